!> Reads Gwyddion's own files (GWY): the first channel whose values are lengths.
!>
!> The layout is that of the format's documentation in Gwyddion's user guide, which gwyfile,
!> surfalize and SurfaceTopography read alike. Gwyddion has no missing points: its own importers
!> and SurfaceTopography mask them, so that what is masked is taken as missing here.
module asperity_height_map_gwyddion_gwy
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_no_value, only: none
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_decode_heights, only: bytes_of, float64, is_allowed_scale
   use asperity_height_map_file_errors, only: byte_error, fits_memory, map_error, plain_excerpt
   use asperity_height_map_gwyddion_fields, only: channel_text, gwy_channel, read_channels
   use asperity_height_map_read_rows, only: mask_rows, read_rows
   use asperity_height_map_type, only: add_note, allocate_heights, height_map, missing_points
   use asperity_height_map_units, only: map_hints, plain_unit, settle_step, settle_unit
   implicit none
   private
   public :: read_gwy

   !> Channels that a message names
   integer, parameter :: most_named = 6

contains

   !> Read a file.
   subroutine read_gwy(source, hints, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(gwy_channel), allocatable :: channels(:)
      character(len=:), allocatable :: others
      integer :: chosen, missing

      call read_channels(source, channels, error)
      if (allocated(error)) return
      call choose(source, channels, chosen, error)
      if (allocated(error)) return
      associate (channel => channels(chosen))
         call read_image(source, channel, hints, map, error)
         if (allocated(error)) return
         if (size(channels) > 1) then
            call list(channels, chosen, others)
            call add_note(map, 'channel '//channel_text(channel)//' is read, not '//others// &
               ': delete in Gwyddion what is not wanted.')
         end if
         if (.not. channel%mask%is_there) return
         missing = missing_points(map)
         call read_mask(source, channel, map, error)
         if (allocated(error)) return
         missing = missing_points(map) - missing
         if (missing > 0) call add_note(map, to_text(missing)//' points that are masked are '// &
            'taken as missing: remove the mask in Gwyddion where they are sound.')
      end associate
   end subroutine read_gwy

   !> Choose the first channel of lengths, or else the first without a unit.
   subroutine choose(source, channels, chosen, error)
      type(byte_source), intent(in) :: source
      type(gwy_channel), intent(in) :: channels(:)
      integer, intent(out) :: chosen
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: all
      integer :: i

      chosen = 0
      do i = size(channels), 1, -1
         if (plain_unit(channels(i)%image%unit) /= '') chosen = i
      end do
      if (chosen > 0) return
      do i = size(channels), 1, -1
         if (channels(i)%image%unit == '') chosen = i
      end do
      if (chosen > 0) return
      if (size(channels) == 0) then
         call map_error(error, source, 'holds no image: in Gwyddion, make one of what it '// &
            'holds, and save it')
      else
         call list(channels, 0, all)
         call map_error(error, source, 'holds no heights: the values of its channels are no '// &
            'lengths that are known (m, cm, mm, um and nm are): '//all)
      end if
   end subroutine choose

   !> List channels but one.
   subroutine list(channels, but, text)
      type(gwy_channel), intent(in) :: channels(:)
      integer, intent(in) :: but
      character(len=:), allocatable, intent(out) :: text
      integer :: i, n

      text = ''
      n = 0
      do i = 1, size(channels)
         if (i == but) cycle
         n = n + 1
         if (n > most_named) exit
         if (n > 1) text = text//', '
         text = text//channel_text(channels(i))
      end do
      if (n > most_named) text = text//' and others'
   end subroutine list

   !> Read the heights of a channel.
   subroutine read_image(source, channel, hints, map, error)
      type(byte_source), intent(inout) :: source
      type(gwy_channel), intent(in) :: channel
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: factor, unit

      associate (image => channel%image)
         if (image%lateral_unit /= '' .and. plain_unit(image%lateral_unit) == '') then
            call byte_error(error, source, image%place%first, 'the sides of channel '// &
               channel_text(channel)//' are in '//plain_excerpt(trim(image%lateral_unit), 16)// &
               ', which is no length that is known (m, cm, mm, um and nm are)')
            return
         end if
         call settle_unit(source%name, 'lengths', '--lateral-unit', &
            plain_unit(image%lateral_unit), hints%lateral_unit, unit, error)
         if (allocated(error)) return
         call settle_unit(source%name, 'heights', '--height-unit', plain_unit(image%unit), &
            hints%height_unit, factor, error)
         if (allocated(error)) return
         call fits_memory(source, int(image%nx, int64), int(image%ny, int64), image%count, &
            image%place%first, error)
         if (allocated(error)) return
         call check_count(source, channel, image%count, image%place%first, 'heights', error)
         if (allocated(error)) return
         call take_step('x', image%length_x, image%nx, hints%step_x, map%step_x)
         if (allocated(error)) return
         call take_step('y', image%length_y, image%ny, hints%step_y, map%step_y)
         if (allocated(error)) return
         call allocate_heights(source%name, int(image%nx, int64), int(image%ny, int64), map, error)
         if (allocated(error)) return
         call read_rows(source, image%data%first, float64, factor, none, map, error)
      end associate

   contains

      !> The step from the length of a side.
      subroutine take_step(axis, length, points, hint, step)
         character(len=*), intent(in) :: axis
         real(wp), intent(in) :: length, points, hint
         real(wp), intent(inout) :: step

         if (is_finite(length)) then
            if (is_allowed_scale(length)) then
               call settle_step(source%name, axis, length/points*unit, hint, step, error)
               return
            end if
         end if
         call byte_error(error, source, channel%image%place%first, 'the side of channel '// &
            channel_text(channel)//' in '//axis//', '//to_text(length)//', is not allowed: it '// &
            'must be above 0 and finite')
      end subroutine take_step

   end subroutine read_image

   !> Take away what is masked.
   subroutine read_mask(source, channel, map, error)
      type(byte_source), intent(inout) :: source
      type(gwy_channel), intent(in) :: channel
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error

      call check_count(source, channel, channel%mask%count, channel%mask%place%first, &
         'numbers of its mask', &
         error)
      if (.not. allocated(error)) call mask_rows(source, channel%mask%data%first, float64, map, &
         error)
   end subroutine read_mask

   !> Check that there are as many numbers as points.
   subroutine check_count(source, channel, count, offset, what, error)
      type(byte_source), intent(in) :: source
      type(gwy_channel), intent(in) :: channel
      integer(int64), intent(in) :: count, offset
      character(len=*), intent(in) :: what
      type(error_type), allocatable, intent(out) :: error

      associate (image => channel%image)
         if (count /= int(image%nx, int64)*int(image%ny, int64)) call byte_error(error, source, &
            offset, 'channel '//channel_text(channel)//' has '//to_text(count)//' '//what// &
            ', and '//to_text(int(image%nx, int64))//' x '//to_text(int(image%ny, int64))// &
            ' points: the file is damaged')
      end associate
   end subroutine check_count

end module asperity_height_map_gwyddion_gwy
