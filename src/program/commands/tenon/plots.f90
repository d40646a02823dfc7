!> Pictures of the tenon joint: what the paper shows in its Figs 25 to 35.
module asperity_program_commands_tenon_plots
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_open, status_slip, status_stick, &
      status_unset
   use asperity_program_commands_joint_loops, only: largest_cycle, legends, loop_joules
   use asperity_program_commands_tenon_compare_models, only: joint_type, last_kept_steps
   use asperity_program_plot_figure, only: as_line, as_line_and_points, as_points, block, box, &
      cross, dashed, disc, figure_type, panel_type, solid
   use asperity_program_plot_palette, only: black, blue, red, sky
   use asperity_program_report_units, only: joule, kilonewton_metre
   use asperity_replay_tenon_points, only: tenon_point
   implicit none
   private
   public :: joint_pictures

   !> Largest number of points of a line, cycles that are called the first
   integer, parameter :: most_points = 4000, first_cycles = 4
   !> Of either model
   integer, parameter :: colours(2) = [blue, red], strokes(2) = [solid, dashed], &
      marks(2) = [box, disc]

contains

   !> All pictures.
   pure function joint_pictures(joints) result(pictures)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      type(figure_type), allocatable :: pictures(:)
      type(panel_type) :: p(11)
      integer, allocatable :: peaks(:)
      integer :: i, j

      p = [panel_type('rotation (rad)', 'moment (kN m)', 'Moment, all cycles'), &
         panel_type('rotation (rad)', 'moment (kN m)', 'Moment, largest loop'), &
         panel_type('rotation (rad)', 'moment (kN m)', 'Skeleton'), &
         panel_type('rotation (rad)', 'stiffness (kN m/rad)', 'Secant stiffness'), &
         panel_type('cycle', 'energy (J)', 'Energy of the loops'), &
         panel_type('cycle', 'energy (J)', 'Dissipation by friction'), &
         panel_type('rotation (rad)', 'normal force (kN)', 'Upper face, largest loop'), &
         panel_type('rotation (rad)', 'normal force (kN)', 'Lower face, largest loop'), &
         panel_type('rotation (rad)', 'pull-out (mm)', 'Pull-out, largest loop'), &
         panel_type('step', 'displacement (mm)', 'Programme'), &
         panel_type('rotation (rad)', 'moment (kN m)', 'Moment, first loops')]
      p([1, 2, 3, 7, 8, 9, 10, 11])%zero_lines = .true.
      p(5:6)%x%whole = .true.
      p(4:6)%y%low = 0.0_wp
      do i = 1, size(joints)
         associate (steps => joints(i)%steps, loops => joints(i)%loops, &
               stride => 1 + ubound(joints(i)%steps, 1)/most_points)
            call draw(p(1), i, as_line, (steps(::stride)%rotation), &
               kilonewton_metre*steps(::stride)%moment)
            j = largest_cycle(loops)
            if (size(loops%cycles) > 0) then
               ! sample 1 is step 0
               associate (s => steps(loops%cycles(max(1, j))%first - 1: &
                     loops%cycles(max(1, j))%last - 1:stride))
                  call draw(p(2), i, as_line, (s%rotation), kilonewton_metre*s%moment)
                  call draw(p(7), i, as_line, (s%rotation), 1.0e-3_wp*s%face_normal(1))
                  call draw(p(8), i, as_line, (s%rotation), 1.0e-3_wp*s%face_normal(2))
                  call draw(p(9), i, as_line, (s%rotation), (s%pull_out))
               end associate
               associate (s => steps(:loops%cycles(min(first_cycles, size(loops%cycles)))%last - 1))
                  call draw(p(11), i, as_line, (s%rotation), kilonewton_metre*s%moment)
               end associate
            end if
            peaks = pack([(j, j=1, size(loops%cycles))], &
               [(any(loops%cycles(j)%peak > 0), j=1, size(loops%cycles))])
            associate (c => loops%cycles(peaks), number => real(peaks, wp))
               call draw(p(4), i, as_points, [(maxval(abs(c(j)%displacement), &
                  mask=c(j)%peak > 0), j=1, size(c))], (c%secant_stiffness))
               call draw(p(5), i, as_line_and_points, number, loop_joules((c%cumulative_energy)))
               call draw(p(6), i, as_line_and_points, number, joule*steps(c%last - 1)%friction)
            end associate
            associate (up => loops%skeleton(1), down => loops%skeleton(2))
               call draw(p(3), i, as_line_and_points, [down%displacement(size(down%force):1:-1), &
                  0.0_wp, up%displacement], [down%force(size(down%force):1:-1), 0.0_wp, up%force])
            end associate
         end associate
      end do
      associate (steps => joints(1)%steps(::1 + ubound(joints(1)%steps, 1)/most_points))
         call p(10)%add(real(steps%step, wp), (steps%displacement), '', black, as_line)
      end associate
      ! one legend, as colours tell the models apart
      do i = 1, size(joints)
         call p(3)%add((joints(i)%loops%skeleton%yield_displacement), &
            (joints(i)%loops%skeleton%yield_force), trim(merge('yield points', '            ', &
            i == 1)), colours(i), as_points, mark=cross)
      end do
      pictures = [ &
         figure_type('Displacement of the load point over the steps of the programme (the '// &
         'paper''s Fig. 22).', p(10:10)), &
         figure_type('Moment of both models over the whole programme (Fig. 25).', &
         p(1:1)), &
         figure_type('The first loop of the largest amplitude (Fig. 26). The joint runs '// &
         'against the friction of its sides while the gap closes that the indented wood has '// &
         'left: that pinches the loop.', p(2:2)), &
         figure_type('The first loops, four at most (Fig. 27).', p(11:11)), &
         figure_type('Peaks of the first cycle of each amplitude; crosses are the yield points '// &
         'of equal energy (Fig. 28).', p(3:3)), &
         figure_type('Secant stiffness of every cycle, mean of both sides (Fig. 29).', p(4:4)), &
         figure_type('Area of all moment-rotation loops up to each cycle (Fig. 30).', p(5:5)), &
         figure_type('Dissipated by friction on all faces up to each cycle (Fig. 35).', p(6:6)), &
         figure_type('Normal force of the upper and of the lower face in the first loop of the '// &
         'largest amplitude (Fig. 34).', p(7:8)), &
         figure_type('Pull-out of the tenon at the column face in the same loop.', p(9:9)), &
         figure_type('Contact along the upper face (pressure drawn upwards) and the lower face '// &
         '(drawn downwards): open, sticking and slipping points (Figs 31 to 33) at two '// &
         'displacements of the load point. The column face is at 0.', state_panels(joints))]
   end function joint_pictures

   !> One line of one model.
   pure subroutine draw(panel, model, form, x, y)
      type(panel_type), intent(inout) :: panel
      integer, intent(in) :: model, form
      real(wp), intent(in) :: x(:), y(:)

      call panel%add(x, y, trim(legends(model)), colours(model), form, strokes(model), &
         marks(model))
   end subroutine draw

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
