!> Sums over summits that were pressed and part again, against the law with memory.
module test_surface_unloading
   use asperity, only: error_type, normal_properties, wp
   use asperity_surface_generate_random_stream, only: fill_normal, new_random, random_type
   use asperity_surface_pair_law_on_summits, only: sum_over_summits, summit_curve
   use extremes, only: largest_of
   use funit, only: assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair
   implicit none
   private
   public :: suite_surface_unloading

contains

   function suite_surface_unloading() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('summits that part')
      call suite%addTest(TestMethod('sum over Gaussian summits', test_sum))
   end function suite_surface_unloading

   !> Over 40000 summits with Gaussian heights, pressed to the mean plane or to two sigma from it,
   !> the sums are the law within 4 of their own standard errors.
   subroutine test_sum()
      integer, parameter :: n = 40000
      real(wp), parameter :: retractions(5) = [0.0_wp, 0.02_wp, 0.05_wp, 0.1_wp, 0.2_wp]
      type(normal_properties) :: p
      type(random_type) :: stream
      type(summit_curve) :: curve
      type(error_type), allocatable :: error
      real(wp), allocatable :: z(:), curvatures(:)
      real(wp) :: worst, closest
      integer :: i

      p = normal_of_pair('transverse-tangential')
      allocate (z(n), curvatures(n))
      call new_random(stream, 6)
      call fill_normal(stream, z)
      curvatures = 1.0_wp/p%radius
      worst = 0.0_wp
      do i = 0, 2, 2
         closest = i*p%sigma
         call sum_over_summits(p, p%sigma*z, curvatures, n/p%eta, closest + p%sigma*retractions, &
            curve, error, closest)
         call assertTrue(all(curve%mean_radius(2:) < curve%mean_radius(:4)), 'falls')
         call assertGreaterThan(curve%mean_radius(1), 2.0_wp*curve%mean_radius(5), 'by much')
         worst = max(worst, largest_of((curve%mean_radius - curve%gaussian) &
            /curve%mean_radius_error))
         call assertRelativelyEqual(curve%mean_radius, curve%own_radius, 1.0e-12_wp, 'equal radii')
         call assertLessThan(largest_of((curve%contact_density/curve%gaussian_density - 1.0_wp) &
            *sqrt(curve%gaussian_density/p%eta*n)), 4.0_wp, 'contact density')
      end do
      call record('surface.unloading.standard_errors', worst)
      call assertLessThan(worst, 4.0_wp, 'pressure')
   end subroutine test_sum

end module test_surface_unloading
