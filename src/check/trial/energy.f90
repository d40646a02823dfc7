!> Rule `energy`: stored energy and dissipation make up the work of the tractions, pressed and
!> lifted without slip, and slid to and fro at one overclosure. There are no other paths: where the
!> pressure changes under an elastic slip, some right laws keep no balance.
module asperity_check_trial_energy
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record
   use asperity_check_driven_layout, only: same_bits
   use asperity_check_driven_left, only: stored_is_set
   use asperity_check_driven_paths, only: main_path, motion_sizes, path_of, sizes_of
   use asperity_check_driven_point, only: point_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_energy, severity_note, severity_warning
   use asperity_check_settings, only: check_settings
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_energy

   !> Increments a row, twice: the work is a sum of trapezoids, whose error goes down with them
   integer, parameter :: parts(2) = [64, 128]
   !> What the balance may be off, of all work turned over; and what is left of that when there are
   !> twice as many increments, where the error is that of the sum
   real(wp), parameter :: tolerance = 0.01_wp, remains = 0.7_wp

   !> Pressed and lifted, in shares of the gap (negative) and of the largest overclosure: rows get
   !> short where a law begins to act
   real(wp), parameter :: closures(13) = [-1.0_wp, -0.1_wp, -0.01_wp, -0.001_wp, 0.0_wp, 0.3_wp, &
      1.0_wp, 0.3_wp, 0.0_wp, -0.001_wp, -0.01_wp, -0.1_wp, -1.0_wp]

   !> Sums along a path, N/mm.
   type :: energy_sums
      !> Work of the tractions, and all that was turned over
      real(wp) :: work = 0.0_wp, turned_over = 0.0_wp
      !> Change of the stored energy, and dissipation
      real(wp) :: stored = 0.0_wp, dissipated = 0.0_wp
      logical :: is_complete = .false., is_given = .false.
   end type energy_sums

contains

   !> Run the trial.
   subroutine check_energy(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(motion_sizes) :: sizes
      integer :: found_before

      if (.not. energies_are_set(routine, main_path(settings))) return
      sizes = sizes_of(settings)
      found_before = findings%n
      call check_path('pressed and lifted without slip', 1, path_of(sizes, closures, &
         0.0_wp*closures))
      if (findings%n > found_before) return
      call check_path('slid to and fro under pressure', 3, path_of(sizes, [-1.0_wp, 1.0_wp, &
         1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp], [0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, -0.6_wp, 0.0_wp]))

   contains

      subroutine check_path(name, from_row, path)
         character(len=*), intent(in) :: name
         integer, intent(in) :: from_row
         type(motion_path), intent(in) :: path
         type(energy_sums) :: sums(size(parts))
         real(wp) :: off(size(parts))
         integer :: i

         do i = 1, size(parts)
            sums(i) = sums_along(routine, path, parts(i), from_row)
            if (.not. sums(i)%is_complete .or. .not. sums(i)%turned_over > 0.0_wp) return
            if (.not. is_finite(sums(i)%stored + sums(i)%dissipated)) then
               call findings%add(rule_energy, severity_warning, name, &
                  'numbers in SED, SFD, SPD, SVD and SCD', 'none', &
                  'energies of the model''s output are none')
               return
            end if
            off(i) = imbalance(sums(i))/sums(i)%turned_over
         end do
         if (off(2) <= tolerance .or. off(2) <= remains*off(1)) return
         associate (s => sums(2))
            call findings%add(rule_energy, merge(severity_warning, severity_note, s%is_given), &
               name, to_text(s%work, 4)//' N/mm, the work of the tractions', &
               to_text(s%stored, 4)//' N/mm more in SED and '// &
               to_text(s%dissipated, 4)//' in SFD, SPD, SVD and SCD', &
               'forces are not concerned; energies of the model''s output (ALLSE, ALLFD and '// &
               'the like) do not balance')
         end associate
      end subroutine check_path

   end subroutine check_energy

   pure real(wp) function imbalance(sums)
      type(energy_sums), intent(in) :: sums

      imbalance = abs(sums%work - sums%stored - sums%dissipated)
   end function imbalance

   !> Sums from the end of a row to that of the row where the balance is off most.
   type(energy_sums) function sums_along(routine, path, parts, from_row) result(sums)
      type(driven_routine), intent(in) :: routine
      type(motion_path), intent(in) :: path
      integer, intent(in) :: parts, from_row
      type(drive_record) :: record
      type(energy_sums) :: so_far
      real(wp) :: work
      integer :: i, row

      call drive(routine, path, parts, record)
      if (record%row_end(size(path%time)) == 0) return
      do row = from_row + 1, size(path%time)
         do i = record%row_end(row - 1) + 1, record%row_end(row)
            associate (item => record%items(i), before => record%items(i)%start)
               work = 0.5_wp*sum((before%stress + item%answer%stress)*item%motion%drdisp)
               so_far%work = so_far%work + work
               so_far%turned_over = so_far%turned_over + abs(work)
               so_far%dissipated = so_far%dissipated + item%answer%dissipation
               so_far%is_given = so_far%is_given .or. abs(item%answer%sed) > 0.0_wp &
                  .or. abs(item%answer%dissipation) > 0.0_wp
            end associate
         end do
         so_far%stored = record%items(record%row_end(row))%answer%sed &
            - record%items(record%row_end(from_row))%answer%sed
         if (row == from_row + 1 .or. imbalance(so_far) > imbalance(sums)) sums = so_far
         if (.not. is_finite(so_far%stored + so_far%dissipated)) exit
      end do
      sums%turned_over = so_far%turned_over
      sums%is_complete = .true.
   end function sums_along

   !> Whether the routine sets its energies at all, which is another rule's: none is just what it
   !> held before.
   logical function energies_are_set(routine, path)
      type(driven_routine), intent(in) :: routine
      type(motion_path), intent(in) :: path
      type(drive_record) :: record
      type(driven_routine) :: other
      type(point_answer) :: answer
      integer :: i

      call drive(routine, path, 1, record)
      energies_are_set = stored_is_set(routine, record)
      other = routine
      other%poison = 2
      do i = 1, record%n
         associate (item => record%items(i))
            call call_routine(other, item%start, item%motion, answer)
            energies_are_set = energies_are_set .and. same_bits(answer%dissipation, &
               item%answer%dissipation)
         end associate
      end do
   end function energies_are_set

end module asperity_check_trial_energy
