!> Settings in effect: options over the case file over presets over defaults, and the place of
!> each in messages.
module asperity_program_input_resolve
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: default_initial_separation
   use asperity_deck_tenon_parts, only: default_mesh_size, default_tenon_sizes, tenon_sizes
   use asperity_program_input_case_file, only: read_case
   use asperity_program_input_command_line, only: command_line_type
   use asperity_program_input_keys, only: belongs, command_deck_shear, command_deck_tenon, &
      command_hysteresis, command_press, command_table, command_tenon, decks, find_key, n_keys, &
      tenons
   use asperity_program_input_presets, only: apply_presets, check_presets_used, drop_overridden, &
      fill
   use asperity_program_input_ranges, only: linear_range
   use asperity_program_input_settings, only: default_settings, settings_type
   use asperity_program_system_strings, only: starts_with
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_settings
   implicit none
   private
   public :: case_settings, settled, leader_of, locate, mark_unused

   !> Default of `separation`: from 4 sigma down to 0
   integer, parameter :: default_points = 41
   !> Defaults of `displacement_increment`, mm
   real(wp), parameter :: box_increment = 0.02_wp, deck_increment = 0.05_wp, &
      joint_increment = 0.8_wp
   !> Defaults of `mesh_size` of discs, mm, which is the paper's, and of `largest_pressure`, MPa
   real(wp), parameter :: disc_mesh = 2.5_wp, table_end = 4.7_wp

   !> Default of `cycles`, for the default amplitudes
   real(wp), parameter :: default_cycles(9) = [1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 3.0_wp, 3.0_wp, &
      3.0_wp, 3.0_wp, 3.0_wp]
   !> How the source of a value begins that is that of another key
   character(len=*), parameter :: as = 'as '

contains

   !> Defaults, and what a case file gives.
   subroutine case_settings(path, settings, error)
      !> Path of the case file, empty for none
      character(len=*), intent(in) :: path
      !> Its settings
      type(settings_type), intent(out) :: settings
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error

      settings = default_settings()
      if (path /= '') call read_case(path, settings, error)
   end subroutine case_settings

   !> Settings in effect: options over the settings of a case file, then all that follows from
   !> them. Explicit values go before a surface, and that before a pair, each of the options before
   !> all of the case file. `error` names the place.
   pure subroutine settled(base, line, settings, error)
      !> From `case_settings`
      type(settings_type), intent(in) :: base
      !> Command and options
      type(command_line_type), intent(in) :: line
      !> A value for every key of the command
      type(settings_type), intent(out) :: settings
      !> Set when a value is missing or refused
      type(error_type), allocatable, intent(out) :: error
      integer :: key

      settings = base
      call drop_overridden(settings, line%options)
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
      call fill_followers(settings, line%command)
      call mark_unused(settings, line%command)
      if (line%command == command_press .and. settings%text_of('control') == 'overclosure' &
            .and. .not. settings%given('peak')) then
         call fatal_error(error, 'control = overclosure needs a peak, in mm')
         call locate(error, settings)
      end if
   end subroutine settled

   !> Values that follow from those of other keys, or from the command.
   pure subroutine fill_followers(settings, command)
      type(settings_type), intent(inout) :: settings
      integer, intent(in) :: command
      integer :: i

      associate (sigma => settings%real_of('sigma'))
         call fill(settings, 'initial_separation', [default_initial_separation*sigma], &
            '4 sigma', follows=.true.)
         call fill(settings, 'separation', linear_range(default_initial_separation*sigma, &
            0.0_wp, default_points), '4 sigma to 0', follows=.true.)
      end associate
      if (command == command_table) then
         call fill(settings, 'largest_pressure', [table_end], 'default')
         call follow(settings, 'stick_pressure', 'largest_pressure')
      else if (iand(command, decks) /= 0) then
         if (command == command_deck_shear) call fill(settings, 'mesh_size', [disc_mesh], 'default')
         call follow(settings, 'largest_pressure', 'hardness')
      end if
      call fill(settings, 'displacement_increment', [merge(joint_increment, &
         merge(deck_increment, box_increment, command == command_deck_shear), &
         iand(command, tenons) /= 0)], 'default')
      if (iand(command, tenons) == 0) return
      if (settings%given('amplitudes')) then
         associate (amplitudes => settings%of(find_key('amplitudes'))%values)
            call fill(settings, 'cycles', [(1.0_wp, i=1, size(amplitudes))], '1 each', &
               follows=.true.)
         end associate
      else
         call fill(settings, 'cycles', default_cycles, 'default')
      end if
      call follow(settings, 'clearance_above', 'clearance')
      call follow(settings, 'clearance_below', 'clearance')
      call follow(settings, 'side_friction', 'friction_coefficient')
      call follow(settings, 'side_critical_slip', 'critical_slip')
      call follow_sizes(settings, command)
   end subroutine fill_followers

   !> Sizes of a joint that follow from its length and height.
   pure subroutine follow_sizes(settings, command)
      type(settings_type), intent(inout) :: settings
      integer, intent(in) :: command
      type(tenon_settings) :: joint
      type(tenon_sizes) :: sizes

      joint%length = settings%real_of('length')
      joint%height = settings%real_of('height')
      if (command == command_deck_tenon) then
         sizes = default_tenon_sizes(joint)
         call fill(settings, 'mesh_size', [default_mesh_size(joint)], 'a tenth of height', .true.)
         call fill(settings, 'column_height', [sizes%column_height], '10/3 of height', .true.)
         call fill(settings, 'column_width', [sizes%column_width], as//'length', .true.)
         call fill(settings, 'edge_relief', [sizes%edge_relief], 'a hundredth of height', .true.)
      else
         call complete_tenon_settings(joint)
         call fill(settings, 'extension', [joint%extension], 'a fifth of height', .true.)
         call fill(settings, 'shoulder_height', [joint%shoulder_height], 'a sixth of height', &
            .true.)
         call fill(settings, 'bearing_depth', [joint%bearing_depth], 'half of height', .true.)
         call fill(settings, 'column_depth', [joint%column_depth], 'half of height', .true.)
      end if
   end subroutine follow_sizes

   !> Give a key the value of another unless it has one.
   pure subroutine follow(settings, name, leader)
      type(settings_type), intent(inout) :: settings
      character(len=*), intent(in) :: name, leader

      call fill(settings, name, settings%of(find_key(leader))%values, as//leader, &
         follows=.true.)
   end subroutine follow

   !> Mark what does not act on the run, so that no listing shows it as if it did.
   pure subroutine mark_unused(settings, command)
      !> Settings in effect
      type(settings_type), intent(inout) :: settings
      !> The command
      integer, intent(in) :: command
      integer :: key
      logical :: recorded

      if (iand(command, tenons) == 0) return
      recorded = settings%text_of('history') /= ''
      call mark(settings, [character(len=24) :: 'amplitudes', 'cycles'], recorded)
      do key = 1, n_keys
         ! how to read a record
         if (belongs(key, command_hysteresis) .and. belongs(key, command)) &
            settings%of(key)%unused = .not. recorded
      end do
      call mark(settings, [character(len=24) :: 'clearance'], &
         .not. (settings%of(find_key('clearance_above'))%follows &
         .or. settings%of(find_key('clearance_below'))%follows))
      ! it acts on the deck alone
      call mark(settings, [character(len=24) :: 'column_load'], command == command_tenon)
      call mark(settings, [character(len=24) :: 'extension'], settings%switch_of('shoulders'))
      call mark(settings, [character(len=24) :: 'shoulder_height', 'shoulder_gap', &
         'shoulder_points'], .not. settings%switch_of('shoulders'))
      call mark(settings, [character(len=24) :: 'axial_stiffness'], &
         settings%text_of('axial_rule') /= 'spring')
      call mark(settings, [character(len=24) :: 'axial_force'], &
         settings%text_of('axial_rule') /= 'force')
      call mark(settings, [character(len=24) :: 'side_pair', 'side_friction', &
         'side_critical_slip', 'side_points'], .not. settings%real_of('side_pressure') > 0.0_wp)
      call mark(settings, [character(len=24) :: 'column_depth', 'column_strength', &
         'column_hardening'], .not. settings%real_of('column_modulus') > 0.0_wp)
   end subroutine mark_unused

   pure subroutine mark(settings, names, unused)
      type(settings_type), intent(inout) :: settings
      character(len=*), intent(in) :: names(:)
      logical, intent(in) :: unused
      integer :: i

      do i = 1, size(names)
         settings%of(find_key(trim(names(i))))%unused = unused
      end do
   end subroutine mark

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
         if (key > 0) key = leader_of(key, settings)
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

   !> The key that a key takes its value from, else itself: the last word of its source.
   pure integer function leader_of(key, settings) result(leader)
      !> Place of the key
      integer, intent(in) :: key
      !> Settings in effect
      type(settings_type), intent(in) :: settings

      leader = key
      associate (setting => settings%of(key))
         if (.not. setting%follows) return
         leader = find_key(setting%source(index(setting%source, ' ', back=.true.) + 1:))
      end associate
      if (leader == 0) leader = key
   end function leader_of

end module asperity_program_input_resolve
