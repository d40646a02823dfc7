!> Rule `no_surface`: RDISP(1) = -1.E36, no opposite surface, gives no traction and finite numbers,
!> before and after contact, and a state that a contact found later survives.
module asperity_check_trial_no_surface
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, largest_stress, &
      place_of
   use asperity_check_driven_layout, only: entry_name, is_input
   use asperity_check_driven_left, only: stress_left
   use asperity_check_driven_paths, only: motion_sizes, path_of, sizes_of
   use asperity_check_driven_point, only: has_surface
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_no_surface, severity_error
   use asperity_check_settings, only: check_settings
   use asperity_contact_state, only: no_opposite_surface
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_no_surface

   !> Traction without a surface, of the largest one: a law that fades out need not be just zero
   real(wp), parameter :: faded = 1.0e-6_wp
   !> How far the pressure may be off that of a point that came from a gap, after two increments
   !> of rest: that much may be left of a jump
   real(wp), parameter :: tolerance = 0.01_wp
   !> The increment that finds a surface has a DRDISP(1) of up to 1e36, and may have a jump; but no
   !> traction beyond all others
   real(wp), parameter :: beyond = 10.0_wp
   character(len=*), parameter :: lost = &
      'points that lie beside the other surface get forces, or the job ends'

contains

   !> Run the trial.
   subroutine check_no_surface(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(motion_sizes) :: sizes
      type(motion_path) :: path
      type(drive_record) :: known, record
      ! where the surface is lost, with slip, and found, also again
      integer, parameter :: lost_row = 8, found = 3, found_again = 10
      logical :: is_left(3)
      integer :: found_before, rows, row

      sizes = sizes_of(settings)
      path = path_of(sizes, [-1.0_wp, -1.0_wp, 0.3_wp, 1.0_wp, 1.0_wp, 1.0_wp, 0.6_wp, -1.0_wp, &
         -0.9_wp, 0.3_wp, 1.0_wp, 1.0_wp, 1.0_wp], [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
         0.0_wp, 0.1_wp, 0.2_wp, 0.2_wp, 0.2_wp, 0.2_wp, 0.2_wp, 0.2_wp])
      call drive(routine, path, 1, known)
      path%overclosure(1:2) = no_opposite_surface
      path%overclosure(lost_row:lost_row + 1) = no_opposite_surface
      call drive(routine, path, 1, record)
      rows = size(path%time)
      found_before = findings%n
      ! what is no number or not set in a gap either is another rule's
      if (known%unusable .or. .not. all_numbers(known)) return
      is_left = .false.
      if (known%row_end(lost_row) > 0) is_left = stress_left(routine, &
         known%items(known%row_end(lost_row)), largest_stress(known))
      call check_numbers(routine, record, largest_stress(known), is_left, findings)
      if (findings%n > found_before .or. known%row_end(rows) == 0) return
      if (record%row_end(rows) == 0) then
         call findings%add(rule_no_surface, severity_error, place_of(record%refused), &
            'an increment that is through, as it is when the point came from a gap', &
            'the routine asks for ever smaller increments', lost)
         return
      end if
      do row = found, found_again, found_again - found
         call check_found(record%items(record%row_end(row)))
         if (findings%n > found_before) return
      end do
      call compare(6, 'found from the start on')
      if (findings%n == found_before) call compare(rows, 'found again')

   contains

      subroutine check_found(item)
         type(driven_increment), intent(in) :: item
         integer :: k

         k = maxloc(abs(item%answer%stress), dim=1)
         if (abs(item%answer%stress(k)) <= beyond*largest_stress(known)) return
         call findings%add(rule_no_surface, severity_error, 'STRESS('//to_text(k)// &
            ') where a surface is found, DRDISP(1) = '//to_text(item%motion%drdisp(1), 3)// &
            ' mm, '//place_of(item), 'no more than '//to_text(largest_stress(known), 3)// &
            ' MPa, the largest when the point comes from a gap', &
            to_text(item%answer%stress(k), 5)//' MPa', 'contact that begins where no surface '// &
            'was is wrong')
      end subroutine check_found

      subroutine compare(row, how)
         integer, intent(in) :: row
         character(len=*), intent(in) :: how
         real(wp) :: expected, pressure

         expected = known%items(known%row_end(row))%answer%stress(1)
         pressure = record%items(record%row_end(row))%answer%stress(1)
         if (abs(pressure - expected) <= tolerance*abs(expected)) return
         call findings%add(rule_no_surface, severity_error, &
            'STRESS(1) after a surface was '//how//', '// &
            place_of(record%items(record%row_end(row))), to_text(expected, 5)// &
            ' MPa, as when the point comes from a gap', to_text(pressure, 5)//' MPa', &
            'contact that begins where no surface was is wrong')
      end subroutine compare

   end subroutine check_no_surface

   !> Whether all that the routine answers are numbers.
   pure logical function all_numbers(record)
      type(drive_record), intent(in) :: record
      integer :: i

      all_numbers = .true.
      do i = 1, record%n
         all_numbers = all_numbers .and. all(is_finite(record%items(i)%answer%numbers))
      end do
   end function all_numbers

   !> Tractions without a surface, and numbers that are none.
   subroutine check_numbers(routine, record, largest, is_left, findings)
      type(driven_routine), intent(in) :: routine
      type(drive_record), intent(in) :: record
      real(wp), intent(in) :: largest
      logical, intent(in) :: is_left(3)
      type(finding_list), intent(inout) :: findings
      integer :: i, k

      do i = 1, record%n
         associate (item => record%items(i))
            call report_no_number(routine, item, findings)
            if (has_surface(item%motion%rdisp(1))) cycle
            k = maxloc(abs(item%answer%stress), dim=1, mask=.not. is_left)
            if (k == 0) cycle
            if (abs(item%answer%stress(k)) > faded*largest) then
               call findings%add(rule_no_surface, severity_error, 'STRESS('//to_text(k)//'), '// &
                  place_of(item), '0', to_text(item%answer%stress(k), 5)//' MPa', lost)
               return
            end if
         end associate
      end do
      if (record%unusable) call report_no_number(routine, record%refused, findings)
   end subroutine check_numbers

   subroutine report_no_number(routine, item, findings)
      type(driven_routine), intent(in) :: routine
      type(driven_increment), intent(in) :: item
      type(finding_list), intent(inout) :: findings
      integer :: i, k

      ! with a surface now and before it is no matter of this rule
      if (has_surface(item%motion%rdisp(1)) .and. has_surface(item%start%rdisp(1))) return
      do i = 1, size(routine%layout%slots)
         associate (slot => routine%layout%slots(i))
            if (slot%role == is_input) cycle
            do k = 1, slot%length
               if (is_finite(item%answer%numbers(slot%number + k - 1))) cycle
               call findings%add(rule_no_surface, severity_error, entry_name(slot, k)//', '// &
                  place_of(item), 'a number', to_text(item%answer%numbers(slot%number + k - 1)), &
                  lost)
               return
            end do
         end associate
      end do
   end subroutine report_no_number

end module asperity_check_trial_no_surface
