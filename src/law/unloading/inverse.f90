!> Inverse of the unloading branch: how far a face has parted when its pressure has fallen to a
!> given one.
module asperity_law_unloading_inverse
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_law, only: evaluate_unloading_branch
   implicit none
   private
   public :: retraction_for_pressure

   integer, parameter :: max_iterations = 200

contains

   !> Retraction from the closest separation at which the pressure is the given one, mm, to
   !> round-off of the direct evaluation; zero when it is that of the closest separation or above.
   !> Newton on ln p, which falls ever steeper, kept inside a bracket.
   pure real(wp) function retraction_for_pressure(properties, closest_separation, pressure) &
         result(retraction)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Pressure, MPa; below the smallest normal number, zero too, it is taken for that
      real(wp), intent(in) :: pressure
      type(normal_response) :: response
      real(wp) :: sought, near, far, next, step, small, mismatch
      integer :: iteration
      logical :: settled

      retraction = 0.0_wp
      sought = pressure
      ! the pressure falls to zero by underflow alone, and never below
      if (pressure < tiny(1.0_wp)) sought = tiny(1.0_wp)
      response = evaluate_normal_law(properties, closest_separation)
      if (.not. response%pressure > sought) return
      near = 0.0_wp
      far = properties%w1
      do
         call evaluate_unloading_branch(properties, closest_separation, far, response)
         if (.not. response%pressure >= sought) exit
         near = far
         far = 2.0_wp*far
      end do

      retraction = far
      settled = .false.
      do iteration = 1, max_iterations
         step = huge(1.0_wp)
         small = 1.0e-9_wp*retraction
         if (response%pressure >= tiny(1.0_wp)) then
            mismatch = log(response%pressure) - log(sought)
            if (abs(mismatch) < 0.5_wp) mismatch = log(response%pressure/sought)
            step = mismatch*response%pressure/response%stiffness
            small = 1.0e-9_wp*max(retraction, response%pressure/response%stiffness)
         end if
         if (.not. (step >= near - retraction .and. step <= far - retraction) &
               .and. abs(step) > small) step = 0.5_wp*(near + far) - retraction
         next = max(retraction + step, 0.0_wp)
         if (settled .or. .not. abs(next - retraction) > 0.0_wp) exit
         ! Newton is quadratic: one more step from here is at round-off
         settled = abs(step) <= small
         retraction = next
         call evaluate_unloading_branch(properties, closest_separation, retraction, response)
         if (response%pressure >= sought) then
            near = retraction
         else
            far = retraction
         end if
      end do
      retraction = next
   end function retraction_for_pressure

end module asperity_law_unloading_inverse
