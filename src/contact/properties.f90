!> Properties of one pair of faces: the normal law, friction and the datum of the overclosure.
module asperity_contact_properties
   use asperity_base_checks, only: check_positive, check_range, largest_positive, &
      smallest_positive
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_check_friction, only: check_friction, is_plain
   use asperity_contact_friction_settings, only: friction_settings, largest_friction, &
      stick_critical_slip
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: compiled_law
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties, &
      unloading_elastic
   use asperity_law_plausibility, only: check_plausible_length, length_max
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_unloading_law
   use asperity_paper_pairs, only: pair_preset
   implicit none
   private
   public :: contact_properties, new_contact_properties, complete_contact_properties, &
      compile_normal_law, without_summits

   !> What happens to the elastic slip when the pressure changes
   enum, bind(c)
      !> The elastic slip stays: shear stress follows the pressure, as in ABAQUS' own friction
      enumerator :: rule_abaqus = 1
      !> Pressure rising keeps the shear stress, falling keeps the elastic slip: creates no energy
      enumerator :: rule_dissipative = 2
   end enum
   public :: rule_abaqus, rule_dissipative

   !> How the slip of an increment is integrated
   enum, bind(c)
      !> Exactly, on a straight path: two half increments equal one
      enumerator :: slip_exact = 1
      !> Backward Euler (radial return), as in ABAQUS' own friction
      enumerator :: slip_backward_euler = 2
   end enum
   public :: slip_exact, slip_backward_euler

   !> Largest |d0|, mm, that is let pass: far beyond any use
   real(wp), parameter :: largest_separation = 1.0e20_wp

   !> A point opens below p_open = this times 2 pi eta R H sigma
   real(wp), parameter :: open_pressure_factor = 1.0e-9_wp
   !> ... and closes above p_open times this
   real(wp), parameter, public :: close_pressure_ratio = 2.0_wp
   !> Separation at zero overclosure when none is given, in sigma
   real(wp), parameter, public :: default_initial_separation = 4.0_wp

   !> Everything a contact point needs. Build it with `new_contact_properties`; read only after.
   type :: contact_properties
      !> Properties of the normal law
      type(normal_properties) :: normal = normal_properties()
      !> Coulomb friction coefficient mu
      real(wp) :: friction_coefficient = 0.0_wp
      !> Critical elastic slip gcrit, mm: the largest |elastic slip|
      real(wp) :: critical_slip = 1.0_wp
      !> Separation at zero overclosure d0, mm: separation = d0 - overclosure
      real(wp) :: initial_separation = 0.0_wp
      !> `rule_abaqus` or `rule_dissipative`
      integer :: friction_rule = rule_abaqus
      !> `slip_exact` or `slip_backward_euler`
      integer :: slip_integration = slip_exact
      !> What friction is beyond these
      type(friction_settings) :: friction = friction_settings()
      !> Whether it is nothing beyond them
      logical :: friction_is_plain = .true.
      !> A closed point opens below this pressure, MPa; an open one closes above twice it
      real(wp) :: p_open = 0.0_wp
      !> The compiled normal law, where it was asked for; the law is evaluated directly otherwise
      type(compiled_law), allocatable :: compiled
      !> The same with elastic unloading
      type(compiled_unloading_law), allocatable :: compiled_unloading
   end type contact_properties

   !> From checked properties of the normal law, or from a pair of the paper.
   interface new_contact_properties
      module procedure :: from_normal
      module procedure :: from_pair
   end interface new_contact_properties

contains

   !> Check friction and datum, and derive the opening pressure.
   !> `error` is set when mu is not between 0 and 1000, gcrit not above zero, |d0| above 1e20, an
   !> option unknown, or gcrit or |d0| a length that no face has.
   pure subroutine from_normal(properties, normal, friction_coefficient, critical_slip, error, &
         initial_separation, friction_rule, slip_integration, compiled, accept_unphysical, friction)
      !> Result
      type(contact_properties), intent(out) :: properties
      !> Checked properties of the normal law
      type(normal_properties), intent(in) :: normal
      !> Coulomb friction coefficient
      real(wp), intent(in) :: friction_coefficient
      !> Critical elastic slip, mm
      real(wp), intent(in) :: critical_slip
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> Separation at zero overclosure, mm; 4 sigma when absent; zero and negative are allowed
      real(wp), intent(in), optional :: initial_separation
      !> `rule_abaqus` (default) or `rule_dissipative`
      integer, intent(in), optional :: friction_rule
      !> `slip_exact` (default) or `slip_backward_euler`
      integer, intent(in), optional :: slip_integration
      !> Compile the normal law, for very many updates; false when absent
      logical, intent(in), optional :: compiled
      !> Let lengths that no face has pass; results are then flagged
      logical, intent(in), optional :: accept_unphysical
      !> Friction beyond one coefficient and one critical slip
      type(friction_settings), intent(in), optional :: friction
      real(wp) :: separation

      separation = 0.0_wp
      if (present(initial_separation)) separation = initial_separation
      ! what is no number must not be compared: that may trap
      if (.not. all_finite([friction_coefficient, critical_slip, separation])) then
         call refuse(error, friction_coefficient, critical_slip, separation)
         return
      end if
      properties%normal = normal
      call complete_contact_properties(properties, friction_coefficient, critical_slip, error, &
         initial_separation, friction_rule, slip_integration, compiled, accept_unphysical, friction)
   end subroutine from_normal

   !> The same where `properties%normal` is in its place already, for many calls: without a copy.
   pure subroutine complete_contact_properties(properties, friction_coefficient, critical_slip, &
         error, initial_separation, friction_rule, slip_integration, compiled, &
         accept_unphysical, friction)
      !> With checked properties of the normal law; all the rest is set
      type(contact_properties), intent(inout) :: properties
      !> As above, and finite
      real(wp), intent(in) :: friction_coefficient, critical_slip
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in), optional :: initial_separation
      integer, intent(in), optional :: friction_rule, slip_integration
      logical, intent(in), optional :: compiled, accept_unphysical
      type(friction_settings), intent(in), optional :: friction
      logical :: allowed, accepted

      if (allocated(properties%compiled)) deallocate (properties%compiled)
      if (allocated(properties%compiled_unloading)) deallocate (properties%compiled_unloading)
      properties%friction_coefficient = friction_coefficient
      properties%critical_slip = critical_slip
      properties%initial_separation = default_initial_separation*properties%normal%sigma
      if (present(initial_separation)) properties%initial_separation = initial_separation
      properties%friction_rule = rule_abaqus
      if (present(friction_rule)) properties%friction_rule = friction_rule
      properties%slip_integration = slip_exact
      if (present(slip_integration)) properties%slip_integration = slip_integration
      ! nothing is set for plain friction, which is asked for most often
      if (.not. properties%friction_is_plain) properties%friction = friction_settings()
      properties%friction_is_plain = .true.
      associate (p => properties%normal)
         properties%p_open = open_pressure_factor*2.0_wp*pi*p%eta*p%radius*p%hardness*p%sigma
      end associate

      allowed = friction_coefficient >= 0.0_wp .and. friction_coefficient <= largest_friction &
         .and. critical_slip >= smallest_positive .and. critical_slip <= largest_positive &
         .and. abs(properties%initial_separation) <= largest_separation
      if (.not. allowed) then
         call refuse(error, friction_coefficient, critical_slip, properties%initial_separation)
         return
      end if
      accepted = .false.
      if (present(accept_unphysical)) accepted = accept_unphysical
      call check_plausible_length('critical_slip', critical_slip, length_max, accepted, &
         properties%normal%validity, error)
      if (.not. allocated(error)) call check_plausible_length('initial_separation', &
         properties%initial_separation, max(length_max, &
         properties%normal%vanishing_separation), accepted, properties%normal%validity, error)
      if (allocated(error)) return
      if (properties%friction_rule /= rule_abaqus &
            .and. properties%friction_rule /= rule_dissipative) then
         call fatal_error(error, 'friction_rule = '//to_text(properties%friction_rule)// &
            ' is unknown: 1 is abaqus, 2 is dissipative', subject='friction_rule')
      else if (properties%slip_integration /= slip_exact &
            .and. properties%slip_integration /= slip_backward_euler) then
         call fatal_error(error, 'slip_integration = '//to_text(properties%slip_integration)// &
            ' is unknown: 1 is exact, 2 is backward_euler', subject='slip_integration')
      end if
      if (.not. allocated(error) .and. present(friction)) then
         call check_friction(friction, friction_coefficient, properties%normal, error)
         if (allocated(error)) return
         properties%friction = friction
         properties%friction_is_plain = is_plain(friction)
      end if
      if (allocated(error) .or. .not. present(compiled)) return
      if (compiled) call compile_normal_law(properties, error)
   end subroutine complete_contact_properties

   !> Name the first number that is not allowed.
   pure subroutine refuse(error, friction_coefficient, critical_slip, initial_separation)
      type(error_type), allocatable, intent(inout) :: error
      real(wp), intent(in) :: friction_coefficient, critical_slip, initial_separation

      call check_range(error, 'friction_coefficient', friction_coefficient, 0.0_wp, &
         largest_friction, '')
      if (.not. allocated(error)) call check_positive(error, 'critical_slip', critical_slip, 'mm')
      if (.not. allocated(error)) call check_range(error, 'initial_separation', &
         initial_separation, -largest_separation, largest_separation, ' mm')
   end subroutine refuse

   !> The same for hard contact, which has no summits: gcrit in their place.
   pure function without_summits(properties) result(hard)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      type(contact_properties) :: hard

      hard = properties
      hard%friction%stick = stick_critical_slip
      hard%friction_is_plain = is_plain(hard%friction)
   end function without_summits

   !> Compile the normal law, unless it is. `error` is set when the properties were never built.
   pure subroutine compile_normal_law(properties, error)
      !> The properties
      type(contact_properties), intent(inout) :: properties
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      if (properties%normal%unloading == unloading_elastic) then
         if (allocated(properties%compiled_unloading)) return
         allocate (properties%compiled_unloading)
         call new_compiled_unloading_law(properties%compiled_unloading, properties%normal, error)
      else
         if (allocated(properties%compiled)) return
         allocate (properties%compiled)
         call new_compiled_law(properties%compiled, properties%normal, error)
      end if
   end subroutine compile_normal_law

   !> The same of a pair of the paper, with its friction.
   pure subroutine from_pair(properties, pair, error, initial_separation, friction_rule, &
         slip_integration, compiled, accept_unphysical, unloading, friction)
      !> Result
      type(contact_properties), intent(out) :: properties
      !> The pair, such as `find_pair` finds
      type(pair_preset), intent(in) :: pair
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> As above
      real(wp), intent(in), optional :: initial_separation
      integer, intent(in), optional :: friction_rule, slip_integration
      logical, intent(in), optional :: compiled, accept_unphysical
      !> `unloading_reversible` (default) or `unloading_elastic`
      integer, intent(in), optional :: unloading
      !> Friction beyond one coefficient and one critical slip
      type(friction_settings), intent(in), optional :: friction
      type(normal_properties) :: normal

      call new_normal_properties(normal, pair, error, accept_unphysical, unloading)
      if (.not. allocated(error)) call from_normal(properties, normal, &
         pair%friction_coefficient, pair%critical_slip, error, initial_separation, &
         friction_rule, slip_integration, compiled, accept_unphysical, friction)
   end subroutine from_pair

end module asperity_contact_properties
