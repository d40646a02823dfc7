!> Random surfaces. A Gaussian one is a sum of waves of random phase and Gaussian amplitude over a
!> map larger by as much as heights are correlated, of which the part asked for is cut out: unlike a
!> periodic map its ends do not fit each other, as those of a measured one do not, and its
!> autocorrelation is the one asked for at all distances (circulant embedding). Heights of other
!> distributions are a function of Gaussian ones (a translation process), whose correlation is
!> chosen such that theirs is the one asked for; where no Gaussian surface has it, negative power is
!> left out of its spectrum.
module asperity_surface_generate_map
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_room
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_fourier, only: easy_length, transform_backward_2d
   use asperity_surface_generate_height_distribution, only: marginal_height, marginal_type, &
      new_marginal
   use asperity_surface_generate_random_stream, only: fill_normal, new_random, random_type
   use asperity_surface_generate_settings, only: check_surface_settings, surface_settings
   use asperity_surface_generate_spectrum, only: correlation_reach, distort_spectrum, fill_spectrum
   implicit none
   private
   public :: generate_surface, surface_settings

   !> Most points of the larger map
   real(wp), parameter :: most_points = 1.0e9_wp

contains

   !> Generate a surface.
   subroutine generate_surface(settings, map, error)
      !> What it shall be
      type(surface_settings), intent(in) :: settings
      !> The surface
      type(height_map), intent(out) :: map
      !> Set where there is no such surface
      type(error_type), allocatable, intent(out) :: error
      type(marginal_type) :: marginal
      complex(wp), allocatable :: spectrum(:, :)
      real(wp), allocatable :: field(:, :)
      real(wp) :: reach(2)
      type(error_type), allocatable :: no_room
      integer :: nx, ny, status, j

      call check_surface_settings(settings, error)
      if (.not. allocated(error)) call new_marginal(marginal, settings%ssk, settings%sku, error)
      if (allocated(error)) return
      reach = correlation_reach(settings)
      if (product(reach + [settings%points_x, settings%points_y]) > most_points) then
         call refuse_size(error, settings)
         return
      end if
      nx = easy_length(settings%points_x + ceiling(reach(1)))
      ny = easy_length(settings%points_y + ceiling(reach(2)))
      allocate (spectrum(nx/2 + 1, ny), stat=status)
      if (status == 0) allocate (field(nx, ny), stat=status)
      ! what FFTW works in, and lines
      if (status == 0) call check_room('', 16_int64*(nx + ny), no_room)
      if (status /= 0 .or. allocated(no_room)) then
         call refuse_size(error, settings, 16_int64*(nx/2 + 1)*ny + 8_int64*nx*ny)
         return
      end if
      call fill_spectrum(settings, spectrum, field)
      if (.not. marginal%heights%is_gaussian) call distort_spectrum(marginal, spectrum, field)
      call randomise(settings%seed, spectrum)
      call transform_backward_2d(spectrum, field)
      deallocate (spectrum)
      allocate (map%heights(settings%points_x, settings%points_y), stat=status)
      if (status /= 0) then
         call refuse_size(error, settings, 8_int64*nx*ny + &
            8_int64*settings%points_x*settings%points_y)
         return
      end if
      do j = 1, settings%points_y
         map%heights(:, j) = settings%sq*marginal_height(marginal, field(:settings%points_x, j))
      end do
      map%step_x = settings%step
      map%step_y = settings%step
      map%source = 'random surface, seed '//to_text(settings%seed)
      map%format = 'generated'
   end subroutine generate_surface

   !> Refuse what the memory does not hold.
   pure subroutine refuse_size(error, settings, bytes)
      type(error_type), allocatable, intent(out) :: error
      type(surface_settings), intent(in) :: settings
      !> What they would take, where that is known
      integer(int64), intent(in), optional :: bytes
      character(len=:), allocatable :: size

      size = ''
      if (present(bytes)) size = ', '//to_text(real(bytes, wp)/2.0_wp**20, 4)//' MiB'
      call fatal_error(error, 'there is no memory for '//to_text(settings%points_x)//' x '// &
         to_text(settings%points_y)//' points and the waves beyond them'//size// &
         ': give fewer points or shorter correlation lengths', computation_error)
   end subroutine refuse_size

   !> Turn the variances of the waves into random amplitudes, those of a real map.
   pure subroutine randomise(seed, spectrum)
      integer, intent(in) :: seed
      complex(wp), intent(inout) :: spectrum(:, :)
      type(random_type) :: stream
      real(wp), allocatable :: normal(:)
      real(wp) :: factor
      integer :: i, j, last, opposite, ny

      call new_random(stream, seed)
      allocate (normal(2*size(spectrum, 1)))
      last = size(spectrum, 1)
      ny = size(spectrum, 2)
      do j = 1, ny
         opposite = modulo(1 - j, ny) + 1
         call fill_normal(stream, normal)
         ! two waves in each half: the other one is the conjugate, not stored
         do i = 2, last - 1
            factor = sqrt(0.5_wp*real(spectrum(i, j), wp))
            spectrum(i, j) = factor*cmplx(normal(2*i - 1), normal(2*i), wp)
         end do
         ! both are stored
         do i = 1, last, last - 1
            if (opposite < j) then
               spectrum(i, j) = conjg(spectrum(i, opposite))
            else if (opposite == j) then
               spectrum(i, j) = sqrt(real(spectrum(i, j), wp))*normal(2*i)
            else
               factor = sqrt(0.5_wp*real(spectrum(i, j), wp))
               spectrum(i, j) = factor*cmplx(normal(2*i - 1), normal(2*i), wp)
            end if
         end do
      end do
   end subroutine randomise

end module asperity_surface_generate_map
