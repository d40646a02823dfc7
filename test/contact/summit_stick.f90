!> Summits that stick each for itself, one way and to and fro at a constant pressure: backbone,
!> Masing's rule, random paths, stiffness.
module test_contact_summit_stick
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_point, only: contact_tangent
   use asperity_contact_properties, only: contact_properties, rule_abaqus, slip_exact
   use asperity_contact_state, only: contact_response, contact_state, status_slip, status_stick
   use asperity_contact_stick_elements, only: find_stick_elements, stick_elements, summit_backbone
   use extremes, only: worsen
   use funit, only: assertEqual, assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_stream
   use stick_cases, only: full_slip, move, mu, random_sticking, shear_modulus, sticking
   implicit none
   private
   public :: suite_summit_stick

contains

   function suite_summit_stick() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('summit stick')
      call suite%addTest(TestMethod('backbone: its elements, and Mindlin''s sum', test_backbone))
      call suite%addTest(TestMethod('Masing: branches are the backbone doubled', test_masing))
      call suite%addTest(TestMethod('random paths against 500 elements', test_random_path))
      call suite%addTest(TestMethod('stiffness at first touch', test_first_touch))
      call suite%addTest(TestMethod('coefficient by pressure, shear limit', test_strength))
   end function suite_summit_stick

   subroutine test_backbone()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: fresh
      type(stick_elements) :: elements
      real(wp) :: overclosure, slip, chords, curve
      integer :: i, j

      p = sticking(normal_of_pair('transverse-tangential'), rule_abaqus, slip_exact, 0)
      chords = 0.0_wp
      curve = 0.0_wp
      do i = 0, 6
         overclosure = 0.7_wp*real(i, wp)*p%normal%sigma
         call find_stick_elements(p%normal, shear_modulus, 8, p%initial_separation - overclosure, &
            elements)
         do j = 0, 50
            slip = 0.03_wp*full_slip(p, overclosure)*real(j, wp)
            call move(p, fresh, overclosure, slip, r)
            call worsen(chords, abs(r%traction(2)/(mu*r%traction(1)) &
               - sum(elements%share(:8)*min(slip/(mu*elements%unit_slip(:8)), 1.0_wp))))
            call worsen(curve, abs(r%traction(2)/(mu*r%traction(1)) - summit_backbone(p%normal, &
               shear_modulus, p%initial_separation - overclosure, slip/mu)))
            call assertEqual(merge(status_slip, status_stick, j > 33), r%status, 'status')
         end do
      end do
      call record('summit_stick.backbone.chords', chords)
      call record('summit_stick.backbone.mindlin', curve)
      call assertLessThan(chords, 1.0e-14_wp, 'elements')
      call assertLessThan(curve, 0.01_wp, 'Mindlin')
   end subroutine test_backbone

   !> Loops between random turning points at constant pressure, each leg in 20 steps: from a turn on
   !> the stress falls by twice the backbone of half the way, and loops close.
   subroutine test_masing()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r, half
      type(contact_state) :: fresh, state
      real(wp) :: full, overclosure, amplitude, way, turned, error
      integer :: i, j

      stream = random_stream(1926)
      error = 0.0_wp
      do i = 1, 100
         call random_sticking(stream, i, p)
         overclosure = p%initial_separation - stream%uniform(-2.0_wp, 5.0_wp)*p%normal%sigma
         full = full_slip(p, overclosure)
         amplitude = full*stream%uniform(0.05_wp, 1.3_wp)
         call move(p, fresh, overclosure, amplitude, r)
         turned = r%traction(2)
         state = r%state
         do j = 1, 40
            way = 0.1_wp*amplitude*min(j, 40 - j)
            call move(p, state, overclosure, merge(-0.1_wp, 0.1_wp, j <= 20)*amplitude, r)
            state = r%state
            if (j <= 20) then
               call move(p, fresh, overclosure, 0.5_wp*way, half)
               call worsen(error, abs((r%traction(2) - turned + 2.0_wp*half%traction(2)) &
                  /(mu*r%traction(1))))
            else
               call move(p, fresh, overclosure, 0.1_wp*amplitude*(0.5_wp*real(j - 20, wp)), half)
               call worsen(error, abs((r%traction(2) + turned - 2.0_wp*half%traction(2)) &
                  /(mu*r%traction(1))))
            end if
         end do
         call worsen(error, abs((r%traction(2) - turned)/(mu*r%traction(1))))
      end do
      call record('summit_stick.masing', error)
      call assertLessThan(error, 1.0e-12_wp, 'branches')
   end subroutine test_masing

   !> Random motion to and fro at constant pressure against an Iwan model of its own, of 500 chords
   !> of Mindlin's sum. The first leg is off by the
   !> distance of the chords, 0.8 %, each turn that is remembered by up to twice that.
   subroutine test_random_path()
      integer, parameter :: seed = 1967, fine = 500
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: state
      real(wp) :: overclosure, full, slip, error, knot(0:fine), chord(fine + 1), share(fine)
      real(wp) :: gamma(fine), height(0:fine)
      integer :: i, j, n

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      error = 0.0_wp
      do n = 1, 12
         p = sticking(normal_of_pair(merge('transverse-tangential ', 'tangential-tangential ', &
            mod(n, 2) == 0)), rule_abaqus, slip_exact, 8)
         overclosure = p%initial_separation - stream%uniform(-1.0_wp, 5.0_wp)*p%normal%sigma
         full = full_slip(p, overclosure)
         knot(0) = 0.0_wp
         height(0) = 0.0_wp
         do i = 1, fine
            knot(i) = 3.0_wp*full*(real(i, wp)/fine)**2
            height(i) = summit_backbone(p%normal, shear_modulus, &
               p%initial_separation - overclosure, knot(i)/mu)
            chord(i) = (height(i) - height(i - 1))/(knot(i) - knot(i - 1))
         end do
         chord(fine + 1) = 0.0_wp
         share = knot(1:)*(chord(:fine) - chord(2:))
         gamma = 0.0_wp
         state = contact_state()
         call move(p, state, overclosure, 0.0_wp, r)
         do j = 1, 400
            slip = full*stream%uniform(-0.7_wp, 0.7_wp)
            state = r%state
            call move(p, state, overclosure, slip, r)
            gamma = min(max(gamma + slip, -knot(1:)), knot(1:))
            call worsen(error, abs(r%traction(2)/(mu*r%traction(1)) - sum(share*gamma/knot(1:))))
         end do
      end do
      call record('summit_stick.random_path', error)
      call assertLessThan(error, 0.025_wp, 'random paths')
   end subroutine test_random_path

   !> Sum of the elements' stiffnesses, by the tangent at rest and by the stick of a small motion:
   !> with 8 elements up to 12 % below 8 G* a of all summits.
   subroutine test_first_touch()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: fresh
      type(stick_elements) :: elements
      real(wp) :: tangent(3, 3), overclosure
      integer :: i

      p = sticking(normal_of_pair('transverse-tangential'), rule_abaqus, slip_exact, 8)
      do i = 1, 6
         overclosure = 0.7_wp*real(i, wp)*p%normal%sigma
         call find_stick_elements(p%normal, shear_modulus, 8, p%initial_separation - overclosure, &
            elements)
         call move(p, fresh, overclosure, 1.0e-7_wp, r)
         tangent = contact_tangent(p, r%state)
         call assertEqual(1.0_wp, tangent(2, 2)/r%tangent(2, 2), 1.0e-12_wp, 'tangent of a state')
         call assertEqual(1.0_wp, tangent(3, 3)/r%tangent(2, 2), 1.0e-12_wp, 'across')
         call assertEqual(0.94_wp, tangent(2, 2)/elements%stiffness, 0.06_wp, 'first touch')
      end do
   end subroutine test_first_touch

   !> Plateaus are the strength; the stiffness is that of the solids, whatever the coefficient.
   subroutine test_strength()
      type(contact_properties) :: p, plain
      type(contact_response) :: r, first, other
      type(contact_state) :: fresh
      type(friction_settings) :: settings
      real(wp) :: overclosure

      plain = sticking(normal_of_pair('transverse-tangential'), rule_abaqus, slip_exact, 8)
      overclosure = 2.0_wp*plain%normal%sigma
      settings%pressure_exponent = -0.3_wp
      settings%reference_pressure = 0.1_wp
      p = sticking(plain%normal, rule_abaqus, slip_exact, 8, settings)
      call move(p, fresh, overclosure, 1.0_wp, r)
      call assertEqual(mu*r%traction(1)*(r%traction(1)/0.1_wp)**(-0.3_wp), r%traction(2), &
         1.0e-13_wp, 'power')
      call move(p, fresh, overclosure, 1.0e-6_wp, first)
      call move(plain, fresh, overclosure, 1.0e-6_wp, other)
      call assertEqual(other%traction(2), first%traction(2), 1.0e-15_wp, 'stiffness')
      settings = friction_settings(shear_limit=0.2_wp)
      p = sticking(plain%normal, rule_abaqus, slip_exact, 8, settings)
      call move(p, fresh, overclosure, 1.0_wp, r)
      call assertTrue(mu*r%traction(1) > 0.2_wp)
      call assertEqual(0.2_wp, r%traction(2), 1.0e-14_wp, 'limit')
   end subroutine test_strength

end module test_contact_summit_stick
