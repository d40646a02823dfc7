!> Pictures of the tenon joint: what the paper shows in its Figs 25 to 35.
module asperity_program_commands_tenon_plots
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_open, status_slip, status_stick, &
      status_unset
   use asperity_program_commands_joint_loops, only: largest_cycle, legends
   use asperity_program_commands_joint_plots, only: draw_model, loop_pictures, most_points, &
      whole_cycles
   use asperity_program_commands_tenon_compare_models, only: joint_type, last_kept_steps
   use asperity_program_plot_figure, only: as_line, as_line_and_points, as_points, block, disc, &
      figure_type, panel_type
   use asperity_program_plot_palette, only: black, red, sky
   use asperity_program_report_units, only: joule
   use asperity_replay_tenon_points, only: tenon_point
   implicit none
   private
   public :: joint_pictures

contains

   !> All pictures.
   pure function joint_pictures(joints) result(pictures)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      type(figure_type), allocatable :: pictures(:)
      type(panel_type) :: p(5)
      integer, allocatable :: peaks(:)
      integer :: i, j

      p = [panel_type('step', 'displacement (mm)', 'Programme'), &
         panel_type('cycle', 'energy (J)', 'Dissipation by friction'), &
         panel_type('rotation (rad)', 'normal force (kN)', 'Upper face, largest loop'), &
         panel_type('rotation (rad)', 'normal force (kN)', 'Lower face, largest loop'), &
         panel_type('rotation (rad)', 'pull-out (mm)', 'Pull-out, largest loop')]
      p([1, 3, 4, 5])%zero_lines = .true.
      p(2)%x%whole = .true.
      p(2)%y%low = 0.0_wp
      associate (steps => joints(1)%steps(::1 + ubound(joints(1)%steps, 1)/most_points))
         call p(1)%add(real(steps%step, wp), (steps%displacement), '', black, as_line)
      end associate
      do i = 1, size(joints)
         associate (steps => joints(i)%steps, cycles => joints(i)%loops%cycles, &
               model => joints(i)%model, stride => 1 + ubound(joints(i)%steps, 1)/most_points)
            if (size(cycles) == 0) cycle
            j = max(1, largest_cycle(joints(i)%loops))
            ! sample 1 is step 0
            associate (s => steps(cycles(j)%first - 1:cycles(j)%last - 1:stride))
               call draw_model(p(3), model, as_line, (s%rotation), 1.0e-3_wp*s%face_normal(1))
               call draw_model(p(4), model, as_line, (s%rotation), 1.0e-3_wp*s%face_normal(2))
               call draw_model(p(5), model, as_line, (s%rotation), (s%pull_out))
            end associate
            peaks = whole_cycles(joints(i))
            call draw_model(p(2), model, as_line_and_points, real(peaks, wp), &
               joule*steps(cycles(peaks)%last - 1)%friction)
         end associate
      end do
      pictures = [ &
         figure_type('Displacement of the load point over the steps of the programme (the '// &
         'paper''s Fig. 22).', p(1:1)), &
         loop_pictures(joints), &
         figure_type('Dissipated by friction on all faces up to each cycle (Fig. 35).', p(2:2)), &
         figure_type('Normal force of the upper and of the lower face in the first loop of the '// &
         'largest amplitude (Fig. 34).', p(3:4)), &
         figure_type('Pull-out of the tenon at the column face in the same loop.', p(5:5)), &
         figure_type('Contact along the upper face (pressure drawn upwards) and the lower face '// &
         '(drawn downwards): open, sticking and slipping points (Figs 31 to 33) at two '// &
         'displacements of the load point. The column face is at 0.', state_panels(joints))]
   end function joint_pictures

   !> Open, sticking and slipping points along the upper and the lower face, both models side by
   !> side.
   pure function state_panels(joints) result(panels)
      type(joint_type), intent(in) :: joints(:)
      type(panel_type), allocatable :: panels(:)
      integer, allocatable :: steps(:)
      integer :: i, j

      allocate (steps, source=last_kept_steps(joints(1)))
      allocate (panels(size(steps)*size(joints)))
      do j = 1, size(steps)
         do i = 1, size(joints)
            associate (panel => panels(size(joints)*(j - 1) + i), points => joints(i)%points)
               panel = panel_type('place in the tenon (mm)', 'lower | upper face (MPa)', &
                  trim(legends(i))//', load point at '// &
                  to_text(joints(i)%steps(steps(j))%displacement, 4)//' mm')
               panel%zero_lines = .true.
               call draw_state(panel, points, steps(j), [status_unset, status_open], 'open', &
                  sky, disc)
               call draw_state(panel, points, steps(j), [status_stick], 'stick', black, disc)
               call draw_state(panel, points, steps(j), [status_slip], 'slip', red, block)
            end associate
         end do
      end do
   end function state_panels

   !> Pressure, of the lower face negative, of the points in some states.
   pure subroutine draw_state(panel, points, step, states, legend, colour, mark)
      type(panel_type), intent(inout) :: panel
      type(tenon_point), intent(in) :: points(:)
      integer, intent(in) :: step, states(:), colour, mark
      character(len=*), intent(in) :: legend
      integer, allocatable :: which(:)
      integer :: i

      which = pack([(i, i=1, size(points))], [(points(i)%step == step .and. points(i)%face <= 2 &
         .and. any(points(i)%status == states), i=1, size(points))])
      call panel%add(points(which)%x, merge(points(which)%pressure, -points(which)%pressure, &
         points(which)%face == 1), legend, colour, as_points, mark=mark)
   end subroutine draw_state

end module asperity_program_commands_tenon_plots
