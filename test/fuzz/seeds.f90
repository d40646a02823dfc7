!> Sound files of every format, which the fuzzing damages.
module fuzz_seeds
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use asperity_height_map_write, only: height_map_bytes
   use binary_cases, only: gsf_file, gwy_array, gwy_field, gwy_file, gwy_text, plu_file
   implicit none
   private
   public :: add_file, add_written, seed_type

   character(len=*), parameter :: line_end = achar(10)

   !> A file.
   type :: seed_type
      !> Its bytes
      character(len=:), allocatable :: bytes
   end type seed_type

contains

   !> Append a file of test/data.
   subroutine add_file(seeds, name)
      !> The seeds
      type(seed_type), allocatable, intent(inout) :: seeds(:)
      !> Name there, with its folder
      character(len=*), intent(in) :: name
      type(seed_type) :: seed
      integer :: length, unit, status

      open (newunit=unit, file='test/data/'//name, access='stream', form='unformatted', &
         status='old', action='read', iostat=status)
      if (status /= 0) error stop 'run it in the folder of the project'
      inquire (unit=unit, size=length)
      allocate (character(len=length) :: seed%bytes)
      read (unit) seed%bytes
      close (unit)
      seeds = [seeds, seed]
   end subroutine add_file

   !> Append a map as we write it, or as others do: `esri`, `gwyddion`, `semicolons`, `names`,
   !> `axes`, `factor`, `quoted`, `column`, `plu`, `gwy`, `gsf`, `keyence`, `wyko`, `spip`,
   !> `surfer`.
   subroutine add_written(seeds, form)
      !> The seeds
      type(seed_type), allocatable, intent(inout) :: seeds(:)
      !> Form of the file
      character(len=*), intent(in) :: form
      type(seed_type) :: seed
      type(height_map) :: map
      type(error_type), allocatable :: error
      integer :: i, j

      allocate (map%heights(6, 5))
      map%source = 'seed'
      map%step_x = 0.001_wp
      map%step_y = 0.002_wp
      do j = 1, 5
         do i = 1, 6
            map%heights(i, j) = 0.001_wp*i*i - 0.0003_wp*j*i
         end do
      end do
      map%heights(2, 3) = none
      select case (form)
      case ('sdf', 'xyz', 'csv')
         call height_map_bytes(map, form, seed%bytes, error)
         if (allocated(error)) error stop error%message
      case ('esri')
         seed%bytes = 'ncols 6'//line_end//'nrows 5'//line_end//'xllcorner 0.0'//line_end// &
            'yllcorner 0.0'//line_end//'cellsize 0.5'//line_end//'nodata_value -9999'//line_end// &
            repeat('1 2.5 3e-1 -9999 5 6 '//line_end, 5)
      case ('gwyddion')
         seed%bytes = '# Channel: Height'//line_end//'# Width: 10.0 '//char(194)//char(181)//'m'// &
            line_end//'# Height: 10.0 um'//line_end//'# Value units: m'//line_end// &
            repeat('1.0e-6'//achar(9)//'2e-6'//achar(9)//'NaN'//achar(9)//'4e-7'//achar(9)//'0'// &
            line_end, 6)
      case ('semicolons')
         seed%bytes = repeat('1.25;;-3;4e1;5;'//achar(13)//line_end, 7)
      case ('names')
         seed%bytes = 'X [um],Y [um],Z [nm]'//achar(13)//line_end
         do j = 1, 5
            do i = 1, 5
               seed%bytes = seed%bytes//achar(48 + i)//'.5, '//achar(48 + j)//', '// &
                  achar(48 + mod(i*j, 10))//line_end
            end do
         end do
      case ('axes')
         seed%bytes = ',0,2.5,5,7.5,10,12.5'//line_end
         do j = 1, 5
            seed%bytes = seed%bytes//achar(48 + 2*j - 2)//',8.1,9.7,7.2,8.9,'//achar(48 + j)// &
               '.3,9.4'//line_end
         end do
      case ('column')
         seed%bytes = '7'//line_end//repeat('-1.25'//line_end//'3.5e-1'//line_end, 3)//'nan'// &
            line_end
      case ('factor')
         seed%bytes = 'h=6 w=5'//line_end//'pixel size=2.5e-006 m'//line_end//'data unit=rad'// &
            line_end//'height conversion factor (-> m)=6.3e-008'//line_end//'Objective: 50x'// &
            line_end//repeat('186.8 18.5 19.3 0 -1.5e2'//line_end, 6)//'# end'//line_end
      case ('quoted')
         seed%bytes = '"","y_um","x_um","Height/nm","note"'//line_end
         do j = 1, 5
            do i = 1, 5
               seed%bytes = seed%bytes//'"7","'//achar(48 + j)//'","'//achar(48 + i)//'.5","'// &
                  achar(48 + mod(i*j, 10))//'","good"'//line_end
            end do
         end do
      case ('plu')
         call plu_file(seed%bytes, 0, '')
      case ('gsf')
         call gsf_file(seed%bytes, '', '')
      case ('gwy')
         seed%bytes = gwy_file(gwy_text('/1/data/title', 'Height')// &
            gwy_field('/1/mask', '', gwy_array(.true.))// &
            gwy_field('/1/data', 'um', gwy_array(.false.))// &
            gwy_field('/0/data', 'V', gwy_array(.false.)))
      case ('keyence')
         seed%bytes = '"Data type";"ImageDataCsv"'//line_end//'"XY-Kal";"2,5";"um"'//line_end// &
            '"Bild";"H'//char(246)//'he"'//line_end//'"H";"5"'//line_end//'"V";"5"'//line_end// &
            'a;1'//line_end//'b;2'//line_end//'"E";"'//char(181)//'m"'//line_end//line_end// &
            '"H"'//line_end//repeat('"1,5";"2";"";"0,25";"-3"'//line_end, 5)
      case ('wyko')
         seed%bytes = 'Wyko ASCII Data File Format 1 1 1'//line_end//'X Size'//achar(9)//'5'// &
            line_end//'Y Size'//achar(9)//'5'//line_end//'Pixel_size'//achar(9)//'7'//achar(9)// &
            '4'//achar(9)//'1'//line_end//'OPD'//achar(9)//'3'//achar(9)//'100'//line_end
         do j = 1, 5
            do i = 1, 5
               seed%bytes = seed%bytes//achar(48 + j)//achar(9)//achar(48 + i)//achar(9)// &
                  achar(48 + mod(i*j, 10))//'.5'//line_end
            end do
         end do
         seed%bytes = seed%bytes//'Intensity'//achar(9)//'3'//achar(9)//'100'//line_end
      case ('spip')
         seed%bytes = '# File Format = ASCII'//line_end//'# x-pixels = 6'//line_end// &
            '# y-pixels = 5'//line_end//'# x-length = 12'//line_end//'# y-length = 15'// &
            line_end//'# Bit2nm = 2.0'//line_end//'# voidpixels = 1'//line_end// &
            '# Start of Data:'//line_end//repeat('1 2.5 -3e1 4 7 6 2 8'//line_end//'4 1'// &
            line_end, 3)//repeat('0 0 0 1 0'//line_end, 6)
      case ('surfer')
         seed%bytes = 'DSAA'//line_end//'5 6'//line_end//'0 1'//line_end//'-1 2e3'//line_end// &
            '0 1'//line_end//repeat('1.5 2 1.70141e+038'//line_end//'4 5.5'//line_end, 6)
      case default
         error stop 'no such form'
      end select
      seeds = [seeds, seed]
   end subroutine add_written

end module fuzz_seeds
