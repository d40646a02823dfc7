!> The wood of the decks: orthotropic elasticity, yield, local axes.
module asperity_deck_cards_wood_cards
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_options, only: deck_choice, for_calculix
   use asperity_paper_wood, only: poisson_ratios, shear_moduli, wood_strength_across, &
      wood_strength_along, young_moduli
   implicit none
   private
   public :: wood_type, check_wood, write_wood, write_axes

   !> Wood; 1 = L along the grain, 2 = R radial, 3 = T tangential. Values of Table 1 of the paper
   !> but for the hardening, which is chosen.
   type :: wood_type
      !> Moduli in L, R and T, MPa
      real(wp) :: modulus(3) = young_moduli
      !> Poisson's ratios LR, LT, RT: strain in the second over that in the first direction, which
      !> is pulled
      real(wp) :: poisson(3) = poisson_ratios
      !> Shear moduli LR, LT, RT, MPa
      real(wp) :: shear(3) = shear_moduli
      !> Strength in compression along and across the grain, MPa
      real(wp) :: strength_along = wood_strength_along, &
         strength_across = wood_strength_across
      !> Slope of the stress over plastic strain, over the modulus; along and across the grain
      real(wp) :: hardening_along = 0.02_wp, hardening_across = 0.02_wp
   end type wood_type

   !> Plastic strain up to which the yield stress is given
   real(wp), parameter :: largest_strain = 1.0_wp

contains

   !> `error` is set unless the elastic constants store energy in every deformation and the
   !> strengths can be.
   pure subroutine check_wood(wood, error)
      !> The wood
      type(wood_type), intent(in) :: wood
      !> Set when it cannot be
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: c(3, 3), minors(2)

      if (.not. all([wood%modulus, wood%shear] > 0.0_wp)) then
         call fatal_error(error, 'the moduli of the wood must be above zero')
         return
      end if
      ! compliance, scaled to ones on the diagonal
      c = 0.0_wp
      c(1, 2) = wood%poisson(1)*sqrt(wood%modulus(2)/wood%modulus(1))
      c(1, 3) = wood%poisson(2)*sqrt(wood%modulus(3)/wood%modulus(1))
      c(2, 3) = wood%poisson(3)*sqrt(wood%modulus(3)/wood%modulus(2))
      minors(1) = 1.0_wp - c(1, 2)**2
      minors(2) = 1.0_wp - c(1, 2)**2 - c(1, 3)**2 - c(2, 3)**2 &
         - 2.0_wp*c(1, 2)*c(1, 3)*c(2, 3)
      if (.not. all(minors > 0.0_wp)) then
         call fatal_error(error, 'moduli of '//to_text(wood%modulus(1), 6)// &
            ' MPa along and '//to_text(wood%modulus(2), 6)//' MPa across the grain do not go '// &
            'with the Poisson''s ratios of Table 1: the wood would give energy when it is deformed')
         return
      end if
      call check_positive(error, 'strength along the grain', wood%strength_along, 'MPa')
      if (.not. allocated(error)) &
         call check_positive(error, 'strength across the grain', wood%strength_across, 'MPa')
   end subroutine check_wood

   !> The material. For CalculiX, `along` says whether contact presses its parts along the grain,
   !> as its yield knows one strength only.
   pure subroutine write_wood(deck, choice, wood, name, along)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> The wood
      type(wood_type), intent(in) :: wood
      !> Name of the material
      character(len=*), intent(in) :: name
      !> Whether it is pressed along the grain
      logical, intent(in) :: along

      call deck%line('*MATERIAL, NAME='//name)
      call deck%line('*ELASTIC, TYPE=ENGINEERING CONSTANTS')
      call deck%reals([wood%modulus, wood%poisson, wood%shear])
      if (choice%plasticity /= 'plastic') return
      if (for_calculix(choice)) then
         call deck%comment('Yield of CalculiX beside these elastic constants is that of Mises: '// &
            'one strength in all directions, the same in tension and compression. The strength '// &
            'is that in the direction in which contact presses; in others the wood yields too '// &
            'early (beam, bent along the grain) or too late (column, pressed at the sides).')
         call write_yield(deck, merge(wood%strength_along, wood%strength_across, along), &
            merge(wood%hardening_along*wood%modulus(1), wood%hardening_across*wood%modulus(2), &
            along))
      else
         call deck%comment('Hill''s criterion, the same in tension and compression: reference '// &
            'is the strength across the grain, R11 the strength along over that across the '// &
            'grain (Table 1). The paper gives no strength in shear: R12, R13, R23 are chosen, '// &
            'at shear strengths of fc90/sqrt(3).')
         call write_yield(deck, wood%strength_across, wood%hardening_across*wood%modulus(2))
         call deck%line('*POTENTIAL')
         call deck%reals([wood%strength_along/wood%strength_across, 1.0_wp, 1.0_wp, 1.0_wp, &
            1.0_wp, 1.0_wp])
      end if
   end subroutine write_wood

   !> Yield stress over plastic strain.
   pure subroutine write_yield(deck, strength, slope)
      class(writer_type), intent(inout) :: deck
      real(wp), intent(in) :: strength, slope

      call deck%line('*PLASTIC')
      call deck%reals([strength, 0.0_wp])
      call deck%reals([strength + slope*largest_strain, largest_strain])
   end subroutine write_yield

   !> Local axes: the direction of the grain, and the radial one.
   pure subroutine write_axes(deck, name, grain, radial)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Name of the axes
      character(len=*), intent(in) :: name
      !> Direction of 1 = L and of 2 = R
      real(wp), intent(in) :: grain(3), radial(3)

      call deck%line('*ORIENTATION, NAME='//name//', SYSTEM=RECTANGULAR')
      call deck%reals([grain, radial])
   end subroutine write_axes

end module asperity_deck_cards_wood_cards
