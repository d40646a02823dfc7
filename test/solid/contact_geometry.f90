!> Rays, polygons, rims: what contact sees of two surfaces.
module test_solid_contact_geometry
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_solid_contact_geometry_coverage, only: find_coverage
   use asperity_solid_contact_geometry_facet, only: facet_ray, facet_shape, shoot_ray
   use asperity_solid_contact_geometry_polygon, only: clip_to_rectangle
   use asperity_solid_contact_geometry_surface, only: contact_surface, nearest_facet, &
      new_contact_surface, project
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_pair, only: begin_increment, contact_pair, new_contact_pair
   use contact_blocks, only: blocks, new_blocks, turn_master
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_geometry

   integer(int64), parameter :: seed = 26457513_int64
   real(wp), parameter :: up(3) = [0.0_wp, 0.0_wp, 1.0_wp]

contains

   function suite_contact_geometry() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact geometry')
      call suite%addTest(TestMethod('a ray meets a warped facet', test_ray))
      call suite%addTest(TestMethod('a ray walks over the facets', test_walk))
      call suite%addTest(TestMethod('polygons cut by a rectangle', test_clip))
      call suite%addTest(TestMethod('coverage past rims and small facets', test_coverage))
      call suite%addTest(TestMethod('samples of a cell stand for all of it', test_samples))
      call suite%addTest(TestMethod('surfaces that are refused', test_refused))
   end function suite_contact_geometry

   !> Where it meets, and the derivatives by differences.
   subroutine test_ray()
      type(random_stream) :: stream
      type(facet_ray) :: ray, moved
      real(wp) :: corners(3, 4), from(3), change(3), worst
      real(wp), parameter :: step = 1.0e-6_wp
      integer :: i, k

      stream = random_stream(seed)
      write (*, '(5x, a, i0)') 'seed ', seed
      worst = 0.0_wp
      do i = 1, 50
         ! seen from below, clockwise
         corners = reshape([0.0_wp, 0.0_wp, 2.0_wp, 0.0_wp, 8.0_wp, 2.0_wp, 10.0_wp, 8.0_wp, &
            2.0_wp, 10.0_wp, 0.0_wp, 2.0_wp], [3, 4])
         do k = 1, 4
            corners(:, k) = corners(:, k) + [stream%uniform(-1.0_wp, 1.0_wp), &
               stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
         end do
         from = [stream%uniform(1.0_wp, 9.0_wp), stream%uniform(1.0_wp, 7.0_wp), 0.0_wp]
         ray = facet_ray()
         call shoot_ray(ray, corners, from, up)
         call assertTrue(ray%usable, 'it meets')
         worst = max(worst, maxval(abs(matmul(corners, facet_shape(ray%natural)) &
            - from - ray%gap*up)))
         do k = 1, 3
            from(k) = from(k) + step
            moved = ray
            call shoot_ray(moved, corners, from, up)
            change = [moved%natural - ray%natural, moved%gap - ray%gap]/step
            call assertEqual(0.0_wp, maxval(abs(change - ray%inverse(:, k))), &
               tolerance=1.0e-5_wp, message='derivative')
            from(k) = from(k) - step
         end do
      end do
      call assertEqual(0.0_wp, worst, tolerance=1.0e-13_wp, message='place')
      ray = facet_ray()
      call shoot_ray(ray, corners, from, -up)
      call assertFalse(ray%usable, 'the back of a facet')
      ! a facet that leans by 75 degrees
      corners(3, :) = tan(75.0_wp/180.0_wp*acos(-1.0_wp))*corners(1, :)
      call shoot_ray(ray, corners, from, up)
      call assertFalse(ray%usable, 'a leaning facet')
   end subroutine test_ray

   !> To the facet that is found by arithmetic, past a rim to the one next to it.
   subroutine test_walk()
      type(random_stream) :: stream
      type(blocks) :: b
      type(contact_surface) :: surface
      type(error_type), allocatable :: error
      type(facet_ray) :: ray
      real(wp) :: from(3)
      integer :: i, facet, expected(2)

      stream = random_stream(seed + 1)
      write (*, '(5x, a, i0)') 'seed ', seed + 1
      b = new_blocks([1, 1], [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp], [7, 5], [0.0_wp, 0.0_wp], &
         [70.0_wp, 50.0_wp], -0.5_wp)
      call new_contact_surface(surface, 'master', b%nodes, b%master, error)
      call assertFalse(allocated(error), 'the surface')
      call assertEqual(24, count(surface%neighbours == 0), 'edges at rims')
      do i = 1, 100
         from = [stream%uniform(-15.0_wp, 85.0_wp), stream%uniform(-15.0_wp, 65.0_wp), 0.0_wp]
         expected = min(max(int(from(:2)/10.0_wp), 0), [6, 4])
         facet = 1 + mod(i, 35)
         ray = facet_ray()
         call project(surface, b%nodes, from, up, facet, ray)
         call assertEqual(expected(2)*7 + expected(1) + 1, facet, 'facet')
         call assertEqual(0.5_wp, ray%gap, 1.0e-14_wp, 'gap')
      end do
      from = [33.0_wp, 17.0_wp, 0.0_wp]
      call assertEqual(11, nearest_facet(surface, b%nodes, from, up), 'nearest facet')
      call assertEqual(0, nearest_facet(surface, b%nodes, from, -up), 'none behind')
   end subroutine test_walk

   subroutine test_clip()
      real(wp), parameter :: diamond(2, 4) = reshape([1.5_wp, 0.0_wp, 0.0_wp, 1.5_wp, &
         -1.5_wp, 0.0_wp, 0.0_wp, -1.5_wp], [2, 4])
      real(wp), parameter :: one(2) = 1.0_wp
      real(wp) :: area, centroid(2)

      ! an octagon: the diamond without four tips of 1/4 each
      call clip_to_rectangle(diamond, -one, one, area, centroid)
      call assertEqual(4.5_wp - 1.0_wp, area, 1.0e-15_wp, 'octagon')
      call assertEqual([0.0_wp, 0.0_wp], centroid, 1.0e-15_wp, 'its centroid')
      ! a right triangle of sides 1
      call clip_to_rectangle(diamond, [0.5_wp, 0.0_wp], [2.0_wp, 2.0_wp], area, centroid)
      call assertEqual(0.5_wp, area, 1.0e-15_wp, 'triangle')
      call assertEqual([0.5_wp + 1.0_wp/3.0_wp, 1.0_wp/3.0_wp], centroid, 1.0e-15_wp, &
         'centroid of the triangle')
      call clip_to_rectangle(diamond(:, [4, 3, 2, 1]), -2.0_wp*one, 2.0_wp*one, area, centroid)
      call assertEqual(-4.5_wp, area, 1.0e-15_wp, 'clockwise')
      call clip_to_rectangle(diamond, one, 2.0_wp*one, area, centroid)
      call assertEqual(0.0_wp, area, 0.0_wp, 'nothing shared')
   end subroutine test_clip

   !> A cell of 6 mm moves over a rim: its coverage is the share of it inside, though facets are
   !> 2 mm wide; at a corner it is the product.
   subroutine test_coverage()
      real(wp), parameter :: edges(3, 2) = reshape([6.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 6.0_wp, &
         0.0_wp], [3, 2])
      type(blocks) :: b
      type(contact_surface) :: surface
      type(error_type), allocatable :: error
      type(facet_ray) :: ray
      real(wp) :: coverage, gradient(2), place(3), inside(2), by_place(2)
      integer :: i, facet

      b = new_blocks([1, 1], [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp], [10, 4], [0.0_wp, 0.0_wp], &
         [20.0_wp, 20.0_wp], 0.0_wp)
      call new_contact_surface(surface, 'master', b%nodes, b%master, error)
      do i = 0, 60
         place = [20.0_wp - 5.0_wp + 0.17_wp*i, 20.0_wp - 2.9_wp + 0.05_wp*i, 0.0_wp]
         facet = 1
         ray = facet_ray()
         call project(surface, b%nodes, place, up, facet, ray)
         call find_coverage(surface, facet, ray%natural, edges, coverage, gradient)
         inside = min(max(0.5_wp + (20.0_wp - place(:2))/6.0_wp, 0.0_wp), 1.0_wp)
         call assertEqual(product(inside), coverage, 1.0e-13_wp, 'share inside')
         by_place = 0.0_wp
         if (inside(1) < 1.0_wp .and. inside(1) > 0.0_wp) by_place(1) = -inside(2)/6.0_wp
         if (inside(2) < 1.0_wp .and. inside(1) > 0.0_wp) by_place(2) = -inside(1)/6.0_wp
         call assertEqual(by_place, matmul(gradient, ray%inverse(:2, :2)), 1.0e-13_wp, &
            'derivative by the place')
      end do
   end subroutine test_coverage

   !> Weights sum to one and have the cell's middle as their centroid, rims and turned facets alike;
   !> a cell within a facet has one sample.
   subroutine test_samples()
      type(blocks) :: b
      type(contact_pair) :: pair
      type(hard_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: x(3, 4), centroid(3), worst
      integer :: i, j, k, samples

      law%properties = pair_properties()
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [7.0_wp, 3.0_wp], &
         [52.0_wp, 70.0_wp], 0.0_wp)
      call turn_master(b, 3, [30.0_wp, 30.0_wp, 0.0_wp], 0.3_wp)
      call new_contact_pair(pair, 'samples', b%nodes, b%slave, b%master, 3, law, error)
      call begin_increment(pair, b%nodes, error)
      worst = 0.0_wp
      samples = 0
      do i = 1, size(pair%faces)
         x = b%nodes(:, pair%faces(i)%nodes(:4))
         samples = samples + size(pair%faces(i)%samples)
         do j = 1, size(pair%faces(i)%cells)
            associate (cell => pair%faces(i)%cells(j))
               centroid = 0.0_wp
               do k = cell%first, cell%last
                  associate (sample => pair%faces(i)%samples(k))
                     centroid = centroid + sample%weight*matmul(x, sample%shape)
                  end associate
               end do
               worst = max(worst, maxval(abs(centroid - cell%position)), &
                  abs(sum(pair%faces(i)%samples(cell%first:cell%last)%weight) - 1.0_wp))
            end associate
         end do
      end do
      call assertLessThan(worst, 1.0e-4_wp, 'centroid and sum')
      call assertTrue(samples > 120 .and. samples < 240, 'some cells are cut')
      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [6, 2], [0.0_wp, 0.0_wp], &
         [60.0_wp, 60.0_wp], 0.0_wp)
      call new_contact_pair(pair, 'nested', b%nodes, b%slave, b%master, 3, law, error)
      call begin_increment(pair, b%nodes, error)
      call assertEqual(9, size(pair%faces(1)%samples), 'cells that nest')
   end subroutine test_samples

   subroutine test_refused()
      type(blocks) :: b
      type(contact_pair) :: pair
      type(hard_law) :: law
      type(error_type), allocatable :: error

      law%properties = pair_properties()
      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp], [1, 1], [0.0_wp, 0.0_wp], &
         [1.0_wp, 1.0_wp], 0.0_wp)
      call new_contact_pair(pair, 'top', b%nodes, b%slave(:, :0), b%master, 3, law, error)
      call assertTrue(allocated(error), 'no slave')
      call assertEqual('the slave surface of top has no facets: contact needs at least one on '// &
         'either side', error%message)
      call new_contact_pair(pair, 'top', b%nodes, b%slave, b%master(:, :0), 3, law, error)
      call assertTrue(index(error%message, 'the master surface of top has no') == 1, 'no master')
      call new_contact_pair(pair, 'top', b%nodes, b%slave, b%master, 0, law, error)
      call assertTrue(index(error%message, 'contact cells = 0 is not allowed') == 1, 'no cells')
      b%nodes(:, 5) = b%nodes(:, 4)
      call new_contact_pair(pair, 'top', b%nodes, b%slave, b%master, 3, law, error)
      call assertEqual('facet 1 of the slave surface of top, nodes 1, 2, 5, 4, is degenerate: '// &
         'its corners must be four and convex', error%message)
   end subroutine test_refused

end module test_solid_contact_geometry
