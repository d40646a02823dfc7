!> Samples of a record that cannot be what the test did: outliers, gaps in sampling, a zero that is
!> none.
!>
!> A step is judged by those beside it, as sampling may be uneven and a programme's speed may
!> change: its measure is the median of the steps that are not zero in a window before it, or in one
!> after it, or 0.3 of the largest of the nearest, whichever is larger. Noise moves medians and
!> steps alike, ringing makes several large steps, and a brittle drop does not come back, so none of
!> them is taken for an outlier.
module asperity_hysteresis_samples
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_types, only: record_gap, record_outlier
   implicit none
   private
   public :: displacement_noise, find_outliers, find_gaps, find_zeros, leave_out

   !> Steps in a window, and the nearest of them
   integer, parameter :: window = 12, nearest = 4
   !> Share of the largest of the nearest steps
   real(wp), parameter :: largest_share = 0.3_wp
   !> A gap, or an outlier, is so many times the steps beside it. Noise does not come there: the
   !> median of its steps is about its standard deviation
   real(wp), parameter :: gap_times = 10.0_wp, outlier_times = 20.0_wp
   !> ... and larger than this share of the record's range, below which it matters little
   real(wp), parameter :: least_share = 0.02_wp
   !> The samples on both sides of an outlier agree within this share of its height
   real(wp), parameter :: agreement = 0.2_wp
   !> Samples that tell noise at most, and at least
   integer, parameter :: most_told = 1000, least_told = 500
   !> Share of steps of a noisy record that turn: 2/3 in noise alone, none on a smooth way, all
   !> where only the tips of cycles are given
   real(wp), parameter :: least_turning = 0.3_wp, most_turning = 0.8_wp
   !> Median of the distance of a sample from the mean of its neighbours over the standard deviation
   !> of Gaussian noise: 0.6745 root 1.5
   real(wp), parameter :: median_distance = 0.826_wp
   !> A record whose first displacement is so far out, as a share of its range, does not begin at
   !> zero
   real(wp), parameter :: away = 0.02_wp
   !> No force, and force at the beginning: as shares of the largest
   real(wp), parameter :: no_force = 0.02_wp, some_force = 0.05_wp

contains

   !> Single samples of displacement or of force that leap away and back. Force does so at the tips
   !> of slack loops as well, so it must not do so where the displacement turns.
   pure subroutine find_outliers(displacement, force, outliers)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> The outliers of displacement, then those of force
      type(record_outlier), allocatable, intent(out) :: outliers(:)
      integer, allocatable :: x(:), f(:)
      integer :: i

      call find_leaps(displacement, x)
      call find_leaps(force, f)
      f = pack(f, goes_on(displacement, f))
      allocate (outliers(size(x) + size(f)))
      do i = 1, size(x)
         outliers(i) = record_outlier(x(i), 'displacement', displacement(x(i)))
      end do
      do i = 1, size(f)
         outliers(size(x) + i) = record_outlier(f(i), 'force', force(f(i)))
      end do
   end subroutine find_outliers

   !> Samples of one quantity that leap away and back. The range is that of the samples that remain,
   !> so that a large one hides no smaller one.
   pure subroutine find_leaps(values, leaps)
      real(wp), intent(in) :: values(:)
      integer, allocatable, intent(out) :: leaps(:)
      real(wp), allocatable :: rest(:)
      logical :: is_leap(size(values))
      real(wp) :: out, back
      integer :: i, found

      is_leap = .false.
      allocate (rest, source=values)
      do
         found = 0
         associate (least => least_share*(maxval(rest) - minval(rest)))
            do i = 2, size(rest) - 1
               if (is_leap(i)) cycle
               out = rest(i) - rest(i - 1)
               back = rest(i) - rest(i + 1)
               if (.not. min(abs(out), abs(back)) > least) cycle
               if (.not. out*sign(1.0_wp, back) > 0.0_wp) cycle
               if (abs(out - back) > agreement*min(abs(out), abs(back))) cycle
               if (.not. min(abs(out), abs(back)) > outlier_times*usual_step(rest, i - 1, i + 1)) &
                  cycle
               is_leap(i) = .true.
               found = found + 1
               rest(i) = 0.5_wp*(rest(i - 1) + rest(i + 1))
            end do
         end associate
         if (found == 0) exit
      end do
      leaps = pack([(i, i=1, size(values))], is_leap)
   end subroutine find_leaps

   !> Whether the displacement goes on in one direction, or stands still, at samples that are
   !> neither the first nor the last.
   pure function goes_on(displacement, samples)
      real(wp), intent(in) :: displacement(:)
      integer, intent(in) :: samples(:)
      logical :: goes_on(size(samples))
      integer :: i

      do i = 1, size(samples)
         associate (k => samples(i), last => size(displacement))
            goes_on(i) = (displacement(k) - displacement(max(1, k - 2))) &
               *(displacement(min(last, k + 2)) - displacement(k)) >= 0.0_wp
         end associate
      end do
   end function goes_on

   !> Put the mean of its neighbours for a sample in both quantities, which gives the same work and
   !> the same curve as leaving it out, and keeps the numbers of the samples.
   pure subroutine leave_out(outliers, displacement, force)
      !> What was found
      type(record_outlier), intent(in) :: outliers(:)
      !> The record
      real(wp), intent(inout) :: displacement(:), force(:)
      integer :: i

      do i = 1, size(outliers)
         associate (k => outliers(i)%sample)
            displacement(k) = 0.5_wp*(displacement(k - 1) + displacement(k + 1))
            force(k) = 0.5_wp*(force(k - 1) + force(k + 1))
         end associate
      end do
   end subroutine leave_out

   !> Steps of displacement far larger than those before and after them.
   pure subroutine find_gaps(displacement, gaps)
      !> Displacement, outliers left out
      real(wp), intent(in) :: displacement(:)
      !> The gaps
      type(record_gap), allocatable, intent(out) :: gaps(:)
      logical :: is_gap(size(displacement) - 1)
      integer, allocatable :: places(:)
      integer :: i

      is_gap = .false.
      associate (least => least_share*(maxval(displacement) - minval(displacement)))
         do i = 1, size(is_gap)
            associate (step => abs(displacement(i + 1) - displacement(i)))
               if (.not. step > least) cycle
               is_gap(i) = step > gap_times*usual_step(displacement, i, i + 1)
            end associate
         end do
      end associate
      places = pack([(i, i=1, size(is_gap))], is_gap)
      allocate (gaps(size(places)))
      do i = 1, size(places)
         gaps(i) = record_gap(places(i), &
            abs(displacement(places(i) + 1) - displacement(places(i))))
      end do
   end subroutine find_gaps

   !> Measure of the steps before one sample and after another. Very large where there are too few
   !> to judge by.
   pure real(wp) function usual_step(values, before, after)
      real(wp), intent(in) :: values(:)
      integer, intent(in) :: before, after

      associate (early => values(max(1, before - window):before), &
            late => values(after:min(size(values), after + window)))
         usual_step = max(median_step(early), median_step(late), largest_share*max( &
            largest_step(early(max(1, size(early) - nearest):)), &
            largest_step(late(:min(size(late), 1 + nearest)))))
      end associate
      if (.not. usual_step > 0.0_wp) usual_step = huge(1.0_wp)/outlier_times
   end function usual_step

   pure real(wp) function largest_step(values)
      real(wp), intent(in) :: values(:)
      integer :: i

      largest_step = 0.0_wp
      do i = 1, size(values) - 1
         largest_step = max(largest_step, abs(values(i + 1) - values(i)))
      end do
   end function largest_step

   !> Standard deviation of the noise of displacement; zero where a record is too short to tell, or
   !> its steps do not turn as those of noise.
   pure real(wp) function displacement_noise(displacement)
      !> Displacement, outliers left out
      real(wp), intent(in) :: displacement(:)
      real(wp) :: distances(most_told)
      integer :: i, j, n, turning

      displacement_noise = 0.0_wp
      if (size(displacement) < least_told) return
      n = min(most_told, size(displacement) - 2)
      turning = 0
      do i = 1, n
         j = 2 + int(real(i - 1, wp)*(real(size(displacement) - 3, wp)/real(n - 1, wp)))
         associate (before => displacement(j) - displacement(j - 1), &
               after => displacement(j + 1) - displacement(j))
            if (min(before, after) < 0.0_wp .and. max(before, after) > 0.0_wp) turning = turning + 1
            distances(i) = 0.5_wp*abs(after - before)
         end associate
      end do
      associate (share => real(turning, wp)/real(n, wp))
         if (share < least_turning .or. share > most_turning) return
      end associate
      displacement_noise = median(distances(:n))/median_distance
   end function displacement_noise

   !> Median of the sizes of steps that are not zero; zero when there is none.
   pure real(wp) function median_step(values)
      real(wp), intent(in) :: values(:)
      real(wp) :: steps(max(0, size(values) - 1))

      steps = abs(values(2:) - values(:size(steps)))
      median_step = median(pack(steps, steps > 0.0_wp))
   end function median_step

   !> Median of a few numbers, zero of none.
   pure real(wp) function median(values)
      real(wp), intent(in) :: values(:)
      real(wp) :: sorted(size(values))
      integer :: i, j

      do i = 1, size(values)
         ! into its place among those before
         do j = i - 1, 1, -1
            if (sorted(j) <= values(i)) exit
            sorted(j + 1) = sorted(j)
         end do
         sorted(j + 1) = values(i)
      end do
      median = 0.0_wp
      if (size(values) > 0) &
         median = 0.5_wp*(sorted((size(values) + 1)/2) + sorted((size(values) + 2)/2))
   end function median

   !> Whether the record begins away from zero without force, or at zero with force.
   pure subroutine find_zeros(displacement, force, threshold, unloaded_displacement, loaded_force)
      !> The record, outliers left out
      real(wp), intent(in) :: displacement(:), force(:)
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> First displacement or force; left alone where there is nothing to say
      real(wp), intent(inout) :: unloaded_displacement, loaded_force
      real(wp) :: largest

      largest = maxval(abs(force))
      if (abs(displacement(1)) > max(threshold, away*(maxval(displacement) &
         - minval(displacement)))) then
         if (abs(force(1)) <= no_force*largest) unloaded_displacement = displacement(1)
      else if (abs(force(1)) > some_force*largest) then
         loaded_force = force(1)
      end if
   end subroutine find_zeros

end module asperity_hysteresis_samples
