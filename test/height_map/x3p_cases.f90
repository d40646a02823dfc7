!> Contents of X3P files by formula.
module x3p_cases
   use zip_writer, only: zip_member_text
   implicit none
   private
   public :: x3p_members

   character(len=*), parameter :: line_end = achar(10)

contains

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

end module x3p_cases
