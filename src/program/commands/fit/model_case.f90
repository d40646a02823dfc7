!> The case file that fixes keys of a model.
module asperity_program_commands_fit_model_case
   use asperity_base_error, only: error_type
   use asperity_program_commands_curve, only: curve_command
   use asperity_program_commands_press, only: press_command
   use asperity_program_commands_shear, only: shear_command
   use asperity_program_commands_table_command, only: table_command
   use asperity_program_commands_tenon_command, only: tenon_command
   use asperity_program_input_case_file, only: read_case
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: read_model

contains

   !> Read it. It may have keys of other commands.
   subroutine read_model(path, keys, error)
      !> Path of the file, empty for none
      character(len=*), intent(in) :: path
      !> Keys of the model; those that no option gives take the values of the file
      type(key_list), intent(inout) :: keys
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      type(key_list) :: known
      type(curve_command) :: curve
      type(press_command) :: press
      type(shear_command) :: shear
      type(tenon_command) :: tenon
      type(table_command) :: table
      integer :: i

      if (path == '') return
      call curve%declare(known)
      call press%declare(known)
      call shear%declare(known)
      call tenon%declare(known)
      call table%declare(known)
      do i = 1, keys%n
         if (known%find(trim(keys%rows(i)%name)) > 0) cycle
         call known%declare(trim(keys%rows(i)%name), keys%rows(i)%kind, '', '', '')
      end do
      keys%case_path = path
      call read_case(keys, known, error)
   end subroutine read_model

end module asperity_program_commands_fit_model_case
