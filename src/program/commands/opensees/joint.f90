!> `--opensees FILE` of a joint: a rotational spring that follows moment against rotation.
module asperity_program_commands_opensees_joint
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_commands_joint_loops, only: joint_loops, legends
   use asperity_program_commands_opensees_output, only: opensees_output
   use asperity_program_report_report, only: report_type
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: add_joint_material, check_history

contains

   !> Set `error` if a material is asked for and the history goes to one side only, before a joint
   !> is followed along it.
   pure subroutine check_history(output, joint, error)
      !> The output
      type(opensees_output), intent(in) :: output
      !> The joint; a programme of amplitudes goes to both sides
      type(tenon_settings), intent(in) :: joint
      !> Set then
      type(error_type), allocatable, intent(inout) :: error

      if (.not. output%is_asked() .or. .not. allocated(joint%displacement)) return
      if (minval(joint%displacement) < 0.0_wp .and. maxval(joint%displacement) > 0.0_wp) return
      call fatal_error(error, 'a material with loops takes cycles to both sides, and the '// &
         'history goes to one', subject='opensees')
   end subroutine check_history

   !> Fit the loops of the last model, which is the rough law where both were asked for.
   subroutine add_joint_material(output, report, joints, error)
      !> The output; nothing is done unless it is asked for
      type(opensees_output), intent(inout) :: output
      !> The report, with its other tables
      type(report_type), intent(inout) :: report
      !> The models
      class(joint_loops), intent(in) :: joints(:)
      !> Set when no material follows the loops
      type(error_type), allocatable, intent(out) :: error
      type(record_labels) :: labels

      if (.not. output%is_asked()) return
      labels%x = 'rotation'
      labels%x_unit = 'rad'
      labels%f = 'moment'
      labels%f_unit = 'kN m'
      associate (joint => joints(size(joints)))
         call output%add_to(report, joint%rotation, joint%moment, joint%loops, labels, &
            'asperity '//trim(report%name)//', '//trim(legends(joint%model)), error)
      end associate
   end subroutine add_joint_material

end module asperity_program_commands_opensees_joint
