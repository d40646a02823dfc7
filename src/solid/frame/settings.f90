!> A plane frame of columns and beams that pass through them. Wherever a beam meets a column there
!> is a joint, all of one kind.
module asperity_solid_frame_settings
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_tenon_parts, only: tenon_sizes
   use asperity_replay_sizes, only: check_size
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: frame_settings, complete_frame_settings, check_frame_settings, shoe_height

   !> Columns, beams and loads; x as `column_places`, z from the feet up.
   type :: frame_settings
      !> Places of the columns' axes, rising, mm; chosen
      real(wp), allocatable :: column_places(:)
      !> Vertical load at the head of each column, N; none when not allocated
      real(wp), allocatable :: column_loads(:)
      !> Height of the axis of each beam above the feet, mm; one, at 2/3 of the columns, when not
      !> allocated
      real(wp), allocatable :: beam_heights(:)
      !> Numbers of the first and the last column of each beam; all columns when not allocated
      integer, allocatable :: beam_from(:), beam_to(:)
      !> Whether the feet turn on a hinge, as the heads do, or are `fixed`
      character(len=8) :: column_feet = 'hinged'
   end type frame_settings

   !> Height of the columns unless one knows better, mm; chosen
   real(wp), parameter, public :: usual_column_height = 3000.0_wp
   !> Places of the columns unless one knows better, mm; chosen
   real(wp), parameter :: usual_places(2) = [0.0_wp, 2100.0_wp]
   !> Height of a beam over that of the columns; chosen
   real(wp), parameter :: beam_ratio = 2.0_wp/3.0_wp
   !> Height of a shoe, a stiff end of a column that turns on a hinge, over the column's depth
   real(wp), parameter :: shoe_ratio = 0.2_wp
   !> Further away no column stands, mm
   real(wp), parameter :: furthest = 1.0e6_wp

contains

   !> Height of the shoes at both ends of a column, mm.
   pure real(wp) function shoe_height(joint)
      !> The joints
      type(tenon_settings), intent(in) :: joint

      shoe_height = shoe_ratio*joint%length
   end function shoe_height

   !> Give what is not allocated its value, and lists of one value as many as there are columns or
   !> beams. `error` is set when a list has another length.
   pure subroutine complete_frame_settings(frame, sizes, error)
      !> The frame
      type(frame_settings), intent(inout) :: frame
      !> Sizes of the joints and their columns
      type(tenon_sizes), intent(in) :: sizes
      !> Set then
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: first(:), last(:)

      if (.not. allocated(frame%column_places)) frame%column_places = usual_places
      if (.not. allocated(frame%column_loads)) frame%column_loads = [0.0_wp]
      if (.not. allocated(frame%beam_heights)) &
         frame%beam_heights = [beam_ratio*sizes%column_height]
      if (.not. allocated(frame%beam_from)) frame%beam_from = [1]
      if (.not. allocated(frame%beam_to)) frame%beam_to = [size(frame%column_places)]
      if (size(frame%column_places) < 2) then
         call fatal_error(error, 'column_places has '//to_text(size(frame%column_places))// &
            ' values: a frame has two columns at least', subject='column_places')
      else if (size(frame%beam_heights) < 1) then
         call fatal_error(error, 'beam_heights is empty: a frame has one beam at least', &
            subject='beam_heights')
      end if
      associate (columns => size(frame%column_places), beams => size(frame%beam_heights))
         call spread_values(frame%column_loads, 'column_loads', columns, 'columns', error)
         first = real(frame%beam_from, wp)
         call spread_values(first, 'beam_from', beams, 'beams', error)
         last = real(frame%beam_to, wp)
         call spread_values(last, 'beam_to', beams, 'beams', error)
      end associate
      frame%beam_from = nint(first)
      frame%beam_to = nint(last)
   end subroutine complete_frame_settings

   !> One value stands for all.
   pure subroutine spread_values(values, name, n, of_what, error)
      real(wp), allocatable, intent(inout) :: values(:)
      character(len=*), intent(in) :: name, of_what
      integer, intent(in) :: n
      type(error_type), allocatable, intent(inout) :: error
      integer :: i

      if (allocated(error)) return
      if (size(values) == n) return
      if (size(values) == 1) then
         values = [(values(1), i=1, n)]
      else
         call fatal_error(error, name//' has '//to_text(size(values))//' values for '// &
            to_text(n)//' '//of_what//': give one for all, or one for each', subject=name)
      end if
   end subroutine spread_values

   !> `error` is set when the frame cannot be built.
   pure subroutine check_frame_settings(frame, joint, sizes, error)
      !> The frame, complete
      type(frame_settings), intent(in) :: frame
      !> The joints, checked, and sizes of their columns
      type(tenon_settings), intent(in) :: joint
      type(tenon_sizes), intent(in) :: sizes
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: least
      integer :: i

      do i = 1, size(frame%column_places)
         call check_range(error, 'column_places', frame%column_places(i), -furthest, furthest, &
            ' mm')
         if (allocated(error)) return
         if (frame%column_loads(i) > 0.0_wp) then
            call check_size(error, 'column_load', frame%column_loads(i), joint%accept_sizes)
            if (allocated(error)) error%subject = 'column_loads'
         else
            call check_range(error, 'column_loads', frame%column_loads(i), 0.0_wp, &
               huge(1.0_wp), ' N')
         end if
         if (allocated(error)) return
      end do
      do i = 2, size(frame%column_places)
         if (frame%column_places(i) - frame%column_places(i - 1) > joint%length) cycle
         call fatal_error(error, 'column_places = '//to_text(frame%column_places(i - 1))//', '// &
            to_text(frame%column_places(i))//' mm are nearer than the columns are deep, '// &
            'length = '//to_text(joint%length)//' mm: places rise by more than that', &
            subject='column_places length')
         return
      end do
      least = shoe_height(joint) + 0.5_wp*joint%height &
         + max(joint%clearance_above, joint%clearance_below)
      if (.not. sizes%column_height > 2.0_wp*least) then
         call fatal_error(error, 'column_height = '//to_text(sizes%column_height)//' mm is too '// &
            'small for a beam: it must be above '//to_text(2.0_wp*least)//' mm', &
            subject='column_height')
         return
      end if
      do i = 1, size(frame%beam_heights)
         call check_range(error, 'beam_heights', frame%beam_heights(i), least, &
            sizes%column_height - least, ' mm')
         if (.not. allocated(error)) call check_beam(frame, joint, i, error)
         if (allocated(error)) return
      end do
      do i = 1, size(frame%column_places)
         if (any(frame%beam_from <= i .and. frame%beam_to >= i)) cycle
         call fatal_error(error, 'column '//to_text(i)//' at '// &
            to_text(frame%column_places(i))//' mm has no beam: leave it out, or change '// &
            'beam_from or beam_to', subject='column_places beam_from beam_to')
         return
      end do
   end subroutine check_frame_settings

   !> `error` is set when a beam has not two columns, or meets an earlier one in a column.
   pure subroutine check_beam(frame, joint, beam, error)
      type(frame_settings), intent(in) :: frame
      type(tenon_settings), intent(in) :: joint
      integer, intent(in) :: beam
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: least
      integer :: other

      associate (from => frame%beam_from, to => frame%beam_to, z => frame%beam_heights, &
            n => size(frame%column_places))
         if (from(beam) < 1 .or. from(beam) >= to(beam) .or. to(beam) > n) then
            call fatal_error(error, 'beam '//to_text(beam)//' goes from column '// &
               to_text(from(beam))//' to '//to_text(to(beam))//' (beam_from, beam_to): columns '// &
               'are numbered 1 to '//to_text(n)//', and a beam joins two at least', &
               subject='beam_from beam_to')
            return
         end if
         least = joint%height + 2.0_wp*max(joint%clearance_above, joint%clearance_below)
         do other = 1, beam - 1
            if (from(other) > to(beam) .or. to(other) < from(beam)) cycle
            if (abs(z(beam) - z(other)) > least) cycle
            call fatal_error(error, 'beam_heights = '//to_text(z(other))//', '// &
               to_text(z(beam))//' mm: beams '//to_text(other)//' and '//to_text(beam)// &
               ' meet in a column, where their axes must be more than '//to_text(least)// &
               ' mm apart', subject='beam_heights')
            return
         end do
      end associate
   end subroutine check_beam

end module asperity_solid_frame_settings
