!> What C and Fortran share: the result codes, the plain structs and the object behind an opaque
!> handle. Everything here stands in asperity.h again, member by member.
module asperity_c_types
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int64_t, c_ptr, c_size_t
   use asperity_base_error, only: computation_error, input_error
   use asperity_contact_friction_settings, only: most_friction_points, most_stick_elements, &
      slip_direction_associated, stick_critical_slip
   use asperity_contact_properties, only: rule_abaqus, slip_exact
   use asperity_law_normal_properties, only: default_plastic_ratio, heights_gaussian, &
      unloading_reversible
   implicit none
   private
   public :: error_struct, handle_object, properties_struct, state_struct

   !> Result codes. Those of the library are the categories of its errors (3 is a file, which the
   !> C interface never touches).
   integer, parameter, public :: code_ok = 0, code_computation = computation_error, &
      code_input = input_error, code_null = 4, code_length = 5, code_memory = 6, code_handle = 7

   !> First word of the object behind a handle: what kind it is
   integer(c_int64_t), parameter, public :: tag_law = int(z'6C61772D61737065', c_int64_t), &
      tag_states = int(z'7374612D61737065', c_int64_t)

   !> Length of the message, with the NUL at its end
   integer, parameter, public :: message_length = 508
   !> `initial_separation` that stands for 4 sigma: far outside the range allowed
   real(c_double), parameter, public :: four_sigma = 1.0e300_c_double

   !> struct asperity_error
   type, bind(c) :: error_struct
      !> One of the result codes
      integer(c_int) :: code
      !> Text that ends with NUL
      character(kind=c_char) :: message(message_length)
   end type error_struct

   !> Not a number: a property that was not set, which the law refuses
   real(c_double), parameter :: unset = transfer(int(z'7FF8000000000000', c_int64_t), 1.0_c_double)

   !> struct asperity_properties
   type, bind(c) :: properties_struct
      !> Size of the struct in the header that the caller was compiled with
      integer(c_size_t) :: size = 0_c_size_t
      !> As in `normal_properties`
      real(c_double) :: eta = unset, modulus = unset, radius = unset, hardness = unset, &
         yield_factor = unset, sigma = unset
      !> As in `contact_properties`
      real(c_double) :: friction_coefficient = unset, critical_slip = unset, &
         initial_separation = four_sigma
      !> As in `contact_properties`
      integer(c_int) :: friction_rule = rule_abaqus, slip_integration = slip_exact
      !> 0 or 1
      integer(c_int) :: accept_unphysical = 0_c_int, compiled = 0_c_int
      !> As in `normal_properties`
      integer(c_int) :: unloading = unloading_reversible
      !> As in `normal_properties`
      real(c_double) :: plastic_ratio = default_plastic_ratio
      integer(c_int) :: height_distribution = heights_gaussian
      real(c_double) :: skewness = 0.0_c_double, kurtosis = 3.0_c_double
      !> As in `friction_settings`
      real(c_double) :: static_friction_coefficient = 0.0_c_double, decay_slip = 0.0_c_double, &
         decay_slip_rate = 0.0_c_double, friction_coefficient_across = 0.0_c_double, &
         grain_angle = 0.0_c_double
      integer(c_int) :: slip_direction = slip_direction_associated
      real(c_double) :: pressure_exponent = 0.0_c_double, reference_pressure = 0.0_c_double, &
         shear_limit = 0.0_c_double
      integer(c_int) :: stick = stick_critical_slip, stick_elements = 0_c_int
      real(c_double) :: shear_modulus = 0.0_c_double
      integer(c_int) :: friction_points = 0_c_int
      real(c_double) :: friction_pressures(most_friction_points) = 0.0_c_double, &
         friction_factors(most_friction_points) = 0.0_c_double
   end type properties_struct

   !> struct asperity_state: `contact_state`
   type, bind(c) :: state_struct
      !> As in `contact_state`
      integer(c_int) :: status, validity
      !> As in `contact_state`
      real(c_double) :: overclosure, pressure, normal_energy, elastic_slip(2), largest_closure, &
         dissipation, pressure_coupling, motion_share, grain_turn, &
         summit_slip(2, most_stick_elements)
   end type state_struct

   !> What a handle points to
   type, bind(c) :: handle_object
      !> `tag_law` or `tag_states`
      integer(c_int64_t) :: tag
      !> The law or the states
      type(c_ptr) :: content
   end type handle_object

end module asperity_c_types
