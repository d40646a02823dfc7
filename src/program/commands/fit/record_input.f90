!> The record that `asperity fit` reads: its keys, its two columns in the units of the model, its
!> tests.
module asperity_program_commands_fit_record_input
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_file, only: read_record
   use asperity_program_record_keys, only: column_keys, format_keys
   use asperity_program_record_tests, only: test_text, test_type
   use asperity_program_record_units, only: find_unit, unit_type
   implicit none
   private
   public :: fit_record, record_input, record_quantities

   !> Beginnings of the keys of both columns
   character(len=*), parameter :: axes(2) = [character(len=12) :: 'displacement', 'force']

   !> What both columns are to a model.
   type :: record_quantities
      !> What they hold (`asperity_program_record_names`)
      integer :: holds(2) = 0
      !> Their names in tables, and the units of the model
      character(len=16) :: names(2) = '', units(2) = ''
   end type record_quantities

   !> One test.
   type :: fit_record
      !> What tells it from others, empty for the only one
      character(len=:), allocatable :: title
      !> Its samples, in the units of the model
      real(wp), allocatable :: x(:), y(:)
   end type fit_record

   !> The record as the user gives it.
   type :: record_input
      !> Its path
      character(len=:), allocatable :: record_file
      !> How it is written, and its columns
      type(format_keys) :: format
      type(column_keys) :: columns(2)
      !> What is subtracted from the columns, and what they are then multiplied by
      real(wp) :: zero(2) = 0.0_wp, factor(2) = 1.0_wp
   contains
      procedure :: declare, check, read => read_records
   end type record_input

contains

   !> Declare the record, its columns and how it is written.
   pure subroutine declare(self, keys)
      !> The record
      class(record_input), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      self%columns%name = axes
      call keys%text('record_file', self%record_file, 'the record, as FILE.csv without an option')
      call keys%reads('record', is_argument=.true.)
      call self%columns(1)%declare_column(keys, &
         'name or number of the column of closure, slip or displacement; found by name and unit')
      call self%columns(2)%declare_column(keys, &
         'name or number of the column of pressure, stress or force; found by name and unit')
      call self%format%declare(keys, unused=.false.)
      call keys%real('displacement_zero', self%zero(1), '', &
         'reading at rest, subtracted from the column of displacement')
      call keys%real('displacement_factor', self%factor(1), '', &
         'then multiplied by; -1 turns the sign')
      call keys%real('force_zero', self%zero(2), '', &
         'reading at rest, subtracted from the column of force')
      call keys%real('force_factor', self%factor(2), '', &
         'then multiplied by; 1/area makes a pressure')
      call self%columns(1)%declare_unit(keys, &
         'unit after zero and factor; that of the file, else mm')
      call self%columns(2)%declare_unit(keys, &
         'unit after zero and factor; that of the file, else MPa or N')
   end subroutine declare

   !> Set `error` unless there is a record and something would be left of it.
   pure subroutine check(self, error)
      !> The record
      class(record_input), intent(in) :: self
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(axes)
         if (.not. allocated(error) .and. .not. abs(self%factor(i)) > 0.0_wp) &
            call fatal_error(error, trim(axes(i))//'_factor = 0.0 is not allowed: nothing '// &
            'would be left of the record', subject=trim(axes(i))//'_factor')
      end do
      if (.not. allocated(error) .and. self%record_file == '') &
         call fatal_error(error, 'no record is given: asperity fit FILE.csv')
      if (.not. allocated(error)) call self%format%check(error)
   end subroutine check

   !> Read both columns and bring them to zero, scale and the units of the model.
   subroutine read_records(self, quantities, records, columns, error)
      !> What is asked for; what was found is said there
      class(record_input), intent(inout) :: self
      !> What the columns are to the model
      type(record_quantities), intent(in) :: quantities
      !> One a test
      type(fit_record), allocatable, intent(out) :: records(:)
      !> What was taken of the file
      type(record_column), intent(out) :: columns(2)
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      type(test_type), allocatable :: tests(:)
      character(len=12) :: decimal
      integer :: i

      do i = 1, size(axes)
         call self%columns(i)%ask(columns(i))
      end do
      decimal = self%format%decimal
      call read_record(self%record_file, self%format%record_format, &
         reshape(quantities%holds, [2, 1]), columns, tests, error)
      if (allocated(error)) return
      if (columns(1)%place == columns(2)%place) then
         call fatal_error(error, self%record_file//': '//columns(1)%name//' and '// &
            columns(2)%name//' are both column '//to_text(columns(1)%place))
         return
      end if
      if (self%format%decimal /= decimal) self%format%decimal_source = 'the numbers of the file'
      do i = 1, size(axes)
         call self%columns(i)%tell(columns(i))
         call self%columns(i)%tell_unit(columns(i), trim(quantities%units(i)))
         columns(i)%values(:) = self%factor(i)*(columns(i)%values - self%zero(i))
         call convert(self, i, trim(quantities%units(i)), columns(i), error)
         if (allocated(error)) return
      end do
      allocate (records(size(tests)))
      do i = 1, size(tests)
         associate (first => tests(i)%first, last => tests(i)%last)
            records(i)%title = test_text(tests(i))
            records(i)%x = columns(1)%values(first:last)
            records(i)%y = columns(2)%values(first:last)
         end associate
      end do
   end subroutine read_records

   !> From the unit of a column to that of the model.
   pure subroutine convert(self, which, unit, column, error)
      type(record_input), intent(in) :: self
      integer, intent(in) :: which
      character(len=*), intent(in) :: unit
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error
      type(unit_type) :: found, wanted

      found = find_unit(self%columns(which)%unit)
      wanted = find_unit(unit)
      if (found%measures /= wanted%measures) then
         call fatal_error(error, self%record_file//': '//column%name//' is in '// &
            self%columns(which)%unit//', which is no unit like '//unit//': bring it to one by --'// &
            trim(axes(which))//'-factor, and say which by --'//trim(axes(which))//'-unit')
      else
         column%values(:) = column%values*found%factor/wanted%factor
      end if
   end subroutine convert

end module asperity_program_commands_fit_record_input
