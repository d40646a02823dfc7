!> Work into a contact point, integrated by Gauss quadrature of the tractions along the path of an
!> increment, never taken from the ledgers.
module contact_work
   use asperity, only: contact_properties, contact_response, contact_state, elastic_recovery, &
      evaluate_compiled_law, evaluate_normal_law, evaluate_unloading_law, no_rotation, &
      normal_response, slip_backward_euler, status_open, status_slip, status_unset, &
      unloading_elastic, update_contact_point, wp
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   implicit none
   private
   public :: normal_work, tangential_work

   real(wp), parameter :: none(2) = 0.0_wp

contains

   !> Integral of p d(overclosure) from the state's overclosure or from where the pressure vanishes:
   !> over what the face remembers, then over what it never passed, in panels of two sigma.
   function normal_work(p, start, overclosure) result(work)
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure
      real(wp) :: work, from, left, right
      integer :: i, panel, panels

      from = start%overclosure
      if (start%status == status_unset) from = p%initial_separation - 12.0_wp*p%normal%sigma
      work = 0.0_wp
      if (p%normal%unloading == unloading_elastic .and. start%status /= status_unset) then
         associate (largest => start%largest_closure)
            work = given_back(p, largest, from) - given_back(p, largest, min(overclosure, largest))
            from = largest
         end associate
      end if
      if (p%normal%unloading == unloading_elastic .and. from >= overclosure) return
      panels = max(1, ceiling(0.5_wp*abs(overclosure - from)/p%normal%sigma))
      do panel = 1, panels
         left = from + (overclosure - from)*real(panel - 1, wp)/panels
         right = from + (overclosure - from)*real(panel, wp)/panels
         do i = 1, n_points
            work = work + 0.5_wp*(right - left)*weights(i)*pressure_at(p, &
               0.5_wp*(left + right + nodes(i)*(right - left)))
         end do
      end do
   end function normal_work

   !> Work that the face gives back while it parts from its largest closure to a smaller one: panels
   !> end where the law is not smooth, at w1 and where the last elasto-plastic summit lets go, and
   !> are not longer than the distance from the largest closure.
   function given_back(p, largest, overclosure) result(work)
      type(contact_properties), intent(in) :: p
      real(wp), intent(in) :: largest, overclosure
      real(wp) :: work, left, right, whole
      type(normal_response) :: law
      integer :: i

      work = 0.0_wp
      left = 0.0_wp
      whole = min(largest - overclosure, 40.0_wp*p%normal%sigma)
      associate (n => p%normal, kink => elastic_recovery(p%normal, p%normal%w2))
         do while (left < whole)
            right = max(n%w1, 1.6_wp*left)
            if (left < kink .and. right > kink) right = kink
            right = min(right, whole)
            do i = 1, n_points
               law = evaluate_unloading_law(n, p%initial_separation - largest, &
                  0.5_wp*(left + right + nodes(i)*(right - left)))
               work = work + 0.5_wp*(right - left)*weights(i)*law%pressure
            end do
            left = right
         end do
      end associate
   end function given_back

   !> Pressure at an overclosure that was never passed, by the law that the update takes.
   function pressure_at(p, overclosure) result(pressure)
      type(contact_properties), intent(in) :: p
      real(wp), intent(in) :: overclosure
      real(wp) :: pressure, stiffness
      type(normal_response) :: law

      if (allocated(p%compiled)) then
         call evaluate_compiled_law(p%compiled, p%initial_separation - overclosure, pressure, &
            stiffness)
      else
         law = evaluate_normal_law(p%normal, p%initial_separation - overclosure)
         pressure = law%pressure
      end if
   end function pressure_at

   !> Integral of the shear stress over the tangential motion at the end pressure: the stress at
   !> parts of the motion comes from updates with those parts. Backward Euler's path is the chord
   !> of the elastic slip, then slip at its end.
   function tangential_work(p, start, end, slip) result(work)
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(in) :: start
      type(contact_response), intent(in) :: end
      real(wp), intent(in) :: slip(2)
      type(contact_response) :: at
      type(contact_state) :: pressed
      real(wp) :: work, motion(2), low, high, middle
      integer :: i

      work = 0.0_wp
      if (end%status == status_open) return
      call update_contact_point(p, start, end%state%overclosure, none, no_rotation, at)
      pressed = at%state
      motion = slip
      if (start%status == status_open) then
         ! motion before closing does no work
         call update_contact_point(p, start, end%state%overclosure, 1.0e-6_wp*slip, no_rotation, at)
         motion = at%state%elastic_slip/1.0e-6_wp
      end if
      if (p%slip_integration == slip_backward_euler) then
         work = leg(pressed, end%state%elastic_slip - pressed%elastic_slip, 0.0_wp, 1.0_wp) &
            + dot_product(end%traction(2:3), motion - end%state%elastic_slip &
            + pressed%elastic_slip)
         return
      end if
      low = 0.0_wp
      high = 1.0_wp
      if (end%status == status_slip) then
         do i = 1, 60
            middle = 0.5_wp*(low + high)
            call update_contact_point(p, pressed, end%state%overclosure, middle*motion, &
               no_rotation, at)
            if (at%status == status_slip) then
               high = middle
            else
               low = middle
            end if
         end do
         work = leg(pressed, motion, 0.0_wp, low) + leg(pressed, motion, low, 1.0_wp)
      else
         work = leg(pressed, motion, 0.0_wp, 1.0_wp)
      end if

   contains

      function leg(from, motion, begin, finish) result(part)
         type(contact_state), intent(in) :: from
         real(wp), intent(in) :: motion(2), begin, finish
         real(wp) :: part
         type(contact_response) :: at
         integer :: i

         part = 0.0_wp
         do i = 1, n_points
            call update_contact_point(p, from, from%overclosure, &
               0.5_wp*(begin + finish + nodes(i)*(finish - begin))*motion, no_rotation, at)
            part = part + 0.5_wp*(finish - begin)*weights(i) &
               *dot_product(at%traction(2:3), motion)
         end do
      end function leg

   end function tangential_work

end module contact_work
