!> Column and beam of the tenon joint as meshes: one half, cut through the middle of the beam.
!>
!> x runs along the beam, 0 at the column face; z up, 0 at the middle of the beam; y across it, 0 in
!> the plane of symmetry.
module asperity_deck_tenon_parts
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_mesh_cuts, only: even_cuts, joined_cuts
   use asperity_deck_mesh_hexahedra, only: hex_mesh, new_grid_mesh
   use asperity_deck_options, only: check_mesh_size, deck_choice
   use asperity_deck_tenon_rims, only: cut_part
   use asperity_replay_sizes, only: check_size
   use asperity_replay_tenon_settings, only: tenon_face_arm, tenon_settings
   implicit none
   private
   public :: tenon_sizes, default_tenon_sizes, default_mesh_size, check_tenon_sizes, &
      tenon_elements, new_beam, node_near

   !> Sizes that the plane replay does not have; chosen ones by `default_tenon_sizes`.
   type :: tenon_sizes
      !> Height of the column, and its width across the beam, mm; chosen
      real(wp) :: column_height = 0.0_wp, column_width = 0.0_wp
      !> Length of beam behind the column, mm
      real(wp) :: tail = 0.0_wp
      !> Clearance of the meshes above and below the beam, negative for an interference, mm
      real(wp) :: gap_above = 0.0_wp, gap_below = 0.0_wp
      !> Contact of the mortise begins so far from its back, and at the sides from its top and
      !> bottom, mm; chosen. Nodes there are at the edge of the beam and would find and lose it in
      !> turn
      real(wp) :: edge_relief = 0.0_wp
      !> Interference at each side, mm, made from the side pressure when not above zero; and the
      !> part of it by which the meshes overlap, while the beam swells by the rest
      real(wp) :: side_interference = 0.0_wp, side_overlap = 0.0_wp
   end type tenon_sizes

   !> Height of the column, relief and edge of an element over the height of the tenon
   real(wp), parameter :: column_ratio = 10.0_wp/3.0_wp, relief_ratio = 0.01_wp, &
      mesh_ratio = 0.1_wp

contains

   !> Sizes of a joint unless one knows better: the column is square, the rest follows from the
   !> height of the tenon.
   pure function default_tenon_sizes(settings) result(sizes)
      !> Settings of the joint
      type(tenon_settings), intent(in) :: settings
      type(tenon_sizes) :: sizes

      sizes%column_height = column_ratio*settings%height
      sizes%column_width = settings%length
      sizes%edge_relief = relief_ratio*settings%height
   end function default_tenon_sizes

   !> Length of an edge aimed at, mm: the paper's for a tenon 300 mm high.
   pure real(wp) function default_mesh_size(settings)
      !> Settings of the joint
      type(tenon_settings), intent(in) :: settings

      default_mesh_size = mesh_ratio*settings%height
   end function default_mesh_size

   !> `error` is set when the parts cannot be, or the mesh is too coarse for them.
   pure subroutine check_tenon_sizes(choice, settings, sizes, error)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Checked settings of the joint
      type(tenon_settings), intent(in) :: settings
      !> Further sizes
      type(tenon_sizes), intent(in) :: sizes
      !> Set when a size is refused
      type(error_type), allocatable, intent(out) :: error

      call check_positive(error, 'column_height', sizes%column_height, 'mm')
      if (.not. allocated(error)) &
         call check_positive(error, 'column_width', sizes%column_width, 'mm')
      if (.not. allocated(error)) &
         call check_range(error, 'tail', sizes%tail, 0.0_wp, 1.0e9_wp, ' mm')
      associate (accepted => settings%accept_sizes)
         call check_size(error, 'column_height', sizes%column_height, accepted)
         call check_size(error, 'column_width', sizes%column_width, accepted)
         call check_size(error, 'tail', sizes%tail, accepted)
         call check_size(error, 'edge_relief', sizes%edge_relief, accepted)
         call check_size(error, 'side_interference', sizes%side_interference, accepted)
      end associate
      if (.not. allocated(error)) call check_range(error, 'edge_relief', sizes%edge_relief, &
         0.0_wp, 0.25_wp*min(choice%mesh_size, settings%width), ' mm')
      if (.not. allocated(error)) call check_range(error, 'side_interference', &
         sizes%side_interference, 0.0_wp, 0.25_wp*settings%width, ' mm')
      if (allocated(error)) return
      call check_mesh_size(error, choice, 'width', settings%width)
      call check_mesh_size(error, choice, 'height', settings%height)
      call check_mesh_size(error, choice, 'length', settings%length)
      call check_mesh_size(error, choice, 'arm', tenon_face_arm(settings))
      if (allocated(error)) return
      associate (high => settings%height + 2.0_wp*max(settings%clearance_above, &
            settings%clearance_below))
         if (.not. sizes%column_height > high) call fatal_error(error, 'column_height = '// &
            to_text(sizes%column_height)//' mm is too small for the mortise, '//to_text(high)// &
            ' mm high', subject='column_height')
      end associate
      if (.not. sizes%column_width > settings%width) call fatal_error(error, 'column_width = '// &
         to_text(sizes%column_width)//' mm is too small for the mortise, '// &
         to_text(settings%width)//' mm wide', subject='column_width')
   end subroutine check_tenon_sizes

   !> The beam, with nodes at mid-height, and with a section at the column face when it is graded.
   pure subroutine new_beam(mesh, choice, settings, sizes)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Checked settings of the joint
      type(tenon_settings), intent(in) :: settings
      !> Further sizes
      type(tenon_sizes), intent(in) :: sizes
      real(wp), allocatable :: x(:), y(:), z(:), inside(:), outside(:)

      associate (s => settings, half => 0.5_wp*settings%height)
         if (allocated(choice%rim_mesh_size)) then
            call cut_part(choice, -s%length, 0.0_wp, [.true., .true.], 1, inside)
            call cut_part(choice, 0.0_wp, tenon_face_arm(s), [.true., .false.], 1, outside)
            call joined_cuts(inside, outside, x)
            if (sizes%tail > 0.0_wp) then
               call cut_part(choice, -s%length - sizes%tail, -s%length, [.false., .true.], 1, &
                  outside)
               inside = x
               call joined_cuts(outside, inside, x)
            end if
         else
            call even_cuts(-s%length - sizes%tail, tenon_face_arm(s), choice%mesh_size, 1, x)
         end if
         call even_cuts(0.0_wp, 0.5_wp*s%width, choice%mesh_size, 1, y)
         call cut_part(choice, -half, half, [.true., .true.], 2, z)
      end associate
      call new_grid_mesh(mesh, x, y, z)
   end subroutine new_beam

   !> About how many elements the parts have, not fewer.
   pure real(wp) function tenon_elements(choice, settings, sizes)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Checked settings of the joint
      type(tenon_settings), intent(in) :: settings
      !> Further sizes
      type(tenon_sizes), intent(in) :: sizes
      real(wp) :: finer

      ! cells that rims add in a direction: of four, each with those from the finest to the largest
      finer = 0.0_wp
      if (allocated(choice%rim_mesh_size)) finer = &
         4.0_wp*log(choice%mesh_size/choice%rim_mesh_size)/log(choice%mesh_growth)
      associate (s => settings, cell => choice%mesh_size)
         tenon_elements = 0.5_wp*sizes%column_width/cell &
            *(s%length/cell + finer)*(sizes%column_height/cell + finer) &
            + 0.5_wp*s%width/cell*((s%length + sizes%tail + tenon_face_arm(s))/cell + finer) &
            *(s%height/cell + finer)
      end associate
   end function tenon_elements

   !> The node that is nearest to a place.
   pure integer function node_near(mesh, place)
      !> The part
      type(hex_mesh), intent(in) :: mesh
      !> The place, mm
      real(wp), intent(in) :: place(3)

      node_near = minloc(sum((mesh%nodes - spread(place, 2, size(mesh%nodes, 2)))**2, 1), 1)
   end function node_near

end module asperity_deck_tenon_parts
