!> Several tests in one file: rows that a condition chooses, and leading columns that tell one test
!> from another.
module asperity_program_record_tests
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_record_columns, only: column_with_name, number_of
   use asperity_program_record_conditions, only: condition_type, is_same, is_wanted, shown, &
      test_type
   use asperity_program_record_layout, only: layout_type
   use asperity_program_record_lines, only: field, next_line, place_type
   use asperity_program_record_names, only: holds_other, holds_pressure, holds_unknown
   use asperity_program_record_numbers, only: looks_like_number
   use asperity_program_system_strings, only: quoted, string_type
   implicit none
   private
   public :: read_conditions, find_tests

   !> Fewest rows of a test, and most tests of a file
   integer, parameter :: fewest_rows = 3, most_tests = 1000
   !> Values that a message lists
   integer, parameter :: most_listed = 12

contains

   !> The conditions of `name=value,name=value`. `error` lists the values that there are.
   pure subroutine read_conditions(text, layout, list, conditions, error)
      !> The whole file, and how it is written
      character(len=*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      !> The conditions as given
      character(len=*), intent(in) :: list
      !> What they mean
      type(condition_type), allocatable, intent(out) :: conditions(:)
      !> Set when a column or value is not there
      type(error_type), allocatable, intent(out) :: error
      type(condition_type) :: condition
      integer :: first, last, equals

      allocate (conditions(0))
      first = 1
      do while (first <= len(list))
         last = first + index(list(first:)//',', ',') - 2
         equals = index(list(first:last), '=')
         if (equals < 2) then
            call fatal_error(error, '--where: '//quoted(list(first:last))//' is not NAME=VALUE')
            return
         end if
         condition%name = list(first:first + equals - 2)
         condition%value = list(first + equals:last)
         condition%place = number_of(condition%name)
         if (condition%place == 0) then
            call column_with_name(layout, condition%name, condition%place, error)
            if (allocated(error)) error%message = '--where: '//error%message
            if (allocated(error)) return
         end if
         conditions = [conditions, condition]
         call check_value(text, layout, conditions, error)
         if (allocated(error)) return
         first = last + 2
      end do
   end subroutine read_conditions

   !> Set `error` when no row meets all conditions: it lists what rows have that meet all but one.
   pure subroutine check_value(text, layout, conditions, error)
      character(len=*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      type(condition_type), intent(in) :: conditions(:)
      type(error_type), allocatable, intent(out) :: error
      type(place_type) :: place
      type(string_type) :: values(most_listed + 1)
      character(len=:), allocatable :: cell, known
      integer :: i, n

      n = 0
      place = layout%start
      associate (last => conditions(size(conditions)))
         do while (place%next > 0)
            associate (line => text(place%first:place%last))
               if (is_wanted(line, place, conditions)) return
               cell = field(line, place, last%place)
               if (n <= most_listed .and. &
                  is_wanted(line, place, conditions(:size(conditions) - 1))) then
                  if (.not. any([(is_same(cell, values(i)%text), i=1, n)])) then
                     n = n + 1
                     values(n)%text = cell
                  end if
               end if
            end associate
            call next_line(text, place)
         end do
         known = ''
         do i = 1, min(n, most_listed)
            if (i > 1) known = known//', '
            known = known//shown(values(i)%text)
         end do
         if (n > most_listed) known = known//', ...'
         call fatal_error(error, '--where: no row of '//layout%path//' has '//last%name//' = '// &
            quoted(last%value)//'; there are: '//known)
      end associate
   end subroutine check_value

   !> The tests of a file, one if nothing tells them apart. A leading column does so if it holds
   !> texts, or numbers of a name that is none of those looked for, no time and no count, changes at
   !> most every third row, and no value comes back after another.
   pure subroutine find_tests(text, layout, conditions, n_leading, tests)
      !> The whole file, and how it is written
      character(len=*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      !> Conditions of the rows that are read
      type(condition_type), intent(in) :: conditions(:)
      !> Columns before the first that is read
      integer, intent(in) :: n_leading
      !> The tests
      type(test_type), allocatable, intent(out) :: tests(:)
      type(test_type), allocatable :: found(:)
      integer :: n

      allocate (tests(1))
      allocate (tests(1)%conditions(0))
      do n = 1, min(n_leading, size(layout%columns))
         if (all(layout%columns(n)%holds /= [holds_unknown, holds_pressure, holds_other])) exit
         if (.not. layout%has_names) then
            if (looks_like_number(field(text(layout%start%first:layout%start%last), &
               layout%start, n))) exit
         end if
         call split(text, layout, conditions, n, found)
         if (size(found) == 0) exit
         call move_alloc(found, tests)
      end do
      do n = 1, size(tests)
         tests(n)%constants = tests(n)%conditions
      end do
      if (size(tests) > 1) return
      tests(1)%first = 1
      tests(1)%last = huge(1)
      deallocate (tests(1)%conditions)
      allocate (tests(1)%conditions(0))
   end subroutine find_tests

   !> Split the rows wherever one of the first columns changes; no tests if these do not tell any.
   pure subroutine split(text, layout, conditions, n, tests)
      character(len=*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      type(condition_type), intent(in) :: conditions(:)
      integer, intent(in) :: n
      type(test_type), allocatable, intent(out) :: tests(:)
      type(test_type) :: all_tests(most_tests)
      type(place_type) :: place
      integer :: i, row, count

      count = 0
      row = 0
      place = layout%start
      allocate (tests(0))
      do while (place%next > 0)
         associate (line => text(place%first:place%last))
            if (is_wanted(line, place, conditions)) then
               row = row + 1
               if (count > 0) then
                  if (is_wanted(line, place, all_tests(count)%conditions)) then
                     all_tests(count)%last = row
                     call next_line(text, place)
                     cycle
                  end if
                  if (row - all_tests(count)%first < fewest_rows) return
                  do i = 1, count - 1
                     if (is_wanted(line, place, all_tests(i)%conditions)) return
                  end do
               end if
               if (count == most_tests) return
               count = count + 1
               all_tests(count)%first = row
               all_tests(count)%last = row
               allocate (all_tests(count)%conditions(n))
               do i = 1, n
                  associate (condition => all_tests(count)%conditions(i))
                     condition%place = i
                     condition%name = layout%columns(i)%name
                     if (.not. layout%has_names) condition%name = 'column_'//to_text(i)
                     condition%unit = layout%columns(i)%unit
                     condition%value = field(line, place, i)
                  end associate
               end do
            end if
         end associate
         call next_line(text, place)
      end do
      if (count > 0) then
         if (row + 1 - all_tests(count)%first >= fewest_rows) tests = all_tests(:count)
      end if
   end subroutine split

end module asperity_program_record_tests
