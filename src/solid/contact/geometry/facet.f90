!> A facet of a surface, bilinear between its four corners, and the ray that meets it.
module asperity_solid_contact_geometry_facet
   use asperity_base_kinds, only: wp
   use asperity_solid_small_matrices, only: cross, invert
   implicit none
   private
   public :: facet_ray, facet_shape, facet_slopes, shoot_ray

   !> Where a ray meets a facet, extended past its edges if need be.
   type :: facet_ray
      !> Natural coordinates on the facet, -1 to 1 within it
      real(wp) :: natural(2) = 0.0_wp
      !> Distance along the ray, mm
      real(wp) :: gap = 0.0_wp
      !> When the start of the ray moves by u from the point that it meets, natural coordinates and
      !> gap change by `inverse u`
      real(wp) :: inverse(3, 3) = 0.0_wp
      !> Whether the ray meets the front of a facet that does not lean too far
      logical :: usable = .false.
   end type facet_ray

   !> Natural coordinates of the corners
   real(wp), parameter :: xi(4) = [-1.0_wp, 1.0_wp, 1.0_wp, -1.0_wp]
   real(wp), parameter :: eta(4) = [-1.0_wp, -1.0_wp, 1.0_wp, 1.0_wp]
   !> Product of both slopes of the shape functions
   real(wp), parameter, public :: facet_twist(4) = [0.25_wp, -0.25_wp, 0.25_wp, -0.25_wp]
   !> Facets that lean more than 70 degrees are met by iterates gone astray only
   real(wp), parameter, public :: least_cosine = 0.34202014332566873_wp
   !> Natural coordinates further out than this are of no use
   real(wp), parameter :: farthest = 20.0_wp
   !> A step this small, in natural coordinates, ends the search: the error left is its square
   real(wp), parameter :: small_step = 1.0e-10_wp
   integer, parameter :: max_iterations = 12

contains

   !> Shape functions.
   pure function facet_shape(natural) result(values)
      !> Natural coordinates
      real(wp), intent(in) :: natural(2)
      real(wp) :: values(4)

      values = 0.25_wp*(1.0_wp + xi*natural(1))*(1.0_wp + eta*natural(2))
   end function facet_shape

   !> Derivatives of the shape functions by the natural coordinates.
   pure function facet_slopes(natural) result(slopes)
      !> Natural coordinates
      real(wp), intent(in) :: natural(2)
      real(wp) :: slopes(4, 2)

      slopes(:, 1) = 0.25_wp*xi*(1.0_wp + eta*natural(2))
      slopes(:, 2) = 0.25_wp*eta*(1.0_wp + xi*natural(1))
   end function facet_slopes

   !> Meet a facet by Newton's method from the natural coordinates that the ray has.
   pure subroutine shoot_ray(ray, corners, from, direction)
      !> The ray; its natural coordinates are the first guess
      type(facet_ray), intent(inout) :: ray
      !> Places of the four corners, mm
      real(wp), intent(in) :: corners(3, 4)
      !> Start, mm, and unit direction
      real(wp), intent(in) :: from(3), direction(3)
      real(wp) :: slopes(4, 2), matrix(3, 3), normal(3), step(3), determinant
      integer :: iteration

      ray%usable = .false.
      ray%gap = 0.0_wp
      matrix(:, 3) = -direction
      do iteration = 1, max_iterations
         slopes = facet_slopes(ray%natural)
         matrix(:, :2) = matmul(corners, slopes)
         normal = cross(matrix(:, 1), matrix(:, 2))
         call invert(matrix, ray%inverse, determinant)
         if (.not. abs(determinant) > epsilon(1.0_wp)*norm2(normal)) return
         step = matmul(ray%inverse, from + ray%gap*direction &
            - matmul(corners, facet_shape(ray%natural)))
         ray%natural = min(max(ray%natural + step(:2), -farthest), farthest)
         ray%gap = ray%gap + step(3)
         if (maxval(abs(step(:2))) < small_step) exit
      end do
      ray%usable = iteration <= max_iterations .and. determinant > least_cosine*norm2(normal)
   end subroutine shoot_ray

end module asperity_solid_contact_geometry_facet
