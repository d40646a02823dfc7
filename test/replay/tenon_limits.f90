!> The tenon joint where something ends: at the edges of the mortise, at the cap of wood without
!> hardening, and at the limits of grip and pull-out.
module test_replay_tenon_limits
   use asperity, only: contact_properties, contact_response, error_type, rule_abaqus, &
      rule_dissipative, status_open, wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction, only: slide
   use asperity_replay_tenon_contact_record, only: contact_record, keep_response, leave_surface
   use asperity_replay_tenon_contact_rough, only: rough_law
   use asperity_replay_tenon_geometry, only: new_tenon_model, tenon_model
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use tenon_cases, only: face_pair, run_joint, side_pair
   implicit none
   private
   public :: suite_tenon_limits

contains

   function suite_tenon_limits() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon limits')
      call suite%addTest(TestMethod('area in the mortise', test_area))
      call suite%addTest(TestMethod('energy that crosses the edges', test_edge_energy))
      call suite%addTest(TestMethod('wood at its cap', test_cap))
      call suite%addTest(TestMethod('just below the cap', test_below_cap))
      call suite%addTest(TestMethod('grip of the sides', test_grip))
      call suite%addTest(TestMethod('an open point bears nothing', test_open))
   end function suite_tenon_limits

   !> A tenon that its axial force pulls out or pushes in while it is turned.
   function driven_joint(force, contact, increment) result(settings)
      real(wp), intent(in) :: force, increment
      character(len=*), intent(in) :: contact
      type(tenon_settings) :: settings

      settings = tenon_settings(contact=contact, axial_rule='force', axial_force=force, &
         side_pressure=0.2_wp, amplitudes=[8.0_wp, 16.0_wp], points=50, side_points=10, &
         displacement_increment=increment)
   end function driven_joint

   !> A cell counts as far as it lies in the mortise, X from -length to 0: at the mouth, where the
   !> extension comes in, and at the back, through which the tenon is pushed.
   subroutine test_area()
      real(wp), parameter :: forces(2) = [6000.0_wp, -6000.0_wp]
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      type(tenon_point), allocatable :: points(:)
      real(wp) :: x, cell, width, covered
      integer :: i, j, at(4), partly_back, partly_front

      at = [10, 30, 64, 96]
      do j = 1, 2
         s = driven_joint(forces(j), 'hard', 1.0_wp)
         call run_joint(s, steps, record_at=at, points=points)
         if (anyExceptions()) return
         partly_back = 0
         partly_front = 0
         do i = 1, size(points)
            associate (p => points(i), step => steps(points(i)%step))
               ! tenon and extension are whole numbers of cells
               cell = merge(6.0_wp, 30.0_wp, p%face <= 2)
               width = merge(s%width, 30.0_wp, p%face <= 2)
               x = step%pull_out + p%x*cos(step%rotation) - p%y*sin(step%rotation)
               covered = max(min(x + 0.5_wp*cell, 0.0_wp) - max(x - 0.5_wp*cell, -s%length), 0.0_wp)
               call assertEqual(width*covered, p%area, 1.0e-9_wp*width*cell, 'area')
               if (covered > 0.0_wp .and. covered < 0.999_wp*cell) then
                  if (x < -0.5_wp*s%length) partly_back = partly_back + 1
                  if (x > -0.5_wp*s%length) partly_front = partly_front + 1
               end if
            end associate
         end do
         call assertGreaterThan(partly_front, 10, message='partly covered at the mouth')
         if (j == 2) call assertGreaterThan(partly_back, 10, message='and at the back')
      end do
   end subroutine test_area

   !> Work into the points is what is stored, dissipated and lost at the edges, also where what
   !> crosses them is ten times what the step leaves.
   subroutine test_edge_energy()
      real(wp), parameter :: forces(2) = [6000.0_wp, -6000.0_wp]
      character(len=5), parameter :: contacts(2) = ['hard ', 'rough']
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: rest, worst
      integer :: i, j

      worst = 0.0_wp
      do j = 1, 2
         do i = 1, 2
            call run_joint(driven_joint(forces(j), contacts(i), 0.125_wp), steps)
            if (anyExceptions()) return
            associate (first => steps(0), last => steps(ubound(steps, 1)))
               rest = last%contact_work - (last%stored - first%stored + last%friction &
                  + last%plastic + last%edge - last%elastic_slip)
               call worsen(worst, rest/last%edge)
               ! out: what was stored leaves at the mouth; in: more comes there than leaves behind
               call assertGreaterThan(forces(j)*last%edge, 1000.0_wp*abs(forces(j)), 'edge')
            end associate
         end do
      end do
      call record('tenon.edge_energy', worst)
      call assertLessThan(worst, 0.1_wp, 'balance')
   end subroutine test_edge_energy

   !> The law of a rough joint of capped wood.
   subroutine capped_law(law, strength)
      type(rough_law), intent(out) :: law
      real(wp), intent(in) :: strength
      type(tenon_settings) :: s
      type(tenon_model) :: model
      type(error_type), allocatable :: error

      s%wood%hardening_across = 0.0_wp
      s%wood%compression_strengths(2) = strength
      s%gap = 'first_touch'
      call new_tenon_model(model, s, face_pair(), side_pair(), error)
      call assertFalse(allocated(error), 'model')
      select type (rough => model%law)
      type is (rough_law)
         law = rough
      end select
   end subroutine capped_law

   subroutine press(law, start, closure, trial)
      type(rough_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure
      type(contact_record), intent(inout) :: trial
      type(error_type), allocatable :: error

      call law%close(start, closure, [0.0_wp, 0.0_wp], trial, error)
      call assertFalse(allocated(error), 'overclosure found')
      trial%weight = 1.0_wp
   end subroutine press

   !> Pressed past the cap, the pressure stays and the tenon's wood takes the rest of the closure;
   !> then it springs back and is pressed again, further.
   subroutine test_cap()
      type(rough_law) :: law
      type(contact_record) :: start, trial
      real(wp) :: worst, indentation, closure
      integer :: i

      call capped_law(law, 4.7_wp)
      worst = 0.0_wp
      start = contact_record()
      do i = 1, 5
         closure = i*2.5_wp
         trial = start
         call press(law, start, closure, trial)
         indentation = closure - law%yields_at - 4.7_wp*law%wood%compliance
         call worsen(worst, largest_of([trial%state%pressure/4.7_wp - 1.0_wp, &
            trial%indentation(1)/indentation - 1.0_wp]))
         call assertEqual(0.0_wp, trial%indentation(2), 0.0_wp, 'the column does not yield')
         call assertEqual([0.0_wp, 0.0_wp], [trial%stiffness, trial%overclosure_by_closure], &
            0.0_wp, 'no stiffness')
         start = trial
         ! back by half the elastic deflection: no further indentation, less pressure
         call press(law, start, closure - 0.5_wp*4.7_wp*law%wood%compliance, trial)
         call assertEqual(start%indentation, trial%indentation, 0.0_wp, 'keeps its indentation')
         call assertEqual(closure - 0.5_wp*4.7_wp*law%wood%compliance, trial%state%overclosure &
            + trial%state%pressure*law%wood%compliance + sum(trial%indentation), 1.0e-12_wp, &
            'in series')
         call assertTrue(trial%state%pressure < 4.7_wp .and. trial%state%pressure > 2.0_wp, &
            'springs back')
         start = trial
      end do
      call record('tenon.cap', worst)
      ! the compiled law is within 1e-10 of the one that gives the overclosure at the cap
      call assertLessThan(worst, 1.0e-9_wp, 'pressure and indentation')
   end subroutine test_cap

   !> Just short of the cap nothing is indented, although the compiled law may give a pressure above
   !> it there by its own error.
   subroutine test_below_cap()
      type(rough_law) :: law
      type(contact_record) :: start, trial
      real(wp) :: at_cap
      integer :: i, j

      do j = 1, 40
         call capped_law(law, 0.2_wp*j)
         at_cap = law%yields_at + 0.2_wp*j*law%wood%compliance
         do i = 1, 36
            start = contact_record()
            trial = start
            call press(law, start, at_cap*(1.0_wp - 1.0e-15_wp*2.0_wp**i), trial)
            call assertEqual(0.0_wp, sum(trial%indentation), 1.0e-12_wp, to_text(0.2_wp*j)//' MPa')
            ! within that error the overclosure may be that at the cap
            if (i > 26) call assertGreaterThan(trial%stiffness, 0.0_wp, 'elastic')
            if (anyExceptions()) return
         end do
      end do
   end subroutine test_below_cap

   !> Both sides hold 2 mu p length height, 22.5 kN: a force of that is refused, the next below
   !> not; without force nothing needs to hold.
   subroutine test_grip()
      real(wp), parameter :: grip = 22500.0_wp
      type(contact_properties) :: sides

      sides = side_pair()
      sides%friction_coefficient = 0.5_wp
      call check(grip, .false.)
      call check(-grip, .false.)
      call check(nearest(grip, -1.0_wp), .true.)
      call check(-nearest(grip, -1.0_wp), .true.)
   contains
      subroutine check(force, passes)
         real(wp), intent(in) :: force
         logical, intent(in) :: passes
         type(tenon_model) :: model
         type(error_type), allocatable :: error

         call new_tenon_model(model, tenon_settings(length=300.0_wp, height=300.0_wp, &
            side_pressure=0.25_wp, axial_rule='force', axial_force=force), face_pair(), sides, &
            error)
         call assertTrue(passes .neqv. allocated(error), to_text(force)//' N')
      end subroutine check
   end subroutine test_grip

   !> A point that slipped under pressure and then opens, or leaves the mortise, has no stress, no
   !> stiffness and no tangential energy; what its elastic slip stored is lost.
   subroutine test_open()
      type(contact_properties) :: sides
      type(contact_record) :: closed, open, away
      integer :: rule

      do rule = rule_abaqus, rule_dissipative
         sides = face_pair(friction_rule=rule)
         call at_pressure(sides, contact_record(), 0.0_wp, 2.0_wp, closed)
         call assertGreaterThan(closed%tangential_energy, 0.01_wp, 'stored')
         open = closed
         call at_pressure(sides, closed, -1.0_wp, 0.0_wp, open)
         call check(open)
         call assertEqual(merge([-1.0_wp, 0.0_wp], [0.0_wp, 1.0_wp], rule == rule_abaqus) &
            *closed%tangential_energy, [open%pressure_coupling, open%dissipation], 1.0e-15_wp, &
            'lost')
         away = closed
         call leave_surface(closed, away)
         call check(away)
         call assertEqual([0.0_wp, 0.0_wp], [away%weight, away%dissipation], 0.0_wp, 'away')
      end do
   contains
      !> The point slides, touching from zero overclosure on
      subroutine at_pressure(properties, start, overclosure, pressure, trial)
         type(contact_properties), intent(in) :: properties
         type(contact_record), intent(in) :: start
         real(wp), intent(in) :: overclosure, pressure
         type(contact_record), intent(inout) :: trial
         type(contact_response) :: response

         response%traction(1) = pressure
         call slide(response, properties, start%state, start%state%elastic_slip, overclosure, &
            [0.1_wp, 0.2_wp], is_open=.not. pressure > 0.0_wp, closing=0.0_wp)
         call keep_response(trial, response, overclosure, 1.0_wp)
      end subroutine at_pressure

      subroutine check(point)
         type(contact_record), intent(in) :: point

         call assertEqual(status_open, point%state%status, 'open')
         call assertEqual(0.0_wp, [point%state%pressure, point%state%elastic_slip, point%shear, &
            point%stiffness, point%shear_by_closure, reshape(point%shear_by_slip, [4]), &
            point%tangential_energy], 0.0_wp, 'nothing')
         call assertEqual(1.0_wp, point%overclosure_by_closure, 0.0_wp, 'the face opens alone')
      end subroutine check
   end subroutine test_open

end module test_replay_tenon_limits
