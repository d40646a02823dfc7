!> What a message is about, by its text: what the program finds the place of a value by.
module subjects
   use asperity_base_error, only: error_type
   implicit none
   private
   public :: fits_subject

contains

   !> Whether an error whose message begins with the name of a value, `sigma = ...`, has that name
   !> first in its subject.
   pure logical function fits_subject(error) result(fits)
      !> The error
      type(error_type), intent(in) :: error
      character(len=*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyz_0123456789'
      integer :: length

      length = verify(error%message, letters) - 1
      fits = length < 1 .or. error%message(length + 1:length + min(3, &
         len(error%message) - length)) /= ' = '
      if (.not. fits) fits = index(error%subject//' ', error%message(:length)//' ') == 1
   end function fits_subject

end module subjects
