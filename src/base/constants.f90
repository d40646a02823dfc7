!> Constants of mathematics.
module asperity_constants
   use asperity_kinds, only: wp
   implicit none
   private

   real(wp), parameter, public :: pi = acos(-1.0_wp)
end module asperity_constants
