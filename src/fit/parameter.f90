!> A parameter of a fit: its name, where the search begins and between what it stays.
!>
!> Inside it is y, its value or the value's logarithm, and t, which any number may be: y goes from
!> one bound to the other as t goes from minus to plus infinity. So no search can ask for a value
!> that is not allowed.
module asperity_fit_parameter
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: check_parameters, fit_parameter, free_of, plain_slope, spread_of, value_of, y_of

   !> One parameter that is sought.
   type :: fit_parameter
      !> Name, as the library calls it
      character(len=32) :: name = ''
      !> Unit, empty for none
      character(len=16) :: unit = ''
      !> Where the search begins, strictly between the bounds
      real(wp) :: start = 0.0_wp
      !> Bounds, which the search comes close to and never passes
      real(wp) :: lower = 0.0_wp, upper = 0.0_wp
      !> Varied by ratios: bounds above zero, interval symmetric in the logarithm
      logical :: by_ratio = .false.
   end type fit_parameter

   !> t of a share so close to a bound that its slope is nothing is not asked for
   real(wp), parameter :: farthest = 30.0_wp

contains

   !> Set `error` unless names are given once, and bounds and starts are in order.
   pure subroutine check_parameters(parameters, error)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (size(parameters) == 0) then
         call fatal_error(error, 'no parameter is free: name at least one')
         return
      end if
      do i = 1, size(parameters)
         call check_parameter(parameters(i), error)
         if (.not. allocated(error) .and. any(parameters(:i - 1)%name == parameters(i)%name)) &
            call fatal_error(error, trim(parameters(i)%name)//' is free twice: name it once')
         if (allocated(error)) return
      end do
   end subroutine check_parameters

   pure subroutine check_parameter(parameter, error)
      type(fit_parameter), intent(in) :: parameter
      type(error_type), allocatable, intent(out) :: error
      logical :: fine

      associate (p => parameter)
         fine = is_finite(p%start) .and. is_finite(p%lower) .and. is_finite(p%upper)
         if (fine) fine = p%lower < p%start .and. p%start < p%upper &
            .and. (p%lower > 0.0_wp .or. .not. p%by_ratio)
         if (.not. fine) call fatal_error(error, trim(p%name)//' begins at '//to_text(p%start)// &
            ' between '//to_text(p%lower)//' and '//to_text(p%upper)//trim(' '//p%unit)// &
            ': the beginning must lie between the bounds'// &
            trim(merge(', which must be above 0', '                       ', p%by_ratio)), &
            subject=trim(p%name))
      end associate
   end subroutine check_parameter

   !> y of a value: itself or its logarithm.
   elemental real(wp) function y_of(parameter, value)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its value
      real(wp), intent(in) :: value

      y_of = value
      if (parameter%by_ratio) y_of = log(value)
   end function y_of

   !> Value of y.
   elemental real(wp) function plain_of(parameter, y)
      type(fit_parameter), intent(in) :: parameter
      real(wp), intent(in) :: y

      plain_of = y
      if (parameter%by_ratio) plain_of = exp(y)
   end function plain_of

   !> Value of t, between the bounds.
   elemental real(wp) function value_of(parameter, t)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Any number
      real(wp), intent(in) :: t
      real(wp) :: low, high

      low = y_of(parameter, parameter%lower)
      high = y_of(parameter, parameter%upper)
      value_of = plain_of(parameter, low + (high - low)*share_of(t))
      value_of = min(max(value_of, parameter%lower), parameter%upper)
   end function value_of

   !> t of a value strictly between the bounds.
   elemental real(wp) function free_of(parameter, value)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its value
      real(wp), intent(in) :: value
      real(wp) :: y, low, high

      y = y_of(parameter, value)
      low = y_of(parameter, parameter%lower)
      high = y_of(parameter, parameter%upper)
      free_of = log((y - low)/(high - y))
   end function free_of

   !> dy/dt.
   elemental real(wp) function plain_slope(parameter, t)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Any number
      real(wp), intent(in) :: t

      plain_slope = (y_of(parameter, parameter%upper) - y_of(parameter, parameter%lower)) &
         *share_of(t)*share_of(-t)
   end function plain_slope

   !> Ends of an interval y +- half, as values.
   pure function spread_of(parameter, value, half) result(ends)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its value
      real(wp), intent(in) :: value
      !> Half of the interval, of y
      real(wp), intent(in) :: half
      real(wp) :: ends(2)

      ends(1) = plain_of(parameter, y_of(parameter, value) - half)
      ends(2) = plain_of(parameter, y_of(parameter, value) + half)
   end function spread_of

   !> The way from one bound to the other, 0 to 1.
   elemental real(wp) function share_of(t)
      real(wp), intent(in) :: t

      share_of = 1.0_wp/(1.0_wp + exp(-min(max(t, -farthest), farthest)))
   end function share_of

end module asperity_fit_parameter
