!> The ABAQUS utilities that a UINTER may call, and what stands in for the user's other routines: a
!> file of the user's that has one of these takes its place.

!> Print a message with its placeholders %I, %R and %S filled in.
subroutine stdb_abqerr(lop, string, intv, realv, charv)
   use asperity_base_kinds, only: wp
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

!> Folder of the results, without a blank or a slash at its end.
subroutine getoutdir(outdir, lenoutdir)
   use, intrinsic :: iso_c_binding, only: c_char, c_associated, c_char, c_loc, c_null_char, &
      c_ptr, c_size_t
   implicit none
   !> The folder, and the length of its name
   character(len=*), intent(out) :: outdir
   integer, intent(out) :: lenoutdir
   interface
      function getcwd(buffer, size) bind(c)
         import :: c_ptr, c_size_t
         type(c_ptr), value :: buffer
         integer(c_size_t), value :: size
         type(c_ptr) :: getcwd
      end function getcwd
   end interface
   character(kind=c_char), target :: buffer(4096)
   integer :: i

   outdir = ''
   lenoutdir = 0
   if (.not. c_associated(getcwd(c_loc(buffer), size(buffer, kind=c_size_t)))) return
   do i = 1, len(outdir)
      if (buffer(i) == c_null_char) exit
      outdir(i:i) = buffer(i)
      lenoutdir = i
   end do
end subroutine getoutdir

!> Name of the job: that of the deck where the runner tells it.
subroutine getjobname(jobname, lenjobname)
   use asperity_calculix_ccx_state, only: host
   implicit none
   !> The name, and its length
   character(len=*), intent(out) :: jobname
   integer, intent(out) :: lenjobname

   call get_environment_variable('ASPERITY_CALCULIX_JOB', jobname)
   if (jobname == '') jobname = host%job
   lenjobname = len_trim(jobname)
end subroutine getjobname

!> ABAQUS' results file is not there to be read.
subroutine posfil(nstep, ninc, array, jrcd)
   use asperity_base_kinds, only: wp
   use asperity_calculix_refusal, only: refuse
   implicit none
   integer, intent(in) :: nstep, ninc
   real(wp), intent(inout) :: array(*)
   integer, intent(inout) :: jrcd

   call refuse('POSFIL was called: CalculiX writes no results file of ABAQUS (.fil)')
end subroutine posfil

!> ABAQUS' results file is not there to be read.
subroutine dbfile(lop, array, jrcd)
   use asperity_base_kinds, only: wp
   use asperity_calculix_refusal, only: refuse
   implicit none
   integer, intent(in) :: lop
   real(wp), intent(inout) :: array(*)
   integer, intent(inout) :: jrcd

   call refuse('DBFILE was called: CalculiX writes no results file of ABAQUS (.fil)')
end subroutine dbfile

!> The user has none.
subroutine uexternaldb(lop, lrestart, time, dtime, kstep, kinc)
   use asperity_base_kinds, only: wp
   implicit none
   integer, intent(in) :: lop, lrestart, kstep, kinc
   real(wp), intent(in) :: time(2), dtime

end subroutine uexternaldb

!> The user has none.
subroutine urdfil(lstop, lovrwrt, kstep, kinc, dtime, time)
   use asperity_base_kinds, only: wp
   implicit none
   integer, intent(inout) :: lstop, lovrwrt
   integer, intent(in) :: kstep, kinc
   real(wp), intent(inout) :: dtime
   real(wp), intent(in) :: time(2)

end subroutine urdfil
