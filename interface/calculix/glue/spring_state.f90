!> What a spring keeps from increment to increment, in the solver's state variables of its slave
!> node. All zero is a spring that never was.
module asperity_calculix_spring_state
   implicit none
   private

   enum, bind(c)
      !> Total time at the end of the last increment in which the spring existed
      enumerator :: slot_time = 1
      !> Factor below 1 that UINTER asked of the increment, 0 for none
      enumerator :: slot_pnewdt
      !> Tractions (3), and stored energy per area
      enumerator :: slot_stress, slot_energy = 6
      !> Accumulated motion in the two slip directions
      enumerator :: slot_slip, slot_status = 9
      !> LOPENCLOSE + 1 in `slot_status`, LSTATE + 1
      enumerator :: slot_user_status
   end enum
   public :: slot_time, slot_pnewdt, slot_stress, slot_energy, slot_slip, slot_status, &
      slot_user_status
   !> How many there are; STATEV comes after them
   integer, parameter, public :: own_slots = slot_user_status

end module asperity_calculix_spring_state
