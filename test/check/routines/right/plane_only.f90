! check: --properties 100 --nstatv 1 --ndir 2
! For two dimensions alone, and says so.
subroutine uinter(stress,ddsddr,dviscous,dstructural,flux,ddfddt,ddsddt, &
   ddfddr,statev,sed,sfd,spd,svd,scd,pnewdt,rdisp,drdisp,temp,dtemp, &
   predef,dpred,time,dtime,freqr,ciname,slname,msname,props,coords, &
   alocaldir,drot,area,chrlngth,node,ndir,nstatv,npred,nprops,mcrd, &
   kstep,kinc,kit,linper,lopenclose,lstate,lsdi,lprint)
   include 'aba_param.inc'
   character(80) :: ciname, slname, msname
   dimension stress(ndir), ddsddr(ndir,ndir), dviscous(ndir,ndir), dstructural(ndir,ndir)
   dimension flux(2), ddfddt(2,2), ddsddt(ndir,2), ddfddr(2,ndir), statev(nstatv)
   dimension rdisp(ndir), drdisp(ndir), temp(2), dtemp(2), predef(2,npred), dpred(2,npred)
   dimension time(2), props(nprops), coords(mcrd), alocaldir(3,3), drot(2,2)

   dviscous = 0; dstructural = 0; flux = 0; ddfddt = 0; ddsddt = 0; ddfddr = 0
   sfd = 0; spd = 0; svd = 0; scd = 0
   ddsddr = 0
   if (ndir /= 2) then
      call stdb_abqerr(-3, 'for two dimensions alone', ndir, props, ciname)
      call xit
   end if
   u = rdisp(1)
   if (linper == 1) u = statev(1)
   stress = 0
   sed = 0
   if (u > 0) then
      ddsddr(1,1) = props(1)
      stress(1) = props(1)*rdisp(1)
      sed = props(1)*u**2/2
   end if
   if (linper == 0) statev(1) = max(u, -1.d0)
end subroutine uinter
