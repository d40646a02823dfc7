!> Units as laboratories write them: what they measure, and how much they are.
module asperity_program_record_units
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_program_system_strings, only: lower_case
   implicit none
   private
   public :: unit_type, find_unit

   !> What a unit measures
   enum, bind(c)
      !> Not known, or no unit
      enumerator :: unit_unknown = 0
      enumerator :: unit_length
      enumerator :: unit_angle
      !> A share that may be an angle: %
      enumerator :: unit_share
      enumerator :: unit_force
      enumerator :: unit_moment
      enumerator :: unit_pressure
      enumerator :: unit_time
      !> Something that no column of a record is chosen for
      enumerator :: unit_other
   end enum
   public :: unit_unknown, unit_length, unit_angle, unit_share, unit_force, unit_moment, &
      unit_pressure, unit_time, unit_other

   !> One unit.
   type :: unit_type
      !> Its name in lower case, without blanks, points and other marks of a product
      character(len=10) :: name
      !> What it measures
      integer :: measures
      !> What it is in mm, rad, N or MPa; 1 of all others
      real(wp) :: factor
   end type unit_type

   real(wp), parameter :: degree = pi/180.0_wp, inch = 25.4_wp, &
      kgf = 9.80665_wp, lbf = 4.4482216152605_wp

   type(unit_type), parameter :: units(*) = [ &
      unit_type('mm', unit_length, 1.0_wp), unit_type('cm', unit_length, 10.0_wp), &
      unit_type('dm', unit_length, 100.0_wp), unit_type('m', unit_length, 1000.0_wp), &
      unit_type('um', unit_length, 1.0e-3_wp), unit_type('micron', unit_length, 1.0e-3_wp), &
      unit_type('in', unit_length, inch), unit_type('inch', unit_length, inch), &
      unit_type('inches', unit_length, inch), unit_type('"', unit_length, inch), &
      unit_type('zoll', unit_length, inch), unit_type('mil', unit_length, 1.0e-3_wp*inch), &
      unit_type('ft', unit_length, 12.0_wp*inch), &
      unit_type('rad', unit_angle, 1.0_wp), unit_type('radian', unit_angle, 1.0_wp), &
      unit_type('radians', unit_angle, 1.0_wp), unit_type('mrad', unit_angle, 1.0e-3_wp), &
      unit_type('deg', unit_angle, degree), unit_type('degree', unit_angle, degree), &
      unit_type('degrees', unit_angle, degree), unit_type('grad', unit_angle, degree), &
      unit_type('%', unit_share, 1.0e-2_wp), unit_type('percent', unit_share, 1.0e-2_wp), &
      unit_type('%rad', unit_angle, 1.0e-2_wp), &
      unit_type('n', unit_force, 1.0_wp), unit_type('dan', unit_force, 10.0_wp), &
      unit_type('kn', unit_force, 1000.0_wp), unit_type('mn', unit_force, 1.0e6_wp), &
      unit_type('lbf', unit_force, lbf), unit_type('lb', unit_force, lbf), &
      unit_type('lbs', unit_force, lbf), unit_type('kip', unit_force, 1000.0_wp*lbf), &
      unit_type('kips', unit_force, 1000.0_wp*lbf), unit_type('kgf', unit_force, kgf), &
      unit_type('kp', unit_force, kgf), unit_type('tf', unit_force, 1000.0_wp*kgf), &
      unit_type('nm', unit_moment, 1.0_wp), unit_type('nmm', unit_moment, 1.0_wp), &
      unit_type('ncm', unit_moment, 1.0_wp), unit_type('knm', unit_moment, 1.0_wp), &
      unit_type('knmm', unit_moment, 1.0_wp), unit_type('kncm', unit_moment, 1.0_wp), &
      unit_type('mnm', unit_moment, 1.0_wp), unit_type('kipin', unit_moment, 1.0_wp), &
      unit_type('inkip', unit_moment, 1.0_wp), unit_type('kipft', unit_moment, 1.0_wp), &
      unit_type('ftkip', unit_moment, 1.0_wp), unit_type('kinch', unit_moment, 1.0_wp), &
      unit_type('lbin', unit_moment, 1.0_wp), unit_type('inlb', unit_moment, 1.0_wp), &
      unit_type('lbft', unit_moment, 1.0_wp), unit_type('ftlb', unit_moment, 1.0_wp), &
      unit_type('lbfin', unit_moment, 1.0_wp), unit_type('lbfft', unit_moment, 1.0_wp), &
      unit_type('inlbf', unit_moment, 1.0_wp), unit_type('ftlbf', unit_moment, 1.0_wp), &
      unit_type('s', unit_time, 1.0_wp), unit_type('sec', unit_time, 1.0_wp), &
      unit_type('secs', unit_time, 1.0_wp), unit_type('second', unit_time, 1.0_wp), &
      unit_type('seconds', unit_time, 1.0_wp), unit_type('sek', unit_time, 1.0_wp), &
      unit_type('ms', unit_time, 1.0e-3_wp), unit_type('min', unit_time, 60.0_wp), &
      unit_type('h', unit_time, 3600.0_wp), unit_type('hr', unit_time, 3600.0_wp), &
      unit_type('mpa', unit_pressure, 1.0_wp), unit_type('kpa', unit_pressure, 1.0e-3_wp), &
      unit_type('pa', unit_pressure, 1.0e-6_wp), unit_type('gpa', unit_pressure, 1.0e3_wp), &
      unit_type('n/mm2', unit_pressure, 1.0_wp), unit_type('n/mm^2', unit_pressure, 1.0_wp), &
      unit_type('psi', unit_pressure, lbf/inch**2), &
      unit_type('ksi', unit_pressure, 1000.0_wp*lbf/inch**2), &
      unit_type('bar', unit_pressure, 0.1_wp), unit_type('v', unit_other, 1.0_wp), &
      unit_type('mv', unit_other, 1.0_wp), unit_type('mv/v', unit_other, 1.0_wp), &
      unit_type('a', unit_other, 1.0_wp), unit_type('ma', unit_other, 1.0_wp), &
      unit_type('c', unit_other, 1.0_wp), unit_type('degc', unit_other, 1.0_wp), &
      unit_type('mm/s', unit_other, 1.0_wp), unit_type('mm/min', unit_other, 1.0_wp), &
      unit_type('n/mm', unit_other, 1.0_wp), unit_type('kn/mm', unit_other, 1.0_wp), &
      unit_type('n/s', unit_other, 1.0_wp), unit_type('kn/s', unit_other, 1.0_wp), &
      unit_type('m/s', unit_other, 1.0_wp), unit_type('hz', unit_other, 1.0_wp), &
      unit_type('j', unit_other, 1.0_wp), unit_type('kj', unit_other, 1.0_wp), &
      unit_type('mm2', unit_other, 1.0_wp), unit_type('mm^2', unit_other, 1.0_wp), &
      unit_type('1/mm^2', unit_other, 1.0_wp), unit_type('mpa/mm', unit_other, 1.0_wp), &
      unit_type('um/m', unit_other, 1.0_wp), unit_type('g', unit_other, 1.0_wp)]

   !> Marks of a product, which different laboratories write differently, in UTF-8 also the dots
   character(len=*), parameter :: marks = ' .*-_'
   character(len=2), parameter :: middle_dot = char(194)//char(183), micro = char(194)//char(181), &
      mu = char(206)//char(188), degree_sign = char(194)//char(176)
   character(len=3), parameter :: dot_operator = char(226)//char(139)//char(133)

contains

   !> The unit that a text in UTF-8 means; `unit_unknown` and 1 if it is not known.
   pure type(unit_type) function find_unit(text) result(unit)
      !> The text
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: name
      integer :: i

      unit = unit_type('', unit_unknown, 1.0_wp)
      ! a nanometre is none of a force times a length
      if (text == 'nm') return
      name = plain(lower_case(text))
      i = findloc(units%name == name .and. len_trim(name) > 0, .true., 1)
      if (i > 0) unit = units(i)
   end function find_unit

   !> A text without marks of a product, and with ASCII letters for the signs that have one.
   pure function plain(text)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: plain
      integer :: i

      plain = ''
      i = 1
      do while (i <= len(text))
         if (starts(text(i:), micro) .or. starts(text(i:), mu)) then
            plain = plain//'u'
            i = i + 1
         else if (starts(text(i:), degree_sign)) then
            plain = plain//'deg'
            i = i + 1
         else if (starts(text(i:), middle_dot)) then
            i = i + 1
         else if (starts(text(i:), dot_operator)) then
            i = i + 2
         else if (scan(text(i:i), marks) == 0) then
            plain = plain//text(i:i)
         end if
         i = i + 1
      end do
   end function plain

   pure logical function starts(text, beginning)
      character(len=*), intent(in) :: text, beginning

      starts = index(text, beginning) == 1
   end function starts

end module asperity_program_record_units
