!> What builds are compared by, in a few rounds: test/bench/builds.py runs those of several in turn.
program asperity_bench_builds
   use bench_compared, only: add_compared
   use bench_list, only: contender_list, run_contenders
   use bench_options, only: options_type, read_options
   use bench_results, only: result_row, write_csv
   implicit none
   !> Rounds of one run
   integer, parameter :: rounds = 5
   type(options_type) :: options
   type(contender_list), allocatable :: list
   type(result_row), allocatable :: rows(:)

   call read_options(options)
   options%plan%repeats = min(rounds, options%plan%repeats)
   allocate (list)
   call add_compared(list)
   call run_contenders(list, options%plan, rows)
   call write_csv(options%csv, rows)
end program asperity_bench_builds
