!> A right UINTER, penalty with Coulomb friction, and the same with one fault at a time.
module faulty_law
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: law

   !> The faults
   enum, bind(c)
      enumerator :: no_fault = 0, tangent_left, damping_left, heat_left, dissipation_left, &
         stored_left, shear_left_open, tangent_added, state_beyond, property_beyond, &
         tangent_halved, tangent_symmetric, tangent_sign, counts_calls, remembers_points, &
         never_presses, glued, divides, first_alone, always_cuts, ignores_perturbation, &
         perturbation_moves_state, ignores_turn, three_always, left_in_two_d, pulls, absolute, &
         shear_reversed, energy_of_increment, dissipation_total, no_energy, ages_by_increment, &
         viscous_without_time
   end enum
   public :: no_fault, tangent_left, damping_left, heat_left, dissipation_left, stored_left, &
      shear_left_open, tangent_added, state_beyond, property_beyond, tangent_halved, &
      tangent_symmetric, tangent_sign, counts_calls, remembers_points, never_presses, glued, &
      divides, first_alone, always_cuts, ignores_perturbation, perturbation_moves_state, &
      ignores_turn, three_always, left_in_two_d, pulls, absolute, shear_reversed, &
      energy_of_increment, dissipation_total, no_energy, ages_by_increment, viscous_without_time
   !> The fault that the law has
   integer, public :: fault = no_fault

   !> What a faulty law keeps between calls
   integer :: calls = 0
   real(wp) :: last_position = 0.0_wp

contains

   !> PROPS: normal stiffness, shear stiffness, MPa/mm; friction coefficient. STATEV: overclosure,
   !> elastic slips, share of the friction used (1 slips), increments.
   subroutine law( &
      stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, &
      svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, &
      slname, msname, props, coords, alocaldir, drot, area, chrlngth, node, ndir, nstatv, npred, &
      nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint)
      integer, intent(in) :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit
      integer, intent(in) :: linper, lprint
      real(wp), intent(inout) :: stress(ndir)
      real(wp), intent(inout) :: ddsddr(ndir, ndir), dviscous(ndir, ndir)
      real(wp), intent(inout) :: dstructural(ndir, ndir)
      real(wp), intent(inout) :: flux(2), ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir)
      real(wp), intent(inout) :: statev(nstatv)
      real(wp), intent(inout) :: sed, sfd, spd, svd, scd, pnewdt
      real(wp), intent(in) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2)
      real(wp), intent(in) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr
      character(len=80), intent(in) :: ciname, slname, msname
      real(wp), intent(in) :: props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2)
      real(wp), intent(in) :: area, chrlngth
      integer, intent(inout) :: lopenclose, lstate, lsdi
      real(wp) :: tangent(3, 3), tractions(3), slip(2), shear(2), direction(2), pressure, u, size_of
      real(wp) :: old_pressure, dissipated

      associate (u1 => temp, u2 => dtemp, u3 => predef, u4 => dpred, u5 => time, u6 => dtime, &
            u7 => freqr, u8 => ciname, u9 => slname, u10 => msname, u11 => coords, u12 => area, &
            u13 => alocaldir, u14 => chrlngth, u15 => node, u16 => kstep, u17 => kinc, &
            u18 => lprint, u19 => lsdi)
      end associate
      if (fault /= damping_left) dviscous = 0.0_wp
      if (fault /= damping_left) dstructural = 0.0_wp
      if (fault /= heat_left) then
         flux = 0.0_wp
         ddfddt = 0.0_wp
         ddsddt = 0.0_wp
         ddfddr = 0.0_wp
      end if
      if (fault /= dissipation_left) then
         spd = 0.0_wp
         svd = 0.0_wp
         scd = 0.0_wp
      end if
      sfd = 0.0_wp
      tangent = 0.0_wp
      tractions = 0.0_wp
      u = rdisp(1)
      if (fault == absolute .and. u > -1.0e30_wp) u = abs(u)
      pressure = props(1)*max(u, 0.0_wp)
      if (fault == never_presses) pressure = 0.0_wp
      if (fault == glued) pressure = props(1)*u

      if (linper == 1 .and. fault /= ignores_perturbation) then
         if (statev(1) > 0.0_wp .or. fault == glued) tangent(1, 1) = props(1)
         if (statev(4) < 1.0_wp .and. statev(1) > 0.0_wp) then
            tangent(2, 2) = props(2)
            tangent(3, 3) = props(2)
         end if
         ddsddr = tangent(:ndir, :ndir)
         stress = matmul(ddsddr, rdisp)
         if (fault == perturbation_moves_state) statev(1) = rdisp(1)
         return
      end if

      slip = 0.0_wp
      if (pressure > 0.0_wp .and. fault /= never_presses .and. fault /= glued) then
         tangent(1, 1) = props(1)
         if (fault == absolute .and. rdisp(1) < 0.0_wp) tangent(1, 1) = -props(1)
         slip = statev(2:3)
         if (ndir == 3 .and. fault /= ignores_turn) slip = matmul(drot, slip)
         slip(:ndir - 1) = slip(:ndir - 1) + drdisp(2:)
         shear = props(2)*slip
         size_of = hypot(shear(1), shear(2))
         statev(4) = size_of/(props(3)*pressure)
         if (size_of > props(3)*pressure) then
            direction = shear/size_of
            dissipated = props(3)*pressure*(size_of - props(3)*pressure)/props(2)
            if (fault == dissipation_total) then
               statev(5) = statev(5) + dissipated
               dissipated = statev(5)
            end if
            sfd = dissipated
            shear = props(3)*pressure*direction
            slip = shear/props(2)
            tangent(2:3, 1) = props(3)*tangent(1, 1)*direction
            tangent(2, 2) = props(3)*pressure*props(2)/size_of*(1.0_wp - direction(1)**2)
            tangent(3, 2) = -props(3)*pressure*props(2)/size_of*direction(1)*direction(2)
            tangent(2, 3) = tangent(3, 2)
            tangent(3, 3) = props(3)*pressure*props(2)/size_of*(1.0_wp - direction(2)**2)
         else
            tangent(2, 2) = props(2)
            tangent(3, 3) = props(2)
         end if
         tractions(2:3) = shear
      else
         if (fault == glued) tangent(1, 1) = props(1)
         statev(4) = 0.0_wp
      end if
      tractions(1) = pressure
      old_pressure = props(1)*max(statev(1), 0.0_wp)
      if (fault /= stored_left) sed = (pressure**2/props(1) &
         + props(2)*dot_product(slip, slip))/2.0_wp
      if (fault == energy_of_increment) sed = (pressure**2 - old_pressure**2)/(2.0_wp*props(1))
      statev(1) = max(rdisp(1), -1.0_wp)
      statev(2:3) = slip
      lopenclose = merge(1, 0, pressure > 0.0_wp)
      lstate = lopenclose

      select case (fault)
      case (absolute)
         ! the work that its tractions take
         sed = sed + pressure*(rdisp(1) - u)/2.0_wp
      case (tangent_halved)
         tangent(1, 1) = tangent(1, 1)/2.0_wp
      case (tangent_symmetric)
         tangent(2:3, 1) = tangent(2:3, 1)/2.0_wp
         tangent(1, 2:3) = tangent(2:3, 1)
      case (tangent_sign)
         tangent(1, 1) = -tangent(1, 1)
      case (counts_calls)
         calls = calls + 1
         tractions(1) = tractions(1)*(1.0_wp + 1.0e-13_wp*mod(calls, 2))
      case (remembers_points)
         tractions(1) = tractions(1)*(1.0_wp + 1.0e-13_wp*tanh(last_position))
         last_position = rdisp(1)
      case (first_alone)
         if (kit == 0) tractions(1) = 2.0_wp*tractions(1)
      case (always_cuts)
         if (drdisp(1) > 0.0_wp) pnewdt = 0.5_wp
      case (divides)
         if (abs(drdisp(1)) <= 0.0_wp) tangent(1, 1) = ieee_value(1.0_wp, ieee_quiet_nan)
      case (pulls)
         tractions(1) = -tractions(1)
         tangent(1, :) = -tangent(1, :)
         sed = props(2)*dot_product(slip, slip)/2.0_wp - pressure**2/(2.0_wp*props(1))
      case (shear_reversed)
         tractions(2:3) = -tractions(2:3)
         tangent(2:3, :) = -tangent(2:3, :)
         sed = (pressure**2/props(1) - props(2)*dot_product(slip, slip))/2.0_wp
         sfd = -sfd
      case (no_energy)
         sed = 0.0_wp
         sfd = 0.0_wp
      case (ages_by_increment)
         spd = (exp(-statev(5)) - exp(-statev(5) - 0.001_wp))*old_pressure**2/(2.0_wp*props(1))
         statev(5) = statev(5) + 0.001_wp
         sed = sed + (exp(-statev(5)) - 1.0_wp)*pressure**2/(2.0_wp*props(1))
         tractions(1) = tractions(1)*exp(-statev(5))
         tangent(1, 1) = tangent(1, 1)*exp(-statev(5))
      case (viscous_without_time)
         if (pressure > 0.0_wp) then
            tractions(2:) = 0.0_wp
            tractions(2:ndir) = 0.2_wp*props(2)*drdisp(2:)
            tangent(2:3, :) = 0.0_wp
            tangent(2, 2) = 0.2_wp*props(2)
            tangent(3, 3) = 0.2_wp*props(2)
         end if
         sed = pressure**2/(2.0_wp*props(1))
         sfd = 0.0_wp
         if (pressure > 0.0_wp) sfd = 0.2_wp*props(2)*dot_product(drdisp(2:), drdisp(2:))
      case (state_beyond)
         call write_beyond(statev, nstatv)
      case (property_beyond)
         tractions(1) = tractions(1)*(1.0_wp + 1.0e-13_wp*beyond(props, nprops))
      case default
      end select
      if (fault == dissipation_left .and. .not. sfd > 0.0_wp) sfd = 0.0_wp

      if (fault == shear_left_open .and. .not. pressure > 0.0_wp) then
         stress(1) = 0.0_wp
      else
         stress = tractions(:ndir)
      end if
      if (fault == three_always) call write_third(stress, tractions(3))
      select case (fault)
      case (tangent_added)
         ddsddr(1, 1) = ddsddr(1, 1) + tangent(1, 1)
         ddsddr(2:, 1) = tangent(2:ndir, 1)
         ddsddr(:, 2:) = tangent(:ndir, 2:ndir)
      case (tangent_left)
         ddsddr(1, 1) = tangent(1, 1)
         ddsddr(2:, :) = tangent(2:ndir, :ndir)
      case (left_in_two_d)
         if (ndir == 3) ddsddr(1, 2) = 0.0_wp
         ddsddr(:, 1) = tangent(:ndir, 1)
         ddsddr(2:, 2:) = tangent(2:ndir, 2:ndir)
         if (ndir == 3) ddsddr(1, 3) = 0.0_wp
      case default
         ddsddr = tangent(:ndir, :ndir)
      end select
   end subroutine law

   !> Write after the end of an array, where no compiler sees it.
   subroutine write_beyond(values, n)
      real(wp), intent(inout) :: values(*)
      integer, intent(in) :: n

      values(n + 1) = 0.0_wp
   end subroutine write_beyond

   !> Write to the third component, whether there is one or not.
   subroutine write_third(values, x)
      real(wp), intent(inout) :: values(*)
      real(wp), intent(in) :: x

      values(3) = x
   end subroutine write_third

   !> The number after the end of an array.
   real(wp) function beyond(values, n)
      real(wp), intent(in) :: values(*)
      integer, intent(in) :: n

      beyond = values(n + 1)
   end function beyond

end module faulty_law
