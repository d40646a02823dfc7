!> Tells of many points with the same extreme height, far from all others: a number that marks
!> missing points.
module asperity_height_map_marker
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: add_note, height_map
   implicit none
   private
   public :: note_marker

   !> Points of the same height that are many
   integer, parameter :: many = 2
   !> Distance to the other heights, over their range; of a height of 0, which marks more often, if
   !> it is as much larger than that of the next ones
   real(wp), parameter :: far = 0.5_wp, near_zero = 0.2_wp, levels = 3.0_wp
   !> Figures that a number of a file has at most
   integer, parameter :: figures = 15

contains

   !> Add a note if there is such a height.
   subroutine note_marker(map, factor)
      !> The map
      type(height_map), intent(inout) :: map
      !> mm of a number of a text, which `--missing-value` can name; of another format 0
      real(wp), intent(in) :: factor
      real(wp) :: extreme(2), next(2)
      integer :: points(2)

      call look(map%heights, extreme, next, points)
      if (.not. next(1) < next(2)) return
      call tell(1, 'lowest', 'below')
      call tell(2, 'highest', 'above')

   contains

      subroutine tell(side, which, where)
         integer, intent(in) :: side
         character(len=*), intent(in) :: which, where
         character(len=:), allocatable :: value, remedy
         real(wp) :: gap, level

         gap = abs(extreme(side) - next(side))
         if (points(side) < many) return
         if (gap <= far*(next(2) - next(1))) then
            if (abs(extreme(side)) > 0.0_wp .or. gap <= near_zero*(next(2) - next(1))) return
            ! the levels of a coarse map are as far from each other
            if (side == 1) then
               level = minval(map%heights, mask=map%heights > next(1))
            else
               level = maxval(map%heights, mask=map%heights < next(2))
            end if
            if (gap <= levels*abs(level - next(side))) return
         end if
         if (factor > 0.0_wp) then
            value = to_text(extreme(side)/factor, figures)
            remedy = '--missing-value '//value//' says so'
         else
            value = to_text(extreme(side), figures)//' mm'
            remedy = 'mark them as missing in the file'
         end if
         call add_note(map, to_text(points(side))//' points have the same '//which// &
            ' height, '//value//', '//to_text(gap, 4)//' mm '//where// &
            ' all others: if this number marks missing points, '//remedy//'.')
      end subroutine tell

   end subroutine note_marker

   !> Lowest and highest height, how many points have them, and the next ones.
   pure subroutine look(heights, extreme, next, points)
      real(wp), intent(in) :: heights(:, :)
      real(wp), intent(out) :: extreme(2), next(2)
      integer, intent(out) :: points(2)
      integer :: i, j

      extreme = [none, -none]
      next = extreme
      points = 0
      do j = 1, size(heights, 2)
         do i = 1, size(heights, 1)
            associate (z => heights(i, j))
               if (z >= none) cycle
               if (z < extreme(1)) then
                  next(1) = extreme(1)
                  extreme(1) = z
                  points(1) = 1
               else if (z <= extreme(1)) then
                  points(1) = points(1) + 1
               else
                  next(1) = min(next(1), z)
               end if
               if (z > extreme(2)) then
                  next(2) = extreme(2)
                  extreme(2) = z
                  points(2) = 1
               else if (z >= extreme(2)) then
                  points(2) = points(2) + 1
               else
                  next(2) = max(next(2), z)
               end if
            end associate
         end do
      end do
   end subroutine look

end module asperity_height_map_marker
