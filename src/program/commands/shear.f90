!> `asperity shear`: the direct shear box, one replay per normal stress.
module asperity_program_commands_shear
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_room, check_work
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: fewest_stick_elements, stick_summits
   use asperity_contact_friction_strength, only: find_friction_strength
   use asperity_contact_properties, only: contact_properties, without_summits
   use asperity_contact_state, only: status_slip
   use asperity_contact_stick_elements, only: find_stick_elements, stick_elements
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_friction_keys, only: declare_friction
   use asperity_program_commands_faces_heights_remark, only: remark_surface_heights
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_plots, only: draw_shear
   use asperity_program_commands_replay_failed_point, only: keep_failed_point
   use asperity_program_commands_shear_keys, only: declare_shear
   use asperity_program_commands_sweep_runs, only: run_sweep
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_status, column_validity, new_table, table_type
   use asperity_program_report_units, only: joule
   use asperity_program_system_progress, only: progress_type
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_shear_box, only: run_shear_box, shear_settings, shear_step
   implicit none
   private
   public :: shear_command

   !> Shears discs.
   type, extends(command_type) :: shear_command
      private
      type(faces_type) :: faces
      !> Specimen and path; the normal stress is set for each run
      type(shear_settings) :: box
      !> Normal stresses, MPa
      real(wp), allocatable :: normal_stress(:)
      !> Checked properties of the faces
      type(contact_properties) :: properties
   contains
      procedure :: describe, declare, check, run
      procedure, private :: has_summits
   end type shear_command

   !> History of one run.
   type :: history_type
      type(shear_step), allocatable :: steps(:)
   end type history_type

   !> Bytes of an increment in results and table
   integer(int64), parameter :: bytes_of_row = 600

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(shear_command), intent(inout) :: self

      self%name = 'shear'
      self%summary = 'direct shear box, as ABAQUS calls UINTER'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Direct shear of two discs under dead weight, through UINTER (Figs 13-18).'
   end subroutine describe

   !> Faces, specimen and path.
   pure subroutine declare(self, keys)
      !> The command
      class(shear_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%faces%declare(keys, has_friction=.true.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call self%faces%declare_rules(keys)
      call declare_friction(self%faces%friction, keys, has_time=.true., &
         pair_key=self%faces%pair_key)
      call self%faces%declare_accept(keys)
      call declare_shear(self%box, self%normal_stress, keys)
      call keys%switch('shrinking_overlap', self%box%shrinking_overlap, &
         'the overlap of the discs shrinks with displacement')
      call keys%real('shear_compliance', self%box%shear_compliance, 'mm/N', &
         'shear compliance of the two specimens together')
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_sweep(keys)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the faces.
   subroutine check(self, error)
      !> The command
      class(shear_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      call self%faces%contact(self%properties, error)
   end subroutine check

   !> Run the replays. `error` is set when a setting is refused or a replay fails.
   recursive subroutine run(self, report, error)
      !> The command
      class(shear_command), intent(inout) :: self
      !> Its table and summary are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(history_type) :: runs(size(self%normal_stress)), beside(size(self%normal_stress))
      type(shear_settings) :: settings
      type(progress_type) :: progress
      type(motion_path) :: failed
      integer :: i, rows

      if (self%sweep /= '') then
         call run_sweep(self, report, error)
         return
      end if
      ! each run is small, and not looked at for itself
      call check_room('shear', 0_int64, error)
      if (allocated(error)) return
      call progress%start('shear')
      settings = self%box
      do i = 1, size(runs)
         call progress%show(i - 1, size(runs), 'normal stresses')
         settings%normal_stress = self%normal_stress(i)
         call run_shear_box(settings, self%properties, runs(i)%steps, error, failed)
         if (allocated(error)) then
            call keep_failed_point(error, failed, self%properties, 'the box')
            exit
         end if
         if (.not. (self%has_summits() .and. report%is_drawn())) cycle
         call run_shear_box(settings, without_summits(self%properties), beside(i)%steps, error)
         if (allocated(error)) exit
      end do
      call progress%finish()
      if (allocated(error)) return

      rows = sum([(size(runs(i)%steps), i=1, size(runs))])
      call check_work(to_text(rows)//' increments', bytes_of_row*rows, error)
      if (allocated(error)) return
      call join_runs(self, runs, report)
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%summary = summary_of(self, runs)
      report%faces = self%faces%words()
      call remark_surface_heights(report, self%faces%heights, self%properties%normal)
      report%shown_columns = [character(len=24) :: 'normal_stress_nominal', 'displacement', &
         'overclosure', 'separation_over_sigma', 'normal_stress', 'shear_force', &
         'shear_stress_nominal', 'shear_stress', 'area_fraction', 'dissipation', 'status', &
         'validity']
      if (self%faces%has_memory) report%shown_columns = [report%shown_columns, &
         [character(len=len(report%shown_columns)) :: 'plastic_dissipation']]
      if (.not. report%is_drawn()) return
      if (self%has_summits()) then
         call draw_shear(report, self%properties, [(beside(i)%steps%shear_stress_nominal, &
            i=1, size(beside))])
      else
         call draw_shear(report, self%properties)
      end if
   end subroutine run

   !> Whether summits stick each for itself.
   pure logical function has_summits(self)
      !> The command
      class(shear_command), intent(in) :: self

      has_summits = self%properties%friction%stick == stick_summits
   end function has_summits

   !> One table of all runs, each row led by the normal stress of its run.
   pure subroutine join_runs(self, runs, report)
      type(shear_command), intent(in) :: self
      type(history_type), intent(in) :: runs(:)
      type(report_type), intent(inout) :: report
      type(shear_step), allocatable :: s(:)
      real(wp), allocatable :: nominal(:)
      integer :: i

      allocate (report%first_rows(size(runs) + 1))
      report%first_rows(1) = 1
      do i = 1, size(runs)
         report%first_rows(i + 1) = report%first_rows(i) + size(runs(i)%steps)
      end do
      allocate (s(report%first_rows(size(runs) + 1) - 1))
      allocate (nominal(size(s)), report%important(size(s)))
      do i = 1, size(runs)
         associate (first => report%first_rows(i), last => report%first_rows(i + 1) - 1)
            s(first:last) = runs(i)%steps
            nominal(first:last) = self%normal_stress(i)
            report%important(first:last) = turning_points((s(first:last)%displacement))
         end associate
      end do

      report%table = new_table(columns=22 + merge(1, 0, self%faces%has_memory), &
         rows=size(s), leading=2)
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      associate (table => report%table)
         call table%add_numbers('normal_stress_nominal', 'MPa', nominal)
         call table%add_numbers('time', 's', (s%time))
         call table%add_numbers('displacement', 'mm', (s%displacement))
         call table%add_numbers('slip', 'mm', (s%slip))
         call table%add_numbers('overclosure', 'mm', (s%overclosure))
         call table%add_numbers('separation', 'mm', (s%separation))
         call table%add_numbers('separation_over_sigma', '-', (s%separation_over_sigma))
         call table%add_numbers('overlap_area', 'mm^2', (s%overlap_area))
         call table%add_numbers('normal_stress', 'MPa', (s%normal_stress))
         call table%add_numbers('shear_force', 'N', (s%shear_force))
         call table%add_numbers('shear_stress_nominal', 'MPa', (s%shear_stress_nominal))
         call table%add_numbers('shear_stress', 'MPa', (s%shear_stress))
         call table%add_numbers('area_fraction', '-', (s%area_fraction))
         call table%add_numbers('normal_energy', 'J', joule*s%normal_energy)
         call table%add_numbers('tangential_energy', 'J', joule*s%tangential_energy)
         call table%add_numbers('dissipation', 'J', joule*s%dissipation)
         if (self%faces%has_memory) call table%add_numbers('plastic_dissipation', 'J', &
            joule*s%plastic_dissipation)
         call table%add_numbers('pressure_coupling', 'J', joule*s%pressure_coupling)
         call table%add_numbers('elastic_share', '-', (s%elastic_share))
         call table%add_numbers('elastoplastic_share', '-', (s%elastoplastic_share))
         call table%add_numbers('plastic_share', '-', (s%plastic_share))
         call table%add_codes('status', column_status, (s%status))
         call table%add_codes('validity', column_validity, (s%validity))
      end associate
   end subroutine join_runs

   !> One row per normal stress: closure under load, initial slope, plateau, dissipation.
   pure function summary_of(self, runs) result(table)
      type(shear_command), intent(in) :: self
      type(history_type), intent(in) :: runs(:)
      type(table_type) :: table
      type(shear_step) :: seated(size(runs)), turned(size(runs)), last(size(runs))
      real(wp), dimension(size(runs)) :: slope, plateau_nominal, plateau, stiffness, strength
      type(stick_elements) :: elements
      real(wp) :: by_pressure
      logical :: has_rest
      integer :: i

      slope = none
      do i = 1, size(runs)
         associate (steps => runs(i)%steps)
            seated(i) = steps(1)
            turned(i) = steps(first_turn(steps))
            last(i) = steps(size(steps))
            if (size(steps) > 1) slope(i) = steps(2)%shear_stress_nominal/steps(2)%displacement
         end associate
      end do
      ! The plateau is read where the box first turns; there is none unless it slips there
      plateau_nominal = merge(abs(turned%shear_stress_nominal), none, &
         turned%status == status_slip)
      plateau = merge(abs(turned%shear_stress), none, turned%status == status_slip)

      has_rest = self%properties%friction%static_friction_coefficient > 0.0_wp
      table = new_table(columns=8 + merge(1, 0, self%faces%has_memory) &
         + merge(2, 0, self%has_summits()) + merge(1, 0, has_rest), rows=size(runs))
      call table%add_numbers('normal_stress_nominal', 'MPa', self%normal_stress)
      call table%add_numbers('overclosure', 'mm', (seated%overclosure))
      call table%add_numbers('separation_over_sigma', '-', (seated%separation_over_sigma))
      if (self%has_summits()) then
         do i = 1, size(runs)
            call find_stick_elements(self%properties%normal, &
               self%properties%friction%shear_modulus, fewest_stick_elements, &
               seated(i)%separation, elements)
            stiffness(i) = elements%stiffness
            call find_friction_strength(self%properties, seated(i)%normal_stress, strength(i), &
               by_pressure)
         end do
         call table%add_numbers('shear_stiffness', 'MPa/mm', stiffness)
         call table%add_numbers('stiffness_by_gcrit', 'MPa/mm', &
            strength/self%properties%critical_slip)
      end if
      call table%add_numbers('initial_slope', 'MPa/mm', slope)
      if (has_rest) call table%add_numbers('peak_nominal', 'MPa', &
         [(maxval(abs(runs(i)%steps%shear_stress_nominal)), i=1, size(runs))])
      call table%add_numbers('plateau_nominal', 'MPa', plateau_nominal)
      call table%add_numbers('mu_p_nominal', 'MPa', &
         self%properties%friction_coefficient*self%normal_stress)
      call table%add_numbers('plateau', 'MPa', plateau)
      call table%add_numbers('dissipation', 'J', joule*last%dissipation)
      if (self%faces%has_memory) call table%add_numbers('plastic_dissipation', 'J', &
         joule*last%plastic_dissipation)
   end function summary_of

   !> Step at which the box first turns or ends.
   pure integer function first_turn(steps)
      type(shear_step), intent(in) :: steps(:)
      logical :: turns(size(steps))

      turns = turning_points((steps%displacement))
      if (size(turns) > 1) turns(1) = .false.
      first_turn = findloc(turns, .true., 1)
   end function first_turn

end module asperity_program_commands_shear
