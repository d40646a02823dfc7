!> The master face of a spring is left only by a margin.
module test_calculix_master_faces
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: know_pairs
   use asperity_calculix_interactions, only: add_interaction, interaction_type
   use asperity_calculix_master_faces, only: keep_faces, margin
   use funit, only: assertEqual, TestMethod, TestSuite
   implicit none
   private
   public :: suite_master_faces

   !> Two quadrilaterals side by side, 10 long, nodes 1 to 6, a triangle behind them, 2 5 7, and a
   !> slave node, 8
   integer, parameter :: left(4) = [1, 2, 5, 4], right(4) = [2, 3, 6, 5], behind(3) = [4, 5, 7]
   integer, parameter :: slave = 8
   !> Calls of `face_kept`
   integer :: calls = 0

contains

   function suite_master_faces() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('master faces')
      call suite%addTest(TestMethod('left only by the margin', test_margin))
      call suite%addTest(TestMethod('at the rim of the surface', test_rim))
      call suite%addTest(TestMethod('after a cut', test_cut))
      call suite%addTest(TestMethod('of another kind of face', test_kinds))
      call suite%addTest(TestMethod('springs of others are not touched', test_others))
   end function suite_master_faces

   !> The face of the spring when the slave node is at x and the solver found that face; 0 for none.
   function face_kept(x, found, material, depth, now) result(face)
      real(wp), intent(in) :: x
      !> Penetration, 0.1 unless given
      real(wp), intent(in), optional :: depth
      !> Step, increment and number of cuts; every call is another increment unless given
      integer, intent(in), optional :: now(3)
      integer, intent(in) :: found(:)
      integer, intent(in) :: material
      integer :: face(4)
      real(wp) :: co(3, 8), vold(0:3, 8)
      real(wp) :: height, area(2, 1)
      integer :: increment(3)
      integer :: kon(10), n, last, free, ipkon(2), elements(3, 2)
      character(len=8) :: lakon(2)

      height = 0.1_wp
      if (present(depth)) height = depth
      calls = calls + 1
      increment = [1, 1000 + calls, 0]
      if (present(now)) increment = now
      co = 0.0_wp
      co(1, :7) = [0.0_wp, 10.0_wp, 20.0_wp, 0.0_wp, 10.0_wp, 20.0_wp, 5.0_wp]
      co(2, :7) = [0.0_wp, 0.0_wp, 0.0_wp, 10.0_wp, 10.0_wp, 10.0_wp, 20.0_wp]
      vold = 0.0_wp
      ! half of the way by displacement
      co(:, slave) = [0.5_wp*x, 5.0_wp, -height]
      vold(1, slave) = 0.5_wp*x
      n = size(found)
      call know_pairs([material], [0, 1], [slave])
      ! an element before it
      last = 1
      free = 1
      area = 0.0_wp
      if (n > 0) then
         area = 2.5_wp
         last = 2
         ipkon(2) = free
         kon(free + 1:free + n) = found
         kon(free + n + 1:free + n + 2) = [slave, 1]
         lakon(2) = 'ESPRNGC'//achar(iachar('0') + n)
      end if
      call keep_faces(increment, 2, last, free, ipkon, kon, lakon, elements, [1, 3, 3], [slave], &
         [material], co, vold, area)
      face = 0
      if (last < 2) return
      call assertEqual(2.5_wp, area(1, 1), 0.0_wp, 'area')
      read (lakon(2)(8:8), '(i1)') n
      face(:n) = kon(ipkon(2) + 1:ipkon(2) + n)
      call check([slave, 1], kon(ipkon(2) + n + 1:ipkon(2) + n + 2), 'slave node and its number')
   end function face_kept

   subroutine prepare()
      type(interaction_type) :: interaction
      integer :: none(4)

      interaction%material = 1
      interaction%search_distance = 3.0_wp
      allocate (interaction%props(0))
      call add_interaction(interaction)
      ! far away: nothing is remembered
      none = face_kept(1000.0_wp, [integer :: ], 1)
   end subroutine prepare

   subroutine test_margin()
      real(wp) :: beyond

      call prepare()
      beyond = 5.0_wp*margin
      call check(left, face_kept(9.0_wp, left, 1), 'inside')
      call check(left, face_kept(10.0_wp + 0.9_wp*beyond, right, 1), 'outside by less')
      call check(right, face_kept(10.0_wp + 1.1_wp*beyond, right, 1), 'outside by more')
      call check(right, face_kept(10.0_wp - 0.9_wp*beyond, left, 1), 'and the same on the way back')
      call check(left, face_kept(10.0_wp - 1.1_wp*beyond, left, 1), 'by more')
   end subroutine test_margin

   !> At the rim the solver finds no face: the last one is kept, but not beyond the margin or out of
   !> the interaction's reach, and it is forgotten then.
   subroutine test_rim()
      real(wp) :: beyond

      call prepare()
      beyond = 20.0_wp + 5.0_wp*margin
      call check(right, face_kept(19.9_wp, right, 1), 'first')
      call check(right, face_kept(beyond - 0.1_wp, [integer :: ], 1), 'within the margin')
      call check([0, 0, 0, 0], face_kept(beyond + 0.1_wp, [integer :: ], 1), 'past it')
      call check([0, 0, 0, 0], face_kept(beyond - 0.1_wp, [integer :: ], 1), 'forgotten')
      call check(right, face_kept(19.9_wp, right, 1), 'found again')
      call check(right, face_kept(19.9_wp, [integer :: ], 1, -2.9_wp), 'within reach')
      call check([0, 0, 0, 0], face_kept(19.9_wp, [integer :: ], 1, -3.1_wp), 'out of reach')
   end subroutine test_rim

   !> What an iteration that went astray forgot comes back after a cut, and in the same attempt when
   !> the node does.
   subroutine test_cut()
      real(wp) :: near, far

      call prepare()
      near = 20.0_wp + 4.0_wp*margin
      far = 20.0_wp + 50.0_wp*margin
      call check(right, face_kept(19.9_wp, right, 1, now=[1, 1, 0]), 'first')
      call check(right, face_kept(near, [integer :: ], 1, now=[1, 2, 0]), 'at the rim')
      call check([0, 0, 0, 0], face_kept(far, [integer :: ], 1, now=[1, 2, 0]), 'astray')
      call check(right, face_kept(near, [integer :: ], 1, now=[1, 2, 0]), 'back')
      call check([0, 0, 0, 0], face_kept(far, [integer :: ], 1, now=[1, 2, 0]), 'astray again')
      call check(right, face_kept(near, [integer :: ], 1, now=[1, 2, 1]), 'after a cut')
      call check([0, 0, 0, 0], face_kept(far, [integer :: ], 1, now=[1, 2, 1]), 'where it went')
      call check([0, 0, 0, 0], face_kept(near, [integer :: ], 1, now=[1, 3, 0]), 'and stayed')
   end subroutine test_cut

   subroutine test_kinds()
      call prepare()
      call check(left, face_kept(9.9_wp, left, 1), 'quadrilateral')
      call check([behind, 0], face_kept(9.9_wp, behind, 1), 'then a triangle')
      call check(left, face_kept(9.9_wp, left, 1), 'and back')
   end subroutine test_kinds

   subroutine test_others()
      call prepare()
      call check(left, face_kept(9.9_wp, left, 2), 'first')
      call check(right, face_kept(10.1_wp, right, 2), 'as the solver found it')
   end subroutine test_others

   subroutine check(expected, found, what)
      integer, intent(in) :: expected(:), found(:)
      character(len=*), intent(in) :: what
      integer :: i

      do i = 1, size(expected)
         call assertEqual(expected(i), found(i), what)
      end do
   end subroutine check

end module test_calculix_master_faces
