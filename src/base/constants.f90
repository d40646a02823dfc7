!> Constants of mathematics.
module asperity_base_constants
   use asperity_base_kinds, only: wp
   implicit none
   private

   real(wp), parameter, public :: pi = acos(-1.0_wp)
end module asperity_base_constants
