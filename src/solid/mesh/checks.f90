!> Whether the mesh of the joint as a solid goes with its programme: what cannot be seen on it is
!> refused, what makes results poor is said.
!>
!> Estimates are those of a rigid tenon that turns about its middle: it touches from a displacement
!> A0 of the load point on (`touching_displacement`), presses its rims by
!> (A - A0)/(1 + 2 arm/length) into the faces at an amplitude A, and meets each face over
!> length/2 (1 - A0/A). Wood gives way besides.
module asperity_solid_mesh_checks
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_tenon_deck, only: tenon_deck, touching_displacement
   use asperity_replay_tenon_settings, only: tenon_face_arm
   implicit none
   private
   public :: check_solid_mesh, mesh_remark

   !> Share of a facet that must be in contact: to the middle of its first contact cell, of three
   real(wp), parameter :: least_share = 1.0_wp/6.0_wp
   !> Cell at the rims over indentation of crushed wood from which on forces are some 7 % and more
   !> too high, as found on meshes from 20 to 60 mm; below one, strains are not small any more
   real(wp), parameter :: coarse = 3.0_wp

contains

   !> `error` is set when contact cannot be seen on the mesh, or is nowhere.
   pure subroutine check_solid_mesh(deck, error)
      !> The model, with its meshes
      type(tenon_deck), intent(in) :: deck
      !> Set when the mesh is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: touch, amplitude, strip, facet, cell
      character(len=16) :: name

      touch = touching_displacement(deck)
      amplitude = maxval(abs(deck%turns))
      if (.not. amplitude > touch) then
         if (deck%has_sides) return
         call fatal_error(error, 'nothing touches: the largest displacement is '// &
            to_text(amplitude, 4)//' mm, and the tenon meets its faces at '//to_text(touch, 4)// &
            ' mm; take larger amplitudes, a smaller clearance or a side pressure', &
            subject='amplitudes clearance side_pressure')
         return
      end if
      strip = 0.5_wp*deck%settings%length*(1.0_wp - touch/amplitude)
      facet = rim_facet(deck)
      name = 'mesh_size'
      cell = deck%choice%mesh_size
      if (allocated(deck%choice%rim_mesh_size)) then
         name = 'rim_mesh_size'
         cell = deck%choice%rim_mesh_size
      end if
      if (strip < least_share*facet) call fatal_error(error, trim(name)//' = '// &
         to_text(cell)//' mm is too coarse for the indentation: at '// &
         to_text(amplitude, 4)//' mm the tenon meets its faces over '//to_text(strip, 4)// &
         ' mm, less than the sixth part of an element of '//to_text(facet, 4)// &
         ' mm; take a smaller one or larger amplitudes', subject=trim(name))
   end subroutine check_solid_mesh

   !> What is to be said of a mesh that is not refused; blank when there is nothing.
   pure function mesh_remark(deck) result(remark)
      !> The model, with its meshes
      type(tenon_deck), intent(in) :: deck
      character(len=240) :: remark
      real(wp) :: touch, amplitude, indentation, cell, elastic

      remark = ''
      touch = touching_displacement(deck)
      amplitude = maxval(abs(deck%turns))
      associate (s => deck%settings)
         indentation = (amplitude - touch)/(1.0_wp + 2.0_wp*tenon_face_arm(s)/s%length)
         ! what half the height of the tenon bears without crushing
         elastic = 0.5_wp*s%height*s%wood%compression_strengths(2)/s%wood%young_moduli(2)
      end associate
      ! places of nodes are sums: not 60.00 mm for 60.0
      cell = anint(1.0e6_wp*max(rim_facet(deck), rim_height(deck)))/1.0e6_wp
      if (.not. indentation > 0.0_wp) then
         remark = 'the tenon meets its sides only: a rigid one '// &
            'touches above and below from '//to_text(touch, 4)//' mm on'
      else if (cell < indentation) then
         remark = 'elements of '//to_text(cell, 4)// &
            ' mm at the rims are smaller than the indentation, about '//to_text(indentation, 3)// &
            ' mm: strains there are not small, and increments may be cut'
      else if (cell > coarse*indentation .and. indentation > elastic) then
         remark = 'elements of '//to_text(cell, 4)// &
            ' mm at the rims are coarse for an indentation of about '//to_text(indentation, 3)// &
            ' mm: forces come out too high, by a third at 60 mm in the paper''s joint'
      end if
   end function mesh_remark

   !> Length of the mortise's last facet, at the column face, mm.
   pure real(wp) function rim_facet(deck)
      type(tenon_deck), intent(in) :: deck

      rim_facet = last_step(deck%column%nodes(1, :))
   end function rim_facet

   !> Height of the beam's elements at its upper face, mm.
   pure real(wp) function rim_height(deck)
      type(tenon_deck), intent(in) :: deck

      rim_height = last_step(deck%beam%nodes(3, :))
   end function rim_height

   !> From the second largest to the largest coordinate.
   pure real(wp) function last_step(places)
      real(wp), intent(in) :: places(:)

      last_step = maxval(places)
      ! planes of a grid are the same number in all their nodes
      last_step = last_step - maxval(places, mask=places < last_step)
   end function last_step

end module asperity_solid_mesh_checks
