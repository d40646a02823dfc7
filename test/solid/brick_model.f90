!> Small models of bricks for tests: a box of elements, its equilibrium, a rotation.
module brick_model
   use asperity, only: error_type, wp
   use asperity_solid_element_brick, only: brick, brick_response, new_brick
   use asperity_solid_material_material, only: material_point, new_solid_material, solid_material
   use asperity_solid_small_matrices, only: skew
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: box, new_box, set_shapes, assemble, find_equilibrium, isotropic, rotation_about

   !> Elements in a box, all with a shape of their own.
   type :: box
      !> Undeformed and present places of the nodes, mm
      real(wp), allocatable :: nodes(:, :), positions(:, :)
      !> Whether a node is free in a direction
      logical, allocatable :: is_free(:, :)
      integer, allocatable :: elements(:, :)
      type(brick), allocatable :: shapes(:)
      type(solid_material) :: material
      type(material_point), allocatable :: start(:, :), end(:, :)
      real(wp) :: eigenstrain(6) = 0.0_wp
      !> Whether strain is logarithmic
      logical :: is_logarithmic = .false.
      !> Equations that couple: their numbers differ by at most that
      integer :: bandwidth = 0
   end type box

contains

   !> A box of elements that are all free, nodes counted in z, then y, then x.
   subroutine new_box(model, number, lengths, material)
      type(box), intent(out) :: model
      !> Elements and lengths in x, y and z
      integer, intent(in) :: number(3)
      real(wp), intent(in) :: lengths(3)
      type(solid_material), intent(in) :: material
      integer :: i, j, k, n, corner(3, 8)

      model%material = material
      allocate (model%nodes(3, product(number + 1)), model%elements(8, product(number)))
      allocate (model%is_free(3, product(number + 1)), source=.true.)
      do i = 0, number(1)
         do j = 0, number(2)
            do k = 0, number(3)
               model%nodes(:, node([i, j, k])) = lengths*[i, j, k]/number
            end do
         end do
      end do
      corner = reshape([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1], &
         [3, 8])
      n = 0
      do i = 0, number(1) - 1
         do j = 0, number(2) - 1
            do k = 0, number(3) - 1
               n = n + 1
               model%elements(:, n) = [integer :: node([i, j, k] + corner(:, 1)), &
                  node([i, j, k] + corner(:, 2)), node([i, j, k] + corner(:, 3)), &
                  node([i, j, k] + corner(:, 4)), node([i, j, k] + corner(:, 5)), &
                  node([i, j, k] + corner(:, 6)), node([i, j, k] + corner(:, 7)), &
                  node([i, j, k] + corner(:, 8))]
            end do
         end do
      end do
      call set_shapes(model)
   contains
      integer function node(place)
         integer, intent(in) :: place(3)

         node = 1 + place(3) + (number(3) + 1)*(place(2) + (number(2) + 1)*place(1))
      end function node
   end subroutine new_box

   !> Shapes from the nodes as they are, without history.
   subroutine set_shapes(model)
      type(box), intent(inout) :: model
      type(error_type), allocatable :: error
      integer :: e, n

      n = size(model%elements, 2)
      if (allocated(model%shapes)) deallocate (model%shapes, model%start, model%end)
      allocate (model%shapes(n), model%start(8, n), model%end(8, n))
      model%positions = model%nodes
      do e = 1, n
         call new_brick(model%shapes(e), model%nodes(:, model%elements(:, e)), &
            model%material%stiffness, error)
         if (allocated(error)) error stop 'brick_model: an element is inverted'
      end do
      model%shapes%is_logarithmic = model%is_logarithmic
      model%bandwidth = 3*maxval(maxval(model%elements, 1) - minval(model%elements, 1)) + 2
   end subroutine set_shapes

   !> Internal forces of the box, and its tangent.
   subroutine assemble(model, forces, tangent)
      type(box), intent(inout) :: model
      real(wp), intent(out) :: forces(:, :)
      real(wp), intent(out), optional :: tangent(:, :)
      real(wp) :: f(3, 8), k(24, 24)
      integer :: a, e, n_yielding, equations(24)
      logical :: inverted

      forces = 0.0_wp
      if (present(tangent)) tangent = 0.0_wp
      do e = 1, size(model%elements, 2)
         associate (nodes => model%elements(:, e))
            call brick_response(model%shapes(e), model%material, model%positions(:, nodes), &
               model%eigenstrain, model%start(:, e), model%end(:, e), f, n_yielding, k, inverted)
            if (inverted) error stop 'brick_model: an element turned inside out'
            do a = 1, 8
               equations(3*a - 2:3*a) = 3*nodes(a) - [2, 1, 0]
               forces(:, nodes(a)) = forces(:, nodes(a)) + f(:, a)
            end do
         end associate
         if (present(tangent)) tangent(equations, equations) = tangent(equations, equations) + k
      end do
   end subroutine assemble

   !> Move the free nodes until internal are external forces, by Newton's method.
   subroutine find_equilibrium(model, external, tolerance, iterations)
      type(box), intent(inout) :: model
      !> External forces, and what may be left of them, N
      real(wp), intent(in) :: external(:, :), tolerance
      !> Iterations that it took
      integer, intent(out) :: iterations
      real(wp), allocatable :: forces(:, :), tangent(:, :), step(:)
      integer :: i, n
      logical, allocatable :: is_free(:)

      n = size(model%nodes)
      allocate (forces(3, n/3), tangent(n, n), step(n))
      is_free = reshape(model%is_free, [n])
      do iterations = 0, 30
         call assemble(model, forces, tangent)
         step = merge(reshape(external - forces, [n]), 0.0_wp, is_free)
         if (maxval(abs(step)) < tolerance) return
         do i = 1, n
            if (is_free(i)) cycle
            tangent(:, i) = 0.0_wp
            tangent(i, :) = 0.0_wp
            tangent(i, i) = 1.0_wp
         end do
         call eliminate(tangent, step, model%bandwidth)
         model%positions = model%positions + reshape(step, [3, n/3])
      end do
      error stop 'brick_model: no equilibrium'
   end subroutine find_equilibrium

   !> Gauss' elimination of a symmetric, positive matrix with a band, by its lower half.
   subroutine eliminate(matrix, right, bandwidth)
      real(wp), intent(inout) :: matrix(:, :), right(:)
      integer, intent(in) :: bandwidth
      real(wp) :: factor
      integer :: i, k, last, n

      n = size(right)
      do k = 1, n
         last = min(n, k + bandwidth)
         do i = k + 1, last
            factor = matrix(i, k)/matrix(k, k)
            matrix(i:last, i) = matrix(i:last, i) - factor*matrix(i:last, k)
            right(i) = right(i) - factor*right(k)
         end do
      end do
      do k = n, 1, -1
         last = min(n, k + bandwidth)
         right(k) = (right(k) - dot_product(matrix(k + 1:last, k), right(k + 1:last))) &
            /matrix(k, k)
      end do
   end subroutine eliminate

   !> An elastic material that is the same in all directions.
   function isotropic(young, poisson) result(material)
      real(wp), intent(in) :: young, poisson
      type(solid_material) :: material
      type(wood_properties) :: wood
      type(error_type), allocatable :: error

      wood%young_moduli = young
      wood%poisson_ratios = poisson
      wood%shear_moduli = 0.5_wp*young/(1.0_wp + poisson)
      wood%criterion = 'none'
      call new_solid_material(material, wood, 1, 2, .false., error)
      if (allocated(error)) error stop 'brick_model: no material'
   end function isotropic

   !> Rotation by an angle about an axis (Rodrigues).
   function rotation_about(axis, angle) result(rotation)
      real(wp), intent(in) :: axis(3), angle
      real(wp) :: rotation(3, 3), s(3, 3)
      integer :: i

      s = skew(axis/norm2(axis))
      rotation = sin(angle)*s + (1.0_wp - cos(angle))*matmul(s, s)
      do i = 1, 3
         rotation(i, i) = rotation(i, i) + 1.0_wp
      end do
   end function rotation_about

end module brick_model
