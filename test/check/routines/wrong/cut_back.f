C check: --properties 100. --nstatv 1
C finds: cut_back error
C     Asks for half of the increment whenever faces close.
      subroutine uinter(stress,ddsddr,dviscous,dstructural,flux,ddfddt,
     1 ddsddt,ddfddr,statev,sed,sfd,spd,svd,scd,pnewdt,rdisp,drdisp,
     2 temp,dtemp,predef,dpred,time,dtime,freqr,ciname,slname,msname,
     3 props,coords,alocaldir,drot,area,chrlngth,node,ndir,nstatv,
     4 npred,nprops,mcrd,kstep,kinc,kit,linper,lopenclose,lstate,lsdi,
     5 lprint)
      include 'aba_param.inc'
      dimension stress(ndir),ddsddr(ndir,ndir),dviscous(ndir,ndir),
     1 dstructural(ndir,ndir),flux(2),ddfddt(2,2),ddsddt(ndir,2),
     2 ddfddr(2,ndir),statev(nstatv),rdisp(ndir),drdisp(ndir),temp(2),
     3 dtemp(2),predef(2,npred),dpred(2,npred),time(2),props(nprops),
     4 coords(mcrd),alocaldir(3,3),drot(2,2)
      character*80 ciname,slname,msname
C
      ddsddr=0.d0
      dviscous=0.d0
      dstructural=0.d0
      flux=0.d0
      ddfddt=0.d0
      ddsddt=0.d0
      ddfddr=0.d0
      sfd=0.d0
      spd=0.d0
      svd=0.d0
      scd=0.d0
      stress=0.d0
      u=rdisp(1)
      if (linper.eq.1) then
         if (statev(1).gt.0.d0) ddsddr(1,1)=props(1)
         stress(1)=ddsddr(1,1)*rdisp(1)
         return
      end if
      sed=0.d0
      statev(1)=0.d0
      if (u.gt.0.d0) then
         stress(1)=props(1)*u
         ddsddr(1,1)=props(1)
         sed=props(1)*u*u/2
         statev(1)=u
         if (drdisp(1).gt.0.d0) pnewdt=0.5d0
      end if
      return
      end
