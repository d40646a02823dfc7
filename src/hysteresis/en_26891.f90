!> Slips, slip moduli and largest force of EN 26891 (ISO 6891), as the standard is commonly cited.
module asperity_hysteresis_en_26891
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_curves, only: cut_off, displacement_at, outward, peak_of
   use asperity_hysteresis_types, only: en_26891_numbers, hysteresis_settings, &
      hysteresis_skeleton, side_sign
   implicit none
   private
   public :: evaluate_en_26891

   !> Displacement in mm up to which the largest force counts
   real(wp), parameter :: largest_slip = 15.0_wp
   !> Shares of the estimated force between which a test is unloaded
   real(wp), parameter :: upper_share = 0.4_wp, lower_share = 0.1_wp
   !> Shares of the largest force at which slips are given
   real(wp), parameter :: service_share = 0.6_wp, late_share = 0.8_wp
   !> It is an unloading if it leaves less than this share of the force before, which is at least
   !> this share of the largest: less is noise
   real(wp), parameter :: unloaded_share = 0.5_wp, least_share = 0.15_wp
   !> ... and that of the standard, by a quarter, if it leaves a share within these bounds
   real(wp), parameter :: standard_shares(2) = [0.15_wp, 0.35_wp]
   !> Round-off of forces that are to be reached
   real(wp), parameter :: round_off = 1.0e-9_wp

contains

   !> Evaluate a monotonic test.
   pure subroutine evaluate_en_26891(displacement, force, side, settings, skeleton, numbers)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> The side to which it goes
      integer, intent(in) :: side
      !> The estimated force, and what a millimetre is
      type(hysteresis_settings), intent(in) :: settings
      !> Skeleton of that side
      type(hysteresis_skeleton), intent(in) :: skeleton
      !> What was found
      type(en_26891_numbers), intent(out) :: numbers
      real(wp), allocatable :: x(:), f(:), record_x(:), record_f(:)
      real(wp) :: reloaded
      logical :: is_cut
      integer :: peak, top, bottom

      if (is_none(skeleton%peak_force)) return
      associate (s => side_sign(side), n => numbers)
         call outward(s, skeleton, x, f)
         if (.not. is_none(settings%millimetre)) &
            call cut_off(largest_slip*settings%millimetre, x, f, is_cut)
         peak = peak_of(f)
         if (peak == 0) return
         n%peak_displacement = s*x(peak)
         n%peak_force = s*f(peak)
         allocate (record_x, source=s*displacement)
         allocate (record_f, source=s*force)
         call find_unloading(record_f, least_share*f(peak), top, bottom)
         call estimate(settings, n%peak_force*s, record_f, top, bottom, n)

         n%slip_at_10_percent = s*slip_at(x, f, lower_share*n%estimated_force)
         n%initial_slip = s*slip_at(x, f, upper_share*n%estimated_force)
         n%slip_at_60_percent = s*slip_at(x, f, service_share*f(peak))
         n%slip_at_80_percent = s*slip_at(x, f, late_share*f(peak))
         if (f(peak) < upper_share*n%estimated_force*(1.0_wp - round_off)) then
            ! never loaded so far
            n%slip_at_10_percent = none
            n%initial_slip = none
            n%estimated_force = s*n%estimated_force
            return
         end if
         n%modified_initial_slip = 4.0_wp/3.0_wp*(n%initial_slip - n%slip_at_10_percent)
         n%joint_settlement = n%initial_slip - n%modified_initial_slip
         if (s*n%initial_slip > 0.0_wp) &
            n%initial_slip_modulus = upper_share*n%estimated_force/(s*n%initial_slip)
         if (s*n%modified_initial_slip > 0.0_wp) &
            n%slip_modulus = upper_share*n%estimated_force/(s*n%modified_initial_slip)
         if (top > 0) then
            call find_elastic_slip(record_x, record_f, top, bottom, n%estimated_force, &
               n%elastic_slip, reloaded)
            if (.not. is_none(reloaded)) then
               n%elastic_slip = s*n%elastic_slip
               n%modified_slip_at_60_percent = n%slip_at_60_percent - s*reloaded &
                  + n%modified_initial_slip
               n%modified_slip_at_80_percent = n%slip_at_80_percent - s*reloaded &
                  + n%modified_initial_slip
            end if
         end if
         n%estimated_force = s*n%estimated_force
      end associate
   end subroutine evaluate_en_26891

   !> Displacement at which a force is first reached.
   pure real(wp) function slip_at(x, f, force)
      real(wp), intent(in) :: x(0:), f(0:), force

      slip_at = displacement_at(x, f, (1.0_wp - round_off)*force)
   end function slip_at

   !> First unloading from which the record comes back to more force than before; zero for none.
   pure subroutine find_unloading(f, least, top, bottom)
      !> Force, positive outwards, and the least that it is unloaded from
      real(wp), intent(in) :: f(:), least
      !> Samples of the largest force before, and of the least one
      integer, intent(out) :: top, bottom
      integer :: i

      top = 1
      bottom = 1
      do i = 2, size(f)
         if (f(i) > f(top)) then
            if (f(top) >= least .and. f(bottom) < unloaded_share*f(top)) return
            top = i
            bottom = i
         else if (f(i) < f(bottom)) then
            bottom = i
         end if
      end do
      top = 0
   end subroutine find_unloading

   !> The estimated force, unsigned.
   pure subroutine estimate(settings, peak_force, f, top, bottom, numbers)
      type(hysteresis_settings), intent(in) :: settings
      real(wp), intent(in) :: peak_force, f(:)
      integer, intent(in) :: top, bottom
      type(en_26891_numbers), intent(inout) :: numbers

      numbers%estimated_force = peak_force
      numbers%estimated_by = 'peak_force'
      if (top > 0) then
         associate (left => f(bottom)/f(top))
            if (left >= standard_shares(1) .and. left <= standard_shares(2)) then
               numbers%estimated_force = f(top)/upper_share
               numbers%estimated_by = 'unloading'
            end if
         end associate
      end if
      if (is_none(settings%estimated_force)) return
      numbers%estimated_force = settings%estimated_force
      numbers%estimated_by = 'given'
   end subroutine estimate

   !> v_e and v_24; without a value if the record does not come back to 0.4 of the estimated force.
   !> Where it is not unloaded to 0.1 of it, its lowest point takes the place of v_11 and v_21.
   pure subroutine find_elastic_slip(x, f, top, bottom, estimated, elastic, reloaded)
      real(wp), intent(in) :: x(:), f(:), estimated
      integer, intent(in) :: top, bottom
      real(wp), intent(out) :: elastic, reloaded
      real(wp) :: upper, lower, held, v_11, v_21
      integer :: i, back

      elastic = none
      reloaded = none
      upper = (1.0_wp - round_off)*upper_share*estimated
      lower = lower_share*estimated
      if (f(top) < upper) return
      ! the record may creep while it holds the force
      held = maxval(x(top:bottom))
      v_11 = x(bottom)
      do i = top, bottom - 1
         if (.not. f(i + 1) <= lower) cycle
         v_11 = crossing(x(i:i + 1), f(i:i + 1), lower)
         exit
      end do
      do back = bottom, size(f)
         if (f(back) >= upper) exit
      end do
      if (back > size(f)) return
      v_21 = x(bottom)
      do i = back - 1, bottom, -1
         if (.not. f(i) <= lower) cycle
         v_21 = crossing(x(i:i + 1), f(i:i + 1), lower)
         exit
      end do
      reloaded = x(back)
      if (back > bottom) reloaded = crossing(x(back - 1:back), f(back - 1:back), upper)
      elastic = 2.0_wp/3.0_wp*(held + reloaded - v_11 - v_21)
   end subroutine find_elastic_slip

   !> Displacement at which a straight line has a force.
   pure real(wp) function crossing(x, f, force)
      real(wp), intent(in) :: x(2), f(2), force

      crossing = x(2)
      if (abs(f(2) - f(1)) > 0.0_wp) crossing = x(1) + (x(2) - x(1))*((force - f(1))/(f(2) - f(1)))
   end function crossing

end module asperity_hysteresis_en_26891
