!> Formats that are not read are named with what to do, by the first bytes that their documentation
!> gives; texts that begin like one are still read.
module test_height_map_formats
   use asperity_base_error, only: error_type
   use asperity_height_map_read, only: read_height_map_bytes
   use asperity_height_map_type, only: height_map
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use map_file_cases, only: has_text, nl, no_hints, read_text, refused, with_steps
   use zip_writer, only: zip_member_text, zip_of
   implicit none
   private
   public :: suite_map_formats

   character(len=1), parameter :: nul = achar(0)
   character(len=*), parameter :: gwyddion = 'open it in Gwyddion', &
      software = 'instrument''s software', &
      numpy = 'numpy.savetxt'

contains

   function suite_map_formats() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map formats')
      call suite%addTest(TestMethod('instruments that Gwyddion reads', test_gwyddion))
      call suite%addTest(TestMethod('other instruments', test_others))
      call suite%addTest(TestMethod('data, pictures, packed files', test_data))
      call suite%addTest(TestMethod('meshes and clouds', test_meshes))
      call suite%addTest(TestMethod('archives', test_archives))
      call suite%addTest(TestMethod('igor waves by their name', test_igor))
      call suite%addTest(TestMethod('texts that begin alike', test_texts))
   end function suite_map_formats

   !> A file that begins so is refused by its name, with the remedy.
   subroutine check(code, name, remedy)
      character(len=*), intent(in) :: code, name, remedy

      call refused(code//repeat(nul//'x', 300), 'file: is '//name, remedy, no_hints)
      ! as short as it can be
      call refused(code//nul, 'file: is '//name, remedy, no_hints)
   end subroutine check

   subroutine test_gwyddion()
      call check('GWYO', 'an old Gwyddion file (.gwy), which is not read: ', gwyddion)
      call check('AliconaImaging'//nul//achar(13)//nl, 'an Alicona file (.al3d)', gwyddion)
      call check('fileformat = bcrf'//nl, 'an Image Metrology file (.bcr', gwyddion)
      call check('fileformat = bcrstm'//nl, 'an Image Metrology file (.bcr', gwyddion)
      call check(char(255)//char(254)//wide('fileformat = bcrf_unicode'), 'an Image Metrology', &
         gwyddion)
      call check(wide('fileformat = bcrf_unicode'), 'an Image Metrology file (.bcrf)', gwyddion)
      call check('\*File list'//nl, 'a Bruker Nanoscope file', gwyddion)
      call check('\*EC File list'//nl, 'a Bruker Nanoscope file', gwyddion)
      call check('?*File list'//nl, 'a Bruker Nanoscope file', gwyddion)
      call check('FRTM_GLIDERV1.00', 'a MicroProf file (.frt)', gwyddion)
      call check('fileType      Image'//nl, 'a PicoView file (.mi)', gwyddion)
      call check('[DataSet]'//nl, 'a Nanosurf file (.nid, .ezd)', gwyddion)
      call check(achar(1)//nul//'Directory', 'a Wyko file (.opd)', gwyddion)
      call check('VCA DATA'//achar(1)//nul//nul//'U', 'a Bruker Vision or Dektak file (.opdx)', &
         gwyddion)
      call check('WSxM file copyright UAM', 'a WSxM file (.stp, .top)', gwyddion)
      call check(char(136)//achar(27)//achar(3)//'o', 'a Zygo MetroPro file (.dat)', gwyddion)
      call check(char(136)//achar(27)//achar(3)//'p', 'a Zygo MetroPro file (.dat)', gwyddion)
      call check(char(136)//achar(27)//achar(3)//'q', 'a Zygo MetroPro file (.dat)', gwyddion)
      call check('VK3_', 'a Keyence file (.vk3)', gwyddion)
      call check('VK4_', 'a Keyence file (.vk4)', gwyddion)
      call check('VK6', 'a Keyence file (.vk6)', gwyddion)
      call check('VK7', 'a Keyence file (.vk7)', gwyddion)
      call check('OLYMPUSRAWFORMAT', 'an Olympus file (.oir)', gwyddion)
      call check(achar(1)//char(176)//char(147)//char(255), 'an NT-MDT file (.mdt)', gwyddion)
      call check(':NANONIS_VERSION:', 'a Nanonis file (.sxm)', gwyddion)
   end subroutine test_gwyddion

   !> A text in UTF-16.
   pure function wide(text)
      character(len=*), intent(in) :: text
      character(len=2*len(text)) :: wide
      integer :: i

      do i = 1, len(text)
         wide(2*i - 1:2*i) = text(i:i)//nul
      end do
   end function wide

   subroutine test_others()
      call check('KPK0', 'a Keyence file (.zon)', software)
      call check('KPK1', 'a Keyence file (.zon)', software)
      call check('Binary TrueMap Data File v2.0'//achar(13)//nl, 'a TrueMap or GelSight file', &
         software)
      call check('Zeta-Instruments', 'a Zeta file (.zmg)', software)
      call check('OmniSurf3D', 'an OmniSurf3D file (.os3d)', software)
      call check(achar(2)//repeat(nul, 31)//'OM_MS_2.0', 'a NanoFocus file (.nms)', software)
      call check('DSBB', 'a binary Surfer grid (.grd)', 'ASCII grid')
      call check('DSRB', 'a binary Surfer grid (.grd)', 'ASCII grid')
      call check(char(208)//char(207)//char(17)//char(224)//char(161), 'a MountainsMap (.mnt)', &
         '.sur')
   end subroutine test_others

   subroutine test_data()
      call check(char(137)//'HDF'//achar(13)//nl//achar(26)//nl, 'an HDF5 file', 'h5py')
      call check('CDF'//achar(1), 'a netCDF file (.nc)', numpy)
      call check('CDF'//achar(2), 'a netCDF file (.nc)', numpy)
      call check('CDF'//achar(5), 'a netCDF file (.nc)', numpy)
      call check('MATLAB 5.0 MAT-file, Platform', 'a Matlab file (.mat)', numpy)
      call check(char(147)//'NUMPY'//achar(1), 'a NumPy file (.npy)', numpy)
      call check('SIMPLE  =                    T', 'a FITS file (.fits)', numpy)
      call check('SFLZ', 'a surfalize file (.sflz)', numpy)
      call check('II*'//nul, 'a TIFF file (.tif, .lext)', 'in Gwyddion')
      call check('MM'//nul//'*', 'a TIFF file (.tif, .lext)', 'in Gwyddion')
      call check('II+'//nul, 'a BigTIFF file (.tif)', 'in Gwyddion')
      call check('MM'//nul//'+', 'a BigTIFF file (.tif)', 'in Gwyddion')
      call check(char(137)//'PNG'//achar(13)//nl, 'a picture (.png)', software)
      call check(char(255)//char(216)//char(255), 'a picture (.jpg)', software)
      call check('GIF87a', 'a picture (.gif)', software)
      call check('GIF89a', 'a picture (.gif)', software)
      call check('%PDF-1.7', 'a PDF file', software)
      call check(achar(31)//char(139), 'packed by gzip (.gz)', 'unpack it')
      call check('BZh91AY&SY', 'packed by bzip2 (.bz2)', 'unpack it')
      call check(char(253)//'7zXZ', 'packed by xz (.xz)', 'unpack it')
      call check('7z'//char(188)//char(175), 'packed by 7-Zip (.7z)', 'unpack it')
      call check('Rar!'//achar(26)//achar(7), 'packed by RAR (.rar)', 'unpack it')
      call check('('//char(181)//'/'//char(253), 'packed by Zstandard (.zst)', 'unpack it')
   end subroutine test_data

   subroutine test_meshes()
      character(len=*), parameter :: facet = ' facet normal 0 0 1'//nl

      call check('solid part'//nl//facet, 'a mesh of triangles (.stl)', 'CloudCompare')
      call refused(repeat('stl ', 20)//achar(2)//repeat(nul, 3)//repeat(nul, 100), &
         'file: is a mesh of triangles (.stl)', 'grid of equal steps', no_hints)
      call check('ply'//nl//'format', 'a mesh or a cloud of points (.ply)', 'CloudCompare')
      call check('ply'//achar(13)//nl, 'a mesh or a cloud of points (.ply)', 'CloudCompare')
      call check('LASF', 'a cloud of points (.las, .laz)', 'CloudCompare')
      call check('ASTM-E57', 'a cloud of points (.e57)', 'CloudCompare')
   end subroutine test_meshes

   subroutine test_archives()
      call with_member('xl/workbook.xml', 'file: is an Excel file (.xlsx)', 'as csv')
      call with_member('xl/workbook.bin', 'file: is an Excel file (.xlsb)', 'as csv')
      call with_member('content.xml', 'file: is an OpenDocument file (.ods)', 'as csv')
      call with_member('word/document.xml', 'file: is a Word file (.docx)', 'as csv')
      call with_member('heights.npy', 'file: is a NumPy archive (.npz)', numpy)
      call with_member('header.properties', 'file: is a JPK file', gwyddion)
      call with_member('scan.oir', 'file: is an Olympus file (.poir)', gwyddion)
      call with_member('3D/3dmodel.model', 'file: is a mesh of triangles (.3mf)', 'CloudCompare')
      call with_member('scan.txt', 'file: is a zip archive with first.txt, and neither', &
         'unpack it')
   contains
      subroutine with_member(name, start, part)
         character(len=*), intent(in) :: name, start, part
         type(zip_member_text) :: members(2)
         character(len=:), allocatable :: archive

         members(1)%name = 'first.txt'
         members(1)%bytes = '1'
         members(2)%name = name
         members(2)%bytes = '2'
         call zip_of(members, archive)
         call refused(archive, start, part, no_hints)
      end subroutine with_member
   end subroutine test_archives

   subroutine test_igor()
      type(height_map) :: map
      type(error_type), allocatable :: error

      call read_height_map_bytes('scan.ibw', achar(5)//repeat(nul//'x', 100), no_hints, map, error)
      call assertTrue(allocated(error), 'refused')
      if (.not. allocated(error)) return
      call assertTrue(has_text(error%message, 'scan.ibw: is an Igor wave (.ibw)') .and. &
         has_text(error%message, gwyddion), error%message)
   end subroutine test_igor

   !> Columns and headers that begin with the letters of a code are text.
   subroutine test_texts()
      character(len=*), parameter :: heads(4) = [character(len=12) :: '# VK4_ scan', 'VK4_=1', &
         'solid=oak', 'DSBB: 2']
      type(height_map) :: map
      integer :: i

      do i = 1, size(heads)
         call read_text(trim(heads(i))//nl//repeat('1 2 4 8 3'//nl, 5), with_steps, map)
         call assertEqual([5, 5], shape(map%heights), heads(i))
      end do
   end subroutine test_texts

end module test_height_map_formats
