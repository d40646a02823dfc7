!> Problems with known answers: y(x; a, b) of a few forms beside a record.
module curve_problem
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_fit_problem, only: fit_problem
   implicit none
   private
   public :: curve

   !> The record, and which form it is held against.
   type, extends(fit_problem) :: curve
      !> `line` a + b x, `decay` a exp(-b x), `product` a b x, `wave` a sin(b x)
      character(len=8) :: form = 'line'
      real(wp), allocatable :: x(:), y(:)
      !> What residuals are divided by
      real(wp) :: scale = 1.0_wp
      !> Above this b the model is refused, or no number
      real(wp) :: largest = huge(1.0_wp), largest_number = huge(1.0_wp)
   contains
      procedure :: residuals => curve_residuals
   end type curve

contains

   recursive subroutine curve_residuals(self, values, residuals, error)
      class(curve), intent(in) :: self
      real(wp), intent(in) :: values(:)
      real(wp), intent(out) :: residuals(:)
      type(error_type), allocatable, intent(out) :: error

      residuals = 0.0_wp
      associate (a => values(1), b => values(2))
         if (b > self%largest) then
            call fatal_error(error, 'refused', computation_error)
            return
         end if
         select case (self%form)
         case ('line')
            residuals = a + b*self%x
         case ('decay')
            residuals = a*exp(-b*self%x)
         case ('product')
            residuals = a*b*self%x
         case ('wave')
            residuals = a*sin(b*self%x)
         case default
            error stop 'no such form'
         end select
         residuals = (residuals - self%y)/self%scale
         if (b > self%largest_number) residuals = ieee_value(a, ieee_quiet_nan)
      end associate
   end subroutine curve_residuals

end module curve_problem
