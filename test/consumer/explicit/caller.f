c A caller as ABAQUS/Explicit would be: fixed form, everything typed implicitly, no interface of
c VUINTER in sight. In single precision as it stands, in double with -fdefault-real-8. Its numbers
c are those of the first pair at h = 2.532, where normal_law_reference.csv holds the pressure to 30
c digits. Node 1 sticks, node 2 slips, node 3 has no opposite surface.
      program caller
      include 'vaba_param.inc'
      parameter (n=3)
      dimension props(9), statev(11*n), stress(3*n), sfd(n), scd(n),
     1   spd(n), svd(n), sed(n), fslv(n), fmst(n)
      common /counts/ npassed, nfailed
      data props /0.5, 0.31, 206.0, 297.0, 3.14159265358979, 0.1477,
     1   24.53, 0.4, 0.0593/
      npassed = 0
      nfailed = 0
c datum: d0 = 4 sigma, as props(10) is left out
      closure = 4.0*0.0593 - 0.1501476
      p = 0.33732782403076127

      do ndir = 2, 3
         statev = 0.0
         do kinc = 1, 2
            stress = -99.0
            call push(ndir, n, kinc, closure, props, statev, stress,
     1         sfd, scd, spd, svd, sed, fslv, fmst)
c           0.15 mm of elastic slip an increment at node 1; (0.6, 0.8) mm of slip at node 2
            gamma = 0.15*kinc
            t = 0.5*p*gamma/0.31
            call check('pressure 1', ndir, stress(1), p)
            call check('shear 1', ndir, stress(2), t)
            call check('dissipation 1', ndir, sfd(1), 0.0)
            call check('pressure 2', ndir, stress(ndir+1), p)
            if (ndir .eq. 2) then
               call check('shear 2', ndir, stress(ndir+2), 0.5*p)
               slide = 0.6
            else
               call check('shear 2', ndir, stress(ndir+2), 0.3*p)
               call check('shear 2', ndir, stress(ndir+3), 0.4*p)
               slide = 1.0
            end if
            if (kinc .eq. 1) slide = slide - 0.31
            call check('dissipation 2', ndir, sfd(2), 0.5*p*slide)
            call check('pressure 3', ndir, stress(2*ndir+1), 0.0)
            call check('shear 3', ndir, stress(2*ndir+2), 0.0)
            call check('energy 3', ndir, sed(3), 0.0)
            if (ndir .eq. 2) call check('untouched', ndir, stress(7),
     1         -99.0)
            call check('energy of slip', ndir, sed(2) - sed(1),
     1         0.5*0.5*p*(0.31 - gamma*gamma/0.31))
         end do
         call check('status 1', ndir, statev(1), 2.0)
         call check('status 2', ndir, statev(12), 3.0)
         call check('status 3', ndir, statev(23), 1.0)
         call check('others', ndir, sum(scd) + sum(spd) + sum(svd) +
     1      sum(fslv) + sum(fmst), 0.0)
      end do
      print '(i0, a, i0, a)', npassed, ' passed, ', nfailed, ' failed'
      if (nfailed .gt. 0) stop 1
      end

c One increment
      subroutine push(ndir, n, kinc, closure, props, statev, stress,
     1   sfd, scd, spd, svd, sed, fslv, fmst)
      include 'vaba_param.inc'
      dimension props(9), statev(11,n), stress(ndir,n), sfd(n), scd(n),
     1   spd(n), svd(n), sed(n), fslv(n), fmst(n), rdisp(ndir,n),
     2   drdisp(ndir,n), drot(2,2,n), stiff(n), cond(n), shape(4,n),
     3   cslv(ndir,n), cmst(ndir,5), aloc(ndir,ndir,n), area(n),
     4   tslv(n), dtslv(n), pslv(1,n), dpslv(1,n), tmst(n), dtmst(n),
     5   pmst(1,n), dpmst(1,n), jslv(n), jmst(5), jcon(4,n)
      character*80 surfi, surfs, surfm
      surfi = 'WOOD'
      surfs = 'LOWER'
      surfm = 'UPPER'
      rdisp = 0.0
      drdisp = 0.0
      drot = 0.0
      drot(1,1,:) = 1.0
      drot(2,2,:) = 1.0
      rdisp(1,1) = closure
      rdisp(1,2) = closure
      rdisp(1,3) = -1.0e36
      drdisp(2,1) = 0.15
      drdisp(2,2) = 0.6
      drdisp(2,3) = 0.6
      if (ndir .eq. 3) drdisp(3,2) = 0.8
      rdisp(2:,:) = kinc*drdisp(2:,:)
      sfd = -99.0
      scd = -99.0
      spd = -99.0
      svd = -99.0
      fslv = -99.0
      fmst = -99.0
      if (kinc .eq. 1) sed = 0.0
      stiff = 0.0
      cond = 0.0
      shape = 0.25
      cslv = 0.0
      cmst = 0.0
      aloc = 0.0
      area = 1.0
      tslv = 0.0
      dtslv = 0.0
      pslv = 0.0
      dpslv = 0.0
      tmst = 0.0
      dtmst = 0.0
      pmst = 0.0
      dpmst = 0.0
      do i = 1, n
         jslv(i) = 100 + i
      end do
      jmst = 0
      jcon = 1
      t = 0.1*kinc
      dt = 0.1
      call vuinter(sfd, scd, spd, svd, stress, fslv, fmst, sed, statev,
     1   1, kinc, 4, n, 5, ndir, ndir, 11, 9, 1, 1, n, jslv, jmst, jcon,
     2   t, t, dt, surfi, surfs, surfm, rdisp, drdisp, drot, stiff,
     3   cond, shape, cslv, cmst, aloc, props, area, tslv, dtslv, pslv,
     4   dpslv, tmst, dtmst, pmst, dpmst)
      end

c Tolerance: a hundred roundings of the closure, and not below the law's own 1e-12
      subroutine check(what, ndir, found, wanted)
      include 'vaba_param.inc'
      character*(*) what
      common /counts/ npassed, nfailed
      tol = max(1.0e-12, 100.0*epsilon(1.0))
      if (abs(found - wanted) .le. tol*abs(wanted)) then
         npassed = npassed + 1
      else
         nfailed = nfailed + 1
         print *, 'FAIL ', what, ' ndir', ndir, ':', found, wanted
      end if
      end

c The utilities that ABAQUS supplies; neither may be called here
      subroutine xplb_abqerr(lop, string, intv, realv, charv)
      include 'vaba_param.inc'
      character*(*) string
      character*8 charv(*)
      dimension intv(*), realv(*)
      common /counts/ npassed, nfailed
      nfailed = nfailed + 1
      print '(2a)', 'FAIL: XPLB_ABQERR ', string
      end

      subroutine xplb_exit
      stop 3
      end
