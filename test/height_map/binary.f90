!> PLU, PLUX, GWY and GSF: values, notes, and what is refused where.
module test_height_map_binary
   use, intrinsic :: iso_fortran_env, only: int32, real32
   use asperity_base_kinds, only: wp
   use asperity_height_map_read, only: map_hints
   use asperity_height_map_type, only: height_map
   use binary_cases, only: gsf_file, gwy_array, gwy_field, gwy_file, gwy_object, gwy_text, &
      plu_file, &
      plux_members
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: assert_map, has_text, no_hints, read_text, refused
   use zip_writer, only: zip_member_text, zip_of
   implicit none
   private
   public :: suite_map_binary

   character(len=1), parameter :: nul = achar(0)

contains

   function suite_map_binary() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map binary')
      call suite%addTest(TestMethod('plu', test_plu))
      call suite%addTest(TestMethod('plu that is refused', test_plu_faults))
      call suite%addTest(TestMethod('plux', test_plux))
      call suite%addTest(TestMethod('plux that is refused', test_plux_faults))
      call suite%addTest(TestMethod('gwy', test_gwy))
      call suite%addTest(TestMethod('channels of gwy', test_channels))
      call suite%addTest(TestMethod('gwy that is refused', test_gwy_faults))
      call suite%addTest(TestMethod('gsf', test_gsf))
      call suite%addTest(TestMethod('gsf that is refused', test_gsf_faults))
   end function suite_map_binary

   !> The map of the formula, mm; heights are in units of `unit` mm.
   subroutine assert_formula(bytes, unit, format, missing, map)
      character(len=*), intent(in) :: bytes, format
      real(wp), intent(in) :: unit
      logical, intent(in) :: missing
      type(height_map), intent(out) :: map
      real(wp) :: expected(6, 5)
      integer :: i, j

      do j = 1, 5
         do i = 1, 6
            expected(i, j) = unit*(0.25_wp*i*i - 1.5_wp*j)
         end do
      end do
      ! a one, or a nine for a missing point
      expected(2, 3) = merge(9.0_wp, unit, missing)
      call read_text(bytes, no_hints, map)
      call assert_map(map, 6, reshape(expected, [30]), 1.0e-15_wp*unit)
      call assertEqual([0.0015_wp, 0.0025_wp], [map%step_x, map%step_y], 1.0e-18_wp)
      call assertEqual(format, map%format)
   end subroutine assert_formula

   subroutine assert_note(map, part)
      type(height_map), intent(in) :: map
      character(len=*), intent(in) :: part

      call assertTrue(allocated(map%notes), part)
      if (allocated(map%notes)) call assertTrue(has_text(map%notes, part), part//' in '//map%notes)
   end subroutine assert_note

   subroutine test_plu()
      type(height_map) :: map
      character(len=:), allocatable :: bytes

      call plu_file(bytes, 0, '')
      call assert_formula(bytes, 0.001_wp, 'PLU (Sensofar)', .true., map)
      call assertTrue(.not. allocated(map%notes), 'nothing to note')
      ! an image behind, and what newer versions have
      call assert_formula(bytes//repeat('rgb', 30)//'operator', 0.001_wp, 'PLU (Sensofar)', &
         .true., &
         map)
      call plu_file(bytes, 489, achar(3)//nul)
      call assert_formula(bytes, 0.001_wp, 'PLU (Sensofar)', .true., map)
      call assert_note(map, 'holds 3 layers: the first is read')
   end subroutine test_plu

   subroutine test_plu_faults()
      character(len=:), allocatable :: bytes
      character(len=*), parameter :: kinds(0:8) = [character(len=20) :: 'an image', 'a profile', &
         'several profiles', '', 'profiles at several', 'a thickness', 'a custom one', &
         'topographies at', 'thicknesses at']
      integer :: kind

      do kind = 0, 8
         if (kind /= 3) call check(428, transfer(kind, '1234'), 'file: byte 428: ', &
            trim(kinds(kind)))
      end do
      call check(428, transfer(9, '1234'), 'file: byte 428: ', 'kind 9')
      call check(428, transfer(-1, '1234'), 'file: byte 428: ', 'kind 4294967295')
      call check(489, nul, 'file: byte 489: ', 'no layer')
      call check(404, transfer(0.0_real32, '1234'), 'file: byte 404: ', 'step 0.0 um in x')
      call check(408, transfer(-1.0_real32, '1234'), 'file: byte 408: ', 'step -1.0 um in y')
      call check(404, transfer(int(z'7F800000', int32), '1234'), 'file: byte 404: ', 'in x')
      call check(404, transfer(int(z'7FC00000', int32), '1234'), 'file: byte 404: ', 'in x')
      call check(404, transfer(1.0e-9_real32, '1234'), 'file: step ', 'from 1e-9 to 1e6 mm')
      call check(500, transfer([0, 6], repeat(' ', 8)), 'file: byte 500: ', '6 x 0 points')
      call check(500, transfer([100000, 100000], repeat(' ', 8)), 'file: byte 500: ', &
         '100000 x 100000')
      call check(500, transfer([6, 6], repeat(' ', 8)), 'file: byte 500: ', &
         '6 x 6 points, the file has room for 32')
      call check(500, transfer([6, 1], repeat(' ', 8)), 'file: 1 x 6 points', 'are no map')
      ! the 9th height
      call check(540, transfer(int(z'7F800000', int32), '1234'), 'file: byte 540: ', &
         'point 3 of line 2: height')
      call check(540, transfer(2.0e9_real32, '1234'), 'file: byte 540: ', 'beyond 1 km')
      call plu_file(bytes, 0, '')
      call refused(bytes(:627), 'file: byte 500: ', 'the file has room for 29 at most', no_hints)
      call refused(bytes, 'file: ', 'nm contradicts the file, whose heights are in um', &
         map_hints(height_unit='nm'))
      call refused(bytes, 'file: ', '--step 2.0 mm contradicts', map_hints(step_x=2.0_wp))
      ! no PLU without a date or a version
      call check(0, nul, 'file: is in no format', 'PLU')
      call check(490, achar(7), 'file: is in no format', 'PLU')
   contains
      subroutine check(offset, field, start, part)
         integer, intent(in) :: offset
         character(len=*), intent(in) :: field, start, part

         call plu_file(bytes, offset, field)
         call refused(bytes, start, part, no_hints)
      end subroutine check
   end subroutine test_plu_faults

   subroutine test_plux()
      type(zip_member_text) :: members(3)
      type(height_map) :: map
      character(len=:), allocatable :: archive

      call plux_members(members)
      call zip_of(members, archive)
      call assert_formula(archive, 0.001_wp, 'PLUX (Sensofar)', .true., map)
      call change(members, '<INFO/>', '<LAYER_1><FILENAME_Z>other</FILENAME_Z></LAYER_1>')
      call zip_of(members, archive)
      call assert_formula(archive, 0.001_wp, 'PLUX (Sensofar)', .true., map)
      call assert_note(map, 'holds 2 layers: the first is read')
   end subroutine test_plux

   subroutine test_plux_faults()
      type(zip_member_text) :: members(3)
      character(len=:), allocatable :: archive

      call check('>6<', '>5<', 'file: LAYER_0.raw: 120 bytes', '5 x 5 points of 4 bytes')
      call check('>6<', '>7<', 'file: byte 0: ', '7 x 5 points, the file has room for 30')
      call check('>6<', '>six<', 'file: index.xml:', &
         '/GENERAL/IMAGE_SIZE_X is six: it must be a whole number')
      call check('>5<', '>0<', 'file: index.xml:', &
         '/GENERAL/IMAGE_SIZE_Y is 0: it must be a whole number above 0')
      call check('>1.5<', '>-1<', 'file: index.xml:', &
         '/GENERAL/FOV_X is -1: it must be a number above 0')
      call check('>2.5<', '>1,5<', 'file: index.xml:', '/GENERAL/FOV_Y is 1,5: it must be')
      call check('>2.5<', '>1e12<', 'file: step', 'from 1e-9 to 1e6 mm')
      call check('<FOV_X>1.5</FOV_X>', '', 'file: index.xml: ', 'FOV_X')
      call check('FILENAME_Z>LAYER_0.raw</FILENAME_Z', 'A/></A', 'file: index.xml:', 'no sound XML')
      call check('<FILENAME_Z>LAYER_0.raw</FILENAME_Z>', '', 'file: index.xml: ', 'no layer')
      call check('LAYER_0.raw<', 'none.raw<', 'file: the archive has no member none.raw', &
         'incomplete')
      call check('<xml>', '<!DOCTYPE a []><xml>', 'file: index.xml:', 'document type')
      call plux_members(members)
      members(2)%bytes(33:36) = transfer(3.0e9_real32, '1234')
      call zip_of(members, archive)
      call refused(archive, 'file: LAYER_0.raw: byte 32: ', 'beyond 1 km', no_hints)
   contains
      subroutine check(old, new, start, part)
         character(len=*), intent(in) :: old, new, start, part

         call plux_members(members)
         call change(members, old, new)
         call zip_of(members, archive)
         call refused(archive, start, part, no_hints)
      end subroutine check
   end subroutine test_plux_faults

   !> Replace the first such text in index.xml.
   subroutine change(members, old, new)
      type(zip_member_text), intent(inout) :: members(3)
      character(len=*), intent(in) :: old, new
      integer :: at

      at = index(members(1)%bytes, old)
      call assertTrue(at > 0, old)
      if (at > 0) members(1)%bytes = members(1)%bytes(:at - 1)//new// &
         members(1)%bytes(at + len(old):)
   end subroutine change

   subroutine test_gwy()
      type(height_map) :: map
      character(len=:), allocatable :: channel

      channel = gwy_field('/0/data', 'um', gwy_array(.false.))
      call assert_formula(gwy_file(channel), 0.001_wp, 'GWY (Gwyddion)', .false., map)
      call assertTrue(.not. allocated(map%notes), 'nothing to note')
      ! its mask may stand before it
      channel = gwy_field('/0/mask', '', gwy_array(.true.))//channel
      call assert_formula(gwy_file(channel), 0.001_wp, 'GWY (Gwyddion)', .true., map)
      call assert_note(map, '1 points that are masked are taken as missing')
      ! a mask of another channel is none of it
      channel = gwy_field('/1/mask', '', gwy_array(.true.))// &
         gwy_field('/0/data', 'nm', gwy_array(.false.))
      call assert_formula(gwy_file(channel), 1.0e-6_wp, 'GWY (Gwyddion)', .false., map)
   end subroutine test_gwy

   !> Lengths first, by number; else what has no unit, with the user's.
   subroutine test_channels()
      type(height_map) :: map
      character(len=:), allocatable :: heights, volts, plain, file

      heights = gwy_array(.false.)
      volts = gwy_field('/0/data', 'V', heights)//gwy_text('/0/data/title', 'Amplitude')
      file = gwy_file(gwy_field('/12/data', 'mm', heights)//gwy_text('/3/data/title', 'Topo')// &
         gwy_field('/3/data', char(194)//char(181)//'m', heights)//volts)
      call assert_formula(file, 0.001_wp, 'GWY (Gwyddion)', .false., map)
      call assert_note(map, &
         'channel 3 ''Topo'' in um is read, not 0 ''Amplitude'' in V, 12 '''' in mm')
      plain = gwy_field('/7/data', '', heights)
      call read_text(gwy_file(volts//plain), map_hints(height_unit='um'), map)
      call assertEqual(0.001_wp, map%heights(2, 3), 1.0e-18_wp)
      call refused(gwy_file(volts//plain), 'file: does not say in which unit its heights are', &
         '--height-unit', no_hints)
      call refused(gwy_file(volts), 'file: holds no heights', '0 ''Amplitude'' in V', &
         map_hints(height_unit='um'))
      call refused(gwy_file(gwy_text('/0/data', 'no image')), 'file: holds no image', 'Gwyddion', &
         no_hints)
   end subroutine test_channels

   subroutine test_gwy_faults()
      character(len=:), allocatable :: file, heights, place
      integer :: at

      heights = gwy_array(.false.)
      file = gwy_file(gwy_field('/0/data', 'um', heights))
      call refused(file(:len(file) - 1), 'file: byte 21: ', 'do not fit in the', no_hints)
      call refused(file(:11), 'file: byte 4: ', 'a text does not end within its object', no_hints)
      call change_file('GwyContainer', 'GwyOtherThing', 'file: byte 4: ', 'GwyOtherThing')
      at = index(file, 'xres') + 4
      call check(at + 1, 'k', at, 'component of kind 107')
      ! where the field's own components begin
      at = index(file, 'GwyDataField') + 16
      place = 'file: byte '//decimal(at)//': '
      call check_field('xres'//nul//'i', transfer(5, '1234'), 'has 30 heights, and 5 x 5')
      call check_field('xres'//nul//'i', transfer(60000, '1234'), '60000 x 5 points, the file has')
      call check_field('yres'//nul//'i', transfer(-5, '1234'), '6 x -5 points')
      call check_field('xreal'//nul//'d', repeat(nul, 8), 'in x, 0.0, is not allowed')
      call check_field('yreal'//nul//'d', repeat(char(255), 8), 'in y, ')
      call check_field('unitstr'//nul//'s', 'K', 'are in K, which is no length')
      call refused(file, 'file: ', '--lateral-unit mm contradicts', map_hints(lateral_unit='mm'))
      ! the 9th height
      at = index(file, heights) + 10 + 64
      call check(at, transfer(1.0e10_wp, repeat(' ', 8)), at - 1, 'point 3 of line 2: height 1')
      call refused(gwy_file(gwy_field('/0/data', 'um', heights)// &
         gwy_object('/0/mask', 'GwyDataField', gwy_text('title', 'x'))), 'file: byte ', &
         'has 0 numbers of its mask, and 6 x 5 points', no_hints)
   contains
      !> With these bytes at a place.
      subroutine check(at, field, offset, part)
         integer, intent(in) :: at, offset
         character(len=*), intent(in) :: field, part
         character(len=:), allocatable :: other

         other = file
         other(at:at + len(field) - 1) = field
         call refused(other, 'file: byte '//decimal(offset)//': ', part, no_hints)
      end subroutine check

      !> With these bytes as the value of a component of the field.
      subroutine check_field(name, field, part)
         character(len=*), intent(in) :: name, field, part
         character(len=:), allocatable :: other
         integer :: at

         other = file
         at = index(other, name) + len(name)
         other(at:at + len(field) - 1) = field
         call refused(other, place, part, no_hints)
      end subroutine check_field

      subroutine change_file(old, new, start, part)
         character(len=*), intent(in) :: old, new, start, part
         integer :: at

         at = index(file, old)
         call refused(file(:at - 1)//new//file(at + len(old):), start, part, no_hints)
      end subroutine change_file

      function decimal(number) result(text)
         integer, intent(in) :: number
         character(len=:), allocatable :: text
         character(len=12) :: buffer

         write (buffer, '(i0)') number
         text = trim(buffer)
      end function decimal
   end subroutine test_gwy_faults

   subroutine test_gsf()
      type(height_map) :: map
      character(len=:), allocatable :: bytes
      integer :: i

      ! every length of the header
      do i = 0, 4
         call gsf_file(bytes, 'Topography', repeat('t', i))
         call assert_formula(bytes, 0.001_wp, 'GSF (Gwyddion)', .true., map)
      end do
      call gsf_file(bytes, 'm'//achar(10)//'ZUnits = um', 'm')
      call read_text(bytes, map_hints(height_unit='mm'), map)
      call assertEqual(-1.25_wp, map%heights(1, 1), 0.0_wp)
      call gsf_file(bytes, 'XReal = 9.0e-6', 'Other = 1')
      call read_text(bytes, map_hints(step_x=0.0015_wp), map)
      call assertEqual(0.0015_wp, map%step_x, 0.0_wp)
   end subroutine test_gsf

   subroutine test_gsf_faults()
      character(len=:), allocatable :: bytes

      call check('XRes = 6', 'XRes = six', 'file: byte 26: ', 'XRes = six is not allowed')
      call check('XRes = 6', 'XRes = 0', 'file: byte 26: ', 'whole number above 0')
      call check('XRes = 6', 'XRes = 7', 'file: byte 0: ', '7 x 5 points, the file has room for 30')
      call check('XRes = 6', 'XRes = 5', 'file: byte ', 'bytes follow the 5 x 5 points')
      call check('XRes = 6'//achar(10), '', 'file: byte 0: ', 'no XRes')
      call check('XReal = 9.0e-6', 'XReal = 0', 'file: byte 44: ', 'XReal = 0 is not allowed')
      call check('YReal = 12.5e-6', 'YReal = 1,5', 'file: byte 59: ', 'YReal = 1,5 is not allowed')
      call check('XReal = 9.0e-6', 'Other = 1', 'file: does not say the distance', 'in x')
      call check('ZUnits = um', 'ZUnits = V', 'file: byte 0: ', 'heights are in V')
      call check('XYUnits = m', 'XYUnits = s', 'file: byte 0: ', 'lengths are in s')
      call check('ZUnits = um', 'Zoom = 1', 'file: does not say in which unit its heights are', &
         '--height-unit')
      call refused('Gwyddion Simple Field 1.0'//achar(10)//'XRes = 6'//achar(10), &
         'file: byte 35: ', &
         'no zero byte', no_hints)
   contains
      subroutine check(old, new, start, part)
         character(len=*), intent(in) :: old, new, start, part

         call gsf_file(bytes, old, new)
         call refused(bytes, start, part, no_hints)
      end subroutine check
   end subroutine test_gsf_faults

end module test_height_map_binary
