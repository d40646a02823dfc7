!> Properties of one pair of rough faces for the normal law: checked once, with all constants
!> that follow from them. N-mm-MPa, or N-m-Pa for a face like timber's; in any other consistent
!> units with `accept_unphysical`, as values are then taken for slips of units.
module asperity_law_normal_properties
   use asperity_base_checks, only: all_positive, check_positive, check_range
   use asperity_base_constants, only: pi
   use asperity_base_double_double, only: assignment(=), double_double, operator(*), quotient
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_gaussian_tail, only: vanishing_height
   use asperity_law_johnson_heights, only: height_of, johnson_heights
   use asperity_law_johnson_summits, only: find_summit_heights
   use asperity_law_plausibility, only: check_plausible
   use asperity_law_validity, only: stiffer_than_hertz, valid
   use asperity_paper_pairs, only: pair_preset
   implicit none
   private
   public :: normal_properties, new_normal_properties, equivalent_modulus

   !> What summits do that part again
   enum, bind(c)
      !> Unloading follows loading: the paper's law
      enumerator :: unloading_reversible = 0
      !> Every yielded summit recovers as an elastic one of the radius that its largest deformation
      !> left: `asperity_law_unloading_law`
      enumerator :: unloading_elastic
   end enum
   public :: unloading_reversible, unloading_elastic

   !> How summit heights are distributed
   enum, bind(c)
      !> Normally (Eq. 23)
      enumerator :: heights_gaussian = 0
      !> By Johnson's distribution of a skewness and a kurtosis
      enumerator :: heights_johnson
   end enum
   public :: heights_gaussian, heights_johnson

   !> w2/w1 of metals and of the paper, Eq. 11, and the range over which the law is verified
   real(wp), parameter, public :: default_plastic_ratio = 110.0_wp
   real(wp), parameter :: log_default_ratio = log(default_plastic_ratio)
   real(wp), parameter :: plastic_ratio_min = 10.0_wp, plastic_ratio_max = 1000.0_wp
   !> 3 pi/4 to 32 digits
   type(double_double), parameter :: three_quarters_pi = &
      double_double(2.356194490192345_wp, 9.184850993605148436e-17_wp)
   !> Range of the yield factor over which the law is verified
   real(wp), parameter :: yield_factor_min = 0.05_wp, yield_factor_max = 1.0_wp
   !> Largest b3 with which elastic unloading lies below loading; k = 2/sqrt(w2/w1)
   real(wp), parameter :: largest_force_exponent = 1.5_wp

   !> Normal number of the rarest heights whose closure is judged: one summit in forty
   real(wp), parameter :: rarest_judged = 2.0_wp

   !> Properties of the normal law. Build it with `new_normal_properties`; read only afterwards.
   type :: normal_properties
      !> Asperity density eta: summits per nominal area, 1/mm^2 (Eq. 24)
      real(wp) :: eta = 0.0_wp
      !> Equivalent modulus E*, MPa (Eq. 4)
      real(wp) :: modulus = 0.0_wp
      !> Summit radius R, mm
      real(wp) :: radius = 0.0_wp
      !> Hardness H, MPa
      real(wp) :: hardness = 0.0_wp
      !> Mean contact pressure factor k: yield starts at the mean pressure k H (Eq. 5)
      real(wp) :: yield_factor = 0.0_wp
      !> Standard deviation of summit heights, mm (Eq. 23)
      real(wp) :: sigma = 0.0_wp
      !> Plastic ratio w2/w1 (Eq. 11)
      real(wp) :: plastic_ratio = default_plastic_ratio
      !> Deformation at first yield w1, mm (Eq. 6)
      real(wp) :: w1 = 0.0_wp
      !> Deformation at full plasticity w2, mm (Eq. 11)
      real(wp) :: w2 = 0.0_wp
      !> Exponents of mean pressure, area and force in the elasto-plastic stage (Eqs 14-19),
      !> computed from the yield factor
      real(wp) :: b1 = 0.0_wp, b2 = 0.0_wp, b3 = 0.0_wp
      !> b3 - 1, with the bits that b3 has no room for
      real(wp) :: b3_less_1 = 0.0_wp
      !> Force at first yield N1 = pi k H R w1, N (Eq. 7)
      real(wp) :: n1 = 0.0_wp
      !> Work of one summit's force up to w2, N mm
      real(wp) :: energy_2 = 0.0_wp
      !> `unloading_reversible` or `unloading_elastic`
      integer :: unloading = unloading_reversible
      !> `heights_gaussian` or `heights_johnson`
      integer :: height_distribution = heights_gaussian
      !> Skewness and kurtosis of the heights, 0 and 3 of Gaussian ones
      real(wp) :: skewness = 0.0_wp, kurtosis = 3.0_wp
      !> The heights as a function of a Gaussian number
      type(johnson_heights) :: heights = johnson_heights()
      !> Beyond this separation the law is zero in double precision, mm
      real(wp) :: vanishing_separation = 0.0_wp
      !> Up to this one the mean closure of the summits in contact is judged, mm: the few far out of
      !> heavy tails are all tall
      real(wp) :: judged_separation = 0.0_wp
      !> Flags that hold for every result of these properties (see `asperity_law_validity`)
      integer :: validity = valid
   end type normal_properties

   !> From six numbers, or from a pair of the paper.
   interface new_normal_properties
      module procedure :: from_values
      module procedure :: from_pair
   end interface new_normal_properties

contains

   !> Check the properties of the normal law and derive its constants.
   !> `error` is set, and `properties` unusable, when a value is not above zero (1e-20 to 1e20),
   !> the yield factor is outside 0.05 to 1 (2/sqrt(plastic_ratio) to 1 with elastic unloading), the
   !> plastic ratio outside 10 to 1000, or a value is one that no face or solid has, such as an
   !> eta R sigma below 0.0158 (see `asperity_law_plausibility`); when no heights have skewness and
   !> kurtosis, or heights that are not Gaussian are to unload elastically.
   pure subroutine from_values(properties, eta, modulus, radius, hardness, yield_factor, sigma, &
         error, accept_unphysical, unloading, plastic_ratio, height_distribution, skewness, &
         kurtosis)
      !> Result; all of it is set
      type(normal_properties), intent(inout) :: properties
      !> Asperity density, 1/mm^2; equivalent modulus, MPa; summit radius, mm
      real(wp), intent(in) :: eta, modulus, radius
      !> Hardness, MPa; mean contact pressure factor k; standard deviation of summit heights, mm
      real(wp), intent(in) :: hardness, yield_factor, sigma
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> Let what no face or solid has pass; results are then flagged
      logical, intent(in), optional :: accept_unphysical
      !> `unloading_reversible` (default) or `unloading_elastic`
      integer, intent(in), optional :: unloading
      !> w2/w1, 10 to 1000; 110 when absent
      real(wp), intent(in), optional :: plastic_ratio
      !> `heights_gaussian` (default) or `heights_johnson`
      integer, intent(in), optional :: height_distribution
      !> Skewness and kurtosis of the latter; 0 and 3 when absent
      real(wp), intent(in), optional :: skewness, kurtosis
      type(double_double) :: strain, yield
      real(wp) :: values(7), ratio, log_ratio, b2_less_1
      logical :: allowed, accepted

      ! one by one, as flang allocates memory for an array constructor
      values(1) = eta
      values(2) = modulus
      values(3) = radius
      values(4) = hardness
      values(5) = yield_factor
      values(6) = sigma
      ratio = default_plastic_ratio
      if (present(plastic_ratio)) ratio = plastic_ratio
      values(7) = ratio
      allowed = all_positive(values)
      if (allowed) &
         allowed = yield_factor >= yield_factor_min .and. yield_factor <= yield_factor_max &
         .and. ratio >= plastic_ratio_min .and. ratio <= plastic_ratio_max
      if (.not. allowed) then
         call refuse(error, eta, modulus, radius, hardness, yield_factor, sigma, ratio)
         return
      end if
      accepted = .false.
      if (present(accept_unphysical)) accepted = accept_unphysical
      call check_plausible(eta, modulus, radius, hardness, sigma, accepted, &
         properties%validity, error)
      if (allocated(error)) return

      properties%eta = eta
      properties%modulus = modulus
      properties%radius = radius
      properties%hardness = hardness
      properties%yield_factor = yield_factor
      properties%sigma = sigma
      properties%plastic_ratio = ratio
      ! nearly always that of the paper, in every call of UINTER
      log_ratio = log_default_ratio
      if (abs(ratio - default_plastic_ratio) > 0.0_wp) log_ratio = log(ratio)
      b2_less_1 = log(2.0_wp)/log_ratio
      strain = quotient(hardness, modulus)*yield_factor*three_quarters_pi
      yield = strain*strain*radius
      properties%w1 = yield
      properties%w2 = yield*ratio
      properties%b1 = log(1.0_wp/yield_factor)/log_ratio
      properties%b2 = 1.0_wp + b2_less_1
      properties%b3_less_1 = properties%b1 + b2_less_1
      properties%b3 = 1.0_wp + properties%b3_less_1
      properties%n1 = 4.0_wp/3.0_wp*strain%high*properties%w1*radius*modulus
      properties%energy_2 = properties%n1*properties%w1*(0.4_wp - 1.0_wp/(properties%b3 + 1.0_wp)) &
         + 2.0_wp*pi*radius*hardness*properties%w2**2/(properties%b3 + 1.0_wp)

      if (properties%b3 > largest_force_exponent) &
         properties%validity = ior(properties%validity, stiffer_than_hertz)
      call set_heights(properties, error, height_distribution, skewness, kurtosis)
      properties%unloading = unloading_reversible
      if (present(unloading) .and. .not. allocated(error)) &
         call set_unloading(properties, unloading, error)
   end subroutine from_values

   !> The same of a pair of the paper.
   pure subroutine from_pair(properties, pair, error, accept_unphysical, unloading, &
         plastic_ratio, height_distribution, skewness, kurtosis)
      !> Result
      type(normal_properties), intent(out) :: properties
      !> The pair, such as `find_pair` finds
      type(pair_preset), intent(in) :: pair
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> As above
      logical, intent(in), optional :: accept_unphysical
      integer, intent(in), optional :: unloading, height_distribution
      real(wp), intent(in), optional :: plastic_ratio, skewness, kurtosis

      call from_values(properties, pair%eta, pair%modulus, pair%radius, pair%hardness, &
         pair%yield_factor, pair%sigma, error, accept_unphysical, unloading, plastic_ratio, &
         height_distribution, skewness, kurtosis)
   end subroutine from_pair

   !> Equivalent modulus E* of two elastic bodies, MPa (Eq. 4).
   pure elemental function equivalent_modulus(modulus_1, poisson_1, modulus_2, poisson_2) &
         result(modulus)
      !> Young's moduli, MPa
      real(wp), intent(in) :: modulus_1, modulus_2
      !> Poisson's ratios
      real(wp), intent(in) :: poisson_1, poisson_2
      real(wp) :: modulus

      modulus = 1.0_wp/((1.0_wp - poisson_1**2)/modulus_1 + (1.0_wp - poisson_2**2)/modulus_2)
   end function equivalent_modulus

   !> Set how heights are distributed.
   pure subroutine set_heights(properties, error, height_distribution, skewness, kurtosis)
      type(normal_properties), intent(inout) :: properties
      type(error_type), allocatable, intent(inout) :: error
      integer, intent(in), optional :: height_distribution
      real(wp), intent(in), optional :: skewness, kurtosis

      associate (p => properties)
         p%height_distribution = heights_gaussian
         if (present(height_distribution)) p%height_distribution = height_distribution
         p%skewness = 0.0_wp
         p%kurtosis = 3.0_wp
         p%heights = johnson_heights()
         p%vanishing_separation = vanishing_height*p%sigma
         p%judged_separation = p%vanishing_separation
         if (p%height_distribution == heights_gaussian) return
         if (p%height_distribution /= heights_johnson) then
            call fatal_error(error, 'height_distribution = '//to_text(p%height_distribution)// &
               ' is unknown: 0 is gaussian, 1 is johnson', subject='height_distribution')
            return
         end if
         if (present(skewness)) p%skewness = skewness
         if (present(kurtosis)) p%kurtosis = kurtosis
         call find_summit_heights(p%heights, p%skewness, p%kurtosis, error)
         if (allocated(error) .or. p%heights%is_gaussian) return
         p%vanishing_separation = height_of(p%heights, vanishing_height)*p%sigma
         p%judged_separation = height_of(p%heights, rarest_judged)*p%sigma
      end associate
   end subroutine set_heights

   !> Set what summits do that part again; refused where the unloading branch would lie above the
   !> virgin one, or cycles create energy.
   pure subroutine set_unloading(properties, unloading, error)
      type(normal_properties), intent(inout) :: properties
      integer, intent(in) :: unloading
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: least

      properties%unloading = unloading
      if (unloading /= unloading_reversible .and. unloading /= unloading_elastic) then
         call fatal_error(error, 'unloading = '//to_text(unloading)// &
            ' is unknown: 0 is reversible, 1 is elastic', subject='unloading')
      else if (unloading == unloading_elastic &
            .and. properties%height_distribution /= heights_gaussian) then
         call fatal_error(error, 'height_distribution = johnson is not possible with elastic '// &
            'unloading: take unloading = reversible, or gaussian heights', &
            subject='height_distribution unloading')
      else if (unloading == unloading_elastic .and. properties%b3 > largest_force_exponent) then
         ! rounded upwards, so that the value told is one that passes
         least = 1.0e-4_wp*ceiling(1.0e4_wp*2.0_wp/sqrt(properties%plastic_ratio))
         call fatal_error(error, 'yield_factor = '//to_text(properties%yield_factor)// &
            ' is not allowed with elastic unloading: it must be '//to_text(least, 4)// &
            ' (2/sqrt(plastic_ratio)) or more, as summits would unload stiffer than they load '// &
            'and cycles create energy; the paper uses 0.4', subject='yield_factor')
      end if
   end subroutine set_unloading

   !> Name the first that is not allowed.
   pure subroutine refuse(error, eta, modulus, radius, hardness, yield_factor, sigma, plastic_ratio)
      type(error_type), allocatable, intent(inout) :: error
      real(wp), intent(in) :: eta, modulus, radius, hardness, yield_factor, sigma, plastic_ratio

      call check_positive(error, 'eta', eta, '1/mm^2')
      if (.not. allocated(error)) call check_positive(error, 'modulus', modulus, 'MPa')
      if (.not. allocated(error)) call check_positive(error, 'radius', radius, 'mm')
      if (.not. allocated(error)) call check_positive(error, 'hardness', hardness, 'MPa')
      if (.not. allocated(error)) call check_positive(error, 'sigma', sigma, 'mm')
      if (.not. allocated(error)) call check_range(error, 'plastic_ratio', plastic_ratio, &
         plastic_ratio_min, plastic_ratio_max, '')
      if (.not. allocated(error)) call fatal_error(error, 'yield_factor = '// &
         to_text(yield_factor)//' is not allowed: it must lie between '// &
         to_text(yield_factor_min)//' and '//to_text(nint(yield_factor_max))// &
         '; the paper uses 0.4', subject='yield_factor')
   end subroutine refuse

end module asperity_law_normal_properties
