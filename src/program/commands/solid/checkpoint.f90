!> The file from which a solid joint goes on after an interruption: one for each contact model,
!> written after every stroke, whole or not at all.
module asperity_program_commands_solid_checkpoint
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_kinds, only: wp
   use asperity_base_version, only: version
   use asperity_program_commands_solid_snapshot, only: solid_snapshot
   use asperity_program_commands_solid_snapshots_file, only: read_snapshots, write_snapshots
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_print_case, only: case_heading, case_text
   use asperity_program_system_atomic_files, only: open_target, output_file
   use asperity_program_system_checksum, only: checksum
   use asperity_program_system_files, only: remove_file, rename_file
   use asperity_program_system_process, only: held_interrupts, hold_interrupts, release_interrupts
   use asperity_program_system_strings, only: newline
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_solve_checkpoint, only: read_run, write_run
   use asperity_solid_solve_programme, only: solid_run
   implicit none
   private
   public :: checkpoint_file, is_there, name_checkpoints

   !> A checkpoint.
   type :: checkpoint_file
      !> Its path
      character(len=:), allocatable :: path
      !> Version and input, which tell one joint from another
      character(len=:), allocatable :: head
   contains
      procedure :: check_place, save, load, remove
   end type checkpoint_file

   character(len=*), parameter :: part = '.part'

contains

   !> Whether there is a file.
   logical function is_there(path)
      !> Its path
      character(len=*), intent(in) :: path

      inquire (file=path, exist=is_there)
   end function is_there

   !> `error` is set when the file cannot be written.
   subroutine check_place(self, error)
      !> The file
      class(checkpoint_file), intent(in) :: self
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: file

      call open_target(file, '--checkpoint', self%path, error)
   end subroutine check_place

   !> Write the file.
   subroutine save(self, run, snapshots, seconds, error)
      !> The file
      class(checkpoint_file), intent(in) :: self
      !> The run, between two strokes
      type(solid_run), intent(in) :: run
      !> What was looked at
      type(solid_snapshot), intent(in) :: snapshots(:)
      !> Time that it took, s
      real(wp), intent(in) :: seconds
      !> Set when it cannot be written
      type(error_type), allocatable, intent(out) :: error
      type(held_interrupts) :: held
      character(len=:), allocatable :: reason
      character(len=256) :: message
      integer(int64) :: next, bytes
      integer :: unit, status, late_status

      message = 'the disk may be full'
      call hold_interrupts(held)
      open (newunit=unit, file=self%path//part, access='stream', form='unformatted', &
         status='replace', action='write', iostat=status, iomsg=message)
      if (status == 0) then
         write (unit, iostat=status, iomsg=message) len(self%head), self%head, seconds
         if (status == 0) call write_run(unit, run, status)
         if (status == 0) call write_snapshots(unit, snapshots, status)
         inquire (unit, pos=next)
         close (unit, iostat=late_status)
         if (status == 0) status = late_status
         ! a full disk need not be noticed by then
         inquire (file=self%path//part, size=bytes)
         if (bytes /= next - 1) status = 1
         if (status == 0) call rename_file(self%path//part, self%path, reason)
         if (status /= 0 .or. allocated(reason)) call remove_file(self%path//part)
      end if
      call release_interrupts(held)
      if (status /= 0) reason = trim(message)
      if (allocated(reason)) call fatal_error(error, 'checkpoint '//self%path// &
         ' cannot be written: '//reason, file_error)
   end subroutine save

   !> Read the file into a run at its beginning.
   subroutine load(self, run, snapshots, seconds, error)
      !> The file
      class(checkpoint_file), intent(in) :: self
      !> The run
      type(solid_run), intent(inout) :: run
      !> What was looked at
      type(solid_snapshot), allocatable, intent(out) :: snapshots(:)
      !> Time that it took, s
      real(wp), intent(out) :: seconds
      !> Set when it cannot be read or is of another joint
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: head
      character(len=256) :: message
      integer(int64) :: bytes
      integer :: unit, status, length
      logical :: is_ours

      is_ours = .true.
      seconds = 0.0_wp
      message = 'it is not complete'
      open (newunit=unit, file=self%path, access='stream', form='unformatted', status='old', &
         action='read', iostat=status, iomsg=message)
      if (status == 0) then
         inquire (unit, size=bytes)
         read (unit, iostat=status) length
         if (status == 0) is_ours = length == len(self%head) .and. bytes > length
         if (status == 0 .and. is_ours) then
            allocate (character(len=length) :: head)
            read (unit, iostat=status) head
            if (status == 0) is_ours = head == self%head
         end if
         if (status == 0 .and. is_ours) read (unit, iostat=status) seconds
         if (status == 0 .and. is_ours) call read_run(unit, run, status)
         if (status == 0 .and. is_ours) &
            call read_snapshots(unit, size(run%model%points, 2), snapshots, status)
         close (unit)
      end if
      if (.not. is_ours) then
         call fatal_error(error, 'checkpoint '//self%path//' is of another case or version: '// &
            'run that one, or remove the file and begin without --resume', subject='checkpoint')
      else if (status /= 0) then
         call fatal_error(error, 'checkpoint '//self%path//' cannot be read: '//trim(message), &
            file_error)
      end if
   end subroutine load

   !> Remove the file.
   subroutine remove(self)
      !> The file
      class(checkpoint_file), intent(in) :: self

      call remove_file(self%path)
   end subroutine remove

   !> Name the checkpoints of the models. `error` is set when one cannot be written, when one is
   !> there that is not to be gone on from, when there is none that is, and when a rank has another
   !> case or finds other checkpoints than the first one.
   subroutine name_checkpoints(files, stem, names, command, resumes, keys, ranks, error)
      !> The checkpoints, one for each model
      type(checkpoint_file), intent(inout) :: files(:)
      !> How their paths begin; the command unless given
      character(len=:), allocatable, intent(inout) :: stem
      !> Names of the models, and of the command
      character(len=*), intent(in) :: names(:), command
      !> Whether to go on from them
      logical, intent(in) :: resumes
      !> The input
      type(key_list), intent(in) :: keys
      !> The ranks, of which the first writes
      type(rank_team), intent(in) :: ranks
      !> Set then
      type(error_type), allocatable, intent(out) :: error
      logical :: are_there(size(names))
      integer :: i

      if (stem == '') stem = command
      do i = 1, size(names)
         associate (file => files(i))
            file%path = stem//'.'//trim(names(i))//'.checkpoint'
            file%head = 'asperity '//version//newline//case_text(keys, case_heading(command))
            are_there(i) = is_there(file%path)
            if (ranks%rank == 0 .and. .not. allocated(error)) call file%check_place(error)
         end associate
      end do
      if (allocated(error)) then
         continue
      else if (resumes .and. .not. any(are_there)) then
         call fatal_error(error, 'there is no '//files(1)%path//': begin without '// &
            '--resume, or name the checkpoints with --checkpoint', subject='resume')
      else if (any(are_there) .and. .not. resumes) then
         call fatal_error(error, files(findloc(are_there, .true., 1))%path// &
            ' is there, of a run that was interrupted or is under way: go on from it with '// &
            '--resume, remove it, or name others with --checkpoint', subject='checkpoint')
      end if
      do i = 1, size(names)
         call ranks%agree(error)
         if (.not. allocated(error)) call check_ranks(files(i), ranks, error)
      end do
      call ranks%agree(error)
   end subroutine name_checkpoints

   !> `error` is set on a rank that has another case than the first one, or does not find the file
   !> where that does.
   subroutine check_ranks(self, ranks, error)
      type(checkpoint_file), intent(in) :: self
      type(rank_team), intent(in) :: ranks
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: own(2), first(2)
      character(len=8) :: digits
      real(wp) :: values(2)
      integer :: i

      digits = checksum([(real(iachar(self%head(i:i)), wp), i=1, len(self%head))])
      read (digits, '(z8)') own(1)
      own(2) = merge(1_int64, 0_int64, is_there(self%path))
      values = real(own, wp)
      call ranks%take_first(values)
      first = nint(values, int64)
      if (own(1) /= first(1)) then
         call fatal_error(error, 'its case is not that of rank 0, or its version: all ranks '// &
            'must read the same file by the same program')
      else if (own(2) /= first(2)) then
         call fatal_error(error, 'it does not find checkpoint '//self%path//' as rank 0 does: '// &
            'name one with --checkpoint where all ranks can read', subject='checkpoint')
      end if
   end subroutine check_ranks

end module asperity_program_commands_solid_checkpoint
