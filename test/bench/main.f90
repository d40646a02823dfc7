!> Benchmarks of one build: `./run bench` builds and runs them.
program asperity_bench
   use bench_compared, only: add_compared
   use bench_list, only: contender_list, run_contenders
   use bench_machine, only: machine_type, this_machine
   use bench_options, only: options_type, read_options
   use bench_others, only: add_others
   use bench_report, only: print_contenders, print_header, print_scaling, write_markdown
   use bench_results, only: result_row, write_csv
   use bench_scaling, only: run_building, run_growth, run_threads
   implicit none
   type(options_type) :: options
   type(machine_type) :: machine
   type(contender_list), allocatable :: list
   type(result_row), allocatable :: rows(:)
   character(len=100) :: no_points, no_threads

   call read_options(options)
   machine = this_machine()
   call print_header(machine, options)
   allocate (list)
   call add_compared(list)
   call add_others(list, options)
   call run_contenders(list, options%plan, rows)
   call print_contenders(rows, options)
   call run_building(options, rows)
   call run_growth(options, rows, no_points)
   call run_threads(options, machine%cores, rows, no_threads)
   call print_scaling(rows, no_points, no_threads)
   if (options%markdown /= '') call write_markdown(options%markdown, machine, options, rows)
   if (options%csv /= '') call write_csv(options%csv, rows)
end program asperity_bench
