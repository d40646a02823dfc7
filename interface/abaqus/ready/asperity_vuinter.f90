! asperity 0.2.0: VUINTER for ABAQUS/Explicit with double
! with every module it uses. Generated, do not edit.
!
! Not run: ABAQUS was not available. VUINTER is UINTER for all slave nodes of a contact pair at
! once: same PROPS, same STATEV, same signs. It has 49 arguments and serves contact pairs with the
! penalty method; general contact calls VUINTERACTION, which is not here. It was compared with
! UINTER under hosts of our own.
!
! ABAQUS/Explicit passes single precision unless the job says double, and the file must match. A
! file of the wrong precision is refused before anything is written, with a message that names the
! right one.
!
! abaqus job=joint user=asperity_vuinter_single
! abaqus job=joint double user=asperity_vuinter
!
! *SURFACE INTERACTION, NAME=WOOD, USER, PROPERTIES=12, DEPVAR=11, TRACKING THICKNESS=0.2
!
! 0.5, 0.31, 206.0, 297.0, 3.141592653589793, 0.1477, 24.53, 0.4
! 0.0593, 0.2372, 1.0, 1.0
! *STEP
! *DYNAMIC, EXPLICIT
! , 0.1
! *CONTACT PAIR, INTERACTION=WOOD, MECHANICAL CONSTRAINT=PENALTY
! SLAVE, MASTER
!
! Whether the blank line belongs there in ABAQUS/Explicit too is likely, not certain: the keyword's
! page has two kinds of data lines for it, as for ABAQUS/Standard, and what the first holds was not
! found. With the wrong form VUINTER refuses the list, as pi is not in PROPS(5) then, and nothing is
! computed: try the other.
!
! What differs from UINTER:
!
! - No tangent and no PNEWDT. A motion, rotation, DTIMCUR or STATEV that is not a number or above
!   1e30 in size, and a result that single precision cannot hold, end the job through XPLB_ABQERR
!   and XPLB_EXIT with the number of the slave node (in a model of part instances, ABAQUS' internal
!   one).
! - sed is total; sfd, spd, svd and scd are incremental, as in UINTER. The manual's own words on
!   this were not found.
! - In two dimensions drot has no meaning and is not used.
! - Validity flags: at most one message a call, with the number of nodes and the first of them; each
!   flag once a node.
! - ABAQUS does not know this law's stiffness when it chooses the stable time increment. A stiff law
!   may need a smaller one (*DYNAMIC, EXPLICIT, DIRECT USER CONTROL or SCALE FACTOR).
!
! PROPERTIES: PROPS
!
! In the paper's order as far as it goes; meaning and sources: law.md.
!
!   slot        property [unit]
!   1           mu, friction coefficient
!   2           gcrit, largest elastic slip [mm]
!   3           eta, summits per area [1/mm^2]
!   4           E*, equivalent modulus of the two faces [MPa]
!   5           pi: 3.14 or better. Not used; it guards against a shifted list
!   6           R, radius of summits [mm]
!   7           H, hardness [MPa]
!   8           k, mean pressure at first yield over hardness
!   9           sigma, standard deviation of summit heights. The paper's list ends before it, but
!               the law needs it: PROPERTIES=8 is refused [mm]
!   10          d0, separation at zero overclosure, taken literally, zero and negative too; 4 sigma
!               only with PROPERTIES=9 [mm]
!   11          friction rule: 1 abaqus (default, also 0), 2 dissipative
!   12          slip integration: 1 exact (default, also 0), 2 backward_euler as ABAQUS' own
!               friction
!   13          accept unphysical: 1 lets properties that no face or solid has pass, flagged
!   14          unloading: 0 reversible (default, the paper's), 1 elastic: summits remember
!               (unloading.md), k 2/sqrt(w2/w1) or more, 0.1907 at 110
!   15          plastic ratio w2/w1, 10 to 1000; 0 for 110
!   16          height distribution: 0 gaussian (default), 1 johnson (law.md)
!   17          skewness of johnson
!   18          kurtosis of johnson; 0 for 3
!   19          static friction coefficient; 0 for mu, that in motion
!   20          decay slip: the excess at rest falls to 1/e over it; 0 not by slip [mm]
!   21          decay slip rate, at which it is down to 1/e; 0 not by rate [mm/s]
!   22          friction coefficient across the grain; 0 for mu, that along it
!   23          grain angle, from the first slip direction to the grain at the start [degrees]
!   24          slip direction: 0 associated (default), 1 that of the stress
!   25          pressure exponent n: all coefficients times (p/p0)^n
!   26          reference pressure p0 of the exponent [MPa]
!   27          shear limit, at rest along the grain; 0 none [MPa]
!   28          stick: 0 up to critical_slip (default), 1 summits, each for itself
!   29          stick elements, 4 to 16; 0 for 8
!   30          shear modulus G*, equivalent as E*, for summits [MPa]
!   31          friction points: how many pairs of pressure (MPa, rising) and factor on all
!               coefficients, 0 to 8, follow from slot 32 on
!
! A list may end anywhere from slot 9 on; what it lacks is zero. With friction points it has 31 + 2
! slots each, no more and no less. What depends on a rate takes DTIME (VUINTER: DTIMCUR) for
! seconds: a static step needs times that mean something.
!
! STATE: STATEV
!
! All zero at the start. DEPVAR=11 while slots 19 to 31 of PROPS are zero, 13 when they are not, 13
! + 2 n with summits of n elements (29 with the default of 8). More does no harm; less is refused by
! a message that says how many.
!
!   slot        state [unit]
!   1           status: 0 never called, 1 open, 2 stick, 3 slip (also LSTATE)
!   2           overclosure [mm]
!   3           pressure [MPa]
!   4           stored normal energy per area; with elastic what is recoverable [N/mm]
!   5, 6        elastic slip in the two slip directions; zero while open [mm]
!   7           largest overclosure reached: the memory of elastic, never below slot 2. A restart
!               may turn elastic on [mm]
!   8           frictional dissipation since the start [N/mm]
!   9           pressure coupling since the start (law.md) [N/mm]
!   10          validity flags reached: 1 real area above nominal, 2 pressure above H, 4 mean
!               closure above R/2, 8 k below 2/sqrt(w2/w1), 16 eta*R*sigma above 4, 32 below 0.0158,
!               64 another property as no face or solid has, 128 summits flattened further than
!               unloading is known for
!   11          validity flags warned of
!   12          motion share: how far friction has gone from rest, 0, to motion, 1, by slip alone
!   13          angle by which slip directions have turned over the grain [rad]
!   14, 15; ... elastic slip of the summits' elements, two directions each [mm]
!
! OUTPUT
!
! *OUTPUT, FIELD
! *CONTACT OUTPUT
! CSTRESS, CDISP, SDV
!
! SDV1, SDV2, ... at the slave nodes are the slots of STATEV. CSTRESS is pressure and shear (CPRESS,
! CSHEAR1, CSHEAR2), CDISP the opening COPEN, which is minus the overclosure, and the slips.
!
! SIGNS
!
!   quantity    sign
!   RDISP(1)    overclosure: positive closes; -1.E36 is no opposite surface
!   STRESS(1)   pressure: positive compresses
!   STRESS(2:3) shear stress along RDISP(2:3): has the sign of the elastic slip, which it resists
!   DDSDDR      (1,1), (2,2), (3,3) zero or positive; (2,2), (3,3) below zero where friction decays
!   DROT        the elastic slip of the start becomes DROT times it
!   SED         total stored energy, with elastic the recoverable one
!   SFD, SPD    friction and, with elastic, flattening of summits: dissipation of the increment;
!               SVD, SCD are zero
!
! More: docs/abaqus.md of asperity, whose parts these are.
!
! MIT License
!
! Copyright (c) 2026 asperity authors
!
! Permission is hereby granted, free of charge, to any person obtaining a copy
! of this software and associated documentation files (the "Software"), to deal
! in the Software without restriction, including without limitation the rights
! to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
! copies of the Software, and to permit persons to whom the Software is
! furnished to do so, subject to the following conditions:
!
! The above copyright notice and this permission notice shall be included in all
! copies or substantial portions of the Software.
!
! THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
! IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
! FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
! AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
! LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
! OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
! SOFTWARE.

! src/base/kinds.f90
!> The one real kind of the library.
module asperity_base_kinds
   use, intrinsic :: iso_c_binding, only: c_intptr_t
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private

   !> Working precision of every real number: IEEE double, whatever the compiler's default is.
   integer, parameter, public :: wp = real64
   !> 1. A compiler for 32 bits stops here, at a division by zero: UINTER and the C interface need
   !> addresses and doubles at multiples of 8 bytes
   integer, parameter, public :: asperity_needs_a_64_bit_system = 1/(storage_size( &
      0_c_intptr_t)/64)
end module asperity_base_kinds

! src/contact/friction_settings.f90
!> What friction can be beyond one coefficient and one critical slip: rest and motion, grain,
!> pressure, a shear limit, summits that stick each for itself. Zeros everywhere are plain Coulomb
!> friction with one elastic slip.
module asperity_contact_friction_settings
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: friction_settings

   !> Where a point slips to
   enum, bind(c)
      !> Normal to the ellipse of shear stresses: the most dissipation
      enumerator :: slip_direction_associated = 0
      !> Along the shear stress
      enumerator :: slip_direction_of_stress
   end enum
   public :: slip_direction_associated, slip_direction_of_stress

   !> What sticks before it slides
   enum, bind(c)
      !> The point, up to one critical slip gcrit
      enumerator :: stick_critical_slip = 0
      !> Its summits, each as Mindlin's theory has it
      enumerator :: stick_summits
   end enum
   public :: stick_critical_slip, stick_summits

   !> Largest coefficient and factor on it that are let pass: far beyond any use
   real(wp), parameter, public :: largest_friction = 1.0e3_wp
   !> Most points of mu over pressure, and elements of `stick_summits`
   integer, parameter, public :: most_friction_points = 8, most_stick_elements = 16
   !> Elements unless given, and fewest
   integer, parameter, public :: default_stick_elements = 8, fewest_stick_elements = 4

   !> As a user gives it; checked by `new_contact_properties`.
   type :: friction_settings
      !> Coefficient at rest; zero stands for that in motion, `friction_coefficient`
      real(wp) :: static_friction_coefficient = 0.0_wp
      !> Slip over which the excess at rest falls to 1/e, mm; zero: not by slip
      real(wp) :: decay_slip = 0.0_wp
      !> Slip rate at which it is down to 1/e, mm/s; zero: not by rate
      real(wp) :: decay_slip_rate = 0.0_wp
      !> Coefficient in motion across the grain; zero stands for that along it,
      !> `friction_coefficient`
      real(wp) :: friction_coefficient_across = 0.0_wp
      !> Angle from the first slip direction to the grain, degrees, at the start
      real(wp) :: grain_angle = 0.0_wp
      !> `slip_direction_associated` or `slip_direction_of_stress`
      integer :: slip_direction = slip_direction_associated
      !> All coefficients times (p/reference_pressure)^pressure_exponent; above -1
      real(wp) :: pressure_exponent = 0.0_wp
      !> MPa; needed where the exponent is not zero
      real(wp) :: reference_pressure = 0.0_wp
      !> Pressures, MPa, rising, and factors on all coefficients there; between them straight,
      !> outside constant. The first `friction_points` of them count
      integer :: friction_points = 0
      real(wp) :: friction_pressures(most_friction_points) = 0.0_wp
      real(wp) :: friction_factors(most_friction_points) = 0.0_wp
      !> Largest shear stress, along the grain and at rest, MPa; zero for none
      real(wp) :: shear_limit = 0.0_wp
      !> `stick_critical_slip` or `stick_summits`
      integer :: stick = stick_critical_slip
      !> Number of elements of `stick_summits`, 4 to 16; zero stands for 8
      integer :: stick_elements = 0
      !> Equivalent shear modulus G* of the two faces, 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2, MPa; for
      !> `stick_summits`
      real(wp) :: shear_modulus = 0.0_wp
   end type friction_settings

end module asperity_contact_friction_settings

! src/base/error.f90
!> Errors are values: an allocatable `error_type` is unset on success. Nothing in the library
!> prints or stops.
module asperity_base_error
   implicit none
   private
   public :: error_type, fatal_error

   !> What kind of failure it is; the program uses the number as its exit status.
   integer, parameter, public :: computation_error = 1
   !> A value that is not allowed.
   integer, parameter, public :: input_error = 2
   !> A file that cannot be read or written.
   integer, parameter, public :: file_error = 3

   !> One failure. The message names the thing, its value, what is allowed and what to do.
   type :: error_type
      !> `computation_error`, `input_error` or `file_error`
      integer :: category = computation_error
      !> One line of text without a full stop at its end
      character(len=:), allocatable :: message
      !> Names of the values that it is about, as the API calls them, with a blank between: `sigma`,
      !> `eta radius sigma`; empty when it is about none
      character(len=:), allocatable :: subject
   end type error_type

contains

   !> Set `error` to a failure.
   pure subroutine fatal_error(error, message, category, subject)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> What went wrong
      character(len=*), intent(in) :: message
      !> Kind of failure; `input_error` when absent
      integer, intent(in), optional :: category
      !> Names of the values that it is about; empty when absent
      character(len=*), intent(in), optional :: subject

      allocate (error)
      ! allocated in so many words: ABAQUS may compile without allocation by assignment
      allocate (error%message, source=message)
      if (present(subject)) then
         allocate (error%subject, source=subject)
      else
         allocate (error%subject, source='')
      end if
      error%category = input_error
      if (present(category)) error%category = category
   end subroutine fatal_error

end module asperity_base_error

! src/base/finite.f90
!> Whether a real is a finite number, by its bits: options such as -ffast-math do not spoil it, and
!> unlike IEEE_ARITHMETIC it does not make gfortran save and restore the floating-point state in
!> every external procedure that uses a module of ours, which takes as long as the law itself.
module asperity_base_finite
   use, intrinsic :: iso_c_binding, only: c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: all_below, all_finite, all_within, is_finite, is_nan

   interface
      !> C's own. flang makes a library call of every `transfer`, which takes as long as twenty of
      !> these, and gfortran allocates memory for those of arrays.
      pure subroutine copy_bytes(to, from, n) bind(c, name='memcpy')
         import :: c_size_t
         implicit none
         type(*), intent(inout) :: to(*)
         type(*), intent(in) :: from(*)
         integer(c_size_t), intent(in), value :: n
      end subroutine copy_bytes
   end interface

   !> Exponent bits of a double: all set in an infinity and in what is not a number
   integer(int64), parameter :: exponent_bits = int(z'7FF0000000000000', int64)

   !> Numbers whose bits are looked at side by side
   integer, parameter :: block = 32
   integer(int64), parameter :: sign_bit = ibset(0_int64, 63)
   integer(int64), parameter :: fraction_bits = int(z'000FFFFFFFFFFFFF', int64)

contains

   !> False for infinities and for what is not a number.
   pure elemental logical function is_finite(x)
      !> Any number
      real(wp), intent(in) :: x

      is_finite = iand(transfer(x, exponent_bits), exponent_bits) /= exponent_bits
   end function is_finite

   !> Whether all are finite.
   pure logical function all_finite(values)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)

      all_finite = largest_bits(size(values), values) < exponent_bits
   end function all_finite

   !> Whether all are numbers smaller in size than a limit.
   pure logical function all_below(values, limit)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)
      !> A number above zero
      real(wp), intent(in) :: limit

      real(wp) :: limits(1)
      integer(int64) :: bits(1)

      limits = limit
      call copy_bytes(bits, limits, storage_size(limits, c_size_t)/8)
      all_below = largest_bits(size(values), values) < bits(1)
   end function all_below

   !> Whether all are numbers within a range above zero.
   pure logical function all_within(values, lowest, highest)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)
      !> Ends of the range, above zero
      real(wp), intent(in) :: lowest, highest
      real(wp) :: ends(2)
      integer(int64) :: limits(2)

      ends(1) = lowest
      ends(2) = highest
      call copy_bytes(limits, ends, 2*storage_size(ends, c_size_t)/8)
      all_within = bits_within(size(values), values, limits)
   end function all_within

   !> Bits of the largest in size: in the order of positive numbers, infinity and what is none above
   !> all others.
   pure integer(int64) function largest_bits(n, values) result(largest)
      integer, intent(in) :: n
      real(wp), intent(in) :: values(n)
      integer(int64) :: bits(block)
      integer :: first, m, i

      largest = 0_int64
      do first = 1, n, block
         m = min(block, n - first + 1)
         call copy_bytes(bits, values(first), m*storage_size(values, c_size_t)/8)
         do i = 1, m
            largest = max(largest, iand(bits(i), not(sign_bit)))
         end do
      end do
   end function largest_bits

   pure logical function bits_within(n, values, limits)
      integer, intent(in) :: n
      real(wp), intent(in) :: values(n)
      integer(int64), intent(in) :: limits(2)
      integer(int64) :: bits(block)
      integer :: first, m, i

      bits_within = .true.
      do first = 1, n, block
         m = min(block, n - first + 1)
         call copy_bytes(bits, values(first), m*storage_size(values, c_size_t)/8)
         do i = 1, m
            bits_within = bits_within .and. bits(i) >= limits(1) .and. bits(i) <= limits(2)
         end do
      end do
   end function bits_within

   !> True for what is not a number.
   pure elemental logical function is_nan(x)
      !> Any number
      real(wp), intent(in) :: x

      is_nan = .not. is_finite(x) .and. iand(transfer(x, exponent_bits), fraction_bits) /= 0_int64
   end function is_nan

end module asperity_base_finite

! src/base/number_text.f90
!> Numbers as text, for messages and files.
!>
!> Character results have explicit lengths: gfortran keeps the length of a deferred-length result
!> in static storage, which two threads that warn at once would share.
module asperity_base_number_text
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_finite, only: is_finite, is_nan
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: to_text

   !> Decimal text of a number without blanks: of a real, the shortest that reads back as the same
   !> bits, or its first figures when their number is given; `NaN`, `Infinity` or `-Infinity` where
   !> there is none.
   interface to_text
      module procedure :: integer_to_text
      module procedure :: large_integer_to_text
      module procedure :: real_to_text
      module procedure :: figures_to_text
   end interface to_text

   !> Figures that tell any two reals apart
   integer, parameter :: all_figures = 17
   integer, parameter :: buffer_length = 40

contains

   pure integer function integer_length(value)
      integer(int64), intent(in) :: value
      character(len=buffer_length) :: buffer

      write (buffer, '(i0)') value
      integer_length = len_trim(buffer)
   end function integer_length

   pure integer function real_length(value, figures)
      real(wp), intent(in) :: value
      integer, intent(in) :: figures
      character(len=buffer_length) :: buffer

      call write_real(value, figures, buffer)
      real_length = len_trim(buffer)
   end function real_length

   !> Decimal text of an integer.
   pure function integer_to_text(value) result(text)
      !> The number
      integer, intent(in) :: value
      character(len=integer_length(1_int64*value)) :: text

      write (text, '(i0)') value
   end function integer_to_text

   !> Decimal text of a large integer.
   pure function large_integer_to_text(value) result(text)
      !> The number
      integer(int64), intent(in) :: value
      character(len=integer_length(value)) :: text

      write (text, '(i0)') value
   end function large_integer_to_text

   !> Shortest text of a real that reads back as the same bits.
   pure function real_to_text(value) result(text)
      !> The number
      real(wp), intent(in) :: value
      character(len=real_length(value, all_figures)) :: text
      character(len=buffer_length) :: buffer

      call write_real(value, all_figures, buffer)
      text = buffer
   end function real_to_text

   !> Text of a real of so many figures at most.
   pure function figures_to_text(value, figures) result(text)
      !> The number
      real(wp), intent(in) :: value
      !> Most significant figures shown, 1 to 17
      integer, intent(in) :: figures
      character(len=real_length(value, figures)) :: text
      character(len=buffer_length) :: buffer

      call write_real(value, figures, buffer)
      text = buffer
   end function figures_to_text

   !> The text, left in the buffer and padded with blanks.
   pure subroutine write_real(value, figures, buffer)
      real(wp), intent(in) :: value
      integer, intent(in) :: figures
      character(len=buffer_length), intent(out) :: buffer
      character(len=16) :: edit
      real(wp) :: back
      integer :: n

      if (is_nan(value)) then
         buffer = 'NaN'
         return
      else if (.not. is_finite(value)) then
         buffer = merge('Infinity ', '-Infinity', value > 0.0_wp)
         return
      end if
      ! rounded to few figures, the largest numbers are none
      do n = merge(figures, 1, abs(value) > 1.0e307_wp), figures
         write (edit, '(a, i0, a)') '(es40.', n - 1, 'e3)'
         write (buffer, edit) value
         if (n == figures) exit
         read (buffer, *) back
         if (back >= value .and. back <= value) exit
      end do
      call make_plain(buffer)
   end subroutine write_real

   !> Turn 3.1E-001 into 0.31 where that is short, else into 3.1E-1.
   pure subroutine make_plain(buffer)
      character(len=buffer_length), intent(inout) :: buffer
      character(len=buffer_length) :: figures, zeros
      character(len=1) :: sign
      integer :: mark, exponent, n

      buffer = adjustl(buffer)
      sign = ' '
      if (buffer(1:1) == '-') then
         sign = '-'
         buffer = buffer(2:)
      end if
      mark = index(buffer, 'E')
      read (buffer(mark + 1:), *) exponent
      ! the figures without the point that follows the first of them
      figures = buffer(1:1)//buffer(3:mark - 1)
      n = mark - 2
      zeros = repeat('0', buffer_length)
      if (exponent < -4 .or. exponent > 6) then
         if (n == 1) figures(2:2) = '0'
         n = max(n, 2)
         write (buffer, '(4a, i0)') figures(1:1), '.', figures(2:n), 'E', exponent
      else if (exponent < 0) then
         buffer = '0.'//zeros(:-exponent - 1)//figures
      else
         if (n < exponent + 2) figures(n + 1:exponent + 2) = zeros
         n = max(n, exponent + 2)
         buffer = figures(:exponent + 1)//'.'//figures(exponent + 2:n)
      end if
      buffer = adjustl(sign//buffer(:buffer_length - 1))
   end subroutine make_plain

end module asperity_base_number_text

! src/base/checks.f90
!> Checks of numbers that a caller gives: each names the value, its unit and what is allowed.
module asperity_base_checks
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_within, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: all_positive, check_positive, check_range

   !> Range of a number above zero, wide of any system of units
   real(wp), parameter, public :: smallest_positive = 1.0e-20_wp, largest_positive = 1.0e20_wp

contains

   !> Whether `check_positive` passes every value.
   pure logical function all_positive(values)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)

      all_positive = all_within(values, smallest_positive, largest_positive)
   end function all_positive

   !> Set `error` unless `value` is a number above zero (1e-20 to 1e20).
   pure subroutine check_positive(error, name, value, unit)
      !> Set when the value is refused
      type(error_type), allocatable, intent(inout) :: error
      !> Name of the property
      character(len=*), intent(in) :: name
      !> Its value
      real(wp), intent(in) :: value
      !> Its unit, for the message
      character(len=*), intent(in) :: unit
      real(wp) :: values(1)

      values = value
      if (all_positive(values)) return
      call fatal_error(error, name//' = '//to_text(value)// &
         ' is not allowed: it must be a number above zero (1e-20 to 1e20), in '//unit, &
         subject=name)
   end subroutine check_positive

   !> Set `error` unless `value` is a number between two limits.
   pure subroutine check_range(error, name, value, lowest, highest, unit)
      !> Set when the value is refused
      type(error_type), allocatable, intent(inout) :: error
      !> Name of the property
      character(len=*), intent(in) :: name
      !> Its value and the limits
      real(wp), intent(in) :: value, lowest, highest
      !> Its unit with a blank before it, or nothing
      character(len=*), intent(in) :: unit

      if (is_finite(value)) then
         if (value >= lowest .and. value <= highest) return
      end if
      call fatal_error(error, name//' = '//to_text(value)//unit// &
         ' is not allowed: it must be a number between '//to_text(lowest)//' and '// &
         to_text(highest)//unit, subject=name)
   end subroutine check_range

end module asperity_base_checks

! src/base/constants.f90
!> Constants of mathematics.
module asperity_base_constants
   use asperity_base_kinds, only: wp
   implicit none
   private

   real(wp), parameter, public :: pi = acos(-1.0_wp)
end module asperity_base_constants

! src/base/double_double.f90
!> Products and quotients with twice the digits, as a sum of two doubles. The constants w1 and w2
!> are found with it: far in the tail of the heights one bit of theirs is worth 1e-12 of a result.
module asperity_base_double_double
   use, intrinsic :: iso_fortran_env, only: int64, real32
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: double_double, quotient, operator(*), assignment(=)

   !> The number high + low, |low| at most half a unit in the last place of high.
   type :: double_double
      real(wp) :: high, low
   end type double_double

   !> Product of two, or of one and a real, to about 30 digits.
   interface operator(*)
      module procedure :: multiply
      module procedure :: multiply_real
   end interface operator(*)

   !> Round to a real.
   interface assignment(=)
      module procedure :: round
   end interface assignment(=)

   !> Sizes whose upper half single precision holds
   real(wp), parameter :: smallest = 1.0e-37_wp, largest = 1.0e38_wp
   !> Bits of the lower half of a double
   integer, parameter :: half_bits = 27

contains

   !> a/b to about 30 digits. Operands between 1e-140 and 1e140 in size.
   pure elemental function quotient(a, b) result(q)
      !> Numerator and denominator
      real(wp), intent(in) :: a, b
      type(double_double) :: q, back

      q%high = a/b
      back = exact_product(q%high, b)
      q%low = ((a - back%high) - back%low)/b
   end function quotient

   pure elemental function multiply(a, b) result(c)
      type(double_double), intent(in) :: a, b
      type(double_double) :: c

      c = exact_product(a%high, b%high)
      c%low = c%low + (a%high*b%low + a%low*b%high)
   end function multiply

   pure elemental function multiply_real(a, b) result(c)
      type(double_double), intent(in) :: a
      real(wp), intent(in) :: b
      type(double_double) :: c

      c = exact_product(a%high, b)
      c%low = c%low + a%low*b
   end function multiply_real

   !> a*b without error (Dekker 1971).
   pure elemental function exact_product(a, b) result(c)
      real(wp), intent(in) :: a, b
      type(double_double) :: c
      real(wp) :: a_high, a_low, b_high, b_low

      c%high = a*b
      a_high = upper_half(a)
      b_high = upper_half(b)
      a_low = a - a_high
      b_low = b - b_high
      c%low = ((a_high*b_high - c%high) + a_high*b_low + a_low*b_high) + a_low*b_low
   end function exact_product

   !> The leading bits, rounded to nearest: as single precision holds them, of other sizes by the
   !> bits, which flang gets at by a library call; without Dekker's multiplication, which a fused
   !> multiply-add would spoil.
   pure elemental real(wp) function upper_half(a)
      real(wp), intent(in) :: a
      integer(int64), parameter :: lower = 2_int64**half_bits - 1_int64
      integer(int64), parameter :: half = 2_int64**(half_bits - 1)

      if (abs(a) > smallest .and. abs(a) < largest) then
         upper_half = real(real(a, real32), wp)
      else
         upper_half = transfer(iand(transfer(a, lower) + half, not(lower)), a)
      end if
   end function upper_half

   pure elemental subroutine round(x, a)
      real(wp), intent(out) :: x
      type(double_double), intent(in) :: a

      x = a%high + a%low
   end subroutine round

end module asperity_base_double_double

! src/law/gaussian_tail.f90
!> Moments of the upper tail of the standard normal density phi without loss of digits:
!> F_n(y) = integral_0^inf t^n phi(t + y) dt for n = 0, 1, 2.
module asperity_law_gaussian_tail
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: find_tail_moments, density_reach

   !> From here on exp(-y^2/2), and with it the density, is zero in double precision
   real(wp), parameter, public :: vanishing_height = 39.0_wp
   !> 1/sqrt(2 pi)
   real(wp), parameter, public :: phi_0 = 0.398942280401432677939946_wp
   real(wp), parameter :: sqrt_half = 0.707106781186547524400844_wp
   !> The density is cut where it falls to exp(-45) of its largest value
   real(wp), parameter :: cut = 45.0_wp

   !> (y + shift) F_2/F_1 on equal intervals of u = 1/(y + shift), 0 <= u <= 1/shift, by powers of
   !> the local variable -1..1; from test/reference/gaussian_tail_constants.py, error 3e-17
   real(wp), parameter :: shift = 4.0_wp
   integer, parameter :: degree = 12, intervals = 6
   real(wp), parameter :: c(0:degree, 0:intervals - 1) = reshape([ &
      2.1784494277520991052_wp, 0.19071725054114274484_wp, 0.012734769343233370546_wp, &
      0.00044318767024916836636_wp, -0.000029924078617187449577_wp, &
      -6.6996010023697882412e-6_wp, -5.4410606719384835017e-7_wp, -5.9480057322802313998e-9_wp, &
      4.2836220191271825682e-9_wp, 5.5630991848544302123e-10_wp, 2.1691140537274786062e-11_wp, &
      -3.3124181217054387287e-12_wp, -5.7995024879554452928e-13_wp, &
      2.6136411453718374933_wp, 0.24537963548491723699_wp, 0.014015522506818007868_wp, &
      -0.00014378484523013349413_wp, -0.00012411671832237381937_wp, &
      -0.000010672848458605115285_wp, 2.1406691437961130739e-7_wp, 1.3072739109446553743e-7_wp, &
      9.1889652339331738833e-9_wp, -6.8948557037152686172e-10_wp, -1.6197372522242647953e-10_wp, &
      -4.1140547227738175553e-12_wp, 1.5436016795005742326e-12_wp, &
      3.1570170941958172617_wp, 0.29499739775849004291_wp, 0.009470832306371817104_wp, &
      -0.0014458800420801793331_wp, -0.00017601106649603081555_wp, 4.3605590929842993476e-6_wp, &
      2.1153408874359934769e-6_wp, 4.959458180043027065e-8_wp, -2.2461143700289330323e-8_wp, &
      -1.4411162490708946959e-9_wp, 2.1935731027635540377e-10_wp, 2.3103531014781880442e-11_wp, &
      -1.9196245364543624899e-12_wp, &
      3.7707870445899832305_wp, 0.31065002962673818026_wp, -0.0025827258135934097302_wp, &
      -0.0023572343165792150482_wp, -0.000018947960920139622874_wp, &
      0.000023140077989746398983_wp, 2.4946930439819188919e-7_wp, -2.5387624521660300452e-7_wp, &
      -8.9635960941811872989e-10_wp, 2.8940341117018529072e-9_wp, -3.0075825967304450857e-11_wp, &
      -3.1652900801473226706e-11_wp, 8.9247433012641607609e-13_wp, &
      4.3633202723569415927_wp, 0.27321661636412126409_wp, -0.015429832011362335737_wp, &
      -0.0016731667025793260496_wp, 0.00016544035251742138521_wp, 9.2180522418890277838e-6_wp, &
      -1.9315248119077561122e-6_wp, -2.0735269129325226122e-9_wp, 1.9377282663026450607e-8_wp, &
      -9.8473350492442165708e-10_wp, -1.4449543256004298235e-10_wp, &
      1.7501554982959567683e-11_wp, 4.6881454254009233469e-13_wp, &
      4.8374713293102445214_wp, 0.19709607936601026898_wp, -0.021196748245365898826_wp, &
      -0.00026315606498777050253_wp, 0.00015769396923238155089_wp, -8.0809622927219210194e-6_wp, &
      -6.8067854498867427759e-7_wp, 1.1648568840225049104e-7_wp, -3.2716574811125620483e-9_wp, &
      -7.3253129865862716879e-10_wp, 8.7561392927043137192e-11_wp, &
      -6.6925881644716493914e-13_wp, -6.8655929266162702509e-13_wp], [13, 6])

contains

   !> Scaled moments: F_n(y) = moments(n) exp(-max(y, 0)^2/2), n = 0, 1, 2.
   !> For y > 0 the closed forms phi - y Q and (1 + y^2) Q - y phi lose 13 digits by y = 37. There
   !> all follow from the ratio F_2/F_1 by sums of positive terms: F_0 = F_2 + y F_1 and
   !> phi = F_1 + y F_0.
   pure subroutine find_tail_moments(y, moments)
      !> Lower end of the tail; any finite value up to 1e150 in size
      real(wp), intent(in) :: y
      !> The three moments
      real(wp), intent(out) :: moments(0:2)
      real(wp) :: u, x, x2, x4, ratio
      integer :: i

      if (y > 0.0_wp) then
         u = 1.0_wp/(y + shift)
         x = (2*intervals*shift)*u
         i = min(int(0.5_wp*x), intervals - 1)
         x = x - real(2*i + 1, wp)
         x2 = x*x
         x4 = x2*x2
         ratio = u*((((c(0, i) + c(1, i)*x) + x2*(c(2, i) + c(3, i)*x)) &
            + x4*((c(4, i) + c(5, i)*x) + x2*(c(6, i) + c(7, i)*x))) &
            + x4*x4*(((c(8, i) + c(9, i)*x) + x2*(c(10, i) + c(11, i)*x)) + x4*c(12, i)))
         moments(1) = phi_0/(1.0_wp + y*(y + ratio))
         moments(2) = ratio*moments(1)
         moments(0) = (ratio + y)*moments(1)
      else
         moments(0) = 0.5_wp*erfc(sqrt_half*y)
         moments(1) = phi_0*exp(-0.5_wp*y*y) - y*moments(0)
         moments(2) = moments(0) - y*moments(1)
      end if
   end subroutine find_tail_moments

   !> How far from y, away from zero, the density phi matters: where it is exp(-45) phi(y).
   pure elemental real(wp) function density_reach(y)
      !> Any finite value up to 1e150 in size
      real(wp), intent(in) :: y

      density_reach = 2.0_wp*cut/(sqrt(y*y + 2.0_wp*cut) + abs(y))
   end function density_reach

end module asperity_law_gaussian_tail

! src/law/johnson/curve.f90
!> Johnson's functions from a Gaussian number x to a height z, and back, to round-off also where
!> they are all but a line, and over short ways.
module asperity_law_johnson_curve
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: height_at, height_beyond, height_slope, johnson_curve_type, normal_number

   !> Below this s the function is a line to rounding
   real(wp), parameter, public :: flattest = 1.0e-8_wp
   !> Numbers beyond this are of no use: the density is zero in double precision from 39 on
   real(wp), parameter :: farthest = 40.0_wp

   !> The function z(x) of a distribution, z(0) = 0 and z'(0) = 1. With
   !> c(y) = (1 + w) exp(y)/2 + (1 - w) exp(-y)/2 it is 2/s sinh(y/2) c(y/2), unbounded, or
   !> 2/s sinh(y/2)/c(-y/2), bounded.
   type :: johnson_curve_type
      !> Whether heights are bounded
      logical :: is_bounded = .false.
      !> s, w = (1 - q)/(1 + q), and 1 - w with the digits that w has no room for
      real(wp) :: s = flattest, w = 0.0_wp, rest = 1.0_wp
   end type johnson_curve_type

contains

   !> z(x), rising also where it is flat to rounding: away from zero of terms that each rise.
   pure elemental real(wp) function height_at(curve, x) result(z)
      !> The function
      type(johnson_curve_type), intent(in) :: curve
      !> Gaussian number of mean 0 and variance 1
      real(wp), intent(in) :: x
      real(wp) :: y, power

      y = curve%s*x
      if (abs(y) < 1.0_wp) then
         z = height_beyond(curve, 0.0_wp, x)
      else if (.not. curve%is_bounded) then
         power = exp(y)
         z = 0.5_wp*((1.0_wp + curve%w)*(power - 1.0_wp) + curve%rest*(1.0_wp - 1.0_wp/power)) &
            /curve%s
      else if (y > 0.0_wp) then
         power = exp(-y)
         z = 2.0_wp*(1.0_wp - power)/((1.0_wp + curve%w)*power + curve%rest)/curve%s
      else
         power = exp(y)
         z = 2.0_wp*(power - 1.0_wp)/(1.0_wp + curve%w + curve%rest*power)/curve%s
      end if
   end function height_at

   !> z(x + xi) - z(x), free of cancellation.
   pure elemental real(wp) function height_beyond(curve, x, xi) result(z)
      !> The function
      type(johnson_curve_type), intent(in) :: curve
      !> Gaussian numbers of mean 0 and variance 1: from where, and how far
      real(wp), intent(in) :: x, xi

      associate (s => curve%s)
         z = 2.0_wp/s*sinh(0.5_wp*s*xi)
         if (curve%is_bounded) then
            z = z/(growth(curve, -0.5_wp*s*x)*growth(curve, -0.5_wp*s*(x + xi)))
         else
            z = z*growth(curve, s*(x + 0.5_wp*xi))
         end if
      end associate
   end function height_beyond

   !> dz/dx.
   pure elemental real(wp) function height_slope(curve, x) result(slope)
      !> The function, and a Gaussian number
      type(johnson_curve_type), intent(in) :: curve
      real(wp), intent(in) :: x

      if (curve%is_bounded) then
         slope = growth(curve, -0.5_wp*curve%s*x)**(-2)
      else
         slope = growth(curve, curve%s*x)
      end if
   end function height_slope

   !> c(y) of `johnson_curve_type`.
   pure elemental real(wp) function growth(curve, y)
      type(johnson_curve_type), intent(in) :: curve
      real(wp), intent(in) :: y

      growth = exp(y)
      growth = 0.5_wp*((1.0_wp + curve%w)*growth + curve%rest/growth)
   end function growth

   !> The inverse: the Gaussian number x of a height z; huge in size beyond the ends of bounded
   !> heights.
   pure elemental real(wp) function normal_number(curve, z) result(x)
      !> The function, and a height
      type(johnson_curve_type), intent(in) :: curve
      real(wp), intent(in) :: z
      real(wp) :: v, above, below, root
      integer :: i

      v = curve%s*z
      if (curve%is_bounded) then
         above = 2.0_wp + (1.0_wp + curve%w)*v
         below = 2.0_wp - curve%rest*v
      else
         v = v + curve%w
         root = sqrt(v*v + curve%rest*(1.0_wp + curve%w))
         if (v > 0.0_wp) then
            above = root + v
         else
            above = curve%rest*(1.0_wp + curve%w)/(root - v)
         end if
         below = 1.0_wp + curve%w
      end if
      x = huge(1.0_wp)
      if (.not. below > 0.0_wp) return
      x = -huge(1.0_wp)
      if (.not. above > 0.0_wp) return
      x = log(above/below)/curve%s
      ! a flat function has lost digits in the logarithm, which two steps of Newton's method restore
      if (curve%s > 0.5_wp .or. abs(x) > farthest) return
      do i = 1, 2
         x = x - (height_at(curve, x) - z)/height_slope(curve, x)
      end do
   end function normal_number

end module asperity_law_johnson_curve

! src/law/johnson/fit.f90
!> Johnson's (1949) systems of distributions: heights z as a rising function of a Gaussian number x,
!> with y = s x. Above the lognormal distribution of the same skewness kurtosis takes the unbounded
!> one, z = exp(y) - q exp(-y), below it the bounded one, z = exp(y)/(1 + q exp(y)), 0 <= q <= 1.
!> They reach any skewness and kurtosis that distributions have, save for those next to the bound
!> kurtosis = skewness^2 + 1.
module asperity_law_johnson_fit
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_johnson_curve, only: flattest, height_at, johnson_curve_type
   implicit none
   private
   public :: find_johnson, johnson_curve, johnson_moments, johnson_type, normal_point, &
      normal_weight

   !> Half the number of points of a quadrature over x that is fine enough for all, and their
   !> distance
   integer, parameter, public :: n_half = 400
   real(wp), parameter :: dx = 0.04_wp
   !> What moments need: the trapezoidal rule errs by exp(-2 pi^2/step^2), and by the poles of
   !> bounded functions, pi/s from the axis, by exp(-2 pi^2/(s step)); the powers of unbounded ones
   !> have their largest part at 4 s
   real(wp), parameter :: widest = 0.5_wp, step_by_pole = 0.35_wp
   real(wp), parameter :: reach_bounded = 9.0_wp, reach_unbounded = 15.0_wp
   !> Least distance in kurtosis from the lognormal distributions, between the two systems
   real(wp), parameter :: least_side = 1.0e-6_wp
   !> Steepness of the functions at the end of what is reached
   real(wp), parameter :: steepest_unbounded = 1.2_wp, steepest_bounded = 8.0_wp

   !> One distribution, of skewness zero or above.
   type :: johnson_type
      !> s^2 = a^2 + d/4, unbounded, for d > 0, a^2 - d/2, bounded, else; (1 - q)/(1 + q) = a/s
      real(wp) :: a = 0.0_wp, d = 0.0_wp
   end type johnson_type

contains

   !> Find the distribution.
   pure subroutine find_johnson(skewness, kurtosis, found, is_found)
      !> Skewness, not below zero
      real(wp), intent(in) :: skewness
      !> Kurtosis, above skewness^2 + 1
      real(wp), intent(in) :: kurtosis
      !> The distribution
      type(johnson_type), intent(out) :: found
      !> False where it is not reached
      logical, intent(out) :: is_found
      integer, parameter :: n_steps(4) = [1, 3, 12, 40]
      integer :: i

      do i = 1, size(n_steps)
         call follow(found, skewness, kurtosis, n_steps(i), is_found)
         if (is_found) return
      end do
   end subroutine find_johnson

   !> Point i of the quadrature over a Gaussian number, -n_half to n_half.
   pure elemental real(wp) function normal_point(i)
      !> Its number
      integer, intent(in) :: i

      normal_point = dx*i
   end function normal_point

   !> Its weight, the Gaussian density included.
   pure elemental real(wp) function normal_weight(i)
      !> Its number
      integer, intent(in) :: i

      normal_weight = dx/sqrt(2.0_wp*pi)*exp(-0.5_wp*(dx*i)**2)
   end function normal_weight

   !> Go from the Gaussian distribution to the one asked for in steps, Newton's method at each, on
   !> one side of the lognormal distributions.
   pure subroutine follow(johnson, skewness, kurtosis, n_steps, is_found)
      type(johnson_type), intent(inout) :: johnson
      real(wp), intent(in) :: skewness, kurtosis
      integer, intent(in) :: n_steps
      logical, intent(out) :: is_found
      real(wp) :: target(2), reached, side
      integer :: i

      is_found = .false.
      side = kurtosis - 3.0_wp - lognormal_excess(skewness)
      side = sign(max(abs(side), least_side), side)
      ! where s is small, the skewness is 3 a and the kurtosis 3 + 16 a^2 + d
      johnson%a = min(skewness/(3*n_steps), 1.0_wp)
      johnson%d = max(min(side/n_steps, 1.0_wp), -1.0_wp)
      do i = 1, n_steps
         reached = real(i, wp)/n_steps
         target(1) = skewness*reached
         target(2) = lognormal_excess(target(1)) + side*reached*room(target(1))/room(skewness)
         call solve(johnson, target, is_found)
         if (.not. is_found) return
      end do
   end subroutine follow

   !> Kurtosis less 3 of the lognormal distribution of a skewness.
   pure real(wp) function lognormal_excess(skewness) result(excess)
      real(wp), intent(in) :: skewness
      real(wp) :: w
      integer :: i

      ! skewness = (w + 2) sqrt(w - 1), w = exp(s^2), by Newton on its square from above
      w = 1.0_wp + skewness**2
      do i = 1, 50
         w = w - ((w + 2.0_wp)**2*(w - 1.0_wp) - skewness**2)/(3.0_wp*w*(w + 2.0_wp))
      end do
      excess = (w - 1.0_wp)*(w*w*(w + 3.0_wp) + 6.0_wp*(w + 1.0_wp))
   end function lognormal_excess

   !> Distance in kurtosis of the lognormal distribution of a skewness from its bound.
   pure real(wp) function room(skewness)
      real(wp), intent(in) :: skewness

      room = lognormal_excess(skewness) + 2.0_wp - skewness**2
   end function room

   !> Newton's method for the two parameters, from those there are. It is quadratic: one step from
   !> 1e-10 it is at round-off.
   pure subroutine solve(johnson, target, is_found)
      type(johnson_type), intent(inout) :: johnson
      !> Skewness and kurtosis - 3
      real(wp), intent(in) :: target(2)
      logical, intent(out) :: is_found
      logical :: settled
      type(johnson_type) :: trial
      real(wp) :: rest(2), new_rest(2), scales(2), jacobian(2, 2), step(2), determinant, factor, h
      integer :: i, j

      is_found = .false.
      rest = shape_of(johnson) - target
      scales = 1.0_wp + abs(target)
      settled = .false.
      do i = 1, 40
         is_found = maxval(abs(rest)/scales) < 1.0e-10_wp
         if (settled) return
         settled = is_found
         h = 1.0e-5_wp
         trial = johnson
         trial%a = johnson%a + h
         jacobian(:, 1) = (shape_of(trial) - target - rest)/h
         trial = johnson
         ! by the logarithm of d, which keeps its sign
         trial%d = johnson%d*exp(h)
         jacobian(:, 2) = (shape_of(trial) - target - rest)/h
         determinant = jacobian(1, 1)*jacobian(2, 2) - jacobian(1, 2)*jacobian(2, 1)
         if (.not. abs(determinant) > tiny(1.0_wp)) return
         step = [jacobian(2, 2)*rest(1) - jacobian(1, 2)*rest(2), &
            jacobian(1, 1)*rest(2) - jacobian(2, 1)*rest(1)]/determinant
         factor = 1.0_wp
         do j = 1, 20
            trial%a = max(johnson%a - factor*step(1), 0.0_wp)
            trial%d = johnson%d*exp(max(min(-factor*step(2), 2.0_wp), -2.0_wp))
            if (steepness(trial) <= merge(steepest_unbounded, steepest_bounded, &
               trial%d > 0.0_wp)) then
               new_rest = shape_of(trial) - target
               if (sum((new_rest/scales)**2) < sum((rest/scales)**2)) exit
            end if
            factor = 0.5_wp*factor
         end do
         ! no better: at round-off where it had settled, else lost
         if (j > 20) return
         johnson%a = trial%a
         johnson%d = trial%d
         rest = new_rest
      end do
   end subroutine solve

   !> s of the function.
   pure real(wp) function steepness(johnson)
      type(johnson_type), intent(in) :: johnson

      steepness = sqrt(johnson%a**2 + excess_of(johnson))
   end function steepness

   !> s^2 - a^2.
   pure real(wp) function excess_of(johnson)
      type(johnson_type), intent(in) :: johnson

      excess_of = merge(0.25_wp, -0.5_wp, johnson%d > 0.0_wp)*johnson%d
   end function excess_of

   !> The function of a distribution.
   pure elemental function johnson_curve(johnson) result(curve)
      !> The distribution
      type(johnson_type), intent(in) :: johnson
      type(johnson_curve_type) :: curve

      curve%is_bounded = .not. johnson%d > 0.0_wp
      curve%s = max(steepness(johnson), flattest)
      curve%w = min(johnson%a/curve%s, 1.0_wp)
      curve%rest = 1.0_wp - curve%w
      if (curve%s > flattest) curve%rest = excess_of(johnson)/(curve%s*(curve%s + johnson%a))
   end function johnson_curve

   !> Skewness and excess kurtosis.
   pure function shape_of(johnson) result(shape)
      type(johnson_type), intent(in) :: johnson
      real(wp) :: shape(2)
      real(wp) :: mean, sigma, moments(4)

      call johnson_moments(johnson, mean, sigma, moments)
      shape = [moments(3)/sigma**3, moments(4)/sigma**4 - 3.0_wp]
   end function shape_of

   !> Mean, standard deviation and central moments.
   pure subroutine johnson_moments(johnson, mean, sigma, moments)
      !> The distribution
      type(johnson_type), intent(in) :: johnson
      !> Mean, standard deviation, and means of the first four powers about the mean
      real(wp), intent(out) :: mean, sigma, moments(4)
      type(johnson_curve_type) :: curve
      real(wp) :: z(-n_half:n_half), p(-n_half:n_half), step
      integer :: i, n

      curve = johnson_curve(johnson)
      step = min(widest, step_by_pole/curve%s)
      n = ceiling(merge(reach_bounded, reach_unbounded, curve%is_bounded)/step)
      do i = -n, n
         p(i) = step/sqrt(2.0_wp*pi)*exp(-0.5_wp*(step*i)**2)
         z(i) = height_at(curve, step*i)
      end do
      mean = sum(p(-n:n)*z(-n:n))
      do i = 1, 4
         moments(i) = sum(p(-n:n)*(z(-n:n) - mean)**i)
      end do
      sigma = sqrt(moments(2))
   end subroutine johnson_moments

end module asperity_law_johnson_fit

! src/law/johnson/heights.f90
!> Heights of mean 0, standard deviation 1 and a given skewness and kurtosis, as a rising function
!> of a Gaussian number, by Johnson's distributions.
module asperity_law_johnson_heights
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_johnson_curve, only: height_at, height_beyond, height_slope, &
      johnson_curve_type, normal_number
   use asperity_law_johnson_fit, only: find_johnson, johnson_curve, johnson_moments, johnson_type
   implicit none
   private
   public :: find_johnson_heights, height_of, height_slope_at, height_step, johnson_heights, &
      normal_score

   !> Skewness and kurtosis as near to those of Gaussian heights as this are theirs
   real(wp), parameter :: gaussian_reach = 1.0e-12_wp
   integer, parameter :: reason_length = 120

   !> The function. Build it with `find_johnson_heights`; read only after.
   type :: johnson_heights
      !> Whether heights are Gaussian, which needs no function
      logical :: is_gaussian = .true.
      !> Sign of the skewness
      real(wp) :: sign = 1.0_wp
      !> Johnson's function of a skewness above zero, with its mean and standard deviation
      type(johnson_curve_type) :: curve = johnson_curve_type()
      real(wp) :: mean = 0.0_wp, sigma = 1.0_wp
   end type johnson_heights

contains

   !> Find the function. `error` is set where there is none.
   pure subroutine find_johnson_heights(heights, skewness, kurtosis, names, error)
      !> The function
      type(johnson_heights), intent(out) :: heights
      !> Skewness and kurtosis asked for
      real(wp), intent(in) :: skewness, kurtosis
      !> Their names, of one length, for messages
      character(len=*), intent(in) :: names(2)
      !> Set where no function has them
      type(error_type), allocatable, intent(out) :: error
      type(johnson_type) :: johnson
      character(len=reason_length) :: reason
      real(wp) :: moments(4)
      logical :: is_found

      if (abs(skewness) < gaussian_reach .and. abs(kurtosis - 3.0_wp) < gaussian_reach) return
      reason = ''
      if (kurtosis < skewness**2 + 1.0_wp) then
         reason = 'is not allowed: no heights have '//names(2)//' below '//names(1)//'^2 + 1 = '// &
            to_text(skewness**2 + 1.0_wp, 5)
      else
         call find_johnson(abs(skewness), kurtosis, johnson, is_found)
         if (.not. is_found) reason = 'cannot be reached: give '//names(1)//' from -4 to 4, '// &
            'and '//names(2)//' from 1.1 '//names(1)//'^2 + 1.3 = '// &
            to_text(1.1_wp*skewness**2 + 1.3_wp, 5)//' to 60'
      end if
      if (reason /= '') then
         call fatal_error(error, names(1)//' = '//to_text(skewness)//' with '//names(2)//' = '// &
            to_text(kurtosis)//' '//trim(reason), subject=names(1)//' '//names(2))
         return
      end if
      heights%is_gaussian = .false.
      heights%sign = sign(1.0_wp, skewness)
      heights%curve = johnson_curve(johnson)
      call johnson_moments(johnson, heights%mean, heights%sigma, moments)
   end subroutine find_johnson_heights

   !> Height of a Gaussian number.
   pure elemental real(wp) function height_of(heights, x) result(z)
      !> The function
      type(johnson_heights), intent(in) :: heights
      !> Gaussian number of mean 0 and variance 1
      real(wp), intent(in) :: x

      z = x
      if (heights%is_gaussian) return
      z = height_at(heights%curve, heights%sign*x) - heights%mean
      z = z*(heights%sign/heights%sigma)
   end function height_of

   !> How much higher the height of x + xi is than that of x, free of cancellation.
   pure elemental real(wp) function height_step(heights, x, xi) result(z)
      !> The function, which is not Gaussian
      type(johnson_heights), intent(in) :: heights
      !> Gaussian number, and how far beyond
      real(wp), intent(in) :: x, xi

      if (heights%sign > 0.0_wp) then
         z = height_beyond(heights%curve, x, xi)/heights%sigma
      else
         z = height_beyond(heights%curve, -(x + xi), xi)/heights%sigma
      end if
   end function height_step

   !> Gaussian number of a height; huge in size beyond the ends of bounded heights.
   pure elemental real(wp) function normal_score(heights, z) result(x)
      !> The function
      type(johnson_heights), intent(in) :: heights
      !> Height
      real(wp), intent(in) :: z

      x = z
      if (.not. heights%is_gaussian) x = heights%sign*normal_number(heights%curve, &
         heights%sign*z*heights%sigma + heights%mean)
   end function normal_score

   !> Derivative of the height by the Gaussian number.
   pure elemental real(wp) function height_slope_at(heights, x) result(slope)
      !> The function
      type(johnson_heights), intent(in) :: heights
      !> Gaussian number
      real(wp), intent(in) :: x

      slope = 1.0_wp
      if (.not. heights%is_gaussian) slope = height_slope(heights%curve, heights%sign*x) &
         /heights%sigma
   end function height_slope_at

end module asperity_law_johnson_heights

! src/law/johnson/summits.f90
!> Which of Johnson's distributions heights of summits may have.
module asperity_law_johnson_summits
   use asperity_base_checks, only: check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_johnson_heights, only: find_johnson_heights, johnson_heights
   implicit none
   private
   public :: find_summit_heights

   !> Skewness and kurtosis that Johnson's distributions are sought for
   real(wp), parameter :: largest_skewness = 4.0_wp, largest_kurtosis = 60.0_wp
   !> Above this s bounded heights have two peaks (Johnson 1949), or all but a cliff where they are
   !> skewed
   real(wp), parameter :: steepest_of_one_peak = sqrt(2.0_wp)

contains

   !> Find the heights of a skewness and a kurtosis. `error` is set where none have them, or those
   !> that do have two peaks.
   pure subroutine find_summit_heights(heights, skewness, kurtosis, error)
      !> The function
      type(johnson_heights), intent(inout) :: heights
      !> Skewness and kurtosis
      real(wp), intent(in) :: skewness, kurtosis
      !> Set where they are refused
      type(error_type), allocatable, intent(inout) :: error

      call check_range(error, 'skewness', skewness, -largest_skewness, largest_skewness, '')
      if (.not. allocated(error)) &
         call check_range(error, 'kurtosis', kurtosis, 1.0_wp, largest_kurtosis, '')
      if (.not. allocated(error)) call find_johnson_heights(heights, skewness, kurtosis, &
         ['skewness', 'kurtosis'], error)
      if (allocated(error) .or. heights%is_gaussian) return
      if (heights%curve%is_bounded .and. heights%curve%s > steepest_of_one_peak) &
         call fatal_error(error, 'kurtosis = '//to_text(kurtosis)//' with skewness = '// &
         to_text(skewness)//' is not allowed: such heights have two peaks or a cliff; the '// &
         'kurtosis of heights with one peak is higher', subject='kurtosis')
   end subroutine find_summit_heights

end module asperity_law_johnson_summits

! src/law/validity.f90
!> Limits past which a result is still computed but no longer means what the law assumes.
!> Validity is part of every result: a sum of the flags below, `valid` (zero) when none is set.
module asperity_law_validity
   implicit none
   private
   public :: validity_text, validity_remark

   !> No limit is passed
   integer, parameter, public :: valid = 0
   !> Real area above nominal area: asperities would overlap
   integer, parameter, public :: area_above_nominal = 1
   !> Pressure above the hardness: no such contact exists
   integer, parameter, public :: pressure_above_hardness = 2
   !> Mean closure of the summits in contact above half their radius: past the sphere's equator
   integer, parameter, public :: closure_above_half_radius = 4
   !> Yield factor below 2/sqrt(w2/w1): the elasto-plastic stage is stiffer than Hertz (b3 > 1.5)
   integer, parameter, public :: stiffer_than_hertz = 8
   !> eta R sigma above 4: rougher than any surface measured so far
   integer, parameter, public :: roughness_number_high = 16
   !> eta R sigma below 0.0158, let pass by `accept_unphysical`: no isotropic Gaussian surface
   integer, parameter, public :: roughness_number_low = 32
   !> A property outside what solids and faces have, let pass by `accept_unphysical`
   integer, parameter, public :: implausible_property = 64
   !> Mean deformation of the summits in contact at the closest separation above 170 w1: past what
   !> unloading was computed for (Etsion, Kligerman, Kadin 2005); by a law with memory alone
   integer, parameter, public :: memory_beyond_data = 128

   integer, parameter :: name_length = 26, remark_length = 73
   integer, parameter :: n_flags = 8
   !> Sum of all flags
   integer, parameter, public :: all_flags = 2**n_flags - 1
   character(len=name_length), parameter :: names(n_flags) = [character(len=name_length) :: &
      'area_above_nominal', 'pressure_above_hardness', 'closure_above_half_radius', &
      'stiffer_than_hertz', 'roughness_number_high', 'roughness_number_low', &
      'implausible_property', 'memory_beyond_data']
   character(len=remark_length), parameter :: remarks(n_flags) = [character(len=remark_length) :: &
      'real area above nominal area: asperities overlap, pressure is too high', &
      'pressure above the hardness: outside the model', &
      'mean closure of touching summits above radius/2: spheres do not apply', &
      'yield_factor below 2/sqrt(plastic_ratio): yielding stiffer than Hertz', &
      'eta*radius*sigma above 4: rougher than any measured surface', &
      'eta*radius*sigma below 0.0158: no isotropic Gaussian surface has it', &
      'a property as no face or solid has, let pass: a slip of units?', &
      'closest mean deformation above 170 w1: beyond what unloading is known for']

contains

   !> Length of the entries of `list` whose flag is set, or of `none`.
   pure integer function joined_length(flags, list, separator, none)
      integer, intent(in) :: flags
      character(len=*), intent(in) :: list(:), separator, none
      integer :: i

      joined_length = -len(separator)
      do i = 1, size(list)
         if (btest(flags, i - 1)) &
            joined_length = joined_length + len(separator) + len_trim(list(i))
      end do
      if (joined_length < 0) joined_length = len(none)
   end function joined_length

   pure integer function names_length(flags)
      integer, intent(in) :: flags

      names_length = joined_length(flags, names, '+', 'valid')
   end function names_length

   pure integer function remarks_length(flags)
      integer, intent(in) :: flags

      remarks_length = joined_length(flags, remarks, '; ', '')
   end function remarks_length

   !> Names of the set flags joined by `+`, or `valid`.
   pure function validity_text(flags) result(text)
      !> Sum of flags
      integer, intent(in) :: flags
      character(len=names_length(flags)) :: text

      text = joined(flags, names, '+', 'valid', len(text))
   end function validity_text

   !> What the set flags mean, joined by `; `, or nothing.
   pure function validity_remark(flags) result(text)
      !> Sum of flags
      integer, intent(in) :: flags
      character(len=remarks_length(flags)) :: text

      text = joined(flags, remarks, '; ', '', len(text))
   end function validity_remark

   !> The entries of `list` whose flag is set, or `none`.
   pure function joined(flags, list, separator, none, length) result(text)
      integer, intent(in) :: flags, length
      character(len=*), intent(in) :: list(:), separator, none
      character(len=length) :: text
      integer :: i, next

      text = none
      next = 1
      do i = 1, size(list)
         if (.not. btest(flags, i - 1)) cycle
         if (next > 1) text(next - len(separator):next - 1) = separator
         text(next:) = list(i)
         next = next + len_trim(list(i)) + len(separator)
      end do
   end function joined

end module asperity_law_validity

! src/law/plausibility.f90
!> Ranges outside which no solid and no face is: a property there is, as a rule, a slip of units,
!> and the message names the likeliest. Each range has its reason. N-mm-MPa; a usual face all in
!> N-m-Pa is known for what it is and passes as well.
module asperity_law_plausibility
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_validity, only: implausible_property, roughness_number_high, &
      roughness_number_low, valid
   implicit none
   private
   public :: check_plausible, check_plausible_length

   !> Smallest bandwidth parameter alpha = m0 m4/m2^2 of an isotropic Gaussian surface (Nayak 1971)
   real(wp), parameter, public :: alpha_min = 1.5_wp
   !> c = 1 - 3 sqrt 3 + 16/pi = 0.896806: the variance of summit heights is m0 (1 - c/alpha)
   real(wp), parameter, public :: summit_constant = 1.0_wp - 3.0_wp*sqrt(3.0_wp) + 16.0_wp/pi
   !> Smallest eta R sigma of an isotropic Gaussian surface, sigma that of summit heights:
   !> alpha - c = 768 pi (eta R sigma)^2 with alpha = 1.5, which gives 0.0158
   real(wp), parameter, public :: roughness_number_min = &
      sqrt((alpha_min - summit_constant)/(768.0_wp*pi))
   !> The same with the standard deviation Sq of all heights, as in the paper:
   !> alpha = 768 pi (eta R Sq)^2 = 1.5, 1/(16 sqrt(2 pi)), which is 0.0249
   real(wp), parameter, public :: roughness_number_min_sq = sqrt(alpha_min/(768.0_wp*pi))
   !> Largest eta R sigma, 15.8: one slip by a factor of 1000 leads out of the range from anywhere
   !> in it. It belongs to alpha = 6e5; rough wood has 0.2 to 4
   real(wp), parameter, public :: roughness_number_max = 1000.0_wp*roughness_number_min
   !> Above this eta R sigma a warning is given: no face measured so far has more
   real(wp), parameter, public :: roughness_number_measured = 4.0_wp

   !> What is checked, in this order
   enum, bind(c)
      enumerator :: of_sigma = 1, of_radius, of_number, of_modulus, of_hardness, of_ratio
   end enum

   !> A range that no solid and no face is outside of.
   type :: range_type
      !> Name, the values that it is made of, and its unit with a blank before it
      character(len=17) :: name, subject
      character(len=4) :: unit
      real(wp) :: lowest, highest
   end type range_type

   !> Why, sigma: an atom to the joints of rock (sawn timber has 0.2 mm). radius: an atom to the
   !> summits of an optical mirror. modulus: diamond against a rigid body. hardness: soft foam to
   !> diamond. H/E*: metals have 6e-4 (indium) to 0.05, wood 0.002 to 0.1, the hardest glasses 0.15;
   !> from 1 on a summit would yield only when pressed in by its whole radius
   type(range_type), parameter, public :: ranges(6) = [ &
      range_type('sigma', 'sigma', ' mm', 1.0e-7_wp, 5.0_wp), &
      range_type('radius', 'radius', ' mm', 1.0e-7_wp, 1.0e4_wp), &
      range_type('eta*radius*sigma', 'eta radius sigma', '', roughness_number_min, &
      roughness_number_max), &
      range_type('modulus', 'modulus', ' MPa', 0.0_wp, 1.3e6_wp), &
      range_type('hardness', 'hardness', ' MPa', 0.1_wp, 1.5e5_wp), &
      range_type('hardness/modulus', 'hardness modulus', '', 1.0e-4_wp, 1.0_wp)]

   !> Largest critical slip and distance of the datum, mm: the paper's critical slip is 0.31; a
   !> datum is farther only where the law reaches as far
   real(wp), parameter, public :: length_max = 10.0_wp

   !> Slips of eta, radius and sigma that are tried, the likeliest first: powers of ten that each
   !> must be multiplied by
   integer, parameter :: roughness_slips(3, 12) = reshape([6, 0, 0, 0, 0, -3, 0, -3, 0, &
      6, 0, -3, 6, -3, 0, 6, -3, -3, -6, 0, 0, 0, -3, -3, 0, 0, 3, 0, 3, 0, 0, 3, 3, -2, 0, 0], &
      [3, 12])
   !> The same of modulus and hardness
   integer, parameter :: strength_slips(2, 9) = reshape([-6, 0, 3, 0, 0, -6, 0, 3, -6, -6, 3, 3, &
      -3, 0, 0, -3, -3, -3], [2, 9])
   !> Root mean square slopes of profiles of usual faces, and their H/E*
   real(wp), parameter :: usual_slopes(2) = [0.01_wp, 1.0_wp], &
      usual_ratios(2) = [5.0e-4_wp, 0.3_wp]
   !> A face in N-m-Pa looks like one of N-mm-MPa that is a thousand times smoother and whose
   !> stresses are in Pa by a slip. Up to this sigma and radius, mm, which timber has, it is taken
   !> for the former; smoother faces, as ground metal has, for the latter
   real(wp), parameter :: sigma_in_si = 0.2_wp, radius_in_si = 10.0_wp
   integer, parameter :: message_length = 160
   character(len=*), parameter :: way_past = &
      '; if it is right, set accept_unphysical (PROPS(13) = 1 in UINTER)'

contains

   !> Find the flags of properties outside these ranges, and set `error`, which names the likely
   !> slip of units, unless that is accepted.
   pure subroutine check_plausible(eta, modulus, radius, hardness, sigma, is_accepted, flags, error)
      !> Asperity density, 1/mm^2; equivalent modulus, MPa; summit radius, mm
      real(wp), intent(in) :: eta, modulus, radius
      !> Hardness, MPa; standard deviation of summit heights, mm
      real(wp), intent(in) :: hardness, sigma
      !> Whether they are let pass
      logical, intent(in) :: is_accepted
      !> Sum of validity flags
      integer, intent(out) :: flags
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: number, ratio, values(size(ranges))
      logical :: is_outside(size(ranges))

      number = eta*radius*sigma
      ratio = hardness/modulus
      flags = valid
      if (number < roughness_number_min) flags = ior(flags, roughness_number_low)
      if (number > roughness_number_measured) flags = ior(flags, roughness_number_high)
      if (is_within(sigma, of_sigma) .and. is_within(radius, of_radius) &
         .and. is_within(number, of_number) .and. is_within(modulus, of_modulus) &
         .and. is_within(hardness, of_hardness) .and. is_within(ratio, of_ratio)) return

      values([of_sigma, of_radius, of_number]) = [sigma, radius, number]
      values([of_modulus, of_hardness, of_ratio]) = [modulus, hardness, ratio]
      is_outside = values < ranges%lowest .or. values > ranges%highest
      if (any(is_outside([of_sigma, of_radius, of_modulus, of_hardness, of_ratio]))) &
         flags = ior(flags, implausible_property)
      if (is_accepted) return
      if (is_in_si(eta, modulus, radius, hardness, sigma)) then
         flags = iand(flags, not(implausible_property))
      else
         call refuse(eta, modulus, radius, hardness, sigma, values, &
            findloc(is_outside, .true., dim=1), error)
      end if
   end subroutine check_plausible

   pure logical function is_within(value, i)
      real(wp), intent(in) :: value
      integer, intent(in) :: i

      is_within = value >= ranges(i)%lowest .and. value <= ranges(i)%highest
   end function is_within

   !> Say which of the values is outside its range, and which slip of units would put it there.
   pure subroutine refuse(eta, modulus, radius, hardness, sigma, values, i, error)
      real(wp), intent(in) :: eta, modulus, radius, hardness, sigma, values(:)
      integer, intent(in) :: i
      type(error_type), allocatable, intent(out) :: error
      type(range_type) :: allowed
      logical :: is_low
      character(len=message_length) :: made_of, remedy

      made_of = ''
      if (i == of_number) &
         made_of = ' = '//to_text(eta)//'*'//to_text(radius)//'*'//to_text(sigma)
      if (i == of_ratio) made_of = ' = '//to_text(hardness)//'/'//to_text(modulus)
      if (i < of_modulus) then
         remedy = roughness_slip(eta, radius, sigma)
      else
         remedy = strength_slip(modulus, hardness)
      end if
      allowed = ranges(i)
      is_low = values(i) < allowed%lowest
      call fatal_error(error, trim(allowed%name)//trim(made_of)//' = '//to_text(values(i), 3)// &
         trim(allowed%unit)//' is '//trim(merge('below', 'above', is_low))//' '// &
         to_text(merge(allowed%lowest, allowed%highest, is_low), 3)//trim(allowed%unit)// &
         ', which '//trim(merge('no isotropic Gaussian surface', 'no known face or solid       ', &
         is_low .and. i == of_number))//' has: '//trim(remedy)//way_past, &
         subject=trim(allowed%subject))
   end subroutine refuse

   !> The same of a length of the contact point, critical slip or datum.
   pure subroutine check_plausible_length(name, value, highest, is_accepted, flags, error)
      !> Name of the property
      character(len=*), intent(in) :: name
      !> Its value and the largest size, mm
      real(wp), intent(in) :: value, highest
      !> Whether it is let pass
      logical, intent(in) :: is_accepted
      !> Sum of validity flags, to which one may be added
      integer, intent(inout) :: flags
      !> Set when it is refused
      type(error_type), allocatable, intent(inout) :: error

      if (abs(value) <= highest) return
      flags = ior(flags, implausible_property)
      if (.not. is_accepted) call fatal_error(error, name//' = '//to_text(value, 3)// &
         ' mm is above '//to_text(highest, 3)//' mm, which no known face has: '//name// &
         ' looks like um, give it in mm (times 1e-3)'//way_past, subject=name)
   end subroutine check_plausible_length

   !> Name the slip of eta, radius and sigma that leaves a usual face.
   pure function roughness_slip(eta, radius, sigma) result(text)
      real(wp), intent(in) :: eta, radius, sigma
      character(len=message_length) :: text
      real(wp) :: values(3)
      integer :: i

      do i = 1, size(roughness_slips, 2)
         values = [eta, radius, sigma]*10.0_wp**roughness_slips(:, i)
         if (.not. is_usual_face(values(1), values(2), values(3))) cycle
         text = slip_text(['eta   ', 'radius', 'sigma '], ['1/mm^2', 'mm    ', 'mm    '], &
            roughness_slips(:, i))
         return
      end do
      text = 'check the units of eta (1/mm^2), radius (mm) and sigma (mm)'
   end function roughness_slip

   !> Whether a face is a usual one. By Nayak's density and McCool's radius the mean square slope of
   !> profiles is sqrt(3)/(128 eta R^2).
   pure logical function is_usual_face(eta, radius, sigma) result(is_usual)
      real(wp), intent(in) :: eta, radius, sigma
      real(wp) :: slope

      slope = sqrt(sqrt(3.0_wp)/(128.0_wp*eta*radius**2))
      is_usual = slope >= usual_slopes(1) .and. slope <= usual_slopes(2) &
         .and. eta*radius*sigma >= roughness_number_min &
         .and. eta*radius*sigma <= roughness_number_measured &
         .and. sigma >= ranges(of_sigma)%lowest .and. sigma <= ranges(of_sigma)%highest
   end function is_usual_face

   !> Whether properties are those of a usual face and solid when they are read in N-m-Pa.
   pure logical function is_in_si(eta, modulus, radius, hardness, sigma)
      real(wp), intent(in) :: eta, modulus, radius, hardness, sigma

      is_in_si = is_usual_face(1.0e-6_wp*eta, 1.0e3_wp*radius, 1.0e3_wp*sigma) &
         .and. 1.0e3_wp*sigma <= sigma_in_si .and. 1.0e3_wp*radius <= radius_in_si &
         .and. is_usual_solid(1.0e-6_wp*modulus, 1.0e-6_wp*hardness)
   end function is_in_si

   !> Whether a solid is a usual one.
   pure logical function is_usual_solid(modulus, hardness) result(is_usual)
      real(wp), intent(in) :: modulus, hardness

      is_usual = modulus <= ranges(of_modulus)%highest &
         .and. hardness >= ranges(of_hardness)%lowest &
         .and. hardness <= ranges(of_hardness)%highest &
         .and. hardness/modulus >= usual_ratios(1) .and. hardness/modulus <= usual_ratios(2)
   end function is_usual_solid

   !> Name the slip of modulus and hardness that leaves a usual solid.
   pure function strength_slip(modulus, hardness) result(text)
      real(wp), intent(in) :: modulus, hardness
      character(len=message_length) :: text
      real(wp) :: e, h
      integer :: i

      do i = 1, size(strength_slips, 2)
         e = modulus*10.0_wp**strength_slips(1, i)
         h = hardness*10.0_wp**strength_slips(2, i)
         if (.not. is_usual_solid(e, h)) cycle
         text = slip_text(['modulus ', 'hardness'], ['MPa', 'MPa'], strength_slips(:, i))
         return
      end do
      text = 'check the units of modulus and hardness (MPa)'
   end function strength_slip

   !> Say in which unit properties seem to be, and what to do.
   pure function slip_text(names, units, powers) result(text)
      !> Names of the properties, and their units
      character(len=*), intent(in) :: names(:), units(:)
      !> Powers of ten that they must be multiplied by
      integer, intent(in) :: powers(:)
      character(len=message_length) :: text
      integer :: i

      text = ''
      do i = 1, size(names)
         if (powers(i) == 0) cycle
         if (text /= '') text = trim(text)//'; '
         text = trim(text)//' '//trim(names(i))//' looks like '// &
            trim(unit_of(units(i), powers(i)))//', give it in '//trim(units(i))//' (times 1e'// &
            to_text(powers(i))//')'
      end do
      text = adjustl(text)
   end function slip_text

   !> Unit of a number that becomes one of `unit` when multiplied by a power of ten.
   pure function unit_of(unit, power) result(text)
      character(len=*), intent(in) :: unit
      integer, intent(in) :: power
      character(len=6) :: text

      select case (power)
      case (6)
         text = '1/um^2'
      case (-2)
         text = '1/cm^2'
      case (3)
         text = merge('GPa', 'm  ', unit == 'MPa')
      case (-3)
         text = merge('kPa', 'um ', unit == 'MPa')
      case (-6)
         text = merge('Pa   ', '1/m^2', unit == 'MPa')
      case default
         text = unit
      end select
   end function unit_of

end module asperity_law_plausibility

! src/paper/wood.f90
!> The wood of the tests, larch (Larix gmelinii): Table 1. 1 = L along the grain, 2 = R radial,
!> 3 = T tangential.
module asperity_paper_wood
   use asperity_base_kinds, only: wp
   implicit none
   private

   !> Young's moduli in L, R and T, MPa; the table has one for R and T
   real(wp), parameter, public :: young_moduli(3) = [3727.12_wp, 351.01_wp, 351.01_wp]
   !> Poisson's ratios LR, LT, RT: strain in the second over that in the first direction, which is
   !> pulled
   real(wp), parameter, public :: poisson_ratios(3) = [0.62_wp, 0.42_wp, 0.35_wp]
   !> Shear moduli LR, LT, RT, MPa
   real(wp), parameter, public :: shear_moduli(3) = [224.61_wp, 280.32_wp, 67.16_wp]
   !> Strength in compression along the grain, fc0, and across it, fc90, MPa
   real(wp), parameter, public :: wood_strength_along = 50.1_wp, wood_strength_across = 4.7_wp
   !> Strength in tension along the grain, ft0, MPa
   real(wp), parameter, public :: wood_tension_along = 75.3_wp
   !> Hardness of the transverse section, whose normal is L, and of the tangential one, whose normal
   !> is R, MPa (Table 4); the paper has none of the radial one
   real(wp), parameter, public :: hardness_transverse = 24.53_wp, hardness_tangential = 12.14_wp
end module asperity_paper_wood

! src/paper/pairs.f90
!> Pairs and surfaces of the paper in N-mm-MPa. Table 2 mixes units: only asperity density in
!> 1/um^2, radius in mm and sigma in um is physically admissible, and that is what was converted.
module asperity_paper_pairs
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_paper_wood, only: hardness_tangential, hardness_transverse
   implicit none
   private
   public :: surface_preset, pair_preset, find_surface, find_pair, pair_note

   integer, parameter :: name_length = 24, note_length = 120, part_length = 32

   !> Measured roughness of one face (Table 2).
   type :: surface_preset
      !> Name, such as `unpolished-cross`
      character(len=name_length) :: name
      !> Standard deviation of summit heights, mm; the paper prints Sq in um
      real(wp) :: sigma
      !> Summit radius, mm; printed as 1/Spc without a unit
      real(wp) :: radius
      !> Asperity density, 1/mm^2; the paper prints Spd, which only fits in 1/um^2
      real(wp) :: eta
      !> Kurtosis Sku of the heights, 3 for a Gaussian surface
      real(wp) :: kurtosis
      !> What the paper printed and what was converted
      character(len=note_length) :: note
   end type surface_preset

   !> Everything that the contact law needs for one pair of faces (Table 4 with sigma of Table 2).
   type :: pair_preset
      !> Name, such as `transverse-tangential`
      character(len=name_length) :: name
      !> Asperity density, 1/mm^2
      real(wp) :: eta
      !> Equivalent modulus, MPa
      real(wp) :: modulus
      !> Summit radius, mm
      real(wp) :: radius
      !> Hardness, MPa
      real(wp) :: hardness
      !> Mean contact pressure factor k
      real(wp) :: yield_factor
      !> Standard deviation of summit heights, mm
      real(wp) :: sigma
      !> Coulomb friction coefficient mu
      real(wp) :: friction_coefficient
      !> Critical elastic slip gcrit, mm
      real(wp) :: critical_slip
      !> What the paper printed and what was converted: of eta, sigma, hardness and modulus
      character(len=part_length) :: eta_note = '', sigma_note = '', hardness_note = '', &
         modulus_note = ''
   end type pair_preset

   !> The two pairs of Table 4
   type(pair_preset), parameter, public :: pairs(2) = [ &
      pair_preset('transverse-tangential', 206.0_wp, 297.0_wp, 0.1477_wp, &
      hardness_transverse, 0.4_wp, 0.0593_wp, 0.5_wp, 0.31_wp, &
      'eta 0.000206 read as 1/um^2', 'sigma 59.3 um from Table 2', 'H is the harder face', &
      'E* not from Eq. 4'), &
      pair_preset('tangential-tangential', 134.0_wp, 263.0_wp, 0.1142_wp, &
      hardness_tangential, 0.4_wp, 0.0416_wp, 0.5_wp, 0.31_wp, &
      'eta 0.000134 read as 1/um^2', 'sigma 41.6 um from Table 2', '', 'E* not from Eq. 4')]

   !> The nine surfaces of Table 2
   type(surface_preset), parameter, public :: surfaces(9) = [ &
      surface_preset('unpolished-cross', 0.0593_wp, 0.1477_wp, 206.0_wp, 3.61_wp, &
      'Table 2: Sq 59.3 (um), 1/Spc 0.1477 (mm), Spd 0.000206 (1/um^2)'), &
      surface_preset('unpolished-tangential', 0.0416_wp, 0.1142_wp, 134.0_wp, 3.43_wp, &
      'Table 2: Sq 41.6 (um), 1/Spc 0.1142 (mm), Spd 0.000134 (1/um^2)'), &
      surface_preset('unpolished-radial', 0.0276_wp, 0.0696_wp, 127.0_wp, 3.23_wp, &
      'Table 2: Sq 27.6 (um), 1/Spc 0.0696 (mm), Spd 0.000127 (1/um^2)'), &
      surface_preset('mesh-200-cross', 0.0280_wp, 0.2437_wp, 330.0_wp, 3.49_wp, &
      'Table 2: Sq 28.0 (um), 1/Spc 0.2437 (mm), Spd 0.000330 (1/um^2); the text says 120 mesh'), &
      surface_preset('mesh-200-tangential', 0.0197_wp, 0.1508_wp, 297.0_wp, 3.21_wp, &
      'Table 2: Sq 19.7 (um), 1/Spc 0.1508 (mm), Spd 0.000297 (1/um^2); the text says 120 mesh'), &
      surface_preset('mesh-200-radial', 0.0156_wp, 0.1746_wp, 196.0_wp, 3.14_wp, &
      'Table 2: Sq 15.6 (um), 1/Spc 0.1746 (mm), Spd 0.000196 (1/um^2); the text says 120 mesh'), &
      surface_preset('mesh-400-cross', 0.0239_wp, 0.4465_wp, 322.0_wp, 3.34_wp, &
      'Table 2: Sq 23.9 (um), 1/Spc 0.4465 (mm), Spd 0.000322 (1/um^2)'), &
      surface_preset('mesh-400-tangential', 0.0147_wp, 0.3446_wp, 296.0_wp, 3.14_wp, &
      'Table 2: Sq 14.7 (um), 1/Spc 0.3446 (mm), Spd 0.000296 (1/um^2)'), &
      surface_preset('mesh-400-radial', 0.0117_wp, 0.2336_wp, 169.0_wp, 3.01_wp, &
      'Table 2: Sq 11.7 (um), 1/Spc 0.2336 (mm), Spd 0.000169 (1/um^2)')]

contains

   !> The pair of that name; `error` lists the names when there is none.
   pure subroutine find_pair(name, preset, error)
      !> Name, such as `transverse-tangential`
      character(len=*), intent(in) :: name
      !> The pair found
      type(pair_preset), intent(out) :: preset
      !> Set when the name is unknown
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      i = findloc(pairs%name == name, .true., dim=1)
      preset = pairs(max(i, 1))
      if (i == 0) call refuse_name(error, 'pair', name, (pairs%name))
   end subroutine find_pair

   !> The surface of that name; `error` lists the names when there is none.
   pure subroutine find_surface(name, preset, error)
      !> Name, such as `mesh-400-cross`
      character(len=*), intent(in) :: name
      !> The surface found
      type(surface_preset), intent(out) :: preset
      !> Set when the name is unknown
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      i = findloc(surfaces%name == name, .true., dim=1)
      preset = surfaces(max(i, 1))
      if (i == 0) call refuse_name(error, 'surface', name, (surfaces%name))
   end subroutine find_surface

   !> What the paper printed of those values of a pair that are used, and what was converted.
   pure function pair_note(pair, eta, sigma, hardness, modulus) result(note)
      !> The pair
      type(pair_preset), intent(in) :: pair
      !> Whether each is used
      logical, intent(in) :: eta, sigma, hardness, modulus
      character(len=note_length) :: note
      character(len=2) :: between

      note = 'Table 4'
      call add(note, '; '//pair%eta_note, eta)
      call add(note, '; '//pair%sigma_note, sigma)
      between = merge(', ', '; ', hardness .and. pair%hardness_note /= '')
      call add(note, '; '//pair%hardness_note, hardness)
      call add(note, between//pair%modulus_note, modulus)
   end function pair_note

   !> Add a part, with what stands before it, if there is one and it is used.
   pure subroutine add(note, part, used)
      character(len=note_length), intent(inout) :: note
      character(len=*), intent(in) :: part
      logical, intent(in) :: used

      if (used .and. len_trim(part) > 2) note = trim(note)//part
   end subroutine add

   !> Say that a name is unknown and which are known.
   pure subroutine refuse_name(error, kind, name, known)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: kind, name, known(:)
      character(len=(len(known) + 2)*size(known)) :: list
      integer :: i

      list = known(1)
      do i = 2, size(known)
         list = trim(list)//', '//known(i)
      end do
      call fatal_error(error, kind//" = '"//name//"' is unknown; known "//kind//'s: '// &
         trim(list), subject=kind)
   end subroutine refuse_name

end module asperity_paper_pairs

! src/law/normal_properties.f90
!> Properties of one pair of rough faces for the normal law: checked once, with all constants
!> that follow from them. N-mm-MPa, or N-m-Pa for a face like timber's; in any other consistent
!> units with `accept_unphysical`, as values are then taken for slips of units.
module asperity_law_normal_properties
   use asperity_base_checks, only: all_positive, check_positive, check_range
   use asperity_base_constants, only: pi
   use asperity_base_double_double, only: assignment(=), double_double, operator(*), quotient
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_gaussian_tail, only: vanishing_height
   use asperity_law_johnson_heights, only: height_of, johnson_heights
   use asperity_law_johnson_summits, only: find_summit_heights
   use asperity_law_plausibility, only: check_plausible
   use asperity_law_validity, only: stiffer_than_hertz, valid
   use asperity_paper_pairs, only: pair_preset
   implicit none
   private
   public :: normal_properties, new_normal_properties, equivalent_modulus

   !> What summits do that part again
   enum, bind(c)
      !> Unloading follows loading: the paper's law
      enumerator :: unloading_reversible = 0
      !> Every yielded summit recovers as an elastic one of the radius that its largest deformation
      !> left: `asperity_law_unloading_law`
      enumerator :: unloading_elastic
   end enum
   public :: unloading_reversible, unloading_elastic

   !> How summit heights are distributed
   enum, bind(c)
      !> Normally (Eq. 23)
      enumerator :: heights_gaussian = 0
      !> By Johnson's distribution of a skewness and a kurtosis
      enumerator :: heights_johnson
   end enum
   public :: heights_gaussian, heights_johnson

   !> w2/w1 of metals and of the paper, Eq. 11, and the range over which the law is verified
   real(wp), parameter, public :: default_plastic_ratio = 110.0_wp
   real(wp), parameter :: log_default_ratio = log(default_plastic_ratio)
   real(wp), parameter :: plastic_ratio_min = 10.0_wp, plastic_ratio_max = 1000.0_wp
   !> 3 pi/4 to 32 digits
   type(double_double), parameter :: three_quarters_pi = &
      double_double(2.356194490192345_wp, 9.184850993605148436e-17_wp)
   !> Range of the yield factor over which the law is verified
   real(wp), parameter :: yield_factor_min = 0.05_wp, yield_factor_max = 1.0_wp
   !> Largest b3 with which elastic unloading lies below loading; k = 2/sqrt(w2/w1)
   real(wp), parameter :: largest_force_exponent = 1.5_wp

   !> Normal number of the rarest heights whose closure is judged: one summit in forty
   real(wp), parameter :: rarest_judged = 2.0_wp

   !> Properties of the normal law. Build it with `new_normal_properties`; read only afterwards.
   type :: normal_properties
      !> Asperity density eta: summits per nominal area, 1/mm^2 (Eq. 24)
      real(wp) :: eta = 0.0_wp
      !> Equivalent modulus E*, MPa (Eq. 4)
      real(wp) :: modulus = 0.0_wp
      !> Summit radius R, mm
      real(wp) :: radius = 0.0_wp
      !> Hardness H, MPa
      real(wp) :: hardness = 0.0_wp
      !> Mean contact pressure factor k: yield starts at the mean pressure k H (Eq. 5)
      real(wp) :: yield_factor = 0.0_wp
      !> Standard deviation of summit heights, mm (Eq. 23)
      real(wp) :: sigma = 0.0_wp
      !> Plastic ratio w2/w1 (Eq. 11)
      real(wp) :: plastic_ratio = default_plastic_ratio
      !> Deformation at first yield w1, mm (Eq. 6)
      real(wp) :: w1 = 0.0_wp
      !> Deformation at full plasticity w2, mm (Eq. 11)
      real(wp) :: w2 = 0.0_wp
      !> Exponents of mean pressure, area and force in the elasto-plastic stage (Eqs 14-19),
      !> computed from the yield factor
      real(wp) :: b1 = 0.0_wp, b2 = 0.0_wp, b3 = 0.0_wp
      !> b3 - 1, with the bits that b3 has no room for
      real(wp) :: b3_less_1 = 0.0_wp
      !> Force at first yield N1 = pi k H R w1, N (Eq. 7)
      real(wp) :: n1 = 0.0_wp
      !> Work of one summit's force up to w2, N mm
      real(wp) :: energy_2 = 0.0_wp
      !> `unloading_reversible` or `unloading_elastic`
      integer :: unloading = unloading_reversible
      !> `heights_gaussian` or `heights_johnson`
      integer :: height_distribution = heights_gaussian
      !> Skewness and kurtosis of the heights, 0 and 3 of Gaussian ones
      real(wp) :: skewness = 0.0_wp, kurtosis = 3.0_wp
      !> The heights as a function of a Gaussian number
      type(johnson_heights) :: heights = johnson_heights()
      !> Beyond this separation the law is zero in double precision, mm
      real(wp) :: vanishing_separation = 0.0_wp
      !> Up to this one the mean closure of the summits in contact is judged, mm: the few far out of
      !> heavy tails are all tall
      real(wp) :: judged_separation = 0.0_wp
      !> Flags that hold for every result of these properties (see `asperity_law_validity`)
      integer :: validity = valid
   end type normal_properties

   !> From six numbers, or from a pair of the paper.
   interface new_normal_properties
      module procedure :: from_values
      module procedure :: from_pair
   end interface new_normal_properties

contains

   !> Check the properties of the normal law and derive its constants.
   !> `error` is set, and `properties` unusable, when a value is not above zero (1e-20 to 1e20),
   !> the yield factor is outside 0.05 to 1 (2/sqrt(plastic_ratio) to 1 with elastic unloading), the
   !> plastic ratio outside 10 to 1000, or a value is one that no face or solid has, such as an
   !> eta R sigma below 0.0158 (see `asperity_law_plausibility`); when no heights have skewness and
   !> kurtosis, or heights that are not Gaussian are to unload elastically.
   pure subroutine from_values(properties, eta, modulus, radius, hardness, yield_factor, sigma, &
         error, accept_unphysical, unloading, plastic_ratio, height_distribution, skewness, &
         kurtosis)
      !> Result; all of it is set
      type(normal_properties), intent(inout) :: properties
      !> Asperity density, 1/mm^2; equivalent modulus, MPa; summit radius, mm
      real(wp), intent(in) :: eta, modulus, radius
      !> Hardness, MPa; mean contact pressure factor k; standard deviation of summit heights, mm
      real(wp), intent(in) :: hardness, yield_factor, sigma
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> Let what no face or solid has pass; results are then flagged
      logical, intent(in), optional :: accept_unphysical
      !> `unloading_reversible` (default) or `unloading_elastic`
      integer, intent(in), optional :: unloading
      !> w2/w1, 10 to 1000; 110 when absent
      real(wp), intent(in), optional :: plastic_ratio
      !> `heights_gaussian` (default) or `heights_johnson`
      integer, intent(in), optional :: height_distribution
      !> Skewness and kurtosis of the latter; 0 and 3 when absent
      real(wp), intent(in), optional :: skewness, kurtosis
      type(double_double) :: strain, yield
      real(wp) :: values(7), ratio, log_ratio, b2_less_1
      logical :: allowed, accepted

      ! one by one, as flang allocates memory for an array constructor
      values(1) = eta
      values(2) = modulus
      values(3) = radius
      values(4) = hardness
      values(5) = yield_factor
      values(6) = sigma
      ratio = default_plastic_ratio
      if (present(plastic_ratio)) ratio = plastic_ratio
      values(7) = ratio
      allowed = all_positive(values)
      if (allowed) &
         allowed = yield_factor >= yield_factor_min .and. yield_factor <= yield_factor_max &
         .and. ratio >= plastic_ratio_min .and. ratio <= plastic_ratio_max
      if (.not. allowed) then
         call refuse(error, eta, modulus, radius, hardness, yield_factor, sigma, ratio)
         return
      end if
      accepted = .false.
      if (present(accept_unphysical)) accepted = accept_unphysical
      call check_plausible(eta, modulus, radius, hardness, sigma, accepted, &
         properties%validity, error)
      if (allocated(error)) return

      properties%eta = eta
      properties%modulus = modulus
      properties%radius = radius
      properties%hardness = hardness
      properties%yield_factor = yield_factor
      properties%sigma = sigma
      properties%plastic_ratio = ratio
      ! nearly always that of the paper, in every call of UINTER
      log_ratio = log_default_ratio
      if (abs(ratio - default_plastic_ratio) > 0.0_wp) log_ratio = log(ratio)
      b2_less_1 = log(2.0_wp)/log_ratio
      strain = quotient(hardness, modulus)*yield_factor*three_quarters_pi
      yield = strain*strain*radius
      properties%w1 = yield
      properties%w2 = yield*ratio
      properties%b1 = log(1.0_wp/yield_factor)/log_ratio
      properties%b2 = 1.0_wp + b2_less_1
      properties%b3_less_1 = properties%b1 + b2_less_1
      properties%b3 = 1.0_wp + properties%b3_less_1
      properties%n1 = 4.0_wp/3.0_wp*strain%high*properties%w1*radius*modulus
      properties%energy_2 = properties%n1*properties%w1*(0.4_wp - 1.0_wp/(properties%b3 + 1.0_wp)) &
         + 2.0_wp*pi*radius*hardness*properties%w2**2/(properties%b3 + 1.0_wp)

      if (properties%b3 > largest_force_exponent) &
         properties%validity = ior(properties%validity, stiffer_than_hertz)
      call set_heights(properties, error, height_distribution, skewness, kurtosis)
      properties%unloading = unloading_reversible
      if (present(unloading) .and. .not. allocated(error)) &
         call set_unloading(properties, unloading, error)
   end subroutine from_values

   !> The same of a pair of the paper.
   pure subroutine from_pair(properties, pair, error, accept_unphysical, unloading, &
         plastic_ratio, height_distribution, skewness, kurtosis)
      !> Result
      type(normal_properties), intent(out) :: properties
      !> The pair, such as `find_pair` finds
      type(pair_preset), intent(in) :: pair
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> As above
      logical, intent(in), optional :: accept_unphysical
      integer, intent(in), optional :: unloading, height_distribution
      real(wp), intent(in), optional :: plastic_ratio, skewness, kurtosis

      call from_values(properties, pair%eta, pair%modulus, pair%radius, pair%hardness, &
         pair%yield_factor, pair%sigma, error, accept_unphysical, unloading, plastic_ratio, &
         height_distribution, skewness, kurtosis)
   end subroutine from_pair

   !> Equivalent modulus E* of two elastic bodies, MPa (Eq. 4).
   pure elemental function equivalent_modulus(modulus_1, poisson_1, modulus_2, poisson_2) &
         result(modulus)
      !> Young's moduli, MPa
      real(wp), intent(in) :: modulus_1, modulus_2
      !> Poisson's ratios
      real(wp), intent(in) :: poisson_1, poisson_2
      real(wp) :: modulus

      modulus = 1.0_wp/((1.0_wp - poisson_1**2)/modulus_1 + (1.0_wp - poisson_2**2)/modulus_2)
   end function equivalent_modulus

   !> Set how heights are distributed.
   pure subroutine set_heights(properties, error, height_distribution, skewness, kurtosis)
      type(normal_properties), intent(inout) :: properties
      type(error_type), allocatable, intent(inout) :: error
      integer, intent(in), optional :: height_distribution
      real(wp), intent(in), optional :: skewness, kurtosis

      associate (p => properties)
         p%height_distribution = heights_gaussian
         if (present(height_distribution)) p%height_distribution = height_distribution
         p%skewness = 0.0_wp
         p%kurtosis = 3.0_wp
         p%heights = johnson_heights()
         p%vanishing_separation = vanishing_height*p%sigma
         p%judged_separation = p%vanishing_separation
         if (p%height_distribution == heights_gaussian) return
         if (p%height_distribution /= heights_johnson) then
            call fatal_error(error, 'height_distribution = '//to_text(p%height_distribution)// &
               ' is unknown: 0 is gaussian, 1 is johnson', subject='height_distribution')
            return
         end if
         if (present(skewness)) p%skewness = skewness
         if (present(kurtosis)) p%kurtosis = kurtosis
         call find_summit_heights(p%heights, p%skewness, p%kurtosis, error)
         if (allocated(error) .or. p%heights%is_gaussian) return
         p%vanishing_separation = height_of(p%heights, vanishing_height)*p%sigma
         p%judged_separation = height_of(p%heights, rarest_judged)*p%sigma
      end associate
   end subroutine set_heights

   !> Set what summits do that part again; refused where the unloading branch would lie above the
   !> virgin one, or cycles create energy.
   pure subroutine set_unloading(properties, unloading, error)
      type(normal_properties), intent(inout) :: properties
      integer, intent(in) :: unloading
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: least

      properties%unloading = unloading
      if (unloading /= unloading_reversible .and. unloading /= unloading_elastic) then
         call fatal_error(error, 'unloading = '//to_text(unloading)// &
            ' is unknown: 0 is reversible, 1 is elastic', subject='unloading')
      else if (unloading == unloading_elastic &
            .and. properties%height_distribution /= heights_gaussian) then
         call fatal_error(error, 'height_distribution = johnson is not possible with elastic '// &
            'unloading: take unloading = reversible, or gaussian heights', &
            subject='height_distribution unloading')
      else if (unloading == unloading_elastic .and. properties%b3 > largest_force_exponent) then
         ! rounded upwards, so that the value told is one that passes
         least = 1.0e-4_wp*ceiling(1.0e4_wp*2.0_wp/sqrt(properties%plastic_ratio))
         call fatal_error(error, 'yield_factor = '//to_text(properties%yield_factor)// &
            ' is not allowed with elastic unloading: it must be '//to_text(least, 4)// &
            ' (2/sqrt(plastic_ratio)) or more, as summits would unload stiffer than they load '// &
            'and cycles create energy; the paper uses 0.4', subject='yield_factor')
      end if
   end subroutine set_unloading

   !> Name the first that is not allowed.
   pure subroutine refuse(error, eta, modulus, radius, hardness, yield_factor, sigma, plastic_ratio)
      type(error_type), allocatable, intent(inout) :: error
      real(wp), intent(in) :: eta, modulus, radius, hardness, yield_factor, sigma, plastic_ratio

      call check_positive(error, 'eta', eta, '1/mm^2')
      if (.not. allocated(error)) call check_positive(error, 'modulus', modulus, 'MPa')
      if (.not. allocated(error)) call check_positive(error, 'radius', radius, 'mm')
      if (.not. allocated(error)) call check_positive(error, 'hardness', hardness, 'MPa')
      if (.not. allocated(error)) call check_positive(error, 'sigma', sigma, 'mm')
      if (.not. allocated(error)) call check_range(error, 'plastic_ratio', plastic_ratio, &
         plastic_ratio_min, plastic_ratio_max, '')
      if (.not. allocated(error)) call fatal_error(error, 'yield_factor = '// &
         to_text(yield_factor)//' is not allowed: it must lie between '// &
         to_text(yield_factor_min)//' and '//to_text(nint(yield_factor_max))// &
         '; the paper uses 0.4', subject='yield_factor')
   end subroutine refuse

end module asperity_law_normal_properties

! src/contact/check_friction.f90
!> Checks of friction beyond one coefficient and one critical slip.
module asperity_contact_check_friction
   use asperity_base_checks, only: check_positive, check_range, largest_positive
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: fewest_stick_elements, friction_settings, &
      largest_friction, most_friction_points, most_stick_elements, slip_direction_associated, &
      slip_direction_of_stress, stick_critical_slip, stick_summits
   use asperity_law_normal_properties, only: heights_gaussian, normal_properties, &
      unloading_reversible
   implicit none
   private
   public :: check_friction, is_plain

   !> Largest pressure exponent; the smallest is -1, where the shear stress would not depend on the
   !> pressure, and is not allowed
   real(wp), parameter :: largest_exponent = 10.0_wp
   !> A full turn, degrees, either way
   real(wp), parameter :: largest_angle = 360.0_wp

contains

   !> Whether settings say nothing beyond one coefficient and one critical slip.
   pure logical function is_plain(settings)
      !> Any settings
      type(friction_settings), intent(in) :: settings

      associate (s => settings)
         is_plain = all([s%friction_points, s%stick] == 0) .and. .not. any(abs([ &
            s%static_friction_coefficient, s%decay_slip, s%decay_slip_rate, &
            s%friction_coefficient_across, s%pressure_exponent, s%shear_limit]) > 0.0_wp)
      end associate
   end function is_plain

   !> Set `error` when something is not allowed, with its name, value and what to do.
   pure subroutine check_friction(settings, friction_coefficient, normal, error)
      !> The settings
      type(friction_settings), intent(in) :: settings
      !> Coefficient in motion along the grain, checked
      real(wp), intent(in) :: friction_coefficient
      !> Checked properties of the normal law
      type(normal_properties), intent(in) :: normal
      !> Set when a setting is refused
      type(error_type), allocatable, intent(out) :: error

      call check_coefficients(settings, friction_coefficient, error)
      if (.not. allocated(error)) call check_grain(settings, error)
      if (.not. allocated(error)) call check_pressure(settings, error)
      if (.not. allocated(error)) call check_stick(settings, normal, error)
      if (allocated(error)) return
      if (.not. (friction_coefficient > 0.0_wp .or. is_plain(settings))) call fatal_error(error, &
         'friction_coefficient = 0 is not allowed with friction that depends on anything: it '// &
         'must be above zero, or leave out what it depends on', subject='friction_coefficient')
   end subroutine check_friction

   !> Rest and motion.
   pure subroutine check_coefficients(settings, friction_coefficient, error)
      type(friction_settings), intent(in) :: settings
      real(wp), intent(in) :: friction_coefficient
      type(error_type), allocatable, intent(inout) :: error

      associate (static => settings%static_friction_coefficient, slip => settings%decay_slip, &
            rate => settings%decay_slip_rate)
         call check_range(error, 'static_friction_coefficient', static, 0.0_wp, largest_friction, &
            '')
         if (.not. allocated(error)) call check_range(error, 'decay_slip', slip, 0.0_wp, &
            largest_positive, ' mm')
         if (.not. allocated(error)) call check_range(error, 'decay_slip_rate', rate, 0.0_wp, &
            largest_positive, ' mm/s')
         if (allocated(error)) return
         if (static > 0.0_wp .and. static < friction_coefficient) then
            call fatal_error(error, 'static_friction_coefficient = '//to_text(static)// &
               ' is not allowed: it must not be below friction_coefficient = '// &
               to_text(friction_coefficient)//', that in motion', &
               subject='static_friction_coefficient')
         else if (static > friction_coefficient .and. .not. max(slip, rate) > 0.0_wp) then
            call fatal_error(error, 'static_friction_coefficient = '//to_text(static)// &
               ' is above friction_coefficient = '//to_text(friction_coefficient)// &
               ', but nothing leads from one to the other: give decay_slip in mm, '// &
               'decay_slip_rate in mm/s, or both', subject='static_friction_coefficient')
         else if (slip > 0.0_wp .and. .not. static > 0.0_wp) then
            call fatal_error(error, 'decay_slip = '//to_text(slip)//' mm has no meaning '// &
               'without static_friction_coefficient: give that as well', subject='decay_slip')
         else if (rate > 0.0_wp .and. .not. static > 0.0_wp) then
            call fatal_error(error, 'decay_slip_rate = '//to_text(rate)//' mm/s has no '// &
               'meaning without static_friction_coefficient: give that as well', &
               subject='decay_slip_rate')
         end if
      end associate
   end subroutine check_coefficients

   !> Direction.
   pure subroutine check_grain(settings, error)
      type(friction_settings), intent(in) :: settings
      type(error_type), allocatable, intent(inout) :: error

      call check_range(error, 'friction_coefficient_across', &
         settings%friction_coefficient_across, 0.0_wp, largest_friction, '')
      if (allocated(error)) return
      if (settings%friction_coefficient_across > 0.0_wp) call check_range(error, &
         'friction_coefficient_across', settings%friction_coefficient_across, &
         1.0_wp/largest_friction, largest_friction, '')
      if (.not. allocated(error)) call check_range(error, 'grain_angle', settings%grain_angle, &
         -largest_angle, largest_angle, ' degrees')
      if (allocated(error)) return
      if (all(settings%slip_direction /= [slip_direction_associated, slip_direction_of_stress])) &
         call fatal_error(error, 'slip_direction = '//to_text(settings%slip_direction)// &
         ' is unknown: 0 is associated, 1 is stress', subject='slip_direction')
   end subroutine check_grain

   !> Pressure and shear limit.
   pure subroutine check_pressure(settings, error)
      type(friction_settings), intent(in) :: settings
      type(error_type), allocatable, intent(inout) :: error
      logical :: has_power
      integer :: i

      associate (s => settings, n => settings%friction_points)
         call check_range(error, 'pressure_exponent', s%pressure_exponent, -1.0_wp, &
            largest_exponent, '')
         if (.not. allocated(error)) call check_range(error, 'reference_pressure', &
            s%reference_pressure, 0.0_wp, largest_positive, ' MPa')
         if (.not. allocated(error)) call check_range(error, 'shear_limit', s%shear_limit, &
            0.0_wp, largest_positive, ' MPa')
         if (allocated(error)) return
         has_power = abs(s%pressure_exponent) > 0.0_wp
         if (.not. s%pressure_exponent > -1.0_wp) then
            call fatal_error(error, 'pressure_exponent = '//to_text(s%pressure_exponent)// &
               ' is not allowed: it must be above -1, as friction would not rise with the '// &
               'pressure; for a shear stress without it, use shear_limit', &
               subject='pressure_exponent')
         else if (has_power .and. .not. s%reference_pressure > 0.0_wp) then
            call fatal_error(error, 'pressure_exponent = '//to_text(s%pressure_exponent)// &
               ' needs reference_pressure: the pressure, MPa, at which the coefficients hold', &
               subject='pressure_exponent')
         else if (n < 0 .or. n > most_friction_points) then
            call fatal_error(error, 'friction_points = '//to_text(n)//' is not allowed: '// &
               'there are 0 to '//to_text(most_friction_points)//' points of pressure and factor', &
               subject='friction_points')
         else if (has_power .and. n > 0) then
            call fatal_error(error, 'friction_points and pressure_exponent = '// &
               to_text(s%pressure_exponent)//' exclude each other: give one of them', &
               subject='friction_points pressure_exponent')
         end if
         if (allocated(error)) return
         do i = 1, n
            call check_range(error, 'pressure '//to_text(i)//' of friction_points', &
               s%friction_pressures(i), 0.0_wp, largest_positive, ' MPa')
            if (.not. allocated(error)) call check_range(error, 'factor '//to_text(i)// &
               ' of friction_points', s%friction_factors(i), 1.0_wp/largest_friction, &
               largest_friction, '')
            if (allocated(error)) exit
         end do
         do i = 2, n
            if (allocated(error)) exit
            if (.not. s%friction_pressures(i) > s%friction_pressures(i - 1)) call fatal_error( &
               error, 'pressure '//to_text(i)//' of friction_points = '// &
               to_text(s%friction_pressures(i))//' MPa is not above the one before: '// &
               'pressures must rise')
         end do
         if (allocated(error)) then
            deallocate (error%subject)
            allocate (error%subject, source='friction_points')
         end if
      end associate
   end subroutine check_pressure

   !> What sticks before it slides.
   pure subroutine check_stick(settings, normal, error)
      type(friction_settings), intent(in) :: settings
      type(normal_properties), intent(in) :: normal
      type(error_type), allocatable, intent(inout) :: error

      associate (s => settings)
         if (s%stick == stick_critical_slip) return
         if (s%stick /= stick_summits) then
            call fatal_error(error, 'stick = '//to_text(s%stick)// &
               ' is unknown: 0 is critical_slip, 1 is summits', subject='stick')
            return
         end if
         if (s%stick_elements /= 0 .and. (s%stick_elements < fewest_stick_elements &
            .or. s%stick_elements > most_stick_elements)) call fatal_error(error, &
            'stick_elements = '//to_text(s%stick_elements)//' is not allowed: it must be '// &
            to_text(fewest_stick_elements)//' to '//to_text(most_stick_elements), &
            subject='stick_elements')
         if (allocated(error)) return
         if (abs(s%shear_modulus) > 0.0_wp) then
            call check_positive(error, 'shear_modulus', s%shear_modulus, 'MPa')
         else
            call fatal_error(error, 'stick = summits needs shear_modulus: the equivalent shear '// &
               'modulus G* of the two faces, MPa, 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2', &
               subject='shear_modulus')
         end if
         if (allocated(error)) return
         if (s%static_friction_coefficient > 0.0_wp) then
            call refuse_beside(error, 'static_friction_coefficient', s%static_friction_coefficient)
         else if (s%friction_coefficient_across > 0.0_wp) then
            call refuse_beside(error, 'friction_coefficient_across', s%friction_coefficient_across)
         else if (normal%unloading /= unloading_reversible) then
            call fatal_error(error, 'stick = summits is for summits without memory: use '// &
               'unloading = reversible, or stick = critical_slip', subject='stick')
         else if (normal%height_distribution /= heights_gaussian) then
            call fatal_error(error, 'stick = summits is for Gaussian heights: use '// &
               'height_distribution = gaussian, or stick = critical_slip', subject='stick')
         end if
      end associate
   end subroutine check_stick

   !> Something that summits cannot have.
   pure subroutine refuse_beside(error, name, value)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value

      call fatal_error(error, 'stick = summits is for one coefficient in all directions, at '// &
         'rest and in motion: leave out '//name//' = '//to_text(value)// &
         ', or use stick = critical_slip', subject='stick '//name)
   end subroutine refuse_beside

end module asperity_contact_check_friction

! src/law/compiled_intervals.f90
!> Intervals of h = d/sigma, or of the Gaussian number that belongs to d, that the compiled law has
!> a polynomial each for.
module asperity_law_compiled_intervals
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: intervals_below, place_interval

   !> Ends of the three ranges of h, and intervals per unit of h in each
   real(wp), parameter, public :: first = -8.0_wp, last = 38.0_wp
   real(wp), parameter :: second = 2.0_wp
   !> Up to here from the mean plane the error is below 1e-10, beyond below 1e-9
   real(wp), parameter, public :: precise_reach = 8.0_wp
   integer, parameter :: coarse = 5, fine = 21
   real(wp), parameter :: far = 1.5_wp
   !> Of heights that are not Gaussian the law has more detail: as many intervals, all of one width,
   !> between these
   real(wp), parameter, public :: first_of_johnson = -3.5_wp, last_of_johnson = 8.0_wp
   !> Number of intervals: in the first two ranges, and in all
   integer, parameter, public :: n_near = &
      nint((second - first)*coarse + (precise_reach - second)*fine)
   integer, parameter, public :: n_all = n_near + nint((last - precise_reach)*far)

contains

   !> Middle and half width of an interval of h.
   pure subroutine place_interval(i, is_gaussian, middle, half_width)
      !> Its number, 1 to `n_all`
      integer, intent(in) :: i
      !> Whether heights are Gaussian
      logical, intent(in) :: is_gaussian
      !> Both of h
      real(wp), intent(out) :: middle, half_width
      integer, parameter :: n_first = nint((second - first)*coarse)

      if (.not. is_gaussian) then
         half_width = 0.5_wp*(last_of_johnson - first_of_johnson)/n_all
         middle = first_of_johnson + half_width*(2*i - 1)
      else if (i <= n_first) then
         half_width = 0.5_wp/coarse
         middle = first + half_width*(2*i - 1)
      else if (i <= n_near) then
         half_width = 0.5_wp/fine
         middle = second + half_width*(2*(i - n_first) - 1)
      else
         half_width = 0.5_wp/far
         middle = precise_reach + half_width*(2*(i - n_near) - 1)
      end if
   end subroutine place_interval

   !> Number of intervals that lie below h, with a fraction.
   pure elemental real(wp) function intervals_below(h, is_gaussian)
      !> The variable
      real(wp), intent(in) :: h
      !> Whether heights are Gaussian
      logical, intent(in) :: is_gaussian

      if (.not. is_gaussian) then
         intervals_below = (h - first_of_johnson)*(n_all/(last_of_johnson - first_of_johnson))
         return
      end if
      intervals_below = (min(h, second) - first)*coarse &
         + min(max(h - second, 0.0_wp), precise_reach - second)*fine &
         + max(h - precise_reach, 0.0_wp)*far
   end function intervals_below

end module asperity_law_compiled_intervals

! src/law/hermite_polynomial.f90
!> The polynomial of degree seven that has given values and slopes at four points of an interval:
!> both ends and the inner Gauss-Lobatto points. Neighbours share values and slopes at their ends.
module asperity_law_hermite_polynomial
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: hermite_polynomial

   !> Degree of the polynomial
   integer, parameter, public :: degree = 7
   !> The points from the middle of the interval, over half its width
   real(wp), parameter, public :: hermite_points(4) = &
      [-1.0_wp, -0.447213595499957939281834733746255247_wp, &
      0.447213595499957939281834733746255247_wp, 1.0_wp]
   !> Their squares
   real(wp), parameter :: inner = 0.2_wp, outer = 1.0_wp

contains

   !> Coefficients of the powers of t, measured from the middle of the interval.
   pure function hermite_polynomial(values, slopes, half_width) result(c)
      !> At the four points, in ascending order
      real(wp), intent(in) :: values(4), slopes(4)
      !> Half the width of the interval
      real(wp), intent(in) :: half_width
      real(wp) :: c(0:degree)
      real(wp) :: s(4), slope(2), value(2)
      integer :: i

      ! with z = s^2, the even part is a cubic of z and the odd part s times another
      s = half_width*slopes
      value = 0.5_wp*[values(2) + values(3), values(1) + values(4)]
      slope = 0.25_wp*[s(3) - s(2), s(4) - s(1)]/hermite_points(3:4)
      c(0:6:2) = cubic(value, slope)
      value = 0.5_wp*[values(3) - values(2), values(4) - values(1)]/hermite_points(3:4)
      slope = 0.5_wp*(0.5_wp*[s(2) + s(3), s(1) + s(4)] - value)/[inner, outer]
      c(1:7:2) = cubic(value, slope)
      do i = 1, degree
         c(i) = c(i)/half_width**i
      end do
   end function hermite_polynomial

   !> Cubic with given values and slopes at the two squares, by powers.
   pure function cubic(value, slope) result(c)
      real(wp), intent(in) :: value(2), slope(2)
      real(wp) :: c(0:3)
      real(wp), parameter :: width = outer - inner
      real(wp) :: mean, bend, twist

      mean = (value(2) - value(1))/width
      bend = (mean - slope(1))/width
      twist = (slope(1) + slope(2) - 2.0_wp*mean)/width**2
      ! value + slope y + bend y^2 + twist y^2 (y - width), y = z - inner
      c(3) = twist
      c(2) = bend - twist*(2.0_wp*inner + outer)
      c(1) = slope(1) - 2.0_wp*inner*bend + twist*inner*(inner + 2.0_wp*outer)
      c(0) = value(1) - inner*slope(1) + inner**2*bend - twist*inner**2*outer
   end function cubic

end module asperity_law_hermite_polynomial

! src/law/exponential.f90
!> The exponential function of many arguments at once, in a form that compilers turn into vector
!> instructions; the intrinsic is a call for each argument.
module asperity_law_exponential
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: exponentials

   !> Arguments that are handled side by side
   integer, parameter, public :: exponential_block = 4
   !> exp(x) = 2^(k/4) exp(r), |r| <= ln(2)/8; the first part of ln(2)/4 ends in 24 zero bits
   real(wp), parameter :: quarters_of_ln2 = 5.7707801635558536294_wp
   real(wp), parameter :: ln2_high = 0.17328679468482733_wp
   real(wp), parameter :: ln2_low = 4.5515899962603654599e-10_wp
   !> Keeps k positive where it is cut, so that cutting is rounding down
   integer, parameter :: offset = 600
   real(wp), parameter :: quarter_powers(0:3) = [1.0_wp, 1.1892071150027210667_wp, &
      1.4142135623730950488_wp, 1.6817928305074290861_wp]
   !> (exp(r) - 1 - r)/r^2 to 1.3e-17 of exp(r)
   real(wp), parameter :: c(0:6) = [ &
      0.5_wp, 0.16666666666679419891_wp, 0.041666666666679419637_wp, &
      0.0083333331974283901012_wp, 0.0013888888752986457607_wp, 0.0001984489046255152309_wp, &
      0.000024805207871390875803_wp]

contains

   !> exp(x) to 1.5 eps relative for -100 <= x <= 10; what is not a number stays none.
   pure subroutine exponentials(n, x, values)
      !> Number of arguments, a multiple of `exponential_block`
      integer, intent(in) :: n
      !> Arguments, between -100 and 10
      real(wp), intent(in) :: x(n)
      !> Their exponentials
      real(wp), intent(out) :: values(n)
      integer, parameter :: m = exponential_block
      real(wp) :: r, s, power
      integer :: i, j, quarters
      !> 2^((i - offset)/4)
      real(wp), parameter :: power_of_2(0:offset + 60) = [(quarter_powers(modulo(i, 4)) &
         *2.0_wp**((i - offset - modulo(i, 4))/4), i=0, offset + 60)]

      do i = 0, n - m, m
         do j = i + 1, i + m
            ! positive before it is cut, so that cutting is rounding to nearest; the integer that
            ! stands for what is not a number must be no index out of bounds
            quarters = max(int(x(j)*quarters_of_ln2 + (offset + 0.5_wp)), 0)
            r = real(quarters - offset, wp)
            r = (x(j) - r*ln2_high) - r*ln2_low
            s = r*r
            power = ((c(0) + c(1)*r) + s*(c(2) + c(3)*r)) + s*s*((c(4) + c(5)*r) + s*c(6))
            values(j) = power_of_2(quarters)*(1.0_wp + (r + s*power))
         end do
      end do
   end subroutine exponentials

end module asperity_law_exponential

! src/law/quadrature/fixed_points.f90
!> Points for integrals over the deformations of elasto-plastic summits where w1 is small against
!> sigma and w2/w1 is 110, its default: then they are constants in w/w1, a generalised Gauss rule
!> for the powers of w/w1 that force, slope, work and area are, times the density of heights, over
!> ln(w/w1). Numbers from test/reference/fixed_rule_constants.py.
module asperity_law_quadrature_fixed_points
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: default_plastic_ratio
   implicit none
   private
   public :: find_force_powers

   !> Number of points; a multiple of what `exponentials` handles side by side
   integer, parameter, public :: n_points = 20

   !> ln(w/w1) and w/w1 at the points, and weights
   real(wp), parameter, public :: log_ratio(n_points) = [ &
      0.048619530946669133_wp, 0.26399868768473883_wp, 0.61550950897068935_wp, &
      0.96416179633346744_wp, 1.2229071394298781_wp, 1.4895510765996129_wp, &
      1.7955539710073689_wp, 2.1891923339999781_wp, 2.5801607264950008_wp, &
      2.9383367563284768_wp, 3.2590740162331016_wp, 3.5436531606432351_wp, &
      3.7944120320565355_wp, 4.0132971254390029_wp, 4.2015123629184101_wp, &
      4.3596074127275086_wp, 4.4877215482122645_wp, 4.5858136106106135_wp, &
      4.6537996956595515_wp, 4.6916181468231164_wp]
   real(wp), parameter, public :: ratio(n_points) = [ &
      1.0498208504009704_wp, 1.3021264874993114_wp, 1.8505992563141407_wp, &
      2.6225884716482009_wp, 3.397049087858777_wp, 4.4351040500373866_wp, &
      6.0228102600931713_wp, 8.927999360407236_wp, 13.19925945988881_wp, &
      18.884410800289724_wp, 26.025426858577697_wp, 34.593062654419096_wp, &
      44.452092315037193_wp, 55.328996794803534_wp, 66.78726127749217_wp, &
      78.226417698020276_wp, 88.918618115356492_wp, 98.082956021044298_wp, &
      104.98313263265845_wp, 109.02946282194249_wp]
   real(wp), parameter, public :: weight(n_points) = [ &
      0.12707238911149057_wp, 0.29828143160185056_wp, 0.38146746498797651_wp, &
      0.28718707690258494_wp, 0.26878935990223768_wp, 0.25732529983185004_wp, &
      0.36732728073886955_wp, 0.40165336640313309_wp, 0.37633868477986021_wp, &
      0.33947315830579056_wp, 0.30227910626623156_wp, 0.26728907906754784_wp, &
      0.23455769245582775_wp, 0.20341107092152341_wp, 0.17310654370586018_wp, &
      0.14310274294448513_wp, 0.11311642828080093_wp, 0.08305289517656804_wp, &
      0.052907604696516217_wp, 0.022741690081271134_wp]

   !> ln(w/w1) in the middle of the range, where w/w1 is sqrt(110)
   real(wp), parameter, public :: middle = 0.5_wp*log(default_plastic_ratio)
   real(wp), parameter :: from_middle(n_points) = log_ratio - middle
   !> The exponent b3 - 1 in the middle of its range, for yield factors of 0.05 to 1
   real(wp), parameter, public :: middle_exponent = 0.5_wp*log(80.0_wp)/log(default_plastic_ratio)
   !> exp(x) by powers of x to 3e-17 for |x| <= 0.75
   real(wp), parameter :: c(0:13) = [ &
      1.0000000000000000252_wp, 1.0000000000000000017_wp, 0.49999999999999561758_wp, &
      0.16666666666666637479_wp, 0.041666666666791307047_wp, 0.0083333333333416348251_wp, &
      0.0013888888875597155042_wp, 0.00019841269832416821368_wp, 0.000024801594050048587676_wp, &
      2.7557323719055683797e-6_wp, 2.7555560990967492842e-7_wp, 2.50509371405524587e-8_wp, &
      2.1103715506256629742e-9_wp, 1.6210260812877196512e-10_wp]

contains

   !> (w/(sqrt(110) w1))^(b3 - 1 - `middle_exponent`) at the points. Its logarithm is 0.75 in size
   !> at most, so that one polynomial is enough.
   pure subroutine find_force_powers(b3_less_1, powers)
      !> Exponent of the force less one; for yield factors of 0.05 to 1
      real(wp), intent(in) :: b3_less_1
      !> The powers
      real(wp), intent(out) :: powers(n_points)
      real(wp) :: x, s
      integer :: i

      do i = 1, n_points
         x = (b3_less_1 - middle_exponent)*from_middle(i)
         s = x*x
         powers(i) = (c(0) + s*(c(2) + s*(c(4) + s*(c(6) + s*(c(8) + s*(c(10) + s*c(12))))))) &
            + x*(c(1) + s*(c(3) + s*(c(5) + s*(c(7) + s*(c(9) + s*(c(11) + s*c(13)))))))
      end do
   end subroutine find_force_powers

end module asperity_law_quadrature_fixed_points

! src/law/quadrature/gauss_legendre.f90
!> Gauss-Legendre rule of 48 points on [-1, 1]: enough for a Gaussian cut at exp(-45) of its
!> peak times a smooth factor, to round-off.
module asperity_law_quadrature_gauss_legendre
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: pairwise_sum

   integer, parameter :: n_half = 24
   !> Number of points
   integer, parameter, public :: n_points = 2*n_half

   real(wp), parameter :: half_nodes(n_half) = [ &
      0.03238017096286936203332_wp, 0.09700469920946269893005_wp, 0.1612223560688917180564_wp, &
      0.2247637903946890612249_wp, 0.2873624873554555767359_wp, 0.3487558862921607381598_wp, &
      0.4086864819907167299162_wp, 0.4669029047509584045449_wp, 0.5231609747222330336782_wp, &
      0.5772247260839727038178_wp, 0.6288673967765136239952_wp, 0.6778723796326639052119_wp, &
      0.7240341309238146546745_wp, 0.7671590325157403392539_wp, 0.8070662040294426270826_wp, &
      0.8435882616243935307111_wp, 0.8765720202742478859057_wp, 0.9058791367155696728221_wp, &
      0.9313866907065543331142_wp, 0.952987703160430860723_wp, 0.9705915925462472504614_wp, &
      0.9841245837228268577446_wp, 0.9935301722663507575479_wp, 0.9987710072524261186005_wp]
   real(wp), parameter :: half_weights(n_half) = [ &
      0.06473769681268392250302_wp, 0.0644661644359500822065_wp, 0.06392423858464818662391_wp, &
      0.06311419228625402565713_wp, 0.0620394231598926639042_wp, 0.06070443916589388005297_wp, &
      0.05911483969839563574647_wp, 0.05727729210040321570515_wp, 0.0551995036999841628682_wp, &
      0.05289018948519366709551_wp, 0.05035903555385447495781_wp, 0.04761665849249047482591_wp, &
      0.04467456085669428041945_wp, 0.04154508294346474921406_wp, 0.03824135106583070631722_wp, &
      0.03477722256477043889255_wp, 0.03116722783279808890207_wp, 0.02742650970835694820007_wp, &
      0.02357076083932437914052_wp, 0.01961616045735552781446_wp, 0.01557931572294384872818_wp, &
      0.01147723457923453948959_wp, 0.007327553901276262102384_wp, 0.003153346052305838632677_wp]

   !> Points in ascending order
   real(wp), parameter, public :: nodes(n_points) = &
      [-half_nodes(n_half:1:-1), half_nodes]
   !> Their weights, of sum 2
   real(wp), parameter, public :: weights(n_points) = &
      [half_weights(n_half:1:-1), half_weights]
contains

   !> Sum with the round-off of log2(48) additions instead of 48.
   pure real(wp) function pairwise_sum(terms)
      !> Terms of a quadrature
      real(wp), intent(in) :: terms(n_points)
      integer, parameter :: n = n_points/16
      real(wp) :: halves(8*n)

      halves = terms(:8*n) + terms(8*n + 1:)
      halves(:4*n) = halves(:4*n) + halves(4*n + 1:)
      halves(:2*n) = halves(:2*n) + halves(2*n + 1:4*n)
      halves(:n) = halves(:n) + halves(n + 1:2*n)
      pairwise_sum = sum(halves(:n))
   end function pairwise_sum

end module asperity_law_quadrature_gauss_legendre

! src/law/quadrature/heights.f90
!> Quadrature over summit heights: Gauss points and weights for integrals of functions that are
!> smooth in sqrt(w) or in ln(w), times the Gaussian density of heights, over a range of
!> deformations w.
module asperity_law_quadrature_heights
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: density_reach, phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   implicit none
   private
   public :: quadrature_type, new_quadrature, new_log_quadrature, find_dense_range, &
      relative_exponent

   !> Gauss points, one column a panel. The weights hold the density of heights, to be multiplied
   !> by exp(-exponent - max(h, 0)^2/2), which makes it one at its largest.
   type :: quadrature_type
      !> Number of panels used
      integer :: panels = 0
      !> Points w/w1, and weights
      real(wp) :: ratio(n_points, 2), weight(n_points, 2)
      !> ln(w/w1), from `new_log_quadrature`
      real(wp) :: log_ratio(n_points, 2)
      !> See above; never negative
      real(wp) :: exponent = 0.0_wp
   end type quadrature_type

   !> Ranges that end beyond this many sigma are split; from 2 to 16 is as exact
   real(wp), parameter :: wide = 4.0_wp
   !> Points are even in ln(w) where the range of ln(w) is longer than this and d/sigma above
   !> -1: shorter ranges gain nothing, and around w = -d the density has only the width sigma/|d|
   real(wp), parameter :: shortest = 1.0_wp, lowest = -1.0_wp

contains

   !> Gauss points for integrals over the deformations from..to of functions that are smooth in
   !> sqrt(w), times the density, cut to where the density matters.
   pure function new_quadrature(properties, separation, from, to) result(rule)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Range of the deformation w, mm
      real(wp), intent(in) :: from, to
      type(quadrature_type) :: rule
      real(wp) :: anchor, y, lower, upper

      call place_anchor(rule, properties, separation, from, to, anchor, y, lower, upper)
      if (rule%panels == 0) call add_panels(rule, properties, anchor, y, lower, upper)
   end function new_quadrature

   !> The same for functions that are smooth in ln(w), and with the logarithms; `from` is above
   !> zero.
   pure function new_log_quadrature(properties, separation, from, to) result(rule)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Range of the deformation w, mm
      real(wp), intent(in) :: from, to
      type(quadrature_type) :: rule
      real(wp) :: anchor, y, lower, upper, center, first, last
      integer :: i

      call place_anchor(rule, properties, separation, from, to, anchor, y, lower, upper)
      if (rule%panels == 0) then
         center = anchor/properties%sigma
         first = log(1.0_wp + lower/center)
         last = log(1.0_wp + upper/center)
         if (last - first > shortest .and. y - center > lowest) then
            call add_log_panel(rule, properties, anchor, y, first, last)
            return
         end if
         call add_panels(rule, properties, anchor, y, lower, upper)
      end if
      do i = 1, rule%panels
         rule%log_ratio(:, i) = log(rule%ratio(:, i))
      end do
   end function new_log_quadrature

   !> Find the range about the anchor; where it lies inside from..to on both sides, its panel is
   !> added.
   pure subroutine place_anchor(rule, properties, separation, from, to, anchor, y, lower, upper)
      type(quadrature_type), intent(out) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, from, to
      !> See `find_dense_range`
      real(wp), intent(out) :: anchor, y, lower, upper
      real(wp) :: reach

      call find_dense_range(properties, separation, from, to, anchor, y, lower, upper, &
         rule%exponent)
      reach = density_reach(y)
      if (lower > (from - anchor)/properties%sigma .and. upper < (to - anchor)/properties%sigma) &
         call add_bell(rule, properties, anchor, reach)
   end subroutine place_anchor

   !> Find the anchor, the densest point of a range of deformations, from which lengths are
   !> measured, so that nothing is lost where the range is narrow and far from zero; and the range
   !> about it, cut to where the density matters.
   pure subroutine find_dense_range(properties, separation, from, to, anchor, y, lower, upper, &
         exponent)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Range of the deformation w, mm
      real(wp), intent(in) :: from, to
      !> Anchor, mm; height there over sigma; range about it, in sigma
      real(wp), intent(out) :: anchor, y, lower, upper
      !> Of the density at the anchor, less max(h, 0)^2/2
      real(wp), intent(out) :: exponent
      real(wp) :: reach

      anchor = min(max(-separation, from), to)
      y = (separation + anchor)/properties%sigma
      reach = density_reach(y)
      lower = max((from - anchor)/properties%sigma, -reach)
      upper = min((to - anchor)/properties%sigma, reach)
      exponent = relative_exponent(separation/properties%sigma, anchor/properties%sigma, y)
   end subroutine find_dense_range

   !> Add the Gauss points in lower..upper sigma beyond the anchor, in one panel or two: the
   !> density narrows in sqrt(w), so a wide range is split at a quarter of its upper end (1/16 to
   !> 3/4 are as exact).
   pure subroutine add_panels(rule, properties, anchor, y, lower, upper)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, y, lower, upper
      real(wp) :: root_split

      associate (center => anchor/properties%sigma)
         root_split = 0.25_wp*(center + upper) - center
         if (center + upper > wide .and. lower < root_split) then
            call add_panel(rule, properties, anchor, y, lower, root_split)
            call add_panel(rule, properties, anchor, y, root_split, upper)
         else
            call add_panel(rule, properties, anchor, y, lower, upper)
         end if
      end associate
   end subroutine add_panels

   !> Add the Gauss points between the logarithms of w/anchor, spread evenly in ln(w).
   pure subroutine add_log_panel(rule, properties, anchor, y, first, last)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, y, first, last
      real(wp) :: center, half
      real(wp), dimension(n_points) :: x, growth, t, density

      center = anchor/properties%sigma
      half = 0.5_wp*(last - first)
      x = 0.5_wp*(last + first) + half*nodes
      call exponentials(n_points, x, growth)
      t = center*(growth - 1.0_wp)
      call exponentials(n_points, -t*(y + 0.5_wp*t), density)
      rule%panels = 1
      rule%log_ratio(:, 1) = log(anchor/properties%w1) + x
      rule%ratio(:, 1) = anchor/properties%w1*growth
      rule%weight(:, 1) = (phi_0*half*center)*weights*growth*density
   end subroutine add_log_panel

   !> Add the Gauss points in lower..upper sigma beyond the anchor, spread evenly in sqrt(w). The
   !> density is phi(y + t) at t sigma beyond it. Each w is rounded for itself, so that the errors
   !> of the points average out, and the points are set from the denser end, which keeps it sharp.
   pure subroutine add_panel(rule, properties, anchor, y, lower, upper)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, y, lower, upper
      real(wp) :: start, first, last, half
      real(wp), dimension(n_points) :: w, t, beyond, density

      associate (sigma => properties%sigma)
         ! roots of w/sigma, then less that of the anchor
         start = sqrt(anchor/sigma)
         first = sqrt(max(anchor/sigma + lower, 0.0_wp))
         last = sqrt(max(anchor/sigma + upper, 0.0_wp))
         half = 0.5_wp*(upper - lower)/max(last + first, tiny(1.0_wp))
         if (abs(upper) < abs(lower)) then
            beyond = upper/max(last + start, tiny(1.0_wp)) - half*(1.0_wp - nodes)
         else
            first = lower/max(first + start, tiny(1.0_wp))
            beyond = first + half*(1.0_wp + nodes)
         end if
         t = beyond*(2.0_wp*start + beyond)
         w = max(anchor + sigma*t, 0.0_wp)
         rule%panels = rule%panels + 1
         rule%ratio(:, rule%panels) = w/properties%w1
         call exponentials(n_points, -t*(y + 0.5_wp*t), density)
         rule%weight(:, rule%panels) = (2.0_wp*phi_0*half)*weights*sqrt(w/sigma)*density
      end associate
   end subroutine add_panel

   !> Add the Gauss points of the whole bell around the anchor, spread evenly in w: nothing happens
   !> at its ends, and fixed points have no noise.
   pure subroutine add_bell(rule, properties, anchor, reach)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, reach
      real(wp), dimension(n_points) :: t, density

      t = reach*nodes
      call exponentials(n_points, -0.5_wp*t*t, density)
      rule%panels = 1
      rule%ratio(:, 1) = (anchor + properties%sigma*t)/properties%w1
      rule%weight(:, 1) = (phi_0*reach)*weights*density
   end subroutine add_bell

   !> Exponent y^2/2 of the density where a piece is densest, at y = h + t, less max(h, 0)^2/2:
   !> not as a difference of squares, which would lose digits of small shares.
   pure real(wp) function relative_exponent(h, t, y)
      !> d/sigma
      real(wp), intent(in) :: h
      !> Deformation over sigma at the densest point
      real(wp), intent(in) :: t
      !> Their sum; zero where the whole piece lies on the far side of the mean plane
      real(wp), intent(in) :: y

      if (h > 0.0_wp) then
         relative_exponent = t*(h + 0.5_wp*t)
      else
         relative_exponent = 0.5_wp*y*y
      end if
   end function relative_exponent

end module asperity_law_quadrature_heights

! src/law/quadrature/pieces_by_quadrature.f90
!> The three pieces of the normal law: integrals over elastic, elasto-plastic and plastic summits,
!> the first two by quadrature that fits any properties and separation, the last in closed form.
module asperity_law_quadrature_pieces_by_quadrature
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, pairwise_sum
   use asperity_law_quadrature_heights, only: new_log_quadrature, new_quadrature, quadrature_type, &
      relative_exponent
   implicit none
   private
   public :: piece_type, elastic_piece, elastoplastic_piece, plastic_piece

   !> Integrals over one piece, to be multiplied by exp(-exponent - max(h, 0)^2/2). Without default
   !> values, which flang sets by library calls that take as long as the piece itself.
   type :: piece_type
      !> Force, its slope, area, its slope and energy, in units of N1, N1/w1, pi R w1, pi R, N1 w1
      real(wp) :: pressure, stiffness, area, area_slope, energy
      !> Of an elasto-plastic energy what unloading gives back and what it does not (see
      !> `asperity_law_unloading_law`), on request; their sum is the energy
      real(wp) :: recoverable, dissipation
      !> See above; never negative
      real(wp) :: exponent
   end type piece_type

   !> The piece of no summits
   type(piece_type), parameter, public :: no_summits = piece_type(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
      0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp)

contains

   !> Integrals of the force, its slope, area and energy over elastic summits, in units of N1,
   !> N1/w1, pi R w1 and N1 w1, and of the area's slope in pi R. The summits are those of
   !> deformations up to `largest`, w1 or less.
   pure function elastic_piece(properties, separation, largest) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, largest
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp), dimension(n_points) :: force_slope, force
      integer :: i

      rule = new_quadrature(properties, separation, 0.0_wp, largest)
      piece = no_summits
      piece%exponent = rule%exponent
      do i = 1, rule%panels
         associate (ratio => rule%ratio(:, i), weight => rule%weight(:, i))
            force_slope = weight*sqrt(ratio)
            force = force_slope*ratio
            piece%stiffness = piece%stiffness + 1.5_wp*pairwise_sum(force_slope)
            piece%pressure = piece%pressure + pairwise_sum(force)
            piece%area = piece%area + pairwise_sum(weight*ratio)
            piece%energy = piece%energy + 0.4_wp*pairwise_sum(force*ratio)
            piece%area_slope = piece%area_slope + pairwise_sum(weight)
         end associate
      end do
   end function elastic_piece

   !> The same over elasto-plastic summits.
   pure function elastoplastic_piece(properties, separation, with_memory) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      !> Whether recoverable energy and dissipation are wanted
      logical, intent(in) :: with_memory
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp), dimension(n_points) :: force, area, work, recoverable
      real(wp) :: inverse
      integer :: i

      rule = new_log_quadrature(properties, separation, properties%w1, properties%w2)
      piece = no_summits
      piece%exponent = rule%exponent
      inverse = 1.0_wp/(properties%b3 + 1.0_wp)
      do i = 1, rule%panels
         associate (ratio => rule%ratio(:, i), weight => rule%weight(:, i), b2 => properties%b2)
            call exponentials(n_points, properties%b3_less_1*rule%log_ratio(:, i), force)
            call exponentials(n_points, b2*rule%log_ratio(:, i), area)
            if (with_memory) then
               ! 2/5 of force times recovery, the force over the root of the area
               recoverable = 0.4_wp*(ratio*force)**2/sqrt(area)
               work = 0.4_wp - inverse + inverse*ratio**2*force
               piece%recoverable = piece%recoverable + pairwise_sum(weight*recoverable)
               piece%dissipation = piece%dissipation + pairwise_sum(weight*(work - recoverable))
            end if
            force = weight*ratio*force
            area = weight*area
            piece%stiffness = piece%stiffness + properties%b3*pairwise_sum(force/ratio)
            piece%pressure = piece%pressure + pairwise_sum(force)
            piece%area = piece%area + pairwise_sum(area)
            piece%area_slope = piece%area_slope + b2*pairwise_sum(area/ratio)
            piece%energy = piece%energy &
               + pairwise_sum((0.4_wp - inverse)*weight + inverse*force*ratio)
         end associate
      end do
   end function elastoplastic_piece

   !> The same over plastic summits, in closed form: force and area are linear in w.
   pure function plastic_piece(properties, separation) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type) :: piece
      real(wp) :: a, b, y, moments(0:2), slope

      a = properties%w1/properties%sigma
      b = properties%w2/properties%sigma
      y = (separation + properties%w2)/properties%sigma
      call find_tail_moments(y, moments)
      piece = no_summits
      ! moments of y < 0 are not scaled
      piece%exponent = relative_exponent(separation/properties%sigma, b, max(y, 0.0_wp))
      slope = 2.0_wp/properties%yield_factor
      piece%stiffness = slope*moments(0)
      piece%area_slope = 2.0_wp*moments(0)
      piece%area = 2.0_wp*(moments(1) + b*moments(0))/a
      piece%pressure = slope*(moments(1) + b*moments(0))/a
      piece%energy = properties%energy_2/(properties%n1*properties%w1)*moments(0) &
         + 0.5_wp*slope*(moments(2) + 2.0_wp*b*moments(1))/(a*a)
   end function plastic_piece

end module asperity_law_quadrature_pieces_by_quadrature

! src/law/quadrature/pieces_by_fixed_rule.f90
!> The elastic and the elasto-plastic piece of the normal law where w1 is small against sigma: the
!> one by the power series of the density, the other on the points of a fixed rule, few and
!> constant where w2/w1 is its default; neither takes a power function. Ten times faster than the
!> general quadrature, and as accurate where it serves.
module asperity_law_quadrature_pieces_by_fixed_rule
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: default_plastic_ratio, normal_properties
   use asperity_law_quadrature_fixed_points, only: find_force_powers, log_ratio, &
      middle, middle_exponent, n => n_points, ratio, weight
   use asperity_law_quadrature_pieces_by_quadrature, only: no_summits, piece_type
   implicit none
   private
   public :: fixed_pieces_serve, evaluate_fixed_pieces, fixed_elastic_piece, &
      fixed_elastoplastic_piece

   !> Largest w1/sigma, smallest d/sigma and largest product of the two: test/law/fixed_pieces.f90
   real(wp), parameter :: largest_ratio = 0.025_wp, lowest = -7.0_wp, largest_product = 0.28_wp

   !> Last power of w/w1 in the series of the density, and the powers themselves: the first that is
   !> left out is below 0.28^12/12! = 5e-16; for small products, 0.05^8/8! = 1e-15, fewer do
   integer, parameter :: last = 11, last_of_few = 7
   real(wp), parameter :: small_product = 0.05_wp
   real(wp), parameter :: power(0:last) = real([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11], wp)
   real(wp), parameter :: reciprocal(2:last) = 1.0_wp/power(2:)
   ! integrals of the powers, times those of force, its slope, area, its slope and energy
   real(wp), parameter :: elastic_force(0:last) = 1.0_wp/(power + 2.5_wp)
   real(wp), parameter :: elastic_slope(0:last) = 1.5_wp/(power + 1.5_wp)
   real(wp), parameter :: elastic_area(0:last) = 1.0_wp/(power + 2.0_wp)
   real(wp), parameter :: elastic_area_slope(0:last) = 1.0_wp/(power + 1.0_wp)
   real(wp), parameter :: elastic_energy(0:last) = 0.4_wp/(power + 3.5_wp)

   !> b2, Eq. 15
   real(wp), parameter :: plastic_area_exponent = 1.0_wp + log(2.0_wp)/log(default_plastic_ratio)
   ! weights of the elasto-plastic sums; those with the force lack what `find_force_powers` gives,
   ! that of the recoverable energy, force times recovery, its square
   real(wp), parameter :: by_log(n) = weight*ratio
   real(wp), parameter :: slope_weight(n) = by_log*exp(middle_exponent*(log_ratio - middle))
   real(wp), parameter :: force_weight(n) = slope_weight*ratio
   real(wp), parameter :: work_weight(n) = force_weight*ratio
   real(wp), parameter :: area_weight(n) = by_log*exp(plastic_area_exponent*log_ratio)
   real(wp), parameter :: recoverable_weight(n) = 0.4_wp*by_log*exp(2.0_wp*middle_exponent &
      *(log_ratio - middle) + (2.0_wp - 0.5_wp*plastic_area_exponent)*log_ratio)
   real(wp), parameter :: area_slope_weight(n) = plastic_area_exponent*by_log &
      *exp((plastic_area_exponent - 1.0_wp)*log_ratio)

contains

   !> Whether the fixed rule is accurate at a separation.
   pure logical function fixed_pieces_serve(properties, h)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      real(wp) :: a

      a = properties%w1/properties%sigma
      fixed_pieces_serve = a <= largest_ratio .and. h >= lowest .and. a*h <= largest_product &
         .and. .not. abs(properties%plastic_ratio - default_plastic_ratio) > 0.0_wp
   end function fixed_pieces_serve

   !> Both pieces, where the fixed rule serves.
   pure subroutine evaluate_fixed_pieces(properties, h, with_area_slope, with_memory, elastic, &
         elastoplastic)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      !> Whether the area's slope is wanted
      logical, intent(in) :: with_area_slope
      !> Whether recoverable energy and dissipation are wanted
      logical, intent(in) :: with_memory
      !> Integrals, with exponents of zero
      type(piece_type), intent(out) :: elastic, elastoplastic
      real(wp) :: a

      a = properties%w1/properties%sigma
      call sum_series(a, h, with_area_slope, elastic)
      call sum_points(properties, a, h, with_area_slope, with_memory, elastoplastic)
   end subroutine evaluate_fixed_pieces

   !> The elastic piece of deformations up to `largest` w1, where the fixed rule serves: that of
   !> another w1, in units of this one.
   pure function fixed_elastic_piece(properties, h, largest) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      !> Largest deformation over w1, above zero up to one
      real(wp), intent(in) :: largest
      !> Integrals, with an exponent of zero
      type(piece_type) :: piece

      call sum_series(largest*properties%w1/properties%sigma, h, .false., piece)
      piece%stiffness = piece%stiffness*sqrt(largest)
      piece%pressure = piece%pressure*largest*sqrt(largest)
      piece%area = piece%area*largest
      piece%energy = piece%energy*largest*largest*sqrt(largest)
   end function fixed_elastic_piece

   !> The elasto-plastic piece alone, with recoverable energy and dissipation, where the fixed rule
   !> serves.
   pure function fixed_elastoplastic_piece(properties, h) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      !> Integrals, with an exponent of zero
      type(piece_type) :: piece

      call sum_points(properties, properties%w1/properties%sigma, h, .false., .true., piece)
   end function fixed_elastoplastic_piece

   !> Elastic summits, by the density exp(-t (h + t/2)) at t = a w/w1 in powers of w/w1, each
   !> integrated. The coefficients are a^i/i! times Hermite polynomials of -h.
   pure subroutine sum_series(a, h, with_area_slope, piece)
      real(wp), intent(in) :: a, h
      logical, intent(in) :: with_area_slope
      type(piece_type), intent(out) :: piece
      real(wp) :: c(0:last), first, second, scale
      real(wp), dimension(0:1) :: by_force, by_slope, by_area, by_work
      integer :: most, i, j

      first = -a*h
      second = -a*a
      c(0) = 1.0_wp
      c(1) = first
      most = last
      if (abs(first) < small_product) most = last_of_few
      do i = 2, most
         c(i) = (first*c(i - 1) + second*c(i - 2))*reciprocal(i)
      end do
      by_force = 0.0_wp
      by_slope = 0.0_wp
      by_area = 0.0_wp
      by_work = 0.0_wp
      do i = 0, most, 2
         do j = 0, 1
            by_force(j) = by_force(j) + elastic_force(i + j)*c(i + j)
            by_slope(j) = by_slope(j) + elastic_slope(i + j)*c(i + j)
            by_area(j) = by_area(j) + elastic_area(i + j)*c(i + j)
            by_work(j) = by_work(j) + elastic_energy(i + j)*c(i + j)
         end do
      end do
      piece = no_summits
      scale = phi_0*a
      if (h < 0.0_wp) scale = scale*exp(-0.5_wp*h*h)
      piece%pressure = scale*(by_force(0) + by_force(1))
      piece%stiffness = scale*(by_slope(0) + by_slope(1))
      piece%area = scale*(by_area(0) + by_area(1))
      piece%energy = scale*(by_work(0) + by_work(1))
      if (with_area_slope) &
         piece%area_slope = scale*dot_product(elastic_area_slope(:most), c(:most))
   end subroutine sum_series

   !> Elasto-plastic summits, by sums over the points, in two halves side by side.
   pure subroutine sum_points(properties, a, h, with_area_slope, with_memory, piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: a, h
      logical, intent(in) :: with_area_slope, with_memory
      type(piece_type), intent(out) :: piece
      real(wp) :: t, exponent(n), density(n), powers(n), force, inverse, scale, force_scale
      real(wp), dimension(2) :: by_force, by_slope, by_work, by_area, by_range
      integer :: i, j

      if (h > 0.0_wp) then
         do i = 1, n
            t = a*ratio(i)
            exponent(i) = -t*(h + 0.5_wp*t)
         end do
      else
         exponent = -0.5_wp*(a*ratio + h)**2
      end if
      call exponentials(n, exponent, density)
      call find_force_powers(properties%b3_less_1, powers)

      by_force = 0.0_wp
      by_slope = 0.0_wp
      by_work = 0.0_wp
      by_area = 0.0_wp
      by_range = 0.0_wp
      do i = 0, n - 2, 2
         do j = 1, 2
            by_range(j) = by_range(j) + by_log(i + j)*density(i + j)
            by_area(j) = by_area(j) + area_weight(i + j)*density(i + j)
            force = powers(i + j)*density(i + j)
            by_slope(j) = by_slope(j) + slope_weight(i + j)*force
            by_force(j) = by_force(j) + force_weight(i + j)*force
            by_work(j) = by_work(j) + work_weight(i + j)*force
         end do
      end do
      piece = no_summits
      scale = phi_0*a
      ! the force in the middle of the range: (2/k)^(1/2), as it is 2/k at its upper end
      force_scale = scale*sqrt(2.0_wp/properties%yield_factor)
      inverse = 1.0_wp/(properties%b3 + 1.0_wp)
      piece%pressure = force_scale*(by_force(1) + by_force(2))
      piece%stiffness = force_scale*properties%b3*(by_slope(1) + by_slope(2))
      piece%area = scale*(by_area(1) + by_area(2))
      piece%energy = force_scale*inverse*(by_work(1) + by_work(2)) &
         + scale*(0.4_wp - inverse)*(by_range(1) + by_range(2))
      if (with_area_slope) piece%area_slope = scale*dot_product(area_slope_weight, density)
      if (with_memory) then
         piece%recoverable = scale*2.0_wp/properties%yield_factor &
            *dot_product(recoverable_weight, powers*powers*density)
         piece%dissipation = piece%energy - piece%recoverable
      end if
   end subroutine sum_points

end module asperity_law_quadrature_pieces_by_fixed_rule

! src/law/quadrature/pieces_by_johnson.f90
!> The three pieces of the normal law for heights by Johnson's distributions. The variable is the
!> Gaussian number x of a height, whose density is known in all tails: from x_0 on, that of the
!> separation, summits touch. Force is smooth in sqrt(x - x_0) for elastic summits and in
!> ln(x - x_0) beyond.
module asperity_law_quadrature_pieces_by_johnson
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: density_reach, find_tail_moments, phi_0, vanishing_height
   use asperity_law_johnson_heights, only: height_of, height_slope_at, height_step, &
      johnson_heights, normal_score
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, pairwise_sum, weights
   use asperity_law_quadrature_pieces_by_quadrature, only: no_summits, piece_type
   implicit none
   private
   public :: find_johnson_pieces, decay_score

   !> Below this number no summit that matters is
   real(wp), parameter :: lowest = -37.0_wp
   !> Widest panels: in x, over 1/s in x, and in ln(x - x_0)
   real(wp), parameter :: widest = 4.0_wp, widest_by_pole = 6.0_wp, widest_log = 4.0_wp
   !> Where yielded summits begin in x - x_0 if all have yielded: nothing is there to be lost
   real(wp), parameter :: nearest_start = 1.0e-12_wp

   !> Where the integrals over x begin, and the height of the first summit over the separation
   type :: origin_type
      real(wp) :: x, offset
   end type origin_type

contains

   !> Gaussian number x_0 of a separation, which takes the place of h = d/sigma in the factor
   !> exp(-max(h, 0)^2/2) that scaled values lack; 39 at most, where that is zero.
   pure real(wp) function decay_score(properties, separation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation

      decay_score = max(min(normal_score(properties%heights, separation/properties%sigma), &
         vanishing_height), -vanishing_height)
   end function decay_score

   !> The three pieces, by exp(-max(x_0, 0)^2/2), and the moments of the heights beyond the
   !> separation, of orders 0 and 1, likewise.
   pure subroutine find_johnson_pieces(properties, separation, pieces, moments)
      !> Checked properties, whose heights are not Gaussian
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Elastic, elasto-plastic and plastic summits
      type(piece_type), intent(out) :: pieces(3)
      !> Share of the summits in contact, and their mean deformation over sigma times that
      real(wp), intent(out) :: moments(0:1)
      type(origin_type) :: origin
      real(wp) :: ends(0:3), tail(0:2), deformation
      integer :: stage

      pieces = no_summits
      moments = 0.0_wp
      associate (p => properties, h => separation/properties%sigma)
         if (normal_score(p%heights, h) >= vanishing_height) return
         origin%x = max(decay_score(p, separation), lowest)
         origin%offset = 0.0_wp
         if (origin%x <= lowest) origin%offset = max(height_of(p%heights, lowest) - h, 0.0_wp)
         ends(0) = 0.0_wp
         ends(1) = distance_to(p%heights, origin, h, p%w1/p%sigma)
         ends(2) = max(ends(1), distance_to(p%heights, origin, h, p%w2/p%sigma))
         ends(3) = huge(1.0_wp)
         call find_tail_moments(origin%x, tail)
         moments(0) = tail(0)
         do stage = 1, 3
            call integrate(p, origin, stage, ends(stage - 1), ends(stage), pieces(stage), &
               deformation)
            moments(1) = moments(1) + deformation*exp(-pieces(stage)%exponent)
         end do
      end associate
   end subroutine find_johnson_pieces

   !> How far beyond the origin summits are deformed by b, in sigma.
   pure real(wp) function distance_to(heights, origin, h, b) result(xi)
      type(johnson_heights), intent(in) :: heights
      type(origin_type), intent(in) :: origin
      real(wp), intent(in) :: h, b
      real(wp), parameter :: short = 1.0e-3_wp
      real(wp) :: x
      integer :: i

      xi = 0.0_wp
      if (b <= origin%offset) return
      x = normal_score(heights, h + b)
      xi = huge(1.0_wp)
      if (x >= vanishing_height) return
      xi = x - origin%x
      ! over short ways the difference has lost digits: by the slope, and Newton's method
      if (xi < short) xi = (b - origin%offset)/height_slope_at(heights, origin%x)
      do i = 1, 4
         xi = xi - (origin%offset + height_step(heights, origin%x, xi) - b) &
            /height_slope_at(heights, origin%x + xi)
      end do
      xi = max(xi, 0.0_wp)
   end function distance_to

   !> Integrals over the summits of one stage, whose numbers lie from..to beyond the origin, cut to
   !> where they matter.
   pure subroutine integrate(properties, origin, stage, from, to, piece, deformation)
      type(normal_properties), intent(in) :: properties
      type(origin_type), intent(in) :: origin
      integer, intent(in) :: stage
      real(wp), intent(in) :: from, to
      type(piece_type), intent(inout) :: piece
      !> Mean deformation over sigma times the share of the summits
      real(wp), intent(out) :: deformation
      real(wp) :: anchor, y, growth, lower, upper, first, last, width

      deformation = 0.0_wp
      if (.not. to > from) return
      ! the densest point; beyond it squares of deformations may grow as exp(growth x)
      anchor = min(max(-origin%x, from), to)
      y = origin%x + anchor
      piece%exponent = 0.5_wp*y*y
      if (origin%x > 0.0_wp) piece%exponent = anchor*(origin%x + 0.5_wp*anchor)
      associate (curve => properties%heights%curve)
         growth = merge(0.0_wp, 2.0_wp*curve%s, curve%is_bounded)
         width = min(widest, widest_by_pole/curve%s)
      end associate
      lower = max(from, anchor - density_reach(y))
      upper = min(to, anchor + max(growth - y, 0.0_wp) + density_reach(max(y - growth, 0.0_wp)))
      if (stage > 1) lower = max(lower, nearest_start)
      first = lower
      do while (first < upper)
         last = min(upper, first + width)
         if (stage > 1) last = min(last, first*exp(widest_log))
         call add_panel(properties, origin, stage, first, last, anchor, y, piece, deformation)
         first = last
      end do
   end subroutine integrate

   !> Add one panel.
   pure subroutine add_panel(properties, origin, stage, first, last, anchor, y, piece, deformation)
      type(normal_properties), intent(in) :: properties
      type(origin_type), intent(in) :: origin
      integer, intent(in) :: stage
      real(wp), intent(in) :: first, last, anchor, y
      type(piece_type), intent(inout) :: piece
      real(wp), intent(inout) :: deformation
      real(wp), dimension(n_points) :: xi, weight, ratio, exponent, force, area, energy
      real(wp) :: middle, half, inverse
      integer :: i

      if (stage == 1) then
         middle = 0.5_wp*(sqrt(last) + sqrt(first))
         half = 0.5_wp*(last - first)/(2.0_wp*middle)
         xi = (middle + half*nodes)**2
         weight = 2.0_wp*half*(middle + half*nodes)*weights
      else
         middle = 0.5_wp*log(last*first)
         half = 0.5_wp*log(last/first)
         xi = exp(middle + half*nodes)
         weight = half*xi*weights
      end if
      exponent = -(xi - anchor)*(y + 0.5_wp*(xi - anchor))
      call exponentials(n_points, exponent, force)
      weight = phi_0*weight*force
      do i = 1, n_points
         ratio(i) = origin%offset + height_step(properties%heights, origin%x, xi(i))
      end do
      deformation = deformation + pairwise_sum(weight*ratio)
      associate (p => properties, r => ratio)
         r = r*(p%sigma/p%w1)
         inverse = 1.0_wp/(p%b3 + 1.0_wp)
         select case (stage)
         case (1)
            area = weight*r
            force = area*sqrt(r)
            energy = 0.4_wp*force*r
            piece%stiffness = piece%stiffness + 1.5_wp*pairwise_sum(weight*sqrt(r))
            piece%area_slope = piece%area_slope + pairwise_sum(weight)
         case (2)
            exponent = log(r)
            call exponentials(n_points, p%b3_less_1*exponent, force)
            call exponentials(n_points, (p%b2 - 1.0_wp)*exponent, area)
            force = weight*force
            area = weight*area
            piece%stiffness = piece%stiffness + p%b3*pairwise_sum(force)
            piece%area_slope = piece%area_slope + p%b2*pairwise_sum(area)
            force = force*r
            area = area*r
            energy = (0.4_wp - inverse)*weight + inverse*force*r
         case default
            area = 2.0_wp*weight*r
            force = area/p%yield_factor
            energy = weight*(p%energy_2/(p%n1*p%w1) &
               + (r - p%plastic_ratio)*(r + p%plastic_ratio)/p%yield_factor)
            piece%stiffness = piece%stiffness + 2.0_wp/p%yield_factor*pairwise_sum(weight)
            piece%area_slope = piece%area_slope + 2.0_wp*pairwise_sum(weight)
         end select
      end associate
      piece%area = piece%area + pairwise_sum(area)
      piece%pressure = piece%pressure + pairwise_sum(force)
      piece%energy = piece%energy + pairwise_sum(energy)
   end subroutine add_panel

end module asperity_law_quadrature_pieces_by_johnson

! src/law/normal_law.f90
!> The normal law of a rough face: summits with random heights, each of them elastic,
!> elasto-plastic or fully plastic (Eqs 23-26), as a function of the separation d of the rigid
!> plane from the mean plane of summit heights. Direct evaluation by quadrature, the reference
!> of everything else. The law is reversible; that with memory is in `asperity_law_unloading_law`.
!>
!> Three pieces, in the summit deformation t = w/sigma: elastic on (0, w1), elasto-plastic on
!> (w1, w2), plastic beyond. Each integral is scaled by the density at its largest point, so
!> that no piece underflows before the result does.
module asperity_law_normal_law
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_pieces_by_fixed_rule, only: evaluate_fixed_pieces, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_johnson, only: decay_score, find_johnson_pieces
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, elastoplastic_piece, &
      piece_type, plastic_piece
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      pressure_above_hardness, valid
   implicit none
   private
   public :: normal_response, evaluate_normal_law, evaluate_pressure, evaluate_scaled_law, &
      sum_pieces, apply_decay, is_closed_too_far

   !> Answer of the rough face at one separation.
   type :: normal_response
      !> Pressure on nominal area, MPa (Eq. 26)
      real(wp) :: pressure = 0.0_wp
      !> Normal stiffness -dp/dd, MPa/mm
      real(wp) :: stiffness = 0.0_wp
      !> Real area over nominal area (Eq. 25)
      real(wp) :: area_fraction = 0.0_wp
      !> Summits in contact per nominal area, 1/mm^2 (Eq. 24)
      real(wp) :: contact_density = 0.0_wp
      !> Stored energy per nominal area, N/mm: the integral of p from d to infinity, or with memory
      !> what of it is recoverable
      real(wp) :: energy = 0.0_wp
      !> Plastic dissipation per nominal area since first touch, N/mm; zero without memory
      real(wp) :: plastic_dissipation = 0.0_wp
      !> Shares of the pressure carried by elastic, elasto-plastic and plastic summits; they sum
      !> to one, also where the pressure itself underflows to zero
      real(wp) :: elastic_share = 1.0_wp, elastoplastic_share = 0.0_wp, plastic_share = 0.0_wp
      !> `valid`, or flags (see `asperity_law_validity`)
      integer :: validity = valid
   end type normal_response

contains

   !> Evaluate the law at one separation. Relative error below 1e-12 in every component that is
   !> a normal number, for -40 <= d/sigma <= 37, 1e-8 <= w1/sigma <= 1e3; zero where it underflows.
   !> The pressure never rises with d over steps above 64 eps max(sigma, |d|), round-off's size.
   pure elemental function evaluate_normal_law(properties, separation) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      type(normal_response) :: response

      call evaluate_scaled_law(properties, separation, response)
      call apply_decay(properties, decay_at(properties, separation), response)
   end function evaluate_normal_law

   !> What a contact point needs of the same, to the bit and in less time: no shares and no contact
   !> density.
   pure subroutine evaluate_pressure(properties, separation, pressure, stiffness, energy, &
         validity, pieces)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      !> Pressure, MPa; normal stiffness, MPa/mm; stored energy per nominal area, N/mm
      real(wp), intent(out) :: pressure, stiffness, energy
      !> `valid`, or flags
      integer, intent(out) :: validity
      !> The three pieces, with recoverable energy and dissipation of the elasto-plastic one
      type(piece_type), intent(out), optional :: pieces(3)
      type(piece_type) :: found(3)
      real(wp) :: h, decay, area_fraction, root(3), moments(0:2)
      integer :: i

      h = separation/properties%sigma
      if (properties%heights%is_gaussian) then
         call find_pieces(properties, separation, .false., present(pieces), found)
      else
         call find_johnson_pieces(properties, separation, found, moments(0:1))
      end if
      if (present(pieces)) pieces = found
      do i = 1, 3
         root(i) = root_of(found(i)%exponent)
      end do
      decay = decay_at(properties, separation)
      associate (p => properties)
         pressure = p%eta*p%n1*sum(root*root*found%pressure)*decay
         stiffness = p%eta*p%n1/p%w1*sum(root*root*found%stiffness)*decay
         area_fraction = p%eta*pi*p%radius*p%w1*sum(root*root*found%area)*decay
         energy = p%eta*p%n1*p%w1*sum(root*root*found%energy)*decay
         validity = p%validity
         if (area_fraction > 1.0_wp) validity = ior(validity, area_above_nominal)
         if (pressure > p%hardness) validity = ior(validity, pressure_above_hardness)
         if (p%heights%is_gaussian) then
            ! above the mean plane summits in contact are closed by 0.8 sigma or less in the mean
            if (h > 0.0_wp .and. 0.8_wp*p%sigma < 0.5_wp*p%radius) return
            call find_tail_moments(h, moments)
         end if
         if (is_closed_too_far(p, separation, moments)) &
            validity = ior(validity, closure_above_half_radius)
      end associate
   end subroutine evaluate_pressure

   !> Multiply what was scaled by the factor, and set the flags of area and pressure.
   pure subroutine apply_decay(properties, decay, response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> The factor
      real(wp), intent(in) :: decay
      !> Scaled values on entry
      type(normal_response), intent(inout) :: response

      associate (r => response)
         r%pressure = r%pressure*decay
         r%stiffness = r%stiffness*decay
         r%area_fraction = r%area_fraction*decay
         r%contact_density = r%contact_density*decay
         r%energy = r%energy*decay
         if (r%area_fraction > 1.0_wp) r%validity = ior(r%validity, area_above_nominal)
         if (r%pressure > properties%hardness) &
            r%validity = ior(r%validity, pressure_above_hardness)
      end associate
   end subroutine apply_decay

   !> The factor exp(-max(h, 0)^2/2), which scaled values lack: h is d/sigma, or what has taken its
   !> place where heights are not Gaussian.
   pure real(wp) function decay_at(properties, separation) result(decay)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      real(wp) :: h

      h = separation/properties%sigma
      if (.not. properties%heights%is_gaussian) h = decay_score(properties, separation)
      decay = exp(-0.5_wp*max(h, 0.0_wp)**2)
   end function decay_at

   !> The law without the factor exp(-max(h, 0)^2/2), which underflows far out.
   pure subroutine evaluate_scaled_law(properties, separation, scaled, area_stiffness, pieces)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Pressure, stiffness, area fraction, contact density and energy over the factor; the shares;
      !> and validity without the flags of area and pressure
      type(normal_response), intent(out) :: scaled
      !> Derivative of the area fraction by closure, 1/mm, over the factor
      real(wp), intent(out), optional :: area_stiffness
      !> The three pieces, with recoverable energy and dissipation of the elasto-plastic one
      type(piece_type), intent(out), optional :: pieces(3)
      type(piece_type) :: found(3)
      real(wp) :: moments(0:2)

      if (properties%heights%is_gaussian) then
         call find_pieces(properties, separation, present(area_stiffness), present(pieces), found)
         call find_tail_moments(separation/properties%sigma, moments)
      else
         call find_johnson_pieces(properties, separation, found, moments(0:1))
      end if
      call sum_pieces(properties, found, scaled, area_stiffness)
      if (present(pieces)) pieces = found
      associate (p => properties, r => scaled)
         r%contact_density = p%eta*moments(0)
         r%validity = p%validity
         if (is_closed_too_far(p, separation, moments)) &
            r%validity = ior(r%validity, closure_above_half_radius)
      end associate
   end subroutine evaluate_scaled_law

   !> The three pieces of Gaussian heights, by the fixed rule where it serves.
   pure subroutine find_pieces(properties, separation, with_area_slope, with_memory, pieces)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Whether the area's slope is wanted; recoverable energy and dissipation of elasto-plastic
      !> summits
      logical, intent(in) :: with_area_slope, with_memory
      !> The pieces
      type(piece_type), intent(out) :: pieces(3)
      real(wp) :: h

      h = separation/properties%sigma
      if (fixed_pieces_serve(properties, h)) then
         call evaluate_fixed_pieces(properties, h, with_area_slope, with_memory, pieces(1), &
            pieces(2))
      else
         pieces(1) = elastic_piece(properties, separation, properties%w1)
         pieces(2) = elastoplastic_piece(properties, separation, with_memory)
      end if
      pieces(3) = plastic_piece(properties, separation)
   end subroutine find_pieces

   !> Whether the summits in contact are closed by more than half their radius in the mean.
   pure logical function is_closed_too_far(properties, separation, moments)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm, and `find_tail_moments` of d/sigma
      real(wp), intent(in) :: separation, moments(0:2)

      is_closed_too_far = properties%sigma*moments(1) > 0.5_wp*properties%radius*moments(0) &
         .and. separation <= properties%judged_separation
   end function is_closed_too_far

   !> Root of the factor exp(-exponent) of a piece.
   pure real(wp) function root_of(exponent)
      real(wp), intent(in) :: exponent

      root_of = 1.0_wp
      if (exponent > 0.0_wp) root_of = exp(-0.5_wp*exponent)
   end function root_of

   !> Add up the elastic, the elasto-plastic and the plastic piece.
   pure subroutine sum_pieces(properties, pieces, scaled, area_stiffness)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> The three pieces
      type(piece_type), intent(in) :: pieces(3)
      !> Pressure, stiffness, area fraction, energy and shares, over the pieces' common factor
      type(normal_response), intent(out) :: scaled
      !> Derivative of the area fraction by closure, 1/mm, over the factor
      real(wp), intent(out), optional :: area_stiffness
      real(wp) :: total, root(3), share(3)
      integer :: i

      do i = 1, 3
         root(i) = root_of(pieces(i)%exponent)
      end do
      associate (p => properties, r => scaled)
         total = sum(root*root*pieces%pressure)
         r%pressure = p%eta*p%n1*total
         r%stiffness = p%eta*p%n1/p%w1*sum(root*root*pieces%stiffness)
         r%area_fraction = p%eta*pi*p%radius*p%w1*sum(root*root*pieces%area)
         if (present(area_stiffness)) &
            area_stiffness = p%eta*pi*p%radius*sum(root*root*pieces%area_slope)
         r%energy = p%eta*p%n1*p%w1*sum(root*root*pieces%energy)
         if (total > 0.0_wp) then
            ! root by root, so that a share underflows only when it is no normal number itself
            share = pieces%pressure/total*root*root
            r%elastic_share = share(1)
            r%elastoplastic_share = share(2)
            r%plastic_share = share(3)
         end if
      end associate
   end subroutine sum_pieces

end module asperity_law_normal_law

! src/law/compiled_law.f90
!> The normal law compiled to polynomials of degree seven on fixed intervals of h = d/sigma, for
!> very many evaluations: within 1e-10 of the direct evaluation. Built once from the properties by
!> `asperity_law_compile_law`, then read only, so that threads share it.
!>
!> Up to h = 8 the polynomials are of pressure, area and energy themselves; beyond, of the same over
!> exp(-h^2/2). Values and slopes are exact at four points of an interval, its ends among them. The
!> stiffness is the derivative of the polynomial of the pressure. Outside -8 <= h < 38, or of the
!> range that it was compiled for, the law is evaluated directly, and beyond 39 it is zero. Of
!> heights that are not Gaussian h is the Gaussian number that belongs to d, as a function of which
!> the law is smooth, and the polynomials reach from -3.5 to 8.
module asperity_law_compiled_law
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_intervals, only: intervals_below, n_all
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_hermite_polynomial, only: degree
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_johnson_heights, only: height_slope_at
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_pieces_by_johnson, only: decay_score
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      pressure_above_hardness
   implicit none
   private
   public :: compiled_law, evaluate_compiled_law

   !> Points of a batch that are worked on at a time
   integer, parameter :: chunk = 64
   !> Stand for the column of an h without a polynomial: evaluated directly, or zero
   integer, parameter :: outside = 0, beyond = -1

   !> The law of one pair of faces, compiled. Build it with `new_compiled_law`; read only after: all
   !> but the properties is for the evaluation.
   type :: compiled_law
      !> What it was compiled from
      type(normal_properties) :: properties
      !> 1/sigma
      real(wp) :: inverse_sigma
      !> Separations over sigma below which a limit of the law is passed: nominal area, hardness,
      !> half the radius
      real(wp) :: limits(3)
      !> First and last column that holds a polynomial, and last one that is not over exp(-h^2/2)
      integer :: columns(2), last_near
      !> Polynomials, one column an interval: powers 0 to 7, and the middle of the interval
      real(wp) :: pressure(0:degree + 1, n_all)
      real(wp) :: area_fraction(0:degree, n_all), energy(0:degree, n_all)
   end type compiled_law

   !> Pressure and stiffness at one separation, or at many in one call; at one also the rest.
   interface evaluate_compiled_law
      procedure evaluate_point
      procedure evaluate_batch
   end interface evaluate_compiled_law

contains

   !> At one separation. The error against the direct evaluation is below 1e-10 for |h| <= 8 and
   !> below 1e-9 beyond, relative, in every quantity.
   pure elemental subroutine evaluate_point(law, separation, pressure, stiffness, area_fraction, &
         contact_density, energy, validity)
      !> Compiled law
      type(compiled_law), intent(in) :: law
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      !> Pressure, MPa, and normal stiffness -dp/dd, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Real area over nominal area; summits in contact per nominal area, 1/mm^2; stored energy
      !> per nominal area, N/mm
      real(wp), intent(out), optional :: area_fraction, contact_density, energy
      !> `valid`, or flags (see `asperity_law_validity`)
      integer, intent(out), optional :: validity
      real(wp) :: found(2)
      integer :: column

      if (present(area_fraction) .or. present(contact_density) .or. present(energy) &
            .or. present(validity)) then
         column = column_at(law, separation)
         if (column == outside) then
            call fill(evaluate_normal_law(law%properties, separation), pressure, stiffness, &
               area_fraction, contact_density, energy, validity)
            return
         end if
         call evaluate_rest(law, score_at(law, separation), column, area_fraction, &
            contact_density, energy, validity)
      end if
      call evaluate_all(law, 1, [separation], found(1:1), found(2:2))
      pressure = found(1)
      stiffness = found(2)
   end subroutine evaluate_point

   !> At many separations: pressures and stiffnesses only.
   pure subroutine evaluate_batch(law, separation, pressure, stiffness)
      !> Compiled law
      type(compiled_law), intent(in) :: law
      !> Separations d, mm
      real(wp), intent(in), contiguous :: separation(:)
      !> Pressures, MPa, and stiffnesses -dp/dd, MPa/mm; as many as separations
      real(wp), intent(out), contiguous :: pressure(:), stiffness(:)

      call evaluate_all(law, size(separation), separation, pressure, stiffness)
   end subroutine evaluate_batch

   !> Pressure and stiffness, in chunks: first the interval of each point, then the polynomials,
   !> so that neither waits for the other.
   pure subroutine evaluate_all(law, n, separation, pressure, stiffness)
      type(compiled_law), intent(in) :: law
      integer, intent(in) :: n
      real(wp), intent(in) :: separation(n)
      real(wp), intent(out) :: pressure(n), stiffness(n)
      real(wp) :: h(chunk), intervals, lowest, highest, decay
      integer :: column(chunk), i, j, m
      logical :: inside(chunk), is_gaussian

      is_gaussian = law%properties%heights%is_gaussian
      lowest = law%columns(1) - 1
      highest = law%columns(2)
      do i = 0, n - 1, chunk
         m = min(chunk, n - i)
         do j = 1, m
            h(j) = score_at(law, separation(i + j))
            intervals = intervals_below(h(j), is_gaussian)
            inside(j) = intervals >= lowest .and. intervals < highest
            column(j) = 1 + int(merge(intervals, lowest, inside(j)))
         end do
         call evaluate_polynomials(law, m, column, h, pressure(i + 1), stiffness(i + 1))
         if (any(column(:m) > law%last_near)) then
            do j = 1, m
               if (column(j) <= law%last_near) cycle
               decay = exp(-0.5_wp*h(j)**2)
               stiffness(i + j) = (stiffness(i + j) + law%inverse_sigma*h(j)*pressure(i + j))*decay
               pressure(i + j) = pressure(i + j)*decay
            end do
         end if
         if (.not. is_gaussian) stiffness(i + 1:i + m) = &
            stiffness(i + 1:i + m)/height_slope_at(law%properties%heights, h(:m))
         if (all(inside(:m))) cycle
         do j = 1, m
            if (.not. inside(j)) call evaluate_outside(law, separation(i + j), &
               pressure(i + j), stiffness(i + j))
         end do
      end do
   end subroutine evaluate_all

   !> The polynomials of the pressure and their derivatives over closure, by Horner's rule for both,
   !> written out for speed.
   pure subroutine evaluate_polynomials(law, n, column, h, pressure, stiffness)
      type(compiled_law), intent(in) :: law
      !> Number of points, and the interval and d/sigma of each
      integer, intent(in) :: n, column(n)
      real(wp), intent(in) :: h(n)
      real(wp), intent(out) :: pressure(n), stiffness(n)
      real(wp) :: t, v6, v5, v4, v3, v2, v1, s5, s4, s3, s2, s1
      integer :: i

      do i = 1, n
         associate (c => law%pressure(:, column(i)))
            t = h(i) - c(9)
            v6 = c(8)*t + c(7)
            s5 = c(8)*t + v6
            v5 = v6*t + c(6)
            s4 = s5*t + v5
            v4 = v5*t + c(5)
            s3 = s4*t + v4
            v3 = v4*t + c(4)
            s2 = s3*t + v3
            v2 = v3*t + c(3)
            s1 = s2*t + v2
            v1 = v2*t + c(2)
            pressure(i) = v1*t + c(1)
            stiffness(i) = -(s1*t + v1)*law%inverse_sigma
         end associate
      end do
   end subroutine evaluate_polynomials

   !> Pressure and stiffness where there is no polynomial.
   pure subroutine evaluate_outside(law, separation, pressure, stiffness)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp), intent(out) :: pressure, stiffness

      pressure = 0.0_wp
      stiffness = 0.0_wp
      if (column_at(law, separation) == outside) &
         call fill(evaluate_normal_law(law%properties, separation), pressure, stiffness)
   end subroutine evaluate_outside

   !> What is wanted of the direct evaluation.
   pure subroutine fill(direct, pressure, stiffness, area_fraction, contact_density, energy, &
         validity)
      type(normal_response), intent(in) :: direct
      real(wp), intent(out) :: pressure, stiffness
      real(wp), intent(out), optional :: area_fraction, contact_density, energy
      integer, intent(out), optional :: validity

      pressure = direct%pressure
      stiffness = direct%stiffness
      if (present(area_fraction)) area_fraction = direct%area_fraction
      if (present(contact_density)) contact_density = direct%contact_density
      if (present(energy)) energy = direct%energy
      if (present(validity)) validity = direct%validity
   end subroutine fill

   !> What is not pressure or stiffness, at one d/sigma with a polynomial or beyond all.
   pure subroutine evaluate_rest(law, h, column, area_fraction, contact_density, energy, validity)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: h
      integer, intent(in) :: column
      real(wp), intent(out), optional :: area_fraction, contact_density, energy
      integer, intent(out), optional :: validity
      real(wp) :: t, decay, moments(0:2)

      if (present(area_fraction)) area_fraction = 0.0_wp
      if (present(contact_density)) contact_density = 0.0_wp
      if (present(energy)) energy = 0.0_wp
      if (present(validity)) validity = law%properties%validity
      if (column == beyond) return
      t = h - law%pressure(degree + 1, column)
      decay = 1.0_wp
      if (column > law%last_near) decay = exp(-0.5_wp*h*h)
      if (present(area_fraction)) &
         area_fraction = polynomial(law%area_fraction(:, column), t)*decay
      if (present(energy)) energy = polynomial(law%energy(:, column), t)*decay
      if (present(contact_density)) then
         call find_tail_moments(h, moments)
         contact_density = law%properties%eta*moments(0)*exp(-0.5_wp*max(h, 0.0_wp)**2)
      end if
      if (present(validity)) validity = flags_at(law, h)
   end subroutine evaluate_rest

   !> The variable of the polynomials at a separation.
   pure real(wp) function score_at(law, separation) result(h)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation

      h = separation*law%inverse_sigma
      if (.not. law%properties%heights%is_gaussian) h = decay_score(law%properties, separation)
   end function score_at

   !> Interval of a separation, or `outside` or `beyond`.
   pure integer function column_at(law, separation)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp) :: intervals

      intervals = intervals_below(score_at(law, separation), &
         law%properties%heights%is_gaussian)
      column_at = merge(beyond, outside, separation > law%properties%vanishing_separation)
      if (intervals >= law%columns(1) - 1 .and. intervals < law%columns(2)) &
         column_at = 1 + int(intervals)
   end function column_at

   !> A polynomial by Horner's rule.
   pure real(wp) function polynomial(c, t)
      real(wp), intent(in) :: c(0:degree), t
      integer :: i

      polynomial = c(degree)
      do i = degree - 1, 0, -1
         polynomial = polynomial*t + c(i)
      end do
   end function polynomial

   !> Flags at a separation over sigma.
   pure integer function flags_at(law, h)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: h
      integer, parameter :: flags(3) = &
         [area_above_nominal, pressure_above_hardness, closure_above_half_radius]
      integer :: i

      flags_at = law%properties%validity
      do i = 1, size(flags)
         if (h < law%limits(i)) flags_at = ior(flags_at, flags(i))
      end do
   end function flags_at

end module asperity_law_compiled_law

! src/law/compile_law.f90
!> Compiles the normal law: values and slopes of the direct evaluation at four points of each
!> interval become the polynomials of `asperity_law_compiled_law`. All intervals, or those alone
!> that a range of separations needs.
module asperity_law_compile_law
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_intervals, only: first, first_of_johnson, intervals_below, last, &
      last_of_johnson, n_all, n_near, place_interval
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_hermite_polynomial, only: degree, hermite_points, hermite_polynomial
   use asperity_law_johnson_heights, only: height_of, height_slope_at, normal_score
   use asperity_law_normal_law, only: evaluate_scaled_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_validity, only: closure_above_half_radius
   implicit none
   private
   public :: new_compiled_law, compiling_pays

   !> So many points an interval take as long directly as compiled: three samples of an interval,
   !> each a direct evaluation, and as much again for all else
   integer, parameter :: points_to_pay = 6

contains

   !> Compile the law. `error` is set when the properties were never built.
   pure subroutine new_compiled_law(law, properties, error, range)
      !> Result
      type(compiled_law), intent(out) :: law
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Set when the properties were never built
      type(error_type), allocatable, intent(out) :: error
      !> Least and largest separation, mm, to compile for; beyond them the law is evaluated
      !> directly. When absent, the whole range of polynomials
      real(wp), intent(in), optional :: range(2)
      real(wp), dimension(4, 3) :: values, slopes
      real(wp) :: middle, half_width
      integer :: i, j

      if (.not. properties%sigma > 0.0_wp) then
         call fatal_error(error, 'the properties of the normal law are not set: build them '// &
            'with new_normal_properties')
         return
      end if
      law%properties = properties
      law%inverse_sigma = 1.0_wp/properties%sigma
      law%columns = [1, n_all]
      if (present(range)) law%columns = columns_of(properties, range)
      law%last_near = merge(n_near, n_all, properties%heights%is_gaussian)
      do i = law%columns(1), law%columns(2)
         call place_interval(i, properties%heights%is_gaussian, middle, half_width)
         if (i == law%columns(1) .or. i == law%last_near + 1) then
            call sample(properties, middle - half_width, i > law%last_near, values(1, :), &
               slopes(1, :))
         else
            values(1, :) = values(4, :)
            slopes(1, :) = slopes(4, :)
         end if
         do j = 2, 4
            call sample(properties, middle + half_width*hermite_points(j), i > law%last_near, &
               values(j, :), slopes(j, :))
         end do
         law%pressure(:degree, i) = hermite_polynomial(values(:, 1), slopes(:, 1), half_width)
         law%pressure(degree + 1, i) = middle
         law%area_fraction(:, i) = hermite_polynomial(values(:, 2), slopes(:, 2), half_width)
         law%energy(:, i) = hermite_polynomial(values(:, 3), slopes(:, 3), half_width)
      end do
      call find_limits(law)
   end subroutine new_compiled_law

   !> Whether so many points are evaluated sooner when the law is compiled for their range first.
   pure logical function compiling_pays(points, properties, range)
      !> Number of points
      integer, intent(in) :: points
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Least and largest separation, mm
      real(wp), intent(in) :: range(2)
      integer :: columns(2)

      columns = columns_of(properties, range)
      compiling_pays = points > points_to_pay*max(columns(2) - columns(1) + 1, 1)
   end function compiling_pays

   !> First and last column that a range of separations needs, one at least.
   pure function columns_of(properties, range) result(columns)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: range(2)
      integer :: columns(2)
      real(wp) :: h(2)

      h = normal_score(properties%heights, range/properties%sigma)
      if (properties%heights%is_gaussian) then
         h = min(max(h, first), last)
      else
         h = min(max(h, first_of_johnson), last_of_johnson)
      end if
      columns = min(1 + int(intervals_below(h, properties%heights%is_gaussian)), n_all)
   end function columns_of

   !> Pressure, area fraction and energy, and their derivatives by h, d/sigma or the Gaussian number
   !> that belongs to it; over exp(-h^2/2) if `scaled`.
   pure subroutine sample(properties, h, scaled, values, slopes)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h
      logical, intent(in) :: scaled
      real(wp), intent(out) :: values(:), slopes(:)
      type(normal_response) :: r
      real(wp) :: area_stiffness, decay

      call evaluate_scaled_law(properties, height_of(properties%heights, h)*properties%sigma, r, &
         area_stiffness)
      values = [r%pressure, r%area_fraction, r%energy]
      slopes = -properties%sigma*height_slope_at(properties%heights, h) &
         *[r%stiffness, area_stiffness, r%pressure]
      if (scaled) then
         slopes = slopes + h*values
      else
         decay = exp(-0.5_wp*max(h, 0.0_wp)**2)
         values = values*decay
         slopes = slopes*decay
      end if
   end subroutine sample

   !> Find where the law's limits are passed, by bisection. What lies outside the polynomials is
   !> evaluated, and judged, directly.
   pure subroutine find_limits(law)
      type(compiled_law), intent(inout) :: law
      real(wp) :: lowest, highest, near, distant, h, middle, half_width
      integer :: i

      associate (is_gaussian => law%properties%heights%is_gaussian)
         call place_interval(law%columns(1), is_gaussian, middle, half_width)
         lowest = middle - half_width
         call place_interval(law%columns(2), is_gaussian, middle, half_width)
         highest = middle + half_width
      end associate
      do i = 1, 3
         law%limits(i) = lowest
         if (.not. is_passed(law, i, lowest)) cycle
         near = lowest
         distant = highest
         ! the first place where it is passed no more, as of heavy tails it may be again far out
         if (.not. law%properties%heights%is_gaussian) then
            distant = lowest
            do while (distant < highest)
               distant = distant + 2.0_wp*half_width
               if (.not. is_passed(law, i, distant)) exit
               near = distant
            end do
         end if
         do while (distant - near > epsilon(h)*max(1.0_wp, abs(near)))
            h = 0.5_wp*(near + distant)
            if (is_passed(law, i, h)) then
               near = h
            else
               distant = h
            end if
         end do
         law%limits(i) = distant
      end do
   end subroutine find_limits

   !> Whether a limit is passed at a separation over sigma: nominal area, hardness, half the radius.
   pure logical function is_passed(law, limit, h)
      type(compiled_law), intent(in) :: law
      integer, intent(in) :: limit
      real(wp), intent(in) :: h
      real(wp) :: d, pressure, stiffness, area_fraction
      type(normal_response) :: r

      d = height_of(law%properties%heights, h)*law%properties%sigma
      if (limit < 3) then
         call evaluate_compiled_law(law, d, pressure, stiffness, area_fraction)
         is_passed = merge(area_fraction > 1.0_wp, pressure > law%properties%hardness, limit == 1)
      else
         call evaluate_scaled_law(law%properties, d, r)
         is_passed = iand(r%validity, closure_above_half_radius) > 0
      end if
   end function is_passed

end module asperity_law_compile_law

! src/law/unloading/cell.f90
!> Pieces of the compiled law with memory: a polynomial of h = d/sigma in a strip of h, and a cell
!> of such a strip and of the retraction u. The cell holds the stiffness as a polynomial of h and of
!> x, which is u itself or, where summits of one stage lose contact at the cell's end, the root of
!> what is left to that end: there the law has terms of power 5/2. Pressure and energy are its
!> integrals over u, exactly.
module asperity_law_unloading_cell
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: strip_polynomial, unloading_cell, value_in_strip, evaluate_cell

   !> Degrees of the polynomials: of h, and of x in the stiffness
   integer, parameter, public :: degree_h = 13, degree_x = 15
   !> Half the width of a strip of h
   real(wp), parameter, public :: strip_half_width = 1.0_wp
   !> The powers of x, and the factors that they get in the integral of the stiffness over u and in
   !> the integral of that; column 1 where u is linear in x, column 2 where x is a root
   real(wp), parameter :: n(0:degree_x) = &
      real([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15], wp)
   real(wp), parameter :: once(0:degree_x, 2) = &
      reshape([1.0_wp/(n + 1.0_wp), 2.0_wp/(n + 2.0_wp)], [degree_x + 1, 2])
   real(wp), parameter :: twice(0:degree_x, 2) = reshape([1.0_wp/((n + 1.0_wp)*(n + 2.0_wp)), &
      4.0_wp/((n + 2.0_wp)*(n + 4.0_wp))], [degree_x + 1, 2])

   !> A polynomial of t = (h - middle)/strip_half_width, times exp(-decay t)
   type :: strip_polynomial
      real(wp) :: decay = 0.0_wp
      !> Of the powers of t
      real(wp) :: coefficients(0:degree_h) = 0.0_wp
   end type strip_polynomial

   !> A cell of the unloading branch
   type :: unloading_cell
      !> Origin of x and 1/(size of x), over sigma
      real(wp) :: origin, inverse_size
      !> What x, or its square, is in mm of closure
      real(wp) :: length
      !> 1 where u is linear in x, 2 where x is a root
      integer :: power
      !> All is times exp(-decay t)
      real(wp) :: decay
      !> Energy and pressure at the origin, which is the middle or, where x is a root, the end, and
      !> the coefficients of the powers of x in the stiffness; columns are the powers of t
      real(wp) :: coefficients(0:degree_x + 2, 0:degree_h)
   end type unloading_cell

contains

   !> Value of a polynomial of h.
   pure real(wp) function value_in_strip(polynomial, t) result(value)
      !> The polynomial
      type(strip_polynomial), intent(in) :: polynomial
      !> Place of h in the strip, -1 to 1
      real(wp), intent(in) :: t
      integer :: i

      value = polynomial%coefficients(degree_h)
      do i = degree_h - 1, 0, -1
         value = value*t + polynomial%coefficients(i)
      end do
      value = value*exp(-polynomial%decay*t)
   end function value_in_strip

   !> The polynomials of a cell: first of h, then the stiffness and its two integrals over u.
   pure subroutine evaluate_cell(cell, t, u, pressure, stiffness, energy)
      !> The cell
      type(unloading_cell), intent(in) :: cell
      !> Place of h in its strip, -1 to 1, and the retraction over sigma
      real(wp), intent(in) :: t, u
      !> MPa, MPa/mm and N/mm
      real(wp), intent(out) :: pressure, stiffness, energy
      real(wp) :: c(0:degree_x + 2), decay, x, closure, k(2), p(2), e(2)
      integer :: i

      ! four powers of h at a time, so that the next step need not wait for each
      associate (a => cell%coefficients)
         c = a(:, degree_h - 1) + t*a(:, degree_h)
         do i = degree_h - 5, 0, -4
            c = c*t**4 + ((a(:, i) + t*a(:, i + 1)) + t**2*(a(:, i + 2) + t*a(:, i + 3)))
         end do
      end associate
      x = (cell%origin - u)*cell%inverse_size
      closure = x*cell%length
      if (cell%power == 2) x = sqrt(max(x, 0.0_wp))
      ! even and odd powers of x apart, for the same reason
      k = 0.0_wp
      p = 0.0_wp
      e = 0.0_wp
      do i = degree_x - 1, 0, -2
         k = k*x**2 + c(i + 2:i + 3)
         p = p*x**2 + c(i + 2:i + 3)*once(i:i + 1, cell%power)
         e = e*x**2 + c(i + 2:i + 3)*twice(i:i + 1, cell%power)
      end do
      decay = exp(-cell%decay*t)
      energy = decay*(c(0) + closure*(c(1) + closure*(e(1) + x*e(2))))
      pressure = decay*(c(1) + closure*(p(1) + x*p(2)))
      stiffness = decay*(k(1) + x*k(2))
   end subroutine evaluate_cell

end module asperity_law_unloading_cell

! src/law/unloading/chebyshev.f90
!> Polynomials through values at Chebyshev-Lobatto points, for compiling the law with memory.
module asperity_law_unloading_chebyshev
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: chebyshev_points, chebyshev_coefficients, powers_of_chebyshev

contains

   !> The points cos(pi i/n), i = n to 0: both ends of (-1, 1) are among them.
   pure function chebyshev_points(n) result(points)
      !> Degree of the polynomial
      integer, intent(in) :: n
      real(wp) :: points(0:n)
      integer :: i

      points = [(sin(0.5_wp*pi*(2*i - n)/n), i=0, n)]
   end function chebyshev_points

   !> Coefficients of the Chebyshev polynomials T_0 to T_n; their fall tells how good the fit is.
   pure function chebyshev_coefficients(values) result(c)
      !> Values at `chebyshev_points`
      real(wp), intent(in) :: values(0:)
      real(wp) :: c(0:size(values) - 1)
      real(wp) :: halved(0:size(values) - 1), cosines(0:2*size(values) - 3)
      integer :: i, k, n

      n = size(values) - 1
      ! the points count up from -1, their angles down from pi
      halved = values(n:0:-1)
      halved([0, n]) = 0.5_wp*halved([0, n])
      cosines = [(cos(pi*i/n), i=0, 2*n - 1)]
      do k = 0, n
         c(k) = 2.0_wp/n*sum([(halved(i)*cosines(mod(i*k, 2*n)), i=0, n)])
      end do
      c([0, n]) = 0.5_wp*c([0, n])
   end function chebyshev_coefficients

   !> Coefficients of the powers of x, where the Chebyshev polynomials are of t = scale x + shift.
   !> From the small coefficients of a good fit the large powers get no large round-off.
   pure function powers_of_chebyshev(c, scale, shift) result(powers)
      !> Coefficients of the Chebyshev polynomials of t
      real(wp), intent(in) :: c(0:)
      !> t = scale x + shift
      real(wp), intent(in) :: scale, shift
      real(wp) :: powers(0:size(c) - 1)
      real(wp), dimension(0:size(c) - 1) :: last, this, next
      integer :: k, n

      n = size(c) - 1
      last = 0.0_wp
      last(0) = 1.0_wp
      this = 0.0_wp
      this(0:1) = [shift, scale]
      powers = c(0)*last + c(1)*this
      do k = 2, n
         next = 2.0_wp*(shift*this + scale*eoshift(this, -1)) - last
         powers = powers + c(k)*next
         last = this
         this = next
      end do
   end function powers_of_chebyshev

end module asperity_law_unloading_chebyshev

! src/law/unloading/gauss_points.f90
!> Gauss-Legendre rule of 28 points on 0..1.
module asperity_law_unloading_gauss_points
   use asperity_base_kinds, only: wp
   implicit none
   private

   integer, parameter :: n_half = 14
   !> Number of points
   integer, parameter, public :: n_points = 2*n_half

   real(wp), parameter :: half_nodes(n_half) = [ &
      0.055079289884034270427_wp, 0.16456928213338077128_wp, 0.27206162763517807768_wp, &
      0.37625151608907871022_wp, 0.47587422495511826103_wp, 0.56972047181140171931_wp, &
      0.65665109403886496122_wp, 0.73561087801363177203_wp, 0.80564137091717917145_wp, &
      0.86589252257439504894_wp, 0.91563302639213207387_wp, 0.95425928062893819725_wp, &
      0.98130316537087275369_wp, 0.99644249757395444995_wp]
   real(wp), parameter :: half_weights(n_half) = [ &
      0.11004701301647519628_wp, 0.10871119225829413525_wp, 0.10605576592284641791_wp, &
      0.10211296757806076981_wp, 0.09693065799792991585_wp, 0.090571744393032840942_wp, &
      0.08311341722890121839_wp, 0.074646214234568779024_wp, 0.065272923966999595793_wp, &
      0.055107345675716745431_wp, 0.04427293475900422784_wp, 0.032901427782304379978_wp, &
      0.021132112592771259752_wp, 0.0091242825930945177388_wp]

   !> Points in ascending order
   real(wp), parameter, public :: points(n_points) = &
      0.5_wp*[1.0_wp - half_nodes(n_half:1:-1), 1.0_wp + half_nodes]
   !> Their weights, of sum 1
   real(wp), parameter, public :: weights(n_points) = &
      0.5_wp*[half_weights(n_half:1:-1), half_weights]

end module asperity_law_unloading_gauss_points

! src/law/unloading/sums.f90
!> What yielded summits that part again carry together. A summit's contact radius is a, and it is
!> still pressed in elastically by e - u, e its recovery and u the retraction: its stiffness is
!> 3/2 a, its force a (e - u), its stored energy 2/5 a (e - u)^2 and its area a^2, in units of N1,
!> w1 and sqrt(R w1). The point where it loses contact is a branch point of a; each stage has a
!> variable without it.
module asperity_law_unloading_sums
   use asperity_base_kinds, only: wp
   use asperity_law_quadrature_pieces_by_quadrature, only: piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points
   implicit none
   private
   public :: add_summits

   !> Exponents of the density are kept within what `exponentials` takes, as rounding of
   !> deformations carries them away where no summit touches
   real(wp), parameter, public :: lowest_exponent = -100.0_wp
   !> Below this d/sigma the density has a peak inside the range
   real(wp), parameter, public :: lowest = -1.0_wp

contains

   !> Add what summits of given contact radii and elastic deformations carry, in four parts side by
   !> side.
   pure subroutine add_summits(piece, scale, weight, density, radius, left)
      !> What is added to
      type(piece_type), intent(inout) :: piece
      !> Factor of all weights
      real(wp), intent(in) :: scale
      !> Weights and densities of the points of a panel, contact radii a, deformations e - u
      real(wp), dimension(n), intent(in) :: weight, density, radius, left
      real(wp), dimension(4) :: stiffness, force, energy, area, w, f
      integer :: i

      stiffness = 0.0_wp
      force = 0.0_wp
      energy = 0.0_wp
      area = 0.0_wp
      do i = 1, n, 4
         w = weight(i:i + 3)*density(i:i + 3)*radius(i:i + 3)
         f = w*left(i:i + 3)
         stiffness = stiffness + w
         force = force + f
         energy = energy + f*left(i:i + 3)
         area = area + w*radius(i:i + 3)
      end do
      piece%stiffness = piece%stiffness + 1.5_wp*scale*sum(stiffness)
      piece%pressure = piece%pressure + scale*sum(force)
      piece%energy = piece%energy + 0.4_wp*scale*sum(energy)
      piece%area = piece%area + scale*sum(area)
   end subroutine add_summits

end module asperity_law_unloading_sums

! src/law/single_asperity.f90
!> One spherical summit against a rigid plane: elastic, elasto-plastic, fully plastic
!> (Eqs 1-3, 10-22). Force is continuous; its derivative jumps at w1 and w2.
module asperity_law_single_asperity
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_validity, only: closure_above_half_radius, valid
   implicit none
   private
   public :: asperity_response, evaluate_asperity

   !> Stages of one summit
   enum, bind(c)
      enumerator :: stage_open = 0, stage_elastic, stage_elastoplastic, stage_plastic
   end enum
   public :: stage_open, stage_elastic, stage_elastoplastic, stage_plastic

   !> Answer of one summit at one deformation.
   type :: asperity_response
      !> `stage_open`, `stage_elastic`, `stage_elastoplastic` or `stage_plastic`
      integer :: stage = stage_open
      !> Force, N (Eqs 2, 20, 13), and its derivative by w, N/mm
      real(wp) :: force = 0.0_wp, force_slope = 0.0_wp
      !> Real contact area, mm^2 (Eqs 1, 21, 12), and its derivative by w, mm
      real(wp) :: area = 0.0_wp, area_slope = 0.0_wp
      !> Mean pressure force/area, MPa (Eqs 3, 22, 10), and its derivative by w, MPa/mm
      real(wp) :: mean_pressure = 0.0_wp, mean_pressure_slope = 0.0_wp
      !> Work of the force from first touch, N mm; its derivative by w is the force
      real(wp) :: energy = 0.0_wp
      !> `valid`, or flags (see `asperity_law_validity`)
      integer :: validity = valid
   end type asperity_response

contains

   !> Evaluate one summit. Derivatives at w1 and w2 are those of the stage that begins there;
   !> at w = 0 the slope of the mean pressure is infinite and returned as zero, as for an open
   !> summit.
   pure elemental function evaluate_asperity(properties, deformation) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Normal deformation w of the summit, mm; negative or zero is open
      real(wp), intent(in) :: deformation
      type(asperity_response) :: response
      real(wp) :: ratio, area_1, pressure_1, power

      response%validity = properties%validity
      if (.not. deformation > 0.0_wp) return
      associate (p => properties, w => deformation, r => response)
         ratio = w/p%w1
         area_1 = pi*p%radius*p%w1
         pressure_1 = p%yield_factor*p%hardness
         if (w < p%w1) then
            r%stage = stage_elastic
            r%force = p%n1*ratio*sqrt(ratio)
            r%force_slope = 1.5_wp*r%force/w
            r%area = pi*p%radius*w
            r%area_slope = pi*p%radius
            r%mean_pressure = pressure_1*sqrt(ratio)
            r%mean_pressure_slope = 0.5_wp*r%mean_pressure/w
            r%energy = 0.4_wp*r%force*w
         else if (w < p%w2) then
            r%stage = stage_elastoplastic
            power = ratio**p%b3
            r%force = p%n1*power
            r%force_slope = p%b3*r%force/w
            r%area = area_1*ratio**p%b2
            r%area_slope = p%b2*r%area/w
            r%mean_pressure = pressure_1*ratio**p%b1
            r%mean_pressure_slope = p%b1*r%mean_pressure/w
            r%energy = p%n1*p%w1*(0.4_wp + (power*ratio - 1.0_wp)/(p%b3 + 1.0_wp))
         else
            r%stage = stage_plastic
            r%force = 2.0_wp*pi*p%radius*p%hardness*w
            r%force_slope = 2.0_wp*pi*p%radius*p%hardness
            r%area = 2.0_wp*pi*p%radius*w
            r%area_slope = 2.0_wp*pi*p%radius
            r%mean_pressure = p%hardness
            r%energy = p%energy_2 + pi*p%radius*p%hardness*(w - p%w2)*(w + p%w2)
         end if
         if (w > 0.5_wp*p%radius) r%validity = ior(r%validity, closure_above_half_radius)
      end associate
   end function evaluate_asperity

end module asperity_law_single_asperity

! src/law/unloading/summit.f90
!> One summit that remembers: after yield it unloads and reloads as an elastic (Hertz) contact of
!> another radius, with force and area continuous at its largest deformation (residual sphere:
!> Etsion, Kligerman, Kadin 2005), for the three stages of the paper without any fitted constant.
!>
!> With N and A the force and area at the largest deformation w and e = 3 N/(4 E* sqrt(A/pi)) what
!> it recovers elastically, a retraction u leaves the force N (1 - u/e)^(3/2), the area A (1 - u/e),
!> the stiffness 3/2 N/e (1 - u/e)^(1/2) and the stored energy 2/5 N e (1 - u/e)^(5/2).
module asperity_law_unloading_summit
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity, stage_open
   implicit none
   private
   public :: evaluate_unloading_asperity, elastic_recovery, recovery_exponent, find_contact_edge

   real(wp), parameter :: lowest_log = -50.0_wp

contains

   !> What a summit recovers elastically, mm: the retraction from its largest deformation at which
   !> it loses contact. Its largest deformation less this is its residual.
   pure elemental real(wp) function elastic_recovery(properties, deformation) result(recovery)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Largest deformation, mm
      real(wp), intent(in) :: deformation

      associate (p => properties, w => max(deformation, 0.0_wp))
         if (w < p%w1) then
            recovery = w
         else if (w < p%w2) then
            recovery = p%w1*(w/p%w1)**recovery_exponent(p)
         else
            recovery = sqrt(2.0_wp*p%w1*w)/p%yield_factor
         end if
      end associate
   end function elastic_recovery

   !> Exponent of w/w1 in the elastic recovery of an elasto-plastic summit, b3 - b2/2.
   pure elemental real(wp) function recovery_exponent(properties)
      !> Checked properties
      type(normal_properties), intent(in) :: properties

      recovery_exponent = properties%b3 - 0.5_wp*properties%b2
   end function recovery_exponent

   !> Find the summit that just loses contact: the inverse of `elastic_recovery`.
   pure elemental subroutine find_contact_edge(properties, retraction, deformation, log_ratio)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> How far summits have parted since their largest deformation, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Its largest deformation, mm
      real(wp), intent(out) :: deformation
      !> ln(w/w1) of the deformation w at which the formula of elasto-plastic summits gives a
      !> recovery of the retraction, also beyond these summits; -50 stands for anything below
      real(wp), intent(out) :: log_ratio

      associate (p => properties, u => retraction)
         log_ratio = lowest_log
         if (u > 0.0_wp) log_ratio = max(log(u/p%w1)/recovery_exponent(p), lowest_log)
         if (u < p%w1) then
            deformation = u
         else
            deformation = p%w1*exp(log_ratio)
            if (.not. deformation < p%w2) deformation = 0.5_wp*(p%yield_factor*u)**2/p%w1
         end if
      end associate
   end subroutine find_contact_edge

   !> Evaluate one summit that was pressed to a largest deformation and has parted again. The stage
   !> is that of the largest deformation, `stage_open` once it has lost contact; slopes are by the
   !> deformation at fixed memory; the energy is what is recoverable.
   pure elemental function evaluate_unloading_asperity(properties, largest_deformation, &
         retraction) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Largest deformation of the summit so far, mm
      real(wp), intent(in) :: largest_deformation
      !> How far it has parted since, mm; zero or more
      real(wp), intent(in) :: retraction
      type(asperity_response) :: response
      real(wp) :: recovery, rest

      response = evaluate_asperity(properties, largest_deformation)
      if (response%stage == stage_open) return
      recovery = elastic_recovery(properties, largest_deformation)
      rest = max(1.0_wp - max(retraction, 0.0_wp)/recovery, 0.0_wp)
      associate (r => response)
         if (.not. rest > 0.0_wp) then
            r%stage = stage_open
            r%force = 0.0_wp
            r%area = 0.0_wp
         end if
         r%force_slope = 1.5_wp*r%force/recovery*sqrt(rest)
         r%energy = 0.4_wp*r%force*recovery*rest*rest*sqrt(rest)
         r%force = r%force*rest*sqrt(rest)
         r%area_slope = r%area/recovery
         r%area = r%area*rest
         r%mean_pressure = 0.0_wp
         r%mean_pressure_slope = 0.0_wp
         if (r%area > 0.0_wp) then
            r%mean_pressure = r%force/r%area
            r%mean_pressure_slope = 0.5_wp*r%mean_pressure/(recovery*rest)
         end if
      end associate
   end function evaluate_unloading_asperity

end module asperity_law_unloading_summit

! src/law/unloading/pieces.f90
!> Integrals over elastic and elasto-plastic summits that part again, by the stage of their largest
!> deformation: elastic ones are those of the law without memory, others are summed by quadrature.
module asperity_law_unloading_pieces
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: find_dense_range, relative_exponent
   use asperity_law_quadrature_pieces_by_fixed_rule, only: fixed_elastic_piece, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, no_summits, &
      piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points, points, weights
   use asperity_law_unloading_sums, only: add_summits, lowest, lowest_exponent
   use asperity_law_unloading_summit, only: recovery_exponent
   implicit none
   private
   public :: elastic_unloading_piece, elastoplastic_unloading_piece

   !> The root of the area of an elasto-plastic summit, in pi R w1, is sqrt(x) exp(area_slope ln x)
   !> with area_slope = (b2 - 1)/2: the second factor grows from 1 to sqrt(2), by powers from the
   !> middle
   real(wp), parameter :: log_2 = log(2.0_wp), root_of_root_2 = sqrt(sqrt(2.0_wp))
   real(wp), parameter :: series(0:9) = 1.0_wp/[1.0_wp, 1.0_wp, 2.0_wp, 6.0_wp, 24.0_wp, &
      120.0_wp, 720.0_wp, 5040.0_wp, 40320.0_wp, 362880.0_wp]
   !> Largest w2/sigma, and product of it and d/sigma, with one panel of elasto-plastic summits
   real(wp), parameter :: largest_w2 = 2.2_wp, largest_product = 9.9_wp

contains

   !> Summits of a largest deformation below w1: those of the law without memory at the separation
   !> now, up to the deformation w1 - u.
   pure function elastic_unloading_piece(properties, closest_separation, retraction) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Integrals, by the density at the closest separation
      type(piece_type) :: piece
      real(wp) :: h, now, largest

      piece = no_summits
      if (.not. retraction < properties%w1) return
      associate (p => properties)
         h = closest_separation/p%sigma
         now = (closest_separation + retraction)/p%sigma
         largest = p%w1 - retraction
         if (fixed_pieces_serve(p, now)) then
            piece = fixed_elastic_piece(p, now, largest/p%w1)
         else
            piece = elastic_piece(p, closest_separation + retraction, largest)
         end if
         piece%exponent = piece%exponent &
            + relative_exponent(h, retraction/p%sigma, max(now, 0.0_wp))
      end associate
   end function elastic_unloading_piece

   !> Summits of a largest deformation between w1 and w2. With x = w/w1 the recovery is x^c, and the
   !> variable is v, ln x = ln x_u + v^2, x_u the ratio that just loses contact: 1 - u/e is
   !> 1 - exp(-c v^2).
   pure function elastoplastic_unloading_piece(properties, closest_separation, retraction, edge, &
         log_edge) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> See `find_contact_edge`
      real(wp), intent(in) :: edge, log_edge
      !> Integrals, by the density at the closest separation
      type(piece_type) :: piece
      real(wp) :: u, c, from, anchor, y, lower, upper, first, last, width, start, a, b, v, log_x, &
         t, z, log_ratio, area_slope
      real(wp) :: exponents(2*n), powers(2*n)
      real(wp), dimension(n) :: density, weight, left, radius
      integer :: panel, panels, i

      piece = no_summits
      if (.not. edge < properties%w2) return
      associate (p => properties)
         u = retraction/p%w1
         c = recovery_exponent(p)
         log_ratio = log(p%plastic_ratio)
         area_slope = 0.5_wp*log_2/log_ratio
         from = max(p%w1, edge)
         call find_dense_range(p, closest_separation, from, p%w2, anchor, y, lower, upper, &
            piece%exponent)
         first = max(log_edge, 0.0_wp)
         if (lower > (from - anchor)/p%sigma) first = log((anchor + lower*p%sigma)/p%w1)
         last = log_ratio
         if (upper < (p%w2 - anchor)/p%sigma) last = log((anchor + upper*p%sigma)/p%w1)
         first = sqrt(max(first - log_edge, 0.0_wp))
         last = sqrt(max(last - log_edge, 0.0_wp))
         anchor = anchor/p%sigma
         a = p%w1/p%sigma
         b = p%w2/p%sigma
         panels = 3
         if (closest_separation < lowest*p%sigma) then
            panels = 10
         else if (b <= largest_w2 .and. b*closest_separation <= largest_product*p%sigma) then
            panels = 1
         end if
         width = (last - first)/panels
         do panel = 1, panels
            start = first + width*(panel - 1)
            do i = 1, n
               v = start + width*points(i)
               log_x = log_edge + v*v
               exponents(i) = log_x
               exponents(n + i) = c*log_x
               weight(i) = weights(i)*v
               z = area_slope*log_x - 0.25_wp*log_2
               radius(i) = root_of_root_2*exponential_series(z)
            end do
            call exponentials(2*n, exponents, powers)
            do i = 1, n
               t = a*powers(i) - anchor
               weight(i) = weight(i)*powers(i)
               exponents(i) = max(min(-t*(y + 0.5_wp*t), 0.0_wp), lowest_exponent)
               left(i) = max(powers(n + i) - u, 0.0_wp)
               radius(i) = radius(i)*sqrt(powers(i)*left(i)/powers(n + i))
            end do
            call exponentials(n, exponents(:n), density)
            call add_summits(piece, 2.0_wp*phi_0*a*width, weight, density, radius, left)
         end do
      end associate
   end function elastoplastic_unloading_piece

   !> exp(z) for |z| <= ln(2)/4, to round-off.
   pure real(wp) function exponential_series(z)
      real(wp), intent(in) :: z
      real(wp) :: z2, z4

      z2 = z*z
      z4 = z2*z2
      exponential_series = ((series(0) + z*series(1)) + z2*(series(2) + z*series(3))) &
         + z4*((series(4) + z*series(5)) + z2*(series(6) + z*series(7))) &
         + z4*z4*(series(8) + z*series(9))
   end function exponential_series

end module asperity_law_unloading_pieces

! src/law/unloading/plastic_pieces.f90
!> Integrals over plastic summits that part again.
module asperity_law_unloading_plastic_pieces
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: find_dense_range
   use asperity_law_quadrature_pieces_by_quadrature, only: no_summits, piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points, points, weights
   use asperity_law_unloading_sums, only: add_summits, lowest, lowest_exponent
   implicit none
   private
   public :: plastic_unloading_piece, recoverable_plastic_energy

   !> Smallest w2/sigma with one panel of plastic summits; otherwise the ends of the panels that
   !> their range is split into
   real(wp), parameter :: smallest_w2 = 0.11_wp
   real(wp), parameter :: one(0:1) = [0.0_wp, 1.0_wp]
   real(wp), parameter :: four(0:4) = [0.0_wp, 0.05_wp, 0.3_wp, 0.65_wp, 1.0_wp]

contains

   !> Summits of a largest deformation above w2: e = sqrt(2 x)/k, and the variable is
   !> sqrt(x - x_u).
   pure function plastic_unloading_piece(properties, closest_separation, retraction) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Integrals, by the density at the closest separation
      type(piece_type) :: piece

      if (has_one_panel(properties, closest_separation)) then
         piece = sum_plastic(properties, closest_separation, retraction, one)
      else
         piece = sum_plastic(properties, closest_separation, retraction, four)
      end if
   end function plastic_unloading_piece

   !> The `energy` of the same piece at a retraction of zero, 2/5 N e a summit: by its exponent,
   !> which is that of the plastic piece of the law without memory.
   pure real(wp) function recoverable_plastic_energy(properties, separation) result(energy)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation, mm
      real(wp), intent(in) :: separation

      if (has_one_panel(properties, separation)) then
         energy = sum_plastic_energy(properties, separation, one)
      else
         energy = sum_plastic_energy(properties, separation, four)
      end if
   end function recoverable_plastic_energy

   !> Whether one panel is enough for plastic summits.
   pure logical function has_one_panel(properties, closest_separation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation

      has_one_panel = closest_separation >= lowest*properties%sigma &
         .and. properties%w2 >= smallest_w2*properties%sigma
   end function has_one_panel

   !> Range of the root of the deformation beyond the edge, and the density in it: from the anchor,
   !> where it is densest, at y. All in sigma, as is the edge.
   pure subroutine find_plastic_range(properties, closest_separation, edge, anchor, y, first, &
         last, exponent)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, edge
      real(wp), intent(out) :: anchor, y, first, last, exponent
      real(wp) :: lower, upper

      associate (p => properties)
         call find_dense_range(p, closest_separation, max(p%w2, edge*p%sigma), &
            max(p%w2, edge*p%sigma, -closest_separation) + 10.0_wp*p%sigma, anchor, y, lower, &
            upper, exponent)
         anchor = anchor/p%sigma
         first = sqrt(max(anchor - edge + lower, p%w2/p%sigma - edge, 0.0_wp))
         last = sqrt(anchor - edge + upper)
      end associate
   end subroutine find_plastic_range

   pure function sum_plastic(properties, closest_separation, retraction, ends) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction, ends(0:)
      type(piece_type) :: piece
      real(wp) :: u, edge, anchor, y, first, last, width, start, v, scale, t, recovery
      real(wp), dimension(n) :: exponents, density, weight, left, radius
      integer :: panel, i

      piece = no_summits
      associate (p => properties)
         u = retraction/p%w1
         ! deformations in sigma from here
         edge = 0.5_wp*(p%yield_factor*u)**2*p%w1/p%sigma
         call find_plastic_range(p, closest_separation, edge, anchor, y, first, last, &
            piece%exponent)
         scale = 2.0_wp*p%sigma/(p%w1*p%yield_factor**2)
         do panel = 1, ubound(ends, 1)
            width = (last - first)*(ends(panel) - ends(panel - 1))
            start = first + (last - first)*ends(panel - 1)
            do i = 1, n
               v = start + width*points(i)
               weight(i) = weights(i)*v
               v = v*v
               t = v - (anchor - edge)
               exponents(i) = max(min(-t*(y + 0.5_wp*t), 0.0_wp), lowest_exponent)
               left(i) = scale*v
               recovery = sqrt(u*u + left(i))
               left(i) = left(i)/(recovery + u)
               radius(i) = p%yield_factor*sqrt(recovery*left(i))
            end do
            call exponentials(n, exponents, density)
            call add_summits(piece, 2.0_wp*phi_0*width, weight, density, radius, left)
         end do
      end associate
   end function sum_plastic

   !> The energy alone at a retraction of zero, 2/5 k e^3 a summit: fewer roots and sums.
   pure real(wp) function sum_plastic_energy(properties, separation, ends) result(energy)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, ends(0:)
      real(wp) :: exponent, anchor, y, first, last, width, start, v, t, part(2)
      real(wp), dimension(n) :: exponents, density, weight
      integer :: panel, i, j

      associate (p => properties)
         call find_plastic_range(p, separation, 0.0_wp, anchor, y, first, last, exponent)
         energy = 0.0_wp
         do panel = 1, ubound(ends, 1)
            width = (last - first)*(ends(panel) - ends(panel - 1))
            start = first + (last - first)*ends(panel - 1)
            do i = 1, n
               v = start + width*points(i)
               weight(i) = weights(i)*(v*v)**2
               t = v*v - anchor
               exponents(i) = max(min(-t*(y + 0.5_wp*t), 0.0_wp), lowest_exponent)
            end do
            call exponentials(n, exponents, density)
            part = 0.0_wp
            do i = 0, n - 2, 2
               do j = 1, 2
                  part(j) = part(j) + weight(i + j)*density(i + j)
               end do
            end do
            energy = energy + width*(part(1) + part(2))
         end do
         t = p%sigma/p%w1
         energy = 0.4_wp*2.0_wp*phi_0/p%yield_factor**2*(2.0_wp*t)*sqrt(2.0_wp*t)*energy
      end associate
   end function sum_plastic_energy

end module asperity_law_unloading_plastic_pieces

! src/law/unloading/law.f90
!> The law of a rough face that remembers how close it came: every summit unloads from its own
!> largest deformation (see `asperity_law_unloading_summit`). One number is remembered, the closest
!> separation d_m; summits higher than d_m have the largest deformation w = z - d_m. At
!> d = d_m + u the pressure is eta Int N_u(w) phi(d_m + w) dw over the summits that still touch,
!> e(w) > u, and alike for area, stiffness and stored energy.
!>
!> The virgin branch and the elastic summits are those of the law without memory. The paper's law
!> has none; this one is Etsion, Kligerman and Kadin's idea with the paper's summits.
module asperity_law_unloading_law
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_law, only: apply_decay, evaluate_pressure, evaluate_scaled_law, &
      is_closed_too_far, normal_response, sum_pieces
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: relative_exponent
   use asperity_law_quadrature_pieces_by_fixed_rule, only: fixed_elastoplastic_piece, &
      fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastoplastic_piece, no_summits, &
      piece_type, plastic_piece
   use asperity_law_unloading_pieces, only: elastic_unloading_piece, elastoplastic_unloading_piece
   use asperity_law_unloading_plastic_pieces, only: plastic_unloading_piece, &
      recoverable_plastic_energy
   use asperity_law_unloading_summit, only: find_contact_edge
   use asperity_law_validity, only: closure_above_half_radius, memory_beyond_data
   implicit none
   private
   public :: evaluate_unloading_law, evaluate_unloading_branch, evaluate_virgin_pressure, &
      unloading_stiffness, plastic_dissipation, is_flattened_too_far

   !> Mean deformation over w1 of the summits in contact up to which unloading was computed
   real(wp), parameter :: largest_mean_ratio = 170.0_wp
   !> Larger retractions over w1 are taken for this one: all is zero long before, and its powers are
   !> finite
   real(wp), parameter :: largest_retraction = 1.0e60_wp

contains

   !> Evaluate the law with memory at the separation closest_separation + retraction. With a
   !> retraction of zero or less the face is as close as never before: pressure, stiffness and area
   !> are those of the law without memory. The energy is what is recoverable; it and the plastic
   !> dissipation add up to the work since first touch wherever the face was pressed without pause.
   !> Relative error below 1e-11 in every component that is a normal number, for
   !> -8 <= d_m/sigma <= 8, 1e-6 <= w1/sigma <= 1e2, and retractions until the pressure is 1e-12 of
   !> that at d_m.
   pure elemental function evaluate_unloading_law(properties, closest_separation, retraction) &
         result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm
      real(wp), intent(in) :: retraction
      type(normal_response) :: response

      if (retraction > 0.0_wp) then
         call evaluate_unloading_branch(properties, closest_separation, retraction, response)
         response%plastic_dissipation = plastic_dissipation(properties, closest_separation)
      else
         call evaluate_virgin_branch(properties, closest_separation + retraction, response)
      end if
   end function evaluate_unloading_law

   !> The virgin branch: the law without memory, and its work as what is recoverable and what is
   !> not.
   pure subroutine evaluate_virgin_branch(properties, separation, response)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(normal_response), intent(out) :: response
      type(piece_type) :: pieces(3)
      real(wp) :: decay

      call evaluate_scaled_law(properties, separation, response, pieces=pieces)
      associate (p => properties, r => response)
         decay = decay_at(p, separation)
         call split_work(p, separation, pieces, r%energy, r%plastic_dissipation)
         r%plastic_dissipation = r%plastic_dissipation*decay
         r%validity = ior(r%validity, memory_flags(p, separation))
         call apply_decay(p, decay, r)
      end associate
   end subroutine evaluate_virgin_branch

   !> What a contact point needs of the virgin branch, in less time: no shares, no contact density.
   pure subroutine evaluate_virgin_pressure(properties, separation, pressure, stiffness, energy, &
         dissipation, validity)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation, the closest so far, mm
      real(wp), intent(in) :: separation
      !> Pressure, MPa; stiffness of closing, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Recoverable energy and plastic dissipation since first touch, per nominal area, N/mm
      real(wp), intent(out) :: energy, dissipation
      !> `valid`, or flags
      integer, intent(out) :: validity
      type(piece_type) :: pieces(3)
      real(wp) :: decay

      call evaluate_pressure(properties, separation, pressure, stiffness, energy, validity, pieces)
      decay = decay_at(properties, separation)
      call split_work(properties, separation, pieces, energy, dissipation)
      energy = energy*decay
      dissipation = dissipation*decay
      validity = ior(validity, memory_flags(properties, separation))
   end subroutine evaluate_virgin_pressure

   !> Recoverable energy and plastic dissipation, scaled, of the pieces of the law without memory.
   pure subroutine split_work(properties, separation, pieces, energy, plastic_dissipation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type), intent(in) :: pieces(3)
      real(wp), intent(out) :: energy, plastic_dissipation
      real(wp) :: recoverable, factor(3)
      integer :: i

      recoverable = recoverable_plastic_energy(properties, separation)
      do i = 1, 3
         factor(i) = properties%eta*properties%n1*properties%w1
         if (pieces(i)%exponent > 0.0_wp) factor(i) = factor(i)*exp(-pieces(i)%exponent)
      end do
      energy = factor(1)*pieces(1)%energy + factor(2)*pieces(2)%recoverable + factor(3)*recoverable
      plastic_dissipation = factor(2)*pieces(2)%dissipation &
         + factor(3)*(pieces(3)%energy - recoverable)
   end subroutine split_work

   !> The unloading branch without the plastic dissipation, a constant on it.
   pure subroutine evaluate_unloading_branch(properties, closest_separation, retraction, response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Its `plastic_dissipation` is zero
      type(normal_response), intent(out) :: response
      type(piece_type) :: pieces(3)
      real(wp) :: u, edge, log_edge, shift, h, y, moments(0:2)

      u = min(retraction, largest_retraction*properties%w1)
      call find_contact_edge(properties, u, edge, log_edge)
      pieces(1) = elastic_unloading_piece(properties, closest_separation, u)
      pieces(2) = elastoplastic_unloading_piece(properties, closest_separation, u, edge, log_edge)
      pieces(3) = plastic_unloading_piece(properties, closest_separation, u)
      ! the largest piece keeps its digits where all underflow
      shift = minval(pieces%exponent, mask=pieces%pressure > 0.0_wp)
      pieces%exponent = max(pieces%exponent - shift, 0.0_wp)
      call sum_pieces(properties, pieces, response)
      associate (p => properties, r => response)
         h = closest_separation/p%sigma
         y = h + edge/p%sigma
         call find_tail_moments(y, moments)
         r%contact_density = p%eta*moments(0) &
            *exp(min(shift - relative_exponent(h, edge/p%sigma, max(y, 0.0_wp)), 0.0_wp))
         r%validity = ior(p%validity, memory_flags(p, closest_separation))
         call apply_decay(p, exp(-shift)*decay_at(p, closest_separation), r)
      end associate
   end subroutine evaluate_unloading_branch

   !> Stiffness at the closest separation for parting from it, MPa/mm.
   pure elemental real(wp) function unloading_stiffness(properties, closest_separation) &
         result(stiffness)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      type(normal_response) :: response

      call evaluate_unloading_branch(properties, closest_separation, 0.0_wp, response)
      stiffness = response%stiffness
   end function unloading_stiffness

   !> Plastic dissipation per nominal area from first touch up to the closest separation, N/mm:
   !> virgin work less what is recoverable, summed as a difference summit by summit. It never falls
   !> as the face comes closer.
   pure elemental real(wp) function plastic_dissipation(properties, closest_separation) &
         result(dissipation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      type(piece_type) :: pieces(3)
      real(wp) :: h, energy

      h = closest_separation/properties%sigma
      pieces(1) = no_summits
      if (fixed_pieces_serve(properties, h)) then
         pieces(2) = fixed_elastoplastic_piece(properties, h)
      else
         pieces(2) = elastoplastic_piece(properties, closest_separation, .true.)
      end if
      pieces(3) = plastic_piece(properties, closest_separation)
      call split_work(properties, closest_separation, pieces, energy, dissipation)
      dissipation = dissipation*decay_at(properties, closest_separation)
   end function plastic_dissipation

   !> The factor that scaled values lack.
   pure real(wp) function decay_at(properties, separation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation

      decay_at = exp(-0.5_wp*max(separation/properties%sigma, 0.0_wp)**2)
   end function decay_at

   !> Flags of the deformations at the closest separation, which the face remembers.
   pure integer function memory_flags(properties, closest_separation) result(flags)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation
      real(wp) :: moments(0:2)

      flags = 0
      associate (p => properties)
         if (closest_separation > p%vanishing_separation) return
         ! above the mean plane summits in contact are closed by 0.8 sigma or less in the mean
         if (closest_separation > 0.0_wp .and. 0.8_wp*p%sigma < min(0.5_wp*p%radius, &
            largest_mean_ratio*p%w1)) return
         call find_tail_moments(closest_separation/p%sigma, moments)
         if (is_closed_too_far(p, closest_separation, moments)) flags = closure_above_half_radius
         if (is_flattened_too_far(p, moments)) flags = ior(flags, memory_beyond_data)
      end associate
   end function memory_flags

   !> Whether the summits in contact are deformed further in the mean than unloading is known for.
   pure logical function is_flattened_too_far(properties, moments)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> `find_tail_moments` of the closest separation over sigma
      real(wp), intent(in) :: moments(0:2)

      is_flattened_too_far = properties%sigma*moments(1) &
         > largest_mean_ratio*properties%w1*moments(0)
   end function is_flattened_too_far

end module asperity_law_unloading_law

! src/law/unloading/compile_cell.f90
!> Compiles the pieces of the law with memory: values of the direct law at Chebyshev-Lobatto points
!> become the polynomials of `asperity_law_unloading_cell`. Cells are halved until the stiffness is
!> a good polynomial of its own variable at three closest separations of the strip.
module asperity_law_unloading_compile_cell
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_cell, only: degree_h, degree_x, strip_half_width, &
      strip_polynomial, unloading_cell
   use asperity_law_unloading_chebyshev, only: chebyshev_coefficients, chebyshev_points, &
      powers_of_chebyshev
   use asperity_law_unloading_law, only: evaluate_unloading_branch
   implicit none
   private
   public :: unloaded, fit_in_strip, divide_region, compile_cell

   !> Last Chebyshev coefficients of a good polynomial, over its smallest value
   real(wp), parameter :: good_tail = 1.0e-10_wp
   !> A region is halved at most so often
   integer, parameter :: most_halvings = 12
   !> Below it a value has not all its digits, or none
   real(wp), parameter :: smallest_value = 1.0e-300_wp

contains

   !> The direct law on the unloading branch, by numbers over sigma.
   pure elemental function unloaded(properties, h, u) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation and retraction over sigma
      real(wp), intent(in) :: h, u
      type(normal_response) :: response

      call evaluate_unloading_branch(properties, h*properties%sigma, u*properties%sigma, response)
   end function unloaded

   pure elemental real(wp) function stiffness_at(properties, h, u) result(stiffness)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h, u
      type(normal_response) :: response

      response = unloaded(properties, h, u)
      stiffness = response%stiffness
   end function stiffness_at

   !> A polynomial of h through values at the points of a strip; zero where they are about to
   !> underflow.
   pure subroutine fit_in_strip(polynomial, values)
      !> Result
      type(strip_polynomial), intent(out) :: polynomial
      !> At `chebyshev_points`
      real(wp), intent(in) :: values(0:degree_h)

      if (.not. all(values > smallest_value)) return
      polynomial%decay = 0.5_wp*log(values(0)/values(degree_h))
      polynomial%coefficients = powers_of_chebyshev(chebyshev_coefficients( &
         values*exp(polynomial%decay*chebyshev_points(degree_h))), 1.0_wp, 0.0_wp)
   end subroutine fit_in_strip

   !> Append the cells of a region of the retraction, halved until each is good.
   pure recursive subroutine divide_region(properties, middle, from, to, root, starts, roots, &
         halvings)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Middle of the strip
      real(wp), intent(in) :: middle
      !> Ends of the region over sigma
      real(wp), intent(in) :: from, to
      !> Whether summits of one stage lose contact at the upper end
      logical, intent(in) :: root
      !> Where cells start, over sigma, and whether x is a root in them
      real(wp), allocatable, intent(inout) :: starts(:)
      logical, allocatable, intent(inout) :: roots(:)
      !> How often the region was halved so far
      integer, intent(in) :: halvings
      real(wp), allocatable :: more_starts(:)
      logical, allocatable :: more_roots(:)
      real(wp) :: half

      if (halvings == most_halvings .or. is_good(properties, middle, from, to, root)) then
         allocate (more_starts(size(starts) + 1), source=[starts, from])
         call move_alloc(more_starts, starts)
         allocate (more_roots(size(roots) + 1), source=[roots, root])
         call move_alloc(more_roots, roots)
      else
         half = 0.5_wp*(from + to)
         ! the law is the less smooth the nearer zero retraction is
         if (from > 0.0_wp .and. to > 4.0_wp*from) half = sqrt(from*to)
         call divide_region(properties, middle, from, half, .false., starts, roots, halvings + 1)
         call divide_region(properties, middle, half, to, root, starts, roots, halvings + 1)
      end if
   end subroutine divide_region

   !> Whether the stiffness is a good polynomial of x in the middle and at both ends of the strip.
   pure logical function is_good(properties, middle, from, to, root)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle, from, to
      logical, intent(in) :: root
      real(wp), dimension(0:degree_x) :: u, stiffness, c
      integer :: i

      u = points_of(from, to, root)
      do i = -1, 1
         stiffness = stiffness_at(properties, middle + i*strip_half_width, u)
         c = chebyshev_coefficients(stiffness)
         is_good = maxval(abs(c(degree_x - 1:))) < good_tail*minval(stiffness)
         if (.not. is_good) return
      end do
   end function is_good

   !> Retractions over sigma at the points of a cell.
   pure function points_of(from, to, root) result(u)
      real(wp), intent(in) :: from, to
      logical, intent(in) :: root
      real(wp) :: u(0:degree_x)

      associate (t => chebyshev_points(degree_x))
         if (root) then
            u = to - (to - from)*(0.5_wp*(1.0_wp + t))**2
         else
            u = 0.5_wp*(from + to) - 0.5_wp*(to - from)*t
         end if
      end associate
   end function points_of

   !> The polynomials of one cell of the strip about `middle`.
   pure subroutine compile_cell(cell, properties, middle, from, to, root)
      !> Result
      type(unloading_cell), intent(out) :: cell
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Middle of the strip, and ends of the cell over sigma
      real(wp), intent(in) :: middle, from, to
      !> Whether x is a root
      logical, intent(in) :: root
      type(normal_response) :: r
      real(wp) :: c(0:degree_x + 2, 0:degree_h), h(0:degree_h), u(0:degree_x), scale, shift
      integer :: i

      if (root) then
         cell%origin = to
         cell%inverse_size = 1.0_wp/(to - from)
         cell%power = 2
         scale = 2.0_wp
         shift = -1.0_wp
      else
         cell%origin = 0.5_wp*(from + to)
         cell%inverse_size = 2.0_wp/(to - from)
         cell%power = 1
         scale = 1.0_wp
         shift = 0.0_wp
      end if
      cell%length = properties%sigma/cell%inverse_size
      h = middle + strip_half_width*chebyshev_points(degree_h)
      do i = 0, degree_h
         r = unloaded(properties, h(i), cell%origin)
         c(0:1, i) = [r%energy, r%pressure]
      end do
      cell%decay = 0.5_wp*log(c(1, 0)/c(1, degree_h))
      u = points_of(from, to, root)
      do i = 0, degree_h
         c(2:, i) = powers_of_chebyshev(chebyshev_coefficients( &
            stiffness_at(properties, h(i), u)), scale, shift)
         c(:, i) = c(:, i)*exp(cell%decay*(h(i) - middle)/strip_half_width)
      end do
      do i = 0, degree_x + 2
         cell%coefficients(i, :) = powers_of_chebyshev(chebyshev_coefficients(c(i, :)), 1.0_wp, &
            0.0_wp)
      end do
   end subroutine compile_cell

end module asperity_law_unloading_compile_cell

! src/law/unloading/compiled_law.f90
!> The law with memory compiled to polynomials, for very many evaluations: pressure, stiffness and
!> recoverable energy within 1e-9 of the direct law. Built once from the properties by
!> `asperity_law_unloading_compile_law`, then read only, so that threads share it.
!>
!> The virgin branch is the compiled law without memory; what that lacks, the recoverable energy and
!> the plastic dissipation, are polynomials of h = d/sigma in strips of h. On the unloading branch
!> each strip of h_m = d_m/sigma is divided into cells of the retraction, as many as the properties
!> ask for (see `asperity_law_unloading_cell`): about 120 in all, 300 kB.
!>
!> Cells cover -8 <= h_m < 8 and the retractions until the pressure is 1e-12 of that at the closest
!> separation. Outside, and on the virgin branch outside -8 <= h < 36, the direct law is evaluated.
!> Verified for 1e-6 <= w1/sigma <= 1e2. A plastic dissipation below 1e-260 N/mm may be zero.
module asperity_law_unloading_compiled_law
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_intervals, only: first
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_gaussian_tail, only: vanishing_height
   use asperity_law_normal_law, only: normal_response
   use asperity_law_unloading_cell, only: evaluate_cell, strip_half_width, strip_polynomial, &
      unloading_cell, value_in_strip
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      memory_beyond_data, pressure_above_hardness
   implicit none
   private
   public :: compiled_unloading_law, evaluate_compiled_unloading_law, &
      compiled_plastic_dissipation, size_in_bytes

   !> Number of strips of h, and how many of them have cells
   integer, parameter, public :: n_strips = 22, n_strips_with_cells = 8
   !> Where the real area falls to the nominal one is bracketed at this many h a sigma
   integer, parameter, public :: brackets_per_sigma = 16
   integer, parameter, public :: n_brackets = nint(2.0_wp*strip_half_width)*n_strips_with_cells &
      *brackets_per_sigma

   !> The law with memory of one pair of faces, compiled. Build it with
   !> `new_compiled_unloading_law`; read only after: all is for the evaluation.
   type :: compiled_unloading_law
      !> The virgin branch
      type(compiled_law) :: virgin
      !> Separation over sigma below which `memory_beyond_data` is set
      real(wp) :: memory_limit
      !> Retraction over sigma beyond which nothing touches
      real(wp) :: vanishing_retraction
      !> Of the virgin branch
      type(strip_polynomial) :: energy(n_strips), plastic_dissipation(n_strips)
      !> Number of the first cell of a strip, and retraction over sigma at the end of the last
      integer :: first_cell(n_strips_with_cells + 1)
      real(wp) :: furthest(n_strips_with_cells)
      !> Retractions over sigma at which the cells start
      real(wp), allocatable :: starts(:)
      type(unloading_cell), allocatable :: cells(:)
      !> Retractions over sigma, below and above that at which the real area is the nominal one
      real(wp) :: area_bracket(2, 0:n_brackets)
   end type compiled_unloading_law

contains

   !> Pressure, stiffness and recoverable energy, and validity, at one closest separation and
   !> retraction: on the virgin branch where the retraction is zero or less (see
   !> `evaluate_unloading_law`).
   pure elemental subroutine evaluate_compiled_unloading_law(law, closest_separation, retraction, &
         pressure, stiffness, energy, validity)
      !> Compiled law
      type(compiled_unloading_law), intent(in) :: law
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one so far, mm
      real(wp), intent(in) :: retraction
      !> Pressure, MPa, and stiffness at fixed memory, MPa/mm
      real(wp), intent(out) :: pressure, stiffness
      !> Recoverable energy, N/mm
      real(wp), intent(out) :: energy
      !> Sum of flags (see `asperity_law_validity`)
      integer, intent(out) :: validity
      real(wp) :: h, u
      integer :: strip
      type(normal_response) :: direct

      h = closest_separation*law%virgin%inverse_sigma
      u = retraction*law%virgin%inverse_sigma
      if (.not. u > 0.0_wp) then
         call evaluate_virgin(law, closest_separation + retraction, pressure, stiffness, energy, &
            validity)
         return
      end if
      strip = strip_at(h)
      if (strip >= 1 .and. strip <= n_strips_with_cells) then
         if (u < law%furthest(strip)) then
            associate (i => cell_at(law, strip, u))
               call evaluate_cell(law%cells(i), place_in_strip(h, strip), u, pressure, &
                  stiffness, energy)
            end associate
            validity = flags_at(law, h, u, pressure)
            return
         end if
         if (u > law%vanishing_retraction) then
            pressure = 0.0_wp
            stiffness = 0.0_wp
            energy = 0.0_wp
            validity = flags_at(law, h, u, pressure)
            return
         end if
      end if
      direct = evaluate_unloading_law(law%virgin%properties, closest_separation, retraction)
      pressure = direct%pressure
      stiffness = direct%stiffness
      energy = direct%energy
      validity = direct%validity
   end subroutine evaluate_compiled_unloading_law

   !> Plastic dissipation since first touch, N/mm: a function of the closest separation alone.
   pure elemental real(wp) function compiled_plastic_dissipation(law, closest_separation) &
         result(dissipation)
      !> Compiled law
      type(compiled_unloading_law), intent(in) :: law
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      real(wp) :: h
      integer :: strip
      type(normal_response) :: direct

      h = closest_separation*law%virgin%inverse_sigma
      strip = strip_at(h)
      if (strip >= 1 .and. strip <= n_strips) then
         dissipation = value_in_strip(law%plastic_dissipation(strip), place_in_strip(h, strip))
      else
         direct = evaluate_unloading_law(law%virgin%properties, closest_separation, 0.0_wp)
         dissipation = direct%plastic_dissipation
      end if
   end function compiled_plastic_dissipation

   !> Size of a compiled law in memory, bytes.
   pure integer function size_in_bytes(law)
      !> Compiled law
      type(compiled_unloading_law), intent(in) :: law
      type(unloading_cell) :: cell

      size_in_bytes = (storage_size(law) + size(law%cells)*storage_size(cell) &
         + size(law%starts)*storage_size(law%starts))/8
   end function size_in_bytes

   !> The virgin branch.
   pure subroutine evaluate_virgin(law, separation, pressure, stiffness, energy, validity)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp), intent(out) :: pressure, stiffness, energy
      integer, intent(out) :: validity
      real(wp) :: h
      integer :: strip
      type(normal_response) :: direct

      h = separation*law%virgin%inverse_sigma
      call evaluate_compiled_law(law%virgin, separation, pressure, stiffness, validity=validity)
      if (h < law%memory_limit) validity = ior(validity, memory_beyond_data)
      strip = strip_at(h)
      if (strip >= 1 .and. strip <= n_strips) then
         energy = value_in_strip(law%energy(strip), place_in_strip(h, strip))
      else if (h > vanishing_height) then
         energy = 0.0_wp
      else
         direct = evaluate_unloading_law(law%virgin%properties, separation, 0.0_wp)
         energy = direct%energy
         validity = direct%validity
      end if
   end subroutine evaluate_virgin

   !> Number of the strip that holds an h, 1 to `n_strips`; 0 where none does.
   pure integer function strip_at(h)
      real(wp), intent(in) :: h
      real(wp) :: strips

      strips = (h - first)*(0.5_wp/strip_half_width)
      strip_at = 0
      if (strips >= 0.0_wp .and. strips < n_strips) strip_at = 1 + int(strips)
   end function strip_at

   !> Place of an h in its strip, -1 to 1.
   pure real(wp) function place_in_strip(h, strip) result(t)
      real(wp), intent(in) :: h
      integer, intent(in) :: strip

      t = (h - first)/strip_half_width - (2*strip - 1)
   end function place_in_strip

   !> Number of the cell that holds a retraction over sigma.
   pure integer function cell_at(law, strip, u)
      type(compiled_unloading_law), intent(in) :: law
      integer, intent(in) :: strip
      real(wp), intent(in) :: u
      integer :: i

      cell_at = law%first_cell(strip)
      do i = law%first_cell(strip) + 1, law%first_cell(strip + 1) - 1
         if (law%starts(i) <= u) cell_at = cell_at + 1
      end do
   end function cell_at

   !> Flags on the unloading branch.
   pure integer function flags_at(law, h, u, pressure) result(flags)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h, u, pressure

      flags = law%virgin%properties%validity
      if (pressure > law%virgin%properties%hardness) flags = ior(flags, pressure_above_hardness)
      if (h < law%virgin%limits(3)) flags = ior(flags, closure_above_half_radius)
      if (h < law%memory_limit) flags = ior(flags, memory_beyond_data)
      ! the area falls as a face parts: never above nominal unless it was at the closest separation
      if (h < law%virgin%limits(1)) then
         if (area_is_above_nominal(law, h, u)) flags = ior(flags, area_above_nominal)
      end if
   end function flags_at

   !> Whether the real area is above the nominal one: by the retraction alone, or by the direct law
   !> where that is too close to tell.
   pure logical function area_is_above_nominal(law, h, u)
      type(compiled_unloading_law), intent(in) :: law
      real(wp), intent(in) :: h, u
      type(normal_response) :: direct
      integer :: i

      i = int((h - first)*brackets_per_sigma)
      area_is_above_nominal = u < law%area_bracket(1, i + 1)
      if (area_is_above_nominal .or. u > law%area_bracket(2, i)) return
      associate (p => law%virgin%properties)
         direct = evaluate_unloading_law(p, h*p%sigma, u*p%sigma)
      end associate
      area_is_above_nominal = direct%area_fraction > 1.0_wp
   end function area_is_above_nominal

end module asperity_law_unloading_compiled_law

! src/law/unloading/inverse.f90
!> Inverse of the unloading branch: how far a face has parted when its pressure has fallen to a
!> given one.
module asperity_law_unloading_inverse
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_law, only: evaluate_unloading_branch
   implicit none
   private
   public :: retraction_for_pressure

   integer, parameter :: max_iterations = 200

contains

   !> Retraction from the closest separation at which the pressure is the given one, mm, to
   !> round-off of the direct evaluation; zero when it is that of the closest separation or above.
   !> Newton on ln p, which falls ever steeper, kept inside a bracket.
   pure real(wp) function retraction_for_pressure(properties, closest_separation, pressure) &
         result(retraction)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Pressure, MPa; below the smallest normal number, zero too, it is taken for that
      real(wp), intent(in) :: pressure
      type(normal_response) :: response
      real(wp) :: sought, near, far, next, step, small, mismatch
      integer :: iteration
      logical :: settled

      retraction = 0.0_wp
      sought = pressure
      ! the pressure falls to zero by underflow alone, and never below
      if (pressure < tiny(1.0_wp)) sought = tiny(1.0_wp)
      response = evaluate_normal_law(properties, closest_separation)
      if (.not. response%pressure > sought) return
      near = 0.0_wp
      far = properties%w1
      do
         call evaluate_unloading_branch(properties, closest_separation, far, response)
         if (.not. response%pressure >= sought) exit
         near = far
         far = 2.0_wp*far
      end do

      retraction = far
      settled = .false.
      do iteration = 1, max_iterations
         step = huge(1.0_wp)
         small = 1.0e-9_wp*retraction
         if (response%pressure >= tiny(1.0_wp)) then
            mismatch = log(response%pressure) - log(sought)
            if (abs(mismatch) < 0.5_wp) mismatch = log(response%pressure/sought)
            step = mismatch*response%pressure/response%stiffness
            small = 1.0e-9_wp*max(retraction, response%pressure/response%stiffness)
         end if
         if (.not. (step >= near - retraction .and. step <= far - retraction) &
               .and. abs(step) > small) step = 0.5_wp*(near + far) - retraction
         next = max(retraction + step, 0.0_wp)
         if (settled .or. .not. abs(next - retraction) > 0.0_wp) exit
         ! Newton is quadratic: one more step from here is at round-off
         settled = abs(step) <= small
         retraction = next
         call evaluate_unloading_branch(properties, closest_separation, retraction, response)
         if (response%pressure >= sought) then
            near = retraction
         else
            far = retraction
         end if
      end do
      retraction = next
   end function retraction_for_pressure

end module asperity_law_unloading_inverse

! src/law/unloading/compile_law.f90
!> Compiles the law with memory: divides the range of closest separation and retraction, compiles
!> each piece (see `asperity_law_unloading_compile_cell`), and finds where the law's limits are
!> passed.
module asperity_law_unloading_compile_law
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_intervals, only: first
   use asperity_law_gaussian_tail, only: find_tail_moments, vanishing_height
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties, unloading_elastic
   use asperity_law_unloading_cell, only: degree_h, strip_half_width
   use asperity_law_unloading_chebyshev, only: chebyshev_points
   use asperity_law_unloading_compile_cell, only: compile_cell, divide_region, &
      fit_in_strip, unloaded
   use asperity_law_unloading_compiled_law, only: brackets_per_sigma, compiled_unloading_law, &
      n_brackets, n_strips, n_strips_with_cells
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law, is_flattened_too_far
   use asperity_law_unloading_summit, only: elastic_recovery
   implicit none
   private
   public :: new_compiled_unloading_law

   !> Pressure over that at the closest separation down to which there are cells
   real(wp), parameter :: smallest_pressure_ratio = 1.0e-12_wp

contains

   !> Compile the law. `error` is set when the properties were never built or have no memory.
   pure subroutine new_compiled_unloading_law(law, properties, error)
      !> Result
      type(compiled_unloading_law), intent(out) :: law
      !> Checked properties, with elastic unloading
      type(normal_properties), intent(in) :: properties
      !> Set when the properties were never built or have no memory
      type(error_type), allocatable, intent(out) :: error
      integer :: strip

      call new_compiled_law(law%virgin, properties, error)
      if (allocated(error)) return
      if (properties%unloading /= unloading_elastic) then
         call fatal_error(error, 'the law has no memory (unloading is reversible): compile it '// &
            'with new_compiled_law')
         return
      end if
      do strip = 1, n_strips
         call compile_strip(law, strip)
      end do
      call compile_cells(law)
      call find_memory_limit(law)
      call bracket_area(law)
      associate (p => properties)
         law%vanishing_retraction = elastic_recovery(p, (vanishing_height - first)*p%sigma) &
            /p%sigma
      end associate
   end subroutine new_compiled_unloading_law

   !> Middle of a strip of h.
   pure real(wp) function middle_of(strip)
      integer, intent(in) :: strip

      middle_of = first + strip_half_width*(2*strip - 1)
   end function middle_of

   !> Recoverable energy and plastic dissipation of the virgin branch in one strip.
   pure subroutine compile_strip(law, strip)
      type(compiled_unloading_law), intent(inout) :: law
      integer, intent(in) :: strip
      real(wp), dimension(0:degree_h) :: h, energy, dissipation
      type(normal_response) :: r
      integer :: i

      h = middle_of(strip) + strip_half_width*chebyshev_points(degree_h)
      do i = 0, degree_h
         r = evaluate_unloading_law(law%virgin%properties, h(i)*law%virgin%properties%sigma, 0.0_wp)
         energy(i) = r%energy
         dissipation(i) = r%plastic_dissipation
      end do
      call fit_in_strip(law%energy(strip), energy)
      call fit_in_strip(law%plastic_dissipation(strip), dissipation)
   end subroutine compile_strip

   !> The cells of the unloading branch.
   pure subroutine compile_cells(law)
      type(compiled_unloading_law), intent(inout) :: law
      real(wp), allocatable :: starts(:)
      logical, allocatable :: roots(:)
      real(wp) :: to
      integer :: strip, i

      allocate (starts(0), roots(0))
      do strip = 1, n_strips_with_cells
         law%first_cell(strip) = size(starts) + 1
         call divide_strip(law%virgin%properties, middle_of(strip), starts, roots, &
            law%furthest(strip))
      end do
      law%first_cell(n_strips_with_cells + 1) = size(starts) + 1
      allocate (law%cells(size(starts)))
      do strip = 1, n_strips_with_cells
         to = law%furthest(strip)
         do i = law%first_cell(strip + 1) - 1, law%first_cell(strip), -1
            call compile_cell(law%cells(i), law%virgin%properties, middle_of(strip), starts(i), &
               to, roots(i))
            to = starts(i)
         end do
      end do
      call move_alloc(starts, law%starts)
   end subroutine compile_cells

   !> Append the cells of one strip, and find the end of the last.
   pure subroutine divide_strip(properties, middle, starts, roots, furthest)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: middle
      real(wp), allocatable, intent(inout) :: starts(:)
      logical, allocatable, intent(inout) :: roots(:)
      real(wp), intent(out) :: furthest
      real(wp) :: ends(2), from, d
      type(normal_response) :: r
      integer :: i

      associate (p => properties)
         furthest = 0.0_wp
         do i = -1, 1, 2
            d = p%sigma*(middle + i*strip_half_width)
            r = evaluate_normal_law(p, d)
            furthest = max(furthest, &
               retraction_for_pressure(p, d, smallest_pressure_ratio*r%pressure)/p%sigma)
         end do
         ! where the last elastic and the last elasto-plastic summits part
         ends = [p%w1, elastic_recovery(p, p%w2)]/p%sigma
         from = 0.0_wp
         do i = 1, 2
            if (ends(i) >= furthest) exit
            call divide_region(p, middle, from, ends(i), .true., starts, roots, 0)
            from = ends(i)
         end do
         call divide_region(p, middle, from, furthest, .false., starts, roots, 0)
      end associate
   end subroutine divide_strip

   !> Find, by bisection, where the mean deformation passes what unloading is known for.
   pure subroutine find_memory_limit(law)
      type(compiled_unloading_law), intent(inout) :: law
      real(wp) :: near, distant, h

      associate (p => law%virgin%properties)
         law%memory_limit = first
         if (.not. passes_memory(p, first)) return
         near = first
         distant = vanishing_height
         do while (distant - near > epsilon(h)*max(1.0_wp, abs(near)))
            h = 0.5_wp*(near + distant)
            if (passes_memory(p, h)) then
               near = h
            else
               distant = h
            end if
         end do
      end associate
      law%memory_limit = distant
   end subroutine find_memory_limit

   !> Whether summits are flattened too far at a closest separation over sigma.
   pure logical function passes_memory(properties, h)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h
      real(wp) :: moments(0:2)

      call find_tail_moments(h, moments)
      passes_memory = is_flattened_too_far(properties, moments)
   end function passes_memory

   !> Bracket the retractions at which the real area is the nominal one, from the largest closest
   !> separation at which it is ever above: they rise as the closest separation falls.
   pure subroutine bracket_area(law)
      type(compiled_unloading_law), intent(inout) :: law
      integer, parameter :: halvings = 5
      real(wp) :: h, below, above, step, u
      type(normal_response) :: r
      integer :: i, j, n

      law%area_bracket = 0.0_wp
      below = 0.0_wp
      step = 1.0e-3_wp
      associate (p => law%virgin%properties, limit => law%virgin%limits(1))
         n = min(n_brackets, int((min(limit, vanishing_height) - first)*brackets_per_sigma))
         do i = n, 0, -1
            h = first + real(i, wp)/brackets_per_sigma
            do
               above = below + step
               r = unloaded(p, h, above)
               if (.not. r%area_fraction > 1.0_wp) exit
               below = above
               step = 2.0_wp*step
            end do
            do j = 1, halvings
               u = 0.5_wp*(below + above)
               r = unloaded(p, h, u)
               if (r%area_fraction > 1.0_wp) then
                  below = u
               else
                  above = u
               end if
            end do
            law%area_bracket(:, i) = [below, above]
            step = max(step/16.0_wp, above - below)
         end do
      end associate
   end subroutine bracket_area

end module asperity_law_unloading_compile_law

! src/contact/properties.f90
!> Properties of one pair of faces: the normal law, friction and the datum of the overclosure.
module asperity_contact_properties
   use asperity_base_checks, only: check_positive, check_range, largest_positive, &
      smallest_positive
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_check_friction, only: check_friction, is_plain
   use asperity_contact_friction_settings, only: friction_settings, largest_friction, &
      stick_critical_slip
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: compiled_law
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties, &
      unloading_elastic
   use asperity_law_plausibility, only: check_plausible_length, length_max
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_unloading_law
   use asperity_paper_pairs, only: pair_preset
   implicit none
   private
   public :: contact_properties, new_contact_properties, complete_contact_properties, &
      compile_normal_law, without_summits

   !> What happens to the elastic slip when the pressure changes
   enum, bind(c)
      !> The elastic slip stays: shear stress follows the pressure, as in ABAQUS' own friction
      enumerator :: rule_abaqus = 1
      !> Pressure rising keeps the shear stress, falling keeps the elastic slip: creates no energy
      enumerator :: rule_dissipative = 2
   end enum
   public :: rule_abaqus, rule_dissipative

   !> How the slip of an increment is integrated
   enum, bind(c)
      !> Exactly, on a straight path: two half increments equal one
      enumerator :: slip_exact = 1
      !> Backward Euler (radial return), as in ABAQUS' own friction
      enumerator :: slip_backward_euler = 2
   end enum
   public :: slip_exact, slip_backward_euler

   !> Largest |d0|, mm, that is let pass: far beyond any use
   real(wp), parameter :: largest_separation = 1.0e20_wp

   !> A point opens below p_open = this times 2 pi eta R H sigma
   real(wp), parameter :: open_pressure_factor = 1.0e-9_wp
   !> ... and closes above p_open times this
   real(wp), parameter, public :: close_pressure_ratio = 2.0_wp
   !> Separation at zero overclosure when none is given, in sigma
   real(wp), parameter, public :: default_initial_separation = 4.0_wp

   !> Everything a contact point needs. Build it with `new_contact_properties`; read only after.
   type :: contact_properties
      !> Properties of the normal law
      type(normal_properties) :: normal = normal_properties()
      !> Coulomb friction coefficient mu
      real(wp) :: friction_coefficient = 0.0_wp
      !> Critical elastic slip gcrit, mm: the largest |elastic slip|
      real(wp) :: critical_slip = 1.0_wp
      !> Separation at zero overclosure d0, mm: separation = d0 - overclosure
      real(wp) :: initial_separation = 0.0_wp
      !> `rule_abaqus` or `rule_dissipative`
      integer :: friction_rule = rule_abaqus
      !> `slip_exact` or `slip_backward_euler`
      integer :: slip_integration = slip_exact
      !> What friction is beyond these
      type(friction_settings) :: friction = friction_settings()
      !> Whether it is nothing beyond them
      logical :: friction_is_plain = .true.
      !> A closed point opens below this pressure, MPa; an open one closes above twice it
      real(wp) :: p_open = 0.0_wp
      !> The compiled normal law, where it was asked for; the law is evaluated directly otherwise
      type(compiled_law), allocatable :: compiled
      !> The same with elastic unloading
      type(compiled_unloading_law), allocatable :: compiled_unloading
   end type contact_properties

   !> From checked properties of the normal law, or from a pair of the paper.
   interface new_contact_properties
      module procedure :: from_normal
      module procedure :: from_pair
   end interface new_contact_properties

contains

   !> Check friction and datum, and derive the opening pressure.
   !> `error` is set when mu is not between 0 and 1000, gcrit not above zero, |d0| above 1e20, an
   !> option unknown, or gcrit or |d0| a length that no face has.
   pure subroutine from_normal(properties, normal, friction_coefficient, critical_slip, error, &
         initial_separation, friction_rule, slip_integration, compiled, accept_unphysical, friction)
      !> Result
      type(contact_properties), intent(out) :: properties
      !> Checked properties of the normal law
      type(normal_properties), intent(in) :: normal
      !> Coulomb friction coefficient
      real(wp), intent(in) :: friction_coefficient
      !> Critical elastic slip, mm
      real(wp), intent(in) :: critical_slip
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> Separation at zero overclosure, mm; 4 sigma when absent; zero and negative are allowed
      real(wp), intent(in), optional :: initial_separation
      !> `rule_abaqus` (default) or `rule_dissipative`
      integer, intent(in), optional :: friction_rule
      !> `slip_exact` (default) or `slip_backward_euler`
      integer, intent(in), optional :: slip_integration
      !> Compile the normal law, for very many updates; false when absent
      logical, intent(in), optional :: compiled
      !> Let lengths that no face has pass; results are then flagged
      logical, intent(in), optional :: accept_unphysical
      !> Friction beyond one coefficient and one critical slip
      type(friction_settings), intent(in), optional :: friction
      real(wp) :: separation

      separation = 0.0_wp
      if (present(initial_separation)) separation = initial_separation
      ! what is no number must not be compared: that may trap
      if (.not. all_finite([friction_coefficient, critical_slip, separation])) then
         call refuse(error, friction_coefficient, critical_slip, separation)
         return
      end if
      properties%normal = normal
      call complete_contact_properties(properties, friction_coefficient, critical_slip, error, &
         initial_separation, friction_rule, slip_integration, compiled, accept_unphysical, friction)
   end subroutine from_normal

   !> The same where `properties%normal` is in its place already, for many calls: without a copy.
   pure subroutine complete_contact_properties(properties, friction_coefficient, critical_slip, &
         error, initial_separation, friction_rule, slip_integration, compiled, &
         accept_unphysical, friction)
      !> With checked properties of the normal law; all the rest is set
      type(contact_properties), intent(inout) :: properties
      !> As above, and finite
      real(wp), intent(in) :: friction_coefficient, critical_slip
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in), optional :: initial_separation
      integer, intent(in), optional :: friction_rule, slip_integration
      logical, intent(in), optional :: compiled, accept_unphysical
      type(friction_settings), intent(in), optional :: friction
      logical :: allowed, accepted

      if (allocated(properties%compiled)) deallocate (properties%compiled)
      if (allocated(properties%compiled_unloading)) deallocate (properties%compiled_unloading)
      properties%friction_coefficient = friction_coefficient
      properties%critical_slip = critical_slip
      properties%initial_separation = default_initial_separation*properties%normal%sigma
      if (present(initial_separation)) properties%initial_separation = initial_separation
      properties%friction_rule = rule_abaqus
      if (present(friction_rule)) properties%friction_rule = friction_rule
      properties%slip_integration = slip_exact
      if (present(slip_integration)) properties%slip_integration = slip_integration
      ! nothing is set for plain friction, which is asked for most often
      if (.not. properties%friction_is_plain) properties%friction = friction_settings()
      properties%friction_is_plain = .true.
      associate (p => properties%normal)
         properties%p_open = open_pressure_factor*2.0_wp*pi*p%eta*p%radius*p%hardness*p%sigma
      end associate

      allowed = friction_coefficient >= 0.0_wp .and. friction_coefficient <= largest_friction &
         .and. critical_slip >= smallest_positive .and. critical_slip <= largest_positive &
         .and. abs(properties%initial_separation) <= largest_separation
      if (.not. allowed) then
         call refuse(error, friction_coefficient, critical_slip, properties%initial_separation)
         return
      end if
      accepted = .false.
      if (present(accept_unphysical)) accepted = accept_unphysical
      call check_plausible_length('critical_slip', critical_slip, length_max, accepted, &
         properties%normal%validity, error)
      if (.not. allocated(error)) call check_plausible_length('initial_separation', &
         properties%initial_separation, max(length_max, &
         properties%normal%vanishing_separation), accepted, properties%normal%validity, error)
      if (allocated(error)) return
      if (properties%friction_rule /= rule_abaqus &
            .and. properties%friction_rule /= rule_dissipative) then
         call fatal_error(error, 'friction_rule = '//to_text(properties%friction_rule)// &
            ' is unknown: 1 is abaqus, 2 is dissipative', subject='friction_rule')
      else if (properties%slip_integration /= slip_exact &
            .and. properties%slip_integration /= slip_backward_euler) then
         call fatal_error(error, 'slip_integration = '//to_text(properties%slip_integration)// &
            ' is unknown: 1 is exact, 2 is backward_euler', subject='slip_integration')
      end if
      if (.not. allocated(error) .and. present(friction)) then
         call check_friction(friction, friction_coefficient, properties%normal, error)
         if (allocated(error)) return
         properties%friction = friction
         properties%friction_is_plain = is_plain(friction)
      end if
      if (allocated(error) .or. .not. present(compiled)) return
      if (compiled) call compile_normal_law(properties, error)
   end subroutine complete_contact_properties

   !> Name the first number that is not allowed.
   pure subroutine refuse(error, friction_coefficient, critical_slip, initial_separation)
      type(error_type), allocatable, intent(inout) :: error
      real(wp), intent(in) :: friction_coefficient, critical_slip, initial_separation

      call check_range(error, 'friction_coefficient', friction_coefficient, 0.0_wp, &
         largest_friction, '')
      if (.not. allocated(error)) call check_positive(error, 'critical_slip', critical_slip, 'mm')
      if (.not. allocated(error)) call check_range(error, 'initial_separation', &
         initial_separation, -largest_separation, largest_separation, ' mm')
   end subroutine refuse

   !> The same for hard contact, which has no summits: gcrit in their place.
   pure function without_summits(properties) result(hard)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      type(contact_properties) :: hard

      hard = properties
      hard%friction%stick = stick_critical_slip
      hard%friction_is_plain = is_plain(hard%friction)
   end function without_summits

   !> Compile the normal law, unless it is. `error` is set when the properties were never built.
   pure subroutine compile_normal_law(properties, error)
      !> The properties
      type(contact_properties), intent(inout) :: properties
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      if (properties%normal%unloading == unloading_elastic) then
         if (allocated(properties%compiled_unloading)) return
         allocate (properties%compiled_unloading)
         call new_compiled_unloading_law(properties%compiled_unloading, properties%normal, error)
      else
         if (allocated(properties%compiled)) return
         allocate (properties%compiled)
         call new_compiled_law(properties%compiled, properties%normal, error)
      end if
   end subroutine compile_normal_law

   !> The same of a pair of the paper, with its friction.
   pure subroutine from_pair(properties, pair, error, initial_separation, friction_rule, &
         slip_integration, compiled, accept_unphysical, unloading, friction)
      !> Result
      type(contact_properties), intent(out) :: properties
      !> The pair, such as `find_pair` finds
      type(pair_preset), intent(in) :: pair
      !> Set when a property is refused
      type(error_type), allocatable, intent(out) :: error
      !> As above
      real(wp), intent(in), optional :: initial_separation
      integer, intent(in), optional :: friction_rule, slip_integration
      logical, intent(in), optional :: compiled, accept_unphysical
      !> `unloading_reversible` (default) or `unloading_elastic`
      integer, intent(in), optional :: unloading
      !> Friction beyond one coefficient and one critical slip
      type(friction_settings), intent(in), optional :: friction
      type(normal_properties) :: normal

      call new_normal_properties(normal, pair, error, accept_unphysical, unloading)
      if (.not. allocated(error)) call from_normal(properties, normal, &
         pair%friction_coefficient, pair%critical_slip, error, initial_separation, &
         friction_rule, slip_integration, compiled, accept_unphysical, friction)
   end subroutine from_pair

end module asperity_contact_properties

! src/contact/friction_strength.f90
!> Strength m of a closed point: the largest shear stress at rest, along the grain.
module asperity_contact_friction_strength
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: find_friction_strength, find_friction_factor, largest_shear_stress, &
      static_coefficient, motion_ratio

   !> Powers of e are kept finite for any pressure
   real(wp), parameter :: largest_power = 200.0_wp

contains

   !> m(p) = min(mu_s f(p) p, shear limit), with the coefficient at rest mu_s and the factor f by
   !> pressure.
   pure subroutine find_friction_strength(properties, pressure, strength, by_pressure)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> m, MPa, and its derivative
      real(wp), intent(out) :: strength, by_pressure
      real(wp) :: factor, factor_by_log_pressure, mu

      strength = 0.0_wp
      by_pressure = 0.0_wp
      if (.not. pressure > 0.0_wp) return
      call find_friction_factor(properties%friction, pressure, factor, factor_by_log_pressure)
      mu = static_coefficient(properties)
      strength = mu*factor*pressure
      by_pressure = mu*(factor + factor_by_log_pressure)
      if (properties%friction%shear_limit > 0.0_wp &
         .and. strength > properties%friction%shear_limit) then
         strength = properties%friction%shear_limit
         by_pressure = 0.0_wp
      end if
   end subroutine find_friction_strength

   !> Largest shear stress in any direction at a pressure, at rest or in motion, MPa.
   pure real(wp) function largest_shear_stress(properties, pressure, moves) result(stress)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> Whether the point has slipped far
      logical, intent(in) :: moves
      real(wp) :: by_pressure

      call find_friction_strength(properties, pressure, stress, by_pressure)
      if (moves) stress = stress*motion_ratio(properties)
      stress = stress*max(1.0_wp, properties%friction%friction_coefficient_across &
         /max(properties%friction_coefficient, tiny(1.0_wp)))
   end function largest_shear_stress

   !> Coefficient in motion over that at rest.
   pure real(wp) function motion_ratio(properties)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      motion_ratio = 1.0_wp
      if (properties%friction%static_friction_coefficient > properties%friction_coefficient) &
         motion_ratio = properties%friction_coefficient/static_coefficient(properties)
   end function motion_ratio

   !> Coefficient at rest, along the grain.
   pure real(wp) function static_coefficient(properties)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      static_coefficient = max(properties%friction%static_friction_coefficient, &
         properties%friction_coefficient)
   end function static_coefficient

   !> Factor on all coefficients: (p/reference)^exponent, straight lines between points, or one.
   pure subroutine find_friction_factor(settings, pressure, factor, by_log_pressure)
      !> Checked settings
      type(friction_settings), intent(in) :: settings
      !> Pressure, MPa; above zero
      real(wp), intent(in) :: pressure
      !> f, and p df/dp
      real(wp), intent(out) :: factor, by_log_pressure
      integer :: i

      factor = 1.0_wp
      by_log_pressure = 0.0_wp
      if (abs(settings%pressure_exponent) > 0.0_wp) then
         factor = exp(min(max(settings%pressure_exponent &
            *log(pressure/settings%reference_pressure), -largest_power), largest_power))
         by_log_pressure = settings%pressure_exponent*factor
      else if (settings%friction_points > 0) then
         associate (p => settings%friction_pressures, f => settings%friction_factors, &
               n => settings%friction_points)
            factor = f(1)
            do i = 2, n
               if (.not. pressure > p(i - 1)) exit
               if (pressure < p(i)) then
                  by_log_pressure = (f(i) - f(i - 1))/(p(i) - p(i - 1))*pressure
                  factor = f(i - 1) + (f(i) - f(i - 1))*((pressure - p(i - 1))/(p(i) - p(i - 1)))
               else
                  factor = f(i)
               end if
            end do
         end associate
      end if
   end subroutine find_friction_factor

end module asperity_contact_friction_strength

! src/contact/stick_elements.f90
!> Summits that stick each for itself. Mindlin (1949): a summit under the force N, of contact radius
!> a, leans over by delta under T = mu N (1 - (1 - delta/delta_i)^(3/2)) and slides from
!> delta_i = 3 mu N/(16 G* a) on; N and a = sqrt(A/pi) are those of the normal law. The sum over the
!> heights is the backbone. It is concave, so its chords are a sum of elements, each with a critical
!> slip of its own, that repeat it up to the chords' distance and all its loops by Masing's rule.
!>
!> All slips are over the coefficient mu, as it only scales them.
module asperity_contact_stick_elements
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: m => n_points, nodes, weights
   implicit none
   private
   public :: stick_elements, find_stick_elements, summit_backbone, equivalent_shear_modulus

   !> Elements at one separation. Without default values, which flang sets by library calls.
   type :: stick_elements
      !> Number of elements; the first n of the arrays count
      integer :: n
      !> Share of the largest shear stress that an element carries when all slide: positive, sum 1;
      !> and its derivative by closure, 1/mm
      real(wp) :: share(most_stick_elements), share_by_closure(most_stick_elements)
      !> Critical slip over mu, mm, rising; and its derivative by closure
      real(wp) :: unit_slip(most_stick_elements), unit_slip_by_closure(most_stick_elements)
      !> Shear stiffness at first touch, MPa/mm: 8 G* a of all summits in contact
      real(wp) :: stiffness
   end type stick_elements

   !> Summits at the points of a quadrature over heights, at one separation.
   type :: summits
      !> What forces per area, MPa, and critical slips over mu, mm, are told in
      real(wp) :: unit_force, unit_slip
      !> Force times density and weight, and its derivative by d/sigma
      real(wp) :: force(m), force_slope(m)
      !> Critical slip over mu, and its derivative by d/sigma
      real(wp) :: slip(m), slip_slope(m)
      !> 1/slip, force/slip, and the latter times slip_slope/slip
      real(wp) :: inverse(m), stiffness(m), stiffness_drop(m)
      !> Sums of forces and their derivatives
      real(wp) :: total, total_slope
   end type summits

   !> Heights count as long as their density is above exp(-cut) of the largest
   real(wp), parameter :: cut = 18.0_wp
   !> Knots suit a backbone of 1 - (1 - x/kappa)^kappa, x the slip over that at which the first
   !> slope meets the plateau: kappa = 3/2 for equal summits, infinite for exponential heights. It
   !> follows from the area over the backbone; taken larger for the tail of the heights. The last
   !> chord ends on the plateau, part of a step beyond what would be the end for kappa.
   real(wp), parameter :: tail_factor = 0.75_wp, tail_step = 0.5_wp

contains

   !> Elements at a separation. Shares and slips are differentiable in it but where a point of the
   !> quadrature passes w1 or w2.
   pure subroutine find_stick_elements(normal, shear_modulus, n, separation, elements)
      !> Checked properties of the normal law: Gaussian heights, no memory
      type(normal_properties), intent(in) :: normal
      !> Equivalent shear modulus G*, MPa
      real(wp), intent(in) :: shear_modulus
      !> Number of elements, up to `most_stick_elements`
      integer, intent(in) :: n
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      !> Result
      type(stick_elements), intent(out) :: elements
      type(summits) :: s
      real(wp) :: sums(3), slopes(3), moment, scale, scale_slope, rate, rate_slope
      real(wp) :: x, x_by_rate, knot(0:n), knot_slope(0:n), height(0:n), height_slope(0:n)
      real(wp) :: chord(n + 1), chord_slope(n + 1), width
      integer :: j

      call find_summits(normal, shear_modulus, separation, s)
      ! force, stiffness at first touch, and force times critical slip
      sums = [s%total, 1.5_wp*sum(s%stiffness), sum(s%force*s%slip)]
      slopes = [s%total_slope, 1.5_wp*sum(s%force_slope*s%inverse - s%stiffness_drop), &
         sum(s%force_slope*s%slip + s%force*s%slip_slope)]
      scale = sums(1)/sums(2)
      scale_slope = scale*(slopes(1)/sums(1) - slopes(2)/sums(2))
      ! the area over the backbone, kappa/(kappa + 1)
      moment = 0.4_wp*sums(3)/sums(1)/scale
      rate = tail_factor*(1.0_wp/moment - 1.0_wp)
      rate_slope = -tail_factor/moment &
         *(slopes(3)/sums(3) + slopes(2)/sums(2) - 2.0_wp*slopes(1)/sums(1))

      knot(0) = 0.0_wp
      knot_slope(0) = 0.0_wp
      height(0) = 0.0_wp
      height_slope(0) = 0.0_wp
      do j = 1, n
         call place_knot(j, n, rate, x, x_by_rate)
         knot(j) = scale*x
         knot_slope(j) = scale_slope*x + scale*x_by_rate*rate_slope
         call sum_backbone(s, knot(j), knot_slope(j), height(j), height_slope(j))
         height_slope(j) = (height_slope(j) - height(j)/sums(1)*slopes(1))/sums(1)
         height(j) = height(j)/sums(1)
      end do
      height(n) = 1.0_wp
      height_slope(n) = 0.0_wp
      do j = 1, n
         width = knot(j) - knot(j - 1)
         chord(j) = (height(j) - height(j - 1))/width
         chord_slope(j) = (height_slope(j) - height_slope(j - 1) &
            - chord(j)*(knot_slope(j) - knot_slope(j - 1)))/width
      end do
      chord(n + 1) = 0.0_wp
      chord_slope(n + 1) = 0.0_wp

      elements%n = n
      elements%share = 0.0_wp
      elements%share_by_closure = 0.0_wp
      elements%unit_slip = 0.0_wp
      elements%unit_slip_by_closure = 0.0_wp
      do j = 1, n
         elements%share(j) = knot(j)*(chord(j) - chord(j + 1))
         elements%share_by_closure(j) = -(knot_slope(j)*(chord(j) - chord(j + 1)) &
            + knot(j)*(chord_slope(j) - chord_slope(j + 1)))/normal%sigma
         elements%unit_slip(j) = s%unit_slip*knot(j)
         elements%unit_slip_by_closure(j) = -s%unit_slip*knot_slope(j)/normal%sigma
      end do
      elements%stiffness = s%unit_force/s%unit_slip*sums(2)
   end subroutine find_stick_elements

   !> Equivalent shear modulus G* of two elastic bodies, MPa: 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2.
   pure elemental function equivalent_shear_modulus(shear_modulus_1, poisson_1, shear_modulus_2, &
         poisson_2) result(modulus)
      !> Shear moduli, MPa
      real(wp), intent(in) :: shear_modulus_1, shear_modulus_2
      !> Poisson's ratios
      real(wp), intent(in) :: poisson_1, poisson_2
      real(wp) :: modulus

      modulus = 1.0_wp/((2.0_wp - poisson_1)/shear_modulus_1 &
         + (2.0_wp - poisson_2)/shear_modulus_2)
   end function equivalent_shear_modulus

   !> Mindlin's curve of all summits: shear stress over mu p at a slip, to be compared with its
   !> elements.
   pure real(wp) function summit_backbone(normal, shear_modulus, separation, unit_slip) &
         result(share)
      !> As above
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: shear_modulus, separation
      !> Slip over mu, mm; zero or more
      real(wp), intent(in) :: unit_slip
      type(summits) :: s
      real(wp) :: slope

      call find_summits(normal, shear_modulus, separation, s)
      call sum_backbone(s, unit_slip/s%unit_slip, 0.0_wp, share, slope)
      share = share/s%total
   end function summit_backbone

   !> Summits at Gauss points in sqrt(w), in which their forces are smooth. Force and contact radius
   !> are powers of w in each stage.
   pure subroutine find_summits(normal, shear_modulus, separation, s)
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: shear_modulus, separation
      type(summits), intent(out) :: s
      real(wp) :: h, root, first, width, first_slope, width_slope, x, t, t_slope, height
      real(wp) :: by_force, by_slip, log_force(m), log_slip(m)
      integer :: i

      h = separation/normal%sigma
      root = sqrt(max(h, 0.0_wp)**2 + 2.0_wp*cut)
      first = max(-h - root, 0.0_wp)
      first_slope = merge(-1.0_wp, 0.0_wp, first > 0.0_wp)
      if (h > 0.0_wp) then
         width = 2.0_wp*cut/(root + h)
         width_slope = -width/root
      else
         width = min(root - h, 2.0_wp*root)
         width_slope = -1.0_wp - first_slope
      end if
      do i = 1, m
         x = (0.5_wp*(1.0_wp + nodes(i)))**2
         t = first + width*x
         t_slope = first_slope + width_slope*x
         height = max(h, -root) + width*x
         call find_powers(normal, t*normal%sigma, by_force, by_slip, log_force(i), log_slip(i))
         if (h > 0.0_wp) then
            log_force(i) = log_force(i) - t*(h + 0.5_wp*t)
            s%force_slope(i) = -t - height*t_slope
         else
            log_force(i) = log_force(i) - 0.5_wp*height**2
            s%force_slope(i) = -height*(1.0_wp + t_slope)
         end if
         ! of ln(force) and ln(slip), until both are known
         s%force_slope(i) = s%force_slope(i) + by_force*t_slope/t
         s%slip_slope(i) = by_slip*t_slope/t
      end do
      s%unit_force = normal%eta*normal%n1*phi_0*width*exp(-0.5_wp*max(h, 0.0_wp)**2)
      s%unit_slip = 3.0_wp*normal%n1/(16.0_wp*shear_modulus*sqrt(normal%radius*normal%w1))
      s%force = exp(log_force)*weights*0.5_wp*(1.0_wp + nodes)
      s%slip = exp(log_slip)
      s%force_slope = s%force_slope*s%force
      s%inverse = 1.0_wp/s%slip
      s%stiffness = s%force*s%inverse
      s%stiffness_drop = s%stiffness*s%slip_slope
      s%slip_slope = s%slip_slope*s%slip
      s%total = sum(s%force)
      s%total_slope = sum(s%force_slope)
   end subroutine find_summits

   !> Exponents of force and critical slip of a summit, and their logarithms over those at w1.
   pure subroutine find_powers(normal, deformation, by_force, by_slip, log_force, log_slip)
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: deformation
      real(wp), intent(out) :: by_force, by_slip, log_force, log_slip
      real(wp) :: log_ratio

      log_ratio = log(deformation/normal%w1)
      if (deformation < normal%w1) then
         by_force = 1.5_wp
         by_slip = 1.0_wp
         log_force = by_force*log_ratio
         log_slip = log_ratio
      else if (deformation < normal%w2) then
         by_force = normal%b3
         by_slip = normal%b3 - 0.5_wp*normal%b2
         log_force = by_force*log_ratio
         log_slip = by_slip*log_ratio
      else
         by_force = 1.0_wp
         by_slip = 0.5_wp
         log_force = log_ratio + log(2.0_wp/normal%yield_factor)
         log_slip = log_force - 0.5_wp*(log_ratio + log(2.0_wp))
      end if
   end subroutine find_powers

   !> Sum of the summits' shear forces over mu at a slip, and its derivative by d/sigma where that
   !> of the slip is given. Critical slips rise from point to point.
   pure subroutine sum_backbone(s, slip, slip_slope, total, total_slope)
      type(summits), intent(in) :: s
      real(wp), intent(in) :: slip, slip_slope
      real(wp), intent(out) :: total, total_slope
      real(wp) :: sticking, root, spared, spared_slope, by_slip, by_critical_slip
      integer :: i

      spared = 0.0_wp
      spared_slope = 0.0_wp
      by_slip = 0.0_wp
      by_critical_slip = 0.0_wp
      do i = m, 1, -1
         if (.not. s%slip(i) > slip) exit
         sticking = 1.0_wp - slip*s%inverse(i)
         root = sqrt(sticking)
         spared = spared + s%force(i)*(sticking*root)
         spared_slope = spared_slope + s%force_slope(i)*(sticking*root)
         by_slip = by_slip + s%stiffness(i)*root
         by_critical_slip = by_critical_slip + s%stiffness_drop(i)*root
      end do
      total = s%total - spared
      total_slope = s%total_slope - spared_slope &
         + 1.5_wp*(slip_slope*by_slip - slip*by_critical_slip)
   end subroutine sum_backbone

   !> Knot j of n for a rate 1/kappa, kappa (1 - r^(2/kappa)) with r = 1 - j/(n + tail_step), at
   !> which chords are equally far from 1 - (1 - x/kappa)^kappa; and its derivative by the rate.
   pure subroutine place_knot(j, n, rate, x, x_by_rate)
      integer, intent(in) :: j, n
      real(wp), intent(in) :: rate
      real(wp), intent(out) :: x, x_by_rate
      real(wp), parameter :: small = 1.0e-2_wp
      real(wp) :: l, z

      l = 2.0_wp*log(1.0_wp - real(j, wp)/(real(n, wp) + tail_step))
      z = rate*l
      if (abs(z) < small) then
         x = -l*(1.0_wp + z/2.0_wp*(1.0_wp + z/3.0_wp*(1.0_wp + z/4.0_wp*(1.0_wp + z/5.0_wp &
            *(1.0_wp + z/6.0_wp)))))
         x_by_rate = -l*l*(0.5_wp + z/3.0_wp*(1.0_wp + z*3.0_wp/8.0_wp*(1.0_wp + z*4.0_wp/15.0_wp &
            *(1.0_wp + z*5.0_wp/24.0_wp*(1.0_wp + z*6.0_wp/35.0_wp)))))
      else
         x = (1.0_wp - exp(z))/rate
         x_by_rate = -(x + l*exp(z))/rate
      end if
   end subroutine place_knot

end module asperity_contact_stick_elements

! src/contact/friction_elements.f90
!> Elastic-slip elements in parallel that make up the friction of a point: shear stress = sum of
!> stiffness times elastic slip, each within its radius.
module asperity_contact_friction_elements
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: default_stick_elements, &
      most_stick_elements, stick_summits
   use asperity_contact_friction_strength, only: find_friction_strength
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_stick_elements, only: find_stick_elements, stick_elements
   implicit none
   private
   public :: friction_elements, find_friction_elements, stick_number

   !> The elements at a pressure. The first `n` count.
   type :: friction_elements
      integer :: n
      !> Stiffness along the grain, MPa/mm, and its derivative by overclosure
      real(wp) :: stiffness(most_stick_elements), stiffness_by(most_stick_elements)
      !> Largest elastic slip, at rest, mm, and its derivative by overclosure
      real(wp) :: radius(most_stick_elements), radius_by(most_stick_elements)
   end type friction_elements

contains

   !> One element with gcrit, or those of the summits.
   pure subroutine find_friction_elements(properties, overclosure, pressure, &
         pressure_by_overclosure, elements)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Overclosure, mm
      real(wp), intent(in) :: overclosure
      !> Pressure there, MPa, and its derivative, MPa/mm
      real(wp), intent(in) :: pressure, pressure_by_overclosure
      !> Result
      type(friction_elements), intent(out) :: elements
      real(wp) :: strength, by_pressure

      call find_friction_strength(properties, pressure, strength, by_pressure)
      if (properties%friction%stick == stick_summits) then
         call find_summits(properties, overclosure, pressure, pressure_by_overclosure, strength, &
            by_pressure, elements)
         return
      end if
      elements%n = 1
      elements%stiffness(1) = strength/properties%critical_slip
      elements%stiffness_by(1) = by_pressure/properties%critical_slip*pressure_by_overclosure
      elements%radius(1) = properties%critical_slip
      elements%radius_by(1) = 0.0_wp
   end subroutine find_friction_elements

   !> Elements of the summits: their stiffness is that of solids and does not depend on friction,
   !> their largest elastic slips are in proportion to its coefficient, strength over pressure.
   pure subroutine find_summits(properties, overclosure, pressure, pressure_by_overclosure, &
         strength, by_pressure, elements)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: overclosure, pressure, pressure_by_overclosure
      !> Largest shear stress, MPa, and its derivative by pressure
      real(wp), intent(in) :: strength, by_pressure
      type(friction_elements), intent(out) :: elements
      type(stick_elements) :: summits
      real(wp) :: coefficient, coefficient_by
      integer :: j

      coefficient = properties%friction_coefficient
      coefficient_by = 0.0_wp
      if (pressure > 0.0_wp) then
         coefficient = strength/pressure
         coefficient_by = (by_pressure - coefficient)*(pressure_by_overclosure/pressure)
      end if
      call find_stick_elements(properties%normal, properties%friction%shear_modulus, &
         stick_number(properties), properties%initial_separation - overclosure, summits)
      elements%n = summits%n
      do j = 1, summits%n
         associate (share => summits%share(j), slip => summits%unit_slip(j), &
               share_by => summits%share_by_closure(j), slip_by => summits%unit_slip_by_closure(j))
            elements%stiffness(j) = pressure*share/slip
            elements%stiffness_by(j) = (pressure_by_overclosure*share &
               + pressure*(share_by - share*slip_by/slip))/slip
            elements%radius(j) = coefficient*slip
            elements%radius_by(j) = coefficient_by*slip + coefficient*slip_by
         end associate
      end do
   end subroutine find_summits

   !> How many elements the summits have.
   pure integer function stick_number(properties)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      stick_number = properties%friction%stick_elements
      if (stick_number == 0) stick_number = default_stick_elements
   end function stick_number

end module asperity_contact_friction_elements

! src/contact/state.f90
!> What a contact point remembers between increments, and what an update of it returns.
module asperity_contact_state
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_law_validity, only: valid
   implicit none
   private
   public :: contact_state, contact_response, is_closed, may_close, status_text

   !> Contact status
   enum, bind(c)
      !> Never updated: nothing is known of the point's past
      enumerator :: status_unset = 0
      !> Pressure below p_open
      enumerator :: status_open
      !> Closed; only elastic slip at the end of the increment
      enumerator :: status_stick
      !> Closed and slipping at the end of the increment
      enumerator :: status_slip
   end enum
   public :: status_unset, status_open, status_stick, status_slip

   !> Rotation of slip directions that do not turn
   real(wp), parameter, public :: no_rotation(2, 2) = &
      reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])

   !> Overclosure that stands for "no opposite surface"
   real(wp), parameter, public :: no_opposite_surface = -1.0e36_wp
   !> Any overclosure below this, mm, means the same
   real(wp), parameter, public :: no_surface_limit = -1.0e30_wp

   character(len=5), parameter :: status_names(0:3) = ['unset', 'open ', 'stick', 'slip ']

   !> What a point remembers between increments. All zero is a fresh point.
   type :: contact_state
      !> `status_unset`, `status_open`, `status_stick` or `status_slip`
      integer :: status = status_unset
      !> Overclosure, mm
      real(wp) :: overclosure = 0.0_wp
      !> Pressure, MPa
      real(wp) :: pressure = 0.0_wp
      !> Stored (recoverable) normal energy per area, N/mm
      real(wp) :: normal_energy = 0.0_wp
      !> Elastic slip in the two slip directions, mm; zero while open
      real(wp) :: elastic_slip(2) = 0.0_wp
      !> Largest overclosure reached, mm: all that a law with memory remembers
      real(wp) :: largest_closure = 0.0_wp
      !> Frictional dissipation per area since the start, N/mm
      real(wp) :: dissipation = 0.0_wp
      !> Pressure coupling per area since the start, N/mm
      real(wp) :: pressure_coupling = 0.0_wp
      !> All validity flags reached so far
      integer :: validity = valid
      !> How far the friction has gone from rest, 0, to motion, 1; by slip alone
      real(wp) :: motion_share = 0.0_wp
      !> Angle by which slip directions have turned over the grain since the start, radians
      real(wp) :: grain_turn = 0.0_wp
      !> Elastic slips of the elements of `stick_summits`, mm; set where those are asked for
      real(wp) :: summit_slip(2, most_stick_elements) = 0.0_wp
   end type contact_state

   !> Result of one update. Energies obey, on any path,
   !> work = change of (normal_energy + tangential_energy) + dissipation + plastic_dissipation
   !>    - pressure_coupling.
   type :: contact_response
      !> Pressure and the two shear stresses, MPa: positive pressure compresses, shear stress has
      !> the sign of the elastic slip
      real(wp) :: traction(3) = 0.0_wp
      !> tangent(i, j) = d traction(i)/d (overclosure, slip 1, slip 2)(j), MPa/mm; unsymmetric
      real(wp) :: tangent(3, 3) = 0.0_wp
      !> State at the end
      type(contact_state) :: state = contact_state()
      !> Stored (recoverable) normal energy per area at the end, N/mm
      real(wp) :: normal_energy = 0.0_wp
      !> Stored tangential energy per area at the end, mu p gamma^2/(2 gcrit), N/mm
      real(wp) :: tangential_energy = 0.0_wp
      !> Frictional dissipation per area of this increment, N/mm; never negative
      real(wp) :: dissipation = 0.0_wp
      !> Plastic dissipation of summits per area in this increment, N/mm; never negative, zero
      !> without memory
      real(wp) :: plastic_dissipation = 0.0_wp
      !> Energy per area that a pressure change put into stored elastic slip in this increment,
      !> N/mm; signed, zero for the dissipative rule
      real(wp) :: pressure_coupling = 0.0_wp
      !> Status at the end
      integer :: status = status_open
      !> Validity of this result
      integer :: validity = valid
   end type contact_response

contains

   !> Whether a point is known to touch.
   pure logical function is_closed(state)
      !> State of the point
      type(contact_state), intent(in) :: state

      is_closed = state%status == status_stick .or. state%status == status_slip
   end function is_closed

   !> Whether a point may close at a known overclosure: it was seen open, with a surface opposite.
   pure logical function may_close(state)
      !> State of the point
      type(contact_state), intent(in) :: state

      may_close = state%status == status_open .and. state%overclosure >= no_surface_limit
   end function may_close

   !> A status that has a name. It stands before its use, where gfortran 12 sees no interface
   !> otherwise.
   pure integer function known(status)
      integer, intent(in) :: status

      known = min(max(status, 0), 3)
   end function known

   !> Name of a status: `unset`, `open`, `stick` or `slip`.
   pure function status_text(status) result(text)
      !> One of the status enumerators
      integer, intent(in) :: status
      character(len=len_trim(status_names(known(status)))) :: text

      text = status_names(known(status))
   end function status_text

end module asperity_contact_state

! interface/abaqus/routines/statev.f90
!> What stands where in STATEV of UINTER and VUINTER, and nothing else: every reader and writer
!> of it uses these names.
module asperity_abaqus_statev
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: stick_number
   use asperity_contact_friction_settings, only: most_stick_elements, stick_summits
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_state
   implicit none
   private
   public :: state_from_statev, statev_from_state, statev_needed

   !> Slots of STATEV; all zero is a fresh point
   enum, bind(c)
      !> 0 never called, 1 open, 2 stick, 3 slip
      enumerator :: state_status = 1
      !> Overclosure, mm; pressure, MPa; stored normal energy, N/mm
      enumerator :: state_overclosure, state_pressure, state_normal_energy
      !> Elastic slip in the two slip directions, mm
      enumerator :: state_elastic_slip_1, state_elastic_slip_2
      !> Largest overclosure reached, mm: the memory of elastic unloading
      enumerator :: state_largest_closure
      !> Frictional dissipation and pressure coupling since the start, N/mm
      enumerator :: state_dissipation, state_pressure_coupling
      !> Sum of the validity flags reached, and of those already warned about
      enumerator :: state_validity, state_warned
      !> Of friction that is not plain: how far it has gone from rest, 0, to motion, 1, and the
      !> angle by which slip directions have turned over the grain, radians
      enumerator :: state_motion_share, state_grain_turn
      !> Elastic slip of the first of the summits' elements in the two slip directions, mm; the next
      !> ones follow
      enumerator :: state_summit_slip
   end enum
   public :: state_status, state_overclosure, state_pressure, state_normal_energy, &
      state_elastic_slip_1, state_elastic_slip_2, state_largest_closure, state_dissipation, &
      state_pressure_coupling, state_validity, state_warned, state_motion_share, &
      state_grain_turn, state_summit_slip
   !> DEPVAR that UINTER and VUINTER need at least, and at most
   integer, parameter, public :: n_statev = state_warned, &
      most_statev = state_grain_turn + 2*most_stick_elements

contains

   !> DEPVAR that UINTER and VUINTER need for these properties.
   pure integer function statev_needed(properties) result(needed)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      needed = n_statev
      if (properties%friction_is_plain) return
      needed = state_grain_turn
      if (properties%friction%stick == stick_summits) needed = needed + 2*stick_number(properties)
   end function statev_needed

   !> State of a point from as many slots of STATEV as `statev_needed` says.
   pure subroutine state_from_statev(statev, state)
      !> At least `n_statev` numbers; no more than the properties need
      real(wp), intent(in) :: statev(:)
      !> State of the point; what STATEV has no slots for is left alone
      type(contact_state), intent(inout) :: state
      integer :: j

      state%status = int(statev(state_status))
      state%overclosure = statev(state_overclosure)
      state%pressure = statev(state_pressure)
      state%normal_energy = statev(state_normal_energy)
      state%elastic_slip(1) = statev(state_elastic_slip_1)
      state%elastic_slip(2) = statev(state_elastic_slip_2)
      state%largest_closure = statev(state_largest_closure)
      state%dissipation = statev(state_dissipation)
      state%pressure_coupling = statev(state_pressure_coupling)
      state%validity = int(statev(state_validity))
      if (size(statev) < state_grain_turn) return
      state%motion_share = statev(state_motion_share)
      state%grain_turn = statev(state_grain_turn)
      do j = 1, elements_of(statev)
         state%summit_slip(:, j) = statev(state_summit_slip + 2*j - 2:state_summit_slip + 2*j - 1)
      end do
   end subroutine state_from_statev

   !> Write a state to as many slots of STATEV as `statev_needed` says; that of warnings is left
   !> alone.
   pure subroutine statev_from_state(state, statev)
      !> State of the point
      type(contact_state), intent(in) :: state
      !> At least `n_statev` numbers; no more than the properties need
      real(wp), intent(inout) :: statev(:)
      integer :: j

      statev(state_status) = state%status
      statev(state_overclosure) = state%overclosure
      statev(state_pressure) = state%pressure
      statev(state_normal_energy) = state%normal_energy
      statev(state_elastic_slip_1) = state%elastic_slip(1)
      statev(state_elastic_slip_2) = state%elastic_slip(2)
      statev(state_largest_closure) = state%largest_closure
      statev(state_dissipation) = state%dissipation
      statev(state_pressure_coupling) = state%pressure_coupling
      statev(state_validity) = state%validity
      if (size(statev) < state_grain_turn) return
      statev(state_motion_share) = state%motion_share
      statev(state_grain_turn) = state%grain_turn
      do j = 1, elements_of(statev)
         statev(state_summit_slip + 2*j - 2:state_summit_slip + 2*j - 1) = state%summit_slip(:, j)
      end do
   end subroutine statev_from_state

   !> Elements of the summits' stick that a STATEV has room for.
   pure integer function elements_of(statev)
      real(wp), intent(in) :: statev(:)

      elements_of = min((size(statev) - state_grain_turn)/2, most_stick_elements)
   end function elements_of

end module asperity_abaqus_statev

! interface/abaqus/routines/checks.f90
!> What UINTER and VUINTER check before they compute: sizes that the deck sets, a STATEV that only
!> they write to, and numbers that a host gone wrong may pass.
module asperity_abaqus_checks
   use asperity_abaqus_statev, only: n_statev, state_elastic_slip_2, state_grain_turn, &
      state_largest_closure, state_motion_share, state_overclosure, state_pressure, state_status, &
      state_validity, state_warned
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_below
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_slip, status_unset
   use asperity_law_validity, only: all_flags
   implicit none
   private
   public :: check_sizes, check_statev, computable, sizes_are_computable

   !> Larger numbers than this are a host gone wrong
   real(wp), parameter, public :: largest = 1.0e30_wp

contains

   !> Refuse what would be read or written out of bounds.
   pure subroutine check_sizes(nstatv, needed, ndir, error)
      !> Number of state variables, and of those that the properties need
      integer, intent(in) :: nstatv, needed
      !> Number of components
      integer, intent(in) :: ndir
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      if (nstatv < needed) then
         call fatal_error(error, 'DEPVAR = '//to_text(nstatv)//' is too small: give DEPVAR = '// &
            to_text(needed)//' on *SURFACE INTERACTION')
      else if (ndir /= 2 .and. ndir /= 3) then
         call fatal_error(error, 'NDIR = '//to_text(ndir)//' is not allowed: it must be 2 or 3')
      end if
   end subroutine check_sizes

   !> Refuse a STATEV that is not ours.
   pure subroutine check_statev(statev, error)
      !> As many slots as the properties need, all finite
      real(wp), intent(in), contiguous :: statev(:)
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error

      if (statev(state_status) < status_unset .or. statev(state_status) > status_slip &
            .or. abs(statev(state_status) - aint(statev(state_status))) > 0.0_wp) then
         call fatal_error(error, 'STATEV(1) = '//to_text(statev(state_status))//' is no '// &
            'contact status ('//to_text(status_unset)//' to '//to_text(status_slip)// &
            '): STATEV must be zero at the start, and nothing else may '// &
            'write to it')
      else if (statev(state_pressure) < 0.0_wp .or. any(statev(state_validity:state_warned) &
            < 0.0_wp) .or. any(statev(state_validity:state_warned) > all_flags)) then
         call fatal_error(error, 'STATEV(3), (10) or (11) = '//to_text(statev(state_pressure))// &
            ', '//to_text(statev(state_validity))//', '//to_text(statev(state_warned))// &
            ' is no pressure or sum of flags: nothing else may write to STATEV')
      else if (statev(state_largest_closure) < statev(state_overclosure)) then
         call fatal_error(error, 'STATEV(7) = '//to_text(statev(state_largest_closure))// &
            ' is below STATEV(2) = '//to_text(statev(state_overclosure))//': the largest '// &
            'closure is the present one or more; nothing else may write to STATEV')
      else if (size(statev) > n_statev) then
         if (statev(state_motion_share) < 0.0_wp .or. statev(state_motion_share) > 1.0_wp) &
            call fatal_error(error, 'STATEV(12) = '//to_text(statev(state_motion_share))// &
            ' is no share of motion, 0 to 1: nothing else may write to STATEV')
      end if
   end subroutine check_statev

   !> Whether pressure, energy, slips and turn are far from overflow.
   pure logical function sizes_are_computable(statev)
      !> As many slots as the properties need, all finite
      real(wp), intent(in), contiguous :: statev(:)

      sizes_are_computable = all(abs(statev(state_pressure:state_elastic_slip_2)) < largest)
      if (sizes_are_computable .and. size(statev) > n_statev) &
         sizes_are_computable = all(abs(statev(state_grain_turn:)) < largest)
   end function sizes_are_computable

   !> Finite, and far from overflow.
   pure logical function computable(values)
      !> Numbers of the host
      real(wp), intent(in), contiguous :: values(:)

      computable = all_below(values, largest)
   end function computable

end module asperity_abaqus_checks

! interface/abaqus/routines/vuinter_precision.f90
!> The precision of VUINTER's arguments, which is that of the run of ABAQUS/Explicit that calls it.
module asperity_abaqus_vuinter_precision
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private

   !> Kind of VUINTER's real arguments; all computing is done in `wp`. It is set here alone:
   !> cmake/abaqus.cmake writes a second file from the same sources with the other kind
   integer, parameter, public :: vp = real64

end module asperity_abaqus_vuinter_precision

! interface/abaqus/routines/prop_slots.f90
!> What stands where in PROPS of UINTER and VUINTER, and nothing else: every reader and writer of it
!> uses these names. Zero is the default from the eleventh slot on.
module asperity_abaqus_prop_slots
   use asperity_contact_friction_settings, only: most_friction_points, most_stick_elements
   implicit none
   private

   !> Slots of PROPS, N-mm-MPa
   enum, bind(c)
      !> mu, and gcrit in mm
      enumerator :: prop_friction_coefficient = 1, prop_critical_slip
      !> eta in 1/mm^2, E* in MPa
      enumerator :: prop_eta, prop_modulus
      !> 3.14 or better: kept in the paper's place as a guard against a shifted list, not used
      enumerator :: prop_pi
      !> R in mm, H in MPa, k
      enumerator :: prop_radius, prop_hardness, prop_yield_factor
      !> sigma in mm, which the paper's list lacks
      enumerator :: prop_sigma
      !> d0 in mm, taken literally; 4 sigma when the list ends before
      enumerator :: prop_initial_separation
      !> 0 default, 1 abaqus, 2 dissipative
      enumerator :: prop_friction_rule
      !> 0 default, 1 exact, 2 backward Euler
      enumerator :: prop_slip_integration
      !> 1 lets properties that no face or solid has pass
      enumerator :: prop_accept_unphysical
      !> 0 reversible, 1 elastic: summits remember how flat they were pressed
      enumerator :: prop_unloading
      !> As of `normal_properties`
      enumerator :: prop_plastic_ratio, prop_height_distribution, prop_skewness, prop_kurtosis
      !> As of `friction_settings`: rest and motion,
      enumerator :: prop_static_friction_coefficient, prop_decay_slip, prop_decay_slip_rate
      !> ... grain,
      enumerator :: prop_friction_coefficient_across, prop_grain_angle, prop_slip_direction
      !> ... pressure,
      enumerator :: prop_pressure_exponent, prop_reference_pressure, prop_shear_limit
      !> ... summits that stick each for itself,
      enumerator :: prop_stick, prop_stick_elements, prop_shear_modulus
      !> ... and how many pairs of pressure and factor follow
      enumerator :: prop_friction_points
   end enum
   public :: prop_friction_coefficient, prop_critical_slip, prop_eta, prop_modulus, prop_pi, &
      prop_radius, prop_hardness, prop_yield_factor, prop_sigma, prop_initial_separation, &
      prop_friction_rule, prop_slip_integration, prop_accept_unphysical, prop_unloading, &
      prop_plastic_ratio, prop_height_distribution, prop_skewness, prop_kurtosis, &
      prop_static_friction_coefficient, prop_decay_slip, prop_decay_slip_rate, &
      prop_friction_coefficient_across, prop_grain_angle, prop_slip_direction, &
      prop_pressure_exponent, prop_reference_pressure, prop_shear_limit, prop_stick, &
      prop_stick_elements, prop_shear_modulus, prop_friction_points
   !> Length of a list with all of them and no pairs, and of the longest one
   integer, parameter, public :: n_props = prop_friction_points, &
      most_props = n_props + 2*most_friction_points

   !> Slots that hold whole numbers, and the largest one there
   integer, parameter, public :: option_slots(9) = [prop_friction_rule, prop_slip_integration, &
      prop_accept_unphysical, prop_unloading, prop_height_distribution, prop_slip_direction, &
      prop_stick, prop_stick_elements, prop_friction_points]
   integer, parameter, public :: option_max(size(option_slots)) = &
      [2, 2, 1, 1, 1, 1, 1, most_stick_elements, most_friction_points]
   !> What they mean
   character(len=*), parameter, public :: option_texts(size(option_slots)) = [character(len=80) :: &
      'the friction rule is 1 for abaqus, 2 for dissipative, 0 for the default', &
      'the slip integration is 1 for exact, 2 for backward Euler, 0 for the default', &
      '1 accepts unphysical values, 0 does not', &
      'the unloading is 0 for reversible, 1 for elastic', &
      'the height distribution is 0 for gaussian, 1 for johnson', &
      'the slip direction is 0 for associated, 1 for that of the stress', &
      'what sticks is 0 for one critical slip, 1 for summits', &
      'there are up to 16 stick elements, 0 for the default', &
      'there are 0 to 8 friction points, a pressure and a factor each']

   !> What a list says, in the words of its slots
   character(len=*), parameter, public :: prop_names(n_props) = [character(len=32) :: &
      'mu', 'gcrit (mm)', 'eta (1/mm^2)', 'E* (MPa)', 'pi', 'R (mm)', 'H (MPa)', 'k', &
      'sigma (mm)', 'd0 (mm)', 'friction rule', 'slip integration', 'accept unphysical', &
      'unloading', 'plastic ratio', 'height distribution', 'skewness', 'kurtosis', &
      'static friction coefficient', 'decay slip (mm)', 'decay slip rate (mm/s)', &
      'friction coefficient across', 'grain angle (degrees)', 'slip direction', &
      'pressure exponent', 'reference pressure (MPa)', 'shear limit (MPa)', 'stick', &
      'stick elements', 'shear modulus (MPa)', 'friction points']

end module asperity_abaqus_prop_slots

! interface/abaqus/routines/props.f90
!> PROPS of UINTER and VUINTER, read and written.
module asperity_abaqus_props
   use asperity_abaqus_prop_slots, only: most_props, n_props, option_max, &
      option_slots, option_texts, prop_accept_unphysical, prop_critical_slip, prop_decay_slip, &
      prop_decay_slip_rate, prop_eta, prop_friction_coefficient, &
      prop_friction_coefficient_across, prop_friction_points, prop_friction_rule, &
      prop_grain_angle, prop_hardness, prop_height_distribution, prop_initial_separation, &
      prop_kurtosis, prop_modulus, prop_names, prop_pi, prop_plastic_ratio, &
      prop_pressure_exponent, prop_radius, prop_reference_pressure, prop_shear_limit, &
      prop_shear_modulus, prop_sigma, prop_skewness, prop_slip_direction, prop_slip_integration, &
      prop_static_friction_coefficient, prop_stick, prop_stick_elements, prop_unloading, &
      prop_yield_factor
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: friction_settings, stick_summits
   use asperity_contact_properties, only: complete_contact_properties, contact_properties, &
      rule_abaqus, slip_exact
   use asperity_law_normal_properties, only: default_plastic_ratio, heights_gaussian, &
      new_normal_properties, normal_properties
   implicit none
   private
   public :: properties_from_props, props_from_properties, near_pi

   !> How far PROPS(5) may be from pi: 3.14 passes
   real(wp), parameter :: pi_tolerance = 0.01_wp
   !> Defaults of the normal law
   type(normal_properties), parameter :: unset = normal_properties()

contains

   !> Read and check PROPS. `error` is set when the list is too short or too long, PROPS(5) is
   !> not near pi, or a property is refused.
   pure subroutine properties_from_props(props, properties, error)
      !> The property list
      real(wp), intent(in), contiguous :: props(:)
      !> Checked properties; all of them are set
      type(contact_properties), intent(inout) :: properties
      !> Set when the list is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: rule, integration
      logical :: accepted

      call check_list(props, error)
      if (allocated(error)) return
      rule = option_of(props, prop_friction_rule)
      if (rule == 0) rule = rule_abaqus
      integration = option_of(props, prop_slip_integration)
      if (integration == 0) integration = slip_exact
      accepted = option_of(props, prop_accept_unphysical) == 1
      if (size(props) <= prop_unloading) then
         call new_normal_properties(properties%normal, props(prop_eta), props(prop_modulus), &
            props(prop_radius), props(prop_hardness), props(prop_yield_factor), &
            props(prop_sigma), error, accepted, option_of(props, prop_unloading))
      else
         call read_normal(props, accepted, properties%normal, error)
      end if
      if (allocated(error)) return
      if (size(props) < prop_initial_separation) then
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error)
      else if (size(props) <= prop_unloading) then
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error, props(prop_initial_separation), rule, integration, &
            accept_unphysical=accepted)
      else
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error, props(prop_initial_separation), rule, integration, &
            accept_unphysical=accepted, friction=friction_of(props))
      end if
   end subroutine properties_from_props

   !> The normal law of a list that goes beyond `prop_unloading`.
   pure subroutine read_normal(props, accepted, normal, error)
      real(wp), intent(in), contiguous :: props(:)
      logical, intent(in) :: accepted
      type(normal_properties), intent(inout) :: normal
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: ratio, kurtosis

      ratio = value_of(props, prop_plastic_ratio)
      if (.not. abs(ratio) > 0.0_wp) ratio = default_plastic_ratio
      kurtosis = value_of(props, prop_kurtosis)
      if (.not. abs(kurtosis) > 0.0_wp) kurtosis = unset%kurtosis
      call new_normal_properties(normal, props(prop_eta), props(prop_modulus), &
         props(prop_radius), props(prop_hardness), props(prop_yield_factor), props(prop_sigma), &
         error, accepted, option_of(props, prop_unloading), ratio, &
         option_of(props, prop_height_distribution), value_of(props, prop_skewness), kurtosis)
   end subroutine read_normal

   !> Friction beyond one coefficient and one critical slip, as a list has it.
   pure function friction_of(props) result(friction)
      real(wp), intent(in), contiguous :: props(:)
      type(friction_settings) :: friction
      integer :: n

      friction%static_friction_coefficient = value_of(props, prop_static_friction_coefficient)
      friction%decay_slip = value_of(props, prop_decay_slip)
      friction%decay_slip_rate = value_of(props, prop_decay_slip_rate)
      friction%friction_coefficient_across = value_of(props, prop_friction_coefficient_across)
      friction%grain_angle = value_of(props, prop_grain_angle)
      friction%slip_direction = option_of(props, prop_slip_direction)
      friction%pressure_exponent = value_of(props, prop_pressure_exponent)
      friction%reference_pressure = value_of(props, prop_reference_pressure)
      friction%shear_limit = value_of(props, prop_shear_limit)
      friction%stick = option_of(props, prop_stick)
      friction%stick_elements = option_of(props, prop_stick_elements)
      friction%shear_modulus = value_of(props, prop_shear_modulus)
      n = option_of(props, prop_friction_points)
      friction%friction_points = n
      friction%friction_pressures(:n) = props(n_props + 1:size(props):2)
      friction%friction_factors(:n) = props(n_props + 2:size(props):2)
   end function friction_of

   !> The full property list that gives these properties. From the slot after `prop_unloading` on,
   !> defaults and what has no effect are zeros.
   pure function props_from_properties(properties) result(props)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: props(n_props + 2*properties%friction%friction_points)

      props = 0.0_wp
      props(prop_friction_coefficient) = properties%friction_coefficient
      props(prop_critical_slip) = properties%critical_slip
      props(prop_pi) = pi
      props(prop_initial_separation) = properties%initial_separation
      props(prop_friction_rule) = properties%friction_rule
      props(prop_slip_integration) = properties%slip_integration
      ! properties that exist have been accepted
      props(prop_accept_unphysical) = 1.0_wp
      associate (normal => properties%normal)
         props(prop_eta) = normal%eta
         props(prop_modulus) = normal%modulus
         props(prop_radius) = normal%radius
         props(prop_hardness) = normal%hardness
         props(prop_yield_factor) = normal%yield_factor
         props(prop_sigma) = normal%sigma
         props(prop_unloading) = normal%unloading
         if (abs(normal%plastic_ratio - default_plastic_ratio) > 0.0_wp) &
            props(prop_plastic_ratio) = normal%plastic_ratio
         if (normal%height_distribution /= heights_gaussian) then
            props(prop_height_distribution) = normal%height_distribution
            props(prop_skewness) = normal%skewness
            props(prop_kurtosis) = normal%kurtosis
         end if
      end associate
      associate (friction => properties%friction)
         props(prop_static_friction_coefficient) = friction%static_friction_coefficient
         props(prop_decay_slip) = friction%decay_slip
         props(prop_decay_slip_rate) = friction%decay_slip_rate
         if (friction%friction_coefficient_across > 0.0_wp) then
            props(prop_friction_coefficient_across) = friction%friction_coefficient_across
            props(prop_grain_angle) = friction%grain_angle
            props(prop_slip_direction) = friction%slip_direction
         end if
         if (abs(friction%pressure_exponent) > 0.0_wp) then
            props(prop_pressure_exponent) = friction%pressure_exponent
            props(prop_reference_pressure) = friction%reference_pressure
         end if
         props(prop_shear_limit) = friction%shear_limit
         if (friction%stick == stick_summits) then
            props(prop_stick) = friction%stick
            props(prop_stick_elements) = friction%stick_elements
            props(prop_shear_modulus) = friction%shear_modulus
         end if
         props(prop_friction_points) = friction%friction_points
         props(n_props + 1::2) = friction%friction_pressures(:friction%friction_points)
         props(n_props + 2::2) = friction%friction_factors(:friction%friction_points)
      end associate
   end function props_from_properties

   !> A property; zero where the list ends before.
   pure real(wp) function value_of(props, slot) result(value)
      real(wp), intent(in), contiguous :: props(:)
      integer, intent(in) :: slot

      value = 0.0_wp
      if (slot <= size(props)) value = props(slot)
   end function value_of

   !> A whole number, after it was checked; zero where the list ends before.
   pure integer function option_of(props, slot) result(option)
      real(wp), intent(in), contiguous :: props(:)
      integer, intent(in) :: slot

      option = 0
      if (slot <= size(props)) option = int(props(slot))
   end function option_of

   !> Is it pi as PROPS(5) holds it?
   pure logical function near_pi(value)
      !> A property, or a number that may be none
      real(wp), intent(in) :: value

      near_pi = is_finite(value)
      if (near_pi) near_pi = abs(value - pi) < pi_tolerance
   end function near_pi

   !> Set `error` when the list cannot be read: its length, a number, pi or an option is wrong.
   pure subroutine check_list(props, error)
      real(wp), intent(in), contiguous :: props(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i, pairs

      if (size(props) < prop_sigma .or. size(props) > most_props) then
         call refuse_length(error, size(props))
         return
      end if
      if (.not. all_finite(props)) then
         call refuse_number(error, props)
         return
      end if
      if (.not. near_pi(props(prop_pi))) then
         call fatal_error(error, 'PROPS(5) = '//to_text(props(prop_pi))//' must be pi (3.14 or '// &
            'better): the list seems shifted; check that the line after *SURFACE INTERACTION '// &
            'is blank or a thickness, and the order of the properties')
         return
      end if
      do i = 1, size(option_slots)
         if (option_slots(i) > size(props)) exit
         if (is_option(props(option_slots(i)), option_max(i))) cycle
         call fatal_error(error, 'PROPS('//to_text(option_slots(i))//') = '// &
            to_text(props(option_slots(i)))//' is not allowed: '//trim(option_texts(i)))
         return
      end do
      if (size(props) < n_props) return
      pairs = option_of(props, prop_friction_points)
      if (size(props) /= n_props + 2*pairs) call fatal_error(error, 'PROPERTIES = '// &
         to_text(size(props))//' does not fit PROPS('//to_text(n_props)//') = '//to_text(pairs)// &
         ' friction points: give '//to_text(n_props + 2*pairs)//', a pressure and a factor for '// &
         'each of them at the end')
   end subroutine check_list

   !> Is it a whole number from 0 on? Of a finite number.
   pure logical function is_option(value, largest)
      real(wp), intent(in) :: value
      integer, intent(in) :: largest

      is_option = value >= 0.0_wp .and. value <= largest
      if (is_option) is_option = abs(value - int(value)) <= 0.0_wp
   end function is_option

   !> Name the first property that is no number.
   pure subroutine refuse_number(error, props)
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in) :: props(:)
      integer :: slot

      slot = findloc(is_finite(props), .false., dim=1)
      call fatal_error(error, 'PROPS('//to_text(slot)//') = '//to_text(props(slot))// &
         ' is not allowed: every property must be a finite number')
   end subroutine refuse_number

   !> Say what is missing.
   pure subroutine refuse_length(error, length)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: length
      character(len=500) :: remedy
      integer :: i

      if (length == prop_sigma - 1) then
         remedy = '; the eight of the paper lack sigma, without which the law has no length '// &
            'scale: add sigma, the standard deviation of summit heights in mm, as the ninth '// &
            '(Table 2 prints it in um)'
      else
         remedy = ' ('//prop_names(1)
         do i = 2, prop_unloading
            remedy = trim(remedy)//', '//prop_names(i)
         end do
         remedy = trim(remedy)//', and what else docs/abaqus.md lists)'
      end if
      call fatal_error(error, 'PROPERTIES = '//to_text(length)//' is not allowed: give '// &
         to_text(prop_sigma)//' to '//to_text(most_props)//trim(remedy))
   end subroutine refuse_length

end module asperity_abaqus_props

! interface/abaqus/routines/vuinter_props.f90
!> PROPS as VUINTER gets it, in the precision of the run: read, and found out when the run has
!> another precision than the file that was compiled.
module asperity_abaqus_vuinter_props
   use, intrinsic :: iso_fortran_env, only: real32, real64
   use asperity_abaqus_prop_slots, only: prop_pi, prop_sigma
   use asperity_abaqus_props, only: near_pi, properties_from_props
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: read_props

   !> The precision of runs that this build is not for
   integer, parameter :: other = merge(real32, real64, vp == real64)
   !> So many properties hold the bits of five (`prop_pi`) in the other precision: half as many, or
   !> twice
   integer, parameter :: leading = merge(3, 10, other == real32)
   character(len=*), parameter :: remedy = 'compile asperity_vuinter for a run with double '// &
      'precision, asperity_vuinter_single for one without'

contains

   !> Read and check PROPS. `error` is set when `properties_from_props` refuses it. A list in the
   !> other precision is told by its bits where they are there to see, and is not read on.
   pure subroutine read_props(props, properties, error)
      !> The property list
      real(vp), intent(in) :: props(:)
      !> Checked properties; all of them are set
      type(contact_properties), intent(inout) :: properties
      !> Set when the list is refused
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message

      if (in_other_precision(props)) then
         call fatal_error(error, 'PROPS is in '//merge('single', 'double', other == real32)// &
            ' precision, and this VUINTER is not: '//remedy)
         return
      end if
      call properties_from_props(real(props, wp), properties, error)
      if (.not. allocated(error) .or. size(props) < prop_sigma) return
      if (near_pi(real(props(prop_pi), wp))) return
      allocate (message, source=error%message// &
         '; or the run has another precision than VUINTER: '//remedy)
      call move_alloc(message, error%message)
   end subroutine read_props

   !> Does the list hold pi in its place when read in the other precision, and not in ours?
   pure logical function in_other_precision(props)
      real(vp), intent(in) :: props(:)
      real(other) :: seen(prop_pi)

      in_other_precision = .false.
      if (size(props) < leading) return
      if (near_pi(real(props(prop_pi), wp))) return
      seen = transfer(props(:leading), seen, prop_pi)
      in_other_precision = near_pi(real(seen(prop_pi), wp))
   end function in_other_precision

end module asperity_abaqus_vuinter_props

! src/contact/sliding_element.f90
!> The path of one elastic-slip element whose domain is |gamma| <= g: elastic slip, how far it has
!> gone from rest to motion, and dissipation, with their derivatives by overclosure and slip. In
!> the axes of the grain.
!>
!> Radius g = kinetic + excess (1 - moved): `excess` is that of rest over motion, which the slip
!> rate has reduced already. Slipping over l, 1 - moved falls to exp(-l/decay_slip) of it; elastic
!> travel over s brings moved to exp(-s/(decay_slip + g_s - g_k)) of it. So g never grows as fast as
!> an elastic slip that is driven outwards: what slips on does not stick in between, and no noise
!> makes it.
!>
!> Slip goes along w_i gamma_i. Its increment ends by backward Euler: gamma_i = trial_i -
!> lambda w_i gamma_i on the circle of the end. In one dimension that is exact.
module asperity_contact_sliding_element
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: sliding_element, slip_domain, slide_element, shrink_to_domain

   !> Derivatives are by overclosure and the two components of the slip increment
   integer, parameter, public :: n_by = 3

   !> An element within an increment.
   type :: sliding_element
      !> Elastic slip, mm
      real(wp) :: gamma(2)
      !> How far from rest, 0, to motion, 1
      real(wp) :: moved
      real(wp) :: gamma_by(2, n_by), moved_by(n_by)
      !> Work of friction over the stiffness, mm^2
      real(wp) :: lost
      !> Whether it slips at the end
      logical :: slips
   end type sliding_element

   !> Where it sticks, and where it slips to.
   type :: slip_domain
      !> Radius in motion, and what rest adds to it, mm
      real(wp) :: kinetic, excess
      real(wp) :: kinetic_by(n_by), excess_by(n_by)
      !> 1/decay_slip, 1/mm; zero without decay by slip; and the same of the travel that renews
      real(wp) :: decay, renewal
      !> Stiffness along and across the grain over that along it
      real(wp) :: stiffness(2)
      !> Direction of slip: w_i gamma_i
      real(wp) :: direction(2)
   end type slip_domain

   !> Elastic slip that is longer by so much is so by round-off
   real(wp), parameter :: round_off = 1.0_wp + 8.0_wp*epsilon(1.0_wp)
   integer, parameter :: most_iterations = 100

contains

   !> What was inside and is outside, as the domain has shrunk, slips without motion: the stored
   !> energy that is let go is lost.
   pure subroutine shrink_to_domain(element, domain)
      !> The element
      type(sliding_element), intent(inout) :: element
      !> Its domain
      type(slip_domain), intent(in) :: domain
      real(wp) :: before, work

      if (.not. hypot(element%gamma(1), element%gamma(2)) &
         > (domain%kinetic + domain%excess*(1.0_wp - element%moved))*round_off) return
      before = energy(element, domain)
      call return_to_domain(element, domain, work)
      element%lost = element%lost + max(before - energy(element, domain), 0.0_wp)
      element%slips = .true.
   end subroutine shrink_to_domain

   !> Slide over a straight motion: stick up to the domain, then slip.
   pure subroutine slide_element(element, domain, motion, motion_by)
      !> The element, inside its domain
      type(sliding_element), intent(inout) :: element
      !> Its domain
      type(slip_domain), intent(in) :: domain
      !> Relative motion, mm, and its derivatives
      real(wp), intent(in) :: motion(2), motion_by(2, n_by)
      type(sliding_element) :: trial
      real(wp) :: rest(2), rest_by(2, n_by), work, length

      trial = element
      trial%gamma = element%gamma + motion
      trial%gamma_by = element%gamma_by + motion_by
      length = hypot(motion(1), motion(2))
      if (domain%decay > 0.0_wp .and. length > 0.0_wp) &
         call renew(trial, domain%renewal, length, motion, motion_by)
      ! a start outside by round-off must not count as slip when the motion turns back
      if (.not. hypot(trial%gamma(1), trial%gamma(2)) > domain%kinetic &
         + domain%excess*(1.0_wp - trial%moved) &
         .or. .not. dot_product(trial%gamma, motion) > 0.0_wp) then
         trial%slips = .false.
         element = trial
         return
      end if
      if (domain%decay > 0.0_wp) then
         call stick_to_domain(element, domain, motion, motion_by, rest, rest_by)
         if (drops(element, domain)) then
            work = energy(element, domain)
            call return_to_domain(element, domain, length)
            element%lost = element%lost + max(work - energy(element, domain), 0.0_wp)
         end if
         element%gamma = element%gamma + rest
         element%gamma_by = element%gamma_by + rest_by
      else
         element = trial
      end if
      call return_to_domain(element, domain, work)
      element%lost = element%lost + work
      element%slips = .true.
   end subroutine slide_element

   !> Elastic travel renews rest.
   pure subroutine renew(element, renewal, length, motion, motion_by)
      type(sliding_element), intent(inout) :: element
      real(wp), intent(in) :: renewal, length, motion(2), motion_by(2, n_by)
      real(wp) :: left
      integer :: k

      left = exp(-renewal*length)
      do k = 1, n_by
         element%moved_by(k) = left*(element%moved_by(k) &
            - element%moved*renewal*dot_product(motion, motion_by(:, k))/length)
      end do
      element%moved = left*element%moved
   end subroutine renew

   !> Stick over a motion that ends outside: up to the last point inside, f of the way; the rest is
   !> left. |gamma(f)| - g(f) is convex, so Newton's method comes down to its last zero from f = 1.
   pure subroutine stick_to_domain(element, domain, motion, motion_by, rest, rest_by)
      type(sliding_element), intent(inout) :: element
      type(slip_domain), intent(in) :: domain
      real(wp), intent(in) :: motion(2), motion_by(2, n_by)
      real(wp), intent(out) :: rest(2), rest_by(2, n_by)
      real(wp) :: f, step, length, travel, at(2), size, moved, outside, slope, f_by(n_by)
      integer :: i, k

      rest = motion
      rest_by = motion_by
      travel = hypot(motion(1), motion(2))
      f = 1.0_wp
      do i = 1, most_iterations
         at = element%gamma + f*motion
         size = hypot(at(1), at(2))
         moved = element%moved*exp(-domain%renewal*f*travel)
         outside = size - domain%kinetic - domain%excess*(1.0_wp - moved)
         slope = dot_product(at, motion)/size - domain%excess*moved*domain%renewal*travel
         ! never inside
         if (.not. slope > 0.0_wp) return
         ! on the circle from the start on, as after an increment at the same rate
         if (.not. f > 0.0_wp) exit
         step = outside/slope
         f = max(f - step, 0.0_wp)
         if (f > 0.0_wp .and. .not. step > 2.0_wp*epsilon(f)*f) exit
      end do
      length = f*travel
      do k = 1, n_by
         f_by(k) = -(dot_product(at, element%gamma_by(:, k) + f*motion_by(:, k))/size &
            - domain%kinetic_by(k) - domain%excess_by(k)*(1.0_wp - moved) &
            + domain%excess*(exp(-domain%renewal*length)*element%moved_by(k) &
            - moved*domain%renewal*f*dot_product(motion, motion_by(:, k))/travel))/slope
         element%moved_by(k) = exp(-domain%renewal*length)*element%moved_by(k) &
            - moved*domain%renewal*(f*dot_product(motion, motion_by(:, k))/travel + f_by(k)*travel)
         element%gamma_by(:, k) = element%gamma_by(:, k) + f*motion_by(:, k) + f_by(k)*motion
         rest_by(:, k) = (1.0_wp - f)*motion_by(:, k) - f_by(k)*motion
      end do
      element%moved = moved
      element%gamma = element%gamma + f*motion
      rest = (1.0_wp - f)*motion
   end subroutine stick_to_domain

   !> Whether friction on the circle falls faster with slip than elastic slip is let go: it then
   !> drops at once, without motion.
   pure logical function drops(element, domain)
      type(sliding_element), intent(in) :: element
      type(slip_domain), intent(in) :: domain

      associate (g => element%gamma, w => domain%direction)
         drops = domain%excess*(1.0_wp - element%moved)*domain%decay*norm2(w*g)*norm2(g) &
            > dot_product(w*g, g)
      end associate
   end function drops

   !> Slip from a trial outside to the circle of the end: gamma_i = a_i trial_i with
   !> a_i = kappa/(w_i + kappa (1 - w_i)), kappa = 1/(1 + lambda). |gamma| - g of kappa is concave
   !> where w is one; its lowest zero is the end. `work` is that of friction on the way over the
   !> stiffness, along the direction of the end.
   pure subroutine return_to_domain(element, domain, work)
      type(sliding_element), intent(inout) :: element
      type(slip_domain), intent(in) :: domain
      real(wp), intent(out) :: work
      real(wp) :: trial(2), kappa, low, high, next, below(2), a(2), a_by(2), gamma(2), c(2), slip
      real(wp) :: normal(2), along(2), size, reach, faded, excess, outside, slope, slip_by
      real(wp) :: kappa_by(n_by), trial_by(2), slip_by_k
      integer :: i, k

      trial = element%gamma
      reach = hypot(trial(1), trial(2))
      excess = domain%excess*(1.0_wp - element%moved)
      associate (w => domain%direction)
         low = 0.0_wp
         high = 1.0_wp
         kappa = min(domain%kinetic/reach, 1.0_wp)
         do i = 1, most_iterations
            below = w + kappa*(1.0_wp - w)
            a = kappa/below
            a_by = w/(below*below)
            gamma = a*trial
            c = w*trial/below
            slip = (1.0_wp - kappa)*hypot(c(1), c(2))
            along = c/hypot(c(1), c(2))
            size = hypot(gamma(1), gamma(2))
            normal = gamma/size
            faded = exp(-domain%decay*slip)
            outside = size - domain%kinetic - excess*faded
            slip_by = -dot_product(along, a_by*trial)
            slope = dot_product(normal, a_by*trial) + excess*faded*domain%decay*slip_by
            if (outside > 0.0_wp) then
               high = kappa
            else
               low = kappa
            end if
            next = 0.5_wp*(low + high)
            if (slope > 0.0_wp) then
               next = kappa - outside/slope
               if (.not. (next >= low .and. next <= high)) next = 0.5_wp*(low + high)
            end if
            if (abs(next - kappa) <= 4.0_wp*epsilon(kappa)*kappa) exit
            kappa = next
         end do
         ! zero only where friction falls just as fast as elastic slip is let go
         slope = max(slope, epsilon(slope)*reach)
         do k = 1, n_by
            trial_by = element%gamma_by(:, k)
            slip_by_k = dot_product(along, (1.0_wp - a)*trial_by)
            kappa_by(k) = -(dot_product(normal, a*trial_by) - domain%kinetic_by(k) &
               - faded*(domain%excess_by(k)*(1.0_wp - element%moved) &
               - domain%excess*element%moved_by(k)) + excess*faded*domain%decay*slip_by_k)/slope
            element%gamma_by(:, k) = a*trial_by + a_by*trial*kappa_by(k)
            element%moved_by(k) = faded*(element%moved_by(k) + (1.0_wp - element%moved) &
               *domain%decay*(slip_by_k + slip_by*kappa_by(k)))
         end do
      end associate
      ! exactly on the circle, even from very far outside
      size = domain%kinetic + excess*faded
      element%gamma = size*normal
      element%moved = 1.0_wp - (1.0_wp - element%moved)*faded
      work = domain%kinetic*slip
      if (domain%decay > 0.0_wp) then
         work = work + excess*(1.0_wp - faded)/domain%decay
      else
         work = work + excess*slip
      end if
      work = work*dot_product(domain%stiffness*normal, along)
   end subroutine return_to_domain

   !> Stored energy over the stiffness, mm^2.
   pure real(wp) function energy(element, domain)
      type(sliding_element), intent(in) :: element
      type(slip_domain), intent(in) :: domain

      energy = 0.5_wp*dot_product(domain%stiffness*element%gamma, element%gamma)
   end function energy

end module asperity_contact_sliding_element

! src/contact/slip_path.f90
!> The path of the elastic slip gamma, |gamma| <= gcrit (the regularisation of Table 3), in two
!> tangential directions; a second component of zero makes it one-dimensional. The pressure, which
!> scales the friction, does not matter here.
module asperity_contact_slip_path
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: slip_backward_euler
   implicit none
   private
   public :: slip_path, integrate_slip, is_longer

   !> End of a straight increment of relative motion.
   type :: slip_path
      !> Elastic slip at the end, mm
      real(wp) :: elastic_slip(2)
      !> Its derivative by the increment
      real(wp) :: by_increment(2, 2)
      !> Its derivative by the elastic slip at the start
      real(wp) :: by_start(2, 2)
      !> Frictional dissipation divided by mu p, mm; never negative
      real(wp) :: slipped
      !> Whether the point slips at the end
      logical :: slips
   end type slip_path

   real(wp), parameter :: identity(2, 2) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])

contains

   !> Elastic slip after a straight increment of relative motion.
   pure function integrate_slip(start, increment, critical_slip, slip_integration) result(path)
      !> Elastic slip at the start, mm; not longer than the critical slip
      real(wp), intent(in) :: start(2)
      !> Relative tangential motion, mm
      real(wp), intent(in) :: increment(2)
      !> Critical elastic slip gcrit, mm
      real(wp), intent(in) :: critical_slip
      !> `slip_exact` or `slip_backward_euler`
      integer, intent(in) :: slip_integration
      type(slip_path) :: path
      real(wp) :: length

      path%elastic_slip = start + increment
      path%slips = is_longer(path%elastic_slip, critical_slip)
      if (path%slips) then
         ! a start outside the circle by round-off must not count as slip when the motion turns back
         length = hypot(increment(1), increment(2))
         path%slips = length > epsilon(1.0_wp)**2*critical_slip
         if (path%slips) path%slips = dot_product(path%elastic_slip/critical_slip, &
            increment/length) > 0.0_wp
      end if
      if (.not. path%slips) then
         path%by_increment = identity
         path%by_start = identity
         path%slipped = 0.0_wp
      else if (slip_integration == slip_backward_euler) then
         call return_radially(path, critical_slip)
      else
         call follow_circle(path, start, increment, critical_slip)
      end if
   end function integrate_slip

   !> Whether a slip is longer than a length: without a root where both components are small.
   pure logical function is_longer(slip, length)
      !> Slip in two directions, and a length, mm
      real(wp), intent(in) :: slip(2), length
      real(wp), parameter :: surely_inside = 0.7_wp

      is_longer = max(abs(slip(1)), abs(slip(2))) > surely_inside*length
      if (is_longer) is_longer = hypot(slip(1), slip(2)) > length
   end function is_longer

   !> Backward Euler: the trial slip is scaled back to the circle. The path is the chord to the
   !> end point in stick, then slip at the end point.
   pure subroutine return_radially(path, critical_slip)
      type(slip_path), intent(inout) :: path
      real(wp), intent(in) :: critical_slip
      real(wp) :: length, direction(2), tangent(2)

      length = hypot(path%elastic_slip(1), path%elastic_slip(2))
      direction = path%elastic_slip/length
      tangent = [-direction(2), direction(1)]
      path%elastic_slip = critical_slip*direction
      call set_outer(tangent, tangent, path%by_increment)
      path%by_increment = critical_slip/length*path%by_increment
      path%by_start = path%by_increment
      path%slipped = length - critical_slip
   end subroutine return_radially

   !> Exact path: stick up to the circle |gamma| = gcrit = g, then slip along it, where the angle
   !> theta from the motion to gamma obeys tan(theta/2) = tan(theta0/2) exp(-s/g) and the
   !> dissipation is mu p g ln(sin theta0/sin theta). Written so that no direction is singular:
   !> e is the direction of motion, n normal to it, c = cos theta0, tan(theta/2) = (b/g) k.
   pure subroutine follow_circle(path, start, increment, critical_slip)
      type(slip_path), intent(inout) :: path
      real(wp), intent(in) :: start(2), increment(2), critical_slip
      real(wp) :: e(2), n(2), tangent(2), along(2), length, size, a, b, c, one_minus_c, inside
      real(wp) :: stick, x, q, one_minus_q, growth, k, t, cosine, sine, turn

      length = hypot(increment(1), increment(2))
      e = increment/length
      n(1) = -e(2)
      n(2) = e(1)
      associate (g => critical_slip)
         a = dot_product(start, e)
         b = min(max(dot_product(start, n), -g), g)
         size = hypot(start(1), start(2))
         inside = max((g - size)*(g + size), 0.0_wp)
         c = sqrt(a*a + inside)/g
         one_minus_c = (b/g)**2/(1.0_wp + c)
         if (a > 0.0_wp) then
            stick = inside/(g*c + a)
         else
            stick = g*c - a
         end if
         stick = min(stick, length)
         x = (length - stick)/g
         call decay_and_growth(x, c, q, one_minus_q, growth)
         k = q/(1.0_wp + c)
         t = b/g*k
         cosine = (1.0_wp - t)*(1.0_wp + t)/(1.0_wp + t*t)
         sine = 2.0_wp*t/(1.0_wp + t*t)
         path%elastic_slip = g*(cosine*e + sine*n)
         path%slipped = g*growth
         tangent = -sine*e + cosine*n
         turn = (one_minus_q*(1.0_wp - k*one_minus_c) + 2.0_wp*k*c*stick/g) &
            /(1.0_wp + t*t)
         along = -sine*e + turn*g/length*n
         call set_outer(tangent, along, path%by_increment)
         along = -sine*e + 2.0_wp*c*k/(1.0_wp + t*t)*n
         call set_outer(tangent, along, path%by_start)
      end associate
   end subroutine follow_circle

   !> q = exp(-x), 1 - q, and ln(sin theta0/sin theta) = ln(cosh x + c sinh x): without loss for a
   !> small x, where ln(1 + z) = 2 artanh(z/(2 + z)), and without overflow for a large one.
   pure subroutine decay_and_growth(x, c, q, one_minus_q, growth)
      real(wp), intent(in) :: x, c
      real(wp), intent(out) :: q, one_minus_q, growth
      real(wp) :: half_sinh, half_cosh, z

      if (x < 1.0_wp) then
         half_sinh = sinh(0.5_wp*x)
         half_cosh = sqrt(1.0_wp + half_sinh**2)
         q = (half_cosh - half_sinh)**2
         one_minus_q = 2.0_wp*half_sinh*(half_cosh - half_sinh)
         z = 2.0_wp*half_sinh*(half_sinh + c*half_cosh)
         growth = 2.0_wp*atanh(z/(2.0_wp + z))
      else
         q = exp(-x)
         one_minus_q = 1.0_wp - q
         growth = x + log(0.5_wp*((1.0_wp + c) + (1.0_wp - c)*q*q))
      end if
   end subroutine decay_and_growth

   !> The matrix u v^T; no function, as flang copies the array that one returns by a library call.
   pure subroutine set_outer(u, v, matrix)
      real(wp), intent(in) :: u(2), v(2)
      real(wp), intent(out) :: matrix(2, 2)

      matrix(:, 1) = u*v(1)
      matrix(:, 2) = u*v(2)
   end subroutine set_outer

end module asperity_contact_slip_path

! src/contact/general_friction.f90
!> Friction that depends on rest and motion, grain, pressure, or the summits' own stick: what
!> `slide` does where friction is not plain. Shear stress tau_i = sum of stiffness times r_i gamma_i
!> in the axes of the grain, r = (1, across/along), over elements that each stay in their domain.
module asperity_contact_general_friction
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: find_friction_elements, friction_elements
   use asperity_contact_friction_settings, only: slip_direction_associated, stick_critical_slip
   use asperity_contact_friction_strength, only: motion_ratio
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_sliding_element, only: n_by, shrink_to_domain, slide_element, &
      sliding_element, slip_domain
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use asperity_contact_state, only: contact_response, contact_state, is_closed, no_rotation, &
      status_open, status_slip, status_stick
   implicit none
   private
   public :: slide_in_general, add_friction_tangent

   !> An element of the summits' stick slips from its radius less this share of it on
   real(wp), parameter :: at_radius = 1.0e-9_wp

contains

   !> As `slide` does, once it is known what share of the increment lies after closing; what every
   !> point remembers is left to it.
   pure subroutine slide_in_general(response, properties, start, elastic_slip, overclosure, &
         slip_increment, is_open, share, share_by_overclosure, rotation, time_increment)
      !> As of `slide`
      type(contact_response), intent(inout) :: response
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: elastic_slip(2), overclosure, slip_increment(2)
      logical, intent(in) :: is_open
      !> Share of the increment after closing, and its derivative by the overclosure
      real(wp), intent(in) :: share, share_by_overclosure
      !> Rotation of the slip directions and time of the increment, s
      real(wp), intent(in), optional :: rotation(2, 2), time_increment
      type(friction_elements) :: elements, before
      type(sliding_element) :: element
      type(slip_domain) :: domain
      real(wp) :: turn(2, 2), axes(2, 2), increment(2), motion(2), motion_by(2, n_by)
      real(wp) :: stress(2), stress_by(2, n_by), rest, rest_by(n_by), first, energy, kept, total
      real(wp) :: kinetic_share
      integer :: j

      turn = no_rotation
      if (present(rotation)) turn = rotation
      associate (r => response, f => properties%friction)
         r%state%grain_turn = start%grain_turn + atan2(turn(2, 1) - turn(1, 2), &
            turn(1, 1) + turn(2, 2))
         axes = grain_axes(properties, r%state%grain_turn)
         increment = matmul(slip_increment, axes)
         motion = share*increment
         motion_by(:, 1) = share_by_overclosure*increment
         motion_by(:, 2) = [share, 0.0_wp]
         motion_by(:, 3) = [0.0_wp, share]
         call find_rest_by_rate(properties, increment, time_increment, rest, rest_by)
         kinetic_share = motion_ratio(properties)
         domain%decay = 0.0_wp
         if (f%decay_slip > 0.0_wp) domain%decay = 1.0_wp/f%decay_slip
         domain%stiffness = stiffness_ratios(properties)
         domain%direction = slip_weights(properties)

         elements%n = 0
         if (is_closed(start) .or. .not. is_open) call find_friction_elements(properties, &
            overclosure, r%traction(1), r%tangent(1, 1), elements)
         if (is_closed(start)) call find_friction_elements(properties, start%overclosure, &
            start%pressure, 0.0_wp, before)
         stress = 0.0_wp
         stress_by = 0.0_wp
         total = 0.0_wp
         r%tangential_energy = 0.0_wp
         r%dissipation = 0.0_wp
         r%pressure_coupling = 0.0_wp
         r%state%elastic_slip = 0.0_wp
         r%state%motion_share = 0.0_wp
         r%status = merge(status_open, status_slip, is_open)
         do j = 1, elements%n
            associate (k => elements%stiffness(j), k_by => elements%stiffness_by(j))
               ! the pressure changes first
               element%gamma = 0.0_wp
               element%gamma_by = 0.0_wp
               element%moved_by = 0.0_wp
               element%moved = 0.0_wp
               element%lost = 0.0_wp
               element%slips = .false.
               energy = 0.0_wp
               if (is_closed(start)) then
                  element%moved = start%motion_share
                  if (f%stick == stick_critical_slip) then
                     element%gamma = matmul(elastic_slip, axes)
                  else
                     element%gamma = matmul(matmul(turn, start%summit_slip(:, j)), axes)
                  end if
                  first = before%stiffness(j)
                  energy = 0.5_wp*first*dot_product(domain%stiffness*element%gamma, element%gamma)
                  ! at rest as when it is pressed, as the stiffness of a law with memory is then
                  if (properties%friction_rule == rule_dissipative .and. k > 0.0_wp &
                     .and. (k > first .or. (k >= first .and. k_by >= 0.0_wp))) then
                     element%gamma = element%gamma*(first/k)
                     element%gamma_by(:, 1) = -element%gamma*(k_by/k)
                  end if
               end if
               kept = 0.5_wp*k*dot_product(domain%stiffness*element%gamma, element%gamma)
               if (properties%friction_rule == rule_dissipative) then
                  r%dissipation = r%dissipation + max(energy - kept, 0.0_wp)
               else
                  r%pressure_coupling = r%pressure_coupling + kept - energy
               end if
               if (is_open) then
                  r%dissipation = r%dissipation + kept
                  cycle
               end if

               domain%kinetic = kinetic_share*elements%radius(j)
               domain%kinetic_by = [kinetic_share*elements%radius_by(j), 0.0_wp, 0.0_wp]
               domain%excess = (1.0_wp - kinetic_share)*elements%radius(j)*rest
               domain%excess_by = (1.0_wp - kinetic_share)*elements%radius(j)*rest_by
               domain%renewal = 0.0_wp
               if (domain%decay > 0.0_wp) domain%renewal = 1.0_wp/(f%decay_slip &
                  + (1.0_wp - kinetic_share)*elements%radius(j))
               call shrink_to_domain(element, domain)
               if (f%static_friction_coefficient > 0.0_wp &
                  .or. f%friction_coefficient_across > 0.0_wp) then
                  call slide_element(element, domain, motion, motion_by)
               else
                  call slide_at_one_coefficient(element, domain, motion, motion_by, &
                     properties%slip_integration)
               end if
               stress = stress + k*domain%stiffness*element%gamma
               stress_by(:, 1) = stress_by(:, 1) + k_by*domain%stiffness*element%gamma
               stress_by(1, :) = stress_by(1, :) + k*domain%stiffness(1)*element%gamma_by(1, :)
               stress_by(2, :) = stress_by(2, :) + k*domain%stiffness(2)*element%gamma_by(2, :)
               total = total + k
               r%tangential_energy = r%tangential_energy &
                  + 0.5_wp*k*dot_product(domain%stiffness*element%gamma, element%gamma)
               r%dissipation = r%dissipation + k*element%lost
               if (.not. element%slips) r%status = status_stick
               r%state%motion_share = element%moved
               if (f%stick /= stick_critical_slip) &
                  r%state%summit_slip(:, j) = matmul(axes, element%gamma)
            end associate
         end do
         if (total > 0.0_wp) r%state%elastic_slip = matmul(axes, stress/domain%stiffness/total)
         if (is_open .and. f%stick /= stick_critical_slip) r%state%summit_slip = 0.0_wp
         r%traction(2:3) = matmul(axes, stress)
         r%tangent(1, 2:3) = 0.0_wp
         r%tangent(2:3, 1) = matmul(axes, stress_by(:, 1))
         r%tangent(2:3, 2:3) = matmul(axes, matmul(stress_by(:, 2:3), transpose(axes)))
      end associate
   end subroutine slide_in_general

   !> One coefficient in all directions, at rest and in motion: the path of plain friction.
   pure subroutine slide_at_one_coefficient(element, domain, motion, motion_by, slip_integration)
      type(sliding_element), intent(inout) :: element
      type(slip_domain), intent(in) :: domain
      real(wp), intent(in) :: motion(2), motion_by(2, n_by)
      integer, intent(in) :: slip_integration
      type(slip_path) :: path
      real(wp) :: by_radius(2)
      integer :: k

      path = integrate_slip(element%gamma, motion, domain%kinetic, slip_integration)
      ! of the first degree in start, motion and radius together
      by_radius = (path%elastic_slip - matmul(path%by_start, element%gamma) &
         - matmul(path%by_increment, motion))/domain%kinetic
      do k = 1, n_by
         element%gamma_by(:, k) = matmul(path%by_start, element%gamma_by(:, k)) &
            + matmul(path%by_increment, motion_by(:, k)) + by_radius*domain%kinetic_by(k)
      end do
      element%gamma = path%elastic_slip
      element%lost = element%lost + domain%kinetic*path%slipped
      element%slips = path%slips
   end subroutine slide_at_one_coefficient

   !> What the slip rate leaves of rest, exp(-rate/decay_slip_rate), and its derivatives. The rate
   !> is that of the relative motion: by that of the slip alone, steady slip would not be stable.
   pure subroutine find_rest_by_rate(properties, increment, time_increment, rest, rest_by)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: increment(2)
      real(wp), intent(in), optional :: time_increment
      real(wp), intent(out) :: rest, rest_by(n_by)
      real(wp) :: length, scale

      rest = 1.0_wp
      rest_by = 0.0_wp
      if (.not. present(time_increment)) return
      scale = time_increment*properties%friction%decay_slip_rate
      length = hypot(increment(1), increment(2))
      if (.not. (scale > 0.0_wp .and. length > 0.0_wp)) return
      rest = exp(-length/scale)
      rest_by(2:) = -rest/scale*(increment/length)
   end subroutine find_rest_by_rate

   !> Tangent of the shear stresses about a state: elements that stick stick, those that slip slip
   !> on and resist only across their direction, at the coefficient that they have.
   pure subroutine add_friction_tangent(properties, state, pressure, stiffness, tangent)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> A closed state
      type(contact_state), intent(in) :: state
      !> Its pressure, MPa, and normal stiffness, MPa/mm
      real(wp), intent(in) :: pressure, stiffness
      !> Rows 2 and 3 are set
      real(wp), intent(inout) :: tangent(3, 3)
      type(friction_elements) :: elements
      real(wp) :: axes(2, 2), ratios(2), gamma(2), along(2), by(2, 3), e(2, 2)
      logical :: slips
      integer :: j, i

      axes = grain_axes(properties, state%grain_turn)
      ratios = stiffness_ratios(properties)
      call find_friction_elements(properties, state%overclosure, pressure, stiffness, elements)
      by = 0.0_wp
      do j = 1, elements%n
         if (properties%friction%stick == stick_critical_slip) then
            gamma = matmul(state%elastic_slip, axes)
            slips = state%status == status_slip
         else
            gamma = matmul(state%summit_slip(:, j), axes)
            slips = hypot(gamma(1), gamma(2)) > (1.0_wp - at_radius)*elements%radius(j)
         end if
         e = no_rotation
         if (slips) then
            along = slip_weights(properties)*gamma
            do i = 1, 2
               e(:, i) = e(:, i) - along*(gamma(i)/dot_product(along, gamma))
            end do
         end if
         by(:, 1) = by(:, 1) + elements%stiffness_by(j)*ratios*gamma
         by(:, 2) = by(:, 2) + elements%stiffness(j)*ratios*e(:, 1)
         by(:, 3) = by(:, 3) + elements%stiffness(j)*ratios*e(:, 2)
      end do
      tangent(2:3, 1) = matmul(axes, by(:, 1))
      tangent(2:3, 2:3) = matmul(axes, matmul(by(:, 2:3), transpose(axes)))
   end subroutine add_friction_tangent

   !> Columns: the direction of the grain and that across it, in slip directions.
   pure function grain_axes(properties, grain_turn) result(axes)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> How far slip directions have turned since the start, radians
      real(wp), intent(in) :: grain_turn
      real(wp) :: axes(2, 2), angle

      axes = no_rotation
      if (.not. properties%friction%friction_coefficient_across > 0.0_wp) return
      angle = properties%friction%grain_angle*(pi/180.0_wp) + grain_turn
      axes = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
   end function grain_axes

   !> Stiffness along and across the grain, over that along it.
   pure function stiffness_ratios(properties) result(ratios)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: ratios(2)

      ratios = 1.0_wp
      if (properties%friction%friction_coefficient_across > 0.0_wp) ratios(2) = &
         properties%friction%friction_coefficient_across/properties%friction_coefficient
   end function stiffness_ratios

   !> A point slips along w_i gamma_i in the axes of the grain: normal to the ellipse of shear
   !> stresses, or along the shear stress.
   pure function slip_weights(properties) result(weights)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: weights(2)

      weights = stiffness_ratios(properties)
      if (properties%friction%slip_direction == slip_direction_associated) weights = 1.0_wp/weights
   end function slip_weights

end module asperity_contact_general_friction

! src/contact/friction.f90
!> Coulomb friction with elastic slip: tau = mu p gamma/gcrit, |gamma| <= gcrit (Eq. 27 with the
!> regularisation of Table 3), in two tangential directions; a second component of zero makes it
!> one-dimensional. Whatever finds the pressure, `slide` is the only path from there to shear
!> stresses, their derivatives and ledgers; friction that is not plain it hands on.
module asperity_contact_friction
   use asperity_base_kinds, only: wp
   use asperity_contact_general_friction, only: slide_in_general
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use asperity_contact_state, only: contact_response, contact_state, is_closed, may_close, &
      status_open, status_slip, status_stick, status_unset
   implicit none
   private
   public :: slide

contains

   !> Friction over one increment at a known pressure: first the pressure changes, at the elastic
   !> slip of the start and as its rule says, then the point slips at the pressure of the end.
   pure subroutine slide(response, properties, start, elastic_slip, overclosure, slip_increment, &
         is_open, closing, rotation, time_increment)
      !> Pressure, its derivative, normal energy, plastic dissipation and validity at the end; all
      !> the rest is set
      type(contact_response), intent(inout) :: response
      !> Friction
      type(contact_properties), intent(in) :: properties
      !> State at the start
      type(contact_state), intent(in) :: start
      !> Its elastic slip in the slip directions of the end, mm; used where it is closed
      real(wp), intent(in) :: elastic_slip(2)
      !> Overclosure at the end, mm, and relative tangential motion of the increment, mm
      real(wp), intent(in) :: overclosure, slip_increment(2)
      !> Whether the point is open at the end
      logical, intent(in) :: is_open
      !> Overclosure from which on a point is closed, mm; used where `may_close(start)`
      real(wp), intent(in) :: closing
      !> Rotation of the slip directions in the increment, none when absent, and its time, s: for
      !> friction that is not plain
      real(wp), intent(in), optional :: rotation(2, 2), time_increment
      type(slip_path) :: path
      real(wp) :: gamma(2), gamma_by_pressure(2), motion(2)
      real(wp) :: energy, kept_energy, share, share_by_overclosure
      integer :: i

      if (.not. properties%friction_is_plain) then
         share = 1.0_wp
         share_by_overclosure = 0.0_wp
         if (.not. is_open) &
            call share_after_closing(start, overclosure, closing, share, share_by_overclosure)
         call slide_in_general(response, properties, start, elastic_slip, overclosure, &
            slip_increment, is_open, share, share_by_overclosure, rotation, time_increment)
         call end_increment(response, start, overclosure)
         return
      end if
      gamma = 0.0_wp
      if (is_closed(start)) gamma = elastic_slip
      energy = elastic_energy(properties, start%pressure, gamma)
      associate (r => response, p => response%traction(1), &
            scale => properties%friction_coefficient/properties%critical_slip)
         gamma_by_pressure = 0.0_wp
         ! at rest as when it is pressed, as the stiffness of a law with memory is then
         if (properties%friction_rule == rule_dissipative .and. p >= start%pressure &
            .and. p > 0.0_wp) then
            gamma_by_pressure = -gamma*(start%pressure/p)/p
            gamma = gamma*(start%pressure/p)
         end if
         kept_energy = elastic_energy(properties, p, gamma)
         r%dissipation = 0.0_wp
         r%pressure_coupling = 0.0_wp
         r%tangential_energy = 0.0_wp
         r%state%elastic_slip = 0.0_wp
         do i = 2, 3
            r%traction(i) = 0.0_wp
            r%tangent(1, i) = 0.0_wp
            r%tangent(i, 1) = 0.0_wp
            r%tangent(i, 2) = 0.0_wp
            r%tangent(i, 3) = 0.0_wp
         end do
         if (properties%friction_rule == rule_dissipative) then
            r%dissipation = max(energy - kept_energy, 0.0_wp)
         else
            r%pressure_coupling = kept_energy - energy
         end if
         if (is_open) then
            r%status = status_open
            r%dissipation = r%dissipation + kept_energy
         else
            call share_after_closing(start, overclosure, closing, share, share_by_overclosure)
            motion = share*slip_increment
            path = integrate_slip(gamma, motion, properties%critical_slip, &
               properties%slip_integration)
            r%status = merge(status_slip, status_stick, path%slips)
            r%tangential_energy = elastic_energy(properties, p, path%elastic_slip)
            r%dissipation = r%dissipation + properties%friction_coefficient*p*path%slipped
            ! by component, as flang makes library calls of sections and of matmul
            do i = 1, 2
               r%state%elastic_slip(i) = path%elastic_slip(i)
               r%traction(1 + i) = scale*p*path%elastic_slip(i)
               r%tangent(1 + i, 1) = scale*r%tangent(1, 1)*(path%elastic_slip(i) + p &
                  *(path%by_start(i, 1)*gamma_by_pressure(1) &
                  + path%by_start(i, 2)*gamma_by_pressure(2))) &
                  + scale*p*share_by_overclosure*(path%by_increment(i, 1)*slip_increment(1) &
                  + path%by_increment(i, 2)*slip_increment(2))
               r%tangent(1 + i, 2) = scale*p*share*path%by_increment(i, 1)
               r%tangent(1 + i, 3) = scale*p*share*path%by_increment(i, 2)
            end do
         end if
      end associate
      call end_increment(response, start, overclosure)
   end subroutine slide

   !> What the point remembers of the increment.
   pure subroutine end_increment(response, start, overclosure)
      type(contact_response), intent(inout) :: response
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure

      associate (state => response%state)
         state%status = response%status
         state%overclosure = overclosure
         state%pressure = response%traction(1)
         state%normal_energy = response%normal_energy
         state%largest_closure = overclosure
         if (start%status /= status_unset) &
            state%largest_closure = max(overclosure, start%largest_closure)
         state%dissipation = start%dissipation + response%dissipation
         state%pressure_coupling = start%pressure_coupling + response%pressure_coupling
         state%validity = ior(start%validity, response%validity)
      end associate
   end subroutine end_increment

   !> Share of the increment that lies after closing, and its derivative by the overclosure, for a
   !> straight path of the overclosure. One for a point that was closed, and where nothing is known
   !> of the path.
   pure subroutine share_after_closing(start, overclosure, closing, share, by_overclosure)
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, closing
      real(wp), intent(out) :: share, by_overclosure
      real(wp) :: travel

      share = 1.0_wp
      by_overclosure = 0.0_wp
      if (.not. may_close(start)) return
      travel = overclosure - start%overclosure
      if (.not. (closing > start%overclosure .and. travel > 0.0_wp)) return
      share = min(max((overclosure - closing)/travel, 0.0_wp), 1.0_wp)
      by_overclosure = (closing - start%overclosure)/travel/travel
   end subroutine share_after_closing

   !> mu p gamma^2/(2 gcrit)
   pure real(wp) function elastic_energy(properties, pressure, elastic_slip)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: pressure, elastic_slip(2)

      elastic_energy = 0.5_wp*properties%friction_coefficient*pressure &
         *dot_product(elastic_slip, elastic_slip)/properties%critical_slip
   end function elastic_energy

end module asperity_contact_friction

! src/law/normal_inverse.f90
!> Inverse of the normal law: the separation at which it gives a pressure.
module asperity_law_normal_inverse
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   implicit none
   private
   public :: separation_for_pressure

   integer, parameter :: max_iterations = 200
   !> Newton's method is at round-off one step after the logarithm of the pressure errs by this
   real(wp), parameter :: small_mismatch = 2.0e-6_wp
   !> Largest closure beyond the mean plane that is searched, in sigma
   real(wp), parameter :: closest = 1.0e100_wp

contains

   !> Separation d with p(d) = pressure, to 4 eps max(sigma, |d|) of the direct evaluation.
   !> Newton on ln p, which is nearly linear in d far away and concave, kept inside a bracket.
   !> `error` is set unless the pressure is a normal number above zero.
   pure subroutine separation_for_pressure(properties, pressure, separation, error)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> Separation, mm
      real(wp), intent(out) :: separation
      !> Set when the pressure is refused
      type(error_type), allocatable, intent(out) :: error
      type(normal_response) :: response
      real(wp) :: near, far, next, step, small, mismatch
      integer :: iteration
      logical :: settled

      separation = 0.0_wp
      call check_pressure(pressure, error)
      if (allocated(error)) return

      far = properties%sigma
      do while (pressure_at(far) >= pressure)
         far = 2.0_wp*far
      end do
      near = -properties%sigma
      do while (pressure_at(near) < pressure)
         far = near
         near = 2.0_wp*near
         if (near < -closest*properties%sigma) then
            call fatal_error(error, 'pressure = '//to_text(pressure)//' MPa is out of reach', &
               subject='pressure')
            return
         end if
      end do

      separation = max(near, min(far, 0.0_wp))
      settled = .false.
      do iteration = 1, max_iterations
         response = evaluate_normal_law(properties, separation)
         if (response%pressure >= pressure) then
            near = separation
         else
            far = separation
         end if
         step = huge(1.0_wp)
         mismatch = huge(1.0_wp)
         if (response%pressure >= tiny(1.0_wp)) then
            mismatch = log(response%pressure) - log(pressure)
            if (abs(mismatch) < 0.5_wp) mismatch = log(response%pressure/pressure)
            step = mismatch*response%pressure/response%stiffness
         end if
         next = separation + step
         small = 1.0e-9_wp*max(properties%sigma, abs(separation))
         if (.not. (next >= near .and. next <= far) .and. abs(step) > small) then
            next = 0.5_wp*(near + far)
            step = next - separation
         end if
         separation = next
         if (settled .or. .not. abs(step) > 0.0_wp) exit
         ! Newton is quadratic: one more step from here is at round-off
         settled = abs(step) <= small .and. abs(mismatch) <= small_mismatch
      end do

   contains

      pure real(wp) function pressure_at(d)
         real(wp), intent(in) :: d
         type(normal_response) :: at_d

         at_d = evaluate_normal_law(properties, d)
         pressure_at = at_d%pressure
      end function pressure_at

   end subroutine separation_for_pressure

   pure subroutine check_pressure(pressure, error)
      real(wp), intent(in) :: pressure
      type(error_type), allocatable, intent(out) :: error

      if (is_finite(pressure)) then
         if (pressure >= tiny(1.0_wp)) return
      end if
      call fatal_error(error, 'pressure = '//to_text(pressure)// &
         ' MPa has no separation: it must be a finite number above zero (2.3e-308 or more)', &
         subject='pressure')
   end subroutine check_pressure

end module asperity_law_normal_inverse

! src/contact/point.f90
!> The contact-point update: the only path from relative motion to tractions. UINTER, the replays
!> and every other host call it and nothing else.
!>
!> Within an increment the pressure changes first, at the elastic slip of the start, then the
!> point slips at the pressure of the end. If the point closes within the increment, only the
!> share of the motion after closing counts, for a straight path of the overclosure.
module asperity_contact_point
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction, only: slide
   use asperity_contact_general_friction, only: add_friction_tangent
   use asperity_contact_properties, only: close_pressure_ratio, contact_properties
   use asperity_contact_slip_path, only: is_longer
   use asperity_contact_state, only: contact_response, contact_state, is_closed, may_close, &
      status_open, status_slip, status_unset
   use asperity_law_compiled_law, only: evaluate_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_pressure, normal_response
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_unloading_compiled_law, only: compiled_plastic_dissipation, &
      evaluate_compiled_unloading_law
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_branch, evaluate_virgin_pressure, &
      plastic_dissipation, unloading_stiffness
   implicit none
   private
   public :: update_contact_point, contact_tangent, contact_pressure, find_normal, &
      normal_values, overclosure_for

   !> What a contact point takes from the normal law. Without default values, which flang sets by
   !> library calls.
   type :: normal_values
      !> Pressure, MPa, and normal stiffness, MPa/mm
      real(wp) :: pressure, stiffness
      !> Stored (recoverable) energy per area, N/mm
      real(wp) :: energy
      !> Plastic dissipation per area since first touch, N/mm; zero without memory, and while the
      !> point is not closer than ever
      real(wp) :: plastic_dissipation
      !> `valid`, or flags
      integer :: validity
   end type normal_values

contains

   !> Advance one contact point over one increment. Any finite input gives a finite result.
   pure subroutine update_contact_point(properties, start, overclosure, slip_increment, rotation, &
         response, time_increment)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the start of the increment; no part of `response`
      type(contact_state), intent(in) :: start
      !> Overclosure at the end, mm; `no_opposite_surface` when there is none
      real(wp), intent(in) :: overclosure
      !> Relative tangential motion of the increment in the slip directions at the end, mm
      real(wp), intent(in) :: slip_increment(2)
      !> Rotation of the slip directions in the increment: a vector v becomes rotation v
      real(wp), intent(in) :: rotation(2, 2)
      !> Result; all of it is set
      type(contact_response), intent(inout) :: response
      !> Time of the increment, s, for friction that depends on the slip rate; without it, or where
      !> it is zero, friction is that of no rate
      real(wp), intent(in), optional :: time_increment
      type(normal_values) :: normal
      real(wp) :: elastic_slip(2), closing
      logical :: opens

      call find_normal(properties, start, overclosure, normal)
      response%traction(1) = normal%pressure
      response%tangent(1, 1) = normal%stiffness
      response%normal_energy = normal%energy
      response%validity = normal%validity
      response%plastic_dissipation = 0.0_wp
      if (normal%plastic_dissipation > 0.0_wp) response%plastic_dissipation = &
         max(normal%plastic_dissipation - dissipated_before(properties, start), 0.0_wp)
      elastic_slip = start%elastic_slip
      if (is_closed(start)) then
         elastic_slip = rotation(:, 1)*start%elastic_slip(1) + rotation(:, 2)*start%elastic_slip(2)
         ! a rotation that is not quite one must not lengthen it
         if (is_longer(elastic_slip, properties%critical_slip)) elastic_slip = elastic_slip &
            *(properties%critical_slip/hypot(elastic_slip(1), elastic_slip(2)))
      end if
      opens = is_open(properties, normal%pressure, is_closed(start))
      closing = 0.0_wp
      if (may_close(start) .and. .not. opens) closing = closing_overclosure(properties, start)
      call slide(response, properties, start, elastic_slip, overclosure, slip_increment, opens, &
         closing, rotation, time_increment)
   end subroutine update_contact_point

   !> Tangent about a state, for perturbations: sticking points stick, slipping points slip on, so
   !> they resist only across the slip direction. Nothing changes status. With memory a point at
   !> its largest closure parts: the stiffness is that of unloading.
   pure function contact_tangent(properties, state) result(tangent)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the base of the perturbation
      type(contact_state), intent(in) :: state
      !> d traction(i)/d (overclosure, slip 1, slip 2)(j), MPa/mm
      real(wp) :: tangent(3, 3)
      type(normal_values) :: normal
      real(wp) :: scale, across(2)

      tangent = 0.0_wp
      if (state%status == status_unset) return
      call find_normal(properties, state, state%overclosure, normal)
      if (properties%normal%unloading == unloading_elastic .and. normal%pressure > 0.0_wp &
         .and. .not. state%overclosure < state%largest_closure) normal%stiffness = &
         unloading_stiffness(properties%normal, properties%initial_separation - state%overclosure)
      tangent(1, 1) = normal%stiffness
      if (state%status == status_open) return
      if (.not. properties%friction_is_plain) then
         call add_friction_tangent(properties, state, normal%pressure, normal%stiffness, tangent)
         return
      end if
      scale = properties%friction_coefficient/properties%critical_slip
      tangent(2:3, 1) = scale*normal%stiffness*state%elastic_slip
      if (state%status == status_slip) then
         across = [-state%elastic_slip(2), state%elastic_slip(1)]/properties%critical_slip
         tangent(2:3, 2) = scale*normal%pressure*across*across(1)
         tangent(2:3, 3) = scale*normal%pressure*across*across(2)
      else
         tangent(2, 2) = scale*normal%pressure
         tangent(3, 3) = scale*normal%pressure
      end if
   end function contact_tangent

   !> Pressure of a state, MPa, from its overclosures, for hosts whose own has been rounded.
   pure real(wp) function contact_pressure(properties, state) result(pressure)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State of the point
      type(contact_state), intent(in) :: state
      type(normal_values) :: normal

      call find_normal(properties, state, state%overclosure, normal)
      pressure = normal%pressure
   end function contact_pressure

   !> The normal law at an overclosure, in the way the properties choose.
   pure subroutine find_normal(properties, start, overclosure, normal)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the start of the increment
      type(contact_state), intent(in) :: start
      !> Overclosure at its end, mm
      real(wp), intent(in) :: overclosure
      !> Its values
      type(normal_values), intent(out) :: normal

      normal = normal_values(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, properties%normal%validity)
      associate (separation => properties%initial_separation - overclosure)
         ! open, as most points of a model are: no need to evaluate zeros
         if (separation > properties%normal%vanishing_separation) return
         if (properties%normal%unloading == unloading_elastic) then
            if (remembers(properties, start) .and. overclosure < start%largest_closure) then
               call find_with_memory(properties, properties%initial_separation &
                  - start%largest_closure, start%largest_closure - overclosure, normal)
            else
               call find_with_memory(properties, separation, 0.0_wp, normal)
            end if
         else if (allocated(properties%compiled)) then
            call evaluate_compiled_law(properties%compiled, separation, normal%pressure, &
               normal%stiffness, energy=normal%energy, validity=normal%validity)
         else
            call evaluate_pressure(properties%normal, separation, normal%pressure, &
               normal%stiffness, normal%energy, normal%validity)
         end if
      end associate
   end subroutine find_normal

   !> The law with memory, compiled or directly; no plastic dissipation on the unloading branch.
   pure subroutine find_with_memory(properties, closest_separation, retraction, normal)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction
      type(normal_values), intent(inout) :: normal
      type(normal_response) :: law

      if (allocated(properties%compiled_unloading)) then
         call evaluate_compiled_unloading_law(properties%compiled_unloading, closest_separation, &
            retraction, normal%pressure, normal%stiffness, normal%energy, normal%validity)
         if (.not. retraction > 0.0_wp) normal%plastic_dissipation = &
            compiled_plastic_dissipation(properties%compiled_unloading, closest_separation)
      else if (retraction > 0.0_wp) then
         call evaluate_unloading_branch(properties%normal, closest_separation, retraction, law)
         normal = normal_values(law%pressure, law%stiffness, law%energy, 0.0_wp, law%validity)
      else
         call evaluate_virgin_pressure(properties%normal, closest_separation, normal%pressure, &
            normal%stiffness, normal%energy, normal%plastic_dissipation, normal%validity)
      end if
   end subroutine find_with_memory

   !> Whether a point was close enough before for its summits to have yielded.
   pure logical function remembers(properties, state)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: state

      remembers = .false.
      if (state%status /= status_unset) remembers = properties%initial_separation &
         - state%largest_closure <= properties%normal%vanishing_separation
   end function remembers

   !> Plastic dissipation since first touch up to the start of an increment, N/mm.
   pure real(wp) function dissipated_before(properties, start)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start

      dissipated_before = 0.0_wp
      if (.not. remembers(properties, start)) return
      associate (closest_separation => properties%initial_separation - start%largest_closure)
         if (allocated(properties%compiled_unloading)) then
            dissipated_before = compiled_plastic_dissipation(properties%compiled_unloading, &
               closest_separation)
         else
            dissipated_before = plastic_dissipation(properties%normal, closest_separation)
         end if
      end associate
   end function dissipated_before

   !> Overclosure at which a point comes to a pressure from the state that it is in: on the
   !> unloading branch where that has it, else on the virgin one. `error` is set when the law has no
   !> such pressure.
   pure subroutine overclosure_for(properties, state, pressure, overclosure, error)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State of the point
      type(contact_state), intent(in) :: state
      !> Pressure, MPa; above zero
      real(wp), intent(in) :: pressure
      !> Overclosure, mm
      real(wp), intent(out) :: overclosure
      !> Set when the pressure is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: separation, retraction

      if (properties%normal%unloading == unloading_elastic .and. remembers(properties, state)) then
         retraction = retraction_for_pressure(properties%normal, &
            properties%initial_separation - state%largest_closure, pressure)
         overclosure = state%largest_closure - retraction
         if (retraction > 0.0_wp) return
      end if
      call separation_for_pressure(properties%normal, pressure, separation, error)
      overclosure = properties%initial_separation - separation
   end subroutine overclosure_for

   !> Open below p_open; an open point closes only above twice that.
   pure logical function is_open(properties, pressure, was_closed)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: pressure
      logical, intent(in) :: was_closed

      if (was_closed) then
         is_open = pressure < properties%p_open
      else
         is_open = .not. pressure > close_pressure_ratio*properties%p_open
      end if
   end function is_open

   !> Overclosure at which an open point closes, mm; far below any where that is not found.
   pure real(wp) function closing_overclosure(properties, start) result(overclosure)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      type(error_type), allocatable :: error

      call overclosure_for(properties, start, close_pressure_ratio*properties%p_open, &
         overclosure, error)
      if (allocated(error)) overclosure = -huge(1.0_wp)
   end function closing_overclosure

end module asperity_contact_point

! interface/abaqus/routines/vuinter.f90
!> ABAQUS/Explicit user subroutine VUINTER for rough contact, 49 arguments: UINTER's law, PROPS and
!> STATEV for all slave nodes of a contact pair. Arguments have the precision of the run (see
!> vuinter_precision.f90); computing is in double precision. It keeps nothing between calls: no
!> SAVE, no COMMON, no I/O, so any number of threads may call it. ABAQUS/Explicit cannot repeat an
!> increment, so an error ends the job. Arguments: vuinter_signature.f90; deck, signs and slots:
!> docs/abaqus.md.
!>
!> Where there are so many slave nodes that it pays, the law is compiled in the call, for
!> separations within 8 sigma of the mean plane: results are then within 1e-10 of UINTER's. With
!> few nodes, beyond 8 sigma, and with memory they are UINTER's.
subroutine vuinter( &
   sfd, scd, spd, svd, stress, fluxslv, fluxmst, sed, statev, kstep, kinc, nfacnod, nslvnod, &
   nmstnod, nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv, jslvuid, jmstuid, &
   jconmstid, timstep, timglb, dtimcur, surfint, surfslv, surfmst, rdisp, drdisp, drot, &
   stiffdflt, conddflt, shape, coordslv, coordmst, alocaldir, props, areaslv, tempslv, dtempslv, &
   predefslv, dpredefslv, tempmst, dtempmst, predefmst, dpredefmst)
   use asperity_abaqus_checks, only: check_sizes, check_statev, computable, sizes_are_computable
   use asperity_abaqus_statev, only: most_statev, state_from_statev, state_warned, &
      statev_from_state, statev_needed
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_abaqus_vuinter_props, only: read_props
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_point, only: contact_pressure, update_contact_point
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_state, only: contact_response, contact_state, no_opposite_surface, &
      no_rotation, no_surface_limit, status_slip, status_stick
   use asperity_law_compile_law, only: compiling_pays, new_compiled_law
   use asperity_law_compiled_intervals, only: precise_reach
   use asperity_law_normal_properties, only: unloading_reversible
   use asperity_law_validity, only: validity_remark
   implicit none
   integer, intent(in) :: kstep, kinc, nfacnod, nslvnod, nmstnod
   integer, intent(in) :: nsurfdir, ndir, nstatevar, nprops, ntemp, npred, numdeftfv
   real(vp), intent(inout) :: sfd(nslvnod), scd(nslvnod), spd(nslvnod), svd(nslvnod)
   real(vp), intent(inout) :: stress(ndir, nslvnod), fluxslv(nslvnod), fluxmst(nslvnod)
   real(vp), intent(inout) :: sed(nslvnod), statev(nstatevar, nslvnod)
   integer, intent(in) :: jslvuid(nslvnod), jmstuid(nmstnod), jconmstid(nfacnod, nslvnod)
   real(vp), intent(in) :: timstep, timglb, dtimcur
   character(len=80), intent(in) :: surfint, surfslv, surfmst
   real(vp), intent(in) :: rdisp(ndir, nslvnod), drdisp(ndir, nslvnod), drot(2, 2, nslvnod)
   real(vp), intent(in) :: stiffdflt(nslvnod), conddflt(nslvnod), shape(nfacnod, nslvnod)
   real(vp), intent(in) :: coordslv(ndir, nslvnod), coordmst(ndir, nmstnod)
   real(vp), intent(in) :: alocaldir(ndir, ndir, nslvnod), props(nprops), areaslv(nslvnod)
   real(vp), intent(in) :: tempslv(nslvnod), dtempslv(nslvnod)
   real(vp), intent(in) :: predefslv(npred, nslvnod), dpredefslv(npred, nslvnod)
   real(vp), intent(in) :: tempmst(numdeftfv), dtempmst(numdeftfv)
   real(vp), intent(in) :: predefmst(npred, numdeftfv), dpredefmst(npred, numdeftfv)

   interface
      !> ABAQUS: message to the message file; lop -1 warns, -3 reports an error and stops.
      subroutine xplb_abqerr(lop, string, intv, realv, charv)
         use asperity_abaqus_vuinter_precision, only: vp
         implicit none
         integer, intent(in) :: lop
         character(len=*), intent(in) :: string
         integer, intent(in) :: intv(*)
         real(vp), intent(in) :: realv(*)
         character(len=8), intent(in) :: charv(*)
      end subroutine xplb_abqerr
      !> ABAQUS: ends the job.
      subroutine xplb_exit()
      end subroutine xplb_exit
   end interface

   integer, parameter :: warning = -1, fatal = -3
   type(contact_properties) :: properties
   type(contact_state) :: start
   type(contact_response) :: response
   type(error_type), allocatable :: error
   logical :: pressure_is_rounded
   integer :: node, slots, faulty, first_to_warn, n_to_warn, flags_to_warn

   associate (u1 => kstep, u2 => kinc, u3 => nsurfdir, u4 => ntemp, u5 => jmstuid, &
         u6 => jconmstid, u7 => timstep, u8 => timglb, u10 => surfslv, &
         u11 => surfmst, u12 => stiffdflt, u13 => conddflt, u14 => shape, u15 => coordslv, &
         u16 => coordmst, u17 => alocaldir, u18 => areaslv, u19 => tempslv, u20 => dtempslv, &
         u21 => predefslv, u22 => dpredefslv, u23 => tempmst, u24 => dtempmst, &
         u25 => predefmst, u26 => dpredefmst)
      ! arguments of the interface that the law does not need
   end associate

   faulty = 0
   call read_props(props, properties, error)
   if (allocated(error)) then
      ! nothing is written: the arrays may be half as long as they are declared here
      call tell(fatal, '', error%message)
      call xplb_exit()
      return
   end if

   slots = statev_needed(properties)
   call check_sizes(nstatevar, slots, ndir, error)
   if (.not. allocated(error)) call check_time(error)
   flags_to_warn = 0
   n_to_warn = 0
   first_to_warn = 0
   ! the dissipative rule would take the rounding of STATEV(3) for a change of pressure
   pressure_is_rounded = vp /= wp .and. properties%friction_rule == rule_dissipative
   if (.not. allocated(error)) call compile_for_nodes(error)
   if (.not. allocated(error)) then
      do node = 1, nslvnod
         call advance(node, start, response, error)
         if (.not. allocated(error)) cycle
         faulty = node
         exit
      end do
   end if

   scd = 0.0_vp
   svd = 0.0_vp
   fluxslv = 0.0_vp
   fluxmst = 0.0_vp
   if (allocated(error)) then
      if (faulty > 0) then
         call tell(fatal, ', NODE '//to_text(jslvuid(faulty)), error%message)
      else
         call tell(fatal, '', error%message)
      end if
      call xplb_exit()
      stress = 0.0_vp
      sed = 0.0_vp
      sfd = 0.0_vp
      spd = 0.0_vp
   else if (n_to_warn == 1) then
      call tell(warning, ', NODE '//to_text(jslvuid(first_to_warn)), &
         validity_remark(flags_to_warn))
   else if (n_to_warn > 1) then
      call tell(warning, ', '//to_text(n_to_warn)//' NODES, THE FIRST '// &
         to_text(jslvuid(first_to_warn)), validity_remark(flags_to_warn))
   end if

contains

   !> Compile the law for the separations of the nodes, where that takes less time than it saves.
   subroutine compile_for_nodes(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: reach, separation, range(2)
      integer :: node, n

      if (properties%normal%unloading /= unloading_reversible) return
      reach = precise_reach*properties%normal%sigma
      range = [reach, -reach]
      n = 0
      do node = 1, nslvnod
         if (.not. is_finite(real(rdisp(1, node), wp))) cycle
         separation = properties%initial_separation - real(rdisp(1, node), wp)
         if (.not. abs(separation) < reach) cycle
         n = n + 1
         range(1) = min(range(1), separation)
         range(2) = max(range(2), separation)
      end do
      if (.not. compiling_pays(n, properties%normal, range)) return
      allocate (properties%compiled)
      call new_compiled_law(properties%compiled, properties%normal, error, range)
   end subroutine compile_for_nodes

   !> Advance a node over the increment. `error` is set when it cannot be computed.
   subroutine advance(node, start, response, error)
      integer, intent(in) :: node
      !> Variables of the caller, as setting their default values at every node takes flang longer
      !> than the law
      type(contact_state), intent(inout) :: start
      type(contact_response), intent(inout) :: response
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: overclosure, slip(2), rotation(2, 2)

      call gather(node, start, overclosure, slip, rotation, error)
      if (allocated(error)) return
      call update_contact_point(properties, start, overclosure, slip, rotation, response, &
         real(dtimcur, wp))
      call scatter(node, response, error)
   end subroutine advance

   !> State and motion of a node.
   subroutine gather(node, state, overclosure, slip, rotation, error)
      integer, intent(in) :: node
      type(contact_state), intent(inout) :: state
      real(wp), intent(out) :: overclosure, slip(2), rotation(2, 2)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: kept(most_statev), moved(7)
      logical :: is_known

      overclosure = no_opposite_surface
      slip = 0.0_wp
      rotation = no_rotation
      kept(:slots) = real(statev(:slots, node), wp)
      is_known = all_finite(kept(:slots))
      if (is_known) is_known = sizes_are_computable(kept(:slots))
      if (.not. is_known) then
         call fatal_error(error, 'STATEV holds no number, or one above 1e30 in size')
         return
      end if
      call check_statev(kept(:slots), error)
      if (allocated(error)) return
      call state_from_statev(kept(:slots), state)
      if (pressure_is_rounded) call restore_pressure(state)

      if (.not. is_finite(real(rdisp(1, node), wp))) then
         call refuse_motion(node, error)
      else if (rdisp(1, node) > no_surface_limit) then
         overclosure = real(rdisp(1, node), wp)
         slip(:ndir - 1) = real(drdisp(2:, node), wp)
         if (ndir == 3) rotation = real(drot(:, :, node), wp)
         moved(1) = overclosure
         moved(2:3) = slip
         moved(4:5) = rotation(:, 1)
         moved(6:7) = rotation(:, 2)
         if (.not. computable(moved)) call refuse_motion(node, error)
      end if
   end subroutine gather

   !> The pressure of the start in all its digits, from the overclosure, which has lost none.
   subroutine restore_pressure(state)
      type(contact_state), intent(inout) :: state

      if (state%status /= status_stick .and. state%status /= status_slip) return
      state%pressure = contact_pressure(properties, state)
   end subroutine restore_pressure

   !> A time that is no number must not reach the law.
   subroutine check_time(error)
      type(error_type), allocatable, intent(out) :: error

      if (.not. computable([real(dtimcur, wp)])) call fatal_error(error, 'DTIMCUR = '// &
         to_text(real(dtimcur, wp))//' is no number or above 1e30 in size')
   end subroutine check_time

   subroutine refuse_motion(node, error)
      integer, intent(in) :: node
      type(error_type), allocatable, intent(out) :: error

      call fatal_error(error, 'RDISP(1) = '//to_text(real(rdisp(1, node), wp))// &
         ', or DRDISP or DROT, is no number or above 1e30 in size: the motion has diverged')
   end subroutine refuse_motion

   !> Results of a node, and what it has to warn of.
   subroutine scatter(node, response, error)
      integer, intent(in) :: node
      type(contact_response), intent(in) :: response
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: kept(most_statev), energy
      integer :: warned, fresh

      associate (r => response)
         warned = int(statev(state_warned, node))
         fresh = iand(r%state%validity, not(warned))
         call statev_from_state(r%state, kept(:slots))
         kept(state_warned) = ior(warned, r%state%validity)
         energy = r%normal_energy + r%tangential_energy
         ! in double precision nothing is
         if (vp /= wp) then
            if (any(abs([kept(:slots), r%traction, energy, r%dissipation, r%plastic_dissipation]) &
                  > real(huge(1.0_vp), wp))) then
               call fatal_error(error, 'pressure = '//to_text(r%state%pressure)//' or its '// &
                  'energy is beyond the precision of the run: the motion has diverged')
               return
            end if
         end if
         statev(:slots, node) = real(kept(:slots), vp)
         stress(:, node) = real(r%traction(:ndir), vp)
         sed(node) = real(energy, vp)
         sfd(node) = real(r%dissipation, vp)
         spd(node) = real(r%plastic_dissipation, vp)
      end associate
      if (fresh == 0) return
      if (n_to_warn == 0) first_to_warn = node
      n_to_warn = n_to_warn + 1
      flags_to_warn = ior(flags_to_warn, fresh)
   end subroutine scatter

   subroutine tell(lop, where, message)
      integer, intent(in) :: lop
      character(len=*), intent(in) :: where, message

      call xplb_abqerr(lop, 'ASPERITY VUINTER, INTERACTION '//trim(surfint)//where//': '// &
         message, [0], [0.0_vp], ['        '])
   end subroutine tell

end subroutine vuinter
