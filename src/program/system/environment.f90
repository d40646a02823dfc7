!> What is around a run: its command line, the time, the width of the terminal.
module asperity_program_system_environment
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int, c_int16_t, c_long, &
      c_null_char, c_size_t
   use asperity_program_system_posix, only: c_gmtime_r, c_ioctl, c_isatty, c_strftime, c_time
   use asperity_program_system_strings, only: shell_word
   implicit none
   private
   public :: command_text, output_width, time_text

   !> Characters of a line where nobody says how many there are, and at least
   integer, parameter :: usual_width = 80, least_width = 40
   !> Standard output; the request of Linux for the size of a terminal
   integer(c_int), parameter :: standard_output = 1
   integer(c_long), parameter :: window_size = int(z'5413', c_long)

contains

   !> The command line as a shell takes it.
   function command_text() result(text)
      character(len=:), allocatable :: text
      character(len=:), allocatable :: argument
      integer :: i, length

      text = 'asperity'
      do i = 1, command_argument_count()
         call get_command_argument(i, length=length)
         allocate (character(len=length) :: argument)
         call get_command_argument(i, argument)
         text = text//' '//shell_word(argument)
         deallocate (argument)
      end do
   end function command_text

   !> Characters of a line of standard output: COLUMNS, else those of the terminal, else 80.
   integer function output_width() result(width)
      character(len=20) :: columns
      integer(c_int16_t) :: size_of_window(4)
      integer :: status

      call get_environment_variable('COLUMNS', columns, status=status)
      if (status == 0) then
         read (columns, *, iostat=status) width
      else if (c_isatty(standard_output) == 1) then
         ! rows come before columns
         size_of_window = 0_c_int16_t
         status = int(c_ioctl(standard_output, window_size, size_of_window))
         width = size_of_window(2)
      end if
      if (status /= 0 .or. width <= 0) width = usual_width
      width = max(least_width, width)
   end function output_width

   !> The time in UTC; that of SOURCE_DATE_EPOCH, in seconds since 1970, where it is set. Empty
   !> where there is no such date.
   function time_text() result(text)
      character(len=:), allocatable :: text
      character(len=20) :: epoch
      character(kind=c_char, len=32) :: buffer
      integer(c_long) :: seconds, calendar(16)
      integer :: status

      call get_environment_variable('SOURCE_DATE_EPOCH', epoch, status=status)
      if (status == 0) read (epoch, *, iostat=status) seconds
      if (status /= 0) call c_time(seconds)
      text = ''
      if (.not. c_associated(c_gmtime_r(seconds, calendar))) return
      text = buffer(:c_strftime(buffer, len(buffer, c_size_t), &
         '%Y-%m-%d %H:%M:%S UTC'//c_null_char, calendar))
   end function time_text

end module asperity_program_system_environment
