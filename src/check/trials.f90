!> The trials of a routine, each of which may run in a process of its own.
module asperity_check_trials
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_kinds, only: wp
   use asperity_check_driven_call, only: new_uinter, new_vuinter, usual_ndir
   use asperity_check_driven_drive, only: drive, drive_record
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list
   use asperity_check_settings, only: check_settings
   use asperity_check_trial_cut_back, only: check_cut_back
   use asperity_check_trial_energy, only: check_energy
   use asperity_check_trial_first_call, only: check_first_call
   use asperity_check_trial_guard, only: check_guard
   use asperity_check_trial_no_surface, only: check_no_surface
   use asperity_check_trial_no_traction, only: check_no_traction
   use asperity_check_trial_nodes, only: check_nodes
   use asperity_check_trial_outputs, only: check_outputs
   use asperity_check_trial_perturbation, only: check_perturbation
   use asperity_check_trial_repeat, only: check_repeat
   use asperity_check_trial_rotation, only: check_rotation
   use asperity_check_trial_sign, only: check_sign
   use asperity_check_trial_step_size, only: check_step_size
   use asperity_check_trial_tangent, only: check_tangent
   use asperity_check_trial_two_d, only: check_two_d
   implicit none
   private
   public :: run_uinter_trial, run_vuinter_trial, drive_uinter_outputs, drive_vuinter_outputs

   !> Trials, the first of which only drives the routine along its path
   enum, bind(c)
      enumerator :: trial_drive = 1, trial_outputs, trial_guard, trial_repeat, trial_no_traction, &
         trial_no_surface, trial_sign, trial_energy, trial_step_size, trial_rotation, trial_two_d, &
         trial_nodes, trial_tangent, trial_first_call, trial_cut_back, trial_perturbation
   end enum
   !> Their names
   character(len=*), parameter :: names(trial_perturbation) = [character(len=12) :: 'drive', &
      'outputs', 'guard', 'repeat', 'no_traction', 'no_surface', 'sign', 'energy', 'step_size', &
      'rotation', 'two_d', 'nodes', 'tangent', 'first_call', 'cut_back', 'perturbation']
   !> Those of UINTER and of VUINTER
   integer, parameter :: of_uinter(15) = [trial_drive, trial_outputs, trial_guard, trial_tangent, &
      trial_repeat, trial_no_traction, trial_no_surface, trial_first_call, trial_cut_back, &
      trial_perturbation, trial_rotation, trial_two_d, trial_sign, trial_energy, trial_step_size]
   integer, parameter :: of_vuinter(12) = [trial_drive, trial_outputs, trial_guard, trial_repeat, &
      trial_nodes, trial_no_traction, trial_no_surface, trial_rotation, trial_two_d, trial_sign, &
      trial_energy, trial_step_size]
   !> Names of the trials of UINTER and of VUINTER
   character(len=*), parameter, public :: uinter_trials(size(of_uinter)) = names(of_uinter), &
      vuinter_trials(size(of_vuinter)) = names(of_vuinter)

contains

   !> Run one trial of a UINTER and add what it finds.
   subroutine run_uinter_trial(trial, routine, settings, findings)
      !> Place in `uinter_trials`
      integer, intent(in) :: trial
      !> The UINTER
      procedure(uinter_interface) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(driven_routine) :: usual, plane

      call new_uinter(usual, routine, settings, usual_ndir(settings))
      call new_uinter(plane, routine, settings, 2)
      call run_trial(of_uinter(trial), usual, plane, settings, findings)
   end subroutine run_uinter_trial

   !> Run one trial of a VUINTER and add what it finds.
   subroutine run_vuinter_trial(trial, routine, settings, findings)
      !> Place in `vuinter_trials`
      integer, intent(in) :: trial
      !> The VUINTER; in single precision where the settings say so
      procedure(vuinter_interface) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(driven_routine) :: usual, plane

      call new_vuinter(usual, routine, settings, usual_ndir(settings), nodes=1)
      call new_vuinter(plane, routine, settings, 2, nodes=1)
      call run_trial(of_vuinter(trial), usual, plane, settings, findings)
   end subroutine run_vuinter_trial

   subroutine run_trial(trial, usual, plane, settings, findings)
      integer, intent(in) :: trial
      type(driven_routine), intent(in) :: usual, plane
      type(check_settings), intent(in) :: settings
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(finding_list) :: of_solid
      integer :: found_before

      select case (trial)
      case (trial_drive)
         call drive(usual, main_path(settings), 1, record)
      case (trial_outputs)
         call check_outputs(usual, settings, findings)
      case (trial_guard)
         call check_guard(usual, settings, findings)
      case (trial_repeat)
         call check_repeat(usual, settings, findings)
      case (trial_no_traction)
         call check_no_traction(usual, settings, findings)
      case (trial_no_surface)
         call check_no_surface(usual, settings, findings)
      case (trial_sign)
         call check_sign(usual, settings, findings)
      case (trial_energy)
         call check_energy(usual, settings, findings)
      case (trial_step_size)
         call check_step_size(usual, settings, findings)
      case (trial_rotation)
         call check_rotation(usual, settings, findings)
      case (trial_two_d)
         if (settings%ndir /= 0) return
         found_before = findings%n
         call check_two_d(plane, usual, settings, findings)
         if (findings%n > found_before .or. .not. associated(plane%vuinter)) return
         ! several nodes in two dimensions alone
         call check_nodes(usual, settings, of_solid)
         if (of_solid%n == 0) call check_nodes(plane, settings, findings)
      case (trial_nodes)
         call check_nodes(usual, settings, findings)
      case (trial_tangent)
         call check_tangent(usual, settings, findings)
      case (trial_first_call)
         call check_first_call(usual, settings, findings)
      case (trial_cut_back)
         call check_cut_back(usual, settings, findings)
      case default
         call check_perturbation(usual, settings, findings)
      end select
   end subroutine run_trial

   !> All outputs of a UINTER along its path, for comparison with those of another build.
   subroutine drive_uinter_outputs(routine, settings, values)
      !> The UINTER
      procedure(uinter_interface) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> All numbers after each accepted call, one after the other
      real(wp), allocatable, intent(out) :: values(:)
      type(driven_routine) :: driven

      call new_uinter(driven, routine, settings, usual_ndir(settings))
      call drive_outputs(driven, settings, values)
   end subroutine drive_uinter_outputs

   !> All outputs of a VUINTER along its path, for comparison with those of another build.
   subroutine drive_vuinter_outputs(routine, settings, values)
      !> The VUINTER
      procedure(vuinter_interface) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> All numbers after each accepted call, one after the other
      real(wp), allocatable, intent(out) :: values(:)
      type(driven_routine) :: driven

      call new_vuinter(driven, routine, settings, usual_ndir(settings), nodes=1)
      call drive_outputs(driven, settings, values)
   end subroutine drive_vuinter_outputs

   !> All outputs along the path.
   subroutine drive_outputs(driven, settings, values)
      type(driven_routine), intent(in) :: driven
      type(check_settings), intent(in) :: settings
      real(wp), allocatable, intent(out) :: values(:)
      type(drive_record) :: record
      integer :: i, n

      call drive(driven, main_path(settings), 1, record)
      n = driven%layout%numbers
      allocate (values(n*record%n))
      do i = 1, record%n
         values(n*(i - 1) + 1:n*i) = record%items(i)%answer%numbers
      end do
   end subroutine drive_outputs

end module asperity_check_trials
