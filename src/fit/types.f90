!> What a fit takes besides its problem, and what it gives.
module asperity_fit_types
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: fit_result, fit_settings, is_unsettled

   !> How the minimum is sought.
   type :: fit_settings
      !> Most iterations of a search
      integer :: max_iterations = 100
      !> Searches: one from the start, the others from the best of sets spread between the bounds
      integer :: searches = 1
      !> How many sets are spread for each of these
      integer :: spread_sets = 20
      !> Step of differences, over the way between the bounds; larger for models with some noise
      real(wp) :: difference_step = 1.0e-5_wp
      !> Share of the intervals
      real(wp) :: confidence = 0.95_wp
   end type fit_settings

   !> What was found. Standard errors and directions are of y: the logarithm of a parameter that is
   !> varied by ratios, else its value over its scale.
   type :: fit_result
      !> Values, and ends of their intervals
      real(wp), allocatable :: values(:), lower(:), upper(:)
      !> Standard errors
      real(wp), allocatable :: standard_errors(:)
      !> Correlations
      real(wp), allocatable :: correlations(:, :)
      !> Directions of the parameters that the record tells apart, in columns, best known first, and
      !> standard errors along them
      real(wp), allocatable :: directions(:, :), direction_errors(:)
      !> Whether the record settles a direction: its standard error is below one half, and a change
      !> along it moves the model by more than errors of the differences
      logical, allocatable :: settled(:)
      !> Whether a parameter came to one of its bounds, so that its interval means nothing
      logical, allocatable :: at_bound(:)
      !> Residuals
      real(wp), allocatable :: residuals(:)
      !> Sum of their squares, there and at the start, which is huge if the model fails at the start
      real(wp) :: chi_squared = 0.0_wp, start_chi_squared = 0.0_wp
      !> Residuals less parameters
      integer :: degrees_of_freedom = 0
      !> Searches, and how many of them came to this minimum
      integer :: searches = 0, agreeing = 0
      !> Iterations of all searches, and evaluations of the model
      integer :: iterations = 0, evaluations = 0
   end type fit_result

   !> Part of a parameter in the directions that are not settled from which it is one of those that
   !> the record does not tell
   real(wp), parameter :: named_part = 0.3_wp

contains

   !> Whether a parameter is one of those that the record does not tell.
   pure logical function is_unsettled(result, which)
      !> What was found
      type(fit_result), intent(in) :: result
      !> Which parameter
      integer, intent(in) :: which

      is_unsettled = norm2(pack(result%directions(which, :), .not. result%settled)) > named_part
   end function is_unsettled

end module asperity_fit_types
