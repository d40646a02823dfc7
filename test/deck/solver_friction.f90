!> Friction beyond one coefficient as ABAQUS has it, and what no solver's own friction can be.
module test_deck_solver_friction
   use asperity, only: contact_properties, error_type, friction_settings, &
      slip_direction_of_stress, stick_summits, wp
   use asperity_deck_solver_friction, only: check_solver_friction, friction_parameters, &
      friction_rows
   use friction_cases, only: friction_properties
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_solver_friction

contains

   function suite_solver_friction() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('solver friction')
      call suite%addTest(TestMethod('cards of ABAQUS', test_cards))
      call suite%addTest(TestMethod('a power in rows', test_power))
      call suite%addTest(TestMethod('what solvers cannot', test_refused))
   end function suite_solver_friction

   subroutine test_cards()
      type(friction_settings) :: points

      call check(friction_settings(), '', [0.5_wp], 1)
      call check(friction_settings(static_friction_coefficient=0.6_wp, decay_slip_rate=4.0_wp), &
         ', EXPONENTIAL DECAY', [0.6_wp, 0.5_wp, 0.25_wp], 1)
      call check(friction_settings(shear_limit=2.5_wp), ', TAUMAX=2.5', [0.5_wp], 1)
      points = friction_settings(friction_points=2, friction_coefficient_across=0.2_wp)
      points%friction_pressures(:2) = [1.0_wp, 2.0_wp]
      points%friction_factors(:2) = [1.0_wp, 0.5_wp]
      call check(points, ', ANISOTROPIC', [0.25_wp, 0.1_wp, 0.0_wp, 2.0_wp], 2)
   end subroutine test_cards

   !> The words, the last row, and how many rows.
   subroutine check(settings, words, last, n)
      type(friction_settings), intent(in) :: settings
      character(len=*), intent(in) :: words
      real(wp), intent(in) :: last(:)
      integer, intent(in) :: n
      type(contact_properties) :: p
      type(error_type), allocatable :: error

      p = friction_properties(settings)
      call check_solver_friction(p, .false., error)
      call assertFalse(allocated(error), 'taken')
      call assertEqual(words, friction_parameters(p), 'card')
      associate (rows => friction_rows(p))
         call assertEqual(n, size(rows, 1), 'rows')
         call assertEqual(size(last), size(rows, 2), 'columns')
         call assertEqual(last, rows(n, :), 1.0e-15_wp, 'last row')
      end associate
   end subroutine check

   !> Half way between rows the straight line is within 0.3 % of the power.
   subroutine test_power()
      type(contact_properties) :: p
      real(wp) :: worst, middle
      integer :: i

      p = friction_properties(friction_settings(pressure_exponent=-0.3_wp, &
         reference_pressure=2.0_wp))
      worst = 0.0_wp
      associate (rows => friction_rows(p))
         call assertEqual(p%normal%hardness, rows(size(rows, 1), 3), 1.0e-12_wp, 'up to H')
         do i = 2, size(rows, 1)
            middle = 0.5_wp*(rows(i, 3) + rows(i - 1, 3))
            worst = max(worst, abs(0.5_wp*(rows(i, 1) + rows(i - 1, 1)) &
               /(0.5_wp*(middle/2.0_wp)**(-0.3_wp)) - 1.0_wp))
         end do
      end associate
      call assertLessThan(worst, 0.003_wp, 'straight lines')
   end subroutine test_power

   subroutine test_refused()
      call refused(friction_settings(shear_limit=1.0_wp), .true., 'has one coefficient')
      call refused(friction_settings(stick=stick_summits, shear_modulus=30.0_wp), .false., &
         'stick = summits')
      call refused(friction_settings(static_friction_coefficient=0.6_wp, decay_slip=1.0_wp), &
         .false., 'decay_slip = 1.0 mm')
      call refused(friction_settings(static_friction_coefficient=0.6_wp, decay_slip_rate=1.0_wp, &
         friction_coefficient_across=0.2_wp), .false., 'in all directions')
      call refused(friction_settings(friction_coefficient_across=0.2_wp, grain_angle=30.0_wp), &
         .false., 'grain_angle = 30.0 degrees')
      call refused(friction_settings(static_friction_coefficient=0.6_wp, decay_slip_rate=1.0_wp, &
         shear_limit=2.5_wp), .false., 'shear_limit = 2.5 MPa')
      call refused(friction_settings(friction_coefficient_across=0.2_wp, shear_limit=2.5_wp), &
         .false., 'shear_limit = 2.5 MPa')
      call refused(friction_settings(static_friction_coefficient=0.5_wp), .false., &
         'needs decay_slip_rate')
      call refused(friction_settings(friction_coefficient_across=0.2_wp, &
         slip_direction=slip_direction_of_stress), .false., 'slip_direction = stress')
   end subroutine test_refused

   subroutine refused(settings, is_calculix, text)
      type(friction_settings), intent(in) :: settings
      logical, intent(in) :: is_calculix
      character(len=*), intent(in) :: text
      type(error_type), allocatable :: error

      call check_solver_friction(friction_properties(settings), is_calculix, error)
      call assertTrue(allocated(error), 'refused')
      if (allocated(error)) call assertTrue(index(error%message, text) > 0, error%message)
   end subroutine refused

end module test_deck_solver_friction
