!> Remarks on the analyses of a solid, each at its limit.
module test_program_solid_remarks
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_loops, only: hard, rough
   use asperity_program_commands_joint_remarks, only: analysis_remarks
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_system_strings, only: string_type
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use made_outcomes, only: made_outcome
   implicit none
   private
   public :: suite_remarks

contains

   function suite_remarks() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('remarks')
      call suite%addTest(TestMethod('none', test_none))
      call suite%addTest(TestMethod('no moment', test_no_moment))
      call suite%addTest(TestMethod('large strain', test_strain))
      call suite%addTest(TestMethod('work that is not accounted for', test_balance))
      call suite%addTest(TestMethod('multigrid that failed', test_multigrid))
      call suite%addTest(TestMethod('of each model', test_models))
   end function suite_remarks

   !> Not a function: gfortran 12 frees what one returns for a polymorphic argument twice
   subroutine make(outcomes)
      type(solid_outcome), intent(out) :: outcomes(1)

      outcomes(1) = made_outcome(rough, 1.0_wp)
      outcomes(1)%has_moment = .true.
   end subroutine make

   !> The remarks are one with these words, or none where there are none.
   subroutine assert_said(outcomes, words)
      type(solid_outcome), intent(in) :: outcomes(:)
      character(len=*), intent(in) :: words
      type(string_type), allocatable :: lines(:)

      allocate (lines, source=analysis_remarks(outcomes))
      call assertEqual(merge(0, 1, words == ''), size(lines), words)
      if (size(lines) == 1) call assertEqual(words, lines(1)%text)
   end subroutine assert_said

   subroutine test_none()
      type(solid_outcome) :: outcomes(1)

      call make(outcomes)
      call assert_said(outcomes, '')
   end subroutine test_none

   subroutine test_no_moment()
      type(solid_outcome) :: outcomes(1)

      call make(outcomes)
      outcomes(1)%has_moment = .false.
      call assert_said(outcomes, 'rough law: there is no moment in any increment')
   end subroutine test_no_moment

   subroutine test_strain()
      type(solid_outcome) :: outcomes(1)

      call make(outcomes)
      associate (last => outcomes(1)%records(size(outcomes(1)%records)))
         last%plastic_strain = 0.2_wp
         call assert_said(outcomes, '')
         last%plastic_strain = nearest(0.2_wp, 1.0_wp)
         call assert_said(outcomes, 'rough law: the wood''s plastic strain reaches 0.20, which '// &
            'is past small strains: strain = logarithmic bears it; a smaller mesh_size raises it')
         outcomes(1)%is_logarithmic = .true.
         call assert_said(outcomes, '')
      end associate
   end subroutine test_strain

   subroutine test_balance()
      type(solid_outcome) :: outcomes(1)

      call make(outcomes)
      associate (last => outcomes(1)%records(size(outcomes(1)%records)))
         last%work = 200.0_wp
         last%balance = -2.0_wp
         call assert_said(outcomes, '')
         last%balance = -2.01_wp
         call assert_said(outcomes, 'rough law: -2.01 of 200.0 J of work are not '// &
            'accounted for; larger stroke_increments leave less')
      end associate
   end subroutine test_balance

   subroutine test_multigrid()
      type(solid_outcome) :: outcomes(1)

      call make(outcomes)
      outcomes(1)%multigrid_failures = 2
      call assert_said(outcomes, 'rough law: multigrid did not converge (2); factors took its '// &
         'place until contact met other faces, with the memory of preconditioner = lu')
   end subroutine test_multigrid

   subroutine test_models()
      type(solid_outcome) :: outcomes(2)
      type(string_type), allocatable :: lines(:)

      outcomes(hard) = made_outcome(hard, 1.0_wp)
      outcomes(rough) = made_outcome(rough, 1.0_wp)
      outcomes%has_moment = .false.
      allocate (lines, source=analysis_remarks(outcomes))
      call assertEqual(2, size(lines))
      call assertTrue(index(lines(hard)%text, 'hard contact: ') == 1)
      call assertTrue(index(lines(rough)%text, 'rough law: ') == 1)
   end subroutine test_models

end module test_program_solid_remarks
