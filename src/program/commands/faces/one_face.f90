!> The keys of one of two faces: its roughness by a name of Table 2 or by a case file, what its
!> section is of the wood, and each number by itself.
module asperity_program_commands_faces_one_face
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_faces_face, only: face
   use asperity_paper_pairs, only: find_surface, surface_preset, surfaces
   use asperity_program_input_key_list, only: key_list
   use asperity_wood_ageing, only: aged_wood, ageing_factors
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_elasticity, section_names
   implicit none
   private
   public :: one_face_type

   !> Places of the numbers: of the summits, and of the wood below them
   integer, parameter :: n_numbers = 6
   integer, parameter, public :: of_summits(3) = [1, 2, 3], of_wood(3) = [4, 5, 6]
   !> That of the hardness
   integer, parameter, public :: face_hardness = 6
   character(len=13), parameter, public :: number_names(n_numbers) = [character(len=13) :: &
      'sigma', 'radius', 'eta', 'young_modulus', 'poisson_ratio', 'hardness']
   character(len=6), parameter :: number_units(n_numbers) = [character(len=6) :: &
      'mm', 'mm', '1/mm^2', 'MPa', '', 'MPa']
   character(len=*), parameter :: helps(n_numbers) = [character(len=60) :: &
      'standard deviation of summit heights of face ', 'summit radius of face ', &
      'asperity density of face ', 'Young''s modulus at right angles to face ', &
      'Poisson''s ratio of strain in the face, of face ', 'hardness of face ']

   !> A face.
   type :: one_face_type
      !> `face_1` or `side_face_2`, and what is before and after the names of its keys
      character(len=:), allocatable :: own, prefix, number
      !> Name of Table 2 or path of a case file, empty for none
      character(len=:), allocatable :: name
      !> Place of its section, zero for none
      integer :: section = 0
      !> Its numbers, `none` where there is none
      real(wp) :: values(n_numbers) = none
      !> Places of the keys
      integer :: name_key = 0, section_key = 0, keys(n_numbers) = 0
   contains
      procedure :: declare, is_given, has_summits, as_face, all_keys
   end type one_face_type

contains

   !> Declare the face. A number goes before the section and the name, and each of the options
   !> before all of the case file.
   pure subroutine declare(self, keys, prefix, number, wood, ageing)
      !> The face
      class(one_face_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> What is before the names of the keys, and its number
      character(len=*), intent(in) :: prefix, number
      !> The wood of its section when it is new, and old over new
      type(wood_properties), intent(in) :: wood
      type(ageing_factors), intent(in) :: ageing

      self%prefix = prefix
      self%number = number
      self%own = prefix//'face_'//number
      call declare_all(self, keys, wood, ageing)
      call keys%forget_case(self%name_key, self%keys(of_summits))
      if (any(surfaces%name == self%name)) &
         call keys%forget_case(self%name_key, [self%section_key, self%keys(of_wood)])
      call keys%forget_case(self%section_key, self%keys(of_wood))
      call declare_all(self, keys, wood, ageing)
   end subroutine declare

   !> Declare name, section and numbers.
   pure subroutine declare_all(self, keys, wood, ageing)
      class(one_face_type), intent(inout) :: self
      type(key_list), intent(inout) :: keys
      type(wood_properties), intent(in) :: wood
      type(ageing_factors), intent(in) :: ageing
      real(wp) :: new(n_numbers)
      character(len=10) :: section
      integer :: i

      self%name = ''
      call keys%text(self%own, self%name, 'face '//self%number// &
         ': a surface of Table 2, or a case file that asperity surface wrote')
      call keys%reads('face', is_argument=.false.)
      self%name_key = keys%last
      section = ''
      self%values = none
      new = none
      if (self%name /= '') call take_name(self, keys, section)
      call keys%choice(self%prefix//'section_'//self%number, section, section_list(), &
         'section of the wood that face '//self%number//' is; as its name says unless given')
      self%section_key = keys%last
      if (section /= '') call keys%follows(self%name_key, self%own//' '//self%name)
      self%section = findloc(section_names == section, .true., 1)
      if (self%section > 0) then
         self%values(of_wood) = of_section(aged_wood(wood, ageing), self%section)
         new(of_wood) = of_section(wood, self%section)
      end if
      do i = 1, n_numbers
         call keys%real(self%prefix//trim(number_names(i))//'_'//self%number, self%values(i), &
            trim(number_units(i)), trim(helps(i))//' '//self%number)
         self%keys(i) = keys%last
         if (is_none(self%values(i))) cycle
         if (any(of_wood == i)) then
            call keys%follows(self%section_key, trim(section)//' section')
            if (abs(self%values(i) - new(i)) > 0.0_wp) call keys%also('aged')
         else
            call keys%follows(self%name_key, self%own//' '//self%name)
         end if
      end do
   end subroutine declare_all

   !> What a section of a wood is, in the order of the numbers.
   pure function of_section(wood, section) result(numbers)
      type(wood_properties), intent(in) :: wood
      integer, intent(in) :: section
      real(wp) :: numbers(size(of_wood))

      call section_elasticity(wood, section, numbers(1), numbers(2))
      numbers(3) = wood%hardnesses(section)
   end function of_section

   !> Take what a name gives: summits and, if it is one of the paper, the section.
   pure subroutine take_name(self, keys, section)
      class(one_face_type), intent(inout) :: self
      type(key_list), intent(inout) :: keys
      character(len=10), intent(inout) :: section
      type(surface_preset) :: surface
      type(error_type), allocatable :: error

      if (allocated(keys%rows(self%name_key)%values)) then
         self%values(of_summits) = keys%rows(self%name_key)%values
         return
      end if
      call find_surface(self%name, surface, error)
      if (allocated(error)) then
         call keys%refuse(self%own//error%message(index(error%message, ' ='):)// &
            '; or give the path of a case file, X.nml', self%own)
         return
      end if
      self%values(of_summits) = [surface%sigma, surface%radius, surface%eta]
      section = section_of(self%name)
   end subroutine take_name

   !> The section that a name of Table 2 says; the paper calls the transverse one cross.
   pure function section_of(name) result(section)
      character(len=*), intent(in) :: name
      character(len=10) :: section

      section = name(index(name, '-', back=.true.) + 1:)
      if (section == 'cross') section = 'transverse'
   end function section_of

   !> Names of the sections, separated by blanks.
   pure function section_list() result(list)
      character(len=:), allocatable :: list
      integer :: i

      list = trim(section_names(1))
      do i = 2, size(section_names)
         list = list//' '//trim(section_names(i))
      end do
   end function section_list

   !> Whether anything of it is given.
   pure logical function is_given(self, keys)
      !> The face, declared
      class(one_face_type), intent(in) :: self
      !> The keys
      type(key_list), intent(in) :: keys
      integer :: i

      is_given = .false.
      do i = 1, n_numbers
         is_given = is_given .or. keys%given(self%keys(i))
      end do
      is_given = is_given .or. keys%given(self%name_key) .or. keys%given(self%section_key)
   end function is_given

   !> Whether its summits are known.
   pure logical function has_summits(self)
      !> The face
      class(one_face_type), intent(in) :: self

      has_summits = .not. any(is_none(self%values(of_summits)))
   end function has_summits

   !> Its numbers for the library; zero where there is none.
   pure type(face) function as_face(self)
      !> The face
      class(one_face_type), intent(in) :: self

      associate (v => merge(0.0_wp, self%values, is_none(self%values)))
         as_face = face(v(1), v(2), v(3), v(4), v(5), v(6))
      end associate
   end function as_face

   !> Places of all its keys.
   pure function all_keys(self) result(places)
      !> The face, declared
      class(one_face_type), intent(in) :: self
      integer :: places(n_numbers + 2)

      places = [self%name_key, self%section_key, self%keys]
   end function all_keys

end module asperity_program_commands_faces_one_face
