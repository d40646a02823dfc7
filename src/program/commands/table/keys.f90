!> Keys of the law as a table that the command and decks have in common.
module asperity_program_commands_table_keys
   use asperity_deck_options, only: deck_choice
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: declare_table

contains

   !> Declare from which pressure, how near and by how many rows.
   pure subroutine declare_table(limits, keys)
      !> Pressure, relative error, number of rows
      type(deck_choice), intent(inout) :: limits
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%optional_real('smallest_pressure', limits%smallest_pressure, 'MPa', &
         'pressure from which it holds; unless given, 1e-9 2 pi eta R H sigma, as points open')
      call keys%real('tolerance', limits%tolerance, '', &
         'relative error of linear interpolation between rows')
      call keys%whole('rows', limits%rows, 'most rows; CalculiX takes 200')
   end subroutine declare_table

end module asperity_program_commands_table_keys
