!> Inverse of the unloading branch: how far a face has parted when its pressure has fallen to a
!> given one.
module asperity_law_unloading_inverse
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_law, only: evaluate_unloading_law
   implicit none
   private
   public :: retraction_for_pressure

contains

   !> Retraction from the closest separation at which the pressure is the given one, mm; zero when
   !> it is that of the closest separation or above.
   pure real(wp) function retraction_for_pressure(properties, closest_separation, pressure) &
         result(retraction)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Pressure, MPa; above zero
      real(wp), intent(in) :: pressure
      type(normal_response) :: response
      real(wp) :: near, far
      integer :: i

      near = 0.0_wp
      far = properties%sigma*20.0_wp
      do i = 1, 60
         retraction = 0.5_wp*(near + far)
         response = evaluate_unloading_law(properties, closest_separation, retraction)
         if (response%pressure > pressure) then
            near = retraction
         else
            far = retraction
         end if
      end do
      response = evaluate_unloading_law(properties, closest_separation, 0.0_wp)
      if (response%pressure <= pressure) retraction = 0.0_wp
   end function retraction_for_pressure

end module asperity_law_unloading_inverse
