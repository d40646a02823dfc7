!> METIS, which parts meshes: loaded when there are ranks to part one for. Debian's PETSc brings it
!> along (32-bit indices).
module asperity_solid_engine_metis
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_funptr, c_int, &
      c_null_ptr, c_ptr
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_replay_shared_library, only: find_procedure, open_library, shared_library
   implicit none
   private
   public :: part_mesh

   abstract interface
      integer(c_int) function part_function(elements, nodes, first, corners, weights, sizes, &
            common, parts, shares, options, cut, part_of_element, part_of_node) bind(c)
         import :: c_int, c_ptr
         integer(c_int), intent(in) :: elements, nodes, first(*), corners(*), weights(*)
         type(c_ptr), value :: sizes
         integer(c_int), intent(in) :: common, parts
         type(c_ptr), value :: shares
         integer(c_int), intent(in) :: options(*)
         integer(c_int), intent(out) :: cut, part_of_element(*), part_of_node(*)
      end function part_function
   end interface

   character(len=*), parameter :: library_name = 'libmetis.so.5'
   !> Elements are neighbours that share a face; what METIS returns on success
   integer(c_int), parameter :: nodes_of_face = 4, success = 1
   !> Options in METIS' order: the first is how, 0 by halves of halves, with which multigrid on
   !> eight ranks needs 0.6 times the vectors that it needs with all parts at once on 30 mm (1.2
   !> times on 60 mm); -1 leaves the rest to METIS
   integer(c_int), parameter :: options(40) = [0_c_int, spread(-1_c_int, 1, 39)]

contains

   !> Part bricks so that parts weigh alike and have short borders.
   subroutine part_mesh(corners, nodes, weights, parts, part_of_element, part_of_node, error)
      !> The eight nodes of each element, from 1
      integer, intent(in) :: corners(:, :)
      !> Number of nodes
      integer, intent(in) :: nodes
      !> Weight of each element
      integer, intent(in) :: weights(:)
      !> Number of parts, two or more and at most as many as elements
      integer, intent(in) :: parts
      !> Part of each element and each node, from 0
      integer, allocatable, intent(out) :: part_of_element(:), part_of_node(:)
      !> Set when METIS is not there or fails
      type(error_type), allocatable, intent(out) :: error
      type(shared_library) :: library
      type(c_funptr) :: address
      procedure(part_function), pointer :: part
      character(len=:), allocatable :: failure
      integer(c_int) :: first(size(corners, 2) + 1), element_parts(size(corners, 2)), &
         node_parts(nodes), cut, code
      integer :: i

      call ieee_set_halting_mode(ieee_all, .false.)
      call open_library(library_name, library, failure)
      if (.not. allocated(failure)) then
         call find_procedure(library, 'METIS_PartMeshDual', address)
         if (.not. c_associated(address)) failure = 'it has no METIS_PartMeshDual'
      end if
      if (allocated(failure)) then
         call fatal_error(error, 'METIS, which parts the mesh among ranks, cannot be loaded ('// &
            failure//'): apt-get install libmetis5, or take one rank', computation_error)
         return
      end if
      call c_f_procpointer(address, part)
      first = [(8*i, i=0, size(corners, 2))]
      code = part(size(corners, 2, c_int), int(nodes, c_int), first, &
         int(reshape(corners - 1, [size(corners)]), c_int), int(weights, c_int), c_null_ptr, &
         nodes_of_face, int(parts, c_int), c_null_ptr, options, cut, element_parts, node_parts)
      if (code /= success) then
         call fatal_error(error, 'METIS cannot part the mesh in '//to_text(parts)// &
            ': its error code is '//to_text(code), computation_error)
         return
      end if
      part_of_element = element_parts
      part_of_node = node_parts
   end subroutine part_mesh

end module asperity_solid_engine_metis
