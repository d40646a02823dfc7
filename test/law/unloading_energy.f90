!> Energy of the law with memory, and the inverse of its unloading branch: stored energy is the
!> integral of the pressure, dissipation never falls, cycles never create energy.
module test_law_unloading_energy
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law, plastic_dissipation
   use asperity_law_unloading_summit, only: elastic_recovery
   use extremes, only: worsen
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertLessThanOrEqual, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_properties, random_stream
   use test_law_unloading_law, only: random_unloading
   implicit none
   private
   public :: suite_unloading_energy

contains

   function suite_unloading_energy() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('unloading energy')
      call suite%addTest(TestMethod('stored energy is the integral of pressure', test_integral))
      call suite%addTest(TestMethod('dissipation grows as the face comes closer', test_dissipation))
      call suite%addTest(TestMethod('random cycles create no energy', test_cycles))
      call suite%addTest(TestMethod('retraction for a pressure', test_inverse))
      call suite%addTest(TestMethod('smallest pressures', test_smallest))
   end function suite_unloading_energy

   !> Work of the pressure from retraction `from` to `to`, N/mm, split where the last elastic and
   !> the last elasto-plastic summit lose contact and, for the rest, in `n` parts.
   real(wp) function work(p, d, from, to, n)
      type(normal_properties), intent(in) :: p
      real(wp), intent(in) :: d, from, to
      integer, intent(in) :: n
      type(normal_response) :: r
      real(wp) :: ends(4), a, b
      integer :: i, j, part

      ends = [from, min(max(p%w1, from), to), min(max(elastic_recovery(p, p%w2), from), to), to]
      work = 0.0_wp
      do i = 1, 3
         do part = 1, n
            a = ends(i) + (ends(i + 1) - ends(i))*real(part - 1, wp)/n
            b = ends(i) + (ends(i + 1) - ends(i))*real(part, wp)/n
            if (.not. b > a) cycle
            do j = 1, n_points
               r = evaluate_unloading_law(p, d, 0.5_wp*(a + b) + 0.5_wp*(b - a)*nodes(j))
               work = work + 0.5_wp*(b - a)*weights(j)*r%pressure
            end do
         end do
      end do
   end function work

   !> From a retraction of 1e-3 to one of 0.9 of that at which a billionth of the pressure is left.
   subroutine test_integral()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: first, last
      real(wp) :: d, u, top, worst
      integer :: i

      stream = random_stream(81)
      worst = 0.0_wp
      do i = 1, 60
         call random_unloading(stream, i, p, d, u)
         first = evaluate_normal_law(p, d)
         top = retraction_for_pressure(p, d, 1.0e-9_wp*first%pressure)
         first = evaluate_unloading_law(p, d, 1.0e-3_wp*top)
         last = evaluate_unloading_law(p, d, 0.9_wp*top)
         call worsen(worst, abs(work(p, d, 1.0e-3_wp*top, 0.9_wp*top, 3) &
            /(first%energy - last%energy) - 1.0_wp))
      end do
      call record('unloading_law.energy.integral_error', worst)
      call assertLessThan(worst, 1.0e-11_wp, 'relative difference')
   end subroutine test_integral

   !> At steps of 1e-9 sigma and more, down to the smallest normal number.
   subroutine test_dissipation()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: d, lost(2)
      integer :: i, n_falling

      stream = random_stream(82)
      n_falling = 0
      do i = 1, 10000
         call random_properties(stream, p, 1.0e-6_wp, 1.0e2_wp, 0.1908_wp)
         d = p%sigma*stream%uniform(-40.0_wp, 37.0_wp)
         lost(1) = plastic_dissipation(p, d)
         lost(2) = plastic_dissipation(p, d - p%sigma*stream%log_uniform(1.0e-9_wp, 10.0_wp))
         call assertLessThanOrEqual(0.0_wp, lost(1), 'never negative')
         if (lost(2) < lost(1)) n_falling = n_falling + 1
         r = evaluate_unloading_law(p, d, p%sigma)
         call assertEqual(lost(1), r%plastic_dissipation, 0.0_wp, 'a constant of the branch')
      end do
      call assertEqual(0, n_falling, 'falling dissipations')
   end subroutine test_dissipation

   !> A face of the paper and a smooth one, pressed ever closer and parted again at random: work
   !> done on it less what is stored is what the law says is lost, and never falls. On the virgin
   !> branch the work is the reversible law's energy, on the unloading branch a quadrature.
   subroutine test_cycles()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: virgin(2), r
      real(wp) :: d, u, next, total, stored, lost, worst
      integer :: pair, i

      stream = random_stream(83)
      worst = 0.0_wp
      do pair = 1, 2
         p = normal_of_pair(merge('transverse-tangential', 'tangential-tangential', pair == 1))
         d = 6.0_wp*p%sigma
         u = 0.0_wp
         r = evaluate_unloading_law(p, d, 0.0_wp)
         total = r%energy + r%plastic_dissipation
         lost = r%plastic_dissipation
         do i = 1, 60
            next = p%w1*stream%uniform(0.0_wp, 60.0_wp)
            if (mod(i, 3) == 0) next = -p%sigma*stream%uniform(0.0_wp, 0.5_wp)
            if (next > u) then
               total = total - work(p, d, u, next, 4)
            else
               total = total + work(p, d, max(next, 0.0_wp), u, 4)
            end if
            if (next < 0.0_wp) then
               virgin(1) = evaluate_normal_law(p, d)
               d = d + next
               virgin(2) = evaluate_normal_law(p, d)
               total = total + virgin(2)%energy - virgin(1)%energy
            end if
            u = max(next, 0.0_wp)
            r = evaluate_unloading_law(p, d, u)
            stored = r%energy
            call worsen(worst, abs(total - stored - r%plastic_dissipation)/total)
            call assertLessThanOrEqual(lost, r%plastic_dissipation, 'never given back')
            lost = r%plastic_dissipation
         end do
      end do
      call record('unloading_law.cycles.energy_error', worst)
      call assertLessThan(worst, 1.0e-11_wp, 'work = stored + lost')
   end subroutine test_cycles

   !> p(u(p)) to 64 eps of the pressure, of its change over the retraction, or of what rounding the
   !> separation does to it; zero at the closest separation's own and above.
   subroutine test_inverse()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: closest, r
      real(wp) :: d, u, pressure, worst
      integer :: i

      stream = random_stream(84)
      worst = 0.0_wp
      do i = 1, 10000
         call random_unloading(stream, i, p, d, u)
         closest = evaluate_normal_law(p, d)
         pressure = closest%pressure*stream%log_uniform(1.0e-12_wp, 1.0_wp)
         u = retraction_for_pressure(p, d, pressure)
         r = evaluate_unloading_law(p, d, u)
         call worsen(worst, abs(r%pressure - pressure) &
            /(pressure + r%stiffness*max(u, p%sigma*epsilon(u)))/epsilon(u))
         call assertEqual(0.0_wp, retraction_for_pressure(p, d, closest%pressure), 0.0_wp, 'itself')
         call assertEqual(0.0_wp, retraction_for_pressure(p, d, 2.0_wp*closest%pressure), 0.0_wp, &
            'above')
      end do
      call record('unloading_inverse.round_trip.eps', worst)
      call assertLessThan(worst, 64.0_wp, 'error in eps')
   end subroutine test_inverse

   !> Pressures from 1e-300 MPa, wherever the face is pressed harder; zero and less end where the
   !> smallest normal number does.
   subroutine test_smallest()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: closest, r
      real(wp) :: d, u, pressure, worst
      integer :: i, tried

      stream = random_stream(85)
      worst = 0.0_wp
      tried = 0
      do i = 1, 3000
         call random_unloading(stream, i, p, d, u)
         closest = evaluate_normal_law(p, d)
         pressure = stream%log_uniform(1.0e-300_wp, 1.0e-10_wp)
         if (pressure >= closest%pressure) cycle
         tried = tried + 1
         u = retraction_for_pressure(p, d, pressure)
         r = evaluate_unloading_law(p, d, u)
         call worsen(worst, abs(r%pressure - pressure)/(pressure + r%stiffness*u)/epsilon(u))
         u = retraction_for_pressure(p, d, tiny(u))
         call assertEqual(u, retraction_for_pressure(p, d, 0.0_wp), 0.0_wp, 'zero')
         call assertEqual(u, retraction_for_pressure(p, d, -1.0_wp), 0.0_wp, 'below zero')
      end do
      call assertGreaterThan(tried, 2500, message='cases')
      call record('unloading_inverse.smallest.eps', worst)
      call assertLessThan(worst, 64.0_wp, 'error in eps')
   end subroutine test_smallest

end module test_law_unloading_energy
