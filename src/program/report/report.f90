!> What a run has to say: its input, its results, which rows deserve to be shown.
module asperity_program_report_report
   use asperity_base_kinds, only: wp
   use asperity_program_input_key, only: given_nowhere, kind_picture, name_length
   use asperity_program_input_key_list, only: key_list
   use asperity_program_plot_figure, only: figure_type
   use asperity_program_report_table, only: table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: report_type, deck_type, named_table, turning_points

   !> A table beside the main one.
   type :: named_table
      !> Name in JSON, empty when it is not part of it
      character(len=:), allocatable :: name
      !> Heading on the terminal, empty when it is not shown
      character(len=:), allocatable :: title
      !> The table
      type(table_type) :: table
      !> How many of its columns the terminal shows, zero for all
      integer :: columns_shown = 0
   end type named_table

   !> Input for another program.
   type :: deck_type
      !> Option that asks for it, without its dashes
      character(len=8) :: option = ''
      !> What to write
      character(len=:), allocatable :: text
   end type deck_type

   !> Result of one command.
   type :: report_type
      !> Words of the command
      character(len=12) :: name = ''
      !> Its keys, and what their values are
      type(key_list) :: keys
      !> What the faces are, in a few words
      character(len=:), allocatable :: faces
      !> What a record is, as `hysteresis` finds it; not allocated elsewhere
      character(len=:), allocatable :: record_kind
      !> All results
      type(table_type) :: table
      !> Whether the terminal shows `table`
      logical :: shows_table = .true.
      !> Further tables, none when not allocated
      type(named_table), allocatable :: more(:)
      !> Every contact point, no columns when there is none
      type(table_type) :: points
      !> Pictures where they are asked for, and the title of a sheet of all of them
      type(figure_type), allocatable :: pictures(:)
      character(len=:), allocatable :: picture_title
      !> Lines that the terminal shows in the place of a table, none when not allocated; what is too
      !> long goes on behind so many blanks
      type(string_type), allocatable :: paragraphs(:)
      integer :: paragraph_indent = 0
      !> A page in HTML where it is asked for: its text before each picture and after the last
      type(string_type), allocatable :: page(:)
      !> Input for other programs, none when not allocated
      type(deck_type), allocatable :: decks(:)
      !> Whether the law was used at all: the faces touch in some step
      logical :: has_contact = .true.
      !> What is to be said of the results, one line each, none when not allocated
      type(string_type), allocatable :: remarks(:)
      !> What the results come to, one or two lines, none when not allocated
      type(string_type), allocatable :: verdict(:)
      !> One row per run, no columns when there is none
      type(table_type) :: summary
      !> Names of the columns of `table` that the terminal shows; all when not allocated
      character(len=name_length), allocatable :: shown_columns(:)
      !> First row of each run, and one past the last row
      integer, allocatable :: first_rows(:)
      !> Rows that are shown however long the table is: ends and turning points
      logical, allocatable :: important(:)
   contains
      !> Whether pictures are asked for
      procedure :: is_drawn
      !> A further table by its name, and its rows
      procedure :: table_of, table_rows
      !> Rows to show when only about so many per run fit
      procedure :: selected_rows
      !> All validity flags of the results together
      procedure :: validity
      !> What is to be said when there are none
      procedure :: valid_text
      !> Say something more of the results
      procedure :: add_remark
   end type report_type

contains

   !> Whether pictures are asked for.
   pure logical function is_drawn(self)
      !> The report
      class(report_type), intent(in) :: self

      associate (rows => self%keys%rows(:self%keys%n))
         is_drawn = any(rows%kind == kind_picture .and. rows%given /= given_nowhere)
      end associate
   end function is_drawn

   !> A further table, which must be there, by its name.
   pure function table_of(self, name) result(table)
      !> The report
      class(report_type), intent(in) :: self
      !> Its name in JSON
      character(len=*), intent(in) :: name
      type(table_type) :: table
      integer :: i

      do i = 1, size(self%more)
         if (self%more(i)%name == name) table = self%more(i)%table
      end do
   end function table_of

   !> Rows of a further table by its name.
   pure integer function table_rows(self, name) result(rows)
      !> The report
      class(report_type), intent(in) :: self
      !> Its name in JSON
      character(len=*), intent(in) :: name
      integer :: i

      rows = 0
      do i = 1, size(self%more)
         if (self%more(i)%name == name) rows = self%more(i)%table%rows
      end do
   end function table_rows

   !> Rows to show when only about `limit` per run fit: evenly spaced ones and important ones.
   pure function selected_rows(self, limit) result(rows)
      !> The report
      class(report_type), intent(in) :: self
      !> Evenly spaced rows per run
      integer, intent(in) :: limit
      integer, allocatable :: rows(:)
      logical :: chosen(self%table%rows)
      integer :: run, i

      do run = 1, size(self%first_rows) - 1
         associate (first => self%first_rows(run), next => self%first_rows(run + 1))
            chosen(first:next - 1) = thinned_rows(self%important(first:next - 1), limit)
         end associate
      end do
      rows = pack([(i, i=1, size(chosen))], chosen)
   end function selected_rows

   !> Evenly spaced rows, about `limit` of them, and the important ones unless they are more.
   pure function thinned_rows(important, limit) result(chosen)
      !> Rows to keep
      logical, intent(in) :: important(:)
      !> Evenly spaced rows
      integer, intent(in) :: limit
      logical :: chosen(size(important))
      integer :: i

      chosen = size(important) <= limit
      do i = 0, limit - 1
         chosen(1 + nint(real(i, wp)*real(size(important) - 1, wp)/real(limit - 1, wp))) = .true.
      end do
      if (count(important) <= limit) chosen = chosen .or. important
   end function thinned_rows

   !> Rows at which a history turns, with its first and last.
   pure function turning_points(values) result(turns)
      !> The history
      real(wp), intent(in) :: values(:)
      logical :: turns(size(values))
      integer :: i, direction, next

      turns = .false.
      turns(1) = .true.
      turns(size(values)) = .true.
      direction = 0
      do i = 2, size(values)
         next = merge(1, 0, values(i) > values(i - 1)) - merge(1, 0, values(i) < values(i - 1))
         if (next == 0) cycle
         if (next == -direction) turns(i - 1) = .true.
         direction = next
      end do
   end function turning_points

   !> All validity flags of the results together.
   pure integer function validity(self)
      !> The report
      class(report_type), intent(in) :: self
      integer :: i

      validity = 0
      i = self%table%find('validity')
      if (i > 0) validity = iany(self%table%columns(i)%codes)
   end function validity

   !> What is to be said when no validity flag is set.
   pure function valid_text(self) result(text)
      !> The report
      class(report_type), intent(in) :: self
      character(len=:), allocatable :: text

      text = 'no limit of the law is passed.'
      if (.not. self%has_contact) &
         text = 'the faces touch in no step, so that the law was not used.'
   end function valid_text

   !> Say something more of the results.
   pure subroutine add_remark(self, text)
      !> The report
      class(report_type), intent(inout) :: self
      !> A line
      character(len=*), intent(in) :: text
      type(string_type) :: line

      line%text = text
      if (allocated(self%remarks)) then
         self%remarks = [self%remarks, line]
      else
         self%remarks = [line]
      end if
   end subroutine add_remark

end module asperity_program_report_report
