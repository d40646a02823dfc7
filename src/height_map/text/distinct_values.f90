!> The different coordinates along an axis, each with a number, found again fast.
module asperity_height_map_text_distinct_values
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: axis_type, number_of_coordinate, rounding_of

   !> Most of them: two numbers fit in 4 bytes
   integer, parameter, public :: most_coordinates = 65536
   integer, parameter :: first_slots = 256

   !> The coordinates of an axis.
   type :: axis_type
      !> How many
      integer :: count = 0
      !> Their values
      real(wp), allocatable :: values(:)
      !> Most figures and decimals that one of them was printed with
      integer :: figures = 0, decimals = 0
      integer(int64), allocatable, private :: bits(:)
      !> Numbers by a hash of the value, 0 for none
      integer, allocatable, private :: slots(:)
      integer, private :: before = 1, stride = 1
   end type axis_type

contains

   !> Number of a coordinate, from one; 0 when there are too many.
   subroutine number_of_coordinate(axis, value, number)
      !> The axis
      type(axis_type), intent(inout) :: axis
      !> The coordinate
      real(wp), intent(in) :: value
      !> Its number
      integer, intent(out) :: number
      integer(int64) :: bits
      integer :: slot

      ! 0 and -0 are one
      bits = transfer(value + 0.0_wp, bits)
      number = axis%before
      if (number <= axis%count) then
         if (axis%bits(number) == bits) return
         ! mostly, a point follows that is as far on as the last one was
         number = number + axis%stride
         if (number >= 1 .and. number <= axis%count) then
            if (axis%bits(number) == bits) then
               axis%before = number
               return
            end if
         end if
      end if
      if (.not. allocated(axis%slots)) call make_room(axis, first_slots)
      call find_slot(axis, bits, slot)
      number = axis%slots(slot)
      if (number == 0) then
         if (axis%count >= most_coordinates) return
         axis%count = axis%count + 1
         number = axis%count
         axis%slots(slot) = number
         axis%values(number) = value + 0.0_wp
         axis%bits(number) = bits
         if (4*axis%count > size(axis%slots)) call make_room(axis, 4*size(axis%slots))
      end if
      ! back at the beginning of a line
      if (abs(number - axis%before) == 1) axis%stride = number - axis%before
      axis%before = number
   end subroutine number_of_coordinate

   !> How far the coordinates may be from those that were rounded when they were printed: half of
   !> the last figure of the largest, by whichever is coarser, figures or decimals.
   pure real(wp) function rounding_of(axis)
      !> The axis
      type(axis_type), intent(in) :: axis
      real(wp) :: largest
      integer :: last

      largest = maxval(abs(axis%values(:axis%count)))
      last = -axis%decimals
      if (largest > 0.0_wp) last = max(last, floor(log10(largest)) + 1 - axis%figures)
      rounding_of = 0.5_wp*10.0_wp**max(-300, min(last, 300))
   end function rounding_of

   subroutine find_slot(axis, bits, slot)
      type(axis_type), intent(in) :: axis
      integer(int64), intent(in) :: bits
      integer, intent(out) :: slot
      integer(int64), parameter :: multiplier = 1540483477_int64, mask = 2_int64**31 - 1_int64
      integer(int64) :: mixed

      mixed = ieor(bits, ishft(bits, -32))
      mixed = iand(ieor(mixed, ishft(mixed, -15)), mask)*multiplier
      slot = int(iand(ishft(mixed, -20), size(axis%slots) - 1_int64)) + 1
      do while (axis%slots(slot) > 0)
         if (axis%bits(axis%slots(slot)) == bits) exit
         slot = slot + 1
         if (slot > size(axis%slots)) slot = 1
      end do
   end subroutine find_slot

   !> Make a table of so many slots, a power of two, at most a quarter of them taken.
   subroutine make_room(axis, slots)
      type(axis_type), intent(inout) :: axis
      integer, intent(in) :: slots
      real(wp), allocatable :: values(:)
      integer(int64), allocatable :: bits(:)
      integer :: i, slot

      allocate (values(slots/4 + 1), bits(slots/4 + 1))
      if (axis%count > 0) then
         values(:axis%count) = axis%values(:axis%count)
         bits(:axis%count) = axis%bits(:axis%count)
      end if
      call move_alloc(values, axis%values)
      call move_alloc(bits, axis%bits)
      if (allocated(axis%slots)) deallocate (axis%slots)
      allocate (axis%slots(slots), source=0)
      do i = 1, axis%count
         call find_slot(axis, axis%bits(i), slot)
         axis%slots(slot) = i
      end do
   end subroutine make_room

end module asperity_height_map_text_distinct_values
