!> Writes results so that a file is either complete or not there: everything goes to FILE.part
!> in the same folder first, then all of them are renamed. Targets below /dev and /proc are
!> written directly, since renaming would replace the device.
module app_output
   use, intrinsic :: iso_c_binding, only: c_int
   use asperity, only: error_type, file_error
   use asperity_error, only: fatal_error
   use app_system, only: close_file, create_file, held_interrupts, hold_interrupts, may_write, &
      release_interrupts, remove_file, rename_file, resolved_path, standard_output, write_text
   use app_strings, only: starts_with
   implicit none
   private
   public :: output_file, open_target, write_files, discard_files, write_standard_output

   !> One file to write.
   type :: output_file
      !> Option that asked for it, such as `--csv`
      character(len=:), allocatable :: option
      !> Path as given
      character(len=:), allocatable :: path
      !> Path without links, and its temporary name
      character(len=:), allocatable :: target, part
      !> What to write
      character(len=:), allocatable :: text
      !> Below /dev or /proc: written without a temporary name
      logical :: is_device = .false.
      !> The temporary file is complete
      logical :: staged = .false.
   end type output_file

contains

   !> Prepare a file to write, before the work whose result it takes. `error` is set when its
   !> folder is not there or cannot be written.
   subroutine open_target(file, option, path, error)
      !> The file
      type(output_file), intent(out) :: file
      !> Option and path as given
      character(len=*), intent(in) :: option, path
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: folder, reason
      integer :: name

      file%option = option
      file%path = path
      file%target = resolved_path(path)
      if (file%target == '') then
         ! A new file, in a folder that must be there
         name = index(path, '/', back=.true.) + 1
         folder = resolved_path('./')
         if (name > 1) folder = resolved_path(path(:name - 1))
         if (folder == '') then
            call refuse(error, file, 'the folder does not exist')
            return
         end if
         file%target = folder//'/'//path(name:)
      end if
      if (resolved_path(file%target//'/') /= '') then
         call refuse(error, file, 'it is a folder')
         return
      end if
      file%is_device = starts_with(file%target, '/dev/') .or. starts_with(file%target, '/proc/')
      file%part = file%target//'.part'
      if (file%is_device) return
      call may_write(file%target(:index(file%target, '/', back=.true.)), reason)
      if (allocated(reason)) call refuse(error, file, reason)
   end subroutine open_target

   !> Write all files, or none but devices. Those already staged are only renamed.
   subroutine write_files(files, error)
      !> The files
      type(output_file), intent(inout) :: files(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(held_interrupts) :: held
      character(len=:), allocatable :: reason
      integer :: i

      call hold_interrupts(held)
      do i = 1, size(files)
         if (files(i)%is_device .or. files(i)%staged) cycle
         call write_file(files(i), files(i)%part, error)
         if (allocated(error)) exit
      end do
      do i = 1, size(files)
         if (allocated(error)) exit
         if (.not. files(i)%staged) cycle
         call rename_file(files(i)%part, files(i)%target, reason)
         if (allocated(reason)) then
            call refuse(error, files(i), reason)
         else
            files(i)%staged = .false.
         end if
      end do
      call discard_files(files)
      call release_interrupts(held)

      do i = 1, size(files)
         if (allocated(error)) return
         if (files(i)%is_device) call write_file(files(i), files(i)%target, error)
      end do
   end subroutine write_files

   !> Remove temporary files.
   subroutine discard_files(files)
      !> The files
      type(output_file), intent(inout) :: files(:)
      integer :: i

      do i = 1, size(files)
         if (files(i)%staged) call remove_file(files(i)%part)
         files(i)%staged = .false.
      end do
   end subroutine discard_files

   !> Write the text of a file under some name; it is staged as soon as it exists.
   subroutine write_file(file, name, error)
      type(output_file), intent(inout) :: file
      character(len=*), intent(in) :: name
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: reason, late_reason
      integer(c_int) :: descriptor

      call create_file(name, descriptor, reason)
      if (.not. allocated(reason)) then
         file%staged = .not. file%is_device
         call write_text(descriptor, file%text, reason)
         call close_file(descriptor, late_reason)
         if (allocated(late_reason) .and. .not. allocated(reason)) reason = late_reason
      end if
      if (allocated(reason)) call refuse(error, file, reason)
   end subroutine write_file

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

end module app_output
