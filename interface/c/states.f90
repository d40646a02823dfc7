!> C interface: contact states. See asperity.h for what each function does.
module asperity_c_states
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int, c_loc, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_c_checks, only: answer, check_pointer, check_points, clear_handle, content_of, &
      free_handle, wrap
   use asperity_c_contents, only: content_at
   use asperity_c_types, only: code_length, error_struct, tag_states
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_contact_points, only: contact_states, set_contact_state
   use asperity_contact_state, only: contact_state
   implicit none
   private
   public :: asperity_states_new, asperity_states_free, asperity_states_copy, &
      asperity_states_count, make_room, states_of

contains

   !> Fresh states of n points.
   integer(c_int) function asperity_states_new(states, n, error) result(code) &
         bind(c, name='asperity_states_new')
      !> Pointer to the handle, which is NULL after an error
      type(c_ptr), value :: states
      !> Number of points
      integer(c_int), value :: n
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(c_ptr), pointer :: handle
      type(contact_states), pointer :: content
      type(error_type), allocatable :: problem
      logical :: starved

      starved = .false.
      call clear_handle(problem, 'states', states, handle)
      call check_points(problem, n)
      if (.not. allocated(problem)) then
         call make_states(n, content, starved)
         if (.not. starved) call wrap(tag_states, c_loc(content), handle, starved)
         if (starved .and. associated(content)) deallocate (content)
      end if
      code = answer(problem, error, starved)
   end function asperity_states_new

   !> Free states and set their handle to NULL. NULL at either place is fine.
   integer(c_int) function asperity_states_free(states, error) result(code) &
         bind(c, name='asperity_states_free')
      !> Pointer to the handle
      type(c_ptr), intent(inout), optional :: states
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: content
      type(error_type), allocatable :: problem

      if (present(states)) then
         call states_of(problem, 'states', states, content, null_passes=.true.)
         if (associated(content)) then
            deallocate (content)
            call free_handle(states)
         end if
      end if
      code = answer(problem, error)
   end function asperity_states_free

   !> Copy the states of all points to other states of the same number.
   integer(c_int) function asperity_states_copy(from, to, error) result(code) &
         bind(c, name='asperity_states_copy')
      !> Handles
      type(c_ptr), value :: from, to
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: source, target
      type(error_type), allocatable :: problem
      logical :: starved

      starved = .false.
      call states_of(problem, 'from', from, source)
      call states_of(problem, 'to', to, target)
      if (.not. allocated(problem)) then
         if (size(source%status) /= size(target%status)) then
            call fatal_error(problem, 'from has '//to_text(size(source%status))// &
               ' points, to has '//to_text(size(target%status))//': only equal numbers are '// &
               'copied', code_length)
         else if (.not. associated(source, target)) then
            call make_room(target, starved, allocated(source%motion_share), &
               allocated(source%summit_slip))
            if (.not. starved) call copy_states(source, target)
         end if
      end if
      code = answer(problem, error, starved)
   end function asperity_states_copy

   !> Number of points.
   integer(c_int) function asperity_states_count(states, n, error) result(code) &
         bind(c, name='asperity_states_count')
      !> Handle
      type(c_ptr), value :: states
      !> Where the number goes
      type(c_ptr), value :: n
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_states), pointer :: content
      type(error_type), allocatable :: problem
      integer(c_int), pointer :: count

      call states_of(problem, 'states', states, content)
      call check_pointer(problem, 'n', n, alignment=4)
      if (.not. allocated(problem)) then
         call c_f_pointer(n, count)
         count = size(content%status, kind=c_int)
      end if
      code = answer(problem, error)
   end function asperity_states_count

   !> The states of a handle; a problem and no association when it is none.
   subroutine states_of(problem, name, handle, content, null_passes)
      !> Set when the handle is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Name of the argument
      character(len=*), intent(in) :: name
      !> Handle
      type(c_ptr), intent(in) :: handle
      !> Its states
      type(contact_states), pointer, intent(out) :: content
      !> NULL is no problem
      logical, intent(in), optional :: null_passes
      type(c_ptr) :: address

      nullify (content)
      call content_of(problem, name, handle, tag_states, address, null_passes)
      if (.not. allocated(problem)) call content_at(address, content)
   end subroutine states_of

   !> As `new_contact_states`, which stops the program where memory ends.
   subroutine make_states(n, states, starved)
      integer(c_int), intent(in) :: n
      type(contact_states), pointer, intent(out) :: states
      logical, intent(out) :: starved
      integer :: status

      allocate (states, stat=status)
      if (status /= 0) then
         nullify (states)
      else
         allocate (states%status(n), stat=status)
         if (status == 0) allocate (states%validity(n), stat=status)
         if (status == 0) allocate (states%overclosure(n), stat=status)
         if (status == 0) allocate (states%pressure(n), stat=status)
         if (status == 0) allocate (states%normal_energy(n), stat=status)
         if (status == 0) allocate (states%elastic_slip(n, 2), stat=status)
         if (status == 0) allocate (states%largest_closure(n), stat=status)
         if (status == 0) allocate (states%dissipation(n), stat=status)
         if (status == 0) allocate (states%pressure_coupling(n), stat=status)
      end if
      starved = status /= 0
      if (.not. starved) call clear_states(states)
   end subroutine make_states

   !> Room for what friction that is not plain remembers, zeros at first, where there is none yet.
   subroutine make_room(states, starved, for_friction, for_summits)
      !> States of a number of points
      type(contact_states), intent(inout) :: states
      !> There was no memory
      logical, intent(out) :: starved
      !> For the motion share and the turn of the grain, and for the elastic slips of summits
      logical, intent(in) :: for_friction, for_summits
      integer :: status

      status = 0
      associate (n => size(states%status))
         if (for_friction .and. .not. allocated(states%motion_share)) then
            allocate (states%grain_turn(n), source=0.0_wp, stat=status)
            if (status == 0) allocate (states%motion_share(n), source=0.0_wp, stat=status)
            if (status /= 0 .and. allocated(states%grain_turn)) deallocate (states%grain_turn)
         end if
         if (status == 0 .and. for_summits .and. .not. allocated(states%summit_slip)) &
            allocate (states%summit_slip(n, 2, most_stick_elements), source=0.0_wp, stat=status)
      end associate
      starved = status /= 0
   end subroutine make_room

   pure subroutine clear_states(states)
      type(contact_states), intent(inout) :: states
      integer :: i

      do i = 1, size(states%status)
         call set_contact_state(states, i, contact_state())
      end do
   end subroutine clear_states

   !> Array by array, so that nothing is allocated.
   pure subroutine copy_states(from, to)
      type(contact_states), intent(in) :: from
      type(contact_states), intent(inout) :: to

      to%status(:) = from%status
      to%overclosure(:) = from%overclosure
      to%pressure(:) = from%pressure
      to%normal_energy(:) = from%normal_energy
      to%elastic_slip(:, :) = from%elastic_slip
      to%largest_closure(:) = from%largest_closure
      to%dissipation(:) = from%dissipation
      to%pressure_coupling(:) = from%pressure_coupling
      to%validity(:) = from%validity
      if (allocated(from%motion_share)) then
         to%motion_share(:) = from%motion_share
         to%grain_turn(:) = from%grain_turn
      else if (allocated(to%motion_share)) then
         to%motion_share(:) = 0.0_wp
         to%grain_turn(:) = 0.0_wp
      end if
      if (allocated(from%summit_slip)) then
         to%summit_slip(:, :, :) = from%summit_slip
      else if (allocated(to%summit_slip)) then
         to%summit_slip(:, :, :) = 0.0_wp
      end if
   end subroutine copy_states

end module asperity_c_states
