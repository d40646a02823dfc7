!> Records whose envelope is known in closed form: a joint that softens, driven along the programmes
!> of tests.
!>
!> The backbone is F (x/p) exp(1 - x/p), largest, F, at x = p. Within what it has reached the joint
!> is elastic with a gap: it unloads along a straight line, then carries nothing, and comes back the
!> same way. What it does first on each side is the backbone, whatever the programme.
module backbone_models
   use asperity_base_kinds, only: wp
   use hysteresis_models, only: record_type
   implicit none
   private
   public :: backbone_type, backbone_force, backbone_area, backbone_fall, driven, programme_turns

   !> A joint, alike on both sides.
   type :: backbone_type
      !> Largest force and its displacement
      real(wp) :: force = 1.0_wp, displacement = 1.0_wp
      !> Stiffness of unloading over the initial one
      real(wp) :: unloading = 1.0_wp
   end type backbone_type

contains

   !> Force of the backbone.
   pure elemental real(wp) function backbone_force(joint, x)
      type(backbone_type), intent(in) :: joint
      real(wp), intent(in) :: x

      backbone_force = joint%force*(x/joint%displacement)*exp(1.0_wp - x/joint%displacement)
   end function backbone_force

   !> Area below the backbone up to some displacement.
   pure real(wp) function backbone_area(joint, x)
      type(backbone_type), intent(in) :: joint
      real(wp), intent(in) :: x

      associate (u => x/joint%displacement)
         backbone_area = joint%force*joint%displacement*exp(1.0_wp) &
            *(1.0_wp - (1.0_wp + u)*exp(-u))
      end associate
   end function backbone_area

   !> Displacement at which it has a share of its largest force, before or past the peak, by
   !> Newton's method.
   pure real(wp) function backbone_fall(joint, share, past)
      type(backbone_type), intent(in) :: joint
      real(wp), intent(in) :: share
      logical, intent(in) :: past
      real(wp) :: u
      integer :: i

      u = merge(2.0_wp, share/exp(1.0_wp), past)
      do i = 1, 60
         u = u - (u*exp(1.0_wp - u) - share)/((1.0_wp - u)*exp(1.0_wp - u))
      end do
      backbone_fall = u*joint%displacement
   end function backbone_fall

   !> The record of a path.
   pure function driven(joint, path) result(record)
      type(backbone_type), intent(in) :: joint
      real(wp), intent(in) :: path(:)
      type(record_type) :: record
      real(wp) :: reach(2), x, stiffness
      integer :: i, side

      stiffness = joint%unloading*exp(1.0_wp)*joint%force/joint%displacement
      allocate (record%displacement, source=path)
      allocate (record%force(size(path)))
      reach = 0.0_wp
      do i = 1, size(path)
         side = merge(1, 2, path(i) > 0.0_wp)
         x = abs(path(i))
         reach(side) = max(reach(side), x)
         record%force(i) = sign(max(0.0_wp, backbone_force(joint, reach(side)) &
            - stiffness*(reach(side) - x)), path(i))
      end do
   end function driven

   !> Turning points of a cyclic programme: each amplitude as often as said, the first time in full,
   !> then times `trailing`; to both sides, or to one side and back.
   pure function programme_turns(amplitudes, times, trailing, one_sided) result(turns)
      real(wp), intent(in) :: amplitudes(:)
      integer, intent(in) :: times(:)
      real(wp), intent(in) :: trailing
      logical, intent(in) :: one_sided
      real(wp) :: turns(2*sum(times) + merge(0, 1, one_sided))
      real(wp) :: a
      integer :: i, j, n

      n = 0
      do i = 1, size(times)
         do j = 1, times(i)
            a = amplitudes(i)*merge(1.0_wp, trailing, j == 1)
            turns(n + 1:n + 2) = [a, merge(0.0_wp, -a, one_sided)]
            n = n + 2
         end do
      end do
      if (.not. one_sided) turns(n + 1) = 0.0_wp
   end function programme_turns

end module backbone_models
