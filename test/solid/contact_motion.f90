!> A pair on a path: increments, work of the forces.
module contact_motion
   use asperity, only: error_type, wp
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: accept, begin_increment, contact_pair, default_cells, &
      new_contact_pair
   use contact_blocks, only: blocks
   use contact_forces, only: pair_forces
   implicit none
   private
   public :: new_motion, motion, advance, moved_master, winding_path

   !> A pair, where its nodes are, and the work done on it so far, N mm.
   type :: motion
      type(contact_pair) :: pair
      real(wp), allocatable :: x(:, :), forces(:, :)
      real(wp) :: work = 0.0_wp
   end type motion

contains

   subroutine new_motion(m, b, law)
      type(motion), intent(out) :: m
      type(blocks), intent(in) :: b
      class(solid_law), intent(in) :: law
      type(error_type), allocatable :: error

      call new_contact_pair(m%pair, 'path', b%nodes, b%slave, b%master, default_cells, law, error)
      if (allocated(error)) error stop 'the pair of the tests is refused'
      m%x = b%nodes
      allocate (m%forces(3, size(b%nodes, 2)), source=0.0_wp)
   end subroutine new_motion

   !> One increment to given places; its work by the trapezoidal rule.
   subroutine advance(m, x)
      type(motion), intent(inout) :: m
      real(wp), intent(in) :: x(:, :)
      type(error_type), allocatable :: error

      call begin_increment(m%pair, m%x, error)
      if (allocated(error)) error stop 'the law of the tests fails'
      call pair_forces(m%pair, m%x, m%forces)
      m%work = m%work + 0.5_wp*sum(m%forces*(x - m%x))
      call pair_forces(m%pair, x, m%forces)
      m%work = m%work + 0.5_wp*sum(m%forces*(x - m%x))
      call accept(m%pair)
      m%x = x
   end subroutine advance

   !> The master moved as a rigid body: by a way, and turned by small angles about its middle.
   function moved_master(b, way, angles) result(x)
      type(blocks), intent(in) :: b
      real(wp), intent(in) :: way(3), angles(3)
      real(wp) :: x(3, size(b%nodes, 2))
      real(wp) :: middle(3), r(3)
      integer :: i

      x = b%nodes
      middle = sum(x(:, b%slave_nodes + 1:), 2)/(size(x, 2) - b%slave_nodes)
      do i = b%slave_nodes + 1, size(x, 2)
         r = x(:, i) - middle
         x(:, i) = x(:, i) + way + [angles(2)*r(3) - angles(3)*r(2), &
            angles(3)*r(1) - angles(1)*r(3), angles(1)*r(2) - angles(2)*r(1)]
      end do
   end function moved_master

   !> Where the master is at a time: over a rim and back, turning, lifting off.
   function winding_path(b, time) result(x)
      type(blocks), intent(in) :: b
      real(wp), intent(in) :: time
      real(wp) :: x(3, size(b%nodes, 2))
      real(wp), parameter :: turn = 2.0_wp*acos(-1.0_wp)

      x = moved_master(b, [14.0_wp*sin(turn*time), 6.0_wp*sin(2.0_wp*turn*time), &
         0.06_wp*sin(3.0_wp*turn*time)], 0.002_wp*[sin(4.0_wp*turn*time), &
         sin(turn*time) + sin(3.0_wp*turn*time), 5.0_wp*sin(turn*time)])
   end function winding_path

end module contact_motion
