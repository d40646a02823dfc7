!> `asperity tenon`: the cyclic tenon joint under hard contact and under the rough law.
module asperity_program_commands_tenon_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_heights_remark, only: remark_surface_heights
   use asperity_program_commands_joint_face_rows, only: face_table
   use asperity_program_commands_joint_loops, only: hard, legends, rough
   use asperity_program_commands_joint_tables, only: comparison_table, cycles_table, &
      skeleton_table
   use asperity_program_commands_opensees_joint, only: add_joint_material, check_history
   use asperity_program_commands_opensees_output, only: opensees_output
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_commands_tenon_compare_models, only: check_moment, joint_type, &
      run_joint, steps_to_record
   use asperity_program_commands_tenon_face_rows, only: joint_face_rows
   use asperity_program_commands_tenon_failure, only: keep_failed_step, &
      keep_point_of_step
   use asperity_program_commands_tenon_history, only: follow_history, history_type, read_history
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_commands_tenon_page, only: joint_page
   use asperity_program_commands_tenon_paper_joint, only: is_paper_joint
   use asperity_program_commands_tenon_plots, only: joint_pictures
   use asperity_program_commands_tenon_remarks, only: joint_remarks
   use asperity_program_commands_tenon_sweep, only: report_sweep
   use asperity_program_commands_tenon_sweeps_file, only: close_partial, partial_type
   use asperity_program_commands_tenon_tables, only: points_table, steps_table, totals_table
   use asperity_program_input_key, only: kind_file, kind_picture
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: named_table, report_type, turning_points
   use asperity_program_system_progress, only: clear_steps, show_steps, tell_terminal
   use asperity_replay_tenon_load_path, only: tenon_programme
   implicit none
   private
   public :: tenon_command

   !> Replays the joint under hard contact and under the rough law.
   type, extends(command_type) :: tenon_command
      private
      type(tenon_case) :: case
      !> Paths of further outputs
      character(len=:), allocatable :: points, page
      !> Material for a frame program
      type(opensees_output) :: opensees
      !> What is kept of a sweep while it runs
      type(partial_type) :: partial
   contains
      procedure :: describe, declare, check, run, finish
   end type tenon_command

   !> Bytes of a step in both replays, their analysis and tables
   integer(int64), parameter :: bytes_of_step = 3000

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(tenon_command), intent(inout) :: self

      self%name = 'tenon'
      self%summary = 'cyclic tenon joint, hard contact against the rough law'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Cyclic replay of a straight tenon joint: moment, stiffness and energy of '// &
         'hard contact and of the rough law, beside the paper''s (Figs 19-35, Table 5).'
   end subroutine describe

   !> Faces, joint, programme and outputs.
   pure subroutine declare(self, keys)
      !> The command
      class(tenon_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call declare_replay_case(self%case, keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call keys%text('points', self%points, 'write every contact point at the steps of record '// &
         'as CSV; - is standard output', kind_file)
      call keys%text('report', self%page, &
         'write a page of case, table and pictures, .html (needs gnuplot)', kind_picture)
      call self%opensees%declare(keys)
      call self%declare_sweep(keys)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the case.
   subroutine check(self, error)
      !> The command
      class(tenon_command), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      call self%case%check(error, compiled=.true.)
      if (.not. allocated(error)) call self%opensees%check(error)
      if (.not. allocated(error) .and. self%sweep /= '') call check_sweep(self, error)
   end subroutine check

   !> Run both models, or a sweep. `error` is set when a setting is refused or a replay fails.
   subroutine run(self, report, error)
      !> The command
      class(tenon_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(history_type) :: history

      call read_history(history, self%case, error)
      ! The cases of a sweep may have arms of their own
      if (.not. allocated(error) .and. self%sweep == '') &
         call follow_history(self%case%joint, history, error)
      if (.not. allocated(error)) call check_history(self%opensees, self%case%joint, error)
      if (allocated(error)) return
      call self%declare(report%keys)
      report%faces = self%case%faces%words()
      if (self%sweep == '') then
         call report_joint(self, report, error)
         if (.not. allocated(error)) report%more = [report%more, history%columns]
      else
         call report_sweep(self%case, history, self%sweep, self%csv, report, self%partial, error)
      end if
   end subroutine run

   !> Refuse outputs that a sweep has not.
   subroutine check_sweep(self, error)
      class(tenon_command), intent(in) :: self
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: option

      option = ''
      if (self%points /= '') option = '--points'
      if (self%page /= '') option = '--report'
      if (self%plot /= '') option = '--plot'
      if (self%opensees%is_asked()) option = '--opensees'
      if (option /= '') call fatal_error(error, option//': is for one run, not for --sweep')
   end subroutine check_sweep

   !> Remove what was kept of a sweep.
   subroutine finish(self, error)
      !> The command
      class(tenon_command), intent(inout) :: self
      !> Never set
      type(error_type), allocatable, intent(out) :: error

      if (allocated(self%partial%path)) call close_partial(self%partial)
   end subroutine finish

   !> Run both models.
   subroutine report_joint(self, report, error)
      class(tenon_command), intent(inout) :: self
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      type(joint_type) :: joints(2)
      real(wp), allocatable :: path(:)
      integer, allocatable :: cycle_of(:), record(:)

      call tenon_programme(self%case%joint, path, cycle_of)
      call check_work(to_text(size(path))//' steps', bytes_of_step*size(path), error)
      if (allocated(error)) return
      if (allocated(self%case%record)) then
         record = self%case%record
         call check_record(record, ubound(path, 1), error)
         if (allocated(error)) return
      else
         record = steps_to_record(path)
      end if
      call run_joint(self%case, hard, joints(hard), error, record, show_hard)
      if (.not. allocated(error)) &
         call run_joint(self%case, rough, joints(rough), error, record, show_rough)
      call clear_steps()
      if (allocated(error)) then
         call keep_failure(self%case, path, joints, report, error)
         return
      end if
      call tell_times(self%case, joints)
      call check_moment(joints, error)
      if (allocated(error)) return

      report%table = steps_table(joints, self%case%faces%has_memory)
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%summary = comparison_table(joints, is_paper_joint(self%case))
      report%more = [ &
         named_table('totals', 'Whole programme', &
         totals_table(joints, self%case%faces%has_memory)), &
         named_table('faces', 'Faces', face_table(joint_face_rows(joints))), &
         named_table('cycles', 'Cycles', cycles_table(joints), 14), &
         named_table('skeleton', '', skeleton_table(joints))]
      report%points = points_table(joints)
      report%remarks = joint_remarks(self%case, joints, is_paper_joint(self%case))
      call remark_surface_heights(report, self%case%faces%heights, self%case%properties%normal)
      call add_joint_material(self%opensees, report, joints, error)
      if (allocated(error)) return
      report%has_contact = any(joints%touches)
      report%shows_table = .false.
      associate (n => size(joints(hard)%steps))
         report%first_rows = [1, n + 1, report%table%rows + 1]
         report%important = [turning_points((joints(hard)%steps%displacement)), &
            turning_points((joints(rough)%steps%displacement))]
      end associate
      if (report%is_drawn()) then
         report%pictures = joint_pictures(joints)
         report%picture_title = picture_title(report, 'Tenon joint')
      end if
      if (self%page /= '') report%page = joint_page(report, self%case)
   end subroutine report_joint

   !> Times of both replays, and of one point in one evaluation of the equilibrium.
   subroutine tell_times(case, joints)
      type(tenon_case), intent(in) :: case
      type(joint_type), intent(in) :: joints(:)
      character(len=:), allocatable :: text
      real(wp) :: updates
      integer :: points, i

      associate (t => case%joint)
         points = 2*t%points
         if (t%side_pressure > 0.0_wp) points = points + t%side_points**2
         if (t%shoulders) points = points + 2*t%shoulder_points
      end associate
      text = 'tenon:'
      do i = 1, size(joints)
         updates = real(points, wp)*sum(joints(i)%steps%iterations)
         text = text//' '//trim(legends(i))//' '//to_text(joints(i)%seconds, 2)//' s, '// &
            to_text(1.0e9_wp*joints(i)%seconds/max(updates, 1.0_wp), 2)//' ns a point update;'
      end do
      call tell_terminal(text(:len(text) - 1))
   end subroutine tell_times

   !> Keep what replays the step that failed, and the contact point at which it did.
   subroutine keep_failure(case, path, joints, report, error)
      type(tenon_case), intent(in) :: case
      real(wp), intent(in) :: path(0:)
      type(joint_type), intent(in) :: joints(:)
      type(report_type), intent(in) :: report
      type(error_type), intent(inout) :: error
      integer :: failed

      failed = 0
      if (allocated(joints(hard)%steps)) failed = size(joints(hard)%steps)
      if (allocated(joints(rough)%steps)) failed = size(joints(rough)%steps)
      ! none failed when all are there, and a joint at rest needs no displacements
      if (failed > 0 .and. failed <= ubound(path, 1)) &
         call keep_failed_step(error, report%keys, path(1:failed))
      if (allocated(joints(rough)%steps)) call keep_point_of_step(error, case)
   end subroutine keep_failure

   !> Refuse steps that the programme has not, and steps that are not in order.
   pure subroutine check_record(record, steps, error)
      integer, intent(in) :: record(:), steps
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(record)
         if (record(i) > steps) then
            call fatal_error(error, 'record = '//to_text(record(i))// &
               ' is not allowed: the programme has '//to_text(steps)//' steps', subject='record')
            return
         end if
         if (all(record(:i - 1) < record(i))) cycle
         call fatal_error(error, 'record = '//to_text(record(i))// &
            ' is out of order: steps must rise', subject='record')
         return
      end do
   end subroutine check_record

   !> Progress of hard contact.
   subroutine show_hard(done, amount)
      integer, intent(in) :: done, amount

      call show_steps('tenon: hard contact', done, amount)
   end subroutine show_hard

   !> Progress of the rough law.
   subroutine show_rough(done, amount)
      integer, intent(in) :: done, amount

      call show_steps('tenon: rough law', done, amount)
   end subroutine show_rough

end module asperity_program_commands_tenon_command
