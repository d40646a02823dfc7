!> The ranks that run the program together, as their launcher says before MPI starts.
module asperity_program_system_launch
   use, intrinsic :: iso_c_binding, only: c_int
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_system_posix, only: c_sleep
   implicit none
   private
   public :: launch_type, find_launch, check_launch, give_way, rank_words

   !> This process among them.
   type :: launch_type
      !> Its rank, from 0
      integer :: rank = 0
      !> How many there are; 0 where the launcher does not say
      integer :: size = 1
   end type launch_type

   !> What launchers set: Open MPI; MPICH, Intel MPI, Cray and Flux; srun. The script of a batch job
   !> has SLURM_PROCID as well, but not the tasks of a step
   character(len=*), parameter :: variables(2, 3) = reshape([character(len=20) :: &
      'OMPI_COMM_WORLD_RANK', 'OMPI_COMM_WORLD_SIZE', &
      'PMI_RANK', 'PMI_SIZE', &
      'SLURM_PROCID', 'SLURM_STEP_NUM_TASKS'], [2, 3])
   !> Launchers by PMIx alone set a rank, and no size
   character(len=*), parameter :: lone_rank = 'PMIX_RANK'
   !> What a launcher takes at most to end all ranks after one of them, s
   integer(c_int), parameter :: patience = 2_c_int

contains

   !> What the launcher says; one rank where none has started the program.
   type(launch_type) function find_launch() result(launch)
      integer :: i, rank, ranks

      do i = 1, size(variables, 2)
         rank = number_in(trim(variables(1, i)))
         ranks = number_in(trim(variables(2, i)))
         if (rank < 0 .or. rank >= ranks) cycle
         launch = launch_type(rank, ranks)
         return
      end do
      rank = number_in(lone_rank)
      if (rank >= 0) launch = launch_type(rank, 0)
   end function find_launch

   !> The whole number in an environment variable; -1 where there is none.
   integer function number_in(variable) result(number)
      character(len=*), intent(in) :: variable
      character(len=20) :: text
      integer :: status

      number = -1
      call get_environment_variable(variable, text, status=status)
      if (status /= 0 .or. text == '' .or. verify(trim(text), '0123456789') > 0) return
      read (text, *, iostat=status) number
      if (status /= 0) number = -1
   end function number_in

   !> Set `error` when MPI has not joined the ranks that the launcher has started: each would run
   !> alone, and all would write the same files.
   pure subroutine check_launch(launch, rank, ranks, error)
      !> What the launcher says
      type(launch_type), intent(in) :: launch
      !> This rank and their number, as MPI has them
      integer, intent(in) :: rank, ranks
      !> Set when they are not the same
      type(error_type), allocatable, intent(out) :: error

      if (rank == launch%rank .and. (ranks == launch%size .or. launch%size == 0)) return
      call fatal_error(error, 'the launcher has started rank '//to_text(launch%rank)//' of '// &
         to_text(launch%size)//', which is '//to_text(rank)//' of '//to_text(ranks)// &
         ' for MPI: start all by the mpirun of PETSc''s MPI, or by srun --mpi=pmix; '// &
         'for one rank, begin with env -u '//lone_rank//variable_words())
   end subroutine check_launch

   !> The rank before the words of what it alone tells, such as `rank 1: `; none for rank 0.
   pure function rank_words(launch) result(words)
      !> What the launcher says
      type(launch_type), intent(in) :: launch
      character(len=:), allocatable :: words

      words = ''
      if (launch%rank > 0) words = 'rank '//to_text(launch%rank)//': '
   end function rank_words

   !> Variables that say a rank, for `env`.
   pure function variable_words() result(words)
      character(len=:), allocatable :: words
      integer :: i

      words = ''
      do i = 1, size(variables, 2)
         words = words//' -u '//trim(variables(1, i))
      end do
   end function variable_words

   !> Before a rank tells an error: if rank 0 has the same one, it tells it and the launcher ends
   !> all by then.
   subroutine give_way(launch)
      !> What the launcher says
      type(launch_type), intent(in) :: launch
      integer(c_int) :: left

      if (launch%rank == 0) return
      left = c_sleep(patience)
      if (left /= 0) return
   end subroutine give_way

end module asperity_program_system_launch
