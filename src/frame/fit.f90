!> Fit a material of a frame program to a cyclic record: its force along the record, the peaks of
!> both sides and the energy of every cycle.
module asperity_frame_fit
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_problem, only: fit_problem
   use asperity_fit_types, only: fit_result, fit_settings
   use asperity_frame_comparison, only: cycle_energy, cycle_peaks, small_energy
   use asperity_frame_history, only: frame_history
   use asperity_frame_material, only: frame_material
   implicit none
   private
   public :: fit_material

   !> A material beside the record.
   type, extends(fit_problem) :: material_problem
      !> The material, of any numbers
      class(frame_material), allocatable :: material
      !> The record
      type(frame_history) :: history
   contains
      procedure :: residuals => material_residuals
   end type material_problem

   !> What errors count as one: of force, over the record's largest; of a cycle's energy and of its
   !> peaks, which are the goal
   real(wp), parameter :: force_scale = 0.1_wp, energy_scale = 0.05_wp, peak_scale = 0.03_wp
   !> Steps of differences, one search after the other: the force has kinks, which large ones pass
   !> over
   real(wp), parameter :: steps(3) = [2.0e-2_wp, 2.0e-3_wp, 2.0e-4_wp]

contains

   !> Fit a material. Of several starts the best end is taken.
   subroutine fit_material(material, history, chi_squared, error)
      !> The material; its numbers are set
      class(frame_material), intent(inout) :: material
      !> The record
      type(frame_history), intent(in) :: history
      !> Sum of squared errors, over what counts as one
      real(wp), intent(out) :: chi_squared
      !> Set when no start leads anywhere
      type(error_type), allocatable, intent(out) :: error
      type(material_problem) :: problem
      type(fit_parameter), allocatable :: parameters(:)
      type(fit_settings) :: settings
      type(fit_result) :: result
      type(error_type), allocatable :: failure
      real(wp), allocatable :: best(:)
      integer :: start, round, n

      problem%history = history
      n = size(history%force) + 3*size(history%energy)
      settings%max_iterations = 150
      chi_squared = huge(1.0_wp)
      start = 0
      do
         start = start + 1
         call material%parameters(history, start, parameters)
         if (size(parameters) == 0) exit
         if (allocated(problem%material)) deallocate (problem%material)
         allocate (problem%material, source=material)
         do round = 1, size(steps)
            settings%difference_step = steps(round)
            call fit_least_squares(problem, n, parameters, settings, result, failure)
            ! what counts is how good the values are, which is told beside them, not whether they
            ! could be a little better
            if (.not. allocated(result%values)) exit
            if (.not. result%start_chi_squared < huge(1.0_wp)) exit
            if (.not. is_finite(result%chi_squared)) exit
            parameters%start = inside(parameters, result%values)
            if (result%chi_squared >= chi_squared) cycle
            chi_squared = result%chi_squared
            best = result%values
         end do
      end do
      if (allocated(best)) then
         call material%apply(best)
      else
         call fatal_error(error, 'no numbers of the material follow the record', computation_error)
         if (allocated(failure)) error%message = error%message//': '//failure%message
      end if
   end subroutine fit_material

   !> Values strictly between the bounds, to begin at.
   elemental real(wp) function inside(parameter, value)
      type(fit_parameter), intent(in) :: parameter
      real(wp), intent(in) :: value

      associate (margin => 1.0e-6_wp*(parameter%upper - parameter%lower))
         inside = min(max(value, parameter%lower + margin), parameter%upper - margin)
         if (parameter%by_ratio) inside = min(max(value, parameter%lower*(1.0_wp + 1.0e-6_wp)), &
            parameter%upper/(1.0_wp + 1.0e-6_wp))
      end associate
   end function inside

   !> Errors of force, of energies and of peaks.
   recursive subroutine material_residuals(self, values, residuals, error)
      !> The problem
      class(material_problem), intent(in) :: self
      !> Values of the parameters
      real(wp), intent(in) :: values(:)
      !> One for each step, each cycle, and each peak
      real(wp), intent(out) :: residuals(:)
      !> Set when the material has no answer
      type(error_type), allocatable, intent(out) :: error
      class(frame_material), allocatable :: material
      real(wp), allocatable :: force(:), energy(:), peak(:, :), off(:, :)
      integer :: n, m

      allocate (material, source=self%material)
      call material%apply(values)
      associate (h => self%history)
         n = size(h%force)
         m = size(h%energy)
         allocate (force(n))
         call material%replay(h%displacement, force, error)
         if (allocated(error)) return
         allocate (energy, source=cycle_energy(h, h%displacement, force))
         allocate (peak, source=cycle_peaks(h, force))
         residuals(:n) = (force - h%force)/(force_scale*h%largest_force*sqrt(real(n, wp)))
         residuals(n + 1:n + m) = (energy - h%energy) &
            /(energy_scale*max(abs(h%energy), small_energy*maxval(abs(h%energy))) &
            *sqrt(real(m, wp)))
         allocate (off(2, m), source=0.0_wp)
         where (.not. is_none(peak) .and. .not. is_none(h%peak_force) &
            .and. abs(h%peak_force) > 0.0_wp) &
            off = (peak - h%peak_force)/(peak_scale*abs(h%peak_force)*sqrt(real(m, wp)))
         residuals(n + m + 1:) = reshape(off, [2*m])
      end associate
   end subroutine material_residuals

end module asperity_frame_fit
