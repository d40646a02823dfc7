!> What heights that are not Gaussian do to the pressure. By how much their skewness and kurtosis
!> differ says little: a kurtosis of 3.6 is near 3, and may multiply a light pressure by five. But
!> that is with one radius for all summits; where high summits are sharper, as on many maps, it
!> cancels.
module asperity_surface_remarks_on_heights
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: heights_gaussian, heights_johnson, &
      new_normal_properties, normal_properties
   use asperity_surface_pair_law_on_summits, only: sum_over_summits, summit_curve
   use asperity_surface_parameters_parameters, only: n_parameters, p_sku, p_ssk
   use asperity_surface_remarks_remark, only: add_remark, is_known, quantity, remark_type
   implicit none
   private
   public :: add_height_effect, remark_heights

   !> Pressures of the Gaussian law at which heights are compared, MPa: joints of wood at work
   real(wp), parameter :: pressures(2) = [0.05_wp, 0.2_wp]
   !> Factor on the pressure from which it is told: the law at its best is as near an elastic
   !> solution
   real(wp), parameter :: least_factor = 1.2_wp

contains

   !> A remark on the heights of a map, unless their effect is small, or may be within their
   !> uncertainty; beside it the sum over the map's own summits.
   pure subroutine remark_heights(law, values, uncertainty, heights, curvatures, area, remarks)
      !> The law by the route, with Gaussian heights
      type(normal_properties), intent(in) :: law
      !> Values and the half widths of their 95 % intervals, in the order of the table
      real(wp), intent(in) :: values(n_parameters), uncertainty(n_parameters)
      !> Heights of the summits above their mean plane, mm, and mean curvatures, 1/mm; none where
      !> the map's are not known
      real(wp), intent(in) :: heights(:), curvatures(:)
      !> Area they were found on, mm^2
      real(wp), intent(in) :: area
      !> Added to
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: text
      real(wp) :: separations(size(pressures))
      logical :: is_told

      associate (ssk => values(p_ssk), sku => values(p_sku), u_ssk => uncertainty(p_ssk), &
            u_sku => uncertainty(p_sku))
         if (.not. (is_known(ssk) .and. is_known(sku))) return
         text = ''
         call add_height_effect(text, law, nearer(ssk, u_ssk), 3.0_wp + nearer(sku - 3.0_wp, &
            u_sku), separations, is_told)
         if (.not. is_told) return
         text = 'ssk = '//trim(quantity(p_ssk, ssk, u_ssk))//', sku = '// &
            trim(quantity(p_sku, sku, u_sku))//': '
         call add_height_effect(text, law, ssk, sku, separations, is_told)
      end associate
      if (.not. is_told) return
      if (size(heights) > 0) call add_own_sums(text, law, heights, curvatures, area, separations)
      call add_remark(remarks, 'heights', text)
   end subroutine remark_heights

   !> The value nearest to zero within its uncertainty, if that is known.
   pure real(wp) function nearer(value, half_width)
      real(wp), intent(in) :: value, half_width

      nearer = value
      if (is_known(half_width)) nearer = sign(max(abs(value) - half_width, 0.0_wp), value)
   end function nearer

   !> Add what heights of a skewness and a kurtosis do to the pressure by Johnson's distribution.
   pure subroutine add_height_effect(text, law, skewness, kurtosis, separations, is_told)
      !> Added to
      character(len=:), allocatable, intent(inout) :: text
      !> The law with Gaussian heights
      type(normal_properties), intent(in) :: law
      !> Of the heights
      real(wp), intent(in) :: skewness, kurtosis
      !> Where the law has the pressures compared, mm
      real(wp), intent(out) :: separations(:)
      !> Whether there is anything to tell: not where the effect is small, or cannot be computed
      logical, intent(out) :: is_told
      type(normal_properties) :: gaussian, johnson
      type(normal_response) :: response(size(pressures))
      type(error_type), allocatable :: error
      real(wp) :: factors(size(pressures))
      integer :: i

      is_told = .false.
      separations = 0.0_wp
      call with_heights(gaussian, law, heights_gaussian, 0.0_wp, 3.0_wp, error)
      do i = 1, size(pressures)
         if (.not. allocated(error)) &
            call separation_for_pressure(gaussian, pressures(i), separations(i), error)
      end do
      if (allocated(error)) return
      call with_heights(johnson, law, heights_johnson, skewness, kurtosis, error)
      if (allocated(error)) then
         ! two peaks, or a cliff: far from Gaussian in any case
         is_told = .true.
         text = text//'heights with two peaks or nearly so are far from Gaussian ones, and the '// &
            'law with either distribution does not describe them.'
         return
      end if
      response = evaluate_normal_law(johnson, separations)
      factors = response%pressure/pressures
      is_told = any(factors > least_factor .or. factors < 1.0_wp/least_factor)
      if (.not. is_told) return
      text = text//'where the Gaussian law gives '//to_text(pressures(1))//' and '// &
         to_text(pressures(2))//' MPa, such heights (Johnson''s distribution) with one radius '// &
         'for all summits give '//to_text(factors(1), 3)//' and '//to_text(factors(2), 3)// &
         ' times as much. Where high summits are sharper than others the two cancel.'
   end subroutine add_height_effect

   !> The law with other heights, reversible.
   pure subroutine with_heights(other, law, distribution, skewness, kurtosis, error)
      type(normal_properties), intent(out) :: other
      type(normal_properties), intent(in) :: law
      integer, intent(in) :: distribution
      real(wp), intent(in) :: skewness, kurtosis
      type(error_type), allocatable, intent(out) :: error

      call new_normal_properties(other, law%eta, law%modulus, law%radius, law%hardness, &
         law%yield_factor, law%sigma, error, accept_unphysical=.true., &
         plastic_ratio=law%plastic_ratio, height_distribution=distribution, skewness=skewness, &
         kurtosis=kurtosis)
   end subroutine with_heights

   !> Add what the map's own summits, each with its own radius, have of the Gaussian law there.
   pure subroutine add_own_sums(text, law, heights, curvatures, area, separations)
      character(len=:), allocatable, intent(inout) :: text
      type(normal_properties), intent(in) :: law
      real(wp), intent(in) :: heights(:), curvatures(:), area, separations(:)
      type(summit_curve) :: sums
      type(error_type), allocatable :: error
      integer :: i

      call sum_over_summits(law, heights, curvatures, area, separations, sums, error)
      if (allocated(error)) return
      text = text//' This map''s own summits, each with its own radius, give'
      do i = 1, size(separations)
         if (i > 1) text = text//' and'
         text = text//' '//to_text(sums%own_radius(i)/sums%gaussian(i), 3)//' times (standard '// &
            'error '//to_text(sums%own_radius_error(i)/sums%gaussian(i), 2)//')'
      end do
      text = text//': near 1, keep Gaussian heights; near the factors before, take '// &
         'height_distribution = johnson.'
   end subroutine add_own_sums

end module asperity_surface_remarks_on_heights
