!> A run kept between two strokes, on a unit opened for unformatted stream access. What is read goes
!> on as the run that was not interrupted, bit for bit: every stroke begins without a pattern,
!> factors or increments before it.
module asperity_solid_solve_checkpoint
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_history, only: history_size, pack_facets, pack_history, &
      unpack_facets, unpack_history
   use asperity_solid_solve_gather, only: leave_to_first
   use asperity_solid_solve_programme, only: solid_run
   implicit none
   private
   public :: write_run, read_run

contains

   !> Write a run.
   subroutine write_run(unit, run, status)
      !> The unit
      integer, intent(in) :: unit
      !> The run, between two strokes
      type(solid_run), intent(in) :: run
      !> Not zero on failure, as iostat
      integer, intent(out) :: status
      integer :: i

      write (unit, iostat=status) run%strokes_done, run%increments, run%iterations, run%cutbacks, &
         size(run%displacement), size(run%records), size(run%joints, 1)
      if (status == 0) write (unit, iostat=status) run%displacement, run%ledger, &
         run%model%points, run%records, run%joints
      if (status /= 0) return
      do i = 1, size(run%model%pairs)
         associate (history => pack_history(run%model%pairs(i)), &
               facets => pack_facets(run%model%pairs(i)))
            write (unit, iostat=status) size(history), size(facets), history, facets
            if (status /= 0) return
         end associate
      end do
   end subroutine write_run

   !> Read a run of the same joint, which is at its beginning.
   subroutine read_run(unit, run, status)
      !> The unit
      integer, intent(in) :: unit
      !> The run
      type(solid_run), intent(inout) :: run
      !> Not zero on failure, as iostat; above zero where what is read is of another joint
      integer, intent(out) :: status
      real(wp), allocatable :: history(:)
      integer, allocatable :: facets(:)
      integer :: i, n, n_facets, n_displacements, n_records, n_joints

      read (unit, iostat=status) run%strokes_done, run%increments, run%iterations, run%cutbacks, &
         n_displacements, n_records, n_joints
      if (status /= 0) return
      status = 1
      if (n_displacements /= size(run%displacement) .or. min(n_records, n_joints) < 0) return
      deallocate (run%records, run%joints)
      allocate (run%records(n_records), stat=status)
      if (status == 0) allocate (run%joints(n_joints, n_records), stat=status)
      if (status == 0) read (unit, iostat=status) run%displacement, run%ledger, &
         run%model%points, run%records, run%joints
      do i = 1, size(run%model%pairs)
         if (status == 0) read (unit, iostat=status) n, n_facets
         if (status /= 0) return
         status = 1
         if (n /= history_size(run%model%pairs(i)) .or. n_facets < 0) return
         allocate (history(n), stat=status)
         if (status == 0) allocate (facets(n_facets), stat=status)
         if (status == 0) read (unit, iostat=status) history, facets
         if (status /= 0) return
         call unpack_history(run%model%pairs(i), history)
         call unpack_facets(run%model%pairs(i), facets)
         deallocate (history, facets)
      end do
      call leave_to_first(run%model, run%system%solver%petsc%ranks)
   end subroutine read_run

end module asperity_solid_solve_checkpoint
