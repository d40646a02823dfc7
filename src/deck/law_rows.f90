!> The normal law as rows of pressure and overclosure, for hosts that have no user routine: between
!> rows they interpolate linearly.
!>
!> Rows are placed one after the other from the smallest pressure on, each as far from the one
!> before as the error of the straight line between them allows; for a convex law no placement
!> needs fewer. As a straight line lies above a convex law, all pressures are lowered by one factor,
!> which leaves half of the error on either side and saves three rows in ten. Below the smallest
!> pressure no relative error can hold, as the table ends in zero there and the law does not: it is
!> bounded absolutely. Beyond the largest pressure one more row carries the law's last slope on.
module asperity_deck_law_rows
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_row_lines, only: line_errors, place_rows, points_between
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic
   implicit none
   private
   public :: law_table, new_law_table, stick_slope

   !> Relative error and most rows unless given
   real(wp), parameter, public :: default_tolerance = 0.01_wp
   integer, parameter, public :: default_most_rows = 200
   !> How far the last row is beyond the largest pressure, in sigma
   real(wp), parameter, public :: reach = 200.0_wp

   real(wp), parameter :: smallest_tolerance = 1.0e-6_wp, largest_tolerance = 0.2_wp
   !> Zero, two rows of the law, and the one beyond
   integer, parameter :: fewest_rows = 4
   !> The first row is where the law has the smallest pressure over this: the line from there to the
   !> second row is then about as far above the law as the law is above zero at the first
   real(wp), parameter :: first_row_ratio = 7.0_wp
   !> Points between two rows at which a line is compared with the law when the table is done
   integer, parameter :: many = 64
   !> Rows closer than this, over the largest overclosure of the law's rows, would be changed by the
   !> twelve figures that a deck has
   real(wp), parameter :: closest_rows = 1.0e-6_wp
   !> Part of the tolerance that is kept for what lies between those points
   real(wp), parameter :: margin = 1.0e-3_wp

   !> The law in rows, and how good they are.
   type :: law_table
      !> Overclosure of the mesh faces, mm, ascending; separation is d0 less this
      real(wp), allocatable :: overclosure(:)
      !> Pressure, MPa, ascending from zero
      real(wp), allocatable :: pressure(:)
      !> The relative error holds where the law is between these pressures, MPa
      real(wp) :: smallest_pressure = 0.0_wp, largest_pressure = 0.0_wp
      !> Largest relative error of linear interpolation there, measured against the direct law
      real(wp) :: error = 0.0_wp
      !> Largest absolute error below the smallest pressure, MPa, measured
      real(wp) :: low_error = 0.0_wp
      !> Flags of the law at the largest pressure (see `asperity_law_validity`)
      integer :: validity = 0
   end type law_table

contains

   !> Shear stress over slip while the faces stick at a pressure: mu p/gcrit, MPa/mm. For hosts
   !> whose friction has a constant slope, as the law's follows the pressure.
   pure elemental function stick_slope(properties, pressure) result(slope)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      real(wp) :: slope

      slope = properties%friction_coefficient*pressure/properties%critical_slip
   end function stick_slope

   !> Tabulate the law. `error` is set when an argument is refused or more rows were needed than
   !> allowed.
   pure subroutine new_law_table(table, properties, largest_pressure, error, tolerance, most_rows, &
         smallest_pressure)
      !> Result
      type(law_table), intent(out) :: table
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Up to this pressure the relative error holds, MPa; not above the hardness
      real(wp), intent(in) :: largest_pressure
      !> Set when an argument is refused or more rows were needed than allowed
      type(error_type), allocatable, intent(out) :: error
      !> Relative error allowed, 1e-6 to 0.2; 0.01 when absent
      real(wp), intent(in), optional :: tolerance
      !> Most rows allowed; 200 when absent
      integer, intent(in), optional :: most_rows
      !> From this pressure on, MPa; the opening pressure when absent, below which a point of the
      !> contact-point update is open
      real(wp), intent(in), optional :: smallest_pressure
      type(compiled_law) :: law
      type(law_table) :: balanced
      real(wp) :: wanted, smallest, first, far, near
      integer :: most

      wanted = default_tolerance
      if (present(tolerance)) wanted = tolerance
      most = default_most_rows
      if (present(most_rows)) most = most_rows
      smallest = properties%p_open
      if (present(smallest_pressure)) smallest = smallest_pressure
      call check_arguments(properties%normal, smallest, largest_pressure, wanted, most, error)
      if (allocated(error)) return
      call separation_for_pressure(properties%normal, smallest/first_row_ratio, first, error)
      if (.not. allocated(error)) &
         call separation_for_pressure(properties%normal, smallest, far, error)
      if (.not. allocated(error)) &
         call separation_for_pressure(properties%normal, largest_pressure, near, error)
      if (.not. allocated(error)) call new_compiled_law(law, properties%normal, error)
      if (allocated(error)) return

      ! lines of twice the error, lowered by half of it; rows on the law where it is not convex, so
      ! that this would exceed the tolerance
      table%smallest_pressure = smallest
      table%largest_pressure = largest_pressure
      balanced = table
      call fill_rows(balanced, law, properties, [first, far, near], &
         2.0_wp*(1.0_wp - margin)*wanted/(1.0_wp - wanted), .true.)
      if (balanced%error > wanted) then
         call fill_rows(table, law, properties, [first, far, near], (1.0_wp - margin)*wanted, &
            .false.)
      else
         table = balanced
      end if
      if (size(table%pressure) > most) then
         call refuse_rows(table, wanted, most, error)
      else if (table%error > wanted) then
         call fatal_error(error, 'no table within tolerance = '//to_text(wanted)// &
            ' of the law was found', computation_error)
      else
         call check_spacing(table, properties, error)
      end if
   end subroutine new_law_table

   pure subroutine check_arguments(normal, smallest, largest, tolerance, most_rows, error)
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: smallest, largest, tolerance
      integer, intent(in) :: most_rows
      type(error_type), allocatable, intent(out) :: error

      call check_positive(error, 'largest_pressure', largest, 'MPa')
      if (.not. allocated(error)) &
         call check_positive(error, 'smallest_pressure', smallest, 'MPa')
      if (.not. allocated(error)) call check_range(error, 'tolerance', tolerance, &
         smallest_tolerance, largest_tolerance, '')
      if (allocated(error)) return
      if (most_rows < fewest_rows) then
         call fatal_error(error, 'rows = '//to_text(most_rows)//' is not allowed: a table has '// &
            to_text(fewest_rows)//' at least', subject='rows')
      else if (largest > normal%hardness) then
         call fatal_error(error, 'largest_pressure = '//to_text(largest)// &
            ' MPa is above the hardness, '//to_text(normal%hardness)// &
            ' MPa: the law reaches no such pressure', subject='largest_pressure hardness')
      else if (.not. largest > smallest) then
         call fatal_error(error, 'largest_pressure = '//to_text(largest)// &
            ' MPa is not allowed: it must be above smallest_pressure, '//to_text(smallest, 4)// &
            ' MPa', subject='largest_pressure smallest_pressure')
      else if (normal%unloading == unloading_elastic) then
         call fatal_error(error, 'unloading = elastic is not allowed with the law as a table: '// &
            'its rows are one curve, which loading and unloading share; it must be reversible, '// &
            'or take UINTER for the law with memory', subject='unloading')
      end if
   end subroutine check_arguments

   !> Say how many rows were needed and what helps.
   pure subroutine refuse_rows(table, tolerance, most_rows, error)
      type(law_table), intent(in) :: table
      real(wp), intent(in) :: tolerance
      integer, intent(in) :: most_rows
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: enough

      ! the number of rows goes with the root of the tolerance
      enough = tolerance*(real(size(table%pressure), wp)/real(most_rows, wp))**2
      call fatal_error(error, 'rows = '//to_text(most_rows)//' is too few: tolerance = '// &
         to_text(tolerance)//' from '//to_text(table%smallest_pressure, 3)//' to '// &
         to_text(table%largest_pressure, 3)//' MPa needs '//to_text(size(table%pressure))// &
         '; allow so many, a tolerance of about '//to_text(1.05_wp*enough, 2)// &
         ', or raise smallest_pressure', subject='rows tolerance')
   end subroutine refuse_rows

   !> `error` is set when rows are too close to each other, for where they are.
   pure subroutine check_spacing(table, properties, error)
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      type(error_type), allocatable, intent(out) :: error

      associate (x => table%overclosure(:size(table%overclosure) - 1))
         if (minval(x(2:) - x(:size(x) - 1)) < closest_rows*maxval(abs(x))) &
            call fatal_error(error, 'initial_separation = '// &
            to_text(properties%initial_separation)//' mm is not allowed: so far from the rows '// &
            'their overclosures would differ too little', subject='initial_separation')
      end associate
   end subroutine check_spacing

   !> Place the rows and measure them.
   pure subroutine fill_rows(table, law, properties, ends, allowed, lowered)
      !> Its rows and errors are set
      type(law_table), intent(inout) :: table
      type(compiled_law), intent(in) :: law
      type(contact_properties), intent(in) :: properties
      !> Separations of the first row, of the smallest and of the largest pressure, mm
      real(wp), intent(in) :: ends(3)
      !> Relative error of a line between two rows on the law
      real(wp), intent(in) :: allowed
      !> Lower the rows so that the errors to either side are equal
      logical, intent(in) :: lowered
      real(wp), allocatable :: separation(:)
      type(normal_response) :: last
      real(wp) :: errors(2), extremes(2), factor
      integer :: i, n

      call place_rows(law, ends(2), ends(3), allowed, separation)
      n = size(separation) + 2
      last = evaluate_normal_law(properties%normal, ends(3))
      separation = [ends(1), separation, ends(3) - reach*properties%normal%sigma]
      allocate (table%pressure(n))
      table%overclosure = properties%initial_separation - separation
      table%pressure(1) = 0.0_wp
      table%pressure(2:n - 1) = pressures(properties%normal, separation(2:n - 1))
      table%pressure(n) = last%pressure + last%stiffness*(separation(n - 1) - separation(n))
      table%validity = last%validity

      extremes = 0.0_wp
      do i = 2, n - 2
         errors = line_errors(table%pressure(i:i + 1), pressures(properties%normal, &
            points_between(separation(i), separation(i + 1), many)))
         extremes = [min(extremes(1), errors(1)), max(extremes(2), errors(2))]
      end do
      factor = 1.0_wp
      if (lowered) factor = 2.0_wp/(2.0_wp + sum(extremes))
      table%pressure = factor*table%pressure
      table%error = maxval(abs(factor*(1.0_wp + extremes) - 1.0_wp))

      ! before the first row the law falls towards zero, so its own pressure there is the error
      associate (p => pressures(properties%normal, &
            points_between(separation(1), separation(2), many)))
         table%low_error = maxval(abs([(table%pressure(2)*i/many, i=0, many)] - p))
      end associate
   end subroutine fill_rows

   !> The law's pressures, directly.
   pure function pressures(normal, separation) result(p)
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: separation(:)
      real(wp) :: p(size(separation))
      type(normal_response) :: response
      integer :: i

      do i = 1, size(separation)
         response = evaluate_normal_law(normal, separation(i))
         p(i) = response%pressure
      end do
   end function pressures

end module asperity_deck_law_rows
