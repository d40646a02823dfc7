!> The two ABAQUS utilities that UINTER calls, for programs that play ABAQUS: errors go to standard
!> error without the interaction and node, which are the host's own, and XIT ends the program.
!> Warnings are of validity flags, which every result of the replays has, row by row: not printed.
!> A caller that links its own is served first.
subroutine stdb_abqerr(lop, string, intv, realv, charv)
   use, intrinsic :: iso_fortran_env, only: error_unit
   use asperity_base_kinds, only: wp
   implicit none
   !> 1 information, -1 warning, -2 error, -3 error and stop
   integer, intent(in) :: lop
   !> Message; UINTER uses no placeholders
   character(len=*), intent(in) :: string
   !> Values of the placeholders %I, %R, %S: unused
   integer, intent(in) :: intv(*)
   real(wp), intent(in) :: realv(*)
   character(len=8), intent(in) :: charv(*)

   associate (unused => [real(intv(1), wp), realv(1)], unused_name => charv(1))
   end associate
   if (lop >= -1) return
   write (error_unit, '(2a)') 'asperity: error: ', string(index(string, ': ') + 2:)
end subroutine stdb_abqerr

!> End the program with status 1.
subroutine xit()
   implicit none

   stop 1, quiet=.true.
end subroutine xit
