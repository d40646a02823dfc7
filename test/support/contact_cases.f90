!> Properties and random contact points for the tests of the update and of UINTER.
module contact_cases
   use asperity, only: contact_properties, error_type, find_pair, new_contact_properties, &
      normal_properties, pair_preset, rule_abaqus, slip_exact, unloading_reversible, wp
   use random_inputs, only: random_properties, random_stream
   implicit none
   private
   public :: pair_properties, random_contact

contains

   !> The pair `transverse-tangential`, or another, with a friction rule and a slip integration,
   !> without memory unless unloading says otherwise.
   function pair_properties(friction_rule, slip_integration, pair, unloading) result(properties)
      integer, intent(in), optional :: friction_rule, slip_integration
      character(len=*), intent(in), optional :: pair
      integer, intent(in), optional :: unloading
      type(contact_properties) :: properties
      type(pair_preset) :: preset
      type(error_type), allocatable :: error
      integer :: rule, integration

      if (present(pair)) then
         call find_pair(pair, preset, error)
      else
         call find_pair('transverse-tangential', preset, error)
      end if
      rule = rule_abaqus
      if (present(friction_rule)) rule = friction_rule
      integration = slip_exact
      if (present(slip_integration)) integration = slip_integration
      call new_contact_properties(properties, preset, error, friction_rule=rule, &
         slip_integration=integration, unloading=unloading)
      if (allocated(error)) error stop 'the pair of the tests is refused'
   end function pair_properties

   !> Random properties over the range of metals and wood.
   subroutine random_contact(stream, properties, friction_rule, slip_integration, unloading)
      type(random_stream), intent(inout) :: stream
      type(contact_properties), intent(out) :: properties
      integer, intent(in) :: friction_rule, slip_integration
      !> Reversible when absent
      integer, intent(in), optional :: unloading
      type(normal_properties) :: normal
      type(error_type), allocatable :: error
      real(wp) :: yield_factor_min

      yield_factor_min = 0.1_wp
      if (present(unloading)) yield_factor_min = merge(0.1_wp, 0.2_wp, &
         unloading == unloading_reversible)
      call random_properties(stream, normal, 1.0e-5_wp, 1.0_wp, yield_factor_min, unloading)
      call new_contact_properties(properties, normal, stream%uniform(0.05_wp, 1.0_wp), &
         normal%sigma*stream%log_uniform(0.1_wp, 10.0_wp), error, &
         normal%sigma*stream%uniform(-1.0_wp, 6.0_wp), friction_rule, slip_integration, &
         accept_unphysical=.true.)
      if (allocated(error)) error stop 'the random contact of the tests is refused'
   end subroutine random_contact

end module contact_cases
