!> ABAQUS/Explicit user subroutine VUINTER for rough contact, 49 arguments: UINTER's law, PROPS and
!> STATEV for all slave nodes of a contact pair. Arguments have the precision of the run (see
!> vuinter_precision.f90); computing is in double precision. It keeps nothing between calls: no
!> SAVE, no COMMON, no I/O, so any number of threads may call it. ABAQUS/Explicit cannot repeat an
!> increment, so an error ends the job. Arguments: vuinter_signature.f90; deck, signs and slots:
!> docs/abaqus.md.
!>
!> Where there are so many slave nodes that it pays, the law is compiled in the call, for
!> separations within 8 sigma of the mean plane: results are then within 1e-10 of UINTER's. With
!> few nodes, beyond 8 sigma, and with memory they are UINTER's.
subroutine vuinter( &
   sfd, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, kstep, kinc, nfacnod, nslvnod, &
   nmstnod, nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv, jslvuid, jmstuid, &
   jconmstid, timstep, timglb, dtimcur, surfint, surfslv, surfmst, rdisp, drdisp, drot, &
   stiffdflt, conddflt, shape, coordslv, coordmst, alocaldir, props, areaslv, tempslv, dtempslv, &
   predefslv, dpredefslv, tempmst, dtempmst, predefmst, dpredefmst)
   use asperity_abaqus_checks, only: check_sizes, check_statev, computable, sizes_are_computable
   use asperity_abaqus_statev, only: most_statev, state_from_statev, state_warned, &
      statev_from_state, statev_needed
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_abaqus_vuinter_props, only: read_props
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_point, only: contact_pressure, update_contact_point
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_state, only: contact_response, contact_state, no_opposite_surface, &
      no_rotation, no_surface_limit, status_slip, status_stick
   use asperity_law_compile_law, only: compiling_pays, new_compiled_law
   use asperity_law_compiled_intervals, only: precise_reach
   use asperity_law_normal_properties, only: unloading_reversible
   use asperity_law_validity, only: validity_remark
   implicit none
   integer, intent(in) :: kstep, kinc, nfacnod, nslvnod, nmstnod
   integer, intent(in) :: nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv
   real(vp), intent(inout) :: sfd(nslvnod), scd(nslvnod), spd(nslvnod), svd(nslvnod)
   real(vp), intent(inout) :: stress(ndir, nslvnod), fluxslv(nslvnod), fluxmst(nslvnod)
   real(vp), intent(inout) :: sed(nslvnod), statev(nstatevar, nslvnod)
   integer, intent(in) :: jslvuid(nslvnod), jmstuid(nmstnod), jconmstid(nfacnod, nslvnod)
   real(vp), intent(in) :: timstep, timglb, dtimcur
   character(len=80), intent(in) :: surfint, surfslv, surfmst
   real(vp), intent(in) :: rdisp(ndir, nslvnod), drdisp(ndir, nslvnod), drot(2, 2, nslvnod)
   real(vp), intent(in) :: stiffdflt(nslvnod), conddflt(nslvnod), shape(nfacnod, nslvnod)
   real(vp), intent(in) :: coordslv(ndir, nslvnod), coordmst(ndir, nmstnod)
   real(vp), intent(in) :: alocaldir(ndir, ndir, nslvnod), props(nprops), areaslv(nslvnod)
   real(vp), intent(in) :: tempslv(nslvnod), dtempslv(nslvnod)
   real(vp), intent(in) :: predefslv(npred, nslvnod), dpredefslv(npred, nslvnod)
   real(vp), intent(in) :: tempmst(numdeftfv), dtempmst(numdeftfv)
   real(vp), intent(in) :: predefmst(npred, numdeftfv), dpredefmst(npred, numdeftfv)

   interface
      !> ABAQUS: message to the message file; lop -1 warns, -3 reports an error and stops.
      subroutine xplb_abqerr(lop, string, intv, realv, charv)
         use asperity_abaqus_vuinter_precision, only: vp
         implicit none
         integer, intent(in) :: lop
         character(len=*), intent(in) :: string
         integer, intent(in) :: intv(*)
         real(vp), intent(in) :: realv(*)
         character(len=8), intent(in) :: charv(*)
      end subroutine xplb_abqerr
      !> ABAQUS: ends the job.
      subroutine xplb_exit()
      end subroutine xplb_exit
   end interface

   integer, parameter :: warning = -1, fatal = -3
   type(contact_properties) :: properties
   type(contact_state) :: start
   type(contact_response) :: response
   type(error_type), allocatable :: error
   logical :: pressure_is_rounded
   integer :: node, slots, faulty, first_to_warn, n_to_warn, flags_to_warn

   associate (u1 => kstep, u2 => kinc, u3 => nsurfdir, u4 => ntemp, u5 => jmstuid, &
         u6 => jconmstid, u7 => timstep, u8 => timglb, u10 => surfslv, &
         u11 => surfmst, u12 => stiffdflt, u13 => conddflt, u14 => shape, u15 => coordslv, &
         u16 => coordmst, u17 => alocaldir, u18 => areaslv, u19 => tempslv, u20 => dtempslv, &
         u21 => predefslv, u22 => dpredefslv, u23 => tempmst, u24 => dtempmst, &
         u25 => predefmst, u26 => dpredefmst)
      ! arguments of the interface that the law does not need
   end associate

   faulty = 0
   call read_props(props, properties, error)
   if (allocated(error)) then
      ! nothing is written: the arrays may be half as long as they are declared here
      call tell(fatal, '', error%message)
      call xplb_exit()
      return
   end if

   slots = statev_needed(properties)
   call check_sizes(nstatevar, slots, ndir, error)
   if (.not. allocated(error)) call check_time(error)
   flags_to_warn = 0
   n_to_warn = 0
   first_to_warn = 0
   ! the dissipative rule would take the rounding of STATEV(3) for a change of pressure
   pressure_is_rounded = vp /= wp .and. properties%friction_rule == rule_dissipative
   if (.not. allocated(error)) call compile_for_nodes(error)
   if (.not. allocated(error)) then
      do node = 1, nslvnod
         call advance(node, start, response, error)
         if (.not. allocated(error)) cycle
         faulty = node
         exit
      end do
   end if

   scd = 0.0_vp
   svd = 0.0_vp
   fluxslv = 0.0_vp
   fluxmst = 0.0_vp
   if (allocated(error)) then
      if (faulty > 0) then
         call tell(fatal, ', NODE '//to_text(jslvuid(faulty)), error%message)
      else
         call tell(fatal, '', error%message)
      end if
      call xplb_exit()
      stress = 0.0_vp
      sed = 0.0_vp
      sfd = 0.0_vp
      spd = 0.0_vp
   else if (n_to_warn == 1) then
      call tell(warning, ', NODE '//to_text(jslvuid(first_to_warn)), &
         validity_remark(flags_to_warn))
   else if (n_to_warn > 1) then
      call tell(warning, ', '//to_text(n_to_warn)//' NODES, THE FIRST '// &
         to_text(jslvuid(first_to_warn)), validity_remark(flags_to_warn))
   end if

contains

   !> Compile the law for the separations of the nodes, where that takes less time than it saves.
   subroutine compile_for_nodes(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: reach, separation, range(2)
      integer :: node, n

      if (properties%normal%unloading /= unloading_reversible) return
      reach = precise_reach*properties%normal%sigma
      range = [reach, -reach]
      n = 0
      do node = 1, nslvnod
         if (.not. is_finite(real(rdisp(1, node), wp))) cycle
         separation = properties%initial_separation - real(rdisp(1, node), wp)
         if (.not. abs(separation) < reach) cycle
         n = n + 1
         range(1) = min(range(1), separation)
         range(2) = max(range(2), separation)
      end do
      if (.not. compiling_pays(n, properties%normal, range)) return
      allocate (properties%compiled)
      call new_compiled_law(properties%compiled, properties%normal, error, range)
   end subroutine compile_for_nodes

   !> Advance a node over the increment. `error` is set when it cannot be computed.
   subroutine advance(node, start, response, error)
      integer, intent(in) :: node
      !> Variables of the caller, as setting their default values at every node takes flang longer
      !> than the law
      type(contact_state), intent(inout) :: start
      type(contact_response), intent(inout) :: response
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: overclosure, slip(2), rotation(2, 2)

      call gather(node, start, overclosure, slip, rotation, error)
      if (allocated(error)) return
      call update_contact_point(properties, start, overclosure, slip, rotation, response, &
         real(dtimcur, wp))
      call scatter(node, response, error)
   end subroutine advance

   !> State and motion of a node.
   subroutine gather(node, state, overclosure, slip, rotation, error)
      integer, intent(in) :: node
      type(contact_state), intent(inout) :: state
      real(wp), intent(out) :: overclosure, slip(2), rotation(2, 2)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: kept(most_statev), moved(7)
      logical :: is_known

      overclosure = no_opposite_surface
      slip = 0.0_wp
      rotation = no_rotation
      kept(:slots) = real(statev(:slots, node), wp)
      is_known = all_finite(kept(:slots))
      if (is_known) is_known = sizes_are_computable(kept(:slots))
      if (.not. is_known) then
         call fatal_error(error, 'STATEV holds no number, or one above 1e30 in size')
         return
      end if
      call check_statev(kept(:slots), error)
      if (allocated(error)) return
      call state_from_statev(kept(:slots), state)
      if (pressure_is_rounded) call restore_pressure(state)

      if (.not. is_finite(real(rdisp(1, node), wp))) then
         call refuse_motion(node, error)
      else if (rdisp(1, node) > no_surface_limit) then
         overclosure = real(rdisp(1, node), wp)
         slip(:ndir - 1) = real(drdisp(2:, node), wp)
         if (ndir == 3) rotation = real(drot(:, :, node), wp)
         moved(1) = overclosure
         moved(2:3) = slip
         moved(4:5) = rotation(:, 1)
         moved(6:7) = rotation(:, 2)
         if (.not. computable(moved)) call refuse_motion(node, error)
      end if
   end subroutine gather

   !> The pressure of the start in all its digits, from the overclosure, which has lost none.
   subroutine restore_pressure(state)
      type(contact_state), intent(inout) :: state

      if (state%status /= status_stick .and. state%status /= status_slip) return
      state%pressure = contact_pressure(properties, state)
   end subroutine restore_pressure

   !> A time that is no number must not reach the law.
   subroutine check_time(error)
      type(error_type), allocatable, intent(out) :: error

      if (.not. computable([real(dtimcur, wp)])) call fatal_error(error, 'DTIMCUR = '// &
         to_text(real(dtimcur, wp))//' is no number or above 1e30 in size')
   end subroutine check_time

   subroutine refuse_motion(node, error)
      integer, intent(in) :: node
      type(error_type), allocatable, intent(out) :: error

      call fatal_error(error, 'RDISP(1) = '//to_text(real(rdisp(1, node), wp))// &
         ', or DRDISP or DROT, is no number or above 1e30 in size: the motion has diverged')
   end subroutine refuse_motion

   !> Results of a node, and what it has to warn of.
   subroutine scatter(node, response, error)
      integer, intent(in) :: node
      type(contact_response), intent(in) :: response
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: kept(most_statev), energy
      integer :: warned, fresh

      associate (r => response)
         warned = int(statev(state_warned, node))
         fresh = iand(r%state%validity, not(warned))
         call statev_from_state(r%state, kept(:slots))
         kept(state_warned) = ior(warned, r%state%validity)
         energy = r%normal_energy + r%tangential_energy
         ! in double precision nothing is
         if (vp /= wp) then
            if (any(abs([kept(:slots), r%traction, energy, r%dissipation, r%plastic_dissipation]) &
                  > real(huge(1.0_vp), wp))) then
               call fatal_error(error, 'pressure = '//to_text(r%state%pressure)//' or its '// &
                  'energy is beyond the precision of the run: the motion has diverged')
               return
            end if
         end if
         statev(:slots, node) = real(kept(:slots), vp)
         stress(:, node) = real(r%traction(:ndir), vp)
         sed(node) = real(energy, vp)
         sfd(node) = real(r%dissipation, vp)
         spd(node) = real(r%plastic_dissipation, vp)
      end associate
      if (fresh == 0) return
      if (n_to_warn == 0) first_to_warn = node
      n_to_warn = n_to_warn + 1
      flags_to_warn = ior(flags_to_warn, fresh)
   end subroutine scatter

   subroutine tell(lop, where, message)
      integer, intent(in) :: lop
      character(len=*), intent(in) :: where, message

      call xplb_abqerr(lop, 'ASPERITY VUINTER, INTERACTION '//trim(surfint)//where//': '// &
         message, [0], [0.0_vp], ['        '])
   end subroutine tell

end subroutine vuinter
