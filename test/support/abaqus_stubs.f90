!> Stubs of ABAQUS' STDB_ABQERR and XIT, and of XPLB_ABQERR and XPLB_EXIT of ABAQUS/Explicit, that
!> record their calls and return, so that a test can look at what UINTER and VUINTER said. They are
!> linked before those of the program.
module abaqus_stubs
   implicit none
   private
   public :: forget_calls, last_level, last_message, messages, warnings, exits

   integer, protected :: messages = 0, warnings = 0, exits = 0, last_level = 0
   character(len=600), protected :: last_message = ''

   public :: remember_message, remember_exit

contains

   subroutine forget_calls()
      messages = 0
      warnings = 0
      exits = 0
      last_level = 0
      last_message = ''
   end subroutine forget_calls

   subroutine remember_message(level, message)
      integer, intent(in) :: level
      character(len=*), intent(in) :: message

      messages = messages + 1
      if (level == -1) warnings = warnings + 1
      last_level = level
      last_message = message
   end subroutine remember_message

   subroutine remember_exit()
      exits = exits + 1
   end subroutine remember_exit

end module abaqus_stubs

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
