!> How far the columns of a result lie from those expected, row by row at equal times, and what in
!> words explains it.
module asperity_program_commands_compare_departures
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_compare_history, only: history_type, row_near
   use asperity_program_input_key, only: name_length
   implicit none
   private
   public :: departure_type, matching_rows, aligned, departure_of, explanation, exchange

   !> One column, expected against found.
   type :: departure_type
      !> Its name and unit
      character(len=name_length) :: name = '', unit = ''
      !> Rows that are compared
      logical, allocatable :: is_compared(:)
      !> What a value may be off
      real(wp) :: allowed = 0.0_wp
      !> First row beyond that, zero for none; the row that is farthest off
      integer :: first = 0, worst = 0
      !> Its time, s, and both values
      real(wp) :: time = none, expected = none, found = none
      !> Difference of the values over what is allowed
      real(wp) :: over_allowed = 0.0_wp
   end type departure_type

   !> Rows belong together when their times are as near as this part of the shortest increment:
   !> ABAQUS prints times with three figures
   real(wp), parameter :: share_of_increment = 0.1_wp

contains

   !> The row of the result for each expected row, zero for none.
   pure function matching_rows(expected, result) result(rows)
      !> Both histories
      type(history_type), intent(in) :: expected, result
      integer :: rows(size(expected%time))
      real(wp) :: shortest
      integer :: i, n

      n = size(rows)
      shortest = maxval(abs(expected%time))
      if (n > 1) shortest = minval(abs(expected%time(2:) - expected%time(:n - 1)))
      do i = 1, n
         rows(i) = row_near(result, expected%time(i), share_of_increment*shortest)
      end do
   end function matching_rows

   !> The result in the rows and columns of what is expected, `none` where it has no such.
   pure function aligned(expected, result, rows) result(found)
      !> Both histories
      type(history_type), intent(in) :: expected, result
      !> Row of the result for each expected row
      integer, intent(in) :: rows(:)
      real(wp) :: found(size(rows), size(expected%names))
      integer :: i, j, k

      found = none
      do i = 1, size(expected%names)
         j = findloc(result%names == expected%names(i), .true., 1)
         if (j == 0) cycle
         do k = 1, size(rows)
            if (rows(k) > 0) found(k, i) = result%values(rows(k), j)
         end do
      end do
   end function aligned

   !> One column of what is expected against what is found, in some rows.
   pure function departure_of(expected, column, found, is_row, tolerance) result(departure)
      !> What is expected, and which of its columns
      type(history_type), intent(in) :: expected
      integer, intent(in) :: column
      !> What is found in it
      real(wp), intent(in) :: found(:)
      !> Rows that the result has
      logical, intent(in) :: is_row(:)
      !> What may be off, as a part of the largest value of the column
      real(wp), intent(in) :: tolerance
      type(departure_type) :: departure
      real(wp) :: off(size(found))

      departure%name = expected%names(column)
      departure%unit = expected%units(column)
      departure%allowed = tolerance*scale_of(expected, column)
      associate (values => expected%values(:, column))
         allocate (departure%is_compared, source=is_row .and. values < none)
         ! a value that is missing is as far off as can be
         off = merge(abs(found - values), none, found < none)
         where (.not. departure%is_compared) off = -1.0_wp
         departure%first = findloc(off > departure%allowed, .true., 1)
         departure%worst = maxloc(off, 1)
         if (.not. any(departure%is_compared)) return
         departure%time = expected%time(departure%worst)
         departure%expected = values(departure%worst)
         departure%found = found(departure%worst)
         departure%over_allowed = none
         if (.not. off(departure%worst) > 0.0_wp) departure%over_allowed = 0.0_wp
         if (departure%allowed > 0.0_wp .and. off(departure%worst) < none) &
            departure%over_allowed = off(departure%worst)/departure%allowed
      end associate
   end function departure_of

   !> The largest value of a column; of one that is zero throughout, that of all of its unit.
   pure real(wp) function scale_of(history, column) result(scale)
      type(history_type), intent(in) :: history
      integer, intent(in) :: column
      integer :: j

      scale = largest(history%values(:, column))
      if (scale > 0.0_wp) return
      do j = 1, size(history%names)
         if (history%units(j) == history%units(column)) &
            scale = max(scale, largest(history%values(:, j)))
      end do
   end function scale_of

   pure real(wp) function largest(values)
      real(wp), intent(in) :: values(:)

      largest = max(0.0_wp, maxval(abs(values), mask=values < none))
   end function largest

   !> What explains a column that departs: another sign, other units, a factor, nothing at all;
   !> empty when nothing does.
   pure function explanation(expected, found, allowed) result(text)
      !> Values of the rows that were compared
      real(wp), intent(in) :: expected(:), found(:)
      !> What one may be off
      real(wp), intent(in) :: allowed
      character(len=:), allocatable :: text
      real(wp) :: factor, power

      text = ''
      if (any(is_none(found)) .or. .not. sum(expected**2) > 0.0_wp) return
      factor = sum(expected*found)/sum(expected**2)
      if (.not. abs(factor) > 0.0_wp .or. any(abs(found - factor*expected) &
         > abs(factor)*allowed)) then
         if (all(abs(found) <= allowed)) text = 'is zero throughout: was the routine called?'
      else if (abs(factor + 1.0_wp) < 0.01_wp) then
         text = 'has the other sign throughout: slave and master, or the two bodies, are exchanged'
      else
         power = log10(abs(factor))
         text = 'is '//to_text(factor, 4)//' times what is expected throughout'
         if (abs(power) > 1.0_wp .and. abs(power - 3.0_wp*anint(power/3.0_wp)) < 0.01_wp) then
            text = text//': check the units, which are N, mm, MPa, s'
         else
            text = text//': check area and properties'
         end if
      end if
   end function explanation

   !> Whether two columns of the result are each other's: 1, or -1 with one of them turned, as when
   !> slip directions are turned by 90 degrees; 0 if they are not.
   pure integer function exchange(expected, found, allowed)
      !> Values of both columns in the rows that were compared, shape (rows, 2)
      real(wp), intent(in) :: expected(:, :), found(:, :)
      !> What values of both may be off
      real(wp), intent(in) :: allowed
      integer :: sign

      exchange = 0
      do sign = -1, 1, 2
         if (all(abs(found(:, 1) - expected(:, 2)) <= allowed) .and. &
            all(abs(found(:, 2) - sign*expected(:, 1)) <= allowed)) exchange = sign
         if (all(abs(found(:, 1) - sign*expected(:, 2)) <= allowed) .and. &
            all(abs(found(:, 2) - expected(:, 1)) <= allowed)) exchange = sign
      end do
   end function exchange

end module asperity_program_commands_compare_departures
