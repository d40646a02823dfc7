!> What friction can be beyond one coefficient and one critical slip: rest and motion, grain,
!> pressure, a shear limit, summits that stick each for itself. Zeros everywhere are plain Coulomb
!> friction with one elastic slip.
module asperity_contact_friction_settings
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: friction_settings

   !> Where a point slips to
   enum, bind(c)
      !> Normal to the ellipse of shear stresses: the most dissipation
      enumerator :: slip_direction_associated = 0
      !> Along the shear stress
      enumerator :: slip_direction_of_stress
   end enum
   public :: slip_direction_associated, slip_direction_of_stress

   !> What sticks before it slides
   enum, bind(c)
      !> The point, up to one critical slip gcrit
      enumerator :: stick_critical_slip = 0
      !> Its summits, each as Mindlin's theory has it
      enumerator :: stick_summits
   end enum
   public :: stick_critical_slip, stick_summits

   !> Largest coefficient and factor on it that are let pass: far beyond any use
   real(wp), parameter, public :: largest_friction = 1.0e3_wp
   !> Most points of mu over pressure, and elements of `stick_summits`
   integer, parameter, public :: most_friction_points = 8, most_stick_elements = 16
   !> Elements unless given, and fewest
   integer, parameter, public :: default_stick_elements = 8, fewest_stick_elements = 4

   !> As a user gives it; checked by `new_contact_properties`.
   type :: friction_settings
      !> Coefficient at rest; zero stands for that in motion, `friction_coefficient`
      real(wp) :: static_friction_coefficient = 0.0_wp
      !> Slip over which the excess at rest falls to 1/e, mm; zero: not by slip
      real(wp) :: decay_slip = 0.0_wp
      !> Slip rate at which it is down to 1/e, mm/s; zero: not by rate
      real(wp) :: decay_slip_rate = 0.0_wp
      !> Coefficient in motion across the grain; zero stands for that along it,
      !> `friction_coefficient`
      real(wp) :: friction_coefficient_across = 0.0_wp
      !> Angle from the first slip direction to the grain, degrees, at the start
      real(wp) :: grain_angle = 0.0_wp
      !> `slip_direction_associated` or `slip_direction_of_stress`
      integer :: slip_direction = slip_direction_associated
      !> All coefficients times (p/reference_pressure)^pressure_exponent; above -1
      real(wp) :: pressure_exponent = 0.0_wp
      !> MPa; needed where the exponent is not zero
      real(wp) :: reference_pressure = 0.0_wp
      !> Pressures, MPa, rising, and factors on all coefficients there; between them straight,
      !> outside constant. The first `friction_points` of them count
      integer :: friction_points = 0
      real(wp) :: friction_pressures(most_friction_points) = 0.0_wp
      real(wp) :: friction_factors(most_friction_points) = 0.0_wp
      !> Largest shear stress, along the grain and at rest, MPa; zero for none
      real(wp) :: shear_limit = 0.0_wp
      !> `stick_critical_slip` or `stick_summits`
      integer :: stick = stick_critical_slip
      !> Number of elements of `stick_summits`, 4 to 16; zero stands for 8
      integer :: stick_elements = 0
      !> Equivalent shear modulus G* of the two faces, 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2, MPa; for
      !> `stick_summits`
      real(wp) :: shear_modulus = 0.0_wp
   end type friction_settings

end module asperity_contact_friction_settings
