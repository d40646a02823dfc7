!> Meshes of the decks: volumes, areas, shapes of elements.
module test_deck_meshes
   use asperity, only: error_type, wp
   use asperity_deck_mesh_cuts, only: even_cuts, graded_cuts
   use asperity_deck_mesh_disc, only: new_disc_mesh
   use asperity_deck_mesh_hexahedra, only: faces_in_box, hex_mesh, least_jacobian, mesh_volume, &
      new_grid_mesh, nodes_in_box
   use asperity_deck_options, only: check_deck_choice, deck_choice
   use asperity_deck_tenon_column, only: new_column
   use asperity_deck_tenon_parts, only: check_tenon_sizes, default_mesh_size, default_tenon_sizes, &
      new_beam, node_near, tenon_elements, tenon_sizes
   use asperity_replay_tenon_settings, only: tenon_settings
   use extremes, only: worsen
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use mesh_checks, only: check_mesh, check_surface, outer_area
   implicit none
   private
   public :: suite_deck_meshes

   real(wp), parameter :: pi = acos(-1.0_wp), far = huge(1.0_wp)

contains

   function suite_deck_meshes() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('meshes of decks')
      call suite%addTest(TestMethod('a brick and its faces', test_brick))
      call suite%addTest(TestMethod('a block with a hole', test_hole))
      call suite%addTest(TestMethod('cuts', test_cuts))
      call suite%addTest(TestMethod('cuts that grow from rims', test_graded_cuts))
      call suite%addTest(TestMethod('measures of an element', test_measures))
      call suite%addTest(TestMethod('discs', test_discs))
      call suite%addTest(TestMethod('edges of discs', test_edges))
      call suite%addTest(TestMethod('column and beam', test_joint))
      call suite%addTest(TestMethod('column and beam, graded', test_graded_joint))
      call suite%addTest(TestMethod('other joints', test_other_joints))
   end function suite_deck_meshes

   !> Each of the six faces points outwards.
   subroutine test_brick()
      real(wp), parameter :: extent(3) = [2.0_wp, 3.0_wp, 5.0_wp]
      type(hex_mesh) :: mesh
      integer, allocatable :: faces(:, :), nodes(:)
      real(wp) :: low(3), high(3), area(3)
      integer :: i, sign

      call new_grid_mesh(mesh, [0.0_wp, 1.0_wp, 2.0_wp], [0.0_wp, 3.0_wp], [0.0_wp, 1.0_wp, 5.0_wp])
      call check_mesh(mesh, product(extent), 'brick')
      call assertEqual(1.0_wp, least_jacobian(mesh), tolerance=1.0e-14_wp)
      do i = 1, 3
         do sign = 0, 1
            low = -far
            high = far
            low(i) = sign*extent(i)
            high(i) = low(i)
            area = 0.0_wp
            area(i) = (2*sign - 1)*product(extent)/extent(i)
            call faces_in_box(mesh, low, high, faces)
            call check_surface(mesh, faces, area, 'face of the brick')
         end do
      end do
      call nodes_in_box(mesh, [1.0_wp, -far, 5.0_wp], [far, far, far], nodes)
      call assertEqual(4, size(nodes))
      call assertTrue(all(mesh%nodes(3, nodes) > 4.9_wp .and. mesh%nodes(1, nodes) > 0.9_wp))
   end subroutine test_brick

   !> Only the nodes around a hole are made, and its faces look into it.
   subroutine test_hole()
      type(hex_mesh) :: mesh
      integer, allocatable :: faces(:, :)
      logical :: keep(5, 5, 5)
      real(wp) :: cuts(6)
      integer :: i

      cuts = [(real(i, wp), i=0, 5)]
      keep = .true.
      keep(2:4, 2:4, 2:4) = .false.
      call new_grid_mesh(mesh, cuts, cuts, cuts, keep)
      call check_mesh(mesh, 98.0_wp, 'block with a hole')
      call assertEqual(216 - 8, size(mesh%nodes, 2))
      call assertEqual(204.0_wp, outer_area(mesh), tolerance=1.0e-12_wp)
      call faces_in_box(mesh, [1.0_wp, 1.0_wp, 4.0_wp], [4.0_wp, 4.0_wp, 4.0_wp], faces)
      call check_surface(mesh, faces, [0.0_wp, 0.0_wp, -9.0_wp], 'roof of the hole')
   end subroutine test_hole

   subroutine test_cuts()
      real(wp), allocatable :: cuts(:)

      call even_cuts(-1.0_wp, 2.0_wp, 0.9_wp, 1, cuts)
      call assertEqual(4, size(cuts))
      call assertEqual(2.0_wp, cuts(4))
      call even_cuts(0.0_wp, 1.0_wp, 7.0_wp, 1, cuts)
      call assertEqual(2, size(cuts))
      call even_cuts(0.0_wp, 5.0_wp, 1.0_wp, 2, cuts)
      call assertEqual(1, mod(size(cuts), 2), message='a node in the middle')
   end subroutine test_cuts

   !> Cells of 1, 2, 4, 4 mm fill 7 and 11 mm; 8 mm are nearer to 7 than to 11 by their ratios, so
   !> that 1, 2, 4 mm are stretched.
   subroutine test_graded_cuts()
      real(wp), allocatable :: cuts(:), cells(:)
      integer :: i, n

      call check(7.0_wp, [.true., .false.], [0.0_wp, 1.0_wp, 3.0_wp, 7.0_wp])
      call check(7.0_wp, [.false., .true.], [0.0_wp, 4.0_wp, 6.0_wp, 7.0_wp])
      call check(14.0_wp, [.true., .true.], &
         [0.0_wp, 1.0_wp, 3.0_wp, 7.0_wp, 11.0_wp, 13.0_wp, 14.0_wp])
      call check(11.0_wp, [.true., .false.], [0.0_wp, 1.0_wp, 3.0_wp, 7.0_wp, 11.0_wp])
      call check(8.0_wp, [.true., .false.], [0.0_wp, 8.0_wp, 24.0_wp, 56.0_wp]/7.0_wp)
      call check(0.4_wp, [.true., .false.], [0.0_wp, 0.4_wp])
      call check(0.4_wp, [.true., .true.], [0.0_wp, 0.2_wp, 0.4_wp])
      ! of any length: ends exact, growth as asked for; one cell or two with 1 + growth times its
      ! length is the coarsest choice, so that sizes are within the square root of that
      do i = 1, 60
         call graded_cuts(-50.0_wp, real(i, wp)*7.1_wp, [.true., .false.], 3.0_wp, 40.0_wp, &
            1.5_wp, cuts)
         n = size(cuts)
         call assertEqual([-50.0_wp, real(i, wp)*7.1_wp], cuts([1, n]), tolerance=0.0_wp)
         cells = cuts(2:) - cuts(:n - 1)
         call assertTrue(all(cells(2:) < 1.5_wp*cells(:n - 2) + 1.0e-9_wp &
            .and. cells(2:) > cells(:n - 2) - 1.0e-9_wp), 'growth')
         call assertLessThan(maxval(cells), 40.0_wp*sqrt(2.5_wp))
         call assertLessThan(abs(log(cells(1)/3.0_wp)), 0.5_wp*log(2.5_wp))
      end do
   contains
      subroutine check(length, rims, expected)
         real(wp), intent(in) :: length, expected(:)
         logical, intent(in) :: rims(2)

         call graded_cuts(0.0_wp, length, rims, 1.0_wp, 4.0_wp, 2.0_wp, cuts)
         call assertEqual(size(expected), size(cuts))
         if (size(expected) == size(cuts)) &
            call assertEqual(expected, cuts, tolerance=1.0e-14_wp*length)
      end subroutine check
   end subroutine test_graded_cuts

   !> A wedge of a brick has a known volume and Jacobian; a brick turned inside out has none.
   subroutine test_measures()
      type(hex_mesh) :: mesh

      call new_grid_mesh(mesh, [0.0_wp, 1.0_wp], [0.0_wp, 1.0_wp], [0.0_wp, 1.0_wp])
      ! the upper face half as long: z sections from 1 to 1/2
      mesh%nodes(1, [6, 8]) = 0.5_wp
      call assertEqual(0.75_wp, mesh_volume(mesh), tolerance=1.0e-15_wp)
      call assertEqual(0.5_wp/0.75_wp, least_jacobian(mesh), tolerance=1.0e-15_wp)
      mesh%elements(:, 1) = mesh%elements([5, 6, 7, 8, 1, 2, 3, 4], 1)
      call assertEqual(-0.75_wp, mesh_volume(mesh), tolerance=1.0e-15_wp)
      call assertLessThan(least_jacobian(mesh), 0.0_wp)
   end subroutine test_measures

   !> Volume and areas are those of the true disc, whatever the cells.
   subroutine test_discs()
      real(wp), parameter :: cells(*) = [10.0_wp, 8.0_wp, 5.0_wp, 2.5_wp], diameter = 61.8_wp
      type(hex_mesh) :: mesh
      integer, allocatable :: faces(:, :)
      real(wp) :: area
      integer :: i

      area = 0.25_wp*pi*diameter**2
      do i = 1, size(cells)
         call new_disc_mesh(mesh, diameter, -10.0_wp, 0.0_wp, cells(i))
         call check_mesh(mesh, 10.0_wp*area, 'disc')
         call assertGreaterThan(least_jacobian(mesh), 0.6_wp, message='shape of cells')
         call faces_in_box(mesh, [-far, -far, 0.0_wp], [far, far, 0.0_wp], faces)
         call check_surface(mesh, faces, [0.0_wp, 0.0_wp, area], 'upper face')
         call faces_in_box(mesh, [-far, -far, -10.0_wp], [far, far, -10.0_wp], faces)
         call check_surface(mesh, faces, [0.0_wp, 0.0_wp, -area], 'lower face')
         ! the centre of mass is on the axis
         call assertEqual(0.0_wp, sum(mesh%nodes(1, :)), tolerance=1.0e-9_wp)
         call assertEqual(0.0_wp, sum(mesh%nodes(2, :)), tolerance=1.0e-9_wp)
      end do
   end subroutine test_discs

   !> Edges are about as long as asked for: no more than 1.1 times, nor less than half of that, for
   !> a mesh of the paper's fineness.
   subroutine test_edges()
      type(hex_mesh) :: mesh
      real(wp) :: edge, least, largest
      integer :: i, j

      call new_disc_mesh(mesh, 61.8_wp, 0.0_wp, 10.0_wp, 2.5_wp)
      least = far
      largest = 0.0_wp
      do i = 1, size(mesh%elements, 2)
         do j = 1, 4
            edge = norm2(mesh%nodes(:, mesh%elements(j, i)) &
               - mesh%nodes(:, mesh%elements(mod(j, 4) + 1, i)))
            least = min(least, edge)
            call worsen(largest, edge)
         end do
      end do
      call assertLessThan(largest, 1.1_wp*2.5_wp)
      call assertGreaterThan(least, 0.5_wp*2.5_wp)
   end subroutine test_edges

   !> The base joint at the paper's mesh size: volumes, faces of the mortise, nodes at mid-height.
   subroutine test_joint()
      type(tenon_settings) :: s
      type(tenon_sizes) :: sizes
      type(deck_choice) :: choice
      type(hex_mesh) :: column, beam
      integer, allocatable :: faces(:, :), nodes(:)
      real(wp) :: half, top, bottom

      ! the paper's mesh for the paper's joint
      call assertEqual(30.0_wp, default_mesh_size(s), tolerance=0.0_wp)
      choice%mesh_size = default_mesh_size(s)
      sizes = default_tenon_sizes(s)
      sizes%gap_above = 0.3_wp
      sizes%gap_below = -0.2_wp
      sizes%side_interference = 0.5_wp
      sizes%side_overlap = 0.1_wp
      half = 0.5_wp*s%width - sizes%side_overlap
      top = 150.3_wp
      bottom = -149.8_wp
      call new_column(column, choice, s, sizes)
      call check_mesh(column, 300.0_wp*(150.0_wp*1000.0_wp - half*(top - bottom)), 'column')
      call faces_in_box(column, [-far, 0.0_wp, top], [far, half, top], faces)
      call check_surface(column, faces, [0.0_wp, 0.0_wp, -300.0_wp*half], 'top of the mortise')
      call faces_in_box(column, [-far, 0.0_wp, bottom], [far, half, bottom], faces)
      call check_surface(column, faces, [0.0_wp, 0.0_wp, 300.0_wp*half], 'bottom of the mortise')
      call faces_in_box(column, [-far, half, bottom], [far, half, top], faces)
      call check_surface(column, faces, [0.0_wp, -300.0_wp*(top - bottom), 0.0_wp], &
         'side of the mortise')

      sizes%tail = 40.0_wp
      call new_beam(beam, choice, s, sizes)
      call check_mesh(beam, 840.0_wp*52.5_wp*300.0_wp, 'beam')
      call nodes_in_box(beam, [500.0_wp, -far, 0.0_wp], [500.0_wp, far, 0.0_wp], nodes)
      call assertEqual(3, size(nodes), message='nodes of the load point')
      associate (place => beam%nodes(:, node_near(beam, [0.0_wp, 0.0_wp, 0.0_wp])))
         call assertLessThan(abs(place(1)), 15.0_wp)
         call assertEqual(0.0_wp, norm2(place(2:)), tolerance=1.0e-12_wp)
      end associate
   end subroutine test_joint

   !> Fine at the rims: sections of the beam at the column face and at mid-height, cells of about
   !> the size asked for where contact begins, and the volumes of the even meshes.
   subroutine test_graded_joint()
      type(tenon_settings) :: s
      type(tenon_sizes) :: sizes
      type(deck_choice) :: choice
      type(hex_mesh) :: column, beam
      integer, allocatable :: faces(:, :), nodes(:)
      real(wp), parameter :: rim = 8.0_wp
      integer :: tail

      choice%mesh_size = 60.0_wp
      choice%rim_mesh_size = rim
      do tail = 0, 40, 40
         sizes = default_tenon_sizes(s)
         sizes%gap_above = 0.3_wp
         sizes%gap_below = 0.3_wp
         sizes%side_overlap = 0.1_wp
         sizes%tail = real(tail, wp)
         if (tail > 0) sizes%edge_relief = 0.0_wp
         call new_column(column, choice, s, sizes)
         call check_mesh(column, 300.0_wp*(150.0_wp*1000.0_wp - 52.4_wp*300.6_wp), 'column')
         call faces_in_box(column, [-far, 0.0_wp, 150.3_wp], [far, 52.4_wp, 150.3_wp], faces)
         call check_surface(column, faces, [0.0_wp, 0.0_wp, -300.0_wp*52.4_wp], &
            'top of the mortise')
         call new_beam(beam, choice, s, sizes)
         call check_mesh(beam, (800.0_wp + tail)*52.5_wp*300.0_wp, 'beam')
         call nodes_in_box(beam, [0.0_wp, 0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp, 0.0_wp], nodes)
         call assertEqual(1, size(nodes), message='node at the middle of the column face')
         ! the relief, if any, then a cell of the rim; likewise on the other side of each rim
         associate (relief => sizes%edge_relief)
            call check_cell(column%nodes(1, :), -300.0_wp + relief, 1)
            call check_cell(column%nodes(1, :), 0.0_wp, -1)
            call check_cell(column%nodes(3, :), 150.3_wp - relief, -1)
            call check_cell(column%nodes(3, :), 150.3_wp, 1)
            call check_cell(column%nodes(3, :), -150.3_wp + relief, 1)
            call check_cell(column%nodes(3, :), -150.3_wp, -1)
         end associate
         call check_cell(beam%nodes(1, :), -300.0_wp, 1)
         call check_cell(beam%nodes(1, :), 0.0_wp, -1)
         call check_cell(beam%nodes(1, :), 0.0_wp, 1)
         call check_cell(beam%nodes(3, :), 150.0_wp, -1)
         call check_cell(beam%nodes(3, :), -150.0_wp, 1)
         if (tail > 0) call check_cell(beam%nodes(1, :), -300.0_wp, -1)
         ! an estimate that may be too high, not too low
         call assertLessThan(real(size(column%elements, 2) + size(beam%elements, 2), wp), &
            1.2_wp*tenon_elements(choice, s, sizes))
      end do

      call assertGreaterThan(400.0_wp, real(size(beam%elements, 2), wp))
      call refused(8.0_wp, 1.5_wp, '')
      call refused(61.0_wp, 1.5_wp, 'rim_mesh_size = 61.0 mm is larger than mesh_size, 60.0 mm')
      call refused(0.0_wp, 1.5_wp, 'rim_mesh_size = 0.0 is not allowed')
      call refused(0.4_wp, 1.5_wp, 'rim_mesh_size = 0.4 mm is outside 0.5 to 490.0 mm')
      call refused(8.0_wp, 1.0_wp, 'mesh_growth = 1.0 is not allowed: it must be a number between')
      call refused(8.0_wp, 5.0_wp, 'mesh_growth = 5.0 is not allowed')
   contains
      !> The cell beside a plane, to its right or left, is of the rims: within the square root of
      !> the growth.
      subroutine check_cell(places, plane, side)
         real(wp), intent(in) :: places(:), plane
         integer, intent(in) :: side
         real(wp) :: cell

         call assertLessThan(minval(abs(places - plane)), 1.0e-9_wp)
         cell = minval(side*(places - plane), mask=side*(places - plane) > 1.0e-6_wp)
         call assertLessThan(abs(log(cell/rim)), 0.5_wp*log(1.5_wp))
      end subroutine check_cell

      subroutine refused(finest, growth, start)
         real(wp), intent(in) :: finest, growth
         character(len=*), intent(in) :: start
         type(error_type), allocatable :: error

         choice%rim_mesh_size = finest
         choice%mesh_growth = growth
         call check_deck_choice(choice, .false., error)
         call assertTrue(allocated(error) .eqv. start /= '', start)
         if (allocated(error)) call assertEqual(1, index(error%message, start), error%message)
      end subroutine refused
   end subroutine test_graded_joint

   !> Coarse and odd joints are meshed too, and what cannot be is refused.
   subroutine test_other_joints()
      type(tenon_settings) :: s
      type(tenon_sizes) :: sizes
      type(deck_choice) :: choice
      type(hex_mesh) :: mesh
      type(error_type), allocatable :: error
      integer, allocatable :: nodes(:)

      s%width = 75.0_wp
      s%height = 137.0_wp
      s%length = 210.0_wp
      s%arm = 611.0_wp
      s%arm_datum = 'column_axis'
      choice%mesh_size = 75.0_wp
      sizes = default_tenon_sizes(s)
      call check_tenon_sizes(choice, s, sizes, error)
      call assertFalse(allocated(error))
      call new_column(mesh, choice, s, sizes)
      ! a square column, 10/3 as high as the tenon
      call check_mesh(mesh, 210.0_wp*(105.0_wp*1370.0_wp/3.0_wp - 37.5_wp*137.0_wp), 'column')
      call new_beam(mesh, choice, s, sizes)
      call check_mesh(mesh, (210.0_wp + 506.0_wp)*37.5_wp*137.0_wp, 'beam')
      call nodes_in_box(mesh, [506.0_wp, -far, 0.0_wp], [506.0_wp, far, 0.0_wp], nodes)
      call assertEqual(2, size(nodes))

      ! sizes that follow are in range with the height
      choice%mesh_size = 3.0_wp
      s%height = 5.0_wp
      sizes = default_tenon_sizes(s)
      call check_tenon_sizes(choice, s, sizes, error)
      call assertFalse(allocated(error))
      s%height = 4000.0_wp
      sizes = default_tenon_sizes(s)
      sizes%edge_relief = 0.0_wp
      call check_tenon_sizes(choice, s, sizes, error)
      call assertFalse(allocated(error))
      s%height = 137.0_wp
      sizes = default_tenon_sizes(s)

      choice%mesh_size = 76.0_wp
      call refused('mesh_size = 76.0 mm is larger than the part: width is 75.0 mm')
      choice%mesh_size = 21.0_wp
      call coarse(tenon_settings(width=20.0_wp), 'width is 20.0 mm')
      call coarse(tenon_settings(height=20.0_wp), 'height is 20.0 mm')
      call coarse(tenon_settings(length=20.0_wp), 'length is 20.0 mm')
      call coarse(tenon_settings(arm=20.0_wp), 'arm is 20.0 mm')
      choice%mesh_size = 30.0_wp
      sizes%column_width = 75.0_wp
      call refused('column_width = 75.0 mm is too small')
      sizes%column_width = 0.0_wp
      call refused('column_width = 0.0 is not allowed')
      sizes = default_tenon_sizes(s)
      sizes%column_height = 137.0_wp
      call refused('column_height = 137.0 mm is too small')
      sizes = default_tenon_sizes(s)
      sizes%tail = -1.0_wp
      call refused('tail = -1.0')

   contains

      !> A mesh of 21 mm is refused for what is 20 mm.
      subroutine coarse(settings, part)
         type(tenon_settings), intent(in) :: settings
         character(len=*), intent(in) :: part

         call check_tenon_sizes(choice, settings, default_tenon_sizes(settings), error)
         call assertTrue(allocated(error), part)
         if (allocated(error)) call assertEqual('mesh_size = 21.0 mm is larger than the part: '// &
            part, error%message)
      end subroutine coarse

      subroutine refused(start)
         character(len=*), intent(in) :: start

         call check_tenon_sizes(choice, s, sizes, error)
         call assertTrue(allocated(error), message=start)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, start), message=error%message)
      end subroutine refused

   end subroutine test_other_joints

end module test_deck_meshes
