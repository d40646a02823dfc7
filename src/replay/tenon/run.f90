!> Cyclic replay of a straight tenon joint: the load programme step by step, with its ledgers.
module asperity_replay_tenon_run
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_replay_abaqus_host, only: accept_increment
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_contact, only: contact_record
   use asperity_replay_tenon_energy, only: book_increment, tenon_ledger
   use asperity_replay_tenon_equilibrium, only: balance_tenon
   use asperity_replay_tenon_geometry, only: holding_stiffness, lower, lower_shoulder, &
      new_tenon_model, other_side, side, tenon_faces => n_faces, tenon_forces, tenon_model, &
      tenon_place, upper, upper_shoulder
   use asperity_replay_tenon_load_path, only: tenon_programme
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: tenon_settings, tenon_step, tenon_point, run_tenon, tenon_progress, tenon_faces, &
      tenon_face_names, bearing_faces

   !> Names of the faces
   character(len=14), parameter :: tenon_face_names(tenon_faces) = [character(len=14) :: &
      'upper', 'lower', 'side_1', 'side_2', 'upper_shoulder', 'lower_shoulder']

   !> Faces that bear, which the sides do not
   integer, parameter :: bearing_faces(4) = [upper, lower, upper_shoulder, lower_shoulder]

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
      !> Dissipated by friction and by yield of the wood, N mm
      real(wp) :: friction = 0.0_wp, plastic = 0.0_wp
      !> Ledger of the contact-point update: what changes of pressure put into stored elastic slip,
      !> N mm; signed
      real(wp) :: elastic_slip = 0.0_wp
      !> Stored energy that left with points at the edges of the mortise, less what came, N mm.
      !> contact_work tends to change of stored + friction + plastic + edge - elastic_slip
      real(wp) :: edge = 0.0_wp
      !> Normal force of each face, N, and its frictional dissipation, N mm
      real(wp) :: face_normal(tenon_faces) = 0.0_wp, face_friction_energy(tenon_faces) = 0.0_wp
      !> Newton iterations, and how often the step was halved
      integer :: iterations = 0, halvings = 0
      !> All validity flags of the law reached so far
      integer :: validity = 0
   end type tenon_step

   !> State of one contact point at a chosen step.
   type :: tenon_point
      !> Step, face (see `tenon_face_names`), number in the face
      integer :: step = 0, face = 0, point = 0
      !> `status_open`, `status_stick` or `status_slip`
      integer :: status = 0
      !> Place in the tenon, mm: from the column face outwards, from the axis up
      real(wp) :: x = 0.0_wp, y = 0.0_wp
      !> Area that the point stands for, mm^2, as far as it is in the mortise
      real(wp) :: area = 0.0_wp
      !> Pressure and shear stresses, MPa
      real(wp) :: pressure = 0.0_wp, shear_1 = 0.0_wp, shear_2 = 0.0_wp
      !> Slip of the tenon over the mortise since the start, mm
      real(wp) :: slip_1 = 0.0_wp, slip_2 = 0.0_wp
      !> Permanent indentation of the wood, mm
      real(wp) :: indentation = 0.0_wp
   end type tenon_point

   !> Pull-out over length above which a warning is due, and above which a run stops
   real(wp), parameter, public :: tenon_warned_pull_out = 0.25_wp, tenon_largest_pull_out = 0.5_wp

   !> The joint within a run.
   type :: joint_state
      type(tenon_model) :: model
      !> Accepted points, and those of the last trial
      type(contact_record), allocatable :: start(:), trial(:)
      type(tenon_forces) :: forces
      type(tenon_ledger) :: ledger
      !> u and v, mm; rotation, rad
      real(wp) :: position(2) = 0.0_wp, rotation = 0.0_wp
      !> Their change by rotation in the last increment, mm/rad, and its sense; 0: there was none
      real(wp) :: course(2) = 0.0_wp, sense = 0.0_wp
      real(wp) :: work = 0.0_wp, axial_work = 0.0_wp, holding_work = 0.0_wp
      integer :: iterations = 0, halvings = 0
   end type joint_state

   !> A step is halved at most so often
   integer, parameter :: max_halvings = 12

   abstract interface
      !> Told after every step.
      subroutine tenon_progress(done, amount)
         implicit none
         !> Steps done, and in all
         integer, intent(in) :: done, amount
      end subroutine tenon_progress
   end interface

contains

   !> Replay the joint. `steps` is allocated from 0; after a failure it ends with the last good
   !> step, so that the displacements up to the next one replay the failure.
   subroutine run_tenon(settings, faces, sides, steps, error, record_at, points, progress)
      !> Joint and programme
      type(tenon_settings), intent(in) :: settings
      !> Contact of the upper and lower face and the shoulders, and of the two sides
      type(contact_properties), intent(in) :: faces, sides
      !> The joint at rest, then every step
      type(tenon_step), allocatable, intent(out) :: steps(:)
      !> Set when a setting is refused or a step cannot be solved
      type(error_type), allocatable, intent(out) :: error
      !> Steps at which every point is recorded
      integer, intent(in), optional :: record_at(:)
      !> What was recorded, step after step
      type(tenon_point), allocatable, intent(out), optional :: points(:)
      !> Told after every step
      procedure(tenon_progress), optional :: progress

      type(joint_state) :: joint
      type(tenon_step), allocatable :: done(:)
      real(wp), allocatable :: path(:)
      integer, allocatable :: cycle_of(:)
      integer :: i

      if (present(points)) allocate (points(0))
      allocate (steps(0))
      call check_tenon_settings(settings, error)
      if (allocated(error)) return
      call new_tenon_model(joint%model, settings, faces, sides, error)
      if (allocated(error)) return
      call tenon_programme(settings, path, cycle_of)
      call check_work(to_text(size(path))//' steps', &
         2_int64*int(storage_size(steps)/8, int64)*size(path), error)
      if (.not. allocated(error)) call rest(joint, error)
      if (.not. allocated(error)) deallocate (steps)
      allocate (done(0:ubound(path, 1)))
      do i = 0, ubound(path, 1)
         if (allocated(error)) exit
         if (i > 0) call advance(joint, path(i)/settings%arm, error)
         if (allocated(error)) then
            error%message = 'step '//to_text(i)//', displacement '//to_text(path(i), 6)//' mm: '// &
               error%message
            exit
         end if
         done(i) = step_of(joint, i, cycle_of(i), path(i))
         if (i > 0) done(i)%validity = ior(done(i)%validity, done(i - 1)%validity)
         if (present(points) .and. present(record_at)) then
            if (any(record_at == i)) call record_points(joint, i, points)
         end if
         if (present(progress)) call progress(i, ubound(path, 1))
         call check_pull_out(joint, i, path(i), error)
      end do
      if (.not. allocated(steps)) then
         allocate (steps(0:i - 1))
         steps(:) = done(:i - 1)
      end if
   end subroutine run_tenon

   !> The joint at rest: balance without rotation, from fresh points.
   subroutine rest(joint, error)
      type(joint_state), intent(inout) :: joint
      type(error_type), allocatable, intent(out) :: error
      logical :: found
      integer :: i

      associate (model => joint%model)
         allocate (joint%start(size(model%x)), joint%trial(size(model%x)))
         do i = 1, size(model%x)
            joint%start(i)%place = tenon_place(model%x(i), model%y(i), joint%position, 0.0_wp)
         end do
      end associate
      joint%trial = joint%start
      call balance_tenon(joint%model, joint%start, joint%position, 0.0_wp, joint%position, &
         joint%trial, joint%forces, joint%iterations, found, error)
      if (allocated(error)) return
      if (.not. found) then
         call fatal_error(error, 'no equilibrium at rest: check clearances and the axial rule', &
            computation_error)
         return
      end if
      call accept(joint)
      ! work is counted from here, what is stored stays
      joint%ledger = tenon_ledger(stored=joint%ledger%stored, normal=joint%ledger%normal)
   end subroutine rest

   !> One step to a rotation; halved where no balance is found.
   subroutine advance(joint, rotation, error)
      type(joint_state), intent(inout) :: joint
      real(wp), intent(in) :: rotation
      type(error_type), allocatable, intent(out) :: error
      type(tenon_forces) :: forces
      real(wp) :: from, to, part, position(2)
      integer :: halvings
      logical :: found

      joint%iterations = 0
      joint%halvings = 0
      from = joint%rotation
      part = 1.0_wp
      halvings = 0
      do
         to = rotation
         if (part < 1.0_wp) to = joint%rotation + part*(rotation - joint%rotation)
         position = joint%position
         ! the motion goes on as it did, unless it turns back
         if ((to - joint%rotation)*joint%sense > 0.0_wp) &
            position = position + joint%course*(to - joint%rotation)
         call balance_tenon(joint%model, joint%start, joint%position, to, position, joint%trial, &
            forces, joint%iterations, found, error)
         if (allocated(error)) return
         if (found) then
            call book_load(joint, forces, position, to)
            call accept(joint)
            if (part >= 1.0_wp) return
            part = min(1.0_wp, 2.0_wp*part)
            halvings = max(halvings - 1, 0)
         else
            part = 0.5_wp*part
            halvings = halvings + 1
            joint%halvings = joint%halvings + 1
            if (halvings > max_halvings) then
               call fatal_error(error, 'no equilibrium near rotation '//to_text(to, 6)// &
                  ' rad even with steps halved '//to_text(max_halvings)//' times; try a '// &
                  'smaller displacement_increment, a stiffer axial rule or side pressure', &
                  computation_error)
               return
            end if
         end if
      end do
   end subroutine advance

   !> Work of the load, of the axial rule and of what holds an open joint.
   subroutine book_load(joint, forces, position, rotation)
      type(joint_state), intent(inout) :: joint
      type(tenon_forces), intent(in) :: forces
      real(wp), intent(in) :: position(2), rotation
      real(wp) :: motion(2), lift

      motion = position - joint%position
      lift = motion(2) + joint%model%arm*(sin(rotation) - sin(joint%rotation))
      joint%work = joint%work - 0.5_wp*(joint%forces%vertical + forces%vertical)*lift
      joint%axial_work = joint%axial_work &
         - 0.5_wp*(joint%forces%axial + forces%axial)*motion(1)
      joint%holding_work = joint%holding_work &
         + 0.5_wp*holding_stiffness*dot_product(motion, motion)
      joint%sense = rotation - joint%rotation
      joint%course = 0.0_wp
      if (abs(joint%sense) > 0.0_wp) joint%course = motion/joint%sense
      joint%forces = forces
      joint%position = position
      joint%rotation = rotation
   end subroutine book_load

   !> The trial becomes the start of what follows.
   subroutine accept(joint)
      type(joint_state), intent(inout) :: joint
      integer :: i

      call book_increment(joint%model, joint%start, joint%trial, joint%ledger)
      joint%start = joint%trial
      if (.not. allocated(joint%model%hosts)) return
      do i = 1, size(joint%model%hosts)
         call accept_increment(joint%model%hosts(i))
      end do
   end subroutine accept

   !> What stands in the table of steps.
   pure function step_of(joint, number, cycle, displacement) result(step)
      type(joint_state), intent(in) :: joint
      integer, intent(in) :: number, cycle
      real(wp), intent(in) :: displacement
      type(tenon_step) :: step
      integer :: i

      step%step = number
      step%cycle = cycle
      step%displacement = displacement
      step%rotation = joint%rotation
      step%force = -joint%forces%vertical
      step%moment = step%force*joint%model%settings%arm
      step%pull_out = joint%position(1)
      step%vertical = joint%position(2)
      step%axial_force = joint%forces%axial
      step%work = joint%work
      step%axial_work = joint%axial_work
      step%holding_work = joint%holding_work
      associate (ledger => joint%ledger)
         step%contact_work = ledger%contact_work
         step%stored = ledger%stored
         step%friction = sum(ledger%friction)
         step%plastic = ledger%plastic
         step%elastic_slip = ledger%elastic_slip
         step%edge = ledger%edge
         step%face_normal = ledger%normal
         step%face_friction_energy = ledger%friction
      end associate
      step%iterations = joint%iterations
      step%halvings = joint%halvings
      do i = 1, size(joint%start)
         step%validity = ior(step%validity, joint%start(i)%state%validity)
      end do
   end function step_of

   !> `error` is set when the tenon is half out.
   pure subroutine check_pull_out(joint, number, displacement, error)
      type(joint_state), intent(in) :: joint
      integer, intent(in) :: number
      real(wp), intent(in) :: displacement
      type(error_type), allocatable, intent(out) :: error

      associate (length => joint%model%settings%length)
         if (abs(joint%position(1)) > tenon_largest_pull_out*length) call fatal_error(error, &
            'step '//to_text(number)//', displacement '//to_text(displacement, 6)// &
            ' mm: the tenon has moved '//to_text(joint%position(1), 4)//' mm along its axis, '// &
            'more than half its length: the overlap, not the contact, governs; hold it by '// &
            'axial_rule or side_pressure', computation_error)
      end associate
   end subroutine check_pull_out

   !> Append the state of every point; both sides are given, which are alike.
   subroutine record_points(joint, number, points)
      type(joint_state), intent(in) :: joint
      integer, intent(in) :: number
      type(tenon_point), allocatable, intent(inout) :: points(:)
      type(tenon_point), allocatable :: grown(:)
      type(tenon_point) :: point
      integer :: i, n, first(tenon_faces), next

      next = size(points)
      associate (model => joint%model)
         n = size(model%x) + count(model%face == side)
         allocate (grown(next + n))
         grown(:next) = points
         first = 0
         do i = 1, size(model%x)
            first(model%face(i)) = first(model%face(i)) + 1
            associate (s => joint%start(i))
               point = tenon_point(step=number, face=model%face(i), point=first(model%face(i)), &
                  status=s%state%status, x=model%x(i), y=model%y(i), &
                  area=model%area(i)*s%weight, pressure=s%state%pressure, shear_1=s%shear(1), &
                  shear_2=s%shear(2), slip_1=s%slip(1), slip_2=s%slip(2), &
                  indentation=sum(s%indentation))
            end associate
            if (point%face == side) point%area = 0.5_wp*point%area
            next = next + 1
            grown(next) = point
         end do
         do i = size(points) + 1, size(points) + size(model%x)
            if (grown(i)%face /= side) cycle
            next = next + 1
            grown(next) = grown(i)
            grown(next)%face = other_side
         end do
      end associate
      call move_alloc(grown, points)
   end subroutine record_points

end module asperity_replay_tenon_run
