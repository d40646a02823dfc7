!> Pictures of a tenon joint that follow from its loops (the paper's Figs 25 to 30). There may be
!> one model or both.
module asperity_program_commands_joint_plots
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_loops, only: joint_loops, largest_cycle, legends, loop_joules
   use asperity_program_plot_figure, only: as_line, as_line_and_points, as_points, box, cross, &
      dashed, disc, figure_type, panel_type, solid
   use asperity_program_plot_palette, only: blue, red
   implicit none
   private
   public :: loop_pictures, draw_model, rotation_label, whole_cycles

   !> Cycles that are called the first
   integer, parameter :: first_cycles = 4
   !> Largest number of points of a line
   integer, parameter, public :: most_points = 4000
   !> Of either model
   integer, parameter :: colours(2) = [blue, red], strokes(2) = [solid, dashed], &
      marks(2) = [box, disc]

contains

   !> Moment over all, over the largest loop and the first loops, skeleton, stiffness, energy.
   pure function loop_pictures(joints) result(pictures)
      !> The models
      class(joint_loops), intent(in) :: joints(:)
      type(figure_type), allocatable :: pictures(:)
      type(panel_type) :: p(6)
      character(len=:), allocatable :: rotation
      integer, allocatable :: peaks(:)
      integer :: i, j

      rotation = rotation_label(joints)
      p = [panel_type(rotation, 'moment (kN m)', 'Moment, all cycles'), &
         panel_type(rotation, 'moment (kN m)', 'Moment, largest loop'), &
         panel_type(rotation, 'moment (kN m)', 'Moment, first loops'), &
         panel_type(rotation, 'moment (kN m)', 'Skeleton'), &
         panel_type(rotation, 'stiffness (kN m/rad)', 'Secant stiffness'), &
         panel_type('cycle', 'energy (J)', 'Energy of the loops')]
      p(:4)%zero_lines = .true.
      p(5:6)%y%low = 0.0_wp
      p(6)%x%whole = .true.
      do i = 1, size(joints)
         associate (loops => joints(i)%loops)
            call draw_moment(p(1), joints(i), 1, size(joints(i)%moment))
            j = max(1, largest_cycle(loops))
            if (size(loops%cycles) > 0) then
               call draw_moment(p(2), joints(i), loops%cycles(j)%first, loops%cycles(j)%last)
               call draw_moment(p(3), joints(i), 1, &
                  loops%cycles(min(first_cycles, size(loops%cycles)))%last)
            end if
            associate (up => loops%skeleton(1), down => loops%skeleton(2))
               call draw_model(p(4), joints(i)%model, as_line_and_points, &
                  [down%displacement(size(down%force):1:-1), 0.0_wp, up%displacement], &
                  [down%force(size(down%force):1:-1), 0.0_wp, up%force])
            end associate
            allocate (peaks, source=whole_cycles(joints(i)))
            associate (c => loops%cycles(peaks))
               call draw_model(p(5), joints(i)%model, as_points, [(maxval(abs(c(j)%displacement), &
                  mask=c(j)%peak > 0), j=1, size(c))], (c%secant_stiffness))
               call draw_model(p(6), joints(i)%model, as_line_and_points, &
                  real(peaks, wp), loop_joules((c%cumulative_energy)))
            end associate
            deallocate (peaks)
         end associate
      end do
      ! one legend, as colours tell the models apart
      do i = 1, size(joints)
         call p(4)%add((joints(i)%loops%skeleton%yield_displacement), &
            (joints(i)%loops%skeleton%yield_force), trim(merge('yield points', '            ', &
            i == 1)), colours(joints(i)%model), as_points, mark=cross)
      end do
      pictures = [ &
         figure_type('Moment over the whole programme (Fig. 25).', p(1:1)), &
         figure_type('The first loop of the largest amplitude (Fig. 26). The joint runs '// &
         'against the friction of its sides while the gap closes that the indented wood has '// &
         'left: that pinches the loop.', p(2:2)), &
         figure_type('The first loops, four at most (Fig. 27).', p(3:3)), &
         figure_type('Peaks of the first cycle of each amplitude; crosses are the yield points '// &
         'of equal energy (Fig. 28).', p(4:4)), &
         figure_type('Secant stiffness of every cycle, mean of both sides (Fig. 29).', p(5:5)), &
         figure_type('Area of all loops of moment up to each cycle (Fig. 30).', p(6:6))]
   end function loop_pictures

   !> Label of the axis of rotation.
   pure function rotation_label(joints) result(label)
      !> The models
      class(joint_loops), intent(in) :: joints(:)
      character(len=:), allocatable :: label

      label = trim(joints(1)%rotation_name)//' (rad)'
   end function rotation_label

   !> Cycles with a peak.
   pure function whole_cycles(joint) result(peaks)
      !> The joint
      class(joint_loops), intent(in) :: joint
      integer, allocatable :: peaks(:)
      integer :: i

      associate (c => joint%loops%cycles)
         peaks = pack([(i, i=1, size(c))], [(any(c(i)%peak > 0), i=1, size(c))])
      end associate
   end function whole_cycles

   !> Moment of some samples.
   pure subroutine draw_moment(panel, joint, first, last)
      type(panel_type), intent(inout) :: panel
      class(joint_loops), intent(in) :: joint
      integer, intent(in) :: first, last

      associate (stride => 1 + size(joint%moment)/most_points)
         call draw_model(panel, joint%model, as_line, joint%rotation(first:last:stride), &
            joint%moment(first:last:stride))
      end associate
   end subroutine draw_moment

   !> One line of one model.
   pure subroutine draw_model(panel, model, form, x, y)
      !> Where to draw
      type(panel_type), intent(inout) :: panel
      !> `hard` or `rough`, and how
      integer, intent(in) :: model, form
      !> Coordinates
      real(wp), intent(in) :: x(:), y(:)

      call panel%add(x, y, trim(legends(model)), colours(model), form, strokes(model), &
         marks(model))
   end subroutine draw_model

end module asperity_program_commands_joint_plots
