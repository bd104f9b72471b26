!> A string that is held at some depth, as its part above. It ends there, and the pull and torque at its end replace everything
!> that holds it. Its load without sticking is that of the free string.
module dg_stuck_string
   use dg_kinds, only: wp
   use dg_component, only: axial_stiffness
   use dg_drillstring, only: component_at, component_tops, drillstring_type
   use dg_fluid, only: cut_mud
   use dg_model, only: model_type, string_index
   use dg_profile, only: profile_type
   implicit none
   private
   public :: cut_string, value_at, free_point_without_friction, stretch_between

contains

   !> End the string of the model's first load case at a depth. The part below is removed. Its end is free across the hole, as
   !> it lies against the wall there. If the bit is at that depth the model stays.
   subroutine cut_string(model, depth)
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: depth               !< > 0, not below the bit [m]
      real(wp) :: off
      integer :: i
      off = model%cases(1)%bit_depth - depth
      if (.not. off > 0.0_wp) return
      call cut_mud(model%mud, off)
      associate (parts => model%strings(string_index(model%strings, model%cases(1)%string))%components)
         do i = 1, size(parts) - 1
            if (off < parts(i)%length) exit
            off = off - parts(i)%length
         end do
         if (parts(i)%length > 0.0_wp) parts(i)%length = parts(i)%length - off     ! 0: to surface, as long as it needs to be
      end associate
      associate (string => model%strings(string_index(model%strings, model%cases(1)%string)))
         string%components = string%components(i:)
      end associate
      model%cases(1)%bit_depth = depth
      model%boundary%bit_centred = .false.
      model%boundary%packer_bore = 0.0_wp
   end subroutine cut_string

   !> A quantity of a profile at a depth, by a straight line between its neighbours; at a depth with two rows, of the lower
   !> side.
   pure function value_at(md, values, depth) result(value)
      real(wp), intent(in) :: md(:)               !< never decreasing; its last two differ [m]
      real(wp), intent(in) :: values(:)
      real(wp), intent(in) :: depth               !< [m]
      real(wp) :: value
      integer :: i
      i = min(max(count(md <= depth), 1), size(md) - 1)
      value = values(i) + (values(i + 1) - values(i))*(depth - md(i))/(md(i + 1) - md(i))
   end function value_at

   !> Depth at which the string is held, from its stretch under an additional pull, if nothing rubs [m]: the usual formula,
   !> part by part. Beyond `bit_depth` where the whole string stretches less.
   pure function free_point_without_friction(string, bit_depth, pull, stretch) result(depth)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit_depth           !< [m]
      real(wp), intent(in) :: pull                !< > 0 [N]
      real(wp), intent(in) :: stretch             !< > 0 [m]
      real(wp) :: depth
      real(wp) :: tops(size(string%components)), bottoms(size(string%components)), left, length, bottom
      integer :: i
      tops = bit_depth - component_tops(string, bit_depth)
      bottoms = [bit_depth, tops(:size(tops) - 1)]
      left = stretch
      do i = size(tops), 1, -1
         bottom = bottoms(i)
         length = left*axial_stiffness(string%components(i))/pull
         depth = tops(i) + length
         if (depth <= bottom .or. i == 1) return
         left = left - (bottom - tops(i))*pull/axial_stiffness(string%components(i))
      end do
      depth = bit_depth
   end function free_point_without_friction

   !> Stretch of the string from one state to another: the change of axial force over E A, summed along it [m]. Steps are those
   !> of the first profile, each with the component at its middle.
   pure function stretch_between(first, second, string, bit_depth) result(stretch)
      type(profile_type), intent(in) :: first, second
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit_depth           !< from which the components count [m]
      real(wp) :: stretch
      real(wp) :: tops(size(string%components)), change(size(first%md)), middle
      integer :: i
      tops = component_tops(string, bit_depth)
      do i = 1, size(change)
         change(i) = value_at(second%md, second%axial, first%md(i)) - first%axial(i)
      end do
      stretch = 0.0_wp
      do i = 2, size(change)
         middle = 0.5_wp*(first%md(i - 1) + first%md(i))
         stretch = stretch + 0.5_wp*(change(i - 1) + change(i))*(first%md(i) - first%md(i - 1)) &
                   /axial_stiffness(string%components(component_at(tops, bit_depth - middle)))
      end do
   end function stretch_between
end module dg_stuck_string
