!> Tables of what the standards make of a record.
module asperity_program_commands_hysteresis_standard_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_skeleton
   use asperity_hysteresis_en_12512, only: ductility_class
   use asperity_program_commands_hysteresis_tables, only: get_skeletons, &
      number_of_skeletons, ratio_decimals, record_labels, shown, side_names
   use asperity_program_report_report, only: named_table
   use asperity_program_report_table, only: column_counts, new_table, table_type
   implicit none
   private
   public :: en_12512, en_26891, standard_tables

   !> Names of the tables in JSON
   character(len=*), parameter :: en_12512 = 'en_12512', en_26891 = 'en_26891'
   !> First, second and third cycle
   character(len=*), parameter :: ordinals(3) = [character(len=6) :: 'first', 'second', 'third']

contains

   !> All of them. Those that the record has nothing for have no title, so that the terminal does
   !> not show them.
   pure subroutine standard_tables(result, labels, tables)
      !> What was found
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      !> The tables
      type(named_table), allocatable, intent(out) :: tables(:)
      integer :: i

      allocate (tables(3))
      do i = 1, size(tables)
         tables(i)%title = ''
      end do
      tables(1)%name = en_12512
      tables(1)%table = en_12512_table(result, labels)
      if (tables(1)%table%rows > 0) &
         tables(1)%title = 'Yield and ultimate point by EN 12512, '//limit_words(labels, '30')
      tables(2)%name = 'amplitudes'
      tables(2)%table = amplitude_table(result, labels)
      if (any(result%amplitudes%cycles > 1)) tables(2)%title = 'Strength of first, second and '// &
         'third cycles, and its impairment from the first to the third (EN 12512)'
      tables(3)%name = en_26891
      tables(3)%table = en_26891_table(result, labels)
      if (tables(3)%table%rows > 0) &
         tables(3)%title = 'Slips and slip moduli by EN 26891, '//limit_words(labels, '15')
   end subroutine standard_tables

   !> Whether a limit of displacement is applied.
   pure function limit_words(labels, limit) result(words)
      type(record_labels), intent(in) :: labels
      character(len=*), intent(in) :: limit
      character(len=:), allocatable :: words

      if (.not. is_none(labels%millimetre)) then
         words = 'up to '//limit//' mm'
      else if (labels%x == 'rotation') then
         words = 'without its limit of '//limit//' mm, as rotations have none'
      else
         words = 'without its limit of '//limit//' mm, as no unit of displacement is known '// &
            '(--displacement-unit)'
      end if
   end function limit_words

   !> One row a side with force in its own direction, and one of the mean.
   pure function en_12512_table(result, labels) result(table)
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      type(hysteresis_skeleton) :: s(number_of_skeletons(result))
      integer, allocatable :: sides(:)
      integer :: i

      call get_skeletons(result, s)
      sides = pack([(i, i=1, size(s))], .not. is_none(s%en_12512%peak_force))
      table = new_table(columns=14, rows=size(sides))
      associate (e => s(sides)%en_12512)
         call table%add_texts('side', side_names(sides))
         call table%add_texts('yield_method', known(e%yield_method))
         call table%add_numbers('two_lines_'//labels%x, labels%x_unit, &
            shown((e%two_lines_displacement)))
         call table%add_numbers('two_lines_'//labels%f, labels%f_unit, shown((e%two_lines_force)))
         call table%add_numbers('tangent_'//labels%x, labels%x_unit, &
            shown((e%tangent_displacement)))
         call table%add_numbers('tangent_'//labels%f, labels%f_unit, shown((e%tangent_force)))
         call table%add_numbers('peak_'//labels%x, labels%x_unit, shown((e%peak_displacement)))
         call table%add_numbers('peak_'//labels%f, labels%f_unit, shown((e%peak_force)))
         call table%add_numbers('ultimate_'//labels%x, labels%x_unit, &
            shown((e%ultimate_displacement)))
         call table%add_numbers('ultimate_'//labels%f, labels%f_unit, shown((e%ultimate_force)))
         call table%add_texts('ultimate_reason', known(e%ultimate_reason))
         call table%add_numbers('ductility', '-', shown((e%ductility)))
         call table%add_texts('ductility_class', known(ductility_classes(e%ductility)))
         call table%add_numbers('three_cycle_ductility', '-', shown((e%three_cycle_ductility)))
      end associate
   end function en_12512_table

   !> Classes of several ductilities.
   pure function ductility_classes(ductility) result(classes)
      real(wp), intent(in) :: ductility(:)
      character(len=6) :: classes(size(ductility))
      integer :: i

      do i = 1, size(ductility)
         classes(i) = ductility_class(ductility(i))
      end do
   end function ductility_classes

   !> One row an amplitude and side.
   pure function amplitude_table(result, labels) result(table)
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      integer :: i

      associate (a => result%amplitudes)
         table = new_table(columns=10, rows=size(a), leading=2)
         call table%add_texts('side', side_names(a%side))
         call table%add_codes('first_cycle', column_counts, a%cycle(1))
         call table%add_codes('cycles', column_counts, (a%cycles))
         do i = 1, size(ordinals)
            call table%add_numbers(trim(ordinals(i))//'_'//labels%x, labels%x_unit, &
               shown((a%displacement(i))))
            call table%add_numbers(trim(ordinals(i))//'_'//labels%f, labels%f_unit, &
               shown((a%force(i))))
         end do
         call table%add_numbers('impairment', '-', shown((a%impairment)), ratio_decimals)
      end associate
   end function amplitude_table

   !> One row of a monotonic test, else none.
   pure function en_26891_table(result, labels) result(table)
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      integer :: rows

      associate (e => result%en_26891)
         rows = merge(0, 1, is_none(e%peak_force))
         table = new_table(columns=16, rows=rows)
         call table%add_texts('side', pack([merge(side_names(1), side_names(2), &
            e%peak_force > 0.0_wp)], rows > 0))
         call add(table, rows, 'estimated_'//labels%f, labels%f_unit, e%estimated_force)
         call table%add_texts('estimated_by', pack([e%estimated_by], rows > 0))
         call add(table, rows, 'peak_'//labels%x, labels%x_unit, e%peak_displacement)
         call add(table, rows, 'peak_'//labels%f, labels%f_unit, e%peak_force)
         call add(table, rows, 'slip_at_10_percent', labels%x_unit, e%slip_at_10_percent)
         call add(table, rows, 'initial_slip', labels%x_unit, e%initial_slip)
         call add(table, rows, 'modified_initial_slip', labels%x_unit, e%modified_initial_slip)
         call add(table, rows, 'joint_settlement', labels%x_unit, e%joint_settlement)
         call add(table, rows, 'elastic_slip', labels%x_unit, e%elastic_slip)
         call add(table, rows, 'initial_slip_modulus', labels%stiffness_unit(), &
            e%initial_slip_modulus)
         call add(table, rows, 'slip_modulus', labels%stiffness_unit(), e%slip_modulus)
         call add(table, rows, 'slip_at_60_percent', labels%x_unit, e%slip_at_60_percent)
         call add(table, rows, 'modified_slip_at_60_percent', labels%x_unit, &
            e%modified_slip_at_60_percent)
         call add(table, rows, 'slip_at_80_percent', labels%x_unit, e%slip_at_80_percent)
         call add(table, rows, 'modified_slip_at_80_percent', labels%x_unit, &
            e%modified_slip_at_80_percent)
      end associate
   end function en_26891_table

   !> Append a column of one row, or of none.
   pure subroutine add(table, rows, name, unit, value)
      type(table_type), intent(inout) :: table
      integer, intent(in) :: rows
      character(len=*), intent(in) :: name, unit
      real(wp), intent(in) :: value

      call table%add_numbers(name, unit, pack([shown(value)], rows > 0))
   end subroutine add

   !> A text, `-` for none.
   pure elemental character(len=24) function known(text)
      character(len=*), intent(in) :: text

      known = text
      if (text == '') known = '-'
   end function known

end module asperity_program_commands_hysteresis_standard_tables
