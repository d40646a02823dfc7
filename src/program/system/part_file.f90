!> Temporary files: beside the file that they become, under a name that nobody else has.
module asperity_program_system_part_file
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_char, c_null_ptr, c_ptr
   use asperity_base_libc, only: c_fclose, c_fopen
   use asperity_base_number_text, only: to_text
   use asperity_program_system_errno, only: einval, last_error, last_reason
   use asperity_program_system_file_facts, only: facts_of, facts_of_link, file_facts
   use asperity_program_system_files, only: write_text
   use asperity_program_system_posix, only: c_fchmod, c_fchown, c_fileno, c_fsync, c_getpid
   implicit none
   private
   public :: part_file, free_name, create_part, write_part, close_part

   !> Bytes of the target's name in that of its temporary file: names have 255 at most
   integer, parameter :: longest_stem = 200
   !> An owner or group that is not to be changed
   integer(c_int), parameter :: the_same = -1_c_int

   !> An open temporary file.
   type :: part_file
      !> Its path
      character(len=:), allocatable :: path
      type(c_ptr), private :: stream = c_null_ptr
   end type part_file

contains

   !> Create a temporary file, which must not be there: neither a file nor a link of the user's is
   !> touched.
   subroutine create_part(part, reason)
      !> The file, with its path
      type(part_file), intent(inout) :: part
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      part%stream = c_fopen(part%path//c_null_char, 'wx'//c_null_char)
      if (.not. c_associated(part%stream)) reason = last_reason()
   end subroutine create_part

   !> Path of a temporary file: `NAME.PROCESS.part` beside the target, numbered if that is left of
   !> an earlier process.
   function free_name(target) result(path)
      !> Absolute path of the file that it becomes
      character(len=*), intent(in) :: target
      character(len=:), allocatable :: path
      character(len=:), allocatable :: stem
      integer :: i, first

      first = index(target, '/', back=.true.) + 1
      stem = target(:min(len(target), first + longest_stem - 1))//'.'//to_text(int(c_getpid()))
      path = stem//'.part'
      i = 0
      do
         associate (found => facts_of_link(path))
            if (.not. found%exists) exit
         end associate
         i = i + 1
         path = stem//'-'//to_text(i)//'.part'
      end do
   end function free_name

   !> Give the file the rights of the one that it replaces, and write all of a text to the disk.
   subroutine write_part(part, target, text, reason)
      !> The file
      type(part_file), intent(in) :: part
      !> Absolute path of the file that it becomes
      character(len=*), intent(in) :: target
      !> The text
      character(len=*), intent(in) :: text
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason
      integer(c_int) :: file

      file = c_fileno(part%stream)
      call take_rights(file, facts_of(target))
      call write_text(file, text, reason)
      if (allocated(reason)) return
      ! A few file systems cannot do that for any file
      if (c_fsync(file) == 0) return
      if (last_error() /= einval) reason = last_reason()
   end subroutine write_part

   !> Give an open file the rights of another, where there are any: some file systems have none.
   !> Only root gives files away; who may write the other as one of its group can give that.
   subroutine take_rights(file, other)
      integer(c_int), intent(in) :: file
      type(file_facts), intent(in) :: other
      integer(c_int) :: status

      if (.not. other%exists) return
      status = c_fchown(file, other%owner, other%group)
      if (status /= 0) status = c_fchown(file, the_same, other%group)
      status = c_fchmod(file, other%rights)
      if (status /= 0) return
   end subroutine take_rights

   !> Close a temporary file; some systems report only here that the disk is full.
   subroutine close_part(part, reason)
      !> The file
      type(part_file), intent(inout) :: part
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      if (c_fclose(part%stream) /= 0) reason = last_reason()
      part%stream = c_null_ptr
   end subroutine close_part

end module asperity_program_system_part_file
