!> The partial file of a sweep, FILE.csv.partial: the input as comment lines, then a CSV file whose
!> rows are complete and stand in the order in which they were done.
module asperity_program_commands_tenon_sweeps_file
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_law_validity, only: all_flags, validity_text
   use asperity_program_commands_sweep_cases, only: axis_type
   use asperity_program_commands_tenon_sweeps_table, only: case_result, n_figures, sweep_table
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_print_case, only: case_heading, case_text
   use asperity_program_report_csv, only: write_csv
   use asperity_program_system_atomic_files, only: open_target, output_file
   use asperity_program_system_checksum, only: checksum
   use asperity_program_system_files, only: read_file
   use asperity_program_system_locked_file, only: append_text, locked_file, open_locked, &
      remove_locked, shorten
   use asperity_program_system_strings, only: newline, starts_with
   implicit none
   private
   public :: partial_type, open_partial, append_case, close_partial

   character(len=*), parameter :: ending = '.partial', comment = '# ', record_mark = '! history: '
   !> Largest partial file, characters
   integer, parameter :: largest = 512*1024*1024

   !> The partial file; without a path, nothing is kept.
   type :: partial_type
      !> Its path
      character(len=:), allocatable :: path
      !> While it is written, no other sweep may
      type(locked_file), private :: file
   end type partial_type

contains

   !> Take what is done from a partial file of the same sweep, or begin one. `error` is set when it
   !> is of another sweep or cannot be written.
   subroutine open_partial(partial, sweep, path, keys, history, axes, results, error)
      !> The file
      type(partial_type), intent(out) :: partial
      !> The sweeps, and the path of the CSV file
      character(len=*), intent(in) :: sweep, path
      !> The keys, of which those swept are hidden
      type(key_list), intent(in) :: keys
      !> Recorded displacements, mm, if there are
      real(wp), allocatable, intent(in) :: history(:)
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> One result per combination; those in the file are set
      type(case_result), intent(inout) :: results(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: csv, target
      character(len=:), allocatable :: head, text, reason
      integer, parameter :: no_rows(*) = [integer ::]

      partial%path = ''
      if (path == '' .or. path == '-') return
      call open_target(csv, '--csv', path, error)
      if (allocated(error) .or. csv%is_device) return
      call open_target(target, '--csv', path//ending, error)
      if (allocated(error)) return
      partial%path = path//ending
      if (target%is_device) then
         call fatal_error(error, partial%path//': is no file', file_error)
         return
      end if
      call write_csv(sweep_table(keys, axes, results, no_rows), head, error)
      if (allocated(error)) return
      head = heading(sweep, keys, history)//head
      call open_locked(partial%file, target%target, reason)
      if (.not. allocated(reason)) call read_file(target%target, largest, text, reason)
      if (.not. allocated(reason)) then
         if (starts_with(head, text)) then
            ! New, or ended within its head
            call shorten(partial%file, 0, reason)
            if (.not. allocated(reason)) call append_text(partial%file, head, reason)
            if (allocated(reason)) call remove_locked(partial%file)
         else if (starts_with(text, head)) then
            call read_cases(text(len(head) + 1:), size(axes), results)
            call shorten(partial%file, index(text, newline, back=.true.), reason)
         else
            call fatal_error(error, partial%path//': '//difference(head, text, keys)// &
               '; remove it, or name another file with --csv')
         end if
      end if
      if (allocated(reason)) call fatal_error(error, partial%path//': cannot be used: '//reason, &
         file_error)
   end subroutine open_partial

   !> What tells one sweep from another: version and all input, as comment lines. Of a record, which
   !> may change below its name, the number of displacements and their checksum.
   function heading(sweep, keys, history) result(text)
      character(len=*), intent(in) :: sweep
      type(key_list), intent(in) :: keys
      real(wp), allocatable, intent(in) :: history(:)
      character(len=:), allocatable :: text
      character(len=:), allocatable :: input
      integer :: first, length

      input = '--sweep '//sweep//newline//case_text(keys, case_heading('tenon'))
      if (allocated(history)) input = input//record_mark//to_text(size(history))// &
         ' displacements, checksum '//checksum(history)//newline
      text = ''
      first = 1
      do while (first <= len(input))
         length = index(input(first:), newline)
         text = text//comment//input(first:first + length - 1)
         first = first + length
      end do
   end function heading

   !> How a partial file differs from what is wanted: in its first line that does.
   function difference(head, text, keys) result(words)
      character(len=*), intent(in) :: head, text
      type(key_list), intent(in) :: keys
      character(len=:), allocatable :: words
      integer :: i, first, last

      words = 'is of another sweep'
      do i = 1, min(len(head), len(text))
         if (head(i:i) /= text(i:i)) exit
      end do
      first = index(head(:min(i, len(head)) - 1), newline, back=.true.) + 1
      last = first + index(head(first:), newline) - 1
      if (index(head(first:last), comment//record_mark) == 1) then
         words = keys%rows(keys%find('history'))%text//' has changed since it was begun'
      else if (index(head(first:last), ', version ') > 0) then
         words = 'was begun by another version'
      end if
   end function difference

   !> Take over complete rows.
   subroutine read_cases(text, n_axes, results)
      character(len=*), intent(in) :: text
      integer, intent(in) :: n_axes
      type(case_result), intent(inout) :: results(:)
      integer :: first, length

      ! a line without its end is not complete
      first = 1
      do while (first <= len(text))
         length = index(text(first:), newline) - 1
         if (length < 0) return
         call read_case(text(first:first + length - 1), n_axes, results)
         first = first + length + 1
      end do
   end subroutine read_cases

   !> Take over one row: number, keys, figures, validity, outcome.
   subroutine read_case(row, n_axes, results)
      character(len=*), intent(in) :: row
      integer, intent(in) :: n_axes
      type(case_result), intent(inout) :: results(:)
      type(case_result) :: result
      integer :: first, length, field, which, status, flags

      first = 1
      which = 0
      do field = 1, 2 + n_axes + n_figures
         length = index(row(first:), ',') - 1
         if (length < 0) return
         associate (cell => row(first:first + length - 1), figure => field - 1 - n_axes)
            status = 0
            if (field == 1) then
               read (cell, *, iostat=status) which
            else if (figure > n_figures) then
               do flags = 0, all_flags
                  if (validity_text(flags) == cell) exit
               end do
               result%validity = flags
               if (flags > all_flags) return
            else if (figure > 0) then
               result%figures(figure) = none
               if (cell /= '') read (cell, *, iostat=status) result%figures(figure)
            end if
         end associate
         if (status /= 0) return
         first = first + length + 1
      end do
      if (which < 1 .or. which > size(results)) return
      result%outcome = without_quotes(row(first:))
      result%done = .true.
      results(which) = result
   end subroutine read_case

   !> A text without the quotes that CSV puts around it.
   pure function without_quotes(text) result(plain)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: plain
      integer :: i

      plain = text
      if (.not. starts_with(text, '"')) return
      plain = ''
      i = 2
      do while (i < len(text))
         plain = plain//text(i:i)
         if (text(i:i) == '"') i = i + 1
         i = i + 1
      end do
   end function without_quotes

   !> Keep one more combination.
   subroutine append_case(partial, keys, axes, results, which, error)
      !> The file
      type(partial_type), intent(in) :: partial
      !> The keys
      type(key_list), intent(in) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> All results
      type(case_result), intent(in) :: results(:)
      !> The combination
      integer, intent(in) :: which
      !> Set when the file cannot be written
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text, reason

      if (partial%path == '') return
      call write_csv(sweep_table(keys, axes, results, [which]), text, error)
      if (allocated(error)) return
      call append_text(partial%file, text(index(text, newline) + 1:), reason)
      if (allocated(reason)) call fatal_error(error, partial%path//': cannot be written: '// &
         reason, file_error)
   end subroutine append_case

   !> Remove the file when the results are where they belong.
   subroutine close_partial(partial)
      !> The file
      type(partial_type), intent(inout) :: partial

      if (partial%path /= '') call remove_locked(partial%file)
   end subroutine close_partial

end module asperity_program_commands_tenon_sweeps_file
