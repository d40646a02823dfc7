!> Drive a routine along a path as ABAQUS would: several calls an increment, all from the values at
!> its start, cut back as the routine asks.
module asperity_check_driven_drive
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_point, only: has_surface, is_usable, motion_to, next_start, &
      point_answer, point_motion, point_start
   use asperity_check_driven_routine, only: driven_routine, new_start
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: driven_increment, drive_record, drive, place_of, largest_stress

   !> An accepted increment, or the last one that was tried.
   type :: driven_increment
      type(point_start) :: start
      type(point_motion) :: motion
      type(point_answer) :: answer
   end type driven_increment

   !> What happened along a path.
   type :: drive_record
      !> The first `n` are accepted
      type(driven_increment), allocatable :: items(:)
      integer :: n = 0
      !> The accepted increment at the end of each row of the path; 0 where it was not reached
      integer, allocatable :: row_end(:)
      !> Why it ended early: the routine asks for ever smaller increments, or answers no numbers;
      !> `refused` is then the increment
      logical :: stuck = .false., unusable = .false.
      type(driven_increment) :: refused
   end type drive_record

   !> An increment that is not through after so many cuts, or that is down to this share of a row,
   !> will never be; ABAQUS gives up after five cuts, but our rows may be longer than its increments
   integer, parameter :: most_cuts = 40
   real(wp), parameter :: smallest_share = 1.0e-6_wp
   !> Shares of an increment that iterations try before the last one, beyond the end too
   real(wp), parameter :: iterations(2) = [0.6_wp, 1.1_wp]

contains

   !> Drive a routine along a path, each row in `parts` increments. The first row is where the point
   !> begins; it takes an increment without motion when its time is above zero.
   subroutine drive(routine, path, parts, record)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> The path
      type(motion_path), intent(in) :: path
      !> Increments a row
      integer, intent(in) :: parts
      !> Result
      type(drive_record), intent(out) :: record
      type(point_start) :: start
      real(wp) :: from(3), to(3), dtime
      integer :: row, part

      allocate (record%items(64))
      allocate (record%row_end(size(path%time)), source=0)
      from(1) = path%overclosure(1)
      from(2:3) = path%slip(:, 1)
      call new_start(routine, from, start)
      do row = 1, size(path%time)
         if (row == 1) then
            if (path%time(1) <= 0.0_wp) cycle
            dtime = path%time(1)/parts
         else
            dtime = (path%time(row) - path%time(row - 1))/parts
         end if
         to(1) = path%overclosure(row)
         to(2:3) = path%slip(:, row)
         if (routine%ndir == 2) to(3) = 0.0_wp
         from = start%rdisp
         do part = 1, parts
            call advance(routine, start, between(from, to, real(part, wp)/parts), dtime, &
               parts == 1, record)
            if (record%stuck .or. record%unusable) return
         end do
         record%row_end(row) = record%n
      end do
   end subroutine drive

   !> A position between two; where there is no surface at one of them there is no between.
   pure function between(from, to, share) result(position)
      real(wp), intent(in) :: from(3), to(3), share
      real(wp) :: position(3)

      position = to
      if (share >= 1.0_wp .and. share <= 1.0_wp) return
      position(2:3) = from(2:3) + share*(to(2:3) - from(2:3))
      if (has_surface(from(1)) .and. has_surface(to(1))) position(1) = from(1) &
         + share*(to(1) - from(1))
   end function between

   !> One increment, cut as the routine asks; several calls before the last where `iterate`.
   subroutine advance(routine, start, to, dtime, iterate, record)
      type(driven_routine), intent(in) :: routine
      type(point_start), intent(inout) :: start
      real(wp), intent(in) :: to(3), dtime
      logical, intent(in) :: iterate
      type(drive_record), intent(inout) :: record
      type(point_start) :: next
      type(point_motion) :: motion
      type(point_answer) :: answer
      real(wp) :: from(3), done, part
      integer :: cuts

      done = 0.0_wp
      part = 1.0_wp
      cuts = 0
      from = start%rdisp
      do
         part = min(part, 1.0_wp - done)
         motion = motion_to(start, between(from, to, done + part), part*dtime, kit=1)
         if (iterate) call iterate_before(routine, start, motion)
         call call_routine(routine, start, motion, answer)
         if (answer%pnewdt < 1.0_wp) then
            cuts = cuts + 1
            part = part*max(answer%pnewdt, 0.0_wp)
            record%stuck = cuts > most_cuts .or. part < smallest_share
         else
            record%unusable = .not. is_usable(answer)
         end if
         if (record%stuck .or. record%unusable) then
            record%refused%start = start
            record%refused%motion = motion
            record%refused%answer = answer
            return
         end if
         if (answer%pnewdt < 1.0_wp) cycle
         call keep(record, start, motion, answer)
         call next_start(start, motion, answer, next)
         start = next
         done = done + part
         if (done >= 1.0_wp) return
      end do
   end subroutine advance

   !> Calls that ABAQUS makes before the last one: the first without any motion of the increment.
   subroutine iterate_before(routine, start, motion)
      type(driven_routine), intent(in) :: routine
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      type(point_answer) :: answer
      integer :: i

      call call_routine(routine, start, motion_to(start, start%rdisp, motion%dtime, kit=0), answer)
      do i = 1, size(iterations)
         call call_routine(routine, start, motion_to(start, between(start%rdisp, motion%rdisp, &
            iterations(i)), motion%dtime, kit=i), answer)
      end do
   end subroutine iterate_before

   subroutine keep(record, start, motion, answer)
      type(drive_record), intent(inout) :: record
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      type(point_answer), intent(in) :: answer
      type(driven_increment), allocatable :: grown(:)

      if (record%n == size(record%items)) then
         allocate (grown(2*record%n))
         grown(:record%n) = record%items
         call move_alloc(grown, record%items)
      end if
      record%n = record%n + 1
      record%items(record%n)%start = start
      record%items(record%n)%motion = motion
      record%items(record%n)%answer = answer
   end subroutine keep

   !> Where an increment is, in words.
   function place_of(item) result(place)
      !> The increment
      type(driven_increment), intent(in) :: item
      character(len=:), allocatable :: place
      ! figures that a person reads
      integer, parameter :: figures = 3

      associate (r => item%motion%rdisp)
         place = 'increment '//to_text(item%start%increment)
         if (has_surface(r(1))) then
            place = place//', overclosure '//to_text(r(1), figures)//' mm'
         else
            place = place//', no opposite surface'
         end if
         if (any(abs(r(2:3)) > 0.0_wp)) place = place//', slip '// &
            to_text(r(2), figures)//' and '//to_text(r(3), figures)//' mm'
      end associate
   end function place_of

   !> Largest traction of a record, MPa.
   pure real(wp) function largest_stress(record)
      !> The record
      type(drive_record), intent(in) :: record
      integer :: i

      largest_stress = 0.0_wp
      do i = 1, record%n
         largest_stress = max(largest_stress, maxval(abs(record%items(i)%answer%stress)))
      end do
   end function largest_stress

end module asperity_check_driven_drive
