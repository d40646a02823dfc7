!> The man page of the program, made from the commands and their keys.
module asperity_program_man_page
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_program_commands_registry, only: command_entry, list_commands, n_commands
   use asperity_program_help, only: case_words, group_title, in_group, key_words, n_groups, &
      option_words, status_words
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_strings, only: backslash, escaped, newline
   implicit none
   private
   public :: man_page

contains

   !> The page, for man(1).
   function man_page() result(text)
      character(len=:), allocatable :: text
      type(command_entry) :: list(n_commands)
      type(growing_text) :: b
      integer :: i

      call list_commands(list)
      call b%line('.TH ASPERITY 1 "" "asperity '//version//'" "User Commands"')
      call b%line('.SH NAME')
      call b%line(roff('asperity - elasto-plastic contact of rough timber faces'))
      call b%line('.SH SYNOPSIS')
      do i = 1, size(list)
         associate (command => list(i)%command)
            call b%line('.B '//roff('asperity '//trim(command%name)))
            call b%line(roff(escaped(command%usage, newline, ' | ')))
            call b%line('.br')
         end associate
      end do
      call b%line('.B asperity version')
      call b%line('.br')
      call b%line('.B asperity help')
      call b%line(roff('[COMMAND] [--man] [--completion bash]'))
      call b%line('.SH DESCRIPTION')
      do i = 1, size(list)
         call add_term(b, trim(list(i)%command%name), trim(list(i)%command%summary))
      end do
      call b%line('.PP')
      call b%line(roff(case_words))
      do i = 1, size(list)
         call add_command(b, list(i))
      end do
      call b%line('.SH EXIT STATUS')
      call b%line(roff(status_words))
      call b%line('.SH SEE ALSO')
      call b%line(roff('asperity --citation'))
      text = b%text()
   end function man_page

   !> Purpose and options of one command.
   subroutine add_command(b, entry)
      type(growing_text), intent(inout) :: b
      type(command_entry), intent(inout) :: entry
      type(key_list) :: keys
      integer :: i, group

      associate (command => entry%command)
         call command%declare(keys)
         call b%line('.SH "COMMAND '//trim(command%name)//'"')
         call b%line(roff(command%purpose))
         do group = 1, n_groups
            if (count([(in_group(keys%rows(i), group), i=1, keys%n)]) == 0) cycle
            call b%line('.SS '//roff(group_title(command, group)))
            do i = 1, keys%n
               if (in_group(keys%rows(i), group)) &
                  call add_term(b, option_words(keys%rows(i)), key_words(keys%rows(i)))
            end do
         end do
      end associate
   end subroutine add_command

   !> A term and what it is.
   subroutine add_term(b, term, words)
      type(growing_text), intent(inout) :: b
      character(len=*), intent(in) :: term, words

      call b%line('.TP')
      call b%line('.B '//roff(term))
      call b%line(roff(words))
   end subroutine add_term

   !> A line of text that roff prints as it is.
   function roff(text) result(line)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: line

      line = escaped(escaped(text, backslash, backslash//'e'), '-', backslash//'-')
      if (scan(line(1:1), '.''') == 1) line = backslash//'&'//line
   end function roff

end module asperity_program_man_page
