!> Limits of the compiled law with memory: flags, what lies outside, threads, size, what is refused.
module test_law_compiled_unloading_limits
   use, intrinsic :: ieee_arithmetic, only: ieee_get_halting_mode, ieee_invalid, ieee_is_nan, &
      ieee_quiet_nan, ieee_set_halting_mode, ieee_value
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: vanishing_height
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_plastic_dissipation, &
      compiled_unloading_law, size_in_bytes
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      memory_beyond_data, pressure_above_hardness
   use compiled_unloading_cases, only: compile, compiled_at, direct_at
   use extremes, only: largest_of
   use funit, only: assertEqual, assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, properties_with, random_stream
   use threads, only: check_two_threads
   implicit none
   private
   public :: suite_compiled_unloading_limits

   !> Shared by the two threads, which only read it
   type(compiled_unloading_law) :: shared_law

contains

   function suite_compiled_unloading_limits() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compiled unloading limits')
      call suite%addTest(TestMethod('limits are flagged where the direct law does', test_validity))
      call suite%addTest(TestMethod('outside, not a number', test_outside))
      call suite%addTest(TestMethod('two threads give the serial bits', test_threads))
      call suite%addTest(TestMethod('size, and what is refused', test_construction))
   end function suite_compiled_unloading_limits

   !> The pair of wood, from far beyond all limits to where none is passed, on both branches.
   subroutine test_validity()
      integer, parameter :: seed = 1414
      type(random_stream) :: stream
      type(compiled_unloading_law) :: law
      real(wp) :: h, u, values(3)
      integer :: i, validity, expected, seen, differ

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      call compile(law, normal_of_pair('transverse-tangential'))
      seen = 0
      differ = 0
      do i = 1, 4000
         h = stream%uniform(-8.0_wp, 3.0_wp)
         u = stream%uniform(-0.5_wp, 1.5_wp)
         if (mod(i, 10) == 0) u = -stream%uniform(0.0_wp, 3.0_wp)
         values = compiled_at(law, h, u, validity)
         values = direct_at(law, h, u, expected)
         if (validity /= expected) differ = differ + 1
         seen = ior(seen, validity)
      end do
      call assertEqual(0, differ, 'points where flags differ')
      call assertEqual(area_above_nominal + pressure_above_hardness + closure_above_half_radius &
         + memory_beyond_data, seen, 'limits that were passed')
      ! a face too stiff to pass the limit of memory even where the cells begin
      call compile(law, properties_with(1.0_wp, 0.4_wp))
      values = compiled_at(law, -8.0_wp, 0.1_wp, validity)
      values = direct_at(law, -8.0_wp, 0.1_wp, expected)
      call assertEqual(expected, validity, 'flags where the cells begin')
   end subroutine test_validity

   !> Outside the cells the direct law's numbers; far out, and on the virgin branch far out, zero;
   !> for what is no number the same.
   subroutine test_outside()
      type(compiled_unloading_law) :: law
      real(wp) :: bad
      logical :: halts

      call compile(law, normal_of_pair('transverse-tangential'))
      call assertLessThan(largest_of(compiled_at(law, -9.0_wp, 0.3_wp)/direct_at(law, -9.0_wp, &
         0.3_wp) - 1.0_wp), 1.0e-15_wp, 'far in')
      call assertLessThan(largest_of(compiled_at(law, 8.5_wp, 0.2_wp)/direct_at(law, 8.5_wp, &
         0.2_wp) - 1.0_wp), 1.0e-15_wp, 'far out')
      call assertLessThan(largest_of(compiled_at(law, 2.0_wp, 1.4_wp)/direct_at(law, 2.0_wp, &
         1.4_wp) - 1.0_wp), 1.0e-15_wp, 'parted far')
      call assertLessThan(largest_of(compiled_at(law, 37.0_wp, 0.0_wp)/direct_at(law, 37.0_wp, &
         0.0_wp) - 1.0_wp), 1.0e-9_wp, 'virgin, far out')
      call assertEqual(0.0_wp, largest_of(compiled_at(law, 2.0_wp, 50.0_wp)), 0.0_wp, 'parted')
      call assertEqual(0.0_wp, largest_of(compiled_at(law, vanishing_height + 1.0_wp, &
         -0.5_wp)), 0.0_wp, 'never touched')
      call assertEqual(0.0_wp, compiled_plastic_dissipation(law, 1.0e10_wp), 0.0_wp, 'no loss')
      ! a comparison with what is not a number would end a build that traps invalid operations
      call ieee_get_halting_mode(ieee_invalid, halts)
      call ieee_set_halting_mode(ieee_invalid, .false.)
      bad = ieee_value(bad, ieee_quiet_nan)
      call assertTrue(all(ieee_is_nan(compiled_at(law, bad, 0.1_wp))), 'closest separation')
      call assertTrue(all(ieee_is_nan(compiled_at(law, 1.0_wp, bad))), 'retraction')
      call ieee_set_halting_mode(ieee_invalid, halts)
   end subroutine test_outside

   subroutine test_threads()
      call compile(shared_law, normal_of_pair('tangential-tangential'))
      call check_two_threads(thread_work, 4)
   end subroutine test_threads

   !> Sums over random points of both branches.
   subroutine thread_work(number, sums)
      integer, intent(in) :: number
      real(wp), intent(out) :: sums(:)
      type(random_stream) :: stream
      real(wp) :: h
      integer :: i

      stream = random_stream(900 + number)
      sums = 0.0_wp
      do i = 1, 20000
         h = stream%uniform(-2.0_wp, 6.0_wp)
         sums(:3) = sums(:3) + compiled_at(shared_law, h, stream%uniform(-0.3_wp, 0.9_wp))
         sums(4) = sums(4) + compiled_plastic_dissipation(shared_law, &
            h*shared_law%virgin%properties%sigma)
      end do
   end subroutine thread_work

   !> Below 400 kB for all properties; the reversible law and properties never built are refused.
   subroutine test_construction()
      real(wp), parameter :: ratios(5) = [1.0e-6_wp, 1.0e-4_wp, 1.5e-2_wp, 1.0_wp, 1.0e2_wp]
      type(compiled_unloading_law) :: law
      type(normal_properties) :: never_built
      type(error_type), allocatable :: error
      integer :: i, largest

      largest = 0
      do i = 1, size(ratios)
         call compile(law, properties_with(ratios(i), 0.4_wp))
         largest = max(largest, size_in_bytes(law))
      end do
      call record('compiled_unloading.bytes', real(largest, wp))
      call assertTrue(largest < 400000, 'bytes')
      call new_compiled_unloading_law(law, normal_of_pair('transverse-tangential'), error)
      call assertTrue(allocated(error), 'reversible')
      call assertTrue(index(error%message, 'new_compiled_law') > 0, error%message)
      call new_compiled_unloading_law(law, never_built, error)
      call assertTrue(allocated(error), 'never built')
      call assertTrue(index(error%message, 'new_normal_properties') > 0, error%message)
   end subroutine test_construction

end module test_law_compiled_unloading_limits
