!> One line of progress on a terminal for what takes longer than a second.
module asperity_program_system_progress
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_system_files, only: is_terminal, standard_error, write_text
   use asperity_program_system_launch, only: find_launch, launch_type
   use asperity_program_system_path, only: link_text
   use asperity_program_system_posix, only: c_getppid
   use asperity_program_system_strings, only: newline, starts_with
   implicit none
   private
   public :: progress_type, show_steps, show_stage, show_share, clear_steps, tell_terminal

   real(wp), parameter :: patience = 1.0_wp
   !> A run of this many increments takes over a second
   integer, parameter :: many = 5000
   !> Steps between two looks at the clock
   integer, parameter :: look_every = 16
   character(len=*), parameter :: line_start = achar(13), clear_line = achar(27)//'[K'

   !> Progress of one command.
   type :: progress_type
      private
      character(len=:), allocatable :: name
      integer(int64) :: began = 0_int64
      logical :: on_terminal = .false., shown = .false.
   contains
      !> Start the clock
      procedure :: start
      !> Say what has begun, when it will take long
      procedure :: announce
      !> Say how much is done, when it takes long
      procedure :: show
      !> Clear the line
      procedure :: finish
   end type progress_type

contains

   !> Start the clock.
   subroutine start(self, name)
      !> The progress
      class(progress_type), intent(out) :: self
      !> Name of the command
      character(len=*), intent(in) :: name

      self%name = name
      self%on_terminal = is_watched()
      call system_clock(self%began)
   end subroutine start

   !> Say what has begun, when it will take long.
   subroutine announce(self, amount, things)
      !> The progress
      class(progress_type), intent(inout) :: self
      !> How many increments
      integer, intent(in) :: amount
      !> What they are
      character(len=*), intent(in) :: things

      if (amount > many) call write_line(self, to_text(amount)//' '//things)
   end subroutine announce

   !> Say how much is done, when it takes long.
   subroutine show(self, done, amount, things)
      !> The progress
      class(progress_type), intent(inout) :: self
      !> How many are done, of how many
      integer, intent(in) :: done, amount
      !> What they are
      character(len=*), intent(in) :: things
      integer(int64) :: now, rate

      call system_clock(now, rate)
      if (real(now - self%began, wp) < patience*real(rate, wp)) return
      call write_line(self, to_text(done)//' of '//to_text(amount)//' '//things)
   end subroutine show

   !> Say how many steps are done, once the program has run for longer than a second. It keeps
   !> nothing between calls, so that a replay can call it, which knows no progress.
   subroutine show_steps(what, done, amount)
      !> What is under way
      character(len=*), intent(in) :: what
      !> How many are done, of how many
      integer, intent(in) :: done, amount
      character(len=:), allocatable :: reason
      real(wp) :: seconds

      if (mod(done, look_every) /= 0) return
      call cpu_time(seconds)
      if (seconds < patience) return
      if (is_watched()) call write_text(standard_error, line_start//'asperity '// &
         what//', step '//to_text(done)//' of '//to_text(amount)//clear_line, reason)
   end subroutine show_steps

   !> Say what is under way, once the program has run for longer than a second.
   subroutine show_stage(what)
      !> What has begun
      character(len=*), intent(in) :: what
      character(len=:), allocatable :: reason
      real(wp) :: seconds

      call cpu_time(seconds)
      if (seconds < patience) return
      if (is_watched()) call write_text(standard_error, line_start//'asperity '// &
         what//clear_line, reason)
   end subroutine show_stage

   !> Say how much of a file is read, once the program has run for longer than a second.
   subroutine show_share(share)
      !> Share read, 0 to 1
      real(wp), intent(in) :: share

      call show_stage('reading: '//to_text(nint(100.0_wp*share))//' %')
   end subroutine show_share

   !> Clear the line of those above.
   subroutine clear_steps()
      character(len=:), allocatable :: reason

      if (is_watched()) call write_text(standard_error, line_start//clear_line, &
         reason)
   end subroutine clear_steps

   !> Tell a terminal what is no result, such as a time.
   subroutine tell_terminal(what)
      !> What to say
      character(len=*), intent(in) :: what
      character(len=:), allocatable :: reason

      if (is_watched()) &
         call write_text(standard_error, 'asperity '//what//newline, reason)
   end subroutine tell_terminal

   !> Clear the line.
   subroutine finish(self)
      !> The progress
      class(progress_type), intent(inout) :: self
      character(len=:), allocatable :: reason

      if (self%shown) call write_text(standard_error, line_start//clear_line, reason)
      self%shown = .false.
   end subroutine finish

   !> Whether somebody sees what standard error says: a terminal, or that of the mpirun that reads
   !> it from a pipe, on the machine of rank 0. No other rank says how far it is.
   logical function is_watched()
      type(launch_type) :: launch

      launch = find_launch()
      is_watched = launch%rank == 0
      if (.not. is_watched) return
      is_watched = is_terminal(standard_error)
      if (is_watched .or. launch%size == 1) return
      is_watched = starts_with(link_text('/proc/self/fd/2'), 'pipe:')
      if (is_watched) is_watched = &
         starts_with(link_text('/proc/'//to_text(int(c_getppid()))//'/fd/2'), '/dev/pts/')
   end function is_watched

   !> Write over the line. A terminal that is gone is no reason to stop.
   subroutine write_line(self, text)
      class(progress_type), intent(inout) :: self
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: reason

      if (.not. self%on_terminal) return
      call write_text(standard_error, line_start//'asperity '//self%name//': '//text//clear_line, &
         reason)
      self%shown = .true.
   end subroutine write_line

end module asperity_program_system_progress
