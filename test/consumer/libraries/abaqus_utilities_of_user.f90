! What a user may bring in place of the utilities that come with the joint
subroutine stdb_abqerr(lop, string, intv, realv, charv)
   use asperity, only: wp
   implicit none
   integer, intent(in) :: lop
   character(len=*), intent(in) :: string
   integer, intent(in) :: intv(*)
   real(wp), intent(in) :: realv(*)
   character(len=8), intent(in) :: charv(*)

   print '(a, i0, 2a)', 'own utility, level ', lop, ': ', string
   associate (unused => intv(1), unused_real => realv(1), unused_name => charv(1))
   end associate
end subroutine stdb_abqerr

subroutine xit()
   implicit none

   stop 9
end subroutine xit
