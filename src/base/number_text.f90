!> Numbers as text, for messages and files.
!>
!> Character results have explicit lengths: gfortran keeps the length of a deferred-length result
!> in static storage, which two threads that warn at once would share.
module asperity_base_number_text
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_finite, only: is_finite, is_nan
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: to_text

   !> Decimal text of a number without blanks: of a real, the shortest that reads back as the same
   !> bits, or its first figures when their number is given; `NaN`, `Infinity` or `-Infinity` where
   !> there is none.
   interface to_text
      module procedure :: integer_to_text
      module procedure :: large_integer_to_text
      module procedure :: real_to_text
      module procedure :: figures_to_text
   end interface to_text

   !> Figures that tell any two reals apart
   integer, parameter :: all_figures = 17
   integer, parameter :: buffer_length = 40

contains

   pure integer function integer_length(value)
      integer(int64), intent(in) :: value
      character(len=buffer_length) :: buffer

      write (buffer, '(i0)') value
      integer_length = len_trim(buffer)
   end function integer_length

   pure integer function real_length(value, figures)
      real(wp), intent(in) :: value
      integer, intent(in) :: figures
      character(len=buffer_length) :: buffer

      call write_real(value, figures, buffer)
      real_length = len_trim(buffer)
   end function real_length

   !> Decimal text of an integer.
   pure function integer_to_text(value) result(text)
      !> The number
      integer, intent(in) :: value
      character(len=integer_length(1_int64*value)) :: text

      write (text, '(i0)') value
   end function integer_to_text

   !> Decimal text of a large integer.
   pure function large_integer_to_text(value) result(text)
      !> The number
      integer(int64), intent(in) :: value
      character(len=integer_length(value)) :: text

      write (text, '(i0)') value
   end function large_integer_to_text

   !> Shortest text of a real that reads back as the same bits.
   pure function real_to_text(value) result(text)
      !> The number
      real(wp), intent(in) :: value
      character(len=real_length(value, all_figures)) :: text
      character(len=buffer_length) :: buffer

      call write_real(value, all_figures, buffer)
      text = buffer
   end function real_to_text

   !> Text of a real of so many figures at most.
   pure function figures_to_text(value, figures) result(text)
      !> The number
      real(wp), intent(in) :: value
      !> Most significant figures shown, 1 to 17
      integer, intent(in) :: figures
      character(len=real_length(value, figures)) :: text
      character(len=buffer_length) :: buffer

      call write_real(value, figures, buffer)
      text = buffer
   end function figures_to_text

   !> The text, left in the buffer and padded with blanks.
   pure subroutine write_real(value, figures, buffer)
      real(wp), intent(in) :: value
      integer, intent(in) :: figures
      character(len=buffer_length), intent(out) :: buffer
      character(len=16) :: edit
      real(wp) :: back
      integer :: n

      if (is_nan(value)) then
         buffer = 'NaN'
         return
      else if (.not. is_finite(value)) then
         buffer = merge('Infinity ', '-Infinity', value > 0.0_wp)
         return
      end if
      ! rounded to few figures, the largest numbers are none
      do n = merge(figures, 1, abs(value) > 1.0e307_wp), figures
         write (edit, '(a, i0, a)') '(es40.', n - 1, 'e3)'
         write (buffer, edit) value
         if (n == figures) exit
         read (buffer, *) back
         if (back >= value .and. back <= value) exit
      end do
      call make_plain(buffer)
   end subroutine write_real

   !> Turn 3.1E-001 into 0.31 where that is short, else into 3.1E-1.
   pure subroutine make_plain(buffer)
      character(len=buffer_length), intent(inout) :: buffer
      character(len=buffer_length) :: figures, zeros
      character(len=1) :: sign
      integer :: mark, exponent, n

      buffer = adjustl(buffer)
      sign = ' '
      if (buffer(1:1) == '-') then
         sign = '-'
         buffer = buffer(2:)
      end if
      mark = index(buffer, 'E')
      read (buffer(mark + 1:), *) exponent
      ! the figures without the point that follows the first of them
      figures = buffer(1:1)//buffer(3:mark - 1)
      n = mark - 2
      zeros = repeat('0', buffer_length)
      if (exponent < -4 .or. exponent > 6) then
         if (n == 1) figures(2:2) = '0'
         n = max(n, 2)
         write (buffer, '(4a, i0)') figures(1:1), '.', figures(2:n), 'E', exponent
      else if (exponent < 0) then
         buffer = '0.'//zeros(:-exponent - 1)//figures
      else
         if (n < exponent + 2) figures(n + 1:exponent + 2) = zeros
         n = max(n, exponent + 2)
         buffer = figures(:exponent + 1)//'.'//figures(exponent + 2:n)
      end if
      buffer = adjustl(sign//buffer(:buffer_length - 1))
   end subroutine make_plain

end module asperity_base_number_text
