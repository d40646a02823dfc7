!> The records that `asperity hysteresis` reads: their keys, their columns, what these are called.
module asperity_program_commands_hysteresis_record_input
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: test_type
   use asperity_program_record_names, only: holds_displacement, holds_force, holds_moment, &
      holds_rotation
   use asperity_program_record_readings, only: axes, record_readings
   use asperity_program_record_units, only: find_unit, unit_length
   implicit none
   private
   public :: record_input

   !> The record.
   type, extends(record_readings) :: record_input
      !> What is taken of the records
      character(len=6) :: quantity = ''
      character(len=:), allocatable :: quantity_source
      logical :: has_quantity = .false.
   contains
      procedure :: declare, read => read_input, label
   end type record_input

contains

   !> Declare the record, its columns and how it is written.
   pure subroutine declare(self, keys)
      !> The record
      class(record_input), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call self%declare_files(keys, 'the record, or several, as FILE.csv without an option')
      call keys%choice('quantity', self%quantity, 'force moment', &
         'what is taken of the record: displacement and force, or rotation and moment')
      self%has_quantity = keys%given()
      call keys%said_by(self%quantity_source)
      call self%declare_columns(keys, &
         [character(len=24) :: 'displacement or rotation', 'force or moment'], &
         [character(len=50) :: '; -1 turns the sign, 1/arm makes a rotation', ''], &
         [character(len=66) :: 'unit after zero and factor; that of the file, else mm or rad', &
         'label, after zero and factor; that of the file, else N or kN m'])
   end subroutine declare

   !> Read both columns of a file.
   subroutine read_input(self, path, columns, tests, error)
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

      call self%read_columns(path, quantities_of(self%quantity), columns, tests, error)
   end subroutine read_input

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
