!> Tells the text that programs of instruments export by its beginning, and reads what stands before
!> its numbers; then what stands behind them.
module asperity_height_map_export_start
   use asperity_base_error, only: error_type
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line
   use asperity_height_map_export_keyence, only: is_keyence, read_keyence_start
   use asperity_height_map_export_spip, only: read_spip_start, read_voids, spip_mark
   use asperity_height_map_export_surfer, only: read_surfer_start, surfer_mark
   use asperity_height_map_export_wyko, only: read_wyko_start, wyko_mark
   use asperity_height_map_export_zygo, only: read_zygo_start
   use asperity_height_map_file_errors, only: map_error
   use asperity_height_map_text_ending, only: line_other, line_type
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_type, only: add_note, height_map
   use asperity_height_map_units, only: map_hints
   implicit none
   private
   public :: read_export_end, read_export_start

contains

   !> Read the header of an export. Then the current line is the first of numbers.
   subroutine read_export_start(source, head, hints, header, map, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> Its beginning
      character(len=*), intent(in) :: head
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> What it says; its format stays empty where the text is no export
      type(text_header), intent(out) :: header
      !> Its notes are added to
      type(height_map), intent(inout) :: map
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error

      if (index(head, 'Zygo XYZ Data File') == 1) then
         call read_zygo_start(source, hints, header, map, error)
      else if (index(head, 'Zygo ASCII Data File') == 1) then
         call map_error(error, source, 'is Zygo ASCII data, whole numbers of phase: export the '// &
            'heights as XYZ')
      else if (index(head, wyko_mark) == 1) then
         call read_wyko_start(source, header, map, error)
      else if (index(head, spip_mark) == 1) then
         call read_spip_start(source, header, error)
      else if (index(head, surfer_mark) == 1) then
         call read_surfer_start(source, hints, header, error)
      else if (is_keyence(head)) then
         call read_keyence_start(source, header, error)
      end if
   end subroutine read_export_start

   !> Read what stands behind the heights; the current line is the last of them.
   subroutine read_export_end(source, header, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> Its header
      type(text_header), intent(in) :: header
      !> The map; missing points are taken out, and a note tells of what is left
      type(height_map), intent(inout) :: map
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      logical :: found

      if (header%layout%has_voids) call read_voids(source, header, map, error)
      do while (.not. allocated(error))
         call next_line(source, found, error)
         if (allocated(error) .or. .not. found) return
         if (line_type(source) == line_other) exit
      end do
      if (.not. allocated(error)) call add_note(map, 'what stands behind the heights is not read.')
   end subroutine read_export_end

end module asperity_height_map_export_start
