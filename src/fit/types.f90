!> What a fit takes besides its problem, and what it gives.
module asperity_fit_types
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: fit_result, fit_settings

   !> How the minimum is sought.
   type :: fit_settings
      !> Most iterations
      integer :: max_iterations = 100
      !> Step of differences, of t (see asperity_fit_parameter); larger for models with some noise
      real(wp) :: difference_step = 1.0e-4_wp
      !> Share of the intervals
      real(wp) :: confidence = 0.95_wp
   end type fit_settings

   !> What was found.
   type :: fit_result
      !> Values, and ends of their intervals
      real(wp), allocatable :: values(:), lower(:), upper(:)
      !> Standard errors: of the value, or of its logarithm where it is varied by ratios
      real(wp), allocatable :: standard_errors(:)
      !> Correlations
      real(wp), allocatable :: correlations(:, :)
      !> Standard errors along the directions of the parameters (values or logarithms), in columns,
      !> that the record tells apart, best known first
      real(wp), allocatable :: direction_errors(:), directions(:, :)
      !> Whether a parameter came to one of its bounds, so that its interval means nothing
      logical, allocatable :: at_bound(:)
      !> Residuals
      real(wp), allocatable :: residuals(:)
      !> Sum of their squares, there and at the start
      real(wp) :: chi_squared = 0.0_wp, start_chi_squared = 0.0_wp
      !> Residuals less parameters
      integer :: degrees_of_freedom = 0
      !> Iterations and evaluations of the model
      integer :: iterations = 0, evaluations = 0
   end type fit_result

end module asperity_fit_types
