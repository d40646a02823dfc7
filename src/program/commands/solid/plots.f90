!> Pictures of a solid joint: what the paper shows in its Figs 23 and 25 to 35.
module asperity_program_commands_solid_plots
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_loops, only: largest_cycle
   use asperity_program_commands_joint_plots, only: draw_model, loop_pictures, rotation_label, &
      whole_cycles
   use asperity_program_commands_solid_maps, only: map_pictures
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_plot_figure, only: as_line, as_line_and_points, figure_type, panel_type
   use asperity_solid_mesh_joint, only: face_bottom, face_top
   implicit none
   private
   public :: solid_pictures

   !> Forces are drawn in kN
   real(wp), parameter :: kilonewton = 1.0e-3_wp

contains

   !> All pictures.
   pure function solid_pictures(outcomes) result(pictures)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(figure_type), allocatable :: pictures(:)
      type(panel_type) :: p(5)
      character(len=:), allocatable :: drift
      integer, allocatable :: peaks(:)
      integer :: i, j

      drift = rotation_label(outcomes)
      p = [panel_type('cycle', 'energy (J)', 'Dissipation by friction'), &
         panel_type(drift, 'normal force (kN)', 'Upper face, largest loop'), &
         panel_type(drift, 'normal force (kN)', 'Lower face, largest loop'), &
         panel_type(drift, 'pull-out (mm)', 'Pull-out, largest loop'), &
         panel_type('cycle', 'energy (J)', 'Dissipation by plastic strain')]
      p(2:4)%zero_lines = .true.
      p([1, 5])%x%whole = .true.
      p([1, 5])%y%low = 0.0_wp
      do i = 1, size(outcomes)
         associate (r => outcomes(i)%records, cycles => outcomes(i)%loops%cycles, &
               model => outcomes(i)%model)
            if (size(cycles) == 0) cycle
            peaks = whole_cycles(outcomes(i))
            ! sample 1 is the joint at rest
            associate (ends => max(1, cycles(peaks)%last - 1))
               call draw_model(p(1), model, as_line_and_points, real(peaks, wp), (r(ends)%friction))
               call draw_model(p(5), model, as_line_and_points, real(peaks, wp), (r(ends)%plastic))
            end associate
            j = max(1, largest_cycle(outcomes(i)%loops))
            associate (s => r(max(1, cycles(j)%first - 1):cycles(j)%last - 1), &
                  arm => outcomes(i)%arm)
               call draw_model(p(2), model, as_line, s%displacement/arm, &
                  kilonewton*s%normal_force(face_top))
               call draw_model(p(3), model, as_line, s%displacement/arm, &
                  kilonewton*s%normal_force(face_bottom))
               call draw_model(p(4), model, as_line, s%displacement/arm, (s%pull_out))
            end associate
         end associate
      end do
      pictures = [ &
         loop_pictures(outcomes), &
         figure_type('Dissipated by friction on all faces up to each cycle (Fig. 35).', p(1:1)), &
         figure_type('Dissipated by plastic strain of the wood up to each cycle.', p(5:5)), &
         figure_type('Normal force of the upper and of the lower face in the first loop of the '// &
         'largest amplitude (Fig. 34).', p(2:3)), &
         figure_type('Pull-out of the tenon at the column face in the same loop.', p(4:4)), &
         map_pictures(outcomes)]
   end function solid_pictures

end module asperity_program_commands_solid_plots
