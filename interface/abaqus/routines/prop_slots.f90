!> What stands where in PROPS of UINTER and VUINTER, and nothing else: every reader and writer of it
!> uses these names. Zero is the default from the eleventh slot on.
module asperity_abaqus_prop_slots
   use asperity_contact_friction_settings, only: most_friction_points, most_stick_elements
   implicit none
   private

   !> Slots of PROPS, N-mm-MPa
   enum, bind(c)
      !> mu, and gcrit in mm
      enumerator :: prop_friction_coefficient = 1, prop_critical_slip
      !> eta in 1/mm^2, E* in MPa
      enumerator :: prop_eta, prop_modulus
      !> 3.14 or better: kept in the paper's place as a guard against a shifted list, not used
      enumerator :: prop_pi
      !> R in mm, H in MPa, k
      enumerator :: prop_radius, prop_hardness, prop_yield_factor
      !> sigma in mm, which the paper's list lacks
      enumerator :: prop_sigma
      !> d0 in mm, taken literally; 4 sigma when the list ends before
      enumerator :: prop_initial_separation
      !> 0 default, 1 abaqus, 2 dissipative
      enumerator :: prop_friction_rule
      !> 0 default, 1 exact, 2 backward Euler
      enumerator :: prop_slip_integration
      !> 1 lets properties that no face or solid has pass
      enumerator :: prop_accept_unphysical
      !> 0 reversible, 1 elastic: summits remember how flat they were pressed
      enumerator :: prop_unloading
      !> As of `normal_properties`
      enumerator :: prop_plastic_ratio, prop_height_distribution, prop_skewness, prop_kurtosis
      !> As of `friction_settings`: rest and motion,
      enumerator :: prop_static_friction_coefficient, prop_decay_slip, prop_decay_slip_rate
      !> ... grain,
      enumerator :: prop_friction_coefficient_across, prop_grain_angle, prop_slip_direction
      !> ... pressure,
      enumerator :: prop_pressure_exponent, prop_reference_pressure, prop_shear_limit
      !> ... summits that stick each for itself,
      enumerator :: prop_stick, prop_stick_elements, prop_shear_modulus
      !> ... and how many pairs of pressure and factor follow
      enumerator :: prop_friction_points
   end enum
   public :: prop_friction_coefficient, prop_critical_slip, prop_eta, prop_modulus, prop_pi, &
      prop_radius, prop_hardness, prop_yield_factor, prop_sigma, prop_initial_separation, &
      prop_friction_rule, prop_slip_integration, prop_accept_unphysical, prop_unloading, &
      prop_plastic_ratio, prop_height_distribution, prop_skewness, prop_kurtosis, &
      prop_static_friction_coefficient, prop_decay_slip, prop_decay_slip_rate, &
      prop_friction_coefficient_across, prop_grain_angle, prop_slip_direction, &
      prop_pressure_exponent, prop_reference_pressure, prop_shear_limit, prop_stick, &
      prop_stick_elements, prop_shear_modulus, prop_friction_points
   !> Length of a list with all of them and no pairs, and of the longest one
   integer, parameter, public :: n_props = prop_friction_points, &
      most_props = n_props + 2*most_friction_points

   !> Slots that hold whole numbers, and the largest one there
   integer, parameter, public :: option_slots(9) = [prop_friction_rule, prop_slip_integration, &
      prop_accept_unphysical, prop_unloading, prop_height_distribution, prop_slip_direction, &
      prop_stick, prop_stick_elements, prop_friction_points]
   integer, parameter, public :: option_max(size(option_slots)) = &
      [2, 2, 1, 1, 1, 1, 1, most_stick_elements, most_friction_points]
   !> What they mean
   character(len=*), parameter, public :: option_texts(size(option_slots)) = [character(len=80) :: &
      'the friction rule is 1 for abaqus, 2 for dissipative, 0 for the default', &
      'the slip integration is 1 for exact, 2 for backward Euler, 0 for the default', &
      '1 accepts unphysical values, 0 does not', &
      'the unloading is 0 for reversible, 1 for elastic', &
      'the height distribution is 0 for gaussian, 1 for johnson', &
      'the slip direction is 0 for associated, 1 for that of the stress', &
      'what sticks is 0 for one critical slip, 1 for summits', &
      'there are up to 16 stick elements, 0 for the default', &
      'there are 0 to 8 friction points, a pressure and a factor each']

   !> What a list says, in the words of its slots
   character(len=*), parameter, public :: prop_names(n_props) = [character(len=32) :: &
      'mu', 'gcrit (mm)', 'eta (1/mm^2)', 'E* (MPa)', 'pi', 'R (mm)', 'H (MPa)', 'k', &
      'sigma (mm)', 'd0 (mm)', 'friction rule', 'slip integration', 'accept unphysical', &
      'unloading', 'plastic ratio', 'height distribution', 'skewness', 'kurtosis', &
      'static friction coefficient', 'decay slip (mm)', 'decay slip rate (mm/s)', &
      'friction coefficient across', 'grain angle (degrees)', 'slip direction', &
      'pressure exponent', 'reference pressure (MPa)', 'shear limit (MPa)', 'stick', &
      'stick elements', 'shear modulus (MPa)', 'friction points']

end module asperity_abaqus_prop_slots
