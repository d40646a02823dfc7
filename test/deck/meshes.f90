!> Meshes of the decks: volumes, areas, shapes of elements.
module test_deck_meshes
   use asperity, only: error_type, wp
   use asperity_deck_mesh_cuts, only: even_cuts
   use asperity_deck_mesh_disc, only: new_disc_mesh
   use asperity_deck_mesh_hexahedra, only: faces_in_box, hex_mesh, least_jacobian, mesh_volume, &
      new_grid_mesh, nodes_in_box
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_parts, only: check_tenon_sizes, default_mesh_size, default_tenon_sizes, &
      new_beam, new_column, node_near, tenon_sizes
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
      call suite%addTest(TestMethod('measures of an element', test_measures))
      call suite%addTest(TestMethod('discs', test_discs))
      call suite%addTest(TestMethod('edges of discs', test_edges))
      call suite%addTest(TestMethod('column and beam', test_joint))
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
