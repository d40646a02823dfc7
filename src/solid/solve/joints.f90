!> What is told of every joint of a frame.
module asperity_solid_solve_joints
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_pair, only: contact_pair
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: solid_model
   implicit none
   private
   public :: joint_record, find_joint_records

   !> One joint after an increment; forces and energies are those of the whole joint.
   type :: joint_record
      !> Rotation of the beam against the column, from x to z, rad, and moment of the beam's contact
      !> on the column about the joint's middle, in the same sense, N mm
      real(wp) :: rotation = 0.0_wp, moment = 0.0_wp
      !> Force of the beam on the column along x and z, N
      real(wp) :: force(2) = 0.0_wp
      !> Largest pressure, MPa; energy lost to friction, J
      real(wp) :: largest_pressure = 0.0_wp, friction_energy = 0.0_wp
   end type joint_record

contains

   !> Records of the joints of all ranks.
   subroutine find_joint_records(records, model, displacement, ranks)
      !> One for each joint; none of a single joint
      type(joint_record), allocatable, intent(out) :: records(:)
      !> The frame, and its displacements, mm
      type(solid_model), intent(in) :: model
      real(wp), intent(in) :: displacement(:, :)
      !> The ranks, each with its faces
      type(rank_team), intent(in) :: ranks
      real(wp), parameter :: halves = 2.0_wp, joule = 1.0e3_wp
      real(wp), allocatable :: positions(:, :), sums(:, :), largest(:)
      integer :: i, joint, n

      n = 0
      if (allocated(model%mesh%joints)) n = size(model%mesh%joints)
      allocate (records(n))
      if (n == 0) return
      allocate (sums(4, n), largest(n), source=0.0_wp)
      allocate (positions, source=model%mesh%nodes + displacement)
      do i = 1, size(model%pairs)
         joint = (i - 1)/model%pairs_of_joint + 1
         associate (nodes => model%mesh%joints(joint)%column_nodes)
            call add_pair(sums(:, joint), largest(joint), model%pairs(i), positions, &
               sum(positions(:, nodes), 2)/size(nodes))
         end associate
      end do
      call ranks%sum(sums)
      call ranks%maximum(largest)
      do i = 1, n
         associate (nodes => model%mesh%joints(i))
            records(i) = joint_record(rotation_of(nodes%beam_nodes) &
               - rotation_of(nodes%column_nodes), halves*sums(1, i), halves*sums(2:3, i), &
               largest(i), halves*sums(4, i)/joule)
         end associate
      end do

   contains

      !> Turn of some nodes from x to z, that which fits best, rad.
      pure real(wp) function rotation_of(nodes) result(turn)
         integer, intent(in) :: nodes(:)
         real(wp) :: before(3, size(nodes)), now(3, size(nodes))

         before = model%mesh%nodes(:, nodes)
         before = before - spread(sum(before, 2)/size(nodes), 2, size(nodes))
         now = positions(:, nodes)
         turn = atan2(sum(before(1, :)*now(3, :) - before(3, :)*now(1, :)), &
            sum(before(1, :)*now(1, :) + before(3, :)*now(3, :)))
      end function rotation_of

   end subroutine find_joint_records

   !> Moment, forces and friction of this rank's faces of a pair.
   pure subroutine add_pair(sums, largest, pair, positions, middle)
      !> Moment, force along x and z, and energy lost to friction: what the half joint has
      real(wp), intent(inout) :: sums(4)
      !> Largest pressure, MPa
      real(wp), intent(inout) :: largest
      type(contact_pair), intent(in) :: pair
      !> Of all nodes, and the middle of the joint, mm
      real(wp), intent(in) :: positions(:, :), middle(3)
      real(wp) :: force(3), arm(3)
      integer :: i, j, k

      sums(4) = sums(4) + pair%energy%dissipation
      do i = 1, size(pair%own)
         associate (face => pair%faces(pair%own(i)))
            do j = 1, size(face%cells)
               associate (cell => face%cells(j))
                  if (.not. cell%trial%traction(1)*cell%coverage > 0.0_wp) cycle
                  largest = max(largest, cell%trial%traction(1))
                  do k = cell%first, cell%last
                     associate (sample => face%samples(k))
                        ! on the slave, as add_cell_response has it
                        force = cell%area*cell%coverage*sample%weight &
                           *(cell%trial%traction(1)*sample%ray%inverse(3, :) &
                           - matmul(face%tangents, cell%trial%traction(2:)))
                        arm = matmul(positions(:, face%nodes(:4)), sample%shape) - middle
                     end associate
                     sums(1) = sums(1) + arm(1)*force(3) - arm(3)*force(1)
                     sums(2:3) = sums(2:3) + force([1, 3])
                  end do
               end associate
            end do
         end associate
      end do
   end subroutine add_pair

end module asperity_solid_solve_joints
