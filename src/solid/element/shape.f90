!> The undeformed shape of an eight-node brick with 2 x 2 x 2 integration points and mean
!> dilatation (B-bar; T. J. R. Hughes, Int. J. Numer. Meth. Eng. 15, 1980, 1413), and its operators.
!>
!> Voigt order xx yy zz xy yz zx, engineering shear strains.
module asperity_solid_element_shape
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_mesh_hexahedra, only: natural_corners
   use asperity_solid_small_matrices, only: invert
   implicit none
   private
   public :: brick, new_brick, add_stiffness

   !> Volume over the cube of the longest edge, below which an element counts as flat
   real(wp), parameter :: flat = 1.0e-9_wp

   !> What all elements of one shape and elastic stiffness share.
   type :: brick
      !> Strains at each integration point from displacements of the corners, 1/mm
      real(wp) :: strain_operator(6, 24, 8) = 0.0_wp
      !> Volume of each integration point, mm^3
      real(wp) :: weights(8) = 0.0_wp
      !> Gradients of the corners' shape functions at each integration point, and their means, 1/mm
      real(wp) :: gradients(3, 8, 8) = 0.0_wp, mean_gradients(3, 8) = 0.0_wp
      !> Elastic stiffness of the undeformed element, N/mm
      real(wp) :: stiffness(24, 24) = 0.0_wp
      !> Corners from the first, mm
      real(wp) :: corners(3, 8) = 0.0_wp
      !> Whether strain is logarithmic, not engineering strain
      logical :: is_logarithmic = .false.
   end type brick

contains

   !> Operators of an element.
   pure subroutine new_brick(shape, corners, stiffness, error)
      !> Result
      type(brick), intent(out) :: shape
      !> Corners in the order of C3D8, mm
      real(wp), intent(in) :: corners(3, 8)
      !> Elastic stiffness of the material, symmetric, MPa
      real(wp), intent(in) :: stiffness(6, 6)
      !> Set when the corners enclose no volume at an integration point
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: jacobian(3, 3), inverse(3, 3), longest
      integer :: g, a

      do a = 1, 8
         shape%corners(:, a) = corners(:, a) - corners(:, 1)
      end do
      longest = maxval(abs(shape%corners))
      do g = 1, 8
         shape%gradients(:, :, g) = natural_gradients(natural_corners(:, g)/sqrt(3.0_wp))
         jacobian = matmul(shape%corners, transpose(shape%gradients(:, :, g)))
         call invert(jacobian, inverse, shape%weights(g))
         if (.not. 8.0_wp*shape%weights(g) > flat*longest**3) then
            call fatal_error(error, 'an element is inverted or flat: by its shape at '// &
               'integration point '//to_text(g)//' its volume is '// &
               to_text(8.0_wp*shape%weights(g), 3)//' mm^3 and must be positive; corners 1 to '// &
               '4 go round one face, clockwise seen from outside, 5 to 8 lie opposite to them')
            return
         end if
         shape%gradients(:, :, g) = matmul(transpose(inverse), shape%gradients(:, :, g))
         shape%mean_gradients = shape%mean_gradients + shape%weights(g)*shape%gradients(:, :, g)
      end do
      shape%mean_gradients = shape%mean_gradients/sum(shape%weights)
      do g = 1, 8
         call set_strain_operator(shape%strain_operator(:, :, g), shape%gradients(:, :, g), &
            shape%mean_gradients)
         call add_stiffness(shape%stiffness, shape%strain_operator(:, :, g), &
            shape%weights(g)*stiffness)
      end do
   end subroutine new_brick

   !> Derivatives of the corners' shape functions by natural coordinates at a point.
   pure function natural_gradients(point) result(gradients)
      real(wp), intent(in) :: point(3)
      real(wp) :: gradients(3, 8), s(3)
      integer :: a

      do a = 1, 8
         s = 1.0_wp + natural_corners(:, a)*point
         gradients(:, a) = 0.125_wp*natural_corners(:, a)*[s(2)*s(3), s(3)*s(1), s(1)*s(2)]
      end do
   end function natural_gradients

   !> Strains from displacements at a point; the dilatation is the element's mean.
   pure subroutine set_strain_operator(operator, gradients, mean_gradients)
      real(wp), intent(out) :: operator(6, 24)
      real(wp), intent(in) :: gradients(3, 8), mean_gradients(3, 8)
      integer, parameter :: first(3) = [1, 2, 3], second(3) = [2, 3, 1]
      integer :: a, i, k

      operator = 0.0_wp
      do a = 1, 8
         k = 3*(a - 1)
         do i = 1, 3
            operator(1:3, k + i) = (mean_gradients(i, a) - gradients(i, a))/3.0_wp
            operator(i, k + i) = operator(i, k + i) + gradients(i, a)
            operator(3 + i, k + first(i)) = gradients(second(i), a)
            operator(3 + i, k + second(i)) = gradients(first(i), a)
         end do
      end do
   end subroutine set_strain_operator

   !> Add B'D B, which is symmetric.
   pure subroutine add_stiffness(matrix, operator, d)
      !> The sum, N/mm
      real(wp), intent(inout) :: matrix(24, 24)
      !> B, strains from displacements of the corners, 1/mm, and D, symmetric, N mm
      real(wp), intent(in) :: operator(6, 24), d(6, 6)
      real(wp) :: rows(24, 6), column(6)
      integer :: i, j

      do i = 1, 6
         rows(:, i) = operator(i, :)
      end do
      do j = 1, 24
         column = d(:, 1)*operator(1, j) + d(:, 2)*operator(2, j) + d(:, 3)*operator(3, j) &
            + d(:, 4)*operator(4, j) + d(:, 5)*operator(5, j) + d(:, 6)*operator(6, j)
         matrix(:, j) = matrix(:, j) + rows(:, 1)*column(1) + rows(:, 2)*column(2) &
            + rows(:, 3)*column(3) + rows(:, 4)*column(4) + rows(:, 5)*column(5) &
            + rows(:, 6)*column(6)
      end do
   end subroutine add_stiffness

end module asperity_solid_element_shape
