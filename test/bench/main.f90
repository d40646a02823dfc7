!> Benchmarks of one build: `./run bench` builds and runs them.
program asperity_bench
   use, intrinsic :: iso_fortran_env, only: error_unit
   use bench_contenders, only: run_contenders
   use bench_machine, only: machine_type, this_machine
   use bench_options, only: options_type, read_options
   use bench_report, only: print_contenders, print_header, print_levels, print_scaling, &
      write_markdown
   use bench_results, only: add_row, result_row, write_csv
   use bench_scaling, only: run_building, run_growth, run_threads
   use bench_timing, only: spread_type
   implicit none
   type(options_type) :: options
   type(machine_type) :: machine
   type(result_row), allocatable :: rows(:)
   character(len=100) :: no_points, no_threads
   logical :: sane

   call read_options(options)
   machine = this_machine()
   call add_row(rows, 'level', options%level, '-', spread_type(), 1)
   if (options%level_only) then
      call run_contenders(options, rows, sane)
   else
      call print_header(machine, options)
      call run_contenders(options, rows, sane)
      call print_contenders(rows, options)
      call run_building(options, rows)
      call run_growth(options, rows, no_points)
      call run_threads(options, machine%cores, rows, no_threads)
      call print_scaling(rows, no_points, no_threads)
      call print_levels(rows, options)
      if (options%markdown /= '') call write_markdown(options%markdown, machine, options, rows)
   end if
   if (options%csv /= '') call write_csv(options%csv, rows)
   if (.not. sane) then
      write (error_unit, '(a)') 'bench: error: an error against the direct evaluation is too '// &
         'large, or something is not a number'
      stop 1
   end if
end program asperity_bench
