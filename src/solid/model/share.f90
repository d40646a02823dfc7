!> What of a joint each rank works on: elements and slave faces in parts of like weight and short
!> borders, equations with their nodes.
!>
!> A slave face is parted as one more brick, between it and the master facet that it is nearest to:
!> borders then do not run through contact, where ranks would have to exchange what they find and
!> multigrid's smoothing would not see both sides.
module asperity_solid_model_share
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_contact_pair, only: contact_pair
   use asperity_solid_engine_metis, only: part_mesh
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: solid_model
   implicit none
   private
   public :: share_work

   !> What an element and a slave face weigh: as the entries that they bring into the matrix, whose
   !> equations take nearly all of the time
   integer, parameter :: of_element = 2, of_face = 6

contains

   !> Give each rank its share, all to a rank that is alone. Equations are numbered anew, so that
   !> those of a rank follow each other. `error` is set when there are more ranks than elements.
   subroutine share_work(model, ranks, error)
      !> The joint, which is all this rank's
      type(solid_model), intent(inout) :: model
      !> The ranks
      type(rank_team), intent(in) :: ranks
      !> Set when the joint cannot be shared
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: bricks(:, :), parts(:), nodes(:), weights(:)
      integer :: i, j, n, first

      n = size(model%mesh%elements, 2)
      if (ranks%size == 1) then
         model%own_elements = [(i, i=1, n)]
         allocate (model%first_rows(0:1), source=[0, model%n_unknowns])
         return
      end if
      if (ranks%size > n) then
         call fatal_error(error, to_text(ranks%size)//' ranks are more than the '//to_text(n)// &
            ' elements of the mesh: start at most '//to_text(n)//', or take a smaller mesh_size')
         return
      end if
      allocate (weights(n), source=of_element)
      bricks = model%mesh%elements
      do i = 1, size(model%pairs)
         bricks = append(bricks, bricks_between(model%pairs(i), model%mesh%nodes))
         weights = [weights, (of_face, j=1, size(model%pairs(i)%faces))]
      end do
      call part_mesh(bricks, size(model%mesh%nodes, 2), weights, ranks%size, parts, nodes, error)
      call ranks%agree(error)
      if (allocated(error)) return
      call take_first(parts)
      call take_first(nodes)
      model%own_elements = pack([(i, i=1, n)], parts(:n) == ranks%rank)
      first = n
      do i = 1, size(model%pairs)
         associate (pair => model%pairs(i))
            pair%own = pack([(j, j=1, size(pair%faces))], &
               parts(first + 1:first + size(pair%faces)) == ranks%rank)
            first = first + size(pair%faces)
         end associate
      end do
      call order_equations(model, nodes, ranks%size)

   contains

      !> METIS of another machine might part otherwise.
      subroutine take_first(parts)
         integer, intent(inout) :: parts(:)
         real(wp), allocatable :: values(:)

         allocate (values, source=real(parts, wp))
         call ranks%take_first(values)
         parts = nint(values)
      end subroutine take_first

   end subroutine share_work

   !> Nodes of each slave face of a pair and of the master facet with the nearest middle.
   pure function bricks_between(pair, places) result(bricks)
      type(contact_pair), intent(in) :: pair
      real(wp), intent(in) :: places(:, :)
      integer :: bricks(8, size(pair%faces))
      real(wp) :: middles(3, size(pair%master%facets, 2))
      integer :: i

      associate (facets => pair%master%facets)
         do i = 1, size(facets, 2)
            middles(:, i) = middle(facets(:, i))
         end do
         do i = 1, size(pair%faces)
            associate (corners => pair%faces(i)%nodes(:4))
               bricks(:4, i) = corners
               bricks(5:, i) = facets(:, minloc(sum((middles - spread(middle(corners), 2, &
                  size(middles, 2)))**2, 1), 1))
            end associate
         end do
      end associate

   contains

      pure function middle(corners)
         integer, intent(in) :: corners(4)
         real(wp) :: middle(3)

         middle = 0.25_wp*sum(places(:, corners), 2)
      end function middle

   end function bricks_between

   !> Two lists of bricks as one.
   pure function append(first, second) result(both)
      integer, intent(in) :: first(:, :), second(:, :)
      integer :: both(size(first, 1), size(first, 2) + size(second, 2))

      both(:, :size(first, 2)) = first
      both(:, size(first, 2) + 1:) = second
   end function append

   !> Number the equations rank by rank.
   pure subroutine order_equations(model, part_of_node, ranks)
      type(solid_model), intent(inout) :: model
      integer, intent(in) :: part_of_node(:), ranks
      integer :: part_of_equation(model%n_unknowns), new(model%n_unknowns), i, j, rank, n

      part_of_equation = -1
      do j = 1, size(part_of_node)
         do i = 1, 3
            associate (number => model%numbers(i, j))
               if (number < 1) cycle
               ! an equation of several nodes goes with the first
               if (part_of_equation(number) < 0) part_of_equation(number) = part_of_node(j)
            end associate
         end do
      end do
      allocate (model%first_rows(0:ranks))
      n = 0
      do rank = 0, ranks - 1
         model%first_rows(rank) = n
         do i = 1, model%n_unknowns
            if (part_of_equation(i) /= rank) cycle
            n = n + 1
            new(i) = n
         end do
      end do
      model%first_rows(ranks) = n
      do j = 1, size(part_of_node)
         do i = 1, 3
            if (model%numbers(i, j) > 0) model%numbers(i, j) = new(model%numbers(i, j))
         end do
      end do
   end subroutine order_equations

end module asperity_solid_model_share
