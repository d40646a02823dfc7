!> What gfortran says of a source.
module asperity_program_commands_routine_messages
   use asperity_base_number_text, only: to_text
   use asperity_program_system_strings, only: split_lines, starts_with, string_type
   implicit none
   private
   public :: message_type, compiler_messages

   !> Kinds of messages
   enum, bind(c)
      enumerator :: said_error = 1, said_warning
   end enum
   public :: said_error, said_warning
   character(len=*), parameter :: marks(2) = [character(len=10) :: 'Error: ', 'Warning: ']

   !> A message.
   type :: message_type
      !> One of the above
      integer :: kind = said_error
      !> Such as `line 12`, or `line 3 of body.inc`
      character(len=:), allocatable :: place
      !> What it says
      character(len=:), allocatable :: text
   end type message_type

contains

   !> The messages in an output of gfortran without carets: `PATH:LINE:COLUMN: Warning: TEXT`.
   pure subroutine compiler_messages(output, path, messages)
      !> The output
      character(len=*), intent(in) :: output
      !> Path of the source as the compiler knows it
      character(len=*), intent(in) :: path
      !> The messages, each once
      type(message_type), allocatable, intent(out) :: messages(:)
      type(string_type), allocatable :: lines(:)
      type(message_type), allocatable :: found(:)
      integer :: at, i, kind, n

      ! gfortran warns of its bounds otherwise
      allocate (lines(0))
      call split_lines(output, lines)
      allocate (found(size(lines)))
      n = 0
      do i = 1, size(lines)
         associate (line => lines(i)%text)
            do kind = 1, size(marks)
               at = index(line, ': '//trim(marks(kind))//' ')
               if (kind == said_error .and. at == 0) at = index(line, ': Fatal Error: ')
               if (at > 0) exit
            end do
            ! the line of an error's other place says nothing else
            if (at == 0 .or. index(line, ': (1)') > 0) cycle
            n = n + 1
            found(n)%kind = kind
            found(n)%place = place_of(line(:at - 1), path)
            found(n)%text = without_mark(line(at + 2 + index(line(at + 2:), ': ') + 1:))
            if (any([(is_same(found(kind), found(n)), kind=1, n - 1)])) n = n - 1
         end associate
      end do
      allocate (messages(n))
      do i = 1, n
         messages(i)%kind = found(i)%kind
         messages(i)%place = found(i)%place
         messages(i)%text = found(i)%text
      end do
   end subroutine compiler_messages

   !> A text without ` at (1)`, which refers to a caret that is not shown.
   pure function without_mark(text) result(clean)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: clean
      character(len=*), parameter :: caret = ' at (1)'
      integer :: at

      clean = text
      at = index(clean, caret)
      if (at > 0) clean = clean(:at - 1)//clean(at + len(caret):)
   end function without_mark

   !> Whether two messages say the same of the same line.
   pure logical function is_same(a, b)
      type(message_type), intent(in) :: a, b

      is_same = a%kind == b%kind .and. a%place == b%place .and. a%text == b%text
   end function is_same

   !> `line 12` of `PATH:12:7`.
   pure function place_of(place, path) result(text)
      character(len=*), intent(in) :: place, path
      character(len=:), allocatable :: text
      integer :: line, status, first, last

      text = place
      last = index(place, ':', back=.true.)
      if (last == 0) return
      first = index(place(:last - 1), ':', back=.true.)
      if (first == 0) return
      read (place(first + 1:last - 1), *, iostat=status) line
      if (status /= 0) return
      text = 'line '//to_text(line)
      if (.not. starts_with(place, path//':')) text = text//' of '// &
         place(index(place(:first), '/', back=.true.) + 1:first - 1)
   end function place_of

end module asperity_program_commands_routine_messages
