!> Contact on paths: balance, rims, closing after a gap.
module test_solid_contact_paths
   use asperity, only: contact_response, contact_state, error_type, wp
   use asperity_contact_properties, only: close_pressure_ratio
   use asperity_contact_state, only: status_open
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: begin_increment
   use asperity_solid_contact_rough, only: rough_law
   use asperity_solid_small_matrices, only: cross
   use contact_blocks, only: blocks, new_blocks, turn_master
   use contact_cases, only: pair_properties
   use contact_forces, only: pair_forces
   use contact_motion, only: advance, motion, moved_master, new_motion
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertTrue, TestMethod, &
      TestSuite
   use measurements, only: record
   implicit none
   private
   public :: suite_contact_paths

   real(wp), parameter :: still(3) = 0.0_wp

contains

   function suite_contact_paths() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact paths')
      call suite%addTest(TestMethod('forces and moments balance', test_balance))
      call suite%addTest(TestMethod('a rim fades linearly', test_fade))
      call suite%addTest(TestMethod('pressure and energy of hard contact', test_hard))
      call suite%addTest(TestMethod('shear turns with the faces', test_turning))
      call suite%addTest(TestMethod('no shear before closing', test_closing))
   end function suite_contact_paths

   !> Without friction. Forces balance always; moments where faces are parallel, and up to the lever
   !> of the overclosure times the tilt where they are not.
   subroutine test_balance()
      type(rough_law) :: law
      type(motion) :: m
      type(blocks) :: b
      real(wp) :: force, moment(3), lever
      integer :: i, tilt

      law%properties = pair_properties()
      law%properties%friction_coefficient = 0.0_wp
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [7.0_wp, 3.0_wp], &
         [52.0_wp, 70.0_wp], 0.1_wp)
      call turn_master(b, 3, [30.0_wp, 30.0_wp, 0.0_wp], 0.1_wp)
      do tilt = 0, 1
         call new_motion(m, b, law)
         call advance(m, moved_master(b, [0.7_wp, -0.3_wp, 0.0_wp], &
            [0.002_wp, -0.001_wp, 0.0_wp]*tilt))
         force = sum(abs(m%forces(3, :)))
         call assertGreaterThan(force, 1000.0_wp, 'there are forces')
         call assertLessThan(maxval(abs(sum(m%forces, 2)))/force, 1.0e-14_wp, 'sum of forces')
         moment = 0.0_wp
         do i = 1, size(m%x, 2)
            moment = moment + cross(m%x(:, i), m%forces(:, i))
         end do
         lever = maxval(abs(moment))/force
         call record('solid.contact.moment_lever.'//merge('tilted  ', 'parallel', tilt == 1), lever)
         ! 0.2 mm of overclosure times 0.002
         call assertLessThan(lever, merge(4.0e-4_wp, 1.0e-13_wp, tilt == 1), 'lever, mm')
      end do
   end subroutine test_balance

   !> A master that ends over the slave: the force is the pressure times the area that they share,
   !> in one increment as in many, and falls by pressure times width per way.
   subroutine test_fade()
      type(hard_law) :: law
      type(motion) :: m
      type(blocks) :: b
      type(error_type), allocatable :: error
      real(wp), allocatable :: x(:, :), forces(:, :), tangent(:, :)
      real(wp) :: way, slope
      integer :: i, j, n

      law%properties = pair_properties()
      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 3], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.03_wp)
      call new_motion(m, b, law)
      n = size(b%nodes, 2)
      allocate (x(3, n), forces(3, n), tangent(3*n, 3*n))
      call begin_increment(m%pair, b%nodes, error)
      do i = 1, 30
         way = -1.37_wp*i
         x = moved_master(b, [way, 0.0_wp, 0.0_wp], still)
         call pair_forces(m%pair, x, forces, tangent)
         call assertEqual(20.0_wp*60.0_wp*(50.0_wp + way), sum(forces(3, :b%slave_nodes)), &
            tolerance=1.0e-8_wp, message='force in one increment')
         slope = 0.0_wp
         do j = b%slave_nodes + 1, n
            slope = slope + sum(tangent(3:3*b%slave_nodes:3, 3*j - 2))
         end do
         call assertEqual(20.0_wp*60.0_wp, slope, tolerance=1.0e-8_wp, message='its derivative')
         call advance(m, x)
         call assertEqual(20.0_wp*60.0_wp*(50.0_wp + way), sum(m%forces(3, :b%slave_nodes)), &
            tolerance=1.0e-8_wp, message='force in many')
         call begin_increment(m%pair, m%x, error)
      end do
   end subroutine test_fade

   !> The pressure is the derivative of the energy, and its own is the tangent; 40 MPa at 0.05 mm.
   subroutine test_hard()
      real(wp), parameter :: step = 1.0e-5_wp, none(2) = 0.0_wp
      real(wp), parameter :: overclosures(5) = [-0.01_wp, 0.005_wp, 0.0199_wp, 0.0201_wp, 0.05_wp]
      real(wp), parameter :: pressures(5) = [0.0_wp, 0.625_wp, 9.90025_wp, 10.1_wp, 40.0_wp]
      type(hard_law) :: law
      type(contact_response) :: low, at, high
      type(error_type), allocatable :: error
      integer :: i

      law%properties = pair_properties()
      do i = 1, size(overclosures)
         call law%update(contact_state(), overclosures(i) - step, none, low, error)
         call law%update(contact_state(), overclosures(i), none, at, error)
         call law%update(contact_state(), overclosures(i) + step, none, high, error)
         call assertEqual(pressures(i), at%traction(1), 1.0e-12_wp, 'pressure')
         call assertEqual(pressures(i), (high%normal_energy - low%normal_energy)/(2.0_wp*step), &
            1.0e-6_wp, 'energy')
         call assertEqual(at%tangent(1, 1), (high%traction(1) - low%traction(1))/(2.0_wp*step), &
            1.0e-6_wp, 'tangent')
      end do
   end subroutine test_hard

   !> Press and slide, then turn both bodies by half a radian in one increment: the shear of the
   !> next one has turned too.
   subroutine test_turning()
      type(rough_law) :: law
      type(motion) :: m
      type(blocks) :: b
      type(error_type), allocatable :: error
      real(wp), allocatable :: forces(:, :)
      real(wp), parameter :: c = cos(0.5_wp), s = sin(0.5_wp)
      real(wp), parameter :: turn(3, 3) = reshape([c, s, 0.0_wp, -s, c, 0.0_wp, 0.0_wp, 0.0_wp, &
         1.0_wp], [3, 3])

      law%properties = pair_properties()
      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 3], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.05_wp)
      call new_motion(m, b, law)
      call advance(m, moved_master(b, [0.1_wp, 0.05_wp, -0.03_wp], still))
      ! with cells cut as they will be
      call advance(m, m%x)
      forces = m%forces
      call assertGreaterThan(maxval(abs(forces(1, :))), 10.0_wp, 'there is shear')
      call advance(m, matmul(turn, m%x))
      call assertEqual(0.0_wp, maxval(abs(m%forces - forces)), &
         tolerance=1.0e-9_wp*maxval(abs(forces)), message='directions are those of the start')
      call begin_increment(m%pair, m%x, error)
      call pair_forces(m%pair, m%x, m%forces)
      call assertEqual(0.0_wp, maxval(abs(m%forces - matmul(turn, forces))), &
         tolerance=1.0e-9_wp*maxval(abs(forces)), message='then they turn')
   end subroutine test_turning

   !> Press, slide, lift far in one step, drag in the gap, and close again on a slanting way: the
   !> elastic slip is the motion after closing, in one step and in a hundred, for points that are
   !> fresh and for those that have a past.
   subroutine test_closing()
      type(hard_law) :: hard
      type(rough_law) :: rough
      type(error_type), allocatable :: error
      real(wp) :: separation

      hard%properties = pair_properties()
      call close_again(hard, 0.0_wp)
      rough%properties = pair_properties()
      associate (p => rough%properties)
         call separation_for_pressure(p%normal, close_pressure_ratio*p%p_open, separation, error)
         call close_again(rough, p%initial_separation - separation)
      end associate
   end subroutine test_closing

   subroutine close_again(law, closing)
      class(solid_law), intent(in) :: law
      real(wp), intent(in) :: closing
      real(wp), parameter :: height = 5.0_wp, depth = 0.04_wp, slide = 8.0_wp
      type(blocks) :: b
      type(motion) :: m
      real(wp) :: slip(2)
      integer :: i, k, steps

      b = new_blocks([1, 1], [0.0_wp, 0.0_wp], [30.0_wp, 30.0_wp], [4, 5], [-40.0_wp, -40.0_wp], &
         [70.0_wp, 70.0_wp], -height)
      do k = 1, 2
         steps = merge(1, 100, k == 1)
         call new_motion(m, b, law)
         ! fresh points, far away
         call close(slip(1))
         call advance(m, moved_master(b, [slide + 3.0_wp, 1.0_wp, -height - depth], still))
         call assertGreaterThan(maxval(abs(m%forces(1, :))), 1.0_wp, 'it slides')
         call advance(m, moved_master(b, [slide + 3.0_wp, 1.0_wp, 0.0_wp], still))
         call open_now()
         do i = 1, steps
            call advance(m, moved_master(b, [(slide + 3.0_wp)*(1.0_wp - real(i, wp)/steps), &
               1.0_wp, 0.0_wp], still))
            call open_now()
         end do
         b%nodes(2, b%slave_nodes + 1:) = b%nodes(2, b%slave_nodes + 1:) + 1.0_wp
         call close(slip(2))
         b%nodes(2, b%slave_nodes + 1:) = b%nodes(2, b%slave_nodes + 1:) - 1.0_wp
         call assertEqual(slip(1), slip(2), 1.0e-12_wp, 'fresh and used points')
         ! the master goes along x
         call assertEqual(-slide*(depth - closing)/(height + depth), slip(1), &
            1.0e-12_wp, 'motion after closing')
      end do

   contains

      subroutine close(slip)
         real(wp), intent(out) :: slip
         integer :: i

         do i = 1, steps
            call advance(m, moved_master(b, [slide, 0.0_wp, -height - depth]*real(i, wp)/steps, &
               still))
         end do
         associate (cells => m%pair%faces(1)%cells)
            slip = cells(1)%start%elastic_slip(1)
            do i = 1, size(cells)
               call assertEqual([slip, 0.0_wp], cells(i)%start%elastic_slip, 1.0e-12_wp, &
                  'all alike')
            end do
         end associate
      end subroutine close

      subroutine open_now()
         call assertEqual(0.0_wp, maxval(abs(m%forces)), 0.0_wp, 'no force while open')
         associate (cells => m%pair%faces(1)%cells)
            call assertTrue(all(cells%start%status == status_open), 'open')
         end associate
      end subroutine open_now

   end subroutine close_again

end module test_solid_contact_paths
