!> Reads PLUX files of Sensofar's microscopes: a zip archive with a description, index.xml, and for
!> each layer a member of singles in um, NaN where a point is missing. The layout is that which the
!> public readers of Gwyddion, in C, surfalize and SurfaceTopography, in Python, agree on.
module asperity_height_map_plu_plux
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_archive, only: open_description, read_member_rows
   use asperity_height_map_bytes_byte_source, only: byte_source, memory_of
   use asperity_height_map_bytes_xml, only: close_xml, next_text, open_xml, xml_reader
   use asperity_height_map_bytes_zip, only: close_member, close_zip, find_member, open_zip, &
      zip_archive, zip_member
   use asperity_height_map_decode_heights, only: float32
   use asperity_height_map_file_errors, only: map_error, plain_excerpt
   use asperity_height_map_text_header_fields, only: number_in
   use asperity_height_map_type, only: add_note, height_map
   use asperity_height_map_units, only: map_hints, settle_step, settle_unit
   implicit none
   private
   public :: read_plux

   character(len=*), parameter :: description = 'index.xml', unit = 'um'

   !> What index.xml says.
   type :: plux_header
      !> Points along x and y, and their steps, um; 0 where it does not say it
      real(wp) :: points(2) = 0.0_wp, steps(2) = 0.0_wp
      !> Member with the heights of the first layer; empty for none
      character(len=:), allocatable :: heights
      !> Number of layers with heights
      integer :: layers = 0
   end type plux_header

contains

   !> Read a file.
   subroutine read_plux(source, hints, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(zip_archive) :: archive

      call open_zip(archive, source, memory_of(source), error)
      if (.not. allocated(error)) call read_archive(archive, source, hints, map, error)
      call close_zip(archive)
   end subroutine read_plux

   subroutine read_archive(archive, source, hints, map, error)
      type(zip_archive), intent(in) :: archive
      type(byte_source), intent(inout), target :: source
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      type(zip_member) :: member
      type(plux_header) :: header
      real(wp) :: height_unit, lateral_unit

      call open_description(archive, source, description, member, error)
      if (.not. allocated(error)) call read_header(source, member, header, error)
      call close_member(member)
      if (allocated(error)) return
      if (any(header%points < 1.0_wp) .or. any(header%steps <= 0.0_wp)) then
         call map_error(error, source, description//': IMAGE_SIZE_X, IMAGE_SIZE_Y, FOV_X or '// &
            'FOV_Y is missing: this is no PLUX file, or it holds no map')
      else if (header%layers == 0) then
         call map_error(error, source, description//': names no layer with heights, FILENAME_Z')
      end if
      if (allocated(error)) return
      if (header%layers > 1) call add_note(map, 'the file holds '//to_text(header%layers)// &
         ' layers: the first is read.')
      call settle_unit(source%name, 'lengths', '--lateral-unit', unit, hints%lateral_unit, &
         lateral_unit, error)
      if (allocated(error)) return
      call settle_unit(source%name, 'heights', '--height-unit', unit, hints%height_unit, &
         height_unit, error)
      if (allocated(error)) return
      call settle_step(source%name, 'x', header%steps(1)*lateral_unit, hints%step_x, map%step_x, &
         error)
      if (allocated(error)) return
      call settle_step(source%name, 'y', header%steps(2)*lateral_unit, hints%step_y, map%step_y, &
         error)
      if (allocated(error)) return
      call find_member(archive, source, header%heights, member, error)
      if (.not. allocated(error)) call read_member_rows(archive, source, member, &
         int(header%points, int64), float32, height_unit, 0.0_wp, map, error)
   end subroutine read_archive

   !> Read index.xml.
   subroutine read_header(source, member, header, error)
      type(byte_source), intent(in) :: source
      type(zip_member), intent(in) :: member
      type(plux_header), intent(out) :: header
      type(error_type), allocatable, intent(out) :: error
      type(xml_reader) :: reader
      logical :: found

      header%heights = ''
      call open_xml(reader, source, member, error)
      found = .true.
      do while (found .and. .not. allocated(error))
         call next_text(reader, found, error)
         if (.not. found .or. allocated(error)) exit
         select case (reader%path)
         case ('/GENERAL/IMAGE_SIZE_X')
            call take(1.0_wp, 1.0e15_wp, 'a whole number above 0', header%points(1))
         case ('/GENERAL/IMAGE_SIZE_Y')
            call take(1.0_wp, 1.0e15_wp, 'a whole number above 0', header%points(2))
         case ('/GENERAL/FOV_X')
            call take(1.0e-30_wp, 1.0e30_wp, 'a number above 0', header%steps(1))
         case ('/GENERAL/FOV_Y')
            call take(1.0e-30_wp, 1.0e30_wp, 'a number above 0', header%steps(2))
         case default
            if (index(reader%path, '/LAYER_') /= 1) cycle
            if (reader%path(index(reader%path(2:), '/') + 1:) /= '/FILENAME_Z') cycle
            header%layers = header%layers + 1
            if (header%layers == 1) header%heights = trim(adjustl(reader%text))
         end select
      end do
      call close_xml(reader)

   contains

      !> Take a number within limits.
      subroutine take(least, largest, allowed, number)
         real(wp), intent(in) :: least, largest
         character(len=*), intent(in) :: allowed
         real(wp), intent(inout) :: number
         character(len=:), allocatable :: rest
         real(wp) :: new
         logical :: is_right

         call number_in(trim(adjustl(reader%text)), new, is_right, rest)
         if (is_right) is_right = rest == '' .and. new >= least .and. new <= largest
         if (is_right) then
            number = new
            return
         end if
         call map_error(error, source, description//':'//to_text(reader%line)//': '//reader%path// &
            ' is '//plain_excerpt(trim(adjustl(reader%text)), 20)//': it must be '//allowed)
      end subroutine take

   end subroutine read_header

end module asperity_height_map_plu_plux
