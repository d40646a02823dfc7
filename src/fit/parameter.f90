!> A parameter of a fit: its name, where the search begins and between what it stays.
!>
!> Inside it is y, its value over its scale or the value's logarithm, and t, any number:
!> y swings from one bound to the other and back as the sine of t does. So no search can ask for a
!> value that is not allowed, and one that leaps past a bound comes back.
module asperity_fit_parameter
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: check_parameters, fit_parameter, ends_of, share_of, slope_of, t_of, value_of, y_of, &
      y_at

   !> One parameter that is sought.
   type :: fit_parameter
      !> Name, as the library calls it
      character(len=40) :: name = ''
      !> Unit, empty for none
      character(len=16) :: unit = ''
      !> Where the search begins, strictly between the bounds
      real(wp) :: start = 0.0_wp
      !> Bounds, which the search comes close to and never passes
      real(wp) :: lower = 0.0_wp, upper = 0.0_wp
      !> Varied by ratios: bounds above zero, interval symmetric in the logarithm
      logical :: by_ratio = .false.
      !> Change of a parameter that is not varied by ratios that counts as much as a factor of e of
      !> one that is; above zero
      real(wp) :: scale = 1.0_wp
   end type fit_parameter

   !> Ends of intervals of logarithms lie within what numbers can be
   real(wp), parameter :: largest_log = 700.0_wp

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
            .and. (p%lower > 0.0_wp .or. .not. p%by_ratio) .and. p%scale > 0.0_wp
         if (.not. fine) call fatal_error(error, trim(p%name)//' begins at '//to_text(p%start)// &
            ' between '//to_text(p%lower)//' and '//to_text(p%upper)//trim(' '//p%unit)// &
            ': bounds must lie below and above the beginning'// &
            trim(merge(', and above 0', '             ', p%by_ratio)), &
            subject=trim(p%name))
      end associate
   end subroutine check_parameter

   !> y of a value: itself over the scale, or its logarithm.
   elemental real(wp) function y_of(parameter, value)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its value
      real(wp), intent(in) :: value

      if (parameter%by_ratio) then
         y_of = log(value)
      else
         y_of = value/parameter%scale
      end if
   end function y_of

   !> Value of y.
   elemental real(wp) function value_of(parameter, y)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its y
      real(wp), intent(in) :: y

      if (parameter%by_ratio) then
         value_of = exp(y)
      else
         value_of = y*parameter%scale
      end if
   end function value_of

   !> y between the bounds, which it keeps to the last bit.
   elemental real(wp) function y_at(parameter, t)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Any number
      real(wp), intent(in) :: t

      associate (low => y_of(parameter, parameter%lower), high => y_of(parameter, parameter%upper))
         y_at = min(max(low + 0.5_wp*(high - low)*(1.0_wp + sin(t)), low), high)
      end associate
   end function y_at

   !> t of y between the bounds.
   elemental real(wp) function t_of(parameter, y)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its y
      real(wp), intent(in) :: y

      ! a round further than need be, as GSL measures steps over t
      t_of = 2.0_wp*pi + asin(min(max(2.0_wp*share_of(parameter, y) - 1.0_wp, -1.0_wp), 1.0_wp))
   end function t_of

   !> dy/dt.
   elemental real(wp) function slope_of(parameter, t)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Any number
      real(wp), intent(in) :: t

      slope_of = 0.5_wp*(y_of(parameter, parameter%upper) - y_of(parameter, parameter%lower))*cos(t)
   end function slope_of

   !> The way that y has come from the lower bound to the upper, 0 to 1.
   elemental real(wp) function share_of(parameter, y)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its y
      real(wp), intent(in) :: y

      associate (low => y_of(parameter, parameter%lower), high => y_of(parameter, parameter%upper))
         share_of = (y - low)/(high - low)
      end associate
   end function share_of

   !> Ends of an interval y +- half, as values.
   pure function ends_of(parameter, y, half) result(ends)
      !> The parameter
      type(fit_parameter), intent(in) :: parameter
      !> Its y, and half of the interval
      real(wp), intent(in) :: y, half
      real(wp) :: ends(2)

      ends = [y - half, y + half]
      ! the logarithm of what nothing is known of may be any number
      if (parameter%by_ratio) ends = min(max(ends, -largest_log), largest_log)
      ends = value_of(parameter, ends)
   end function ends_of

end module asperity_fit_parameter
