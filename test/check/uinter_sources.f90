!> UINTERs in fixed and free form, for the tests of sources.
module uinter_sources
   use asperity_base_letter_case, only: lower_case
   implicit none
   private
   public :: fixed_uinter, free_uinter, in_lower_case, swapped, with_line_breaks

   character(len=*), parameter, public :: newline = new_line('a')
   !> ABAQUS' list with names of releases up to 2020, as its manual has it
   character(len=*), parameter, public :: manual(47) = [character(len=10) :: 'STRESS', 'DDSDDR', &
      'AMKI', 'AMSKI', 'FLUX', 'DDFDDT', 'DDSDDT', 'DDFDDR', 'STATEV', 'SED', 'SFD', 'SPD', 'SVD', &
      'SCD', 'PNEWDT', 'RDISP', 'DRDISP', 'TEMP', 'DTEMP', 'PREDEF', 'DPRED', 'TIME', 'DTIME', &
      'FREQR', 'CINAME', 'SLNAME', 'MSNAME', 'PROPS', 'COORDS', 'ALOCALDIR', 'DROT', 'AREA', &
      'CHRLNGTH', 'NODE', 'NDIR', 'NSTATV', 'NPRED', 'NPROPS', 'MCRD', 'KSTEP', 'KINC', 'KIT', &
      'LINPER', 'LOPENCLOSE', 'LSTATE', 'LSDI', 'LPRINT']
   character(len=*), parameter, public :: fixed_begin = '      SUBROUTINE UINTER('
   character(len=*), parameter :: body = &
      '      INCLUDE ''ABA_PARAM.INC'''//newline// &
      '      CHARACTER*80 CINAME,SLNAME,MSNAME'//newline// &
      '      DIMENSION STRESS(NDIR),DDSDDR(NDIR,NDIR),RDISP(NDIR),PROPS(NPROPS)'//newline// &
      '      STRESS(1)=PROPS(1)*RDISP(1)'//newline// &
      '      DDSDDR(1,1)=PROPS(1)'//newline// &
      '      END'//newline

contains

   !> A UINTER in fixed form, six arguments a line.
   function fixed_uinter(names, begin, go_on) result(text)
      character(len=*), intent(in) :: names(:)
      !> How it and a continuation line begin, as usual when absent
      character(len=*), intent(in), optional :: begin, go_on
      character(len=:), allocatable :: text
      integer :: i

      text = fixed_begin
      if (present(begin)) text = begin
      do i = 1, size(names)
         text = text//trim(names(i))
         if (i < size(names)) text = text//','
         if (mod(i, 6) /= 0 .or. i == size(names)) cycle
         if (present(go_on)) then
            text = text//newline//go_on
         else
            text = text//newline//'     &'
         end if
      end do
      text = text//')'//newline//body
   end function fixed_uinter

   !> A UINTER in free form.
   function free_uinter(begin, go_on) result(text)
      !> How it begins, and how a line goes on, as usual when absent
      character(len=*), intent(in), optional :: begin, go_on
      character(len=:), allocatable :: text
      integer :: i

      text = 'subroutine uinter('
      if (present(begin)) text = begin
      do i = 1, size(manual)
         text = text//trim(manual(i))
         if (i < size(manual)) text = text//', '
         if (mod(i, 6) /= 0) cycle
         if (present(go_on)) then
            text = text//go_on
         else
            text = text//'&'//newline//'   '
         end if
      end do
      text = text//')'//newline//body
   end function free_uinter

   !> The list with two names exchanged.
   pure function swapped(a, b) result(names)
      character(len=*), intent(in) :: a, b
      character(len=len(manual)) :: names(size(manual))

      names = manual
      where (manual == a) names = b
      where (manual == b) names = a
   end function swapped

   !> Names in lower case.
   pure function in_lower_case(names) result(lower)
      character(len=*), intent(in) :: names(:)
      character(len=len(names)) :: lower(size(names))
      integer :: i

      do i = 1, size(names)
         lower(i) = lower_case(names(i))
      end do
   end function in_lower_case

   !> Lines whose ends are | in a text.
   pure function with_line_breaks(text) result(lines)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: lines
      integer :: i

      lines = text
      do i = 1, len(text)
         if (text(i:i) == '|') lines(i:i) = newline
      end do
   end function with_line_breaks

end module uinter_sources
