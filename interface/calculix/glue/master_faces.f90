!> The master face of every spring. The solver searches it anew in every iteration: a slave node
!> near an edge may go from one face to the next and back without end, and one at the rim of the
!> whole surface may lose its spring and get it again. A spring of ours keeps its face as long as
!> its node leaves that by no more than a margin.
module asperity_calculix_master_faces
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: host, pair_of
   use asperity_calculix_faces, only: has_face, project_onto_face
   use asperity_calculix_interactions, only: find_interaction, interaction_type
   use asperity_calculix_kinematics, only: frame_at, frame_type
   implicit none
   private
   public :: keep_faces

   !> How far a node may be outside its face, in natural coordinates (a face is 2 long)
   real(wp), parameter, public :: margin = 0.1_wp
   !> Most nodes of a face of any spring
   integer, parameter :: most = 9

   ! CalculiX' routines have no argument that could carry it
   !> Nodes of the face of every slave node in the last iteration, zero for none
   integer, allocatable :: last_faces(:, :)
   !> The same at the start of the increment
   integer, allocatable :: start_faces(:, :)
   !> Area of the slave node when it last had a face
   real(wp), allocatable :: last_areas(:)
   !> Step, increment and number of cuts that the solver is in
   integer :: attempt(3) = -1

contains

   !> Put back the faces and springs that were left by no more than the margin, and remember all.
   subroutine keep_faces(now, first, last, free, ipkon, kon, lakon, ielmat, mi, islavnode, &
         materials, co, vold, springarea)
      !> Step, increment and number of cuts
      integer, intent(in) :: now(3)
      !> The first spring among the elements, and the last, which may change
      integer, intent(in) :: first
      integer, intent(inout) :: last
      !> Where the nodes of the first begin, and at the end where those of another would
      integer, intent(inout) :: free
      !> As in CalculiX
      integer, intent(inout) :: ipkon(*), kon(*)
      character(len=8), intent(inout) :: lakon(*)
      integer, intent(in) :: mi(*)
      integer, intent(inout) :: ielmat(mi(3), *)
      !> Slave nodes, as the springs count them
      integer, intent(in) :: islavnode(*)
      !> Material of every pair
      integer, intent(in) :: materials(:)
      real(wp), intent(in) :: co(3, *), vold(0:mi(2), *)
      !> Area of every slave node, and its penetration at the start; a spring that is put back has
      !> the area that it had
      real(wp), intent(inout) :: springarea(2, *)
      integer, allocatable :: faces(:, :)
      integer :: element, n, counter, nodes
      logical :: changed

      if (.not. any(host%serves)) return
      nodes = host%last_node(size(host%last_node))
      if (.not. allocated(last_faces)) then
         allocate (last_faces(most, nodes), source=0)
         allocate (last_areas(nodes), source=0.0_wp)
      end if
      if (any(now(:2) /= attempt(:2))) then
         start_faces = last_faces
      else if (now(3) /= attempt(3)) then
         last_faces = start_faces
      end if
      attempt = now
      allocate (faces(most, nodes), source=0)
      do element = first, last
         read (lakon(element)(8:8), '(i1)') n
         associate (nodes_of => kon(ipkon(element) + 1:ipkon(element) + n + 2))
            faces(:n, nodes_of(n + 2)) = nodes_of(:n)
         end associate
      end do

      changed = .false.
      do counter = 1, nodes
         if (.not. host%serves(pair_of(counter))) cycle
         associate (kept => last_faces(:, counter), face => faces(:, counter))
            if (any(face > 0)) last_areas(counter) = springarea(1, counter)
            if (all(face == 0)) then
               if (holds(kept)) then
                  face = kept
               else if (holds(start_faces(:, counter))) then
                  face = start_faces(:, counter)
               end if
               if (any(face > 0)) springarea(1, counter) = last_areas(counter)
               changed = changed .or. any(face > 0)
            else if (any(kept /= face) .and. count(face > 0) == count(kept > 0)) then
               if (holds(kept)) then
                  face = kept
                  changed = .true.
               end if
            end if
            kept = face
         end associate
      end do
      if (changed) call write_springs()

   contains

      !> Whether a face holds the slave node still, within reach of the interaction.
      logical function holds(face)
         integer, intent(in) :: face(most)
         type(interaction_type), pointer :: interaction
         type(frame_type) :: frame
         real(wp) :: positions(3, most), slave(3)
         integer :: i

         n = count(face > 0)
         holds = .false.
         if (.not. has_face(n)) return
         do i = 1, n
            positions(:, i) = co(:, face(i)) + vold(1:3, face(i))
         end do
         slave = co(:, islavnode(counter)) + vold(1:3, islavnode(counter))
         frame = frame_at(project_onto_face(positions(:, :n), slave))
         interaction => find_interaction(materials(pair_of(counter)))
         if (dot_product(slave - frame%point%position, frame%axes(:, 1)) &
            > interaction%search_distance) return
         holds = inside(frame%point%xi, n)
      end function holds

      !> Write all springs anew, in the order of their slave nodes, as the solver does.
      subroutine write_springs()
         integer :: i

         last = first - 1
         do i = 1, nodes
            n = count(faces(:, i) > 0)
            if (n == 0) cycle
            last = last + 1
            ipkon(last) = free
            lakon(last) = 'ESPRNGC'//achar(iachar('0') + n)
            ielmat(1, last) = materials(pair_of(i))
            kon(free + 1:free + n) = faces(:n, i)
            kon(free + n + 1:free + n + 2) = [islavnode(i), i]
            free = free + n + 2
         end do
      end subroutine write_springs

   end subroutine keep_faces

   !> Whether a point is inside a face, or outside by no more than the margin.
   pure logical function inside(xi, nodes)
      !> Natural coordinates
      real(wp), intent(in) :: xi(2)
      !> Number of nodes
      integer, intent(in) :: nodes

      if (nodes == 3 .or. nodes == 6) then
         inside = all(xi > -0.5_wp*margin) .and. sum(xi) < 1.0_wp + 0.5_wp*margin
      else
         inside = all(abs(xi) < 1.0_wp + margin)
      end if
   end function inside

end module asperity_calculix_master_faces
