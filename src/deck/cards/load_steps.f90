!> Static steps and output requests, as ABAQUS and CalculiX write them.
module asperity_deck_cards_load_steps
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_options, only: deck_choice, for_calculix
   implicit none
   private
   public :: step_type, open_step, close_step, write_boundary

   !> Increments of a step before a solver gives up
   integer, parameter :: most_increments = 10000
   !> Times of a step, in the unit of the deck.
   type :: step_type
      !> Name, letters and digits
      character(len=24) :: name = ''
      !> Length of the step, first and largest increment
      real(wp) :: period = 1.0_wp, first = 1.0_wp, largest = 1.0_wp
      !> Whether the increments are as given, without a solver's choice
      logical :: direct = .false.
   end type step_type

contains

   !> Begin a step.
   pure subroutine open_step(deck, choice, step)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> The step
      type(step_type), intent(in) :: step
      real(wp), parameter :: smallest = 1.0e-6_wp

      if (for_calculix(choice)) then
         call deck%line('*STEP, NLGEOM, INC='//to_text(most_increments))
      else
         call deck%line('*STEP, NAME='//trim(step%name)//', NLGEOM=YES, UNSYMM=YES, INC='// &
            to_text(most_increments))
      end if
      if (step%direct) then
         call deck%line('*STATIC, DIRECT')
         call deck%reals([step%first, step%period])
      else
         call deck%line('*STATIC')
         call deck%reals([step%first, step%period, smallest*step%period, step%largest])
      end if
      ! CalculiX gives up after 4 and 8 iterations that do not get better, just before it would
      ! freeze the contact springs, which lets them settle
      if (for_calculix(choice)) then
         call deck%line('*CONTROLS, PARAMETERS=TIME INCREMENTATION')
         call deck%line('20, 25, 9, 40, 12, 4, , 12')
      end if
   end subroutine open_step

   !> A displacement of a set of nodes.
   pure subroutine write_boundary(deck, set, direction, displacement)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Name of the set
      character(len=*), intent(in) :: set
      !> 1, 2 or 3
      integer, intent(in) :: direction
      !> Displacement, mm
      real(wp), intent(in) :: displacement

      call deck%line('*BOUNDARY')
      call deck%line(set//', '//to_text(direction)//', '//to_text(direction)//', '// &
         to_text(displacement, 12))
   end subroutine write_boundary

   !> Results of a step, and its end.
   pure subroutine close_step(deck, choice, yields, force_sets, gauges)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Whether the wood yields
      logical, intent(in) :: yields
      !> Sets whose sum of forces is written in every increment
      character(len=*), intent(in) :: force_sets(:)
      !> Sets whose displacements are
      character(len=*), intent(in) :: gauges(:)
      integer :: i

      if (for_calculix(choice)) then
         do i = 1, size(force_sets)
            call deck%line('*NODE PRINT, NSET='//trim(force_sets(i))//', TOTALS=ONLY, FREQUENCY=1')
            call deck%line('RF')
         end do
         do i = 1, size(gauges)
            call deck%line('*NODE PRINT, NSET='//trim(gauges(i))//', FREQUENCY=1')
            call deck%line('U')
         end do
         ! the frequency of CalculiX is one for all that is written
         call deck%line('*NODE FILE')
         call deck%line('U')
         if (choice%field == 'all') then
            call deck%line('*EL FILE')
            call deck%line(stresses(yields))
         end if
         call deck%line('*CONTACT FILE')
         call deck%line('CDIS, CSTR')
      else
         call deck%line('*OUTPUT, HISTORY, FREQUENCY=1')
         do i = 1, size(force_sets)
            call deck%line('*NODE OUTPUT, NSET='//trim(force_sets(i)))
            call deck%line('RF')
         end do
         do i = 1, size(gauges)
            call deck%line('*NODE OUTPUT, NSET='//trim(gauges(i)))
            call deck%line('U')
         end do
         call deck%line('*OUTPUT, FIELD, FREQUENCY=1')
         call deck%line('*NODE OUTPUT')
         call deck%line('U')
         if (choice%field == 'all') then
            call deck%line('*ELEMENT OUTPUT')
            call deck%line(stresses(yields))
         end if
         call deck%line('*CONTACT OUTPUT')
         call deck%line('CSTRESS, CDISP')
      end if
      call deck%line('*END STEP')
   end subroutine close_step

   !> What is written of the elements.
   pure function stresses(yields) result(names)
      logical, intent(in) :: yields
      character(len=:), allocatable :: names

      names = 'S'
      if (yields) names = 'S, PEEQ'
   end function stresses

end module asperity_deck_cards_load_steps
