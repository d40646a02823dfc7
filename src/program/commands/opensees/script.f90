!> The file that OpenSees reads, in Python (openseespy) or Tcl: the material as a function, and a
!> replay of the record's turns.
module asperity_program_commands_opensees_script
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_frame_comparison, only: frame_comparison
   use asperity_frame_history, only: frame_history
   use asperity_frame_material, only: frame_command
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_system_strings, only: newline
   implicit none
   private
   public :: material_script

   !> Figures of numbers in comments
   integer, parameter :: figures = 5
   !> Length of a line of numbers
   integer, parameter :: line_length = 96

contains

   !> The text of the file.
   pure function material_script(is_tcl, commands, history, comparison, steps, labels, source) &
      result(text)
      !> Tcl, else Python
      logical, intent(in) :: is_tcl
      !> The materials, which act in parallel
      type(frame_command), intent(in) :: commands(:)
      !> The record
      type(frame_history), intent(in) :: history
      !> The material beside it
      type(frame_comparison), intent(in) :: comparison
      !> Least steps of a half cycle
      integer, intent(in) :: steps
      !> Names and units
      type(record_labels), intent(in) :: labels
      !> Where the record comes from
      character(len=*), intent(in) :: source
      character(len=:), allocatable :: text
      type(growing_text) :: b

      call add_head(b, commands, history, comparison, steps, labels, source)
      if (is_tcl) then
         call add_tcl(b, commands, history, steps)
      else
         call add_python(b, commands, history, steps)
      end if
      text = b%text()
   end function material_script

   !> What it is, how good it is: comments.
   pure subroutine add_head(b, commands, history, comparison, steps, labels, source)
      type(growing_text), intent(inout) :: b
      type(frame_command), intent(in) :: commands(:)
      type(frame_history), intent(in) :: history
      type(frame_comparison), intent(in) :: comparison
      integer, intent(in) :: steps
      type(record_labels), intent(in) :: labels
      character(len=*), intent(in) :: source
      integer :: i

      call b%line('# '//words(commands)//' for OpenSees, fitted by asperity '//version//' to '// &
         source)
      call b%line('# Units: '//labels%x//' in '//labels%x_unit//', '//labels%f//' in '// &
         labels%f_unit//', energy in '//labels%energy_unit())
      call b%line('# Half a cycle takes at least '//to_text(steps)//' steps: fewer miss the '// &
         'energy of a cycle by more than 1 %.')
      call b%line('# Beyond the record, '//to_text(minval(history%ends), figures)//' to '// &
         to_text(maxval(history%ends), figures)//' '//labels%x_unit//', it is a guess.')
      call b%line('#')
      call b%line('# Record and material: energy of each cycle, '//labels%f//' at its peaks')
      call b%line('# cycle      record    material      %      record    material      %      '// &
         'record    material      %')
      do i = 1, size(history%energy)
         call b%line('#'//cell(to_text(i), 6)// &
            triple(history%energy(i), comparison%energy(i), comparison%energy_error(i))// &
            triple(history%peak_force(1, i), comparison%peak(1, i), comparison%peak_error(1, i))// &
            triple(history%peak_force(2, i), comparison%peak(2, i), comparison%peak_error(2, i)))
      end do
      call b%line('')
   end subroutine add_head

   !> The materials in words.
   pure function words(commands) result(text)
      type(frame_command), intent(in) :: commands(:)
      character(len=:), allocatable :: text
      integer :: i

      text = trim(commands(1)%name)
      do i = 2, size(commands)
         text = text//' beside '//trim(commands(i)%name)
      end do
   end function words

   !> Record, material and the difference in percent.
   pure function triple(record, material, error) result(text)
      real(wp), intent(in) :: record, material, error
      character(len=:), allocatable :: text

      text = cell(number(record), 12)//cell(number(material), 12)
      if (is_none(error)) then
         text = text//cell('-', 7)
      else
         text = text//cell(to_text(real(nint(1000.0_wp*error), wp)/10.0_wp), 7)
      end if
   end function triple

   pure function number(value) result(text)
      real(wp), intent(in) :: value
      character(len=:), allocatable :: text

      text = '-'
      if (.not. is_none(value)) text = to_text(value, figures)
   end function number

   !> A text at the right of a cell.
   pure function cell(text, width) result(padded)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=:), allocatable :: padded

      padded = repeat(' ', max(1, width - len(text)))//text
   end function cell

   !> Functions in Python.
   pure subroutine add_python(b, commands, history, steps)
      type(growing_text), intent(inout) :: b
      type(frame_command), intent(in) :: commands(:)
      type(frame_history), intent(in) :: history
      integer, intent(in) :: steps
      integer :: i, j

      call b%line('import openseespy.opensees as ops'//newline)
      call b%line('# Ends of half cycles, or of their parts, and the cycle of each')
      call b%line('ENDS = ['//listed(history%ends(1:), ', ')//']')
      call b%line('CYCLES = ['//counted(history%cycle, ', ')//']'//newline//newline)
      call b%line('def joint_material(tag):')
      call b%line('    """Define the material; tags up to tag + '//to_text(size(commands))// &
         ' are used."""')
      do i = 1, size(commands)
         call b%add("    ops.uniaxialMaterial('"//trim(commands(i)%name)//"', tag"// &
            plus(i, commands))
         do j = 1, commands(i)%parts
            if (commands(i)%word(j) /= '') call b%add(", '"//trim(commands(i)%word(j))//"'")
            if (commands(i)%size(j) > 0) call b%add(','//newline//'        '// &
               listed(commands(i)%numbers(:commands(i)%size(j), j), ', ', '        '))
         end do
         call b%line(')')
      end do
      if (size(commands) > 1) call b%line("    ops.uniaxialMaterial('Parallel', tag, tag + 1, "// &
         'tag + 2)')
      call b%line(newline//newline//'def replay(steps='//to_text(steps)//'):')
      call b%line('    """Cycle, displacement and force at every step; so many in each half '// &
         'cycle or part."""')
      call b%line('    ops.wipe()')
      call b%line('    joint_material(1)')
      call b%line('    ops.testUniaxialMaterial(1)')
      call b%line('    rows, begin = [(CYCLES[0], 0.0, 0.0)], 0.0')
      call b%line('    for cycle, end in zip(CYCLES, ENDS):')
      call b%line('        for step in range(1, steps + 1):')
      call b%line('            displacement = begin + (end - begin)*step/steps')
      call b%line('            ops.setStrain(displacement)')
      call b%line('            rows.append((cycle, displacement, ops.getStress()))')
      call b%line('        begin = end')
      call b%line('    return rows'//newline//newline)
      call b%line("if __name__ == '__main__':")
      call b%line("    print('cycle,displacement,force')")
      call b%line('    for row in replay():')
      call b%line("        print('%d,%.12g,%.12g' % row)")
   end subroutine add_python

   !> The tag of one of several materials, which the last one joins.
   pure function plus(i, commands) result(text)
      integer, intent(in) :: i
      type(frame_command), intent(in) :: commands(:)
      character(len=:), allocatable :: text

      text = ''
      if (size(commands) > 1) text = ' + '//to_text(i)
   end function plus

   !> Procedures in Tcl.
   pure subroutine add_tcl(b, commands, history, steps)
      type(growing_text), intent(inout) :: b
      type(frame_command), intent(in) :: commands(:)
      type(frame_history), intent(in) :: history
      integer, intent(in) :: steps
      character(len=*), parameter :: go_on = ' \'//newline//'        '
      integer :: i, j

      call b%line('# Ends of half cycles, or of their parts, and the cycle of each')
      call b%line('set ends {'//listed(history%ends(1:), ' ')//'}')
      call b%line('set cycles {'//counted(history%cycle, ' ')//'}'//newline)
      call b%line('# Define the material; tags up to tag + '//to_text(size(commands))// &
         ' are used')
      call b%line('proc joint_material {tag} {')
      do i = 1, size(commands)
         call b%add('    uniaxialMaterial '//trim(commands(i)%name)//' [expr {$tag'// &
            plus(i, commands)//'}]')
         do j = 1, commands(i)%parts
            if (commands(i)%word(j) /= '') call b%add(' '//trim(commands(i)%word(j)))
            if (commands(i)%size(j) > 0) call b%add(go_on//listed( &
               commands(i)%numbers(:commands(i)%size(j), j), ' ', '        ', ' \'))
         end do
         call b%line('')
      end do
      if (size(commands) > 1) call b%line('    uniaxialMaterial Parallel $tag '// &
         '[expr {$tag + 1}] [expr {$tag + 2}]')
      call b%line('}'//newline)
      call b%line('# Print cycle, displacement and force at every step; so many in each half '// &
         'cycle or part')
      call b%line('proc replay {{steps '//to_text(steps)//'}} {')
      call b%line('    global ends cycles')
      call b%line('    wipe')
      call b%line('    joint_material 1')
      call b%line('    testUniaxialMaterial 1')
      call b%line('    puts "cycle,displacement,force"')
      call b%line('    set begin 0.0')
      call b%line('    puts "[lindex $cycles 0],0.0,0.0"')
      call b%line('    foreach cycle $cycles end $ends {')
      call b%line('        for {set step 1} {$step <= $steps} {incr step} {')
      call b%line('            set displacement [expr {$begin + ($end - $begin)*$step/$steps}]')
      call b%line('            setStrain $displacement')
      call b%line('            puts "$cycle,$displacement,[getStress]"')
      call b%line('        }')
      call b%line('        set begin $end')
      call b%line('    }')
      call b%line('}')
      call b%line('if {[file tail [info script]] eq [file tail $argv0]} { replay }')
   end subroutine add_tcl

   !> Numbers that read back as the same bits, on lines.
   pure function listed(values, separator, indent, go_on) result(text)
      real(wp), intent(in) :: values(:)
      character(len=*), intent(in) :: separator
      character(len=*), intent(in), optional :: indent, go_on
      character(len=:), allocatable :: text, item
      integer :: i, column

      text = ''
      column = 0
      do i = 1, size(values)
         item = to_text(values(i))
         if (i > 1) text = text//trim(separator)
         if (i > 1 .and. column + len(item) > line_length - 16) then
            if (present(go_on)) text = text//go_on
            text = text//newline
            if (present(indent)) then
               text = text//indent
            else
               text = text//'    '
            end if
            column = 0
         else if (i > 1) then
            text = text//' '
         end if
         text = text//item
         column = column + len(item) + 2
      end do
   end function listed

   !> Counts, on lines.
   pure function counted(values, separator) result(text)
      integer, intent(in) :: values(:)
      character(len=*), intent(in) :: separator
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(values)
         if (i > 1) text = text//trim(separator)
         if (modulo(i, 24) == 0) then
            text = text//newline//'    '
         else if (i > 1) then
            text = text//' '
         end if
         text = text//to_text(values(i))
      end do
   end function counted

end module asperity_program_commands_opensees_script
