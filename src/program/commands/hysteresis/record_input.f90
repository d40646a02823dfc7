!> The records that `asperity hysteresis` reads: their keys, their columns, what these are called.
module asperity_program_commands_hysteresis_record_input
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: test_type
   use asperity_program_record_file, only: read_record
   use asperity_program_record_keys, only: column_keys, format_keys
   use asperity_program_record_names, only: holds_displacement, holds_force, holds_moment, &
      holds_rotation
   use asperity_program_record_units, only: find_unit, unit_length
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: record_input

   !> Beginnings of the keys of both columns
   character(len=*), parameter :: axes(2) = [character(len=12) :: 'displacement', 'force']

   !> The record.
   type :: record_input
      !> Paths of the records, and what is taken of them
      type(string_type), allocatable :: record_files(:)
      character(len=6) :: quantity = ''
      character(len=:), allocatable :: quantity_source
      logical :: has_quantity = .false.
      !> How it is written, and its columns of displacement and force
      type(format_keys) :: format
      type(column_keys) :: columns(2)
      !> What is subtracted from the columns, and what they are then multiplied by
      real(wp) :: zero(2) = 0.0_wp, factor(2) = 1.0_wp
   contains
      procedure :: declare, check, read => read_columns, label
   end type record_input

contains

   !> Declare the record, its columns and how it is written.
   pure subroutine declare(self, keys)
      !> The record
      class(record_input), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      self%columns%name = axes
      call keys%paths('record_file', self%record_files, &
         'the record, or several, as FILE.csv without an option')
      call keys%reads('record', is_argument=.true.)
      call keys%choice('quantity', self%quantity, 'force moment', &
         'what is taken of the record: displacement and force, or rotation and moment')
      self%has_quantity = keys%given()
      call keys%said_by(self%quantity_source)
      call self%columns(1)%declare_column(keys, &
         'name or number of the column of displacement or rotation; found by name and unit')
      call self%columns(2)%declare_column(keys, &
         'name or number of the column of force or moment; found by name and unit')
      call self%format%declare(keys, unused=.false.)
      call keys%real('displacement_zero', self%zero(1), '', &
         'reading at rest, subtracted from the column of displacement')
      call keys%real('displacement_factor', self%factor(1), '', &
         'then multiplied by; -1 turns the sign, 1/arm makes a rotation')
      call keys%real('force_zero', self%zero(2), '', &
         'reading at rest, subtracted from the column of force')
      call keys%real('force_factor', self%factor(2), '', 'then multiplied by')
      call self%columns(1)%declare_unit(keys, &
         'unit after zero and factor; that of the file, else mm or rad')
      call self%columns(2)%declare_unit(keys, &
         'label, after zero and factor; that of the file, else N or kN m')
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
      if (.not. allocated(error) .and. size(self%record_files) == 0) &
         call fatal_error(error, 'no record is given: asperity hysteresis FILE.csv')
      if (.not. allocated(error)) call self%format%check(error)
   end subroutine check

   !> Read both columns and bring them to zero and scale.
   subroutine read_columns(self, path, columns, tests, error)
      !> What is asked for; what was found is said there
      class(record_input), intent(inout) :: self
      !> Path of the record
      character(len=*), intent(in) :: path
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
      call read_record(path, self%format%record_format, quantities_of(self%quantity), &
         columns, tests, error)
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

   !> What the columns may hold together.
   pure function quantities_of(quantity) result(quantities)
      character(len=*), intent(in) :: quantity
      integer, allocatable :: quantities(:, :)
      integer, parameter :: forces(4) = [holds_displacement, holds_force, holds_rotation, &
         holds_force], moments(2) = [holds_rotation, holds_moment]

      select case (quantity)
      case ('force')
         quantities = reshape(forces, [2, 2])
      case ('moment')
         quantities = reshape(moments, [2, 1])
      case default
         quantities = reshape([forces(:2), moments, forces(3:)], [2, 3])
      end select
   end function quantities_of

   !> Names and units of what the record holds. Units of the file count unless others were given.
   pure subroutine label(self, path, columns, labels)
      !> What is asked for; what was found is said there
      class(record_input), intent(inout) :: self
      !> Path of the record
      character(len=*), intent(in) :: path
      !> The columns
      type(record_column), intent(in) :: columns(2)
      !> Names and units
      type(record_labels), intent(out) :: labels

      labels%x = trim(axes(1))
      labels%f = trim(axes(2))
      if (.not. self%has_quantity) then
         self%quantity = merge('moment', 'force ', columns(2)%holds == holds_moment)
         self%quantity_source = 'its columns'
      end if
      if (self%quantity == 'moment') then
         labels%x = 'rotation'
         labels%f = 'moment'
         call self%columns(1)%tell_unit(columns(1), 'rad')
         call self%columns(2)%tell_unit(columns(2), 'kN m')
      else
         call self%columns(1)%tell_unit(columns(1), 'mm')
         call self%columns(2)%tell_unit(columns(2), 'N')
      end if
      labels%x_unit = self%columns(1)%unit
      labels%f_unit = self%columns(2)%unit
      labels%title = path
      if (.not. self%columns(1)%has_unit .and. columns(1)%unit == '') return
      associate (unit => find_unit(labels%x_unit))
         if (unit%measures == unit_length) labels%millimetre = 1.0_wp/unit%factor
      end associate
   end subroutine label

end module asperity_program_commands_hysteresis_record_input
