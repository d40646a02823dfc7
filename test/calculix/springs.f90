!> Contact springs of the CalculiX interface: faces, kinematics, forces, and every derivative
!> against differences.
module test_calculix_springs
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_loc, c_null_ptr, c_ptr
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: before_results, know_pairs
   use asperity_calculix_faces, only: face_point, most_nodes, project_onto_face, shape_functions
   use asperity_calculix_interactions, only: add_interaction, find_interaction, interaction_type
   use asperity_calculix_kinematics, only: find_motion, motion_type
   use asperity_calculix_spring_state, only: own_slots, slot_time
   use asperity_calculix_springs, only: evaluate_spring, fill_spring, response_type, &
      spring_force, spring_stiffness, spring_type
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertLessThan, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_springs

   integer, parameter :: kinds(4) = [3, 4, 6, 8]
   integer, parameter :: samples = 50

contains

   function suite_springs() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('springs in CalculiX')
      call suite%addTest(TestMethod('shape functions', test_shape_functions))
      call suite%addTest(TestMethod('projection', test_projection))
      call suite%addTest(TestMethod('rigid motion is no slip', test_rigid_motion))
      call suite%addTest(TestMethod('axes and slip', test_axes))
      call suite%addTest(TestMethod('stiffness against differences', test_stiffness))
      call suite%addTest(TestMethod('forces balance', test_balance))
      call suite%addTest(TestMethod('no shear from a point that was away', test_away))
   end function suite_springs

   !> Nodes of a plane face, corners first, in the order of the solver.
   function plain_face(nodes) result(x)
      integer, intent(in) :: nodes
      real(wp) :: x(3, nodes)
      integer :: i, corners

      x = 0.0_wp
      corners = merge(3, 4, nodes == 3 .or. nodes == 6)
      if (corners == 3) then
         x(1:2, :3) = 10.0_wp*reshape([0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 3])
      else
         x(1:2, :4) = 10.0_wp*reshape([0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, &
            1.0_wp], [2, 4])
      end if
      do i = corners + 1, nodes
         x(:, i) = 0.5_wp*(x(:, i - corners) + x(:, mod(i - corners, corners) + 1))
      end do
   end function plain_face

   !> A bent and turned face, and a slave node under its surface.
   subroutine random_face(stream, nodes, x)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: nodes
      real(wp), intent(out) :: x(3, nodes + 1)
      real(wp) :: axis(3), angle
      integer :: i, j

      x(:, :nodes) = plain_face(nodes)
      x(:, nodes + 1) = [stream%uniform(1.0_wp, 4.0_wp), stream%uniform(1.0_wp, 4.0_wp), &
         stream%uniform(-0.3_wp, -0.05_wp)]
      do i = 1, nodes
         do j = 1, 3
            x(j, i) = x(j, i) + stream%uniform(-0.4_wp, 0.4_wp)
         end do
      end do
      axis = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp), &
         stream%uniform(-1.0_wp, 1.0_wp)]
      angle = stream%uniform(0.0_wp, 3.0_wp)
      x = matmul(rotation_about(axis/norm2(axis), angle), x)
   end subroutine random_face

   pure function rotation_about(axis, angle) result(r)
      real(wp), intent(in) :: axis(3), angle
      real(wp) :: r(3, 3), k(3, 3)

      k = reshape([0.0_wp, axis(3), -axis(2), -axis(3), 0.0_wp, axis(1), axis(2), -axis(1), &
         0.0_wp], [3, 3])
      r = sin(angle)*k + (1.0_wp - cos(angle))*matmul(k, k)
      r(1, 1) = r(1, 1) + 1.0_wp
      r(2, 2) = r(2, 2) + 1.0_wp
      r(3, 3) = r(3, 3) + 1.0_wp
   end function rotation_about

   !> One at their own node, zero at the others, a sum of one, and derivatives as by differences.
   subroutine test_shape_functions()
      real(wp), parameter :: h = 1.0e-4_wp
      type(random_stream) :: stream
      real(wp) :: n(most_nodes, -1:1), dn(most_nodes, 2, -1:1), ddn(most_nodes, 3, -1:1), xi(2)
      real(wp) :: step(2), plain(3, 8), natural(2)
      integer :: k, m, i, j, s

      stream%state = 20261122
      do k = 1, size(kinds)
         m = kinds(k)
         plain(:, :m) = plain_face(m)
         do i = 1, m
            natural = plain(1:2, i)/10.0_wp
            if (m == 4 .or. m == 8) natural = 2.0_wp*natural - 1.0_wp
            call shape_functions(m, natural, n(:, 0), dn(:, :, 0), ddn(:, :, 0))
            do j = 1, m
               call assertEqual(merge(1.0_wp, 0.0_wp, i == j), n(j, 0), 1.0e-14_wp, 'at a node')
            end do
         end do
         xi = [stream%uniform(-0.9_wp, 0.9_wp), stream%uniform(-0.9_wp, 0.9_wp)]
         do i = 1, 2
            step = 0.0_wp
            step(i) = h
            do s = -1, 1
               call shape_functions(m, xi + s*step, n(:, s), dn(:, :, s), ddn(:, :, s))
            end do
            call assertEqual(1.0_wp, sum(n(:m, 0)), 1.0e-14_wp, 'sum')
            call assertLessThan(largest_of((n(:m, 1) - n(:m, -1))/(2.0_wp*h) - dn(:m, i, 0)), &
               1.0e-7_wp, 'first derivatives')
            do j = 1, 2
               call assertLessThan(largest_of((dn(:m, j, 1) - dn(:m, j, -1))/(2.0_wp*h) &
                  - ddn(:m, i + j - 1, 0)), 1.0e-7_wp, 'second derivatives')
            end do
         end do
      end do
   end subroutine test_shape_functions

   !> What lies above a point of a bent face along the normal projects onto it, inside and a little
   !> outside.
   subroutine test_projection()
      type(random_stream) :: stream
      type(face_point) :: point
      type(motion_type) :: motion
      real(wp) :: x(3, most_nodes + 1), start(3, most_nodes + 1)
      integer :: k, m, i

      stream%state = 77
      do k = 1, size(kinds)
         m = kinds(k)
         do i = 1, samples
            call random_face(stream, m, x(:, :m + 1))
            point = project_onto_face(x(:, :m), x(:, m + 1))
            call assertLessThan(largest_of(matmul(x(:, m + 1) - point%position, point%tangent)), &
               1.0e-11_wp, 'the gap is normal')
            start = x
            motion = find_motion(x(:, :m + 1), start(:, :m + 1))
            call assertEqual(norm2(x(:, m + 1) - point%position), abs(motion%overclosure), &
               1.0e-12_wp, 'overclosure is the distance')
            ! put it elsewhere along the normal: the same point, another distance
            x(:, m + 1) = point%position + 0.02_wp*motion%frame%axes(:, 1)
            motion = find_motion(x(:, :m + 1), start(:, :m + 1))
            call assertEqual(-0.02_wp, motion%overclosure, 1.0e-12_wp, 'outside is negative')
            call assertLessThan(largest_of(motion%frame%point%xi - point%xi), 1.0e-10_wp, &
               'same point')
         end do
      end do
   end subroutine test_projection

   !> Both turn and move together: the overclosure stays, nothing slips, and the elastic slip turns
   !> with the face.
   subroutine test_rigid_motion()
      type(random_stream) :: stream
      type(motion_type) :: motion, before
      real(wp) :: x(3, most_nodes + 1), y(3, most_nodes + 1), r(3, 3), axis(3), slip(3), turned(3)
      integer :: k, m, i

      stream%state = 3
      do k = 1, size(kinds)
         m = kinds(k)
         do i = 1, samples
            call random_face(stream, m, x(:, :m + 1))
            axis = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp), 0.5_wp]
            r = rotation_about(axis/norm2(axis), stream%uniform(-0.8_wp, 0.8_wp))
            y = matmul(r, x) + 5.0_wp
            before = find_motion(x(:, :m + 1), x(:, :m + 1))
            motion = find_motion(y(:, :m + 1), x(:, :m + 1))
            call assertEqual(before%overclosure, motion%overclosure, 1.0e-11_wp, 'overclosure')
            call assertLessThan(norm2(motion%slip), 1.0e-11_wp, 'slip')
            call assertEqual(motion%overclosure, motion%start_overclosure, 1.0e-11_wp, 'start')
            ! a vector in the face, in both systems
            slip = matmul(before%frame%axes(:, 2:), [0.3_wp, -0.2_wp])
            turned = matmul(motion%frame%axes(:, 2:), matmul(motion%rotation, [0.3_wp, -0.2_wp]))
            call assertLessThan(largest_of(turned - matmul(r, slip)), 1.0e-10_wp, 'it turns along')
         end do
      end do
   end subroutine test_rigid_motion

   !> Orthonormal, the normal first; the first slip direction from global x, or z; a slave node that
   !> slides over a flat face at rest slips by what it moved.
   subroutine test_axes()
      type(motion_type) :: motion
      real(wp) :: x(3, 5), y(3, 5), identity(3, 3)
      integer :: i

      identity = 0.0_wp
      do i = 1, 3
         identity(i, i) = 1.0_wp
      end do
      x(:, :4) = plain_face(4)
      x(:, 5) = [4.0_wp, 5.0_wp, -0.1_wp]
      y = x
      y(:, 5) = y(:, 5) + [0.4_wp, -0.3_wp, -0.02_wp]
      motion = find_motion(y, x)
      associate (axes => motion%frame%axes)
         call assertLessThan(largest_of(matmul(transpose(axes), axes) - identity), 1.0e-14_wp, &
            'orthonormal')
         call assertLessThan(largest_of(axes(:, 1) - [0.0_wp, 0.0_wp, 1.0_wp]), 1.0e-14_wp, &
            'normal')
         call assertLessThan(largest_of(axes(:, 2) - [1.0_wp, 0.0_wp, 0.0_wp]), 1.0e-14_wp, &
            'first slip direction')
      end associate
      call assertEqual(0.12_wp, motion%overclosure, 1.0e-14_wp, 'overclosure')
      call assertEqual(0.10_wp, motion%start_overclosure, 1.0e-14_wp, 'at the start')
      call assertLessThan(largest_of(motion%slip - [0.4_wp, -0.3_wp]), 1.0e-14_wp, 'slip')
      ! the normal along x
      x = x([3, 1, 2], :)
      motion = find_motion(x, x)
      associate (axes => motion%frame%axes)
         call assertLessThan(largest_of(axes(:, 1) - [1.0_wp, 0.0_wp, 0.0_wp]), 1.0e-14_wp, &
            'normal along x')
         call assertLessThan(largest_of(axes(:, 2) - [0.0_wp, 0.0_wp, 1.0_wp]), 1.0e-14_wp, &
            'then z')
      end associate
   end subroutine test_axes

   !> Stick, slip and open springs on bent faces that turn and strain, with friction from the start.
   subroutine test_stiffness()
      real(wp), parameter :: h = 1.0e-6_wp
      type(random_stream) :: stream
      real(wp) :: x(3, most_nodes + 1), y(3, most_nodes + 1), plus(3, most_nodes + 1)
      real(wp) :: start(own_slots + 11), slope(3, most_nodes + 1), scale, state(own_slots + 11)
      real(wp) :: stiffness(3*(most_nodes + 1), 3*(most_nodes + 1))
      type(response_type) :: response, ahead, behind
      integer :: k, m, i, j, c, stuck, slipping
      real(wp) :: largest

      stream%state = 4711
      stuck = 0
      slipping = 0
      largest = 0.0_wp
      do k = 1, size(kinds)
         m = kinds(k)
         do i = 1, samples
            call random_face(stream, m, x(:, :m + 1))
            y = x
            do j = 1, m + 1
               do c = 1, 3
                  y(c, j) = y(c, j) + stream%uniform(-0.02_wp, 0.02_wp)
               end do
            end do
            if (mod(i, 2) == 0) y(:, m + 1) = y(:, m + 1) + 0.6_wp*direction(y(:, :m + 1))
            start = 0.0_wp
            call evaluate(x(:, :m + 1), y(:, :m + 1), start, state, response)
            if (nint(state(own_slots + 1)) == 2) stuck = stuck + 1
            if (nint(state(own_slots + 1)) == 3) slipping = slipping + 1
            stiffness(:3*(m + 1), :3*(m + 1)) = spring_stiffness(response, 2.5_wp)
            scale = largest_of(stiffness(:3*(m + 1), :3*(m + 1)))
            do c = 1, 3*(m + 1)
               plus = y
               plus(mod(c - 1, 3) + 1, (c - 1)/3 + 1) = plus(mod(c - 1, 3) + 1, (c - 1)/3 + 1) + h
               call evaluate(x(:, :m + 1), plus(:, :m + 1), start, state, ahead)
               plus(mod(c - 1, 3) + 1, (c - 1)/3 + 1) = y(mod(c - 1, 3) + 1, (c - 1)/3 + 1) - h
               call evaluate(x(:, :m + 1), plus(:, :m + 1), start, state, behind)
               slope(:, :m + 1) = (spring_force(ahead, 2.5_wp) - spring_force(behind, 2.5_wp)) &
                  /(2.0_wp*h)
               call worsen(largest, largest_of(reshape(slope(:, :m + 1), [3*(m + 1)]) &
                  - stiffness(:3*(m + 1), c))/scale)
            end do
         end do
      end do
      print '(a, es8.1)', 'stiffness of springs against differences, relative: ', largest
      call assertLessThan(largest, 1.0e-7_wp, 'stiffness')
      call assertTrue(stuck > 20 .and. slipping > 20, 'both stick and slip were met')
   end subroutine test_stiffness

   !> A unit vector in the face.
   function direction(x) result(t)
      real(wp), intent(in) :: x(:, :)
      real(wp) :: t(3)
      type(motion_type) :: motion

      motion = find_motion(x, x)
      t = motion%frame%axes(:, 2)
   end function direction

   !> Forces of a spring add up to nothing, and so do their moments.
   subroutine test_balance()
      type(random_stream) :: stream
      real(wp) :: x(3, most_nodes + 1), y(3, most_nodes + 1), f(3, most_nodes + 1), moment(3)
      real(wp) :: start(own_slots + 11), state(own_slots + 11)
      type(response_type) :: response
      integer :: k, m, i, j

      stream%state = 12
      do k = 1, size(kinds)
         m = kinds(k)
         do i = 1, samples
            call random_face(stream, m, x(:, :m + 1))
            y = x
            y(:, m + 1) = y(:, m + 1) + 0.1_wp*direction(x(:, :m + 1))
            start = 0.0_wp
            call evaluate(x(:, :m + 1), y(:, :m + 1), start, state, response)
            f(:, :m + 1) = spring_force(response, 2.5_wp)
            call assertTrue(norm2(f(:, m + 1)) > 0.0_wp, 'there is a force')
            call assertLessThan(largest_of(sum(f(:, :m + 1), 2)), 1.0e-11_wp*norm2(f(:, m + 1)), &
               'forces')
            moment = 0.0_wp
            do j = 1, m
               moment = moment + cross(y(:, j) - response%motion%frame%point%position, f(:, j))
            end do
            call assertLessThan(largest_of(moment), 1.0e-10_wp*norm2(f(:, m + 1)), &
               'moments about the projection')
         end do
      end do
   end subroutine test_balance

   !> A spring that did not exist in the last increment has forgotten its shear, one that did has
   !> not.
   subroutine test_away()
      real(wp) :: x(3, 5), y(3, 5), start(own_slots + 11), state(own_slots + 11)
      type(response_type) :: response

      x(:, :4) = plain_face(4)
      x(:, 5) = [4.0_wp, 5.0_wp, -0.1_wp]
      y = x
      y(1, 5) = y(1, 5) + 0.2_wp
      start = 0.0_wp
      call evaluate(x, y, start, state, response)
      call assertTrue(response%stress(2) > 0.01_wp, 'there is shear')
      call assertEqual(1.0_wp, state(slot_time), 1.0e-14_wp, 'stamped')
      start = state
      ! the host stands at 0 to 1: an increment that ended at 0 came directly before
      start(slot_time) = 0.0_wp
      call evaluate(y, y, start, state, response)
      call assertTrue(response%stress(2) > 0.01_wp, 'kept')
      start(slot_time) = -0.5_wp
      call evaluate(y, y, start, state, response)
      call assertEqual(0.0_wp, response%stress(2), 1.0e-14_wp, 'forgotten')
   end subroutine test_away

   pure function cross(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)

      c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
   end function cross

   !> One spring from one set of positions to another in an increment from 0 to 1, with the law of
   !> the transverse-tangential pair.
   subroutine evaluate(from, to, start, state, response)
      real(wp), intent(in) :: from(:, :), to(:, :), start(:)
      real(wp), intent(out) :: state(:)
      type(response_type), intent(out) :: response
      real(wp), target :: vini(4, most_nodes + 1), time, dtime, ttime
      integer(c_int), target :: istep, iinc
      character(kind=c_char), target :: names(80), pairs(3*81)
      type(interaction_type) :: interaction
      type(spring_type) :: spring
      integer :: i, n

      n = size(from, 2)
      interaction%material = 1
      interaction%depvar = 11
      interaction%search_distance = 3.0_wp
      interaction%props = [0.5_wp, 0.31_wp, 206.0_wp, 297.0_wp, 3.14159265_wp, 0.1477_wp, &
         24.53_wp, 0.4_wp, 0.0593_wp, 0.2372_wp]
      call add_interaction(interaction)
      vini = 0.0_wp
      time = 1.0_wp
      dtime = 1.0_wp
      ttime = 0.0_wp
      istep = 1
      iinc = 1
      names = ' '
      pairs = ' '
      call before_results(c_loc(vini), [1, 3], most_nodes + 1, c_loc(time), c_loc(dtime), &
         c_loc(ttime), c_loc(istep), c_loc(iinc), 0, 0, c_loc(names), c_loc(pairs), 1, 1, 0, &
         c_null_ptr, c_null_ptr, 0)
      call fill_spring(spring, find_interaction(1), from, to_displacements(from, to), &
         [(i, i=1, n), 1], 2.5_wp, 1)
      call know_pairs([0], [0, 1], [n])
      call evaluate_spring(spring, start, state, response)
   end subroutine evaluate

   !> Displacements as the solver has them, the temperature first.
   pure function to_displacements(from, to) result(v)
      real(wp), intent(in) :: from(:, :), to(:, :)
      real(wp) :: v(4, size(from, 2))

      v(1, :) = 0.0_wp
      v(2:, :) = to - from
   end function to_displacements

end module test_calculix_springs
