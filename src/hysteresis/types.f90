!> What the post-processing of displacement-force records takes and gives. Units are those of the
!> record: stiffness is force over displacement, energy force times displacement. Rotation and
!> moment may stand for displacement and force.
module asperity_hysteresis_types
   use asperity_base_checks, only: check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   implicit none
   private
   public :: hysteresis_settings, hysteresis_cycle, hysteresis_skeleton, hysteresis_result
   public :: check_hysteresis_settings, record_outlier, record_gap
   public :: en_12512_numbers, en_26891_numbers, hysteresis_amplitude

   !> The two sides of a record, as places in arrays of two
   integer, parameter, public :: positive_side = 1, negative_side = 2
   !> Sign of displacement on each side
   real(wp), parameter, public :: side_sign(2) = [1.0_wp, -1.0_wp]
   !> Share of the peak force at which the initial stiffness begins (EN 12512)
   real(wp), parameter, public :: initial_fraction = 0.1_wp
   !> Share of the force of the first cycle that the third must hold (EN 1998-1)
   real(wp), parameter, public :: held_share = 0.8_wp
   !> Numbers of a record, and a threshold, must be smaller, so that no product overflows
   real(wp), parameter, public :: largest_value = 1.0e100_wp
   !> Forces below this share of the record's largest are round-off
   real(wp), parameter, public :: round_off_share = 1.0e-9_wp
   !> Length of a kind of record, a definition of peaks, a quantity
   integer, parameter, public :: name_length = 24

   !> How a record is read.
   type :: hysteresis_settings
      !> Reversals of displacement up to this size are noise, and so is such a distance from zero;
      !> zero for 1/400 of the record's range of displacement, or more where the record is noisy
      real(wp) :: threshold = 0.0_wp
      !> A peak has a new amplitude if it is larger than all before it by this share at least
      real(wp) :: amplitude_tolerance = 0.05_wp
      !> Skeleton by the first-cycle `envelope`, or one point a cycle, its largest `displacement` or
      !> its largest `force`. The last makes the largest force the peak of a half cycle, the others
      !> its tip
      character(len=12) :: peaks = 'envelope'
      !> Single samples far off those beside them: `drop` or `keep`
      character(len=12) :: outliers = 'drop'
      !> Forces up to this size are zero; zero for 1e-9 of the largest
      real(wp) :: force_floor = 0.0_wp
      !> Share of the peak force that the elastic stiffness goes through (ASTM E2126)
      real(wp) :: elastic_fraction = 0.4_wp
      !> Share of the peak force, past the peak, at the ultimate point (ASTM E2126)
      real(wp) :: ultimate_fraction = 0.8_wp
      !> One millimetre in the unit of displacement, for the limits of EN 12512 and EN 26891, which
      !> are not applied without it
      real(wp) :: millimetre = none
      !> Estimated largest force (EN 26891); found in the record where it has none
      real(wp) :: estimated_force = none
   end type hysteresis_settings

   !> One cycle. Arrays of two hold the positive side first.
   type :: hysteresis_cycle
      !> First and last sample of the record in this cycle
      integer :: first = 0, last = 0
      !> Displacement and force where it starts, which may lie between two samples
      real(wp) :: start_displacement = 0.0_wp, start_force = 0.0_wp
      !> Displacement and force where it ends
      real(wp) :: end_displacement = 0.0_wp, end_force = 0.0_wp
      !> It ends at the displacement at which it started, but for the threshold
      logical :: closed = .false.
      !> Sample of the peak on each side; zero where the record has none
      integer :: peak(2) = 0
      !> Displacement of each peak, signed
      real(wp) :: displacement(2) = none
      !> Force of each peak, signed
      real(wp) :: force(2) = none
      !> Whether the peak is a point of the skeleton
      logical :: in_skeleton(2) = .false.
      !> (|F+| + |F-|)/(|X+| + |X-|), of one side when there is no other
      real(wp) :: secant_stiffness = none
      !> Mean of |F+|/|X+| and |F-|/|X-|, as the paper has it, of one side when there is no other
      real(wp) :: mean_secant_stiffness = none
      !> Secant stiffness over that of the first cycle
      real(wp) :: stiffness_ratio = none
      !> Work of the force in this cycle, in the record's order, and in all cycles up to it
      real(wp) :: energy = 0.0_wp, cumulative_energy = 0.0_wp
      !> Area of the loop, its small gap closed by a straight line; of closed cycles with both peaks
      !> only, as are the next three, which a loop that gives energy back does not have
      real(wp) :: loop_area = none
      !> Equivalent viscous damping, area/(2 pi (F+ X+/2 + F- X-/2))
      real(wp) :: damping = none
      !> Pinching ratio: height of the loop at zero displacement over F+ - F-
      real(wp) :: pinching = none
      !> Area over that of the rectangle (F+ - F-)(X+ - X-)
      real(wp) :: fullness = none
      !> Work on each side of zero displacement: of half cycles that begin and end at zero
      !> displacement or without force, as are the next
      real(wp) :: half_energy(2) = none
      !> Equivalent viscous damping of each half cycle, work/(2 pi F X/2) (EN 12512)
      real(wp) :: half_damping(2) = none
   end type hysteresis_cycle

   !> What EN 12512 makes of a skeleton, as it is commonly cited; the skeleton counts up to 30 mm,
   !> if it is known what a millimetre is. Displacement and force are signed.
   type :: en_12512_numbers
      !> Point of the largest force
      real(wp) :: peak_displacement = none, peak_force = none
      !> Yield point where two straight parts meet (method a); only if there are two clear ones
      real(wp) :: two_lines_displacement = none, two_lines_force = none
      !> Yield point where the line through 0.1 and 0.4 of the peak force meets the tangent with a
      !> sixth of its slope (method b)
      real(wp) :: tangent_displacement = none, tangent_force = none
      !> The method that counts, `two_lines` or `tangent`; blank if there is no yield point
      character(len=name_length) :: yield_method = ''
      !> Ultimate point
      real(wp) :: ultimate_displacement = none, ultimate_force = none
      !> What ends the skeleton there: the `force`, fallen to 0.8 of its peak, the `limit` of 30 mm,
      !> or its `end`, as at a failure
      character(len=name_length) :: ultimate_reason = ''
      !> Ultimate over yield displacement
      real(wp) :: ductility = none
      !> Largest amplitude over yield displacement, up to the ultimate point, at which the force of
      !> the third cycle is at least 0.8 of that of the first
      real(wp) :: three_cycle_ductility = none
   end type en_12512_numbers

   !> What EN 26891 makes of a monotonic test, as it is commonly cited. Displacement and force are
   !> signed, `slip` is displacement.
   type :: en_26891_numbers
      !> Estimated largest force, and where it comes from: `given`, `unloading` (from 0.4 to 0.1 of
      !> it), or `peak_force`, if nothing else tells it
      real(wp) :: estimated_force = none
      character(len=name_length) :: estimated_by = ''
      !> Largest force up to 15 mm, if it is known what a millimetre is, and its displacement
      real(wp) :: peak_displacement = none, peak_force = none
      !> Slip at 0.1 and 0.4 of the estimated force, when it is first loaded; the latter is v_i
      real(wp) :: slip_at_10_percent = none, initial_slip = none
      !> v_i,mod = 4/3 (v_04 - v_01)
      real(wp) :: modified_initial_slip = none
      !> v_s = v_i - v_i,mod
      real(wp) :: joint_settlement = none
      !> v_e = 2/3 (v_14 + v_24 - v_11 - v_21), at 0.4 before and after the unloading, and at 0.1
      !> at its beginning and its end; of tests that have the unloading, as is what needs v_24
      real(wp) :: elastic_slip = none
      !> k_i = 0.4 F_est/v_i and k_s = 0.4 F_est/v_i,mod
      real(wp) :: initial_slip_modulus = none, slip_modulus = none
      !> Slip at 0.6 and 0.8 of the largest force
      real(wp) :: slip_at_60_percent = none, slip_at_80_percent = none
      !> The same less v_24, with v_i,mod
      real(wp) :: modified_slip_at_60_percent = none, modified_slip_at_80_percent = none
   end type en_26891_numbers

   !> The cycles of one amplitude on one side.
   type :: hysteresis_amplitude
      !> Side, and how many cycles reach this amplitude before a larger one
      integer :: side = positive_side, cycles = 0
      !> The first three of them, zero where there are fewer
      integer :: cycle(3) = 0
      !> Their peaks, signed: points of the envelopes of first, second and third cycles (EN 12512)
      real(wp) :: displacement(3) = none, force(3) = none
      !> Impairment of strength from the first to the third cycle, over the first (EN 12512)
      real(wp) :: impairment = none
   end type hysteresis_amplitude

   !> Skeleton of one side and what follows from it; displacement and force are signed.
   type :: hysteresis_skeleton
      !> Points from the inside to the outside, without the origin
      real(wp), allocatable :: displacement(:), force(:)
      !> Cycle of each point; zero if the record is its own skeleton
      integer, allocatable :: cycle(:)
      !> Force at zero displacement that the other side has left, signed, for which a straight line
      !> takes the place of the first excursion of an envelope; else zero
      real(wp) :: left_force = 0.0_wp
      !> Sample of the record's largest force on this side; zero if it has none there
      integer :: record_sample = 0
      !> Displacement and force of that sample, signed
      real(wp) :: record_displacement = none, record_force = none
      !> Slope between 0.1 of the peak force and the elastic fraction (EN 12512)
      real(wp) :: initial_stiffness = none
      !> Slope from the origin through the elastic fraction of the peak force, Ke of ASTM E2126
      real(wp) :: elastic_stiffness = none
      !> Yield point of equal energy (EEEP)
      real(wp) :: yield_displacement = none, yield_force = none
      !> The equal-energy equation has no solution, and 0.85 of the peak force is taken instead
      logical :: yield_assumed = .false.
      !> Point of the largest force
      real(wp) :: peak_displacement = none, peak_force = none
      !> Point past the peak where the force has fallen to the ultimate fraction, or the last point
      real(wp) :: ultimate_displacement = none, ultimate_force = none
      !> The force has fallen so far
      logical :: ultimate_reached = .false.
      !> Area under the skeleton from the origin to the ultimate point
      real(wp) :: area = none
      !> Ultimate over yield displacement
      real(wp) :: ductility = none
      !> The same by EN 12512
      type(en_12512_numbers) :: en_12512
   end type hysteresis_skeleton

   !> A sample far off those beside it.
   type :: record_outlier
      !> Sample
      integer :: sample = 0
      !> `displacement` or `force`
      character(len=name_length) :: quantity = ''
      !> Its value in the record
      real(wp) :: value = 0.0_wp
   end type record_outlier

   !> A step of displacement far larger than those beside it.
   type :: record_gap
      !> Sample before it
      integer :: sample = 0
      !> Its size
      real(wp) :: step = 0.0_wp
   end type record_gap

   !> Everything found in a record.
   type :: hysteresis_result
      !> `monotonic`, `monotonic_with_unloading`, `cyclic` or `one_sided`
      character(len=name_length) :: record_kind = ''
      !> Standard deviation of the noise of displacement, as far as the samples tell
      real(wp) :: displacement_noise = 0.0_wp
      !> Threshold in use, and whether noise makes it, as it needs more than 1/400 of the range
      real(wp) :: threshold = 0.0_wp
      logical :: noise_sets_threshold = .false.
      !> Outliers; they are left out if the settings say so
      type(record_outlier), allocatable :: outliers(:)
      !> Gaps in sampling
      type(record_gap), allocatable :: gaps(:)
      !> Displacement, far from zero, at which the record begins without force
      real(wp) :: unloaded_displacement = none
      !> Force at which the record begins without displacement
      real(wp) :: loaded_force = none
      !> Samples at which the displacement turns, and the last extreme of a record that still moves;
      !> reversals that make no cycle are not among them
      integer, allocatable :: turning_points(:)
      !> The cycles, which follow each other without a gap
      type(hysteresis_cycle), allocatable :: cycles(:)
      !> Skeletons of the positive and the negative side; without points if there are none
      type(hysteresis_skeleton) :: skeleton(2)
      !> Mean of both skeletons, without points unless both have some (ASTM E2126)
      type(hysteresis_skeleton) :: mean_skeleton
      !> Cycles by amplitude, the positive side first
      type(hysteresis_amplitude), allocatable :: amplitudes(:)
      !> Of monotonic records
      type(en_26891_numbers) :: en_26891
   end type hysteresis_result

contains

   !> `error` is set when a setting is not allowed.
   pure subroutine check_hysteresis_settings(settings, error)
      !> Settings
      type(hysteresis_settings), intent(in) :: settings
      !> Set when one is refused; its message starts with the name
      type(error_type), allocatable, intent(out) :: error

      call check_range(error, 'threshold', settings%threshold, 0.0_wp, largest_value, '')
      if (.not. allocated(error)) call check_range(error, 'amplitude_tolerance', &
         settings%amplitude_tolerance, 0.0_wp, 1.0_wp, '')
      if (.not. allocated(error)) call check_range(error, 'elastic_fraction', &
         settings%elastic_fraction, 0.2_wp, 0.9_wp, '')
      if (.not. allocated(error)) call check_range(error, 'ultimate_fraction', &
         settings%ultimate_fraction, 0.1_wp, 0.99_wp, '')
      if (.not. allocated(error)) call check_range(error, 'force_floor', settings%force_floor, &
         0.0_wp, largest_value, '')
      if (.not. allocated(error) .and. .not. is_none(settings%millimetre)) &
         call check_range(error, 'millimetre', settings%millimetre, round_off_share, &
         largest_value, '')
      if (.not. allocated(error) .and. .not. is_none(settings%estimated_force)) &
         call check_range(error, 'estimated_force', settings%estimated_force, &
         1.0_wp/largest_value, largest_value, '')
      if (allocated(error)) return
      if (all(settings%peaks /= [character(len=12) :: 'envelope', 'displacement', 'force'])) then
         call fatal_error(error, "peaks = '"//trim(settings%peaks)// &
            "' is unknown; known: envelope, displacement, force", subject='peaks')
      else if (all(settings%outliers /= [character(len=12) :: 'drop', 'keep'])) then
         call fatal_error(error, "outliers = '"//trim(settings%outliers)// &
            "' is unknown; known: drop, keep", subject='outliers')
      end if
   end subroutine check_hysteresis_settings

end module asperity_hysteresis_types
