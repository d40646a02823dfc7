!> C interface: version and texts. See asperity.h, which tells C callers everything; tests of the
!> interface are in C.
module asperity_c_texts
   use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_c_checks, only: answer, check_pointer, copy_text
   use asperity_c_types, only: code_input, code_length, error_struct
   use asperity_law_validity, only: all_flags, valid, validity_remark
   implicit none
   private
   public :: asperity_library_version, asperity_validity_remark

contains

   !> Version of the library, such as 0.1.0.
   integer(c_int) function asperity_library_version(buffer, length, error) result(code) &
         bind(c, name='asperity_library_version')
      !> Room for the text
      type(c_ptr), value :: buffer
      !> Its length, with the NUL
      integer(c_int), value :: length
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(error_type), allocatable :: problem

      call give_text(problem, version, buffer, length)
      code = answer(problem, error)
   end function asperity_library_version

   !> What the validity flags of a result mean.
   integer(c_int) function asperity_validity_remark(validity, buffer, length, error) &
         result(code) bind(c, name='asperity_validity_remark')
      !> Sum of flags
      integer(c_int), value :: validity
      !> Room for the text
      type(c_ptr), value :: buffer
      !> Its length, with the NUL
      integer(c_int), value :: length
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(error_type), allocatable :: problem

      if (validity < valid .or. validity > all_flags) then
         call fatal_error(problem, 'validity = '//to_text(validity)//' is not allowed: it must '// &
            'be a sum of flags, 0 to '//to_text(all_flags), code_input)
      else
         call give_text(problem, validity_remark(validity), buffer, length)
      end if
      code = answer(problem, error)
   end function asperity_validity_remark

   !> Write a text to the caller's buffer; what does not fit is cut and reported.
   subroutine give_text(problem, text, address, length)
      type(error_type), allocatable, intent(inout) :: problem
      character(len=*), intent(in) :: text
      type(c_ptr), intent(in) :: address
      integer(c_int), intent(in) :: length
      character(kind=c_char), pointer, contiguous :: buffer(:)

      call check_pointer(problem, 'buffer', address, alignment=1)
      if (allocated(problem)) return
      if (length > 0) then
         call c_f_pointer(address, buffer, [length])
         call copy_text(text, buffer)
      end if
      if (length <= len(text)) call fatal_error(problem, 'length = '//to_text(length)//' is '// &
         'too short for the text: give '//to_text(len(text) + 1)//' or more', code_length)
   end subroutine give_text

end module asperity_c_texts
