!> One guarded call of a UINTER.
module asperity_check_driven_call_uinter
   use asperity_base_kinds, only: wp
   use asperity_check_driven_layout, only: argument_layout, cell_of, changed_name, is_advanced, &
      is_input, is_output, lay_out, new_layout, read_back
   use asperity_check_driven_point, only: point_answer, point_motion, point_start
   use asperity_check_driven_routine, only: driven_routine, fills_of, poison
   implicit none
   private
   public :: new_uinter_layout, call_uinter

   !> Real arguments in the order of the list
   enum, bind(c)
      enumerator :: stress = 1, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, &
         statev, sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, &
         time, dtime, freqr, props, coords, alocaldir, drot, area, chrlngth
   end enum
   character(len=*), parameter :: names(chrlngth) = [character(len=11) :: 'STRESS', 'DDSDDR', &
      'DVISCOUS', 'DSTRUCTURAL', 'FLUX', 'DDFDDT', 'DDSDDT', 'DDFDDR', 'STATEV', 'SED', 'SFD', &
      'SPD', 'SVD', 'SCD', 'PNEWDT', 'RDISP', 'DRDISP', 'TEMP', 'DTEMP', 'PREDEF', 'DPRED', &
      'TIME', 'DTIME', 'FREQR', 'PROPS', 'COORDS', 'ALOCALDIR', 'DROT', 'AREA', 'CHRLNGTH']
   integer, parameter :: roles(chrlngth) = [is_advanced, is_output, is_output, is_output, &
      is_output, is_output, is_output, is_output, is_advanced, is_advanced, is_output, &
      is_output, is_output, is_output, is_advanced, is_input, is_input, is_input, is_input, &
      is_input, is_input, is_input, is_input, is_input, is_input, is_input, is_input, is_input, &
      is_input, is_input]

   !> Inputs that are integers, and texts, in the order of the list
   character(len=*), parameter :: integer_names(11) = [character(len=6) :: 'NODE', 'NDIR', &
      'NSTATV', 'NPRED', 'NPROPS', 'MCRD', 'KSTEP', 'KINC', 'KIT', 'LINPER', 'LPRINT']
   character(len=*), parameter :: text_names(3) = [character(len=6) :: 'CINAME', 'SLNAME', &
      'MSNAME']
   character(len=80), parameter :: texts(3) = [character(len=80) :: 'INTERACTION', 'SLAVE', &
      'MASTER']

   !> Field variables that a model has, so that their arrays are not empty
   integer, parameter :: npred = 1
   !> PNEWDT of the host, which asks for nothing; temperature and field variables; area of the
   !> point, mm^2, and its length, mm
   real(wp), parameter :: large_pnewdt = 1.0e30_wp, temperature = 20.0_wp, area_of_point = 1.0_wp

contains

   !> Where the arguments of a UINTER stand.
   pure subroutine new_uinter_layout(layout, ndir, nstatv, nprops)
      !> Result
      type(argument_layout), intent(out) :: layout
      !> Components, also of the coordinates; lengths of STATEV and PROPS
      integer, intent(in) :: ndir, nstatv, nprops
      integer, parameter :: m = npred

      call new_layout(layout, names, roles, &
         [ndir, ndir**2, ndir**2, ndir**2, 2, 4, 2*ndir, 2*ndir, nstatv, 1, 1, 1, 1, 1, 1, &
         ndir, ndir, 2, 2, 2*m, 2*m, 2, 1, 1, nprops, ndir, 9, 4, 1, 1], &
         [0, ndir, ndir, ndir, 0, 2, ndir, 2, 0, 0, 0, 0, 0, 0, 0, &
         0, 0, 0, 0, 2, 2, 0, 0, 0, 0, 0, 3, 2, 0, 0], single=.false.)
   end subroutine new_uinter_layout

   !> Call it once.
   subroutine call_uinter(routine, start, motion, answer)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> The point at the start of the increment, and its motion
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      !> Result
      type(point_answer), intent(out) :: answer
      real(wp), allocatable :: numbers(:), fills(:), units(:), c(:)
      integer :: at(chrlngth), i, n, given(size(integer_names)), whole(size(integer_names))
      ! of its own, so that what a routine writes to is no constant
      character(len=80) :: names_of(size(texts))

      call fill_in(routine, start, motion, numbers)
      call fills_of(routine, fills)
      call lay_out(routine%layout, numbers, fills, units, c)
      do i = 1, chrlngth
         at(i) = cell_of(routine%layout, i)
      end do
      given = [1, routine%ndir, routine%nstatv, npred, size(routine%props), routine%ndir, 1, &
         start%increment, motion%kit, motion%linper, 0]
      whole = given
      names_of = texts
      answer%lopenclose = start%lopenclose
      answer%lstate = start%lstate
      call routine%uinter(c(at(stress)), c(at(ddsddr)), c(at(dviscous)), c(at(dstructural)), &
         c(at(flux)), c(at(ddfddt)), c(at(ddsddt)), c(at(ddfddr)), c(at(statev)), c(at(sed)), &
         c(at(sfd)), c(at(spd)), c(at(svd)), c(at(scd)), c(at(pnewdt)), c(at(rdisp)), &
         c(at(drdisp)), c(at(temp)), c(at(dtemp)), c(at(predef)), c(at(dpred)), c(at(time)), &
         c(at(dtime)), c(at(freqr)), names_of(1), names_of(2), names_of(3), c(at(props)), &
         c(at(coords)), c(at(alocaldir)), c(at(drot)), c(at(area)), c(at(chrlngth)), whole(1), &
         whole(2), whole(3), whole(4), whole(5), whole(6), whole(7), whole(8), whole(9), &
         whole(10), answer%lopenclose, answer%lstate, answer%lsdi, whole(11))
      answer%changed = changed_name(integer_names, given, whole, text_names, texts, names_of)
      answer%before = numbers
      call read_back(routine%layout, units, c, answer%numbers, answer%damaged_slot, &
         answer%damaged_entry)
      n = routine%ndir
      allocate (answer%statev(routine%nstatv))
      associate (s => routine%layout%slots, a => answer%numbers)
         answer%stress(:n) = a(s(stress)%number:s(stress)%number + n - 1)
         answer%ddsddr(:n, :n) = reshape(a(s(ddsddr)%number:s(ddsddr)%number + n**2 - 1), [n, n])
         answer%statev = a(s(statev)%number:s(statev)%number + routine%nstatv - 1)
         answer%sed = a(s(sed)%number)
         answer%dissipation = sum(a(s(sfd)%number:s(scd)%number))
         answer%pnewdt = a(s(pnewdt)%number)
      end associate
   end subroutine call_uinter

   !> All numbers before a call.
   pure subroutine fill_in(routine, start, motion, numbers)
      type(driven_routine), intent(in) :: routine
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      real(wp), allocatable, intent(out) :: numbers(:)

      allocate (numbers(routine%layout%numbers), source=0.0_wp)
      call poison(routine, numbers)
      associate (s => routine%layout%slots, n => routine%ndir)
         numbers(s(stress)%number:s(stress)%number + n - 1) = start%stress(:n)
         numbers(s(statev)%number:s(statev)%number + routine%nstatv - 1) = start%statev
         numbers(s(sed)%number) = start%sed
         numbers(s(pnewdt)%number) = large_pnewdt
         numbers(s(rdisp)%number:s(rdisp)%number + n - 1) = motion%rdisp(:n)
         numbers(s(drdisp)%number:s(drdisp)%number + n - 1) = motion%drdisp(:n)
         numbers(s(temp)%number:s(temp)%number + 1) = temperature
         numbers(s(time)%number:s(time)%number + 1) = start%time
         ! a perturbation takes no time
         if (motion%linper == 0) numbers(s(time)%number:s(time)%number + 1) = start%time &
            + motion%dtime
         numbers(s(dtime)%number) = motion%dtime
         numbers(s(props)%number:s(props)%number + size(routine%props) - 1) = routine%props
         numbers(s(alocaldir)%number:s(alocaldir)%number + 8:4) = 1.0_wp
         numbers(s(drot)%number:s(drot)%number + 3) = reshape(motion%drot, [4])
         numbers(s(area)%number) = area_of_point
         numbers(s(chrlngth)%number) = sqrt(area_of_point)
      end associate
   end subroutine fill_in

end module asperity_check_driven_call_uinter
