!> What a host that plays ABAQUS keeps of one call of UINTER.
module asperity_replay_abaqus_record
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_quiet_nan, ieee_value
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: no_opposite_surface
   implicit none
   private
   public :: host_record, new_host_record, poison_outputs, check_outputs

   !> Everything that UINTER was given and returned in one call.
   type :: host_record
      !> Step and total time at the end of the increment, s; its length, s
      real(wp) :: time(2) = 0.0_wp, dtime = 0.0_wp
      !> Relative position at the end and its increment, mm
      real(wp), allocatable :: rdisp(:), drdisp(:)
      !> Tractions, MPa, and their derivative by the relative motion, MPa/mm
      real(wp), allocatable :: stress(:), ddsddr(:, :)
      !> State variables
      real(wp), allocatable :: statev(:)
      !> Damping matrices, heat fluxes and their variations
      real(wp), allocatable :: dviscous(:, :), dstructural(:, :), ddsddt(:, :), ddfddr(:, :)
      real(wp) :: flux(2) = 0.0_wp, ddfddt(2, 2) = 0.0_wp
      !> Stored energy per area, total, N/mm
      real(wp) :: sed = 0.0_wp
      !> Frictional, plastic, viscous and creep dissipation per area in the increment, N/mm
      real(wp) :: sfd = 0.0_wp, spd = 0.0_wp, svd = 0.0_wp, scd = 0.0_wp
      !> Time step factor asked for; not below 1 unless a cut is wanted
      real(wp) :: pnewdt = 0.0_wp
      !> Flags of the interface
      integer :: lopenclose = -1, lstate = -1, lsdi = 0
      !> Calls of UINTER in this increment so far
      integer :: calls = 0
   end type host_record

contains

   !> Nothing opposite, and no past.
   pure subroutine new_host_record(record, ndir, nstatv)
      !> Result
      type(host_record), intent(out) :: record
      !> Components, 2 or 3, and length of STATEV
      integer, intent(in) :: ndir, nstatv

      allocate (record%rdisp(ndir), record%drdisp(ndir), record%stress(ndir), &
         record%ddsddr(ndir, ndir), record%dviscous(ndir, ndir), record%dstructural(ndir, ndir), &
         record%ddsddt(ndir, 2), record%ddfddr(2, ndir), record%statev(nstatv), source=0.0_wp)
      record%rdisp(1) = no_opposite_surface
   end subroutine new_host_record

   !> No number in what UINTER must set, so that what it leaves is seen.
   subroutine poison_outputs(record)
      !> The record before the call
      type(host_record), intent(inout) :: record
      real(wp) :: bad

      bad = ieee_value(1.0_wp, ieee_quiet_nan)
      record%dviscous = bad
      record%dstructural = bad
      record%flux = bad
      record%ddfddt = bad
      record%ddsddt = bad
      record%ddfddr = bad
      record%ddsddr = bad
      record%sfd = bad
      record%spd = bad
      record%svd = bad
      record%scd = bad
   end subroutine poison_outputs

   !> `error` is set when an output still holds the poison.
   subroutine check_outputs(record, error)
      !> The record after the call
      type(host_record), intent(in) :: record
      !> Set when UINTER broke its contract
      type(error_type), allocatable, intent(out) :: error

      if (any(ieee_is_nan(record%stress)) .or. any(ieee_is_nan(record%ddsddr)) &
         .or. any(ieee_is_nan(record%dviscous)) .or. any(ieee_is_nan(record%dstructural)) &
         .or. any(ieee_is_nan(record%flux)) .or. any(ieee_is_nan(record%ddfddt)) &
         .or. any(ieee_is_nan(record%ddsddt)) .or. any(ieee_is_nan(record%ddfddr)) &
         .or. any(ieee_is_nan([record%sed, record%sfd, record%spd, record%svd, record%scd]))) &
         call fatal_error(error, 'UINTER returned a number that is not one, or left an output '// &
         'unset, at overclosure = '//to_text(record%rdisp(1))//' mm', computation_error)
   end subroutine check_outputs

end module asperity_replay_abaqus_record
