!> Walks through the objects of a Gwyddion file (GWY), as the format's documentation has them: an
!> object is its name, 4 bytes with the length of what it holds, and components one after the
!> other; a component is its name, a letter for its kind, and its value. Names and texts end with a
!> zero, numbers have their little end first. A capital letter is an array: 4 bytes with their
!> number, and the items.
module asperity_height_map_gwyddion_tree
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_decode_heights, only: byte_buffer, float64, number_at, sint32, uint32
   use asperity_height_map_file_errors, only: byte_error
   implicit none
   private
   public :: gwy_component, gwy_span, next_component, open_object, read_text

   !> Characters of a name or a text that are kept
   integer, parameter, public :: longest_text = 64
   integer, parameter :: block_length = 256

   !> Part of a file.
   type :: gwy_span
      !> Bytes before it, and before what follows it
      integer(int64) :: first = 0_int64, finish = 0_int64
   end type gwy_span

   !> A component of an object.
   type :: gwy_component
      !> Its name
      character(len=longest_text) :: name = ''
      !> Letter of its kind: b, c, i, q, d, s, o, and C, I, Q, D, S, O for arrays
      character(len=1) :: kind = ' '
      !> Its value; of an array the items, of an object what it holds
      type(gwy_span) :: value
      !> Items of an array
      integer(int64) :: count = 0_int64
      !> Value of a whole number of 32 bits or of a double
      real(wp) :: number = 0.0_wp
      !> Value of a text, name of an object
      character(len=longest_text) :: text = ''
   end type gwy_component

contains

   !> Read the next component of an object.
   subroutine next_component(source, rest, component, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What is left of the object; moved behind the component
      type(gwy_span), intent(inout) :: rest
      !> The component
      type(gwy_component), intent(out) :: component
      !> Set when it does not end within the object, or is of no known kind
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: i
      type(gwy_span) :: item

      call read_text(source, rest, component%name, error)
      if (allocated(error)) return
      call read_letter(source, rest, component%kind, error)
      if (allocated(error)) return
      component%value%first = rest%first
      select case (component%kind)
      case ('b', 'c')
         call step_over(source, rest, 1_int64, error)
      case ('i')
         call read_number(source, rest, sint32, component%number, error)
      case ('q')
         call step_over(source, rest, 8_int64, error)
      case ('d')
         call read_number(source, rest, float64, component%number, error)
      case ('s')
         call read_text(source, rest, component%text, error)
      case ('o')
         call open_object(source, rest, component%text, item, error)
         component%value%first = item%first
      case ('C', 'I', 'Q', 'D', 'S', 'O')
         call read_count(source, rest, component%count, error)
         if (allocated(error)) return
         component%value%first = rest%first
         select case (component%kind)
         case ('C')
            call step_over(source, rest, component%count, error)
         case ('I')
            call step_over(source, rest, 4_int64*component%count, error)
         case ('Q', 'D')
            call step_over(source, rest, 8_int64*component%count, error)
         case default
            do i = 1, component%count
               if (component%kind == 'S') then
                  call read_text(source, rest, component%text, error)
               else
                  call open_object(source, rest, component%text, item, error)
               end if
               if (allocated(error)) return
            end do
         end select
      case default
         call byte_error(error, source, rest%first - 1_int64, 'component of kind '// &
            to_text(ichar(component%kind))//', which is none of Gwyddion''s: the file is damaged')
      end select
      component%value%finish = rest%first
   end subroutine next_component

   !> Read the name and the length of an object.
   subroutine open_object(source, rest, name, inside, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What is left of the object around it; moved behind this one
      type(gwy_span), intent(inout) :: rest
      !> Its name
      character(len=longest_text), intent(out) :: name
      !> What it holds
      type(gwy_span), intent(out) :: inside
      !> Set when it does not end within the one around it
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: length

      call read_text(source, rest, name, error)
      if (.not. allocated(error)) call read_count(source, rest, length, error)
      if (allocated(error)) return
      inside%first = rest%first
      call step_over(source, rest, length, error)
      inside%finish = rest%first
   end subroutine open_object

   !> Read a text that ends with a zero; of a long one the beginning is kept.
   subroutine read_text(source, rest, text, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What is left of the object; moved behind the text
      type(gwy_span), intent(inout) :: rest
      !> The text
      character(len=longest_text), intent(out) :: text
      !> Set when it does not end within the object
      type(error_type), allocatable, intent(out) :: error
      character(len=1), target :: block(block_length)
      integer(int64) :: began, n
      integer :: i, used

      text = ''
      used = 0
      began = rest%first
      do while (rest%first < rest%finish)
         n = min(int(block_length, int64), rest%finish - rest%first)
         call read_at(source, rest%first, c_loc(block), n, error)
         if (allocated(error)) return
         do i = 1, int(n)
            rest%first = rest%first + 1_int64
            if (block(i) == achar(0)) return
            if (used == longest_text) cycle
            used = used + 1
            text(used:used) = block(i)
         end do
      end do
      call byte_error(error, source, began, &
         'a text does not end within its object: the file was '// &
         'cut off or damaged')
   end subroutine read_text

   subroutine read_letter(source, rest, letter, error)
      type(byte_source), intent(inout) :: source
      type(gwy_span), intent(inout) :: rest
      character(len=1), intent(inout) :: letter
      type(error_type), allocatable, intent(out) :: error
      character(len=1), target :: byte(1)
      integer(int64) :: at

      at = rest%first
      call step_over(source, rest, 1_int64, error)
      if (.not. allocated(error)) call read_at(source, at, c_loc(byte), 1_int64, error)
      if (.not. allocated(error)) letter = byte(1)
   end subroutine read_letter

   !> Read a number of 4 or 8 bytes.
   subroutine read_number(source, rest, kind, value, error)
      type(byte_source), intent(inout) :: source
      type(gwy_span), intent(inout) :: rest
      integer, intent(in) :: kind
      real(wp), intent(inout) :: value
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      integer(int64) :: at

      allocate (buffer%bytes(merge(8, 4, kind == float64)))
      at = rest%first
      call step_over(source, rest, size(buffer%bytes, kind=int64), error)
      if (.not. allocated(error)) call read_at(source, at, c_loc(buffer%bytes), &
         size(buffer%bytes, kind=int64), error)
      if (.not. allocated(error)) value = number_at(buffer, 0, kind)
   end subroutine read_number

   subroutine read_count(source, rest, count, error)
      type(byte_source), intent(inout) :: source
      type(gwy_span), intent(inout) :: rest
      integer(int64), intent(out) :: count
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value

      value = 0.0_wp
      call read_number(source, rest, uint32, value, error)
      count = int(value, int64)
   end subroutine read_count

   !> Move on by so many bytes.
   subroutine step_over(source, rest, length, error)
      type(byte_source), intent(in) :: source
      type(gwy_span), intent(inout) :: rest
      integer(int64), intent(in) :: length
      type(error_type), allocatable, intent(out) :: error

      if (length > rest%finish - rest%first) then
         call byte_error(error, source, rest%first, to_text(length)//' bytes do not fit in the '// &
            to_text(rest%finish - rest%first)//' that are left of their object: the file was '// &
            'cut off or damaged')
      else
         rest%first = rest%first + length
      end if
   end subroutine step_over

end module asperity_height_map_gwyddion_tree
