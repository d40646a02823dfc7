!> Names of columns, as the line before the numbers of a text has them: which column is x, which y
!> and which z, and their units, such as `y [um],x [um],z [nm]`, `"X_mm";"Y_mm";"Height/um"`.
module asperity_height_map_text_column_names
   use asperity_height_map_text_fields, only: choose_separator
   use asperity_height_map_text_header_fields, only: plain_key
   use asperity_height_map_units, only: is_other_unit, plain_unit
   implicit none
   private
   public :: column_names, read_column_names

   character(len=*), parameter :: tab = achar(9)
   !> What may stand before or after the letter of an axis
   character(len=*), parameter :: words(*) = [character(len=10) :: '', 'pos', 'position', 'coord', &
      'coordinate', 'axis', 'value', 'height']
   integer, parameter :: longest = 64

   !> What a line says of columns.
   type :: column_names
      !> Names in the line
      integer :: fields = 0
      !> Column of x, of y and of z; 0 where no name says it, or more than one
      integer :: places(3) = 0
      !> Their units, empty where there is none
      character(len=8) :: units(3) = ''
      !> Unit of z if it is a known one of something else than lengths
      character(len=longest) :: no_length = ''
      !> Whether the first name is empty, as over numbers of rows
      logical :: first_is_empty = .false.
   end type column_names

contains

   !> Read names; without names of axes three units are those of x, y and z in this order.
   pure subroutine read_column_names(line, names)
      !> The line
      character(len=*), intent(in) :: line
      !> What it says
      type(column_names), intent(out) :: names
      character(len=1) :: separator
      character(len=longest) :: name, unit
      character(len=8) :: by_place(3)
      logical :: is_there_twice(3)
      integer :: axis, first, last

      by_place = ''
      is_there_twice = .false.
      first = verify(line//'x', ' #%!/'//tab)
      if (first > len_trim(line)) return
      separator = choose_separator(line(first:))
      do while (first <= len(line) + 1)
         call next_name(line, separator, first, last, name, unit)
         if (separator == ' ' .and. name == '' .and. unit == '') exit
         names%fields = names%fields + 1
         if (names%fields == 1) names%first_is_empty = &
            verify(name, ' "') == 0
         if (names%fields <= 3) by_place(names%fields) = plain_unit(unit)
         axis = axis_of(name)
         if (axis == 0) cycle
         is_there_twice(axis) = is_there_twice(axis) .or. names%places(axis) > 0
         names%places(axis) = names%fields
         names%units(axis) = plain_unit(unit)
         if (axis == 3 .and. is_other_unit(unit)) names%no_length = unit
      end do
      where (is_there_twice) names%places = 0
      if (all(names%places == 0) .and. names%fields == 3 .and. all(by_place /= '')) then
         names%places = [1, 2, 3]
         names%units = by_place
      end if
      if (names%fields == 2) call read_profile(by_place, names)
   end subroutine read_column_names

   !> Two columns are a position and a height, whatever their names, in this order if none says it.
   pure subroutine read_profile(by_place, names)
      !> Units of the columns
      character(len=*), intent(in) :: by_place(3)
      type(column_names), intent(inout) :: names

      if (all(names%places == 0) .and. any(by_place(:2) == '')) return
      names%places = merge([2, 0, 1], [1, 0, 2], names%places(3) == 1)
      names%units = ''
      names%units([1, 3]) = by_place(names%places([1, 3]))
   end subroutine read_profile

   !> The name at `first`, and its unit: in brackets, or after a slash, an underscore or a blank.
   pure subroutine next_name(line, separator, first, last, name, unit)
      character(len=*), intent(in) :: line
      character(len=1), intent(in) :: separator
      !> Where it begins, then where the next does
      integer, intent(inout) :: first
      !> Where it ends
      integer, intent(out) :: last
      character(len=longest), intent(out) :: name, unit
      character(len=:), allocatable :: field
      integer :: at

      if (separator == ' ') first = first - 1 + verify(line(min(first, len(line) + 1):)//'x', &
         ' '//tab)
      last = len(line)
      at = scan(line(min(first, len(line) + 1):), merge(' '//tab, separator//separator, &
         separator == ' '))
      if (at > 0) last = first + at - 2
      if (separator == ' ' .and. last < len(line)) then
         ! a unit in brackets behind blanks belongs to the name before
         at = last + verify(line(last + 1:)//'x', ' '//tab)
         if (at <= len(line)) then
            if (scan(line(at:at), '[(') > 0 .and. scan(line(at:), '])') > 0) &
               last = at - 1 + scan(line(at:), '])')
         end if
      end if
      field = line(min(first, len(line) + 1):last)
      first = last + 2
      name = field
      unit = ''
      at = scan(field, '[(')
      if (at > 0) then
         name = field(:at - 1)
         unit = field(at + 1:)
         at = scan(unit, '])')
         if (at > 0) unit(at:) = ''
      else
         at = scan(trim(adjustl(field)), '/_ ', back=.true.)
         if (at > 0) then
            field = trim(adjustl(field))
            if (plain_unit(field(at + 1:)) /= '') then
               name = field(:at - 1)
               unit = field(at + 1:)
            end if
         end if
      end if
      unit = adjustl(unit)
   end subroutine next_name

   !> Number of the axis that a name means, 0 for none.
   pure integer function axis_of(name)
      character(len=*), intent(in) :: name
      character(len=1), parameter :: letters(3) = ['x', 'y', 'z']
      character(len=:), allocatable :: key
      integer :: i, k

      call plain_key(name, key)
      do k = 1, size(letters)
         do i = 1, size(words)
            axis_of = k
            if (key == letters(k)//trim(words(i)) .or. key == trim(words(i))//letters(k)) return
         end do
      end do
      axis_of = 0
      if (key == 'height' .or. key == 'heights' .or. key == 'elevation') axis_of = 3
   end function axis_of

end module asperity_height_map_text_column_names
