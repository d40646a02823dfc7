!> What UINTER wants to know and CalculiX does not pass to its springs: time, names, displacements
!> at the start of the increment. Wrappers of the solver's routines hand it over, on one thread,
!> before the springs are called on several; those only read it.
module asperity_calculix_ccx_state
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_int, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_calculix_interactions, only: find_interaction, has_interactions
   use asperity_calculix_outputs, only: optional_left
   use asperity_calculix_refusal, only: refuse
   use asperity_calculix_spring_state, only: slot_pnewdt
   implicit none
   private
   public :: before_results, after_results, report_time, count_call, host_type, host, know_job, &
      know_pairs, pair_of, name_of, surface_name

   !> The solver's variables, which stay where they are during a step.
   type :: host_type
      !> Displacements at the start of the increment (0:, node), mm
      real(wp), pointer :: start(:, :) => null()
      !> Step time at the end of the increment, its length, and total time at the start of the step
      real(wp), pointer :: time => null(), increment => null(), total => null()
      integer, pointer :: step => null(), number => null()
      !> Solutions of the equations in this increment so far
      integer :: iteration = 0
      !> The solver evaluates the start of a step: nothing moves
      logical :: at_rest = .true.
      !> This evaluation is the first of an attempt at an increment
      logical :: new_attempt = .false.
      !> What springs keep, as the solver has it now (value, spring), and elements before springs
      real(wp), pointer :: states(:, :) => null()
      integer :: elements = 0
      !> Names of the interactions, 80 characters each
      character(kind=c_char), pointer :: material_names(:) => null()
      !> Names of a pair: own use, slave, master; 81 characters each
      character(kind=c_char), pointer :: pair_names(:) => null()
      !> The last slave node of the pairs before each pair, then that of all
      integer, allocatable :: last_node(:)
      !> Slave nodes of all pairs
      integer, allocatable :: slave_nodes(:)
      !> Materials of the pairs, and which of these a UINTER serves
      integer, allocatable :: materials(:)
      logical, allocatable :: serves(:)
      !> Use the symmetric part of the stiffness, to compare with
      logical :: symmetric = .false.
      !> Look for outputs that UINTER does not set
      logical :: poisoned = .false.
      !> Write STATEV of every increment
      logical :: writes_states = .false.
      !> Name of the job, and whether it began from a restart file
      character(len=132) :: job = ''
      logical :: resumed = .false.
   end type host_type

   ! CalculiX' routines have no argument that could carry it
   type(host_type), protected :: host
   !> The increment that `iteration` counts in
   real(wp) :: counted(4) = -1.0_wp
   !> Calls of UINTER, those in which the faces overlapped, and the clock's ticks that all took
   integer(int64) :: calls = 0_int64, overlapping = 0_int64, ticks = 0_int64
   !> Some call with an overlap gave a stress
   logical :: stressed = .false.

contains

   !> Take over the solver's variables, and put every spring back to the start of the increment, so
   !> that one that existed in an earlier iteration alone leaves nothing behind.
   subroutine before_results(vini, mi, nk, time, dtime, ttime, istep, iinc, iout, ielas, &
         matname, tieset, ntie, nstate, ne0, xstateini, xstate, mortar) bind(c)
      !> As in CalculiX
      type(c_ptr), value :: vini, time, dtime, ttime, istep, iinc, matname, tieset
      type(c_ptr), value :: xstateini, xstate
      integer(c_int), intent(in) :: mi(*), nk, iout, ielas, ntie, nstate, ne0, mortar
      real(wp), pointer :: from(:, :)
      integer :: pair, nodes, first, last

      if (.not. has_interactions()) return
      if (mortar /= 0) call refuse('UINTER serves node to surface alone: with SURFACE TO '// &
         'SURFACE and the others CalculiX does not call it; write *CONTACT PAIR, '// &
         'INTERACTION=name, TYPE=NODE TO SURFACE, and below it the surface with the finer mesh '// &
         'first')
      call c_f_pointer(vini, host%start, [mi(2) + 1, nk])
      call c_f_pointer(time, host%time)
      call c_f_pointer(dtime, host%increment)
      call c_f_pointer(ttime, host%total)
      call c_f_pointer(istep, host%step)
      call c_f_pointer(iinc, host%number)
      call c_f_pointer(matname, host%material_names, [huge(1)])
      call c_f_pointer(tieset, host%pair_names, [3*81*ntie])
      host%at_rest = ielas == 1
      host%symmetric = is_set('TANGENT', 'symmetric')
      host%poisoned = is_set('POISON', '1')
      host%writes_states = is_set('STATES', '1')
      host%new_attempt = any(abs(counted - increment_now()) > 0.0_wp)
      if (host%new_attempt) host%iteration = 0
      counted = increment_now()
      ! zero after a solution; else displacements are prescribed, or known
      if (iout == 0) host%iteration = host%iteration + 1

      if (.not. allocated(host%serves)) return
      nodes = host%last_node(ntie + 1)
      call c_f_pointer(xstateini, from, [nstate*mi(1), ne0 + nodes])
      call c_f_pointer(xstate, host%states, [nstate*mi(1), ne0 + nodes])
      host%elements = ne0
      do pair = 1, ntie
         if (.not. host%serves(pair)) cycle
         first = ne0 + host%last_node(pair) + 1
         last = ne0 + host%last_node(pair + 1)
         host%states(:, first:last) = from(:, first:last)
      end do
   end subroutine before_results

   !> Ask for a shorter increment when a UINTER did.
   subroutine after_results(qa, mi, nstate, ne0, ntie, xstate) bind(c)
      !> As in CalculiX; the third value is the factor of the increment, negative for none
      real(c_double), intent(inout) :: qa(4)
      integer(c_int), intent(in) :: mi(*), nstate, ne0, ntie
      type(c_ptr), value :: xstate
      real(wp), pointer :: state(:, :)
      integer :: pair, node

      if (.not. has_interactions() .or. .not. allocated(host%serves)) return
      call c_f_pointer(xstate, state, [nstate*mi(1), ne0 + host%last_node(ntie + 1)])
      do pair = 1, ntie
         if (.not. host%serves(pair)) cycle
         do node = host%last_node(pair) + 1, host%last_node(pair + 1)
            associate (factor => state(slot_pnewdt, ne0 + node))
               if (.not. factor > 0.0_wp) cycle
               if (qa(3) < 0.0_wp .or. factor < qa(3)) qa(3) = factor
            end associate
         end do
      end do
   end subroutine after_results

   !> Count a call of UINTER; called on several threads.
   subroutine count_call(began, overclosure, stress)
      !> The clock when it began
      integer(int64), intent(in) :: began
      !> RDISP(1) and STRESS of the call
      real(wp), intent(in) :: overclosure, stress(:)
      integer(int64) :: ended

      call system_clock(ended)
      if (overclosure > 0.0_wp) then
         !$omp atomic
         overlapping = overlapping + 1_int64
         if (any(abs(stress) > 0.0_wp)) then
            !$omp atomic write
            stressed = .true.
         end if
      end if
      !$omp atomic
      calls = calls + 1_int64
      !$omp atomic
      ticks = ticks + (ended - began)
   end subroutine count_call

   !> Say at the end of the job how long UINTER took, and what it left unset.
   subroutine report_time() bind(c)
      integer(int64) :: rate

      call system_clock(count_rate=rate)
      if (calls > 0_int64) write (*, '(a, i0, a, f0.3, a)') ' asperity: ', calls, &
         ' calls of UINTER took ', real(ticks, wp)/real(rate, wp), ' s'
      if (has_interactions() .and. calls == 0_int64) &
         write (*, '(a)') ' *WARNING: UINTER was never called: no slave node came near a master'
      if (overlapping > 0_int64 .and. .not. stressed) write (*, '(a, i0, a)') &
         ' *WARNING: UINTER gave no stress in any of ', overlapping, &
         ' calls in which the faces overlapped'
      if (.not. host%poisoned .or. calls == 0_int64) return
      write (*, '(a)') ' asperity: UINTER sets STRESS and DDSDDR in every call that was made'
      if (optional_left() /= '') write (*, '(2a)') &
         ' asperity: UINTER leaves unset, as it may:', trim(optional_left())
   end subroutine report_time

   !> Whether the variable ASPERITY_CALCULIX_NAME of the environment has a value.
   logical function is_set(name, value)
      character(len=*), intent(in) :: name, value
      character(len=16) :: found

      call get_environment_variable('ASPERITY_CALCULIX_'//name, found)
      is_set = found == value
   end function is_set

   !> What the job is called.
   subroutine know_job(name, resumed)
      !> The solver's name
      character(len=*), intent(in) :: name
      !> It began from a restart file
      logical, intent(in) :: resumed

      host%job = name
      host%resumed = resumed
   end subroutine know_job

   !> Which of the contact pairs a UINTER serves, and which slave nodes they have.
   subroutine know_pairs(materials, last_node, slave_nodes)
      !> Material of every pair
      integer, intent(in) :: materials(:)
      !> The last slave node of the pairs before each pair, then that of all
      integer, intent(in) :: last_node(:)
      !> Slave nodes of all pairs
      integer, intent(in) :: slave_nodes(:)
      integer :: pair

      host%materials = materials
      host%last_node = last_node
      host%slave_nodes = slave_nodes
      if (allocated(host%serves)) deallocate (host%serves)
      allocate (host%serves(size(materials)))
      do pair = 1, size(materials)
         host%serves(pair) = associated(find_interaction(materials(pair)))
      end do
   end subroutine know_pairs

   !> What tells one increment, or its repetition after a cut, from others.
   function increment_now() result(values)
      real(wp) :: values(4)

      values = [real(host%step, wp), real(host%number, wp), host%time, host%increment]
   end function increment_now

   !> Number of the contact pair of a slave node.
   integer function pair_of(node)
      !> Number of the node among those of all pairs
      integer, intent(in) :: node

      pair_of = count(host%last_node(:size(host%last_node) - 1) < node)
   end function pair_of

   !> One name of a list, blank padded.
   pure function name_of(names, number, length) result(name)
      !> The list
      character(kind=c_char), intent(in) :: names(:)
      !> Which, and how long each of them is
      integer, intent(in) :: number, length
      character(len=80) :: name
      integer :: i

      name = ''
      do i = 1, min(length, len(name))
         name(i:i) = names(length*(number - 1) + i)
      end do
   end function name_of

   !> Name of the slave (2) or the master surface (3) of a pair, without the letter of its kind that
   !> the solver appends.
   function surface_name(pair, which) result(name)
      !> Number of the pair; which of the two
      integer, intent(in) :: pair, which
      character(len=80) :: name
      integer :: last

      name = name_of(host%pair_names, 3*(pair - 1) + which, 81)
      last = len_trim(name)
      if (last > 0) name(last:last) = ' '
   end function surface_name

end module asperity_calculix_ccx_state
