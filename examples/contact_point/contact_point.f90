!> Press a wood face to 0.2 MPa and slide it: one contact point, as a finite-element code calls it.
program contact_point
   use asperity, only: contact_properties, contact_response, contact_state, error_type, find_pair, &
      new_contact_properties, no_rotation, pair_preset, separation_for_pressure, status_text, &
      update_contact_point, wp
   implicit none
   type(pair_preset) :: pair
   type(contact_properties) :: properties
   type(contact_state) :: state
   type(contact_response) :: point
   type(error_type), allocatable :: error
   real(wp) :: separation, overclosure
   integer :: i

   call find_pair('transverse-tangential', pair, error)
   if (.not. allocated(error)) call new_contact_properties(properties, pair, error)
   if (.not. allocated(error)) &
      call separation_for_pressure(properties%normal, 0.2_wp, separation, error)
   if (allocated(error)) error stop error%message

   overclosure = properties%initial_separation - separation
   print '(a, f8.5, a)', 'overclosure ', overclosure, ' mm'
   do i = 1, 4
      call update_contact_point(properties, state, overclosure, [0.12_wp, 0.0_wp], no_rotation, &
         point)
      state = point%state
      print '(f5.2, a, 2f8.4, 3a, f7.3, a)', 0.12_wp*i, ' mm: p, tau =', point%traction(:2), &
         ' MPa, ', status_text(point%status), ', stiffness', point%tangent(1, 1), ' MPa/mm'
   end do
end program contact_point
