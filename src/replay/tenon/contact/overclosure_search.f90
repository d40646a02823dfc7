!> Search for the overclosure of a rough interface in series with wood: closure = overclosure +
!> deflection of the wood at the pressure of the interface. It is asked from outside: the caller
!> evaluates the law where the search says.
module asperity_replay_tenon_contact_overclosure_search
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: no_surface_limit
   use asperity_replay_tenon_contact_record, only: contact_record
   use asperity_replay_tenon_contact_wood_bearing, only: bearing_deflection, layers, wood_bearing
   implicit none
   private
   public :: overclosure_search, new_overclosure_search, improve_overclosure

   !> State of one search.
   type :: overclosure_search
      !> Where to evaluate next, mm; the answer once it is found
      real(wp) :: at = 0.0_wp
      logical :: found = .false.
      !> Bounds of the answer, closure and permanent indentation of the wood, mm
      real(wp), private :: low = -huge(1.0_wp), high = 0.0_wp
      real(wp), private :: closure = 0.0_wp, indentation(layers) = 0.0_wp
      !> Roughness, mm, which lengths are measured by
      real(wp), private :: sigma = 0.0_wp
   end type overclosure_search

   !> Longest Newton step inwards, in sigma: the pressure rises steeply there
   real(wp), parameter :: longest_step = 0.5_wp
   !> A Newton step this small, in sigma, ends the search: the error left is its square
   real(wp), parameter :: small_step = 1.0e-9_wp

contains

   !> First guess and bounds. It is found at once when the point is open, or the wood yields at its
   !> cap.
   pure function new_overclosure_search(wood, properties, yields_at, start, trial, closure) &
         result(search)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Rough face
      type(contact_properties), intent(in) :: properties
      !> Overclosure at the wood's first yield, mm
      real(wp), intent(in) :: yields_at
      !> Point at the start of the increment, and as it was found last
      type(contact_record), intent(in) :: start, trial
      !> Closure past first touch, mm
      real(wp), intent(in) :: closure
      type(overclosure_search) :: search
      real(wp) :: deflection, slope

      associate (s => search, sigma => properties%normal%sigma)
         s%sigma = sigma
         s%closure = closure
         s%indentation = start%indentation
         s%high = closure - sum(start%indentation)
         s%at = s%high
         s%found = properties%initial_separation - s%high &
            > properties%normal%vanishing_separation
         if (s%found) return
         if (wood%capped > 0) then
            call bearing_deflection(wood, start%indentation, wood%cap, deflection, slope)
            s%found = yields_at + deflection <= closure
            s%at = yields_at
            if (s%found) return
            s%high = min(s%high, yields_at)
         end if
         s%at = min(s%high, yields_at)
         if (trial%closure > no_surface_limit .and. trial%overclosure_by_closure < 0.99_wp) &
            s%at = min(s%high, trial%state%overclosure &
            + trial%overclosure_by_closure*(closure - trial%closure), &
            max(trial%state%overclosure, yields_at) + longest_step*sigma)
      end associate
   end function new_overclosure_search

   !> One Newton step, kept in the bounds. Both terms rise with the overclosure, so there is one
   !> answer.
   pure subroutine improve_overclosure(search, wood, pressure, stiffness)
      !> The search
      type(overclosure_search), intent(inout) :: search
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Pressure, MPa, at `search%at`, and its derivative, MPa/mm
      real(wp), intent(in) :: pressure, stiffness
      real(wp) :: deflection, slope, next, mismatch, step

      associate (s => search)
         call bearing_deflection(wood, s%indentation, pressure, deflection, slope)
         mismatch = s%at + deflection - s%closure
         if (mismatch > 0.0_wp) then
            s%high = s%at
         else
            s%low = s%at
         end if
         step = min(-mismatch/(1.0_wp + slope*stiffness), longest_step*s%sigma)
         next = min(max(s%at + step, s%low), s%high)
         s%found = abs(step) <= small_step*s%sigma
         ! out of bounds where the law bends: halve
         if (.not. s%found .and. abs(next - (s%at + step)) > 0.0_wp .and. s%low > -huge(1.0_wp)) &
            next = 0.5_wp*(s%low + s%high)
         if (.not. s%found) s%found = .not. abs(next - s%at) > 0.0_wp
         s%at = next
      end associate
   end subroutine improve_overclosure

end module asperity_replay_tenon_contact_overclosure_search
