!> What a contact point of the tenon joint does when it closes, slides and separates. Kinds: hard
!> contact, the rough law, and the rough law through UINTER. Faces and shoulders bear on the wood,
!> which is in series with the interface; the sides slide at a given pressure.
module asperity_replay_tenon_contact_interface_law
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction, only: slide
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response
   use asperity_replay_tenon_contact_record, only: contact_record, keep_response, leave_surface
   use asperity_replay_tenon_contact_wood_bearing, only: wood_bearing
   implicit none
   private
   public :: interface_law

   !> The law of a joint, read only within an increment but for the hosts of UINTER.
   type, abstract :: interface_law
      !> Contact of faces and shoulders, and of the sides
      type(contact_properties) :: faces, sides
      !> Wood under the points of faces and shoulders
      type(wood_bearing) :: wood
      !> Pressure of the sides, MPa
      real(wp) :: side_pressure = 0.0_wp
      !> Overclosure at which they carry it, mm, where the law needs it; else zero
      real(wp) :: side_overclosure = 0.0_wp
   contains
      !> Made ready, once its components are set, for the points of a joint
      procedure :: prepare
      !> A point of a face or shoulder at a closure
      procedure(close), deferred :: close
      !> A point of a side
      procedure :: slide => slide_at_side_pressure
      !> A point with nothing opposite
      procedure :: separate
      !> The last trial of every point is the start of what follows
      procedure :: accept
   end type interface_law

   abstract interface
      !> Pressure, friction and indentation at a closure. `error` is set when there is none.
      subroutine close(law, start, closure, slip, trial, error)
         import :: contact_record, error_type, interface_law, wp
         implicit none
         !> The law
         class(interface_law), intent(inout) :: law
         !> Point at the start of the increment
         type(contact_record), intent(in) :: start
         !> Closure past first touch at its end, and slip within it, mm
         real(wp), intent(in) :: closure, slip(2)
         !> Point at the end; what it holds before is a first guess
         type(contact_record), intent(inout) :: trial
         !> Set on failure
         type(error_type), allocatable, intent(out) :: error
      end subroutine close
   end interface

contains

   !> A law that needs no more than its components is ready.
   subroutine prepare(law, is_side, error)
      !> The law
      class(interface_law), intent(inout) :: law
      !> Of each point, whether it is one of a side
      logical, intent(in) :: is_side(:)
      !> Set when the law cannot carry what is asked of it
      type(error_type), allocatable, intent(out) :: error

      associate (unused => law, unused_too => is_side)
      end associate
   end subroutine prepare

   !> Slide at the pressure of the sides.
   subroutine slide_at_side_pressure(law, start, slip, trial, error)
      !> The law
      class(interface_law), intent(inout) :: law
      !> Point at the start of the increment
      type(contact_record), intent(in) :: start
      !> Slip within the increment, mm
      real(wp), intent(in) :: slip(2)
      !> Point at the end
      type(contact_record), intent(inout) :: trial
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      response%traction(1) = law%side_pressure
      call slide(response, law%sides, start%state, start%state%elastic_slip, &
         law%side_overclosure, slip, is_open=.false., closing=start%state%overclosure)
      call keep_response(trial, response, 0.0_wp, 1.0_wp)
   end subroutine slide_at_side_pressure

   !> Nothing is opposite.
   subroutine separate(law, start, trial, error)
      !> The law
      class(interface_law), intent(inout) :: law
      !> Point at the start and at the end of the increment
      type(contact_record), intent(in) :: start
      type(contact_record), intent(inout) :: trial
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      associate (unused => law)
      end associate
      call leave_surface(start, trial)
   end subroutine separate

   !> A law without a memory of its own has nothing to accept.
   subroutine accept(law)
      !> The law
      class(interface_law), intent(inout) :: law

      associate (unused => law)
      end associate
   end subroutine accept

end module asperity_replay_tenon_contact_interface_law
