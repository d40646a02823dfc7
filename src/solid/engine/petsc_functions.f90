!> Kinds of functions that PETSc's C interface has. Every one returns zero on success.
module asperity_solid_engine_petsc_functions
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int, c_ptr, c_ptrdiff_t
   implicit none
   private
   public :: cntl_function, destroys, finds, gives_number, handler_function, icntl_function, &
      infog_function, matrix_function, of_one, of_three, of_two, option_function, place_function, &
      places_function, plain, sizes_function, space_function, test_function, tolerances_function, &
      values_function, vectors_function, version_function, with_name, with_number

   abstract interface
      !> What takes nothing
      integer(c_int) function plain() bind(c)
         import :: c_int
      end function plain
      !> ... one object
      integer(c_int) function of_one(object) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: object
      end function of_one
      !> ... two objects
      integer(c_int) function of_two(first, second) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: first, second
      end function of_two
      !> ... three objects
      integer(c_int) function of_three(first, second, third) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: first, second, third
      end function of_three
      !> ... and destroys an object
      integer(c_int) function destroys(object) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), intent(inout) :: object
      end function destroys
      !> ... and makes or finds another object
      integer(c_int) function finds(object, found) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: object
         type(c_ptr), intent(out) :: found
      end function finds
      !> ... an object and a number
      integer(c_int) function with_number(object, number) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: object
         integer(c_int), value :: number
      end function with_number
      !> ... an object and a name
      integer(c_int) function with_name(object, name) bind(c)
         import :: c_char, c_int, c_ptr
         type(c_ptr), value :: object
         character(kind=c_char), intent(in) :: name(*)
      end function with_name
      !> ... and gives a number
      integer(c_int) function gives_number(object, number) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: object
         integer(c_int), intent(out) :: number
      end function gives_number
      !> The version of the release
      integer(c_int) function version_function(major, minor, subminor, release) bind(c)
         import :: c_int
         integer(c_int), intent(out) :: major, minor, subminor, release
      end function version_function
      !> Who is told of errors
      integer(c_int) function handler_function(handler, context) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: handler, context
      end function handler_function
      !> An empty matrix of a team
      integer(c_int) function matrix_function(communicator, matrix) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: communicator
         type(c_ptr), intent(out) :: matrix
      end function matrix_function
      !> Its sizes: rows and columns of this rank and of all
      integer(c_int) function sizes_function(matrix, own_rows, own_columns, rows, columns) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: matrix
         integer(c_int), value :: own_rows, own_columns, rows, columns
      end function sizes_function
      !> Where this rank has entries, in any order, on any rank's rows; the lists may be changed
      integer(c_int) function places_function(matrix, n, rows, columns) bind(c)
         import :: c_int, c_ptr, c_ptrdiff_t
         type(c_ptr), value :: matrix
         integer(c_ptrdiff_t), value :: n
         integer(c_int), intent(inout) :: rows(*), columns(*)
      end function places_function
      !> The values of these entries
      integer(c_int) function values_function(matrix, values, mode) bind(c)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: matrix
         real(c_double), intent(in) :: values(*)
         integer(c_int), value :: mode
      end function values_function
      !> Vectors that go with a matrix: what it is multiplied by, and the product
      integer(c_int) function vectors_function(matrix, right, left) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: matrix
         type(c_ptr), intent(out) :: right, left
      end function vectors_function
      !> Let a vector be in an array
      integer(c_int) function place_function(vector, values) bind(c)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: vector
         real(c_double), intent(in) :: values(*)
      end function place_function
      !> The space of some vectors, and of constants if so
      integer(c_int) function space_function(communicator, has_constants, n, vectors, space) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: communicator
         integer(c_int), value :: has_constants, n
         type(c_ptr), intent(in) :: vectors(*)
         type(c_ptr), intent(out) :: space
      end function space_function
      !> An option in a data base: its name and value
      integer(c_int) function option_function(options, name, value) bind(c)
         import :: c_char, c_int, c_ptr
         type(c_ptr), value :: options
         character(kind=c_char), intent(in) :: name(*), value(*)
      end function option_function
      !> Controls of MUMPS that are whole
      integer(c_int) function icntl_function(factors, place, value) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: factors
         integer(c_int), value :: place, value
      end function icntl_function
      !> ... that are real
      integer(c_int) function cntl_function(factors, place, value) bind(c)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: factors
         integer(c_int), value :: place
         real(c_double), value :: value
      end function cntl_function
      !> What MUMPS says
      integer(c_int) function infog_function(factors, place, value) bind(c)
         import :: c_int, c_ptr
         type(c_ptr), value :: factors
         integer(c_int), value :: place
         integer(c_int), intent(out) :: value
      end function infog_function
      !> Tolerances of a Krylov solver
      integer(c_int) function tolerances_function(solver, relative, absolute, divergence, most) &
            bind(c)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: solver
         real(c_double), value :: relative, absolute, divergence
         integer(c_int), value :: most
      end function tolerances_function
      !> Who says that it has converged
      integer(c_int) function test_function(solver, test, context, destroy) bind(c)
         import :: c_funptr, c_int, c_ptr
         type(c_ptr), value :: solver, context
         type(c_funptr), value :: test, destroy
      end function test_function
   end interface

end module asperity_solid_engine_petsc_functions
