!> One rough face: its summits, and the wood below them.
module asperity_faces_face
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_paper_pairs, only: surface_preset
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_constants
   implicit none
   private
   public :: face, face_of_wood, check_face

   !> Largest |Poisson's ratio|: wood has up to some 0.8, and Eq. 4 needs less than 1
   real(wp), parameter :: largest_poisson = 0.99_wp

   !> A face in N-mm-MPa.
   type :: face
      !> Standard deviation of summit heights, mm
      real(wp) :: sigma = 0.0_wp
      !> Summit radius, mm
      real(wp) :: radius = 0.0_wp
      !> Asperity density, 1/mm^2
      real(wp) :: eta = 0.0_wp
      !> Young's modulus along the normal of the face, MPa
      real(wp) :: young_modulus = 0.0_wp
      !> Poisson's ratio of strain in the face for pressure on it
      real(wp) :: poisson_ratio = 0.0_wp
      !> Hardness, MPa
      real(wp) :: hardness = 0.0_wp
   end type face

contains

   !> A surface of the paper on a section of a wood. `error` is set when the section has no
   !> constants.
   pure subroutine face_of_wood(one, surface, section, error, wood)
      !> The face
      type(face), intent(out) :: one
      !> Such as `find_surface` finds
      type(surface_preset), intent(in) :: surface
      !> `section_transverse`, `section_tangential` or `section_radial`
      integer, intent(in) :: section
      !> Set when there is no such face
      type(error_type), allocatable, intent(out) :: error
      !> The wood; the paper's larch when absent
      type(wood_properties), intent(in), optional :: wood
      type(wood_properties) :: larch

      one%sigma = surface%sigma
      one%radius = surface%radius
      one%eta = surface%eta
      if (present(wood)) then
         call section_constants(wood, section, one%young_modulus, one%poisson_ratio, &
            one%hardness, error)
      else
         call section_constants(larch, section, one%young_modulus, one%poisson_ratio, &
            one%hardness, error)
      end if
   end subroutine face_of_wood

   !> `error` is set, unless it is, when a number of a face cannot be; it names it with the number
   !> of the face, such as `sigma_1`.
   pure subroutine check_face(one, number, is_rough, error)
      !> The face
      type(face), intent(in) :: one
      !> Its number, `1` or `2`
      character(len=1), intent(in) :: number
      !> Whether its summits count
      logical, intent(in) :: is_rough
      !> Set when it is refused
      type(error_type), allocatable, intent(inout) :: error

      if (is_rough) then
         if (.not. allocated(error)) call check_positive(error, 'sigma_'//number, one%sigma, 'mm')
         if (.not. allocated(error)) call check_positive(error, 'radius_'//number, one%radius, 'mm')
         if (.not. allocated(error)) call check_positive(error, 'eta_'//number, one%eta, '1/mm^2')
      end if
      if (.not. allocated(error)) call check_positive(error, 'young_modulus_'//number, &
         one%young_modulus, 'MPa')
      if (.not. allocated(error)) call check_range(error, 'poisson_ratio_'//number, &
         one%poisson_ratio, -largest_poisson, largest_poisson, '')
      if (.not. allocated(error)) call check_positive(error, 'hardness_'//number, one%hardness, &
         'MPa')
   end subroutine check_face

end module asperity_faces_face
