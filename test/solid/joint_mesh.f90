!> The mesh of the joint as a solid beside the deck's text, its sets and facets, and what
!> is refused.
module test_solid_joint_mesh
   use asperity, only: contact_properties, error_type, wp
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_tenon_sizes, tenon_sizes
   use asperity_deck_tenon_text, only: write_tenon_deck
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_solid_mesh_checks, only: check_solid_mesh, mesh_remark
   use asperity_solid_mesh_joint, only: face_bottom, face_side, face_top, new_solid_mesh, &
      part_beam, part_column, solid_mesh
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_joint_mesh

contains

   function suite_joint_mesh() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('mesh of the joint as a solid')
      call suite%addTest(TestMethod('nodes and elements of the deck', test_text))
      call suite%addTest(TestMethod('sets of the deck', test_sets))
      call suite%addTest(TestMethod('facets', test_facets))
      call suite%addTest(TestMethod('graded towards the rims', test_graded))
      call suite%addTest(TestMethod('what does not go with the programme', test_refused))
      call suite%addTest(TestMethod('remarks', test_remarks))
   end function suite_joint_mesh

   !> The deck's text, read back: each node within the ten figures of a coordinate there, each
   !> element the same.
   subroutine test_text()
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      type(error_type), allocatable :: error
      character(len=:), allocatable :: text
      integer, allocatable :: numbers(:, :)
      real(wp), allocatable :: rows(:, :)
      type(tenon_settings) :: settings
      integer :: i, column

      ! elastic, as the deck cannot say how wood is crushed
      settings%wood%criterion = 'none'
      call make(deck, settings, 60.0_wp)
      call new_solid_mesh(mesh, deck, error)
      call assertFalse(allocated(error))
      call write_tenon_deck(deck, text, error)
      column = size(deck%column%nodes, 2)
      ! 714 nodes and 378 elements at 60 mm: those of the prototype, made apart from this code
      call assertEqual([714, 378], [size(mesh%nodes, 2), size(mesh%elements, 2)], 'how many')
      allocate (rows, source=reshape([block_of(text, '*NODE, NSET=COLUMN_NODES'), &
         block_of(text, '*NODE, NSET=BEAM_NODES')], [4, size(mesh%nodes, 2)]))
      call assertTrue(all(nint(rows(1, :)) == [(i, i=1, size(rows, 2))]), 'numbers of nodes')
      call assertTrue(all(abs(rows(2:, :) - mesh%nodes) < 1.0e-7_wp), 'places of nodes')
      allocate (numbers, source=nint(reshape( &
         [block_of(text, '*ELEMENT, TYPE=C3D8I, ELSET=COLUMN'), &
         block_of(text, '*ELEMENT, TYPE=C3D8I, ELSET=BEAM')], [9, size(mesh%elements, 2)])))
      call assertTrue(all(numbers(1, :) == [(i, i=1, size(numbers, 2))]), 'numbers of elements')
      call assertTrue(all(numbers(2:, :) == mesh%elements), 'nodes of elements')
      call assertTrue(all((mesh%part == part_column) .eqv. all(mesh%elements <= column, 1)), &
         'parts')
      call assertTrue(all((mesh%part == part_beam) .eqv. all(mesh%elements > column, 1)), 'parts')
   end subroutine test_text

   !> Sets as the text names them, and by their places.
   subroutine test_sets()
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      type(tenon_settings) :: settings
      type(error_type), allocatable :: error
      character(len=:), allocatable :: text

      settings%wood%criterion = 'none'
      call make(deck, settings, 60.0_wp)
      call new_solid_mesh(mesh, deck, error)
      call write_tenon_deck(deck, text, error)
      call check('BOTTOM', mesh%foot)
      call check('TOP', mesh%heads(1)%nodes)
      call check('SYMMETRY', mesh%middle)
      call check('TIP', mesh%load)
      call check('AXIAL', [mesh%axial_node])
      associate (x => mesh%nodes)
         call assertTrue(all(abs(x(3, mesh%foot) + 500.0_wp) < 1.0e-9_wp), 'foot')
         call assertTrue(all(abs(x(3, mesh%heads(1)%nodes) - 500.0_wp) < 1.0e-9_wp), 'head')
         call assertTrue(all(abs(x(2, mesh%middle)) < 1.0e-9_wp), 'plane of symmetry')
         call assertTrue(all(abs(x(1, mesh%load) - 500.0_wp) + abs(x(3, mesh%load)) < 1.0e-9_wp), &
            'load')
         call assertEqual([-300.0_wp, 0.0_wp, 0.0_wp], x(:, mesh%hold_node), tolerance=1.0e-9_wp)
         ! 13 cells from -300 to 500: the fifth plane is the nearest to 0
         call assertTrue(all(abs(x(1, mesh%section) + 300.0_wp - 800.0_wp*5/13) < 1.0e-9_wp), &
            'section')
         ! two nodes across half the beam, seven over its height
         call assertEqual(14, size(mesh%section))
         call assertTrue(all(mesh%section > size(deck%column%nodes, 2)), 'of the beam')
      end associate
   contains
      subroutine check(name, nodes)
         character(len=*), intent(in) :: name
         integer, intent(in) :: nodes(:)
         integer, allocatable :: numbers(:)

         allocate (numbers, source=nint(block_of(text, '*NSET, NSET='//name//new_line('a'))))
         call assertEqual(size(numbers), size(nodes), message=name)
         if (size(numbers) == size(nodes)) call assertTrue(all(numbers == nodes), name)
      end subroutine check
   end subroutine test_sets

   !> Areas and outward normals of the facets, by the cross product of their diagonals: slaves from
   !> the wood of the column into the mortise, masters out of the beam.
   subroutine test_facets()
      type(tenon_settings) :: s
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      type(error_type), allocatable :: error
      real(wp) :: side, high

      call make(deck, s, 60.0_wp)
      call new_solid_mesh(mesh, deck, error)
      side = 52.5_wp - deck%sizes%side_overlap
      high = 300.0_wp + deck%sizes%gap_above + deck%sizes%gap_below
      call check(mesh%mortise(face_top, 1)%facets, [0.0_wp, 0.0_wp, -297.0_wp*side], 'upper slave')
      call check(mesh%mortise(face_bottom, 1)%facets, [0.0_wp, 0.0_wp, 297.0_wp*side], &
         'lower slave')
      call check(mesh%mortise(face_side, 1)%facets, [0.0_wp, -297.0_wp*(high - 6.0_wp), 0.0_wp], &
         'slave at the side')
      call check(mesh%tenon(face_top, 1)%facets, [0.0_wp, 0.0_wp, 800.0_wp*52.5_wp], 'upper master')
      call check(mesh%tenon(face_bottom, 1)%facets, [0.0_wp, 0.0_wp, -800.0_wp*52.5_wp], &
         'lower master')
      call check(mesh%tenon(face_side, 1)%facets, [0.0_wp, 800.0_wp*300.0_wp, 0.0_wp], &
         'master at the side')
      s%side_pressure = 0.0_wp
      call make(deck, s, 60.0_wp)
      call new_solid_mesh(mesh, deck, error)
      call assertEqual([0, 0], [size(mesh%mortise(face_side, 1)%facets, 2), &
         size(mesh%tenon(face_side, 1)%facets, 2)], 'no sides')
   contains
      subroutine check(facets, expected, name)
         integer, intent(in) :: facets(:, :)
         real(wp), intent(in) :: expected(3)
         character(len=*), intent(in) :: name
         real(wp) :: a(3), b(3), area(3)
         integer :: i

         area = 0.0_wp
         do i = 1, size(facets, 2)
            a = mesh%nodes(:, facets(3, i)) - mesh%nodes(:, facets(1, i))
            b = mesh%nodes(:, facets(4, i)) - mesh%nodes(:, facets(2, i))
            area = area + 0.5_wp*[a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), &
               a(1)*b(2) - a(2)*b(1)]
         end do
         call assertEqual(expected, area, tolerance=1.0e-6_wp, message=name)
      end subroutine check
   end subroutine test_facets

   !> Without relief slaves end at the rims, all of the mortise is slave, and the section whose
   !> rotation is the joint's is at the column face.
   subroutine test_graded()
      type(tenon_settings) :: s
      type(tenon_deck) :: deck
      type(solid_mesh) :: mesh
      type(error_type), allocatable :: error
      integer :: i

      call make(deck, s, 60.0_wp, rim=8.0_wp)
      call new_solid_mesh(mesh, deck, error)
      call assertFalse(allocated(error))
      call assertTrue(all(abs(mesh%nodes(1, mesh%section)) < 1.0e-12_wp), 'section')
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], mesh%nodes(:, mesh%axial_node), &
         tolerance=1.0e-12_wp)
      do i = face_top, face_side
         associate (x => mesh%nodes(1, mesh%mortise(i, 1)%facets(1, :)), &
               y => mesh%nodes(1, mesh%mortise(i, 1)%facets(3, :)))
            call assertEqual([-300.0_wp, 0.0_wp], [min(minval(x), minval(y)), &
               max(maxval(x), maxval(y))], tolerance=1.0e-12_wp, message='ends at the rims')
         end associate
      end do
   end subroutine test_graded

   !> With clearances of 0.5 - 4*0.0593 = 0.2628 mm an arm of 500 mm meets the faces at
   !> 0.2628*(1000/300 + 1) = 1.1388 mm.
   subroutine test_refused()
      type(tenon_settings) :: s
      type(tenon_deck) :: deck
      type(error_type), allocatable :: error

      ! 150*(1 - 1.1388/1.2) = 7.65 mm, less than a sixth of 60 mm but not of 30 mm
      s%amplitudes = [1.2_wp]
      s%cycles = [1]
      call make(deck, s, 60.0_wp)
      call refused('mesh_size = 60.0 mm is too coarse for the indentation: at 1.2 mm the tenon '// &
         'meets its faces over 7.650 mm')
      call make(deck, s, 30.0_wp)
      call check_solid_mesh(deck, error)
      call assertFalse(allocated(error), 'fine enough')
      call make(deck, s, 60.0_wp, rim=58.0_wp)
      call refused('rim_mesh_size = 58.0 mm is too coarse for the indentation')
      s%amplitudes = [1.1_wp]
      call make(deck, s, 60.0_wp)
      call check_solid_mesh(deck, error)
      call assertFalse(allocated(error), 'sides touch')
      s%side_pressure = 0.0_wp
      call make(deck, s, 60.0_wp)
      call refused('nothing touches: the largest displacement is 1.1 mm, and the tenon meets '// &
         'its faces at 1.139 mm')
   contains
      subroutine refused(start)
         character(len=*), intent(in) :: start
         type(solid_mesh) :: mesh

         call new_solid_mesh(mesh, deck, error)
         call assertTrue(allocated(error), start)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, start), message=error%message)
      end subroutine refused
   end subroutine test_refused

   !> At 48 mm the rims go (48 - 1.1388)/(1 + 1000/300) = 10.8 mm into the faces.
   subroutine test_remarks()
      type(tenon_settings) :: s

      call check(s, 60.0_wp, 'elements of 60.0 mm at the rims are coarse for an indentation of '// &
         'about 10.8 mm')
      call check(s, 30.0_wp, '')
      ! 8 + 12 + 18 + 27 + 40.5 + 60 = 165.5 mm on half of 300 mm: 8*150/165.5
      call check(s, 60.0_wp, 'elements of 7.251 mm at the rims are smaller than the indentation', &
         rim=8.0_wp)
      s%amplitudes = [1.1_wp]
      s%cycles = [1]
      call check(s, 30.0_wp, 'the tenon meets its sides only')
      ! wood is not crushed: 6.86/4.333 = 1.6 mm over 150 mm is below its strength
      s%amplitudes = [8.0_wp]
      call check(s, 60.0_wp, '')
   contains
      subroutine check(settings, cell, start, rim)
         type(tenon_settings), intent(in) :: settings
         real(wp), intent(in) :: cell
         character(len=*), intent(in) :: start
         real(wp), intent(in), optional :: rim
         type(tenon_deck) :: deck
         character(len=240) :: remark

         call make(deck, settings, cell, rim)
         remark = mesh_remark(deck)
         if (start == '') call assertEqual('', trim(remark))
         call assertEqual(1, index(remark, start), message=trim(remark))
      end subroutine check
   end subroutine test_remarks

   !> The deck of the paper's joint but for settings and mesh.
   subroutine make(deck, settings, cell, rim)
      type(tenon_deck), intent(out) :: deck
      type(tenon_settings), intent(in) :: settings
      real(wp), intent(in) :: cell
      !> Edges at the rims of a graded mesh, which has no relief
      real(wp), intent(in), optional :: rim
      type(tenon_sizes) :: sizes
      type(contact_properties) :: pair
      type(deck_choice) :: choice
      type(error_type), allocatable :: error

      choice%mesh_size = cell
      choice%command = ''
      pair = pair_properties()
      sizes = default_tenon_sizes(settings)
      if (present(rim)) then
         choice%rim_mesh_size = rim
         sizes%edge_relief = 0.0_wp
      end if
      call new_tenon_deck(deck, choice, settings, sizes, 10, pair, pair, error)
      if (allocated(error)) call assertEqual('', error%message)
   end subroutine make

   !> The numbers between a heading and the next line of another kind.
   function block_of(text, heading) result(numbers)
      character(len=*), intent(in) :: text, heading
      real(wp), allocatable :: numbers(:)
      integer :: from, to, i
      character(len=:), allocatable :: part

      from = index(text, heading)
      call assertTrue(from > 0, heading)
      from = from + len(heading)
      if (heading(len(heading):) /= new_line('a')) from = from + 1
      to = from + index(text(from:), '*') - 2
      part = text(from:to)
      do i = 1, len(part)
         if (part(i:i) == new_line('a')) part(i:i) = ','
      end do
      allocate (numbers(count([(part(i:i) == ',', i=1, len(part))])))
      read (part, *) numbers
   end function block_of

end module test_solid_joint_mesh
