!> Sound files of every format, which the fuzzing damages.
module fuzz_seeds
   use asperity_error, only: error_type
   use asperity_kinds, only: wp
   use fuzz_zip_writer, only: zip_member_text
   use map_file_write, only: height_map_bytes
   use surface_height_map, only: height_map, missing_height
   implicit none
   private
   public :: add_file, add_written, seed_type, x3p_members

   character(len=*), parameter :: line_end = achar(10)

   !> A file.
   type :: seed_type
      !> Its bytes
      character(len=:), allocatable :: bytes
   end type seed_type

contains

   !> Append a file of test/data/maps.
   subroutine add_file(seeds, name)
      !> The seeds
      type(seed_type), allocatable, intent(inout) :: seeds(:)
      !> Name in the folder
      character(len=*), intent(in) :: name
      type(seed_type) :: seed
      integer :: length, unit, status

      open (newunit=unit, file='test/data/maps/'//name, access='stream', form='unformatted', &
         status='old', action='read', iostat=status)
      if (status /= 0) error stop 'run it in the folder of the project'
      inquire (unit=unit, size=length)
      allocate (character(len=length) :: seed%bytes)
      read (unit) seed%bytes
      close (unit)
      seeds = [seeds, seed]
   end subroutine add_file

   !> Append a map as we write it, or as others do: `esri`, `gwyddion`, `semicolons`, `names`.
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
      map%heights(2, 3) = missing_height
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
      end select
      seeds = [seeds, seed]
   end subroutine add_written

   !> Members of X3P files: descriptions, points, validity.
   subroutine x3p_members(members, kind)
      !> main.xml, the points, their validity
      type(zip_member_text), intent(out) :: members(3)
      !> 0 to 3 for the types of number, 4 for heights in main.xml
      integer, intent(in) :: kind
      character(len=*), parameter :: types = 'ILFDD'
      integer, parameter :: widths(0:4) = [2, 4, 4, 8, 0]
      integer :: i

      members(1)%name = 'main.xml'
      members(2)%name = 'bindata/data.bin'
      members(3)%name = 'bindata/valid.bin'
      members(1)%bytes = '<?xml version="1.0" encoding="UTF-8"?>'//line_end// &
         '<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>'//line_end// &
         '<Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>'//line_end// &
         '<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment></CX>'// &
         '<CY><AxisType>I</AxisType><Increment>2e-6</Increment><Offset>0</Offset></CY>'// &
         '<CZ><AxisType>A</AxisType><DataType>'//types(kind + 1:kind + 1)// &
         '</DataType><Increment>1e-7</Increment><Offset>0.5</Offset></CZ></Axes></Record1>'// &
         '<Record3><MatrixDimension><SizeX>6</SizeX><SizeY>5</SizeY><SizeZ>1</SizeZ>'// &
         '</MatrixDimension>'//line_end
      if (kind < 4) then
         members(1)%bytes = members(1)%bytes//'<DataLink><PointDataLink>bindata/data.bin'// &
            '</PointDataLink><ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>'
      else
         members(1)%bytes = members(1)%bytes//'<DataList>'
         do i = 1, 15
            members(1)%bytes = members(1)%bytes//'<Datum>1;2;'//achar(64 - 16 + mod(i, 10))// &
               '.5</Datum><Datum>-3e-1</Datum>'
         end do
         members(1)%bytes = members(1)%bytes//'</DataList>'
      end if
      members(1)%bytes = members(1)%bytes//'</Record3><Record4/></p:ISO5436_2>'
      members(2)%bytes = ''
      do i = 1, 30*widths(kind)
         members(2)%bytes = members(2)%bytes//char(mod(37*i, 64))
      end do
      members(3)%bytes = char(255)//char(254)//char(127)//char(63)
   end subroutine x3p_members

end module fuzz_seeds
