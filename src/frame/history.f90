!> The way that a material is taken along: the turns of a cyclic record, with what the record bears
!> on the way and the work of each cycle. Units are those of the record.
module asperity_frame_history
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: hysteresis_result
   use asperity_hysteresis_types, only: hysteresis_skeleton
   implicit none
   private
   public :: frame_history, new_frame_history, path_along, skeleton_force

   !> Turns, and the record between them.
   type :: frame_history
      !> Displacements at the ends of the legs, from zero on; each leg goes one way
      real(wp), allocatable :: ends(:)
      !> Cycle of each leg
      integer, allocatable :: cycle(:)
      !> Steps of each leg, all of one length
      integer :: steps = 0
      !> Displacement at every step, and the force of the record there
      real(wp), allocatable :: displacement(:), force(:)
      !> Work of the record in each cycle, and its force at the peaks of both sides, signed
      real(wp), allocatable :: energy(:), peak_force(:, :)
      !> Skeletons of both sides, all above zero: outermost point and point of the largest force
      real(wp) :: outermost(2) = 0.0_wp, outermost_force(2) = 0.0_wp
      real(wp) :: strongest(2) = 0.0_wp, strongest_force(2) = 0.0_wp
      !> The skeletons themselves
      type(hysteresis_skeleton) :: skeleton(2)
      !> Largest displacement and force of either sign
      real(wp) :: largest_displacement = 0.0_wp, largest_force = 0.0_wp
   end type frame_history

   !> Steps of a leg, and of all legs at most
   integer, parameter :: usual_steps = 24, most_points = 10000, fewest_steps = 4

contains

   !> The history of a record. Reversals that make no cycle are smoothed away: the record moves on
   !> from turn to turn.
   subroutine new_frame_history(history, displacement, force, result, error)
      !> The history
      type(frame_history), intent(out) :: history
      !> The record, outliers left out
      real(wp), intent(in) :: displacement(:), force(:)
      !> What was found in it
      type(hysteresis_result), intent(in) :: result
      !> Set when it is no record of cycles to both sides
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: samples(:)
      integer :: i, n

      if (result%record_kind /= 'cyclic') then
         call fatal_error(error, 'the record is '//trim(result%record_kind)//': a material '// &
            'with loops takes a cyclic one, with cycles to both sides', subject='opensees')
         return
      end if
      do i = 1, 2
         if (size(result%skeleton(i)%force) > 0) then
            if (abs(result%skeleton(i)%peak_force) > 0.0_wp &
               .and. .not. is_none(result%skeleton(i)%peak_force)) cycle
         end if
         call fatal_error(error, 'the record has no skeleton on the '// &
            trim(merge('positive', 'negative', i == 1))//' side: is its zero right', &
            subject='opensees')
         return
      end do
      call find_legs(history, displacement, result, samples)
      n = size(history%cycle)
      history%steps = min(usual_steps, most_points/n)
      if (history%steps < fewest_steps) then
         call fatal_error(error, 'the record has '//to_text(n)//' half cycles: at most '// &
            to_text(most_points/fewest_steps)//' can be fitted', subject='opensees')
         return
      end if
      allocate (history%displacement(0:n*history%steps), history%force(0:n*history%steps))
      history%displacement = path_along(history%ends, history%steps)
      history%force = 0.0_wp
      history%force(0) = force(1)
      do i = 1, n
         call follow_leg(history, i, displacement, force, samples(i - 1), samples(i))
      end do
      allocate (history%energy(size(result%cycles)), source=result%cycles%energy)
      allocate (history%peak_force(2, size(result%cycles)))
      do i = 1, size(result%cycles)
         history%peak_force(:, i) = result%cycles(i)%force
      end do
      do i = 1, 2
         associate (s => result%skeleton(i))
            history%skeleton(i) = s
            history%outermost(i) = abs(s%displacement(size(s%force)))
            history%outermost_force(i) = abs(s%force(size(s%force)))
            history%strongest(i) = abs(s%peak_displacement)
            history%strongest_force(i) = abs(s%peak_force)
         end associate
      end do
      history%largest_displacement = maxval(abs(history%ends))
      history%largest_force = maxval(abs(force))
   end subroutine new_frame_history

   !> Displacements along legs, in equal steps.
   pure function path_along(ends, steps) result(displacement)
      !> Ends of the legs, from the first one's beginning on
      real(wp), intent(in) :: ends(0:)
      !> Steps of each leg
      integer, intent(in) :: steps
      real(wp) :: displacement(1 + steps*(size(ends) - 1))
      integer :: i, j

      displacement(1) = ends(0)
      do i = 1, ubound(ends, 1)
         do j = 1, steps - 1
            displacement(1 + (i - 1)*steps + j) = ends(i - 1) &
               + (ends(i) - ends(i - 1))*real(j, wp)/real(steps, wp)
         end do
         displacement(1 + i*steps) = ends(i)
      end do
   end function path_along

   !> Force of a skeleton at a displacement, both taken above zero: straight lines from the origin.
   pure real(wp) function skeleton_force(history, side, displacement) result(force)
      !> The history
      type(frame_history), intent(in) :: history
      !> The side
      integer, intent(in) :: side
      !> The displacement
      real(wp), intent(in) :: displacement
      real(wp) :: x, f, x_new, f_new
      integer :: i

      x_new = 0.0_wp
      f_new = 0.0_wp
      force = 0.0_wp
      associate (s => history%skeleton(side))
         do i = 1, size(s%force)
            x = x_new
            f = f_new
            x_new = abs(s%displacement(i))
            f_new = abs(s%force(i))
            force = f_new
            if (x_new <= displacement) cycle
            force = f + (f_new - f)*max(0.0_wp, displacement - x)/(x_new - x)
            exit
         end do
      end associate
   end function skeleton_force

   !> Turns and ends of cycles as ends of legs; `samples` are the last ones at or before them.
   subroutine find_legs(history, displacement, result, samples)
      type(frame_history), intent(inout) :: history
      real(wp), intent(in) :: displacement(:)
      type(hysteresis_result), intent(in) :: result
      integer, allocatable, intent(out) :: samples(:)
      real(wp) :: ends(0:size(result%turning_points) + 2*size(result%cycles))
      integer :: cycle(size(ends)), at(0:size(ends)), i, j, n

      n = 0
      ends(0) = 0.0_wp
      at(0) = 1
      do i = 1, size(result%cycles)
         associate (c => result%cycles(i), turns => result%turning_points)
            do j = 1, size(turns)
               if (turns(j) >= c%first .and. turns(j) <= c%last) &
                  call add(displacement(turns(j)), turns(j))
            end do
            call add(c%end_displacement, c%last)
         end associate
      end do
      allocate (history%ends(0:n), source=ends(0:n))
      allocate (history%cycle(n), source=cycle(:n))
      allocate (samples(0:n), source=at(0:n))

   contains

      subroutine add(x, sample)
         real(wp), intent(in) :: x
         integer, intent(in) :: sample

         if (abs(x - ends(n)) <= result%threshold) return
         n = n + 1
         ends(n) = x
         cycle(n) = i
         at(n) = sample
      end subroutine add

   end subroutine find_legs

   !> Forces of the record at the steps of a leg: linear between samples, each moved on to the
   !> furthest one before it.
   subroutine follow_leg(history, leg, displacement, force, from, to)
      type(frame_history), intent(inout) :: history
      integer, intent(in) :: leg, from, to
      real(wp), intent(in) :: displacement(:), force(:)
      real(wp) :: way, x, f, x_new, f_new, wanted
      integer :: sample, step, point

      way = sign(1.0_wp, history%ends(leg) - history%ends(leg - 1))
      point = (leg - 1)*history%steps
      x = way*history%ends(leg - 1)
      f = history%force(point)
      sample = from
      x_new = x
      f_new = f
      do step = 1, history%steps
         wanted = way*history%displacement(point + step)
         do while (x_new < wanted .and. sample < min(to + 1, size(force)))
            sample = sample + 1
            x = x_new
            f = f_new
            x_new = max(x, way*displacement(sample))
            f_new = force(sample)
         end do
         if (x_new > x) then
            history%force(point + step) = f + (f_new - f)*min(1.0_wp, (wanted - x)/(x_new - x))
         else
            history%force(point + step) = f_new
         end if
      end do
      ! the turn itself, not what is beyond it
      if (abs(way*displacement(to) - way*history%ends(leg)) <= 0.0_wp) &
         history%force(point + history%steps) = force(to)
   end subroutine follow_leg

end module asperity_frame_history
