!> The keys of wood, the same for every command: a preset, nine elastic constants, strengths,
!> hardening and criterion.
module asperity_program_commands_wood_keys
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_wood_ageing_keys, only: declare_ageing, of_wood
   use asperity_program_input_key_list, only: key_list
   use asperity_wood_ageing, only: aged_wood, ageing_factors, check_aged_wood, first_aged, &
      last_aged
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_names
   use asperity_wood_values, only: compression_strength, hardening_across, hardening_along, &
      n_values, poisson_ratio, section_hardness, set_wood_values, shear_modulus, shear_strength, &
      tension_strength, value_names, value_units, wood_values, young_modulus
   implicit none
   private
   public :: declare_wood

   character(len=*), parameter :: curves(2) = [character(len=21) :: 'hardening_curve', &
      'hardening_curve_along']

contains

   !> Declare the wood. Single values go before the preset, each of the options before all of the
   !> case file, and are those of new wood. Hidden is what does not act: with that criterion, or in
   !> a replay.
   pure subroutine declare_wood(wood, keys, pressed, sections, ageing)
      !> The wood, new or, with `ageing`, old; its criterion is a default
      type(wood_properties), intent(inout) :: wood
      !> The keys
      type(key_list), intent(inout) :: keys
      !> For a replay, which takes no more of the wood than it presses: whether along, and across
      !> the grain
      logical, intent(in), optional :: pressed(2)
      !> Sections, in L, R and T, whose constants faces take; none when absent
      logical, intent(in), optional :: sections(3)
      !> Old over new, of which the factors of faces are declared
      type(ageing_factors), intent(inout), optional :: ageing
      type(wood_properties) :: larch
      character(len=8) :: preset
      real(wp) :: values(n_values)
      logical :: acts(n_values)
      integer :: i, preset_key, places(n_values), curve, curve_along

      preset = 'larch'
      call keys%choice('wood', preset, 'larch', &
         'wood of Table 1, whose properties those below are unless given')
      preset_key = keys%last
      call keys%forget_case(preset_key, [(keys%find(trim(value_names(i))), i=1, n_values), &
         (keys%find(trim(curves(i))), i=1, size(curves))])
      values = wood_values(larch)
      do i = 1, n_values
         call keys%real(trim(value_names(i)), values(i), trim(value_units(i)), help_of(i))
         call keys%said_by('wood '//trim(preset))
         places(i) = keys%last
      end do
      call set_wood_values(wood, values)
      call declare_curve(keys, curves(1), wood%hardening_curve, &
         'plastic strain and yield stress, MPa, across the grain, in pairs, in place of the slope')
      curve = keys%last
      call declare_curve(keys, curves(2), wood%hardening_curve_along, &
         'the same along the grain, for mises in parts that are pressed along it')
      curve_along = keys%last
      call keys%choice('criterion', wood%criterion, 'none mises hill crushing', &
         'yield of the wood; none is elastic; crushing tells tension from compression')
      if (present(pressed)) call keys%unused(wood%criterion /= 'none')

      acts = acting(wood%criterion, pressed)
      keys%rows(curve)%unused = present(pressed) .or. .not. acts(hardening_across)
      keys%rows(curve_along)%unused = present(pressed) .or. .not. acts(hardening_along)
      if (.not. present(pressed)) then
         acts(hardening_across) = acts(hardening_across) .and. .not. allocated(wood%hardening_curve)
         acts(hardening_along) = acts(hardening_along) &
            .and. .not. allocated(wood%hardening_curve_along)
      end if
      if (present(sections)) acts = acts .or. of_sections(sections)
      keys%rows(places)%unused = .not. acts
      if (present(ageing)) call make_old(wood, keys, ageing, acts)
   end subroutine declare_wood

   !> Declare the factors that no face takes, and age the wood.
   pure subroutine make_old(wood, keys, ageing, acts)
      type(wood_properties), intent(inout) :: wood
      type(key_list), intent(inout) :: keys
      type(ageing_factors), intent(inout) :: ageing
      logical, intent(in) :: acts(n_values)
      type(error_type), allocatable :: error
      integer :: i

      call declare_ageing(ageing, keys, of_wood, &
         [(any(acts(first_aged(of_wood(i)):last_aged(of_wood(i)))), i=1, size(of_wood))])
      call check_aged_wood(wood, ageing, error)
      if (allocated(error)) call keys%refuse(error%message, error%subject)
      wood = aged_wood(wood, ageing)
   end subroutine make_old

   !> Declare a curve, whose values are pairs.
   pure subroutine declare_curve(keys, name, curve, help)
      type(key_list), intent(inout) :: keys
      character(len=*), intent(in) :: name, help
      real(wp), allocatable, intent(inout) :: curve(:, :)
      real(wp), allocatable :: pairs(:)

      if (allocated(curve)) deallocate (curve)
      call keys%list(trim(name), pairs, '', help)
      if (.not. allocated(pairs)) return
      if (modulo(size(pairs), 2) == 0) then
         curve = reshape(pairs, [2, size(pairs)/2])
      else
         call keys%refuse(trim(name)//' has '//to_text(size(pairs))// &
            ' values: it takes pairs of plastic strain and yield stress', trim(name))
      end if
   end subroutine declare_curve

   !> Which values act.
   pure function acting(criterion, pressed) result(acts)
      character(len=*), intent(in) :: criterion
      logical, intent(in), optional :: pressed(2)
      logical :: acts(n_values)

      acts = .false.
      if (present(pressed)) then
         acts(young_modulus:young_modulus + 1) = pressed
         if (criterion == 'none') return
         acts(compression_strength:compression_strength + 1) = pressed
         acts([hardening_along, hardening_across]) = pressed
         return
      end if
      acts(:shear_modulus + 2) = .true.
      if (criterion == 'none') return
      acts(hardening_across) = .true.
      acts(compression_strength:compression_strength + 1) = .true.
      if (criterion == 'mises') then
         acts(hardening_along) = .true.
         return
      end if
      acts(compression_strength + 2) = .true.
      acts(shear_strength:shear_strength + 2) = .true.
      acts(tension_strength:tension_strength + 2) = criterion == 'crushing'
   end function acting

   !> Which values the constants of sections are made of (see `section_elasticity`).
   pure function of_sections(sections) result(acts)
      logical, intent(in) :: sections(3)
      logical :: acts(n_values)

      acts = .false.
      acts(section_hardness:) = sections
      acts(young_modulus:young_modulus + 2) = sections
      acts(young_modulus + 1) = sections(2) .or. sections(3)
      acts(poisson_ratio + 1) = sections(1)
      acts(poisson_ratio + 2) = sections(2) .or. sections(3)
   end function of_sections

   !> What a value is.
   pure function help_of(place) result(help)
      integer, intent(in) :: place
      character(len=:), allocatable :: help
      character(len=*), parameter :: directions(3) = [character(len=16) :: 'along the grain', &
         'radial', 'tangential'], planes(3) = ['LR', 'LT', 'RT']

      select case (place)
      case (:poisson_ratio - 1)
         help = 'Young''s modulus, '//trim(directions(place))
      case (poisson_ratio:shear_modulus - 1)
         associate (plane => planes(place - poisson_ratio + 1))
            help = 'Poisson''s ratio '//plane//': strain in '//plane(2:)//' over that in '// &
               plane(:1)//', which is pulled'
         end associate
      case (shear_modulus:compression_strength - 1)
         help = 'shear modulus '//planes(place - shear_modulus + 1)
      case (compression_strength:tension_strength - 1)
         help = 'strength in compression, '//trim(directions(place - compression_strength + 1))
      case (tension_strength:shear_strength - 1)
         help = 'strength in tension, '//trim(directions(place - tension_strength + 1))
      case (shear_strength:hardening_along - 1)
         help = 'strength in shear '//planes(place - shear_strength + 1)
      case (hardening_along)
         help = 'slope of yield stress over plastic strain, along the grain, over young_modulus_l'
      case (section_hardness:)
         help = 'hardness of the '//trim(section_names(place - section_hardness + 1))// &
            ' section, for faces of it'
      case default
         help = 'the same across the grain, over young_modulus_r'
      end select
   end function help_of

end module asperity_program_commands_wood_keys
