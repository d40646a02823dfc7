!> The normal law compiled to polynomials of degree seven on fixed intervals of h = d/sigma, for
!> very many evaluations: within 1e-10 of the direct evaluation. Built once from the properties by
!> `asperity_law_compile_law`, then read only, so that threads share it.
!>
!> Up to h = 8 the polynomials are of pressure, area and energy themselves; beyond, of the same over
!> exp(-h^2/2). Values and slopes are exact at four points of an interval, its ends among them. The
!> stiffness is the derivative of the polynomial of the pressure. Outside -8 <= h < 38, or of the
!> range that it was compiled for, the law is evaluated directly, and beyond 39 it is zero. Of
!> heights that are not Gaussian h is the Gaussian number that belongs to d, as a function of which
!> the law is smooth, and the polynomials reach from -3.5 to 8.
module asperity_law_compiled_law
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_intervals, only: intervals_below, n_all
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_hermite_polynomial, only: degree
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_johnson_heights, only: height_slope_at
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_pieces_by_johnson, only: decay_score
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      pressure_above_hardness
   implicit none
   private
   public :: compiled_law, evaluate_compiled_law

   !> Points of a batch that are worked on at a time
   integer, parameter :: chunk = 64
   !> Stand for the column of an h without a polynomial: evaluated directly, or zero
   integer, parameter :: outside = 0, beyond = -1

   !> The law of one pair of faces, compiled. Build it with `new_compiled_law`; read only after: all
   !> but the properties is for the evaluation.
   type :: compiled_law
      !> What it was compiled from
      type(normal_properties) :: properties
      !> 1/sigma
      real(wp) :: inverse_sigma
      !> Separations over sigma below which a limit of the law is passed: nominal area, hardness,
      !> half the radius
      real(wp) :: limits(3)
      !> First and last column that holds a polynomial, and last one that is not over exp(-h^2/2)
      integer :: columns(2), last_near
      !> Polynomials, one column an interval: powers 0 to 7, and the middle of the interval
      real(wp) :: pressure(0:degree + 1, n_all)
      real(wp) :: area_fraction(0:degree, n_all), energy(0:degree, n_all)
   end type compiled_law

   !> Pressure and stiffness at one separation, or at many in one call; at one also the rest.
   interface evaluate_compiled_law
      procedure evaluate_point
      procedure evaluate_batch
   end interface evaluate_compiled_law

contains

   !> At one separation. The error against the direct evaluation is below 1e-10 for |h| <= 8 and
   !> below 1e-9 beyond, relative, in every quantity.
   pure elemental subroutine evaluate_point(law, separation, pressure, stiffness, area_fraction, &
         contact_density, energy, validity)
      !> Compiled law
      type(compiled_law), intent(in) :: law
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      !> Pressure, MPa, and normal stiffness -dp/dd, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Real area over nominal area; summits in contact per nominal area, 1/mm^2; stored energy
      !> per nominal area, N/mm
      real(wp), intent(out), optional :: area_fraction, contact_density, energy
      !> `valid`, or flags (see `asperity_law_validity`)
      integer, intent(out), optional :: validity
      real(wp) :: found(2)
      integer :: column

      if (present(area_fraction) .or. present(contact_density) .or. present(energy) &
            .or. present(validity)) then
         column = column_at(law, separation)
         if (column == outside) then
            call fill(evaluate_normal_law(law%properties, separation), pressure, stiffness, &
               area_fraction, contact_density, energy, validity)
            return
         end if
         call evaluate_rest(law, score_at(law, separation), column, area_fraction, &
            contact_density, energy, validity)
      end if
      call evaluate_all(law, 1, [separation], found(1:1), found(2:2))
      pressure = found(1)
      stiffness = found(2)
   end subroutine evaluate_point

   !> At many separations: pressures and stiffnesses only.
   pure subroutine evaluate_batch(law, separation, pressure, stiffness)
      !> Compiled law
      type(compiled_law), intent(in) :: law
      !> Separations d, mm
      real(wp), intent(in), contiguous :: separation(:)
      !> Pressures, MPa, and stiffnesses -dp/dd, MPa/mm; as many as separations
      real(wp), intent(out), contiguous :: pressure(:), stiffness(:)

      call evaluate_all(law, size(separation), separation, pressure, stiffness)
   end subroutine evaluate_batch

   !> Pressure and stiffness, in chunks: first the interval of each point, then the polynomials,
   !> so that neither waits for the other.
   pure subroutine evaluate_all(law, n, separation, pressure, stiffness)
      type(compiled_law), intent(in) :: law
      integer, intent(in) :: n
      real(wp), intent(in) :: separation(n)
      real(wp), intent(out) :: pressure(n), stiffness(n)
      real(wp) :: h(chunk), intervals, lowest, highest, decay
      integer :: column(chunk), i, j, m
      logical :: inside(chunk), is_gaussian

      is_gaussian = law%properties%heights%is_gaussian
      lowest = law%columns(1) - 1
      highest = law%columns(2)
      do i = 0, n - 1, chunk
         m = min(chunk, n - i)
         do j = 1, m
            h(j) = score_at(law, separation(i + j))
            intervals = intervals_below(h(j), is_gaussian)
            inside(j) = intervals >= lowest .and. intervals < highest
            column(j) = 1 + int(merge(intervals, lowest, inside(j)))
         end do
         call evaluate_polynomials(law, m, column, h, pressure(i + 1), stiffness(i + 1))
         if (any(column(:m) > law%last_near)) then
            do j = 1, m
               if (column(j) <= law%last_near) cycle
               decay = exp(-0.5_wp*h(j)**2)
               stiffness(i + j) = (stiffness(i + j) + law%inverse_sigma*h(j)*pressure(i + j))*decay
               pressure(i + j) = pressure(i + j)*decay
            end do
         end if
         if (.not. is_gaussian) stiffness(i + 1:i + m) = &
            stiffness(i + 1:i + m)/height_slope_at(law%properties%heights, h(:m))
         if (all(inside(:m))) cycle
         do j = 1, m
            if (.not. inside(j)) call evaluate_outside(law, separation(i + j), &
               pressure(i + j), stiffness(i + j))
         end do
      end do
   end subroutine evaluate_all

   !> The polynomials of the pressure and their derivatives over closure, by Horner's rule for both,
   !> written out for speed.
   pure subroutine evaluate_polynomials(law, n, column, h, pressure, stiffness)
      type(compiled_law), intent(in) :: law
      !> Number of points, and the interval and d/sigma of each
      integer, intent(in) :: n, column(n)
      real(wp), intent(in) :: h(n)
      real(wp), intent(out) :: pressure(n), stiffness(n)
      real(wp) :: t, v6, v5, v4, v3, v2, v1, s5, s4, s3, s2, s1
      integer :: i

      do i = 1, n
         associate (c => law%pressure(:, column(i)))
            t = h(i) - c(9)
            v6 = c(8)*t + c(7)
            s5 = c(8)*t + v6
            v5 = v6*t + c(6)
            s4 = s5*t + v5
            v4 = v5*t + c(5)
            s3 = s4*t + v4
            v3 = v4*t + c(4)
            s2 = s3*t + v3
            v2 = v3*t + c(3)
            s1 = s2*t + v2
            v1 = v2*t + c(2)
            pressure(i) = v1*t + c(1)
            stiffness(i) = -(s1*t + v1)*law%inverse_sigma
         end associate
      end do
   end subroutine evaluate_polynomials

   !> Pressure and stiffness where there is no polynomial.
   pure subroutine evaluate_outside(law, separation, pressure, stiffness)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp), intent(out) :: pressure, stiffness

      pressure = 0.0_wp
      stiffness = 0.0_wp
      if (column_at(law, separation) == outside) &
         call fill(evaluate_normal_law(law%properties, separation), pressure, stiffness)
   end subroutine evaluate_outside

   !> What is wanted of the direct evaluation.
   pure subroutine fill(direct, pressure, stiffness, area_fraction, contact_density, energy, &
         validity)
      type(normal_response), intent(in) :: direct
      real(wp), intent(out) :: pressure, stiffness
      real(wp), intent(out), optional :: area_fraction, contact_density, energy
      integer, intent(out), optional :: validity

      pressure = direct%pressure
      stiffness = direct%stiffness
      if (present(area_fraction)) area_fraction = direct%area_fraction
      if (present(contact_density)) contact_density = direct%contact_density
      if (present(energy)) energy = direct%energy
      if (present(validity)) validity = direct%validity
   end subroutine fill

   !> What is not pressure or stiffness, at one d/sigma with a polynomial or beyond all.
   pure subroutine evaluate_rest(law, h, column, area_fraction, contact_density, energy, validity)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: h
      integer, intent(in) :: column
      real(wp), intent(out), optional :: area_fraction, contact_density, energy
      integer, intent(out), optional :: validity
      real(wp) :: t, decay, moments(0:2)

      if (present(area_fraction)) area_fraction = 0.0_wp
      if (present(contact_density)) contact_density = 0.0_wp
      if (present(energy)) energy = 0.0_wp
      if (present(validity)) validity = law%properties%validity
      if (column == beyond) return
      t = h - law%pressure(degree + 1, column)
      decay = 1.0_wp
      if (column > law%last_near) decay = exp(-0.5_wp*h*h)
      if (present(area_fraction)) &
         area_fraction = polynomial(law%area_fraction(:, column), t)*decay
      if (present(energy)) energy = polynomial(law%energy(:, column), t)*decay
      if (present(contact_density)) then
         call find_tail_moments(h, moments)
         contact_density = law%properties%eta*moments(0)*exp(-0.5_wp*max(h, 0.0_wp)**2)
      end if
      if (present(validity)) validity = flags_at(law, h)
   end subroutine evaluate_rest

   !> The variable of the polynomials at a separation.
   pure real(wp) function score_at(law, separation) result(h)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation

      h = separation*law%inverse_sigma
      if (.not. law%properties%heights%is_gaussian) h = decay_score(law%properties, separation)
   end function score_at

   !> Interval of a separation, or `outside` or `beyond`.
   pure integer function column_at(law, separation)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp) :: intervals

      intervals = intervals_below(score_at(law, separation), &
         law%properties%heights%is_gaussian)
      column_at = merge(beyond, outside, separation > law%properties%vanishing_separation)
      if (intervals >= law%columns(1) - 1 .and. intervals < law%columns(2)) &
         column_at = 1 + int(intervals)
   end function column_at

   !> A polynomial by Horner's rule.
   pure real(wp) function polynomial(c, t)
      real(wp), intent(in) :: c(0:degree), t
      integer :: i

      polynomial = c(degree)
      do i = degree - 1, 0, -1
         polynomial = polynomial*t + c(i)
      end do
   end function polynomial

   !> Flags at a separation over sigma.
   pure integer function flags_at(law, h)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: h
      integer, parameter :: flags(3) = &
         [area_above_nominal, pressure_above_hardness, closure_above_half_radius]
      integer :: i

      flags_at = law%properties%validity
      do i = 1, size(flags)
         if (h < law%limits(i)) flags_at = ior(flags_at, flags(i))
      end do
   end function flags_at

end module asperity_law_compiled_law
