!> Reads members of a zip archive by libzip: a file's, or that of a memory.
module asperity_height_map_bytes_zip
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int, c_int16_t, c_int32_t, &
      c_int64_t, c_null_char, c_null_ptr, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_c_text, only: get_string
   use asperity_height_map_bytes_libzip, only: c_zip_discard, c_zip_fclose, c_zip_fopen_index, &
      c_zip_fread, c_zip_get_name, c_zip_get_num_entries, c_zip_name_locate, c_zip_open, &
      c_zip_open_from_source, c_zip_source_buffer_create, c_zip_source_free, c_zip_stat_index, &
      zip_stat_type
   use asperity_height_map_file_errors, only: map_error
   implicit none
   private
   public :: close_member, close_zip, count_members, find_folder, find_member, handle_of, &
      name_member, open_member, open_zip, read_handle, read_member, zip_archive, zip_member

   integer(c_int), parameter :: read_only = 16_c_int
   !> Names as they stand in the archive
   integer(c_int32_t), parameter :: raw_names = 64_c_int32_t
   !> Most characters of a name, by the format
   integer, parameter :: longest_name = 65535
   integer(c_int64_t), parameter :: has_size = 4_c_int64_t, has_packed_size = 8_c_int64_t

   !> An archive that is open.
   type :: zip_archive
      private
      type(c_ptr) :: handle = c_null_ptr
   end type zip_archive

   !> A member of it.
   type :: zip_member
      !> Name in the archive
      character(len=:), allocatable :: name
      !> Bytes unpacked and packed
      integer(int64) :: size = 0_int64, packed = 0_int64
      !> Bytes read so far
      integer(int64) :: done = 0_int64
      integer(c_int64_t), private :: place = -1_c_int64_t
      type(c_ptr), private :: handle = c_null_ptr
   end type zip_member

contains

   !> Open an archive.
   subroutine open_zip(archive, source, memory, error)
      !> The archive; close it with `close_zip`
      type(zip_archive), intent(out) :: archive
      !> The file, for its name and size
      type(byte_source), intent(in) :: source
      !> The bytes that stand for a file, a null pointer for a file
      type(c_ptr), intent(in) :: memory
      !> Set when it is no sound archive
      type(error_type), allocatable, intent(out) :: error
      type(c_ptr) :: buffer
      integer(c_int) :: status

      status = 0_c_int
      if (c_associated(memory)) then
         buffer = c_zip_source_buffer_create(memory, source%size, 0_c_int, c_null_ptr)
         if (c_associated(buffer)) then
            archive%handle = c_zip_open_from_source(buffer, read_only, c_null_ptr)
            if (.not. c_associated(archive%handle)) call c_zip_source_free(buffer)
         end if
      else
         archive%handle = c_zip_open(source%name//c_null_char, read_only, status)
      end if
      if (.not. c_associated(archive%handle)) call map_error(error, source, 'begins as a zip '// &
         'archive, such as X3P, and is no sound one: it was cut off or damaged; get it once more')
   end subroutine open_zip

   !> Close an archive.
   subroutine close_zip(archive)
      !> The archive
      type(zip_archive), intent(inout) :: archive

      if (c_associated(archive%handle)) call c_zip_discard(archive%handle)
      archive%handle = c_null_ptr
   end subroutine close_zip

   !> Number of members of an archive.
   integer(int64) function count_members(archive)
      !> The archive
      type(zip_archive), intent(in) :: archive

      count_members = c_zip_get_num_entries(archive%handle, 0_c_int32_t)
   end function count_members

   !> The name of a member, with its folders.
   subroutine name_member(archive, place, name)
      !> The archive
      type(zip_archive), intent(in) :: archive
      !> Place of the member, from 0 on
      integer(int64), intent(in) :: place
      !> Its name
      character(len=:), allocatable, intent(out) :: name

      call get_string(c_zip_get_name(archive%handle, place, raw_names), longest_name, name)
   end subroutine name_member

   !> The folder that a member is in, with the slash behind it; empty where it stands outside all
   !> folders, or is not there.
   subroutine find_folder(archive, source, name, folder, error)
      !> The archive
      type(zip_archive), intent(in) :: archive
      !> The file, for messages
      type(byte_source), intent(in) :: source
      !> Name of the member without its folder
      character(len=*), intent(in) :: name
      !> The folder
      character(len=:), allocatable, intent(out) :: folder
      !> Set when it is in several
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: found
      integer(c_int64_t) :: place

      folder = ''
      if (c_zip_name_locate(archive%handle, name//c_null_char, 0_c_int32_t) >= 0_c_int64_t) return
      do place = 0_c_int64_t, count_members(archive) - 1_c_int64_t
         call name_member(archive, place, found)
         if (len(found) <= len(name)) cycle
         if (found(len(found) - len(name):) /= '/'//name) cycle
         if (folder /= '') then
            call map_error(error, source, 'has '//name//' in several folders: it holds several '// &
               'surfaces; pack each into a file of its own')
            return
         end if
         folder = found(:len(found) - len(name))
      end do
   end subroutine find_folder

   !> Find a member by name and ask for its sizes.
   subroutine find_member(archive, source, name, member, error)
      !> The archive
      type(zip_archive), intent(in) :: archive
      !> The file, for messages
      type(byte_source), intent(in) :: source
      !> Name in the archive
      character(len=*), intent(in) :: name
      !> The member
      type(zip_member), intent(out) :: member
      !> Set when there is none
      type(error_type), allocatable, intent(out) :: error
      type(zip_stat_type) :: stat
      integer(c_int) :: status

      member%name = name
      member%place = c_zip_name_locate(archive%handle, name//c_null_char, 0_c_int32_t)
      if (member%place < 0_c_int64_t) then
         call map_error(error, source, 'the archive has no member '//name//': it is incomplete')
         return
      end if
      status = c_zip_stat_index(archive%handle, member%place, 0_c_int32_t, stat)
      if (status /= 0_c_int .or. iand(stat%valid, has_size) == 0_c_int64_t .or. &
         iand(stat%valid, has_packed_size) == 0_c_int64_t .or. stat%size < 0_c_int64_t .or. &
         stat%packed < 0_c_int64_t) then
         call map_error(error, source, 'the archive does not say the size of '//name)
         return
      end if
      member%size = stat%size
      member%packed = stat%packed
   end subroutine find_member

   !> Begin to read a member.
   subroutine open_member(archive, source, member, error)
      !> The archive
      type(zip_archive), intent(in) :: archive
      !> The file, for messages
      type(byte_source), intent(in) :: source
      !> The member; close it with `close_member`
      type(zip_member), intent(inout) :: member
      !> Set when it cannot be unpacked
      type(error_type), allocatable, intent(out) :: error

      member%handle = c_zip_fopen_index(archive%handle, member%place, 0_c_int32_t)
      member%done = 0_int64
      if (.not. c_associated(member%handle)) call map_error(error, source, member%name// &
         ' cannot be unpacked: it is encrypted, damaged or packed in an unusual way')
   end subroutine open_member

   !> Read bytes of a member. `error` is set when they are damaged.
   subroutine read_member(source, member, to, count, done, error)
      !> The file, for messages
      type(byte_source), intent(in) :: source
      !> The member
      type(zip_member), intent(inout) :: member
      !> Where they go
      type(c_ptr), intent(in) :: to
      !> How many are wanted
      integer(int64), intent(in) :: count
      !> How many there were: fewer at its end
      integer(int64), intent(out) :: done
      !> Set when it is damaged
      type(error_type), allocatable, intent(out) :: error

      done = c_zip_fread(member%handle, to, count)
      if (done < 0_int64) then
         done = 0_int64
         call map_error(error, source, member%name//': byte '//to_text(member%done)// &
            ': the packed bytes are damaged: get the file once more')
      end if
      member%done = member%done + done
   end subroutine read_member

   !> What C knows a member by that is open.
   type(c_ptr) function handle_of(member)
      !> The member
      type(zip_member), intent(in) :: member

      handle_of = member%handle
   end function handle_of

   !> Read bytes of a member by its handle; how many there were, less than 0 for damaged ones.
   integer(int64) function read_handle(handle, to, count)
      !> The member
      type(c_ptr), intent(in) :: handle
      !> Where they go
      type(c_ptr), intent(in) :: to
      !> How many are wanted
      integer(int64), intent(in) :: count

      read_handle = c_zip_fread(handle, to, count)
   end function read_handle

   !> Close a member.
   subroutine close_member(member)
      !> The member
      type(zip_member), intent(inout) :: member
      integer(c_int) :: status

      if (c_associated(member%handle)) status = c_zip_fclose(member%handle)
      member%handle = c_null_ptr
   end subroutine close_member

end module asperity_height_map_bytes_zip
