!> Draws pictures with gnuplot, which reads its script from a pipe and writes the picture to the
!> temporary name of the file.
module app_gnuplot
   use, intrinsic :: iso_c_binding, only: c_int
   use asperity, only: computation_error, error_type, file_error
   use asperity_error, only: fatal_error
   use asperity_text, only: to_text
   use app_output, only: discard_files, output_file
   use app_strings, only: backslash, escaped, lower_case, newline
   use app_system, only: close_file, create_file, pipe_to_shell, read_file, run_shell
   implicit none
   private
   public :: check_picture, draw

   !> Pictures are looked at up to this size, characters
   integer, parameter :: largest = 16*1024*1024
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

   !> Draw into the temporary name of a file. `error` is set when that cannot be written or
   !> gnuplot fails; nothing is left then.
   subroutine draw(file, script, large, error)
      !> The file
      type(output_file), intent(inout) :: file
      !> Commands of gnuplot without terminal and output
      character(len=*), intent(in) :: script
      !> A sheet of many panels
      logical, intent(in) :: large
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: picture, reason, late_reason
      type(output_file) :: files(1)
      integer(c_int) :: descriptor
      integer :: status

      call create_file(file%part, descriptor, reason)
      if (.not. allocated(reason)) then
         file%staged = .true.
         call close_file(descriptor, reason)
      end if
      if (.not. allocated(reason)) then
         status = pipe_to_shell('exec gnuplot -d >'//shell_word(file%part)//' 2>/dev/null', &
            terminal(format_of(file%path), large)//script)
         call read_file(file%part, largest, picture, late_reason)
         if (allocated(late_reason)) reason = late_reason
      end if
      if (allocated(reason)) then
         call fatal_error(error, file%option//': '//file%path//' cannot be written: '//reason, &
            file_error)
      else if (status /= 0) then
         call fatal_error(error, file%option//': gnuplot failed with status '//to_text(status), &
            computation_error)
      else if (.not. is_complete(picture, format_of(file%path))) then
         call fatal_error(error, file%option//': '//file%path//' cannot be written: gnuplot '// &
            'left it incomplete, is the disk full?', file_error)
      end if
      if (.not. allocated(error)) return
      files(1) = file
      call discard_files(files)
      file%staged = .false.
   end subroutine draw

   !> `svg`, `png`, `pdf`, `html`, or nothing.
   pure function format_of(path) result(format)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: format

      format = lower_case(path(index(path, '.', back=.true.) + 1:))
      if (index(path, '.') == 0 .or. all(format /= ['svg ', 'png ', 'pdf ', 'html'])) format = ''
   end function format_of

   !> Whether a picture has its end; one too large to be read is trusted.
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
      is_complete = is_complete .or. len(picture) == largest
   end function is_complete

   !> The first commands of the script.
   pure function terminal(format, large) result(script)
      character(len=*), intent(in) :: format
      logical, intent(in) :: large
      character(len=:), allocatable :: script

      select case (format)
      case ('svg', 'html')
         script = 'set terminal svg size '//trim(merge('1440,1500', '960,720  ', large))// &
            " noenhanced font 'DejaVu Sans,15' background 'white'"
      case ('png')
         script = 'set terminal pngcairo size '//trim(merge('2160,2250', '1440,1080', large))// &
            " noenhanced font 'DejaVu Sans,21'"
      case default
         script = 'set terminal pdfcairo size '//trim(merge('40cm,42cm', '20cm,15cm', large))// &
            " noenhanced font 'DejaVu Sans,13'"
      end select
      script = 'set encoding utf8'//newline//script//newline
   end function terminal

   !> A text as one word of a shell command.
   pure function shell_word(text) result(word)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: word

      word = "'"//escaped(text, "'", "'"//backslash//"''")//"'"
   end function shell_word

end module app_gnuplot
