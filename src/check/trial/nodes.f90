!> Rule `repeat` of a VUINTER: a node's answer depends neither on the other nodes of the call nor on
!> their order or number.
module asperity_check_trial_nodes
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_call_vuinter, only: call_vuinter, new_vuinter_layout
   use asperity_check_driven_drive, only: drive, drive_record, place_of
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_point, only: point_answer, point_motion, point_start
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_guard, rule_repeat, severity_error
   use asperity_check_settings, only: check_settings
   use asperity_check_trial_guard, only: damage_text
   implicit none
   private
   public :: check_nodes

   !> What tractions may differ by, of the largest: a routine may well compute many nodes in another
   !> way than one, but not to other results
   real(wp), parameter :: tolerance = 1.0e-6_wp

contains

   !> Run the trial.
   subroutine check_nodes(routine, settings, findings)
      !> The routine, for one node
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(driven_routine) :: several
      type(point_start), allocatable :: starts(:)
      type(point_motion), allocatable :: motions(:)
      type(point_answer), allocatable :: answers(:), alone(:)
      real(wp) :: off, largest
      integer :: i, n, turn, k

      call drive(routine, main_path(settings), 1, record)
      n = record%n
      if (n == 0) return
      several = routine
      call new_vuinter_layout(several%layout, routine%ndir, routine%nstatv, size(routine%props), &
         n, settings%single_precision)
      allocate (starts(n), motions(n), answers(n), alone(n))
      do i = 1, n
         call call_routine(routine, record%items(i)%start, motion_of(routine, record, i), alone(i))
      end do
      largest = 0.0_wp
      do i = 1, n
         largest = max(largest, maxval(abs(record%items(i)%answer%stress)))
      end do
      ! all increments of the path as nodes of one call, in their order and backwards
      do turn = 1, 2
         do i = 1, n
            k = merge(i, n + 1 - i, turn == 1)
            starts(i) = record%items(k)%start
            motions(i) = motion_of(routine, record, k)
         end do
         call call_vuinter(several, starts, motions, answers)
         do i = 1, n
            k = merge(i, n + 1 - i, turn == 1)
            associate (item => record%items(k), a => answers(i), expected => alone(k))
               if (a%damaged_slot > 0) then
                  call findings%add(rule_guard, severity_error, damage_text(several, a), &
                     'nothing is written there', 'written to with '//to_text(n)//' nodes', &
                     'memory that is not the routine''s is overwritten')
                  return
               end if
               off = maxval(abs(a%stress - expected%stress))
               if (off <= tolerance*largest) cycle
               call findings%add(rule_repeat, severity_error, 'node '//to_text(i)//' of '// &
                  to_text(n)//', '//place_of(item), 'the traction of the node alone, '// &
                  to_text(expected%stress(1), 5)//', '//to_text(expected%stress(2), 5)// &
                  ' MPa', to_text(a%stress(1), 5)//', '//to_text(a%stress(2), 5)//' MPa', &
                  'forces of a node depend on what else is in contact, and on how ABAQUS '// &
                  'groups the nodes')
               return
            end associate
         end do
      end do
   end subroutine check_nodes

   !> The motion of an increment as one of several nodes: a call has one time, and each node a turn
   !> of its own.
   type(point_motion) function motion_of(routine, record, k) result(motion)
      type(driven_routine), intent(in) :: routine
      type(drive_record), intent(in) :: record
      integer, intent(in) :: k
      real(wp) :: angle

      motion = record%items(k)%motion
      motion%dtime = record%items(1)%motion%dtime
      if (routine%ndir /= 3) return
      angle = 0.1_wp*k
      motion%drot = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
   end function motion_of

end module asperity_check_trial_nodes
