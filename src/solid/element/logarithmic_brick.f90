!> The brick with logarithmic strain, for strains of any size: that of each point's own deformation
!> gradient, so that nothing needs turning and the axes of wood are those of the undeformed shape.
!>
!> The mean dilatation of the element takes the place of each point's: strains are
!> E + (mean of tr E - tr E)/3 I. Stress T works on them; its forces are the derivatives of the
!> energy, those of T on E with the element's mean pressure in place of each point's. T is over the
!> undeformed volume: the force over the undeformed area is T over the stretch.
module asperity_solid_element_logarithmic_brick
   use asperity_base_kinds, only: wp
   use asperity_solid_element_logarithmic_strain, only: add_tangent, deform_point, &
      deformed_point, forces_of
   use asperity_solid_element_rotation, only: is_inverted
   use asperity_solid_element_shape, only: brick
   use asperity_solid_material_material, only: material_point, solid_material, update_material
   implicit none
   private
   public :: logarithmic_response

   !> Normal strains without shear
   real(wp), parameter :: identity(6) = [1.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp]

contains

   !> Internal forces of an element, and the state of its integration points, as `brick_response`
   !> has them.
   pure subroutine logarithmic_response(shape, material, positions, eigenstrain, start, end, &
      forces, n_yielding, tangent, inverted)
      !> The element's shape
      type(brick), intent(in) :: shape
      !> The material
      type(solid_material), intent(in) :: material
      !> Where the corners are, mm
      real(wp), intent(in) :: positions(3, 8)
      !> Logarithmic strain without stress, along the axes of the undeformed element
      real(wp), intent(in) :: eigenstrain(6)
      !> Integration points at the start of the increment
      type(material_point), intent(in) :: start(8)
      !> The same now; as at the start when `inverted`
      type(material_point), intent(out) :: end(8)
      !> Internal forces on the corners, N; zero when `inverted`
      real(wp), intent(out) :: forces(3, 8)
      !> Integration points that yield
      integer, intent(out) :: n_yielding
      !> Derivative of the forces by the positions, symmetric, N/mm; zero when `inverted`
      real(wp), intent(out), optional :: tangent(24, 24)
      !> The element is turned inside out or flat at an integration point
      logical, intent(out) :: inverted
      type(deformed_point) :: points(8)
      real(wp) :: shares(8), dilatation, pressure, strain(6), stress(6), stiffness(6, 6, 8)
      integer :: g
      logical :: yields

      end = start
      forces = 0.0_wp
      n_yielding = 0
      if (present(tangent)) tangent = 0.0_wp
      call deform_points(points, shape, positions, inverted)
      if (inverted) return
      shares = shape%weights/sum(shape%weights)
      dilatation = 0.0_wp
      do g = 1, 8
         dilatation = dilatation + shares(g)*sum(points(g)%strains)
      end do
      pressure = 0.0_wp
      do g = 1, 8
         strain = matmul(points(g)%turn(:, 1:3), points(g)%strains) - eigenstrain &
            + (dilatation - sum(points(g)%strains))/3.0_wp*identity
         if (present(tangent)) then
            call update_material(material, start(g), strain, end(g), yields, stiffness(:, :, g))
            if (.not. yields) stiffness(:, :, g) = material%stiffness
         else
            call update_material(material, start(g), strain, end(g), yields)
         end if
         if (yields) n_yielding = n_yielding + 1
         pressure = pressure + shares(g)*sum(end(g)%stress(1:3))/3.0_wp
      end do
      do g = 1, 8
         stress = end(g)%stress + (pressure - sum(end(g)%stress(1:3))/3.0_wp)*identity
         stress = matmul(stress, points(g)%turn)
         forces = forces + shape%weights(g)*forces_of(points(g), stress)
         if (present(tangent)) call add_tangent(tangent, points(g), stress, &
            without_dilatation(stiffness(:, :, g), points(g)%turn), shape%weights(g))
      end do
      if (present(tangent)) call add_mean_dilatation(tangent, points, shape%weights, stiffness)
   end subroutine logarithmic_response

   !> The integration points of a deformed element.
   pure subroutine deform_points(points, shape, positions, inverted)
      type(deformed_point), intent(out) :: points(8)
      type(brick), intent(in) :: shape
      real(wp), intent(in) :: positions(3, 8)
      logical, intent(out) :: inverted
      real(wp) :: places(3, 8), gradient(3, 3)
      integer :: a, g

      do a = 1, 8
         places(:, a) = positions(:, a) - positions(:, 1)
      end do
      do g = 1, 8
         gradient = matmul(places, transpose(shape%gradients(:, :, g)))
         inverted = is_inverted(gradient)
         if (inverted) return
         call deform_point(points(g), gradient, shape%gradients(:, :, g))
      end do
   end subroutine deform_points

   !> Stiffness along the principal directions against strains without dilatation, of stresses
   !> without pressure.
   pure function without_dilatation(stiffness, turn) result(d)
      real(wp), intent(in) :: stiffness(6, 6), turn(6, 6)
      real(wp) :: d(6, 6), pressed(6)
      integer :: i

      d = matmul(transpose(turn), matmul(stiffness, turn))
      pressed = sum(d(:, 1:3), 2)/3.0_wp
      pressed = pressed - sum(pressed(1:3))/6.0_wp*identity
      do i = 1, 6
         d(:, i) = d(:, i) - pressed*identity(i) - identity*pressed(i)
      end do
   end function without_dilatation

   !> Add what stiffness the mean dilatation has: by the stresses that it makes, and by the pressure
   !> that strains without dilatation make.
   pure subroutine add_mean_dilatation(tangent, points, weights, stiffness)
      real(wp), intent(inout) :: tangent(24, 24)
      type(deformed_point), intent(in) :: points(8)
      real(wp), intent(in) :: weights(8), stiffness(6, 6, 8)
      real(wp) :: dilatation(24), mixed(24), pressed(6), bulk, stiff
      integer :: g, j

      dilatation = 0.0_wp
      mixed = 0.0_wp
      stiff = 0.0_wp
      do g = 1, 8
         dilatation = dilatation + reshape(weights(g)*forces_of(points(g), identity), [24])
         pressed = matmul(sum(stiffness(:, 1:3, g), 2)/3.0_wp, points(g)%turn)
         bulk = sum(pressed(1:3))/3.0_wp
         mixed = mixed + reshape(weights(g)*forces_of(points(g), pressed - bulk*identity), [24])
         stiff = stiff + weights(g)*bulk
      end do
      dilatation = dilatation/sum(weights)
      mixed = mixed + 0.5_wp*stiff*dilatation
      do j = 1, 24
         tangent(:, j) = tangent(:, j) + mixed*dilatation(j) + dilatation*mixed(j)
      end do
   end subroutine add_mean_dilatation

end module asperity_solid_element_logarithmic_brick
