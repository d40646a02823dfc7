!> Tangent of contact against differences, in random states with warped facets, rims and friction.
module test_solid_contact_tangent
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, rule_dissipative, wp
   use asperity_contact_state, only: status_slip, status_stick
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: accept, begin_increment, contact_pair, default_cells, &
      new_contact_pair
   use asperity_solid_contact_rough, only: rough_law
   use contact_blocks, only: blocks, new_blocks, turn_master
   use contact_cases, only: pair_properties
   use contact_forces, only: pair_forces
   use funit, only: assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_tangent

   integer(int64), parameter :: seed = 22360679_int64

contains

   function suite_contact_tangent() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact tangent')
      call suite%addTest(TestMethod('rough', test_rough))
      call suite%addTest(TestMethod('hard', test_hard))
   end function suite_contact_tangent

   subroutine test_rough()
      type(rough_law) :: law

      law%properties = pair_properties()
      call compare('rough', law, seed)
      law%properties = pair_properties(rule_dissipative)
      call compare('rough_dissipative', law, seed + 1)
   end subroutine test_rough

   subroutine test_hard()
      type(hard_law) :: law

      law%properties = pair_properties()
      call compare('hard', law, seed + 2)
   end subroutine test_hard

   !> An increment to a random state, and the tangent in another one.
   subroutine compare(name, law, seed)
      character(len=*), intent(in) :: name
      class(solid_law), intent(in) :: law
      integer(int64), intent(in) :: seed
      real(wp), parameter :: step = 2.0e-6_wp
      type(random_stream) :: stream
      type(blocks) :: b
      type(contact_pair) :: pair
      type(error_type), allocatable :: error
      real(wp), allocatable :: x(:, :), forces(:, :), low(:, :), high(:, :), tangent(:, :)
      real(wp), allocatable :: difference(:)
      real(wp) :: worst
      integer :: i, j, n, partly, sticking, slipping

      stream = random_stream(seed)
      write (*, '(5x, a, i0)') 'seed ', seed
      ! the master ends within the slave, at a width of cells that differs from its own
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [7.0_wp, 3.0_wp], &
         [52.0_wp, 70.0_wp], 0.12_wp)
      call turn_master(b, 3, [30.0_wp, 30.0_wp, 0.0_wp], 0.1_wp)
      call new_contact_pair(pair, name, b%nodes, b%slave, b%master, default_cells, law, error)
      n = size(b%nodes, 2)
      allocate (forces(3, n), low(3, n), high(3, n), tangent(3*n, 3*n), difference(3*n))
      x = b%nodes
      call shake(x, 0.2_wp)
      call begin_increment(pair, x, error)
      call shake(x, 0.05_wp)
      call pair_forces(pair, x, forces)
      call accept(pair)
      call begin_increment(pair, x, error)
      call shake(x, 0.05_wp)
      x(1, :b%slave_nodes) = x(1, :b%slave_nodes) + 0.25_wp
      call pair_forces(pair, x, forces, tangent)
      partly = 0
      sticking = 0
      slipping = 0
      do i = 1, size(pair%faces)
         associate (c => pair%faces(i)%cells)
            partly = partly + count(c%coverage > 0.0_wp .and. c%coverage < 1.0_wp &
               .and. c%trial%traction(1) > 0.0_wp)
            sticking = sticking + count(c%trial%status == status_stick)
            slipping = slipping + count(c%trial%status == status_slip)
         end associate
      end do
      worst = 0.0_wp
      do j = 1, n
         do i = 1, 3
            x(i, j) = x(i, j) + step
            call pair_forces(pair, x, high)
            x(i, j) = x(i, j) - 2.0_wp*step
            call pair_forces(pair, x, low)
            x(i, j) = x(i, j) + step
            difference = reshape((high - low)/(2.0_wp*step), [3*n])
            worst = max(worst, maxval(abs(difference - tangent(:, 3*j - 3 + i))))
         end do
      end do
      call record('solid.contact.tangent.'//name, worst/maxval(abs(tangent)))
      call assertGreaterThan(partly, 10, message='cells at rims')
      call assertGreaterThan(sticking, 3, message='cells that stick')
      call assertGreaterThan(slipping, 3, message='cells that slip')
      call assertLessThan(worst/maxval(abs(tangent)), 1.0e-7_wp, 'over the largest entry')

   contains

      !> Move all nodes, most within the planes.
      subroutine shake(x, height)
         real(wp), intent(inout) :: x(:, :)
         real(wp), intent(in) :: height
         integer :: i

         do i = 1, size(x, 2)
            x(:2, i) = x(:2, i) + [stream%uniform(-0.4_wp, 0.4_wp), stream%uniform(-0.4_wp, 0.4_wp)]
            x(3, i) = x(3, i) + height*stream%uniform(-0.5_wp, 0.5_wp)
         end do
      end subroutine shake

   end subroutine compare

end module test_solid_contact_tangent
