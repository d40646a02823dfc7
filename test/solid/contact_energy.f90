!> Energies of contact against the work of its forces.
module test_solid_contact_energy
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: begin_increment
   use asperity_solid_contact_rough, only: rough_law
   use contact_blocks, only: blocks, new_blocks
   use contact_cases, only: pair_properties
   use contact_forces, only: pair_forces
   use contact_motion, only: advance, motion, new_motion, winding_path
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_energy

   integer(int64), parameter :: seed = 31622776_int64

contains

   function suite_contact_energy() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact energy')
      call suite%addTest(TestMethod('without friction no work is lost', test_conservative))
      call suite%addTest(TestMethod('energies add up to the work', test_ledger))
      call suite%addTest(TestMethod('energies add up to the work with memory', test_memory))
   end function suite_contact_energy

   !> Within an increment the forces have a potential, the stored energy: the work of a straight way
   !> by Gauss quadrature, and that of a triangle back to its start.
   subroutine test_conservative()
      type(rough_law) :: law
      type(motion) :: m
      type(blocks) :: b
      type(error_type), allocatable :: error
      real(wp), allocatable :: x(:, :, :), between(:, :)
      real(wp) :: work(3), stored(3)
      type(random_stream) :: stream
      integer, parameter :: panels = 8
      integer :: i, j, panel, corner, next

      stream = random_stream(seed)
      write (*, '(5x, a, i0)') 'seed ', seed
      law%properties = pair_properties()
      law%properties%friction_coefficient = 0.0_wp
      ! one facet over all: a kink between facets would spoil the quadrature
      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [40.0_wp, 40.0_wp], [1, 1], [-20.0_wp, -20.0_wp], &
         [60.0_wp, 60.0_wp], 0.1_wp)
      call new_motion(m, b, law)
      allocate (x(3, size(b%nodes, 2), 3), between(3, size(b%nodes, 2)))
      do i = 1, 3
         x(:, :, i) = b%nodes
         do j = 1, size(x, 2)
            x(:, j, i) = x(:, j, i) + [stream%uniform(-1.0_wp, 1.0_wp), &
               stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-0.1_wp, 0.1_wp)]
         end do
      end do
      call begin_increment(m%pair, x(:, :, 1), error)
      do corner = 1, 3
         next = modulo(corner, 3) + 1
         work(corner) = 0.0_wp
         do panel = 1, panels
            do i = 1, n_points
               between = x(:, :, corner) + (x(:, :, next) - x(:, :, corner)) &
                  *(panel - 0.5_wp + 0.5_wp*nodes(i))/panels
               call pair_forces(m%pair, between, m%forces)
               work(corner) = work(corner) + 0.5_wp*weights(i)/panels &
                  *sum(m%forces*(x(:, :, next) - x(:, :, corner)))
            end do
         end do
         call pair_forces(m%pair, x(:, :, next), m%forces)
         stored(next) = 0.0_wp
         do i = 1, size(m%pair%faces)
            stored(next) = stored(next) &
               + sum(m%pair%faces(i)%cells%area*m%pair%faces(i)%cells%trial%normal_energy)
         end do
      end do
      call assertGreaterThan(maxval(abs(work)), 10.0_wp, 'there is work')
      call assertEqual([stored(2) - stored(1), stored(3) - stored(2), stored(1) - stored(3)], &
         work, tolerance=1.0e-9_wp*maxval(abs(work)), message='work is the change of energy')
      call assertEqual(0.0_wp, sum(work), tolerance=1.0e-9_wp*maxval(abs(work)), &
         message='a closed path')
   end subroutine test_conservative

   !> Work of the contact forces against the ledgers, for steps of which each is half of the last:
   !> without friction the difference falls as the square of the step, with friction as the step, as
   !> the law changes the pressure of an increment before it slides.
   subroutine test_ledger()
      type(rough_law) :: law
      real(wp) :: difference(3), work, edge
      integer :: i, k

      do k = 1, 2
         law%properties = pair_properties()
         if (k == 1) law%properties%friction_coefficient = 0.0_wp
         do i = 1, 3
            call follow(law, 50*2**i, difference(i), work, edge)
         end do
         call record('solid.contact.energy_difference.'//merge('smooth  ', 'friction', k == 1), &
            difference(3)/work)
         call record('solid.contact.energy_edge.'//merge('smooth  ', 'friction', k == 1), edge/work)
         if (k == 1) call assertLessThan(50.0_wp*abs(difference(3)), abs(edge), &
            'the ledger of rims matters')
         call assertEqual(merge(4.0_wp, 2.0_wp, k == 1), difference(1)/difference(2), 0.3_wp, &
            'fall from 100 to 200 steps')
         call assertEqual(merge(4.0_wp, 2.0_wp, k == 1), difference(2)/difference(3), 0.2_wp, &
            'fall from 200 to 400 steps')
      end do
   end subroutine test_ledger

   !> The same of summits that remember, which dissipate more than the difference by far.
   subroutine test_memory()
      type(rough_law) :: law
      real(wp) :: difference(3), work, edge, plastic
      integer :: i

      law%properties = pair_properties()
      law%properties%normal%unloading = unloading_elastic
      law%properties%friction_coefficient = 0.0_wp
      do i = 1, 3
         call follow(law, 50*2**i, difference(i), work, edge, plastic)
      end do
      call record('solid.contact.energy_difference.memory', difference(3)/work)
      call record('solid.contact.energy_plastic.memory', plastic/work)
      call assertLessThan(abs(difference(3)), abs(difference(1))/8.0_wp, 'falls')
      call assertLessThan(1.0e3_wp*abs(difference(3)), plastic, 'the ledger of summits matters')
   end subroutine test_memory

   subroutine follow(law, steps, difference, work, edge, plastic)
      class(solid_law), intent(in) :: law
      integer, intent(in) :: steps
      real(wp), intent(out) :: difference, work, edge
      real(wp), intent(out), optional :: plastic
      type(blocks) :: b
      type(motion) :: m
      integer :: i

      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 3], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.08_wp)
      call new_motion(m, b, law)
      do i = 1, steps
         call advance(m, winding_path(b, 0.9_wp*i/steps))
      end do
      associate (e => m%pair%energy)
         difference = m%work - (e%normal + e%tangential + e%dissipation + e%plastic &
            - e%coupling + e%edge)
         work = m%work
         edge = e%edge
         if (present(plastic)) plastic = e%plastic
      end associate
   end subroutine follow

end module test_solid_contact_energy
