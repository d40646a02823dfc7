!> How the cells of a pair have moved, increment by increment since the start.
module asperity_solid_contact_motions
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_solid_contact_cell, only: motion_of
   use asperity_solid_contact_face, only: contact_face
   implicit none
   private
   public :: contact_motions, add_motions

   !> Of one increment: overclosure at its end and both slips since the start, mm, shape
   !> (3, cells, faces).
   type :: cell_motions
      real(wp), allocatable :: values(:, :, :)
   end type cell_motions

   !> Of all increments, that which gave the first states among them.
   type :: contact_motions
      !> How many there are
      integer :: increments = 0
      type(cell_motions), allocatable :: at(:)
      !> Whether an increment was begun and not accepted
      logical :: is_under_way = .false.
   end type contact_motions

   !> Increments for which there is room at first
   integer, parameter :: first_room = 64

contains

   !> Add what the law was asked last. Where there is not enough memory, all are given up, as no
   !> run is to fail for them.
   pure subroutine add_motions(motions, faces)
      !> The motions
      type(contact_motions), allocatable, intent(inout) :: motions
      !> The faces
      type(contact_face), intent(in) :: faces(:)
      type(error_type), allocatable :: error
      real(wp), allocatable :: values(:, :, :)
      integer :: i, j, n, cells

      cells = size(faces(1)%cells)
      call check_work('motions of contact points', &
         24_int64*cells*size(faces), error)
      if (allocated(error)) then
         deallocate (motions)
         return
      end if
      allocate (values(3, cells, size(faces)))
      do i = 1, size(faces)
         do j = 1, cells
            values(:, j, i) = motion_of(faces(i)%cells(j))
         end do
      end do
      call make_room(motions)
      n = motions%increments
      if (n > 0) values(2:, :, :) = values(2:, :, :) + motions%at(n)%values(2:, :, :)
      motions%increments = n + 1
      call move_alloc(values, motions%at(n + 1)%values)
   end subroutine add_motions

   !> Room for an increment more.
   pure subroutine make_room(motions)
      type(contact_motions), intent(inout) :: motions
      type(cell_motions), allocatable :: larger(:)
      integer :: i

      if (.not. allocated(motions%at)) allocate (motions%at(first_room))
      if (motions%increments < size(motions%at)) return
      allocate (larger(2*motions%increments))
      do i = 1, motions%increments
         call move_alloc(motions%at(i)%values, larger(i)%values)
      end do
      call move_alloc(larger, motions%at)
   end subroutine make_room

end module asperity_solid_contact_motions
