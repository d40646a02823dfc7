!> Two faces as one pair.
module test_faces_two_faces
   use asperity, only: contact_properties, error_type, evaluate_normal_law, face, face_of_wood, &
      find_surface, hardness_harder, hardness_softer, new_contact_properties, pair_from_faces, &
      pair_preset, roughness_face_1, roughness_face_2, roughness_moments, section_radial, &
      section_tangential, section_transverse, separation_for_pressure, surface_preset, wp
   use asperity_faces_nayak, only: moments_of_summits, nayak_summits, nayak_type
   use asperity_faces_two_faces, only: sum_of_summits
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_faces_two_faces

contains

   function suite_faces_two_faces() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('two faces')
      call suite%addTest(TestMethod('moments and summits, there and back', test_moments))
      call suite%addTest(TestMethod('sum of transverse and tangential', test_sum))
      call suite%addTest(TestMethod('sum of two equal faces', test_equal))
      call suite%addTest(TestMethod('closures under load', test_closures))
      call suite%addTest(TestMethod('rules of hardness and roughness', test_rules))
      call suite%addTest(TestMethod('six pairs of sections', test_six))
      call suite%addTest(TestMethod('alpha of a sum', test_alpha))
      call suite%addTest(TestMethod('what is refused', test_refused))
   end function suite_faces_two_faces

   !> A surface of Table 2 on a section, in a wood with a hardness of its radial section.
   function of_paper(name, section) result(one)
      character(len=*), intent(in) :: name
      integer, intent(in) :: section
      type(face) :: one
      type(surface_preset) :: surface
      type(wood_properties) :: wood
      type(error_type), allocatable :: error

      wood%hardnesses(3) = 9.0_wp
      call find_surface(name, surface, error)
      call assertFalse(allocated(error), name)
      call face_of_wood(one, surface, section, error, wood)
      call assertFalse(allocated(error), name)
   end function of_paper

   !> Nayak's formulas turned round.
   subroutine test_moments()
      type(nayak_type) :: summits
      real(wp) :: m0, m2, m4
      integer :: i
      real(wp), parameter :: numbers(3, 3) = reshape([206.0_wp, 0.1477_wp, 0.0593_wp, &
         12.0_wp, 0.05_wp, 0.04_wp, 1.0e4_wp, 0.02_wp, 1.0e-3_wp], [3, 3])

      do i = 1, 3
         call moments_of_summits(numbers(1, i), numbers(2, i), numbers(3, i), m0, m2, m4)
         summits = nayak_summits(m0, m2, m4)
         call assertEqual(1.0_wp, summits%density/numbers(1, i), 1.0e-15_wp, 'density')
         call assertEqual(1.0_wp, summits%curvature*numbers(2, i), 1.0e-15_wp, 'curvature')
         call assertEqual(1.0_wp, sqrt(summits%variance)/numbers(3, i), 2.0e-15_wp, 'sigma')
      end do
   end subroutine test_moments

   !> By hand: 1/R^2 and 1/(R^2 eta) of both faces add; sigma of summits as Nayak has it, here so
   !> near to that of heights, 1/alpha = 0.0004, that squares of sigma add to within it.
   subroutine test_sum()
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      real(wp) :: expected(3), errors(3)
      real(wp), parameter :: r1 = 0.1477_wp, r2 = 0.1142_wp, s1 = 0.0593_wp, s2 = 0.0416_wp, &
         e1 = 206.0_wp, e2 = 134.0_wp, c = 1.0_wp - 3.0_wp*sqrt(3.0_wp) + 16.0_wp/acos(-1.0_wp)

      call pair_from_faces(of_paper('unpolished-cross', section_transverse), &
         of_paper('unpolished-tangential', section_tangential), pair, error)
      call assertFalse(allocated(error))
      associate (m4 => 1.0_wp/r1**2 + 1.0_wp/r2**2, m2 => 1.0_wp/(r1**2*e1) + 1.0_wp/(r2**2*e2))
         expected(1) = m4/m2
         expected(2) = 1.0_wp/sqrt(m4)
         ! m0 = sigma^2 + c m2^2/m4 in 64/(9 pi) and 6 pi sqrt(3) of these
         expected(3) = sqrt(s1**2 + s2**2 + c*(9.0_wp*acos(-1.0_wp)/64.0_wp)/(108.0_wp &
            *acos(-1.0_wp)**2)*(1.0_wp/(r1*e1)**2 + 1.0_wp/(r2*e2)**2 - m2**2/m4))
      end associate
      errors = abs([pair%eta, pair%radius, pair%sigma]/expected - 1.0_wp)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], errors, 1.0e-12_wp, 'against formulas')
      call record('faces.sum', maxval(errors))
      call assertEqual(154.2_wp, pair%eta, 0.05_wp, 'eta')
      call assertEqual(0.09034_wp, pair%radius, 5.0e-6_wp, 'radius')
      call assertEqual(0.07244_wp, pair%sigma, 5.0e-6_wp, 'sigma')
   end subroutine test_sum

   !> Twice the same face: the density stays, R falls and sigma grows by the square root of two.
   subroutine test_equal()
      type(pair_preset) :: pair
      type(face) :: one
      type(error_type), allocatable :: error

      one = of_paper('mesh-400-radial', section_radial)
      call pair_from_faces(one, one, pair, error)
      call assertFalse(allocated(error))
      call assertEqual(one%eta, pair%eta, 1.0e-12_wp*one%eta)
      call assertEqual(one%radius/sqrt(2.0_wp), pair%radius, 1.0e-15_wp)
      call assertEqual(one%sigma*sqrt(2.0_wp), pair%sigma, 1.0e-15_wp)
      call assertEqual(0.5_wp*one%young_modulus/(1.0_wp - one%poisson_ratio**2), pair%modulus, &
         1.0e-10_wp)
      call assertEqual(one%hardness, pair%hardness, 0.0_wp)
   end subroutine test_equal

   !> Transverse on tangential by the E* and H of Table 4: closures 4 sigma - d that another
   !> computation found at four pressures, to the figures that it printed.
   subroutine test_closures()
      type(pair_preset) :: pair
      type(contact_properties) :: properties
      type(error_type), allocatable :: error
      real(wp), parameter :: pressures(4) = [0.05_wp, 0.2_wp, 1.0_wp, 4.7_wp], &
         closures(4) = [0.0735_wp, 0.103_wp, 0.142_wp, 0.186_wp], &
         digits(4) = [5.0e-5_wp, 5.0e-4_wp, 5.0e-4_wp, 5.0e-4_wp]
      real(wp) :: separation, largest
      integer :: i

      call pair_from_faces(of_paper('unpolished-cross', section_transverse), &
         of_paper('unpolished-tangential', section_tangential), pair, error, hardness_harder)
      pair%modulus = 297.0_wp
      call new_contact_properties(properties, pair, error)
      call assertFalse(allocated(error))
      largest = 0.0_wp
      do i = 1, 4
         call separation_for_pressure(properties%normal, pressures(i), separation, error)
         call assertFalse(allocated(error))
         call assertEqual(closures(i), properties%initial_separation - separation, digits(i), &
            'closure')
         largest = max(largest, abs(closures(i) - (properties%initial_separation - separation)))
      end do
      call record('faces.closures', largest)
   end subroutine test_closures

   !> Each rule by itself.
   subroutine test_rules()
      type(face) :: cross, tangential
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      cross = of_paper('unpolished-cross', section_transverse)
      tangential = of_paper('unpolished-tangential', section_tangential)
      call pair_from_faces(cross, tangential, pair, error, hardness_softer)
      call assertEqual(12.14_wp, pair%hardness, 0.0_wp, 'softer')
      call pair_from_faces(cross, tangential, pair, error, hardness_harder)
      call assertEqual(24.53_wp, pair%hardness, 0.0_wp, 'harder')
      call pair_from_faces(cross, tangential, pair, error, roughness_rule=roughness_face_1)
      call assertEqual([206.0_wp, 0.1477_wp, 0.0593_wp], [pair%eta, pair%radius, pair%sigma], &
         0.0_wp, 'face 1')
      call pair_from_faces(cross, tangential, pair, error, roughness_rule=roughness_face_2)
      call assertEqual([134.0_wp, 0.1142_wp, 0.0416_wp], [pair%eta, pair%radius, pair%sigma], &
         0.0_wp, 'face 2')
      call assertEqual([0.4_wp, 0.5_wp, 0.31_wp], [pair%yield_factor, pair%friction_coefficient, &
         pair%critical_slip], 0.0_wp, 'of the paper')
   end subroutine test_rules

   !> All pairs of sections, either way round, give the same pair and a law.
   subroutine test_six()
      character(len=21), parameter :: names(3) = [character(len=21) :: 'unpolished-cross', &
         'unpolished-tangential', 'unpolished-radial']
      type(pair_preset) :: pair, turned
      type(contact_properties) :: properties
      type(error_type), allocatable :: error
      integer :: i, j

      do i = 1, 3
         do j = i, 3
            call pair_from_faces(of_paper(names(i), i), of_paper(names(j), j), pair, error)
            call assertFalse(allocated(error))
            call pair_from_faces(of_paper(names(j), j), of_paper(names(i), i), turned, error)
            call assertEqual([pair%eta, pair%modulus, pair%radius, pair%hardness, pair%sigma], &
               [turned%eta, turned%modulus, turned%radius, turned%hardness, turned%sigma], &
               1.0e-12_wp, 'turned')
            call new_contact_properties(properties, pair, error)
            call assertFalse(allocated(error), names(i)//names(j))
         end do
      end do
   end subroutine test_six

   !> By the inequality of Cauchy and Schwarz alpha of a sum is at least the lesser of both.
   subroutine test_alpha()
      type(face) :: faces(2)
      type(nayak_type) :: one(2), both
      real(wp) :: m0, m2, m4, numbers(3, 2)
      integer :: i, k

      do i = 1, 200
         do k = 1, 2
            ! a spread of decades without a stream of random numbers
            numbers(:, k) = 10.0_wp**(2.0_wp*sin(real(i*k, wp)*[1.0_wp, 1.7_wp, 2.3_wp]))
            faces(k)%eta = 100.0_wp*numbers(1, k)
            faces(k)%radius = 0.1_wp*numbers(2, k)
            faces(k)%sigma = 0.01_wp*numbers(3, k)
            call moments_of_summits(faces(k)%eta, faces(k)%radius, faces(k)%sigma, m0, m2, m4)
            one(k) = nayak_summits(m0, m2, m4)
         end do
         both = sum_of_summits(faces(1), faces(2))
         call assertTrue(both%alpha >= minval(one%alpha)*(1.0_wp - 1.0e-12_wp), 'alpha')
      end do
   end subroutine test_alpha

   !> Every number of either face, and rules.
   subroutine test_refused()
      type(face) :: good, bad
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      good = of_paper('unpolished-cross', section_transverse)
      bad = good
      bad%sigma = 0.0_wp
      call expect('sigma')
      ! of a smooth face nothing is asked
      call pair_from_faces(bad, good, pair, error, roughness_rule=roughness_face_2)
      call assertFalse(allocated(error), 'smooth')
      bad%radius = -1.0_wp
      bad%sigma = good%sigma
      call expect('radius')
      bad = good
      bad%eta = 0.0_wp
      call expect('eta')
      bad = good
      bad%young_modulus = 0.0_wp
      call expect('young_modulus')
      bad = good
      bad%poisson_ratio = 1.0_wp
      call expect('poisson_ratio')
      bad = good
      bad%hardness = -1.0_wp
      call expect('hardness')
      call pair_from_faces(good, good, pair, error, hardness_rule=3)
      call refused('hardness_rule = 3')
      call pair_from_faces(good, good, pair, error, roughness_rule=0)
      call refused('roughness_rule = 0')
      call pair_from_faces(good, good, pair, error, roughness_rule=roughness_moments)
      call assertFalse(allocated(error))
   contains
      subroutine expect(name)
         character(len=*), intent(in) :: name

         call pair_from_faces(bad, good, pair, error)
         call refused(name//'_1 = ')
         call pair_from_faces(good, bad, pair, error)
         call refused(name//'_2 = ')
      end subroutine expect

      subroutine refused(start)
         character(len=*), intent(in) :: start

         call assertTrue(allocated(error), start)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, start), error%message)
         call assertTrue(fits_subject(error), error%subject)
      end subroutine refused
   end subroutine test_refused

end module test_faces_two_faces
