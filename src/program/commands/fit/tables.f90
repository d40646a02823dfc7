!> Tables of a fit.
module asperity_program_commands_fit_tables
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_types, only: fit_result
   use asperity_program_commands_fit_record_input, only: fit_record, record_quantities
   use asperity_program_commands_fit_words, only: combination, durbin_watson
   use asperity_program_input_key, only: kind_integer, kind_logical, kind_real
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_table, only: column_counts, new_table, table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: correlation_table, curve_table, direction_table, fixed_table, parameter_table, &
      quality_table

   integer, parameter :: value_figures = 5, bound_figures = 3
   integer, parameter :: longest = 200

contains

   !> One row a free parameter.
   pure function parameter_table(parameters, result) result(table)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> What was found
      type(fit_result), intent(in) :: result
      type(table_type) :: table
      character(len=16) :: units(size(parameters))

      units = parameters%unit
      where (units == '') units = '-'
      table = new_table(columns=8, rows=size(parameters))
      call table%add_texts('parameter', parameters%name)
      call table%add_texts('unit', units)
      call table%add_numbers('value', '-', result%values, figures=value_figures)
      call table%add_numbers('low_95', '-', result%lower, figures=value_figures)
      call table%add_numbers('high_95', '-', result%upper, figures=value_figures)
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      call table%add_numbers('start', '-', (parameters%start), figures=bound_figures)
      call table%add_numbers('lower_bound', '-', (parameters%lower), figures=bound_figures)
      call table%add_numbers('upper_bound', '-', (parameters%upper), figures=bound_figures)
   end function parameter_table

   !> One row a key of the model that is not free.
   pure function fixed_table(keys, free) result(table)
      !> Keys of the model
      type(key_list), intent(in) :: keys
      !> Names of the free ones
      type(string_type), intent(in) :: free(:)
      type(table_type) :: table
      character(len=longest), allocatable, dimension(:) :: names, values, units, sources
      logical :: shown(keys%n)
      integer, allocatable :: places(:)
      integer :: i, j

      do i = 1, keys%n
         shown(i) = keys%rows(i)%is_input()
         if (shown(i)) shown(i) = .not. any([(free(j)%text == keys%rows(i)%name, j=1, size(free))])
      end do
      places = pack([(i, i=1, keys%n)], shown)
      allocate (names(size(places)), values(size(places)), units(size(places)), &
         sources(size(places)))
      do i = 1, size(places)
         associate (key => keys%rows(places(i)))
            names(i) = key%name
            units(i) = key%unit
            if (key%unit == '') units(i) = '-'
            sources(i) = key%source
            select case (key%kind)
            case (kind_real)
               values(i) = to_text(key%values(1), value_figures)
            case (kind_integer)
               values(i) = to_text(key%whole)
            case (kind_logical)
               values(i) = merge('true ', 'false', key%switch)
            case default
               values(i) = key%text
            end select
         end associate
      end do
      table = new_table(columns=4, rows=size(places))
      call table%add_texts('fixed', names)
      call table%add_texts('as', values)
      call table%add_texts('in', units)
      call table%add_texts('source', sources)
   end function fixed_table

   !> How well the model meets the record, in one row.
   pure function quality_table(quantities, differences, result) result(table)
      !> What the columns of the record are
      type(record_quantities), intent(in) :: quantities
      !> Model less record
      real(wp), intent(in) :: differences(:)
      !> What was found
      type(fit_result), intent(in) :: result
      type(table_type) :: table

      table = new_table(columns=8, rows=1)
      call table%add_codes('samples', column_counts, [size(differences)])
      call table%add_codes('free', column_counts, [size(result%values)])
      call table%add_numbers('root_mean_square', trim(quantities%units(2)), &
         [norm2(differences)/sqrt(real(size(differences), wp))], figures=bound_figures)
      call table%add_numbers('largest_difference', trim(quantities%units(2)), &
         [maxval(abs(differences))], figures=bound_figures)
      call table%add_numbers('durbin_watson', '-', [durbin_watson(result%residuals)], decimals=2)
      call table%add_codes('searches', column_counts, [result%searches])
      call table%add_codes('agreeing', column_counts, [result%agreeing])
      call table%add_codes('evaluations', column_counts, [result%evaluations])
   end function quality_table

   !> Correlations of the parameters.
   pure function correlation_table(parameters, result) result(table)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> What was found
      type(fit_result), intent(in) :: result
      type(table_type) :: table
      integer :: i

      table = new_table(columns=size(parameters) + 1, rows=size(parameters))
      call table%add_texts('correlation', parameters%name)
      do i = 1, size(parameters)
         call table%add_numbers(trim(parameters(i)%name), '-', result%correlations(:, i), &
            decimals=3)
      end do
   end function correlation_table

   !> What the record tells apart, best known first.
   pure function direction_table(parameters, result) result(table)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> What was found
      type(fit_result), intent(in) :: result
      type(table_type) :: table
      character(len=longest) :: texts(size(parameters))
      integer :: i

      do i = 1, size(texts)
         texts(i) = combination(parameters, result%directions(:, i))
      end do
      table = new_table(columns=2, rows=size(texts))
      call table%add_numbers('standard_error', '-', result%direction_errors, figures=2)
      call table%add_texts('of', texts)
   end function direction_table

   !> Record and model, one row a sample.
   function curve_table(quantities, records, model) result(table)
      !> What the columns of the record are
      type(record_quantities), intent(in) :: quantities
      !> The tests
      type(fit_record), intent(in) :: records(:)
      !> The model at the samples of all tests
      real(wp), intent(in) :: model(:)
      type(table_type) :: table
      character(len=longest), allocatable :: titles(:)
      real(wp), allocatable :: x(:), y(:)
      integer :: i, j

      allocate (titles(0), x(0), y(0))
      do i = 1, size(records)
         x = [x, records(i)%x]
         y = [y, records(i)%y]
         titles = [character(len=longest) :: titles, (records(i)%title, j=1, size(records(i)%x))]
      end do
      associate (names => quantities%names, units => quantities%units)
         table = new_table(columns=4 + merge(1, 0, size(records) > 1), rows=size(x))
         if (size(records) > 1) call table%add_texts('test', titles)
         call table%add_numbers(trim(names(1)), trim(units(1)), x)
         call table%add_numbers(trim(names(2)), trim(units(2)), y)
         call table%add_numbers('model_'//trim(names(2)), trim(units(2)), model)
         call table%add_numbers('difference', trim(units(2)), model - y)
      end associate
   end function curve_table

end module asperity_program_commands_fit_tables
