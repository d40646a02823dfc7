!> What a row of the table of keys is, which commands there are, which kinds of values.
module asperity_program_input_key_table
   implicit none
   private

   integer, parameter :: name_length = 24, unit_length = 12, default_length = 24
   integer, parameter :: choices_length = 32, help_length = 84

   !> Commands, as bits of a sum
   integer, parameter, public :: command_curve = 1, command_press = 2, command_shear = 4, &
      command_pairs = 8, command_version = 16, command_help = 32, command_citation = 64, &
      command_hysteresis = 128, command_tenon = 256, command_table = 512, &
      command_deck_shear = 1024, command_deck_tenon = 2048, command_surface = 4096
   !> Commands that share keys
   integer, parameter, public :: shears = command_shear + command_deck_shear, &
      tenons = command_tenon + command_deck_tenon, decks = command_deck_shear + command_deck_tenon
   integer, parameter, public :: all_replays = command_curve + command_press + command_shear + &
      command_tenon + command_table
   integer, parameter, public :: all_runs = all_replays + decks
   integer, parameter, public :: with_friction = shears + tenons + command_table + command_surface
   integer, parameter, public :: slides = shears + tenons
   integer, parameter, public :: sized = slides + command_press
   integer, parameter, public :: moves = shears + command_tenon
   integer, parameter, public :: tabulates = command_table + decks
   integer, parameter, public :: records = command_hysteresis + tenons
   integer, parameter, public :: all_drawn = all_replays + command_hysteresis + command_surface
   integer, parameter, public :: all_laws = all_runs + command_surface
   integer, parameter, public :: all_tables = all_drawn + command_pairs
   integer, parameter, public :: everything = all_tables + decks + command_version + command_help

   !> Kinds of values
   enum, bind(c)
      !> One text
      enumerator :: kind_text = 1
      !> One of the texts in `choices`
      enumerator :: kind_choice
      !> One real number
      enumerator :: kind_real
      !> One whole number
      enumerator :: kind_integer
      !> True or false
      enumerator :: kind_logical
      !> Real numbers
      enumerator :: kind_list
      !> Path of a file that is written; an option only
      enumerator :: kind_file
      !> Something asked for; an option only
      enumerator :: kind_request
      !> A key and its values, `name=values`; an option only, which may be given again
      enumerator :: kind_sweep
   end enum
   public :: kind_text, kind_choice, kind_real, kind_integer, kind_logical, kind_list, &
      kind_file, kind_request, kind_sweep

   !> One row of the table.
   type, public :: key_type
      !> Name in case files; the option has `-` for `_`
      character(len=name_length) :: name
      !> One of the kinds above
      integer :: kind
      !> Unit of the value, blank for none
      character(len=unit_length) :: unit
      !> Sum of the commands that it belongs to
      integer :: commands
      !> A property of the faces rather than of the test done on them
      logical :: is_property
      !> Value when not given, as in a case file; blank when it follows from other values
      character(len=default_length) :: default
      !> Values allowed for `kind_choice`, separated by blanks
      character(len=choices_length) :: choices
      !> Help text
      character(len=help_length) :: help
   end type key_type

end module asperity_program_input_key_table
