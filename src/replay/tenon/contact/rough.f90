!> The rough law: the contact-point update gives pressure, friction, status and energy at an
!> overclosure, and how far the interface closes is found from closure = overclosure + deflection
!> of the wood.
module asperity_replay_tenon_contact_rough
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_point, only: find_normal, normal_values, update_contact_point
   use asperity_contact_properties, only: compile_normal_law
   use asperity_contact_state, only: contact_response, no_rotation
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_replay_tenon_contact_interface_law, only: interface_law
   use asperity_replay_tenon_contact_overclosure_search, only: improve_overclosure, &
      new_overclosure_search, overclosure_search
   use asperity_replay_tenon_contact_record, only: contact_record, keep_response
   use asperity_replay_tenon_contact_wood_bearing, only: bearing_deflection, bearing_indentation
   implicit none
   private
   public :: rough_law

   !> A rough interface on wood.
   type, extends(interface_law) :: rough_law
      !> Overclosure at which the faces reach the first yield pressure of the wood, mm; of elastic
      !> wood, the hardness
      real(wp) :: yields_at = 0.0_wp
   contains
      procedure :: prepare
      procedure :: close
      !> Pressure and stiffness of a face at an overclosure
      procedure :: press
      !> A face at its overclosure, friction and all
      procedure :: update
   end type rough_law

   integer, parameter :: max_iterations = 100

contains

   !> Compile the law unless it is. `error` is set when the pressure of yield is out of reach.
   subroutine prepare(law, is_side, error)
      class(rough_law), intent(inout) :: law
      logical, intent(in) :: is_side(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: pressure, separation

      associate (unused => is_side)
      end associate
      call compile_normal_law(law%faces, error)
      if (allocated(error)) return
      pressure = minval(law%wood%yield)
      ! where no wood yields, searches begin at the highest pressure that the law is for
      if (.not. pressure < huge(pressure)) pressure = law%faces%normal%hardness
      call separation_for_pressure(law%faces%normal, pressure, separation, error)
      law%yields_at = law%faces%initial_separation - separation
   end subroutine prepare

   subroutine close(law, start, closure, slip, trial, error)
      class(rough_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure, slip(2)
      type(contact_record), intent(inout) :: trial
      type(error_type), allocatable, intent(out) :: error
      type(overclosure_search) :: search
      type(contact_response) :: response
      real(wp) :: pressure, stiffness
      integer :: iteration

      search = new_overclosure_search(law%wood, law%faces, law%yields_at, start, trial, closure)
      do iteration = 1, max_iterations
         if (search%found) exit
         call law%press(start, search%at, slip, pressure, stiffness, error)
         if (allocated(error)) return
         call improve_overclosure(search, law%wood, pressure, stiffness)
      end do
      if (.not. search%found) then
         call fatal_error(error, 'no overclosure found at closure = '//to_text(closure)//' mm', &
            computation_error)
         return
      end if
      call law%update(start, search%at, slip, response, error)
      if (.not. allocated(error)) call take_response(law, start, closure, response, trial)
   end subroutine close

   !> By the normal law alone, compiled where it is.
   subroutine press(law, start, overclosure, slip, pressure, stiffness, error)
      !> The law
      class(rough_law), intent(inout) :: law
      !> Point at the start of the increment
      type(contact_record), intent(in) :: start
      !> Overclosure at its end, and slip within it, mm
      real(wp), intent(in) :: overclosure, slip(2)
      !> Pressure, MPa, and its derivative, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(normal_values) :: normal

      associate (unused => slip)
      end associate
      call find_normal(law%faces, start%state, overclosure, normal)
      pressure = normal%pressure
      stiffness = normal%stiffness
   end subroutine press

   !> By the contact-point update.
   subroutine update(law, start, overclosure, slip, response, error)
      !> The law
      class(rough_law), intent(inout) :: law
      !> Point at the start of the increment
      type(contact_record), intent(in) :: start
      !> Overclosure at its end, and slip within it, mm
      real(wp), intent(in) :: overclosure, slip(2)
      !> Result
      type(contact_response), intent(out) :: response
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      call update_contact_point(law%faces, start%state, overclosure, slip, no_rotation, response)
   end subroutine update

   !> Keep what the update returned, and how the wood shares the closure.
   subroutine take_response(law, start, closure, response, trial)
      class(rough_law), intent(in) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure
      type(contact_response), intent(in) :: response
      type(contact_record), intent(inout) :: trial
      real(wp) :: deflection, slope, share

      associate (wood => law%wood, pressure => response%traction(1), &
            overclosure => response%state%overclosure)
         if (wood%capped > 0 .and. overclosure >= law%yields_at) then
            share = 0.0_wp
            trial%indentation = bearing_indentation(wood, start%indentation, wood%cap, &
               closure - overclosure)
         else
            call bearing_deflection(wood, start%indentation, pressure, deflection, slope)
            share = 1.0_wp/(1.0_wp + slope*response%tangent(1, 1))
            trial%indentation = bearing_indentation(wood, start%indentation, &
               min(pressure, wood%cap*(1.0_wp - epsilon(1.0_wp))), closure)
         end if
      end associate
      call keep_response(trial, response, closure, share)
   end subroutine take_response

end module asperity_replay_tenon_contact_rough
