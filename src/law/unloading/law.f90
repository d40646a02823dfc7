!> The law of a rough face that remembers how close it came: every summit unloads from its own
!> largest deformation (see `asperity_law_unloading_summit`). One number is remembered, the closest
!> separation d_m; summits higher than d_m have the largest deformation w = z - d_m. At
!> d = d_m + u the pressure is eta Int N_u(w) phi(d_m + w) dw over the summits that still touch,
!> e(w) > u, and alike for area, stiffness and stored energy.
!>
!> The virgin branch and the elastic summits are those of the law without memory. The paper's law
!> has none; this one is Etsion, Kligerman and Kadin's idea with the paper's summits.
module asperity_law_unloading_law
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: tail_moments
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response, sum_pieces, &
      vanishing_separation
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: relative_exponent
   use asperity_law_quadrature_pieces_by_quadrature, only: piece_type, plastic_piece
   use asperity_law_unloading_pieces, only: elastic_unloading_piece, &
      elastoplastic_unloading_piece, plastic_unloading_piece
   use asperity_law_unloading_summit, only: contact_edge
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      memory_beyond_data, pressure_above_hardness
   implicit none
   private
   public :: evaluate_unloading_law, evaluate_unloading_branch, unloading_stiffness, &
      plastic_dissipation

   !> Mean deformation over w1 of the summits in contact up to which unloading was computed
   real(wp), parameter :: largest_mean_ratio = 170.0_wp
   !> Larger retractions over w1 are taken for this one: all is zero long before, and its powers are
   !> finite
   real(wp), parameter :: largest_retraction = 1.0e60_wp

contains

   !> Evaluate the law with memory at the separation closest_separation + retraction. With a
   !> retraction of zero or less the face is as close as never before: pressure, stiffness and area
   !> are those of the law without memory. The energy is what is recoverable; it and the plastic
   !> dissipation add up to the work since first touch wherever the face was pressed without pause.
   !> Relative error below 1e-11 in every component that is a normal number, for
   !> -8 <= d_m/sigma <= 8, 1e-6 <= w1/sigma <= 1e2, and retractions until the pressure is 1e-12 of
   !> that at d_m.
   pure elemental function evaluate_unloading_law(properties, closest_separation, retraction) &
         result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm
      real(wp), intent(in) :: retraction
      type(normal_response) :: response

      if (retraction > 0.0_wp) then
         call evaluate_unloading_branch(properties, closest_separation, retraction, response)
         response%plastic_dissipation = plastic_dissipation(properties, closest_separation)
      else
         call evaluate_virgin_branch(properties, closest_separation + retraction, response)
      end if
   end function evaluate_unloading_law

   !> The virgin branch: the law without memory, and its work as what is recoverable and what is
   !> not.
   pure subroutine evaluate_virgin_branch(properties, separation, response)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(normal_response), intent(out) :: response
      type(normal_response) :: unloading
      real(wp) :: dissipation

      response = evaluate_normal_law(properties, separation)
      call evaluate_yielded(properties, separation, 0.0_wp, unloading, dissipation)
      response%energy = unloading%energy
      response%plastic_dissipation = dissipation
      response%validity = ior(response%validity, memory_flags(properties, separation))
   end subroutine evaluate_virgin_branch

   !> The unloading branch without the plastic dissipation, a constant on it.
   pure subroutine evaluate_unloading_branch(properties, closest_separation, retraction, response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Its `plastic_dissipation` is zero
      type(normal_response), intent(out) :: response
      real(wp) :: u, edge, y, moments(0:2)

      u = min(retraction, largest_retraction*properties%w1)
      call evaluate_yielded(properties, closest_separation, u, response)
      associate (p => properties, r => response)
         edge = contact_edge(p, u)/p%sigma
         y = closest_separation/p%sigma + edge
         moments = tail_moments(y)
         r%contact_density = p%eta*moments(0)*decay_of(p, closest_separation, &
            relative_exponent(closest_separation/p%sigma, edge, max(y, 0.0_wp)))**2
         r%validity = ior(p%validity, memory_flags(p, closest_separation))
         if (r%area_fraction > 1.0_wp) r%validity = ior(r%validity, area_above_nominal)
         if (r%pressure > p%hardness) r%validity = ior(r%validity, pressure_above_hardness)
      end associate
   end subroutine evaluate_unloading_branch

   !> Stiffness at the closest separation for parting from it, MPa/mm.
   pure elemental real(wp) function unloading_stiffness(properties, closest_separation) &
         result(stiffness)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      type(normal_response) :: response

      call evaluate_yielded(properties, closest_separation, 0.0_wp, response)
      stiffness = response%stiffness
   end function unloading_stiffness

   !> Plastic dissipation per nominal area from first touch up to the closest separation, N/mm:
   !> virgin work less what is recoverable, summed as a difference summit by summit. It never falls
   !> as the face comes closer.
   pure elemental real(wp) function plastic_dissipation(properties, closest_separation) &
         result(dissipation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      type(normal_response) :: response

      call evaluate_yielded(properties, closest_separation, 0.0_wp, response, dissipation)
   end function plastic_dissipation

   !> Pressure, stiffness, area, energy and shares at a retraction, and the plastic dissipation at a
   !> retraction of zero.
   pure subroutine evaluate_yielded(properties, closest_separation, retraction, response, dissipation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction
      type(normal_response), intent(out) :: response
      real(wp), intent(out), optional :: dissipation
      type(piece_type) :: pieces(3), virgin
      real(wp) :: shift, decay, of_elastoplastic

      pieces(1) = elastic_unloading_piece(properties, closest_separation, retraction)
      pieces(3) = plastic_unloading_piece(properties, closest_separation, retraction)
      if (.not. present(dissipation)) then
         call elastoplastic_unloading_piece(properties, closest_separation, retraction, pieces(2))
      else
         call elastoplastic_unloading_piece(properties, closest_separation, retraction, pieces(2), &
            of_elastoplastic)
         virgin = plastic_piece(properties, closest_separation)
         dissipation = properties%eta*properties%n1*properties%w1*( &
            of_elastoplastic*decay_of(properties, closest_separation, pieces(2)%exponent)**2 &
            + (virgin%energy*decay_of(properties, closest_separation, virgin%exponent)**2 &
            - pieces(3)%energy*decay_of(properties, closest_separation, pieces(3)%exponent)**2))
      end if

      shift = minval(pieces%exponent, mask=pieces%pressure > 0.0_wp)
      pieces%exponent = max(pieces%exponent - shift, 0.0_wp)
      call sum_pieces(properties, pieces, response)
      decay = decay_of(properties, closest_separation, shift)
      associate (r => response)
         r%pressure = r%pressure*decay*decay
         r%stiffness = r%stiffness*decay*decay
         r%area_fraction = r%area_fraction*decay*decay
         r%energy = r%energy*decay*decay
      end associate
   end subroutine evaluate_yielded

   !> Root of exp(-exponent - max(h, 0)^2/2).
   pure real(wp) function decay_of(properties, separation, exponent)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, exponent

      decay_of = exp(-0.5_wp*(exponent + 0.5_wp*max(separation/properties%sigma, 0.0_wp)**2))
   end function decay_of

   !> Flags of the deformations at the closest separation, which the face remembers.
   pure integer function memory_flags(properties, closest_separation) result(flags)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation
      real(wp) :: moments(0:2)

      flags = 0
      associate (p => properties)
         if (closest_separation > vanishing_separation*p%sigma) return
         moments = tail_moments(closest_separation/p%sigma)
         if (p%sigma*moments(1) > 0.5_wp*p%radius*moments(0)) flags = closure_above_half_radius
         if (p%sigma*moments(1) > largest_mean_ratio*p%w1*moments(0)) &
            flags = ior(flags, memory_beyond_data)
      end associate
   end function memory_flags

end module asperity_law_unloading_law
