!> Rule `sign`: compression is positive and does not fall as faces close, a gap does not press like
!> a contact, and the first slip from rest is resisted. Tension is allowed.
module asperity_check_trial_sign
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, largest_stress, &
      place_of
   use asperity_check_driven_paths, only: motion_sizes, path_of, sizes_of
   use asperity_check_driven_point, only: motion_to, next_start, point_answer, point_start
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_sign, severity_error
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_sign

   !> Shares of the gap (negative) and of the largest overclosure
   real(wp), parameter :: closures(7) = [-1.0_wp, -0.5_wp, 0.0_wp, 0.1_wp, 0.4_wp, 0.7_wp, 1.0_wp]
   integer, parameter :: widest = 1, shallow = 4, deep = 6, deepest = 7
   !> Of the largest traction: less is rounding, also in single precision
   real(wp), parameter :: rounding = 1.0e-5_wp
   !> First slip from rest, of the largest: so small that most laws stick
   real(wp), parameter :: first_slip = 0.01_wp

contains

   !> Run the trial.
   subroutine check_sign(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(motion_sizes) :: sizes
      real(wp) :: p(size(closures)), largest
      integer :: i

      sizes = sizes_of(settings)
      call drive(routine, path_of(sizes, closures, 0.0_wp*closures), 1, record)
      if (record%row_end(deepest) == 0) return
      largest = largest_stress(record)
      if (.not. largest > 0.0_wp) return
      do i = 1, size(closures)
         p(i) = record%items(record%row_end(i))%answer%stress(1)
      end do
      if (.not. p(deepest) > 0.0_wp) then
         call report(deepest, 'more than 0: compression is positive', &
            'faces that touch pull each other together')
      else if (p(deepest) < p(deep) - rounding*largest) then
         call report(deepest, 'no less than the '// &
            to_text(p(deep), 5)//' MPa before it: pressure does not fall as faces close', &
            'faces that are pressed give way')
      else if (p(widest) > 0.0_wp .and. p(widest) > p(shallow) + rounding*largest) then
         call report(widest, 'no more than the '// &
            to_text(p(shallow), 5)//' MPa at an overclosure of '// &
            to_text(closures(shallow)*sizes%overclosure, 3)// &
            ' mm: RDISP(1) is negative in a gap', 'faces repel each other from afar')
      end if
      call check_shear(routine, sizes, record%items(record%row_end(deepest)), largest, findings)

   contains

      subroutine report(row, expected, effect)
         integer, intent(in) :: row
         character(len=*), intent(in) :: expected, effect

         call findings%add(rule_sign, severity_error, 'STRESS(1), '// &
            place_of(record%items(record%row_end(row))), expected, to_text(p(row), 5)//' MPa', &
            effect)
      end subroutine report

   end subroutine check_sign

   !> The first slip, to both sides in each direction.
   subroutine check_shear(routine, sizes, item, largest, findings)
      type(driven_routine), intent(in) :: routine
      type(motion_sizes), intent(in) :: sizes
      type(driven_increment), intent(in) :: item
      real(wp), intent(in) :: largest
      type(finding_list), intent(inout) :: findings
      type(point_start) :: rest
      type(point_answer) :: answer
      real(wp) :: position(3)
      integer :: k, side

      call next_start(item%start, item%motion, item%answer, rest)
      do k = 2, routine%ndir
         do side = -1, 1, 2
            position = rest%rdisp
            position(k) = position(k) + side*first_slip*sizes%slip
            call call_routine(routine, rest, motion_to(rest, position, sizes%dtime, kit=1), answer)
            if (side*answer%stress(k) >= -rounding*largest) cycle
            call findings%add(rule_sign, severity_error, &
               'STRESS('//to_text(k)//'), first slip of '// &
               to_text(side*first_slip*sizes%slip, 3)//' mm after '//place_of(item), &
               'the sign of the slip', to_text(answer%stress(k), 5)//' MPa', &
               'friction drives the faces on in place of holding them')
            return
         end do
      end do
   end subroutine check_shear

end module asperity_check_trial_sign
