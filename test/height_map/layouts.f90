!> Texts of heights as other programs lay them out: axes around them, and files of all layouts.
module test_height_map_layouts
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_read, only: map_hints, read_height_map
   use asperity_height_map_type, only: height_map, missing_points
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: assert_map, has_text, nl, no_hints, read_text, refused, &
      small_heights, small_rows, with_steps
   implicit none
   private
   public :: suite_map_layouts

   character(len=*), parameter :: folder = 'test/data/scans/'

contains

   function suite_map_layouts() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map layouts')
      call suite%addTest(TestMethod('files of the scans', test_scans))
      call suite%addTest(TestMethod('files of Gwyddion', test_gwyddion))
      call suite%addTest(TestMethod('axes around a matrix', test_axes))
      call suite%addTest(TestMethod('units of axes', test_units_of_axes))
      call suite%addTest(TestMethod('numbers on one side', test_one_side))
      call suite%addTest(TestMethod('heights that look like axes', test_genuine))
   end function suite_map_layouts

   !> Every file has the same heights. Allowed is the rounding of its figures: 1e-4 um and less,
   !> holography 1e-6 rad of 6.3e-5 mm; SUR's whole numbers are nm, half of one is allowed.
   subroutine test_scans()
      type(map_hints), parameter :: um = map_hints(height_unit='um')
      type(map_hints), parameter :: both = map_hints('um', 'um')
      type(map_hints), parameter :: steps = map_hints('', 'um', 0.0025_wp, 0.002_wp)
      type(height_map) :: truth

      call read('truth_mm.csv', map_hints('', 'mm', 0.0025_wp, 0.002_wp), truth)
      call check('pandas_index.csv', steps, 0.002_wp, 0, 1.0e-15_wp)
      call check('axes_in_matrix.csv', steps, 0.002_wp, 0, 1.0e-15_wp)
      call check('axes_in_matrix.csv', both, 0.002_wp, 0, 1.0e-15_wp)
      call check('holography_factor.txt', no_hints, 0.0025_wp, 0, 1.0e-10_wp)
      call check('holography_factor.txt', map_hints('', 'um', 0.0025_wp, 0.0025_wp), 0.0025_wp, 0, &
         1.0e-10_wp)
      call check('width_in_points.txt', both, 0.0025_wp, 0, 1.0e-15_wp)
      call check('width_in_points.txt', map_hints('', 'um', 0.0025_wp, 0.0025_wp), 0.0025_wp, 0, &
         1.0e-15_wp)
      call check('y_first.csv', no_hints, 0.002_wp, 0, 1.0e-15_wp)
      call check('quoted.csv', both, 0.002_wp, 0, 1.0e-15_wp)
      call check('count_first.pts', both, 0.002_wp, 0, 1.0e-15_wp)
      call check('colours.xyz', both, 0.002_wp, 0, 1.0e-15_wp)
      call check('folder.x3p', no_hints, 0.002_wp, 0, 1.0e-15_wp)
      call check('comment_at_end.txt', no_hints, 0.002_wp, 0, 1.0e-15_wp)
      call check('esri_broken_lines.asc', map_hints('mm', 'um'), 0.0025_wp, 0, 1.0e-15_wp)
      call check('esri_nodata_nan.asc', map_hints('mm', 'um'), 0.0025_wp, 3, 1.0e-15_wp)
      call check_five_figures()
      call check('end_mark.xyz', map_hints('mm', 'um'), 1.0_wp, 3, 1.0e-15_wp)
      call check('bcr_doubles.sdf', no_hints, 0.002_wp, 3, 1.0e-15_wp)
      call check('bytes_behind.sur', no_hints, 0.002_wp, 0, 5.1e-7_wp)
      call check('two_objects.sur', no_hints, 0.002_wp, 0, 5.1e-7_wp)
      call refuse('percent.sur', um, 'byte 212: the unit of z is %')
      call refuse('profile.txt', no_hints, 'in which unit its heights are')
      ! the lengths are right, and so is what the user says
      call read('width_and_step.txt', map_hints(step_x=0.02_wp, step_y=0.02_wp), truth)
      call assertEqual([32, 16], shape(truth%heights))

   contains

      subroutine check(name, hints, step_y, missing, tolerance)
         character(len=*), intent(in) :: name
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
         call assertEqual(step_y, map%step_y, 1.0e-9_wp, name)
         if (step_y < 1.0_wp) call assertEqual(0.0025_wp, map%step_x, 1.0e-9_wp, name)
         call assertEqual(missing, missing_points(map), name)
         expected = truth%heights
         do i = 1, 3
            if (missing > 0) expected(holes(1, i), holes(2, i)) = none
         end do
         call assertTrue(all(abs(map%heights - expected) <= tolerance), name)
      end subroutine check

      !> Coordinates 1 mm from the origin in metres: their last figure is 1e-4 mm; heights are 10 um
      !> high, so that theirs is 1e-6 mm. Half of it may be lost, of the step over 23 and 17 steps.
      subroutine check_five_figures()
         type(height_map) :: map

         call read('gwyddion_5_figures.xyz', map_hints('m', 'm'), map)
         call assertEqual([24, 18], shape(map%heights))
         if (any(shape(map%heights) /= [24, 18])) return
         call assertTrue(all(abs(map%heights - truth%heights) <= 5.1e-7_wp), 'five figures')
         call assertEqual(0.000965_wp, map%step_x, 1.0e-4_wp/23.0_wp)
         call assertEqual(0.000965_wp, map%step_y, 1.0e-7_wp)
         call assertTrue(has_text(map%notes, 'x is rounded to 1.0E-7 by its figures'), map%notes)
         call assertFalse(has_text(map%notes, 'y is rounded'), map%notes)
      end subroutine check_five_figures

      subroutine read(name, hints, map)
         character(len=*), intent(in) :: name
         type(map_hints), intent(in) :: hints
         type(height_map), intent(out) :: map
         type(error_type), allocatable :: error

         call read_height_map(folder//name, hints, map, error)
         if (allocated(error)) then
            call assertEqual('', error%message)
            allocate (map%heights(0, 0))
         end if
      end subroutine read

      subroutine refuse(name, hints, part)
         character(len=*), intent(in) :: name, part
         type(map_hints), intent(in) :: hints
         type(height_map) :: map
         type(error_type), allocatable :: error

         call read_height_map(folder//name, hints, map, error)
         call assertTrue(allocated(error), name)
         if (allocated(error)) call assertTrue(has_text(error%message, part), error%message)
      end subroutine refuse

   end subroutine test_scans

   !> What Gwyddion wrote: texts on desktops of nine languages, with five figures. It prints lengths
   !> in whole um, of which nothing is said where the steps are.
   subroutine test_gwyddion()
      character(len=*), parameter :: languages(*) = ['cs', 'de', 'es', 'fr', 'it', 'ja', 'ko', &
         'pt', 'ru']
      integer :: k

      do k = 1, size(languages)
         call check(languages(k)//'.txt', map_hints(step_x=0.0025_wp, step_y=0.002_wp))
         call check(languages(k)//'.xyz', no_hints)
      end do
      ! BCR's first line is at the largest y, Gwyddion's is the top one; SUR's scale is a single
      call check('small.sdf', no_hints, is_turned=.true.)
      call check('small.sur', no_hints, 1.0e-9_wp)

   contains

      subroutine check(name, hints, tolerance, is_turned)
         character(len=*), intent(in) :: name
         type(map_hints), intent(in) :: hints
         real(wp), intent(in), optional :: tolerance
         logical, intent(in), optional :: is_turned
         real(wp) :: allowed
         type(height_map) :: map
         type(error_type), allocatable :: error

         call read_height_map('test/data/gwyddion/'//name, hints, map, error)
         call assertFalse(allocated(error), name)
         if (allocated(error)) return
         allowed = 1.0e-15_wp
         if (present(tolerance)) allowed = tolerance
         if (present(is_turned)) map%heights = map%heights(:, size(map%heights, 2):1:-1)
         call assert_map(map, 6, 1.0e-3_wp*small_heights, allowed)
         call assertEqual([0.0025_wp, 0.002_wp], [map%step_x, map%step_y], 1.0e-15_wp, name)
         call assertFalse(allocated(map%notes), name)
      end subroutine check

   end subroutine test_gwyddion

   !> Numbers in front of each row, if there are any, below a first line.
   subroutine framed(first, numbers, text, separator)
      character(len=*), intent(in) :: first
      character(len=*), intent(in) :: numbers(:)
      character(len=:), allocatable, intent(out) :: text
      character(len=1), intent(in), optional :: separator
      integer :: i

      text = first
      do i = 1, size(small_rows)
         if (size(numbers) > 0) text = text//trim(numbers(i))//','
         text = text//small_rows(i)//nl
      end do
      if (.not. present(separator)) return
      do i = 1, len(text)
         if (text(i:i) == ',') text(i:i) = separator
      end do
   end subroutine framed

   !> The heights are `small_heights`, reversed along y or x if asked, and `part` is said.
   subroutine check_frame(text, hints, steps, part, is_turned)
      character(len=*), intent(in) :: text, part
      type(map_hints), intent(in) :: hints
      real(wp), intent(in) :: steps(2)
      logical, intent(in), optional :: is_turned(2)
      type(height_map) :: map
      integer :: block_length

      do block_length = 20, 2000, 660
         call read_text(text, hints, map, block_length)
         call assertEqual([6, 5], shape(map%heights), text)
         if (any(shape(map%heights) /= [6, 5])) return
         if (present(is_turned)) then
            if (is_turned(1)) map%heights = map%heights(6:1:-1, :)
            if (is_turned(2)) map%heights = map%heights(:, 5:1:-1)
         end if
         call assert_map(map, 6, small_heights, 1.0e-15_wp)
         call assertEqual(steps(1), map%step_x, 1.0e-14_wp)
         call assertEqual(steps(2), map%step_y, 1.0e-14_wp)
         call assertTrue(allocated(map%notes), text)
         if (allocated(map%notes)) call assertTrue(has_text(map%notes, part), map%notes)
      end do
   end subroutine check_frame

   subroutine test_axes()
      character(len=*), parameter :: counted(5) = ['0', '1', '2', '3', '4']
      character(len=*), parameter :: axis(5) = [character(len=4) :: '10', '12.5', '15', '17.5', &
         '20']
      character(len=*), parameter :: falling(5) = ['9', '7', '5', '3', '1']
      character(len=:), allocatable :: text
      type(height_map) :: map
      real(wp), parameter :: steps(2) = [0.5_wp, 0.25_wp]

      call framed(',0,1,2,3,4,5'//nl, counted, text)
      call check_frame(text, with_steps, steps, 'first line counts the columns')
      call check_frame(text, with_steps, steps, 'first column counts the rows')
      call framed(';1,2,3,4,5,6'//nl, counted, text, ';')
      call check_frame(text, with_steps, steps, 'first column counts the rows')
      call framed('"","0","1","2","3","4","5"'//nl, ['"0"', '"1"', '"2"', '"3"', '"4"'], text)
      call check_frame(text, with_steps, steps, 'first line counts the columns')
      call framed('index,1,2,3,4,5,6'//nl, counted, text)
      call check_frame(text, with_steps, steps, 'first line counts the columns')
      call framed('y/x,0,2,4,6,8,10'//nl, axis, text)
      call check_frame(text, map_hints('um', 'mm'), [0.002_wp, 0.0025_wp], &
         'first column is the axis of y, from 10.0 in steps of 2.5')
      ! rounded figures
      call framed(',0,0.33,0.67,1,1.33,1.67'//nl, axis, text, achar(9))
      call check_frame(text, map_hints('um', 'mm'), [0.000334_wp, 0.0025_wp], 'the axis of x')
      ! down and to the left
      call framed(',0,2,4,6,8,10'//nl, falling, text)
      call check_frame(text, map_hints('um', 'mm'), [0.002_wp, 0.002_wp], 'in steps of -2.0', &
         [.false., .true.])
      call framed(',10,8,6,4,2,0'//nl, falling, text)
      call check_frame(text, map_hints('um', 'mm'), [0.002_wp, 0.002_wp], 'the axis of x', &
         [.true., .true.])
      ! a number in the corner, and axes far from the heights
      call framed('0,100,102,104,106,108,110'//nl, ['90', '92', '94', '96', '98'], text)
      call check_frame(text, map_hints('um', 'mm'), [0.002_wp, 0.002_wp], 'the axis of x')
      call framed('NaN,100,102,104,106,108,110'//nl, ['90', '92', '94', '96', '98'], text)
      call check_frame(text, map_hints('um', 'mm'), [0.002_wp, 0.002_wp], 'the axis of x')
      ! or among them
      call framed('NaN,1,2,3,4,5,6'//nl, counted, text)
      call read_text(text, with_steps, map)
      call assertEqual([7, 6], shape(map%heights))
      call assertTrue(has_text(map%notes, 'was taken for heights'), map%notes)
      ! axes far beyond all heights
      call framed(',0,2e7,4e7,6e7,8e7,10e7'//nl, ['0e7', '2e7', '4e7', '6e7', '8e7'], text)
      call check_frame(text, map_hints('nm', 'mm'), [20.0_wp, 20.0_wp], 'the axis of x')
   end subroutine test_axes

   subroutine test_units_of_axes()
      character(len=*), parameter :: axis(5) = [character(len=4) :: '10', '12.5', '15', '17.5', &
         '20']
      character(len=:), allocatable :: text

      call framed(',0,2,4,6,8,10'//nl, axis, text)
      call refused(text, 'file: ', 'its axes are: say it with --lateral-unit', &
         map_hints(height_unit='mm'))
      call check_frame(text, map_hints('', 'mm', 0.002_wp, 0.0025_wp), [0.002_wp, 0.0025_wp], &
         '0.002 mm is the step')
      call check_frame('# xy unit: nm'//nl//text, map_hints(height_unit='mm'), &
         [2.0e-6_wp, 2.5e-6_wp], 'the axis of x')
      call refused(text, 'file: --step contradicts the axes', 'steps are 2.0 and 2.5', &
         map_hints('', 'mm', 0.002_wp, 0.002_wp))
      call refused(text, 'file: --step 0.003 mm contradicts', 'whose step in x is 0.002', &
         map_hints('um', 'mm', 0.003_wp, 0.0025_wp))
      ! columns that count say no step
      call framed(',0,1,2,3,4,5'//nl, axis, text)
      call refused(text, 'file: ', 'distance of its points in x', map_hints('um', 'mm'))
      call check_frame(text, map_hints('um', 'mm', 0.001_wp, 0.0025_wp), [0.001_wp, 0.0025_wp], &
         'counts the columns')
   end subroutine test_units_of_axes

   !> pandas with header=False, with index=False; R; each stands off the heights or has no name.
   subroutine test_one_side()
      character(len=*), parameter :: counted(5) = ['1', '2', '3', '4', '5']
      character(len=:), allocatable :: text
      real(wp), parameter :: steps(2) = [0.5_wp, 0.25_wp]

      call framed('"","V1","V2","V3","V4","V5","V6"'//nl, counted, text)
      call check_frame(text, with_steps, steps, 'first column counts the rows')
      call framed('V1,V2,V3,V4,V5,V6'//nl, counted, text)
      call check_frame(text, with_steps, steps, 'first column counts the rows')
      call smooth('', .true., text)
      call check_smooth(text, 'first column counts the rows')
      call smooth('0,1,2,3,4,5'//nl, .false., text)
      call check_smooth(text, 'first line counts the columns')

   contains

      !> 20 + i j/10, with numbers in front
      subroutine smooth(first, has_numbers, lines)
         character(len=*), intent(in) :: first
         logical, intent(in) :: has_numbers
         character(len=:), allocatable, intent(out) :: lines
         character(len=60) :: line
         integer :: i, j

         lines = first
         do j = 1, 6
            write (line, '(*(f5.2, :, ","))') (20.0_wp + 0.01_wp*(i*j)**2, i=1, 6)
            if (has_numbers) lines = lines//achar(47 + j)//','
            lines = lines//trim(line)//nl
         end do
      end subroutine smooth

      subroutine check_smooth(lines, part)
         character(len=*), intent(in) :: lines, part
         type(height_map) :: map
         integer :: i, j

         call read_text(lines, with_steps, map)
         call assertEqual([6, 6], shape(map%heights), lines)
         if (any(shape(map%heights) /= [6, 6])) return
         call assertTrue(all(abs(map%heights - reshape([((20.0_wp + 0.01_wp*(i*j)**2, i=1, 6), &
            j=1, 6)], [6, 6])) < 1.0e-12_wp), lines)
         call assertTrue(has_text(map%notes, part), map%notes)
      end subroutine check_smooth

   end subroutine test_one_side

   !> Maps by formula: none of their lines is an axis. What may be one is told.
   subroutine test_genuine()
      integer, parameter :: sizes(4) = [5, 6, 9, 40]
      integer :: k, formula

      do k = 1, size(sizes)
         do formula = 1, 9
            call check(formula, sizes(k), .false.)
            call check(formula, sizes(k), .true.)
         end do
      end do

   contains

      subroutine check(formula, n, without_corner)
         integer, intent(in) :: formula, n
         logical, intent(in) :: without_corner
         type(height_map) :: map
         character(len=:), allocatable :: text
         character(len=24) :: number
         integer :: i, j

         text = ''
         do j = 1, n
            do i = 1, n
               write (number, '(f0.6)') height(formula, i - 1, j - 1)
               if (without_corner .and. i*j == 1) number = 'NaN'
               text = text//trim(number)//merge(nl, ' ', i == n)
            end do
         end do
         call read_text(text, with_steps, map)
         write (number, '(a, i0)') 'formula ', formula
         call assertEqual([n, n], shape(map%heights), number)
         ! a parabola along each line, and integers, are told at most
         if (allocated(map%notes)) call assertTrue(has_text(map%notes, 'was taken for heights') &
            .and. formula > 6, trim(number)//', '//map%notes)
      end subroutine check

      pure real(wp) function height(formula, i, j)
         integer, intent(in) :: formula, i, j

         select case (formula)
         case (1)
            height = 1.0_wp*i + 1.0_wp*j
         case (2)
            height = 3.0_wp + 0.5_wp*i - 0.25_wp*j
         case (3)
            height = i*j
         case (4)
            height = i*i + 2.0_wp*j
         case (5)
            height = i
         case (6)
            height = sin(0.7_wp*i) + cos(0.4_wp*j*i) + 0.1_wp*i
         case (7)
            ! a plane in whole numbers
            height = anint(1.04_wp*i + 1.96_wp*j)
         case (8)
            height = i + j + 0.1_wp*(i*j)**2
         case default
            height = anint(1.3_wp*i + 0.9_wp*j)
         end select
      end function height

   end subroutine test_genuine

end module test_height_map_layouts
