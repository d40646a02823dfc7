!> Command line of the benchmarks.
module bench_options
   use asperity, only: wp
   use bench_machine, only: available_memory
   use bench_timing, only: plan_type
   implicit none
   private
   public :: options_type, read_options

   !> What is to be done.
   type :: options_type
      !> Only that everything runs, in seconds
      logical :: short = .false.
      !> Level of optimisation, and the other flags of the compiler, as built
      character(len=60) :: level = ''
      character(len=256) :: flags = ''
      !> Results are written there, unless blank: comma-separated values, Markdown
      character(len=256) :: csv = '', markdown = ''
      !> Memory that may be used, GB
      real(wp) :: memory = 0.0_wp
      type(plan_type) :: plan
   end type options_type

contains

   !> Read the command line; ASPERITY_BENCH=short does what `--short` does.
   subroutine read_options(options)
      type(options_type), intent(out) :: options
      character(len=256) :: word, value
      integer :: i, status

      options%memory = available_memory()
      call get_environment_variable('ASPERITY_BENCH', word, status=status)
      options%short = status == 0 .and. word == 'short'
      i = 1
      do while (i <= command_argument_count())
         call get_command_argument(i, word)
         call get_command_argument(i + 1, value)
         i = i + 2
         select case (word)
         case ('--short')
            i = i - 1
            options%short = .true.
         case ('--level')
            options%level = value(:len(options%level))
         case ('--flags')
            options%flags = value
         case ('--csv')
            options%csv = value
         case ('--markdown')
            options%markdown = value
         case ('--memory')
            read (value, *, iostat=status) options%memory
            if (status /= 0) error stop 'bench: --memory takes a number of GB'
         case default
            error stop 'bench: options are --short, --memory GB, --level TEXT, --flags TEXT, '// &
               '--csv FILE, --markdown FILE'
         end select
      end do
      if (options%short) options%plan = plan_type(repeats=3, least=0.001_wp)
   end subroutine read_options

end module bench_options
