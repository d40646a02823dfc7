!> Columns of a text file under a line of headings: CSV, and what ABAQUS/Viewer writes of X-Y data.
module asperity_program_commands_compare_columns_file
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_compare_history, only: history_type
   use asperity_program_record_layout, only: find_layout, headings_text, layout_type
   use asperity_program_record_lines, only: field, next_line, place_text, place_type
   use asperity_program_record_numbers, only: looks_like_number, read_number
   use asperity_program_system_strings, only: lower_case, quoted
   implicit none
   private
   public :: read_columns

contains

   !> Read all columns of numbers. `error` names file, line and column.
   pure subroutine read_columns(text, path, history, error)
      !> The whole file, and its path
      character(len=*), intent(in) :: text, path
      !> What it holds
      type(history_type), intent(out) :: history
      !> Set when there is no time, or a line is faulty
      type(error_type), allocatable, intent(out) :: error
      type(layout_type) :: layout
      type(place_type) :: place
      integer, allocatable :: places(:)
      integer :: i, time, rows

      call find_layout(text, path, 'auto', 0, .true., layout, error)
      if (allocated(error)) return
      time = 0
      do i = size(layout%columns), 1, -1
         ! ABAQUS/Viewer calls time X
         if (any(lower_case(layout%columns(i)%name) == [character(len=4) :: 'time', 'x'])) time = i
      end do
      if (time == 0) then
         call fatal_error(error, path//': has no column time; '//headings_text(layout))
         return
      end if
      places = pack([(i, i=1, size(layout%columns))], [(i /= time .and. is_number_or_none( &
         field(text(layout%start%first:layout%start%last), layout%start, i)), &
         i=1, size(layout%columns))])
      rows = 0
      place = layout%start
      do while (place%next > 0)
         rows = rows + 1
         call next_line(text, place)
      end do
      history%path = path
      allocate (history%names(size(places)), history%units(size(places)))
      do i = 1, size(places)
         history%names(i) = lower_case(layout%columns(places(i))%name)
         history%units(i) = layout%columns(places(i))%unit
      end do
      allocate (history%time(rows), history%values(rows, size(places)))
      rows = 0
      place = layout%start
      do while (place%next > 0)
         rows = rows + 1
         associate (line => text(place%first:place%last))
            call read_cell(line, place, time, 'time', history%time(rows), error)
            if (.not. allocated(error) .and. is_none(history%time(rows))) &
               call fatal_error(error, place_text(place)//': has no time')
            do i = 1, size(places)
               if (.not. allocated(error)) call read_cell(line, place, places(i), &
                  trim(history%names(i)), history%values(rows, i), error)
            end do
         end associate
         if (allocated(error)) return
         call next_line(text, place)
      end do
   end subroutine read_columns

   pure logical function is_number_or_none(text)
      character(len=*), intent(in) :: text

      is_number_or_none = text == '' .or. looks_like_number(text)
   end function is_number_or_none

   !> One value of a line, `none` where the field is empty or missing.
   pure subroutine read_cell(line, place, column, name, value, error)
      character(len=*), intent(in) :: line, name
      type(place_type), intent(in) :: place
      integer, intent(in) :: column
      real(wp), intent(out) :: value
      type(error_type), allocatable, intent(inout) :: error
      type(error_type), allocatable :: refused
      character(len=:), allocatable :: text

      value = none
      text = field(line, place, column)
      if (text == '') return
      call read_number(text, 'point', value, refused)
      if (allocated(refused)) call fatal_error(error, place_text(place)//': '//name//' (column '// &
         to_text(column)//') = '//quoted(text)//' is not a finite number')
   end subroutine read_cell

end module asperity_program_commands_compare_columns_file
