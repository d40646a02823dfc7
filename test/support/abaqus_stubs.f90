!> What UINTER and VUINTER said: messages and exits, recorded by the utilities of
!> test/abaqus/abaqus_utilities.f90.
module abaqus_stubs
   implicit none
   private
   public :: forget_calls, last_level, last_message, messages, warnings, exits

   integer, protected :: messages = 0, warnings = 0, exits = 0, last_level = 0
   character(len=600), protected :: last_message = ''

   public :: remember_message, remember_exit

contains

   subroutine forget_calls()
      messages = 0
      warnings = 0
      exits = 0
      last_level = 0
      last_message = ''
   end subroutine forget_calls

   subroutine remember_message(level, message)
      integer, intent(in) :: level
      character(len=*), intent(in) :: message

      messages = messages + 1
      if (level == -1) warnings = warnings + 1
      last_level = level
      last_message = message
   end subroutine remember_message

   subroutine remember_exit()
      exits = exits + 1
   end subroutine remember_exit

end module abaqus_stubs
