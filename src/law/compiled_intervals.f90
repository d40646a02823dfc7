!> Intervals of h = d/sigma, or of the Gaussian number that belongs to d, that the compiled law has
!> a polynomial each for.
module asperity_law_compiled_intervals
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: intervals_below, place_interval

   !> Ends of the three ranges of h, and intervals per unit of h in each
   real(wp), parameter, public :: first = -8.0_wp, last = 38.0_wp
   real(wp), parameter :: second = 2.0_wp
   !> Up to here from the mean plane the error is below 1e-10, beyond below 1e-9
   real(wp), parameter, public :: precise_reach = 8.0_wp
   integer, parameter :: coarse = 5, fine = 21
   real(wp), parameter :: far = 1.5_wp
   !> Of heights that are not Gaussian the law has more detail: as many intervals, all of one width,
   !> between these
   real(wp), parameter, public :: first_of_johnson = -3.5_wp, last_of_johnson = 8.0_wp
   !> Number of intervals: in the first two ranges, and in all
   integer, parameter, public :: n_near = &
      nint((second - first)*coarse + (precise_reach - second)*fine)
   integer, parameter, public :: n_all = n_near + nint((last - precise_reach)*far)

contains

   !> Middle and half width of an interval of h.
   pure subroutine place_interval(i, is_gaussian, middle, half_width)
      !> Its number, 1 to `n_all`
      integer, intent(in) :: i
      !> Whether heights are Gaussian
      logical, intent(in) :: is_gaussian
      !> Both of h
      real(wp), intent(out) :: middle, half_width
      integer, parameter :: n_first = nint((second - first)*coarse)

      if (.not. is_gaussian) then
         half_width = 0.5_wp*(last_of_johnson - first_of_johnson)/n_all
         middle = first_of_johnson + half_width*(2*i - 1)
      else if (i <= n_first) then
         half_width = 0.5_wp/coarse
         middle = first + half_width*(2*i - 1)
      else if (i <= n_near) then
         half_width = 0.5_wp/fine
         middle = second + half_width*(2*(i - n_first) - 1)
      else
         half_width = 0.5_wp/far
         middle = precise_reach + half_width*(2*(i - n_near) - 1)
      end if
   end subroutine place_interval

   !> Number of intervals that lie below h, with a fraction.
   pure elemental real(wp) function intervals_below(h, is_gaussian)
      !> The variable
      real(wp), intent(in) :: h
      !> Whether heights are Gaussian
      logical, intent(in) :: is_gaussian

      if (.not. is_gaussian) then
         intervals_below = (h - first_of_johnson)*(n_all/(last_of_johnson - first_of_johnson))
         return
      end if
      intervals_below = (min(h, second) - first)*coarse &
         + min(max(h - second, 0.0_wp), precise_reach - second)*fine &
         + max(h - precise_reach, 0.0_wp)*far
   end function intervals_below

end module asperity_law_compiled_intervals
