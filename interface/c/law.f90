!> C interface: the law. See asperity.h for what each function does.
module asperity_c_law
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_size_t
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_c_checks, only: answer, clear_handle, content_of, free_handle, wrap
   use asperity_c_contents, only: content_at
   use asperity_c_properties, only: view_properties
   use asperity_c_types, only: code_input, error_struct, four_sigma, properties_struct, tag_law
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_properties, only: contact_properties, new_contact_properties
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   implicit none
   private
   public :: asperity_law_new, asperity_law_free, asperity_law_properties, law_of

   !> Words that must be free before a law is built, as the library does not ask of each of its
   !> small allocations whether it succeeded
   integer, parameter :: head_room = 2**17

contains

   !> Build a law.
   integer(c_int) function asperity_law_new(law, properties, error) result(code) &
         bind(c, name='asperity_law_new')
      !> Pointer to the handle, which is NULL after an error
      type(c_ptr), value :: law
      !> Struct of properties
      type(c_ptr), value :: properties
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(c_ptr), pointer :: handle
      type(properties_struct), pointer :: p
      type(error_type), allocatable :: problem
      logical :: starved

      starved = .false.
      call clear_handle(problem, 'law', law, handle)
      call view_properties(problem, properties, p)
      if (.not. allocated(problem)) call make_law(problem, p, handle, starved)
      code = answer(problem, error, starved)
   end function asperity_law_new

   !> Free a law and set its handle to NULL. NULL at either place is fine.
   integer(c_int) function asperity_law_free(law, error) result(code) &
         bind(c, name='asperity_law_free')
      !> Pointer to the handle
      type(c_ptr), intent(inout), optional :: law
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_properties), pointer :: content
      type(error_type), allocatable :: problem

      if (present(law)) then
         call law_of(problem, law, content, null_passes=.true.)
         if (associated(content)) then
            deallocate (content)
            call free_handle(law)
         end if
      end if
      code = answer(problem, error)
   end function asperity_law_free

   !> The properties of a law, with the defaults that it was given.
   integer(c_int) function asperity_law_properties(law, properties, size, error) result(code) &
         bind(c, name='asperity_law_properties')
      !> Handle
      type(c_ptr), value :: law
      !> Struct to fill
      type(c_ptr), value :: properties
      !> Its size for the caller
      integer(c_size_t), value :: size
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_properties), pointer :: content
      type(properties_struct), pointer :: p
      type(error_type), allocatable :: problem

      call law_of(problem, law, content)
      call view_properties(problem, properties, p, size)
      if (.not. allocated(problem)) then
         associate (c => content, n => content%normal, f => content%friction)
            ! a law that exists has been accepted
            p = properties_struct(size, n%eta, n%modulus, n%radius, n%hardness, n%yield_factor, &
               n%sigma, c%friction_coefficient, c%critical_slip, c%initial_separation, &
               c%friction_rule, c%slip_integration, 1, &
               merge(1, 0, allocated(c%compiled) .or. allocated(c%compiled_unloading)), &
               n%unloading, n%plastic_ratio, n%height_distribution, n%skewness, n%kurtosis, &
               f%static_friction_coefficient, f%decay_slip, f%decay_slip_rate, &
               f%friction_coefficient_across, f%grain_angle, f%slip_direction, &
               f%pressure_exponent, f%reference_pressure, f%shear_limit, f%stick, &
               f%stick_elements, f%shear_modulus, f%friction_points, f%friction_pressures, &
               f%friction_factors)
         end associate
      end if
      code = answer(problem, error)
   end function asperity_law_properties

   !> The law of a handle; a problem and no association when it is none.
   subroutine law_of(problem, handle, content, null_passes)
      !> Set when the handle is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Handle
      type(c_ptr), intent(in) :: handle
      !> Its law
      type(contact_properties), pointer, intent(out) :: content
      !> NULL is no problem
      logical, intent(in), optional :: null_passes
      type(c_ptr) :: address

      nullify (content)
      call content_of(problem, 'law', handle, tag_law, address, null_passes)
      if (.not. allocated(problem)) call content_at(address, content)
   end subroutine law_of

   !> Build the law and its handle.
   subroutine make_law(problem, p, handle, starved)
      type(error_type), allocatable, intent(inout) :: problem
      type(properties_struct), intent(in) :: p
      type(c_ptr), intent(inout) :: handle
      logical, intent(out) :: starved
      type(contact_properties), pointer :: content
      integer :: status

      starved = .not. has_room()
      if (starved) return
      allocate (content, stat=status)
      starved = status /= 0
      if (starved) return
      call build(problem, p, content)
      if (.not. allocated(problem)) call wrap(tag_law, c_loc(content), handle, starved)
      if (allocated(problem) .or. starved) deallocate (content)
   end subroutine make_law

   !> Whether there is memory for what the library allocates on the way.
   logical function has_room()
      real(c_double), allocatable, volatile :: room(:)
      integer :: status

      allocate (room(head_room), stat=status)
      has_room = status == 0
   end function has_room

   !> Check the properties and build the law from them.
   subroutine build(problem, p, content)
      type(error_type), allocatable, intent(inout) :: problem
      type(properties_struct), intent(in) :: p
      type(contact_properties), intent(inout) :: content
      type(normal_properties) :: normal

      call check_switch(problem, 'accept_unphysical', p%accept_unphysical)
      call check_switch(problem, 'compiled', p%compiled)
      if (allocated(problem)) return
      call new_normal_properties(normal, p%eta, p%modulus, p%radius, p%hardness, &
         p%yield_factor, p%sigma, problem, p%accept_unphysical == 1, p%unloading, &
         p%plastic_ratio, p%height_distribution, p%skewness, p%kurtosis)
      if (allocated(problem)) return
      if (transfer(p%initial_separation, p%size) == transfer(four_sigma, p%size)) then
         call new_contact_properties(content, normal, p%friction_coefficient, p%critical_slip, &
            problem, friction_rule=p%friction_rule, slip_integration=p%slip_integration, &
            compiled=p%compiled == 1, accept_unphysical=p%accept_unphysical == 1, &
            friction=friction_of(p))
      else
         call new_contact_properties(content, normal, p%friction_coefficient, p%critical_slip, &
            problem, p%initial_separation, p%friction_rule, p%slip_integration, p%compiled == 1, &
            p%accept_unphysical == 1, friction_of(p))
      end if
   end subroutine build

   !> Friction beyond one coefficient and one critical slip.
   pure function friction_of(p) result(friction)
      type(properties_struct), intent(in) :: p
      type(friction_settings) :: friction

      friction = friction_settings(p%static_friction_coefficient, p%decay_slip, &
         p%decay_slip_rate, p%friction_coefficient_across, p%grain_angle, p%slip_direction, &
         p%pressure_exponent, p%reference_pressure, p%friction_points, p%friction_pressures, &
         p%friction_factors, p%shear_limit, p%stick, p%stick_elements, p%shear_modulus)
   end function friction_of

   subroutine check_switch(problem, name, value)
      type(error_type), allocatable, intent(inout) :: problem
      character(len=*), intent(in) :: name
      integer(c_int), intent(in) :: value

      if (allocated(problem) .or. value == 0 .or. value == 1) return
      call fatal_error(problem, name//' = '//to_text(value)//' is not allowed: 0 is no, 1 is yes', &
         code_input)
   end subroutine check_switch

end module asperity_c_law
