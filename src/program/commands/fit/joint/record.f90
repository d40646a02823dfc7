!> A record of a joint, thinned to the samples that a fit compares.
module asperity_program_commands_fit_joint_record
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_turning_points, only: find_turning_points
   use asperity_program_record_names, only: find_meaning, holds_pressure
   use asperity_program_record_conditions, only: condition_type
   implicit none
   private
   public :: check_constants, joint_record, thin_record

   !> What a joint is led along, and the force that it should give.
   type :: joint_record
      !> What messages call it
      character(len=:), allocatable :: name
      !> Displacement of the load point, mm, and force on it, N
      real(wp), allocatable :: displacement(:), force(:)
      !> Samples that the record had
      integer :: samples = 0
   end type joint_record

   !> Reversals up to this share of the range are noise, as in `asperity hysteresis`
   real(wp), parameter :: noise_share = 1.0_wp/400.0_wp

contains

   !> Keep samples that lie evenly along the way of the displacement, and those where it turns.
   pure subroutine thin_record(record, displacement, force, most)
      !> Its samples are set
      type(joint_record), intent(inout) :: record
      !> All samples, mm and N
      real(wp), intent(in) :: displacement(:), force(:)
      !> How many are kept, but for the turns
      integer, intent(in) :: most
      integer, allocatable :: turns(:)
      logical :: kept(size(displacement))
      real(wp) :: way, last
      integer :: i

      record%samples = size(displacement)
      kept = .true.
      if (size(displacement) > most) then
         call find_turning_points(displacement, &
            noise_share*(maxval(displacement) - minval(displacement)), turns)
         way = 0.0_wp
         last = displacement(1)
         do i = 1, size(turns)
            way = way + abs(displacement(turns(i)) - last)
            last = displacement(turns(i))
         end do
         kept = .false.
         kept(1) = .true.
         kept(turns) = .true.
         last = displacement(1)
         do i = 2, size(displacement)
            kept(i) = kept(i) .or. abs(displacement(i) - last) >= way/most
            if (kept(i)) last = displacement(i)
         end do
      end if
      record%displacement = pack(displacement, kept)
      record%force = pack(force, kept)
   end subroutine thin_record

   !> Set `error` when what tells tests apart says that they are none of a joint, or of hard
   !> contact.
   pure subroutine check_constants(constants, error)
      !> Leading columns that are the same in a test
      type(condition_type), intent(in) :: constants(:)
      !> Set then
      type(error_type), allocatable, intent(out) :: error
      integer :: holds, i, rank

      do i = 1, size(constants)
         associate (c => constants(i))
            call find_meaning(c%name, holds, rank)
            if (holds == holds_pressure) call fatal_error(error, 'column '//c%name// &
               ' is that of shear tests, which are no records of a joint (--kind shear)')
            if (c%name == 'model' .and. c%value == 'hard') call fatal_error(error, &
               'holds a replay with hard contact, but the model here has the rough law: '// &
               'take the other by --where model=rough')
         end associate
         if (allocated(error)) return
      end do
   end subroutine check_constants

end module asperity_program_commands_fit_joint_record
