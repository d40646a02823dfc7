!> Rule `perturbation`: in a linear perturbation step (LINPER = 1) STRESS is DDSDDR times RDISP with
!> one DDSDDR for all perturbations, and neither STATEV nor a status changes.
module asperity_check_trial_perturbation
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, place_of
   use asperity_check_driven_layout, only: same_bits
   use asperity_check_driven_paths, only: main_path, motion_sizes, sizes_of
   use asperity_check_driven_point, only: motion_to, next_start, point_answer, point_motion, &
      point_start
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_perturbation, severity_warning
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_perturbation

   !> Perturbation, of the sizes of the motion: so small that a law is linear over it, and so large
   !> that a position is not lost in rounding
   real(wp), parameter :: share = 1.0e-3_wp
   !> What tractions and stiffnesses may be off, of the largest
   real(wp), parameter :: tolerance = 1.0e-6_wp
   character(len=*), parameter :: effect = 'frequencies, buckling and steady-state dynamics '// &
      'about this state are wrong; other procedures are not concerned'

contains

   !> Run the trial. It ends at the first finding: a routine that does not look at LINPER has many.
   subroutine check_perturbation(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(motion_sizes) :: sizes
      real(wp) :: perturbation(3)
      integer :: i, found_before

      sizes = sizes_of(settings)
      found_before = findings%n
      call drive(routine, main_path(settings), 1, record)
      perturbation = share*[sizes%overclosure, sizes%slip, -0.5_wp*sizes%slip]
      if (routine%ndir == 2) perturbation(3) = 0.0_wp
      do i = 1, record%n
         call try_state(routine, record%items(i), perturbation, findings)
         if (findings%n > found_before) return
      end do
   end subroutine check_perturbation

   !> Both signs of a perturbation about the state after an increment.
   subroutine try_state(routine, item, perturbation, findings)
      type(driven_routine), intent(in) :: routine
      type(driven_increment), intent(in) :: item
      real(wp), intent(in) :: perturbation(3)
      type(finding_list), intent(inout) :: findings
      type(point_start) :: base
      type(point_motion) :: motion
      type(point_answer) :: answers(2)
      real(wp) :: expected(3), largest
      integer :: i, k

      call next_start(item%start, item%motion, item%answer, base)
      ! inputs are perturbations too
      base%stress = 0.0_wp
      do i = 1, 2
         motion%rdisp = merge(perturbation, -perturbation, i == 1)
         motion%drdisp = motion%rdisp
         motion%dtime = item%motion%dtime
         motion%linper = 1
         call call_routine(routine, base, motion, answers(i))
         if (.not. all_finite(answers(i)%stress) .or. .not. all(abs(answers(i)%ddsddr) &
               <= huge(largest))) then
            call report('STRESS and DDSDDR', 'numbers', 'none')
            return
         end if
         expected = matmul(answers(i)%ddsddr, motion%rdisp)
         largest = max(maxval(abs(expected)), maxval(abs(answers(i)%stress)))
         do k = 1, routine%ndir
            if (abs(answers(i)%stress(k) - expected(k)) <= tolerance*largest) cycle
            call report('STRESS('//to_text(k)//')', to_text(expected(k), 5)// &
               ' MPa, DDSDDR times RDISP', to_text(answers(i)%stress(k), 5)//' MPa')
            return
         end do
         if (.not. all(same_bits(answers(i)%statev, base%statev))) then
            k = findloc(same_bits(answers(i)%statev, base%statev), .false., dim=1)
            call report('STATEV('//to_text(k)//')', to_text(base%statev(k), 5)//', as it was', &
               to_text(answers(i)%statev(k), 5))
            return
         end if
         if (answers(i)%lopenclose /= base%lopenclose .or. answers(i)%lstate /= base%lstate &
            .or. answers(i)%lsdi /= 0 .or. answers(i)%pnewdt < 1.0_wp) then
            call report('LOPENCLOSE, LSTATE, LSDI and PNEWDT', 'as they were', 'changed')
            return
         end if
      end do
      largest = max(maxval(abs(answers(1)%ddsddr)), maxval(abs(answers(2)%ddsddr)))
      if (.not. all(abs(answers(1)%ddsddr - answers(2)%ddsddr) <= tolerance*largest)) then
         call report('DDSDDR', 'the same for a perturbation and its opposite', 'two different ones')
      else if (abs(answers(1)%ddsddr(1, 1)) <= 0.0_wp) then
         if (presses_at_rest()) call report('DDSDDR(1,1)', &
            'a stiffness where faces press, as the '//to_text( &
            item%answer%ddsddr(1, 1), 5)//' MPa/mm of the increment', '0')
      end if

   contains

      !> Whether there is a pressure with a stiffness; that of viscosity is none at rest
      logical function presses_at_rest()
         type(point_start) :: rest
         type(point_answer) :: still

         presses_at_rest = .false.
         if (.not. is_finite(item%answer%ddsddr(1, 1))) return
         if (.not. item%answer%ddsddr(1, 1) > 0.0_wp) return
         call next_start(item%start, item%motion, item%answer, rest)
         call call_routine(routine, rest, motion_to(rest, rest%rdisp, item%motion%dtime, kit=1), &
            still)
         if (is_finite(still%stress(1))) presses_at_rest = still%stress(1) > 0.0_wp
      end function presses_at_rest

      subroutine report(what, expected, found)
         character(len=*), intent(in) :: what, expected, found

         call findings%add(rule_perturbation, severity_warning, what//' with LINPER = 1 after '// &
            place_of(item), expected, found, effect)
      end subroutine report

   end subroutine try_state

end module asperity_check_trial_perturbation
