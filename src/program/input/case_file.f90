!> Reads a case file: one group `&asperity ... /` of keys and values, in Fortran's namelist
!> form, which Fortran's own READ could not check by key and line.
module asperity_program_input_case_file
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_number_text, only: to_text
   use asperity_program_input_key, only: assign_words, given_as_option, given_in_case, &
      given_nowhere, kind_file, option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_nearest_key, only: nearest_key
   use asperity_program_input_scanner, only: new_scanner, scanner_type, token_comma, token_group, &
      token_none, token_quoted, token_slash, token_type, token_word
   use asperity_program_input_values, only: word_type
   use asperity_program_system_files, only: read_file
   use asperity_program_system_strings, only: lower_case, newline, quoted
   implicit none
   private
   public :: read_case

   character(len=*), parameter :: group = 'asperity'
   character(len=*), parameter :: byte_order_mark = char(239)//char(187)//char(191)
   !> Largest case file, characters: room for several of the longest lists
   integer, parameter :: mebibyte = 1024*1024, largest = 16*mebibyte

contains

   !> Read the case file of a command. It may have keys of other commands. `error` names file and
   !> line.
   subroutine read_case(keys, known, error)
      !> Keys of the command and the path; those that no option gives take the values of the file
      type(key_list), intent(inout) :: keys
      !> Keys of all commands, none of them given; their values are of no matter on return
      type(key_list), intent(inout) :: known
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: path, text, reason
      type(scanner_type) :: scanner
      integer :: i, place

      path = keys%case_path
      ! One character more than allowed tells that the file is too large
      call read_file(path, largest + 1, text, reason)
      if (allocated(reason)) then
         call fatal_error(error, path//': cannot be read: '//reason, file_error)
         return
      end if
      if (index(text, byte_order_mark) == 1) then
         call fatal_error(error, path//':1: begins with a byte order mark, which Fortran does '// &
            'not read: save the file as plain text or UTF-8 without it')
         return
      end if
      call new_scanner(scanner, text, path, error)
      if (allocated(error)) return
      if (len(text) > largest) then
         call fatal_error(error, path//': is larger than '//to_text(largest/mebibyte)// &
            ' MiB, this is not a case file')
         return
      end if
      do i = 1, keys%n
         ! other commands may have choices of their own
         known%rows(known%find(keys%rows(i)%name))%choices = keys%rows(i)%choices
      end do
      call read_group(scanner, known, error)
      if (allocated(error)) return
      if (text(len(text):) /= newline) call fatal_error(error, path// &
         ': the last line needs a line break (Fortran''s namelist READ fails without it)')
      if (allocated(error)) return
      do i = 1, keys%n
         place = known%find(keys%rows(i)%name)
         associate (key => keys%rows(i), read => known%rows(place))
            if (read%given == given_nowhere .or. key%given == given_as_option) cycle
            key%given = given_in_case
            key%has_value = .true.
            key%source = read%source
            key%text = read%text
            key%whole = read%whole
            key%switch = read%switch
            if (allocated(read%values)) key%values = read%values
         end associate
      end do
   end subroutine read_case

   !> Read `&asperity`, the keys, `/`, and nothing after it.
   pure subroutine read_group(scanner, known, error)
      type(scanner_type), intent(inout) :: scanner
      type(key_list), intent(inout) :: known
      type(error_type), allocatable, intent(out) :: error
      type(token_type) :: token
      integer :: first_lines(known%n)

      call scanner%next(token, error)
      if (allocated(error)) return
      if (token%kind /= token_group .or. lower_case(token%text) /= group) then
         call fatal_error(error, scanner%place(max(1, token%line))// &
            ': a case starts with &asperity, found '//shown(token))
         return
      end if
      first_lines = 0
      do
         call scanner%next(token, error)
         if (allocated(error)) return
         if (token%kind == token_slash) exit
         call read_key(scanner, token, first_lines, known, error)
         if (allocated(error)) return
      end do
      call scanner%next(token, error)
      if (allocated(error)) return
      if (token%kind /= token_none) call fatal_error(error, scanner%place(token%line)// &
         ': nothing may follow the / that ends the group, found '//shown(token))
   end subroutine read_group

   !> Read one `key = values`, whose first token is given.
   pure subroutine read_key(scanner, name, first_lines, known, error)
      type(scanner_type), intent(inout) :: scanner
      type(token_type), intent(in) :: name
      integer, intent(inout) :: first_lines(:)
      type(key_list), intent(inout) :: known
      type(error_type), allocatable, intent(out) :: error
      type(token_type) :: equals
      type(word_type), allocatable :: words(:)
      integer :: key

      if (name%kind == token_none) then
         call fatal_error(error, scanner%place(name%line)//': the group has no end, / is missing')
         return
      end if
      if (name%kind /= token_word) then
         call fatal_error(error, scanner%place(name%line)//': expected key = value, found '// &
            shown(name))
         return
      end if
      call find_known_key(known, scanner%place(name%line), lower_case(name%text), key, error)
      if (allocated(error)) return
      if (first_lines(key) > 0) then
         call fatal_error(error, scanner%place(name%line)//': '//trim(known%rows(key)%name)// &
            ' is given twice, first in line '//to_text(first_lines(key)))
         return
      end if
      first_lines(key) = name%line

      if (.not. name%names_key) then
         call fatal_error(error, scanner%place(name%line)//': '//trim(known%rows(key)%name)// &
            ' must be followed by = and its value')
         return
      end if
      call scanner%next(equals, error)
      if (allocated(error)) return
      call read_values(scanner, name%line, trim(known%rows(key)%name), words, error)
      if (allocated(error)) return
      call assign_words(known%rows(key), words, given_in_case, error)
   end subroutine read_key

   !> The values after `key =`: all words up to the next `key =` or the end of the group,
   !> separated by blanks or single commas.
   pure subroutine read_values(scanner, line, key, words, error)
      type(scanner_type), intent(inout) :: scanner
      integer, intent(in) :: line
      character(len=*), intent(in) :: key
      type(word_type), allocatable, intent(out) :: words(:)
      type(error_type), allocatable, intent(out) :: error
      type(token_type) :: token
      type(word_type), allocatable :: found(:)
      integer :: n
      logical :: comma_before

      allocate (found(8))
      n = 0
      comma_before = .true.
      do
         call scanner%peek(token, error)
         if (allocated(error)) return
         if (token%kind == token_slash .or. token%kind == token_none) exit
         if (token%names_key) exit
         if (n > 0 .and. token%after_comment &
            .and. (comma_before .or. token%kind == token_comma)) then
            ! gfortran's READ finds an empty value there
            call fatal_error(error, scanner%place(token%line)//': a comma and a comment may '// &
               'not stand together among the values of '//key//', leave the comma out')
            return
         end if
         if (token%kind == token_comma) then
            if (comma_before) exit
            comma_before = .true.
         else if (token%kind == token_word .or. token%kind == token_quoted) then
            if (n == 0 .and. token%after_comment) exit
            if (n == size(found)) call grow(found)
            n = n + 1
            found(n)%text = token%text
            found(n)%in_quotes = token%kind == token_quoted
            found(n)%source = scanner%place(token%line)
            comma_before = .false.
         else
            call fatal_error(error, scanner%place(token%line)//': unexpected '//shown(token)// &
               ' among the values of '//key)
            return
         end if
         call scanner%next(token, error)
      end do
      if (n == 0 .or. token%kind == token_comma) then
         call fatal_error(error, scanner%place(merge(line, token%line, n == 0))//': '//key// &
            ' has '// &
            trim(merge('no value      ', 'an empty value', n == 0)))
         return
      end if
      words = found(:n)
   end subroutine read_values

   !> Twice the room, the words kept.
   pure subroutine grow(words)
      type(word_type), allocatable, intent(inout) :: words(:)
      type(word_type), allocatable :: larger(:)
      integer :: i

      allocate (larger(2*size(words)))
      do i = 1, size(words)
         larger(i) = words(i)
      end do
      call move_alloc(larger, words)
   end subroutine grow

   !> Place of a key in the table; `error` suggests the nearest.
   pure subroutine find_known_key(known, place, name, key, error)
      type(key_list), intent(in) :: known
      character(len=*), intent(in) :: place, name
      integer, intent(out) :: key
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: nearest

      key = known%find(name)
      if (key == 0) then
         if (scan(name, '(%)') > 0) then
            call fatal_error(error, place//': '//quoted(name)// &
               ' is not a key; subscripts are not supported, write the whole list')
            return
         end if
         nearest = nearest_key(name, pack(known%rows(:known%n)%name, &
            known%rows(:known%n)%kind < kind_file))
         if (nearest /= '') nearest = '; did you mean '//nearest//'?'
         call fatal_error(error, place//': unknown key '//quoted(name)//nearest)
      else if (known%rows(key)%kind >= kind_file) then
         call fatal_error(error, place//': '//name//' is not a key of a case file, '// &
            'use the option '//option_name(name))
      end if
   end subroutine find_known_key

   !> A token for a message.
   pure function shown(token) result(text)
      type(token_type), intent(in) :: token
      character(len=:), allocatable :: text

      text = quoted(token%text)
      if (token%kind == token_none) text = 'the end of the file'
      if (token%kind == token_group) text = quoted('&'//token%text)
   end function shown

end module asperity_program_input_case_file
