!> Random inputs for the tests of the update of many points and of the compiled law in it.
module points_cases
   use asperity, only: contact_properties, contact_state, contact_states, error_type, &
      new_contact_properties, no_opposite_surface, rule_abaqus, rule_dissipative, &
      slip_backward_euler, slip_exact, update_contact_points, wp
   use contact_cases, only: random_contact
   use random_inputs, only: random_stream
   implicit none
   private
   public :: call_arguments, random_arguments, update, numbers_of, random_pair, compile, random_slip

   !> What goes into an update of many points, and comes out. Optional arguments are absent while
   !> they are not allocated.
   type :: call_arguments
      real(wp), allocatable :: overclosure(:), slip(:, :), traction(:, :)
      real(wp), allocatable :: rotation(:, :, :), tangent(:, :, :)
      real(wp), allocatable :: tangential_energy(:), dissipation(:), plastic(:), coupling(:)
      integer, allocatable :: validity(:)
   end type call_arguments

contains

   !> One increment of all points.
   subroutine update(p, states, a, error)
      type(contact_properties), intent(in) :: p
      type(contact_states), intent(inout) :: states
      type(call_arguments), intent(inout) :: a
      type(error_type), allocatable, intent(out) :: error

      call update_contact_points(p, states, a%overclosure, a%slip, a%traction, error, a%rotation, &
         a%tangent, a%tangential_energy, a%dissipation, a%plastic, a%coupling, a%validity)
   end subroutine update

   !> Separations of -9 to 9 sigma, slips of up to 1.5 gcrit; results hold what is never one.
   subroutine random_arguments(stream, p, points, a)
      type(random_stream), intent(inout) :: stream
      type(contact_properties), intent(in) :: p
      integer, intent(in) :: points
      type(call_arguments), intent(out) :: a
      real(wp), parameter :: unset = -9.0e99_wp
      real(wp) :: angle, stretch
      integer :: i

      allocate (a%overclosure(points), a%slip(points, 2), a%rotation(points, 2, 2))
      allocate (a%traction(points, 3), a%tangent(points, 3, 3), source=unset)
      allocate (a%tangential_energy(points), a%dissipation(points), a%plastic(points), &
         a%coupling(points), source=unset)
      allocate (a%validity(points), source=-9)
      do i = 1, points
         a%overclosure(i) = p%initial_separation &
            - p%normal%sigma*stream%uniform(-9.0_wp, 9.0_wp)
         if (stream%uniform(0.0_wp, 1.0_wp) < 0.05_wp) a%overclosure(i) = no_opposite_surface
         a%slip(i, 1) = p%critical_slip*stream%uniform(-1.5_wp, 1.5_wp)
         a%slip(i, 2) = p%critical_slip*stream%uniform(-1.5_wp, 1.5_wp)
         angle = stream%uniform(-3.0_wp, 3.0_wp)
         stretch = stream%uniform(0.9_wp, 1.1_wp)
         a%rotation(i, :, :) = stretch*reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], &
            [2, 2])
      end do
   end subroutine random_arguments

   !> All numbers of a state.
   pure function numbers_of(state) result(numbers)
      type(contact_state), intent(in) :: state
      real(wp) :: numbers(10)

      numbers = [real(state%status, wp), state%overclosure, state%pressure, state%normal_energy, &
         state%elastic_slip, state%largest_closure, state%dissipation, state%pressure_coupling, &
         real(state%validity, wp)]
   end function numbers_of

   !> Random properties with the direct and with the compiled law; `choice` says how friction works.
   subroutine random_pair(stream, choice, direct, compiled, unloading)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: choice
      type(contact_properties), intent(out) :: direct, compiled
      !> Reversible when absent
      integer, intent(in), optional :: unloading

      call random_contact(stream, direct, merge(rule_dissipative, rule_abaqus, btest(choice, 0)), &
         merge(slip_exact, slip_backward_euler, btest(choice, 1)), unloading)
      call compile(direct, compiled)
   end subroutine random_pair

   !> The same properties with the law compiled.
   subroutine compile(direct, compiled)
      type(contact_properties), intent(in) :: direct
      type(contact_properties), intent(out) :: compiled
      type(error_type), allocatable :: error

      call new_contact_properties(compiled, direct%normal, direct%friction_coefficient, &
         direct%critical_slip, error, direct%initial_separation, direct%friction_rule, &
         direct%slip_integration, compiled=.true., accept_unphysical=.true.)
      if (allocated(error)) error stop 'the properties of the tests are not compiled'
   end subroutine compile

   !> A slip in a random direction.
   function random_slip(stream, p, size) result(slip)
      type(random_stream), intent(inout) :: stream
      type(contact_properties), intent(in) :: p
      !> Largest component over gcrit
      real(wp), intent(in) :: size
      real(wp) :: slip(2)

      slip(1) = p%critical_slip*stream%uniform(-size, size)
      slip(2) = p%critical_slip*stream%uniform(-size, size)
   end function random_slip

end module points_cases
