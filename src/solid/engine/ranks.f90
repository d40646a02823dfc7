!> The processes that solve one problem together: ranks of MPI, whose library PETSc has brought
!> along. What is found here is the same on all of them, bit for bit, so that they decide alike; one
!> rank, or a team that was not found, does nothing.
module asperity_solid_engine_ranks
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_f_procpointer, &
      c_funptr, c_int, c_loc, c_null_ptr, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_shared_library, only: find_data, find_procedure, shared_library
   implicit none
   private
   public :: rank_team, find_ranks, meet_ranks

   abstract interface
      !> Combine arrays of all ranks on one of them
      integer(c_int) function reduce_function(own, all, n, kind, operation, root, world) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: own, all
         integer(c_int), value :: n
         type(c_ptr), value :: kind, operation
         integer(c_int), value :: root
         type(c_ptr), value :: world
      end function reduce_function
      !> Copy an array of one rank to all
      integer(c_int) function broadcast_function(array, n, kind, root, world) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: array
         integer(c_int), value :: n
         type(c_ptr), value :: kind
         integer(c_int), value :: root
         type(c_ptr), value :: world
      end function broadcast_function
      !> A number of the team
      integer(c_int) function count_function(world, number) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: world
         integer(c_int), intent(out) :: number
      end function count_function
   end interface

   !> The team, as one of its ranks sees it.
   type :: rank_team
      !> Number of this rank, from 0, and how many there are
      integer :: rank = 0, size = 1
      type(c_ptr), private :: world = c_null_ptr, doubles = c_null_ptr, bytes = c_null_ptr, &
         summing = c_null_ptr, greatest = c_null_ptr
      procedure(reduce_function), pointer, nopass, private :: reduce => null()
      procedure(broadcast_function), pointer, nopass, private :: broadcast => null()
      procedure(count_function), pointer, nopass, private :: get_rank => null(), &
         get_size => null()
   contains
      procedure, private :: sum_list, sum_table
      !> Sums of the numbers of all ranks, in their place
      generic :: sum => sum_list, sum_table
      !> Largest of the numbers of all ranks, in their place
      procedure :: maximum
      !> The numbers of the first rank, in their place
      procedure :: take_first
      !> Whether it is so on any rank
      procedure :: any => any_rank
      !> An error of any rank becomes one of all
      procedure :: agree
   end type rank_team

contains

   !> Find MPI's functions in a library that brings them along.
   subroutine find_ranks(team, library, is_whole)
      !> Result, which knows no ranks yet
      type(rank_team), intent(out) :: team
      !> The library
      type(shared_library), intent(in) :: library
      !> Set to false when something is not there
      logical, intent(inout) :: is_whole

      ! handles of Open MPI are addresses
      call take('ompi_mpi_double', team%doubles)
      call take('ompi_mpi_byte', team%bytes)
      call take('ompi_mpi_op_sum', team%summing)
      call take('ompi_mpi_op_max', team%greatest)
      call c_f_procpointer(of('MPI_Reduce'), team%reduce)
      call c_f_procpointer(of('MPI_Bcast'), team%broadcast)
      call c_f_procpointer(of('MPI_Comm_rank'), team%get_rank)
      call c_f_procpointer(of('MPI_Comm_size'), team%get_size)

   contains

      subroutine take(name, found)
         character(len=*), intent(in) :: name
         type(c_ptr), intent(out) :: found

         call find_data(library, name, found)
         is_whole = is_whole .and. c_associated(found)
      end subroutine take

      type(c_funptr) function of(name)
         character(len=*), intent(in) :: name

         call find_procedure(library, name, of)
         is_whole = is_whole .and. c_associated(of)
      end function of

   end subroutine find_ranks

   !> Learn which rank this is, once MPI has started.
   subroutine meet_ranks(team, world, code)
      !> From `find_ranks`
      type(rank_team), intent(inout) :: team
      !> MPI's handle of all ranks
      type(c_ptr), intent(in) :: world
      !> Zero on success
      integer(c_int), intent(out) :: code
      integer(c_int) :: rank, n

      team%world = world
      code = team%get_rank(world, rank)
      if (code == 0) code = team%get_size(world, n)
      if (code /= 0) return
      team%rank = rank
      team%size = n
   end subroutine meet_ranks

   !> Sums of a list.
   subroutine sum_list(self, values)
      !> The team
      class(rank_team), intent(in) :: self
      !> Numbers of this rank, then the sums
      real(wp), intent(inout) :: values(:)

      call combine(self, values, size(values), self%summing)
   end subroutine sum_list

   !> Sums of a table.
   subroutine sum_table(self, values)
      !> The team
      class(rank_team), intent(in) :: self
      !> Numbers of this rank, then the sums
      real(wp), intent(inout) :: values(:, :)

      call combine(self, values, size(values), self%summing)
   end subroutine sum_table

   !> Largest numbers.
   subroutine maximum(self, values)
      !> The team
      class(rank_team), intent(in) :: self
      !> Numbers of this rank, then the largest of all
      real(wp), intent(inout) :: values(:)

      call combine(self, values, size(values), self%greatest)
   end subroutine maximum

   !> Numbers of the first rank.
   subroutine take_first(self, values)
      !> The team
      class(rank_team), intent(in) :: self
      !> Numbers of this rank, then those of the first
      real(wp), intent(inout), target :: values(:)
      integer(c_int) :: code

      if (self%size == 1 .or. size(values) == 0) return
      call ieee_set_halting_mode(ieee_all, .false.)
      ! MPI ends all ranks by itself where it fails
      code = self%broadcast(c_loc(values), size(values, kind=c_int), self%doubles, 0_c_int, &
         self%world)
   end subroutine take_first

   !> Reduce to the first rank and copy from there: every rank has the same bits.
   subroutine combine(team, values, n, operation)
      type(rank_team), intent(in) :: team
      integer, intent(in) :: n
      real(wp), intent(inout), target :: values(n)
      type(c_ptr), intent(in) :: operation
      real(wp), allocatable, target :: own(:)
      integer(c_int) :: code

      if (team%size == 1 .or. n == 0) return
      call ieee_set_halting_mode(ieee_all, .false.)
      allocate (own, source=values)
      code = team%reduce(c_loc(own), c_loc(values), int(n, c_int), team%doubles, operation, &
         0_c_int, team%world)
      code = team%broadcast(c_loc(values), int(n, c_int), team%doubles, 0_c_int, team%world)
   end subroutine combine

   !> Whether something is so on any rank.
   logical function any_rank(self, own)
      !> The team
      class(rank_team), intent(in) :: self
      !> Whether it is so on this one
      logical, intent(in) :: own
      real(wp) :: count(1)

      count = merge(1.0_wp, 0.0_wp, own)
      call self%maximum(count)
      any_rank = count(1) > 0.5_wp
   end function any_rank

   !> Let all ranks have the error of the first of them that has one. Its message says which rank it
   !> was, but for the first rank, which tells it.
   subroutine agree(self, error)
      !> The team
      class(rank_team), intent(in) :: self
      !> The error of this rank, then that of all
      type(error_type), allocatable, intent(inout) :: error
      character(len=:), allocatable :: message, subject
      real(wp) :: first(1)
      integer :: from, numbers(3)

      if (self%size == 1) return
      first = 0.0_wp
      if (allocated(error)) first = real(self%size - self%rank, wp)
      call self%maximum(first)
      if (.not. first(1) > 0.0_wp) return
      from = self%size - nint(first(1))
      numbers = 0
      if (from == self%rank) numbers = [error%category, len(error%message), len(error%subject)]
      call copy_whole(self, numbers, from)
      message = repeat(' ', numbers(2))
      subject = repeat(' ', numbers(3))
      if (from == self%rank) then
         message = error%message
         subject = error%subject
      end if
      call copy_text(self, message, from)
      call copy_text(self, subject, from)
      if (from > 0) message = 'rank '//to_text(from)//': '//message
      call fatal_error(error, message, numbers(1), subject)
   end subroutine agree

   !> Copy whole numbers of a rank to all.
   subroutine copy_whole(team, numbers, from)
      type(rank_team), intent(in) :: team
      integer, intent(inout), target :: numbers(:)
      integer, intent(in) :: from
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      code = team%broadcast(c_loc(numbers), int(storage_size(numbers)/8*size(numbers), c_int), &
         team%bytes, int(from, c_int), team%world)
   end subroutine copy_whole

   !> Copy a text of a rank to all.
   subroutine copy_text(team, text, from)
      type(rank_team), intent(in) :: team
      character(len=*), intent(inout), target :: text
      integer, intent(in) :: from
      character(kind=c_char), pointer :: letters(:)
      integer(c_int) :: code

      if (len(text) == 0) return
      call ieee_set_halting_mode(ieee_all, .false.)
      call c_f_pointer(c_loc(text), letters, [len(text)])
      code = team%broadcast(c_loc(letters), len(text, kind=c_int), team%bytes, &
         int(from, c_int), team%world)
   end subroutine copy_text

end module asperity_solid_engine_ranks
