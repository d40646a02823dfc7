!> Rays of the samples of a face: gaps, coverage and slip of its cells.
module asperity_solid_contact_rays
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_face, only: contact_face, meet_facet
   use asperity_solid_contact_geometry_coverage, only: find_coverage
   use asperity_solid_contact_geometry_facet, only: facet_shape
   use asperity_solid_contact_geometry_surface, only: contact_surface, nearest_facet, project
   implicit none
   private
   public :: find_middles, start_rays, follow_rays, meet_facets

contains

   !> Rays from the middles of the cells, at the start of an increment: from where they were at the
   !> end of the one before.
   pure subroutine find_middles(face, master, positions)
      !> The face, its normal known
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      real(wp) :: x(3, 4)
      integer :: i, near

      x = positions(:, face%nodes(:4))
      near = 0
      if (any(face%cells%middle%start_facet == 0)) &
         near = nearest_facet(master, positions, 0.25_wp*sum(x, 2), face%normal)
      do i = 1, size(face%cells)
         associate (middle => face%cells(i)%middle)
            if (middle%start_facet == 0) middle%start_facet = near
            middle%facet = middle%start_facet
            middle%ray%natural = middle%start_natural
            call project(master, positions, matmul(x, middle%shape), face%normal, &
               middle%facet, middle%ray)
         end associate
      end do
   end subroutine find_middles

   !> Rays from the samples of a face just cut: where they end, slip begins.
   pure subroutine start_rays(face, master, positions)
      !> The face
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      integer :: i

      face%samples%facet = face%samples%start_facet
      face%samples%start_facet = 0
      call follow_rays(face, master, positions)
      do i = 1, size(face%samples)
         associate (sample => face%samples(i))
            sample%start_facet = merge(sample%facet, 0, sample%ray%usable)
            sample%start_natural = sample%ray%natural
         end associate
      end do
   end subroutine start_rays

   !> Gaps, slip and coverage of all cells, from rays that go on from where they are.
   pure subroutine follow_rays(face, master, positions)
      !> The face
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      real(wp) :: x(3, 4), corners(3, 4), from(3), way(3)
      logical :: usable
      integer :: i, j

      x = positions(:, face%nodes(:4))
      do i = 1, size(face%cells)
         associate (cell => face%cells(i))
            cell%gap = 0.0_wp
            cell%slip_increment = 0.0_wp
            usable = .true.
            do j = cell%first, cell%last
               associate (sample => face%samples(j))
                  from = matmul(x, sample%shape)
                  call project(master, positions, from, face%normal, sample%facet, sample%ray)
                  usable = usable .and. sample%ray%usable
                  cell%gap = cell%gap + sample%weight*sample%ray%gap
                  if (sample%start_facet == 0) cycle
                  corners = positions(:, master%facets(:, sample%start_facet))
                  way = from - matmul(corners, facet_shape(sample%start_natural))
                  cell%slip_increment = cell%slip_increment &
                     + sample%weight*matmul(way, face%tangents)
               end associate
            end do
            if (cell%first == cell%last) then
               ! the sample is the middle
               cell%middle%facet = face%samples(cell%first)%facet
               cell%middle%ray = face%samples(cell%first)%ray
            else
               call project(master, positions, matmul(x, cell%middle%shape), face%normal, &
                  cell%middle%facet, cell%middle%ray)
            end if
            cell%coverage = 0.0_wp
            cell%coverage_gradient = 0.0_wp
            if (usable .and. cell%middle%ray%usable) call find_coverage(master, &
               cell%middle%facet, cell%middle%ray%natural, cell%edges, cell%coverage, &
               cell%coverage_gradient)
         end associate
      end do
   end subroutine follow_rays

   !> Let a face meet the facets of a cell near contact, or in it.
   pure subroutine meet_facets(face, number, master, search_distance, has_grown)
      !> The face
      type(contact_face), intent(inout) :: face
      !> Number of the cell
      integer, intent(in) :: number
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> Gap up to which a facet opposite is met before it is touched, mm
      real(wp), intent(in) :: search_distance
      !> Set to true when a facet was new
      logical, intent(inout) :: has_grown
      integer :: j

      associate (cell => face%cells(number))
         if (cell%coverage <= 0.0_wp) return
         ! the pressure of the start as well, which a run that goes on from a checkpoint has
         if (cell%gap > search_distance &
            .and. .not. max(cell%trial%traction(1), cell%start%pressure) > 0.0_wp) return
         call meet_facet(face, master, cell%middle%facet, has_grown)
         do j = cell%first, cell%last
            call meet_facet(face, master, face%samples(j)%facet, has_grown)
            call meet_facet(face, master, face%samples(j)%start_facet, has_grown)
         end do
      end associate
   end subroutine meet_facets

end module asperity_solid_contact_rays
