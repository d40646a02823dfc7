!> Post-processing of displacement-force records, measured or computed: kind, cycles, skeleton,
!> yield and ultimate point, stiffness, energy, damping. Rotation and moment may stand for the two.
module asperity_hysteresis_analysis
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_amplitudes, only: find_amplitudes
   use asperity_hysteresis_cycles, only: find_peaks, measure_cycles
   use asperity_hysteresis_en_12512, only: evaluate_en_12512
   use asperity_hysteresis_en_26891, only: evaluate_en_26891
   use asperity_hysteresis_mean_skeletons, only: new_mean_skeleton
   use asperity_hysteresis_record_kinds, only: classify
   use asperity_hysteresis_samples, only: displacement_noise, find_gaps, find_outliers, &
      find_zeros, leave_out
   use asperity_hysteresis_skeletons, only: evaluate_skeleton, new_skeleton
   use asperity_hysteresis_turning_points, only: cut_cycles, find_turning_points
   use asperity_hysteresis_types, only: check_hysteresis_settings, en_12512_numbers, &
      en_26891_numbers, hysteresis_amplitude, hysteresis_cycle, hysteresis_result, &
      hysteresis_settings, hysteresis_skeleton, largest_value, negative_side, positive_side, &
      record_gap, record_outlier, round_off_share
   implicit none
   private
   public :: analyse_hysteresis, leave_out
   public :: hysteresis_cycle, hysteresis_result, hysteresis_settings, hysteresis_skeleton
   public :: en_12512_numbers, en_26891_numbers, hysteresis_amplitude, record_gap, record_outlier
   public :: check_hysteresis_settings, negative_side, positive_side

   !> Default threshold over the record's range of displacement, over the standard deviation of
   !> noise if that is more, and the most that noise makes of it over the range
   real(wp), parameter :: default_threshold = 1.0_wp/400.0_wp, noise_threshold = 8.0_wp, &
      most_threshold = 1.0_wp/40.0_wp
   integer, parameter :: fewest_points = 3
   !> Bytes that the analysis takes for each sample at most: the record without outliers 16, both
   !> skeletons 48, their mean 48, work 48
   integer(int64), parameter :: bytes_of_sample = 160

contains

   !> Analyse a record. Its samples need not be evenly spaced, may stand still, and need not end
   !> where they began.
   pure subroutine analyse_hysteresis(displacement, force, result, error, settings)
      !> Displacement, or rotation, of each sample
      real(wp), intent(in) :: displacement(:)
      !> Force, or moment, of each sample
      real(wp), intent(in) :: force(:)
      !> What was found
      type(hysteresis_result), intent(out) :: result
      !> Set when the record or a setting is refused, or there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      !> How to read the record
      type(hysteresis_settings), intent(in), optional :: settings
      type(hysteresis_settings) :: s
      real(wp), allocatable :: x(:), f(:)

      if (present(settings)) s = settings
      call check_hysteresis_settings(s, error)
      if (.not. allocated(error)) call check_record(displacement, force, s, error)
      if (.not. allocated(error)) call check_size(size(force), 0, error)
      if (allocated(error)) return
      call find_outliers(displacement, force, result%outliers)
      if (size(result%outliers) > 0 .and. s%outliers == 'drop') then
         allocate (x, source=displacement)
         allocate (f, source=force)
         call leave_out(result%outliers, x, f)
         call analyse_samples(x, f, s, result, error)
      else
         call analyse_samples(displacement, force, s, result, error)
      end if
   end subroutine analyse_hysteresis

   !> Analyse the samples that count.
   pure subroutine analyse_samples(displacement, force, s, result, error)
      real(wp), intent(in) :: displacement(:), force(:)
      type(hysteresis_settings), intent(in) :: s
      type(hysteresis_result), intent(inout) :: result
      type(error_type), allocatable, intent(inout) :: error
      real(wp) :: force_floor
      logical :: sides(2)
      integer :: i, side

      result%displacement_noise = displacement_noise(displacement)
      result%threshold = s%threshold
      if (.not. s%threshold > 0.0_wp) then
         associate (range => maxval(displacement) - minval(displacement))
            result%threshold = default_threshold*range
            result%noise_sets_threshold = &
               noise_threshold*result%displacement_noise > result%threshold
            if (result%noise_sets_threshold) result%threshold = &
               min(noise_threshold*result%displacement_noise, most_threshold*range)
         end associate
      end if
      force_floor = max(s%force_floor, round_off_share*maxval(abs(force)))
      call find_gaps(displacement, result%gaps)
      call find_zeros(displacement, force, result%threshold, result%unloaded_displacement, &
         result%loaded_force)
      call find_turning_points(displacement, result%threshold, result%turning_points)
      if (size(result%turning_points) == 0) then
         call fatal_error(error, 'displacement changes by no more than '// &
            to_text(maxval(displacement) - minval(displacement), 4)// &
            ' in the whole record, which is within the threshold of '// &
            to_text(result%threshold, 4))
         return
      end if
      if (.not. is_none(result%unloaded_displacement)) then
         ! the sides of a displaced record say nothing
         call classify(displacement - result%unloaded_displacement, force, result%threshold, &
            result%turning_points, result%record_kind, sides)
         sides = .true.
      else
         call classify(displacement, force, result%threshold, result%turning_points, &
            result%record_kind, sides)
      end if
      call check_size(size(force), size(result%turning_points), error)
      if (allocated(error)) return
      call cut_cycles(displacement, force, result%threshold, result%turning_points, result%cycles)
      do i = 1, size(result%cycles)
         call find_peaks(displacement, force, result%threshold, sides, s%peaks == 'force', &
            result%cycles(i))
      end do
      call measure_cycles(displacement, force, result%threshold, force_floor, result%cycles)
      call check_signs(result%cycles, force_floor, error)
      if (allocated(error)) return
      do side = positive_side, negative_side
         call new_skeleton(displacement, force, side, result%threshold, s, result%cycles, &
            result%skeleton(side))
         call evaluate_skeleton(side, s, result%threshold, force_floor, result%skeleton(side))
      end do
      call new_mean_skeleton(result%skeleton, result%mean_skeleton)
      call evaluate_skeleton(positive_side, s, result%threshold, force_floor, result%mean_skeleton)
      call find_amplitudes(result%cycles, s%amplitude_tolerance, result%amplitudes)
      do side = positive_side, negative_side
         call evaluate_en_12512(side, s, result%threshold, force_floor, result%amplitudes, &
            result%skeleton(side))
      end do
      call evaluate_en_12512(positive_side, s, result%threshold, force_floor, &
         result%amplitudes(:0), result%mean_skeleton)
      if (result%record_kind(:9) /= 'monotonic') return
      side = merge(negative_side, positive_side, is_none(result%skeleton(1)%peak_force))
      call evaluate_en_26891(displacement, force, side, s, result%skeleton(side), result%en_26891)
   end subroutine analyse_samples

   !> Set `error` unless there is memory for an analysis.
   pure subroutine check_size(samples, turns, error)
      !> Samples, and the turning points of cycles, of which there may be one each
      integer, intent(in) :: samples, turns
      type(error_type), allocatable, intent(inout) :: error
      type(hysteresis_cycle) :: one
      integer(int64) :: bytes_of_cycle

      bytes_of_cycle = storage_size(one)/8
      call check_work('the analysis of '//to_text(samples)//' samples', &
         bytes_of_sample*samples + bytes_of_cycle*turns, error)
   end subroutine check_size

   !> Refuse what is no record.
   pure subroutine check_record(displacement, force, settings, error)
      real(wp), intent(in) :: displacement(:), force(:)
      type(hysteresis_settings), intent(in) :: settings
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (size(displacement) /= size(force)) then
         call fatal_error(error, 'the record has '//to_text(size(displacement))// &
            ' displacements but '//to_text(size(force))//' forces')
      else if (size(force) < fewest_points) then
         call fatal_error(error, 'the record is too short: '//to_text(size(force))// &
            ' samples, and '//to_text(fewest_points)//' are needed')
      end if
      do i = 1, size(force)
         if (allocated(error)) return
         call check_number(error, 'displacement', i, displacement(i))
         if (.not. allocated(error)) call check_number(error, 'force', i, force(i))
      end do
      if (allocated(error)) return
      if (.not. maxval(displacement) > minval(displacement)) then
         call fatal_error(error, 'displacement is '//to_text(displacement(1), 6)// &
            ' in every sample: the record does not move')
      else if (.not. (maxval(abs(force)) > 0.0_wp .or. settings%force_floor > 0.0_wp)) then
         call fatal_error(error, 'force is zero in every sample')
      else if (maxval(abs(displacement)) < 1.0_wp/largest_value) then
         call fatal_error(error, 'displacement is below 1e-100 in every sample: check its unit')
      else if (maxval(abs(force)) > 0.0_wp .and. maxval(abs(force)) < 1.0_wp/largest_value) then
         call fatal_error(error, 'force is below 1e-100 in every sample: check its unit')
      end if
   end subroutine check_record

   !> Refuse a number that is not finite or too large.
   pure subroutine check_number(error, name, sample, value)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      integer, intent(in) :: sample
      real(wp), intent(in) :: value

      if (is_finite(value)) then
         if (abs(value) < largest_value) return
      end if
      call fatal_error(error, name//' = '//to_text(value)//' in sample '//to_text(sample)// &
         ' is not a number below 1e100 in size', subject=name)
   end subroutine check_number

   !> Refuse a record without a peak, or whose forces point against the displacement: at the peaks,
   !> and so that the test gives energy back. At the end of a test the force of a peak may be below
   !> zero.
   pure subroutine check_signs(cycles, force_floor, error)
      type(hysteresis_cycle), intent(in) :: cycles(:)
      real(wp), intent(in) :: force_floor
      type(error_type), allocatable, intent(inout) :: error
      real(wp) :: product
      logical :: loaded
      integer :: i, side, peaks

      product = 0.0_wp
      peaks = 0
      loaded = .false.
      do i = 1, size(cycles)
         do side = positive_side, negative_side
            if (cycles(i)%peak(side) == 0) cycle
            peaks = peaks + 1
            product = product + cycles(i)%displacement(side)*cycles(i)%force(side)
            loaded = loaded .or. abs(cycles(i)%force(side)) > force_floor
         end do
      end do
      if (peaks == 0) then
         call fatal_error(error, 'displacement comes no further from zero than the threshold')
      else if (loaded .and. .not. product > 0.0_wp .and. &
         .not. cycles(size(cycles))%cumulative_energy > 0.0_wp) then
         call fatal_error(error, 'force points against the displacement at the peaks of '// &
            'the record: turn the sign of one of them')
      end if
   end subroutine check_signs

end module asperity_hysteresis_analysis
