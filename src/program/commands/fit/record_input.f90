!> The record that `asperity fit` reads: its keys, its two columns in the units of the model, its
!> tests.
module asperity_program_commands_fit_record_input
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: condition_type, test_text, test_type
   use asperity_program_record_readings, only: axes, record_readings
   use asperity_program_record_units, only: find_unit, unit_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: fit_record, record_input, record_quantities, samples_of, scale_of

   !> The largest reading is below this, and above one over it
   real(wp), parameter :: most = 1.0e20_wp

   !> Readings below this share of the largest have the noise of that share where noise is relative
   real(wp), parameter :: least_share = 1.0e-2_wp

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
      !> Leading columns of its file that are the same in all its rows
      type(condition_type), allocatable :: constants(:)
      !> Its samples, in the units of the model
      real(wp), allocatable :: x(:), y(:)
   end type fit_record

   !> The record as the user gives it.
   type, extends(record_readings) :: record_input
   contains
      procedure :: declare, read => read_records
   end type record_input

contains

   !> Declare the record, its columns and how it is written.
   pure subroutine declare(self, keys)
      !> The record
      class(record_input), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call self%declare_files(keys, &
         'the record, as FILE.csv without an option; shear and joint take several')
      call self%declare_columns(keys, &
         [character(len=32) :: 'closure, slip or displacement', 'pressure, stress or force'], &
         [character(len=30) :: '; -1 turns the sign', '; 1/area makes a pressure'], &
         [character(len=62) :: 'unit after zero and factor; that of the file, else mm', &
         'unit after zero and factor; that of the file, else MPa or N'])
   end subroutine declare

   !> Read files.
   subroutine read_records(self, files, choices, quantities, records, columns, error)
      !> What is asked for; what was found in the last file is said there
      class(record_input), intent(inout) :: self
      !> Paths of the files
      type(string_type), intent(in) :: files(:)
      !> What the columns may be to the model; the first that a file has is taken
      type(record_quantities), intent(in) :: choices(:)
      !> What they are, in all files the same
      type(record_quantities), intent(out) :: quantities
      !> One a test, file by file
      type(fit_record), allocatable, intent(out) :: records(:)
      !> What was taken of the last file
      type(record_column), intent(out) :: columns(2)
      !> Set when a file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      allocate (records(0))
      do i = 1, size(files)
         call read_file(self, files, i, choices, quantities, records, columns, error)
         if (allocated(error)) return
      end do
   end subroutine read_records

   !> Read both columns of a file and bring them to zero, scale and the units of the model.
   subroutine read_file(self, files, which, choices, quantities, records, columns, error)
      type(record_input), intent(inout) :: self
      type(string_type), intent(in) :: files(:)
      integer, intent(in) :: which
      type(record_quantities), intent(in) :: choices(:)
      type(record_quantities), intent(inout) :: quantities
      type(fit_record), allocatable, intent(inout) :: records(:)
      type(record_column), intent(out) :: columns(2)
      type(error_type), allocatable, intent(out) :: error
      type(test_type), allocatable :: tests(:)
      type(record_input) :: own
      type(fit_record) :: record
      integer :: i

      own = self
      associate (path => files(which)%text)
         call own%read_columns(path, reshape([(choices(i)%holds, i=1, size(choices))], &
            [2, size(choices)]), columns, tests, error)
         if (allocated(error)) return
         do i = size(choices), 1, -1
            if (all(choices(i)%holds == columns%holds)) exit
         end do
         if (which > 1 .and. any(quantities%holds /= choices(i)%holds)) then
            call fatal_error(error, path//': has '//columns(1)%name//' and '// &
               columns(2)%name//', other files before it have not')
            return
         end if
         quantities = choices(i)
         do i = 1, size(axes)
            call bring_to_unit(own, path, i, trim(quantities%units(i)), columns(i), error)
            if (allocated(error)) return
         end do
      end associate
      ! the columns and form of the last file are shown
      if (which == size(files)) then
         self%format = own%format
         self%columns = own%columns
      end if
      do i = 1, size(tests)
         associate (first => tests(i)%first, last => tests(i)%last)
            record%title = test_text(tests(i))
            if (size(files) > 1) record%title = trim(files(which)%text//' '//record%title)
            record%constants = tests(i)%constants
            record%x = columns(1)%values(first:last)
            record%y = columns(2)%values(first:last)
            records = [records, record]
         end associate
      end do
   end subroutine read_file

   !> Samples of all tests.
   pure integer function samples_of(records)
      !> The tests
      type(fit_record), intent(in) :: records(:)
      integer :: i

      samples_of = sum([(size(records(i)%y), i=1, size(records))])
   end function samples_of

   !> What differences are divided by at every sample.
   pure function scale_of(residual_scale, records) result(scale)
      !> `absolute` or `relative`
      character(len=*), intent(in) :: residual_scale
      !> The tests
      type(fit_record), intent(in) :: records(:)
      real(wp), allocatable :: scale(:)
      real(wp) :: largest
      integer :: i

      allocate (scale(0))
      do i = 1, size(records)
         scale = [scale, abs(records(i)%y)]
      end do
      largest = maxval(scale)
      if (residual_scale == 'relative') then
         scale = max(scale, least_share*largest)
      else
         scale = largest
      end if
   end function scale_of

   !> Bring a column to the unit of the model.
   pure subroutine bring_to_unit(self, path, which, unit, column, error)
      class(record_input), intent(inout) :: self
      character(len=*), intent(in) :: path, unit
      integer, intent(in) :: which
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error
      type(unit_type) :: found, wanted
      real(wp) :: largest

      call self%columns(which)%tell_unit(column, unit)
      found = find_unit(self%columns(which)%unit)
      wanted = find_unit(unit)
      if (found%measures /= wanted%measures) then
         call fatal_error(error, path//': '//column%name//' is in '//self%columns(which)%unit// &
            ', which is no unit like '//unit//': bring it to one by --'//trim(axes(which))// &
            '-factor, and say which by --'//trim(axes(which))//'-unit')
      else
         column%values(:) = column%values*found%factor/wanted%factor
         largest = maxval(abs(column%values))
         if (largest > 0.0_wp .and. .not. (largest > 1.0_wp/most .and. largest < most)) &
            call fatal_error(error, path//': the largest '//column%name//' is '// &
            to_text(largest, 3)//' '//unit//', which is not between 1e-20 and 1e20: is its '// &
            'unit or factor wrong?')
      end if
   end subroutine bring_to_unit

end module asperity_program_commands_fit_record_input
