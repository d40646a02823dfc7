!> Compiles the law with memory: divides the range of closest separation and retraction, compiles
!> each piece (see `asperity_law_unloading_compile_cell`), and finds where the law's limits are
!> passed.
module asperity_law_unloading_compile_law
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_intervals, only: first
   use asperity_law_gaussian_tail, only: find_tail_moments, vanishing_height
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic
   use asperity_law_unloading_cell, only: degree_h, strip_half_width
   use asperity_law_unloading_chebyshev, only: chebyshev_points
   use asperity_law_unloading_compile_cell, only: compile_cell, divide_region, &
      fit_in_strip, unloaded
   use asperity_law_unloading_compiled_law, only: brackets_per_sigma, compiled_unloading_law, &
      n_brackets, n_strips, n_strips_with_cells
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law, is_flattened_too_far
   use asperity_law_unloading_summit, only: elastic_recovery
   implicit none
   private
   public :: new_compiled_unloading_law

   !> Pressure over that at the closest separation down to which there are cells
   real(wp), parameter :: smallest_pressure_ratio = 1.0e-12_wp

contains

   !> Compile the law. `error` is set when the properties were never built or have no memory.
   pure subroutine new_compiled_unloading_law(law, properties, error)
      !> Result
      type(compiled_unloading_law), intent(out) :: law
      !> Checked properties, with elastic unloading
      type(normal_properties), intent(in) :: properties
      !> Set when the properties were never built or have no memory
      type(error_type), allocatable, intent(out) :: error
      integer :: strip

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
      call compile_cells(law)
      call find_memory_limit(law)
      call bracket_area(law)
      associate (p => properties)
         law%vanishing_retraction = elastic_recovery(p, (vanishing_height - first)*p%sigma) &
            /p%sigma
      end associate
   end subroutine new_compiled_unloading_law

   !> Middle of a strip of h.
   pure real(wp) function middle_of(strip)
      integer, intent(in) :: strip

      middle_of = first + strip_half_width*(2*strip - 1)
   end function middle_of

   !> Recoverable energy and plastic dissipation of the virgin branch in one strip.
   pure subroutine compile_strip(law, strip)
      type(compiled_unloading_law), intent(inout) :: law
      integer, intent(in) :: strip
      real(wp), dimension(0:degree_h) :: h, energy, dissipation
      type(normal_response) :: r
      integer :: i

      h = middle_of(strip) + strip_half_width*chebyshev_points(degree_h)
      do i = 0, degree_h
         r = evaluate_unloading_law(law%virgin%properties, h(i)*law%virgin%properties%sigma, 0.0_wp)
         energy(i) = r%energy
         dissipation(i) = r%plastic_dissipation
      end do
      call fit_in_strip(law%energy(strip), energy)
      call fit_in_strip(law%plastic_dissipation(strip), dissipation)
   end subroutine compile_strip

   !> The cells of the unloading branch.
   pure subroutine compile_cells(law)
      type(compiled_unloading_law), intent(inout) :: law
      real(wp), allocatable :: starts(:)
      logical, allocatable :: roots(:)
      real(wp) :: to
      integer :: strip, i

      allocate (starts(0), roots(0))
      do strip = 1, n_strips_with_cells
         law%first_cell(strip) = size(starts) + 1
         call divide_strip(law%virgin%properties, middle_of(strip), starts, roots, &
            law%furthest(strip))
      end do
      law%first_cell(n_strips_with_cells + 1) = size(starts) + 1
      allocate (law%cells(size(starts)))
      do strip = 1, n_strips_with_cells
         to = law%furthest(strip)
         do i = law%first_cell(strip + 1) - 1, law%first_cell(strip), -1
            call compile_cell(law%cells(i), law%virgin%properties, middle_of(strip), starts(i), &
               to, roots(i))
            to = starts(i)
         end do
      end do
      call move_alloc(starts, law%starts)
   end subroutine compile_cells

   !> Append the cells of one strip, and find the end of the last.
   pure subroutine divide_strip(properties, middle, starts, roots, furthest)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle
      real(wp), allocatable, intent(inout) :: starts(:)
      logical, allocatable, intent(inout) :: roots(:)
      real(wp), intent(out) :: furthest
      real(wp) :: ends(2), from, d
      type(normal_response) :: r
      integer :: i

      associate (p => properties)
         furthest = 0.0_wp
         do i = -1, 1, 2
            d = p%sigma*(middle + i*strip_half_width)
            r = evaluate_normal_law(p, d)
            furthest = max(furthest, &
               retraction_for_pressure(p, d, smallest_pressure_ratio*r%pressure)/p%sigma)
         end do
         ! where the last elastic and the last elasto-plastic summits part
         ends = [p%w1, elastic_recovery(p, p%w2)]/p%sigma
         from = 0.0_wp
         do i = 1, 2
            if (ends(i) >= furthest) exit
            call divide_region(p, middle, from, ends(i), .true., starts, roots, 0)
            from = ends(i)
         end do
         call divide_region(p, middle, from, furthest, .false., starts, roots, 0)
      end associate
   end subroutine divide_strip

   !> Find, by bisection, where the mean deformation passes what unloading is known for.
   pure subroutine find_memory_limit(law)
      type(compiled_unloading_law), intent(inout) :: law
      real(wp) :: near, distant, h

      associate (p => law%virgin%properties)
         law%memory_limit = first
         if (.not. passes_memory(p, first)) return
         near = first
         distant = vanishing_height
         do while (distant - near > epsilon(h)*max(1.0_wp, abs(near)))
            h = 0.5_wp*(near + distant)
            if (passes_memory(p, h)) then
               near = h
            else
               distant = h
            end if
         end do
      end associate
      law%memory_limit = distant
   end subroutine find_memory_limit

   !> Whether summits are flattened too far at a closest separation over sigma.
   pure logical function passes_memory(properties, h)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h
      real(wp) :: moments(0:2)

      call find_tail_moments(h, moments)
      passes_memory = is_flattened_too_far(properties, moments)
   end function passes_memory

   !> Bracket the retractions at which the real area is the nominal one, from the largest closest
   !> separation at which it is ever above: they rise as the closest separation falls.
   pure subroutine bracket_area(law)
      type(compiled_unloading_law), intent(inout) :: law
      integer, parameter :: halvings = 5
      real(wp) :: h, below, above, step, u
      type(normal_response) :: r
      integer :: i, j, n

      law%area_bracket = 0.0_wp
      below = 0.0_wp
      step = 1.0e-3_wp
      associate (p => law%virgin%properties, limit => law%virgin%limits(1))
         n = min(n_brackets, int((min(limit, vanishing_height) - first)*brackets_per_sigma))
         do i = n, 0, -1
            h = first + real(i, wp)/brackets_per_sigma
            do
               above = below + step
               r = unloaded(p, h, above)
               if (.not. r%area_fraction > 1.0_wp) exit
               below = above
               step = 2.0_wp*step
            end do
            do j = 1, halvings
               u = 0.5_wp*(below + above)
               r = unloaded(p, h, u)
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
