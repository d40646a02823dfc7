!> Logarithmic strain E = ln(F'F)/2 at a point of an element, and its derivatives by the places of
!> the corners (C. Miehe, N. Apel, M. Lambrecht, Comput. Methods Appl. Mech. Engrg. 191, 2002,
!> 5383). All that is symmetric has its components along the principal directions N of C = F'F, in
!> the order 11 22 33 12 23 31; with the first differences f of the logarithm at the eigenvalues of
!> C, and its second ones g,
!>    dE_ij = f_ij dC_ij/2,   T : d2E = sum T_ij (f_ij d2C_ij/2 + sum_k g_ikj dC_ik dC_kj).
module asperity_solid_element_logarithmic_strain
   use asperity_base_kinds, only: wp
   use asperity_solid_element_logarithm, only: first_differences, second_differences
   use asperity_solid_element_principal_stretches, only: find_principal_stretches
   use asperity_solid_element_shape, only: add_stiffness
   implicit none
   private
   public :: deformed_point, deform_point, forces_of, add_tangent

   !> A deformed point.
   type :: deformed_point
      !> Images F N of the principal directions, in columns
      real(wp) :: images(3, 3) = 0.0_wp
      !> Eigenvalues of C, squares of the principal stretches
      real(wp) :: values(3) = 0.0_wp
      !> Principal strains
      real(wp) :: strains(3) = 0.0_wp
      !> Gradients of the corners' shape functions along N, 1/mm
      real(wp) :: gradients(3, 8) = 0.0_wp
      !> Strains xx yy zz xy yz zx from those along N, shear strains as angles; its transpose takes
      !> stresses the other way
      real(wp) :: turn(6, 6) = 0.0_wp
      !> First differences of the logarithm, of all pairs of eigenvalues
      real(wp) :: slopes(3, 3) = 0.0_wp
   end type deformed_point

   !> What stands in each place of 11 22 33 12 23 31, and the place of each component
   integer, parameter :: first(6) = [1, 2, 3, 1, 2, 3], second(6) = [1, 2, 3, 2, 3, 1]
   integer, parameter :: place_of(3, 3) = reshape([1, 4, 6, 4, 2, 5, 6, 5, 3], [3, 3])

contains

   !> Deform a point.
   pure subroutine deform_point(point, gradient, gradients)
      !> Result
      type(deformed_point), intent(out) :: point
      !> Deformation gradient F, its determinant above zero
      real(wp), intent(in) :: gradient(3, 3)
      !> Gradients of the corners' shape functions, 1/mm
      real(wp), intent(in) :: gradients(3, 8)
      real(wp) :: directions(3, 3)
      integer :: i

      call find_principal_stretches(gradient, directions, point%images)
      point%values = sum(point%images**2, 1)
      point%strains = 0.5_wp*log(point%values)
      point%gradients = matmul(transpose(directions), gradients)
      point%slopes = first_differences(point%values)
      do i = 1, 6
         associate (a => directions(:, first(i)), b => directions(:, second(i)))
            point%turn(1:3, i) = a*b
            point%turn(4:6, i) = a(first(4:6))*b(second(4:6)) + a(second(4:6))*b(first(4:6))
         end associate
      end do
   end subroutine deform_point

   !> Forces on the corners by which a stress works on the strain, N over mm^3 of the point: sum of
   !> stress times derivative of E.
   pure function forces_of(point, stress) result(forces)
      !> The point
      type(deformed_point), intent(in) :: point
      !> Stress along the principal directions, MPa
      real(wp), intent(in) :: stress(6)
      real(wp) :: forces(3, 8), tensor(3, 3)

      tensor = on_stretches(point, stress)
      tensor = matmul(point%images, tensor)
      forces = matmul(tensor, point%gradients)
   end function forces_of

   !> Add the derivative of the forces of a stress by the places of the corners.
   pure subroutine add_tangent(tangent, point, stress, stiffness, volume)
      !> The sum, N/mm
      real(wp), intent(inout) :: tangent(24, 24)
      !> The point
      type(deformed_point), intent(in) :: point
      !> Stress along the principal directions, MPa
      real(wp), intent(in) :: stress(6)
      !> Its derivative by the strain, symmetric, MPa
      real(wp), intent(in) :: stiffness(6, 6)
      !> Volume of the undeformed point, mm^3
      real(wp), intent(in) :: volume
      real(wp) :: operator(6, 24), d(6, 6), slopes(6), tensor(3, 3), turned(3, 8), geometric
      integer :: a, b, i, k

      do i = 1, 6
         slopes(i) = point%slopes(first(i), second(i))
      end do
      do i = 1, 6
         d(:, i) = slopes*stiffness(:, i)*slopes(i)
      end do
      call add_curvature(d, point, stress)
      ! changes of C/2, shear as angles
      do a = 1, 8
         k = 3*a - 2
         do i = 1, 3
            operator(i, k:k + 2) = point%images(:, i)*point%gradients(i, a)
         end do
         do i = 4, 6
            operator(i, k:k + 2) = point%images(:, first(i))*point%gradients(second(i), a) &
               + point%images(:, second(i))*point%gradients(first(i), a)
         end do
      end do
      call add_stiffness(tangent, operator, volume*d)
      tensor = volume*on_stretches(point, stress)
      turned = matmul(tensor, point%gradients)
      do b = 1, 8
         do a = 1, 8
            geometric = dot_product(point%gradients(:, a), turned(:, b))
            do i = 0, 2
               tangent(3*a - i, 3*b - i) = tangent(3*a - i, 3*b - i) + geometric
            end do
         end do
      end do
   end subroutine add_tangent

   !> The stress that works on C/2 as the given one does on E: Piola and Kirchhoff's second one.
   pure function on_stretches(point, stress) result(tensor)
      type(deformed_point), intent(in) :: point
      real(wp), intent(in) :: stress(6)
      real(wp) :: tensor(3, 3)

      tensor = point%slopes*reshape(stress(reshape(place_of, [9])), [3, 3])
   end function on_stretches

   !> Add what a stress has by the second derivative of the logarithm, to the stiffness that goes
   !> with changes of C/2, shear as angles.
   pure subroutine add_curvature(stiffness, point, stress)
      real(wp), intent(inout) :: stiffness(6, 6)
      type(deformed_point), intent(in) :: point
      real(wp), intent(in) :: stress(6)
      real(wp) :: curvature(3, 3, 3)
      integer :: i, j, k

      curvature = second_differences(point%values, point%slopes)
      do k = 1, 3
         do j = 1, 3
            do i = 1, 3
               associate (place => stiffness(place_of(i, k), place_of(k, j)))
                  place = place + stress(place_of(i, j))*curvature(i, k, j) &
                     *merge(2.0_wp, 1.0_wp, i == k)*merge(2.0_wp, 1.0_wp, k == j)
               end associate
            end do
         end do
      end do
   end subroutine add_curvature

end module asperity_solid_element_logarithmic_strain
