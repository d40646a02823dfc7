!> Plastic wood: orthotropic elasticity, a criterion of yield with the flow normal to it, isotropic
!> hardening. Strains are small, stresses and strains in the order xx, yy, zz, xy, yz, zx of the
!> global axes, shear strains as angles.
!>
!> The wood's directions lie in global axes, so normal and shear stresses part everywhere: only the
!> block of the normal ones is a matrix.
module asperity_solid_material_material
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_solid_material_eigenvectors, only: find_eigenvectors
   use asperity_solid_material_hardening, only: hardening_curve, &
      new_hardening_curve, yield_stress
   use asperity_solid_material_orthotropy, only: compliance_of, components_of, stiffness_of
   use asperity_solid_material_return_map, only: find_multiplier
   use asperity_solid_material_yield_surface, only: find_yield_surface, yield_surface
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: solid_material, material_point, new_solid_material, update_material, &
      elastic_energy_density

   !> Wood in place.
   type :: solid_material
      !> Stresses of unit strains, MPa, and strains of unit stresses, 1/MPa
      real(wp) :: stiffness(6, 6) = 0.0_wp, compliance(6, 6) = 0.0_wp
      !> Whether it can yield
      logical :: is_plastic = .false.
      type(yield_surface), private :: surface
      type(hardening_curve), private :: hardening
      !> Common eigenvectors T of stiffness C and surface P, the normal stresses' and the shear
      !> stresses': T T' = C, and T' P T is diagonal with the eigenvalues
      real(wp), private :: normal_vectors(3, 3) = 0.0_wp, shear_vectors(3) = 0.0_wp, &
         eigenvalues(6) = 0.0_wp
      !> The centre of the surface in these vectors
      real(wp), private :: centre(3) = 0.0_wp
   end type solid_material

   !> What one integration point remembers.
   type :: material_point
      !> Plastic strain, and the equivalent one
      real(wp) :: plastic_strain(6) = 0.0_wp, equivalent_strain = 0.0_wp
      !> Stress, MPa
      real(wp) :: stress(6) = 0.0_wp
   end type material_point

   !> How far outside the surface a stress is taken for one on it, relatively: rounding, by which a
   !> point that has yielded would yield again
   real(wp), parameter :: yield_tolerance = 1.0e-12_wp

contains

   !> Put wood in place. `error` is set when the wood or the axes are refused.
   pure subroutine new_solid_material(material, wood, grain, radial, pressed_along_grain, error)
      !> Result
      type(solid_material), intent(out) :: material
      !> The wood
      type(wood_properties), intent(in) :: wood
      !> Global axes, 1 to 3, along which L and R lie
      integer, intent(in) :: grain, radial
      !> For `mises`, which knows one strength: whether strength and hardening are those along the
      !> grain
      logical, intent(in) :: pressed_along_grain
      !> Set when the material is refused
      type(error_type), allocatable, intent(out) :: error
      type(yield_surface) :: surface
      integer :: components(6)

      call check_wood_properties(wood, error)
      if (.not. allocated(error)) call components_of(components, grain, radial, error)
      if (allocated(error)) return
      material%compliance(components, components) = compliance_of(wood)
      material%stiffness(components, components) = stiffness_of(wood)
      material%is_plastic = wood%criterion /= 'none'
      if (.not. material%is_plastic) return

      call find_yield_surface(surface, wood, pressed_along_grain)
      material%surface = surface
      material%surface%matrix(components, components) = surface%matrix
      material%surface%centre(components) = surface%centre
      material%hardening = hardening_of(wood, surface%stress, &
         wood%criterion == 'mises' .and. pressed_along_grain)
      call find_common_vectors(material)
   end subroutine new_solid_material

   !> Hardening from the first yield stress on, along or across the grain. After its last point a
   !> curve stays level, as finite-element programs have it.
   pure function hardening_of(wood, stress, along_grain) result(curve)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: stress
      logical, intent(in) :: along_grain
      type(hardening_curve) :: curve

      if (along_grain) then
         if (allocated(wood%hardening_curve_along)) then
            curve = through_points(wood%hardening_curve_along, stress)
         else
            curve = new_hardening_curve([0.0_wp], [stress], &
               wood%hardening_along*wood%young_moduli(1))
         end if
      else if (allocated(wood%hardening_curve)) then
         curve = through_points(wood%hardening_curve, stress)
      else
         curve = new_hardening_curve([0.0_wp], [stress], &
            wood%hardening_across*wood%young_moduli(2))
      end if
   end function hardening_of

   !> A curve of points, above the first yield stress.
   pure function through_points(points, stress) result(curve)
      real(wp), intent(in) :: points(:, :), stress
      type(hardening_curve) :: curve

      curve = new_hardening_curve(points(1, :), stress + (points(2, :) - points(2, 1)), 0.0_wp)
   end function through_points

   !> Common eigenvectors of stiffness and surface.
   pure subroutine find_common_vectors(material)
      type(solid_material), intent(inout) :: material
      real(wp) :: normal(3, 3), root(3, 3), vectors(3, 3), values(3)
      integer :: i

      associate (c => material%stiffness, p => material%surface%matrix)
         normal = c(1:3, 1:3)
         call find_eigenvectors(normal, values, root)
         do i = 1, 3
            root(:, i) = root(:, i)*sqrt(values(i))
         end do
         normal = matmul(transpose(root), matmul(p(1:3, 1:3), root))
         call find_eigenvectors(normal, values, vectors)
         material%normal_vectors = matmul(root, vectors)
         ! that of equal pressure, which Mises and Hill do not see, may be below zero by rounding
         material%eigenvalues(1:3) = max(values, 0.0_wp)
         do i = 1, 3
            material%shear_vectors(i) = sqrt(c(3 + i, 3 + i))
            material%eigenvalues(3 + i) = c(3 + i, 3 + i)*p(3 + i, 3 + i)
         end do
      end associate
      material%centre = matmul(matmul(material%compliance(1:3, 1:3), &
         material%surface%centre(1:3)), material%normal_vectors)
   end subroutine find_common_vectors

   !> Stress and history at the end of an increment, by the return to the closest point of the yield
   !> surface. Strains up to 1e100 give finite results. `tangent` is set only where the point
   !> yields; elsewhere it is the stiffness of the material.
   pure subroutine update_material(material, start, strain, finish, yields, tangent)
      !> The material
      type(solid_material), intent(in) :: material
      !> The point at the start
      type(material_point), intent(in) :: start
      !> Strain at the end, less what swells
      real(wp), intent(in) :: strain(6)
      !> The point at the end
      type(material_point), intent(out) :: finish
      !> Whether plastic strain grows
      logical, intent(out) :: yields
      !> d stress/d strain, symmetric, MPa
      real(wp), intent(out), optional :: tangent(6, 6)
      real(wp) :: elastic(6), trial(6), multiplier, slope

      elastic = strain - start%plastic_strain
      yields = .false.
      if (material%is_plastic) then
         trial(1:3) = elastic_modes(material%normal_vectors, elastic) - material%centre
         trial(4:6) = material%shear_vectors*elastic(4:6)
         yields = sum(material%eigenvalues*trial**2) > ((1.0_wp + yield_tolerance) &
            *yield_stress(material%hardening, start%equivalent_strain))**2
      end if
      if (yields) then
         call find_multiplier(multiplier, slope, material%eigenvalues, trial, material%hardening, &
            start%equivalent_strain)
         call return_to_surface(material, start, trial, multiplier, finish)
         if (present(tangent)) call find_tangent(material, trial, multiplier, slope, tangent)
      else
         finish%plastic_strain = start%plastic_strain
         finish%equivalent_strain = start%equivalent_strain
         finish%stress = product_with(material%stiffness, elastic)
      end if
   end subroutine update_material

   !> Normal strains in the eigenvectors.
   pure function elastic_modes(vectors, strain) result(modes)
      real(wp), intent(in) :: vectors(3, 3), strain(6)
      real(wp) :: modes(3)

      modes = vectors(1, :)*strain(1) + vectors(2, :)*strain(2) + vectors(3, :)*strain(3)
   end function elastic_modes

   !> Product of a matrix whose normal and shear parts stand alone.
   pure function product_with(matrix, vector) result(image)
      real(wp), intent(in) :: matrix(6, 6), vector(6)
      real(wp) :: image(6)
      integer :: i

      image(1:3) = matrix(1:3, 1)*vector(1) + matrix(1:3, 2)*vector(2) + matrix(1:3, 3)*vector(3)
      do i = 4, 6
         image(i) = matrix(i, i)*vector(i)
      end do
   end function product_with

   !> The point on the surface.
   pure subroutine return_to_surface(material, start, trial, multiplier, finish)
      type(solid_material), intent(in) :: material
      type(material_point), intent(in) :: start
      real(wp), intent(in) :: trial(6), multiplier
      type(material_point), intent(out) :: finish
      real(wp) :: reached(6), from_centre(6)

      reached = trial/(1.0_wp + multiplier*material%eigenvalues)
      from_centre = from_modes(material, reached)
      finish%stress = material%surface%centre + from_centre
      finish%plastic_strain = start%plastic_strain &
         + multiplier*product_with(material%surface%matrix, from_centre)
      finish%equivalent_strain = start%equivalent_strain &
         + multiplier*sqrt(sum(material%eigenvalues*reached**2))
   end subroutine return_to_surface

   !> A stress by its shares in the eigenvectors.
   pure function from_modes(material, modes) result(stress)
      type(solid_material), intent(in) :: material
      real(wp), intent(in) :: modes(6)
      real(wp) :: stress(6)

      associate (t => material%normal_vectors)
         stress(1:3) = t(:, 1)*modes(1) + t(:, 2)*modes(2) + t(:, 3)*modes(3)
      end associate
      stress(4:6) = material%shear_vectors*modes(4:6)
   end function from_modes

   !> The exact tangent of the return: A - A v v' A (1 - h m)/(v' A v + h (f^2 - m v' A v)) with
   !> A = (C^-1 + m P)^-1, v = P (s - c), slope h, multiplier m, yield stress f. The denominator is
   !> above zero, as m v' A v < f^2.
   pure subroutine find_tangent(material, trial, multiplier, slope, tangent)
      type(solid_material), intent(in) :: material
      real(wp), intent(in) :: trial(6), multiplier, slope
      real(wp), intent(out) :: tangent(6, 6)
      real(wp) :: factors(6), flow(6), direction(6), along, square, scale
      integer :: i, j

      factors = 1.0_wp/(1.0_wp + multiplier*material%eigenvalues)
      flow = material%eigenvalues*factors*trial
      square = sum(flow*factors*trial)
      along = sum(factors*flow**2)
      scale = (1.0_wp - slope*multiplier)/(along + slope*(square - multiplier*along))
      direction = from_modes(material, factors*flow)
      do j = 1, 6
         tangent(:j, j) = -scale*direction(:j)*direction(j)
      end do
      associate (t => material%normal_vectors)
         do j = 1, 3
            do i = 1, j
               tangent(i, j) = tangent(i, j) + sum(t(i, :)*factors(1:3)*t(j, :))
            end do
            tangent(3 + j, 3 + j) = tangent(3 + j, 3 + j) &
               + material%shear_vectors(j)**2*factors(3 + j)
         end do
      end associate
      do j = 1, 5
         tangent(j + 1:, j) = tangent(j, j + 1:)
      end do
   end subroutine find_tangent

   !> Elastic energy of a stress, MPa = mJ/mm3.
   pure real(wp) function elastic_energy_density(material, stress) result(density)
      !> The material
      type(solid_material), intent(in) :: material
      !> Stress, MPa
      real(wp), intent(in) :: stress(6)

      density = 0.5_wp*dot_product(stress, product_with(material%compliance, stress))
   end function elastic_energy_density

end module asperity_solid_material_material
