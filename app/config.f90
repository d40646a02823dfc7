!> Turns settings into what a command runs on: checked properties and the settings of its test.
module app_config
   use asperity, only: contact_properties, error_type, new_contact_properties, &
      new_normal_properties, normal_properties, rule_abaqus, rule_dissipative, &
      slip_backward_euler, slip_exact, wp
   use asperity_contact_properties, only: default_initial_separation
   use asperity_error, only: fatal_error
   use asperity_text, only: to_text
   use replay_press, only: press_settings
   use replay_shear_box, only: shear_settings
   use app_case_file, only: read_case
   use app_cli, only: command_line_type
   use app_keys, only: command_curve, command_press, command_shear, find_key, n_keys
   use app_lists, only: linear_range
   use app_presets, only: apply_presets, check_presets_used, drop_overridden, fill
   use app_settings, only: default_settings, settings_type
   use app_strings, only: starts_with
   implicit none
   private
   public :: effective_settings, config_type, new_config, locate

   !> What a command runs on.
   type :: config_type
      !> Checked properties of the faces
      type(contact_properties) :: properties
      !> Separations of `curve`, mm; allocated for it only
      real(wp), allocatable :: separation(:)
      !> Load path of `press`
      type(press_settings) :: press
      !> Specimen and path of `shear`; the normal stress is set for each run
      type(shear_settings) :: shear
      !> Normal stresses of `shear`, MPa
      real(wp), allocatable :: normal_stress(:)
   end type config_type

   !> Default of `separation`: from 4 sigma down to 0
   integer, parameter :: default_points = 41
   !> Largest separation over sigma
   real(wp), parameter :: farthest = 1.0e100_wp

contains

   !> Settings in effect: options, then the case file, then defaults. Explicit values go before
   !> a surface, and that before a pair, each of the options before all of the case file.
   !> `error` names the place.
   subroutine effective_settings(line, settings, error)
      !> Command line
      type(command_line_type), intent(in) :: line
      !> A value for every key of the command
      type(settings_type), intent(out) :: settings
      !> Set when a value is missing or refused
      type(error_type), allocatable, intent(out) :: error
      integer :: key

      settings = default_settings()
      if (line%case_path /= '') then
         call read_case(line%case_path, settings, error)
         if (allocated(error)) return
         call drop_overridden(settings, line%options)
      end if
      do key = 1, n_keys
         if (line%options%of(key)%given) settings%of(key) = line%options%of(key)
      end do
      call apply_presets(settings, line%command, error)
      if (.not. allocated(error)) call check_presets_used(settings, line%options, &
         line%command, error)
      if (allocated(error)) then
         call locate(error, settings)
         return
      end if
      associate (sigma => settings%real_of('sigma'))
         call fill(settings, 'initial_separation', [default_initial_separation*sigma], &
            '4 sigma', follows_sigma=.true.)
         call fill(settings, 'separation', linear_range(default_initial_separation*sigma, &
            0.0_wp, default_points), '4 sigma to 0', follows_sigma=.true.)
      end associate
      if (line%command == command_press .and. settings%text_of('control') == 'overclosure' &
            .and. .not. settings%given('peak')) then
         call fatal_error(error, 'control = overclosure needs a peak, in mm')
         call locate(error, settings)
      end if
   end subroutine effective_settings

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
            if (command == command_shear) then
               friction_coefficient = s%real_of('friction_coefficient')
               critical_slip = s%real_of('critical_slip')
            end if
            friction_rule = merge(rule_dissipative, rule_abaqus, &
               s%text_of('friction_rule') == 'dissipative')
            slip_integration = merge(slip_backward_euler, slip_exact, &
               s%text_of('slip_integration') == 'backward_euler')
            call new_contact_properties(config%properties, normal, friction_coefficient, &
               critical_slip, error, s%real_of('initial_separation'), friction_rule, &
               slip_integration)
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
         config%shear%diameter = s%real_of('diameter')
         config%shear%rate = s%real_of('rate')
         config%shear%displacement = s%of(find_key('displacement'))%values
         config%shear%displacement_increment = s%real_of('displacement_increment')
         config%shear%shrinking_overlap = s%switch_of('shrinking_overlap')
         config%shear%shear_compliance = s%real_of('shear_compliance')
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

   !> Put the place of a value before a message that starts with its name, such as
   !> `sigma = -1.0` or `eta*radius*sigma = 0.01`, if the user gave it.
   pure subroutine locate(error, settings)
      !> Its message is changed
      type(error_type), intent(inout) :: error
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      integer :: first, last, key

      first = 1
      do
         last = verify(error%message(first:), 'abcdefghijklmnopqrstuvwxyz_')
         if (last < 2) return
         last = first + last - 2
         key = find_key(error%message(first:last))
         if (key > 0) then
            if (settings%of(key)%given .and. .not. starts_with(error%message, &
               settings%of(key)%source)) then
               error%message = settings%of(key)%source//': '//error%message
               return
            end if
         end if
         if (error%message(last + 1:last + 1) /= '*') return
         first = last + 2
      end do
   end subroutine locate

end module app_config
