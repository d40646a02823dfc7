!> Results as tables: for the terminal, and as Markdown for docs/performance.md.
module bench_report
   use, intrinsic :: iso_fortran_env, only: output_unit
   use asperity, only: version, wp
   use bench_machine, only: machine_type
   use bench_options, only: options_type
   use bench_results, only: find_row, result_row, short, with_spread
   implicit none
   private
   public :: print_header, print_contenders, print_scaling, write_markdown

   !> Between the cells of a Markdown table
   character(len=*), parameter :: bar = ' | '

contains

   !> Machine, compiler, date, and what the figures are.
   subroutine print_header(machine, options)
      type(machine_type), intent(in) :: machine
      type(options_type), intent(in) :: options

      print '(4a)', 'asperity ', version, ' benchmarks, ', machine%date
      call write_machine(output_unit, machine)
      print '(5a)', trim(machine%compiler), ', ', trim(options%level), ' ', trim(options%flags)
      print '(a)', 'Pair transverse-tangential, separations uniform in h = d/sigma = -8..8 in '// &
         'random order, 1e4', 'points, pressure and stiffness of each, unless a row says otherwise.'
      print '(a, i0, a, i0, a)', 'Medians of ', options%plan%repeats, ' repeats of ', &
         nint(1.0e3_wp*options%plan%least), ' ms or more, contenders in turn; in brackets the '// &
         '10 and 90 % quantiles.'
   end subroutine print_header

   subroutine write_machine(unit, machine)
      integer, intent(in) :: unit
      type(machine_type), intent(in) :: machine

      write (unit, '(2a, i0, 5a)') trim(machine%processor), ', ', machine%cores, ' cores, ', &
         trim(short(machine%memory)), ' GB; ', trim(machine%system)
   end subroutine write_machine

   !> Ratios, then times with errors.
   subroutine print_contenders(rows, options)
      type(result_row), intent(in) :: rows(:)
      type(options_type), intent(in) :: options
      integer :: i

      print '(/, a56, 2a26)', [character(len=56) :: 'Ratios', 'over compiled batch', &
         'over read-write loop']
      do i = 1, size(rows)
         if (rows(i)%section == 'time') print '(a56, 2a26)', rows(i)%name, &
            figure(rows, 'over batch', rows(i)%name), figure(rows, 'over loop', rows(i)%name)
      end do
      print '(a)', 'The loop reads one and writes two doubles a point, over 1e4 points; over '// &
         '1e7 for rows of 1e7.'
      print '(/, a56, a23, 2a17)', [character(len=56) :: 'Times; errors, largest and rms', &
         'ns a point', 'pressure', 'stiffness']
      do i = 1, size(rows)
         if (rows(i)%section == 'time') print '(a56, a23, 2a17)', rows(i)%name, &
            with_spread(rows(i)%value), errors(rows, rows(i)%name, 'pressure'), &
            errors(rows, rows(i)%name, 'stiffness')
      end do
      print '(a)', 'Errors are relative, against the direct evaluation.'
      print '(/, a56, a)', [character(len=56) :: 'Law with memory', 'over the reversible one']
      do i = 1, size(rows)
         if (rows(i)%section == 'over reversible') &
            print '(a56, a)', rows(i)%name, with_spread(rows(i)%value)
      end do
      i = findloc(rows%section, 'time', dim=1)
      if (rows(i)%repeats < options%plan%repeats) print '(a, i0, a)', 'Only ', rows(i)%repeats, &
         ' repeats, as more would take too long.'
   end subroutine print_contenders

   !> Building, size, growth with points and threads.
   subroutine print_scaling(rows, no_points, no_threads)
      type(result_row), intent(in) :: rows(:)
      !> Why rows are missing; blank when none is
      character(len=*), intent(in) :: no_points, no_threads
      integer :: i

      print '(/, a)', 'Compiling a law'
      do i = 1, size(rows)
         if (rows(i)%section == 'building') print '(a56, 2a)', rows(i)%name, &
            trim(with_spread(rows(i)%value)), ' ms'
         if (rows(i)%section == 'size') print '(a56, i0, a)', rows(i)%name, &
            nint(rows(i)%value%median), ' bytes'
      end do
      print '(/, a14, 3a26, a7)', [character(len=26) :: 'Points', 'batch, ns a point', &
         'loop, ns a point', 'batch over loop', 'repeats']
      do i = 1, size(rows)
         if (rows(i)%section == 'growth, batch') print '(a14, 3a26, i4)', rows(i)%name, &
            with_spread(rows(i)%value), figure(rows, 'growth, loop', rows(i)%name), &
            figure(rows, 'growth, ratio', rows(i)%name), rows(i)%repeats
      end do
      if (no_points /= '') print '(2a)', 'left out: ', trim(no_points)
      print '(/, a22, a20, a18, a20, a20)', [character(len=22) :: 'Threads', 'batch, ns a point', &
         'times as fast', 'loop, ns a point', 'times as fast']
      do i = 1, size(rows)
         if (rows(i)%section == 'threads, batch') print '(a22, a20, a18, a20, a20)', rows(i)%name, &
            with_spread(rows(i)%value), figure(rows, 'threads, batch gain', rows(i)%name), &
            figure(rows, 'threads, loop', rows(i)%name), &
            figure(rows, 'threads, loop gain', rows(i)%name)
      end do
      if (no_threads /= '') print '(2a)', 'left out: ', trim(no_threads)
   end subroutine print_scaling

   !> The table of docs/performance.md: contenders, then compiling and growth in a few lines.
   subroutine write_markdown(path, machine, options, rows)
      character(len=*), intent(in) :: path
      type(machine_type), intent(in) :: machine
      type(options_type), intent(in) :: options
      type(result_row), intent(in) :: rows(:)
      integer :: unit, status, i

      open (newunit=unit, file=path, action='write', status='replace', iostat=status)
      if (status /= 0) error stop 'bench: the Markdown file cannot be written'
      call write_machine(unit, machine)
      write (unit, '(8a)') trim(machine%compiler), ', ', trim(options%level), '; ', machine%date, &
         '. Medians, in brackets 10 and 90 % quantiles.'
      write (unit, '(/, a, /, a)') '| | over compiled batch | over read-write loop | '// &
         'ns a point | error of pressure | error of stiffness |', '|---|---|---|---|---|---|'
      do i = 1, size(rows)
         if (rows(i)%section /= 'time' .or. is_minor(rows(i)%name)) cycle
         associate (name => rows(i)%name)
            write (unit, '(13a)') '| ', trim(adjustl(name)), bar, &
               trim(figure(rows, 'over batch', name)), bar, &
               trim(figure(rows, 'over loop', name)), bar, trim(with_spread(rows(i)%value)), bar, &
               trim(errors(rows, name, 'pressure')), bar, &
               trim(errors(rows, name, 'stiffness')), ' |'
         end associate
      end do
      call write_memory(unit, rows)
      write (unit, '(/, a)', advance='no') 'Compiling a law takes'
      do i = 1, size(rows)
         if (rows(i)%section == 'building') write (unit, '(5a)', advance='no') ' ', &
            trim(with_spread(rows(i)%value)), ' ms (', trim(rows(i)%name), '),'
      end do
      write (unit, '(2(a, i0), a)') ' and the result ', bytes('size'), ' bytes, ', &
         bytes('size with memory'), ' with memory.'
      call write_growth(unit, rows)
      close (unit)

   contains

      integer function bytes(name)
         character(len=*), intent(in) :: name

         bytes = nint(rows(find_row(rows, 'size', name))%value%median)
      end function bytes

   end subroutine write_markdown

   !> A second table: the law with memory beside the reversible one.
   subroutine write_memory(unit, rows)
      integer, intent(in) :: unit
      type(result_row), intent(in) :: rows(:)
      integer :: i

      write (unit, '(/, a, /, a)') '| law with memory | over the reversible law | ns a point |', &
         '|---|---|---|'
      do i = 1, size(rows)
         if (rows(i)%section == 'over reversible') write (unit, '(7a)') '| ', &
            trim(rows(i)%name), bar, trim(with_spread(rows(i)%value)), bar, &
            trim(figure(rows, 'time', rows(i)%name)), ' |'
      end do
   end subroutine write_memory

   !> Growth with points and threads in a few lines.
   subroutine write_growth(unit, rows)
      integer, intent(in) :: unit
      type(result_row), intent(in) :: rows(:)
      integer :: i, j

      write (unit, '(a)', advance='no') 'Batches, ns a point, and their ratio to the loop:'
      do i = 1, size(rows)
         if (rows(i)%section /= 'growth, batch') cycle
         j = find_row(rows, 'growth, ratio', rows(i)%name)
         write (unit, '(7a)', advance='no') ' ', trim(rows(i)%name), ' points ', &
            trim(short(rows(i)%value%median)), ', ', trim(short(rows(j)%value%median)), ';'
      end do
      write (unit, '(a)') ' separations in random order.'
      do i = 1, size(rows)
         if (rows(i)%section /= 'threads, batch gain') cycle
         ! one thread is as fast as one thread
         if (.not. rows(i)%value%low < rows(i)%value%high) cycle
         write (unit, '(6a)') 'Times as fast as one thread, ', trim(rows(i)%name), ': ', &
            trim(with_spread(rows(i)%value)), ', the loop ', &
            trim(figure(rows, 'threads, loop gain', rows(i)%name))//'.'
      end do
   end subroutine write_growth

   !> Rows that the table of all contenders can do without.
   pure logical function is_minor(name)
      character(len=*), intent(in) :: name

      is_minor = any(name == [character(len=60) :: 'direct evaluation, h = 1..5', &
         'compiled law, batch, h = 1..5', 'table of 200 rows, search, h = 1..5', &
         'update_contact_points, tractions, h = 1..5'])
      is_minor = is_minor .or. index(name, ', reversible, ') > 0 .or. index(name, ', memory, ') > 0
   end function is_minor

   !> A figure with its spread, blank when there is none.
   pure function figure(rows, section, name) result(text)
      type(result_row), intent(in) :: rows(:)
      character(len=*), intent(in) :: section, name
      character(len=32) :: text
      integer :: i

      i = find_row(rows, section, name)
      text = ''
      if (i > 0) text = with_spread(rows(i)%value)
   end function figure

   !> Largest and root-mean-square error of a contender, blank when it has none.
   pure function errors(rows, name, quantity) result(text)
      type(result_row), intent(in) :: rows(:)
      character(len=*), intent(in) :: name, quantity
      character(len=32) :: text
      integer :: largest, rms

      largest = find_row(rows, 'largest error', trim(name)//': '//quantity)
      rms = find_row(rows, 'rms error', trim(name)//': '//quantity)
      text = ''
      if (largest > 0 .and. rms > 0) text = trim(short(rows(largest)%value%median))//', '// &
         short(rows(rms)%value%median)
   end function errors

end module bench_report
