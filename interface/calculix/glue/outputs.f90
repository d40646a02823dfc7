!> What UINTER returns beside states and wishes. Everything is zero before a call; poisoned, it is
!> no number, so that what UINTER never sets shows.
module asperity_calculix_outputs
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_quiet_nan, ieee_value
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: outputs_type, new_outputs, unset_outputs, optional_left, note_optional

   !> Named as UINTER's arguments.
   type :: outputs_type
      real(wp) :: stress(3) = 0.0_wp, ddsddr(3, 3) = 0.0_wp
      real(wp) :: dviscous(3, 3) = 0.0_wp, dstructural(3, 3) = 0.0_wp
      real(wp) :: ddfddt(2, 2) = 0.0_wp, ddsddt(3, 2) = 0.0_wp, ddfddr(2, 3) = 0.0_wp
      real(wp) :: sfd = 0.0_wp, spd = 0.0_wp, svd = 0.0_wp, scd = 0.0_wp
   end type outputs_type

   !> What a static step without heat does without
   character(len=11), parameter :: optional_names(9) = [character(len=11) :: 'DVISCOUS', &
      'DSTRUCTURAL', 'DDFDDT', 'DDSDDT', 'DDFDDR', 'SFD', 'SPD', 'SVD', 'SCD']
   ! CalculiX' routines have no argument that could carry it
   !> Which of them were left unset in some call
   logical :: left(size(optional_names)) = .false.

contains

   !> What goes into a call.
   pure function new_outputs(stress, poisoned) result(outputs)
      !> Stresses at the start of the increment, which UINTER may use
      real(wp), intent(in) :: stress(3)
      !> Fill the others with what is no number
      logical, intent(in) :: poisoned
      type(outputs_type) :: outputs
      real(wp) :: none

      if (poisoned) then
         none = ieee_value(none, ieee_quiet_nan)
         outputs = outputs_type(stress, none, none, none, none, none, none, none, none, none, none)
      end if
      outputs%stress = stress
   end function new_outputs

   !> The names of what had to be set in a poisoned call and was not, each after a blank. A stress
   !> is unset when its face moved and it came back as it went in, from two different values.
   pure function unset_outputs(outputs, again, start, drdisp) result(names)
      !> Of a call, and of one that began with other stresses
      type(outputs_type), intent(in) :: outputs, again
      !> Stresses that the two began with (component, call)
      real(wp), intent(in) :: start(3, 2)
      !> Motion of the increment
      real(wp), intent(in) :: drdisp(3)
      character(len=160) :: names
      integer :: i, j

      names = ''
      do i = 1, 3
         if (ieee_is_nan(outputs%stress(i)) .or. (abs(drdisp(i)) > 0.0_wp &
            .and. .not. abs(outputs%stress(i) - start(i, 1)) > 0.0_wp &
            .and. .not. abs(again%stress(i) - start(i, 2)) > 0.0_wp)) &
            names = trim(names)//' STRESS('//achar(iachar('0') + i)//')'
      end do
      do i = 1, 3
         do j = 1, 3
            if (ieee_is_nan(outputs%ddsddr(i, j))) names = trim(names)//' DDSDDR('// &
               achar(iachar('0') + i)//','//achar(iachar('0') + j)//')'
         end do
      end do
   end function unset_outputs

   !> Note which of the optional ones a poisoned call left unset; they count as zero.
   subroutine note_optional(outputs)
      !> Of a call
      type(outputs_type), intent(inout) :: outputs
      logical :: unset(size(optional_names))
      integer :: i

      unset = [any(ieee_is_nan(outputs%dviscous)), any(ieee_is_nan(outputs%dstructural)), &
         any(ieee_is_nan(outputs%ddfddt)), any(ieee_is_nan(outputs%ddsddt)), &
         any(ieee_is_nan(outputs%ddfddr)), ieee_is_nan(outputs%sfd), ieee_is_nan(outputs%spd), &
         ieee_is_nan(outputs%svd), ieee_is_nan(outputs%scd)]
      do i = 1, size(unset)
         if (.not. unset(i)) cycle
         !$omp atomic write
         left(i) = .true.
      end do
      if (unset(6)) outputs%sfd = 0.0_wp
      if (unset(7)) outputs%spd = 0.0_wp
      if (unset(8)) outputs%svd = 0.0_wp
      if (unset(9)) outputs%scd = 0.0_wp
   end subroutine note_optional

   !> The names of the optional ones that some poisoned call left unset, each after a blank.
   function optional_left() result(names)
      character(len=160) :: names
      integer :: i

      names = ''
      do i = 1, size(left)
         if (left(i)) names = trim(names)//' '//optional_names(i)
      end do
   end function optional_left

end module asperity_calculix_outputs
