!> What a user should know about the parameters of a map before using them, in words.
module asperity_surface_remarks_on_analysis
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_plausibility, only: alpha_min, roughness_number_min, &
      roughness_number_min_sq, summit_constant
   use asperity_surface_parameters_parameters, only: n_parameters, p_alpha, p_eta_nayak, &
      p_eta_paper, p_m2_across, p_m2_along, p_radius_nayak, p_radius_paper, p_sigma_nayak, &
      p_sigma_paper, p_spc, p_spd, parameters
   use asperity_surface_remarks_on_scan, only: map_facts, remark_scan
   use asperity_surface_remarks_remark, only: add_remark, is_known, quantity, remark_type
   implicit none
   private
   public :: find_remarks, map_facts, remark_alpha, remark_anisotropy, remark_step, remark_type

   !> Difference of the routes that matters, over the larger of the two values
   real(wp), parameter :: routes_share = 0.2_wp
   !> m2 across over m2 along from which a surface is called anisotropic, and m2 along over m2
   !> across up to which it is rounding
   real(wp), parameter :: anisotropic = 2.0_wp, nothing = 1.0e-20_wp
   !> Peaks from which their mean is worth something
   real(wp), parameter :: enough_peaks = 20.0_wp

contains

   !> All remarks on a map, none when nothing is unusual.
   pure subroutine find_remarks(values, uncertainty, facts, route, remarks, coarse)
      !> Values and the half widths of their 95 % intervals, in the order of the table
      real(wp), intent(in) :: values(n_parameters), uncertainty(n_parameters)
      !> What else is known
      type(map_facts), intent(in) :: facts
      !> Route whose parameters are taken: `nayak` or `paper`
      character(len=*), intent(in) :: route
      !> The remarks
      type(remark_type), allocatable, intent(out) :: remarks(:)
      !> Values at twice the step
      real(wp), intent(in), optional :: coarse(n_parameters)

      allocate (remarks(0))
      call remark_scan(values, facts, remarks)
      call remark_peaks(facts%peaks, remarks)
      call remark_routes(values, uncertainty, remarks)
      call remark_alpha(values, uncertainty, 'Use the paper''s route, or the sum over the '// &
         'map''s own summits (--verify).', remarks)
      call remark_anisotropy(values, remarks)
      if (route == 'paper') &
         call remark_number(values([p_eta_paper, p_radius_paper, p_sigma_paper]), remarks)
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
         'the same moments. Do not mix them; the verdict says which one to take.')
   end subroutine remark_routes

   !> A bandwidth parameter that no isotropic Gaussian surface has.
   pure subroutine remark_alpha(values, uncertainty, remedy, remarks)
      !> Values and half widths of their intervals in the order of the table
      real(wp), intent(in) :: values(:), uncertainty(:)
      !> What to do, in a sentence
      character(len=*), intent(in) :: remedy
      !> Where to add it
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: text

      associate (alpha => values(p_alpha), u => uncertainty(p_alpha))
         if (.not. alpha < alpha_min) return
         text = 'alpha = '//trim(quantity(p_alpha, alpha, u))//' is below '// &
            to_text(alpha_min)//', which no isotropic Gaussian surface has'
         if (is_known(u) .and. alpha + u >= alpha_min) text = text//', though within its '// &
            'uncertainty'
         text = text//': the law refuses his values unless accept_unphysical is set. Waves of '// &
            'one length or one direction stand out, or heights are far from Gaussian: Nayak''s '// &
            'density, radius and sigma do not describe its summits.'
         if (.not. is_known(values(p_sigma_nayak))) text = text// &
            ' His sigma does not even exist below '//to_text(summit_constant, 4)//'.'
         call add_remark(remarks, 'alpha', text//' '//remedy)
      end associate
   end subroutine remark_alpha

   !> A lay, of which the isotropic equivalent tells little.
   pure subroutine remark_anisotropy(values, remarks)
      !> In the order of the table
      real(wp), intent(in) :: values(:)
      !> Where to add it
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

   !> The least of isotropic Gaussian surfaces, with sq of the paper, and the law's own limit.
   pure subroutine remark_number(law, remarks)
      !> eta, R and sigma
      real(wp), intent(in) :: law(3)
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: text

      if (.not. all(is_known(law))) return
      if (product(law) >= roughness_number_min_sq) return
      text = 'eta R sigma of the paper''s route is '//to_text(product(law), 3)//', below '// &
         to_text(roughness_number_min_sq, 3)//', the least of isotropic Gaussian surfaces with '// &
         'sigma = sq: peaks left after pruning are fewer and sharper than all summits.'
      if (product(law) < roughness_number_min) text = text//' Below '// &
         to_text(roughness_number_min, 3)//' the law refuses it unless accept_unphysical is set.'
      call add_remark(remarks, 'roughness_number', text)
   end subroutine remark_number

   !> Values that hang on the step.
   pure subroutine remark_step(values, uncertainty, coarse, remarks)
      !> Values, half widths of their intervals, and values at twice the step
      real(wp), intent(in) :: values(:), uncertainty(:), coarse(:)
      !> Where to add it
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

end module asperity_surface_remarks_on_analysis
