!> One summit pressed flat (the paper's Fig. 5): force, real area and mean pressure over its
!> deformation, through the elastic, the elasto-plastic and the plastic stage.
program summit
   use asperity, only: asperity_response, error_type, evaluate_asperity, find_pair, &
      new_normal_properties, normal_properties, pair_preset, wp
   implicit none
   type(pair_preset) :: pair
   type(normal_properties) :: properties
   type(asperity_response) :: response
   type(error_type), allocatable :: error
   integer, parameter :: rows = 121
   !> From a tenth of w1 to ten times w2, deformations over w1
   real(wp), parameter :: first = 0.1_wp, last = 1100.0_wp
   character(len=14), parameter :: stages(0:3) = [character(len=14) :: &
      'open', 'elastic', 'elasto-plastic', 'plastic']
   real(wp) :: deformation
   integer :: i

   call find_pair('transverse-tangential', pair, error)
   if (.not. allocated(error)) call new_normal_properties(properties, pair, error)
   if (allocated(error)) error stop error%message
   print '(2(a, es10.3), a)', '# w1 = ', properties%w1, ' mm, w2 = ', properties%w2, ' mm'
   print '(a, 3f8.4)', '# exponents of mean pressure, area and force:', properties%b1, &
      properties%b2, properties%b3
   print '(a)', 'deformation (mm),force (N),area (mm^2),mean_pressure (MPa),stage'
   do i = 1, rows
      deformation = first*properties%w1*(last/first)**(real(i - 1, wp)/real(rows - 1, wp))
      response = evaluate_asperity(properties, deformation)
      print '(4(es13.6, ","), a)', deformation, response%force, response%area, &
         response%mean_pressure, trim(stages(response%stage))
   end do
end program summit
