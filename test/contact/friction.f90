!> Friction at a known pressure, on faces that close like a spring at overclosure zero: shear
!> stresses and ledgers against formulas, every derivative against differences.
module test_contact_friction
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, rule_abaqus, &
      rule_dissipative, slip_backward_euler, slip_exact, status_open, status_slip, status_stick, wp
   use asperity_contact_friction, only: slide
   use contact_cases, only: pair_properties
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_friction

   !> Pressure by overclosure, MPa/mm
   real(wp), parameter :: stiffness = 40.0_wp
   integer, parameter :: rules(2) = [rule_abaqus, rule_dissipative], &
      integrations(2) = [slip_exact, slip_backward_euler]

contains

   function suite_friction() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('friction')
      call suite%addTest(TestMethod('derivatives of a spring that slides', test_derivatives))
      call suite%addTest(TestMethod('a change of pressure, by either rule', test_rules))
      call suite%addTest(TestMethod('what is lost on opening', test_opening))
   end function suite_friction

   !> One increment of the spring.
   pure function slid(properties, start, overclosure, slip) result(response)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response) :: response

      response%traction(1) = stiffness*max(overclosure, 0.0_wp)
      if (overclosure > 0.0_wp) response%tangent(1, 1) = stiffness
      call slide(response, properties, start, start%elastic_slip, overclosure, slip, &
         .not. overclosure > 0.0_wp, 0.0_wp)
   end function slid

   !> Random paths that open and close, rise and fall, both rules and integrations: shear stresses
   !> by overclosure and slip against central differences.
   subroutine test_derivatives()
      real(wp), parameter :: h = 1.0e-7_wp
      type(random_stream) :: stream
      type(contact_properties) :: properties
      type(contact_state) :: start
      type(contact_response) :: r, ahead, behind
      real(wp) :: overclosure, slip(2), step(3), worst, scale
      integer :: i, j, rule, integration, closed, closing

      stream = random_stream(57721566_int64)
      worst = 0.0_wp
      closing = 0
      closed = 0
      do rule = 1, 2
         do integration = 1, 2
            properties = pair_properties(rules(rule), integrations(integration))
            start = contact_state()
            do i = 1, 2000
               overclosure = stream%uniform(-0.02_wp, 0.06_wp)
               slip = properties%critical_slip*[stream%uniform(-1.0_wp, 1.0_wp), &
                  stream%uniform(-1.0_wp, 1.0_wp)]
               r = slid(properties, start, overclosure, slip)
               if (overclosure > h) then
                  scale = properties%friction_coefficient*(stiffness + r%traction(1) &
                     /properties%critical_slip)
                  do j = 1, 3
                     step = 0.0_wp
                     step(j) = h
                     ahead = slid(properties, start, overclosure + step(1), slip + step(2:))
                     behind = slid(properties, start, overclosure - step(1), slip - step(2:))
                     ! the corners of stick and slip, and of the rising pressure
                     if (ahead%status /= behind%status) cycle
                     if ((ahead%traction(1) - start%pressure) &
                        *(behind%traction(1) - start%pressure) < 0.0_wp) cycle
                     call worsen(worst, abs((ahead%traction(2:) - behind%traction(2:))/(2.0_wp*h) &
                        - r%tangent(2:, j))/scale)
                  end do
                  closed = closed + 1
                  if (start%status == status_open) closing = closing + 1
               end if
               start = r%state
            end do
         end do
      end do
      call record('friction.tangent', worst)
      call assertLessThan(worst, 1.0e-6_wp, 'derivatives')
      call assertGreaterThan(closed, 4000, message='closed at the end')
      call assertGreaterThan(closing, 1000, message='closed within the increment')
   end subroutine test_derivatives

   !> Twice the pressure, then half of it, without motion: ABAQUS' rule keeps the elastic slip, and
   !> the energy changes with the pressure; the other one keeps the shear stress while the pressure
   !> rises, at the cost of energy, and the elastic slip while it falls.
   subroutine test_rules()
      real(wp), parameter :: u = 0.01_wp, g = 0.1_wp
      type(contact_properties) :: p
      type(contact_response) :: first, risen, fallen
      real(wp) :: energy, slip(2)
      integer :: rule

      do rule = 1, 2
         p = pair_properties(rules(rule))
         slip = [g*p%critical_slip, 0.0_wp]
         first = slid(p, contact_state(status=status_stick), u, slip)
         risen = slid(p, first%state, 2.0_wp*u, [0.0_wp, 0.0_wp])
         fallen = slid(p, first%state, 0.5_wp*u, [0.0_wp, 0.0_wp])
         energy = 0.5_wp*p%friction_coefficient*stiffness*u*g**2*p%critical_slip
         call assertEqual(p%friction_coefficient*stiffness*u*g, first%traction(2), 1.0e-15_wp, &
            'shear stress')
         call assertEqual(energy, first%tangential_energy, 1.0e-15_wp, 'stored')
         call assertEqual(0.5_wp*first%traction(2), fallen%traction(2), 1.0e-15_wp, 'falling')
         if (rules(rule) == rule_abaqus) then
            call assertEqual(2.0_wp*first%traction(2), risen%traction(2), 1.0e-15_wp, 'rising')
            call assertEqual(energy, risen%pressure_coupling, 1.0e-15_wp, 'put in')
            call assertEqual(-0.5_wp*energy, fallen%pressure_coupling, 1.0e-15_wp, 'taken out')
            call assertEqual(0.0_wp, risen%dissipation + fallen%dissipation, 0.0_wp, 'nothing lost')
         else
            call assertEqual(first%traction(2), risen%traction(2), 1.0e-15_wp, 'kept')
            call assertEqual(0.5_wp*energy, risen%dissipation, 1.0e-15_wp, 'lost on rising')
            call assertEqual(0.5_wp*energy, fallen%dissipation, 1.0e-15_wp, 'lost on falling')
            call assertEqual(0.0_wp, risen%pressure_coupling, 0.0_wp, 'no coupling')
         end if
         if (anyExceptions()) return
      end do
   end subroutine test_rules

   !> A point that opens at pressure zero loses its elastic slip: its energy is heat by the
   !> dissipative rule, ABAQUS' takes it out as the pressure falls. Beyond gcrit it slips at mu p.
   subroutine test_opening()
      type(contact_properties) :: p
      type(contact_response) :: first, opened
      integer :: rule

      do rule = 1, 2
         p = pair_properties(rules(rule))
         first = slid(p, contact_state(status=status_stick), 0.02_wp, &
            [3.0_wp*p%critical_slip, 0.0_wp])
         call assertEqual(status_slip, first%status, 'slips')
         call assertEqual(p%friction_coefficient*first%traction(1), first%traction(2), 1.0e-15_wp, &
            'mu p')
         call assertEqual(2.0_wp*p%critical_slip*first%traction(2), first%dissipation, 1.0e-14_wp, &
            'friction over the way')
         opened = slid(p, first%state, -0.01_wp, [0.1_wp, 0.0_wp])
         call assertEqual(status_open, opened%status, 'open')
         call assertEqual(0.0_wp, maxval(abs(opened%state%elastic_slip)), 0.0_wp, 'forgotten')
         call assertEqual(0.0_wp, maxval(abs(opened%traction)), 0.0_wp, 'no stress')
         call assertEqual(first%tangential_energy, opened%dissipation - opened%pressure_coupling, &
            1.0e-15_wp, 'its energy')
         call assertEqual(merge(first%tangential_energy, 0.0_wp, rule == 2), opened%dissipation, &
            1.0e-15_wp, 'lost')
         call assertEqual(first%dissipation + opened%dissipation, opened%state%dissipation, &
            1.0e-15_wp, 'since the start')
      end do
   end subroutine test_opening

end module test_contact_friction
