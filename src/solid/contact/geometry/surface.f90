!> A surface of facets, and rays that walk over it from facet to facet.
module asperity_solid_contact_geometry_surface
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_contact_geometry_facet, only: facet_ray, facet_slopes, shoot_ray
   use asperity_solid_small_matrices, only: cross
   implicit none
   private
   public :: contact_surface, new_contact_surface, project, nearest_facet

   !> Facets with their normals outwards. Edge k of a facet runs from corner k to the next.
   type :: contact_surface
      !> Corners of each facet
      integer, allocatable :: facets(:, :)
      !> The facet past each edge, 0 at a rim
      integer, allocatable :: neighbours(:, :)
      !> Half the facet in its two natural directions, undeformed, mm
      real(wp), allocatable :: half_edges(:, :, :)
   end type contact_surface

   !> A facet's area at a corner must not fall below this share of that of its middle
   real(wp), parameter :: least_area = 1.0e-6_wp
   !> How far outside of a facet a ray may be and still belong to it
   real(wp), parameter :: on_edge = 1.0e-9_wp
   integer, parameter :: longest_walk = 30

contains

   !> Find neighbours and check the facets. `error` is set when there are none, or one of them is
   !> degenerate.
   pure subroutine new_contact_surface(surface, what, positions, facets, error)
      !> Result
      type(contact_surface), intent(out) :: surface
      !> What the surface is, for messages
      character(len=*), intent(in) :: what
      !> Undeformed places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      !> Four corners of each facet, counter-clockwise seen from outside
      integer, intent(in) :: facets(:, :)
      !> Set when the facets are refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: slopes(4, 2), corners(3, 4)
      integer :: i

      if (size(facets, 2) == 0) then
         call fatal_error(error, 'the '//what//' has no facets: contact needs at least one on '// &
            'either side')
         return
      end if
      surface%facets = facets
      allocate (surface%half_edges(3, 2, size(facets, 2)))
      slopes = facet_slopes([0.0_wp, 0.0_wp])
      do i = 1, size(facets, 2)
         corners = positions(:, facets(:, i))
         if (is_degenerate(corners)) then
            call fatal_error(error, 'facet '//to_text(i)//' of the '//what//', nodes '// &
               to_text(facets(1, i))//', '//to_text(facets(2, i))//', '// &
               to_text(facets(3, i))//', '//to_text(facets(4, i))//', is degenerate: its '// &
               'corners must be four and convex')
            return
         end if
         surface%half_edges(:, :, i) = matmul(corners, slopes)
      end do
      call find_neighbours(surface, size(positions, 2))
   end subroutine new_contact_surface

   !> Whether a facet is too flat at a corner, or not convex.
   pure logical function is_degenerate(corners)
      real(wp), intent(in) :: corners(3, 4)
      real(wp) :: middle(3), area(3)
      integer :: k

      middle = cross(corners(:, 3) - corners(:, 1), corners(:, 4) - corners(:, 2))
      is_degenerate = .true.
      do k = 1, 4
         area = cross(corners(:, modulo(k, 4) + 1) - corners(:, k), &
            corners(:, modulo(k - 2, 4) + 1) - corners(:, k))
         if (.not. dot_product(area, middle) > least_area*dot_product(middle, middle)) return
      end do
      is_degenerate = .false.
   end function is_degenerate

   !> Facets that share an edge, which each runs along in its own sense. They are looked for among
   !> the facets at a node.
   pure subroutine find_neighbours(surface, nodes)
      type(contact_surface), intent(inout) :: surface
      integer, intent(in) :: nodes
      integer :: first(nodes + 1), next(nodes), list(size(surface%facets)), i, j, k, m, from, to

      associate (facets => surface%facets, n => size(surface%facets, 2))
         first = 0
         do i = 1, n
            first(facets(:, i) + 1) = first(facets(:, i) + 1) + 1
         end do
         first(1) = 1
         do i = 1, nodes
            first(i + 1) = first(i) + first(i + 1)
         end do
         next = first(:nodes)
         do i = 1, n
            list(next(facets(:, i))) = i
            next(facets(:, i)) = next(facets(:, i)) + 1
         end do
         allocate (surface%neighbours(4, n), source=0)
         do i = 1, n
            do k = 1, 4
               from = facets(k, i)
               to = facets(modulo(k, 4) + 1, i)
               do m = first(from), first(from + 1) - 1
                  j = list(m)
                  if (j == i) cycle
                  if (any(facets(:, j) == to .and. cshift(facets(:, j), 1) == from)) &
                     surface%neighbours(k, i) = j
               end do
            end do
         end do
      end associate
   end subroutine find_neighbours

   !> Follow a ray to the facet that it meets, from a facet near it on: over edges, and at a rim
   !> past it, on the facet extended. Facet 0 is met by no ray.
   pure subroutine project(surface, positions, from, direction, facet, ray)
      !> The surface
      type(contact_surface), intent(in) :: surface
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      !> Start of the ray, mm, and unit direction
      real(wp), intent(in) :: from(3), direction(3)
      !> A facet near it, and the one found
      integer, intent(inout) :: facet
      !> The ray; its natural coordinates are a first guess
      type(facet_ray), intent(inout) :: ray
      real(wp) :: outside(4), corners(3, 4)
      integer :: step, try, edge, next

      ray%usable = .false.
      if (facet == 0) return
      do step = 1, longest_walk
         corners = positions(:, surface%facets(:, facet))
         call shoot_ray(ray, corners, from, direction)
         outside = [-1.0_wp - ray%natural(2), ray%natural(1) - 1.0_wp, &
            ray%natural(2) - 1.0_wp, -1.0_wp - ray%natural(1)]
         next = 0
         do try = 1, 2
            edge = maxloc(outside, 1)
            if (outside(edge) <= on_edge) exit
            next = surface%neighbours(edge, facet)
            if (next > 0) exit
            outside(edge) = -1.0_wp
         end do
         if (next == 0) exit
         facet = next
         ray%natural = 0.0_wp
      end do
   end subroutine project

   !> The facet that a ray meets nearest to its middle, 0 when there is none.
   pure integer function nearest_facet(surface, positions, from, direction) result(facet)
      !> The surface
      type(contact_surface), intent(in) :: surface
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      !> Start of the ray, mm, and unit direction
      real(wp), intent(in) :: from(3), direction(3)
      type(facet_ray) :: ray
      real(wp) :: least, corners(3, 4)
      integer :: i

      facet = 0
      least = huge(1.0_wp)
      do i = 1, size(surface%facets, 2)
         ray%natural = 0.0_wp
         corners = positions(:, surface%facets(:, i))
         call shoot_ray(ray, corners, from, direction)
         if (.not. ray%usable .or. maxval(abs(ray%natural)) >= least) cycle
         least = maxval(abs(ray%natural))
         facet = i
      end do
   end function nearest_facet

end module asperity_solid_contact_geometry_surface
