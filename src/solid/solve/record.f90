!> What is told of every increment of a solid joint.
module asperity_solid_solve_record
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: status_slip, status_stick
   use asperity_law_validity, only: valid
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: load_place, solid_model
   use asperity_solid_solve_energy, only: energy_ledger
   implicit none
   private
   public :: increment_record, new_record

   !> Most pairs of faces of a joint
   integer, parameter :: most_pairs = 3

   !> One increment; forces and energies are those of the whole joint, or of all joints of a frame.
   type :: increment_record
      !> Number of the stroke, from 1, and iterations
      integer :: stroke = 0, iterations = 0
      !> Displacement of the load, mm; force, N; of a single joint, rotation of the beam at the
      !> column face, rad, and pull-out there, mm
      real(wp) :: displacement = 0.0_wp, force = 0.0_wp, rotation = 0.0_wp, pull_out = 0.0_wp
      !> Energies, J
      real(wp) :: work = 0.0_wp, stored = 0.0_wp, plastic = 0.0_wp, friction = 0.0_wp, &
         face_plastic = 0.0_wp, coupling = 0.0_wp, edge = 0.0_wp, balance = 0.0_wp
      !> Share of the wood's points that yield, and largest equivalent plastic strain
      real(wp) :: yielding = 0.0_wp, plastic_strain = 0.0_wp
      !> Of each kind of pair, upper, lower and side: normal force, N; largest pressure, MPa; area
      !> that sticks and that slips, mm^2; energy lost to friction, J
      real(wp) :: normal_force(most_pairs) = 0.0_wp, largest_pressure(most_pairs) = 0.0_wp, &
         stick_area(most_pairs) = 0.0_wp, slip_area(most_pairs) = 0.0_wp, &
         friction_energy(most_pairs) = 0.0_wp
      !> Largest force of a slave face over its area, MPa: what the element behind feels, whatever
      !> its cells share and however little of them is covered
      real(wp) :: largest_mean_pressure = 0.0_wp
      !> Limits of the law that points have passed, flags
      integer :: validity = valid
   end type increment_record

contains

   !> The record of the present state, of all ranks.
   subroutine new_record(record, model, displacement, ledger, n_yielding, stroke, iterations, &
         ranks)
      !> Result
      type(increment_record), intent(out) :: record
      !> The joint, and its displacements, mm
      type(solid_model), intent(in) :: model
      real(wp), intent(in) :: displacement(:, :)
      !> Its energies
      type(energy_ledger), intent(in) :: ledger
      !> How many points yield; stroke and iterations
      integer, intent(in) :: n_yielding, stroke, iterations
      !> The ranks, each with its elements and faces
      type(rank_team), intent(in) :: ranks
      real(wp), parameter :: halves = 2.0_wp, joule = 1.0e3_wp
      integer :: i, j, k, n, face

      record%stroke = stroke
      record%iterations = iterations
      record%displacement = load_place(model, displacement)
      record%force = halves*ledger%load_force
      if (allocated(model%mesh%section)) &
         call joint_rotation(model, displacement, record%rotation, record%pull_out)
      record%work = halves*ledger%work/joule
      record%stored = halves*ledger%stored/joule
      record%plastic = halves*ledger%plastic/joule
      record%face_plastic = halves*ledger%face_plastic/joule
      record%friction = halves*ledger%friction/joule
      record%coupling = halves*ledger%coupling/joule
      record%edge = halves*ledger%edge/joule
      record%balance = halves*ledger%balance/joule
      record%yielding = real(n_yielding, wp)/size(model%points)
      record%plastic_strain = maxval(model%points(:, model%own_elements)%equivalent_strain)
      do i = 1, size(model%pairs)
         face = modulo(i - 1, model%pairs_of_joint) + 1
         record%friction_energy(face) = record%friction_energy(face) &
            + halves*model%pairs(i)%energy%dissipation/joule
         do n = 1, size(model%pairs(i)%own)
            j = model%pairs(i)%own(n)
            do k = 1, size(model%pairs(i)%faces(j)%cells)
               associate (cell => model%pairs(i)%faces(j)%cells(k))
                  if (.not. cell%coverage > 0.0_wp) cycle
                  record%validity = ior(record%validity, cell%trial%validity)
                  record%normal_force(face) = record%normal_force(face) &
                     + halves*cell%area*cell%coverage*cell%trial%traction(1)
                  record%largest_pressure(face) = max(record%largest_pressure(face), &
                     cell%trial%traction(1))
                  if (cell%trial%status == status_stick) &
                     record%stick_area(face) = record%stick_area(face) &
                     + halves*cell%area*cell%coverage
                  if (cell%trial%status == status_slip) &
                     record%slip_area(face) = record%slip_area(face) &
                     + halves*cell%area*cell%coverage
               end associate
            end do
            associate (cells => model%pairs(i)%faces(j)%cells)
               record%largest_mean_pressure = max(record%largest_mean_pressure, &
                  sum(cells%area*cells%coverage*cells%trial%traction(1))/sum(cells%area))
            end associate
         end do
      end do
      call combine(record, ranks)
   end subroutine new_record

   !> Sums over the ranks of what is a sum over faces, the largest of what is a largest, and flags
   !> of all.
   subroutine combine(record, ranks)
      type(increment_record), intent(inout) :: record
      type(rank_team), intent(in) :: ranks
      real(wp) :: sums(most_pairs, 4), largest(most_pairs + 2), flags(bit_size(record%validity))
      integer :: i

      sums(:, 1) = record%normal_force
      sums(:, 2) = record%stick_area
      sums(:, 3) = record%slip_area
      sums(:, 4) = record%friction_energy
      largest(:most_pairs) = record%largest_pressure
      largest(most_pairs + 1:) = [record%plastic_strain, record%largest_mean_pressure]
      do i = 1, size(flags)
         flags(i) = merge(1.0_wp, 0.0_wp, btest(record%validity, i - 1))
      end do
      call ranks%sum(sums)
      call ranks%maximum(largest)
      call ranks%maximum(flags)
      record%normal_force = sums(:, 1)
      record%stick_area = sums(:, 2)
      record%slip_area = sums(:, 3)
      record%friction_energy = sums(:, 4)
      record%largest_pressure = largest(:most_pairs)
      record%plastic_strain = largest(most_pairs + 1)
      record%largest_mean_pressure = largest(most_pairs + 2)
      do i = 1, size(flags)
         if (flags(i) > 0.5_wp) record%validity = ibset(record%validity, i - 1)
      end do
   end subroutine combine

   !> Rotation of the beam's section at the column face, positive where the load point rises, by
   !> least squares, rad, and its mean displacement out of the mortise, mm.
   pure subroutine joint_rotation(model, displacement, rotation, pull_out)
      !> The joint, and its displacements, mm
      type(solid_model), intent(in) :: model
      real(wp), intent(in) :: displacement(:, :)
      !> Rotation, rad
      real(wp), intent(out) :: rotation
      !> Pull-out, mm
      real(wp), intent(out) :: pull_out
      real(wp) :: height(size(model%mesh%section))

      associate (nodes => model%mesh%section)
         height = model%mesh%nodes(3, nodes)
         height = height - sum(height)/size(height)
         pull_out = sum(displacement(1, nodes))/size(nodes)
         rotation = -dot_product(displacement(1, nodes), height)/dot_product(height, height)
      end associate
   end subroutine joint_rotation

end module asperity_solid_solve_record
