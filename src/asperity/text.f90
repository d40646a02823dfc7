!> Numbers as text, for messages and files.
module asperity_text
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use asperity_kinds, only: wp
   implicit none
   private
   public :: to_text

   !> Shortest text that reads back as the same number.
   interface to_text
      module procedure :: integer_to_text
      module procedure :: real_to_text
   end interface to_text

contains

   !> Decimal text of an integer.
   pure function integer_to_text(value) result(text)
      !> The number
      integer, intent(in) :: value
      character(len=:), allocatable :: text
      character(len=24) :: buffer

      write (buffer, '(i0)') value
      text = trim(buffer)
   end function integer_to_text

   !> Shortest decimal text of a real that reads back as the same bits, or its first
   !> `max_figures` figures; `NaN`, `Infinity` or `-Infinity` where there is none.
   pure function real_to_text(value, max_figures) result(text)
      !> The number
      real(wp), intent(in) :: value
      !> Most significant figures shown; 17 when absent
      integer, intent(in), optional :: max_figures
      character(len=:), allocatable :: text
      character(len=32) :: buffer
      real(wp) :: back
      integer :: digits, most

      if (ieee_is_nan(value)) then
         text = 'NaN'
      else if (.not. ieee_is_finite(value)) then
         text = merge(' Infinity', '-Infinity', value > 0.0_wp)
         text = trim(adjustl(text))
      else
         most = 17
         if (present(max_figures)) most = max_figures
         do digits = 1, most
            write (buffer, '(es32.'//integer_to_text(digits - 1)//'e3)') value
            read (buffer, *) back
            if (back >= value .and. back <= value) exit
         end do
         text = plain(trim(adjustl(buffer)))
      end if
   end function real_to_text

   !> Scientific text such as 3.1E-001 as 0.31 where that is short, else as 3.1E-12.
   pure function plain(scientific) result(text)
      character(len=*), intent(in) :: scientific
      character(len=:), allocatable :: text
      character(len=:), allocatable :: sign_text, figures
      integer :: mark, exponent

      mark = index(scientific, 'E')
      read (scientific(mark + 1:), *) exponent
      figures = scientific(:mark - 1)
      sign_text = ''
      if (figures(1:1) == '-') then
         sign_text = '-'
         figures = figures(2:)
      end if
      if (exponent < -4 .or. exponent > 6) then
         if (figures(len(figures):) == '.') figures = figures//'0'
         text = sign_text//figures//'E'//integer_to_text(exponent)
         return
      end if
      figures = figures(1:1)//figures(3:)
      if (exponent < 0) then
         text = sign_text//'0.'//repeat('0', -exponent - 1)//figures
      else
         figures = figures//repeat('0', max(exponent + 2 - len(figures), 0))
         text = sign_text//figures(:exponent + 1)//'.'//figures(exponent + 2:)
      end if
   end function plain

end module asperity_text
