!> Records of a tenon joint: any real key of `asperity tenon` may be free. The model is the replay
!> with the rough law along the recorded displacements.
module asperity_program_commands_fit_joint
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_problem, only: fit_problem
   use asperity_program_commands_fit_joint_problem, only: joint_problem, new_joint_problem, &
      prepare_joint
   use asperity_program_commands_fit_joint_record, only: check_constants, joint_record, &
      thin_record
   use asperity_program_commands_fit_kind, only: fit_kind
   use asperity_program_commands_fit_record_input, only: fit_record, record_quantities
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_input_key, only: given_as_option, given_nowhere, key_type, kind_real
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_names, only: holds_displacement, holds_force, holds_moment, &
      holds_rotation
   use asperity_program_system_strings, only: add_line, string_type
   use asperity_replay_sizes, only: ranges
   implicit none
   private
   public :: new_joint_kind

   !> Bounds over the start, unless the key's range is narrower
   real(wp), parameter :: wide = 10.0_wp
   !> Keys that need not be given: the law's constant, and how it is computed. Keys of the
   !> programme, which the record takes the place of
   character(len=*), parameter :: need_not(*) = [character(len=22) :: 'plastic_ratio', &
      'displacement_increment']
   !> A record begins at rest within this share of its range, as in `asperity hysteresis`
   real(wp), parameter :: at_rest = 0.02_wp
   !> Samples that are compared, of each record
   integer, parameter :: most_samples = 400
   character(len=*), parameter :: of_programme(*) = [character(len=22) :: 'amplitudes', 'cycles', &
      'history', 'history_quantity', 'record', 'displacement_column', 'where', 'separator', &
      'decimal', 'skip_lines', 'displacement_unit']
   !> Searches of a model whose every evaluation is a replay
   integer, parameter :: few_searches = 2

   !> A joint along records.
   type, extends(fit_kind) :: joint_kind
      private
      !> What the record's columns are times these: mm and N
      real(wp) :: to_model(2) = 1.0_wp
      type(joint_record), allocatable :: records(:)
   contains
      procedure :: declare, missing, take_records, parameter_of, make_problem, remarks, &
         case_keys
   end type joint_kind

contains

   !> The kind: displacement and force, or rotation and moment.
   subroutine new_joint_kind(kind)
      !> The kind
      class(fit_kind), allocatable, intent(out) :: kind

      allocate (joint_kind :: kind)
      kind%usual_searches = few_searches
      kind%choices = [record_quantities([holds_displacement, holds_force], &
         [character(len=16) :: 'displacement', 'force'], [character(len=16) :: 'mm', 'N']), &
         record_quantities([holds_rotation, holds_moment], &
         [character(len=16) :: 'rotation', 'moment'], [character(len=16) :: 'rad', 'kN m'])]
   end subroutine new_joint_kind

   !> The keys of a replay. Those of the programme may be in a case file, but are not fixed.
   subroutine declare(self)
      !> The kind
      class(joint_kind), intent(inout) :: self
      type(tenon_case) :: case
      integer :: i

      call declare_replay_case(case, self%keys)
      do i = 1, self%keys%n
         if (all(of_programme /= self%keys%rows(i)%name)) cycle
         self%keys%rows(i)%unused = .true.
         if (self%keys%rows(i)%given == given_as_option) call self%keys%refuse( &
            trim(self%keys%rows(i)%name)//' cannot be fixed: the record takes the place of a '// &
            'programme', trim(self%keys%rows(i)%name))
      end do
   end subroutine declare

   !> Numbers of the joint that nobody gave: neither by name, nor by a pair or wood that was named.
   pure function missing(self, free) result(names)
      !> The kind, declared
      class(joint_kind), intent(in) :: self
      !> Names of the free keys
      type(string_type), intent(in) :: free(:)
      !> Separated by blanks
      character(len=:), allocatable :: names
      integer :: i, place

      names = ''
      do i = 1, self%keys%n
         if (.not. is_number(self%keys%rows(i))) cycle
         if (self%keys%rows(i)%given /= given_nowhere .or. self%keys%rows(i)%follows) cycle
         ! a pair or a wood that gives it says so
         associate (source => self%keys%rows(i)%source)
            place = self%keys%find(source(:index(source//' ', ' ') - 1))
         end associate
         if (place == 0) place = i
         call add_missing(self%keys%rows(place), free, names)
      end do
      names = trim(adjustl(names))
   end function missing

   !> Add the name of a key that nobody gave, once.
   pure subroutine add_missing(key, free, names)
      type(key_type), intent(in) :: key
      type(string_type), intent(in) :: free(:)
      character(len=:), allocatable, intent(inout) :: names
      integer :: i

      if (key%given /= given_nowhere) return
      if (any([(free(i)%text == key%name, i=1, size(free))])) return
      if (index(names//' ', ' '//trim(key%name)//' ') == 0) names = names//' '//trim(key%name)
   end subroutine add_missing

   !> Whether a key is a number of the model that acts.
   pure logical function is_number(key)
      type(key_type), intent(in) :: key

      is_number = key%kind == kind_real .and. key%is_input() .and. all(key%name /= need_not)
   end function is_number

   !> Thin the records, which then have the samples that are compared. `error` is set when one has
   !> no force.
   subroutine take_records(self, records, error)
      !> The kind, declared
      class(joint_kind), intent(inout) :: self
      !> The records
      type(fit_record), intent(inout) :: records(:)
      !> Set when they do not fit
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: arm
      integer :: i

      self%to_model = 1.0_wp
      if (self%quantities%units(2) /= 'N') then
         arm = self%keys%rows(self%keys%find('arm'))%values(1)
         self%to_model = [arm, 1.0e6_wp/arm]
      end if
      if (allocated(self%records)) deallocate (self%records)
      allocate (self%records(size(records)))
      do i = 1, size(records)
         call check_constants(records(i)%constants, error)
         if (allocated(error)) return
         associate (r => records(i))
            self%records(i)%name = r%title
            if (r%title == '') self%records(i)%name = 'The record'
            if (.not. maxval(r%x) > minval(r%x)) then
               call fatal_error(error, self%records(i)%name//' does not move')
            else if (.not. maxval(abs(r%y)) > 0.0_wp) then
               call fatal_error(error, self%records(i)%name//' has no force')
            end if
            if (allocated(error)) return
            call thin_record(self%records(i), self%to_model(1)*r%x, self%to_model(2)*r%y, &
               most_samples)
            r%x = self%records(i)%displacement/self%to_model(1)
            r%y = self%records(i)%force/self%to_model(2)
         end associate
      end do
   end subroutine take_records

   !> Unit, start and bounds of a key: about the value that it has, within what it may be.
   subroutine parameter_of(self, name, parameter, error)
      !> The kind, with its record
      class(joint_kind), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Start and bounds may still be changed by the user
      type(fit_parameter), intent(out) :: parameter
      !> Set when it may not be free
      type(error_type), allocatable, intent(out) :: error
      integer :: range

      associate (key => self%keys%rows(self%keys%find(name)))
         if (key%unused .or. name == 'displacement_increment') then
            call fatal_error(error, '--free: '//name//' does nothing in this joint')
         else if (name == 'arm' .and. self%to_model(1) > 1.0_wp) then
            call fatal_error(error, '--free: the arm makes displacement and force of rotation '// &
               'and moment, and cannot be free')
         else if (.not. key%has_value) then
            call fatal_error(error, '--free: '//name//' has no value '// &
               'to begin at: give one in --model')
         end if
         if (allocated(error)) return
         parameter%name = name
         parameter%unit = key%unit
         parameter%start = key%values(1)
         parameter%by_ratio = parameter%start > 0.0_wp
         parameter%lower = min(parameter%start/wide, parameter%start*wide)
         parameter%upper = max(parameter%start/wide, parameter%start*wide)
      end associate
      range = findloc(ranges%name == name, .true., 1)
      if (name == 'clearance') range = findloc(ranges%name == 'clearance_above', .true., 1)
      if (range == 0) return
      ! no clearance is no number to begin at, but a range above zero is searched by ratios
      parameter%by_ratio = ranges(range)%lowest > 0.0_wp
      parameter%lower = max(parameter%lower, ranges(range)%lowest)
      parameter%upper = min(parameter%upper, ranges(range)%highest)
   end subroutine parameter_of

   !> The problem of some free keys. `error` is set when the joint at the start is refused.
   subroutine make_problem(self, free, scale, problem, error)
      !> The kind, with its record
      class(joint_kind), intent(inout) :: self
      !> Names of the free keys, in the order of the values
      type(string_type), intent(in) :: free(:)
      !> What differences are divided by at each sample, in the unit of the record
      real(wp), intent(in) :: scale(:)
      !> The problem
      class(fit_problem), allocatable, intent(out) :: problem
      !> Set when the joint is refused
      type(error_type), allocatable, intent(out) :: error
      type(joint_problem) :: own
      type(tenon_case) :: case
      integer, allocatable :: places(:)
      integer :: i

      places = [(self%keys%find(free(i)%text), i=1, size(free))]
      call prepare_joint(self%keys, places, [(self%keys%rows(places(i))%values(1), &
         i=1, size(free))], case, error)
      if (allocated(error)) return
      call new_joint_problem(own, self%keys, places, self%records, self%to_model(2)*scale)
      allocate (problem, source=own)
   end subroutine make_problem

   !> How far the records are thinned, and where they do not begin at rest.
   subroutine remarks(self, lines)
      !> The kind, declared with the values found
      class(joint_kind), intent(in) :: self
      !> One a remark
      type(string_type), allocatable, intent(out) :: lines(:)
      integer :: i

      allocate (lines(0))
      do i = 1, size(self%records)
         associate (r => self%records(i))
            if (abs(r%displacement(1)) > at_rest*(maxval(r%displacement) &
               - minval(r%displacement))) call add_line(lines, r%name//' begins at '// &
               to_text(r%displacement(1), 4)//' mm, to where the joint is led from rest first: '// &
               'is its zero off (--displacement-zero)?')
            if (r%samples > size(r%force)) call add_line(lines, r%name//': '// &
               to_text(size(r%force))//' of '//to_text(r%samples)//' samples are compared, '// &
               'evenly along the way and where it turns.')
         end associate
      end do
   end subroutine remarks

   !> The joint with the values found.
   subroutine case_keys(self, keys, commands)
      !> The kind, declared with the values found
      class(joint_kind), intent(in) :: self
      !> The keys
      type(key_list), intent(out) :: keys
      !> Commands that take such a case, as a text
      character(len=:), allocatable, intent(out) :: commands

      keys = self%keys
      commands = 'tenon, with --history for the record'
   end subroutine case_keys

end module asperity_program_commands_fit_joint
