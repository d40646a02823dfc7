!> Reads case files by Fortran's own namelist READ and prints every key that was set, with all
!> figures, one per line: the independent reading that the program's scanner is compared with.
!> The status is 1 when READ refuses a file.
program read_case
   use, intrinsic :: iso_fortran_env, only: error_unit, real64
   implicit none
   integer, parameter :: wp = real64, longest_list = 1000
   real(wp), parameter :: unset = -huge(1.0_wp)
   integer, parameter :: unset_integer = -huge(1)

   real(wp) :: eta, modulus, radius, hardness, yield_factor, sigma, friction_coefficient
   real(wp) :: critical_slip, initial_separation, peak, step_time, diameter, rate
   real(wp) :: displacement_increment, shear_compliance
   real(wp), dimension(longest_list) :: separation, normal_stress, displacement
   integer :: increments
   logical :: accept_unphysical, accept_sizes, shrinking_overlap
   character(len=80) :: pair, surface, friction_rule, slip_integration, control
   ! Keys of the tenon joint
   real(wp) :: side_friction, side_critical_slip, length, height, width, clearance, clearance_above
   real(wp) :: clearance_below, extension, arm, side_pressure, axial_stiffness, axial_force
   real(wp) :: shoulder_height, shoulder_gap, column_load, bearing_modulus, bearing_depth
   real(wp) :: bearing_strength, hardening, column_modulus, column_depth, column_strength
   real(wp) :: column_hardening
   real(wp), dimension(longest_list) :: amplitudes, cycles, record
   integer :: face_points, side_points, shoulder_points
   logical :: shoulders
   character(len=80) :: side_pair, gap, arm_datum, axial_rule, history, through
   character(len=80) :: displacement_column, history_quantity, where, separator, decimal
   character(len=80) :: displacement_unit
   integer :: skip_lines
   ! Keys of the table
   real(wp) :: largest_pressure, smallest_pressure, tolerance, stick_pressure
   integer :: rows
   ! Keys of the decks
   real(wp) :: mesh_size, penalty, search_distance, disc_height, column_height, column_width, tail
   real(wp) :: side_interference, edge_relief
   integer :: stroke_increments
   character(len=80) :: solver, contact, element, plasticity, field, upper_grain
   namelist /asperity/ pair, surface, eta, modulus, radius, hardness, yield_factor, sigma, &
      friction_coefficient, critical_slip, initial_separation, friction_rule, &
      slip_integration, accept_unphysical, accept_sizes, separation, control, peak, increments, &
      step_time, &
      diameter, normal_stress, rate, displacement, displacement_increment, shrinking_overlap, &
      shear_compliance, &
      side_pair, side_friction, side_critical_slip, length, height, width, clearance, &
      clearance_above, clearance_below, gap, extension, arm, arm_datum, side_pressure, &
      axial_rule, axial_stiffness, axial_force, shoulders, shoulder_height, shoulder_gap, &
      column_load, bearing_modulus, bearing_depth, bearing_strength, hardening, column_modulus, &
      column_depth, column_strength, column_hardening, face_points, side_points, &
      shoulder_points, amplitudes, cycles, history, record, through, displacement_column, &
      history_quantity, where, separator, decimal, skip_lines, displacement_unit, &
      largest_pressure, smallest_pressure, tolerance, rows, stick_pressure, &
      solver, contact, mesh_size, element, plasticity, field, penalty, search_distance, &
      disc_height, upper_grain, column_height, column_width, tail, side_interference, edge_relief, &
      stroke_increments

   character(len=1000) :: path, message
   integer :: unit, status, pass

   call get_command_argument(1, path)
   ! A logical has no value that means "unset": it is set if two defaults give the same
   do pass = 1, 2
      call unset_all()
      accept_unphysical = pass == 1
      accept_sizes = pass == 1
      shrinking_overlap = pass == 1
      shoulders = pass == 1
      open (newunit=unit, file=trim(path), status='old', action='read')
      read (unit, nml=asperity, iostat=status, iomsg=message)
      close (unit)
      if (status /= 0) then
         write (error_unit, '(4a)') trim(path), ': ', trim(message)
         error stop 1
      end if
      if (pass == 1) call print_all()
      call print_logical('accept_unphysical', accept_unphysical, pass)
      call print_logical('accept_sizes', accept_sizes, pass)
      call print_logical('shrinking_overlap', shrinking_overlap, pass)
      call print_logical('shoulders', shoulders, pass)
   end do

contains

   subroutine unset_all()
      eta = unset
      largest_pressure = unset
      smallest_pressure = unset
      tolerance = unset
      stick_pressure = unset
      rows = unset_integer
      mesh_size = unset
      penalty = unset
      search_distance = unset
      disc_height = unset
      column_height = unset
      column_width = unset
      tail = unset
      side_interference = unset
      edge_relief = unset
      stroke_increments = unset_integer
      solver = ''
      contact = ''
      element = ''
      plasticity = ''
      field = ''
      upper_grain = ''
      modulus = unset
      radius = unset
      hardness = unset
      yield_factor = unset
      sigma = unset
      friction_coefficient = unset
      critical_slip = unset
      initial_separation = unset
      peak = unset
      step_time = unset
      diameter = unset
      rate = unset
      displacement_increment = unset
      shear_compliance = unset
      separation = unset
      normal_stress = unset
      displacement = unset
      increments = unset_integer
      pair = ''
      surface = ''
      friction_rule = ''
      slip_integration = ''
      control = ''
      side_friction = unset
      side_critical_slip = unset
      length = unset
      height = unset
      width = unset
      clearance = unset
      clearance_above = unset
      clearance_below = unset
      extension = unset
      arm = unset
      side_pressure = unset
      axial_stiffness = unset
      axial_force = unset
      shoulder_height = unset
      shoulder_gap = unset
      column_load = unset
      bearing_modulus = unset
      bearing_depth = unset
      bearing_strength = unset
      hardening = unset
      column_modulus = unset
      column_depth = unset
      column_strength = unset
      column_hardening = unset
      amplitudes = unset
      cycles = unset
      record = unset
      face_points = unset_integer
      side_points = unset_integer
      shoulder_points = unset_integer
      side_pair = ''
      gap = ''
      arm_datum = ''
      axial_rule = ''
      history = ''
      through = ''
      displacement_column = ''
      history_quantity = ''
      where = ''
      separator = ''
      decimal = ''
      displacement_unit = ''
      skip_lines = unset_integer
   end subroutine unset_all

   subroutine print_all()
      call print_text('pair', pair)
      call print_text('surface', surface)
      call print_reals('eta', [eta])
      call print_reals('modulus', [modulus])
      call print_reals('radius', [radius])
      call print_reals('hardness', [hardness])
      call print_reals('yield_factor', [yield_factor])
      call print_reals('sigma', [sigma])
      call print_reals('friction_coefficient', [friction_coefficient])
      call print_reals('critical_slip', [critical_slip])
      call print_reals('initial_separation', [initial_separation])
      call print_text('friction_rule', friction_rule)
      call print_text('slip_integration', slip_integration)
      call print_reals('separation', separation)
      call print_text('control', control)
      call print_reals('peak', [peak])
      call print_integer('increments', increments)
      call print_reals('step_time', [step_time])
      call print_reals('diameter', [diameter])
      call print_reals('normal_stress', normal_stress)
      call print_reals('rate', [rate])
      call print_reals('displacement', displacement)
      call print_reals('displacement_increment', [displacement_increment])
      call print_reals('shear_compliance', [shear_compliance])
      call print_text('side_pair', side_pair)
      call print_reals('side_friction', [side_friction])
      call print_reals('side_critical_slip', [side_critical_slip])
      call print_reals('length', [length])
      call print_reals('height', [height])
      call print_reals('width', [width])
      call print_reals('clearance', [clearance])
      call print_reals('clearance_above', [clearance_above])
      call print_reals('clearance_below', [clearance_below])
      call print_text('gap', gap)
      call print_reals('extension', [extension])
      call print_reals('arm', [arm])
      call print_text('arm_datum', arm_datum)
      call print_reals('side_pressure', [side_pressure])
      call print_text('axial_rule', axial_rule)
      call print_reals('axial_stiffness', [axial_stiffness])
      call print_reals('axial_force', [axial_force])
      call print_reals('shoulder_height', [shoulder_height])
      call print_reals('shoulder_gap', [shoulder_gap])
      call print_reals('column_load', [column_load])
      call print_reals('bearing_modulus', [bearing_modulus])
      call print_reals('bearing_depth', [bearing_depth])
      call print_reals('bearing_strength', [bearing_strength])
      call print_reals('hardening', [hardening])
      call print_reals('column_modulus', [column_modulus])
      call print_reals('column_depth', [column_depth])
      call print_reals('column_strength', [column_strength])
      call print_reals('column_hardening', [column_hardening])
      call print_integer('face_points', face_points)
      call print_integer('side_points', side_points)
      call print_integer('shoulder_points', shoulder_points)
      call print_reals('amplitudes', amplitudes)
      call print_reals('cycles', cycles)
      call print_text('history', history)
      call print_reals('record', record)
      call print_text('through', through)
      call print_text('displacement_column', displacement_column)
      call print_text('history_quantity', history_quantity)
      call print_text('where', where)
      call print_text('separator', separator)
      call print_text('decimal', decimal)
      call print_text('displacement_unit', displacement_unit)
      call print_integer('skip_lines', skip_lines)
      call print_reals('mesh_size', [mesh_size])
      call print_reals('penalty', [penalty])
      call print_reals('search_distance', [search_distance])
      call print_reals('disc_height', [disc_height])
      call print_reals('column_height', [column_height])
      call print_reals('column_width', [column_width])
      call print_reals('tail', [tail])
      call print_reals('side_interference', [side_interference])
      call print_reals('edge_relief', [edge_relief])
      call print_integer('stroke_increments', stroke_increments)
      call print_text('solver', solver)
      call print_text('contact', contact)
      call print_text('element', element)
      call print_text('plasticity', plasticity)
      call print_text('field', field)
      call print_text('upper_grain', upper_grain)
      call print_reals('largest_pressure', [largest_pressure])
      call print_reals('smallest_pressure', [smallest_pressure])
      call print_reals('tolerance', [tolerance])
      call print_integer('rows', rows)
      call print_reals('stick_pressure', [stick_pressure])
   end subroutine print_all

   subroutine print_text(name, value)
      character(len=*), intent(in) :: name, value

      if (value /= '') print '(3a)', name, ' ', trim(value)
   end subroutine print_text

   subroutine print_integer(name, value)
      character(len=*), intent(in) :: name
      integer, intent(in) :: value

      if (value /= unset_integer) print '(2a, i0)', name, ' ', value
   end subroutine print_integer

   subroutine print_reals(name, values)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: values(:)
      integer :: n

      n = count(values > unset)
      if (n > 0) print '(a, *(1x, es24.16e3))', name, values(:n)
   end subroutine print_reals

   !> Print a logical that both passes agree on, in the second.
   subroutine print_logical(name, value, pass)
      character(len=*), intent(in) :: name
      logical, intent(in) :: value
      integer, intent(in) :: pass

      if (pass == 2 .and. value) print '(2a)', name, ' true'
      if (pass == 1 .and. .not. value) print '(2a)', name, ' false'
   end subroutine print_logical

end program read_case
