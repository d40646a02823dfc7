!> The law with memory compiled to polynomials, for very many evaluations: pressure, stiffness and
!> recoverable energy within 1e-9 of the direct law. Built once from the properties by
!> `asperity_law_unloading_compile_law`, then read only, so that threads share it.
!>
!> The virgin branch is the compiled law without memory; what that lacks, the recoverable energy and
!> the plastic dissipation, are polynomials of h = d/sigma in strips of h. On the unloading branch
!> each strip of h_m = d_m/sigma is divided into cells of the retraction, as many as the properties
!> ask for (see `asperity_law_unloading_cell`): about 120 in all, 300 kB.
!>
!> Cells cover -8 <= h_m < 8 and the retractions until the pressure is 1e-12 of that at the closest
!> separation. Outside, and on the virgin branch outside -8 <= h < 36, the direct law is evaluated.
!> Verified for 1e-6 <= w1/sigma <= 1e2. A plastic dissipation below 1e-260 N/mm may be zero.
module asperity_law_unloading_compiled_law
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_intervals, only: first
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_gaussian_tail, only: vanishing_height
   use asperity_law_normal_law, only: normal_response
   use asperity_law_unloading_cell, only: evaluate_cell, strip_half_width, strip_polynomial, &
      unloading_cell, value_in_strip
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      memory_beyond_data, pressure_above_hardness
   implicit none
   private
   public :: compiled_unloading_law, evaluate_compiled_unloading_law, &
      compiled_plastic_dissipation, size_in_bytes

   !> Number of strips of h, and how many of them have cells
   integer, parameter, public :: n_strips = 22, n_strips_with_cells = 8
   !> Where the real area falls to the nominal one is bracketed at this many h a sigma
   integer, parameter, public :: brackets_per_sigma = 16
   integer, parameter, public :: n_brackets = nint(2.0_wp*strip_half_width)*n_strips_with_cells &
      *brackets_per_sigma

   !> The law with memory of one pair of faces, compiled. Build it with
   !> `new_compiled_unloading_law`; read only after: all is for the evaluation.
   type :: compiled_unloading_law
      !> The virgin branch
      type(compiled_law) :: virgin
      !> Separation over sigma below which `memory_beyond_data` is set
      real(wp) :: memory_limit
      !> Retraction over sigma beyond which nothing touches
      real(wp) :: vanishing_retraction
      !> Of the virgin branch
      type(strip_polynomial) :: energy(n_strips), plastic_dissipation(n_strips)
      !> Number of the first cell of a strip, and retraction over sigma at the end of the last
      integer :: first_cell(n_strips_with_cells + 1)
      real(wp) :: furthest(n_strips_with_cells)
      !> Retractions over sigma at which the cells start
      real(wp), allocatable :: starts(:)
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
         + size(law%starts)*storage_size(law%starts))/8
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
      else if (h > vanishing_height) then
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

   !> Number of the cell that holds a retraction over sigma.
   pure integer function cell_at(law, strip, u)
      type(compiled_unloading_law), intent(in) :: law
      integer, intent(in) :: strip
      real(wp), intent(in) :: u
      integer :: i

      cell_at = law%first_cell(strip)
      do i = law%first_cell(strip) + 1, law%first_cell(strip + 1) - 1
         if (law%starts(i) <= u) cell_at = cell_at + 1
      end do
   end function cell_at

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
