!> Faces that are case files, such as asperity surface writes: their summits are read of them.
module asperity_program_commands_faces_read_faces
   use asperity_base_error, only: error_type, fatal_error
   use asperity_paper_pairs, only: surfaces
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_input_case_file, only: read_case
   use asperity_program_input_key, only: given_nowhere, key_type
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: read_faces, read_face

   !> What is read, in the order of a face
   character(len=*), parameter :: names(3) = [character(len=6) :: 'sigma', 'radius', 'eta']

contains

   !> Read all that are given.
   subroutine read_faces(keys, error)
      !> Keys of a command; those of faces take the numbers of their files
      type(key_list), intent(inout) :: keys
      !> Set when a file cannot be read or has no summits
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, keys%n
         call read_face(keys%rows(i), error)
         if (allocated(error)) return
      end do
   end subroutine read_faces

   !> Read a face that is given by a path, which has a dot or a slash as no name of Table 2 has.
   subroutine read_face(key, error)
      !> Any key
      type(key_type), intent(inout) :: key
      !> Set when its file cannot be read or has no summits
      type(error_type), allocatable, intent(out) :: error
      type(key_list) :: own, known
      type(faces_type) :: faces
      logical, parameter :: has_friction = .true.
      integer :: i, place

      if (key%reads /= 'face' .or. key%given == given_nowhere) return
      if (any(surfaces%name == key%text) .or. scan(key%text, './') == 0) return
      call faces%declare(own, has_friction)
      call faces%declare_separation(own)
      call faces%declare_unloading(own)
      call faces%heights%declare(own)
      call faces%declare_rules(own)
      call faces%declare_accept(own)
      known = own
      own%case_path = key%text
      call read_case(own, known, error)
      if (.not. allocated(error)) allocate (key%values(size(names)))
      do i = 1, size(names)
         if (allocated(error)) exit
         place = own%find(trim(names(i)))
         if (own%given(place)) then
            key%values(i) = own%rows(place)%values(1)
         else
            call fatal_error(error, key%text//': gives no '//trim(names(i))// &
               ': a face needs sigma, radius and eta, such as asperity surface --case writes')
         end if
      end do
      if (allocated(error)) error%message = key%source//': '//error%message
   end subroutine read_face

end module asperity_program_commands_faces_read_faces
