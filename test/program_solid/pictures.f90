!> Pictures of the solid joint, and its page.
module test_program_solid_pictures
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_loops, only: hard, rough
   use asperity_program_commands_solid_keys, only: solid_case
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_commands_solid_page, only: solid_page
   use asperity_program_commands_solid_page_texts, only: origins
   use asperity_program_commands_solid_plots, only: solid_pictures
   use asperity_program_commands_solid_report, only: fill_report
   use asperity_program_commands_solid_snapshot, only: lower_peak, lower_unloaded
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_commands_tenon_page_texts, only: tenon_origins => origins
   use asperity_program_input_key, only: given_as_option, kind_integer, kind_picture, &
      kind_real
   use asperity_program_input_key_list, only: key_list
   use asperity_program_plot_figure, only: as_boxes, figure_type
   use asperity_program_plot_script, only: page_script
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use made_outcomes, only: made_outcome, made_snapshot
   implicit none
   private
   public :: suite_pictures

   real(wp), parameter :: round_off = 1.0e-12_wp
   !> Pictures that need no states
   integer, parameter :: lines = 10

contains

   function suite_pictures() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('pictures')
      call suite%addTest(TestMethod('faces unfolded', test_faces))
      call suite%addTest(TestMethod('plastic strain', test_strain))
      call suite%addTest(TestMethod('nothing kept', test_nothing))
      call suite%addTest(TestMethod('boxes for gnuplot', test_boxes))
      call suite%addTest(TestMethod('page of both models and of one', test_page))
      call suite%addTest(TestMethod('every number has its reason', test_reasons))
   end function suite_pictures

   subroutine make_both(outcomes)
      type(solid_outcome), intent(out) :: outcomes(2)
      integer :: i

      do i = 1, 2
         outcomes(i) = made_outcome(i, 1.0_wp)
         outcomes(i)%snapshots = [made_snapshot(lower_peak, -24.0_wp, 3.0_wp*i), &
            made_snapshot(lower_unloaded, -23.0_wp, 2.0_wp*i)]
      end do
   end subroutine make_both

   !> The cell above at y = 10, z = 100 of a mortise that reaches from z = -100 to 100 and to y = 20
   !> lies 10 mm past the edge and a twentieth of the height.
   subroutine test_faces()
      type(solid_outcome) :: outcomes(2)
      type(figure_type), allocatable :: pictures(:)

      call make_both(outcomes)
      allocate (pictures, source=solid_pictures(outcomes))
      call assertEqual(lines + 3, size(pictures))
      associate (states => pictures(lines + 1)%panels, pressures => pictures(lines + 2)%panels)
         call assertEqual(4, size(states))
         call assertEqual('rough law, -24.0 mm', states(2)%title)
         ! open, stick, slip; what is past the rim is not drawn
         call assertEqual(3, size(states(1)%series))
         call assertEqual(1, size(states(1)%series(1)%x))
         call assertEqual(-15.0_wp, states(1)%series(1)%x(1), round_off)
         call assertEqual(100.0_wp + 10.0_wp + 10.0_wp, states(1)%series(1)%y(1), round_off)
         call assertEqual(-100.0_wp, states(1)%series(2)%y(1), round_off)
         call assertEqual(20.0_wp, states(1)%series(2)%sizes(2, 1), round_off)
         call assertEqual(10.0_wp, states(1)%series(3)%sizes(1, 1), round_off)
         ! one scale of colours
         call assertEqual(6.0_wp, pressures(1)%colours%high, round_off)
         call assertEqual(6.0_wp, pressures(4)%colours%high, round_off)
         call assertEqual(3, size(pressures(1)%series(1)%z))
         call assertEqual(3.0_wp, maxval(pressures(1)%series(1)%z), round_off)
      end associate
   end subroutine test_faces

   subroutine test_strain()
      type(solid_outcome) :: outcomes(2)
      type(figure_type), allocatable :: pictures(:)

      call make_both(outcomes)
      allocate (pictures, source=solid_pictures(outcomes))
      associate (strains => pictures(lines + 3)%panels)
         call assertEqual(2, size(strains))
         call assertEqual(as_boxes, int(strains(1)%series(1)%form))
         call assertEqual(0.5_wp, strains(1)%series(1)%x(1), round_off)
         call assertEqual(0.5_wp, strains(1)%series(1)%y(1), round_off)
         call assertEqual(1.0_wp, strains(1)%series(1)%sizes(1, 1), round_off)
         call assertEqual(0.25_wp, strains(1)%series(1)%z(1), round_off)
         call assertEqual(0.25_wp, strains(2)%colours%high, round_off)
      end associate
   end subroutine test_strain

   subroutine test_nothing()
      type(solid_outcome) :: outcomes(2)
      type(figure_type), allocatable :: pictures(:)

      call make_both(outcomes)
      deallocate (outcomes(rough)%snapshots)
      allocate (outcomes(rough)%snapshots(0))
      allocate (pictures, source=solid_pictures(outcomes))
      call assertEqual(lines, size(pictures))
   end subroutine test_nothing

   subroutine test_boxes()
      type(solid_outcome) :: outcomes(2)
      type(figure_type), allocatable :: pictures(:)
      type(error_type), allocatable :: error
      character(len=:), allocatable :: script

      call make_both(outcomes)
      allocate (pictures, source=solid_pictures(outcomes))
      call page_script(pictures(lines + 1:lines + 2), script, error)
      call assertFalse(allocated(error))
      call assertTrue(index(script, '1:2:3:4 with boxxyerror') > 0)
      call assertTrue(index(script, '1:2:3:4:5 with boxxyerror') > 0)
      ! half of 10 by 20 mm on each side
      call assertTrue(index(script, &
         ' -1.50000000E+001  1.20000000E+002  5.00000000E+000  1.00000000E+001') > 0)
      call assertTrue(index(script, "set cblabel 'pressure (MPa)'") > 0)
   end subroutine test_boxes

   subroutine test_page()
      type(solid_outcome) :: outcomes(2)
      integer :: first

      call make_both(outcomes)
      do first = hard, rough
         call check_page(outcomes(first:))
      end do
   end subroutine test_page

   !> What is not of the faces, whose pair is said anyway.
   subroutine test_reasons()
      type(solid_case) :: case
      type(key_list) :: keys
      integer :: i

      call case%declare(keys)
      do i = 1, keys%n
         associate (key => keys%rows(i))
            if (key%is_property .or. .not. key%is_input()) cycle
            if (key%kind /= kind_real .and. key%kind /= kind_integer) cycle
            ! what follows another key has that one's
            if (key%leader > 0) cycle
            call assertTrue(any(origins%key == key%name) .or. any(tenon_origins%key == key%name), &
               trim(key%name))
         end associate
      end do
   end subroutine test_reasons

   subroutine check_page(outcomes)
      type(solid_outcome), intent(in) :: outcomes(:)
      type(report_type) :: report
      type(tenon_case) :: case
      type(key_list) :: usual
      type(error_type), allocatable :: error
      type(string_type), allocatable :: parts(:)
      integer :: i

      report%name = 'solid'
      report%faces = 'faces'
      call declare_replay_case(case, report%keys)
      call declare_replay_case(case, usual)
      ! pictures are asked for
      report%keys%rows(1)%kind = kind_picture
      report%keys%rows(1)%given = given_as_option
      call fill_report(report, outcomes, .false., .true., error)
      call assertFalse(allocated(error))
      call assertTrue(report%has_contact)
      call assertEqual(report%table%rows + 1, report%first_rows(size(outcomes) + 1))
      call assertEqual(report%table%rows, size(report%important))
      call assertEqual(lines + 3, size(report%pictures))
      allocate (parts, source=solid_page(report, case%joint, usual, .true.))
      call assertEqual(lines + 4, size(parts))
      call assertTrue(index(parts(1)%text, 'rough law, this model') > 0)
      call assertTrue((index(parts(1)%text, 'hard contact, this model') > 0) &
         .eqv. size(outcomes) == 2)
      do i = 1, size(report%more)
         call assertEqual(size(report%more(i)%table%columns), report%more(i)%table%set)
      end do
   end subroutine check_page

end module test_program_solid_pictures
