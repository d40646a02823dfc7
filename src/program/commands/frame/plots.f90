!> Pictures of a frame: base shear over sway, moments of its joints.
module asperity_program_commands_frame_plots
   use asperity_base_kinds, only: wp
   use asperity_program_commands_frame_outcome, only: frame_outcome, joint_name
   use asperity_program_commands_joint_loops, only: legends
   use asperity_program_commands_joint_plots, only: draw_model
   use asperity_program_plot_figure, only: as_line, figure_type, panel_type
   use asperity_program_plot_palette, only: palette
   use asperity_program_report_units, only: kilonewton_metre
   implicit none
   private
   public :: frame_pictures

contains

   !> All pictures.
   pure function frame_pictures(outcomes) result(pictures)
      !> The models
      type(frame_outcome), intent(in) :: outcomes(:)
      type(figure_type), allocatable :: pictures(:)
      type(panel_type) :: p(2)
      integer :: i

      associate (last => outcomes(size(outcomes)))
         p = [panel_type('sway (mm)', 'base shear (kN)', 'Base shear'), &
            panel_type('rotation (rad)', 'moment (kN m)', 'Joints, '// &
            trim(legends(last%whole%model)))]
         p%zero_lines = .true.
         do i = 1, size(outcomes)
            associate (r => outcomes(i)%whole%records)
               call draw_model(p(1), outcomes(i)%whole%model, as_line, (r%displacement), &
                  1.0e-3_wp*r%force)
            end associate
         end do
         do i = 1, size(last%joints, 1)
            call p(2)%add((last%joints(i, :)%rotation), kilonewton_metre*last%joints(i, :)%moment, &
               joint_name(last, i), 1 + modulo(i - 1, size(palette)), as_line)
         end do
      end associate
      pictures = [figure_type('Base shear over the sway of the heads.', p(1:1)), &
         figure_type('Moment of each joint over its rotation, by the last model.', p(2:2))]
   end function frame_pictures

end module asperity_program_commands_frame_plots
