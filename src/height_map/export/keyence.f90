!> Keyence's csv of an image, as the programs of VK and VR microscopes write it, and spreadsheets
!> after them: lines of a key and its values, an empty one, the name of the image, and its rows.
!>
!> Its keys are translated, their order and `ImageDataCsv` are not, so that the keys behind the one
!> that begins with XY are told by their place. Where no comma separates fields, it is the decimal
!> one. Learnt from public readers and writers of English, Japanese and Chinese files (VK-X1000,
!> VK-X3000, VR-6000).
module asperity_height_map_export_keyence
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: replace_in_line
   use asperity_height_map_export_header_lines, only: next_header_line, read_size, &
      start_numbers, take_field
   use asperity_height_map_file_errors, only: line_error, line_text, plain_excerpt
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_text_header_fields, only: number_in, plain_key
   use asperity_height_map_units, only: plain_unit
   implicit none
   private
   public :: is_keyence, read_keyence_start

   character(len=*), parameter :: tab = achar(9), kinds = 'DataCsv', image = 'ImageDataCsv'
   !> Lines behind the step: the image, columns, rows, least and largest value, unit
   integer, parameter :: places = 6
   !> How words for heights begin, in lower case: English; German in Latin-1 and UTF-8; Japanese and
   !> Chinese in UTF-8 and in the encodings of their own
   character(len=*), parameter :: heights(*) = [character(len=6) :: 'height', &
      'h'//char(246)//'he', 'h'//char(195)//char(182)//'he', &
      char(233)//char(171)//char(152)//char(227)//char(129)//char(149), &
      char(141)//char(130)//char(130)//char(179), &
      char(233)//char(171)//char(152)//char(229)//char(186)//char(166), &
      char(184)//char(223)//char(182)//char(200)]
   !> Characters of a file that a message shows
   integer, parameter :: shown = 40

contains

   !> Whether a file begins as one.
   pure logical function is_keyence(head)
      !> Its beginning
      character(len=*), intent(in) :: head
      integer :: last

      last = index(head, kinds) + len(kinds)
      is_keyence = last > len(kinds) .and. last <= len(head)
      if (is_keyence) is_keyence = scan(head(last:last), '",;'//tab//achar(13)//achar(10)) > 0
   end function is_keyence

   !> Read what stands before the rows. Then the current line is the first of them.
   subroutine read_keyence_start(source, header, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What it says
      type(text_header), intent(inout) :: header
      !> Set when it is faulty, or has no heights
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line, key, value, unit, rest
      character(len=1) :: separator
      real(wp) :: number
      integer :: longest, place
      logical :: is_number, is_past_gap

      header%layout%format = 'Keyence csv'
      separator = ' '
      place = -1
      is_past_gap = .false.
      do
         call next_header_line(source, line, error)
         if (allocated(error)) return
         longest = len(line)
         if (separator == ' ') call find_separator(line, separator)
         if (separator /= ',') then
            header%layout%has_decimal_commas = .true.
            call replace_in_line(source, ',', '.')
            call line_text(source, longest, line)
         end if
         call take_field(line, separator, key)
         call take_field(line, separator, value)
         if (place < 0) then
            call check_kind()
            call number_in(value, number, is_number, rest)
            if (is_number .and. is_step(key)) then
               place = 0
               call take_field(line, separator, unit)
               call read_step()
            end if
         else if (place < places) then
            place = place + 1
            call read_by_place()
         else if (verify(key//value//line, ' "'//separator) == 0) then
            is_past_gap = .true.
         else
            call number_in(key, number, is_number, rest)
            if (is_number) exit
            if (is_past_gap) then
               ! the name of the image; its rows follow
               call next_header_line(source, line, error)
               if (allocated(error)) return
               exit
            end if
         end if
         if (allocated(error)) return
      end do
      if (header%layout%has_decimal_commas) call replace_in_line(source, ',', '.')
      call start_numbers(source, header, error, separator)

   contains

      subroutine check_kind()
         if (index(value, kinds) == 0 .or. value == image) return
         call line_error(error, source, source%first, 'the file holds '// &
            plain_excerpt(value, shown)//', not '//image//': export the height image as csv')
      end subroutine check_kind

      subroutine read_step()
         header%steps = number
         header%step_units = plain_unit(unit)
         if (number > 0.0_wp .and. number < 1.0e30_wp .and. header%step_units(1) /= '') return
         call line_error(error, source, source%first, 'the distance of points must be a number '// &
            'above 0 and its unit m, cm, mm, um or nm')
      end subroutine read_step

      subroutine read_by_place()
         character(len=:), allocatable :: word
         integer :: i

         call number_in(value, number, is_number, rest)
         select case (place)
         case (1)
            call plain_key(value, word)
            do i = 1, size(heights)
               if (index(word, trim(heights(i))) == 1) return
            end do
            call line_error(error, source, source%first, 'the file holds an image of '''// &
               plain_excerpt(value, shown)//''', no heights: export the height image as csv')
         case (2, 3)
            if (.not. is_number .or. rest /= '') number = 0.0_wp
            call read_size(source, number, header%sizes(place - 1), error)
         case (places)
            header%height_unit = plain_unit(value)
            if (header%height_unit == '') call line_error(error, source, source%first, &
               'the unit of the heights, '''//plain_excerpt(value, shown)//''', is no length: '// &
               'allowed are m, cm, mm, um and nm; export the height image as csv')
         case default
            ! least and largest value
            continue
         end select
      end subroutine read_by_place

   end subroutine read_keyence_start

   !> What stands behind the first field of a line.
   pure subroutine find_separator(line, separator)
      character(len=*), intent(in) :: line
      character(len=1), intent(inout) :: separator
      integer :: place

      place = scan(line, ',;'//tab)
      if (place > 0) separator = line(place:place)
   end subroutine find_separator

   !> Whether a key is that of the step, such as XY Calibration.
   pure logical function is_step(key)
      character(len=*), intent(in) :: key
      character(len=:), allocatable :: word

      call plain_key(key, word)
      is_step = index(word, 'xy') == 1
   end function is_step

end module asperity_height_map_export_keyence
