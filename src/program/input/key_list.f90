!> The keys of a command, each declared once with the variable that takes its value:
!>
!>     call keys%real('height', joint%height, 'mm', 'height of the tenon')
!>     call keys%unused(.not. joint%has_height)
!>
!> The first time, the variable says the default, and the key is listed. Then options and case file
!> are read into the list, and the same calls give every variable its value; a default may then be
!> computed from variables whose keys stand above. What is said of a key after its declaration
!> (`follows`, `unused`, ...; see key_rows.f90) is said of the last one.
module asperity_program_input_key_list
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_program_input_key, only: given_nowhere, kind_choice, kind_counts, kind_integer, &
      kind_list, kind_logical, kind_paths, kind_real, kind_request, kind_text
   use asperity_program_input_key_rows, only: add_choices, key_rows, word_of
   use asperity_program_input_ranges, only: list_text
   use asperity_program_system_strings, only: split_lines, string_type
   implicit none
   private
   public :: key_list

   !> Keys that are bound to variables.
   type, extends(key_rows) :: key_list
   contains
      procedure :: text, paths, real => real_number, optional_real, whole, switch
      procedure, private :: choice_text, choice_place, choice_switch
      generic :: choice => choice_text, choice_place, choice_switch
      procedure, private :: real_list, count_list
      generic :: list => real_list, count_list
      procedure :: request
   end type key_list

contains

   !> A text, or the path of a file to write; the variable is empty for none.
   pure subroutine text(self, name, value, help, kind)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      character(len=:), allocatable, intent(inout) :: value
      !> What it is
      character(len=*), intent(in) :: help
      !> `kind_file`, `kind_picture`, `kind_place` or `kind_sweep` where it is no mere text
      integer, intent(in), optional :: kind

      if (.not. allocated(value)) value = ''
      call self%declare(name, kind_text, '', help, value)
      associate (key => self%rows(self%last))
         if (present(kind)) key%kind = kind
         if (key%given /= given_nowhere) then
            value = key%text
         else
            key%text = value
            key%has_value = value /= ''
         end if
      end associate
   end subroutine text

   !> Paths of files that are read; the variable has no elements for none.
   pure subroutine paths(self, name, value, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      type(string_type), allocatable, intent(out) :: value(:)
      !> What they are
      character(len=*), intent(in) :: help

      call self%declare(name, kind_paths, '', help, '')
      call split_lines(self%rows(self%last)%text, value)
   end subroutine paths

   !> One of several texts; the variable is blank for none.
   pure subroutine choice_text(self, name, value, choices, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      character(len=*), intent(inout) :: value
      !> The texts, separated by blanks
      character(len=*), intent(in) :: choices
      !> What it is
      character(len=*), intent(in) :: help

      call self%declare(name, kind_choice, '', help, value)
      associate (key => self%rows(self%last))
         call add_choices(key, choices)
         if (key%given /= given_nowhere) then
            value = key%text
         else
            key%text = trim(value)
            key%has_value = value /= ''
         end if
      end associate
   end subroutine choice_text

   !> One of several texts, by its place among them.
   pure subroutine choice_place(self, name, value, choices, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable, from 1
      integer, intent(inout) :: value
      !> The texts, separated by blanks
      character(len=*), intent(in) :: choices
      !> What it is
      character(len=*), intent(in) :: help
      character(len=len(choices)) :: chosen
      integer :: i

      chosen = word_of(choices, value)
      call self%choice_text(name, chosen, choices, help)
      value = 1
      do i = 2, count([(choices(i:i) == ' ', i=1, len(choices))]) + 1
         if (word_of(choices, i) == chosen) value = i
      end do
   end subroutine choice_place

   !> One of two texts, of which the second means true.
   pure subroutine choice_switch(self, name, value, choices, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      logical, intent(inout) :: value
      !> The texts, separated by a blank
      character(len=*), intent(in) :: choices
      !> What it is
      character(len=*), intent(in) :: help
      integer :: place

      place = merge(2, 1, value)
      call self%choice_place(name, place, choices, help)
      value = place == 2
   end subroutine choice_switch

   !> A real number; the variable is `none` for none.
   pure subroutine real_number(self, name, value, unit, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      real(wp), intent(inout) :: value
      !> Its unit, empty for none
      character(len=*), intent(in) :: unit
      !> What it is
      character(len=*), intent(in) :: help

      call self%declare(name, kind_real, unit, help, list_text([value]))
      associate (key => self%rows(self%last))
         if (key%given /= given_nowhere) then
            value = key%values(1)
         else
            key%values = [value]
            key%has_value = .not. is_none(value)
         end if
      end associate
   end subroutine real_number

   !> A real number that is not allocated unless it is given.
   pure subroutine optional_real(self, name, value, unit, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      real(wp), allocatable, intent(inout) :: value
      !> Its unit, empty for none
      character(len=*), intent(in) :: unit
      !> What it is
      character(len=*), intent(in) :: help

      call self%declare(name, kind_real, unit, help, '')
      associate (key => self%rows(self%last))
         if (key%given /= given_nowhere) then
            value = key%values(1)
         else
            key%has_value = allocated(value)
            if (allocated(value)) key%values = [value]
         end if
      end associate
   end subroutine optional_real

   !> A whole number.
   pure subroutine whole(self, name, value, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      integer, intent(inout) :: value
      !> What it is
      character(len=*), intent(in) :: help

      call self%declare(name, kind_integer, '', help, to_text(value))
      associate (key => self%rows(self%last))
         if (key%given == given_nowhere) key%whole = value
         key%has_value = .true.
         value = key%whole
      end associate
   end subroutine whole

   !> True or false.
   pure subroutine switch(self, name, value, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      logical, intent(inout) :: value
      !> What it is
      character(len=*), intent(in) :: help

      call self%declare(name, kind_logical, '', help, trim(merge('true ', 'false', value)))
      associate (key => self%rows(self%last))
         if (key%given == given_nowhere) key%switch = value
         key%has_value = .true.
         value = key%switch
      end associate
   end subroutine switch

   !> Real numbers; the variable is not allocated for none.
   pure subroutine real_list(self, name, value, unit, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      real(wp), allocatable, intent(inout) :: value(:)
      !> Its unit, empty for none
      character(len=*), intent(in) :: unit
      !> What it is
      character(len=*), intent(in) :: help

      call declare_list(self, name, kind_list, value, unit, help)
      if (self%given()) value = self%rows(self%last)%values
   end subroutine real_list

   !> Whole numbers of at least zero; the variable is not allocated for none.
   pure subroutine count_list(self, name, value, unit, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      integer, allocatable, intent(inout) :: value(:)
      !> Its unit, empty for none
      character(len=*), intent(in) :: unit
      !> What it is
      character(len=*), intent(in) :: help
      real(wp), allocatable :: usual(:)
      integer :: i

      if (allocated(value)) allocate (usual, source=real(value, wp))
      call declare_list(self, name, kind_counts, usual, unit, help)
      if (.not. self%given()) return
      associate (values => self%rows(self%last)%values)
         do i = 1, size(values)
            if (values(i) >= 0.0_wp .and. values(i) < 1.0e9_wp &
               .and. .not. abs(values(i) - anint(values(i))) > 0.0_wp) cycle
            call self%refuse(name//' = '//to_text(values(i))// &
               ' is not allowed: whole numbers of at least zero', name)
            return
         end do
         value = nint(values)
      end associate
   end subroutine count_list

   !> What lists of either kind of number have in common.
   pure subroutine declare_list(self, name, kind, values, unit, help)
      class(key_list), intent(inout) :: self
      character(len=*), intent(in) :: name, unit, help
      integer, intent(in) :: kind
      real(wp), allocatable, intent(in) :: values(:)

      if (allocated(values)) then
         call self%declare(name, kind, unit, help, list_text(values))
      else
         call self%declare(name, kind, unit, help, '')
      end if
      associate (key => self%rows(self%last))
         if (key%given /= given_nowhere) return
         key%has_value = allocated(values)
         if (allocated(values)) key%values = values
      end associate
   end subroutine declare_list

   !> Something asked for.
   pure subroutine request(self, name, value, help)
      !> The keys
      class(key_list), intent(inout) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its variable
      logical, intent(inout) :: value
      !> What it is
      character(len=*), intent(in) :: help

      call self%declare(name, kind_request, '', help, '')
      value = self%given()
   end subroutine request

end module asperity_program_input_key_list
