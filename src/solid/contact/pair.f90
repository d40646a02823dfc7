!> A pair of surfaces in contact, integrated on the faces of the slave. Each face has cells, of
!> which each is one contact point; rays along the face's normal find the master surface.
module asperity_solid_contact_pair
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: is_closed, status_unset
   use asperity_solid_contact_cell, only: contact_cell, motion_of
   use asperity_solid_contact_cut, only: cut_face
   use asperity_solid_contact_energy, only: add_increment, contact_energy, recut_energy
   use asperity_solid_contact_face, only: contact_face, freeze_axes, keep_facets, met_facets, &
      new_contact_face, surround_facet
   use asperity_solid_contact_geometry_surface, only: contact_surface, new_contact_surface
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_motions, only: add_motions, contact_motions
   use asperity_solid_contact_rays, only: find_middles, meet_facets, start_rays
   implicit none
   private
   public :: contact_pair, new_contact_pair, begin_increment, update_cell, accept, &
      foresee_pattern, forget_pattern

   !> Cells along each edge of a slave facet by default
   integer, parameter, public :: default_cells = 3
   !> More than this makes no sense
   integer, parameter :: most_cells = 100
   !> Gap up to which master facets are met before they are touched by default, mm
   real(wp), parameter, public :: default_search_distance = 3.0_wp

   !> Slave faces against a master surface.
   type :: contact_pair
      !> What it is called in results
      character(len=8) :: name = ''
      !> One for each slave facet
      type(contact_face), allocatable :: faces(:)
      !> Those that this process follows: all, unless other ranks have some
      integer, allocatable :: own(:)
      !> The other side
      type(contact_surface) :: master
      !> What happens at each point
      class(solid_law), allocatable :: law
      !> Gap up to which master facets are met before they are touched, mm
      real(wp) :: search_distance = default_search_distance
      !> Whether a face's `nodes` have grown since the caller reset this
      logical :: has_grown = .false.
      !> Energies at the last accepted increment
      type(contact_energy) :: energy
      !> How its cells have moved since the start, where that is kept
      type(contact_motions), allocatable :: motions
   end type contact_pair

contains

   !> Build a pair from undeformed surfaces. `error` is set when a surface has no facets or a
   !> degenerate one, or for a number of cells that is not between 1 and 100.
   subroutine new_contact_pair(pair, name, positions, slave_facets, master_facets, cells, law, &
         error)
      !> Result
      type(contact_pair), intent(out) :: pair
      !> What it is called in results
      character(len=*), intent(in) :: name
      !> Undeformed places of all nodes of the model, mm
      real(wp), intent(in) :: positions(:, :)
      !> Corners of the facets of both sides, counter-clockwise seen from outside
      integer, intent(in) :: slave_facets(:, :), master_facets(:, :)
      !> Cells along each edge of a slave facet
      integer, intent(in) :: cells
      !> What happens at each point
      class(solid_law), intent(in) :: law
      !> Set when the pair is refused
      type(error_type), allocatable, intent(out) :: error
      type(contact_surface) :: slave
      integer :: i

      pair%name = name
      if (cells < 1 .or. cells > most_cells) then
         call fatal_error(error, 'contact cells = '//to_text(cells)//' is not allowed: along '// &
            'an edge of a facet there are 1 to '//to_text(most_cells))
         return
      end if
      call new_contact_surface(slave, 'slave surface of '//trim(name), positions, slave_facets, &
         error)
      if (.not. allocated(error)) call new_contact_surface(pair%master, 'master surface of '// &
         trim(name), positions, master_facets, error)
      if (allocated(error)) return
      allocate (pair%law, source=law)
      allocate (pair%faces(size(slave_facets, 2)))
      pair%own = [(i, i=1, size(pair%faces))]
      do i = 1, size(pair%faces)
         call new_contact_face(pair%faces(i), positions, slave_facets(:, i), cells)
      end do
   end subroutine new_contact_pair

   !> Freeze normals and tangents, cut the cells by the master facets, and start the rays. An
   !> increment that is cut back begins anew by this too. A point that was never seen takes the
   !> state that the law gives where it is.
   subroutine begin_increment(pair, positions, error)
      !> The pair
      type(contact_pair), intent(inout) :: pair
      !> Places of all nodes at the start, mm
      real(wp), intent(in) :: positions(:, :)
      !> Set when the law fails
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j

      if (allocated(pair%motions)) pair%motions%is_under_way = .true.
      do i = 1, size(pair%faces)
         call freeze_axes(pair%faces(i), positions)
      end do
      do i = 1, size(pair%own)
         associate (face => pair%faces(pair%own(i)))
            call find_middles(face, pair%master, positions)
            call cut_face(face, pair%master, positions)
            call start_rays(face, pair%master, positions)
            do j = 1, size(face%cells)
               associate (cell => face%cells(j))
                  cell%start_coverage = cell%coverage
                  if (cell%start%status == status_unset) then
                     call update_cell(pair%law, cell, error)
                     if (allocated(error)) return
                     call take_first_state(pair%energy, cell)
                  end if
                  cell%recut_energy = recut_energy(cell)
               end associate
               call meet_facets(face, j, pair%master, pair%search_distance, pair%has_grown)
            end do
         end associate
      end do
      if (.not. allocated(pair%motions)) return
      ! that which gave the first states
      if (pair%motions%increments == 0) call add_motions(pair%motions, pair%faces)
   end subroutine begin_increment

   !> Traction of a cell at its gap, slip and coverage. One without coverage has nothing opposite.
   subroutine update_cell(law, cell, error)
      !> The law
      class(solid_law), intent(inout) :: law
      !> The cell
      type(contact_cell), intent(inout) :: cell
      !> Set when the law fails
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: motion(3)

      motion = motion_of(cell)
      call law%update(cell%start, motion(1), motion(2:), cell%trial, error)
   end subroutine update_cell

   !> The first state of a cell, with the energy of its overclosure.
   pure subroutine take_first_state(energy, cell)
      type(contact_energy), intent(inout) :: energy
      type(contact_cell), intent(inout) :: cell
      real(wp) :: stored

      cell%start = cell%trial%state
      cell%last_coverage = cell%coverage
      stored = cell%area*cell%coverage*cell%trial%normal_energy
      energy%normal = energy%normal + stored
      energy%edge = energy%edge - stored
   end subroutine take_first_state

   !> The last trial of every cell is the start of what follows.
   pure subroutine accept(pair)
      !> The pair
      type(contact_pair), intent(inout) :: pair
      integer :: i, j

      pair%energy%normal = 0.0_wp
      pair%energy%tangential = 0.0_wp
      do i = 1, size(pair%own)
         do j = 1, size(pair%faces(pair%own(i))%cells)
            associate (cell => pair%faces(pair%own(i))%cells(j))
               call add_increment(pair%energy, cell)
               cell%recut_energy = 0.0_wp
               cell%start = cell%trial%state
               cell%start_tangential_energy = cell%trial%tangential_energy
               cell%last_coverage = cell%coverage
               if (is_closed(cell%start)) cell%slip = cell%slip + cell%slip_increment
               cell%middle%start_facet = cell%middle%facet
               cell%middle%start_natural = cell%middle%ray%natural
            end associate
         end do
      end do
      if (.not. allocated(pair%motions)) return
      pair%motions%is_under_way = .false.
      call add_motions(pair%motions, pair%faces)
   end subroutine accept

   !> Add what is around the facets met, when a pattern is made anyway: the next increments then
   !> find it as they need it.
   pure subroutine foresee_pattern(pair)
      !> The pair
      type(contact_pair), intent(inout) :: pair
      integer, allocatable :: met(:)
      integer :: i, j

      do i = 1, size(pair%own)
         associate (face => pair%faces(pair%own(i)))
            met = met_facets(face)
            do j = 1, size(met)
               call surround_facet(face, pair%master, met(j), pair%has_grown)
            end do
         end associate
      end do
   end subroutine foresee_pattern

   !> Forget the nodes that were not met since this was done last, before a new pattern of the
   !> matrix. The next increments meet those they need.
   pure subroutine forget_pattern(pair)
      !> The pair
      type(contact_pair), intent(inout) :: pair
      integer :: i

      do i = 1, size(pair%faces)
         call keep_facets(pair%faces(i), pair%master, met_facets(pair%faces(i)))
         pair%faces(i)%is_met = .false.
      end do
      pair%has_grown = .true.
   end subroutine forget_pattern

end module asperity_solid_contact_pair
