!> The keys of two faces: each of them, and how they make one pair.
module asperity_program_commands_faces_two_faces
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_faces_nayak, only: nayak_type
   use asperity_faces_two_faces, only: hardness_softer, pair_from_faces, roughness_face_1, &
      roughness_face_2, roughness_moments, sum_of_summits
   use asperity_law_plausibility, only: alpha_min
   use asperity_paper_pairs, only: pair_preset
   use asperity_program_commands_faces_one_face, only: face_hardness, number_names, of_summits, &
      of_wood, one_face_type
   use asperity_program_input_key_list, only: key_list
   use asperity_wood_ageing, only: ageing_factors
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_names
   implicit none
   private
   public :: two_faces_type

   character(len=1), parameter :: numbers(2) = ['1', '2']

   !> Two faces.
   type :: two_faces_type
      type(one_face_type) :: faces(2)
      !> `hardness_softer` and the like, `roughness_moments` and the like
      integer :: hardness_rule = hardness_softer, roughness_rule = roughness_moments
      !> Whether they are given
      logical :: is_given = .false.
      !> The pair that they make
      type(pair_preset) :: pair
      !> Places of the keys of the rules
      integer :: rule_keys(2) = 0
   contains
      procedure :: declare, all_keys, name_keys, sections, is_rough, note, words
   end type two_faces_type

contains

   !> Declare the faces and, if they are given, make the pair of them.
   pure subroutine declare(self, keys, prefix, wood, ageing)
      !> The faces
      class(two_faces_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> What is before the names of the keys
      character(len=*), intent(in) :: prefix
      !> The wood of their sections when it is new, and old over new
      type(wood_properties), intent(in) :: wood
      type(ageing_factors), intent(in) :: ageing
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, 2
         call self%faces(i)%declare(keys, prefix, numbers(i), wood, ageing)
      end do
      self%is_given = self%faces(1)%is_given(keys) .or. self%faces(2)%is_given(keys)
      self%hardness_rule = hardness_softer
      call keys%choice(prefix//'hardness_rule', self%hardness_rule, 'softer harder', &
         'whose hardness two faces take: that of the softer (Eq. 26) or the harder (Table 4)')
      call keys%needs(self%is_given, 'needs two faces, '//prefix//'face_1 and '//prefix//'face_2')
      self%rule_keys(1) = keys%last
      self%roughness_rule = roughness_moments
      call keys%choice(prefix//'roughness_rule', self%roughness_rule, 'moments face_1 face_2', &
         'whose summits two faces take: of their sum, or of one, as the paper the rougher')
      call keys%needs(self%is_given, 'needs two faces, '//prefix//'face_1 and '//prefix//'face_2')
      self%rule_keys(2) = keys%last
      if (.not. self%is_given) return
      do i = 1, 2
         keys%rows(self%faces(i)%keys(of_summits))%unused = .not. self%is_rough(i)
         call check_whole(self%faces(i), keys, self%is_rough(i))
      end do
      if (allocated(keys%error)) return
      call pair_from_faces(self%faces(1)%as_face(), self%faces(2)%as_face(), self%pair, error, &
         self%hardness_rule, self%roughness_rule)
      if (allocated(error)) call keys%refuse(prefix//error%message, prefix//error%subject)
   end subroutine declare

   !> Refuse a face of which something is missing.
   pure subroutine check_whole(one, keys, is_rough)
      type(one_face_type), intent(in) :: one
      type(key_list), intent(inout) :: keys
      logical, intent(in) :: is_rough
      character(len=:), allocatable :: whole
      integer :: i

      if (is_rough .and. all(is_none(one%values(of_summits)))) then
         call keys%refuse(one%own//' is not given: two faces need both; give '//one%own// &
            ', or sigma, radius and eta of it', '')
      else if (all(is_none(one%values(of_wood)))) then
         call keys%refuse(one%prefix//'section_'//one%number//' is not given: only the names '// &
            'of Table 2 say which section they are; give it, or young_modulus, poisson_ratio '// &
            'and hardness of the face', '')
      end if
      do i = 1, size(one%values)
         if (.not. is_none(one%values(i)) .or. (any(of_summits == i) .and. .not. is_rough)) cycle
         whole = one%prefix//trim(number_names(i))//'_'//one%number
         if (i == face_hardness .and. one%section > 0) then
            call keys%refuse(whole//' is not given: no hardness of the '// &
               trim(section_names(one%section))//' section of larch is known; give '//whole// &
               wood_key(keys, 'hardness_'//trim(section_names(one%section))), '')
         else
            call keys%refuse(whole//' is not given: a face needs all of its numbers', '')
         end if
      end do
   end subroutine check_whole

   !> Another key to give, where the command has it.
   pure function wood_key(keys, name) result(text)
      type(key_list), intent(in) :: keys
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: text

      text = ''
      if (keys%find(name) > 0) text = ' or '//name
   end function wood_key

   !> Whether the summits of a face count.
   pure logical function is_rough(self, face)
      !> The faces
      class(two_faces_type), intent(in) :: self
      !> 1 or 2
      integer, intent(in) :: face

      is_rough = self%roughness_rule == roughness_moments .or. &
         self%roughness_rule == merge(roughness_face_1, roughness_face_2, face == 1)
   end function is_rough

   !> Which sections of the wood, in L, R and T, give constants.
   pure function sections(self)
      !> The faces
      class(two_faces_type), intent(in) :: self
      logical :: sections(3)
      integer :: i

      sections = [(self%is_given .and. any(self%faces%section == i), i=1, 3)]
   end function sections

   !> Places of all keys, declared.
   pure function all_keys(self) result(places)
      !> The faces
      class(two_faces_type), intent(in) :: self
      integer, allocatable :: places(:)

      places = [self%faces(1)%all_keys(), self%faces(2)%all_keys(), self%rule_keys]
   end function all_keys

   !> Places of the keys that name the faces.
   pure function name_keys(self) result(places)
      !> The faces
      class(two_faces_type), intent(in) :: self
      integer :: places(2)

      places = self%faces%name_key
   end function name_keys

   !> How the pair is made of them, for the listing; empty where nothing of that is used.
   pure function note(self, modulus, summits) result(text)
      !> The faces, given
      class(two_faces_type), intent(in) :: self
      !> Whether E* and the summits that they make are used
      logical, intent(in) :: modulus, summits
      character(len=:), allocatable :: text
      type(nayak_type) :: both

      text = ''
      if (modulus) text = 'E* by Eq. 4'
      ! a face that lacks a number is refused later
      if (summits .and. self%roughness_rule == roughness_moments &
         .and. self%faces(1)%has_summits() .and. self%faces(2)%has_summits()) then
         both = sum_of_summits(self%faces(1)%as_face(), self%faces(2)%as_face())
         if (text /= '') text = text//'; '
         text = text//'eta, radius, sigma of the sum of both, as moments add; its alpha '// &
            to_text(both%alpha, 4)//' (isotropic Gaussian surfaces have '// &
            to_text(alpha_min, 2)//' or more)'
      end if
      if (text /= '') text = 'Faces: '//text
   end function note

   !> What the faces are, for a title.
   pure function words(self) result(text)
      !> The faces, given
      class(two_faces_type), intent(in) :: self
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, 2
         if (i == 2) text = text//' on '
         if (.not. self%is_rough(i)) then
            text = text//'smooth face'
         else if (self%faces(i)%name == '') then
            text = text//'given face'
         else
            text = text//self%faces(i)%name
         end if
      end do
   end function words

end module asperity_program_commands_faces_two_faces
