!> What formats in zip archives share: a description in XML, and a member with numbers, x fastest
!> and their little end first. zip's own checksums are verified.
module asperity_height_map_archive
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, report_progress
   use asperity_height_map_bytes_zip, only: close_member, find_member, open_member, read_member, &
      zip_archive, zip_member
   use asperity_height_map_decode_heights, only: byte_buffer, bytes_of, decode, height_message, &
      scale_heights
   use asperity_height_map_file_errors, only: fits_memory, map_error
   use asperity_height_map_type, only: allocate_heights, height_map
   implicit none
   private
   public :: open_description, read_member_rows

   !> Most bytes that one packed byte can hold, rounded up; of descriptions and of numbers
   integer(int64), parameter :: xml_ratio = 100_int64, largest_ratio = 1100_int64
   integer(int64), parameter :: some_xml = 2_int64**20

contains

   !> Open a member with a description.
   subroutine open_description(archive, source, name, member, error)
      !> The archive
      type(zip_archive), intent(in) :: archive
      !> The file, for messages
      type(byte_source), intent(in) :: source
      !> Name of the member
      character(len=*), intent(in) :: name
      !> The member; close it with `close_member`
      type(zip_member), intent(out) :: member
      !> Set when it is not there, cannot be unpacked, or is too long
      type(error_type), allocatable, intent(out) :: error

      call find_member(archive, source, name, member, error)
      if (allocated(error)) return
      if (member%size > some_xml + xml_ratio*source%size) then
         call map_error(error, source, &
            name//': '//to_text(member%size)//' bytes are packed '// &
            'in it, more than any surface needs: it is not unpacked')
         return
      end if
      call open_member(archive, source, member, error)
   end subroutine open_description

   !> Read the heights in a member.
   subroutine read_member_rows(archive, source, member, sizes, kind, factor, zero, map, error)
      !> The archive
      type(zip_archive), intent(in) :: archive
      !> The file
      type(byte_source), intent(inout) :: source
      !> The member, found and not open
      type(zip_member), intent(inout) :: member
      !> Points along x and y that the description promises
      integer(int64), intent(in) :: sizes(:)
      !> Kind of the numbers
      integer, intent(in) :: kind
      !> mm of one, and height of the number 0, mm
      real(wp), intent(in) :: factor, zero
      !> Its heights are set
      type(height_map), intent(inout) :: map
      !> Set when they cannot be read
      type(error_type), allocatable, intent(out) :: error

      call fits_memory(source, sizes(1), sizes(2), &
         min(member%size, min(member%packed, source%size)*largest_ratio)/bytes_of(kind), &
         0_int64, error)
      if (allocated(error)) return
      if (member%size /= sizes(1)*sizes(2)*bytes_of(kind)) then
         call map_error(error, source, &
            member%name//': '//to_text(member%size)//' bytes, the description '// &
            'promises '//to_text(sizes(1))//' x '//to_text(sizes(2))// &
            ' points of '//to_text(bytes_of(kind))//' bytes')
         return
      end if
      call allocate_heights(source%name, sizes(1), sizes(2), map, error)
      if (allocated(error)) return
      call open_member(archive, source, member, error)
      if (.not. allocated(error)) call read_rows(source, member, kind, factor, zero, map, error)
      call close_member(member)
   end subroutine read_member_rows

   !> Read the numbers of a member; one byte more is asked for, as zip's checksum is compared at the
   !> end.
   subroutine read_rows(source, member, kind, factor, zero, map, error)
      type(byte_source), intent(inout) :: source
      type(zip_member), intent(inout) :: member
      integer, intent(in) :: kind
      real(wp), intent(in) :: factor, zero
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      character(len=:), allocatable :: message
      integer(int64) :: done
      integer :: bad, j

      allocate (buffer%bytes(size(map%heights, 1)*bytes_of(kind)))
      do j = 1, size(map%heights, 2)
         call read_member(source, member, c_loc(buffer%bytes), size(buffer%bytes, kind=int64), &
            done, &
            error)
         if (allocated(error)) return
         if (done < size(buffer%bytes)) exit
         associate (row => map%heights(:, j))
            call decode(buffer, kind, row)
            call scale_heights(row, factor, zero, bad)
            if (bad > 0) then
               call height_message(row(bad), factor, message)
               call map_error(error, source, member%name//': byte '//to_text(member%done - &
                  done + &
                  (bad - 1)*bytes_of(kind))//': '//message)
               return
            end if
         end associate
         call report_progress(source, int(real(source%size, wp)*j/size(map%heights, 2), int64))
      end do
      if (j > size(map%heights, 2)) call read_member(source, member, c_loc(buffer%bytes), 1_int64, &
         done, error)
      if (allocated(error)) return
      if (j <= size(map%heights, 2) .or. done > 0_int64) call map_error(error, source, &
         member%name//': byte '//to_text(member%done)//': the points do not end where the '// &
         'archive says: get the file once more')
   end subroutine read_rows

end module asperity_height_map_archive
