!> The one table of everything a user can set. The case-file scanner, the options, the help
!> texts and `--print-case` all read it, so that none of them can disagree.
module asperity_program_input_keys
   use asperity_program_input_key_table, only: all_drawn, all_laws, all_runs, all_tables, &
      command_citation, command_curve, command_deck_shear, command_deck_tenon, command_help, &
      command_hysteresis, command_pairs, command_press, command_shear, command_surface, &
      command_table, command_tenon, command_version, decks, everything, key_type, kind_choice, &
      kind_file, kind_integer, kind_list, kind_logical, kind_real, kind_request, kind_sweep, &
      kind_text, moves, records, shears, sized, slides, tabulates, tenons, with_friction
   use asperity_program_input_surface_keys, only: surface_keys
   implicit none
   private
   public :: find_key, option_name, command_names, belongs
   public :: command_citation, command_curve, command_deck_shear, command_deck_tenon, &
      command_help, command_hysteresis, command_pairs, command_press, command_shear, &
      command_surface, command_table, command_tenon, command_version, decks, key_type, &
      kind_choice, kind_file, kind_integer, kind_list, kind_logical, kind_real, kind_request, &
      kind_sweep, kind_text, shears, tenons

   logical, parameter :: yes = .true., no = .false.

   !> The table; its order is that of help texts, headers and `--print-case`. Two keys are called
   !> `pair`, of different commands
   type(key_type), parameter, public :: keys(*) = [surface_keys, &
      key_type('pair', kind_text, '', all_runs, yes, '', '', &
      'pair of faces of the paper; transverse-tangential unless all is given'), &
      key_type('surface', kind_text, '', all_runs, yes, '', '', &
      'surface of Table 2: its eta, radius and sigma in place of the pair''s'), &
      key_type('eta', kind_real, '1/mm^2', all_runs, yes, '', '', &
      'asperity density'), &
      key_type('modulus', kind_real, 'MPa', all_laws, yes, '', '', &
      'equivalent modulus E* of the two faces (Eq. 4)'), &
      key_type('radius', kind_real, 'mm', all_runs, yes, '', '', &
      'summit radius'), &
      key_type('hardness', kind_real, 'MPa', all_laws, yes, '', '', &
      'hardness'), &
      key_type('yield_factor', kind_real, '', all_laws, yes, '', '', &
      'mean contact pressure at first yield over hardness, 0.05 to 1'), &
      key_type('sigma', kind_real, 'mm', all_runs, yes, '', '', &
      'standard deviation of summit heights'), &
      key_type('friction_coefficient', kind_real, '', with_friction, yes, '', '', &
      'Coulomb friction coefficient mu'), &
      key_type('critical_slip', kind_real, 'mm', with_friction, yes, '', '', &
      'largest elastic slip gcrit'), &
      key_type('initial_separation', kind_real, 'mm', all_laws, yes, '', '', &
      'separation d0 at zero overclosure; 4 sigma unless given'), &
      key_type('friction_rule', kind_choice, '', slides, yes, 'abaqus', &
      'abaqus dissipative', &
      'what elastic slip does when the pressure changes'), &
      key_type('slip_integration', kind_choice, '', slides, yes, 'exact', &
      'exact backward_euler', &
      'how the slip of an increment is integrated'), &
      key_type('side_pair', kind_text, '', tenons, yes, 'tangential-tangential', '', &
      'pair of faces of the two sides of the tenon'), &
      key_type('side_friction', kind_real, '', tenons, yes, '', '', &
      'Coulomb friction coefficient of the sides; friction_coefficient unless given'), &
      key_type('side_critical_slip', kind_real, 'mm', tenons, yes, '', '', &
      'largest elastic slip of the sides; critical_slip unless given'), &
      key_type('accept_unphysical', kind_logical, '', all_runs, yes, 'false', '', &
      'let properties that no face or solid has pass; results are flagged'), &
      key_type('accept_sizes', kind_logical, '', sized, no, 'false', '', &
      'let sizes and pressures pass that look like another unit, and large rotations'), &
      key_type('separation', kind_list, 'mm', command_curve + command_surface, no, '', '', &
      'separations, also from:to:count as an option; 4 sigma to 0 unless given'), &
      key_type('control', kind_choice, '', command_press, no, 'pressure', &
      'pressure overclosure', &
      'what is ramped up and down'), &
      key_type('peak', kind_real, 'MPa or mm', command_press, no, '4.7', '', &
      'value at the top of the ramp; needed when control is overclosure'), &
      key_type('increments', kind_integer, '', command_press, no, '50', '', &
      'increments of each ramp'), &
      key_type('step_time', kind_real, 's', command_press, no, '1', '', &
      'time of each ramp'), &
      key_type('diameter', kind_real, 'mm', shears, no, '61.8', '', &
      'diameter of the two discs'), &
      key_type('normal_stress', kind_list, 'MPa', shears, no, '0.05 0.1 0.2', '', &
      'normal stresses on the full disc, one run each'), &
      key_type('rate', kind_real, 'mm/min', shears, no, '1.2', '', &
      'speed of the lower box'), &
      key_type('displacement', kind_list, 'mm', shears, no, '3', '', &
      'turning points of the lower box, such as 3,-3,3'), &
      key_type('displacement_increment', kind_real, 'mm', moves, no, '', '', &
      'largest displacement in one increment; shear 0.02, deck 0.05, tenon 0.8 unless given'), &
      key_type('shrinking_overlap', kind_logical, '', command_shear, no, 'true', '', &
      'the overlap of the discs shrinks with displacement'), &
      key_type('shear_compliance', kind_real, 'mm/N', command_shear, no, '0', '', &
      'shear compliance of the two specimens together'), &
      key_type('largest_pressure', kind_real, 'MPa', tabulates, no, '', '', &
      'pressure up to which the tolerance holds; table 4.7, deck the hardness unless given'), &
      key_type('smallest_pressure', kind_real, 'MPa', tabulates, no, '', '', &
      'pressure from which it holds; unless given, 1e-9 2 pi eta R H sigma, as points open'), &
      key_type('tolerance', kind_real, '', tabulates, no, '0.01', '', &
      'relative error of linear interpolation between rows'), &
      key_type('rows', kind_integer, '', tabulates, no, '200', '', &
      'most rows; CalculiX takes 200'), &
      key_type('stick_pressure', kind_real, 'MPa', tabulates, no, '', '', &
      'pressure of CalculiX'' stick slope; largest_pressure, deck: as loaded, unless given'), &
      key_type('length', kind_real, 'mm', tenons, no, '300', '', &
      'length of the tenon in the mortise'), &
      key_type('height', kind_real, 'mm', tenons, no, '300', '', &
      'height of the tenon'), &
      key_type('width', kind_real, 'mm', tenons, no, '105', '', &
      'width of the tenon'), &
      key_type('clearance', kind_real, 'mm', tenons, no, '0.5', '', &
      'gap above the tenon, and the same below it'), &
      key_type('clearance_above', kind_real, 'mm', tenons, no, '', '', &
      'gap above the tenon; clearance unless given'), &
      key_type('clearance_below', kind_real, 'mm', tenons, no, '', '', &
      'gap below the tenon; clearance unless given'), &
      key_type('gap', kind_choice, '', tenons, no, 'mean_plane', 'mean_plane first_touch', &
      'what the clearance is measured between'), &
      key_type('extension', kind_real, 'mm', command_tenon, no, '', '', &
      'length of full material past the column face; a fifth of height unless given'), &
      key_type('arm', kind_real, 'mm', tenons, no, '500', '', &
      'distance of the load point from arm_datum; the moment is force times arm'), &
      key_type('arm_datum', kind_choice, '', tenons, no, 'column_face', &
      'column_face column_axis', &
      'where the arm is measured from'), &
      key_type('side_pressure', kind_real, 'MPa', tenons, no, '0.2', '', &
      'pressure on each side face, 0 for none'), &
      key_type('axial_rule', kind_choice, '', tenons, no, 'spring', &
      'spring fixed free force', &
      'what resists pull-out'), &
      key_type('axial_stiffness', kind_real, 'N/mm', tenons, no, '500', '', &
      'stiffness of the axial spring'), &
      key_type('axial_force', kind_real, 'N', command_tenon, no, '0', '', &
      'axial force of axial_rule = force, positive pulls the tenon out'), &
      key_type('shoulders', kind_logical, '', tenons, no, 'false', '', &
      'shoulders above and below the tenon bear on the column face; no extension then'), &
      key_type('shoulder_height', kind_real, 'mm', command_tenon, no, '', '', &
      'height of each shoulder; a sixth of height unless given'), &
      key_type('shoulder_gap', kind_real, 'mm', command_tenon, no, '0', '', &
      'gap between each shoulder and the column face'), &
      key_type('column_load', kind_real, 'N', tenons, no, '0', '', &
      'vertical load of the column; the plane replay does not use it'), &
      key_type('bearing_modulus', kind_real, 'MPa', tenons, no, '351', '', &
      'modulus of the wood perpendicular to the grain'), &
      key_type('bearing_depth', kind_real, 'mm', command_tenon, no, '', '', &
      'depth of wood that the bearing compresses; half of height unless given'), &
      key_type('bearing_strength', kind_real, 'MPa', tenons, no, '4.7', '', &
      'strength fc90 perpendicular to the grain'), &
      key_type('hardening', kind_real, '', tenons, no, '0.02', '', &
      'stiffness after yield over bearing_modulus/bearing_depth'), &
      key_type('column_modulus', kind_real, 'MPa', tenons, no, '3727', '', &
      'modulus of the column parallel to the grain, 0 for rigid'), &
      key_type('column_depth', kind_real, 'mm', command_tenon, no, '', '', &
      'depth of the column that the bearing compresses; half of height unless given'), &
      key_type('column_strength', kind_real, 'MPa', tenons, no, '50.1', '', &
      'strength fc0 of the column parallel to the grain'), &
      key_type('column_hardening', kind_real, '', tenons, no, '0.02', '', &
      'stiffness after yield over column_modulus/column_depth'), &
      key_type('face_points', kind_integer, '', command_tenon, no, '100', '', &
      'contact points along the upper, and along the lower face'), &
      key_type('side_points', kind_integer, '', command_tenon, no, '12', '', &
      'contact points along either direction of a side face'), &
      key_type('shoulder_points', kind_integer, '', command_tenon, no, '16', '', &
      'contact points over the height of each shoulder'), &
      key_type('amplitudes', kind_list, 'mm', tenons, no, '0.5 1 2 4 8 16 24 32 48', '', &
      'amplitudes at the load point, growing'), &
      key_type('cycles', kind_list, '', tenons, no, '', '', &
      'cycles at each amplitude; 1, and 3 from 8 mm on of the default amplitudes'), &
      key_type('history', kind_text, '', tenons, no, '', '', &
      'CSV file of recorded displacements or rotations, in place of amplitudes'), &
      key_type('history_quantity', kind_choice, '', tenons, no, '', 'displacement rotation', &
      'what is taken of the history; rotation is displacement over arm; as its columns say'), &
      key_type('record', kind_list, '', command_tenon, no, '', '', &
      'steps whose points --points holds; four of the largest loop unless given'), &
      key_type('through', kind_choice, '', command_tenon, no, 'direct', 'direct uinter', &
      'what updates a contact point'), &
      key_type('solver', kind_choice, '', decks, no, 'calculix', 'calculix abaqus', &
      'what the deck is for'), &
      key_type('contact', kind_choice, '', decks, no, 'uinter', 'uinter table hard', &
      'UINTER, the law as a table, or hard contact'), &
      key_type('mesh_size', kind_real, 'mm', decks, no, '', '', &
      'edge of an element aimed at; shear 2.5, tenon a tenth of height unless given'), &
      key_type('element', kind_choice, '', decks, no, 'c3d8i', 'c3d8i c3d8 c3d8r', &
      'element; the paper''s C3D8R deforms without resistance in CalculiX'), &
      key_type('plasticity', kind_choice, '', decks, no, 'elastic', 'elastic plastic', &
      'wood; plastic is Hill''s criterion in ABAQUS, Mises'' in CalculiX'), &
      key_type('field', kind_choice, '', decks, no, 'contact', 'contact all', &
      'results of all nodes in every increment: displacement and contact, or also stress'), &
      key_type('penalty', kind_real, 'MPa/mm', decks, no, '100', '', &
      'pressure over penetration of hard contact in CalculiX'), &
      key_type('search_distance', kind_real, 'mm', decks, no, '3', '', &
      'clearance below which CalculiX with UINTER has contact springs'), &
      key_type('disc_height', kind_real, 'mm', command_deck_shear, no, '10', '', &
      'height of each disc'), &
      key_type('upper_grain', kind_choice, '', command_deck_shear, no, '', 'normal along', &
      'grain of the upper disc; along its face for pair tangential-tangential, else normal'), &
      key_type('column_height', kind_real, 'mm', command_deck_tenon, no, '', '', &
      'height of the column; 10/3 of height unless given'), &
      key_type('column_width', kind_real, 'mm', command_deck_tenon, no, '', '', &
      'width of the column across the beam; length unless given'), &
      key_type('tail', kind_real, 'mm', command_deck_tenon, no, '0', '', &
      'length of the beam behind the column'), &
      key_type('edge_relief', kind_real, 'mm', command_deck_tenon, no, '', '', &
      'no contact so near the edges of the mortise; a hundredth of height unless given'), &
      key_type('side_interference', kind_real, 'mm', command_deck_tenon, no, '', '', &
      'interference at each side; made for side_pressure unless given'), &
      key_type('stroke_increments', kind_integer, '', command_deck_tenon, no, '10', '', &
      'fewest increments of a stroke; twice as many beyond 16 mm'), &
      key_type('record_file', kind_text, '', command_hysteresis, no, '', '', &
      'the record, as FILE.csv without an option'), &
      key_type('quantity', kind_choice, '', command_hysteresis, no, '', 'force moment', &
      'what is taken of the record: displacement and force, or rotation and moment'), &
      key_type('displacement_column', kind_text, '', records, no, '', '', &
      'name or number of the column of displacement or rotation; found by name and unit'), &
      key_type('force_column', kind_text, '', command_hysteresis, no, '', '', &
      'name or number of the column of force or moment; found by name and unit'), &
      key_type('where', kind_text, '', records, no, '', '', &
      'NAME=VALUE,...: only rows that have these values; all tests of the file unless given'), &
      key_type('separator', kind_choice, '', records, no, 'auto', &
      'auto comma semicolon tab blank', &
      'what separates columns'), &
      key_type('decimal', kind_choice, '', records, no, 'auto', 'auto point comma', &
      'decimal sign'), &
      key_type('skip_lines', kind_integer, '', records, no, '0', '', &
      'lines passed over before the column names'), &
      key_type('displacement_zero', kind_real, '', command_hysteresis, no, '0', '', &
      'reading at rest, subtracted from the column of displacement'), &
      key_type('displacement_factor', kind_real, '', command_hysteresis, no, '1', '', &
      'then multiplied by; -1 turns the sign, 1/arm makes a rotation'), &
      key_type('force_zero', kind_real, '', command_hysteresis, no, '0', '', &
      'reading at rest, subtracted from the column of force'), &
      key_type('force_factor', kind_real, '', command_hysteresis, no, '1', '', &
      'then multiplied by'), &
      key_type('displacement_unit', kind_text, '', records, no, '', '', &
      'unit (hysteresis: after zero and factor); that of the file, else mm or rad'), &
      key_type('force_unit', kind_text, '', command_hysteresis, no, '', '', &
      'label, after zero and factor; that of the file, else N or kN m'), &
      key_type('threshold', kind_real, '', command_hysteresis, no, '', '', &
      'reversals up to this are noise; 1/400 of the range or more by noise, unless above 0'), &
      key_type('peaks', kind_choice, '', command_hysteresis, no, 'envelope', &
      'envelope displacement force', &
      'skeleton: first-cycle envelope, or the tip or the largest force of each first cycle'), &
      key_type('outliers', kind_choice, '', command_hysteresis, no, 'drop', 'drop keep', &
      'single samples that leap away and back, which a remark names'), &
      key_type('amplitude_tolerance', kind_real, '', command_hysteresis, no, '0.05', '', &
      'share by which an amplitude must exceed all before to be a new one'), &
      key_type('elastic_fraction', kind_real, '', command_hysteresis, no, '0.4', '', &
      'share of the peak force that the elastic stiffness goes through'), &
      key_type('ultimate_fraction', kind_real, '', command_hysteresis, no, '0.8', '', &
      'share of the peak force, past the peak, at the ultimate point'), &
      key_type('csv', kind_file, '', all_tables, no, '', '', &
      'write all columns with 17 figures; - is standard output'), &
      key_type('json', kind_file, '', all_tables, no, '', '', &
      'write properties, units and all columns; - is standard output'), &
      key_type('plot', kind_file, '', all_drawn, no, '', '', &
      'draw a picture, .svg, .png or .pdf (needs gnuplot)'), &
      key_type('abaqus', kind_file, '', command_table, no, '', '', &
      'write the interaction for an ABAQUS deck; - is standard output'), &
      key_type('calculix', kind_file, '', command_table, no, '', '', &
      'write the interaction for a CalculiX deck; - is standard output'), &
      key_type('inp', kind_file, '', decks, no, '', '', &
      'write the deck; - is standard output'), &
      key_type('points', kind_file, '', command_tenon, no, '', '', &
      'write every contact point at the steps of record as CSV; - is standard output'), &
      key_type('report', kind_file, '', command_tenon, no, '', '', &
      'write a page of case, table and pictures, .html (needs gnuplot)'), &
      key_type('sweep', kind_sweep, '', command_tenon, no, '', '', &
      'run all combinations; NAME=a,b,c or NAME=start:stop:count; may be repeated'), &
      key_type('print_case', kind_request, '', all_runs, no, '', '', &
      'print the effective input as a case file and stop'), &
      key_type('help', kind_request, '', everything, no, '', '', &
      'print this text')]

   integer, parameter, public :: n_keys = size(keys)

contains

   !> Place of a name in the table, zero when it is not there.
   pure integer function find_key(name, command)
      !> Name as in case files, in lower case
      character(len=*), intent(in) :: name
      !> Only keys that belong to it; all when absent
      integer, intent(in), optional :: command

      do find_key = n_keys, 1, -1
         if (keys(find_key)%name /= name) cycle
         if (.not. present(command)) return
         if (belongs(find_key, command)) return
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
      character(len=10), parameter :: each(*) = [character(len=10) :: &
         'curve', 'press', 'shear', 'pairs', 'version', 'help', 'citation', 'hysteresis', 'tenon', &
         'table', 'deck shear', 'deck tenon', 'surface']
      integer :: i

      names = ''
      do i = 1, size(each)
         if (.not. btest(commands, i - 1)) cycle
         if (names /= '') names = names//', '
         names = names//trim(each(i))
      end do
   end function command_names

end module asperity_program_input_keys
