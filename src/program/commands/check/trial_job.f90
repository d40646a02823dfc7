!> A trial of a user routine as the work of a child process.
module asperity_program_commands_check_trial_job
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_funptr, c_int
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_text_builder, only: growing_text
   use asperity_check_finding, only: finding_list
   use asperity_check_settings, only: check_settings
   use asperity_check_trials, only: drive_uinter_outputs, drive_vuinter_outputs, run_uinter_trial, &
      run_vuinter_trial
   use asperity_program_commands_check_finding_lines, only: lines_of
   use asperity_program_commands_routine_load, only: load_uinter, load_vuinter
   use asperity_program_system_child_numbers, only: add_numbers
   use asperity_program_system_child_run, only: child_work
   use asperity_replay_shared_library, only: find_procedure, open_library, shared_library
   implicit none
   private
   public :: trial_job

   !> First word of the result when the library cannot be loaded; then follows why
   character(len=*), parameter, public :: not_loaded = 'not loaded: '

   !> A trial. Its result is the findings as lines, or the outputs as hexadecimal numbers.
   type, extends(child_work) :: trial_job
      !> Paths of the libraries of the routine and of the utilities of ABAQUS, empty for none
      character(len=:), allocatable :: library, utilities
      !> Whether it is VUINTER
      logical :: is_explicit = .false.
      !> Place among the trials; zero for the outputs along the path
      integer :: trial = 0
      !> What it is driven with
      type(check_settings) :: settings
   contains
      procedure :: work
   end type trial_job

   !> When UEXTERNALDB is called: start and end of the analysis, of an increment, of the step
   enum, bind(c)
      enumerator :: analysis_starts = 0, increment_starts, increment_ends, analysis_ends, &
         restart_starts, step_starts, step_ends
   end enum

   abstract interface
      !> ABAQUS/Standard's call at the joints of an analysis.
      subroutine uexternaldb_interface(lop, lrestart, time, dtime, kstep, kinc)
         import :: wp
         implicit none
         integer, intent(in) :: lop, lrestart, kstep, kinc
         real(wp), intent(in) :: time(2), dtime
      end subroutine uexternaldb_interface
   end interface

contains

   !> Load the routine and try it.
   subroutine work(self, text)
      !> The trial
      class(trial_job), intent(in) :: self
      !> Its result
      character(len=:), allocatable, intent(out) :: text
      procedure(uinter_interface), pointer :: uinter
      procedure(vuinter_interface), pointer :: vuinter
      type(error_type), allocatable :: error
      type(finding_list) :: findings
      type(growing_text) :: buffer
      real(wp), allocatable :: values(:)

      nullify (uinter, vuinter)
      if (self%is_explicit) then
         call load_vuinter(self%library, self%utilities, vuinter, error)
      else
         call load_uinter(self%library, self%utilities, uinter, error)
      end if
      if (allocated(error)) then
         text = not_loaded//error%message
         return
      end if
      if (.not. self%is_explicit) call tell_start(self)
      if (self%trial > 0) then
         if (self%is_explicit) then
            call run_vuinter_trial(self%trial, vuinter, self%settings, findings)
         else
            call run_uinter_trial(self%trial, uinter, self%settings, findings)
         end if
         text = lines_of(findings)
      else
         if (self%is_explicit) then
            call drive_vuinter_outputs(vuinter, self%settings, values)
         else
            call drive_uinter_outputs(uinter, self%settings, values)
         end if
         call add_numbers(buffer, values)
         text = buffer%text()
      end if
      if (.not. self%is_explicit) call tell_end(self)
   end subroutine work

   !> Call UEXTERNALDB, where the library has it, as before the first increment.
   subroutine tell_start(self)
      class(trial_job), intent(in) :: self

      call call_uexternaldb(self, analysis_starts, 0, 0)
      call call_uexternaldb(self, step_starts, 1, 0)
      call call_uexternaldb(self, increment_starts, 1, 1)
   end subroutine tell_start

   !> Call UEXTERNALDB, where the library has it, as after the last increment.
   subroutine tell_end(self)
      class(trial_job), intent(in) :: self

      call call_uexternaldb(self, increment_ends, 1, 1)
      call call_uexternaldb(self, step_ends, 1, 1)
      call call_uexternaldb(self, analysis_ends, 1, 1)
   end subroutine tell_end

   !> Call UEXTERNALDB once.
   subroutine call_uexternaldb(self, lop, kstep, kinc)
      class(trial_job), intent(in) :: self
      integer, intent(in) :: lop, kstep, kinc
      procedure(uexternaldb_interface), pointer :: uexternaldb
      type(shared_library) :: library
      type(c_funptr) :: found
      character(len=:), allocatable :: failure

      ! opening it again gives the one that is open
      call open_library(self%library, library, failure)
      if (allocated(failure)) return
      call find_procedure(library, 'uexternaldb_', found)
      if (.not. c_associated(found)) return
      call c_f_procpointer(found, uexternaldb)
      call uexternaldb(lop, 0, [0.0_wp, 0.0_wp], self%settings%time_increment, kstep, kinc)
   end subroutine call_uexternaldb

end module asperity_program_commands_check_trial_job
