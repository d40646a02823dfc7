!> The paper's pairs and surfaces: Table 2 and Table 4 as printed, converted by formula.
module test_law_pairs
   use asperity_base_error, only: error_type, input_error
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_law_validity, only: valid
   use asperity_paper_pairs, only: find_pair, find_surface, pair_note, pair_preset, pairs, &
      surface_preset, surfaces
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, &
      TestSuite
   implicit none
   private
   public :: suite_presets

   !> Table 2 as printed: sigma (Sq), R (1/Spc), eta (Spd), Sku
   character(len=22), parameter :: surface_names(9) = [character(len=22) :: &
      'unpolished-cross', 'unpolished-tangential', 'unpolished-radial', &
      'mesh-200-cross', 'mesh-200-tangential', 'mesh-200-radial', &
      'mesh-400-cross', 'mesh-400-tangential', 'mesh-400-radial']
   real(wp), parameter :: table_2(4, 9) = reshape([ &
      59.3_wp, 0.1477_wp, 0.000206_wp, 3.61_wp, &
      41.6_wp, 0.1142_wp, 0.000134_wp, 3.43_wp, &
      27.6_wp, 0.0696_wp, 0.000127_wp, 3.23_wp, &
      28.0_wp, 0.2437_wp, 0.000330_wp, 3.49_wp, &
      19.7_wp, 0.1508_wp, 0.000297_wp, 3.21_wp, &
      15.6_wp, 0.1746_wp, 0.000196_wp, 3.14_wp, &
      23.9_wp, 0.4465_wp, 0.000322_wp, 3.34_wp, &
      14.7_wp, 0.3446_wp, 0.000296_wp, 3.14_wp, &
      11.7_wp, 0.2336_wp, 0.000169_wp, 3.01_wp], [4, 9])

   !> Table 4 as printed: mu, gcrit, eta, E*, R, H, k; and sigma of Table 2
   real(wp), parameter :: table_4(8, 2) = reshape([ &
      0.5_wp, 0.31_wp, 0.000206_wp, 297.0_wp, 0.1477_wp, 24.53_wp, 0.4_wp, 59.3_wp, &
      0.5_wp, 0.31_wp, 0.000134_wp, 263.0_wp, 0.1142_wp, 12.14_wp, 0.4_wp, 41.6_wp], [8, 2])

   !> mm per um, and 1/mm^2 per 1/um^2
   real(wp), parameter :: um = 1.0e-3_wp, per_um2 = 1.0e6_wp

contains

   function suite_presets() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('presets')
      call suite%addTest(TestMethod('surfaces of Table 2', test_surfaces))
      call suite%addTest(TestMethod('pairs of Table 4', test_pairs))
      call suite%addTest(TestMethod('every pair is physical', test_physical))
      call suite%addTest(TestMethod('unknown names list the known ones', test_unknown))
   end function suite_presets

   subroutine test_surfaces()
      type(surface_preset) :: surface
      type(error_type), allocatable :: error
      integer :: i

      call assertEqual(size(surface_names), size(surfaces))
      do i = 1, size(surface_names)
         call find_surface(trim(surface_names(i)), surface, error)
         call assertFalse(allocated(error), trim(surface_names(i))//' is known')
         call assertEqual(surface_names(i), surface%name)
         call assertRelativelyEqual( &
            [table_2(1, i)*um, table_2(2, i), table_2(3, i)*per_um2, table_2(4, i)], &
            [surface%sigma, surface%radius, surface%eta, surface%kurtosis], 1.0e-15_wp, &
            trim(surface_names(i)))
         call assertTrue(index(surface%note, 'Table 2') > 0, 'note names its source')
      end do
   end subroutine test_surfaces

   subroutine test_pairs()
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      integer :: i

      call assertEqual(2, size(pairs))
      do i = 1, 2
         call find_pair(merge('transverse-tangential', 'tangential-tangential', i == 1), pair, &
            error)
         call assertFalse(allocated(error))
         call assertRelativelyEqual([table_4(1:2, i), table_4(3, i)*per_um2, table_4(4:7, i), &
            table_4(8, i)*um], [pair%friction_coefficient, pair%critical_slip, pair%eta, &
            pair%modulus, pair%radius, pair%hardness, pair%yield_factor, pair%sigma], 1.0e-15_wp)
         call assertEqual('Table 4', trim(pair_note(pair, .false., .false., .false., .false.)))
         call assertEqual('Table 4; '//trim(pair%eta_note), trim(pair_note(pair, .true., .false., &
            .false., .false.)))
         call assertTrue(index(pair%sigma_note, 'Table 2') > 0, 'names the source of sigma')
         call assertTrue(index(pair_note(pair, .true., .true., .true., .true.), &
            trim(merge(', ', '; ', i == 1))//' E* not from Eq. 4') > 0, 'last part')
      end do
   end subroutine test_pairs

   !> Accepted without `accept_unphysical`; eta R sigma is 1.8 and 0.64, and from 0.24 to 3.4 over
   !> Table 2 (to two figures).
   subroutine test_physical()
      real(wp), parameter :: number(2) = [1.8_wp, 0.64_wp], half_digit(2) = [0.05_wp, 0.005_wp]
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      real(wp) :: numbers(9)
      integer :: i

      do i = 1, 2
         call new_normal_properties(p, pairs(i), error)
         call assertFalse(allocated(error))
         call assertEqual(valid, p%validity)
         call assertEqual([pairs(i)%eta, pairs(i)%modulus, pairs(i)%radius, pairs(i)%hardness, &
            pairs(i)%yield_factor, pairs(i)%sigma], &
            [p%eta, p%modulus, p%radius, p%hardness, p%yield_factor, p%sigma], 0.0_wp)
         call assertEqual(number(i), p%eta*p%radius*p%sigma, half_digit(i))
      end do
      numbers = surfaces%eta*surfaces%radius*surfaces%sigma
      call assertEqual(0.24_wp, minval(numbers), 0.01_wp)
      call assertEqual(3.4_wp, maxval(numbers), 0.05_wp)
   end subroutine test_physical

   subroutine test_unknown()
      type(pair_preset) :: pair
      type(surface_preset) :: surface
      type(error_type), allocatable :: error
      integer :: i

      call find_pair('radial-radial', pair, error)
      call assertTrue(allocated(error), 'pair is refused')
      if (.not. allocated(error)) return
      call assertEqual(input_error, error%category)
      call assertEqual('pair', error%subject)
      call assertTrue(index(error%message, "'radial-radial'") > 0, 'message holds the name')
      do i = 1, size(pairs)
         call assertTrue(index(error%message, trim(pairs(i)%name)) > 0, 'message lists the pairs')
      end do
      call find_surface('', surface, error)
      call assertTrue(allocated(error), 'surface is refused')
      if (.not. allocated(error)) return
      call assertEqual('surface', error%subject)
      do i = 1, size(surfaces)
         call assertTrue(index(error%message, trim(surfaces(i)%name)) > 0, &
            'message lists the surfaces')
      end do
   end subroutine test_unknown

end module test_law_pairs
