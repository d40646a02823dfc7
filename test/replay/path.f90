!> Given motions: lengths of their increments, through a UINTER of another, and those of the contact
!> points at which replays of tests fail.
module test_replay_path
   use asperity, only: contact_properties, error_type, new_contact_properties, &
      no_opposite_surface, wp
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_replay_abaqus_host, only: host_point, new_host_point
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_path_replay, only: path_step, replay_path
   use asperity_replay_shear_box, only: run_shear_box, shear_settings, shear_step
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_run, only: failed_point, run_tenon
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use tenon_cases, only: face_pair, side_pair
   implicit none
   private
   public :: suite_replay_path

   procedure(uinter_interface) :: uinter
   real(wp), parameter :: stiffness = 80.0_wp, viscosity = 3.0_wp

contains

   function suite_replay_path() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('replay of a path')
      call suite%addTest(TestMethod('lengths of increments', test_lengths))
      call suite%addTest(TestMethod('a spring and dashpot by another hand', test_dashpot))
      call suite%addTest(TestMethod('the row that fails is named', test_row))
      call suite%addTest(TestMethod('the point at which a tenon joint fails', test_tenon))
      call suite%addTest(TestMethod('the motion with which a shear box fails', test_shear))
   end function suite_replay_path

   subroutine test_lengths()
      type(motion_path) :: path

      path%time = [0.5_wp, 2.0_wp, 2.5_wp]
      call assertEqual([0.5_wp, 1.5_wp, 0.5_wp], path%lengths(), 0.0_wp, 'from time zero')
      path%time = [0.0_wp, 2.0_wp, 2.5_wp]
      call assertEqual([2.0_wp, 2.0_wp, 0.5_wp], path%lengths(), 0.0_wp, 'at time zero')
      path%time = [0.0_wp]
      call assertEqual([1.0_wp], path%lengths(), 0.0_wp, 'one row')
   end subroutine test_lengths

   !> Pressure K u, shear stress by the slip rate: dissipation is stress times slip, TIME the end of
   !> the increment.
   subroutine test_dashpot()
      type(host_point) :: point
      type(motion_path) :: path
      type(path_step), allocatable :: steps(:)
      type(error_type), allocatable :: error
      integer :: i

      path = motion_path(time=[0.5_wp, 2.0_wp, 2.25_wp, 3.0_wp], overclosure=[0.1_wp, 0.2_wp, &
         no_opposite_surface, 0.05_wp], slip=reshape([0.0_wp, 0.0_wp, 0.3_wp, -0.6_wp, 0.3_wp, &
         -0.6_wp, 0.6_wp, 0.0_wp], [2, 4]), expected=reshape([0.0_wp], [1, 1]))
      call new_host_point(point, dashpot, [stiffness, viscosity], 1, keep_history=.false.)
      call replay_path(path, point, steps, error)
      call assertFalse(allocated(error), 'done')
      if (allocated(error)) return
      call assertEqual([8.0_wp, 16.0_wp, 0.0_wp, 4.0_wp], steps%traction(1), 1.0e-14_wp, 'K u')
      call assertEqual([0.0_wp, 0.6_wp, 0.0_wp, 1.2_wp], steps%traction(2), 1.0e-14_wp, 'x')
      call assertEqual([0.0_wp, -1.2_wp, 0.0_wp, 2.4_wp], steps%traction(3), 1.0e-14_wp, 'y')
      call assertEqual([0.0_wp, 0.9_wp, 0.9_wp, 2.7_wp], steps%dissipation(3), 1.0e-14_wp, &
         'viscous')
      call assertEqual([0.0_wp], [maxval(abs(steps%dissipation(1)))], 0.0_wp, 'none by friction')
      call assertEqual(path%time, [(steps(i)%statev(1), i=1, 4)], 1.0e-15_wp, 'TIME')
      call assertTrue(all(steps%lopenclose == [1, 1, 0, 1]), 'open where nothing is opposite')
   end subroutine test_dashpot

   subroutine test_row()
      type(host_point) :: point
      type(motion_path) :: path
      type(path_step), allocatable :: steps(:)
      type(error_type), allocatable :: error

      path = motion_path(time=[1.0_wp, 2.0_wp], overclosure=[0.1_wp, 0.6_wp], &
         slip=reshape([0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], [2, 2]), expected=reshape([0.0_wp], [1, 1]))
      call new_host_point(point, dashpot, [stiffness, viscosity], 1, keep_history=.false.)
      call replay_path(path, point, steps, error)
      call assertTrue(allocated(error), 'cuts for ever past 0.5')
      if (allocated(error)) call assertEqual(1, index(error%message, &
         'row 2, time = 2.0 s: UINTER asks to cut the increment for ever'), error%message)
   end subroutine test_row

   !> Led through a UINTER of its own, the point comes to the pressure and shear stress that it had
   !> at the end of the last good step.
   subroutine test_tenon()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), again(:)
      type(tenon_point), allocatable :: points(:)
      type(failed_point) :: failed
      type(error_type), allocatable :: error
      type(host_point) :: point
      type(path_step), allocatable :: path(:)
      real(wp) :: departure
      integer :: i

      ! the sides hold 18 kN
      s = tenon_settings(axial_rule='force', axial_force=1.0e4_wp, side_pressure=0.2_wp, &
         points=50, contact='rough', through_uinter=.true.)
      call run_tenon(s, face_pair(), side_pair(), steps, error)
      call assertTrue(allocated(error), 'fails')
      if (.not. allocated(error)) return
      call run_tenon(s, face_pair(), side_pair(), again, error, [ubound(steps, 1)], points, &
         failed=failed)
      call assertEqual(size(steps), size(again), 'again at the same step')
      call assertTrue(failed%point > 0, 'a point')
      if (failed%point == 0) return
      call assertTrue(size(failed%path%time) > size(steps), 'all increments, and that which failed')
      call new_host_point(point, uinter, failed%properties, keep_history=.false.)
      call replay_path(failed%path, point, path, error)
      call assertFalse(allocated(error), 'replayed')
      departure = 1.0_wp
      associate (last => points(failed%point))
         do i = 1, size(path)
            departure = min(departure, abs(path(i)%traction(1) - last%pressure) &
               + abs(norm2(path(i)%traction(2:)) - norm2([last%shear_1, last%shear_2])))
         end do
      end associate
      call assertEqual(0.0_wp, departure, 1.0e-12_wp, 'comes by the tractions of the last step')
   end subroutine test_tenon

   !> A soft machine on faces that stick far more than they slide finds no balance. Its motion comes
   !> to the stresses of the steps before.
   subroutine test_shear()
      type(contact_properties) :: p, soft
      type(shear_settings) :: box
      type(shear_step), allocatable :: steps(:)
      type(motion_path) :: failed
      type(host_point) :: point
      type(path_step), allocatable :: path(:)
      type(error_type), allocatable :: error
      integer :: n

      p = pair_properties()
      box%normal_stress = 0.2_wp
      box%displacement = [0.1_wp]
      call run_shear_box(box, p, steps, error, failed)
      call assertFalse(allocated(error), 'a good one')
      call assertFalse(allocated(failed%time), 'leaves nothing')
      call new_contact_properties(soft, p%normal, 0.5_wp, 1.0e-4_wp, error, &
         p%initial_separation, accept_unphysical=.true., &
         friction=friction_settings(static_friction_coefficient=4.0_wp, decay_slip=2.0e-3_wp, &
         pressure_exponent=2.9_wp, reference_pressure=0.2_wp))
      call assertFalse(allocated(error), 'such faces')
      box = shear_settings(normal_stress=1.2_wp, displacement=[3.0_wp], &
         displacement_increment=2.0_wp, shear_compliance=0.1_wp)
      call run_shear_box(box, soft, steps, error, failed)
      call assertTrue(allocated(error), 'fails')
      call assertTrue(allocated(failed%time), 'leaves its motion')
      if (.not. allocated(failed%time)) return
      n = size(failed%time)
      call new_host_point(point, uinter, soft, keep_history=.false.)
      call replay_path(failed, point, path, error)
      call assertFalse(allocated(error), 'replayed')
      call assertTrue(n > 1, 'seated, and the increment that failed')
      call assertEqual(steps(:n - 1)%normal_stress, path(:n - 1)%traction(1), 1.0e-13_wp, &
         'pressure')
      call assertEqual(steps(:n - 1)%shear_stress, path(:n - 1)%traction(2), 1.0e-13_wp, 'shear')
   end subroutine test_shear

   !> Pressure K u of PROPS(1), shear stress PROPS(2) times the slip rate; no number of the motion
   !> past 0.5 mm.
   subroutine dashpot( &
      stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, &
      sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, &
      time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, drot, &
      area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, &
      linper, lopenclose, lstate, lsdi, lprint)
      integer, intent(in) :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit
      integer, intent(in) :: linper, lprint
      real(wp), intent(inout) :: stress(ndir)
      real(wp), intent(inout) :: ddsddr(ndir, ndir), dviscous(ndir, ndir), dstructural(ndir, ndir)
      real(wp), intent(inout) :: flux(2), ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir)
      real(wp), intent(inout) :: statev(nstatv)
      real(wp), intent(inout) :: sed, sfd, spd, svd, scd, pnewdt
      real(wp), intent(in) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2)
      real(wp), intent(in) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr
      character(len=80), intent(in) :: ciname, slname, msname
      real(wp), intent(in) :: props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2)
      real(wp), intent(in) :: area, chrlngth
      integer, intent(inout) :: lopenclose, lstate, lsdi
      integer :: i

      associate (u1 => dviscous, u2 => dstructural, u3 => flux, u4 => ddfddt, u5 => ddsddt, &
            u6 => ddfddr, u7 => spd, u8 => scd, u9 => temp, u10 => dtemp, u11 => predef, &
            u12 => dpred, u13 => freqr, u14 => ciname, u15 => slname, u16 => msname, &
            u17 => coords, u18 => alocaldir, u19 => drot, u20 => area, u21 => chrlngth, &
            u22 => node, u23 => kstep, u24 => kinc, u25 => kit, u26 => linper, u27 => lprint, &
            u28 => lstate, u29 => lsdi)
         ! arguments that it does not need
      end associate
      lopenclose = merge(1, 0, rdisp(1) > 0.0_wp)
      stress = 0.0_wp
      ddsddr = 0.0_wp
      svd = 0.0_wp
      statev(1) = time(2)
      if (rdisp(1) > 0.5_wp) pnewdt = 0.5_wp
      if (rdisp(1) <= 0.0_wp) return
      stress(1) = props(1)*rdisp(1)
      ddsddr(1, 1) = props(1)
      stress(2:) = props(2)*drdisp(2:)/dtime
      do i = 2, ndir
         ddsddr(i, i) = props(2)/dtime
      end do
      sed = 0.5_wp*stress(1)**2/props(1)
      sfd = 0.0_wp
      svd = dot_product(stress(2:), drdisp(2:))
   end subroutine dashpot

end module test_replay_path
