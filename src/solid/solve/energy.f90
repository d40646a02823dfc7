!> Energy of a solid joint: what the loads put in, and where it is.
module asperity_solid_solve_energy
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_energy, only: contact_energy
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_material_material, only: elastic_energy_density, material_point
   use asperity_solid_model_model, only: load_place, solid_model
   implicit none
   private
   public :: energy_ledger, add_increment

   !> Sums since the beam was fitted, of the half joint, J/1000.
   type :: energy_ledger
      !> Work of the moved load and of the columns'
      real(wp) :: work = 0.0_wp
      !> Stored in wood, springs and contact, above what was stored at first
      real(wp) :: stored = 0.0_wp
      !> Lost to plastic strain of the wood, and to friction
      real(wp) :: plastic = 0.0_wp, friction = 0.0_wp
      !> Lost to yield of the faces' summits
      real(wp) :: face_plastic = 0.0_wp
      !> Put into elastic slip by changes of pressure, and taken along by points that leave faces
      real(wp) :: coupling = 0.0_wp, edge = 0.0_wp
      !> Work less all the rest: falls with the increments
      real(wp) :: balance = 0.0_wp
      !> What the next increment begins from; place of the heads is their mean, by their loads
      logical :: has_begun = .false.
      real(wp) :: stored_at_first = 0.0_wp, load_force = 0.0_wp, load_place = 0.0_wp, &
         head_place = 0.0_wp, contact_at_first(4) = 0.0_wp
   end type energy_ledger

contains

   !> Add an increment, or begin where there was none. `start` are the points of the elements before
   !> it. All ranks get the sums over all.
   subroutine add_increment(ledger, model, start, displacement, load_force, ranks)
      !> The ledger
      type(energy_ledger), intent(inout) :: ledger
      !> The joint at the end of the increment
      type(solid_model), intent(in) :: model
      !> Points of the elements at its start
      type(material_point), intent(in) :: start(:, :)
      !> Displacements at its end, mm
      real(wp), intent(in) :: displacement(:, :)
      !> Force at the load, N
      real(wp), intent(in) :: load_force
      !> The ranks, each with its elements and faces
      type(rank_team), intent(in) :: ranks
      type(contact_energy) :: contact
      real(wp) :: stored, plastic, place, column_load, head_place, sums(6)
      integer :: i, j, k

      contact = contact_energy()
      do i = 1, size(model%pairs)
         associate (of_pair => model%pairs(i)%energy)
            contact%normal = contact%normal + of_pair%normal
            contact%tangential = contact%tangential + of_pair%tangential
            contact%dissipation = contact%dissipation + of_pair%dissipation
            contact%coupling = contact%coupling + of_pair%coupling
            contact%edge = contact%edge + of_pair%edge
            contact%plastic = contact%plastic + of_pair%plastic
         end associate
      end do
      stored = contact%normal + contact%tangential
      plastic = 0.0_wp
      place = load_place(model, displacement)
      column_load = sum(model%column_loads)
      head_place = 0.0_wp
      do i = 1, size(model%column_loads)
         if (.not. column_load > 0.0_wp) exit
         head_place = head_place + model%column_loads(i)/column_load &
            *displacement(3, model%mesh%heads(i)%nodes(1))
      end do
      do k = 1, size(model%own_elements)
         j = model%own_elements(k)
         associate (shape => model%shapes(model%shape_of(j)), &
               wood => model%wood(model%mesh%part(j)))
            do i = 1, 8
               associate (now => model%points(i, j), then => start(i, j))
                  stored = stored + shape%weights(i)*elastic_energy_density(wood, now%stress)
                  if (ledger%has_begun) plastic = plastic + 0.5_wp*shape%weights(i) &
                     *dot_product(now%stress + then%stress, &
                     now%plastic_strain - then%plastic_strain)
               end associate
            end do
         end associate
      end do
      sums = [stored, plastic, contact%dissipation, contact%coupling, contact%edge, &
         contact%plastic]
      call ranks%sum(sums)
      stored = sums(1)
      do i = 1, size(model%springs)
         associate (spring => model%springs(i))
            stored = stored &
               + 0.5_wp*spring%stiffness*displacement(spring%direction, spring%node)**2
         end associate
      end do
      ledger%plastic = ledger%plastic + sums(2)
      if (.not. ledger%has_begun) then
         ledger%stored_at_first = stored
         ledger%contact_at_first = sums(3:)
         ledger%has_begun = .true.
      else
         ledger%work = ledger%work &
            + 0.5_wp*(load_force + ledger%load_force)*(place - ledger%load_place) &
            - column_load*(head_place - ledger%head_place)
      end if
      ledger%stored = stored - ledger%stored_at_first
      ledger%friction = sums(3) - ledger%contact_at_first(1)
      ledger%coupling = sums(4) - ledger%contact_at_first(2)
      ledger%edge = sums(5) - ledger%contact_at_first(3)
      ledger%face_plastic = sums(6) - ledger%contact_at_first(4)
      ledger%balance = ledger%work - ledger%stored - ledger%plastic - ledger%face_plastic &
         - ledger%friction + ledger%coupling - ledger%edge
      ledger%load_force = load_force
      ledger%load_place = place
      ledger%head_place = head_place
   end subroutine add_increment

end module asperity_solid_solve_energy
