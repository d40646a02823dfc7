!> Several records in one call: each is read by itself, and all their tests make one list.
module asperity_program_commands_hysteresis_records
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_hysteresis_record_input, only: record_input
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: name_records, test_type
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: repeated, string_type
   implicit none
   private
   public :: list_tests, number_of_tests, read_records, record_type, remark_columns

   !> One record.
   type :: record_type
      !> What was asked for, and what was found
      type(record_input) :: input
      !> Displacement and force
      type(record_column) :: columns(2)
      !> Its tests, as rows of the columns
      type(test_type), allocatable :: tests(:)
      !> Names and units
      type(record_labels) :: labels
   end type record_type

contains

   !> Read all records. `error` is set when one cannot be read, is there already, or has other units
   !> than the first.
   subroutine read_records(input, records, error)
      !> What is asked for
      type(record_input), intent(in) :: input
      !> The records
      type(record_type), allocatable, intent(out) :: records(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (repeated(input%files) /= '') then
         call fatal_error(error, repeated(input%files)//': is given twice')
         return
      end if
      allocate (records(size(input%files)))
      do i = 1, size(records)
         associate (r => records(i), path => input%files(i)%text)
            r%input = input
            call r%input%read(path, r%columns, r%tests, error)
            if (allocated(error)) return
            call r%input%label(path, r%columns, r%labels)
            call check_units(records(1)%labels, r%labels, error)
            if (allocated(error)) return
         end associate
      end do
   end subroutine read_records

   !> Set `error` if a record is not in the units of the first.
   pure subroutine check_units(first, other, error)
      type(record_labels), intent(in) :: first, other
      type(error_type), allocatable, intent(out) :: error

      if (first%x_unit == other%x_unit .and. first%f_unit == other%f_unit) return
      call fatal_error(error, other%title//' is in '//other%x_unit//' and '//other%f_unit//', '// &
         first%title//' in '//first%x_unit//' and '//first%f_unit//': records in one call '// &
         'must have the same units')
   end subroutine check_units

   !> How many tests a record has.
   pure elemental integer function number_of_tests(record)
      !> The record
      type(record_type), intent(in) :: record

      number_of_tests = size(record%tests)
   end function number_of_tests

   !> The tests of all records, and which record each is of.
   pure subroutine list_tests(paths, records, tests, numbers)
      !> Paths of the records
      type(string_type), intent(in) :: paths(:)
      !> The records
      type(record_type), intent(in) :: records(:)
      !> All tests; where there are several records, the first condition is the record
      type(test_type), allocatable, intent(out) :: tests(:)
      !> Records of the tests
      integer, allocatable, intent(out) :: numbers(:)
      integer :: i, j, n

      n = sum(number_of_tests(records))
      allocate (tests(n), numbers(n))
      n = 0
      do i = 1, size(records)
         do j = 1, size(records(i)%tests)
            n = n + 1
            tests(n) = records(i)%tests(j)
            numbers(n) = i
         end do
      end do
      call name_records(paths, numbers, tests)
   end subroutine list_tests

   !> Say which records have their quantities in other columns than the first.
   pure subroutine remark_columns(records, report)
      !> The records
      type(record_type), intent(in) :: records(:)
      !> Its remarks are added to
      type(report_type), intent(inout) :: report
      integer :: i

      do i = 2, size(records)
         associate (first => records(1)%columns, own => records(i)%columns)
            if (all(first%place == own%place)) cycle
            call report%add_remark(records(i)%labels%title//': '//own(1)%name//' is column '// &
               to_text(own(1)%place)//', '//own(2)%name//' column '//to_text(own(2)%place)// &
               ', unlike '//to_text(first(1)%place)//' and '//to_text(first(2)%place)//' of '// &
               records(1)%labels%title//'.')
         end associate
      end do
   end subroutine remark_columns

end module asperity_program_commands_hysteresis_records
