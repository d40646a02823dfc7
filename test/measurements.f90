!> Numbers measured by tests. Each is printed, and appended as `key value` to the file that the
!> environment variable ASPERITY_MEASUREMENTS names, from which the documentation is filled.
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
      character(len=1024) :: path
      integer :: unit, length, status

      write (*, '(5x, a, 1x, es10.3)') key, value
      call get_environment_variable('ASPERITY_MEASUREMENTS', path, length, status)
      if (status /= 0 .or. length == 0) return
      open (newunit=unit, file=path(:length), position='append', action='write', iostat=status)
      if (status /= 0) error stop 'ASPERITY_MEASUREMENTS names a file that cannot be written'
      write (unit, '(a, 1x, es10.3)') key, value
      close (unit)
   end subroutine record

end module measurements
