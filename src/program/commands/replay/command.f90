!> `asperity replay`: a given motion of a contact point through a UINTER.
module asperity_program_commands_replay_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_abaqus_props, only: properties_from_props
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list
   use asperity_contact_properties, only: contact_properties
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_friction_keys, only: declare_friction
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_replay_expected, only: compare_with_expected
   use asperity_program_commands_replay_foreign, only: replay_foreign
   use asperity_program_commands_replay_path_input, only: read_path
   use asperity_program_commands_replay_plot, only: draw_replay
   use asperity_program_commands_replay_tables, only: add_remarks, replay_table, shown_columns
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_system_strings, only: starts_with
   use asperity_replay_abaqus_host, only: host_point, new_host_point
   use asperity_replay_abaqus_record, only: optional_outputs
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_path_replay, only: path_step, replay_path
   implicit none
   private
   public :: replay_command

   !> Replays paths.
   type, extends(command_type) :: replay_command
      private
      !> Paths of the motion, and of another UINTER, empty for ours
      character(len=:), allocatable :: path, uinter
      !> PROPS, length of STATEV and whether they are given; components
      real(wp), allocatable :: props(:)
      logical :: has_props = .false., has_nstatv = .false.
      integer :: nstatv = 0, ndir = 3
      !> What a result may be off the expected one, as a part of the largest of its column. A
      !> result of the same routine comes back to the last bit, another compiler's to 1e-12 or so;
      !> what is printed has six figures
      real(wp) :: tolerance = 1.0e-6_wp
      type(faces_type) :: faces
      !> Checked properties of the faces
      type(contact_properties) :: properties
      !> Columns that depart from what is expected, empty for none
      character(len=:), allocatable :: departs
   contains
      procedure :: describe, declare, check, run, finish
   end type replay_command

   !> Bytes of an increment in results and table, and of each state variable in both
   integer(int64), parameter :: bytes_of_row = 400, bytes_of_variable = 16

   procedure(uinter_interface) :: uinter

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(replay_command), intent(inout) :: self

      self%name = 'replay'
      self%summary = 'a given motion of a contact point through any UINTER'
      self%usage = 'PATH.csv [CASE.nml] [options]'
      self%purpose = 'Lead a contact point along a motion as ABAQUS would, through asperity''s '// &
         'UINTER or another. The path has columns time, overclosure, slip_1 '// &
         'and slip_2, a row at the end of each increment; pressure, shear_1 and shear_2, where '// &
         'it has them, are what is expected, and the command ends with status 1 when the '// &
         'result departs. What it writes by --csv is such a path.'
      self%headings(2) = 'The replay, also keys of a case file'
   end subroutine describe

   !> Path, UINTER and faces.
   pure subroutine declare(self, keys)
      !> The command
      class(replay_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys
      integer :: i

      call self%faces%declare(keys, has_friction=.true.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call self%faces%declare_rules(keys)
      call declare_friction(self%faces%friction, keys, has_time=.true., &
         pair_key=self%faces%pair_key)
      call self%faces%declare_accept(keys)
      call keys%text('path', self%path, 'CSV file of the motion, as PATH.csv without an option')
      call keys%reads('path', is_argument=.true.)
      call keys%text('uinter', self%uinter, &
         'another UINTER than asperity''s: Fortran source or shared library (.so)')
      call keys%reads('routine', is_argument=.false.)
      call keys%list('properties', self%props, '', 'PROPS of the user routine')
      self%has_props = keys%given()
      call keys%whole('nstatv', self%nstatv, 'length of STATEV of the user routine')
      self%has_nstatv = keys%given()
      call keys%needs(self%uinter /= '', 'is for --uinter: asperity''s own has what it needs')
      call keys%whole('ndir', self%ndir, 'components of the relative motion, 2 or 3')
      call keys%real('tolerance', self%tolerance, '', &
         'what a value may be off, as a part of the largest of its column')
      do i = 1, keys%n
         if (keys%rows(i)%is_property) call keys%needs(self%uinter == '' .and. &
            .not. self%has_props, 'is of asperity''s faces, where neither --uinter nor '// &
            '--properties is given', i)
      end do
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check what is given, and the faces.
   subroutine check(self, error)
      !> The command
      class(replay_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      self%departs = ''
      if (.not. allocated(self%props)) allocate (self%props(0))
      if (self%path == '') then
         call fatal_error(error, 'no path is given: asperity replay PATH.csv')
      else if (all(self%ndir /= [2, 3])) then
         call fatal_error(error, 'ndir = '//to_text(self%ndir)//' is not allowed: 2 or 3', &
            subject='ndir')
      else if (self%uinter /= '' .and. .not. self%has_nstatv) then
         call fatal_error(error, '--uinter needs the length of STATEV as well, DEPVAR of the '// &
            'deck, by --nstatv; 0 for none', subject='nstatv')
      else if (self%nstatv < 0) then
         call fatal_error(error, 'nstatv = '//to_text(self%nstatv)// &
            ' is not allowed: it must not be negative', subject='nstatv')
      else if (.not. (self%tolerance > 0.0_wp .and. self%tolerance < 1.0_wp)) then
         call fatal_error(error, 'tolerance = '//to_text(self%tolerance)// &
            ' is not allowed: above 0 and below 1', subject='tolerance')
      else if (self%uinter /= '') then
         continue
      else if (self%has_props) then
         call properties_from_props(self%props, self%properties, error)
      else
         call self%faces%contact(self%properties, error)
      end if
   end subroutine check

   !> Replay the path. `error` is set when it cannot be read or UINTER fails.
   subroutine run(self, report, error)
      !> The command
      class(replay_command), intent(inout) :: self
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(motion_path) :: path
      type(path_step), allocatable :: steps(:)
      type(finding_list) :: findings
      logical :: unset(size(optional_outputs))

      call read_path(self%path, path, error)
      if (.not. allocated(error)) call check_components(self, path, error)
      if (.not. allocated(error)) call check_work(to_text(size(path%time))//' increments', &
         (bytes_of_row + bytes_of_variable*self%nstatv)*size(path%time, kind=int64), error)
      if (allocated(error)) return
      if (self%uinter == '') then
         call replay_own(self, path, steps, unset, error)
      else
         call replay_foreign(self%uinter, path, self%props, self%nstatv, self%ndir, steps, unset, &
            findings, error)
      end if
      if (allocated(error)) then
         if (starts_with(error%message, 'row ')) error%message = self%path//', '//error%message
         return
      end if
      report%table = replay_table(path, steps, self%ndir, is_ours=self%uinter == '')
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%faces = self%faces%words()
      if (self%has_props) report%faces = 'given properties'
      if (self%uinter /= '') report%faces = 'UINTER of '//self%uinter
      report%shown_columns = shown_columns(report%table)
      report%first_rows = [1, size(steps) + 1]
      report%important = turning_points(path%overclosure) .or. turning_points(path%slip(1, :))
      call add_remarks(report, steps, unset, findings)
      call compare_with_expected(report, path, steps, self%tolerance, self%departs)
      if (report%is_drawn()) call draw_replay(report, path)
   end subroutine run

   !> Fail when the result departs from what was expected.
   subroutine finish(self, error)
      !> The command
      class(replay_command), intent(inout) :: self
      !> Set when it departs
      type(error_type), allocatable, intent(out) :: error

      if (self%departs /= '') call fatal_error(error, 'the result departs from what '// &
         self%path//' expects, in '//self%departs, computation_error)
   end subroutine finish

   !> Refuse slip in a direction that is not there.
   pure subroutine check_components(self, path, error)
      type(replay_command), intent(in) :: self
      type(motion_path), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error

      if (self%ndir == 2 .and. any(abs(path%slip(2, :)) > 0.0_wp)) call fatal_error(error, &
         self%path//': has slip_2, which is not zero and needs ndir = 3', subject='ndir')
   end subroutine check_components

   !> The path through asperity's UINTER.
   subroutine replay_own(self, path, steps, unset, error)
      type(replay_command), intent(in) :: self
      type(motion_path), intent(in) :: path
      type(path_step), allocatable, intent(out) :: steps(:)
      logical, intent(out) :: unset(:)
      type(error_type), allocatable, intent(out) :: error
      type(host_point) :: point

      if (self%has_props) then
         call new_host_point(point, uinter, self%properties, self%ndir, self%props, &
            keep_history=.false.)
      else
         call new_host_point(point, uinter, self%properties, self%ndir, keep_history=.false.)
      end if
      call replay_path(path, point, steps, error)
      unset = point%unset
   end subroutine replay_own

end module asperity_program_commands_replay_command
