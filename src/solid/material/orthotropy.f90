!> Elasticity of wood, and the place of its directions in the global axes.
module asperity_solid_material_orthotropy
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_small_matrices, only: invert
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: components_of, compliance_of, stiffness_of

contains

   !> Places of the components LL, RR, TT, LR, LT, RT in xx, yy, zz, xy, yz, zx. `error` is set
   !> unless the axes are two of the three.
   pure subroutine components_of(components, grain, radial, error)
      !> The places
      integer, intent(out) :: components(6)
      !> Global axes, 1 to 3, along which L and R lie
      integer, intent(in) :: grain, radial
      !> Set when they are none
      type(error_type), allocatable, intent(out) :: error
      integer :: tangential

      components = 0
      if (min(grain, radial) < 1 .or. max(grain, radial) > 3 .or. grain == radial) then
         call fatal_error(error, 'axes '//to_text(grain)//' along the grain and '// &
            to_text(radial)//' in the radial direction are not allowed: they must be two of '// &
            '1, 2 and 3', subject='grain radial')
         return
      end if
      tangential = 6 - grain - radial
      ! a shear strain is known by the axis that has no part in it: z, x and y
      components = [grain, radial, tangential, 4 + mod(tangential, 3), 4 + mod(radial, 3), &
         4 + mod(grain, 3)]
   end subroutine components_of

   !> Strains of unit stresses, 1/MPa, in the order LL, RR, TT, LR, LT, RT; of checked wood.
   pure function compliance_of(wood) result(compliance)
      !> The wood
      type(wood_properties), intent(in) :: wood
      real(wp) :: compliance(6, 6)
      integer :: i

      compliance = 0.0_wp
      associate (e => wood%young_moduli, nu => wood%poisson_ratios)
         compliance(1, 2:3) = -nu(1:2)/e(1)
         compliance(2, 3) = -nu(3)/e(2)
         compliance(2:3, 1) = compliance(1, 2:3)
         compliance(3, 2) = compliance(2, 3)
         do i = 1, 3
            compliance(i, i) = 1.0_wp/e(i)
            compliance(3 + i, 3 + i) = 1.0_wp/wood%shear_moduli(i)
         end do
      end associate
   end function compliance_of

   !> Its inverse, MPa.
   pure function stiffness_of(wood) result(stiffness)
      !> The wood
      type(wood_properties), intent(in) :: wood
      real(wp) :: stiffness(6, 6)
      real(wp) :: compliance(6, 6), normal(3, 3), inverse(3, 3), scales(3), determinant
      integer :: i

      compliance = compliance_of(wood)
      ! scaled to ones on the diagonal
      scales = sqrt(wood%young_moduli)
      do i = 1, 3
         normal(:, i) = compliance(1:3, i)*(scales*scales(i))
      end do
      call invert(normal, inverse, determinant)
      inverse = 0.5_wp*(inverse + transpose(inverse))
      stiffness = 0.0_wp
      do i = 1, 3
         stiffness(1:3, i) = inverse(:, i)*(scales*scales(i))
         stiffness(3 + i, 3 + i) = wood%shear_moduli(i)
      end do
   end function stiffness_of

end module asperity_solid_material_orthotropy
