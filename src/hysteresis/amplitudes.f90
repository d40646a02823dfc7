!> Cycles by amplitude: strength of first, second and third cycles (EN 12512).
module asperity_hysteresis_amplitudes
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_hysteresis_types, only: held_share, hysteresis_amplitude, hysteresis_cycle, &
      negative_side, positive_side, round_off_share
   implicit none
   private
   public :: find_amplitudes, three_cycle_amplitude

contains

   !> Group the cycles of each side. A cycle of the skeleton begins an amplitude; those that follow
   !> and reach as far, within the tolerance, are its second, third and further cycles. Smaller
   !> ones, such as the trailing cycles of CUREE, belong to none.
   pure subroutine find_amplitudes(cycles, tolerance, amplitudes)
      !> Cycles with their peaks, and which of them are in the skeleton
      type(hysteresis_cycle), intent(in) :: cycles(:)
      !> Share by which an amplitude may differ
      real(wp), intent(in) :: tolerance
      !> The amplitudes, the positive side first, from small to large
      type(hysteresis_amplitude), allocatable, intent(out) :: amplitudes(:)
      integer :: i, n, side

      allocate (amplitudes(count(cycles%in_skeleton(positive_side)) &
         + count(cycles%in_skeleton(negative_side))))
      n = 0
      do side = positive_side, negative_side
         do i = 1, size(cycles)
            if (cycles(i)%in_skeleton(side)) then
               n = n + 1
               amplitudes(n)%side = side
            else
               if (cycles(i)%peak(side) == 0 .or. n == 0) cycle
               if (amplitudes(n)%side /= side) cycle
               associate (first => amplitudes(n)%displacement(1))
                  if (abs(cycles(i)%displacement(side) - first) > tolerance*abs(first)) cycle
               end associate
            end if
            call append(amplitudes(n), i, cycles(i)%displacement(side), cycles(i)%force(side))
         end do
      end do
   end subroutine find_amplitudes

   !> Append a cycle.
   pure subroutine append(amplitude, number, displacement, force)
      type(hysteresis_amplitude), intent(inout) :: amplitude
      integer, intent(in) :: number
      real(wp), intent(in) :: displacement, force

      amplitude%cycles = amplitude%cycles + 1
      if (amplitude%cycles > size(amplitude%cycle)) return
      amplitude%cycle(amplitude%cycles) = number
      amplitude%displacement(amplitude%cycles) = displacement
      amplitude%force(amplitude%cycles) = force
      if (amplitude%cycles < size(amplitude%cycle)) return
      ! only of a first force in the direction of displacement
      associate (f => amplitude%force)
         if (f(1)*amplitude%displacement(1) > 0.0_wp) amplitude%impairment = 1.0_wp - f(3)/f(1)
      end associate
   end subroutine append

   !> Largest amplitude of a side, unsigned, up to the ultimate displacement, whose third cycle has
   !> at least 0.8 of the force of the first; `none` if there is none.
   pure real(wp) function three_cycle_amplitude(amplitudes, side, ultimate) result(largest)
      !> All amplitudes
      type(hysteresis_amplitude), intent(in) :: amplitudes(:)
      !> The side
      integer, intent(in) :: side
      !> Ultimate displacement, unsigned
      real(wp), intent(in) :: ultimate
      integer :: i

      largest = none
      do i = 1, size(amplitudes)
         if (amplitudes(i)%side /= side .or. amplitudes(i)%cycles < 3) cycle
         associate (f => amplitudes(i)%force, x => abs(amplitudes(i)%displacement(1)))
            if (x > (1.0_wp + round_off_share)*ultimate) cycle
            if (f(3)*f(1) >= held_share*f(1)**2 .and. abs(f(1)) > 0.0_wp) largest = x
         end associate
      end do
   end function three_cycle_amplitude

end module asperity_hysteresis_amplitudes
