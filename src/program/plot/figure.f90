!> Pictures as the commands describe them: figures of panels, panels of axes and series. How they
!> are drawn is known in this folder alone.
module asperity_program_plot_figure
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_program_plot_palette, only: blue, palette
   implicit none
   private
   public :: axis_type, figure_type, panel_type, series_type

   !> How a series is drawn
   enum, bind(c)
      !> A line through its points
      enumerator :: as_line = 1
      !> A mark at each point
      enumerator :: as_points
      !> Both
      enumerator :: as_line_and_points
      !> A bar from zero to each point
      enumerator :: as_bars
      !> The outline of a histogram
      enumerator :: as_steps
      !> The area between `y` and `z`
      enumerator :: as_band
      !> A colour, by `z`, at each point of a grid
      enumerator :: as_map
      !> A rectangle about each point, coloured by `z` where there is one
      enumerator :: as_boxes
   end enum
   public :: as_line, as_points, as_line_and_points, as_bars, as_steps, as_band, as_map, as_boxes

   !> Marks of points
   enum, bind(c)
      enumerator :: disc = 1
      enumerator :: ring
      enumerator :: block
      enumerator :: box
      enumerator :: cross
   end enum
   public :: disc, ring, block, box, cross

   !> Lines
   integer, parameter, public :: solid = 1, dashed = 2, dotted = 3

   !> An axis.
   type :: axis_type
      !> Quantity and unit, empty for no axis
      character(len=:), allocatable :: label
      !> Its ends, `none` where the series decide
      real(wp) :: low = none, high = none
      !> Logarithmic, of whole numbers
      logical :: logarithmic = .false., whole = .false.
   end type axis_type

   !> What is drawn in one colour. Points with a coordinate `none` are left out.
   type :: series_type
      !> Coordinates; `z` only of bands, maps and boxes
      real(wp), allocatable :: x(:), y(:), z(:)
      !> Width and height of each box
      real(wp), allocatable :: sizes(:, :)
      !> What it is, empty for no legend
      character(len=:), allocatable :: legend
      !> How it is drawn
      integer :: form = as_line, colour = blue, stroke = solid, mark = disc
      !> Belongs to the axis on the right
      logical :: right = .false.
   end type series_type

   !> One system of axes.
   type :: panel_type
      !> Above it, empty for none; in its place when it has no point
      character(len=:), allocatable :: title, empty
      !> Axes below, on the left, on the right, and of the colours of a map or of boxes
      type(axis_type) :: x, y, right, colours
      !> Left, bottom, width and height as parts of the sheet; zero for a place of the grid
      real(wp) :: place(4) = 0.0_wp
      !> Lines through zero
      logical :: zero_lines = .false.
      !> What is drawn, in this order
      type(series_type), allocatable :: series(:)
   contains
      !> Append a series
      procedure :: add
   end type panel_type

   !> Panels that belong together.
   type :: figure_type
      !> A sentence or two below it on a page
      character(len=:), allocatable :: caption
      !> The panels
      type(panel_type), allocatable :: panels(:)
   end type figure_type

   interface panel_type
      module procedure :: new_panel
   end interface panel_type

contains

   !> A panel without series yet.
   pure function new_panel(x_label, y_label, title) result(panel)
      !> Labels of the axes
      character(len=*), intent(in) :: x_label, y_label
      !> Title; none when absent
      character(len=*), intent(in), optional :: title
      type(panel_type) :: panel

      panel%title = ''
      if (present(title)) panel%title = title
      panel%empty = 'nothing to draw'
      panel%x%label = x_label
      panel%y%label = y_label
      panel%right%label = ''
      panel%colours%label = ''
      allocate (panel%series(0))
   end function new_panel

   !> Append a series.
   pure subroutine add(self, x, y, legend, colour, form, stroke, mark, right, z, sizes)
      !> The panel
      class(panel_type), intent(inout) :: self
      !> Coordinates
      real(wp), intent(in) :: x(:), y(:)
      !> What it is, empty for no legend
      character(len=*), intent(in) :: legend
      !> Place in the palette, which is used over again
      integer, intent(in) :: colour
      !> How it is drawn, as a solid line with discs at points when absent
      integer, intent(in), optional :: form, stroke, mark
      !> Whether it belongs to the axis on the right
      logical, intent(in), optional :: right
      !> Lower edge of a band, height of a map, what boxes are coloured by
      real(wp), intent(in), optional :: z(:)
      !> Width and height of each box
      real(wp), intent(in), optional :: sizes(:, :)
      type(series_type) :: series

      allocate (series%x, source=x)
      allocate (series%y, source=y)
      if (present(z)) allocate (series%z, source=z)
      if (present(sizes)) allocate (series%sizes, source=sizes)
      series%legend = legend
      series%colour = 1 + modulo(colour - 1, size(palette))
      if (present(form)) series%form = form
      if (present(stroke)) series%stroke = stroke
      if (present(mark)) series%mark = mark
      if (present(right)) series%right = right
      self%series = [self%series, series]
   end subroutine add

end module asperity_program_plot_figure
