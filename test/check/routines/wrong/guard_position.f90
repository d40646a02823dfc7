! check: --properties 100,60,0.4 --nstatv 4
! finds: guard error
! Writes to RDISP where there is no surface opposite.
subroutine uinter(stress,ddsddr,dviscous,dstructural,flux,ddfddt,ddsddt, &
   ddfddr,statev,sed,sfd,spd,svd,scd,pnewdt,rdisp,drdisp,temp,dtemp, &
   predef,dpred,time,dtime,freqr,ciname,slname,msname,props,coords, &
   alocaldir,drot,area,chrlngth,node,ndir,nstatv,npred,nprops,mcrd, &
   kstep,kinc,kit,linper,lopenclose,lstate,lsdi,lprint)
   implicit none
   character(80) :: ciname, slname, msname
   integer :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper
   integer :: lopenclose, lstate, lsdi, lprint
   double precision :: stress(ndir), ddsddr(ndir,ndir), dviscous(ndir,ndir), dstructural(ndir,ndir)
   double precision :: flux(2), ddfddt(2,2), ddsddt(ndir,2), ddfddr(2,ndir), statev(nstatv)
   double precision :: sed, sfd, spd, svd, scd, pnewdt, rdisp(ndir), drdisp(ndir)
   double precision :: temp(2), dtemp(2), predef(2,npred), dpred(2,npred), time(2), dtime, freqr
   double precision :: props(nprops), coords(mcrd), alocaldir(3,3), drot(2,2), area, chrlngth
   double precision :: kn, kt, mu, p, shear(2), slip(2), n(2), trial, limit
   integer :: i, j, m

   kn = props(1)
   kt = props(2)
   mu = props(3)
   m = ndir - 1
   dviscous = 0; dstructural = 0; flux = 0; ddfddt = 0; ddsddt = 0; ddfddr = 0
   ddsddr = 0; sfd = 0; spd = 0; svd = 0; scd = 0

   if (linper == 1) then
      ! about the state kept in statev: 0 open, 1 stick, 2 slip
      if (statev(4) > 0) ddsddr(1,1) = kn
      if (statev(4) == 1) then
         do i = 2, ndir
            ddsddr(i,i) = kt
         end do
      end if
      stress = matmul(ddsddr, rdisp)
      return
   end if

   stress = 0
   sed = 0
   rdisp(1) = max(rdisp(1), -1d0)
   if (rdisp(1) <= 0) then
      ! open, or nothing opposite
      statev = 0
      lopenclose = 0
      return
   end if
   lopenclose = 1
   p = kn*rdisp(1)
   stress(1) = p
   ddsddr(1,1) = kn
   slip = statev(2:3)
   if (ndir == 3) slip = matmul(drot, slip)
   slip(:m) = slip(:m) + drdisp(2:)
   shear = kt*slip
   trial = sqrt(sum(shear**2))
   limit = mu*p
   statev(4) = 1
   if (trial > limit) then
      statev(4) = 2
      n = shear/trial
      do j = 1, m
         ddsddr(1+j,1) = mu*kn*n(j)
         do i = 1, m
            ddsddr(1+i,1+j) = -limit*kt/trial*n(i)*n(j)
         end do
         ddsddr(1+j,1+j) = ddsddr(1+j,1+j) + limit*kt/trial
      end do
      sfd = limit*(trial - limit)/kt
      shear = limit*n
      slip = shear/kt
   else
      do i = 2, ndir
         ddsddr(i,i) = kt
      end do
   end if
   stress(2:) = shear(:m)
   sed = p**2/(2*kn) + kt*sum(slip**2)/2
   statev(1) = rdisp(1)
   statev(2:3) = slip
end subroutine uinter
