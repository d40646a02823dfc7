!> Bricks against closed forms: swelling, a loaded block that turns, bending, a cantilever that
!> bends far, and material that keeps its volume.
module test_solid_brick_structures
   use asperity, only: error_type, wp
   use asperity_base_constants, only: pi
   use asperity_solid_element_brick, only: brick, brick_response, new_brick
   use asperity_solid_material_material, only: material_point, solid_material
   use brick_model, only: assemble, box, find_equilibrium, isotropic, new_box, rotation_about, &
      set_shapes
   use brick_states, only: edge, measures, wood_of
   use funit, only: assertEqual, assertFalse, assertLessThanOrEqual, TestMethod, TestSuite
   use measurements, only: record
   implicit none
   private
   public :: suite_brick_structures

   !> Young's modulus, MPa; length and height of the beams, mm; elements along and over the height
   real(wp), parameter :: young = 1000.0_wp, length = 100.0_wp, height = 10.0_wp
   integer, parameter :: along = 20, over = 4

contains

   function suite_brick_structures() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('brick structures')
      call suite%addTest(TestMethod('free swelling', test_swelling))
      call suite%addTest(TestMethod('a loaded block turns', test_turning_block))
      call suite%addTest(TestMethod('pure bending, up to constant volume', test_bending))
      call suite%addTest(TestMethod('a cantilever that bends far', test_cantilever))
      call suite%addTest(TestMethod('only mean dilatation is stiff', test_locking))
   end function suite_brick_structures

   !> A free block of wood takes the strain of swelling in its measure, without stress.
   subroutine test_swelling()
      type(box) :: block
      real(wp), allocatable :: external(:, :), expected(:, :)
      real(wp) :: stretches(3)
      integer :: e, g, i, iterations, m

      do m = 1, size(measures)
         call new_box(block, [2, 2, 2], [2.0_wp, 3.0_wp, 2.0_wp]*edge, wood_of('none'))
         block%is_logarithmic = measures(m)
         call set_shapes(block)
         block%eigenstrain = [0.02_wp, 0.03_wp, 0.001_wp, 0.0_wp, 0.0_wp, 0.0_wp]
         stretches = 1.0_wp + block%eigenstrain(1:3)
         if (measures(m)) stretches = exp(block%eigenstrain(1:3))
         ! six supports, of a corner and its neighbours on the edges
         block%is_free(:, 1) = .false.
         block%is_free(1:2, 2) = .false.
         block%is_free(1, 4) = .false.
         expected = block%nodes
         do i = 1, 3
            expected(i, :) = stretches(i)*expected(i, :)
         end do
         if (.not. allocated(external)) &
            allocate (external(3, size(block%nodes, 2)), source=0.0_wp)
         call find_equilibrium(block, external, 1.0e-8_wp, iterations)
         call assertEqual(0.0_wp, maxval(abs(block%positions - expected)), &
            tolerance=1.0e-10_wp*edge)
         do e = 1, size(block%elements, 2)
            do g = 1, 8
               call assertEqual(0.0_wp, maxval(abs(block%end(g, e)%stress)), tolerance=1.0e-9_wp)
            end do
         end do
      end do
   end subroutine test_swelling

   !> A block in compression across the grain, strain s/E in the direction of the load: as it turns
   !> round, stress stays and the forces, s A/4 a corner, turn with it.
   subroutine test_turning_block()
      type(solid_material) :: material
      type(box) :: one
      type(brick) :: shape
      type(error_type), allocatable :: error
      type(material_point) :: start(8), end(8)
      real(wp) :: forces(3, 8), expected(3, 8), stress(6), strain(6), r(3, 3), places(3, 8)
      real(wp), parameter :: lengths(3) = [1.0_wp, 1.5_wp, 0.7_wp]*edge, pressure = 3.0_wp
      integer, parameter :: turns = 12
      integer :: a, g, k, n_yielding
      logical :: inverted

      material = wood_of('none')
      call new_box(one, [1, 1, 1], lengths, material)
      call new_brick(shape, one%nodes(:, one%elements(:, 1)), material%stiffness, error)
      call assertFalse(allocated(error))
      stress = [-pressure, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp]
      strain = matmul(material%compliance, stress)
      do k = 0, turns
         r = rotation_about([1.0_wp, -2.0_wp, 0.5_wp], 2.0_wp*pi*k/turns)
         do a = 1, 8
            places(:, a) = matmul(r, (1.0_wp + strain(1:3))*shape%corners(:, a))
            ! pushed back where it is pressed together
            expected(:, a) = r(:, 1)*pressure*lengths(2)*lengths(3)/4.0_wp &
               *merge(1.0_wp, -1.0_wp, shape%corners(1, a) < 0.5_wp*edge)
         end do
         call brick_response(shape, material, places, spread(0.0_wp, 1, 6), start, end, forces, &
            n_yielding, inverted=inverted)
         call assertEqual(0.0_wp, maxval(abs(forces - expected)), &
            tolerance=1.0e-11_wp*maxval(material%stiffness)*edge**2)
         do g = 1, 8
            call assertEqual(stress, end(g)%stress, tolerance=1.0e-11_wp*maxval(material%stiffness))
         end do
         start = end
      end do
   end subroutine test_turning_block

   !> Bending stiffness of bricks over that of a plate in plane strain, whose modulus is
   !> E' = E/(1 - nu^2). With n elements of length l over the height h: layers that are constant
   !> carry 1 - 1/n^2; in a layer the dilatation is constant, which leaves 4 G/3 of E'; and corners
   !> on a parabola shear the element along its length by kappa x.
   pure real(wp) function stiffness_ratio(poisson, layers)
      real(wp), intent(in) :: poisson
      integer, intent(in) :: layers
      real(wp) :: shear

      ! G/E'
      shear = 0.5_wp*(1.0_wp - poisson)
      stiffness_ratio = 1.0_wp - (1.0_wp - 4.0_wp/3.0_wp*shear)/layers**2 &
         + shear*(length/along/height)**2
   end function stiffness_ratio

   !> A beam one element wide that does not move across; x = 0 is held in x, one node in y.
   subroutine new_beam(beam, poisson)
      type(box), intent(out) :: beam
      real(wp), intent(in) :: poisson
      integer :: n

      call new_box(beam, [along, over, 1], [length, height, height], isotropic(young, poisson))
      beam%is_free(3, :) = .false.
      do n = 1, size(beam%nodes, 2)
         if (beam%nodes(1, n) > 0.0_wp) cycle
         beam%is_free(1, n) = .false.
         if (abs(beam%nodes(2, n) - 0.5_wp*height) < 0.1_wp) beam%is_free(2, n) = .false.
      end do
   end subroutine new_beam

   !> The end turned by a small angle: a parabola, and the moment E' I kappa times the ratio.
   subroutine test_bending()
      type(box) :: beam
      real(wp), allocatable :: forces(:, :)
      real(wp), parameter :: poissons(3) = [0.0_wp, 0.3_wp, 0.499_wp], curvature = 1.0e-6_wp
      real(wp) :: y, moment, expected
      integer :: k, n, iterations

      do k = 1, size(poissons)
         call new_beam(beam, poissons(k))
         allocate (forces(3, size(beam%nodes, 2)), source=0.0_wp)
         do n = 1, size(beam%nodes, 2)
            if (beam%nodes(1, n) < 0.999_wp*length) cycle
            beam%is_free(1, n) = .false.
            beam%positions(1, n) = length*(1.0_wp - curvature*(beam%nodes(2, n) - 0.5_wp*height))
         end do
         call find_equilibrium(beam, forces, 1.0e-7_wp, iterations)
         call assemble(beam, forces)
         moment = 0.0_wp
         do n = 1, size(beam%nodes, 2)
            y = beam%nodes(2, n) - 0.5_wp*height
            if (beam%nodes(1, n) > 0.999_wp*length) moment = moment - forces(1, n)*y
            if (abs(y) < 0.1_wp) call assertEqual(0.5_wp*curvature*beam%nodes(1, n)**2, &
               beam%positions(2, n) - beam%nodes(2, n), tolerance=1.0e-6_wp*curvature*length**2)
         end do
         expected = young/(1.0_wp - poissons(k)**2)*height**4/12.0_wp*curvature
         call record('solid.brick.bending', &
            abs(moment/(expected*stiffness_ratio(poissons(k), over)) - 1.0_wp))
         call assertEqual(stiffness_ratio(poissons(k), over), moment/expected, tolerance=2.0e-6_wp)
         ! no locking
         call assertEqual(1.0_wp, moment/expected, tolerance=0.11_wp)
         deallocate (forces)
      end do
   end subroutine test_bending

   !> A load at the end that keeps its direction, P L^2/(E I) = 1 and 2: the elastica (K.
   !> Mattiasson, Int. J. Numer. Meth. Eng. 17, 1981, 145) with the stiffness of the bricks. What
   !> is left is shear, 6/5 P/(G A), some 0.7 %.
   subroutine test_cantilever()
      type(box) :: beam
      real(wp), allocatable :: external(:, :)
      real(wp), parameter :: deflections(2) = [0.30172_wp, 0.49346_wp]
      real(wp), parameter :: shortenings(2) = [0.05643_wp, 0.16064_wp]
      real(wp) :: load, found(2), share
      integer :: k, n, iterations, tip

      call new_beam(beam, 0.0_wp)
      allocate (external(3, size(beam%nodes, 2)), source=0.0_wp)
      load = young*height**4/12.0_wp*stiffness_ratio(0.0_wp, over)/length**2
      tip = 0
      do k = 1, 2
         do n = 1, size(beam%nodes, 2)
            if (beam%nodes(1, n) < 0.999_wp*length) cycle
            share = 1.0_wp
            if (abs(beam%nodes(2, n) - 0.5_wp*height) > 0.49_wp*height) share = 0.5_wp
            external(2, n) = k*load*share/(2.0_wp*over)
            if (abs(beam%nodes(2, n) - 0.5_wp*height) < 0.1_wp) tip = n
         end do
         call find_equilibrium(beam, external, 1.0e-8_wp*load, iterations)
         call assertLessThanOrEqual(iterations, 12)
         found = [1.0_wp, -1.0_wp]*(beam%positions([2, 1], tip) - beam%nodes([2, 1], tip))/length
         call record('solid.brick.cantilever', abs(found(1)/deflections(k) - 1.0_wp))
         call assertEqual(deflections(k), found(1), tolerance=0.01_wp*deflections(k))
         call assertEqual(shortenings(k), found(2), tolerance=0.01_wp*shortenings(k))
      end do
   end subroutine test_cantilever

   !> Stiffness matrices of equal shear modulus differ by V (K2 - K1) b b', b the mean gradients:
   !> the bulk modulus K resists the mean dilatation and nothing else.
   subroutine test_locking()
      type(solid_material) :: soft, stiff
      type(box) :: one
      type(brick) :: of_soft, of_stiff
      type(error_type), allocatable :: error
      real(wp), parameter :: shear = 100.0_wp, poissons(2) = [0.2_wp, 0.49999_wp]
      real(wp) :: bulk(2), b(24), difference(24, 24), corners(3, 8)
      integer :: j

      soft = isotropic(2.0_wp*shear*(1.0_wp + poissons(1)), poissons(1))
      stiff = isotropic(2.0_wp*shear*(1.0_wp + poissons(2)), poissons(2))
      bulk = 2.0_wp*shear*(1.0_wp + poissons)/(3.0_wp*(1.0_wp - 2.0_wp*poissons))
      call new_box(one, [1, 1, 1], [edge, edge, edge], soft)
      corners = one%nodes(:, one%elements(:, 1))
      ! not a brick's shape
      corners(:, 7) = corners(:, 7) + [0.2_wp, -0.1_wp, 0.3_wp]*edge
      call new_brick(of_soft, corners, soft%stiffness, error)
      call assertFalse(allocated(error))
      call new_brick(of_stiff, corners, stiff%stiffness, error)
      call assertFalse(allocated(error))
      b = reshape(of_soft%mean_gradients, [24])
      do j = 1, 24
         difference(:, j) = of_stiff%stiffness(:, j) - of_soft%stiffness(:, j) &
            - sum(of_soft%weights)*(bulk(2) - bulk(1))*b*b(j)
      end do
      call assertEqual(0.0_wp, maxval(abs(difference)), &
         tolerance=1.0e-9_wp*maxval(of_stiff%stiffness))
   end subroutine test_locking

end module test_solid_brick_structures
