!> Student's t for whole degrees of freedom, by the finite sums of its distribution.
module asperity_base_student
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: student_factor, student_share

contains

   !> Share of Student's distribution between -t and t.
   pure real(wp) function student_share(t, degrees)
      !> Any number from zero on
      real(wp), intent(in) :: t
      !> Degrees of freedom, at least 1
      integer, intent(in) :: degrees
      real(wp) :: c2, term, total
      integer :: i

      ! t = sqrt(degrees) tan(angle); sin(angle) times a polynomial of cos(angle)^2
      c2 = degrees/(degrees + t*t)
      term = merge(1.0_wp, sqrt(c2), mod(degrees, 2) == 0)
      total = 0.0_wp
      do i = merge(2, 3, mod(degrees, 2) == 0), degrees, 2
         total = total + term
         term = term*c2*real(i - 1, wp)/real(i, wp)
      end do
      total = total*t/sqrt(degrees + t*t)
      if (mod(degrees, 2) == 1) total = 2.0_wp/pi*(total + atan(t/sqrt(real(degrees, wp))))
      student_share = total
   end function student_share

   !> The t with so large a share between -t and t: 12.7, 4.30, 3.18 ... 1.96 for 0.95.
   pure real(wp) function student_factor(share, degrees)
      !> Share, 0 to below 1
      real(wp), intent(in) :: share
      !> Degrees of freedom; from 10000 on it is taken for a Gaussian one, to 1e-4
      integer, intent(in) :: degrees
      real(wp) :: low, high, middle
      integer :: i, n

      n = min(max(degrees, 1), 10000)
      low = 0.0_wp
      high = 1.0_wp
      do while (student_share(high, n) < share .and. high < 1.0e9_wp)
         high = 2.0_wp*high
      end do
      do i = 1, 60
         middle = 0.5_wp*(low + high)
         if (student_share(middle, n) < share) then
            low = middle
         else
            high = middle
         end if
      end do
      student_factor = 0.5_wp*(low + high)
   end function student_factor

end module asperity_base_student
