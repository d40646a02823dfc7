!> `--opensees FILE`: a material of OpenSees that follows the loops of a record or a joint.
module asperity_program_commands_opensees_output
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_frame_comparison, only: compare_material, frame_comparison, least_steps
   use asperity_frame_dowel_type, only: dowel_type_material
   use asperity_frame_elastic_gap, only: elastic_gap_material
   use asperity_frame_fit, only: fit_material
   use asperity_frame_history, only: frame_history, new_frame_history
   use asperity_frame_material, only: frame_command, frame_material
   use asperity_frame_pinching4, only: pinching4_material
   use asperity_hysteresis_analysis, only: hysteresis_result
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_commands_opensees_script, only: material_script
   use asperity_program_input_key, only: kind_file
   use asperity_program_input_key_list, only: key_list
   use asperity_program_plot_figure, only: panel_type
   use asperity_program_plot_palette, only: blue
   use asperity_program_report_report, only: deck_type, named_table, report_type
   use asperity_program_report_table, only: column_counts, new_table, table_type
   implicit none
   private
   public :: opensees_output

   !> The output, and what it takes.
   type :: opensees_output
      private
      !> Where it is written, empty for nowhere
      character(len=:), allocatable :: path
      !> The material
      character(len=12) :: material = 'best'
      !> What was made: names in the order of the candidates
      type(frame_comparison) :: chosen
      character(len=12) :: chosen_name = ''
   contains
      !> Declare its keys
      procedure :: declare
      !> Check them
      procedure :: check
      !> Whether it is asked for
      procedure :: is_asked
      !> Refuse it where there are several records
      procedure :: refuse
      !> Fit, and add tables and the file to a report
      procedure :: add_to
      !> Draw the material over the loops
      procedure :: draw
   end type opensees_output

   !> Materials, in the order in which they are tried
   character(len=12), parameter :: names(3) = &
      [character(len=12) :: 'dowel_type', 'pinching4', 'elastic_gap']

   !> A material as near as this, in energy of cycles and in peaks, needs no word
   real(wp), parameter :: near_energy = 0.05_wp, near_peaks = 0.03_wp

contains

   !> Declare its keys.
   pure subroutine declare(self, keys)
      !> The output
      class(opensees_output), intent(inout) :: self
      !> The command's keys
      type(key_list), intent(inout) :: keys

      call keys%text('opensees', self%path, 'write a material of OpenSees that follows the '// &
         'loops, .py (openseespy) or .tcl; - is standard output, in Python', kind_file)
      call keys%choice('opensees_material', self%material, &
         'best dowel_type pinching4 elastic_gap', 'material of OpenSees; best is '// &
         'the better one of the two that take energy')
   end subroutine declare

   !> Set `error` unless the file is one in Python or Tcl.
   pure subroutine check(self, error)
      !> The output
      class(opensees_output), intent(in) :: self
      !> Set otherwise
      type(error_type), allocatable, intent(inout) :: error

      if (.not. self%is_asked() .or. self%path == '-') return
      if (ends_with(self%path, '.py') .or. ends_with(self%path, '.tcl')) return
      call fatal_error(error, self%path//' is neither .py nor .tcl: end its name with one of '// &
         'them', subject='opensees')
   end subroutine check

   !> Whether it is asked for.
   pure logical function is_asked(self)
      !> The output
      class(opensees_output), intent(in) :: self

      is_asked = .false.
      if (allocated(self%path)) is_asked = self%path /= ''
   end function is_asked

   !> Set `error` if it is asked for of several records.
   pure subroutine refuse(self, error)
      !> The output
      class(opensees_output), intent(in) :: self
      !> Set if so
      type(error_type), allocatable, intent(inout) :: error

      if (self%is_asked()) call fatal_error(error, '--opensees: a material follows one record, '// &
         'and there are several: give one file, and choose a test by --where')
   end subroutine refuse

   pure logical function ends_with(text, ending)
      character(len=*), intent(in) :: text, ending

      ends_with = .false.
      if (len(text) > len(ending)) ends_with = text(len(text) - len(ending) + 1:) == ending
   end function ends_with

   !> Fit, and add tables and the file to a report.
   subroutine add_to(self, report, displacement, force, result, labels, source, error)
      !> The output
      class(opensees_output), intent(inout) :: self
      !> The report, with its other tables
      type(report_type), intent(inout) :: report
      !> The record, outliers left out
      real(wp), intent(in) :: displacement(:), force(:)
      !> What was found in it
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      !> Where it comes from, in words
      character(len=*), intent(in) :: source
      !> Set when no material follows it
      type(error_type), allocatable, intent(out) :: error
      type(frame_history) :: history
      type(frame_comparison) :: comparisons(size(names))
      type(frame_command), allocatable :: commands(:), chosen(:)
      class(frame_material), allocatable :: material
      logical :: tried(size(names))
      real(wp) :: errors(size(names))
      integer :: steps(size(names)), i, best

      call new_frame_history(history, displacement, force, result, error)
      if (allocated(error)) return
      tried = names == self%material
      if (self%material == 'best') tried = names /= 'elastic_gap'
      best = 0
      steps = 0
      errors = huge(1.0_wp)
      do i = 1, size(names)
         if (.not. tried(i)) cycle
         if (allocated(material)) deallocate (material)
         select case (names(i))
         case ('dowel_type')
            allocate (dowel_type_material :: material)
         case ('pinching4')
            allocate (pinching4_material :: material)
         case default
            allocate (elastic_gap_material :: material)
         end select
         call fit_material(material, history, errors(i), error)
         if (.not. allocated(error)) &
            call compare_material(comparisons(i), material, history, error)
         if (allocated(error)) then
            if (count(tried) == 1) return
            tried(i) = .false.
            errors(i) = huge(1.0_wp)
            deallocate (error)
            cycle
         end if
         steps(i) = least_steps(comparisons(i), material, history)
         call material%commands(commands)
         if (best > 0) then
            if (errors(i) >= errors(best)) cycle
         end if
         best = i
         call move_alloc(commands, chosen)
      end do
      if (best == 0) then
         call fatal_error(error, 'no material of OpenSees follows the record', subject='opensees')
         return
      end if
      self%chosen = comparisons(best)
      self%chosen_name = names(best)
      report%more = [report%more, named_table('opensees', 'Materials of OpenSees', &
         materials_table(pack(names, tried), pack(comparisons, tried), pack(steps, tried), &
         names(best)))]
      report%more = [report%more, named_table('opensees_cycles', trim(names(best))// &
         ' beside the record', cycles_table(history, comparisons(best), labels))]
      call remark_goal(report, names(best), comparisons(best))
      call add_deck(report, material_script(ends_with(self%path, '.tcl'), chosen, history, &
         comparisons(best), steps(best), labels, source))
   end subroutine add_to

   !> Say so where the material is not as near as one may hope for.
   pure subroutine remark_goal(report, name, comparison)
      type(report_type), intent(inout) :: report
      character(len=*), intent(in) :: name
      type(frame_comparison), intent(in) :: comparison

      if (comparison%largest_energy_error <= near_energy &
         .and. comparison%largest_peak_error <= near_peaks) return
      call report%add_remark(trim(name)//' misses the energy of a cycle by up to '// &
         to_text(100.0_wp*comparison%largest_energy_error, 3)//' % and a peak by up to '// &
         to_text(100.0_wp*comparison%largest_peak_error, 3)//' %: the best that was found, '// &
         'but not within '//to_text(nint(100.0_wp*near_energy))//' and '// &
         to_text(nint(100.0_wp*near_peaks))//' %.')
   end subroutine remark_goal

   !> The file among the report's.
   pure subroutine add_deck(report, text)
      type(report_type), intent(inout) :: report
      character(len=*), intent(in) :: text
      type(deck_type), allocatable :: decks(:)
      integer :: n

      n = 0
      if (allocated(report%decks)) n = size(report%decks)
      allocate (decks(n + 1))
      if (n > 0) decks(:n) = report%decks
      decks(n + 1)%option = 'opensees'
      decks(n + 1)%text = text
      call move_alloc(decks, report%decks)
   end subroutine add_deck

   !> How well each material that was tried follows the record.
   pure function materials_table(tried, comparisons, steps, chosen) result(table)
      character(len=*), intent(in) :: tried(:), chosen
      type(frame_comparison), intent(in) :: comparisons(:)
      integer, intent(in) :: steps(:)
      type(table_type) :: table
      integer :: i

      table = new_table(columns=6, rows=size(tried))
      call table%add_texts('material', tried)
      call table%add_texts('written', [(merge('yes', 'no ', tried(i) == chosen), &
         i=1, size(tried))])
      call table%add_numbers('energy_error', '%', 100.0_wp*comparisons%largest_energy_error, 1)
      call table%add_numbers('peak_error', '%', 100.0_wp*comparisons%largest_peak_error, 1)
      call table%add_numbers('force_error', '%', 100.0_wp*comparisons%force_error, 1)
      call table%add_codes('least_steps', column_counts, steps)
   end function materials_table

   !> Energy and peaks of each cycle, of record and material.
   pure function cycles_table(history, comparison, labels) result(table)
      type(frame_history), intent(in) :: history
      type(frame_comparison), intent(in) :: comparison
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      character(len=:), allocatable :: energy
      integer :: i, side
      character(len=*), parameter :: sides(2) = [character(len=9) :: 'positive_', 'negative_']

      energy = labels%energy_unit()
      table = new_table(columns=10, rows=size(history%energy))
      call table%add_codes('cycle', column_counts, [(i, i=1, size(history%energy))])
      call table%add_numbers('record_energy', energy, (history%energy))
      call table%add_numbers('material_energy', energy, (comparison%energy))
      call table%add_numbers('energy_error', '%', percent(comparison%energy_error), 1)
      do side = 1, 2
         call table%add_numbers(sides(side)//'record', labels%f_unit, history%peak_force(side, :))
         call table%add_numbers(sides(side)//'material', labels%f_unit, comparison%peak(side, :))
         call table%add_numbers(sides(side)//'error', '%', &
            percent(comparison%peak_error(side, :)), 1)
      end do
   end function cycles_table

   !> A share in percent, which may be none.
   pure elemental real(wp) function percent(share)
      real(wp), intent(in) :: share

      percent = share
      if (.not. is_none(share)) percent = 100.0_wp*share
   end function percent

   !> Draw the material over the loops.
   pure subroutine draw(self, panel)
      !> The output, which is asked for
      class(opensees_output), intent(in) :: self
      !> Panel of the loops
      type(panel_type), intent(inout) :: panel

      call panel%add(self%chosen%displacement, self%chosen%force, trim(self%chosen_name), blue)
   end subroutine draw

end module asperity_program_commands_opensees_output
