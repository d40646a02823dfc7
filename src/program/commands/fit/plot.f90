!> Picture of a fit: record and model, and what is left between them.
module asperity_program_commands_fit_plot
   use asperity_base_kinds, only: wp
   use asperity_program_commands_fit_record_input, only: fit_record, record_quantities
   use asperity_program_plot_figure, only: as_line, as_points, figure_type, panel_type
   use asperity_program_plot_palette, only: red, sky
   implicit none
   private
   public :: fit_picture

contains

   !> Two panels a test: record and model of all tests, then what is left.
   function fit_picture(quantities, records, model) result(picture)
      !> What the columns of the record are
      type(record_quantities), intent(in) :: quantities
      !> The tests
      type(fit_record), intent(in) :: records(:)
      !> The model at the samples of all tests
      real(wp), intent(in) :: model(:)
      type(figure_type) :: picture
      integer :: first, i

      picture%caption = ''
      allocate (picture%panels(2*size(records)))
      first = 1
      do i = 1, size(records)
         associate (x => records(i)%x, y => records(i)%y, names => quantities%names, &
               units => quantities%units)
            associate (fitted => model(first:first + size(x) - 1), curve => picture%panels(i), &
                  rest => picture%panels(size(records) + i))
               curve = panel_type(trim(names(1))//' ('//trim(units(1))//')', &
                  trim(names(2))//' ('//trim(units(2))//')', records(i)%title)
               call curve%add(x, y, 'record', sky, as_points)
               call curve%add(x, fitted, 'model', red, as_line)
               rest = panel_type(trim(names(1))//' ('//trim(units(1))//')', &
                  'model less record ('//trim(units(2))//')')
               rest%zero_lines = .true.
               call rest%add(x, fitted - y, '', sky, as_points)
            end associate
            first = first + size(x)
         end associate
      end do
   end function fit_picture

end module asperity_program_commands_fit_plot
