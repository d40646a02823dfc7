!> What the replay of the tenon joint tells of its contact points.
module asperity_replay_tenon_points
   use asperity_base_kinds, only: wp
   use asperity_replay_tenon_forces, only: tenon_increment
   use asperity_replay_tenon_geometry, only: other_side, side, tenon_faces
   implicit none
   private
   public :: tenon_point, record_points

   !> State of one contact point at a chosen step.
   type :: tenon_point
      !> Step, face (see `tenon_face_names`), number in the face
      integer :: step = 0, face = 0, point = 0
      !> `status_open`, `status_stick` or `status_slip`
      integer :: status = 0
      !> Place in the tenon, mm: from the column face outwards, from the axis up
      real(wp) :: x = 0.0_wp, y = 0.0_wp
      !> Area that the point stands for, mm^2, as far as it is in the mortise
      real(wp) :: area = 0.0_wp
      !> Pressure and shear stresses, MPa
      real(wp) :: pressure = 0.0_wp, shear_1 = 0.0_wp, shear_2 = 0.0_wp
      !> Slip of the tenon over the mortise since the start, mm
      real(wp) :: slip_1 = 0.0_wp, slip_2 = 0.0_wp
      !> Permanent indentation of the wood, mm
      real(wp) :: indentation = 0.0_wp
   end type tenon_point

contains

   !> Append the state of every point; both sides are given, which are alike.
   pure subroutine record_points(joint, number, points)
      !> The joint
      type(tenon_increment), intent(in) :: joint
      !> Number of the step
      integer, intent(in) :: number
      !> What was recorded before, and the points of this step
      type(tenon_point), allocatable, intent(inout) :: points(:)
      type(tenon_point), allocatable :: grown(:)
      type(tenon_point) :: point
      integer :: i, n, first(tenon_faces), next

      next = size(points)
      associate (model => joint%model)
         n = size(model%x) + count(model%face == side)
         allocate (grown(next + n))
         grown(:next) = points
         first = 0
         do i = 1, size(model%x)
            first(model%face(i)) = first(model%face(i)) + 1
            associate (s => joint%start(i))
               point = tenon_point(step=number, face=model%face(i), point=first(model%face(i)), &
                  status=s%state%status, x=model%x(i), y=model%y(i), &
                  area=model%area(i)*s%weight, pressure=s%state%pressure, shear_1=s%shear(1), &
                  shear_2=s%shear(2), slip_1=s%slip(1), slip_2=s%slip(2), &
                  indentation=sum(s%indentation))
            end associate
            if (point%face == side) point%area = 0.5_wp*point%area
            next = next + 1
            grown(next) = point
         end do
         do i = size(points) + 1, size(points) + size(model%x)
            if (grown(i)%face /= side) cycle
            next = next + 1
            grown(next) = grown(i)
            grown(next)%face = other_side
         end do
      end associate
      call move_alloc(grown, points)
   end subroutine record_points

end module asperity_replay_tenon_points
