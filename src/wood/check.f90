!> Which wood can be: elastic constants that store energy, strengths, hardening and a criterion of
!> yield that leave one stress for every strain. Errors name the keys of the wood.
module asperity_wood_check
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_values, only: section_hardness, value_names
   implicit none
   private
   public :: check_wood_properties

   !> Ends of the names of keys: directions, and pairs of them
   character(len=1), parameter :: directions(3) = ['l', 'r', 't']
   character(len=2), parameter :: planes(3) = ['lr', 'lt', 'rt']
   !> Largest slope over the modulus: a wood that hardens more is as good as elastic
   real(wp), parameter :: largest_hardening = 1.0e9_wp
   !> Least of the minors of the compliance scaled to ones on its diagonal: below it rounding
   !> decides over the stiffness
   real(wp), parameter :: smallest_minor = 1.0e-9_wp
   !> How far the first stress of the curve may be from the strength, relatively
   real(wp), parameter :: curve_tolerance = 1.0e-6_wp
   !> Largest strain of the curve
   real(wp), parameter :: largest_strain = 1.0e3_wp

contains

   !> `error` is set when the wood cannot be.
   pure subroutine check_wood_properties(wood, error)
      !> The wood
      type(wood_properties), intent(in) :: wood
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      call check_each(error, 'young_modulus_', directions, wood%young_moduli)
      call check_each(error, 'shear_modulus_', planes, wood%shear_moduli)
      call check_each(error, 'compression_strength_', directions, wood%compression_strengths)
      call check_each(error, 'tension_strength_', directions, wood%tension_strengths)
      call check_each(error, 'shear_strength_', planes, wood%shear_strengths)
      do i = 1, 3
         if (allocated(error) .or. is_none(wood%hardnesses(i))) cycle
         call check_positive(error, trim(value_names(section_hardness + i - 1)), &
            wood%hardnesses(i), 'MPa')
      end do
      if (.not. allocated(error)) call check_range(error, 'hardening_along', &
         wood%hardening_along, 0.0_wp, largest_hardening, '')
      if (.not. allocated(error)) call check_range(error, 'hardening_across', &
         wood%hardening_across, 0.0_wp, largest_hardening, '')
      if (.not. allocated(error)) call check_energy(wood, error)
      if (.not. allocated(error)) call check_criterion(wood, error)
      if (.not. allocated(error) .and. allocated(wood%hardening_curve)) &
         call check_curve('hardening_curve', wood%hardening_curve, 'compression_strength_r', &
         wood%compression_strengths(2), error)
      if (.not. allocated(error) .and. allocated(wood%hardening_curve_along)) &
         call check_curve('hardening_curve_along', wood%hardening_curve_along, &
         'compression_strength_l', wood%compression_strengths(1), error)
   end subroutine check_wood_properties

   !> Refuse stresses that are not above zero, unless `error` is set.
   pure subroutine check_each(error, name, ends, values)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name, ends(3)
      real(wp), intent(in) :: values(3)
      integer :: i

      do i = 1, 3
         if (.not. allocated(error)) call check_positive(error, name//ends(i), values(i), 'MPa')
      end do
   end subroutine check_each

   !> Refuse elastic constants that give energy in some deformation.
   pure subroutine check_energy(wood, error)
      type(wood_properties), intent(in) :: wood
      type(error_type), allocatable, intent(inout) :: error
      integer, parameter :: first(3) = [1, 1, 2], second(3) = [2, 3, 3]
      real(wp) :: coupling(3), largest, determinant
      integer :: i

      associate (e => wood%young_moduli, nu => wood%poisson_ratios)
         do i = 1, 3
            ! below it all two directions store energy together
            largest = sqrt((1.0_wp - smallest_minor)*e(first(i))/e(second(i)))
            call check_range(error, 'poisson_ratio_'//planes(i), nu(i), -largest, largest, '')
            if (allocated(error)) return
            coupling(i) = nu(i)*sqrt(e(second(i))/e(first(i)))
         end do
         determinant = 1.0_wp - sum(coupling**2) - 2.0_wp*product(coupling)
         if (determinant >= smallest_minor) return
         call fatal_error(error, 'poisson_ratio_lr = '//to_text(nu(1))//', poisson_ratio_lt = '// &
            to_text(nu(2))//' and poisson_ratio_rt = '//to_text(nu(3))// &
            ' do not go together with Young''s moduli of '//to_text(e(1), 6)//', '// &
            to_text(e(2), 6)//' and '//to_text(e(3), 6)//' MPa: the wood would give energy '// &
            'when it is deformed; take smaller ratios', &
            subject='poisson_ratio_lr poisson_ratio_lt poisson_ratio_rt')
      end associate
   end subroutine check_energy

   !> Refuse a criterion that is unknown or open: Hill's is an ellipsoid's sections only while each
   !> reciprocal strength is below the sum of the others.
   pure subroutine check_criterion(wood, error)
      type(wood_properties), intent(in) :: wood
      type(error_type), allocatable, intent(inout) :: error
      real(wp) :: reciprocals(3)

      select case (wood%criterion)
      case ('none', 'mises', 'crushing')
         return
      case ('hill')
         reciprocals = 1.0_wp/wood%compression_strengths
         if (2.0_wp*maxval(reciprocals) < sum(reciprocals)) return
         associate (fc => wood%compression_strengths)
            call fatal_error(error, 'compression_strength_l = '//to_text(fc(1))// &
               ', compression_strength_r = '//to_text(fc(2))//' and compression_strength_t = '// &
               to_text(fc(3))//' MPa are not allowed with criterion = ''hill'', which needs '// &
               'each of 1/strength below the sum of the other two; take strengths closer to '// &
               'each other, or criterion = ''crushing''', subject='compression_strength_l '// &
               'compression_strength_r compression_strength_t criterion')
         end associate
      case default
         call fatal_error(error, 'criterion = '''//trim(wood%criterion)//''' is unknown: it '// &
            'must be one of none, mises, hill, crushing', subject='criterion')
      end select
   end subroutine check_criterion

   !> Refuse points that are no curve of yield stress, which begins at the strength and never falls.
   pure subroutine check_curve(name, curve, strength_name, strength, error)
      character(len=*), intent(in) :: name, strength_name
      real(wp), intent(in) :: curve(:, :), strength
      type(error_type), allocatable, intent(inout) :: error
      integer :: i, n

      n = size(curve, 2)
      if (size(curve, 1) /= 2 .or. n < 1) then
         call fatal_error(error, name//' has no points: give pairs of plastic strain and yield '// &
            'stress', subject=name)
         return
      end if
      do i = 1, n
         call check_range(error, name, curve(1, i), 0.0_wp, largest_strain, '')
         if (.not. allocated(error)) call check_positive(error, name, curve(2, i), 'MPa')
         if (allocated(error)) return
      end do
      if (curve(1, 1) > 0.0_wp .or. abs(curve(2, 1) - strength) > curve_tolerance*strength) then
         call fatal_error(error, name//' begins at a plastic strain of '//to_text(curve(1, 1))// &
            ' and '//to_text(curve(2, 1))//' MPa: it must begin at 0 and '//strength_name//' = '// &
            to_text(strength)//' MPa', subject=name//' '//strength_name)
         return
      end if
      do i = 2, n
         if (curve(1, i) > curve(1, i - 1) .and. curve(2, i) >= curve(2, i - 1)) cycle
         call fatal_error(error, name//' goes from '//to_text(curve(2, i - 1))// &
            ' MPa at a plastic strain of '//to_text(curve(1, i - 1))//' to '// &
            to_text(curve(2, i))//' MPa at '//to_text(curve(1, i))//': strains must rise, and '// &
            'stresses must not fall', subject=name)
         return
      end do
   end subroutine check_curve

end module asperity_wood_check
