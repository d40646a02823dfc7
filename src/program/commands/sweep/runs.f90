!> `--sweep` of commands that draw one picture: a run of its own for every combination, then all
!> tables and pictures in one.
module asperity_program_commands_sweep_runs
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_sweep_cases, only: axis_type, combinations, new_axes, set_case
   use asperity_program_commands_sweep_columns, only: case_words, hide_swept
   use asperity_program_commands_sweep_joined_pictures, only: join_pictures
   use asperity_program_commands_sweep_joined_tables, only: join_tables
   use asperity_program_input_key, only: given_nowhere, name_length
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: run_sweep

contains

   !> Run all combinations, each as if its values had been given. `error` names the combination that
   !> is refused or fails.
   subroutine run_sweep(command, report, error)
      !> The command, with its sweep
      class(command_type), intent(in) :: command
      !> With the keys, of which those swept are hidden; tables and picture are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(axis_type), allocatable :: axes(:)
      type(report_type), allocatable :: cases(:)
      type(report_type) :: empty
      type(string_type), allocatable :: legends(:)
      type(key_list) :: keys
      integer :: i, n, place

      ! gfortran warns otherwise of what is intent(out) anyway
      allocate (axes(0))
      call new_axes(axes, command%sweep, report%keys, error)
      if (allocated(error)) return
      keys = report%keys
      ! what is run is one combination
      place = keys%find('sweep')
      keys%rows(place)%given = given_nowhere
      keys%rows(place)%text = ''
      n = combinations(axes)
      allocate (legends(n))
      ! gfortran warns of its own initial values without a source
      allocate (cases(n), source=empty)
      do i = 1, n
         legends(i)%text = case_words(axes, i)
         call run_case(command, keys, axes, i, cases(i), error)
         ! results and tables of all
         if (.not. allocated(error) .and. i == 1) call check_work(to_text(n)//' combinations', &
            20_int64*n*cases(1)%table%rows*cases(1)%table%set, error)
         if (.not. allocated(error)) cycle
         error%message = '--sweep, '//legends(i)%text//': '//error%message
         return
      end do

      call join_tables(report%table, keys, axes, cases%table, error)
      if (.not. allocated(error) .and. cases(1)%summary%set > 0) &
         call join_tables(report%summary, keys, axes, cases%summary, error)
      if (allocated(error)) return
      call join_rows(report, cases, keys, axes)
      report%faces = common_words(cases)
      call join_remarks(report, cases, legends)
      if (report%is_drawn()) call join_pictures(report, cases, legends)
      call hide_swept(report%keys, axes)
   end subroutine run_sweep

   !> One combination.
   subroutine run_case(command, keys, axes, which, report, error)
      class(command_type), intent(in) :: command
      type(key_list), intent(in) :: keys
      type(axis_type), intent(in) :: axes(:)
      integer, intent(in) :: which
      type(report_type), intent(out) :: report
      type(error_type), allocatable, intent(out) :: error
      class(command_type), allocatable :: own

      allocate (own, mold=command)
      call own%describe()
      report%name = own%name
      report%keys = keys
      call set_case(report%keys, axes, which)
      call own%declare(report%keys)
      if (allocated(report%keys%error)) then
         error = report%keys%error
      else
         call own%check(error)
      end if
      if (.not. allocated(error)) call own%run(report, error)
      if (allocated(error)) call report%keys%with_place(error)
   end subroutine run_case

   !> Which rows are shown, and of which columns.
   pure subroutine join_rows(report, cases, keys, axes)
      type(report_type), intent(inout) :: report
      type(report_type), intent(in) :: cases(:)
      type(key_list), intent(in) :: keys
      type(axis_type), intent(in) :: axes(:)
      integer :: i, widest

      report%first_rows = [1]
      allocate (report%important(0))
      do i = 1, size(cases)
         associate (first => cases(i)%first_rows)
            report%first_rows = [report%first_rows, size(report%important) + first(2:)]
         end associate
         report%important = [report%important, cases(i)%important]
      end do
      widest = maxloc(cases%table%set, 1)
      if (allocated(cases(widest)%shown_columns)) report%shown_columns = &
         [character(len=name_length) :: keys%rows(axes%key)%name, cases(widest)%shown_columns]
   end subroutine join_rows

   !> The remarks of all cases, each with its case.
   pure subroutine join_remarks(report, cases, legends)
      type(report_type), intent(inout) :: report
      type(report_type), intent(in) :: cases(:)
      type(string_type), intent(in) :: legends(:)
      integer :: i, j

      allocate (report%remarks(0))
      do i = 1, size(cases)
         if (.not. allocated(cases(i)%remarks)) cycle
         do j = 1, size(cases(i)%remarks)
            call report%add_remark(legends(i)%text//': '//cases(i)%remarks(j)%text)
         end do
      end do
   end subroutine join_remarks

   !> What the faces of all cases are, if that is the same.
   pure function common_words(cases) result(text)
      type(report_type), intent(in) :: cases(:)
      character(len=:), allocatable :: text
      integer :: i

      text = cases(1)%faces
      do i = 2, size(cases)
         if (cases(i)%faces /= text) text = 'several faces'
      end do
   end function common_words

end module asperity_program_commands_sweep_runs
