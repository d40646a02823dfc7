!> C interface: two faces as one pair. See asperity.h for what each function does.
module asperity_c_faces
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_ptr, c_size_t
   use asperity_base_error, only: error_type
   use asperity_c_checks, only: answer, check_pointer
   use asperity_c_properties, only: longest_name, read_text, view_properties
   use asperity_c_types, only: error_struct, properties_struct
   use asperity_faces_face, only: face, face_of_wood
   use asperity_faces_two_faces, only: pair_from_faces
   use asperity_paper_pairs, only: find_surface, pair_preset, surface_preset
   implicit none
   private
   public :: asperity_face_from_paper, asperity_properties_from_faces

   !> struct asperity_face: `face`
   type, bind(c) :: face_struct
      !> As in `face`
      real(c_double) :: sigma, radius, eta, young_modulus, poisson_ratio, hardness
   end type face_struct

contains

   !> A surface of the paper on a section of its wood.
   integer(c_int) function asperity_face_from_paper(one, surface, section, error) result(code) &
         bind(c, name='asperity_face_from_paper')
      !> Struct to fill
      type(c_ptr), value :: one
      !> Name, which ends with NUL
      type(c_ptr), value :: surface
      !> One of the sections
      integer(c_int), value :: section
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(face_struct), pointer :: p
      type(error_type), allocatable :: problem
      type(surface_preset) :: found
      type(face) :: made
      character(len=longest_name) :: name

      call view_face(problem, 'face', one, p)
      call read_text(problem, 'surface', surface, name)
      if (.not. allocated(problem)) call find_surface(trim(name), found, problem)
      if (.not. allocated(problem)) call face_of_wood(made, found, int(section), problem)
      if (.not. allocated(problem)) p = face_struct(made%sigma, made%radius, made%eta, &
         made%young_modulus, made%poisson_ratio, made%hardness)
      code = answer(problem, error)
   end function asperity_face_from_paper

   !> The properties of the pair that two faces make, and the defaults.
   integer(c_int) function asperity_properties_from_faces(properties, size, face_1, face_2, &
         hardness_rule, roughness_rule, error) result(code) &
         bind(c, name='asperity_properties_from_faces')
      !> Struct to fill
      type(c_ptr), value :: properties
      !> Its size for the caller
      integer(c_size_t), value :: size
      !> The faces
      type(c_ptr), value :: face_1, face_2
      !> One of the rules each
      integer(c_int), value :: hardness_rule, roughness_rule
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(properties_struct), pointer :: p
      type(face_struct), pointer :: first, second
      type(error_type), allocatable :: problem
      type(pair_preset) :: made

      call view_properties(problem, properties, p, size)
      call view_face(problem, 'face_1', face_1, first)
      call view_face(problem, 'face_2', face_2, second)
      if (.not. allocated(problem)) call pair_from_faces(as_face(first), as_face(second), made, &
         problem, int(hardness_rule), int(roughness_rule))
      if (.not. allocated(problem)) then
         p = properties_struct(size, made%eta, made%modulus, made%radius, made%hardness, &
            made%yield_factor, made%sigma, made%friction_coefficient, made%critical_slip)
      end if
      code = answer(problem, error)
   end function asperity_properties_from_faces

   !> The caller's struct of a face.
   subroutine view_face(problem, name, address, p)
      type(error_type), allocatable, intent(inout) :: problem
      character(len=*), intent(in) :: name
      type(c_ptr), intent(in) :: address
      type(face_struct), pointer, intent(out) :: p

      nullify (p)
      call check_pointer(problem, name, address)
      if (.not. allocated(problem)) call c_f_pointer(address, p)
   end subroutine view_face

   !> The same for the library.
   pure type(face) function as_face(p)
      type(face_struct), intent(in) :: p

      as_face = face(p%sigma, p%radius, p%eta, p%young_modulus, p%poisson_ratio, p%hardness)
   end function as_face

end module asperity_c_faces
