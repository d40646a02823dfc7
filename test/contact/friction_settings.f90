!> What friction beyond one coefficient is refused for: each by its name, value and remedy.
module test_contact_friction_settings
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use asperity, only: contact_properties, error_type, find_pair, friction_settings, &
      new_contact_properties, new_normal_properties, normal_properties, pair_preset, &
      stick_summits, unloading_elastic, unloading_reversible, wp
   use asperity_base_number_text, only: to_text
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_friction_settings

   real(wp), parameter :: mu = 0.5_wp

contains

   function suite_friction_settings() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('friction settings')
      call suite%addTest(TestMethod('rest and motion', test_rest))
      call suite%addTest(TestMethod('grain', test_grain))
      call suite%addTest(TestMethod('pressure and shear limit', test_pressure))
      call suite%addTest(TestMethod('summits', test_summits))
      call suite%addTest(TestMethod('no number, no friction, plain friction', test_rare))
   end function suite_friction_settings

   !> Refused for `subject` with a message that has `text`, or taken where that is empty.
   subroutine check(settings, subject, text, coefficient, unloading)
      type(friction_settings), intent(in) :: settings
      character(len=*), intent(in) :: subject, text
      real(wp), intent(in), optional :: coefficient
      integer, intent(in), optional :: unloading
      type(contact_properties) :: p
      type(normal_properties) :: normal
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      real(wp) :: in_motion

      in_motion = mu
      if (present(coefficient)) in_motion = coefficient
      call find_pair('transverse-tangential', pair, error)
      call new_normal_properties(normal, pair, error, unloading=unloading)
      call new_contact_properties(p, normal, in_motion, 0.31_wp, error, friction=settings)
      if (subject == '') then
         call assertFalse(allocated(error), 'taken: '//text)
         return
      end if
      call assertTrue(allocated(error), 'refused for '//subject)
      if (.not. allocated(error)) return
      call assertEqual(subject, error%subject, 'subject')
      call assertTrue(index(error%message, text) > 0, error%message//' without '//text)
   end subroutine check

   subroutine test_rest()
      call check(friction_settings(static_friction_coefficient=0.49_wp, decay_slip=1.0_wp), &
         'static_friction_coefficient', &
         '= 0.49 is not allowed: it must not be below friction_coefficient = 0.5')
      call check(friction_settings(static_friction_coefficient=0.6_wp), &
         'static_friction_coefficient', 'give decay_slip in mm, decay_slip_rate in mm/s, or both')
      call check(friction_settings(static_friction_coefficient=-0.1_wp), &
         'static_friction_coefficient', 'between 0.0 and 1000.0')
      call check(friction_settings(decay_slip=0.1_wp), 'decay_slip', &
         'decay_slip = 0.1 mm has no meaning without static_friction_coefficient')
      call check(friction_settings(decay_slip_rate=0.1_wp), 'decay_slip_rate', 'give that as well')
      call check(friction_settings(static_friction_coefficient=0.6_wp, decay_slip=-0.1_wp), &
         'decay_slip', '-0.1 mm is not allowed')
      call check(friction_settings(static_friction_coefficient=0.6_wp, decay_slip=0.1_wp, &
         decay_slip_rate=-1.0_wp), 'decay_slip_rate', '-1.0 mm/s is not allowed')
      call check(friction_settings(static_friction_coefficient=mu, decay_slip=0.1_wp, &
         decay_slip_rate=2.0_wp), '', 'the same at rest')
   end subroutine test_rest

   subroutine test_grain()
      call check(friction_settings(friction_coefficient_across=-0.1_wp), &
         'friction_coefficient_across', '-0.1 is not allowed')
      call check(friction_settings(friction_coefficient_across=1.0e-4_wp), &
         'friction_coefficient_across', 'between 0.001 and 1000.0')
      call check(friction_settings(grain_angle=361.0_wp), 'grain_angle', '361.0 degrees')
      call check(friction_settings(slip_direction=2), 'slip_direction', &
         '2 is unknown: 0 is associated, 1 is stress')
      call check(friction_settings(friction_coefficient_across=0.1_wp, grain_angle=-360.0_wp, &
         slip_direction=1), '', 'an ellipse')
   end subroutine test_grain

   subroutine test_pressure()
      type(friction_settings) :: points

      call check(friction_settings(pressure_exponent=-1.0_wp, reference_pressure=1.0_wp), &
         'pressure_exponent', 'use shear_limit')
      call check(friction_settings(pressure_exponent=-1.5_wp), 'pressure_exponent', &
         'between -1.0 and 10.0')
      call check(friction_settings(pressure_exponent=-0.1_wp), 'pressure_exponent', &
         'needs reference_pressure')
      call check(friction_settings(pressure_exponent=-0.1_wp, reference_pressure=-1.0_wp), &
         'reference_pressure', '-1.0 MPa')
      call check(friction_settings(shear_limit=-1.0_wp), 'shear_limit', '-1.0 MPa is not allowed')
      call check(friction_settings(pressure_exponent=-0.1_wp, reference_pressure=1.0_wp, &
         shear_limit=1.0_wp), '', 'a power and a limit')
      points = friction_settings(friction_points=3)
      points%friction_pressures(:3) = [0.0_wp, 1.0_wp, 2.0_wp]
      points%friction_factors(:3) = [1.0_wp, 0.8_wp, 0.7_wp]
      call check(points, '', 'three points')
      points%friction_pressures(3) = 1.0_wp
      call check(points, 'friction_points', &
         'pressure 3 of friction_points = 1.0 MPa is not above the one before')
      points%friction_pressures(3) = 2.0_wp
      points%friction_factors(2) = 0.0_wp
      call check(points, 'friction_points', 'factor 2 of friction_points = 0.0')
      points%friction_factors(2) = 1.0_wp
      points%friction_pressures(1) = -1.0_wp
      call check(points, 'friction_points', 'pressure 1 of friction_points = -1.0 MPa')
      points%friction_pressures(1) = 0.0_wp
      points%pressure_exponent = 0.1_wp
      points%reference_pressure = 1.0_wp
      call check(points, 'friction_points pressure_exponent', 'exclude each other')
      call check(friction_settings(friction_points=9), 'friction_points', 'there are 0 to 8')
      call check(friction_settings(friction_points=-1), 'friction_points', '-1 is not allowed')
   end subroutine test_pressure

   subroutine test_summits()
      call check(friction_settings(stick=2), 'stick', &
         'is unknown: 0 is critical_slip, 1 is summits')
      call check(friction_settings(stick=stick_summits), 'shear_modulus', 'needs shear_modulus')
      call check(friction_settings(stick=stick_summits, shear_modulus=-1.0_wp), 'shear_modulus', &
         'above zero')
      call check(friction_settings(stick=stick_summits, shear_modulus=30.0_wp, stick_elements=3), &
         'stick_elements', '3 is not allowed: it must be 4 to 16')
      call check(friction_settings(stick=stick_summits, shear_modulus=30.0_wp, stick_elements=17), &
         'stick_elements', '4 to 16')
      call check(friction_settings(stick=stick_summits, shear_modulus=30.0_wp, &
         static_friction_coefficient=0.6_wp, decay_slip=0.1_wp), &
         'stick static_friction_coefficient', 'use stick = critical_slip')
      call check(friction_settings(stick=stick_summits, shear_modulus=30.0_wp, &
         friction_coefficient_across=0.6_wp), 'stick friction_coefficient_across', 'leave out')
      call check(friction_settings(stick=stick_summits, shear_modulus=30.0_wp), 'stick', &
         'unloading = reversible', unloading=unloading_elastic)
      call check(friction_settings(stick=stick_summits, shear_modulus=30.0_wp), '', &
         'eight elements', unloading=unloading_reversible)
   end subroutine test_summits

   subroutine test_rare()
      type(friction_settings) :: settings
      type(contact_properties) :: p
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      real(wp) :: no_number

      no_number = ieee_value(1.0_wp, ieee_quiet_nan)
      call check(friction_settings(static_friction_coefficient=no_number), &
         'static_friction_coefficient', to_text(no_number))
      call check(friction_settings(pressure_exponent=no_number), 'pressure_exponent', 'NaN')
      call check(friction_settings(friction_coefficient_across=no_number), &
         'friction_coefficient_across', 'NaN')
      call check(friction_settings(shear_limit=0.1_wp), 'friction_coefficient', &
         'friction_coefficient = 0 is not allowed', coefficient=0.0_wp)
      call check(friction_settings(), '', 'no friction', coefficient=0.0_wp)

      call find_pair('transverse-tangential', pair, error)
      call new_contact_properties(p, pair, error, friction=settings)
      call assertTrue(p%friction_is_plain, 'nothing is plain')
      call new_contact_properties(p, pair, error, friction=friction_settings(grain_angle=30.0_wp, &
         slip_direction=1, reference_pressure=1.0_wp))
      call assertTrue(p%friction_is_plain, 'what has no effect is plain')
      call new_contact_properties(p, pair, error, friction=friction_settings(shear_limit=1.0_wp))
      call assertFalse(p%friction_is_plain, 'a limit is not plain')
   end subroutine test_rare

end module test_contact_friction_settings
