!> The tenon joint: geometry, signs, and its contact points.
!>
!> Column on the left, with the mortise; the tenon turns by t about O, the middle of the tenon at
!> the column face (the origin of the mortise's frame X, Y):
!>
!>                     X = -length             X = 0                            load point
!>      column  ///////|///////////////////////|                                     ^ F
!>                     | clearance_above       |                                     |
!>         mortise     |=======================|======                               |
!>                     |   tenon   y ^         | extension     beam                  |
!>                     |             O--> x    O-------------------------------------o
!>                     |=======================|======
!>                     | clearance_below       |
!>      column  ///////|///////////////////////|<------------ arm to the face ------->
!>
!> - Mortise: rigid, flat; the faces are at Y = height/2 + clearance_above and
!>   Y = -(height/2 + clearance_below), from X = -length to 0. Tenon: rigid but for the wood under
!>   each contact point; x from -length to extension, y = -height/2 and height/2.
!> - A tenon point is at X = u + x cos t - y sin t, Y = v + x sin t + y cos t. The rotation t is
!>   displacement/arm, positive when the load point rises; u (pull-out) and v come from equilibrium.
!> - Upper and lower face: the normal is vertical, friction horizontal. Closure past first touch of
!>   the undeformed wood is first - gap, with first the separation d0 at first touch for a
!>   clearance between mean planes, zero for a clearance until first touch and for hard contact.
!> - Sides: a given pressure, slip in X and Y. The two are alike, so that one is computed.
!> - Shoulders: x = 0, from height/2 to height/2 + shoulder_height above and below. Normal
!>   horizontal, friction vertical; end grain of the beam on the side of the column, the same two
!>   woods in series as at the upper face. The extension is inside the beam then.
!> - A cell counts as far as it is in the mortise: its weight changes with X at either edge.
!> - Equilibrium: sum of X forces with the axial force R1 = 0, and moment about the load point
!>   R2 = 0, in which the load F does not occur; F = -(sum of Y forces). The axial force goes
!>   through O. The moment of the joint is F arm, about the datum of the arm.
!> - An open joint is held where it is by `holding_stiffness` on u and v, with its own ledger.
module asperity_replay_tenon_geometry
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: stick_summits
   use asperity_contact_friction_strength, only: largest_shear_stress
   use asperity_contact_properties, only: contact_properties, without_summits
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_replay_steps, only: fewest_steps
   use asperity_replay_tenon_contact_hard, only: hard_law
   use asperity_replay_tenon_contact_interface_law, only: interface_law
   use asperity_replay_tenon_contact_record, only: contact_record
   use asperity_replay_tenon_contact_rough, only: rough_law
   use asperity_replay_tenon_contact_uinter, only: uinter_law
   use asperity_replay_tenon_contact_wood_bearing, only: new_wood_bearing
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_face_arm, tenon_settings
   implicit none
   private
   public :: tenon_model, new_tenon_model, tenon_at_rest, tenon_place

   !> Faces as they are computed
   integer, parameter, public :: upper = 1, lower = 2, side = 3, other_side = 4, &
      upper_shoulder = 5, lower_shoulder = 6, tenon_faces = 6
   !> Their names
   character(len=14), parameter, public :: tenon_face_names(tenon_faces) = [character(len=14) :: &
      'upper', 'lower', 'side_1', 'side_2', 'upper_shoulder', 'lower_shoulder']
   !> Faces that bear, which the sides do not
   integer, parameter, public :: bearing_faces(4) = [upper, lower, upper_shoulder, lower_shoulder]

   !> Geometry and law; read only in a run but for what the law keeps.
   type :: tenon_model
      !> Settings of the joint
      type(tenon_settings) :: settings
      !> Law of its contact points
      class(interface_law), allocatable :: law
      !> Whether the tenon is held along its axis
      logical :: fixed = .false.
      !> Distance of the load point from the column face, mm
      real(wp) :: arm = 0.0_wp
      !> Closure at zero gap, mm
      real(wp) :: first_touch = 0.0_wp
      !> Stiffness of the axial spring, N/mm, and a given axial force, N
      real(wp) :: axial_stiffness = 0.0_wp, axial_force = 0.0_wp
      !> Of each point: its face, place in the tenon and length of its cell, mm; area, mm^2, of both
      !> sides together
      integer, allocatable :: face(:)
      real(wp), allocatable :: x(:), y(:), cell(:), area(:)
      !> Outward normal and wall distance of each face
      real(wp) :: normal(2, tenon_faces) = 0.0_wp, wall(tenon_faces) = 0.0_wp
   end type tenon_model

contains

   !> Build the joint. `error` is set when the faces cannot carry the pressures asked of them.
   subroutine new_tenon_model(model, settings, faces, sides, error)
      !> Result
      type(tenon_model), intent(out) :: model
      !> Checked settings
      type(tenon_settings), intent(in) :: settings
      !> Contact of faces and shoulders, and of the sides
      type(contact_properties), intent(in) :: faces, sides
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      model%settings = settings
      call complete_tenon_settings(model%settings)
      model%fixed = settings%axial_rule == 'fixed'
      model%arm = tenon_face_arm(settings)
      if (settings%axial_rule == 'spring') model%axial_stiffness = settings%axial_stiffness
      if (settings%axial_rule == 'force') model%axial_force = settings%axial_force
      call check_axial_force(settings, sides, error)
      if (allocated(error)) return
      model%normal(:, upper) = [0.0_wp, 1.0_wp]
      model%normal(:, lower) = [0.0_wp, -1.0_wp]
      model%normal(:, upper_shoulder) = [-1.0_wp, 0.0_wp]
      model%normal(:, lower_shoulder) = [-1.0_wp, 0.0_wp]
      model%wall(upper) = 0.5_wp*settings%height + settings%clearance_above
      model%wall(lower) = 0.5_wp*settings%height + settings%clearance_below
      model%wall(upper_shoulder:lower_shoulder) = settings%shoulder_gap
      call place_points(model)
      call choose_law(model, faces, sides, error)
   end subroutine new_tenon_model

   !> The law that the settings ask for.
   subroutine choose_law(model, faces, sides, error)
      type(tenon_model), intent(inout) :: model
      type(contact_properties), intent(in) :: faces, sides
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: separation

      if (model%settings%contact == 'hard') then
         allocate (hard_law :: model%law)
      else
         if (model%settings%through_uinter) then
            allocate (uinter_law :: model%law)
         else
            allocate (rough_law :: model%law)
         end if
         if (model%settings%gap == 'mean_plane') model%first_touch = faces%initial_separation
      end if
      model%law%faces = faces
      if (model%settings%contact == 'hard') model%law%faces = without_summits(faces)
      model%law%sides = sides
      model%law%wood = new_wood_bearing(model%settings)
      model%law%side_pressure = model%settings%side_pressure
      if (sides%friction%stick == stick_summits .and. model%law%side_pressure > 0.0_wp) then
         call separation_for_pressure(sides%normal, model%law%side_pressure, separation, error)
         if (allocated(error)) return
         model%law%side_overclosure = sides%initial_separation - separation
      end if
      call model%law%prepare(model%face == side, error)
   end subroutine choose_law

   !> While the joint is open, only the sides hold against a given force.
   pure subroutine check_axial_force(settings, sides, error)
      type(tenon_settings), intent(in) :: settings
      type(contact_properties), intent(in) :: sides
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: grip

      if (settings%axial_rule /= 'force') return
      grip = 2.0_wp*settings%length*settings%height &
         *largest_shear_stress(sides, settings%side_pressure, moves=.true.)
      if (abs(settings%axial_force) > 0.0_wp .and. .not. abs(settings%axial_force) < grip) &
         call fatal_error(error, 'axial_force = '//to_text(settings%axial_force)// &
         ' N has no equilibrium while the joint is open: friction of the sides holds '// &
         to_text(grip, 4)//' N; raise side_pressure or take another axial_rule', &
         subject='axial_force')
   end subroutine check_axial_force

   !> Cells of equal length over the tenon and, when it runs on, over the extension.
   subroutine place_points(model)
      type(tenon_model), intent(inout) :: model
      real(wp), allocatable :: x(:), cell(:)
      real(wp) :: size_y
      integer :: i

      allocate (model%face(0), model%x(0), model%y(0), model%cell(0), model%area(0))
      associate (s => model%settings)
         call cut(s%points)
         call add(upper, x, [(0.5_wp*s%height, i=1, size(x))], cell, cell*s%width)
         call add(lower, x, [(-0.5_wp*s%height, i=1, size(x))], cell, cell*s%width)
         if (s%side_pressure > 0.0_wp) then
            call cut(s%side_points)
            size_y = s%height/s%side_points
            do i = 1, s%side_points
               call add(side, x, spread(-0.5_wp*s%height + (i - 0.5_wp)*size_y, 1, size(x)), &
                  cell, 2.0_wp*cell*size_y)
            end do
         end if
         if (.not. s%shoulders) return
         size_y = s%shoulder_height/s%shoulder_points
         x = spread(0.0_wp, 1, s%shoulder_points)
         call add(upper_shoulder, x, [(0.5_wp*s%height + (i - 0.5_wp)*size_y, i=1, size(x))], x, &
            x + size_y*s%width)
         call add(lower_shoulder, x, [(-0.5_wp*s%height - (i - 0.5_wp)*size_y, i=1, size(x))], x, &
            x + size_y*s%width)
      end associate

   contains

      !> Middles and lengths of the cells.
      subroutine cut(n)
         integer, intent(in) :: n
         real(wp) :: size_x
         integer :: j, more

         size_x = model%settings%length/n
         x = [(-model%settings%length + (j - 0.5_wp)*size_x, j=1, n)]
         cell = spread(size_x, 1, n)
         if (model%settings%shoulders .or. .not. model%settings%extension > 0.0_wp) return
         more = fewest_steps(model%settings%extension, size_x)
         size_x = model%settings%extension/more
         x = [x, [((j - 0.5_wp)*size_x, j=1, more)]]
         cell = [cell, spread(size_x, 1, more)]
      end subroutine cut

      subroutine add(face, x, y, cell, area)
         integer, intent(in) :: face
         real(wp), intent(in) :: x(:), y(:), cell(:), area(:)

         model%face = [model%face, spread(face, 1, size(x))]
         model%x = [model%x, x]
         model%y = [model%y, y]
         model%cell = [model%cell, cell]
         model%area = [model%area, area]
      end subroutine add

   end subroutine place_points

   !> The points of a joint that nothing has touched yet.
   pure function tenon_at_rest(model) result(points)
      !> Joint
      type(tenon_model), intent(in) :: model
      type(contact_record) :: points(size(model%x))
      integer :: i

      do i = 1, size(points)
         points(i)%point = i
         points(i)%place = tenon_place(model%x(i), model%y(i), [0.0_wp, 0.0_wp], 0.0_wp)
      end do
   end function tenon_at_rest

   !> Place of a tenon point in the mortise, mm.
   pure function tenon_place(x, y, position, rotation) result(place)
      !> Place in the tenon, mm
      real(wp), intent(in) :: x, y
      !> u and v, mm, and rotation, rad
      real(wp), intent(in) :: position(2), rotation
      real(wp) :: place(2)

      place = [position(1) + x*cos(rotation) - y*sin(rotation), &
         position(2) + x*sin(rotation) + y*cos(rotation)]
   end function tenon_place

end module asperity_replay_tenon_geometry
