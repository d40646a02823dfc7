!> The recorded displacements or rotations that a tenon joint may be led along.
module asperity_program_commands_tenon_history
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: test_text, test_type
   use asperity_program_record_file, only: read_record
   use asperity_program_record_names, only: holds_displacement, holds_rotation
   use asperity_program_record_table, only: columns_table
   use asperity_program_record_units, only: find_unit, unit_angle, unit_length, unit_share, &
      unit_type
   use asperity_program_report_report, only: named_table
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: history_type, read_history, follow_history

   !> Way of the load point.
   type :: history_type
      private
      !> Path of the file, empty when there is none
      character(len=:), allocatable :: path
      !> Displacements, mm, or rotations, rad; what they are
      real(wp), allocatable, public :: values(:)
      logical :: is_rotation = .false.
      !> Which column was taken
      type(named_table), allocatable, public :: columns(:)
   end type history_type

   !> Rotations without a unit are in rad up to this
   real(wp), parameter :: largest_rotation = 0.5_wp
   !> Tests that a message lists
   integer, parameter :: most_listed = 12

contains

   !> Read the history that a case names, if it does. `error` names file and line.
   subroutine read_history(history, case, error)
      !> The history, empty if none is named
      type(history_type), intent(out) :: history
      !> The case; what was found is said there
      type(tenon_case), intent(inout) :: case
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      type(record_column) :: columns(1)
      type(test_type), allocatable :: tests(:)
      character(len=12) :: decimal
      logical :: is_told

      history%path = case%history
      allocate (history%columns(0))
      if (history%path == '') return
      call case%format%check(error)
      if (allocated(error)) return
      call case%column%ask(columns(1))
      decimal = case%format%decimal
      call read_record(history%path, case%format%record_format, &
         quantities_of(case%history_quantity), columns, tests, error)
      if (.not. allocated(error)) call check_tests(history%path, columns(1)%values, tests, error)
      if (allocated(error)) return
      is_told = columns(1)%unit /= '' .and. columns(1)%unit_given == ''
      call convert(history, columns(1), error)
      if (allocated(error)) return
      history%values = history%values(:tests(1)%last)
      if (case%format%decimal /= decimal) case%format%decimal_source = 'the numbers of the file'
      call case%column%tell(columns(1))
      call case%column%tell_unit(columns(1), '')
      if (.not. is_told) case%column%unit_source = 'default'
      if (.not. case%has_quantity) then
         case%history_quantity = columns(1)%name
         case%quantity_source = case%column%column_source
      end if
      history%columns = [named_table('columns', '', columns_table(columns))]
   end subroutine read_history

   !> What the column may hold.
   pure function quantities_of(quantity) result(quantities)
      character(len=*), intent(in) :: quantity
      integer, allocatable :: quantities(:, :)

      select case (quantity)
      case ('displacement')
         quantities = reshape([holds_displacement], [1, 1])
      case ('rotation')
         quantities = reshape([holds_rotation], [1, 1])
      case default
         quantities = reshape([holds_displacement, holds_rotation], [1, 2])
      end select
   end function quantities_of

   !> Several tests are one history if they go the same way.
   pure subroutine check_tests(path, values, tests, error)
      character(len=*), intent(in) :: path
      real(wp), intent(in) :: values(:)
      type(test_type), intent(in) :: tests(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: list
      integer :: i
      logical :: same

      same = .true.
      list = ''
      associate (first => values(:tests(1)%last))
         do i = 2, size(tests)
            associate (other => values(tests(i)%first:tests(i)%last))
               same = same .and. size(other) == size(first)
               if (same) same = .not. any(abs(other - first) > 0.0_wp)
            end associate
         end do
      end associate
      if (same) return
      do i = 1, min(size(tests), most_listed)
         if (i > 1) list = list//'; '
         list = list//test_text(tests(i))
      end do
      if (size(tests) > most_listed) list = list//'; ...'
      call fatal_error(error, path//': has '//to_text(size(tests))// &
         ' tests below each other, choose one with --where NAME=VALUE: '//list)
   end subroutine check_tests

   !> Bring a column to mm or rad. `error` when its unit is no such unit, or may be another.
   pure subroutine convert(history, column, error)
      type(history_type), intent(inout) :: history
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error
      type(unit_type) :: unit
      character(len=:), allocatable :: place

      place = history%path//': '//column%name//' (column '//to_text(column%place)//')'
      history%is_rotation = column%holds == holds_rotation
      if (column%unit == '') then
         column%unit = merge('rad', 'mm ', history%is_rotation)
         column%unit = trim(column%unit)
         if (history%is_rotation .and. any(abs(column%values) > largest_rotation)) then
            call fatal_error(error, place//' has no unit and goes to '// &
               to_text(maxval(abs(column%values)), 4)// &
               ': if that is % or mrad rather than rad, give --displacement-unit')
            return
         end if
      end if
      unit = find_unit(column%unit)
      if (history%is_rotation .and. all(unit%measures /= [unit_angle, unit_share])) then
         call fatal_error(error, place//' is in '//column%unit// &
            ', which is no angle: rad, mrad, % or deg, by --displacement-unit if need be')
      else if (.not. history%is_rotation .and. unit%measures /= unit_length) then
         call fatal_error(error, place//' is in '//column%unit// &
            ', which is no length: mm, cm, m or in, by --displacement-unit if need be; '// &
            'rotations need --history-quantity rotation')
      else
         history%values = unit%factor*column%values
      end if
   end subroutine convert

   !> Lead a joint along the history, if there is one; rotation is displacement over arm. `error` is
   !> set when it goes too far.
   pure subroutine follow_history(tenon, history, error)
      !> The joint, whose displacements are set
      type(tenon_settings), intent(inout) :: tenon
      !> The history
      type(history_type), intent(in) :: history
      !> Set when it goes too far
      type(error_type), allocatable, intent(out) :: error

      if (history%path == '') return
      tenon%displacement = history%values
      if (history%is_rotation) tenon%displacement = tenon%arm*history%values
      call check_tenon_settings(tenon, error)
      if (allocated(error)) error%message = history%path//': '//error%message
   end subroutine follow_history

end module asperity_program_commands_tenon_history
