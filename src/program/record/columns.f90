!> Which columns of a record are taken: those asked for by name or number, else those whose names
!> and units say that they hold what is looked for.
module asperity_program_record_columns
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_record_headings, only: rank_of, rank_unit
   use asperity_program_record_layout, only: headings_text, layout_type
   use asperity_program_record_names, only: holds_unknown, quantity_name
   use asperity_program_record_units, only: unit_time, unit_unknown
   use asperity_program_system_strings, only: lower_case, nearest_name, quoted
   use asperity_program_system_utf8, only: utf8_text
   implicit none
   private
   public :: record_column, choose_columns, number_of, column_with_name

   !> One column to read.
   type :: record_column
      !> What it holds, one of `asperity_program_record_names`, and its name for messages
      integer :: holds = holds_unknown
      character(len=:), allocatable :: name
      !> Its name in the file or its number, from one; empty if it is to be found
      character(len=:), allocatable :: wanted
      !> Option that chooses it, for messages
      character(len=:), allocatable :: option
      !> Unit that counts in place of the file's, empty for none
      character(len=:), allocatable :: unit_given
      !> Its place in a line
      integer :: place = 0
      !> Name in the file, empty if there are no names
      character(len=:), allocatable :: heading
      !> Unit in the file, empty if there is none
      character(len=:), allocatable :: unit
      !> Why it was taken: option, name, unit, rest (the others hold something else), position
      character(len=:), allocatable :: chosen_by
      !> The numbers
      real(wp), allocatable :: values(:)
   end type record_column

   integer, parameter :: longest_heading = 80

contains

   !> Find the places of the columns. `error` lists those of the file when they cannot be told.
   pure subroutine choose_columns(layout, quantities, columns, error)
      !> The file
      type(layout_type), intent(in) :: layout
      !> What the columns may hold together, one list a column; the first that the file has is taken
      integer, intent(in) :: quantities(:, :)
      !> The columns; `holds` and what was found are set
      type(record_column), intent(inout) :: columns(:)
      !> Set when there is no such column, or more than one
      type(error_type), allocatable, intent(out) :: error
      integer :: ranks(size(layout%columns), size(columns)), i, variant
      logical :: found

      do i = 1, size(columns)
         columns(i)%place = 0
         if (columns(i)%wanted /= '') call take_wanted(layout, columns(i), error)
         if (allocated(error)) return
      end do
      do variant = 1, size(quantities, 2)
         columns%holds = quantities(:, variant)
         call rank_candidates(layout, columns, ranks)
         found = all([(answers(layout, columns(i), ranks(:, i)), i=1, size(columns))])
         if (found) exit
      end do
      if (.not. found) then
         columns%holds = quantities(:, 1)
         call rank_candidates(layout, columns, ranks)
      end if
      do i = 1, size(columns)
         columns(i)%name = quantity_name(columns(i)%holds)
         if (columns(i)%wanted /= '' .or. .not. any(ranks(:, i) > 0)) cycle
         call take_best(layout, ranks(:, i), columns(i), error)
         if (allocated(error)) return
      end do
      if (.not. found) call take_rest(layout, columns, error)
      if (allocated(error)) return
      do i = 1, size(columns)
         call set_found(layout, columns(i), error)
         if (allocated(error)) return
      end do
   end subroutine choose_columns

   !> Whether a column may hold its quantity: one that was asked for unless its name and unit speak
   !> against it, another if there is a candidate.
   pure logical function answers(layout, column, ranks)
      type(layout_type), intent(in) :: layout
      type(record_column), intent(in) :: column
      integer, intent(in) :: ranks(:)

      answers = any(ranks > 0)
      if (column%place == 0) return
      answers = .true.
      if (column%place > size(layout%columns)) return
      associate (heading => layout%columns(column%place))
         answers = rank_of(heading, column%holds) > 0 .or. heading%holds == holds_unknown
      end associate
   end function answers

   !> The column that the user names.
   pure subroutine take_wanted(layout, column, error)
      type(layout_type), intent(in) :: layout
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error

      column%chosen_by = 'option'
      column%place = number_of(column%wanted)
      if (column%place == 0) &
         call column_with_name(layout, column%wanted, column%place, error)
      if (allocated(error)) error%message = column%option//': '//error%message
   end subroutine take_wanted

   !> The number that a text is, zero for a name.
   pure integer function number_of(text)
      !> The text
      character(len=*), intent(in) :: text

      number_of = 0
      if (verify(text, '0123456789') == 0 .and. len(text) > 0 .and. len(text) < 6) &
         read (text, *) number_of
   end function number_of

   !> Place of the column of a name, with or without its unit, in any case.
   pure subroutine column_with_name(layout, name, place, error)
      !> The file
      type(layout_type), intent(in) :: layout
      !> The name
      character(len=*), intent(in) :: name
      !> Its place
      integer, intent(out) :: place
      !> Set when there is none, or more than one
      type(error_type), allocatable, intent(out) :: error
      character(len=longest_heading) :: names(size(layout%columns))
      character(len=:), allocatable :: wanted, nearest
      integer :: i

      wanted = lower_case(utf8_text(name))
      place = 0
      do i = 1, size(layout%columns)
         names(i) = lower_case(layout%columns(i)%name)
         if (lower_case(layout%columns(i)%name) /= wanted &
            .and. lower_case(layout%columns(i)%text) /= wanted) cycle
         if (place > 0) then
            call refuse(layout, 'there is more than one column '//quoted(name)// &
               ', give the number of the one meant', error)
            return
         end if
         place = i
      end do
      if (place > 0) return
      nearest = nearest_name(wanted, names)
      if (nearest /= '') nearest = ', did you mean '//nearest//'?'
      call refuse(layout, 'there is no column '//quoted(name)//nearest, error)
   end subroutine column_with_name

   !> How well each column of the file answers to each that is looked for: from 1 on, the lower the
   !> better, zero where it does not.
   pure subroutine rank_candidates(layout, columns, ranks)
      type(layout_type), intent(in) :: layout
      type(record_column), intent(in) :: columns(:)
      integer, intent(out) :: ranks(:, :)
      integer :: i, j

      do j = 1, size(columns)
         do i = 1, size(layout%columns)
            ranks(i, j) = 0
            if (all(columns%place /= i)) ranks(i, j) = rank_of(layout%columns(i), columns(j)%holds)
         end do
      end do
   end subroutine rank_candidates

   !> Take the candidate of the best rank; `error` if it is not the only one.
   pure subroutine take_best(layout, ranks, column, error)
      type(layout_type), intent(in) :: layout
      integer, intent(in) :: ranks(:)
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error
      integer :: best, second

      best = minval(ranks, mask=ranks > 0)
      column%place = findloc(ranks, best, 1)
      column%chosen_by = 'name'
      if (best == rank_unit) column%chosen_by = 'unit'
      if (count(ranks == best) == 1) return
      second = column%place + findloc(ranks(column%place + 1:), best, 1)
      call refuse(layout, 'columns '//to_text(column%place)//' and '//to_text(second)// &
         ' may both be '//column%name//': choose with '//column%option, error)
   end subroutine take_best

   !> Columns that no name and no unit tell: by position where there are no names, or none says
   !> anything; what is left over where the others hold something else.
   pure subroutine take_rest(layout, columns, error)
      type(layout_type), intent(in) :: layout
      type(record_column), intent(inout) :: columns(:)
      type(error_type), allocatable, intent(out) :: error
      logical :: free(size(layout%columns))
      integer :: i, missing

      missing = count(columns%place == 0)
      free = layout%columns%holds == holds_unknown .and. layout%columns%measures == unit_unknown
      if (.not. layout%has_names .or. (all(free) .and. missing == size(columns) &
         .and. count(free) > missing)) then
         do i = 1, size(columns)
            if (columns(i)%place > 0) cycle
            columns(i)%place = i
            columns(i)%chosen_by = 'position'
         end do
         return
      end if
      free(pack(columns%place, columns%place > 0 .and. columns%place <= size(free))) = .false.
      do i = 1, size(columns)
         if (columns(i)%place > 0) cycle
         if (count(free) /= missing) then
            call refuse(layout, 'no column is '//columns(i)%name//' by its name and unit: '// &
               'choose one with '//columns(i)%option, error)
            return
         end if
         columns(i)%place = findloc(free, .true., 1)
         columns(i)%chosen_by = 'rest'
         free(columns(i)%place) = .false.
         missing = missing - 1
      end do
   end subroutine take_rest

   !> Set what the file says of a column; `error` if it is time.
   pure subroutine set_found(layout, column, error)
      type(layout_type), intent(in) :: layout
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error

      column%heading = ''
      column%unit = ''
      ! a column that is not there is told where its line is read
      if (column%place <= size(layout%columns)) then
         column%heading = layout%columns(column%place)%name
         column%unit = layout%columns(column%place)%unit
         if (layout%columns(column%place)%measures == unit_time .and. column%unit_given == '') &
            call refuse(layout, 'column '//to_text(column%place)//' is in '//column%unit// &
            ', which is time and no '//column%name//': choose another with '//column%option, error)
      end if
      if (column%unit_given /= '') column%unit = column%unit_given
   end subroutine set_found

   !> An error at the line of names that lists the columns.
   pure subroutine refuse(layout, message, error)
      type(layout_type), intent(in) :: layout
      character(len=*), intent(in) :: message
      type(error_type), allocatable, intent(out) :: error

      call fatal_error(error, layout%path//': '//message//'; '//headings_text(layout))
   end subroutine refuse

end module asperity_program_record_columns
