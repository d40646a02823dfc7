!> Letters in lower and upper case.
module asperity_base_letter_case
   implicit none
   private
   public :: lower_case, upper_case

contains

   !> ASCII letters in lower case.
   pure function lower_case(text) result(lower)
      !> Any text
      character(len=*), intent(in) :: text
      character(len=len(text)) :: lower
      integer :: i

      lower = text
      do i = 1, len(text)
         if (text(i:i) >= 'A' .and. text(i:i) <= 'Z') lower(i:i) = achar(iachar(text(i:i)) + 32)
      end do
   end function lower_case

   !> ASCII letters in upper case.
   pure function upper_case(text) result(upper)
      !> Any text
      character(len=*), intent(in) :: text
      character(len=len(text)) :: upper
      integer :: i

      upper = text
      do i = 1, len(text)
         if (text(i:i) >= 'a' .and. text(i:i) <= 'z') upper(i:i) = achar(iachar(text(i:i)) - 32)
      end do
   end function upper_case

end module asperity_base_letter_case
