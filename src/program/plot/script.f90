!> Figures as scripts of gnuplot with their data inside.
module asperity_program_plot_script
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_plot_figure, only: figure_type
   use asperity_program_plot_panel_script, only: add_panel
   use asperity_program_plot_series_script, only: label
   implicit none
   private
   public :: page_script, sheet_script

   !> Width of a character and height of a line over the size of the font
   real(wp), parameter :: slim = 0.6_wp, line_height = 1.5_wp
   !> Lines of text that the title of a sheet takes
   real(wp), parameter :: title_lines = 2.8_wp

   !> A sheet: pixels, size of its font, parts of its height below the title, grid of panels.
   type :: sheet_type
      integer :: width = 960, height = 720, font = 15
      real(wp) :: top = 1.0_wp
      integer :: columns = 1, rows = 1
      !> Room for an axis on the right in every panel
      logical :: right = .false.
   end type sheet_type

contains

   !> All panels of some figures on one sheet.
   pure subroutine sheet_script(figures, title, format, script, error)
      !> The figures
      type(figure_type), intent(in) :: figures(:)
      !> Title of the sheet
      character(len=*), intent(in) :: title
      !> svg, png or pdf
      character(len=*), intent(in) :: format
      !> The script
      character(len=:), allocatable, intent(out) :: script
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: b
      type(sheet_type) :: sheet
      integer :: i, panels

      panels = sum([(size(figures(i)%panels), i=1, size(figures))])
      if (panels > 4) sheet = sheet_type(1440, 1140, 13)
      if (panels > 16) sheet = sheet_type(2160, 1710, 13)
      sheet%top = 1.0_wp - title_lines*real(sheet%font, wp)/real(sheet%height, wp)
      call set_grid(sheet, panels)
      if (size(figures) == 1) sheet%right = sheet%columns == 1 .and. has_right(figures(1))
      call b%line(terminal(sheet, format))
      call b%line('set multiplot title '//label(title))
      panels = 0
      do i = 1, size(figures)
         call add_panels(b, sheet, figures(i), panels)
      end do
      call b%line('unset multiplot')
      call b%take(script, error)
   end subroutine sheet_script

   !> One SVG document a figure, one after the other, with letters of one size on a page that is
   !> two figures of one panel wide.
   pure subroutine page_script(figures, script, error)
      !> The figures
      type(figure_type), intent(in) :: figures(:)
      !> The script
      character(len=:), allocatable, intent(out) :: script
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: b
      type(sheet_type) :: sheet
      integer :: i, panels

      do i = 1, size(figures)
         sheet = sheet_type(660, 420, 14)
         call set_grid(sheet, size(figures(i)%panels))
         if (size(figures(i)%panels) > 1) then
            sheet%width = 1340
            sheet%height = 420*sheet%rows
         end if
         call b%line('set terminal svg size '//to_text(sheet%width)//','//to_text(sheet%height)// &
            " dynamic noenhanced font 'sans-serif,14' name 'p"//to_text(i)//"'")
         call b%line('set multiplot')
         panels = 0
         call add_panels(b, sheet, figures(i), panels)
         call b%line('unset multiplot')
      end do
      call b%take(script, error)
   end subroutine page_script

   !> Two panels below each other, more in about as many rows as columns.
   pure subroutine set_grid(sheet, panels)
      type(sheet_type), intent(inout) :: sheet
      integer, intent(in) :: panels

      if (panels > 2) sheet%columns = ceiling(sqrt(real(panels, wp)))
      sheet%rows = (max(panels, 1) - 1)/sheet%columns + 1
   end subroutine set_grid

   pure logical function has_right(figure)
      type(figure_type), intent(in) :: figure
      integer :: i

      has_right = any([(figure%panels(i)%right%label /= '', i=1, size(figure%panels))])
   end function has_right

   !> Terminal of a sheet; points and lines grow with the letters.
   pure function terminal(sheet, format) result(text)
      type(sheet_type), intent(in) :: sheet
      character(len=*), intent(in) :: format
      character(len=:), allocatable :: text

      associate (w => sheet%width, h => sheet%height, f => sheet%font)
         select case (format)
         case ('svg')
            text = 'svg size '//to_text(w)//','//to_text(h)// &
               " noenhanced font 'DejaVu Sans,"//to_text(f)//"' background 'white'"
         case ('png')
            text = 'pngcairo size '//to_text(3*w/2)//','//to_text(3*h/2)// &
               " noenhanced font 'DejaVu Sans,"//to_text(3*f/2)//"' linewidth 1.5 pointscale 2.2"
         case default
            text = 'pdfcairo size '//to_text(w/48)//'cm,'//to_text(h/48)// &
               "cm noenhanced font 'DejaVu Sans,"//to_text(f - 2)//"'"
         end select
      end associate
      text = 'set encoding utf8'//new_line('a')//'set terminal '//text
   end function terminal

   !> The panels of a figure after those that the sheet has already.
   pure subroutine add_panels(b, sheet, figure, panels)
      type(growing_text), intent(inout) :: b
      type(sheet_type), intent(in) :: sheet
      type(figure_type), intent(in) :: figure
      integer, intent(inout) :: panels
      real(wp) :: place(4)
      integer :: i

      do i = 1, size(figure%panels)
         place = figure%panels(i)%place
         if (.not. place(3) > 0.0_wp) place = [real(modulo(panels, sheet%columns), wp) &
            /real(sheet%columns, wp), 1.0_wp - real(panels/sheet%columns + 1, wp) &
            /real(sheet%rows, wp), 1.0_wp/real(sheet%columns, wp), 1.0_wp/real(sheet%rows, wp)]
         place([2, 4]) = sheet%top*place([2, 4])
         panels = panels + 1
         call add_panel(b, figure%panels(i), place, &
            int(place(3)*real(sheet%width, wp)/(slim*real(sheet%font, wp))), &
            line_height*real(sheet%font, wp)/real(sheet%height, wp), sheet%right)
      end do
   end subroutine add_panels

end module asperity_program_plot_script
