!> A press record: the pressure of two faces by the law at the closures that were measured, on a
!> machine that yields.
!>
!> The closure is the overclosure of the faces and the compliance of the machine times the pressure,
!> so that the pressure is where p = law(closure - compliance p). Closures are taken for exact.
module asperity_fit_press
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_problem, only: fit_problem
   use asperity_law_normal_law, only: evaluate_pressure, normal_response
   use asperity_law_normal_properties, only: default_plastic_ratio, heights_gaussian, &
      new_normal_properties, normal_properties, unloading_elastic, unloading_reversible
   use asperity_law_unloading_law, only: evaluate_unloading_branch
   implicit none
   private
   public :: press_problem, press_pressures

   !> Places of the numbers of the model
   enum, bind(c)
      enumerator :: press_eta = 1
      enumerator :: press_modulus
      enumerator :: press_radius
      enumerator :: press_hardness
      enumerator :: press_yield_factor
      enumerator :: press_sigma
      enumerator :: press_separation
      enumerator :: press_compliance
   end enum
   public :: press_separation, press_compliance
   integer, parameter, public :: n_press_numbers = 8

   !> The model and the record.
   type, extends(fit_problem) :: press_problem
      !> Closures, mm, and pressures, MPa, in the order of the test
      real(wp), allocatable :: closure(:), pressure(:)
      !> What differences of pressure are divided by, MPa
      real(wp), allocatable :: scale(:)
      !> Numbers of the model, of which the free ones are set: eta, modulus, radius, hardness,
      !> yield_factor, sigma, separation at closure zero, compliance of the machine, mm/MPa
      real(wp) :: numbers(n_press_numbers) = 0.0_wp
      !> Places of the free ones
      integer, allocatable :: free(:)
      !> What else the law takes
      real(wp) :: plastic_ratio = default_plastic_ratio, skewness = 0.0_wp, kurtosis = 3.0_wp
      integer :: unloading = unloading_reversible, height_distribution = heights_gaussian
   contains
      procedure :: residuals => press_residuals
   end type press_problem

   integer, parameter :: most_iterations = 60
   real(wp), parameter :: pressure_tolerance = 1.0e-13_wp

contains

   !> Differences of pressure over their scale.
   recursive subroutine press_residuals(self, values, residuals, error)
      !> The problem
      class(press_problem), intent(in) :: self
      !> Values of the free numbers
      real(wp), intent(in) :: values(:)
      !> One a sample
      real(wp), intent(out) :: residuals(:)
      !> Set when the law refuses the numbers
      type(error_type), allocatable, intent(out) :: error

      call press_pressures(self, values, residuals, error)
      if (.not. allocated(error)) residuals = (residuals - self%pressure)/self%scale
   end subroutine press_residuals

   !> Pressures of the model at the closures of the record, MPa.
   pure subroutine press_pressures(problem, values, pressures, error)
      !> The problem
      class(press_problem), intent(in) :: problem
      !> Values of the free numbers
      real(wp), intent(in) :: values(:)
      !> One a sample
      real(wp), intent(out) :: pressures(:)
      !> Set when the law refuses the numbers
      type(error_type), allocatable, intent(out) :: error
      type(normal_properties) :: properties
      real(wp) :: n(n_press_numbers), overclosure, largest
      integer :: i

      n = problem%numbers
      n(problem%free) = values
      ! what no face has may well lie on the way; the end is judged by who asks
      call new_normal_properties(properties, n(press_eta), n(press_modulus), n(press_radius), &
         n(press_hardness), n(press_yield_factor), n(press_sigma), error, &
         accept_unphysical=.true., unloading=problem%unloading, &
         plastic_ratio=problem%plastic_ratio, height_distribution=problem%height_distribution, &
         skewness=problem%skewness, kurtosis=problem%kurtosis)
      if (allocated(error)) return
      largest = -huge(1.0_wp)
      do i = 1, size(pressures)
         call find_pressure(properties, n(press_separation), n(press_compliance), &
            problem%closure(i), largest, pressures(i))
         overclosure = problem%closure(i) - n(press_compliance)*pressures(i)
         largest = max(largest, overclosure)
      end do
   end subroutine press_pressures

   !> The pressure p = law(closure - compliance p), which lies between zero and law(closure).
   pure subroutine find_pressure(properties, separation, compliance, closure, largest, pressure)
      type(normal_properties), intent(in) :: properties
      !> Separation at overclosure zero, mm; compliance, mm/MPa; closure, mm
      real(wp), intent(in) :: separation, compliance, closure
      !> Largest overclosure so far, mm
      real(wp), intent(in) :: largest
      real(wp), intent(out) :: pressure
      real(wp) :: low, high, law, stiffness, next
      integer :: iteration

      call evaluate(properties, separation - closure, separation - largest, pressure, stiffness)
      if (.not. compliance > 0.0_wp .or. .not. pressure > 0.0_wp) return
      low = 0.0_wp
      high = pressure
      next = pressure - compliance*stiffness*pressure/(1.0_wp + compliance*stiffness)
      do iteration = 1, most_iterations
         if (.not. (next > low .and. next < high)) next = 0.5_wp*(low + high)
         pressure = next
         call evaluate(properties, separation - closure + compliance*pressure, &
            separation - largest, law, stiffness)
         if (law > pressure) then
            low = pressure
         else
            high = pressure
         end if
         next = pressure + (law - pressure)/(1.0_wp + compliance*stiffness)
         if (abs(next - pressure) <= pressure_tolerance*pressure .or. &
            high - low <= pressure_tolerance*high) exit
      end do
      pressure = min(max(next, low), high)
   end subroutine find_pressure

   !> Pressure and stiffness at a separation, after the closest one so far.
   pure subroutine evaluate(properties, separation, closest, pressure, stiffness)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, closest
      real(wp), intent(out) :: pressure, stiffness
      type(normal_response) :: response
      real(wp) :: energy
      integer :: validity

      pressure = 0.0_wp
      stiffness = 0.0_wp
      if (separation > properties%vanishing_separation) return
      if (properties%unloading == unloading_elastic .and. separation > closest) then
         call evaluate_unloading_branch(properties, closest, separation - closest, response)
         pressure = response%pressure
         stiffness = response%stiffness
      else
         call evaluate_pressure(properties, separation, pressure, stiffness, energy, validity)
      end if
   end subroutine evaluate

end module asperity_fit_press
