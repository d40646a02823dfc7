!> What the commands that write input decks have in common: keys and table.
module asperity_program_commands_deck_parts
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_hexahedra, only: hex_mesh, mesh_volume
   use asperity_deck_options, only: deck_choice
   use asperity_program_commands_faces_properties, only: hardness
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_table_keys, only: declare_table
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_counts, new_table
   implicit none
   private
   public :: declare_law_table, declare_deck, fill_table

   !> Criterion of yield of a deck unless given: no solver has a card for that of `wood_properties`,
   !> and Mises' or Hill's, taken without asking, would pass for it
   character(len=*), parameter, public :: usual_criterion = 'none'

contains

   !> Declare the law as a table.
   pure subroutine declare_law_table(choice, faces, keys)
      !> Choices of the deck
      type(deck_choice), intent(inout) :: choice
      !> The faces, declared
      type(faces_type), intent(in) :: faces
      !> The keys
      type(key_list), intent(inout) :: keys
      real(wp) :: largest

      largest = faces%values(hardness)
      call keys%real('largest_pressure', largest, 'MPa', &
         'pressure up to which the tolerance holds; the hardness unless given')
      call keys%follows(faces%keys(hardness))
      if (keys%given()) choice%largest_pressure = largest
      call declare_table(choice, keys)
      call keys%optional_real('stick_pressure', choice%stick_pressure, 'MPa', &
         'pressure of CalculiX'' stick slope; as loaded unless given')
   end subroutine declare_law_table

   !> Declare solver, contact, elements and results.
   pure subroutine declare_deck(choice, keys, mesh_size)
      !> Choices of the deck; the size of its mesh is a default
      type(deck_choice), intent(inout) :: choice
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Place of the key of the mesh's size
      integer, intent(out), optional :: mesh_size

      call keys%choice('solver', choice%solver, 'calculix abaqus', 'what the deck is for')
      call keys%choice('contact', choice%contact, 'uinter table hard', &
         'UINTER, the law as a table, or hard contact')
      call keys%real('mesh_size', choice%mesh_size, 'mm', 'edge of an element aimed at')
      if (present(mesh_size)) mesh_size = keys%last
      call keys%choice('element', choice%element, 'c3d8i c3d8 c3d8r', &
         'element; the paper''s C3D8R deforms without resistance in CalculiX')
      call keys%choice('field', choice%field, 'contact all', &
         'results of all nodes in every increment: displacement and contact, or also stress')
      call keys%real('penalty', choice%penalty, 'MPa/mm', &
         'pressure over penetration of hard contact in CalculiX')
      call keys%real('search_distance', choice%search_distance, 'mm', &
         'clearance below which CalculiX with UINTER has contact springs')
   end subroutine declare_deck

   !> One row for each part.
   pure subroutine fill_table(report, names, parts)
      !> The report
      type(report_type), intent(inout) :: report
      !> Names of the parts
      character(len=*), intent(in) :: names(:)
      !> The parts
      type(hex_mesh), intent(in) :: parts(:)
      integer :: i

      report%table = new_table(columns=4, rows=size(parts))
      associate (table => report%table)
         call table%add_texts('part', names)
         call table%add_codes('nodes', column_counts, [(size(parts(i)%nodes, 2), i=1, size(parts))])
         call table%add_codes('elements', column_counts, &
            [(size(parts(i)%elements, 2), i=1, size(parts))])
         call table%add_numbers('volume', 'mm^3', [(mesh_volume(parts(i)), i=1, size(parts))])
      end associate
      report%first_rows = [1, size(parts) + 1]
      allocate (report%important(size(parts)), source=.true.)
   end subroutine fill_table

end module asperity_program_commands_deck_parts
