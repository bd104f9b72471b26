!> Ratings of premium connections. Makers give the strength of a connection as a share of that of the pipe body, its
!> efficiency. They rate tension, compression, burst and collapse, and the largest dogleg.
module dg_connection_rating
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   implicit none
   private
   public :: connection_rating_type, is_rated

   !> Shares of the strength of the body [-]. Missing: not rated.
   type :: connection_rating_type
      real(wp) :: tension = missing
      real(wp) :: compression = missing   !< of the tensile strength of the body
      real(wp) :: burst = missing
      real(wp) :: collapse = missing
      real(wp) :: dogleg = missing        !< largest curvature of the pipe [1/m]
   end type connection_rating_type

contains

   !> True if a connection has any rating.
   elemental function is_rated(rating) result(rated)
      type(connection_rating_type), intent(in) :: rating
      logical :: rated
      rated = .not. (is_missing(rating%tension) .and. is_missing(rating%compression) .and. is_missing(rating%burst) .and. &
                     is_missing(rating%collapse) .and. is_missing(rating%dogleg))
   end function is_rated
end module dg_connection_rating
