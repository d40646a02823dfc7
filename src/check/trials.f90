!> The trials of a routine, each of which may run in a process of its own.
module asperity_check_trials
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_check_finding, only: finding_list
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: run_uinter_trial

   !> Names of the trials of UINTER, the first of which only drives the routine along its path
   character(len=*), parameter, public :: uinter_trials(1) = [character(len=13) :: 'drive']

contains

   !> Run one trial and add what it finds.
   subroutine run_uinter_trial(trial, routine, settings, findings)
      !> Place in `uinter_trials`
      integer, intent(in) :: trial
      !> The UINTER
      procedure(uinter_interface) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings

      associate (unused => [trial, settings%nstatv, findings%n])
      end associate
   end subroutine run_uinter_trial

end module asperity_check_trials
