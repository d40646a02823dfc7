!> Memory that the system does not give.
module surface_memory
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_error, only: computation_error, error_type, fatal_error
   use asperity_kinds, only: wp
   use asperity_text, only: to_text
   implicit none
   private
   public :: check_memory

   real(wp), parameter :: mebibyte = 2.0_wp**20

contains

   !> Set `error` after an `allocate` that failed.
   pure subroutine check_memory(status, what, bytes, error)
      !> Its `stat`
      integer, intent(in) :: status
      !> What the memory was for, such as the name of a map
      character(len=*), intent(in) :: what
      !> How much was asked for
      integer(int64), intent(in) :: bytes
      !> Set unless `status` is 0
      type(error_type), allocatable, intent(inout) :: error

      if (status == 0 .or. allocated(error)) return
      call fatal_error(error, what//': there is not enough memory, '// &
         to_text(real(bytes, wp)/mebibyte, 4)//' MiB more were asked for: cut the map, or raise '// &
         'the limit of memory (ulimit -v)', computation_error)
   end subroutine check_memory

end module surface_memory
