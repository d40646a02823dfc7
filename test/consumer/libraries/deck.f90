! The law in rows, linear between them within one per cent
program deck
   use asperity, only: contact_properties, error_type, wp
   use asperity_abaqus_props, only: properties_from_props
   use asperity_deck_law_rows, only: law_table, new_law_table
   implicit none
   real(wp), parameter :: pi = acos(-1.0_wp), &
      props(9) = [0.5_wp, 0.31_wp, 206.0_wp, 297.0_wp, pi, 0.1477_wp, 24.53_wp, 0.4_wp, 0.0593_wp]
   type(contact_properties) :: properties
   type(law_table) :: table
   type(error_type), allocatable :: error

   call properties_from_props(props, properties, error)
   if (allocated(error)) error stop 1
   call new_law_table(table, properties, 4.7_wp, error, tolerance=0.01_wp)
   if (allocated(error)) error stop 2
   if (size(table%pressure) < 4 .or. .not. table%error <= 0.01_wp) error stop 3
   print '(a, i0, a)', 'deck: ', size(table%pressure), ' rows'
end program deck
