!> A material beside the record that it stands for: peaks of both sides and energy of every cycle.
module asperity_frame_comparison
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_frame_history, only: frame_history, path_along
   use asperity_frame_material, only: frame_material
   implicit none
   private
   public :: compare_material, cycle_energy, cycle_peaks, frame_comparison, least_steps

   !> A material beside a record; arrays of two hold the positive side first.
   type :: frame_comparison
      !> Energy of each cycle, and its ratio to the record's less one; no ratio where the record has
      !> less than `small_energy` of its largest
      real(wp), allocatable :: energy(:), energy_error(:)
      !> Force at the peaks of each cycle, and its ratio to the record's less one
      real(wp), allocatable :: peak(:, :), peak_error(:, :)
      !> Largest errors, whatever their sign
      real(wp) :: largest_energy_error = 0.0_wp, largest_peak_error = 0.0_wp
      !> Root mean square of force along the record, over its largest
      real(wp) :: force_error = 0.0_wp
      !> Displacement and force of the material
      real(wp), allocatable :: displacement(:), force(:)
   end type frame_comparison

   !> Energies below this share of a cycle's largest have no ratio
   real(wp), parameter, public :: small_energy = 0.005_wp
   !> Steps of a half cycle between which energies change no more
   integer, parameter :: fine_steps = 200
   !> Energies may miss those of fine steps by this share, in `least_steps`
   real(wp), parameter :: step_error = 0.01_wp

contains

   !> Replay a material and compare.
   pure subroutine compare_material(comparison, material, history, error)
      !> What comes out
      type(frame_comparison), intent(out) :: comparison
      !> The material
      class(frame_material), intent(in) :: material
      !> The record
      type(frame_history), intent(in) :: history
      !> Set when the material has no answer
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: force(:)
      integer :: i

      allocate (force(size(history%force)))
      call material%replay(history%displacement, force, error)
      if (allocated(error)) return
      comparison%force_error = sqrt(sum((force - history%force)**2)/size(force)) &
         /history%largest_force
      comparison%displacement = path_along(history%ends, fine_steps)
      allocate (comparison%force(size(comparison%displacement)))
      call material%replay(comparison%displacement, comparison%force, error)
      if (allocated(error)) return
      comparison%energy = cycle_energy(history, comparison%displacement, comparison%force)
      comparison%peak = cycle_peaks(history, comparison%force)
      allocate (comparison%energy_error(size(comparison%energy)), source=none)
      allocate (comparison%peak_error(2, size(comparison%energy)), source=none)
      do i = 1, size(comparison%energy)
         if (history%energy(i) >= small_energy*maxval(history%energy)) &
            comparison%energy_error(i) = comparison%energy(i)/history%energy(i) - 1.0_wp
      end do
      where (.not. is_none(history%peak_force) .and. abs(history%peak_force) > 0.0_wp) &
         comparison%peak_error = comparison%peak/history%peak_force - 1.0_wp
      comparison%largest_energy_error = maxval(abs(comparison%energy_error), &
         mask=.not. is_none(comparison%energy_error))
      comparison%largest_peak_error = maxval(abs(comparison%peak_error), &
         mask=.not. is_none(comparison%peak_error))
   end subroutine compare_material

   !> Energy of each cycle along the legs of a history, by the trapezoidal rule.
   pure function cycle_energy(history, displacement, force) result(energy)
      !> The history
      type(frame_history), intent(in) :: history
      !> Displacement and force, of as many steps in each leg
      real(wp), intent(in) :: displacement(0:), force(0:)
      real(wp), allocatable :: energy(:)
      integer :: i, j, steps

      allocate (energy(size(history%energy)), source=0.0_wp)
      steps = ubound(displacement, 1)/size(history%cycle)
      do i = 1, size(history%cycle)
         associate (e => energy(history%cycle(i)))
            do j = (i - 1)*steps + 1, i*steps
               e = e + 0.5_wp*(force(j) + force(j - 1))*(displacement(j) - displacement(j - 1))
            end do
         end associate
      end do
   end function cycle_energy

   !> Force at the outermost ends of the legs of each cycle, on both sides; none without a peak.
   pure function cycle_peaks(history, force) result(peak)
      !> The history
      type(frame_history), intent(in) :: history
      !> Force, of as many steps in each leg
      real(wp), intent(in) :: force(0:)
      real(wp), allocatable :: peak(:, :)
      real(wp) :: furthest(2, size(history%energy))
      integer :: i, side, steps

      allocate (peak(2, size(history%energy)), source=none)
      furthest = 0.0_wp
      steps = ubound(force, 1)/size(history%cycle)
      do i = 1, size(history%cycle)
         associate (c => history%cycle(i), x => history%ends(i))
            side = merge(1, 2, x > 0.0_wp)
            if (is_none(history%peak_force(side, c))) cycle
            if (.not. abs(x) > furthest(side, c)) cycle
            furthest(side, c) = abs(x)
            peak(side, c) = force(i*steps)
         end associate
      end do
   end function cycle_peaks

   !> The fewest steps of a half cycle that give every cycle's energy to 1 % of that by fine ones.
   pure integer function least_steps(comparison, material, history) result(steps)
      !> The comparison by fine steps
      type(frame_comparison), intent(in) :: comparison
      !> The material
      class(frame_material), intent(in) :: material
      !> The record
      type(frame_history), intent(in) :: history
      type(error_type), allocatable :: error
      real(wp), allocatable :: displacement(:), force(:)

      do steps = 5, fine_steps - 5, 5
         allocate (displacement, source=path_along(history%ends, steps))
         allocate (force(size(displacement)))
         call material%replay(displacement, force, error)
         if (allocated(error)) exit
         if (all(abs(cycle_energy(history, displacement, force) - comparison%energy) &
            <= step_error*abs(comparison%energy) .or. is_none(comparison%energy_error))) return
         deallocate (displacement, force)
      end do
      steps = fine_steps
   end function least_steps

end module asperity_frame_comparison
