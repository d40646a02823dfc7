!> What every function of the C interface checks of its arguments, and how it answers.
!> A problem is an `error_type` whose category is the result code.
module asperity_c_checks
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_int64_t, &
      c_intptr_t, c_loc, c_null_char, c_null_ptr, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_c_types, only: code_handle, code_input, code_length, code_memory, code_null, &
      code_ok, error_struct, handle_object, message_length
   implicit none
   private
   public :: answer, check_pointer, check_points, clear_handle, content_of, copy_text, &
      free_handle, number_of, wrap

   !> Alignment of every handle and struct, and of arrays of double
   integer, parameter, public :: word = 8

contains

   !> Fill the caller's error struct, if there is one, and return the code.
   integer(c_int) function answer(problem, error, starved) result(code)
      !> Unset on success
      type(error_type), allocatable, intent(in) :: problem
      !> The caller's struct
      type(error_struct), intent(inout), optional :: error
      !> There was not enough memory, for a `problem` neither
      logical, intent(in), optional :: starved

      code = code_ok
      if (present(starved)) code = merge(code_memory, code_ok, starved)
      if (allocated(problem)) code = int(problem%category, c_int)
      if (.not. present(error)) return
      error%code = code
      if (allocated(problem)) then
         call copy_text(problem%message, error%message)
      else if (code == code_memory) then
         call copy_text('not enough memory', error%message)
      else
         call copy_text('', error%message)
      end if
   end function answer

   !> Copy a text and a NUL to a buffer; a text that is too long ends with three dots.
   pure subroutine copy_text(text, buffer)
      !> Fortran text
      character(len=*), intent(in) :: text
      !> At least one character; nothing is written after the NUL
      character(kind=c_char), intent(inout) :: buffer(:)
      integer :: i, length

      length = min(len(text), size(buffer) - 1)
      do i = 1, length
         buffer(i) = text(i:i)
      end do
      if (length < len(text)) buffer(max(length - 2, 1):length) = '.'
      buffer(length + 1) = c_null_char
   end subroutine copy_text

   !> Address as a number.
   pure integer(c_intptr_t) function number_of(address)
      !> Any address
      type(c_ptr), intent(in) :: address

      number_of = transfer(address, number_of)
   end function number_of

   !> Refuse NULL and, as reading it may stop the processor, what no compiler would align so.
   subroutine check_pointer(problem, name, address, alignment)
      !> Set when the pointer is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Name of the argument; blanks may follow
      character(len=*), intent(in) :: name
      !> The pointer
      type(c_ptr), intent(in) :: address
      !> Bytes; 8 when absent
      integer, intent(in), optional :: alignment
      integer :: bytes

      if (allocated(problem)) return
      bytes = word
      if (present(alignment)) bytes = alignment
      if (.not. c_associated(address)) then
         call fatal_error(problem, trim(name)//' is NULL: it must point to something', code_null)
      else if (modulo(number_of(address), int(bytes, c_intptr_t)) /= 0) then
         call fatal_error(problem, trim(name)//' is not aligned to '//to_text(bytes)//' bytes', &
            code_input)
      end if
   end subroutine check_pointer

   !> The caller's handle that a new law or new states go to, set to NULL.
   subroutine clear_handle(problem, name, address, handle)
      !> Set when there is no place for it
      type(error_type), allocatable, intent(inout) :: problem
      !> Name of the argument
      character(len=*), intent(in) :: name
      !> Where the caller has the handle
      type(c_ptr), intent(in) :: address
      !> The handle
      type(c_ptr), pointer, intent(out) :: handle

      nullify (handle)
      call check_pointer(problem, name, address)
      if (allocated(problem)) return
      call c_f_pointer(address, handle)
      handle = c_null_ptr
   end subroutine clear_handle

   !> Content of a handle; NULL and a problem when it is not of that kind.
   subroutine content_of(problem, name, address, tag, content, null_passes)
      !> Set when the handle is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Name of the argument
      character(len=*), intent(in) :: name
      !> The handle
      type(c_ptr), intent(in) :: address
      !> Its kind
      integer(c_int64_t), intent(in) :: tag
      !> What it holds
      type(c_ptr), intent(out) :: content
      !> NULL is no problem; false when absent
      logical, intent(in), optional :: null_passes
      type(handle_object), pointer :: handle

      content = c_null_ptr
      if (present(null_passes)) then
         if (null_passes .and. .not. c_associated(address)) return
      end if
      call check_pointer(problem, name, address)
      if (allocated(problem)) return
      call c_f_pointer(address, handle)
      if (handle%tag == tag) then
         content = handle%content
      else
         call fatal_error(problem, name//' is a handle of another kind, or none at all', &
            code_handle)
      end if
   end subroutine content_of

   !> Put a handle around a law or states.
   subroutine wrap(tag, content, address, starved)
      !> Kind of handle
      integer(c_int64_t), intent(in) :: tag
      !> What it holds
      type(c_ptr), intent(in) :: content
      !> The handle
      type(c_ptr), intent(inout) :: address
      !> There was no memory
      logical, intent(out) :: starved
      type(handle_object), pointer :: handle
      integer :: status

      allocate (handle, stat=status)
      starved = status /= 0
      if (starved) return
      handle%tag = tag
      handle%content = content
      address = c_loc(handle)
   end subroutine wrap

   !> Give back the memory of a handle, not of what it holds, and set it to NULL.
   subroutine free_handle(address)
      !> A handle that has been checked
      type(c_ptr), intent(inout) :: address
      type(handle_object), pointer :: handle

      call c_f_pointer(address, handle)
      deallocate (handle)
      address = c_null_ptr
   end subroutine free_handle

   !> Refuse a number of points that is negative or not the one of the states.
   subroutine check_points(problem, n, points)
      !> Set when it is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Number of points that the caller gave
      integer(c_int), intent(in) :: n
      !> Number of points of the states
      integer, intent(in), optional :: points

      if (allocated(problem)) return
      if (n < 0) then
         call fatal_error(problem, 'n = '//to_text(n)//' is not allowed: a number of points '// &
            'is zero or more', code_length)
      else if (present(points)) then
         if (n /= points) call fatal_error(problem, 'n = '//to_text(n)//' does not fit: the '// &
            'states have '//to_text(points)//' points', code_length)
      end if
   end subroutine check_points

end module asperity_c_checks
