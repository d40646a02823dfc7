!> Picture of a table of the law as a gnuplot script: rows and law, and the error between them.
module asperity_program_commands_table_plot
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_law_rows, only: law_table
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_program_input_presets, only: faces_text
   use asperity_program_input_settings, only: settings_type
   use asperity_program_system_strings, only: backslash
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: law_table_script

   !> Points drawn between two rows
   integer, parameter :: points = 12
   !> Colours that colour-blind people can tell apart (Okabe and Ito)
   character(len=*), parameter :: blue = 'lc rgb "#0072B2"', red = 'lc rgb "#D55E00"'

contains

   !> The picture of a table; its last row is far outside and not drawn.
   pure function law_table_script(table, properties, settings) result(script)
      !> The table, and the properties that it was made from
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      character(len=:), allocatable :: script
      type(normal_response) :: law
      type(text_buffer) :: b
      real(wp) :: part, overclosure, pressure
      integer :: i, j, n

      n = size(table%pressure) - 1
      call b%line('$rows << EOD')
      do i = 2, n
         call b%numbers([table%overclosure(i), table%pressure(i)])
      end do
      call b%line('EOD')
      call b%line('$law << EOD')
      do i = 2, n - 1
         do j = 0, points
            part = real(j, wp)/points
            overclosure = table%overclosure(i) + part*(table%overclosure(i + 1) &
               - table%overclosure(i))
            pressure = table%pressure(i) + part*(table%pressure(i + 1) - table%pressure(i))
            law = evaluate_normal_law(properties%normal, &
               properties%initial_separation - overclosure)
            call b%numbers([overclosure, law%pressure, 100.0_wp*(pressure/law%pressure - 1.0_wp)])
         end do
      end do
      call b%line('EOD')
      call b%line('set multiplot layout 2,1 title "Law and table: '//faces_text(settings)//'"')
      call b%line('set lmargin at screen 0.12')
      call b%line("set format y '%h'")
      call b%line("set xlabel 'overclosure (mm)'")
      call b%line("set ylabel 'pressure (MPa)'")
      call b%line('set key top left')
      call b%line('set logscale y')
      call b%line('plot $law using 1:2 lw 2 '//blue//" title 'law', "//backslash)
      call b%line('$rows using 1:2 with points pt 7 ps 0.6 '//red//" title '"// &
         to_text(n + 1)//" rows, first and last not drawn'")
      call b%line('unset logscale y')
      call b%line("set ylabel 'error of interpolation (%)'")
      call b%line('unset key')
      call b%line('plot $law using 1:3 lw 2 '//red//' notitle')
      call b%line('unset multiplot')
      script = b%text()
   end function law_table_script

end module asperity_program_commands_table_plot
