!> One contact point of the tenon joint: interface and wood under it in series, and friction.
!>
!> Rough: the contact-point update is the only law of pressure, friction, status and energy; how far
!> the interface closes is found from closure = overclosure + deflection of the wood. UINTER may
!> stand in its place. Hard: the interface does not close, with the same friction.
module asperity_replay_tenon_contact
   use asperity_abaqus_props_and_statev, only: state_from_statev
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use asperity_contact_point, only: advance_contact_point
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_state, only: contact_response, contact_state, no_opposite_surface, &
      no_rotation, no_surface_limit, status_open, status_slip, status_stick
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: vanishing_separation
   use asperity_replay_abaqus_host, only: host_point, refuse_cut, try_increment
   use asperity_replay_tenon_contact_wood_bearing, only: bearing_deflection, bearing_indentation, &
      bearing_pressure, layers, wood_bearing
   implicit none
   private
   public :: contact_record, press_hard, press_rough, press_through_uinter, rub, leave_surface, &
      leave_through_uinter, rub_through_uinter, yield_overclosure

   !> A contact point at the end of an increment.
   type :: contact_record
      !> Place in the mortise, mm, and slip since the start, mm
      real(wp) :: place(2) = 0.0_wp, slip(2) = 0.0_wp
      !> Share of the point's area that is in the mortise
      real(wp) :: weight = 0.0_wp
      !> Closure past first touch of the undeformed wood, mm
      real(wp) :: closure = no_opposite_surface
      !> Its overclosure, pressure, elastic slip, status: what the update remembers
      type(contact_state) :: state = contact_state()
      !> Permanent indentation of the wood, mm
      real(wp) :: indentation(layers) = 0.0_wp
      !> Shear stresses, MPa
      real(wp) :: shear(2) = 0.0_wp
      !> Derivatives of pressure and shear stress by closure, of shear stress by slip, MPa/mm
      real(wp) :: stiffness = 0.0_wp, shear_by_closure(2) = 0.0_wp, shear_by_slip(2, 2) = 0.0_wp
      !> Derivative of the overclosure by closure
      real(wp) :: overclosure_by_closure = 1.0_wp
      !> Stored tangential energy per area, N/mm; frictional dissipation and pressure coupling of
      !> the increment
      real(wp) :: tangential_energy = 0.0_wp, dissipation = 0.0_wp, pressure_coupling = 0.0_wp
   end type contact_record

   integer, parameter :: max_iterations = 100
   !> Longest Newton step inwards, in sigma: the pressure rises steeply there
   real(wp), parameter :: longest_step = 0.5_wp
   !> A Newton step this small, in sigma, ends the search: the error left is its square
   real(wp), parameter :: small_step = 1.0e-9_wp

contains

   !> Nothing is opposite to the point: it forgets its elastic slip, not its indentation.
   pure subroutine leave_surface(start, trial)
      !> Point before and after
      type(contact_record), intent(in) :: start
      type(contact_record), intent(inout) :: trial

      trial%closure = no_opposite_surface
      trial%weight = 0.0_wp
      trial%indentation = start%indentation
      trial%state = contact_state(status=status_open, overclosure=no_opposite_surface, &
         validity=start%state%validity)
      call clear(trial)
   end subroutine leave_surface

   !> The same, told to UINTER.
   subroutine leave_through_uinter(start, trial, host, error)
      !> Point before and after
      type(contact_record), intent(in) :: start
      type(contact_record), intent(inout) :: trial
      !> The host of this point
      type(host_point), intent(inout) :: host
      !> Set when UINTER broke its contract
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      call ask_uinter(host, no_opposite_surface, [0.0_wp, 0.0_wp], response, error)
      call leave_surface(start, trial)
   end subroutine leave_through_uinter

   pure subroutine clear(trial)
      type(contact_record), intent(inout) :: trial

      trial%shear = 0.0_wp
      trial%stiffness = 0.0_wp
      trial%shear_by_closure = 0.0_wp
      trial%shear_by_slip = 0.0_wp
      trial%overclosure_by_closure = 1.0_wp
      trial%tangential_energy = 0.0_wp
      trial%dissipation = 0.0_wp
      trial%pressure_coupling = 0.0_wp
   end subroutine clear

   !> Overclosure at which the rough face reaches the first yield pressure of the wood, mm.
   pure subroutine yield_overclosure(wood, properties, overclosure, error)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Properties of the rough face
      type(contact_properties), intent(in) :: properties
      !> Result
      real(wp), intent(out) :: overclosure
      !> Set when the pressure is out of reach
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: separation

      call separation_for_pressure(properties%normal, minval(wood%yield), separation, error)
      overclosure = properties%initial_separation - separation
   end subroutine yield_overclosure

   !> Hard contact: the wood alone gives the pressure.
   pure subroutine press_hard(wood, properties, start, closure, slip, trial)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Friction
      type(contact_properties), intent(in) :: properties
      !> Point at the start of the increment
      type(contact_record), intent(in) :: start
      !> Closure at its end, mm, and slip within it, mm
      real(wp), intent(in) :: closure, slip(2)
      !> Point at the end
      type(contact_record), intent(inout) :: trial
      real(wp) :: pressure, stiffness

      call bearing_pressure(wood, start%indentation, closure, pressure, stiffness)
      trial%closure = closure
      call rub(properties, start, min(closure - sum(start%indentation), 0.0_wp), pressure, &
         stiffness, slip, trial, closure - sum(start%indentation))
      trial%indentation = bearing_indentation(wood, start%indentation, pressure, closure)
      trial%overclosure_by_closure = merge(1.0_wp, 0.0_wp, pressure <= 0.0_wp)
   end subroutine press_hard

   !> Friction of a rigid interface at a known pressure, with the order and the energies of the
   !> contact-point update: the pressure changes first, then the point slips. The point is open when
   !> there is no pressure, and closes where its overclosure passes zero.
   pure subroutine rub(properties, start, overclosure, pressure, stiffness, slip, trial, approach)
      !> Friction
      type(contact_properties), intent(in) :: properties
      !> Point at the start of the increment
      type(contact_record), intent(in) :: start
      !> Overclosure, mm; zero while closed
      real(wp), intent(in) :: overclosure
      !> Pressure, MPa, and its derivative by closure, MPa/mm
      real(wp), intent(in) :: pressure, stiffness
      !> Slip within the increment, mm
      real(wp), intent(in) :: slip(2)
      !> Point at the end
      type(contact_record), intent(inout) :: trial
      !> Closure past contact, mm: where it is absent, the point was and is closed
      real(wp), intent(in), optional :: approach
      type(slip_path) :: path
      real(wp) :: gamma(2), gamma_by_pressure(2), energy, kept_energy, scale
      real(wp) :: share, share_by_closure
      logical :: was_closed

      was_closed = start%state%status == status_stick .or. start%state%status == status_slip
      gamma = 0.0_wp
      if (was_closed) gamma = start%state%elastic_slip
      scale = properties%friction_coefficient/properties%critical_slip
      energy = 0.5_wp*scale*start%state%pressure*dot_product(gamma, gamma)
      gamma_by_pressure = 0.0_wp
      if (properties%friction_rule == rule_dissipative .and. pressure > start%state%pressure) then
         gamma_by_pressure = -gamma*(start%state%pressure/pressure)/pressure
         gamma = gamma*(start%state%pressure/pressure)
      end if
      kept_energy = 0.5_wp*scale*pressure*dot_product(gamma, gamma)
      call clear(trial)
      if (properties%friction_rule == rule_dissipative) then
         trial%dissipation = max(energy - kept_energy, 0.0_wp)
      else
         trial%pressure_coupling = kept_energy - energy
      end if
      trial%state = start%state
      trial%state%overclosure = overclosure
      trial%state%pressure = pressure
      trial%state%elastic_slip = 0.0_wp
      trial%state%status = status_open
      if (.not. pressure > 0.0_wp) return

      share = 1.0_wp
      share_by_closure = 0.0_wp
      if (present(approach) .and. start%state%status == status_open &
            .and. start%state%overclosure > no_surface_limit) then
         share = approach/(approach - start%state%overclosure)
         share_by_closure = -start%state%overclosure/(approach - start%state%overclosure)**2
      end if
      path = integrate_slip(gamma, share*slip, properties%critical_slip, &
         properties%slip_integration)
      trial%state%status = merge(status_slip, status_stick, path%slips)
      trial%state%elastic_slip = path%elastic_slip
      trial%tangential_energy = 0.5_wp*scale*pressure &
         *dot_product(path%elastic_slip, path%elastic_slip)
      trial%dissipation = trial%dissipation &
         + properties%friction_coefficient*pressure*path%slipped
      trial%shear = scale*pressure*path%elastic_slip
      trial%stiffness = stiffness
      trial%shear_by_closure = scale*stiffness*(path%elastic_slip &
         + pressure*matmul(path%by_start, gamma_by_pressure)) &
         + scale*pressure*share_by_closure*matmul(path%by_increment, slip)
      trial%shear_by_slip = scale*pressure*share*path%by_increment
   end subroutine rub

   !> Rough contact by the contact-point update.
   pure subroutine press_rough(wood, properties, yields_at, start, closure, slip, trial, error)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Rough face, compiled
      type(contact_properties), intent(in) :: properties
      !> Overclosure at the wood's first yield, mm
      real(wp), intent(in) :: yields_at
      !> Point at the start of the increment
      type(contact_record), intent(in) :: start
      !> Closure at its end, mm, and slip within it, mm
      real(wp), intent(in) :: closure, slip(2)
      !> Point at the end; what it holds before is the first guess
      type(contact_record), intent(inout) :: trial
      !> Set when no overclosure is found
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response
      real(wp) :: u, low, high, pressure, stiffness, step
      integer :: iteration
      logical :: found

      call guess_overclosure(wood, properties, yields_at, start, closure, trial, u, low, high, &
         found)
      do iteration = 1, max_iterations
         if (found) exit
         call evaluate_compiled_law(properties%compiled, properties%initial_separation - u, &
            pressure, stiffness)
         call improve_overclosure(wood, start%indentation, closure, pressure, stiffness, &
            properties%normal%sigma, u, low, high, step, found)
      end do
      if (.not. found) then
         call refuse(error, closure)
         return
      end if
      call advance_contact_point(properties, start%state, u, slip, no_rotation, response)
      call take_response(wood, start, closure, yields_at, response, trial)
   end subroutine press_rough

   !> The same with UINTER in place of the update.
   subroutine press_through_uinter(wood, properties, yields_at, start, closure, slip, trial, host, &
         error)
      !> As for `press_rough`
      type(wood_bearing), intent(in) :: wood
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: yields_at
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure, slip(2)
      type(contact_record), intent(inout) :: trial
      !> The host of this point
      type(host_point), intent(inout) :: host
      !> Set when no overclosure is found or UINTER broke its contract
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response
      real(wp) :: u, low, high, step
      integer :: iteration
      logical :: found

      call guess_overclosure(wood, properties, yields_at, start, closure, trial, u, low, high, &
         found)
      do iteration = 1, max_iterations
         if (found) exit
         call ask_uinter(host, u, slip, response, error)
         if (allocated(error)) return
         call improve_overclosure(wood, start%indentation, closure, response%traction(1), &
            response%tangent(1, 1), properties%normal%sigma, u, low, high, step, found)
      end do
      if (found) then
         call ask_uinter(host, u, slip, response, error)
         if (.not. allocated(error)) &
            call take_response(wood, start, closure, yields_at, response, trial)
      else
         call refuse(error, closure)
      end if
   end subroutine press_through_uinter

   !> Friction of a point whose overclosure is known, by UINTER.
   subroutine rub_through_uinter(start, overclosure, slip, trial, host, error)
      !> Point at the start
      type(contact_record), intent(in) :: start
      !> Overclosure at the end, mm, and slip within the increment, mm
      real(wp), intent(in) :: overclosure, slip(2)
      !> Point at the end
      type(contact_record), intent(inout) :: trial
      !> The host of this point
      type(host_point), intent(inout) :: host
      !> Set when UINTER broke its contract
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      call ask_uinter(host, overclosure, slip, response, error)
      if (allocated(error)) return
      call take_response(wood_bearing(), start, overclosure, huge(1.0_wp), response, trial)
   end subroutine rub_through_uinter

   !> First guess of the overclosure, and its bounds. `found` when the point is open, or the wood
   !> yields at its cap.
   pure subroutine guess_overclosure(wood, properties, yields_at, start, closure, trial, u, low, &
         high, found)
      type(wood_bearing), intent(in) :: wood
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: yields_at, closure
      type(contact_record), intent(in) :: start, trial
      real(wp), intent(out) :: u, low, high
      logical, intent(out) :: found
      real(wp) :: deflection, slope

      low = -huge(1.0_wp)
      high = closure - sum(start%indentation)
      u = high
      found = properties%initial_separation - high > vanishing_separation*properties%normal%sigma
      if (found) return
      if (wood%capped > 0) then
         call bearing_deflection(wood, start%indentation, wood%cap, deflection, slope)
         found = yields_at + deflection <= closure
         u = yields_at
         if (found) return
         high = min(high, yields_at)
      end if
      u = min(high, yields_at)
      if (trial%closure > no_surface_limit .and. trial%overclosure_by_closure < 0.99_wp) &
         u = min(high, trial%state%overclosure &
         + trial%overclosure_by_closure*(closure - trial%closure), &
         max(trial%state%overclosure, yields_at) + longest_step*properties%normal%sigma)
   end subroutine guess_overclosure

   !> One Newton step towards closure = overclosure + deflection(pressure), kept in the bounds. Both
   !> terms rise with the overclosure, so there is one answer.
   pure subroutine improve_overclosure(wood, indentation, closure, pressure, stiffness, sigma, u, &
         low, high, step, found)
      type(wood_bearing), intent(in) :: wood
      real(wp), intent(in) :: indentation(layers), closure, pressure, stiffness, sigma
      real(wp), intent(inout) :: u, low, high
      real(wp), intent(out) :: step
      logical, intent(out) :: found
      real(wp) :: deflection, slope, next, mismatch

      call bearing_deflection(wood, indentation, pressure, deflection, slope)
      mismatch = u + deflection - closure
      if (mismatch > 0.0_wp) then
         high = u
      else
         low = u
      end if
      step = min(-mismatch/(1.0_wp + slope*stiffness), longest_step*sigma)
      next = min(max(u + step, low), high)
      found = abs(step) <= small_step*sigma
      ! out of bounds where the law bends: halve
      if (.not. found .and. abs(next - (u + step)) > 0.0_wp .and. low > -huge(1.0_wp)) &
         next = 0.5_wp*(low + high)
      if (.not. found) found = .not. abs(next - u) > 0.0_wp
      u = next
   end subroutine improve_overclosure

   !> Keep what the update returned, with derivatives by closure in place of overclosure.
   pure subroutine take_response(wood, start, closure, yields_at, response, trial)
      type(wood_bearing), intent(in) :: wood
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure, yields_at
      type(contact_response), intent(in) :: response
      type(contact_record), intent(inout) :: trial
      real(wp) :: deflection, slope, share
      logical :: at_cap

      at_cap = wood%capped > 0 .and. response%state%overclosure >= yields_at
      if (at_cap) then
         share = 0.0_wp
         trial%indentation = bearing_indentation(wood, start%indentation, wood%cap, &
            closure - response%state%overclosure)
      else
         call bearing_deflection(wood, start%indentation, response%traction(1), deflection, slope)
         share = 1.0_wp/(1.0_wp + slope*response%tangent(1, 1))
         trial%indentation = bearing_indentation(wood, start%indentation, &
            min(response%traction(1), wood%cap*(1.0_wp - epsilon(1.0_wp))), closure)
      end if
      trial%closure = closure
      trial%state = response%state
      trial%shear = response%traction(2:)
      trial%overclosure_by_closure = share
      trial%stiffness = share*response%tangent(1, 1)
      trial%shear_by_closure = share*response%tangent(2:, 1)
      trial%shear_by_slip = response%tangent(2:, 2:)
      trial%tangential_energy = response%tangential_energy
      trial%dissipation = response%dissipation
      trial%pressure_coupling = response%pressure_coupling
   end subroutine take_response

   !> One iteration of a host's increment, as the response of the update.
   subroutine ask_uinter(host, overclosure, slip, response, error)
      type(host_point), intent(inout) :: host
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response), intent(out) :: response
      type(error_type), allocatable, intent(out) :: error
      integer :: n

      n = host%ndir
      call try_increment(host, overclosure, slip(:n - 1), 1.0_wp, error)
      if (.not. allocated(error)) call refuse_cut(host, error)
      if (allocated(error)) return
      associate (t => host%trial)
         response%traction(:n) = t%stress
         response%tangent(:n, :n) = t%ddsddr
         response%state = state_from_statev(t%statev)
         response%status = response%state%status
         response%normal_energy = response%state%normal_energy
         response%tangential_energy = t%sed - response%state%normal_energy
         response%dissipation = t%sfd
         response%pressure_coupling = response%state%pressure_coupling
      end associate
      associate (start => state_from_statev(host%start%statev))
         response%pressure_coupling = response%pressure_coupling - start%pressure_coupling
      end associate
   end subroutine ask_uinter

   pure subroutine refuse(error, closure)
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in) :: closure

      call fatal_error(error, 'no overclosure found at closure = '//to_text(closure)//' mm', &
         computation_error)
   end subroutine refuse

end module asperity_replay_tenon_contact
