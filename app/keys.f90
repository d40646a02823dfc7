!> The one table of everything a user can set. The case-file scanner, the options, the help
!> texts and `--print-case` all read it, so that none of them can disagree.
module app_keys
   implicit none
   private
   public :: key_type, find_key, option_name, command_names, belongs

   integer, parameter :: name_length = 24, unit_length = 12, default_length = 24
   integer, parameter :: choices_length = 24, help_length = 84

   !> Commands, as bits of a sum
   integer, parameter, public :: command_curve = 1, command_press = 2, command_shear = 4, &
      command_pairs = 8, command_version = 16, command_help = 32, command_citation = 64
   integer, parameter :: all_runs = command_curve + command_press + command_shear
   integer, parameter :: all_tables = all_runs + command_pairs
   integer, parameter :: everything = all_tables + command_version + command_help

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
   end enum
   public :: kind_text, kind_choice, kind_real, kind_integer, kind_logical, kind_list, &
      kind_file, kind_request

   !> One row of the table.
   type :: key_type
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

   logical, parameter :: yes = .true., no = .false.

   !> The table; its order is that of help texts, headers and `--print-case`
   type(key_type), parameter, public :: keys(*) = [ &
      key_type('pair', kind_text, '', all_runs, yes, '', '', &
      'pair of faces of the paper; transverse-tangential unless all is given'), &
      key_type('surface', kind_text, '', all_runs, yes, '', '', &
      'surface of Table 2: its eta, radius and sigma in place of the pair''s'), &
      key_type('eta', kind_real, '1/mm^2', all_runs, yes, '', '', &
      'asperity density'), &
      key_type('modulus', kind_real, 'MPa', all_runs, yes, '', '', &
      'equivalent modulus E* of the two faces (Eq. 4)'), &
      key_type('radius', kind_real, 'mm', all_runs, yes, '', '', &
      'summit radius'), &
      key_type('hardness', kind_real, 'MPa', all_runs, yes, '', '', &
      'hardness'), &
      key_type('yield_factor', kind_real, '', all_runs, yes, '', '', &
      'mean contact pressure at first yield over hardness, 0.05 to 1'), &
      key_type('sigma', kind_real, 'mm', all_runs, yes, '', '', &
      'standard deviation of summit heights'), &
      key_type('friction_coefficient', kind_real, '', command_shear, yes, '', '', &
      'Coulomb friction coefficient mu'), &
      key_type('critical_slip', kind_real, 'mm', command_shear, yes, '', '', &
      'largest elastic slip gcrit'), &
      key_type('initial_separation', kind_real, 'mm', all_runs, yes, '', '', &
      'separation d0 at zero overclosure; 4 sigma unless given'), &
      key_type('friction_rule', kind_choice, '', command_shear, yes, 'abaqus', &
      'abaqus dissipative', &
      'what elastic slip does when the pressure changes'), &
      key_type('slip_integration', kind_choice, '', command_shear, yes, 'exact', &
      'exact backward_euler', &
      'how the slip of an increment is integrated'), &
      key_type('accept_unphysical', kind_logical, '', all_runs, yes, 'false', '', &
      'let eta*radius*sigma below 0.0249 pass; results are flagged'), &
      key_type('separation', kind_list, 'mm', command_curve, no, '', '', &
      'separations, also from:to:count as an option; 4 sigma to 0 in 41 points unless given'), &
      key_type('control', kind_choice, '', command_press, no, 'pressure', &
      'pressure overclosure', &
      'what is ramped up and down'), &
      key_type('peak', kind_real, 'MPa or mm', command_press, no, '4.7', '', &
      'value at the top of the ramp; needed when control is overclosure'), &
      key_type('increments', kind_integer, '', command_press, no, '50', '', &
      'increments of each ramp'), &
      key_type('step_time', kind_real, 's', command_press, no, '1', '', &
      'time of each ramp'), &
      key_type('diameter', kind_real, 'mm', command_shear, no, '61.8', '', &
      'diameter of the two discs'), &
      key_type('normal_stress', kind_list, 'MPa', command_shear, no, '0.05 0.1 0.2', '', &
      'normal stresses on the full disc, one run each'), &
      key_type('rate', kind_real, 'mm/min', command_shear, no, '1.2', '', &
      'speed of the lower box'), &
      key_type('displacement', kind_list, 'mm', command_shear, no, '3', '', &
      'turning points of the lower box, such as 3,-3,3'), &
      key_type('displacement_increment', kind_real, 'mm', command_shear, no, '0.02', '', &
      'largest displacement in one increment'), &
      key_type('shrinking_overlap', kind_logical, '', command_shear, no, 'true', '', &
      'the overlap of the discs shrinks with displacement'), &
      key_type('shear_compliance', kind_real, 'mm/N', command_shear, no, '0', '', &
      'shear compliance of the two specimens together'), &
      key_type('csv', kind_file, '', all_tables, no, '', '', &
      'write all columns with 17 figures; - is standard output'), &
      key_type('json', kind_file, '', all_tables, no, '', '', &
      'write properties, units and all columns; - is standard output'), &
      key_type('plot', kind_file, '', all_runs, no, '', '', &
      'draw a picture, .svg, .png or .pdf (needs gnuplot)'), &
      key_type('print_case', kind_request, '', all_runs, no, '', '', &
      'print the effective input as a case file and stop'), &
      key_type('help', kind_request, '', everything, no, '', '', &
      'print this text')]

   integer, parameter, public :: n_keys = size(keys)

contains

   !> Place of a name in the table, zero when it is not there.
   pure integer function find_key(name)
      !> Name as in case files, in lower case
      character(len=*), intent(in) :: name

      do find_key = n_keys, 1, -1
         if (keys(find_key)%name == name) return
      end do
   end function find_key

   !> Whether a key belongs to a command.
   pure logical function belongs(key, command)
      !> Place in the table
      integer, intent(in) :: key
      !> One command
      integer, intent(in) :: command

      belongs = iand(keys(key)%commands, command) /= 0
   end function belongs

   !> Name of the option of a key, such as `--yield-factor`.
   pure function option_name(key) result(option)
      !> Place in the table
      integer, intent(in) :: key
      character(len=:), allocatable :: option
      integer :: i

      option = '--'//trim(keys(key)%name)
      do i = 1, len(option)
         if (option(i:i) == '_') option(i:i) = '-'
      end do
   end function option_name

   !> Names of the commands of a sum, such as `press, shear`.
   pure function command_names(commands) result(names)
      !> Sum of commands
      integer, intent(in) :: commands
      character(len=:), allocatable :: names
      character(len=8), parameter :: each(*) = [character(len=8) :: &
         'curve', 'press', 'shear', 'pairs', 'version', 'help', 'citation']
      integer :: i

      names = ''
      do i = 1, size(each)
         if (.not. btest(commands, i - 1)) cycle
         if (names /= '') names = names//', '
         names = names//trim(each(i))
      end do
   end function command_names

end module app_keys
