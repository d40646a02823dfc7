!> PROPS as VUINTER gets it, in the precision of the run: read, and found out when the run has
!> another precision than the file that was compiled.
module asperity_abaqus_vuinter_props
   use, intrinsic :: iso_fortran_env, only: real32, real64
   use asperity_abaqus_prop_slots, only: prop_pi, prop_sigma
   use asperity_abaqus_props, only: near_pi, properties_from_props
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: read_props

   !> The precision of runs that this build is not for
   integer, parameter :: other = merge(real32, real64, vp == real64)
   !> So many properties hold the bits of five (`prop_pi`) in the other precision: half as many, or
   !> twice
   integer, parameter :: leading = merge(3, 10, other == real32)
   character(len=*), parameter :: remedy = 'compile asperity_vuinter for a run with double '// &
      'precision, asperity_vuinter_single for one without'

contains

   !> Read and check PROPS. `error` is set when `properties_from_props` refuses it. A list in the
   !> other precision is told by its bits where they are there to see, and is not read on.
   pure subroutine read_props(props, properties, error)
      !> The property list
      real(vp), intent(in) :: props(:)
      !> Checked properties; all of them are set
      type(contact_properties), intent(inout) :: properties
      !> Set when the list is refused
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message

      if (in_other_precision(props)) then
         call fatal_error(error, 'PROPS is in '//merge('single', 'double', other == real32)// &
            ' precision, and this VUINTER is not: '//remedy)
         return
      end if
      call properties_from_props(real(props, wp), properties, error)
      if (.not. allocated(error) .or. size(props) < prop_sigma) return
      if (near_pi(real(props(prop_pi), wp))) return
      allocate (message, source=error%message// &
         '; or the run has another precision than VUINTER: '//remedy)
      call move_alloc(message, error%message)
   end subroutine read_props

   !> Does the list hold pi in its place when read in the other precision, and not in ours?
   pure logical function in_other_precision(props)
      real(vp), intent(in) :: props(:)
      real(other) :: seen(prop_pi)

      in_other_precision = .false.
      if (size(props) < leading) return
      if (near_pi(real(props(prop_pi), wp))) return
      seen = transfer(props(:leading), seen, prop_pi)
      in_other_precision = near_pi(real(seen(prop_pi), wp))
   end function in_other_precision

end module asperity_abaqus_vuinter_props
