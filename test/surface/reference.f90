!> Parameters of the maps of test/data/surface_reference.txt, computed by
!> test/reference/surface_reference.py from the words of the definitions.
module test_surface_reference
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use asperity_surface_parameters_from_sums, only: parameters_of
   use asperity_surface_parameters_parameters, only: n_parameters, p_direction, p_ssk, parameters
   use asperity_surface_parameters_sum_tiles, only: sum_map
   use asperity_surface_parameters_tile_sums, only: summed, surface_sums_type
   use asperity_surface_prepare_level, only: level_plane, remove_form
   use asperity_surface_summits_find, only: find_summits, summit_set
   use extremes, only: worsen
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   implicit none
   private
   public :: suite_surface_reference

   !> Unit of the heights, mm, and what stands for a missing one
   real(wp), parameter :: unit_of_heights = 1.0e-5_wp
   integer, parameter :: missing = -1000000
   !> Largest relative difference: rounding of sums, above a plane a hundred times as high as Sq
   real(wp), parameter :: tolerance = 1.0e-11_wp

   !> A map and what is known of it.
   type :: reference_map
      character(len=16) :: name = ''
      type(height_map) :: map
      real(wp) :: share = 0.0_wp
      integer :: degree = 1
      !> Parameters in the order of the table
      real(wp) :: values(n_parameters) = none
   end type reference_map

contains

   function suite_surface_reference() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_reference')
      call suite%addTest(TestMethod('maps of the second implementation', test_maps))
   end function suite_surface_reference

   subroutine test_maps()
      type(reference_map) :: reference
      character(len=:), allocatable :: message
      character(len=1024) :: folder
      real(wp) :: worst
      integer :: unit, status, maps

      call get_environment_variable('ASPERITY_TEST_DATA', folder, status=status)
      if (status /= 0) folder = 'test/data'
      open (newunit=unit, file=trim(folder)//'/surface_reference.txt', status='old', &
         action='read', iostat=status)
      call assertEqual(0, status, 'surface_reference.txt')
      if (status /= 0) return
      maps = 0
      worst = 0.0_wp
      do
         call read_map(unit, reference, message)
         if (message == 'none') exit
         call assertEqual('', message)
         if (message /= '') exit
         maps = maps + 1
         call compare(reference, worst)
      end do
      close (unit)
      call assertEqual(6, maps, 'maps')
      call record('surface.parameters.relative_error', worst)
   end subroutine test_maps

   !> The parameters of one map, summed over tiles.
   subroutine compare(reference, worst)
      type(reference_map), intent(inout) :: reference
      real(wp), intent(inout) :: worst
      type(error_type), allocatable :: error
      type(summit_set) :: summits
      type(surface_sums_type), allocatable :: sums(:)
      real(wp) :: found(n_parameters), off
      integer :: p

      associate (map => reference%map, expected => reference%values)
         call level_plane(map)
         if (reference%degree > 1) call remove_form(map, reference%degree, error)
         call assertFalse(allocated(error), trim(reference%name)//': form')
         call find_summits(map, reference%share, summits, error)
         call assertFalse(allocated(error), trim(reference%name)//': summits')
         call sum_map(map, summits, 3, 2, sums)
         call parameters_of(summed(sums), map%step_x*map%step_y, found)
         do p = 1, n_parameters
            call assertTrue(max(found(p), expected(p)) < none, label(p))
            if (max(found(p), expected(p)) >= none) cycle
            if (p == p_direction) then
               off = abs(modulo(found(p) - expected(p) + 90.0_wp, 180.0_wp) - 90.0_wp)/180.0_wp
            else if (p == p_ssk) then
               off = abs(found(p) - expected(p))
            else
               off = abs(found(p)/expected(p) - 1.0_wp)
            end if
            call worsen(worst, off)
            call assertLessThan(off, tolerance, label(p))
         end do
      end associate

   contains

      pure function label(p) result(text)
         integer, intent(in) :: p
         character(len=:), allocatable :: text

         text = trim(reference%name)//' '//trim(parameters(p)%name)
      end function label

   end subroutine compare

   !> Read the next map. `message` is `none` after the last one, empty when all is well.
   subroutine read_map(unit, reference, message)
      integer, intent(in) :: unit
      type(reference_map), intent(out) :: reference
      character(len=:), allocatable, intent(out) :: message
      integer, allocatable :: heights(:, :)
      character(len=16) :: name
      character(len=64) :: line
      real(wp) :: value
      integer :: nx, ny, p, status

      message = 'none'
      read (unit, *, iostat=status) reference%name, nx, ny, reference%map%step_x, &
         reference%map%step_y, reference%share, reference%degree
      if (status /= 0) return
      message = ''
      reference%map%source = trim(reference%name)
      allocate (heights(nx, ny))
      read (unit, *, iostat=status) heights
      if (status /= 0) message = trim(reference%name)//': heights'
      reference%map%heights = merge(none, unit_of_heights*heights, heights == missing)
      do while (message == '')
         read (unit, '(a)', iostat=status) line
         if (line == 'end') exit
         if (status == 0) read (line, *, iostat=status) name, value
         if (status /= 0) message = trim(reference%name)//': parameters'
         p = findloc(parameters%name == name, .true., 1)
         if (p == 0) message = trim(reference%name)//': unknown '//name
         if (p > 0) reference%values(p) = value
      end do
   end subroutine read_map

end module test_surface_reference
