!> Contact as decks say it: UINTER with its properties, the law as a table, or hard contact, each
!> for ABAQUS and for CalculiX.
module asperity_deck_cards_interaction
   use asperity_abaqus_prop_slots, only: n_props, prop_accept_unphysical, prop_names, &
      prop_slip_integration
   use asperity_abaqus_props, only: properties_from_props, props_from_properties
   use asperity_abaqus_statev, only: statev_needed
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_law_rows, only: law_table, new_law_table, stick_slope
   use asperity_deck_law_rows_text, only: calculix_rows
   use asperity_deck_solver_friction, only: check_solver_friction, friction_parameters, &
      friction_rows
   use asperity_deck_options, only: deck_choice, for_calculix
   use asperity_law_normal_inverse, only: separation_for_pressure
   implicit none
   private
   public :: interaction_type, new_interaction, overclosure_for, write_interaction, write_pair

   !> Contact of one kind of faces.
   type :: interaction_type
      !> Name in the deck
      character(len=16) :: name
      !> Law and friction
      type(contact_properties) :: properties
      !> The law in rows, for `table`
      type(law_table) :: table
      !> Pressure whose stick slope is taken where the slope is constant, MPa
      real(wp) :: stick_pressure = 0.0_wp
   end type interaction_type

   !> What LINEAR of CalculiX pulls at a large clearance, MPa, as small as its smoothing allows
   real(wp), parameter :: pull = 1.0e-3_wp

contains

   !> Prepare contact for the deck. `error` is set when the table cannot be made.
   pure subroutine new_interaction(interaction, choice, name, properties, stick_pressure, error)
      !> Result
      type(interaction_type), intent(out) :: interaction
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Name in the deck
      character(len=*), intent(in) :: name
      !> Law and friction
      type(contact_properties), intent(in) :: properties
      !> Pressure of the stick slope unless the choices have one, MPa
      real(wp), intent(in) :: stick_pressure
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: largest, smallest

      interaction%name = name
      interaction%properties = properties
      interaction%stick_pressure = stick_pressure
      if (allocated(choice%stick_pressure)) interaction%stick_pressure = choice%stick_pressure
      if (choice%contact /= 'uinter') &
         call check_solver_friction(properties, for_calculix(choice), error)
      if (allocated(error) .or. choice%contact /= 'table') return
      largest = properties%normal%hardness
      if (allocated(choice%largest_pressure)) largest = choice%largest_pressure
      smallest = properties%p_open
      if (allocated(choice%smallest_pressure)) smallest = choice%smallest_pressure
      call new_law_table(interaction%table, properties, largest, error, &
         tolerance=choice%tolerance, most_rows=choice%rows, smallest_pressure=smallest)
      if (allocated(error) .or. .not. for_calculix(choice)) return
      if (size(interaction%table%pressure) > calculix_rows) call fatal_error(error, 'rows = '// &
         to_text(choice%rows)//' lets the table have '//to_text(size(interaction%table%pressure)) &
         //', too many for CalculiX, which takes '//to_text(calculix_rows), subject='rows')
   end subroutine new_interaction

   !> Overclosure of the mesh faces at which contact has a pressure. `error` is set when the law
   !> reaches no such pressure.
   pure subroutine overclosure_for(interaction, choice, name, pressure, overclosure, error)
      !> Contact
      type(interaction_type), intent(in) :: interaction
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> What the pressure is called, and its value, MPa
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: pressure
      !> Overclosure, mm
      real(wp), intent(out) :: overclosure
      !> Set when the law cannot reach the pressure
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: separation

      overclosure = 0.0_wp
      if (choice%contact == 'hard') then
         ! that of CalculiX; for ABAQUS next to nothing, so that both have one mesh
         overclosure = pressure/choice%penalty
      else if (pressure > interaction%properties%normal%hardness) then
         call fatal_error(error, name//' = '//to_text(pressure)//' MPa is above the hardness, '// &
            to_text(interaction%properties%normal%hardness)// &
            ' MPa: the law reaches no such pressure', subject=name)
      else
         call separation_for_pressure(interaction%properties%normal, pressure, separation, error)
         overclosure = interaction%properties%initial_separation - separation
      end if
   end subroutine overclosure_for

   !> The lines of one interaction.
   pure subroutine write_interaction(deck, choice, interaction)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Contact
      type(interaction_type), intent(in) :: interaction

      select case (choice%contact)
      case ('uinter')
         call write_uinter(deck, choice, interaction)
      case ('table')
         call write_table(deck, choice, interaction)
      case default
         call write_hard(deck, choice, interaction)
      end select
   end subroutine write_interaction

   pure subroutine write_uinter(deck, choice, interaction)
      class(writer_type), intent(inout) :: deck
      type(deck_choice), intent(in) :: choice
      type(interaction_type), intent(in) :: interaction
      real(wp) :: props(n_props + 2*interaction%properties%friction%friction_points)
      type(contact_properties) :: read_back
      type(error_type), allocatable :: refused
      character(len=:), allocatable :: counts, names
      integer :: n, i

      props = props_from_properties(interaction%properties)
      ! what is unphysical is accepted only where UINTER would refuse it, and what is zero at the
      ! end is left out
      props(prop_accept_unphysical) = 0.0_wp
      call properties_from_props(props, read_back, refused)
      if (allocated(refused)) props(prop_accept_unphysical) = 1.0_wp
      n = max(prop_slip_integration, findloc(abs(props) > 0.0_wp, .true., dim=1, back=.true.))
      names = trim(prop_names(1))
      do i = 2, min(n, n_props)
         names = names//', '//trim(prop_names(i))
      end do
      if (n > n_props) names = names//', a pressure (MPa) and a factor for each of them'
      counts = 'PROPERTIES='//to_text(n)//', DEPVAR='// &
         to_text(statev_needed(interaction%properties))
      call deck%comment('UINTER of asperity: '//names//'. Separation of the mean planes = d0 - '// &
         'overclosure of the mesh faces.')
      if (for_calculix(choice)) then
         call deck%line('*SURFACE INTERACTION, NAME='//trim(interaction%name))
         call deck%line('*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, '//counts// &
            ', SEARCH DISTANCE='//to_text(choice%search_distance))
         call deck%reals(props(:n))
         call deck%comment('CalculiX needs a friction to make room and to solve '// &
            'unsymmetrically; its numbers are not used.')
         call deck%line('*FRICTION')
         call deck%reals([1.0_wp, 1.0_wp])
      else
         call deck%line('*SURFACE INTERACTION, NAME='//trim(interaction%name)//', USER, '// &
            counts//', UNSYMM')
         ! ABAQUS takes this line for a thickness: without it, for the first properties
         call deck%line()
         call deck%reals(props(:n))
      end if
   end subroutine write_uinter

   pure subroutine write_table(deck, choice, interaction)
      class(writer_type), intent(inout) :: deck
      type(deck_choice), intent(in) :: choice
      type(interaction_type), intent(in) :: interaction
      integer :: i

      associate (table => interaction%table)
         call deck%comment('The law in '//to_text(size(table%pressure))//' rows of pressure '// &
            '(MPa) and overclosure (mm), each within '//to_text(100.0_wp*table%error, 3)// &
            ' % of the law from '//to_text(table%smallest_pressure, 3)//' to '// &
            to_text(table%largest_pressure, 4)//' MPa, within '//to_text(table%low_error, 3)// &
            ' MPa below; the last row only carries the slope on.')
         call deck%line('*SURFACE INTERACTION, NAME='//trim(interaction%name))
         call deck%line('*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR')
         do i = 1, size(table%pressure)
            call deck%reals([table%pressure(i), table%overclosure(i)])
         end do
      end associate
      call write_friction(deck, choice, interaction)
   end subroutine write_table

   pure subroutine write_hard(deck, choice, interaction)
      class(writer_type), intent(inout) :: deck
      type(deck_choice), intent(in) :: choice
      type(interaction_type), intent(in) :: interaction

      if (for_calculix(choice)) then
         call deck%comment('Hard contact as CalculiX has it: pressure over penetration '// &
            '(MPa/mm), pull at a large clearance (MPa), the largest clearance with a spring '// &
            'over the root of the node''s area. The first is chosen: large '// &
            'against the wood, yet it converges.')
         call deck%line('*SURFACE INTERACTION, NAME='//trim(interaction%name))
         call deck%line('*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR')
         call deck%reals([choice%penalty, pull, 1.0e-3_wp])
      else
         call deck%line('*SURFACE INTERACTION, NAME='//trim(interaction%name))
         call deck%line('*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD')
      end if
      call write_friction(deck, choice, interaction)
   end subroutine write_hard

   !> Coulomb's friction of the solver, with elastic slip.
   pure subroutine write_friction(deck, choice, interaction)
      class(writer_type), intent(inout) :: deck
      type(deck_choice), intent(in) :: choice
      type(interaction_type), intent(in) :: interaction
      integer :: i

      associate (p => interaction%properties)
         if (for_calculix(choice)) then
            call deck%comment('Friction coefficient, and the slope of the shear stress in '// &
               'stick (MPa/mm), which CalculiX keeps constant while the law''s is mu p/gcrit: '// &
               'taken at p = '//to_text(interaction%stick_pressure, 6)//' MPa. Unlike UINTER, '// &
               'CalculiX counts slip while the faces are apart.')
            call deck%line('*FRICTION')
            call deck%reals([p%friction_coefficient, stick_slope(p, interaction%stick_pressure)])
         else
            call deck%comment('Friction coefficient; the elastic slip (mm) makes the slope in '// &
               'stick mu p/gcrit, as in UINTER.')
            call deck%line('*FRICTION, ELASTIC SLIP='//to_text(p%critical_slip)// &
               friction_parameters(p))
            associate (rows => friction_rows(p))
               do i = 1, size(rows, 1)
                  call deck%reals(rows(i, :))
               end do
            end associate
         end if
      end associate
   end subroutine write_friction

   !> One contact pair.
   pure subroutine write_pair(deck, interaction, slave, master)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Contact
      type(interaction_type), intent(in) :: interaction
      !> Names of the surfaces
      character(len=*), intent(in) :: slave, master

      call deck%line('*CONTACT PAIR, INTERACTION='//trim(interaction%name)// &
         ', TYPE=NODE TO SURFACE')
      call deck%line(slave//', '//master)
   end subroutine write_pair

end module asperity_deck_cards_interaction
