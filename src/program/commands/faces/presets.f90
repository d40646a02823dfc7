!> The properties of two faces from presets: those of two faces by themselves, of a surface and of
!> a pair of the paper, unless they are given.
module asperity_program_commands_faces_presets
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_faces_aged_pair, only: age_pair
   use asperity_paper_pairs, only: find_pair, find_surface, pair_note, pair_preset, surface_preset
   use asperity_program_commands_faces_as_given, only: as_given_words
   use asperity_program_commands_faces_heights, only: heights_type
   use asperity_program_commands_faces_properties, only: critical_slip, eta, face_properties, &
      face_property, friction_coefficient, hardness, modulus, n_properties, of_faces, of_surface, &
      pair_values, sigma
   use asperity_program_commands_faces_two_faces, only: two_faces_type
   use asperity_program_commands_wood_ageing_keys, only: ageing_of_faces => of_faces, &
      ageing_of_friction => of_friction, declare_ageing
   use asperity_program_commands_wood_keys, only: declare_wood
   use asperity_program_input_key, only: given_as_option, option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_wood_ageing, only: ageing_factors
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_transverse
   implicit none
   private
   public :: preset_faces

   character(len=*), parameter, public :: default_pair = 'transverse-tangential'
   !> In the place of the key of a preset: two faces
   integer, parameter :: of_two_faces = -1

   !> Properties of the faces.
   type :: preset_faces
      !> What is before the names of the keys
      character(len=5) :: prefix = ''
      !> The pair unless all is given
      character(len=24) :: usual_pair = default_pair
      !> Names of the pair and of the surface, empty for none
      character(len=:), allocatable :: pair, surface
      !> Two faces, in place of the surface and of most of the pair
      type(two_faces_type) :: two
      !> The properties, in N, mm, MPa, and those of the presets; none where there is none
      real(wp) :: values(n_properties) = none, usual(n_properties) = none
      !> Plastic ratio and heights of the summits
      type(heights_type) :: heights
      !> Places of the keys of the properties, zero for none, and of the presets
      integer :: keys(n_properties) = 0
      integer :: pair_key = 0, surface_key = 0
      !> Old over new wood, and the new one
      type(ageing_factors) :: ageing
      type(wood_properties), private :: wood
      !> Properties that age has changed
      logical, private :: is_aged(n_properties) = .false.
      !> The key that gives each property unless it is given, or `of_two_faces`
      integer, private :: leaders(n_properties) = 0
   contains
      procedure :: declare, declare_values, is_on_end, words
   end type preset_faces

contains

   !> Declare the properties. Explicit values go before two faces, these before a surface, and that
   !> before a pair, each of the options before all of the case file.
   pure subroutine declare(self, keys, has_friction, prefix, usual_pair)
      !> The faces
      class(preset_faces), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether friction acts
      logical, intent(in) :: has_friction
      !> What is before the names of the keys; nothing when absent
      character(len=*), intent(in), optional :: prefix
      !> The pair unless all is given; `default_pair` when absent
      character(len=*), intent(in), optional :: usual_pair
      type(error_type), allocatable :: error
      type(pair_preset) :: pair
      logical :: is_key(n_properties)
      integer, allocatable :: places(:)
      integer :: i

      self%prefix = ''
      if (present(prefix)) self%prefix = prefix
      self%usual_pair = default_pair
      if (present(usual_pair)) self%usual_pair = usual_pair
      is_key = .true.
      is_key([friction_coefficient, critical_slip]) = has_friction
      self%usual = none
      self%leaders = 0
      self%heights = heights_type()
      self%is_aged = .false.
      ! the wood stands below the faces in listings; no preset changes it
      if (keys%find('wood') > 0) call declare_wood(self%wood, keys)
      self%pair = ''
      call declare_presets(self, keys)
      call self%declare_values(keys, is_key)
      call declare_ageing(self%ageing, keys, pack(ageing_of_faces, has_friction .or. &
         ageing_of_faces /= ageing_of_friction), spread(.true., 1, size(ageing_of_faces)))
      call keys%forget_case(self%pair_key, [self%surface_key, self%two%all_keys(), &
         pack(self%keys, is_key)])
      call declare_presets(self, keys)
      call keys%forget_case(self%surface_key, [self%two%all_keys(), self%keys(of_surface)])
      allocate (places, source=self%two%all_keys())
      do i = 1, size(places)
         call keys%forget_case(places(i), self%keys(of_faces))
      end do
      call declare_presets(self, keys)
      if (self%two%is_given) then
         call take(self, pair_values(self%two%pair), of_two_faces, of_faces)
      else
         call take_surface(self, error)
      end if
      call self%declare_values(keys, is_key)
      if (self%pair == '' .and. any(is_none(self%values) .and. is_key) &
            .and. .not. self%two%is_given) then
         self%pair = trim(self%usual_pair)
         call declare_presets(self, keys)
      end if
      if (.not. allocated(error)) call take_pair(self, error)
      if (allocated(error)) then
         call keys%refuse(trim(self%prefix)//error%message, trim(self%prefix)//error%subject)
         return
      end if
      if (self%two%is_given) then
         pair = self%two%pair
         pair%friction_coefficient = pair%friction_coefficient*self%ageing%friction
         call take(self, pair_values(pair), of_two_faces, new=pair_values(self%two%pair))
      end if
      call self%declare_values(keys, is_key)
      call check_used(keys, self%surface_key, self%keys)
      call check_used(keys, self%pair_key, self%keys)
      if (self%prefix == '') call tell(self, keys)
   end subroutine declare

   !> Declare pair, surface and two faces.
   pure subroutine declare_presets(self, keys)
      class(preset_faces), intent(inout) :: self
      type(key_list), intent(inout) :: keys

      keys%of_faces = .true.
      call keys%text(trim(self%prefix)//'pair', self%pair, &
         'pair of faces of the paper; '//trim(self%usual_pair)//' unless all is given')
      self%pair_key = keys%last
      self%surface = ''
      call keys%text(trim(self%prefix)//'surface', self%surface, &
         'surface of Table 2: its eta, radius and sigma in place of the pair''s')
      self%surface_key = keys%last
      call self%two%declare(keys, trim(self%prefix), self%wood, self%ageing)
   end subroutine declare_presets

   !> Declare the properties themselves, whose defaults are those of the presets.
   pure subroutine declare_values(self, keys, is_key)
      !> The faces
      class(preset_faces), intent(inout) :: self
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
         call keys%real(trim(self%prefix)//trim(property%name), self%values(i), &
            trim(property%unit), trim(property%help))
         self%keys(i) = keys%last
         if (self%leaders(i) == of_two_faces .and. any(of_faces == i)) then
            call keys%follows(self%two%faces(1)%name_key, &
               trim(self%prefix)//'face_1 and '//trim(self%prefix)//'face_2')
         else if (self%leaders(i) == of_two_faces) then
            call keys%said_by('as the pairs of the paper')
         else if (self%leaders(i) > 0) then
            call keys%given_by(self%leaders(i))
         end if
         if (self%is_aged(i)) call keys%also('aged')
      end do
   end subroutine declare_values

   !> Take what a preset gives of some properties, and none before it; `new` is without its age.
   pure subroutine take(self, values, leader, places, new)
      type(preset_faces), intent(inout) :: self
      real(wp), intent(in) :: values(n_properties)
      integer, intent(in) :: leader
      integer, intent(in), optional :: places(:)
      real(wp), intent(in), optional :: new(n_properties)
      logical :: taken(n_properties)
      integer :: i

      taken = is_none(self%usual)
      if (present(places)) taken = taken .and. [(any(places == i), i=1, n_properties)]
      self%usual = merge(values, self%usual, taken)
      self%leaders = merge(leader, self%leaders, taken)
      if (present(new)) self%is_aged = self%is_aged .or. (taken .and. abs(values - new) > 0.0_wp)
   end subroutine take

   !> Take what the surface gives.
   pure subroutine take_surface(self, error)
      type(preset_faces), intent(inout) :: self
      type(error_type), allocatable, intent(out) :: error
      type(surface_preset) :: surface

      if (self%surface == '') return
      call find_surface(self%surface, surface, error)
      if (allocated(error)) return
      self%usual(of_surface) = [surface%eta, surface%radius, surface%sigma]
      self%leaders(of_surface) = self%surface_key
      self%heights%usual_kurtosis = surface%kurtosis
      self%heights%surface = 'surface '//self%surface
   end subroutine take_surface

   !> Take what the pair gives, and the surface does not.
   pure subroutine take_pair(self, error)
      type(preset_faces), intent(inout) :: self
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: pair, old

      if (self%pair == '') return
      call find_pair(self%pair, pair, error)
      if (allocated(error)) return
      old = pair
      call age_pair(old, self%wood, self%ageing, error)
      if (.not. allocated(error)) &
         call take(self, pair_values(old), self%pair_key, new=pair_values(pair))
   end subroutine take_pair

   !> Say below the input what is to be known of the presets whose values are used.
   pure subroutine tell(self, keys)
      type(preset_faces), intent(in) :: self
      type(key_list), intent(inout) :: keys
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      character(len=:), allocatable :: note, as_given
      logical :: used(n_properties)
      integer :: i

      if (allocated(keys%note)) deallocate (keys%note)
      do i = 1, n_properties
         used(i) = .false.
         if (self%keys(i) > 0) used(i) = .not. keys%given(self%keys(i))
      end do
      note = ''
      if (self%two%is_given) then
         note = self%two%note(used(modulus), any(used(of_surface)))
      else if (self%pair /= '' .and. any(used .and. self%leaders == self%pair_key)) then
         call find_pair(self%pair, pair, error)
         used = used .and. self%leaders == self%pair_key
         note = 'Pair: '//trim(pair_note(pair, used(eta), used(sigma), used(hardness), &
            used(modulus)))
      end if
      as_given = as_given_words(self%ageing, self%keys, keys)
      if (note /= '' .and. as_given /= '') note = note//'. '
      if (note//as_given /= '') keys%note = note//as_given
   end subroutine tell

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

   !> Whether the grain of the first face is at right angles to it, as far as that is known.
   pure logical function is_on_end(self)
      !> The faces
      class(preset_faces), intent(in) :: self

      is_on_end = self%pair /= 'tangential-tangential'
      if (self%two%faces(1)%section > 0) is_on_end = &
         self%two%faces(1)%section == section_transverse
   end function is_on_end

   !> What the faces are, for a title: pair, surface, and whether a value differs from theirs.
   pure function words(self) result(text)
      !> The faces
      class(preset_faces), intent(in) :: self
      character(len=:), allocatable :: text

      text = self%pair
      if (self%two%is_given) then
         text = self%two%words()
      else if (text == '') then
         text = 'given properties'
         return
      end if
      if (self%surface /= '') text = text//', '//self%surface
      if (any(abs(self%values(:sigma) - self%usual(:sigma)) > 0.0_wp)) text = text//', changed'
   end function words

end module asperity_program_commands_faces_presets
