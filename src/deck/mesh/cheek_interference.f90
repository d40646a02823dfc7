!> The interference at which the sides of the mortise press upon the tenon.
!>
!> The cheek of the column is taken for a beam that bends and shears, from -a to a between the ends
!> of the mortise. There it lies on springs of stiffness kc: contact, and the half tenon that it
!> squeezes. Beyond, the wood between it and the plane of symmetry is an elastic foundation k.
!> Per width of cheek, with deflection w outwards, rotation theta, bending stiffness EI, shear
!> stiffness S:
!>
!>     V = S (w' - theta),  M = EI theta',  M' = -V,  V' = k w beyond, kc (w - d) in the mortise
!>
!> - beyond: w = C1 exp(-r1 z) + C2 exp(-r2 z) with r1 r2 = q = sqrt(k/EI) and
!>   r1 + r2 = r = sqrt(k/S + 2 q), so that at its end k w = -r V + q M and k theta = q V - r q M;
!> - in the mortise: w - d = C3 cosh(s3 z) + C4 cosh(s4 z), s^4 - (kc/S) s^2 + kc/EI = 0; the roots
!>   may be complex.
!>
!> The mean pressure is -V(a)/a, in proportion to the interference d.
module asperity_deck_mesh_cheek_interference
   use asperity_base_kinds, only: wp
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: side_interference

   !> Share of the section that carries shear
   real(wp), parameter :: shear_area = 5.0_wp/6.0_wp

contains

   !> Interference at each side for a mean pressure, mm.
   pure real(wp) function side_interference(pressure, overclosure, wood, width, height, &
         column_width) result(interference)
      !> Mean pressure, MPa, and overclosure of contact at it, mm
      real(wp), intent(in) :: pressure, overclosure
      !> The wood: of the column, with R across its cheek, and of the tenon, with T across its width
      type(wood_properties), intent(in) :: wood
      !> Width of the tenon, height of the mortise, width of the column, mm
      real(wp), intent(in) :: width, height, column_width
      complex(wp) :: s(2), at_end(2), shear_force(2), moment(2), rotation(2), matrix(2, 2), part(2)
      real(wp) :: thickness, bending, shear, foundation, springs, q, r, a

      a = 0.5_wp*height
      thickness = 0.5_wp*(column_width - width)
      bending = wood%young_moduli(1)*thickness**3/12.0_wp
      shear = shear_area*wood%shear_moduli(1)*thickness
      foundation = wood%young_moduli(2)/(0.5_wp*width)
      springs = 1.0_wp/(overclosure/pressure + 0.5_wp*width/wood%young_moduli(3))

      s = springs/shear
      s(1) = s(1) + sqrt(s(1)**2 - 4.0_wp*springs/bending)
      s(2) = 2.0_wp*s(2) - s(1)
      s = sqrt(0.5_wp*s)
      ! scaled by exp(-s a), so that nothing overflows
      at_end = 0.5_wp*(1.0_wp + exp(-2.0_wp*s*a))
      shear_force = springs/s*0.5_wp*(1.0_wp - exp(-2.0_wp*s*a))
      moment = -springs/s**2*at_end
      rotation = s*0.5_wp*(1.0_wp - exp(-2.0_wp*s*a)) - shear_force/shear

      q = sqrt(foundation/bending)
      r = sqrt(foundation/shear + 2.0_wp*q)
      matrix(1, :) = at_end - (-r*shear_force + q*moment)/foundation
      matrix(2, :) = rotation - (q*shear_force - r*q*moment)/foundation
      ! matrix * part = [-d, 0], with d = 1
      part = [-matrix(2, 2), matrix(2, 1)]/(matrix(1, 1)*matrix(2, 2) - matrix(1, 2)*matrix(2, 1))
      interference = -pressure*a/real(sum(part*shear_force), wp)
   end function side_interference

end module asperity_deck_mesh_cheek_interference
