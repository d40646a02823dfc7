!> The rough law through UINTER: every point is called as ABAQUS calls it, from the start of the
!> increment, in every iteration.
module asperity_replay_tenon_contact_uinter
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: contact_response, no_opposite_surface
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_replay_abaqus_host, only: accept_increment, host_point, host_response, &
      new_host_point, refuse_cut, try_increment
   use asperity_replay_tenon_contact_record, only: contact_record, keep_response, leave_surface
   use asperity_replay_tenon_contact_rough, only: rough_law
   implicit none
   private
   public :: uinter_law

   !> The rough law, and the host of each point.
   type, extends(rough_law) :: uinter_law
      !> Of each point
      type(host_point), allocatable :: hosts(:)
   contains
      procedure :: prepare
      procedure :: press
      procedure :: update
      procedure :: slide
      procedure :: separate
      procedure :: accept
   end type uinter_law

   procedure(uinter_interface) :: uinter

contains

   subroutine prepare(law, is_side, error)
      class(uinter_law), intent(inout) :: law
      logical, intent(in) :: is_side(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: separation
      integer :: i

      call law%rough_law%prepare(is_side, error)
      if (allocated(error)) return
      if (law%side_pressure > 0.0_wp) then
         call separation_for_pressure(law%sides%normal, law%side_pressure, separation, error)
         if (allocated(error)) return
         law%side_overclosure = law%sides%initial_separation - separation
      end if
      allocate (law%hosts(size(is_side)))
      do i = 1, size(is_side)
         if (is_side(i)) then
            call new_host_point(law%hosts(i), uinter, law%sides, 3, keep_history=.false.)
         else
            call new_host_point(law%hosts(i), uinter, law%faces, 2, keep_history=.false.)
         end if
      end do
   end subroutine prepare

   subroutine press(law, start, overclosure, slip, pressure, stiffness, error)
      class(uinter_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      real(wp), intent(out) :: pressure, stiffness
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      call law%update(start, overclosure, slip, response, error)
      pressure = response%traction(1)
      stiffness = response%tangent(1, 1)
   end subroutine press

   !> One iteration of a host's increment, as the response of the update.
   subroutine update(law, start, overclosure, slip, response, error)
      class(uinter_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response), intent(out) :: response
      type(error_type), allocatable, intent(out) :: error

      associate (host => law%hosts(start%point))
         call try_increment(host, overclosure, slip(:host%ndir - 1), 0.0_wp, error)
         if (.not. allocated(error)) call refuse_cut(host, error)
         if (.not. allocated(error)) response = host_response(host)
      end associate
   end subroutine update

   !> The sides have no wood: their overclosure is known.
   subroutine slide(law, start, slip, trial, error)
      class(uinter_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: slip(2)
      type(contact_record), intent(inout) :: trial
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      call law%update(start, law%side_overclosure, slip, response, error)
      if (.not. allocated(error)) &
         call keep_response(trial, response, law%side_overclosure, 1.0_wp)
   end subroutine slide

   !> Nothing is opposite, and UINTER is told.
   subroutine separate(law, start, trial, error)
      class(uinter_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      type(contact_record), intent(inout) :: trial
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      call law%update(start, no_opposite_surface, [0.0_wp, 0.0_wp], response, error)
      call leave_surface(start, trial)
   end subroutine separate

   subroutine accept(law)
      class(uinter_law), intent(inout) :: law
      integer :: i

      do i = 1, size(law%hosts)
         call accept_increment(law%hosts(i))
      end do
   end subroutine accept

end module asperity_replay_tenon_contact_uinter
