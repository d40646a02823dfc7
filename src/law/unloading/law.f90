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
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_law, only: apply_decay, evaluate_pressure, evaluate_scaled_law, &
      is_closed_too_far, normal_response, sum_pieces
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: relative_exponent
   use asperity_law_quadrature_pieces_by_fixed_rule, only: fixed_elastoplastic_piece, &
      fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastoplastic_piece, no_summits, &
      piece_type, plastic_piece
   use asperity_law_unloading_pieces, only: elastic_unloading_piece, elastoplastic_unloading_piece
   use asperity_law_unloading_plastic_pieces, only: plastic_unloading_piece, &
      recoverable_plastic_energy
   use asperity_law_unloading_summit, only: find_contact_edge
   use asperity_law_validity, only: closure_above_half_radius, memory_beyond_data
   implicit none
   private
   public :: evaluate_unloading_law, evaluate_unloading_branch, evaluate_virgin_pressure, &
      unloading_stiffness, plastic_dissipation, is_flattened_too_far

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
      type(piece_type) :: pieces(3)
      real(wp) :: decay

      call evaluate_scaled_law(properties, separation, response, pieces=pieces)
      associate (p => properties, r => response)
         decay = decay_at(p, separation)
         call split_work(p, separation, pieces, r%energy, r%plastic_dissipation)
         r%plastic_dissipation = r%plastic_dissipation*decay
         r%validity = ior(r%validity, memory_flags(p, separation))
         call apply_decay(p, decay, r)
      end associate
   end subroutine evaluate_virgin_branch

   !> What a contact point needs of the virgin branch, in less time: no shares, no contact density.
   pure subroutine evaluate_virgin_pressure(properties, separation, pressure, stiffness, energy, &
         dissipation, validity)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation, the closest so far, mm
      real(wp), intent(in) :: separation
      !> Pressure, MPa; stiffness of closing, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Recoverable energy and plastic dissipation since first touch, per nominal area, N/mm
      real(wp), intent(out) :: energy, dissipation
      !> `valid`, or flags
      integer, intent(out) :: validity
      type(piece_type) :: pieces(3)
      real(wp) :: decay

      call evaluate_pressure(properties, separation, pressure, stiffness, energy, validity, pieces)
      decay = decay_at(properties, separation)
      call split_work(properties, separation, pieces, energy, dissipation)
      energy = energy*decay
      dissipation = dissipation*decay
      validity = ior(validity, memory_flags(properties, separation))
   end subroutine evaluate_virgin_pressure

   !> Recoverable energy and plastic dissipation, scaled, of the pieces of the law without memory.
   pure subroutine split_work(properties, separation, pieces, energy, plastic_dissipation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type), intent(in) :: pieces(3)
      real(wp), intent(out) :: energy, plastic_dissipation
      real(wp) :: recoverable, factor(3)
      integer :: i

      recoverable = recoverable_plastic_energy(properties, separation)
      do i = 1, 3
         factor(i) = properties%eta*properties%n1*properties%w1
         if (pieces(i)%exponent > 0.0_wp) factor(i) = factor(i)*exp(-pieces(i)%exponent)
      end do
      energy = factor(1)*pieces(1)%energy + factor(2)*pieces(2)%recoverable + factor(3)*recoverable
      plastic_dissipation = factor(2)*pieces(2)%dissipation &
         + factor(3)*(pieces(3)%energy - recoverable)
   end subroutine split_work

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
      type(piece_type) :: pieces(3)
      real(wp) :: u, edge, log_edge, shift, h, y, moments(0:2)

      u = min(retraction, largest_retraction*properties%w1)
      call find_contact_edge(properties, u, edge, log_edge)
      pieces(1) = elastic_unloading_piece(properties, closest_separation, u)
      pieces(2) = elastoplastic_unloading_piece(properties, closest_separation, u, edge, log_edge)
      pieces(3) = plastic_unloading_piece(properties, closest_separation, u)
      ! the largest piece keeps its digits where all underflow
      shift = minval(pieces%exponent, mask=pieces%pressure > 0.0_wp)
      pieces%exponent = max(pieces%exponent - shift, 0.0_wp)
      call sum_pieces(properties, pieces, response)
      associate (p => properties, r => response)
         h = closest_separation/p%sigma
         y = h + edge/p%sigma
         call find_tail_moments(y, moments)
         r%contact_density = p%eta*moments(0) &
            *exp(min(shift - relative_exponent(h, edge/p%sigma, max(y, 0.0_wp)), 0.0_wp))
         r%validity = ior(p%validity, memory_flags(p, closest_separation))
         call apply_decay(p, exp(-shift)*decay_at(p, closest_separation), r)
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

      call evaluate_unloading_branch(properties, closest_separation, 0.0_wp, response)
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
      type(piece_type) :: pieces(3)
      real(wp) :: h, energy

      h = closest_separation/properties%sigma
      pieces(1) = no_summits
      if (fixed_pieces_serve(properties, h)) then
         pieces(2) = fixed_elastoplastic_piece(properties, h)
      else
         pieces(2) = elastoplastic_piece(properties, closest_separation, .true.)
      end if
      pieces(3) = plastic_piece(properties, closest_separation)
      call split_work(properties, closest_separation, pieces, energy, dissipation)
      dissipation = dissipation*decay_at(properties, closest_separation)
   end function plastic_dissipation

   !> The factor that scaled values lack.
   pure real(wp) function decay_at(properties, separation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation

      decay_at = exp(-0.5_wp*max(separation/properties%sigma, 0.0_wp)**2)
   end function decay_at

   !> Flags of the deformations at the closest separation, which the face remembers.
   pure integer function memory_flags(properties, closest_separation) result(flags)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation
      real(wp) :: moments(0:2)

      flags = 0
      associate (p => properties)
         if (closest_separation > p%vanishing_separation) return
         ! above the mean plane summits in contact are closed by 0.8 sigma or less in the mean
         if (closest_separation > 0.0_wp .and. 0.8_wp*p%sigma < min(0.5_wp*p%radius, &
            largest_mean_ratio*p%w1)) return
         call find_tail_moments(closest_separation/p%sigma, moments)
         if (is_closed_too_far(p, closest_separation, moments)) flags = closure_above_half_radius
         if (is_flattened_too_far(p, moments)) flags = ior(flags, memory_beyond_data)
      end associate
   end function memory_flags

   !> Whether the summits in contact are deformed further in the mean than unloading is known for.
   pure logical function is_flattened_too_far(properties, moments)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> `find_tail_moments` of the closest separation over sigma
      real(wp), intent(in) :: moments(0:2)

      is_flattened_too_far = properties%sigma*moments(1) &
         > largest_mean_ratio*properties%w1*moments(0)
   end function is_flattened_too_far

end module asperity_law_unloading_law
