!> Memory that the system does not give.
module asperity_base_memory
   use, intrinsic :: iso_fortran_env, only: int64, int8
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: check_memory, check_room, check_work

   !> What to do where there is too little
   character(len=*), parameter, public :: memory_remedy = &
      ': make it smaller, or raise the limit of memory (ulimit -v)'
   real(wp), parameter :: mebibyte = 2.0_wp**20
   !> Bytes that are always kept for what is small: lines of a map, tables, texts
   integer(int64), parameter :: reserve = 16_int64*2_int64**20
   !> Bytes of work from which there may be too little memory for what is small beside it
   integer(int64), parameter, public :: worth_a_look = 2_int64**20

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
         to_text(real(bytes, wp)/mebibyte, 4)//' MiB more were asked for'//memory_remedy, &
         computation_error)
   end subroutine check_memory

   !> Set `error` unless so many bytes, and some for what is small, can be had now. What is taken
   !> and freed within them needs no check of its own.
   pure subroutine check_room(what, bytes, error)
      !> What the memory is for, such as the name of a map
      character(len=*), intent(in) :: what
      !> How much
      integer(int64), intent(in) :: bytes
      !> Set unless there is room
      type(error_type), allocatable, intent(inout) :: error
      integer(int8), allocatable :: room(:)
      integer :: status

      if (allocated(error)) return
      allocate (room(bytes + reserve), stat=status)
      call check_memory(status, what, bytes + reserve, error)
   end subroutine check_room

   !> The same for work that may be so small that it needs no look.
   pure subroutine check_work(what, bytes, error)
      !> What the memory is for
      character(len=*), intent(in) :: what
      !> How much, all in all
      integer(int64), intent(in) :: bytes
      !> Set unless there is room
      type(error_type), allocatable, intent(inout) :: error

      if (bytes > worth_a_look) call check_room(what, bytes, error)
   end subroutine check_work

end module asperity_base_memory
