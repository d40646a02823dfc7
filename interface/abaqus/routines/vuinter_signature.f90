!> The signature of VUINTER, 49 arguments, for hosts that call one.
module asperity_abaqus_vuinter_signature
   implicit none
   private
   public :: vuinter_interface

   abstract interface
      !> ABAQUS/Explicit user interface law for contact pairs: all slave nodes of a pair at once.
      !> Energies come in another order than UINTER's.
      subroutine vuinter_interface( &
         sfd, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, kstep, kinc, nfacnod, &
         nslvnod, nmstnod, nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv, jslvuid, &
         jmstuid, jconmstid, timstep, timglb, dtimcur, surfint, surfslv, surfmst, rdisp, drdisp, &
         drot, stiffdflt, conddflt, shape, coordslv, coordmst, alocaldir, props, areaslv, &
         tempslv, dtempslv, predefslv, dpredefslv, tempmst, dtempmst, predefmst, dpredefmst)
         use asperity_abaqus_vuinter_precision, only: vp
         implicit none
         !> Step; increment; nodes of a master facet, slave nodes, master nodes
         integer, intent(in) :: kstep, kinc, nfacnod, nslvnod, nmstnod
         !> Directions of the surfaces; components, 2 or 3; lengths of STATEV and PROPS; 1 when
         !> temperatures are given; field variables; points of the master surface that have any
         integer, intent(in) :: nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv
         !> Per area, N/mm: frictional, creep, plastic and viscous dissipation of the increment
         real(vp), intent(inout) :: sfd(nslvnod), scd(nslvnod), spd(nslvnod), svd(nslvnod)
         !> Pressure (compression positive) and shear, MPa: start of the increment, then end
         real(vp), intent(inout) :: stress(ndir, nslvnod)
         !> Heat fluxes into both surfaces
         real(vp), intent(inout) :: fluxslv(nslvnod), fluxmst(nslvnod)
         !> Stored energy per area, total, N/mm; state variables: start of the increment, then end
         real(vp), intent(inout) :: sed(nslvnod), statev(nstatevar, nslvnod)
         !> Numbers of the slave and master nodes; nodes of the facet opposite each slave node
         integer, intent(in) :: jslvuid(nslvnod), jmstuid(nmstnod), jconmstid(nfacnod, nslvnod)
         !> Step time, total time, length of the increment, s
         real(vp), intent(in) :: timstep, timglb, dtimcur
         !> Names of the interaction, slave surface and master surface
         character(len=80), intent(in) :: surfint, surfslv, surfmst
         !> Relative position at the end, overclosure positive, and its increment, mm
         real(vp), intent(in) :: rdisp(ndir, nslvnod), drdisp(ndir, nslvnod)
         !> Rotation of the two slip directions about the normal in the increment; without meaning
         !> in two dimensions
         real(vp), intent(in) :: drot(2, 2, nslvnod)
         !> Stiffness and conductance that ABAQUS would use by default
         real(vp), intent(in) :: stiffdflt(nslvnod), conddflt(nslvnod)
         !> Shape functions of the facet; positions, mm; local axes; properties
         real(vp), intent(in) :: shape(nfacnod, nslvnod), coordslv(ndir, nslvnod)
         real(vp), intent(in) :: coordmst(ndir, nmstnod), alocaldir(ndir, ndir, nslvnod)
         real(vp), intent(in) :: props(nprops)
         !> Area of a slave node, mm^2; temperatures and field variables with their increments
         real(vp), intent(in) :: areaslv(nslvnod), tempslv(nslvnod), dtempslv(nslvnod)
         real(vp), intent(in) :: predefslv(npred, nslvnod), dpredefslv(npred, nslvnod)
         real(vp), intent(in) :: tempmst(numdeftfv), dtempmst(numdeftfv)
         real(vp), intent(in) :: predefmst(npred, numdeftfv), dpredefmst(npred, numdeftfv)
      end subroutine vuinter_interface
   end interface

end module asperity_abaqus_vuinter_signature
