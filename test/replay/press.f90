!> The press replay against the law itself.
module test_replay_press
   use asperity, only: contact_properties, error_type, evaluate_normal_law, normal_response, &
      rule_abaqus, wp
   use asperity_replay_press, only: default_peak, press_loop, press_settings, press_step, &
      run_press
   use contact_cases, only: pair_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_press

contains

   function suite_press() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('press')
      call suite%addTest(TestMethod('pressure ramp', test_pressure_ramp))
      call suite%addTest(TestMethod('overclosure ramp', test_overclosure_ramp))
      call suite%addTest(TestMethod('stages of Fig. 17', test_stages))
      call suite%addTest(TestMethod('settings that are refused', test_refused))
      call suite%addTest(TestMethod('limits of the peak', test_peaks))
   end function suite_press

   !> Up and down in equal steps; the law is reversible, so both ways give the same closure.
   subroutine test_pressure_ramp()
      type(contact_properties) :: p
      type(press_settings) :: settings
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error
      type(normal_response) :: law
      integer :: i, n

      p = pair_properties()
      n = 20
      settings%increments = n
      settings%step_time = 2.0_wp
      call run_press(settings, p, steps, loops, error)
      call assertFalse(allocated(error), 'runs')
      call assertEqual(2*n + 1, size(steps), 'steps')
      do i = 1, n - 1
         call assertEqual(default_peak*i/n, steps(1 + i)%pressure, 1.0e-11_wp, 'pressure')
         call assertEqual(0.1_wp*i, steps(1 + i)%time, 1.0e-13_wp, 'time')
         call assertEqual(steps(1 + i)%overclosure, steps(2*n + 1 - i)%overclosure, 1.0e-14_wp, &
            'reversible')
         law = evaluate_normal_law(p%normal, p%initial_separation - steps(1 + i)%overclosure)
         call assertEqual(law%pressure, steps(1 + i)%pressure, 0.0_wp, 'law')
         call assertEqual(law%stiffness, steps(1 + i)%stiffness, 0.0_wp, 'stiffness')
         call assertEqual(law%energy, steps(1 + i)%energy, 0.0_wp, 'energy')
         call assertEqual([law%area_fraction, law%contact_density, law%elastic_share, &
            law%elastoplastic_share, law%plastic_share], [steps(1 + i)%area_fraction, &
            steps(1 + i)%contact_density, steps(1 + i)%elastic_share, &
            steps(1 + i)%elastoplastic_share, steps(1 + i)%plastic_share], 0.0_wp, 'the rest')
         call assertEqual(law%validity, steps(1 + i)%validity, 'validity')
         call assertEqual(1.0_wp, steps(1 + i)%elastic_share + steps(1 + i)%elastoplastic_share &
            + steps(1 + i)%plastic_share, 1.0e-14_wp, 'shares')
         if (anyExceptions()) return
      end do
      call assertLessThan(steps(1)%pressure, p%p_open, 'starts open')
      call assertLessThan(steps(2*n + 1)%pressure, p%p_open, 'ends open')
   end subroutine test_pressure_ramp

   subroutine test_overclosure_ramp()
      type(contact_properties) :: p
      type(press_settings) :: settings
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error
      integer :: i

      p = pair_properties(rule_abaqus, pair='tangential-tangential')
      settings = press_settings('overclosure', [0.1_wp], 10, 1.0_wp)
      call run_press(settings, p, steps, loops, error)
      call assertFalse(allocated(error), 'runs')
      do i = 0, 20
         call assertEqual(0.1_wp - 0.01_wp*abs(10 - i), steps(i + 1)%overclosure, 1.0e-15_wp, &
            'overclosure')
      end do
   end subroutine test_overclosure_ramp

   !> For wood the elasto-plastic stage carries nearly all; the plastic share grows with pressure.
   subroutine test_stages()
      type(press_settings) :: settings
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error
      integer :: i

      call run_press(settings, pair_properties(), steps, loops, error)
      do i = 3, 51
         call assertTrue(steps(i)%plastic_share > steps(i - 1)%plastic_share, 'plastic grows')
         call assertLessThan(steps(i)%elastic_share, 1.0e-3_wp, 'elastic is below 0.1 %')
         if (anyExceptions()) return
      end do
   end subroutine test_stages

   subroutine test_refused()
      type(press_settings) :: without

      allocate (without%peak(0))
      call expect(without, 'peak is empty')
      call expect(press_settings(control='force'), 'control = ''force''')
      call expect(press_settings(peak=[-1.0_wp]), 'peak = -1.0')
      call expect(press_settings(peak=[1.0_wp, 0.0_wp]), 'peak = 0.0')
      call expect(press_settings(increments=0), 'increments = 0')
      call expect(press_settings(increments=2000000), 'increments = 2000000')
      call expect(press_settings(step_time=0.0_wp), 'step_time = 0.0')
      call expect(press_settings('overclosure', [1.0e15_wp], 1, accept_sizes=.true.), &
         'UINTER cannot compute')
      call expect(press_settings('overclosure', [140.0_wp]), 'peak = 140.0 mm is outside')
      call expect(press_settings('overclosure', [1.4e-4_wp]), 'peak = 0.00014 mm is outside')
      call expect(press_settings(peak=[4.7e6_wp]), 'peak = 4700000.0 MPa is outside')
   end subroutine test_refused

   !> A peak is from 5e-4 to 10 of the hardness, or from 0.013 sigma to 8 sigma past the datum.
   subroutine test_peaks()
      type(contact_properties) :: p

      p = pair_properties()
      associate (h => p%normal%hardness, s => p%normal%sigma, d => p%initial_separation)
         call check('pressure', 5.0e-4_wp*h, -1.0_wp)
         call check('pressure', 10.0_wp*h, 1.0_wp)
         call check('overclosure', 0.013_wp*s, -1.0_wp)
         call check('overclosure', d + 8.0_wp*s, 1.0_wp)
      end associate
   contains
      !> The limit is not refused as a size, the number next to it is, unless it is accepted.
      subroutine check(control, limit, side)
         character(len=*), intent(in) :: control
         real(wp), intent(in) :: limit, side

         call assertFalse(is_outside(press_settings(control, [limit], 1)), control//' at its limit')
         call assertTrue(is_outside(press_settings(control, [nearest(limit, side)], 1)), &
            control//' beyond its limit')
         call assertFalse(is_outside(press_settings(control, [nearest(limit, side)], 1, &
            accept_sizes=.true.)), control//' accepted')
      end subroutine check

      logical function is_outside(settings)
         type(press_settings), intent(in) :: settings
         type(press_step), allocatable :: steps(:)
         type(press_loop), allocatable :: loops(:)
         type(error_type), allocatable :: error

         call run_press(settings, p, steps, loops, error)
         is_outside = allocated(error)
         if (is_outside) is_outside = index(error%message, ' is outside ') > 0
      end function is_outside
   end subroutine test_peaks

   subroutine expect(settings, text)
      type(press_settings), intent(in) :: settings
      character(len=*), intent(in) :: text
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error

      call run_press(settings, pair_properties(), steps, loops, error)
      call assertTrue(allocated(error), text)
      if (.not. allocated(error)) return
      call assertEqual(1, index(error%message, text), error%message)
      call assertTrue(fits_subject(error), error%message)
   end subroutine expect

end module test_replay_press
