!> What the hosts at all contact points of a tenon joint ask of UINTER, increment by increment, kept
!> in a run that is known to fail.
module asperity_replay_tenon_motions
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_tenon_contact_uinter, only: uinter_law
   use asperity_replay_tenon_forces, only: tenon_increment
   use asperity_replay_tenon_geometry, only: side
   implicit none
   private
   public :: tenon_motions, start_motions, add_motions, failed_motion

   !> Overclosure and both slips of every point, mm, shape (3, points, increments).
   type :: tenon_motions
      integer :: increments = 0
      real(wp), allocatable :: values(:, :, :)
   end type tenon_motions

   !> Increments for which there is room at first
   integer, parameter :: first_room = 64

contains

   !> Room for the points of a joint.
   pure subroutine start_motions(motions, points)
      !> The motions
      type(tenon_motions), intent(out) :: motions
      !> How many points
      integer, intent(in) :: points

      allocate (motions%values(3, points, first_room))
   end subroutine start_motions

   !> Add what UINTER was asked last. `error` is set when there is not enough memory.
   subroutine add_motions(motions, at, error)
      !> The motions
      type(tenon_motions), intent(inout) :: motions
      !> The increment
      type(tenon_increment), intent(in) :: at
      !> Set when there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: larger(:, :, :)
      integer :: i, n, points

      n = motions%increments
      points = size(at%trial)
      if (n == size(motions%values, 3)) then
         call check_work('motions of '//to_text(points)//' contact points', &
            48_int64*points*int(n, int64), error)
         if (allocated(error)) return
         allocate (larger(3, points, 2*n))
         larger(:, :, :n) = motions%values
         call move_alloc(larger, motions%values)
      end if
      n = n + 1
      motions%increments = n
      motions%values(:, :, n) = 0.0_wp
      select type (law => at%model%law)
      type is (uinter_law)
         do i = 1, points
            associate (asked => law%hosts(i)%trial%rdisp)
               motions%values(:size(asked), i, n) = asked
            end associate
         end do
      class default
         continue
      end select
   end subroutine add_motions

   !> The motion of the point at which the last increment failed: the one that was refused, else
   !> that whose force changed most.
   subroutine failed_motion(motions, at, path, properties, point)
      !> The motions, that which failed among them
      type(tenon_motions), intent(in) :: motions
      !> That increment
      type(tenon_increment), intent(in) :: at
      !> Result: one increment a second
      type(motion_path), intent(out) :: path
      !> Properties of the point
      type(contact_properties), intent(out) :: properties
      !> Number of the point
      integer, intent(out) :: point
      integer :: i, n

      point = at%refused
      if (point == 0) point = maxloc(at%model%area*[(change_of(at, i), i=1, size(at%trial))], 1)
      n = motions%increments
      path%time = real([(i, i=1, n)], wp)
      path%overclosure = motions%values(1, point, :n)
      path%slip = motions%values(2:, point, :n)
      allocate (path%expected(3, n), source=0.0_wp)
      properties = at%model%law%faces
      if (at%model%face(point) == side) properties = at%model%law%sides
   end subroutine failed_motion

   !> By how much the tractions of a point change in an increment, MPa.
   pure real(wp) function change_of(at, i)
      type(tenon_increment), intent(in) :: at
      integer, intent(in) :: i

      associate (start => at%start(i), trial => at%trial(i))
         change_of = norm2([trial%weight*trial%state%pressure &
            - start%weight*start%state%pressure, trial%weight*trial%shear &
            - start%weight*start%shear])
      end associate
   end function change_of

end module asperity_replay_tenon_motions
