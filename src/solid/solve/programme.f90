!> The programme of a solid joint: the column is loaded, the beam fitted, then the load goes from
!> turn to turn. Increments grow where they are easy and are halved where they are not solved.
module asperity_solid_solve_programme
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_contact_pair, only: forget_pattern
   use asperity_solid_engine_petsc, only: petsc_library
   use asperity_solid_material_material, only: material_point
   use asperity_solid_model_model, only: load_place, solid_model
   use asperity_solid_model_share, only: share_work
   use asperity_solid_model_settings, only: easy_iterations, few_iterations, fit_increments, &
      growth, large_amplitude, shortest_increment, shrinkage
   use asperity_solid_solve_equations, only: equation_system, load_state
   use asperity_solid_solve_energy, only: add_increment, energy_ledger
   use asperity_solid_solve_gather, only: gather_met_facets, gather_model
   use asperity_solid_solve_increment, only: increment_type, solve_increment
   use asperity_solid_solve_joints, only: find_joint_records, joint_record
   use asperity_solid_solve_record, only: increment_record, new_record
   implicit none
   private
   public :: solid_run, solid_observer, new_solid_run, run_programme

   !> A joint on its way through the programme. Between strokes it can be kept and taken up again:
   !> each begins without a pattern, factors or the increments before it.
   type :: solid_run
      !> The joint
      type(solid_model) :: model
      !> Its equations, made anew in every stroke
      type(equation_system) :: system
      !> Displacements now, and at the start of the last increment, mm
      real(wp), allocatable :: displacement(:, :), before(:, :)
      !> Energies
      type(energy_ledger) :: ledger
      !> Every increment of the strokes so far
      type(increment_record), allocatable :: records(:)
      !> The joints of a frame in each of them
      type(joint_record), allocatable :: joints(:, :)
      !> Strokes that are done; -1 before the beam is fitted
      integer :: strokes_done = -1
      !> Increments, iterations and increments that were halved, with those before the strokes
      integer :: increments = 0, iterations = 0, cutbacks = 0
   end type solid_run

   !> Who watches a run: progress, files. Of several ranks the first sees points and contact of all
   !> after a stroke, and after an increment that it wants whole; the others see their own.
   type, abstract :: solid_observer
   contains
      !> Whether the first rank is to see all of an increment, which no one wants unless it says so
      procedure :: wants_whole
      !> After an increment
      procedure(after), deferred :: after_increment
      !> After a stroke, and after the beam was fitted
      procedure(after), deferred :: after_stroke
   end type solid_observer

   abstract interface
      !> Look at the run. `error` is set to stop it.
      subroutine after(self, run, error)
         import :: error_type, solid_observer, solid_run
         implicit none
         !> The observer
         class(solid_observer), intent(inout) :: self
         !> The run
         type(solid_run), intent(in) :: run
         !> Set to stop it
         type(error_type), allocatable, intent(out) :: error
      end subroutine after
   end interface

contains

   !> A run at its beginning, its work shared by the ranks. `error` is set when it cannot be.
   subroutine new_solid_run(run, model, petsc, error)
      !> Result
      type(solid_run), intent(out) :: run
      !> The joint
      type(solid_model), intent(in) :: model
      !> PETSc, loaded
      type(petsc_library), intent(in) :: petsc
      !> Set when there are more ranks than elements, or METIS is missing
      type(error_type), allocatable, intent(out) :: error

      run%model = model
      run%system%solver%petsc = petsc
      call share_work(run%model, petsc%ranks, error)
      if (allocated(error)) return
      allocate (run%displacement(3, size(model%mesh%nodes, 2)), source=0.0_wp)
      run%before = run%displacement
      allocate (run%records(0), run%joints(0, 0))
      allocate (run%system%residual(model%n_unknowns), run%system%by_motion(model%n_unknowns))
   end subroutine new_solid_run

   !> Run what is left of the programme. `error` is set when no increment is small enough, or the
   !> engine or the observer fails; the run then stands at the last increment that was solved.
   subroutine run_programme(run, observer, error)
      !> The run
      type(solid_run), intent(inout) :: run
      !> Who watches
      class(solid_observer), intent(inout) :: observer
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      do while (run%strokes_done < size(run%model%turns) - 1)
         call begin_anew(run)
         if (run%strokes_done < 0) then
            call seat(run, observer, error)
         else
            call stroke(run, observer, error)
         end if
         if (allocated(error)) exit
         run%strokes_done = run%strokes_done + 1
         call after_stroke(run, observer, error)
         if (allocated(error)) exit
      end do
      call run%system%solver%release()
   end subroutine run_programme

   !> Whether an increment is wanted whole: all ranks must say the same.
   logical function wants_whole(self, run)
      !> The observer
      class(solid_observer), intent(in) :: self
      !> The run
      type(solid_run), intent(in) :: run

      wants_whole = .false.
      associate (unused => self, unused_too => run)
      end associate
   end function wants_whole

   !> Show the observers of all ranks an increment, and the first all of it where it asks for that.
   subroutine after_increment(run, observer, error)
      type(solid_run), intent(inout) :: run
      class(solid_observer), intent(inout) :: observer
      type(error_type), allocatable, intent(out) :: error

      if (observer%wants_whole(run)) call gather(run)
      call observer%after_increment(run, error)
      call run%system%solver%petsc%ranks%agree(error)
   end subroutine after_increment

   !> ... and a stroke, which the first sees whole.
   subroutine after_stroke(run, observer, error)
      type(solid_run), intent(inout) :: run
      class(solid_observer), intent(inout) :: observer
      type(error_type), allocatable, intent(out) :: error

      call gather(run)
      call gather_met_facets(run%model, run%system%solver%petsc%ranks)
      call observer%after_stroke(run, error)
      call run%system%solver%petsc%ranks%agree(error)
   end subroutine after_stroke

   subroutine gather(run)
      type(solid_run), intent(inout) :: run

      call gather_model(run%model, run%system%solver%petsc%ranks)
   end subroutine gather

   !> No pattern, no factors, no facets but those that are met.
   subroutine begin_anew(run)
      type(solid_run), intent(inout) :: run
      integer :: i

      call run%system%solver%release()
      do i = 1, size(run%model%pairs)
         call forget_pattern(run%model%pairs(i))
      end do
   end subroutine begin_anew

   !> Load the column and fit the beam.
   subroutine seat(run, observer, error)
      type(solid_run), intent(inout) :: run
      class(solid_observer), intent(inout) :: observer
      type(error_type), allocatable, intent(out) :: error
      type(increment_type) :: increment
      integer :: i

      do i = 0, merge(fit_increments, 0, run%model%swelling > 0.0_wp)
         increment = increment_type(load=load_state(1.0_wp, real(i, wp)/fit_increments), &
            is_soft=.true.)
         call try(run, increment, 0.0_wp, error)
         if (allocated(error)) return
         if (.not. increment%is_solved) then
            call fatal_error(error, 'the joint at rest has no equilibrium ('// &
               trim(merge('column load     ', 'fit of the sides', i == 0))//'): '// &
               increment%reason//'. A smaller side_pressure or mesh_size may help', &
               computation_error)
            return
         end if
         call keep(run, increment)
         if (i == 0 .and. run%model%swelling > 0.0_wp) cycle
         call after_increment(run, observer, error)
         if (allocated(error)) return
      end do
      run%ledger = energy_ledger()
      call add_increment(run%ledger, run%model, run%model%points, run%displacement, &
         run%system%load_force, run%system%solver%petsc%ranks)
   end subroutine seat

   !> One stroke.
   subroutine stroke(run, observer, error)
      type(solid_run), intent(inout) :: run
      class(solid_observer), intent(inout) :: observer
      type(error_type), allocatable, intent(out) :: error
      type(increment_type) :: increment
      real(wp) :: from, way, done, length, longest, last_motion
      integer :: hard
      logical :: is_fresh

      associate (turns => run%model%turns, settings => run%model%settings)
         from = turns(run%strokes_done + 1)
         way = turns(run%strokes_done + 2) - from
         longest = 1.0_wp/settings%stroke_increments
         if (max(abs(from), abs(from + way)) > large_amplitude) longest = 0.5_wp*longest
         length = longest
         ! a run that has failed goes on from where it stands
         done = (load_place(run%model, run%displacement) - from)/way
         is_fresh = .true.
         last_motion = 0.0_wp
         do while (done < 1.0_wp)
            ! what is left of the stroke is no increment of its own if it is next to nothing
            if (1.0_wp - done < length + shortest_increment) length = 1.0_wp - done
            increment = increment_type(motion=way*length, load=load_state(1.0_wp, 1.0_wp), &
               is_fresh=is_fresh)
            call try(run, increment, last_motion, error)
            if (allocated(error)) return
            if (increment%is_solved) then
               done = merge(1.0_wp, done + length, length >= 1.0_wp - done)
               last_motion = increment%motion
               is_fresh = .false.
               call keep(run, increment)
               call after_increment(run, observer, error)
               if (allocated(error)) return
               hard = max(settings%most_iterations - few_iterations, settings%most_iterations/2)
               if (increment%iterations > hard) then
                  length = max(shrinkage*length, shortest_increment)
               else if (increment%iterations <= min(easy_iterations, hard)) then
                  length = min(growth*length, longest)
               end if
            else if (.not. is_fresh) then
               ! the same increment from the tangent, before a shorter one
               is_fresh = .true.
            else
               length = 0.5_wp*length
               run%cutbacks = run%cutbacks + 1
               if (length >= shortest_increment) cycle
               call fatal_error(error, 'no increment is small enough in stroke '// &
                  to_text(run%strokes_done + 1)//' from '//to_text(from, 5)//' to '// &
                  to_text(from + way, 5)//' mm, at '//to_text(from + done*way, 6)//' mm: '// &
                  increment%reason, computation_error)
               return
            end if
         end do
      end associate
   end subroutine stroke

   !> Try an increment.
   subroutine try(run, increment, last_motion, error)
      type(solid_run), intent(inout) :: run
      type(increment_type), intent(inout) :: increment
      real(wp), intent(in) :: last_motion
      type(error_type), allocatable, intent(out) :: error
      type(material_point), allocatable :: points(:, :)

      allocate (points, source=run%model%points)
      call solve_increment(increment, run%model, run%system, run%displacement, run%before, &
         last_motion, error)
      if (.not. allocated(error) .and. increment%is_solved .and. run%strokes_done >= 0) &
         call add_increment(run%ledger, run%model, points, run%displacement, &
         run%system%load_force, run%system%solver%petsc%ranks)
      run%iterations = run%iterations + increment%iterations
   end subroutine try

   !> Count an increment, and record it in a stroke.
   subroutine keep(run, increment)
      type(solid_run), intent(inout) :: run
      type(increment_type), intent(in) :: increment
      type(increment_record) :: record
      type(joint_record), allocatable :: joints(:)

      run%increments = run%increments + 1
      if (run%strokes_done < 0) return
      call new_record(record, run%model, run%displacement, run%ledger, run%system%n_yielding, &
         run%strokes_done + 1, increment%iterations, run%system%solver%petsc%ranks)
      run%records = [run%records, record]
      call find_joint_records(joints, run%model, run%displacement, run%system%solver%petsc%ranks)
      run%joints = reshape([run%joints, joints], [size(joints), size(run%records)])
   end subroutine keep

end module asperity_solid_solve_programme
