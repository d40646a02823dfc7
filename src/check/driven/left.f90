!> What a routine leaves as it was at the start of the increment, whatever that is.
module asperity_check_driven_left
   use asperity_base_kinds, only: wp
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive_record, driven_increment
   use asperity_check_driven_layout, only: same_bits
   use asperity_check_driven_point, only: point_answer, point_start
   use asperity_check_driven_routine, only: driven_routine
   implicit none
   private
   public :: stress_left, stored_is_set

   !> Tractions of the start that no law answers: of both signs, and short numbers, which single
   !> precision has too; in shares of the largest one
   real(wp), parameter :: shares(2) = [0.37109375_wp, -0.61328125_wp]

contains

   !> Which tractions stay what they were, whatever that is, though the point moves that way.
   function stress_left(routine, item, largest) result(is_left)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> The increment
      type(driven_increment), intent(in) :: item
      !> Size of the tractions, MPa
      real(wp), intent(in) :: largest
      logical :: is_left(3)
      type(point_start) :: start
      type(point_answer) :: answer
      real(wp) :: held
      integer :: j

      is_left = abs(item%motion%drdisp) > 0.0_wp
      is_left(routine%ndir + 1:) = .false.
      do j = 1, size(shares)
         held = shares(j)
         ! a power of two keeps the number short
         if (largest > 0.0_wp) held = shares(j)*2.0_wp**exponent(largest)
         start = item%start
         start%stress = held
         call call_routine(routine, start, item%motion, answer)
         is_left = is_left .and. same_bits(answer%stress, held)
      end do
   end function stress_left

   !> Whether the stored energy is ever another than that of the start.
   logical function stored_is_set(routine, record)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> Increments along a path
      type(drive_record), intent(in) :: record
      type(point_start) :: start
      type(point_answer) :: answer
      integer :: i

      stored_is_set = .true.
      do i = 1, record%n
         start = record%items(i)%start
         start%sed = shares(1)
         call call_routine(routine, start, record%items(i)%motion, answer)
         if (.not. same_bits(answer%sed, shares(1))) return
      end do
      stored_is_set = .false.
   end function stored_is_set

end module asperity_check_driven_left
