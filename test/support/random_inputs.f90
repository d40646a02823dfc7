!> Inputs for tests: the paper's pairs and repeatable random ones. The same seed gives the same
!> uniform numbers with every compiler.
module random_inputs
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_paper_pairs, only: find_pair, pair_preset
   implicit none
   private
   public :: random_stream, random_properties, normal_of_pair, properties_with

   integer(int64), parameter :: modulus = 2147483647_int64, multiplier = 48271_int64

   !> Lehmer generator, x -> 48271 x mod (2^31 - 1).
   type :: random_stream
      !> Seed, then state; between 1 and 2^31 - 2
      integer(int64) :: state = 1_int64
   contains
      procedure :: uniform
      procedure :: log_uniform
      procedure :: gaussian
   end type random_stream

contains

   !> A number between `lower` and `upper`, with 62 random bits.
   function uniform(this, lower, upper) result(x)
      class(random_stream), intent(inout) :: this
      real(wp), intent(in) :: lower, upper
      real(wp) :: x, high, low

      this%state = mod(multiplier*this%state, modulus)
      high = real(this%state, wp)
      this%state = mod(multiplier*this%state, modulus)
      low = real(this%state, wp)
      x = lower + (upper - lower)*((high - 1.0_wp + low/real(modulus, wp))/real(modulus, wp))
   end function uniform

   !> A number between `lower` and `upper`, both positive, uniform in its logarithm.
   function log_uniform(this, lower, upper) result(x)
      class(random_stream), intent(inout) :: this
      real(wp), intent(in) :: lower, upper
      real(wp) :: x

      x = lower*exp(this%uniform(0.0_wp, log(upper/lower)))
   end function log_uniform

   !> A number of a Gaussian distribution with a standard deviation of one (Box and Muller).
   function gaussian(this) result(x)
      class(random_stream), intent(inout) :: this
      real(wp) :: x, radius

      radius = sqrt(-2.0_wp*log(this%uniform(1.0e-300_wp, 1.0_wp)))
      x = radius*cos(2.0_wp*pi*this%uniform(0.0_wp, 1.0_wp))
   end function gaussian

   !> Random properties with w1/sigma between the limits and eta R sigma between 0.03 and 4.
   subroutine random_properties(stream, properties, w1_min, w1_max, yield_factor_min, unloading)
      type(random_stream), intent(inout) :: stream
      type(normal_properties), intent(out) :: properties
      !> Limits of w1/sigma
      real(wp), intent(in) :: w1_min, w1_max
      !> Smallest yield factor
      real(wp), intent(in) :: yield_factor_min
      !> As of the properties
      integer, intent(in), optional :: unloading
      type(error_type), allocatable :: error
      real(wp) :: sigma, radius, hardness, yield_factor, elastic_modulus, eta

      sigma = stream%log_uniform(1.0e-5_wp, 10.0_wp)
      radius = stream%log_uniform(1.0e-3_wp, 10.0_wp)
      hardness = stream%log_uniform(1.0_wp, 1.0e3_wp)
      yield_factor = stream%uniform(yield_factor_min, 1.0_wp)
      elastic_modulus = 0.75_wp*pi*yield_factor*hardness &
         *sqrt(radius/(sigma*stream%log_uniform(w1_min, w1_max)))
      eta = stream%log_uniform(0.03_wp, 4.0_wp)/(radius*sigma)
      call new_normal_properties(properties, eta, elastic_modulus, radius, hardness, &
         yield_factor, sigma, error, accept_unphysical=.true., unloading=unloading)
      if (allocated(error)) error stop 'random_properties: '//error%message
   end subroutine random_properties

   !> Properties of a pair of the paper.
   function normal_of_pair(name) result(properties)
      character(len=*), intent(in) :: name
      type(normal_properties) :: properties
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      call find_pair(name, pair, error)
      if (allocated(error)) error stop 'normal_of_pair: '//error%message
      call new_normal_properties(properties, pair, error)
      if (allocated(error)) error stop 'normal_of_pair: '//error%message
   end function normal_of_pair

   !> The transverse-tangential pair with another modulus, so that w1/sigma is as given.
   function properties_with(w1_over_sigma, yield_factor) result(properties)
      real(wp), intent(in) :: w1_over_sigma, yield_factor
      type(normal_properties) :: properties, base
      type(error_type), allocatable :: error
      real(wp) :: elastic_modulus

      base = normal_of_pair('transverse-tangential')
      associate (p => base)
         elastic_modulus = 0.75_wp*pi*yield_factor*p%hardness*sqrt(p%radius/(p%sigma*w1_over_sigma))
         call new_normal_properties(properties, p%eta, elastic_modulus, p%radius, p%hardness, &
            yield_factor, p%sigma, error, accept_unphysical=.true.)
      end associate
      if (allocated(error)) error stop 'properties_with: '//error%message
   end function properties_with

end module random_inputs
