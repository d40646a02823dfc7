!> The law with memory compiled to polynomials, for very many evaluations: pressure, stiffness and
!> recoverable energy within 1e-9 of the direct law. Built once from the properties by
!> `asperity_law_unloading_compile_law`, then read only, so that threads share it.
!>
!> The virgin branch is the compiled law without memory; what it lacks, the recoverable energy and
!> the plastic dissipation, are polynomials of h = d/sigma in strips. On the unloading branch each
!> strip of h_m = d_m/sigma is divided into cells of the retraction u, as many as the properties
!> ask for. A cell holds the stiffness as a polynomial of h_m and of x, which is u itself or, where
!> summits of one stage lose contact at the cell's end, the root of what is left to that end: there
!> the law has terms of power 5/2. Pressure and energy are its integrals over u, exactly.
!>
!> Cells cover -8 <= h_m < 8 and the retractions until the pressure is 1e-12 of that at the closest
!> separation. Outside, and on the virgin branch outside -8 <= h < 36, the law is evaluated directly.
module asperity_law_unloading_compiled_law
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law, first
   use asperity_law_normal_law, only: normal_response, vanishing_separation
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      memory_beyond_data, pressure_above_hardness
   implicit none
   private
   public :: compiled_unloading_law, evaluate_compiled_unloading_law, &
      compiled_plastic_dissipation, size_in_bytes

   !> Degrees of the polynomials: of h, and of x in the stiffness
   integer, parameter, public :: degree_h = 13, degree_x = 15
   !> Strips of h: half their width, how many there are, and how many of them have cells
   real(wp), parameter, public :: strip_half_width = 1.0_wp
   integer, parameter, public :: n_strips = 22, n_strips_with_cells = 8
   !> Where the real area falls to the nominal one is bracketed at this many h a sigma
   integer, parameter, public :: brackets_per_sigma = 16
   integer, parameter, public :: n_brackets = nint(2*strip_half_width)*n_strips_with_cells &
      *brackets_per_sigma
   !> Factors of the powers of x in the integral of the stiffness, and in the integral of that;
   !> column 1 where u is linear in x, column 2 where it is quadratic
   integer :: i_
   real(wp), parameter :: once(0:degree_x, 2) = reshape([ &
      [(1.0_wp/(i_ + 1), i_=0, degree_x)], [(2.0_wp/(i_ + 2), i_=0, degree_x)]], &
      [degree_x + 1, 2])
   real(wp), parameter :: twice(0:degree_x, 2) = reshape([ &
      [(1.0_wp/((i_ + 1)*(i_ + 2)), i_=0, degree_x)], &
      [(4.0_wp/((i_ + 2)*(i_ + 4)), i_=0, degree_x)]], [degree_x + 1, 2])

   !> A polynomial of h in a strip, times exp(-decay t), t = (h - middle)/strip_half_width
   type, public :: strip_polynomial
      real(wp) :: decay = 0.0_wp
      real(wp) :: coefficients(0:degree_h) = 0.0_wp
   end type strip_polynomial

   !> A cell of the unloading branch: energy and pressure at its origin (the middle, or its end
   !> where x is a root) and the powers of x in the stiffness, each a polynomial of t, all times
   !> exp(-decay t)
   type, public :: unloading_cell
      !> Origin of x and 1/(size of x), over sigma
      real(wp) :: origin, inverse_size
      !> What x, or its square, is in mm of closure
      real(wp) :: length
      !> 1 where u is linear in x, 2 where x is a root
      integer :: power
      real(wp) :: decay
      real(wp) :: coefficients(0:degree_x + 2, 0:degree_h)
   end type unloading_cell

   !> The law with memory of one pair of faces, compiled. Build it with
   !> `new_compiled_unloading_law`; read only after: all is for the evaluation.
   type :: compiled_unloading_law
      !> The virgin branch
      type(compiled_law) :: virgin
      !> Separation over sigma below which `memory_beyond_data` is set
      real(wp) :: memory_limit
      !> Retraction over sigma at which the last summit that counts has parted
      real(wp) :: vanishing_retraction
      !> Of the virgin branch
      type(strip_polynomial) :: energy(n_strips), plastic_dissipation(n_strips)
      !> Number of the first cell of a strip, and retraction over sigma at the end of the last
      integer :: first_cell(n_strips_with_cells + 1)
      real(wp) :: furthest(n_strips_with_cells)
      !> Retraction over sigma at which a cell starts
      real(wp), allocatable :: start(:)
      type(unloading_cell), allocatable :: cells(:)
      !> Retractions over sigma, below and above that at which the real area is the nominal one
      real(wp) :: area_bracket(2, 0:n_brackets)
   end type compiled_unloading_law

contains

   !> Pressure, stiffness and recoverable energy, and validity, at one closest separation and
   !> retraction: on the virgin branch where the retraction is zero or less (see
   !> `evaluate_unloading_law`).
   pure elemental subroutine evaluate_compiled_unloading_law(law, closest_separation, retraction, &
         pressure, stiffness, energy, validity)
      !> Compiled law
      type(compiled_unloading_law), intent(in) :: law
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm
      real(wp), intent(in) :: retraction
      !> Pressure, MPa, and stiffness at fixed memory, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Recoverable energy, N/mm
      real(wp), intent(out) :: energy
      !> Sum of flags (see `asperity_law_validity`)
      integer, intent(out) :: validity
      real(wp) :: h, u
      integer :: strip
      type(normal_response) :: direct

      h = closest_separation*law%virgin%inverse_sigma
      u = retraction*law%virgin%inverse_sigma
      if (.not. u > 0.0_wp) then
         call evaluate_virgin(law, closest_separation + retraction, pressure, stiffness, energy, &
            validity)
         return
      end if
      strip = strip_at(h)
      if (strip >= 1 .and. strip <= n_strips_with_cells) then
         if (u < law%furthest(strip)) then
            associate (i => cell_at(law, strip, u))
               call evaluate_cell(law%cells(i), place_in_strip(h, strip), u, pressure, &
                  stiffness, energy)
            end associate
            validity = flags_at(law, h, u, pressure)
            return
         end if
         if (u > law%vanishing_retraction) then
            pressure = 0.0_wp
            stiffness = 0.0_wp
            energy = 0.0_wp
            validity = flags_at(law, h, u, pressure)
            return
         end if
      end if
      direct = evaluate_unloading_law(law%virgin%properties, closest_separation, retraction)
      pressure = direct%pressure
      stiffness = direct%stiffness
      energy = direct%energy
      validity = direct%validity
   end subroutine evaluate_compiled_unloading_law

   !> Plastic dissipation since first touch, N/mm: a function of the closest separation alone.
   pure elemental real(wp) function compiled_plastic_dissipation(law, closest_separation) &
         result(dissipation)
      !> Compiled law
      type(compiled_unloading_law), intent(in) :: law
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      real(wp) :: h
      integer :: strip
      type(normal_response) :: direct

      h = closest_separation*law%virgin%inverse_sigma
      strip = strip_at(h)
      if (strip >= 1 .and. strip <= n_strips) then
         dissipation = value_in_strip(law%plastic_dissipation(strip), place_in_strip(h, strip))
      else
         direct = evaluate_unloading_law(law%virgin%properties, closest_separation, 0.0_wp)
         dissipation = direct%plastic_dissipation
      end if
   end function compiled_plastic_dissipation

   !> Size of a compiled law in memory, bytes.
   pure integer function size_in_bytes(law)
      !> Compiled law
      type(compiled_unloading_law), intent(in) :: law
      type(unloading_cell) :: cell

      size_in_bytes = (storage_size(law) + size(law%cells)*storage_size(cell) &
         + size(law%start)*storage_size(law%start))/8
   end function size_in_bytes

   !> The virgin branch.
   pure subroutine evaluate_virgin(law, separation, pressure, stiffness, energy, validity)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp), intent(out) :: pressure, stiffness, energy
      integer, intent(out) :: validity
      real(wp) :: h
      integer :: strip
      type(normal_response) :: direct

      h = separation*law%virgin%inverse_sigma
      call evaluate_compiled_law(law%virgin, separation, pressure, stiffness, validity=validity)
      if (h < law%memory_limit) validity = ior(validity, memory_beyond_data)
      strip = strip_at(h)
      if (strip >= 1 .and. strip <= n_strips) then
         energy = value_in_strip(law%energy(strip), place_in_strip(h, strip))
      else if (h > vanishing_separation) then
         energy = 0.0_wp
      else
         direct = evaluate_unloading_law(law%virgin%properties, separation, 0.0_wp)
         energy = direct%energy
         validity = direct%validity
      end if
   end subroutine evaluate_virgin

   !> Number of the strip that holds an h, 1 to `n_strips`; 0 where none does.
   pure integer function strip_at(h)
      real(wp), intent(in) :: h
      real(wp) :: strips

      strips = (h - first)*(0.5_wp/strip_half_width)
      strip_at = 0
      if (strips >= 0.0_wp .and. strips < n_strips) strip_at = 1 + int(strips)
   end function strip_at

   !> Place of an h in its strip, -1 to 1.
   pure real(wp) function place_in_strip(h, strip) result(t)
      real(wp), intent(in) :: h
      integer, intent(in) :: strip

      t = (h - first)/strip_half_width - (2*strip - 1)
   end function place_in_strip

   !> A polynomial of h.
   pure real(wp) function value_in_strip(polynomial, t) result(value)
      type(strip_polynomial), intent(in) :: polynomial
      real(wp), intent(in) :: t
      integer :: i

      value = polynomial%coefficients(degree_h)
      do i = degree_h - 1, 0, -1
         value = value*t + polynomial%coefficients(i)
      end do
      value = value*exp(-polynomial%decay*t)
   end function value_in_strip

   !> Number of the cell that holds a retraction over sigma.
   pure integer function cell_at(law, strip, u)
      type(compiled_unloading_law), intent(in) :: law
      integer, intent(in) :: strip
      real(wp), intent(in) :: u
      integer :: i

      cell_at = law%first_cell(strip)
      do i = law%first_cell(strip) + 1, law%first_cell(strip + 1) - 1
         if (law%start(i) <= u) cell_at = cell_at + 1
      end do
   end function cell_at

   !> The polynomials of a cell: first of h, then the stiffness and its two integrals over u.
   pure subroutine evaluate_cell(cell, t, u, pressure, stiffness, energy)
      type(unloading_cell), intent(in) :: cell
      real(wp), intent(in) :: t, u
      real(wp), intent(out) :: pressure, stiffness, energy
      real(wp) :: c(0:degree_x + 2), decay, x, closure
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
      stiffness = 0.0_wp
      pressure = 0.0_wp
      energy = 0.0_wp
         do i = degree_x, 0, -1
            stiffness = stiffness*x + c(i + 2)
            pressure = pressure*x + c(i + 2)*once(i, cell%power)
            energy = energy*x + c(i + 2)*twice(i, cell%power)
         end do
      decay = exp(-cell%decay*t)
      energy = decay*(c(0) + closure*(c(1) + closure*energy))
      pressure = decay*(c(1) + closure*pressure)
      stiffness = decay*stiffness
   end subroutine evaluate_cell

   !> Flags on the unloading branch.
   pure integer function flags_at(law, h, u, pressure) result(flags)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h, u, pressure

      flags = law%virgin%properties%validity
      if (pressure > law%virgin%properties%hardness) flags = ior(flags, pressure_above_hardness)
      if (h < law%virgin%limits(3)) flags = ior(flags, closure_above_half_radius)
      if (h < law%memory_limit) flags = ior(flags, memory_beyond_data)
      ! the area falls as a face parts: never above nominal unless it was at the closest separation
      if (h < law%virgin%limits(1)) then
         if (area_is_above_nominal(law, h, u)) flags = ior(flags, area_above_nominal)
      end if
   end function flags_at

   !> Whether the real area is above the nominal one: by the retraction alone, or by the direct law
   !> where that is too close to tell.
   pure logical function area_is_above_nominal(law, h, u)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h, u
      type(normal_response) :: direct
      integer :: i

      i = int((h - first)*brackets_per_sigma)
      area_is_above_nominal = u < law%area_bracket(1, i + 1)
      if (area_is_above_nominal .or. u > law%area_bracket(2, i)) return
      associate (p => law%virgin%properties)
         direct = evaluate_unloading_law(p, h*p%sigma, u*p%sigma)
      end associate
      area_is_above_nominal = direct%area_fraction > 1.0_wp
   end function area_is_above_nominal

end module asperity_law_unloading_compiled_law
