!> Profiles, which are maps of one line: in text, SDF, SUR and X3P.
module test_height_map_profiles
   use, intrinsic :: iso_fortran_env, only: int16, int32, real32
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_read, only: map_hints
   use asperity_height_map_type, only: check_height_map, height_map
   use asperity_height_map_write, only: height_map_bytes
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: assert_map, has_text, nl, no_hints, read_text, refused, small_heights
   use x3p_cases, only: x3p_members
   use zip_writer, only: zip_member_text, zip_of
   implicit none
   private
   public :: suite_map_profiles

   real(wp), parameter :: heights(6) = [3.1_wp, 4.7_wp, 2.2_wp, 8.9_wp, 5.3_wp, 4.4_wp]
   character(len=*), parameter :: texts(6) = ['3.1', '4.7', '2.2', '8.9', '5.3', '4.4']
   character(len=*), parameter :: places(6) = ['0 ', '2 ', '4 ', '6 ', '8 ', '10']

contains

   function suite_map_profiles() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map profiles')
      call suite%addTest(TestMethod('columns of x and z', test_columns))
      call suite%addTest(TestMethod('heights alone', test_heights_alone))
      call suite%addTest(TestMethod('points of one line', test_one_line))
      call suite%addTest(TestMethod('texts that are refused', test_refused))
      call suite%addTest(TestMethod('SDF', test_sdf))
      call suite%addTest(TestMethod('SUR', test_sur))
      call suite%addTest(TestMethod('X3P', test_x3p))
   end function suite_map_profiles

   !> Lines of x = 0, 2, 4 ... um and z, between separators.
   function lines_of(before, between, behind) result(text)
      character(len=*), intent(in) :: before, between, behind
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(texts)
         text = text//before//trim(places(i))//between//texts(i)//behind//nl
      end do
   end function lines_of

   !> Heights in um are 1e-3 of them in mm, steps 0.002 mm.
   subroutine check_profile(text, hints, expected)
      character(len=*), intent(in) :: text
      type(map_hints), intent(in) :: hints
      real(wp), intent(in) :: expected(:)
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp) :: scaled(size(expected))
      integer :: k

      scaled = 1.0e-3_wp*expected
      where (expected > 8.99_wp) scaled = 9.0_wp
      do k = 1, 3
         call read_text(text, hints, map, 10**k)
         call assert_map(map, size(expected), scaled, 1.0e-17_wp)
         call assertEqual(0.002_wp, map%step_x, 1.0e-17_wp)
         call assertEqual(0.002_wp, map%step_y, 1.0e-17_wp)
         call assertEqual('text of a profile', map%format)
         call check_height_map(map, error)
         call assertTrue(allocated(error), 'a profile is no map')
      end do
   end subroutine check_profile

   subroutine test_columns()
      type(map_hints), parameter :: both = map_hints('um', 'um'), um = map_hints('', 'um')

      call check_profile(lines_of('', ' ', ''), both, heights)
      call check_profile(lines_of(' ', achar(9), ' '), both, heights)
      call check_profile('x [um],z [um]'//nl//lines_of('', ',', ''), no_hints, heights)
      call check_profile('z (um);x (um)'//nl//'3.1;0'//nl//'4.7;2'//nl//'2.2;4'//nl//'8.9;6'//nl// &
         '5.3;8'//nl//'4.4;10'//nl, no_hints, heights)
      ! no axis is named: their order; y is the height where nothing else is
      call check_profile('Position [um];Height [um]'//nl//lines_of('', ';', ''), no_hints, heights)
      call check_profile('Distance (um);Level (um)'//nl//lines_of('', ';', ''), no_hints, heights)
      call check_profile('x [um],y [um]'//nl//lines_of('', ',', ''), no_hints, heights)
      call check_profile('Lateral(um)'//achar(9)//'Profile(um)'//nl//lines_of('', achar(9), ''), &
         no_hints, heights)
      call check_profile('# lateral unit: um'//nl//lines_of('', ' ', ''), um, heights)
      ! another column, and rows in another order
      call check_profile('x [um];z [um];valid'//nl//lines_of('', ';', ';1'), no_hints, heights)
      call check_profile('4 2.2'//nl//'0 3.1'//nl//'10 4.4'//nl//'2 4.7'//nl//'8 5.3'//nl// &
         '6 8.9'//nl, both, heights)
      ! missing points: no line, NaN, empty
      call check_profile('0,3.1'//nl//'2,nan'//nl//'4,2.2'//nl//'6,'//nl//'10,4.4'//nl, both, &
         [3.1_wp, 9.0_wp, 2.2_wp, 9.0_wp, 9.0_wp, 4.4_wp])
   end subroutine test_columns

   subroutine test_heights_alone()
      type(map_hints), parameter :: step = map_hints('', 'um', 0.002_wp, 0.002_wp)
      character(len=:), allocatable :: column
      type(height_map) :: map
      integer :: i

      column = ''
      do i = 1, size(texts)
         column = column//texts(i)//nl
      end do
      call check_profile(column, step, heights)
      call check_profile('# step: 2 um'//nl//'# height unit: um'//nl//column, no_hints, heights)
      ! their number before them, as some instruments write it
      call check_profile('6'//nl//column, step, heights)
      call read_text('6'//nl//column, step, map)
      call assertTrue(has_text(map%notes, 'the first number is that of the heights'), map%notes)
      ! another number is a height
      call check_profile('5'//nl//column, step, [5.0_wp, heights])
      call refused(column, 'file: ', 'say it with --step', map_hints(height_unit='um'))
      call refused(column, 'file: ', 'in which unit its heights are', no_hints)
   end subroutine test_heights_alone

   !> x y z with one y is a profile; more lines are a map, or profiles of a map.
   subroutine test_one_line()
      type(map_hints), parameter :: both = map_hints('um', 'um')
      type(height_map) :: map
      character(len=:), allocatable :: line
      integer :: i

      line = ''
      do i = 1, size(texts)
         line = line//trim(places(i))//' 7.5 '//texts(i)//nl
      end do
      call read_text(line, both, map)
      call assert_map(map, 6, 1.0e-3_wp*heights, 1.0e-17_wp)
      ! three parallel traces as a matrix
      call read_text(repeat('3.1 4.7 2.2 8.9 5.3 4.4'//nl, 3), &
         map_hints('', 'mm', 0.002_wp, 0.5_wp), map)
      call assert_map(map, 6, [heights, heights, heights], 1.0e-15_wp)
      call assertEqual(0.5_wp, map%step_y, 0.0_wp)
   end subroutine test_one_line

   subroutine test_refused()
      call refused('1 2'//nl, 'file: ', '1 points in a line are no profile')
      call refused('1 2'//nl//'2 3'//nl//'3 2'//nl//'4 4'//nl, 'file: ', &
         '4 points in a line are no profile: at least 5')
      call refused('0 1'//nl//'1 2'//nl//'2 3'//nl//'3.4 2'//nl//'4 4'//nl//'5 3'//nl, 'file: ', &
         'on no regular grid in x')
      call refused('0 1'//nl//'1 2'//nl//'1 3'//nl//'2 2'//nl//'3 4'//nl//'4 4'//nl, 'file: ', &
         'two points at x = 1.0')
      call refused(repeat('1.5 2.5'//nl, 9), 'file: ', 'are no profile')
      call refused(lines_of('', ' ', '')//'12 x'//nl, 'file:7:4: ', '''x'' is no number')
      call refused(lines_of('', ' ', '')//'12 1 3'//nl, 'file:7:', 'fields that the first one has')
      call refused(lines_of('', ' ', '')//'nan 1'//nl, 'file:7:1: ', 'a coordinate is missing')
      call refused('x [um],z [V]'//nl//lines_of('', ',', ''), 'file:1:', &
         'unknown as one of heights')
      call refused('24 18'//nl//repeat('1 2 3 4 5'//nl, 9), 'file:2:1: ', &
         'of no format that is known', no_hints)
      call refused('0 nan'//nl//'1 nan'//nl//'2 nan'//nl//'3 nan'//nl//'4 nan'//nl, 'file: ', &
         'every point is missing')
   end subroutine test_refused

   !> Binary and text; the distance of lines may be 0.
   subroutine test_sdf()
      type(height_map) :: map, back
      character(len=:), allocatable :: bytes
      type(error_type), allocatable :: error
      real(wp), parameter :: zero = 0.0_wp

      allocate (map%heights(6, 5))
      map%heights = 1.0e-3_wp*reshape(small_heights, [6, 5])
      map%step_x = 0.002_wp
      map%step_y = 0.003_wp
      map%source = 'made'
      call height_map_bytes(map, 'sdf', bytes, error)
      bytes = bytes(:44)//achar(1)//achar(0)//bytes(47:81 + 6*8)
      call read_text(bytes, no_hints, back)
      call assert_map(back, 6, map%heights(:, 1), 1.0e-17_wp)
      call assertEqual(0.002_wp, back%step_y, 1.0e-17_wp)
      call read_text(bytes(:54)//transfer(zero, '12345678')//bytes(63:), no_hints, back)
      call assert_map(back, 6, map%heights(:, 1), 1.0e-17_wp)
      call read_text('aBCR-1.0'//nl//'NumPoints = 6'//nl//'NumProfiles = 1'//nl// &
         'Xscale = 2e-6'//nl//'Yscale = 0'//nl//'Zscale = 1e-6'//nl//'Zresolution = -1'//nl// &
         'Compression = 0'//nl//'DataType = 7'//nl//'CheckType = 0'//nl//'*'//nl// &
         '3.1 4.7 2.2 8.9 5.3 4.4'//nl//'*'//nl, no_hints, back)
      call assert_map(back, 6, 1.0e-3_wp*heights, 1.0e-17_wp)
   end subroutine test_sdf

   !> Kind 1 is a profile; nothing is said of y.
   subroutine test_sur()
      type(height_map) :: map
      character(len=512) :: head
      integer :: i

      head = repeat(achar(0), len(head))
      head(:12) = 'DIGITAL SURF'
      head(15:15) = achar(1)
      head(19:19) = achar(1)
      head(99:99) = achar(16)
      head(109:120) = transfer([6_int32, 1_int32, 6_int32], repeat('1234', 3))
      head(121:132) = transfer([2.0_real32, 0.0_real32, 0.5_real32], repeat('1234', 3))
      head(181:182) = 'um'
      head(213:214) = 'um'
      call read_text(head//transfer([(int(i, int16), i=1, 6)], repeat('12', 6)), no_hints, map)
      call assert_map(map, 6, [(0.5e-3_wp*i, i=1, 6)], 1.0e-17_wp)
      call assertEqual(0.002_wp, map%step_x, 1.0e-17_wp)
      call assertEqual(0.002_wp, map%step_y, 1.0e-17_wp)
   end subroutine test_sur

   !> FeatureType PRF; the axis of y does not count.
   subroutine test_x3p()
      type(zip_member_text) :: members(3)
      type(height_map) :: map, line
      character(len=:), allocatable :: archive, text
      integer :: at

      call x3p_members(members, 3)
      call zip_of(members, archive)
      call read_text(archive, no_hints, map)
      text = members(1)%bytes
      call replace('SUR<', 'PRF<')
      call replace('<SizeX>6</SizeX><SizeY>5', '<SizeX>30</SizeX><SizeY>1')
      call replace('<CY><AxisType>I</AxisType><Increment>2e-6', &
         '<CY><AxisType>A</AxisType><Increment>0')
      members(1)%bytes = text
      call zip_of(members, archive)
      call read_text(archive, no_hints, line)
      call assertEqual([30, 1], shape(line%heights))
      if (size(line%heights) /= 30) return
      call assertTrue(all(abs(reshape(line%heights, [6, 5]) - map%heights) <= 0.0_wp), 'heights')
      call assertEqual(map%step_x, line%step_y, 0.0_wp)

   contains

      subroutine replace(old, new)
         character(len=*), intent(in) :: old, new

         at = index(text, old)
         text = text(:at - 1)//new//text(at + len(old):)
      end subroutine replace

   end subroutine test_x3p

end module test_height_map_profiles
