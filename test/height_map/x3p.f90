!> X3P archives made here: sound ones of every type of number, and those that must be refused.
module test_height_map_x3p
   use, intrinsic :: iso_fortran_env, only: int16, int32, real32
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_read, only: map_hints
   use asperity_height_map_type, only: height_map
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: assert_same, read_text, refused
   use x3p_cases, only: x3p_members
   use zip_writer, only: zip_member_text, zip_of
   implicit none
   private
   public :: suite_map_x3p

   type(map_hints), parameter :: no_hints = map_hints()

contains

   function suite_map_x3p() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map x3p')
      call suite%addTest(TestMethod('types of numbers', test_types))
      call suite%addTest(TestMethod('heights in main.xml', test_list))
      call suite%addTest(TestMethod('all of it in a folder', test_folder))
      call suite%addTest(TestMethod('validity', test_validity))
      call suite%addTest(TestMethod('archives that are refused', test_archives))
      call suite%addTest(TestMethod('archives that promise something else', test_promises))
      call suite%addTest(TestMethod('descriptions that are refused', test_descriptions))
      call suite%addTest(TestMethod('document types and entities', test_entities))
      call suite%addTest(TestMethod('bombs', test_bombs))
   end function suite_map_x3p

   !> 6 x 5 points k = 1, 2, ... times 1e-7 m and 0.5 m, steps 1 and 2 um; the 9th is missing, and
   !> the 24th.
   subroutine test_types()
      type(zip_member_text) :: members(3)
      type(height_map) :: map
      character(len=:), allocatable :: archive
      integer :: i, k

      do i = 0, 3
         call x3p_members(members, i)
         select case (i)
         case (0)
            members(2)%bytes = transfer([(int(k, int16), k=1, 30)], repeat(' ', 60))
         case (1)
            members(2)%bytes = transfer([(int(k, int32), k=1, 30)], repeat(' ', 120))
         case (2)
            members(2)%bytes = transfer([(real(k, real32), k=1, 30)], repeat(' ', 120))
         case default
            members(2)%bytes = transfer([(real(k, wp), k=1, 30)], repeat(' ', 240))
         end select
         call zip_of(members, archive)
         call read_text(archive, no_hints, map)
         call assertEqual([6, 5], shape(map%heights))
         if (size(map%heights) /= 30) return
         call assertEqual([0.001_wp, 0.002_wp], [map%step_x, map%step_y], 1.0e-18_wp)
         call assertTrue(map%heights(3, 2) >= none .and. map%heights(6, 4) >= &
            none, 'not valid')
         call assertEqual(2, count(map%heights >= none))
         call assertEqual(500.0_wp + 1.0e-4_wp, map%heights(1, 1), 1.0e-12_wp)
         call assertEqual(500.0_wp + 30.0e-4_wp, map%heights(6, 5), 1.0e-12_wp)
      end do
      ! a floating-point height that is none
      members(2)%bytes(9:16) = repeat(char(255), 8)
      call zip_of(members, archive)
      call read_text(archive, no_hints, map)
      call assertEqual(3, count(map%heights >= none))
      call assertTrue(map%heights(2, 1) >= none, 'NaN')
   end subroutine test_types

   subroutine test_list()
      type(zip_member_text) :: members(3)
      type(height_map) :: map
      character(len=:), allocatable :: archive

      call x3p_members(members, 4)
      call zip_of(members, archive)
      call read_text(archive, no_hints, map)
      call assertEqual([6, 5], shape(map%heights))
      if (size(map%heights) /= 30) return
      call assertEqual(500.0_wp - 0.3e-4_wp, map%heights(2, 1), 1.0e-12_wp)
      call assertEqual(500.0_wp + 1.5e-4_wp, map%heights(1, 1), 1.0e-12_wp)
      call change(members, '<Datum>-3e-1</Datum>', '')
      call refuse(members, 'file: main.xml: 29 heights', 'promises 6 x 5')
      call x3p_members(members, 4)
      call change(members, '-3e-1', '-3,1')
      call refuse(members, 'file: main.xml:', 'must be a number with a decimal point, or NaN')
   end subroutine test_list

   !> The map of the archive without the folder; other members of the same folder do not matter.
   subroutine test_folder()
      type(zip_member_text) :: members(3), outside(4)
      type(height_map) :: map, within
      character(len=:), allocatable :: archive
      integer :: i

      call x3p_members(members, 1)
      call zip_of(members, archive)
      call read_text(archive, no_hints, map)
      do i = 1, 3
         members(i)%name = 'scans/oak 1/'//members(i)%name
      end do
      call zip_of(members, archive)
      call read_text(archive, no_hints, within)
      call assert_same(map, within, 'folder')
      ! another main.xml within a name is none, one in a second folder is
      outside(1)%name = '__MACOSX/scans/._main.xml'
      outside(1)%bytes = 'x'
      outside(2:) = members
      call zip_of(outside, archive)
      call read_text(archive, no_hints, within)
      call assert_same(map, within, 'beside others')
      outside(1)%name = 'scans/oak 2/main.xml'
      call refuse(outside, 'file: has main.xml in several folders', 'pack each into a file')
      ! links begin in the folder
      members(2)%name = 'bindata/data.bin'
      call refuse(members, 'file: the archive has no member scans/oak 1/bindata/data.bin', &
         'incomplete')
   end subroutine test_folder

   subroutine test_validity()
      type(zip_member_text) :: members(3)

      call x3p_members(members, 0)
      members(3)%bytes = members(3)%bytes(:3)
      call refuse(members, 'file: bindata/valid.bin: 3 bytes', 'there must be 4')
      members(3)%bytes = repeat(achar(0), 4)
      call refuse(members, 'file: ', 'every point is missing')
      members(3)%name = 'bindata/other.bin'
      call refuse(members, 'file: the archive has no member bindata/valid.bin', 'incomplete')
   end subroutine test_validity

   !> Replace the first such text in main.xml.
   subroutine change(members, old, new)
      type(zip_member_text), intent(inout) :: members(3)
      character(len=*), intent(in) :: old, new
      integer :: at

      at = index(members(1)%bytes, old)
      call assertTrue(at > 0, old)
      if (at == 0) return
      members(1)%bytes = members(1)%bytes(:at - 1)//new//members(1)%bytes(at + len(old):)
   end subroutine change

   subroutine refuse(members, start, part)
      type(zip_member_text), intent(in) :: members(:)
      character(len=*), intent(in) :: start, part
      character(len=:), allocatable :: archive

      call zip_of(members, archive)
      call refused(archive, start, part, no_hints)
   end subroutine refuse

   subroutine test_archives()
      type(zip_member_text) :: members(3)
      character(len=:), allocatable :: archive
      integer :: at

      call x3p_members(members, 1)
      call zip_of(members, archive)
      call refused(archive(:4), 'file: begins as a zip archive', 'no sound one', no_hints)
      call refused(archive(:len(archive) - 30), 'file: begins as a zip archive', 'cut off', &
         no_hints)
      at = index(archive, members(2)%bytes)
      archive(at:at) = char(ieor(ichar(archive(at:at)), 16))
      call refused(archive, 'file: bindata/data.bin: byte ', 'damaged', no_hints)
      members(1)%name = 'other.xml'
      call refuse(members, 'file: is a zip archive with ', 'neither X3P nor PLUX')
      members(1)%name = 'main.xml'
      members(2)%bytes = members(2)%bytes(:119)
      call refuse(members, 'file: byte 0: ', '6 x 5 points, the file has room for 29')
      members(2)%bytes = repeat(members(2)%bytes, 2)
      call refuse(members, 'file: bindata/data.bin: 238 bytes', 'promises 6 x 5 points of 4 bytes')
      members(2)%name = 'data.bin'
      call refuse(members, 'file: the archive has no member bindata/data.bin', 'incomplete')
   end subroutine test_archives

   !> An archive whose list promises more or fewer bytes than there are.
   subroutine test_promises()
      call check(5, 100)
      call check(7, 140)
   contains
      subroutine check(columns, bytes)
         integer, intent(in) :: columns, bytes
         type(zip_member_text) :: members(3)
         character(len=:), allocatable :: archive
         integer :: at

         call x3p_members(members, 1)
         call change(members, '<SizeX>6', '<SizeX>'//achar(iachar('0') + columns))
         call zip_of(members, archive)
         at = index(archive, 'PK'//achar(1)//achar(2))
         at = at + 3 + index(archive(at + 4:), 'PK'//achar(1)//achar(2))
         archive(at + 24:at + 27) = transfer(bytes, '1234')
         call refused(archive, 'file: bindata/data.bin: byte ', 'get the file once more', no_hints)
      end subroutine check
   end subroutine test_promises

   subroutine test_descriptions()
      call check('SUR<', 'PRF<', 'file: main.xml: FeatureType is ''PRF''', 'profiles of one line')
      call check('SUR<', 'PCL<', 'file: main.xml: FeatureType is ''PCL''', 'no clouds of points')
      call check('<AxisType>I', '<AxisType>A', 'file: main.xml: the axes CX and CY', 'incremental')
      call check('<AxisType>A', '<AxisType>B', 'file: main.xml: AxisType of CZ', 'A or I')
      call check('<DataType>L', '<DataType>X', 'file: main.xml: DataType of CZ', 'I, L, F or D')
      call check('<SizeZ>1', '<SizeZ>2', 'file: main.xml: SizeZ is 2', 'one layer')
      call check('<SizeX>6', '<SizeX>0', 'file: main.xml:', 'whole number above 0')
      call check('<SizeX>6', '<SizeX>six', 'file: main.xml:', 'must be a number')
      call check('<SizeX>6', '<SizeX>1000000', 'file: byte 0: ', '1000000 x 5 points')
      call check('<SizeX>6</SizeX><SizeY>5', '<SizeX>1000000</SizeX><SizeY>1000000', &
         'file: byte 0: ', '1000000 x 1000000 points: at most')
      call check('<SizeX>6</SizeX><SizeY>5', '<SizeX>1</SizeX><SizeY>30', 'file: ', &
         '1 x 30 points are no map')
      call check('1e-6<', '0<', 'file: main.xml: Increment of CX', 'above 0 and finite')
      call check('2e-6<', '-2e-6<', 'file: main.xml: Increment of CY', 'above 0 and finite')
      call check('2e-6<', '2,5e-6<', 'file: main.xml:', 'decimal point')
      call check('1e-7<', '1e7<', 'file: bindata/data.bin: byte ', 'beyond 1 km')
      call check('0.5<', '1e300<', 'file: main.xml: Offset of CZ', 'at most 1 km')
      call check('</Record3>', '', 'file: main.xml:', 'no sound XML')
      call check('</p:ISO5436_2>', '', 'file: main.xml:', 'no sound XML')

   contains

      subroutine check(old, new, start, part)
         character(len=*), intent(in) :: old, new, start, part
         type(zip_member_text) :: members(3)

         call x3p_members(members, 1)
         call change(members, old, new)
         call refuse(members, start, part)
      end subroutine check

   end subroutine test_descriptions

   !> Entities that would grow to 10^9 letters, or read a file of the machine.
   subroutine test_entities()
      type(zip_member_text) :: members(3)
      character(len=:), allocatable :: text
      character(len=1) :: name
      integer :: i

      call x3p_members(members, 1)
      text = '<!DOCTYPE x [<!ENTITY a "ha">'
      do i = 1, 9
         name = achar(iachar('a') + i)
         text = text//'<!ENTITY '//name//' "'//repeat('&'//achar(iachar(name) - 1)//';', 10)//'">'
      end do
      call change(members, '<p:ISO', text//']><p:ISO')
      ! even where nothing grows, a document type is refused
      call refuse(members, 'file: main.xml:', 'document type or entities')
      call change(members, 'ISO5436 - 2000', '&j;')
      call refuse(members, 'file: main.xml:', 'XML')
      call x3p_members(members, 1)
      call change(members, '<p:ISO', &
         '<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/hostname">]><p:ISO')
      call change(members, 'ISO5436 - 2000', '&a;')
      call refuse(members, 'file: main.xml:', 'document type or entities')
      call x3p_members(members, 1)
      call change(members, 'ISO5436 - 2000', '&a;')
      call refuse(members, 'file: main.xml:', 'no sound XML')
      call x3p_members(members, 1)
      call change(members, 'ISO5436 - 2000', repeat('<a>', 100)//repeat('</a>', 100))
      call refuse(members, 'file: main.xml:', 'more than 16 others')
   end subroutine test_entities

   !> Sizes that the archive cannot hold.
   subroutine test_bombs()
      type(zip_member_text) :: members(3)
      character(len=:), allocatable :: archive
      integer :: at

      call x3p_members(members, 1)
      call zip_of(members, archive)
      ! the sizes of main.xml in the list at the end: 1 GB unpacked
      at = index(archive, 'PK'//achar(1)//achar(2))
      archive(at + 24:at + 27) = transfer(10**9, '1234')
      call refused(archive, 'file: main.xml: 1000000000 bytes are packed', 'it is not unpacked', &
         no_hints)
      ! 20000 x 20000 points of 4 bytes in 120
      call change(members, '<SizeX>6</SizeX><SizeY>5', '<SizeX>20000</SizeX><SizeY>20000')
      call zip_of(members, archive)
      at = index(archive, 'PK'//achar(1)//achar(2))
      at = at + 3 + index(archive(at + 4:), 'PK'//achar(1)//achar(2))
      archive(at + 24:at + 27) = transfer(1600000000, '1234')
      call refused(archive, 'file: byte 0: ', '20000 x 20000 points', no_hints)
   end subroutine test_bombs

end module test_height_map_x3p
