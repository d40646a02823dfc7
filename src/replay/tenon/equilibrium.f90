!> Equilibrium of the tenon joint at a rotation: Newton with the exact derivatives and a line
!> search; where that fails, a nested bracketing search.
module asperity_replay_tenon_equilibrium
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_replay_tenon_bracketing, only: advance_search, new_root_search, root_search
   use asperity_replay_tenon_forces, only: evaluate_tenon, tenon_forces, tenon_increment
   use asperity_replay_tenon_geometry, only: tenon_model
   implicit none
   private
   public :: balance_tenon, search_tenon

   !> Residual that is let pass, over strength times width times length
   real(wp), parameter :: tolerance = 1.0e-11_wp
   !> Residual at which a search that gets no further ends well
   real(wp), parameter :: worst_tolerance = 1.0e-9_wp
   integer, parameter :: max_iterations = 40, max_cuts = 12, max_search = 200
   !> Longest Newton step and farthest search, mm
   real(wp), parameter :: longest_step = 5.0_wp, farthest = 100.0_wp

contains

   !> Find u and v from a first guess in `joint%position`. `found` is false when there is no
   !> balance; `error` is set when a point cannot be evaluated.
   subroutine balance_tenon(joint, found, error)
      !> Joint
      type(tenon_increment), intent(inout) :: joint
      !> Whether there is balance
      logical, intent(out) :: found
      !> Set when a point cannot be evaluated
      type(error_type), allocatable, intent(out) :: error

      call iterate(joint, found, error)
      if (found .or. allocated(error)) return
      joint%position = joint%from
      call search_tenon(joint, found, error)
   end subroutine balance_tenon

   !> Newton with halving steps.
   subroutine iterate(joint, found, error)
      type(tenon_increment), intent(inout) :: joint
      logical, intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: small, step(2), share, size_before, last(2)
      integer :: iteration, cut
      logical :: solved

      found = .false.
      small = small_force(joint%model)
      call evaluate_tenon(joint, error)
      do iteration = 1, max_iterations
         if (allocated(error)) return
         size_before = size_of(joint)
         found = size_before <= small
         if (found) return
         call newton_step(joint%forces, step, solved)
         if (.not. solved) return
         share = min(1.0_wp, longest_step/maxval(abs(step)))
         last = joint%position
         do cut = 1, max_cuts
            joint%position = last + share*step
            call evaluate_tenon(joint, error)
            if (allocated(error)) return
            if (size_of(joint) < size_before*(1.0_wp - 1.0e-4_wp*share)) exit
            share = 0.5_wp*share
         end do
         if (cut > max_cuts) then
            ! as close as round-off lets
            found = size_of(joint) <= small*(worst_tolerance/tolerance)
            return
         end if
      end do
   end subroutine iterate

   !> Largest residual, the moment over its lever, N.
   pure real(wp) function size_of(joint)
      type(tenon_increment), intent(in) :: joint

      associate (residual => joint%forces%residual, model => joint%model)
         size_of = max(abs(residual(1)), &
            abs(residual(2))/(model%arm + 0.5_wp*model%settings%length))
      end associate
   end function size_of

   !> Solve the two equations by elimination with the larger pivot.
   pure subroutine newton_step(forces, step, solved)
      type(tenon_forces), intent(in) :: forces
      real(wp), intent(out) :: step(2)
      logical, intent(out) :: solved
      real(wp) :: determinant, scale

      associate (j => forces%jacobian, r => forces%residual)
         determinant = j(1, 1)*j(2, 2) - j(1, 2)*j(2, 1)
         scale = abs(j(1, 1)*j(2, 2)) + abs(j(1, 2)*j(2, 1))
         solved = abs(determinant) > 16.0_wp*epsilon(1.0_wp)*scale
         step = 0.0_wp
         if (solved) step = -[j(2, 2)*r(1) - j(1, 2)*r(2), j(1, 1)*r(2) - j(2, 1)*r(1)]/determinant
      end associate
      solved = solved .and. maxval(abs(step)) > 0.0_wp
   end subroutine newton_step

   !> Residual that is let pass, N.
   pure real(wp) function small_force(model)
      type(tenon_model), intent(in) :: model

      small_force = tolerance*model%settings%wood%compression_strengths(2)*model%settings%width &
         *model%settings%length
   end function small_force

   !> The same by bracketing: search v, with u found for each. R2 rises with v, R1 falls with u.
   subroutine search_tenon(joint, found, error)
      !> As for `balance_tenon`
      type(tenon_increment), intent(inout) :: joint
      logical, intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: small
      type(root_search) :: outer
      integer :: i

      small = worst_tolerance/tolerance*small_force(joint%model)
      outer = new_root_search(joint%position(2), 0.01_wp, farthest, rises=.true.)
      do i = 1, max_search
         joint%position(2) = outer%at
         call search_axially(joint, small, found, error)
         if (allocated(error) .or. .not. found) return
         found = size_of(joint) <= small
         if (found .or. outer%done) return
         call advance_search(outer, joint%forces%residual(2))
         if (outer%failed) return
      end do
   end subroutine search_tenon

   !> Search u at a given v.
   subroutine search_axially(joint, small, found, error)
      type(tenon_increment), intent(inout) :: joint
      real(wp), intent(in) :: small
      logical, intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      type(root_search) :: inner
      integer :: i

      found = .false.
      inner = new_root_search(joint%position(1), 0.01_wp, farthest, rises=.false.)
      do i = 1, max_search
         joint%position(1) = inner%at
         call evaluate_tenon(joint, error)
         if (allocated(error)) return
         ! a tenth leaves room for the moment
         found = abs(joint%forces%residual(1)) <= 0.1_wp*small
         if (found .or. inner%done) exit
         call advance_search(inner, joint%forces%residual(1))
         if (inner%failed) return
      end do
      found = .true.
   end subroutine search_axially

end module asperity_replay_tenon_equilibrium
