!> The tenon joint: geometry, signs, and the forces of all contact points at a position.
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
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_law_compiled_law, only: new_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_replay_abaqus_host, only: host_point, new_host_point
   use asperity_replay_tenon_contact, only: contact_record, leave_surface, leave_through_uinter, &
      press_hard, press_rough, press_through_uinter, rub, rub_through_uinter, yield_overclosure
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_face_arm, tenon_settings
   use asperity_replay_tenon_contact_wood_bearing, only: new_wood_bearing, wood_bearing
   implicit none
   private
   public :: tenon_model, tenon_forces, new_tenon_model, tenon_place, evaluate_tenon

   !> Faces as they are computed
   integer, parameter, public :: upper = 1, lower = 2, side = 3, other_side = 4, &
      upper_shoulder = 5, lower_shoulder = 6, n_faces = 6
   !> What keeps an open joint in place, N/mm: far below any contact
   real(wp), parameter, public :: holding_stiffness = 1.0e-4_wp

   !> Geometry and laws; read only in a run but for the hosts of UINTER.
   type :: tenon_model
      !> Settings and contact of the faces and of the sides
      type(tenon_settings) :: settings
      type(contact_properties) :: faces, sides
      !> Wood under the points of faces and shoulders
      type(wood_bearing) :: wood
      logical :: hard = .false., fixed = .false.
      !> Distance of the load point from the column face, mm
      real(wp) :: arm = 0.0_wp
      !> Closure at zero gap, mm, and overclosure where the wood first yields
      real(wp) :: first_touch = 0.0_wp, yields_at = 0.0_wp
      !> Overclosure at which the sides carry their pressure, mm
      real(wp) :: side_overclosure = 0.0_wp
      !> Stiffness of the axial spring, N/mm, and a given axial force, N
      real(wp) :: axial_stiffness = 0.0_wp, axial_force = 0.0_wp
      !> Of each point: its face, place in the tenon and length of its cell, mm; area, mm^2, of both
      !> sides together
      integer, allocatable :: face(:)
      real(wp), allocatable :: x(:), y(:), cell(:), area(:)
      !> Outward normal and wall distance of each face
      real(wp) :: normal(2, n_faces) = 0.0_wp, wall(n_faces) = 0.0_wp
      !> The points' hosts, when they go through UINTER
      type(host_point), allocatable :: hosts(:)
   end type tenon_model

   !> Forces at a position.
   type :: tenon_forces
      !> Residuals: force along X, N, and moment about the load point, N mm
      real(wp) :: residual(2) = 0.0_wp
      !> Their derivatives by u and v
      real(wp) :: jacobian(2, 2) = 0.0_wp
      !> Vertical force of all points, N
      real(wp) :: vertical = 0.0_wp
      !> Axial force, N
      real(wp) :: axial = 0.0_wp
   end type tenon_forces

   procedure(uinter_interface) :: uinter

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
      real(wp) :: separation

      model%settings = settings
      call complete_tenon_settings(model%settings)
      model%faces = faces
      model%sides = sides
      model%wood = new_wood_bearing(model%settings)
      model%hard = settings%contact == 'hard'
      model%fixed = settings%axial_rule == 'fixed'
      model%arm = tenon_face_arm(settings)
      if (settings%axial_rule == 'spring') model%axial_stiffness = settings%axial_stiffness
      if (settings%axial_rule == 'force') model%axial_force = settings%axial_force
      call check_axial_force(settings, sides, error)
      if (allocated(error)) return
      if (.not. model%hard) then
         if (settings%gap == 'mean_plane') model%first_touch = faces%initial_separation
         call compile(model%faces, error)
         if (.not. allocated(error)) &
            call yield_overclosure(model%wood, faces, model%yields_at, error)
         if (allocated(error)) return
      end if
      if (settings%side_pressure > 0.0_wp .and. settings%through_uinter) then
         call separation_for_pressure(sides%normal, settings%side_pressure, separation, error)
         if (allocated(error)) return
         model%side_overclosure = sides%initial_separation - separation
      end if
      model%normal(:, upper) = [0.0_wp, 1.0_wp]
      model%normal(:, lower) = [0.0_wp, -1.0_wp]
      model%normal(:, upper_shoulder) = [-1.0_wp, 0.0_wp]
      model%normal(:, lower_shoulder) = [-1.0_wp, 0.0_wp]
      model%wall(upper) = 0.5_wp*settings%height + settings%clearance_above
      model%wall(lower) = 0.5_wp*settings%height + settings%clearance_below
      model%wall(upper_shoulder:lower_shoulder) = settings%shoulder_gap
      call place_points(model)
      if (settings%through_uinter) call new_hosts(model)
   end subroutine new_tenon_model

   !> While the joint is open, only the sides hold against a given force.
   pure subroutine check_axial_force(settings, sides, error)
      type(tenon_settings), intent(in) :: settings
      type(contact_properties), intent(in) :: sides
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: grip

      if (settings%axial_rule /= 'force') return
      grip = 2.0_wp*settings%length*settings%height &
         *sides%friction_coefficient*settings%side_pressure
      if (abs(settings%axial_force) > 0.0_wp .and. .not. abs(settings%axial_force) < grip) &
         call fatal_error(error, 'axial_force = '//to_text(settings%axial_force)// &
         ' N has no equilibrium while the joint is open: friction of the sides holds '// &
         to_text(grip, 4)//' N; raise side_pressure or take another axial_rule', &
         subject='axial_force')
   end subroutine check_axial_force

   !> Compile the law unless it is.
   subroutine compile(properties, error)
      type(contact_properties), intent(inout) :: properties
      type(error_type), allocatable, intent(out) :: error

      if (allocated(properties%compiled)) return
      allocate (properties%compiled)
      call new_compiled_law(properties%compiled, properties%normal, error)
   end subroutine compile

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
         more = ceiling(model%settings%extension/size_x*(1.0_wp - 1.0e-12_wp))
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

   subroutine new_hosts(model)
      type(tenon_model), intent(inout) :: model
      integer :: i

      allocate (model%hosts(size(model%x)))
      do i = 1, size(model%x)
         if (model%face(i) == side) then
            call new_host_point(model%hosts(i), uinter, model%sides, 3, keep_history=.false.)
         else
            call new_host_point(model%hosts(i), uinter, model%faces, 2, keep_history=.false.)
         end if
      end do
   end subroutine new_hosts

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

   !> All points and their forces at a position, from the accepted points `start`.
   subroutine evaluate_tenon(model, start, from, position, rotation, trial, forces, error)
      !> Joint
      type(tenon_model), intent(inout) :: model
      !> Points at the start of the increment
      type(contact_record), intent(in) :: start(:)
      !> u and v at its start, and at its end, mm; rotation at its end, rad
      real(wp), intent(in) :: from(2), position(2), rotation
      !> Points at its end
      type(contact_record), intent(inout) :: trial(:)
      !> Forces at its end
      type(tenon_forces), intent(out) :: forces
      !> Set when a point cannot be evaluated
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: cosine, sine, arm(2), lever(2), force(2), by_position(2, 2), by_weight(2)
      integer :: i

      cosine = cos(rotation)
      sine = sin(rotation)
      arm = model%arm*[cosine, sine]
      do i = 1, size(start)
         lever = [model%x(i)*cosine - model%y(i)*sine, model%x(i)*sine + model%y(i)*cosine]
         call evaluate_point(model, i, start(i), position + lever, trial(i), by_weight, error)
         if (allocated(error)) return
         if (trial(i)%weight <= 0.0_wp .or. trial(i)%state%pressure <= 0.0_wp) cycle
         call point_force(model, i, trial(i), by_weight, force, by_position)
         lever = lever - arm
         forces%residual = forces%residual &
            + [force(1), lever(1)*force(2) - lever(2)*force(1)]
         forces%jacobian(1, :) = forces%jacobian(1, :) + by_position(1, :)
         forces%jacobian(2, :) = forces%jacobian(2, :) + lever(1)*by_position(2, :) &
            - lever(2)*by_position(1, :)
         forces%vertical = forces%vertical + force(2)
      end do
      call add_axial(model, from, position, arm(2), forces)
   end subroutine evaluate_tenon

   !> The axial rule, and what holds an open joint.
   pure subroutine add_axial(model, from, position, lift, forces)
      type(tenon_model), intent(in) :: model
      real(wp), intent(in) :: from(2), position(2), lift
      type(tenon_forces), intent(inout) :: forces
      real(wp) :: reach

      reach = model%arm + 0.5_wp*model%settings%length
      if (model%fixed) then
         forces%axial = -forces%residual(1)
         forces%residual(2) = forces%residual(2) + lift*forces%axial
         forces%jacobian(2, :) = forces%jacobian(2, :) - lift*forces%jacobian(1, :)
         forces%residual(1) = 0.0_wp
         forces%jacobian(:, 1) = [-1.0_wp, 0.0_wp]
         forces%jacobian(1, 2) = 0.0_wp
      else
         forces%axial = model%axial_force - model%axial_stiffness*position(1)
         forces%residual = forces%residual + forces%axial*[1.0_wp, lift] &
            - [holding_stiffness*(position(1) - from(1)), 0.0_wp]
         forces%jacobian(:, 1) = forces%jacobian(:, 1) - model%axial_stiffness*[1.0_wp, lift] &
            - [holding_stiffness, 0.0_wp]
      end if
      ! a small force against v at the middle of the mortise
      forces%residual(2) = forces%residual(2) &
         + reach*holding_stiffness*(position(2) - from(2))
      forces%jacobian(2, 2) = forces%jacobian(2, 2) + reach*holding_stiffness
   end subroutine add_axial

   !> One point at its place: weight, closure, slip and the law.
   subroutine evaluate_point(model, i, start, place, trial, by_weight, error)
      type(tenon_model), intent(inout) :: model
      integer, intent(in) :: i
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: place(2)
      type(contact_record), intent(inout) :: trial
      real(wp), intent(out) :: by_weight(2)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: closure, slip(2)
      integer :: face

      face = model%face(i)
      trial%place = place
      slip = place - start%place
      trial%slip = start%slip + slip
      by_weight = 0.0_wp
      trial%weight = 1.0_wp
      if (face <= other_side) &
         call find_weight(model%settings%length, place(1), model%cell(i), trial%weight, &
         by_weight(1))
      if (trial%weight <= 0.0_wp) then
         if (allocated(model%hosts)) then
            call leave_through_uinter(start, trial, model%hosts(i), error)
         else
            call leave_surface(start, trial)
         end if
      else if (face == side) then
         if (allocated(model%hosts)) then
            call rub_through_uinter(start, model%side_overclosure, slip, trial, model%hosts(i), &
               error)
         else
            call rub(model%sides, start, 0.0_wp, model%settings%side_pressure, 0.0_wp, slip, trial)
         end if
      else
         closure = model%first_touch &
            - (model%wall(face) - dot_product(model%normal(:, face), place))
         if (face <= lower) then
            slip(2) = 0.0_wp
         else
            slip = [slip(2), 0.0_wp]
         end if
         if (model%hard) then
            call press_hard(model%wood, model%faces, start, closure, slip, trial)
         else if (allocated(model%hosts)) then
            call press_through_uinter(model%wood, model%faces, model%yields_at, start, closure, &
               slip, trial, model%hosts(i), error)
         else
            call press_rough(model%wood, model%faces, model%yields_at, start, closure, slip, &
               trial, error)
         end if
      end if
   end subroutine evaluate_point

   !> Share of a cell that is in the mortise, and its derivative by X.
   pure subroutine find_weight(length, x, cell, weight, by_x)
      real(wp), intent(in) :: length, x, cell
      real(wp), intent(out) :: weight, by_x

      weight = 1.0_wp
      by_x = 0.0_wp
      if (x + 0.5_wp*cell > 0.0_wp) then
         weight = 0.5_wp - x/cell
         by_x = -1.0_wp/cell
      else if (x - 0.5_wp*cell < -length) then
         weight = 0.5_wp + (x + length)/cell
         by_x = 1.0_wp/cell
      end if
      if (weight <= 0.0_wp) then
         weight = 0.0_wp
         by_x = 0.0_wp
      end if
   end subroutine find_weight

   !> Force of a point on the tenon, N, and its derivatives by u and v.
   pure subroutine point_force(model, i, trial, by_weight, force, by_position)
      type(tenon_model), intent(in) :: model
      integer, intent(in) :: i
      type(contact_record), intent(in) :: trial
      real(wp), intent(in) :: by_weight(2)
      real(wp), intent(out) :: force(2), by_position(2, 2)
      real(wp) :: stress(2), n(2), t(2)
      integer :: face

      face = model%face(i)
      if (face == side) then
         stress = -trial%shear
         by_position = -trial%shear_by_slip
      else
         n = model%normal(:, face)
         t = merge([1.0_wp, 0.0_wp], [0.0_wp, 1.0_wp], face <= lower)
         stress = -trial%state%pressure*n - trial%shear(1)*t
         by_position(:, 1) = -(trial%stiffness*n + trial%shear_by_closure(1)*t)*n(1) &
            - trial%shear_by_slip(1, 1)*t*t(1)
         by_position(:, 2) = -(trial%stiffness*n + trial%shear_by_closure(1)*t)*n(2) &
            - trial%shear_by_slip(1, 1)*t*t(2)
      end if
      force = model%area(i)*trial%weight*stress
      by_position = model%area(i)*(trial%weight*by_position &
         + spread(stress, 2, 2)*spread(by_weight, 1, 2))
   end subroutine point_force

end module asperity_replay_tenon_geometry
