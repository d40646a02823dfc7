! check: --properties 100,60,1.5,0.4 --nstatv 4
! Bonded in shear up to a strength, which is then lost at once; after that Coulomb friction.
! Properties: normal and shear stiffness, strength, coefficient.
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
   ak = props(1); at = props(2)
   if (linper == 1) then
      if (statev(1) > 0) ddsddr(1,1) = ak
      do i = 2, ndir
         if (statev(1) == 1) ddsddr(i,i) = at
      end do
      stress = matmul(ddsddr, rdisp)
      return
   end if
   sed = 0
   stress = 0
   statev(1) = 0
   if (rdisp(1) <= 0) then
      statev(2:3) = 0
      return
   end if
   p = ak*rdisp(1)
   tau = statev(2:3)
   if (ndir == 3) tau = matmul(drot, tau)
   tau(1:ndir-1) = tau(1:ndir-1) + at*drdisp(2:ndir)
   trial = sqrt(sum(tau**2))
   d = 0
   if (trial > 0) d = tau/trial
   statev(1) = 1
   ddsddr(1,1) = ak
   do i = 2, ndir
      ddsddr(i,i) = at
   end do
   broke = statev(4)
   if (trial > props(3)) statev(4) = 1
   if (statev(4) > 0 .and. trial > props(4)*p) then
      statev(1) = 2
      ddsddr(2:ndir,1) = props(4)*ak*d(1:ndir-1)
      do i = 2, ndir
         do j = 2, ndir
            ddsddr(i,j) = -props(4)*p*at/trial*d(i-1)*d(j-1)
         end do
         ddsddr(i,i) = ddsddr(i,i) + props(4)*p*at/trial
      end do
      tau = props(4)*p*d
      sfd = props(4)*p*(trial - props(4)*p)/at
      ! what the bond held goes at once
      if (broke == 0) sfd = (trial**2 - (props(4)*p)**2)/(2*at)
   end if
   stress(1) = p
   stress(2:ndir) = tau(1:ndir-1)
   sed = p**2/(2*ak) + sum(tau**2)/(2*at)
   statev(2:3) = tau
end subroutine uinter
