!> Solid joints made by formulas, for tests of what the command shows: a spring beside a slider that
!> has a spring of its own.
module made_outcomes
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: status_open, status_slip, status_stick
   use asperity_program_commands_joint_loops, only: analyse_loops
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_commands_solid_snapshot, only: contact_value, solid_snapshot
   use asperity_solid_solve_record, only: increment_record
   implicit none
   private
   public :: made_outcome, made_force, made_snapshot

   !> Stiffness of the spring and of the slider's, N/mm; friction of the slider, N
   real(wp), parameter, public :: spring = 500.0_wp, slider_spring = 2000.0_wp, friction = 2000.0_wp
   !> Where the load turns, mm, how long an increment is, mm, and the arm, mm
   real(wp), parameter, public :: turns(*) = [0.0_wp, 8.0_wp, -8.0_wp, 8.0_wp, -8.0_wp, 24.0_wp, &
      -24.0_wp, 24.0_wp, -24.0_wp, 0.0_wp], increment = 0.5_wp, arm = 500.0_wp

contains

   !> The forces of all increments and where they are, at a share of the joint's forces.
   pure subroutine made_force(share, displacement, force)
      real(wp), intent(in) :: share
      real(wp), allocatable, intent(out) :: displacement(:), force(:)
      real(wp) :: x, slider
      integer :: i, j, n

      allocate (displacement(0), force(0))
      slider = 0.0_wp
      do i = 2, size(turns)
         n = nint(abs(turns(i) - turns(i - 1))/increment)
         do j = 1, n
            x = turns(i - 1) + (turns(i) - turns(i - 1))*j/n
            slider = max(-friction, min(friction, &
               slider + slider_spring*(turns(i) - turns(i - 1))/n))
            displacement = [displacement, x]
            force = [force, share*(spring*x + slider)]
         end do
      end do
   end subroutine made_force

   !> A joint.
   function made_outcome(model, share) result(outcome)
      integer, intent(in) :: model
      real(wp), intent(in) :: share
      type(solid_outcome) :: outcome
      type(error_type), allocatable :: error
      real(wp), allocatable :: displacement(:), force(:)
      integer :: i

      call made_force(share, displacement, force)
      outcome%model = model
      allocate (outcome%records(size(force)))
      do i = 1, size(force)
         outcome%records(i) = increment_record(stroke=1, iterations=3, &
            displacement=displacement(i), force=force(i), rotation=0.6_wp*displacement(i)/arm, &
            pull_out=0.01_wp*i, work=2.0_wp*i, friction=share*i, plastic=0.5_wp*i)
         outcome%records(i)%largest_pressure = [real(wp) :: i, 2*i, 0.0_wp]
         outcome%records(i)%largest_mean_pressure = 1.5_wp*i
         outcome%records(i)%normal_force = [max(0.0_wp, force(i)), max(0.0_wp, -force(i)), 100.0_wp]
      end do
      outcome%pairs = [character(len=8) :: 'upper', 'lower', 'side']
      outcome%arm = arm
      outcome%rotation_name = 'drift'
      outcome%iterations = 3*size(force)
      allocate (outcome%snapshots(0))
      allocate (outcome%mesh%nodes(3, 8), outcome%mesh%elements(8, 1), outcome%mesh%part(1))
      outcome%mesh%elements(:, 1) = [1, 2, 3, 4, 5, 6, 7, 8]
      outcome%mesh%part = 1
      outcome%mesh%nodes = reshape(real([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, &
         1, 1, 1, 0, 1, 1], wp), [3, 8])
      call analyse_loops(outcome, [0.0_wp, displacement/arm], [0.0_wp, arm*force], .false., error)
   end function made_outcome

   !> Three cells of 10 by 20 mm above and one at the side, at some pressure; one element.
   pure function made_snapshot(kind, displacement, pressure) result(snapshot)
      integer, intent(in) :: kind
      real(wp), intent(in) :: displacement, pressure
      type(solid_snapshot) :: snapshot

      snapshot%kind = kind
      snapshot%stroke = kind
      snapshot%displacement = displacement
      allocate (snapshot%contact(4))
      snapshot%contact%area = 200.0_wp
      snapshot%contact(1) = contact_value(1, [-5.0_wp, 10.0_wp, 100.0_wp], &
         [10.0_wp, 20.0_wp, 0.0_wp], 200.0_wp, 0.5_wp, 0.0_wp, pressure, [0.1_wp, 0.2_wp], &
         status_slip)
      snapshot%contact(2) = contact_value(1, [-15.0_wp, 10.0_wp, 100.0_wp], &
         [10.0_wp, 20.0_wp, 0.0_wp], 200.0_wp, 1.0_wp, 0.1_wp, 0.0_wp, [0.0_wp, 0.0_wp], &
         status_open)
      ! past the rim
      snapshot%contact(3) = contact_value(1, [5.0_wp, 10.0_wp, 100.0_wp], &
         [10.0_wp, 20.0_wp, 0.0_wp], 200.0_wp, 0.0_wp, 0.0_wp, 99.0_wp, [0.0_wp, 0.0_wp], &
         status_open)
      snapshot%contact(4) = contact_value(3, [-5.0_wp, 20.0_wp, -100.0_wp], &
         [10.0_wp, 0.0_wp, 20.0_wp], 200.0_wp, 1.0_wp, 0.0_wp, 0.4_wp, [0.0_wp, 0.0_wp], &
         status_stick)
      allocate (snapshot%plastic_strain(1), source=0.25_wp)
      allocate (snapshot%stress(6, 1), source=1.0_wp/3.0_wp)
   end function made_snapshot

end module made_outcomes
