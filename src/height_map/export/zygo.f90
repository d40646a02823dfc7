!> Zygo's XYZ text: 13 or 14 lines whose places say what they are, a `#`, a line for each point with
!> column, row and height or `No Data`, a `#`.
!>
!> Line 4 has the first column and row and how many there are, the seventh number of line 8 is the
!> distance of pixels in m. It does not say the unit of heights, which MetroPro writes in um and
!> Mx in others as well. Learnt from public readers of files of both.
module asperity_height_map_export_zygo
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_export_header_lines, only: next_header_line, numbers_in, read_size, &
      start_points
   use asperity_height_map_file_errors, only: line_error
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_type, only: add_note, height_map
   use asperity_height_map_units, only: map_hints
   implicit none
   private
   public :: read_zygo_start

   real(wp), parameter :: m = 1.0e3_wp  ! mm
   !> Lines before the mark at least
   integer(int64), parameter :: fewest = 13_int64

contains

   !> Read what stands before the points. Then the current line is the first of them.
   subroutine read_zygo_start(source, hints, header, map, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> What it says
      type(text_header), intent(inout) :: header
      !> Its notes are added to
      type(height_map), intent(inout) :: map
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line
      real(wp) :: values(7)
      integer :: axis, count

      header%layout%format = 'Zygo XYZ text'
      header%layout%has_end_mark = .true.
      header%layout%coordinate = 0.0_wp
      do
         call next_header_line(source, line, error)
         if (allocated(error)) return
         if (line == '#') exit
         call numbers_in(line, values, count)
         if (source%line == 4_int64) then
            if (count < 4) values(3:4) = 0.0_wp
            do axis = 1, 2
               call read_size(source, values(axis + 2), header%sizes(axis), error)
               if (allocated(error)) return
            end do
         else if (source%line == 8_int64 .and. count == 7) then
            if (values(7) > 0.0_wp .and. values(7) < 1.0_wp) header%layout%coordinate = m*values(7)
         end if
      end do
      if (source%line <= fewest) then
         call line_error(error, source, source%first, 'there are '// &
            to_text(source%line - 1_int64)//' lines before the points, 13 or 14 must be there: '// &
            'the header is damaged')
         return
      end if
      call note_units(hints, header, map)
      call next_header_line(source, line, error)
      if (.not. allocated(error)) call start_points(source, header, error)
   end subroutine read_zygo_start

   !> Say what the file leaves open, and what it does not.
   subroutine note_units(hints, header, map)
      type(map_hints), intent(in) :: hints
      type(text_header), intent(inout) :: header
      type(height_map), intent(inout) :: map
      character(len=:), allocatable :: text

      if (hints%height_unit == '') then
         header%height_unit = 'um'
         call add_note(map, 'heights are taken for um, as MetroPro writes them: the file does '// &
            'not say it, and Mx may write others, which --height-unit says.')
      end if
      if (header%layout%coordinate > 0.0_wp) then
         text = 'coordinates count pixels, which are '//to_text(header%layout%coordinate, 6)// &
            ' mm apart by its header'
         if (hints%lateral_unit /= '') text = text//'; --lateral-unit '// &
            trim(hints%lateral_unit)//' is not used'
         call add_note(map, text//'.')
      end if
   end subroutine note_units

end module asperity_height_map_export_zygo
