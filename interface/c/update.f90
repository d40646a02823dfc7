!> C interface: the contact-point update. See asperity.h for what it does.
module asperity_c_update
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_c_arrays, only: array_argument, check_arrays, check_values
   use asperity_c_checks, only: answer, check_points
   use asperity_c_law, only: law_of
   use asperity_c_states, only: make_room, states_of
   use asperity_c_types, only: code_input, error_struct
   use asperity_contact_friction_settings, only: stick_summits
   use asperity_contact_points, only: contact_states, update_contact_points
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: asperity_states_update

   !> Largest overclosure in size, mm: that of a point without opposite surface
   real(wp), parameter :: largest_overclosure = 1.0e36_wp
   !> Largest slip, mm, component of a rotation, and time, s: larger ones are a host gone wrong
   real(wp), parameter :: largest = 1.0e30_wp

contains

   !> Advance all points over one increment.
   integer(c_int) function asperity_states_update(law, states, n, overclosure, slip_increment, &
         rotation, time_increment, traction, tangent, tangential_energy, dissipation, &
         plastic_dissipation, pressure_coupling, validity, error) result(code) &
         bind(c, name='asperity_states_update')
      !> Handles
      type(c_ptr), value :: law, states
      !> Number of points
      integer(c_int), value :: n
      !> Arrays [n], [2][n] and [2][2][n], the last may be NULL
      type(c_ptr), value :: overclosure, slip_increment, rotation
      !> Time of the increment, s; zero where there is none
      real(c_double), value :: time_increment
      !> Arrays [3][n] and [3][3][n], the second may be NULL
      type(c_ptr), value :: traction, tangent
      !> Arrays [n], may be NULL
      type(c_ptr), value :: tangential_energy, dissipation, plastic_dissipation, &
         pressure_coupling, validity
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(contact_properties), pointer :: properties
      type(contact_states), pointer :: content
      type(error_type), allocatable :: problem
      logical :: starved

      starved = .false.
      call law_of(problem, law, properties)
      call states_of(problem, 'states', states, content)
      if (.not. allocated(problem)) call check_points(problem, n, size(content%status))
      if (.not. allocated(problem)) call check_arrays(problem, n, [ &
         array_argument('overclosure', overclosure, required=.true.), &
         array_argument('slip_increment', slip_increment, 2*8, required=.true.), &
         array_argument('rotation', rotation, 4*8), &
         array_argument('traction', traction, 3*8, required=.true., written=.true.), &
         array_argument('tangent', tangent, 9*8, written=.true.), &
         array_argument('tangential_energy', tangential_energy, written=.true.), &
         array_argument('dissipation', dissipation, written=.true.), &
         array_argument('plastic_dissipation', plastic_dissipation, written=.true.), &
         array_argument('pressure_coupling', pressure_coupling, written=.true.), &
         array_argument('validity', validity, bytes=4, written=.true.)])
      call check_values(problem, 'overclosure', n, 1, overclosure, largest_overclosure)
      call check_values(problem, 'slip_increment', n, 2, slip_increment, largest)
      call check_values(problem, 'rotation', n, 4, rotation, largest)
      call check_time(problem)
      if (n > 0 .and. .not. allocated(problem)) then
         call make_room(content, starved, .not. properties%friction_is_plain, &
            properties%friction%stick == stick_summits)
         if (.not. starved) call update()
      end if
      code = answer(problem, error, starved)

   contains

      subroutine check_time(problem)
         type(error_type), allocatable, intent(inout) :: problem

         if (allocated(problem)) return
         if (is_finite(time_increment)) then
            if (time_increment >= 0.0_wp .and. time_increment <= largest) return
         end if
         call fatal_error(problem, 'time_increment = '//to_text(time_increment)//' s is not '// &
            'allowed: it must be a number from 0 to '//to_text(largest), code_input)
      end subroutine check_time

      !> A pointer that is not associated counts as an argument that is not there.
      subroutine update()
         real(wp), pointer, contiguous, dimension(:) :: closure, e, d, f, c
         real(wp), pointer, contiguous, dimension(:, :) :: slip, t
         real(wp), pointer, contiguous, dimension(:, :, :) :: r, k
         integer(c_int), pointer, contiguous :: v(:)

         nullify (r, k, e, d, f, c, v)
         call c_f_pointer(overclosure, closure, [n])
         call c_f_pointer(slip_increment, slip, [n, 2])
         call c_f_pointer(traction, t, [n, 3])
         if (c_associated(rotation)) call c_f_pointer(rotation, r, [n, 2, 2])
         if (c_associated(tangent)) call c_f_pointer(tangent, k, [n, 3, 3])
         if (c_associated(tangential_energy)) call c_f_pointer(tangential_energy, e, [n])
         if (c_associated(dissipation)) call c_f_pointer(dissipation, d, [n])
         if (c_associated(plastic_dissipation)) call c_f_pointer(plastic_dissipation, f, [n])
         if (c_associated(pressure_coupling)) call c_f_pointer(pressure_coupling, c, [n])
         if (c_associated(validity)) call c_f_pointer(validity, v, [n])
         call update_contact_points(properties, content, closure, slip, t, problem, r, k, e, d, &
            f, c, v, time_increment)
      end subroutine update

   end function asperity_states_update

end module asperity_c_update
