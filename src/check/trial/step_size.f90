!> Rule `step_size`: with more and more increments on the same path the tractions come to an end.
module asperity_check_trial_step_size
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_drive, only: drive, drive_record, place_of
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_step_size, severity_error
   use asperity_check_settings, only: check_settings
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_step_size

   !> Increments a row
   integer, parameter :: parts(4) = [1, 4, 16, 64]
   !> What the last quartering may change, of the largest traction of its kind: right laws of first
   !> order are at a hundredth or below where a row is ten times what they slip before they slide; a
   !> shear that is by increment and not by time changes by 0.047
   real(wp), parameter :: tolerance = 0.03_wp
   !> It must be less than this share of the change before, unless it is that small
   real(wp), parameter :: shrinks = 0.8_wp, small = 1.0e-3_wp
   character(len=*), parameter :: kinds(2) = [character(len=8) :: 'pressure', 'shear']

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
      ! of the pressure and of the shear, which may be much smaller; of each quartering
      real(wp) :: change(2, size(parts)), largest(2), off(2)
      integer :: i, row, kind, worst(2)

      path = main_path(settings)
      call drive(routine, path, parts(1), coarse)
      largest = largest_of(coarse)
      change = 0.0_wp
      do i = 2, size(parts)
         if (coarse%row_end(size(path%time)) == 0) return
         call drive(routine, path, parts(i), fine)
         if (fine%row_end(size(path%time)) == 0) return
         worst = 1
         do row = 1, size(path%time)
            if (coarse%row_end(row) == 0) cycle
            off = sizes_of(coarse%items(coarse%row_end(row))%answer%stress &
               - fine%items(fine%row_end(row))%answer%stress)
            where (off > change(:, i)) worst = row
            change(:, i) = max(change(:, i), off)
         end do
         coarse = fine
      end do
      do kind = 1, 2
         associate (last => change(kind, size(parts)), before => change(kind, :size(parts) - 1))
            if (last <= small*largest(kind)) cycle
            if (last <= tolerance*largest(kind) .and. last <= shrinks*maxval(before)) cycle
            call findings%add(rule_step_size, severity_error, trim(kinds(kind))// &
               ' at the end of row '//to_text(worst(kind))//', '// &
               place_of(coarse%items(coarse%row_end(worst(kind)))), &
               'tractions that come to an end as increments get shorter', &
               'quartering them thrice changes STRESS by '// &
               to_text(change(kind, 2), 3)//', '//to_text(change(kind, 3), 3)//' and '// &
               to_text(last, 3)//' MPa, of '//to_text(largest(kind), 3), &
               'results depend on the size of the increments, which ABAQUS chooses')
            return
         end associate
      end do
   end subroutine check_step_size

   !> Size of the pressure and of the shear.
   pure function sizes_of(stress) result(sizes)
      real(wp), intent(in) :: stress(3)
      real(wp) :: sizes(2)

      sizes(1) = abs(stress(1))
      sizes(2) = hypot(stress(2), stress(3))
   end function sizes_of

   !> The largest of a record.
   pure function largest_of(record) result(largest)
      type(drive_record), intent(in) :: record
      real(wp) :: largest(2)
      integer :: i

      largest = 0.0_wp
      do i = 1, record%n
         largest = max(largest, sizes_of(record%items(i)%answer%stress))
      end do
   end function largest_of

end module asperity_check_trial_step_size
