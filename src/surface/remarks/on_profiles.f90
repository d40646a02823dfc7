!> What a user should know about parameters from profiles before using them, in words.
module asperity_surface_remarks_on_profiles
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_surface_parameters_parameters, only: n_parameters, p_m0, p_m2, p_m2_x, &
      p_m2_y, p_m4, p_m4_x, p_m4_y, p_radius_nayak, p_sdq
   use asperity_surface_remarks_on_analysis, only: remark_alpha, remark_anisotropy, remark_step
   use asperity_surface_remarks_on_scan, only: enough_steps, enough_waves, remark_slope
   use asperity_surface_remarks_remark, only: add_remark, is_known, remark_type
   implicit none
   private
   public :: find_profile_remarks, profile_facts

   !> Radius of a stylus over that of summits from which it matters
   real(wp), parameter :: blunt = 0.1_wp

   !> What is known of profiles besides their values; of each direction.
   type :: profile_facts
      !> How many there are
      integer :: number(2) = 0
      !> Groups of them, or parts into which a single one is split
      integer :: groups(2) = 1
      !> Distance of points, and length of the first profile, mm
      real(wp) :: step(2) = 0.0_wp, length(2) = 0.0_wp
      !> Distance of neighbours that are lines of a map, mm; 0 for others
      real(wp) :: spacing(2) = 0.0_wp
      !> Radius of the stylus, mm; 0 when it is not known
      real(wp) :: stylus = 0.0_wp
   end type profile_facts

contains

   !> All remarks.
   pure subroutine find_profile_remarks(values, uncertainty, coarse, facts, remarks)
      !> Values, half widths of their 95 % intervals, and values at twice the step, in the order of
      !> the table
      real(wp), intent(in), dimension(n_parameters) :: values, uncertainty, coarse
      !> What else is known
      type(profile_facts), intent(in) :: facts
      !> The remarks
      type(remark_type), allocatable, intent(out) :: remarks(:)
      real(wp) :: gradient, m2(2), m4(2)
      integer :: directions, k

      allocate (remarks(0))
      directions = count(facts%number > 0)
      m2 = values(p_m2)
      m4 = values(p_m4)
      gradient = values(p_sdq)
      if (directions == 2) then
         m2 = values([p_m2_x, p_m2_y])
         m4 = values([p_m4_x, p_m4_y])
      else if (is_known(m2(1))) then
         gradient = sqrt(2.0_wp*m2(1))
      end if
      call remark_slope(gradient, remarks)
      call remark_isotropy(directions, remarks)
      if (directions == 2) call remark_anisotropy(values, remarks)
      call remark_single(facts, remarks)
      do k = 1, directions
         call remark_waves(values(p_m0), m2(k), facts, k, remarks)
         call remark_resolution(m2(k), m4(k), facts%step(k), trim(where_of(k, directions)), remarks)
      end do
      call remark_alpha(values, uncertainty, 'Filter the long waves out, or scan a map.', remarks)
      call remark_step(values, uncertainty, coarse, remarks)
      if (facts%stylus > 0.0_wp) call remark_stylus(values(p_radius_nayak), facts%stylus, remarks)
   end subroutine find_profile_remarks

   pure subroutine remark_isotropy(directions, remarks)
      integer, intent(in) :: directions
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (directions == 1) then
         call add_remark(remarks, 'isotropy', 'That the surface is isotropic is assumed: '// &
            'profiles in one direction do not show a lay. Profiles at right angles to them '// &
            '(--perpendicular) do.')
      else
         call add_remark(remarks, 'isotropy', 'The two directions are taken for those across '// &
            'the lay and along it; m2 and m4 are the geometric means of both.')
      end if
   end subroutine remark_isotropy

   pure subroutine remark_single(facts, remarks)
      type(profile_facts), intent(in) :: facts
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (all(facts%number /= 1)) return
      call add_remark(remarks, 'single', 'A single profile: uncertainties are from '// &
         to_text(maxval(facts%groups, mask=facts%number == 1))//' parts of it, and say nothing '// &
         'of how the surface differs elsewhere. Take several.')
   end subroutine remark_single

   !> Profiles, or the parts of one, that are no longer than a wave, and lines of a map that are no
   !> wave apart.
   pure subroutine remark_waves(m0, m2, facts, k, remarks)
      real(wp), intent(in) :: m0, m2
      type(profile_facts), intent(in) :: facts
      integer, intent(in) :: k
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: what
      real(wp) :: apart, waves

      if (.not. (is_known(m0) .and. is_known(m2))) return
      if (.not. min(m0, m2) > 0.0_wp) return
      what = 'A profile'
      waves = facts%length(k)*sqrt(m2/m0)/(2.0_wp*pi)
      if (facts%number(k) == 1 .and. facts%groups(k) > 1) then
         what = 'A part of the profile'
         waves = waves/facts%groups(k)
      end if
      apart = facts%spacing(k)*facts%number(k)/facts%groups(k)*sqrt(m2/m0)/(2.0_wp*pi)
      if (facts%spacing(k) > 0.0_wp .and. apart < enough_waves) call add_remark(remarks, &
         'few_waves', 'The lines of the map lie close: their '//to_text(facts%groups(k))// &
         ' groups are only '//to_text(apart, 2)//' typical waves, 2 pi sqrt(m0/m2), wide, not '// &
         'independent of each other, and the uncertainties too small. Take lines further '// &
         'apart, or fewer tiles.')
      if (waves >= enough_waves) return
      call add_remark(remarks, 'few_waves', what//' is only '//to_text(waves, 2)//' typical '// &
         'waves, 2 pi sqrt(m0/m2), long: m0 is too small, and so are the uncertainties. Take '// &
         'longer profiles, fewer tiles, or remove the form or longer waves.')
   end subroutine remark_waves

   pure subroutine remark_resolution(m2, m4, step, along, remarks)
      real(wp), intent(in) :: m2, m4, step
      character(len=*), intent(in) :: along
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      real(wp) :: steps

      if (.not. (is_known(m2) .and. is_known(m4))) return
      if (.not. min(m2, m4) > 0.0_wp) return
      steps = 2.0_wp*pi*sqrt(m2/m4)/step
      if (steps >= enough_steps) return
      call add_remark(remarks, 'resolution', 'The shortest waves'//along// &
         ', 2 pi sqrt(m2/m4), span '//to_text(steps, 2)//' steps, fewer than '// &
         to_text(nint(enough_steps))//': m4 hangs on the step, noise counts as '// &
         'roughness. Scan with a shorter step or filter short waves out.')
   end subroutine remark_resolution

   !> Of which profiles something is said, where there are two directions.
   pure function where_of(k, directions) result(text)
      integer, intent(in) :: k, directions
      character(len=8) :: text

      text = ''
      if (directions == 2) text = merge(' along x', ' along y', k == 1)
   end function where_of

   !> A ball that rolls over a summit of radius R shows R and its own radius together; what is
   !> sharper than it, and pores narrower than it, it does not show.
   pure subroutine remark_stylus(radius, stylus, remarks)
      real(wp), intent(in) :: radius, stylus
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      character(len=:), allocatable :: text

      if (.not. is_known(radius)) return
      text = 'The stylus has a radius of '//to_text(stylus, 4)//' mm, the summits that it '// &
         'shows one of '//to_text(radius, 4)//' mm: '
      if (stylus >= radius) then
         text = text//'none can be sharper than the stylus, so that steps or noise of the '// &
            'record count as roughness. Filter short waves out.'
      else if (stylus > blunt*radius) then
         text = text//'where it shows R, a summit has about R less its own radius, '// &
            to_text(radius - stylus, 4)//' mm. Take a finer stylus, or '//to_text(radius - stylus, &
            4)//' mm for radius.'
      else
         text = text//'it rounds them off by less than a tenth.'
      end if
      call add_remark(remarks, 'stylus', text)
   end subroutine remark_stylus

end module asperity_surface_remarks_on_profiles
