!> The normal law of a rough face: summits with random heights, each of them elastic,
!> elasto-plastic or fully plastic (Eqs 23-26), as a function of the separation d of the rigid
!> plane from the mean plane of summit heights. Direct evaluation by quadrature, the reference
!> of everything else. The law is reversible; that with memory is in `asperity_law_unloading_law`.
!>
!> Three pieces, in the summit deformation t = w/sigma: elastic on (0, w1), elasto-plastic on
!> (w1, w2), plastic beyond. Each integral is scaled by the density at its largest point, so
!> that no piece underflows before the result does.
module asperity_law_normal_law
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_pieces_by_fixed_rule, only: evaluate_fixed_pieces, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_johnson, only: decay_score, find_johnson_pieces
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, elastoplastic_piece, &
      piece_type, plastic_piece
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      pressure_above_hardness, valid
   implicit none
   private
   public :: normal_response, evaluate_normal_law, evaluate_pressure, evaluate_scaled_law, &
      sum_pieces, apply_decay, is_closed_too_far

   !> Answer of the rough face at one separation.
   type :: normal_response
      !> Pressure on nominal area, MPa (Eq. 26)
      real(wp) :: pressure = 0.0_wp
      !> Normal stiffness -dp/dd, MPa/mm
      real(wp) :: stiffness = 0.0_wp
      !> Real area over nominal area (Eq. 25)
      real(wp) :: area_fraction = 0.0_wp
      !> Summits in contact per nominal area, 1/mm^2 (Eq. 24)
      real(wp) :: contact_density = 0.0_wp
      !> Stored energy per nominal area, N/mm: the integral of p from d to infinity, or with memory
      !> what of it is recoverable
      real(wp) :: energy = 0.0_wp
      !> Plastic dissipation per nominal area since first touch, N/mm; zero without memory
      real(wp) :: plastic_dissipation = 0.0_wp
      !> Shares of the pressure carried by elastic, elasto-plastic and plastic summits; they sum
      !> to one, also where the pressure itself underflows to zero
      real(wp) :: elastic_share = 1.0_wp, elastoplastic_share = 0.0_wp, plastic_share = 0.0_wp
      !> `valid`, or flags (see `asperity_law_validity`)
      integer :: validity = valid
   end type normal_response

contains

   !> Evaluate the law at one separation. Relative error below 1e-12 in every component that is
   !> a normal number, for -40 <= d/sigma <= 37, 1e-8 <= w1/sigma <= 1e3; zero where it underflows.
   !> The pressure never rises with d over steps above 64 eps max(sigma, |d|), round-off's size.
   pure elemental function evaluate_normal_law(properties, separation) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      type(normal_response) :: response

      call evaluate_scaled_law(properties, separation, response)
      call apply_decay(properties, decay_at(properties, separation), response)
   end function evaluate_normal_law

   !> What a contact point needs of the same, to the bit and in less time: no shares and no contact
   !> density.
   pure subroutine evaluate_pressure(properties, separation, pressure, stiffness, energy, &
         validity, pieces)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      !> Pressure, MPa; normal stiffness, MPa/mm; stored energy per nominal area, N/mm
      real(wp), intent(out) :: pressure, stiffness, energy
      !> `valid`, or flags
      integer, intent(out) :: validity
      !> The three pieces, with recoverable energy and dissipation of the elasto-plastic one
      type(piece_type), intent(out), optional :: pieces(3)
      type(piece_type) :: found(3)
      real(wp) :: h, decay, area_fraction, root(3), moments(0:2)
      integer :: i

      h = separation/properties%sigma
      if (properties%heights%is_gaussian) then
         call find_pieces(properties, separation, .false., present(pieces), found)
      else
         call find_johnson_pieces(properties, separation, found, moments(0:1))
      end if
      if (present(pieces)) pieces = found
      do i = 1, 3
         root(i) = root_of(found(i)%exponent)
      end do
      decay = decay_at(properties, separation)
      associate (p => properties)
         pressure = p%eta*p%n1*sum(root*root*found%pressure)*decay
         stiffness = p%eta*p%n1/p%w1*sum(root*root*found%stiffness)*decay
         area_fraction = p%eta*pi*p%radius*p%w1*sum(root*root*found%area)*decay
         energy = p%eta*p%n1*p%w1*sum(root*root*found%energy)*decay
         validity = p%validity
         if (area_fraction > 1.0_wp) validity = ior(validity, area_above_nominal)
         if (pressure > p%hardness) validity = ior(validity, pressure_above_hardness)
         if (p%heights%is_gaussian) then
            ! above the mean plane summits in contact are closed by 0.8 sigma or less in the mean
            if (h > 0.0_wp .and. 0.8_wp*p%sigma < 0.5_wp*p%radius) return
            call find_tail_moments(h, moments)
         end if
         if (is_closed_too_far(p, separation, moments)) &
            validity = ior(validity, closure_above_half_radius)
      end associate
   end subroutine evaluate_pressure

   !> Multiply what was scaled by the factor, and set the flags of area and pressure.
   pure subroutine apply_decay(properties, decay, response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> The factor
      real(wp), intent(in) :: decay
      !> Scaled values on entry
      type(normal_response), intent(inout) :: response

      associate (r => response)
         r%pressure = r%pressure*decay
         r%stiffness = r%stiffness*decay
         r%area_fraction = r%area_fraction*decay
         r%contact_density = r%contact_density*decay
         r%energy = r%energy*decay
         if (r%area_fraction > 1.0_wp) r%validity = ior(r%validity, area_above_nominal)
         if (r%pressure > properties%hardness) &
            r%validity = ior(r%validity, pressure_above_hardness)
      end associate
   end subroutine apply_decay

   !> The factor exp(-max(h, 0)^2/2), which scaled values lack: h is d/sigma, or what has taken its
   !> place where heights are not Gaussian.
   pure real(wp) function decay_at(properties, separation) result(decay)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      real(wp) :: h

      h = separation/properties%sigma
      if (.not. properties%heights%is_gaussian) h = decay_score(properties, separation)
      decay = exp(-0.5_wp*max(h, 0.0_wp)**2)
   end function decay_at

   !> The law without the factor exp(-max(h, 0)^2/2), which underflows far out.
   pure subroutine evaluate_scaled_law(properties, separation, scaled, area_stiffness, pieces)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Pressure, stiffness, area fraction, contact density and energy over the factor; the shares;
      !> and validity without the flags of area and pressure
      type(normal_response), intent(out) :: scaled
      !> Derivative of the area fraction by closure, 1/mm, over the factor
      real(wp), intent(out), optional :: area_stiffness
      !> The three pieces, with recoverable energy and dissipation of the elasto-plastic one
      type(piece_type), intent(out), optional :: pieces(3)
      type(piece_type) :: found(3)
      real(wp) :: moments(0:2)

      if (properties%heights%is_gaussian) then
         call find_pieces(properties, separation, present(area_stiffness), present(pieces), found)
         call find_tail_moments(separation/properties%sigma, moments)
      else
         call find_johnson_pieces(properties, separation, found, moments(0:1))
      end if
      call sum_pieces(properties, found, scaled, area_stiffness)
      if (present(pieces)) pieces = found
      associate (p => properties, r => scaled)
         r%contact_density = p%eta*moments(0)
         r%validity = p%validity
         if (is_closed_too_far(p, separation, moments)) &
            r%validity = ior(r%validity, closure_above_half_radius)
      end associate
   end subroutine evaluate_scaled_law

   !> The three pieces of Gaussian heights, by the fixed rule where it serves.
   pure subroutine find_pieces(properties, separation, with_area_slope, with_memory, pieces)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Whether the area's slope is wanted; recoverable energy and dissipation of elasto-plastic
      !> summits
      logical, intent(in) :: with_area_slope, with_memory
      !> The pieces
      type(piece_type), intent(out) :: pieces(3)
      real(wp) :: h

      h = separation/properties%sigma
      if (fixed_pieces_serve(properties, h)) then
         call evaluate_fixed_pieces(properties, h, with_area_slope, with_memory, pieces(1), &
            pieces(2))
      else
         pieces(1) = elastic_piece(properties, separation, properties%w1)
         pieces(2) = elastoplastic_piece(properties, separation, with_memory)
      end if
      pieces(3) = plastic_piece(properties, separation)
   end subroutine find_pieces

   !> Whether the summits in contact are closed by more than half their radius in the mean.
   pure logical function is_closed_too_far(properties, separation, moments)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm, and `find_tail_moments` of d/sigma
      real(wp), intent(in) :: separation, moments(0:2)

      is_closed_too_far = properties%sigma*moments(1) > 0.5_wp*properties%radius*moments(0) &
         .and. separation <= properties%judged_separation
   end function is_closed_too_far

   !> Root of the factor exp(-exponent) of a piece.
   pure real(wp) function root_of(exponent)
      real(wp), intent(in) :: exponent

      root_of = 1.0_wp
      if (exponent > 0.0_wp) root_of = exp(-0.5_wp*exponent)
   end function root_of

   !> Add up the elastic, the elasto-plastic and the plastic piece.
   pure subroutine sum_pieces(properties, pieces, scaled, area_stiffness)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> The three pieces
      type(piece_type), intent(in) :: pieces(3)
      !> Pressure, stiffness, area fraction, energy and shares, over the pieces' common factor
      type(normal_response), intent(out) :: scaled
      !> Derivative of the area fraction by closure, 1/mm, over the factor
      real(wp), intent(out), optional :: area_stiffness
      real(wp) :: total, root(3), share(3)
      integer :: i

      do i = 1, 3
         root(i) = root_of(pieces(i)%exponent)
      end do
      associate (p => properties, r => scaled)
         total = sum(root*root*pieces%pressure)
         r%pressure = p%eta*p%n1*total
         r%stiffness = p%eta*p%n1/p%w1*sum(root*root*pieces%stiffness)
         r%area_fraction = p%eta*pi*p%radius*p%w1*sum(root*root*pieces%area)
         if (present(area_stiffness)) &
            area_stiffness = p%eta*pi*p%radius*sum(root*root*pieces%area_slope)
         r%energy = p%eta*p%n1*p%w1*sum(root*root*pieces%energy)
         if (total > 0.0_wp) then
            ! root by root, so that a share underflows only when it is no normal number itself
            share = pieces%pressure/total*root*root
            r%elastic_share = share(1)
            r%elastoplastic_share = share(2)
            r%plastic_share = share(3)
         end if
      end associate
   end subroutine sum_pieces

end module asperity_law_normal_law
