!> Reads height maps and profiles. The format is told by what a file contains, not by its name.
module asperity_height_map_read
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_bytes_byte_source, only: byte_source, close_source, open_source, &
      progress_report, read_at, use_bytes
   use asperity_height_map_bytes_lines, only: start_lines
   use asperity_height_map_export_start, only: read_export_end, read_export_start
   use asperity_height_map_file_errors, only: map_error
   use asperity_height_map_formats, only: refuse_other_archive, refuse_other_format
   use asperity_height_map_gwyddion_gsf, only: gsf_magic, read_gsf
   use asperity_height_map_gwyddion_gwy, only: read_gwy
   use asperity_height_map_marker, only: note_marker
   use asperity_height_map_plu_plux, only: read_plux
   use asperity_height_map_plu_read, only: is_plu, read_plu
   use asperity_height_map_sdf_read, only: read_binary_sdf, read_text_sdf
   use asperity_height_map_sur_read, only: read_sur
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_text_matrix, only: read_matrix
   use asperity_height_map_text_settle, only: drop_count, settle_heights
   use asperity_height_map_text_start, only: read_text_start
   use asperity_height_map_text_xyz, only: read_xyz
   use asperity_height_map_type, only: add_note, check_heights, height_map
   use asperity_height_map_units, only: map_hints
   use asperity_height_map_x3p_read, only: read_x3p
   implicit none
   private
   public :: map_hints, progress_report, read_height_map, read_height_map_bytes

   integer, parameter :: looked_at = 512
   character(len=*), parameter :: known = &
      'heights are read from SDF, X3P, SUR, PLU, PLUX, GWY and GSF files, and from '// &
      'text with three columns x, y, z or with a matrix, profiles from two, x and z, or one'

contains

   !> Read the height map of a file.
   subroutine read_height_map(path, hints, map, error, progress)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> What the user says of a file that does not say it itself
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(out) :: map
      !> Set when there is no sound map in it; names file and place
      type(error_type), allocatable, intent(out) :: error
      !> Hears how far the reading is
      procedure(progress_report), optional :: progress
      type(byte_source), target :: source

      call open_source(source, path, error, progress)
      if (.not. allocated(error)) call read_source(source, hints, map, error)
      call close_source(source)
   end subroutine read_height_map

   !> Read a height map from the bytes of a file in memory.
   subroutine read_height_map_bytes(name, bytes, hints, map, error, block_length)
      !> Name for messages
      character(len=*), intent(in) :: name
      !> The bytes
      character(len=*), intent(in), target :: bytes
      !> What the user says of a file that does not say it itself
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(out) :: map
      !> Set when there is no sound map in it; names place
      type(error_type), allocatable, intent(out) :: error
      !> Bytes handled at once, for tests
      integer, intent(in), optional :: block_length
      type(byte_source), target :: source

      call use_bytes(source, name, bytes, block_length)
      call read_source(source, hints, map, error)
      call close_source(source)
   end subroutine read_height_map_bytes

   !> Recognise the format and read.
   subroutine read_source(source, hints, map, error)
      type(byte_source), intent(inout), target :: source
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      character(len=1), target :: bytes(looked_at)
      character(len=looked_at) :: head
      integer :: i, n
      logical :: is_text

      is_text = .false.
      map%source = source%name
      map%format = ''
      if (source%size == 0_int64) then
         call map_error(error, source, 'is empty')
         return
      end if
      head = ''
      n = int(min(source%size, int(looked_at, int64)))
      call read_at(source, 0_int64, c_loc(bytes), int(n, int64), error)
      if (allocated(error)) return
      do i = 1, n
         head(i:i) = bytes(i)
      end do
      if (head(:4) == 'PK'//achar(3)//achar(4) .or. head(:4) == 'PK'//achar(5)//achar(6)) then
         call read_archive(source, hints, map, error)
      else if (head(:12) == 'DIGITAL SURF' .or. head(:12) == 'DSCOMPRESSED') then
         map%format = 'SUR (Digital Surf)'
         call read_sur(source, head(:2) == 'DS', hints, map, error)
      else if (head(2:5) == 'ISO-' .or. head(2:5) == 'BCR-') then
         call read_sdf(source, head(:8), hints, map, error)
      else if (head(:4) == 'GWYP') then
         map%format = 'GWY (Gwyddion)'
         call read_gwy(source, hints, map, error)
      else if (head(:len(gsf_magic)) == gsf_magic) then
         map%format = 'GSF (Gwyddion)'
         call read_gsf(source, hints, map, error)
      else if (is_plu(head(:n))) then
         map%format = 'PLU (Sensofar)'
         call read_plu(source, hints, map, error)
      else
         call refuse_other_format(source, head(:n), error)
         if (.not. allocated(error)) call read_text(source, head(:n), hints, map, error)
         is_text = .true.
      end if
      if (.not. (is_text .or. allocated(error))) then
         call note_marker(map, 0.0_wp)
         if (hints%has_missing_value) call add_note(map, '--missing-value is for text, and not '// &
            'used: this format marks missing points itself.')
      end if
      if (.not. allocated(error)) call check_heights(map, error)
      if (allocated(error) .and. allocated(map%heights)) deallocate (map%heights)
   end subroutine read_source

   subroutine read_archive(source, hints, map, error)
      type(byte_source), intent(inout), target :: source
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      logical :: is_plux

      call refuse_other_archive(source, is_plux, error)
      if (allocated(error)) return
      if (is_plux) then
         map%format = 'PLUX (Sensofar)'
         call read_plux(source, hints, map, error)
      else
         map%format = 'X3P (ISO 25178-72)'
         call read_x3p(source, hints, map, error)
      end if
   end subroutine read_archive

   subroutine read_sdf(source, version, hints, map, error)
      type(byte_source), intent(inout), target :: source
      character(len=8), intent(in) :: version
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      logical :: is_bcr

      is_bcr = version(2:4) == 'BCR'
      select case (version)
      case ('aISO-1.0', 'aISO-2.0', 'aBCR-0.0', 'aBCR-1.0', 'AISO-1.0', 'ABCR-1.0')
         map%format = 'SDF text (ISO 25178-71)'
         call read_text_sdf(source, is_bcr, hints, map, error)
      case ('bISO-1.0', 'bISO-2.0', 'bBCR-0.0', 'bBCR-1.0', 'BISO-1.0', 'BBCR-1.0')
         map%format = 'SDF binary (ISO 25178-71)'
         call read_binary_sdf(source, is_bcr, version(6:) == '2.0', hints, map, error)
      case default
         call map_error(error, source, 'begins as an SDF file of an unknown version: known are '// &
            'aISO-1.0, bISO-1.0, aISO-2.0, bISO-2.0, aBCR-1.0 and bBCR-1.0, and BCR with 0.0')
      end select
   end subroutine read_sdf

   subroutine read_text(source, head, hints, map, error)
      type(byte_source), intent(inout), target :: source
      character(len=*), intent(in) :: head
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      type(text_header) :: header
      integer(int64) :: mark
      real(wp) :: factor
      integer :: i
      logical :: has_points

      if (index(head, char(255)//char(254)) == 1 .or. index(head, char(254)//char(255)) == 1) then
         call map_error(error, source, 'is text in UTF-16: save it as UTF-8 or ASCII')
         return
      end if
      do i = 1, len(head)
         select case (ichar(head(i:i)))
         case (0:8, 14:31)
            call map_error(error, source, 'is in no format that is known: '//known)
            return
         case default
            cycle
         end select
      end do
      mark = 0_int64
      if (index(head, char(239)//char(187)//char(191)) == 1) mark = 3_int64
      call start_lines(source, mark, error)
      if (allocated(error)) return
      call read_export_start(source, head(mark + 1:), hints, header, map, error)
      if (allocated(error)) return
      map%format = trim(header%layout%format)
      if (map%format /= '') then
         has_points = all(header%names%places > 0)
      else
         call read_text_start(source, header, error)
         if (allocated(error)) return
         call check_columns(source, header, has_points)
         map%format = trim(merge('text of x, y, z ', 'text of a matrix', has_points))
         if (has_points .and. header%names%places(2) == 0) map%format = 'text of a profile'
      end if
      call settle_heights(source, header, hints, map, factor, error)
      if (allocated(error)) return
      if (has_points) then
         if (header%has_colours) call add_note(map, 'of six columns the last three are '// &
            'taken for red, green and blue, and not used.')
         call read_xyz(source, header, factor, hints, map, error)
         if (header%names%places(1) == 0 .and. .not. allocated(error)) call drop_count(map, factor)
      else
         call read_matrix(source, header, factor, hints, map, error)
      end if
      if (header%layout%has_more .and. .not. allocated(error)) &
         call read_export_end(source, header, map, error)
      if (.not. allocated(error)) call note_marker(map, factor)
   end subroutine read_text

   !> Whether the columns are coordinates and a height: three of them, colours behind, or names say
   !> so; of a profile x and z, or z alone.
   subroutine check_columns(source, header, has_points)
      type(byte_source), intent(in) :: source
      type(text_header), intent(inout) :: header
      logical, intent(out) :: has_points
      logical :: fits

      associate (names => header%names)
         fits = header%fields == names%fields
         if (header%fields == names%fields + 1) then
            ! a separator at the end of each line, or numbers of rows that have no name
            fits = .true.
            if (header%separator == ' ' .or. &
               source%block(max(source%last, 1)) /= header%separator) then
               where (names%places > 0) names%places = names%places + 1
            end if
         end if
         has_points = .false.
         if (any(header%sizes > 0_int64)) return
         has_points = fits .and. names%places(3) > 0 .and. names%places(1) > 0
         if (has_points) header%has_colours = .false.
         if (has_points) return
         has_points = header%fields <= 3_int64 .or. header%has_colours
         select case (header%fields)
         case (1)
            names%places = [0, 0, 1]
         case (2)
            names%places = merge([2, 0, 1], [1, 0, 2], names%places(3) == 1)
         case default
            if (has_points) names%places = [1, 2, 3]
         end select
      end associate
   end subroutine check_columns

end module asperity_height_map_read
