!> Writes results so that a file is either complete or not there: everything goes to temporary files
!> in the same folders first, then all of them are renamed. Devices, pipes and open descriptors are
!> written directly, since renaming would replace them.
module asperity_program_system_atomic_files
   use, intrinsic :: iso_c_binding, only: c_int
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_program_system_file_facts, only: facts_of, facts_of_descriptor, file_facts
   use asperity_program_system_files, only: close_file, open_file, remove_file, rename_file, &
      standard_error, standard_output, write_text
   use asperity_program_system_part_file, only: close_part, create_part, free_name, part_file, &
      write_part
   use asperity_program_system_path, only: find_target, may_write, resolved_path
   use asperity_program_system_process, only: held_interrupts, hold_interrupts, release_interrupts
   use asperity_program_system_strings, only: starts_with
   implicit none
   private
   public :: output_file, open_target, write_files, write_standard_output

   !> One file to write.
   type :: output_file
      !> Option that asked for it, such as `--csv`
      character(len=:), allocatable :: option
      !> Path as given, and without links
      character(len=:), allocatable :: path, target
      !> What to write
      character(len=:), allocatable :: text
      !> Written without a temporary file
      logical :: is_device = .false.
      !> Temporary file; allocated while it is there
      character(len=:), allocatable :: part
      !> Descriptor that the path names, such as /dev/stdout
      integer(c_int), private :: descriptor = -1_c_int
   end type output_file

contains

   !> Prepare a file to write, before the work whose result it takes. `error` is set when it or its
   !> folder cannot be written.
   subroutine open_target(file, option, path, error)
      !> The file
      type(output_file), intent(out) :: file
      !> Option and path as given
      character(len=*), intent(in) :: option, path
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(file_facts) :: facts
      character(len=:), allocatable :: reason

      file%option = option
      file%path = path
      file%descriptor = descriptor_in(path)
      if (file%descriptor >= 0) then
         file%is_device = .true.
         file%target = path
         facts = facts_of_descriptor(file%descriptor)
         if (.not. facts%exists) call refuse(error, file, 'no such file is open')
         return
      end if
      call find_target(path, file%target, reason)
      if (.not. allocated(reason)) then
         facts = facts_of(file%target)
         file%is_device = facts%exists .and. .not. facts%is_regular
         if (resolved_path(file%target//'/') /= '') then
            reason = 'it is a folder'
         else if (facts%exists) then
            call may_write(file%target, reason)
         end if
      end if
      if (.not. (allocated(reason) .or. file%is_device)) &
         call may_write(file%target(:index(file%target, '/', back=.true.)), reason)
      if (allocated(reason)) call refuse(error, file, reason)
   end subroutine open_target

   !> The descriptor that a path names, or a negative number. Opened by its path, a file that
   !> standard output goes to would be emptied.
   pure integer(c_int) function descriptor_in(path) result(descriptor)
      character(len=*), intent(in) :: path
      character(len=*), parameter :: folders(2) = ['/dev/fd/      ', '/proc/self/fd/']
      character(len=:), allocatable :: number
      integer :: i, status

      descriptor = -1_c_int
      if (path == '/dev/stdout') descriptor = standard_output
      if (path == '/dev/stderr') descriptor = standard_error
      do i = 1, size(folders)
         if (.not. starts_with(path, trim(folders(i)))) cycle
         number = path(len_trim(folders(i)) + 1:)
         if (number == '' .or. verify(number, '0123456789') > 0) return
         read (number, *, iostat=status) descriptor
         if (status /= 0) descriptor = -1_c_int
      end do
   end function descriptor_in

   !> Write all files, or none but devices.
   subroutine write_files(files, error, is_ending)
      !> The files
      type(output_file), intent(inout) :: files(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> Whether the program is at its end: an interrupt meanwhile is then forgotten
      logical, intent(in), optional :: is_ending
      type(held_interrupts) :: held
      character(len=:), allocatable :: reason
      integer :: i

      call hold_interrupts(held)
      do i = 1, size(files)
         if (files(i)%is_device) cycle
         call write_file(files(i), reason)
         if (allocated(reason)) exit
      end do
      if (.not. allocated(reason)) then
         do i = 1, size(files)
            if (files(i)%is_device) cycle
            call rename_file(files(i)%part, files(i)%target, reason)
            if (allocated(reason)) exit
            deallocate (files(i)%part)
         end do
      end if
      if (allocated(reason)) call refuse(error, files(i), reason)
      do i = 1, size(files)
         if (allocated(files(i)%part)) call remove_file(files(i)%part)
      end do
      call release_interrupts(held, is_ending)

      do i = 1, size(files)
         if (allocated(error)) return
         if (.not. files(i)%is_device) cycle
         call write_device(files(i), reason)
         if (allocated(reason)) call refuse(error, files(i), reason)
      end do
   end subroutine write_files

   !> Write the text of a file into a temporary one.
   subroutine write_file(file, reason)
      type(output_file), intent(inout) :: file
      character(len=:), allocatable, intent(out) :: reason
      type(part_file) :: part
      character(len=:), allocatable :: late_reason

      part%path = free_name(file%target)
      call create_part(part, reason)
      if (allocated(reason)) return
      file%part = part%path
      call write_part(part, file%target, file%text, reason)
      call close_part(part, late_reason)
      if (.not. allocated(reason)) call move_alloc(late_reason, reason)
   end subroutine write_file

   !> Write the text of a file into a device, a pipe or an open descriptor.
   subroutine write_device(file, reason)
      type(output_file), intent(in) :: file
      character(len=:), allocatable, intent(out) :: reason
      character(len=:), allocatable :: late_reason
      integer(c_int) :: descriptor

      if (file%descriptor >= 0) then
         call write_text(file%descriptor, file%text, reason)
         return
      end if
      call open_file(file%target, descriptor, reason)
      if (allocated(reason)) return
      call write_text(descriptor, file%text, reason)
      call close_file(descriptor, late_reason)
      if (.not. allocated(reason)) call move_alloc(late_reason, reason)
   end subroutine write_device

   !> Write to standard output.
   subroutine write_standard_output(text, error)
      !> What to write
      character(len=*), intent(in) :: text
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: reason

      call write_text(standard_output, text, reason)
      if (allocated(reason)) call fatal_error(error, 'standard output cannot be written: '// &
         reason, file_error)
   end subroutine write_standard_output

   !> An error at a file.
   pure subroutine refuse(error, file, reason)
      type(error_type), allocatable, intent(out) :: error
      type(output_file), intent(in) :: file
      character(len=*), intent(in) :: reason

      call fatal_error(error, file%option//': '//file%path//' cannot be written: '//reason, &
         file_error)
   end subroutine refuse

end module asperity_program_system_atomic_files
