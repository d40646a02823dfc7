! check: --properties 100,60,0.4 --nstatv 1
! Coulomb friction that begins from the shear STRESS of the start, and keeps none in STATEV.
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
   dimension tau(2), d(2)

   dviscous = 0; dstructural = 0; flux = 0; ddfddt = 0; ddsddt = 0; ddfddr = 0
   sfd = 0; spd = 0; svd = 0; scd = 0
   ddsddr = 0
   if (linper == 1) then
      if (statev(1) > 0) ddsddr(1,1) = props(1)
      if (statev(1) == 1) then
         do i = 2, ndir
            ddsddr(i,i) = props(2)
         end do
      end if
      stress = matmul(ddsddr, rdisp)
      return
   end if
   sed = 0
   statev(1) = 0
   if (rdisp(1) <= 0) then
      stress = 0
      return
   end if
   tau = 0
   tau(1:ndir-1) = stress(2:ndir)
   if (ndir == 3) tau = matmul(drot, tau)
   tau(1:ndir-1) = tau(1:ndir-1) + props(2)*drdisp(2:ndir)
   p = props(1)*rdisp(1)
   trial = sqrt(sum(tau**2))
   statev(1) = 1
   ddsddr(1,1) = props(1)
   do i = 2, ndir
      ddsddr(i,i) = props(2)
   end do
   if (trial > props(3)*p) then
      statev(1) = 2
      d = tau/trial
      ddsddr(2:ndir,1) = props(3)*props(1)*d(1:ndir-1)
      do i = 2, ndir
         do j = 2, ndir
            ddsddr(i,j) = -props(3)*p*props(2)/trial*d(i-1)*d(j-1)
         end do
         ddsddr(i,i) = ddsddr(i,i) + props(3)*p*props(2)/trial
      end do
      sfd = props(3)*p*(trial - props(3)*p)/props(2)
      tau = props(3)*p*d
   end if
   stress(1) = p
   stress(2:ndir) = tau(1:ndir-1)
   sed = p**2/(2*props(1)) + sum(tau**2)/(2*props(2))
end subroutine uinter
