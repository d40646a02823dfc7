!> Who watches a solid joint run: tells a terminal how far it is, keeps what the pictures show, and
!> writes the checkpoint after every stroke.
module asperity_program_commands_solid_observer
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_solid_checkpoint, only: checkpoint_file
   use asperity_program_commands_solid_snapshot, only: no_snapshot, snapshot_kind, &
      solid_snapshot, take_snapshot
   use asperity_program_commands_solid_vtk_files, only: write_vtk_step
   use asperity_program_system_progress, only: show_stage
   use asperity_solid_model_settings, only: fit_increments, large_amplitude
   use asperity_solid_solve_programme, only: solid_observer, solid_run
   use asperity_solid_solve_times, only: seconds_now
   implicit none
   private
   public :: run_observer, new_observer, seconds_of

   !> The observer of one model.
   type, extends(solid_observer) :: run_observer
      !> What is under way, such as `solid: rough law`
      character(len=:), allocatable :: name
      !> Where the run is kept
      type(checkpoint_file) :: checkpoint
      !> Folder of files for ParaView, empty for none
      character(len=:), allocatable :: vtk
      !> Whether this is the rank that tells and writes
      logical :: is_first = .true.
      !> What was looked at
      type(solid_snapshot), allocatable :: snapshots(:)
      !> Time spent before this process, s, and when it began
      real(wp) :: seconds_before = 0.0_wp
      real(wp), private :: began = 0.0_wp
   contains
      procedure :: wants_whole, after_increment, after_stroke
   end type run_observer

contains

   !> Begin to watch.
   subroutine new_observer(observer, name, checkpoint, vtk, is_first)
      !> Result
      type(run_observer), intent(out) :: observer
      !> What is under way
      character(len=*), intent(in) :: name
      !> Where the run is kept
      type(checkpoint_file), intent(in) :: checkpoint
      !> Folder of files for ParaView, empty for none
      character(len=*), intent(in) :: vtk
      !> Whether this is the rank that tells and writes
      logical, intent(in) :: is_first

      observer%name = name
      observer%is_first = is_first
      observer%checkpoint = checkpoint
      observer%vtk = vtk
      allocate (observer%snapshots(0))
      observer%began = seconds_now()
   end subroutine new_observer

   !> Time that a run has taken, s.
   real(wp) function seconds_of(observer)
      !> Its observer
      type(run_observer), intent(in) :: observer

      seconds_of = observer%seconds_before + seconds_now() - observer%began
   end function seconds_of

   !> Whether pictures are made of an increment.
   logical function wants_whole(self, run)
      class(run_observer), intent(in) :: self
      type(solid_run), intent(in) :: run

      wants_whole = allocated(self%snapshots) .and. snapshot_kind(run) /= no_snapshot
   end function wants_whole

   !> Show how far the run is, and keep what the pictures show.
   subroutine after_increment(self, run, error)
      class(run_observer), intent(inout) :: self
      type(solid_run), intent(in) :: run
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      real(wp) :: share, left
      integer :: kind

      share = min(run%increments/real(expected_increments(run), wp), 1.0_wp)
      left = seconds_of(self)*(1.0_wp/share - 1.0_wp)
      text = ', at rest'
      if (run%strokes_done >= 0) text = ', stroke '//to_text(run%strokes_done + 1)//' of '// &
         to_text(size(run%model%turns) - 1)//', '//to_text(nint(100.0_wp*share))//' %, about '// &
         time_words(left)//' left'
      if (self%is_first) call show_stage(self%name//text)
      kind = snapshot_kind(run)
      if (kind /= no_snapshot) call keep(self%snapshots, run, kind)
   end subroutine after_increment

   !> One snapshot more.
   subroutine keep(snapshots, run, kind)
      type(solid_snapshot), allocatable, intent(inout) :: snapshots(:)
      type(solid_run), intent(in) :: run
      integer, intent(in) :: kind
      type(solid_snapshot), allocatable :: more(:)
      integer :: i

      ! one by one: gfortran 12 frees twice what an array constructor shares
      allocate (more(size(snapshots) + 1))
      do i = 1, size(snapshots)
         more(i) = snapshots(i)
      end do
      more(size(more)) = take_snapshot(run, kind)
      call move_alloc(more, snapshots)
   end subroutine keep

   !> Keep the run, and write the end of the stroke for ParaView.
   subroutine after_stroke(self, run, error)
      class(run_observer), intent(inout) :: self
      type(solid_run), intent(in) :: run
      type(error_type), allocatable, intent(out) :: error

      if (.not. self%is_first) return
      if (self%vtk /= '' .and. run%strokes_done > 0) call write_vtk_step(self%vtk, run, error)
      if (.not. allocated(error)) &
         call self%checkpoint%save(run, self%snapshots, seconds_of(self), error)
   end subroutine after_stroke

   !> Increments of the whole programme, if none is halved.
   pure integer function expected_increments(run) result(n)
      type(solid_run), intent(in) :: run
      integer :: i

      n = 1 + fit_increments
      associate (turns => run%model%turns, each => run%model%settings%stroke_increments)
         do i = 2, size(turns)
            n = n + each*merge(2, 1, max(abs(turns(i - 1)), abs(turns(i))) > large_amplitude)
         end do
      end associate
   end function expected_increments

   !> A time in the unit that suits it.
   pure function time_words(seconds) result(words)
      real(wp), intent(in) :: seconds
      character(len=:), allocatable :: words

      if (seconds < 90.0_wp) then
         words = to_text(nint(seconds))//' s'
      else if (seconds < 5400.0_wp) then
         words = to_text(nint(seconds/60.0_wp))//' min'
      else
         words = to_text(seconds/3600.0_wp, 2)//' h'
      end if
   end function time_words

end module asperity_program_commands_solid_observer
