!> Picture of a record: loops with skeleton, stiffness, energy, damping.
module asperity_program_commands_hysteresis_plot
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_analysis, only: hysteresis_amplitude, hysteresis_result, &
      negative_side, positive_side
   use asperity_program_commands_hysteresis_tables, only: record_labels, side_names
   use asperity_program_plot_figure, only: as_bars, as_line, as_line_and_points, as_points, cross, &
      dashed, disc, figure_type, panel_type, ring
   use asperity_program_plot_palette, only: black, blue, green, pink, red, sky
   implicit none
   private
   public :: record_picture, loops_panel

   !> Which series of the loops' panel is the skeleton
   integer, parameter, public :: skeleton_series = 2

   !> Samples of the record that are drawn, besides the peaks
   integer, parameter :: most_samples = 5000
   !> Points of a skeleton that are marked
   integer, parameter :: most_marks = 60

contains

   !> The picture of a record.
   pure function record_picture(displacement, force, result, labels) result(picture)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> What was found in it
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      type(figure_type) :: picture
      type(panel_type) :: loops, stiffness, energy, ratios
      real(wp), dimension(size(result%cycles)) :: number, amplitude
      integer :: i

      associate (c => result%cycles)
         number = [(real(i, wp), i=1, size(c))]
         amplitude = [(sum(abs(c(i)%displacement), mask=c(i)%peak > 0) &
            /max(1, count(c(i)%peak > 0)), i=1, size(c))]
         stiffness = panel_type('mean of the two peaks ('//labels%x_unit//')', &
            'secant stiffness ('//labels%stiffness_unit()//')')
         stiffness%x%low = 0.0_wp
         stiffness%y%low = 0.0_wp
         call stiffness%add(amplitude, (c%secant_stiffness), '', blue, as_points)
         energy = panel_type('cycle', 'energy ('//labels%energy_unit()//')')
         energy%x%whole = .true.
         call energy%add(number, (c%cumulative_energy), 'cumulative', blue, as_line_and_points)
         call energy%add(number, (c%energy), 'of the cycle', red, as_bars)
         ratios = panel_type('cycle', 'ratio')
         ratios%x%whole = .true.
         if (.not. all(is_none(c%damping))) then
            call ratios%add(number, (c%damping), 'viscous damping', blue, as_line_and_points)
            call ratios%add(number, (c%pinching), 'pinching', green, as_line_and_points)
         else
            do i = positive_side, negative_side
               if (.not. all(is_none(c%half_damping(i)))) call ratios%add(number, &
                  (c%half_damping(i)), 'viscous damping, '//trim(side_names(i)), i, &
                  as_line_and_points)
            end do
         end if
         ratios%empty = 'no damping: no closed cycle'
      end associate
      loops = loops_panel(displacement, force, result, labels, '')
      call add_later_cycles(loops, result%amplitudes, 2, 'second', green)
      call add_later_cycles(loops, result%amplitudes, 3, 'third', pink)
      picture = figure_type('Loops, skeleton, envelopes of second and third cycles, yield '// &
         'point of equal energy and ultimate point; stiffness, energy, ratios of the cycles', &
         [loops, stiffness, energy, ratios])
   end function record_picture

   !> The envelope of second or of third cycles, through the origin.
   pure subroutine add_later_cycles(panel, amplitudes, which, legend, colour)
      type(panel_type), intent(inout) :: panel
      type(hysteresis_amplitude), intent(in) :: amplitudes(:)
      integer, intent(in) :: which, colour
      character(len=*), intent(in) :: legend
      integer, allocatable :: p(:), n(:)
      integer :: i

      p = pack([(i, i=1, size(amplitudes))], amplitudes%cycles >= which .and. &
         amplitudes%side == positive_side)
      n = pack([(i, i=size(amplitudes), 1, -1)], amplitudes(size(amplitudes):1:-1)%cycles >= which &
         .and. amplitudes(size(amplitudes):1:-1)%side == negative_side)
      if (size(p) + size(n) == 0) return
      call panel%add([amplitudes(n)%displacement(which), 0.0_wp, &
         amplitudes(p)%displacement(which)], [amplitudes(n)%force(which), 0.0_wp, &
         amplitudes(p)%force(which)], legend, colour, as_line_and_points, stroke=dashed, mark=disc)
   end subroutine add_later_cycles

   !> Loops, skeletons through the origin, yield and ultimate points.
   pure function loops_panel(displacement, force, result, labels, title) result(panel)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> What was found in it
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      !> Title of the panel, empty for none
      character(len=*), intent(in) :: title
      type(panel_type) :: panel
      logical :: drawn(size(force))
      integer :: i

      panel = panel_type(labels%x//' ('//labels%x_unit//')', labels%f//' ('//labels%f_unit//')', &
         title)
      ! evenly spaced samples and all turning points
      drawn = [(modulo(i - 1, max(1, size(force)/most_samples)) == 0, i=1, size(force))]
      drawn(result%turning_points) = .true.
      drawn(size(force)) = .true.
      call panel%add(pack(displacement, drawn), pack(force, drawn), 'record', sky)
      associate (n => result%skeleton(negative_side), p => result%skeleton(positive_side), &
            s => result%skeleton)
         ! points of a record that is its own skeleton would hide it
         call panel%add([n%displacement(size(n%force):1:-1), 0.0_wp, p%displacement], &
            [n%force(size(n%force):1:-1), 0.0_wp, p%force], 'skeleton', red, &
            merge(as_line_and_points, as_line, max(size(n%force), size(p%force)) <= most_marks), &
            mark=disc)
         call panel%add((s%yield_displacement), (s%yield_force), 'yield', black, as_points, &
            mark=ring)
         call panel%add((s%ultimate_displacement), (s%ultimate_force), 'ultimate', black, &
            as_points, mark=cross)
      end associate
   end function loops_panel

end module asperity_program_commands_hysteresis_plot
