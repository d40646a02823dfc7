!> What is to be said of a record and of its analysis.
module asperity_program_commands_hysteresis_remarks
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: en_26891_numbers, hysteresis_result, &
      hysteresis_settings, hysteresis_skeleton, negative_side, positive_side
   use asperity_hysteresis_en_12512, only: ductility_class
   use asperity_program_commands_hysteresis_tables, only: record_labels, side_names
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: record_remarks, excess_words

   !> Share by which the record may hold more than the skeleton, and by which a ratio may leave its
   !> range, as noise does
   real(wp), parameter :: allowance = 0.02_wp
   !> Share by which the largest force may differ from its estimate (EN 26891)
   real(wp), parameter :: estimate_allowance = 0.2_wp
   !> Damping of a rectangle
   real(wp), parameter :: largest_damping = 2.0_wp/pi
   !> Cycles, samples and gaps that are named; of more, the number is said
   integer, parameter :: most_cycles = 12, most_named = 3
   !> Figures of numbers
   integer, parameter :: figures = 5

   !> Remarks, in the order of the analysis.
   type :: remark_list
      type(string_type), allocatable :: lines(:)
   contains
      procedure :: add
   end type remark_list

contains

   !> All remarks.
   pure function record_remarks(settings, result, labels) result(lines)
      !> How it was read
      type(hysteresis_settings), intent(in) :: settings
      !> What was found
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      type(string_type), allocatable :: lines(:)
      type(remark_list) :: list
      integer :: side

      allocate (list%lines(0))
      call add_outliers(list, settings, result, labels)
      call add_gaps(list, result, labels)
      call add_zeros(list, result, labels)
      call add_cycles(list, settings, result)
      do side = positive_side, negative_side
         call add_side(list, side_names(side), settings, result%threshold, &
            result%skeleton(side), labels)
      end do
      call add_estimate(list, result%en_26891, labels)
      call move_alloc(list%lines, lines)
   end function record_remarks

   pure subroutine add(self, text)
      class(remark_list), intent(inout) :: self
      character(len=*), intent(in) :: text

      self%lines = [self%lines, string_type(text)]
   end subroutine add

   !> Samples that leap away and back.
   pure subroutine add_outliers(list, settings, result, labels)
      type(remark_list), intent(inout) :: list
      type(hysteresis_settings), intent(in) :: settings
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      character(len=:), allocatable :: text
      integer :: i, n

      n = size(result%outliers)
      if (n == 0) return
      text = ''
      do i = 1, min(n, most_named)
         associate (outlier => result%outliers(i))
            if (outlier%quantity == 'force') then
               text = text//labels%f//' '//shown(outlier%value, labels%f_unit)
            else
               text = text//labels%x//' '//shown(outlier%value, labels%x_unit)
            end if
            text = text//' in sample '//to_text(outlier%sample)//', '
         end associate
      end do
      if (n > most_named) text = text//'and more, '
      text = 'Outliers, '//to_text(n)//': '//text//'far off the samples beside '// &
         trim(merge('it  ', 'them', n == 1))//': '
      if (settings%outliers == 'drop') then
         call list%add(text//'left out (--outliers keep takes them in).')
      else
         call list%add(text//'taken as measured; --outliers drop leaves them out.')
      end if
   end subroutine add_outliers

   !> Steps that hide what happened.
   pure subroutine add_gaps(list, result, labels)
      type(remark_list), intent(inout) :: list
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      character(len=:), allocatable :: text
      integer :: i, n

      n = size(result%gaps)
      if (n == 0) return
      text = ''
      do i = 1, min(n, most_named)
         text = text//shown(result%gaps(i)%step, labels%x_unit)//' after sample '// &
            to_text(result%gaps(i)%sample)//', '
      end do
      if (n > most_named) text = text//'and more, '
      call list%add('Gaps in sampling, '//to_text(n)//': a step of '//text//'far above the '// &
         'steps beside: energy, damping and shape of that cycle are of a straight line there.')
   end subroutine add_gaps

   !> A zero that may be none.
   pure subroutine add_zeros(list, result, labels)
      type(remark_list), intent(inout) :: list
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels

      if (.not. is_none(result%unloaded_displacement)) call list%add('The record begins at '// &
         shown(result%unloaded_displacement, labels%x_unit)//' without '//labels%f//': zero of '// &
         labels%x//' looks wrong, and stiffness, ductility and cycles with it; '// &
         '--displacement-zero sets it (the reading at rest, before the factor).')
      if (.not. is_none(result%loaded_force)) call list%add('The record begins with '//labels%f// &
         ' '//shown(result%loaded_force, labels%f_unit)//' at zero '//labels%x// &
         ': unless that is so, --force-zero sets its zero.')
   end subroutine add_zeros

   !> Cycles that are not closed, and numbers outside what a loop between its peaks can have.
   pure subroutine add_cycles(list, settings, result)
      type(remark_list), intent(inout) :: list
      type(hysteresis_settings), intent(in) :: settings
      type(hysteresis_result), intent(in) :: result
      character(len=:), allocatable :: cure

      cure = ''
      if (settings%peaks /= 'force') cure = &
         '; the largest force is not at the tip, perhaps (--peaks force)'
      associate (c => result%cycles)
         ! a monotonic record is expected to be open
         if (result%record_kind(:9) /= 'monotonic') call add_list(list, &
            'Not closed, so energy is the work done and there is no damping: ', .not. c%closed, '')
         call add_list(list, 'Closed, but giving energy back, so there is no damping: ', &
            c%closed .and. c%loop_area < 0.0_wp .and. is_none(c%fullness), '')
         call add_list(list, 'Fullness above 1, a loop outside the rectangle of its peaks: ', &
            is_outside(c%fullness, 1.0_wp), cure)
         call add_list(list, 'Damping above 2/pi, that of a rectangle: ', &
            is_outside(c%damping, largest_damping), cure)
         call add_list(list, 'Pinching outside 0 to 1, wider at zero than between the peaks: ', &
            is_outside(c%pinching, 1.0_wp), cure)
      end associate
   end subroutine add_cycles

   !> Whether a number is known and beyond its range by more than noise.
   pure elemental logical function is_outside(value, largest)
      real(wp), intent(in) :: value, largest

      is_outside = .not. is_none(value) .and. &
         (value < -allowance*largest .or. value > (1.0_wp + allowance)*largest)
   end function is_outside

   !> The cycles of which something is true.
   pure subroutine add_list(list, text, is_true, more)
      type(remark_list), intent(inout) :: list
      character(len=*), intent(in) :: text, more
      logical, intent(in) :: is_true(:)
      character(len=:), allocatable :: names
      integer :: i

      if (.not. any(is_true)) return
      if (count(is_true) > most_cycles) then
         names = to_text(count(is_true))//' cycles'
      else
         names = 'cycle'
         do i = 1, size(is_true)
            if (is_true(i)) names = names//' '//to_text(i)
         end do
      end if
      call list%add(text//names//more)
   end subroutine add_list

   !> One side.
   pure subroutine add_side(list, name, settings, threshold, skeleton, labels)
      type(remark_list), intent(inout) :: list
      character(len=*), intent(in) :: name
      type(hysteresis_settings), intent(in) :: settings
      real(wp), intent(in) :: threshold
      type(hysteresis_skeleton), intent(in) :: skeleton
      type(record_labels), intent(in) :: labels
      character(len=:), allocatable :: text

      if (size(skeleton%force) == 0) return
      if (size(skeleton%force) == 1) call list%add('The '//name//' skeleton is a straight '// &
         'line, having one amplitude: its stiffness and yield point say little.')
      if (is_none(skeleton%peak_force)) then
         call list%add('The '//name//' skeleton has no force in its own direction: nothing is '// &
            'formed from it.')
         return
      end if
      text = excess_words(skeleton, labels%f_unit)
      if (text /= '') then
         text = 'The record has '//text//' (sample '//to_text(skeleton%record_sample)//', '// &
            shown(skeleton%record_displacement, labels%x_unit)//') than the '//name//' skeleton'
         if (settings%peaks == 'envelope') then
            call list%add(text//', in a later or an inner cycle.')
         else
            call list%add(text//': --peaks envelope takes it in.')
         end if
      end if
      if (abs(skeleton%left_force) > 0.0_wp) call list%add('The '//name//' side begins with '// &
         shown(skeleton%left_force, labels%f_unit)//' at zero '//labels%x//', left by the '// &
         'other side: a straight line goes to its first tip, whose stiffness says little.')
      if (is_none(skeleton%elastic_stiffness)) then
         call list%add('The '//name//' side has '//shown(skeleton%force(1), labels%f_unit)// &
            ' at its first sample beyond zero, which is past the point of the elastic '// &
            'stiffness: the record gives it no stiffness and no yield point.')
      else if (settings%elastic_fraction*abs(skeleton%peak_force) &
         <= skeleton%elastic_stiffness*threshold) then
         call list%add('The elastic stiffness of the '//name//' side comes from within the '// &
            'threshold of '//shown(threshold, labels%x_unit)//', where noise may make it.')
      end if
      associate (n => skeleton%en_12512)
         if (ductility_class(n%three_cycle_ductility) /= ductility_class(n%ductility) .and. &
            .not. is_none(n%three_cycle_ductility)) call list%add('Three cycles on the '//name// &
            ' side hold 0.8 of the force of the first up to a ductility of '// &
            to_text(n%three_cycle_ductility, 3)//', class '// &
            trim(ductility_class(n%three_cycle_ductility))//', not '// &
            trim(ductility_class(n%ductility))//' (EN 12512, EN 1998-1).')
      end associate
      if (skeleton%yield_assumed) call list%add('The '//name//' skeleton is too hollow for a '// &
         'yield point of equal energy: 0.85 of the peak is taken (ASTM E2126).')
      if (skeleton%ductility < 1.0_wp - allowance) call list%add('The '//name//' ductility is '// &
         'below 1: the yield point lies beyond the ultimate point, so zero of '//labels%x// &
         ' or of '//labels%f//', or the record, is not what it seems.')
   end subroutine add_side

   !> An estimate of EN 26891 that is far off.
   pure subroutine add_estimate(list, numbers, labels)
      type(remark_list), intent(inout) :: list
      type(en_26891_numbers), intent(in) :: numbers
      type(record_labels), intent(in) :: labels

      if (is_none(numbers%peak_force)) return
      if (abs(numbers%peak_force/numbers%estimated_force - 1.0_wp) <= estimate_allowance) return
      call list%add('EN 26891: the largest '//labels%f//', '//shown(numbers%peak_force, &
         labels%f_unit)//', is more than 20 % off the estimate of '// &
         shown(numbers%estimated_force, labels%f_unit)//', which then counts for further tests '// &
         'only if it is adjusted.')
   end subroutine add_estimate

   !> How much more force the record has than its skeleton; empty if it is no more than 2 %.
   pure function excess_words(skeleton, unit) result(text)
      !> The skeleton of one side
      type(hysteresis_skeleton), intent(in) :: skeleton
      !> Unit of its force
      character(len=*), intent(in) :: unit
      character(len=:), allocatable :: text
      real(wp) :: more

      text = ''
      if (is_none(skeleton%peak_force)) return
      more = abs(skeleton%record_force)/abs(skeleton%peak_force) - 1.0_wp
      if (more > allowance) text = shown(skeleton%record_force, unit)//', '// &
         to_text(100.0_wp*more, 2)//' % more'
   end function excess_words

   !> A number with its unit.
   pure function shown(value, unit) result(text)
      real(wp), intent(in) :: value
      character(len=*), intent(in) :: unit
      character(len=:), allocatable :: text

      text = to_text(value, figures)//' '//unit
   end function shown

end module asperity_program_commands_hysteresis_remarks
