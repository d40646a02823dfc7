!> First lines of every deck: what made it, units, what was and was not run.
module asperity_deck_cards_banner
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_options, only: deck_choice, element_kind, for_calculix
   implicit none
   private
   public :: write_head

contains

   !> Write the first lines.
   pure subroutine write_head(deck, choice, title)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> What the model is
      character(len=*), intent(in) :: title

      call deck%line('*HEADING')
      call deck%line(title)
      call deck%comment('Made by asperity '//version//':')
      call deck%line('**    '//choice%command)
      call deck%comment('Units: N, mm, MPa, s.')
      if (for_calculix(choice)) then
         select case (choice%contact)
         case ('uinter')
            call deck%comment('For CalculiX (ccx) 2.20 with UINTER, which interface/calculix '// &
               'builds. A stock ccx refuses this deck.')
         case ('table')
            call deck%comment('For a stock CalculiX (ccx) 2.20: the law as a table.')
         case default
            call deck%comment('For a stock CalculiX (ccx) 2.20: hard contact.')
         end select
      else
         call deck%comment('For ABAQUS/Standard. Not run: ABAQUS was not available.')
         if (choice%contact == 'uinter') &
            call deck%comment('   abaqus job=... user=asperity_uinter')
      end if
      call deck%comment('Elements: '//element_kind(choice)//'. The paper used C3D8R; in '// &
         'CalculiX that one deforms without resistance (hourglassing), C3D8I does not and '// &
         'bends well.')
      call deck%comment('')
   end subroutine write_head

end module asperity_deck_cards_banner
