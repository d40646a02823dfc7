!> Joints for the tests of the tenon.
module tenon_cases
   use asperity, only: contact_properties, error_type, new_contact_properties, &
      new_normal_properties, normal_properties, wp
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_run, only: run_tenon
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use asperity_wood_values, only: n_values, set_wood_values, value_names, wood_values
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFalse
   implicit none
   private
   public :: plain_joint, joint_with, face_pair, side_pair, scaled_pair, run_joint

contains

   !> The study's plain joint: hard, fixed, no sides, no extension, rigid column.
   function plain_joint() result(settings)
      type(tenon_settings) :: settings

      settings = tenon_settings(contact='hard', axial_rule='fixed', side_pressure=0.0_wp, &
         extension=0.0_wp, column='rigid')
   end function plain_joint

   !> The default joint with one property of its wood changed.
   function joint_with(name, value) result(settings)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value
      type(tenon_settings) :: settings
      real(wp) :: values(n_values)

      values = wood_values(settings%wood)
      values(findloc(value_names == name, .true., 1)) = value
      call set_wood_values(settings%wood, values)
   end function joint_with

   !> Upper and lower face, with another friction coefficient or rule.
   function face_pair(friction_coefficient, friction_rule) result(properties)
      real(wp), intent(in), optional :: friction_coefficient
      integer, intent(in), optional :: friction_rule
      type(contact_properties) :: properties

      properties = pair_properties(friction_rule=friction_rule)
      if (present(friction_coefficient)) properties%friction_coefficient = friction_coefficient
   end function face_pair

   function side_pair() result(properties)
      type(contact_properties) :: properties

      properties = pair_properties(pair='tangential-tangential')
   end function side_pair

   !> The faces with sigma, R, d0 times s and eta over s^2: all closures shrink by s at the same
   !> pressure, so that s to 0 is hard contact.
   function scaled_pair(s) result(properties)
      real(wp), intent(in) :: s
      type(contact_properties) :: properties, full
      type(normal_properties) :: normal
      type(error_type), allocatable :: error

      full = face_pair()
      associate (n => full%normal)
         call new_normal_properties(normal, n%eta/s**2, n%modulus, n%radius*s, n%hardness, &
            n%yield_factor, n%sigma*s, error, accept_unphysical=.true.)
      end associate
      call new_contact_properties(properties, normal, full%friction_coefficient, &
         full%critical_slip, error)
   end function scaled_pair

   !> Run a joint of the two pairs that must not fail.
   subroutine run_joint(settings, steps, faces, record_at, points)
      type(tenon_settings), intent(in) :: settings
      type(tenon_step), allocatable, intent(out) :: steps(:)
      type(contact_properties), intent(in), optional :: faces
      integer, intent(in), optional :: record_at(:)
      type(tenon_point), allocatable, intent(out), optional :: points(:)
      type(error_type), allocatable :: error

      if (present(faces)) then
         call run_tenon(settings, faces, side_pair(), steps, error, record_at, points)
      else
         call run_tenon(settings, face_pair(), side_pair(), steps, error, record_at, points)
      end if
      call assertFalse(allocated(error), 'runs')
      if (allocated(error)) call assertEqual('', error%message, 'no message')
   end subroutine run_joint

end module tenon_cases
