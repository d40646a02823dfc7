!> Press one contact point: close and open it again through UINTER, by ramps of pressure or of
!> overclosure, to one peak (the paper's Fig. 17) or to several, one after the other.
module asperity_replay_press
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_abaqus_statev, only: state_from_statev
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_contact_point, only: overclosure_for
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_state
   use asperity_law_normal_law, only: normal_response
   use asperity_paper_wood, only: wood_strength_across
   use asperity_replay_abaqus_host, only: accept_increment, host_point, new_host_point, &
      refuse_cut, try_increment
   use asperity_replay_normal, only: law_at
   use asperity_replay_sizes, only: check_between
   implicit none
   private
   public :: press_settings, press_step, press_loop, run_press

   !> Peak when none is given, MPa: fc90 of the wood
   real(wp), parameter, public :: default_peak = wood_strength_across

   !> Load path: for each peak up in one ramp, down to zero in another.
   type :: press_settings
      !> What is ramped: `pressure` or `overclosure`
      character(len=16) :: control = 'pressure'
      !> Values at the top of the ramps, MPa or mm; `default_peak` when not allocated
      real(wp), allocatable :: peak(:)
      !> Increments of each ramp
      integer :: increments = 50
      !> Duration of each ramp, s
      real(wp) :: step_time = 1.0_wp
      !> Let a peak pass that is most likely in another unit
      logical :: accept_sizes = .false.
   end type press_settings

   !> One increment of the replay.
   type :: press_step
      !> Step time, s
      real(wp) :: time = 0.0_wp
      !> Overclosure and separation, mm
      real(wp) :: overclosure = 0.0_wp, separation = 0.0_wp
      !> Pressure, MPa, and normal stiffness, MPa/mm, as UINTER returned them
      real(wp) :: pressure = 0.0_wp, stiffness = 0.0_wp
      !> Real over nominal area; contacts, 1/mm^2; stored energy, N/mm
      real(wp) :: area_fraction = 0.0_wp, contact_density = 0.0_wp, energy = 0.0_wp
      !> Plastic dissipation since the start, N/mm, and closest separation so far, mm
      real(wp) :: plastic_dissipation = 0.0_wp, closest_separation = 0.0_wp
      !> Shares of the pressure by stage
      real(wp) :: elastic_share = 1.0_wp, elastoplastic_share = 0.0_wp, plastic_share = 0.0_wp
      !> Contact status and validity flags
      integer :: status = 0, validity = 0
   end type press_step

   !> What pressing to one peak and releasing comes to.
   type :: press_loop
      !> The peak, MPa or mm
      real(wp) :: peak = 0.0_wp
      !> Closest separation so far, mm
      real(wp) :: closest_separation = 0.0_wp
      !> Overclosure at which the pressure falls to that at which a point opens, mm
      real(wp) :: residual_closure = 0.0_wp
      !> Work of the loop, N/mm
      real(wp) :: cycle_loss = 0.0_wp
   end type press_loop

   integer, parameter :: max_increments = 1000000, max_iterations = 20
   real(wp), parameter :: pressure_tolerance = 1.0e-12_wp
   !> Smallest peak overclosure, and how far mean planes may pass each other, over sigma
   real(wp), parameter :: least_closure = 0.013_wp, past_mean = 8.0_wp
   !> Range of a peak pressure over the hardness, beyond which results are flagged
   real(wp), parameter :: least_pressure = 5.0e-4_wp, largest_pressure = 10.0_wp
   procedure(uinter_interface) :: uinter

contains

   !> Replay a press. `error` is set when a setting is not allowed or UINTER broke its contract.
   subroutine run_press(settings, properties, steps, loops, error)
      !> Load path
      type(press_settings), intent(in) :: settings
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Start, then ramp up and ramp down for each peak
      type(press_step), allocatable, intent(out) :: steps(:)
      !> One of each peak
      type(press_loop), allocatable, intent(out) :: loops(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(host_point) :: point
      real(wp), allocatable :: peaks(:)
      integer :: i, k, n, first, row

      if (allocated(settings%peak)) then
         allocate (peaks, source=settings%peak)
      else
         allocate (peaks, source=[default_peak])
      end if
      call check_settings(settings, peaks, error)
      do i = 1, size(peaks)
         if (.not. allocated(error)) call check_peak(settings, peaks(i), properties, error)
      end do
      if (allocated(error)) return
      call new_host_point(point, uinter, properties, ndir=2, keep_history=.false.)
      n = settings%increments
      call check_work(to_text(size(peaks)*real(n, wp), 6)//' increments', &
         int(storage_size(steps)/8, int64)*(2*int(n, int64)*size(peaks) + 1), error)
      if (allocated(error)) return
      allocate (steps(2*n*size(peaks) + 1), loops(size(peaks)))
      call advance(point, settings, properties, 0.0_wp, 0.0_wp, steps(1), error)
      do k = 1, size(peaks)
         first = 2*n*(k - 1) + 1
         do i = 1, 2*n
            if (allocated(error)) return
            row = first + i
            call advance(point, settings, properties, &
               peaks(k)*real(n - abs(n - i), wp)/n, settings%step_time/n, steps(row), error)
            steps(row)%plastic_dissipation = steps(row)%plastic_dissipation &
               + steps(row - 1)%plastic_dissipation
         end do
         if (.not. allocated(error)) &
            call close_loop(point, properties, peaks(k), steps(first), steps(first + 2*n), &
            loops(k), error)
      end do
   end subroutine run_press

   !> One increment.
   subroutine advance(point, settings, properties, target, dtime, step, error)
      type(host_point), intent(inout) :: point
      type(press_settings), intent(in) :: settings
      type(contact_properties), intent(in) :: properties
      !> Pressure or overclosure at its end, and its time, s
      real(wp), intent(in) :: target, dtime
      type(press_step), intent(out) :: step
      type(error_type), allocatable, intent(out) :: error

      if (settings%control == 'overclosure') then
         call try_increment(point, target, [0.0_wp], dtime, error)
      else
         call reach_pressure(point, properties, target, dtime, error)
      end if
      if (.not. allocated(error)) call refuse_cut(point, error)
      if (allocated(error)) return
      call accept_increment(point)
      step = step_of(point, properties)
   end subroutine advance

   !> What a loop comes to. Its work is what UINTER's ledgers tell, without error of a step.
   pure subroutine close_loop(point, properties, peak, first, last, loop, error)
      type(host_point), intent(in) :: point
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: peak
      !> Its first and last step
      type(press_step), intent(in) :: first, last
      type(press_loop), intent(out) :: loop
      type(error_type), allocatable, intent(out) :: error
      type(contact_state) :: state

      loop%peak = peak
      loop%closest_separation = last%closest_separation
      loop%cycle_loss = last%energy - first%energy + last%plastic_dissipation &
         - first%plastic_dissipation
      call state_from_statev(point%start%statev, state)
      call overclosure_for(properties, state, properties%p_open, loop%residual_closure, error)
   end subroutine close_loop

   !> Newton on the pressure that UINTER returns, from the inverse of the law. Zero pressure is
   !> the separation at which the point has just opened.
   subroutine reach_pressure(point, properties, pressure, dtime, error)
      type(host_point), intent(inout) :: point
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: pressure, dtime
      type(error_type), allocatable, intent(out) :: error
      type(contact_state) :: start
      real(wp) :: overclosure, wanted
      integer :: iteration

      wanted = max(pressure, 0.5_wp*properties%p_open)
      call state_from_statev(point%start%statev, start)
      call overclosure_for(properties, start, wanted, overclosure, error)
      if (allocated(error)) return
      do iteration = 1, max_iterations
         call try_increment(point, overclosure, [0.0_wp], dtime, error)
         if (allocated(error)) return
         associate (p => point%trial%stress(1))
            ! the pressure can be met to the round-off of the overclosure
            if (abs(p - wanted) <= pressure_tolerance*wanted + point%trial%ddsddr(1, 1) &
               *4.0_wp*spacing(max(abs(overclosure), abs(properties%initial_separation)))) return
            overclosure = overclosure + (wanted - p)/point%trial%ddsddr(1, 1)
         end associate
      end do
      call fatal_error(error, 'no overclosure found for pressure = '//to_text(pressure)//' MPa', &
         computation_error)
   end subroutine reach_pressure

   !> What happened in the accepted increment.
   pure function step_of(point, properties) result(step)
      type(host_point), intent(in) :: point
      type(contact_properties), intent(in) :: properties
      type(press_step) :: step
      type(normal_response) :: normal
      type(contact_state) :: state

      call state_from_statev(point%start%statev, state)
      step%time = point%start%time(1)
      step%overclosure = point%start%rdisp(1)
      step%separation = properties%initial_separation - step%overclosure
      step%pressure = point%start%stress(1)
      step%stiffness = point%start%ddsddr(1, 1)
      step%energy = point%start%sed
      step%plastic_dissipation = point%start%spd
      step%closest_separation = properties%initial_separation - state%largest_closure
      step%status = point%start%lstate
      normal = law_at(properties, state)
      step%area_fraction = normal%area_fraction
      step%contact_density = normal%contact_density
      step%elastic_share = normal%elastic_share
      step%elastoplastic_share = normal%elastoplastic_share
      step%plastic_share = normal%plastic_share
      step%validity = normal%validity
   end function step_of

   !> Refuse a peak that is most likely in another unit.
   pure subroutine check_peak(settings, peak, properties, error)
      type(press_settings), intent(in) :: settings
      real(wp), intent(in) :: peak
      type(contact_properties), intent(in) :: properties
      type(error_type), allocatable, intent(out) :: error

      if (settings%control == 'pressure') then
         associate (hardness => properties%normal%hardness)
            call check_between(error, 'peak', peak, least_pressure*hardness, &
               largest_pressure*hardness, 'MPa', settings%accept_sizes)
         end associate
      else
         ! what lies between the datum and mean planes in touch comes before
         associate (sigma => properties%normal%sigma)
            call check_between(error, 'peak', peak, least_closure*sigma, &
               max(properties%initial_separation, 0.0_wp) + past_mean*sigma, 'mm', &
               settings%accept_sizes)
         end associate
      end if
   end subroutine check_peak

   pure subroutine check_settings(settings, peaks, error)
      type(press_settings), intent(in) :: settings
      real(wp), intent(in) :: peaks(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (settings%control /= 'pressure' .and. settings%control /= 'overclosure') then
         call fatal_error(error, "control = '"//trim(settings%control)// &
            "' is unknown: it must be 'pressure' or 'overclosure'", subject='control')
      else if (settings%increments < 1 .or. settings%increments > max_increments) then
         call fatal_error(error, 'increments = '//to_text(settings%increments)// &
            ' is not allowed: it must lie between 1 and '//to_text(max_increments), &
            subject='increments')
      else if (size(peaks) == 0) then
         call fatal_error(error, 'peak is empty: give at least one, in MPa or mm', subject='peak')
      else
         do i = 1, size(peaks)
            if (.not. allocated(error)) call check_positive(error, 'peak', peaks(i), 'MPa or mm')
         end do
         if (.not. allocated(error)) &
            call check_positive(error, 'step_time', settings%step_time, 's')
      end if
   end subroutine check_settings

end module asperity_replay_press
