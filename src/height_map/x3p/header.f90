!> The description of an X3P file (ISO 25178-72): its member main.xml.
module asperity_height_map_x3p_header
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_number_chunks, only: number_store
   use asperity_height_map_bytes_xml, only: close_xml, next_text, open_xml, xml_reader
   use asperity_height_map_bytes_zip, only: zip_member
   use asperity_height_map_decode_heights, only: float32, float64, is_allowed_scale, sint16, sint32
   use asperity_height_map_file_errors, only: map_error
   use asperity_height_map_text_header_fields, only: number_in, plain_key
   use asperity_height_map_type, only: height_map
   use asperity_height_map_units, only: map_hints, settle_step, settle_unit
   implicit none
   private
   public :: check_x3p_header, read_x3p_header, x3p_header

   real(wp), parameter :: metre = 1.0e3_wp
   character(len=*), parameter :: axes(3) = ['CX', 'CY', 'CZ']

   !> What main.xml says.
   type :: x3p_header
      !> SUR for a surface, PRF for a profile
      character(len=:), allocatable :: feature
      !> Of x, y and z: I for incremental or A for absolute; I, L, F or D
      character(len=1) :: axis_type(3) = ' ', data_type(3) = ' '
      !> Of x, y and z, m; an increment of z may lack
      real(wp) :: increment(3) = [0.0_wp, 0.0_wp, 1.0_wp], offset(3) = 0.0_wp
      !> Points along x, y and z
      integer(int64) :: sizes(3) = [0_int64, 0_int64, 1_int64]
      !> Members with the points and with their validity, empty if there are none
      character(len=:), allocatable :: points, valid
      !> Heights that stand in main.xml itself
      type(number_store) :: list
   end type x3p_header

contains

   !> Read main.xml.
   subroutine read_x3p_header(source, member, header, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> The member, open
      type(zip_member), intent(in) :: member
      !> What it says
      type(x3p_header), intent(out) :: header
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      type(xml_reader) :: reader
      logical :: found

      header%feature = ''
      header%points = ''
      header%valid = ''
      call open_xml(reader, source, member, error)
      found = .true.
      do while (found .and. .not. allocated(error))
         call next_text(reader, found, error)
         if (found .and. .not. allocated(error)) call read_element(source, reader, header, error)
      end do
      call close_xml(reader)
   end subroutine read_x3p_header

   subroutine read_element(source, reader, header, error)
      type(byte_source), intent(in) :: source
      type(xml_reader), intent(in) :: reader
      type(x3p_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      integer :: i

      text = trim(adjustl(without_breaks(reader%text)))
      select case (reader%path)
      case ('/Record1/FeatureType')
         header%feature = text
      case ('/Record3/MatrixDimension/SizeX')
         call read_size(1)
      case ('/Record3/MatrixDimension/SizeY')
         call read_size(2)
      case ('/Record3/MatrixDimension/SizeZ')
         call read_size(3)
      case ('/Record3/DataLink/PointDataLink')
         header%points = text
      case ('/Record3/DataLink/ValidPointsLink')
         header%valid = text
      case ('/Record3/DataList/Datum')
         call read_datum(source, reader, text, header, error)
      case default
         if (index(reader%path, '/Record1/Axes/') /= 1) return
         do i = 1, 3
            if (reader%path(15:) == axes(i)//'/AxisType') then
               header%axis_type(i) = text
            else if (reader%path(15:) == axes(i)//'/DataType') then
               header%data_type(i) = text
            else if (reader%path(15:) == axes(i)//'/Increment') then
               call read_real(header%increment(i))
            else if (reader%path(15:) == axes(i)//'/Offset') then
               call read_real(header%offset(i))
            end if
         end do
      end select

   contains

      subroutine read_real(value)
         real(wp), intent(inout) :: value
         character(len=:), allocatable :: rest
         real(wp) :: new
         logical :: is_number

         if (text == '') return
         call number_in(text, new, is_number, rest)
         if (is_number .and. rest == '') then
            value = new
         else
            call element_error(source, reader, 'must be a number with a decimal point', error)
         end if
      end subroutine read_real

      subroutine read_size(axis)
         integer, intent(in) :: axis
         real(wp) :: value

         value = -1.0_wp
         call read_real(value)
         if (allocated(error)) return
         if (value >= 1.0_wp .and. value <= 1.0e15_wp) then
            header%sizes(axis) = int(value, int64)
         else
            call element_error(source, reader, 'must be a whole number above 0', error)
         end if
      end subroutine read_size

   end subroutine read_element

   !> Line breaks and tabs as blanks.
   pure function without_breaks(text) result(line)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: line
      integer :: i

      line = text
      do i = 1, len(line)
         if (iachar(line(i:i)) < 32) line(i:i) = ' '
      end do
   end function without_breaks

   !> Append a height of the list, which may follow x and y.
   subroutine read_datum(source, reader, text, header, error)
      type(byte_source), intent(in) :: source
      type(xml_reader), intent(in) :: reader
      character(len=*), intent(in) :: text
      type(x3p_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: rest, word
      real(wp) :: value
      logical :: is_number

      if (header%list%count >= huge(1)) then
         call element_error(source, reader, 'is one too many: at most '// &
            to_text(huge(1))//' are read', error)
         return
      end if
      call plain_key(text(index(text, ';', back=.true.) + 1:), word)
      if (word == '' .or. word == 'nan') then
         value = none
      else
         call number_in(text(index(text, ';', back=.true.) + 1:), value, is_number, rest)
         if (.not. is_number .or. rest /= '') then
            call element_error(source, reader, 'must be a number with a decimal point, or NaN', &
               error)
            return
         end if
      end if
      call header%list%add(value, source%name, error)
   end subroutine read_datum

   subroutine element_error(source, reader, message, error)
      type(byte_source), intent(in) :: source
      type(xml_reader), intent(in) :: reader
      character(len=*), intent(in) :: message
      type(error_type), allocatable, intent(out) :: error

      call map_error(error, source, &
         'main.xml:'//to_text(reader%line)//': '//reader%path//' '//message)
   end subroutine element_error

   !> Set the steps of a map, factor and offset of its heights and the kind of its numbers; `error`
   !> names what is not allowed.
   subroutine check_x3p_header(source, header, hints, map, kind, factor, zero, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> What main.xml says
      type(x3p_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Its steps are set
      type(height_map), intent(inout) :: map
      !> Kind of the numbers
      integer, intent(out) :: kind
      !> mm of one, and height of the number 0, mm
      real(wp), intent(out) :: factor, zero
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: unit
      integer :: i
      logical :: is_profile

      factor = 1.0_wp
      zero = 0.0_wp
      select case (header%data_type(3))
      case ('I')
         kind = sint16
      case ('L')
         kind = sint32
      case ('F')
         kind = float32
      case default
         kind = float64
      end select
      ! a profile has no other line, whatever is said of y
      is_profile = header%feature == 'PRF' .and. header%sizes(2) == 1_int64
      if (header%feature /= 'SUR' .and. .not. is_profile) then
         call map_error(error, source, 'main.xml: FeatureType is '''//plain(header%feature)// &
            ''': only surfaces, SUR, and profiles of one line, PRF, are read, no clouds of points')
      else if (header%axis_type(1) /= 'I' .or. &
         .not. (is_profile .or. header%axis_type(2) == 'I')) then
         call map_error(error, source, 'main.xml: the axes CX and CY must be incremental, '// &
            'AxisType I: resample the surface to equal steps')
      else if (scan(header%axis_type(3), 'AI') == 0) then
         call map_error(error, source, 'main.xml: AxisType of CZ must be A or I')
      else if (header%points /= '' .and. scan(header%data_type(3), 'ILFD') == 0) then
         call map_error(error, source, 'main.xml: DataType of CZ must be I, L, F or D')
      else if (header%sizes(3) /= 1_int64) then
         call map_error(error, source, 'main.xml: SizeZ is '//to_text(header%sizes(3))// &
            ': only one layer is read')
      end if
      if (allocated(error)) return
      call settle_unit(source%name, 'lengths', '--lateral-unit', 'm', hints%lateral_unit, unit, &
         error)
      if (allocated(error)) return
      call settle_unit(source%name, 'heights', '--height-unit', 'm', hints%height_unit, unit, error)
      if (allocated(error)) return
      do i = 1, 3
         if (i == 2 .and. is_profile) cycle
         if (is_allowed_scale(header%increment(i))) then
            if (is_allowed_scale(header%increment(i)*metre)) cycle
         end if
         call map_error(error, source, 'main.xml: Increment of '//axes(i)//', '// &
            to_text(header%increment(i))//' m, is not allowed: it must be above 0 and finite')
         return
      end do
      call settle_step(source%name, 'x', header%increment(1)*metre, hints%step_x, map%step_x, error)
      if (allocated(error)) return
      map%step_y = map%step_x
      if (.not. is_profile) call settle_step(source%name, 'y', header%increment(2)*metre, &
         hints%step_y, map%step_y, error)
      if (allocated(error)) return
      factor = header%increment(3)*metre
      if (.not. is_finite(header%offset(3)) .or. abs(header%offset(3)) > 1.0e3_wp) then
         call map_error(error, source, 'main.xml: Offset of CZ, '//to_text(header%offset(3))// &
            ' m, is not allowed: at most 1 km')
         return
      end if
      zero = header%offset(3)*metre
   end subroutine check_x3p_header

   !> The beginning of a text without what a terminal could take for a command.
   pure function plain(text) result(shown)
      character(len=*), intent(in) :: text
      character(len=min(len(text), 20)) :: shown
      integer :: i

      shown = text
      do i = 1, len(shown)
         if (iachar(shown(i:i)) < 32 .or. iachar(shown(i:i)) > 126) shown(i:i) = '?'
      end do
   end function plain

end module asperity_height_map_x3p_header
