!> A brick against what holds for any: no force from rotation, linear fields, balance, energy.
module test_solid_brick
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_base_constants, only: pi
   use asperity_solid_element_brick, only: brick, brick_response
   use asperity_solid_material_material, only: material_point, solid_material
   use asperity_solid_small_matrices, only: cross
   use brick_model, only: assemble, box, new_box, rotation_about, set_shapes
   use brick_states, only: criteria, edge, measures, random_brick, random_places, &
      random_rotation, wood_of
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_brick

   integer(int64), parameter :: seed = 22360680_int64

contains

   function suite_brick() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('brick')
      call suite%addTest(TestMethod('rigid rotation gives no force', test_rotation))
      call suite%addTest(TestMethod('linear fields in a patch of distorted bricks', test_patch))
      call suite%addTest(TestMethod('forces and moments balance', test_balance))
      call suite%addTest(TestMethod('forces are derivatives of the energy', test_energy))
      call suite%addTest(TestMethod('a closed path takes no work', test_closed_path))
   end function suite_brick

   subroutine test_rotation()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8), scale
      integer :: k, n_yielding
      logical :: inverted

      stream = random_stream(seed)
      material = wood_of('none')
      scale = maxval(material%stiffness)*edge**2
      do k = 1, 50
         call random_brick(shape, stream, material, measures(1 + mod(k, 2)))
         call brick_response(shape, material, matmul(random_rotation(stream), shape%corners) &
            + spread([1.0_wp, -2.0_wp, 3.0_wp]*edge, 2, 8), spread(0.0_wp, 1, 6), start, end, &
            forces, n_yielding, inverted=inverted)
         call assertFalse(inverted)
         call assertEqual(0.0_wp, maxval(abs(forces)), tolerance=1.0e-12_wp*scale)
      end do
   end subroutine test_rotation

   !> Inner nodes need no force, and every point has the stress C (U - I) of F = R U.
   subroutine test_patch()
      type(random_stream) :: stream
      type(box) :: patch
      real(wp) :: stretch(3, 3), f(3, 3), stress(6)
      real(wp), allocatable :: forces(:, :)
      integer :: e, g, i, n

      stream = random_stream(seed + 1)
      call new_box(patch, [3, 3, 3], spread(3.0_wp*edge, 1, 3), wood_of('none'))
      do n = 1, size(patch%nodes, 2)
         do i = 1, 3
            patch%nodes(i, n) = patch%nodes(i, n) + stream%uniform(-0.15_wp, 0.15_wp)*edge
         end do
      end do
      call set_shapes(patch)
      stretch = reshape([1.05_wp, 0.03_wp, -0.02_wp, 0.03_wp, 0.96_wp, 0.04_wp, &
         -0.02_wp, 0.04_wp, 1.02_wp], [3, 3])
      f = matmul(random_rotation(stream), stretch)
      patch%positions = matmul(f, patch%nodes)
      allocate (forces(3, size(patch%nodes, 2)))
      call assemble(patch, forces)
      stress = matmul(patch%material%stiffness, [stretch(1, 1) - 1.0_wp, stretch(2, 2) - 1.0_wp, &
         stretch(3, 3) - 1.0_wp, 2.0_wp*stretch(1, 2), 2.0_wp*stretch(2, 3), &
         2.0_wp*stretch(3, 1)])
      do e = 1, size(patch%elements, 2)
         do g = 1, 8
            call assertEqual(stress, patch%end(g, e)%stress, tolerance=1.0e-11_wp*maxval(stress))
         end do
      end do
      do n = 1, size(patch%nodes, 2)
         if (count(patch%elements == n) == 8) call assertEqual(0.0_wp, &
            maxval(abs(forces(:, n))), tolerance=1.0e-11_wp*maxval(abs(forces)))
      end do
   end subroutine test_patch

   subroutine test_balance()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8), places(3, 8), moment(3), eigenstrain(6)
      integer :: a, c, k, n_yielding
      logical :: inverted

      stream = random_stream(seed + 4)
      eigenstrain = [0.01_wp, 0.02_wp, -0.01_wp, 0.01_wp, 0.0_wp, -0.02_wp]
      do c = 1, size(criteria)
         material = wood_of(criteria(c))
         do k = 1, 10
            call random_brick(shape, stream, material, measures(1 + mod(k, 2)))
            places = matmul(random_rotation(stream), shape%corners &
               + random_places(stream, 0.15_wp*edge))
            call brick_response(shape, material, places, eigenstrain, start, end, forces, &
               n_yielding, inverted=inverted)
            moment = 0.0_wp
            do a = 1, 8
               moment = moment + cross(places(:, a), forces(:, a))
            end do
            call assertGreaterThan(maxval(abs(forces)), 100.0_wp)
            call assertEqual(0.0_wp, maxval(abs(sum(forces, 2))), &
               tolerance=1.0e-12_wp*maxval(abs(forces)))
            call assertEqual(0.0_wp, maxval(abs(moment)), &
               tolerance=1.0e-12_wp*maxval(abs(forces))*edge)
         end do
      end do
   end subroutine test_balance

   !> Energy stored by the stresses of a position, by the compliance.
   function stored_energy(shape, material, points) result(energy)
      type(brick), intent(in) :: shape
      type(solid_material), intent(in) :: material
      type(material_point), intent(in) :: points(8)
      real(wp) :: energy
      integer :: g

      energy = 0.0_wp
      do g = 1, 8
         energy = energy + 0.5_wp*shape%weights(g)*dot_product(points(g)%stress, &
            matmul(material%compliance, points(g)%stress))
      end do
   end function stored_energy

   subroutine test_energy()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8), places(3, 8), way(3, 8), energy(2), unused(3, 8), eigenstrain(6)
      real(wp), parameter :: step = 1.0e-5_wp
      integer :: k, n_yielding
      logical :: inverted

      stream = random_stream(seed + 5)
      material = wood_of('none')
      eigenstrain = [0.01_wp, 0.02_wp, -0.01_wp, 0.01_wp, 0.0_wp, -0.02_wp]
      do k = 1, 20
         call random_brick(shape, stream, material, measures(1 + mod(k, 2)))
         places = matmul(random_rotation(stream), shape%corners &
            + random_places(stream, 0.15_wp*edge))
         way = random_places(stream, edge)
         call brick_response(shape, material, places, eigenstrain, start, end, forces, &
            n_yielding, inverted=inverted)
         call brick_response(shape, material, places + step*way, eigenstrain, start, end, unused, &
            n_yielding, inverted=inverted)
         energy(2) = stored_energy(shape, material, end)
         call brick_response(shape, material, places - step*way, eigenstrain, start, end, unused, &
            n_yielding, inverted=inverted)
         energy(1) = stored_energy(shape, material, end)
         call assertEqual(sum(forces*way), (energy(2) - energy(1))/(2.0_wp*step), &
            tolerance=1.0e-8_wp*sum(abs(forces*way)))
      end do
   end subroutine test_energy

   !> Work of the trapezoidal rule round a closed path, with a turn: falls with the step's square.
   subroutine test_closed_path()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      real(wp) :: axis(3, 3), ways(3, 8, 2), work(2)
      integer :: m

      stream = random_stream(seed + 6)
      material = wood_of('none')
      do m = 1, size(measures)
         call random_brick(shape, stream, material, measures(m))
         axis = random_rotation(stream)
         ways(:, :, 1) = random_places(stream, 0.1_wp*edge)
         ways(:, :, 2) = random_places(stream, 0.1_wp*edge)
         work = [work_of(40), work_of(80)]
         call assertLessThan(abs(work(1)), 0.01_wp*maxval(material%stiffness)*edge**3*0.1_wp**2)
         call assertEqual(4.0_wp, work(1)/work(2), tolerance=0.1_wp)
      end do
   contains
      real(wp) function work_of(steps)
         integer, intent(in) :: steps
         real(wp), parameter :: z(3) = [0.0_wp, 0.0_wp, 1.0_wp]
         type(material_point) :: start(8), end(8)
         real(wp) :: forces(3, 8), last_forces(3, 8), places(3, 8), last_places(3, 8), t
         integer :: k, n_yielding
         logical :: inverted

         work_of = 0.0_wp
         do k = 0, steps
            t = 2.0_wp*pi*k/steps
            ! a turn to and fro and a round of two shapes
            places = matmul(matmul(axis, rotation_about(z, 0.5_wp*sin(t))), shape%corners &
               + (1.0_wp - cos(t))*ways(:, :, 1) + sin(2.0_wp*t)*ways(:, :, 2))
            call brick_response(shape, material, places, spread(0.0_wp, 1, 6), start, end, forces, &
               n_yielding, inverted=inverted)
            if (k > 0) work_of = work_of + 0.5_wp*sum((forces + last_forces)*(places - last_places))
            last_forces = forces
            last_places = places
         end do
      end function work_of
   end subroutine test_closed_path

end module test_solid_brick
