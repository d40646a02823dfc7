!> Tables of what a record says: cycles, sides, skeleton.
module asperity_program_commands_hysteresis_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: hysteresis_cycle, hysteresis_result, &
      hysteresis_skeleton, negative_side, positive_side
   use asperity_program_report_table, only: column_counts, new_table, table_type
   implicit none
   private
   public :: record_labels, cycle_table, get_skeletons, number_of_skeletons, shown, side_table, &
      skeleton_table

   !> What the record holds.
   type :: record_labels
      !> Name of displacement and its unit
      character(len=:), allocatable :: x, x_unit
      !> A millimetre in that unit, `none` where no unit is known or it is no length
      real(wp) :: millimetre = none
      !> Name of force and its unit
      character(len=:), allocatable :: f, f_unit
      !> Title of pictures
      character(len=:), allocatable :: title
   contains
      !> Unit of force over displacement
      procedure :: stiffness_unit
      !> Unit of force times displacement
      procedure :: energy_unit
   end type record_labels

   !> Decimals of damping and ratios
   integer, parameter, public :: ratio_decimals = 4
   !> The two sides, and the mean of both, in tables and remarks
   character(len=*), parameter, public :: side_names(3) = &
      [character(len=8) :: 'positive', 'negative', 'mean']

contains

   !> Unit of force over displacement.
   pure function stiffness_unit(self) result(unit)
      !> The labels
      class(record_labels), intent(in) :: self
      character(len=:), allocatable :: unit

      unit = self%f_unit//'/'//self%x_unit
   end function stiffness_unit

   !> Unit of force times displacement; a moment times an angle in rad is in the moment's unit.
   pure function energy_unit(self) result(unit)
      !> The labels
      class(record_labels), intent(in) :: self
      character(len=:), allocatable :: unit

      unit = self%f_unit
      if (self%x_unit /= 'rad') unit = unit//' '//self%x_unit
   end function energy_unit

   !> One row per cycle.
   pure function cycle_table(result, labels) result(table)
      !> What was found
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      character(len=:), allocatable :: energy
      integer :: i, side

      table = new_table(columns=22, rows=size(result%cycles))
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      energy = labels%energy_unit()
      associate (c => result%cycles)
         call table%add_codes('cycle', column_counts, [(i, i=1, size(c))])
         call table%add_texts('closed', yes_or_no((c%closed)))
         do side = positive_side, negative_side
            call table%add_numbers(side_names(side)//'_'//labels%x, labels%x_unit, &
               shown((c%displacement(side))))
            call table%add_numbers(side_names(side)//'_'//labels%f, labels%f_unit, &
               shown((c%force(side))))
         end do
         call table%add_texts('skeleton', skeleton_texts(c))
         call table%add_numbers('secant_stiffness', labels%stiffness_unit(), &
            shown((c%secant_stiffness)))
         call table%add_numbers('mean_secant_stiffness', labels%stiffness_unit(), &
            shown((c%mean_secant_stiffness)))
         call table%add_numbers('stiffness_ratio', '-', shown((c%stiffness_ratio)), ratio_decimals)
         call table%add_numbers('energy', energy, (c%energy))
         call table%add_numbers('cumulative_energy', energy, (c%cumulative_energy))
         call table%add_numbers('loop_area', energy, shown((c%loop_area)))
         call table%add_numbers('damping', '-', shown((c%damping)), ratio_decimals)
         do side = positive_side, negative_side
            call table%add_numbers(side_names(side)//'_energy', energy, &
               shown((c%half_energy(side))))
            call table%add_numbers(side_names(side)//'_damping', '-', &
               shown((c%half_damping(side))), ratio_decimals)
         end do
         call table%add_numbers('pinching', '-', shown((c%pinching)), ratio_decimals)
         call table%add_numbers('fullness', '-', shown((c%fullness)), ratio_decimals)
         call table%add_codes('first_sample', column_counts, (c%first))
         call table%add_codes('last_sample', column_counts, (c%last))
      end associate
   end function cycle_table

   !> Which of the two peaks of each cycle are points of the skeleton.
   pure function skeleton_texts(cycles) result(texts)
      type(hysteresis_cycle), intent(in) :: cycles(:)
      character(len=8) :: texts(size(cycles))
      integer :: i

      do i = 1, size(cycles)
         associate (in => cycles(i)%in_skeleton)
            texts(i) = 'none'
            if (in(positive_side)) texts(i) = side_names(positive_side)
            if (in(negative_side)) texts(i) = side_names(negative_side)
            if (all(in)) texts(i) = 'both'
         end associate
      end do
   end function skeleton_texts

   !> How many skeletons a record has: those of both sides, and their mean if there is one.
   pure integer function number_of_skeletons(result)
      !> What was found
      type(hysteresis_result), intent(in) :: result

      number_of_skeletons = merge(3, 2, size(result%mean_skeleton%force) > 0)
   end function number_of_skeletons

   !> All skeletons.
   pure subroutine get_skeletons(result, skeletons)
      !> What was found
      type(hysteresis_result), intent(in) :: result
      !> Two or three
      type(hysteresis_skeleton), intent(out) :: skeletons(:)

      ! no constructor: gfortran 12 frees its components twice
      skeletons(positive_side) = result%skeleton(positive_side)
      skeletons(negative_side) = result%skeleton(negative_side)
      if (size(skeletons) == 3) skeletons(3) = result%mean_skeleton
   end subroutine get_skeletons

   !> One row per side, and one of the mean: stiffness, yield, peak and ultimate point.
   pure function side_table(result, labels) result(table)
      !> What was found
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      type(hysteresis_skeleton) :: s(number_of_skeletons(result))

      call get_skeletons(result, s)
      table = new_table(columns=11, rows=size(s))
      call table%add_texts('side', side_names(:size(s)))
      call table%add_numbers('initial_stiffness', labels%stiffness_unit(), &
         shown((s%initial_stiffness)))
      call table%add_numbers('elastic_stiffness', labels%stiffness_unit(), &
         shown((s%elastic_stiffness)))
      call table%add_numbers('yield_'//labels%x, labels%x_unit, shown((s%yield_displacement)))
      call table%add_numbers('yield_'//labels%f, labels%f_unit, shown((s%yield_force)))
      call table%add_numbers('peak_'//labels%x, labels%x_unit, shown((s%peak_displacement)))
      call table%add_numbers('peak_'//labels%f, labels%f_unit, shown((s%peak_force)))
      call table%add_numbers('ultimate_'//labels%x, labels%x_unit, &
         shown((s%ultimate_displacement)))
      call table%add_numbers('ultimate_'//labels%f, labels%f_unit, shown((s%ultimate_force)))
      call table%add_texts('failed', yes_or_no((s%ultimate_reached)))
      call table%add_numbers('ductility', '-', shown((s%ductility)))
   end function side_table

   !> The points of all skeletons, each from the inside to the outside.
   pure function skeleton_table(result, labels) result(table)
      !> What was found
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      type(table_type) :: table
      integer :: i

      associate (p => result%skeleton(positive_side), n => result%skeleton(negative_side), &
            m => result%mean_skeleton)
         table = new_table(columns=4, rows=size(p%force) + size(n%force) + size(m%force))
         call table%add_texts('side', [character(len=8) :: &
            (side_names(positive_side), i=1, size(p%force)), &
            (side_names(negative_side), i=1, size(n%force)), &
            (side_names(3), i=1, size(m%force))])
         call table%add_codes('cycle', column_counts, [p%cycle, n%cycle, m%cycle])
         call table%add_numbers(labels%x, labels%x_unit, &
            [p%displacement, n%displacement, m%displacement])
         call table%add_numbers(labels%f, labels%f_unit, [p%force, n%force, m%force])
      end associate
   end function skeleton_table

   !> What is not known has no value.
   pure elemental real(wp) function shown(value)
      !> A number
      real(wp), intent(in) :: value

      shown = value
      if (is_none(value)) shown = none
   end function shown

   pure elemental character(len=3) function yes_or_no(condition)
      logical, intent(in) :: condition

      yes_or_no = merge('yes', 'no ', condition)
   end function yes_or_no

end module asperity_program_commands_hysteresis_tables
