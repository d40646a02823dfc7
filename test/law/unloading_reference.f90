!> The law with memory against numbers that are not its own: two tables in 25 digits.
module test_law_unloading_reference
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: normal_response
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties, &
      unloading_elastic
   use asperity_law_unloading_law, only: evaluate_unloading_law, unloading_stiffness
   use extremes, only: worsen
   use funit, only: assertEqual, assertFail, assertLessThan, assertLessThanOrEqual, TestMethod, &
      TestSuite
   use measurements, only: record
   use reference_table, only: open_table
   implicit none
   private
   public :: suite_unloading_reference

   !> Of the law everywhere, and of one stage's share or the dissipation of faces that hardly yield
   real(wp), parameter :: tolerance = 1.0e-12_wp, tolerance_of_little = 1.0e-11_wp

contains

   function suite_unloading_reference() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('unloading reference')
      call suite%addTest(TestMethod('given 25-digit values', test_given))
      call suite%addTest(TestMethod('25-digit values over the whole range', test_range))
   end function suite_unloading_reference

   !> test/data/unloading_reference.csv, whose 60 rows of four pairs were given with the derivation,
   !> found with a quadrature in 40 digits. At no retraction its stiffness is that of the
   !> unloading branch.
   subroutine test_given()
      character(len=*), parameter :: header = 'pair,eta,modulus,radius,hardness,yield_factor,'// &
         'sigma,closest_separation,retraction,pressure,stiffness,area_fraction,'// &
         'contact_density,stored_energy'
      character(len=40) :: pair
      character(len=1024) :: line
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: v(13), worst
      integer :: unit, status, rows

      worst = 0.0_wp
      rows = 0
      call open_table('unloading_reference.csv', header, unit)
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         read (line, *) pair, v
         rows = rows + 1
         call set_properties(p, v(1:6))
         r = evaluate_unloading_law(p, v(7), v(8))
         if (.not. v(8) > 0.0_wp) r%stiffness = unloading_stiffness(p, v(7))
         call worsen(worst, abs([r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%energy]/v(9:13) - 1.0_wp))
      end do
      close (unit)
      call assertEqual(60, rows, 'rows')
      call record('unloading_law.given.relative_error', worst)
      call assertLessThan(worst, tolerance, 'relative error')
   end subroutine test_given

   !> test/data/unloading_law_reference.csv, by test/reference/unloading_reference.py: d_m/sigma
   !> from -8 to 8, w1/sigma from 1e-6 to 1e2, k from 0.1907 to 1, retractions up to a pressure of
   !> 1e-12 of that at d_m. At no retraction likewise.
   subroutine test_range()
      character(len=*), parameter :: header = 'kind,sigma,eta,modulus,radius,hardness,'// &
         'yield_factor,closest_separation,retraction,pressure,stiffness,area_fraction,'// &
         'contact_density,energy,plastic_dissipation,elastic_share,elastoplastic_share,'// &
         'plastic_share'
      character(len=19), parameter :: columns(9) = [character(len=19) :: 'pressure', &
         'stiffness', 'area_fraction', 'contact_density', 'energy', 'plastic_dissipation', &
         'elastic_share', 'elastoplastic_share', 'plastic_share']
      character(len=40) :: kind
      character(len=1024) :: line
      character(len=12) :: label
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: v(17), found(9), relative, worst(9)
      integer :: unit, status, rows, j

      worst = 0.0_wp
      rows = 0
      call open_table('unloading_law_reference.csv', header, unit)
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         read (line, *) kind, v
         rows = rows + 1
         write (label, '(a, i0)') 'row ', rows
         call set_properties(p, v([2, 3, 4, 5, 6, 1]))
         r = evaluate_unloading_law(p, v(7), v(8))
         if (.not. v(8) > 0.0_wp) r%stiffness = unloading_stiffness(p, v(7))
         found = [r%pressure, r%stiffness, r%area_fraction, r%contact_density, r%energy, &
            r%plastic_dissipation, r%elastic_share, r%elastoplastic_share, r%plastic_share]
         do j = 1, 9
            if (v(8 + j) >= tiny(1.0_wp)) then
               relative = abs(found(j)/v(8 + j) - 1.0_wp)
               call worsen(worst(j), relative)
               call assertLessThan(relative, merge(tolerance_of_little, tolerance, j > 5), &
                  trim(label)//' '//columns(j))
            else
               call assertLessThanOrEqual(found(j), tiny(1.0_wp), trim(label)//' '//columns(j))
            end if
         end do
      end do
      close (unit)
      call assertEqual(267, rows, 'rows')
      do j = 1, 9
         call record('unloading_law.'//trim(columns(j))//'.relative_error', worst(j))
      end do
   end subroutine test_range

   subroutine set_properties(p, values)
      type(normal_properties), intent(out) :: p
      !> eta, modulus, radius, hardness, yield factor, sigma
      real(wp), intent(in) :: values(6)
      type(error_type), allocatable :: error

      call new_normal_properties(p, values(1), values(2), values(3), values(4), values(5), &
         values(6), error, accept_unphysical=.true., unloading=unloading_elastic)
      if (allocated(error)) call assertFail(error%message)
   end subroutine set_properties

end module test_law_unloading_reference
