! A loop through (0, 1), (1, 3), (0, -1), (-1, -3): a parallelogram of area 2
program hysteresis
   use asperity, only: error_type, wp
   use asperity_hysteresis_analysis, only: analyse_hysteresis, hysteresis_result
   implicit none
   real(wp), parameter :: displacement(9) = [0.0_wp, 1.0_wp, 0.0_wp, -1.0_wp, 0.0_wp, 1.0_wp, &
      0.0_wp, -1.0_wp, 0.0_wp], &
      force(9) = [1.0_wp, 3.0_wp, -1.0_wp, -3.0_wp, 1.0_wp, 3.0_wp, -1.0_wp, -3.0_wp, 1.0_wp]
   type(hysteresis_result) :: result
   type(error_type), allocatable :: error

   call analyse_hysteresis(displacement, force, result, error)
   if (allocated(error)) error stop 1
   if (size(result%cycles) /= 2) error stop 2
   if (abs(result%cycles(2)%loop_area - 2.0_wp) > 1.0e-12_wp) error stop 3
   print '(a)', 'hysteresis: two loops of area 2'
end program hysteresis
