!> Elements of summits that stick: against reference values, Hertz' limit, the sum of the summits'
!> curves, and differences.
module test_contact_stick_elements
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: fewest_stick_elements, most_stick_elements
   use asperity_contact_stick_elements, only: equivalent_shear_modulus, find_stick_elements, &
      stick_elements, summit_backbone
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertGreaterThanOrEqual, assertIsFinite, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: properties_with, random_properties, random_stream
   use reference_table, only: open_table
   implicit none
   private
   public :: suite_stick_elements

   !> G* of the pair transverse-tangential by Table 1, MPa
   real(wp), parameter :: shear_modulus = 31.6_wp
   integer, parameter :: n_slips = 60

contains

   function suite_stick_elements() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('stick elements')
      call suite%addTest(TestMethod('backbone and stiffness against reference values', &
         test_reference))
      call suite%addTest(TestMethod('all summits elastic: pressures of two separations', &
         test_elastic_limit))
      call suite%addTest(TestMethod('other plastic ratios: sum over single summits', &
         test_plastic_ratio))
      call suite%addTest(TestMethod('equivalent shear modulus', test_shear_modulus))
      call suite%addTest(TestMethod('elements against the backbone', test_backbone))
      call suite%addTest(TestMethod('yield factors down to 0.05', test_low_yield_factor))
      call suite%addTest(TestMethod('derivatives by closure', test_derivatives))
      call suite%addTest(TestMethod('any separation: positive, rising, sum one', test_any))
   end function suite_stick_elements

   !> Backbone and stiffness of rows in 13 digits, by stick_reference.py.
   subroutine test_reference()
      character(len=*), parameter :: header = &
         'eta,modulus,radius,hardness,yield_factor,sigma,shear_modulus,h,unit_slip,share,stiffness'
      type(normal_properties) :: p
      type(stick_elements) :: elements
      type(error_type), allocatable :: error
      real(wp) :: row(11), share_error, stiffness_error
      integer :: unit, status, n

      call open_table('stick_reference.csv', header, unit)
      share_error = 0.0_wp
      stiffness_error = 0.0_wp
      n = 0
      do
         read (unit, *, iostat=status) row
         if (status /= 0) exit
         n = n + 1
         call new_normal_properties(p, row(1), row(2), row(3), row(4), row(5), row(6), error, &
            accept_unphysical=.true.)
         call assertTrue(.not. allocated(error))
         call find_stick_elements(p, row(7), 8, row(8)*p%sigma, elements)
         call worsen(stiffness_error, abs(elements%stiffness/row(11) - 1.0_wp))
         call worsen(share_error, &
            abs(summit_backbone(p, row(7), row(8)*p%sigma, row(9)) - row(10)))
      end do
      close (unit)
      call assertEqual(216, n, 'rows')
      call record('stick_elements.backbone.error', share_error)
      call record('stick_elements.stiffness.relative_error', stiffness_error)
      call assertLessThan(share_error, 5.0e-4_wp, 'backbone')
      call assertLessThan(stiffness_error, 2.0e-4_wp, 'stiffness')
   end subroutine test_reference

   !> w1 = 1000 sigma: T = mu (N(w) - N(w - v)) of each summit, v = 4 G* delta/(mu E*), so that the
   !> backbone is the difference of two pressures, and the stiffness 4 G*/E* times the normal one.
   subroutine test_elastic_limit()
      type(normal_properties) :: p
      type(normal_response) :: here, there
      type(stick_elements) :: elements
      real(wp) :: d, v, share_error, stiffness_error
      integer :: i, j

      p = properties_with(1.0e3_wp, 0.4_wp)
      share_error = 0.0_wp
      stiffness_error = 0.0_wp
      do i = -4, 12
         d = 0.5_wp*real(i, wp)*p%sigma
         here = evaluate_normal_law(p, d)
         call find_stick_elements(p, shear_modulus, 8, d, elements)
         call worsen(stiffness_error, &
            abs(elements%stiffness*p%modulus/(4.0_wp*shear_modulus*here%stiffness) - 1.0_wp))
         do j = 0, n_slips
            v = 4.0_wp*p%sigma*real(j, wp)/n_slips
            there = evaluate_normal_law(p, d + v)
            call worsen(share_error, abs(summit_backbone(p, shear_modulus, d, &
               v*p%modulus/(4.0_wp*shear_modulus)) - (1.0_wp - there%pressure/here%pressure)))
         end do
      end do
      call record('stick_elements.elastic_limit.error', share_error)
      call assertLessThan(share_error, 5.0e-4_wp, 'backbone')
      call assertLessThan(stiffness_error, 1.0e-6_wp, 'stiffness')
   end subroutine test_elastic_limit

   !> The backbone as a sum over 20000 heights of what `evaluate_asperity` says.
   subroutine test_plastic_ratio()
      real(wp), parameter :: ratios(3) = [10.0_wp, 60.0_wp, 1000.0_wp]
      integer, parameter :: n = 20000
      type(normal_properties) :: p
      type(stick_elements) :: elements
      type(asperity_response) :: one
      type(error_type), allocatable :: error
      real(wp) :: w, d, slip, density, radius, sums(3), share_error, stiffness_error
      integer :: i, j, k

      share_error = 0.0_wp
      stiffness_error = 0.0_wp
      do i = 1, size(ratios)
         call new_normal_properties(p, 206.0_wp, 297.0_wp, 0.1477_wp, 10.0_wp, 0.4_wp, 0.0593_wp, &
            error, plastic_ratio=ratios(i))
         call assertTrue(.not. allocated(error))
         do j = -1, 3
            d = real(j, wp)*p%sigma
            call find_stick_elements(p, shear_modulus, 8, d, elements)
            slip = elements%unit_slip(4)
            sums = 0.0_wp
            do k = 1, n
               w = 9.0_wp*p%sigma*(real(k, wp) - 0.5_wp)/n
               one = evaluate_asperity(p, w)
               density = exp(-0.5_wp*((d + w)/p%sigma)**2)/sqrt(2.0_wp*pi)*9.0_wp/n
               radius = sqrt(one%area/pi)
               sums = sums + density*[one%force, 8.0_wp*shear_modulus*radius, one%force*(1.0_wp &
                  - max(1.0_wp - slip*16.0_wp*shear_modulus*radius/(3.0_wp*one%force), &
                  0.0_wp)**1.5_wp)]
            end do
            call worsen(share_error, &
               abs(summit_backbone(p, shear_modulus, d, slip) - sums(3)/sums(1)))
            call worsen(stiffness_error, abs(elements%stiffness/(p%eta*sums(2)) - 1.0_wp))
         end do
      end do
      call record('stick_elements.plastic_ratio.error', share_error)
      call assertLessThan(share_error, 5.0e-4_wp, 'backbone')
      call assertLessThan(stiffness_error, 2.0e-4_wp, 'stiffness')
   end subroutine test_plastic_ratio

   !> Transverse on tangential, and tangential on tangential, by Table 1.
   subroutine test_shear_modulus()
      call assertEqual(31.6429555_wp, &
         equivalent_shear_modulus(224.61_wp, 0.42_wp, 67.16_wp, 0.35_wp), 1.0e-7_wp)
      call assertEqual(67.16_wp/3.3_wp, &
         equivalent_shear_modulus(67.16_wp, 0.35_wp, 67.16_wp, 0.35_wp), 1.0e-13_wp)
   end subroutine test_shear_modulus

   !> Largest distance of the elements from the backbone, in mu p, and their stiffness at first
   !> touch over that of the summits.
   subroutine compare(p, n, d, distance, stiffness)
      type(normal_properties), intent(in) :: p
      integer, intent(in) :: n
      real(wp), intent(in) :: d
      real(wp), intent(inout) :: distance
      real(wp), intent(out) :: stiffness
      type(stick_elements) :: elements
      type(normal_response) :: law
      real(wp) :: slip
      integer :: i

      call find_stick_elements(p, shear_modulus, n, d, elements)
      do i = 1, n_slips
         slip = 1.5_wp*elements%unit_slip(n)*real(i, wp)/n_slips
         call worsen(distance, abs(summit_backbone(p, shear_modulus, d, slip) &
            - sum(elements%share(:n)*min(slip/elements%unit_slip(:n), 1.0_wp))))
      end do
      law = evaluate_normal_law(p, d)
      stiffness = law%pressure*sum(elements%share(:n)/elements%unit_slip(:n))/elements%stiffness
   end subroutine compare

   !> Random faces of yield factors from 0.2, w1/sigma 0.0001 to 10, d from -2 to 6 sigma.
   subroutine test_backbone()
      integer, parameter :: seed = 1949, n_cases = 300, numbers(5) = [4, 6, 8, 12, 16]
      real(wp), parameter :: allowed(5) = [0.03_wp, 0.016_wp, 0.01_wp, 0.0045_wp, 0.003_wp], &
         least(5) = [0.78_wp, 0.84_wp, 0.87_wp, 0.91_wp, 0.93_wp]
      character(len=2) :: label
      type(random_stream) :: stream
      type(normal_properties) :: p
      real(wp) :: distance, stiffness, softest
      integer :: i, j

      write (*, '(5x, a, i0)') 'seed ', seed
      do j = 1, size(numbers)
         stream = random_stream(seed)
         distance = 0.0_wp
         softest = 1.0_wp
         do i = 1, n_cases
            call random_properties(stream, p, 1.0e-4_wp, 10.0_wp, 0.2_wp)
            call compare(p, numbers(j), p%sigma*stream%uniform(-2.0_wp, 6.0_wp), distance, &
               stiffness)
            softest = min(softest, stiffness)
            call assertLessThan(stiffness, 1.0_wp, 'chords are softer than the curve')
         end do
         write (label, '(i0)') numbers(j)
         call record('stick_elements.chords.'//trim(label), distance)
         call record('stick_elements.softer.'//trim(label), 1.0_wp - softest)
         call assertLessThan(distance, allowed(j), trim(label)//' elements')
         call assertGreaterThanOrEqual(softest, least(j), trim(label)//' elements')
      end do
   end subroutine test_backbone

   !> Over all yield factors that the law takes, 8 elements are up to 1.1 % away.
   subroutine test_low_yield_factor()
      type(random_stream) :: stream
      type(normal_properties) :: p
      real(wp) :: distance, stiffness
      integer :: i

      stream = random_stream(1950)
      distance = 0.0_wp
      do i = 1, 600
         call random_properties(stream, p, 1.0e-4_wp, 10.0_wp, 0.05_wp)
         call compare(p, 8, p%sigma*stream%uniform(-2.0_wp, 6.0_wp), distance, stiffness)
      end do
      call record('stick_elements.chords.any_yield_factor', distance)
      call assertLessThan(distance, 0.011_wp, '8 elements')
   end subroutine test_low_yield_factor

   !> Shares and slips against central differences.
   subroutine test_derivatives()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(stick_elements) :: at, closer, farther
      real(wp) :: d, step, by_share, by_slip
      integer :: i, n

      stream = random_stream(1951)
      by_share = 0.0_wp
      by_slip = 0.0_wp
      do i = 1, 400
         call random_properties(stream, p, 1.0e-4_wp, 10.0_wp, 0.05_wp)
         n = nint(stream%uniform(3.6_wp, 16.4_wp))
         d = p%sigma*stream%uniform(-8.0_wp, 20.0_wp)
         step = 1.0e-6_wp*p%sigma
         call find_stick_elements(p, shear_modulus, n, d, at)
         call find_stick_elements(p, shear_modulus, n, d - step, closer)
         call find_stick_elements(p, shear_modulus, n, d + step, farther)
         call worsen(by_share, largest_of(at%share_by_closure(:n) &
            - (closer%share(:n) - farther%share(:n))/(2.0_wp*step))*p%sigma)
         call worsen(by_slip, largest_of((at%unit_slip_by_closure(:n) &
            - (closer%unit_slip(:n) - farther%unit_slip(:n))/(2.0_wp*step))/at%unit_slip(:n)) &
            *p%sigma)
      end do
      call record('stick_elements.share.derivative', by_share)
      call record('stick_elements.unit_slip.derivative', by_slip)
      call assertLessThan(by_share, 1.0e-7_wp, 'shares')
      call assertLessThan(by_slip, 1.0e-7_wp, 'slips')
   end subroutine test_derivatives

   !> From far inside to far outside.
   subroutine test_any()
      real(wp), parameter :: far(6) = [-1.0e100_wp, -1.0e6_wp, -50.0_wp, 38.9_wp, 1.0e6_wp, &
         1.0e100_wp]
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(stick_elements) :: e
      real(wp) :: h
      integer :: i, n

      stream = random_stream(1952)
      do i = 1, 1000
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         n = fewest_stick_elements + mod(i, most_stick_elements - fewest_stick_elements + 1)
         h = stream%uniform(-40.0_wp, 40.0_wp)
         if (i <= size(far)) h = far(min(i, size(far)))
         call find_stick_elements(p, shear_modulus, n, h*p%sigma, e)
         call assertEqual(1.0_wp, sum(e%share(:n)), 1.0e-12_wp, 'sum of shares')
         call assertGreaterThanOrEqual(minval(e%share(:n)), 0.0_wp, 'least share')
         call assertTrue(all([e%unit_slip(1) > 0.0_wp, e%unit_slip(2:n) > e%unit_slip(:n - 1)]), &
            'slips rise')
         call assertIsFinite(sum(abs(e%share_by_closure)) + sum(abs(e%unit_slip_by_closure)) &
            + e%stiffness, 'finite')
      end do
   end subroutine test_any

end module test_contact_stick_elements
