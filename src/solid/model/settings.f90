!> How a solid joint is solved: strain, contact, tolerances, steps. Nothing of it is in the paper.
module asperity_solid_model_settings
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_deck_tenon_sets, only: holding_stiffness
   use asperity_solid_contact_hard, only: default_penalty, default_soft_overclosure
   use asperity_solid_contact_pair, only: default_cells, default_search_distance
   implicit none
   private
   public :: solid_settings, check_solid_settings

   !> Choices of the analysis.
   type :: solid_settings
      !> Whether wood's strain is logarithmic, not engineering strain
      logical :: is_logarithmic = .false.
      !> Contact points along each edge of a face; two are 1 % softer at 60 mm, five change nothing
      integer :: cells = default_cells
      !> Pressure of hard contact over penetration, MPa/mm, beyond a soft start of
      !> `soft_overclosure`, mm: 0.05 mm at 50 MPa; ten times as much changes the force by 0.3 %
      real(wp) :: penalty = default_penalty, soft_overclosure = default_soft_overclosure
      !> Gap up to which faces opposite are known to the matrix before they touch, mm
      real(wp) :: search_distance = default_search_distance
      !> Spring in z at the end of the tenon, N/mm, that holds the joint while it is open: nothing
      !> beside wood
      real(wp) :: holding_stiffness = holding_stiffness
      !> Whether every contact point is run through UINTER
      logical :: through_uinter = .false.
      !> Residual over the forces of contact and load at which an increment is solved
      real(wp) :: tolerance = 1.0e-3_wp
      !> Residual that GMRES leaves, over that of the iteration
      real(wp) :: forcing = 1.0e-2_wp
      !> Whether multigrid preconditions GMRES, and not factors
      logical :: uses_multigrid = .false.
      !> Most iterations of an increment
      integer :: most_iterations = 16
      !> Fewest increments of a stroke; twice as many beyond `large_amplitude`
      integer :: stroke_increments = 10
   end type solid_settings

   !> Least tolerance: below it is rounding
   real(wp), parameter :: least_tolerance = 1.0e-12_wp
   !> Amplitude beyond which a stroke takes twice as many increments, mm
   real(wp), parameter, public :: large_amplitude = 16.5_wp
   !> Increments in which the beam swells between the sides
   integer, parameter, public :: fit_increments = 5
   !> An increment solved in so many iterations lets the next one be longer, by this factor; one
   !> that takes all but a few of `most_iterations`, and more than half of them, makes it shorter
   integer, parameter, public :: easy_iterations = 6, few_iterations = 4
   real(wp), parameter, public :: growth = 1.5_wp, shrinkage = 0.7_wp
   !> Shortest increment, over the stroke
   real(wp), parameter, public :: shortest_increment = 1.0e-5_wp

contains

   !> `error` is set when a setting is refused.
   pure subroutine check_solid_settings(settings, error)
      !> Settings
      type(solid_settings), intent(in) :: settings
      !> Set when one of them is refused
      type(error_type), allocatable, intent(out) :: error

      associate (s => settings)
         call check_range(error, 'contact_cells', real(s%cells, wp), 1.0_wp, 10.0_wp, '')
         if (.not. allocated(error)) call check_positive(error, 'penalty', s%penalty, 'MPa/mm')
         if (.not. allocated(error)) &
            call check_range(error, 'soft_overclosure', s%soft_overclosure, 0.0_wp, 1.0_wp, ' mm')
         if (.not. allocated(error)) &
            call check_range(error, 'search_distance', s%search_distance, 0.0_wp, 1.0e3_wp, ' mm')
         if (.not. allocated(error)) &
            call check_positive(error, 'holding_stiffness', s%holding_stiffness, 'N/mm')
         if (.not. allocated(error)) &
            call check_range(error, 'tolerance', s%tolerance, least_tolerance, 0.1_wp, '')
         if (.not. allocated(error)) &
            call check_range(error, 'forcing', s%forcing, 1.0e-12_wp, 0.5_wp, '')
         if (.not. allocated(error)) call check_range(error, 'most_iterations', &
            real(s%most_iterations, wp), 4.0_wp, 1000.0_wp, '')
         if (.not. allocated(error)) call check_range(error, 'stroke_increments', &
            real(s%stroke_increments, wp), 1.0_wp, 10000.0_wp, '')
      end associate
   end subroutine check_solid_settings

end module asperity_solid_model_settings
