!> Compiles the law with memory: values of the direct law at Chebyshev-Lobatto points become the
!> polynomials of `asperity_law_unloading_compiled_law`. Cells are halved until the stiffness is a
!> good polynomial of its own variable at three closest separations of the strip.
module asperity_law_unloading_compile_law
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: first
   use asperity_law_gaussian_tail, only: tail_moments
   use asperity_law_normal_law, only: normal_response, vanishing_separation
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic
   use asperity_law_unloading_chebyshev, only: chebyshev_coefficients, chebyshev_points, &
      powers_of_chebyshev
   use asperity_law_unloading_compiled_law, only: brackets_per_sigma, compiled_unloading_law, &
      degree_h, degree_x, n_brackets, n_strips, n_strips_with_cells, strip_half_width, &
      strip_polynomial, unloading_cell
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law, largest_mean_ratio
   use asperity_law_unloading_summit, only: elastic_recovery
   implicit none
   private
   public :: new_compiled_unloading_law

   !> Pressure over that at the closest separation down to which there are cells
   real(wp), parameter :: smallest_pressure_ratio = 1.0e-12_wp
   !> Last Chebyshev coefficients of a good polynomial, over its smallest value
   real(wp), parameter :: good_tail = 1.0e-9_wp
   !> Cells of a region are halved at most so often
   integer, parameter :: most_halvings = 12
   !> Below it a value has not all its digits, or none
   real(wp), parameter :: smallest_value = 1.0e-280_wp

contains

   !> Compile the law. `error` is set when the properties were never built or have no memory.
   pure subroutine new_compiled_unloading_law(law, properties, error)
      !> Result
      type(compiled_unloading_law), intent(out) :: law
      !> Checked properties, with elastic unloading
      type(normal_properties), intent(in) :: properties
      !> Set when the properties were never built or have no memory
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: start(:)
      logical, allocatable :: rooted(:)
      integer :: strip, i

      call new_compiled_law(law%virgin, properties, error)
      if (allocated(error)) return
      if (properties%unloading /= unloading_elastic) then
         call fatal_error(error, 'the law has no memory (unloading is reversible): compile it '// &
            'with new_compiled_law')
         return
      end if
      do strip = 1, n_strips
         call compile_strip(law, strip)
      end do
      allocate (start(0), rooted(0))
      do strip = 1, n_strips_with_cells
         law%first_cell(strip) = size(start) + 1
         call divide_strip(properties, middle_of(strip), start, rooted, law%furthest(strip))
      end do
      law%first_cell(n_strips_with_cells + 1) = size(start) + 1
      allocate (law%cells(size(start)))
      do strip = 1, n_strips_with_cells
         associate (last => law%first_cell(strip + 1) - 1)
            do i = law%first_cell(strip), last - 1
               call compile_cell(law%cells(i), properties, middle_of(strip), start(i), &
                  start(i + 1), rooted(i))
            end do
            call compile_cell(law%cells(last), properties, middle_of(strip), start(last), &
               law%furthest(strip), rooted(last))
         end associate
      end do
      call move_alloc(start, law%start)
      call find_limits(law)
   end subroutine new_compiled_unloading_law

   !> Middle of a strip of h.
   pure real(wp) function middle_of(strip)
      integer, intent(in) :: strip

      middle_of = first + strip_half_width*(2*strip - 1)
   end function middle_of

   !> The direct law at d_m/sigma and u/sigma; no retraction is just off the virgin branch.
   pure elemental function unloaded(properties, h, u) result(response)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h, u
      type(normal_response) :: response

      associate (p => properties)
         response = evaluate_unloading_law(p, h*p%sigma, max(u*p%sigma, 1.0e-14_wp*p%w1))
      end associate
   end function unloaded

   !> Recoverable energy and plastic dissipation of the virgin branch in one strip.
   pure subroutine compile_strip(law, strip)
      type(compiled_unloading_law), intent(inout) :: law
      integer, intent(in) :: strip
      type(normal_response) :: r(0:degree_h)

      associate (p => law%virgin%properties)
         r = evaluate_unloading_law(p, &
            p%sigma*(middle_of(strip) + strip_half_width*chebyshev_points(degree_h)), 0.0_wp)
      end associate
      call fit_in_strip(law%energy(strip), r%energy)
      call fit_in_strip(law%plastic_dissipation(strip), r%plastic_dissipation)
   end subroutine compile_strip

   !> A polynomial of h through values at the points of a strip; zero where they are about to
   !> underflow.
   pure subroutine fit_in_strip(polynomial, values)
      type(strip_polynomial), intent(out) :: polynomial
      real(wp), intent(in) :: values(0:degree_h)

      if (.not. all(values > smallest_value)) return
      polynomial%decay = 0.5_wp*log(values(0)/values(degree_h))
      polynomial%coefficients = powers_of_chebyshev(chebyshev_coefficients( &
         values*exp(polynomial%decay*chebyshev_points(degree_h))), 1.0_wp, 0.0_wp)
   end subroutine fit_in_strip

   !> Starts of the cells of one strip, which of them end where a stage of summits has parted, and
   !> the end of the last.
   pure subroutine divide_strip(properties, middle, start, rooted, furthest)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle
      real(wp), allocatable, intent(inout) :: start(:)
      logical, allocatable, intent(inout) :: rooted(:)
      real(wp), intent(out) :: furthest
      real(wp) :: ends(2), from
      type(normal_response) :: r
      integer :: i

      associate (p => properties)
         furthest = 0.0_wp
         do i = -1, 1, 2
            associate (d => p%sigma*(middle + i*strip_half_width))
               r = evaluate_unloading_law(p, d, 0.0_wp)
               furthest = max(furthest, retraction_for_pressure(p, d, &
                  smallest_pressure_ratio*r%pressure)/p%sigma)
            end associate
         end do
         ends = [p%w1, elastic_recovery(p, p%w2)]/p%sigma
         from = 0.0_wp
         do i = 1, 2
            if (ends(i) >= furthest) exit
            call divide(p, middle, from, ends(i), .true., most_halvings, start, rooted)
            from = ends(i)
         end do
         call divide(p, middle, from, furthest, .false., most_halvings, start, rooted)
      end associate
   end subroutine divide_strip

   !> Append a cell, or the cells of its halves where it is no good one.
   pure recursive subroutine divide(properties, middle, from, to, root, halvings, start, rooted)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle, from, to
      logical, intent(in) :: root
      integer, intent(in) :: halvings
      real(wp), allocatable, intent(inout) :: start(:)
      logical, allocatable, intent(inout) :: rooted(:)
      type(normal_response) :: r(0:degree_x)
      real(wp) :: u(0:degree_x), c(0:degree_x), half
      logical :: good
      integer :: i

      good = .true.
      u = points_of(from, to, root)
      do i = -1, 1
         r = unloaded(properties, middle + i*strip_half_width, u)
         c = chebyshev_coefficients(r%stiffness)
         good = maxval(abs(c(degree_x - 1:))) < good_tail*minval(r%stiffness)
         if (.not. good) exit
      end do
      if (good .or. halvings == 0) then
         start = [start, from]
         rooted = [rooted, root]
      else
         half = 0.5_wp*(from + to)
         ! far from zero over their own size: the law is least smooth there
         if (from > 0.0_wp .and. to > 4.0_wp*from) half = sqrt(from*to)
         call divide(properties, middle, from, half, .false., halvings - 1, start, rooted)
         call divide(properties, middle, half, to, root, halvings - 1, start, rooted)
      end if
   end subroutine divide

   !> Retractions over sigma at the points of a cell.
   pure function points_of(from, to, root) result(u)
      real(wp), intent(in) :: from, to
      logical, intent(in) :: root
      real(wp) :: u(0:degree_x)

      associate (t => chebyshev_points(degree_x))
         if (root) then
            u = to - (to - from)*(0.5_wp*(1.0_wp + t))**2
         else
            u = 0.5_wp*(from + to) - 0.5_wp*(to - from)*t
         end if
      end associate
   end function points_of

   !> The polynomials of one cell of the strip about `middle`.
   pure subroutine compile_cell(cell, properties, middle, from, to, root)
      type(unloading_cell), intent(out) :: cell
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle, from, to
      logical, intent(in) :: root
      type(normal_response) :: r(0:degree_x)
      real(wp) :: c(0:degree_x + 2, 0:degree_h), h(0:degree_h), u(0:degree_x), scale, shift
      integer :: i

      if (root) then
         cell%origin = to
         cell%inverse_size = 1.0_wp/(to - from)
         cell%power = 2
         scale = 2.0_wp
         shift = -1.0_wp
      else
         cell%origin = 0.5_wp*(from + to)
         cell%inverse_size = 2.0_wp/(to - from)
         cell%power = 1
         scale = 1.0_wp
         shift = 0.0_wp
      end if
      cell%length = properties%sigma/cell%inverse_size
      h = middle + strip_half_width*chebyshev_points(degree_h)
      do i = 0, degree_h
         r(0) = unloaded(properties, h(i), cell%origin)
         c(0:1, i) = [r(0)%energy, r(0)%pressure]
      end do
      cell%decay = 0.5_wp*log(c(1, 0)/c(1, degree_h))
      u = points_of(from, to, root)
      do i = 0, degree_h
         r = unloaded(properties, h(i), u)
         c(2:, i) = powers_of_chebyshev(chebyshev_coefficients(r%stiffness), scale, shift)
         c(:, i) = c(:, i)*exp(cell%decay*(h(i) - middle)/strip_half_width)
      end do
      do i = 0, degree_x + 2
         cell%coefficients(i, :) = powers_of_chebyshev(chebyshev_coefficients(c(i, :)), 1.0_wp, &
            0.0_wp)
      end do
   end subroutine compile_cell

   !> Find the limits of the law, by bisection, and where nothing touches any more.
   pure subroutine find_limits(law)
      type(compiled_unloading_law), intent(inout) :: law
      real(wp) :: near, distant, h, moments(0:2)

      associate (p => law%virgin%properties)
         near = first
         distant = vanishing_separation
         do while (distant - near > epsilon(h)*max(1.0_wp, abs(near)))
            h = 0.5_wp*(near + distant)
            moments = tail_moments(h)
            if (p%sigma*moments(1) > largest_mean_ratio*p%w1*moments(0)) then
               near = h
            else
               distant = h
            end if
         end do
         law%memory_limit = distant
         law%vanishing_retraction = elastic_recovery(p, (vanishing_separation - first)*p%sigma) &
            /p%sigma
         call bracket_area(law)
      end associate
   end subroutine find_limits

   !> Bracket, from far to near, the retractions at which the real area is the nominal one. They
   !> rise as the closest separation falls.
   pure subroutine bracket_area(law)
      type(compiled_unloading_law), intent(inout) :: law
      real(wp) :: below, above, step, u
      type(normal_response) :: r
      integer :: i, j

      law%area_bracket = 0.0_wp
      below = 0.0_wp
      step = 1.0e-3_wp
      associate (limits => law%virgin%limits)
      do i = min(n_brackets, int((min(limits(1), vanishing_separation) - first)*brackets_per_sigma)), 0, -1
         above = below + step
         r = unloaded(law%virgin%properties, first + real(i, wp)/brackets_per_sigma, above)
         do while (r%area_fraction > 1.0_wp)
            below = above
            step = 2.0_wp*step
            above = below + step
            r = unloaded(law%virgin%properties, first + real(i, wp)/brackets_per_sigma, above)
         end do
         do j = 1, 5
            u = 0.5_wp*(below + above)
            r = unloaded(law%virgin%properties, first + real(i, wp)/brackets_per_sigma, u)
            if (r%area_fraction > 1.0_wp) then
               below = u
            else
               above = u
            end if
         end do
         law%area_bracket(:, i) = [below, above]
         step = max(step/16.0_wp, above - below)
      end do
      end associate
   end subroutine bracket_area

end module asperity_law_unloading_compile_law
