!> The linear Gaussian filter of ISO 16610-21 along blocks of lines of equal length.
!>
!> A short filter sums directly, a long one by Fourier transforms of lines with zeros behind, so
!> that their ends do not meet. Towards the ends part of the weights falls outside. With
!> `keeps_slope` the filtered value there is that of the straight line fitted with the weights left
!> (moment retainment of ISO 16610-28 of order 1): (M2 N0 - M1 N1)/(M0 M2 - M1^2), where Mp sums
!> k^p w(k) and Np sums k^p w(k) z(i+k) over the points k away that there are. Without it the plain
!> sum N0 comes back.
module asperity_surface_prepare_line_filter
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_surface_fourier, only: delete_line_transform, easy_length, line_transform, &
      new_line_transform, transform_lines_backward, transform_lines_forward
   implicit none
   private
   public :: delete_line_filter, filter_lines, line_filter, new_line_filter

   !> alpha of ISO 16610-21: half of a wave of the cutoff's length passes
   real(wp), parameter, public :: alpha = sqrt(log(2.0_wp)/pi)
   !> Weights below this share of the largest are left out
   real(wp), parameter :: least_weight = 1.0e-16_wp
   !> Longest reach, in points, of filters that sum directly; from there on transforms are faster
   integer, parameter :: direct_reach = 28

   !> A filter for blocks of lines of one length.
   type :: line_filter
      !> Points of a line
      integer :: points = 0
      !> Lines of a block, at most
      integer :: lines = 0
      !> Points either side of one that have weight
      integer, private :: reach = 0
      logical, private :: keeps_slope = .false., by_fourier = .false.
      !> Weights by distance, from 0 to `reach`; with those of the other side, 1 in total
      real(wp), allocatable, private :: weights(:)
      !> Result by point: `of_sum` N0 - `of_moment` N1
      real(wp), allocatable, private :: of_sum(:), of_moment(:)
      !> Padded lines with zeros around, and for N1
      real(wp), allocatable, private :: padded(:, :), moments(:, :)
      !> Spectra of lines, and those times that of the weights for N1
      complex(wp), allocatable, private :: spectra(:, :), moment_spectra(:, :)
      !> Spectra of the weights: the real one for N0, by i the imaginary one for N1
      real(wp), allocatable, private :: passes_sum(:), passes_moment(:)
      type(line_transform), private :: transform
   end type line_filter

contains

   !> A filter; to be deleted after use.
   subroutine new_line_filter(filter, points, lines, cutoff, keeps_slope)
      !> The filter
      type(line_filter), intent(out) :: filter
      !> Points of a line, and lines of a block at most
      integer, intent(in) :: points, lines
      !> Length of the wave of which half passes, in steps
      real(wp), intent(in) :: cutoff
      !> Whether straight lines stay as they are
      logical, intent(in) :: keeps_slope
      integer :: i

      filter%points = points
      filter%lines = lines
      filter%keeps_slope = keeps_slope
      filter%reach = min(int(alpha*cutoff*sqrt(-log(least_weight)/pi)), points - 1)
      filter%by_fourier = filter%reach > direct_reach
      allocate (filter%weights(0:filter%reach))
      do i = 0, filter%reach
         filter%weights(i) = exp(-pi*(real(i, wp)/(alpha*cutoff))**2)
      end do
      associate (w => filter%weights)
         w = w/(w(0) + 2.0_wp*sum(w(1:)))
      end associate
      allocate (filter%of_sum(points), filter%of_moment(points))
      filter%of_sum = 1.0_wp
      filter%of_moment = 0.0_wp
      if (keeps_slope) call correct_ends(filter%weights, filter%of_sum, filter%of_moment)
      if (filter%by_fourier) then
         call prepare_transform(filter)
      else
         allocate (filter%padded(1 - filter%reach:points + filter%reach, 1))
         filter%padded = 0.0_wp
      end if
   end subroutine new_line_filter

   !> Factors of N0 and N1 at each point.
   pure subroutine correct_ends(w, of_sum, of_moment)
      real(wp), intent(in) :: w(0:)
      real(wp), intent(inout) :: of_sum(:), of_moment(:)
      real(wp) :: m0, m1, m2
      integer :: i, k

      associate (n => size(of_sum))
         do i = 1, n
            ! nothing falls outside
            if (i > ubound(w, 1) .and. i <= n - ubound(w, 1)) cycle
            m0 = w(0)
            m1 = 0.0_wp
            m2 = 0.0_wp
            do k = 1, ubound(w, 1)
               if (i + k <= n) then
                  m0 = m0 + w(k)
                  m1 = m1 + w(k)*k
                  m2 = m2 + w(k)*real(k, wp)**2
               end if
               if (i - k >= 1) then
                  m0 = m0 + w(k)
                  m1 = m1 - w(k)*k
                  m2 = m2 + w(k)*real(k, wp)**2
               end if
            end do
            of_sum(i) = m2/(m0*m2 - m1**2)
            of_moment(i) = m1/(m0*m2 - m1**2)
         end do
      end associate
   end subroutine correct_ends

   !> Plans and the spectra of the weights, by the length of the padded lines, as transforms there
   !> and back multiply by it.
   subroutine prepare_transform(filter)
      type(line_filter), intent(inout) :: filter
      integer :: length, k

      length = easy_length(filter%points + filter%reach)
      allocate (filter%padded(length, filter%lines), filter%spectra(length/2 + 1, filter%lines))
      call new_line_transform(filter%transform, filter%padded, filter%spectra)
      filter%padded = 0.0_wp
      filter%padded(1, 1) = filter%weights(0)
      do k = 1, filter%reach
         filter%padded(1 + k, 1) = filter%weights(k)
         filter%padded(length + 1 - k, 1) = filter%weights(k)
      end do
      call transform_lines_forward(filter%transform, filter%padded, filter%spectra)
      allocate (filter%passes_sum(length/2 + 1))
      filter%passes_sum = real(filter%spectra(:, 1), wp)/real(length, wp)
      if (.not. filter%keeps_slope) return
      ! the point k behind is at -k of the one whose mean it enters
      filter%padded(1, 1) = 0.0_wp
      do k = 1, filter%reach
         filter%padded(1 + k, 1) = -filter%weights(k)*k
         filter%padded(length + 1 - k, 1) = filter%weights(k)*k
      end do
      call transform_lines_forward(filter%transform, filter%padded, filter%spectra)
      allocate (filter%passes_moment(length/2 + 1), filter%moments(length, filter%lines), &
         filter%moment_spectra(length/2 + 1, filter%lines))
      filter%passes_moment = aimag(filter%spectra(:, 1))/real(length, wp)
   end subroutine prepare_transform

   !> Filter lines in place.
   subroutine filter_lines(filter, lines)
      !> The filter; its arrays are worked in
      type(line_filter), intent(inout) :: filter
      !> Points by lines, at most as many as the filter takes
      real(wp), intent(inout), contiguous :: lines(:, :)
      integer :: line

      if (filter%by_fourier) then
         call filter_by_fourier(filter, lines)
      else
         do line = 1, size(lines, 2)
            call filter_directly(filter%weights, filter%of_sum, filter%of_moment, &
               filter%reach, filter%padded(:, 1), lines(:, line))
         end do
      end if
   end subroutine filter_lines

   !> Sum directly along a line.
   pure subroutine filter_directly(w, of_sum, of_moment, reach, padded, line)
      integer, intent(in) :: reach
      real(wp), intent(in) :: w(0:reach), of_sum(:), of_moment(:)
      !> Zeros either side
      real(wp), intent(inout) :: padded(1 - reach:)
      real(wp), intent(inout) :: line(:)
      real(wp) :: moment
      integer :: i, k

      associate (n => size(line))
         padded(1:n) = line
         line = w(0)*line
         do k = 1, reach
            do i = 1, n
               line(i) = line(i) + w(k)*(padded(i - k) + padded(i + k))
            end do
         end do
         do i = 1, n
            if (i > reach .and. i <= n - reach) cycle
            moment = 0.0_wp
            do k = 1, reach
               moment = moment + w(k)*k*(padded(i + k) - padded(i - k))
            end do
            line(i) = of_sum(i)*line(i) - of_moment(i)*moment
         end do
      end associate
   end subroutine filter_directly

   !> Filter a block of lines by their transforms.
   subroutine filter_by_fourier(filter, lines)
      type(line_filter), intent(inout) :: filter
      real(wp), intent(inout), contiguous :: lines(:, :)
      integer :: line, k, n

      n = filter%points
      do line = 1, size(lines, 2)
         filter%padded(:n, line) = lines(:, line)
         filter%padded(n + 1:, line) = 0.0_wp
      end do
      call transform_lines_forward(filter%transform, filter%padded, filter%spectra)
      do line = 1, size(lines, 2)
         if (filter%keeps_slope) then
            do k = 1, size(filter%spectra, 1)
               filter%moment_spectra(k, line) = cmplx(-aimag(filter%spectra(k, line)), &
                  real(filter%spectra(k, line)), wp)*filter%passes_moment(k)
            end do
         end if
         do k = 1, size(filter%spectra, 1)
            filter%spectra(k, line) = filter%spectra(k, line)*filter%passes_sum(k)
         end do
      end do
      call transform_lines_backward(filter%transform, filter%spectra, filter%padded)
      if (filter%keeps_slope) call transform_lines_backward(filter%transform, &
         filter%moment_spectra, filter%moments)
      do line = 1, size(lines, 2)
         if (filter%keeps_slope) then
            lines(:, line) = filter%of_sum*filter%padded(:n, line) &
               - filter%of_moment*filter%moments(:n, line)
         else
            lines(:, line) = filter%padded(:n, line)
         end if
      end do
   end subroutine filter_by_fourier

   !> Free the plans, which would not go with the variable.
   subroutine delete_line_filter(filter)
      !> The filter
      type(line_filter), intent(inout) :: filter

      call delete_line_transform(filter%transform)
   end subroutine delete_line_filter

end module asperity_surface_prepare_line_filter
