!> How wide the gap is between a rough face, or the sum of two, and a rigid plane that just touches
!> its highest point.
module asperity_surface_pair_first_touch_gap
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   implicit none
   private
   public :: gap_distribution, find_gap

   !> Bins over the range of heights: quantiles are found to 1/65536 of it, and better as a rule, as
   !> gaps are taken to spread evenly within a bin
   integer, parameter :: n_bins = 65536
   !> Bins of the histogram that is kept
   integer, parameter :: n_kept = 64

   !> Distribution of the gap at first touch.
   type :: gap_distribution
      !> Distance of the mean plane of the heights from the touching plane, mm: the mean gap
      real(wp) :: mean = 0.0_wp
      !> Standard deviation of the gap and its largest value, mm
      real(wp) :: sigma = 0.0_wp, largest = 0.0_wp
      !> Shares asked for, and the gap that so large a share of the area does not exceed, mm
      real(wp), allocatable :: shares(:), quantiles(:)
      !> Histogram: upper end of each of 64 bins, mm, and probability density in it, 1/mm
      real(wp), allocatable :: ends(:), density(:)
   end type gap_distribution

contains

   !> Find the distribution, over the measured points.
   pure subroutine find_gap(map, shares, gap, error)
      !> Heights, mm, positive towards the plane
      type(height_map), intent(in) :: map
      !> Shares of the area, 0 to 1
      real(wp), intent(in) :: shares(:)
      !> The distribution
      type(gap_distribution), intent(out) :: gap
      !> Set when no point was measured, or a share is none
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: counts(:)
      real(wp) :: lowest, highest, points, first, second, width
      integer :: i, j, bin
      logical :: are_shares

      are_shares = all_finite(shares)
      if (are_shares) are_shares = all(shares >= 0.0_wp .and. shares <= 1.0_wp)
      if (.not. are_shares) then
         call fatal_error(error, 'shares of the gap must be from 0 to 1')
         return
      end if
      highest = -huge(1.0_wp)
      lowest = huge(1.0_wp)
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (map%heights(i, j) >= none) cycle
            highest = max(highest, map%heights(i, j))
            lowest = min(lowest, map%heights(i, j))
         end do
      end do
      if (lowest > highest) then
         call fatal_error(error, map%source//': every point is missing, there is no gap')
         return
      end if
      allocate (counts(n_bins), source=0)
      width = (highest - lowest)/n_bins
      points = 0.0_wp
      first = 0.0_wp
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (map%heights(i, j) >= none) cycle
            associate (g => highest - map%heights(i, j))
               bin = 1
               if (width > 0.0_wp) bin = min(n_bins, 1 + int(g/width))
               counts(bin) = counts(bin) + 1
               points = points + 1.0_wp
               first = first + g
            end associate
         end do
      end do
      gap%mean = first/points
      gap%largest = highest - lowest
      gap%shares = shares
      gap%quantiles = [(quantile(counts, width, points*shares(i)), i=1, size(shares))]
      gap%ends = gap%largest/n_kept*[(real(i, wp), i=1, n_kept)]
      allocate (gap%density(n_kept), source=0.0_wp)
      if (.not. width > 0.0_wp) return
      do i = 1, n_kept
         j = n_bins/n_kept
         gap%density(i) = sum(real(counts((i - 1)*j + 1:i*j), wp))/(points*gap%largest/n_kept)
      end do
      second = 0.0_wp
      do j = 1, size(map%heights, 2)
         second = second + sum((highest - map%heights(:, j) - gap%mean)**2, &
            mask=map%heights(:, j) < none)
      end do
      gap%sigma = sqrt(second/points)
   end subroutine find_gap

   !> The gap up to which so many points lie.
   pure real(wp) function quantile(counts, width, wanted)
      integer, intent(in) :: counts(:)
      real(wp), intent(in) :: width, wanted
      real(wp) :: below
      integer :: i

      below = 0.0_wp
      do i = 1, size(counts)
         if (counts(i) > 0 .and. below + counts(i) >= wanted) exit
         below = below + counts(i)
      end do
      i = min(i, size(counts))
      quantile = width*(i - 1)
      if (counts(i) > 0) quantile = width*(i - 1 + (wanted - below)/counts(i))
   end function quantile

end module asperity_surface_pair_first_touch_gap
