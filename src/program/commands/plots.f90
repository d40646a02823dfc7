!> Pictures of `curve`, `press` and `shear`.
module asperity_program_commands_plots
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_program_plot_figure, only: as_band, as_points, dashed, dotted, figure_type, &
      panel_type, ring
   use asperity_program_plot_palette, only: black, blue, green, red, sky
   use asperity_program_report_report, only: report_type
   implicit none
   private
   public :: draw_curve, draw_press, draw_shear, picture_title

   !> Evenly spaced points of each run that are drawn
   integer, parameter :: most_points = 1000
   !> Smallest pressure that is drawn, over the largest: faces that part with memory lose it so fast
   !> that it would fill the picture with nothing
   real(wp), parameter :: least_drawn = 1.0e-12_wp
   !> Room above and below the closures, as a part of their range, or of sigma
   real(wp), parameter :: margin = 0.05_wp

contains

   !> Pressure (logarithmic) and real area against separation.
   pure subroutine draw_curve(report)
      !> Its picture is set
      type(report_type), intent(inout) :: report
      type(panel_type) :: panel
      integer, allocatable :: rows(:)

      allocate (rows, source=rows_of(report, 1))
      panel = panel_type('separation (mm)', 'pressure (MPa)')
      panel%right%label = 'real area / nominal area'
      panel%right%low = 0.0_wp
      associate (separation => column(report, 'separation', rows), &
            pressure => column(report, 'pressure', rows), &
            area => column(report, 'area_fraction', rows), &
            codes => report%table%columns(report%table%find('validity'))%codes(rows))
         panel%y%logarithmic = any(pressure > 0.0_wp)
         if (any(pressure > 0.0_wp .and. pressure < least_drawn*maxval(pressure))) &
            panel%y%low = least_drawn*maxval(pressure)
         ! past the limit of the law there is no such area
         if (any(area > 1.0_wp)) panel%right%high = 1.0_wp
         call panel%add(separation, pressure, 'pressure (left)', blue)
         call panel%add(separation, area, 'real area (right)', red, stroke=dashed, right=.true.)
         call panel%add(pack(separation, codes > 0), pack(pressure, codes > 0), &
            'past a limit of the law', black, as_points, mark=ring)
      end associate
      call set_picture(report, 'Normal contact law', [panel])
   end subroutine draw_curve

   !> Normal stress against step time, with the stages that carry it (the paper's Fig. 17), and
   !> the overclosure; with memory the loops of stress against overclosure instead.
   pure subroutine draw_press(report)
      !> Its picture is set
      type(report_type), intent(inout) :: report
      type(panel_type) :: stress, closure, loops
      integer, allocatable :: rows(:)

      allocate (rows, source=rows_of(report, 1))
      stress = panel_type('step time (s)', 'normal stress (MPa)')
      stress%y%low = 0.0_wp
      closure = panel_type('step time (s)', 'overclosure (mm)')
      associate (time => column(report, 'time', rows), p => column(report, 'pressure', rows), &
            elastic => column(report, 'elastic_share', rows), &
            plastic => column(report, 'plastic_share', rows))
         call stress%add(time, p*plastic, 'plastic', red, as_band, z=0.0_wp*p)
         call stress%add(time, p*(1.0_wp - elastic), 'elasto-plastic', sky, as_band, z=p*plastic)
         call stress%add(time, p, 'elastic ('//to_text(100.0_wp*elastic(maxloc(p, 1)), 2)// &
            ' % at peak)', green, as_band, z=p*(1.0_wp - elastic))
         call stress%add(time, p, 'normal stress', black)
         call closure%add(time, column(report, 'overclosure', rows), '', blue)
      end associate
      if (report%table%find('plastic_dissipation') > 0) then
         loops = panel_type('overclosure (mm)', 'normal stress (MPa)')
         loops%y%low = 0.0_wp
         call loops%add(column(report, 'overclosure', rows), column(report, 'pressure', rows), '', &
            black)
         call set_picture(report, 'Press and release', [loops, stress])
      else
         call set_picture(report, 'Press and release', [stress, closure])
      end if
   end subroutine draw_press

   !> Shear stress, and closure, against displacement for all normal stresses (Fig. 18).
   pure subroutine draw_shear(report, properties, by_critical_slip)
      !> Its picture is set
      type(report_type), intent(inout) :: report
      !> Properties of the faces
      type(contact_properties), intent(in) :: properties
      !> Where summits stick each for itself, the shear stress of one critical slip for all, of
      !> every row, MPa
      real(wp), intent(in), optional :: by_critical_slip(:)
      type(panel_type) :: stress, closure
      character(len=:), allocatable :: name
      integer, allocatable :: rows(:)
      real(wp) :: nominal(1)
      integer :: run

      stress = panel_type('displacement (mm)', 'shear stress (MPa)')
      closure = panel_type('displacement (mm)', 'overclosure (mm)')
      name = ''
      do run = 1, size(report%first_rows) - 1
         rows = rows_of(report, run)
         nominal = column(report, 'normal_stress_nominal', rows(:1))
         name = to_text(nominal(1), 4)//' MPa'
         associate (displacement => column(report, 'displacement', rows))
            call stress%add(displacement, column(report, 'shear_stress_nominal', rows), &
               name//', full disc', run)
            call stress%add(displacement, column(report, 'shear_stress', rows), &
               name//', overlap', run, stroke=dashed)
            if (present(by_critical_slip)) call stress%add(displacement, by_critical_slip(rows), &
               name//', gcrit', run, stroke=dotted)
            call closure%add(displacement, column(report, 'overclosure', rows), name, run)
         end associate
      end do
      call add_separation_axis(closure, report, properties)
      call set_picture(report, 'Direct shear', [stress, closure])
   end subroutine draw_shear

   !> Axes of overclosure on the left and of the same separation, over sigma, on the right.
   pure subroutine add_separation_axis(panel, report, properties)
      type(panel_type), intent(inout) :: panel
      type(report_type), intent(in) :: report
      type(contact_properties), intent(in) :: properties
      real(wp) :: d0, room, sigma

      d0 = properties%initial_separation
      sigma = properties%normal%sigma
      associate (overclosure => report%table%columns(report%table%find('overclosure'))%values)
         room = margin*max(maxval(overclosure) - minval(overclosure), sigma)
         panel%y%low = minval(overclosure) - room
         panel%y%high = maxval(overclosure) + room
      end associate
      panel%right%label = 'separation / sigma'
      panel%right%low = (d0 - panel%y%low)/sigma
      panel%right%high = (d0 - panel%y%high)/sigma
   end subroutine add_separation_axis

   !> Make some panels the picture of a report.
   pure subroutine set_picture(report, what, panels)
      type(report_type), intent(inout) :: report
      character(len=*), intent(in) :: what
      type(panel_type), intent(in) :: panels(:)

      report%picture_title = picture_title(report, what)
      allocate (report%pictures(1))
      report%pictures(1) = figure_type('', panels)
   end subroutine set_picture

   !> Title of a picture, which also says when results pass a limit of the law.
   pure function picture_title(report, what) result(text)
      !> The report
      type(report_type), intent(in) :: report
      !> What the picture shows
      character(len=*), intent(in) :: what
      character(len=:), allocatable :: text

      text = what//': '//report%faces
      if (report%validity() /= 0) text = text//' (partly past the limits of the law)'
   end function picture_title

   !> Rows of a run that are drawn.
   pure function rows_of(report, run) result(rows)
      type(report_type), intent(in) :: report
      integer, intent(in) :: run
      integer, allocatable :: rows(:)

      allocate (rows, source=report%selected_rows(most_points))
      rows = pack(rows, rows >= report%first_rows(run) .and. rows < report%first_rows(run + 1))
   end function rows_of

   !> Values of a column in some rows.
   pure function column(report, name, rows) result(values)
      type(report_type), intent(in) :: report
      character(len=*), intent(in) :: name
      integer, intent(in) :: rows(:)
      real(wp) :: values(size(rows))

      values = report%table%columns(report%table%find(name))%values(rows)
   end function column

end module asperity_program_commands_plots
