!> Contender: the update of many contact points in one call, with the compiled law.
module bench_points
   use asperity, only: contact_properties, contact_states, error_type, new_contact_properties, &
      new_contact_states, set_contact_state, update_contact_points, wp
   use bench_cases, only: contact_set
   use bench_timing, only: contender
   implicit none
   private
   public :: points_update, new_points_update

   !> Points in place: every second pass moves them back, so that those that slip keep slipping
   !> and those that stick keep sticking.
   type, extends(contender) :: points_update
      type(contact_properties) :: properties
      type(contact_states) :: states
      real(wp), allocatable :: overclosure(:), slip(:, :), traction(:, :)
      !> With the tangent and the energies as well
      logical :: everything = .false.
      real(wp), allocatable :: tangent(:, :, :), energy(:, :)
   contains
      procedure :: pass => pass_points
   end type points_update

contains

   !> The points of a set, which must share one set of properties.
   subroutine new_points_update(update, set, everything)
      type(points_update), intent(out) :: update
      type(contact_set), intent(in) :: set
      logical, intent(in) :: everything
      type(error_type), allocatable :: error
      integer :: i, n

      n = size(set%which)
      update%points = n
      update%everything = everything
      associate (p => set%properties(1))
         call new_contact_properties(update%properties, p%normal, p%friction_coefficient, &
            p%critical_slip, error, p%initial_separation, p%friction_rule, p%slip_integration, &
            compiled=.true.)
      end associate
      if (.not. allocated(error)) call new_contact_states(update%states, n, error)
      if (allocated(error)) error stop error%message
      do i = 1, n
         call set_contact_state(update%states, i, set%state(i))
      end do
      update%overclosure = set%position(1, :)
      update%slip = transpose(set%motion(2:, :))
      allocate (update%traction(n, 3), update%tangent(n, 3, 3), update%energy(n, 3), source=0.0_wp)
   end subroutine new_points_update

   subroutine pass_points(this)
      class(points_update), intent(inout) :: this
      type(error_type), allocatable :: error

      if (this%everything) then
         call update_contact_points(this%properties, this%states, this%overclosure, this%slip, &
            this%traction, error, tangent=this%tangent, tangential_energy=this%energy(:, 1), &
            dissipation=this%energy(:, 2), pressure_coupling=this%energy(:, 3))
      else
         call update_contact_points(this%properties, this%states, this%overclosure, this%slip, &
            this%traction, error)
      end if
      if (allocated(error)) error stop error%message
      this%slip = -this%slip
      this%checksum = this%checksum + sum(this%traction) + this%tangent(1, 1, 1) &
         + this%energy(1, 1)
   end subroutine pass_points

end module bench_points
