!> ABAQUS/Standard user subroutine UINTER for rough contact, the 47 arguments of release 6.12 to
!> 2025. It reads PROPS and STATEV (see props.f90, statev.f90), calls the contact-point
!> update and writes every output. It keeps nothing between calls: no SAVE, no COMMON, no I/O, so
!> any number of threads may call it. Arguments: uinter_signature.f90; deck, signs and slots:
!> docs/abaqus.md.
subroutine uinter( &
   stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, &
   svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, &
   slname, msname, props, coords, alocaldir, drot, area, chrlngth, node, ndir, nstatv, npred, &
   nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint)
   use asperity_abaqus_checks, only: check_sizes, check_statev, computable, sizes_are_computable
   use asperity_abaqus_props, only: properties_from_props
   use asperity_abaqus_statev, only: state_from_statev, state_validity, state_warned, &
      statev_from_state, statev_needed
   use asperity_abaqus_uinter_point, only: uinter_point
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_point, only: contact_tangent, update_contact_point
   use asperity_contact_state, only: no_opposite_surface, no_rotation, no_surface_limit, status_open
   use asperity_law_validity, only: validity_remark
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

   interface
      !> ABAQUS: message to the message file; lop -1 warns, -3 reports an error and stops.
      subroutine stdb_abqerr(lop, string, intv, realv, charv)
         use asperity_base_kinds, only: wp
         implicit none
         integer, intent(in) :: lop
         character(len=*), intent(in) :: string
         integer, intent(in) :: intv(*)
         real(wp), intent(in) :: realv(*)
         character(len=8), intent(in) :: charv(*)
      end subroutine stdb_abqerr
      !> ABAQUS: ends the job.
      subroutine xit()
      end subroutine xit
   end interface

   !> Time step factor asked for when the host's numbers are not finite
   real(wp), parameter :: cut_back = 0.25_wp
   integer, parameter :: warning = -1, fatal = -3
   type(uinter_point) :: point
   type(error_type), allocatable :: error
   real(wp) :: slip(2), rotation(2, 2), overclosure, moved(8), tangent(3, 3)
   !> Slots of STATEV that the properties need
   integer :: slots
   !> Whether STATEV and the position are numbers that can be computed with
   logical :: known

   associate (u1 => temp, u2 => dtemp, u3 => predef, u4 => dpred, u5 => time, u7 => freqr, &
         u8 => coords, u9 => alocaldir, u10 => area, u11 => chrlngth, &
         u12 => slname, u13 => msname, u14 => kstep, u15 => kinc, u16 => lsdi, u17 => lprint)
      ! arguments of the interface that the law does not need
   end associate

   call clear(ndir*ndir, dviscous)
   call clear(ndir*ndir, dstructural)
   call clear(2*ndir, ddsddt)
   call clear(2*ndir, ddfddr)
   flux = 0.0_wp
   ddfddt = 0.0_wp
   sfd = 0.0_wp
   spd = 0.0_wp
   svd = 0.0_wp
   scd = 0.0_wp

   call properties_from_props(props, point%properties, error)
   if (.not. allocated(error)) call check_state(error)
   if (allocated(error)) then
      call tell(fatal, error%message)
      call xit()
      stress = 0.0_wp
      ddsddr = 0.0_wp
      sed = 0.0_wp
      return
   end if

   if (known) known = is_finite(rdisp(1)) .and. sizes_are_computable(statev(:slots))
   if (.not. known) then
      ddsddr = 0.0_wp
      pnewdt = cut_back
      return
   end if
   call state_from_statev(statev(:slots), point%start)

   if (linper == 1) then
      tangent = contact_tangent(point%properties, point%start)
      ddsddr = tangent(:ndir, :ndir)
      stress = 0.0_wp
      if (rdisp(1) < no_surface_limit) return
      if (computable(rdisp)) then
         stress = matmul(ddsddr, rdisp)
      else
         pnewdt = cut_back
      end if
      return
   end if

   slip = 0.0_wp
   rotation = no_rotation
   overclosure = no_opposite_surface
   if (rdisp(1) > no_surface_limit) then
      overclosure = rdisp(1)
      slip(:ndir - 1) = drdisp(2:)
      if (ndir == 3) rotation = drot
      moved(1) = overclosure
      moved(2:3) = slip
      moved(4:5) = rotation(:, 1)
      moved(6:7) = rotation(:, 2)
      moved(8) = dtime
      if (.not. computable(moved)) then
         ddsddr = 0.0_wp
         pnewdt = cut_back
         return
      end if
   end if

   associate (response => point%response)
      call update_contact_point(point%properties, point%start, overclosure, slip, rotation, &
         response, dtime)
      stress = response%traction(:ndir)
      ddsddr = response%tangent(:ndir, :ndir)
      sed = response%normal_energy + response%tangential_energy
      sfd = response%dissipation
      spd = response%plastic_dissipation
      lopenclose = merge(0, 1, response%status == status_open)
      lstate = response%status
      call warn_once(response%validity)
      call statev_from_state(response%state, statev(:slots))
   end associate

contains

   !> Zero in one run, without a loop over columns.
   pure subroutine clear(n, values)
      integer, intent(in) :: n
      real(wp), intent(out) :: values(n)

      values = 0.0_wp
   end subroutine clear

   !> Refuse what would be read or written out of bounds, and a STATEV that is not ours.
   subroutine check_state(error)
      type(error_type), allocatable, intent(out) :: error

      slots = statev_needed(point%properties)
      call check_sizes(nstatv, slots, ndir, error)
      if (allocated(error)) return
      ! not finite is no error of the deck: the increment is cut
      known = all_finite(statev(:slots))
      if (known) call check_statev(statev(:slots), error)
   end subroutine check_state

   !> Warn, in the first iteration of an increment, of flags not yet warned of at this point:
   !> those of this trial, and those that came up in a later iteration of an earlier increment.
   subroutine warn_once(validity)
      integer, intent(in) :: validity
      integer :: reached, warned, fresh

      reached = int(statev(state_validity))
      warned = int(statev(state_warned))
      if (kit == 0) then
         fresh = iand(ior(validity, reached), not(warned))
         if (fresh /= 0) call tell(warning, validity_remark(fresh))
         warned = ior(warned, fresh)
      end if
      statev(state_warned) = ior(warned, reached)
   end subroutine warn_once

   subroutine tell(lop, message)
      integer, intent(in) :: lop
      character(len=*), intent(in) :: message

      call stdb_abqerr(lop, 'ASPERITY UINTER, INTERACTION '//trim(ciname)//', NODE '// &
         to_text(node)//': '//message, [0], [0.0_wp], ['        '])
   end subroutine tell

end subroutine uinter
