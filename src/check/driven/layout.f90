!> Where the real arguments of a user routine stand in one array, with guard cells before and after
!> each, so that all of them can be filled, guarded, compared and named alike.
module asperity_check_driven_layout
   use, intrinsic :: iso_fortran_env, only: int64, real32
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: argument_slot, argument_layout, new_layout, lay_out, read_back, entry_name, &
      same_bits, cell_of, changed_name

   !> What a routine does with an argument: it reads it, sets it, or is given its value at the start
   !> of the increment and sets that of the end
   enum, bind(c)
      enumerator :: is_input = 1, is_output, is_advanced
   end enum
   public :: is_input, is_output, is_advanced

   !> Cells between two arguments; more than the entries that a fault of one component too many
   !> reaches, and even, so that an argument of single precision begins at a whole cell
   integer, parameter :: guard = 64

   !> One real argument.
   type :: argument_slot
      !> Name in ABAQUS' manual
      character(len=11) :: name = ''
      !> Numbers, and rows where it is a matrix, else zero
      integer :: length = 0, rows = 0
      integer :: role = is_input
      !> Place of the first number among all numbers without guards, and among all with them
      integer :: number = 0, unit = 0
   end type argument_slot

   !> All real arguments.
   type :: argument_layout
      type(argument_slot), allocatable :: slots(:)
      !> How many numbers there are without guards, and with them
      integer :: numbers = 0, units = 0
      !> Whether two numbers share a cell, as a routine in single precision has them
      logical :: single = .false.
   end type argument_layout

contains

   !> Lay out arguments in the order of their names; a name without length stands for no argument.
   pure subroutine new_layout(layout, names, roles, lengths, rows, single)
      !> Result
      type(argument_layout), intent(out) :: layout
      !> One each: name, role, length, rows of a matrix or 0
      character(len=*), intent(in) :: names(:)
      integer, intent(in) :: roles(:), lengths(:), rows(:)
      !> Whether the routine takes single precision
      logical, intent(in) :: single
      integer :: i

      allocate (layout%slots(size(names)))
      layout%single = single
      layout%units = guard
      do i = 1, size(names)
         associate (slot => layout%slots(i))
            slot%name = names(i)
            slot%role = roles(i)
            slot%length = lengths(i)
            slot%rows = rows(i)
            slot%number = layout%numbers + 1
            slot%unit = layout%units + 1
            layout%numbers = layout%numbers + slot%length
            layout%units = layout%units + 2*((slot%length + 1)/2) + guard
         end associate
      end do
   end subroutine new_layout

   !> Cell at which an argument begins.
   pure integer function cell_of(layout, slot)
      !> The layout
      type(argument_layout), intent(in) :: layout
      !> Place of the argument
      integer, intent(in) :: slot

      cell_of = layout%slots(slot)%unit
      if (layout%single) cell_of = (cell_of + 1)/2
   end function cell_of

   !> Cells that hold all numbers between guards.
   pure subroutine lay_out(layout, numbers, fills, units, cells)
      !> The layout
      type(argument_layout), intent(in) :: layout
      !> All numbers without guards
      real(wp), intent(in) :: numbers(:)
      !> What the guard before the first argument and after each holds
      real(wp), intent(in) :: fills(0:)
      !> All numbers with their guards, for `read_back`
      real(wp), allocatable, intent(out) :: units(:)
      !> The same as the routine takes them
      real(wp), allocatable, intent(out) :: cells(:)
      integer :: i, last

      allocate (units(layout%units))
      units(:guard) = fills(0)
      do i = 1, size(layout%slots)
         associate (slot => layout%slots(i))
            last = layout%units
            if (i < size(layout%slots)) last = layout%slots(i + 1)%unit - 1
            units(slot%unit + slot%length:last) = fills(i)
            units(slot%unit:slot%unit + slot%length - 1) = &
               numbers(slot%number:slot%number + slot%length - 1)
         end associate
      end do
      if (layout%single) then
         units = real(real(units, real32), wp)
         allocate (cells(layout%units/2))
         cells = transfer(real(units, real32), cells)
      else
         allocate (cells(layout%units))
         cells = units
      end if
   end subroutine lay_out

   !> All numbers after a call, and where it wrote that it must not.
   pure subroutine read_back(layout, units, cells, numbers, slot, offset)
      !> The layout
      type(argument_layout), intent(in) :: layout
      !> What `lay_out` gave
      real(wp), intent(in) :: units(:)
      !> What the routine left
      real(wp), intent(in) :: cells(:)
      !> All numbers without guards
      real(wp), allocatable, intent(out) :: numbers(:)
      !> Argument that was written to, and the entry: of an input within it, else outside of it;
      !> zero for none
      integer, intent(out) :: slot, offset
      real(wp) :: after(size(units))
      integer :: i, k, last

      if (layout%single) then
         after = real(transfer(cells, [0.0_real32]), wp)
      else
         after = cells
      end if
      allocate (numbers(layout%numbers))
      slot = 0
      offset = 0
      do i = 1, size(layout%slots)
         associate (s => layout%slots(i))
            numbers(s%number:s%number + s%length - 1) = after(s%unit:s%unit + s%length - 1)
            if (slot > 0) cycle
            last = layout%units
            if (i < size(layout%slots)) last = s%unit + s%length + guard/2 - 1
            do k = merge(1, s%unit - guard/2, i == 1), last
               if (k >= s%unit .and. k < s%unit + s%length .and. s%role /= is_input) cycle
               if (same_bits(after(k), units(k))) cycle
               slot = i
               offset = k - s%unit + 1
               exit
            end do
         end associate
      end do
   end subroutine read_back

   !> The first integer or text that a routine has written to, blank for none.
   pure function changed_name(names, before, after, text_names, texts_before, texts_after) &
         result(name)
      !> Integers: names, and values before and after the call
      character(len=*), intent(in) :: names(:)
      integer, intent(in) :: before(:), after(:)
      !> The same of texts
      character(len=*), intent(in) :: text_names(:), texts_before(:), texts_after(:)
      character(len=9) :: name
      integer :: k

      name = ''
      k = findloc(after == before, .false., dim=1)
      if (k > 0) name = names(k)
      if (k > 0) return
      k = findloc(texts_after == texts_before, .false., dim=1)
      if (k > 0) name = text_names(k)
   end function changed_name

   !> Name of an entry of an argument: `PNEWDT`, `STRESS(2)`, `DDSDDR(2,1)`.
   pure function entry_name(slot, entry) result(name)
      !> The argument
      type(argument_slot), intent(in) :: slot
      !> The entry, 1 first; others are outside of it
      integer, intent(in) :: entry
      character(len=:), allocatable :: name

      name = trim(slot%name)
      if (slot%length == 1 .and. slot%rows == 0 .and. entry == 1) return
      if (slot%rows > 0 .and. entry >= 1 .and. entry <= slot%length) then
         name = name//'('//to_text(1 + mod(entry - 1, slot%rows))//','// &
            to_text(1 + (entry - 1)/slot%rows)//')'
      else
         name = name//'('//to_text(entry)//')'
      end if
   end function entry_name

   !> Whether two numbers, or what is none, are the same.
   pure elemental logical function same_bits(a, b)
      !> The two
      real(wp), intent(in) :: a, b

      same_bits = transfer(a, 0_int64) == transfer(b, 0_int64)
   end function same_bits

end module asperity_check_driven_layout
