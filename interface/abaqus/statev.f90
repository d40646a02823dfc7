!> What stands where in STATEV of UINTER and VUINTER, and nothing else: every reader and writer of it
!> uses these names.
module asperity_abaqus_statev
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: contact_state
   implicit none
   private
   public :: state_from_statev, statev_from_state

   !> Slots of STATEV; all zero is a fresh point
   enum, bind(c)
      !> 0 never called, 1 open, 2 stick, 3 slip
      enumerator :: state_status = 1
      !> Overclosure, mm; pressure, MPa; stored normal energy, N/mm
      enumerator :: state_overclosure, state_pressure, state_normal_energy
      !> Elastic slip in the two slip directions, mm
      enumerator :: state_elastic_slip_1, state_elastic_slip_2
      !> Largest overclosure reached, mm: the memory of elastic unloading
      enumerator :: state_largest_closure
      !> Frictional dissipation and pressure coupling since the start, N/mm
      enumerator :: state_dissipation, state_pressure_coupling
      !> Sum of the validity flags reached, and of those already warned about
      enumerator :: state_validity, state_warned
   end enum
   public :: state_status, state_overclosure, state_pressure, state_normal_energy, &
      state_elastic_slip_1, state_elastic_slip_2, state_largest_closure, state_dissipation, &
      state_pressure_coupling, state_validity, state_warned
   !> DEPVAR that UINTER and VUINTER need
   integer, parameter, public :: n_statev = state_warned

contains

   !> State of a point from STATEV.
   pure subroutine state_from_statev(statev, state)
      !> At least `n_statev` numbers
      real(wp), intent(in) :: statev(:)
      !> State of the point; all of it is set
      type(contact_state), intent(inout) :: state

      state%status = int(statev(state_status))
      state%overclosure = statev(state_overclosure)
      state%pressure = statev(state_pressure)
      state%normal_energy = statev(state_normal_energy)
      state%elastic_slip(1) = statev(state_elastic_slip_1)
      state%elastic_slip(2) = statev(state_elastic_slip_2)
      state%largest_closure = statev(state_largest_closure)
      state%dissipation = statev(state_dissipation)
      state%pressure_coupling = statev(state_pressure_coupling)
      state%validity = int(statev(state_validity))
   end subroutine state_from_statev

   !> Write a state to STATEV; the slot of warnings is left alone.
   pure subroutine statev_from_state(state, statev)
      !> State of the point
      type(contact_state), intent(in) :: state
      !> At least `n_statev` numbers
      real(wp), intent(inout) :: statev(:)

      statev(state_status) = state%status
      statev(state_overclosure) = state%overclosure
      statev(state_pressure) = state%pressure
      statev(state_normal_energy) = state%normal_energy
      statev(state_elastic_slip_1) = state%elastic_slip(1)
      statev(state_elastic_slip_2) = state%elastic_slip(2)
      statev(state_largest_closure) = state%largest_closure
      statev(state_dissipation) = state%dissipation
      statev(state_pressure_coupling) = state%pressure_coupling
      statev(state_validity) = state%validity
   end subroutine statev_from_state

end module asperity_abaqus_statev
