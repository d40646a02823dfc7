!> What a brick does at its limits: gradients of any kind, elements inside out, bad corners.
module test_solid_brick_limits
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_solid_element_brick, only: brick, brick_response, new_brick
   use asperity_solid_element_rotation, only: polar_rotation
   use asperity_solid_material_material, only: material_point, solid_material
   use brick_model, only: box, new_box
   use brick_states, only: edge, measures, random_brick, random_rotation, wood_of
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_brick_limits

   integer(int64), parameter :: seed = 26457513_int64
   real(wp), parameter :: identity(3, 3) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, &
      0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [3, 3])

contains

   function suite_brick_limits() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('brick limits')
      call suite%addTest(TestMethod('rotation of any gradient', test_polar))
      call suite%addTest(TestMethod('elements turned inside out', test_inverted))
      call suite%addTest(TestMethod('points that yield are counted', test_number_yielding))
      call suite%addTest(TestMethod('corners that enclose no volume', test_bad_corners))
   end function suite_brick_limits

   !> R U with known R and U, stretched between a hundredth and a hundredfold.
   subroutine test_polar()
      type(random_stream) :: stream
      real(wp) :: r(3, 3), axes(3, 3), stretches(3, 3), found(3, 3)
      integer :: i, k
      logical :: inverted

      stream = random_stream(seed)
      do k = 1, 200
         r = random_rotation(stream)
         axes = random_rotation(stream)
         stretches = 0.0_wp
         do i = 1, 3
            stretches(i, i) = stream%log_uniform(1.0e-2_wp, 1.0e2_wp)
         end do
         call polar_rotation(matmul(r, matmul(axes, matmul(stretches, transpose(axes)))), found, &
            inverted)
         call assertFalse(inverted)
         call assertEqual(0.0_wp, maxval(abs(matmul(transpose(r), found) - identity)), &
            tolerance=1.0e-11_wp)
         call assertEqual(0.0_wp, maxval(abs(matmul(transpose(found), found) - identity)), &
            tolerance=1.0e-14_wp)
      end do
      ! limits: a thousandfold, and a billionth of the cube of the largest stretch
      stretches = identity
      stretches(1, 1) = 999.0_wp
      call polar_rotation(matmul(r, stretches), found, inverted)
      call assertFalse(inverted)
      stretches(1, 1) = 1002.0_wp
      call polar_rotation(stretches, found, inverted)
      call assertTrue(inverted)
      stretches(1, 1) = 1.0_wp
      stretches(2, 2) = 1.01e-9_wp
      call polar_rotation(stretches, found, inverted)
      call assertFalse(inverted)
      call assertEqual(0.0_wp, maxval(abs(found - identity)), tolerance=1.0e-14_wp)
      stretches(2, 2) = 0.99e-9_wp
      call polar_rotation(stretches, found, inverted)
      call assertTrue(inverted)
   end subroutine test_polar

   !> Mirrored, flattened, and far away: said, with nothing that is not a number.
   subroutine test_inverted()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8)
      real(wp) :: flat(3, 3), places(3, 8)
      integer :: m

      stream = random_stream(seed + 1)
      material = wood_of('crushing')
      start%equivalent_strain = 0.5_wp
      do m = 1, size(measures)
         call random_brick(shape, stream, material, measures(m))
         flat = identity
         flat(3, 3) = -1.0_wp
         call check(matmul(flat, shape%corners), .true.)
         flat(3, 3) = 0.0_wp
         call check(matmul(flat, shape%corners), .true.)
         call check(spread([1.0_wp, 2.0_wp, 3.0_wp], 2, 8), .true.)
         call check(1.0e200_wp*shape%corners, .true.)
         flat(3, 3) = 0.01_wp
         call check(matmul(flat, shape%corners), .false.)
         call check(10.0_wp*shape%corners, .false.)
         ! a corner beyond the middle of the opposite face: inside out at one point, not on average
         places = shape%corners
         places(:, 7) = 0.1_wp*places(:, 7)
         call check(places, shape%is_logarithmic)
      end do
   contains
      subroutine check(places, expected)
         real(wp), intent(in) :: places(3, 8)
         logical, intent(in) :: expected
         type(material_point) :: end(8)
         real(wp) :: forces(3, 8), tangent(24, 24)
         integer :: n_yielding
         logical :: inverted

         forces = 1.0_wp
         tangent = 1.0_wp
         n_yielding = 1
         call brick_response(shape, material, places, spread(0.0_wp, 1, 6), start, end, forces, &
            n_yielding, tangent, inverted)
         call assertTrue(inverted .eqv. expected)
         call assertLessThan(maxval(abs(forces)), huge(1.0_wp))
         call assertLessThan(maxval(abs(tangent)), huge(1.0_wp))
         if (.not. inverted) return
         call assertEqual(0.0_wp, maxval(abs(forces)) + maxval(abs(tangent)))
         call assertEqual(0, n_yielding)
         call assertEqual(0.0_wp, &
            maxval(abs(end%equivalent_strain - start%equivalent_strain)))
      end subroutine check
   end subroutine test_inverted

   !> Pressed together by 5 % across the grain, all points yield, and none as it was.
   subroutine test_number_yielding()
      type(random_stream) :: stream
      type(solid_material) :: material
      type(brick) :: shape
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8), pressed(3, 3)
      integer :: n_yielding
      logical :: inverted

      stream = random_stream(seed + 2)
      material = wood_of('crushing')
      call random_brick(shape, stream, material, measures(1))
      pressed = identity
      pressed(1, 1) = 0.95_wp
      call brick_response(shape, material, matmul(pressed, shape%corners), spread(0.0_wp, 1, 6), &
         start, end, forces, n_yielding, inverted=inverted)
      call assertEqual(merge(8, 0, material%is_plastic), n_yielding)
      call brick_response(shape, material, shape%corners, spread(0.0_wp, 1, 6), start, end, &
         forces, n_yielding, inverted=inverted)
      call assertEqual(0, n_yielding)
   end subroutine test_number_yielding

   subroutine test_bad_corners()
      type(solid_material) :: material
      type(box) :: one
      type(brick) :: shape
      type(error_type), allocatable :: error
      real(wp) :: corners(3, 8)

      material = wood_of('none')
      call new_box(one, [1, 1, 1], [edge, edge, edge], material)
      corners = one%nodes(:, one%elements(:, 1))
      call new_brick(shape, corners(:, [5, 6, 7, 8, 1, 2, 3, 4]), material%stiffness, error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertTrue( &
         index(error%message, 'point 1 its volume is -27000') > 0, error%message)
      ! one corner beyond the middle of the opposite face
      corners(:, 7) = [0.1_wp, 0.1_wp, 0.1_wp]*edge
      call new_brick(shape, corners, material%stiffness, error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertTrue(index(error%message, 'point 7 ') > 0, error%message)
      ! a plate of a billionth of its edge
      corners = one%nodes(:, one%elements(:, 1))
      corners(1, :) = corners(1, :) + 7.0_wp
      corners(3, :) = 1.01e-9_wp*corners(3, :)
      call new_brick(shape, corners, material%stiffness, error)
      call assertFalse(allocated(error))
      call assertEqual(edge, maxval(shape%corners))
      call assertEqual(0.0_wp, maxval(abs(shape%corners(:, 1))))
      corners(3, :) = 0.98_wp*corners(3, :)
      call new_brick(shape, corners, material%stiffness, error)
      call assertTrue(allocated(error))
   end subroutine test_bad_corners

end module test_solid_brick_limits
