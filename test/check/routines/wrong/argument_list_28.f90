! check: --properties 100 --nstatv 1
! finds: argument_list error
! A list that no release has
subroutine uinter(stress, ddsddr, statev, sed, sfd, spd, pnewdt, rdisp, drdisp, temp, dtemp, &
   predef, dpred, time, dtime, ciname, slname, msname, props, nprops, coords, node, ndir, nstatv, &
   kstep, kinc, kit, lopenclose)
   implicit none
   integer :: nprops, node, ndir, nstatv, kstep, kinc, kit, lopenclose
   double precision :: stress(ndir), ddsddr(ndir, ndir), statev(nstatv), sed, sfd, spd, pnewdt
   double precision :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2), predef(2, 1), dpred(2, 1)
   double precision :: time(2), dtime, props(nprops), coords(ndir)
   character(len=80) :: ciname, slname, msname

   stress = 0.0d0
   ddsddr = 0.0d0
   ddsddr(1, 1) = props(1)
   stress(1) = props(1)*max(rdisp(1), 0.0d0)
   sed = 0.0d0
   sfd = 0.0d0
   spd = 0.0d0
end subroutine uinter
