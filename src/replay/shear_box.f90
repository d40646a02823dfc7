!> Direct shear of two discs under dead weight (the paper's Figs 13-18), every step through
!> UINTER. The weight fixes the pressure, so the box tests friction, not the normal law; the
!> closure under load is what the normal law says.
module asperity_replay_shear_box
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_abaqus_statev, only: state_elastic_slip_1, state_from_statev, state_normal_energy, &
      state_pressure_coupling
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_strength, only: largest_shear_stress
   use asperity_contact_point, only: overclosure_for
   use asperity_contact_properties, only: close_pressure_ratio, contact_properties
   use asperity_contact_state, only: contact_state
   use asperity_law_normal_law, only: normal_response
   use asperity_replay_abaqus_host, only: accept_increment, host_point, new_host_point, &
      refuse_cut, try_increment
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_normal, only: law_at
   use asperity_replay_shear_settings, only: box_path, check_shear_settings, current_area, &
      default_displacement, overlap_area, shear_settings
   implicit none
   private
   public :: shear_settings, shear_step, run_shear_box, overlap_area

   !> One increment of the replay. Energies are totals over the overlap, N mm; with a shrinking
   !> overlap the energy stored in the area that is lost stands in no ledger.
   type :: shear_step
      !> Time since the box moves, s
      real(wp) :: time = 0.0_wp
      !> Displacement of the box, relative motion of the faces, mm
      real(wp) :: displacement = 0.0_wp, slip = 0.0_wp
      !> Overclosure and separation, mm; separation over sigma
      real(wp) :: overclosure = 0.0_wp, separation = 0.0_wp, separation_over_sigma = 0.0_wp
      !> Area of the discs' overlap, mm^2
      real(wp) :: overlap_area = 0.0_wp
      !> Normal stress on the overlap, MPa
      real(wp) :: normal_stress = 0.0_wp
      !> Shear force, N
      real(wp) :: shear_force = 0.0_wp
      !> Shear stress on the full disc and on the overlap, MPa
      real(wp) :: shear_stress_nominal = 0.0_wp, shear_stress = 0.0_wp
      !> Real area over overlap area
      real(wp) :: area_fraction = 0.0_wp
      !> Stored normal and tangential energy, N mm
      real(wp) :: normal_energy = 0.0_wp, tangential_energy = 0.0_wp
      !> Frictional dissipation and pressure coupling since the start, N mm
      real(wp) :: dissipation = 0.0_wp, pressure_coupling = 0.0_wp
      !> Plastic dissipation since the faces first touched, N mm
      real(wp) :: plastic_dissipation = 0.0_wp
      !> Shares of the pressure by stage
      real(wp) :: elastic_share = 1.0_wp, elastoplastic_share = 0.0_wp, plastic_share = 0.0_wp
      !> Contact status and validity flags
      integer :: status = 0, validity = 0
   end type shear_step

   integer, parameter :: max_iterations = 200
   !> Balance is found to this part of the pressure, and of gcrit
   real(wp), parameter :: balance_tolerance = 1.0e-11_wp
   real(wp), parameter :: seconds_per_minute = 60.0_wp
   procedure(uinter_interface) :: uinter

contains

   !> Replay a shear test. The first step is the seated box at rest. `error` is set when a setting
   !> is not allowed, balance is not found or UINTER broke its contract.
   subroutine run_shear_box(settings, properties, steps, error, failed)
      !> Specimen, load and path
      type(shear_settings), intent(in) :: settings
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Seated box, then every increment
      type(shear_step), allocatable, intent(out) :: steps(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> The motion up to what was tried last, where an increment failed; no rows elsewhere
      type(motion_path), intent(out), optional :: failed
      type(host_point) :: point
      real(wp), allocatable :: turns(:), path(:)
      integer :: i

      if (allocated(settings%displacement)) then
         allocate (turns, source=settings%displacement)
      else
         allocate (turns, source=[default_displacement])
      end if
      call check_shear_settings(settings, turns, error)
      if (allocated(error)) return
      if (settings%normal_stress <= close_pressure_ratio*properties%p_open) then
         call fatal_error(error, 'normal_stress = '//to_text(settings%normal_stress)// &
            ' MPa leaves the faces open: it must be above '// &
            to_text(close_pressure_ratio*properties%p_open, 3)//' MPa; check the units '// &
            '(N-mm-MPa)', subject='normal_stress')
         return
      end if
      call box_path(turns, settings%displacement_increment, path)
      call new_host_point(point, uinter, properties, ndir=2, keep_history=.false.)
      call check_work(to_text(size(path))//' increments', &
         int(storage_size(steps)/8, int64)*size(path), error)
      if (allocated(error)) return
      allocate (steps(size(path)))
      do i = 1, size(path)
         call balance(point, settings, properties, path(i), seconds_per_minute &
            *abs(path(i) - path(max(i - 1, 1)))/settings%rate, error)
         if (allocated(error)) then
            if (present(failed)) call keep_motion(failed, steps(:i - 1), point)
            return
         end if
         steps(i) = step_of(point, settings, properties, path(i))
         if (i > 1) call add_energies(steps(i), steps(i - 1), point)
         call accept_increment(point)
      end do
   end subroutine run_shear_box

   !> The motion of the increments that are done and of the last trial.
   pure subroutine keep_motion(path, steps, point)
      type(motion_path), intent(out) :: path
      type(shear_step), intent(in) :: steps(:)
      type(host_point), intent(in) :: point
      integer :: n

      n = size(steps) + 1
      associate (asked => point%trial)
         path%time = [steps%time, asked%time(1)]
         path%overclosure = [steps%overclosure, asked%rdisp(1)]
         allocate (path%slip(2, n), path%expected(3, n), source=0.0_wp)
         path%slip(1, :) = [steps%slip, asked%rdisp(2)]
      end associate
   end subroutine keep_motion

   !> Find overclosure and slip so that the pressure carries the weight and the slip plus the
   !> specimens' shear is the displacement of the box: Newton with the tangent of UINTER. The slip
   !> stays in a bracket, since the shear stress never falls with it.
   subroutine balance(point, settings, properties, displacement, dtime, error)
      type(host_point), intent(inout) :: point
      type(shear_settings), intent(in) :: settings
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: displacement, dtime
      type(error_type), allocatable, intent(out) :: error
      type(contact_state) :: start
      real(wp) :: pressure, area, compliance, overclosure, slip, low, high, strength
      real(wp) :: r(2), j(2, 2), allowed(2), determinant
      integer :: iteration

      area = current_area(settings, displacement)
      pressure = settings%normal_stress*overlap_area(settings%diameter, 0.0_wp)/area
      compliance = settings%shear_compliance*area
      call state_from_statev(point%start%statev, start)
      call overclosure_for(properties, start, pressure, overclosure, error)
      if (allocated(error)) return
      strength = largest_shear_stress(properties, pressure, moves=.false.)
      low = displacement - 1.01_wp*compliance*strength
      high = displacement + 1.01_wp*compliance*strength
      slip = min(max(displacement - compliance*point%start%stress(2), low), high)
      do iteration = 1, max_iterations
         call try_increment(point, overclosure, [slip - point%start%rdisp(2)], dtime, error)
         if (.not. allocated(error)) call refuse_cut(point, error)
         if (allocated(error)) return
         associate (stress => point%trial%stress, tangent => point%trial%ddsddr)
            r = [stress(1) - pressure, slip + compliance*stress(2) - displacement]
            ! no closer than round-off of overclosure and displacement allows
            allowed = balance_tolerance*[pressure, properties%critical_slip] &
               + 4.0_wp*[tangent(1, 1)*spacing(max(abs(overclosure), &
               abs(properties%initial_separation))), spacing(max(abs(displacement), abs(high)))]
            if (all(abs(r) <= allowed)) return
            if (r(2) > 0.0_wp) then
               high = slip
            else
               low = slip
            end if
            j(1, :) = tangent(1, :)
            j(2, :) = compliance*tangent(2, :) + [0.0_wp, 1.0_wp]
         end associate
         determinant = j(1, 1)*j(2, 2) - j(1, 2)*j(2, 1)
         if (.not. abs(determinant) > 0.0_wp) exit
         overclosure = overclosure - (j(2, 2)*r(1) - j(1, 2)*r(2))/determinant
         slip = slip - (j(1, 1)*r(2) - j(2, 1)*r(1))/determinant
         if (.not. (slip > low .and. slip < high)) slip = 0.5_wp*(low + high)
      end do
      call fatal_error(error, 'no balance found at displacement = '//to_text(displacement)// &
         ' mm; try a smaller displacement_increment', computation_error)
   end subroutine balance

   !> What happened in the trial that balances.
   pure function step_of(point, settings, properties, displacement) result(step)
      type(host_point), intent(in) :: point
      type(shear_settings), intent(in) :: settings
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: displacement
      type(shear_step) :: step
      type(contact_state) :: state
      type(normal_response) :: normal

      associate (trial => point%trial)
         step%time = trial%time(1)
         step%displacement = displacement
         step%slip = trial%rdisp(2)
         step%overclosure = trial%rdisp(1)
         step%separation = properties%initial_separation - step%overclosure
         step%separation_over_sigma = step%separation/properties%normal%sigma
         step%overlap_area = current_area(settings, displacement)
         step%normal_stress = trial%stress(1)
         step%shear_stress = trial%stress(2)
         step%shear_force = step%overlap_area*step%shear_stress
         step%shear_stress_nominal = step%shear_force/overlap_area(settings%diameter, 0.0_wp)
         step%normal_energy = step%overlap_area*trial%statev(state_normal_energy)
         step%tangential_energy = step%overlap_area*0.5_wp*trial%stress(2) &
            *trial%statev(state_elastic_slip_1)
         if (.not. properties%friction_is_plain) step%tangential_energy = step%overlap_area &
            *(trial%sed - trial%statev(state_normal_energy))
         step%plastic_dissipation = step%overlap_area*trial%spd
         step%status = trial%lstate
      end associate
      call state_from_statev(point%trial%statev, state)
      normal = law_at(properties, state)
      step%area_fraction = normal%area_fraction
      step%elastic_share = normal%elastic_share
      step%elastoplastic_share = normal%elastoplastic_share
      step%plastic_share = normal%plastic_share
      step%validity = normal%validity
   end function step_of

   !> Add what the increment dissipated and coupled, on the overlap at its end.
   pure subroutine add_energies(step, last, point)
      type(shear_step), intent(inout) :: step
      type(shear_step), intent(in) :: last
      type(host_point), intent(in) :: point

      step%dissipation = last%dissipation + step%overlap_area*point%trial%sfd
      step%pressure_coupling = last%pressure_coupling + step%overlap_area &
         *(point%trial%statev(state_pressure_coupling) - &
         point%start%statev(state_pressure_coupling))
      step%plastic_dissipation = last%plastic_dissipation + step%plastic_dissipation
   end subroutine add_energies

end module asperity_replay_shear_box
