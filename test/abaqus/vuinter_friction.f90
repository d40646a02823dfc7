!> VUINTER against UINTER, point by point, with friction beyond one coefficient, with summits that
!> stick each for itself, and with heights that are not Gaussian.
module test_abaqus_vuinter_friction
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, error_type, friction_settings, heights_johnson, &
      new_contact_properties, new_normal_properties, normal_properties, rule_abaqus, &
      stick_summits, wp
   use asperity_abaqus_props, only: properties_from_props
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_replay_abaqus_host, only: host_point, new_host_point, try_increment
   use contact_cases, only: pair_properties
   use extremes, only: largest_of, worsen
   use funit, only: assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   use vuinter_host, only: advance_nodes, guards_hold, new_slave_nodes, outputs_set, slave_nodes, &
      statev_of, stress_of, time_increment
   implicit none
   private
   public :: suite_vuinter_friction

   procedure(uinter_interface) :: uinter
   integer(int64), parameter :: seed = 17320508_int64
   integer, parameter :: n_kinds = 7, kind_of_johnson = 7

contains

   function suite_vuinter_friction() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('vuinter_friction')
      call suite%addTest(TestMethod('gives UINTER''s bits', test_bits))
      call suite%addTest(TestMethod('agrees with UINTER to 1e-10 with many nodes', test_many))
   end function suite_vuinter_friction

   !> Numbers that single precision holds.
   function settings_of(kind) result(settings)
      integer, intent(in) :: kind
      type(friction_settings) :: settings

      select case (kind)
      case (1)
         settings = friction_settings(static_friction_coefficient=0.75_wp, decay_slip=0.125_wp)
      case (2)
         settings = friction_settings(static_friction_coefficient=0.75_wp, decay_slip_rate=2.0_wp)
      case (3)
         settings = friction_settings(friction_coefficient_across=0.25_wp, grain_angle=30.0_wp, &
            slip_direction=1)
      case (4)
         settings = friction_settings(pressure_exponent=-0.25_wp, reference_pressure=2.0_wp, &
            shear_limit=0.5_wp)
      case (5)
         settings = friction_settings(friction_points=2)
         settings%friction_pressures(:2) = [0.125_wp, 1.5_wp]
         settings%friction_factors(:2) = [1.25_wp, 0.5_wp]
      case (6)
         settings = friction_settings(stick=stick_summits, shear_modulus=32.0_wp, stick_elements=6)
      case default
         settings = friction_settings()
      end select
   end function settings_of

   subroutine new_nodes(kind, n_nodes, nodes, p)
      integer, intent(in) :: kind, n_nodes
      type(slave_nodes), intent(out) :: nodes
      type(contact_properties), intent(out) :: p
      type(contact_properties) :: wood
      type(normal_properties) :: normal
      type(error_type), allocatable :: error

      wood = pair_properties()
      normal = wood%normal
      if (kind == kind_of_johnson) then
         associate (n => wood%normal)
            call new_normal_properties(normal, n%eta, n%modulus, n%radius, n%hardness, &
               n%yield_factor, n%sigma, error, height_distribution=heights_johnson, &
               skewness=0.25_wp, kurtosis=3.5_wp)
         end associate
         call assertFalse(allocated(error), 'accepted')
      end if
      call new_contact_properties(p, normal, 0.5_wp, 0.31_wp, error, 0.2372_wp, rule_abaqus, &
         friction=settings_of(kind))
      call assertFalse(allocated(error), 'accepted')
      call new_slave_nodes(nodes, n_nodes, p)
      ! what a list in the precision of the run says
      call properties_from_props(real(nodes%props, wp), p, error)
      call assertFalse(allocated(error), 'accepted')
   end subroutine new_nodes

   !> Few nodes: every number is that of UINTER, rounded to the precision of the run.
   subroutine test_bits()
      call assertFalse(worst_difference(20, 20) > 0.0_wp, 'difference')
   end subroutine test_bits

   !> So many that the law is compiled.
   subroutine test_many()
      real(wp) :: worst

      worst = worst_difference(800, 3)
      call assertLessThan(worst, 1.0e-10_wp + 4.0_wp*real(epsilon(1.0_vp), wp), 'difference')
      if (vp == wp) call assertTrue(worst > 0.0_wp, 'the law was compiled')
      write (*, '(5x, a, es9.1)') 'worst difference', worst
   end subroutine test_many

   !> Largest difference of a stress over the larger of pressure and shear, or of a slot of STATEV
   !> over its size, along random paths of all kinds, each increment from the STATEV of VUINTER.
   function worst_difference(n_nodes, increments) result(worst)
      integer, intent(in) :: n_nodes, increments
      real(wp) :: worst
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(slave_nodes) :: nodes, start
      real(vp) :: overclosure(n_nodes), slip(2, n_nodes), turn(2, 2, n_nodes)
      real(wp) :: angle
      integer :: kind, i, node

      stream = random_stream(seed)
      worst = 0.0_wp
      do kind = 1, n_kinds
         call new_nodes(kind, n_nodes, nodes, p)
         do i = 1, increments
            do node = 1, n_nodes
               overclosure(node) = real(stream%uniform(-0.05_wp, 0.15_wp), vp)
               slip(1, node) = real(stream%uniform(-0.3_wp, 0.3_wp), vp)
               slip(2, node) = real(stream%uniform(-0.3_wp, 0.3_wp), vp)
               angle = stream%uniform(-0.5_wp, 0.5_wp)
               turn(:, :, node) = real(reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], &
                  [2, 2]), vp)
            end do
            start = nodes
            call advance_nodes(nodes, overclosure, slip, turn)
            call assertTrue(guards_hold(nodes) .and. outputs_set(nodes), 'outputs')
            do node = 1, n_nodes
               call worsen(worst, difference(p, start, nodes, node, overclosure(node), &
                  slip(:, node), turn(:, :, node)))
            end do
         end do
      end do
   end function worst_difference

   function difference(p, start, nodes, node, overclosure, slip, turn) result(worst)
      type(contact_properties), intent(in) :: p
      type(slave_nodes), intent(in) :: start, nodes
      integer, intent(in) :: node
      real(vp), intent(in) :: overclosure, slip(2), turn(2, 2)
      real(wp) :: worst
      type(host_point) :: point
      type(error_type), allocatable :: error
      real(wp), allocatable :: found(:), wanted(:)
      real(wp) :: scale

      call new_host_point(point, uinter, p, props=real(nodes%props, wp), keep_history=.false.)
      point%start%statev = statev_of(start, node)
      call try_increment(point, real(overclosure, wp), real(slip, wp), real(time_increment, wp), &
         error, real(turn, wp))
      call assertFalse(allocated(error), 'UINTER kept its contract')
      wanted = real(real(point%trial%stress, vp), wp)
      scale = max(largest_of(wanted), tiny(1.0_wp))
      worst = largest_of(stress_of(nodes, node) - wanted)/scale
      found = statev_of(nodes, node)
      wanted = real(real(point%trial%statev, vp), wp)
      scale = max(largest_of(wanted(5:6)), 1.0e-3_wp*p%critical_slip)
      if (size(wanted) > 13) call worsen(worst, largest_of(found(14:) - wanted(14:))/scale)
      call worsen(worst, largest_of(found(5:6) - wanted(5:6))/scale)
      if (size(wanted) > 11) call worsen(worst, largest_of(found(12:13) - wanted(12:13)))
      if (abs(found(1) - wanted(1)) > 0.0_wp) worst = huge(1.0_wp)
   end function difference

end module test_abaqus_vuinter_friction
