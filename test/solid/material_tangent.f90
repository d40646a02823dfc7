!> The tangent of the update, against differences of its stress.
module test_solid_material_tangent
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_material_material, only: material_point, solid_material, update_material
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use material_cases, only: criteria, distinct_wood, prepare, random_curve, random_vector
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_material_tangent

   integer(int64), parameter :: seed = 26457513_int64

contains

   function suite_material_tangent() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tangent of plastic wood')
      call suite%addTest(TestMethod('random states of each criterion', test_tangent))
   end function suite_material_tangent

   !> Tangent against central differences, of fourth order, in random states of every criterion,
   !> with a slope and with curves. A difference over a corner of the curve counts not.
   subroutine test_tangent()
      type(random_stream) :: stream
      type(wood_properties) :: wood
      type(solid_material) :: material
      type(material_point) :: start, point
      real(wp) :: strain(6), tangent(6, 6), largest
      integer :: i, criterion, n_checked
      logical :: yields
      character(len=40) :: message

      stream = random_stream(seed)
      do criterion = 1, 3
         n_checked = 0
         largest = 0.0_wp
         do i = 1, 200
            message = 'seed '//to_text(seed)//', state '//to_text(i)
            wood = distinct_wood(criteria(criterion))
            if (mod(i, 2) == 0) &
               wood%hardening_curve = random_curve(stream, wood%compression_strengths(2))
            call prepare(material, wood, 2, 1)
            start%plastic_strain = random_vector(stream, 0.02_wp)
            start%equivalent_strain = max(stream%uniform(-0.2_wp, 0.3_wp), 0.0_wp)
            strain = start%plastic_strain + random_vector(stream, 0.1_wp)
            call update_material(material, start, strain, point, yields, tangent)
            if (.not. yields) cycle
            if (mod(i, 2) == 0) then
               if (any(abs(wood%hardening_curve(1, :) - point%equivalent_strain) < 1.0e-3_wp)) cycle
            end if
            n_checked = n_checked + 1
            call assertEqual(0.0_wp, maxval(abs(tangent - transpose(tangent))), message)
            largest = max(largest, maxval(abs(tangent - differences(material, start, strain))) &
               /maxval(abs(material%stiffness)))
            call assertLessThan(largest, 1.0e-7_wp, criteria(criterion)//message)
         end do
         call assertGreaterThan(n_checked, 120)
      end do
   end subroutine test_tangent

   function differences(material, start, strain) result(tangent)
      type(solid_material), intent(in) :: material
      type(material_point), intent(in) :: start
      real(wp), intent(in) :: strain(6)
      real(wp) :: tangent(6, 6), stresses(6, -2:2), moved(6)
      real(wp), parameter :: step = 2.0e-5_wp
      type(material_point) :: point
      integer :: i, k
      logical :: yields

      do i = 1, 6
         do k = -2, 2
            moved = strain
            moved(i) = strain(i) + k*step
            call update_material(material, start, moved, point, yields)
            stresses(:, k) = point%stress
         end do
         tangent(:, i) = (8.0_wp*(stresses(:, 1) - stresses(:, -1)) - stresses(:, 2) &
            + stresses(:, -2))/(12.0_wp*step)
      end do
   end function differences

end module test_solid_material_tangent
