!> Profiles: closed forms, sums by the definition, profiles cut from generated surfaces against the
!> surface, uncertainties against the scatter of many sets, and what is said of them.
module test_surface_profiles
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_student, only: student_factor
   use asperity_height_map_type, only: height_map
   use asperity_surface_analysis, only: analyse_surface, analysis_settings, preparation_settings, &
      prepare_surface, surface_analysis_type
   use asperity_surface_generate_map, only: generate_surface
   use asperity_surface_generate_settings, only: surface_settings
   use asperity_surface_parameters_parameters, only: n_parameters, p_direction, p_eta_nayak, p_m0, &
      p_m2, p_m2_across, p_m2_x, p_m2_y, p_m4, p_m4_x, p_m4_y, p_radius_nayak, p_sdq, &
      p_sigma_nayak, p_sku, p_sq, p_ssk, parameters
   use asperity_surface_profiles_analysis, only: add_profiles, analyse_profiles, groups_of, &
      profile_set
   use asperity_surface_remarks_on_profiles, only: find_profile_remarks, profile_facts
   use asperity_surface_remarks_remark, only: remark_type
   use extremes, only: worsen
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertTrue, TestMethod, &
      TestSuite
   use map_cases, only: flat_map
   use measurements, only: record
   implicit none
   private
   public :: suite_surface_profiles

   real(wp), parameter :: pi = 4.0_wp*atan(1.0_wp)
   type(preparation_settings), parameter :: plain = preparation_settings()

contains

   function suite_surface_profiles() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface profiles')
      call suite%addTest(TestMethod('a wave', test_wave))
      call suite%addTest(TestMethod('sums by the definition', test_definition))
      call suite%addTest(TestMethod('forms and holes', test_preparation))
      call suite%addTest(TestMethod('lines of a map have its m2 and m4', test_lines))
      call suite%addTest(TestMethod('profiles of an isotropic surface', test_isotropic))
      call suite%addTest(TestMethod('two directions of a lay', test_lay))
      call suite%addTest(TestMethod('uncertainty of two directions', test_two_uncertainties))
      call suite%addTest(TestMethod('what is refused', test_refused))
      call suite%addTest(TestMethod('limits of remarks', test_remarks))
   end function suite_surface_profiles

   !> Add a map's lines, which must work.
   subroutine add(set, map, direction, settings)
      type(profile_set), intent(inout) :: set
      type(height_map), intent(in) :: map
      integer, intent(in) :: direction
      type(preparation_settings), intent(in) :: settings
      type(error_type), allocatable :: error

      call add_profiles(set, map, 1, direction, settings, error)
      if (allocated(error)) call assertEqual('', error%message)
   end subroutine add

   !> Of a cos(2 pi x/wave): a^2/2, and times (2 sin(pi step/wave)/step)^2 for m2, squared for m4,
   !> at 1, 2 and 4 times the step. 60 waves, whose ends err by a part in that; even, so that the
   !> mean line has no slope. ssk 0, sku 1.5.
   subroutine test_wave()
      real(wp), parameter :: a = 0.013_wp, wave = 0.2_wp, step = 0.004_wp
      integer, parameter :: n = 3001
      type(profile_set) :: set
      type(surface_analysis_type) :: analysis
      type(height_map) :: map
      real(wp) :: s
      integer :: i, k

      call flat_map(map, n, 1, step, step)
      map%heights(:, 1) = [(3.0_wp + 0.2_wp*i + a*cos(2.0_wp*pi*(i - 1501)*step/wave), i=1, n)]
      call add(set, map, 1, plain)
      call analyse_profiles(set, 16, analysis)
      do k = 1, 3
         s = 2.0_wp*sin(pi*2**(k - 1)*step/wave)/(2**(k - 1)*step)
         associate (v => analysis%values(:, k))
            call assertEqual(0.5_wp*a**2, v(p_m0), 2.0e-3_wp*a**2)
            call assertEqual(0.5_wp*(a*s)**2, v(p_m2), 2.0e-3_wp*(a*s)**2)
            call assertEqual(0.5_wp*(a*s*s)**2, v(p_m4), 2.0e-3_wp*(a*s*s)**2)
            call assertEqual(a/sqrt(2.0_wp), v(p_sq), 2.0e-3_wp*a)
            call assertEqual(0.0_wp, v(p_ssk), 2.0e-3_wp)
            call assertEqual(1.5_wp, v(p_sku), 5.0e-3_wp)
            ! (m4/m2)/(6 pi sqrt 3), (3/8) sqrt(pi/m4); alpha = 1
            call assertEqual(s**2/(6.0_wp*pi*sqrt(3.0_wp)), v(p_eta_nayak), &
               2.0e-3_wp*v(p_eta_nayak))
            call assertEqual(0.375_wp*sqrt(2.0_wp*pi)/(a*s*s), v(p_radius_nayak), &
               2.0e-3_wp*v(p_radius_nayak))
         end associate
      end do
   end subroutine test_wave

   !> Two profiles of different length with holes, each about its mean line, in loops.
   subroutine test_definition()
      type(profile_set) :: set
      type(surface_analysis_type) :: analysis
      type(height_map) :: map
      real(wp), parameter :: step = 0.01_wp
      real(wp) :: c(2), m(3), n(3), z(300), mean, x
      integer :: i, k, length

      m = 0.0_wp
      n = 0.0_wp
      mean = 0.0_wp
      do k = 1, 2
         length = 100*(k + 1)
         call flat_map(map, length, 1, step, step)
         do i = 1, length
            map%heights(i, 1) = sin(0.7_wp*i + k) + 0.4_wp*cos(0.11_wp*i*i) + 0.05_wp*i
            if (mod(i, 30) == 7) map%heights(i, 1) = none
         end do
         call add(set, map, 1, preparation_settings(most_missing=0.1_wp))
         ! the line by its two normal equations, x from the middle of the measured points
         z(:length) = map%heights(:, 1)
         associate (q => pack([(i, i=1, length)], z(:length) < none))
            x = sum(real(q, wp))/size(q)
            c(2) = sum((q - x)*z(q))/sum((q - x)**2)
            c(1) = sum(z(q))/size(q) - c(2)*x
            z(q) = z(q) - c(1) - c(2)*q
            n(1) = n(1) + size(q)
            mean = mean + sum(z(q))
            m(1) = m(1) + sum(z(q)**2)
         end associate
         do i = 1, length - 1
            if (max(z(i), z(i + 1)) >= none) cycle
            n(2) = n(2) + 1.0_wp
            m(2) = m(2) + ((z(i + 1) - z(i))/step)**2
         end do
         do i = 2, length - 1
            if (max(z(i - 1), z(i), z(i + 1)) >= none) cycle
            n(3) = n(3) + 1.0_wp
            m(3) = m(3) + ((z(i + 1) + z(i - 1) - 2.0_wp*z(i))/step**2)**2
         end do
      end do
      m = m/n
      m(1) = m(1) - (mean/n(1))**2
      call analyse_profiles(set, 16, analysis)
      associate (v => analysis%values(:, 1))
         call assertEqual(m, v([p_m0, p_m2, p_m4]), 1.0e-11_wp*m(3))
         call assertEqual(m(1), v(p_m0), 1.0e-12_wp*m(1))
         call assertEqual(m(2), v(p_m2), 1.0e-12_wp*m(2))
      end associate
      call assertEqual([200, 300], set%profiles(:2)%points)
      call assertEqual([7, 10], set%profiles(:2)%missing)
   end subroutine test_definition

   !> What a polynomial adds comes out again, and what is left is orthogonal to it; filled holes are
   !> on a straight line between their ends.
   subroutine test_preparation()
      type(height_map) :: bent, map
      type(error_type), allocatable :: error
      real(wp) :: left(200)
      integer :: i

      call flat_map(map, 200, 1, 0.1_wp, 0.1_wp)
      map%heights(:, 1) = [(sin(0.9_wp*i) + cos(0.01_wp*i*i), i=1, 200)]
      bent = map
      bent%heights(:, 1) = bent%heights(:, 1) + [(1.0e-5_wp*(real(i, wp) - 40.0_wp)**3, i=1, 200)]
      call prepare_surface(map, preparation_settings(form=3), error)
      call prepare_surface(bent, preparation_settings(form=3), error)
      call assertTrue(.not. allocated(error), 'form')
      call assertLessThan(maxval(abs(bent%heights - map%heights)), 1.0e-12_wp)
      call assertLessThan(abs(sum(map%heights(:, 1)*[(real(i, wp)**3, i=1, 200)])), 1.0e-4_wp)

      call flat_map(map, 200, 1, 0.1_wp, 0.1_wp)
      map%heights(:, 1) = [(merge(1.0_wp, 0.0_wp, mod(i, 40) < 20), i=1, 200)]
      map%heights(56:65, 1) = none
      call prepare_surface(map, preparation_settings(fills=.true., most_missing=0.06_wp), error)
      call assertTrue(.not. allocated(error), 'fill')
      left = map%heights(:, 1)
      ! from 1 at 55 to 0 at 66, of which levelling takes a line away
      call assertLessThan(maxval(abs(left(56:65) - left(55) - (left(66) - left(55)) &
         *[(real(i, wp)/11.0_wp, i=1, 10)])), 2.0e-3_wp)
   end subroutine test_preparation

   !> Second differences do not see the mean plane, nor the mean lines: m4 is that of the map to
   !> rounding. First ones see their slopes.
   subroutine test_lines()
      type(surface_settings) :: s
      type(height_map) :: map, level
      type(error_type), allocatable :: error
      type(surface_analysis_type) :: of_map, of_lines
      type(profile_set) :: set
      integer :: k

      s%points_x = 300
      s%points_y = 200
      call generate_surface(s, map, error)
      level = map
      call prepare_surface(level, plain, error)
      call analyse_surface(level, analysis_settings(), of_map, error)
      call add(set, map, 1, plain)
      call analyse_profiles(set, 16, of_lines)
      do k = 1, 3
         call assertEqual(of_map%values(p_m4_x, k), of_lines%values(p_m4, k), &
            merge(1.0e-11_wp, 0.1_wp, k == 1)*of_map%values(p_m4_x, k))
      end do
      call assertEqual(of_map%values(p_m2_x, 1), of_lines%values(p_m2, 1), &
         0.02_wp*of_map%values(p_m2_x, 1))
      call assertEqual(200, set%n)
      call assertEqual(16, groups_of(set, 1, 16))
      call assertEqual(of_map%uncertainty(p_m4_x), of_lines%uncertainty(p_m4), &
         1.0_wp*of_map%uncertainty(p_m4_x))
   end subroutine test_lines

   !> 200 sets of 6 profiles, far apart on surfaces of correlation exp(-(x/l)^2), whose moments by
   !> differences are 2 (1 - r(h))/h^2 and (6 - 8 r(h) + 2 r(2h))/h^4 times Sq^2. Of m0 the mean
   !> line takes sum P_ij r_ij/n, P its projection, 5 %. eta, R and sigma of all sets together are
   !> those of Nayak of these moments; 95 % of sets are within their stated uncertainty (190 with a
   !> standard deviation of 3), as are those of a single profile, whose 16 parts of 4 correlation
   !> lengths are correlated a little.
   subroutine test_isotropic()
      integer, parameter :: n = 200, each = 6
      real(wp), parameter :: step = 0.01_wp, length = 0.05_wp, sq = 0.02_wp
      integer, parameter :: shown(6) = [p_m0, p_m2, p_m4, p_eta_nayak, p_radius_nayak, &
         p_sigma_nayak]
      type(surface_settings) :: s
      type(height_map) :: map, line
      type(error_type), allocatable :: error
      type(surface_analysis_type) :: analysis
      type(profile_set) :: none_yet, set, single
      real(wp) :: values(n_parameters, n), widths(n_parameters, n), of_one(n_parameters, n), &
         one_width(n_parameters, n), truth(6), mean, worst
      integer :: covered, i, j, k, least

      truth(1) = sq**2
      do j = 1, 320
         do i = 1, 320
            truth(1) = truth(1) - sq**2*r(i - j)/320.0_wp*(1.0_wp/320.0_wp &
               + (i - 160.5_wp)*(j - 160.5_wp)*12.0_wp/(320.0_wp*(320.0_wp**2 - 1.0_wp)))
         end do
      end do
      truth(2) = 2.0_wp*sq**2*(1.0_wp - r(1))/step**2
      truth(3) = sq**2*(6.0_wp - 8.0_wp*r(1) + 2.0_wp*r(2))/step**4
      truth(4) = truth(3)/truth(2)/(6.0_wp*pi*sqrt(3.0_wp))
      truth(5) = 0.375_wp*sqrt(pi/truth(3))
      truth(6) = sqrt(truth(1) - 0.896806_wp*truth(2)**2/truth(3))
      s%points_x = 320
      s%points_y = 20*each
      s%step = step
      s%sq = sq
      s%correlation_length_x = length
      s%correlation_length_y = length
      do i = 1, n
         s%seed = 5000 + i
         call generate_surface(s, map, error)
         set = none_yet
         do j = 1, each
            call flat_map(line, 320, 1, step, step)
            line%heights(:, 1) = map%heights(:, 20*j)
            call add(set, line, 1, plain)
         end do
         call analyse_profiles(set, 16, analysis)
         values(:, i) = analysis%values(:, 1)
         widths(:, i) = analysis%uncertainty
         single = none_yet
         call add(single, line, 1, plain)
         call analyse_profiles(single, 16, analysis)
         of_one(:, i) = analysis%values(:, 1)
         one_width(:, i) = analysis%uncertainty
      end do
      worst = 0.0_wp
      least = n
      do k = 1, size(shown)
         mean = sum(values(shown(k), :))/n
         call worsen(worst, [abs(mean/truth(k) - 1.0_wp)])
         covered = count(abs(values(shown(k), :) - mean) <= widths(shown(k), :))
         least = min(least, covered)
         mean = sum(of_one(shown(k), :))/n
         covered = count(abs(of_one(shown(k), :) - mean) <= one_width(shown(k), :))
         call assertGreaterThan(real(covered, wp), 169.5_wp, &
            'one: '//parameters(shown(k))%name)
      end do
      call record('surface.profiles.isotropic.difference', worst)
      call record('surface.profiles.coverage.least', real(least, wp)/n)
      call assertLessThan(worst, 0.01_wp)
      call assertGreaterThan(real(least, wp), 181.5_wp)

   contains

      !> Correlation at so many steps
      pure real(wp) function r(steps)
         integer, intent(in) :: steps

         r = exp(-(steps*step/length)**2)
      end function r

   end subroutine test_isotropic

   !> Profiles along x and along y of a surface whose lay is along y: the geometric means, as the
   !> map itself has them.
   subroutine test_lay()
      type(surface_settings) :: s
      type(height_map) :: map, turned
      type(error_type), allocatable :: error
      type(surface_analysis_type) :: of_map, both, other
      type(profile_set) :: set, swapped

      s%points_x = 400
      s%points_y = 400
      s%step = 0.01_wp
      s%correlation_length_x = 0.06_wp
      s%correlation_length_y = 0.2_wp
      call generate_surface(s, map, error)
      turned = map
      turned%heights = transpose(map%heights)
      call add(set, map, 1, plain)
      call add(set, turned, 2, plain)
      call analyse_profiles(set, 16, both)
      call prepare_surface(map, plain, error)
      call analyse_surface(map, analysis_settings(), of_map, error)
      associate (v => both%values(:, 1), m => of_map%values(:, 1))
         call assertEqual(sqrt(v(p_m2_x)*v(p_m2_y)), v(p_m2), 1.0e-14_wp*v(p_m2))
         call assertEqual(sqrt(v(p_m4_x)*v(p_m4_y)), v(p_m4), 1.0e-14_wp*v(p_m4))
         call assertEqual(m(p_m4_x), v(p_m4_x), 1.0e-10_wp*m(p_m4_x))
         call assertEqual(m(p_m4_y), v(p_m4_y), 1.0e-10_wp*m(p_m4_y))
         call assertEqual(m(p_m2), v(p_m2), 0.05_wp*m(p_m2))
         call assertEqual(m(p_m4), v(p_m4), 0.05_wp*m(p_m4))
         call assertEqual(m(p_sdq), v(p_sdq), 0.02_wp*m(p_sdq))
         call assertEqual(v(p_m2_x), v(p_m2_across), 0.0_wp)
         call assertEqual(0.0_wp, v(p_direction), 0.0_wp)
         call assertEqual(m(p_eta_nayak), v(p_eta_nayak), 0.05_wp*m(p_eta_nayak))
         call assertEqual(m(p_radius_nayak), v(p_radius_nayak), 0.05_wp*m(p_radius_nayak))
         ! m0 is that of the steeper ones
         call assertEqual(m(p_m0), v(p_m0), 0.1_wp*m(p_m0))
      end associate
      ! the other way round only x and y change
      call add(swapped, turned, 1, plain)
      call prepare_surface(turned, plain, error)
      turned%heights = transpose(turned%heights)
      call add(swapped, turned, 2, plain)
      call analyse_profiles(swapped, 16, other)
      call assertEqual(90.0_wp, other%values(p_direction, 1), 0.0_wp)
      call assertEqual(both%values(p_m0, 1), other%values(p_m0, 1), 1.0e-10_wp)
      call assertEqual(both%values(p_m4, 1), other%values(p_m4, 1), 1.0e-8_wp*both%values(p_m4, 1))
   end subroutine test_lay

   !> Profiles of waves of amplitudes a, along x, and of one amplitude b, along y: m2_x = c a^2 for
   !> each, so that its mean, and the half width by Student's t, are those of three numbers. m2 is
   !> their geometric mean with a value that does not scatter.
   subroutine test_two_uncertainties()
      real(wp), parameter :: a(3) = [1.0_wp, 1.01_wp, 0.99_wp]
      type(profile_set) :: set
      type(surface_analysis_type) :: analysis
      real(wp) :: m2(3), half
      integer :: k

      do k = 1, 3
         call add(set, wave_of(a(k)), 1, plain)
         m2(k) = set%profiles(k)%sums(1)%slope/set%profiles(k)%sums(1)%pairs
      end do
      do k = 1, 3
         call add(set, wave_of(0.5_wp), 2, plain)
      end do
      call analyse_profiles(set, 16, analysis)
      half = student_factor(0.95_wp, 2)*sqrt(sum((m2 - sum(m2)/3.0_wp)**2)/6.0_wp)
      call assertEqual(4.3027_wp, student_factor(0.95_wp, 2), 1.0e-4_wp)
      associate (v => analysis%values(:, 1), u => analysis%uncertainty)
         call assertEqual(half, u(p_m2_x), 1.0e-9_wp*half)
         call assertEqual(half/m2(1)*0.5_wp*v(p_m2), u(p_m2), 2.0e-3_wp*u(p_m2))
         call assertLessThan(u(p_m2_y), 1.0e-9_wp*half)
         call assertTrue(u(p_direction) >= none, 'none of the direction')
      end associate
      ! one group alone has no scatter
      call analyse_profiles(set, 1, analysis)
      call assertTrue(all(analysis%uncertainty >= none), 'none without groups')

   contains

      function wave_of(a) result(map)
         real(wp), intent(in) :: a
         type(height_map) :: map
         integer :: i

         call flat_map(map, 500, 1, 0.01_wp, 0.01_wp)
         map%heights(:, 1) = [(a*cos(0.2_wp*i), i=1, 500)]
      end function wave_of

   end subroutine test_two_uncertainties

   subroutine test_refused()
      type(profile_set) :: set
      type(height_map) :: map
      integer :: i

      call flat_map(map, 100, 1, 0.01_wp, 0.01_wp)
      call refused(map, 'has no roughness')
      map%heights(:, 1) = [(0.5_wp + 0.1_wp*i, i=1, 100)]
      call refused(map, 'has no roughness')
      map%heights(:, 1) = [(sin(0.5_wp*i), i=1, 100)]
      call add(set, map, 1, plain)
      map%step_x = 0.02_wp
      call refused(map, 'test map: its step, 0.02 mm, is not that of test map, 0.01 mm')
      ! the other direction has a step of its own
      call add(set, map, 2, plain)
      map%step_x = 0.01_wp
      map%heights(11:20, 1) = none
      call refused(map, '10 of 100 points are missing')
      map%heights = none
      call refused(map, 'every point is missing')

   contains

      subroutine refused(map, part)
         type(height_map), intent(in) :: map
         character(len=*), intent(in) :: part
         type(error_type), allocatable :: error

         call add_profiles(set, map, 1, 1, plain, error)
         call assertTrue(allocated(error), 'must be refused: '//part)
         if (allocated(error)) call assertTrue(index(error%message, part) > 0, error%message)
      end subroutine refused

   end subroutine test_refused

   !> At each limit there is no remark, at the next number there is one.
   subroutine test_remarks()
      real(wp), parameter :: wave = 2.0_wp*pi
      type(profile_facts) :: facts
      real(wp) :: values(n_parameters)

      values = none
      facts%number = [4, 0]
      facts%groups = [4, 1]
      facts%step = 1.0_wp
      facts%length = wave
      call expect('isotropy')
      facts%number = [4, 3]
      call expect('isotropy')
      facts%number = [1, 0]
      call expect('isotropy single')
      facts%number = [4, 0]
      ! a typical wave, and six steps to the shortest one
      values([p_m0, p_m2]) = 1.0_wp
      call expect('isotropy')
      facts%length = wave*(1.0_wp - 1.0e-15_wp)
      call expect('isotropy few_waves')
      facts%length = 4.0_wp*wave
      facts%number = [1, 0]
      call expect('isotropy single')
      facts%groups = [5, 1]
      call expect('isotropy single few_waves')
      facts%number = [4, 0]
      facts%groups = [4, 1]
      facts%spacing = 1.01_wp*wave
      call expect('isotropy')
      facts%spacing = 0.99_wp*wave
      call expect('isotropy few_waves')
      facts%spacing = 0.0_wp
      values(p_m4) = (wave/6.0_wp)**2*0.999_wp
      call expect('isotropy')
      values(p_m4) = (wave/6.0_wp)**2*1.001_wp
      call expect('isotropy resolution')
      values = none
      ! the stylus' radius is told: as sharp as summits, a tenth of theirs
      values(p_radius_nayak) = 0.02_wp
      facts%stylus = 0.02_wp
      call expect('isotropy stylus', 'sharper than the stylus')
      facts%stylus = 0.005_wp
      call expect('isotropy stylus', '0.015 mm')
      facts%stylus = 0.002_wp
      call expect('isotropy stylus', 'less than a tenth')

   contains

      subroutine expect(codes, words)
         character(len=*), intent(in) :: codes
         character(len=*), intent(in), optional :: words
         type(remark_type), allocatable :: remarks(:)
         real(wp) :: nothing(n_parameters)
         character(len=:), allocatable :: found
         integer :: i

         nothing = none
         allocate (remarks(0))
         call find_profile_remarks(values, nothing, nothing, facts, remarks)
         found = ''
         do i = 1, size(remarks)
            found = found//' '//trim(remarks(i)%code)
         end do
         call assertEqual(codes, found(2:))
         if (present(words)) call assertTrue(index(remarks(size(remarks))%text, words) > 0, &
            remarks(size(remarks))%text)
      end subroutine expect

   end subroutine test_remarks

end module test_surface_profiles
