!> ABAQUS' STDB_ABQERR and XIT, and XPLB_ABQERR and XPLB_EXIT of ABAQUS/Explicit, that record their
!> calls and return, so that a test can look at what UINTER and VUINTER said. No library has them: a
!> program that holds them uses them in place of those that come with the joint.
subroutine stdb_abqerr(lop, string, intv, realv, charv)
   use abaqus_stubs, only: remember_message
   use asperity_base_kinds, only: wp
   implicit none
   integer, intent(in) :: lop
   character(len=*), intent(in) :: string
   integer, intent(in) :: intv(*)
   real(wp), intent(in) :: realv(*)
   character(len=8), intent(in) :: charv(*)

   associate (unused => [real(intv(1), wp), realv(1)], unused_name => charv(1))
   end associate
   call remember_message(lop, string)
end subroutine stdb_abqerr

subroutine xit()
   use abaqus_stubs, only: remember_exit
   implicit none

   call remember_exit()
end subroutine xit

subroutine xplb_abqerr(lop, string, intv, realv, charv)
   use abaqus_stubs, only: remember_message
   use asperity_abaqus_vuinter_precision, only: vp
   implicit none
   integer, intent(in) :: lop
   character(len=*), intent(in) :: string
   integer, intent(in) :: intv(*)
   real(vp), intent(in) :: realv(*)
   character(len=8), intent(in) :: charv(*)

   associate (unused => [real(intv(1), vp), realv(1)], unused_name => charv(1))
   end associate
   call remember_message(lop, string)
end subroutine xplb_abqerr

subroutine xplb_exit()
   use abaqus_stubs, only: remember_exit
   implicit none

   call remember_exit()
end subroutine xplb_exit
