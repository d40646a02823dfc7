!> The channels of a Gwyddion file (GWY): images with their titles, units and masks.
module asperity_height_map_gwyddion_fields
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_file_errors, only: byte_error, plain_excerpt
   use asperity_height_map_gwyddion_tree, only: gwy_component, gwy_span, longest_text, &
      next_component, open_object
   use asperity_height_map_units, only: plain_unit
   implicit none
   private
   public :: channel_text, gwy_channel, read_channels

   integer(int64), parameter :: magic_length = 4_int64
   integer, parameter :: most_channels = 1000

   !> An image: a field of data.
   type :: gwy_field
      !> Whether there is one
      logical :: is_there = .false.
      !> Points of a line and lines; lengths of both sides, in the unit
      real(wp) :: nx = 0.0_wp, ny = 0.0_wp, length_x = 0.0_wp, length_y = 0.0_wp
      !> Units of the sides and of the values, as they stand in the file
      character(len=longest_text) :: lateral_unit = '', unit = ''
      !> Number of values, and where they and the field are
      integer(int64) :: count = 0_int64
      type(gwy_span) :: data = gwy_span(), place = gwy_span()
   end type gwy_field

   !> A channel.
   type :: gwy_channel
      !> Its number in the file
      integer :: number = 0
      !> Its title
      character(len=longest_text) :: title = ''
      !> Its image, and the image that says where it is masked
      type(gwy_field) :: image = gwy_field(), mask = gwy_field()
   end type gwy_channel

contains

   !> Read what channels there are, in the order of their numbers.
   subroutine read_channels(source, channels, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Those with an image
      type(gwy_channel), allocatable, intent(out) :: channels(:)
      !> Set when the file is damaged
      type(error_type), allocatable, intent(out) :: error
      type(gwy_channel), allocatable :: found(:), more(:)
      type(gwy_component) :: component
      type(gwy_span) :: rest, inside
      character(len=longest_text) :: name, role
      integer :: i, n, number

      allocate (found(8))
      rest = gwy_span(magic_length, source%size)
      call open_object(source, rest, name, inside, error)
      if (allocated(error)) return
      if (name /= 'GwyContainer') then
         call byte_error(error, source, magic_length, 'begins with '// &
            plain_excerpt(trim(name), 20)//' where GwyContainer must be: the file is damaged')
         return
      end if
      n = 0
      do while (inside%first < inside%finish)
         call next_component(source, inside, component, error)
         if (allocated(error)) return
         call split_name(component%name, number, role)
         if (number < 0) cycle
         do i = 1, n
            if (found(i)%number == number) exit
         end do
         if (i > most_channels) then
            call byte_error(error, source, component%value%first, 'more than '// &
               to_text(most_channels)//' channels: save the one with the heights alone')
            return
         end if
         if (i > size(found)) then
            allocate (more(2*size(found)))
            more(:n) = found
            call move_alloc(more, found)
         end if
         if (i > n) found(i) = gwy_channel(number=number)
         n = max(i, n)
         if (role == 'data/title' .and. component%kind == 's') then
            found(i)%title = component%text
         else if (role == 'data' .and. component%text == 'GwyDataField') then
            call read_field(source, component%value, found(i)%image, error)
         else if (role == 'mask' .and. component%text == 'GwyDataField') then
            call read_field(source, component%value, found(i)%mask, error)
         end if
         if (allocated(error)) return
      end do
      call sort(found(:n), channels)
   end subroutine read_channels

   !> The number of a channel in a name such as /3/data, and what follows it; -1 where there is
   !> none.
   pure subroutine split_name(name, number, role)
      character(len=longest_text), intent(in) :: name
      integer, intent(out) :: number
      character(len=longest_text), intent(out) :: role
      integer :: n

      number = -1
      role = ''
      if (name(1:1) /= '/') return
      n = verify(name(2:), '0123456789')
      if (n < 2 .or. n > 9) return
      if (name(n + 1:n + 1) /= '/') return
      role = name(n + 2:)
      if (all(role /= [character(len=10) :: 'data', 'data/title', 'mask'])) return
      read (name(2:n), '(i9)') number
   end subroutine split_name

   !> Read a field but its values.
   subroutine read_field(source, place, field, error)
      type(byte_source), intent(inout) :: source
      type(gwy_span), intent(in) :: place
      type(gwy_field), intent(inout) :: field
      type(error_type), allocatable, intent(out) :: error
      type(gwy_component) :: component
      type(gwy_span) :: rest

      field = gwy_field(is_there=.true., place=place)
      rest = place
      do while (rest%first < rest%finish)
         call next_component(source, rest, component, error)
         if (allocated(error)) return
         select case (component%kind//component%name)
         case ('ixres')
            field%nx = component%number
         case ('iyres')
            field%ny = component%number
         case ('dxreal')
            field%length_x = component%number
         case ('dyreal')
            field%length_y = component%number
         case ('Ddata')
            field%count = component%count
            field%data = component%value
         case ('osi_unit_xy')
            call read_unit(source, component%value, field%lateral_unit, error)
         case ('osi_unit_z')
            call read_unit(source, component%value, field%unit, error)
         case default
            cycle
         end select
         if (allocated(error)) return
      end do
   end subroutine read_field

   !> Read the name in a unit.
   subroutine read_unit(source, place, unit, error)
      type(byte_source), intent(inout) :: source
      type(gwy_span), intent(in) :: place
      character(len=longest_text), intent(inout) :: unit
      type(error_type), allocatable, intent(out) :: error
      type(gwy_component) :: component
      type(gwy_span) :: rest

      rest = place
      do while (rest%first < rest%finish)
         call next_component(source, rest, component, error)
         if (allocated(error)) return
         if (component%name == 'unitstr' .and. component%kind == 's') unit = component%text
      end do
   end subroutine read_unit

   !> Those with an image, by their numbers: Gwyddion writes them in any order.
   pure subroutine sort(found, channels)
      type(gwy_channel), intent(in) :: found(:)
      type(gwy_channel), allocatable, intent(out) :: channels(:)
      integer :: i, k, n

      n = 0
      do i = 1, size(found)
         if (found(i)%image%is_there) n = n + 1
      end do
      allocate (channels(n))
      n = 0
      do i = 1, size(found)
         if (.not. found(i)%image%is_there) cycle
         do k = n, 1, -1
            if (channels(k)%number <= found(i)%number) exit
            channels(k + 1) = channels(k)
         end do
         channels(k + 1) = found(i)
         n = n + 1
      end do
   end subroutine sort

   !> A channel for a message: its number, title and unit.
   pure function channel_text(channel) result(text)
      !> The channel
      type(gwy_channel), intent(in) :: channel
      character(len=:), allocatable :: text

      text = to_text(channel%number)//' '''//plain_excerpt(trim(channel%title), 30)//''''
      if (channel%image%unit == '') then
         text = text//' without unit'
      else if (plain_unit(channel%image%unit) /= '') then
         text = text//' in '//trim(plain_unit(channel%image%unit))
      else
         text = text//' in '//plain_excerpt(trim(channel%image%unit), 16)
      end if
   end function channel_text

end module asperity_height_map_gwyddion_fields
