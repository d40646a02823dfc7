!> Snapshots kept beside a run, on a unit opened for unformatted stream access.
module asperity_program_commands_solid_snapshots_file
   use asperity_program_commands_solid_snapshot, only: solid_snapshot
   implicit none
   private
   public :: write_snapshots, read_snapshots

contains

   !> Write snapshots.
   subroutine write_snapshots(unit, snapshots, status)
      !> The unit
      integer, intent(in) :: unit
      !> The snapshots
      type(solid_snapshot), intent(in) :: snapshots(:)
      !> Not zero on failure, as iostat
      integer, intent(out) :: status
      integer :: i

      write (unit, iostat=status) size(snapshots)
      if (status /= 0) return
      do i = 1, size(snapshots)
         associate (s => snapshots(i))
            write (unit, iostat=status) s%kind, s%stroke, s%displacement, size(s%contact), &
               size(s%plastic_strain)
            if (status /= 0) return
            write (unit, iostat=status) s%contact, s%plastic_strain, s%stress
            if (status /= 0) return
         end associate
      end do
   end subroutine write_snapshots

   !> Read snapshots of a joint.
   subroutine read_snapshots(unit, n_elements, snapshots, status)
      !> The unit
      integer, intent(in) :: unit
      !> Elements of the joint
      integer, intent(in) :: n_elements
      !> The snapshots
      type(solid_snapshot), allocatable, intent(out) :: snapshots(:)
      !> Not zero on failure, as iostat; above zero where what is read is of another joint
      integer, intent(out) :: status
      integer :: i, n, n_cells, n_found

      read (unit, iostat=status) n
      if (status /= 0) return
      status = 1
      if (n < 0) return
      allocate (snapshots(n), stat=status)
      if (status /= 0) return
      do i = 1, n
         associate (s => snapshots(i))
            read (unit, iostat=status) s%kind, s%stroke, s%displacement, n_cells, n_found
            if (status /= 0) return
            status = 1
            if (n_cells < 0 .or. n_found /= n_elements) return
            allocate (s%contact(n_cells), stat=status)
            if (status == 0) allocate (s%plastic_strain(n_elements), stat=status)
            if (status == 0) allocate (s%stress(6, n_elements), stat=status)
            if (status /= 0) return
            read (unit, iostat=status) s%contact, s%plastic_strain, s%stress
            if (status /= 0) return
         end associate
      end do
   end subroutine read_snapshots

end module asperity_program_commands_solid_snapshots_file
