!> The mesh of a frame: volumes, facets of its joints, symmetry; tables that are refused.
module test_solid_frame_mesh
   use asperity, only: contact_properties, error_type, wp
   use asperity_deck_mesh_hexahedra, only: hex_mesh, least_jacobian, mesh_volume
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_tenon_sizes, tenon_sizes
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_solid_frame_mesh, only: joint_count, new_frame_mesh
   use asperity_solid_frame_settings, only: check_frame_settings, complete_frame_settings, &
      frame_settings
   use asperity_solid_mesh_joint, only: face_bottom, face_side, face_top, part_beam, part_column, &
      part_shoe, solid_mesh
   use asperity_solid_small_matrices, only: cross
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_frame_mesh

   !> Sizes of the frames, mm
   real(wp), parameter :: height = 2000.0_wp, depth = 300.0_wp, wide = 52.5_wp

contains

   function suite_frame_mesh() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('mesh of a frame')
      call suite%addTest(TestMethod('volumes', test_volumes))
      call suite%addTest(TestMethod('facets of each joint', test_facets))
      call suite%addTest(TestMethod('a beam that ends with its columns', test_flush))
      call suite%addTest(TestMethod('feet, heads, joints', test_sets))
      call suite%addTest(TestMethod('left is right in a mirror', test_mirror))
      call suite%addTest(TestMethod('tables that are refused', test_refused))
   end function suite_frame_mesh

   !> Two beams in three columns, the upper one from the second column on.
   type(frame_settings) function two_beams() result(frame)
      allocate (frame%column_places, source=[-1000.0_wp, 0.0_wp, 1000.0_wp])
      allocate (frame%beam_heights, source=[600.0_wp, 1200.0_wp])
      allocate (frame%beam_from, source=[1, 2])
      allocate (frame%beam_to, source=[3, 3])
   end function two_beams

   !> Mesh of a frame with a tail of 150 mm unless given.
   subroutine make(mesh, deck, frame, tail, rim)
      type(solid_mesh), intent(out) :: mesh
      type(tenon_deck), intent(out) :: deck
      type(frame_settings), intent(inout) :: frame
      real(wp), intent(in), optional :: tail, rim
      type(tenon_settings) :: settings
      type(tenon_sizes) :: sizes
      type(contact_properties) :: pair
      type(deck_choice) :: choice
      type(error_type), allocatable :: error
      integer, allocatable :: beam_ends(:, :)

      settings%arm = height
      settings%amplitudes = [50.0_wp]
      settings%cycles = [1]
      sizes = default_tenon_sizes(settings)
      sizes%column_height = height
      sizes%tail = 150.0_wp
      if (present(tail)) sizes%tail = tail
      choice%mesh_size = 100.0_wp
      if (present(rim)) choice%rim_mesh_size = rim
      choice%command = ''
      pair = pair_properties()
      call new_tenon_deck(deck, choice, settings, sizes, 10, pair, pair, error)
      if (.not. allocated(error)) call complete_frame_settings(frame, deck%sizes, error)
      if (.not. allocated(error)) &
         call check_frame_settings(frame, deck%settings, deck%sizes, error)
      if (.not. allocated(error)) call new_frame_mesh(mesh, frame, deck, beam_ends, error)
      if (allocated(error)) call assertEqual('', error%message)
   end subroutine make

   !> Columns less their mortises, beams; all cells are bricks.
   subroutine test_volumes()
      type(frame_settings) :: frame
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      real(wp) :: columns, beams, side, high

      frame = two_beams()
      call make(mesh, deck, frame)
      side = wide - deck%sizes%side_overlap
      high = 300.0_wp + deck%sizes%gap_above + deck%sizes%gap_below
      columns = 3.0_wp*depth*150.0_wp*height - 5.0_wp*depth*side*high
      beams = wide*300.0_wp*((2000.0_wp + 600.0_wp) + (1000.0_wp + 600.0_wp))
      call assertEqual(5, joint_count(frame))
      call check([part_column, part_beam, part_shoe], columns + beams)
      call check([part_beam], beams)
      ! two shoes a column, of a fifth of its depth
      call check([part_shoe], 3.0_wp*depth*150.0_wp*120.0_wp)
      call make(mesh, deck, frame, rim=40.0_wp)
      call check([part_column, part_beam, part_shoe], columns + beams)

   contains

      subroutine check(parts, expected)
         integer, intent(in) :: parts(:)
         real(wp), intent(in) :: expected
         type(hex_mesh) :: some
         integer :: i
         integer, allocatable :: chosen(:)

         chosen = pack([(i, i=1, size(mesh%part))], &
            [(any(parts == mesh%part(i)), i=1, size(mesh%part))])
         some%nodes = mesh%nodes
         ! gfortran 12 does not take elements of a list as the source of an allocation
         allocate (some%elements(8, size(chosen)))
         some%elements = mesh%elements(:, chosen)
         call assertEqual(expected, mesh_volume(some), tolerance=1.0e-9_wp*expected)
         call assertEqual(1.0_wp, least_jacobian(some), tolerance=1.0e-9_wp)
      end subroutine check

   end subroutine test_volumes

   !> Sums of outward normals times areas, from the places of the columns and the beams: slaves from
   !> the wood of the column into the mortise, masters out of the beam.
   subroutine test_facets()
      type(frame_settings) :: frame
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      real(wp) :: side, high, length
      integer :: i

      frame = two_beams()
      call make(mesh, deck, frame)
      side = wide - deck%sizes%side_overlap
      high = 300.0_wp + deck%sizes%gap_above + deck%sizes%gap_below
      call assertTrue(all(mesh%joints%beam == [1, 1, 1, 2, 2]))
      call assertTrue(all(mesh%joints%column == [1, 2, 3, 2, 3]))
      do i = 1, 5
         associate (beam => mesh%joints(i)%beam, column => mesh%joints(i)%column)
            length = merge(2600.0_wp, 1600.0_wp, beam == 1)
            call check(mesh%mortise(face_top, i)%facets, [0.0_wp, 0.0_wp, -depth*side])
            call check(mesh%mortise(face_bottom, i)%facets, [0.0_wp, 0.0_wp, depth*side])
            call check(mesh%mortise(face_side, i)%facets, [0.0_wp, -depth*(high - 6.0_wp), 0.0_wp])
            call check(mesh%tenon(face_top, i)%facets, [0.0_wp, 0.0_wp, length*wide])
            call check(mesh%tenon(face_bottom, i)%facets, [0.0_wp, 0.0_wp, -length*wide])
            call check(mesh%tenon(face_side, i)%facets, [0.0_wp, length*300.0_wp, 0.0_wp])
            call check_middle(mesh%mortise(face_top, i)%facets, &
               [frame%column_places(column), 0.5_wp*side, &
               frame%beam_heights(beam) + 150.0_wp + deck%sizes%gap_above])
         end associate
      end do

   contains

      subroutine check(facets, expected)
         integer, intent(in) :: facets(:, :)
         real(wp), intent(in) :: expected(3)

         call assertEqual(expected, total_area(mesh, facets), tolerance=1.0e-6_wp)
      end subroutine check

      !> Ends of what the facets fill, about their middle.
      subroutine check_middle(facets, expected)
         integer, intent(in) :: facets(:, :)
         real(wp), intent(in) :: expected(3)
         real(wp) :: places(3, size(facets))

         places = mesh%nodes(:, reshape(facets, [size(facets)]))
         call assertEqual(expected, 0.5_wp*(minval(places, 2) + maxval(places, 2)), &
            tolerance=1.0e-9_wp)
      end subroutine check_middle

   end subroutine test_facets

   !> Where the beam ends with the column, contact begins 3 mm inside.
   subroutine test_flush()
      type(frame_settings) :: frame
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      real(wp) :: side, area(3)
      integer :: i

      allocate (frame%column_places, source=[-1000.0_wp, 0.0_wp, 1000.0_wp])
      call make(mesh, deck, frame, tail=0.0_wp)
      side = wide - deck%sizes%side_overlap
      do i = 1, 3
         area = total_area(mesh, mesh%mortise(face_bottom, i)%facets)
         call assertEqual(side*merge(300.0_wp, 297.0_wp, i == 2), area(3), tolerance=1.0e-6_wp)
      end do
   end subroutine test_flush

   !> Feet and heads are lines along the columns' axes; fixed feet are planes; joints have nodes of
   !> both parts around their middle.
   subroutine test_sets()
      type(frame_settings) :: frame
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      integer :: i, along, across

      frame = two_beams()
      call make(mesh, deck, frame)
      across = count(abs(mesh%nodes(1, :) + 1000.0_wp) < 1.0e-9_wp .and. mesh%nodes(3, :) <= 0.0_wp)
      call assertEqual(3*across, size(mesh%foot))
      call assertTrue(all(abs(mesh%nodes(3, mesh%foot)) < 1.0e-9_wp))
      call assertEqual(3*across, size(mesh%load))
      do i = 1, 3
         associate (x => mesh%nodes(:, mesh%heads(i)%nodes))
            call assertTrue(all(abs(x(1, :) - frame%column_places(i)) < 1.0e-9_wp))
            call assertTrue(all(abs(x(3, :) - height) < 1.0e-9_wp))
         end associate
      end do
      do i = 1, size(mesh%joints)
         associate (joint => mesh%joints(i))
            call check(joint%column_nodes)
            call check(joint%beam_nodes)
         end associate
      end do
      along = count(mesh%nodes(3, :) <= 0.0_wp .and. abs(mesh%nodes(2, :)) < 1.0e-9_wp)
      frame%column_feet = 'fixed'
      call make(mesh, deck, frame)
      call assertEqual(along*across, size(mesh%foot))

   contains

      subroutine check(nodes)
         integer, intent(in) :: nodes(:)
         real(wp) :: middle(3)

         middle = sum(mesh%nodes(:, nodes), 2)/size(nodes)
         call assertTrue(size(nodes) > 8)
         call assertEqual(frame%column_places(mesh%joints(i)%column), middle(1), &
            tolerance=1.0e-9_wp)
         call assertEqual(frame%beam_heights(mesh%joints(i)%beam), middle(3), tolerance=1.0e-9_wp)
      end subroutine check

   end subroutine test_sets

   !> A frame about x = 0 has a node at the mirrored place of each.
   subroutine test_mirror()
      type(frame_settings) :: frame
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      integer :: i

      allocate (frame%column_places, source=[-900.0_wp, 900.0_wp])
      call make(mesh, deck, frame, tail=0.0_wp)
      call assertTrue(all([(has_image(mesh%nodes(:, i)), i=1, size(mesh%nodes, 2))]))

   contains

      logical function has_image(place)
         real(wp), intent(in) :: place(3)
         real(wp) :: image(3)
         integer :: j

         image = [-place(1), place(2), place(3)]
         has_image = .false.
         do j = 1, size(mesh%nodes, 2)
            has_image = has_image .or. all(abs(mesh%nodes(:, j) - image) < 1.0e-6_wp)
         end do
      end function has_image

   end subroutine test_mirror

   subroutine test_refused()
      type(frame_settings) :: frame
      type(tenon_settings) :: joint
      type(tenon_sizes) :: sizes

      sizes = default_tenon_sizes(joint)
      sizes%column_height = height
      frame = two_beams()
      call refused('')
      frame%column_places = [0.0_wp]
      call refused('column_places has 1 values: a frame has two columns at least')
      frame = two_beams()
      ! the columns are 300 mm deep
      frame%column_places = [0.0_wp, 300.0_wp, 900.0_wp]
      call refused('column_places = 0.0, 300.0 mm are nearer than the columns are deep, length '// &
         '= 300.0 mm')
      frame%column_places = [0.0_wp, 300.1_wp, 900.0_wp]
      call refused('')
      frame%column_loads = [1000.0_wp, 1000.0_wp]
      call refused('column_loads has 2 values for 3 columns')
      frame%column_loads = [-1.0_wp]
      call refused('column_loads = -1.0 N')
      frame = two_beams()
      frame%beam_heights = [real(wp) ::]
      call refused('beam_heights is empty')
      frame = two_beams()
      frame%beam_to = [3, 4]
      call refused('beam 2 goes from column 2 to 4 (beam_from, beam_to): columns are numbered '// &
         '1 to 3')
      frame%beam_to = [3, 2]
      call refused('beam 2 goes from column 2 to 2')
      frame%beam_from = [2, 0]
      call refused('beam 2 goes from column 0 to 2')
      frame%beam_from = [1, 1, 1]
      frame%beam_to = [3]
      call refused('beam_from has 3 values for 2 beams')
      frame = two_beams()
      frame%beam_from = [2, 2]
      call refused('column 1 at -1000.0 mm has no beam')
      frame = two_beams()
      ! 300 mm high, 0.5 mm of clearance on both sides
      frame%beam_heights = [600.0_wp, 901.0_wp]
      call refused('beam_heights = 600.0, 901.0 mm: beams 1 and 2 meet in a column')
      frame%beam_heights = [600.0_wp, 901.1_wp]
      call refused('')
      ! shoe of 60 mm, half the beam, 0.5 mm
      frame%beam_heights = [210.4_wp, 900.0_wp]
      call refused('beam_heights = 210.4 mm')
      frame%beam_heights = [600.0_wp, 1789.6_wp]
      call refused('beam_heights = 1789.6 mm')
      frame%beam_heights = [210.6_wp, 1789.4_wp]
      call refused('')
      sizes%column_height = 421.0_wp
      call refused('column_height = 421.0 mm is too small for a beam')

   contains

      subroutine refused(start)
         character(len=*), intent(in) :: start
         type(frame_settings) :: complete
         type(error_type), allocatable :: error

         complete = frame
         call complete_frame_settings(complete, sizes, error)
         if (.not. allocated(error)) call check_frame_settings(complete, joint, sizes, error)
         call assertTrue(allocated(error) .neqv. start == '', start)
         if (allocated(error)) call assertEqual(1, index(error%message, start), &
            message=error%message)
      end subroutine refused

   end subroutine test_refused

   !> Sum of outward normals times areas, by the cross product of diagonals, mm^2.
   function total_area(mesh, facets) result(area)
      type(solid_mesh), intent(in) :: mesh
      integer, intent(in) :: facets(:, :)
      real(wp) :: area(3)
      real(wp) :: a(3), b(3)
      integer :: i

      area = 0.0_wp
      do i = 1, size(facets, 2)
         a = mesh%nodes(:, facets(3, i)) - mesh%nodes(:, facets(1, i))
         b = mesh%nodes(:, facets(4, i)) - mesh%nodes(:, facets(2, i))
         area = area + 0.5_wp*cross(a, b)
      end do
   end function total_area

end module test_solid_frame_mesh
