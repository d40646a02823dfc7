!> One spherical summit against a rigid plane: elastic, elasto-plastic, fully plastic
!> (Eqs 1-3, 10-22). Force is continuous; its derivative jumps at w1 and w2.
module asperity_law_single_asperity
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_validity, only: closure_above_half_radius, valid
   implicit none
   private
   public :: asperity_response, evaluate_asperity

   !> Stages of one summit
   enum, bind(c)
      enumerator :: stage_open = 0, stage_elastic, stage_elastoplastic, stage_plastic
   end enum
   public :: stage_open, stage_elastic, stage_elastoplastic, stage_plastic

   !> Answer of one summit at one deformation.
   type :: asperity_response
      !> `stage_open`, `stage_elastic`, `stage_elastoplastic` or `stage_plastic`
      integer :: stage = stage_open
      !> Force, N (Eqs 2, 20, 13), and its derivative by w, N/mm
      real(wp) :: force = 0.0_wp, force_slope = 0.0_wp
      !> Real contact area, mm^2 (Eqs 1, 21, 12), and its derivative by w, mm
      real(wp) :: area = 0.0_wp, area_slope = 0.0_wp
      !> Mean pressure force/area, MPa (Eqs 3, 22, 10), and its derivative by w, MPa/mm
      real(wp) :: mean_pressure = 0.0_wp, mean_pressure_slope = 0.0_wp
      !> Work of the force from first touch, N mm; its derivative by w is the force
      real(wp) :: energy = 0.0_wp
      !> `valid`, or flags (see `asperity_law_validity`)
      integer :: validity = valid
   end type asperity_response

contains

   !> Evaluate one summit. Derivatives at w1 and w2 are those of the stage that begins there;
   !> at w = 0 the slope of the mean pressure is infinite and returned as zero, as for an open
   !> summit.
   pure elemental function evaluate_asperity(properties, deformation) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Normal deformation w of the summit, mm; negative or zero is open
      real(wp), intent(in) :: deformation
      type(asperity_response) :: response
      real(wp) :: ratio, area_1, pressure_1, power

      response%validity = properties%validity
      if (.not. deformation > 0.0_wp) return
      associate (p => properties, w => deformation, r => response)
         ratio = w/p%w1
         area_1 = pi*p%radius*p%w1
         pressure_1 = p%yield_factor*p%hardness
         if (w < p%w1) then
            r%stage = stage_elastic
            r%force = p%n1*ratio*sqrt(ratio)
            r%force_slope = 1.5_wp*r%force/w
            r%area = pi*p%radius*w
            r%area_slope = pi*p%radius
            r%mean_pressure = pressure_1*sqrt(ratio)
            r%mean_pressure_slope = 0.5_wp*r%mean_pressure/w
            r%energy = 0.4_wp*r%force*w
         else if (w < p%w2) then
            r%stage = stage_elastoplastic
            power = ratio**p%b3
            r%force = p%n1*power
            r%force_slope = p%b3*r%force/w
            r%area = area_1*ratio**p%b2
            r%area_slope = p%b2*r%area/w
            r%mean_pressure = pressure_1*ratio**p%b1
            r%mean_pressure_slope = p%b1*r%mean_pressure/w
            r%energy = p%n1*p%w1*(0.4_wp + (power*ratio - 1.0_wp)/(p%b3 + 1.0_wp))
         else
            r%stage = stage_plastic
            r%force = 2.0_wp*pi*p%radius*p%hardness*w
            r%force_slope = 2.0_wp*pi*p%radius*p%hardness
            r%area = 2.0_wp*pi*p%radius*w
            r%area_slope = 2.0_wp*pi*p%radius
            r%mean_pressure = p%hardness
            r%energy = p%energy_2 + pi*p%radius*p%hardness*(w - p%w2)*(w + p%w2)
         end if
         if (w > 0.5_wp*p%radius) r%validity = ior(r%validity, closure_above_half_radius)
      end associate
   end function evaluate_asperity

end module asperity_law_single_asperity
