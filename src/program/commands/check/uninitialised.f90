!> Whether the outputs of a routine depend on variables that nothing was given to: two builds of it,
!> in which such variables hold different numbers, must give the same.
module asperity_program_commands_check_uninitialised
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, rule_uninitialised, severity_error
   use asperity_program_commands_routine_messages, only: message_type
   use asperity_program_system_child_run, only: child_finished, child_outcome
   use asperity_program_system_strings, only: split_lines, string_type
   implicit none
   private
   public :: judge_builds

   !> How gfortran warns of such a variable
   character(len=*), parameter :: marks(2) = [character(len=21) :: 'used uninitialized', &
      'may be used uninitial']
   !> Warnings that a finding shows
   integer, parameter :: shown = 3

contains

   !> Tell the outputs of two builds along one path apart, which are not the same, and name the
   !> variables by what the compiler warns of in a build that fills nothing.
   pure subroutine judge_builds(first, second, messages, findings)
      !> The runs, the first of which came to its end
      type(child_outcome), intent(in) :: first, second
      !> Warnings of the compiler
      type(message_type), intent(in) :: messages(:)
      !> The finding is added
      type(finding_list), intent(inout) :: findings
      character(len=:), allocatable :: found, place
      type(string_type), allocatable :: numbers(:), others(:)
      integer :: different, i, n

      if (second%ending == child_finished) then
         ! gfortran warns of their bounds otherwise
         allocate (numbers(0), others(0))
         call split_lines(first%text, numbers)
         call split_lines(second%text, others)
         n = min(size(numbers), size(others))
         different = count([(numbers(i)%text /= others(i)%text, i=1, n)])
         if (size(numbers) == size(others)) then
            ! behind the last line break is no number
            found = to_text(different)//' of '//to_text(n - 1)//' outputs along the path '// &
               'change when it holds another number'
         else
            found = 'the path ends early when it holds another number'
         end if
      else
         found = 'the run does not come to its end when it holds another number'
      end if
      place = ''
      n = 0
      do i = 1, size(messages)
         if (index(messages(i)%text, trim(marks(1))) == 0 &
            .and. index(messages(i)%text, trim(marks(2))) == 0) cycle
         n = n + 1
         if (n > shown) exit
         if (place /= '') place = place//'; '
         place = place//messages(i)%place//': '//in_words(messages(i)%text)
      end do
      if (place == '') place = 'a variable that the compiler does not name'
      call findings%add(rule_uninitialised, severity_error, place, 'outputs that do not depend '// &
         'on what a variable holds before it is set', found, &
         'results change with the compiler, its options and what ran before')
   end subroutine judge_builds

   !> A warning without its option, and without what gfortran calls an array of unknown bounds.
   pure function in_words(warning) result(text)
      character(len=*), intent(in) :: warning
      character(len=:), allocatable :: text
      integer :: last

      text = warning
      last = index(text, ' [-W')
      if (last > 0) text = text(:last - 1)
      last = index(text, "' ")
      if (text(:min(len(text), 4)) == "'MEM" .and. last > 0) text = 'an array'//text(last + 1:)
   end function in_words

end module asperity_program_commands_check_uninitialised
