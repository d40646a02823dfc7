!> Eight-node brick with 2 x 2 x 2 integration points and mean dilatation (B-bar), of one of two
!> strain measures. Logarithmic strain has a module of its own. With engineering strain the brick
!> is corotational: strains are small in a frame that turns with the element, so that its operators
!> stay those of the undeformed shape.
!>
!> Stress is then that of Biot, the force over the undeformed area: what crushing tests of wood
!> measure. Voigt order xx yy zz xy yz zx, engineering shear strains.
module asperity_solid_element_brick
   use asperity_base_kinds, only: wp
   use asperity_solid_element_corotation, only: balance_forces, complete_tangent, element_frame, &
      new_frame
   use asperity_solid_element_logarithmic_brick, only: logarithmic_response
   use asperity_solid_element_shape, only: add_stiffness, brick, new_brick
   use asperity_solid_material_material, only: material_point, solid_material, update_material
   implicit none
   private
   public :: brick, new_brick, brick_response

contains

   !> Internal forces of an element, and the state of its integration points.
   pure subroutine brick_response(shape, material, positions, eigenstrain, start, end, forces, &
      n_yielding, tangent, inverted)
      !> The element's operators, made with the material's stiffness
      type(brick), intent(in) :: shape
      !> The material
      type(solid_material), intent(in) :: material
      !> Where the corners are, mm
      real(wp), intent(in) :: positions(3, 8)
      !> Strain without stress, as of swelling, along the axes of the undeformed element, in the
      !> element's measure
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

      if (shape%is_logarithmic) then
         call logarithmic_response(shape, material, positions, eigenstrain, start, end, forces, &
            n_yielding, tangent, inverted)
         return
      end if
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
