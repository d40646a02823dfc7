!> A right VUINTER, penalty with Coulomb friction, and the same with one fault at a time; the right
!> one in single precision as well.
module explicit_law
   use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_funloc
   use, intrinsic :: iso_fortran_env, only: real32
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: explicit, explicit_in_single

   !> The faults
   enum, bind(c)
      enumerator :: no_fault = 0, flux_left, energy_left, stress_left, state_beyond, &
         first_node_alone, shares_pressure, counts_calls, never_presses, glued, ignores_turn, &
         pulls, energy_of_increment, ages_by_increment
   end enum
   public :: no_fault, flux_left, energy_left, stress_left, state_beyond, first_node_alone, &
      shares_pressure, counts_calls, never_presses, glued, ignores_turn, pulls, &
      energy_of_increment, ages_by_increment
   !> The fault that the law has
   integer, public :: fault = no_fault

   integer :: calls = 0

contains

   !> PROPS: normal and shear stiffness, MPa/mm; friction coefficient. STATEV: overclosure, elastic
   !> slips, increments.
   subroutine explicit( &
      sfd, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, kstep, kinc, nfacnod, &
      nslvnod, nmstnod, nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv, jslvuid, &
      jmstuid, jconmstid, timstep, timglb, dtimcur, surfint, surfslv, surfmst, rdisp, drdisp, &
      drot, stiffdflt, conddflt, shape, coordslv, coordmst, alocaldir, props, areaslv, &
      tempslv, dtempslv, predefslv, dpredefslv, tempmst, dtempmst, predefmst, dpredefmst)
      integer, intent(in) :: kstep, kinc, nfacnod, nslvnod, nmstnod
      integer, intent(in) :: nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv
      real(vp), intent(inout) :: sfd(nslvnod), scd(nslvnod), spd(nslvnod), svd(nslvnod)
      real(vp), intent(inout) :: stress(ndir, nslvnod)
      real(vp), intent(inout) :: fluxslv(nslvnod), fluxmst(nslvnod)
      real(vp), intent(inout) :: sed(nslvnod), statev(nstatevar, nslvnod)
      integer, intent(in) :: jslvuid(nslvnod), jmstuid(nmstnod), jconmstid(nfacnod, nslvnod)
      real(vp), intent(in) :: timstep, timglb, dtimcur
      character(len=80), intent(in) :: surfint, surfslv, surfmst
      real(vp), intent(in) :: rdisp(ndir, nslvnod), drdisp(ndir, nslvnod)
      real(vp), intent(in) :: drot(2, 2, nslvnod)
      real(vp), intent(in) :: stiffdflt(nslvnod), conddflt(nslvnod)
      real(vp), intent(in) :: shape(nfacnod, nslvnod), coordslv(ndir, nslvnod)
      real(vp), intent(in) :: coordmst(ndir, nmstnod), alocaldir(ndir, ndir, nslvnod)
      real(vp), intent(in) :: props(nprops)
      real(vp), intent(in) :: areaslv(nslvnod), tempslv(nslvnod), dtempslv(nslvnod)
      real(vp), intent(in) :: predefslv(npred, nslvnod), dpredefslv(npred, nslvnod)
      real(vp), intent(in) :: tempmst(numdeftfv), dtempmst(numdeftfv)
      real(vp), intent(in) :: predefmst(npred, numdeftfv), dpredefmst(npred, numdeftfv)
      integer :: i, at

      associate (u1 => kstep, u2 => kinc, u3 => nsurfdir, u4 => ntemp, u5 => jslvuid, &
            u6 => jmstuid, u7 => jconmstid, u8 => timstep, u9 => timglb, u10 => dtimcur, &
            u11 => surfint, u12 => surfslv, u13 => surfmst, u14 => stiffdflt, u15 => conddflt, &
            u16 => shape, u17 => coordslv, u18 => coordmst, u19 => alocaldir, u20 => areaslv, &
            u21 => tempslv, u22 => dtempslv, u23 => predefslv, u24 => dpredefslv, &
            u25 => tempmst, u26 => dtempmst, u27 => predefmst, u28 => dpredefmst)
      end associate
      calls = calls + 1
      do i = 1, nslvnod
         at = i
         if (fault == first_node_alone) at = 1
         if (fault /= flux_left) fluxslv(i) = 0.0_vp
         if (fault /= flux_left) fluxmst(i) = 0.0_vp
         if (fault /= energy_left) scd(i) = 0.0_vp
         svd(i) = 0.0_vp
         call one_node(ndir, nprops, props, rdisp(:, at), drdisp(:, at), drot(:, :, i), &
            nstatevar, statev(:, i), stress(:, i), sed(i), sfd(i), spd(i))
      end do
      if (fault == shares_pressure) stress(1, :) = sum(stress(1, :))/nslvnod
      if (fault == state_beyond) call write_beyond(statev, size(statev))
   end subroutine explicit

   !> One node of it.
   subroutine one_node(ndir, nprops, props, rdisp, drdisp, drot, nstatv, statev, stress, sed, sfd, &
         spd)
      integer, intent(in) :: ndir, nprops, nstatv
      real(wp), intent(in) :: props(nprops), rdisp(ndir), drdisp(ndir), drot(2, 2)
      real(wp), intent(inout) :: statev(nstatv), stress(ndir), sed, sfd, spd
      real(wp) :: p, slip(2), shear(2), trial, before

      before = props(1)*max(statev(1), 0.0_wp)
      p = props(1)*max(rdisp(1), 0.0_wp)
      sfd = 0.0_wp
      spd = 0.0_wp
      slip = 0.0_wp
      shear = 0.0_wp
      if (fault == never_presses) p = 0.0_wp
      if (p > 0.0_wp .and. fault /= glued) then
         slip = statev(2:3)
         if (ndir == 3 .and. fault /= ignores_turn) slip = matmul(drot, slip)
         slip(:ndir - 1) = slip(:ndir - 1) + drdisp(2:)
         shear = props(2)*slip
         trial = hypot(shear(1), shear(2))
         if (trial > props(3)*p) then
            shear = props(3)*p*shear/trial
            slip = shear/props(2)
            sfd = props(3)*p*(trial - props(3)*p)/props(2)
         end if
      end if
      if (fault == glued) p = props(1)*rdisp(1)
      sed = p**2/(2.0_wp*props(1)) + props(2)*dot_product(slip, slip)/2.0_wp
      if (fault == energy_of_increment) sed = (p**2 - before**2)/(2.0_wp*props(1))
      statev(1) = max(rdisp(1), -1.0_wp)
      statev(2:3) = slip
      if (fault == ages_by_increment) then
         spd = (exp(-statev(4)) - exp(-statev(4) - 0.001_wp))*before**2/(2.0_wp*props(1))
         statev(4) = statev(4) + 0.001_wp
         sed = sed + (exp(-statev(4)) - 1.0_wp)*p**2/(2.0_wp*props(1))
         p = p*exp(-statev(4))
      end if
      if (fault == pulls) sed = props(2)*dot_product(slip, slip)/2.0_wp - p**2/(2.0_wp*props(1))
      if (fault == counts_calls) p = p*(1.0_wp + 1.0e-13_wp*mod(calls, 2))
      stress(1) = merge(-p, p, fault == pulls)
      if (fault == stress_left .and. .not. p > 0.0_wp) return
      stress(2:) = shear(:ndir - 1)
   end subroutine one_node

   !> Write after the end of an array, where no compiler sees it.
   subroutine write_beyond(values, n)
      real(wp), intent(inout) :: values(*)
      integer, intent(in) :: n

      values(n + 1) = 0.0_wp
   end subroutine write_beyond

   !> The law in single precision, as a routine of the interface that hosts know.
   function explicit_in_single() result(routine)
      procedure(vuinter_interface), pointer :: routine

      call c_f_procpointer(c_funloc(single), routine)
   end function explicit_in_single

   subroutine single( &
      sfd, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, kstep, kinc, nfacnod, &
      nslvnod, nmstnod, nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv, jslvuid, &
      jmstuid, jconmstid, timstep, timglb, dtimcur, surfint, surfslv, surfmst, rdisp, drdisp, &
      drot, stiffdflt, conddflt, shape, coordslv, coordmst, alocaldir, props, areaslv, &
      tempslv, dtempslv, predefslv, dpredefslv, tempmst, dtempmst, predefmst, dpredefmst)
      integer, intent(in) :: kstep, kinc, nfacnod, nslvnod, nmstnod
      integer, intent(in) :: nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv
      real(real32), intent(inout) :: sfd(nslvnod), scd(nslvnod), spd(nslvnod), svd(nslvnod)
      real(real32), intent(inout) :: stress(ndir, nslvnod)
      real(real32), intent(inout) :: fluxslv(nslvnod), fluxmst(nslvnod)
      real(real32), intent(inout) :: sed(nslvnod), statev(nstatevar, nslvnod)
      integer, intent(in) :: jslvuid(nslvnod), jmstuid(nmstnod), jconmstid(nfacnod, nslvnod)
      real(real32), intent(in) :: timstep, timglb, dtimcur
      character(len=80), intent(in) :: surfint, surfslv, surfmst
      real(real32), intent(in) :: rdisp(ndir, nslvnod), drdisp(ndir, nslvnod)
      real(real32), intent(in) :: drot(2, 2, nslvnod)
      real(real32), intent(in) :: stiffdflt(nslvnod), conddflt(nslvnod)
      real(real32), intent(in) :: shape(nfacnod, nslvnod), coordslv(ndir, nslvnod)
      real(real32), intent(in) :: coordmst(ndir, nmstnod), alocaldir(ndir, ndir, nslvnod)
      real(real32), intent(in) :: props(nprops)
      real(real32), intent(in) :: areaslv(nslvnod), tempslv(nslvnod), dtempslv(nslvnod)
      real(real32), intent(in) :: predefslv(npred, nslvnod), dpredefslv(npred, nslvnod)
      real(real32), intent(in) :: tempmst(numdeftfv), dtempmst(numdeftfv)
      real(real32), intent(in) :: predefmst(npred, numdeftfv), dpredefmst(npred, numdeftfv)
      integer :: i
      real(wp) :: state(nstatevar), tractions(ndir), stored, friction, plastic

      associate (u1 => kstep, u2 => kinc, u3 => nsurfdir, u4 => ntemp, u5 => jslvuid, &
            u6 => jmstuid, u7 => jconmstid, u8 => timstep, u9 => timglb, u10 => dtimcur, &
            u11 => surfint, u12 => surfslv, u13 => surfmst, u14 => stiffdflt, u15 => conddflt, &
            u16 => shape, u17 => coordslv, u18 => coordmst, u19 => alocaldir, u20 => areaslv, &
            u21 => tempslv, u22 => dtempslv, u23 => predefslv, u24 => dpredefslv, &
            u25 => tempmst, u26 => dtempmst, u27 => predefmst, u28 => dpredefmst)
      end associate
      do i = 1, nslvnod
         state = statev(:, i)
         tractions = stress(:, i)
         stored = sed(i)
         call one_node(ndir, nprops, real(props, wp), real(rdisp(:, i), wp), &
            real(drdisp(:, i), wp), real(drot(:, :, i), wp), nstatevar, state, tractions, stored, &
            friction, plastic)
         statev(:, i) = real(state, real32)
         stress(:, i) = real(tractions, real32)
         sed(i) = real(stored, real32)
         sfd(i) = real(friction, real32)
         spd(i) = real(plastic, real32)
      end do
      svd = 0.0_real32
      scd = 0.0_real32
      fluxslv = 0.0_real32
      if (fault /= flux_left) fluxmst = 0.0_real32
   end subroutine single

end module explicit_law
