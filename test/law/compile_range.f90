!> The law compiled for a range of separations alone, and when that pays.
module test_law_compile_range
   use asperity, only: compiled_law, error_type, evaluate_compiled_law, evaluate_normal_law, &
      new_compiled_law, normal_properties, normal_response, wp
   use asperity_law_compile_law, only: compiling_pays
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_properties, random_stream
   implicit none
   private
   public :: suite_compile_range

contains

   function suite_compile_range() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compile range')
      call suite%addTest(TestMethod('inside compiled, elsewhere direct', test_range))
      call suite%addTest(TestMethod('what compiling a range takes', test_what_pays))
   end function suite_compile_range

   !> Pressure, stiffness, area fraction, contact density and energy.
   subroutine evaluate(law, separation, values, validity)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp), intent(out) :: values(5)
      integer, intent(out) :: validity

      call evaluate_compiled_law(law, separation, values(1), values(2), values(3), values(4), &
         values(5), validity)
   end subroutine evaluate

   !> In the range what the whole compiled law gives, but for the rounding of the first interval's
   !> end, of eps h^2 at most: 3e-13. Outside either that, in the same intervals, or the bits of the
   !> direct law. Flags always.
   subroutine test_range()
      integer, parameter :: seed = 16180339, n_sets = 100, n_points = 200
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_law) :: whole, part
      type(error_type), allocatable :: error
      type(normal_response) :: r
      real(wp) :: lowest, width, h, found(5), expected(5), direct(5), worst
      integer :: i, j, flags, expected_flags, n_direct, flags_seen

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      n_direct = 0
      flags_seen = 0
      do i = 1, n_sets
         call random_properties(stream, p, 1.0e-4_wp, 1.0e2_wp, 0.05_wp)
         lowest = stream%uniform(-9.0_wp, 37.0_wp)
         if (mod(i, 2) == 0) lowest = stream%uniform(-9.0_wp, 4.0_wp)
         width = stream%log_uniform(1.0e-3_wp, 10.0_wp)
         if (mod(i, 10) == 0) width = 0.0_wp
         call new_compiled_law(whole, p, error)
         call new_compiled_law(part, p, error, [lowest, lowest + width]*p%sigma)
         call assertFalse(allocated(error), 'built')
         do j = 1, n_points
            h = lowest + (width + 0.1_wp)*stream%uniform(-0.5_wp, 1.5_wp)
            call evaluate(part, h*p%sigma, found, flags)
            call evaluate(whole, h*p%sigma, expected, expected_flags)
            r = evaluate_normal_law(p, h*p%sigma)
            direct = [r%pressure, r%stiffness, r%area_fraction, r%contact_density, r%energy]
            if ((h < lowest .or. h > lowest + width) &
                  .and. largest_of(found - direct) <= 0.0_wp) then
               n_direct = n_direct + 1
               expected_flags = r%validity
            else if (h < 37.0_wp) then
               call worsen(worst, largest_of(found/expected - 1.0_wp))
            end if
            call assertEqual(expected_flags, flags, 'flags')
            flags_seen = ior(flags_seen, flags)
         end do
      end do
      call record('compile_range.difference', worst)
      call assertLessThan(worst, 3.0e-13_wp, 'difference')
      call assertTrue(n_direct > 2000, 'outside')
      call assertEqual(7, iand(flags_seen, 7), 'each limit was passed')
   end subroutine test_range

   !> Six points an interval, and at least one interval: of 0.2 below h = 2, of 1/21 above. No point
   !> has no range: it is empty.
   subroutine test_what_pays()
      type(normal_properties) :: p
      real(wp) :: sigma

      p = normal_of_pair('transverse-tangential')
      sigma = p%sigma
      call assertFalse(compiling_pays(0, p, [8.0_wp, -8.0_wp]*sigma), 'no point')
      call assertFalse(compiling_pays(6, p, [2.01_wp, 2.01_wp]*sigma), 'six points, one interval')
      call assertTrue(compiling_pays(7, p, [2.01_wp, 2.01_wp]*sigma), 'seven')
      call assertFalse(compiling_pays(6*68, p, [1.01_wp, 4.99_wp]*sigma), '1 to 5 sigma')
      call assertTrue(compiling_pays(6*68 + 1, p, [1.01_wp, 4.99_wp]*sigma), 'one more')
      call assertTrue(compiling_pays(7, p, [100.0_wp, 200.0_wp]*sigma), 'the last interval')
      call assertTrue(compiling_pays(7, p, [-1.0e10_wp, -9.0_wp]*sigma), 'the first')
   end subroutine test_what_pays

end module test_law_compile_range
