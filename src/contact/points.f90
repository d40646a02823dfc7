!> The contact-point update, friction and all, for many points at once, as a structure of arrays:
!> what explicit hosts, VUINTER and the C interface call. Point by point it is
!> `update_contact_point`.
module asperity_contact_points
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_contact_point, only: update_contact_point
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, contact_state, no_rotation, status_unset
   use asperity_law_validity, only: valid
   implicit none
   private
   public :: contact_states, new_contact_states, get_contact_state, set_contact_state, &
      update_contact_points

   !> What the points remember between increments: `contact_state`, each component an array over
   !> the points. Build it with `new_contact_states`.
   type :: contact_states
      !> `status_unset`, `status_open`, `status_stick` or `status_slip`
      integer, allocatable :: status(:)
      !> Overclosure, mm
      real(wp), allocatable :: overclosure(:)
      !> Pressure, MPa
      real(wp), allocatable :: pressure(:)
      !> Stored (recoverable) normal energy per area, N/mm
      real(wp), allocatable :: normal_energy(:)
      !> Elastic slip in the two slip directions, mm; (points, 2)
      real(wp), allocatable :: elastic_slip(:, :)
      !> Largest overclosure reached, mm
      real(wp), allocatable :: largest_closure(:)
      !> Frictional dissipation per area since the start, N/mm
      real(wp), allocatable :: dissipation(:)
      !> Pressure coupling per area since the start, N/mm
      real(wp), allocatable :: pressure_coupling(:)
      !> All validity flags reached so far
      integer, allocatable :: validity(:)
      !> Of friction that is not plain: how far it has gone from rest to motion, and the turn of the
      !> grain, radians; unallocated while all are zero
      real(wp), allocatable :: motion_share(:), grain_turn(:)
      !> Elastic slips of summits, mm; (points, 2, elements), unallocated while all are zero
      real(wp), allocatable :: summit_slip(:, :, :)
   end type contact_states

contains

   !> Fresh points.
   pure subroutine new_contact_states(states, points, error)
      !> Result
      type(contact_states), intent(out) :: states
      !> Number of points, zero or more
      integer, intent(in) :: points
      !> Set when the number is negative
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: zero(:)

      if (points < 0) then
         call fatal_error(error, 'points = '//to_text(points)// &
            ' is not allowed: the number of contact points is zero or more', subject='points')
         return
      end if
      allocate (zero(points), source=0.0_wp)
      allocate (states%status(points), source=status_unset)
      allocate (states%validity(points), source=valid)
      allocate (states%elastic_slip(points, 2), source=0.0_wp)
      states%overclosure = zero
      states%pressure = zero
      states%normal_energy = zero
      states%largest_closure = zero
      states%dissipation = zero
      states%pressure_coupling = zero
   end subroutine new_contact_states

   !> State of one point.
   pure function get_contact_state(states, point) result(state)
      !> States of all points
      type(contact_states), intent(in) :: states
      !> Number of the point, from 1
      integer, intent(in) :: point
      type(contact_state) :: state

      state%status = states%status(point)
      state%overclosure = states%overclosure(point)
      state%pressure = states%pressure(point)
      state%normal_energy = states%normal_energy(point)
      state%elastic_slip = states%elastic_slip(point, :)
      state%largest_closure = states%largest_closure(point)
      state%dissipation = states%dissipation(point)
      state%pressure_coupling = states%pressure_coupling(point)
      state%validity = states%validity(point)
      if (allocated(states%motion_share)) then
         state%motion_share = states%motion_share(point)
         state%grain_turn = states%grain_turn(point)
      end if
      if (allocated(states%summit_slip)) state%summit_slip = states%summit_slip(point, :, :)
   end function get_contact_state

   !> Set the state of one point.
   pure subroutine set_contact_state(states, point, state)
      !> States of all points
      type(contact_states), intent(inout) :: states
      !> Number of the point, from 1
      integer, intent(in) :: point
      !> Its new state
      type(contact_state), intent(in) :: state

      call keep_state(states, point, state)
      call keep_friction(states, point, state)
   end subroutine set_contact_state

   !> What every point remembers.
   pure subroutine keep_state(states, point, state)
      type(contact_states), intent(inout) :: states
      integer, intent(in) :: point
      type(contact_state), intent(in) :: state

      states%status(point) = state%status
      states%overclosure(point) = state%overclosure
      states%pressure(point) = state%pressure
      states%normal_energy(point) = state%normal_energy
      states%elastic_slip(point, :) = state%elastic_slip
      states%largest_closure(point) = state%largest_closure
      states%dissipation(point) = state%dissipation
      states%pressure_coupling(point) = state%pressure_coupling
      states%validity(point) = state%validity
   end subroutine keep_state

   !> What friction that is not plain remembers; its arrays are made when there is something.
   pure subroutine keep_friction(states, point, state)
      type(contact_states), intent(inout) :: states
      integer, intent(in) :: point
      type(contact_state), intent(in) :: state

      associate (n => size(states%status))
         if (.not. allocated(states%motion_share) .and. max(abs(state%motion_share), &
            abs(state%grain_turn)) > 0.0_wp) allocate (states%motion_share(n), &
            states%grain_turn(n), source=0.0_wp)
         if (.not. allocated(states%summit_slip) .and. any(abs(state%summit_slip) > 0.0_wp)) &
            allocate (states%summit_slip(n, 2, most_stick_elements), source=0.0_wp)
      end associate
      if (allocated(states%motion_share)) then
         states%motion_share(point) = state%motion_share
         states%grain_turn(point) = state%grain_turn
      end if
      if (allocated(states%summit_slip)) states%summit_slip(point, :, :) = state%summit_slip
   end subroutine keep_friction

   !> Advance all points over one increment, in place. A host that iterates keeps a copy of the
   !> states of the start. `error` is set, and nothing changed, when an array has not one entry
   !> (row) a point.
   pure subroutine update_contact_points(properties, states, overclosure, slip_increment, &
         traction, error, rotation, tangent, tangential_energy, dissipation, plastic_dissipation, &
         pressure_coupling, validity, time_increment)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> States at the start; at the end on return
      type(contact_states), intent(inout) :: states
      !> Overclosure at the end, mm; `no_opposite_surface` where there is none
      real(wp), intent(in), contiguous :: overclosure(:)
      !> Relative tangential motion of the increment, mm; (points, 2)
      real(wp), intent(in), contiguous :: slip_increment(:, :)
      !> Pressure and two shear stresses at the end, MPa; (points, 3)
      real(wp), intent(out), contiguous :: traction(:, :)
      !> Set when an array has a wrong size
      type(error_type), allocatable, intent(out) :: error
      !> Rotation of the slip directions; (points, 2, 2), none when absent
      real(wp), intent(in), contiguous, optional :: rotation(:, :, :)
      !> d traction(i)/d (overclosure, slip 1, slip 2)(j), MPa/mm; (points, 3, 3)
      real(wp), intent(out), contiguous, optional :: tangent(:, :, :)
      !> Stored tangential energy at the end, frictional dissipation, plastic dissipation of summits
      !> and pressure coupling of this increment, per area, N/mm
      real(wp), intent(out), contiguous, optional :: tangential_energy(:), dissipation(:), &
         plastic_dissipation(:), pressure_coupling(:)
      !> Validity of these results
      integer, intent(out), contiguous, optional :: validity(:)
      !> Time of the increment, s, for friction that depends on the slip rate
      real(wp), intent(in), optional :: time_increment
      type(contact_response) :: response
      real(wp) :: turn(2, 2)
      integer :: points, i

      points = 0
      if (allocated(states%status)) points = size(states%status)
      call check_shape(error, 'overclosure', shape(overclosure), [points])
      call check_shape(error, 'slip_increment', shape(slip_increment), [points, 2])
      call check_shape(error, 'traction', shape(traction), [points, 3])
      if (present(rotation)) &
         call check_shape(error, 'rotation', shape(rotation), [points, 2, 2])
      if (present(tangent)) call check_shape(error, 'tangent', shape(tangent), [points, 3, 3])
      if (present(tangential_energy)) &
         call check_shape(error, 'tangential_energy', shape(tangential_energy), [points])
      if (present(dissipation)) &
         call check_shape(error, 'dissipation', shape(dissipation), [points])
      if (present(plastic_dissipation)) &
         call check_shape(error, 'plastic_dissipation', shape(plastic_dissipation), [points])
      if (present(pressure_coupling)) &
         call check_shape(error, 'pressure_coupling', shape(pressure_coupling), [points])
      if (present(validity)) call check_shape(error, 'validity', shape(validity), [points])
      if (allocated(error)) return

      turn = no_rotation
      do i = 1, points
         if (present(rotation)) turn = rotation(i, :, :)
         call update_contact_point(properties, get_contact_state(states, i), overclosure(i), &
            [slip_increment(i, 1), slip_increment(i, 2)], turn, response, time_increment)
         call keep_state(states, i, response%state)
         if (allocated(states%motion_share) .or. .not. properties%friction_is_plain) &
            call keep_friction(states, i, response%state)
         traction(i, :) = response%traction
         if (present(tangent)) tangent(i, :, :) = response%tangent
         if (present(tangential_energy)) tangential_energy(i) = response%tangential_energy
         if (present(dissipation)) dissipation(i) = response%dissipation
         if (present(plastic_dissipation)) plastic_dissipation(i) = response%plastic_dissipation
         if (present(pressure_coupling)) pressure_coupling(i) = response%pressure_coupling
         if (present(validity)) validity(i) = response%validity
      end do
   end subroutine update_contact_points

   !> Set `error`, unless it is set, when an array has not the shape that the points need.
   pure subroutine check_shape(error, name, found, needed)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      integer, intent(in) :: found(:), needed(:)
      integer :: i

      if (allocated(error) .or. all(found == needed)) return
      do i = 1, size(needed)
         if (found(i) /= needed(i)) exit
      end do
      call fatal_error(error, name//' has the extent '//to_text(found(i))//' in dimension '// &
         to_text(i)//', not '//to_text(needed(i))//': states of '//to_text(needed(1))// &
         ' points were given', subject=name)
   end subroutine check_shape

end module asperity_contact_points
