!> Unstructured grids as VTK's XML files (.vtu), which ParaView and pyvista open, and the series of
!> them (.pvd) that ParaView plays.
!>
!> Numbers are bytes in base 64 within the XML: exact, plain text, a third larger than raw bytes. A
!> file a step, as each is whole by itself: in the newer VTKHDF, one file of all steps, data whose
!> offsets are forgotten shows the first step's values in every step, and nothing says so.
module asperity_solid_vtu_document
   use, intrinsic :: iso_fortran_env, only: int32, int64, int8
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_solid_vtu_base64, only: encode_base64
   implicit none
   private
   public :: vtu_array, write_vtu, write_pvd

   !> VTK's numbers of the kinds of cells: quadrilaterals, and hexahedra with corners as in C3D8
   integer, parameter, public :: vtu_quadrilateral = 9, vtu_hexahedron = 12

   !> Values at all nodes or in all cells.
   type :: vtu_array
      !> Name, as ParaView shows it
      character(len=32) :: name = ''
      !> Components of each value; six are shown as XX YY ZZ XY YZ XZ
      real(wp), allocatable :: values(:, :)
   end type vtu_array

contains

   !> The text of a .vtu file.
   pure subroutine write_vtu(nodes, cells, kind, of_nodes, of_cells, text, error)
      !> Coordinates of each node
      real(wp), intent(in) :: nodes(:, :)
      !> Nodes of each cell, numbered from 1
      integer, intent(in) :: cells(:, :)
      !> `vtu_quadrilateral` or `vtu_hexahedron`
      integer, intent(in) :: kind
      !> Values at the nodes and in the cells
      type(vtu_array), intent(in) :: of_nodes(:), of_cells(:)
      !> The text
      character(len=:), allocatable, intent(out) :: text
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: out
      integer :: i, corners, n

      corners = size(cells, 1)
      n = size(cells, 2)
      call open_document(out, 'UnstructuredGrid')
      call out%line('<Piece NumberOfPoints="'//to_text(size(nodes, 2))//'" NumberOfCells="'// &
         to_text(n)//'">')
      call out%line('<Points>')
      call add_reals(out, 'Points', nodes)
      call out%line('</Points>')
      call out%line('<Cells>')
      call add_array(out, 'Int32', 'connectivity', 1, &
         transfer(int(cells - 1, int32), [0_int8]))
      call add_array(out, 'Int32', 'offsets', 1, &
         transfer(int([(corners*i, i=1, n)], int32), [0_int8]))
      call add_array(out, 'UInt8', 'types', 1, [(int(kind, int8), i=1, n)])
      call out%line('</Cells>')
      call out%line('<PointData>')
      do i = 1, size(of_nodes)
         call add_reals(out, trim(of_nodes(i)%name), of_nodes(i)%values)
      end do
      call out%line('</PointData>')
      call out%line('<CellData>')
      do i = 1, size(of_cells)
         call add_reals(out, trim(of_cells(i)%name), of_cells(i)%values)
      end do
      call out%line('</CellData>')
      call out%line('</Piece>')
      call close_document(out, 'UnstructuredGrid')
      call out%take(text, error)
   end subroutine write_vtu

   !> The text of a .pvd file: which file shows which time.
   pure subroutine write_pvd(times, files, text, error)
      !> Time of each file, rising, and its path seen from the folder of the .pvd file
      real(wp), intent(in) :: times(:)
      character(len=*), intent(in) :: files(:)
      !> The text
      character(len=:), allocatable, intent(out) :: text
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: out
      integer :: i

      call open_document(out, 'Collection')
      do i = 1, size(files)
         call out%add('<DataSet timestep="'//to_text(times(i))//'" part="0" file="')
         call add_escaped(out, trim(files(i)))
         call out%line('"/>')
      end do
      call close_document(out, 'Collection')
      call out%take(text, error)
   end subroutine write_pvd

   !> Begin a document.
   pure subroutine open_document(out, kind)
      type(growing_text), intent(inout) :: out
      !> What is in it
      character(len=*), intent(in) :: kind
      character(len=12) :: order

      ! as this machine's
      order = 'BigEndian'
      if (any(transfer(1_int32, [0_int8]) /= [0_int8, 0_int8, 0_int8, 1_int8])) &
         order = 'LittleEndian'
      call out%line('<?xml version="1.0"?>')
      call out%line('<VTKFile type="'//kind//'" version="1.0" byte_order="'//trim(order)// &
         '" header_type="UInt64">')
      call out%line('<!-- units: mm, N, MPa -->')
      call out%line('<'//kind//'>')
   end subroutine open_document

   !> End a document.
   pure subroutine close_document(out, kind)
      type(growing_text), intent(inout) :: out
      !> What is in it
      character(len=*), intent(in) :: kind

      call out%line('</'//kind//'>')
      call out%line('</VTKFile>')
   end subroutine close_document

   !> Add an array of real numbers.
   pure subroutine add_reals(out, name, values)
      type(growing_text), intent(inout) :: out
      character(len=*), intent(in) :: name
      !> Components of each value
      real(wp), intent(in) :: values(:, :)

      call add_array(out, 'Float64', name, size(values, 1), transfer(values, [0_int8]))
   end subroutine add_reals

   !> Add an array: how many bytes there are, and the bytes.
   pure subroutine add_array(out, kind, name, components, bytes)
      type(growing_text), intent(inout) :: out
      !> VTK's kind of number, and name of the array
      character(len=*), intent(in) :: kind, name
      !> Numbers of each value
      integer, intent(in) :: components
      !> All of them
      integer(int8), intent(in) :: bytes(:)
      character(len=:), allocatable :: encoded

      call out%line('<DataArray type="'//kind//'" Name="'//name//'" NumberOfComponents="'// &
         to_text(components)//'" format="binary">')
      call encode_base64([transfer(size(bytes, kind=int64), [0_int8]), bytes], encoded)
      call out%line(encoded)
      call out%line('</DataArray>')
   end subroutine add_array

   !> Add text, with the characters that XML reserves as it wants them.
   pure subroutine add_escaped(out, text)
      type(growing_text), intent(inout) :: out
      character(len=*), intent(in) :: text
      integer :: i

      do i = 1, len(text)
         select case (text(i:i))
         case ('&')
            call out%add('&amp;')
         case ('<')
            call out%add('&lt;')
         case ('"')
            call out%add('&quot;')
         case default
            call out%add(text(i:i))
         end select
      end do
   end subroutine add_escaped

end module asperity_solid_vtu_document
