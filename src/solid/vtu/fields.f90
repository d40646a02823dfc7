!> Fields of the joint as a solid as .vtu files: its body, and the contact cells of its faces.
module asperity_solid_vtu_fields
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_solid_vtu_document, only: vtu_array, vtu_hexahedron, vtu_quadrilateral, write_vtu
   implicit none
   private
   public :: body_fields, contact_fields, write_body, write_contact

   !> Fields of nodes and elements, undeformed.
   type :: body_fields
      !> Coordinates and displacement of each node, mm
      real(wp), allocatable :: nodes(:, :), displacement(:, :)
      !> Nodes of each element, in the order of C3D8, and its part
      integer, allocatable :: elements(:, :), part(:)
      !> Of each element's eight points: stress xx yy zz xy yz zx, MPa, in the global axes, and
      !> equivalent plastic strain
      real(wp), allocatable :: stress(:, :, :), plastic_strain(:, :)
   end type body_fields

   !> Fields of contact cells. Those of a facet run along its first edge first, then the next row.
   type :: contact_fields
      !> Coordinates and displacement of each node, mm
      real(wp), allocatable :: nodes(:, :), displacement(:, :)
      !> Corners of each slave facet, and cells along each of its edges
      integer, allocatable :: facets(:, :)
      integer :: cells = 1
      !> Of each cell: which of the pairs of faces it is of, and its status: 1 open, 2 stick,
      !> 3 slip
      integer, allocatable :: face(:), status(:)
      !> Pressure, MPa, gap, mm, and share that has a surface opposite
      real(wp), allocatable :: pressure(:), gap(:), coverage(:)
      !> Shear traction in the global axes, MPa
      real(wp), allocatable :: shear(:, :)
   end type contact_fields

contains

   !> The text of the body's file: displacement of nodes; part, mean stress and largest plastic
   !> strain of elements.
   pure subroutine write_body(body, text, error)
      !> The fields
      type(body_fields), intent(in) :: body
      !> The text
      character(len=:), allocatable, intent(out) :: text
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: points = 8.0_wp
      type(vtu_array) :: of_nodes(1), of_cells(3)

      call name_values(of_nodes(1), 'displacement', body%displacement)
      call name_values(of_cells(1), 'part', row(real(body%part, wp)))
      call name_values(of_cells(2), 'stress', sum(body%stress, 2)/points)
      call name_values(of_cells(3), 'plastic_strain', row(maxval(body%plastic_strain, 1)))
      call write_vtu(body%nodes, body%elements, vtu_hexahedron, of_nodes, of_cells, text, error)
   end subroutine write_body

   !> The text of the contact cells' file.
   pure subroutine write_contact(contact, text, error)
      !> The fields
      type(contact_fields), intent(in) :: contact
      !> The text
      character(len=:), allocatable, intent(out) :: text
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: places(:, :), displacement(:, :)
      integer, allocatable :: cells(:, :)
      type(vtu_array) :: of_nodes(1), of_cells(6)

      call divide_facets(contact%nodes, contact%facets, contact%cells, places)
      call divide_facets(contact%displacement, contact%facets, contact%cells, displacement)
      call number_cells(contact%cells, size(contact%facets, 2), cells)
      call name_values(of_nodes(1), 'displacement', displacement)
      call name_values(of_cells(1), 'face', row(real(contact%face, wp)))
      call name_values(of_cells(2), 'status', row(real(contact%status, wp)))
      call name_values(of_cells(3), 'pressure', row(contact%pressure))
      call name_values(of_cells(4), 'shear', contact%shear)
      call name_values(of_cells(5), 'gap', row(contact%gap))
      call name_values(of_cells(6), 'coverage', row(contact%coverage))
      call write_vtu(places, cells, vtu_quadrilateral, of_nodes, of_cells, text, error)
   end subroutine write_contact

   !> Values at the corners of cells, bilinear between those at the corners of their facets.
   pure subroutine divide_facets(values, facets, cells, divided)
      !> Three values of each node
      real(wp), intent(in) :: values(:, :)
      !> Corners of each facet, and cells along each of its edges
      integer, intent(in) :: facets(:, :), cells
      !> Values at (cells + 1)**2 places of each facet
      real(wp), allocatable, intent(out) :: divided(:, :)
      real(wp) :: u, v
      integer :: i, j, k, n

      allocate (divided(size(values, 1), (cells + 1)**2*size(facets, 2)))
      n = 0
      do k = 1, size(facets, 2)
         do j = 0, cells
            do i = 0, cells
               u = real(i, wp)/cells
               v = real(j, wp)/cells
               n = n + 1
               divided(:, n) = matmul(values(:, facets(:, k)), [(1.0_wp - u)*(1.0_wp - v), &
                  u*(1.0_wp - v), u*v, (1.0_wp - u)*v])
            end do
         end do
      end do
   end subroutine divide_facets

   !> Corners of the cells among the places of `divide_facets`.
   pure subroutine number_cells(cells, facets, numbers)
      !> Cells along each edge of a facet, and how many facets there are
      integer, intent(in) :: cells, facets
      !> Four corners of each cell
      integer, allocatable, intent(out) :: numbers(:, :)
      integer :: i, j, k, n, first

      allocate (numbers(4, cells**2*facets))
      n = 0
      do k = 0, facets - 1
         do j = 0, cells - 1
            do i = 0, cells - 1
               first = (cells + 1)**2*k + (cells + 1)*j + i + 1
               n = n + 1
               numbers(:, n) = first + [0, 1, cells + 2, cells + 1]
            end do
         end do
      end do
   end subroutine number_cells

   !> Values under their name.
   pure subroutine name_values(array, name, values)
      type(vtu_array), intent(out) :: array
      character(len=*), intent(in) :: name
      !> Components of each value
      real(wp), intent(in) :: values(:, :)

      array%name = name
      allocate (array%values, source=values)
   end subroutine name_values

   !> Single values as one component.
   pure function row(values)
      real(wp), intent(in) :: values(:)
      real(wp) :: row(1, size(values))

      row(1, :) = values
   end function row

end module asperity_solid_vtu_fields
