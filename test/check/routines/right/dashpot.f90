! check: --properties 100,20 --nstatv 1
! A penalty with a dashpot in the normal direction, which never pulls.
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
   if (linper == 1) then
      if (statev(1) > 0) ddsddr(1,1) = props(1)
      if (statev(1) > 0) dviscous(1,1) = props(2)
      stress = matmul(ddsddr, rdisp)
      return
   end if
   sed = 0
   stress = 0
   statev(1) = 0
   if (rdisp(1) <= 0) return
   statev(1) = 1
   c = 0
   ! no speed where the surface was just found
   if (dtime > 0 .and. abs(drdisp(1)) < 1.d30) c = props(2)/dtime
   p = props(1)*rdisp(1) + c*drdisp(1)
   sed = props(1)*rdisp(1)**2/2
   if (p <= 0) then
      ! the dashpot holds the spring back
      svd = -props(1)*rdisp(1)*drdisp(1)
      return
   end if
   stress(1) = p
   ddsddr(1,1) = props(1) + c
   dviscous(1,1) = props(2)
   svd = c*drdisp(1)**2
end subroutine uinter
