!> The commands of the program, in the order of its help.
module asperity_program_commands_registry
   use asperity_program_commands_check_command, only: check_command
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_compare_command, only: compare_command
   use asperity_program_commands_curve, only: curve_command
   use asperity_program_commands_deck_shear, only: shear_deck_command
   use asperity_program_commands_deck_tenon, only: tenon_deck_command
   use asperity_program_commands_fit_command, only: fit_command
   use asperity_program_commands_frame_command, only: frame_command
   use asperity_program_commands_hysteresis_command, only: hysteresis_command
   use asperity_program_commands_pairs, only: pairs_command
   use asperity_program_commands_press, only: press_command
   use asperity_program_commands_replay_command, only: replay_command
   use asperity_program_commands_shear, only: shear_command
   use asperity_program_commands_solid_command, only: solid_command
   use asperity_program_commands_surface_command, only: surface_command
   use asperity_program_commands_table_command, only: table_command
   use asperity_program_commands_tenon_command, only: tenon_command
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_options, only: find_option
   implicit none
   private
   public :: command_entry, list_commands, find_command, all_keys, owners

   !> How many there are
   integer, parameter, public :: n_commands = 16

   !> A command in a list.
   type :: command_entry
      class(command_type), allocatable :: command
   end type command_entry

contains

   !> All commands, described.
   subroutine list_commands(list)
      !> The commands
      type(command_entry), intent(out) :: list(n_commands)
      integer :: i

      allocate (curve_command :: list(1)%command)
      allocate (press_command :: list(2)%command)
      allocate (shear_command :: list(3)%command)
      allocate (tenon_command :: list(4)%command)
      allocate (solid_command :: list(5)%command)
      allocate (frame_command :: list(6)%command)
      allocate (table_command :: list(7)%command)
      allocate (shear_deck_command :: list(8)%command)
      allocate (tenon_deck_command :: list(9)%command)
      allocate (hysteresis_command :: list(10)%command)
      allocate (fit_command :: list(11)%command)
      allocate (surface_command :: list(12)%command)
      allocate (pairs_command :: list(13)%command)
      allocate (replay_command :: list(14)%command)
      allocate (compare_command :: list(15)%command)
      allocate (check_command :: list(16)%command)
      do i = 1, size(list)
         call list(i)%command%describe()
      end do
   end subroutine list_commands

   !> The command of a word, or of the two of a deck; not allocated when there is none.
   subroutine find_command(word, command)
      !> The word
      character(len=*), intent(in) :: word
      !> The command, described
      class(command_type), allocatable, intent(out) :: command
      type(command_entry) :: list(n_commands)
      integer :: i

      call list_commands(list)
      do i = 1, size(list)
         if (list(i)%command%name == word) call move_alloc(list(i)%command, command)
      end do
   end subroutine find_command

   !> Keys of all commands, each once.
   subroutine all_keys(keys)
      !> The keys
      type(key_list), intent(out) :: keys
      type(command_entry) :: list(n_commands)
      integer :: i

      call list_commands(list)
      do i = 1, size(list)
         call list(i)%command%declare(keys)
      end do
   end subroutine all_keys

   !> Names of the commands that have an option, such as `press, shear`; empty when none has.
   function owners(option) result(names)
      !> The option
      character(len=*), intent(in) :: option
      character(len=:), allocatable :: names
      type(command_entry) :: list(n_commands)
      type(key_list), allocatable :: keys
      integer :: i, place
      logical :: negated

      names = ''
      call list_commands(list)
      do i = 1, size(list)
         allocate (keys)
         call list(i)%command%declare(keys)
         call find_option(keys, option, place, negated)
         if (place > 0 .and. names /= '') names = names//', '
         if (place > 0) names = names//trim(list(i)%command%name)
         deallocate (keys)
      end do
   end function owners

end module asperity_program_commands_registry
