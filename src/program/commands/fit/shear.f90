!> Shear records: friction by the keys of `asperity shear`.
module asperity_program_commands_fit_shear
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_problem, only: fit_problem
   use asperity_fit_shear, only: new_shear_problem, shear_problem
   use asperity_fit_shear_model, only: check_shear_tests, shear_critical_slip, &
      shear_decay_slip, shear_friction_coefficient, shear_names, shear_pressure_exponent, &
      shear_reference_pressure, shear_shear_compliance, shear_static_friction_coefficient, &
      shear_test, shear_units
   use asperity_program_commands_fit_kind, only: fit_kind
   use asperity_program_commands_fit_record_input, only: fit_record, record_quantities
   use asperity_program_commands_fit_shear_tests, only: find_normal_stress, guess, remark_loaded
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_names, only: holds_displacement, holds_force, holds_pressure
   use asperity_program_system_strings, only: string_type
   use asperity_replay_shear_settings, only: overlap_area
   implicit none
   private
   public :: new_shear_kind

   !> What the numbers of the model are
   character(len=*), parameter :: helps(size(shear_names)) = [character(len=60) :: &
      'Coulomb friction coefficient in motion', 'largest elastic slip', &
      'coefficient at rest', 'slip over which the excess at rest falls to 1/e', &
      'friction as a power of pressure', 'pressure at which that power is one', &
      'largest shear stress', 'shear compliance of specimens and machine together']
   !> Bounds of what is guessed, over the guess
   real(wp), parameter :: wide = 100.0_wp

   !> Friction along shear records.
   type, extends(fit_kind) :: shear_kind
      private
      !> Numbers of the model
      real(wp) :: values(size(shear_names)) = 0.0_wp
      !> Diameter of the discs, mm, and normal stress where the record has none, MPa
      real(wp) :: diameter = none, normal_stress = none
      !> Area that makes a stress of the second column, mm^2 for forces, else 1
      real(wp) :: divisor = 1.0_wp
      type(shear_test), allocatable :: tests(:)
   contains
      procedure :: declare, missing, take_records, parameter_of, make_problem, remarks, &
         case_keys
   end type shear_kind

contains

   !> The kind: forces, or shear stresses.
   subroutine new_shear_kind(kind)
      !> The kind
      class(fit_kind), allocatable, intent(out) :: kind

      allocate (shear_kind :: kind)
      kind%choices = [record_quantities([holds_displacement, holds_force], &
         [character(len=16) :: 'displacement', 'shear_force'], [character(len=16) :: 'mm', 'N']), &
         record_quantities([holds_displacement, holds_pressure], &
         [character(len=16) :: 'displacement', 'shear_stress'], [character(len=16) :: 'mm', 'MPa'])]
   end subroutine new_shear_kind

   !> Friction, size and normal stress. What is zero unless given does nothing then.
   subroutine declare(self)
      !> The kind
      class(shear_kind), intent(inout) :: self
      integer :: i

      self%values = 0.0_wp
      self%values([shear_friction_coefficient, shear_critical_slip, shear_reference_pressure]) &
         = none
      self%diameter = none
      self%normal_stress = none
      do i = 1, size(shear_names)
         call self%keys%real(trim(shear_names(i)), self%values(i), trim(shear_units(i)), &
            trim(helps(i)))
         call self%keys%unused(i > shear_critical_slip .and. .not. self%keys%given())
      end do
      call self%keys%real('diameter', self%diameter, 'mm', 'diameter of the two discs')
      call self%keys%real('normal_stress', self%normal_stress, 'MPa', &
         'normal stress on the full disc; of a record that has it in a leading column, that')
      if (.not. self%keys%given()) return
      associate (key => self%keys%rows(self%keys%last))
         if (size(key%values) > 1) call self%keys%refuse('normal_stress: one value is taken, '// &
            'for all tests that do not say theirs in a leading column', 'normal_stress')
      end associate
   end subroutine declare

   !> Friction and critical slip, and what goes with what else is asked for.
   pure function missing(self, free) result(names)
      !> The kind, declared
      class(shear_kind), intent(in) :: self
      !> Names of the free keys
      type(string_type), intent(in) :: free(:)
      !> Separated by blanks
      character(len=:), allocatable :: names
      logical :: has(size(shear_names)), needed(size(shear_names))
      integer :: i, j

      do i = 1, size(has)
         has(i) = any([(free(j)%text == shear_names(i), j=1, size(free))])
         if (.not. has(i) .and. .not. is_none(self%values(i))) has(i) = abs(self%values(i)) > 0.0_wp
      end do
      needed = .false.
      needed([shear_friction_coefficient, shear_critical_slip]) = .true.
      needed(shear_decay_slip) = has(shear_static_friction_coefficient)
      needed(shear_static_friction_coefficient) = has(shear_decay_slip)
      needed(shear_reference_pressure) = has(shear_pressure_exponent)
      names = ''
      do i = 1, size(has)
         if (needed(i) .and. .not. has(i)) names = names//' '//trim(shear_names(i))
      end do
      names = trim(adjustl(names))
   end function missing

   !> Shear stress and normal stress of each test. `error` is set when one has no normal stress, or
   !> the tests cannot be followed.
   subroutine take_records(self, records, error)
      !> The kind, declared
      class(shear_kind), intent(inout) :: self
      !> The tests; displacement in mm, force in N or shear stress in MPa
      type(fit_record), intent(inout) :: records(:)
      !> Set when they do not fit
      type(error_type), allocatable, intent(out) :: error
      type(shear_test), allocatable :: tests(:)
      real(wp) :: normal_stress
      integer :: i

      if (.not. is_none(self%diameter)) then
         call check_positive(error, 'diameter', self%diameter, 'mm')
      else if (self%quantities%units(2) == 'N') then
         call fatal_error(error, 'the record has forces: give the diameter of the discs in '// &
            'mm by --fix diameter=, for the area that they act on')
      end if
      if (allocated(error)) return
      if (self%quantities%units(2) == 'N') self%divisor = overlap_area(self%diameter, 0.0_wp)
      allocate (tests(size(records)))
      do i = 1, size(records)
         call find_normal_stress(records(i), self%normal_stress, normal_stress, error)
         if (allocated(error)) return
         associate (n => size(records(i)%x))
            tests(i)%displacement = records(i)%x
            tests(i)%shear_stress = records(i)%y/self%divisor
            allocate (tests(i)%normal_stress(n), source=normal_stress)
            if (.not. is_none(self%diameter)) &
               allocate (tests(i)%area(n), source=overlap_area(self%diameter, 0.0_wp))
         end associate
      end do
      call check_shear_tests(tests, error)
      if (.not. allocated(error)) call move_alloc(tests, self%tests)
   end subroutine take_records

   !> Unit, start and bounds of a number: about its value, or about a guess by the record.
   subroutine parameter_of(self, name, parameter, error)
      !> The kind, with its record
      class(shear_kind), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Start and bounds may still be changed by the user
      type(fit_parameter), intent(out) :: parameter
      !> Set when it may not be free
      type(error_type), allocatable, intent(out) :: error
      integer :: which

      which = findloc(shear_names == name, .true., 1)
      if (which == 0) then
         call fatal_error(error, '--free: '//name//' is measured, and cannot be free')
         return
      end if
      if (which == shear_shear_compliance .and. is_none(self%diameter)) then
         call fatal_error(error, '--free: shear_compliance needs the area that forces act on: '// &
            'give the diameter of the discs in mm by --fix diameter=')
         return
      end if
      parameter%name = name
      parameter%unit = shear_units(which)
      parameter%by_ratio = all(which /= [shear_pressure_exponent, shear_shear_compliance])
      parameter%start = guess(self%tests, which)
      if (.not. is_none(self%values(which))) then
         if (abs(self%values(which)) > 0.0_wp) parameter%start = self%values(which)
      end if
      parameter%lower = parameter%start/wide
      parameter%upper = parameter%start*wide
      select case (which)
      case (shear_shear_compliance)
         parameter%lower = 0.0_wp
         parameter%scale = parameter%start
      case (shear_pressure_exponent)
         parameter%lower = -0.9_wp
         parameter%upper = 1.0_wp
      case default
         continue
      end select
   end subroutine parameter_of

   !> The problem of some free keys.
   subroutine make_problem(self, free, scale, problem, error)
      !> The kind, with its record
      class(shear_kind), intent(inout) :: self
      !> Names of the free keys, in the order of the values
      type(string_type), intent(in) :: free(:)
      !> What differences are divided by at each sample, in the unit of the record
      real(wp), intent(in) :: scale(:)
      !> The problem
      class(fit_problem), allocatable, intent(out) :: problem
      !> Set when the tests cannot be followed
      type(error_type), allocatable, intent(out) :: error
      type(shear_problem), allocatable :: own
      real(wp) :: values(size(shear_names))
      integer :: i

      values = self%values
      where (is_none(values)) values = 0.0_wp
      allocate (own)
      call new_shear_problem(own, self%tests, values, &
         [(findloc(shear_names == free(i)%text, .true., 1), i=1, size(free))], &
         scale/self%divisor, error)
      call move_alloc(own, problem)
   end subroutine make_problem

   !> Tests that begin under load.
   subroutine remarks(self, lines)
      !> The kind, declared with the values found
      class(shear_kind), intent(in) :: self
      !> One a remark
      type(string_type), allocatable, intent(out) :: lines(:)

      call remark_loaded(self%tests, lines)
   end subroutine remarks

   !> The numbers found, with the tests' normal stresses.
   subroutine case_keys(self, keys, commands)
      !> The kind, declared with the values found
      class(shear_kind), intent(in) :: self
      !> The keys
      type(key_list), intent(out) :: keys
      !> Commands that take such a case, as a text
      character(len=:), allocatable, intent(out) :: commands
      real(wp), allocatable :: stresses(:)
      real(wp) :: value
      integer :: i

      commands = 'shear; a pair or properties of faces go into this file'
      do i = 1, size(shear_names)
         value = self%values(i)
         if (is_none(value)) cycle
         if (abs(value) > 0.0_wp) call keys%real(trim(shear_names(i)), value, &
            trim(shear_units(i)), '')
      end do
      value = self%diameter
      if (.not. is_none(value)) call keys%real('diameter', value, 'mm', '')
      stresses = [(self%tests(i)%normal_stress(1), i=1, size(self%tests))]
      call keys%list('normal_stress', stresses, 'MPa', '')
   end subroutine case_keys

end module asperity_program_commands_fit_shear
