!> The end of a job that would compute something wrong.
module asperity_calculix_refusal
   implicit none
   private
   public :: refuse

contains

   !> Say why, and end the job with the solver's status of an error.
   subroutine refuse(reason)
      !> What is wrong, and what to do
      character(len=*), intent(in) :: reason

      write (*, '(2a)') ' *ERROR: ', reason
      stop 201
   end subroutine refuse

end module asperity_calculix_refusal
