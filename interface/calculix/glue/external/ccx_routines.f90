!> Routines of CalculiX that the linker replaces by these. Their own are still there, with `ccx_`
!> before the name, and serve what is none of ours. Argument lists are CalculiX'; only what is
!> used is described.

!> Internal forces of a spring.
subroutine springforc_n2f(xl, konl, vl, imat, elcon, nelcon, elas, fnl, ncmat_, ntmat_, nope, &
   lakonl, t1l, kode, elconloc, plicon, nplicon, npmat_, senergy, nener, cstr, mi, springarea, &
   nmethod, ne0, nstate_, xstateini, xstate, reltime, ielas, venergy, ielorien, orab, norien, &
   nelem, smscale, mscalmethod)
   use asperity_base_kinds, only: wp
   use asperity_calculix_interactions, only: find_interaction, interaction_type
   use asperity_calculix_spring_state, only: slot_slip
   use asperity_calculix_springs, only: evaluate_spring, fill_spring, response_type, &
      spring_force, spring_type
   implicit none
   character(len=8) :: lakonl
   integer :: konl(*), imat, nelcon(2, *), ncmat_, ntmat_, nope, kode, npmat_, nener, mi(*)
   integer :: nplicon(0:ntmat_, *), nmethod, ne0, nstate_, ielas, norien, nelem, mscalmethod
   integer :: ielorien(mi(3), *)
   real(wp) :: xl(3, *), vl(0:mi(2), *), elcon(0:ncmat_, ntmat_, *), elas(*), fnl(3, *), t1l
   real(wp) :: elconloc(*), plicon(0:2*npmat_, ntmat_, *), senergy, cstr(6), springarea(2)
   real(wp) :: xstateini(nstate_*mi(1), *), xstate(nstate_*mi(1), *), reltime, venergy
   real(wp) :: orab(7, *), smscale(*)
   external :: ccx_springforc_n2f
   type(interaction_type), pointer :: interaction
   type(spring_type) :: spring
   type(response_type) :: response
   integer :: slot

   interaction => null()
   if (lakonl(7:7) == 'C') interaction => find_interaction(imat)
   if (.not. associated(interaction)) then
      call ccx_springforc_n2f(xl, konl, vl, imat, elcon, nelcon, elas, fnl, ncmat_, ntmat_, nope, &
         lakonl, t1l, kode, elconloc, plicon, nplicon, npmat_, senergy, nener, cstr, mi, &
         springarea, nmethod, ne0, nstate_, xstateini, xstate, reltime, ielas, venergy, &
         ielorien, orab, norien, nelem, smscale, mscalmethod)
      return
   end if
   call fill_spring(spring, interaction, xl(:, :nope), vl(:, :nope), konl(:nope + 1), &
      springarea(1), nmethod)
   slot = ne0 + konl(nope + 1)
   call evaluate_spring(spring, xstateini(:, slot), xstate(:, slot), response)
   fnl(:, :nope) = spring_force(response, springarea(1))
   associate (motion => response%motion)
      cstr = [-motion%overclosure, xstate(slot_slip:slot_slip + 1, slot), response%stress]
   end associate
   if (nener == 1) then
      senergy = springarea(1)*response%energy
      venergy = springarea(1)*response%dissipation
   end if
end subroutine springforc_n2f

!> Stiffness of a spring.
subroutine springstiff_n2f(xl, elas, konl, voldl, s, imat, elcon, nelcon, ncmat_, ntmat_, nope, &
   lakonl, t1l, kode, elconloc, plicon, nplicon, npmat_, iperturb, springarea, nmethod, mi, ne0, &
   nstate_, xstateini, xstate, reltime, nasym, ielorien, orab, norien, nelem)
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: host
   use asperity_calculix_interactions, only: find_interaction, interaction_type
   use asperity_calculix_springs, only: evaluate_spring, fill_spring, response_type, &
      spring_stiffness, spring_type
   implicit none
   character(len=8) :: lakonl
   integer :: konl(*), imat, nelcon(2, *), ncmat_, ntmat_, nope, kode, npmat_, mi(*)
   integer :: nplicon(0:ntmat_, *), iperturb(*), nmethod, ne0, nstate_, nasym, norien, nelem
   integer :: ielorien(mi(3), *)
   real(wp) :: xl(3, *), voldl(0:mi(2), *), elcon(0:ncmat_, ntmat_, *), elas(*), s(60, 60), t1l
   real(wp) :: elconloc(*), plicon(0:2*npmat_, ntmat_, *), springarea(2), reltime, orab(7, *)
   real(wp) :: xstateini(nstate_*mi(1), *), xstate(nstate_*mi(1), *)
   external :: ccx_springstiff_n2f
   type(interaction_type), pointer :: interaction
   type(spring_type) :: spring
   type(response_type) :: response
   real(wp) :: state(nstate_*mi(1))
   integer :: n

   interaction => null()
   if (lakonl(7:7) == 'C') interaction => find_interaction(imat)
   if (.not. associated(interaction)) then
      call ccx_springstiff_n2f(xl, elas, konl, voldl, s, imat, elcon, nelcon, ncmat_, ntmat_, &
         nope, lakonl, t1l, kode, elconloc, plicon, nplicon, npmat_, iperturb, springarea, &
         nmethod, mi, ne0, nstate_, xstateini, xstate, reltime, nasym, ielorien, orab, norien, &
         nelem)
      return
   end if
   call fill_spring(spring, interaction, xl(:, :nope), voldl(:, :nope), konl(:nope + 1), &
      springarea(1), nmethod)
   call evaluate_spring(spring, xstateini(:, ne0 + konl(nope + 1)), state, response)
   n = 3*nope
   s(:n, :n) = spring_stiffness(response, springarea(1))
   if (nasym == 0 .or. host%symmetric) s(:n, :n) = 0.5_wp*(s(:n, :n) + transpose(s(:n, :n)))
end subroutine springstiff_n2f

!> Read *SURFACE BEHAVIOR.
subroutine surfacebehaviors(inpc, textpart, elcon, nelcon, imat, ntmat_, ncmat_, irstrt, istep, &
   istat, n, iline, ipol, inl, ipoinp, inp, ipoinpc, npmat_, plicon, nplicon, nstate_, &
   ichangesurfacebehavior, ier)
   use asperity_base_kinds, only: wp
   use asperity_calculix_interactions, only: add_interaction, interaction_type, mark, most_depvar
   use asperity_calculix_keyword, only: is_uinter, read_parameters, read_property
   use asperity_calculix_spring_state, only: own_slots
   implicit none
   character(len=1) :: inpc(*)
   character(len=132) :: textpart(16)
   integer :: imat, ntmat_, ncmat_, nelcon(2, *), irstrt(*), istep, istat, n, iline, ipol, inl
   integer :: ipoinp(2, *), inp(3, *), ipoinpc(0:*), npmat_, nplicon(0:ntmat_, *), nstate_
   integer :: ichangesurfacebehavior, ier
   real(wp) :: elcon(0:ncmat_, ntmat_, *), plicon(0:2*npmat_, ntmat_, *)
   external :: ccx_surfacebehaviors, getnewline
   type(interaction_type) :: interaction
   character(len=:), allocatable :: problem
   integer :: i, key, found

   if (.not. is_uinter(textpart(:n))) then
      call ccx_surfacebehaviors(inpc, textpart, elcon, nelcon, imat, ntmat_, ncmat_, irstrt, &
         istep, istat, n, iline, ipol, inl, ipoinp, inp, ipoinpc, npmat_, plicon, nplicon, &
         nstate_, ichangesurfacebehavior, ier)
      return
   end if
   call read_parameters(textpart(:n), interaction, problem)
   if (imat == 0) problem = 'it must follow *SURFACE INTERACTION'
   if (istep > 0) problem = 'it must stand before all steps, and the law cannot be changed in one'
   if (ncmat_ < 8) problem = '*FRICTION with the line 1.,1. must follow; its values are not used'
   found = 0
   do
      call getnewline(inpc, textpart, istat, n, key, iline, ipol, inl, ipoinp, inp, ipoinpc)
      if (istat < 0 .or. key == 1) exit
      if (allocated(problem)) cycle
      do i = 1, n
         call read_property(textpart(i), interaction%props, found, problem)
      end do
   end do
   if (.not. allocated(problem)) then
      if (found < size(interaction%props)) &
         problem = 'there are fewer properties than PROPERTIES says'
   end if
   if (allocated(problem)) then
      write (*, '(2a)') ' *ERROR reading *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER: ', problem
      ier = 1
      return
   end if

   ! For the solver: an exponential law that reaches so far, with friction, which asks for the
   ! unsymmetric equation solver
   elcon(0:2, 1, imat) = [0.0_wp, log(100.0_wp)/interaction%search_distance, 1.0_wp]
   elcon(3:4, 1, imat) = [1.5_wp, mark]
   elcon(6:7, 1, imat) = 1.0_wp
   nelcon(:, imat) = [8, 1]
   interaction%material = imat
   call add_interaction(interaction)
   nstate_ = max(nstate_, own_slots + most_depvar())
end subroutine surfacebehaviors

!> Generate the contact springs.
subroutine gencontelem_n2f(tieset, ntie, itietri, ne, ipkon, kon, lakon, cg, straight, ifree, &
   koncont, co, vold, xo, yo, zo, x, y, z, nx, ny, nz, ielmat, elcon, istep, iinc, iit, ncmat_, &
   ntmat_, nmethod, mi, imastop, nslavnode, islavnode, islavsurf, itiefac, areaslav, iponoels, &
   inoels, springarea, set, nset, istartset, iendset, ialset, tietol, reltime, filab, nasym, &
   xnoels, icutb, ne0, jobnamef, mortar, auw, jqw, iroww, nzsw, imastnode, nmastnode)
   use asperity_base_kinds, only: wp
   use asperity_calculix_areas, only: leave_out_sides
   use asperity_calculix_ccx_state, only: host, know_job, know_pairs
   use asperity_calculix_interactions, only: mark
   use asperity_calculix_master_faces, only: keep_faces
   use asperity_calculix_restart, only: keep_interactions
   implicit none
   character(len=81) :: tieset(3, *), set(*)
   character(len=8) :: lakon(*)
   character(len=87) :: filab(*)
   character(len=132) :: jobnamef(*)
   integer :: ntie, itietri(*), ne, ipkon(*), kon(*), ifree, koncont(*), nx(*), ny(*), nz(*)
   integer :: ielmat(*), istep, iinc, iit, ncmat_, ntmat_, nmethod, mi(*), imastop(*)
   integer :: nslavnode(*), islavnode(*), islavsurf(2, *), itiefac(2, *), iponoels(*)
   integer :: inoels(2, *), nset
   integer :: istartset(*), iendset(*), ialset(*), nasym, icutb, ne0, mortar, jqw(*), iroww(*)
   integer :: nzsw, imastnode(*), nmastnode(*)
   real(wp) :: cg(*), straight(*), co(3, *), vold(0:mi(2), *), xo(*), yo(*), zo(*), x(*), y(*)
   real(wp) :: z(*), elcon(0:ncmat_, ntmat_, *), areaslav(*), springarea(2, *), tietol(4, *)
   real(wp) :: reltime, xnoels(*), auw(*)
   external :: ccx_gencontelem_n2f
   integer :: first, free, i, materials(ntie)
   logical :: marked(ntie), resumed

   materials = [(merge(int(tietol(2, i)), 0, tieset(1, i)(81:81) == 'C'), i=1, ntie)]
   marked = .false.
   do i = 1, ntie
      if (materials(i) > 0) marked(i) = abs(elcon(4, 1, materials(i)) - mark) < 0.5_wp
   end do
   if (iit < 0 .and. any(marked)) then
      call keep_interactions(jobnamef(1), pack(materials, marked), resumed)
      if (host%job == '') call know_job(jobnamef(1), resumed)
   end if
   call know_pairs(materials, nslavnode(:ntie + 1), islavnode(:nslavnode(ntie + 1)))
   do i = 1, ntie
      if (.not. host%serves(i)) cycle
      call leave_out_sides(islavnode(nslavnode(i) + 1:nslavnode(i + 1)), itiefac(:, i), ipkon, &
         kon, lakon, islavsurf, iponoels, inoels, xnoels)
   end do
   first = ne + 1
   free = ifree
   call ccx_gencontelem_n2f(tieset, ntie, itietri, ne, ipkon, kon, lakon, cg, straight, ifree, &
      koncont, co, vold, xo, yo, zo, x, y, z, nx, ny, nz, ielmat, elcon, istep, iinc, iit, ncmat_, &
      ntmat_, nmethod, mi, imastop, nslavnode, islavnode, islavsurf, itiefac, areaslav, iponoels, &
      inoels, springarea, set, nset, istartset, iendset, ialset, tietol, reltime, filab, nasym, &
      xnoels, icutb, ne0, jobnamef, mortar, auw, jqw, iroww, nzsw, imastnode, nmastnode)
   call keep_faces([istep, iinc, icutb], first, ne, free, ipkon, kon, lakon, ielmat, mi, &
      islavnode, materials, co, vold, springarea)
   ! springs that were put back need room
   ifree = max(ifree, free)
end subroutine gencontelem_n2f

!> Write a line of JOB.sta: an increment has converged.
subroutine writesta(istep, j, icutb, l, ttime, time, dtime)
   use asperity_base_kinds, only: wp
   use asperity_calculix_events, only: end_increment
   use asperity_calculix_interactions, only: has_interactions
   use asperity_calculix_states, only: write_states
   implicit none
   integer :: istep, j, icutb, l
   real(wp) :: ttime, time, dtime
   external :: ccx_writesta

   call ccx_writesta(istep, j, icutb, l, ttime, time, dtime)
   if (.not. has_interactions()) return
   call write_states(istep, j, ttime + time)
   call end_increment(istep, j, time, ttime + time, dtime)
end subroutine writesta
