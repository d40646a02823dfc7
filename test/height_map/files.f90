!> Height maps out of sound files of every format.
module test_height_map_files
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_read, only: map_hints, read_height_map
   use asperity_height_map_type, only: height_map, missing_points
   use asperity_height_map_write, only: height_map_bytes
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use map_file_cases, only: assert_map, assert_same, formula_map, has_text, in_mm, nl, read_text
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_map_files

   character(len=*), parameter :: tab = achar(9)
   type(map_hints), parameter :: no_hints = map_hints()
   !> What `listen` heard
   real(wp) :: last_share = 0.0_wp
   integer :: calls = 0

contains

   function suite_map_files() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map files')
      call suite%addTest(TestMethod('files of other programs', test_others))
      call suite%addTest(TestMethod('written and read again', test_round_trip))
      call suite%addTest(TestMethod('any size of block', test_blocks))
      call suite%addTest(TestMethod('a file, with progress', test_file))
      call suite%addTest(TestMethod('matrix: separators and holes', test_matrix))
      call suite%addTest(TestMethod('matrix: headers', test_headers))
      call suite%addTest(TestMethod('matrix: ends of lines', test_line_ends))
      call suite%addTest(TestMethod('points in any order', test_order))
      call suite%addTest(TestMethod('points: separators and holes', test_points))
      call suite%addTest(TestMethod('points: rounded coordinates', test_rounded))
      call suite%addTest(TestMethod('units', test_units))
   end function suite_map_files

   !> z = i^2 - 3 j + i j/4 um, of sdfio's |z|, two points missing. Allowed are the rounding of
   !> the file's numbers: doubles and 32-bit integers far less than 1e-10 mm, singles 2^-24 of
   !> 0.043 mm, 16 bits of the range of 0.06 mm; SUR's scale is a single.
   subroutine test_others()
      real(wp), parameter :: exact = 1.0e-10_wp, single = 3.0e-9_wp, short = 1.0e-6_wp
      character(len=*), parameter :: folder = 'test/data/maps/'

      call check('surfalize.sdf', 'SDF binary', .false., exact)
      call check('surfalize_text.sdf', 'SDF text', .false., exact)
      call check('surfalize.x3p', 'X3P', .false., exact)
      call check('surfalize.sur', 'SUR', .false., single)
      call check('surfalize_packed.sur', 'SUR', .false., single)
      call check('surface_topography_D.x3p', 'X3P', .false., exact)
      call check('surface_topography_F.x3p', 'X3P', .false., single)
      call check('surface_topography_L.x3p', 'X3P', .false., exact)
      call check('surface_topography_I.x3p', 'X3P', .false., short)
      call check('sdfio_iso_1_0_ascii_binary64.sdf', 'SDF text', .true., exact)
      call check('sdfio_iso_2_0_ascii_binary32.sdf', 'SDF text', .true., single)
      call check('sdfio_iso_2_0_binary_int16.sdf', 'SDF binary', .true., short)
      call check('sdfio_bcr_1_0_binary_uint16.sdf', 'SDF binary', .true., short)
      call check('sdfio_bcr_1_0_ascii_int32.sdf', 'SDF text', .true., exact)

   contains

      subroutine check(name, form, is_absolute, tolerance)
         character(len=*), intent(in) :: name, form
         logical, intent(in) :: is_absolute
         real(wp), intent(in) :: tolerance
         type(height_map) :: map
         type(error_type), allocatable :: error
         real(wp) :: z(7, 6)
         integer :: i, j

         call read_height_map(folder//name, no_hints, map, error)
         call assertFalse(allocated(error), name)
         if (allocated(error)) then
            call assertEqual('', error%message)
            return
         end if
         do j = 0, 5
            do i = 0, 6
               z(i + 1, j + 1) = 1.0e-3_wp*(i*i - 3*j + 0.25_wp*i*j)
            end do
         end do
         if (is_absolute) z = abs(z)
         z(1, 1) = 9.0_wp
         z(4, 3) = 9.0_wp
         call assertTrue(index(map%format, form) == 1, name//': '//map%format)
         call assertEqual(folder//name, map%source)
         call assertEqual(0.002_wp, map%step_x, 1.0e-9_wp, name)
         call assertEqual(0.003_wp, map%step_y, 1.0e-9_wp, name)
         call assert_map(map, 7, reshape(z, [42]), tolerance)
      end subroutine check

   end subroutine test_others

   !> Every bit comes back: SDF has them all, and 17 figures, read with right rounding, as well.
   !> With holes SDF has whole numbers of 32 bits: half of one is allowed, 1/(2^31 - 1) of the
   !> largest height, and what the scale's rounding takes.
   subroutine test_round_trip()
      character(len=*), parameter :: endings(3) = ['sdf', 'xyz', 'csv']
      type(height_map) :: map, back
      type(error_type), allocatable :: error
      character(len=:), allocatable :: bytes
      real(wp) :: largest
      integer :: k

      call formula_map(map, 37, 23)
      do k = 1, size(endings)
         call height_map_bytes(map, endings(k), bytes, error)
         call assertFalse(allocated(error), endings(k))
         call read_text(bytes, no_hints, back)
         if (endings(k) == 'sdf') then
            call assertTrue(all((map%heights >= none) .eqv. &
               (back%heights >= none)), 'holes')
            call assertEqual(81 + 4*size(map%heights), len(bytes))
            largest = maxval(abs(map%heights), mask=map%heights < none)
            call assertTrue(all(abs(map%heights - back%heights) <= &
               0.501_wp*largest/2147483647.0_wp), 'rounded')
         else
            call assert_same(map, back, endings(k))
         end if
         call assertEqual(map%step_x, back%step_x, 4.0_wp*epsilon(map%step_x)*map%step_x)
         call assertEqual(map%step_y, back%step_y, 4.0_wp*epsilon(map%step_y)*map%step_y)
      end do
      where (map%heights >= none) map%heights = -0.125_wp
      call height_map_bytes(map, 'sdf', bytes, error)
      call read_text(bytes, no_hints, back)
      call assert_same(map, back, 'sdf without holes')
      ! a hole alone in a plane of height 0
      map%heights = 0.0_wp
      map%heights(3, 4) = none
      call height_map_bytes(map, 'sdf', bytes, error)
      call read_text(bytes, no_hints, back)
      call assert_same(map, back, 'sdf of zeros with a hole')
      call height_map_bytes(map, 'png', bytes, error)
      call assertTrue(allocated(error), 'an unknown ending')
      map%heights = none
      call height_map_bytes(map, 'sdf', bytes, error)
      call assertTrue(allocated(error), 'nothing to write')
   end subroutine test_round_trip

   !> However the blocks cut lines and numbers, the map is the same.
   subroutine test_blocks()
      character(len=*), parameter :: endings(2) = ['xyz', 'csv']
      type(height_map) :: map, back
      type(error_type), allocatable :: error
      character(len=:), allocatable :: bytes
      integer :: k, length

      call formula_map(map, 7, 6)
      do k = 1, size(endings)
         call height_map_bytes(map, endings(k), bytes, error)
         do length = 1, 400, 7
            call read_text(bytes, no_hints, back, length)
            call assert_same(map, back, endings(k))
         end do
      end do
   end subroutine test_blocks

   !> Notes a share.
   subroutine listen(share)
      real(wp), intent(in) :: share

      call assertTrue(share > last_share .and. share <= 1.0_wp, 'rises')
      last_share = share
      calls = calls + 1
   end subroutine listen

   !> A file of several blocks; the shares rise.
   subroutine test_file()
      character(len=*), parameter :: path = 'test_map_file.csv'
      type(height_map) :: map, back
      type(error_type), allocatable :: error
      character(len=:), allocatable :: bytes
      integer :: unit

      call formula_map(map, 300, 400)
      call height_map_bytes(map, 'csv', bytes, error)
      open (newunit=unit, file=path, access='stream', form='unformatted', status='replace', &
         action='write')
      write (unit) bytes
      close (unit)
      last_share = 0.0_wp
      calls = 0
      call read_height_map(path, no_hints, back, error, listen)
      open (newunit=unit, file=path, action='write')
      close (unit, status='delete')
      call assertFalse(allocated(error), 'is read')
      call assert_same(map, back, 'file')
      call assertTrue(calls > 1, 'heard of')
      call assertEqual(1.0_wp, last_share, 0.01_wp)
   end subroutine test_file

   subroutine test_matrix()
      type(map_hints) :: hints
      type(height_map) :: map
      real(wp), parameter :: row(5) = [1.5_wp, -2.0_wp, 9.0_wp, 0.25_wp, 3.0_wp]
      integer :: k

      hints = in_mm
      hints%step_x = 0.01_wp
      hints%step_y = 0.02_wp
      call read(repeat('1.5 -2 NaN .25 3e0'//nl, 5))
      call read(repeat('  1.5  -2'//tab//'nan 0.25   3'//nl, 5))
      call read(repeat('1.5,-2,,0.25,3'//nl, 5))
      call read(repeat('1.5, -2, No Data, 0.25, 3'//nl, 5))
      call read(repeat('1.5,'//tab//'-2,'//tab//'---,'//tab//'0.25,'//tab//'3'//nl, 5))
      call read(repeat('1.5;-2;;0.25;3;'//nl, 5))
      call read(repeat('1.5;-2; ;0.25;3'//nl, 5))
      call read(repeat('1.5'//tab//'-2'//tab//tab//'0.25'//tab//'3'//nl, 5))
      call read(repeat('1.5 -2 No Data 0.25 3'//nl, 5))
      call read(nl//repeat('1.5 -2 BAD 0.25 3'//nl//nl, 5))
      ! a hole at the end of some lines is one, at the end of all it is the separator
      call read_text('1,2,3,4,'//nl//repeat('1,2,3,4,5'//nl, 4), hints, map)
      call assertEqual(5, size(map%heights, 1))
      call assertEqual(1, missing_points(map))
      call assertEqual(0.01_wp, map%step_x)
      call assertEqual(0.02_wp, map%step_y)

   contains

      subroutine read(text)
         character(len=*), intent(in) :: text

         call read_text(text, hints, map)
         call assertEqual('text of a matrix', map%format)
         call assert_map(map, 5, [(row, k=1, 5)], 0.0_wp)
      end subroutine read

   end subroutine test_matrix

   subroutine test_headers()
      type(height_map) :: map
      type(map_hints) :: hints
      integer :: k

      ! Esri: the last line is at y = 0
      call read_text('ncols 6'//nl//'nrows 5'//nl//'xllcorner 0.5'//nl//'yllcorner 0'//nl// &
         'cellsize 0.25'//nl//'NODATA_value -9999'//nl//'1 2 3 4 5 6'//nl// &
         repeat('0 0 0 0 0 -9999.0'//nl, 4), in_mm, map)
      call assert_map(map, 6, [(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 9.0_wp, k=1, 4), &
         1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp, 6.0_wp], 0.0_wp)
      call assertEqual([0.25_wp, 0.25_wp], [map%step_x, map%step_y])
      ! Gwyddion: the lengths of the whole map
      hints = map_hints()
      call read_text('# Channel: Height (retrace)'//nl//'# Width: 10.0 '//char(194)//char(181)// &
         'm'//nl//'# Height: 21.0 um'//nl//'# Value units: m'//nl// &
         repeat('1e-6'//tab//'2e-6'//tab//'3e-6'//tab//'4e-6'//tab//'5e-6'//nl, 7), hints, map)
      call assert_map(map, 5, [(1.0e-3_wp, 2.0e-3_wp, 3.0e-3_wp, 4.0e-3_wp, 5.0e-3_wp, k=1, 7)], &
         1.0e-15_wp)
      call assertEqual([0.002_wp, 0.003_wp], [map%step_x, map%step_y], 1.0e-15_wp)
      ! ours, in other units
      call read_text('# step: 2 um'//nl//'# height unit: nm'//nl//repeat('1,2,3,4,5'//nl, 5), &
         hints, &
         map)
      call assertEqual([0.002_wp, 0.002_wp], [map%step_x, map%step_y], 1.0e-15_wp)
      call assertEqual(5.0e-6_wp, map%heights(5, 5), 1.0e-20_wp)
      ! the user repeats what the file says
      hints = map_hints(height_unit='nm', step_x=0.002_wp)
      call read_text('# step: 2 um'//nl//'# height unit: nm'//nl//repeat('1,2,3,4,5'//nl, 5), &
         hints, &
         map)
      call assertEqual(5, size(map%heights, 1))
   end subroutine test_headers

   subroutine test_line_ends()
      type(height_map) :: map
      type(map_hints) :: hints
      character(len=1), parameter :: cr = achar(13)
      integer :: k

      hints = in_mm
      hints%step_x = 1.0_wp
      hints%step_y = 1.0_wp
      call read(repeat('1 2 3 4 5'//nl, 5))
      call read(repeat('1 2 3 4 5'//nl, 4)//'1 2 3 4 5')
      call read(repeat('1 2 3 4 5'//cr//nl, 5))
      call read(repeat('1 2 3 4 5'//cr, 5))
      call read(char(239)//char(187)//char(191)//repeat('1 2 3 4 5'//nl, 5)//nl//nl)

   contains

      subroutine read(text)
         character(len=*), intent(in) :: text

         call read_text(text, hints, map)
         call assert_map(map, 5, [(1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp, k=1, 5)], 0.0_wp)
      end subroutine read

   end subroutine test_line_ends

   !> The lines of a map in random order, backwards, by columns; some left out.
   subroutine test_order()
      type(height_map) :: map, back
      type(random_stream) :: stream
      integer, parameter :: nx = 9, ny = 8
      integer :: i, k, m, order(nx*ny), kept
      character(len=:), allocatable :: text
      character(len=60) :: line

      call formula_map(map, nx, ny)
      map%step_x = 0.5_wp
      map%step_y = 0.25_wp
      stream%state = 99
      text = ''
      do k = 1, 4
         do i = 1, nx*ny
            order(i) = i - 1
         end do
         do i = nx*ny, 2, -1
            m = 1 + int(stream%uniform(0.0_wp, real(i, wp)))
            kept = order(i)
            if (k == 1) m = i
            if (k == 2) m = nx*ny + 1 - i
            if (k == 2 .and. m > i) exit
            order(i) = order(m)
            order(m) = kept
         end do
         if (k == 3) then
            do i = 0, nx*ny - 1
               order(i + 1) = i/ny + nx*mod(i, ny)
            end do
         end if
         text = ''
         do i = 1, nx*ny
            associate (x => mod(order(i), nx), y => order(i)/nx)
               if (map%heights(x + 1, y + 1) >= none) cycle
               write (line, '(f8.3, f8.2, es25.16)') x*0.5_wp - 1.0_wp, y*0.25_wp, &
                  map%heights(x + 1, y + 1)
            end associate
            text = text//trim(line)//nl
         end do
         call read_text(text, in_mm, back)
         call assertEqual('text of x, y, z', back%format)
         call assert_same(map, back, 'order')
         call assertEqual([0.5_wp, 0.25_wp], [back%step_x, back%step_y], 1.0e-15_wp)
      end do
   end subroutine test_order

   subroutine test_points()
      type(height_map) :: map
      character(len=*), parameter :: separators(4) = [' ', ',', ';', tab]
      character(len=*), parameter :: holes(4) = ['NaN    ', 'BAD    ', 'No Data', '-9999  ']
      character(len=:), allocatable :: text
      integer :: i, j, k
      type(map_hints) :: hints

      text = ''
      do k = 1, 4
         text = 'x (um)'//separators(k)//'y (um)'//separators(k)//'height (nm)'//nl
         if (k == 4) text = '# nodata: -9999'//nl//text
         do j = 1, 5
            do i = 1, 6
               text = text//achar(48 + i)//'.0'//separators(k)//achar(48 + j)//separators(k)
               if (i == 2 .and. j == 3) then
                  text = text//trim(holes(k))//nl
               else
                  text = text//achar(48 + i)//achar(48 + j)//nl
               end if
            end do
         end do
         hints = map_hints()
         call read_text(text, hints, map)
         call assertEqual('text of x, y, z', map%format)
         call assertEqual(0.001_wp, map%step_x, 1.0e-18_wp)
         call assertEqual(1, missing_points(map))
         call assertTrue(map%heights(2, 3) >= none, 'hole')
         call assertEqual(65.0e-6_wp, map%heights(6, 5), 1.0e-18_wp)
      end do
   end subroutine test_points

   !> Coordinates of steps 1/3 and 1/7 with three and four decimals: the step is that of the whole
   !> map, so it is off by less than one in the last decimal over the number of steps.
   subroutine test_rounded()
      type(height_map) :: map
      character(len=:), allocatable :: text
      character(len=40) :: line
      integer :: i, j

      text = ''
      do j = 0, 30
         do i = 0, 40
            write (line, '(f9.3, f9.4, i6)') i/3.0_wp, j/7.0_wp, i + 100*j
            text = text//trim(line)//nl
         end do
      end do
      call read_text(text, in_mm, map)
      call assertEqual([41, 31], shape(map%heights))
      call assertEqual(1.0_wp/3.0_wp, map%step_x, 1.0e-3_wp/40.0_wp)
      call assertEqual(1.0_wp/7.0_wp, map%step_y, 1.0e-4_wp/30.0_wp)
      call assertEqual(1007.0_wp, map%heights(8, 11))
   end subroutine test_rounded

   subroutine test_units()
      type(height_map) :: map
      type(map_hints) :: hints
      character(len=*), parameter :: names(5) = ['m ', 'cm', 'mm', 'um', 'nm']
      real(wp), parameter :: lengths(5) = [1.0e3_wp, 1.0e1_wp, 1.0_wp, 1.0e-3_wp, 1.0e-6_wp]
      integer :: k

      do k = 1, 5
         hints = map_hints(lateral_unit=names(k), height_unit=names(6 - k))
         call read_text('ncols 5'//nl//'nrows 5'//nl//'cellsize 2'//nl//repeat('1 2 3 4 5'//nl, &
            5), &
            hints, map)
         call assertEqual(2.0_wp*lengths(k), map%step_x, 1.0e-15_wp*lengths(k), names(k))
         call assertEqual(5.0_wp*lengths(6 - k), map%heights(5, 1), 1.0e-15_wp*lengths(6 - k))
      end do
      call assertTrue(has_text(map%format, 'matrix'), 'format')
      call assertLessThan(map%step_x, 1.0e-5_wp, 'nanometres')
   end subroutine test_units

end module test_height_map_files
