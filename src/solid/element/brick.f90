!> Eight-node brick with 2 x 2 x 2 integration points and mean dilatation (B-bar), corotational:
!> strains are small in a frame that turns with the element, so that its operators stay those of
!> the undeformed shape (T. J. R. Hughes, Int. J. Numer. Meth. Eng. 15, 1980, 1413).
!>
!> Stress is that of Biot, the force over the undeformed area, and goes with engineering strain:
!> what crushing tests of wood measure. Voigt order xx yy zz xy yz zx, engineering shear strains.
module asperity_solid_element_brick
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_mesh_hexahedra, only: natural_corners
   use asperity_solid_element_corotation, only: balance_forces, complete_tangent, element_frame, &
      new_frame
   use asperity_solid_material_material, only: material_point, solid_material, update_material
   use asperity_solid_small_matrices, only: invert
   implicit none
   private
   public :: brick, new_brick, brick_response

   !> Volume over the cube of the longest edge, below which an element counts as flat
   real(wp), parameter :: flat = 1.0e-9_wp

   !> What all elements of one shape and elastic stiffness share.
   type :: brick
      !> Strains at each integration point from displacements of the corners, 1/mm
      real(wp) :: strain_operator(6, 24, 8) = 0.0_wp
      !> Volume of each integration point, mm^3
      real(wp) :: weights(8) = 0.0_wp
      !> Mean gradients of the corners' shape functions, 1/mm
      real(wp) :: mean_gradients(3, 8) = 0.0_wp
      !> Elastic stiffness of the undeformed element, N/mm
      real(wp) :: stiffness(24, 24) = 0.0_wp
      !> Corners from the first, mm
      real(wp) :: corners(3, 8) = 0.0_wp
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
      real(wp) :: gradients(3, 8, 8), jacobian(3, 3), inverse(3, 3), longest
      integer :: g, a

      do a = 1, 8
         shape%corners(:, a) = corners(:, a) - corners(:, 1)
      end do
      longest = maxval(abs(shape%corners))
      do g = 1, 8
         gradients(:, :, g) = natural_gradients(natural_corners(:, g)/sqrt(3.0_wp))
         jacobian = matmul(shape%corners, transpose(gradients(:, :, g)))
         call invert(jacobian, inverse, shape%weights(g))
         if (.not. 8.0_wp*shape%weights(g) > flat*longest**3) then
            call fatal_error(error, 'an element is inverted or flat: by its shape at '// &
               'integration point '//to_text(g)//' its volume is '// &
               to_text(8.0_wp*shape%weights(g), 3)//' mm^3 and must be positive; corners 1 to '// &
               '4 go round one face, clockwise seen from outside, 5 to 8 lie opposite to them')
            return
         end if
         gradients(:, :, g) = matmul(transpose(inverse), gradients(:, :, g))
         shape%mean_gradients = shape%mean_gradients + shape%weights(g)*gradients(:, :, g)
      end do
      shape%mean_gradients = shape%mean_gradients/sum(shape%weights)
      do g = 1, 8
         call set_strain_operator(shape%strain_operator(:, :, g), gradients(:, :, g), &
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
      real(wp), intent(inout) :: matrix(24, 24)
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

   !> Internal forces of an element, and the state of its integration points.
   pure subroutine brick_response(shape, material, positions, eigenstrain, start, end, forces, &
      n_yielding, tangent, inverted)
      !> The element's operators, made with the material's stiffness
      type(brick), intent(in) :: shape
      !> The material
      type(solid_material), intent(in) :: material
      !> Where the corners are, mm
      real(wp), intent(in) :: positions(3, 8)
      !> Strain without stress, as of swelling, along the axes of the undeformed element
      real(wp), intent(in) :: eigenstrain(6)
      !> Integration points at the start of the increment
      type(material_point), intent(in) :: start(8)
      !> The same now; as at the start when `inverted`
      type(material_point), intent(out) :: end(8)
      !> Internal forces on the corners in global axes, N; zero when `inverted`
      real(wp), intent(out) :: forces(3, 8)
      !> Integration points that yield
      integer, intent(out) :: n_yielding
      !> Derivative of the forces by the positions, corner by corner x y z, symmetric, N/mm; zero
      !> when `inverted`
      real(wp), intent(out), optional :: tangent(24, 24)
      !> The element is turned inside out or flat: its iterate is to be refused
      logical, intent(out) :: inverted
      type(element_frame) :: frame
      real(wp) :: f0(3, 8), balanced(3, 8), turned(3)
      integer :: a

      call new_frame(frame, shape%corners, shape%mean_gradients, positions)
      inverted = frame%inverted
      if (inverted) then
         end = start
         forces = 0.0_wp
         n_yielding = 0
         if (present(tangent)) tangent = 0.0_wp
         return
      end if
      if (present(tangent)) tangent = shape%stiffness
      call add_points(shape, material, frame%displacements, eigenstrain, start, end, f0, &
         n_yielding, tangent)
      call balance_forces(frame, shape%mean_gradients, f0, balanced, turned)
      do a = 1, 8
         forces(:, a) = frame%rotation(:, 1)*balanced(1, a) + frame%rotation(:, 2)*balanced(2, a) &
            + frame%rotation(:, 3)*balanced(3, a)
      end do
      if (present(tangent)) &
         call complete_tangent(frame, shape%mean_gradients, f0, balanced, turned, tangent)
   end subroutine brick_response

   !> Stresses at the integration points and their forces in the element's frame; what yields
   !> softens the tangent.
   pure subroutine add_points(shape, material, displacements, eigenstrain, start, end, forces, &
      n_yielding, tangent)
      type(brick), intent(in) :: shape
      type(solid_material), intent(in) :: material
      real(wp), intent(in) :: displacements(24), eigenstrain(6)
      type(material_point), intent(in) :: start(8)
      type(material_point), intent(out) :: end(8)
      real(wp), intent(out) :: forces(24)
      integer, intent(out) :: n_yielding
      real(wp), intent(inout), optional :: tangent(24, 24)
      real(wp) :: strain(6), stress(6), softened(6, 6)
      integer :: g, j
      logical :: yields

      forces = 0.0_wp
      n_yielding = 0
      do g = 1, 8
         strain = -eigenstrain
         do j = 1, 24
            strain = strain + shape%strain_operator(:, j, g)*displacements(j)
         end do
         if (present(tangent)) then
            call update_material(material, start(g), strain, end(g), yields, softened)
         else
            call update_material(material, start(g), strain, end(g), yields)
         end if
         stress = shape%weights(g)*end(g)%stress
         do j = 1, 24
            forces(j) = forces(j) + dot_product(shape%strain_operator(:, j, g), stress)
         end do
         if (.not. yields) cycle
         n_yielding = n_yielding + 1
         if (present(tangent)) call add_stiffness(tangent, shape%strain_operator(:, :, g), &
            shape%weights(g)*(softened - material%stiffness))
      end do
   end subroutine add_points

end module asperity_solid_element_brick
