!> What the headings of a record's columns say: name, unit, and what a column holds by them.
module asperity_program_record_headings
   use asperity_program_record_names, only: find_meaning, holds_displacement, holds_drift, &
      holds_force, holds_moment, holds_pressure, holds_rotation, holds_time, holds_unknown
   use asperity_program_record_units, only: find_unit, unit_angle, unit_force, unit_length, &
      unit_moment, unit_pressure, unit_share, unit_time, unit_unknown
   use asperity_program_system_utf8, only: utf8_text
   implicit none
   private
   public :: heading_type, is_unit_of, read_heading, rank_of

   !> What a file says of one of its columns, in UTF-8.
   type :: heading_type
      !> The whole heading, and without its unit; empty if there are no names
      character(len=:), allocatable :: text, name
      !> Unit, empty if there is none
      character(len=:), allocatable :: unit
      !> What it holds by its name, and how sure that is (`asperity_program_record_names`)
      integer :: holds = holds_unknown, rank = 0
      !> What its unit measures (`asperity_program_record_units`)
      integer :: measures = unit_unknown
   end type heading_type

   !> Ranks of candidates below those of names: the unit says what drift is; the unit alone
   integer, parameter :: rank_drift = 4
   integer, parameter, public :: rank_unit = 5
   !> What stands between a name and its unit where there are no brackets
   character(len=*), parameter :: joints = ' ,/_'

contains

   !> What one field of the line of names says.
   pure subroutine read_heading(text, heading)
      !> The field
      character(len=*), intent(in) :: text
      !> What it says
      type(heading_type), intent(out) :: heading
      integer :: open, last, holds, rank

      heading%text = utf8_text(text)
      heading%name = heading%text
      heading%unit = ''
      last = len(heading%text)
      open = scan(heading%text, '([', back=.true.)
      if (open > 1 .and. scan(heading%text(max(1, last):), ')]') > 0) then
         heading%unit = trim(adjustl(heading%text(open + 1:last - 1)))
         heading%name = trim(heading%text(:open - 1))
      else
         open = scan(heading%text, joints, back=.true.)
         if (open > 1 .and. open < last) then
            call find_meaning(heading%text(:open - 1), holds, rank)
            if (rank > 0 .and. is_unit_of(holds, heading%text(open + 1:))) then
               heading%unit = heading%text(open + 1:)
               heading%name = without_joint(heading%text(:open))
            end if
         end if
      end if
      call find_meaning(heading%name, heading%holds, heading%rank)
      associate (unit => find_unit(heading%unit))
         heading%measures = unit%measures
      end associate
   end subroutine read_heading

   !> A name without what joined a unit to it, such as `Weg in ` or `Weg/`.
   pure function without_joint(text) result(name)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: name

      name = text(:verify(text, joints, back=.true.))
      if (len(name) < 4) return
      if (name(len(name) - 2:) == ' in') name = trim(name(:len(name) - 3))
   end function without_joint

   !> Whether a text is a unit of what a name stands for.
   pure logical function is_unit_of(holds, text)
      !> What the name stands for
      integer, intent(in) :: holds
      !> The text
      character(len=*), intent(in) :: text

      associate (unit => find_unit(text))
         is_unit_of = unit%measures /= unit_unknown .and. fits(holds, unit%measures)
      end associate
   end function is_unit_of

   !> Whether what a column holds may have a unit that measures something; a unit that is not known
   !> fits all.
   pure logical function fits(holds, measures)
      integer, intent(in) :: holds, measures

      select case (holds)
      case (holds_displacement)
         fits = any(measures == [unit_unknown, unit_length])
      case (holds_rotation)
         fits = any(measures == [unit_unknown, unit_angle, unit_share])
      case (holds_drift)
         fits = any(measures == [unit_unknown, unit_length, unit_angle, unit_share])
      case (holds_force)
         fits = any(measures == [unit_unknown, unit_force])
      case (holds_moment)
         fits = any(measures == [unit_unknown, unit_moment])
      case (holds_pressure)
         fits = any(measures == [unit_unknown, unit_pressure])
      case (holds_time)
         fits = any(measures == [unit_unknown, unit_time])
      case default
         fits = .false.
      end select
   end function fits

   !> How well a heading answers to a quantity: from 1 on, the lower the better; zero if not.
   pure integer function rank_of(heading, holds) result(rank)
      !> The heading
      type(heading_type), intent(in) :: heading
      !> The quantity, one of `asperity_program_record_names`
      integer, intent(in) :: holds

      rank = 0
      if (.not. fits(holds, heading%measures)) return
      if (heading%holds == holds) then
         rank = heading%rank
      else if (heading%holds == holds_drift) then
         ! a displacement if its unit says so, else a rotation
         if (holds == holds_rotation .or. (holds == holds_displacement &
            .and. heading%measures == unit_length)) rank = rank_drift
      else if (heading%holds == holds_unknown .and. heading%measures == unit_of(holds)) then
         rank = rank_unit
      end if
   end function rank_of

   !> The kind of unit that tells a quantity without a name. A share may be many things.
   pure integer function unit_of(holds)
      integer, intent(in) :: holds

      select case (holds)
      case (holds_displacement)
         unit_of = unit_length
      case (holds_rotation)
         unit_of = unit_angle
      case (holds_force)
         unit_of = unit_force
      case (holds_pressure)
         unit_of = unit_pressure
      case default
         unit_of = unit_moment
      end select
   end function unit_of

end module asperity_program_record_headings
