!> The contact-point update with memory and the compiled law against the direct one.
module test_contact_compiled_memory
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, no_rotation, &
      unloading_elastic, update_contact_point, wp
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use points_cases, only: random_pair, random_slip
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_compiled_memory

   integer(int64), parameter :: seed = 33166247_int64

contains

   function suite_compiled_memory() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compiled memory')
      call suite%addTest(TestMethod('as the direct law to 1e-9', test_direct))
   end function suite_compiled_memory

   !> Random paths with partings small and large. Both updates start from the state that the
   !> compiled one left. The plastic dissipation of an increment is a difference: its error is that
   !> of what was dissipated since first touch.
   subroutine test_direct()
      type(random_stream) :: stream
      type(contact_properties) :: direct, compiled
      type(contact_state) :: start
      type(contact_response) :: c, d
      real(wp) :: overclosure, slip(2), total, worst(4)
      integer :: i, set, unloaded, flattened

      stream = random_stream(seed)
      worst = 0.0_wp
      unloaded = 0
      flattened = 0
      do set = 1, 20
         call random_pair(stream, set, direct, compiled, unloading_elastic)
         call assertTrue(allocated(compiled%compiled_unloading), 'compiled')
         start = contact_state()
         total = 0.0_wp
         do i = 1, 60
            overclosure = direct%initial_separation &
               - direct%normal%sigma*stream%uniform(-0.5_wp, 5.0_wp)
            if (mod(i, 3) > 0 .and. i > 1) overclosure = start%largest_closure &
               - direct%normal%sigma*stream%log_uniform(1.0e-6_wp, 1.0_wp)
            slip = random_slip(stream, direct, 0.5_wp)
            call update_contact_point(direct, start, overclosure, slip, no_rotation, d)
            call update_contact_point(compiled, start, overclosure, slip, no_rotation, c)
            call assertEqual(d%validity, c%validity, 'validity')
            call assertGreaterThanOrEqual(c%plastic_dissipation, 0.0_wp, 'plastic dissipation')
            total = total + d%plastic_dissipation
            if (d%traction(1) > 1.0e-12_wp*direct%p_open) then
               call worsen(worst(1), abs(c%traction(1)/d%traction(1) - 1.0_wp))
               call worsen(worst(2), abs(c%tangent(1, 1)/d%tangent(1, 1) - 1.0_wp))
               call worsen(worst(3), abs(c%normal_energy/d%normal_energy - 1.0_wp))
            end if
            if (d%plastic_dissipation > 0.0_wp) then
               call worsen(worst(4), abs(c%plastic_dissipation - d%plastic_dissipation)/total)
               flattened = flattened + 1
            else if (i > 1 .and. d%traction(1) > 0.0_wp) then
               unloaded = unloaded + 1
            end if
            start = c%state
            if (anyExceptions()) return
         end do
      end do
      write (*, '(5x, a, i0)') 'seed ', seed
      call record('compiled_memory.pressure', worst(1))
      call record('compiled_memory.stiffness', worst(2))
      call record('compiled_memory.energy', worst(3))
      call record('compiled_memory.plastic_dissipation', worst(4))
      call assertGreaterThan(unloaded, 500, message='increments that unload')
      call assertGreaterThan(flattened, 50, message='increments that flatten')
      call assertLessThan(maxval(worst), 1.0e-9_wp, 'relative error')
   end subroutine test_direct

end module test_contact_compiled_memory
