!> Shared libraries that are opened when they are needed, by dlopen. Constants are those of Linux
!> with glibc.
module asperity_replay_shared_library
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_funptr, c_int, &
      c_null_char, c_null_funptr, c_null_ptr, c_ptr
   use asperity_base_libc, only: c_strlen
   implicit none
   private
   public :: shared_library, open_library, find_data, find_procedure

   !> An open library; it stays open until the program ends.
   type :: shared_library
      !> Its handle
      type(c_ptr) :: handle = c_null_ptr
   end type shared_library

   !> Modes of dlopen: all symbols are resolved at once
   integer(c_int), parameter :: now = int(z'2', c_int)
   !> The library's own symbols go before those of the program
   integer(c_int), parameter :: own_first = int(z'8', c_int)
   !> Libraries that are opened later find its symbols
   integer(c_int), parameter :: for_all = int(z'100', c_int)

   interface
      type(c_ptr) function c_dlopen(path, mode) bind(c, name='dlopen')
         import :: c_char, c_int, c_ptr
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
      end function c_dlopen
      type(c_ptr) function c_dlsym(library, name) bind(c, name='dlsym')
         import :: c_char, c_ptr
         type(c_ptr), value :: library
         character(kind=c_char), intent(in) :: name(*)
      end function c_dlsym
      type(c_ptr) function c_dlerror() bind(c, name='dlerror')
         import :: c_ptr
      end function c_dlerror
   end interface

contains

   !> Open a library. `failure` is set when it cannot be opened.
   subroutine open_library(path, library, failure, is_global)
      !> Path of its file; a name without a slash is looked for where the system has libraries
      character(len=*), intent(in) :: path
      !> The library
      type(shared_library), intent(out) :: library
      !> The reason
      character(len=:), allocatable, intent(out) :: failure
      !> Whether libraries opened later find its symbols; if not, its own go before all others'
      logical, intent(in), optional :: is_global
      integer(c_int) :: mode

      mode = ior(now, own_first)
      if (present(is_global)) then
         if (is_global) mode = ior(now, for_all)
      end if
      library%handle = c_dlopen(path//c_null_char, mode)
      if (.not. c_associated(library%handle)) failure = last_failure()
   end subroutine open_library

   !> Address of something of a library; null when it has no such name.
   subroutine find_data(library, name, found)
      !> The library
      type(shared_library), intent(in) :: library
      !> The name as the linker has it
      character(len=*), intent(in) :: name
      !> Its address
      type(c_ptr), intent(out) :: found

      found = c_dlsym(library%handle, name//c_null_char)
   end subroutine find_data

   !> Address of a procedure of a library; null when it has no such name.
   subroutine find_procedure(library, name, found)
      !> The library
      type(shared_library), intent(in) :: library
      !> The name as the linker has it
      character(len=*), intent(in) :: name
      !> Its address
      type(c_funptr), intent(out) :: found

      found = transfer(c_dlsym(library%handle, name//c_null_char), c_null_funptr)
   end subroutine find_procedure

   !> Why the last library could not be opened.
   function last_failure() result(text)
      character(len=:), allocatable :: text
      character(kind=c_char), pointer :: letters(:)
      type(c_ptr) :: message
      integer :: i

      message = c_dlerror()
      text = 'unknown reason'
      if (.not. c_associated(message)) return
      call c_f_pointer(message, letters, [c_strlen(message)])
      text = repeat(' ', size(letters))
      do i = 1, size(letters)
         text(i:i) = letters(i)
      end do
   end function last_failure

end module asperity_replay_shared_library
