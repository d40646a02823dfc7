!> States of many contact points: fresh, set and read; and what their update refuses.
module test_contact_states
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_state, contact_states, error_type, &
      get_contact_state, input_error, new_contact_states, set_contact_state, valid, wp
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use points_cases, only: call_arguments, numbers_of, random_arguments, update
   use random_inputs, only: random_stream
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_contact_states

   integer(int64), parameter :: seed = 16180342_int64

contains

   function suite_contact_states() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact states')
      call suite%addTest(TestMethod('fresh, set and read', test_states))
      call suite%addTest(TestMethod('wrong extents are refused', test_extents))
      call suite%addTest(TestMethod('states that were never built', test_never_built))
      call suite%addTest(TestMethod('a negative number of points is refused', test_negative))
   end function suite_contact_states

   !> Each point has its own place; building again forgets.
   subroutine test_states()
      integer, parameter :: points = 7
      type(contact_states) :: states
      type(contact_state) :: wanted, found
      type(error_type), allocatable :: error
      integer :: i, round

      do round = 1, 2
         call new_contact_states(states, points, error)
         call assertFalse(allocated(error), 'built')
         do i = 1, points
            found = get_contact_state(states, i)
            call assertEqual(numbers_of(contact_state()), numbers_of(found), 0.0_wp, 'fresh')
         end do
         do i = points, 1, -1
            call set_contact_state(states, i, numbered(i))
         end do
         do i = 1, points
            found = get_contact_state(states, i)
            wanted = numbered(i)
            call assertEqual(numbers_of(wanted), numbers_of(found), 0.0_wp, 'as set')
         end do
      end do
      call assertEqual(valid, 0, 'nothing to remark is zero')
   end subroutine test_states

   !> Every dimension of every array, one too large and one too small, with the optional arrays and
   !> without: the message names it, and the states stay.
   subroutine test_extents()
      integer, parameter :: points = 4
      character(len=*), parameter :: names(10) = [character(len=19) :: 'overclosure', &
         'slip_increment', 'traction', 'rotation', 'tangent', 'tangential_energy', 'dissipation', &
         'pressure_coupling', 'validity', 'plastic_dissipation']
      integer, parameter :: ranks(10) = [1, 2, 2, 3, 3, 1, 1, 1, 1, 1]
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_states) :: states
      type(call_arguments) :: a
      type(contact_state) :: found
      type(error_type), allocatable :: error
      integer :: array, dimension, change, extents(3), i
      character(len=120) :: message

      stream = random_stream(seed)
      p = pair_properties()
      call new_contact_states(states, points, error)
      do i = 1, points
         call set_contact_state(states, i, numbered(i))
      end do
      do array = 1, 9
         do dimension = 1, ranks(array)
            do change = -1, 1, 2
               call random_arguments(stream, p, points, a)
               extents = [points, 2, 2]
               if (names(array) == 'traction' .or. names(array) == 'tangent') extents(2:) = 3
               write (message, '(2a, i0, a, i0, a, i0, a)') trim(names(array)), &
                  ' has the extent ', extents(dimension) + change, ' in dimension ', dimension, &
                  ', not ', extents(dimension), ': states of 4 points were given'
               extents(dimension) = extents(dimension) + change
               call resize(a, array, extents)
               call update(p, states, a, error)
               call expect(error, trim(message))
               call leave_out_others(a, array)
               call update(p, states, a, error)
               call expect(error, trim(message))
               do i = 1, points
                  found = get_contact_state(states, i)
                  call assertEqual(numbers_of(numbered(i)), numbers_of(found), 0.0_wp, 'unchanged')
               end do
            end do
         end do
      end do
   end subroutine test_extents

   !> States that were never built are those of no points.
   subroutine test_never_built()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_states) :: states
      type(call_arguments) :: a
      type(error_type), allocatable :: error

      stream = random_stream(seed + 1)
      p = pair_properties()
      call random_arguments(stream, p, 1, a)
      call update(p, states, a, error)
      call expect(error, 'overclosure has the extent 1 in dimension 1, not 0: states of 0 '// &
         'points were given')
      call random_arguments(stream, p, 0, a)
      call update(p, states, a, error)
      call assertFalse(allocated(error), 'no points')
   end subroutine test_never_built

   subroutine test_negative()
      type(contact_states) :: states
      type(error_type), allocatable :: error

      call new_contact_states(states, 3, error)
      call new_contact_states(states, -1, error)
      call expect(error, 'points = -1 is not allowed: the number of contact points is zero or more')
      call assertFalse(allocated(states%status), 'no states')
      call new_contact_states(states, -huge(1), error)
      call expect(error, 'points = -2147483647 is not allowed: the number of contact points is '// &
         'zero or more')
   end subroutine test_negative

   subroutine expect(error, message)
      type(error_type), allocatable, intent(in) :: error
      character(len=*), intent(in) :: message

      call assertTrue(allocated(error), message)
      if (.not. allocated(error)) return
      call assertEqual(message, error%message)
      call assertEqual(input_error, error%category, 'category')
      call assertTrue(fits_subject(error), error%message)
   end subroutine expect

   !> Take all optional arrays away but one, or none.
   subroutine leave_out_others(a, array)
      type(call_arguments), intent(inout) :: a
      integer, intent(in) :: array

      if (array /= 4) deallocate (a%rotation)
      if (array /= 5) deallocate (a%tangent)
      if (array /= 6) deallocate (a%tangential_energy)
      if (array /= 7) deallocate (a%dissipation)
      if (array /= 8) deallocate (a%coupling)
      if (array /= 9) deallocate (a%validity)
      if (array /= 10) deallocate (a%plastic)
   end subroutine leave_out_others

   !> Give one array, by its number in test_extents, other extents.
   subroutine resize(a, array, n)
      type(call_arguments), intent(inout) :: a
      integer, intent(in) :: array, n(3)
      real(wp), parameter :: zero = 0.0_wp

      select case (array)
      case (1)
         a%overclosure = spread(zero, 1, n(1))
      case (2)
         a%slip = spread(spread(zero, 1, n(1)), 2, n(2))
      case (3)
         a%traction = spread(spread(zero, 1, n(1)), 2, n(2))
      case (4)
         a%rotation = spread(spread(spread(zero, 1, n(1)), 2, n(2)), 3, n(3))
      case (5)
         a%tangent = spread(spread(spread(zero, 1, n(1)), 2, n(2)), 3, n(3))
      case (6)
         a%tangential_energy = spread(zero, 1, n(1))
      case (7)
         a%dissipation = spread(zero, 1, n(1))
      case (8)
         a%coupling = spread(zero, 1, n(1))
      case (9)
         a%validity = spread(0, 1, n(1))
      case default
         a%plastic = spread(zero, 1, n(1))
      end select
   end subroutine resize

   !> A state whose numbers all differ, and from those of other points.
   pure function numbered(i) result(state)
      integer, intent(in) :: i
      type(contact_state) :: state
      real(wp) :: x

      x = 100.0_wp*i
      state = contact_state(modulo(i, 4), x + 1.0_wp, x + 2.0_wp, x + 3.0_wp, [x + 4.0_wp, &
         x + 5.0_wp], x + 6.0_wp, x + 7.0_wp, x + 8.0_wp, i)
   end function numbered

end module test_contact_states
