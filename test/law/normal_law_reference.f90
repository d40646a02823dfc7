!> The normal law against numbers that are not its own: 30-digit values, GSL's quadrature of the
!> plain integrals, and closed forms of the all-elastic and the all-plastic limit.
module test_law_normal_law_reference
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_loc, c_ptr
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use extremes, only: worsen
   use funit, only: assertEqual, assertLessThan, assertLessThanOrEqual, assertRelativelyEqual, &
      TestMethod, TestSuite
   use gsl_quadrature, only: gaussian_moment, integrate
   use measurements, only: record
   use random_inputs, only: properties_with, random_properties, random_stream
   use reference_table, only: columns, n_columns, read_reference, reference_row
   implicit none
   private
   public :: suite_normal_law_reference

   !> What GSL's integrand is given: properties, separation, and the number of the column wanted.
   type, bind(C) :: integrand_parameters
      real(c_double) :: eta, modulus, radius, hardness, sigma, w1, w2, b2, b3, separation
      integer(c_int) :: column
   end type integrand_parameters

contains

   function suite_normal_law_reference() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('normal law reference')
      call suite%addTest(TestMethod('30-digit values', test_table))
      call suite%addTest(TestMethod('GSL quadrature', test_gsl))
      call suite%addTest(TestMethod('all-elastic limit', test_elastic_limit))
      call suite%addTest(TestMethod('all-plastic limit', test_plastic_limit))
   end function suite_normal_law_reference

   pure function as_array(r) result(values)
      type(normal_response), intent(in) :: r
      real(wp) :: values(n_columns)

      values = [r%pressure, r%stiffness, r%area_fraction, r%contact_density, r%energy, &
         r%elastic_share, r%elastoplastic_share, r%plastic_share]
   end function as_array

   !> Every row of test/data/normal_law_reference.csv, wherever the value is a normal number; below
   !> that the result may not be larger than the smallest normal number.
   subroutine test_table()
      type(reference_row), allocatable :: rows(:)
      character(len=:), allocatable :: message
      character(len=12) :: label
      real(wp) :: found(n_columns), worst(n_columns), worst_w, relative
      integer :: i, j

      call read_reference(rows, message)
      call assertEqual('', message)
      call assertEqual(420, size(rows), 'rows')
      worst = 0.0_wp
      worst_w = 0.0_wp
      do i = 1, size(rows)
         write (label, '(a, i0)') 'row ', i
         found = as_array(evaluate_normal_law(rows(i)%properties, rows(i)%separation))
         call worsen(worst_w, [abs(rows(i)%properties%w1/rows(i)%w1 - 1.0_wp), &
            abs(rows(i)%properties%w2/rows(i)%w2 - 1.0_wp)])
         do j = 1, n_columns
            if (rows(i)%values(j) >= tiny(1.0_wp)) then
               relative = abs(found(j)/rows(i)%values(j) - 1.0_wp)
               call worsen(worst(j), relative)
               call assertLessThan(relative, 1.0e-12_wp, trim(label)//' '//columns(j))
            else
               call assertLessThanOrEqual(found(j), tiny(1.0_wp), trim(label)//' '//columns(j))
            end if
         end do
      end do
      call assertLessThan(worst_w, 1.0e-16_wp, 'w1 and w2 rounded to nearest')
      call record('normal_law.w1_w2.relative_error', worst_w)
      do j = 1, n_columns
         call record('normal_law.'//trim(columns(j))//'.relative_error', worst(j))
      end do
   end subroutine test_table

   !> Eqs 24-26 as they stand, over summit heights z, by GSL. Separation and w1 are such that GSL
   !> can promise 1e-10; the test checks that it does. Heights are in sigma, since GSL's infinite
   !> range is scaled by one.
   subroutine test_gsl()
      integer, parameter :: seed = 2021, n_cases = 200
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(integrand_parameters), target :: given
      real(wp) :: d, found(n_columns), worst(5), value, total, error, promised, edges(3)
      integer :: i, column, range

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      do i = 1, n_cases
         call random_properties(stream, p, 1.0e-4_wp, 10.0_wp, 0.05_wp)
         d = p%sigma*stream%uniform(-6.0_wp, 8.0_wp)
         found = as_array(evaluate_normal_law(p, d))
         edges = [d, d + p%w1, d + p%w2]/p%sigma
         do column = 1, 5
            given = integrand_parameters(p%eta, p%modulus, p%radius, p%hardness, p%sigma, p%w1, &
               p%w2, p%b2, p%b3, d, int(column, c_int))
            call integrate(summit_integrand, c_loc(given), edges(3), total, promised)
            do range = 1, 2
               call integrate(summit_integrand, c_loc(given), edges(range), value, error, &
                  edges(range + 1))
               total = total + value
               promised = promised + error
            end do
            call assertLessThan(promised, 1.0e-10_wp*total, 'error that GSL promises')
            call worsen(worst(column), abs(found(column)/total - 1.0_wp))
         end do
      end do
      do column = 1, 5
         call record('normal_law.'//trim(columns(column))//'.gsl_difference', worst(column))
         call assertLessThan(worst(column), 1.0e-10_wp, columns(column))
      end do
   end subroutine test_gsl

   !> eta times one summit's response times the density of heights, from the paper's formulas.
   function summit_integrand(height, parameters) bind(C) result(y)
      real(c_double), intent(in), value :: height
      type(c_ptr), intent(in), value :: parameters
      real(c_double) :: y
      type(integrand_parameters), pointer :: p
      real(wp) :: w, force_1, x
      integer :: stage

      call c_f_pointer(parameters, p)
      w = height*p%sigma - p%separation
      x = w/p%w1
      force_1 = 4.0_wp/3.0_wp*p%modulus*sqrt(p%radius)*p%w1*sqrt(p%w1)
      stage = 1 + count(w >= [p%w1, p%w2])
      select case (10*p%column + stage)
      case (11)
         y = force_1*x*sqrt(x)
      case (12)
         y = force_1*x**p%b3
      case (13)
         y = 2.0_wp*pi*p%radius*p%hardness*w
      case (21)
         y = 1.5_wp*force_1*sqrt(x)/p%w1
      case (22)
         y = p%b3*force_1*x**(p%b3 - 1.0_wp)/p%w1
      case (23)
         y = 2.0_wp*pi*p%radius*p%hardness
      case (31)
         y = pi*p%radius*w
      case (32)
         y = pi*p%radius*p%w1*x**p%b2
      case (33)
         y = 2.0_wp*pi*p%radius*w
      case (51:53)
         y = 0.4_wp*force_1*min(w, p%w1)*min(x, 1.0_wp)*sqrt(min(x, 1.0_wp))
         if (stage > 1) y = y + force_1*p%w1 &
            *((min(w, p%w2)/p%w1)**(p%b3 + 1.0_wp) - 1.0_wp)/(p%b3 + 1.0_wp)
         if (stage > 2) y = y + pi*p%radius*p%hardness*(w*w - p%w2*p%w2)
      case default
         y = 1.0_wp
      end select
      y = y*p%eta*exp(-0.5_wp*height**2)/sqrt(2.0_wp*pi)
   end function summit_integrand

   !> w1 = 1000 sigma: all summits are elastic, and each quantity is a moment F_p(h). The series,
   !> of positive terms, is good to 1e-14, GSL's U to 3e-13.
   subroutine test_elastic_limit()
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: h, hertz, relative, worst
      integer :: i

      p = properties_with(1.0e3_wp, 0.4_wp)
      hertz = 4.0_wp/3.0_wp*p%eta*p%modulus*sqrt(p%radius*p%sigma)
      worst = 0.0_wp
      do i = 0, 44
         h = 0.25_wp*real(i - 24, wp)
         r = evaluate_normal_law(p, h*p%sigma)
         relative = max(abs(r%pressure/(hertz*p%sigma*gaussian_moment(1.5_wp, h)) - 1.0_wp), &
            abs(r%stiffness/(1.5_wp*hertz*gaussian_moment(0.5_wp, h)) - 1.0_wp), &
            abs(r%area_fraction/(p%eta*pi*p%radius*p%sigma*gaussian_moment(1.0_wp, h)) - 1.0_wp), &
            abs(r%energy/(0.4_wp*hertz*p%sigma**2*gaussian_moment(2.5_wp, h)) - 1.0_wp))
         call assertLessThan(relative, merge(1.0e-12_wp, 5.0e-14_wp, h > 0.0_wp), 'moments')
         call worsen(worst, relative)
      end do
      call record('normal_law.all_elastic.relative_error', worst)
      ! F_3/2 as known to eight and seven figures
      call assertEqual(0.43001999_wp, gaussian_moment(1.5_wp, 0.0_wp), 0.5e-8_wp)
      call assertEqual(0.0066481776_wp, gaussian_moment(1.5_wp, 2.0_wp), 0.5e-10_wp)
      call assertEqual(4.439156e-6_wp, gaussian_moment(1.5_wp, 4.0_wp), 0.5e-12_wp)
      call assertRelativelyEqual(2.0_wp**0.25_wp*gamma(1.25_wp)/sqrt(2.0_wp*pi), &
         gaussian_moment(1.5_wp, 0.0_wp), 1.0e-15_wp, 'F_3/2(0) = 2^(1/4) Gamma(5/4)/sqrt(2 pi)')
   end subroutine test_elastic_limit

   !> w1 = 1e-8 sigma: all summits are plastic but those with w < w2 = b sigma. These carry less
   !> than 2 pi R H w, so F_1 errs by less than phi(max(h, 0)) b^2/2; the area likewise.
   subroutine test_plastic_limit()
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: h, b, worst, allowed
      integer :: i

      p = properties_with(1.0e-8_wp, 0.4_wp)
      b = p%w2/p%sigma
      worst = 0.0_wp
      do i = 0, 44
         h = 0.25_wp*real(i - 24, wp)
         r = evaluate_normal_law(p, h*p%sigma)
         allowed = 2.0e-13_wp &
            + 0.5_wp*b**2*exp(-0.5_wp*max(h, 0.0_wp)**2)/sqrt(2.0_wp*pi)/gaussian_moment(1.0_wp, h)
         call worsen(worst, abs(r%pressure/(2.0_wp*pi*p%eta*p%radius*p%hardness*p%sigma &
            *gaussian_moment(1.0_wp, h)) - 1.0_wp)/allowed)
         call worsen(worst, abs(r%area_fraction*p%hardness/r%pressure - 1.0_wp)/allowed)
      end do
      call record('normal_law.all_plastic.error_over_bound', worst)
      call assertLessThan(worst, 1.0_wp, 'error over its bound')
   end subroutine test_plastic_limit

end module test_law_normal_law_reference
