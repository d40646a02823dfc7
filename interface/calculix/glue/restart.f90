!> The interactions of a job in a file of their own, JOB.uinter: CalculiX' restart file has no place
!> for them. It is written when a job begins, and read when one begins from a restart file.
module asperity_calculix_restart
   use asperity_base_kinds, only: wp
   use asperity_calculix_interactions, only: add_interaction, all_interactions, find_interaction, &
      interaction_type
   use asperity_calculix_refusal, only: refuse
   implicit none
   private
   public :: keep_interactions

   character(len=*), parameter :: first_line = 'UINTER in CalculiX, interactions, 1'

contains

   !> Read the interactions if the solver has some from a restart file that are not known, else
   !> write them. Ends the job where that cannot be done.
   subroutine keep_interactions(job, needed, resumed)
      !> Name of the job, without suffix
      character(len=*), intent(in) :: job
      !> Materials that a UINTER serves, by the solver's account
      integer, intent(in) :: needed(:)
      !> The job began from a restart file
      logical, intent(out) :: resumed
      integer :: i
      logical :: known

      resumed = .false.
      if (size(needed) == 0) return
      known = .true.
      do i = 1, size(needed)
         if (known) known = associated(find_interaction(needed(i)))
      end do
      if (known) then
         call write_interactions(trim(job)//'.uinter')
         return
      end if
      resumed = .true.
      call read_interactions(trim(job)//'.uinter')
      do i = 1, size(needed)
         if (.not. associated(find_interaction(needed(i)))) &
            call refuse(trim(job)//'.uinter is not of the run that wrote the restart file')
      end do
   end subroutine keep_interactions

   subroutine write_interactions(name)
      character(len=*), intent(in) :: name
      type(interaction_type), allocatable :: list(:)
      integer :: unit, status, i

      allocate (list, source=all_interactions())
      open (newunit=unit, file=name, status='replace', action='write', iostat=status)
      if (status /= 0) call refuse(name//' cannot be written')
      write (unit, '(a)') first_line
      write (unit, '(i0)') size(list)
      do i = 1, size(list)
         write (unit, '(3(i0, 1x), es25.17e3)') list(i)%material, list(i)%depvar, &
            size(list(i)%props), list(i)%search_distance
         write (unit, '(4es25.17e3)') list(i)%props
      end do
      close (unit)
   end subroutine write_interactions

   subroutine read_interactions(name)
      character(len=*), intent(in) :: name
      type(interaction_type) :: interaction
      character(len=len(first_line)) :: line
      integer :: unit, status, i, n, length

      open (newunit=unit, file=name, status='old', action='read', iostat=status)
      if (status /= 0) call refuse('a restart needs '//name//', which the first run wrote')
      read (unit, '(a)', iostat=status) line
      if (status /= 0 .or. line /= first_line) call refuse(name//' is of another kind')
      read (unit, *, iostat=status) n
      do i = 1, n
         if (status /= 0) exit
         read (unit, *, iostat=status) interaction%material, interaction%depvar, length, &
            interaction%search_distance
         if (status /= 0) exit
         if (allocated(interaction%props)) deallocate (interaction%props)
         allocate (interaction%props(length))
         read (unit, *, iostat=status) interaction%props
         if (status == 0) call add_interaction(interaction)
      end do
      close (unit)
      if (status /= 0) call refuse(name//' is damaged')
   end subroutine read_interactions

end module asperity_calculix_restart
