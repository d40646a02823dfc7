!> Reads SUR files of Digital Surf, plain ones and compressed ones.
!>
!> Compressed data are: the number of streams, then for each its length unpacked and packed, 4 bytes
!> each, then the zlib streams.
module asperity_height_map_sur_read
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_bytes_inflate, only: end_inflate, finish_inflate, inflate_bytes, &
      inflater, start_inflate
   use asperity_height_map_decode_heights, only: byte_buffer, bytes_of, decode, height_message, &
      scale_heights, sint16, sint32, uint32
   use asperity_height_map_file_errors, only: byte_error, fits_memory
   use asperity_height_map_sur_header, only: check_sur_header, read_sur_header, sur_header
   use asperity_height_map_type, only: add_note, allocate_heights, height_map
   use asperity_height_map_units, only: map_hints
   implicit none
   private
   public :: read_sur

   !> Most bytes that one packed byte can hold, rounded up
   integer(int64), parameter, public :: largest_ratio = 1100_int64
   integer, parameter :: most_streams = 1024

contains

   !> Read a file.
   subroutine read_sur(source, is_compressed, hints, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Whether its heights are compressed
      logical, intent(in) :: is_compressed
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(sur_header) :: header
      real(wp) :: factor, zero
      integer(int64) :: width, room
      integer :: kind

      call read_sur_header(source, header, error)
      if (allocated(error)) return
      call check_sur_header(source, header, hints, map, factor, zero, error)
      if (allocated(error)) return
      kind = merge(sint16, sint32, header%bits == 16)
      width = bytes_of(kind)
      room = (source%size - header%data_offset)/width
      if (is_compressed) room = room*largest_ratio
      if (header%objects > 1) call add_note(map, 'the file holds '//to_text(header%objects)// &
         ' objects: the first is read.')
      call fits_memory(source, header%nx, header%ny, room, 108_int64, error)
      if (allocated(error)) return
      call allocate_heights(source%name, header%nx, header%ny, map, error)
      if (allocated(error)) return
      if (is_compressed) then
         call read_compressed(source, header, kind, factor, zero, map, error)
      else if (header%objects < 2 .and. room >= 2_int64*header%points) then
         call byte_error(error, source, header%data_offset + header%points*width, &
            'as many points as the '//to_text(header%nx)//' x '//to_text(header%ny)// &
            ' that the header promises, or more, follow them: the header is wrong')
      else
         if (header%objects < 2 .and. room > header%points) call add_note(map, &
            to_text(source%size - header%data_offset - header%points*width)// &
            ' bytes follow the points and are left out.')
         call read_plain(source, header, kind, factor, zero, map, error)
      end if
   end subroutine read_sur

   subroutine read_plain(source, header, kind, factor, zero, map, error)
      type(byte_source), intent(inout) :: source
      type(sur_header), intent(in) :: header
      integer, intent(in) :: kind
      real(wp), intent(in) :: factor, zero
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      integer(int64) :: offset, length
      integer :: j

      length = header%nx*bytes_of(kind)
      allocate (buffer%bytes(length))
      offset = header%data_offset
      do j = 1, size(map%heights, 2)
         call read_at(source, offset, c_loc(buffer%bytes), length, error)
         if (allocated(error)) return
         call put_row(source, header, buffer, kind, factor, zero, map%heights(:, j), j, error)
         if (allocated(error)) return
         offset = offset + length
      end do
   end subroutine read_plain

   subroutine read_compressed(source, header, kind, factor, zero, map, error)
      type(byte_source), intent(inout) :: source
      type(sur_header), intent(in) :: header
      integer, intent(in) :: kind
      real(wp), intent(in) :: factor, zero
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      type(inflater), allocatable, target :: stream
      integer(int64) :: offset, unpacked, packed, missing, done
      real(wp) :: numbers(2)
      integer :: i, j, streams

      call read_counts(source, header%data_offset, numbers(1:1), error)
      if (allocated(error)) return
      streams = int(min(numbers(1), 1.0e6_wp))
      offset = header%data_offset + 4_int64 + 8_int64*streams
      if (streams < 1 .or. streams > most_streams .or. offset > source%size) then
         call byte_error(error, source, header%data_offset, to_text(streams)//' compressed '// &
            'streams: there must be 1 to '//to_text(most_streams)//', within the file')
         return
      end if
      allocate (buffer%bytes(header%nx*bytes_of(kind)), stream)
      missing = 0_int64
      unpacked = 0_int64
      j = 0
      i = 0
      rows: do while (j < size(map%heights, 2))
         do while (missing < size(buffer%bytes, kind=int64))
            if (unpacked == 0_int64) then
               i = i + 1
               if (i > streams) exit rows
               call read_counts(source, header%data_offset + 4_int64 + 8_int64*(i - 1), &
                  numbers, error)
               if (allocated(error)) exit rows
               unpacked = int(numbers(1), int64)
               packed = int(numbers(2), int64)
               if (packed > source%size - offset) then
                  call byte_error(error, source, offset, 'a compressed stream of '// &
                     to_text(packed)//' bytes does not fit in the file: it was cut off')
                  exit rows
               end if
               call start_inflate(stream, offset, packed)
               offset = offset + packed
               if (unpacked == 0_int64) cycle
            end if
            done = min(unpacked, size(buffer%bytes, kind=int64) - missing)
            call fill(missing, done)
            if (allocated(error)) exit rows
            if (done == 0_int64) exit rows
            missing = missing + done
            unpacked = unpacked - done
            if (unpacked == 0_int64) call finish_inflate(stream, source, error)
            if (allocated(error)) exit rows
         end do
         missing = 0_int64
         j = j + 1
         call put_row(source, header, buffer, kind, factor, zero, map%heights(:, j), j, error)
         if (allocated(error)) exit rows
      end do rows
      call end_inflate(stream)
      if (allocated(error)) return
      if (j < size(map%heights, 2)) then
         call byte_error(error, source, offset, 'the compressed heights end in line '// &
            to_text(j + &
            1)//' of '//to_text(header%ny)//': the file was cut off, or the header '// &
            'is wrong')
      else if (unpacked > 0_int64 .or. i < streams) then
         call byte_error(error, source, offset, 'compressed heights follow the '// &
            to_text(header%nx)//' x '//to_text(header%ny)//' that the header promises')
      end if

   contains

      !> Unpack `wanted` bytes behind the first `after` of the row.
      subroutine fill(after, wanted)
         integer(int64), intent(in) :: after
         integer(int64), intent(inout) :: wanted
         integer(int64) :: got

         call inflate_bytes(stream, source, buffer%bytes(after + 1:after + wanted), got, error)
         wanted = got
      end subroutine fill

   end subroutine read_compressed

   !> Read unsigned numbers of 4 bytes.
   subroutine read_counts(source, offset, values, error)
      type(byte_source), intent(inout) :: source
      integer(int64), intent(in) :: offset
      real(wp), intent(out) :: values(:)
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer

      values = 0.0_wp
      if (offset + 4_int64*size(values) > source%size) then
         call byte_error(error, source, source%size, &
            'the file ends before its heights: it was cut off')
         return
      end if
      allocate (buffer%bytes(4*size(values)))
      call read_at(source, offset, c_loc(buffer%bytes), size(buffer%bytes, kind=int64), error)
      if (.not. allocated(error)) call decode(buffer, uint32, values)
   end subroutine read_counts

   !> Turn the bytes of a line into heights.
   subroutine put_row(source, header, buffer, kind, factor, zero, row, number, error)
      type(byte_source), intent(in) :: source
      type(sur_header), intent(in) :: header
      type(byte_buffer), intent(in) :: buffer
      integer, intent(in) :: kind
      real(wp), intent(in) :: factor, zero
      real(wp), intent(inout) :: row(:)
      integer, intent(in) :: number
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message
      integer :: bad

      call decode(buffer, kind, row)
      if (header%has_missing) then
         where (abs(row - header%marker) < 0.5_wp) row = none
      end if
      call scale_heights(row, factor, zero, bad)
      if (bad == 0) return
      call height_message(row(bad), factor, message)
      call byte_error(error, source, header%data_offset, 'point '//to_text(bad)//' of line '// &
         to_text(number)//': '//message)
   end subroutine put_row

end module asperity_height_map_sur_read
