! Press a point through UINTER: the ramp's top is the pressure asked for
program joint
   use asperity, only: contact_properties, error_type, wp
   use asperity_abaqus_props, only: properties_from_props
   use asperity_replay_press, only: press_loop, press_settings, press_step, run_press
   implicit none
   real(wp), parameter :: pi = acos(-1.0_wp), &
      props(9) = [0.5_wp, 0.31_wp, 206.0_wp, 297.0_wp, pi, 0.1477_wp, 24.53_wp, 0.4_wp, 0.0593_wp]
   type(contact_properties) :: properties
   type(press_step), allocatable :: steps(:)
   type(press_loop), allocatable :: loops(:)
   type(error_type), allocatable :: error

   call properties_from_props(props, properties, error)
   if (allocated(error)) error stop 1
   call run_press(press_settings(peak=[1.25_wp], increments=4), properties, steps, loops, error)
   if (allocated(error)) error stop 2
   if (size(steps) /= 9 .or. abs(steps(5)%pressure - 1.25_wp) > 1.0e-10_wp) error stop 3
   print '(a)', 'joint: pressed to 1.25 MPa'
end program joint
