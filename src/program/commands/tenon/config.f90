!> Settings of `asperity tenon` as the replay takes them.
module asperity_program_commands_tenon_config
   use asperity_base_checks, only: check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties, new_contact_properties
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_paper_pairs, only: find_pair, pair_preset
   use asperity_program_input_keys, only: belongs, find_key
   use asperity_program_input_settings, only: settings_type
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: new_tenon_settings, new_side_properties, whole_list

   !> Most contact points along a face
   integer, parameter :: most_points = 10000

contains

   !> The joint and its programme, without contact model and recorded history. `error` begins with
   !> the name of the value.
   pure subroutine new_tenon_settings(tenon, settings, command, error)
      !> The joint
      type(tenon_settings), intent(out) :: tenon
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> The command, of which a deck has no increment of displacement
      integer, intent(in) :: command
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      associate (s => settings, t => tenon)
         t%length = s%real_of('length')
         t%height = s%real_of('height')
         t%width = s%real_of('width')
         t%clearance_above = s%real_of('clearance_above')
         t%clearance_below = s%real_of('clearance_below')
         t%gap = s%text_of('gap')
         call take(t%extension, s, 'extension')
         t%arm = s%real_of('arm')
         t%arm_datum = s%text_of('arm_datum')
         t%side_pressure = s%real_of('side_pressure')
         t%axial_rule = s%text_of('axial_rule')
         t%axial_stiffness = s%real_of('axial_stiffness')
         t%axial_force = s%real_of('axial_force')
         t%shoulders = s%switch_of('shoulders')
         call take(t%shoulder_height, s, 'shoulder_height')
         t%shoulder_gap = s%real_of('shoulder_gap')
         t%column_load = s%real_of('column_load')
         t%bearing_modulus = s%real_of('bearing_modulus')
         call take(t%bearing_depth, s, 'bearing_depth')
         t%bearing_strength = s%real_of('bearing_strength')
         t%hardening = s%real_of('hardening')
         t%column_modulus = s%real_of('column_modulus')
         call take(t%column_depth, s, 'column_depth')
         t%column_strength = s%real_of('column_strength')
         t%column_hardening = s%real_of('column_hardening')
         t%points = s%whole_of('face_points')
         t%side_points = s%whole_of('side_points')
         t%shoulder_points = s%whole_of('shoulder_points')
         if (belongs(find_key('displacement_increment'), command)) &
            t%displacement_increment = s%real_of('displacement_increment')
         t%through_uinter = s%text_of('through') == 'uinter'
         t%accept_sizes = s%switch_of('accept_sizes')
         t%amplitudes = s%of(find_key('amplitudes'))%values
         call whole_list(s, 'cycles', t%cycles, error)
      end associate
      ! Here, as the replay calls it `points`, which is the name of an output
      if (.not. allocated(error)) call check_range(error, 'face_points', &
         real(tenon%points, wp), 1.0_wp, real(most_points, wp), '')
      if (.not. allocated(error)) call check_tenon_settings(tenon, error, &
         joint_only=settings%text_of('history') /= '')
      if (allocated(error)) return
      if (abs(tenon%axial_force) > 0.0_wp .and. tenon%axial_rule /= 'force') &
         call fatal_error(error, 'axial_force needs axial_rule = force')
   end subroutine new_tenon_settings

   !> Give a size the value of a key if it has one; keys of the replay have none for a deck.
   pure subroutine take(size, settings, name)
      real(wp), allocatable, intent(inout) :: size
      type(settings_type), intent(in) :: settings
      character(len=*), intent(in) :: name

      if (settings%of(find_key(name))%has_value) size = settings%real_of(name)
   end subroutine take

   !> Properties of the sides of the tenon, whose friction may be given. `error` begins with the
   !> name of the value.
   pure subroutine new_side_properties(sides, settings, friction_rule, slip_integration, error)
      !> The properties
      type(contact_properties), intent(out) :: sides
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> Rules of friction, as for the other faces
      integer, intent(in) :: friction_rule, slip_integration
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: pair
      type(normal_properties) :: normal

      call check_range(error, 'side_friction', settings%real_of('side_friction'), 0.0_wp, &
         1000.0_wp, '')
      if (.not. allocated(error)) call find_pair(settings%text_of('side_pair'), pair, error)
      if (allocated(error)) then
         if (index(error%message, 'pair') == 1) error%message = 'side_'//error%message
         return
      end if
      call new_normal_properties(normal, pair%eta, pair%modulus, pair%radius, pair%hardness, &
         pair%yield_factor, pair%sigma, error)
      if (.not. allocated(error)) call new_contact_properties(sides, normal, &
         settings%real_of('side_friction'), settings%real_of('side_critical_slip'), error, &
         friction_rule=friction_rule, slip_integration=slip_integration, compiled=.true., &
         accept_unphysical=settings%switch_of('accept_unphysical'))
      if (.not. allocated(error)) return
      if (index(error%message, 'critical_slip') == 1) error%message = 'side_'//error%message
   end subroutine new_side_properties

   !> Values of a list of whole numbers. `error` begins with the name of the list.
   pure subroutine whole_list(settings, name, values, error)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> Name of the list
      character(len=*), intent(in) :: name
      !> Its values
      integer, allocatable, intent(out) :: values(:)
      !> Set when one of them is not a whole number of at least zero
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      associate (list => settings%of(find_key(name))%values)
         do i = 1, size(list)
            if (list(i) >= 0.0_wp .and. list(i) < 1.0e9_wp &
               .and. .not. abs(list(i) - anint(list(i))) > 0.0_wp) cycle
            call fatal_error(error, name//' = '//to_text(list(i))// &
               ' is not allowed: whole numbers of at least zero')
            return
         end do
         values = nint(list)
      end associate
   end subroutine whole_list

end module asperity_program_commands_tenon_config
