!> The master face of every spring. The solver searches it anew in every iteration, and a slave node
!> near an edge may go from one face to the next and back without end. A spring of ours keeps its
!> face as long as its node leaves that by no more than a margin.
module calculix_masters
   use asperity_kinds, only: wp
   use calculix_faces, only: face_point, has_face, most_nodes, project_onto_face
   use calculix_host, only: host, pair_of
   implicit none
   private
   public :: keep_faces

   !> How far a node may be outside its face, in natural coordinates (a face is 2 long)
   real(wp), parameter, public :: margin = 0.1_wp

   ! CalculiX' routines have no argument that could carry it
   !> Nodes of the last face of every slave node, zero for none
   integer, allocatable :: last_faces(:, :)

contains

   !> Put back the faces that were left by no more than the margin, and remember all.
   subroutine keep_faces(first, last, ipkon, kon, lakon, nodes, co, vold, mi)
      !> The springs among the elements
      integer, intent(in) :: first, last
      !> As in CalculiX
      integer, intent(in) :: ipkon(*), mi(*)
      integer, intent(inout) :: kon(*)
      character(len=8), intent(in) :: lakon(*)
      real(wp), intent(in) :: co(3, *), vold(0:mi(2), *)
      !> Number of slave nodes of all pairs
      integer, intent(in) :: nodes
      real(wp) :: positions(3, most_nodes + 1)
      integer :: element, n, base, counter, slave, face(most_nodes), i
      logical :: seen(nodes)

      if (.not. any(host%serves)) return
      if (.not. allocated(last_faces)) allocate (last_faces(most_nodes, nodes), source=0)
      seen = .false.
      do element = first, last
         if (lakon(element)(7:7) /= 'C') cycle
         read (lakon(element)(8:8), '(i1)') n
         if (.not. has_face(n)) cycle
         base = ipkon(element)
         slave = kon(base + n + 1)
         counter = kon(base + n + 2)
         if (.not. host%serves(pair_of(counter))) cycle
         seen(counter) = .true.
         face = 0
         face(:n) = kon(base + 1:base + n)
         associate (kept => last_faces(:, counter))
            if (count(kept > 0) == n .and. any(kept /= face)) then
               do i = 1, n
                  positions(:, i) = co(:, kept(i)) + vold(1:3, kept(i))
               end do
               if (holds(positions(:, :n), co(:, slave) + vold(1:3, slave))) then
                  kon(base + 1:base + n) = kept(:n)
                  cycle
               end if
            end if
            kept = face
         end associate
      end do
      do counter = 1, nodes
         if (.not. seen(counter)) last_faces(:, counter) = 0
      end do
   end subroutine keep_faces

   !> Whether a face still holds a position.
   pure logical function holds(nodes, position)
      real(wp), intent(in) :: nodes(:, :), position(3)
      type(face_point) :: point

      point = project_onto_face(nodes, position)
      if (size(nodes, 2) == 3 .or. size(nodes, 2) == 6) then
         holds = all(point%xi > -0.5_wp*margin) .and. sum(point%xi) < 1.0_wp + 0.5_wp*margin
      else
         holds = all(abs(point%xi) < 1.0_wp + margin)
      end if
   end function holds

end module calculix_masters
