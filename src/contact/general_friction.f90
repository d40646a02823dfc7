!> Friction that depends on rest and motion, grain, pressure, or the summits' own stick: what
!> `slide` does where friction is not plain. Shear stress tau_i = sum of stiffness times r_i gamma_i
!> in the axes of the grain, r = (1, across/along), over elements that each stay in their domain.
module asperity_contact_general_friction
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: find_friction_elements, friction_elements
   use asperity_contact_friction_settings, only: slip_direction_associated, stick_critical_slip
   use asperity_contact_friction_strength, only: motion_ratio
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_sliding_element, only: n_by, shrink_to_domain, slide_element, &
      sliding_element, slip_domain
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use asperity_contact_state, only: contact_response, contact_state, is_closed, no_rotation, &
      status_open, status_slip, status_stick
   implicit none
   private
   public :: slide_in_general, add_friction_tangent

   !> An element of the summits' stick slips from its radius less this share of it on
   real(wp), parameter :: at_radius = 1.0e-9_wp

contains

   !> As `slide` does, once it is known what share of the increment lies after closing; what every
   !> point remembers is left to it.
   pure subroutine slide_in_general(response, properties, start, elastic_slip, overclosure, &
         slip_increment, is_open, share, share_by_overclosure, rotation, time_increment)
      !> As of `slide`
      type(contact_response), intent(inout) :: response
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: elastic_slip(2), overclosure, slip_increment(2)
      logical, intent(in) :: is_open
      !> Share of the increment after closing, and its derivative by the overclosure
      real(wp), intent(in) :: share, share_by_overclosure
      !> Rotation of the slip directions and time of the increment, s
      real(wp), intent(in), optional :: rotation(2, 2), time_increment
      type(friction_elements) :: elements, before
      type(sliding_element) :: element
      type(slip_domain) :: domain
      real(wp) :: turn(2, 2), axes(2, 2), increment(2), motion(2), motion_by(2, n_by)
      real(wp) :: stress(2), stress_by(2, n_by), rest, rest_by(n_by), first, energy, kept, total
      real(wp) :: kinetic_share
      integer :: j

      turn = no_rotation
      if (present(rotation)) turn = rotation
      associate (r => response, f => properties%friction)
         r%state%grain_turn = start%grain_turn + atan2(turn(2, 1) - turn(1, 2), &
            turn(1, 1) + turn(2, 2))
         axes = grain_axes(properties, r%state%grain_turn)
         increment = matmul(slip_increment, axes)
         motion = share*increment
         motion_by(:, 1) = share_by_overclosure*increment
         motion_by(:, 2) = [share, 0.0_wp]
         motion_by(:, 3) = [0.0_wp, share]
         call find_rest_by_rate(properties, increment, time_increment, rest, rest_by)
         kinetic_share = motion_ratio(properties)
         domain%decay = 0.0_wp
         if (f%decay_slip > 0.0_wp) domain%decay = 1.0_wp/f%decay_slip
         domain%stiffness = stiffness_ratios(properties)
         domain%direction = slip_weights(properties)

         elements%n = 0
         if (is_closed(start) .or. .not. is_open) call find_friction_elements(properties, &
            overclosure, r%traction(1), r%tangent(1, 1), elements)
         if (is_closed(start)) call find_friction_elements(properties, start%overclosure, &
            start%pressure, 0.0_wp, before)
         stress = 0.0_wp
         stress_by = 0.0_wp
         total = 0.0_wp
         r%tangential_energy = 0.0_wp
         r%dissipation = 0.0_wp
         r%pressure_coupling = 0.0_wp
         r%state%elastic_slip = 0.0_wp
         r%state%motion_share = 0.0_wp
         r%status = merge(status_open, status_slip, is_open)
         do j = 1, elements%n
            associate (k => elements%stiffness(j), k_by => elements%stiffness_by(j))
               ! the pressure changes first
               element%gamma = 0.0_wp
               element%gamma_by = 0.0_wp
               element%moved_by = 0.0_wp
               element%moved = 0.0_wp
               element%lost = 0.0_wp
               element%slips = .false.
               energy = 0.0_wp
               if (is_closed(start)) then
                  element%moved = start%motion_share
                  if (f%stick == stick_critical_slip) then
                     element%gamma = matmul(elastic_slip, axes)
                  else
                     element%gamma = matmul(matmul(turn, start%summit_slip(:, j)), axes)
                  end if
                  first = before%stiffness(j)
                  energy = 0.5_wp*first*dot_product(domain%stiffness*element%gamma, element%gamma)
                  ! at rest as when it is pressed, as the stiffness of a law with memory is then
                  if (properties%friction_rule == rule_dissipative .and. k > 0.0_wp &
                     .and. (k > first .or. (k >= first .and. k_by >= 0.0_wp))) then
                     element%gamma = element%gamma*(first/k)
                     element%gamma_by(:, 1) = -element%gamma*(k_by/k)
                  end if
               end if
               kept = 0.5_wp*k*dot_product(domain%stiffness*element%gamma, element%gamma)
               if (properties%friction_rule == rule_dissipative) then
                  r%dissipation = r%dissipation + max(energy - kept, 0.0_wp)
               else
                  r%pressure_coupling = r%pressure_coupling + kept - energy
               end if
               if (is_open) then
                  r%dissipation = r%dissipation + kept
                  cycle
               end if

               domain%kinetic = kinetic_share*elements%radius(j)
               domain%kinetic_by = [kinetic_share*elements%radius_by(j), 0.0_wp, 0.0_wp]
               domain%excess = (1.0_wp - kinetic_share)*elements%radius(j)*rest
               domain%excess_by = (1.0_wp - kinetic_share)*elements%radius(j)*rest_by
               domain%renewal = 0.0_wp
               if (domain%decay > 0.0_wp) domain%renewal = 1.0_wp/(f%decay_slip &
                  + (1.0_wp - kinetic_share)*elements%radius(j))
               call shrink_to_domain(element, domain)
               if (f%static_friction_coefficient > 0.0_wp &
                  .or. f%friction_coefficient_across > 0.0_wp) then
                  call slide_element(element, domain, motion, motion_by)
               else
                  call slide_at_one_coefficient(element, domain, motion, motion_by, &
                     properties%slip_integration)
               end if
               stress = stress + k*domain%stiffness*element%gamma
               stress_by(:, 1) = stress_by(:, 1) + k_by*domain%stiffness*element%gamma
               stress_by(1, :) = stress_by(1, :) + k*domain%stiffness(1)*element%gamma_by(1, :)
               stress_by(2, :) = stress_by(2, :) + k*domain%stiffness(2)*element%gamma_by(2, :)
               total = total + k
               r%tangential_energy = r%tangential_energy &
                  + 0.5_wp*k*dot_product(domain%stiffness*element%gamma, element%gamma)
               r%dissipation = r%dissipation + k*element%lost
               if (.not. element%slips) r%status = status_stick
               r%state%motion_share = element%moved
               if (f%stick /= stick_critical_slip) &
                  r%state%summit_slip(:, j) = matmul(axes, element%gamma)
            end associate
         end do
         if (total > 0.0_wp) r%state%elastic_slip = matmul(axes, stress/domain%stiffness/total)
         if (is_open .and. f%stick /= stick_critical_slip) r%state%summit_slip = 0.0_wp
         r%traction(2:3) = matmul(axes, stress)
         r%tangent(1, 2:3) = 0.0_wp
         r%tangent(2:3, 1) = matmul(axes, stress_by(:, 1))
         r%tangent(2:3, 2:3) = matmul(axes, matmul(stress_by(:, 2:3), transpose(axes)))
      end associate
   end subroutine slide_in_general

   !> One coefficient in all directions, at rest and in motion: the path of plain friction.
   pure subroutine slide_at_one_coefficient(element, domain, motion, motion_by, slip_integration)
      type(sliding_element), intent(inout) :: element
      type(slip_domain), intent(in) :: domain
      real(wp), intent(in) :: motion(2), motion_by(2, n_by)
      integer, intent(in) :: slip_integration
      type(slip_path) :: path
      real(wp) :: by_radius(2)
      integer :: k

      path = integrate_slip(element%gamma, motion, domain%kinetic, slip_integration)
      ! of the first degree in start, motion and radius together
      by_radius = (path%elastic_slip - matmul(path%by_start, element%gamma) &
         - matmul(path%by_increment, motion))/domain%kinetic
      do k = 1, n_by
         element%gamma_by(:, k) = matmul(path%by_start, element%gamma_by(:, k)) &
            + matmul(path%by_increment, motion_by(:, k)) + by_radius*domain%kinetic_by(k)
      end do
      element%gamma = path%elastic_slip
      element%lost = element%lost + domain%kinetic*path%slipped
      element%slips = path%slips
   end subroutine slide_at_one_coefficient

   !> What the slip rate leaves of rest, exp(-rate/decay_slip_rate), and its derivatives. The rate
   !> is that of the relative motion: by that of the slip alone, steady slip would not be stable.
   pure subroutine find_rest_by_rate(properties, increment, time_increment, rest, rest_by)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: increment(2)
      real(wp), intent(in), optional :: time_increment
      real(wp), intent(out) :: rest, rest_by(n_by)
      real(wp) :: length, scale

      rest = 1.0_wp
      rest_by = 0.0_wp
      if (.not. present(time_increment)) return
      scale = time_increment*properties%friction%decay_slip_rate
      length = hypot(increment(1), increment(2))
      if (.not. (scale > 0.0_wp .and. length > 0.0_wp)) return
      rest = exp(-length/scale)
      rest_by(2:) = -rest/scale*(increment/length)
   end subroutine find_rest_by_rate

   !> Tangent of the shear stresses about a state: elements that stick stick, those that slip slip
   !> on and resist only across their direction, at the coefficient that they have.
   pure subroutine add_friction_tangent(properties, state, pressure, stiffness, tangent)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> A closed state
      type(contact_state), intent(in) :: state
      !> Its pressure, MPa, and normal stiffness, MPa/mm
      real(wp), intent(in) :: pressure, stiffness
      !> Rows 2 and 3 are set
      real(wp), intent(inout) :: tangent(3, 3)
      type(friction_elements) :: elements
      real(wp) :: axes(2, 2), ratios(2), gamma(2), along(2), by(2, 3), e(2, 2)
      logical :: slips
      integer :: j, i

      axes = grain_axes(properties, state%grain_turn)
      ratios = stiffness_ratios(properties)
      call find_friction_elements(properties, state%overclosure, pressure, stiffness, elements)
      by = 0.0_wp
      do j = 1, elements%n
         if (properties%friction%stick == stick_critical_slip) then
            gamma = matmul(state%elastic_slip, axes)
            slips = state%status == status_slip
         else
            gamma = matmul(state%summit_slip(:, j), axes)
            slips = hypot(gamma(1), gamma(2)) > (1.0_wp - at_radius)*elements%radius(j)
         end if
         e = no_rotation
         if (slips) then
            along = slip_weights(properties)*gamma
            do i = 1, 2
               e(:, i) = e(:, i) - along*(gamma(i)/dot_product(along, gamma))
            end do
         end if
         by(:, 1) = by(:, 1) + elements%stiffness_by(j)*ratios*gamma
         by(:, 2) = by(:, 2) + elements%stiffness(j)*ratios*e(:, 1)
         by(:, 3) = by(:, 3) + elements%stiffness(j)*ratios*e(:, 2)
      end do
      tangent(2:3, 1) = matmul(axes, by(:, 1))
      tangent(2:3, 2:3) = matmul(axes, matmul(by(:, 2:3), transpose(axes)))
   end subroutine add_friction_tangent

   !> Columns: the direction of the grain and that across it, in slip directions.
   pure function grain_axes(properties, grain_turn) result(axes)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> How far slip directions have turned since the start, radians
      real(wp), intent(in) :: grain_turn
      real(wp) :: axes(2, 2), angle

      axes = no_rotation
      if (.not. properties%friction%friction_coefficient_across > 0.0_wp) return
      angle = properties%friction%grain_angle*(pi/180.0_wp) + grain_turn
      axes = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
   end function grain_axes

   !> Stiffness along and across the grain, over that along it.
   pure function stiffness_ratios(properties) result(ratios)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: ratios(2)

      ratios = 1.0_wp
      if (properties%friction%friction_coefficient_across > 0.0_wp) ratios(2) = &
         properties%friction%friction_coefficient_across/properties%friction_coefficient
   end function stiffness_ratios

   !> A point slips along w_i gamma_i in the axes of the grain: normal to the ellipse of shear
   !> stresses, or along the shear stress.
   pure function slip_weights(properties) result(weights)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: weights(2)

      weights = stiffness_ratios(properties)
      if (properties%friction%slip_direction == slip_direction_associated) weights = 1.0_wp/weights
   end function slip_weights

end module asperity_contact_general_friction
