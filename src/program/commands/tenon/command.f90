!> `asperity tenon`: the cyclic tenon joint under hard contact and under the rough law.
module asperity_program_commands_tenon_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: negative_side, positive_side
   use asperity_program_commands_config, only: config_type
   use asperity_program_commands_hysteresis_remarks, only: excess_words
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_commands_tenon_compare_models, only: check_moment, hard, joint_type, &
      legends, rough, run_joint, steps_to_record
   use asperity_program_commands_tenon_failure, only: keep_failed_step
   use asperity_program_commands_tenon_page, only: joint_page
   use asperity_program_commands_tenon_paper_joint, only: is_paper_joint
   use asperity_program_commands_tenon_plots, only: joint_pictures
   use asperity_program_commands_tenon_tables, only: comparison_table, cycles_table, points_table, &
      skeleton_table, steps_table, totals_table
   use asperity_program_report_report, only: named_table, report_type, turning_points
   use asperity_program_system_progress, only: clear_steps, show_steps, tell_terminal
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_load_path, only: tenon_programme
   use asperity_replay_tenon_run, only: tenon_warned_pull_out
   implicit none
   private
   public :: report_tenon

   !> Bytes of a step in both replays, their analysis and tables
   integer(int64), parameter :: bytes_of_step = 3000

contains

   !> Run both models. `error` is set when a setting is refused or a replay fails.
   subroutine report_tenon(config, report, error)
      !> Faces, joint and programme
      type(config_type), intent(in) :: config
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(joint_type) :: joints(2)
      real(wp), allocatable :: path(:)
      integer, allocatable :: cycle_of(:), record(:)

      call tenon_programme(config%tenon, path, cycle_of)
      call check_work(to_text(size(path))//' steps', bytes_of_step*size(path), error)
      if (allocated(error)) return
      if (allocated(config%record)) then
         record = config%record
         call check_record(record, ubound(path, 1), error)
         if (allocated(error)) return
      else
         record = steps_to_record(path)
      end if
      call run_joint(config, hard, joints(hard), error, record, show_hard)
      if (.not. allocated(error)) &
         call run_joint(config, rough, joints(rough), error, record, show_rough)
      call clear_steps()
      if (allocated(error)) then
         call keep_failure(path, joints, report, error)
         return
      end if
      call tell_times(config, joints)
      call check_moment(joints, error)
      if (allocated(error)) return

      report%table = steps_table(joints)
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%summary = comparison_table(joints, is_paper_joint(report%settings))
      report%more = [ &
         named_table('totals', 'Whole programme', &
         totals_table(joints)), &
         named_table('cycles', 'Cycles', cycles_table(joints), 12), &
         named_table('skeleton', '', skeleton_table(joints))]
      report%points = points_table(joints)
      report%remarks = remarks(config, joints, is_paper_joint(report%settings))
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
      if (report%settings%given('report')) report%page = joint_page(report)
   end subroutine report_tenon

   !> Times of both replays, and of one point in one evaluation of the equilibrium.
   subroutine tell_times(config, joints)
      type(config_type), intent(in) :: config
      type(joint_type), intent(in) :: joints(:)
      character(len=:), allocatable :: text
      real(wp) :: updates
      integer :: points, i

      associate (t => config%tenon)
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

   !> Keep what replays the step that failed.
   subroutine keep_failure(path, joints, report, error)
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
         call keep_failed_step(error, report%settings, path(1:failed))
   end subroutine keep_failure

   !> Refuse steps that the programme has not, and steps that are not in order.
   pure subroutine check_record(record, steps, error)
      integer, intent(in) :: record(:), steps
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(record)
         if (record(i) > steps) then
            call fatal_error(error, 'record = '//to_text(record(i))// &
               ' is not allowed: the programme has '//to_text(steps)//' steps')
            return
         end if
         if (all(record(:i - 1) < record(i))) cycle
         call fatal_error(error, 'record = '//to_text(record(i))// &
            ' is out of order: steps must rise')
         return
      end do
   end subroutine check_record

   !> What must be known beside the figures.
   pure function remarks(config, joints, beside_paper) result(lines)
      type(config_type), intent(in) :: config
      type(joint_type), intent(in) :: joints(:)
      logical, intent(in) :: beside_paper
      type(string_type), allocatable :: lines(:)
      type(string_type) :: line
      real(wp) :: furthest
      integer :: i, side

      line%text = 'A prediction, not a fit to a test: '
      if (beside_paper) line%text = 'A prediction from chosen sizes, not a fit to the paper: '
      line%text = line%text//'compare ratios to hard contact, not moments.'
      lines = [line]
      do i = 1, size(joints)
         if (.not. joints(i)%touches) then
            line%text = trim(legends(i))//': the faces touch in no step, '// &
               trim(merge('so that all moment is friction of the sides', &
               'and there is no moment                     ', joints(i)%has_moment))
            lines = [lines, line]
         end if
         furthest = maxval(abs(joints(i)%steps%pull_out))
         if (furthest <= tenon_warned_pull_out*config%tenon%length) cycle
         line%text = trim(legends(i))//': the tenon moves '//to_text(furthest, 3)// &
            ' mm along its axis, more than a quarter of its length: the overlap, not the '// &
            'contact, then governs the moment'
         lines = [lines, line]
      end do
      do i = 1, size(joints)
         do side = positive_side, negative_side
            line%text = excess_words(joints(i)%loops%skeleton(side), 'kN m')
            if (line%text == '') cycle
            line%text = trim(legends(i))//': the replay has '//line%text// &
               ' than its skeleton through the tips of first cycles'
            lines = [lines, line]
         end do
      end do
   end function remarks

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
