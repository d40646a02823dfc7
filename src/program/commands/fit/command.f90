!> `asperity fit`: parameters of a model from a record.
module asperity_program_commands_fit_command
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_problem, only: fit_problem
   use asperity_fit_types, only: fit_result, fit_settings
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_read_faces, only: read_faces
   use asperity_program_commands_fit_case_out, only: fit_case
   use asperity_program_commands_fit_free_keys, only: fix_keys, read_free, set_bounds, set_starts
   use asperity_program_commands_fit_hold_out, only: follow_hold_out, read_hold_out, record_table
   use asperity_program_commands_fit_joint, only: new_joint_kind
   use asperity_program_commands_fit_keys, only: fit_options
   use asperity_program_commands_fit_kind, only: fit_kind
   use asperity_program_commands_fit_model_case, only: read_model
   use asperity_program_commands_fit_plot, only: fit_picture
   use asperity_program_commands_fit_press, only: new_press_kind
   use asperity_program_commands_fit_shear, only: new_shear_kind
   use asperity_program_commands_fit_record_input, only: fit_record, record_input, samples_of, &
      scale_of
   use asperity_program_commands_fit_tables, only: correlation_table, curve_table, &
      direction_table, fixed_table, parameter_table, quality_table
   use asperity_program_commands_fit_words, only: check_explained, check_settled, &
      pronoun, residual_remarks
   use asperity_program_input_key, only: given_as_option
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_table, only: columns_table
   use asperity_program_report_report, only: named_table, report_type
   use asperity_program_system_strings, only: escaped, string_type
   implicit none
   private
   public :: fit_command

   !> Fits a model to a record.
   type, extends(command_type) :: fit_command
      private
      type(fit_options) :: options
   contains
      procedure :: describe, declare, check, run
   end type fit_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(fit_command), intent(inout) :: self

      self%name = 'fit'
      self%summary = 'parameters of the law from a record of a test'
      self%usage = 'FILE.csv --kind KIND --free KEY,... [options]'
      self%purpose = 'From a record to numbers of the model: which values meet it best (least '// &
         'squares), how sure they are, and which of them the record cannot tell. What is '// &
         'neither free nor fixed by --fix or --model is asked for.'
      self%headings(2) = 'Model and record'
      self%takes_case = .false.
   end subroutine describe

   !> Model and record.
   pure subroutine declare(self, keys)
      !> The command
      class(fit_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%options%declare(keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the options.
   subroutine check(self, error)
      !> The command
      class(fit_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      call self%options%check(error)
   end subroutine check

   !> Read the record, fit, and report. `error` names what is wrong.
   subroutine run(self, report, error)
      !> The command
      class(fit_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      class(fit_kind), allocatable :: kind
      type(string_type), allocatable :: free(:)
      type(fit_record), allocatable :: records(:)
      type(record_column) :: columns(2)
      type(fit_parameter), allocatable :: parameters(:)
      type(fit_settings) :: settings
      type(fit_result) :: result
      class(fit_problem), allocatable, target :: problem
      ! what is held out
      class(fit_problem), allocatable :: other_problem
      type(fit_record), allocatable :: held_out(:)
      real(wp), allocatable :: scale(:), readings(:), model(:), held_out_model(:)
      type(record_input) :: input
      integer :: i

      ! as it is given, before columns are found
      input = self%options%input
      ! one kind a line
      if (self%options%kind == 'press') call new_press_kind(kind)
      if (self%options%kind == 'shear') call new_shear_kind(kind)
      if (self%options%kind == 'joint') call new_joint_kind(kind)
      call set_model(self%options, kind, free, error)
      if (.not. allocated(error)) &
         call self%options%input%read(self%options%input%files, kind%choices, &
         kind%quantities, records, columns, error)
      if (allocated(error)) return
      call kind%take_records(records, error)
      if (allocated(error)) then
         error%message = files_text(self%options)//': '//error%message
         return
      end if
      call make_parameters(self%options, kind, free, parameters, error)
      if (allocated(error)) return
      scale = scale_of(self%options%residual_scale, records)
      call kind%make_problem(free, scale, problem, error)
      if (allocated(error)) then
         error%message = files_text(self%options)//': '//error%message
         return
      end if
      call read_hold_out(kind, input, self%options%hold_out, free, other_problem, held_out, error)
      if (allocated(error)) return
      if (self%options%searches == 0) then
         self%options%searches = kind%usual_searches
         self%options%searches_source = 'usual for '//trim(self%options%kind)
      end if
      settings%searches = self%options%searches
      call fit_least_squares(problem, samples_of(records), parameters, settings, result, error)
      if (.not. allocated(error)) call check_settled(parameters, result, error)
      if (allocated(error)) then
         error%message = files_text(self%options)//': '//error%message
         return
      end if
      call give(kind, parameters, result%values, 'fitted', error)
      if (.not. allocated(error)) then
         readings = [(records(i)%y, i=1, size(records))]
         model = readings + scale*result%residuals
         call check_explained(readings, model, error)
         if (allocated(error)) error%message = files_text(self%options)//': '//error%message
      end if
      if (.not. allocated(error)) call follow_hold_out(other_problem, held_out, &
         result%values, held_out_model, error)
      if (allocated(error)) return
      call add_results(self, kind, free, records, columns, parameters, result, model, report)
      if (size(records) + size(held_out) > 1) report%more = [report%more, named_table('records', &
         'Records', record_table(kind%quantities, self%options%input%files, records, model, &
         self%options%hold_out, held_out, held_out_model))]
   end subroutine run

   !> Set what is fixed, and find what is free. `error` names what is neither.
   subroutine set_model(options, kind, free, error)
      type(fit_options), intent(in) :: options
      class(fit_kind), intent(inout) :: kind
      type(string_type), allocatable, intent(out) :: free(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: names

      call kind%declare()
      call fix_keys(options%fix, kind%keys, error)
      if (.not. allocated(error)) call read_free(options%free, kind%keys, free, error)
      if (.not. allocated(error)) call read_model(options%model, kind%keys, error)
      if (.not. allocated(error)) call read_faces(kind%keys, error)
      if (.not. allocated(error)) call declare_again(kind, error)
      if (allocated(error)) return
      names = kind%missing(free)
      if (names /= '') call fatal_error(error, 'nothing says '//escaped(names, ' ', ', ')// &
         ': free '//pronoun(names)//', or fix '//pronoun(names)//' by --fix, --model or a '// &
         'pair (--fix pair=NAME)')
   end subroutine set_model

   !> Declare the keys of the model with their values.
   subroutine declare_again(kind, error)
      class(fit_kind), intent(inout) :: kind
      type(error_type), allocatable, intent(out) :: error

      call kind%declare()
      if (.not. allocated(kind%keys%error)) return
      error = kind%keys%error
      call kind%keys%with_place(error)
   end subroutine declare_again

   !> Starts and bounds of the free keys.
   subroutine make_parameters(options, kind, free, parameters, error)
      type(fit_options), intent(in) :: options
      class(fit_kind), intent(inout) :: kind
      type(string_type), intent(in) :: free(:)
      type(fit_parameter), allocatable, intent(out) :: parameters(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      allocate (parameters(size(free)))
      do i = 1, size(free)
         call kind%parameter_of(free(i)%text, parameters(i), error)
         if (allocated(error)) return
      end do
      call set_bounds(options%bounds, parameters, error)
      if (.not. allocated(error)) call set_starts(options%start, parameters, error)
      if (.not. allocated(error)) call give(kind, parameters, parameters%start, 'start', error)
   end subroutine make_parameters

   !> Give the free keys values.
   subroutine give(kind, parameters, values, source, error)
      class(fit_kind), intent(inout) :: kind
      type(fit_parameter), intent(in) :: parameters(:)
      real(wp), intent(in) :: values(:)
      character(len=*), intent(in) :: source
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(parameters)
         associate (key => kind%keys%rows(kind%keys%find(trim(parameters(i)%name))))
            key%values = [values(i)]
            key%given = given_as_option
            key%has_value = .true.
            key%source = source
         end associate
      end do
      call declare_again(kind, error)
   end subroutine give

   !> Paths of the files.
   pure function files_text(options) result(text)
      type(fit_options), intent(in) :: options
      character(len=:), allocatable :: text
      integer :: i

      associate (files => options%input%files)
         text = files(1)%text
         do i = 2, size(files)
            text = text//', '//files(i)%text
         end do
      end associate
   end function files_text

   !> Tables, remarks, picture, case file.
   subroutine add_results(self, kind, free, records, columns, parameters, result, model, report)
      class(fit_command), intent(inout) :: self
      class(fit_kind), intent(in) :: kind
      type(string_type), intent(in) :: free(:)
      type(fit_record), intent(in) :: records(:)
      type(record_column), intent(in) :: columns(2)
      type(fit_parameter), intent(in) :: parameters(:)
      type(fit_result), intent(in) :: result
      real(wp), intent(in) :: model(:)
      type(report_type), intent(inout) :: report
      type(string_type), allocatable :: lines(:)

      report%table = curve_table(kind%quantities, records, model)
      report%shows_table = .false.
      report%summary = parameter_table(parameters, result)
      allocate (report%more(5))
      report%more(1) = named_table('fixed', 'Fixed', fixed_table(kind%keys, free))
      report%more(2) = named_table('quality', 'Model and record', quality_table(kind%quantities, &
         report%table%columns(report%table%set)%values, result))
      report%more(3) = named_table('correlations', 'Correlations', &
         correlation_table(parameters, result))
      report%more(4) = named_table('directions', 'What the record tells apart, best known first', &
         direction_table(parameters, result))
      report%more(5) = named_table('columns', '', columns_table(columns))
      call kind%remarks(lines)
      report%remarks = [residual_remarks(parameters, result), lines]
      allocate (report%decks(1))
      report%decks(1)%option = 'case'
      report%decks(1)%text = fit_case(kind, files_text(self%options), parameters, result)
      call self%declare(report%keys)
      report%picture_title = files_text(self%options)
      if (report%is_drawn()) report%pictures = [fit_picture(kind%quantities, records, model)]
   end subroutine add_results

end module asperity_program_commands_fit_command
