!> Keys of `asperity surface` that no other command has.
module asperity_program_input_surface_keys
   use asperity_program_input_key_table, only: command_surface, key_type, kind_choice, kind_file, &
      kind_integer, kind_list, kind_logical, kind_real, kind_text
   implicit none
   private

   logical, parameter :: yes = .true., no = .false.

   !> The rows; the first is another `pair` than that of the other commands
   type(key_type), parameter, public :: surface_keys(*) = [ &
      key_type('pair', kind_logical, '', command_surface, no, 'false', '', &
      'combine the maps of two faces that touch'), &
      key_type('material', kind_text, '', command_surface, yes, '', '', &
      'pair of the paper for modulus, hardness, yield factor and friction'), &
      key_type('map_file', kind_text, '', command_surface, no, '', '', &
      'the height map, as FILE without an option'), &
      key_type('second_map', kind_text, '', command_surface, no, '', '', &
      'the map of the other face, as a second FILE without an option'), &
      key_type('mirror', kind_choice, '', command_surface, no, 'x', 'x y none', &
      'how the second map is turned over to face the first: its x or its y reversed'), &
      key_type('lateral_unit', kind_choice, '', command_surface, no, '', 'm cm mm um nm', &
      'unit of x, y and steps in a file that does not tell it'), &
      key_type('height_unit', kind_choice, '', command_surface, no, '', 'm cm mm um nm', &
      'unit of heights in a file that does not tell it'), &
      key_type('step', kind_list, 'mm', command_surface, no, '', '', &
      'distance of neighbours, or that in x and that in y; of a file that does not tell it'), &
      key_type('missing_value', kind_real, '', command_surface, no, '', '', &
      'number that marks missing points in a text, as it stands there'), &
      key_type('missing', kind_choice, '', command_surface, no, 'mask', 'mask fill', &
      'points without height: leave out, or fill in smoothly'), &
      key_type('most_missing', kind_real, '', command_surface, no, '0.05', '', &
      'share of missing points up to which a map is taken'), &
      key_type('form', kind_integer, '', command_surface, no, '1', '', &
      'degree of the polynomial of x and y that is removed, 1 (a plane) to 8'), &
      key_type('short_cutoff', kind_real, 'mm', command_surface, no, '', '', &
      'S filter, Gaussian (ISO 16610-61): removes shorter waves; none unless given'), &
      key_type('long_cutoff', kind_real, 'mm', command_surface, no, '', '', &
      'L filter: removes longer waves; none unless given'), &
      key_type('pruning', kind_real, '', command_surface, no, '0.05', '', &
      'hills lower than this share of sz are no peaks (Wolf pruning)'), &
      key_type('tiles', kind_integer, '', command_surface, no, '4', '', &
      'the map is split into tiles x tiles for the uncertainties'), &
      key_type('route', kind_choice, '', command_surface, no, 'nayak', 'nayak paper', &
      'parameters for --case and --plot: of moments, or spd, spc, sq'), &
      key_type('verify', kind_logical, '', command_surface, no, 'false', '', &
      'sum the law over the summits of the map beside the Gaussian integral'), &
      key_type('generate', kind_logical, '', command_surface, no, 'false', '', &
      'make a random surface in place of a file'), &
      key_type('map_points', kind_list, '', command_surface, no, '512', '', &
      'its points, or those along x and along y'), &
      key_type('sq', kind_real, 'mm', command_surface, no, '0.02', '', &
      'its root mean square height'), &
      key_type('correlation_length', kind_list, 'mm', command_surface, no, '', '', &
      'where correlation falls to 1/e, or that in x and that in y; 10 steps unless given'), &
      key_type('length_direction', kind_real, 'deg', command_surface, no, '0', '', &
      'angle of the first correlation length, from x towards y'), &
      key_type('spectrum', kind_choice, '', command_surface, no, 'gaussian', &
      'gaussian exponential self_affine', &
      'its autocorrelation, or a self-affine spectrum'), &
      key_type('hurst', kind_real, '', command_surface, no, '0.8', '', &
      'Hurst exponent of self_affine'), &
      key_type('longest_wave', kind_real, 'mm', command_surface, no, '', '', &
      'self_affine: the spectrum is flat above; a quarter of the map unless given'), &
      key_type('shortest_wave', kind_real, 'mm', command_surface, no, '', '', &
      'self_affine: no shorter waves; 8 steps unless given'), &
      key_type('ssk', kind_real, '', command_surface, no, '0', '', &
      'its skewness'), &
      key_type('sku', kind_real, '', command_surface, no, '3', '', &
      'its kurtosis'), &
      key_type('seed', kind_integer, '', command_surface, no, '1', '', &
      'seed of its random numbers'), &
      key_type('case', kind_file, '', command_surface, no, '', '', &
      'write the parameters of route as a case for curve, press, shear, tenon and table'), &
      key_type('map', kind_file, '', command_surface, no, '', '', &
      'write the map as it was analysed, .sdf, .xyz or .csv')]

end module asperity_program_input_surface_keys
