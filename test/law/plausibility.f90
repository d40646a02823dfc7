!> What no face or solid has: limits of eta R sigma in closed form, slips of units, edges of ranges.
module test_law_plausibility
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, input_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_law_plausibility, only: alpha_min, ranges, roughness_number_max, &
      roughness_number_min, roughness_number_min_sq
   use asperity_law_validity, only: implausible_property, roughness_number_high, &
      roughness_number_low, valid, validity_remark
   use asperity_paper_pairs, only: pairs, surfaces
   use asperity_faces_nayak, only: nayak_summits, nayak_type
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertRelativelyEqual, &
      assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_plausibility

contains

   function suite_plausibility() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('plausibility')
      call suite%addTest(TestMethod('each names its values', test_subjects))
      call suite%addTest(TestMethod('least eta R sigma, in closed form', test_least_number))
      call suite%addTest(TestMethod('slips of units of wood are named', test_wood))
      call suite%addTest(TestMethod('slips of other faces and solids are refused', test_others))
      call suite%addTest(TestMethod('wood in N-m-Pa is right', test_si))
      call suite%addTest(TestMethod('edges of the ranges', test_edges))
   end function suite_plausibility

   !> As of the statistics of summits at alpha = 1.5, above which it only rises; the texts have it.
   subroutine test_least_number()
      type(nayak_type) :: summits
      real(wp) :: number, last
      integer :: i

      call assertRelativelyEqual(1.0_wp/(16.0_wp*sqrt(2.0_wp*pi)), roughness_number_min_sq, &
         1.0e-15_wp)
      call assertRelativelyEqual(sqrt((0.5_wp + 3.0_wp*sqrt(3.0_wp) - 16.0_wp/pi)/(768.0_wp*pi)), &
         roughness_number_min, 1.0e-14_wp)
      summits = nayak_summits(2.0_wp, 3.0_wp, alpha_min*4.5_wp)
      associate (eta_r => summits%density/summits%curvature)
         call assertRelativelyEqual(roughness_number_min, eta_r*sqrt(summits%variance), 1.0e-13_wp)
         call assertRelativelyEqual(roughness_number_min_sq, eta_r*sqrt(2.0_wp), 1.0e-14_wp)
      end associate
      last = roughness_number_min
      do i = 1, 100
         summits = nayak_summits(2.0_wp, 3.0_wp, (alpha_min + 0.1_wp*i)*4.5_wp)
         number = summits%density/summits%curvature*sqrt(summits%variance)
         call assertGreaterThan(number, last)
         last = number
      end do
      call assertEqual('0.0158', to_text(roughness_number_min, 3))
      call assertEqual('0.0249', to_text(roughness_number_min_sq, 3))
      call assertTrue(index(validity_remark(roughness_number_low), 'below 0.0158') > 0)
   end subroutine test_least_number

   !> Every face of Table 2 and both pairs of Table 4: right as they are, and in wrong units named.
   subroutine test_wood()
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, size(surfaces)
         associate (s => surfaces(i))
            call new_normal_properties(p, s%eta, 297.0_wp, s%radius, 24.53_wp, 0.4_wp, s%sigma, &
               error)
            call assertFalse(allocated(error), s%name)
            call assertEqual(valid, p%validity, s%name)
            call slip([1.0e-6_wp, 1.0_wp, 1.0_wp], 'eta looks like 1/um^2, give it in 1/mm^2')
            call slip([1.0_wp, 1.0e3_wp, 1.0_wp], 'radius looks like um, give it in mm (')
            call slip([1.0_wp, 1.0_wp, 1.0e3_wp], 'sigma looks like um, give it in mm (times 1e-3)')
            call slip([1.0_wp, 1.0e3_wp, 1.0e3_wp], 'radius looks like um')
            call slip([1.0_wp, 1.0e3_wp, 1.0e3_wp], 'sigma looks like um')
            call slip([1.0e-6_wp, 1.0_wp, 1.0e3_wp], 'eta looks like 1/um^2')
            call slip([1.0e-6_wp, 1.0_wp, 1.0e3_wp], 'sigma looks like um')
            call slip([1.0e-6_wp, 1.0e3_wp, 1.0_wp], 'eta looks like 1/um^2')
            call slip([1.0e-6_wp, 1.0e3_wp, 1.0_wp], 'radius looks like um')
            call slip([1.0e-6_wp, 1.0e3_wp, 1.0e3_wp], 'eta looks like 1/um^2')
            call slip([1.0e-6_wp, 1.0e3_wp, 1.0e3_wp], 'radius looks like um')
            call slip([1.0e-6_wp, 1.0e3_wp, 1.0e3_wp], 'sigma looks like um')
            call slip([1.0e6_wp, 1.0_wp, 1.0_wp], 'eta looks like 1/m^2')
            ! times 100, 1/cm^2 or another slip
            call slip([1.0e2_wp, 1.0_wp, 1.0_wp], 'looks like')
         end associate
      end do
      do i = 1, size(pairs)
         associate (q => pairs(i))
            call strength(q%modulus*1.0e6_wp, q%hardness, of_modulus('Pa', '-6'))
            call strength(q%modulus*1.0e-3_wp, q%hardness, of_modulus('GPa', '3'))
            call strength(q%modulus, q%hardness*1.0e6_wp, of_hardness('Pa', '-6'))
            call strength(q%modulus, q%hardness*1.0e-3_wp, of_hardness('GPa', '3'))
            call strength(q%modulus*1.0e6_wp, q%hardness*1.0e6_wp, &
               of_modulus('Pa', '-6')//'; '//of_hardness('Pa', '-6'))
            call strength(q%modulus*1.0e-3_wp, q%hardness*1.0e-3_wp, &
               of_modulus('GPa', '3')//'; '//of_hardness('GPa', '3'))
         end associate
      end do
      ! steel, and wood along its grain
      call strength(1.0e8_wp, 2.0e3_wp, of_modulus('kPa', '-3'))
      call strength(1.0e5_wp, 2.0e6_wp, of_hardness('kPa', '-3'))
      call strength(1.2e7_wp, 3.0e4_wp, of_modulus('kPa', '-3')//'; '//of_hardness('kPa', '-3'))

   contains

      subroutine slip(factors, text)
         real(wp), intent(in) :: factors(3)
         character(len=*), intent(in) :: text

         associate (s => surfaces(i))
            call refused(s%eta*factors(1), 297.0_wp, s%radius*factors(2), 24.53_wp, &
               s%sigma*factors(3), text)
         end associate
      end subroutine slip

      subroutine strength(modulus, hardness, text)
         real(wp), intent(in) :: modulus, hardness
         character(len=*), intent(in) :: text

         call refused(206.0_wp, modulus, 0.1477_wp, hardness, 0.0593_wp, &
            ' has: '//text//'; if it is right')
      end subroutine strength

      pure function of_modulus(unit, power) result(text)
         character(len=*), intent(in) :: unit, power
         character(len=:), allocatable :: text

         text = 'modulus looks like '//unit//', give it in MPa (times 1e'//power//')'
      end function of_modulus

      pure function of_hardness(unit, power) result(text)
         character(len=*), intent(in) :: unit, power
         character(len=:), allocatable :: text

         text = 'hardness looks like '//unit//', give it in MPa (times 1e'//power//')'
      end function of_hardness

   end subroutine test_wood

   !> The values that a property outside its range is made of.
   subroutine test_subjects()
      call expect([206.0_wp, 297.0_wp, 0.1477_wp, 24.53_wp, 6.0_wp], 'sigma')
      call expect([1.0e-3_wp, 297.0_wp, 2.0e4_wp, 24.53_wp, 0.0593_wp], 'radius')
      call expect([1.0_wp, 297.0_wp, 0.1477_wp, 24.53_wp, 0.0593_wp], 'eta radius sigma')
      call expect([206.0_wp, 2.0e6_wp, 0.1477_wp, 2.0e3_wp, 0.0593_wp], 'modulus')
      call expect([206.0_wp, 297.0_wp, 0.1477_wp, 0.09_wp, 0.0593_wp], 'hardness')
      call expect([206.0_wp, 297.0_wp, 0.1477_wp, 300.0_wp, 0.0593_wp], 'hardness modulus')

   contains

      subroutine expect(values, subject)
         real(wp), intent(in) :: values(5)
         character(len=*), intent(in) :: subject
         type(normal_properties) :: p
         type(error_type), allocatable :: error

         call new_normal_properties(p, values(1), values(2), values(3), values(4), 0.4_wp, &
            values(5), error)
         call assertTrue(allocated(error), subject)
         if (allocated(error)) call assertEqual(subject, error%subject)
      end subroutine expect

   end subroutine test_subjects

   !> Refused with a message that names the slip and the way past it, and let pass with a flag.
   subroutine refused(eta, modulus, radius, hardness, sigma, text)
      real(wp), intent(in) :: eta, modulus, radius, hardness, sigma
      character(len=*), intent(in) :: text
      type(normal_properties) :: p
      type(error_type), allocatable :: error

      call new_normal_properties(p, eta, modulus, radius, hardness, 0.4_wp, sigma, error)
      call assertTrue(allocated(error), text)
      if (.not. allocated(error)) return
      call assertEqual(input_error, error%category)
      call assertTrue(index(error%message, text) > 0, text//' expected in: '//error%message)
      call assertTrue(index(error%message, 'accept_unphysical') > 0, error%message)
      call new_normal_properties(p, eta, modulus, radius, hardness, 0.4_wp, sigma, error, &
         accept_unphysical=.true.)
      call assertFalse(allocated(error), 'accepted')
      call assertTrue(p%validity /= valid, 'flagged')
   end subroutine refused

   !> A ground and a polished metal, a ceramic, sawn and planed wood, a joint of rock: right as they
   !> are, and with one property a slip of units off refused whatever it is.
   subroutine test_others()
      !> eta, modulus, radius, hardness, sigma
      real(wp), parameter :: faces(5, 6) = reshape([ &
         1500.0_wp, 1.15e5_wp, 0.05_wp, 2.0e3_wp, 5.0e-4_wp, &
         5000.0_wp, 3.9e4_wp, 0.5_wp, 1.2e3_wp, 1.0e-5_wp, &
         1.0e4_wp, 2.0e5_wp, 0.02_wp, 1.8e4_wp, 2.0e-4_wp, &
         5.0_wp, 1.2e4_wp, 0.2_wp, 30.0_wp, 0.15_wp, &
         300.0_wp, 600.0_wp, 0.15_wp, 20.0_wp, 0.01_wp, &
         0.1_wp, 3.0e4_wp, 2.0_wp, 500.0_wp, 0.5_wp], [5, 6])
      !> Property, and factor of its slip
      integer, parameter :: slipped(9) = [1, 1, 2, 2, 3, 3, 4, 5, 5]
      real(wp), parameter :: factors(9) = [1.0e-6_wp, 1.0e6_wp, 1.0e6_wp, 1.0e-3_wp, 1.0e3_wp, &
         1.0e-3_wp, 1.0e6_wp, 1.0e3_wp, 1.0e-3_wp]
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      real(wp) :: v(5)
      integer :: i, j

      do i = 1, size(faces, 2)
         v = faces(:, i)
         call new_normal_properties(p, v(1), v(2), v(3), v(4), 0.4_wp, v(5), error)
         call assertFalse(allocated(error), 'right as it is')
         call assertEqual(valid, p%validity, 'right as it is')
         do j = 1, size(slipped)
            v = faces(:, i)
            v(slipped(j)) = v(slipped(j))*factors(j)
            call new_normal_properties(p, v(1), v(2), v(3), v(4), 0.4_wp, v(5), error)
            call assertTrue(allocated(error), 'face '//to_text(i)//', slip '//to_text(j))
         end do
         v = faces(:, i)*[1.0_wp, 1.0e6_wp, 1.0_wp, 1.0e6_wp, 1.0_wp]
         call refused(v(1), v(2), v(3), v(4), v(5), 'looks like')
      end do
   end subroutine test_others

   !> Every face and pair of wood in a consistent system, the law of which is the same.
   subroutine test_si()
      type(normal_properties) :: p, q
      type(error_type), allocatable :: error
      integer :: i, j

      do i = 1, size(surfaces)
         do j = 1, size(pairs)
            associate (s => surfaces(i), m => pairs(j))
               call new_normal_properties(p, s%eta, m%modulus, s%radius, m%hardness, 0.4_wp, &
                  s%sigma, error)
               call assertFalse(allocated(error), s%name)
               call new_normal_properties(q, 1.0e6_wp*s%eta, 1.0e6_wp*m%modulus, &
                  1.0e-3_wp*s%radius, 1.0e6_wp*m%hardness, 0.4_wp, 1.0e-3_wp*s%sigma, error)
               call assertFalse(allocated(error), s%name//' in N-m-Pa')
               call assertEqual(valid, q%validity, s%name//' in N-m-Pa')
               call assertRelativelyEqual(p%w1, 1.0e3_wp*q%w1, 1.0e-14_wp)
               ! one of them forgotten
               call refused(s%eta, 1.0e6_wp*m%modulus, 1.0e-3_wp*s%radius, 1.0e6_wp*m%hardness, &
                  1.0e-3_wp*s%sigma, 'eta*radius*sigma')
            end associate
         end do
      end do
   end subroutine test_si

   !> Just inside of each edge nothing is said; just outside it is refused, and flagged if accepted.
   subroutine test_edges()
      real(wp), parameter :: inside(2) = [1.0_wp + 1.0e-12_wp, 1.0_wp - 1.0e-12_wp]
      integer :: i, j

      call assertEqual('15.8', to_text(roughness_number_max, 3), 'a thousand times the least')
      call assertEqual([1.0e-7_wp, 1.0e-7_wp, roughness_number_min, 0.0_wp, 0.1_wp, 1.0e-4_wp], &
         ranges%lowest, 0.0_wp, 'lowest')
      call assertEqual([5.0_wp, 1.0e4_wp, roughness_number_max, 1.3e6_wp, 1.5e5_wp, 1.0_wp], &
         ranges%highest, 0.0_wp, 'highest')
      do i = 1, size(ranges)
         do j = 1, 2
            associate (edge => merge(ranges(i)%lowest, ranges(i)%highest, j == 1))
               if (.not. edge > 0.0_wp) cycle
               call build(i, edge*inside(j), .false.)
               call build(i, edge*inside(3 - j), .true.)
            end associate
         end do
      end do
   end subroutine test_edges

   !> Properties of which one, or the ratio or product, has a value, and all others are usual.
   subroutine build(which, value, is_refused)
      integer, intent(in) :: which
      real(wp), intent(in) :: value
      logical, intent(in) :: is_refused
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      real(wp) :: number, modulus, radius, hardness, sigma
      integer :: flag

      number = 0.1_wp
      radius = 0.1_wp
      sigma = 0.05_wp
      modulus = 300.0_wp
      hardness = 25.0_wp
      flag = implausible_property
      select case (trim(ranges(which)%name))
      case ('sigma')
         sigma = value
      case ('radius')
         radius = value
      case ('eta*radius*sigma')
         number = value
         flag = merge(roughness_number_low, roughness_number_high, value < 1.0_wp)
      case ('modulus')
         modulus = value
         hardness = 1.0e4_wp
      case ('hardness')
         hardness = value
         modulus = 5.0_wp*value
      case ('hardness/modulus')
         modulus = hardness/value
      case default
         call assertTrue(.false., 'no edge is tested of '//ranges(which)%name)
      end select
      call new_normal_properties(p, number/(radius*sigma), modulus, radius, hardness, 0.4_wp, &
         sigma, error)
      call assertTrue(allocated(error) .eqv. is_refused, ranges(which)%name//' = '//to_text(value))
      call new_normal_properties(p, number/(radius*sigma), modulus, radius, hardness, 0.4_wp, &
         sigma, error, accept_unphysical=.true.)
      call assertFalse(allocated(error), 'accepted')
      if (is_refused) call assertEqual(flag, p%validity, ranges(which)%name//' flagged')
      if (.not. is_refused .and. flag == implausible_property) &
         call assertEqual(valid, p%validity, ranges(which)%name//' valid')
   end subroutine build

end module test_law_plausibility
