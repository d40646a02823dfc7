!> The program units of a Fortran source, followed from statement to statement: which subroutines it
!> has, and what they are in.
module asperity_check_source_units
   use asperity_check_source_heads, only: begins, begins_interface, ended_kind, identifier_end, &
      name_length, read_head
   implicit none
   private
   public :: program_units, source_routine

   !> A subroutine of a source.
   type :: source_routine
      !> Its name in lower case
      character(len=name_length) :: name = ''
      !> Names of its arguments in lower case
      character(len=name_length), allocatable :: arguments(:)
      !> `external`, `internal`, `module` (a procedure of one), `entry` or `bind(c)`
      character(len=8) :: role = 'external'
      !> What it is in, empty for external
      character(len=name_length) :: host = ''
      !> Line of its head
      integer :: line = 0
   end type source_routine

   !> A unit that is open.
   type :: open_unit
      !> `module`, `program`, `procedure` or `interface`
      character(len=9) :: kind = ''
      character(len=name_length) :: name = ''
      !> Whether its CONTAINS was met
      logical :: contains = .false.
   end type open_unit

   !> Where in a source its reader is, and the subroutines so far.
   type :: program_units
      private
      type(open_unit), allocatable :: open(:)
      type(source_routine), allocatable :: found(:)
   contains
      !> Follow a statement
      procedure :: follow
      !> The subroutines, those in interfaces left out
      procedure :: routines
   end type program_units

contains

   !> Follow a statement.
   pure subroutine follow(self, statement, line)
      !> Where we are
      class(program_units), intent(inout) :: self
      !> A statement of `next_statement`, and its line
      character(len=*), intent(in) :: statement
      integer, intent(in) :: line
      character(len=name_length) :: name
      character(len=:), allocatable :: arguments
      logical :: is_head, bound

      if (.not. allocated(self%open)) allocate (self%open(0), self%found(0))
      if (ended_kind(statement) /= '') then
         call close_unit(self, ended_kind(statement))
         return
      end if
      if (statement == 'contains') then
         if (size(self%open) > 0) self%open(size(self%open))%contains = .true.
         return
      end if
      if (begins_interface(statement)) then
         call push(self, 'interface', '')
         return
      end if
      call read_head(statement, 'subroutine', name, arguments, bound, is_head)
      if (is_head) then
         ! where no subroutine may begin, an END was not seen
         if (in_body(self)) call close_unit(self, 'any')
         call keep(self, name, arguments, line, bound)
         call push(self, 'procedure', name)
         return
      end if
      call read_head(statement, 'function', name, arguments, bound, is_head)
      if (is_head .and. .not. in_body(self)) then
         call push(self, 'procedure', name)
         return
      end if
      call read_head(statement, 'entry', name, arguments, bound, is_head)
      if (is_head .and. in_body(self)) then
         call keep(self, name, arguments, line, bound, 'entry')
         return
      end if
      call follow_container(self, statement)
   end subroutine follow

   !> Follow the head of a module, submodule, program, block data or separate module procedure.
   pure subroutine follow_container(self, statement)
      class(program_units), intent(inout) :: self
      character(len=*), intent(in) :: statement
      integer :: n

      if (in_body(self)) return
      n = index(statement, ')')
      if (begins(statement, 'submodule(') .and. n > 0) then
         call push(self, 'module', statement(n + 1:))
      else if (identifier_end(statement) < len(statement)) then
         return
      else if (begins(statement, 'moduleprocedure') .and. size(self%open) > 0) then
         if (self%open(size(self%open))%kind /= 'interface') &
            call push(self, 'procedure', statement(16:))
      else if (begins(statement, 'module')) then
         call push(self, 'module', statement(7:))
      else if (begins(statement, 'program')) then
         call push(self, 'program', statement(8:))
      else if (begins(statement, 'blockdata')) then
         call push(self, 'program', statement(10:))
      end if
   end subroutine follow_container

   pure subroutine push(self, kind, name)
      class(program_units), intent(inout) :: self
      character(len=*), intent(in) :: kind, name
      type(open_unit) :: unit

      unit%kind = kind
      unit%name = name
      self%open = [self%open, unit]
   end subroutine push

   !> Keep a subroutine, unless it stands in an interface.
   pure subroutine keep(self, name, arguments, line, bound, role)
      class(program_units), intent(inout) :: self
      character(len=*), intent(in) :: name, arguments
      integer, intent(in) :: line
      logical, intent(in) :: bound
      character(len=*), intent(in), optional :: role
      type(source_routine), allocatable :: grown(:)
      integer :: n

      if (any(self%open%kind == 'interface')) return
      n = size(self%found) + 1
      allocate (grown(n))
      grown(:n - 1) = self%found
      grown(n)%name = name
      grown(n)%line = line
      call split(arguments, grown(n)%arguments)
      if (size(self%open) > 0) then
         grown(n)%host = self%open(size(self%open))%name
         grown(n)%role = 'internal'
         if (self%open(size(self%open))%kind == 'module') grown(n)%role = 'module'
      end if
      if (bound) grown(n)%role = 'bind(c)'
      if (present(role)) grown(n)%role = role
      call move_alloc(grown, self%found)
   end subroutine keep

   !> The subroutines so far.
   pure subroutine routines(self, found)
      !> Where we are
      class(program_units), intent(in) :: self
      !> Those in interfaces left out
      type(source_routine), allocatable, intent(out) :: found(:)

      if (allocated(self%found)) then
         found = self%found
      else
         allocate (found(0))
      end if
   end subroutine routines

   !> Whether we are among declarations and statements of a procedure, where no other may begin.
   pure logical function in_body(self)
      class(program_units), intent(in) :: self

      in_body = .false.
      if (size(self%open) == 0) return
      associate (last => self%open(size(self%open)))
         in_body = any(last%kind == [character(len=9) :: 'procedure', 'program']) .and. &
            .not. last%contains
      end associate
   end function in_body

   !> Close the last open unit of a kind, or of `any` kind, and what is open in it.
   pure subroutine close_unit(self, kind)
      class(program_units), intent(inout) :: self
      character(len=*), intent(in) :: kind
      integer :: i

      do i = size(self%open), 1, -1
         if (kind /= 'any' .and. self%open(i)%kind /= kind) cycle
         self%open = self%open(:i - 1)
         return
      end do
   end subroutine close_unit

   !> The names of a list with commas.
   pure subroutine split(list, names)
      character(len=*), intent(in) :: list
      character(len=name_length), allocatable, intent(out) :: names(:)
      integer :: finish, i, start

      if (list == '') then
         allocate (names(0))
         return
      end if
      allocate (names(count([(list(i:i) == ',', i=1, len(list))]) + 1))
      start = 1
      do i = 1, size(names)
         finish = start - 1 + index(list(start:)//',', ',')
         names(i) = list(start:finish - 1)
         start = finish + 1
      end do
   end subroutine split

end module asperity_check_source_units
