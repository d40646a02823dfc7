!> The effective input as a case file that gives the same run.
module asperity_program_input_print_case
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_program_input_keys, only: belongs, command_names, keys, kind_choice, kind_file, &
      kind_integer, kind_list, kind_logical, kind_real, kind_text, n_keys
   use asperity_program_input_settings, only: settings_type
   use asperity_program_system_strings, only: escaped, newline, string_type
   implicit none
   private
   public :: case_text

   integer, parameter :: longest_line = 90
   !> Column at which comments start
   integer, parameter :: comment_column = 48

contains

   !> A case file with every key of the command; reals read back as the same bits.
   pure function case_text(settings, command, heading) result(text)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> The command
      integer, intent(in) :: command
      !> Comment lines above it; the command when absent
      type(string_type), intent(in), optional :: heading(:)
      character(len=:), allocatable :: text
      character(len=:), allocatable :: entry
      type(growing_text) :: buffer
      integer :: i, key

      entry = ''
      if (present(heading)) then
         do i = 1, size(heading)
            call buffer%line('! '//heading(i)%text)
         end do
      else
         call buffer%line('! asperity '//command_names(command)//' THIS_FILE, version '//version)
      end if
      call buffer%line('&asperity')
      do key = 1, n_keys
         if (.not. belongs(key, command) .or. keys(key)%kind >= kind_file) cycle
         if (.not. settings%of(key)%has_value) cycle
         if (settings%of(key)%unused .and. .not. settings%of(key)%given) cycle
         if (settings%of(key)%follows) then
            ! said, not fixed: it must follow when the other key changes
            call buffer%line('  ! '//trim(keys(key)%name)//': '//settings%of(key)%source)
            cycle
         end if
         entry = '  '//trim(keys(key)%name)//' = '//value_text(settings, key)
         call buffer%add(entry)
         if (settings%unit_of(key) /= '' .and. index(entry, newline) == 0) &
            call buffer%add(repeat(' ', max(1, comment_column - len(entry)))//'! '// &
            settings%unit_of(key))
         call buffer%line()
      end do
      call buffer%line('/')
      text = buffer%text()
   end function case_text

   !> Value of a key in namelist form.
   pure function value_text(settings, key) result(text)
      type(settings_type), intent(in) :: settings
      integer, intent(in) :: key
      character(len=:), allocatable :: text

      associate (setting => settings%of(key))
         select case (keys(key)%kind)
         case (kind_text, kind_choice)
            text = "'"//escaped(setting%text, "'", "''")//"'"
         case (kind_real)
            text = to_text(setting%values(1))
         case (kind_integer)
            text = to_text(setting%whole)
         case (kind_logical)
            text = trim(merge('.true. ', '.false.', setting%switch))
         case (kind_list)
            text = list_text(settings, key)
         case default
            text = ''
         end select
      end associate
   end function value_text

   !> Values of a list on as many lines as they need.
   pure function list_text(settings, key) result(text)
      type(settings_type), intent(in) :: settings
      integer, intent(in) :: key
      character(len=:), allocatable :: text
      character(len=:), allocatable :: value
      type(growing_text) :: buffer
      integer :: i, width

      width = len_trim(keys(key)%name) + 5
      associate (values => settings%of(key)%values)
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
