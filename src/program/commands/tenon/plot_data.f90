!> Data of the tenon joint's pictures as data blocks of gnuplot, named after model and content.
module asperity_program_commands_tenon_plot_data
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_slip, status_stick
   use asperity_program_commands_tenon_compare_models, only: joint_type, largest_cycle, &
      loop_joules, model_names
   use asperity_program_report_units, only: joule, kilonewton_metre
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: add_cycles, add_skeleton, add_states, add_steps, state_block, state_steps

   !> Largest number of points of a line
   integer, parameter :: most_points = 4000
   !> Steps whose contact states are shown
   integer, parameter :: most_states = 2

contains

   !> Rotation and moment of all steps; these, normal force of the upper face, kN, and pull-out of
   !> the first loop of the largest amplitude.
   subroutine add_steps(b, joint)
      !> Where to append
      type(text_buffer), intent(inout) :: b
      !> One model
      type(joint_type), intent(in) :: joint
      integer :: i, stride

      stride = 1 + ubound(joint%steps, 1)/most_points
      call start_block(b, joint, 'all')
      do i = 0, ubound(joint%steps, 1), stride
         call b%numbers([joint%steps(i)%rotation, kilonewton_metre*joint%steps(i)%moment])
      end do
      call b%line('EOD')
      call start_block(b, joint, 'loop')
      if (size(joint%loops%cycles) == 0) then
         ! gnuplot refuses a block without any point
         call b%line('NaN NaN NaN NaN')
         call b%line('EOD')
         return
      end if
      associate (cycle => joint%loops%cycles(max(1, largest_cycle(joint%loops))))
         ! sample 1 is step 0
         do i = cycle%first - 1, cycle%last - 1, stride
            associate (s => joint%steps(i))
               call b%numbers([s%rotation, kilonewton_metre*s%moment, &
                  1.0e-3_wp*s%face_normal(1), s%pull_out])
            end associate
         end do
      end associate
      call b%line('EOD')
   end subroutine add_steps

   !> The skeleton from its negative to its positive end, and its yield points.
   subroutine add_skeleton(b, joint)
      !> Where to append
      type(text_buffer), intent(inout) :: b
      !> One model
      type(joint_type), intent(in) :: joint
      integer :: i

      call start_block(b, joint, 'skeleton')
      associate (up => joint%loops%skeleton(1), down => joint%loops%skeleton(2))
         do i = size(down%force), 1, -1
            call b%numbers([down%displacement(i), down%force(i)])
         end do
         call b%numbers([0.0_wp, 0.0_wp])
         do i = 1, size(up%force)
            call b%numbers([up%displacement(i), up%force(i)])
         end do
      end associate
      call b%line('EOD')
      call start_block(b, joint, 'yield')
      do i = 1, 2
         associate (skeleton => joint%loops%skeleton(i))
            if (.not. is_none(skeleton%yield_force)) &
               call b%numbers([skeleton%yield_displacement, skeleton%yield_force])
         end associate
      end do
      ! gnuplot refuses a block without any point
      call b%line('NaN NaN')
      call b%line('EOD')
   end subroutine add_skeleton

   !> Of every cycle: rotation, number, secant stiffness, energy of all loops and frictional
   !> dissipation of all faces until its end.
   subroutine add_cycles(b, joint)
      !> Where to append
      type(text_buffer), intent(inout) :: b
      !> One model
      type(joint_type), intent(in) :: joint
      integer :: i

      call start_block(b, joint, 'cycles')
      do i = 1, size(joint%loops%cycles)
         associate (cycle => joint%loops%cycles(i))
            if (all(cycle%peak == 0)) cycle
            call b%numbers([maxval(abs(cycle%displacement), mask=cycle%peak > 0), real(i, wp), &
               cycle%secant_stiffness, loop_joules(cycle%cumulative_energy), &
               joule*joint%steps(cycle%last - 1)%friction])
         end associate
      end do
      call b%line('NaN NaN NaN NaN NaN')
      call b%line('EOD')
   end subroutine add_cycles

   !> Place, pressure (of the lower face negative) and state (1 open, 2 stick, 3 slip) of the
   !> points of the upper and the lower face.
   subroutine add_states(b, joint)
      !> Where to append
      type(text_buffer), intent(inout) :: b
      !> One model
      type(joint_type), intent(in) :: joint
      integer, allocatable :: steps(:)
      integer :: i, j, state

      call state_steps(joint, steps)
      do j = 1, size(steps)
         call b%line(state_block(joint%model, j)//' << EOD')
         do i = 1, size(joint%points)
            associate (p => joint%points(i))
               if (p%step /= steps(j) .or. p%face > 2) cycle
               state = 1
               if (p%status == status_stick) state = 2
               if (p%status == status_slip) state = 3
               call b%numbers([p%x, merge(p%pressure, -p%pressure, p%face == 1), &
                  real(state, wp)])
            end associate
         end do
         call b%line('NaN NaN NaN')
         call b%line('EOD')
      end do
   end subroutine add_states

   !> Steps whose contact states are shown: the last of those kept.
   subroutine state_steps(joint, steps)
      !> One model
      type(joint_type), intent(in) :: joint
      !> The steps
      integer, allocatable, intent(out) :: steps(:)
      integer :: i

      allocate (steps(0))
      do i = size(joint%points), 1, -1
         if (size(steps) == most_states) exit
         if (any(steps == joint%points(i)%step)) cycle
         steps = [joint%points(i)%step, steps]
      end do
   end subroutine state_steps

   !> Name of a block of contact states.
   pure function state_block(model, which) result(name)
      !> Model, and place of the step among those shown
      integer, intent(in) :: model, which
      character(len=:), allocatable :: name

      name = '$'//trim(model_names(model))//'_state_'//to_text(which)
   end function state_block

   subroutine start_block(b, joint, what)
      type(text_buffer), intent(inout) :: b
      type(joint_type), intent(in) :: joint
      character(len=*), intent(in) :: what

      call b%line('$'//trim(model_names(joint%model))//'_'//what//' << EOD')
   end subroutine start_block

end module asperity_program_commands_tenon_plot_data
