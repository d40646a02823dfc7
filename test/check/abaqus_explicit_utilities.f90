!> ABAQUS/Explicit's XPLB_ABQERR and XPLB_EXIT, which VUINTER calls: a warning is nothing, an error
!> ends the tests.
subroutine xplb_abqerr(lop, string, intv, realv, charv)
   use, intrinsic :: iso_fortran_env, only: error_unit
   use asperity_abaqus_vuinter_precision, only: vp
   implicit none
   integer, intent(in) :: lop
   character(len=*), intent(in) :: string
   integer, intent(in) :: intv(*)
   real(vp), intent(in) :: realv(*)
   character(len=8), intent(in) :: charv(*)

   associate (unused => [real(intv(1), vp), realv(1)], unused_name => charv(1))
   end associate
   if (lop < -1) write (error_unit, '(a)') string
end subroutine xplb_abqerr

subroutine xplb_exit()
   implicit none

   stop 1, quiet=.true.
end subroutine xplb_exit
