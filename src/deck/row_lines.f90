!> Straight lines between rows of the law: how far they are from it, and where rows have to be.
module asperity_deck_row_lines
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   implicit none
   private
   public :: place_rows, points_between, line_errors

   !> More rows than any law that is allowed needs
   integer, parameter :: too_many_rows = 100000
   !> Points between two rows at which a line is compared with the law
   integer, parameter :: few = 16

contains

   !> Separations of the rows on the law, descending: each as far from the one before as the error
   !> of the line between them allows.
   pure subroutine place_rows(law, far, near, allowed, separation)
      !> The law
      type(compiled_law), intent(in) :: law
      !> The first and the last of them, mm
      real(wp), intent(in) :: far, near
      !> Relative error of a line
      real(wp), intent(in) :: allowed
      !> Result, mm
      real(wp), allocatable, intent(out) :: separation(:)
      real(wp), parameter :: precision = 1.0e-3_wp
      real(wp) :: good, bad, length

      separation = [far]
      length = 0.1_wp*law%properties%sigma
      do while (separation(size(separation)) > near .and. size(separation) < too_many_rows)
         associate (from => separation(size(separation)))
            good = 0.0_wp
            bad = length
            do while (good < from - near)
               if (.not. fits(from, bad)) exit
               good = min(bad, from - near)
               bad = 2.0_wp*bad
            end do
            do while (bad - good > precision*bad .and. good < from - near)
               length = 0.5_wp*(good + bad)
               if (fits(from, length)) then
                  good = length
               else
                  bad = length
               end if
            end do
            length = good
            separation = [separation, merge(near, from - good, good >= from - near)]
         end associate
      end do

   contains

      !> Whether a line of that length, or to the last row, is good enough.
      pure logical function fits(start, reached)
         real(wp), intent(in) :: start, reached
         real(wp), dimension(0:few) :: p, stiffness

         call evaluate_compiled_law(law, points_between(start, max(start - reached, near), few), &
            p, stiffness)
         fits = all(abs(line_errors([p(0), p(few)], p)) <= allowed)
      end function fits

   end subroutine place_rows

   !> So many equal steps from one separation to another.
   pure function points_between(from, to, steps) result(points)
      !> First and last, mm, and number of steps
      real(wp), intent(in) :: from, to
      integer, intent(in) :: steps
      real(wp) :: points(0:steps)
      integer :: i

      points = [(from + (to - from)*i/steps, i=0, steps)]
   end function points_between

   !> Smallest and largest relative error of the line between two rows, from the law at equal steps;
   !> between these, by the parabola through three of them.
   pure function line_errors(ends, p) result(extremes)
      !> Pressures of the two rows and of the law
      real(wp), intent(in) :: ends(2), p(0:)
      real(wp) :: extremes(2), e(0:size(p) - 1)
      integer :: i, n

      n = size(p) - 1
      e = [((ends(1) + (ends(2) - ends(1))*i/n)/p(i) - 1.0_wp, i=0, n)]
      extremes = [-summit(-e), summit(e)]
   end function line_errors

   !> Largest of some values of a smooth function.
   pure real(wp) function summit(e)
      real(wp), intent(in) :: e(:)
      real(wp) :: bend
      integer :: i

      ! at least 1 anyway, which warnings of gfortran -O3 do not see
      i = max(maxloc(e, 1), 1)
      summit = e(i)
      if (i == 1 .or. i == size(e)) return
      bend = 2.0_wp*e(i) - e(i - 1) - e(i + 1)
      if (bend > 0.0_wp) summit = e(i) + (e(i + 1) - e(i - 1))**2/(8.0_wp*bend)
   end function summit

end module asperity_deck_row_lines
