!> Cells of a slave facet: each is one contact point, with a state, a traction and an area. Its gap
!> and slip are means over samples, one on each master facet that is opposite.
module asperity_solid_contact_cell
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: contact_response, contact_state, no_opposite_surface
   use asperity_solid_contact_geometry_facet, only: facet_ray
   implicit none
   private
   public :: contact_cell, contact_sample, motion_of

   !> A place in a slave facet, kept within an increment, and the ray from it.
   type :: contact_sample
      !> Share of the cell that it stands for
      real(wp) :: weight = 1.0_wp
      !> Shape functions of the slave facet at its place
      real(wp) :: shape(4) = 0.0_wp
      !> Master facet that its ray meets, now and at the start of the increment; 0 for none
      integer :: facet = 0, start_facet = 0
      !> Ray now, and where it met at the start of the increment
      type(facet_ray) :: ray
      real(wp) :: start_natural(2) = 0.0_wp
   end type contact_sample

   !> A contact point. Start is that of the increment.
   type :: contact_cell
      !> Place of its middle, undeformed, mm
      real(wp) :: position(3) = 0.0_wp
      !> Area, undeformed, mm^2
      real(wp) :: area = 0.0_wp
      !> Its two edges, undeformed, mm
      real(wp) :: edges(3, 2) = 0.0_wp
      !> Ray from its middle, by which it is covered
      type(contact_sample) :: middle
      !> Its samples among those of the face
      integer :: first = 0, last = -1
      !> Mean gap, mm, and relative tangential motion since the start, mm
      real(wp) :: gap = 0.0_wp, slip_increment(2) = 0.0_wp
      !> Share that has a surface opposite, its derivatives by the natural coordinates of the
      !> middle, and its value at the end of the increment before and at the start of this one
      real(wp) :: coverage = 0.0_wp, coverage_gradient(2) = 0.0_wp
      real(wp) :: last_coverage = 0.0_wp, start_coverage = 0.0_wp
      !> What is remembered of the start, and stored tangential energy per area then, N/mm
      type(contact_state) :: start = contact_state()
      real(wp) :: start_tangential_energy = 0.0_wp
      !> Energy that left when the cell was cut anew at the start, N mm
      real(wp) :: recut_energy = 0.0_wp
      !> Result of the law: traction, status, energies per area
      type(contact_response) :: trial = contact_response()
      !> Relative tangential motion while closed, up to the start, mm
      real(wp) :: slip(2) = 0.0_wp
   end type contact_cell

contains

   !> What the law is asked about a cell: overclosure, mm, `no_opposite_surface` without coverage,
   !> and slip of the increment, mm.
   pure function motion_of(cell) result(motion)
      !> The cell
      type(contact_cell), intent(in) :: cell
      real(wp) :: motion(3)

      motion = [no_opposite_surface, 0.0_wp, 0.0_wp]
      if (cell%coverage > 0.0_wp) motion = [-cell%gap, cell%slip_increment]
   end function motion_of

end module asperity_solid_contact_cell
