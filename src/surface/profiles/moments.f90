!> From sums over profiles to the parameters of the surface that they were taken of.
!>
!> On an isotropic surface m2 and m4 of profiles in any direction are those of Nayak's formulas;
!> that it is isotropic, profiles in one direction cannot show. Of two directions at right angles to
!> each other, taken for those across the lay and along it, the equivalent isotropic surface has the
!> geometric means of both m2 and of both m4 (Sayles & Thomas 1976, McCool 1987), as a map has. m0
!> is that of the steeper profiles, which span more waves: along a lay a profile misses what lies
!> beside it.
module asperity_surface_profiles_moments
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_base_student, only: student_factor
   use asperity_surface_parameters_from_sums, only: values_of_moments, variance_of
   use asperity_surface_parameters_parameters, only: n_parameters, p_direction, p_m0, p_m2, &
      p_m2_across, p_m2_along, p_m2_x, p_m2_y, p_m4, p_m4_across, p_m4_along, p_m4_x, p_m4_y, &
      p_sdq, p_sku, p_sq, p_ssk
   use asperity_surface_parameters_uncertainty, only: confidence, jackknife
   use asperity_surface_profiles_sums, only: added, profile_sums
   implicit none
   private
   public :: profile_moments, profile_uncertainties, profile_values

contains

   !> m0, m2 and m4 of profiles; `none` where there is none.
   pure subroutine profile_moments(sums, m0, m2, m4)
      !> Sums over them
      type(profile_sums), intent(in) :: sums
      !> Mean squares of height, slope and curvature, mm^2, 1, 1/mm^2
      real(wp), intent(out) :: m0, m2, m4

      m0 = none
      m2 = none
      m4 = none
      if (sums%points > 0.0_wp) &
         m0 = variance_of(sums%second/sums%points, sums%first/sums%points)
      if (sums%pairs > 0.0_wp) m2 = sums%slope/sums%pairs
      if (sums%triples > 0.0_wp) m4 = sums%curvature/sums%triples
   end subroutine profile_moments

   !> All parameters that profiles give, in the order of the table; `none` for the others.
   pure subroutine profile_values(sums, steeper, values)
      !> Sums over the profiles of one direction, or of x and of y
      type(profile_sums), intent(in) :: sums(:)
      !> Which of the two directions is taken for that across the lay; 1 for one
      integer, intent(in) :: steeper
      !> The values
      real(wp), intent(out) :: values(n_parameters)
      real(wp) :: m0, mean, raw(2:4)
      real(wp), dimension(size(sums)) :: m2, m4
      integer :: i

      values = none
      do i = 1, size(sums)
         call profile_moments(sums(i), m0, m2(i), m4(i))
         if (i == steeper) values(p_m0) = m0
      end do
      if (is_none(values(p_m0)) .or. any(is_none(m2)) .or. any(is_none(m4))) return
      values(p_sq) = sqrt(values(p_m0))
      associate (part => sums(steeper))
         mean = part%first/part%points
         raw = [part%second, part%third, part%fourth]/part%points
      end associate
      if (values(p_m0) > 0.0_wp) then
         values(p_ssk) = (raw(3) - 3.0_wp*mean*raw(2) + 2.0_wp*mean**3)/values(p_sq)**3
         values(p_sku) = (raw(4) - 4.0_wp*mean*raw(3) + 6.0_wp*mean**2*raw(2) &
            - 3.0_wp*mean**4)/values(p_m0)**2
      end if
      values(p_m2) = m2(1)
      values(p_m4) = m4(1)
      if (size(sums) == 2) then
         values([integer :: p_m2_x, p_m2_y]) = m2
         values([integer :: p_m4_x, p_m4_y]) = m4
         values(p_sdq) = sqrt(sum(m2))
         values(p_direction) = 90.0_wp*real(steeper - 1, wp)
         values([integer :: p_m2_across, p_m2_along]) = m2([steeper, 3 - steeper])
         values([integer :: p_m4_across, p_m4_along]) = m4([steeper, 3 - steeper])
         values(p_m2) = sqrt(product(m2))
         values(p_m4) = sqrt(product(m4))
      end if
      call values_of_moments(values)
   end subroutine profile_values

   !> Half widths of the 95 % intervals of all parameters from the scatter of groups: the profiles
   !> of a direction, or the parts of a single one. Each is left out in turn (jackknife); variances
   !> of two directions add, with the degrees of freedom of Welch and Satterthwaite.
   pure subroutine profile_uncertainties(groups, direction, steeper, uncertainty)
      !> Sums over each group
      type(profile_sums), intent(in) :: groups(:)
      !> Direction of each, 1 or 2
      integer, intent(in) :: direction(:)
      !> As above
      integer, intent(in) :: steeper
      !> Half widths; `none` where there is none, for fewer than two groups of a direction
      real(wp), intent(out) :: uncertainty(n_parameters)
      type(profile_sums) :: whole(maxval(direction)), without(maxval(direction))
      real(wp) :: values(n_parameters), variance(n_parameters, maxval(direction)), total, free
      real(wp), allocatable :: left(:, :), weights(:)
      integer, allocatable :: own(:)
      type(profile_sums), allocatable :: others(:)
      integer :: degrees(maxval(direction)), i, k, p

      uncertainty = none
      do k = 1, size(whole)
         do i = 1, size(groups)
            if (direction(i) == k) whole(k) = added(whole(k), groups(i))
         end do
      end do
      call profile_values(whole, steeper, values)
      do k = 1, size(whole)
         own = pack([(i, i=1, size(groups))], direction == k .and. groups%points > 0.0_wp)
         if (size(own) < 2) return
         degrees(k) = size(own) - 1
         if (allocated(left)) deallocate (left)
         allocate (left(n_parameters, size(own)))
         call sum_without(groups(own), others)
         do i = 1, size(own)
            without = whole
            without(k) = others(i)
            call profile_values(without, steeper, left(:, i))
         end do
         weights = groups(own)%points/sum(groups(own)%points)
         call jackknife(values, left, weights, variance(:, k))
      end do
      do p = 1, n_parameters
         if (p == p_direction .or. any(is_none(variance(p, :)))) cycle
         total = sum(variance(p, :))
         free = real(minval(degrees), wp)
         if (total > 0.0_wp) free = total**2/sum(variance(p, :)**2/real(degrees, wp))
         uncertainty(p) = student_factor(confidence, int(min(free, 1.0e6_wp) + 1.0e-9_wp)) &
            *sqrt(total)
      end do
   end subroutine profile_uncertainties

   !> Sums over all groups but one each.
   pure subroutine sum_without(groups, others)
      type(profile_sums), intent(in) :: groups(:)
      !> Those without the first, without the second ...
      type(profile_sums), allocatable, intent(out) :: others(:)
      type(profile_sums) :: before, behind
      integer :: i

      allocate (others(size(groups)))
      do i = 1, size(groups)
         others(i) = before
         before = added(before, groups(i))
      end do
      do i = size(groups), 1, -1
         others(i) = added(others(i), behind)
         behind = added(behind, groups(i))
      end do
   end subroutine sum_without

end module asperity_surface_profiles_moments
