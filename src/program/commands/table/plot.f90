!> Picture of a table of the law: its rows beside the law, and the error between them.
module asperity_program_commands_table_plot
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_law_rows, only: law_table
   use asperity_law_normal_law, only: evaluate_normal_law
   use asperity_program_plot_figure, only: as_points, figure_type, panel_type
   use asperity_program_plot_palette, only: blue, red
   implicit none
   private
   public :: law_table_picture

   !> Points drawn between two rows
   integer, parameter :: points = 12

contains

   !> The picture of a table; its first and its last row are not drawn.
   pure function law_table_picture(table, properties) result(picture)
      !> The table, and the properties that it was made from
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      type(figure_type) :: picture
      type(panel_type) :: rows, errors
      real(wp), allocatable :: closure(:), pressure(:)
      integer :: n

      n = size(table%pressure) - 1
      allocate (closure, source=between(table%overclosure(2:n)))
      allocate (pressure, source=between(table%pressure(2:n)))
      rows = panel_type('overclosure (mm)', 'pressure (MPa)')
      rows%y%logarithmic = .true.
      errors = panel_type('overclosure (mm)', 'error of interpolation (%)')
      associate (law => evaluate_normal_law(properties%normal, &
            properties%initial_separation - closure))
         call rows%add(closure, law%pressure, 'law', blue)
         call errors%add(closure, 100.0_wp*(pressure/law%pressure - 1.0_wp), '', red)
      end associate
      call rows%add(table%overclosure(2:n), table%pressure(2:n), &
         to_text(n + 1)//' rows, first and last not drawn', red, as_points)
      picture = figure_type('', [rows, errors])
   end function law_table_picture

   !> Values between neighbours, these themselves included.
   pure function between(values) result(finer)
      real(wp), intent(in) :: values(:)
      real(wp) :: finer((size(values) - 1)*points + 1)
      integer :: i, j

      finer(1) = values(1)
      do i = 1, size(values) - 1
         do j = 1, points
            finer((i - 1)*points + j + 1) = values(i) + real(j, wp)/points &
               *(values(i + 1) - values(i))
         end do
      end do
   end function between

end module asperity_program_commands_table_plot
