!> The header of the text form of ISO 25178-71: lines `name = value`, closed by a star.
module asperity_height_map_sdf_text_header
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line
   use asperity_height_map_decode_heights, only: float64, uint8
   use asperity_height_map_file_errors, only: line_error, line_text, map_error
   use asperity_height_map_sdf_header, only: sdf_header
   use asperity_height_map_text_header_fields, only: number_in, plain_key, split_at
   implicit none
   private
   public :: read_text_header

   integer, parameter :: longest_value = 200
   integer, parameter :: n_keys = 8
   !> What must be there, and what may
   character(len=*), parameter :: keys(n_keys) = [character(len=11) :: 'numpoints', 'numprofiles', &
      'xscale', 'yscale', 'zscale', 'datatype', 'compression', 'checktype']
   character(len=*), parameter :: names(n_keys) = [character(len=11) :: 'NumPoints', &
      'NumProfiles', &
      'Xscale', 'Yscale', 'Zscale', 'DataType', 'Compression', 'CheckType']
   integer, parameter :: n_needed = 5
   !> Names of data types in the BCR proposal
   character(len=*), parameter :: types(uint8:float64) = [character(len=8) :: 'uchar', 'uinteger', &
      'ulongint', 'float', 'char', 'integer', 'longint', 'double']

contains

   !> Read the header, from the first line on to the star.
   subroutine read_text_header(source, header, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What it says
      type(sdf_header), intent(out) :: header
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line
      real(wp) :: values(n_keys)
      logical :: is_set(n_keys), found
      integer :: i

      values = 0.0_wp
      values(6) = float64
      is_set = .false.
      call next_line(source, found, error)
      do while (.not. allocated(error))
         call next_line(source, found, error)
         if (allocated(error)) return
         if (.not. found) then
            call line_error(error, source, source%first, 'the file ends within its header: a '// &
               'line with a star must follow it; it was cut off')
            return
         end if
         call line_text(source, longest_value, line)
         i = verify(line//'x', ' '//achar(9))
         if (line(i:min(i, len(line))) == '*') exit
         if (index(line, ';') > 0) line = line(:index(line, ';') - 1)
         if (len_trim(line) > 0) call read_value(source, line, values, is_set, error)
      end do
      if (allocated(error)) return
      do i = 1, n_needed
         if (is_set(i)) cycle
         call map_error(error, source, 'the header does not say '//trim(names(i))//': add it')
         return
      end do
      header%nx = int(values(1), int64)
      header%ny = int(values(2), int64)
      header%x_scale = values(3)
      header%y_scale = values(4)
      header%z_scale = values(5)
      header%kind = int(values(6))
      header%compression = int(values(7))
      header%check = int(values(8))
      header%data_offset = source%start + source%last
   end subroutine read_text_header

   !> Read one line of the header.
   subroutine read_value(source, line, values, is_set, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: line
      real(wp), intent(inout) :: values(n_keys)
      logical, intent(inout) :: is_set(n_keys)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: key, value, rest, word
      !> Of sizes and of types
      real(wp), parameter :: largest(2) = [4294967295.0_wp, 255.0_wp]
      logical :: is_allowed
      integer :: i, k, place

      call split_at(line, '=', key, value, place)
      if (key == '') then
         call line_error(error, source, source%first, 'the header must have lines such as '// &
            'NumPoints = 512, and a star after them')
         return
      end if
      do i = 1, n_keys
         if (key == keys(i)) exit
      end do
      if (i > n_keys) return
      if (is_set(i)) then
         call line_error(error, source, source%first, trim(names(i))//' is there twice: leave '// &
            'one out')
         return
      end if
      is_set(i) = .true.
      call number_in(value, values(i), is_allowed, rest)
      is_allowed = is_allowed .and. rest == ''
      if (is_allowed .and. (i <= 2 .or. i > n_needed)) &
         is_allowed = values(i) >= 0.0_wp .and. &
         values(i) <= largest(merge(1, 2, i <= 2)) .and. .not. &
         abs(values(i) - aint(values(i))) > 0.0_wp
      call plain_key(value, word)
      if (i > n_needed .and. .not. is_allowed) then
         do k = lbound(types, 1), ubound(types, 1)
            if (i > n_needed + 1 .or. word /= types(k)) cycle
            values(i) = k
            is_allowed = .true.
         end do
         if (i > n_needed + 1 .and. (word == 'null' .or. word == 'none')) then
            values(i) = 0.0_wp
            is_allowed = .true.
         end if
      end if
      if (.not. is_allowed) call line_error(error, source, source%first + place - 1, &
         trim(names(i))//' has no value that can be read: it must be a number with a decimal '// &
         'point, sizes and types whole ones')
   end subroutine read_value

end module asperity_height_map_sdf_text_header
