!> Plastic ratios w2/w1 other than 110: the law without memory and with it against 25-digit values,
!> compiled laws against the direct ones, continuity of one summit, and what is refused.
module test_law_plastic_ratio
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: default_plastic_ratio, new_normal_properties, &
      normal_properties, unloading_elastic, unloading_reversible
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_unloading_law, &
      evaluate_compiled_unloading_law
   use asperity_law_unloading_law, only: evaluate_unloading_law, unloading_stiffness
   use asperity_law_unloading_summit, only: elastic_recovery
   use asperity_law_validity, only: stiffer_than_hertz
   use asperity_paper_pairs, only: find_pair, pair_preset
   use extremes, only: worsen
   use funit, only: assertEqual, assertFail, assertLessThan, assertLessThanOrEqual, &
      assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use reference_table, only: open_table
   implicit none
   private
   public :: suite_plastic_ratio

   real(wp), parameter :: ratios(4) = [10.0_wp, 54.0_wp, 200.0_wp, 1000.0_wp]

contains

   function suite_plastic_ratio() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('plastic ratio')
      call suite%addTest(TestMethod('25-digit values', test_table))
      call suite%addTest(TestMethod('one summit is continuous', test_summit))
      call suite%addTest(TestMethod('compiled', test_compiled))
      call suite%addTest(TestMethod('compiled with memory', test_compiled_unloading))
      call suite%addTest(TestMethod('the pressure of other ratios', test_pressures))
      call suite%addTest(TestMethod('what is refused', test_refused))
   end function suite_plastic_ratio

   !> test/data/plastic_ratio_reference.csv, by test/reference/plastic_ratio_reference.py; a
   !> negative retraction stands for the law without memory.
   subroutine test_table()
      character(len=*), parameter :: header = 'plastic_ratio,sigma,eta,modulus,radius,hardness,'// &
         'yield_factor,closest_separation,retraction,pressure,stiffness,area_fraction,'// &
         'contact_density,energy,plastic_dissipation,elastic_share,elastoplastic_share,'// &
         'plastic_share'
      character(len=19), parameter :: columns(9) = [character(len=19) :: 'pressure', &
         'stiffness', 'area_fraction', 'contact_density', 'energy', 'plastic_dissipation', &
         'elastic_share', 'elastoplastic_share', 'plastic_share']
      character(len=1024) :: line
      character(len=12) :: label
      type(normal_properties) :: p
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: v(18), found(9), relative, worst(9, 2)
      integer :: unit, status, rows, kind, j

      call open_table('plastic_ratio_reference.csv', header, unit)
      worst = 0.0_wp
      rows = 0
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         read (line, *) v
         rows = rows + 1
         write (label, '(a, i0)') 'row ', rows
         kind = merge(1, 2, v(9) < 0.0_wp)
         call new_normal_properties(p, v(3), v(4), v(5), v(6), v(7), v(2), error, .true., &
            merge(unloading_reversible, unloading_elastic, kind == 1), v(1))
         if (allocated(error)) call assertFail(error%message)
         if (kind == 1) then
            r = evaluate_normal_law(p, v(8))
         else
            r = evaluate_unloading_law(p, v(8), v(9))
            if (.not. v(9) > 0.0_wp) r%stiffness = unloading_stiffness(p, v(8))
         end if
         found = [r%pressure, r%stiffness, r%area_fraction, r%contact_density, r%energy, &
            r%plastic_dissipation, r%elastic_share, r%elastoplastic_share, r%plastic_share]
         do j = 1, 9
            if (v(9 + j) >= tiny(1.0_wp)) then
               relative = abs(found(j)/v(9 + j) - 1.0_wp)
               call worsen(worst(j, kind), relative)
               call assertLessThan(relative, &
                  merge(1.0e-11_wp, 1.0e-12_wp, kind == 2 .and. j > 5), &
                  trim(label)//' '//columns(j))
            else
               call assertLessThanOrEqual(found(j), tiny(1.0_wp), trim(label)//' '//columns(j))
            end if
         end do
      end do
      close (unit)
      call assertEqual(192, rows, 'rows')
      call record('plastic_ratio.law.relative_error', maxval(worst(:5, 1)))
      call record('plastic_ratio.shares.relative_error', maxval(worst(7:, 1)))
      call record('plastic_ratio.unloading.relative_error', maxval(worst(:5, 2)))
      call record('plastic_ratio.unloading.dissipation_and_shares', maxval(worst(6:, 2)))
   end subroutine test_table

   !> Force, area and mean pressure from both sides of w1 and w2, and the recovery at w2.
   subroutine test_summit()
      type(normal_properties) :: p
      type(asperity_response) :: below, above
      real(wp) :: worst
      integer :: i, j

      worst = 0.0_wp
      do i = 1, size(ratios)
         p = paper_pair(ratios(i))
         call assertRelativelyEqual(ratios(i)*p%w1, p%w2, 1.0e-15_wp, 'w2')
         call assertRelativelyEqual(log(5.0_wp)/log(ratios(i)) + 1.0_wp, p%b3, 1.0e-15_wp, 'b3')
         do j = 1, 2
            associate (w => merge(p%w1, p%w2, j == 1))
               below = evaluate_asperity(p, w*(1.0_wp - epsilon(w)))
               above = evaluate_asperity(p, w)
               call worsen(worst, abs([below%force/above%force, below%area/above%area, &
                  below%mean_pressure/above%mean_pressure, below%energy/above%energy, &
                  elastic_recovery(p, w*(1.0_wp - epsilon(w)))/elastic_recovery(p, w)] - 1.0_wp))
            end associate
         end do
      end do
      call record('plastic_ratio.jump', worst)
      call assertLessThan(worst, 2.0e-14_wp, 'jump')
   end subroutine test_summit

   !> Within 1e-10 of the direct evaluation for |d| <= 8 sigma, 1e-9 beyond.
   subroutine test_compiled()
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: d, h, pressure, stiffness, area, energy, worst(2)
      integer :: i, j

      worst = 0.0_wp
      do i = 1, size(ratios)
         p = paper_pair(ratios(i))
         call new_compiled_law(law, p, error)
         if (allocated(error)) call assertFail(error%message)
         do j = 0, 900
            h = -8.0_wp + 0.05_wp*j
            d = h*p%sigma
            r = evaluate_normal_law(p, d)
            call evaluate_compiled_law(law, d, pressure, stiffness, area, energy=energy)
            call worsen(worst(merge(1, 2, h <= 8.0_wp)), abs([pressure/r%pressure, &
               stiffness/r%stiffness, area/r%area_fraction, energy/r%energy] - 1.0_wp))
         end do
      end do
      call record('plastic_ratio.compiled.to_8_sigma', worst(1))
      call record('plastic_ratio.compiled.beyond', worst(2))
      call assertLessThan(worst(1), 1.0e-10_wp, 'to 8 sigma')
      call assertLessThan(worst(2), 1.0e-9_wp, 'beyond')
   end subroutine test_compiled

   !> Within 1e-9 of the values at the closest separation, as at 110.
   subroutine test_compiled_unloading()
      type(normal_properties) :: p
      type(compiled_unloading_law) :: law
      type(normal_response) :: r, closest
      type(error_type), allocatable :: error
      real(wp) :: d, u, pressure, stiffness, energy, worst
      integer :: i, j, k, flags

      worst = 0.0_wp
      do i = 1, size(ratios)
         p = paper_pair(ratios(i), unloading_elastic, max(0.4_wp, 2.001_wp/sqrt(ratios(i))))
         call new_compiled_unloading_law(law, p, error)
         if (allocated(error)) call assertFail(error%message)
         do j = 0, 32
            d = (-3.9_wp + 0.35_wp*j)*p%sigma
            closest = evaluate_unloading_law(p, d, 0.0_wp)
            do k = 1, 12
               u = p%w1*10.0_wp**(-2.0_wp + 0.33_wp*k)
               r = evaluate_unloading_law(p, d, u)
               call evaluate_compiled_unloading_law(law, d, u, pressure, stiffness, energy, flags)
               call worsen(worst, abs([(pressure - r%pressure)/closest%pressure, &
                  (energy - r%energy)/closest%energy]))
            end do
         end do
      end do
      call record('plastic_ratio.compiled_unloading', worst)
      call assertLessThan(worst, 1.0e-9_wp, 'compiled with memory')
   end subroutine test_compiled_unloading

   !> Pressures at 0.2, 0.15 and 0.1 mm over those of 110, transverse on tangential, found before
   !> the ratio was a property by a program with another constant, to three figures.
   subroutine test_pressures()
      real(wp), parameter :: separations(3) = [0.2_wp, 0.15_wp, 0.1_wp]
      real(wp), parameter :: low(3) = [1.21_wp, 1.20_wp, 1.18_wp], &
         high(3) = [0.88_wp, 0.87_wp, 0.87_wp]
      type(normal_response) :: r(3), usual(3)

      usual = evaluate_normal_law(paper_pair(default_plastic_ratio), separations)
      r = evaluate_normal_law(paper_pair(54.0_wp), separations)
      call assertTrue(all(abs(r%pressure/usual%pressure - low) < 0.0051_wp), '54')
      r = evaluate_normal_law(paper_pair(200.0_wp), separations)
      call assertTrue(all(abs(r%pressure/usual%pressure - high) < 0.0051_wp), '200')
   end subroutine test_pressures

   !> Outside 10 to 1000, and with memory below k = 2/sqrt(w2/w1), whose message names a value that
   !> passes.
   subroutine test_refused()
      type(normal_properties) :: p
      type(error_type), allocatable :: error

      call try(p, 9.99_wp, unloading_reversible, error)
      call assertTrue(allocated(error), 'below 10')
      if (allocated(error)) call assertEqual('plastic_ratio = 9.99 is not allowed: it must be '// &
         'a number between 10.0 and 1000.0', error%message)
      call try(p, 1000.1_wp, unloading_reversible, error)
      call assertTrue(allocated(error), 'above 1000')
      call try(p, 10.0_wp, unloading_elastic, error)
      call assertTrue(allocated(error), 'stiffer than Hertz')
      if (allocated(error)) call assertTrue(index(error%message, 'it must be 0.6325 '// &
         '(2/sqrt(plastic_ratio)) or more') > 0, error%message)
      call try(p, 10.0_wp, unloading_reversible, error)
      call assertEqual(stiffer_than_hertz, p%validity, 'flag at 10')
      call try(p, 25.1_wp, unloading_elastic, error)
      call assertTrue(.not. allocated(error), '2/sqrt(25.1) is below 0.4')
      call assertEqual(0, p%validity, 'no flag')
   end subroutine test_refused

   subroutine try(p, ratio, unloading, error, yield_factor)
      type(normal_properties), intent(out) :: p
      real(wp), intent(in) :: ratio
      integer, intent(in) :: unloading
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in), optional :: yield_factor
      type(pair_preset) :: pair

      call find_pair('transverse-tangential', pair, error)
      if (present(yield_factor)) pair%yield_factor = yield_factor
      call new_normal_properties(p, pair, error, unloading=unloading, plastic_ratio=ratio)
   end subroutine try

   function paper_pair(ratio, unloading, yield_factor) result(p)
      real(wp), intent(in) :: ratio
      integer, intent(in), optional :: unloading
      real(wp), intent(in), optional :: yield_factor
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      integer :: how

      how = unloading_reversible
      if (present(unloading)) how = unloading
      call try(p, ratio, how, error, yield_factor)
      if (allocated(error)) error stop 'plastic_ratio: '//error%message
   end function paper_pair

end module test_law_plastic_ratio
