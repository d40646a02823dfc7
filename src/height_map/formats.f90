!> Formats that are not read, by how they begin: a message names them and what to export instead.
!>
!> The first bytes are those of the formats' documentation, and of public readers (Gwyddion,
!> SurfaceTopography, surfalize) and the file type data base of file(1). What is said to be opened
!> by Gwyddion was looked up in Gwyddion 2.62.
module asperity_height_map_formats
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_height_map_bytes_byte_source, only: byte_source, memory_of
   use asperity_height_map_bytes_zip, only: close_zip, count_members, name_member, &
      open_zip, zip_archive
   use asperity_height_map_file_errors, only: map_error, plain_excerpt
   implicit none
   private
   public :: refuse_other_archive, refuse_other_format

   !> A format that is not read.
   type :: other_format
      !> Bytes before its code, and the code, whose length without blanks at its end counts
      integer :: offset = 0
      character(len=32) :: code = ''
      !> What it is, and what to do
      character(len=48) :: name = ''
      character(len=2) :: remedy = ''
   end type other_format

   character(len=1), parameter :: nul = achar(0), lf = achar(10)

   type(other_format), parameter :: formats(*) = [ &
      other_format(0, 'GWYO', 'an old Gwyddion file (.gwy)', 'gw'), &
      other_format(0, 'AliconaImaging', 'an Alicona file (.al3d)', 'gw'), &
      other_format(0, 'fileformat = bcr', 'an Image Metrology file (.bcr, .bcrf)', 'gw'), &
      other_format(0, char(255)//char(254)//'f'//nul//'i'//nul//'l'//nul//'e'//nul//'f'//nul// &
      'o'//nul//'r'//nul//'m'//nul, 'an Image Metrology file (.bcrf)', 'gw'), &
      other_format(0, 'f'//nul//'i'//nul//'l'//nul//'e'//nul//'f'//nul//'o'//nul//'r'//nul//'m'// &
      nul, 'an Image Metrology file (.bcrf)', 'gw'), &
      other_format(0, '\*File list', 'a Bruker Nanoscope file (.spm, .di)', 'gw'), &
      other_format(0, '\*EC File list', 'a Bruker Nanoscope file (.spm, .di)', 'gw'), &
      other_format(0, '?*File list', 'a Bruker Nanoscope file (.spm, .di)', 'gw'), &
      other_format(0, 'FRTM_GLIDERV', 'a MicroProf file (.frt)', 'gw'), &
      other_format(0, 'fileType', 'a PicoView file (.mi)', 'gw'), &
      other_format(0, '[DataSet]', 'a Nanosurf file (.nid, .ezd)', 'gw'), &
      other_format(0, char(1)//nul//'Directory', 'a Wyko file (.opd)', 'gw'), &
      other_format(0, 'VCA DATA'//char(1), 'a Bruker Vision or Dektak file (.opdx)', 'gw'), &
      other_format(0, 'WSxM file copyright', 'a WSxM file (.stp, .top)', 'gw'), &
      other_format(0, char(136)//char(27)//char(3)//'o', 'a Zygo MetroPro file (.dat)', 'gw'), &
      other_format(0, char(136)//char(27)//char(3)//'p', 'a Zygo MetroPro file (.dat)', 'gw'), &
      other_format(0, char(136)//char(27)//char(3)//'q', 'a Zygo MetroPro file (.dat)', 'gw'), &
      other_format(0, 'VK3_', 'a Keyence file (.vk3)', 'gw'), &
      other_format(0, 'VK4_', 'a Keyence file (.vk4)', 'gw'), &
      other_format(0, 'VK6', 'a Keyence file (.vk6)', 'gw'), &
      other_format(0, 'VK7', 'a Keyence file (.vk7)', 'gw'), &
      other_format(0, 'OLYMPUSRAWFORMAT', 'an Olympus file (.oir)', 'gw'), &
      other_format(0, char(1)//char(176)//char(147)//char(255), 'an NT-MDT file (.mdt)', 'gw'), &
      other_format(0, ':NANONIS_VERSION:', 'a Nanonis file (.sxm)', 'gw'), &
      other_format(0, 'KPK', 'a Keyence file (.zon)', 'in'), &
      other_format(0, 'Binary TrueMap Data File', 'a TrueMap or GelSight file (.tmd)', 'in'), &
      other_format(0, 'Zeta-Instruments', 'a Zeta file (.zmg)', 'in'), &
      other_format(0, 'OmniSurf3D', 'an OmniSurf3D file (.os3d)', 'in'), &
      other_format(32, 'OM_MS_', 'a NanoFocus file (.nms)', 'in'), &
      other_format(0, 'DSBB', 'a binary Surfer grid (.grd)', 'su'), &
      other_format(0, 'DSRB', 'a binary Surfer grid (.grd)', 'su'), &
      other_format(0, char(208)//char(207)//char(17)//char(224), &
      'a MountainsMap (.mnt) or old Office file', 'mo'), &
      other_format(0, char(137)//'HDF'//char(13)//lf, 'an HDF5 file (.h5, .datx, .nc, .mat)', &
      'h5'), &
      other_format(0, 'CDF'//char(1), 'a netCDF file (.nc)', 'py'), &
      other_format(0, 'CDF'//char(2), 'a netCDF file (.nc)', 'py'), &
      other_format(0, 'CDF'//char(5), 'a netCDF file (.nc)', 'py'), &
      other_format(0, 'MATLAB 5.0 MAT-file', 'a Matlab file (.mat)', 'py'), &
      other_format(0, char(147)//'NUMPY', 'a NumPy file (.npy)', 'py'), &
      other_format(0, 'SIMPLE  =', 'a FITS file (.fits)', 'py'), &
      other_format(0, 'SFLZ', 'a surfalize file (.sflz)', 'py'), &
      other_format(0, 'II*'//nul, 'a TIFF file (.tif, .lext)', 'ti'), &
      other_format(0, 'MM'//nul//'*', 'a TIFF file (.tif, .lext)', 'ti'), &
      other_format(0, 'II+'//nul, 'a BigTIFF file (.tif)', 'ti'), &
      other_format(0, 'MM'//nul//'+', 'a BigTIFF file (.tif)', 'ti'), &
      other_format(0, char(137)//'PNG', 'a picture (.png)', 'pi'), &
      other_format(0, char(255)//char(216)//char(255), 'a picture (.jpg)', 'pi'), &
      other_format(0, 'GIF87a', 'a picture (.gif)', 'pi'), &
      other_format(0, 'GIF89a', 'a picture (.gif)', 'pi'), &
      other_format(0, '%PDF-1', 'a PDF file', 'pi'), &
      other_format(0, char(31)//char(139), 'packed by gzip (.gz)', 'un'), &
      other_format(4, '1AY&SY', 'packed by bzip2 (.bz2)', 'un'), &
      other_format(0, char(253)//'7zXZ', 'packed by xz (.xz)', 'un'), &
      other_format(0, '7z'//char(188)//char(175), 'packed by 7-Zip (.7z)', 'un'), &
      other_format(0, 'Rar!'//char(26)//char(7), 'packed by RAR (.rar)', 'un'), &
      other_format(0, char(40)//char(181)//char(47)//char(253), 'packed by Zstandard (.zst)', &
      'un'), &
      other_format(0, 'ply'//lf, 'a mesh or a cloud of points (.ply)', 'cl'), &
      other_format(0, 'ply'//char(13), 'a mesh or a cloud of points (.ply)', 'cl'), &
      other_format(0, 'LASF', 'a cloud of points (.las, .laz)', 'cl'), &
      other_format(0, 'ASTM-E57', 'a cloud of points (.e57)', 'cl')]

   !> Members of archives that tell what they are: the end of a name
   type(other_format), parameter :: archives(*) = [ &
      other_format(0, 'xl/workbook.xml', 'an Excel file (.xlsx)', 'of'), &
      other_format(0, 'xl/workbook.bin', 'an Excel file (.xlsb)', 'of'), &
      other_format(0, 'content.xml', 'an OpenDocument file (.ods)', 'of'), &
      other_format(0, 'word/document.xml', 'a Word file (.docx)', 'of'), &
      other_format(0, '.npy', 'a NumPy archive (.npz)', 'py'), &
      other_format(0, 'header.properties', 'a JPK file (.jpk-force, .jpk-qi-image)', 'gw'), &
      other_format(0, '.oir', 'an Olympus file (.poir)', 'gw'), &
      other_format(0, '3dmodel.model', 'a mesh of triangles (.3mf)', 'cl')]

contains

   !> Set `error` when a file begins as one of a format that is known and not read.
   subroutine refuse_other_format(source, head, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Its first bytes
      character(len=*), intent(in) :: head
      !> Set then
      type(error_type), allocatable, intent(out) :: error
      type(other_format) :: row
      integer :: i

      do i = 1, size(formats)
         row = formats(i)
         if (len(head) <= row%offset) cycle
         if (index(head(row%offset + 1:), trim(row%code)) /= 1) cycle
         ! a text may begin with a few letters by chance
         if (is_short_word(trim(row%code)) .and. index(head, nul) == 0) cycle
         call refuse(source, row, error)
         return
      end do
      if (is_mesh(source, head)) then
         call refuse(source, other_format(0, '', 'a mesh of triangles (.stl)', 'cl'), error)
      else if (is_igor(source, head)) then
         call refuse(source, other_format(0, '', 'an Igor wave (.ibw)', 'gw'), error)
      end if
   end subroutine refuse_other_format

   !> Set `error` when a zip archive is neither X3P nor PLUX; `is_plux` tells the latter.
   subroutine refuse_other_archive(source, is_plux, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Whether it has the description that a PLUX file has
      logical, intent(out) :: is_plux
      !> Set then, and when it cannot be opened
      type(error_type), allocatable, intent(out) :: error
      type(zip_archive) :: archive
      character(len=:), allocatable :: name, first
      integer(int64) :: count, place
      integer :: i, known

      is_plux = .false.
      call open_zip(archive, source, memory_of(source), error)
      if (allocated(error)) return
      first = ''
      known = 0
      count = count_members(archive)
      do place = 0_int64, count - 1_int64
         call name_member(archive, place, name)
         if (place == 0_int64) first = name
         is_plux = is_plux .or. name == 'index.xml'
         if (name == 'main.xml' .or. ends_with(name, '/main.xml')) exit
         do i = 1, size(archives)
            if (ends_with(name, trim(archives(i)%code))) known = i
         end do
      end do
      call close_zip(archive)
      if (place < count) then
         is_plux = .false.
      else if (known > 0) then
         call refuse(source, archives(known), error)
      else if (.not. is_plux) then
         call map_error(error, source, 'is a zip archive with '//plain_excerpt(first, 40)// &
            ', and neither X3P nor PLUX: unpack it, and give a map that is in it')
      end if
   end subroutine refuse_other_archive

   !> Whether a code is made of a few printable characters.
   pure logical function is_short_word(code)
      character(len=*), intent(in) :: code
      integer :: i

      is_short_word = len(code) < 6
      do i = 1, len(code)
         if (ichar(code(i:i)) < 32 .or. ichar(code(i:i)) > 126) is_short_word = .false.
      end do
   end function is_short_word

   !> Whether a file is a mesh in STL: text, or 50 bytes for each triangle behind their number.
   pure logical function is_mesh(source, head)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: head
      integer(int64) :: triangles
      integer :: i

      is_mesh = index(head, 'solid') == 1 .and. index(head, 'facet') > 0
      if (is_mesh .or. len(head) < 84) return
      triangles = 0_int64
      do i = 84, 81, -1
         triangles = 256_int64*triangles + ichar(head(i:i))
      end do
      is_mesh = triangles > 0_int64 .and. source%size == 84_int64 + 50_int64*triangles
   end function is_mesh

   !> Whether a file is an Igor wave, whose first bytes, the version, are too few to go by alone.
   pure logical function is_igor(source, head)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: head

      is_igor = len(head) > 64 .and. (ends_with(source%name, '.ibw') .or. &
         ends_with(source%name, '.IBW')) .and. index(head, nul) > 0
   end function is_igor

   pure logical function ends_with(text, ending)
      character(len=*), intent(in) :: text, ending

      ends_with = len(text) >= len(ending)
      if (ends_with) ends_with = text(len(text) - len(ending) + 1:) == ending
   end function ends_with

   !> Name a format and what to do.
   subroutine refuse(source, format, error)
      type(byte_source), intent(in) :: source
      type(other_format), intent(in) :: format
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: remedy

      select case (format%remedy)
      case ('gw')
         remedy = 'open it in Gwyddion, and save it as .gwy'
      case ('mo')
         remedy = 'export a surface in MountainsMap as .sur, a table as csv'
      case ('su')
         remedy = 'save it in Surfer as an ASCII grid (.grd)'
      case ('h5')
         remedy = 'export it in the instrument''s software as SUR, SDF, X3P or text, or write '// &
            'its heights as csv, such as by h5py and numpy.savetxt'
      case ('py')
         remedy = 'write its heights as csv, such as by numpy.savetxt'
      case ('ti')
         remedy = 'open an instrument''s in Gwyddion, and save it as .gwy; other pictures have '// &
            'colours, and no heights'
      case ('pi')
         remedy = 'it has colours, and no heights: export those in the instrument''s software'
      case ('un')
         remedy = 'unpack it'
      case ('cl')
         remedy = 'put it on a grid of equal steps, such as by Rasterize in CloudCompare, and '// &
            'save x y z'
      case ('of')
         remedy = 'save the sheet with the heights as csv'
      case default
         remedy = 'export it in the instrument''s software as SUR, SDF, X3P or text'
      end select
      call map_error(error, source, 'is '//trim(format%name)//', which is not read: '//remedy)
   end subroutine refuse

end module asperity_height_map_formats
