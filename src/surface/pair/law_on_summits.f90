!> Does the statistical law hold on a real map? The law of one summit summed over the summits found
!> there, p(d) = (1/A) sum N(z - d), without any assumption on their heights: by one radius for all,
!> as the law has it, and by the radius of each; at first loading, or on the way back with memory.
module asperity_surface_pair_law_on_summits
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_single_asperity, only: asperity_response, stage_open
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_law_unloading_summit, only: evaluate_unloading_asperity
   implicit none
   private
   public :: summit_curve, sum_over_summits

   !> Pressures at each separation. The gap of one summit to another is not in any of them.
   type :: summit_curve
      !> Separation from the summit mean plane, mm
      real(wp), allocatable :: separation(:)
      !> Pressure of the Gaussian law, MPa
      real(wp), allocatable :: gaussian(:)
      !> Pressure of the summits, MPa, with the mean radius, with that of each
      real(wp), allocatable :: mean_radius(:), own_radius(:)
      !> Standard errors of these two as samples of independent summits, MPa
      real(wp), allocatable :: mean_radius_error(:), own_radius_error(:)
      !> Summits in contact per area, 1/mm^2, of the map and of the Gaussian law
      real(wp), allocatable :: contact_density(:), gaussian_density(:)
      !> Real area over nominal area, with the mean radius, and by the Gaussian law
      real(wp), allocatable :: area_fraction(:), gaussian_area(:)
      !> Summits without a radius, as their curvature is not above zero; they take the mean one
      integer :: without_radius = 0
   end type summit_curve

contains

   !> Sum the law of one summit over summits.
   pure subroutine sum_over_summits(properties, heights, curvatures, area, separations, curve, &
         error, closest_separation)
      !> The pair: radius is the mean one, eta and sigma are for the Gaussian law
      type(normal_properties), intent(in) :: properties
      !> Heights of the summits above the summit mean plane, mm
      real(wp), intent(in) :: heights(:)
      !> Their mean curvatures, 1/mm
      real(wp), intent(in) :: curvatures(:)
      !> Area they were found on, mm^2
      real(wp), intent(in) :: area
      !> Separations of the rigid plane from the summit mean plane, mm
      real(wp), intent(in) :: separations(:)
      !> Result
      type(summit_curve), intent(out) :: curve
      !> Set when there is nothing to sum
      type(error_type), allocatable, intent(out) :: error
      !> Separation that they part from with memory, mm; none when absent
      real(wp), intent(in), optional :: closest_separation
      real(wp), allocatable :: ratio(:)
      type(normal_response) :: law
      real(wp) :: closest
      integer :: i, n

      if (size(heights) == 0 .or. .not. area > 0.0_wp) then
         call fatal_error(error, 'there are no summits to sum over: the map shows none')
         return
      else if (size(heights) /= size(curvatures)) then
         call fatal_error(error, 'summits have as many heights as curvatures')
         return
      end if
      ! radius over mean radius
      allocate (ratio(size(heights)), source=1.0_wp)
      do i = 1, size(heights)
         if (curvatures(i)*properties%radius > tiny(1.0_wp)) then
            ratio(i) = 1.0_wp/(curvatures(i)*properties%radius)
         else
            curve%without_radius = curve%without_radius + 1
         end if
      end do
      n = size(separations)
      curve%separation = separations
      allocate (curve%gaussian(n), curve%gaussian_density(n), curve%gaussian_area(n), &
         curve%mean_radius(n), curve%own_radius(n), curve%mean_radius_error(n), &
         curve%own_radius_error(n), curve%contact_density(n), curve%area_fraction(n))
      do i = 1, n
         closest = separations(i)
         if (present(closest_separation)) closest = min(closest, closest_separation)
         if (closest < separations(i)) then
            law = evaluate_unloading_law(properties, closest, separations(i) - closest)
         else
            law = evaluate_normal_law(properties, separations(i))
         end if
         curve%gaussian(i) = law%pressure
         curve%gaussian_density(i) = law%contact_density
         curve%gaussian_area(i) = law%area_fraction
         call sum_at(curve, i, properties, heights, ratio, area, closest)
      end do
   end subroutine sum_over_summits

   !> Sums at the separation with a number, from the closest one so far.
   pure subroutine sum_at(curve, number, properties, z, ratio, area, closest)
      type(summit_curve), intent(inout) :: curve
      integer, intent(in) :: number
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: z(:), ratio(:), area, closest
      type(asperity_response) :: summit
      real(wp) :: retraction, sums(2), squares(2), areas, force
      integer :: i, touching

      retraction = curve%separation(number) - closest
      touching = 0
      sums = 0.0_wp
      squares = 0.0_wp
      areas = 0.0_wp
      do i = 1, size(z)
         if (.not. z(i) > closest) cycle
         summit = evaluate_unloading_asperity(properties, z(i) - closest, retraction)
         if (summit%stage /= stage_open) touching = touching + 1
         areas = areas + summit%area
         sums(1) = sums(1) + summit%force
         squares(1) = squares(1) + summit%force**2
         ! w1 and w2 are as the radius, forces at equal w/w1 as its square, at every stage
         summit = evaluate_unloading_asperity(properties, (z(i) - closest)/ratio(i), &
            retraction/ratio(i))
         force = summit%force*ratio(i)**2
         sums(2) = sums(2) + force
         squares(2) = squares(2) + force**2
      end do
      curve%contact_density(number) = real(touching, wp)/area
      curve%mean_radius(number) = sums(1)/area
      curve%own_radius(number) = sums(2)/area
      curve%mean_radius_error(number) = sqrt(squares(1))/area
      curve%own_radius_error(number) = sqrt(squares(2))/area
      curve%area_fraction(number) = areas/area
   end subroutine sum_at

end module asperity_surface_pair_law_on_summits
