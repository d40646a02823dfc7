!> Keys of the shear test that its replay and its deck have in common.
module asperity_program_commands_shear_keys
   use asperity_base_kinds, only: wp
   use asperity_paper_shear_test, only: disc_normal_stress
   use asperity_program_input_key_list, only: key_list
   use asperity_replay_shear_settings, only: default_displacement, shear_settings
   implicit none
   private
   public :: declare_shear

   !> Normal stresses of the paper's test, MPa
   real(wp), parameter :: stresses(3) = [disc_normal_stress, 0.1_wp, 0.2_wp]

contains

   !> Declare specimen and path.
   pure subroutine declare_shear(box, normal_stress, keys, has_stress)
      !> Specimen and path
      type(shear_settings), intent(inout) :: box
      !> Normal stresses, MPa
      real(wp), allocatable, intent(inout) :: normal_stress(:)
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether normal stresses are given
      logical, intent(out), optional :: has_stress

      call keys%switch('accept_sizes', box%accept_sizes, &
         'let sizes and pressures pass that look like another unit')
      call keys%real('diameter', box%diameter, 'mm', 'diameter of the two discs')
      if (.not. allocated(normal_stress)) normal_stress = stresses
      call keys%list('normal_stress', normal_stress, 'MPa', &
         'normal stresses on the full disc, one run each')
      if (present(has_stress)) has_stress = keys%given()
      call keys%real('rate', box%rate, 'mm/min', 'speed of the lower box')
      if (.not. allocated(box%displacement)) box%displacement = [default_displacement]
      call keys%list('displacement', box%displacement, 'mm', &
         'turning points of the lower box, such as 3,-3,3')
      call keys%real('displacement_increment', box%displacement_increment, 'mm', &
         'largest displacement in one increment')
   end subroutine declare_shear

end module asperity_program_commands_shear_keys
