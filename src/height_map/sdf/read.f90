!> Reads surface data files of ISO 25178-71: heights by rows of x, the first at y = 0. The BCR
!> proposal left open where the first one is; MountainsMap takes the largest y, and so it is here.
module asperity_height_map_sdf_read
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64, int8
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_bytes_lines, only: next_line, start_lines
   use asperity_height_map_decode_heights, only: byte_buffer, bytes_of, decode, float64, &
      height_message, scale_heights
   use asperity_height_map_file_errors, only: byte_error, fits_memory, line_error
   use asperity_height_map_sdf_header, only: check_sdf_header, drop_markers, read_binary_header, &
      sdf_header
   use asperity_height_map_sdf_text_header, only: read_text_header
   use asperity_height_map_text_fields, only: field_error, field_missing, field_too_large, &
      read_field, skip_field
   use asperity_height_map_type, only: allocate_heights, height_map
   use asperity_height_map_units, only: map_hints
   implicit none
   private
   public :: read_binary_sdf, read_text_sdf

contains

   !> Read the binary form.
   subroutine read_binary_sdf(source, is_bcr, is_second, hints, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Whether it follows the BCR proposal, or version 2.0
      logical, intent(in) :: is_bcr, is_second
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(sdf_header) :: header
      type(byte_buffer), target :: buffer
      integer(int64) :: offset, width
      real(wp) :: factor
      integer :: j, row

      call read_binary_header(source, is_bcr, is_second, header, error)
      if (allocated(error)) return
      call check_sdf_header(source, header, hints, map, factor, error)
      if (allocated(error)) return
      width = bytes_of(header%kind)
      call fits_memory(source, header%nx, header%ny, (source%size - header%data_offset)/width, &
         header%sizes_offset, error)
      if (allocated(error)) return
      call check_trailer(source, header%data_offset + header%nx*header%ny*width, error)
      if (allocated(error)) return
      call allocate_heights(source%name, header%nx, header%ny, map, error)
      if (allocated(error)) return
      allocate (buffer%bytes(header%nx*width))
      offset = header%data_offset
      do j = 1, size(map%heights, 2)
         call read_at(source, offset, c_loc(buffer%bytes), header%nx*width, error)
         if (allocated(error)) return
         row = merge(size(map%heights, 2) + 1 - j, j, is_bcr)
         call decode(buffer, header%kind, map%heights(:, row))
         call put_row(source, header, factor, map%heights(:, row), offset, error)
         if (allocated(error)) return
         offset = offset + header%nx*width
      end do
   end subroutine read_binary_sdf

   !> Turn a row of numbers into heights.
   subroutine put_row(source, header, factor, row, offset, error)
      type(byte_source), intent(in) :: source
      type(sdf_header), intent(in) :: header
      real(wp), intent(in) :: factor
      real(wp), intent(inout) :: row(:)
      integer(int64), intent(in) :: offset
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message
      integer :: bad

      call drop_markers(row, header%kind, header%is_bcr)
      call scale_heights(row, factor, 0.0_wp, bad)
      if (bad == 0) return
      call height_message(row(bad), factor, message)
      call byte_error(error, source, offset + (bad - 1)*bytes_of(header%kind), message)
   end subroutine put_row

   !> After the points there may be text, and nothing else: a header that promises fewer points than
   !> there are would hide the rest.
   subroutine check_trailer(source, offset, error)
      type(byte_source), intent(inout) :: source
      integer(int64), intent(in) :: offset
      type(error_type), allocatable, intent(out) :: error
      integer(int8), allocatable, target :: bytes(:)
      integer(int64), parameter :: looked_at = 4096_int64
      integer(int64) :: n
      integer :: i

      n = min(source%size - offset, looked_at)
      if (n <= 0_int64) return
      allocate (bytes(n))
      call read_at(source, offset, c_loc(bytes), n, error)
      if (allocated(error)) return
      do i = 1, int(n)
         select case (bytes(i))
         case (1:8, 11:12, 14:25, 27:31, 127)
            call byte_error(error, source, offset, to_text(source%size - offset)//' bytes '// &
               'follow the points that the header promises, and are no text: the header is wrong')
            return
         case default
            cycle
         end select
      end do
   end subroutine check_trailer

   !> Read the text form.
   subroutine read_text_sdf(source, is_bcr, hints, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> Whether it follows the BCR proposal
      logical, intent(in) :: is_bcr
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(sdf_header) :: header
      real(wp) :: factor

      call start_lines(source, 0_int64, error)
      if (allocated(error)) return
      call read_text_header(source, header, error)
      if (allocated(error)) return
      header%is_bcr = is_bcr
      call check_sdf_header(source, header, hints, map, factor, error)
      if (allocated(error)) return
      ! a digit and a blank for each, the last blank may lack
      call fits_memory(source, header%nx, header%ny, (source%size - header%data_offset + &
         1_int64)/2, &
         header%sizes_offset, error)
      if (allocated(error)) return
      call allocate_heights(source%name, header%nx, header%ny, map, error)
      if (allocated(error)) return
      call read_points(source, header, factor, map, error)
   end subroutine read_text_sdf

   !> Read the numbers of the text form, up to a star.
   subroutine read_points(source, header, factor, map, error)
      type(byte_source), intent(inout), target :: source
      type(sdf_header), intent(in) :: header
      real(wp), intent(in) :: factor
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message
      real(wp) :: value(1)
      integer :: at, before, i, j, kind, bad
      logical :: found, is_last

      i = 1
      j = 1
      lines: do
         call next_line(source, found, error)
         if (allocated(error)) return
         if (.not. found) exit lines
         at = source%first
         is_last = .false.
         do while (.not. is_last)
            do while (at <= source%last)
               if (scan(source%block(at), ' '//achar(9)) == 0) exit
               at = at + 1
            end do
            if (at > source%last) exit
            if (source%block(at) == '*') exit lines
            before = at
            call read_field(source%block, at, source%last, ' ', value(1), kind, is_last)
            if (kind == field_too_large .and. header%kind == float64) then
               ! the largest double, printed
               call skip_field(source%block, at, source%last, ' ', is_last)
               value(1) = none
            else if (kind > field_missing) then
               call field_error(error, source, at, kind)
               return
            end if
            if (j > size(map%heights, 2)) then
               call line_error(error, source, before, 'more numbers than the '// &
                  to_text(header%nx)//' x '//to_text(header%ny)//' that the header promises')
               return
            end if
            call drop_markers(value, header%kind, header%is_bcr)
            call scale_heights(value, factor, 0.0_wp, bad)
            if (bad > 0) then
               call height_message(value(1), factor, message)
               call line_error(error, source, before, message)
               return
            end if
            map%heights(i, merge(size(map%heights, 2) + 1 - j, j, header%is_bcr)) = value(1)
            i = i + 1
            if (i > size(map%heights, 1)) then
               i = 1
               j = j + 1
            end if
         end do
      end do lines
      if (j <= size(map%heights, 2)) call line_error(error, source, source%first, 'the numbers '// &
         'end after '//to_text((j - 1)*header%nx + i - 1)//', the header promises '// &
         to_text(header%nx)//' x '//to_text(header%ny)//': the file was cut off, or the '// &
         'header is wrong')
   end subroutine read_points

end module asperity_height_map_sdf_read
