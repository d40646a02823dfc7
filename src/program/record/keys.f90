!> Keys that say how a record is read: its format, and each of its columns.
module asperity_program_record_keys
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_input_key, only: option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_file, only: record_format
   implicit none
   private
   public :: column_keys, format_keys

   !> A column as the user asks for it, then as it was found.
   type :: column_keys
      !> `displacement` or `force`, the beginning of its keys
      character(len=12) :: name = ''
      !> Name or number of the column, and the unit of its numbers; empty for none
      character(len=:), allocatable :: column, unit
      !> Where they were found, not allocated before
      character(len=:), allocatable :: column_source, unit_source
      !> Whether they are given
      logical :: has_column = .false., has_unit = .false.
   contains
      procedure :: declare_column, declare_unit, ask, tell, tell_unit
   end type column_keys

   !> How a record is written.
   type, extends(record_format) :: format_keys
      !> Where the decimal sign was found, not allocated before
      character(len=:), allocatable :: decimal_source
   contains
      procedure :: declare, check
   end type format_keys

contains

   !> Declare which column it is.
   pure subroutine declare_column(self, keys, help)
      !> The column
      class(column_keys), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> What it is
      character(len=*), intent(in) :: help

      call keys%text(trim(self%name)//'_column', self%column, help)
      call keys%said_by(self%column_source)
      self%has_column = keys%given()
      if (self%has_column) self%column_source = keys%rows(keys%last)%source
   end subroutine declare_column

   !> Declare its unit.
   pure subroutine declare_unit(self, keys, help)
      !> The column
      class(column_keys), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> What it is
      character(len=*), intent(in) :: help

      call keys%text(trim(self%name)//'_unit', self%unit, help)
      call keys%said_by(self%unit_source)
      self%has_unit = keys%given()
   end subroutine declare_unit

   !> A column of a record to look for.
   pure subroutine ask(self, column)
      !> What is wanted
      class(column_keys), intent(in) :: self
      !> The column
      type(record_column), intent(out) :: column

      column%wanted = self%column
      column%unit_given = self%unit
      column%option = option_name(trim(self%name)//'_column')
   end subroutine ask

   !> Say which column was taken.
   pure subroutine tell(self, column)
      !> What was wanted
      class(column_keys), intent(inout) :: self
      !> The column
      type(record_column), intent(in) :: column

      if (self%has_column) return
      self%column = to_text(column%place)
      select case (column%chosen_by)
      case ('position')
         self%column_source = 'position: nothing says what columns hold'
      case ('rest')
         self%column_source = 'what is left of the columns: '//column%heading
      case default
         self%column_source = 'its '//column%chosen_by//': '//column%heading
      end select
   end subroutine tell

   !> Say which unit the numbers have: that of the column, else a usual one.
   pure subroutine tell_unit(self, column, usual)
      !> What was wanted
      class(column_keys), intent(inout) :: self
      !> The column
      type(record_column), intent(in) :: column
      !> The usual unit
      character(len=*), intent(in) :: usual

      if (self%has_unit) return
      self%unit = usual
      self%unit_source = 'default'
      if (column%unit == '') return
      self%unit = column%unit
      self%unit_source = 'column '//to_text(column%place)
   end subroutine tell_unit

   !> Declare how the record is written and which rows are read.
   pure subroutine declare(self, keys, unused)
      !> How it is written
      class(format_keys), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether no record is read
      logical, intent(in) :: unused

      call keys%text('where', self%where, &
         'NAME=VALUE,...: only rows that have these values; all tests of the file unless given')
      call keys%unused(unused)
      call keys%choice('separator', self%separator, 'auto comma semicolon tab blank', &
         'what separates columns')
      call keys%unused(unused)
      call keys%choice('decimal', self%decimal, 'auto point comma', 'decimal sign')
      if (allocated(self%decimal_source)) call keys%said_by(self%decimal_source)
      call keys%unused(unused)
      call keys%whole('skip_lines', self%skip_lines, &
         'lines passed over before the column names')
      call keys%unused(unused)
   end subroutine declare

   !> Set `error` unless the record can be written so.
   pure subroutine check(self, error)
      !> How it is written
      class(format_keys), intent(in) :: self
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error

      if (self%skip_lines < 0) call fatal_error(error, 'skip_lines = '// &
         to_text(self%skip_lines)//' is not allowed: it must not be negative', &
         subject='skip_lines')
   end subroutine check

end module asperity_program_record_keys
