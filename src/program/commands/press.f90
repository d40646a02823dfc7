!> `asperity press`: press and release, replayed through UINTER.
module asperity_program_commands_press
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_heights_remark, only: remark_surface_heights
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_plots, only: draw_press
   use asperity_program_commands_sweep_runs, only: run_sweep
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_status, column_validity, new_table, &
      table_type
   use asperity_program_system_progress, only: progress_type
   use asperity_replay_press, only: default_peak, press_loop, press_settings, press_step, run_press
   implicit none
   private
   public :: press_command

   !> Presses and releases.
   type, extends(command_type) :: press_command
      private
      type(faces_type) :: faces
      type(press_settings) :: press
      !> Whether the peak is given
      logical :: has_peak = .false.
      !> Checked properties of the faces
      type(contact_properties) :: properties
   contains
      procedure :: describe, declare, check, run
   end type press_command

   !> Bytes of an increment in results and table
   integer(int64), parameter :: bytes_of_row = 300

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(press_command), intent(inout) :: self

      self%name = 'press'
      self%summary = 'press and release, as ABAQUS calls UINTER'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Press two faces together and release them, through UINTER. Fig. 17 of '// &
         'the paper is the ramp of overclosure. A ramp of pressure starts and ends where the '// &
         'faces just part. With unloading = elastic every peak leaves a loop of pressure '// &
         'against closure: cycle_loss is its work, residual_closure where the faces part again.'
   end subroutine describe

   !> Faces and load path.
   pure subroutine declare(self, keys)
      !> The command
      class(press_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%faces%declare(keys, has_friction=.false.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call self%faces%declare_accept(keys)
      call keys%switch('accept_sizes', self%press%accept_sizes, &
         'let sizes and pressures pass that look like another unit')
      call keys%choice('control', self%press%control, 'pressure overclosure', &
         'what is ramped up and down')
      if (.not. allocated(self%press%peak)) self%press%peak = [default_peak]
      call keys%list('peak', self%press%peak, trim(merge('mm ', 'MPa', &
         self%press%control == 'overclosure')), &
         'peaks, a ramp up and a ramp down for each; needed, in mm, when control is overclosure')
      self%has_peak = keys%given()
      call keys%whole('increments', self%press%increments, 'increments of each ramp')
      call keys%real('step_time', self%press%step_time, 's', 'time of each ramp')
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_sweep(keys)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the faces, and that a peak goes with its control.
   subroutine check(self, error)
      !> The command
      class(press_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      if (self%press%control == 'overclosure' .and. .not. self%has_peak) then
         call fatal_error(error, 'control = overclosure needs a peak, in mm', subject='control')
      else
         call self%faces%contact(self%properties, error)
      end if
   end subroutine check

   !> Run the replay. `error` is set when a setting is refused or the replay fails.
   recursive subroutine run(self, report, error)
      !> The command
      class(press_command), intent(inout) :: self
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(press_step), allocatable :: s(:)
      type(press_loop), allocatable :: loops(:)
      type(progress_type) :: progress

      if (self%sweep /= '') then
         call run_sweep(self, report, error)
         return
      end if
      call progress%start('press')
      call progress%announce(self%press%increments, 'increments up and down')
      call run_press(self%press, self%properties, s, loops, error)
      call progress%finish()
      if (.not. allocated(error)) &
         call check_work(to_text(size(s))//' increments', bytes_of_row*size(s), error)
      if (allocated(error)) return

      report%table = new_table(columns=13 + merge(4, 0, self%faces%has_memory), rows=size(s))
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      associate (table => report%table)
         call table%add_numbers('time', 's', (s%time))
         call table%add_numbers('overclosure', 'mm', (s%overclosure))
         call table%add_numbers('separation', 'mm', (s%separation))
         call table%add_numbers('pressure', 'MPa', (s%pressure))
         call table%add_numbers('stiffness', 'MPa/mm', (s%stiffness))
         call table%add_numbers('area_fraction', '-', (s%area_fraction))
         call table%add_numbers('contact_density', '1/mm^2', (s%contact_density))
         call table%add_numbers('energy', 'N/mm', (s%energy))
         if (self%faces%has_memory) call add_memory(table, s, loops)
         call table%add_numbers('elastic_share', '-', (s%elastic_share))
         call table%add_numbers('elastoplastic_share', '-', (s%elastoplastic_share))
         call table%add_numbers('plastic_share', '-', (s%plastic_share))
         call table%add_codes('status', column_status, (s%status))
         call table%add_codes('validity', column_validity, (s%validity))
         call table%check_finite(error)
      end associate
      report%shown_columns = [character(len=24) :: 'time', 'overclosure', 'separation', &
         'pressure', 'stiffness', 'area_fraction', 'energy', 'elastic_share', &
         'elastoplastic_share', 'plastic_share', 'status', 'validity']
      if (self%faces%has_memory) report%shown_columns = [report%shown_columns, &
         [character(len=len(report%shown_columns)) :: 'plastic_dissipation']]
      report%summary = loops_table(loops, trim(merge('mm ', 'MPa', &
         self%press%control == 'overclosure')))
      report%faces = self%faces%words()
      call remark_surface_heights(report, self%faces%heights, self%properties%normal)
      report%first_rows = [1, size(s) + 1]
      report%important = turning_points((s%overclosure))
      if (.not. allocated(error) .and. report%is_drawn()) call draw_press(report)
   end subroutine run

   !> What the faces remember, and what a loop leaves in the row that ends it.
   pure subroutine add_memory(table, steps, loops)
      type(table_type), intent(inout) :: table
      type(press_step), intent(in) :: steps(:)
      type(press_loop), intent(in) :: loops(:)
      real(wp), dimension(size(steps)) :: residual, loss
      integer :: ramps

      ramps = (size(steps) - 1)/size(loops)
      residual = none
      loss = none
      residual(1 + ramps::ramps) = loops%residual_closure
      loss(1 + ramps::ramps) = loops%cycle_loss
      call table%add_numbers('plastic_dissipation', 'N/mm', (steps%plastic_dissipation))
      call table%add_numbers('closest_separation', 'mm', (steps%closest_separation))
      call table%add_numbers('residual_closure', 'mm', residual)
      call table%add_numbers('cycle_loss', 'N/mm', loss)
   end subroutine add_memory

   !> One row a peak.
   pure function loops_table(loops, unit) result(table)
      type(press_loop), intent(in) :: loops(:)
      character(len=*), intent(in) :: unit
      type(table_type) :: table

      table = new_table(columns=4, rows=size(loops))
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      call table%add_numbers('peak', unit, (loops%peak))
      call table%add_numbers('closest_separation', 'mm', (loops%closest_separation))
      call table%add_numbers('residual_closure', 'mm', (loops%residual_closure))
      call table%add_numbers('cycle_loss', 'N/mm', (loops%cycle_loss))
   end function loops_table

end module asperity_program_commands_press
