!> `asperity curve --single`: force, area and mean pressure of one summit through its stages (the
!> paper's Fig. 5), and on the way back where it remembers.
module asperity_program_commands_single_summit
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity
   use asperity_law_unloading_summit, only: elastic_recovery, evaluate_unloading_asperity
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_plot_figure, only: dashed, dotted, figure_type, panel_type
   use asperity_program_plot_palette, only: black, blue, red
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_validity, new_table, table_type
   implicit none
   private
   public :: report_summit, usual_deformations

   !> Points a decade, and decades before w1 and after w2
   integer, parameter :: points = 8, decades = 1
   !> Points between w1 and w2
   integer, parameter :: between = 24
   !> Steps of the way back
   integer, parameter :: releases = 20
   !> Names of the stages, from 0
   character(len=*), parameter :: stages(0:3) = [character(len=13) :: 'open', 'elastic', &
      'elastoplastic', 'plastic']

contains

   !> Deformations that show all stages: w1/10 to 10 w2 in equal ratios, w1 and w2 among them, mm.
   pure function usual_deformations(properties) result(deformation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      real(wp), allocatable :: deformation(:)
      integer :: i

      associate (w1 => properties%w1, w2 => properties%w2)
         deformation = [(w1*10.0_wp**(real(i, wp)/points), i=-points*decades, -1), &
            (w1*(w2/w1)**(real(i, wp)/between), i=0, between - 1), &
            (w2*10.0_wp**(real(i, wp)/points), i=0, points*decades)]
      end associate
   end function usual_deformations

   !> Press a summit, and release it where it remembers. `error` is set when a result is out of the
   !> range of numbers.
   pure subroutine report_summit(report, properties, deformation, error)
      !> Its table, summary and picture are set
      type(report_type), intent(inout) :: report
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Deformations, mm
      real(wp), intent(in) :: deformation(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: w(:), largest(:)
      integer :: n

      n = size(deformation)
      allocate (w, largest, source=deformation)
      report%first_rows = [1, n + 1]
      report%important = turning_points(deformation)
      if (properties%unloading == unloading_elastic) then
         w = [w, way_back(properties, maxval(deformation))]
         largest = [largest, spread(maxval(deformation), 1, size(w) - n)]
         report%first_rows = [1, n + 1, size(w) + 1]
         report%important = [report%important, turning_points(w(n + 1:))]
      end if
      report%table = summit_table(properties, w, largest)
      report%summary = stage_table(properties)
      call report%table%check_finite(error)
      if (.not. allocated(error) .and. report%is_drawn()) call draw_summit(report, properties, n)
   end subroutine report_summit

   !> Deformations from the largest one, mm, to where contact is lost, evenly spaced; the last one
   !> is past it by more than rounding.
   pure function way_back(properties, largest) result(w)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: largest
      real(wp) :: w(releases + 1)
      integer :: i

      w = [(largest - elastic_recovery(properties, largest)*real(i, wp)/releases, i=0, releases)]
      w(releases + 1) = w(releases + 1) - 4.0_wp*spacing(largest)
   end function way_back

   !> One row a deformation.
   pure function summit_table(properties, w, largest) result(table)
      type(normal_properties), intent(in) :: properties
      !> Deformations and the largest ones so far, mm
      real(wp), intent(in) :: w(:), largest(:)
      type(table_type) :: table
      type(asperity_response) :: r(size(w))

      r = evaluate_asperity(properties, w)
      where (largest > w) r = evaluate_unloading_asperity(properties, largest, largest - w)
      table = new_table(columns=9, rows=size(w))
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      call table%add_numbers('deformation', 'mm', w)
      call table%add_numbers('deformation_over_w1', '-', w/properties%w1)
      call table%add_numbers('force', 'N', (r%force))
      call table%add_numbers('area', 'mm^2', (r%area))
      call table%add_numbers('mean_pressure', 'MPa', (r%mean_pressure))
      call table%add_numbers('stiffness', 'N/mm', (r%force_slope))
      call table%add_numbers('energy', 'N mm', (r%energy))
      call table%add_texts('stage', stages(r%stage))
      call table%add_codes('validity', column_validity, (r%validity))
   end function summit_table

   !> Where yield begins, w1, and where all is plastic, w2.
   pure function stage_table(properties) result(table)
      type(normal_properties), intent(in) :: properties
      type(table_type) :: table
      type(asperity_response) :: r(2)

      associate (w => [properties%w1, properties%w2])
         r = evaluate_asperity(properties, w)
         table = new_table(columns=5, rows=2)
         call table%add_texts('stage_begins', stages(r%stage))
         call table%add_numbers('deformation', 'mm', w)
         call table%add_numbers('force', 'N', (r%force))
         call table%add_numbers('area', 'mm^2', (r%area))
         call table%add_numbers('mean_pressure', 'MPa', (r%mean_pressure))
      end associate
   end function stage_table

   !> Force, area and mean pressure against deformation, w1 and w2 marked. One legend is enough.
   pure subroutine draw_summit(report, properties, n)
      type(report_type), intent(inout) :: report
      type(normal_properties), intent(in) :: properties
      !> Rows of loading
      integer, intent(in) :: n
      character(len=*), parameter :: names(3) = [character(len=13) :: 'force', 'area', &
         'mean_pressure'], labels(3) = [character(len=19) :: 'force (N)', 'area (mm^2)', &
         'mean pressure (MPa)']
      type(panel_type) :: panels(size(names))
      character(len=8) :: legends(3)
      real(wp) :: ends(2)
      integer :: i

      legends = [character(len=8) :: 'pressed', 'released', 'w1, w2']
      do i = 1, size(names)
         panels(i) = panel_type('deformation w (mm)', trim(labels(i)))
         panels(i)%x%logarithmic = .true.
         panels(i)%y%logarithmic = names(i) /= 'mean_pressure'
         associate (w => report%table%columns(1)%values, &
               y => report%table%columns(report%table%find(trim(names(i))))%values)
            ends = [minval(y(:n), mask=y(:n) > 0.0_wp), maxval(y(:n))]
            ! on the way back they vanish
            panels(i)%y%low = merge(ends(1), 0.0_wp, panels(i)%y%logarithmic)
            call panels(i)%add(w(:n), y(:n), trim(legends(1)), blue)
            if (size(w) > n) call panels(i)%add(w(n + 1:), y(n + 1:), trim(legends(2)), red, &
               stroke=dashed)
         end associate
         call panels(i)%add(spread(properties%w1, 1, 2), ends, trim(legends(3)), black, &
            stroke=dotted)
         call panels(i)%add(spread(properties%w2, 1, 2), ends, '', black, stroke=dotted)
         legends = ''
      end do
      report%picture_title = picture_title(report, 'One summit')
      report%pictures = [figure_type('', panels)]
   end subroutine draw_summit

end module asperity_program_commands_single_summit
