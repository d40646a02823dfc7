!> Writes comments and numbers as decks of ABAQUS and of CalculiX have them.
!>
!> Both read numbers in fields of at most 20 characters and sets with 16 numbers a line.
module asperity_deck_cards_card_writer
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   implicit none
   private
   public :: writer_type

   !> Figures that tell any two reals apart
   integer, parameter :: all_figures = 17
   integer, parameter :: longest_field = 20, most_reals = 8, most_integers = 16
   !> Columns of a comment
   integer, parameter :: comment_width = 96

   !> A deck under construction.
   type, extends(growing_text) :: writer_type
   contains
      !> Append a comment, on as many lines as it needs
      procedure :: comment
      !> Append a heading between rules
      procedure :: heading
      !> Append real numbers, eight a line, or fewer
      procedure :: reals
      !> Append whole numbers, sixteen a line
      procedure :: integers
      !> Append one real number
      procedure :: real
   end type writer_type

contains

   !> Append a comment, on as many lines as it needs.
   pure subroutine comment(self, text)
      !> The deck
      class(writer_type), intent(inout) :: self
      !> One paragraph, empty for an empty line
      character(len=*), intent(in) :: text
      integer :: first, last

      if (len(text) == 0) call self%line('**')
      first = 1
      do while (first <= len(text))
         last = len(text)
         if (last - first >= comment_width) then
            last = first + index(text(first:first + comment_width), ' ', back=.true.) - 1
            ! a word longer than a line
            if (last < first) last = first + comment_width - 1
         end if
         call self%line('** '//trim(text(first:last)))
         first = last + 1
      end do
   end subroutine comment

   !> Append a heading between rules.
   pure subroutine heading(self, text)
      !> The deck
      class(writer_type), intent(inout) :: self
      !> The heading
      character(len=*), intent(in) :: text

      call self%line('**')
      call self%line('** '//repeat('-', 10)//' '//text//' '// &
         repeat('-', max(2, comment_width - 12 - len(text))))
   end subroutine heading

   !> Append real numbers, eight a line or fewer.
   pure subroutine reals(self, values, most)
      !> The deck
      class(writer_type), intent(inout) :: self
      !> The numbers
      real(wp), intent(in) :: values(:)
      !> Most numbers of a line, 8 when absent
      integer, intent(in), optional :: most
      integer :: i, limit

      limit = most_reals
      if (present(most)) limit = most
      do i = 1, size(values)
         call self%real(values(i))
         call close_number(self, i, size(values), limit)
      end do
   end subroutine reals

   !> Append whole numbers, sixteen a line.
   pure subroutine integers(self, values)
      !> The deck
      class(writer_type), intent(inout) :: self
      !> The numbers
      integer, intent(in) :: values(:)
      integer :: i

      do i = 1, size(values)
         call self%add(to_text(values(i)))
         call close_number(self, i, size(values), most_integers)
      end do
   end subroutine integers

   !> Append what stands between a number and the next.
   pure subroutine close_number(self, i, n, limit)
      class(writer_type), intent(inout) :: self
      integer, intent(in) :: i, n, limit

      if (i == n .or. mod(i, limit) == 0) then
         call self%line()
      else
         call self%add(', ')
      end if
   end subroutine close_number

   !> Append a number with as many figures as the field holds, at most so many.
   pure subroutine real(self, value, figures)
      !> The deck
      class(writer_type), intent(inout) :: self
      !> The number
      real(wp), intent(in) :: value
      !> Most figures, 17 when absent
      integer, intent(in), optional :: figures
      integer :: n

      n = all_figures
      if (present(figures)) n = figures
      do while (n > 1 .and. len(to_text(value, n)) > longest_field)
         n = n - 1
      end do
      call self%add(to_text(value, n))
   end subroutine real

end module asperity_deck_cards_card_writer
