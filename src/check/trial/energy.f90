!> Rule `energy`: stored energy and dissipation make up the work of the tractions, pressed and lifted
!> without slip, and slid to and fro at one overclosure. There are no other paths: where the
!> pressure changes under an elastic slip, some right laws keep no balance.
module asperity_check_trial_energy
   use, intrinsic :: iso_fortran_env, only: real32
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record
   use asperity_check_driven_layout, only: same_bits
   use asperity_check_driven_paths, only: main_path, motion_sizes, path_of, sizes_of
   use asperity_check_driven_point, only: point_answer, point_start
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
      call check_path('pressed and lifted without slip', 1, path_of(sizes, [-1.0_wp, 0.5_wp, &
         1.0_wp, 0.5_wp, -1.0_wp, -1.0_wp], [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp]))
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
               call findings%add(rule_energy, severity_warning, name, 'numbers in SED, SFD, SPD, '// &
                  'SVD and SCD', 'none', 'energies of the model''s output are none')
               return
            end if
            off(i) = abs(sums(i)%work - sums(i)%stored - sums(i)%dissipated)/sums(i)%turned_over
         end do
         if (off(2) <= tolerance .or. off(2) <= remains*off(1)) return
         associate (s => sums(2))
            call findings%add(rule_energy, merge(severity_warning, severity_note, s%is_given), name, &
               to_text(s%work, 4)//' N/mm, the work of the tractions', to_text(s%stored, 4)// &
               ' N/mm more in SED and '//to_text(s%dissipated, 4)//' in SFD, SPD, SVD and SCD', &
               'forces are not concerned; energies of the model''s output (ALLSE, ALLFD and the '// &
               'like) do not balance')
         end associate
      end subroutine check_path

   end subroutine check_energy

   !> Sums from the end of a row on.
   type(energy_sums) function sums_along(routine, path, parts, from_row) result(sums)
      type(driven_routine), intent(in) :: routine
      type(motion_path), intent(in) :: path
      integer, intent(in) :: parts, from_row
      type(drive_record) :: record
      real(wp) :: work
      integer :: i

      call drive(routine, path, parts, record)
      sums%is_complete = record%row_end(size(path%time)) > 0
      if (.not. sums%is_complete) return
      do i = record%row_end(from_row) + 1, record%n
         associate (item => record%items(i), before => record%items(i)%start)
            work = 0.5_wp*sum((before%stress + item%answer%stress)*item%motion%drdisp)
            sums%work = sums%work + work
            sums%turned_over = sums%turned_over + abs(work)
            sums%dissipated = sums%dissipated + item%answer%dissipation
            sums%is_given = sums%is_given .or. abs(item%answer%sed) > 0.0_wp &
               .or. abs(item%answer%dissipation) > 0.0_wp
         end associate
      end do
      sums%stored = record%items(record%n)%answer%sed &
         - record%items(record%row_end(from_row))%answer%sed
   end function sums_along

   !> Whether the routine sets its energies at all, which is another rule's: none is just what it
   !> held before.
   logical function energies_are_set(routine, path)
      type(driven_routine), intent(in) :: routine
      type(motion_path), intent(in) :: path
      ! a stored energy of the start that no law gives
      real(wp), parameter :: held = 0.7391482_wp
      type(drive_record) :: record
      type(driven_routine) :: other
      type(point_start) :: start
      type(point_answer) :: answer
      logical :: is_stored
      integer :: i

      call drive(routine, path, 1, record)
      energies_are_set = .true.
      is_stored = .false.
      other = routine
      other%poison = 2
      do i = 1, record%n
         associate (item => record%items(i))
            start = item%start
            call call_routine(other, start, item%motion, answer)
            energies_are_set = energies_are_set .and. same_bits(answer%dissipation, &
               item%answer%dissipation)
            start%sed = real(real(held, real32), wp)
            call call_routine(routine, start, item%motion, answer)
            is_stored = is_stored .or. .not. same_bits(answer%sed, start%sed)
         end associate
      end do
      energies_are_set = energies_are_set .and. is_stored
   end function energies_are_set

end module asperity_check_trial_energy
