!> User routines from shared libraries.
module asperity_program_commands_routine_load
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_procpointer, c_funptr
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_letter_case, only: upper_case
   use asperity_program_system_file_facts, only: facts_of, file_facts
   use asperity_replay_shared_library, only: find_procedure, open_library, shared_library
   implicit none
   private
   public :: load_uinter, load_vuinter

contains

   !> Load a UINTER. `error` is set when the file is no library, or has none.
   subroutine load_uinter(path, utilities, routine, error)
      !> Path of the library, and of that of the utilities of ABAQUS, empty for none
      character(len=*), intent(in) :: path, utilities
      !> The routine
      procedure(uinter_interface), pointer, intent(out) :: routine
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(c_funptr) :: found

      nullify (routine)
      call load_routine(path, utilities, 'uinter', found, error)
      if (.not. allocated(error)) call c_f_procpointer(found, routine)
   end subroutine load_uinter

   !> Load a VUINTER, of the precision that the program has.
   subroutine load_vuinter(path, utilities, routine, error)
      !> Path of the library, and of that of the utilities of ABAQUS, empty for none
      character(len=*), intent(in) :: path, utilities
      !> The routine
      procedure(vuinter_interface), pointer, intent(out) :: routine
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(c_funptr) :: found

      nullify (routine)
      call load_routine(path, utilities, 'vuinter', found, error)
      if (.not. allocated(error)) call c_f_procpointer(found, routine)
   end subroutine load_vuinter

   !> Find a routine by any of the names that compilers give it.
   subroutine load_routine(path, utilities, name, found, error)
      character(len=*), intent(in) :: path, utilities, name
      type(c_funptr), intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      type(file_facts) :: facts
      type(shared_library) :: library
      character(len=:), allocatable :: failure
      character(len=len(name)) :: capitals

      facts = facts_of(path)
      if (.not. facts%exists) then
         call fatal_error(error, path//': there is no such file', file_error)
         return
      end if
      if (utilities /= '') call open_library(utilities, library, failure, is_global=.true.)
      ! without a slash it would be looked for where the system has libraries
      if (index(path, '/') == 0) then
         call open_library('./'//path, library, failure)
      else
         call open_library(path, library, failure)
      end if
      if (allocated(failure)) then
         call fatal_error(error, path//': cannot be loaded as a shared library: '//failure)
         return
      end if
      capitals = upper_case(name)
      call find_procedure(library, name//'_', found)
      if (.not. c_associated(found)) call find_procedure(library, name, found)
      if (.not. c_associated(found)) call find_procedure(library, capitals, found)
      if (.not. c_associated(found)) call fatal_error(error, path//': has no '//capitals//': '// &
         'none of its symbols is '//name//'_, '//name//' or '//capitals)
   end subroutine load_routine

end module asperity_program_commands_routine_load
