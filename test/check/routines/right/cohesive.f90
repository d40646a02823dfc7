! check: --properties 50,0.02,0.4 --nstatv 4
! Bonded faces with linear softening in tension and shear, one damage for both; pressed faces are a
! penalty. Properties: stiffness, separation at the peak and at failure.
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
   dimension d(3)

   ak = props(1); peak = props(2); fail = props(3)
   dviscous = 0; dstructural = 0; flux = 0; ddfddt = 0; ddsddt = 0; ddfddr = 0
   ddsddr = 0; sfd = 0; svd = 0; scd = 0; spd = 0

   ! separations: tension opens, pressure does not damage
   d = 0
   if (linper == 1) then
      d(1:ndir) = statev(2:1+ndir)
   else
      d(1:ndir) = rdisp
   end if
   closed = max(d(1), 0.d0)
   d(1) = min(d(1), 0.d0)
   before = statev(1)
   if (linper == 0 .and. d(1) > -1.d30) then
      size_of = sqrt(sum(d**2))
      statev(1) = max(before, size_of)
   else if (linper == 0) then
      statev(1) = max(before, fail)
      size_of = 0
      d = 0
   end if
   damage = damage_of(statev(1))
   do i = 1, ndir
      ddsddr(i,i) = (1 - damage)*ak
   end do
   if (closed > 0) ddsddr(1,1) = ak
   if (linper == 1) then
      stress = matmul(ddsddr, rdisp)
      return
   end if
   stress = (1 - damage)*ak*d(1:ndir)
   if (closed > 0) stress(1) = ak*closed
   if (statev(1) > before .and. statev(1) > peak .and. statev(1) < fail .and. size_of > 0) then
      slope = ak*fail*peak/((fail - peak)*statev(1)**2*size_of)
      do j = 1, ndir
         ddsddr(:,j) = ddsddr(:,j) - slope*d(1:ndir)*d(j)
      end do
   end if
   sed = (1 - damage)*ak*sum(d**2)/2 + ak*closed**2/2
   spd = lost(statev(1)) - lost(before)
   statev(2:1+ndir) = rdisp
contains
   double precision function damage_of(s)
      double precision, intent(in) :: s
      damage_of = 0
      if (s > peak) damage_of = min(fail*(s - peak)/(s*(fail - peak)), 1.d0)
   end function
   ! energy under the curve up to s, less what unloading gives back
   double precision function lost(s)
      double precision, intent(in) :: s
      double precision :: e
      lost = 0
      if (s <= peak) return
      e = min(s, fail)
      lost = ak*peak**2/2 + ak*peak/(fail - peak)*(fail*(e - peak) - (e**2 - peak**2)/2) &
         - (1 - damage_of(s))*ak*s**2/2
   end function
end subroutine uinter
