!> Two columns that a command reads of a record, displacement and force or what stands for them: the
!> keys that name them, and what brings their readings to zero and scale.
module asperity_program_record_readings
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: test_type
   use asperity_program_record_file, only: read_record
   use asperity_program_record_keys, only: column_keys, format_keys
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: record_readings

   !> Beginnings of the keys of both columns
   character(len=*), parameter, public :: axes(2) = [character(len=12) :: 'displacement', 'force']

   !> What is read of a record.
   type :: record_readings
      !> Its files
      type(string_type), allocatable :: files(:)
      !> How it is written, and its columns
      type(format_keys) :: format
      type(column_keys) :: columns(2)
      !> What is subtracted from the columns, and what they are then multiplied by
      real(wp) :: zero(2) = 0.0_wp, factor(2) = 1.0_wp
   contains
      procedure :: declare_files, declare_columns, check, read_columns
   end type record_readings

contains

   !> Declare the files.
   pure subroutine declare_files(self, keys, help)
      !> What is read
      class(record_readings), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> What they are
      character(len=*), intent(in) :: help

      self%columns%name = axes
      call keys%paths('record_file', self%files, help)
      call keys%reads('record', is_argument=.true.)
   end subroutine declare_files

   !> Declare the columns and how the record is written.
   pure subroutine declare_columns(self, keys, columns, factors, units)
      !> What is read
      class(record_readings), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> What the columns are of, what factors do besides, what units are and else are
      character(len=*), intent(in) :: columns(2), factors(2), units(2)
      integer :: i

      do i = 1, size(axes)
         call self%columns(i)%declare_column(keys, 'name or number of the column of '// &
            trim(columns(i))//'; found by name and unit')
      end do
      call self%format%declare(keys, unused=.false.)
      do i = 1, size(axes)
         call keys%real(trim(axes(i))//'_zero', self%zero(i), '', &
            'reading at rest, subtracted from the column of '//trim(axes(i)))
         call keys%real(trim(axes(i))//'_factor', self%factor(i), '', &
            'then multiplied by'//trim(factors(i)))
      end do
      do i = 1, size(axes)
         call self%columns(i)%declare_unit(keys, trim(units(i)))
      end do
   end subroutine declare_columns

   !> Set `error` unless there is a record and something would be left of it.
   pure subroutine check(self, command, error)
      !> What is read
      class(record_readings), intent(in) :: self
      !> Name of the command
      character(len=*), intent(in) :: command
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(axes)
         if (.not. allocated(error) .and. .not. abs(self%factor(i)) > 0.0_wp) &
            call fatal_error(error, trim(axes(i))//'_factor = 0.0 is not allowed: nothing '// &
            'would be left of the record', subject=trim(axes(i))//'_factor')
      end do
      if (.not. allocated(error) .and. size(self%files) == 0) &
         call fatal_error(error, 'no record is given: asperity '//command//' FILE.csv')
      if (.not. allocated(error)) call self%format%check(error)
   end subroutine check

   !> Read both columns of a file and bring them to zero and scale.
   subroutine read_columns(self, path, quantities, columns, tests, error)
      !> What is asked for; what was found is said there
      class(record_readings), intent(inout) :: self
      !> Path of the file
      character(len=*), intent(in) :: path
      !> What the columns may hold together, a column for each choice
      integer, intent(in) :: quantities(:, :)
      !> The columns
      type(record_column), intent(out) :: columns(2)
      !> The tests of the file, as rows of the columns
      type(test_type), allocatable, intent(out) :: tests(:)
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=12) :: decimal
      integer :: i

      do i = 1, size(axes)
         call self%columns(i)%ask(columns(i))
      end do
      decimal = self%format%decimal
      call read_record(path, self%format%record_format, quantities, columns, tests, error)
      if (allocated(error)) return
      if (columns(1)%place == columns(2)%place) then
         call fatal_error(error, path//': '//columns(1)%name//' and '// &
            columns(2)%name//' are both column '//to_text(columns(1)%place))
         return
      end if
      if (self%format%decimal /= decimal) self%format%decimal_source = 'the numbers of the file'
      do i = 1, size(axes)
         call self%columns(i)%tell(columns(i))
         columns(i)%values(:) = self%factor(i)*(columns(i)%values - self%zero(i))
      end do
   end subroutine read_columns

end module asperity_program_record_readings
