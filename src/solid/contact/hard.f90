!> Hard contact, enforced by a penalty, with the friction of the rough law.
module asperity_solid_contact_hard
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction, only: slide
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, contact_state
   use asperity_solid_contact_law, only: solid_law
   implicit none
   private
   public :: hard_law

   !> Penalty by default, MPa/mm: 0.06 mm of overclosure at 50 MPa. Ten times more changes the peak
   !> force of the joint by 0.2 % and takes half as many iterations again
   real(wp), parameter, public :: default_penalty = 1000.0_wp
   !> Overclosure up to which the pressure rises as its square by default, mm: a kink there would
   !> cost iterations
   real(wp), parameter, public :: default_soft_overclosure = 0.02_wp

   !> Two faces that do not enter each other, but for the penalty.
   type, extends(solid_law) :: hard_law
      !> Friction
      type(contact_properties) :: properties
      !> Rise of the pressure with the overclosure, MPa/mm
      real(wp) :: penalty = default_penalty
      !> Overclosure up to which it rises as its square, mm
      real(wp) :: soft_overclosure = default_soft_overclosure
   contains
      procedure :: update
   end type hard_law

contains

   !> With penalty k and soft overclosure s: p = k o^2/(2 s) up to s, k (o - s/2) beyond.
   subroutine update(law, start, overclosure, slip, response, error)
      class(hard_law), intent(inout) :: law
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response), intent(out) :: response
      type(error_type), allocatable, intent(out) :: error

      associate (k => law%penalty, s => law%soft_overclosure, o => max(overclosure, 0.0_wp), &
            pressure => response%traction(1))
         if (o < s) then
            pressure = k*o*o/(2.0_wp*s)
            response%tangent(1, 1) = k*o/s
            response%normal_energy = k*o**3/(6.0_wp*s)
         else
            pressure = k*(o - 0.5_wp*s)
            response%tangent(1, 1) = k
            response%normal_energy = 0.5_wp*k*o*(o - s) + k*s*s/6.0_wp
         end if
         call slide(response, law%properties, start, start%elastic_slip, overclosure, slip, &
            is_open=.not. pressure > 0.0_wp, closing=0.0_wp)
      end associate
   end subroutine update

end module asperity_solid_contact_hard
