!> Wood for tests of the material, its yield stress by the criteria as they are written, and a
!> driver that leaves some strains free of stress.
module material_cases
   use asperity, only: wp
   use asperity_base_error, only: error_type
   use asperity_solid_material_material, only: material_point, new_solid_material, &
      solid_material, update_material
   use asperity_wood_properties, only: wood_properties
   use random_inputs, only: random_stream
   implicit none
   private
   public :: criteria, place_of, prepare, distinct_wood, equivalent_stress, crushing_size, &
      first_yield_stress, load, random_curve, random_vector

   character(len=8), parameter :: criteria(3) = [character(len=8) :: 'mises', 'hill', 'crushing']
   !> Places of the components of a symmetric tensor in xx, yy, zz, xy, yz, zx
   integer, parameter :: place_of(3, 3) = reshape([1, 4, 6, 4, 2, 5, 6, 5, 3], [3, 3])

contains

   !> A material; stops when it is refused.
   subroutine prepare(material, wood, grain, radial, along)
      type(solid_material), intent(out) :: material
      type(wood_properties), intent(in) :: wood
      integer, intent(in) :: grain, radial
      !> Pressed along the grain, not when absent
      logical, intent(in), optional :: along
      type(error_type), allocatable :: error
      logical :: pressed

      pressed = .false.
      if (present(along)) pressed = along
      call new_solid_material(material, wood, grain, radial, pressed, error)
      if (allocated(error)) error stop 'material_cases: '//error%message
   end subroutine prepare

   !> Wood of which no two constants are the same.
   function distinct_wood(criterion) result(wood)
      character(len=*), intent(in) :: criterion
      type(wood_properties) :: wood

      wood%criterion = criterion
      wood%young_moduli = [3727.0_wp, 411.0_wp, 351.0_wp]
      wood%shear_moduli = [224.0_wp, 280.0_wp, 67.0_wp]
      wood%poisson_ratios = [0.62_wp, 0.42_wp, 0.35_wp]
      wood%compression_strengths = [50.1_wp, 4.7_wp, 4.4_wp]
      wood%tension_strengths = [75.3_wp, 3.1_wp, 2.9_wp]
      wood%shear_strengths = [2.7_wp, 3.3_wp, 1.9_wp]
      wood%hardening_along = 0.03_wp
      wood%hardening_across = 0.05_wp
   end function distinct_wood

   !> Square of the size of the crushing ellipsoid, beside half axes sqrt(ft fc).
   real(wp) function crushing_size(wood) result(square)
      type(wood_properties), intent(in) :: wood

      associate (a => wood%tension_strengths, b => wood%compression_strengths)
         square = 1.0_wp + sum((a - b)**2/(4.0_wp*a*b))
      end associate
   end function crushing_size

   !> Yield stress at first, MPa: by its definition for R pressed.
   real(wp) function first_yield_stress(wood)
      type(wood_properties), intent(in) :: wood

      first_yield_stress = wood%compression_strengths(2)
      if (wood%criterion == 'crushing') first_yield_stress = 2.0_wp*crushing_size(wood) &
         /(1.0_wp/wood%tension_strengths(2) + 1.0_wp/wood%compression_strengths(2))
   end function first_yield_stress

   !> Yield stress that a stress in the order LL, RR, TT, LR, LT, RT just reaches, MPa. Mises: as
   !> for wood pressed across the grain; Hill: as the manual of ABAQUS writes it, with ratios R.
   real(wp) function equivalent_stress(wood, s) result(reached)
      type(wood_properties), intent(in) :: wood
      real(wp), intent(in) :: s(6)
      real(wp) :: r(3), r12, r13, r23, f, g, h, yield

      yield = first_yield_stress(wood)
      select case (trim(wood%criterion))
      case ('mises')
         reached = sqrt(0.5_wp*((s(1) - s(2))**2 + (s(2) - s(3))**2 + (s(3) - s(1))**2) &
            + 3.0_wp*sum(s(4:6)**2))
      case ('hill')
         r = wood%compression_strengths/yield
         r12 = wood%shear_strengths(1)/(yield/sqrt(3.0_wp))
         r13 = wood%shear_strengths(2)/(yield/sqrt(3.0_wp))
         r23 = wood%shear_strengths(3)/(yield/sqrt(3.0_wp))
         f = 0.5_wp*(1.0_wp/r(2)**2 + 1.0_wp/r(3)**2 - 1.0_wp/r(1)**2)
         g = 0.5_wp*(1.0_wp/r(3)**2 + 1.0_wp/r(1)**2 - 1.0_wp/r(2)**2)
         h = 0.5_wp*(1.0_wp/r(1)**2 + 1.0_wp/r(2)**2 - 1.0_wp/r(3)**2)
         reached = sqrt(f*(s(2) - s(3))**2 + g*(s(3) - s(1))**2 + h*(s(1) - s(2))**2 &
            + 3.0_wp*s(6)**2/r23**2 + 3.0_wp*s(5)**2/r13**2 + 3.0_wp*s(4)**2/r12**2)
      case default
         associate (a => wood%tension_strengths, b => wood%compression_strengths)
            reached = sum(s(1:3)**2/(a*b) + s(1:3)*(1.0_wp/a - 1.0_wp/b)) &
               + sum((s(4:6)/wood%shear_strengths)**2)
         end associate
         ! 1 at first; the ellipsoid grows about its centre
         reached = yield*sqrt((reached - 1.0_wp + crushing_size(wood))/crushing_size(wood))
      end select
   end function equivalent_stress

   !> Load a point: strains that are `driven` are given, the others such that their stress is zero.
   subroutine load(material, start, driven, strain, finish)
      type(solid_material), intent(in) :: material
      type(material_point), intent(in) :: start
      logical, intent(in) :: driven(6)
      !> Given, and found from what it is on entry
      real(wp), intent(inout) :: strain(6)
      type(material_point), intent(out) :: finish
      real(wp) :: tangent(6, 6), residual(6)
      logical :: yields
      integer :: i, iteration

      do iteration = 1, 60
         call update_material(material, start, strain, finish, yields, tangent)
         if (.not. yields) tangent = material%stiffness
         residual = merge(0.0_wp, finish%stress, driven)
         if (iteration > 1 .and. maxval(abs(residual)) <= 1.0e-13_wp*maxval(abs(finish%stress))) &
            return
         do i = 1, 6
            if (.not. driven(i)) cycle
            tangent(i, :) = 0.0_wp
            tangent(:, i) = 0.0_wp
            tangent(i, i) = material%stiffness(i, i)
         end do
         call eliminate(tangent, residual)
         strain = strain - residual
      end do
      if (maxval(abs(merge(0.0_wp, finish%stress, driven))) > 1.0e-11_wp) &
         error stop 'material_cases: no state with these stresses'
   end subroutine load

   !> Solve a system of six by elimination, the largest of a column first.
   subroutine eliminate(matrix, vector)
      real(wp), intent(inout) :: matrix(6, 6), vector(6)
      real(wp) :: row(6), factor
      integer :: i, j, pivot

      do j = 1, 6
         pivot = j - 1 + maxloc(abs(matrix(j:, j)), 1)
         row = matrix(j, :)
         matrix(j, :) = matrix(pivot, :)
         matrix(pivot, :) = row
         vector([j, pivot]) = vector([pivot, j])
         do i = j + 1, 6
            factor = matrix(i, j)/matrix(j, j)
            matrix(i, :) = matrix(i, :) - factor*matrix(j, :)
            vector(i) = vector(i) - factor*vector(j)
         end do
      end do
      do j = 6, 1, -1
         vector(j) = (vector(j) - dot_product(matrix(j, j + 1:), vector(j + 1:)))/matrix(j, j)
      end do
   end subroutine eliminate

   !> Six numbers up to `largest` in size.
   function random_vector(stream, largest) result(vector)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: largest
      real(wp) :: vector(6)
      integer :: i

      do i = 1, 6
         vector(i) = stream%uniform(-largest, largest)
      end do
   end function random_vector

   !> A curve of points, sometimes flat, sometimes steep after a flat piece.
   function random_curve(stream, strength) result(curve)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: strength
      real(wp) :: curve(2, 5)
      integer :: i

      curve(:, 1) = [0.0_wp, strength]
      do i = 2, 5
         curve(1, i) = curve(1, i - 1) + stream%log_uniform(1.0e-4_wp, 0.3_wp)
         curve(2, i) = curve(2, i - 1) + max(stream%uniform(-0.5_wp, 1.0_wp), 0.0_wp)*strength
      end do
   end function random_curve

end module material_cases
