!> The text of the shear test's deck.
module asperity_deck_shear_text
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_banner, only: write_head
   use asperity_deck_cards_interaction, only: write_interaction, write_pair
   use asperity_deck_cards_load_steps, only: close_step, open_step, step_type, write_boundary
   use asperity_deck_cards_mesh_writer, only: model_writer
   use asperity_deck_cards_wood_cards, only: check_criterion, write_axes, write_wood
   use asperity_deck_mesh_hexahedra, only: faces_in_box, hex_mesh, nodes_in_box
   use asperity_deck_options, only: element_kind
   use asperity_deck_shear_deck, only: shear_deck
   use asperity_replay_steps, only: fewest_steps
   implicit none
   private
   public :: write_shear_deck

   real(wp), parameter :: far = huge(1.0_wp)
   character(len=*), parameter :: force_sets(2) = [character(len=6) :: 'BOTTOM', 'TOP']
   character(len=*), parameter :: gauges(4) = [character(len=12) :: 'BOTTOM', 'CAP', &
      'LOWER_MIDDLE', 'UPPER_MIDDLE']

contains

   !> The text of the deck.
   pure subroutine write_shear_deck(model, text, error)
      !> The model
      type(shear_deck), intent(in) :: model
      !> The deck
      character(len=:), allocatable, intent(out) :: text
      !> Set when the solver has no card for the wood, or when there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      type(model_writer) :: deck

      call check_criterion(model%choice, model%wood, error)
      if (allocated(error)) return
      call write_words(deck, model)
      call write_parts(deck, model)
      call write_supports(deck, model)
      call write_steps(deck, model)
      call deck%take(text, error)
   end subroutine write_shear_deck

   !> What the model is, and what of it is chosen.
   pure subroutine write_words(deck, model)
      type(model_writer), intent(inout) :: deck
      type(shear_deck), intent(in) :: model

      call write_head(deck, model%choice, 'Direct shear test of two discs of wood')
      call deck%comment('Two discs, one upon the other; z points up, the lower one moves along '// &
         'x. Diameter, height, normal stress, speed: the paper''s, or the case''s. Edges are '// &
         'about '// &
         to_text(model%choice%mesh_size, 4)//' mm long; the rim is placed so that the area is '// &
         'that of the circle.')
      call deck%comment('Chosen, as the paper does not say it:')
      call deck%comment('- The boxes: the upper face of the upper disc is held in x and y and '// &
         'stays level, as under a cap that cannot tilt (*EQUATION); the lower face of the '// &
         'lower disc moves as a whole. The sides are free.')
      if (model%upper_on_end) then
         call deck%comment('- The grain: of the upper disc along z, so that its cross section '// &
            'is in contact; of the lower disc along x, tangential section in contact (R along z).')
      else
         call deck%comment('- The grain: of both discs along x, tangential sections in contact '// &
            '(R along z).')
      end if
      call deck%comment('- The start: the meshes overlap by '//to_text(model%overclosure, 6)// &
         ' mm, which is the overclosure at which contact carries the normal stress. A gap '// &
         'closed by a load would have no stiffness at first, and no solver would find the end '// &
         'of it. The first step is one increment, from which on CalculiX counts all of the '// &
         'overlap.')
      call deck%comment('The upper face is the slave. Where its nodes pass the rim of the '// &
         'lower disc they lose their contact: the overlap shrinks as in the test, by whole nodes.')
      call deck%comment('For interface/calculix/run:')
      call deck%line('** load: set BOTTOM, direction 1')
   end subroutine write_words

   !> Meshes, wood, surfaces, contact.
   pure subroutine write_parts(deck, model)
      type(model_writer), intent(inout) :: deck
      type(shear_deck), intent(in) :: model
      real(wp), parameter :: x(3) = [1.0_wp, 0.0_wp, 0.0_wp], z(3) = [0.0_wp, 0.0_wp, 1.0_wp]
      character(len=:), allocatable :: kind
      integer :: nodes, elements

      kind = element_kind(model%choice)
      nodes = size(model%lower%nodes, 2)
      elements = size(model%lower%elements, 2)
      call deck%heading('meshes')
      call deck%nodes(model%lower, 0, 'LOWER_NODES')
      call deck%elements(model%lower, 0, 0, kind, 'LOWER')
      call deck%nodes(model%upper, nodes, 'UPPER_NODES')
      call deck%elements(model%upper, elements, nodes, kind, 'UPPER')

      call deck%heading('wood; 1 = L, 2 = R, 3 = T')
      call write_axes(deck, 'LOWER_AXES', x, z)
      if (model%upper_on_end) then
         call write_axes(deck, 'UPPER_AXES', z, x)
      else
         call write_axes(deck, 'UPPER_AXES', x, z)
      end if
      call write_wood(deck, model%choice, model%wood, 'LOWER_WOOD', .false.)
      call write_wood(deck, model%choice, model%wood, 'UPPER_WOOD', model%upper_on_end)
      call deck%section('LOWER', 'LOWER_WOOD', 'LOWER_AXES')
      call deck%section('UPPER', 'UPPER_WOOD', 'UPPER_AXES')

      call deck%heading('contact')
      call deck%surface('LOWER_FACE', faces_at(model%lower, 0.0_wp, 0))
      call deck%surface('UPPER_FACE', faces_at(model%upper, -model%overclosure, elements))
      call deck%surface('CAP_FACE', faces_at(model%upper, top_of(model%upper), elements))
      call write_interaction(deck, model%choice, model%contact)
      call write_pair(deck, model%contact, 'UPPER_FACE', 'LOWER_FACE')
   end subroutine write_parts

   !> Element and number of the faces of a part at a height.
   pure function faces_at(mesh, height, element_offset) result(faces)
      type(hex_mesh), intent(in) :: mesh
      !> Height, mm
      real(wp), intent(in) :: height
      !> Number of the element before the first
      integer, intent(in) :: element_offset
      integer, allocatable :: faces(:, :)

      call faces_in_box(mesh, [-far, -far, height], [far, far, height], faces)
      faces(1, :) = element_offset + faces(1, :)
   end function faces_at

   !> Height of the upper face of a part, mm.
   pure real(wp) function top_of(mesh)
      type(hex_mesh), intent(in) :: mesh

      top_of = maxval(mesh%nodes(3, :))
   end function top_of

   !> Sets of nodes, and what holds them.
   pure subroutine write_supports(deck, model)
      type(model_writer), intent(inout) :: deck
      type(shear_deck), intent(in) :: model
      integer, allocatable :: bottom(:), top(:)
      integer :: nodes, cap

      nodes = size(model%lower%nodes, 2)
      call deck%heading('supports')
      call nodes_at(model%lower, minval(model%lower%nodes(3, :)), bottom)
      call nodes_at(model%upper, top_of(model%upper), top)
      cap = middle_of(model%upper, top)
      call deck%node_set('BOTTOM', bottom)
      call deck%node_set('TOP', nodes + top)
      call deck%node_set('CAP', [nodes + cap])
      call nodes_at(model%lower, 0.0_wp, bottom)
      call deck%node_set('LOWER_MIDDLE', [middle_of(model%lower, bottom)])
      call nodes_at(model%upper, -model%overclosure, bottom)
      call deck%node_set('UPPER_MIDDLE', [nodes + middle_of(model%upper, bottom)])
      call deck%comment('The cap stays level: its nodes go down as CAP does.')
      call deck%level(nodes + top, nodes + cap, 3)
      call write_boundary(deck, 'BOTTOM', 1, 0.0_wp)
      call write_boundary(deck, 'BOTTOM', 2, 0.0_wp)
      call write_boundary(deck, 'BOTTOM', 3, 0.0_wp)
      call write_boundary(deck, 'TOP', 1, 0.0_wp)
      call write_boundary(deck, 'TOP', 2, 0.0_wp)
   end subroutine write_supports

   !> Nodes of a part at a height.
   pure subroutine nodes_at(mesh, height, found)
      type(hex_mesh), intent(in) :: mesh
      real(wp), intent(in) :: height
      integer, allocatable, intent(out) :: found(:)

      call nodes_in_box(mesh, [-far, -far, height], [far, far, height], found)
   end subroutine nodes_at

   !> The node nearest to the axis.
   pure integer function middle_of(mesh, among)
      type(hex_mesh), intent(in) :: mesh
      integer, intent(in) :: among(:)

      middle_of = among(minloc(mesh%nodes(1, among)**2 + mesh%nodes(2, among)**2, 1))
   end function middle_of

   !> Press, then a step for each way of the lower box.
   pure subroutine write_steps(deck, model)
      type(model_writer), intent(inout) :: deck
      type(shear_deck), intent(in) :: model
      type(step_type) :: step
      real(wp) :: from, way
      integer :: i

      call deck%heading('press')
      step%name = 'PRESS'
      step%direct = .true.
      call open_step(deck, model%choice, step)
      call deck%line('*DSLOAD')
      call deck%line('CAP_FACE, P, '//to_text(model%settings%normal_stress))
      call close_step(deck, model%choice, model%wood%criterion /= 'none', force_sets, gauges)
      from = 0.0_wp
      do i = 1, size(model%settings%displacement)
         associate (to => model%settings%displacement(i), s => model%settings)
            way = abs(to - from)
            if (.not. way > 0.0_wp) cycle
            call deck%heading('shear from '//to_text(from, 6)//' to '//to_text(to, 6)//' mm')
            step%name = 'SHEAR_'//to_text(i)
            step%direct = .false.
            step%period = 60.0_wp*way/s%rate
            step%largest = step%period/fewest_steps(way, s%displacement_increment)
            step%first = step%largest
            call open_step(deck, model%choice, step)
            call write_boundary(deck, 'BOTTOM', 1, to)
            call close_step(deck, model%choice, model%wood%criterion /= 'none', force_sets, gauges)
            from = to
         end associate
      end do
   end subroutine write_steps

end module asperity_deck_shear_text
