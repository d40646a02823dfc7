!> Pictures of the cases of a sweep as one: each case has a colour, its values in the legend.
module asperity_program_commands_sweep_joined_pictures
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_plot_figure, only: as_band, as_line, figure_type, panel_type, series_type, &
      solid
   use asperity_program_plot_palette, only: palette
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: join_pictures

contains

   !> Draw the panels of all cases over each other where their axes are the same.
   pure subroutine join_pictures(report, cases, legends)
      !> With its table; its picture is set
      type(report_type), intent(inout) :: report
      !> Reports of the cases, with pictures
      type(report_type), intent(in) :: cases(:)
      !> The values of each case
      type(string_type), intent(in) :: legends(:)
      type(panel_type), allocatable :: panels(:)
      integer :: i, j, k

      allocate (panels(0))
      do i = 1, size(cases)
         associate (own => cases(i)%pictures(1)%panels)
            do j = 1, size(own)
               do k = 1, size(panels)
                  if (panels(k)%x%label == own(j)%x%label .and. &
                     panels(k)%y%label == own(j)%y%label) exit
               end do
               if (k > size(panels)) panels = [panels, without_series(own(j))]
               call add_case(panels(k), own(j), legends(i)%text, of_first=i == 1)
            end do
         end associate
      end do
      associate (title => cases(1)%picture_title)
         report%picture_title = picture_title(report, title(:index(title, ': ') - 1))
      end associate
      report%pictures = [figure_type('', panels)]
   end subroutine join_pictures

   !> Axes alone. A scale on the right that no series belongs to is of one case.
   pure function without_series(panel) result(empty)
      type(panel_type), intent(in) :: panel
      type(panel_type) :: empty

      empty = panel
      deallocate (empty%series)
      allocate (empty%series(0))
      if (any(panel%series%right)) return
      empty%right%label = ''
      empty%right%low = none
      empty%right%high = none
   end function without_series

   !> Add the series of a case. Bands would hide those of others. Solid lines of one case are told
   !> apart by what stands before the comma in their legend; lines that are not solid take the
   !> colour of the solid one before them, and the first one says what they are.
   pure subroutine add_case(panel, own, legend, of_first)
      type(panel_type), intent(inout) :: panel
      type(panel_type), intent(in) :: own
      character(len=*), intent(in) :: legend
      logical, intent(in) :: of_first
      type(series_type) :: series
      logical :: is_solid(size(own%series))
      integer :: colour, i

      is_solid = own%series%form == as_line .and. own%series%stroke == solid
      colour = count(panel%series%form == as_line .and. panel%series%stroke == solid)
      do i = 1, size(own%series)
         if (own%series(i)%form == as_band) cycle
         series = own%series(i)
         if (is_solid(i)) then
            colour = colour + 1
            series%legend = legend
            if (count(is_solid) > 1) &
               series%legend = legend//', '//before_comma(own%series(i)%legend)
         else if (.not. of_first .or. colour > 1) then
            series%legend = ''
         else if (count(is_solid) > 1) then
            series%legend = series%legend(index(series%legend, ', ') + 2:)
         end if
         if (series%form == as_line) series%colour = 1 + modulo(colour - 1, size(palette))
         panel%series = [panel%series, series]
      end do
      panel%y%logarithmic = panel%y%logarithmic .or. own%y%logarithmic
      panel%y%low = outer(panel%y%low, own%y%low, -1.0_wp)
      panel%y%high = outer(panel%y%high, own%y%high, 1.0_wp)
      if (panel%right%label /= '') &
         panel%right%high = outer(panel%right%high, own%right%high, 1.0_wp)
   end subroutine add_case

   !> What stands before the first comma, or all.
   pure function before_comma(text) result(part)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: part

      part = text(:index(text//',', ',') - 1)
   end function before_comma

   !> The lower (sign -1) or the higher (sign 1) of two ends of an axis; either may be none.
   pure real(wp) function outer(a, b, sign)
      real(wp), intent(in) :: a, b, sign

      outer = a
      if (is_none(b)) return
      outer = b
      if (.not. is_none(a)) outer = sign*max(sign*a, sign*b)
   end function outer

end module asperity_program_commands_sweep_joined_pictures
