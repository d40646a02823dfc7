!> The path of one elastic-slip element whose domain is |gamma| <= g: elastic slip, how far it has
!> gone from rest to motion, and dissipation, with their derivatives by overclosure and slip. In
!> the axes of the grain.
!>
!> Radius g = kinetic + excess (1 - moved): `excess` is that of rest over motion, which the slip
!> rate has reduced already. Slipping over l, 1 - moved falls to exp(-l/decay_slip) of it; elastic
!> travel over s brings moved to exp(-s/(decay_slip + g_s - g_k)) of it. So g never grows as fast as
!> an elastic slip that is driven outwards: what slips on does not stick in between, and no noise
!> makes it.
!>
!> Slip goes along w_i gamma_i. Its increment ends by backward Euler: gamma_i = trial_i -
!> lambda w_i gamma_i on the circle of the end. In one dimension that is exact.
module asperity_contact_sliding_element
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: sliding_element, slip_domain, slide_element, shrink_to_domain

   !> Derivatives are by overclosure and the two components of the slip increment
   integer, parameter, public :: n_by = 3

   !> An element within an increment.
   type :: sliding_element
      !> Elastic slip, mm
      real(wp) :: gamma(2)
      !> How far from rest, 0, to motion, 1
      real(wp) :: moved
      real(wp) :: gamma_by(2, n_by), moved_by(n_by)
      !> Work of friction over the stiffness, mm^2
      real(wp) :: lost
      !> Whether it slips at the end
      logical :: slips
   end type sliding_element

   !> Where it sticks, and where it slips to.
   type :: slip_domain
      !> Radius in motion, and what rest adds to it, mm
      real(wp) :: kinetic, excess
      real(wp) :: kinetic_by(n_by), excess_by(n_by)
      !> 1/decay_slip, 1/mm; zero without decay by slip; and the same of the travel that renews
      real(wp) :: decay, renewal
      !> Stiffness along and across the grain over that along it
      real(wp) :: stiffness(2)
      !> Direction of slip: w_i gamma_i
      real(wp) :: direction(2)
   end type slip_domain

   !> Elastic slip that is longer by so much is so by round-off
   real(wp), parameter :: round_off = 1.0_wp + 8.0_wp*epsilon(1.0_wp)
   integer, parameter :: most_iterations = 100

contains

   !> What was inside and is outside, as the domain has shrunk, slips without motion: the stored
   !> energy that is let go is lost.
   pure subroutine shrink_to_domain(element, domain)
      !> The element
      type(sliding_element), intent(inout) :: element
      !> Its domain
      type(slip_domain), intent(in) :: domain
      real(wp) :: before, work

      if (.not. hypot(element%gamma(1), element%gamma(2)) &
         > (domain%kinetic + domain%excess*(1.0_wp - element%moved))*round_off) return
      before = energy(element, domain)
      call return_to_domain(element, domain, work)
      element%lost = element%lost + max(before - energy(element, domain), 0.0_wp)
      element%slips = .true.
   end subroutine shrink_to_domain

   !> Slide over a straight motion: stick up to the domain, then slip.
   pure subroutine slide_element(element, domain, motion, motion_by)
      !> The element, inside its domain
      type(sliding_element), intent(inout) :: element
      !> Its domain
      type(slip_domain), intent(in) :: domain
      !> Relative motion, mm, and its derivatives
      real(wp), intent(in) :: motion(2), motion_by(2, n_by)
      type(sliding_element) :: trial
      real(wp) :: rest(2), rest_by(2, n_by), work, length

      trial = element
      trial%gamma = element%gamma + motion
      trial%gamma_by = element%gamma_by + motion_by
      length = hypot(motion(1), motion(2))
      if (domain%decay > 0.0_wp .and. length > 0.0_wp) &
         call renew(trial, domain%renewal, length, motion, motion_by)
      ! a start outside by round-off must not count as slip when the motion turns back
      if (.not. hypot(trial%gamma(1), trial%gamma(2)) > domain%kinetic &
         + domain%excess*(1.0_wp - trial%moved) &
         .or. .not. dot_product(trial%gamma, motion) > 0.0_wp) then
         trial%slips = .false.
         element = trial
         return
      end if
      if (domain%decay > 0.0_wp) then
         call stick_to_domain(element, domain, motion, motion_by, rest, rest_by)
         if (drops(element, domain)) then
            work = energy(element, domain)
            call return_to_domain(element, domain, length)
            element%lost = element%lost + max(work - energy(element, domain), 0.0_wp)
         end if
         element%gamma = element%gamma + rest
         element%gamma_by = element%gamma_by + rest_by
      else
         element = trial
      end if
      call return_to_domain(element, domain, work)
      element%lost = element%lost + work
      element%slips = .true.
   end subroutine slide_element

   !> Elastic travel renews rest.
   pure subroutine renew(element, renewal, length, motion, motion_by)
      type(sliding_element), intent(inout) :: element
      real(wp), intent(in) :: renewal, length, motion(2), motion_by(2, n_by)
      real(wp) :: left
      integer :: k

      left = exp(-renewal*length)
      do k = 1, n_by
         element%moved_by(k) = left*(element%moved_by(k) &
            - element%moved*renewal*dot_product(motion, motion_by(:, k))/length)
      end do
      element%moved = left*element%moved
   end subroutine renew

   !> Stick over a motion that ends outside: up to the last point inside, f of the way; the rest is
   !> left. |gamma(f)| - g(f) is convex, so Newton's method comes down to its last zero from f = 1.
   pure subroutine stick_to_domain(element, domain, motion, motion_by, rest, rest_by)
      type(sliding_element), intent(inout) :: element
      type(slip_domain), intent(in) :: domain
      real(wp), intent(in) :: motion(2), motion_by(2, n_by)
      real(wp), intent(out) :: rest(2), rest_by(2, n_by)
      real(wp) :: f, step, length, travel, at(2), size, moved, outside, slope, f_by(n_by)
      integer :: i, k

      rest = motion
      rest_by = motion_by
      travel = hypot(motion(1), motion(2))
      f = 1.0_wp
      do i = 1, most_iterations
         at = element%gamma + f*motion
         size = hypot(at(1), at(2))
         moved = element%moved*exp(-domain%renewal*f*travel)
         outside = size - domain%kinetic - domain%excess*(1.0_wp - moved)
         slope = dot_product(at, motion)/size - domain%excess*moved*domain%renewal*travel
         ! never inside
         if (.not. slope > 0.0_wp) return
         ! on the circle from the start on, as after an increment at the same rate
         if (.not. f > 0.0_wp) exit
         step = outside/slope
         f = max(f - step, 0.0_wp)
         if (f > 0.0_wp .and. .not. step > 2.0_wp*epsilon(f)*f) exit
      end do
      length = f*travel
      do k = 1, n_by
         f_by(k) = -(dot_product(at, element%gamma_by(:, k) + f*motion_by(:, k))/size &
            - domain%kinetic_by(k) - domain%excess_by(k)*(1.0_wp - moved) &
            + domain%excess*(exp(-domain%renewal*length)*element%moved_by(k) &
            - moved*domain%renewal*f*dot_product(motion, motion_by(:, k))/travel))/slope
         element%moved_by(k) = exp(-domain%renewal*length)*element%moved_by(k) &
            - moved*domain%renewal*(f*dot_product(motion, motion_by(:, k))/travel + f_by(k)*travel)
         element%gamma_by(:, k) = element%gamma_by(:, k) + f*motion_by(:, k) + f_by(k)*motion
         rest_by(:, k) = (1.0_wp - f)*motion_by(:, k) - f_by(k)*motion
      end do
      element%moved = moved
      element%gamma = element%gamma + f*motion
      rest = (1.0_wp - f)*motion
   end subroutine stick_to_domain

   !> Whether friction on the circle falls faster with slip than elastic slip is let go: it then
   !> drops at once, without motion.
   pure logical function drops(element, domain)
      type(sliding_element), intent(in) :: element
      type(slip_domain), intent(in) :: domain

      associate (g => element%gamma, w => domain%direction)
         drops = domain%excess*(1.0_wp - element%moved)*domain%decay*norm2(w*g)*norm2(g) &
            > dot_product(w*g, g)
      end associate
   end function drops

   !> Slip from a trial outside to the circle of the end: gamma_i = a_i trial_i with
   !> a_i = kappa/(w_i + kappa (1 - w_i)), kappa = 1/(1 + lambda). |gamma| - g of kappa is concave
   !> where w is one; its lowest zero is the end. `work` is that of friction on the way over the
   !> stiffness, along the direction of the end.
   pure subroutine return_to_domain(element, domain, work)
      type(sliding_element), intent(inout) :: element
      type(slip_domain), intent(in) :: domain
      real(wp), intent(out) :: work
      real(wp) :: trial(2), kappa, low, high, next, below(2), a(2), a_by(2), gamma(2), c(2), slip
      real(wp) :: normal(2), along(2), size, reach, faded, excess, outside, slope, slip_by
      real(wp) :: kappa_by(n_by), trial_by(2), slip_by_k
      integer :: i, k

      trial = element%gamma
      reach = hypot(trial(1), trial(2))
      excess = domain%excess*(1.0_wp - element%moved)
      associate (w => domain%direction)
         low = 0.0_wp
         high = 1.0_wp
         kappa = min(domain%kinetic/reach, 1.0_wp)
         do i = 1, most_iterations
            below = w + kappa*(1.0_wp - w)
            a = kappa/below
            a_by = w/(below*below)
            gamma = a*trial
            c = w*trial/below
            slip = (1.0_wp - kappa)*hypot(c(1), c(2))
            along = c/hypot(c(1), c(2))
            size = hypot(gamma(1), gamma(2))
            normal = gamma/size
            faded = exp(-domain%decay*slip)
            outside = size - domain%kinetic - excess*faded
            slip_by = -dot_product(along, a_by*trial)
            slope = dot_product(normal, a_by*trial) + excess*faded*domain%decay*slip_by
            if (outside > 0.0_wp) then
               high = kappa
            else
               low = kappa
            end if
            next = 0.5_wp*(low + high)
            if (slope > 0.0_wp) then
               next = kappa - outside/slope
               if (.not. (next >= low .and. next <= high)) next = 0.5_wp*(low + high)
            end if
            if (abs(next - kappa) <= 4.0_wp*epsilon(kappa)*kappa) exit
            kappa = next
         end do
         ! zero only where friction falls just as fast as elastic slip is let go
         slope = max(slope, epsilon(slope)*reach)
         do k = 1, n_by
            trial_by = element%gamma_by(:, k)
            slip_by_k = dot_product(along, (1.0_wp - a)*trial_by)
            kappa_by(k) = -(dot_product(normal, a*trial_by) - domain%kinetic_by(k) &
               - faded*(domain%excess_by(k)*(1.0_wp - element%moved) &
               - domain%excess*element%moved_by(k)) + excess*faded*domain%decay*slip_by_k)/slope
            element%gamma_by(:, k) = a*trial_by + a_by*trial*kappa_by(k)
            element%moved_by(k) = faded*(element%moved_by(k) + (1.0_wp - element%moved) &
               *domain%decay*(slip_by_k + slip_by*kappa_by(k)))
         end do
      end associate
      ! exactly on the circle, even from very far outside
      size = domain%kinetic + excess*faded
      element%gamma = size*normal
      element%moved = 1.0_wp - (1.0_wp - element%moved)*faded
      work = domain%kinetic*slip
      if (domain%decay > 0.0_wp) then
         work = work + excess*(1.0_wp - faded)/domain%decay
      else
         work = work + excess*slip
      end if
      work = work*dot_product(domain%stiffness*normal, along)
   end subroutine return_to_domain

   !> Stored energy over the stiffness, mm^2.
   pure real(wp) function energy(element, domain)
      type(sliding_element), intent(in) :: element
      type(slip_domain), intent(in) :: domain

      energy = 0.5_wp*dot_product(domain%stiffness*element%gamma, element%gamma)
   end function energy

end module asperity_contact_sliding_element
