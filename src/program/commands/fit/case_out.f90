!> The case file of a fit, which says where its numbers come from.
module asperity_program_commands_fit_case_out
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_types, only: fit_result
   use asperity_program_commands_fit_kind, only: fit_kind
   use asperity_program_input_key, only: kind_real
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_print_case, only: case_text
   use asperity_program_system_strings, only: add_line, string_type
   implicit none
   private
   public :: fit_case

contains

   !> The case file.
   function fit_case(kind, files, parameters, result) result(text)
      !> The kind, declared with the values found
      class(fit_kind), intent(in) :: kind
      !> Paths of the record
      character(len=*), intent(in) :: files
      !> The free parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> What was found
      type(fit_result), intent(in) :: result
      character(len=:), allocatable :: text
      character(len=:), allocatable :: commands
      type(key_list) :: keys
      type(string_type), allocatable :: heading(:)
      integer :: i, place

      call kind%case_keys(keys, commands)
      allocate (heading(3))
      heading(1)%text = 'Written by asperity fit, version '//version//', for asperity '//commands
      heading(2)%text = 'Record: '//files
      heading(3)%text = 'Fitted, with 95 % intervals:'
      do i = 1, size(parameters)
         call add_line(heading, '  '//trim(parameters(i)%name)//' '// &
            to_text(result%values(i), 4)//', '//to_text(result%lower(i), 4)//' to '// &
            to_text(result%upper(i), 4)//trim(' '//parameters(i)%unit)// &
            only_there(trim(parameters(i)%name), keys))
      end do
      call add_line(heading, 'Fixed:')
      do i = 1, kind%keys%n
         associate (key => kind%keys%rows(i))
            if (key%kind /= kind_real .or. .not. key%is_input()) cycle
            if (any(parameters%name == key%name)) cycle
            place = keys%find(trim(key%name))
            call add_line(heading, '  '//trim(key%name)//' '//to_text(key%values(1), 4)// &
               trim(' '//key%unit)//': '//key%source//only_there(trim(key%name), keys))
         end associate
      end do
      text = case_text(keys, heading)
   end function fit_case

   !> What is to be said of a number that is no key of the case.
   pure function only_there(name, keys) result(text)
      character(len=*), intent(in) :: name
      type(key_list), intent(in) :: keys
      character(len=:), allocatable :: text

      text = ''
      if (keys%find(name) == 0) text = ' (of the test, not of the case)'
   end function only_there

end module asperity_program_commands_fit_case_out
