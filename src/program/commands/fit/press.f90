!> `asperity fit --kind press`: the law held against closure and pressure of a press record.
module asperity_program_commands_fit_press
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_press, only: n_press_numbers, press_problem, press_separation
   use asperity_fit_problem, only: fit_problem
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic, &
      unloading_reversible
   use asperity_law_validity, only: valid, validity_remark
   use asperity_program_commands_faces_properties, only: critical_slip, eta, &
      friction_coefficient, n_properties, sigma, yield_factor
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_fit_kind, only: fit_kind
   use asperity_program_commands_fit_press_numbers, only: compliance_name, least_yield_factor, &
      press_name, press_names, press_number, press_parameter, separation_name
   use asperity_program_commands_fit_record_input, only: fit_record, record_quantities
   use asperity_program_commands_surface_law, only: refusal
   use asperity_program_input_key, only: given_as_option
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_names, only: holds_displacement, holds_pressure
   use asperity_program_system_strings, only: add_line, string_type
   implicit none
   private
   public :: new_press_kind

   !> A record returns if it opens again by this share of the range; pulls if the least pressure is
   !> below minus this share of the largest
   real(wp), parameter :: least_return = 0.05_wp, largest_pull = 0.05_wp

   !> The model and the record.
   type, extends(fit_kind) :: press_kind
      private
      type(faces_type) :: faces
      real(wp) :: compliance = 0.0_wp
      type(fit_record) :: record
   contains
      procedure :: declare, missing, take_records, parameter_of, make_problem, remarks, &
         case_keys
   end type press_kind

contains

   !> The kind.
   subroutine new_press_kind(kind)
      !> The kind
      class(fit_kind), allocatable, intent(out) :: kind

      allocate (press_kind :: kind)
      kind%choices = [record_quantities([holds_displacement, holds_pressure], &
         [character(len=16) :: 'closure', 'pressure'], [character(len=16) :: 'mm', 'MPa'])]
   end subroutine new_press_kind

   !> The faces, and the machine.
   subroutine declare(self)
      !> The kind
      class(press_kind), intent(inout) :: self
      type(faces_type) :: faces

      self%faces = faces
      self%compliance = 0.0_wp
      associate (keys => self%keys)
         call self%faces%declare(keys, has_friction=.false.)
         call self%faces%declare_separation(keys)
         call self%faces%declare_unloading(keys)
         call self%faces%heights%declare(keys)
         keys%of_faces = .false.
         call keys%real(compliance_name, self%compliance, 'mm/MPa', &
            'closure of the machine, and of all but the faces, over the pressure')
      end associate
   end subroutine declare

   !> Numbers that are neither free nor given by themselves, by a pair, a surface or two faces.
   pure function missing(self, free) result(names)
      !> The kind, declared
      class(press_kind), intent(in) :: self
      !> Names of the free keys
      type(string_type), intent(in) :: free(:)
      !> Separated by blanks
      character(len=:), allocatable :: names
      integer :: i, j

      names = ''
      do i = eta, press_separation
         if (is_given(self, i) .or. any([(free(j)%text == press_name(i), j=1, size(free))])) cycle
         names = trim(adjustl(names//' '//press_name(i)))
      end do
   end function missing

   !> Whether the user gives a number, by itself or by what stands for several; a separation that
   !> follows sigma is not given.
   pure logical function is_given(self, which)
      type(press_kind), intent(in) :: self
      integer, intent(in) :: which
      integer :: place

      place = self%keys%find(press_name(which))
      is_given = self%keys%given(place)
      associate (key => self%keys%rows(place))
         if (which <= sigma .and. key%leader > 0) &
            is_given = is_given .or. self%keys%given(key%leader)
      end associate
   end function is_given

   !> All numbers of the model.
   pure function numbers_of(self) result(numbers)
      type(press_kind), intent(in) :: self
      real(wp) :: numbers(n_press_numbers)

      numbers = [self%faces%values(eta:sigma), self%faces%initial_separation, self%compliance]
   end function numbers_of

   !> Take the test, of which there is one. Where it returns, summits unload elastically unless
   !> something else is said.
   subroutine take_records(self, records, error)
      !> The kind, declared
      class(press_kind), intent(inout) :: self
      !> The tests
      type(fit_record), intent(inout) :: records(:)
      !> Set when this is no press record
      type(error_type), allocatable, intent(out) :: error
      integer :: peak, place

      if (size(records) /= 1) then
         call fatal_error(error, 'there are '//to_text(size(records))//' tests, of which '// &
            'press takes one: give one file, and choose its test by --where')
         return
      end if
      self%record = records(1)
      associate (x => self%record%x, y => self%record%y)
         peak = maxloc(x, 1)
         if (.not. maxval(x) > minval(x)) then
            call fatal_error(error, 'all closures are the same: this is no press record')
         else if (.not. maxval(y) > 0.0_wp) then
            call fatal_error(error, 'no pressure is above zero: turn the sign by '// &
               '--force-factor -1')
         else if (minval(y) < -largest_pull*maxval(y)) then
            call fatal_error(error, 'pressures go down to '//to_text(minval(y), 3)//' MPa, but'// &
               ' faces do not pull: this is no press record, or its zero is off (--force-zero)')
         else if (y(peak) < 0.5_wp*maxval(y)) then
            call fatal_error(error, 'the largest pressure is not near the largest closure: '// &
               'this is no press record, or closing is counted downwards '// &
               '(--displacement-factor -1)')
         end if
         if (allocated(error)) return
         place = self%keys%find('unloading')
         if (self%keys%given(place) .or. maxval(x) - minval(x(peak:)) &
            < least_return*(maxval(x) - minval(x))) return
         associate (key => self%keys%rows(place))
            key%given = given_as_option
            key%has_value = .true.
            key%text = 'elastic'
            key%source = 'the record returns'
         end associate
      end associate
      call self%declare()
   end subroutine take_records

   !> Unit, start and bounds of a number.
   subroutine parameter_of(self, name, parameter, error)
      !> The kind, with its record
      class(press_kind), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> The parameter
      type(fit_parameter), intent(out) :: parameter
      !> Set when it is no number of the model
      type(error_type), allocatable, intent(out) :: error
      integer :: which

      which = press_number(name)
      if (which == 0) then
         call fatal_error(error, '--free: '//name//' cannot be free: a press record may settle '// &
            press_names())
         return
      end if
      associate (numbers => numbers_of(self))
         parameter = press_parameter(which, self%record, numbers(which), is_given(self, which))
      end associate
      if (which == yield_factor .and. self%faces%has_memory) then
         ! less is refused with elastic unloading
         parameter%lower = least_yield_factor(self%faces%heights%plastic_ratio)
         if (.not. is_given(self, which)) parameter%start = sqrt(parameter%lower)
      end if
   end subroutine parameter_of

   !> The problem of some free numbers.
   subroutine make_problem(self, free, scale, problem, error)
      !> The kind, with its record
      class(press_kind), intent(inout) :: self
      !> Names of the free numbers
      type(string_type), intent(in) :: free(:)
      !> What differences of pressure are divided by, MPa
      real(wp), intent(in) :: scale(:)
      !> The problem
      class(fit_problem), allocatable, intent(out) :: problem
      !> Never set: the law is asked at every set of values
      type(error_type), allocatable, intent(out) :: error
      type(press_problem) :: press
      integer :: i

      press%closure = self%record%x
      press%pressure = self%record%y
      press%scale = scale
      press%numbers = numbers_of(self)
      allocate (press%free(size(free)))
      do i = 1, size(free)
         press%free(i) = press_number(free(i)%text)
      end do
      press%unloading = merge(unloading_elastic, unloading_reversible, self%faces%has_memory)
      press%plastic_ratio = self%faces%heights%plastic_ratio
      press%height_distribution = self%faces%heights%distribution()
      press%skewness = self%faces%heights%skewness
      press%kurtosis = self%faces%heights%kurtosis
      allocate (problem, source=press)
   end subroutine make_problem

   !> What no face has, and limits of the law that the record goes past.
   subroutine remarks(self, lines)
      !> The kind, declared with the values found
      class(press_kind), intent(in) :: self
      !> The remarks
      type(string_type), allocatable, intent(out) :: lines(:)
      type(faces_type) :: faces
      type(normal_properties) :: properties
      type(normal_response) :: response
      type(error_type), allocatable :: error
      integer :: bit

      allocate (lines(0))
      if (refusal(self%faces) /= '') call add_line(lines, 'The law refuses these '// &
         'values as those of no faces: '//refusal(self%faces))
      faces = self%faces
      faces%accept_unphysical = .true.
      call faces%normal(properties, error)
      if (allocated(error)) return
      response = evaluate_normal_law(properties, self%faces%initial_separation &
         - maxval(self%record%x - self%compliance*self%record%y))
      do bit = 0, bit_size(valid) - 2
         if (btest(response%validity, bit)) call add_line(lines, &
            'At the largest pressure: '//validity_remark(ibset(0, bit)))
      end do
   end subroutine remarks

   !> A case of faces.
   subroutine case_keys(self, keys, commands)
      !> The kind, declared with the values found
      class(press_kind), intent(in) :: self
      !> The keys
      type(key_list), intent(out) :: keys
      !> Commands that take such a case
      character(len=:), allocatable, intent(out) :: commands
      type(faces_type) :: faces
      logical :: is_key(n_properties)

      is_key = .true.
      is_key([friction_coefficient, critical_slip]) = .false.
      faces%usual = self%faces%values
      faces%has_memory = self%faces%has_memory
      faces%heights = self%faces%heights
      call faces%declare_values(keys, is_key)
      ! as a number, not as 4 sigma
      faces%initial_separation = self%faces%initial_separation
      call keys%real(separation_name, faces%initial_separation, 'mm', '')
      call faces%declare_unloading(keys)
      call faces%heights%declare(keys)
      if (refusal(self%faces) /= '') then
         faces%accept_unphysical = .true.
         call faces%declare_accept(keys)
      end if
      commands = 'curve, press, shear, tenon and table'
   end subroutine case_keys

end module asperity_program_commands_fit_press
