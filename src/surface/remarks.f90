!> What a user should know about the parameters of a map before using them, in words.
module surface_remarks
   use asperity_kinds, only: wp
   use asperity_properties, only: pi, roughness_number_min
   use asperity_text, only: to_text
   use surface_nayak, only: alpha_min
   use surface_parameters, only: n_parameters, p_alpha, p_eta_nayak, p_eta_paper, p_m0, &
      p_m2_across, p_m2_along, p_m2_x, p_m2_y, p_m4_x, p_m4_y, p_radius_nayak, p_radius_paper, &
      p_sigma_nayak, p_sigma_paper, p_sku, p_spc, p_spd, p_ssk, parameters, &
      p_sdq, p_sp, p_sq, p_sv
   use surface_remark_list, only: add_remark, is_known, quantity, remark_type
   implicit none
   private
   public :: find_remarks, remark_type

   !> Difference of the routes that matters, over the larger of the two values
   real(wp), parameter :: routes_share = 0.2_wp
   !> Skewness, and kurtosis less 3, from which heights are far from Gaussian
   real(wp), parameter :: far_ssk = 0.5_wp, far_sku = 1.0_wp
   !> m2 across over m2 along from which a surface is called anisotropic, and m2 along over m2
   !> across up to which it is rounding
   real(wp), parameter :: anisotropic = 2.0_wp, nothing = 1.0e-20_wp
   !> Least and largest sdq of a scanned surface
   real(wp), parameter :: least_slope = 1.0e-4_wp, largest_slope = 10.0_wp
   !> Height over sq from which a point is an outlier; the highest of 1e9 Gaussian ones is at 6
   real(wp), parameter :: far_out = 12.0_wp
   !> Share of filled points that is worth a word
   real(wp), parameter :: much_filled = 0.01_wp
   !> Peaks from which their mean is worth something
   real(wp), parameter :: enough_peaks = 20.0_wp
   !> Waves that a tile must hold, and steps that the shortest waves must span
   real(wp), parameter :: enough_waves = 1.0_wp, enough_steps = 6.0_wp

   !> What is known of the map besides its values.
   type, public :: map_facts
      !> Steps, mm
      real(wp) :: step_x = 0.0_wp, step_y = 0.0_wp
      !> Sides of a tile, mm; zero without tiles
      real(wp) :: tile_x = 0.0_wp, tile_y = 0.0_wp
      !> Number of peaks
      real(wp) :: peaks = 0.0_wp
      !> Share of points that were filled in
      real(wp) :: filled = 0.0_wp
      !> Places of the highest and of the lowest point, mm
      real(wp) :: top(2) = 0.0_wp, bottom(2) = 0.0_wp
   end type map_facts

contains

   !> All remarks on a map, none when nothing is unusual.
   pure subroutine find_remarks(values, uncertainty, facts, remarks, coarse)
      !> Values and the half widths of their 95 % intervals, in the order of the table
      real(wp), intent(in) :: values(n_parameters), uncertainty(n_parameters)
      !> What else is known
      type(map_facts), intent(in) :: facts
      !> The remarks
      type(remark_type), allocatable, intent(out) :: remarks(:)
      !> Values at twice the step
      real(wp), intent(in), optional :: coarse(n_parameters)

      allocate (remarks(0))
      call remark_slope(values(p_sdq), remarks)
      call remark_outlier('highest', values(p_sp), values(p_sq), facts%top, remarks)
      call remark_outlier('lowest', values(p_sv), values(p_sq), facts%bottom, remarks)
      call remark_filled(facts%filled, remarks)
      call remark_peaks(facts%peaks, remarks)
      call remark_routes(values, uncertainty, remarks)
      call remark_alpha(values, uncertainty, remarks)
      call remark_heights(values, uncertainty, remarks)
      call remark_anisotropy(values, remarks)
      call remark_number(values([p_eta_paper, p_radius_paper, p_sigma_paper]), 'paper', remarks)
      call remark_number(values([p_eta_nayak, p_radius_nayak, p_sigma_nayak]), 'Nayak', remarks)
      call remark_waves(values, facts, remarks)
      call remark_resolution(values, facts, remarks)
      if (present(coarse)) call remark_step(values, uncertainty, coarse, remarks)
   end subroutine find_remarks

   pure subroutine remark_peaks(peaks, remarks)
      real(wp), intent(in) :: peaks
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (peaks < 0.5_wp) then
         call add_remark(remarks, 'no_peaks', 'No peak is left after pruning: spd is 0, and '// &
            'spc and the paper''s R do not exist. Take a larger map or a lower height of pruning.')
      else if (peaks < enough_peaks) then
         call add_remark(remarks, 'few_peaks', 'spd and spc rest on few peaks: '// &
            to_text(nint(peaks))//', fewer than '//to_text(nint(enough_peaks))// &
            '. Take a larger map.')
      end if
   end subroutine remark_peaks

   pure subroutine remark_routes(values, uncertainty, remarks)
      real(wp), intent(in) :: values(:), uncertainty(:)
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      integer, parameter :: pairs(2, 3) = reshape([p_eta_paper, p_eta_nayak, p_radius_paper, &
         p_radius_nayak, p_sigma_paper, p_sigma_nayak], [2, 3])
      character(len=5), parameter :: names(3) = ['eta  ', 'R    ', 'sigma']
      character(len=:), allocatable :: list
      real(wp) :: doubt
      integer :: i

      list = ''
      do i = 1, 3
         associate (p => pairs(1, i), n => pairs(2, i))
            if (.not. all(is_known(values([p, n])))) cycle
            doubt = 0.0_wp
            if (all(is_known(uncertainty([p, n])))) doubt = hypot(uncertainty(p), uncertainty(n))
            if (abs(values(p) - values(n)) <= max(doubt, routes_share*max(values(p), values(n)))) &
               cycle
            if (len(list) > 0) list = list//'; '
            list = list//trim(names(i))//' is '//trim(quantity(p, values(p), uncertainty(p)))// &
               ' against '//trim(quantity(n, values(n), uncertainty(n)))
         end associate
      end do
      if (len(list) == 0) return
      call add_remark(remarks, 'routes', 'The routes of the paper and of Nayak and McCool '// &
         'disagree: '// &
         list//'. The paper''s R and eta are those of the peaks left after pruning, its sigma '// &
         'is that of all heights; Nayak''s are those of all summits of a Gaussian surface with '// &
         'the same moments. Compare both with the sum over the map''s own summits (--verify), '// &
         'and do not mix them.')
   end subroutine remark_routes

   !> Slopes of no scanned surface are a slip of units.
   pure subroutine remark_slope(sdq, remarks)
      real(wp), intent(in) :: sdq
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (.not. is_known(sdq)) return
      if (sdq >= least_slope .and. sdq <= largest_slope) return
      call add_remark(remarks, 'slope', 'sdq = '//to_text(sdq, 4)//' is no slope of a scanned '// &
         'surface, which is from '//to_text(least_slope)//' to '//to_text(largest_slope)// &
         ': check units and step (--lateral-unit, --height-unit, --step). The routes do not '// &
         'show such a slip: eta R sigma is the same in all units.')
   end subroutine remark_slope

   !> One point far out of the others.
   pure subroutine remark_outlier(what, size, sq, place, remarks)
      character(len=*), intent(in) :: what
      real(wp), intent(in) :: size, sq, place(2)
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (.not. (is_known(size) .and. is_known(sq))) return
      if (size <= far_out*sq) return
      call add_remark(remarks, 'outlier', 'The '//what//' point is '//to_text(size, 4)// &
         ' mm off the mean plane, '//to_text(size/sq, 3)//' times sq, at x '// &
         to_text(place(1), 5)//' mm, y '//to_text(place(2), 5)//' mm: a spike, or a number '// &
         'that marks a missing point? It raises sq and sz, and with sz the height of '// &
         'pruning: take it out of the file.')
   end subroutine remark_outlier

   !> Points that nobody measured.
   pure subroutine remark_filled(share, remarks)
      real(wp), intent(in) :: share
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (share <= much_filled) return
      call add_remark(remarks, 'filled', to_text(100.0_wp*share, 2)//' % of the points were '// &
         'filled in: slopes and curvatures there are not those of the surface. --missing mask '// &
         'leaves them out.')
   end subroutine remark_filled

   pure subroutine remark_alpha(values, uncertainty, remarks)
      real(wp), intent(in) :: values(:), uncertainty(:)
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: text

      associate (alpha => values(p_alpha), u => uncertainty(p_alpha))
         if (.not. alpha < alpha_min) return
         text = 'alpha = '//trim(quantity(p_alpha, alpha, u))//' is below '// &
            to_text(alpha_min)//', which no isotropic Gaussian surface has'
         if (is_known(u) .and. alpha + u >= alpha_min) text = text//', though within its '// &
            'uncertainty'
         text = text//'. Waves of one length or one direction stand out, or heights are far '// &
            'from Gaussian: Nayak''s density, radius and sigma do not describe its summits.'
         if (.not. is_known(values(p_sigma_nayak))) text = text// &
            ' His sigma does not even exist below 0.8968.'
         call add_remark(remarks, 'alpha', text//' Use the paper''s route, or the sum over the '// &
            'map''s own summits (--verify).')
      end associate
   end subroutine remark_alpha

   pure subroutine remark_heights(values, uncertainty, remarks)
      real(wp), intent(in) :: values(:), uncertainty(:)
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=72) :: meaning

      associate (ssk => values(p_ssk), sku => values(p_sku))
         if (is_far(ssk, uncertainty(p_ssk), far_ssk)) then
            meaning = 'a few hills stand out, and fewer summits touch at once'
            if (ssk < 0.0_wp) &
               meaning = 'pits are deeper than hills are high, and more summits touch at once'
            call add_remark(remarks, 'ssk', 'ssk = '// &
               trim(quantity(p_ssk, ssk, uncertainty(p_ssk)))//' is far from 0, the Gaussian '// &
               'value (threshold '//to_text(far_ssk)//'): '//trim(meaning)// &
               ' than the Gaussian law says. Check with --verify.')
         end if
         if (is_far(sku - 3.0_wp, uncertainty(p_sku), far_sku)) then
            meaning = 'extremes are rarer'
            if (sku > 3.0_wp) meaning = 'extremes, if they are no outliers, are commoner'
            call add_remark(remarks, 'sku', 'sku = '// &
               trim(quantity(p_sku, sku, uncertainty(p_sku)))//' is far from 3, the Gaussian '// &
               'value (threshold '//to_text(far_sku)//' off it): '//trim(meaning)// &
               ' than the Gaussian law says. Check with --verify.')
         end if
      end associate
   end subroutine remark_heights

   !> Beyond its uncertainty, if that is known, and a threshold.
   pure logical function is_far(value, half_width, threshold)
      real(wp), intent(in) :: value, half_width, threshold

      is_far = .false.
      if (is_known(value)) is_far = abs(value) > threshold
      if (is_known(half_width)) is_far = is_far .and. abs(value) > half_width
   end function is_far

   pure subroutine remark_anisotropy(values, remarks)
      real(wp), intent(in) :: values(:)
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      associate (across => values(p_m2_across), along => values(p_m2_along))
         if (.not. is_known(across) .or. .not. is_known(along)) return
         if (across <= anisotropic*along) return
         if (along > nothing*across) then
            call add_remark(remarks, 'anisotropic', 'The surface has a lay: m2 is '// &
               to_text(across, 4)//' across it, '//to_text(across/along, 3)// &
               ' times as much as along it. The isotropic equivalent, of the geometric means '// &
               'of m2 and of m4, is an approximation: summits are ridges, whose one radius '// &
               'stands for two.')
         else
            call add_remark(remarks, 'anisotropic', 'The surface does not vary along its lay: '// &
               'it has no isotropic equivalent.')
         end if
      end associate
   end subroutine remark_anisotropy

   !> The law's own limit, which is meant for the standard deviation of the surface.
   pure subroutine remark_number(law, route, remarks)
      !> eta, R and sigma
      real(wp), intent(in) :: law(3)
      character(len=*), intent(in) :: route
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: text

      if (.not. all(is_known(law))) return
      if (product(law) >= roughness_number_min) return
      text = 'eta R sigma of the '//route//' route is '//to_text(product(law), 3)//', below '// &
         to_text(roughness_number_min)//': the law refuses it unless accept_unphysical is set.'
      if (route == 'Nayak') then
         text = text//' With the sigma of summits, which this route takes, isotropic Gaussian '// &
            'surfaces of alpha below 2.4 are under that limit and still exist.'
      else
         text = text//' No isotropic Gaussian surface has it by all its summits; peaks left '// &
            'after pruning are fewer and sharper, so that one may be there by them.'
      end if
      call add_remark(remarks, 'roughness_number', text)
   end subroutine remark_number

   pure subroutine remark_waves(values, facts, remarks)
      real(wp), intent(in) :: values(:)
      type(map_facts), intent(in) :: facts
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      real(wp) :: waves

      if (.not. all(is_known(values([p_m0, p_m2_x, p_m2_y])))) return
      if (.not. min(facts%tile_x, facts%tile_y, values(p_m0)) > 0.0_wp) return
      waves = min(facts%tile_x*sqrt(values(p_m2_x)/values(p_m0)), &
         facts%tile_y*sqrt(values(p_m2_y)/values(p_m0)))/(2.0_wp*pi)
      if (waves >= enough_waves) return
      call add_remark(remarks, 'few_waves', 'A tile is only '//to_text(waves, 2)//' typical '// &
         'waves, 2 pi sqrt(m0/m2), long: tiles are not independent of each other, and the '// &
         'uncertainties too small. Take a larger map, fewer tiles, or remove the form or '// &
         'longer waves.')
   end subroutine remark_waves

   pure subroutine remark_resolution(values, facts, remarks)
      real(wp), intent(in) :: values(:)
      type(map_facts), intent(in) :: facts
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      real(wp) :: steps

      if (.not. all(is_known(values([p_m2_x, p_m2_y, p_m4_x, p_m4_y])))) return
      if (.not. min(facts%step_x, facts%step_y, values(p_m4_x), values(p_m4_y)) > 0.0_wp) return
      steps = 2.0_wp*pi*min(sqrt(values(p_m2_x)/values(p_m4_x))/facts%step_x, &
         sqrt(values(p_m2_y)/values(p_m4_y))/facts%step_y)
      if (steps >= enough_steps) return
      call add_remark(remarks, 'resolution', 'The shortest waves, 2 pi sqrt(m2/m4), span '// &
         to_text(steps, 2)//' steps, fewer than '//to_text(nint(enough_steps))//': curvatures '// &
         'and summits depend on the step, noise counts as roughness. Scan with a shorter step '// &
         'or filter short waves out.')
   end subroutine remark_resolution

   pure subroutine remark_step(values, uncertainty, coarse, remarks)
      real(wp), intent(in) :: values(:), uncertainty(:), coarse(:)
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      integer, parameter :: shown(7) = [p_spd, p_spc, p_alpha, p_eta_nayak, p_radius_nayak, &
         p_sigma_paper, p_sigma_nayak]
      character(len=:), allocatable :: list
      integer :: i, p

      list = ''
      do i = 1, size(shown)
         p = shown(i)
         if (.not. (is_known(values(p)) .and. is_known(uncertainty(p)) .and. is_known(coarse(p)))) &
            cycle
         if (abs(coarse(p) - values(p)) <= uncertainty(p)) cycle
         if (len(list) > 0) list = list//', '
         list = list//trim(parameters(p)%name)//' from '// &
            trim(quantity(p, values(p), uncertainty(p)))//' to '//to_text(coarse(p), 4)
      end do
      if (len(list) == 0) return
      call add_remark(remarks, 'step', 'Twice the step changes values by more than their '// &
         'uncertainty: '// &
         list//'. They are those of this step and filter; state both with them.')
   end subroutine remark_step

end module surface_remarks
