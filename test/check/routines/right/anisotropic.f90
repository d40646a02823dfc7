! check: --properties 100,60,0.5,0.2 --nstatv 3
! Friction with two coefficients along the two slip directions, and turning with these. Properties:
! normal and shear stiffness, coefficients.
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
   dimension tau(2), d(2), r(2)
   dviscous = 0; dstructural = 0; flux = 0; ddfddt = 0; ddsddt = 0; ddfddr = 0
   sfd = 0; spd = 0; svd = 0; scd = 0
   ddsddr = 0
   ak = props(1); at = props(2)
   r = [props(3), props(4)]
   if (linper == 1) then
      if (statev(1) > 0) ddsddr(1,1) = ak
      do i = 2, ndir
         if (statev(1) == 1) ddsddr(i,i) = at*r(i-1)
      end do
      stress = matmul(ddsddr, rdisp)
      return
   end if
   sed = 0
   stress = 0
   if (rdisp(1) <= 0) then
      statev = 0
      return
   end if
   p = ak*rdisp(1)
   ! elastic slip; shear = at r slip, |slip| <= p/at
   tau = statev(2:3)
   if (ndir == 3) tau = matmul(drot, tau)
   tau(1:ndir-1) = tau(1:ndir-1) + drdisp(2:ndir)
   trial = sqrt(sum(tau**2))
   statev(1) = 1
   ddsddr(1,1) = ak
   do i = 2, ndir
      ddsddr(i,i) = at*r(i-1)
   end do
   if (trial > p/at) then
      statev(1) = 2
      d = tau/trial
      ddsddr(2:ndir,1) = ak*r(1:ndir-1)*d(1:ndir-1)
      do i = 2, ndir
         do j = 2, ndir
            ddsddr(i,j) = -p*r(i-1)/trial*d(i-1)*d(j-1)
         end do
         ddsddr(i,i) = ddsddr(i,i) + p*r(i-1)/trial
      end do
      sfd = sum(r*d**2)*p*(trial - p/at)
      tau = p/at*d
   end if
   stress(1) = p
   stress(2:ndir) = at*r(1:ndir-1)*tau(1:ndir-1)
   sed = p**2/(2*ak) + at*sum(r*tau**2)/2
   statev(2:3) = tau
end subroutine uinter
