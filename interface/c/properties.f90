!> C interface: the struct of properties. See asperity.h for what each function does.
module asperity_c_properties
   use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int, c_null_char, c_ptr, &
      c_size_t, c_sizeof
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_c_checks, only: answer, check_pointer
   use asperity_c_types, only: code_length, error_struct, properties_struct
   use asperity_paper_pairs, only: find_pair, pair_preset
   implicit none
   private
   public :: asperity_properties_init, asperity_properties_from_pair, longest_name, read_text, &
      view_properties

   !> Characters of a name that are looked at: more than any has
   integer, parameter :: longest_name = 64

contains

   !> Defaults; what has none is NaN, so that the law refuses a property that was forgotten.
   integer(c_int) function asperity_properties_init(properties, size, error) result(code) &
         bind(c, name='asperity_properties_init')
      !> Struct to fill
      type(c_ptr), value :: properties
      !> Its size for the caller
      integer(c_size_t), value :: size
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(properties_struct), pointer :: p
      type(error_type), allocatable :: problem

      call view_properties(problem, properties, p, size)
      if (.not. allocated(problem)) then
         p = properties_struct()
         p%size = size
      end if
      code = answer(problem, error)
   end function asperity_properties_init

   !> The properties of a pair of the paper, and the defaults.
   integer(c_int) function asperity_properties_from_pair(properties, size, pair, error) &
         result(code) bind(c, name='asperity_properties_from_pair')
      !> Struct to fill
      type(c_ptr), value :: properties
      !> Its size for the caller
      integer(c_size_t), value :: size
      !> Name, which ends with NUL
      type(c_ptr), value :: pair
      !> Filled when present
      type(error_struct), intent(inout), optional :: error
      type(properties_struct), pointer :: p
      type(error_type), allocatable :: problem
      type(pair_preset) :: found
      character(len=longest_name) :: name

      call view_properties(problem, properties, p, size)
      call read_text(problem, 'pair', pair, name)
      if (.not. allocated(problem)) call find_pair(trim(name), found, problem)
      if (.not. allocated(problem)) then
         p = properties_struct(size, found%eta, found%modulus, found%radius, found%hardness, &
            found%yield_factor, found%sigma, found%friction_coefficient, found%critical_slip)
      end if
      code = answer(problem, error)
   end function asperity_properties_from_pair

   !> A text of the caller; one without an end is cut.
   subroutine read_text(problem, name, address, text)
      !> Set when there is none; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> What it is called
      character(len=*), intent(in) :: name
      !> Where the caller has it
      type(c_ptr), intent(in) :: address
      !> The text, blank after a problem
      character(len=longest_name), intent(out) :: text
      character(kind=c_char), pointer, contiguous :: letters(:)
      integer :: i

      text = ''
      call check_pointer(problem, name, address, alignment=1)
      if (allocated(problem)) return
      call c_f_pointer(address, letters, [len(text)])
      do i = 1, len(text)
         if (letters(i) == c_null_char) exit
         text(i:i) = letters(i)
      end do
   end subroutine read_text

   !> The caller's struct, after a check that it is the one of this library.
   subroutine view_properties(problem, address, p, size)
      !> Set when it is refused; a problem found before stays
      type(error_type), allocatable, intent(inout) :: problem
      !> Where the caller has it
      type(c_ptr), intent(in) :: address
      !> The struct
      type(properties_struct), pointer, intent(out) :: p
      !> Its size for the caller, who has filled in the struct when absent
      integer(c_size_t), intent(in), optional :: size
      integer(c_size_t) :: given

      nullify (p)
      call check_pointer(problem, 'properties', address)
      if (allocated(problem)) return
      call c_f_pointer(address, p)
      if (present(size)) then
         given = size
      else
         given = p%size
      end if
      if (given /= c_sizeof(p)) call fatal_error(problem, 'the size of asperity_properties is '// &
         'not '//to_text(int(c_sizeof(p)))//' bytes: fill the struct by '// &
         'asperity_properties_init(&p, sizeof p, &error) first, and compile with the header of '// &
         'this library', code_length)
   end subroutine view_properties

end module asperity_c_properties
