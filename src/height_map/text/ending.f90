!> Lines of a text that are no numbers: blank ones, and comments, which end the numbers.
module asperity_height_map_text_ending
   use asperity_base_error, only: error_type
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line
   use asperity_height_map_file_errors, only: line_error
   implicit none
   private
   public :: check_text_end, line_type

   !> What a line is
   integer, parameter, public :: line_blank = 0, line_comment = 1, line_other = 2

contains

   !> What the current line is.
   pure integer function line_type(source)
      !> The file
      type(byte_source), intent(in) :: source
      integer :: i

      line_type = line_blank
      do i = source%first, source%last
         if (source%block(i) == ' ' .or. source%block(i) == achar(9)) cycle
         line_type = merge(line_comment, line_other, source%block(i) == '#')
         return
      end do
   end function line_type

   !> After a comment behind the first numbers there must be no others: it may separate two maps.
   subroutine check_text_end(source, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> Set when numbers follow
      type(error_type), allocatable, intent(out) :: error
      logical :: found

      do
         call next_line(source, found, error)
         if (allocated(error) .or. .not. found) return
         if (line_type(source) /= line_other) cycle
         call line_error(error, source, source%first, 'numbers follow a comment that stands '// &
            'behind others: leave the comment out, or keep one map in the file')
         return
      end do
   end subroutine check_text_end

end module asperity_height_map_text_ending
