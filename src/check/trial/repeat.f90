!> Rule `repeat`: the same input gives the same bits, in whatever order, also after a longer attempt
!> from the same start that was given up.
module asperity_check_trial_repeat
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, place_of
   use asperity_check_driven_layout, only: entry_name, same_bits
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_point, only: motion_to, point_answer, point_motion, same_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_repeat, severity_error
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_repeat, difference_text

contains

   !> Run the trial. It ends at the first finding: one cause makes all of them.
   subroutine check_repeat(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(point_answer) :: first, again
      type(point_motion) :: motion
      integer :: i

      call drive(routine, main_path(settings), 1, record)
      do i = 1, record%n
         associate (item => record%items(i))
            call call_routine(routine, item%start, item%motion, first)
            call call_routine(routine, item%start, item%motion, again)
            if (reported('twice in a row', item, first, again)) return
            motion = motion_to(item%start, halfway(item), item%motion%dtime/2, kit=1)
            call call_routine(routine, item%start, motion, first)
            call call_routine(routine, item%start, item%motion, again)
            call call_routine(routine, item%start, motion, again)
            if (reported('before and after a longer attempt', item, first, again)) return
         end associate
      end do
      do i = record%n, 1, -1
         associate (item => record%items(i))
            call call_routine(routine, item%start, item%motion, again)
            if (reported('and after other points', item, item%answer, again)) return
         end associate
      end do

   contains

      logical function reported(when, item, a, b)
         character(len=*), intent(in) :: when
         type(driven_increment), intent(in) :: item
         type(point_answer), intent(in) :: a, b

         reported = .not. same_answer(a, b)
         if (.not. reported) return
         call findings%add(rule_repeat, severity_error, place_of(item), &
            'the same answer for the same input, '//when, difference_text(routine, a, b), &
            'iterations do not converge to one answer, and results depend on the order of '// &
            'points and on the number of calls')
      end function reported

   end subroutine check_repeat

   !> The position in the middle of an increment.
   pure function halfway(item) result(position)
      type(driven_increment), intent(in) :: item
      real(wp) :: position(3)

      position = 0.5_wp*(item%start%rdisp + item%motion%rdisp)
   end function halfway

   !> The first number that differs.
   function difference_text(routine, a, b) result(text)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> Two answers
      type(point_answer), intent(in) :: a, b
      character(len=:), allocatable :: text
      integer :: i, k

      text = 'another LOPENCLOSE, LSTATE or LSDI'
      do i = 1, size(routine%layout%slots)
         associate (slot => routine%layout%slots(i))
            do k = 1, slot%length
               associate (x => a%numbers(slot%number + k - 1), y => b%numbers(slot%number + k - 1))
                  if (same_bits(x, y)) cycle
                  text = entry_name(slot, k)//' = '//to_text(x)//' and '//to_text(y)
                  return
               end associate
            end do
         end associate
      end do
   end function difference_text

end module asperity_check_trial_repeat
