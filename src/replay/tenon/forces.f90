!> Forces of all contact points of the tenon joint at a position, and what holds the tenon.
module asperity_replay_tenon_forces
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_replay_tenon_contact_record, only: contact_record
   use asperity_replay_tenon_geometry, only: lower, other_side, side, tenon_model
   implicit none
   private
   public :: tenon_forces, tenon_increment, evaluate_tenon

   !> What keeps an open joint in place, N/mm: far below any contact
   real(wp), parameter, public :: holding_stiffness = 1.0e-4_wp

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

   !> The joint within an increment, from accepted points to a position.
   type :: tenon_increment
      !> Joint
      type(tenon_model) :: model
      !> Points at the start of the increment, and as they were evaluated last
      type(contact_record), allocatable :: start(:), trial(:)
      !> u and v at the start, and at the end, mm; rotation at the end, rad
      real(wp) :: from(2) = 0.0_wp, position(2) = 0.0_wp, rotation = 0.0_wp
      !> Whether it comes to rest, from nowhere: nothing holds it at `from` then
      logical :: rests = .false.
      !> Forces as they were evaluated last
      type(tenon_forces) :: forces
      !> Evaluations so far
      integer :: iterations = 0
      !> The point that could not be evaluated, zero for none
      integer :: refused = 0
   end type tenon_increment

contains

   !> All points and their forces at the position.
   subroutine evaluate_tenon(joint, error)
      !> Joint
      type(tenon_increment), intent(inout) :: joint
      !> Set when a point cannot be evaluated
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: cosine, sine, arm(2), lever(2), force(2), by_position(2, 2), by_weight(2)
      integer :: i

      joint%iterations = joint%iterations + 1
      if (joint%rests) joint%from = joint%position
      cosine = cos(joint%rotation)
      sine = sin(joint%rotation)
      associate (model => joint%model, forces => joint%forces)
         forces = tenon_forces()
         arm = model%arm*[cosine, sine]
         do i = 1, size(joint%start)
            lever = [model%x(i)*cosine - model%y(i)*sine, model%x(i)*sine + model%y(i)*cosine]
            associate (trial => joint%trial(i))
               call evaluate_point(model, joint%start(i), joint%position + lever, trial, &
                  by_weight, error)
               if (allocated(error)) then
                  joint%refused = i
                  return
               end if
               if (trial%weight <= 0.0_wp .or. trial%state%pressure <= 0.0_wp) cycle
               call point_force(model, i, trial, by_weight, force, by_position)
            end associate
            lever = lever - arm
            forces%residual = forces%residual &
               + [force(1), lever(1)*force(2) - lever(2)*force(1)]
            forces%jacobian(1, :) = forces%jacobian(1, :) + by_position(1, :)
            forces%jacobian(2, :) = forces%jacobian(2, :) + lever(1)*by_position(2, :) &
               - lever(2)*by_position(1, :)
            forces%vertical = forces%vertical + force(2)
         end do
         call add_axial(model, joint%from, joint%position, arm(2), forces)
      end associate
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
   subroutine evaluate_point(model, start, place, trial, by_weight, error)
      type(tenon_model), intent(inout) :: model
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: place(2)
      type(contact_record), intent(inout) :: trial
      real(wp), intent(out) :: by_weight(2)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: closure, slip(2)
      integer :: face

      face = model%face(start%point)
      trial%place = place
      slip = place - start%place
      trial%slip = start%slip + slip
      by_weight = 0.0_wp
      trial%weight = 1.0_wp
      if (face <= other_side) call find_weight(model%settings%length, place(1), &
         model%cell(start%point), trial%weight, by_weight(1))
      if (trial%weight <= 0.0_wp) then
         call model%law%separate(start, trial, error)
      else if (face == side) then
         call model%law%slide(start, slip, trial, error)
      else
         closure = model%first_touch &
            - (model%wall(face) - dot_product(model%normal(:, face), place))
         if (face <= lower) then
            slip(2) = 0.0_wp
         else
            slip = [slip(2), 0.0_wp]
         end if
         call model%law%close(start, closure, slip, trial, error)
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

end module asperity_replay_tenon_forces
