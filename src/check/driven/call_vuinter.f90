!> One guarded call of a VUINTER for several slave nodes.
module asperity_check_driven_call_vuinter
   use, intrinsic :: iso_fortran_env, only: real32
   use asperity_base_kinds, only: wp
   use asperity_check_driven_layout, only: argument_layout, cell_of, changed_name, is_advanced, &
      is_input, is_output, lay_out, new_layout, read_back
   use asperity_check_driven_point, only: point_answer, point_motion, point_start
   use asperity_check_driven_routine, only: driven_routine, fills_of, poison
   implicit none
   private
   public :: new_vuinter_layout, call_vuinter

   !> Real arguments in the order of the list
   enum, bind(c)
      enumerator :: sfd = 1, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, timstep, &
         timglb, dtimcur, rdisp, drdisp, drot, stiffdflt, conddflt, shape_values, coordslv, &
         coordmst, alocaldir, props, areaslv, tempslv, dtempslv, predefslv, dpredefslv, tempmst, &
         dtempmst, predefmst, dpredefmst
   end enum
   character(len=*), parameter :: names(dpredefmst) = [character(len=11) :: 'sfd', 'scd', 'spd', &
      'svd', 'stress', 'fluxSlv', 'fluxMst', 'sed', 'statev', 'timStep', 'timGlb', 'dTimCur', &
      'rdisp', 'drdisp', 'drot', 'stiffDflt', 'condDflt', 'shape', 'coordSlv', 'coordMst', &
      'alocaldir', 'props', 'areaSlv', 'tempSlv', 'dtempSlv', 'preDefSlv', 'dpreDefSlv', &
      'tempMst', 'dtempMst', 'preDefMst', 'dpreDefMst']
   integer, parameter :: roles(dpredefmst) = [is_output, is_output, is_output, is_output, &
      is_advanced, is_output, is_output, is_advanced, is_advanced, is_input, is_input, is_input, &
      is_input, is_input, is_input, is_input, is_input, is_input, is_input, is_input, is_input, &
      is_input, is_input, is_input, is_input, is_input, is_input, is_input, is_input, is_input, &
      is_input]

   !> Inputs that are integers, and texts, in the order of the list
   character(len=*), parameter :: integer_names(12) = [character(len=9) :: 'kStep', 'kInc', &
      'nFacNod', 'nSlvNod', 'nMstNod', 'nSurfDir', 'nDir', 'nStateVar', 'nProps', 'nTemp', &
      'nPred', 'numDefTfv']
   character(len=*), parameter :: text_names(3) = [character(len=7) :: 'surfInt', 'surfSlv', &
      'surfMst']
   character(len=80), parameter :: texts(3) = [character(len=80) :: 'INTERACTION', 'SLAVE', &
      'MASTER']

   !> Nodes of a facet of the master surface, which is one facet; field variables; first node number
   integer, parameter :: facet_nodes = 4, npred = 1, first_label = 101
   !> Temperature; area of a node, mm^2; stiffness, MPa/mm, and conductance that ABAQUS would take
   real(wp), parameter :: temperature = 20.0_wp, area = 1.0_wp, stiffness = 1.0e3_wp

contains

   !> Where the arguments of a VUINTER stand.
   pure subroutine new_vuinter_layout(layout, ndir, nstatv, nprops, n, single)
      !> Result
      type(argument_layout), intent(out) :: layout
      !> Components, lengths of STATEV and PROPS, slave nodes
      integer, intent(in) :: ndir, nstatv, nprops, n
      !> Whether it takes single precision
      logical, intent(in) :: single

      call new_layout(layout, names, roles, &
         [n, n, n, n, ndir*n, n, n, n, nstatv*n, 1, 1, 1, ndir*n, ndir*n, 4*n, n, n, &
         facet_nodes*n, ndir*n, ndir*facet_nodes, ndir**2*n, nprops, n, n, n, npred*n, npred*n, &
         n, n, npred*n, npred*n], &
         [0, 0, 0, 0, ndir, 0, 0, 0, nstatv, 0, 0, 0, ndir, ndir, 0, 0, 0, &
         facet_nodes, ndir, ndir, 0, 0, 0, 0, 0, npred, npred, &
         0, 0, npred, npred], single)
   end subroutine new_vuinter_layout

   !> Call it once. The layout of the routine is for as many nodes.
   subroutine call_vuinter(routine, starts, motions, answers)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> The nodes at the start of the increment, and their motions
      type(point_start), intent(in) :: starts(:)
      type(point_motion), intent(in) :: motions(:)
      !> Results
      type(point_answer), intent(inout) :: answers(:)
      real(wp), allocatable :: numbers(:), fills(:), units(:), c(:)
      integer, allocatable :: labels(:), facets(:)
      integer :: at(dpredefmst), i, n, given(size(integer_names)), whole(size(integer_names))
      ! of its own, so that what a routine writes to is no constant
      character(len=80) :: names_of(size(texts))

      n = size(starts)
      call fill_in(routine, starts, motions, numbers)
      call fills_of(routine, fills)
      call lay_out(routine%layout, numbers, fills, units, c)
      do i = 1, dpredefmst
         at(i) = cell_of(routine%layout, i)
      end do
      allocate (labels(max(n, facet_nodes)), facets(n*facet_nodes))
      labels = [(first_label + i, i=0, size(labels) - 1)]
      facets = [(1 + mod(i, facet_nodes), i=0, size(facets) - 1)]
      given = [1, starts(1)%increment, facet_nodes, n, facet_nodes, routine%ndir - 1, &
         routine%ndir, routine%nstatv, size(routine%props), 1, npred, n]
      whole = given
      names_of = texts
      call routine%vuinter(c(at(sfd)), c(at(scd)), c(at(spd)), c(at(svd)), c(at(stress)), &
         c(at(fluxslv)), c(at(fluxmst)), c(at(sed)), c(at(statev)), whole(1), whole(2), whole(3), &
         whole(4), whole(5), whole(6), whole(7), whole(8), whole(9), whole(10), whole(11), &
         whole(12), labels, labels, facets, c(at(timstep)), c(at(timglb)), c(at(dtimcur)), &
         names_of(1), names_of(2), names_of(3), c(at(rdisp)), c(at(drdisp)), c(at(drot)), &
         c(at(stiffdflt)), c(at(conddflt)), c(at(shape_values)), c(at(coordslv)), c(at(coordmst)), &
         c(at(alocaldir)), c(at(props)), &
         c(at(areaslv)), c(at(tempslv)), c(at(dtempslv)), c(at(predefslv)), c(at(dpredefslv)), &
         c(at(tempmst)), c(at(dtempmst)), c(at(predefmst)), c(at(dpredefmst)))
      do i = 1, n
         call read_node(routine, units, c, i, answers(i))
         ! as the precision of the routine takes them
         answers(i)%before = numbers
         if (routine%layout%single) answers(i)%before = real(real(numbers, real32), wp)
         answers(i)%changed = changed_name(integer_names, given, whole, text_names, texts, &
            names_of)
      end do
   end subroutine call_vuinter

   !> The answer of one node; its `numbers` are those of all nodes.
   pure subroutine read_node(routine, units, cells, node, answer)
      type(driven_routine), intent(in) :: routine
      real(wp), intent(in) :: units(:), cells(:)
      integer, intent(in) :: node
      type(point_answer), intent(out) :: answer
      integer :: d, m

      call read_back(routine%layout, units, cells, answer%numbers, answer%damaged_slot, &
         answer%damaged_entry)
      d = routine%ndir
      m = routine%nstatv
      allocate (answer%statev(m))
      associate (s => routine%layout%slots, a => answer%numbers, k => node - 1)
         answer%stress(:d) = a(s(stress)%number + d*k:s(stress)%number + d*node - 1)
         answer%statev = a(s(statev)%number + m*k:s(statev)%number + m*node - 1)
         answer%sed = a(s(sed)%number + k)
         answer%dissipation = a(s(sfd)%number + k) + a(s(scd)%number + k) + a(s(spd)%number + k) &
            + a(s(svd)%number + k)
      end associate
   end subroutine read_node

   !> All numbers before a call.
   pure subroutine fill_in(routine, starts, motions, numbers)
      type(driven_routine), intent(in) :: routine
      type(point_start), intent(in) :: starts(:)
      type(point_motion), intent(in) :: motions(:)
      real(wp), allocatable, intent(out) :: numbers(:)
      integer :: i, k, d, m

      allocate (numbers(routine%layout%numbers), source=0.0_wp)
      call poison(routine, numbers)
      d = routine%ndir
      m = routine%nstatv
      associate (s => routine%layout%slots)
         do i = 1, size(starts)
            k = i - 1
            numbers(s(stress)%number + d*k:s(stress)%number + d*i - 1) = starts(i)%stress(:d)
            numbers(s(statev)%number + m*k:s(statev)%number + m*i - 1) = starts(i)%statev
            numbers(s(sed)%number + k) = starts(i)%sed
            numbers(s(rdisp)%number + d*k:s(rdisp)%number + d*i - 1) = motions(i)%rdisp(:d)
            numbers(s(drdisp)%number + d*k:s(drdisp)%number + d*i - 1) = motions(i)%drdisp(:d)
            numbers(s(drot)%number + 4*k:s(drot)%number + 4*i - 1) = reshape(motions(i)%drot, [4])
            numbers(s(alocaldir)%number + d**2*k:s(alocaldir)%number + d**2*i - 1:d + 1) = 1.0_wp
         end do
         numbers(s(timstep)%number) = starts(1)%time + motions(1)%dtime
         numbers(s(timglb)%number) = starts(1)%time + motions(1)%dtime
         numbers(s(dtimcur)%number) = motions(1)%dtime
         numbers(s(stiffdflt)%number:s(conddflt)%number + size(starts) - 1) = stiffness
         numbers(s(shape_values)%number:s(coordslv)%number - 1) = 1.0_wp/facet_nodes
         numbers(s(props)%number:s(props)%number + size(routine%props) - 1) = routine%props
         numbers(s(areaslv)%number:s(tempslv)%number - 1) = area
         numbers(s(tempslv)%number:s(dtempslv)%number - 1) = temperature
         numbers(s(tempmst)%number:s(dtempmst)%number - 1) = temperature
      end associate
   end subroutine fill_in

end module asperity_check_driven_call_vuinter
