!> Numbers measured by tests. Each is printed, and appended as `key value` to a file with the
!> program's name in the folder that the environment variable ASPERITY_MEASUREMENTS names, from
!> which the documentation is filled: programs that run side by side do not share a file.
module measurements
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: record

contains

   !> Note one measured number.
   subroutine record(key, value)
      !> What was measured, such as `normal_law.pressure.relative_error`
      character(len=*), intent(in) :: key
      !> The number
      real(wp), intent(in) :: value
      character(len=1024) :: path, program
      integer :: unit, length, status

      write (*, '(5x, a, 1x, es10.3)') key, value
      call get_environment_variable('ASPERITY_MEASUREMENTS', path, length, status)
      if (status /= 0 .or. length == 0) return
      call get_command_argument(0, program)
      path(length + 1:) = '/'//program(index(program, '/', back=.true.) + 1:)
      open (newunit=unit, file=trim(path), position='append', action='write', iostat=status)
      if (status /= 0) error stop 'ASPERITY_MEASUREMENTS names a folder that cannot be written to'
      write (unit, '(a, 1x, es10.3)') key, value
      close (unit)
   end subroutine record

end module measurements
