!> VUINTER against UINTER, point by point, on random paths; and VUINTER in two threads.
module test_abaqus_vuinter_agreement
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, error_type, no_opposite_surface, wp
   use asperity_abaqus_props, only: properties_from_props
   use asperity_abaqus_statev, only: n_statev, state_dissipation, state_elastic_slip_1, &
      state_elastic_slip_2, state_largest_closure, state_normal_energy, state_overclosure, &
      state_pressure, state_pressure_coupling, state_status, state_validity
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_replay_abaqus_host, only: accept_increment, host_point, new_host_point, &
      try_increment
   use contact_cases, only: pair_properties, random_contact
   use extremes, only: largest_of, worsen
   use funit, only: assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   use threads, only: check_two_threads
   use vuinter_host, only: advance_nodes, guards_hold, new_slave_nodes, outputs_set, slave_nodes, &
      statev_of, stress_of
   implicit none
   private
   public :: suite_vuinter_agreement

   procedure(uinter_interface) :: uinter
   integer(int64), parameter :: seed = 14142135_int64
   integer, parameter :: thread_increments = 50, thread_nodes = 40
   real(wp), parameter :: eps = real(epsilon(1.0_vp), wp), dtime = 0.1_wp

   !> Motion of all nodes in an increment
   type :: motion
      real(vp), allocatable :: overclosure(:), slip(:, :), rotation(:, :, :)
   end type motion

contains

   function suite_vuinter_agreement() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('vuinter_agreement')
      call suite%addTest(TestMethod('agrees with UINTER in each increment', test_increments))
      call suite%addTest(TestMethod('agrees with UINTER to 1e-10 with many nodes', test_many))
      call suite%addTest(TestMethod('agrees with UINTER along whole paths', test_paths))
      call suite%addTest(TestMethod('two threads give the serial bits', test_threads))
   end function suite_vuinter_agreement

   !> Random properties, both rules, both integrations, two and three components, with memory and
   !> without, too few nodes for a compiled law; each increment from the state that VUINTER keeps.
   !> Within 4 roundings of the run's precision.
   subroutine test_increments()
      integer, parameter :: n_nodes = 140, increments = 25
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(error_type), allocatable :: error
      type(slave_nodes) :: nodes, start
      type(motion) :: m
      real(wp) :: worst
      integer :: case, set, i, node, seen(0:3)

      stream = random_stream(seed)
      worst = 0.0_wp
      seen = 0
      do case = 0, 15
         do set = 1, 3
            call new_random_nodes(stream, n_nodes, case, nodes, p)
            do i = 1, increments
               call move(stream, n_nodes, p, m)
               start = nodes
               call advance_nodes(nodes, m%overclosure, m%slip, m%rotation)
               call assertTrue(guards_hold(nodes) .and. outputs_set(nodes), 'outputs')
               do node = 1, n_nodes
                  call worsen(worst, difference(p, start, nodes, m, node, error))
                  call count_status(nodes, node, seen)
               end do
               call assertFalse(allocated(error), 'UINTER kept its contract')
            end do
         end do
      end do
      call assertLessThan(worst, 4.0_wp, 'roundings')
      call assertTrue(all(seen(1:) > 1000), 'open, stick and slip came up')
      write (*, '(5x, a, es9.1)') 'worst difference in roundings', worst
   end subroutine test_increments

   !> So many that the law is compiled: separations of -2 to 7 sigma are 125 intervals of 6 nodes.
   !> To round-off they would agree if it were not; with memory they do.
   subroutine test_many()
      integer, parameter :: n_nodes = 800, increments = 4
      real(wp), parameter :: compiled_error = 1.0e-10_wp
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(error_type), allocatable :: error
      type(slave_nodes) :: nodes, start
      type(motion) :: m
      real(wp) :: worst, worst_with_memory
      integer :: case, i, node, seen(0:3)

      stream = random_stream(seed + 1)
      worst = 0.0_wp
      worst_with_memory = 0.0_wp
      seen = 0
      do case = 0, 8
         call new_random_nodes(stream, n_nodes, case, nodes, p)
         do i = 1, increments
            call move(stream, n_nodes, p, m)
            start = nodes
            call advance_nodes(nodes, m%overclosure, m%slip, m%rotation)
            call assertTrue(guards_hold(nodes) .and. outputs_set(nodes), 'outputs')
            do node = 1, n_nodes
               if (case < 8) then
                  call worsen(worst, difference(p, start, nodes, m, node, error))
               else
                  call worsen(worst_with_memory, difference(p, start, nodes, m, node, error))
               end if
               call count_status(nodes, node, seen)
            end do
            call assertFalse(allocated(error), 'UINTER kept its contract')
         end do
      end do
      call assertLessThan(worst*eps, compiled_error + 4.0_wp*eps, 'difference')
      call assertLessThan(worst_with_memory, 4.0_wp, 'roundings with memory')
      if (vp == wp) call assertLessThan(100.0_wp, worst, 'the law was compiled')
      call assertTrue(all(seen(1:) > 1000), 'open, stick and slip came up')
      write (*, '(5x, a, es9.1)') 'worst difference', worst*eps
   end subroutine test_many

   subroutine new_random_nodes(stream, n_nodes, case, nodes, p)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: n_nodes, case
      type(slave_nodes), intent(out) :: nodes
      type(contact_properties), intent(out) :: p
      type(error_type), allocatable :: error

      call random_contact(stream, p, 1 + ibits(case, 0, 1), 1 + ibits(case, 1, 1), &
         ibits(case, 3, 1))
      call new_slave_nodes(nodes, n_nodes, p, merge(2, 3, btest(case, 2)))
      ! what a list in the precision of the run says
      call properties_from_props(real(nodes%props, wp), p, error)
      call assertFalse(allocated(error), 'accepted')
   end subroutine new_random_nodes

   !> Separations of -2 to 7 sigma, slips of up to gcrit; now and then no surface, or a rotation.
   subroutine move(stream, n, p, m)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: n
      type(contact_properties), intent(in) :: p
      type(motion), intent(out) :: m
      real(wp) :: angle
      integer :: i

      allocate (m%overclosure(n), m%slip(2, n), m%rotation(2, 2, n))
      do i = 1, n
         m%overclosure(i) = real(p%initial_separation &
            - p%normal%sigma*stream%uniform(-2.0_wp, 7.0_wp), vp)
         if (stream%uniform(0.0_wp, 1.0_wp) < 0.05_wp) &
            m%overclosure(i) = real(no_opposite_surface, vp)
         m%slip(1, i) = real(p%critical_slip*stream%uniform(-1.0_wp, 1.0_wp), vp)
         m%slip(2, i) = real(p%critical_slip*stream%uniform(-1.0_wp, 1.0_wp), vp)
         angle = 0.0_wp
         if (stream%uniform(0.0_wp, 1.0_wp) < 0.3_wp) angle = stream%uniform(-3.0_wp, 3.0_wp)
         m%rotation(:, :, i) = real(reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], &
            [2, 2]), vp)
      end do
   end subroutine move

   !> Largest difference between VUINTER and UINTER at a node, in roundings of what it is made of:
   !> stresses of the pressure, energies of the energies of the increment, slip of gcrit.
   function difference(p, start, nodes, m, node, error) result(worst)
      type(contact_properties), intent(in) :: p
      type(slave_nodes), intent(in) :: start, nodes
      type(motion), intent(in) :: m
      integer, intent(in) :: node
      type(error_type), allocatable, intent(inout) :: error
      real(wp) :: worst
      integer, parameter :: exact(4) = [state_status, state_overclosure, state_largest_closure, &
         state_validity]
      type(host_point) :: point
      real(wp) :: stress(3), found(n_statev), wanted(n_statev), before(n_statev), energy
      integer :: d

      d = nodes%n_dir
      call new_host_point(point, uinter, p, d, props=real(nodes%props, wp), keep_history=.false.)
      before = statev_of(start, node)
      point%start%statev = before
      call try_increment(point, real(m%overclosure(node), wp), real(m%slip(:d - 1, node), wp), &
         dtime, error, real(m%rotation(:, :, node), wp))
      stress = stress_of(nodes, node)
      found = statev_of(nodes, node)
      associate (t => point%trial)
         wanted = t%statev
         energy = t%sed + t%sfd + before(state_normal_energy) &
            + p%friction_coefficient*before(state_pressure)*p%critical_slip
         worst = in_roundings(largest_of(stress(:d) - t%stress), t%stress(1))
         call worsen(worst, in_roundings(abs(real(nodes%sed(node), wp) - t%sed), energy))
         call worsen(worst, in_roundings(abs(real(nodes%sfd(node), wp) - t%sfd), energy))
         call worsen(worst, in_roundings(abs(real(nodes%spd(node), wp) - t%spd), energy + t%spd))
      end associate
      call worsen(worst, in_roundings(abs(found(state_pressure) - wanted(state_pressure)), &
         wanted(state_pressure)))
      call worsen(worst, in_roundings(abs(found(state_normal_energy) &
         - wanted(state_normal_energy)), wanted(state_normal_energy)))
      call worsen(worst, in_roundings(largest_of(found(state_elastic_slip_1:state_elastic_slip_2) &
         - wanted(state_elastic_slip_1:state_elastic_slip_2)), p%critical_slip))
      call worsen(worst, in_roundings(abs(found(state_dissipation) - wanted(state_dissipation)), &
         energy + wanted(state_dissipation)))
      call worsen(worst, in_roundings(abs(found(state_pressure_coupling) &
         - wanted(state_pressure_coupling)), energy + abs(wanted(state_pressure_coupling))))
      ! the host's own numbers, and whole ones; no_opposite_surface is not the same in both
      wanted = real(real(wanted, vp), wp)
      if (any(abs(found(exact) - wanted(exact)) > 0.0_wp)) worst = huge(1.0_wp)
   end function difference

   !> In roundings of a number of that size; what lies below the smallest normal number is nothing.
   pure real(wp) function in_roundings(error, scale)
      real(wp), intent(in) :: error, scale

      in_roundings = max(error - real(tiny(1.0_vp), wp), 0.0_wp) &
         /(eps*max(scale, real(tiny(1.0_vp), wp)))
   end function in_roundings

   subroutine count_status(nodes, node, seen)
      type(slave_nodes), intent(in) :: nodes
      integer, intent(in) :: node
      integer, intent(inout) :: seen(0:3)
      real(wp) :: statev(n_statev)
      integer :: status

      statev = statev_of(nodes, node)
      status = nint(statev(state_status))
      seen(status) = seen(status) + 1
   end subroutine count_status

   !> Each with its own state from the first increment to the last. Every increment adds a few
   !> roundings of the elastic slip at most, and slipping forgets them: within one an increment.
   subroutine test_paths()
      integer, parameter :: n_nodes = 8, increments = 300
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(error_type), allocatable :: error
      type(slave_nodes) :: nodes
      type(host_point) :: points(n_nodes)
      type(motion) :: m
      real(wp) :: worst, stress(3)
      integer :: case, i, node

      stream = random_stream(seed)
      worst = 0.0_wp
      do case = 0, 7
         call new_random_nodes(stream, n_nodes, case, nodes, p)
         associate (d => nodes%n_dir)
            do node = 1, n_nodes
               call new_host_point(points(node), uinter, p, d, props=real(nodes%props, wp), &
                  keep_history=.false.)
            end do
            do i = 1, increments
               call move(stream, n_nodes, p, m)
               call advance_nodes(nodes, m%overclosure, m%slip, m%rotation)
               do node = 1, n_nodes
                  call try_increment(points(node), real(m%overclosure(node), wp), &
                     real(m%slip(:d - 1, node), wp), dtime, error, &
                     real(m%rotation(:, :, node), wp))
                  call accept_increment(points(node))
                  stress = stress_of(nodes, node)
                  call worsen(worst, in_roundings(largest_of(stress(:d) &
                     - points(node)%start%stress), points(node)%start%stress(1)))
               end do
            end do
         end associate
      end do
      call assertLessThan(worst, real(increments, wp), 'roundings')
      write (*, '(5x, a, es9.1)') 'worst difference in roundings', worst
   end subroutine test_paths

   !> Each thread has a pair of its own; both at once give the bits that each gives alone.
   subroutine test_threads()
      call check_two_threads(thread_work, 5)
   end subroutine test_threads

   !> Sums of stresses and energies over a path of the pair with that number, which stays within
   !> the law's limits: no stub is called.
   subroutine thread_work(number, sums)
      integer, intent(in) :: number
      real(wp), intent(out) :: sums(:)
      type(random_stream) :: stream
      type(slave_nodes) :: nodes
      real(vp) :: overclosure(thread_nodes), slip(2, thread_nodes)
      integer :: i, k

      stream = random_stream(seed + number)
      if (number == 1) then
         call new_slave_nodes(nodes, thread_nodes, pair_properties(2, 1, 'transverse-tangential'))
      else
         call new_slave_nodes(nodes, thread_nodes, pair_properties(2, 1, 'tangential-tangential'))
      end if
      sums = 0.0_wp
      do i = 1, thread_increments
         do k = 1, thread_nodes
            overclosure(k) = real(stream%uniform(-0.05_wp, 0.1_wp), vp)
            slip(1, k) = real(stream%uniform(-0.3_wp, 0.3_wp), vp)
            slip(2, k) = real(stream%uniform(-0.3_wp, 0.3_wp), vp)
         end do
         call advance_nodes(nodes, overclosure, slip)
         do k = 1, thread_nodes
            sums = sums + [stress_of(nodes, k), real(nodes%sed(k), wp), real(nodes%sfd(k), wp)]
         end do
      end do
   end subroutine thread_work

end module test_abaqus_vuinter_agreement
