!> C interface: values of the normal law. See asperity.h for what each function does.
module asperity_c_evaluate
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_c_arrays, only: array_argument, check_arrays, check_values
   use asperity_c_checks, only: answer, check_pointer, check_points
   use asperity_c_law, only: law_of
   use asperity_c_types, only: code_input, error_struct
   use asperity_contact_properties, only: contact_properties
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_unloading_law, only: evaluate_unloading_law
   implicit none
   private
   public :: asperity_law_evaluate, asperity_law_evaluate_unloading, asperity_law_separation

   !> Largest separation in size, mm: no result of any law overflows there
   real(wp), parameter :: largest_separation = 1.0e36_wp

contains

   !> The normal law at n separations.
   integer(c_int) function asperity_law_evaluate(law, n, separation, pressure, stiffness, &
         area_fraction, contact_density, energy, validity, error) result(code) &
         bind(c, name='asperity_law_evaluate')
      !> Handle
      type(c_ptr), value :: law
      !> Number of points
      integer(c_int), value :: n
      !> Arrays of n reals; the last three may be NULL
      type(c_ptr), value :: separation, pressure, stiffness, area_fraction, contact_density, energy
      !> Array of n integers, may be NULL
      type(c_ptr), value :: validity
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_properties), pointer :: properties
      type(compiled_law), pointer :: compiled
      type(error_type), allocatable :: problem
      real(wp), pointer, contiguous :: d(:), p(:), s(:)

      call law_of(problem, law, properties)
      call check_points(problem, n)
      if (.not. allocated(problem)) call check_arrays(problem, n, [ &
         array_argument('separation', separation, required=.true.), &
         array_argument('pressure', pressure, required=.true., written=.true.), &
         array_argument('stiffness', stiffness, required=.true., written=.true.), &
         array_argument('area_fraction', area_fraction, written=.true.), &
         array_argument('contact_density', contact_density, written=.true.), &
         array_argument('energy', energy, written=.true.), &
         array_argument('validity', validity, bytes=4, written=.true.)])
      call check_values(problem, 'separation', n, 1, separation, largest_separation)
      if (n > 0 .and. .not. allocated(problem)) then
         call c_f_pointer(separation, d, [n])
         call c_f_pointer(pressure, p, [n])
         call c_f_pointer(stiffness, s, [n])
         nullify (compiled)
         if (allocated(properties%compiled)) compiled => properties%compiled
         if (allocated(properties%compiled_unloading)) &
            compiled => properties%compiled_unloading%virgin
         if (associated(compiled) .and. .not. (c_associated(area_fraction) &
               .or. c_associated(contact_density) .or. c_associated(energy) &
               .or. c_associated(validity))) then
            call evaluate_compiled_law(compiled, d, p, s)
         else
            call evaluate_all(properties, compiled, d, p, s, area_fraction, contact_density, &
               energy, validity)
         end if
      end if
      code = answer(problem, error)
   end function asperity_law_evaluate

   !> The law with memory at n closest separations and retractions from them.
   integer(c_int) function asperity_law_evaluate_unloading(law, n, closest_separation, &
         retraction, pressure, stiffness, area_fraction, contact_density, energy, &
         plastic_dissipation, validity, error) result(code) &
         bind(c, name='asperity_law_evaluate_unloading')
      !> Handle
      type(c_ptr), value :: law
      !> Number of points
      integer(c_int), value :: n
      !> Arrays of n reals; the last four may be NULL
      type(c_ptr), value :: closest_separation, retraction, pressure, stiffness, area_fraction, &
         contact_density, energy, plastic_dissipation
      !> Array of n integers, may be NULL
      type(c_ptr), value :: validity
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_properties), pointer :: properties
      type(error_type), allocatable :: problem
      type(normal_response) :: r
      real(wp), pointer, contiguous, dimension(:) :: d, u, p, s, a, c, e, f
      integer(c_int), pointer, contiguous :: v(:)
      integer :: i

      call law_of(problem, law, properties)
      call check_points(problem, n)
      if (.not. allocated(problem)) call check_arrays(problem, n, [ &
         array_argument('closest_separation', closest_separation, required=.true.), &
         array_argument('retraction', retraction, required=.true.), &
         array_argument('pressure', pressure, required=.true., written=.true.), &
         array_argument('stiffness', stiffness, required=.true., written=.true.), &
         array_argument('area_fraction', area_fraction, written=.true.), &
         array_argument('contact_density', contact_density, written=.true.), &
         array_argument('energy', energy, written=.true.), &
         array_argument('plastic_dissipation', plastic_dissipation, written=.true.), &
         array_argument('validity', validity, bytes=4, written=.true.)])
      call check_values(problem, 'closest_separation', n, 1, closest_separation, &
         largest_separation)
      call check_values(problem, 'retraction', n, 1, retraction, largest_separation)
      if (.not. allocated(problem)) then
         if (properties%normal%unloading /= unloading_elastic) call fatal_error(problem, &
            'unloading of the law is reversible: it remembers no closest separation; build it '// &
            'with ASPERITY_UNLOADING_ELASTIC', code_input)
      end if
      if (n > 0 .and. .not. allocated(problem)) then
         call c_f_pointer(closest_separation, d, [n])
         call c_f_pointer(retraction, u, [n])
         p => reals(pressure, n)
         s => reals(stiffness, n)
         a => reals(area_fraction, n)
         c => reals(contact_density, n)
         e => reals(energy, n)
         f => reals(plastic_dissipation, n)
         v => flags(validity, n)
         do i = 1, n
            r = evaluate_unloading_law(properties%normal, d(i), u(i))
            p(i) = r%pressure
            s(i) = r%stiffness
            if (associated(a)) a(i) = r%area_fraction
            if (associated(c)) c(i) = r%contact_density
            if (associated(e)) e(i) = r%energy
            if (associated(f)) f(i) = r%plastic_dissipation
            if (associated(v)) v(i) = r%validity
         end do
      end if
      code = answer(problem, error)
   end function asperity_law_evaluate_unloading

   !> An array of the caller; not associated when it is NULL.
   function reals(address, n) result(array)
      type(c_ptr), intent(in) :: address
      integer(c_int), intent(in) :: n
      real(wp), pointer, contiguous :: array(:)

      nullify (array)
      if (c_associated(address)) call c_f_pointer(address, array, [n])
   end function reals

   !> The same of integers.
   function flags(address, n) result(array)
      type(c_ptr), intent(in) :: address
      integer(c_int), intent(in) :: n
      integer(c_int), pointer, contiguous :: array(:)

      nullify (array)
      if (c_associated(address)) call c_f_pointer(address, array, [n])
   end function flags

   !> Separation at which the law gives a pressure.
   integer(c_int) function asperity_law_separation(law, pressure, separation, error) &
         result(code) bind(c, name='asperity_law_separation')
      !> Handle
      type(c_ptr), value :: law
      !> Pressure, MPa
      real(c_double), value :: pressure
      !> Where the separation goes, mm; untouched after an error
      type(c_ptr), value :: separation
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_properties), pointer :: properties
      type(error_type), allocatable :: problem
      real(wp), pointer :: place
      real(wp) :: found

      call law_of(problem, law, properties)
      call check_pointer(problem, 'separation', separation)
      if (.not. allocated(problem)) &
         call separation_for_pressure(properties%normal, pressure, found, problem)
      if (.not. allocated(problem)) then
         call c_f_pointer(separation, place)
         place = found
      end if
      code = answer(problem, error)
   end function asperity_law_separation

   !> Everything that the law answers, compiled or directly, into those arrays that are there.
   subroutine evaluate_all(properties, compiled, d, p, s, area_fraction, contact_density, energy, &
         validity)
      type(contact_properties), intent(in) :: properties
      type(compiled_law), pointer, intent(in) :: compiled
      real(wp), intent(in), contiguous :: d(:)
      real(wp), intent(out), contiguous :: p(:), s(:)
      type(c_ptr), intent(in) :: area_fraction, contact_density, energy, validity
      real(wp), pointer, contiguous :: a(:), c(:), e(:)
      integer(c_int), pointer, contiguous :: v(:)
      type(normal_response) :: r
      integer :: i

      a => reals(area_fraction, size(d))
      c => reals(contact_density, size(d))
      e => reals(energy, size(d))
      v => flags(validity, size(d))
      do i = 1, size(d)
         if (associated(compiled)) then
            call evaluate_compiled_law(compiled, d(i), r%pressure, r%stiffness, &
               r%area_fraction, r%contact_density, r%energy, r%validity)
         else
            r = evaluate_normal_law(properties%normal, d(i))
         end if
         p(i) = r%pressure
         s(i) = r%stiffness
         if (associated(a)) a(i) = r%area_fraction
         if (associated(c)) c(i) = r%contact_density
         if (associated(e)) e(i) = r%energy
         if (associated(v)) v(i) = r%validity
      end do
   end subroutine evaluate_all

end module asperity_c_evaluate
