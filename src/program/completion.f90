!> Completion of commands and options in bash, made from the commands and their keys.
module asperity_program_completion
   use asperity_base_text_builder, only: growing_text
   use asperity_program_commands_registry, only: all_keys, command_entry, list_commands, &
      n_commands
   use asperity_program_input_key, only: kind_choice, kind_logical, option_name
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: bash_completion

contains

   !> The function for bash, to be sourced.
   function bash_completion() result(text)
      character(len=:), allocatable :: text
      type(command_entry) :: list(n_commands)
      type(key_list) :: known
      character(len=:), allocatable :: first, second
      type(growing_text) :: b
      integer :: i, blank

      first = ''
      second = ''
      call list_commands(list)
      do i = 1, size(list)
         associate (name => list(i)%command%name)
            blank = index(name, ' ')
            if (index(first//' ', ' '//name(:blank - 1)//' ') == 0) first = first//' '// &
               name(:blank - 1)
            if (name(blank:) /= '') second = second//trim(name(blank:))
         end associate
      end do
      call b%line('# Completion of asperity in bash; written by asperity help --completion bash')
      call b%line('_asperity() {')
      call b%line('   local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}')
      call b%line('   local command=${COMP_WORDS[1]} words=')
      call b%line('   COMPREPLY=()')
      call b%line('   if ((COMP_CWORD == 1)) || [[ $before == help ]]; then')
      call b%line("      words='"//first//" version help --citation'")
      call b%line('   elif [[ $before == deck ]]; then')
      call b%line("      words='"//second//"'")
      call b%line('   else')
      call b%line('      [[ $command == deck ]] && command="deck ${COMP_WORDS[2]}"')
      call b%line('      case $before in')
      call all_keys(known)
      do i = 1, known%n
         associate (key => known%rows(i))
            if (key%kind == kind_choice) call b%line('      '//option_name(key%name)// &
               ") words='"//trim(key%choices)//"' ;;")
         end associate
      end do
      call b%line('      esac')
      call b%line('      [[ -n $words ]] || case $command in')
      do i = 1, size(list)
         call add_options(b, list(i))
      end do
      call b%line('      esac')
      call b%line('      [[ $word == -* || $before == --* ]] || words=')
      call b%line('   fi')
      call b%line('   mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")')
      call b%line('}')
      call b%line('complete -o default -F _asperity asperity')
      text = b%text()
   end function bash_completion

   !> Options of one command.
   subroutine add_options(b, entry)
      type(growing_text), intent(inout) :: b
      type(command_entry), intent(inout) :: entry
      type(key_list) :: keys
      character(len=:), allocatable :: option
      integer :: i

      call entry%command%declare(keys)
      call b%add("      '"//trim(entry%command%name)//"') words='")
      do i = 1, keys%n
         option = option_name(keys%rows(i)%name)
         if (i > 1) call b%add(' ')
         call b%add(option)
         if (keys%rows(i)%kind == kind_logical) call b%add(' --no-'//option(3:))
      end do
      call b%line("' ;;")
   end subroutine add_options

end module asperity_program_completion
