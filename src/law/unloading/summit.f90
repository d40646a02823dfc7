!> One summit that remembers: after yield it unloads and reloads as an elastic (Hertz) contact of
!> another radius, with force and area continuous at its largest deformation (residual sphere:
!> Etsion, Kligerman, Kadin 2005), for the three stages of the paper without any fitted constant.
!>
!> With N and A the force and area at the largest deformation w and e = 3 N/(4 E* sqrt(A/pi)) what
!> it recovers elastically, a retraction u leaves the force N (1 - u/e)^(3/2), the area A (1 - u/e),
!> the stiffness 3/2 N/e (1 - u/e)^(1/2) and the stored energy 2/5 N e (1 - u/e)^(5/2).
module asperity_law_unloading_summit
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity, stage_open
   implicit none
   private
   public :: evaluate_unloading_asperity, elastic_recovery, recovery_exponent, find_contact_edge

   real(wp), parameter :: lowest_log = -50.0_wp

contains

   !> What a summit recovers elastically, mm: the retraction from its largest deformation at which
   !> it loses contact. Its largest deformation less this is its residual.
   pure elemental real(wp) function elastic_recovery(properties, deformation) result(recovery)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Largest deformation, mm
      real(wp), intent(in) :: deformation

      associate (p => properties, w => max(deformation, 0.0_wp))
         if (w < p%w1) then
            recovery = w
         else if (w < p%w2) then
            recovery = p%w1*(w/p%w1)**recovery_exponent(p)
         else
            recovery = sqrt(2.0_wp*p%w1*w)/p%yield_factor
         end if
      end associate
   end function elastic_recovery

   !> Exponent of w/w1 in the elastic recovery of an elasto-plastic summit, b3 - b2/2.
   pure elemental real(wp) function recovery_exponent(properties)
      !> Checked properties
      type(normal_properties), intent(in) :: properties

      recovery_exponent = properties%b3 - 0.5_wp*properties%b2
   end function recovery_exponent

   !> Find the summit that just loses contact: the inverse of `elastic_recovery`.
   pure elemental subroutine find_contact_edge(properties, retraction, deformation, log_ratio)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> How far summits have parted since their largest deformation, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Its largest deformation, mm
      real(wp), intent(out) :: deformation
      !> ln(w/w1) of the deformation w at which the formula of elasto-plastic summits gives a
      !> recovery of the retraction, also beyond these summits; -50 stands for anything below
      real(wp), intent(out) :: log_ratio

      associate (p => properties, u => retraction)
         log_ratio = lowest_log
         if (u > 0.0_wp) log_ratio = max(log(u/p%w1)/recovery_exponent(p), lowest_log)
         if (u < p%w1) then
            deformation = u
         else
            deformation = p%w1*exp(log_ratio)
            if (.not. deformation < p%w2) deformation = 0.5_wp*(p%yield_factor*u)**2/p%w1
         end if
      end associate
   end subroutine find_contact_edge

   !> Evaluate one summit that was pressed to a largest deformation and has parted again. The stage
   !> is that of the largest deformation, `stage_open` once it has lost contact; slopes are by the
   !> deformation at fixed memory; the energy is what is recoverable.
   pure elemental function evaluate_unloading_asperity(properties, largest_deformation, &
         retraction) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Largest deformation of the summit so far, mm
      real(wp), intent(in) :: largest_deformation
      !> How far it has parted since, mm; zero or more
      real(wp), intent(in) :: retraction
      type(asperity_response) :: response
      real(wp) :: recovery, rest

      response = evaluate_asperity(properties, largest_deformation)
      if (response%stage == stage_open) return
      recovery = elastic_recovery(properties, largest_deformation)
      rest = max(1.0_wp - max(retraction, 0.0_wp)/recovery, 0.0_wp)
      associate (r => response)
         if (.not. rest > 0.0_wp) then
            r%stage = stage_open
            r%force = 0.0_wp
            r%area = 0.0_wp
         end if
         r%force_slope = 1.5_wp*r%force/recovery*sqrt(rest)
         r%energy = 0.4_wp*r%force*recovery*rest*rest*sqrt(rest)
         r%force = r%force*rest*sqrt(rest)
         r%area_slope = r%area/recovery
         r%area = r%area*rest
         r%mean_pressure = 0.0_wp
         r%mean_pressure_slope = 0.0_wp
         if (r%area > 0.0_wp) then
            r%mean_pressure = r%force/r%area
            r%mean_pressure_slope = 0.5_wp*r%mean_pressure/(recovery*rest)
         end if
      end associate
   end function evaluate_unloading_asperity

end module asperity_law_unloading_summit
