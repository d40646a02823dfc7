!> What is settled about the heights of a text: mm of a number, and the number that marks missing
!> points, by its header or by the user.
module asperity_height_map_text_settle
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_file_errors, only: map_error
   use asperity_height_map_text_header, only: header_remark, text_header
   use asperity_height_map_type, only: add_note, fewest_points, height_map
   use asperity_height_map_units, only: map_hints, settle_unit, unit_length
   implicit none
   private
   public :: drop_count, settle_heights

   !> Share of a number that rounding may change
   real(wp), parameter :: same = 1.0e-12_wp
   !> A factor and a unit that differ by less are the same
   real(wp), parameter :: rounding = 1.0e-3_wp

contains

   !> Settle both. Notes say what was taken, and what was not understood.
   subroutine settle_heights(source, header, hints, map, factor, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> What its header says; the user's marker is added
      type(text_header), intent(inout) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Its notes are added to
      type(height_map), intent(inout) :: map
      !> mm of a number
      real(wp), intent(out) :: factor
      !> Set when nobody says it, or two say different things
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text

      factor = header%factor
      if (hints%has_missing_value) then
         if (header%has_marker .and. abs(header%marker - hints%missing_value) > 0.0_wp) then
            call map_error(error, source, '--missing-value '//to_text(hints%missing_value)// &
               ' contradicts the file, which marks missing points by '//to_text(header%marker)// &
               ': leave the option out')
            return
         end if
         header%has_marker = .true.
         header%marker = hints%missing_value
      end if
      call header_remark(header, text)
      if (text /= '') call add_note(map, text)
      if (factor > 0.0_wp) then
         if (header%height_unit /= '' .and. &
            abs(factor - unit_length(header%height_unit)) > rounding*factor) then
            call map_error(error, source, 'heights are in '//trim(header%height_unit)// &
               ', and a factor in the header makes '//to_text(factor, 6)// &
               ' mm of each: take one of the two out')
            return
         end if
         text = 'a number is a height of '//to_text(factor, 6)//' mm, by the factor in its header'
         if (hints%height_unit /= '') text = text//'; --height-unit '// &
            trim(hints%height_unit)//' is not used'
         call add_note(map, text//'.')
      else if (allocated(header%no_length)) then
         allocate (error, source=header%no_length)
      else
         call settle_unit(source%name, 'heights', '--height-unit', header%height_unit, &
            hints%height_unit, factor, error)
      end if
   end subroutine settle_heights

   !> Take the first height of a profile away if it is the number of those behind it, as some
   !> instruments write it.
   pure subroutine drop_count(map, factor)
      !> The profile
      type(height_map), intent(inout) :: map
      !> mm of a number
      real(wp), intent(in) :: factor
      integer :: behind

      behind = size(map%heights, 1) - 1
      if (behind < fewest_points .or. &
         abs(map%heights(1, 1) - behind*factor) > same*behind*factor) return
      map%heights = map%heights(2:, :)
      call add_note(map, 'the first number is that of the heights behind it, and none of them.')
   end subroutine drop_count

end module asperity_height_map_text_settle
