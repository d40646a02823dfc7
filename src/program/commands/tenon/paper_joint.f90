!> What makes a joint the paper's.
module asperity_program_commands_tenon_paper_joint
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_input_command_line, only: command_line_type
   use asperity_program_input_keys, only: command_tenon, find_key
   use asperity_program_input_resolve, only: settled
   use asperity_program_input_settings, only: default_settings, settings_type
   implicit none
   private
   public :: is_paper_joint, usual_settings

   !> What makes a joint the paper's: sizes and programme at their defaults, which are those of
   !> examples/tenon_joint/base.nml. Faces, wood and how it is held may differ, to compare them
   character(len=*), parameter :: sizes(*) = [character(len=16) :: 'length', 'height', 'width', &
      'clearance_above', 'clearance_below', 'arm', 'amplitudes', 'cycles']

contains

   !> Whether a joint is that of the paper.
   pure logical function is_paper_joint(settings)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      type(settings_type) :: usual
      integer :: i

      usual = usual_settings()
      is_paper_joint = settings%text_of('history') == '' &
         .and. .not. settings%switch_of('shoulders') &
         .and. settings%text_of('arm_datum') == usual%text_of('arm_datum')
      do i = 1, size(sizes)
         if (.not. is_paper_joint) return
         associate (own => settings%of(find_key(trim(sizes(i)))), &
               its => usual%of(find_key(trim(sizes(i)))))
            is_paper_joint = size(own%values) == size(its%values)
            if (is_paper_joint) is_paper_joint = .not. any(abs(own%values - its%values) > 0.0_wp)
         end associate
      end do
   end function is_paper_joint

   !> Settings of a run without any input.
   pure function usual_settings() result(settings)
      type(settings_type) :: settings
      type(command_line_type) :: line
      type(error_type), allocatable :: error

      line%command = command_tenon
      call settled(default_settings(), line, settings, error)
   end function usual_settings

end module asperity_program_commands_tenon_paper_joint
