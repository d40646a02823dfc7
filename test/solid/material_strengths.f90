!> Yield of a piece of wood under one stress, against formulas for each criterion and direction.
module test_solid_material_strengths
   use asperity, only: wp
   use asperity_solid_material_material, only: material_point, solid_material, update_material
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertRelativelyEqual, &
      assertTrue, TestMethod, TestSuite
   use material_cases, only: criteria, distinct_wood, first_yield_stress, load, place_of, prepare
   implicit none
   private
   public :: suite_material_strengths

contains

   function suite_material_strengths() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('strengths of wood')
      call suite%addTest(TestMethod('yield at each strength, in all six places', test_first_yield))
      call suite%addTest(TestMethod('ideally plastic: stress stays at each strength', test_ideal))
      call suite%addTest(TestMethod('slope of hardening in each direction', test_slopes))
      call suite%addTest(TestMethod('pressed along the grain', test_along))
      call suite%addTest(TestMethod('crushing apart from tension', test_shifted))
      call suite%addTest(TestMethod('unloading is elastic', test_unloading))
      call suite%addTest(TestMethod('wood held at its sides', test_held))
   end function suite_material_strengths

   !> Strengths of L, R, T, LR, LT, RT in tension (sign 1) or compression (-1).
   function strengths_of(wood, sense) result(strengths)
      type(wood_properties), intent(in) :: wood
      integer, intent(in) :: sense
      real(wp) :: strengths(6)

      strengths = [wood%compression_strengths, wood%shear_strengths]
      if (wood%criterion == 'mises') strengths = wood%compression_strengths(2) &
         *[1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp/sqrt(3.0_wp), 1.0_wp/sqrt(3.0_wp), 1.0_wp/sqrt(3.0_wp)]
      if (wood%criterion == 'crushing' .and. sense > 0) strengths(1:3) = wood%tension_strengths
   end function strengths_of

   !> Places of L, R, T, LR, LT, RT.
   function places(grain, radial) result(p)
      integer, intent(in) :: grain, radial
      integer :: p(6), t

      t = 6 - grain - radial
      p = [grain, radial, t, place_of(grain, radial), place_of(grain, t), place_of(radial, t)]
   end function places

   subroutine test_first_yield()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: point
      real(wp) :: strengths(6), stress(6)
      integer :: grain, radial, p(6), criterion, sense, i
      logical :: yields

      do criterion = 1, 3
         wood = distinct_wood(criteria(criterion))
         do grain = 1, 3
            do radial = 1, 3
               if (radial == grain) cycle
               call prepare(material, wood, grain, radial)
               p = places(grain, radial)
               do sense = -1, 1, 2
                  strengths = strengths_of(wood, sense)
                  do i = 1, 6
                     stress = 0.0_wp
                     stress(p(i)) = sense*strengths(i)
                     call update_material(material, material_point(), &
                        (1.0_wp - 2.0e-12_wp)*matmul(material%compliance, stress), point, yields)
                     call assertFalse(yields, 'below the strength: '//criteria(criterion))
                     call update_material(material, material_point(), &
                        (1.0_wp + 4.0e-12_wp)*matmul(material%compliance, stress), point, yields)
                     call assertTrue(yields, 'above the strength: '//criteria(criterion))
                  end do
               end do
            end do
         end do
      end do
   end subroutine test_first_yield

   subroutine test_ideal()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: point
      real(wp) :: strengths(6), strain(6)
      integer :: p(6), criterion, sense, i, j

      do criterion = 1, 3
         wood = distinct_wood(criteria(criterion))
         wood%hardening_across = 0.0_wp
         call prepare(material, wood, 2, 3)
         p = places(2, 3)
         do sense = -1, 1, 2
            strengths = strengths_of(wood, sense)
            do i = 1, 6
               strain = material%compliance(:, p(i))*(3.0_wp*sense*strengths(i))
               call load(material, material_point(), [(j == p(i), j=1, 6)], strain, point)
               call assertRelativelyEqual(sense*strengths(i), point%stress(p(i)), 1.0e-12_wp, &
                  criteria(criterion))
               call assertGreaterThan(point%equivalent_strain, 0.0_wp)
            end do
         end do
      end do
   end subroutine test_ideal

   !> A stress alone, with the same strengths in tension and compression: strength +
   !> h (strength/reference)^2 plastic strain, h the slope across the grain.
   subroutine test_slopes()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: point
      real(wp) :: strengths(6), strain(6), slope, plastic
      integer :: p(6), criterion, i, j

      do criterion = 1, 3
         wood = distinct_wood(criteria(criterion))
         wood%tension_strengths = wood%compression_strengths
         call prepare(material, wood, 3, 1)
         p = places(3, 1)
         strengths = strengths_of(wood, -1)
         do i = 1, 6
            strain = -material%compliance(:, p(i))*(6.0_wp*strengths(i))
            call load(material, material_point(), [(j == p(i), j=1, 6)], strain, point)
            slope = wood%hardening_across*wood%young_moduli(2) &
               *(strengths(i)/wood%compression_strengths(2))**2
            plastic = -point%plastic_strain(p(i))
            call assertGreaterThan(plastic, 0.0_wp)
            call assertRelativelyEqual(strengths(i) + slope*plastic, -point%stress(p(i)), &
               1.0e-12_wp, criteria(criterion))
            call assertRelativelyEqual(strain(p(i)) + plastic, &
               material%compliance(p(i), p(i))*point%stress(p(i)), 1.0e-12_wp)
            ! work: stress on plastic strain is yield stress on the equivalent one
            call assertRelativelyEqual(plastic*strengths(i)/wood%compression_strengths(2), &
               point%equivalent_strain, 1.0e-12_wp)
         end do
      end do
   end subroutine test_slopes

   subroutine test_along()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: point
      real(wp) :: strain(6)
      integer :: j

      wood = distinct_wood('mises')
      ! the curve is that across the grain
      allocate (wood%hardening_curve(2, 2))
      wood%hardening_curve = reshape([0.0_wp, 4.7_wp, 0.1_wp, 9.0_wp], [2, 2])
      call prepare(material, wood, 3, 1, along=.true.)
      strain = material%compliance(:, 3)*(-4.0_wp*wood%compression_strengths(1))
      call load(material, material_point(), [(j == 3, j=1, 6)], strain, point)
      call assertRelativelyEqual(-wood%compression_strengths(1) + wood%hardening_along &
         *wood%young_moduli(1)*point%plastic_strain(3), point%stress(3), 1.0e-12_wp)
      ! one along it, of 200 MPa up to a plastic strain far beyond
      allocate (wood%hardening_curve_along(2, 2))
      wood%hardening_curve_along = reshape([0.0_wp, wood%compression_strengths(1), &
         10.0_wp, wood%compression_strengths(1) + 2000.0_wp], [2, 2])
      call prepare(material, wood, 3, 1, along=.true.)
      call load(material, material_point(), [(j == 3, j=1, 6)], strain, point)
      call assertRelativelyEqual(200.0_wp*point%plastic_strain(3) &
         - wood%compression_strengths(1), point%stress(3), 1.0e-12_wp)
      ! across the grain the other one
      call prepare(material, wood, 1, 3, along=.false.)
      strain = material%compliance(:, 3)*(-4.0_wp*wood%compression_strengths(2))
      call load(material, material_point(), [(j == 3, j=1, 6)], strain, point)
      call assertRelativelyEqual(43.0_wp*point%plastic_strain(3) &
         - wood%compression_strengths(2), point%stress(3), 1.0e-12_wp)
   end subroutine test_along

   !> With other strengths in tension the ellipsoid's centre is not at zero. The slope at first
   !> crushing in R is that of the wood; in the others it goes with the square of the
   !> harmonic mean of both strengths. Further on in R z = sqrt((f^2 - k)/P), k the share of the
   !> other centres; the plastic strain comes to its integral as the steps fall.
   subroutine test_shifted()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: point
      real(wp) :: strain(6), strengths(6), half(6), mean, slope, h, stress, plastic, errors(2)
      integer :: p(6), i, j, sense

      wood = distinct_wood('crushing')
      call prepare(material, wood, 1, 2)
      p = places(1, 2)
      h = wood%hardening_across*wood%young_moduli(2)
      mean = 1.0_wp/wood%tension_strengths(2) + 1.0_wp/wood%compression_strengths(2)
      do sense = -1, 1, 2
         strengths = strengths_of(wood, sense)
         half = [2.0_wp/(1.0_wp/wood%tension_strengths + 1.0_wp/wood%compression_strengths), &
            wood%shear_strengths]
         do i = 1, 6
            strain = sense*material%compliance(:, p(i))*strengths(i)*(1.0_wp + 1.0e-6_wp)
            call load(material, material_point(), [(j == p(i), j=1, 6)], strain, point)
            slope = (sense*point%stress(p(i)) - strengths(i))/abs(point%plastic_strain(p(i)))
            call assertRelativelyEqual(h*(0.5_wp*mean*half(i))**2, slope, 1.0e-4_wp)
         end do
      end do

      do i = 1, 2
         call crush_in_steps(material, 400*i, point)
         call crush(wood, h, point%equivalent_strain, stress, plastic)
         call assertRelativelyEqual(stress, point%stress(2), 1.0e-12_wp)
         errors(i) = point%plastic_strain(2) - plastic
      end do
      call assertRelativelyEqual(2.0_wp, errors(1)/errors(2), 0.02_wp)
      call assertEqual(0.0_wp, errors(2), tolerance=1.0e-5_wp)
      call assertGreaterThan(abs(plastic/point%equivalent_strain + 1.0_wp), 1.0e-2_wp)
   end subroutine test_shifted

   !> R pressed alone to a strain of 0.3 in equal steps.
   subroutine crush_in_steps(material, n, point)
      type(solid_material), intent(in) :: material
      integer, intent(in) :: n
      type(material_point), intent(out) :: point
      type(material_point) :: next
      real(wp) :: strain(6)
      integer :: i, j

      strain = 0.0_wp
      do i = 1, n
         strain(2) = -0.3_wp*real(i, wp)/real(n, wp)
         call load(material, point, [(j == 2, j=1, 6)], strain, next)
         point = next
      end do
   end subroutine crush_in_steps

   !> R pressed alone until an equivalent plastic strain: stress, and plastic strain, the integral
   !> of P z/f.
   subroutine crush(wood, h, equivalent, stress, strain)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: h, equivalent
      real(wp), intent(out) :: stress, strain
      real(wp) :: first, last, p, k, square_of_size

      first = first_yield_stress(wood)
      last = first + h*equivalent
      associate (a => wood%tension_strengths, b => wood%compression_strengths)
         square_of_size = 1.0_wp + sum((a - b)**2/(4.0_wp*a*b))
         p = first**2/(square_of_size*a(2)*b(2))
         k = first**2/square_of_size*((a(1) - b(1))**2/(4.0_wp*a(1)*b(1)) &
            + (a(3) - b(3))**2/(4.0_wp*a(3)*b(3)))
         stress = 0.5_wp*(a(2) - b(2)) - sqrt((last**2 - k)/p)
      end associate
      strain = -sqrt(p)/h*(antiderivative(last, k) - antiderivative(first, k))
   end subroutine crush

   !> Of sqrt(f^2 - k)/f.
   real(wp) function antiderivative(f, k)
      real(wp), intent(in) :: f, k

      antiderivative = sqrt(f**2 - k) - sqrt(k)*acos(sqrt(k)/f)
   end function antiderivative

   subroutine test_unloading()
      type(solid_material) :: material
      type(material_point) :: point, back
      real(wp) :: strain(6), change(6)
      integer :: criterion
      logical :: yields

      do criterion = 1, 3
         call prepare(material, distinct_wood(criteria(criterion)), 1, 2)
         strain = [0.01_wp, -0.05_wp, 0.01_wp, 0.02_wp, 0.0_wp, -0.01_wp]
         call update_material(material, material_point(), strain, point, yields)
         call assertTrue(yields)
         ! the same strain once more: on the surface, not outside
         call update_material(material, point, strain, back, yields)
         call assertFalse(yields)
         call assertRelativelyEqual(point%stress(2), back%stress(2), 1.0e-12_wp)
         change = -0.05_wp*matmul(material%compliance, point%stress)
         call update_material(material, point, strain + change, back, yields)
         call assertFalse(yields)
         call assertEqual(point%plastic_strain, back%plastic_strain)
         call assertEqual(0.95_wp*point%stress, back%stress, &
            tolerance=1.0e-12_wp*maxval(abs(point%stress)))
      end do
   end subroutine test_unloading

   !> Crushed in R and held in T: side strain takes no part in crushing, and the stress is the
   !> strength; Hill's flow needs the same strain in T, and the stress rises to
   !> fc90/sqrt(1 - F^2), F = 1 - (fc90/fc0)^2/2: nearly the strength along the grain.
   subroutine test_held()
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: point, next
      real(wp) :: strain(6), f, expected
      integer :: criterion, i, j

      do criterion = 2, 3
         wood = wood_properties(criterion=criteria(criterion), hardening_across=0.0_wp)
         call prepare(material, wood, 1, 2)
         expected = -wood%compression_strengths(2)
         if (criterion == 2) then
            f = 1.0_wp - 0.5_wp*(wood%compression_strengths(2)/wood%compression_strengths(1))**2
            expected = expected/sqrt((1.0_wp - f)*(1.0_wp + f))
         else
            ! the shift along the grain takes no part while the strengths are these
            wood%tension_strengths = wood%compression_strengths
            call prepare(material, wood, 1, 2)
         end if
         strain = 0.0_wp
         point = material_point()
         do i = 1, 200
            strain(2) = strain(2) - 0.05_wp
            call load(material, point, [(j == 2 .or. j == 3, j=1, 6)], strain, next)
            point = next
         end do
         call assertRelativelyEqual(expected, point%stress(2), 1.0e-9_wp, criteria(criterion))
      end do
   end subroutine test_held

end module test_solid_material_strengths
