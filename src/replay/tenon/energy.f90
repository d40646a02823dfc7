!> Energies of the tenon joint over one increment, all points.
!>
!> The work is the trapezoidal rule of forces over motions. Each point's pressure path is split
!> exactly, and so is its slip path, for the mean of "pressure first" and "slip first": with
!> tau = mu p gamma/gcrit that gives friction at the mean pressure and the pressure coupling at
!> the mean squared elastic slip, so that the sum closes to second order in the step. The
!> dissipative rule has one order only, the pressure first, and closes to first order.
module asperity_replay_tenon_energy
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_strength, only: find_friction_strength
   use asperity_contact_properties, only: rule_abaqus
   use asperity_contact_state, only: status_open
   use asperity_replay_tenon_contact_record, only: contact_record
   use asperity_replay_tenon_contact_wood_bearing, only: bearing_plastic_work
   use asperity_replay_tenon_geometry, only: other_side, side, tenon_faces, tenon_model
   implicit none
   private
   public :: tenon_ledger, book_increment, stored_energy, point_split

   !> Totals since rest, N mm.
   type :: tenon_ledger
      !> Work into the points
      real(wp) :: contact_work = 0.0_wp
      !> Stored now, with what was stored at rest
      real(wp) :: stored = 0.0_wp
      !> Dissipated by friction, of each face; by yield of the wood, and of the faces' summits
      real(wp) :: friction(tenon_faces) = 0.0_wp, plastic = 0.0_wp, face_plastic = 0.0_wp
      !> Pressure coupling, and stored energy lost at the edges
      real(wp) :: elastic_slip = 0.0_wp, edge = 0.0_wp
      !> Normal force of each face now, N
      real(wp) :: normal(tenon_faces) = 0.0_wp
   end type tenon_ledger

contains

   !> Add what an increment did.
   pure subroutine book_increment(model, start, trial, ledger)
      !> Joint
      type(tenon_model), intent(in) :: model
      !> Points at its start and end
      type(contact_record), intent(in) :: start(:), trial(:)
      !> The totals
      type(tenon_ledger), intent(inout) :: ledger
      real(wp) :: friction, plastic, coupling, before, after, weight
      integer :: i, face

      ledger%stored = 0.0_wp
      ledger%normal = 0.0_wp
      do i = 1, size(start)
         if (start(i)%weight <= 0.0_wp .and. trial(i)%weight <= 0.0_wp) cycle
         face = model%face(i)
         before = stored_energy(model, face, start(i))
         after = stored_energy(model, face, trial(i))
         ledger%contact_work = ledger%contact_work + model%area(i)*work_of(model, face, start(i), &
            trial(i))
         if (trial(i)%weight <= 0.0_wp) then
            ! gone with what it had
            ledger%edge = ledger%edge + model%area(i)*start(i)%weight*before
            cycle
         end if
         call point_split(model, face, start(i), trial(i), friction, plastic, coupling)
         weight = 0.5_wp*model%area(i)*(start(i)%weight + trial(i)%weight)
         ledger%friction(face) = ledger%friction(face) + weight*friction
         ledger%plastic = ledger%plastic + weight*plastic
         ! the sides' pressure is given: what they stored and lost by it was before
         if (face /= side) &
            ledger%face_plastic = ledger%face_plastic + weight*trial(i)%plastic_dissipation
         ledger%elastic_slip = ledger%elastic_slip + weight*coupling
         ledger%edge = ledger%edge - 0.5_wp*model%area(i)*(before + after) &
            *(trial(i)%weight - start(i)%weight)
         ledger%stored = ledger%stored + model%area(i)*trial(i)%weight*after
         ledger%normal(face) = ledger%normal(face) &
            + model%area(i)*trial(i)%weight*trial(i)%state%pressure
      end do
      ! one side was computed with the area of both
      ledger%normal(side:other_side) = 0.5_wp*sum(ledger%normal(side:other_side))
      ledger%friction(side:other_side) = 0.5_wp*sum(ledger%friction(side:other_side))
   end subroutine book_increment

   !> Frictional dissipation, plastic work and pressure coupling per area of an increment, N/mm.
   pure subroutine point_split(model, face, start, trial, friction, plastic, coupling)
      !> Joint
      type(tenon_model), intent(in) :: model
      !> Face of the point
      integer, intent(in) :: face
      !> Point at its start and end
      type(contact_record), intent(in) :: start, trial
      !> Result
      real(wp), intent(out) :: friction, plastic, coupling
      real(wp) :: change, scale, before, after

      friction = trial%dissipation
      coupling = trial%pressure_coupling
      plastic = bearing_plastic_work(model%law%wood, start%indentation, trial%indentation)
      if (model%law%faces%friction_rule /= rule_abaqus .or. face == side) return
      if (trial%state%status == status_open) return
      ! the update changes the pressure first: add the mean with the other order
      if (.not. model%law%faces%friction_is_plain) then
         call find_friction_strength(model%law%faces, start%state%pressure, before, change)
         call find_friction_strength(model%law%faces, trial%state%pressure, after, change)
         friction = friction*(0.5_wp*(after + before)/after)
         coupling = 0.5_wp*(coupling + trial%tangential_energy*(after - before)/after)
         return
      end if
      scale = model%law%faces%friction_coefficient/model%law%faces%critical_slip
      change = trial%state%pressure - start%state%pressure
      friction = friction*(0.5_wp*(trial%state%pressure + start%state%pressure) &
         /trial%state%pressure)
      coupling = 0.5_wp*coupling + 0.25_wp*scale*change*dot_product(trial%state%elastic_slip, &
         trial%state%elastic_slip)
   end subroutine point_split

   !> Stored energy of a point per area, N/mm: of the interface, the wood and the elastic slip. The
   !> sides' pressure is given, so that their normal energy does not change.
   pure real(wp) function stored_energy(model, face, point)
      !> Joint
      type(tenon_model), intent(in) :: model
      !> Face of the point
      integer, intent(in) :: face
      !> The point
      type(contact_record), intent(in) :: point

      stored_energy = point%tangential_energy
      if (face == side) return
      stored_energy = stored_energy + point%state%normal_energy &
         + 0.5_wp*model%law%wood%compliance*point%state%pressure**2
   end function stored_energy

   !> Work into a point per area by the trapezoidal rule.
   pure real(wp) function work_of(model, face, start, trial)
      type(tenon_model), intent(in) :: model
      integer, intent(in) :: face
      type(contact_record), intent(in) :: start, trial

      work_of = 0.5_wp*dot_product(start%weight*stress_of(model, face, start) &
         + trial%weight*stress_of(model, face, trial), trial%place - start%place)
   end function work_of

   !> Stress of the tenon on the mortise, in the mortise's frame.
   pure function stress_of(model, face, point) result(stress)
      type(tenon_model), intent(in) :: model
      integer, intent(in) :: face
      type(contact_record), intent(in) :: point
      real(wp) :: stress(2)

      if (face == side) then
         stress = point%shear
      else
         stress = point%state%pressure*model%normal(:, face)
         if (face < side) then
            stress(1) = stress(1) + point%shear(1)
         else
            stress(2) = stress(2) + point%shear(1)
         end if
      end if
   end function stress_of

end module asperity_replay_tenon_energy
