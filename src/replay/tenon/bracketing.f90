!> Bracketing search for the zero of a monotone function, asked from outside: the caller evaluates
!> the function where the search says.
module asperity_replay_tenon_bracketing
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: root_search, new_root_search, advance_search

   !> State of one search.
   type :: root_search
      !> Where to evaluate next
      real(wp) :: at = 0.0_wp
      !> Whether the bracket is as small as it gets, and whether none was found
      logical :: done = .false., failed = .false.
      !> Direction in which the function rises, step to widen by, farthest distance searched
      real(wp), private :: rises = 1.0_wp, step = 1.0_wp, farthest = 1.0_wp, origin = 0.0_wp
      !> Ends of the bracket, with the function's values
      real(wp), private :: low = 0.0_wp, high = 0.0_wp, f_low = 0.0_wp, f_high = 0.0_wp
      logical, private :: has_low = .false., has_high = .false.
      !> Which end moved last
      integer, private :: moved = 0
   end type root_search

contains

   !> Search from a place on.
   pure function new_root_search(origin, step, farthest, rises) result(search)
      !> First place; first step; farthest distance
      real(wp), intent(in) :: origin, step, farthest
      !> Whether the function rises
      logical, intent(in) :: rises
      type(root_search) :: search

      search%at = origin
      search%origin = origin
      search%step = step
      search%farthest = farthest
      search%rises = merge(1.0_wp, -1.0_wp, rises)
   end function new_root_search

   !> Take the function's value at `search%at` and move on: widen until two signs are seen, then
   !> false position with halved ends (Illinois), and bisection now and then.
   pure subroutine advance_search(search, value)
      !> The search
      type(root_search), intent(inout) :: search
      !> Value at `search%at`
      real(wp), intent(in) :: value
      real(wp) :: f, width

      f = search%rises*value
      associate (s => search)
         if (f > 0.0_wp) then
            if (s%moved == 1 .and. s%has_low) s%f_low = 0.5_wp*s%f_low
            s%high = s%at
            s%f_high = f
            s%has_high = .true.
            s%moved = 1
         else
            if (s%moved == -1 .and. s%has_high) s%f_high = 0.5_wp*s%f_high
            s%low = s%at
            s%f_low = f
            s%has_low = .true.
            s%moved = -1
         end if
         if (.not. (s%has_low .and. s%has_high)) then
            s%at = s%at - sign(s%step, f)
            s%step = 2.0_wp*s%step
            s%failed = abs(s%at - s%origin) > s%farthest
            return
         end if
         width = s%high - s%low
         s%done = abs(width) <= 4.0_wp*spacing(max(abs(s%low), abs(s%high), tiny(1.0_wp)))
         s%at = s%low - s%f_low*(width/(s%f_high - s%f_low))
         if (.not. (s%at > min(s%low, s%high) .and. s%at < max(s%low, s%high))) &
            s%at = s%low + 0.5_wp*width
      end associate
   end subroutine advance_search

end module asperity_replay_tenon_bracketing
