!> The effective input as a case file that gives the same run.
module asperity_program_input_print_case
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_program_input_key, only: given_nowhere, key_type, kind_choice, kind_counts, &
      kind_file, kind_integer, kind_list, kind_logical, kind_real, kind_text
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_strings, only: escaped, newline, string_type
   implicit none
   private
   public :: case_text, case_heading

   integer, parameter :: longest_line = 90
   !> Column at which comments start
   integer, parameter :: comment_column = 48

contains

   !> The heading of a case of a command.
   pure function case_heading(name) result(heading)
      !> Words of the command
      character(len=*), intent(in) :: name
      type(string_type) :: heading(1)

      heading(1)%text = 'asperity '//trim(name)//' THIS_FILE, version '//version
   end function case_heading

   !> A case file with every key; reals read back as the same bits.
   pure function case_text(keys, heading) result(text)
      !> The keys
      type(key_list), intent(in) :: keys
      !> Comment lines above it
      type(string_type), intent(in) :: heading(:)
      character(len=:), allocatable :: text
      character(len=:), allocatable :: entry
      type(growing_text) :: buffer
      integer :: i

      entry = ''
      do i = 1, size(heading)
         call buffer%line('! '//heading(i)%text)
      end do
      call buffer%line('&asperity')
      do i = 1, keys%n
         associate (key => keys%rows(i))
            if (key%kind >= kind_file .or. .not. key%has_value) cycle
            if (key%unused .and. key%given == given_nowhere) cycle
            if (key%follows) then
               ! said, not fixed: it must follow when the other key changes
               call buffer%line('  ! '//trim(key%name)//': '//key%source)
               cycle
            end if
            entry = '  '//trim(key%name)//' = '//value_text(key)
            call buffer%add(entry)
            if (key%unit /= '' .and. index(entry, newline) == 0) &
               call buffer%add(repeat(' ', max(1, comment_column - len(entry)))//'! '// &
               trim(key%unit))
            call buffer%line()
         end associate
      end do
      call buffer%line('/')
      text = buffer%text()
   end function case_text

   !> Value of a key in namelist form.
   pure function value_text(key) result(text)
      type(key_type), intent(in) :: key
      character(len=:), allocatable :: text

      select case (key%kind)
      case (kind_text, kind_choice)
         text = "'"//escaped(key%text, "'", "''")//"'"
      case (kind_real)
         text = to_text(key%values(1))
      case (kind_integer)
         text = to_text(key%whole)
      case (kind_logical)
         text = trim(merge('.true. ', '.false.', key%switch))
      case (kind_list, kind_counts)
         text = list_text(key)
      case default
         text = ''
      end select
   end function value_text

   !> Values of a list on as many lines as they need.
   pure function list_text(key) result(text)
      type(key_type), intent(in) :: key
      character(len=:), allocatable :: text
      character(len=:), allocatable :: value
      type(growing_text) :: buffer
      integer :: i, width

      width = len_trim(key%name) + 5
      associate (values => key%values)
         do i = 1, size(values)
            value = to_text(values(i))
            if (i < size(values)) value = value//','
            if (width + len(value) > longest_line) then
               call buffer%line()
               call buffer%add('   ')
               width = 3
            end if
            if (i > 1) call buffer%add(' ')
            call buffer%add(value)
            width = width + 1 + len(value)
         end do
      end associate
      text = buffer%text()
   end function list_text

end module asperity_program_input_print_case
