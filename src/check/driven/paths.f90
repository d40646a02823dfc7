!> Motions that a routine is driven along.
module asperity_check_driven_paths
   use asperity_base_kinds, only: wp
   use asperity_check_driven_point, only: has_surface
   use asperity_check_settings, only: check_settings
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: motion_sizes, sizes_of, main_path, path_of

   !> How far a point moves, mm, and how long an increment is, s.
   type :: motion_sizes
      real(wp) :: overclosure = 0.0_wp, gap = 0.0_wp, slip = 0.0_wp, dtime = 0.0_wp
   end type motion_sizes

contains

   !> Sizes of the motion: those of the settings, or of their path where it goes so far.
   pure type(motion_sizes) function sizes_of(settings) result(sizes)
      !> The settings
      type(check_settings), intent(in) :: settings
      real(wp) :: deepest, widest, longest
      integer :: i

      sizes = motion_sizes(settings%largest_overclosure, settings%largest_gap, &
         settings%largest_slip, settings%time_increment)
      if (.not. allocated(settings%path%time)) return
      deepest = 0.0_wp
      widest = 0.0_wp
      do i = 1, size(settings%path%time)
         if (.not. has_surface(settings%path%overclosure(i))) cycle
         deepest = max(deepest, settings%path%overclosure(i))
         widest = max(widest, -settings%path%overclosure(i))
      end do
      longest = maxval(abs(settings%path%slip))
      if (deepest > 0.0_wp) sizes%overclosure = deepest
      if (widest > 0.0_wp) sizes%gap = widest
      if (longest > 0.0_wp) sizes%slip = longest
   end function sizes_of

   !> The user's path, or ours: from a gap into contact, slide, back, diagonally and on while
   !> parting, out with slip, and press again.
   pure type(motion_path) function main_path(settings) result(path)
      !> The settings
      type(check_settings), intent(in) :: settings
      ! Shares of the largest overclosure (gap where negative) and of the largest slip. No two
      ! neighbours alike in slip while open, so that what an open branch leaves is seen
      real(wp), parameter :: closure(27) = [-1.0_wp, -0.5_wp, 0.1_wp, 0.4_wp, 0.7_wp, 1.0_wp, &
         1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 0.9_wp, 0.8_wp, &
         0.6_wp, 0.3_wp, 0.1_wp, -0.2_wp, -0.6_wp, -1.0_wp, -0.4_wp, 0.2_wp, 0.5_wp, 0.8_wp, 0.6_wp]
      real(wp), parameter :: slip_1(27) = [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
         0.02_wp, 0.1_wp, 0.35_wp, 1.0_wp, 0.95_wp, 0.6_wp, 0.0_wp, -0.3_wp, -0.25_wp, -0.1_wp, &
         0.1_wp, 0.15_wp, 0.2_wp, 0.3_wp, 0.33_wp, 0.3_wp, 0.2_wp, 0.1_wp, 0.0_wp, 0.2_wp, 0.6_wp]
      real(wp), parameter :: slip_2(27) = [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
         0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.05_wp, 0.2_wp, &
         0.4_wp, 0.45_wp, 0.5_wp, 0.6_wp, 0.5_wp, 0.45_wp, 0.4_wp, 0.5_wp, 0.6_wp, 0.55_wp, 0.3_wp]
      type(motion_sizes) :: sizes

      if (allocated(settings%path%time)) then
         path = settings%path
         return
      end if
      sizes = sizes_of(settings)
      path = path_of(sizes, closure, slip_1, slip_2)
   end function main_path

   !> A path from shares of the sizes; negative closures are shares of the gap.
   pure type(motion_path) function path_of(sizes, closure, slip_1, slip_2) result(path)
      !> The sizes
      type(motion_sizes), intent(in) :: sizes
      !> Shares; no slip in the second direction when absent
      real(wp), intent(in) :: closure(:), slip_1(:)
      real(wp), intent(in), optional :: slip_2(:)
      integer :: i, n

      n = size(closure)
      allocate (path%time(n), path%overclosure(n))
      allocate (path%slip(2, n), source=0.0_wp)
      do i = 1, n
         path%time(i) = sizes%dtime*i
         path%overclosure(i) = closure(i)*sizes%overclosure
         if (closure(i) < 0.0_wp) path%overclosure(i) = closure(i)*sizes%gap
         path%slip(1, i) = slip_1(i)*sizes%slip
         if (present(slip_2)) path%slip(2, i) = slip_2(i)*sizes%slip
      end do
   end function path_of

end module asperity_check_driven_paths
