!> Elastic wood: nine constants in every place of its axes.
module test_solid_material_elasticity
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_base_error, only: error_type
   use asperity_solid_material_eigenvectors, only: find_eigenvectors
   use asperity_solid_material_material, only: elastic_energy_density, material_point, &
      new_solid_material, solid_material, update_material
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, &
      TestSuite
   use material_cases, only: distinct_wood, load, place_of, prepare, random_vector
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_material_elasticity

   integer(int64), parameter :: seed = 24494897_int64

contains

   function suite_material_elasticity() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('elastic wood')
      call suite%addTest(TestMethod('nine constants in all six places', test_constants))
      call suite%addTest(TestMethod('stiffness is the inverse, energy as by it', test_inverse))
      call suite%addTest(TestMethod('history without yield', test_history))
      call suite%addTest(TestMethod('axes that are refused', test_axes))
      call suite%addTest(TestMethod('eigenvectors of three', test_eigenvectors))
   end function suite_material_elasticity

   !> A stress alone, by the update: strains along and to the sides give moduli and ratios.
   subroutine test_constants()
      type(solid_material) :: material
      type(material_point) :: point
      type(wood_properties) :: wood
      real(wp) :: strain(6)
      integer :: grain, radial, axes(3), i, j, k

      wood = distinct_wood('none')
      do grain = 1, 3
         do radial = 1, 3
            if (radial == grain) cycle
            axes = [grain, radial, 6 - grain - radial]
            call prepare(material, wood, grain, radial)
            do k = 1, 3
               strain = 0.0_wp
               strain(axes(k)) = 1.0e-3_wp
               call load(material, material_point(), [(i == axes(k), i=1, 6)], strain, point)
               call assertRelativelyEqual(wood%young_moduli(k), &
                  point%stress(axes(k))/strain(axes(k)), 1.0e-12_wp, 'modulus')
               if (k == 1) call assertEqual(wood%poisson_ratios(1:2), &
                  -strain(axes(2:3))/strain(axes(1)), tolerance=1.0e-12_wp, message='LR, LT')
               if (k == 2) call assertRelativelyEqual(wood%poisson_ratios(3), &
                  -strain(axes(3))/strain(axes(2)), 1.0e-12_wp, 'RT')
            end do
            do k = 1, 3
               ! LR, LT, RT
               i = place_of(axes(merge(2, 1, k == 3)), axes(merge(2, 3, k == 1)))
               strain = 0.0_wp
               strain(i) = 1.0e-3_wp
               call load(material, material_point(), [(i == j, j=1, 6)], strain, point)
               call assertRelativelyEqual(wood%shear_moduli(k), point%stress(i)/strain(i), &
                  1.0e-12_wp, 'shear')
               call assertEqual(1.0e-3_wp, sum(abs(strain)), tolerance=1.0e-18_wp)
            end do
         end do
      end do
   end subroutine test_constants

   subroutine test_inverse()
      type(solid_material) :: material
      type(material_point) :: point
      type(random_stream) :: stream
      real(wp) :: product(6, 6), strain(6)
      logical :: yields
      integer :: i

      call prepare(material, distinct_wood('none'), 3, 1)
      product = matmul(material%stiffness, material%compliance)
      do i = 1, 6
         product(i, i) = product(i, i) - 1.0_wp
      end do
      call assertEqual(0.0_wp, maxval(abs(product)), tolerance=1.0e-14_wp)
      call assertEqual(0.0_wp, maxval(abs(material%stiffness - transpose(material%stiffness))))
      stream = random_stream(seed)
      do i = 1, 20
         strain = random_vector(stream, 0.1_wp)
         call update_material(material, material_point(), strain, point, yields)
         call assertRelativelyEqual( &
            0.5_wp*dot_product(strain, matmul(material%stiffness, strain)), &
            elastic_energy_density(material, point%stress), 1.0e-13_wp)
      end do
   end subroutine test_inverse

   !> Without yield the history stays, and `none` never yields.
   subroutine test_history()
      type(solid_material) :: material
      type(material_point) :: start, point
      real(wp) :: strain(6)
      logical :: yields

      call prepare(material, distinct_wood('none'), 1, 2)
      start%plastic_strain = [1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp, 6.0_wp]*1.0e-3_wp
      start%equivalent_strain = 0.02_wp
      strain = 1.0_wp
      call update_material(material, start, strain, point, yields)
      call assertFalse(yields)
      call assertFalse(material%is_plastic)
      call assertEqual(start%plastic_strain, point%plastic_strain)
      call assertEqual(start%equivalent_strain, point%equivalent_strain)
      call assertRelativelyEqual(matmul(material%stiffness, strain - start%plastic_strain), &
         point%stress, 1.0e-14_wp)
      call prepare(material, distinct_wood('crushing'), 1, 2)
      call assertTrue(material%is_plastic)
      call update_material(material, start, start%plastic_strain, point, yields)
      call assertFalse(yields)
      call assertEqual(start%equivalent_strain, point%equivalent_strain)
      call assertEqual(0.0_wp, maxval(abs(point%stress)))
   end subroutine test_history

   subroutine test_axes()
      type(solid_material) :: material
      type(error_type), allocatable :: error
      integer, parameter :: refused(2, 4) = reshape([0, 1, 1, 4, 2, 2, 1, -1], [2, 4])
      integer :: i

      do i = 1, 4
         call new_solid_material(material, distinct_wood('hill'), refused(1, i), refused(2, i), &
            .false., error)
         call assertTrue(allocated(error))
         if (.not. allocated(error)) return
         call assertEqual('grain radial', error%subject)
      end do
      call new_solid_material(material, distinct_wood('none'), 3, 2, .false., error)
      call assertFalse(allocated(error))
   end subroutine test_axes

   !> Their definition, also where eigenvalues meet or are nought.
   subroutine test_eigenvectors()
      type(random_stream) :: stream
      real(wp) :: a(3, 3), values(3), vectors(3, 3), v(6), size_of_a
      integer :: i, k

      stream = random_stream(seed)
      do k = 1, 200
         v = random_vector(stream, 1.0_wp)
         a = reshape(v([1, 4, 6, 4, 2, 5, 6, 5, 3]), [3, 3])
         select case (mod(k, 4))
         case (1)
            a = spread(v(1:3), 1, 3)*spread(v(1:3), 2, 3)
         case (2)
            a = 0.0_wp
            do i = 1, 3
               a(i, i) = v(i)
            end do
         case (3)
            a(1:2, 3) = 1.0e-9_wp*a(1:2, 3)
            a(3, 1:2) = a(1:2, 3)
         case default
            ! as it was drawn
         end select
         size_of_a = maxval(abs(a))
         call find_eigenvectors(a, values, vectors)
         do i = 1, 3
            call assertEqual(0.0_wp, maxval(abs(matmul(a, vectors(:, i)) &
               - values(i)*vectors(:, i))), tolerance=1.0e-14_wp*size_of_a)
            v(1:3) = matmul(vectors(:, i), vectors)
            v(i) = v(i) - 1.0_wp
            call assertEqual(0.0_wp, maxval(abs(v(1:3))), tolerance=1.0e-14_wp)
         end do
      end do
   end subroutine test_eigenvectors

end module test_solid_material_elasticity
