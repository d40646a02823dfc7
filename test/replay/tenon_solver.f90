!> The solver of the tenon joint: exact derivatives, one solution, Newton against bracketing.
module test_replay_tenon_solver
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, rule_abaqus, rule_dissipative, wp
   use asperity_replay_tenon_bracketing, only: advance_search, new_root_search, root_search
   use asperity_replay_tenon_equilibrium, only: balance_tenon, search_tenon
   use asperity_replay_tenon_forces, only: evaluate_tenon, tenon_increment
   use asperity_replay_tenon_geometry, only: new_tenon_model, tenon_at_rest
   use asperity_replay_tenon_settings, only: tenon_settings
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   use tenon_cases, only: face_pair, side_pair
   implicit none
   private
   public :: suite_tenon_solver

   character(len=5), parameter :: contacts(2) = ['hard ', 'rough']

contains

   function suite_tenon_solver() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon solver')
      call suite%addTest(TestMethod('bracketing search', test_root))
      call suite%addTest(TestMethod('exact derivatives', test_derivatives))
      call suite%addTest(TestMethod('no second solution', test_restarts))
      call suite%addTest(TestMethod('bracketing finds the same balance', test_bracketing))
   end function suite_tenon_solver

   !> Rising and falling functions with a bend, a flat and a jump at their zero; and none.
   subroutine test_root()
      real(wp), parameter :: tolerances(6) = &
         [1.0e-11_wp, 1.0e-11_wp, 2.0e-9_wp, 1.0e-11_wp, 5.0e-3_wp, 0.0_wp]
      type(root_search) :: search
      integer :: i, j
      real(wp) :: x, f

      do j = 1, 6
         search = new_root_search(0.0_wp, 0.01_wp, 100.0_wp, rises=j /= 2)
         do i = 1, 200
            x = search%at
            select case (j)
            case (1)
               f = x - 3.0_wp
            case (2)
               f = 1.0_wp - x**3
            case (3)
               f = max(x - 7.0_wp, 1.0e-3_wp*(x - 7.0_wp))
            case (4)
               f = merge(x + 1.0_wp, x - 5.0_wp, x > -2.0_wp)
            case (5)
               f = (x + 20.0_wp)**5
            case default
               f = 1.0_wp
            end select
            if (abs(f) <= 1.0e-12_wp .or. search%done) exit
            call advance_search(search, f)
            if (search%failed) exit
         end do
         call assertTrue((j == 6) .eqv. search%failed, 'fails where there is no zero')
         call assertTrue(i < 150, 'ends')
         ! 1e-12 of the function, at its slope there
         if (j /= 6) call assertEqual(zero_of(j), search%at, tolerances(j), 'zero')
      end do
   end subroutine test_root

   pure real(wp) function zero_of(j)
      integer, intent(in) :: j
      real(wp), parameter :: zeros(5) = [3.0_wp, 1.0_wp, 7.0_wp, -1.0_wp, -20.0_wp]

      zero_of = zeros(j)
   end function zero_of

   !> Along a path with free play, yield and reversals the bracketing search alone comes to the
   !> balance of Newton, to what its larger tolerance allows.
   subroutine test_bracketing()
      type(tenon_increment) :: joint, again
      type(error_type), allocatable :: error
      real(wp) :: worst
      integer :: c, a, i, iterations, searched
      logical :: found
      character(len=6), parameter :: rules(2) = ['spring', 'fixed ']

      worst = 0.0_wp
      searched = 0
      iterations = 0
      do c = 1, 2
         do a = 1, 2
            call begin(tenon_settings(contact=contacts(c), axial_rule=rules(a), points=30, &
               side_points=5), joint, rule_abaqus)
            do i = 1, 15
               joint%rotation = 0.005_wp*i*sin(0.7_wp*i)
               again = joint
               call balance_tenon(joint, found, error)
               call assertTrue(found, 'Newton')
               call search_tenon(again, found, error)
               call assertTrue(found, 'bracketing')
               call worsen(worst, largest_of(again%position - joint%position))
               searched = searched + again%iterations
               iterations = iterations + joint%iterations
               call go_on(joint)
            end do
         end do
      end do
      call record('tenon.bracketing_distance', worst)
      call record('tenon.bracketing_evaluations', real(searched, wp)/60.0_wp)
      call record('tenon.newton_evaluations', real(iterations, wp)/60.0_wp)
      call assertLessThan(worst, 1.0e-6_wp, 'same balance')
   end subroutine test_bracketing

   !> A joint at rest, to be turned by the tests below.
   subroutine begin(s, joint, rule)
      type(tenon_settings), intent(in) :: s
      type(tenon_increment), intent(out) :: joint
      integer, intent(in) :: rule
      type(error_type), allocatable :: error

      call new_tenon_model(joint%model, s, face_pair(friction_rule=rule), side_pair(), error)
      call assertFalse(allocated(error), 'model')
      joint%start = tenon_at_rest(joint%model)
      joint%trial = joint%start
   end subroutine begin

   !> The balance that was found is the start of the next increment.
   subroutine go_on(joint)
      type(tenon_increment), intent(inout) :: joint

      joint%start = joint%trial
      joint%from = joint%position
      joint%iterations = 0
   end subroutine go_on

   !> Residuals of a joint when it is moved, mm.
   function residual_at(joint, offset) result(residual)
      type(tenon_increment), intent(in) :: joint
      real(wp), intent(in) :: offset(2)
      real(wp) :: residual(2)
      type(tenon_increment) :: moved
      type(error_type), allocatable :: error

      moved = joint
      moved%position = joint%position + offset
      call evaluate_tenon(moved, error)
      call assertFalse(allocated(error), 'evaluated')
      residual = moved%forces%residual
   end function residual_at

   !> Derivatives of both residuals by u and v against central differences, at random positions
   !> about the path of a joint with shoulders, for both contacts and rules and two axial rules.
   subroutine test_derivatives()
      character(len=6), parameter :: rules(2) = ['spring', 'fixed ']
      real(wp), parameter :: h = 1.0e-5_wp
      type(tenon_settings) :: s
      type(tenon_increment) :: joint
      type(error_type), allocatable :: error
      type(random_stream) :: stream
      real(wp) :: worst, offset(2), scale(2)
      integer :: c, a, f, i, j, k, first
      logical :: found

      stream = random_stream(7_int64)
      worst = 0.0_wp
      ! stiffness of the wood under a face, and times the lever
      scale = 7.0e4_wp*[1.0_wp, 650.0_wp]
      do c = 1, 2
         do a = 1, 2
            do f = rule_abaqus, rule_dissipative
               s = tenon_settings(contact=contacts(c), axial_rule=rules(a), shoulders=.true., &
                  points=30, side_points=5)
               s%wood%young_moduli(1) = 1000.0_wp
               call begin(s, joint, f)
               first = merge(2, 1, rules(a) == 'fixed')
               do i = 1, 12
                  joint%rotation = 0.04_wp*sin(0.8_wp*i)
                  do k = 1, 3
                     joint%position = joint%from + [stream%uniform(-1.0_wp, 1.0_wp), &
                        stream%uniform(-1.0_wp, 1.0_wp)]
                     if (first == 2) joint%position(1) = 0.0_wp
                     call evaluate_tenon(joint, error)
                     do j = first, 2
                        offset = merge([h, 0.0_wp], [0.0_wp, h], j == 1)
                        call worsen(worst, abs((residual_at(joint, offset) &
                           - residual_at(joint, -offset))/(2.0_wp*h) &
                           - joint%forces%jacobian(:, j))/scale)
                     end do
                  end do
                  joint%position = joint%from
                  call balance_tenon(joint, found, error)
                  call assertTrue(found, 'balance')
                  call go_on(joint)
               end do
            end do
         end do
      end do
      call record('tenon.derivatives', worst)
      ! a bend of a point within the difference leaves the share of its cell, not more
      call assertLessThan(worst, 2.0e-4_wp, 'derivatives')
   end subroutine test_derivatives

   !> From eight random places about each balance the solver comes to the same.
   subroutine test_restarts()
      type(tenon_increment) :: joint, again
      type(error_type), allocatable :: error
      type(random_stream) :: stream
      real(wp) :: worst
      integer :: c, i, k
      logical :: found

      stream = random_stream(11_int64)
      worst = 0.0_wp
      do c = 1, 2
         call begin(tenon_settings(contact=contacts(c), points=50, side_points=6), joint, &
            rule_abaqus)
         do i = 1, 60
            joint%rotation = 0.0016_wp*i*sin(0.45_wp*i)
            call balance_tenon(joint, found, error)
            call assertTrue(found, 'balance')
            again = joint
            do k = 1, 8
               again%position = joint%position + [stream%uniform(-1.0_wp, 1.0_wp), &
                  stream%uniform(-1.0_wp, 1.0_wp)]
               call balance_tenon(again, found, error)
               call assertTrue(found, 'balance again')
               call worsen(worst, largest_of(again%position - joint%position))
            end do
            if (anyExceptions()) return
            call go_on(joint)
         end do
      end do
      call record('tenon.restart_distance', worst)
      call assertLessThan(worst, 1.0e-6_wp, 'one solution')
   end subroutine test_restarts

end module test_replay_tenon_solver
