!> Headers of texts of heights: names of columns, factors, sizes, markers, what is not understood.
module test_height_map_headers
   use asperity_base_kinds, only: wp
   use asperity_height_map_read, only: map_hints
   use asperity_height_map_type, only: height_map, missing_points, note_end
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: assert_map, has_text, in_mm, nl, no_hints, read_text, refused, &
      small_heights, small_rows, with_steps
   implicit none
   private
   public :: suite_map_headers

contains

   function suite_map_headers() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map headers')
      call suite%addTest(TestMethod('names of columns', test_names))
      call suite%addTest(TestMethod('heights that are no lengths', test_no_lengths))
      call suite%addTest(TestMethod('lengths and numbers of points', test_extents))
      call suite%addTest(TestMethod('markers of missing points', test_markers))
      call suite%addTest(TestMethod('lines not understood', test_unknown))
      call suite%addTest(TestMethod('comments behind the numbers', test_comments))
      call suite%addTest(TestMethod('quotes', test_quotes))
      call suite%addTest(TestMethod('colours behind points', test_colours))
   end function suite_map_headers

   !> The heights, line by line.
   subroutine lines_of(text, separator)
      character(len=:), allocatable, intent(out) :: text
      !> Between them; a comma when absent
      character(len=1), intent(in), optional :: separator
      integer :: i

      text = ''
      do i = 1, size(small_rows)
         text = text//small_rows(i)//nl
      end do
      if (.not. present(separator)) return
      do i = 1, len(text)
         if (text(i:i) == ',') text(i:i) = separator
      end do
   end subroutine lines_of

   subroutine test_names()
      character(len=*), parameter :: first(3) = [character(len=25) :: 'y [um],x [um],z [nm]', &
         '"Y_um","X_um","Height_nm"', '# Y/um, X/um, Z/nm']
      character(len=*), parameter :: words(6) = [character(len=10) :: 'pos', 'Position', 'coord', &
         'coordinate', 'axis', 'value']
      integer :: k

      do k = 1, size(first)
         call check(trim(first(k)), '', '', no_hints)
      end do
      call check('y x z', '', '', map_hints('um', 'nm'), blanks=.true.)
      call check('# y [um] x [um] z [nm]', '', '', no_hints, blanks=.true.)
      do k = 1, size(words)
         call check('Y '//trim(words(k))//' (um),X '//trim(words(k))//' (um),Z (nm)', '', '', &
            no_hints)
         call check(trim(words(k))//' y (um),'//trim(words(k))//' x (um),z (nm)', '', '', no_hints)
      end do
      ! among others, and in front of one without a name
      call check('y [um],x [um],z [nm],quality,red', '', ',good,7', no_hints)
      call check('id,y [um],x [um],z [nm]', '1,', '', no_hints)
      call check(',y [um],x [um],z [nm]', '1,', '', no_hints)
      call check('y [um],x [um],z [nm]', '"1",', '', no_hints)
      call check('y [um],x [um],z [nm]', '', ',', no_hints)
      call refused('y [um],x [mm],z [nm]'//nl//'0,0,1'//nl, 'file:1:1: ', 'x is in mm, y in um', &
         no_hints)
      ! a name without column
      call refused('x [um],y [um],z [nm]'//nl//'1,2,x'//nl, 'file:2:5: ', 'is no number', no_hints)

   contains

      !> 6 x 5 points, 2 um along x and 3 um along y, y first
      subroutine check(names, before, behind, hints, blanks)
         character(len=*), intent(in) :: names, before, behind
         type(map_hints), intent(in) :: hints
         logical, intent(in), optional :: blanks
         type(height_map) :: map
         character(len=:), allocatable :: text
         character(len=40) :: line
         integer :: i, j, k

         text = names//nl
         do j = 0, 4
            do i = 0, 5
               write (line, '(i0, ",", i0, ",", f0.1)') 3*j, 2*i, small_heights(6*j + i + 1)
               do k = 1, len_trim(line)
                  if (present(blanks) .and. line(k:k) == ',') line(k:k) = ' '
               end do
               text = text//before//trim(line)//behind//nl
            end do
         end do
         call read_text(text, hints, map)
         call assertEqual([6, 5], shape(map%heights), names)
         if (any(shape(map%heights) /= [6, 5])) return
         call assert_map(map, 6, 1.0e-6_wp*small_heights, 1.0e-15_wp)
         call assertEqual(0.002_wp, map%step_x, 1.0e-15_wp, names)
         call assertEqual(0.003_wp, map%step_y, 1.0e-15_wp, names)
         call assertFalse(allocated(map%notes), names)
      end subroutine check

   end subroutine test_names

   !> Only a factor to a length helps.
   subroutine test_no_lengths()
      character(len=*), parameter :: units(5) = [character(len=10) :: 'rad', '%', 'a.u.', 'V', &
         'grey level']
      character(len=*), parameter :: factors(3) = [character(len=44) :: &
         'height conversion factor (-> m)=2e-003', 'Height conversion factor (-> um) = 2000', &
         'height factor: 2 mm']
      character(len=:), allocatable :: text
      type(height_map) :: map
      integer :: k

      call lines_of(text, ' ')
      do k = 1, size(units)
         call refused('data unit='//trim(units(k))//nl//text, 'file:1:11: ', &
            'allowed are m, cm, mm, um and nm', with_steps)
      end do
      call refused('x [um] y [um] z [V]'//nl//text, 'file:1:', 'V, is unknown as one of heights', &
         map_hints('um', 'um'))
      do k = 1, size(factors)
         call read_text('data unit = rad'//nl//trim(factors(k))//nl//'pixel size = 3e-6 m'//nl// &
            text, no_hints, map)
         call assert_map(map, 6, 2.0_wp*small_heights, 1.0e-14_wp)
         call assertEqual(0.003_wp, map%step_y, 1.0e-15_wp)
         call assertTrue(has_text(map%notes, 'a number is a height of 2.0'), map%notes)
      end do
      call refused('height conversion factor = 2'//nl//text, 'file:1:28: ', &
         'to which unit it leads', with_steps)
      call refused('z unit = um'//nl//trim(factors(1))//nl//text, 'file: heights are in um', &
         'take one of the two out', map_hints(step_x=1.0_wp, step_y=1.0_wp))
   end subroutine test_no_lengths

   subroutine test_extents()
      character(len=:), allocatable :: text
      type(height_map) :: map

      call lines_of(text, ' ')
      call check('Width = 6'//nl//'Height = 5'//nl//'PixelSize = 3 um', map_hints('', 'mm'), &
         [0.003_wp, 0.003_wp])
      call check('h=5 w=6'//nl//'dx = 3 um'//nl//'dy = 2 um', map_hints('', 'mm'), &
         [0.003_wp, 0.002_wp])
      call check('h=5 w=6', with_steps, [0.5_wp, 0.25_wp])
      call check('dx=3 um dy=2 um', map_hints('', 'mm'), [0.003_wp, 0.002_wp])
      call check('h=5 dx=3 um w=6 dy=2 um', map_hints('', 'mm'), [0.003_wp, 0.002_wp])
      call check('# Width: 12 um'//nl//'# Height: 15 um', map_hints('', 'mm', 0.002_wp, 0.003_wp), &
         [0.002_wp, 0.003_wp])
      call check('# Width: 12'//nl//'# Height: 15', map_hints('um', 'mm'), [0.002_wp, 0.003_wp])
      ! Gwyddion prints 14.226 um so, whose step is 2.371 um, 0.34 % less than a sixth of 14 um
      call check('# Width: 14 um'//nl//'# Height: 15.00 um', map_hints('', 'mm'), &
         [14.0e-3_wp/6.0_wp, 0.003_wp])
      call assertEqual('file: Width is 14.0 um, rounded to 1.0 um by its figures: the step in '// &
         'x, 0.00233333 mm, may be off by 3.6 %; --step says it exactly.'//note_end, map%notes)
      call check('# Width: 14 um'//nl//'# Height: 15.00 um', &
         map_hints('', 'mm', 0.002371_wp, 0.003_wp), [0.002371_wp, 0.003_wp])
      call assertFalse(allocated(map%notes), 'said by the user')
      call refused('# Width: 14 um'//nl//'# Height: 15.00 um'//nl//text, &
         'file: --step 0.00242 mm contradicts', 'whose step in x is 0.0023', &
         map_hints('', 'mm', 0.00242_wp, 0.003_wp))
      call refused('Width = 6'//nl//'Height = 5'//nl//text, 'file: ', &
         'distance of its points in x', in_mm)
      call refused('Width = 6'//nl//'Height = 7'//nl//text, &
         'file: Width is the number of columns', 'is not that of the rows, 5', in_mm)

   contains

      subroutine check(header, hints, steps)
         character(len=*), intent(in) :: header
         type(map_hints), intent(in) :: hints
         real(wp), intent(in) :: steps(2)

         call read_text(header//nl//text, hints, map)
         call assert_map(map, 6, small_heights, 1.0e-15_wp)
         call assertEqual(steps(1), map%step_x, 1.0e-15_wp, header)
         call assertEqual(steps(2), map%step_y, 1.0e-15_wp, header)
      end subroutine check

   end subroutine test_extents

   subroutine test_markers()
      type(map_hints) :: hints
      type(height_map) :: map
      character(len=:), allocatable :: text, points
      character(len=40) :: line
      integer :: i

      call lines_of(text)
      text = text//'4.1,-99.9999,5.2,-99.9999,6.6,5.9'//nl
      call read_text(text, with_steps, map)
      call assertTrue(has_text(map%notes, '2 points have the same lowest height, -99.9999,'), &
         map%notes)
      call assertTrue(has_text(map%notes, '--missing-value -99.9999 says so'), map%notes)
      hints = with_steps
      hints%has_missing_value = .true.
      hints%missing_value = -99.9999_wp
      call read_text(text, hints, map)
      call assertFalse(allocated(map%notes), 'nothing to say')
      call assert_map(map, 6, [small_heights, 4.1_wp, 9.0_wp, 5.2_wp, 9.0_wp, 6.6_wp, 5.9_wp], &
         1.0e-15_wp)
      call refused('# nodata: -1'//nl//text, 'file: --missing-value -99.9999 contradicts', &
         'by -1.0', hints)
      ! points, and zeros
      points = ''
      do i = 0, 29
         write (line, '(i0, " ", i0, " ", f0.1)') mod(i, 6), i/6, small_heights(i + 1)
         if (i == 7 .or. i == 9) line(5:) = '0'
         points = points//trim(line)//nl
      end do
      call read_text(points, in_mm, map)
      call assertTrue(has_text(map%notes, '--missing-value 0.0 says so'), map%notes)
      hints = in_mm
      hints%has_missing_value = .true.
      call read_text(points, hints, map)
      call assertEqual(2, missing_points(map))
      ! steps of a clipped or a coarse map are no marker
      call read_text(repeat('1 2 3 5 4'//nl//'1 3 2 5 4'//nl, 3), with_steps, map)
      call assertFalse(allocated(map%notes), 'clipped')
   end subroutine test_markers

   subroutine test_unknown()
      character(len=:), allocatable :: text
      type(height_map) :: map

      call lines_of(text, ' ')
      call read_text('Objective: 50x'//nl//'# ---'//nl//'# made by M'//char(252)//'ller'//nl// &
         text, with_steps, map)
      call assert_map(map, 6, small_heights, 1.0e-15_wp)
      call assertEqual('file: not understood in its header, and not used: ''Objective: 50x'', '// &
         '''# made by M?ller''.'//note_end, map%notes)
      call read_text(repeat('# some line'//nl, 7)//text, with_steps, map)
      call assertTrue(has_text(map%notes, 'and 2 lines more.'), map%notes)
      call read_text('# '//repeat('long ', 100)//nl//text, with_steps, map)
      call assertTrue(len(map%notes) < 200, map%notes)
      ! what is written by us is understood
      call read_text('# Heights, a line for each y, the first at y = 0'//nl// &
         '# step_x: 1 mm'//nl//'# step_y: 1 mm'//nl//'# height unit: mm'//nl//text, no_hints, map)
      call assertFalse(allocated(map%notes), 'our own')
   end subroutine test_unknown

   !> A quote alone is no number, and two without anything between are a hole.
   subroutine test_quotes()
      type(height_map) :: map
      integer :: i

      call read_text('"1","2","3","","5"'//nl//repeat('"1","2","3","NaN","5"'//nl, 4), &
         with_steps, map)
      call assert_map(map, 5, [(1.0_wp, 2.0_wp, 3.0_wp, &
         9.0_wp, 5.0_wp, i=1, 5)], 1.0e-15_wp)
      call refused('1 2 3 4 5'//nl//'1 2 3 4 "'//nl, 'file:2:9: ', 'is no number', with_steps)
      call refused('a "'//nl//'"'//nl//'1,2,"'//nl, 'file:3:5: ', 'is no number', with_steps)
   end subroutine test_quotes

   subroutine test_comments()
      character(len=:), allocatable :: text
      type(height_map) :: map

      call lines_of(text, ' ')
      call read_text(text//'# the end'//nl//nl//'#'//nl, with_steps, map)
      call assert_map(map, 6, small_heights, 1.0e-15_wp)
      call refused(text//'# Channel: phase'//nl//text, 'file:7:1: ', 'numbers follow a comment', &
         with_steps)
      call refused('0 0 1'//nl//'# next'//nl//'1 0 2'//nl, 'file:3:1: ', &
         'numbers follow a comment')
   end subroutine test_comments

   !> Six columns are a map of points only if the last three alone are colours.
   subroutine test_colours()
      character(len=*), parameter :: row = '1.5 2 3 4 5 6'//nl
      character(len=:), allocatable :: points
      character(len=40) :: line
      type(height_map) :: map
      integer :: i

      points = ''
      do i = 0, 29
         write (line, '(2(i0, ";"), f0.1, a)') mod(i, 6), i/6, small_heights(i + 1), ';0;255;7'
         points = points//trim(line)//nl
      end do
      call read_text(points, in_mm, map)
      call assert_map(map, 6, small_heights, 1.0e-15_wp)
      call assertTrue(has_text(map%notes, 'taken for red, green and blue'), map%notes)
      ! the count of the points first
      call read_text('30'//nl//points, in_mm, map)
      call assert_map(map, 6, small_heights, 1.0e-15_wp)
      call refused(points//'0;5;1.0;256;0;0'//nl, 'file:31:9: ', 'no whole number from 0 to 255')
      call refused(points//'0;5;1.0;1;0;0.5'//nl, 'file:31:13: ', 'if this is a matrix')
      call refused(points//'0;5;1.0;1;0;'//nl, 'file:31:', 'from 0 to 255')
      ! names say more, and steps make a matrix
      call read_text('x;y;z;a;b;c'//nl//'0;5;1.0;256;0;0.5'//nl//points, in_mm, map)
      call assertFalse(has_text(map%notes//'', 'red'), 'names')
      call read_text('# step: 1 mm'//nl//repeat(row, 5), in_mm, map)
      call assertEqual([6, 5], shape(map%heights), 'a matrix with steps')
      call read_text(repeat('1 2 3 4 5 6'//nl, 5), with_steps, map)
      call assertEqual([6, 5], shape(map%heights), 'a matrix of whole numbers')
      call read_text(repeat('1.5 2 3 4.0 5 6'//nl, 5), with_steps, map)
      call assertEqual([6, 5], shape(map%heights), 'a matrix of others')
      call read_text(repeat('NaN 2 3 4 5 6'//nl, 5), with_steps, map)
      call assertEqual([6, 5], shape(map%heights), 'a matrix with a hole')
   end subroutine test_colours

end module test_height_map_headers
