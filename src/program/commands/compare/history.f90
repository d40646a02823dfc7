!> Named quantities over time, as `compare` holds two of them against each other.
module asperity_program_commands_compare_history
   use asperity_base_kinds, only: wp
   use asperity_program_input_key, only: name_length
   implicit none
   private
   public :: history_type, row_near

   !> Names of the reaction forces of a face: of the totals that solvers print
   character(len=*), parameter, public :: reaction_names(3) = [character(len=10) :: 'reaction_1', &
      'reaction_2', 'reaction_3']

   !> Quantities over time. A value that is not there is `none`.
   type :: history_type
      !> Path of the file
      character(len=:), allocatable :: path
      !> Names of the columns, and their units, blank where the file says none
      character(len=name_length), allocatable :: names(:)
      character(len=name_length), allocatable :: units(:)
      !> Total time of each row, s
      real(wp), allocatable :: time(:)
      !> Values, shape (rows, columns)
      real(wp), allocatable :: values(:, :)
   end type history_type

contains

   !> The last row at a time, zero for none: solvers print the end of a step twice.
   pure integer function row_near(history, time, tolerance) result(row)
      !> The history
      type(history_type), intent(in) :: history
      !> The time, and how near to it a row may be, s
      real(wp), intent(in) :: time, tolerance

      row = findloc(abs(history%time - time) <= tolerance, .true., 1, back=.true.)
   end function row_near

end module asperity_program_commands_compare_history
