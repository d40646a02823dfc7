!> States of the solid joint that are kept: which, and through a file.
module test_program_solid_snapshots
   use asperity_base_kinds, only: wp
   use asperity_program_commands_solid_snapshot, only: lower_peak, lower_unloaded, no_snapshot, &
      snapshot_kind, solid_snapshot, upper_peak, upper_unloaded
   use asperity_program_commands_solid_snapshots_file, only: read_snapshots, write_snapshots
   use asperity_solid_solve_programme, only: solid_run
   use asperity_solid_solve_record, only: increment_record
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use made_outcomes, only: made_snapshot
   implicit none
   private
   public :: suite_snapshots

contains

   function suite_snapshots() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('snapshots')
      call suite%addTest(TestMethod('which states are kept', test_kinds))
      call suite%addTest(TestMethod('through a file', test_file))
   end function suite_snapshots

   !> Two cycles of the largest amplitude after one of a smaller: only the first of them counts.
   subroutine test_kinds()
      real(wp), parameter :: turns(*) = [0.0_wp, 8.0_wp, -8.0_wp, 48.0_wp, -48.0_wp, 48.0_wp, &
         -48.0_wp, 0.0_wp]
      ! 2 % of 48 mm is 0.96 mm
      real(wp), parameter :: parts(*) = [0.009_wp, 0.012_wp, 0.5_wp, 1.0_wp]
      type(solid_run) :: run
      integer :: i, j, seen(4)

      run%model%turns = turns
      allocate (run%records(0))
      call assertEqual(no_snapshot, snapshot_kind(run))
      seen = 0
      do i = 2, size(turns)
         do j = 1, size(parts)
            run%records = [run%records, increment_record(stroke=i - 1, &
               displacement=turns(i - 1) + parts(j)*(turns(i) - turns(i - 1)))]
            associate (kind => snapshot_kind(run))
               if (kind == no_snapshot) cycle
               call assertEqual(0, seen(kind))
               seen(kind) = size(run%records)
            end associate
         end do
      end do
      ! 1.2 % of a stroke of 96 mm is 1.15 mm
      call assertEqual(12, seen(upper_peak))
      call assertEqual(14, seen(upper_unloaded))
      call assertEqual(16, seen(lower_peak))
      call assertEqual(18, seen(lower_unloaded))
   end subroutine test_kinds

   subroutine test_file()
      type(solid_snapshot) :: snapshots(2)
      type(solid_snapshot), allocatable :: found(:)
      integer :: unit, status

      snapshots = [made_snapshot(upper_peak, 24.0_wp, 1.0_wp/3.0_wp), &
         made_snapshot(lower_peak, -24.0_wp, 0.1_wp)]
      open (newunit=unit, status='scratch', access='stream', form='unformatted', &
         action='readwrite')
      call write_snapshots(unit, snapshots, status)
      call assertEqual(0, status)
      rewind (unit)
      call read_snapshots(unit, 1, found, status)
      call assertEqual(0, status)
      call assertEqual(2, size(found))
      call assertEqual(lower_peak, found(2)%kind)
      call assertEqual(-24.0_wp, found(2)%displacement, 0.0_wp)
      call assertTrue(all(abs(found(1)%contact%pressure - snapshots(1)%contact%pressure) <= 0.0_wp))
      call assertTrue(all(found(1)%contact%status == snapshots(1)%contact%status))
      call assertTrue(all(abs(found(1)%stress - snapshots(1)%stress) <= 0.0_wp))
      call assertEqual(0.25_wp, found(2)%plastic_strain(1), 0.0_wp)
      ! of a joint with two elements
      rewind (unit)
      call read_snapshots(unit, 2, found, status)
      call assertTrue(status > 0)
      ! cut short
      close (unit)
      open (newunit=unit, status='scratch', access='stream', form='unformatted', &
         action='readwrite')
      write (unit) 1, upper_peak
      rewind (unit)
      call read_snapshots(unit, 1, found, status)
      call assertTrue(status /= 0)
      close (unit)
   end subroutine test_file

end module test_program_solid_snapshots
