!> The program `asperity`. It alone prints errors and sets the exit status.
program asperity_main
   use asperity, only: error_type
   use asperity_program_command_line, only: command_line_type, parse_command_line
   use asperity_program_driver, only: drive
   use asperity_program_system_files, only: standard_error, write_text
   use asperity_program_system_launch, only: find_launch, give_way, launch_type, rank_words
   use asperity_program_system_process, only: set_signals
   use asperity_program_system_strings, only: newline
   use asperity_program_system_utf8, only: utf8_text
   implicit none
   type(command_line_type) :: line
   type(launch_type) :: launch
   type(error_type), allocatable :: error
   character(len=:), allocatable :: reason

   launch = find_launch()
   call set_signals()
   call parse_command_line(line, error)
   if (.not. allocated(error)) call drive(line, launch, error)
   if (allocated(error)) then
      call give_way(launch)
      call write_text(standard_error, utf8_text('asperity: error: '//rank_words(launch)// &
         error%message)//newline, reason)
      stop error%category, quiet=.true.
   end if
end program asperity_main
