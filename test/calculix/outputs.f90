!> What a poisoned call of UINTER tells.
module test_calculix_outputs
   use asperity_base_kinds, only: wp
   use asperity_calculix_outputs, only: new_outputs, note_optional, optional_left, outputs_type, &
      unset_outputs
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_outputs

   !> Stresses before the two calls
   real(wp), parameter :: start(3, 2) = reshape([0.5_wp, 0.1_wp, 0.2_wp, 0.6_wp, 0.3_wp, 0.4_wp], &
      [3, 2])
   real(wp), parameter :: moved(3) = [0.1_wp, 0.1_wp, 0.1_wp]

contains

   function suite_outputs() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('outputs of UINTER')
      call suite%addTest(TestMethod('what must be set', test_required))
      call suite%addTest(TestMethod('what may be set', test_optional))
   end function suite_outputs

   subroutine test_required()
      type(outputs_type) :: a, b

      a = new_outputs(start(:, 1), poisoned=.true.)
      b = new_outputs(start(:, 2), poisoned=.true.)
      call assertEqual(' STRESS(1) STRESS(2) STRESS(3) DDSDDR(1,1) DDSDDR(1,2) DDSDDR(1,3) '// &
         'DDSDDR(2,1) DDSDDR(2,2) DDSDDR(2,3) DDSDDR(3,1) DDSDDR(3,2) DDSDDR(3,3)', &
         trim(unset_outputs(a, b, start, moved)), 'nothing set')
      a%ddsddr = 0.0_wp
      b%ddsddr = 0.0_wp
      call assertEqual(' STRESS(2)', trim(unset_outputs(a, b, start, [0.0_wp, 0.1_wp, 0.0_wp])), &
         'a stress stays as it is where nothing moved')
      ! one that adds to the stress, one that comes out the same by chance, one that is not set
      a%stress = start(:, 1) + [0.1_wp, 0.0_wp, 0.0_wp]
      b%stress = [start(1, 2) + 0.1_wp, start(2, 1), start(3, 2)]
      call assertEqual(' STRESS(3)', trim(unset_outputs(a, b, start, moved)), 'set but the third')
      a = new_outputs(start(:, 1), poisoned=.false.)
      call assertEqual(0.0_wp, sum(abs(a%ddsddr)) + a%sfd, 0.0_wp, 'zero unless poisoned')
   end subroutine test_required

   subroutine test_optional()
      type(outputs_type) :: a

      call assertEqual('', trim(optional_left()), 'none yet')
      a = new_outputs(start(:, 1), poisoned=.true.)
      a%dviscous = 0.0_wp
      a%dstructural = 0.0_wp
      a%ddfddt = 0.0_wp
      a%ddsddt(:2, :) = 0.0_wp
      a%ddfddr = 0.0_wp
      a%sfd = 0.25_wp
      a%svd = 0.0_wp
      call note_optional(a)
      call assertEqual(' DDSDDT SPD SCD', trim(optional_left()), 'those that some call left')
      call assertTrue(a%sfd + a%spd + a%scd - 0.25_wp <= 0.0_wp, 'they count as zero')
   end subroutine test_optional

end module test_calculix_outputs
