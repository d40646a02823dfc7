!> Texts that programs of instruments export.
module test_height_map_exports
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_read, only: map_hints, read_height_map
   use asperity_height_map_type, only: height_map, missing_points
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: assert_map, has_text, nl, no_hints, read_text, refused, &
      small_heights, small_rows
   implicit none
   private
   public :: suite_map_exports

   character(len=*), parameter :: tab = achar(9), crlf = achar(13)//nl
   !> Heights in um, read as mm
   real(wp), parameter :: um = 1.0e-3_wp, exact = 1.0e-15_wp
   integer, parameter :: rows = size(small_rows)

contains

   function suite_map_exports() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map exports')
      call suite%addTest(TestMethod('files of the scans', test_scans))
      call suite%addTest(TestMethod('Keyence', test_keyence))
      call suite%addTest(TestMethod('Keyence, refused', test_keyence_refused))
      call suite%addTest(TestMethod('Zygo', test_zygo))
      call suite%addTest(TestMethod('Wyko', test_wyko))
      call suite%addTest(TestMethod('Wyko, points', test_wyko_points))
      call suite%addTest(TestMethod('SPIP', test_spip))
      call suite%addTest(TestMethod('Surfer', test_surfer))
   end function suite_map_exports

   !> Every file has the same heights. Allowed is the rounding of its figures: none where they are
   !> the same, half of 1e-6 wave lengths of 633 nm.
   subroutine test_scans()
      type(height_map) :: truth

      call read('truth_mm.csv', map_hints('', 'mm', 0.0025_wp, 0.002_wp), truth)
      call check('keyence_vk.csv', no_hints, 'Keyence csv', 0.0025_wp, 0, exact)
      call check('keyence_vk_no_quotes.csv', map_hints('', 'um', 0.0025_wp, 0.0025_wp), &
         'Keyence csv', 0.0025_wp, 0, exact)
      call check('zygo_header.xyz', no_hints, 'Zygo XYZ text', 0.0025_wp, 3, exact)
      call check('zygo_header.xyz', map_hints('um', 'um'), 'Zygo XYZ text', 0.0025_wp, 3, exact)
      call check('wyko.asc', map_hints('', '', 0.0025_wp, 0.002_wp), 'Wyko ASCII', 0.002_wp, 3, &
         3.2e-10_wp)
      call check('spip.asc', map_hints('', 'nm'), 'SPIP ASCII', 0.002_wp, 0, exact)
      call check('surfer.grd', map_hints('um', 'um'), 'Surfer grid (DSAA)', 0.002_wp, 0, exact)
      call check('surfer.grd', map_hints('', 'um', 0.0025_wp, 0.002_wp), 'Surfer grid (DSAA)', &
         0.002_wp, 0, exact)

   contains

      subroutine check(name, hints, form, step_y, missing, tolerance)
         character(len=*), intent(in) :: name, form
         type(map_hints), intent(in) :: hints
         real(wp), intent(in) :: step_y, tolerance
         integer, intent(in) :: missing
         integer, parameter :: holes(2, 3) = reshape([6, 4, 7, 4, 21, 10], [2, 3])
         type(height_map) :: map
         real(wp) :: expected(24, 18)
         integer :: i

         call read(name, hints, map)
         call assertEqual([24, 18], shape(map%heights), name)
         if (any(shape(map%heights) /= [24, 18])) return
         call assertEqual(form, map%format)
         call assertEqual(0.0025_wp, map%step_x, 1.0e-15_wp, name)
         call assertEqual(step_y, map%step_y, 1.0e-15_wp, name)
         call assertEqual(missing, missing_points(map), name)
         expected = truth%heights
         do i = 1, 3
            if (missing > 0) expected(holes(1, i), holes(2, i)) = none
         end do
         call assertTrue(all(abs(map%heights - expected) <= tolerance), name)
      end subroutine check

      subroutine read(name, hints, map)
         character(len=*), intent(in) :: name
         type(map_hints), intent(in) :: hints
         type(height_map), intent(out) :: map
         type(error_type), allocatable :: error

         call read_height_map('test/data/scans/'//name, hints, map, error)
         if (.not. allocated(error)) return
         call assertEqual('', error%message)
         allocate (map%heights(0, 0))
      end subroutine read

   end subroutine test_scans

   !> The small map in lines that end like this, with other commas and separators.
   function lines(separator, point, finish) result(text)
      character(len=1), intent(in) :: separator, point
      character(len=*), intent(in) :: finish
      character(len=:), allocatable :: text
      integer :: i, k

      text = ''
      do k = 1, rows
         do i = 1, len_trim(small_rows(k))
            select case (small_rows(k) (i:i))
            case (',')
               text = text//separator
            case ('.')
               text = text//point
            case default
               text = text//small_rows(k) (i:i)
            end select
         end do
         text = text//finish
      end do
   end function lines

   !> A header of Keyence's, in the words of its languages; fields between quotes or not.
   function keyence(words, separator, quote, unit) result(text)
      !> Of the step, the image, columns and rows, the unit, and of heights
      character(len=*), intent(in) :: words(6), separator, quote, unit
      character(len=:), allocatable :: text

      text = field('Measured date')//separator//field('2026-01-15 09:30:00')//crlf
      text = text//field('Data type')//separator//field('ImageDataCsv')//crlf
      text = text//field(trim(words(1)))//separator//field('2500')//separator//field('nm')//crlf
      text = text//field(trim(words(2)))//separator//field(trim(words(6)))//crlf
      text = text//field(trim(words(3)))//separator//field('6')//crlf
      text = text//field(trim(words(4)))//separator//field('5')//crlf
      text = text//'min'//separator//'2.2'//crlf//'max'//separator//'8.9'//crlf
      text = text//field(trim(words(5)))//separator//field(unit)//crlf
      text = text//field('Reference')//separator//field('')//crlf//crlf
      text = text//field(trim(words(6)))//crlf

   contains

      function field(word)
         character(len=*), intent(in) :: word
         character(len=:), allocatable :: field

         field = quote//word//quote
      end function field

   end function keyence

   subroutine test_keyence()
      character(len=*), parameter :: english(6) = [character(len=18) :: 'XY Calibration', &
         'Output image data', 'Horizontal', 'Vertical', 'Unit', 'Height']
      character(len=*), parameter :: german(6) = [character(len=18) :: 'XY-Kalibrierung', &
         'Bilddaten', 'Horizontal', 'Vertikal', 'Einheit', 'H'//char(246)//'he']
      !> In Shift-JIS, of which only the word of heights matters
      character(len=*), parameter :: japanese(6) = [character(len=18) :: 'XY'//char(131), &
         char(143), char(137), char(143), char(146), &
         char(141)//char(130)//char(130)//char(179)]
      character(len=*), parameter :: mu = char(131)//char(202)
      type(height_map) :: map
      character(len=:), allocatable :: text
      integer :: i

      call check(keyence(english, ',', '"', 'um')//lines(',', '.', crlf))
      call check(keyence(english, ';', '"', 'um')//lines(';', '.', nl))
      call check(keyence(german, ';', '"', char(181)//'m')//lines(';', ',', crlf))
      call check(keyence(german, tab, '', 'um')//lines(tab, ',', crlf))
      call check(keyence(japanese, ',', '"', mu//'m')//lines(',', '.', crlf))
      call check(char(239)//char(187)//char(191)//keyence(english, ',', '', 'um')// &
         lines(',', '.', nl))
      ! without the name of the image; a separator within quotes
      text = keyence(english, ',', '"', 'um')
      call check(text(:place_of(text, 10))//lines(',', '.', crlf))
      call check(text(:index(text, 'Calib') - 1)//', '//text(index(text, 'Calib'):)// &
         lines(',', '.', crlf))
      ! each number between quotes
      text = lines(',', '.', '"'//nl)
      do i = len(text) - 1, 1, -1
         if (text(i:i) == ',') text = text(:i - 1)//'","'//text(i + 1:)
         if (text(i:i) == nl) text = text(:i)//'"'//text(i + 1:)
      end do
      call check(keyence(english, ',', '"', 'um')//'"'//text)
      ! as spreadsheets write it, all lines as long as the longest
      text = keyence(english, ',', '', 'um')
      do i = len(text), 1, -1
         if (text(i:i) == achar(13)) text = text(:i - 1)//',,,'//text(i:)
      end do
      call check(text//lines(',', '.', crlf))
      ! missing points, in the first row all of them
      text = lines(',', '.', crlf)
      call read_text(keyence(english, ',', '"', 'um')//'"","","","","",""'//crlf//text(26:), &
         no_hints, map)
      call assert_map(map, 6, [spread(9.0_wp, 1, 6), um*small_heights(7:)], exact)

   contains

      subroutine check(file)
         character(len=*), intent(in) :: file

         call read_text(file, no_hints, map)
         call assert_map(map, 6, um*small_heights, exact)
         call assertEqual('Keyence csv', map%format)
         call assertEqual(0.0025_wp, map%step_x, exact)
         call assertEqual(0.0025_wp, map%step_y, exact)
         call assertFalse(allocated(map%notes), 'nothing to say')
      end subroutine check

   end subroutine test_keyence

   subroutine test_keyence_refused()
      character(len=18) :: words(6)
      character(len=:), allocatable :: text, head
      integer :: k

      words = [character(len=18) :: 'XY Calibration', 'Output image data', 'Horizontal', &
         'Vertical', 'Unit', 'Height']
      text = lines(',', '.', nl)
      head = keyence(words, ',', '"', 'um')
      call refused(head//text, 'file: --height-unit mm contradicts', 'are in um', &
         map_hints('', 'mm'))
      call refused(head//text, 'file: --step 0.5 mm contradicts', '0.0025 mm', &
         map_hints('', '', 0.5_wp, 0.5_wp))
      call refused(head//text(:len(text) - 24), 'file:16:', &
         'there are 4 rows, the header promises 5: the file was cut off', no_hints)
      call refused(head//text(:len(text) - 5), 'file:17:1: ', 'row of 5 fields', no_hints)
      call refused(head//text//'1,2,3,4,5,6'//nl, 'file:18:', 'there are 6 rows', no_hints)
      call refused(head//'1,2,3,4,5,6,7'//nl, 'file:13:1: ', 'there are 7 columns, the header '// &
         'promises 6', no_hints)
      call refused(head//'1,2,x,4,5,6'//nl, 'file:13:5: ', 'is no number', no_hints)
      call refused(head, 'file:12:1: ', 'before its heights: it was cut off', no_hints)
      do k = 2, 11
         call refused(head(:place_of(head, k)), 'file:', 'before its heights: it was cut off', &
            no_hints)
      end do
      call refused(keyence(words, ',', '"', '')//text, 'file:9:1: ', 'is no length', no_hints)
      words(6) = 'Laser intensity'
      call refused(keyence(words, ',', '"', 'um')//text, 'file:4:1: ', &
         'an image of ''Laser intensity'', no heights: export the height image', no_hints)
      k = index(head, 'Image')
      call refused(head(:k - 1)//'Profile'//head(k + 5:)//text, 'file:2:1: ', &
         'holds ProfileDataCsv, not ImageDataCsv', no_hints)
      k = index(head, '"6"')
      call refused(head(:k)//'x'//head(k + 2:)//text, 'file:5:1: ', 'must be a whole number', &
         no_hints)
      call refused(head(:k + 1)//' px'//head(k + 2:)//text, 'file:5:1: ', &
         'must be a whole number', no_hints)
      k = index(head, '"nm"')
      call refused(head(:k)//'px'//head(k + 3:)//text, 'file:3:1: ', 'the distance of points', &
         no_hints)
   end subroutine test_keyence_refused

   !> Last character of a line.
   pure integer function place_of(text, line)
      character(len=*), intent(in) :: text
      integer, intent(in) :: line
      integer :: i

      place_of = 0
      do i = 1, line
         place_of = place_of + index(text(place_of + 1:), nl)
      end do
   end function place_of

   !> A Zygo file of 6 x 5 points from column 10 and row 20 on, the pixels 2 um apart.
   function zygo(pixel, mark) result(text)
      character(len=*), intent(in) :: pixel
      character(len=*), intent(in) :: mark
      character(len=:), allocatable :: text
      character(len=40) :: line
      integer :: i, j

      text = 'Zygo XYZ Data File - Format 1'//nl//'0 3 0 0 "Tue Aug 25 16:59:23 2026"'//nl// &
         '0 0 6 5 1 255'//nl//'10 20 6 5'//nl//'"comment"'//nl//'""'//nl//'""'//nl// &
         '0 0.5 6.328e-07 0 1 0 '//pixel//' 1787677163'//nl//repeat('0 0 0'//nl, 4)// &
         '1 0'//nl//'#'//nl
      do j = 0, rows - 1
         do i = 0, 5
            write (line, '(i0, " ", i0, " ", f0.1)') 10 + i, 20 + j, small_heights(6*j + i + 1)
            if (i == 2 .and. j == 3) line = '12 23 No Data'
            text = text//trim(line)//nl
         end do
      end do
      text = text//mark
   end function zygo

   subroutine test_zygo()
      character(len=:), allocatable :: text
      type(height_map) :: map
      real(wp) :: heights(30)

      text = zygo('2.0e-6', '#'//nl)
      heights = um*small_heights
      heights(21) = 9.0_wp
      call read_text(text, no_hints, map)
      call assert_map(map, 6, heights, exact)
      call assertEqual(0.002_wp, map%step_x, exact)
      call assertEqual(0.002_wp, map%step_y, exact)
      call assertTrue(has_text(map%notes, 'heights are taken for um, as MetroPro'), map%notes)
      call assertTrue(has_text(map%notes, 'pixels, which are 0.002 mm apart'), map%notes)
      call read_text(text, map_hints('mm', 'nm'), map)
      heights = 1.0e-6_wp*small_heights
      heights(21) = 9.0_wp
      call assert_map(map, 6, heights, exact)
      call assertEqual(0.002_wp, map%step_x, exact)
      call assertFalse(has_text(map%notes, 'MetroPro'), map%notes)
      call assertTrue(has_text(map%notes, '--lateral-unit mm is not used'), map%notes)
      ! pixels of no known size
      call refused(zygo('0', '#'), 'file: ', 'distance of its points in x: say it with --step', &
         no_hints)
      call read_text(zygo('0', '#'), map_hints('', 'um', 0.5_wp, 0.25_wp), map)
      call assertEqual(0.25_wp, map%step_y, exact)
      call refused(text, 'file: --step 0.5 mm contradicts', '0.002', &
         map_hints('', 'um', 0.5_wp, 0.5_wp))
      ! cut off, damaged, of another kind
      call refused(zygo('2e-6', ''), 'file:44:', 'behind 30 of the 6 x 5 points', no_hints)
      call refused(text(:place_of(text, 30)), 'file:30:', 'behind 16 of the 6 x 5', no_hints)
      call refused(text(:index(text, '#')), 'file:14:', 'before its heights', no_hints)
      call refused(text(:index(text, '#') + 1)//'10 20'//nl//'#', 'file:15:1: ', &
         'here are 2 fields, a point has three', no_hints)
      text(place_of(text, 14) + 7:place_of(text, 14) + 9) = 'NaN'
      call read_text(text, no_hints, map)
      call assertEqual(2, missing_points(map))
      text = zygo('2.0e-6', '#'//nl)
      call refused(text(:place_of(text, 11))//text(index(text, '#'):), 'file:12:1: ', &
         'there are 11 lines before the points', no_hints)
      call refused(text(:place_of(text, 12))//text(index(text, '#'):), 'file:13:1: ', &
         'there are 12 lines before the points', no_hints)
      call refused(text//'1 2 3'//nl, 'file:46:1: ', 'numbers follow a comment', no_hints)
      call refused(text(:len(text) - 2)//'20 20 1.5'//nl//'#', 'file: the points are on 11 x 5', &
         'the header promises 6 x 5', no_hints)
      call refused('Zygo ASCII Data File - Format 2'//nl//'1'//nl, 'file: is Zygo ASCII data', &
         'export the heights as XYZ', no_hints)
   end subroutine test_zygo

   !> A Wyko file of 5 lines of 6 numbers: 5 points along x, 6 along y.
   function wyko(flags, keys, finish) result(text)
      character(len=*), intent(in) :: flags, keys, finish
      character(len=:), allocatable :: text

      text = 'Wyko ASCII Data File Format '//flags//crlf//'X Size'//tab//'5'//crlf// &
         'Y Size'//tab//'6'//crlf//'Block Name'//tab//'Type'//tab//'Length'//tab//'Value'//crlf// &
         keys//'RAW_DATA'//tab//'3'//tab//'120'//crlf//lines(tab, '.', crlf)//finish
   end function wyko

   !> A key with its value.
   function key(name, value) result(text)
      character(len=*), intent(in) :: name, value
      character(len=:), allocatable :: text

      text = name//tab//'7'//tab//'4'//tab//value//crlf
   end function key

   subroutine test_wyko()
      character(len=*), parameter :: waves = '0'//tab//'0'//tab//'1', real_units = '0 1 1'
      character(len=:), allocatable :: keys, wave, text
      real(wp) :: turned(30)
      type(height_map) :: map

      keys = key('Pixel_size', '0.002')//key('Aspect', '1.5')//key('Title', 'oak')
      wave = key('Wavelength', '500')
      ! a line is one of x
      turned = reshape(transpose(reshape(small_heights, [6, rows])), [30])
      call check(wyko(waves, wave//keys, ''), 5.0e-4_wp)
      call assertTrue(has_text(map%notes, 'wave lengths of 500'), map%notes)
      call check(wyko(real_units, wave//keys, ''), 1.0e-6_wp)
      call assertFalse(allocated(map%notes), 'nothing to say')
      call check(wyko(real_units, keys//key('Mult', '1'), ''), 1.0e-6_wp)
      ! other blocks, behind and before
      call check(wyko(real_units, keys, 'Intensity'//tab//'3'//tab//'120'//crlf// &
         lines(tab, '.', crlf)), 1.0e-6_wp)
      call assertTrue(has_text(map%notes, 'stands behind the heights is not read'), map%notes)
      call check(wyko(real_units, keys//'Image'//tab//'3'//tab//'120'//crlf// &
         lines(tab, '.', crlf), ''), 1.0e-6_wp)
      call assertTrue(has_text(map%notes, 'the block Image is not read'), map%notes)
      ! missing points
      text = wyko(real_units, keys, '')
      text = text(:index(text, '4.7') - 1)//'Bad'//text(index(text, '4.7') + 3:)
      call read_text(text, no_hints, map)
      call assertTrue(map%heights(1, 2) >= none, 'Bad')
      call assertEqual(1, missing_points(map))
      ! one step for both
      call read_text(wyko(real_units, key('Pixel_size', '0.002'), ''), no_hints, map)
      call assertEqual(0.002_wp, map%step_y, exact)
      call refused(wyko(real_units, '', ''), 'file: ', 'say it with --step', no_hints)
      call refused(wyko(real_units, keys, ''), 'file: --height-unit um contradicts', 'in nm', &
         map_hints('', 'um'))
      call refused(wyko(waves, keys, ''), 'file:8:1: ', 'no Wavelength stands before them', &
         no_hints)
      call refused(wyko(waves, wave//keys//key('Mult', '2'), ''), 'file:9:1: Mult is 2: ', &
         'do not agree', no_hints)
      call refused(wyko(waves, key('Wavelength', 'x'), ''), 'file:5:1: ', 'must be a number', &
         no_hints)
      call refused(wyko(waves, key('Wavelength', '1e-300'), ''), 'file:5:1: ', &
         'from 1e-9 to 1e9', no_hints)
      call refused(wyko('0 1', keys, ''), 'file:1:1: ', 'three numbers must follow', no_hints)
      text = wyko(real_units, keys, '')
      call refused(text(:len(text) - 25), 'file:12:', 'there are 4 rows, the header promises 5', &
         no_hints)
      call refused(text(:len(text) - 7), 'file:13:1: ', 'row of 5 fields', no_hints)
      call refused(text(:index(text, 'RAW') - 1), 'file:7:', 'before its heights', no_hints)
      call refused(text(:index(text, 'Y Size') - 1)//text(index(text, 'Block'):), 'file:7:1: ', &
         'X Size and Y Size must stand', no_hints)

   contains

      subroutine check(file, factor)
         character(len=*), intent(in) :: file
         real(wp), intent(in) :: factor

         call read_text(file, no_hints, map)
         call assert_map(map, 5, factor*turned, exact)
         call assertEqual(0.002_wp, map%step_x, exact)
         call assertEqual(0.003_wp, map%step_y, exact)
      end subroutine check

   end subroutine test_wyko

   !> A line for each point: x, y, mm, and z.
   subroutine test_wyko_points()
      character(len=:), allocatable :: points, text
      character(len=60) :: line
      type(height_map) :: map
      real(wp) :: turned(30)
      integer :: i, j

      points = ''
      do j = 0, 4
         do i = 0, 5
            write (line, '(f5.3, a, f5.3, a, f0.1)') 0.002_wp*j, tab, 0.003_wp*i, tab, &
               small_heights(6*j + i + 1)
            if (i == 1 .and. j == 2) line(index(line, tab, .true.) + 1:) = 'Bad'
            points = points//trim(line)//crlf
         end do
      end do
      turned = reshape(transpose(reshape(small_heights, [6, rows])), [30])
      turned(8) = 9.0e6_wp
      text = file('0.002', '')
      call check(text)
      call assertFalse(allocated(map%notes), 'nothing to say')
      call check(file('0.002', 'Intensity'//tab//'3'//tab//'120'//crlf//points))
      call assertTrue(has_text(map%notes, 'behind the heights'), map%notes)
      call check(text(:index(text, 'RAW_DATA') - 1)//'Image'//tab//'3'//tab//'120'//crlf// &
         points//text(index(text, 'RAW_DATA'):))
      call refused(file('2', ''), 'file: by their coordinates the steps', 'correct it', no_hints)
      call refused(text(:len(text) - 18), 'file:', 'behind 29 of the 5 x 6 points', no_hints)
      call refused(text(:index(text, '0.000') - 1)//'1'//tab//'2'//crlf, 'file:8:1: ', &
         'here are 2 fields', no_hints)
      call refused(text, 'file: --lateral-unit um contradicts', 'are in mm', map_hints('um', ''))

   contains

      function file(pixel, finish) result(whole)
         character(len=*), intent(in) :: pixel, finish
         character(len=:), allocatable :: whole

         whole = wyko('1'//tab//'1'//tab//'1', key('Pixel_size', pixel)//key('Aspect', '1.5'), '')
         whole = whole(:index(whole, 'RAW_DATA') + 15)//points//finish
      end function file

      subroutine check(whole)
         character(len=*), intent(in) :: whole

         call read_text(whole, no_hints, map)
         call assert_map(map, 5, merge(9.0_wp, 1.0e-6_wp*turned, turned > 8.0e6_wp), exact)
         call assertEqual(0.002_wp, map%step_x, 1.0e-12_wp)
         call assertEqual(0.003_wp, map%step_y, 1.0e-12_wp)
      end subroutine check

   end subroutine test_wyko_points

   subroutine test_spip()
      character(len=*), parameter :: mark = '# File Format = ASCII'//nl, &
         sizes = '# x-pixels = 6'//nl//'# y-pixels = 5'//nl, &
         lengths = '# x-length = 12000'//nl//'# y-length = -15000'//nl, &
         begin = '# Start of Data:'//nl
      character(len=:), allocatable :: head, text
      type(height_map) :: map
      real(wp) :: heights(30)
      integer :: i

      text = lines(tab, '.', nl)
      head = mark//sizes//lengths
      call check(head//'# z-unit = um'//nl//begin//text, um)
      call check(head//'# Bit2nm = 1.0'//nl//begin//text, 1.0e-6_wp)
      call assertFalse(allocated(map%notes), 'nothing to say')
      call check(head//'# Bit2nm = 250'//nl//begin//text, 250.0e-6_wp)
      ! the unit goes before the factor
      call check(head//'# Bit2nm = 250'//nl//'# z-unit = [nm]'//nl//begin//text, 1.0e-6_wp)
      ! all on one line
      do i = 1, len(text)
         if (text(i:i) == nl) text(i:i) = tab
      end do
      call check(head//'# z-unit = um'//nl//begin//text//nl, um)
      text = lines(tab, '.', nl)
      ! a matrix of void pixels, in lines of 10
      head = head//'# z-unit = um'//nl
      heights = um*small_heights
      heights([3, 30]) = 9.0_wp
      call read_text(head//'# voidpixels = 2'//nl//begin//text//nl//'0 0 1 0 0 0 0 0 0 0'//nl// &
         repeat('0 ', 10)//nl//repeat('0 ', 9)//'1'//nl, no_hints, map)
      call assert_map(map, 6, heights, exact)
      call read_text(head//'# voidpixels = 2'//nl//begin//text//repeat('0 ', 30)//nl//'# x'// &
         nl//'more'//nl, no_hints, map)
      call assertTrue(has_text(map%notes, 'what stands behind the heights'), map%notes)
      call refused(head//'# voidpixels = 2'//nl//begin//lines(tab, '.', tab)//repeat('0 ', 30)// &
         nl, 'file:9:121: ', 'end here, and so must the line', no_hints)
      call refused(head//'# voidpixels = 2'//nl//begin//text//repeat('0 ', 29)//nl, 'file:', &
         'within the matrix of void pixels', no_hints)
      call refused(head//'# voidpixels = 2'//nl//begin//text//repeat('0 ', 31)//nl, &
         'file:14:61: ', 'more void pixels than points', no_hints)
      call refused(head//'# voidpixels = 2'//nl//begin//text//'0 2'//nl, 'file:14:3: ', &
         'a void pixel is 1', no_hints)
      call refused(head//'# voidpixels = 2'//nl//begin//text//'0 x'//nl, 'file:14:3: ', &
         'is no number', no_hints)
      call refused(head//begin//text(:len(text) - 4), 'file:12:1: ', 'row of 5 fields', no_hints)
      call refused(head//begin//text//'1 2 3 4 5 6'//nl, 'file:13:', 'there are 6 rows', no_hints)
      call refused(mark//sizes//begin//text, 'file: ', 'in which unit its heights are', no_hints)
      call refused(mark//sizes//'# z-unit = nm'//nl//begin//text, 'file: ', 'with --step', no_hints)
      call refused(mark//sizes//'# z-unit = [V]'//nl//begin//text, 'file:4:1: ', 'is no length', &
         no_hints)
      call refused(mark//'# points = 6'//nl//'# length = 5'//nl//begin//text, 'file:5:1: ', &
         'this is a profile', no_hints)
      call refused(mark//'# x-pixels = 0'//nl//begin//text, 'file:2:1: ', 'whole number', no_hints)
      call refused(mark//'# x-pixels = 6 um'//nl//begin//text, 'file:2:1: ', 'whole number', &
         no_hints)
      call refused(mark//sizes, 'file:3:', 'before its heights', no_hints)

   contains

      subroutine check(file, factor)
         character(len=*), intent(in) :: file
         real(wp), intent(in) :: factor

         call read_text(file, no_hints, map)
         call assert_map(map, 6, factor*small_heights, exact)
         call assertEqual('SPIP ASCII', map%format)
         call assertEqual(0.002_wp, map%step_x, exact)
         call assertEqual(0.003_wp, map%step_y, exact)
      end subroutine check

   end subroutine test_spip

   subroutine test_surfer()
      character(len=*), parameter :: head = 'DSAA'//nl//'6 5'//nl//'10 20'//nl//'-3 9'//nl// &
         '2.2 8.9'//nl
      type(map_hints), parameter :: in_um = map_hints('um', 'um'), &
         wrong = map_hints('', 'um', 0.004_wp, 0.003_wp)
      character(len=:), allocatable :: text
      real(wp) :: heights(30)
      type(height_map) :: map

      text = lines(' ', '.', nl)
      call read_text(head//text, in_um, map)
      call check(um*small_heights)
      call read_text(head//text//achar(13)//crlf, map_hints('', 'um', 0.002_wp, 0.003_wp), map)
      call check(um*small_heights)
      ! rows in pieces, blanked points
      heights = um*small_heights
      heights(2) = 9.0_wp
      call read_text(head//'3.1 1.70141e+038'//nl//nl//text(9:), in_um, map)
      call check(heights)
      call read_text(head//'3.1 1.701410009187828e+38 '//text(9:), in_um, map)
      call check(heights)
      call refused(head//text, 'file: ', 'in which unit its lengths are', map_hints('', 'um'))
      call refused(head//text, 'file:5:1: --step contradicts the ranges', 'are 2.0 and 3.0', wrong)
      call refused(head//text(:len(text) - 4), 'file:10:1: ', 'row of 5 fields', in_um)
      call refused(head//'3.1'//nl//text(5:len(text) - 4), 'file:11:', &
         'the last row has 5 heights', in_um)
      call refused(head//text//text, 'file:', 'there are 10 rows', in_um)
      call refused(head(:7)//'x'//head(9:)//text, 'file:2:1: ', 'whole number', in_um)
      call refused(head(:9)//'20 10'//head(15:)//text, 'file:3:1: ', 'the range of x', in_um)
      call refused(head(:9)//'0 1e-300'//head(15:)//text, 'file:3:1: ', 'the range of x', wrong)
      call refused(head(:place_of(head, 3)), 'file:3:', 'it was cut off', in_um)

   contains

      subroutine check(expected)
         real(wp), intent(in) :: expected(:)

         call assert_map(map, 6, expected, exact)
         call assertEqual(0.002_wp, map%step_x, exact)
         call assertEqual(0.003_wp, map%step_y, exact)
         call assertEqual('Surfer grid (DSAA)', map%format)
      end subroutine check

   end subroutine test_surfer

end module test_height_map_exports
