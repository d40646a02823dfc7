!> The tenon joint beside records of it that were made by known values, with noise and drift.
module test_program_fit_joint
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_types, only: fit_result, fit_settings
   use asperity_program_commands_fit_joint_problem, only: joint_force, joint_problem, &
      new_joint_problem, prepare_joint
   use asperity_program_commands_fit_joint_record, only: joint_record, thin_record
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_input_key, only: given_as_option
   use asperity_program_input_key_list, only: key_list
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_fit_joint

   !> Free keys, what the records are made with, where searches begin
   character(len=*), parameter :: names(4) = [character(len=18) :: 'clearance', 'side_pressure', &
      'bearing_depth', 'hardening_across']
   real(wp), parameter :: truth(4) = [0.5_wp, 0.4_wp, 150.0_wp, 0.05_wp]
   real(wp), parameter :: far(4) = [2.0_wp, 0.05_wp, 900.0_wp, 0.5_wp]
   real(wp), parameter :: lowest(4) = [0.02_wp, 0.01_wp, 20.0_wp, 0.001_wp], &
      highest(4) = [8.0_wp, 4.5_wp, 2000.0_wp, 0.9_wp]
   real(wp), parameter :: programme(7) = [2.0_wp, -2.0_wp, 8.0_wp, -8.0_wp, 24.0_wp, -24.0_wp, &
      0.0_wp]
   integer(int64), parameter :: seed = 16180339_int64

contains

   function suite_fit_joint() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('fit of a joint')
      call suite%addTest(TestMethod('a record is thinned evenly, its turns stay', test_thinned))
      call suite%addTest(TestMethod('the replay is smooth in its keys', test_smooth))
      call suite%addTest(TestMethod('found from far off, with noise and drift', test_found))
      call suite%addTest(TestMethod('hardening without yield is not settled', test_unsettled))
   end function suite_fit_joint

   !> A joint of few points and the places of the free keys.
   subroutine new_joint(keys, free)
      type(key_list), intent(out) :: keys
      integer, intent(out) :: free(:)
      type(tenon_case) :: case
      integer :: i

      call declare_replay_case(case, keys)
      call set_whole(keys, 'face_points', 12)
      call set_whole(keys, 'side_points', 3)
      free = [(keys%find(trim(names(i))), i=1, size(names))]
   end subroutine new_joint

   subroutine set_whole(keys, name, value)
      type(key_list), intent(inout) :: keys
      character(len=*), intent(in) :: name
      integer, intent(in) :: value

      associate (key => keys%rows(keys%find(name)))
         key%whole = value
         key%given = given_as_option
      end associate
   end subroutine set_whole

   !> Displacements through turning points, in steps of at most `step`.
   pure subroutine go_through(turns, step, path)
      real(wp), intent(in) :: turns(:), step
      real(wp), allocatable, intent(out) :: path(:)
      real(wp) :: from
      integer :: i, j, n

      path = [0.0_wp]
      from = 0.0_wp
      do i = 1, size(turns)
         n = ceiling(abs(turns(i) - from)/step)
         path = [path, [(from + (turns(i) - from)*j/n, j=1, n)]]
         from = turns(i)
      end do
   end subroutine go_through

   !> A record of the joint along turning points, with noise of a share of the largest force and a
   !> drift to another share of it.
   subroutine make_record(keys, free, turns, noise, drift, stream, made)
      type(key_list), intent(in) :: keys
      integer, intent(in) :: free(:)
      real(wp), intent(in) :: turns(:), noise, drift
      type(random_stream), intent(inout) :: stream
      type(joint_record), intent(out) :: made
      type(tenon_case) :: case
      type(error_type), allocatable :: error
      real(wp), allocatable :: path(:), force(:)
      real(wp) :: largest
      integer :: i, n

      call go_through(turns, 0.8_wp, path)
      n = size(path)
      allocate (force(n))
      made%displacement = path
      call prepare_joint(keys, free, truth, case, error)
      if (.not. allocated(error)) call joint_force(case, made, force, error)
      call assertFalse(allocated(error), 'the record is made')
      if (allocated(error)) return
      largest = maxval(abs(force))
      do i = 1, n
         force(i) = force(i) + largest*(drift*i/n + noise*stream%gaussian())
      end do
      call thin_record(made, path, force, 100)
   end subroutine make_record

   !> Largest force of each record, at all of its samples.
   pure function scale_of(records) result(scale)
      type(joint_record), intent(in) :: records(:)
      real(wp), allocatable :: scale(:)
      integer :: i, j

      scale = [((maxval(abs(records(i)%force)), j=1, size(records(i)%force)), i=1, size(records))]
   end function scale_of

   !> Fit the joint to some records from a start.
   subroutine fit(keys, free, records, starts, searches, result)
      type(key_list), intent(in) :: keys
      integer, intent(in) :: free(:)
      type(joint_record), intent(in) :: records(:)
      real(wp), intent(in) :: starts(:)
      integer, intent(in) :: searches
      type(fit_result), intent(out) :: result
      type(joint_problem) :: problem
      type(fit_parameter) :: parameters(size(free))
      type(error_type), allocatable :: error
      real(wp), allocatable :: scale(:)

      allocate (scale, source=scale_of(records))
      call new_joint_problem(problem, keys, free, records, scale)
      parameters%name = names
      parameters%start = starts
      parameters%lower = lowest
      parameters%upper = highest
      parameters%by_ratio = .true.
      call fit_least_squares(problem, size(scale), parameters, &
         fit_settings(searches=searches), result, error)
      if (allocated(error)) print '(a)', error%message
      call assertFalse(allocated(error), 'a minimum is found')
   end subroutine fit

   !> All turns stay, and no gap is longer than two even steps.
   subroutine test_thinned()
      type(joint_record) :: thin
      real(wp), allocatable :: path(:)
      integer :: i

      call go_through(programme, 0.01_wp, path)
      call thin_record(thin, path, 2.0_wp*path, 200)
      call assertEqual(size(path), thin%samples, 'samples of the record')
      call assertTrue(size(thin%force) > 150 .and. size(thin%force) < 215, 'kept')
      do i = 1, size(programme)
         call assertTrue(any(abs(thin%displacement - programme(i)) < 1.0e-12_wp), 'turn')
      end do
      call assertLessThan(maxval(abs(thin%displacement(2:) &
         - thin%displacement(:size(thin%displacement) - 1))), 2.0_wp*112.0_wp/200.0_wp, 'even')
      call assertEqual(2.0_wp*thin%displacement, thin%force, 1.0e-12_wp, 'force')
      call thin_record(thin, path(:150), path(:150), 150)
      call assertEqual(150, size(thin%force), 'a short record stays')
   end subroutine test_thinned

   !> Differences for steps of a ten-thousandth and a millionth of a key agree to a thousandth: the
   !> replay solves its steps more closely than a search needs.
   subroutine test_smooth()
      type(key_list) :: keys
      type(joint_record) :: made
      type(random_stream) :: stream
      type(joint_problem) :: problem
      real(wp), allocatable :: r(:, :)
      real(wp) :: values(4, 3), error
      logical :: failed(3)
      integer :: free(4), i

      stream = random_stream(seed)
      call new_joint(keys, free)
      call make_record(keys, free, programme, 0.0_wp, 0.0_wp, stream, made)
      if (anyExceptions()) return
      allocate (r(size(made%force), 3))
      call new_joint_problem(problem, keys, free, [made], scale_of([made]))
      do i = 1, size(truth)
         values = spread(truth, 2, 3)
         values(i, 2:) = truth(i)*(1.0_wp + [1.0e-4_wp, 1.0e-6_wp])
         call problem%several_residuals(values, r, failed)
         call assertFalse(any(failed), 'evaluated')
         call assertLessThan(maxval(abs(r(:, 1))), 2.0e-4_wp, 'its own record, in longer steps')
         r(:, 2) = (r(:, 2) - r(:, 1))/1.0e-4_wp
         r(:, 3) = (r(:, 3) - r(:, 1))/1.0e-6_wp
         error = norm2(r(:, 2) - r(:, 3))/norm2(r(:, 3))
         call record('fit.joint.difference_error.'//trim(names(i)), error)
         call assertLessThan(error, 1.0e-2_wp, 'differences of '//names(i))
      end do
   end subroutine test_smooth

   !> Four keys from starts four to ten times off, of two records with noise of 1 % of the largest
   !> force and a drift to 0.2 % of it.
   subroutine test_found()
      type(key_list) :: keys
      type(joint_record) :: records(2)
      type(random_stream) :: stream
      type(fit_result) :: result
      integer :: free(4), i

      stream = random_stream(seed + 1_int64)
      call new_joint(keys, free)
      call make_record(keys, free, programme, 0.01_wp, 0.002_wp, stream, records(1))
      call make_record(keys, free, [24.0_wp], 0.01_wp, 0.002_wp, stream, records(2))
      if (anyExceptions()) return
      call fit(keys, free, records, far, 1, result)
      if (anyExceptions()) return
      call record('fit.joint.evaluations', real(result%evaluations, wp))
      do i = 1, size(truth)
         call record('fit.joint.'//trim(names(i)), result%values(i))
         call assertLessThan(abs(log(result%values(i)/truth(i))), &
            4.0_wp*result%standard_errors(i), names(i))
      end do
      call assertLessThan(maxval(result%standard_errors), 0.2_wp, 'and sharply')
      call assertTrue(all(result%settled), 'settled')
   end subroutine test_found

   !> In loops that press nothing beyond its strength hardening does nothing.
   subroutine test_unsettled()
      type(key_list) :: keys
      type(joint_record) :: made
      type(random_stream) :: stream
      type(fit_result) :: result
      integer :: free(4)

      stream = random_stream(seed + 2_int64)
      call new_joint(keys, free)
      call make_record(keys, free, [2.0_wp, -2.0_wp, 0.0_wp], 0.01_wp, 0.0_wp, stream, made)
      if (anyExceptions()) return
      call fit(keys, free, [made], truth, 1, result)
      if (anyExceptions()) return
      call assertFalse(all(result%settled), 'something is not settled')
      call assertGreaterThan(abs(result%directions(4, 4)), 0.9_wp, 'and that is hardening')
   end subroutine test_unsettled

end module test_program_fit_joint
