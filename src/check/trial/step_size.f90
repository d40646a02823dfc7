!> Rule `step_size`: with more and more increments on the same path the tractions come to an end.
module asperity_check_trial_step_size
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_drive, only: drive, drive_record, largest_stress, place_of
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_step_size, severity_error
   use asperity_check_settings, only: check_settings
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_step_size

   !> Increments a row
   integer, parameter :: parts(4) = [1, 2, 4, 8]
   !> What the last halving may change, of the largest traction: right laws of first order are
   !> below a hundredth
   real(wp), parameter :: tolerance = 0.05_wp
   !> Changes that do not shrink to this share per halving, unless they are that small
   real(wp), parameter :: shrinks = 0.8_wp, small = 1.0e-3_wp

contains

   !> Run the trial.
   subroutine check_step_size(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(motion_path) :: path
      type(drive_record) :: coarse, fine
      real(wp) :: change(size(parts)), largest
      integer :: i, row, worst

      path = main_path(settings)
      call drive(routine, path, parts(1), coarse)
      largest = largest_stress(coarse)
      change = 0.0_wp
      worst = 0
      do i = 2, size(parts)
         if (coarse%row_end(size(path%time)) == 0) return
         call drive(routine, path, parts(i), fine)
         if (fine%row_end(size(path%time)) == 0) return
         largest = max(largest, largest_stress(fine))
         do row = 1, size(path%time)
            if (coarse%row_end(row) == 0) cycle
            associate (a => coarse%items(coarse%row_end(row))%answer%stress, &
                  b => fine%items(fine%row_end(row))%answer%stress)
               if (maxval(abs(a - b)) <= change(i)) cycle
               change(i) = maxval(abs(a - b))
               worst = row
            end associate
         end do
         if (i < size(parts)) coarse = fine
      end do
      associate (last => change(size(parts)), before => change(size(parts) - 1))
         if (last <= small*largest) return
         if (last <= tolerance*largest .and. last <= shrinks*before) return
         call findings%add(rule_step_size, severity_error, place_of( &
            coarse%items(coarse%row_end(worst))), 'tractions that come to an end as increments '// &
            'get shorter', 'halving them changes STRESS by '//to_text(change(2), 3)//', '// &
            to_text(before, 3)//' and '//to_text(last, 3)//' MPa, of '//to_text(largest, 3), &
            'results depend on the size of the increments, which ABAQUS chooses')
      end associate
   end subroutine check_step_size

end module asperity_check_trial_step_size
