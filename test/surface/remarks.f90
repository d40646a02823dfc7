!> The limits of the remarks on a map: at each there is no remark, at the next number there is one.
module test_surface_remarks
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_law_plausibility, only: roughness_number_min_sq
   use asperity_surface_parameters_parameters, only: n_parameters, p_alpha, p_eta_nayak, &
      p_eta_paper, p_m0, p_m2_across, p_m2_along, p_m2_x, p_m2_y, p_m4_x, p_m4_y, &
      p_radius_paper, p_sdq, p_sigma_paper, p_sp, p_sq, p_sv
   use asperity_surface_remarks_on_analysis, only: find_remarks, map_facts, remark_type
   use funit, only: assertEqual, TestMethod, TestSuite
   implicit none
   private
   public :: suite_surface_remarks

   real(wp), parameter :: up = 1.0_wp, down = -1.0_wp, eps = epsilon(1.0_wp)
   real(wp), parameter :: wave = 2.0_wp*acos(-1.0_wp)

contains

   function suite_surface_remarks() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface remarks')
      call suite%addTest(TestMethod('limits of values', test_values))
      call suite%addTest(TestMethod('limits of the scan', test_scan))
      call suite%addTest(TestMethod('twice the step', test_step))
   end function suite_surface_remarks

   !> One value after the other, of which nothing else is known.
   subroutine test_values()
      call border('alpha', [p_alpha], [1.5_wp], down)
      call border('slope', [p_sdq], [10.0_wp], up)
      call border('slope', [p_sdq], [1.0e-4_wp], down)
      ! the first of two or three is moved
      call border('anisotropic', [p_m2_across, p_m2_along], [2.0_wp, 1.0_wp], up)
      call border('outlier', [p_sp, p_sq], [12.0_wp, 1.0_wp], up)
      call border('outlier', [p_sv, p_sq], [12.0_wp, 1.0_wp], up)
      ! a fifth of the larger one
      call border('routes', [p_eta_nayak, p_eta_paper], [1.0_wp, 1.25_wp], down)
      call border('routes', [p_eta_paper, p_eta_nayak], [1.0_wp, 1.25_wp], down)
      call border('roughness_number', [p_eta_paper, p_radius_paper, p_sigma_paper], &
         [roughness_number_min_sq, 1.0_wp, 1.0_wp], down)
   end subroutine test_values

   !> No remark at the values, and the one of that code when the first is moved to the next number.
   subroutine border(code, places, at, side)
      character(len=*), intent(in) :: code
      integer, intent(in) :: places(:)
      real(wp), intent(in) :: at(:), side
      real(wp) :: values(n_parameters)

      values = none
      values(places) = at
      call expect('', values, map_facts(peaks=100.0_wp))
      values(places(1)) = nearest(at(1), side)
      call expect(code, values, map_facts(peaks=100.0_wp))
   end subroutine border

   !> What is known of the scan besides values.
   subroutine test_scan()
      real(wp) :: values(n_parameters)

      values = none
      call expect('', values, map_facts(peaks=20.0_wp))
      call expect('few_peaks', values, map_facts(peaks=nearest(20.0_wp, down)))
      call expect('few_peaks', values, map_facts(peaks=0.5_wp))
      call expect('no_peaks', values, map_facts(peaks=nearest(0.5_wp, down)))
      call expect('', values, map_facts(peaks=20.0_wp, filled=0.01_wp))
      call expect('filled', values, map_facts(peaks=20.0_wp, filled=nearest(0.01_wp, up)))
      call expect('shape', values, map_facts(peaks=20.0_wp, points=[600, 12]))
      call expect('', values, map_facts(peaks=20.0_wp, points=[599, 12]))
      call expect('', values, map_facts(peaks=20.0_wp, points=[13, 650]))
      ! a tile of one wave along either side
      values([p_m0, p_m2_x, p_m2_y]) = 1.0_wp
      call expect('', values, map_facts(peaks=20.0_wp, tile_x=wave, tile_y=wave))
      call expect('few_waves', values, map_facts(peaks=20.0_wp, tile_x=wave, &
         tile_y=nearest(wave, down)))
      call expect('few_waves', values, map_facts(peaks=20.0_wp, tile_x=nearest(wave, down), &
         tile_y=wave))
      ! six steps a wave, but for rounding
      values([p_m4_x, p_m4_y]) = 1.0_wp
      call expect('', values, map_facts(peaks=20.0_wp, step_x=wave/6.0_wp*(1.0_wp - 2.0_wp*eps), &
         step_y=0.1_wp))
      call expect('resolution', values, map_facts(peaks=20.0_wp, step_x=0.1_wp, &
         step_y=wave/6.0_wp*(1.0_wp + 2.0_wp*eps)))
   end subroutine test_scan

   !> Values at twice the step may differ by the uncertainty; so may routes by both of theirs.
   subroutine test_step()
      real(wp) :: values(n_parameters), widths(n_parameters), coarse(n_parameters)

      values = none
      widths = none
      coarse = none
      values(p_eta_nayak) = 1.0_wp
      widths(p_eta_nayak) = 0.75_wp
      coarse(p_eta_nayak) = 1.75_wp
      call expect('', values, map_facts(peaks=20.0_wp), widths, coarse)
      coarse(p_eta_nayak) = nearest(1.75_wp, up)
      call expect('step', values, map_facts(peaks=20.0_wp), widths, coarse)
      values(p_eta_paper) = 2.25_wp
      widths(p_eta_paper) = 1.0_wp
      call expect('', values, map_facts(peaks=20.0_wp), widths)
      values(p_eta_paper) = nearest(2.25_wp, up)
      call expect('routes', values, map_facts(peaks=20.0_wp), widths)
   end subroutine test_step

   !> The one remark there should be, or none.
   subroutine expect(code, values, facts, widths, coarse)
      character(len=*), intent(in) :: code
      real(wp), intent(in) :: values(:)
      type(map_facts), intent(in) :: facts
      real(wp), intent(in), optional :: widths(:), coarse(:)
      type(remark_type), allocatable :: remarks(:)
      real(wp) :: half_widths(n_parameters)
      character(len=:), allocatable :: found
      integer :: i

      half_widths = none
      if (present(widths)) half_widths = widths
      call find_remarks(values, half_widths, facts, 'paper', remarks, coarse)
      found = ''
      do i = 1, size(remarks)
         found = found//trim(remarks(i)%code)
      end do
      call assertEqual(code, found, 'peaks '//to_text(facts%peaks))
   end subroutine expect

end module test_surface_remarks
