!> Wyko's ASCII text: keys with types, lengths and values, and blocks of numbers, of which the first
!> of heights is read. A line of a block is one of constant x, its first number at y = 0.
!>
!> Of the three numbers of the first line the first is 1 where each line is a point x, y, z in mm,
!> and the second is 1 where heights are nm and not wave lengths; `Aspect` is the step in y over
!> that in x, `Pixel_size`, mm. So do Gwyddion and SurfaceTopography. They disagree about `Mult`:
!> Gwyddion 2.62 multiplies by it what SurfaceTopography divides, so that it is refused.
module asperity_height_map_export_wyko
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_export_header_lines, only: next_header_line, numbers_in, read_size, &
      start_numbers, start_points, take_field
   use asperity_height_map_file_errors, only: line_error, plain_excerpt
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_text_header_fields, only: number_in
   use asperity_height_map_type, only: add_note, height_map
   implicit none
   private
   public :: read_wyko_start, wyko_mark

   character(len=*), parameter :: wyko_mark = 'Wyko ASCII Data File Format'
   character(len=*), parameter :: tab = achar(9)
   !> Type of a block of numbers, and names of those of heights
   character(len=*), parameter :: array = '3'
   character(len=*), parameter :: blocks(*) = [character(len=11) :: 'RAW_DATA', 'RAW DATA', 'Raw', &
      'OPD', 'SAMPLE_DATA']
   real(wp), parameter :: nm = 1.0e-6_wp  ! mm
   !> Characters of a file that a message shows
   integer, parameter :: shown = 40

contains

   !> Read what stands before the heights. Then the current line is the first of them.
   subroutine read_wyko_start(source, header, map, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What it says
      type(text_header), intent(inout) :: header
      !> Its notes are added to
      type(height_map), intent(inout) :: map
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line, key, value, rest, unused
      real(wp) :: aspect, flags(3), number, wave
      integer :: count
      logical :: has_points, is_number

      header%layout%format = 'Wyko ASCII'
      header%layout%has_more = .true.
      call next_header_line(source, line, error)
      if (allocated(error)) return
      call numbers_in(line(len(wyko_mark) + 1:), flags, count)
      if (count < 3) then
         call line_error(error, source, source%first, 'three numbers must follow '//wyko_mark)
         return
      end if
      has_points = abs(flags(1)) > 0.0_wp
      aspect = 1.0_wp
      wave = 0.0_wp
      do
         call next_header_line(source, line, error)
         if (allocated(error)) return
         call take_field(line, tab, key)
         call take_field(line, tab, value)
         if (key == 'X Size' .or. key == 'Y Size') then
            call number_in(value, number, is_number, rest)
            call read_size(source, number, header%sizes(merge(1, 2, key == 'X Size')), error)
            if (allocated(error)) return
            cycle
         end if
         if (value == array) then
            if (any(blocks == key)) exit
            ! a block that is none of heights, unless it is a line within one
            call number_in(key, number, is_number, rest)
            if (.not. is_number .and. key /= 'Bad') call add_note(map, 'the block '// &
               plain_excerpt(key, shown)//' is not read.')
            cycle
         end if
         call take_field(line, tab, unused)
         call take_field(line, tab, value)
         call number_in(value, number, is_number, rest)
         select case (key)
         case ('Wavelength')
            call set(wave)
         case ('Aspect')
            call set(aspect)
         case ('Pixel_size')
            call set(header%steps(1))
         case ('Mult')
            if (.not. is_number) number = 0.0_wp
            if (abs(number - 1.0_wp) > 0.0_wp) call line_error(error, source, source%first, &
               'Mult is '//plain_excerpt(value, shown)//': whether heights are over it or '// &
               'times it, readers of this format do not agree; export the heights in nm '// &
               'without it, or as OPD, which Gwyddion saves as .gwy')
         case default
            continue
         end select
         if (allocated(error)) return
      end do
      if (any(header%sizes == 0_int64)) then
         call line_error(error, source, source%first, 'X Size and Y Size must stand before the '// &
            'heights')
         return
      end if
      header%steps(2) = aspect*header%steps(1)
      header%step_units = 'mm'
      call settle_heights()
      if (allocated(error)) return
      call next_header_line(source, line, error)
      if (allocated(error)) return
      if (has_points) then
         header%lateral_unit = 'mm'
         call start_points(source, header, error)
      else
         header%layout%has_lines_of_x = .true.
         call start_numbers(source, header, error)
      end if

   contains

      subroutine set(variable)
         real(wp), intent(inout) :: variable

         if (is_number) is_number = number >= 1.0e-9_wp .and. number <= 1.0e9_wp
         if (is_number) then
            variable = number
         else
            call line_error(error, source, source%first, key//' must be a number from 1e-9 to 1e9')
         end if
      end subroutine set

      subroutine settle_heights()
         if (abs(flags(2)) > 0.0_wp) then
            header%height_unit = 'nm'
         else if (wave > 0.0_wp) then
            header%factor = wave*nm
            call add_note(map, 'heights are wave lengths of '//to_text(wave)//' nm.')
         else
            call line_error(error, source, source%first, 'heights are wave lengths, and no '// &
               'Wavelength stands before them: export the heights in nm')
         end if
      end subroutine settle_heights

   end subroutine read_wyko_start

end module asperity_height_map_export_wyko
