!> What a host that plays ABAQUS keeps of one call of UINTER.
module asperity_replay_abaqus_record
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: no_opposite_surface
   implicit none
   private
   public :: host_record, new_host_record, poison_outputs, check_outputs

   !> Outputs that a UINTER may leave: those of damping and heat matter in procedures that have
   !> them, energies in output alone
   character(len=*), parameter, public :: optional_outputs(*) = [character(len=11) :: &
      'DVISCOUS', 'DSTRUCTURAL', 'DDFDDT', 'DDSDDT', 'DDFDDR', 'SFD', 'SPD', 'SVD', 'SCD']

   !> Not a number, with bits that no computation makes but one with it
   integer(int64), parameter :: poison_bits = int(z'7FF8617370657269', int64)

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
      !> Which of `optional_outputs` the call left unset
      logical :: unset(size(optional_outputs)) = .false.
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

   !> Poison in what UINTER has to set, so that what it leaves is seen. STRESS, FLUX, SED and STATEV
   !> come in with the values at the start of the increment.
   pure subroutine poison_outputs(record)
      !> The record before the call
      type(host_record), intent(inout) :: record
      real(wp) :: poison

      poison = transfer(poison_bits, poison)
      record%dviscous = poison
      record%dstructural = poison
      record%ddfddt = poison
      record%ddsddt = poison
      record%ddfddr = poison
      record%ddsddr = poison
      record%sfd = poison
      record%spd = poison
      record%svd = poison
      record%scd = poison
   end subroutine poison_outputs

   !> What UINTER left of its optional outputs is noted and counts as zero. `error` is set when it
   !> left DDSDDR, or when an output is no number, and names it.
   pure subroutine check_outputs(record, error)
      !> The record after the call
      type(host_record), intent(inout) :: record
      !> Set when UINTER broke its contract
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: names

      associate (r => record)
         ! what is not finite stays so in a sum
         if (is_finite(sum(r%stress) + sum(r%ddsddr) + sum(r%dviscous) + sum(r%dstructural) &
            + sum(r%flux) + sum(r%ddfddt) + sum(r%ddsddt) + sum(r%ddfddr) + r%sed + r%sfd + r%spd &
            + r%svd + r%scd)) return
         r%unset = [any(is_poison(r%dviscous)), any(is_poison(r%dstructural)), &
            any(is_poison(r%ddfddt)), any(is_poison(r%ddsddt)), any(is_poison(r%ddfddr)), &
            is_poison([r%sfd, r%spd, r%svd, r%scd])]
         names = entries('DDSDDR', is_poison(r%ddsddr))
         if (names /= '') then
            call fatal_error(error, 'UINTER left'//names//' unset at '//place(r), &
               computation_error)
            return
         end if
         call clear(r%dviscous)
         call clear(r%dstructural)
         call clear(r%ddfddt)
         call clear(r%ddsddt)
         call clear(r%ddfddr)
         call clear(r%sfd)
         call clear(r%spd)
         call clear(r%svd)
         call clear(r%scd)
         names = entries('STRESS', spread(.not. is_finite(r%stress), 2, 1))// &
            entries('DDSDDR', .not. is_finite(r%ddsddr))// &
            entries('DVISCOUS', .not. is_finite(r%dviscous))// &
            entries('DSTRUCTURAL', .not. is_finite(r%dstructural))// &
            entries('FLUX', spread(.not. is_finite(r%flux), 2, 1))// &
            entries('DDFDDT', .not. is_finite(r%ddfddt))// &
            entries('DDSDDT', .not. is_finite(r%ddsddt))// &
            entries('DDFDDR', .not. is_finite(r%ddfddr))// &
            one('SED', r%sed)//one('SFD', r%sfd)//one('SPD', r%spd)//one('SVD', r%svd)// &
            one('SCD', r%scd)
         if (names /= '') call fatal_error(error, 'UINTER computed'//names// &
            ', which is not a finite number, at '//place(r), computation_error)
      end associate
   end subroutine check_outputs

   !> Whether a number is the poison.
   elemental logical function is_poison(value)
      real(wp), intent(in) :: value

      is_poison = transfer(value, poison_bits) == poison_bits
   end function is_poison

   !> Zero in place of poison.
   elemental subroutine clear(value)
      real(wp), intent(inout) :: value

      if (is_poison(value)) value = 0.0_wp
   end subroutine clear

   !> Entries of an array as ` NAME(1,2), ...`, with one index where it has one column; empty for
   !> none, and the name alone for all.
   pure function entries(name, chosen) result(text)
      character(len=*), intent(in) :: name
      logical, intent(in) :: chosen(:, :)
      character(len=:), allocatable :: text
      integer :: i, j

      text = ''
      if (all(chosen)) then
         text = ' '//name
         return
      end if
      do i = 1, size(chosen, 1)
         do j = 1, size(chosen, 2)
            if (.not. chosen(i, j)) cycle
            text = text//' '//name//'('//to_text(i)
            if (size(chosen, 2) > 1) text = text//','//to_text(j)
            text = text//')'
         end do
      end do
   end function entries

   !> A number by its name where it is not finite.
   pure function one(name, value) result(text)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value
      character(len=:), allocatable :: text

      text = entries(name, reshape([.not. is_finite(value)], [1, 1]))
   end function one

   !> Where it was.
   pure function place(record) result(text)
      type(host_record), intent(in) :: record
      character(len=:), allocatable :: text

      text = 'overclosure = '//to_text(record%rdisp(1))//' mm'
   end function place

end module asperity_replay_abaqus_record
