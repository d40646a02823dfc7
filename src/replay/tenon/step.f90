!> What the replay of the tenon joint tells of a step.
module asperity_replay_tenon_step
   use asperity_base_kinds, only: wp
   use asperity_replay_tenon_geometry, only: tenon_faces
   use asperity_replay_tenon_joint, only: joint_state
   implicit none
   private
   public :: tenon_step, step_of

   !> One step of the replay; step 0 is the joint at rest. Energies are totals since step 0.
   type :: tenon_step
      !> Number of the step, and of the cycle that it belongs to (0 at rest; of a recorded history,
      !> counted by its upward passages through zero)
      integer :: step = 0, cycle = 0
      !> Displacement of the programme at the load point, mm: rotation times arm
      real(wp) :: displacement = 0.0_wp
      !> Rotation, rad; positive lifts the load point
      real(wp) :: rotation = 0.0_wp
      !> Force on the load point, N, positive up
      real(wp) :: force = 0.0_wp
      !> Moment about the datum of the arm, N mm: force times arm
      real(wp) :: moment = 0.0_wp
      !> Motion of the middle of the tenon at the column face, mm: out of the mortise, and up
      real(wp) :: pull_out = 0.0_wp, vertical = 0.0_wp
      !> Axial force on the tenon, N, positive pulls it out
      real(wp) :: axial_force = 0.0_wp
      !> Work of the load (trapezoidal rule), N mm
      real(wp) :: work = 0.0_wp
      !> Work into all contact points, into the axial rule, and into the term that keeps an open
      !> joint in place (trapezoidal rule), N mm; their sum is `work`
      real(wp) :: contact_work = 0.0_wp, axial_work = 0.0_wp, holding_work = 0.0_wp
      !> Stored energy of all points, N mm, with what was stored at rest
      real(wp) :: stored = 0.0_wp
      !> Dissipated by friction, by yield of the wood, and by yield of the faces' summits, N mm
      real(wp) :: friction = 0.0_wp, plastic = 0.0_wp, face_plastic = 0.0_wp
      !> Ledger of the contact-point update: what changes of pressure put into stored elastic slip,
      !> N mm; signed
      real(wp) :: elastic_slip = 0.0_wp
      !> Stored energy that left with points at the edges of the mortise, less what came, N mm.
      !> contact_work tends to change of stored + friction + plastic + face_plastic + edge
      !> - elastic_slip
      real(wp) :: edge = 0.0_wp
      !> Normal force of each face, N, and its frictional dissipation, N mm
      real(wp) :: face_normal(tenon_faces) = 0.0_wp, face_friction_energy(tenon_faces) = 0.0_wp
      !> Newton iterations, and how often the step was halved
      integer :: iterations = 0, halvings = 0
      !> All validity flags of the law reached so far
      integer :: validity = 0
   end type tenon_step

contains

   !> The step that a joint has come to.
   pure function step_of(joint, number, cycle, displacement) result(step)
      !> The joint
      type(joint_state), intent(in) :: joint
      !> Number of the step and of its cycle
      integer, intent(in) :: number, cycle
      !> Displacement of the programme, mm
      real(wp), intent(in) :: displacement
      type(tenon_step) :: step
      integer :: i

      step%step = number
      step%cycle = cycle
      step%displacement = displacement
      step%rotation = joint%rotation
      step%force = -joint%forces%vertical
      step%moment = step%force*joint%at%model%settings%arm
      step%pull_out = joint%at%position(1)
      step%vertical = joint%at%position(2)
      step%axial_force = joint%forces%axial
      step%work = joint%work
      step%axial_work = joint%axial_work
      step%holding_work = joint%holding_work
      associate (ledger => joint%ledger)
         step%contact_work = ledger%contact_work
         step%stored = ledger%stored
         step%friction = sum(ledger%friction)
         step%plastic = ledger%plastic
         step%face_plastic = ledger%face_plastic
         step%elastic_slip = ledger%elastic_slip
         step%edge = ledger%edge
         step%face_normal = ledger%normal
         step%face_friction_energy = ledger%friction
      end associate
      step%iterations = joint%at%iterations
      step%halvings = joint%halvings
      do i = 1, size(joint%at%start)
         step%validity = ior(step%validity, joint%at%start(i)%state%validity)
      end do
   end function step_of

end module asperity_replay_tenon_step
