!> Findings as lines of text, on their way from a child process.
module asperity_program_commands_check_finding_lines
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list
   use asperity_program_system_strings, only: escaped, newline, split_lines, string_type
   implicit none
   private
   public :: lines_of, add_lines

   !> Stands between the parts of a finding
   character(len=1), parameter :: mark = achar(31)
   !> Parts of a finding
   integer, parameter :: parts = 6

contains

   !> One line a finding.
   pure function lines_of(findings) result(text)
      !> The findings
      type(finding_list), intent(in) :: findings
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, findings%n
         associate (f => findings%items(i))
            text = text//to_text(f%rule)//mark//to_text(f%severity)//mark// &
               escaped(f%place//mark//f%expected//mark//f%found//mark//f%effect, newline, ' ')// &
               newline
         end associate
      end do
   end function lines_of

   !> Add the findings of such lines.
   pure subroutine add_lines(text, findings)
      !> From `lines_of`
      character(len=*), intent(in) :: text
      !> Where they are added
      type(finding_list), intent(inout) :: findings
      type(string_type), allocatable :: lines(:), part(:)
      integer :: i, rule, severity

      ! gfortran warns of its bounds otherwise
      allocate (lines(0))
      call split_lines(text, lines)
      do i = 1, size(lines)
         call split_lines(escaped(lines(i)%text, mark, newline), part)
         if (size(part) < parts) cycle
         read (part(1)%text, *) rule
         read (part(2)%text, *) severity
         call findings%add(rule, severity, part(3)%text, part(4)%text, part(5)%text, part(6)%text)
      end do
   end subroutine add_lines

end module asperity_program_commands_check_finding_lines
