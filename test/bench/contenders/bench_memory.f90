!> Contender: the update of many contact points whose law has memory, and the same points without.
module bench_memory
   use asperity, only: contact_properties, contact_response, contact_state, contact_states, &
      error_type, find_pair, new_contact_properties, new_contact_states, no_rotation, pair_preset, &
      retraction_for_pressure, set_contact_state, unloading_elastic, update_contact_point, &
      update_contact_points, wp
   use asperity_base_constants, only: pi
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use bench_timing, only: contender
   use random_inputs, only: random_stream
   implicit none
   private
   public :: memory_update, new_memory_update

   !> Points whose separation goes up and down between two places, pass by pass.
   type, extends(contender) :: memory_update
      type(contact_properties) :: properties
      type(contact_states) :: states
      !> What the points remember before each pass
      real(wp), allocatable :: largest_closure(:)
      !> Overclosure by point and place, and the next place
      real(wp), allocatable :: overclosure(:, :)
      integer :: place = 2
      real(wp), allocatable :: slip(:, :), traction(:, :), tangent(:, :, :), energy(:, :)
   contains
      procedure :: pass => pass_memory
   end type memory_update

   !> Closest separations, over sigma
   real(wp), parameter :: h_min = 1.0_wp, h_max = 5.0_wp
   !> Least pressure of points that unload and reload, over that at the closest separation
   real(wp), parameter :: least_pressure = 0.02_wp

contains

   !> Points of the pair transverse-tangential that stick or slip: those that unload and reload are
   !> at two pressures below that of their closest separation, those that load are brought closer
   !> than it by each pass.
   subroutine new_memory_update(update, points, unloading, loads, compiled)
      type(memory_update), intent(out) :: update
      !> How many
      integer, intent(in) :: points
      !> `unloading_reversible` or `unloading_elastic`
      integer, intent(in) :: unloading
      !> Whether they load; they unload and reload otherwise
      logical, intent(in) :: loads
      !> Whether the law is compiled
      logical, intent(in) :: compiled
      type(pair_preset) :: pair
      type(contact_properties) :: remembering
      type(contact_state) :: state
      type(random_stream) :: stream
      type(error_type), allocatable :: error
      integer :: i

      call find_pair('transverse-tangential', pair, error)
      if (.not. allocated(error)) call new_contact_properties(update%properties, pair, error, &
         compiled=compiled, unloading=unloading)
      if (.not. allocated(error)) call new_contact_properties(remembering, pair, error, &
         unloading=unloading_elastic)
      if (.not. allocated(error)) call new_contact_states(update%states, points, error)
      if (allocated(error)) error stop error%message
      update%points = points
      allocate (update%overclosure(points, 2), update%slip(points, 2), update%traction(points, 3), &
         update%tangent(points, 3, 3), update%energy(points, 4))
      stream%state = 19990818
      do i = 1, points
         call new_point(remembering, loads, stream, update%overclosure(i, :), update%slip(i, :), &
            state)
         call set_contact_state(update%states, i, state)
      end do
      update%largest_closure = update%states%largest_closure
   end subroutine new_memory_update

   !> One point at the first of its places. The same for every law, as it is drawn for that with
   !> memory.
   subroutine new_point(properties, loads, stream, overclosure, slip, state)
      type(contact_properties), intent(in) :: properties
      logical, intent(in) :: loads
      type(random_stream), intent(inout) :: stream
      real(wp), intent(out) :: overclosure(2), slip(2)
      type(contact_state), intent(out) :: state
      type(contact_response) :: response
      type(normal_response) :: closest
      real(wp) :: separation, retraction, angle
      integer :: k

      associate (p => properties)
         separation = p%normal%sigma*stream%uniform(h_min, h_max)
         if (loads) then
            overclosure = p%initial_separation - separation + p%normal%sigma &
               *[stream%uniform(0.01_wp, 0.02_wp), stream%uniform(0.02_wp, 0.03_wp)]
         else
            closest = evaluate_normal_law(p%normal, separation)
            do k = 1, 2
               retraction = retraction_for_pressure(p%normal, separation, &
                  closest%pressure*stream%uniform(least_pressure, 1.0_wp))
               overclosure(k) = p%initial_separation - separation - retraction
            end do
         end if
         call update_contact_point(p, contact_state(), p%initial_separation - separation, &
            [0.0_wp, 0.0_wp], no_rotation, response)
         state = response%state
         if (.not. loads) then
            call update_contact_point(p, response%state, overclosure(1), [0.0_wp, 0.0_wp], &
               no_rotation, response)
            state = response%state
         end if
         angle = stream%uniform(0.0_wp, 2.0_wp*pi)
         slip = merge(0.05_wp, 3.0_wp, stream%uniform(0.0_wp, 1.0_wp) < 0.5_wp) &
            *p%critical_slip*[cos(angle), sin(angle)]
      end associate
   end subroutine new_point

   subroutine pass_memory(this)
      class(memory_update), intent(inout) :: this
      type(error_type), allocatable :: error

      this%states%largest_closure = this%largest_closure
      call update_contact_points(this%properties, this%states, this%overclosure(:, this%place), &
         this%slip, this%traction, error, tangent=this%tangent, &
         tangential_energy=this%energy(:, 1), dissipation=this%energy(:, 2), &
         plastic_dissipation=this%energy(:, 3), pressure_coupling=this%energy(:, 4))
      if (allocated(error)) error stop error%message
      this%place = 3 - this%place
      this%slip = -this%slip
      this%checksum = this%checksum + sum(this%traction) + this%tangent(1, 1, 1) &
         + this%energy(1, 1) + this%energy(1, 3)
   end subroutine pass_memory

end module bench_memory
