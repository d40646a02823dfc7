c A caller as ABAQUS would be: fixed form, everything typed implicitly, compiled with
c -fdefault-real-8, no interface of UINTER in sight. Its numbers are those of the first pair
c at h = 2.532, where normal_law_reference.csv holds pressure and stiffness to 30 digits.
      program caller
      include 'aba_param.inc'
      dimension props(9), statev(11)
      common /counts/ npassed, nfailed
      data props /0.5, 0.31, 206.0, 297.0, 3.14159265358979, 0.1477,
     1   24.53, 0.4, 0.0593/
      npassed = 0
      nfailed = 0
c datum: d0 = 4 sigma, as props(10) is left out
      closure = 4.0*0.0593 - 0.1501476
      p = 0.33732782403076127
      stiff = 18.262576572168773

      do ndir = 2, 3
         statev = 0.0
         call push(ndir, closure, 0.0, 0.0, props, statev, p, 0.0, 0.0,
     1      stiff, 0.0, 1)
c        sliding by 1 mm: the elastic slip is 0.31 mm of it
         if (ndir .eq. 2) call push(ndir, closure, 1.0, 0.0, props,
     1      statev, p, 0.5*p, 0.0, stiff, 0.5*p*(1.0 - 0.31), 1)
         if (ndir .eq. 3) call push(ndir, closure, 0.6, 0.8, props,
     1      statev, p, 0.3*p, 0.4*p, stiff, 0.5*p*(1.0 - 0.31), 1)
c        no opposite surface
         call push(ndir, -1.0e36, 0.0, 0.0, props, statev, 0.0, 0.0,
     1      0.0, 0.0, 0.0, 0)
      end do
      print '(i0, a, i0, a)', npassed, ' passed, ', nfailed, ' failed'
      if (nfailed .gt. 0) stop 1
      end

c One increment to closure c with slip s2, s3, against what is expected of it
      subroutine push(ndir, c, s2, s3, props, statev, p, t2, t3, stiff,
     1   dissip, lclose)
      include 'aba_param.inc'
      dimension props(9), statev(11), stress(3), ddsddr(9), dvisc(9),
     1   dstruc(9), flux(2), ddfddt(4), ddsddt(6), ddfddr(6), rdisp(3),
     2   drdisp(3), temp(2), dtemp(2), predef(2), dpred(2), time(2),
     3   coords(3), aloc(9), drot(4)
      character*80 ciname, slname, msname
      ciname = 'WOOD'
      slname = 'LOWER'
      msname = 'UPPER'
      stress = -99.0
      ddsddr = -99.0
      sed = 0.0
      pnewdt = 10.0
      rdisp = 0.0
      drdisp = 0.0
      rdisp(1) = c
      rdisp(2) = s2
      rdisp(3) = s3
      drdisp(2) = s2
      drdisp(3) = s3
      temp = 0.0
      dtemp = 0.0
      predef = 0.0
      dpred = 0.0
      time = 1.0
      dtime = 1.0
      freqr = 0.0
      coords = 0.0
      aloc = 0.0
      aloc(1) = 1.0
      aloc(5) = 1.0
      aloc(9) = 1.0
      drot = 0.0
      drot(1) = 1.0
      drot(4) = 1.0
      area = 1.0
      chrlng = 1.0
      node = 7
      nstatv = 11
      npred = 1
      nprops = 9
      mcrd = ndir
      kstep = 1
      kinc = 1
      kit = 0
      linper = 0
      lopen = -1
      lstate = -1
      lsdi = 0
      lprint = 0
      call uinter(stress, ddsddr, dvisc, dstruc, flux, ddfddt, ddsddt,
     1   ddfddr, statev, sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp,
     2   temp, dtemp, predef, dpred, time, dtime, freqr, ciname, slname,
     3   msname, props, coords, aloc, drot, area, chrlng, node, ndir,
     4   nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopen,
     5   lstate, lsdi, lprint)
      call check('pressure', ndir, stress(1), p)
      call check('shear 1', ndir, stress(2), t2)
      if (ndir .eq. 3) call check('shear 2', ndir, stress(3), t3)
      if (ndir .eq. 2) call check('untouched', ndir, stress(3), -99.0)
      call check('stiffness', ndir, ddsddr(1), stiff)
      call check('dissipation', ndir, sfd, dissip)
      call check('lopenclose', ndir, real(lopen), real(lclose))
      end

c Tolerance: 1e-12 of the expected value, a hundred times the round-off of the closure
      subroutine check(what, ndir, found, wanted)
      include 'aba_param.inc'
      character*(*) what
      common /counts/ npassed, nfailed
      if (abs(found - wanted) .le. 1.0e-12*abs(wanted)) then
         npassed = npassed + 1
      else
         nfailed = nfailed + 1
         print *, 'FAIL ', what, ' ndir', ndir, ':', found, wanted
      end if
      end

c The utilities that ABAQUS supplies; neither may be called here
      subroutine stdb_abqerr(lop, string, intv, realv, charv)
      include 'aba_param.inc'
      character*(*) string
      character*8 charv(*)
      dimension intv(*), realv(*)
      common /counts/ npassed, nfailed
      nfailed = nfailed + 1
      print *, 'FAIL: STDB_ABQERR ', string
      end

      subroutine xit
      stop 3
      end
