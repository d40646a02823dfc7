!> Contact points in the middle of a job, for the update, UINTER and VUINTER: each has a state from
!> which an increment is to be computed, and the motion of that increment.
module bench_cases
   use asperity, only: contact_properties, contact_response, contact_state, no_rotation, &
      rule_abaqus, slip_exact, status_slip, status_stick, update_contact_point, wp
   use asperity_abaqus_prop_slots, only: prop_unloading
   use asperity_abaqus_props, only: props_from_properties
   use asperity_abaqus_statev, only: n_statev, state_warned, statev_from_state
   use asperity_base_constants, only: pi
   use asperity_law_validity, only: all_flags
   use contact_cases, only: pair_properties, random_contact
   use random_inputs, only: random_stream
   implicit none
   private
   public :: contact_set, new_contact_set, both

   !> In place of a status: points that stick and points that slip, at random
   integer, parameter :: both = 0

   !> Points and their properties.
   type :: contact_set
      !> Sets of properties, the same as PROPS, and which of them each point has
      type(contact_properties), allocatable :: properties(:)
      real(wp), allocatable :: props(:, :)
      integer, allocatable :: which(:)
      !> State at the start, the same as STATEV
      type(contact_state), allocatable :: state(:)
      real(wp), allocatable :: statev(:, :)
      !> Overclosure and slip at the end, and their increments; (3, points)
      real(wp), allocatable :: position(:, :), motion(:, :)
   end type contact_set

contains

   !> Points whose increment ends at separations uniform in h = d/sigma, sticking or slipping.
   subroutine new_contact_set(set, points, sets, status, h_min, h_max)
      type(contact_set), intent(out) :: set
      !> Points; sets of properties, the pair transverse-tangential when there is one
      integer, intent(in) :: points, sets
      !> `status_stick`, `status_slip` or `both`
      integer, intent(in) :: status
      real(wp), intent(in) :: h_min, h_max
      type(random_stream) :: stream
      integer :: i, wanted

      stream%state = 19640213
      allocate (set%properties(sets), set%props(prop_unloading, sets), set%which(points), &
         set%state(points), set%statev(n_statev, points), set%position(3, points), &
         set%motion(3, points))
      if (sets == 1) then
         set%properties(1) = pair_properties()
      else
         do i = 1, sets
            call random_contact(stream, set%properties(i), rule_abaqus, slip_exact)
         end do
      end if
      do i = 1, sets
         ! of plain friction, so that the rest of the list is zeros
         associate (full => props_from_properties(set%properties(i)))
            set%props(:, i) = full(:prop_unloading)
         end associate
      end do
      do i = 1, points
         set%which(i) = 1 + mod(i - 1, sets)
         wanted = status
         if (status == both) &
            wanted = merge(status_stick, status_slip, stream%uniform(0.0_wp, 1.0_wp) < 0.5_wp)
         call new_point(set, i, wanted, stream%uniform(h_min, h_max), stream)
      end do
   end subroutine new_contact_set

   !> One point: closed and a little slipped at the start, then moved as it takes to stick or slip.
   subroutine new_point(set, point, status, h, stream)
      type(contact_set), intent(inout) :: set
      integer, intent(in) :: point, status
      real(wp), intent(in) :: h
      type(random_stream), intent(inout) :: stream
      type(contact_response) :: response
      real(wp) :: angle, slip

      associate (p => set%properties(set%which(point)), position => set%position(:, point), &
            motion => set%motion(:, point))
         angle = stream%uniform(0.0_wp, 2.0_wp*pi)
         position(1) = p%initial_separation - h*p%normal%sigma
         position(2:) = 0.3_wp*p%critical_slip*[cos(angle), sin(angle)]
         motion(1) = stream%uniform(-0.02_wp, 0.02_wp)*p%normal%sigma
         call update_contact_point(p, contact_state(), position(1) - motion(1), position(2:), &
            no_rotation, response)
         set%state(point) = response%state
         set%statev(:, point) = 0.0_wp
         call statev_from_state(response%state, set%statev(:, point))
         ! no messages
         set%statev(state_warned, point) = all_flags

         angle = stream%uniform(0.0_wp, 2.0_wp*pi)
         slip = merge(0.05_wp, 3.0_wp, status == status_stick)*p%critical_slip
         motion(2:) = slip*[cos(angle), sin(angle)]
         position(2:) = position(2:) + motion(2:)
         call update_contact_point(p, set%state(point), position(1), motion(2:), no_rotation, &
            response)
         if (response%status /= status) error stop 'bench: a point does not do what it should'
      end associate
   end subroutine new_point

end module bench_cases
