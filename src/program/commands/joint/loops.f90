!> Hard contact beside the rough law: what is common to a tenon joint in a plane and as a solid.
module asperity_program_commands_joint_loops
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_analysis, only: analyse_hysteresis, hysteresis_result, &
      hysteresis_settings
   use asperity_program_report_units, only: joule, kilonewton_metre
   implicit none
   private
   public :: joint_loops, analyse_loops, largest_cycle, loop_joules

   !> Contact models, in the order of tables
   integer, parameter, public :: hard = 1, rough = 2
   character(len=5), parameter, public :: model_names(2) = [character(len=5) :: 'hard', 'rough']
   !> The same for readers
   character(len=12), parameter, public :: legends(2) = ['hard contact', 'rough law   ']

   !> Reversals over the largest rotation that are rounding
   real(wp), parameter :: exact = 1.0e-6_wp

   !> A joint under one model.
   type :: joint_loops
      !> `hard` or `rough`
      integer :: model = hard
      !> Whether the joint has a moment at all
      logical :: has_moment = .true.
      !> What is called its rotation in tables and pictures
      character(len=8) :: rotation_name = 'rotation'
      !> Rotation, rad, and moment, kN m, of the joint at rest and of every step
      real(wp), allocatable :: rotation(:), moment(:)
      !> Analysis of moment against rotation, whose samples those are. Without a moment there is no
      !> cycle, and nothing is known
      type(hysteresis_result) :: loops
      !> Time that it took, s
      real(wp) :: seconds = 0.0_wp
   end type joint_loops

contains

   !> Analyse moment against rotation, unless there is no moment. `error` is set when the record is
   !> refused.
   pure subroutine analyse_loops(joint, rotation, moment, has_noise, error)
      !> The joint, with `has_moment`; record and loops are set
      class(joint_loops), intent(inout) :: joint
      !> Rotation, rad, and moment, N mm, of the joint at rest and of every step
      real(wp), intent(in) :: rotation(:), moment(:)
      !> Whether the rotation may have noise, as recorded ones do; that of a programme has none
      logical, intent(in) :: has_noise
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(hysteresis_settings) :: analysis

      joint%rotation = rotation
      joint%moment = kilonewton_metre*moment
      if (.not. joint%has_moment) then
         call leave_unknown(joint%loops)
         return
      end if
      ! Skeletons go through the tips of first cycles, as the paper's do; computed samples are no
      ! outliers
      analysis%peaks = 'displacement'
      analysis%outliers = 'keep'
      if (.not. has_noise) analysis%threshold = exact*maxval(abs(rotation))
      call analyse_hysteresis(joint%rotation, joint%moment, joint%loops, error, analysis)
   end subroutine analyse_loops

   !> What is known of a record without a force: nothing.
   pure subroutine leave_unknown(loops)
      type(hysteresis_result), intent(inout) :: loops
      integer :: side

      allocate (loops%turning_points(0), loops%cycles(0))
      do side = 1, size(loops%skeleton)
         associate (skeleton => loops%skeleton(side))
            allocate (skeleton%displacement(0), skeleton%force(0), skeleton%cycle(0))
         end associate
      end do
   end subroutine leave_unknown

   !> Energy of loops of moment, kN m, against rotation, rad, in J; what is not known stays so.
   pure elemental real(wp) function loop_joules(energy)
      !> The energy, kN m
      real(wp), intent(in) :: energy

      loop_joules = energy
      if (.not. is_none(energy)) loop_joules = energy*(joule/kilonewton_metre)
   end function loop_joules

   !> The first cycle that goes furthest, zero when there is none.
   pure integer function largest_cycle(loops)
      !> Analysis of a record
      type(hysteresis_result), intent(in) :: loops
      real(wp) :: reach, furthest
      integer :: i, sample

      largest_cycle = 0
      furthest = 0.0_wp
      do i = 1, size(loops%cycles)
         reach = 0.0_wp
         do sample = 1, 2
            if (loops%cycles(i)%peak(sample) > 0) &
               reach = max(reach, abs(loops%cycles(i)%displacement(sample)))
         end do
         ! more than rounding
         if (.not. reach > furthest*(1.0_wp + 1.0e-9_wp)) cycle
         furthest = reach
         largest_cycle = i
      end do
   end function largest_cycle

end module asperity_program_commands_joint_loops
