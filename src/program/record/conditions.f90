!> What tells one test from another: conditions that all its rows meet.
module asperity_program_record_conditions
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_record_lines, only: field, place_type
   use asperity_program_record_numbers, only: looks_like_number, read_number
   use asperity_program_system_strings, only: string_type
   use asperity_program_system_utf8, only: utf8_text
   implicit none
   private
   public :: condition_type, test_type, is_same, is_wanted, name_records, same_conditions, shown, &
      test_text

   !> What the rows of a test have in a column.
   type :: condition_type
      !> Place and name of the column
      integer :: place = 0
      character(len=:), allocatable :: name
      !> Unit of the column, empty for none
      character(len=:), allocatable :: unit
      !> Its text in these rows
      character(len=:), allocatable :: value
   end type condition_type

   !> Rows of one test, counted over those that are read.
   type :: test_type
      !> First and last row
      integer :: first = 1, last = 0
      !> What tells it from the others, none if it is the only one
      type(condition_type), allocatable :: conditions(:)
      !> What would, if there were others: leading columns that are the same in all its rows
      type(condition_type), allocatable :: constants(:)
   end type test_type

   !> The condition that is a record's file
   character(len=*), parameter :: record_name = 'record'
   !> Numbers this near to each other, relative to them, are the same value
   real(wp), parameter :: same = 1.0e-9_wp
   !> Decimal sign of values, which takes a point as well
   character(len=*), parameter :: any_decimal = 'comma'

contains

   !> Whether a line meets all conditions.
   pure logical function is_wanted(line, place, conditions)
      !> The line and where it stands
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      !> The conditions
      type(condition_type), intent(in) :: conditions(:)
      integer :: i

      is_wanted = .false.
      do i = 1, size(conditions)
         if (.not. is_same(field(line, place, conditions(i)%place), conditions(i)%value)) return
      end do
      is_wanted = .true.
   end function is_wanted

   !> Whether two texts are the same value: the same text, or the same number.
   pure logical function is_same(a, b)
      !> The texts
      character(len=*), intent(in) :: a, b
      real(wp) :: x, y
      type(error_type), allocatable :: error

      is_same = a == b
      if (is_same .or. .not. (looks_like_number(a) .and. looks_like_number(b))) return
      call read_number(a, any_decimal, x, error)
      if (.not. allocated(error)) call read_number(b, any_decimal, y, error)
      if (.not. allocated(error)) is_same = abs(x - y) <= same*max(abs(x), abs(y))
   end function is_same

   !> Make the record of each test its first condition, where there are several records, and give
   !> all tests the conditions that one of them has.
   pure subroutine name_records(paths, numbers, tests)
      !> Paths of the records, and which of them holds each test
      type(string_type), intent(in) :: paths(:)
      integer, intent(in) :: numbers(:)
      !> The tests
      type(test_type), intent(inout) :: tests(:)
      type(condition_type), allocatable :: known(:), own(:)
      integer :: i, j, place

      if (size(paths) == 1) return
      allocate (known(1))
      known(1)%name = record_name
      known(1)%unit = ''
      known(1)%value = ''
      do i = 1, size(tests)
         do j = 1, size(tests(i)%conditions)
            if (place_of(known, tests(i)%conditions(j)%name) > 0) cycle
            call append(known, tests(i)%conditions(j))
         end do
      end do
      do i = 1, size(tests)
         call move_alloc(tests(i)%conditions, own)
         allocate (tests(i)%conditions(size(known)))
         do j = 1, size(known)
            tests(i)%conditions(j) = known(j)
            place = place_of(own, known(j)%name)
            if (place > 0) tests(i)%conditions(j) = own(place)
         end do
         associate (path => paths(numbers(i))%text)
            tests(i)%conditions(1)%value = path(shared_folder(paths) + 1:)
         end associate
      end do
   end subroutine name_records

   !> Length of the folder's name that all paths begin with, its slash included.
   pure integer function shared_folder(paths)
      type(string_type), intent(in) :: paths(:)
      integer :: i

      shared_folder = index(paths(1)%text, '/', back=.true.)
      i = 2
      do while (i <= size(paths) .and. shared_folder > 0)
         associate (folder => paths(1)%text(:shared_folder))
            if (index(paths(i)%text, folder) == 1) then
               i = i + 1
            else
               shared_folder = index(folder(:shared_folder - 1), '/', back=.true.)
            end if
         end associate
      end do
   end function shared_folder

   !> Place of a condition, zero for none.
   pure integer function place_of(conditions, name)
      type(condition_type), intent(in) :: conditions(:)
      character(len=*), intent(in) :: name

      do place_of = size(conditions), 1, -1
         if (conditions(place_of)%name == name) return
      end do
   end function place_of

   !> Append a condition that no value is known of.
   pure subroutine append(list, condition)
      type(condition_type), allocatable, intent(inout) :: list(:)
      type(condition_type), intent(in) :: condition
      type(condition_type), allocatable :: longer(:)
      integer :: i

      allocate (longer(size(list) + 1))
      do i = 1, size(list)
         longer(i) = list(i)
      end do
      longer(i) = condition
      longer(i)%value = ''
      call move_alloc(longer, list)
   end subroutine append

   !> Whether two tests have the same conditions, which have the same names.
   pure logical function same_conditions(a, b, first)
      !> The tests
      type(test_type), intent(in) :: a, b
      !> First condition that is compared
      integer, intent(in) :: first
      integer :: i

      same_conditions = .false.
      do i = first, size(a%conditions)
         if (.not. is_same(a%conditions(i)%value, b%conditions(i)%value)) return
      end do
      same_conditions = .true.
   end function same_conditions

   !> What tells a test from others, such as `model = rough, normal_stress = 0.05 MPa`; empty for
   !> the only one.
   pure function test_text(test, first) result(words)
      !> The test
      type(test_type), intent(in) :: test
      !> First condition that is said, the first of all when absent
      integer, intent(in), optional :: first
      character(len=:), allocatable :: words
      integer :: i, from

      words = ''
      from = 1
      if (present(first)) from = first
      do i = from, size(test%conditions)
         associate (c => test%conditions(i))
            if (c%value == '') cycle
            if (words /= '') words = words//', '
            ! the name of a file says itself what it is
            if (c%name /= record_name) words = words//c%name//' = '
            words = words//shown(c%value)
            if (c%unit /= '') words = words//' '//c%unit
         end associate
      end do
   end function test_text

   !> A value as it is read: a number in its shortest form.
   pure function shown(value) result(text)
      !> Text of the file
      character(len=*), intent(in) :: value
      character(len=:), allocatable :: text
      real(wp) :: number
      type(error_type), allocatable :: error

      text = utf8_text(value)
      if (verify(value, '0123456789') == 0 .or. .not. looks_like_number(value)) return
      call read_number(value, any_decimal, number, error)
      if (.not. allocated(error)) text = to_text(number)
   end function shown

end module asperity_program_record_conditions
