!> The kinds of interface law of the tenon joint: each on one point of a face and one of a side.
module test_replay_tenon_laws
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, rule_abaqus, rule_dissipative, status_open, wp
   use asperity_replay_tenon_contact_hard, only: hard_law
   use asperity_replay_tenon_contact_interface_law, only: interface_law
   use asperity_replay_tenon_contact_record, only: contact_record
   use asperity_replay_tenon_contact_rough, only: rough_law
   use asperity_replay_tenon_contact_uinter, only: uinter_law
   use asperity_replay_tenon_contact_wood_bearing, only: new_wood_bearing
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_settings
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   use tenon_cases, only: face_pair, side_pair
   implicit none
   private
   public :: suite_tenon_laws

   character(len=6), parameter :: kinds(3) = ['hard  ', 'rough ', 'uinter']
   integer, parameter :: rules(2) = [rule_abaqus, rule_dissipative]

contains

   function suite_tenon_laws() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon laws')
      call suite%addTest(TestMethod('derivatives of every kind', test_derivatives))
      call suite%addTest(TestMethod('through UINTER as without', test_uinter))
   end function suite_tenon_laws

   !> A law of a face (point 1) and a side (point 2) on wood of two layers.
   subroutine new_law(law, kind, rule)
      class(interface_law), allocatable, intent(out) :: law
      character(len=*), intent(in) :: kind
      integer, intent(in) :: rule
      type(tenon_settings) :: s
      type(error_type), allocatable :: error

      select case (kind)
      case ('hard')
         allocate (hard_law :: law)
      case ('rough')
         allocate (rough_law :: law)
      case default
         allocate (uinter_law :: law)
      end select
      s%wood%compression_strengths(1) = 6.0_wp
      call complete_tenon_settings(s)
      law%faces = face_pair(friction_rule=rule)
      law%sides = side_pair()
      law%wood = new_wood_bearing(s)
      law%side_pressure = 0.2_wp
      call law%prepare([.false., .true.], error)
      call assertFalse(allocated(error), 'law')
   end subroutine new_law

   !> A face at a closure.
   function closed(law, start, closure, slip) result(trial)
      class(interface_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure, slip
      type(contact_record) :: trial
      type(error_type), allocatable :: error

      trial = start
      call law%close(start, closure, [slip, 0.0_wp], trial, error)
      call assertFalse(allocated(error), 'closed')
   end function closed

   !> A side after a slip.
   function slid(law, start, slip) result(trial)
      class(interface_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: slip(2)
      type(contact_record) :: trial
      type(error_type), allocatable :: error

      trial = start
      call law%slide(start, slip, trial, error)
      call assertFalse(allocated(error), 'slid')
   end function slid

   !> Random paths through touch, yield of both layers, stick, slip and reversals, by both rules:
   !> pressure and shear stress by closure and slip against central differences.
   subroutine test_derivatives()
      real(wp), parameter :: h = 1.0e-6_wp
      class(interface_law), allocatable :: law
      type(contact_record) :: face, beside, trial, ahead, behind
      type(random_stream) :: stream
      real(wp) :: closure, slip, turn(2), step(2), worst, tau
      integer :: i, j, kind, rule, yields, closes

      do kind = 1, size(kinds)
         stream = random_stream(31_int64)
         worst = 0.0_wp
         yields = 0
         closes = 0
         do rule = 1, 2
            call new_law(law, trim(kinds(kind)), rules(rule))
            face = contact_record(point=1)
            beside = contact_record(point=2)
            do i = 1, 300
               closure = stream%uniform(-1.5_wp, 4.0_wp) + sum(face%indentation)
               slip = stream%uniform(-1.0_wp, 1.0_wp)*law%faces%critical_slip
               trial = closed(law, face, closure, slip)
               ahead = closed(law, face, closure + h, slip)
               behind = closed(law, face, closure - h, slip)
               if (smooth(face, ahead, behind)) &
                  call worsen(worst, largest_of([(ahead%state%pressure - behind%state%pressure) &
                  /(2.0_wp*h) - trial%stiffness, (ahead%shear - behind%shear)/(2.0_wp*h) &
                  - trial%shear_by_closure])*law%wood%compliance)
               ahead = closed(law, face, closure, slip + h)
               behind = closed(law, face, closure, slip - h)
               tau = law%faces%friction_coefficient*max(trial%state%pressure, 0.1_wp) &
                  /law%faces%critical_slip
               if (smooth(face, ahead, behind)) call worsen(worst, &
                  largest_of((ahead%shear - behind%shear)/(2.0_wp*h) &
                  - trial%shear_by_slip(:, 1))/tau)
               if (sum(trial%indentation) > sum(face%indentation)) yields = yields + 1
               if (face%state%status == status_open .and. trial%state%status /= status_open) &
                  closes = closes + 1

               turn = law%sides%critical_slip*[stream%uniform(-1.0_wp, 1.0_wp), &
                  stream%uniform(-1.0_wp, 1.0_wp)]
               tau = law%sides%friction_coefficient*law%side_pressure/law%sides%critical_slip
               do j = 1, 2
                  step = merge([h, 0.0_wp], [0.0_wp, h], j == 1)
                  ahead = slid(law, beside, turn + step)
                  behind = slid(law, beside, turn - step)
                  trial = slid(law, beside, turn)
                  if (smooth(beside, ahead, behind)) call worsen(worst, &
                     largest_of((ahead%shear - behind%shear)/(2.0_wp*h) &
                     - trial%shear_by_slip(:, j))/tau)
               end do
               beside = trial
               face = closed(law, face, closure, slip)
               call law%accept()
               if (anyExceptions()) return
            end do
         end do
         call record('tenon.law.derivatives.'//trim(kinds(kind)), worst)
         call assertLessThan(worst, 1.0e-5_wp, kinds(kind))
         call assertGreaterThan(yields, 5, message='yields')
         call assertGreaterThan(closes, 50, message='closes')
      end do
   end subroutine test_derivatives

   !> Whether no corner of status, yield or of the pressure's rise lies between two trials.
   pure logical function smooth(start, ahead, behind)
      type(contact_record), intent(in) :: start, ahead, behind

      smooth = ahead%state%status == behind%state%status &
         .and. all((ahead%indentation > start%indentation) &
         .eqv. (behind%indentation > start%indentation)) &
         .and. ((ahead%state%pressure > start%state%pressure) &
         .eqv. (behind%state%pressure > start%state%pressure))
   end function smooth

   !> The same path with UINTER and without: separation too, whatever was stored before.
   subroutine test_uinter()
      class(interface_law), allocatable :: laws, through
      type(contact_record) :: face(2), beside(2), after(2)
      type(error_type), allocatable :: error
      type(random_stream) :: stream
      real(wp) :: closure, slip, turn(2), worst
      integer :: i, rule

      stream = random_stream(47_int64)
      worst = 0.0_wp
      do rule = 1, 2
         call new_law(laws, 'rough', rules(rule))
         call new_law(through, 'uinter', rules(rule))
         face = contact_record(point=1)
         beside = contact_record(point=2)
         do i = 1, 200
            closure = stream%uniform(-0.5_wp, 4.0_wp)
            slip = stream%uniform(-1.0_wp, 1.0_wp)
            turn = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
            if (mod(i, 7) == 0) then
               after = face
               call laws%separate(face(1), after(1), error)
               call assertFalse(allocated(error), 'separated')
               call through%separate(face(2), after(2), error)
               call assertFalse(allocated(error), 'separated through UINTER')
               call assertEqual(0.0_wp, maxval(abs([after%state%pressure, after(1)%shear, &
                  after(2)%shear, after%tangential_energy])), 0.0_wp, 'nothing is left')
            else
               after = [closed(laws, face(1), closure, slip), &
                  closed(through, face(2), closure, slip)]
            end if
            face = after
            beside = [slid(laws, beside(1), turn), slid(through, beside(2), turn)]
            call through%accept()
            call worsen(worst, distance(face(1), face(2)))
            call worsen(worst, distance(beside(1), beside(2)))
            if (anyExceptions()) return
         end do
      end do
      call record('tenon.law.uinter', worst)
      ! the compiled law is within 1e-10 of that which UINTER evaluates
      call assertLessThan(worst, 1.0e-9_wp, 'the same')
   end subroutine test_uinter

   !> How far two records are apart: stresses over 1 MPa, energies over 1 N/mm, lengths over 1 mm.
   pure real(wp) function distance(a, b)
      type(contact_record), intent(in) :: a, b

      distance = maxval(abs([a%state%pressure - b%state%pressure, a%shear - b%shear, &
         a%state%elastic_slip - b%state%elastic_slip, a%indentation - b%indentation, &
         a%tangential_energy - b%tangential_energy, a%dissipation - b%dissipation, &
         a%pressure_coupling - b%pressure_coupling]))
      if (a%state%status /= b%state%status) distance = huge(1.0_wp)
   end function distance

end module test_replay_tenon_laws
