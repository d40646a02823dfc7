!> What the tests of records share.
module hysteresis_checks
   use asperity_base_error, only: error_type
   use asperity_hysteresis_analysis, only: analyse_hysteresis, hysteresis_result, &
      hysteresis_settings
   use funit, only: assertFalse
   use hysteresis_models, only: record_type
   implicit none
   private
   public :: analyse

contains

   !> Analyse, and fail the test if that fails.
   subroutine analyse(this, result, settings)
      type(record_type), intent(in) :: this
      type(hysteresis_result), intent(out) :: result
      type(hysteresis_settings), intent(in), optional :: settings
      type(error_type), allocatable :: error

      call analyse_hysteresis(this%displacement, this%force, result, error, settings)
      call assertFalse(allocated(error), 'is analysed')
      if (allocated(error)) error stop error%message
   end subroutine analyse

end module hysteresis_checks
