!> Keys in the order of listings, and what is said of each beside its value: whether it follows
!> another, is of no effect, or is refused.
module asperity_program_input_key_rows
   use asperity_base_error, only: error_type, fatal_error
   use asperity_program_input_key, only: forget, given_as_option, given_in_case, given_nowhere, &
      key_type
   implicit none
   private
   public :: key_rows, add_choices, word_of

   !> Keys.
   type :: key_rows
      !> The keys; no more than the first `n`
      type(key_type), allocatable :: rows(:)
      integer :: n = 0
      !> Place of the key that was declared last
      integer :: last = 0
      !> Keys that are declared now are properties of the faces
      logical :: of_faces = .false.
      !> Path of the case file, empty when there is none
      character(len=:), allocatable :: case_path
      !> A line below the input on the terminal, none when not allocated
      character(len=:), allocatable :: note
      !> The first value that was refused
      type(error_type), allocatable :: error
   contains
      procedure :: declare, follows, given_by, said_by, also, needs, unused, means, reads
      procedure :: find, given, forget_case, refuse, with_place
   end type key_rows

contains

   !> Unless it is given, the last key has a value made from that of another one, which it is to
   !> follow.
   pure subroutine follows(self, leader, source)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Place of the other key
      integer, intent(in) :: leader
      !> How, such as `half of height`; the value itself when absent
      character(len=*), intent(in), optional :: source

      associate (key => self%rows(self%last))
         key%default = ''
         if (key%given /= given_nowhere) return
         key%follows = .true.
         key%leader = leader
         key%source = 'as '//trim(self%rows(leader)%name)
         if (present(source)) key%source = source
      end associate
   end subroutine follows

   !> Unless it is given, the last key has the value that a text stands for, such as a pair.
   pure subroutine given_by(self, leader)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Place of the text's key
      integer, intent(in) :: leader

      associate (key => self%rows(self%last))
         key%default = ''
         if (key%given /= given_nowhere .or. .not. key%has_value) return
         key%leader = leader
         key%source = trim(self%rows(leader)%name)//' '//self%rows(leader)%text
      end associate
   end subroutine given_by

   !> Unless it is given, something else than its source has a part in the value of the last key.
   pure subroutine also(self, what)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> What it is
      character(len=*), intent(in) :: what

      associate (key => self%rows(self%last))
         if (key%given == given_nowhere) key%source = key%source//', '//what
      end associate
   end subroutine also

   !> Unless it is given, the last key has a value that was found.
   pure subroutine said_by(self, source)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Where it was found; absent if it is a default
      character(len=*), intent(in), optional :: source

      if (.not. present(source)) return
      associate (key => self%rows(self%last))
         if (key%given == given_nowhere) key%source = source
      end associate
   end subroutine said_by

   !> Refuse a key, and hide it, unless something is so.
   pure subroutine needs(self, is_so, why, place)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Whether it is so
      logical, intent(in) :: is_so
      !> What it needs
      character(len=*), intent(in) :: why
      !> Its place; the last one when absent
      integer, intent(in), optional :: place
      integer :: own

      if (is_so) return
      own = self%last
      if (present(place)) own = place
      self%rows(own)%unused = .true.
      if (self%given(own)) call self%refuse(self%rows(own)%source//': '//why, '')
   end subroutine needs

   !> Say whether the last key is of no effect on the run.
   pure subroutine unused(self, is_so)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Whether it is so
      logical, intent(in) :: is_so

      self%rows(self%last)%unused = is_so
   end subroutine unused

   !> Further names in the errors of the library that mean the last key.
   pure subroutine means(self, subjects)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> The names, separated by blanks
      character(len=*), intent(in) :: subjects

      associate (key => self%rows(self%last))
         key%subjects = trim(key%name)//' '//subjects
      end associate
   end subroutine means

   !> The last key is the path of a file that is read.
   pure subroutine reads(self, what, is_argument)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> What the file is, such as `record`
      character(len=*), intent(in) :: what
      !> Whether it is given without an option, too
      logical, intent(in) :: is_argument

      self%rows(self%last)%reads = what
      self%rows(self%last)%is_argument = is_argument
   end subroutine reads

   !> Place of a key, zero when there is none of that name.
   pure integer function find(self, name)
      !> The keys
      class(key_rows), intent(in) :: self
      !> Name as in case files, in lower case
      character(len=*), intent(in) :: name

      do find = self%n, 1, -1
         if (self%rows(find)%name == name) return
      end do
   end function find

   !> Whether a key was given.
   pure logical function given(self, place)
      !> The keys
      class(key_rows), intent(in) :: self
      !> Its place; the last one when absent
      integer, intent(in), optional :: place

      given = self%rows(self%last)%given /= given_nowhere
      if (present(place)) given = self%rows(place)%given /= given_nowhere
   end function given

   !> Forget what the case file gives some keys, if an option gives it anew.
   pure subroutine forget_case(self, option, places)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Place of the option's key
      integer, intent(in) :: option
      !> Places of the others
      integer, intent(in) :: places(:)
      integer :: i

      if (self%rows(option)%given /= given_as_option) return
      do i = 1, size(places)
         if (self%rows(places(i))%given == given_in_case) call forget(self%rows(places(i)))
      end do
   end subroutine forget_case

   !> Refuse a value, unless one is refused.
   pure subroutine refuse(self, message, subject)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> What is wrong
      character(len=*), intent(in) :: message
      !> Names of the keys that it is about
      character(len=*), intent(in) :: subject

      if (.not. allocated(self%error)) call fatal_error(self%error, message, subject=subject)
   end subroutine refuse

   !> Put the place where the user gave a value before a message about it.
   pure subroutine with_place(self, error)
      !> The keys
      class(key_rows), intent(in) :: self
      !> Its message is changed; it is about nothing on return
      type(error_type), intent(inout) :: error
      integer :: i, place

      do i = 1, count([(error%subject(i:i) == ' ', i=1, len(error%subject))]) + 1
         place = meant(self, word_of(error%subject, i))
         if (place == 0) cycle
         if (self%rows(place)%follows) place = self%rows(place)%leader
         if (self%rows(place)%given == given_nowhere) cycle
         error%message = self%rows(place)%source//': '//error%message
         exit
      end do
      error%subject = ''
   end subroutine with_place

   !> Place of the key that a name in an error means, zero for none.
   pure integer function meant(self, name)
      class(key_rows), intent(in) :: self
      character(len=*), intent(in) :: name

      meant = 0
      if (name == '') return
      do meant = self%n, 1, -1
         if (index(' '//trim(self%rows(meant)%subjects)//' ', ' '//trim(name)//' ') > 0) return
      end do
   end function meant

   !> List a key, and make it the last one. Unless it is given, its value is a default.
   pure subroutine declare(self, name, kind, unit, help, default)
      !> The keys
      class(key_rows), intent(inout) :: self
      !> Its name, its unit, what it is, and its default as a text
      character(len=*), intent(in) :: name, unit, help, default
      !> Its kind
      integer, intent(in) :: kind

      self%last = self%find(name)
      if (self%last == 0) then
         call make_room(self)
         self%n = self%n + 1
         self%last = self%n
         associate (key => self%rows(self%n))
            key%name = name
            key%kind = kind
            key%is_property = self%of_faces
            key%default = default
            key%help = help
            key%subjects = name
            key%text = ''
         end associate
      end if
      associate (key => self%rows(self%last))
         key%unit = unit
         key%unused = .false.
         key%follows = .false.
         key%leader = 0
         if (key%given == given_nowhere) key%source = 'default'
      end associate
   end subroutine declare

   !> Room for one more key.
   pure subroutine make_room(self)
      class(key_rows), intent(inout) :: self
      type(key_type), allocatable :: larger(:)
      integer :: i

      if (.not. allocated(self%rows)) allocate (self%rows(64))
      if (self%n < size(self%rows)) return
      allocate (larger(2*self%n))
      do i = 1, self%n
         larger(i) = self%rows(i)
      end do
      call move_alloc(larger, self%rows)
   end subroutine make_room

   !> A word of a text, from 1, blank when it has not so many.
   pure function word_of(text, which) result(word)
      !> The text
      character(len=*), intent(in) :: text
      !> Which word
      integer, intent(in) :: which
      character(len=len(text)) :: word
      integer :: i

      word = text
      do i = 2, which
         word = word(index(word//' ', ' ') + 1:)
      end do
      word = word(:index(word//' ', ' ') - 1)
   end function word_of

   !> Choices of a key, to which another command of all may add its own.
   pure subroutine add_choices(key, choices)
      !> The key, with those so far
      type(key_type), intent(inout) :: key
      !> More of them
      character(len=*), intent(in) :: choices
      character(len=len(choices)) :: word
      integer :: i

      do i = 1, count([(choices(i:i) == ' ', i=1, len_trim(choices))]) + 1
         word = word_of(choices, i)
         if (index(' '//trim(key%choices)//' ', ' '//trim(word)//' ') > 0) cycle
         key%choices = adjustl(trim(key%choices)//' '//word)
      end do
   end subroutine add_choices

end module asperity_program_input_key_rows
