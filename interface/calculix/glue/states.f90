!> STATEV of every contact spring after every increment, as a CSV file, JOB.states.csv.
module asperity_calculix_states
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: host, pair_of, surface_name
   use asperity_calculix_interactions, only: find_interaction, interaction_type, most_depvar
   use asperity_calculix_refusal, only: refuse
   use asperity_calculix_spring_state, only: own_slots, slot_time
   implicit none
   private
   public :: write_states

   ! CalculiX' routines have no argument that could carry it
   !> Unit of the file, 0 before it is opened
   integer :: unit = 0

contains

   !> Write what the springs have after an increment.
   subroutine write_states(step, increment, time)
      !> Where the job is; total time
      integer, intent(in) :: step, increment
      real(wp), intent(in) :: time
      !> Share of an increment by which times may differ and still be the same
      real(wp), parameter :: same_time = 1.0e-6_wp
      type(interaction_type), pointer :: interaction
      integer :: node, pair, i

      if (.not. host%writes_states) return
      if (unit == 0) call open_file()
      do node = 1, size(host%slave_nodes)
         pair = pair_of(node)
         if (.not. host%serves(pair)) cycle
         interaction => find_interaction(host%materials(pair))
         associate (state => host%states(:, host%elements + node))
            ! a spring that has gone
            if (abs(state(slot_time) - time) > same_time*host%increment) cycle
            write (unit, '(2(i0, a), es0.9e2, 3a, i0)', advance='no') step, ',', increment, ',', &
               time, ',', trim(surface_name(pair, 2)), ',', host%slave_nodes(node)
            do i = 1, most_depvar()
               write (unit, '(a)', advance='no') ','
               if (i <= interaction%depvar) write (unit, '(es0.15e3)', advance='no') &
                  state(own_slots + i)
            end do
            write (unit, '(a)') ''
         end associate
      end do
      flush (unit)
   end subroutine write_states

   !> Open the file and name its columns.
   subroutine open_file()
      integer :: i, status

      open (newunit=unit, file=trim(host%job)//'.states.csv', status='replace', action='write', &
         iostat=status)
      if (status /= 0) call refuse(trim(host%job)//'.states.csv cannot be written')
      write (unit, '(a, *(a, i0))') 'step,increment,time,pair,node', &
         (',statev_', i, i=1, most_depvar())
   end subroutine open_file

end module asperity_calculix_states
