!> The law with heights that are not Gaussian: against 17-digit values, Gaussian heights as a limit,
!> pressures found by another program, the inverse, the compiled law, and what is refused.
module test_law_johnson
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_johnson_heights, only: find_johnson_heights, height_of, height_slope_at, &
      height_step, johnson_heights, normal_score
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, evaluate_pressure, normal_response
   use asperity_law_normal_properties, only: heights_gaussian, heights_johnson, &
      new_normal_properties, normal_properties, unloading_elastic
   use asperity_law_validity, only: closure_above_half_radius
   use asperity_paper_pairs, only: find_pair, find_surface, pair_preset, surface_preset
   use extremes, only: worsen
   use funit, only: assertEqual, assertFail, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use reference_table, only: open_table
   implicit none
   private
   public :: suite_johnson

   !> Skewness and kurtosis: unbounded and bounded, skewed to both sides, and near Gaussian
   real(wp), parameter :: shapes(2, 10) = reshape([0.0_wp, 3.61_wp, 0.0_wp, 2.5_wp, 0.0_wp, &
      3.0001_wp, 0.0_wp, 20.0_wp, 0.5_wp, 4.5_wp, -0.7_wp, 4.0_wp, 2.0_wp, 12.0_wp, -0.6_wp, &
      2.8_wp, 0.5_wp, 3.0_wp, 0.0_wp, 2.0_wp], [2, 10])

contains

   function suite_johnson() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('johnson')
      call suite%addTest(TestMethod('17-digit values', test_table))
      call suite%addTest(TestMethod('heights: moments, inverse, slope', test_heights))
      call suite%addTest(TestMethod('kurtosis 3 is Gaussian', test_gaussian))
      call suite%addTest(TestMethod('pressures of another program', test_pressures))
      call suite%addTest(TestMethod('stiffness and pressure are derivatives', test_derivatives))
      call suite%addTest(TestMethod('pressure alone is the same', test_pressure_alone))
      call suite%addTest(TestMethod('inverse', test_inverse))
      call suite%addTest(TestMethod('any separation', test_far))
      call suite%addTest(TestMethod('compiled', test_compiled))
      call suite%addTest(TestMethod('far tails raise no flag', test_flags))
      call suite%addTest(TestMethod('what is refused', test_refused))
   end function suite_johnson

   !> test/data/johnson_reference.csv, by test/reference/johnson_reference.py: d from -6 to 8 sigma,
   !> bounded heights to 0.02 sigma from their end. To 1e-12, and to what an error of the height by
   !> 32 eps max(sigma, |d|) makes: that is more near that end alone, which moves so far where
   !> moments are rounded, and is not recorded there. Shares below 1e-17 have no digits there.
   subroutine test_table()
      character(len=*), parameter :: header = 'skewness,kurtosis,plastic_ratio,sigma,eta,'// &
         'modulus,radius,hardness,yield_factor,separation,pressure,stiffness,area_fraction,'// &
         'contact_density,energy,elastic_share,elastoplastic_share,plastic_share'
      character(len=19), parameter :: columns(8) = [character(len=19) :: 'pressure', &
         'stiffness', 'area_fraction', 'contact_density', 'energy', 'elastic_share', &
         'elastoplastic_share', 'plastic_share']
      character(len=1024) :: line
      character(len=12) :: label
      type(normal_properties) :: p
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: v(18), found(8), relative, rounding, worst(8)
      integer :: unit, status, rows, j

      call open_table('johnson_reference.csv', header, unit)
      worst = 0.0_wp
      rows = 0
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         read (line, *) v
         rows = rows + 1
         write (label, '(a, i0)') 'row ', rows
         call new_normal_properties(p, v(5), v(6), v(7), v(8), v(9), v(4), error, .true., &
            plastic_ratio=v(3), height_distribution=heights_johnson, skewness=v(1), kurtosis=v(2))
         if (allocated(error)) call assertFail(error%message)
         r = evaluate_normal_law(p, v(10))
         found = [r%pressure, r%stiffness, r%area_fraction, r%contact_density, r%energy, &
            r%elastic_share, r%elastoplastic_share, r%plastic_share]
         rounding = 32.0_wp*epsilon(1.0_wp)*max(v(4), abs(v(10)))*v(12)/v(11)
         do j = 1, 8
            relative = abs(found(j) - v(10 + j))
            if (j <= 5) relative = relative/v(10 + j)
            if (rounding < 1.0e-12_wp) call worsen(worst(j), relative)
            call assertLessThan(relative, 1.0e-12_wp + rounding, trim(label)//' '//columns(j))
         end do
      end do
      close (unit)
      call assertEqual(180, rows, 'rows')
      do j = 1, 5
         call record('johnson.'//trim(columns(j))//'.relative_error', worst(j))
      end do
      call record('johnson.shares', maxval(worst(6:)))
   end subroutine test_table

   !> The function has the moments that it was asked for, by the trapezoidal rule; its inverse,
   !> steps and slope fit it.
   subroutine test_heights()
      type(johnson_heights) :: heights
      type(error_type), allocatable :: error
      real(wp) :: x, z(-1600:1600), weight(-1600:1600), moments(4), worst(4)
      integer :: i, j

      worst = 0.0_wp
      do j = 1, size(shapes, 2)
         call find_johnson_heights(heights, shapes(1, j), shapes(2, j), ['skewness', 'kurtosis'], &
            error)
         if (allocated(error)) call assertFail(error%message)
         do i = -1600, 1600
            x = 0.01_wp*i
            z(i) = height_of(heights, x)
            weight(i) = 0.01_wp*exp(-0.5_wp*x*x)/sqrt(8.0_wp*atan(1.0_wp))
            if (abs(x) > 5.0_wp) cycle
            call worsen(worst(2), abs(normal_score(heights, z(i)) - x) &
               *min(height_slope_at(heights, x), 1.0_wp)/max(abs(z(i)), 1.0_wp))
            call worsen(worst(3), abs(height_step(heights, x, 0.7_wp) &
               - (height_of(heights, x + 0.7_wp) - z(i)))/max(abs(z(i)), 1.0_wp))
            call worsen(worst(4), abs(height_step(heights, x - 1.0e-5_wp, 2.0e-5_wp)/2.0e-5_wp &
               /height_slope_at(heights, x) - 1.0_wp))
         end do
         do i = 1, 4
            moments(i) = sum(weight*z**i)
         end do
         call worsen(worst(1), abs(moments - [0.0_wp, 1.0_wp, shapes(1, j), shapes(2, j)]) &
            /[1.0_wp, 1.0_wp, 1.0_wp, shapes(2, j)])
      end do
      call record('johnson.moments', worst(1))
      call record('johnson.inverse', worst(2))
      call assertLessThan(worst(1), 1.0e-12_wp, 'moments')
      call assertLessThan(worst(2), 1.0e-13_wp, 'inverse')
      call assertLessThan(worst(3), 1.0e-13_wp, 'steps')
      call assertLessThan(worst(4), 1.0e-8_wp, 'slope')
   end subroutine test_heights

   !> Skewness 0 and kurtosis 3 give the Gaussian law; next to them the one that belongs to the
   !> smallest distance between Johnson's systems, 1e-6 in kurtosis.
   subroutine test_gaussian()
      type(normal_properties) :: p, gaussian
      type(normal_response) :: r, wanted
      real(wp) :: d
      integer :: i

      gaussian = pair_with(0.0_wp, 3.0_wp, heights_gaussian)
      do i = -12, 16
         d = 0.5_wp*i*gaussian%sigma
         wanted = evaluate_normal_law(gaussian, d)
         p = pair_with(0.0_wp, 3.0_wp)
         r = evaluate_normal_law(p, d)
         call assertRelativelyEqual([wanted%pressure, wanted%stiffness, wanted%area_fraction, &
            wanted%contact_density, wanted%energy], [r%pressure, r%stiffness, r%area_fraction, &
            r%contact_density, r%energy], 1.0e-12_wp, 'Gaussian')
         ! 1e-6/24 times the fourth Hermite polynomial of 8, 3700, over Mills' ratio and more
         p = pair_with(0.0_wp, 3.0_wp + 1.0e-9_wp)
         r = evaluate_normal_law(p, d)
         call assertRelativelyEqual(wanted%pressure, r%pressure, 3.0e-4_wp, 'next to it')
         if (abs(i) <= 6) call assertRelativelyEqual(wanted%pressure, r%pressure, 1.0e-5_wp, &
            'next to it, within 3 sigma')
      end do
   end subroutine test_gaussian

   !> Pressure over that of Gaussian heights at the separations where those give 0.05, 0.2, 1 and
   !> 4.7 MPa, for surfaces of Table 2 with the kurtosis that it names, found by another program to
   !> three figures.
   subroutine test_pressures()
      call check('transverse-tangential', 'unpolished-cross', &
         [4.94_wp, 2.89_wp, 1.73_wp, 1.22_wp])
      call check('tangential-tangential', 'unpolished-tangential', &
         [2.14_wp, 1.50_wp, 1.13_wp, 0.99_wp])
      call check('transverse-tangential', 'mesh-400-cross', [3.02_wp, 2.05_wp, 1.43_wp, 1.14_wp])
      call check('transverse-tangential', 'mesh-400-radial', [1.02_wp, 1.01_wp, 1.00_wp, 1.00_wp])
   end subroutine test_pressures

   subroutine check(pair_name, surface_name, ratios)
      character(len=*), intent(in) :: pair_name, surface_name
      real(wp), intent(in) :: ratios(4)
      real(wp), parameter :: pressures(4) = [0.05_wp, 0.2_wp, 1.0_wp, 4.7_wp]
      type(pair_preset) :: pair
      type(surface_preset) :: surface
      type(normal_properties) :: gaussian, johnson
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: d
      integer :: i

      call find_pair(pair_name, pair, error)
      call find_surface(surface_name, surface, error)
      if (allocated(error)) call assertFail(error%message)
      pair%eta = surface%eta
      pair%radius = surface%radius
      pair%sigma = surface%sigma
      call new_normal_properties(gaussian, pair, error)
      call new_normal_properties(johnson, pair, error, height_distribution=heights_johnson, &
         kurtosis=surface%kurtosis)
      if (allocated(error)) call assertFail(error%message)
      do i = 1, 4
         call separation_for_pressure(gaussian, pressures(i), d, error)
         r = evaluate_normal_law(johnson, d)
         write (*, '(5x, a, 2f9.4)') surface_name, ratios(i), r%pressure/pressures(i)
         call assertLessThan(abs(r%pressure/pressures(i) - ratios(i)), 0.0051_wp, surface_name)
      end do
   end subroutine check

   !> -dp/dd and -dE/dd by central differences of five points.
   subroutine test_derivatives()
      type(normal_properties) :: p
      type(normal_response) :: r, at(4)
      real(wp) :: d, step, worst
      integer :: i, j

      worst = 0.0_wp
      do j = 1, size(shapes, 2)
         p = pair_with(shapes(1, j), shapes(2, j))
         do i = -10, 12
            d = 0.3_wp*i*p%sigma
            if (d > p%vanishing_separation - 0.3_wp*p%sigma) cycle
            r = evaluate_normal_law(p, d)
            step = 2.0e-3_wp*p%sigma
            at = evaluate_normal_law(p, d + step*[-2, -1, 1, 2])
            call worsen(worst, abs([(8.0_wp*(at(2)%pressure - at(3)%pressure) &
               - at(1)%pressure + at(4)%pressure)/(12.0_wp*step*r%stiffness), &
               (8.0_wp*(at(2)%energy - at(3)%energy) - at(1)%energy + at(4)%energy) &
               /(12.0_wp*step*r%pressure)] - 1.0_wp))
         end do
      end do
      call record('johnson.derivative', worst)
      call assertLessThan(worst, 1.0e-7_wp, 'derivatives')
   end subroutine test_derivatives

   !> What a contact point takes equals the whole law, flags too.
   subroutine test_pressure_alone()
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: pressure, stiffness, energy, d
      integer :: i, j, validity

      do j = 1, size(shapes, 2)
         p = pair_with(shapes(1, j), shapes(2, j))
         do i = -12, 16
            d = 0.5_wp*i*p%sigma
            r = evaluate_normal_law(p, d)
            call evaluate_pressure(p, d, pressure, stiffness, energy, validity)
            call assertEqual([r%pressure, r%stiffness, r%energy], [pressure, stiffness, energy], &
               0.0_wp, 'to the bit')
            call assertEqual(r%validity, validity, 'flags')
         end do
      end do
   end subroutine test_pressure_alone

   !> The separation of a pressure, from 1e-250 MPa, or 1e-12 MPa of bounded heights, up to one near
   !> the hardness, to the pressure that rounding the separation and the height in it makes.
   subroutine test_inverse()
      type(normal_properties) :: p
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: pressure, d
      integer :: i, j

      do j = 1, size(shapes, 2)
         p = pair_with(shapes(1, j), shapes(2, j))
         do i = -25, 1
            if (p%heights%curve%is_bounded .and. i < -12) cycle
            pressure = 2.0_wp*10.0_wp**merge(10*i, i, i < -12)
            call separation_for_pressure(p, pressure, d, error)
            if (allocated(error)) call assertFail(error%message)
            r = evaluate_normal_law(p, d)
            call assertLessThan(abs(r%pressure - pressure), 1.0e-12_wp*pressure &
               + 8.0_wp*epsilon(d)*max(p%sigma, abs(d))*r%stiffness, 'pressure')
         end do
      end do
   end subroutine test_inverse

   !> Any separation up to 1e100 sigma gives finite numbers, the pressure never rises, and beyond
   !> the last summit all is zero.
   subroutine test_far()
      type(normal_properties) :: p
      type(normal_response) :: r, before
      real(wp) :: d
      integer :: i, j

      do j = 1, size(shapes, 2)
         p = pair_with(shapes(1, j), shapes(2, j))
         before = evaluate_normal_law(p, -1.0e100_wp*p%sigma)
         do i = -200, 200
            d = sinh(1.15_wp*i)*p%sigma
            if (abs(d) > 1.0e100_wp*p%sigma) cycle
            r = evaluate_normal_law(p, d)
            call assertTrue(r%pressure >= 0.0_wp .and. r%pressure <= before%pressure, 'falls')
            call assertTrue(r%energy >= 0.0_wp .and. r%stiffness >= 0.0_wp, 'not negative')
            call assertRelativelyEqual(1.0_wp, &
               r%elastic_share + r%elastoplastic_share + r%plastic_share, 1.0e-14_wp, 'shares')
            before = r
         end do
         r = evaluate_normal_law(p, p%vanishing_separation*1.001_wp)
         call assertEqual(0.0_wp, r%pressure, 0.0_wp, 'vanished')
      end do
   end subroutine test_far

   !> Within 1e-9 of the direct evaluation, Gaussian numbers up to 8, unless heights end steeply:
   !> the law is then rougher as a function of them.
   subroutine test_compiled()
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: d, pressure, stiffness, area, density, energy, worst(2, 2)
      integer :: i, j, k, kind, validity

      worst = 0.0_wp
      do j = 1, size(shapes, 2)
         p = pair_with(shapes(1, j), shapes(2, j))
         kind = merge(2, 1, p%heights%curve%is_bounded .and. p%heights%curve%s > 1.0_wp)
         do k = 1, 2
            if (k == 1) call new_compiled_law(law, p, error)
            if (k == 2) call new_compiled_law(law, p, error, [-1.0_wp, 2.0_wp]*p%sigma)
            if (allocated(error)) call assertFail(error%message)
            do i = -777, 777
               d = height_of(p%heights, 0.01_wp*i)*p%sigma
               if (d > p%vanishing_separation - 0.02_wp*p%sigma) exit
               r = evaluate_normal_law(p, d)
               call evaluate_compiled_law(law, d, pressure, stiffness, area, density, energy, &
                  validity)
               call worsen(worst(1, kind), abs([pressure/r%pressure, area/r%area_fraction, &
                  energy/r%energy, density/r%contact_density] - 1.0_wp))
               call worsen(worst(2, kind), abs(stiffness/r%stiffness - 1.0_wp))
               call assertEqual(r%validity, validity, 'flags')
            end do
         end do
         call evaluate_compiled_law(law, p%vanishing_separation*1.001_wp, pressure, stiffness, area)
         call assertEqual(0.0_wp, pressure + stiffness + area, 0.0_wp, 'beyond')
      end do
      call record('johnson.compiled', worst(1, 1))
      call record('johnson.compiled.stiffness', worst(2, 1))
      call record('johnson.compiled.steep', maxval(worst(:, 2)))
      call assertLessThan(maxval(worst(:, 1)), 1.0e-9_wp, 'compiled')
      call assertLessThan(maxval(worst(:, 2)), 1.0e-6_wp, 'compiled, steep end')
   end subroutine test_compiled

   !> Far out of heavy tails the few summits in contact are all tall; that is no limit passed.
   subroutine test_flags()
      type(normal_properties) :: p
      type(normal_response) :: r
      integer :: i

      p = pair_with(0.0_wp, 20.0_wp)
      do i = 1, 40
         r = evaluate_normal_law(p, p%judged_separation + i*p%sigma)
         call assertEqual(0, r%validity, 'far')
      end do
      r = evaluate_normal_law(p, -2.0_wp*p%sigma)
      call assertTrue(iand(r%validity, closure_above_half_radius) > 0, 'near')
   end subroutine test_flags

   !> Pairs of skewness and kurtosis that no heights have, ranges, and elastic unloading.
   subroutine test_refused()
      call refused(2.0_wp, 4.9_wp, 'skewness = 2.0 with kurtosis = 4.9 is not allowed: no '// &
         'heights have kurtosis below skewness^2 + 1 = 5')
      call refused(0.0_wp, 0.5_wp, 'kurtosis = 0.5 is not allowed: it must be a number between')
      call refused(0.0_wp, 61.0_wp, 'kurtosis = 61.0 is not allowed: it must be a number between')
      call refused(-4.5_wp, 50.0_wp, 'skewness = -4.5 is not allowed: it must be a number between')
      call refused(0.0_wp, 1.05_wp, 'skewness = 0.0 with kurtosis = 1.05 cannot be reached: give')
      call refused(0.0_wp, 3.5_wp, 'height_distribution = johnson is not possible with elastic', &
         unloading=unloading_elastic)
      call refused(0.0_wp, 3.5_wp, 'height_distribution = 2 is unknown: 0 is gaussian, 1 is '// &
         'johnson', distribution=2)
      call refused(0.0_wp, 1.7_wp, 'kurtosis = 1.7 with skewness = 0.0 is not allowed: such '// &
         'heights have two peaks or a cliff')
   end subroutine test_refused

   subroutine refused(skewness, kurtosis, message, distribution, unloading)
      real(wp), intent(in) :: skewness, kurtosis
      character(len=*), intent(in) :: message
      integer, intent(in), optional :: distribution, unloading
      type(normal_properties) :: p
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      integer :: how

      how = heights_johnson
      if (present(distribution)) how = distribution
      call find_pair('transverse-tangential', pair, error)
      call new_normal_properties(p, pair, error, unloading=unloading, height_distribution=how, &
         skewness=skewness, kurtosis=kurtosis)
      if (.not. allocated(error)) then
         call assertFail('accepted: '//message)
      else
         call assertEqual(message, error%message(:min(len(message), len(error%message))), 'message')
      end if
   end subroutine refused

   function pair_with(skewness, kurtosis, distribution) result(p)
      real(wp), intent(in) :: skewness, kurtosis
      integer, intent(in), optional :: distribution
      type(normal_properties) :: p
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      integer :: how

      how = heights_johnson
      if (present(distribution)) how = distribution
      call find_pair('transverse-tangential', pair, error)
      call new_normal_properties(p, pair, error, height_distribution=how, skewness=skewness, &
         kurtosis=kurtosis)
      if (allocated(error)) error stop 'johnson: '//error%message
   end function pair_with

end module test_law_johnson
