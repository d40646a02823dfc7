!> Results of a run: rows of numbers with their spread, to be printed and kept in a file.
module bench_results
   use asperity, only: wp
   use bench_timing, only: spread_type
   implicit none
   private
   public :: result_row, add_row, find_row, write_csv, short, with_spread

   !> One figure.
   type :: result_row
      !> Which table, whose row, and the unit
      character(len=24) :: section = ''
      character(len=60) :: name = ''
      character(len=12) :: unit = ''
      type(spread_type) :: value
      !> Repeats that the quantiles come from
      integer :: repeats = 1
   end type result_row

contains

   !> Append a figure.
   pure subroutine add_row(rows, section, name, unit, value, repeats)
      type(result_row), allocatable, intent(inout) :: rows(:)
      character(len=*), intent(in) :: section, name, unit
      type(spread_type), intent(in) :: value
      integer, intent(in) :: repeats
      type(result_row), allocatable :: longer(:)
      integer :: n

      n = 0
      if (allocated(rows)) n = size(rows)
      allocate (longer(n + 1))
      if (n > 0) longer(:n) = rows
      longer(n + 1) = result_row(section, name, unit, value, repeats)
      call move_alloc(longer, rows)
   end subroutine add_row

   !> Place of a figure, 0 when there is none.
   pure function find_row(rows, section, name) result(i)
      type(result_row), intent(in) :: rows(:)
      character(len=*), intent(in) :: section, name
      integer :: i

      do i = 1, size(rows)
         if (rows(i)%section == section .and. rows(i)%name == name) return
      end do
      i = 0
   end function find_row

   !> Write all figures; names hold no quote.
   subroutine write_csv(path, rows)
      character(len=*), intent(in) :: path
      type(result_row), intent(in) :: rows(:)
      integer :: unit, status, i

      open (newunit=unit, file=path, action='write', status='replace', iostat=status)
      if (status /= 0) error stop 'bench: the file of results cannot be written'
      write (unit, '(a)') 'section,name,unit,median,quantile_10,quantile_90,repeats'
      do i = 1, size(rows)
         associate (r => rows(i))
            write (unit, '(7a, 3(es12.6, '',''), i0)') '"', trim(r%section), '","', &
               trim(r%name), '","', trim(r%unit), '",', r%value%median, r%value%low, &
               r%value%high, r%repeats
         end associate
      end do
      close (unit)
   end subroutine write_csv

   !> Three significant digits.
   pure function short(x) result(text)
      real(wp), intent(in) :: x
      character(len=10) :: text

      text = ''
      if (abs(x) >= 1.0e7_wp .or. abs(x) < 0.000995_wp) then
         write (text, '(es9.1)') x
         if (.not. abs(x) > 0.0_wp) text = '0'
      else if (abs(x) >= 99.95_wp) then
         write (text, '(i0)') nint(x)
      else if (abs(x) >= 9.995_wp) then
         write (text, '(f0.1)') x
      else if (abs(x) >= 0.995_wp) then
         write (text, '(f4.2)') x
      else if (abs(x) >= 0.0995_wp) then
         write (text, '(f5.3)') x
      else
         write (text, '(f6.4)') x
      end if
      text = adjustl(text)
   end function short

   !> `median (low-high)`.
   pure function with_spread(value) result(text)
      type(spread_type), intent(in) :: value
      character(len=32) :: text

      text = trim(short(value%median))//' ('//trim(short(value%low))//'-'// &
         trim(short(value%high))//')'
   end function with_spread

end module bench_results
