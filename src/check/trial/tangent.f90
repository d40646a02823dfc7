!> Rule `tangent`: DDSDDR is the derivative of STRESS by the relative motion, by differences at
!> every state of the path. Where both sides differ, as at a change of status, either is right; and
!> any is without motion, from which elements of a law may go different ways.
module asperity_check_trial_tangent
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine, repeats
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, place_of
   use asperity_check_driven_layout, only: same_bits
   use asperity_check_driven_paths, only: main_path, motion_sizes, sizes_of
   use asperity_check_driven_point, only: has_surface, motion_to, point_answer, point_motion
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_tangent, severity_error, severity_warning
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_tangent

   !> Steps of differences, as shares of the largest overclosure and slip: the smallest for laws
   !> that change over a millionth of these, the largest for laws with some noise of their own. The
   !> one in between is shown
   real(wp), parameter :: steps(3) = [1.0e-8_wp, 1.0e-6_wp, 1.0e-4_wp]
   integer, parameter :: shown = 2
   !> What an entry may be off, of itself and of the largest entry: ten times what differences of a
   !> smooth law are off
   real(wp), parameter :: relative = 1.0e-3_wp, of_largest = 1.0e-5_wp

   !> The derivatives that an entry may be
   type :: differences_type
      !> Left, right and central for each step
      real(wp) :: values(3, 3, 3, size(steps)) = 0.0_wp
      !> Whether the routine could answer
      logical :: known(3) = .true.
      !> Whether the routine sets the entry, as a number where nothing moves; else it is another
      !> rule's
      logical :: is_set(3, 3) = .true.
   end type differences_type

contains

   !> Run the trial.
   subroutine check_tangent(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(driven_increment) :: still, item_of_worst
      type(differences_type) :: worst_differences
      real(wp) :: worst
      logical :: ever_wrong(3, 3), on_diagonal
      integer :: i, at(2), bad

      call drive(routine, main_path(settings), 1, record)
      worst = 0.0_wp
      bad = 0
      ever_wrong = .false.
      on_diagonal = .false.
      at = 0
      do i = 1, record%n
         call compare(record%items(i), may_be_corner=.true.)
      end do
      if (bad > 0) then
         call report(', ', bad, record%n)
         return
      end if
      do i = 1, record%n
         still = record%items(i)
         still%motion = motion_to(still%start, still%start%rdisp, still%motion%dtime, kit=1)
         call call_routine(routine, still%start, still%motion, still%answer)
         if (still%answer%pnewdt >= 1.0_wp) call compare(still, may_be_corner=.false.)
      end do
      if (bad > 0) call report(' with DRDISP = 0 at the start of ', bad, record%n)

   contains

      subroutine compare(item, may_be_corner)
         type(driven_increment), intent(in) :: item
         !> Whether corners are compared
         logical, intent(in) :: may_be_corner
         type(differences_type) :: differences
         real(wp) :: off
         logical :: wrong(3, 3)
         integer :: j, k

         if (.not. has_surface(item%motion%rdisp(1))) return
         call find_differences(routine, sizes_of(settings), item, differences)
         if (.not. repeats(routine, item%start, item%motion)) return
         wrong = .false.
         do k = 1, routine%ndir
            if (.not. differences%known(k)) cycle
            do j = 1, routine%ndir
               if (.not. differences%is_set(j, k)) cycle
               if (.not. may_be_corner .and. is_corner(differences, j, k)) cycle
               off = excess(item%answer%ddsddr, differences, j, k)
               wrong(j, k) = off > 0.0_wp
               if (off <= worst) cycle
               worst = off
               item_of_worst = item
               at = [j, k]
               worst_differences = differences
            end do
         end do
         if (.not. any(wrong)) return
         bad = bad + 1
         ever_wrong = ever_wrong .or. wrong
         on_diagonal = on_diagonal .or. wrong(1, 1) .or. wrong(2, 2) .or. wrong(3, 3)
      end subroutine compare

      subroutine report(when, bad, n)
         character(len=*), intent(in) :: when
         integer, intent(in) :: bad, n

         associate (item => item_of_worst)
            call findings%add(rule_tangent, merge(severity_error, severity_warning, on_diagonal), &
               'DDSDDR('//to_text(at(1))//','//to_text(at(2))//')'//when//place_of(item), &
               text_of(worst_differences, at), &
               to_text(item%answer%ddsddr(at(1), at(2)), 5)//' MPa/mm; of '//to_text(n)// &
               ' increments '//to_text(bad)//' are off, in '//entries(ever_wrong), &
               effect_of(on_diagonal))
         end associate
      end subroutine report

   end subroutine check_tangent

   pure function effect_of(on_diagonal) result(effect)
      logical, intent(in) :: on_diagonal
      character(len=:), allocatable :: effect

      effect = 'Newton''s method converges slowly or not at all'
      if (.not. on_diagonal) effect = 'slow convergence: shear depends on pressure and not the '// &
         'other way round, so give the unsymmetric matrix, and UNSYMM on *SURFACE INTERACTION'
   end function effect_of

   !> What the entry should be.
   function text_of(differences, at) result(text)
      type(differences_type), intent(in) :: differences
      integer, intent(in) :: at(2)
      character(len=:), allocatable :: text

      associate (d => differences%values(at(1), at(2), :, shown))
         text = to_text(d(3), 5)//' MPa/mm by differences'
         if (is_corner(differences, at(1), at(2))) text = to_text(d(1), 5)// &
            ' MPa/mm by differences to the left or '//to_text(d(2), 5)//' to the right'
      end associate
   end function text_of

   function entries(wrong) result(text)
      logical, intent(in) :: wrong(3, 3)
      character(len=:), allocatable :: text
      integer :: j, k

      text = ''
      do k = 1, 3
         do j = 1, 3
            if (.not. wrong(j, k)) cycle
            if (text /= '') text = text//', '
            text = text//'('//to_text(j)//','//to_text(k)//')'
         end do
      end do
   end function entries

   !> Whether both sides differ.
   pure logical function is_corner(differences, j, k)
      type(differences_type), intent(in) :: differences
      integer, intent(in) :: j, k

      associate (d => differences%values(j, k, :, shown))
         is_corner = abs(d(1) - d(2)) > relative*max(abs(d(1)), abs(d(2)))
      end associate
   end function is_corner

   !> How far an entry is off what it may be at most, relative to its size; not positive when right.
   pure real(wp) function excess(found, differences, j, k)
      real(wp), intent(in) :: found(3, 3)
      type(differences_type), intent(in) :: differences
      integer, intent(in) :: j, k
      real(wp) :: largest, allowed
      integer :: side, step

      excess = 1.0_wp
      if (.not. is_finite(found(j, k))) return
      largest = max(maxval(abs(differences%values(:, :, 3, :))), maxval(abs(found), &
         mask=is_finite(found)), tiny(largest))
      do step = 1, size(steps)
         do side = 1, 3
            associate (d => differences%values(j, k, side, step))
               allowed = relative*max(abs(d), abs(found(j, k))) + of_largest*largest
               excess = min(excess, (abs(found(j, k) - d) - allowed)/largest)
            end associate
         end do
      end do
   end function excess

   !> Differences at the end of an increment.
   subroutine find_differences(routine, sizes, item, differences)
      type(driven_routine), intent(in) :: routine
      type(motion_sizes), intent(in) :: sizes
      type(driven_increment), intent(in) :: item
      type(differences_type), intent(out) :: differences
      type(point_motion) :: motion
      type(point_answer) :: left, right
      type(driven_routine) :: other
      real(wp) :: h
      integer :: k, step

      other = routine
      other%poison = 2
      call call_routine(other, item%start, item%motion, left)
      call call_routine(routine, item%start, motion_to(item%start, item%start%rdisp, &
         item%motion%dtime, kit=0), right)
      differences%is_set = same_bits(left%ddsddr, item%answer%ddsddr) &
         .and. (is_finite(item%answer%ddsddr) .or. is_finite(right%ddsddr))
      do k = 1, routine%ndir
         do step = 1, size(steps)
            h = steps(step)*merge(sizes%overclosure, sizes%slip, k == 1)
            motion = moved(item%motion, k, -h)
            call call_routine(routine, item%start, motion, left)
            motion = moved(item%motion, k, h)
            call call_routine(routine, item%start, motion, right)
            differences%known(k) = differences%known(k) .and. all(is_finite(left%stress)) &
               .and. all(is_finite(right%stress)) .and. left%pnewdt >= 1.0_wp &
               .and. right%pnewdt >= 1.0_wp
            if (.not. differences%known(k)) exit
            differences%values(:, k, 1, step) = (item%answer%stress - left%stress)/h
            differences%values(:, k, 2, step) = (right%stress - item%answer%stress)/h
            differences%values(:, k, 3, step) = (right%stress - left%stress)/(2.0_wp*h)
         end do
      end do
   end subroutine find_differences

   pure type(point_motion) function moved(motion, k, h)
      type(point_motion), intent(in) :: motion
      integer, intent(in) :: k
      real(wp), intent(in) :: h

      moved = motion
      moved%rdisp(k) = moved%rdisp(k) + h
      moved%drdisp(k) = moved%drdisp(k) + h
   end function moved

end module asperity_check_trial_tangent
