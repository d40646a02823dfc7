!> A drawing of the joint with its sizes, symbols and signs, as an SVG element.
module asperity_program_commands_tenon_sketch
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: add_sketch

   !> Size of the drawing, and its margins
   real(wp), parameter :: wide = 900.0_wp, high = 400.0_wp, margin = 60.0_wp
   !> Gaps are drawn at least so wide, as they could not be seen else
   real(wp), parameter :: least_gap = 6.0_wp
   !> Place of the column face
   real(wp), parameter :: face = 400.0_wp, middle = 0.5_wp*high

contains

   !> Append the drawing.
   pure subroutine add_sketch(b, joint)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The joint, all sizes given
      type(tenon_settings), intent(in) :: joint
      real(wp) :: scale, length, half, arm, extension, above, below, datum

      associate (j => joint)
         datum = 0.0_wp
         if (j%arm_datum == 'column_axis') datum = -0.5_wp*j%length
         scale = min((face - margin)/j%length, &
            (wide - margin - face)/max(j%arm + datum, 1.0_wp), (high - 2.5_wp*margin)/j%height)
         length = scale*j%length
         half = 0.5_wp*scale*j%height
         extension = scale*j%extension
         arm = scale*(j%arm + datum)
         above = max(least_gap, scale*j%clearance_above)
         below = max(least_gap, scale*j%clearance_below)
      end associate

      call b%line('<svg viewBox="0 0 900 400" role="img" aria-label="The joint, its sizes and '// &
         'signs" font-family="sans-serif" font-size="13"><defs><marker id="sketch_head" '// &
         'viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" '// &
         'orient="auto-start-reverse"><path d="M0,0 L8,4 L0,8 z"/></marker></defs>')
      ! column, above and below the mortise
      call add_box(b, face - length, 10.0_wp, length, middle - half - above - 10.0_wp, '#cbb59a')
      call add_box(b, face - length, middle + half + below, length, &
         high - 10.0_wp - middle - half - below, '#cbb59a')
      ! tenon and beam: full height as far as the extension goes
      call add_box(b, face - length, middle - half, length + extension, 2.0_wp*half, '#efdcc0')
      call b%line('<line x1="'//place(face + extension)//'" x2="'//place(face + arm)//'" y1="'// &
         place(middle)//'" y2="'//place(middle)//'" stroke="#8a6d3b" stroke-width="6"/>')
      call b%line('<line x1="'//place(face - length - 10.0_wp)//'" x2="'// &
         place(face + arm + 30.0_wp)//'" y1="'//place(middle)//'" y2="'//place(middle)// &
         '" stroke="#555" stroke-dasharray="8 3 2 3"/>')
      ! load, pull-out, rotation
      call add_arrow(b, face + arm, middle, face + arm, middle - 70.0_wp, .false.)
      call add_label(b, face + arm - 8.0_wp, middle - 60.0_wp, 'F, v', 'end')
      call add_arrow(b, face + extension + 12.0_wp, middle + 18.0_wp, face + extension + 62.0_wp, &
         middle + 18.0_wp, .false.)
      call add_label(b, face + extension + 16.0_wp, middle + 36.0_wp, 'u pull-out', 'start')
      call b%line('<path d="M'//place(face + 0.55_wp*arm)//','//place(middle + 12.0_wp)// &
         ' q 14,-30 -6,-56" fill="none" stroke="#000" marker-end="url(#sketch_head)"/>')
      call add_label(b, face + 0.55_wp*arm + 14.0_wp, middle - 22.0_wp, 'rotation', 'start')
      ! sizes
      call add_arrow(b, face - length, middle - 24.0_wp, face, middle - 24.0_wp, .true.)
      call add_label(b, face - 0.5_wp*length, middle - 30.0_wp, &
         'length '//size_text(joint%length), 'middle')
      call add_arrow(b, face - length + 24.0_wp, middle - half, face - length + 24.0_wp, &
         middle + half, .true.)
      call add_label(b, face - length + 32.0_wp, middle + 0.6_wp*half, &
         'height '//size_text(joint%height)//', width '//size_text(joint%width), &
         'start')
      call add_arrow(b, face + scale*datum, high - 24.0_wp, face + arm, high - 24.0_wp, .true.)
      call add_label(b, face + 0.5_wp*arm, high - 30.0_wp, 'arm '//size_text(joint%arm)// &
         trim(merge(' from the column axis', ' from the column face', datum < 0.0_wp)), 'start')
      call add_label(b, face + 8.0_wp, middle - half - above - 4.0_wp, 'clearance above '// &
         size_text(joint%clearance_above)//' (upper face)', 'start')
      call add_label(b, face + 8.0_wp, middle + half + below + 14.0_wp, 'clearance below '// &
         size_text(joint%clearance_below)//' (lower face)', 'start')
      call add_label(b, face - 0.5_wp*length, 32.0_wp, 'column, grain upright', 'middle')
      call b%line('<line x1="'//place(face)//'" x2="'//place(face)//'" y1="10" y2="390" '// &
         'stroke="#000" stroke-dasharray="2 3"/>')
      call add_label(b, face + 8.0_wp, 24.0_wp, 'column face', 'start')
      call b%line('</svg>')
   end subroutine add_sketch

   pure subroutine add_box(b, x, y, width, height, colour)
      type(growing_text), intent(inout) :: b
      real(wp), intent(in) :: x, y, width, height
      character(len=*), intent(in) :: colour

      call b%line('<rect x="'//place(x)//'" y="'//place(y)//'" width="'//place(width)// &
         '" height="'//place(max(0.0_wp, height))//'" fill="'//colour//'" stroke="#555"/>')
   end subroutine add_box

   !> An arrow, with a head at either end for sizes.
   pure subroutine add_arrow(b, x1, y1, x2, y2, both)
      type(growing_text), intent(inout) :: b
      real(wp), intent(in) :: x1, y1, x2, y2
      logical, intent(in) :: both

      call b%add('<line x1="'//place(x1)//'" y1="'//place(y1)//'" x2="'//place(x2)//'" y2="'// &
         place(y2)//'" stroke="#000" marker-end="url(#sketch_head)"')
      if (both) call b%add(' marker-start="url(#sketch_head)"')
      call b%line('/>')
   end subroutine add_arrow

   pure subroutine add_label(b, x, y, text, anchor)
      type(growing_text), intent(inout) :: b
      real(wp), intent(in) :: x, y
      character(len=*), intent(in) :: text, anchor

      call b%line('<text x="'//place(x)//'" y="'//place(y)//'" text-anchor="'//anchor//'">'// &
         text//'</text>')
   end subroutine add_label

   !> A coordinate.
   pure function place(x) result(text)
      real(wp), intent(in) :: x
      character(len=:), allocatable :: text
      character(len=16) :: buffer

      write (buffer, '(f12.1)') x
      text = trim(adjustl(buffer))
   end function place

   !> A size in mm.
   pure function size_text(size) result(text)
      real(wp), intent(in) :: size
      character(len=:), allocatable :: text

      text = to_text(size, 6)//' mm'
   end function size_text

end module asperity_program_commands_tenon_sketch
