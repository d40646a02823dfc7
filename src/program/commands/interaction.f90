!> What is to be said when so much of the faces touches that summits feel each other, which the law
!> leaves out: the force of each lowers the face around it.
module asperity_program_commands_interaction
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_report_report, only: report_type
   implicit none
   private
   public :: interaction_remark, remark_interaction

   !> Real over nominal area from which it is said, and from which contacts grow together as well
   real(wp), parameter :: considerable = 0.1_wp, large = 0.3_wp
   !> Area by the law, and its pressure over that of an elastic solution at the same separation:
   !> `./run surfaces` measures and checks them
   real(wp), parameter :: measured_area(2) = [0.06_wp, 0.1_wp], measured_share(2) = &
      [0.57_wp, 0.38_wp]

contains

   !> The remark, empty where there is nothing to say.
   pure function interaction_remark(area_fraction) result(text)
      !> Largest real area over nominal area
      real(wp), intent(in) :: area_fraction
      character(len=:), allocatable :: text

      text = ''
      if (.not. area_fraction >= considerable) return
      text = 'Real area up to '//percent(area_fraction)//' of the nominal one: the law leaves '// &
         'out that summits lower the face around each other. Beside an elastic solution it had '// &
         to_text(measured_share(1))//' of the pressure at the same separation where its area '// &
         'was '//percent(measured_area(1))//', and '//to_text(measured_share(2))//' at '// &
         percent(measured_area(2))//' (docs/surface.md); plastic summits were not compared.'
      if (area_fraction >= large) text = text//' From '//percent(large)// &
         ' on contacts grow together as well: closures and stiffness are rough.'
   end function interaction_remark

   !> Add the remark on the largest area of a report's table.
   pure subroutine remark_interaction(report)
      !> With its table
      type(report_type), intent(inout) :: report
      integer :: place
      character(len=:), allocatable :: text

      place = report%table%find('area_fraction')
      if (place == 0) return
      text = interaction_remark(maxval(report%table%columns(place)%values))
      if (text /= '') call report%add_remark(text)
   end subroutine remark_interaction

   !> A fraction as a whole number of percent.
   pure function percent(fraction) result(text)
      real(wp), intent(in) :: fraction
      character(len=:), allocatable :: text

      text = to_text(100.0_wp*fraction, 2)//' %'
      if (abs(fraction) < 1.0e6_wp) text = to_text(nint(100.0_wp*fraction))//' %'
   end function percent

end module asperity_program_commands_interaction
