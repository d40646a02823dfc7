!> Forces of all faces of a pair together.
module contact_forces
   use asperity, only: error_type, wp
   use asperity_solid_contact_pair, only: contact_pair
   use asperity_solid_contact_response, only: face_response
   implicit none
   private
   public :: pair_forces

contains

   !> Internal forces on all nodes, and their derivative by all places.
   subroutine pair_forces(pair, positions, forces, tangent)
      type(contact_pair), intent(inout) :: pair
      real(wp), intent(in) :: positions(:, :)
      real(wp), intent(out) :: forces(:, :)
      real(wp), intent(out), optional :: tangent(:, :)
      type(error_type), allocatable :: error
      real(wp), allocatable :: f(:, :), k(:, :)
      integer :: i, j, m, n

      forces = 0.0_wp
      if (present(tangent)) tangent = 0.0_wp
      do i = 1, size(pair%faces)
         if (present(tangent)) then
            call face_response(pair, i, positions, f, error, k)
         else
            call face_response(pair, i, positions, f, error)
         end if
         if (allocated(error)) error stop 'the law of the tests fails'
         associate (nodes => pair%faces(i)%nodes)
            do j = 1, size(nodes)
               forces(:, nodes(j)) = forces(:, nodes(j)) + f(:, j)
               if (.not. present(tangent)) cycle
               do m = 1, size(nodes)
                  do n = 1, 3
                     tangent(3*nodes(m) - 2:3*nodes(m), 3*nodes(j) - 3 + n) = &
                        tangent(3*nodes(m) - 2:3*nodes(m), 3*nodes(j) - 3 + n) &
                        + k(3*m - 2:3*m, 3*j - 3 + n)
                  end do
               end do
            end do
         end associate
      end do
   end subroutine pair_forces

end module contact_forces
