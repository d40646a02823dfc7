!> The form of a Fortran source, fixed or free.
module asperity_check_source_form
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_letter_case, only: lower_case
   use asperity_check_source_statements, only: newline
   implicit none
   private
   public :: form_of, gfortran_options

   character(len=*), parameter :: fixed_endings(5) = [character(len=4) :: '.f', '.for', '.ftn', &
      '.f77', '.fpp']
   character(len=*), parameter :: free_endings(5) = [character(len=4) :: '.f90', '.f95', '.f03', &
      '.f08', '.f18']

contains

   !> The form, by the directive of Intel's compiler if there is one, else by the path's ending.
   pure subroutine form_of(path, text, form, error)
      !> Path of the source
      character(len=*), intent(in) :: path
      !> The source
      character(len=*), intent(in) :: text
      !> `fixed` or `free`
      character(len=5), intent(out) :: form
      !> Set when neither the source nor its path tells
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: ending
      integer :: length, start

      start = 1
      do while (start <= len(text))
         length = index(text(start:), newline) - 1
         if (length < 0) length = len(text) - start + 1
         form = form_by_directive(text(start:start - 1 + length))
         if (form /= '') return
         start = start + length + 1
      end do
      ending = lower_case(path(max(scan(path, './', back=.true.), 1):))
      if (any(fixed_endings == ending)) then
         form = 'fixed'
      else if (any(free_endings == ending)) then
         form = 'free'
      else
         call fatal_error(error, path//' is no Fortran by its ending: fixed form is '// &
            listed(fixed_endings)//', free form '//listed(free_endings))
      end if
   end subroutine form_of

   !> The form that a line sets, empty for a line that is no directive.
   pure function form_by_directive(line) result(form)
      character(len=*), intent(in) :: line
      character(len=5) :: form
      character(len=20) :: word
      integer :: first

      form = ''
      first = verify(line, ' '//achar(9))
      if (first == 0) return
      if (scan(line(first:first), '!cC*') == 0) return
      word = lower_case(adjustl(line(first + 1:)))
      if (word(:4) /= 'dir$' .and. word(:4) /= 'dec$') return
      word = adjustl(word(5:))
      select case (word)
      case ('freeform', 'nofixedform')
         form = 'free'
      case ('nofreeform', 'fixedform')
         form = 'fixed'
      case default
         form = ''
      end select
   end function form_by_directive

   !> Options of gfortran for a source: its form, lines of any length, a preprocessor if it has
   !> lines of one.
   pure function gfortran_options(form, text) result(options)
      !> `fixed` or `free`
      character(len=*), intent(in) :: form
      !> The source
      character(len=*), intent(in) :: text
      character(len=52) :: options

      options = '-f'//trim(form)//'-form -f'//trim(form)//'-line-length-none'
      if (text(:min(len(text), 1)) == '#' .or. index(text, newline//'#') > 0) &
         options = trim(options)//' -cpp'
   end function gfortran_options

   !> Endings as a message lists them.
   pure function listed(endings) result(text)
      character(len=*), intent(in) :: endings(:)
      character(len=:), allocatable :: text
      integer :: i

      text = trim(endings(1))
      do i = 2, size(endings)
         text = text//', '//trim(endings(i))
      end do
   end function listed

end module asperity_check_source_form
