!> Files of Sensofar and of Gwyddion by formula, byte by byte: 6 x 5 points, the second of the
!> third line missing.
module binary_cases
   use, intrinsic :: iso_fortran_env, only: int32, real32, real64
   use zip_writer, only: zip_member_text
   implicit none
   private
   public :: gsf_file, gwy_array, gwy_field, gwy_file, gwy_object, gwy_text, plu_file, plux_members

   integer, parameter :: nx = 6, ny = 5
   character(len=1), parameter :: nul = achar(0)

contains

   !> Height of a point, in the unit of the file: exact in single precision.
   pure real(real64) function height(i, j)
      integer, intent(in) :: i, j

      height = 0.25_real64*i*i - 1.5_real64*j
   end function height

   !> All heights as singles, with a number for the missing one.
   pure function singles(missing) result(bytes)
      real(real32), intent(in) :: missing
      character(len=4*nx*ny) :: bytes
      real(real32) :: values(nx, ny)
      integer :: i, j

      do j = 1, ny
         do i = 1, nx
            values(i, j) = real(height(i, j), real32)
         end do
      end do
      values(2, 3) = missing
      bytes = transfer(values, bytes)
   end function singles

   pure function word(value) result(bytes)
      integer, intent(in) :: value
      character(len=4) :: bytes

      bytes = transfer(int(value, int32), bytes)
   end function word

   !> A PLU file with one field replaced; steps of 1.5 and 2.5 um, heights in um.
   subroutine plu_file(bytes, offset, field)
      !> The file
      character(len=:), allocatable, intent(out) :: bytes
      !> Bytes before the field, and what it is to have
      integer, intent(in) :: offset
      character(len=*), intent(in) :: field
      character(len=508) :: head

      head = repeat(nul, 508)
      head(:24) = 'Mon Nov 30 09:15:00 2026'
      head(389:396) = word(ny)//word(nx)
      head(405:412) = transfer([1.5_real32, 2.5_real32], repeat(' ', 8))
      head(429:432) = word(3)
      head(449:464) = word(ny)//word(nx)//word(ny)//word(nx)
      head(490:491) = achar(1)//char(251)
      head(501:508) = word(ny)//word(nx)
      ! the least and the largest height
      bytes = head//singles(1000001.0_real32)//transfer([-7.25_real32, 7.5_real32], repeat(' ', 8))
      if (len(field) > 0) bytes(offset + 1:offset + len(field)) = field
   end subroutine plu_file

   !> Members of a PLUX file; steps of 1.5 and 2.5 um, heights in um.
   subroutine plux_members(members)
      !> index.xml, heights, recipe
      type(zip_member_text), intent(out) :: members(3)

      members(2)%name = 'LAYER_0.raw'
      members(2)%bytes = singles(transfer(int(z'7FC00000', int32), 1.0_real32))
      members(1)%name = 'index.xml'
      members(1)%bytes = '<?xml version="1.0" encoding="UTF-8"?>'//achar(10)// &
         '<xml><GENERAL><DATE>Mon Nov 30 09:15:00 2026</DATE><IMAGE_SIZE_X>6</IMAGE_SIZE_X>'// &
         '<IMAGE_SIZE_Y>5</IMAGE_SIZE_Y><FOV_X>1.5</FOV_X><FOV_Y>2.5</FOV_Y></GENERAL>'// &
         achar(10)//'<LAYER_0><FILENAME_STACK>LAYER_0.stack.raw</FILENAME_STACK>'// &
         '<FILENAME_Z>LAYER_0.raw</FILENAME_Z></LAYER_0><INFO/></xml>'
      members(3)%name = './recipe.txt'
      members(3)%bytes = '<xml/>'
   end subroutine plux_members

   !> A GSF file in um, sides of 9 and 12.5, with a line of the header replaced by others.
   subroutine gsf_file(bytes, old, new)
      !> The file
      character(len=:), allocatable, intent(out) :: bytes
      !> What is replaced in the header, and by what
      character(len=*), intent(in) :: old, new
      character(len=:), allocatable :: head
      integer :: at

      head = 'Gwyddion Simple Field 1.0'//achar(10)//'XRes = 6'//achar(10)// &
         'YRes = 5'//achar(10)//'XReal = 9.0e-6'//achar(10)//'YReal = 12.5e-6'//achar(10)// &
         'XYUnits = m'//achar(10)//'ZUnits = um'//achar(10)//'Title = Topography'//achar(10)
      at = index(head, old)
      if (len(old) > 0 .and. at > 0) head = head(:at - 1)//new//head(at + len(old):)
      head = head//repeat(nul, 4 - mod(len(head), 4))
      bytes = head//singles(transfer(int(z'7FC00000', int32), 1.0_real32))
   end subroutine gsf_file

   !> A component of a GWY file that is an object.
   pure function gwy_object(name, type, inside) result(bytes)
      !> Name of the component, its type and what is in it
      character(len=*), intent(in) :: name, type, inside
      character(len=:), allocatable :: bytes

      bytes = name//nul//'o'//type//nul//word(len(inside))//inside
   end function gwy_object

   !> A component that is a text.
   pure function gwy_text(name, text) result(bytes)
      !> Its name and text
      character(len=*), intent(in) :: name, text
      character(len=:), allocatable :: bytes

      bytes = name//nul//'s'//text//nul
   end function gwy_text

   !> The component with the numbers of a field: heights, or 1 where the second point of the third
   !> line is and 0 elsewhere.
   pure function gwy_array(is_mask) result(bytes)
      !> Whether it is the mask
      logical, intent(in) :: is_mask
      character(len=:), allocatable :: bytes
      real(real64) :: values(nx, ny)
      integer :: i, j

      do j = 1, ny
         do i = 1, nx
            values(i, j) = merge(0.0_real64, height(i, j), is_mask)
         end do
      end do
      values(2, 3) = 1.0_real64
      bytes = 'data'//nul//'D'//word(nx*ny)//transfer(values, repeat(' ', 8*nx*ny))
   end function gwy_array

   !> A field of 6 x 5 points and 9 x 12.5 um.
   pure function gwy_field(name, unit, numbers) result(bytes)
      !> Name of the component, unit of its numbers, empty for none, and the component with them
      character(len=*), intent(in) :: name, unit, numbers
      character(len=:), allocatable :: bytes

      bytes = 'xres'//nul//'i'//word(nx)//'yres'//nul//'i'//word(ny)// &
         'xreal'//nul//'d'//transfer(9.0e-6_real64, repeat(' ', 8))// &
         'yreal'//nul//'d'//transfer(12.5e-6_real64, repeat(' ', 8))// &
         gwy_object('si_unit_xy', 'GwySIUnit', gwy_text('unitstr', 'm'))//numbers
      if (unit /= '') bytes = bytes//gwy_object('si_unit_z', 'GwySIUnit', gwy_text('unitstr', unit))
      bytes = gwy_object(name, 'GwyDataField', bytes)
   end function gwy_field

   !> A GWY file with these components, after one of every other kind.
   pure function gwy_file(components) result(bytes)
      !> The components
      character(len=*), intent(in) :: components
      character(len=:), allocatable :: bytes

      bytes = '/0/data/visible'//nul//'b'//achar(1)//'letter'//nul//'cx'// &
         'large'//nul//'q'//repeat(nul, 8)//'letters'//nul//'C'//word(3)//'abc'// &
         'words'//nul//'I'//word(2)//word(7)//word(8)//'larger'//nul//'Q'//word(1)// &
         repeat(nul, 8)//'texts'//nul//'S'//word(2)//'one'//nul//repeat('long', 300)//nul// &
         'objects'//nul//'O'//word(1)//'GwyThing'//nul//word(2)//'ab'
      bytes = 'GWYP'//'GwyContainer'//nul//word(len(bytes) + len(components))//bytes//components
   end function gwy_file

end module binary_cases
