!> Files of heights that must be refused, with the place of the fault.
module test_height_map_faults
   use, intrinsic :: iso_fortran_env, only: int16, int32, real32
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_read, only: map_hints, read_height_map
   use asperity_height_map_type, only: height_map
   use asperity_height_map_write, only: height_map_bytes
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: formula_map, has_text, in_mm, nl, read_text, refused
   implicit none
   private
   public :: suite_map_faults

   !> Bytes of SDF's header
   integer, parameter :: sdf_header = 81
   type(map_hints), parameter :: no_hints = map_hints()
   !> As a double
   character(len=8), parameter :: infinity = repeat(achar(0), 6)//char(240)//char(127)

contains

   function suite_map_faults() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map faults')
      call suite%addTest(TestMethod('no format at all', test_unknown))
      call suite%addTest(TestMethod('no file', test_no_file))
      call suite%addTest(TestMethod('SDF, binary', test_sdf))
      call suite%addTest(TestMethod('SDF, numbers of the header', test_sdf_numbers))
      call suite%addTest(TestMethod('SDF, text', test_sdf_text))
      call suite%addTest(TestMethod('SUR', test_sur))
      call suite%addTest(TestMethod('matrix', test_matrix))
      call suite%addTest(TestMethod('headers of a matrix', test_headers))
      call suite%addTest(TestMethod('decimal commas', test_commas))
      call suite%addTest(TestMethod('points', test_points))
      call suite%addTest(TestMethod('points on no grid', test_no_grid))
      call suite%addTest(TestMethod('limits of steps and heights', test_limits))
      call suite%addTest(TestMethod('units', test_units))
   end function suite_map_faults

   subroutine test_unknown()
      call refused('', 'file: ', 'is empty')
      call refused(nl//nl//' '//nl, 'file: ', 'has no line of numbers')
      call refused('Dear reader'//nl//'this is a letter', 'file: ', 'has no line of numbers')
      call refused(char(137)//'XYZ'//achar(13)//achar(10)//achar(26)//achar(0), 'file: ', &
         'is in no format that is known')
      call refused(char(255)//char(254)//'1'//achar(0), 'file: ', 'UTF-16')
      call refused('aISO-3.0'//nl, 'file: ', 'an SDF file of an unknown version')
      call refused(repeat('no numbers here'//nl, 1100), 'file:1001:', &
         'no line of numbers among the first 1000')
   end subroutine test_unknown

   subroutine test_no_file()
      call unreadable('test/data', 'test/data: is a folder')
      call unreadable('test/data/', 'is a folder')
      call unreadable('test/data/no_such_map.sdf', 'test/data/no_such_map.sdf: cannot be opened')

   contains

      subroutine unreadable(path, message)
         character(len=*), intent(in) :: path, message
         type(height_map) :: map
         type(error_type), allocatable :: error

         call read_height_map(path, no_hints, map, error)
         call assertTrue(allocated(error), path)
         if (.not. allocated(error)) return
         call assertTrue(has_text(error%message, message), error%message)
      end subroutine unreadable

   end subroutine test_no_file

   !> A sound file of 7 x 6 points.
   subroutine sdf_file(bytes)
      character(len=:), allocatable, intent(out) :: bytes
      type(height_map) :: map
      type(error_type), allocatable :: error

      call formula_map(map, 7, 6)
      where (map%heights >= none) map%heights = 0.5_wp
      call height_map_bytes(map, 'sdf', bytes, error)
      call assertEqual(sdf_header + 8*42, len(bytes))
   end subroutine sdf_file

   subroutine test_sdf()
      character(len=:), allocatable :: bytes
      character(len=2), parameter :: rows(2) = [achar(1)//achar(0), achar(4)//achar(0)]
      integer :: i

      call sdf_file(bytes)
      call refused(bytes(:8), 'file: byte 8: ', 'ends within its header', no_hints)
      call refused(bytes(:80), 'file: byte 80: ', 'ends within its header', no_hints)
      call refused(bytes(:81), 'file: byte 42: ', &
         'promises 7 x 6 points, the file has room for 0', &
         no_hints)
      call refused(bytes(:len(bytes) - 1), 'file: byte 42: ', 'has room for 41', no_hints)
      call refused(bytes//bytes(100:140), 'file: byte 417: ', 'follow the points', no_hints)
      call refused(bytes//'comment', 'file: ', 'contradicts', map_hints(height_unit='um'))
      call refused(bytes, 'file: ', '--step 0.1 mm contradicts', map_hints(step_x=0.1_wp))
      ! fewer rows than are there
      do i = 1, 2
         call refused(bytes(:44)//rows(i)//bytes(47:), 'file: byte ', 'follow the points', no_hints)
      end do
      ! shorter lines than a map and a profile need
      call refused(bytes(:42)//achar(4)//bytes(44:81 + 8*24), 'file: ', &
         '4 x 6 points are no map: at least 5', no_hints)
      call refused(bytes(:42)//achar(4)//bytes(44:44)//achar(1)//bytes(46:81 + 8*4), 'file: ', &
         '4 points in a line are no profile: at least 5', no_hints)
      call refused(bytes(:97)//infinity//bytes(106:), 'file: byte 97: ', &
         'must be a finite number', no_hints)
      call refused(bytes(:97)//transfer(1.0e12_wp, '12345678')//bytes(106:), 'file: byte 97: ', &
         'beyond 1 km', no_hints)
      call refused(bytes(:81)//repeat(transfer(-huge(1.0_wp), '12345678'), 42), 'file: ', &
         'every point is missing', no_hints)
   end subroutine test_sdf

   !> Numbers of the header of 7 x 6 points replaced.
   subroutine test_sdf_numbers()
      character(len=:), allocatable :: bytes
      character(len=8), parameter :: version = 'bISO-2.0'
      integer, parameter :: million(2) = 1000000
      real(wp), parameter :: wrong(4) = [0.0_wp, -1.0e-6_wp, 1.0e300_wp, 1.0e-300_wp]
      integer :: i

      call sdf_file(bytes)
      call refused(bytes(:42)//repeat(achar(0), 4)//bytes(47:), 'file: byte 42: ', &
         'promises 0 x 0 points', no_hints)
      call refused(bytes(:42)//repeat(char(255), 4)//bytes(47:), 'file: byte 42: ', &
         'promises 65535 x 65535 points', no_hints)
      call refused(version//bytes(9:42)//transfer(million, '12345678')//bytes(47:), &
         'file: byte 42: ', 'promises 1000000 x 1000000 points: at most', no_hints)
      call refused(version//bytes(9:42)//repeat(char(255), 8)//bytes(47:), &
         'file: byte 42: ', 'promises 4294967295 x 4294967295 points', no_hints)
      do i = 1, size(wrong)
         call refused(bytes(:46)//transfer(wrong(i), '12345678')//bytes(55:), 'file: ', &
            'not allowed', no_hints)
         call refused(bytes(:54)//transfer(wrong(i), '12345678')//bytes(63:), 'file: ', &
            'not allowed', no_hints)
         call refused(bytes(:62)//transfer(wrong(i), '12345678')//bytes(71:), 'file: Zscale', &
            'it must be above 0 and finite', no_hints)
      end do
      do i = 46, 62, 8
         call refused(bytes(:i)//repeat(char(255), 8)//bytes(i + 9:), 'file: ', 'not allowed', &
            no_hints)
      end do
      call refused(bytes(:78)//achar(1)//bytes(80:), 'file: ', 'compression 1', no_hints)
      call refused(bytes(:79)//achar(8)//bytes(81:), 'file: ', 'data type 8 is unknown', no_hints)
      call refused(bytes(:80)//achar(1)//bytes(82:), 'file: ', 'check 1', no_hints)
   end subroutine test_sdf_numbers

   subroutine test_sdf_text()
      character(len=*), parameter :: sizes = &
         'aISO-1.0'//nl//'NumPoints = 5'//nl//'NumProfiles = 5'//nl
      character(len=*), parameter :: head = sizes//'Xscale = 1e-6'//nl//'Yscale = 1e-6'//nl// &
         'Zscale = 1e-9'//nl//'DataType = 7'//nl
      character(len=*), parameter :: row = '1 2 3 4 BAD'//nl

      call refused(sizes, 'file:', 'ends within its header', no_hints)
      call refused(sizes//'*'//nl//repeat(row, 5), 'file: ', 'does not say Xscale: add it', &
         no_hints)
      call refused(head//'*'//nl//repeat(row, 3), 'file: byte ', 'room for', no_hints)
      call refused(head//'*'//nl//repeat(row, &
         4)//'1 2 3 4'//nl//'*'//nl//'Name = a longer trailer', &
         'file:14:1: ', 'the numbers end after 24', no_hints)
      call refused(head//'*'//nl//repeat(row, 5)//'6'//nl//'*'//nl, 'file:14:1: ', 'more numbers', &
         no_hints)
      call refused(head//'*'//nl//repeat(row, 2)//'1 2 x 4 5'//nl//repeat(row, 2), 'file:11:5: ', &
         '''x'' is no number', no_hints)
      call refused(head//'*'//nl//repeat(row, 2)//'1 2 1,5 4 5'//nl//repeat(row, 2), &
         'file:11:5: ', &
         'decimal comma', no_hints)
      call refused(head//'*'//nl//repeat(row, 2)//'1 2 3 4 -inf'//nl//repeat(row, 2), &
         'file:11:9: ', &
         'finite', no_hints)
      call refused(head//'*'//nl//repeat(row, 2)//'1 2 3 4 1e20'//nl//repeat(row, 2), &
         'file:11:9: ', 'height 1.0E20 is not allowed: in units of 1.00000E-6 mm', no_hints)
      call refused(head//'*'//nl//repeat('BAD '//nl, 25), 'file: ', 'every point is missing', &
         no_hints)
      call refused(sizes//'Xscale = 1,5'//nl, 'file:4:10: ', 'Xscale', no_hints)
      call refused(sizes//'NumPoints = 5'//nl, 'file:4:1: ', 'NumPoints is there twice', no_hints)
      call refused(sizes//'Xscale 1e-6'//nl, 'file:4:1: ', 'lines such as', no_hints)
      call refused('aISO-1.0'//nl//'NumPoints = -5'//nl, 'file:2:13: ', 'NumPoints', no_hints)
      call refused('aISO-1.0'//nl//'NumPoints = 1e6'//nl//'NumProfiles = 1e6'//nl// &
         head(len(sizes) + 1:)//'*'//nl//row, 'file: byte 0: ', '1000000 x 1000000 points', &
         no_hints)
      call refused(head//'Compression = 1'//nl//'*'//nl//row, 'file: ', 'compression 1', no_hints)
   end subroutine test_sdf_text

   !> A SUR file with one header field replaced.
   subroutine sur_file(bytes, offset, field)
      character(len=:), allocatable, intent(out) :: bytes
      integer, intent(in) :: offset
      character(len=*), intent(in) :: field
      character(len=512) :: head
      integer :: i

      head = repeat(achar(0), 512)
      head(:12) = 'DIGITAL SURF'
      head(15:15) = achar(1)
      head(19:19) = achar(2)
      head(99:99) = achar(16)
      head(109:120) = transfer([7_int32, 6_int32, 42_int32], repeat('1234', 3))
      head(121:132) = transfer([2.0_real32, 3.0_real32, 0.5_real32], repeat('1234', 3))
      do i = 181, 213, 16
         head(i:i + 1) = 'um'
      end do
      if (len(field) > 0) head(offset + 1:offset + len(field)) = field
      bytes = head//transfer([(int(i, int16), i=1, 42)], repeat('12', 42))
   end subroutine sur_file

   subroutine test_sur()
      character(len=:), allocatable :: bytes

      call sur_file(bytes, 0, '')
      call refused(bytes(:511), 'file: byte 511: ', 'ends within its header', no_hints)
      call refused(bytes(:595), 'file: byte 108: ', '7 x 6 points, the file has room for 41', &
         no_hints)
      call refused(bytes//bytes(513:596), 'file: byte 596: ', 'or more, follow them', no_hints)
      call refused(bytes, 'file: ', 'contradicts the file', map_hints(lateral_unit='mm'))
      call check(12, achar(1), 'file: byte 12: ', 'format 1')
      call check(18, achar(4), 'file: byte 18: ', 'kind 4')
      call check(98, achar(8), 'file: byte 98: ', '8 bits')
      call check(290, achar(1), 'file: byte 290: ', 'inverted')
      call check(108, transfer(8, '1234'), 'file: byte 108: ', '8 x 6 points, and 42 in all')
      call check(108, transfer([1000000, 1000000, -727379968], repeat('1234', 3)), &
         'file: byte 108: ', '1000000 x 1000000')
      call check(108, transfer([-7, -6, 42], repeat('1234', 3)), 'file: byte 108: ', '-7 x -6')
      call check(108, transfer([1, 42, 42], repeat('1234', 3)), 'file: ', &
         '1 x 42 points are no map')
      call check(120, repeat(achar(0), 4), 'file: byte 120: ', 'spacing 0.0 in x')
      call check(124, transfer(-1.0_real32, '1234'), 'file: byte 124: ', 'spacing -1.0 in y')
      call check(128, transfer(-1, '1234'), 'file: byte 128: ', 'in z')
      ! 500 m, 1 km, 1.5 km ...
      call check(128, transfer(5.0e8_real32, '1234'), 'file: byte 512: ', &
         'point 3 of line 1: height 3.0 is not allowed: in units of 500000.0 mm it is beyond 1 km')
      call check(180, '  ', 'file: ', 'does not say in which unit its lengths are')
      call check(180, 'fm', 'file: byte 180: ', 'the unit of x is fm, which is no length')
      call check(212, 'a.u.', 'file: byte 212: ', 'the unit of z is a.u., which is no length')
      call check(0, 'DSCOMPRESSED', 'file: byte 512: ', 'compressed streams')

   contains

      subroutine check(offset, field, start, part)
         integer, intent(in) :: offset
         character(len=*), intent(in) :: field, start, part

         call sur_file(bytes, offset, field)
         call refused(bytes, start, part, no_hints)
      end subroutine check

   end subroutine test_sur

   subroutine test_matrix()
      character(len=*), parameter :: row = '1 2 3 4 5'//nl
      type(map_hints) :: hints

      hints = in_mm
      hints%step_x = 0.1_wp
      hints%step_y = 0.1_wp
      call check(row//row//'1 2 3 4'//nl//row//row, 'file:3:1: ', &
         'row of 4 fields, the first one has 5')
      call check(row//row//'1 2 3 4 5 6'//nl//row//row, 'file:3:1: ', 'row of 6 fields')
      call check(row//row//row//row//'1 2 3 ', 'file:5:1: ', 'row of 3 fields')
      call check(row//row//'1 2 three 4 5'//nl//row//row, 'file:3:5: ', '''three'' is no number')
      call check('1 2 three 4 5'//nl//repeat(row, 4), 'file:1:5: ', '''three'' is no number')
      call check('one 2 3 4 5'//nl//repeat(row, 4), 'file:1:1: ', '''one'' is no number')
      call check(repeat(row, 4)//'1 2 3 4 5x'//nl, 'file:5:9: ', '''5x'' is no number')
      call check(repeat(row, 4)//'1 2 3 4 1.#QNA'//nl, 'file:5:9: ', 'is no number')
      call check(repeat(row, 80)//'1 2 3 4 '//achar(27)//'[2J'//nl, 'file:81:9: ', '''?[2J''')
      call check(repeat(row, 4)//'1 2 inf 4 5'//nl, 'file:5:5: ', 'finite')
      call check(repeat(row, 4)//'1 2 -Infinity 4 5'//nl, 'file:5:5: ', 'finite')
      call check(repeat(row, 4)//'1 2 1e309 4 5'//nl, 'file:5:5: ', 'above 1e308')
      call check(repeat(row, 4)//'1 2 1.70141e38 4 5'//nl, 'file:5:5: ', 'beyond 1 km')
      ! the first line and the first column may be axes: what is wrong there comes last
      call check('1 2 1e20 4 5'//nl//row//'1e20 2 3 4 5'//nl//row//row, 'file:1:5: ', 'beyond 1 km')
      call check('1 2 1e20 4 5'//nl//row//'1 2 1e20 4 5'//nl//row//row, 'file:3:5: ', 'beyond 1 km')
      call check(repeat('nan nan nan nan nan'//nl, 5), 'file: ', 'every point is missing')
      call check(repeat('1 2 3 4'//nl, 50), 'file: ', '4 x 50 points are no map')
      call check('7', 'file: ', '1 points in a line are no profile')

   contains

      subroutine check(text, start, part)
         character(len=*), intent(in) :: text, start, part

         call refused(text, start, part, hints)
      end subroutine check

   end subroutine test_matrix

   subroutine test_headers()
      character(len=*), parameter :: row = '1 2 3 4 5'//nl
      character(len=*), parameter :: head = 'cellsize 0.5'//nl

      call refused('ncols 1000000'//nl//'nrows 1000000'//nl//head//row, 'file: byte 0: ', &
         '1000000 x 1000000 points')
      call refused('ncols 5'//nl//'nrows 6'//nl//head//repeat(row, 5), 'file:8:', &
         'there are 5 rows, the header promises 6')
      call refused('ncols 5'//nl//'nrows 5'//nl//head//repeat(row, 6), 'file:9:', &
         'there are 6 rows, the header promises 5')
      call refused('ncols 6'//nl//'nrows 5'//nl//head//repeat(row, 5), 'file:8:', &
         'there are 5 columns, the header promises 6')
      call refused('ncols -5'//nl//'nrows 5'//nl//head//row, 'file:1:7: ', 'whole number above 0')
      call refused('ncols five'//nl//'nrows 5'//nl//head//row, 'file:1:7: ', 'whole number')
      call refused('ncols 5'//nl//'nrows 5'//nl//'cellsize 0'//nl//row, 'file:3:10: ', 'above 0')
      call refused('ncols 5'//nl//'nrows 5'//nl//'cellsize -1'//nl//row, 'file:3:10: ', 'above 0')
      call refused('# step_x: 1 furlong'//nl//row, 'file:1:11: ', 'unit of this line is unknown')
      call refused('# step_x: 1e-20 mm'//nl//repeat(row, 5), 'file: step', 'from 1e-9 to 1e6 mm')
      call refused('# height unit: K'//nl//row, 'file:1:16: ', &
         'the unit of this line, K, is unknown as one of heights')
      call refused('ncols 6'//nl//'nrows 5'//nl//head//repeat(row//row, 3), 'file:9:', &
         'there are 5 columns, the header promises 6')
      call refused('# nodata: x'//nl//row, 'file:1:11: ', 'marks missing points')
   end subroutine test_headers

   subroutine test_commas()
      character(len=*), parameter :: row = '1 2 3 4 5'//nl

      call refused(row//'1,5 2,5 3 4 5'//nl, 'file:2:1: ', 'decimal comma at ''1''', with_steps())
      call refused('1,5 2,5 3,5 4 5'//nl//row, 'file:1:1: ', 'decimal comma', with_steps())
      call refused('1;2,5;3;4;5'//nl, 'file:1:3: ', 'decimal comma', with_steps())
      call refused('1'//achar(9)//'-2,5'//achar(9)//'3'//nl, 'file:1:3: ', 'decimal comma')
      call refused('0,001,0,002,0,003'//nl, 'file:1:3: ', 'decimal comma', with_steps())
      call refused('1.5;2.5;3,5'//nl, 'file:1:9: ', 'decimal comma')
      call refused('# step_x: 1,5 mm'//nl//row, 'file:1:11: ', 'decimal point')

   contains

      type(map_hints) function with_steps()
         with_steps = in_mm
         with_steps%step_x = 0.1_wp
         with_steps%step_y = 0.1_wp
      end function with_steps

   end subroutine test_commas

   !> 5 x 5 points, the last line left out.
   subroutine points_file(text)
      character(len=:), allocatable, intent(out) :: text
      integer :: i

      text = ''
      do i = 0, 23
         text = text//achar(48 + mod(i, 5))//' '//achar(48 + i/5)//' 0.5'//nl
      end do
   end subroutine points_file

   subroutine test_points()
      character(len=:), allocatable :: text

      call points_file(text)
      call refused(text//'4 4'//nl, 'file:25:3: ', 'not the 3 fields')
      call refused(text//'4 4 5 6'//nl, 'file:25:7: ', 'not the 3 fields')
      call refused(text//'4 y 5'//nl, 'file:25:3: ', '''y'' is no number')
      call refused(text//'4 nan 5'//nl, 'file:25:3: ', 'a coordinate is missing')
      call refused(text//'4 4 inf'//nl, 'file:25:5: ', 'finite')
      call refused(text//'4 1e200 5'//nl, 'file:25:3: ', 'beyond 1e15')
      call refused(text//'4 4 1e20'//nl, 'file:25:5: ', 'beyond 1 km')
      call refused(text//'2 2 0.75'//nl, 'file: ', &
         'two points at x = 2.0, y = 2.0 with different heights, 0.5 and 0.75 mm')
      call refused(text(:30), 'file: ', '4 points in a line are no profile')
   end subroutine test_points

   subroutine test_no_grid()
      character(len=:), allocatable :: text
      character(len=40) :: line
      integer :: i, j

      call points_file(text)
      call refused(text//'4.3 4 1'//nl, 'file: ', 'on no regular grid in x')
      call refused(text//'4 4.3 1'//nl, 'file: ', 'on no regular grid in y')
      call refused('1 1 5'//nl//'1 2 5'//nl//'1 3 5'//nl, 'file: ', 'in x: all are the same')
      call refused('1 1 5'//nl//'2 1 5'//nl//'3 1 5'//nl, 'file: ', 'are no profile')
      ! along a diagonal
      text = ''
      do i = 1, 40
         write (line, '(2i4, a)') i, i, ' 1.5'
         text = text//trim(line)//nl
      end do
      call refused(text, 'file: ', '40 points on 40 x 40 lines')
      ! turned by a little
      text = ''
      do j = 1, 12
         do i = 1, 12
            write (line, '(2f12.6, a)') i + 0.01_wp*j, j - 0.01_wp*i, ' 1.5'
            text = text//trim(line)//nl
         end do
      end do
      call refused(text, 'file: ', 'on no regular grid')
   end subroutine test_no_grid

   subroutine test_units()
      character(len=*), parameter :: row = '1 2 3 4 5'//nl
      character(len=:), allocatable :: text

      call refused(repeat(row, 5), 'file: ', 'its heights are: say it with --height-unit', no_hints)
      call refused(repeat(row, 5), 'file: ', 'distance of its points in x: say it with --step')
      call refused('cellsize 1'//nl//repeat(row, 5), 'file: ', &
         'its lengths are: say it with --lateral-unit', map_hints(height_unit='um'))
      call refused('# height unit: um'//nl//repeat(row, 5), 'file: ', &
         '--height-unit mm contradicts the file, whose heights are in um')
      call refused('# step: 1 um'//nl//repeat(row, 5), 'file: ', '--lateral-unit mm contradicts')
      call refused(repeat(row, 5), '--height-unit ell', 'is no unit', map_hints(height_unit='ell'))
      call refused('# step: 1 mm'//nl//repeat(row, 5), 'file: --step 2.0 mm contradicts', &
         'step in x is 1.0 mm', map_hints('mm', 'mm', 2.0_wp, 2.0_wp))
      call refused(repeat(row, 5), 'step -2.0 mm', 'from 1e-9 to 1e6', &
         map_hints('mm', 'mm', -2.0_wp, -2.0_wp))
      call points_file(text)
      call refused(text, 'file: ', 'its heights are: say it with --height-unit', no_hints)
      call refused(text, 'file: ', 'its coordinates are: say it with --lateral-unit', &
         map_hints(height_unit='mm'))
      call refused('x [um] y [mm] z [um]'//nl//text, 'file:1:1: ', 'x is in um, y in mm', no_hints)
      call refused(text, 'file: ', '--step 3.0 mm contradicts', map_hints('mm', 'mm', 3.0_wp, &
         0.0_wp))
   end subroutine test_units

   !> Steps from 1e-9 to 1e6 mm, heights up to 1 km: at the limit, and the next number.
   subroutine test_limits()
      character(len=*), parameter :: row = '1 2 3 4 5'//nl, high = '1 2 3 4 1000000'
      type(height_map) :: map

      call step(1.0e-9_wp, -1.0_wp)
      call step(1.0e6_wp, 1.0_wp)
      call read_text(repeat(row, 4)//high//nl, map_hints('mm', 'mm', 1.0_wp, 1.0_wp), map)
      call assertEqual(1.0e6_wp, map%heights(5, 5), 0.0_wp, '1 km')
      call refused(repeat(row, 4)//high//'.0000000002'//nl, 'file:5:9: ', 'beyond 1 km', &
         map_hints('mm', 'mm', 1.0_wp, 1.0_wp))
   contains
      subroutine step(limit, side)
         real(wp), intent(in) :: limit, side
         real(wp) :: beyond

         call read_text(repeat(row, 5), map_hints('mm', 'mm', limit, limit), map)
         call assertEqual([limit, limit], [map%step_x, map%step_y], 0.0_wp, 'limit')
         beyond = nearest(limit, side)
         call refused(repeat(row, 5), 'step '//to_text(beyond)//' mm', 'from 1e-9 to 1e6', &
            map_hints('mm', 'mm', beyond, limit))
         call refused(repeat(row, 5), 'step '//to_text(beyond)//' mm', 'from 1e-9 to 1e6', &
            map_hints('mm', 'mm', limit, beyond))
      end subroutine step
   end subroutine test_limits

end module test_height_map_faults
