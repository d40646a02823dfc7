!> Pieces of the compiled law with memory: a polynomial of h = d/sigma in a strip of h, and a cell
!> of such a strip and of the retraction u. The cell holds the stiffness as a polynomial of h and of
!> x, which is u itself or, where summits of one stage lose contact at the cell's end, the root of
!> what is left to that end: there the law has terms of power 5/2. Pressure and energy are its
!> integrals over u, exactly.
module asperity_law_unloading_cell
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: strip_polynomial, unloading_cell, value_in_strip, evaluate_cell

   !> Degrees of the polynomials: of h, and of x in the stiffness
   integer, parameter, public :: degree_h = 13, degree_x = 15
   !> Half the width of a strip of h
   real(wp), parameter, public :: strip_half_width = 1.0_wp
   !> The powers of x, and the factors that they get in the integral of the stiffness over u and in
   !> the integral of that; column 1 where u is linear in x, column 2 where x is a root
   real(wp), parameter :: n(0:degree_x) = &
      real([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15], wp)
   real(wp), parameter :: once(0:degree_x, 2) = &
      reshape([1.0_wp/(n + 1.0_wp), 2.0_wp/(n + 2.0_wp)], [degree_x + 1, 2])
   real(wp), parameter :: twice(0:degree_x, 2) = reshape([1.0_wp/((n + 1.0_wp)*(n + 2.0_wp)), &
      4.0_wp/((n + 2.0_wp)*(n + 4.0_wp))], [degree_x + 1, 2])

   !> A polynomial of t = (h - middle)/strip_half_width, times exp(-decay t)
   type :: strip_polynomial
      real(wp) :: decay = 0.0_wp
      !> Of the powers of t
      real(wp) :: coefficients(0:degree_h) = 0.0_wp
   end type strip_polynomial

   !> A cell of the unloading branch
   type :: unloading_cell
      !> Origin of x and 1/(size of x), over sigma
      real(wp) :: origin, inverse_size
      !> What x, or its square, is in mm of closure
      real(wp) :: length
      !> 1 where u is linear in x, 2 where x is a root
      integer :: power
      !> All is times exp(-decay t)
      real(wp) :: decay
      !> Energy and pressure at the origin, which is the middle or, where x is a root, the end, and
      !> the coefficients of the powers of x in the stiffness; columns are the powers of t
      real(wp) :: coefficients(0:degree_x + 2, 0:degree_h)
   end type unloading_cell

contains

   !> Value of a polynomial of h.
   pure real(wp) function value_in_strip(polynomial, t) result(value)
      !> The polynomial
      type(strip_polynomial), intent(in) :: polynomial
      !> Place of h in the strip, -1 to 1
      real(wp), intent(in) :: t
      integer :: i

      value = polynomial%coefficients(degree_h)
      do i = degree_h - 1, 0, -1
         value = value*t + polynomial%coefficients(i)
      end do
      value = value*exp(-polynomial%decay*t)
   end function value_in_strip

   !> The polynomials of a cell: first of h, then the stiffness and its two integrals over u.
   pure subroutine evaluate_cell(cell, t, u, pressure, stiffness, energy)
      !> The cell
      type(unloading_cell), intent(in) :: cell
      !> Place of h in its strip, -1 to 1, and the retraction over sigma
      real(wp), intent(in) :: t, u
      !> MPa, MPa/mm and N/mm
      real(wp), intent(out) :: pressure, stiffness, energy
      real(wp) :: c(0:degree_x + 2), decay, x, closure, k(2), p(2), e(2)
      integer :: i

      ! four powers of h at a time, so that the next step need not wait for each
      associate (a => cell%coefficients)
         c = a(:, degree_h - 1) + t*a(:, degree_h)
         do i = degree_h - 5, 0, -4
            c = c*t**4 + ((a(:, i) + t*a(:, i + 1)) + t**2*(a(:, i + 2) + t*a(:, i + 3)))
         end do
      end associate
      x = (cell%origin - u)*cell%inverse_size
      closure = x*cell%length
      if (cell%power == 2) x = sqrt(max(x, 0.0_wp))
      ! even and odd powers of x apart, for the same reason
      k = 0.0_wp
      p = 0.0_wp
      e = 0.0_wp
      do i = degree_x - 1, 0, -2
         k = k*x**2 + c(i + 2:i + 3)
         p = p*x**2 + c(i + 2:i + 3)*once(i:i + 1, cell%power)
         e = e*x**2 + c(i + 2:i + 3)*twice(i:i + 1, cell%power)
      end do
      decay = exp(-cell%decay*t)
      energy = decay*(c(0) + closure*(c(1) + closure*(e(1) + x*e(2))))
      pressure = decay*(c(1) + closure*(p(1) + x*p(2)))
      stiffness = decay*(k(1) + x*k(2))
   end subroutine evaluate_cell

end module asperity_law_unloading_cell
