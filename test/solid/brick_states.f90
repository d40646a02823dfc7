!> Random bricks and how they are turned, for tests.
module brick_states
   use asperity, only: error_type, wp
   use asperity_base_constants, only: pi
   use asperity_solid_element_brick, only: brick, new_brick
   use asperity_solid_material_material, only: new_solid_material, solid_material
   use asperity_wood_properties, only: wood_properties
   use brick_model, only: box, new_box, rotation_about
   use random_inputs, only: random_stream
   implicit none
   private
   public :: wood_of, random_places, random_rotation, random_brick

   !> Edge of an element, mm
   real(wp), parameter, public :: edge = 30.0_wp
   character(len=8), parameter, public :: criteria(4) = &
      ['none    ', 'mises   ', 'hill    ', 'crushing']

contains

   !> A material of wood, its grain in z.
   function wood_of(criterion) result(material)
      character(len=*), intent(in) :: criterion
      type(solid_material) :: material
      type(wood_properties) :: wood
      type(error_type), allocatable :: error

      wood%criterion = criterion
      call new_solid_material(material, wood, 3, 1, .false., error)
      if (allocated(error)) error stop 'brick_states: no material'
   end function wood_of

   !> Numbers between -size and size.
   function random_places(stream, size) result(places)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: size
      real(wp) :: places(3, 8)
      integer :: a, i

      do a = 1, 8
         do i = 1, 3
            places(i, a) = stream%uniform(-size, size)
         end do
      end do
   end function random_places

   function random_rotation(stream) result(rotation)
      type(random_stream), intent(inout) :: stream
      real(wp) :: rotation(3, 3), axis(3)
      integer :: i

      do i = 1, 3
         axis(i) = stream%uniform(-1.0_wp, 1.0_wp)
      end do
      rotation = rotation_about(axis, stream%uniform(-pi, pi))
   end function random_rotation

   !> A distorted element of a material.
   subroutine random_brick(shape, stream, material)
      type(brick), intent(out) :: shape
      type(random_stream), intent(inout) :: stream
      type(solid_material), intent(in) :: material
      type(error_type), allocatable :: error
      type(box) :: one

      call new_box(one, [1, 1, 1], [edge, 1.5_wp*edge, 0.7_wp*edge], material)
      call new_brick(shape, one%nodes(:, one%elements(:, 1)) + random_places(stream, 0.1_wp*edge), &
         material%stiffness, error)
      if (allocated(error)) error stop 'brick_states: an element is inverted'
   end subroutine random_brick

end module brick_states
