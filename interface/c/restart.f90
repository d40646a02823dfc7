!> C interface: the state of one point, for a restart. See asperity.h for what each function does.
module asperity_c_restart
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_c_checks, only: answer, check_pointer
   use asperity_c_states, only: make_room, states_of
   use asperity_c_types, only: code_input, code_length, error_struct, state_struct
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_contact_points, only: contact_states, get_contact_state, set_contact_state
   use asperity_contact_state, only: contact_state, status_slip, status_unset
   use asperity_law_validity, only: all_flags, valid
   implicit none
   private
   public :: asperity_states_get, asperity_states_set

   !> Largest lengths, and pressure and energies, of a state: beyond what any law gives, and far
   !> enough from overflow
   real(wp), parameter :: largest_length = 1.0e36_wp, largest_energy = 1.0e200_wp

contains

   !> State of one point, counted from 0.
   integer(c_int) function asperity_states_get(states, point, state, error) result(code) &
         bind(c, name='asperity_states_get')
      !> Handle
      type(c_ptr), value :: states
      !> Number of the point
      integer(c_int), value :: point
      !> Struct to fill
      type(c_ptr), value :: state
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: content
      type(state_struct), pointer :: place
      type(error_type), allocatable :: problem

      call view_point(problem, states, point, state, content, place)
      if (.not. allocated(problem)) then
         associate (s => get_contact_state(content, point + 1))
            place = state_struct(s%status, s%validity, s%overclosure, s%pressure, &
               s%normal_energy, s%elastic_slip, s%largest_closure, s%dissipation, &
               s%pressure_coupling, s%motion_share, s%grain_turn, s%summit_slip)
         end associate
      end if
      code = answer(problem, error)
   end function asperity_states_get

   !> Set the state of one point, counted from 0.
   integer(c_int) function asperity_states_set(states, point, state, error) result(code) &
         bind(c, name='asperity_states_set')
      !> Handle
      type(c_ptr), value :: states
      !> Number of the point
      integer(c_int), value :: point
      !> Its new state
      type(c_ptr), value :: state
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: content
      type(state_struct), pointer :: s
      type(error_type), allocatable :: problem
      logical :: starved

      starved = .false.
      call view_point(problem, states, point, state, content, s)
      if (.not. allocated(problem)) call check_state(problem, s)
      if (.not. allocated(problem)) call make_room(content, starved, &
         max(abs(s%motion_share), abs(s%grain_turn)) > 0.0_wp, any(abs(s%summit_slip) > 0.0_wp))
      if (.not. (allocated(problem) .or. starved)) call set_contact_state(content, point + 1, &
         contact_state(s%status, s%overclosure, s%pressure, s%normal_energy, s%elastic_slip, &
         s%largest_closure, s%dissipation, s%pressure_coupling, s%validity, s%motion_share, &
         s%grain_turn, s%summit_slip))
      code = answer(problem, error, starved)
   end function asperity_states_set

   !> The states and the caller's struct, unless a handle, the struct or the point is not there.
   subroutine view_point(problem, states, point, state, content, s)
      type(error_type), allocatable, intent(inout) :: problem
      type(c_ptr), intent(in) :: states, state
      integer(c_int), intent(in) :: point
      type(contact_states), pointer, intent(out) :: content
      type(state_struct), pointer, intent(out) :: s

      nullify (s)
      call states_of(problem, 'states', states, content)
      call check_pointer(problem, 'state', state)
      if (allocated(problem)) return
      if (point < 0 .or. point >= size(content%status)) then
         call fatal_error(problem, 'point = '//to_text(point)//' is not there: the states have '// &
            to_text(size(content%status))//' points, counted from 0', code_length)
      else
         call c_f_pointer(state, s)
      end if
   end subroutine view_point

   !> Refuse what no update can have left behind.
   subroutine check_state(problem, state)
      type(error_type), allocatable, intent(inout) :: problem
      type(state_struct), intent(in) :: state
      integer :: i, j

      call check_size(problem, 'overclosure', state%overclosure, largest_length)
      call check_size(problem, 'pressure', state%pressure, largest_energy)
      call check_size(problem, 'normal_energy', state%normal_energy, largest_energy)
      call check_size(problem, 'elastic_slip[0]', state%elastic_slip(1), largest_length)
      call check_size(problem, 'elastic_slip[1]', state%elastic_slip(2), largest_length)
      call check_size(problem, 'largest_closure', state%largest_closure, largest_length)
      call check_size(problem, 'dissipation', state%dissipation, largest_energy)
      call check_size(problem, 'pressure_coupling', state%pressure_coupling, largest_energy)
      call check_size(problem, 'motion_share', state%motion_share, 1.0_wp)
      call check_size(problem, 'grain_turn', state%grain_turn, largest_length)
      do j = 1, most_stick_elements
         do i = 1, 2
            call check_size(problem, 'summit_slip['//to_text(j - 1)//']['//to_text(i - 1)//']', &
               state%summit_slip(i, j), largest_length)
         end do
      end do
      if (allocated(problem)) return
      if (state%status < status_unset .or. state%status > status_slip) then
         call fatal_error(problem, 'status = '//to_text(state%status)//' of the state is not '// &
            'allowed: it must be one of enum asperity_status, '//to_text(status_unset)//' to '// &
            to_text(status_slip), code_input)
      else if (state%validity < valid .or. state%validity > all_flags) then
         call fatal_error(problem, 'validity = '//to_text(state%validity)//' of the state is '// &
            'not allowed: it must be a sum of flags, 0 to '//to_text(all_flags), code_input)
      else if (state%pressure < 0.0_wp) then
         call fatal_error(problem, 'pressure = '//to_text(state%pressure)//' MPa of the state '// &
            'is not allowed: it must be zero or more', code_input)
      else if (state%largest_closure < state%overclosure) then
         call fatal_error(problem, 'largest_closure = '//to_text(state%largest_closure)// &
            ' mm of the state is not allowed: it must be the overclosure, '// &
            to_text(state%overclosure)//' mm, or more', code_input)
      else if (state%motion_share < 0.0_wp) then
         call fatal_error(problem, 'motion_share = '//to_text(state%motion_share)//' of the '// &
            'state is not allowed: it must be 0, at rest, to 1, in motion', code_input)
      end if
   end subroutine check_state

   subroutine check_size(problem, name, value, largest)
      type(error_type), allocatable, intent(inout) :: problem
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value, largest

      if (allocated(problem)) return
      if (is_finite(value)) then
         if (abs(value) <= largest) return
      end if
      call fatal_error(problem, name//' = '//to_text(value)//' of the state is not allowed: '// &
         'it must be a number up to '//to_text(largest)//' in size', code_input)
   end subroutine check_size

end module asperity_c_restart
