!> The ABAQUS utilities that a UINTER may call.

!> Print a message with its placeholders %I, %R and %S filled in.
subroutine stdb_abqerr(lop, string, intv, realv, charv)
   use asperity_kinds, only: wp
   implicit none
   !> 1 information, -1 warning, -2 error, -3 error that ends the job
   integer, intent(in) :: lop
   !> The message
   character(len=*), intent(in) :: string
   !> What %I, %R and %S stand for, in their order
   integer, intent(in) :: intv(*)
   real(wp), intent(in) :: realv(*)
   character(len=8), intent(in) :: charv(*)
   character(len=:), allocatable :: message
   character(len=24) :: value
   integer :: i, used(3)

   used = 0
   message = ''
   i = 1
   do while (i <= len_trim(string))
      select case (string(i:min(i + 1, len(string))))
      case ('%I')
         used(1) = used(1) + 1
         write (value, '(i0)') intv(used(1))
         message = message//trim(value)
         i = i + 2
      case ('%R')
         used(2) = used(2) + 1
         write (value, '(es15.7)') realv(used(2))
         message = message//trim(adjustl(value))
         i = i + 2
      case ('%S')
         used(3) = used(3) + 1
         message = message//trim(charv(used(3)))
         i = i + 2
      case default
         message = message//string(i:i)
         i = i + 1
      end select
   end do
   select case (lop)
   case (1)
      write (*, '(2a)') ' *INFO: ', message
   case (-1)
      write (*, '(2a)') ' *WARNING: ', message
   case default
      write (*, '(2a)') ' *ERROR: ', message
   end select
   if (lop == -3) call xit()
end subroutine stdb_abqerr

!> End the job.
subroutine xit()
   implicit none

   stop 201
end subroutine xit
