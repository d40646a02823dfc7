!> A host that plays ABAQUS for one contact point: it calls UINTER several times an increment from
!> the values at its start, with every output poisoned beforehand, accepts or cuts back, and keeps
!> the history of everything that UINTER returned.
module asperity_replay_abaqus_host
   use asperity_abaqus_props, only: props_from_properties
   use asperity_abaqus_statev, only: state_from_statev, statev_needed
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, contact_state, no_rotation, no_surface_limit
   use asperity_replay_abaqus_record, only: check_outputs, host_record, new_host_record, &
      optional_outputs, poison_outputs
   implicit none
   private
   public :: host_point, new_host_point, try_increment, accept_increment, refuse_cut, &
      run_increment, host_response

   !> One contact point of the host.
   type :: host_point
      !> The UINTER that is called
      procedure(uinter_interface), pointer, nopass :: routine => null()
      !> PROPS
      real(wp), allocatable :: props(:)
      !> Components, 2 or 3
      integer :: ndir = 3
      !> Values at the start of the increment
      type(host_record) :: start
      !> Values of the last call
      type(host_record) :: trial
      !> Accepted increments
      type(host_record), allocatable :: history(:)
      !> Whether they are kept
      logical :: keep_history = .true.
      !> Increments asked to be repeated so far
      integer :: cutbacks = 0
      !> Increments accepted so far
      integer :: increments = 0
      !> Rotation of the slip directions since the start, the product of all DROT
      real(wp) :: rotation(2, 2) = no_rotation
      !> SFD, SPD, SVD and SCD of all accepted increments, N/mm
      real(wp) :: dissipation(4) = 0.0_wp
      !> Which of the optional outputs a call has left unset
      logical :: unset(size(optional_outputs)) = .false.
   end type host_point

   !> A fresh point, by checked properties or by a list that only its UINTER knows
   interface new_host_point
      module procedure point_of_properties, point_of_list
   end interface new_host_point

   real(wp), parameter :: large_pnewdt = 1.0e30_wp
   integer, parameter :: max_discontinuities = 10, max_cutbacks = 30

contains

   !> A fresh point that calls `routine` with the full property list of `properties`.
   subroutine point_of_properties(point, routine, properties, ndir, props, nstatv, keep_history)
      !> Result
      type(host_point), intent(out) :: point
      !> The UINTER to be called
      procedure(uinter_interface) :: routine
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> 2 or 3 components; 3 when absent
      integer, intent(in), optional :: ndir
      !> Another property list in place of that of `properties`
      real(wp), intent(in), optional :: props(:)
      !> Length of STATEV; what UINTER needs when absent
      integer, intent(in), optional :: nstatv
      !> Whether accepted increments are kept; they are when absent
      logical, intent(in), optional :: keep_history
      integer :: n

      n = statev_needed(properties)
      if (present(nstatv)) n = nstatv
      if (present(props)) then
         call point_of_list(point, routine, props, n, ndir, keep_history)
      else
         call point_of_list(point, routine, props_from_properties(properties), n, ndir, &
            keep_history)
      end if
   end subroutine point_of_properties

   !> A fresh point that calls `routine` with a property list.
   subroutine point_of_list(point, routine, props, nstatv, ndir, keep_history)
      !> Result
      type(host_point), intent(out) :: point
      !> The UINTER to be called
      procedure(uinter_interface) :: routine
      !> PROPS
      real(wp), intent(in) :: props(:)
      !> Length of STATEV
      integer, intent(in) :: nstatv
      !> 2 or 3 components; 3 when absent
      integer, intent(in), optional :: ndir
      !> Whether accepted increments are kept; they are when absent
      logical, intent(in), optional :: keep_history

      point%routine => routine
      point%props = props
      if (present(ndir)) point%ndir = ndir
      call new_host_record(point%start, point%ndir, nstatv)
      point%trial = point%start
      if (present(keep_history)) point%keep_history = keep_history
      allocate (point%history(0))
   end subroutine point_of_list

   !> One iteration: call UINTER from the start of the increment for a trial motion, and again
   !> while it changes LOPENCLOSE. `point%trial` holds what it returned. `error` is set when a
   !> required output was left unset or the status never settles.
   subroutine try_increment(point, overclosure, slip_increment, dtime, error, rotation, linper)
      !> The point
      type(host_point), intent(inout) :: point
      !> RDISP(1) at the end, mm
      real(wp), intent(in) :: overclosure
      !> DRDISP(2:), mm
      real(wp), intent(in) :: slip_increment(:)
      !> Length of the increment, s
      real(wp), intent(in) :: dtime
      !> Set when UINTER broke its contract
      type(error_type), allocatable, intent(out) :: error
      !> DROT
      real(wp), intent(in), optional :: rotation(2, 2)
      !> 1 in a linear perturbation step, where motions are perturbations
      integer, intent(in), optional :: linper
      integer :: lopenclose, perturbation, repeat
      real(wp) :: drot(2, 2)

      drot = no_rotation
      if (present(rotation)) drot = rotation
      perturbation = 0
      if (present(linper)) perturbation = linper
      do repeat = 1, max_discontinuities
         lopenclose = point%trial%lopenclose
         call call_routine(point, overclosure, slip_increment, dtime, drot, perturbation)
         call check_outputs(point%trial, error)
         point%unset = point%unset .or. point%trial%unset
         if (allocated(error)) return
         if (point%trial%lopenclose == lopenclose .or. perturbation == 1) return
      end do
      call fatal_error(error, 'LOPENCLOSE keeps changing at overclosure = '// &
         to_text(overclosure)//' mm', computation_error)
   end subroutine try_increment

   !> `error` is set when the last trial asks to be cut, for a caller that cannot cut.
   subroutine refuse_cut(point, error)
      !> The point
      type(host_point), intent(in) :: point
      !> Set when PNEWDT is below 1
      type(error_type), allocatable, intent(out) :: error

      if (point%trial%pnewdt < 1.0_wp) call fatal_error(error, 'UINTER cannot compute '// &
         'overclosure = '//to_text(point%trial%rdisp(1))//' mm', computation_error)
   end subroutine refuse_cut

   !> The last trial as the response of the contact-point update.
   pure function host_response(point) result(response)
      !> The point
      type(host_point), intent(in) :: point
      type(contact_response) :: response
      type(contact_state) :: start

      call state_from_statev(point%start%statev, start)
      associate (t => point%trial, n => point%ndir, state => response%state)
         call state_from_statev(t%statev, state)
         response%traction(:n) = t%stress
         response%tangent(:n, :n) = t%ddsddr
         response%status = state%status
         response%validity = state%validity
         response%normal_energy = state%normal_energy
         response%tangential_energy = t%sed - state%normal_energy
         response%plastic_dissipation = t%spd
         response%dissipation = t%sfd
         response%pressure_coupling = state%pressure_coupling - start%pressure_coupling
      end associate
   end function host_response

   !> Accept the last trial: it becomes the start of the next increment.
   subroutine accept_increment(point, rotation)
      !> The point
      type(host_point), intent(inout) :: point
      !> DROT of the increment
      real(wp), intent(in), optional :: rotation(2, 2)
      type(host_record), allocatable :: grown(:)

      if (present(rotation)) point%rotation = matmul(rotation, point%rotation)
      point%increments = point%increments + 1
      associate (t => point%trial)
         point%dissipation = point%dissipation + [t%sfd, t%spd, t%svd, t%scd]
      end associate
      if (point%keep_history) then
         if (point%increments > size(point%history)) then
            allocate (grown(max(64, 2*size(point%history))))
            grown(:size(point%history)) = point%history
            call move_alloc(grown, point%history)
         end if
         point%history(point%increments) = point%trial
      end if
      point%start = point%trial
      point%start%calls = 0
      point%trial%calls = 0
   end subroutine accept_increment

   !> A whole increment of prescribed motion: cut back as UINTER asks, then accept. As in ABAQUS,
   !> the first iteration has moved nothing yet. `error` is set when it cannot be finished.
   subroutine run_increment(point, overclosure, slip_increment, dtime, error, rotation)
      !> The point
      type(host_point), intent(inout) :: point
      !> RDISP(1) at the end, mm
      real(wp), intent(in) :: overclosure
      !> DRDISP(2:), mm
      real(wp), intent(in) :: slip_increment(:)
      !> Length of the increment, s
      real(wp), intent(in) :: dtime
      !> Set when UINTER broke its contract or asks for ever smaller increments
      type(error_type), allocatable, intent(out) :: error
      !> DROT; an increment with rotation is not cut
      real(wp), intent(in), optional :: rotation(2, 2)
      real(wp) :: done, part, from, to
      integer :: cuts

      done = 0.0_wp
      part = 1.0_wp
      cuts = 0
      from = point%start%rdisp(1)
      if (from < no_surface_limit) from = overclosure
      do while (done < 1.0_wp)
         part = min(part, 1.0_wp - done)
         to = overclosure
         if (done + part < 1.0_wp) to = from + (done + part)*(overclosure - from)
         call try_increment(point, point%start%rdisp(1), 0.0_wp*slip_increment, part*dtime, error)
         if (allocated(error)) return
         if (point%trial%pnewdt >= 1.0_wp) then
            call try_increment(point, to, part*slip_increment, part*dtime, error, rotation)
            if (allocated(error)) return
         end if
         if (point%trial%pnewdt < 1.0_wp) then
            cuts = cuts + 1
            point%cutbacks = point%cutbacks + 1
            part = part*point%trial%pnewdt
            point%trial = point%start
            if (cuts <= max_cutbacks .and. .not. present(rotation)) cycle
            call fatal_error(error, 'UINTER asks to cut the increment for ever at '// &
               'overclosure = '//to_text(overclosure)//' mm', computation_error)
            return
         end if
         call accept_increment(point, rotation)
         done = done + part
         if (part <= 0.0_wp) exit
      end do
   end subroutine run_increment

   !> One call, from the values at the start of the increment, outputs poisoned.
   subroutine call_routine(point, overclosure, slip_increment, dtime, drot, linper)
      type(host_point), intent(inout) :: point
      real(wp), intent(in) :: overclosure, slip_increment(:), dtime, drot(2, 2)
      integer, intent(in) :: linper
      character(len=80), parameter :: ciname = 'WOOD', slname = 'SLAVE', msname = 'MASTER'
      real(wp), parameter :: zero_2(2) = 0.0_wp, zero_field(2, 1) = 0.0_wp
      real(wp), parameter :: axes(3, 3) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, &
         0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [3, 3])
      real(wp) :: coords(point%ndir)
      integer :: calls, lopenclose, lstate

      coords = 0.0_wp
      calls = point%trial%calls
      lopenclose = point%trial%lopenclose
      lstate = point%trial%lstate
      point%trial = point%start
      call poison_outputs(point%trial)
      associate (t => point%trial)
         t%calls = calls + 1
         t%lopenclose = lopenclose
         t%lstate = lstate
         t%lsdi = 0
         t%pnewdt = large_pnewdt
         t%dtime = dtime
         t%rdisp(1) = overclosure
         t%drdisp(1) = overclosure - point%start%rdisp(1)
         t%drdisp(2:) = slip_increment
         if (linper == 1) then
            ! a perturbation has no past
            t%rdisp(2:) = slip_increment
         else
            t%time = point%start%time + dtime
            if (point%ndir == 3) t%rdisp(2:) = matmul(drot, point%start%rdisp(2:))
            t%rdisp(2:) = t%rdisp(2:) + slip_increment
         end if
         call point%routine( &
            t%stress, t%ddsddr, t%dviscous, t%dstructural, t%flux, t%ddfddt, &
            t%ddsddt, t%ddfddr, t%statev, t%sed, t%sfd, t%spd, t%svd, t%scd, &
            t%pnewdt, t%rdisp, t%drdisp, zero_2, zero_2, zero_field, zero_field, &
            t%time, dtime, 0.0_wp, ciname, slname, msname, point%props, coords, &
            axes, drot, 1.0_wp, 1.0_wp, 1, point%ndir, size(t%statev), 1, &
            size(point%props), point%ndir, 1, point%increments + 1, calls, linper, &
            t%lopenclose, t%lstate, t%lsdi, 0)
      end associate
   end subroutine call_routine

end module asperity_replay_abaqus_host
