!> Variances of the waves of a random surface. Spectra hold the half plane of ../fourier.f90, in
!> their real parts, and sum to 1 over the whole plane.
module asperity_surface_generate_spectrum
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_surface_fourier, only: transform_backward_2d, transform_forward_2d
   use asperity_surface_generate_height_distribution, only: distorted_correlation, marginal_type
   use asperity_surface_generate_settings, only: surface_settings
   implicit none
   private
   public :: correlation_reach, distort_spectrum, fill_spectrum

   !> Correlation lengths after which the autocorrelation counts as nothing: 1e-11 and 1e-5
   real(wp), parameter :: gaussian_reach = 5.0_wp, exponential_reach = 12.0_wp
   !> The same in longest waves
   real(wp), parameter :: self_affine_reach = 2.0_wp
   !> Share of the largest variance below which one of a distorted spectrum is rounding
   real(wp), parameter :: rounding = 1.0e-13_wp

contains

   !> Steps along x and y after which heights are not correlated.
   pure function correlation_reach(s) result(reach)
      !> The settings
      type(surface_settings), intent(in) :: s
      real(wp) :: reach(2)
      real(wp) :: factor

      if (s%spectrum == 'self_affine') then
         reach = self_affine_reach*s%longest_wave/s%step
      else
         factor = merge(gaussian_reach, exponential_reach, s%spectrum == 'gaussian')/s%step
         associate (a => s%direction*pi/180.0_wp, lx => s%correlation_length_x, &
            ly => s%correlation_length_y)
            reach = factor*[hypot(lx*cos(a), ly*sin(a)), hypot(lx*sin(a), ly*cos(a))]
         end associate
      end if
   end function correlation_reach

   !> Set the variances.
   subroutine fill_spectrum(s, spectrum, field)
      !> The settings
      type(surface_settings), intent(in) :: s
      !> The spectrum, (nx/2 + 1) x ny
      complex(wp), intent(inout), contiguous :: spectrum(:, :)
      !> Room for nx x ny numbers
      real(wp), intent(inout), contiguous :: field(:, :)

      select case (s%spectrum)
      case ('gaussian')
         call fill_gaussian(s, size(field, 1), spectrum)
      case ('exponential')
         call fill_exponential(s, field)
         call transform_forward_2d(field, spectrum)
      case default
         call fill_self_affine(s, size(field, 1), spectrum)
      end select
      call scale_spectrum(spectrum, 0.0_wp)
   end subroutine fill_spectrum

   !> Wave number of place k of n, rad per step, between -pi and pi.
   pure elemental real(wp) function wave_number(k, n)
      integer, intent(in) :: k, n

      wave_number = 2.0_wp*pi*real(merge(k - 1, k - 1 - n, 2*(k - 1) <= n), wp)/real(n, wp)
   end function wave_number

   !> The transform of a Gaussian function is one; that of its samples is the sum over all wave
   !> numbers that the step cannot tell apart. A transform by numbers would leave rounding in
   !> place of the shortest waves, which curvatures would show.
   pure subroutine fill_gaussian(s, nx, spectrum)
      type(surface_settings), intent(in) :: s
      integer, intent(in) :: nx
      complex(wp), intent(inout) :: spectrum(:, :)
      real(wp) :: c, d, lx, ly, kx, ky, total
      integer :: i, j, m, n, aliases

      lx = 0.5_wp*s%correlation_length_x/s%step
      ly = 0.5_wp*s%correlation_length_y/s%step
      c = cos(s%direction*pi/180.0_wp)
      d = sin(s%direction*pi/180.0_wp)
      aliases = merge(0, 1, min(lx, ly) > 4.0_wp)
      do j = 1, size(spectrum, 2)
         do i = 1, size(spectrum, 1)
            total = 0.0_wp
            do n = -aliases, aliases
               do m = -aliases, aliases
                  kx = wave_number(i, nx) + 2.0_wp*pi*m
                  ky = wave_number(j, size(spectrum, 2)) + 2.0_wp*pi*n
                  total = total + exp(-min((lx*(c*kx + d*ky))**2 + (ly*(c*ky - d*kx))**2, 700.0_wp))
               end do
            end do
            spectrum(i, j) = cmplx(total, 0.0_wp, wp)
         end do
      end do
   end subroutine fill_gaussian

   !> Autocorrelation over the larger map, closed upon itself.
   pure subroutine fill_exponential(s, field)
      type(surface_settings), intent(in) :: s
      real(wp), intent(inout) :: field(:, :)
      real(wp) :: c, d, x, y
      integer :: i, j, nx, ny

      c = cos(s%direction*pi/180.0_wp)
      d = sin(s%direction*pi/180.0_wp)
      nx = size(field, 1)
      ny = size(field, 2)
      do j = 1, ny
         y = s%step*merge(j - 1, j - 1 - ny, 2*(j - 1) <= ny)
         do i = 1, nx
            x = s%step*merge(i - 1, i - 1 - nx, 2*(i - 1) <= nx)
            field(i, j) = exp(-hypot((c*x + d*y)/s%correlation_length_x, &
               (c*y - d*x)/s%correlation_length_y))
         end do
      end do
   end subroutine fill_exponential

   !> Power law between two wave numbers, constant below them.
   pure subroutine fill_self_affine(s, nx, spectrum)
      type(surface_settings), intent(in) :: s
      integer, intent(in) :: nx
      complex(wp), intent(inout) :: spectrum(:, :)
      real(wp) :: longest, shortest, k
      integer :: i, j

      longest = 2.0_wp*pi*s%step/s%longest_wave
      shortest = 2.0_wp*pi*s%step/s%shortest_wave*(1.0_wp + 1.0e-9_wp)
      do j = 1, size(spectrum, 2)
         do i = 1, size(spectrum, 1)
            k = hypot(wave_number(i, nx), wave_number(j, size(spectrum, 2)))
            spectrum(i, j) = (0.0_wp, 0.0_wp)
            if (k <= shortest) &
               spectrum(i, j) = (max(k, longest)/longest)**(-2.0_wp - 2.0_wp*s%hurst)
         end do
      end do
      spectrum(1, 1) = (0.0_wp, 0.0_wp)
   end subroutine fill_self_affine

   !> Scale to the sum 1 over the whole plane, and drop what is no variance or rounding.
   pure subroutine scale_spectrum(spectrum, least)
      complex(wp), intent(inout) :: spectrum(:, :)
      !> Share of the largest below which a variance is dropped
      real(wp), intent(in) :: least
      real(wp) :: largest, total, column
      integer :: i, j, last

      last = size(spectrum, 1)
      largest = 0.0_wp
      do j = 1, size(spectrum, 2)
         largest = max(largest, maxval(real(spectrum(:, j), wp)))
      end do
      total = 0.0_wp
      do j = 1, size(spectrum, 2)
         do i = 1, last
            spectrum(i, j) = max(real(spectrum(i, j), wp), 0.0_wp)
            if (real(spectrum(i, j), wp) < least*largest) spectrum(i, j) = (0.0_wp, 0.0_wp)
         end do
         column = real(spectrum(1, j), wp) + real(spectrum(last, j), wp)
         total = total + column + 2.0_wp*sum(real(spectrum(2:last - 1, j), wp))
      end do
      do j = 1, size(spectrum, 2)
         spectrum(:, j) = spectrum(:, j)/total
      end do
   end subroutine scale_spectrum

   !> Turn the spectrum of heights of a distribution into that of the Gaussian surface they are a
   !> function of.
   subroutine distort_spectrum(marginal, spectrum, field)
      !> The function
      type(marginal_type), intent(in) :: marginal
      !> The spectrum
      complex(wp), intent(inout), contiguous :: spectrum(:, :)
      !> Room for a map
      real(wp), intent(inout), contiguous :: field(:, :)
      integer :: i, j, nx, ny

      call transform_backward_2d(spectrum, field)
      nx = size(field, 1)
      ny = size(field, 2)
      ! now the autocorrelation: the same at opposite places
      do j = 1, ny/2 + 1
         field(:, j) = distorted_correlation(marginal, field(:, j))
      end do
      do j = ny/2 + 2, ny
         do i = 1, nx
            field(i, j) = field(modulo(1 - i, nx) + 1, ny + 2 - j)
         end do
      end do
      call transform_forward_2d(field, spectrum)
      call scale_spectrum(spectrum, rounding)
   end subroutine distort_spectrum

end module asperity_surface_generate_spectrum
