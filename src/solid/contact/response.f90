!> Nodal forces and tangent of a face of a contact pair.
module asperity_solid_contact_response
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_cell_response, only: add_cell_response
   use asperity_solid_contact_pair, only: contact_pair, update_cell
   use asperity_solid_contact_rays, only: follow_rays, meet_facets
   implicit none
   private
   public :: face_response

contains

   !> Internal forces of a face at a trial: the residual gets them with the sign of the elements'.
   subroutine face_response(pair, number, positions, forces, error, tangent)
      !> The pair; the nodes of the face may grow
      type(contact_pair), intent(inout) :: pair
      !> Number of the face
      integer, intent(in) :: number
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      !> Forces on the face's nodes, N; given its shape here
      real(wp), allocatable, intent(inout) :: forces(:, :)
      !> Set when the law fails
      type(error_type), allocatable, intent(out) :: error
      !> Their derivative by the places of these nodes, node by node x y z, N/mm; given its shape
      real(wp), allocatable, intent(inout), optional :: tangent(:, :)
      integer :: i, n

      associate (face => pair%faces(number))
         call follow_rays(face, pair%master, positions)
         do i = 1, size(face%cells)
            call update_cell(pair%law, face%cells(i), error)
            if (allocated(error)) return
            call meet_facets(face, i, pair%master, pair%search_distance, pair%has_grown)
         end do
         n = size(face%nodes)
         call give_shape(forces, 3, n)
         if (present(tangent)) call give_shape(tangent, 3*n, 3*n)
         do i = 1, size(face%cells)
            if (.not. face%cells(i)%trial%traction(1) > 0.0_wp) cycle
            ! flang 19 does not pass on the absence of what is allocatable
            if (present(tangent)) then
               call add_cell_response(face, face%cells(i), pair%master, positions, forces, &
                  tangent)
            else
               call add_cell_response(face, face%cells(i), pair%master, positions, forces)
            end if
         end do
      end associate
   end subroutine face_response

   !> Zeros.
   pure subroutine give_shape(array, rows, columns)
      real(wp), allocatable, intent(inout) :: array(:, :)
      integer, intent(in) :: rows, columns

      if (allocated(array)) then
         if (any(shape(array) /= [rows, columns])) deallocate (array)
      end if
      if (.not. allocated(array)) allocate (array(rows, columns))
      array = 0.0_wp
   end subroutine give_shape

end module asperity_solid_contact_response
