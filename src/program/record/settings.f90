!> How a record is read, as the settings say it.
module asperity_program_record_settings
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_input_keys, only: find_key, option_name
   use asperity_program_input_settings, only: settings_type
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_file, only: record_format
   implicit none
   private
   public :: get_format, ask_for_column, tell_column, tell_decimal

contains

   !> Separator, decimal sign, lines skipped and rows chosen. `error` names the option.
   pure subroutine get_format(settings, format, error)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> How the record is read
      type(record_format), intent(out) :: format
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      format%separator = settings%text_of('separator')
      format%decimal = settings%text_of('decimal')
      format%skip_lines = settings%whole_of('skip_lines')
      format%where = settings%text_of('where')
      if (format%skip_lines < 0) call fatal_error(error, 'skip_lines = '// &
         to_text(format%skip_lines)//' is not allowed: it must not be negative')
   end subroutine get_format

   !> Let the settings say which decimal sign the numbers have.
   pure subroutine tell_decimal(settings, format)
      !> Settings in effect
      type(settings_type), intent(inout) :: settings
      !> How the record was read
      type(record_format), intent(in) :: format

      associate (setting => settings%of(find_key('decimal')))
         if (setting%text /= format%decimal) setting%source = 'the numbers of the file'
         setting%text = format%decimal
      end associate
   end subroutine tell_decimal

   !> A column as the user asks for it by `NAME_column` and `NAME_unit`.
   pure subroutine ask_for_column(settings, name, column)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> `displacement` or `force`
      character(len=*), intent(in) :: name
      !> The column
      type(record_column), intent(out) :: column

      column%wanted = settings%text_of(name//'_column')
      column%unit_given = settings%text_of(name//'_unit')
      column%option = option_name(find_key(name//'_column'))
   end subroutine ask_for_column

   !> Let the settings say which column was taken.
   pure subroutine tell_column(settings, name, column)
      !> Settings in effect
      type(settings_type), intent(inout) :: settings
      !> `displacement` or `force`
      character(len=*), intent(in) :: name
      !> The column
      type(record_column), intent(in) :: column

      associate (setting => settings%of(find_key(name//'_column')))
         if (setting%given) return
         setting%has_value = .true.
         setting%text = to_text(column%place)
         select case (column%chosen_by)
         case ('position')
            setting%source = 'position: nothing says what columns hold'
         case ('rest')
            setting%source = 'what is left of the columns: '//column%heading
         case default
            setting%source = 'its '//column%chosen_by//': '//column%heading
         end select
      end associate
   end subroutine tell_column

end module asperity_program_record_settings
