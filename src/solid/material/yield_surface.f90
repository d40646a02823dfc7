!> Criteria of yield of wood, all of one form: sqrt((s - c)' P (s - c)) = yield stress, with
!> stresses s in the order LL, RR, TT, LR, LT, RT.
module asperity_solid_material_yield_surface
   use asperity_base_kinds, only: wp
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: yield_surface, find_yield_surface

   !> The form, and the yield stress before any plastic strain.
   type :: yield_surface
      !> P
      real(wp) :: matrix(6, 6) = 0.0_wp
      !> c, MPa
      real(wp) :: centre(6) = 0.0_wp
      !> Yield stress, MPa
      real(wp) :: stress = 0.0_wp
   end type yield_surface

contains

   !> The surface of checked wood whose criterion is not `none`.
   pure subroutine find_yield_surface(surface, wood, pressed_along_grain)
      !> Result
      type(yield_surface), intent(out) :: surface
      !> The wood; `crushing` where it is neither `mises` nor `hill`
      type(wood_properties), intent(in) :: wood
      !> For `mises`: whether the strength is that along the grain
      logical, intent(in) :: pressed_along_grain
      real(wp), parameter :: equal_strengths(3) = 1.0_wp

      associate (fc => wood%compression_strengths, p => surface%matrix)
         surface%stress = fc(2)
         select case (trim(wood%criterion))
         case ('mises')
            if (pressed_along_grain) surface%stress = fc(1)
            p(1:3, 1:3) = without_pressure(equal_strengths)
            call set_shear(p, [3.0_wp, 3.0_wp, 3.0_wp])
         case ('hill')
            p(1:3, 1:3) = without_pressure(fc/surface%stress)
            call set_shear(p, (surface%stress/wood%shear_strengths)**2)
         case default
            call find_crushing(surface, wood)
         end select
      end associate
   end subroutine find_yield_surface

   !> The sum of s_i^2/(ft_i fc_i) + s_i (1/ft_i - 1/fc_i) and of t_ij^2/fs_ij^2 is 1 at first: each
   !> strength is reached exactly, and wood crushes without a strain to its sides. The squares
   !> completed, it is an ellipsoid about (ft_i - fc_i)/2 with the half axes size*sqrt(ft_i fc_i).
   !> The yield stress is such that the equivalent plastic strain is that of first crushing in R.
   pure subroutine find_crushing(surface, wood)
      type(yield_surface), intent(inout) :: surface
      type(wood_properties), intent(in) :: wood
      real(wp) :: square_of_size
      integer :: i

      associate (ft => wood%tension_strengths, fc => wood%compression_strengths)
         square_of_size = 1.0_wp + 0.25_wp*sum((ft - fc)**2/(ft*fc))
         surface%stress = square_of_size*ft(2)*fc(2)/(0.5_wp*(ft(2) + fc(2)))
         surface%centre(1:3) = 0.5_wp*(ft - fc)
         do i = 1, 3
            surface%matrix(i, i) = surface%stress**2/(square_of_size*ft(i)*fc(i))
         end do
         call set_shear(surface%matrix, &
            (surface%stress/wood%shear_strengths)**2/square_of_size)
      end associate
   end subroutine find_crushing

   !> Hill's form of the normal stresses, which does not see their mean.
   pure function without_pressure(strengths) result(p)
      !> In the three directions, over the yield stress
      real(wp), intent(in) :: strengths(3)
      real(wp) :: p(3, 3)
      real(wp) :: half(3)
      integer :: i, j

      half = 0.5_wp/strengths**2
      do i = 1, 3
         p(i, i) = 2.0_wp*half(i)
         do j = 1, 3
            ! the third direction is 6 - i - j
            if (j /= i) p(i, j) = half(6 - i - j) - half(i) - half(j)
         end do
      end do
   end function without_pressure

   !> The shear stresses' share.
   pure subroutine set_shear(p, squares)
      real(wp), intent(inout) :: p(6, 6)
      real(wp), intent(in) :: squares(3)
      integer :: i

      do i = 1, 3
         p(3 + i, 3 + i) = squares(i)
      end do
   end subroutine set_shear

end module asperity_solid_material_yield_surface
