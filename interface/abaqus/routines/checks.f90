!> What UINTER and VUINTER check before they compute: sizes that the deck sets, a STATEV that only
!> they write to, and numbers that a host gone wrong may pass.
module asperity_abaqus_checks
   use asperity_abaqus_statev, only: n_statev, state_elastic_slip_2, state_grain_turn, &
      state_largest_closure, state_motion_share, state_overclosure, state_pressure, state_status, &
      state_validity, state_warned
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_below
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_slip, status_unset
   use asperity_law_validity, only: all_flags
   implicit none
   private
   public :: check_sizes, check_statev, computable, sizes_are_computable

   !> Larger numbers than this are a host gone wrong
   real(wp), parameter, public :: largest = 1.0e30_wp

contains

   !> Refuse what would be read or written out of bounds.
   pure subroutine check_sizes(nstatv, needed, ndir, error)
      !> Number of state variables, and of those that the properties need
      integer, intent(in) :: nstatv, needed
      !> Number of components
      integer, intent(in) :: ndir
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      if (nstatv < needed) then
         call fatal_error(error, 'DEPVAR = '//to_text(nstatv)//' is too small: give DEPVAR = '// &
            to_text(needed)//' on *SURFACE INTERACTION')
      else if (ndir /= 2 .and. ndir /= 3) then
         call fatal_error(error, 'NDIR = '//to_text(ndir)//' is not allowed: it must be 2 or 3')
      end if
   end subroutine check_sizes

   !> Refuse a STATEV that is not ours.
   pure subroutine check_statev(statev, error)
      !> As many slots as the properties need, all finite
      real(wp), intent(in), contiguous :: statev(:)
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error

      if (statev(state_status) < status_unset .or. statev(state_status) > status_slip &
            .or. abs(statev(state_status) - aint(statev(state_status))) > 0.0_wp) then
         call fatal_error(error, 'STATEV(1) = '//to_text(statev(state_status))//' is no '// &
            'contact status ('//to_text(status_unset)//' to '//to_text(status_slip)// &
            '): STATEV must be zero at the start, and nothing else may '// &
            'write to it')
      else if (statev(state_pressure) < 0.0_wp .or. any(statev(state_validity:state_warned) &
            < 0.0_wp) .or. any(statev(state_validity:state_warned) > all_flags)) then
         call fatal_error(error, 'STATEV(3), (10) or (11) = '//to_text(statev(state_pressure))// &
            ', '//to_text(statev(state_validity))//', '//to_text(statev(state_warned))// &
            ' is no pressure or sum of flags: nothing else may write to STATEV')
      else if (statev(state_largest_closure) < statev(state_overclosure)) then
         call fatal_error(error, 'STATEV(7) = '//to_text(statev(state_largest_closure))// &
            ' is below STATEV(2) = '//to_text(statev(state_overclosure))//': the largest '// &
            'closure is the present one or more; nothing else may write to STATEV')
      else if (size(statev) > n_statev) then
         if (statev(state_motion_share) < 0.0_wp .or. statev(state_motion_share) > 1.0_wp) &
            call fatal_error(error, 'STATEV(12) = '//to_text(statev(state_motion_share))// &
            ' is no share of motion, 0 to 1: nothing else may write to STATEV')
      end if
   end subroutine check_statev

   !> Whether pressure, energy, slips and turn are far from overflow.
   pure logical function sizes_are_computable(statev)
      !> As many slots as the properties need, all finite
      real(wp), intent(in), contiguous :: statev(:)

      sizes_are_computable = all(abs(statev(state_pressure:state_elastic_slip_2)) < largest)
      if (sizes_are_computable .and. size(statev) > n_statev) &
         sizes_are_computable = all(abs(statev(state_grain_turn:)) < largest)
   end function sizes_are_computable

   !> Finite, and far from overflow.
   pure logical function computable(values)
      !> Numbers of the host
      real(wp), intent(in), contiguous :: values(:)

      computable = all_below(values, largest)
   end function computable

end module asperity_abaqus_checks
