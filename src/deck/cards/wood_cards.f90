!> The wood of the decks: orthotropic elasticity, yield, local axes.
module asperity_deck_cards_wood_cards
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_options, only: deck_choice, for_calculix
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: check_criterion, write_wood, write_axes

   !> Plastic strain up to which the yield stress is given
   real(wp), parameter :: largest_strain = 1.0_wp

contains

   !> `error` is set when the solver has no card for the wood's criterion of yield, or does not
   !> follow its curve.
   pure subroutine check_criterion(choice, wood, error)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> The wood
      type(wood_properties), intent(in) :: wood
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error

      if (wood%criterion == 'crushing') then
         call fatal_error(error, 'criterion = crushing cannot be written: no card of ABAQUS or '// &
            'CalculiX tells tension from compression in each direction of wood; take mises, or '// &
            'with ABAQUS hill', subject='criterion')
      else if (wood%criterion == 'hill' .and. for_calculix(choice)) then
         call fatal_error(error, 'criterion = hill cannot be written for CalculiX, whose yield '// &
            'beside nine elastic constants is that of Mises: take mises, or solver = abaqus', &
            subject='criterion solver')
      else if (wood%criterion == 'mises' .and. for_calculix(choice)) then
         call check_curve(error, 'hardening_curve', wood%hardening_curve)
         call check_curve(error, 'hardening_curve_along', wood%hardening_curve_along)
      end if
   end subroutine check_criterion

   !> Refuse a curve that CalculiX does not follow.
   pure subroutine check_curve(error, name, curve)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      !> Plastic strain and yield stress, MPa; not allocated for none
      real(wp), allocatable, intent(in) :: curve(:, :)

      if (allocated(error) .or. .not. allocated(curve)) return
      if (size(curve, 2) > 2) call fatal_error(error, name//' has '//to_text(size(curve, 2))// &
         ' points: beside nine elastic constants CalculiX takes the first two, and goes on in '// &
         'their line; give two, or take solver = abaqus', subject=name//' solver')
   end subroutine check_curve

   !> The material, which is checked. For Mises' criterion, which has one strength,
   !> `along` says whether contact presses its parts along the grain.
   pure subroutine write_wood(deck, choice, wood, name, along)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> The wood
      type(wood_properties), intent(in) :: wood
      !> Name of the material
      character(len=*), intent(in) :: name
      !> Whether it is pressed along the grain
      logical, intent(in) :: along

      call deck%line('*MATERIAL, NAME='//name)
      call deck%line('*ELASTIC, TYPE=ENGINEERING CONSTANTS')
      call deck%reals([wood%young_moduli, wood%poisson_ratios, wood%shear_moduli])
      if (wood%criterion == 'mises') then
         if (for_calculix(choice)) call deck%comment('Yield of CalculiX beside these elastic '// &
            'constants is that of Mises.')
         call deck%comment('Mises'' criterion: one strength in all directions, the same in '// &
            'tension and compression. The strength is that in the direction in which contact '// &
            'presses; in others the wood yields too early (beam, bent along the grain) or too '// &
            'late (column, pressed at the sides).')
         call write_yield(deck, wood, along)
      else if (wood%criterion == 'hill') then
         call deck%comment('Hill''s criterion, the same in tension and compression: reference '// &
            'is the strength in compression in R; ratios to it are those of the strengths in '// &
            'compression, and in shear times sqrt(3). The paper gives no strength in shear.')
         call write_yield(deck, wood, along=.false.)
         call deck%line('*POTENTIAL')
         associate (reference => wood%compression_strengths(2))
            call deck%reals([wood%compression_strengths/reference, &
               wood%shear_strengths/(reference/sqrt(3.0_wp))])
         end associate
      end if
   end subroutine write_wood

   !> Yield stress over plastic strain, by the curve or by the slope.
   pure subroutine write_yield(deck, wood, along)
      class(writer_type), intent(inout) :: deck
      type(wood_properties), intent(in) :: wood
      logical, intent(in) :: along

      call deck%line('*PLASTIC')
      if (along .and. allocated(wood%hardening_curve_along)) then
         call write_points(deck, wood%hardening_curve_along)
      else if (.not. along .and. allocated(wood%hardening_curve)) then
         call write_points(deck, wood%hardening_curve)
      else if (along) then
         call write_line(deck, wood%compression_strengths(1), &
            wood%hardening_along*wood%young_moduli(1))
      else
         call write_line(deck, wood%compression_strengths(2), &
            wood%hardening_across*wood%young_moduli(2))
      end if
   end subroutine write_yield

   !> A straight line of yield stress over plastic strain.
   pure subroutine write_line(deck, strength, slope)
      class(writer_type), intent(inout) :: deck
      real(wp), intent(in) :: strength, slope

      call write_points(deck, reshape([0.0_wp, strength, &
         largest_strain, strength + slope*largest_strain], [2, 2]))
   end subroutine write_line

   !> Points of plastic strain and yield stress, which the card has the other way round.
   pure subroutine write_points(deck, points)
      class(writer_type), intent(inout) :: deck
      real(wp), intent(in) :: points(:, :)
      integer :: i

      do i = 1, size(points, 2)
         call deck%reals([points(2, i), points(1, i)])
      end do
   end subroutine write_points

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
