!> The faces as commands take them: their properties, what their summits do, friction.
module asperity_program_commands_faces_type
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_properties, only: contact_properties, default_initial_separation, &
      new_contact_properties
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties, &
      unloading_elastic, unloading_reversible
   use asperity_program_commands_faces_presets, only: preset_faces
   use asperity_program_commands_faces_properties, only: critical_slip, eta, &
      friction_coefficient, hardness, modulus, radius, sigma, yield_factor
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: faces_type

   !> Properties of the faces.
   type, extends(preset_faces) :: faces_type
      !> Separation at zero overclosure, mm
      real(wp) :: initial_separation = none
      !> Whether summits remember how flat they were pressed
      logical :: has_memory = .false.
      !> Options of friction
      type(contact_properties) :: options
      !> And what friction is beyond one coefficient and one critical slip
      type(friction_settings) :: friction
      !> Let properties pass that no face has
      logical :: accept_unphysical = .false.
      !> Whether the separation at zero overclosure is given
      logical :: has_separation = .false.
   contains
      procedure :: declare_separation, declare_unloading, declare_rules, declare_accept
      procedure :: usual_separation, normal, contact
   end type faces_type

contains

   !> Declare the separation at zero overclosure.
   pure subroutine declare_separation(self, keys)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      self%initial_separation = self%usual_separation()
      call keys%real(trim(self%prefix)//'initial_separation', self%initial_separation, 'mm', &
         'separation d0 at zero overclosure; 4 sigma unless given')
      self%has_separation = keys%given()
      if (self%keys(sigma) > 0) call keys%follows(self%keys(sigma), '4 sigma')
   end subroutine declare_separation

   !> The separation at zero overclosure unless another is given, mm.
   pure real(wp) function usual_separation(self)
      !> The faces
      class(faces_type), intent(in) :: self

      usual_separation = none
      if (.not. is_none(self%values(sigma))) &
         usual_separation = default_initial_separation*self%values(sigma)
   end function usual_separation

   !> Declare what the summits do when the faces part.
   pure subroutine declare_unloading(self, keys)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%choice('unloading', self%has_memory, 'reversible elastic', &
         'how summits unload: back as they loaded (the paper), or elastically, staying flat')
   end subroutine declare_unloading

   !> Declare the rules of friction.
   pure subroutine declare_rules(self, keys)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%choice('friction_rule', self%options%friction_rule, 'abaqus dissipative', &
         'what elastic slip does when the pressure changes')
      call keys%choice('slip_integration', self%options%slip_integration, &
         'exact backward_euler', 'how the slip of an increment is integrated')
   end subroutine declare_rules

   !> Declare whether what no face has is accepted, the last of the properties.
   pure subroutine declare_accept(self, keys)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%switch('accept_unphysical', self%accept_unphysical, &
         'let properties that no face or solid has pass; results are flagged')
      keys%of_faces = .false.
   end subroutine declare_accept

   !> The checked properties of the normal law.
   pure subroutine normal(self, law, error)
      !> The faces
      class(faces_type), intent(in) :: self
      !> The properties
      type(normal_properties), intent(out) :: law
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      associate (v => self%values)
         call new_normal_properties(law, v(eta), v(modulus), v(radius), v(hardness), &
            v(yield_factor), v(sigma), error, self%accept_unphysical, &
            merge(unloading_elastic, unloading_reversible, self%has_memory), &
            self%heights%plastic_ratio, self%heights%distribution(), self%heights%skewness, &
            self%heights%kurtosis)
      end associate
   end subroutine normal

   !> All checked properties.
   pure subroutine contact(self, checked, error, compiled)
      !> The faces
      class(faces_type), intent(in) :: self
      !> The properties
      type(contact_properties), intent(out) :: checked
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      !> Whether the law is to be compiled
      logical, intent(in), optional :: compiled
      type(normal_properties) :: law
      real(wp) :: friction(2)

      call self%normal(law, error)
      if (allocated(error)) return
      friction = [self%options%friction_coefficient, self%options%critical_slip]
      if (self%keys(critical_slip) > 0) friction = self%values([friction_coefficient, &
         critical_slip])
      call new_contact_properties(checked, law, friction(1), friction(2), error, &
         self%initial_separation, self%options%friction_rule, self%options%slip_integration, &
         compiled, self%accept_unphysical, self%friction)
   end subroutine contact

end module asperity_program_commands_faces_type
