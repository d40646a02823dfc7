!> The fixed rule of the elastic and the elasto-plastic piece against the general quadrature, over
!> all properties and separations where it serves, and at the ends of that range.
module test_law_fixed_pieces
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_scaled_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_fixed_points, only: find_force_powers, log_ratio, &
      middle_exponent, n_points, ratio, weight
   use asperity_law_quadrature_pieces_by_fixed_rule, only: evaluate_fixed_pieces, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, elastoplastic_piece, &
      piece_type, plastic_piece
   use asperity_law_unloading_gauss_points, only: points, weights
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: properties_with, random_properties, random_stream
   implicit none
   private
   public :: suite_fixed_pieces

   integer(int64), parameter :: seed = 57721566_int64
   real(wp), parameter :: eps = epsilon(1.0_wp)
   !> Limits of the fixed rule: largest w1/sigma, smallest d/sigma, largest product
   real(wp), parameter :: largest_ratio = 0.025_wp, lowest = -7.0_wp, largest_product = 0.28_wp
   integer, parameter :: n_numbers = 5
   character(len=10), parameter :: names(n_numbers) = [character(len=10) :: 'pressure', &
      'stiffness', 'area', 'area_slope', 'energy']

contains

   function suite_fixed_pieces() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('fixed pieces')
      call suite%addTest(TestMethod('against the general quadrature', test_random))
      call suite%addTest(TestMethod('at the corners of its range', test_corners))
      call suite%addTest(TestMethod('no seam where it begins and ends', test_seams))
      call suite%addTest(TestMethod('without the slope of the area', test_without_slope))
      call suite%addTest(TestMethod('recoverable energy and dissipation', test_memory))
      call suite%addTest(TestMethod('where it serves', test_range))
      call suite%addTest(TestMethod('powers of the force', test_force_powers))
      call suite%addTest(TestMethod('points and weights integrate powers', test_weights))
   end function suite_fixed_pieces

   !> Random properties and separations; every other one within a tenth of the limit of the
   !> product, where the density decays most over the elasto-plastic range.
   subroutine test_random()
      integer, parameter :: n_cases = 100000
      type(random_stream) :: stream
      type(normal_properties) :: p
      real(wp) :: a, h, highest, worst(n_numbers, 3)
      integer :: i, served

      stream = random_stream(seed)
      worst = 0.0_wp
      served = 0
      do i = 1, n_cases
         if (mod(i, 2) == 0) then
            call random_properties(stream, p, 1.0e-8_wp, largest_ratio, 0.05_wp)
            a = p%w1/p%sigma
            h = stream%uniform(lowest, min(37.0_wp, largest_product/a))
         else
            call random_properties(stream, p, largest_product/37.0_wp, largest_ratio, 0.05_wp)
            a = p%w1/p%sigma
            highest = largest_product/a
            h = stream%uniform(0.9_wp*highest, highest)
         end if
         if (.not. fixed_pieces_serve(p, h)) cycle
         served = served + 1
         call compare(p, h, worst)
      end do
      write (*, '(5x, a, i0)') 'seed ', seed
      call assertGreaterThan(served, n_cases - n_cases/1000, message='cases')
      do i = 1, n_numbers
         call record('fixed_pieces.elastic.'//trim(names(i)), worst(i, 1))
         call record('fixed_pieces.elastoplastic.'//trim(names(i)), worst(i, 2))
         call record('fixed_pieces.sum.'//trim(names(i)), worst(i, 3))
      end do
      call check(worst)
   end subroutine test_random

   !> Smallest and largest w1/sigma, separation and yield factor.
   subroutine test_corners()
      real(wp), parameter :: ratios(4) = [1.0e-8_wp, 1.0e-4_wp, largest_product/37.0_wp, &
         largest_ratio*(1.0_wp - 4.0_wp*eps)]
      real(wp), parameter :: factors(3) = [0.05_wp, 0.4_wp, 1.0_wp]
      type(normal_properties) :: p
      real(wp) :: highest, worst(n_numbers, 3)
      integer :: i, j

      worst = 0.0_wp
      do i = 1, size(ratios)
         do j = 1, size(factors)
            p = properties_with(ratios(i), factors(j))
            highest = min(37.0_wp, largest_product*(1.0_wp - 4.0_wp*eps)*p%sigma/p%w1)
            call assertTrue(fixed_pieces_serve(p, highest), 'serves')
            call compare(p, lowest, worst)
            call compare(p, 0.0_wp, worst)
            call compare(p, -tiny(1.0_wp), worst)
            call compare(p, highest, worst)
         end do
      end do
      call check(worst)
   end subroutine test_corners

   !> Pieces to 1e-12 of their own; the law, all three pieces together, to 2e-14.
   subroutine check(worst)
      real(wp), intent(in) :: worst(n_numbers, 3)
      integer :: i

      do i = 1, n_numbers
         call assertLessThan(worst(i, 1), 1.0e-12_wp, 'elastic '//names(i))
         call assertLessThan(worst(i, 2), 1.0e-12_wp, 'elasto-plastic '//names(i))
         call assertLessThan(worst(i, 3), 2.0e-14_wp, 'law '//names(i))
      end do
   end subroutine check

   !> Largest differences so far: of the elastic piece, the elasto-plastic one and all three, over
   !> the general quadrature's numbers.
   subroutine compare(p, h, worst)
      type(normal_properties), intent(in) :: p
      real(wp), intent(in) :: h
      real(wp), intent(inout) :: worst(n_numbers, 3)
      type(piece_type) :: fixed(2)
      real(wp), dimension(n_numbers, 3) :: found, wanted
      real(wp) :: d

      d = h*p%sigma
      call evaluate_fixed_pieces(p, h, .true., .true., fixed(1), fixed(2))
      found(:, 1) = numbers_of(fixed(1))
      found(:, 2) = numbers_of(fixed(2))
      wanted(:, 1) = numbers_of(elastic_piece(p, d, p%w1))
      wanted(:, 2) = numbers_of(elastoplastic_piece(p, d, .true.))
      wanted(:, 3) = numbers_of(plastic_piece(p, d))
      found(:, 3) = sum(found(:, :2), dim=2) + wanted(:, 3)
      wanted(:, 3) = sum(wanted, dim=2)
      call worsen(worst, abs(found - wanted)/wanted)
   end subroutine compare

   pure function numbers_of(piece) result(numbers)
      type(piece_type), intent(in) :: piece
      real(wp) :: numbers(n_numbers)

      numbers = [piece%pressure, piece%stiffness, piece%area, piece%area_slope, piece%energy] &
         *exp(-piece%exponent)
   end function numbers_of

   !> The law a few roundings to both sides of each limit, by which it changes some eps itself.
   !> Without exp(-h^2/2) its round-off is not enlarged by h^2. Allowed is the difference of the
   !> two quadratures, as above.
   subroutine test_seams()
      real(wp), parameter :: below = 1.0_wp - 4.0_wp*eps, above = 1.0_wp + 4.0_wp*eps
      type(random_stream) :: stream
      type(normal_properties) :: p
      real(wp) :: k, h, worst(3)
      integer :: i

      stream = random_stream(seed + 1)
      worst = 0.0_wp
      do i = 1, 5000
         k = stream%uniform(0.05_wp, 1.0_wp)
         ! the separation falls below the lowest
         p = properties_with(stream%log_uniform(1.0e-8_wp, largest_ratio*below), k)
         call step_across(p, lowest*below, p, lowest*above, worst(1))
         ! the product grows beyond its limit
         p = properties_with(stream%log_uniform(largest_product/37.0_wp, largest_ratio*below), k)
         h = largest_product*p%sigma/p%w1
         call step_across(p, h*below, p, h*above, worst(2))
         ! properties with larger w1/sigma
         h = stream%uniform(lowest, 0.999_wp*largest_product/largest_ratio)
         call step_across(properties_with(largest_ratio*below, k), h, &
            properties_with(largest_ratio*above, k), h, worst(3))
      end do
      call record('fixed_pieces.seam.separation', worst(1))
      call record('fixed_pieces.seam.product', worst(2))
      call record('fixed_pieces.seam.ratio', worst(3))
      call assertLessThan(maxval(worst), 1.0e-14_wp, 'pressure')
   end subroutine test_seams

   subroutine step_across(p_inside, h_inside, p_outside, h_outside, worst)
      type(normal_properties), intent(in) :: p_inside, p_outside
      real(wp), intent(in) :: h_inside, h_outside
      real(wp), intent(inout) :: worst
      type(normal_response) :: inside, outside
      real(wp) :: d

      d = h_inside*p_inside%sigma
      call assertTrue(fixed_pieces_serve(p_inside, d/p_inside%sigma), 'inside')
      call evaluate_scaled_law(p_inside, d, inside)
      d = h_outside*p_outside%sigma
      call assertFalse(fixed_pieces_serve(p_outside, d/p_outside%sigma), &
         'outside')
      call evaluate_scaled_law(p_outside, d, outside)
      call worsen(worst, abs(inside%pressure/outside%pressure - 1.0_wp))
   end subroutine step_across

   !> Nothing else changes.
   subroutine test_without_slope()
      type(piece_type) :: with(2), without(2)
      integer :: i

      call evaluate_fixed_pieces(properties_with(0.01_wp, 0.4_wp), 1.5_wp, .true., .true., &
         with(1), with(2))
      call evaluate_fixed_pieces(properties_with(0.01_wp, 0.4_wp), 1.5_wp, .false., .false., &
         without(1), without(2))
      do i = 1, 2
         call assertGreaterThan(with(i)%area_slope, 0.0_wp, 'with')
         with(i)%area_slope = 0.0_wp
         call assertEqual(numbers_of(with(i)), numbers_of(without(i)), 0.0_wp, 'the rest')
      end do
   end subroutine test_without_slope

   !> Against the general quadrature, which sums the dissipation summit by summit. The difference of
   !> energy and recoverable energy that the fixed rule takes loses a digit or two.
   subroutine test_memory()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(piece_type) :: fixed(2), wanted
      real(wp) :: a, h, worst(2)
      integer :: i

      stream = random_stream(seed + 3)
      worst = 0.0_wp
      do i = 1, 20000
         call random_properties(stream, p, 1.0e-8_wp, largest_ratio, 0.1908_wp)
         a = p%w1/p%sigma
         h = stream%uniform(lowest, min(37.0_wp, largest_product/a))
         if (.not. fixed_pieces_serve(p, h)) cycle
         call evaluate_fixed_pieces(p, h, .false., .true., fixed(1), fixed(2))
         wanted = elastoplastic_piece(p, h*p%sigma, .true.)
         call worsen(worst, abs([fixed(2)%recoverable/wanted%recoverable, &
            fixed(2)%dissipation/wanted%dissipation]*exp(wanted%exponent) - 1.0_wp))
         call assertRelativelyEqual(wanted%energy, wanted%recoverable + wanted%dissipation, &
            1.0e-14_wp, 'sum')
      end do
      call record('fixed_pieces.recoverable', worst(1))
      call record('fixed_pieces.dissipation', worst(2))
      call assertLessThan(worst(1), 1.0e-12_wp, 'recoverable')
      call assertLessThan(worst(2), 1.0e-11_wp, 'dissipation')
   end subroutine test_memory

   !> The limits themselves; nothing bounds the separation of small w1/sigma. The points are those
   !> of one plastic ratio.
   subroutine test_range()
      real(wp), parameter :: other = 110.0_wp*(1.0_wp + eps)

      call assertTrue(serves(0.025_wp, -7.0_wp), 'both limits')
      call assertFalse(serves(0.0251_wp, -7.0_wp), 'w1/sigma')
      call assertFalse(serves(0.025_wp, -7.01_wp), 'd/sigma')
      call assertTrue(serves(0.02_wp, 13.9_wp), 'product')
      call assertFalse(serves(0.02_wp, 14.1_wp), 'product')
      call assertTrue(serves(1.0e-8_wp, 1.0e7_wp), 'far')
      call assertFalse(serves(0.02_wp, 1.0_wp, other), 'plastic ratio')
   end subroutine test_range

   !> Whether the rule serves at a w1/sigma and d/sigma.
   logical function serves(a, h, plastic_ratio)
      real(wp), intent(in) :: a, h
      real(wp), intent(in), optional :: plastic_ratio
      type(normal_properties) :: p

      p%w1 = a
      p%sigma = 1.0_wp
      if (present(plastic_ratio)) p%plastic_ratio = plastic_ratio
      serves = fixed_pieces_serve(p, h)
   end function serves

   !> By the intrinsic power: the polynomial errs by some eps/2, and the rounding of the ratio or of
   !> its logarithm enters times the exponent, 0.32 at most.
   subroutine test_force_powers()
      type(random_stream) :: stream
      real(wp) :: powers(n_points), exponent, k, worst
      integer :: i

      stream = random_stream(seed + 2)
      worst = 0.0_wp
      do i = 1, 5000
         k = stream%uniform(0.05_wp, 1.0_wp)
         if (i == 1) k = 0.05_wp
         if (i == 2) k = 1.0_wp
         exponent = log(2.0_wp/k)/log(110.0_wp)
         call find_force_powers(exponent, powers)
         call worsen(worst, largest_of(powers &
            /(ratio/sqrt(110.0_wp))**(exponent - middle_exponent) - 1.0_wp))
      end do
      call record('fixed_pieces.force_powers', worst)
      call assertLessThan(worst, 6.0_wp*eps, 'powers')
   end subroutine test_force_powers

   !> The integrals that the points were made for where they have a closed form: over w/w1 = 1..110
   !> of powers up to 2 + b3 - 1, and of 1 and w/w1 times exp(-q w/w1), which is the density for a
   !> small w1/sigma.
   subroutine test_weights()
      integer, parameter :: steps = 28
      real(wp) :: p, q
      integer :: i

      call assertRelativelyEqual(exp(log_ratio), ratio, 5.0_wp*eps, 'ratios')
      do i = 0, steps
         p = 0.1_wp*i
         call assertRelativelyEqual((110.0_wp**(p + 1.0_wp) - 1.0_wp)/(p + 1.0_wp), &
            sum(weight*ratio**(p + 1.0_wp)), 1.0e-13_wp, 'power')
         q = 0.01_wp*max(i, 1)
         call assertRelativelyEqual((exp(-q) - exp(-110.0_wp*q))/q, &
            sum(weight*ratio*exp(-q*ratio)), 1.0e-13_wp, 'density')
         call assertRelativelyEqual(((1.0_wp + q)*exp(-q) - (1.0_wp + 110.0_wp*q) &
            *exp(-110.0_wp*q))/q**2, sum(weight*ratio**2*exp(-q*ratio)), 1.0e-13_wp, 'force')
      end do
      ! the Gauss rule of unloading integrates powers to 2n - 1; a rounded point errs by half its
      ! power, sums of positive terms by n eps/2 at most
      do i = 0, 2*size(points) - 1
         call assertRelativelyEqual(1.0_wp/(i + 1), sum(weights*points**i), (14 + i)*eps, 'power')
      end do
   end subroutine test_weights

end module test_law_fixed_pieces
