!> The return to the yield surface: against a fine explicit integration, its conditions in random
!> states, curves of hardening.
module test_solid_material_return
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_base_finite, only: all_finite
   use asperity_base_number_text, only: to_text
   use asperity_solid_material_material, only: material_point, solid_material, update_material
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, &
      assertTrue, TestMethod, TestSuite
   use material_cases, only: criteria, distinct_wood, equivalent_stress, first_yield_stress, load, &
      prepare, random_curve, random_vector
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_material_return

   integer(int64), parameter :: seed = 26457513_int64
   !> Axes of all tests here, and LL, RR, TT, LR, LT, RT in them
   integer, parameter :: grain = 2, radial = 1, places(6) = [2, 1, 3, 4, 5, 6]

contains

   function suite_material_return() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('return to the yield surface')
      call suite%addTest(TestMethod('explicit integration, two legs', test_explicit))
      call suite%addTest(TestMethod('on the surface, flow normal to it', test_conditions))
      call suite%addTest(TestMethod('one step as many along a curve', test_curve))
      call suite%addTest(TestMethod('huge strains', test_huge))
   end function suite_material_return

   !> Slopes of the equivalent stress, by differences, for the order LL, RR, TT, LR, LT, RT.
   function slopes_of(wood, s) result(slopes)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: s(6)
      real(wp) :: slopes(6), step, ahead(6), back(6)
      integer :: i

      step = 1.0e-4_wp
      do i = 1, 6
         ahead = s
         back = s
         ahead(i) = s(i) + step
         back(i) = s(i) - step
         slopes(i) = (equivalent_stress(wood, ahead) - equivalent_stress(wood, back))/(2.0_wp*step)
      end do
   end function slopes_of

   !> Rates of stress and equivalent plastic strain of a point that yields, by the strain.
   subroutine find_rates(wood, stiffness, h, stress, leg, rate, strain_rate)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: stiffness(6, 6), h, stress(6), leg(6)
      real(wp), intent(out) :: rate(6), strain_rate
      real(wp) :: n(6)

      n(places) = slopes_of(wood, stress(places))
      rate = matmul(stiffness, leg)
      strain_rate = dot_product(n, rate)/(dot_product(n, matmul(stiffness, n)) + h)
      rate = rate - matmul(stiffness, n)*strain_rate
   end subroutine find_rates

   !> Stress and equivalent strain along two legs from a point on the surface, by the Runge-Kutta
   !> method of fourth order.
   subroutine integrate(wood, stiffness, h, legs, stress, strain)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: stiffness(6, 6), h, legs(6, 2)
      real(wp), intent(inout) :: stress(6)
      real(wp), intent(out) :: strain
      integer, parameter :: n = 2000
      real(wp) :: rates(6, 4), strain_rates(4), step(6)
      integer :: i, leg

      strain = 0.0_wp
      do leg = 1, 2
         step = legs(:, leg)/n
         do i = 1, n
            call find_rates(wood, stiffness, h, stress, step, rates(:, 1), strain_rates(1))
            call find_rates(wood, stiffness, h, stress + 0.5_wp*rates(:, 1), step, rates(:, 2), &
               strain_rates(2))
            call find_rates(wood, stiffness, h, stress + 0.5_wp*rates(:, 2), step, rates(:, 3), &
               strain_rates(3))
            call find_rates(wood, stiffness, h, stress + rates(:, 3), step, rates(:, 4), &
               strain_rates(4))
            call assertTrue(all(strain_rates > 0.0_wp), 'the leg loads')
            stress = stress + matmul(rates, [1.0_wp, 2.0_wp, 2.0_wp, 1.0_wp])/6.0_wp
            strain = strain + dot_product(strain_rates, [1.0_wp, 2.0_wp, 2.0_wp, 1.0_wp])/6.0_wp
         end do
      end do
   end subroutine integrate

   !> The same in equal increments of the update.
   subroutine follow(material, first, legs, n, point)
      type(solid_material), intent(in) :: material
      real(wp), intent(in) :: first(6), legs(6, 2)
      integer, intent(in) :: n
      type(material_point), intent(out) :: point
      type(material_point) :: next
      real(wp) :: strain(6)
      logical :: yields
      integer :: i, leg

      strain = first
      do leg = 1, 2
         do i = 1, n
            call update_material(material, point, &
               strain + legs(:, leg)*(real(i, wp)/real(n, wp)), next, yields)
            point = next
         end do
         strain = strain + legs(:, leg)
      end do
   end subroutine follow

   !> From first yield along two legs with a turn between them. The update's error falls with its
   !> step, and what n and 2 n increments promise for none is the explicit result.
   subroutine test_explicit()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: coarse, fine
      real(wp), parameter :: legs(6, 2) = reshape([ &
         -0.04_wp, 0.01_wp, 0.01_wp, 0.02_wp, 0.0_wp, -0.01_wp, &
         -0.02_wp, 0.02_wp, -0.02_wp, 0.03_wp, -0.02_wp, 0.0_wp], [6, 2])
      real(wp) :: first(6), stress(6), strain, h, errors(2)
      integer :: criterion

      do criterion = 1, 3
         wood = distinct_wood(criteria(criterion))
         h = wood%hardening_across*wood%young_moduli(2)
         call prepare(material, wood, grain, radial)
         first = first_yield(wood, material%stiffness, legs(:, 1))
         stress = matmul(material%stiffness, first)
         call integrate(wood, material%stiffness, h, legs, stress, strain)
         call follow(material, first, legs, 400, coarse)
         call follow(material, first, legs, 800, fine)
         errors = [norm2(coarse%stress - stress), norm2(fine%stress - stress)]
         call assertLessThan(errors(1), 1.0e-2_wp*norm2(stress), criteria(criterion))
         call assertRelativelyEqual(2.0_wp, errors(1)/errors(2), 0.03_wp, criteria(criterion))
         call assertEqual(stress, 2.0_wp*fine%stress - coarse%stress, &
            tolerance=1.0e-5_wp*norm2(stress), message=criteria(criterion))
         call assertRelativelyEqual(strain, &
            2.0_wp*fine%equivalent_strain - coarse%equivalent_strain, 1.0e-5_wp)
      end do
   end subroutine test_explicit

   !> Strain along a leg, at which the elastic stress reaches the surface, by bisection.
   function first_yield(wood, stiffness, leg) result(strain)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: stiffness(6, 6), leg(6)
      real(wp) :: strain(6), stress(6), low, high, middle
      integer :: i

      stress = matmul(stiffness, leg)
      low = 0.0_wp
      high = 1.0_wp
      do i = 1, 60
         middle = 0.5_wp*(low + high)
         if (equivalent_stress(wood, middle*stress(places)) > first_yield_stress(wood)) then
            high = middle
         else
            low = middle
         end if
      end do
      strain = middle*leg
   end function first_yield

   !> Yield stress of a curve, by its points and the first yield stress.
   real(wp) function level(curve, first, strain)
      real(wp), intent(in) :: curve(:, :), first, strain
      integer :: i

      level = first + curve(2, size(curve, 2)) - curve(2, 1)
      do i = 2, size(curve, 2)
         if (strain > curve(1, i)) cycle
         level = first - curve(2, 1) + curve(2, i - 1) + (curve(2, i) - curve(2, i - 1)) &
            *(strain - curve(1, i - 1))/(curve(1, i) - curve(1, i - 1))
         return
      end do
   end function level

   !> Random wood, states and strains: the stress ends on the grown surface, the plastic strain
   !> grows along its normal by the equivalent strain, and stress is stiffness times elastic strain.
   subroutine test_conditions()
      type(random_stream) :: stream
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: start, point
      real(wp) :: strain(6), grown, normal(6), yield
      integer :: i, n_yielding
      logical :: yields
      character(len=40) :: message

      stream = random_stream(seed)
      n_yielding = 0
      do i = 1, 600
         message = 'seed '//to_text(seed)//', state '//to_text(i)
         wood = distinct_wood(criteria(1 + mod(i, 3)))
         wood%hardening_curve = random_curve(stream, wood%compression_strengths(2))
         call prepare(material, wood, grain, radial)
         start%plastic_strain = random_vector(stream, 0.02_wp)
         start%equivalent_strain = max(stream%uniform(-0.2_wp, 0.6_wp), 0.0_wp)
         strain = start%plastic_strain &
            + random_vector(stream, stream%log_uniform(1.0e-3_wp, 2.0_wp))
         call update_material(material, start, strain, point, yields)
         call assertEqual(matmul(material%stiffness, strain - point%plastic_strain), point%stress, &
            tolerance=1.0e-12_wp*maxval(matmul(material%stiffness, abs(strain))), message=message)
         yield = level(wood%hardening_curve, first_yield_stress(wood), point%equivalent_strain)
         if (.not. yields) then
            call assertLessThan(equivalent_stress(wood, point%stress(places)), &
               yield*(1.0_wp + 2.0e-12_wp), message)
            cycle
         end if
         n_yielding = n_yielding + 1
         ! a stress is a sum of six products, each as large as the elastic stress may be
         call assertRelativelyEqual(yield, equivalent_stress(wood, point%stress(places)), &
            1.0e-12_wp + 6*epsilon(1.0_wp)*maxval(matmul(material%stiffness, abs(strain)))/yield, &
            message)
         grown = point%equivalent_strain - start%equivalent_strain
         call assertGreaterThan(grown, 0.0_wp, message)
         normal(places) = slopes_of(wood, point%stress(places))
         call assertEqual(grown*normal, point%plastic_strain - start%plastic_strain, &
            tolerance=1.0e-7_wp*grown*norm2(normal), message=message)
      end do
      call assertGreaterThan(n_yielding, 400)
   end subroutine test_conditions

   !> Crushed in one direction: one large step over several points of the curve gives what many
   !> small ones give, and both the curve. One piece rises steeply after a flat one.
   subroutine test_curve()
      real(wp), parameter :: curve(2, 5) = reshape([0.0_wp, 4.7_wp, 0.02_wp, 6.0_wp, 0.2_wp, &
         6.0_wp, 0.25_wp, 20.0_wp, 0.5_wp, 22.0_wp], [2, 5])
      real(wp), parameter :: ends(6) = [0.03_wp, 0.15_wp, 0.24_wp, 0.3_wp, 0.5_wp, 1.0_wp]
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: at_once, small, next
      real(wp) :: strain(6)
      integer :: criterion, i, j, k

      do criterion = 1, 3
         wood = distinct_wood(criteria(criterion))
         wood%tension_strengths = wood%compression_strengths
         wood%hardening_curve = curve
         call prepare(material, wood, grain, radial)
         do k = 1, size(ends)
            strain = 0.0_wp
            strain(radial) = -ends(k)
            call load(material, material_point(), [(j == radial, j=1, 6)], strain, at_once)
            strain = 0.0_wp
            small = material_point()
            do i = 1, 100
               strain(radial) = -ends(k)*(real(i, wp)/100.0_wp)
               call load(material, small, [(j == radial, j=1, 6)], strain, next)
               small = next
            end do
            call assertRelativelyEqual(small%stress(radial), at_once%stress(radial), 1.0e-12_wp, &
               criteria(criterion))
            call assertEqual(small%plastic_strain, at_once%plastic_strain, tolerance=1.0e-11_wp)
            call assertRelativelyEqual( &
               -level(curve, curve(2, 1), -at_once%plastic_strain(radial)), &
               at_once%stress(radial), 1.0e-12_wp, criteria(criterion))
         end do
      end do
   end subroutine test_curve

   !> Iterates gone astray: still finite, and on the surface.
   subroutine test_huge()
      type(random_stream) :: stream
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: start, point
      real(wp) :: tangent(6, 6), strain(6)
      integer :: i
      logical :: yields
      character(len=40) :: message

      stream = random_stream(seed)
      do i = 1, 300
         message = 'seed '//to_text(seed)//', state '//to_text(i)
         wood = distinct_wood(criteria(1 + mod(i, 3)))
         wood%hardening_across = 0.0_wp
         call prepare(material, wood, grain, radial)
         strain = random_vector(stream, stream%log_uniform(1.0e-2_wp, 1.0e100_wp))
         call update_material(material, start, strain, point, yields, tangent)
         call assertTrue(yields, message)
         call assertTrue(all_finite([point%stress, point%plastic_strain, &
            point%equivalent_strain, reshape(tangent, [36])]), message)
         if (wood%criterion == 'crushing') call assertRelativelyEqual(first_yield_stress(wood), &
            equivalent_stress(wood, point%stress(places)), 1.0e-12_wp, message)
      end do
   end subroutine test_huge

end module test_solid_material_return
