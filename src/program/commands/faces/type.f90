!> The properties of the faces, as commands take them: those of a pair and of a surface of the
!> paper, unless they are given.
module asperity_program_commands_faces_type
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_properties, only: contact_properties, default_initial_separation, &
      new_contact_properties
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties, &
      unloading_elastic, unloading_reversible
   use asperity_paper_pairs, only: find_pair, find_surface, pair_preset, surface_preset
   use asperity_program_commands_faces_heights, only: heights_type
   use asperity_program_commands_faces_properties, only: critical_slip, eta, face_properties, &
      face_property, friction_coefficient, hardness, modulus, n_properties, of_surface, &
      pair_values, radius, sigma, yield_factor
   use asperity_program_input_key, only: given_as_option, option_name
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: faces_type

   character(len=*), parameter, public :: default_pair = 'transverse-tangential'

   !> Properties of the faces.
   type :: faces_type
      !> Names of the pair and of the surface, empty for none
      character(len=:), allocatable :: pair, surface
      !> The properties, in N, mm, MPa, and those of the presets; none where there is none
      real(wp) :: values(n_properties) = none, usual(n_properties) = none
      !> Separation at zero overclosure, mm
      real(wp) :: initial_separation = none
      !> Whether summits remember how flat they were pressed
      logical :: has_memory = .false.
      !> Plastic ratio and heights of the summits
      type(heights_type) :: heights
      !> Options of friction
      type(contact_properties) :: options
      !> And what friction is beyond one coefficient and one critical slip
      type(friction_settings) :: friction
      !> Let properties pass that no face has
      logical :: accept_unphysical = .false.
      !> Places of the keys of the properties, zero for none, and of the presets
      integer :: keys(n_properties) = 0
      integer :: pair_key = 0, surface_key = 0
      !> Whether the separation at zero overclosure is given
      logical :: has_separation = .false.
   contains
      procedure :: declare, declare_values, declare_separation, declare_unloading, declare_rules, &
         declare_accept
      procedure :: usual_separation, normal, contact, words
   end type faces_type

contains

   !> Declare the properties. Explicit values go before a surface, and that before a pair, each of
   !> the options before all of the case file.
   pure subroutine declare(self, keys, has_friction)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether friction acts
      logical, intent(in) :: has_friction
      type(error_type), allocatable :: error
      logical :: is_key(n_properties)

      is_key = .true.
      is_key([friction_coefficient, critical_slip]) = has_friction
      self%usual = none
      self%pair = ''
      call declare_presets(self, keys)
      call self%declare_values(keys, is_key)
      call keys%forget_case(self%pair_key, [self%surface_key, pack(self%keys, is_key)])
      call declare_presets(self, keys)
      call keys%forget_case(self%surface_key, self%keys(of_surface))
      call take_surface(self, error)
      call self%declare_values(keys, is_key)
      if (self%pair == '' .and. any(is_none(self%values) .and. is_key)) then
         self%pair = default_pair
         call declare_presets(self, keys)
      end if
      if (.not. allocated(error)) call take_pair(self, keys, error)
      if (allocated(error)) then
         call keys%refuse(error%message, error%subject)
         return
      end if
      call self%declare_values(keys, is_key)
      call check_used(keys, self%surface_key, self%keys)
      call check_used(keys, self%pair_key, self%keys)
   end subroutine declare

   !> Declare pair and surface.
   pure subroutine declare_presets(self, keys)
      class(faces_type), intent(inout) :: self
      type(key_list), intent(inout) :: keys

      keys%of_faces = .true.
      call keys%text('pair', self%pair, &
         'pair of faces of the paper; '//default_pair//' unless all is given')
      self%pair_key = keys%last
      self%surface = ''
      call keys%text('surface', self%surface, &
         'surface of Table 2: its eta, radius and sigma in place of the pair''s')
      self%surface_key = keys%last
   end subroutine declare_presets

   !> Declare the properties themselves, whose defaults are those of the presets.
   pure subroutine declare_values(self, keys, is_key)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Properties that are keys
      logical, intent(in) :: is_key(n_properties)
      type(face_property) :: property
      integer :: i

      keys%of_faces = .true.
      self%values = self%usual
      do i = 1, n_properties
         if (.not. is_key(i)) cycle
         property = face_properties(i)
         call keys%real(trim(property%name), self%values(i), trim(property%unit), &
            trim(property%help))
         self%keys(i) = keys%last
         if (self%surface /= '' .and. any(of_surface == i)) then
            call keys%given_by(self%surface_key)
         else if (self%pair /= '') then
            call keys%given_by(self%pair_key)
         end if
      end do
   end subroutine declare_values

   !> Take what the surface gives.
   pure subroutine take_surface(self, error)
      type(faces_type), intent(inout) :: self
      type(error_type), allocatable, intent(out) :: error
      type(surface_preset) :: surface

      self%heights = heights_type()
      if (self%surface == '') return
      call find_surface(self%surface, surface, error)
      if (allocated(error)) return
      self%usual(of_surface) = [surface%eta, surface%radius, surface%sigma]
      self%heights%usual_kurtosis = surface%kurtosis
      self%heights%surface = 'surface '//self%surface
   end subroutine take_surface

   !> Take what the pair gives, and the surface does not.
   pure subroutine take_pair(self, keys, error)
      type(faces_type), intent(inout) :: self
      type(key_list), intent(inout) :: keys
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: pair

      if (allocated(keys%note)) deallocate (keys%note)
      if (self%pair == '') return
      call find_pair(self%pair, pair, error)
      if (allocated(error)) return
      keys%note = 'Pair: '//trim(pair%note)
      self%usual = merge(pair_values(pair), self%usual, is_none(self%usual))
   end subroutine take_pair

   !> Refuse a pair or surface given as an option of which nothing is used.
   pure subroutine check_used(keys, preset, places)
      type(key_list), intent(inout) :: keys
      integer, intent(in) :: preset, places(:)
      integer :: i

      if (keys%rows(preset)%given /= given_as_option) return
      do i = 1, size(places)
         if (places(i) == 0) cycle
         if (keys%rows(places(i))%leader == preset) return
      end do
      call keys%refuse(option_name(keys%rows(preset)%name)// &
         ': has no effect, every property that it gives is given explicitly', '')
   end subroutine check_used

   !> Declare the separation at zero overclosure.
   pure subroutine declare_separation(self, keys)
      !> The faces
      class(faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      self%initial_separation = self%usual_separation()
      call keys%real('initial_separation', self%initial_separation, 'mm', &
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

   !> What the faces are, for a title: pair, surface, and whether a value differs from theirs.
   pure function words(self) result(text)
      !> The faces
      class(faces_type), intent(in) :: self
      character(len=:), allocatable :: text

      text = self%pair
      if (text == '') then
         text = 'given properties'
         return
      end if
      if (self%surface /= '') text = text//', '//self%surface
      if (any(abs(self%values(:sigma) - self%usual(:sigma)) > 0.0_wp)) text = text//', changed'
   end function words

end module asperity_program_commands_faces_type
