!> Fits to records that a material of known numbers has made, and what a history takes of a record.
module test_frame_fit
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_frame_comparison, only: compare_material, frame_comparison, least_steps
   use asperity_frame_dowel_envelope, only: dowel_envelope
   use asperity_frame_dowel_type, only: dowel_type_material
   use asperity_frame_fit, only: fit_material
   use asperity_frame_history, only: frame_history, new_frame_history, path_along, skeleton_force
   use asperity_frame_pinching4, only: pinching4_material
   use asperity_hysteresis_analysis, only: analyse_hysteresis, hysteresis_result
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   implicit none
   private
   public :: suite_frame_fit

   !> Ends of half cycles, two of each larger amplitude; the first are elastic
   integer, parameter :: n_legs = 21
   real(wp), parameter :: ends(0:n_legs) = [0.0_wp, 0.5_wp, -0.5_wp, 1.0_wp, -1.0_wp, 2.0_wp, &
      -2.0_wp, 2.0_wp, -2.0_wp, 5.0_wp, -5.0_wp, 5.0_wp, -5.0_wp, 10.0_wp, -10.0_wp, 10.0_wp, &
      -10.0_wp, 15.0_wp, -15.0_wp, 15.0_wp, -15.0_wp, 0.0_wp]

contains

   function suite_frame_fit() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('frame fit')
      call suite%addTest(TestMethod('history of a bilinear record', test_history))
      call suite%addTest(TestMethod('back-slips are smoothed away', test_back_slip))
      call suite%addTest(TestMethod('DowelType found again', test_dowel))
      call suite%addTest(TestMethod('Pinching4 found again', test_pinching))
      call suite%addTest(TestMethod('a monotonic record is refused', test_monotonic))
   end function suite_frame_fit

   !> An elastic-plastic spring, stiffness 8, yield at 0.5: a loop to 2 and -2 has 4*4*1.5.
   subroutine test_history()
      real(wp), parameter :: x(*) = [0.0_wp, 0.5_wp, 2.0_wp, 1.0_wp, -2.0_wp, -1.0_wp, 2.0_wp, &
         1.0_wp, -2.0_wp, -1.0_wp, 0.0_wp]
      real(wp), parameter :: f(*) = [0.0_wp, 4.0_wp, 4.0_wp, -4.0_wp, -4.0_wp, 4.0_wp, 4.0_wp, &
         -4.0_wp, -4.0_wp, 4.0_wp, 4.0_wp]
      type(frame_history) :: history

      call make(history, x, f)
      call assertEqual([2.0_wp, -2.0_wp, 0.0_wp, 2.0_wp, -2.0_wp, 0.0_wp], history%ends(1:), &
         1.0e-14_wp, 'legs')
      call assertEqual([1, 1, 1, 2, 2, 2], history%cycle, 'cycles')
      call assertEqual(24.0_wp, history%energy(2), 1.0e-12_wp, 'energy of a closed loop')
      ! from 0 to 2 in equal steps: elastic for the first quarter
      call assertEqual(4.0_wp, history%force(history%steps/4), 1.0e-14_wp, 'force on the way')
      call assertEqual(2.0_wp, history%force(history%steps/8), 1.0e-14_wp, 'and before')
      call assertEqual(4.0_wp, skeleton_force(history, 1, 0.5_wp), 1.0e-14_wp, 'skeleton')
      call assertEqual(2.0_wp, skeleton_force(history, 1, 0.25_wp), 1.0e-14_wp, 'inside')
   end subroutine test_history

   !> A little way back changes neither legs nor, but for that, forces.
   subroutine test_back_slip()
      real(wp), parameter :: x(*) = [0.0_wp, 1.0_wp, 0.9_wp, 2.0_wp, 0.0_wp, -2.0_wp, 0.0_wp, &
         2.0_wp, 0.0_wp, -2.0_wp, 0.0_wp]
      type(frame_history) :: history

      call make(history, x, x)
      call assertEqual([2.0_wp, -2.0_wp, 0.0_wp], history%ends(1:3), 1.0e-14_wp, 'legs')
      call assertTrue(all(history%displacement(1:history%steps) &
         > history%displacement(0:history%steps - 1)), 'one way')
      call assertEqual(2.0_wp, history%force(history%steps), 1.0e-14_wp, 'force of the tip')
   end subroutine test_back_slip

   !> The history of a record.
   subroutine make(history, x, f)
      type(frame_history), intent(out) :: history
      real(wp), intent(in) :: x(:), f(:)
      type(hysteresis_result) :: result
      type(error_type), allocatable :: error

      call analyse_hysteresis(x, f, result, error)
      call assertFalse(allocated(error), 'analysed')
      if (allocated(error)) return
      call new_frame_history(history, x, f, result, error)
      call assertFalse(allocated(error), 'taken')
   end subroutine make

   !> From starts far off the numbers come back as far as loops tell: energies within 1 %, peaks
   !> within 0.5 %.
   subroutine test_dowel()
      type(dowel_type_material) :: truth, found
      type(frame_history) :: history
      type(frame_comparison) :: comparison
      type(error_type), allocatable :: error
      real(wp) :: x(0:40*n_legs), f(0:40*n_legs), chi_squared

      truth%pinching_force = 2.0_wp
      truth%pinching_stiffness = 0.3_wp
      truth%unloading_ratio = 4.0_wp
      truth%curvature = 0.8_wp
      truth%pinching_growth = 0.1_wp
      truth%yield_displacement = 1.5_wp
      truth%softening = [0.5_wp, 0.2_wp, 0.3_wp]
      truth%envelope = dowel_envelope([1.5_wp, 4.0_wp, 20.0_wp], [12.0_wp, 18.0_wp, 25.0_wp], &
         1.0_wp)
      truth%slider_stiffness = 4.0_wp
      truth%slider_force = 1.5_wp
      x = path_along(ends, 40)
      call truth%replay(x, f, error)
      call assertFalse(allocated(error), 'made')
      call make(history, x, f)
      call fit_material(found, history, chi_squared, error)
      call assertFalse(allocated(error), 'fitted')
      if (allocated(error)) return
      call compare_material(comparison, found, history, error)
      call assertLessThan(comparison%largest_energy_error, 0.01_wp, 'energy')
      call assertLessThan(comparison%largest_peak_error, 0.005_wp, 'peaks')
      call assertLessThan(comparison%force_error, 0.01_wp, 'force')
      call assertTrue(least_steps(comparison, found, history) > 4, 'steps')
   end subroutine test_dowel

   !> As above; the force of unloading stays below that of reloading at every amplitude.
   subroutine test_pinching()
      type(pinching4_material) :: truth, found
      type(frame_history) :: history
      type(frame_comparison) :: comparison
      type(error_type), allocatable :: error
      real(wp) :: x(0:40*n_legs), f(0:40*n_legs), chi_squared
      integer :: side

      do side = 1, 2
         truth%displacement(:, side) = [1.0_wp, 4.0_wp, 8.0_wp, 15.0_wp]
         truth%force(:, side) = [10.0_wp, 16.0_wp, 20.0_wp, 21.0_wp]
      end do
      truth%reload_displacement = [0.5_wp, 0.4_wp]
      truth%reload_force = [0.35_wp, 0.3_wp]
      truth%unload_force = [0.05_wp, 0.1_wp]
      x = path_along(ends, 40)
      call truth%replay(x, f, error)
      call make(history, x, f)
      call fit_material(found, history, chi_squared, error)
      call assertFalse(allocated(error), 'fitted')
      if (allocated(error)) return
      call compare_material(comparison, found, history, error)
      call assertLessThan(comparison%largest_energy_error, 0.02_wp, 'energy')
      call assertLessThan(comparison%largest_peak_error, 0.01_wp, 'peaks')
      do side = 1, 2
         call assertLessThan(found%unload_force(side)*maxval(found%force(:, side)), &
            found%reload_force(side)*minval(found%force(:, side)), 'guard')
      end do
   end subroutine test_pinching

   !> It has no loops.
   subroutine test_monotonic()
      real(wp), parameter :: x(*) = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp]
      type(hysteresis_result) :: result
      type(frame_history) :: history
      type(error_type), allocatable :: error

      call analyse_hysteresis(x, x, result, error)
      call new_frame_history(history, x, x, result, error)
      call assertTrue(allocated(error), 'refused')
      if (allocated(error)) call assertTrue(index(error%message, 'monotonic') > 0, 'said')
   end subroutine test_monotonic

end module test_frame_fit
