!> Settings of the tenon joint: sizes, wood, axial rule, resolution and load programme.
!>
!> The drawing, symbols and signs are in geometry.f90. What the paper does not print is marked
!> as chosen. Sizes that follow from others are allocatable: `complete_tenon_settings` sets
!> those that are not allocated, and a run does it by itself.
module asperity_replay_tenon_settings
   use asperity_base_kinds, only: wp
   use asperity_paper_joint, only: joint_amplitudes, joint_cycles
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: tenon_settings, complete_tenon_settings, tenon_amplitudes, tenon_face_arm

   !> Sizes, wood, axial rule, resolution and load programme of one joint.
   type :: tenon_settings
      !> Length of the tenon in the mortise, which is the column's depth, mm; chosen
      real(wp) :: length = 300.0_wp
      !> Height of the tenon, mm; chosen
      real(wp) :: height = 300.0_wp
      !> Width of the tenon, mm; chosen
      real(wp) :: width = 105.0_wp
      !> Clearance above and below the tenon, mm, as `gap` defines it; chosen
      real(wp) :: clearance_above = 0.5_wp, clearance_below = 0.5_wp
      !> Length of full material that runs on past the column face, mm; a fifth of `height` when not
      !> allocated; no use with shoulders
      real(wp), allocatable :: extension
      !> Distance of the load point from `arm_datum`, mm
      real(wp) :: arm = 500.0_wp
      !> Where the arm is measured from, and the moment is taken about: `column_face` or
      !> `column_axis`, which lies length/2 inside the face
      character(len=16) :: arm_datum = 'column_face'
      !> What the clearance means: distance of the `mean_plane` of the summits to the other face, or
      !> motion until `first_touch` (separation d0); the same for hard contact
      character(len=16) :: gap = 'mean_plane'
      !> Pressure on the two side faces, MPa; none when zero; chosen: of 0.1, 0.2, ... the first
      !> with which the stiffness of both models falls from the first rotation on, as in Fig. 29
      real(wp) :: side_pressure = 0.4_wp
      !> What holds the tenon along its axis: `spring`, `fixed`, `free`, or a given `force`, through
      !> the middle of the tenon at the column face
      character(len=16) :: axial_rule = 'spring'
      !> Stiffness of the spring, N/mm; chosen
      real(wp) :: axial_stiffness = 500.0_wp
      !> The given force on the tenon, N; positive pulls it out
      real(wp) :: axial_force = 0.0_wp
      !> Whether shoulders above and below the tenon bear on the column face
      logical :: shoulders = .false.
      !> Height of each shoulder, mm; a sixth of `height` when not allocated
      real(wp), allocatable :: shoulder_height
      !> Gap between each shoulder and the column face, mm
      real(wp) :: shoulder_gap = 0.0_wp
      !> Vertical load of the column, N, for information only
      real(wp) :: column_load = 0.0_wp
      !> Wood of tenon and column. Pressed across the grain, the tenon has the properties in R;
      !> along it, the column those in L. All criteria but `none` are one here, and curves of no use
      type(wood_properties) :: wood = wood_properties()
      !> Whether the column gives way: `elastic`, or `rigid`
      character(len=16) :: column = 'elastic'
      !> Depth of wood that the bearing of the tenon, and of the column, compresses, mm: a modulus
      !> over it is a stiffness; chosen, half of `height` when not allocated
      real(wp), allocatable :: bearing_depth, column_depth
      !> Contact points along each face over `length`, along each side of a side face, and over each
      !> shoulder's height
      integer :: points = 100, side_points = 12, shoulder_points = 16
      !> Largest step of the displacement, mm
      real(wp) :: displacement_increment = 0.8_wp
      !> `rough` or `hard`: a rigid interface with the same friction
      character(len=16) :: contact = 'rough'
      !> Whether every contact point of the rough joint is run through UINTER
      logical :: through_uinter = .false.
      !> Amplitudes, mm, and how many cycles of each; the paper's when not allocated: 0.5, 1, 2,
      !> 4 mm once; 8, 16, 24, 32, 48 mm three times
      real(wp), allocatable :: amplitudes(:)
      integer, allocatable :: cycles(:)
      !> Recorded displacements of the load point, mm, in place of amplitudes
      real(wp), allocatable :: displacement(:)
      !> Let sizes outside the ranges of `asperity_replay_sizes` and rotations outside those of
      !> `asperity_replay_tenon_turns` pass
      logical :: accept_sizes = .false.
   end type tenon_settings

   !> What follows from the height of the tenon, over it
   real(wp), parameter :: depth_ratio = 0.5_wp, extension_ratio = 0.2_wp, &
      shoulder_ratio = 1.0_wp/6.0_wp

contains

   !> Give sizes that follow from the height their values unless they have some.
   pure subroutine complete_tenon_settings(settings)
      !> Settings
      type(tenon_settings), intent(inout) :: settings

      associate (s => settings)
         if (.not. allocated(s%bearing_depth)) s%bearing_depth = depth_ratio*s%height
         if (.not. allocated(s%column_depth)) s%column_depth = depth_ratio*s%height
         if (.not. allocated(s%extension)) s%extension = extension_ratio*s%height
         if (.not. allocated(s%shoulder_height)) s%shoulder_height = shoulder_ratio*s%height
      end associate
   end subroutine complete_tenon_settings

   !> Distance of the load point from the column face, mm.
   pure real(wp) function tenon_face_arm(settings)
      !> Settings
      type(tenon_settings), intent(in) :: settings

      tenon_face_arm = settings%arm
      if (settings%arm_datum == 'column_axis') &
         tenon_face_arm = settings%arm - 0.5_wp*settings%length
   end function tenon_face_arm

   !> The amplitudes and cycles of the settings, or the paper's.
   pure subroutine tenon_amplitudes(settings, amplitudes, cycles)
      !> Settings
      type(tenon_settings), intent(in) :: settings
      !> Amplitudes, mm
      real(wp), allocatable, intent(out) :: amplitudes(:)
      !> Cycles of each
      integer, allocatable, intent(out) :: cycles(:)

      if (allocated(settings%amplitudes)) then
         amplitudes = settings%amplitudes
         if (allocated(settings%cycles)) then
            cycles = settings%cycles
         else
            allocate (cycles(size(amplitudes)), source=1)
         end if
      else
         amplitudes = joint_amplitudes
         cycles = joint_cycles
         if (allocated(settings%cycles)) cycles = settings%cycles
      end if
   end subroutine tenon_amplitudes

end module asperity_replay_tenon_settings
