!> Sums over the points of a profile or of a part of it. Moments are functions of such sums, so that
!> those of several profiles add up.
module asperity_surface_profiles_sums
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   implicit none
   private
   public :: added, profile_sums, sum_profile

   !> z is the height above the mean line of the whole profile, mm; slopes are differences of
   !> neighbours, curvatures second differences of three points in a row. A difference counts where
   !> all its points were measured, and belongs to the part of its first (slope) or middle point.
   type :: profile_sums
      !> Points, and sums of z, z^2, z^3, z^4
      real(wp) :: points = 0.0_wp, first = 0.0_wp, second = 0.0_wp, third = 0.0_wp, &
         fourth = 0.0_wp
      !> Pairs of neighbours and sum of their slopes' squares
      real(wp) :: pairs = 0.0_wp, slope = 0.0_wp
      !> Three points in a row and sum of their curvatures' squares
      real(wp) :: triples = 0.0_wp, curvature = 0.0_wp
   end type profile_sums

contains

   !> Sums of two parts together.
   pure elemental function added(a, b) result(c)
      !> The parts
      type(profile_sums), intent(in) :: a, b
      type(profile_sums) :: c

      c%points = a%points + b%points
      c%first = a%first + b%first
      c%second = a%second + b%second
      c%third = a%third + b%third
      c%fourth = a%fourth + b%fourth
      c%pairs = a%pairs + b%pairs
      c%slope = a%slope + b%slope
      c%triples = a%triples + b%triples
      c%curvature = a%curvature + b%curvature
   end function added

   !> Sums over equal parts of a profile.
   pure subroutine sum_profile(z, step, parts)
      !> Heights above the mean line, mm; `none` where not measured
      real(wp), intent(in) :: z(:)
      !> Distance of neighbours, mm
      real(wp), intent(in) :: step
      !> One for each part, of which there may be one
      type(profile_sums), intent(out) :: parts(:)
      integer :: i

      do i = 1, size(z)
         if (z(i) >= none) cycle
         associate (part => parts(part_of(i)))
            part%points = part%points + 1.0_wp
            part%first = part%first + z(i)
            part%second = part%second + z(i)**2
            part%third = part%third + z(i)**3
            part%fourth = part%fourth + z(i)**4
         end associate
      end do
      do i = 1, size(z) - 1
         if (max(z(i), z(i + 1)) >= none) cycle
         associate (part => parts(part_of(i)))
            part%pairs = part%pairs + 1.0_wp
            part%slope = part%slope + ((z(i + 1) - z(i))/step)**2
         end associate
      end do
      do i = 2, size(z) - 1
         if (max(z(i - 1), z(i), z(i + 1)) >= none) cycle
         associate (part => parts(part_of(i)))
            part%triples = part%triples + 1.0_wp
            part%curvature = part%curvature + ((z(i + 1) - 2.0_wp*z(i) + z(i - 1))/step**2)**2
         end associate
      end do

   contains

      !> The part that a point belongs to
      pure integer function part_of(i)
         integer, intent(in) :: i

         part_of = 1 + int(int(i - 1, int64)*size(parts)/size(z))
      end function part_of

   end subroutine sum_profile

end module asperity_surface_profiles_sums
