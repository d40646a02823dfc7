!> Bricks with logarithmic strain: large stretches against closed forms, the limit of small ones,
!> energy of plastic paths, and flow that keeps the volume.
module test_solid_brick_logarithmic
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_base_constants, only: pi
   use asperity_solid_element_brick, only: brick, brick_response, new_brick
   use asperity_solid_material_material, only: elastic_energy_density, material_point, &
      solid_material
   use brick_model, only: assemble, box, find_equilibrium, new_box, rotation_about, set_shapes
   use brick_states, only: edge, measures, random_brick, random_places, random_rotation, &
      random_stretch, wood_of
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_brick_logarithmic

   integer(int64), parameter :: seed = 33166247_int64

contains

   function suite_brick_logarithmic() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('brick, logarithmic strain')
      call suite%addTest(TestMethod('pressed and pulled along an axis, and turned', test_uniaxial))
      call suite%addTest(TestMethod('large linear fields in distorted bricks', test_patch))
      call suite%addTest(TestMethod('small strains are engineering strains', test_small))
      call suite%addTest(TestMethod('energy is the work along a plastic path', test_work))
      call suite%addTest(TestMethod('flow that keeps the volume does not lock', test_locking))
   end function suite_brick_logarithmic

   !> Stress T along an axis makes the stretches exp(compliance T); the force is T A/stretch, A the
   !> undeformed area, turned by a third of a turn with the block.
   subroutine test_uniaxial()
      type(solid_material) :: material
      type(box) :: one
      type(brick) :: shape
      type(error_type), allocatable :: error
      type(material_point) :: start(8), end(8)
      real(wp) :: stress(6), strain(6), forces(3, 8), expected(3, 8), places(3, 8), r(3, 3)
      real(wp), parameter :: lengths(3) = [1.0_wp, 1.5_wp, 0.7_wp]*edge
      real(wp), parameter :: stretches(5) = [0.3_wp, 0.5_wp, 0.9_wp, 1.3_wp, 2.0_wp]
      integer :: a, g, i, k, n_yielding
      logical :: inverted

      material = wood_of('none')
      call new_box(one, [1, 1, 1], lengths, material)
      call new_brick(shape, one%nodes(:, one%elements(:, 1)), material%stiffness, error)
      call assertFalse(allocated(error))
      shape%is_logarithmic = .true.
      r = rotation_about([1.0_wp, 1.0_wp, 1.0_wp], 2.0_wp*pi/3.0_wp)
      do i = 1, 3
         do k = 1, size(stretches)
            stress = 0.0_wp
            stress(i) = log(stretches(k))/material%compliance(i, i)
            strain = matmul(material%compliance, stress)
            do a = 1, 8
               places(:, a) = matmul(r, exp(strain(1:3))*shape%corners(:, a))
               expected(:, a) = r(:, i)*stress(i)/stretches(k)*product(lengths)/lengths(i) &
                  /4.0_wp*merge(1.0_wp, -1.0_wp, shape%corners(i, a) > 0.1_wp*edge)
            end do
            call brick_response(shape, material, places, spread(0.0_wp, 1, 6), start, end, &
               forces, n_yielding, inverted=inverted)
            call assertEqual(0.0_wp, maxval(abs(forces - expected)), &
               tolerance=1.0e-11_wp*maxval(material%stiffness)*edge**2)
            do g = 1, 8
               call assertEqual(stress, end(g)%stress, &
                  tolerance=1.0e-11_wp*maxval(material%stiffness))
            end do
         end do
      end do
   end subroutine test_uniaxial

   !> Stretched 0.3 to 2 times: inner nodes need no force, and every point has the stress C ln U of
   !> F = R U.
   subroutine test_patch()
      type(random_stream) :: stream
      type(box) :: patch
      real(wp) :: logarithm(3, 3), stretch(3, 3), stress(6)
      real(wp), allocatable :: forces(:, :)
      integer :: e, g, i, n

      stream = random_stream(seed)
      call new_box(patch, [3, 3, 3], spread(3.0_wp*edge, 1, 3), wood_of('none'))
      do n = 1, size(patch%nodes, 2)
         do i = 1, 3
            patch%nodes(i, n) = patch%nodes(i, n) + stream%uniform(-0.15_wp, 0.15_wp)*edge
         end do
      end do
      patch%is_logarithmic = .true.
      call set_shapes(patch)
      stretch = random_stretch(stream, 0.3_wp, 2.0_wp, logarithm)
      patch%positions = matmul(matmul(random_rotation(stream), stretch), patch%nodes)
      allocate (forces(3, size(patch%nodes, 2)))
      call assemble(patch, forces)
      stress = matmul(patch%material%stiffness, [logarithm(1, 1), logarithm(2, 2), &
         logarithm(3, 3), 2.0_wp*logarithm(1, 2), 2.0_wp*logarithm(2, 3), 2.0_wp*logarithm(3, 1)])
      do e = 1, size(patch%elements, 2)
         do g = 1, 8
            call assertEqual(stress, patch%end(g, e)%stress, &
               tolerance=1.0e-11_wp*maxval(abs(stress)))
         end do
      end do
      do n = 1, size(patch%nodes, 2)
         if (count(patch%elements == n) == 8) call assertEqual(0.0_wp, &
            maxval(abs(forces(:, n))), tolerance=1.0e-11_wp*maxval(abs(forces)))
      end do
   end subroutine test_patch

   !> At strains of a millionth both measures give the same forces, to some millionths.
   subroutine test_small()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8, 2), places(3, 8)
      real(wp), parameter :: small = 1.0e-6_wp
      integer :: k, m, n_yielding
      logical :: inverted

      stream = random_stream(seed + 1)
      material = wood_of('none')
      do k = 1, 10
         call random_brick(shape, stream, material, measures(1))
         places = matmul(random_rotation(stream), shape%corners &
            + random_places(stream, 0.5_wp*small*edge))
         do m = 1, size(measures)
            shape%is_logarithmic = measures(m)
            call brick_response(shape, material, places, spread(0.0_wp, 1, 6), start, end, &
               forces(:, :, m), n_yielding, inverted=inverted)
         end do
         call assertEqual(0.0_wp, maxval(abs(forces(:, :, 2) - forces(:, :, 1))), &
            tolerance=5.0_wp*small*maxval(abs(forces)))
      end do
   end subroutine test_small

   !> Work of the corners' forces is energy stored and lost to plastic strain; what is left falls at
   !> least with the step.
   subroutine test_work()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      real(wp) :: stretch(3, 3), way(3, 8), left(2), work

      stream = random_stream(seed + 2)
      material = wood_of('crushing')
      call random_brick(shape, stream, material, measures(2))
      stretch = random_stretch(stream, 0.4_wp, 1.5_wp)
      way = random_places(stream, 0.1_wp*edge)
      call follow(100, left(1), work)
      call follow(200, left(2), work)
      call record('solid.brick.logarithmic.work', abs(left(2))/work)
      call assertGreaterThan(work, 0.0_wp)
      call assertLessThan(abs(left(2)), 2.0e-3_wp*work)
      call assertLessThan(abs(left(2)), 0.6_wp*abs(left(1)))
   contains
      subroutine follow(steps, left, work)
         integer, intent(in) :: steps
         real(wp), intent(out) :: left, work
         real(wp), parameter :: z(3) = [0.0_wp, 0.0_wp, 1.0_wp]
         type(material_point) :: start(8), end(8)
         real(wp) :: forces(3, 8), last_forces(3, 8), places(3, 8), last_places(3, 8), t
         real(wp) :: lost, stored
         integer :: g, k, n_yielding
         logical :: inverted

         work = 0.0_wp
         stored = 0.0_wp
         lost = 0.0_wp
         last_places = shape%corners
         last_forces = 0.0_wp
         do k = 1, steps
            t = real(k, wp)/steps
            ! there and half of the way back, and a turn
            t = merge(t, 1.2_wp - t, t < 0.6_wp)/0.6_wp
            places = matmul(rotation_about(z, 2.0_wp*t), shape%corners &
               + t*(matmul(stretch, shape%corners) - shape%corners + way))
            call brick_response(shape, material, places, spread(0.0_wp, 1, 6), start, end, &
               forces, n_yielding, inverted=inverted)
            call assertFalse(inverted)
            work = work + 0.5_wp*sum((forces + last_forces)*(places - last_places))
            stored = 0.0_wp
            do g = 1, 8
               stored = stored + shape%weights(g)*elastic_energy_density(material, end(g)%stress)
               lost = lost + 0.5_wp*shape%weights(g)*dot_product(start(g)%stress + end(g)%stress, &
                  end(g)%plastic_strain - start(g)%plastic_strain)
            end do
            start = end
            last_places = places
            last_forces = forces
         end do
         left = work - stored - lost
      end subroutine follow
   end subroutine test_work

   !> A block of Mises' wood pressed by 3 % between rough plates, beyond yield: the force of both
   !> measures is the same but for what the strain itself makes. With dilatations of points in place
   !> of the element's it would be 18 % more.
   subroutine test_locking()
      type(box) :: block
      real(wp), allocatable :: external(:, :), forces(:, :)
      real(wp) :: found(2)
      real(wp), parameter :: height = 2.0_wp*edge, pressed = 0.03_wp
      integer :: m, n, iterations

      do m = 1, size(measures)
         call new_box(block, [3, 3, 3], [height, height, height], wood_of('mises'))
         block%is_logarithmic = measures(m)
         call set_shapes(block)
         do n = 1, size(block%nodes, 2)
            if (abs(block%nodes(1, n) - 0.5_wp*height) < 0.4_wp*height) cycle
            block%is_free(:, n) = .false.
            block%positions(1, n) = (1.0_wp - pressed)*block%nodes(1, n)
         end do
         allocate (external(3, size(block%nodes, 2)), forces(3, size(block%nodes, 2)), &
            source=0.0_wp)
         call find_equilibrium(block, external, 1.0e-6_wp, iterations)
         call assemble(block, forces)
         found(m) = sum(forces(1, :), block%nodes(1, :) > 0.9_wp*height)
         call assertGreaterThan(count(block%end%equivalent_strain > 0.0_wp), 200)
         deallocate (external, forces)
      end do
      call assertEqual(found(1), found(2), tolerance=2.0_wp*pressed*abs(found(1)))
   end subroutine test_locking

end module test_solid_brick_logarithmic
