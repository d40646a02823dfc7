!> Inverse of the normal law: the separation at which it gives a pressure.
module asperity_law_normal_inverse
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   implicit none
   private
   public :: separation_for_pressure

   integer, parameter :: max_iterations = 200
   !> Newton's method is at round-off one step after the logarithm of the pressure errs by this
   real(wp), parameter :: small_mismatch = 2.0e-6_wp
   !> Largest closure beyond the mean plane that is searched, in sigma
   real(wp), parameter :: closest = 1.0e100_wp

contains

   !> Separation d with p(d) = pressure, to 4 eps max(sigma, |d|) of the direct evaluation.
   !> Newton on ln p, which is nearly linear in d far away and concave, kept inside a bracket.
   !> `error` is set unless the pressure is a normal number above zero.
   pure subroutine separation_for_pressure(properties, pressure, separation, error)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> Separation, mm
      real(wp), intent(out) :: separation
      !> Set when the pressure is refused
      type(error_type), allocatable, intent(out) :: error
      type(normal_response) :: response
      real(wp) :: near, far, next, step, small, mismatch
      integer :: iteration
      logical :: settled

      separation = 0.0_wp
      call check_pressure(pressure, error)
      if (allocated(error)) return

      far = properties%sigma
      do while (pressure_at(far) >= pressure)
         far = 2.0_wp*far
      end do
      near = -properties%sigma
      do while (pressure_at(near) < pressure)
         far = near
         near = 2.0_wp*near
         if (near < -closest*properties%sigma) then
            call fatal_error(error, 'pressure = '//to_text(pressure)//' MPa is out of reach', &
               subject='pressure')
            return
         end if
      end do

      separation = max(near, min(far, 0.0_wp))
      settled = .false.
      do iteration = 1, max_iterations
         response = evaluate_normal_law(properties, separation)
         if (response%pressure >= pressure) then
            near = separation
         else
            far = separation
         end if
         step = huge(1.0_wp)
         mismatch = huge(1.0_wp)
         if (response%pressure >= tiny(1.0_wp)) then
            mismatch = log(response%pressure) - log(pressure)
            if (abs(mismatch) < 0.5_wp) mismatch = log(response%pressure/pressure)
            step = mismatch*response%pressure/response%stiffness
         end if
         next = separation + step
         small = 1.0e-9_wp*max(properties%sigma, abs(separation))
         if (.not. (next >= near .and. next <= far) .and. abs(step) > small) then
            next = 0.5_wp*(near + far)
            step = next - separation
         end if
         separation = next
         if (settled .or. .not. abs(step) > 0.0_wp) exit
         ! Newton is quadratic: one more step from here is at round-off
         settled = abs(step) <= small .and. abs(mismatch) <= small_mismatch
      end do

   contains

      pure real(wp) function pressure_at(d)
         real(wp), intent(in) :: d
         type(normal_response) :: at_d

         at_d = evaluate_normal_law(properties, d)
         pressure_at = at_d%pressure
      end function pressure_at

   end subroutine separation_for_pressure

   pure subroutine check_pressure(pressure, error)
      real(wp), intent(in) :: pressure
      type(error_type), allocatable, intent(out) :: error

      if (is_finite(pressure)) then
         if (pressure >= tiny(1.0_wp)) return
      end if
      call fatal_error(error, 'pressure = '//to_text(pressure)// &
         ' MPa has no separation: it must be a finite number above zero (2.3e-308 or more)', &
         subject='pressure')
   end subroutine check_pressure

end module asperity_law_normal_inverse
