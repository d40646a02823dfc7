!> The shear-box replay against formulas: balance, plateau, slope, dissipation = enclosed area,
!> overlap of the discs.
module test_replay_shear_box
   use asperity, only: contact_properties, error_type, evaluate_normal_law, normal_response, &
      separation_for_pressure, status_slip, status_stick, wp
   use asperity_replay_shear_box, only: overlap_area, run_shear_box, shear_settings, shear_step
   use asperity_replay_shear_settings, only: check_shear_settings
   use contact_cases, only: pair_properties
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_shear_box

   real(wp), parameter :: pi = acos(-1.0_wp)

contains

   function suite_shear_box() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('shear box')
      call suite%addTest(TestMethod('overlap of two discs', test_overlap))
      call suite%addTest(TestMethod('plateau, slope and closure', test_plateau))
      call suite%addTest(TestMethod('constant area: dissipation is the enclosed area', test_cycle))
      call suite%addTest(TestMethod('shrinking overlap', test_shrinking))
      call suite%addTest(TestMethod('compliant specimens', test_compliance))
      call suite%addTest(TestMethod('very soft specimens', test_soft))
      call suite%addTest(TestMethod('settings that are refused', test_refused))
      call suite%addTest(TestMethod('way of the box', test_way))
   end function suite_shear_box

   !> A/A0 = 0.979, 0.938, 0.897 at 1, 3, 5 mm; the derivative at zero is -diameter.
   subroutine test_overlap()
      real(wp), parameter :: d = 61.8_wp, h = 1.0e-6_wp
      real(wp) :: full

      full = overlap_area(d, 0.0_wp)
      call assertEqual(0.25_wp*pi*d**2, full, 1.0e-12_wp*full, 'full disc')
      call assertEqual([0.979_wp, 0.938_wp, 0.897_wp], &
         overlap_area(d, [1.0_wp, -3.0_wp, 5.0_wp])/full, 5.0e-4_wp, 'shares')
      call assertEqual(-d, (overlap_area(d, h) - full)/h, 1.0e-3_wp, 'slope')
      call assertEqual(0.0_wp, overlap_area(d, 100.0_wp), 0.0_wp, 'apart')
   end subroutine test_overlap

   !> Both pairs and the three weights of the paper: tau = mu p min(1, slip/gcrit), at the closure
   !> at which the law carries the weight.
   subroutine test_plateau()
      real(wp), parameter :: stresses(3) = [0.05_wp, 0.1_wp, 0.2_wp]
      type(contact_properties) :: p
      type(shear_settings) :: settings
      type(shear_step), allocatable :: steps(:)
      type(error_type), allocatable :: error
      real(wp) :: separation, worst
      integer :: i, j, pair

      worst = 0.0_wp
      do pair = 1, 2
         p = pair_properties()
         if (pair == 2) p = pair_properties(pair='tangential-tangential')
         do i = 1, 3
            settings%normal_stress = stresses(i)
            settings%shrinking_overlap = .false.
            call run_shear_box(settings, p, steps, error)
            call assertFalse(allocated(error), 'runs')
            call separation_for_pressure(p%normal, stresses(i), separation, error)
            do j = 1, size(steps)
               associate (s => steps(j))
                  call assertEqual(stresses(i), s%normal_stress, 1.0e-11_wp*stresses(i), 'balance')
                  call assertEqual(separation, s%separation, 1.0e-10_wp, 'separation')
                  call assertEqual(0.5_wp*stresses(i)*min(1.0_wp, s%displacement/0.31_wp), &
                     s%shear_stress, 1.0e-11_wp, 'shear stress')
                  call worsen(worst, abs(s%shear_stress - 0.5_wp*stresses(i) &
                     *min(1.0_wp, s%displacement/0.31_wp))/stresses(i))
                  call assertEqual(merge(status_slip, status_stick, s%displacement > 0.31_wp), &
                     s%status, 'status')
                  call assertEqual(50.0_wp*s%displacement, s%time, 1.0e-9_wp, '1.2 mm/min')
               end associate
               if (anyExceptions()) return
            end do
         end do
      end do
      call record('shear_box.plateau_and_slope', worst)
   end subroutine test_plateau

   !> At constant area and pressure a closed cycle dissipates its enclosed area: per cycle of
   !> amplitude a, 4 mu W (a - g) once the loop is closed.
   subroutine test_cycle()
      type(contact_properties) :: p
      type(shear_settings) :: settings
      type(shear_step), allocatable :: steps(:)
      type(error_type), allocatable :: error
      real(wp) :: enclosed, weight, first, last
      integer :: i, j
      real(wp), parameter :: a = 1.5_wp, g = 0.31_wp

      p = pair_properties()
      settings%displacement = [a, -a, a]
      settings%shrinking_overlap = .false.
      ! a step that divides the amplitude and gcrit, so that the trapezoid is exact
      settings%displacement_increment = 0.01_wp
      call run_shear_box(settings, p, steps, error)
      call assertFalse(allocated(error), 'runs')
      i = 151
      j = 151 + 600
      first = steps(i)%dissipation
      last = steps(j)%dissipation
      call assertEqual([a, a], [steps(i)%displacement, steps(j)%displacement], 1.0e-12_wp, 'cycle')
      enclosed = sum(0.5_wp*(steps(i + 1:j)%shear_force + steps(i:j - 1)%shear_force) &
         *(steps(i + 1:j)%displacement - steps(i:j - 1)%displacement))
      weight = 0.05_wp*overlap_area(61.8_wp, 0.0_wp)
      call record('shear_box.dissipation', abs(last - first - enclosed)/enclosed)
      call assertEqual(enclosed, last - first, 1.0e-9_wp*enclosed, 'enclosed area')
      call assertEqual(4.0_wp*0.5_wp*weight*(a - g), enclosed, 1.0e-9_wp*enclosed, 'formula')
      call assertEqual(0.0_wp, steps(j)%pressure_coupling, 1.0e-9_wp*enclosed, 'no coupling')
   end subroutine test_cycle

   !> Dead weight on a shrinking overlap: force and nominal shear stress stay, the stress on the
   !> current area rises as A0/A.
   subroutine test_shrinking()
      type(shear_settings) :: settings
      type(shear_step), allocatable :: steps(:)
      type(error_type), allocatable :: error
      type(contact_properties) :: p
      type(normal_response) :: law
      real(wp) :: ratio, dissipation, coupling, gamma
      integer :: i, n

      p = pair_properties()
      settings%displacement = [5.0_wp]
      call run_shear_box(settings, p, steps, error)
      n = size(steps)
      ratio = overlap_area(61.8_wp, 5.0_wp)/overlap_area(61.8_wp, 0.0_wp)
      call assertEqual(0.05_wp/ratio, steps(n)%normal_stress, 1.0e-11_wp, 'normal stress')
      call assertEqual(0.025_wp, steps(n)%shear_stress_nominal, 1.0e-11_wp, 'nominal is flat')
      call assertEqual(0.025_wp/ratio, steps(n)%shear_stress, 1.0e-11_wp, 'current rises')
      call assertGreaterThan(steps(n)%overclosure, steps(1)%overclosure, 'closes further')
      dissipation = 0.0_wp
      coupling = 0.0_wp
      do i = 2, n
         associate (s => steps(i), last => steps(i - 1))
            law = evaluate_normal_law(p%normal, s%separation)
            call assertEqual(law%area_fraction, s%area_fraction, 0.0_wp, 'real area')
            call assertEqual(s%overlap_area*law%energy, s%normal_energy, &
               1.0e-12_wp*s%normal_energy, 'stored normal energy')
            gamma = min(s%slip, 0.31_wp)
            call assertEqual(s%overlap_area*0.25_wp*s%normal_stress*gamma**2/0.31_wp, &
               s%tangential_energy, 1.0e-9_wp, 'stored tangential energy')
            ! the slip beyond gcrit at the pressure and on the overlap of the end of the step
            dissipation = dissipation + s%overlap_area*0.5_wp*s%normal_stress &
               *(max(s%slip - 0.31_wp, 0.0_wp) - max(last%slip - 0.31_wp, 0.0_wp))
            call assertEqual(dissipation, s%dissipation, 1.0e-8_wp, 'dissipation')
            coupling = coupling + s%overlap_area*0.25_wp*min(last%slip, 0.31_wp)**2/0.31_wp &
               *(s%normal_stress - last%normal_stress)
            call assertEqual(coupling, s%pressure_coupling, 1.0e-8_wp, 'pressure coupling')
            call assertEqual(law%validity, s%validity, 'validity')
         end associate
         if (anyExceptions()) return
      end do
      call assertGreaterThan(coupling, 0.1_wp, 'pressure rises under stored slip')
      settings = shear_settings(normal_stress=30.0_wp, accept_sizes=.true.)
      call run_shear_box(settings, p, steps, error)
      call assertEqual(3.0_wp, steps(size(steps))%displacement, 0.0_wp, 'default displacement')
      call assertEqual(3, steps(1)%validity, 'past real area and hardness')
   end subroutine test_shrinking

   !> Specimens so soft that the faces stick for several steps and then slip within one: Newton
   !> alone would hop between slip to and fro.
   subroutine test_soft()
      type(contact_properties) :: p
      type(shear_settings) :: settings
      type(shear_step), allocatable :: steps(:)
      type(error_type), allocatable :: error
      real(wp), parameter :: compliances(4) = [1.0e-3_wp, 1.0e-1_wp, 1.0e6_wp, 1.0e-4_wp]
      real(wp), parameter :: increments(4) = [0.02_wp, 1.0_wp, 1.0_wp, 0.02_wp]
      real(wp), parameter :: slips(4) = [1.0e-3_wp, 0.31_wp, 0.31_wp, 1.0e-6_wp]
      integer :: i

      do i = 1, 4
         p = pair_properties()
         p%critical_slip = slips(i)
         settings = shear_settings(shear_compliance=compliances(i), &
            displacement_increment=increments(i))
         call run_shear_box(settings, p, steps, error)
         call assertFalse(allocated(error), 'runs')
         if (allocated(error)) return
         call assertEqual(steps%displacement, steps%slip + compliances(i)*steps%shear_force, &
            1.0e-9_wp, 'displacement')
      end do
   end subroutine test_soft

   !> Displacement = slip + compliance times force; the initial slope is that of two springs.
   subroutine test_compliance()
      type(shear_settings) :: settings
      type(shear_step), allocatable :: steps(:)
      type(error_type), allocatable :: error
      real(wp) :: stiffness
      integer :: i

      settings%shear_compliance = 0.002_wp
      settings%shrinking_overlap = .false.
      settings%displacement = [2.0_wp, -2.0_wp]
      call run_shear_box(settings, pair_properties(), steps, error)
      call assertFalse(allocated(error), 'runs')
      do i = 1, size(steps)
         call assertEqual(steps(i)%displacement, steps(i)%slip + 0.002_wp*steps(i)%shear_force, &
            1.0e-10_wp, 'displacement')
      end do
      stiffness = 0.5_wp*0.05_wp*overlap_area(61.8_wp, 0.0_wp)/0.31_wp
      call assertEqual(1.0_wp/(1.0_wp/stiffness + 0.002_wp), steps(2)%shear_force &
         /steps(2)%displacement, 1.0e-8_wp*stiffness, 'slope')
      call assertLessThan(steps(2)%shear_force/steps(2)%displacement, stiffness, 'softer')
   end subroutine test_compliance

   subroutine test_refused()
      type(shear_settings) :: s

      s%diameter = -1.0_wp
      call expect(s, 'diameter = -1.0')
      s = shear_settings(normal_stress=0.0_wp)
      call expect(s, 'normal_stress = 0.0')
      s = shear_settings(normal_stress=5.0e-7_wp, accept_sizes=.true.)
      call expect(s, 'normal_stress = 5.0E-7 MPa leaves the faces open')
      s = shear_settings(rate=-1.2_wp)
      call expect(s, 'rate = -1.2')
      s = shear_settings(displacement_increment=0.0_wp)
      call expect(s, 'displacement_increment = 0.0')
      s = shear_settings(shear_compliance=-1.0_wp)
      call expect(s, 'shear_compliance = -1.0')
      s = shear_settings(displacement=[1.0_wp, 60.0_wp])
      call expect(s, 'displacement = 60.0')
      s%accept_sizes = .true.
      call expect(s, 'displacement = 60.0 mm is not allowed')
      s = shear_settings()
      allocate (s%displacement(0))
      call expect(s, 'displacement is empty')
      s = shear_settings(displacement_increment=1.0e-9_wp, accept_sizes=.true.)
      call expect(s, 'displacement_increment = 1.0E-9 mm gives more than 1000000 steps')
   end subroutine test_refused

   subroutine expect(settings, text)
      type(shear_settings), intent(in) :: settings
      character(len=*), intent(in) :: text
      type(shear_step), allocatable :: steps(:)
      type(error_type), allocatable :: error

      call run_shear_box(settings, pair_properties(), steps, error)
      call assertTrue(allocated(error), text)
      if (.not. allocated(error)) return
      call assertEqual(1, index(error%message, text), error%message)
      call assertTrue(fits_subject(error), error%message)
   end subroutine expect

   !> The box may move by 0.9 of the diameter, whatever is accepted, and by 0.00091 of it at least,
   !> unless it is accepted.
   subroutine test_way()
      real(wp), parameter :: d = 61.8_wp, high = 0.9_wp*d, low = 0.00091_wp*d

      call check(high, .false., .true.)
      call check(-high, .false., .true.)
      call check(nearest(high, 1.0_wp), .false., .false.)
      call check(nearest(high, 1.0_wp), .true., .false.)
      call check(low, .false., .true.)
      call check(nearest(low, -1.0_wp), .false., .false.)
      call check(nearest(low, -1.0_wp), .true., .true.)
   contains
      subroutine check(way, accepted, passes)
         real(wp), intent(in) :: way
         logical, intent(in) :: accepted, passes
         type(error_type), allocatable :: error

         call check_shear_settings(shear_settings(accept_sizes=accepted), [way], error)
         call assertTrue(passes .neqv. allocated(error), 'way of the box')
      end subroutine check
   end subroutine test_way

end module test_replay_shear_box
