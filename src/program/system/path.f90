!> Where paths lead.
module asperity_program_system_path
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_char, c_size_t
   use asperity_program_system_errno, only: last_reason
   use asperity_program_system_posix, only: c_access, c_readlink, c_realpath
   use asperity_program_system_strings, only: starts_with
   implicit none
   private
   public :: resolved_path, find_target, link_text, may_write

   integer(c_int), parameter :: write_access = 2_c_int
   integer, parameter :: longest_path = 4096
   !> Links followed one after the other, as many as Linux does
   integer, parameter :: most_links = 40

contains

   !> Absolute path without links, or nothing when there is no such file.
   function resolved_path(path) result(resolved)
      !> Any path
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: resolved
      character(len=longest_path) :: buffer

      resolved = ''
      if (.not. c_associated(c_realpath(path//c_null_char, buffer))) return
      resolved = buffer(:index(buffer, c_null_char) - 1)
   end function resolved_path

   !> Absolute path of a file to write, which need not be there yet: links are followed, also one
   !> that leads to nothing so far.
   subroutine find_target(path, target, reason)
      !> Any path
      character(len=*), intent(in) :: path
      !> Absolute path without links
      character(len=:), allocatable, intent(out) :: target
      !> Set when its folder is not there
      character(len=:), allocatable, intent(out) :: reason
      character(len=:), allocatable :: folder, next
      integer :: i, name

      target = resolved_path(path)
      if (target /= '') return
      next = path
      do i = 1, most_links
         name = index(next, '/', back=.true.) + 1
         folder = resolved_path('./')
         if (name > 1) folder = resolved_path(next(:name - 1))
         if (folder == '') then
            reason = 'the folder does not exist'
            return
         end if
         target = folder//'/'//next(name:)
         next = link_text(target)
         if (next == '') return
         if (.not. starts_with(next, '/')) next = folder//'/'//next
      end do
      reason = 'its links lead to each other'
   end subroutine find_target

   !> What a link says, or nothing when a path is none.
   function link_text(path) result(text)
      !> The path
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: text
      character(len=longest_path) :: buffer

      text = buffer(:int(c_readlink(path//c_null_char, buffer, int(longest_path, c_size_t))))
   end function link_text

   !> Set `reason` unless a file may be written, or files created in a folder.
   subroutine may_write(path, reason)
      !> Path of the file or folder
      character(len=*), intent(in) :: path
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      if (c_access(path//c_null_char, write_access) /= 0) reason = last_reason()
   end subroutine may_write

end module asperity_program_system_path
