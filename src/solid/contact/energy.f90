!> Energies of contact, of a pair of surfaces. On any path, in the limit of small increments,
!> work of the contact forces = change of (normal + tangential) + dissipation + plastic - coupling
!> + edge.
module asperity_solid_contact_energy
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: no_surface_limit
   use asperity_solid_contact_cell, only: contact_cell
   implicit none
   private
   public :: contact_energy, add_increment, recut_energy

   !> N mm.
   type :: contact_energy
      !> Stored now by pressure, and by elastic slip
      real(wp) :: normal = 0.0_wp, tangential = 0.0_wp
      !> Frictional dissipation and pressure coupling since the start, as in `contact_response`
      real(wp) :: dissipation = 0.0_wp, coupling = 0.0_wp
      !> Energy that left since the start without work of forces: as cells lost their coverage, and
      !> were cut anew; what the undeformed bodies' overclosure stores came in so
      real(wp) :: edge = 0.0_wp
      !> Plastic dissipation of the faces' summits since the start
      real(wp) :: plastic = 0.0_wp
   end type contact_energy

contains

   !> Add what a cell did in an increment, and what it stores at the end.
   pure subroutine add_increment(energy, cell)
      !> The energies
      type(contact_energy), intent(inout) :: energy
      !> The cell, not yet accepted
      type(contact_cell), intent(in) :: cell
      real(wp) :: start_normal, mean_coverage

      associate (c0 => cell%start_coverage, c => cell%coverage, r => cell%trial, a => cell%area)
         energy%edge = energy%edge + cell%recut_energy
         if (c <= 0.0_wp) then
            energy%edge = energy%edge &
               + a*c0*(cell%start%normal_energy + cell%start_tangential_energy)
            return
         end if
         ! past a rim the cell was as pressed, but not covered
         start_normal = cell%start%normal_energy
         mean_coverage = 0.5_wp*(c0 + c)
         if (cell%start%overclosure < no_surface_limit) then
            start_normal = r%normal_energy
            energy%edge = energy%edge - a*mean_coverage*r%plastic_dissipation
         end if
         energy%edge = energy%edge + a*(c0 - c)*0.5_wp*(start_normal + r%normal_energy &
            + cell%start_tangential_energy + r%tangential_energy)
         energy%plastic = energy%plastic + a*mean_coverage*r%plastic_dissipation
         energy%dissipation = energy%dissipation + a*mean_coverage*r%dissipation
         energy%coupling = energy%coupling + a*mean_coverage*r%pressure_coupling
         energy%normal = energy%normal + a*c*r%normal_energy
         energy%tangential = energy%tangential + a*c*r%tangential_energy
      end associate
   end subroutine add_increment

   !> Energy that leaves a cell as it is cut anew, N mm: its gap and coverage jump a little.
   pure real(wp) function recut_energy(cell)
      !> The cell, cut anew
      type(contact_cell), intent(in) :: cell

      associate (c => cell%start_coverage)
         recut_energy = (cell%last_coverage - c) &
            *(cell%start%normal_energy + cell%start_tangential_energy)
         if (cell%start%pressure > 0.0_wp) recut_energy = recut_energy &
            + c*cell%start%pressure*(cell%gap + cell%start%overclosure)
         recut_energy = cell%area*recut_energy
      end associate
   end function recut_energy

end module asperity_solid_contact_energy
