!> What a kind of fit is: a model with keys, the record that it is held against, and what of it may
!> be free.
!>
!> `asperity fit` first declares the keys of the model, then sets what is fixed, declares again,
!> gives the record, and asks for a parameter of every free key and for the problem. When the values
!> are found it asks for the curve and for a case file.
module asperity_program_commands_fit_kind
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_problem, only: fit_problem
   use asperity_program_commands_fit_record_input, only: fit_record, record_quantities
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: fit_kind

   !> A kind of fit.
   type, abstract :: fit_kind
      !> Keys of the model, with what is fixed
      type(key_list) :: keys
      !> What the columns of a record may be, and what they are
      type(record_quantities), allocatable :: choices(:)
      type(record_quantities) :: quantities
      !> Searches unless their number is given
      integer :: usual_searches = 5
   contains
      !> Give the variables of the model the values of its keys
      procedure(declare), deferred :: declare
      !> Names of numbers of the model that are neither given nor free, separated by blanks
      procedure(missing), deferred :: missing
      !> Take the tests of the record
      procedure(take_records), deferred :: take_records
      !> Unit, start and bounds of a key that is free
      procedure(parameter_of), deferred :: parameter_of
      !> The problem of some free keys
      procedure(make_problem), deferred :: make_problem
      !> What is to be said of the values found and of the record, besides what holds for all kinds
      procedure(remarks), deferred :: remarks
      !> A case file's keys with the values found
      procedure(case_keys), deferred :: case_keys
   end type fit_kind

   abstract interface
      !> Give the variables of the model the values of its keys; keys%error is set when one is
      !> refused.
      subroutine declare(self)
         import :: fit_kind
         !> The kind
         class(fit_kind), intent(inout) :: self
      end subroutine declare

      !> Names of numbers of the model that are neither given nor free.
      pure function missing(self, free) result(names)
         import :: fit_kind, string_type
         !> The kind, declared
         class(fit_kind), intent(in) :: self
         !> Names of the free keys
         type(string_type), intent(in) :: free(:)
         !> Separated by blanks
         character(len=:), allocatable :: names
      end function missing

      !> Take the tests, of which some samples may be left out. `error` is set when they are of
      !> another kind.
      subroutine take_records(self, records, error)
         import :: error_type, fit_kind, fit_record
         !> The kind, declared
         class(fit_kind), intent(inout) :: self
         !> The tests, in the units of the model
         type(fit_record), intent(inout) :: records(:)
         !> Set when they do not fit
         type(error_type), allocatable, intent(out) :: error
      end subroutine take_records

      !> Unit, start and bounds of a key that is free; `error` is set when it may not be.
      subroutine parameter_of(self, name, parameter, error)
         import :: error_type, fit_kind, fit_parameter
         !> The kind, with its record
         class(fit_kind), intent(in) :: self
         !> Name of the key
         character(len=*), intent(in) :: name
         !> Start and bounds may still be changed by the user
         type(fit_parameter), intent(out) :: parameter
         !> Set when it may not be free
         type(error_type), allocatable, intent(out) :: error
      end subroutine parameter_of

      !> The problem of some free keys.
      subroutine make_problem(self, free, scale, problem, error)
         import :: error_type, fit_kind, fit_problem, string_type, wp
         !> The kind, with its record
         class(fit_kind), intent(inout) :: self
         !> Names of the free keys, in the order of the values
         type(string_type), intent(in) :: free(:)
         !> What differences are divided by at each sample of all tests
         real(wp), intent(in) :: scale(:)
         !> The problem
         class(fit_problem), allocatable, intent(out) :: problem
         !> Set when the model cannot be made
         type(error_type), allocatable, intent(out) :: error
      end subroutine make_problem

      !> What is to be said of the values found and of the record. Keys of the model have the values
      !> found.
      subroutine remarks(self, lines)
         import :: fit_kind, string_type
         !> The kind, declared with the values found
         class(fit_kind), intent(in) :: self
         !> One a remark
         type(string_type), allocatable, intent(out) :: lines(:)
      end subroutine remarks

      !> A case file's keys with the values found.
      subroutine case_keys(self, keys, commands)
         import :: fit_kind, key_list
         !> The kind, declared with the values found
         class(fit_kind), intent(in) :: self
         !> The keys
         type(key_list), intent(out) :: keys
         !> Commands that take such a case, as a text
         character(len=:), allocatable, intent(out) :: commands
      end subroutine case_keys
   end interface

end module asperity_program_commands_fit_kind
