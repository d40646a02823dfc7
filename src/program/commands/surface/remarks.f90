!> What is to be said of a height map: by its readers, and of what was found on it.
module asperity_program_commands_surface_remarks
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_height_map_type, only: height_map, note_end
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_commands_surface_verify, only: take_summits
   use asperity_law_normal_properties, only: heights_gaussian, normal_properties
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   use asperity_surface_analysis, only: surface_analysis_type
   use asperity_surface_remarks_on_analysis, only: find_remarks, map_facts, remark_type
   use asperity_surface_remarks_on_heights, only: remark_heights
   implicit none
   private
   public :: add_heights_remark, add_remarks, map_notes

contains

   !> What is to be said of the map and its parameters.
   pure subroutine add_remarks(options, report, map, analysis, filled)
      !> The options
      type(surface_options), intent(in) :: options
      !> Its remarks are added to
      type(report_type), intent(inout) :: report
      !> The map as it was analysed
      type(height_map), intent(in) :: map
      !> What was found
      type(surface_analysis_type), intent(in) :: analysis
      !> Share of points that were filled in
      real(wp), intent(in) :: filled
      type(map_facts) :: facts
      type(remark_type), allocatable :: found(:)
      type(string_type), allocatable :: lines(:)
      integer :: i

      facts%filled = filled
      facts%points = shape(map%heights)
      facts%top = map_place(map, maxloc(map%heights, mask=.not. is_none(map%heights)))
      facts%bottom = map_place(map, minloc(map%heights))
      facts%step_x = map%step_x
      facts%step_y = map%step_y
      associate (tiles => options%analysis%tiles)
         if (tiles > 1) then
            facts%tile_x = map%step_x*real(size(map%heights, 1)/tiles, wp)
            facts%tile_y = map%step_y*real(size(map%heights, 2)/tiles, wp)
         end if
      end associate
      facts%peaks = real(count(analysis%summits%is_peak), wp)
      ! gfortran warns otherwise of what is intent(out) anyway
      allocate (found(0))
      call find_remarks(analysis%values(:, 1), analysis%uncertainty, facts, &
         options%route, found, analysis%values(:, 2))
      allocate (lines(size(found)))
      do i = 1, size(found)
         lines(i)%text = found(i)%text
      end do
      report%remarks = [lines, report%remarks]
   end subroutine add_remarks

   !> What heights that are not Gaussian do to the pressure of the law, if that has Gaussian ones.
   pure subroutine add_heights_remark(report, analysis, law, route)
      !> Its remarks are added to
      type(report_type), intent(inout) :: report
      !> What was found
      type(surface_analysis_type), intent(in) :: analysis
      !> The law by the route
      type(normal_properties), intent(in) :: law
      !> The route
      character(len=*), intent(in) :: route
      type(remark_type), allocatable :: found(:)
      real(wp), allocatable :: heights(:), curvatures(:)
      integer :: i

      if (law%height_distribution /= heights_gaussian) return
      allocate (found(0))
      if (allocated(analysis%summits%height)) then
         call take_summits(analysis, route, heights, curvatures)
      else
         allocate (heights(0), curvatures(0))
      end if
      call remark_heights(law, analysis%values(:, 1), analysis%uncertainty, heights, curvatures, &
         analysis%area, found)
      do i = 1, size(found)
         call report%add_remark(found(i)%text)
      end do
   end subroutine add_heights_remark

   !> What the readers had to say of the map.
   pure subroutine map_notes(map, notes)
      !> The map
      type(height_map), intent(in) :: map
      !> One line each
      type(string_type), allocatable, intent(out) :: notes(:)
      integer :: finish, i, start

      if (.not. allocated(map%notes)) then
         allocate (notes(0))
         return
      end if
      allocate (notes(count([(map%notes(i:i) == note_end, i=1, len(map%notes))])))
      start = 1
      do i = 1, size(notes)
         finish = start - 1 + index(map%notes(start:), note_end)
         notes(i)%text = map%notes(start:finish - 1)
         start = finish + 1
      end do
   end subroutine map_notes

   !> Coordinates of a point.
   pure function map_place(map, point) result(place)
      type(height_map), intent(in) :: map
      integer, intent(in) :: point(2)
      real(wp) :: place(2)

      place = real(point - 1, wp)*[map%step_x, map%step_y]
   end function map_place

end module asperity_program_commands_surface_remarks
