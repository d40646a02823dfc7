!> C interface: the states of points, for a restart. See asperity.h for what each function does.
module asperity_c_restart
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_c_checks, only: answer, check_pointer, check_points
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

   !> States of points, counted from 0.
   integer(c_int) function asperity_states_get(states, first, n, state, error) result(code) &
         bind(c, name='asperity_states_get')
      !> Handle
      type(c_ptr), value :: states
      !> Number of the first point, and how many
      integer(c_int), value :: first, n
      !> Structs to fill
      type(c_ptr), value :: state
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: content
      type(state_struct), pointer, contiguous :: places(:)
      type(error_type), allocatable :: problem
      integer :: i

      call view_points(problem, states, first, n, state, content, places)
      if (.not. allocated(problem)) then
         do i = 1, n
            associate (s => get_contact_state(content, first + i))
               places(i) = state_struct(s%status, s%validity, s%overclosure, s%pressure, &
                  s%normal_energy, s%elastic_slip, s%largest_closure, s%dissipation, &
                  s%pressure_coupling, s%motion_share, s%grain_turn, s%summit_slip)
            end associate
         end do
      end if
      code = answer(problem, error)
   end function asperity_states_get

   !> Set the states of points, counted from 0.
   integer(c_int) function asperity_states_set(states, first, n, state, error) result(code) &
         bind(c, name='asperity_states_set')
      !> Handle
      type(c_ptr), value :: states
      !> Number of the first point, and how many
      integer(c_int), value :: first, n
      !> Their new states
      type(c_ptr), value :: state
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: content
      type(state_struct), pointer, contiguous :: places(:)
      type(error_type), allocatable :: problem
      logical :: starved, has_friction, has_summits
      integer :: i

      starved = .false.
      call view_points(problem, states, first, n, state, content, places)
      has_friction = .false.
      has_summits = .false.
      if (.not. allocated(problem)) then
         do i = 1, n
            call check_state(problem, i, places(i))
            if (allocated(problem)) exit
            has_friction = has_friction &
               .or. max(abs(places(i)%motion_share), abs(places(i)%grain_turn)) > 0.0_wp
            has_summits = has_summits .or. any(abs(places(i)%summit_slip) > 0.0_wp)
         end do
      end if
      if (.not. allocated(problem)) call make_room(content, starved, has_friction, has_summits)
      if (.not. (allocated(problem) .or. starved)) then
         do i = 1, n
            associate (s => places(i))
               call set_contact_state(content, first + i, contact_state(s%status, s%overclosure, &
                  s%pressure, s%normal_energy, s%elastic_slip, s%largest_closure, s%dissipation, &
                  s%pressure_coupling, s%validity, s%motion_share, s%grain_turn, s%summit_slip))
            end associate
         end do
      end if
      code = answer(problem, error, starved)
   end function asperity_states_set

   !> The states and the caller's structs, unless a handle, the structs or a point is not there.
   subroutine view_points(problem, states, first, n, state, content, places)
      type(error_type), allocatable, intent(inout) :: problem
      type(c_ptr), intent(in) :: states, state
      integer(c_int), intent(in) :: first, n
      type(contact_states), pointer, intent(out) :: content
      type(state_struct), pointer, contiguous, intent(out) :: places(:)

      nullify (places)
      call states_of(problem, 'states', states, content)
      call check_points(problem, n)
      if (n > 0) call check_pointer(problem, 'state', state)
      if (allocated(problem)) return
      if (first < 0 .or. first > size(content%status) - n) then
         call fatal_error(problem, 'first = '//to_text(first)//' and n = '//to_text(n)//' go '// &
            'beyond the points: the states have '//to_text(size(content%status))// &
            ', counted from 0', code_length)
      else
         call c_f_pointer(state, places, [n])
      end if
   end subroutine view_points

   !> Refuse what no update can have left behind.
   subroutine check_state(problem, place, state)
      type(error_type), allocatable, intent(inout) :: problem
      !> Where the state stands in the caller's array, from 1
      integer, intent(in) :: place
      type(state_struct), intent(in) :: state
      integer :: i, j

      call check_size('overclosure', state%overclosure, largest_length)
      call check_size('pressure', state%pressure, largest_energy)
      call check_size('normal_energy', state%normal_energy, largest_energy)
      call check_size('elastic_slip[0]', state%elastic_slip(1), largest_length)
      call check_size('elastic_slip[1]', state%elastic_slip(2), largest_length)
      call check_size('largest_closure', state%largest_closure, largest_length)
      call check_size('dissipation', state%dissipation, largest_energy)
      call check_size('pressure_coupling', state%pressure_coupling, largest_energy)
      call check_size('motion_share', state%motion_share, 1.0_wp)
      call check_size('grain_turn', state%grain_turn, largest_length)
      do j = 1, most_stick_elements
         do i = 1, 2
            ! its text is made only where it is needed: there may be many points
            if (is_within(state%summit_slip(i, j), largest_length)) cycle
            call check_size('summit_slip['//to_text(j - 1)//']['//to_text(i - 1)//']', &
               state%summit_slip(i, j), largest_length)
         end do
      end do
      if (allocated(problem)) return
      if (state%status < status_unset .or. state%status > status_slip) then
         call refuse('status = '//to_text(state%status), 'one of enum asperity_status, '// &
            to_text(status_unset)//' to '//to_text(status_slip))
      else if (state%validity < valid .or. state%validity > all_flags) then
         call refuse('validity = '//to_text(state%validity), 'a sum of flags, 0 to '// &
            to_text(all_flags))
      else if (state%pressure < 0.0_wp) then
         call refuse('pressure = '//to_text(state%pressure)//' MPa', 'zero or more')
      else if (state%largest_closure < state%overclosure) then
         call refuse('largest_closure = '//to_text(state%largest_closure)//' mm', &
            'the overclosure, '//to_text(state%overclosure)//' mm, or more')
      else if (state%motion_share < 0.0_wp) then
         call refuse('motion_share = '//to_text(state%motion_share), '0, at rest, to 1, in motion')
      end if

   contains

      subroutine check_size(name, value, largest)
         character(len=*), intent(in) :: name
         real(wp), intent(in) :: value, largest

         if (allocated(problem)) return
         if (.not. is_within(value, largest)) call refuse(name//' = '//to_text(value), &
            'a number up to '//to_text(largest)//' in size')
      end subroutine check_size

      subroutine refuse(what, allowed)
         character(len=*), intent(in) :: what, allowed

         call fatal_error(problem, what//' of state['//to_text(place - 1)//'] is not allowed: '// &
            'it must be '//allowed, code_input)
      end subroutine refuse

   end subroutine check_state

   !> Whether a value is a number up to a size.
   elemental logical function is_within(value, largest)
      real(wp), intent(in) :: value, largest

      is_within = is_finite(value)
      if (is_within) is_within = abs(value) <= largest
   end function is_within

end module asperity_c_restart
