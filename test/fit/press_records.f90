!> Press records of the paper's first pair, computed, and parameters that begin far off.
module press_records
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_press, only: press_pressures, press_problem
   use asperity_law_normal_properties, only: unloading_elastic
   use random_inputs, only: random_stream
   implicit none
   private
   public :: add_noise, new_record, press_parameters

   !> eta, modulus, radius, hardness, yield factor, sigma, separation at closure zero
   real(wp), parameter, public :: truth(7) = [206.0_wp, 297.0_wp, 0.1477_wp, 24.53_wp, 0.4_wp, &
      0.0593_wp, 0.2372_wp]
   character(len=10), parameter :: names(8) = [character(len=10) :: 'eta', 'modulus', 'radius', &
      'hardness', 'k', 'sigma', 'separation', 'compliance']
   integer, parameter :: samples = 40
   real(wp), parameter :: largest_closure = 0.14_wp

contains

   !> A record without noise: up to 0.14 mm, or up and half of the way back.
   subroutine new_record(problem, free, returns, compliance)
      type(press_problem), intent(out) :: problem
      integer, intent(in) :: free(:)
      logical, intent(in) :: returns
      real(wp), intent(in), optional :: compliance
      type(error_type), allocatable :: error
      real(wp) :: p(samples), exact(8)
      integer :: i, up

      up = samples
      if (returns) up = 26
      problem%closure = [(largest_closure*real(up - abs(i - up), wp)/real(up, wp), i=1, samples)]
      exact(:7) = truth
      exact(8) = 0.0_wp
      if (present(compliance)) exact(8) = compliance
      problem%numbers = exact
      problem%free = free
      if (returns) problem%unloading = unloading_elastic
      call press_pressures(problem, exact(free), p, error)
      problem%pressure = p
      problem%scale = spread(maxval(p), 1, samples)
   end subroutine new_record

   !> Gaussian noise of a share of the largest pressure.
   subroutine add_noise(problem, exact, noise, stream)
      type(press_problem), intent(inout) :: problem
      real(wp), intent(in) :: exact(:), noise
      type(random_stream), intent(inout) :: stream
      integer :: i

      do i = 1, size(exact)
         problem%pressure(i) = exact(i) + noise*maxval(exact)*stream%gaussian()
      end do
   end subroutine add_noise

   !> Parameters that begin at a factor times the truth; lengths that have a zero begin off by a
   !> part of the range.
   function press_parameters(problem, factor) result(parameters)
      type(press_problem), intent(in) :: problem
      real(wp), intent(in) :: factor
      type(fit_parameter), allocatable :: parameters(:)
      integer :: i

      allocate (parameters(size(problem%free)))
      do i = 1, size(parameters)
         associate (which => problem%free(i), p => parameters(i))
            p%name = names(which)
            select case (which)
            case (7)
               p%scale = largest_closure
               p%start = truth(7) + 0.05_wp*log(factor)
               p%lower = -5.0_wp*largest_closure
               p%upper = 25.0_wp*largest_closure
            case (8)
               p%scale = 0.01_wp
               p%start = 0.005_wp*min(factor, 5.0_wp)
               p%lower = -0.001_wp
               p%upper = 0.03_wp
            case default
               p%by_ratio = .true.
               p%start = factor*truth(which)
               p%lower = truth(which)/1000.0_wp
               p%upper = truth(which)*1000.0_wp
            end select
         end associate
      end do
   end function press_parameters

end module press_records
