!> Records that are not fitted: how far the model with the values found is from them, beside those
!> that are.
module asperity_program_commands_fit_hold_out
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_fit_problem, only: fit_problem
   use asperity_program_commands_fit_kind, only: fit_kind
   use asperity_program_commands_fit_record_input, only: fit_record, record_input, &
      record_quantities, samples_of
   use asperity_program_record_columns, only: record_column
   use asperity_program_report_table, only: column_counts, new_table, table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: follow_hold_out, read_hold_out, record_table

   integer, parameter :: longest = 80, figures = 3

contains

   !> Read them, before a search that may be long. `error` is set when one cannot be read or is of
   !> another kind.
   subroutine read_hold_out(kind, input, files, free, problem, records, error)
      !> The kind, with the records that are fitted
      class(fit_kind), intent(in) :: kind
      !> How records are written, as given
      type(record_input), intent(in) :: input
      !> Paths of those that are not fitted
      type(string_type), intent(in) :: files(:)
      !> Names of the free keys
      type(string_type), intent(in) :: free(:)
      !> Their problem, not there where there are no files
      class(fit_problem), allocatable, intent(out) :: problem
      !> The records, none where there are no files
      type(fit_record), allocatable, intent(out) :: records(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      class(fit_kind), allocatable :: own
      type(record_input) :: own_input
      type(record_column) :: columns(2)
      real(wp), allocatable :: scale(:)

      allocate (records(0))
      if (size(files) == 0) return
      allocate (own, source=kind)
      own_input = input
      call own_input%read(files, kind%choices, own%quantities, records, columns, error)
      if (allocated(error)) return
      if (any(own%quantities%holds /= kind%quantities%holds)) then
         call fatal_error(error, '--hold-out: '//files(1)%text//' has '//columns(1)%name// &
            ' and '//columns(2)%name//', the records that are fitted have not')
         return
      end if
      call own%take_records(records, error)
      if (.not. allocated(error)) then
         allocate (scale(samples_of(records)), source=1.0_wp)
         call own%make_problem(free, scale, problem, error)
      end if
      if (allocated(error)) error%message = '--hold-out: '//files(1)%text//': '//error%message
   end subroutine read_hold_out

   !> Follow them with the values found. `error` is set when one cannot be followed.
   subroutine follow_hold_out(problem, records, values, model, error)
      !> Their problem, where there are any
      class(fit_problem), allocatable, intent(in) :: problem
      !> The records
      type(fit_record), intent(in) :: records(:)
      !> Values of the free keys
      real(wp), intent(in) :: values(:)
      !> The model at the samples of all of them
      real(wp), allocatable, intent(out) :: model(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      allocate (model(samples_of(records)))
      if (.not. allocated(problem)) return
      call problem%residuals(values, model, error)
      if (allocated(error)) then
         error%message = '--hold-out: '//error%message
      else
         ! they are differences over a scale of 1
         model = model + [(records(i)%y, i=1, size(records))]
      end if
   end subroutine follow_hold_out

   !> One row a record.
   pure function record_table(quantities, files, records, model, held_out_files, held_out, &
         held_out_model) result(table)
      !> What the columns of the records are
      type(record_quantities), intent(in) :: quantities
      !> Paths of the records that are fitted, and of those that are not
      type(string_type), intent(in) :: files(:), held_out_files(:)
      !> The former, and the model at their samples
      type(fit_record), intent(in) :: records(:)
      real(wp), intent(in) :: model(:)
      !> The latter, and the model at theirs
      type(fit_record), intent(in) :: held_out(:)
      real(wp), intent(in) :: held_out_model(:)
      type(table_type) :: table
      character(len=longest) :: titles(size(records) + size(held_out))
      real(wp), dimension(size(titles)) :: mean, share, largest
      integer :: samples(size(titles)), n
      character(len=3) :: fitted(size(titles))

      n = size(records)
      fitted = 'yes'
      fitted(n + 1:) = 'no'
      call compare(files, records, model, titles(:n), samples(:n), mean(:n), share(:n), largest(:n))
      call compare(held_out_files, held_out, held_out_model, titles(n + 1:), samples(n + 1:), &
         mean(n + 1:), share(n + 1:), largest(n + 1:))
      table = new_table(columns=6, rows=size(titles))
      call table%add_texts('record', titles)
      call table%add_texts('fitted', fitted)
      call table%add_codes('samples', column_counts, samples)
      call table%add_numbers('root_mean_square', trim(quantities%units(2)), mean, figures=figures)
      call table%add_numbers('of_largest', '%', 100.0_wp*share, figures=figures)
      call table%add_numbers('largest_difference', trim(quantities%units(2)), largest, &
         figures=figures)
   end function record_table

   !> Differences of some records.
   pure subroutine compare(files, records, model, titles, samples, mean, share, largest)
      type(string_type), intent(in) :: files(:)
      type(fit_record), intent(in) :: records(:)
      real(wp), intent(in) :: model(:)
      character(len=longest), intent(out) :: titles(:)
      integer, intent(out) :: samples(:)
      !> Root mean square, the same over the record's largest reading, and the largest difference
      real(wp), intent(out) :: mean(:), share(:), largest(:)
      integer :: first, i

      first = 1
      do i = 1, size(records)
         titles(i) = records(i)%title
         if (size(files) == 1) titles(i) = trim(files(1)%text//' '//records(i)%title)
         samples(i) = size(records(i)%y)
         associate (y => records(i)%y, fitted => model(first:first + samples(i) - 1))
            mean(i) = norm2(fitted - y)/sqrt(real(samples(i), wp))
            share(i) = mean(i)/maxval(abs(y))
            largest(i) = maxval(abs(fitted - y))
         end associate
         first = first + samples(i)
      end do
   end subroutine compare

end module asperity_program_commands_fit_hold_out
