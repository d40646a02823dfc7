!> The law as a table: errors are measured here by interpolation of our own at random overclosures,
!> against the direct law.
module test_deck_law_rows
   use asperity, only: contact_properties, error_type, evaluate_normal_law, normal_response, &
      pressure_above_hardness, area_above_nominal, rule_abaqus, slip_exact, wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_law_rows, only: law_table, new_law_table, reach, stick_slope
   use contact_cases, only: pair_properties, random_contact
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, &
      assertGreaterThanOrEqual, assertLessThan, assertLessThanOrEqual, assertTrue, TestMethod, &
      TestSuite
   use random_inputs, only: random_stream
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_law_table

   integer, parameter :: seed = 20260705

contains

   function suite_law_table() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('law_table')
      call suite%addTest(TestMethod('error of random laws and tolerances', test_error))
      call suite%addTest(TestMethod('rows of the pairs', test_rows))
      call suite%addTest(TestMethod('no table of fewer rows', test_fewest))
      call suite%addTest(TestMethod('a law that is not convex', test_not_convex))
      call suite%addTest(TestMethod('both ends', test_ends))
      call suite%addTest(TestMethod('too many rows', test_too_many))
      call suite%addTest(TestMethod('arguments that are refused', test_refused))
      call suite%addTest(TestMethod('stick slope', test_stick_slope))
   end function suite_law_table

   !> Pressure of the table at an overclosure, as CalculiX interpolates.
   pure real(wp) function interpolated(table, overclosure)
      type(law_table), intent(in) :: table
      real(wp), intent(in) :: overclosure
      integer :: i

      associate (x => table%overclosure, p => table%pressure)
         i = count(x <= overclosure)
         if (i == 0) then
            interpolated = p(1)
         else if (i == size(x)) then
            interpolated = p(i)
         else
            interpolated = p(i) + (p(i + 1) - p(i))*(overclosure - x(i))/(x(i + 1) - x(i))
         end if
      end associate
   end function interpolated

   !> Random properties and pressures, tolerances 0.1 to 1e-4: the table is within what it says it
   !> is, and that within what was asked for; what it says is no more than a little too careful.
   subroutine test_error()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(law_table) :: table
      type(error_type), allocatable :: error
      type(normal_response) :: law
      real(wp) :: tolerance, largest, smallest, worst, worst_low, overclosure, difference
      character(len=:), allocatable :: place
      integer :: i, j, n

      stream%state = seed
      do i = 1, 150
         call random_contact(stream, p, rule_abaqus, slip_exact)
         tolerance = stream%log_uniform(1.0e-4_wp, 0.1_wp)
         largest = p%normal%hardness*stream%log_uniform(1.0e-5_wp, 1.0_wp)
         smallest = p%p_open
         if (mod(i, 2) == 0) smallest = largest*stream%log_uniform(1.0e-6_wp, 0.5_wp)
         if (smallest >= largest) cycle
         call new_law_table(table, p, largest, error, tolerance, 5000, smallest)
         place = 'seed '//to_text(seed)//', case '//to_text(i)
         if (allocated(error)) place = place//': '//error%message
         call assertFalse(allocated(error), place)
         if (anyExceptions()) return
         n = size(table%pressure)
         call assertEqual(n, size(table%overclosure), place//', sizes')
         call assertTrue(all(table%overclosure(2:) > table%overclosure(:n - 1)), place//', x')
         call assertTrue(all(table%pressure(2:) > table%pressure(:n - 1)), place//', p')
         worst = 0.0_wp
         worst_low = 0.0_wp
         do j = 1, 4000
            overclosure = stream%uniform(table%overclosure(1) &
               - merge(p%normal%sigma, 0.0_wp, mod(j, 8) == 0), table%overclosure(n - 1))
            law = evaluate_normal_law(p%normal, p%initial_separation - overclosure)
            difference = abs(interpolated(table, overclosure) - law%pressure)
            if (law%pressure > largest) cycle
            if (law%pressure >= smallest) then
               call worsen(worst, difference/law%pressure)
            else
               call worsen(worst_low, difference)
            end if
         end do
         ! the table's own error is from 64 points a row and a parabola: good to 1e-4 of itself, and
         ! to the round-off of overclosures, some sigma in size, on a slope of about h/sigma
         call assertLessThanOrEqual(worst, table%error*(1.0_wp + 1.0e-4_wp) + 1.0e-13_wp, &
            place//', error')
         call assertLessThanOrEqual(table%error, tolerance, place//', tolerance')
         call assertGreaterThan(worst, 0.9_wp*table%error, place//', honest')
         call assertLessThanOrEqual(worst_low, table%low_error*(1.0_wp + 1.0e-4_wp), &
            place//', low')
         call assertLessThan(table%low_error, 0.16_wp*smallest + tolerance*smallest, &
            place//', low, share')
         if (anyExceptions()) return
      end do
   end subroutine test_error

   !> How many rows it takes from the opening pressure to the 4.7 MPa of the paper's Fig. 17.
   subroutine test_rows()
      call check('transverse-tangential', 0.1_wp, 16)
      call check('transverse-tangential', 0.01_wp, 46)
      call check('transverse-tangential', 1.0e-3_wp, 140)
      call check('transverse-tangential', 1.0e-4_wp, 440)
      call check('tangential-tangential', 0.01_wp, 48)

   contains

      subroutine check(pair, tolerance, most)
         character(len=*), intent(in) :: pair
         real(wp), intent(in) :: tolerance
         integer, intent(in) :: most
         type(law_table) :: table
         type(error_type), allocatable :: error

         call new_law_table(table, pair_properties(pair=pair), 4.7_wp, error, tolerance, most)
         if (allocated(error)) then
            call assertTrue(.false., pair//' '//error%message)
            return
         end if
         call assertGreaterThan(size(table%pressure), 3*most/4, &
            message=pair//to_text(tolerance))
         call assertGreaterThan(table%error, 0.99_wp*tolerance, pair//', not better than asked for')
         call assertEqual(0, table%validity, pair)
      end subroutine check

   end subroutine test_rows

   !> A lower bound that any table on any rows obeys: in a closure in which the law's curvature is
   !> p'' at least and the law p at most, a line within t of the law is no longer than
   !> 4 sqrt(t p/p''), so that rows are no fewer than the integral of sqrt(p''/p)/(4 sqrt(t)).
   subroutine test_fewest()
      type(contact_properties) :: p
      type(law_table) :: table
      type(error_type), allocatable :: error
      type(normal_response) :: left, middle, right
      real(wp), parameter :: tolerance = 1.0e-3_wp
      real(wp) :: d, step, rows
      integer, parameter :: steps = 2000
      integer :: i, n

      p = pair_properties()
      call new_law_table(table, p, 4.7_wp, error, tolerance)
      call assertFalse(allocated(error), 'table')
      if (anyExceptions()) return
      n = size(table%pressure)
      step = (table%overclosure(n - 1) - table%overclosure(2))/steps
      rows = 0.0_wp
      do i = 1, steps
         d = p%initial_separation - table%overclosure(2) - (i - 0.5_wp)*step
         left = evaluate_normal_law(p%normal, d - 0.5_wp*step)
         middle = evaluate_normal_law(p%normal, d)
         right = evaluate_normal_law(p%normal, d + 0.5_wp*step)
         rows = rows + sqrt((left%stiffness - right%stiffness)/(step*middle%pressure))*step
      end do
      rows = rows/(4.0_wp*sqrt(tolerance)) + 3.0_wp
      call assertGreaterThanOrEqual(real(n, wp), rows - 1.0_wp, 'bound')
      call assertLessThan(real(n, wp), 1.01_wp*rows + 1.0_wp, 'as few as there can be')
   end subroutine test_fewest

   !> Pressed past their full plasticity, summits soften all at once where w2 is several sigma: the
   !> law bends the other way, and lowering rows would double the error.
   subroutine test_not_convex()
      type(contact_properties) :: p
      type(law_table) :: table
      type(error_type), allocatable :: error
      type(normal_response) :: near, middle, far
      real(wp) :: d, worst, overclosure
      integer :: j

      p = soft_contact()
      d = -p%normal%w2
      near = evaluate_normal_law(p%normal, d - 0.5_wp*p%normal%sigma)
      middle = evaluate_normal_law(p%normal, d)
      far = evaluate_normal_law(p%normal, d + 0.5_wp*p%normal%sigma)
      call assertLessThan(near%stiffness, far%stiffness, 'softens')
      call assertLessThan(near%area_fraction, 1.0_wp, 'below nominal area')
      call new_law_table(table, p, near%pressure, error, 1.0e-3_wp, 1000)
      call assertFalse(allocated(error), 'table')
      if (anyExceptions()) return
      call assertLessThanOrEqual(table%error, 1.0e-3_wp, 'tolerance')
      call assertEqual(near%pressure, table%pressure(size(table%pressure) - 1), &
         1.0e-11_wp*near%pressure, 'rows on the law')
      worst = 0.0_wp
      do j = 0, 40000
         overclosure = table%overclosure(2) &
            + (table%overclosure(size(table%pressure) - 1) - table%overclosure(2))*j/40000.0_wp
         middle = evaluate_normal_law(p%normal, p%initial_separation - overclosure)
         call worsen(worst, abs(interpolated(table, overclosure)/middle%pressure - 1.0_wp))
      end do
      call assertLessThanOrEqual(worst, table%error*(1.0_wp + 1.0e-4_wp), 'error')
   end subroutine test_not_convex

   !> Few, blunt, hard summits: w2 is 4 sigma, and the real area still below the nominal there.
   function soft_contact() result(p)
      use asperity, only: new_contact_properties, new_normal_properties, normal_properties
      type(contact_properties) :: p
      type(normal_properties) :: normal
      type(error_type), allocatable :: error

      call new_normal_properties(normal, 0.6_wp, 1105.0_wp, 1.0_wp, 50.0_wp, 0.4_wp, 0.05_wp, error)
      if (.not. allocated(error)) call new_contact_properties(p, normal, 0.5_wp, 0.3_wp, error)
      if (allocated(error)) error stop 'soft_contact is refused'
   end function soft_contact

   !> First and last row, and the law's own slope from the largest pressure on.
   subroutine test_ends()
      type(contact_properties) :: p
      type(law_table) :: table
      type(error_type), allocatable :: error
      type(normal_response) :: law
      real(wp) :: slope
      integer :: n

      p = pair_properties()
      call new_law_table(table, p, 4.7_wp, error)
      call assertFalse(allocated(error), 'table')
      if (anyExceptions()) return
      n = size(table%pressure)
      call assertEqual(0.0_wp, table%pressure(1), 0.0_wp, 'zero')
      call assertEqual(p%p_open, table%smallest_pressure, 0.0_wp, 'from the opening pressure on')
      law = evaluate_normal_law(p%normal, p%initial_separation - table%overclosure(1))
      call assertEqual(p%p_open/7.0_wp, law%pressure, 1.0e-9_wp*p%p_open, 'first row')
      law = evaluate_normal_law(p%normal, p%initial_separation - table%overclosure(2))
      call assertEqual(p%p_open, law%pressure, 1.0e-9_wp*p%p_open, 'second row')
      law = evaluate_normal_law(p%normal, p%initial_separation - table%overclosure(n - 1))
      call assertEqual(4.7_wp, law%pressure, 1.0e-11_wp, 'last row but one')
      call assertEqual(table%overclosure(n - 1) + reach*p%normal%sigma, table%overclosure(n), &
         1.0e-12_wp, 'last row')
      slope = (table%pressure(n) - table%pressure(n - 1))/(reach*p%normal%sigma)
      call assertEqual(1.0_wp, slope/law%stiffness, 0.011_wp, 'slope goes on')
      call assertGreaterThan(table%pressure(n), 100*4.7_wp, 'well beyond')

      call new_law_table(table, p, 22.0_wp, error)
      call assertFalse(allocated(error), 'table past the nominal area')
      call assertEqual(area_above_nominal, iand(table%validity, area_above_nominal), 'flagged')
      call assertEqual(0, iand(table%validity, pressure_above_hardness), 'not this flag')
   end subroutine test_ends

   !> What the message of a table that is refused advises is enough.
   subroutine test_too_many()
      type(law_table) :: table
      type(error_type), allocatable :: error
      type(contact_properties) :: p

      p = pair_properties()
      call new_law_table(table, p, 4.7_wp, error, 1.0e-4_wp)
      call assertTrue(allocated(error), 'refused')
      if (anyExceptions()) return
      call assertGreaterThan(index(error%message, 'rows = 200 is too few: tolerance = 0.0001 '// &
         'from 2.78E-7 to 4.7 MPa needs 4'), 0, message=error%message)
      call assertGreaterThan(index(error%message, 'a tolerance of about 0.00044,'), 0, &
         message=error%message)
      call assertEqual('rows tolerance', error%subject)
      call new_law_table(table, p, 4.7_wp, error, 4.4e-4_wp)
      call assertFalse(allocated(error), 'this tolerance is enough')
      if (anyExceptions()) return
      call assertGreaterThan(size(table%pressure), 180, message='rows')
      call new_law_table(table, p, 4.7_wp, error, 4.4e-4_wp, size(table%pressure))
      call assertFalse(allocated(error), 'exactly as many')
      call new_law_table(table, p, 4.7_wp, error, 4.4e-4_wp, 180)
      call assertTrue(allocated(error), 'too few')
      call new_law_table(table, p, 4.7_wp, error, 1.0e-4_wp, smallest_pressure=0.01_wp)
      call assertFalse(allocated(error), 'a higher smallest pressure')
   end subroutine test_too_many

   subroutine test_refused()
      call check('largest_pressure = 0.0 ', 0.0_wp)
      call check('largest_pressure = -1.0 ', -1.0_wp)
      call check('largest_pressure = 24.6 MPa is above the hardness, 24.53 MPa', 24.6_wp)
      call check('largest_pressure = 1.0E-8 MPa is not allowed: it must be above smallest', &
         1.0e-8_wp)
      call check('tolerance = 0.3 ', 4.7_wp, 0.3_wp)
      call check('tolerance = '//to_text(nearest(0.2_wp, 1.0_wp)), 4.7_wp, nearest(0.2_wp, 1.0_wp))
      call check('tolerance = '//to_text(nearest(1.0e-6_wp, -1.0_wp)), 4.7_wp, &
         nearest(1.0e-6_wp, -1.0_wp))
      call check('tolerance = 0.0 ', 4.7_wp, 0.0_wp)
      call check('rows = 3 is not allowed', 4.7_wp, 0.01_wp, 3)
      call check('smallest_pressure = -1.0 ', 4.7_wp, 0.01_wp, 200, -1.0_wp)
      call check('largest_pressure = 4.7 MPa is not allowed: it must be above', 4.7_wp, 0.01_wp, &
         200, 4.7_wp)

   contains

      subroutine check(message, largest, tolerance, most_rows, smallest)
         character(len=*), intent(in) :: message
         real(wp), intent(in) :: largest
         real(wp), intent(in), optional :: tolerance, smallest
         integer, intent(in), optional :: most_rows
         type(law_table) :: table
         type(error_type), allocatable :: error

         call new_law_table(table, pair_properties(), largest, error, tolerance, most_rows, &
            smallest)
         call assertTrue(allocated(error), message)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, message), error%message)
         call assertTrue(fits_subject(error), error%message)
      end subroutine check

   end subroutine test_refused

   !> mu p/gcrit, as the contact-point update has it in stick.
   subroutine test_stick_slope()
      type(contact_properties) :: p

      p = pair_properties()
      call assertEqual(0.5_wp*0.2_wp/0.31_wp, stick_slope(p, 0.2_wp), 1.0e-15_wp, 'slope')
   end subroutine test_stick_slope

end module test_deck_law_rows
