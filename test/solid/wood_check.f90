!> Wood that is refused, with the name of the key, and wood just inside each limit.
module test_solid_wood_check
   use asperity, only: wp
   use asperity_base_error, only: error_type
   use asperity_solid_material_material, only: new_solid_material, solid_material
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_wood_check

   character(len=1), parameter :: directions(3) = ['l', 'r', 't']
   character(len=2), parameter :: planes(3) = ['lr', 'lt', 'rt']

contains

   function suite_wood_check() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('wood that can be')
      call suite%addTest(TestMethod('stresses above zero', test_positive))
      call suite%addTest(TestMethod('Poisson''s ratios', test_ratios))
      call suite%addTest(TestMethod('criterion', test_criterion))
      call suite%addTest(TestMethod('hardening', test_hardening))
      call suite%addTest(TestMethod('what messages say', test_messages))
   end function suite_wood_check

   !> The wood is refused, as the key's.
   subroutine refuse(wood, key)
      type(wood_properties), intent(in) :: wood
      character(len=*), intent(in) :: key
      type(error_type), allocatable :: error
      type(solid_material) :: material

      call check_wood_properties(wood, error)
      call assertTrue(allocated(error), key)
      if (.not. allocated(error)) return
      call assertEqual(key, error%subject(:min(len(key), len(error%subject))))
      call assertTrue(fits_subject(error), key)
      deallocate (error)
      call new_solid_material(material, wood, 1, 2, .false., error)
      call assertTrue(allocated(error), key)
   end subroutine refuse

   subroutine accept(wood)
      type(wood_properties), intent(in) :: wood
      type(error_type), allocatable :: error

      call check_wood_properties(wood, error)
      if (allocated(error)) call assertEqual('', error%message)
      call assertFalse(allocated(error))
   end subroutine accept

   !> Each of twelve stresses and moduli.
   subroutine test_positive()
      type(wood_properties) :: wood, wrong
      real(wp), parameter :: refused(2) = [0.0_wp, -1.0_wp]
      integer :: i, k

      call accept(wood)
      do k = 1, 2
         do i = 1, 3
            wrong = wood
            wrong%young_moduli(i) = refused(k)
            call refuse(wrong, 'young_modulus_'//directions(i))
            wrong = wood
            wrong%shear_moduli(i) = refused(k)
            call refuse(wrong, 'shear_modulus_'//planes(i))
            wrong = wood
            wrong%compression_strengths(i) = refused(k)
            call refuse(wrong, 'compression_strength_'//directions(i))
            wrong = wood
            wrong%tension_strengths(i) = refused(k)
            call refuse(wrong, 'tension_strength_'//directions(i))
            wrong = wood
            wrong%shear_strengths(i) = refused(k)
            call refuse(wrong, 'shear_strength_'//planes(i))
         end do
      end do
   end subroutine test_positive

   !> The compliance is positive definite: each ratio below the root of the moduli's, and all
   !> together, for equal moduli and ratios nu > -1 and nu < 1/2.
   subroutine test_ratios()
      type(wood_properties) :: wood

      wood%young_moduli = [400.0_wp, 100.0_wp, 25.0_wp]
      wood%poisson_ratios = [1.999_wp, 0.0_wp, 0.0_wp]
      call accept(wood)
      wood%poisson_ratios = [2.001_wp, 0.0_wp, 0.0_wp]
      call refuse(wood, 'poisson_ratio_lr')
      wood%poisson_ratios = [0.0_wp, -3.999_wp, 0.0_wp]
      call accept(wood)
      wood%poisson_ratios = [0.0_wp, -4.001_wp, 0.0_wp]
      call refuse(wood, 'poisson_ratio_lt')
      wood%poisson_ratios = [0.0_wp, 0.0_wp, 1.999_wp]
      call accept(wood)
      wood%poisson_ratios = [0.0_wp, 0.0_wp, 2.001_wp]
      call refuse(wood, 'poisson_ratio_rt')
      wood%young_moduli = 100.0_wp
      wood%poisson_ratios = 0.499_wp
      call accept(wood)
      wood%poisson_ratios = 0.501_wp
      call refuse(wood, 'poisson_ratio_lr poisson_ratio_lt poisson_ratio_rt')
      wood%poisson_ratios = -0.999_wp
      call accept(wood)
   end subroutine test_ratios

   !> Hill needs 1/fc of each direction below the sum of the other two.
   subroutine test_criterion()
      type(wood_properties) :: wood

      wood%compression_strengths = 1.0_wp/[1.0_wp, 2.0_wp, 2.99_wp]
      wood%criterion = 'hill'
      call accept(wood)
      wood%compression_strengths = 1.0_wp/[1.0_wp, 2.0_wp, 3.01_wp]
      call refuse(wood, 'compression_strength_l compression_strength_r')
      wood%criterion = 'crushing'
      call accept(wood)
      wood%criterion = 'mises'
      call accept(wood)
      wood%criterion = 'none'
      call accept(wood)
      wood%criterion = 'tresca'
      call refuse(wood, 'criterion')
   end subroutine test_criterion

   subroutine test_hardening()
      type(wood_properties) :: wood, wrong

      wrong = wood
      wrong%hardening_along = -0.01_wp
      call refuse(wrong, 'hardening_along')
      wrong = wood
      wrong%hardening_across = -0.01_wp
      call refuse(wrong, 'hardening_across')
      wood%hardening_along = 0.0_wp
      wood%hardening_across = 0.0_wp
      call accept(wood)

      call accept(with_curve(wood, [0.0_wp, 4.7_wp]))
      call accept(with_curve(wood, [0.0_wp, 4.7_wp, 0.1_wp, 4.7_wp, 0.2_wp, 9.0_wp]))
      ! not from the strength on, not from zero on, strains that stay, stresses that fall
      call refuse(with_curve(wood, [0.0_wp, 4.8_wp]), 'hardening_curve')
      call refuse(with_curve(wood, [0.01_wp, 4.7_wp]), 'hardening_curve')
      call refuse(with_curve(wood, [0.0_wp, 4.7_wp, 0.0_wp, 5.0_wp]), 'hardening_curve')
      call refuse(with_curve(wood, [0.0_wp, 4.7_wp, 0.1_wp, 5.0_wp, 0.2_wp, 4.9_wp]), &
         'hardening_curve')
      call refuse(with_curve(wood, [0.0_wp, 4.7_wp, -0.1_wp, 5.0_wp]), 'hardening_curve')
      call refuse(with_curve(wood, [0.0_wp, 4.7_wp, 0.1_wp, 0.0_wp]), 'hardening_curve')
      wood%hardening_curve = reshape([real(wp) ::], [2, 0])
      call refuse(wood, 'hardening_curve')
      wood%hardening_curve = reshape([0.0_wp], [1, 1])
      call refuse(wood, 'hardening_curve')
   end subroutine test_hardening

   !> Messages that name several values.
   subroutine test_messages()
      type(wood_properties) :: wood

      wood%young_moduli = [120.0_wp, 110.0_wp, 100.0_wp]
      wood%poisson_ratios = [0.6_wp, 0.7_wp, 0.8_wp]
      call say(wood, 'poisson_ratio_lr = 0.6, poisson_ratio_lt = 0.7 and poisson_ratio_rt = '// &
         '0.8 do not go together with Young''s moduli of 120.0, 110.0 and 100.0 MPa: the wood '// &
         'would give energy when it is deformed; take smaller ratios')
      wood = wood_properties(criterion='hill', compression_strengths=[9.0_wp, 1.0_wp, 3.0_wp])
      call say(wood, 'compression_strength_l = 9.0, compression_strength_r = 1.0 and '// &
         'compression_strength_t = 3.0 MPa are not allowed with criterion = ''hill'', which '// &
         'needs each of 1/strength below the sum of the other two; take strengths closer to '// &
         'each other, or criterion = ''crushing''')
      wood = wood_properties(criterion='tresca')
      call say(wood, 'criterion = ''tresca'' is unknown: it must be one of none, mises, hill, '// &
         'crushing')
      wood = wood_properties()
      call say(with_curve(wood, [0.01_wp, 5.0_wp]), 'hardening_curve begins at a plastic '// &
         'strain of 0.01 and 5.0 MPa: it must begin at 0 and '// &
         'compression_strength_r = 4.7 MPa')
      call say(with_curve(wood, [0.0_wp, 4.7_wp, 0.1_wp, 5.0_wp, 0.2_wp, 4.9_wp]), &
         'hardening_curve goes from 5.0 MPa at a plastic strain of 0.1 to 4.9 MPa at 0.2: '// &
         'strains must rise, and stresses must not fall')
      call say(with_curve(wood, [0.0_wp, 4.7_wp, -0.1_wp, 5.0_wp]), 'hardening_curve = -0.1 is '// &
         'not allowed: it must be a number between 0.0 and 1000.0')
   end subroutine test_messages

   subroutine say(wood, message)
      type(wood_properties), intent(in) :: wood
      character(len=*), intent(in) :: message
      type(error_type), allocatable :: error

      call check_wood_properties(wood, error)
      call assertTrue(allocated(error), message)
      if (allocated(error)) call assertEqual(message, error%message)
   end subroutine say

   !> Wood with points of a curve: strain, stress, strain, stress.
   function with_curve(wood, points) result(changed)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: points(:)
      type(wood_properties) :: changed

      changed = wood
      changed%hardening_curve = reshape(points, [2, size(points)/2])
   end function with_curve

end module test_solid_wood_check
