program consumer
   use asperity, only: equivalent_modulus, wp
   implicit none
   ! Two equal faces with nu = 0: half the modulus
   if (abs(equivalent_modulus(8.0_wp, 0.0_wp, 8.0_wp, 0.0_wp) - 4.0_wp) > 1.0e-14_wp) error stop 1
   print '(a)', 'consumer: asperity answers'
end program consumer
