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
   public :: wood_of, random_places, random_rotation, random_stretch, random_brick

   !> Edge of an element, mm
   real(wp), parameter, public :: edge = 30.0_wp
   !> Strain measures of an element, whether logarithmic, and their names
   logical, parameter, public :: measures(2) = [.false., .true.]
   character(len=11), parameter, public :: measure_names(2) = ['engineering', 'logarithmic']
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

   !> A symmetric matrix with eigenvalues between two numbers, and its logarithm.
   function random_stretch(stream, least, most, logarithm) result(stretch)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: least, most
      real(wp), intent(out), optional :: logarithm(3, 3)
      real(wp) :: stretch(3, 3), axes(3, 3), values(3)
      integer :: i

      axes = random_rotation(stream)
      do i = 1, 3
         values(i) = stream%log_uniform(least, most)
      end do
      stretch = matmul(axes, spread(values, 2, 3)*transpose(axes))
      if (present(logarithm)) &
         logarithm = matmul(axes, spread(log(values), 2, 3)*transpose(axes))
   end function random_stretch

   !> A distorted element of a material and strain measure.
   subroutine random_brick(shape, stream, material, is_logarithmic)
      type(brick), intent(out) :: shape
      type(random_stream), intent(inout) :: stream
      type(solid_material), intent(in) :: material
      logical, intent(in) :: is_logarithmic
      type(error_type), allocatable :: error
      type(box) :: one

      call new_box(one, [1, 1, 1], [edge, 1.5_wp*edge, 0.7_wp*edge], material)
      call new_brick(shape, one%nodes(:, one%elements(:, 1)) + random_places(stream, 0.1_wp*edge), &
         material%stiffness, error)
      if (allocated(error)) error stop 'brick_states: an element is inverted'
      shape%is_logarithmic = is_logarithmic
   end subroutine random_brick

end module brick_states
