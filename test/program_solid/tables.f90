!> Tables of the solid joint, against the formulas that the joint is made of.
module test_program_solid_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_program_commands_joint_face_rows, only: face_table
   use asperity_program_commands_joint_loops, only: hard, rough
   use asperity_program_commands_joint_tables, only: comparison_table, cycles_table
   use asperity_program_commands_solid_face_rows, only: solid_face_rows
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_commands_solid_snapshot, only: lower_peak, lower_unloaded, upper_peak
   use asperity_program_commands_solid_tables, only: amplitudes_table, increments_table, &
      totals_table
   use asperity_program_report_table, only: table_type
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use made_outcomes, only: arm, friction, increment, made_force, made_outcome, made_snapshot, &
      spring
   implicit none
   private
   public :: suite_tables

   !> Round-off of sums over some hundred increments
   real(wp), parameter :: round_off = 1.0e-10_wp
   !> The rough law's forces over those of hard contact
   real(wp), parameter :: share = 1.25_wp

contains

   function suite_tables() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tables')
      call suite%addTest(TestMethod('beside Table 5', test_comparison))
      call suite%addTest(TestMethod('one model alone', test_alone))
      call suite%addTest(TestMethod('first cycle of each amplitude', test_amplitudes))
      call suite%addTest(TestMethod('increments', test_increments))
      call suite%addTest(TestMethod('totals', test_totals))
      call suite%addTest(TestMethod('rows by face', test_faces))
   end function suite_tables

   !> Not a function: gfortran 12 frees what one returns for a polymorphic argument twice
   subroutine make_both(outcomes)
      type(solid_outcome), intent(out) :: outcomes(2)

      outcomes(hard) = made_outcome(hard, 1.0_wp)
      outcomes(rough) = made_outcome(rough, share)
   end subroutine make_both

   !> Value of a column in a row.
   real(wp) function value(table, name, row)
      type(table_type), intent(in) :: table
      character(len=*), intent(in) :: name
      integer, intent(in) :: row

      call assertTrue(table%find(name) > 0, name)
      value = table%columns(table%find(name))%values(row)
   end function value

   subroutine test_comparison()
      type(solid_outcome) :: outcomes(2)
      type(table_type) :: table
      real(wp) :: moment

      call make_both(outcomes)
      table = comparison_table(outcomes, .true.)
      call assertEqual(5, table%rows)
      call assertEqual('rough law, this model', table%columns(1)%cell(5))
      ! at -24 mm, kN m, and over 24/500 rad
      moment = -1.0e-6_wp*arm*(24.0_wp*spring + friction)
      call assertEqual(moment, value(table, 'ultimate_moment', 4), round_off)
      call assertEqual(share*moment, value(table, 'ultimate_moment', 5), round_off)
      call assertEqual(-moment*arm/24.0_wp, value(table, 'bending_stiffness', 4), round_off)
      call assertEqual(share, value(table, 'ultimate_to_hard', 5), round_off)
      call assertEqual(share, value(table, 'yield_to_hard', 5), round_off)
      call assertEqual(1.0_wp, value(table, 'stiffness_to_hard', 4), 0.0_wp)
      ! the paper's +10.8 %
      call assertEqual(19.84_wp/17.91_wp, value(table, 'ultimate_to_hard', 3), round_off)
      table = comparison_table(outcomes, .false.)
      call assertEqual(2, table%rows)
   end subroutine test_comparison

   subroutine test_alone()
      type(solid_outcome) :: outcomes(2)
      type(table_type) :: table

      call make_both(outcomes)
      table = comparison_table(outcomes(rough:), .true.)
      call assertEqual(4, table%rows)
      call assertTrue(is_none(value(table, 'ultimate_to_hard', 4)))
      table = cycles_table(outcomes(rough:))
      call assertEqual(4, table%rows)
      call assertEqual(9, table%set)
      call assertEqual(24.0_wp/arm, value(table, 'drift', 3), round_off)
      table = amplitudes_table(outcomes(rough:))
      call assertEqual(6, table%set)
      ! of a record that is the same on both sides
      call assertEqual(value(table, 'secant_stiffness_rough', 2), &
         value(table, 'mean_secant_stiffness_rough', 2), &
         round_off*value(table, 'secant_stiffness_rough', 2))
      call assertEqual(0, table%find('energy_to_hard'))
   end subroutine test_alone

   !> Energy by the trapezoidal rule between the zeros that a cycle begins and ends at.
   subroutine test_amplitudes()
      type(solid_outcome) :: outcomes(2)
      type(table_type) :: table
      real(wp), allocatable :: x(:), f(:)
      real(wp) :: work
      integer :: i, first, last

      call make_both(outcomes)
      table = amplitudes_table(outcomes)
      call assertEqual(2, table%rows)
      call assertEqual(8.0_wp, value(table, 'amplitude', 1), round_off)
      call assertEqual(24.0_wp, value(table, 'amplitude', 2), round_off)
      call assertEqual(1.0e-3_wp*(24.0_wp*spring + friction), &
         value(table, 'positive_force_hard', 2), round_off)
      call assertEqual(-1.0e-3_wp*share*(8.0_wp*spring + friction), &
         value(table, 'negative_force_rough', 1), round_off)
      call assertEqual(share, value(table, 'energy_to_hard', 2), round_off)

      call made_force(1.0_wp, x, f)
      ! up, down, and back to zero; two of them before
      first = nint((8 + 16 + 16 + 16 + 8)/increment)
      last = first + nint((24 + 48 + 24)/increment)
      work = 0.0_wp
      do i = first + 1, last
         work = work + 0.5e-3_wp*(f(i) + f(i - 1))*(x(i) - x(i - 1))
      end do
      call assertEqual(0.0_wp, x(first), round_off)
      call assertEqual(work, value(table, 'energy_hard', 2), 1.0e-8_wp)
   end subroutine test_amplitudes

   subroutine test_increments()
      type(table_type) :: table
      type(solid_outcome) :: outcomes(2)
      integer :: n

      call make_both(outcomes)
      n = size(outcomes(hard)%records)
      table = increments_table(outcomes, has_memory=.false.)
      call assertEqual(2*n, table%rows)
      call assertEqual(size(table%columns), table%set)
      call assertEqual('rough', table%columns(1)%cell(n + 1))
      call assertEqual('1', table%columns(2)%cell(n + 1))
      ! 8 mm, the end of the first stroke
      associate (row => n + nint(8.0_wp/increment))
         call assertEqual(8.0_wp, value(table, 'displacement', row), round_off)
         call assertEqual(8.0_wp/arm, value(table, 'drift', row), round_off)
         call assertEqual(0.6_wp*8.0_wp/arm, value(table, 'rotation', row), round_off)
         call assertEqual(1.0e-6_wp*arm*value(table, 'force', row), &
            value(table, 'moment', row), round_off)
         call assertEqual(share*(8.0_wp*spring + friction), value(table, 'normal_upper', row), &
            1.0e-8_wp)
      end associate
   end subroutine test_increments

   subroutine test_totals()
      type(table_type) :: table
      type(solid_outcome) :: outcomes(2)
      real(wp) :: n

      call make_both(outcomes)
      n = real(size(outcomes(hard)%records), wp)
      table = totals_table(outcomes, has_memory=.false.)
      call assertEqual(size(table%columns), table%set)
      call assertEqual(2.0_wp*n, value(table, 'work_of_load', 1), 0.0_wp)
      call assertEqual(share*n, value(table, 'friction_dissipation', 2), round_off)
      call assertEqual(2.0_wp*n, value(table, 'largest_pressure', 2), 0.0_wp)
      call assertEqual(1.5_wp*n, value(table, 'largest_mean_pressure', 2), 0.0_wp)
      call assertEqual(0.6_wp*24.0_wp/arm, value(table, 'largest_rotation', 1), round_off)
   end subroutine test_totals

   !> Only states that both models have kept; areas and forces are those of both halves.
   subroutine test_faces()
      type(table_type) :: table
      type(solid_outcome) :: outcomes(2)

      call make_both(outcomes)
      outcomes(hard)%snapshots = [made_snapshot(upper_peak, 24.0_wp, 2.0_wp), &
         made_snapshot(lower_peak, -24.0_wp, 4.0_wp)]
      outcomes(rough)%snapshots = [made_snapshot(lower_peak, -24.0_wp, 5.0_wp), &
         made_snapshot(lower_unloaded, -23.0_wp, 5.0_wp)]
      table = face_table(solid_face_rows(outcomes))
      call assertEqual(6, table%rows)
      call assertEqual('sides', table%columns(2)%cell(5))
      call assertEqual('rough', table%columns(3)%cell(2))
      call assertEqual(-24.0_wp, value(table, 'displacement', 2), 0.0_wp)
      call assertEqual(5.0_wp, value(table, 'largest_pressure', 2), 0.0_wp)
      call assertEqual(1.25_wp, value(table, 'pressure_to_hard', 2), round_off)
      call assertEqual(2.0_wp*0.5_wp*200.0_wp*5.0_wp, value(table, 'normal_force', 2), round_off)
      call assertEqual(2.0_wp*0.5_wp*200.0_wp, value(table, 'area_slip', 2), round_off)
      call assertEqual(2.0_wp*200.0_wp, value(table, 'area_open', 2), round_off)
      call assertEqual(2.0_wp*200.0_wp, value(table, 'area_stick', 5), round_off)
      ! the lower face has no cells here
      call assertEqual(0.0_wp, value(table, 'normal_force', 3), 0.0_wp)
      call assertTrue(is_none(value(table, 'force_to_hard', 4)))
   end subroutine test_faces

end module test_program_solid_tables
