!> What is left behind when a computation fails at a contact point: the motion of the point and its
!> properties, with which `asperity replay` leads UINTER the same way.
module asperity_program_commands_replay_failed_point
   use asperity_abaqus_props, only: props_from_properties
   use asperity_base_error, only: computation_error, error_type
   use asperity_base_text_builder, only: growing_text
   use asperity_contact_properties, only: contact_properties
   use asperity_program_report_table, only: full_figures
   use asperity_program_system_atomic_files, only: open_target, output_file, write_files
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: keep_failed_point

   character(len=*), parameter :: case_name = 'failed_point.nml', path_name = 'failed_point.csv'

contains

   !> Write the files into the current folder and say so in the message, if the error is one of
   !> computation. When they cannot be written, the message stays as it is.
   subroutine keep_failed_point(error, path, properties, words)
      !> Why it failed
      type(error_type), intent(inout) :: error
      !> The motion, up to what failed; no rows for none
      type(motion_path), intent(in) :: path
      !> Properties of the point
      type(contact_properties), intent(in) :: properties
      !> What the point is, such as `contact point 12`
      character(len=*), intent(in) :: words
      type(error_type), allocatable :: late_error
      type(output_file) :: files(2)
      type(growing_text) :: rows, case
      integer :: i

      if (error%category /= computation_error .or. .not. allocated(path%time)) return
      call rows%line('time (s),overclosure (mm),slip_1 (mm),slip_2 (mm)')
      do i = 1, size(path%time)
         call rows%line(full_figures(path%time(i))//','//full_figures(path%overclosure(i))//','// &
            full_figures(path%slip(1, i))//','//full_figures(path%slip(2, i)))
      end do
      call case%line('! '//error%message)
      call case%line('&asperity')
      call case%line("  path = '"//path_name//"'")
      call case%line('  properties =')
      associate (props => props_from_properties(properties))
         do i = 1, size(props)
            call case%line('    '//full_figures(props(i)))
         end do
      end associate
      call case%line('/')
      call open_target(files(1), 'failed point', path_name, late_error)
      if (.not. allocated(late_error)) call open_target(files(2), 'failed point', case_name, &
         late_error)
      if (allocated(late_error)) return
      files(1)%text = rows%text()
      files(2)%text = case%text()
      call write_files(files, late_error)
      if (.not. allocated(late_error)) error%message = error%message//'; asperity replay '// &
         case_name//' replays the motion of '//words
   end subroutine keep_failed_point

end module asperity_program_commands_replay_failed_point
