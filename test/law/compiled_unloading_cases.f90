!> The compiled law with memory beside the direct one, for tests: both by numbers over sigma.
module compiled_unloading_cases
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_unloading_law, &
      evaluate_compiled_unloading_law
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use funit, only: assertFalse
   implicit none
   private
   public :: compile, compiled_at, direct_at, furthest_at

   !> Just above 2/sqrt(110), below which there is no elastic unloading
   real(wp), parameter, public :: yield_factor_min = 0.19070_wp

contains

   !> Compile the law of these properties with elastic unloading.
   subroutine compile(law, properties)
      type(compiled_unloading_law), intent(out) :: law
      type(normal_properties), intent(in) :: properties
      type(normal_properties) :: p
      type(error_type), allocatable :: error

      p = properties
      p%unloading = unloading_elastic
      call new_compiled_unloading_law(law, p, error)
      call assertFalse(allocated(error), 'compiled')
   end subroutine compile

   !> Pressure, stiffness and energy, compiled, at h and u over sigma.
   function compiled_at(law, h, u, validity) result(values)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h, u
      integer, intent(out), optional :: validity
      real(wp) :: values(3)
      integer :: flags

      associate (sigma => law%virgin%properties%sigma)
         call evaluate_compiled_unloading_law(law, h*sigma, u*sigma, values(1), values(2), &
            values(3), flags)
      end associate
      if (present(validity)) validity = flags
   end function compiled_at

   !> The same, directly.
   function direct_at(law, h, u, validity) result(values)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h, u
      integer, intent(out), optional :: validity
      real(wp) :: values(3)
      type(normal_response) :: r

      associate (p => law%virgin%properties)
         r = evaluate_unloading_law(p, h*p%sigma, u*p%sigma)
      end associate
      values = [r%pressure, r%stiffness, r%energy]
      if (present(validity)) validity = r%validity
   end function direct_at

   !> Retraction over sigma at which the pressure is 1e-12 of that at the closest separation.
   real(wp) function furthest_at(law, h) result(u)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h
      type(normal_response) :: r

      associate (p => law%virgin%properties)
         r = evaluate_normal_law(p, h*p%sigma)
         u = retraction_for_pressure(p, h*p%sigma, 1.0e-12_wp*r%pressure)/p%sigma
      end associate
   end function furthest_at

end module compiled_unloading_cases
