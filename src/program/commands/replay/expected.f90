!> A replay beside the tractions that its path expects.
module asperity_program_commands_replay_expected
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_compare_departures, only: departure_of, departure_type
   use asperity_program_commands_compare_history, only: history_type
   use asperity_program_commands_compare_words, only: departures_table, remark_departures
   use asperity_program_report_report, only: named_table, report_type
   use asperity_program_system_strings, only: string_type
   use asperity_replay_motion_path, only: motion_path, traction_names
   use asperity_replay_path_replay, only: path_step
   implicit none
   private
   public :: compare_with_expected

contains

   !> Add a table and remarks of the columns that are expected, if any are.
   pure subroutine compare_with_expected(report, path, steps, tolerance, departs)
      !> The report
      type(report_type), intent(inout) :: report
      !> The motion, with what is expected
      type(motion_path), intent(in) :: path
      !> The result
      type(path_step), intent(in) :: steps(:)
      !> What may be off, as a part of the largest value of a column
      real(wp), intent(in) :: tolerance
      !> Columns that depart, with commas between them; empty for none
      character(len=:), allocatable, intent(out) :: departs
      type(history_type) :: expected
      type(departure_type), allocatable :: departures(:)
      type(string_type) :: line
      real(wp), allocatable :: found(:, :)
      logical :: is_row(size(steps))
      integer :: i, n

      departs = ''
      n = count(path%has_expected)
      if (n == 0) return
      allocate (found(size(steps), n), departures(n), expected%values(size(steps), n), &
         expected%names(n), expected%units(n))
      expected%time = path%time
      expected%names(:) = pack(traction_names, path%has_expected)
      expected%units(:) = 'MPa'
      is_row = .true.
      n = 0
      do i = 1, size(traction_names)
         if (.not. path%has_expected(i)) cycle
         n = n + 1
         found(:, n) = steps%traction(i)
         expected%values(:, n) = path%expected(i, :)
      end do
      do i = 1, n
         departures(i) = departure_of(expected, i, found(:, i), is_row, tolerance)
         if (departures(i)%first > 0) departs = departs//', '//trim(departures(i)%name)
      end do
      if (departs /= '') departs = departs(3:)
      report%more = [named_table('departures', 'Beside what is expected', &
         departures_table(departures))]
      call remark_departures(report, departures, expected, found)
      line%text = 'pass: '//to_text(n)//' columns in '//to_text(size(steps))//' rows within '// &
         to_text(tolerance)//' of the largest value of each.'
      if (departs /= '') line%text = 'departs from what is expected in '//departs//'.'
      allocate (report%verdict(1))
      report%verdict(1) = line
   end subroutine compare_with_expected

end module asperity_program_commands_replay_expected
