!> Reads X3P files (ISO 25178-72): a zip archive with main.xml, a member with the numbers, x
!> fastest and their little end first, and maybe one with a bit for each that says whether it is
!> valid, the lowest bit first. zip's own checksums are verified, those in main.xml are not needed.
module asperity_height_map_x3p_read
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64, int8
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_archive, only: open_description, read_member_rows
   use asperity_height_map_bytes_byte_source, only: byte_source, memory_of
   use asperity_height_map_bytes_zip, only: close_member, close_zip, find_folder, find_member, &
      open_member, open_zip, read_member, zip_archive, zip_member
   use asperity_height_map_decode_heights, only: height_message, scale_heights
   use asperity_height_map_file_errors, only: fits_memory, map_error
   use asperity_height_map_type, only: allocate_heights, height_map
   use asperity_height_map_units, only: map_hints
   use asperity_height_map_x3p_header, only: check_x3p_header, read_x3p_header, x3p_header
   implicit none
   private
   public :: read_x3p

contains

   !> Read a file.
   subroutine read_x3p(source, hints, map, error)
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
   end subroutine read_x3p

   subroutine read_archive(archive, source, hints, map, error)
      type(zip_archive), intent(in) :: archive
      type(byte_source), intent(inout), target :: source
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      type(x3p_header) :: header
      type(zip_member) :: member
      character(len=:), allocatable :: folder
      real(wp) :: factor, zero
      integer :: kind

      ! all of it may be packed in a folder, in which the links begin
      call find_folder(archive, source, 'main.xml', folder, error)
      if (allocated(error)) return
      call open_description(archive, source, folder//'main.xml', member, error)
      if (.not. allocated(error)) call read_x3p_header(source, member, header, error)
      call close_member(member)
      if (allocated(error)) return
      call check_x3p_header(source, header, hints, map, kind, factor, zero, error)
      if (allocated(error)) return
      if (header%points == '') then
         call read_list(source, header, factor, zero, map, error)
         return
      end if
      call find_member(archive, source, folder//plain_name(header%points), member, error)
      if (allocated(error)) return
      call read_member_rows(archive, source, member, header%sizes, kind, factor, zero, map, error)
      if (allocated(error) .or. header%valid == '') return
      call find_member(archive, source, folder//plain_name(header%valid), member, error)
      if (.not. allocated(error)) call open_member(archive, source, member, error)
      if (.not. allocated(error)) call read_validity(source, member, map, error)
      call close_member(member)
   end subroutine read_archive

   !> Name of a member: some programs write ./ before it, or \ within.
   pure function plain_name(link) result(name)
      character(len=*), intent(in) :: link
      character(len=:), allocatable :: name
      integer :: i

      name = link
      do i = 1, len(name)
         if (name(i:i) == '\') name(i:i) = '/'
      end do
      if (index(name, './') == 1) name = name(3:)
   end function plain_name

   !> Take away the points that are not valid.
   subroutine read_validity(source, member, map, error)
      type(byte_source), intent(in) :: source
      type(zip_member), intent(inout) :: member
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      integer(int8), target :: bytes(4096)
      integer(int64) :: at, done, needed
      integer :: i, j, nx

      nx = size(map%heights, 1)
      needed = (size(map%heights, kind=int64) + 7_int64)/8_int64
      if (member%size /= needed) then
         call map_error(error, source, &
            member%name//': '//to_text(member%size)//' bytes, for '// &
            to_text(size(map%heights, kind=int64))//' points there must be '//to_text(needed))
         return
      end if
      done = 0_int64
      i = 0
      j = 1
      do at = 0_int64, size(map%heights, kind=int64) - 1_int64
         if (mod(at, 8_int64*size(bytes)) == 0_int64) then
            call read_member(source, member, c_loc(bytes), size(bytes, kind=int64), done, error)
            if (allocated(error)) return
         end if
         i = i + 1
         if (i > nx) then
            i = 1
            j = j + 1
         end if
         if (mod(at, 8_int64*size(bytes))/8_int64 >= done) then
            call map_error(error, source, &
               member%name//': ends at byte '//to_text(member%done)// &
               ' of '//to_text(needed)//': get the file once more')
            return
         end if
         if (.not. btest(bytes(mod(at, 8_int64*size(bytes))/8_int64 + 1), int(mod(at, 8_int64)))) &
            map%heights(i, j) = none
      end do
   end subroutine read_validity

   !> Take the heights out of main.xml.
   subroutine read_list(source, header, factor, zero, map, error)
      type(byte_source), intent(in) :: source
      type(x3p_header), intent(inout) :: header
      real(wp), intent(in) :: factor, zero
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message
      real(wp), allocatable :: values(:)
      integer :: bad, chunk, i, j, k, length

      call fits_memory(source, header%sizes(1), header%sizes(2), int(huge(1), int64), 0_int64, &
         error)
      if (allocated(error)) return
      if (header%list%count /= header%sizes(1)*header%sizes(2)) then
         call map_error(error, source, &
            'main.xml: '//to_text(header%list%count)//' heights, it '// &
            'promises '//to_text(header%sizes(1))//' x '//to_text(header%sizes(2)))
         return
      end if
      call allocate_heights(source%name, header%sizes(1), header%sizes(2), map, error)
      if (allocated(error)) return
      i = 0
      j = 1
      do chunk = 1, header%list%chunks
         call header%list%take(chunk, values, length)
         call scale_heights(values(:length), factor, zero, bad)
         if (bad > 0) then
            call height_message(values(bad), factor, message)
            call map_error(error, source, 'main.xml: Datum: '//message)
            return
         end if
         do k = 1, length
            i = i + 1
            if (i > size(map%heights, 1)) then
               i = 1
               j = j + 1
            end if
            map%heights(i, j) = values(k)
         end do
      end do
   end subroutine read_list

end module asperity_height_map_x3p_read
