!> The keys of a tenon joint, its case for replay and deck: faces, sides, sizes, programme.
module asperity_program_commands_tenon_joint_keys
   use asperity_base_checks, only: check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_contact_friction_settings, only: largest_friction, stick_summits
   use asperity_contact_properties, only: contact_properties
   use asperity_paper_joint, only: joint_amplitudes, joint_cycles
   use asperity_program_commands_faces_friction_keys, only: declare_friction, &
      declare_shear_modulus, friction_of_sides
   use asperity_program_commands_faces_properties, only: critical_slip, friction_coefficient
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_tenon_bearing_keys, only: declare_bearing, &
      declare_points
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_keys, only: column_keys, format_keys
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_settings
   implicit none
   private
   public :: tenon_case, declare_replay_case

   !> Most contact points along a face
   integer, parameter :: most_points = 10000

   !> The case.
   type :: tenon_case
      type(faces_type) :: faces
      !> Faces and friction of the sides
      type(faces_type) :: side_faces
      real(wp) :: side_friction = none, side_critical_slip = none, side_shear_modulus = 0.0_wp
      !> The joint and its programme
      type(tenon_settings) :: joint
      !> Steps at which every point is kept, not allocated unless given
      integer, allocatable :: record(:)
      !> Gap above and below the tenon, mm, unless each is given
      real(wp) :: clearance = none
      !> Recorded motion in place of amplitudes: path of the file, what is taken of it and how
      character(len=:), allocatable :: history
      character(len=12) :: history_quantity = ''
      logical :: has_quantity = .false.
      character(len=:), allocatable :: quantity_source
      type(column_keys) :: column
      type(format_keys) :: format
      !> Checked properties of the faces and of the sides
      type(contact_properties) :: properties, sides
      !> Places of the keys of length and height
      integer :: length_key = 0, height_key = 0
      !> Places of the first and the last key of the sides, which follow each other
      integer, private :: side_keys(2) = 0
   contains
      procedure :: declare_faces, declare_sizes, declare_hold, declare_side_pressure
      procedure :: declare_programme, declare_amplitudes, declare_reading, sections, check
   end type tenon_case

contains

   !> Declare the properties of the faces and of the sides.
   pure subroutine declare_faces(self, keys)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call self%faces%declare(keys, has_friction=.true.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call self%faces%declare_rules(keys)
      call declare_friction(self%faces%friction, keys, has_time=.false., &
         pair_key=self%faces%pair_key)
      call declare_sides(self, keys)
      self%side_friction = self%faces%values(friction_coefficient)
      call keys%real('side_friction', self%side_friction, '', &
         'Coulomb friction coefficient of the sides; friction_coefficient unless given')
      call keys%follows(self%faces%keys(friction_coefficient))
      self%side_critical_slip = self%faces%values(critical_slip)
      call keys%real('side_critical_slip', self%side_critical_slip, 'mm', &
         'largest elastic slip of the sides; critical_slip unless given')
      call keys%follows(self%faces%keys(critical_slip))
      call declare_shear_modulus('side_shear_modulus', self%side_shear_modulus, keys, &
         self%faces%friction%stick == stick_summits, self%side_keys(1))
      self%side_keys(2) = keys%last
      call self%faces%declare_accept(keys)
      call keys%switch('accept_sizes', self%joint%accept_sizes, &
         'let sizes and pressures pass that look like another unit, and large rotations')
   end subroutine declare_faces

   !> Declare the properties of the sides but friction. What their pair gives is not listed beside
   !> its name.
   pure subroutine declare_sides(self, keys)
      class(tenon_case), intent(inout) :: self
      type(key_list), intent(inout) :: keys
      integer :: i

      call self%side_faces%declare(keys, has_friction=.false., prefix='side_', &
         usual_pair='tangential-tangential')
      self%side_keys(1) = self%side_faces%pair_key
      call self%side_faces%declare_separation(keys)
      associate (s => self%side_faces)
         keys%rows(keys%last)%unused = .not. (keys%given() .or. s%two%is_given) &
            .and. s%surface == ''
         do i = 1, size(s%keys)
            if (s%keys(i) == 0) cycle
            if (keys%rows(s%keys(i))%leader == s%pair_key) keys%rows(s%keys(i))%unused = .true.
         end do
      end associate
   end subroutine declare_sides

   !> Sections of the wood, in L, R and T, whose constants the faces take.
   pure function sections(self)
      !> The case, its faces declared
      class(tenon_case), intent(in) :: self
      logical :: sections(3)

      sections = self%faces%two%sections() .or. self%side_faces%two%sections()
   end function sections

   !> Declare length, height, width and clearances.
   pure subroutine declare_sizes(self, keys)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      type(tenon_settings) :: usual
      integer :: clearance
      logical :: follow(2)

      associate (t => self%joint)
         call keys%real('length', t%length, 'mm', 'length of the tenon in the mortise')
         self%length_key = keys%last
         call keys%real('height', t%height, 'mm', 'height of the tenon')
         self%height_key = keys%last
         call keys%real('width', t%width, 'mm', 'width of the tenon')
         self%clearance = usual%clearance_above
         call keys%real('clearance', self%clearance, 'mm', &
            'gap above the tenon, and the same below it')
         clearance = keys%last
         t%clearance_above = self%clearance
         call keys%real('clearance_above', t%clearance_above, 'mm', &
            'gap above the tenon; clearance unless given')
         call keys%follows(clearance)
         follow(1) = .not. keys%given()
         t%clearance_below = self%clearance
         call keys%real('clearance_below', t%clearance_below, 'mm', &
            'gap below the tenon; clearance unless given')
         call keys%follows(clearance)
         follow(2) = .not. keys%given()
         keys%rows(clearance)%unused = .not. any(follow)
         call keys%choice('gap', t%gap, 'mean_plane first_touch', &
            'what the clearance is measured between')
      end associate
   end subroutine declare_sizes

   !> Declare arm, side pressure, what resists pull-out, and shoulders.
   pure subroutine declare_hold(self, keys, is_replay)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether it is for the replay, which takes more sizes
      logical, intent(in) :: is_replay
      type(tenon_settings) :: usual
      integer :: extension

      usual%length = self%joint%length
      usual%height = self%joint%height
      call complete_tenon_settings(usual)
      extension = 0
      associate (t => self%joint)
         if (is_replay) then
            t%extension = usual%extension
            call keys%real('extension', t%extension, 'mm', &
               'length of full material past the column face; a fifth of height unless given')
            call keys%follows(self%height_key, 'a fifth of height')
            extension = keys%last
         end if
         call keys%real('arm', t%arm, 'mm', &
            'distance of the load point from arm_datum; the moment is force times arm')
         call keys%choice('arm_datum', t%arm_datum, 'column_face column_axis', &
            'where the arm is measured from')
         call self%declare_side_pressure(keys)
         call keys%choice('axial_rule', t%axial_rule, 'spring fixed free force', &
            'what resists pull-out')
         call keys%real('axial_stiffness', t%axial_stiffness, 'N/mm', &
            'stiffness of the axial spring')
         call keys%unused(t%axial_rule /= 'spring')
         if (is_replay) then
            call keys%real('axial_force', t%axial_force, 'N', &
               'axial force of axial_rule = force, positive pulls the tenon out')
            call keys%unused(t%axial_rule /= 'force')
         end if
         call keys%switch('shoulders', t%shoulders, &
            'shoulders above and below the tenon bear on the column face; no extension then')
         if (is_replay) then
            keys%rows(extension)%unused = t%shoulders
            t%shoulder_height = usual%shoulder_height
            call keys%real('shoulder_height', t%shoulder_height, 'mm', &
               'height of each shoulder; a sixth of height unless given')
            call keys%follows(self%height_key, 'a sixth of height')
            call keys%unused(.not. t%shoulders)
            call keys%real('shoulder_gap', t%shoulder_gap, 'mm', &
               'gap between each shoulder and the column face')
            call keys%unused(.not. t%shoulders)
         end if
         call keys%real('column_load', t%column_load, 'N', &
            'vertical load of the column; the plane replay does not use it')
         call keys%unused(is_replay)
      end associate
   end subroutine declare_hold

   !> Declare the pressure of the sides, without which their faces are of no use.
   pure subroutine declare_side_pressure(self, keys)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%real('side_pressure', self%joint%side_pressure, 'MPa', &
         'pressure on each side face, 0 for none')
      if (.not. self%joint%side_pressure > 0.0_wp) &
         keys%rows(self%side_keys(1):self%side_keys(2))%unused = .true.
   end subroutine declare_side_pressure

   !> Declare amplitudes, or the record in their place.
   pure subroutine declare_programme(self, keys)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      integer :: cycles

      call self%declare_amplitudes(keys, joint_amplitudes, joint_cycles, &
         'amplitudes at the load point, growing')
      cycles = keys%last
      call keys%text('history', self%history, &
         'CSV file of recorded displacements or rotations, in place of amplitudes')
      call keys%reads('history', is_argument=.false.)
      keys%rows([cycles - 1, cycles])%unused = self%history /= ''
      call keys%choice('history_quantity', self%history_quantity, 'displacement rotation', &
         'what is taken of the history; rotation is displacement over arm; as its columns say')
      self%has_quantity = keys%given()
      if (allocated(self%quantity_source)) call keys%said_by(self%quantity_source)
   end subroutine declare_programme

   !> Declare amplitudes and cycles, the last two keys.
   pure subroutine declare_amplitudes(self, keys, amplitudes, cycles, help)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Amplitudes, mm, and cycles of each by default
      real(wp), intent(in) :: amplitudes(:)
      integer, intent(in) :: cycles(:)
      !> What the amplitudes are of
      character(len=*), intent(in) :: help
      logical :: are_given

      associate (t => self%joint)
         t%amplitudes = amplitudes
         call keys%list('amplitudes', t%amplitudes, 'mm', help)
         are_given = keys%given()
         t%cycles = cycles
         if (are_given) then
            deallocate (t%cycles)
            allocate (t%cycles(size(t%amplitudes)), source=1)
         end if
         call keys%list('cycles', t%cycles, '', &
            'cycles at each amplitude; 1 each unless given with the amplitudes')
         if (are_given) call keys%follows(keys%last - 1, '1 each')
      end associate
   end subroutine declare_amplitudes

   !> Declare how the record is read.
   pure subroutine declare_reading(self, keys)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      self%column%name = 'displacement'
      call self%column%declare_column(keys, &
         'name or number of the column of displacement or rotation; found by name and unit')
      call keys%unused(self%history == '')
      call self%format%declare(keys, self%history == '')
      call self%column%declare_unit(keys, 'unit; that of the file, else mm or rad')
      call keys%unused(self%history == '')
   end subroutine declare_reading

   !> Declare the case of a replay.
   pure subroutine declare_replay_case(case, keys)
      !> The case
      type(tenon_case), intent(inout) :: case
      !> The keys
      type(key_list), intent(inout) :: keys

      call case%declare_faces(keys)
      call keys%real('displacement_increment', case%joint%displacement_increment, 'mm', &
         'largest displacement in one increment')
      call case%declare_sizes(keys)
      call case%declare_hold(keys, is_replay=.true.)
      call declare_bearing(case%joint, case%faces%ageing, case%sections(), case%height_key, keys)
      call declare_points(case%joint, keys)
      call case%declare_programme(keys)
      call keys%list('record', case%record, '', &
         'steps whose points --points holds; four of the largest loop unless given')
      call keys%choice('through', case%joint%through_uinter, 'direct uinter', &
         'what updates a contact point')
      call case%declare_reading(keys)
   end subroutine declare_replay_case

   !> Check everything but a record.
   subroutine check(self, error, compiled)
      !> The case
      class(tenon_case), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      !> Whether the law of the faces is to be compiled
      logical, intent(in) :: compiled

      call self%faces%contact(self%properties, error, compiled)
      if (.not. allocated(error)) call check_sides(self, error)
      if (.not. allocated(error)) call check_range(error, 'face_points', &
         real(self%joint%points, wp), 1.0_wp, real(most_points, wp), '')
      if (.not. allocated(error)) call check_tenon_settings(self%joint, error, &
         joint_only=self%history /= '')
      if (allocated(error)) return
      if (abs(self%joint%axial_force) > 0.0_wp .and. self%joint%axial_rule /= 'force') &
         call fatal_error(error, 'axial_force needs axial_rule = force', subject='axial_force')
   end subroutine check

   !> Properties of the sides of the tenon; what they do is what the faces do.
   subroutine check_sides(self, error)
      type(tenon_case), intent(inout) :: self
      type(error_type), allocatable, intent(out) :: error
      type(faces_type) :: sides
      integer :: i

      call check_range(error, 'side_friction', self%side_friction, 0.0_wp, largest_friction, '')
      if (allocated(error)) return
      sides = self%faces
      sides%values = self%side_faces%values
      sides%values([friction_coefficient, critical_slip]) = [self%side_friction, &
         self%side_critical_slip]
      if (self%faces%values(friction_coefficient) > 0.0_wp) sides%friction = &
         friction_of_sides(sides%friction, &
         self%side_friction/self%faces%values(friction_coefficient), self%side_shear_modulus)
      sides%initial_separation = self%side_faces%initial_separation
      call sides%contact(self%sides, error, compiled=.true.)
      if (allocated(error)) then
         ! a message begins with what it is about
         error%message = 'side_'//error%message
         error%subject = 'side_'//error%subject
         do i = len(error%subject) - 1, 1, -1
            if (error%subject(i:i) == ' ') error%subject = error%subject(:i)//'side_'// &
               error%subject(i + 1:)
         end do
      end if
   end subroutine check_sides

end module asperity_program_commands_tenon_joint_keys
