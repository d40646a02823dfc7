!> The law of a rough face that remembers how close it came: every summit unloads from its own
!> largest deformation (see `asperity_law_unloading_summit`). One number is remembered, the closest
!> separation d_m; summits higher than d_m have the largest deformation w = z - d_m. At
!> d = d_m + u the pressure is eta Int N_u(w) phi(d_m + w) dw over the summits that still touch,
!> e(w) > u, and alike for area, stiffness and stored energy.
!>
!> The virgin branch and the elastic summits are those of the law without memory.
module asperity_law_unloading_law
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: tail_moments
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use asperity_law_single_asperity, only: asperity_response
   use asperity_law_unloading_summit, only: elastic_recovery, evaluate_unloading_asperity, &
      recovery_exponent
   use asperity_law_validity, only: area_above_nominal, memory_beyond_data, pressure_above_hardness
   implicit none
   private
   public :: evaluate_unloading_law, unloading_stiffness, plastic_dissipation

   !> Mean deformation over w1 of the summits in contact up to which unloading was computed
   real(wp), parameter :: largest_mean_ratio = 170.0_wp

contains

   !> Evaluate the law with memory at the separation closest_separation + retraction. With a
   !> retraction of zero or less the face is as close as never before: pressure, stiffness and area
   !> are those of the law without memory. The energy is what is recoverable; it and the plastic
   !> dissipation add up to the work since first touch wherever the face was pressed without pause.
   pure elemental function evaluate_unloading_law(properties, closest_separation, retraction) &
         result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm
      real(wp), intent(in) :: retraction
      type(normal_response) :: response, virgin, unloaded
      real(wp) :: closest

      closest = closest_separation + min(retraction, 0.0_wp)
      virgin = evaluate_normal_law(properties, closest)
      unloaded = brute_force(properties, closest, max(retraction, 0.0_wp))
      if (retraction > 0.0_wp) then
         response = unloaded
         unloaded = brute_force(properties, closest, 0.0_wp)
      else
         response = virgin
         response%energy = unloaded%energy
      end if
      response%plastic_dissipation = max(virgin%energy - unloaded%energy, 0.0_wp)
      response%validity = properties%validity
      if (response%area_fraction > 1.0_wp) &
         response%validity = ior(response%validity, area_above_nominal)
      if (response%pressure > properties%hardness) &
         response%validity = ior(response%validity, pressure_above_hardness)
      if (mean_deformation(properties, closest) > largest_mean_ratio*properties%w1) &
         response%validity = ior(response%validity, memory_beyond_data)
   end function evaluate_unloading_law

   !> Stiffness at the closest separation for parting from it, MPa/mm.
   pure elemental real(wp) function unloading_stiffness(properties, closest_separation) &
         result(stiffness)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      type(normal_response) :: response

      response = brute_force(properties, closest_separation, 0.0_wp)
      stiffness = response%stiffness
   end function unloading_stiffness

   !> Plastic dissipation per nominal area since first touch, N/mm, when the face has been as close
   !> as this: the work less what is recoverable.
   pure elemental real(wp) function plastic_dissipation(properties, closest_separation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      type(normal_response) :: response

      response = evaluate_unloading_law(properties, closest_separation, 0.0_wp)
      plastic_dissipation = response%plastic_dissipation
   end function plastic_dissipation

   pure real(wp) function mean_deformation(properties, separation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      real(wp) :: moments(0:2)

      moments = tail_moments(separation/properties%sigma)
      mean_deformation = properties%sigma*moments(1)/moments(0)
   end function mean_deformation

   pure function brute_force(properties, closest, retraction) result(r)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest, retraction
      type(normal_response) :: r
      integer, parameter :: panels = 6
      type(asperity_response) :: one
      real(wp) :: w_c, from, to, first, last, v, w, weight, share(3), width
      integer :: piece, panel, i

      associate (p => properties, u => retraction)
         if (u < p%w1) then
            w_c = u
         else if (u < elastic_recovery(p, p%w2)) then
            w_c = p%w1*(u/p%w1)**(1.0_wp/recovery_exponent(p))
         else
            w_c = (p%yield_factor*u)**2/(2.0_wp*p%w1)
         end if
         r%contact_density = 0.5_wp*p%eta*erfc((closest + w_c)/(sqrt(2.0_wp)*p%sigma))
         share = 0.0_wp
         do piece = 1, 3
            from = max(w_c, merge(0.0_wp, merge(p%w1, p%w2, piece == 2), piece == 1))
            to = merge(p%w1, merge(p%w2, max(40.0_wp*p%sigma - closest, 2.0_wp*p%w2), piece == 2), &
               piece == 1)
            to = min(to, max(12.0_wp*p%sigma, w_c + 12.0_wp*p%sigma - min(closest, 0.0_wp)))
            if (.not. to > from) cycle
            ! w = w_c + v^2, even in v
            first = sqrt(from - w_c)
            last = sqrt(to - w_c)
            width = (last - first)/panels
            do panel = 1, panels
               do i = 1, n_points
                  v = first + width*(panel - 0.5_wp + 0.5_wp*nodes(i))
                  w = w_c + v*v
                  weight = width*weights(i)*v*p%eta/(sqrt(2.0_wp*pi)*p%sigma) &
                     *exp(-0.5_wp*((closest + w)/p%sigma)**2)
                  one = evaluate_unloading_asperity(p, w, u)
                  share(piece) = share(piece) + weight*one%force
                  r%stiffness = r%stiffness + weight*one%force_slope
                  r%area_fraction = r%area_fraction + weight*one%area
                  r%energy = r%energy + weight*one%energy
               end do
            end do
         end do
         r%pressure = sum(share)
         if (r%pressure > 0.0_wp) then
            share = share/r%pressure
            r%elastic_share = share(1)
            r%elastoplastic_share = share(2)
            r%plastic_share = share(3)
         end if
      end associate
   end function brute_force

end module asperity_law_unloading_law
