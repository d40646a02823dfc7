!> Unpacks a zlib stream out of a file piece by piece.
module asperity_height_map_bytes_inflate
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_loc, c_long, c_null_char, c_null_ptr, &
      c_ptr, c_sizeof
   use, intrinsic :: iso_fortran_env, only: int64, int8
   use asperity_base_error, only: error_type
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_file_errors, only: byte_error
   implicit none
   private
   public :: end_inflate, finish_inflate, inflate_bytes, inflater, start_inflate

   integer, parameter :: block_length = 65536
   integer(c_int), parameter :: z_ok = 0_c_int, z_stream_end = 1_c_int, z_no_flush = 0_c_int

   !> The structure z_stream of zlib.h; its counts are unsigned, and here below 2^31.
   type, bind(c) :: z_stream
      type(c_ptr) :: next_in = c_null_ptr
      integer(c_int) :: avail_in = 0_c_int
      integer(c_long) :: total_in = 0_c_long
      type(c_ptr) :: next_out = c_null_ptr
      integer(c_int) :: avail_out = 0_c_int
      integer(c_long) :: total_out = 0_c_long
      type(c_ptr) :: msg = c_null_ptr, state = c_null_ptr
      type(c_ptr) :: zalloc = c_null_ptr, zfree = c_null_ptr, opaque = c_null_ptr
      integer(c_int) :: data_type = 0_c_int
      integer(c_long) :: adler = 0_c_long, reserved = 0_c_long
   end type z_stream

   !> A stream being unpacked; the target of pointers. zlib keeps its address: never copy it.
   type :: inflater
      private
      type(z_stream) :: stream
      integer(int8) :: block(block_length) = 0_int8
      integer(int64) :: next = 0_int64, finish = 0_int64
      logical :: is_open = .false., is_done = .false.
   end type inflater

   interface
      integer(c_int) function c_inflate_init(stream, version, size) bind(c, name='inflateInit_')
         import :: c_char, c_int, z_stream
         implicit none
         type(z_stream), intent(inout) :: stream
         character(kind=c_char), intent(in) :: version(*)
         integer(c_int), value :: size
      end function c_inflate_init
      integer(c_int) function c_inflate(stream, flush) bind(c, name='inflate')
         import :: c_int, z_stream
         implicit none
         type(z_stream), intent(inout) :: stream
         integer(c_int), value :: flush
      end function c_inflate
      integer(c_int) function c_inflate_end(stream) bind(c, name='inflateEnd')
         import :: c_int, z_stream
         implicit none
         type(z_stream), intent(inout) :: stream
      end function c_inflate_end
   end interface

contains

   !> Begin with the stream of `length` bytes after the first `offset`.
   subroutine start_inflate(self, offset, length)
      !> The stream
      type(inflater), intent(inout) :: self
      !> Where it is
      integer(int64), intent(in) :: offset, length

      call end_inflate(self)
      self%stream = z_stream()
      self%next = offset
      self%finish = offset + length
      self%is_done = .false.
      self%is_open = c_inflate_init(self%stream, '1'//c_null_char, &
         int(c_sizeof(self%stream), c_int)) == z_ok
   end subroutine start_inflate

   !> Unpack the next bytes.
   subroutine inflate_bytes(self, source, bytes, done, error)
      !> The stream
      type(inflater), intent(inout), target :: self
      !> The file
      type(byte_source), intent(inout) :: source
      !> What was packed
      integer(int8), intent(inout), target, contiguous :: bytes(:)
      !> How many there were: fewer at the end of the stream
      integer(int64), intent(out) :: done
      !> Set when the stream is damaged
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: n
      integer(c_int) :: status

      done = 0_int64
      if (.not. self%is_open) then
         call byte_error(error, source, self%next, 'zlib cannot be used')
         return
      end if
      if (size(bytes) == 0) return
      self%stream%next_out = c_loc(bytes)
      self%stream%avail_out = int(size(bytes), c_int)
      do while (self%stream%avail_out > 0_c_int .and. .not. self%is_done)
         if (self%stream%avail_in == 0_c_int) then
            n = min(int(block_length, int64), self%finish - self%next)
            if (n <= 0_int64) exit
            call read_at(source, self%next, c_loc(self%block), n, error)
            if (allocated(error)) return
            self%next = self%next + n
            self%stream%next_in = c_loc(self%block)
            self%stream%avail_in = int(n, c_int)
         end if
         status = c_inflate(self%stream, z_no_flush)
         self%is_done = status == z_stream_end
         if (status /= z_ok .and. status /= z_stream_end) then
            call byte_error(error, source, self%next - self%stream%avail_in, 'the compressed '// &
               'heights are damaged: get the file once more, or save it without compression')
            return
         end if
      end do
      done = size(bytes, kind=int64) - self%stream%avail_out
   end subroutine inflate_bytes

   !> Check that a stream ends here: zlib compares its checksum then.
   subroutine finish_inflate(self, source, error)
      !> The stream
      type(inflater), intent(inout), target :: self
      !> The file
      type(byte_source), intent(inout) :: source
      !> Set when it goes on, or its checksum is wrong
      type(error_type), allocatable, intent(out) :: error
      integer(int8), target :: spare(1)
      integer(int64) :: done

      spare = 0_int8
      call inflate_bytes(self, source, spare, done, error)
      if (allocated(error)) return
      if (done > 0_int64 .or. .not. self%is_done) call byte_error(error, source, self%next, &
         'the compressed heights do not end where the header says: get the file once more')
   end subroutine finish_inflate

   !> Give back what zlib holds.
   subroutine end_inflate(self)
      !> The stream
      type(inflater), intent(inout) :: self
      integer(c_int) :: status

      if (self%is_open) status = c_inflate_end(self%stream)
      self%is_open = .false.
   end subroutine end_inflate

end module asperity_height_map_bytes_inflate
