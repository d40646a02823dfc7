!> The tenon joint on its way: put to rest, turned step by step, with its ledgers.
module asperity_replay_tenon_joint
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_tenon_energy, only: book_increment, tenon_ledger
   use asperity_replay_tenon_equilibrium, only: balance_tenon
   use asperity_replay_tenon_forces, only: holding_stiffness, tenon_forces, tenon_increment
   use asperity_replay_tenon_geometry, only: tenon_at_rest
   use asperity_replay_tenon_motions, only: add_motions, start_motions, tenon_motions
   implicit none
   private
   public :: joint_state, rest_joint, turn_joint

   !> The joint within a run.
   type :: joint_state
      !> Where it is, and the increment that is tried
      type(tenon_increment) :: at
      !> Forces and rotation, rad, that were accepted last
      type(tenon_forces) :: forces
      real(wp) :: rotation = 0.0_wp
      !> Change of u and v by rotation in the last increment, mm/rad, and its sense; 0: there was
      !> none
      real(wp) :: course(2) = 0.0_wp, sense = 0.0_wp
      !> Energies since rest, N mm: of the points, and the work of the load, of the axial rule and
      !> of what holds an open joint
      type(tenon_ledger) :: ledger
      real(wp) :: work = 0.0_wp, axial_work = 0.0_wp, holding_work = 0.0_wp
      !> How often the step was halved
      integer :: halvings = 0
      !> Motions of all points, where they are kept
      type(tenon_motions), allocatable :: motions
   end type joint_state

   !> A step is halved at most so often
   integer, parameter :: max_halvings = 12

contains

   !> The joint at rest: balance without rotation, from points that nothing has touched.
   subroutine rest_joint(joint, error)
      !> The joint; its model is set
      type(joint_state), intent(inout) :: joint
      !> Set when there is no balance
      type(error_type), allocatable, intent(out) :: error
      logical :: found

      joint%at%start = tenon_at_rest(joint%at%model)
      joint%at%trial = joint%at%start
      if (allocated(joint%motions)) call start_motions(joint%motions, size(joint%at%start))
      joint%at%rests = .true.
      call balance_tenon(joint%at, found, error)
      joint%at%rests = .false.
      if (allocated(error)) return
      if (.not. found) then
         call fatal_error(error, 'no equilibrium at rest: check clearances and the axial rule', &
            computation_error)
         return
      end if
      joint%forces = joint%at%forces
      call accept(joint, error)
      if (allocated(error)) return
      ! work is counted from here, what is stored stays
      joint%ledger = tenon_ledger(stored=joint%ledger%stored, normal=joint%ledger%normal)
   end subroutine rest_joint

   !> One step to a rotation; halved where no balance is found.
   subroutine turn_joint(joint, rotation, error)
      !> The joint
      type(joint_state), intent(inout) :: joint
      !> Rotation at the end of the step, rad
      real(wp), intent(in) :: rotation
      !> Set when there is no balance
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: part
      integer :: halvings
      logical :: found

      joint%at%iterations = 0
      joint%halvings = 0
      part = 1.0_wp
      halvings = 0
      associate (at => joint%at)
         do
            at%rotation = rotation
            if (part < 1.0_wp) at%rotation = joint%rotation + part*(rotation - joint%rotation)
            at%position = at%from
            ! the motion goes on as it did, unless it turns back
            if ((at%rotation - joint%rotation)*joint%sense > 0.0_wp) &
               at%position = at%position + joint%course*(at%rotation - joint%rotation)
            call balance_tenon(at, found, error)
            if (allocated(error)) return
            if (found) then
               call book_load(joint)
               call accept(joint, error)
               if (part >= 1.0_wp .or. allocated(error)) return
               part = min(1.0_wp, 2.0_wp*part)
               halvings = max(halvings - 1, 0)
            else
               part = 0.5_wp*part
               halvings = halvings + 1
               joint%halvings = joint%halvings + 1
               if (halvings > max_halvings) then
                  call fatal_error(error, 'no equilibrium near rotation '// &
                     to_text(at%rotation, 6)//' rad even with steps halved '// &
                     to_text(max_halvings)//' times; try a smaller displacement_increment, a '// &
                     'stiffer axial rule or side pressure', computation_error)
                  return
               end if
            end if
         end do
      end associate
   end subroutine turn_joint

   !> Work of the load, of the axial rule and of what holds an open joint.
   subroutine book_load(joint)
      type(joint_state), intent(inout) :: joint
      real(wp) :: motion(2), lift

      associate (forces => joint%at%forces)
         motion = joint%at%position - joint%at%from
         lift = motion(2) + joint%at%model%arm*(sin(joint%at%rotation) - sin(joint%rotation))
         joint%work = joint%work - 0.5_wp*(joint%forces%vertical + forces%vertical)*lift
         joint%axial_work = joint%axial_work &
            - 0.5_wp*(joint%forces%axial + forces%axial)*motion(1)
         joint%holding_work = joint%holding_work &
            + 0.5_wp*holding_stiffness*dot_product(motion, motion)
         joint%sense = joint%at%rotation - joint%rotation
         joint%course = 0.0_wp
         if (abs(joint%sense) > 0.0_wp) joint%course = motion/joint%sense
         joint%forces = forces
         joint%rotation = joint%at%rotation
      end associate
   end subroutine book_load

   !> What was tried becomes the start of what follows.
   subroutine accept(joint, error)
      type(joint_state), intent(inout) :: joint
      type(error_type), allocatable, intent(out) :: error

      associate (at => joint%at)
         if (allocated(joint%motions)) call add_motions(joint%motions, at, error)
         call book_increment(at%model, at%start, at%trial, joint%ledger)
         at%start = at%trial
         at%from = at%position
         call at%model%law%accept()
      end associate
   end subroutine accept

end module asperity_replay_tenon_joint
