!> SPIP's ASCII text, which Gwyddion writes as well: keys behind `#`, and heights, the first line at
!> y = 0. Lengths are of the whole map, in nm. Heights are in `z-unit`, or times `Bit2nm` in nm.
!> If there are void pixels, a matrix of the same size follows that is 1 at them. Learnt from
!> Gwyddion's reader and writer and from SurfaceTopography's reader.
module asperity_height_map_export_spip
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line
   use asperity_height_map_decode_heights, only: is_allowed_scale
   use asperity_height_map_export_header_lines, only: next_header_line, read_size, start_numbers
   use asperity_height_map_file_errors, only: line_error, plain_excerpt
   use asperity_height_map_text_fields, only: field_error, field_number, read_field
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_text_header_fields, only: number_in, split_at
   use asperity_height_map_type, only: height_map
   use asperity_height_map_units, only: plain_unit
   implicit none
   private
   public :: read_spip_start, read_voids, spip_mark

   character(len=*), parameter :: spip_mark = '# File Format = ASCII'
   real(wp), parameter :: nm = 1.0e-6_wp  ! mm
   !> Characters of a file that a message shows
   integer, parameter :: shown = 40

contains

   !> Read what stands before the heights. Then the current line is the first of them.
   subroutine read_spip_start(source, header, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What it says
      type(text_header), intent(inout) :: header
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line, key, value, rest
      real(wp) :: lengths(2), number, to_nm
      integer :: place
      logical :: is_number, is_profile

      header%layout%format = 'SPIP ASCII'
      header%layout%has_broken_rows = .true.
      lengths = 0.0_wp
      to_nm = 0.0_wp
      is_profile = .false.
      do
         call next_header_line(source, line, error)
         if (allocated(error)) return
         if (line == '') cycle
         if (line(1:1) /= '#') exit
         call split_at(line, '=:', key, value, place)
         call number_in(value, number, is_number, rest)
         select case (key)
         case ('x-pixels', 'y-pixels')
            if (rest /= '') number = 0.0_wp
            call read_size(source, number, header%sizes(axis_of()), error)
         case ('x-length', 'y-length')
            call read_positive(lengths(axis_of()))
         case ('z-unit')
            header%height_unit = plain_unit(value)
            if (header%height_unit == '') call line_error(error, source, source%first, &
               'the unit of the heights, '''//plain_excerpt(value, shown)//''', is no length: '// &
               'allowed are m, cm, mm, um and nm; export the heights themselves')
         case ('bit2nm')
            call read_positive(to_nm)
            if (.not. (allocated(error) .or. is_allowed_scale(to_nm*nm))) &
               call line_error(error, source, source%first, 'this factor is not allowed')
         case ('voidpixels')
            header%layout%has_voids = number > 0.0_wp
            header%layout%has_more = header%layout%has_voids
         case ('points')
            is_profile = .true.
         case default
            continue
         end select
         if (allocated(error)) return
      end do
      if (any(header%sizes == 0_int64)) then
         call line_error(error, source, source%first, 'x-pixels and y-pixels must stand before '// &
            'the heights'//trim(merge('; this is a profile, and no map', repeat(' ', 31), &
            is_profile)))
         return
      end if
      header%steps = lengths/real(header%sizes, wp)
      header%step_units = 'nm'
      if (header%height_unit == '' .and. to_nm > 0.0_wp) then
         header%factor = to_nm*nm
         if (.not. abs(to_nm - 1.0_wp) > 0.0_wp) then
            header%factor = 0.0_wp
            header%height_unit = 'nm'
         end if
      end if
      call start_numbers(source, header, error, separator=' ')

   contains

      integer function axis_of()
         axis_of = merge(1, 2, key(1:1) == 'x')
      end function axis_of

      !> Lengths along axes that run backwards are below 0
      subroutine read_positive(variable)
         real(wp), intent(inout) :: variable

         if (is_number) is_number = abs(number) <= 1.0e30_wp
         if (is_number) then
            variable = abs(number)
         else
            call line_error(error, source, source%first, key//' must be a number')
         end if
      end subroutine read_positive

   end subroutine read_spip_start

   !> Take out of a map what the matrix behind its heights says is void; the current line is the
   !> last of heights.
   subroutine read_voids(source, header, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> Its header
      type(text_header), intent(in) :: header
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when the matrix is faulty, or not whole
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value
      integer :: at, before, i, j, kind
      logical :: found, is_last

      is_last = .true.
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            do while (is_last)
               call next_line(source, found, error)
               if (allocated(error)) return
               if (.not. found) then
                  call line_error(error, source, source%first, &
                     'the file ends within the matrix of void pixels: it was cut off')
                  return
               end if
               at = source%first
               is_last = verify_blank(source)
            end do
            before = at
            call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
            if (kind == field_number .and. (abs(value) <= 0.0_wp .or. &
               abs(value - 1.0_wp) <= 0.0_wp)) then
               if (value > 0.5_wp) map%heights(i, j) = none
            else if (kind > field_number) then
               call field_error(error, source, before, kind)
               return
            else
               call line_error(error, source, before, 'a void pixel is 1 and another 0 in the '// &
                  'matrix behind the heights: nothing else is allowed')
               return
            end if
         end do
      end do
      if (.not. is_last) call line_error(error, source, at, &
         'there are more void pixels than points')
   end subroutine read_voids

   !> Whether the current line has no field.
   pure logical function verify_blank(source)
      type(byte_source), intent(in) :: source
      integer :: i

      verify_blank = .true.
      do i = source%first, source%last
         verify_blank = verify_blank .and. (source%block(i) == ' ' .or. source%block(i) == achar(9))
      end do
   end function verify_blank

end module asperity_height_map_export_spip
