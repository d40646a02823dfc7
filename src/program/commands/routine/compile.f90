!> User routines compiled by gfortran to shared libraries, in a temporary folder.
module asperity_program_commands_routine_compile
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_letter_case, only: lower_case
   use asperity_base_number_text, only: to_text
   use asperity_check_source_includes, only: include_names, include_text
   use asperity_program_commands_routine_messages, only: compiler_messages, message_type, &
      said_error, said_warning
   use asperity_program_commands_routine_stubs, only: stubs_text
   use asperity_program_system_child_command, only: run_command
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_files, only: close_file, open_file, write_text
   use asperity_program_system_path, only: resolved_path
   use asperity_program_system_strings, only: newline, shell_word
   implicit none
   private
   public :: routine_compiler, find_compiler, build_routine, build_stubs, write_file

   !> What compiles user routines.
   type :: routine_compiler
      !> Its words: FC, else gfortran
      character(len=:), allocatable :: words
   end type routine_compiler

   !> What variables hold that nothing has been given to: whatever is there, zeros, or numbers that
   !> show
   enum, bind(c)
      enumerator :: fill_none = 0, fill_zeros, fill_others
   end enum
   public :: fill_none, fill_zeros, fill_others
   character(len=*), parameter :: fill_options(0:2) = [character(len=150) :: '', &
      '-finit-real=zero -finit-integer=0 -finit-logical=false -finit-character=0 '// &
      '-finit-derived -ftrivial-auto-var-init=zero', &
      '-finit-real=inf -finit-integer=-77 -finit-logical=true -finit-character=63 '// &
      '-finit-derived -ftrivial-auto-var-init=pattern']
   !> The option among these that the oldest compilers do not have
   character(len=*), parameter :: newest_option = '-ftrivial-auto-var-init'
   !> Fortran as ABAQUS' compilers take it, locals on the stack as ABAQUS has them, and everything
   !> left out that the user routines of the file do not come to. At -O1 what is never written is
   !> no variable
   character(len=*), parameter :: options = ' -O1 -g -fPIC -shared -frecursive -std=legacy '// &
      '-fdec -fdata-sections -ffunction-sections -Wl,--gc-sections -Xlinker --version-script='
   !> What compilers are asked to say
   character(len=*), parameter :: warnings = ' -fno-diagnostics-show-caret -fmax-errors=20 '// &
      '-Wall -Wno-unused -Wno-unused-dummy-argument -Wno-tabs -Wno-conversion '
   !> The user routines that are called
   character(len=*), parameter :: exported = &
      '{ global: uinter_; vuinter_; uexternaldb_; local: *; };'
   !> Errors that a message shows
   integer, parameter :: errors_shown = 3

contains

   !> The compiler, and what ABAQUS' user subroutines include, in capitals and in small letters.
   !> `error` is set when there is none.
   subroutine find_compiler(folder, real_kind, compiler, error)
      !> Where its files go
      type(temporary_folder), intent(inout) :: folder
      !> Kind of reals: `double_kind` or `single_kind` of asperity_check_source_includes
      character(len=*), intent(in) :: real_kind
      !> The compiler
      type(routine_compiler), intent(out) :: compiler
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: output
      integer :: i, length, status

      call get_environment_variable('FC', length=length)
      compiler%words = repeat(' ', length)
      if (length > 0) call get_environment_variable('FC', compiler%words)
      if (compiler%words == '') compiler%words = 'gfortran'
      call run_command(folder, compiler%words//' --version', output, status, error)
      if (allocated(error)) return
      if (status /= 0) then
         call fatal_error(error, 'the compiler '//compiler%words//' does not run; install '// &
            'gfortran, name it by FC, or give the routine as a shared library (.so)')
      else if (index(output, 'GNU Fortran') == 0) then
         call fatal_error(error, 'FC = '//compiler%words//' is not gfortran, whose options are '// &
            'needed; set FC=gfortran')
      end if
      if (.not. allocated(error)) &
         call write_file(folder%path//'/exported', exported//newline, error)
      do i = 1, size(include_names)
         associate (name => include_names(i))
            if (.not. allocated(error)) call write_file(folder%path//'/'//trim(name), &
               trim(include_text(trim(name), real_kind)), error)
            if (.not. allocated(error)) call write_file(folder%path//'/'//trim(lower_case(name)), &
               trim(include_text(trim(name), real_kind)), error)
         end associate
      end do
   end subroutine find_compiler

   !> Compile a source to a shared library. Nothing is written but in the folder.
   subroutine build_routine(folder, compiler, path, form_options, fill, library, messages, error)
      !> Where the library goes
      type(temporary_folder), intent(inout) :: folder
      !> The compiler
      type(routine_compiler), intent(in) :: compiler
      !> Path of the source
      character(len=*), intent(in) :: path
      !> The compiler's options for its form
      character(len=*), intent(in) :: form_options
      !> One of `fill_none`, `fill_zeros` and `fill_others`
      integer, intent(in) :: fill
      !> Path of the library
      character(len=:), allocatable, intent(out) :: library
      !> What the compiler warns of
      type(message_type), allocatable, intent(out) :: messages(:)
      !> Set when it does not compile
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: output
      integer :: i, n, status

      library = folder%path//'/routine_'//to_text(fill)//'.so'
      call run_command(folder, compiler%words//options// &
         shell_word(folder%path//'/exported')//warnings//trim(fill_options(fill))//' '// &
         trim(form_options)//' -I'//shell_word(folder%path)//' '//shell_word(resolved_path(path)) &
         //' -o '//shell_word(library), output, status, error)
      if (allocated(error)) return
      call compiler_messages(output, resolved_path(path), messages)
      if (status == 0) then
         messages = pack(messages, messages%kind == said_warning)
         return
      end if
      messages = pack(messages, messages%kind == said_error)
      n = size(messages)
      if (n == 0 .and. index(output, newest_option) > 0) then
         call fatal_error(error, 'the compiler '//compiler%words//' does not know '// &
            newest_option//': gfortran 12 or a later one is needed')
         return
      else if (output == '') then
         call fatal_error(error, path//': the compiler fails and says nothing; it needs space '// &
            'in '//folder%path//' (TMPDIR)', file_error)
         return
      else if (n == 0) then
         call fatal_error(error, path//': does not compile: '//output(:index(output//newline, &
            newline) - 1))
         return
      end if
      output = messages(1)%place//': '//messages(1)%text
      do i = 2, min(n, errors_shown)
         output = output//'; '//messages(i)%place//': '//messages(i)%text
      end do
      if (n > errors_shown) output = output//'; and '//to_text(n - errors_shown)//' more'
      call fatal_error(error, path//': does not compile: '//output)
   end subroutine build_routine

   !> Compile the utilities of ABAQUS that routines call.
   subroutine build_stubs(folder, compiler, library, error)
      !> Where the library goes
      type(temporary_folder), intent(inout) :: folder
      !> The compiler
      type(routine_compiler), intent(in) :: compiler
      !> Path of the library
      character(len=:), allocatable, intent(out) :: library
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: output
      integer :: status

      library = folder%path//'/utilities.so'
      call write_file(folder%path//'/utilities.f90', stubs_text(), error)
      if (allocated(error)) return
      call run_command(folder, compiler%words//' -g -fPIC -shared -w '// &
         shell_word(folder%path//'/utilities.f90')//' -o '//shell_word(library), output, status, &
         error)
      if (status /= 0 .and. .not. allocated(error)) call fatal_error(error, &
         'what stands in for the utilities of ABAQUS does not compile: '//output)
   end subroutine build_stubs

   !> Write a file of a temporary folder.
   subroutine write_file(path, text, error)
      !> Its path
      character(len=*), intent(in) :: path
      !> What to write
      character(len=*), intent(in) :: text
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: reason
      integer :: file

      call open_file(path, file, reason)
      if (.not. allocated(reason)) call write_text(file, text, reason)
      if (.not. allocated(reason)) call close_file(file, reason)
      if (allocated(reason)) call fatal_error(error, path//' cannot be written: '//reason, &
         file_error)
   end subroutine write_file

end module asperity_program_commands_routine_compile
