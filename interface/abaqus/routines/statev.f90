!> What stands where in STATEV of UINTER and VUINTER, and nothing else: every reader and writer
!> of it uses these names.
module asperity_abaqus_statev
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: stick_number
   use asperity_contact_friction_settings, only: most_stick_elements, stick_summits
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_state
   implicit none
   private
   public :: state_from_statev, statev_from_state, statev_needed

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
      !> Of friction that is not plain: how far it has gone from rest, 0, to motion, 1, and the
      !> angle by which slip directions have turned over the grain, radians
      enumerator :: state_motion_share, state_grain_turn
      !> Elastic slip of the first of the summits' elements in the two slip directions, mm; the next
      !> ones follow
      enumerator :: state_summit_slip
   end enum
   public :: state_status, state_overclosure, state_pressure, state_normal_energy, &
      state_elastic_slip_1, state_elastic_slip_2, state_largest_closure, state_dissipation, &
      state_pressure_coupling, state_validity, state_warned, state_motion_share, &
      state_grain_turn, state_summit_slip
   !> DEPVAR that UINTER and VUINTER need at least, and at most
   integer, parameter, public :: n_statev = state_warned, &
      most_statev = state_grain_turn + 2*most_stick_elements

contains

   !> DEPVAR that UINTER and VUINTER need for these properties.
   pure integer function statev_needed(properties) result(needed)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      needed = n_statev
      if (properties%friction_is_plain) return
      needed = state_grain_turn
      if (properties%friction%stick == stick_summits) needed = needed + 2*stick_number(properties)
   end function statev_needed

   !> State of a point from as many slots of STATEV as `statev_needed` says.
   pure subroutine state_from_statev(statev, state)
      !> At least `n_statev` numbers; no more than the properties need
      real(wp), intent(in) :: statev(:)
      !> State of the point; what STATEV has no slots for is left alone
      type(contact_state), intent(inout) :: state
      integer :: j

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
      if (size(statev) < state_grain_turn) return
      state%motion_share = statev(state_motion_share)
      state%grain_turn = statev(state_grain_turn)
      do j = 1, elements_of(statev)
         state%summit_slip(:, j) = statev(state_summit_slip + 2*j - 2:state_summit_slip + 2*j - 1)
      end do
   end subroutine state_from_statev

   !> Write a state to as many slots of STATEV as `statev_needed` says; that of warnings is left
   !> alone.
   pure subroutine statev_from_state(state, statev)
      !> State of the point
      type(contact_state), intent(in) :: state
      !> At least `n_statev` numbers; no more than the properties need
      real(wp), intent(inout) :: statev(:)
      integer :: j

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
      if (size(statev) < state_grain_turn) return
      statev(state_motion_share) = state%motion_share
      statev(state_grain_turn) = state%grain_turn
      do j = 1, elements_of(statev)
         statev(state_summit_slip + 2*j - 2:state_summit_slip + 2*j - 1) = state%summit_slip(:, j)
      end do
   end subroutine statev_from_state

   !> Elements of the summits' stick that a STATEV has room for.
   pure integer function elements_of(statev)
      real(wp), intent(in) :: statev(:)

      elements_of = min((size(statev) - state_grain_turn)/2, most_stick_elements)
   end function elements_of

end module asperity_abaqus_statev
