!> What of a joint each rank works on: elements in parts of like weight and short borders, slave
!> faces with the element behind them, equations with their nodes.
module asperity_solid_model_share
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_engine_metis, only: part_mesh
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: solid_model
   implicit none
   private
   public :: share_work

   !> What an element weighs, and how much more one with a slave face: as the times they take
   integer, parameter :: of_element = 2, of_face = 4

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
      integer, allocatable :: elements(:), nodes(:), element_behind(:)
      integer :: weights(size(model%mesh%elements, 2)), i, j, n

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
      weights = of_element
      do i = 1, size(model%pairs)
         call find_elements_behind(model, i, element_behind)
         weights(element_behind) = weights(element_behind) + of_face
      end do
      call part_mesh(model%mesh%elements, size(model%mesh%nodes, 2), weights, ranks%size, &
         elements, nodes, error)
      call ranks%agree(error)
      if (allocated(error)) return
      call take_first(elements)
      call take_first(nodes)
      model%own_elements = pack([(i, i=1, n)], elements == ranks%rank)
      do i = 1, size(model%pairs)
         call find_elements_behind(model, i, element_behind)
         associate (pair => model%pairs(i))
            pair%own = pack([(j, j=1, size(pair%faces))], elements(element_behind) == ranks%rank)
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

   !> The element of each slave face of a pair.
   pure subroutine find_elements_behind(model, pair, elements)
      type(solid_model), intent(in) :: model
      integer, intent(in) :: pair
      integer, allocatable, intent(out) :: elements(:)
      integer, allocatable :: face_at(:, :)
      integer :: i, j, k

      ! a facet has one corner that it is looked for at: up to four facets have the same
      allocate (face_at(4, size(model%mesh%nodes, 2)), source=0)
      associate (faces => model%pairs(pair)%faces)
         do i = 1, size(faces)
            associate (at => face_at(:, faces(i)%nodes(1)))
               at(findloc(at, 0, 1)) = i
            end associate
         end do
         allocate (elements(size(faces)), source=1)
         do i = 1, size(model%mesh%elements, 2)
            associate (nodes => model%mesh%elements(:, i))
               do j = 1, 8
                  do k = 1, 4
                     if (face_at(k, nodes(j)) == 0) exit
                     if (is_within(faces(face_at(k, nodes(j)))%nodes(:4), nodes)) &
                        elements(face_at(k, nodes(j))) = i
                  end do
               end do
            end associate
         end do
      end associate
   end subroutine find_elements_behind

   !> Whether an element has all corners of a facet.
   pure logical function is_within(facet, nodes)
      integer, intent(in) :: facet(4), nodes(8)
      integer :: i

      is_within = .true.
      do i = 1, 4
         is_within = is_within .and. any(nodes == facet(i))
      end do
   end function is_within

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
