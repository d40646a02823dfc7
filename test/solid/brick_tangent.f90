!> The tangent of a brick against differences of its forces.
module test_solid_brick_tangent
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_solid_element_brick, only: brick, brick_response
   use asperity_solid_material_material, only: material_point, solid_material
   use asperity_solid_small_matrices, only: cross
   use brick_states, only: criteria, edge, measure_names, measures, random_brick, random_places, &
      random_rotation, random_stretch, wood_of
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_brick_tangent

   integer(int64), parameter :: seed = 24494897_int64

contains

   function suite_brick_tangent() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('brick tangent')
      call suite%addTest(TestMethod('tangent against differences', test_tangent))
      call suite%addTest(TestMethod('tangent of the undeformed element', test_tangent_at_rest))
   end function suite_brick_tangent

   !> Random states, turned far, with swelling; what yields has yielded elsewhere before.
   subroutine test_tangent()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8), unused(8)
      real(wp) :: places(3, 8), moved(3, 8), forces(3, 8), plus(3, 8), minus(3, 8)
      real(wp) :: tangent(24, 24), differences(24, 24), eigenstrain(6), error, asymmetry
      real(wp), parameter :: step = 1.0e-6_wp*edge
      real(wp) :: largest
      integer :: c, j, k, m, n_yielding, n_unused, number_yielding
      logical :: inverted

      stream = random_stream(seed + 2)
      eigenstrain = [0.0_wp, 0.01_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp]
      do m = 1, size(measures)
         largest = 0.0_wp
         do c = 1, size(criteria)
            material = wood_of(criteria(c))
            error = 0.0_wp
            asymmetry = 0.0_wp
            number_yielding = 0
            do k = 1, 10
               call random_brick(shape, stream, material, measures(m))
               start = material_point()
               call response(random_state(shape), end, forces, n_unused)
               start = end
               places = random_state(shape)
               call brick_response(shape, material, places, eigenstrain, start, end, forces, &
                  n_yielding, tangent, inverted)
               number_yielding = number_yielding + n_yielding
               do j = 1, 24
                  moved = reshape(unit_move(j, step), [3, 8])
                  call response(places + moved, unused, plus, n_unused)
                  call response(places - moved, unused, minus, n_unused)
                  differences(:, j) = reshape(plus - minus, [24])/(2.0_wp*step)
               end do
               error = max(error, maxval(abs(tangent - differences))/maxval(abs(tangent)))
               asymmetry = max(asymmetry, maxval(abs(tangent - transpose(tangent))) &
                  /maxval(abs(tangent)))
            end do
            if (.not. measures(m)) call record('solid.brick.tangent.'//trim(criteria(c)), error)
            largest = max(largest, error)
            call assertLessThan(error, 1.0e-7_wp, measure_names(m)//' '//criteria(c))
            call assertLessThan(asymmetry, 1.0e-12_wp, measure_names(m)//' '//criteria(c))
            if (material%is_plastic) then
               call assertTrue(number_yielding > 20, measure_names(m)//' '//criteria(c))
            else
               call assertEqual(0, number_yielding)
            end if
         end do
         if (measures(m)) call record('solid.brick.tangent.logarithmic', largest)
      end do
   contains
      !> Turned and distorted; with logarithmic strain stretched as well, 0.3 to 2 times.
      function random_state(of) result(state)
         type(brick), intent(in) :: of
         real(wp) :: state(3, 8)

         state = of%corners
         if (of%is_logarithmic) state = matmul(random_stretch(stream, 0.3_wp, 2.0_wp), state)
         state = matmul(random_rotation(stream), state + random_places(stream, 0.05_wp*edge))
      end function random_state

      subroutine response(positions, now, f, n)
         real(wp), intent(in) :: positions(3, 8)
         type(material_point), intent(out) :: now(8)
         real(wp), intent(out) :: f(3, 8)
         integer, intent(out) :: n

         call brick_response(shape, material, positions, eigenstrain, start, now, f, n, &
            inverted=inverted)
         call assertFalse(inverted)
      end subroutine response
   end subroutine test_tangent

   function unit_move(j, step) result(move)
      integer, intent(in) :: j
      real(wp), intent(in) :: step
      real(wp) :: move(24)

      move = 0.0_wp
      move(j) = step
   end function unit_move

   !> Turned, without stress: symmetric, R K R', and no stiffness against rigid motion.
   subroutine test_tangent_at_rest()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8), tangent(24, 24), r(3, 3), turned(24, 24), spin(24)
      integer :: a, b, m, n_yielding
      logical :: inverted

      stream = random_stream(seed + 3)
      material = wood_of('none')
      do m = 1, size(measures)
         call random_brick(shape, stream, material, measures(m))
         r = random_rotation(stream)
         call brick_response(shape, material, matmul(r, shape%corners), spread(0.0_wp, 1, 6), &
            start, end, forces, n_yielding, tangent, inverted)
         do b = 1, 8
            do a = 1, 8
               turned(3*a - 2:3*a, 3*b - 2:3*b) = matmul(r, &
                  matmul(shape%stiffness(3*a - 2:3*a, 3*b - 2:3*b), transpose(r)))
            end do
            spin(3*b - 2:3*b) = cross([0.3_wp, 0.5_wp, -0.7_wp], matmul(r, shape%corners(:, b)))
         end do
         call assertEqual(0.0_wp, maxval(abs(tangent - turned)), &
            tolerance=1.0e-12_wp*maxval(turned))
         call assertEqual(0.0_wp, maxval(abs(tangent - transpose(tangent))), &
            tolerance=1.0e-12_wp*maxval(turned))
         call assertEqual(0.0_wp, maxval(abs(matmul(tangent, spin))), &
            tolerance=1.0e-12_wp*maxval(turned)*edge)
      end do
   end subroutine test_tangent_at_rest

end module test_solid_brick_tangent
