!> Compiles the pieces of the law with memory: values of the direct law at Chebyshev-Lobatto points
!> become the polynomials of `asperity_law_unloading_cell`. Cells are halved until the stiffness is
!> a good polynomial of its own variable at three closest separations of the strip.
module asperity_law_unloading_compile_cell
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_cell, only: degree_h, degree_x, strip_half_width, &
      strip_polynomial, unloading_cell
   use asperity_law_unloading_chebyshev, only: chebyshev_coefficients, chebyshev_points, &
      powers_of_chebyshev
   use asperity_law_unloading_law, only: evaluate_unloading_branch
   implicit none
   private
   public :: unloaded, fit_in_strip, divide_region, compile_cell

   !> Last Chebyshev coefficients of a good polynomial, over its smallest value
   real(wp), parameter :: good_tail = 1.0e-10_wp
   !> A region is halved at most so often
   integer, parameter :: most_halvings = 12
   !> Below it a value has not all its digits, or none
   real(wp), parameter :: smallest_value = 1.0e-300_wp

contains

   !> The direct law on the unloading branch, by numbers over sigma.
   pure elemental function unloaded(properties, h, u) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation and retraction over sigma
      real(wp), intent(in) :: h, u
      type(normal_response) :: response

      call evaluate_unloading_branch(properties, h*properties%sigma, u*properties%sigma, response)
   end function unloaded

   pure elemental real(wp) function stiffness_at(properties, h, u) result(stiffness)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h, u
      type(normal_response) :: response

      response = unloaded(properties, h, u)
      stiffness = response%stiffness
   end function stiffness_at

   !> A polynomial of h through values at the points of a strip; zero where they are about to
   !> underflow.
   pure subroutine fit_in_strip(polynomial, values)
      !> Result
      type(strip_polynomial), intent(out) :: polynomial
      !> At `chebyshev_points`
      real(wp), intent(in) :: values(0:degree_h)

      if (.not. all(values > smallest_value)) return
      polynomial%decay = 0.5_wp*log(values(0)/values(degree_h))
      polynomial%coefficients = powers_of_chebyshev(chebyshev_coefficients( &
         values*exp(polynomial%decay*chebyshev_points(degree_h))), 1.0_wp, 0.0_wp)
   end subroutine fit_in_strip

   !> Append the cells of a region of the retraction, halved until each is good.
   pure recursive subroutine divide_region(properties, middle, from, to, root, starts, roots, &
         halvings)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Middle of the strip
      real(wp), intent(in) :: middle
      !> Ends of the region over sigma
      real(wp), intent(in) :: from, to
      !> Whether summits of one stage lose contact at the upper end
      logical, intent(in) :: root
      !> Where cells start, over sigma, and whether x is a root in them
      real(wp), allocatable, intent(inout) :: starts(:)
      logical, allocatable, intent(inout) :: roots(:)
      !> How often the region was halved so far
      integer, intent(in) :: halvings
      real(wp), allocatable :: more_starts(:)
      logical, allocatable :: more_roots(:)
      real(wp) :: half

      if (halvings == most_halvings .or. is_good(properties, middle, from, to, root)) then
         allocate (more_starts(size(starts) + 1), source=[starts, from])
         call move_alloc(more_starts, starts)
         allocate (more_roots(size(roots) + 1), source=[roots, root])
         call move_alloc(more_roots, roots)
      else
         half = 0.5_wp*(from + to)
         ! the law is the less smooth the nearer zero retraction is
         if (from > 0.0_wp .and. to > 4.0_wp*from) half = sqrt(from*to)
         call divide_region(properties, middle, from, half, .false., starts, roots, halvings + 1)
         call divide_region(properties, middle, half, to, root, starts, roots, halvings + 1)
      end if
   end subroutine divide_region

   !> Whether the stiffness is a good polynomial of x in the middle and at both ends of the strip.
   pure logical function is_good(properties, middle, from, to, root)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle, from, to
      logical, intent(in) :: root
      real(wp), dimension(0:degree_x) :: u, stiffness, c
      integer :: i

      u = points_of(from, to, root)
      do i = -1, 1
         stiffness = stiffness_at(properties, middle + i*strip_half_width, u)
         c = chebyshev_coefficients(stiffness)
         is_good = maxval(abs(c(degree_x - 1:))) < good_tail*minval(stiffness)
         if (.not. is_good) return
      end do
   end function is_good

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
      !> Result
      type(unloading_cell), intent(out) :: cell
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Middle of the strip, and ends of the cell over sigma
      real(wp), intent(in) :: middle, from, to
      !> Whether x is a root
      logical, intent(in) :: root
      type(normal_response) :: r
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
         r = unloaded(properties, h(i), cell%origin)
         c(0:1, i) = [r%energy, r%pressure]
      end do
      cell%decay = 0.5_wp*log(c(1, 0)/c(1, degree_h))
      u = points_of(from, to, root)
      do i = 0, degree_h
         c(2:, i) = powers_of_chebyshev(chebyshev_coefficients( &
            stiffness_at(properties, h(i), u)), scale, shift)
         c(:, i) = c(:, i)*exp(cell%decay*(h(i) - middle)/strip_half_width)
      end do
      do i = 0, degree_x + 2
         cell%coefficients(i, :) = powers_of_chebyshev(chebyshev_coefficients(c(i, :)), 1.0_wp, &
            0.0_wp)
      end do
   end subroutine compile_cell

end module asperity_law_unloading_compile_cell
