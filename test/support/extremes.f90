!> Largest errors that a NaN cannot hide in. `maxval` and `max` may leave out what is no number, so
!> that `maxval(abs(x)) < tolerance` holds for all NaN: here it counts as huge.
module extremes
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: largest_of, worsen

   !> Largest absolute value of an array; zero if it is empty, huge if one is no finite number.
   interface largest_of
      procedure largest_1
      procedure largest_2
      procedure largest_3
   end interface largest_of

   !> Keep the larger of what was found so far and new errors, element by element if there are as
   !> many of both; huge if one is no finite number.
   interface worsen
      procedure worsen_0
      procedure worsen_1
   end interface worsen

contains

   pure real(wp) function largest_1(values) result(found)
      real(wp), intent(in) :: values(:)
      integer :: i

      found = 0.0_wp
      do i = 1, size(values)
         if (is_finite(values(i))) then
            found = max(found, abs(values(i)))
         else
            found = huge(found)
         end if
      end do
   end function largest_1

   pure real(wp) function largest_2(values) result(found)
      real(wp), intent(in) :: values(:, :)

      found = largest_1(reshape(values, [size(values)]))
   end function largest_2

   pure real(wp) function largest_3(values) result(found)
      real(wp), intent(in) :: values(:, :, :)

      found = largest_1(reshape(values, [size(values)]))
   end function largest_3

   pure elemental subroutine worsen_0(worst, error)
      !> Largest error so far
      real(wp), intent(inout) :: worst
      !> A new one; a difference with its sign is allowed
      real(wp), intent(in) :: error

      if (is_finite(error)) then
         worst = max(worst, error)
      else
         worst = huge(worst)
      end if
   end subroutine worsen_0

   pure subroutine worsen_1(worst, errors)
      real(wp), intent(inout) :: worst
      real(wp), intent(in) :: errors(:)
      integer :: i

      do i = 1, size(errors)
         call worsen_0(worst, errors(i))
      end do
   end subroutine worsen_1

end module extremes
