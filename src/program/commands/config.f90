!> Turns settings into what a command runs on: checked properties and the settings of its test.
module asperity_program_commands_config
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties, new_contact_properties, rule_abaqus, &
      rule_dissipative, slip_backward_euler, slip_exact
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_program_commands_tenon_config, only: new_side_properties, new_tenon_settings, &
      whole_list
   use asperity_program_input_keys, only: command_curve, command_table, command_tenon, find_key, &
      shears, tenons
   use asperity_program_input_resolve, only: locate
   use asperity_program_input_settings, only: settings_type
   use asperity_replay_press, only: press_settings
   use asperity_replay_shear_box, only: shear_settings
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: config_type, new_config

   !> What a command runs on.
   type :: config_type
      !> Checked properties of the faces
      type(contact_properties) :: properties
      !> Separations of `curve`, mm; allocated for it only
      real(wp), allocatable :: separation(:)
      !> Checked properties of the sides of the tenon
      type(contact_properties) :: sides
      !> The tenon joint, without contact model and recorded history
      type(tenon_settings) :: tenon
      !> Steps of `tenon` at which every point is kept; not allocated unless given
      integer, allocatable :: record(:)
      !> Load path of `press`
      type(press_settings) :: press
      !> Specimen and path of `shear`; the normal stress is set for each run
      type(shear_settings) :: shear
      !> Normal stresses of `shear`, MPa
      real(wp), allocatable :: normal_stress(:)
   end type config_type

   !> Largest separation over sigma
   real(wp), parameter :: farthest = 1.0e100_wp

contains

   !> Checked properties and settings of the test. `error` names the place of the value.
   pure subroutine new_config(config, settings, command, error)
      !> What the command runs on
      type(config_type), intent(out) :: config
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> The command
      integer, intent(in) :: command
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(normal_properties) :: normal
      real(wp) :: friction_coefficient, critical_slip
      integer :: friction_rule, slip_integration

      associate (s => settings)
         call new_normal_properties(normal, s%real_of('eta'), s%real_of('modulus'), &
            s%real_of('radius'), s%real_of('hardness'), s%real_of('yield_factor'), &
            s%real_of('sigma'), error, s%switch_of('accept_unphysical'))
         if (.not. allocated(error)) then
            friction_coefficient = 0.0_wp
            critical_slip = 1.0_wp
            if (iand(command, shears + tenons + command_table) /= 0) then
               friction_coefficient = s%real_of('friction_coefficient')
               critical_slip = s%real_of('critical_slip')
            end if
            friction_rule = merge(rule_dissipative, rule_abaqus, &
               s%text_of('friction_rule') == 'dissipative')
            slip_integration = merge(slip_backward_euler, slip_exact, &
               s%text_of('slip_integration') == 'backward_euler')
            call new_contact_properties(config%properties, normal, friction_coefficient, &
               critical_slip, error, s%real_of('initial_separation'), friction_rule, &
               slip_integration, compiled=command == command_tenon, &
               accept_unphysical=s%switch_of('accept_unphysical'))
         end if
         if (.not. allocated(error) .and. iand(command, tenons) /= 0) then
            call new_side_properties(config%sides, s, friction_rule, slip_integration, error)
            if (.not. allocated(error)) call new_tenon_settings(config%tenon, s, command, error)
            if (.not. allocated(error) .and. s%given('record')) &
               call whole_list(s, 'record', config%record, error)
         end if
         if (allocated(error)) then
            call locate(error, settings)
            return
         end if
         if (command == command_curve) then
            config%separation = s%of(find_key('separation'))%values
            call check_separation(config%separation, normal%sigma, error)
            if (allocated(error)) then
               call locate(error, settings)
               return
            end if
         end if
         config%press%control = s%text_of('control')
         config%press%peak = s%real_of('peak')
         config%press%increments = s%of(find_key('increments'))%whole
         config%press%step_time = s%real_of('step_time')
         config%press%accept_sizes = s%switch_of('accept_sizes')
         config%shear%diameter = s%real_of('diameter')
         config%shear%rate = s%real_of('rate')
         config%shear%displacement = s%of(find_key('displacement'))%values
         config%shear%displacement_increment = s%real_of('displacement_increment')
         config%shear%shrinking_overlap = s%switch_of('shrinking_overlap')
         config%shear%shear_compliance = s%real_of('shear_compliance')
         config%shear%accept_sizes = s%switch_of('accept_sizes')
         config%normal_stress = s%of(find_key('normal_stress'))%values
      end associate
   end subroutine new_config

   !> Refuse separations at which the energy would overflow.
   pure subroutine check_separation(separation, sigma, error)
      real(wp), intent(in) :: separation(:), sigma
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      i = findloc(abs(separation)/sigma > farthest, .true., 1)
      if (i > 0) call fatal_error(error, 'separation = '//to_text(separation(i))// &
         ' mm is not allowed: it must be below 1e100 sigma in size')
   end subroutine check_separation

end module asperity_program_commands_config
