!> What the C interface checks of the arrays of a call.
module asperity_c_arrays
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, &
      c_intptr_t, c_null_ptr, c_ptr
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_c_checks, only: check_pointer, number_of, word
   use asperity_c_types, only: code_input
   implicit none
   private
   public :: array_argument, check_arrays, check_values

   !> Alignment of arrays of int
   integer, parameter :: half_word = 4

   !> One array that a caller passed.
   type :: array_argument
      !> Its name in the header
      character(len=19) :: name = ''
      !> Where it begins; may be NULL
      type(c_ptr) :: address = c_null_ptr
      !> Bytes a point
      integer :: bytes = 8
      !> NULL is refused
      logical :: required = .false.
      !> The function writes to it
      logical :: written = .false.
   end type array_argument

contains

   !> Refuse arrays that are missing, misaligned, or written to while another argument shares
   !> their memory, which Fortran does not allow.
   subroutine check_arrays(problem, n, arrays)
      !> Set when one is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Number of points
      integer(c_int), intent(in) :: n
      !> All arrays of the call
      type(array_argument), intent(in) :: arrays(:)
      integer(c_intptr_t) :: first(size(arrays)), past(size(arrays))
      integer :: i, k

      if (n == 0) return
      do i = 1, size(arrays)
         associate (a => arrays(i))
            first(i) = number_of(a%address)
            past(i) = first(i)
            if (.not. (a%required .or. c_associated(a%address))) cycle
            past(i) = first(i) + int(n, c_intptr_t)*a%bytes
            call check_pointer(problem, a%name, a%address, &
               merge(half_word, word, a%bytes == half_word))
            if (allocated(problem)) return
            do k = 1, i - 1
               if (.not. (a%written .or. arrays(k)%written)) cycle
               if (first(i) < past(k) .and. first(k) < past(i)) then
                  call fatal_error(problem, trim(arrays(k)%name)//' and '//trim(a%name)// &
                     ' overlap: arrays that are written to share no memory', code_input)
                  return
               end if
            end do
         end associate
      end do
   end subroutine check_arrays

   !> Refuse numbers that are not finite or are too large, before anything is computed from them.
   subroutine check_values(problem, name, n, rows, address, largest)
      !> Set when one is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Name of the array
      character(len=*), intent(in) :: name
      !> Number of points, and of rows [n]
      integer(c_int), intent(in) :: n
      integer, intent(in) :: rows
      !> The array, checked; NULL passes
      type(c_ptr), intent(in) :: address
      !> Largest size allowed
      real(wp), intent(in) :: largest
      real(c_double), pointer, contiguous :: values(:, :)
      integer :: i, row

      if (allocated(problem) .or. n == 0 .or. .not. c_associated(address)) return
      call c_f_pointer(address, values, [int(n), rows])
      do row = 1, rows
         do i = 1, n
            if (.not. ieee_is_finite(values(i, row))) exit
            if (abs(values(i, row)) > largest) exit
         end do
         if (i > n) cycle
         call fatal_error(problem, name//' of point '//to_text(i - 1)//' = '// &
            to_text(values(i, row))//' is not allowed: it must be a number up to '// &
            to_text(largest)//' in size', code_input)
         return
      end do
   end subroutine check_values

end module asperity_c_arrays
