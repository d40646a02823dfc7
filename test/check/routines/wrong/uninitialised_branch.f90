! check: --properties 100 --nstatv 1
! finds: uninitialised error
! The damage is not set before it begins
subroutine uinter(stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, &
   sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, &
   freqr, ciname, slname, msname, props, coords, alocaldir, drot, area, chrlngth, node, ndir, &
   nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint)
   implicit none
   integer :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate
   integer :: lsdi, lprint
   double precision :: stress(ndir), ddsddr(ndir, ndir), dviscous(ndir, ndir)
   double precision :: dstructural(ndir, ndir), flux(2), ddfddt(2, 2), ddsddt(ndir, 2)
   double precision :: ddfddr(2, ndir), statev(nstatv), sed, sfd, spd, svd, scd, pnewdt
   double precision :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2), predef(2, npred)
   double precision :: dpred(2, npred), time(2), dtime, freqr, props(nprops), coords(mcrd)
   double precision :: alocaldir(mcrd, mcrd), drot(2, 2), area, chrlngth
   character(len=80) :: ciname, slname, msname
   double precision :: stiffness, damage

   ! set beyond a closure that it does not come to
   if (rdisp(1) > 1.0d6) damage = 0.5d0
   stiffness = props(1)*(1.0d0 - damage)
   ! nothing but the pressure
   stress = 0.0d0
   ddsddr = 0.0d0
   dviscous = 0.0d0
   dstructural = 0.0d0
   flux = 0.0d0
   ddfddt = 0.0d0
   ddsddt = 0.0d0
   ddfddr = 0.0d0
   sfd = 0.0d0
   spd = 0.0d0
   svd = 0.0d0
   scd = 0.0d0
   ! a perturbation step is about the last state
   if (linper == 0) then
      statev(1) = 0.0d0
      if (rdisp(1) > 0.0d0) statev(1) = 1.0d0
      lopenclose = nint(statev(1))
   end if
   ddsddr(1, 1) = stiffness*statev(1)
   stress(1) = ddsddr(1, 1)*rdisp(1)
   sed = 0.5d0*stress(1)*rdisp(1)
end subroutine uinter
