!> A variance for each kind of measured values, from the residuals of a fit.
!>
!> Hook loads and torques have errors of their own. With one scatter for both, intervals by the noisier kind hold the truth too
!> seldom, and the others are far too wide. The variances are those of restricted maximum likelihood (Patterson & Thompson
!> 1971): r_k.r_k = s_k^2 (n_k - h_k). h_k are the leverages of a kind in the fit with these variances as weights. The
!> covariance of the unknowns, and the degrees of freedom of each interval, are after Kenward & Roger (1997). In their linear
!> form a single unknown has Satterthwaite's (1946) freedom.
!>
!> Kinds are numbered from 1; values of kind 0 have deviations that are known.
module dg_variance_components
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: estimate_factors, adjust_covariance, scatter_of, spare_of, invert_normal

   !> Least variance of a kind over the largest, both over those at the beginning [-]. A kind with hardly more values than
   !> unknowns of its own may fit exactly, by chance.
   real(wp), parameter :: least_variance = 1.0e-4_wp
   integer, parameter :: most_iterations = 500
   !> Relative change of a variance that ends the iteration [-].
   real(wp), parameter :: at_rest = 1.0e-8_wp
   !> Spare values of a kind that count as none [-].
   real(wp), parameter :: none_spare = 1.0e-9_wp
   !> Spare values with which a kind's scatter is told.
   real(wp), parameter :: some_spare = 0.1_wp
   !> Determinant of the variances' information, over the product of its diagonal, under which they are one [-].
   real(wp), parameter :: singular = 1.0e-12_wp

contains

   !> Factors on the deviations of each kind, in the fit linearised about where it is.
   pure subroutine estimate_factors(jacobian, residual, kinds, factors)
      real(wp), intent(in) :: jacobian(:, :)   !< (data, unknowns found), over the deviations
      real(wp), intent(in) :: residual(:)      !< over the deviations
      integer, intent(in) :: kinds(:)          !< one a datum
      real(wp), intent(out) :: factors(:)      !< one a kind; ones where the data cannot tell them
      real(wp) :: inverse(size(jacobian, 2), size(jacobian, 2)), weight(size(kinds)), left(size(kinds))
      real(wp) :: spare(size(kinds)), variance(size(factors)), before(size(factors))
      integer :: iteration, k, i
      logical :: regular
      factors = 1.0_wp
      if (size(residual) <= size(jacobian, 2)) return
      variance = max(dot_product(residual, residual)/real(size(residual) - size(jacobian, 2), wp), tiny(1.0_wp))
      do iteration = 1, most_iterations
         weight = 1.0_wp
         do k = 1, size(factors)
            where (kinds == k) weight = 1.0_wp/variance(k)
         end do
         call invert(normal_matrix(jacobian, weight), inverse, regular)
         if (.not. regular) return
         left = residual - matmul(jacobian, matmul(inverse, matmul(weight*residual, jacobian)))
         spare = [(1.0_wp - weight(i)*dot_product(jacobian(i, :), matmul(inverse, jacobian(i, :))), i=1, size(spare))]
         before = variance
         do k = 1, size(factors)
            if (any(kinds == k)) variance(k) = sum(left**2, mask=kinds == k)/max(sum(spare, mask=kinds == k), none_spare)
         end do
         variance = max(variance, least_variance*maxval(variance), tiny(1.0_wp))
         if (all(abs(variance - before) <= at_rest*before)) exit
      end do
      factors = sqrt(variance)
   end subroutine estimate_factors

   !> Scatter of the residuals of some data over their deviations: their squares over the number of them that is spare;
   !> missing where hardly any is [-].
   pure function scatter_of(jacobian, residual, among) result(scatter)
      real(wp), intent(in) :: jacobian(:, :)   !< (data, unknowns found), over the deviations
      real(wp), intent(in) :: residual(:)      !< over the deviations
      logical, intent(in) :: among(:)          !< these data
      real(wp) :: scatter
      real(wp) :: inverse(size(jacobian, 2), size(jacobian, 2)), spare
      logical :: regular
      scatter = missing
      call invert_normal(jacobian, inverse, regular)
      if (.not. regular) return
      spare = spare_of(jacobian, inverse, among)
      if (spare > some_spare) scatter = sqrt(sum(residual**2, mask=among)/spare)
   end function scatter_of

   !> Number of some data less what the unknowns take of them.
   pure function spare_of(jacobian, inverse, among) result(spare)
      real(wp), intent(in) :: jacobian(:, :)   !< (data, unknowns found), over the deviations
      real(wp), intent(in) :: inverse(:, :)    !< of its normal matrix
      logical, intent(in) :: among(:)          !< these data
      real(wp) :: spare
      integer :: i
      spare = count(among) - sum([(dot_product(jacobian(i, :), matmul(inverse, jacobian(i, :))), i=1, size(among))], mask=among)
   end function spare_of

   !> Covariance of the unknowns with the effect of estimated variances, and the degrees of freedom of each. The deviations are
   !> estimated. It is Kenward & Roger's C + 2 C L C with L = sum over kinds of W_kl (d_kl A_k - A_k C A_l). A_k is the normal
   !> matrix of a kind and W the covariance of the variances.
   pure subroutine adjust_covariance(jacobian, kinds, covariance, freedom)
      real(wp), intent(in) :: jacobian(:, :)       !< (data, unknowns found), over the deviations
      integer, intent(in) :: kinds(:)              !< one a datum
      real(wp), intent(inout) :: covariance(:, :)  !< of the unknowns found
      real(wp), intent(out) :: freedom(:)          !< one an unknown, >= 1
      real(wp) :: normal(size(freedom), size(freedom), maxval(kinds)), added(size(freedom), size(freedom))
      real(wp) :: share(size(freedom), size(freedom), maxval(kinds)), slope(maxval(kinds))
      real(wp), dimension(maxval(kinds), maxval(kinds)) :: information, w
      integer :: k, l, u
      do k = 1, maxval(kinds)
         normal(:, :, k) = normal_matrix(jacobian, merge(1.0_wp, 0.0_wp, kinds == k))
         share(:, :, k) = matmul(covariance, normal(:, :, k))
      end do
      do k = 1, maxval(kinds)
         do l = 1, maxval(kinds)
            information(k, l) = 0.5_wp*sum(share(:, :, k)*transpose(share(:, :, l)))
            if (k == l) information(k, k) = information(k, k) + 0.5_wp*count(kinds == k) &
                                            - sum([(share(u, u, k), u=1, size(freedom))])
         end do
      end do
      call invert_variances(information, w)
      added = 0.0_wp
      do k = 1, maxval(kinds)
         added = added + w(k, k)*normal(:, :, k)
         do l = 1, maxval(kinds)
            added = added - w(k, l)*matmul(normal(:, :, k), share(:, :, l))
         end do
      end do
      do u = 1, size(freedom)
         do k = 1, maxval(kinds)
            slope(k) = dot_product(share(u, :, k), covariance(:, u))
         end do
         freedom(u) = max(1.0_wp, 2.0_wp*covariance(u, u)**2/max(dot_product(slope, matmul(w, slope)), tiny(1.0_wp)))
      end do
      covariance = covariance + 2.0_wp*matmul(covariance, matmul(added, covariance))
   end subroutine adjust_covariance

   !> Inverse of the normal matrix of a Jacobian, which is the covariance of its unknowns where errors are independent.
   pure subroutine invert_normal(jacobian, inverse, regular)
      real(wp), intent(in) :: jacobian(:, :)     !< (data, unknowns found), over the deviations
      real(wp), intent(out) :: inverse(:, :)
      logical, intent(out) :: regular
      call invert(normal_matrix(jacobian, spread(1.0_wp, 1, size(jacobian, 1))), inverse, regular)
   end subroutine invert_normal

   !> Inverse of the information on one or more variances; where two cannot be told apart, that of each by itself.
   pure subroutine invert_variances(information, w)
      real(wp), intent(in) :: information(:, :)
      real(wp), intent(out) :: w(:, :)
      real(wp) :: scale(size(information, 1)), scaled(size(information, 1), size(information, 1))
      logical :: regular
      integer :: k, l
      do k = 1, size(scale)
         scale(k) = sqrt(max(information(k, k), none_spare**2))
      end do
      do k = 1, size(scale)
         do l = 1, size(scale)
            scaled(k, l) = information(k, l)/(scale(k)*scale(l))
         end do
         scaled(k, k) = 1.0_wp
      end do
      call invert(scaled, w, regular)
      if (.not. regular) then
         w = 0.0_wp
         do k = 1, size(scale)
            w(k, k) = 1.0_wp
         end do
      end if
      do k = 1, size(scale)
         do l = 1, size(scale)
            w(k, l) = w(k, l)/(scale(k)*scale(l))
         end do
      end do
   end subroutine invert_variances

   pure function normal_matrix(jacobian, weight) result(matrix)
      real(wp), intent(in) :: jacobian(:, :), weight(:)
      real(wp) :: matrix(size(jacobian, 2), size(jacobian, 2))
      integer :: j, k
      do j = 1, size(matrix, 1)
         do k = 1, size(matrix, 1)
            matrix(j, k) = sum(weight*jacobian(:, j)*jacobian(:, k))
         end do
      end do
   end function normal_matrix

   !> Inverse of a symmetric positive definite matrix, by exchange of its rows; small ones only.
   pure subroutine invert(matrix, inverse, regular)
      real(wp), intent(in) :: matrix(:, :)
      real(wp), intent(out) :: inverse(:, :)
      logical, intent(out) :: regular
      real(wp) :: pivot, row(size(matrix, 1)), column(size(matrix, 1)), diagonal(size(matrix, 1))
      integer :: k, j
      inverse = matrix
      do k = 1, size(row)
         diagonal(k) = matrix(k, k)
      end do
      do k = 1, size(row)
         pivot = inverse(k, k)
         regular = pivot > singular*diagonal(k)
         if (.not. regular) return
         row = inverse(k, :)/pivot
         column = inverse(:, k)
         do j = 1, size(row)
            inverse(:, j) = inverse(:, j) - column*row(j)
         end do
         inverse(k, :) = row
         inverse(:, k) = -column/pivot
         inverse(k, k) = 1.0_wp/pivot
      end do
      regular = .true.      ! of no unknowns, too
   end subroutine invert
end module dg_variance_components
