!> Names of columns as laboratories write them, in English and German: what a column holds.
module asperity_program_record_names
   use asperity_program_system_strings, only: lower_case
   implicit none
   private
   public :: find_meaning, quantity_name

   !> What a column holds
   enum, bind(c)
      !> Not known
      enumerator :: holds_unknown = 0
      enumerator :: holds_displacement
      enumerator :: holds_rotation
      !> Displacement or rotation, as its unit says
      enumerator :: holds_drift
      enumerator :: holds_force
      enumerator :: holds_moment
      enumerator :: holds_pressure
      enumerator :: holds_time
      !> Numbers of steps, cycles, samples and what else changes within a test
      enumerator :: holds_count
      !> Something that no column of a record is chosen for
      enumerator :: holds_other
   end enum
   public :: holds_unknown, holds_displacement, holds_rotation, holds_drift, holds_force, &
      holds_moment, holds_pressure, holds_time, holds_count, holds_other

   !> How sure a name is: the quantity's own name; another one, or its symbol; a part of the heading
   integer, parameter, public :: sure_name = 1, other_name = 2, part_of_name = 3

   !> One word.
   type :: word_type
      character(len=16) :: text
      integer :: holds
      !> `sure_name`, `other_name`, or zero: counts only if it is the whole heading
      integer :: rank
      !> Ends German compounds as well
      logical :: ends = .false.
   end type word_type

   logical, parameter :: ends = .true.

   type(word_type), parameter :: words(*) = [ &
      word_type('displacement', holds_displacement, sure_name, ends), &
      word_type('displ', holds_displacement, sure_name), &
      word_type('disp', holds_displacement, sure_name), &
      word_type('weg', holds_displacement, sure_name, ends), &
      word_type('verschiebung', holds_displacement, sure_name, ends), &
      word_type('slip', holds_displacement, other_name), &
      word_type('stroke', holds_displacement, other_name), &
      word_type('deflection', holds_displacement, other_name), &
      word_type('opening', holds_displacement, other_name), &
      word_type('elongation', holds_displacement, other_name), &
      word_type('deformation', holds_displacement, other_name), &
      word_type('closure', holds_displacement, other_name), &
      word_type('overclosure', holds_displacement, other_name), &
      word_type('approach', holds_displacement, other_name), &
      word_type('lvdt', holds_displacement, other_name), &
      word_type('travel', holds_displacement, other_name), &
      word_type('extension', holds_displacement, other_name), &
      word_type('durchbiegung', holds_displacement, other_name, ends), &
      word_type('verformung', holds_displacement, other_name, ends), &
      word_type('schlupf', holds_displacement, other_name, ends), &
      word_type('u', holds_displacement, 0), word_type('d', holds_displacement, 0), &
      word_type('delta', holds_displacement, 0), &
      word_type('rotation', holds_rotation, sure_name), &
      word_type('rot', holds_rotation, sure_name), &
      word_type('angle', holds_rotation, other_name), &
      word_type('theta', holds_rotation, other_name), &
      word_type('verdrehung', holds_rotation, sure_name, ends), &
      word_type('winkel', holds_rotation, other_name, ends), &
      word_type('drift', holds_drift, sure_name), &
      word_type('force', holds_force, sure_name), word_type('load', holds_force, sure_name), &
      word_type('kraft', holds_force, sure_name, ends), &
      word_type('last', holds_force, other_name, ends), &
      word_type('f', holds_force, 0), word_type('p', holds_force, 0), &
      word_type('moment', holds_moment, sure_name, ends), &
      word_type('torque', holds_moment, other_name), word_type('m', holds_moment, 0), &
      word_type('time', holds_time, sure_name), word_type('zeit', holds_time, sure_name, ends), &
      word_type('elapsed', holds_time, other_name), word_type('t', holds_time, 0), &
      word_type('step', holds_count, sure_name), word_type('increment', holds_count, sure_name), &
      word_type('cycle', holds_count, sure_name), word_type('zyklus', holds_count, sure_name), &
      word_type('schritt', holds_count, sure_name), word_type('stufe', holds_count, sure_name), &
      word_type('sample', holds_count, other_name), word_type('point', holds_count, other_name), &
      word_type('punkt', holds_count, other_name, ends), &
      word_type('row', holds_count, other_name), &
      word_type('line', holds_count, other_name), word_type('index', holds_count, other_name), &
      word_type('number', holds_count, other_name), word_type('nummer', holds_count, other_name), &
      word_type('no', holds_count, other_name), word_type('nr', holds_count, other_name), &
      word_type('count', holds_count, sure_name), word_type('scan', holds_count, sure_name), &
      word_type('phase', holds_count, sure_name), word_type('stage', holds_count, sure_name), &
      word_type('segment', holds_count, sure_name), word_type('loop', holds_count, sure_name), &
      word_type('level', holds_count, sure_name), word_type('amplitude', holds_count, sure_name), &
      word_type('pressure', holds_pressure, sure_name), &
      word_type('stress', holds_pressure, other_name), &
      word_type('druck', holds_pressure, sure_name, ends), &
      word_type('spannung', holds_pressure, other_name, ends), &
      word_type('strain', holds_other, sure_name), word_type('rate', holds_other, sure_name), &
      word_type('speed', holds_other, sure_name), word_type('velocity', holds_other, sure_name), &
      word_type('energy', holds_other, sure_name), word_type('work', holds_other, sure_name), &
      word_type('stiffness', holds_other, sure_name), word_type('area', holds_other, sure_name), &
      word_type('temperature', holds_other, sure_name), &
      word_type('voltage', holds_other, sure_name), &
      word_type('dissipation', holds_other, sure_name), &
      word_type('dehnung', holds_other, sure_name, ends), &
      word_type('geschwindigkeit', holds_other, sure_name, ends)]

   character(len=*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyz'

contains

   !> What a column of some heading, without its unit, holds, and how sure that is. Of the words
   !> that are known the last one says it, as in `load-point displacement`.
   pure subroutine find_meaning(heading, holds, rank)
      !> The heading in UTF-8
      character(len=*), intent(in) :: heading
      !> What it holds
      integer, intent(out) :: holds
      !> `sure_name`, `other_name`, `part_of_name`; zero for what is not known
      integer, intent(out) :: rank
      character(len=len(heading)) :: text
      integer :: first, length, which

      holds = holds_unknown
      rank = 0
      text = lower_case(adjustl(heading))
      which = findloc(words%text == text .and. len_trim(text) > 0, .true., 1)
      if (which > 0) then
         holds = words(which)%holds
         rank = max(words(which)%rank, sure_name)
         if (words(which)%rank == 0) rank = other_name
         return
      end if
      first = scan(text, letters)
      do while (first > 0)
         length = verify(text(first:)//' ', letters) - 1
         which = known_word(text(first:first + length - 1))
         if (which > 0) then
            ! `force no. 2` is a force, `load step` a step
            if (holds == holds_unknown .or. words(which)%holds /= holds_count &
                  .or. words(which)%rank == sure_name) holds = words(which)%holds
            rank = part_of_name
         end if
         first = first + length
         if (first > len(text)) exit
         length = scan(text(first:), letters)
         if (length == 0) exit
         first = first + length - 1
      end do
   end subroutine find_meaning

   !> Place of a word within a heading in the table, zero if it is not there.
   pure integer function known_word(word) result(which)
      character(len=*), intent(in) :: word
      integer :: last

      do which = size(words), 1, -1
         if (words(which)%rank == 0) cycle
         last = len_trim(words(which)%text)
         if (word == words(which)%text(:last) .or. word == words(which)%text(:last)//'s') return
         if (.not. words(which)%ends .or. len(word) < last) cycle
         if (word(len(word) - last + 1:) == words(which)%text(:last)) return
      end do
   end function known_word

   !> A quantity in words.
   pure function quantity_name(holds) result(name)
      !> One of the above
      integer, intent(in) :: holds
      character(len=:), allocatable :: name

      select case (holds)
      case (holds_displacement)
         name = 'displacement'
      case (holds_rotation)
         name = 'rotation'
      case (holds_force)
         name = 'force'
      case (holds_pressure)
         name = 'pressure'
      case default
         name = 'moment'
      end select
   end function quantity_name

end module asperity_program_record_names
