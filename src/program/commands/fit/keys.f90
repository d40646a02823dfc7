!> Keys of `asperity fit`.
module asperity_program_commands_fit_keys
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_fit_record_input, only: record_input
   use asperity_program_input_key, only: kind_file
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_strings, only: repeated, string_type
   implicit none
   private
   public :: fit_options

   integer, parameter :: most_searches = 1000

   !> What is asked for.
   type :: fit_options
      !> The record
      type(record_input) :: input
      !> What it is
      character(len=8) :: kind = ''
      !> Keys of the model: names, and names with values, between commas
      character(len=:), allocatable :: free, fix, bounds, start
      !> A case file that fixes keys, and one to write
      character(len=:), allocatable :: model, case
      !> What differences are divided by
      character(len=8) :: residual_scale = 'absolute'
      !> Records that are not fitted
      type(string_type), allocatable :: hold_out(:)
      !> Searches, zero for what is usual, and what says so
      integer :: searches = 0
      character(len=:), allocatable :: searches_source
   contains
      procedure :: declare, check
   end type fit_options

contains

   !> Declare them.
   pure subroutine declare(self, keys)
      !> The options
      class(fit_options), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%choice('kind', self%kind, 'press shear joint', &
         'what the record is: of pressing two faces, of shearing them, of a tenon joint')
      call keys%text('free', self%free, &
         'KEY,...: numbers of the model that the record is to give')
      call keys%text('fix', self%fix, &
         'KEY=VALUE,...: what the model is besides; pair=NAME fixes what the pair gives')
      call keys%text('model', self%model, &
         'a case file, which fixes its keys of the model; --free and --fix go before it')
      call keys%reads('case file', is_argument=.false.)
      call keys%text('start', self%start, &
         'KEY=VALUE,...: where the search begins; as --model or pair say, else in the middle')
      call keys%text('bounds', self%bounds, &
         'KEY=LOW:HIGH,...: between what free numbers stay; wide unless given')
      call keys%choice('residual_scale', self%residual_scale, 'absolute relative', &
         'noise is as large everywhere, or in proportion to the reading')
      call keys%whole('searches', self%searches, &
         'searches from values spread between the bounds, the best counts; as usual for 0')
      call keys%said_by(self%searches_source)
      call self%input%declare(keys)
      call keys%paths('hold_out', self%hold_out, &
         'a record that is not fitted, written as the others: how far the model is from it')
      call keys%reads('record', is_argument=.false.)
      call keys%text('case', self%case, &
         'write a case file with the values found; - is standard output', kind_file)
   end subroutine declare

   !> Set `error` unless they make sense.
   pure subroutine check(self, error)
      !> The options
      class(fit_options), intent(in) :: self
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error

      call self%input%check('fit', error)
      if (allocated(error)) return
      if (repeated([self%input%files, self%hold_out]) /= '') then
         call fatal_error(error, repeated([self%input%files, self%hold_out])//': is given twice')
      else if (self%kind == '') then
         call fatal_error(error, 'nothing says what the record is: --kind press, shear or joint')
      else if (self%searches < 0 .or. self%searches > most_searches) then
         call fatal_error(error, 'searches = '//to_text(self%searches)// &
            ' is not allowed: it must lie between 0 and '//to_text(most_searches), &
            subject='searches')
      end if
   end subroutine check

end module asperity_program_commands_fit_keys
