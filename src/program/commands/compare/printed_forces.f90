!> Totals of reaction forces that *NODE PRINT leaves in the .dat file of ABAQUS or of CalculiX.
module asperity_program_commands_compare_printed_forces
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_compare_history, only: history_type, reaction_names
   use asperity_program_record_lines, only: field, field_count, next_line, place_text, &
      place_type, start_reading
   use asperity_program_record_numbers, only: looks_like_number, read_number
   use asperity_program_system_strings, only: quoted
   implicit none
   private
   public :: is_printed, read_printed_forces

   !> What begins a total of CalculiX, and a table of ABAQUS
   character(len=*), parameter :: calculix_mark = 'total force (fx,fy,fz) for set', &
      abaqus_mark = 'TABLE IS PRINTED FOR NODES BELONGING TO NODE'
   !> What to write into the deck
   character(len=*), parameter :: remedy = &
      '*NODE PRINT, NSET=name, TOTALS=YES with RF on the next line prints them'

   !> Where the reader of tables is
   type :: table_place
      !> Total time of the increment, s
      real(wp) :: time = none
      !> Set of the table, and of the first totals
      character(len=80) :: set = '', first_set = ''
      !> Columns of RF1, RF2, RF3 among the values of a line, zero for none
      integer :: columns(3) = 0
      !> Tables with reaction forces so far
      integer :: tables = 0
   end type table_place

contains

   !> Whether a text is such a file.
   pure logical function is_printed(text)
      !> The whole file
      character(len=*), intent(in) :: text

      is_printed = index(text, calculix_mark) > 0 .or. index(text, 'TOTAL TIME COMPLETED') > 0
   end function is_printed

   !> Read the totals. `error` is set when there are none, or those of several sets.
   pure subroutine read_printed_forces(text, path, history, error)
      !> The whole file, and its path
      character(len=*), intent(in) :: text, path
      !> What it holds
      type(history_type), intent(out) :: history
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(place_type) :: place
      type(table_place) :: table
      real(wp), allocatable :: time(:), forces(:, :)
      real(wp) :: total(3)
      logical :: calculix, found
      integer :: n

      calculix = index(text, calculix_mark) > 0
      allocate (time(64), forces(3, 64))
      n = 0
      call start_reading(text, path, 0, place)
      call next_line(text, place)
      do while (place%next > 0)
         if (calculix) then
            call take_calculix(text, place, table, total, found, error)
         else
            call take_abaqus(text, place, table, total, found, error)
         end if
         if (.not. allocated(error) .and. found) call check_set(table, place, error)
         if (allocated(error)) return
         if (found) then
            if (n == size(time)) call grow(time, forces)
            n = n + 1
            time(n) = table%time
            forces(:, n) = total
         end if
         call next_line(text, place)
      end do
      if (n == 0 .and. table%tables > 0) then
         call fatal_error(error, path//': has reaction forces without totals; '//remedy)
      else if (n == 0) then
         call fatal_error(error, path//': has no totals of reaction forces; '//remedy)
      else
         call fill_history(path, time(:n), forces(:, :n), history)
      end if
   end subroutine read_printed_forces

   !> A total of CalculiX: a line that names set and time, then a line of three numbers.
   pure subroutine take_calculix(text, place, table, total, found, error)
      character(len=*), intent(in) :: text
      type(place_type), intent(inout) :: place
      type(table_place), intent(inout) :: table
      real(wp), intent(out) :: total(3)
      logical, intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      integer :: n

      total = none
      found = index(text(place%first:place%last), calculix_mark) > 0
      if (.not. found) return
      place%separator = ' '
      associate (line => text(place%first:place%last))
         n = field_count(line, ' ')
         table%set = field(line, place, n - 3)
         call read_value(field(line, place, n), place, table%time, error)
      end associate
      if (allocated(error)) return
      call next_line(text, place)
      if (place%next == 0) then
         found = .false.
      else
         call read_values(text(place%first:place%last), place, 0, [1, 2, 3], total, error)
      end if
   end subroutine take_calculix

   !> A total of ABAQUS: the summary of an increment has the time, the paragraph before a table the
   !> set, its heading the quantities, and a line that begins with TOTAL the sums.
   pure subroutine take_abaqus(text, place, table, total, found, error)
      character(len=*), intent(in) :: text
      type(place_type), intent(inout) :: place
      type(table_place), intent(inout) :: table
      real(wp), intent(out) :: total(3)
      logical, intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: time_mark = 'TOTAL TIME COMPLETED'
      integer :: n

      found = .false.
      total = none
      place%separator = ' '
      associate (line => text(place%first:place%last))
         n = index(line, time_mark)
         if (n > 0) then
            call read_value(field(line(n + len(time_mark):), place, 1), place, table%time, error)
            table%columns = 0
         else if (index(line, abaqus_mark) > 0 .or. index(line, 'FOR ALL NODES') > 0) then
            table%set = field(line, place, field_count(line, ' '))
            table%columns = 0
         else if (index(line, 'FOOT-') > 0) then
            call find_reactions(line, place, table)
         else if (table%set == 'NODE' .or. table%set == 'SET') then
            ! a long name stands on a line of its own
            table%set = field(line, place, field_count(line, ' '))
         else if (any(table%columns > 0)) then
            ! not the total time of the job
            if (field(line, place, 1) == 'TOTAL' .and. &
               verify(field(line, place, 2), '0123456789.+-ED*') == 0) then
               call read_values(line, place, 1, table%columns, total, error)
               found = .true.
            else if (index(line, 'ALL VALUES IN THIS TABLE ARE ZERO') > 0) then
               total = merge(0.0_wp, none, table%columns > 0)
               found = .true.
            end if
            if (found) table%columns = 0
         end if
      end associate
   end subroutine take_abaqus

   !> Which columns under a heading such as `NODE FOOT- U1 RF1 RF2` are reaction forces.
   pure subroutine find_reactions(line, place, table)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      type(table_place), intent(inout) :: table
      integer :: i, n

      n = 0
      table%columns = 0
      do i = 1, field_count(line, ' ')
         if (n > 0) then
            where (field(line, place, i) == [character(len=3) :: 'RF1', 'RF2', 'RF3']) &
               table%columns = n
            n = n + 1
         else if (index(field(line, place, i), 'FOOT-') > 0) then
            n = 1
         end if
      end do
      if (any(table%columns > 0)) table%tables = table%tables + 1
   end subroutine find_reactions

   !> Set `error` when totals are of another set than those before.
   pure subroutine check_set(table, place, error)
      type(table_place), intent(inout) :: table
      type(place_type), intent(in) :: place
      type(error_type), allocatable, intent(out) :: error

      if (table%first_set == '') table%first_set = table%set
      if (table%set /= table%first_set) call fatal_error(error, place_text(place)// &
         ': has totals of reaction forces of the sets '//trim(table%first_set)//' and '// &
         trim(table%set)//': print those of one face alone')
   end subroutine check_set

   !> Values of a line behind its first words.
   pure subroutine read_values(line, place, skipped, columns, values, error)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      integer, intent(in) :: skipped, columns(3)
      real(wp), intent(out) :: values(3)
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      values = none
      do i = 1, size(columns)
         if (columns(i) > 0 .and. .not. allocated(error)) &
            call read_value(field(line, place, skipped + columns(i)), place, values(i), error)
      end do
   end subroutine read_values

   !> A number as Fortran prints it, which loses the E before an exponent of three figures.
   pure subroutine read_value(text, place, value, error)
      character(len=*), intent(in) :: text
      type(place_type), intent(in) :: place
      real(wp), intent(out) :: value
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: number
      integer :: sign

      number = text
      sign = scan(number, '+-', back=.true.)
      if (sign > 1 .and. verify(number, '0123456789.+-') == 0) &
         number = number(:sign - 1)//'E'//number(sign:)
      if (looks_like_number(number)) then
         call read_number(number, 'point', value, error)
         if (.not. allocated(error)) return
      end if
      value = none
      call fatal_error(error, place_text(place)//': '//quoted(text)//' is not a finite number')
   end subroutine read_value

   !> Room for twice as many.
   pure subroutine grow(time, forces)
      real(wp), allocatable, intent(inout) :: time(:), forces(:, :)
      real(wp), allocatable :: longer(:), wider(:, :)

      allocate (longer(2*size(time)), wider(3, 2*size(time)))
      longer(:size(time)) = time
      wider(:, :size(time)) = forces
      call move_alloc(longer, time)
      call move_alloc(wider, forces)
   end subroutine grow

   !> The totals as columns; in two dimensions there is no third.
   pure subroutine fill_history(path, time, forces, history)
      character(len=*), intent(in) :: path
      real(wp), intent(in) :: time(:), forces(:, :)
      type(history_type), intent(out) :: history
      integer :: n

      n = count(forces(:, 1) < none)
      history%path = path
      allocate (history%time, source=time)
      allocate (history%values, source=transpose(forces(:n, :)))
      allocate (history%names(n), history%units(n))
      history%names = reaction_names(:n)
      history%units = 'N'
   end subroutine fill_history

end module asperity_program_commands_compare_printed_forces
