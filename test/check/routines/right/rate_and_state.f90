! check: --properties 100,200,0.3,0.01,0.015,1e-3,0.01 --nstatv 5
! Rate and state friction with the ageing law, by backward Euler. Properties: normal and shear
! stiffness, mu, a, b, V0, L.
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
   ak = props(1); at = props(2); a = props(4); b = props(5); v0 = props(6); al = props(7)
   if (linper == 1) then
      if (statev(1) > 0) ddsddr(1,1) = ak
      do i = 2, ndir
         if (statev(1) > 0) ddsddr(i,i) = at
      end do
      stress = matmul(ddsddr, rdisp)
      return
   end if
   sed = 0
   stress = 0
   age = statev(4) + dtime
   if (statev(5) == 0) age = al/v0
   statev(5) = 1
   if (rdisp(1) <= 0) then
      statev(1:3) = 0
      statev(4) = age
      return
   end if
   p = ak*rdisp(1)
   tau = statev(2:3)
   if (ndir == 3) tau = matmul(drot, tau)
   tau(1:ndir-1) = tau(1:ndir-1) + at*drdisp(2:ndir)
   trial = sqrt(sum(tau**2))
   d = 0
   if (trial > 0) d = tau/trial
   s = 0
   if (trial > 0 .and. dtime > 0) then
      hi = trial/at
      dlo = 0
      do i = 1, 200
         s = (dlo + hi)/2
         if (trial - at*s - p*a*asinh(z(s)) > 0) then
            dlo = s
         else
            hi = s
         end if
      end do
   end if
   ! derivatives of s by trial and by p
   st = 0; sp = 0
   if (s > 0) then
      fs = -at - p*a/sqrt(1 + z(s)**2)*z(s)*(1/s - b/a/(al + s))
      st = -1/fs
      sp = a*asinh(z(s))/fs
   end if
   tnew = trial - at*s
   stress(1) = p
   stress(2:ndir) = tnew*d(1:ndir-1)
   ddsddr(1,1) = ak
   ddsddr(2:ndir,1) = -at*sp*ak*d(1:ndir-1)
   do i = 2, ndir
      if (trial > 0) then
         do j = 2, ndir
            ddsddr(i,j) = at*(1 - at*st - tnew/trial)*d(i-1)*d(j-1)
         end do
         ddsddr(i,i) = ddsddr(i,i) + at*tnew/trial
      else
         ddsddr(i,i) = at
      end if
   end do
   sfd = tnew*s
   sed = p**2/(2*ak) + tnew**2/(2*at)
   statev(1) = 1
   statev(2:3) = tnew*d
   statev(4) = age/(1 + s/al)
contains
   double precision function z(s)
      double precision, intent(in) :: s
      z = s/(2*v0*dtime)*exp((props(3) + b*log(age/(1 + s/al)*v0/al))/a)
   end function
end subroutine uinter
