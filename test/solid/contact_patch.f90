!> Contact patch test: two flat surfaces of different grids overlap evenly, and the nodal forces of
!> both are those of a uniform pressure.
module test_solid_contact_patch
   use asperity, only: error_type, wp
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_pair, only: begin_increment, contact_pair, default_cells, &
      new_contact_pair
   use contact_blocks, only: blocks, new_blocks, turn_master
   use contact_cases, only: pair_properties
   use contact_forces, only: pair_forces
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use measurements, only: record
   implicit none
   private
   public :: suite_contact_patch

   real(wp), parameter :: size_of_block = 120.0_wp, overclosure = 0.03_wp
   !> Of the hard law at this overclosure, MPa
   real(wp), parameter :: pressure = 20.0_wp

contains

   function suite_contact_patch() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact patch')
      call suite%addTest(TestMethod('4 x 4 on 6 x 6 and 6 x 6 on 4 x 4', test_parallel))
      call suite%addTest(TestMethod('a master turned by 10 degrees', test_turned))
   end function suite_contact_patch

   !> Parallel edges: exact for any number of cells.
   subroutine test_parallel()
      integer, parameter :: facets(2, 3) = reshape([4, 6, 6, 4, 5, 7], [2, 3])
      type(blocks) :: b
      real(wp), allocatable :: forces(:, :), expected(:, :)
      real(wp) :: worst
      integer :: i, cells

      worst = 0.0_wp
      do i = 1, size(facets, 2)
         do cells = 1, 4
            b = new_blocks([1, 1]*facets(1, i), [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp]*size_of_block, &
               [1, 1]*facets(2, i), [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp]*size_of_block, overclosure)
            call press(b, cells, forces, expected)
            call add_uniform(expected, b%slave, (size_of_block/facets(1, i))**2)
            call add_uniform(expected, b%master, -(size_of_block/facets(2, i))**2)
            worst = max(worst, maxval(abs(forces - expected))/maxval(expected))
         end do
      end do
      call record('solid.contact.patch', worst)
      call assertGreaterThan(maxval(expected), 1000.0_wp, 'there are forces')
      call assertLessThan(worst, 1.0e-12_wp, 'largest error over the largest force')
   end subroutine test_parallel

   !> A larger master, turned in its plane. Pieces are polygons, over which shape functions are
   !> taken at the centroid.
   subroutine test_turned()
      integer, parameter :: points = 1200
      real(wp), parameter :: angle = 10.0_wp/180.0_wp*acos(-1.0_wp), facet = 20.0_wp
      type(blocks) :: b
      real(wp), allocatable :: forces(:, :), expected(:, :)
      real(wp) :: place(2), from_centre(2), local(2), u(2), step
      integer :: i, j, at(2)

      b = new_blocks([4, 4], [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp]*size_of_block, [12, 12], &
         [-1.0_wp, -1.0_wp]*60.0_wp, [1.0_wp, 1.0_wp]*180.0_wp, overclosure)
      call turn_master(b, 3, [60.0_wp, 60.0_wp, 0.0_wp], angle)
      call press(b, default_cells, forces, expected)
      call add_uniform(expected, b%slave, 900.0_wp)
      ! the master's by fine sums
      step = size_of_block/points
      do j = 1, points
         do i = 1, points
            place = ([i, j] - 0.5_wp)*step
            from_centre = place - 60.0_wp
            local = [cos(angle)*from_centre(1) + sin(angle)*from_centre(2), &
               cos(angle)*from_centre(2) - sin(angle)*from_centre(1)] + 120.0_wp
            at = int(local/facet)
            u = local/facet - at
            associate (f => expected(3, b%master([1, 4, 3, 2], at(2)*12 + at(1) + 1)))
               expected(3, b%master([1, 4, 3, 2], at(2)*12 + at(1) + 1)) = f - pressure*step**2 &
                  *[(1.0_wp - u(1))*(1.0_wp - u(2)), u(1)*(1.0_wp - u(2)), u(1)*u(2), &
                  (1.0_wp - u(1))*u(2)]
            end associate
         end do
      end do
      associate (n => b%slave_nodes)
         call record('solid.contact.turned_patch.slave', &
            maxval(abs(forces - expected)*spread(merge(1, 0, [(i, i=1, size(forces, 2))] <= n), &
            1, 3))/maxval(expected))
         call record('solid.contact.turned_patch.master', &
            maxval(abs(forces(3, n + 1:) - expected(3, n + 1:)))/maxval(-expected))
         call assertEqual(0.0_wp, maxval(abs(forces(3, :n) - expected(3, :n)))/maxval(expected), &
            tolerance=2.0e-3_wp, message='slave')
         call assertEqual(0.0_wp, maxval(abs(forces(3, n + 1:) - expected(3, n + 1:))) &
            /maxval(-expected), tolerance=2.0e-3_wp, message='master')
      end associate
   end subroutine test_turned

   !> Nodal forces of a pair in hard contact without motion, and zeros.
   subroutine press(b, cells, forces, zeros)
      type(blocks), intent(in) :: b
      integer, intent(in) :: cells
      real(wp), allocatable, intent(out) :: forces(:, :), zeros(:, :)
      type(contact_pair) :: pair
      type(hard_law) :: law
      type(error_type), allocatable :: error

      law%properties = pair_properties()
      call new_contact_pair(pair, 'patch', b%nodes, b%slave, b%master, cells, law, error)
      call assertFalse(allocated(error), 'the pair')
      if (allocated(error)) return
      call begin_increment(pair, b%nodes, error)
      allocate (forces(3, size(b%nodes, 2)), zeros(3, size(b%nodes, 2)), source=0.0_wp)
      call pair_forces(pair, b%nodes, forces)
   end subroutine press

   !> A quarter of the force on each facet at each of its corners.
   subroutine add_uniform(forces, facets, area)
      real(wp), intent(inout) :: forces(:, :)
      integer, intent(in) :: facets(:, :)
      real(wp), intent(in) :: area
      integer :: i

      do i = 1, size(facets, 2)
         forces(3, facets(:, i)) = forces(3, facets(:, i)) + 0.25_wp*pressure*area
      end do
   end subroutine add_uniform

end module test_solid_contact_patch
