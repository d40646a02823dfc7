!> What the properties of two faces are: their places, names, units and meanings.
module asperity_program_commands_faces_properties
   use asperity_base_kinds, only: wp
   use asperity_paper_pairs, only: pair_preset
   use asperity_program_input_key, only: name_length
   implicit none
   private
   public :: face_property, pair_values

   !> Places of the properties
   integer, parameter, public :: eta = 1, modulus = 2, radius = 3, hardness = 4, yield_factor = 5, &
      sigma = 6, friction_coefficient = 7, critical_slip = 8, n_properties = 8
   !> Those that a map gives
   integer, parameter, public :: of_surface(3) = [eta, radius, sigma]
   !> Those that two faces give
   integer, parameter, public :: of_faces(5) = [eta, modulus, radius, hardness, sigma]

   !> What a property is.
   type :: face_property
      !> Name and unit of its key, and what it is
      character(len=name_length) :: name
      character(len=8) :: unit
      character(len=64) :: help
   end type face_property

   !> In this order
   type(face_property), parameter, public :: face_properties(n_properties) = [ &
      face_property('eta', '1/mm^2', 'asperity density'), &
      face_property('modulus', 'MPa', 'equivalent modulus E* of the two faces (Eq. 4)'), &
      face_property('radius', 'mm', 'summit radius'), &
      face_property('hardness', 'MPa', 'hardness'), &
      face_property('yield_factor', '', &
      'mean contact pressure at first yield over hardness, 0.05 to 1'), &
      face_property('sigma', 'mm', 'standard deviation of summit heights'), &
      face_property('friction_coefficient', '', 'Coulomb friction coefficient mu'), &
      face_property('critical_slip', 'mm', 'largest elastic slip gcrit')]

contains

   !> The properties that a pair gives.
   pure function pair_values(pair) result(values)
      !> The pair
      type(pair_preset), intent(in) :: pair
      real(wp) :: values(n_properties)

      values = [pair%eta, pair%modulus, pair%radius, pair%hardness, pair%yield_factor, &
         pair%sigma, pair%friction_coefficient, pair%critical_slip]
   end function pair_values

end module asperity_program_commands_faces_properties
