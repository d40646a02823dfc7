!> What the kurtosis of a surface of Table 2 does to the pressure, told where heights are Gaussian.
module asperity_program_commands_faces_heights_remark
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_properties, only: normal_properties
   use asperity_program_commands_faces_heights, only: heights_type
   use asperity_program_report_report, only: report_type
   use asperity_surface_remarks_on_heights, only: add_height_effect
   implicit none
   private
   public :: remark_surface_heights

contains

   !> Add the remark to a report, unless the effect is small. Table 2 has no skewness.
   pure subroutine remark_surface_heights(report, heights, law)
      !> The report
      type(report_type), intent(inout) :: report
      !> Settings of the heights
      type(heights_type), intent(in) :: heights
      !> The law
      type(normal_properties), intent(in) :: law
      character(len=:), allocatable :: text
      real(wp) :: separations(2)
      logical :: is_told

      if (heights%is_johnson .or. .not. allocated(heights%surface)) return
      text = heights%surface//' has a kurtosis of '//to_text(heights%usual_kurtosis)//': '
      call add_height_effect(text, law, 0.0_wp, heights%usual_kurtosis, separations, is_told)
      if (is_told) call report%add_remark(text)
   end subroutine remark_surface_heights

end module asperity_program_commands_faces_heights_remark
