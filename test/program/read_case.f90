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
   logical :: accept_unphysical, shrinking_overlap
   character(len=80) :: pair, surface, friction_rule, slip_integration, control
   namelist /asperity/ pair, surface, eta, modulus, radius, hardness, yield_factor, sigma, &
      friction_coefficient, critical_slip, initial_separation, friction_rule, &
      slip_integration, accept_unphysical, separation, control, peak, increments, step_time, &
      diameter, normal_stress, rate, displacement, displacement_increment, shrinking_overlap, &
      shear_compliance

   character(len=1000) :: path, message
   integer :: unit, status, pass

   call get_command_argument(1, path)
   ! A logical has no value that means "unset": it is set if two defaults give the same
   do pass = 1, 2
      call unset_all()
      accept_unphysical = pass == 1
      shrinking_overlap = pass == 1
      open (newunit=unit, file=trim(path), status='old', action='read')
      read (unit, nml=asperity, iostat=status, iomsg=message)
      close (unit)
      if (status /= 0) then
         write (error_unit, '(4a)') trim(path), ': ', trim(message)
         error stop 1
      end if
      if (pass == 1) call print_all()
      call print_logical('accept_unphysical', accept_unphysical, pass)
      call print_logical('shrinking_overlap', shrinking_overlap, pass)
   end do

contains

   subroutine unset_all()
      eta = unset
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
      if (increments /= unset_integer) print '(a, i0)', 'increments ', increments
      call print_reals('step_time', [step_time])
      call print_reals('diameter', [diameter])
      call print_reals('normal_stress', normal_stress)
      call print_reals('rate', [rate])
      call print_reals('displacement', displacement)
      call print_reals('displacement_increment', [displacement_increment])
      call print_reals('shear_compliance', [shear_compliance])
   end subroutine print_all

   subroutine print_text(name, value)
      character(len=*), intent(in) :: name, value

      if (value /= '') print '(3a)', name, ' ', trim(value)
   end subroutine print_text

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
