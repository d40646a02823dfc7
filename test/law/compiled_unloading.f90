!> The compiled law with memory against the direct one and itself: the whole stated range, edges of
!> cells, regions and strips, derivatives.
module test_law_compiled_unloading
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_compiled_law, only: compiled_plastic_dissipation, &
      compiled_unloading_law
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_law_unloading_summit, only: elastic_recovery
   use compiled_unloading_cases, only: compile, compiled_at, direct_at, furthest_at, &
      yield_factor_min
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, properties_with, random_properties, random_stream
   implicit none
   private
   public :: suite_compiled_unloading

   character(len=9), parameter :: names(3) = ['pressure ', 'stiffness', 'energy   ']

contains

   function suite_compiled_unloading() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compiled unloading')
      call suite%addTest(TestMethod('random properties, the whole range', test_sweep))
      call suite%addTest(TestMethod('the virgin branch', test_virgin))
      call suite%addTest(TestMethod('no seam at the edges of cells, regions, strips', test_seams))
      call suite%addTest(TestMethod('stiffness and pressure are derivatives', test_derivative))
      call suite%addTest(TestMethod('pressure falls as a face parts', test_monotone))
   end function suite_compiled_unloading

   !> Random properties, closest separations from -8 to 8 sigma, retractions until the pressure is
   !> 1e-12 of that at the closest separation, many of them small. 1e-9 is demanded.
   subroutine test_sweep()
      integer, parameter :: seed = 271828, n_sets = 24, n_points = 400
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_unloading_law) :: law
      real(wp) :: h, u, worst(3)
      integer :: i, j, without_cell

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      without_cell = 0
      do i = 1, n_sets
         call random_properties(stream, p, 1.0e-6_wp, 1.0e2_wp, yield_factor_min)
         call compile(law, p)
         do j = 1, n_points
            h = stream%uniform(-8.0_wp, 8.0_wp)
            u = furthest_at(law, h)
            if (u > law%furthest(1 + int((h + 8.0_wp)/2.0_wp))) without_cell = without_cell + 1
            if (mod(j, 2) == 0) then
               u = u*stream%uniform(0.0_wp, 1.0_wp)
            else
               u = u*stream%log_uniform(1.0e-8_wp, 1.0_wp)
            end if
            call worsen(worst, abs(compiled_at(law, h, u)/direct_at(law, h, u) - 1.0_wp))
         end do
      end do
      call assertEqual(0, without_cell, 'points of the range without a cell')
      do j = 1, 3
         call record('compiled_unloading.'//trim(names(j)), worst(j))
         call assertLessThan(worst(j), 1.0e-9_wp, trim(names(j)))
      end do
   end subroutine test_sweep

   !> What is recoverable and the plastic dissipation, to 36 sigma, of which it may
   !> be zero below 1e-260.
   subroutine test_virgin()
      integer, parameter :: seed = 1618, n_sets = 10, n_points = 300
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_unloading_law) :: law
      type(normal_response) :: r
      real(wp) :: h, found(3), worst(4)
      integer :: i, j

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      do i = 1, n_sets
         call random_properties(stream, p, 1.0e-6_wp, 1.0e2_wp, yield_factor_min)
         call compile(law, p)
         do j = 1, n_points
            h = stream%uniform(-8.0_wp, merge(8.0_wp, 36.0_wp, mod(j, 2) == 0))
            found = compiled_at(law, h + 0.1_wp, -0.1_wp)
            r = evaluate_unloading_law(p, h*p%sigma, 0.0_wp)
            call worsen(worst(:3), abs(found/[r%pressure, r%stiffness, r%energy] - 1.0_wp))
            if (r%plastic_dissipation > 1.0e-260_wp) call worsen(worst(4), &
               abs(compiled_plastic_dissipation(law, h*p%sigma)/r%plastic_dissipation - 1.0_wp))
         end do
      end do
      call record('compiled_unloading.virgin.energy', worst(3))
      call record('compiled_unloading.virgin.plastic_dissipation', worst(4))
      call assertLessThan(largest_of(worst), 1.0e-9_wp, 'relative error')
   end subroutine test_virgin

   !> Across each edge of the cells in a strip, and across the edges of strips, nothing changes by
   !> more than twice the error; at the ends of the regions, w1 and the recovery at w2, as directly.
   subroutine test_seams()
      type(compiled_unloading_law) :: law
      real(wp), parameter :: ratios(4) = [1.0e-6_wp, 1.0e-3_wp, 0.1_wp, 10.0_wp]
      real(wp) :: h, u, ends(2), worst(2)
      integer :: i, j, k, strip

      worst = 0.0_wp
      do i = 1, size(ratios)
         call compile(law, properties_with(ratios(i), 0.2_wp*i))
         associate (p => law%virgin%properties)
            ends = [p%w1, elastic_recovery(p, p%w2)]/p%sigma
         end associate
         do strip = 1, 8
            h = 2.0_wp*strip - 9.3_wp
            do j = law%first_cell(strip) + 1, law%first_cell(strip + 1) - 1
               u = law%starts(j)
               call worsen(worst(1), largest_of(compiled_at(law, h, nearest(u, -1.0_wp)) &
                  /compiled_at(law, h, u) - 1.0_wp))
            end do
            do j = 0, 10
               h = 2.0_wp*strip - 10.0_wp
               u = 0.09_wp*j*law%furthest(strip)
               if (strip > 1 .and. j > 0) call worsen(worst(1), largest_of( &
                  compiled_at(law, nearest(h, -1.0_wp), u)/compiled_at(law, h, u) - 1.0_wp))
            end do
            do k = 1, 2
               if (ends(k) > 0.9_wp*law%furthest(strip)) cycle
               do j = -20, 20
                  h = 2.0_wp*strip - 9.0_wp + 0.0499_wp*j
                  u = ends(k)*(1.0_wp + sign(10.0_wp**(-abs(j)), real(j, wp)))
                  call worsen(worst(2), largest_of(compiled_at(law, h, u)/direct_at(law, h, u) &
                     - 1.0_wp))
               end do
            end do
         end do
      end do
      call record('compiled_unloading.seam', worst(1))
      call record('compiled_unloading.region_ends', worst(2))
      call assertLessThan(worst(1), 1.0e-9_wp, 'seams')
      call assertLessThan(worst(2), 1.0e-9_wp, 'ends of regions')
   end subroutine test_seams

   !> Energy falls by pressure and pressure by stiffness, by eighth-order differences within a cell:
   !> the polynomials are integrals of each other, so that only the formula's error is left.
   subroutine test_derivative()
      real(wp), parameter :: weights(4) = [0.8_wp, -0.2_wp, 4.0_wp/105.0_wp, -1.0_wp/280.0_wp]
      type(compiled_unloading_law) :: law
      real(wp) :: h, u, step, slopes(3), here(3), worst(2)
      integer :: i, j, k

      worst = 0.0_wp
      call compile(law, normal_of_pair('transverse-tangential'))
      do i = 1, 8
         h = 2.0_wp*i - 9.7_wp
         do j = law%first_cell(i), law%first_cell(i + 1) - 2
            u = 0.5_wp*(law%starts(j) + law%starts(j + 1))
            step = 0.01_wp*(law%starts(j + 1) - law%starts(j))
            here = compiled_at(law, h, u)
            slopes = 0.0_wp
            do k = 1, 4
               slopes = slopes + weights(k)*(compiled_at(law, h, u - k*step) &
                  - compiled_at(law, h, u + k*step))/(step*law%virgin%properties%sigma)
            end do
            call worsen(worst, abs(slopes([3, 1])/here([1, 2]) - 1.0_wp))
         end do
      end do
      call record('compiled_unloading.derivative', largest_of(worst))
      call assertLessThan(worst(1), 1.0e-11_wp, 'pressure')
      call assertLessThan(worst(2), 1.0e-11_wp, 'stiffness')
   end subroutine test_derivative

   !> Over steps far above the error at seams; the stiffness is positive everywhere.
   subroutine test_monotone()
      integer, parameter :: seed = 577
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_unloading_law) :: law
      real(wp) :: h, u, values(3), last(3)
      integer :: i, j, k, rising

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      rising = 0
      do i = 1, 4
         call random_properties(stream, p, 1.0e-6_wp, 1.0e2_wp, yield_factor_min)
         call compile(law, p)
         do k = 1, 20
            h = stream%uniform(-8.0_wp, 8.0_wp)
            u = furthest_at(law, h)
            last = huge(1.0_wp)
            do j = 1, 2000
               values = compiled_at(law, h, 5.0e-4_wp*u*j)
               if (any(values([1, 3]) >= last([1, 3])) .or. values(2) <= 0.0_wp) rising = rising + 1
               last = values
            end do
         end do
      end do
      call assertEqual(0, rising, 'points')
   end subroutine test_monotone

end module test_law_compiled_unloading
