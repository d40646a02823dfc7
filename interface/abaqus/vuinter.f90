!> ABAQUS/Explicit user subroutine VUINTER for rough contact, 49 arguments: UINTER's law, PROPS and
!> STATEV for all slave nodes of a contact pair. Arguments have the precision of the run (see
!> vuinter_precision.f90); computing is in double precision. It keeps nothing between calls: no
!> SAVE, no COMMON, no I/O, so any number of threads may call it. ABAQUS/Explicit cannot repeat an
!> increment, so an error ends the job. Arguments: vuinter_signature.f90; deck, signs and slots:
!> docs/abaqus.md.
!>
!> The law is evaluated directly. A law compiled in each call would serve many slave nodes faster,
!> but to its own 1e-10 only, and VUINTER is to agree with UINTER to round-off.
subroutine vuinter( &
   sfd, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, kstep, kinc, nfacnod, nslvnod, &
   nmstnod, nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv, jslvuid, jmstuid, &
   jconmstid, timstep, timglb, dtimcur, surfint, surfslv, surfmst, rdisp, drdisp, drot, &
   stiffdflt, conddflt, shape, coordslv, coordmst, alocaldir, props, areaslv, tempslv, dtempslv, &
   predefslv, dpredefslv, tempmst, dtempmst, predefmst, dpredefmst)
   use asperity_abaqus_checks, only: check_sizes, check_statev, computable
   use asperity_abaqus_props_and_statev, only: n_statev, state_elastic_slip_2, state_from_statev, &
      state_pressure, state_warned, statev_from_state
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_abaqus_vuinter_props, only: read_props
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_point, only: contact_pressure
   use asperity_contact_points, only: contact_states, get_contact_state, new_contact_states, &
      set_contact_state, update_contact_points
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_state, only: contact_state, no_opposite_surface, no_rotation, &
      no_surface_limit, status_slip, status_stick
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

   !> Nodes that are worked on at a time, so that work arrays stay on the stack and in the cache
   integer, parameter :: block = 128
   integer, parameter :: warning = -1, fatal = -3
   type(contact_properties) :: properties
   type(error_type), allocatable :: error
   logical :: pressure_is_rounded
   integer :: first, faulty, first_to_warn, n_to_warn, flags_to_warn

   associate (u1 => kstep, u2 => kinc, u3 => nsurfdir, u4 => ntemp, u5 => jmstuid, &
         u6 => jconmstid, u7 => timstep, u8 => timglb, u9 => dtimcur, u10 => surfslv, &
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

   call check_sizes(nstatevar, ndir, error)
   flags_to_warn = 0
   n_to_warn = 0
   first_to_warn = 0
   ! the dissipative rule would take the rounding of STATEV(3) for a change of pressure
   pressure_is_rounded = vp /= wp .and. properties%friction_rule == rule_dissipative
   do first = 1, nslvnod, block
      if (allocated(error)) exit
      call advance(first, min(block, nslvnod - first + 1), error)
   end do

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

   !> Advance `n` nodes from the one before `first` on. `error` is set, with `faulty` the node,
   !> when one cannot be computed.
   subroutine advance(first, n, error)
      integer, intent(in) :: first, n
      type(error_type), allocatable, intent(out) :: error
      type(contact_states) :: states
      real(wp) :: overclosure(n), slip(n, 2), rotation(n, 2, 2)
      real(wp) :: traction(n, 3), tangential_energy(n), dissipation(n), plastic_dissipation(n)
      integer :: i

      call new_contact_states(states, n, error)
      do i = 1, n
         faulty = first + i - 1
         call gather(faulty, states, i, overclosure(i), slip(i, :), rotation(i, :, :), error)
         if (allocated(error)) return
      end do
      faulty = 0
      call update_contact_points(properties, states, overclosure, slip, traction, error, &
         rotation, tangential_energy=tangential_energy, dissipation=dissipation, &
         plastic_dissipation=plastic_dissipation)
      if (allocated(error)) return
      do i = 1, n
         faulty = first + i - 1
         call scatter(faulty, get_contact_state(states, i), traction(i, :), &
            states%normal_energy(i) + tangential_energy(i), dissipation(i), &
            plastic_dissipation(i), error)
         if (allocated(error)) return
      end do
      faulty = 0
   end subroutine advance

   !> State and motion of a node.
   subroutine gather(node, states, i, overclosure, slip, rotation, error)
      integer, intent(in) :: node, i
      type(contact_states), intent(inout) :: states
      real(wp), intent(out) :: overclosure, slip(2), rotation(2, 2)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: slots(n_statev)
      type(contact_state) :: state

      overclosure = no_opposite_surface
      slip = 0.0_wp
      rotation = no_rotation
      slots = real(statev(:n_statev, node), wp)
      if (.not. (all_finite(slots) &
         .and. computable(slots(state_pressure:state_elastic_slip_2)))) then
         call fatal_error(error, 'STATEV holds no number, or one above 1e30 in size')
         return
      end if
      call check_statev(slots, error)
      if (allocated(error)) return
      state = state_from_statev(slots)
      if (pressure_is_rounded) call restore_pressure(state)
      call set_contact_state(states, i, state)

      if (.not. is_finite(real(rdisp(1, node), wp))) then
         call refuse_motion(node, error)
      else if (rdisp(1, node) > no_surface_limit) then
         overclosure = real(rdisp(1, node), wp)
         slip(:ndir - 1) = real(drdisp(2:, node), wp)
         if (ndir == 3) rotation = real(drot(:, :, node), wp)
         if (.not. computable([overclosure, slip, rotation(:, 1), rotation(:, 2)])) &
            call refuse_motion(node, error)
      end if
   end subroutine gather

   !> The pressure of the start in all its digits, from the overclosure, which has lost none.
   subroutine restore_pressure(state)
      type(contact_state), intent(inout) :: state

      if (state%status /= status_stick .and. state%status /= status_slip) return
      state%pressure = contact_pressure(properties, state)
   end subroutine restore_pressure

   subroutine refuse_motion(node, error)
      integer, intent(in) :: node
      type(error_type), allocatable, intent(out) :: error

      call fatal_error(error, 'RDISP(1) = '//to_text(real(rdisp(1, node), wp))// &
         ', or DRDISP or DROT, is no number or above 1e30 in size: the motion has diverged')
   end subroutine refuse_motion

   !> Results of a node, and what it has to warn of.
   subroutine scatter(node, state, traction, energy, dissipated, flattened, error)
      integer, intent(in) :: node
      type(contact_state), intent(in) :: state
      real(wp), intent(in) :: traction(3), energy, dissipated, flattened
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: slots(n_statev)
      integer :: warned, fresh

      slots = 0.0_wp
      warned = nint(statev(state_warned, node))
      fresh = iand(state%validity, not(warned))
      call statev_from_state(state, slots)
      slots(state_warned) = ior(warned, state%validity)
      if (any(abs([slots, traction, energy, dissipated, flattened]) > real(huge(1.0_vp), wp))) then
         call fatal_error(error, 'pressure = '//to_text(state%pressure)//' or its energy is '// &
            'beyond the precision of the run: the motion has diverged')
         return
      end if
      statev(:n_statev, node) = real(slots, vp)
      stress(:, node) = real(traction(:ndir), vp)
      sed(node) = real(energy, vp)
      sfd(node) = real(dissipated, vp)
      spd(node) = real(flattened, vp)
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
