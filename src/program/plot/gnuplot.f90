!> Draws pictures with gnuplot, which reads its script from a pipe and writes the picture into a
!> temporary file.
module asperity_program_plot_gnuplot
   use asperity_base_error, only: computation_error, error_type, fatal_error, file_error
   use asperity_program_system_atomic_files, only: output_file
   use asperity_program_system_files, only: read_file, remove_file
   use asperity_program_system_part_file, only: close_part, create_part, free_name, part_file
   use asperity_program_system_process, only: close_shell, held_interrupts, hold_interrupts, &
      open_shell, release_interrupts, run_shell, shell_type
   use asperity_program_system_strings, only: lower_case, newline, shell_word
   use asperity_program_system_utf8, only: utf8_text
   implicit none
   private
   public :: check_picture, draw, format_of

   !> Largest picture, characters
   integer, parameter :: largest = 256*1024*1024
   !> Shell command that succeeds if gnuplot is installed
   character(len=*), parameter :: is_there = 'command -v gnuplot >/dev/null 2>&1'

contains

   !> Set `error` unless a picture can be drawn into a file, before the work it shows.
   subroutine check_picture(file, error)
      !> The file
      type(output_file), intent(in) :: file
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      if (file%option == '--report' .and. format_of(file%path) /= 'html') then
         call fatal_error(error, file%option//': '//file%path//' must end in .html')
      else if (format_of(file%path) == '' .or. file%option /= '--report' &
            .and. format_of(file%path) == 'html') then
         call fatal_error(error, file%option//': '//file%path// &
            ' has no known ending: .svg, .png or .pdf')
      else if (file%is_device) then
         call fatal_error(error, file%option//': '//file%path//': a picture needs a file')
      else if (run_shell(is_there) /= 0) then
         call fatal_error(error, file%option//': gnuplot is not installed; on Debian: '// &
            'apt-get install gnuplot-nox', computation_error)
      end if
   end subroutine check_picture

   !> Draw the picture of a file. `error` is set when it cannot be had whole; nothing is left then.
   subroutine draw(file, script, picture, error)
      !> The file
      type(output_file), intent(in) :: file
      !> Commands of gnuplot
      character(len=*), intent(in) :: script
      !> What belongs into the file
      character(len=:), allocatable, intent(out) :: picture
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(held_interrupts) :: held
      type(part_file) :: part
      type(shell_type) :: shell
      character(len=:), allocatable :: failure, reason

      ! Interrupts reach gnuplot but not the program, which tidies up. So gnuplot is there first,
      ! and waits for a line before it takes the temporary file, which the program creates
      part%path = free_name(file%target)
      call open_shell(shell, 'read -r line && exec gnuplot -d >'//shell_word(part%path)// &
         ' 2>/dev/null', failure)
      if (.not. allocated(failure)) then
         call hold_interrupts(held)
         call create_part(part, reason)
         if (allocated(reason)) then
            call close_shell(shell, '', failure)
         else
            call close_part(part, reason)
            call close_shell(shell, newline//utf8_text(script), failure)
            if (.not. allocated(reason)) call read_file(part%path, largest, picture, reason)
            call remove_file(part%path)
         end if
         call release_interrupts(held, is_ending=.true.)
      end if
      if (allocated(reason)) then
         call fatal_error(error, file%option//': '//file%path//' cannot be written: '//reason, &
            file_error)
      else if (allocated(failure)) then
         call fatal_error(error, file%option//': gnuplot '//failure, computation_error)
      else if (.not. is_complete(picture, format_of(file%path))) then
         call fatal_error(error, file%option//': '//file%path//' cannot be written: gnuplot '// &
            'left it incomplete, is the disk full?', file_error)
      end if
   end subroutine draw

   !> `svg`, `png`, `pdf`, `html`, or nothing.
   pure function format_of(path) result(format)
      !> Path of a file
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: format

      format = lower_case(path(index(path, '.', back=.true.) + 1:))
      if (index(path, '.') == 0 .or. all(format /= ['svg ', 'png ', 'pdf ', 'html'])) format = ''
   end function format_of

   !> Whether a picture has its end.
   pure logical function is_complete(picture, format)
      character(len=*), intent(in) :: picture, format

      select case (format)
      case ('svg', 'html')
         is_complete = index(picture, '</svg>', back=.true.) > 0
      case ('png')
         is_complete = index(picture, 'IEND', back=.true.) > 0
      case default
         is_complete = index(picture, '%%EOF', back=.true.) > 0
      end select
   end function is_complete

end module asperity_program_plot_gnuplot
