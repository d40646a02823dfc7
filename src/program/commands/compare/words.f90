!> A comparison in a table and in words.
module asperity_program_commands_compare_words
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_compare_departures, only: departure_type, exchange, explanation
   use asperity_program_commands_compare_history, only: history_type
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_counts, new_table, table_type
   implicit none
   private
   public :: departures_table, remark_rows, remark_departures

   !> Significant figures of unlike quantities on the terminal
   integer, parameter :: figures = 5
   !> Columns of two directions, which may have changed places
   character(len=8), parameter :: pairs(3) = [character(len=8) :: 'slip', 'shear', 'reaction']

contains

   !> One row a column.
   pure function departures_table(departures) result(table)
      !> The columns
      type(departure_type), intent(in) :: departures(:)
      type(table_type) :: table
      integer :: rows(size(departures)), i

      do i = 1, size(departures)
         rows(i) = count(departures(i)%is_compared)
      end do
      table = new_table(columns=9, rows=size(departures))
      call table%add_texts('column', departures%name)
      call table%add_texts('unit', departures%unit)
      call table%add_codes('rows', column_counts, rows)
      call table%add_texts('passes', merge('no ', 'yes', departures%first > 0))
      call table%add_codes('worst_row', column_counts, (departures%worst))
      call table%add_numbers('time', 's', (departures%time), figures=figures)
      call table%add_numbers('expected', '-', (departures%expected), figures=figures)
      call table%add_numbers('found', '-', (departures%found), figures=figures)
      call table%add_numbers('off_over_allowed', '-', (departures%over_allowed), figures=3)
   end function departures_table

   !> What is to be said of the rows and columns that were not compared.
   pure subroutine remark_rows(report, expected, result, rows)
      !> The report
      type(report_type), intent(inout) :: report
      !> Both histories
      type(history_type), intent(in) :: expected, result
      !> Row of the result for each expected row
      integer, intent(in) :: rows(:)
      character(len=:), allocatable :: names
      integer :: i, more

      if (any(rows == 0)) call report%add_remark('Missing: '//result%path//' has no row at '// &
         to_text(count(rows == 0))//' of '//to_text(size(rows))//' times, the first of them '// &
         to_text(expected%time(findloc(rows, 0, 1)))//' s.')
      more = 0
      do i = 1, size(result%time)
         if (all(rows /= i)) more = more + 1
      end do
      if (more > 0) call report%add_remark('Not compared: '//to_text(more)//' of '// &
         to_text(size(result%time))//' rows of '//result%path// &
         ', at other times or given again at the same.')
      if (any(result%time(2:) < result%time(:size(result%time) - 1))) call report%add_remark( &
         'The rows of '//result%path//' are not in the order of time.')
      names = ''
      do i = 1, size(expected%names)
         if (all(result%names /= expected%names(i))) names = names//', '//trim(expected%names(i))
      end do
      if (names /= '') call report%add_remark('Not compared, as '//result%path// &
         ' does not have them: '//names(3:)//'.')
   end subroutine remark_rows

   !> Where columns begin to depart, and what explains it.
   pure subroutine remark_departures(report, departures, expected, found)
      !> The report
      type(report_type), intent(inout) :: report
      !> The columns
      type(departure_type), intent(in) :: departures(:)
      !> What is expected, and what is found in its rows and columns
      type(history_type), intent(in) :: expected
      real(wp), intent(in) :: found(:, :)
      character(len=:), allocatable :: why
      integer :: i, place

      do i = 1, size(departures)
         associate (d => departures(i))
            if (d%first == 0) cycle
            place = findloc(expected%names == d%name, .true., 1)
            why = explanation(pack(expected%values(:, place), d%is_compared), &
               pack(found(:, place), d%is_compared), d%allowed)
            if (why == '') why = 'departs from row '//to_text(d%first)//' on, at '// &
               to_text(expected%time(d%first))//' s'
            call report%add_remark(trim(d%name)//' '//why//'.')
         end associate
      end do
      do i = 1, size(pairs)
         call remark_exchange(report, departures, expected, found, trim(pairs(i)))
      end do
   end subroutine remark_departures

   !> Two directions that have changed places.
   pure subroutine remark_exchange(report, departures, expected, found, pair)
      type(report_type), intent(inout) :: report
      type(departure_type), intent(in) :: departures(:)
      type(history_type), intent(in) :: expected
      real(wp), intent(in) :: found(:, :)
      character(len=*), intent(in) :: pair
      integer :: first, second, i, j, change

      first = findloc(departures%name == pair//'_1', .true., 1)
      second = findloc(departures%name == pair//'_2', .true., 1)
      if (first == 0 .or. second == 0) return
      if (departures(first)%first == 0 .and. departures(second)%first == 0) return
      i = findloc(expected%names == departures(first)%name, .true., 1)
      j = findloc(expected%names == departures(second)%name, .true., 1)
      associate (is_compared => departures(first)%is_compared .and. departures(second)%is_compared)
         change = exchange(both(expected%values, i, j, is_compared), &
            both(found, i, j, is_compared), &
            max(departures(first)%allowed, departures(second)%allowed))
      end associate
      if (change == 1) call report%add_remark(pair//'_1 and '//pair//'_2 have changed places.')
      if (change == -1) call report%add_remark(pair//'_1 and '//pair//'_2 have changed places, '// &
         'one with the other sign: slip directions are turned by 90 degrees.')
   end subroutine remark_exchange

   !> Two columns in some rows.
   pure function both(values, i, j, is_row)
      real(wp), intent(in) :: values(:, :)
      integer, intent(in) :: i, j
      logical, intent(in) :: is_row(:)
      real(wp) :: both(count(is_row), 2)

      both(:, 1) = pack(values(:, i), is_row)
      both(:, 2) = pack(values(:, j), is_row)
   end function both

end module asperity_program_commands_compare_words
