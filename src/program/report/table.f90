!> A table of results: named columns with units, of numbers or of texts.
module asperity_program_report_table
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_text
   use asperity_law_validity, only: validity_text
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: column_type, table_type, new_table, full_figures

   !> Kinds of columns
   enum, bind(c)
      !> Real numbers
      enumerator :: column_numbers = 1
      !> Contact status, an integer code
      enumerator :: column_status
      !> Validity flags, an integer sum
      enumerator :: column_validity
      !> Texts
      enumerator :: column_texts
      !> Whole numbers
      enumerator :: column_counts
   end enum
   public :: column_numbers, column_status, column_validity, column_texts, column_counts

   !> One column.
   type :: column_type
      !> Name, as in CSV and JSON
      character(len=:), allocatable :: name
      !> Unit, `-` for none
      character(len=:), allocatable :: unit
      !> One of the kinds above
      integer :: kind = column_numbers
      !> Numbers
      real(wp), allocatable :: values(:)
      !> Decimals on the terminal, negative to choose them by the values
      integer :: decimals = -1
      !> Significant figures of each number on the terminal, zero for one format of them all
      integer :: figures = 0
      !> Codes of status or validity, whole numbers
      integer, allocatable :: codes(:)
      !> Texts
      type(string_type), allocatable :: texts(:)
   contains
      !> One cell as text, numbers with 17 figures, empty where there is no value
      procedure :: cell
   end type column_type

   !> Columns of one length.
   type :: table_type
      !> The columns
      type(column_type), allocatable :: columns(:)
      !> Number of rows
      integer :: rows = 0
      !> Number of columns set
      integer :: set = 0
      !> Columns that tell rows apart; the terminal repeats them where a table is too wide
      integer :: leading = 1
   contains
      !> Append a column of numbers
      procedure :: add_numbers
      !> Append a column of codes
      procedure :: add_codes
      !> Append a column of texts
      procedure :: add_texts
      !> Place of a column
      procedure :: find
      !> Set an error if a number is not finite
      procedure :: check_finite
   end type table_type

contains

   !> A table without columns yet.
   pure function new_table(columns, rows, leading) result(table)
      !> How many columns will be added
      integer, intent(in) :: columns
      !> Number of rows
      integer, intent(in) :: rows
      !> Columns that tell rows apart, one when absent
      integer, intent(in), optional :: leading
      type(table_type) :: table

      if (present(leading)) table%leading = leading
      allocate (table%columns(columns))
      table%rows = rows
   end function new_table

   !> Append a column of numbers.
   pure subroutine add_numbers(self, name, unit, values, decimals, figures)
      !> The table
      class(table_type), intent(inout) :: self
      !> Name and unit of the column
      character(len=*), intent(in) :: name, unit
      !> One value per row
      real(wp), intent(in) :: values(:)
      !> Decimals on the terminal; chosen by the values when absent
      integer, intent(in), optional :: decimals
      !> Significant figures on the terminal, for a column of unlike quantities
      integer, intent(in), optional :: figures

      self%set = self%set + 1
      associate (column => self%columns(self%set))
         column%name = name
         column%unit = unit
         column%kind = column_numbers
         allocate (column%values, source=values)
         if (present(decimals)) column%decimals = decimals
         if (present(figures)) column%figures = figures
      end associate
   end subroutine add_numbers

   !> Append a column of codes, `column_status` or `column_validity`, or of `column_counts`.
   pure subroutine add_codes(self, name, kind, codes)
      !> The table
      class(table_type), intent(inout) :: self
      !> Name of the column
      character(len=*), intent(in) :: name
      !> Kind of the column
      integer, intent(in) :: kind
      !> One code per row
      integer, intent(in) :: codes(:)

      self%set = self%set + 1
      associate (column => self%columns(self%set))
         column%name = name
         column%unit = '-'
         column%kind = kind
         allocate (column%codes, source=codes)
      end associate
   end subroutine add_codes

   !> Append a column of texts.
   pure subroutine add_texts(self, name, texts)
      !> The table
      class(table_type), intent(inout) :: self
      !> Name of the column
      character(len=*), intent(in) :: name
      !> One text per row
      character(len=*), intent(in) :: texts(:)
      integer :: i

      self%set = self%set + 1
      associate (column => self%columns(self%set))
         column%name = name
         column%unit = '-'
         column%kind = column_texts
         allocate (column%texts(size(texts)))
         do i = 1, size(texts)
            column%texts(i)%text = trim(texts(i))
         end do
      end associate
   end subroutine add_texts

   !> Place of a column, zero when there is none of that name.
   pure integer function find(self, name)
      !> The table
      class(table_type), intent(in) :: self
      !> Name of the column
      character(len=*), intent(in) :: name

      do find = self%set, 1, -1
         if (self%columns(find)%name == name) return
      end do
   end function find

   !> Set an error if a number is not finite, so that no file ever holds one.
   pure subroutine check_finite(self, error)
      !> The table
      class(table_type), intent(in) :: self
      !> Set for the first such number
      type(error_type), allocatable, intent(out) :: error
      integer :: i, row

      do i = 1, self%set
         associate (column => self%columns(i))
            if (column%kind /= column_numbers) cycle
            row = findloc(ieee_is_finite(column%values), .false., 1)
            if (row == 0) cycle
            call fatal_error(error, column%name//' = '//to_text(column%values(row))// &
               ' in row '//to_text(row)//' is out of the range of numbers', computation_error)
            return
         end associate
      end do
   end subroutine check_finite

   !> One cell as text, numbers with 17 figures, empty where there is no value.
   pure function cell(self, row) result(text)
      !> The column
      class(column_type), intent(in) :: self
      !> Row, from 1
      integer, intent(in) :: row
      character(len=:), allocatable :: text

      select case (self%kind)
      case (column_numbers)
         text = ''
         if (.not. is_none(self%values(row))) text = full_figures(self%values(row))
      case (column_status)
         text = status_text(self%codes(row))
      case (column_validity)
         text = validity_text(self%codes(row))
      case (column_counts)
         text = to_text(self%codes(row))
      case default
         text = self%texts(row)%text
      end select
   end function cell

   !> A finite number with 17 significant figures, so that it reads back as the same bits.
   pure function full_figures(value) result(text)
      !> The number
      real(wp), intent(in) :: value
      character(len=:), allocatable :: text
      character(len=24) :: buffer

      write (buffer, '(es24.16e3)') value
      text = trim(adjustl(buffer))
   end function full_figures

end module asperity_program_report_table
