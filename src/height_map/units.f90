!> Units of files, and what the user says of a file that does not say it itself.
module asperity_height_map_units
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: is_other_unit, map_hints, plain_unit, settle_step, settle_unit, unit_length, &
      unit_of_length

   !> What the user says of a file that does not say it itself.
   type :: map_hints
      !> `m`, `cm`, `mm`, `um` or `nm`; empty when the file must say
      character(len=8) :: lateral_unit = '', height_unit = ''
      !> Distance of neighbours, mm; 0 when the file must say
      real(wp) :: step_x = 0.0_wp, step_y = 0.0_wp
      !> Whether a number of a text marks missing points, and which, as it stands there
      logical :: has_missing_value = .false.
      real(wp) :: missing_value = 0.0_wp
   end type map_hints

   !> Names of units, and their lengths in mm; the last one stands in files of other programs
   character(len=*), parameter :: names(6) = [character(len=2) :: 'm', 'cm', 'mm', 'um', 'nm', &
      'pm']
   real(wp), parameter :: lengths(6) = [1.0e3_wp, 10.0_wp, 1.0_wp, 1.0e-3_wp, 1.0e-6_wp, &
      1.0e-9_wp]
   !> What instruments export beside heights
   character(len=*), parameter :: others(*) = [character(len=9) :: '%', 'a.u.', 'arb.', 'au', &
      'counts', 'count', 'deg', char(194)//char(176), 'rad', 'mrad', 'waves', 'v', 'mv', 'uv', &
      'a', 'ma', 'na', 'pa', 'k', 'n', 'mn', 'nn', 'px', 'pixel', 'pixels', 's', 'ms', 'intensity']
   !> Steps that differ by less are the same, as people round them
   real(wp), parameter :: rounding = 1.0e-3_wp
   !> Steps of real maps, mm
   real(wp), parameter :: smallest_step = 1.0e-9_wp, largest_step = 1.0e6_wp

contains

   !> The name of a unit as used here: um for a micrometre in any spelling, empty for no unit.
   pure function plain_unit(text) result(unit)
      !> As it stands in a file, in brackets or not
      character(len=*), intent(in) :: text
      character(len=8) :: unit
      character(len=16) :: inner
      integer :: i, n

      inner = ''
      n = 0
      do i = 1, len_trim(text)
         if (scan(text(i:i), ' []()"'''//achar(0)//achar(9)) > 0) cycle
         n = n + 1
         if (n > len(inner)) exit
         inner(n:n) = text(i:i)
      end do
      unit = ''
      if (n < 1 .or. n > len(inner)) return
      select case (inner(:n))
      case ('m', 'cm', 'mm', 'um', 'nm', 'pm')
         unit = inner(:n)
      case ('M', 'meter', 'metre', 'meters', 'metres')
         unit = 'm'
      case ('MM', 'millimeter', 'millimetre')
         unit = 'mm'
      case ('UM', 'micron', 'microns', 'micrometer', 'micrometre')
         unit = 'um'
      case ('NM', 'nanometer', 'nanometre')
         unit = 'nm'
      case default
         ! the Greek letter and the micro sign in Shift-JIS, GBK, UTF-8, in Latin-1, of MS-DOS
         if (inner(n:n) /= 'm') return
         if (inner(:n - 1) == char(131)//char(202) .or. inner(:n - 1) == char(166)//char(204) &
            .or. inner(:n - 1) == char(206)//char(188) .or. inner(:n - 1) == char(194)//char(181) &
            .or. inner(:n - 1) == char(181) .or. inner(:n - 1) == char(230)) unit = 'um'
      end select
   end function plain_unit

   !> Whether a text is a known unit of something that is no length.
   pure logical function is_other_unit(text)
      !> As it stands in a file
      character(len=*), intent(in) :: text
      character(len=len(text)) :: lower
      integer :: i

      do i = 1, len(text)
         lower(i:i) = text(i:i)
         if (text(i:i) >= 'A' .and. text(i:i) <= 'Z') lower(i:i) = achar(iachar(text(i:i)) + 32)
      end do
      is_other_unit = any(others == adjustl(lower))
   end function is_other_unit

   !> Length of a unit in mm, 0 if it is none.
   pure elemental real(wp) function unit_length(unit)
      !> Name, such as `um`
      character(len=*), intent(in) :: unit
      integer :: i

      unit_length = 0.0_wp
      do i = 1, size(names)
         if (unit == names(i)) unit_length = lengths(i)
      end do
   end function unit_length

   !> The unit whose length all of some numbers are, within rounding; empty if there is none.
   pure function unit_of_length(values, mask) result(unit)
      !> Lengths, mm
      real(wp), intent(in) :: values(:)
      !> Which of them
      logical, intent(in) :: mask(:)
      character(len=8) :: unit
      integer :: i

      unit = ''
      do i = 1, size(names)
         if (any(mask) .and. all(abs(values - lengths(i)) <= rounding*lengths(i) .or. .not. mask)) &
            unit = names(i)
      end do
   end function unit_of_length

   !> Length in mm of the unit of a file: what the file says, or else the user.
   pure subroutine settle_unit(name, what, option, in_file, hint, length, error)
      !> Name of the file
      character(len=*), intent(in) :: name
      !> What has the unit, and the option of the program that says it
      character(len=*), intent(in) :: what, option
      !> Unit in the file, empty if it says none; and what the user says
      character(len=*), intent(in) :: in_file, hint
      !> Its length, mm
      real(wp), intent(out) :: length
      !> Set when nobody says it, or both say different ones
      type(error_type), allocatable, intent(out) :: error
      character(len=8) :: said

      length = 0.0_wp
      said = plain_unit(hint)
      if (hint /= '' .and. said == '') then
         call fatal_error(error, option//' '//trim(hint)//' is no unit: allowed are m, cm, mm, '// &
            'um and nm')
      else if (in_file == '' .and. hint == '') then
         call fatal_error(error, &
            name//': does not say in which unit its '//what//' are: say it '// &
            'with '//option//' m, cm, mm, um or nm')
      else if (in_file /= '' .and. hint /= '' .and. in_file /= said) then
         call fatal_error(error, name//': '//option//' '//trim(hint)//' contradicts the file, '// &
            'whose '//what//' are in '//trim(in_file)//': leave the option out')
      else if (in_file /= '') then
         length = unit_length(in_file)
      else
         length = unit_length(said)
      end if
   end subroutine settle_unit

   !> The step of a map in mm: what the file says, or else the user.
   pure subroutine settle_step(name, axis, in_file, hint, step, error)
      !> Name of the file; `x` or `y`
      character(len=*), intent(in) :: name, axis
      !> Step in the file, 0 if it says none; and what the user says, mm
      real(wp), intent(in) :: in_file, hint
      !> The step, mm
      real(wp), intent(out) :: step
      !> Set when nobody says it, both say different ones, or it is not allowed
      type(error_type), allocatable, intent(out) :: error

      step = in_file
      if (abs(hint) > 0.0_wp .and. .not. (hint >= smallest_step .and. hint <= largest_step)) then
         call fatal_error(error, 'step '//to_text(hint)//' mm in '//axis//' is not allowed: '// &
            'it must be from 1e-9 to 1e6 mm')
      else if (.not. (abs(in_file) > 0.0_wp .or. abs(hint) > 0.0_wp)) then
         call fatal_error(error, name//': does not say the distance of its points in '//axis// &
            ': say it with --step')
      else if (.not. abs(in_file) > 0.0_wp) then
         step = hint
      else if (.not. (in_file >= smallest_step .and. in_file <= largest_step)) then
         call fatal_error(error, name//': step '//to_text(in_file)//' mm in '//axis// &
            ' is not allowed: it must be from 1e-9 to 1e6 mm; correct the header')
      else if (hint > 0.0_wp .and. abs(hint - in_file) > rounding*in_file) then
         call fatal_error(error, name//': --step '//to_text(hint)//' mm contradicts the file, '// &
            'whose step in '//axis//' is '//to_text(in_file)//' mm: leave the option out')
      end if
   end subroutine settle_step

end module asperity_height_map_units
