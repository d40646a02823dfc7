!> What a contact point remembers between increments, and what an update of it returns.
module asperity_contact_state
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_law_validity, only: valid
   implicit none
   private
   public :: contact_state, contact_response, is_closed, may_close, status_text

   !> Contact status
   enum, bind(c)
      !> Never updated: nothing is known of the point's past
      enumerator :: status_unset = 0
      !> Pressure below p_open
      enumerator :: status_open
      !> Closed; only elastic slip at the end of the increment
      enumerator :: status_stick
      !> Closed and slipping at the end of the increment
      enumerator :: status_slip
   end enum
   public :: status_unset, status_open, status_stick, status_slip

   !> Rotation of slip directions that do not turn
   real(wp), parameter, public :: no_rotation(2, 2) = &
      reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])

   !> Overclosure that stands for "no opposite surface"
   real(wp), parameter, public :: no_opposite_surface = -1.0e36_wp
   !> Any overclosure below this, mm, means the same
   real(wp), parameter, public :: no_surface_limit = -1.0e30_wp

   character(len=5), parameter :: status_names(0:3) = ['unset', 'open ', 'stick', 'slip ']

   !> What a point remembers between increments. All zero is a fresh point.
   type :: contact_state
      !> `status_unset`, `status_open`, `status_stick` or `status_slip`
      integer :: status = status_unset
      !> Overclosure, mm
      real(wp) :: overclosure = 0.0_wp
      !> Pressure, MPa
      real(wp) :: pressure = 0.0_wp
      !> Stored (recoverable) normal energy per area, N/mm
      real(wp) :: normal_energy = 0.0_wp
      !> Elastic slip in the two slip directions, mm; zero while open
      real(wp) :: elastic_slip(2) = 0.0_wp
      !> Largest overclosure reached, mm: all that a law with memory remembers
      real(wp) :: largest_closure = 0.0_wp
      !> Frictional dissipation per area since the start, N/mm
      real(wp) :: dissipation = 0.0_wp
      !> Pressure coupling per area since the start, N/mm
      real(wp) :: pressure_coupling = 0.0_wp
      !> All validity flags reached so far
      integer :: validity = valid
      !> How far the friction has gone from rest, 0, to motion, 1; by slip alone
      real(wp) :: motion_share = 0.0_wp
      !> Angle by which slip directions have turned over the grain since the start, radians
      real(wp) :: grain_turn = 0.0_wp
      !> Elastic slips of the elements of `stick_summits`, mm; set where those are asked for
      real(wp) :: summit_slip(2, most_stick_elements) = 0.0_wp
   end type contact_state

   !> Result of one update. Energies obey, on any path,
   !> work = change of (normal_energy + tangential_energy) + dissipation + plastic_dissipation
   !>    - pressure_coupling.
   type :: contact_response
      !> Pressure and the two shear stresses, MPa: positive pressure compresses, shear stress has
      !> the sign of the elastic slip
      real(wp) :: traction(3) = 0.0_wp
      !> tangent(i, j) = d traction(i)/d (overclosure, slip 1, slip 2)(j), MPa/mm; unsymmetric
      real(wp) :: tangent(3, 3) = 0.0_wp
      !> State at the end
      type(contact_state) :: state = contact_state()
      !> Stored (recoverable) normal energy per area at the end, N/mm
      real(wp) :: normal_energy = 0.0_wp
      !> Stored tangential energy per area at the end, mu p gamma^2/(2 gcrit), N/mm
      real(wp) :: tangential_energy = 0.0_wp
      !> Frictional dissipation per area of this increment, N/mm; never negative
      real(wp) :: dissipation = 0.0_wp
      !> Plastic dissipation of summits per area in this increment, N/mm; never negative, zero
      !> without memory
      real(wp) :: plastic_dissipation = 0.0_wp
      !> Energy per area that a pressure change put into stored elastic slip in this increment,
      !> N/mm; signed, zero for the dissipative rule
      real(wp) :: pressure_coupling = 0.0_wp
      !> Status at the end
      integer :: status = status_open
      !> Validity of this result
      integer :: validity = valid
   end type contact_response

contains

   !> Whether a point is known to touch.
   pure logical function is_closed(state)
      !> State of the point
      type(contact_state), intent(in) :: state

      is_closed = state%status == status_stick .or. state%status == status_slip
   end function is_closed

   !> Whether a point may close at a known overclosure: it was seen open, with a surface opposite.
   pure logical function may_close(state)
      !> State of the point
      type(contact_state), intent(in) :: state

      may_close = state%status == status_open .and. state%overclosure >= no_surface_limit
   end function may_close

   !> A status that has a name. It stands before its use, where gfortran 12 sees no interface
   !> otherwise.
   pure integer function known(status)
      integer, intent(in) :: status

      known = min(max(status, 0), 3)
   end function known

   !> Name of a status: `unset`, `open`, `stick` or `slip`.
   pure function status_text(status) result(text)
      !> One of the status enumerators
      integer, intent(in) :: status
      character(len=len_trim(status_names(known(status)))) :: text

      text = status_names(known(status))
   end function status_text

end module asperity_contact_state
