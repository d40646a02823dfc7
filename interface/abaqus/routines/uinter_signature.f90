!> The signature of UINTER, 47 arguments, for hosts that call one.
module asperity_abaqus_uinter_signature
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
         use asperity_base_kinds, only: wp
         implicit none
         !> Node (0 in surface-to-surface), components, lengths of arrays, step, increment,
         !> iteration (0 first)
         integer, intent(in) :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit
         !> 1 in a linear perturbation step; 1 for detailed print
         integer, intent(in) :: linper, lprint
         !> Pressure (compression positive) and shear, MPa: start of the increment, then end
         real(wp), intent(inout) :: stress(ndir)
         !> d stress(i)/d relative motion(j), MPa/mm; damping matrices
         real(wp), intent(inout) :: ddsddr(ndir, ndir), dviscous(ndir, ndir)
         real(wp), intent(inout) :: dstructural(ndir, ndir)
         !> Heat fluxes into both surfaces and their variations
         real(wp), intent(inout) :: flux(2), ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir)
         !> State variables: start of the increment, then end
         real(wp), intent(inout) :: statev(nstatv)
         !> Per area, N/mm: stored energy, total; frictional, plastic, viscous and creep
         !> dissipation of the increment. Below 1, PNEWDT asks for a shorter increment
         real(wp), intent(inout) :: sed, sfd, spd, svd, scd, pnewdt
         !> Relative position at the end, overclosure positive, and its increment, mm; temperatures
         real(wp), intent(in) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2)
         !> Field variables; step and total time at the end, increment, s; frequency ratio
         real(wp), intent(in) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr
         !> Names of the interaction and of both surfaces
         character(len=80), intent(in) :: ciname, slname, msname
         !> Properties; position; local axes; rotation of the slip directions
         real(wp), intent(in) :: props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2)
         !> Area and length of the point, mm^2, mm
         real(wp), intent(in) :: area, chrlngth
         !> 0 open, 1 closed; user's status; 1 asks for another iteration
         integer, intent(inout) :: lopenclose, lstate, lsdi
      end subroutine uinter_interface
   end interface

end module asperity_abaqus_uinter_signature
