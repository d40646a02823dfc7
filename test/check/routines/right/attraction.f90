! check: --properties 5,0.02 --nstatv 1 --largest-overclosure 0.008 --largest-gap 0.1
! Attraction and repulsion of faces at a distance. Properties: scale of stress, distance of
! equilibrium.
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
   x = rdisp(1)
   if (linper == 1) x = statev(1)
   stress = 0
   sed = 0
   z0 = props(2)
   if (linper == 0) statev(1) = max(x, -1.d3)
   if (x > -1.d30) then
      g = z0/(z0 - x)
      p = props(1)*(g**9 - g**3)
      ddsddr(1,1) = props(1)/z0*(9*g**10 - 3*g**4)
      if (linper == 1) then
         stress = matmul(ddsddr, rdisp)
      else
         stress(1) = p
         sed = props(1)*z0*(g**8/8 - g**2/2)
      end if
   end if
end subroutine uinter
