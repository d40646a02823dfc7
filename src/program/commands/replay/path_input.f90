!> Reads the motion of a contact point, with or without what it is expected to answer, from a file
!> of columns (docs/replay.md).
module asperity_program_commands_replay_path_input
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: no_opposite_surface, no_surface_limit
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_conditions, only: condition_type
   use asperity_program_record_file, only: read_rows, read_text
   use asperity_program_record_layout, only: find_layout, headings_text, layout_type
   use asperity_program_record_numbers, only: decimal_of
   use asperity_program_record_units, only: find_unit, unit_type
   use asperity_program_system_strings, only: lower_case, nearest_name, quoted, starts_with
   use asperity_replay_motion_path, only: motion_path, traction_names
   implicit none
   private
   public :: read_path

   !> What a file may have, and which of it the motion is
   character(len=*), parameter :: names(7) = [character(len=11) :: 'time', 'overclosure', &
      'slip_1', 'slip_2', traction_names]
   character(len=*), parameter :: units(size(names)) = [character(len=3) :: 's', 'mm', 'mm', &
      'mm', 'MPa', 'MPa', 'MPa']
   integer, parameter :: of_time = 1, of_overclosure = 2, of_slip = 2, of_tractions = 4
   character(len=*), parameter :: other_overclosure = 'closure'
   !> Motions and tractions are below this
   real(wp), parameter :: largest = 1.0e20_wp

contains

   !> Read a path. `error` names file and line.
   subroutine read_path(path_name, path, error)
      !> Path of the file
      character(len=*), intent(in) :: path_name
      !> The motion
      type(motion_path), intent(out) :: path
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      type(layout_type) :: layout
      type(record_column), allocatable :: columns(:)
      integer :: places(size(names))

      call read_text(path_name, text, error)
      if (.not. allocated(error)) &
         call find_layout(text, path_name, 'auto', 0, .false., layout, error)
      if (.not. allocated(error)) call find_columns(layout, places, error)
      if (.not. allocated(error)) call read_columns(text, layout, places, columns, error)
      if (.not. allocated(error)) call take_columns(path_name, columns, places, path, error)
      if (.not. allocated(error)) call check_path(path_name, path, error)
   end subroutine read_path

   !> Columns of the names, zero for what the file has not.
   pure subroutine find_columns(layout, places, error)
      type(layout_type), intent(in) :: layout
      integer, intent(out) :: places(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: name, meant
      integer :: i, j

      places = 0
      meant = ''
      if (.not. layout%has_names) then
         call refuse(layout, 'its first line must name the columns: '//trim(names(of_time))// &
            ', '//trim(names(of_overclosure))//' and so on', error)
         return
      end if
      do i = 1, size(layout%columns)
         name = lower_case(layout%columns(i)%name)
         if (name == other_overclosure) name = trim(names(of_overclosure))
         j = findloc(names == name, .true., 1)
         if (j == 0) cycle
         if (places(j) > 0) then
            call refuse(layout, 'columns '//to_text(places(j))//' and '//to_text(i)// &
               ' are both '//trim(names(j)), error)
            return
         end if
         places(j) = i
      end do
      ! what is mistyped would be passed over, and slip would be zero
      do i = 1, size(layout%columns)
         if (any(places == i)) cycle
         name = lower_case(layout%columns(i)%name)
         meant = nearest_name(name, pack(names, places == 0))
         if (starts_with(name, 'slip')) meant = trim(names(of_slip + 1))
         if (meant == '') cycle
         call refuse(layout, 'there is no column '//quoted(layout%columns(i)%name)// &
            ' of a path, did you mean '//meant//'?', error)
         return
      end do
      do j = of_time, of_overclosure
         if (places(j) > 0) cycle
         call refuse(layout, 'there is no column '//trim(names(j)), error)
         return
      end do
   end subroutine find_columns

   !> The numbers, in s, mm and MPa.
   pure subroutine read_columns(text, layout, places, columns, error)
      character(len=*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      integer, intent(in) :: places(:)
      type(record_column), allocatable, intent(out) :: columns(:)
      type(error_type), allocatable, intent(out) :: error
      type(condition_type) :: none(0)
      type(unit_type) :: unit, wanted
      character(len=:), allocatable :: decimal
      integer :: i, j

      allocate (columns(count(places > 0)))
      i = 0
      do j = 1, size(names)
         if (places(j) == 0) cycle
         i = i + 1
         columns(i)%name = trim(names(j))
         columns(i)%place = places(j)
         columns(i)%unit = layout%columns(places(j))%unit
         if (columns(i)%unit == '') columns(i)%unit = trim(units(j))
         unit = find_unit(columns(i)%unit)
         wanted = find_unit(trim(units(j)))
         if (unit%measures == wanted%measures) cycle
         call refuse(layout, columns(i)%name//' is in '//columns(i)%unit// &
            ', which is no unit like '//trim(units(j)), error)
         return
      end do
      decimal = decimal_of(text, layout%start, (columns%place))
      if (decimal == '') then
         call fatal_error(error, layout%path//': every number with a comma has three figures '// &
            'behind it, which may be a decimal sign or none: write points')
         return
      end if
      call read_rows(text, layout%start, decimal, none, columns, error)
      if (allocated(error)) return
      do i = 1, size(columns)
         unit = find_unit(columns(i)%unit)
         columns(i)%values = unit%factor*columns(i)%values
      end do
   end subroutine read_columns

   !> The path that the columns are.
   pure subroutine take_columns(path_name, columns, places, path, error)
      character(len=*), intent(in) :: path_name
      type(record_column), intent(in) :: columns(:)
      integer, intent(in) :: places(:)
      type(motion_path), intent(out) :: path
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: values(:, :)
      integer :: i, j

      allocate (values(size(columns(1)%values), size(names)), source=0.0_wp)
      i = 0
      do j = 1, size(names)
         if (places(j) == 0) cycle
         i = i + 1
         values(:, j) = columns(i)%values
         if (j == of_overclosure) where (values(:, j) < no_surface_limit) &
            values(:, j) = no_opposite_surface
         call check_size(path_name, trim(names(j)), pack(values(:, j), &
            j /= of_overclosure .or. values(:, j) > no_surface_limit), error)
         if (allocated(error)) return
      end do
      path%time = values(:, of_time)
      path%overclosure = values(:, of_overclosure)
      path%slip = transpose(values(:, of_slip + 1:of_slip + 2))
      path%expected = transpose(values(:, of_tractions + 1:))
      path%has_expected = places(of_tractions + 1:) > 0
   end subroutine take_columns

   !> Refuse what no motion or traction is.
   pure subroutine check_size(path_name, name, values, error)
      character(len=*), intent(in) :: path_name, name
      real(wp), intent(in) :: values(:)
      type(error_type), allocatable, intent(out) :: error

      if (all(abs(values) < largest)) return
      call fatal_error(error, path_name//': '//name//' = '// &
         to_text(values(findloc(abs(values) < largest, .false., 1)))// &
         ' is not between -1e20 and 1e20; overclosure -1e36 is no opposite surface')
   end subroutine check_size

   !> Refuse times that do not rise.
   pure subroutine check_path(path_name, path, error)
      character(len=*), intent(in) :: path_name
      type(motion_path), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 2, size(path%time)
         if (path%time(i) > path%time(i - 1)) cycle
         call fatal_error(error, path_name//': time = '//to_text(path%time(i))//' s of row '// &
            to_text(i)//' is not later than '//to_text(path%time(i - 1))//' s before it: a '// &
            'row is the end of an increment')
         return
      end do
   end subroutine check_path

   !> An error that lists the columns.
   pure subroutine refuse(layout, message, error)
      type(layout_type), intent(in) :: layout
      character(len=*), intent(in) :: message
      type(error_type), allocatable, intent(out) :: error

      call fatal_error(error, layout%path//': '//message//'; '//headings_text(layout))
   end subroutine refuse

end module asperity_program_commands_replay_path_input
