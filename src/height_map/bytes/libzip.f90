!> Interfaces of the functions of libzip that read an archive.
module asperity_height_map_bytes_libzip
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int16_t, c_int32_t, c_int64_t, &
      c_null_ptr, c_ptr
   implicit none
   private
   public :: c_zip_discard, c_zip_fclose, c_zip_fopen_index, c_zip_fread, c_zip_get_name, &
      c_zip_get_num_entries, c_zip_name_locate, c_zip_open, c_zip_open_from_source, &
      c_zip_source_buffer_create, c_zip_source_free, c_zip_stat_index, zip_stat_type

   !> The structure zip_stat of zip.h.
   type, bind(c) :: zip_stat_type
      integer(c_int64_t) :: valid = 0_c_int64_t
      type(c_ptr) :: name = c_null_ptr
      integer(c_int64_t) :: place = 0_c_int64_t, size = 0_c_int64_t, packed = 0_c_int64_t
      integer(c_int64_t) :: time = 0_c_int64_t
      integer(c_int32_t) :: crc = 0_c_int32_t
      integer(c_int16_t) :: method = 0_c_int16_t, encryption = 0_c_int16_t
      integer(c_int32_t) :: flags = 0_c_int32_t
   end type zip_stat_type

   interface
      type(c_ptr) function c_zip_open(path, flags, status) bind(c, name='zip_open')
         import :: c_char, c_int, c_ptr
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: flags
         integer(c_int), intent(out) :: status
      end function c_zip_open
      type(c_ptr) function c_zip_source_buffer_create(bytes, length, is_freed, error) &
         bind(c, name='zip_source_buffer_create')
         import :: c_int, c_int64_t, c_ptr
         type(c_ptr), value :: bytes
         integer(c_int64_t), value :: length
         integer(c_int), value :: is_freed
         type(c_ptr), value :: error
      end function c_zip_source_buffer_create
      subroutine c_zip_source_free(source) bind(c, name='zip_source_free')
         import :: c_ptr
         type(c_ptr), value :: source
      end subroutine c_zip_source_free
      type(c_ptr) function c_zip_open_from_source(source, flags, error) &
         bind(c, name='zip_open_from_source')
         import :: c_int, c_ptr
         type(c_ptr), value :: source
         integer(c_int), value :: flags
         type(c_ptr), value :: error
      end function c_zip_open_from_source
      subroutine c_zip_discard(archive) bind(c, name='zip_discard')
         import :: c_ptr
         type(c_ptr), value :: archive
      end subroutine c_zip_discard
      integer(c_int64_t) function c_zip_name_locate(archive, name, flags) &
         bind(c, name='zip_name_locate')
         import :: c_char, c_int32_t, c_int64_t, c_ptr
         type(c_ptr), value :: archive
         character(kind=c_char), intent(in) :: name(*)
         integer(c_int32_t), value :: flags
      end function c_zip_name_locate
      integer(c_int64_t) function c_zip_get_num_entries(archive, flags) &
         bind(c, name='zip_get_num_entries')
         import :: c_int32_t, c_int64_t, c_ptr
         type(c_ptr), value :: archive
         integer(c_int32_t), value :: flags
      end function c_zip_get_num_entries
      type(c_ptr) function c_zip_get_name(archive, place, flags) bind(c, name='zip_get_name')
         import :: c_int32_t, c_int64_t, c_ptr
         type(c_ptr), value :: archive
         integer(c_int64_t), value :: place
         integer(c_int32_t), value :: flags
      end function c_zip_get_name
      integer(c_int) function c_zip_stat_index(archive, place, flags, stat) &
         bind(c, name='zip_stat_index')
         import :: c_int, c_int32_t, c_int64_t, c_ptr, zip_stat_type
         type(c_ptr), value :: archive
         integer(c_int64_t), value :: place
         integer(c_int32_t), value :: flags
         type(zip_stat_type), intent(inout) :: stat
      end function c_zip_stat_index
      type(c_ptr) function c_zip_fopen_index(archive, place, flags) bind(c, name='zip_fopen_index')
         import :: c_int32_t, c_int64_t, c_ptr
         type(c_ptr), value :: archive
         integer(c_int64_t), value :: place
         integer(c_int32_t), value :: flags
      end function c_zip_fopen_index
      integer(c_int64_t) function c_zip_fread(file, to, count) bind(c, name='zip_fread')
         import :: c_int64_t, c_ptr
         type(c_ptr), value :: file, to
         integer(c_int64_t), value :: count
      end function c_zip_fread
      integer(c_int) function c_zip_fclose(file) bind(c, name='zip_fclose')
         import :: c_int, c_ptr
         type(c_ptr), value :: file
      end function c_zip_fclose
   end interface

end module asperity_height_map_bytes_libzip
