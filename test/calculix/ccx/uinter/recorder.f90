!> A UINTER for tests of its host: a plain law, a request for shorter increments, and a record of
!> every argument of every call in `uinter.log`. For one thread. PROPS:
!>    1  initial pressure p0, MPa; p = p0 exp(overclosure/length), or p0/length*overclosure
!>    2  length, mm
!>    3  1 exponential, 0 linear and closed from zero overclosure
!>    4  friction coefficient
!>    5  stick slope, MPa/mm
!>    6  total time after which increments are asked to be shorter, 0 for never
!>    7  than this
!>    8  by this factor
!>    9  1 records
!> STATEV: increments with a surface opposite, elastic slip (2), sum of their lengths, unused.
subroutine uinter( &
   stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, &
   svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, &
   slname, msname, props, coords, alocaldir, drot, area, chrlngth, node, ndir, nstatv, npred, &
   nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint)
   use, intrinsic :: iso_fortran_env, only: wp => real64
   implicit none
   integer, intent(in) :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit
   integer, intent(in) :: linper, lprint
   real(wp), intent(inout) :: stress(ndir)
   real(wp), intent(inout) :: ddsddr(ndir, ndir), dviscous(ndir, ndir), dstructural(ndir, ndir)
   real(wp), intent(inout) :: flux(2), ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir)
   real(wp), intent(inout) :: statev(nstatv)
   real(wp), intent(inout) :: sed, sfd, spd, svd, scd, pnewdt
   real(wp), intent(in) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2)
   real(wp), intent(in) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr
   character(len=80), intent(in) :: ciname, slname, msname
   real(wp), intent(in) :: props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2)
   real(wp), intent(in) :: area, chrlngth
   integer, intent(inout) :: lopenclose, lstate, lsdi
   !> Nothing lies opposite
   real(wp), parameter :: no_surface = -1.0e35_wp
   real(wp) :: pressure, slope, slip(2), limit

   if (props(9) > 0.5_wp) call record_entry()

   slip = 0.0_wp
   pressure = 0.0_wp
   slope = 0.0_wp
   ddsddr = 0.0_wp
   stress = 0.0_wp
   if (rdisp(1) > no_surface) then
      if (props(3) > 0.5_wp) then
         pressure = props(1)*exp(rdisp(1)/props(2))
         slope = pressure/props(2)
      else if (rdisp(1) > 0.0_wp) then
         slope = props(1)/props(2)
         pressure = slope*rdisp(1)
      end if
      slip = matmul(drot, statev(2:3)) + drdisp(2:3)
      ddsddr(1, 1) = slope
      limit = props(4)*pressure
      stress(1) = pressure
      if (props(5)*norm2(slip) <= limit) then
         stress(2:3) = props(5)*slip
         ddsddr(2, 2) = props(5)
         ddsddr(3, 3) = props(5)
      else
         associate (direction => slip/norm2(slip), ratio => limit/norm2(slip))
            stress(2:3) = limit*direction
            ddsddr(2:3, 1) = props(4)*slope*direction
            ddsddr(2, 2) = ratio*(1.0_wp - direction(1)**2)
            ddsddr(3, 3) = ratio*(1.0_wp - direction(2)**2)
            ddsddr(2, 3) = -ratio*direction(1)*direction(2)
            ddsddr(3, 2) = ddsddr(2, 3)
            slip = limit/props(5)*direction
         end associate
      end if
      statev(1) = statev(1) + 1.0_wp
      statev(2:3) = slip
      statev(4) = statev(4) + dtime
   end if
   sed = sed + 1.0_wp
   sfd = 0.25_wp
   lopenclose = merge(1, 0, pressure > 0.0_wp)
   lstate = 100*kstep + kinc
   if (props(6) > 0.0_wp .and. time(2) > props(6) .and. dtime > props(7)) then
      ! a state that must not survive
      pnewdt = props(8)
      statev = -1.0e3_wp
   end if
   if (props(9) > 0.5_wp) call record_exit()

contains

   !> What came in.
   subroutine record_entry()
      integer :: unit

      open (newunit=unit, file='uinter.log', position='append', action='write')
      write (unit, '(a)') 'CALL'
      call integers(unit, 'NODE', [node])
      call integers(unit, 'SIZES', [ndir, nstatv, npred, nprops, mcrd])
      call integers(unit, 'COUNTERS', [kstep, kinc, kit])
      call integers(unit, 'FLAGS', [linper, lopenclose, lstate, lsdi, lprint])
      call reals(unit, 'STRESS', stress)
      call reals(unit, 'STATEV', statev)
      call reals(unit, 'ENERGIES', [sed, sfd, spd, svd, scd])
      call reals(unit, 'PNEWDT', [pnewdt])
      call reals(unit, 'RDISP', rdisp)
      call reals(unit, 'DRDISP', drdisp)
      call reals(unit, 'TEMP', [temp, dtemp])
      call reals(unit, 'PREDEF', [reshape(predef, [2*npred]), reshape(dpred, [2*npred])])
      call reals(unit, 'TIME', [time, dtime, freqr])
      call reals(unit, 'PROPS', props)
      call reals(unit, 'COORDS', coords)
      call reals(unit, 'ALOCALDIR', reshape(alocaldir, [9]))
      call reals(unit, 'DROT', reshape(drot, [4]))
      call reals(unit, 'AREA', [area, chrlngth])
      call reals(unit, 'ZEROS', [reshape(dviscous, [ndir**2]), &
         reshape(dstructural, [ndir**2]), flux, reshape(ddfddt, [4]), reshape(ddsddt, [2*ndir]), &
         reshape(ddfddr, [2*ndir])])
      write (unit, '(4a)') 'NAMES', '|'//ciname, '|'//slname, '|'//msname
      close (unit)
   end subroutine record_entry

   !> What goes out.
   subroutine record_exit()
      integer :: unit

      open (newunit=unit, file='uinter.log', position='append', action='write')
      call reals(unit, 'OUT_STRESS', stress)
      call reals(unit, 'OUT_STATEV', statev)
      call reals(unit, 'OUT_SED', [sed])
      call reals(unit, 'OUT_PNEWDT', [pnewdt])
      call integers(unit, 'OUT_FLAGS', [lopenclose, lstate])
      close (unit)
   end subroutine record_exit

   subroutine integers(unit, name, values)
      integer, intent(in) :: unit, values(:)
      character(len=*), intent(in) :: name

      write (unit, '(a, *(1x, i0))') name, values
   end subroutine integers

   subroutine reals(unit, name, values)
      integer, intent(in) :: unit
      real(wp), intent(in) :: values(:)
      character(len=*), intent(in) :: name

      write (unit, '(a, *(1x, es25.16e3))') name, values
   end subroutine reals

end subroutine uinter
