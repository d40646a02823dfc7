!> Ranges outside which no solid and no face is: a property there is, as a rule, a slip of units,
!> and the message names the likeliest. Each range has its reason. N-mm-MPa; a usual face all in
!> N-m-Pa is known for what it is and passes as well.
module asperity_law_plausibility
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_validity, only: implausible_property, roughness_number_high, &
      roughness_number_low, valid
   implicit none
   private
   public :: check_plausible, check_plausible_length

   !> Smallest bandwidth parameter alpha = m0 m4/m2^2 of an isotropic Gaussian surface (Nayak 1971)
   real(wp), parameter, public :: alpha_min = 1.5_wp
   !> c = 1 - 3 sqrt 3 + 16/pi = 0.896806: the variance of summit heights is m0 (1 - c/alpha)
   real(wp), parameter, public :: summit_constant = 1.0_wp - 3.0_wp*sqrt(3.0_wp) + 16.0_wp/pi
   !> Smallest eta R sigma of an isotropic Gaussian surface, sigma that of summit heights:
   !> alpha - c = 768 pi (eta R sigma)^2 with alpha = 1.5, which gives 0.0158
   real(wp), parameter, public :: roughness_number_min = &
      sqrt((alpha_min - summit_constant)/(768.0_wp*pi))
   !> The same with the standard deviation Sq of all heights, as in the paper:
   !> alpha = 768 pi (eta R Sq)^2 = 1.5, 1/(16 sqrt(2 pi)), which is 0.0249
   real(wp), parameter, public :: roughness_number_min_sq = sqrt(alpha_min/(768.0_wp*pi))
   !> Largest eta R sigma, 15.8: one slip by a factor of 1000 leads out of the range from anywhere
   !> in it. It belongs to alpha = 6e5; rough wood has 0.2 to 4
   real(wp), parameter, public :: roughness_number_max = 1000.0_wp*roughness_number_min
   !> Above this eta R sigma a warning is given: no face measured so far has more
   real(wp), parameter, public :: roughness_number_measured = 4.0_wp

   !> What is checked, in this order
   enum, bind(c)
      enumerator :: of_sigma = 1, of_radius, of_number, of_modulus, of_hardness, of_ratio
   end enum

   !> A range that no solid and no face is outside of.
   type :: range_type
      !> Name, the values that it is made of, and its unit with a blank before it
      character(len=17) :: name, subject
      character(len=4) :: unit
      real(wp) :: lowest, highest
   end type range_type

   !> Why, sigma: an atom to the joints of rock (sawn timber has 0.2 mm). radius: an atom to the
   !> summits of an optical mirror. modulus: diamond against a rigid body. hardness: soft foam to
   !> diamond. H/E*: metals have 6e-4 (indium) to 0.05, wood 0.002 to 0.1, the hardest glasses 0.15;
   !> from 1 on a summit would yield only when pressed in by its whole radius
   type(range_type), parameter, public :: ranges(6) = [ &
      range_type('sigma', 'sigma', ' mm', 1.0e-7_wp, 5.0_wp), &
      range_type('radius', 'radius', ' mm', 1.0e-7_wp, 1.0e4_wp), &
      range_type('eta*radius*sigma', 'eta radius sigma', '', roughness_number_min, &
      roughness_number_max), &
      range_type('modulus', 'modulus', ' MPa', 0.0_wp, 1.3e6_wp), &
      range_type('hardness', 'hardness', ' MPa', 0.1_wp, 1.5e5_wp), &
      range_type('hardness/modulus', 'hardness modulus', '', 1.0e-4_wp, 1.0_wp)]

   !> Largest critical slip and distance of the datum, mm: the paper's critical slip is 0.31; a
   !> datum is farther only where the law reaches as far
   real(wp), parameter, public :: length_max = 10.0_wp

   !> Slips of eta, radius and sigma that are tried, the likeliest first: powers of ten that each
   !> must be multiplied by
   integer, parameter :: roughness_slips(3, 12) = reshape([6, 0, 0, 0, 0, -3, 0, -3, 0, &
      6, 0, -3, 6, -3, 0, 6, -3, -3, -6, 0, 0, 0, -3, -3, 0, 0, 3, 0, 3, 0, 0, 3, 3, -2, 0, 0], &
      [3, 12])
   !> The same of modulus and hardness
   integer, parameter :: strength_slips(2, 9) = reshape([-6, 0, 3, 0, 0, -6, 0, 3, -6, -6, 3, 3, &
      -3, 0, 0, -3, -3, -3], [2, 9])
   !> Root mean square slopes of profiles of usual faces, and their H/E*
   real(wp), parameter :: usual_slopes(2) = [0.01_wp, 1.0_wp], &
      usual_ratios(2) = [5.0e-4_wp, 0.3_wp]
   !> A face in N-m-Pa looks like one of N-mm-MPa that is a thousand times smoother and whose
   !> stresses are in Pa by a slip. Up to this sigma and radius, mm, which timber has, it is taken
   !> for the former; smoother faces, as ground metal has, for the latter
   real(wp), parameter :: sigma_in_si = 0.2_wp, radius_in_si = 10.0_wp
   integer, parameter :: message_length = 160
   character(len=*), parameter :: way_past = &
      '; if it is right, set accept_unphysical (PROPS(13) = 1 in UINTER)'

contains

   !> Find the flags of properties outside these ranges, and set `error`, which names the likely
   !> slip of units, unless that is accepted.
   pure subroutine check_plausible(eta, modulus, radius, hardness, sigma, is_accepted, flags, error)
      !> Asperity density, 1/mm^2; equivalent modulus, MPa; summit radius, mm
      real(wp), intent(in) :: eta, modulus, radius
      !> Hardness, MPa; standard deviation of summit heights, mm
      real(wp), intent(in) :: hardness, sigma
      !> Whether they are let pass
      logical, intent(in) :: is_accepted
      !> Sum of validity flags
      integer, intent(out) :: flags
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: number, ratio, values(size(ranges))
      logical :: is_outside(size(ranges))

      number = eta*radius*sigma
      ratio = hardness/modulus
      flags = valid
      if (number < roughness_number_min) flags = ior(flags, roughness_number_low)
      if (number > roughness_number_measured) flags = ior(flags, roughness_number_high)
      if (is_within(sigma, of_sigma) .and. is_within(radius, of_radius) &
         .and. is_within(number, of_number) .and. is_within(modulus, of_modulus) &
         .and. is_within(hardness, of_hardness) .and. is_within(ratio, of_ratio)) return

      values([of_sigma, of_radius, of_number]) = [sigma, radius, number]
      values([of_modulus, of_hardness, of_ratio]) = [modulus, hardness, ratio]
      is_outside = values < ranges%lowest .or. values > ranges%highest
      if (any(is_outside([of_sigma, of_radius, of_modulus, of_hardness, of_ratio]))) &
         flags = ior(flags, implausible_property)
      if (is_accepted) return
      if (is_in_si(eta, modulus, radius, hardness, sigma)) then
         flags = iand(flags, not(implausible_property))
      else
         call refuse(eta, modulus, radius, hardness, sigma, values, &
            findloc(is_outside, .true., dim=1), error)
      end if
   end subroutine check_plausible

   pure logical function is_within(value, i)
      real(wp), intent(in) :: value
      integer, intent(in) :: i

      is_within = value >= ranges(i)%lowest .and. value <= ranges(i)%highest
   end function is_within

   !> Say which of the values is outside its range, and which slip of units would put it there.
   pure subroutine refuse(eta, modulus, radius, hardness, sigma, values, i, error)
      real(wp), intent(in) :: eta, modulus, radius, hardness, sigma, values(:)
      integer, intent(in) :: i
      type(error_type), allocatable, intent(out) :: error
      type(range_type) :: allowed
      logical :: is_low
      character(len=message_length) :: made_of, remedy

      made_of = ''
      if (i == of_number) &
         made_of = ' = '//to_text(eta)//'*'//to_text(radius)//'*'//to_text(sigma)
      if (i == of_ratio) made_of = ' = '//to_text(hardness)//'/'//to_text(modulus)
      if (i < of_modulus) then
         remedy = roughness_slip(eta, radius, sigma)
      else
         remedy = strength_slip(modulus, hardness)
      end if
      allowed = ranges(i)
      is_low = values(i) < allowed%lowest
      call fatal_error(error, trim(allowed%name)//trim(made_of)//' = '//to_text(values(i), 3)// &
         trim(allowed%unit)//' is '//trim(merge('below', 'above', is_low))//' '// &
         to_text(merge(allowed%lowest, allowed%highest, is_low), 3)//trim(allowed%unit)// &
         ', which '//trim(merge('no isotropic Gaussian surface', 'no known face or solid       ', &
         is_low .and. i == of_number))//' has: '//trim(remedy)//way_past, &
         subject=trim(allowed%subject))
   end subroutine refuse

   !> The same of a length of the contact point, critical slip or datum.
   pure subroutine check_plausible_length(name, value, highest, is_accepted, flags, error)
      !> Name of the property
      character(len=*), intent(in) :: name
      !> Its value and the largest size, mm
      real(wp), intent(in) :: value, highest
      !> Whether it is let pass
      logical, intent(in) :: is_accepted
      !> Sum of validity flags, to which one may be added
      integer, intent(inout) :: flags
      !> Set when it is refused
      type(error_type), allocatable, intent(inout) :: error

      if (abs(value) <= highest) return
      flags = ior(flags, implausible_property)
      if (.not. is_accepted) call fatal_error(error, name//' = '//to_text(value, 3)// &
         ' mm is above '//to_text(highest, 3)//' mm, which no known face has: '//name// &
         ' looks like um, give it in mm (times 1e-3)'//way_past, subject=name)
   end subroutine check_plausible_length

   !> Name the slip of eta, radius and sigma that leaves a usual face.
   pure function roughness_slip(eta, radius, sigma) result(text)
      real(wp), intent(in) :: eta, radius, sigma
      character(len=message_length) :: text
      real(wp) :: values(3)
      integer :: i

      do i = 1, size(roughness_slips, 2)
         values = [eta, radius, sigma]*10.0_wp**roughness_slips(:, i)
         if (.not. is_usual_face(values(1), values(2), values(3))) cycle
         text = slip_text(['eta   ', 'radius', 'sigma '], ['1/mm^2', 'mm    ', 'mm    '], &
            roughness_slips(:, i))
         return
      end do
      text = 'check the units of eta (1/mm^2), radius (mm) and sigma (mm)'
   end function roughness_slip

   !> Whether a face is a usual one. By Nayak's density and McCool's radius the mean square slope of
   !> profiles is sqrt(3)/(128 eta R^2).
   pure logical function is_usual_face(eta, radius, sigma) result(is_usual)
      real(wp), intent(in) :: eta, radius, sigma
      real(wp) :: slope

      slope = sqrt(sqrt(3.0_wp)/(128.0_wp*eta*radius**2))
      is_usual = slope >= usual_slopes(1) .and. slope <= usual_slopes(2) &
         .and. eta*radius*sigma >= roughness_number_min &
         .and. eta*radius*sigma <= roughness_number_measured &
         .and. sigma >= ranges(of_sigma)%lowest .and. sigma <= ranges(of_sigma)%highest
   end function is_usual_face

   !> Whether properties are those of a usual face and solid when they are read in N-m-Pa.
   pure logical function is_in_si(eta, modulus, radius, hardness, sigma)
      real(wp), intent(in) :: eta, modulus, radius, hardness, sigma

      is_in_si = is_usual_face(1.0e-6_wp*eta, 1.0e3_wp*radius, 1.0e3_wp*sigma) &
         .and. 1.0e3_wp*sigma <= sigma_in_si .and. 1.0e3_wp*radius <= radius_in_si &
         .and. is_usual_solid(1.0e-6_wp*modulus, 1.0e-6_wp*hardness)
   end function is_in_si

   !> Whether a solid is a usual one.
   pure logical function is_usual_solid(modulus, hardness) result(is_usual)
      real(wp), intent(in) :: modulus, hardness

      is_usual = modulus <= ranges(of_modulus)%highest &
         .and. hardness >= ranges(of_hardness)%lowest &
         .and. hardness <= ranges(of_hardness)%highest &
         .and. hardness/modulus >= usual_ratios(1) .and. hardness/modulus <= usual_ratios(2)
   end function is_usual_solid

   !> Name the slip of modulus and hardness that leaves a usual solid.
   pure function strength_slip(modulus, hardness) result(text)
      real(wp), intent(in) :: modulus, hardness
      character(len=message_length) :: text
      real(wp) :: e, h
      integer :: i

      do i = 1, size(strength_slips, 2)
         e = modulus*10.0_wp**strength_slips(1, i)
         h = hardness*10.0_wp**strength_slips(2, i)
         if (.not. is_usual_solid(e, h)) cycle
         text = slip_text(['modulus ', 'hardness'], ['MPa', 'MPa'], strength_slips(:, i))
         return
      end do
      text = 'check the units of modulus and hardness (MPa)'
   end function strength_slip

   !> Say in which unit properties seem to be, and what to do.
   pure function slip_text(names, units, powers) result(text)
      !> Names of the properties, and their units
      character(len=*), intent(in) :: names(:), units(:)
      !> Powers of ten that they must be multiplied by
      integer, intent(in) :: powers(:)
      character(len=message_length) :: text
      integer :: i

      text = ''
      do i = 1, size(names)
         if (powers(i) == 0) cycle
         if (text /= '') text = trim(text)//'; '
         text = trim(text)//' '//trim(names(i))//' looks like '// &
            trim(unit_of(units(i), powers(i)))//', give it in '//trim(units(i))//' (times 1e'// &
            to_text(powers(i))//')'
      end do
      text = adjustl(text)
   end function slip_text

   !> Unit of a number that becomes one of `unit` when multiplied by a power of ten.
   pure function unit_of(unit, power) result(text)
      character(len=*), intent(in) :: unit
      integer, intent(in) :: power
      character(len=6) :: text

      select case (power)
      case (6)
         text = '1/um^2'
      case (-2)
         text = '1/cm^2'
      case (3)
         text = merge('GPa', 'm  ', unit == 'MPa')
      case (-3)
         text = merge('kPa', 'um ', unit == 'MPa')
      case (-6)
         text = merge('Pa   ', '1/m^2', unit == 'MPa')
      case default
         text = unit
      end select
   end function unit_of

end module asperity_law_plausibility
