! check: --properties 100,60,0.4 --nstatv 4
! finds: unset_output note
! Energies are left.
subroutine uinter(stress,ddsddr,dviscous,dstructural,flux,ddfddt,ddsddt, &
   ddfddr,statev,sed,sfd,spd,svd,scd,pnewdt,rdisp,drdisp,temp,dtemp, &
   predef,dpred,time,dtime,freqr,ciname,slname,msname,props,coords, &
   alocaldir,drot,area,chrlngth,node,ndir,nstatv,npred,nprops,mcrd, &
   kstep,kinc,kit,linper,lopenclose,lstate,lsdi,lprint)
   implicit none
   character(80) :: ciname, slname, msname
   integer :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper
   integer :: lopenclose, lstate, lsdi, lprint, i, m
   double precision :: stress(ndir), ddsddr(ndir,ndir), dviscous(ndir,ndir), dstructural(ndir,ndir)
   double precision :: flux(2), ddfddt(2,2), ddsddt(ndir,2), ddfddr(2,ndir), statev(nstatv)
   double precision :: sed, sfd, spd, svd, scd, pnewdt, rdisp(ndir), drdisp(ndir)
   double precision :: temp(2), dtemp(2), predef(2,npred), dpred(2,npred), time(2), dtime, freqr
   double precision :: props(nprops), coords(mcrd), alocaldir(3,3), drot(2,2), area, chrlngth
   double precision :: kn, kt, mu, p, slip(2), shear(2), n(2), trial

   kn = props(1); kt = props(2); mu = props(3)
   m = ndir - 1
   dviscous = 0; dstructural = 0; flux = 0; ddfddt = 0; ddsddt = 0; ddfddr = 0
   ddsddr = 0;
   if (linper == 1) then
      if (statev(4) > 0) ddsddr(1,1) = kn
      stress = matmul(ddsddr, rdisp)
      return
   end if
   stress = 0
   if (rdisp(1) <= 0) then
      statev = 0
      return
   end if
   p = kn*rdisp(1)
   slip = statev(2:3)
   if (ndir == 3) slip = matmul(drot, slip)
   slip(:m) = slip(:m) + drdisp(2:)
   shear = kt*slip
   trial = sqrt(sum(shear**2))
   ddsddr(1,1) = kn
   do i = 2, ndir
      ddsddr(i,i) = kt
   end do
   if (trial > mu*p) then
      n = shear/trial
      ddsddr(2:,1) = mu*kn*n(:m)
      do i = 1, m
         ddsddr(2:,1+i) = -mu*p*kt/trial*n(:m)*n(i)
         ddsddr(1+i,1+i) = ddsddr(1+i,1+i) + mu*p*kt/trial
      end do
      shear = mu*p*n
      slip = shear/kt
   end if
   stress(1) = p
   stress(2:) = shear(:m)
   statev(1) = rdisp(1)
   statev(2:3) = slip
   statev(4) = 1
end subroutine uinter
