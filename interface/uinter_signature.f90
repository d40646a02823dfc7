!> The signature of UINTER, 47 arguments, for hosts that call one.
module uinter_signature
   implicit none
   private
   public :: uinter_interface

   abstract interface
      !> ABAQUS/Standard user interface law, release 6.12 to 2025.
      subroutine uinter_interface( &
         stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, &
         sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, &
         time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, drot, &
         area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, &
         linper, lopenclose, lstate, lsdi, lprint)
         use asperity_kinds, only: wp
         implicit none
         integer, intent(in) :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit
         integer, intent(in) :: linper, lprint
         real(wp), intent(inout) :: stress(ndir)
         real(wp), intent(inout) :: ddsddr(ndir, ndir), dviscous(ndir, ndir)
         real(wp), intent(inout) :: dstructural(ndir, ndir)
         real(wp), intent(inout) :: flux(2), ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir)
         real(wp), intent(inout) :: statev(nstatv)
         real(wp), intent(inout) :: sed, sfd, spd, svd, scd, pnewdt
         real(wp), intent(in) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2)
         real(wp), intent(in) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr
         character(len=80), intent(in) :: ciname, slname, msname
         real(wp), intent(in) :: props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2)
         real(wp), intent(in) :: area, chrlngth
         integer, intent(inout) :: lopenclose, lstate, lsdi
      end subroutine uinter_interface
   end interface

end module uinter_signature
