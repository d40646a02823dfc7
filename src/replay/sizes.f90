!> Ranges of the sizes and pressures of timber specimens and joints, and what a value outside them
!> looks like. A length in metres or a pressure in kPa is computed like any other, and nothing in
!> the results shows it.
!>
!> The limits are wide of what is built and tested, from furniture and scale models to bridges, and
!> of the woods there are, from balsa to the hardest. All are chosen, and no range spans a factor
!> of 1000, so that no value within one passes in a unit of 1000 or 1/1000 times the size: metres or
!> micrometres for mm, kPa or GPa for MPa. Zero, where it is allowed, means none and passes.
module asperity_replay_sizes
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: size_range, check_size, check_between, range_of, slip_text

   !> One quantity and its range.
   type :: size_range
      !> Name, as in settings and case files
      character(len=22) :: name = ''
      !> Unit: `mm`, `MPa` or `N`
      character(len=3) :: unit = ''
      !> The limits
      real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
   end type size_range

   !> The table
   type(size_range), parameter, public :: ranges(*) = [ &
      ! tenons from chair legs to bridge beams; what follows from a height is in range with it
      size_range('length', 'mm', 5.0_wp, 4000.0_wp), &
      size_range('height', 'mm', 5.0_wp, 4000.0_wp), &
      size_range('width', 'mm', 3.0_wp, 2000.0_wp), &
      size_range('extension', 'mm', 1.0_wp, 900.0_wp), &
      size_range('arm', 'mm', 20.0_wp, 19000.0_wp), &
      ! a tenth of the height as well, see `check_sizes` of the settings
      size_range('clearance_above', 'mm', 0.01_wp, 9.0_wp), &
      size_range('clearance_below', 'mm', 0.01_wp, 9.0_wp), &
      size_range('shoulder_height', 'mm', 0.8_wp, 790.0_wp), &
      size_range('shoulder_gap', 'mm', 0.01_wp, 9.0_wp), &
      size_range('bearing_depth', 'mm', 2.5_wp, 2400.0_wp), &
      size_range('column_depth', 'mm', 2.5_wp, 2400.0_wp), &
      ! wood across the grain from 40 MPa, along it to 39 GPa; rolling shear of balsa from 10 MPa
      size_range('young_modulus_l', 'MPa', 40.0_wp, 39000.0_wp), &
      size_range('young_modulus_r', 'MPa', 40.0_wp, 39000.0_wp), &
      size_range('young_modulus_t', 'MPa', 40.0_wp, 39000.0_wp), &
      size_range('shear_modulus_lr', 'MPa', 4.0_wp, 3900.0_wp), &
      size_range('shear_modulus_lt', 'MPa', 4.0_wp, 3900.0_wp), &
      size_range('shear_modulus_rt', 'MPa', 4.0_wp, 3900.0_wp), &
      ! strength from 0.3 MPa, in tension along the grain to some 250
      size_range('compression_strength_l', 'MPa', 0.3_wp, 200.0_wp), &
      size_range('compression_strength_r', 'MPa', 0.3_wp, 200.0_wp), &
      size_range('compression_strength_t', 'MPa', 0.3_wp, 200.0_wp), &
      size_range('tension_strength_l', 'MPa', 0.3_wp, 290.0_wp), &
      size_range('tension_strength_r', 'MPa', 0.3_wp, 290.0_wp), &
      size_range('tension_strength_t', 'MPa', 0.3_wp, 290.0_wp), &
      size_range('shear_strength_lr', 'MPa', 0.3_wp, 200.0_wp), &
      size_range('shear_strength_lt', 'MPa', 0.3_wp, 200.0_wp), &
      size_range('shear_strength_rt', 'MPa', 0.3_wp, 200.0_wp), &
      ! hardness from balsa across the grain to the hardest woods along it
      size_range('hardness_transverse', 'MPa', 0.5_wp, 490.0_wp), &
      size_range('hardness_tangential', 'MPa', 0.5_wp, 490.0_wp), &
      size_range('hardness_radial', 'MPa', 0.5_wp, 490.0_wp), &
      ! from the weight of a specimen to what presses soft wood flat
      size_range('side_pressure', 'MPa', 0.005_wp, 4.9_wp), &
      size_range('normal_stress', 'MPa', 0.005_wp, 4.9_wp), &
      size_range('column_load', 'N', 500.0_wp, 490000.0_wp), &
      ! steps of a replay
      size_range('displacement_increment', 'mm', 0.005_wp, 4.9_wp), &
      ! the shear box
      size_range('diameter', 'mm', 5.0_wp, 900.0_wp), &
      ! decks
      size_range('disc_height', 'mm', 1.0_wp, 900.0_wp), &
      size_range('mesh_size', 'mm', 0.5_wp, 490.0_wp), &
      size_range('rim_mesh_size', 'mm', 0.5_wp, 490.0_wp), &
      size_range('column_height', 'mm', 16.0_wp, 15000.0_wp), &
      size_range('column_width', 'mm', 5.0_wp, 4000.0_wp), &
      size_range('tail', 'mm', 5.0_wp, 4000.0_wp), &
      size_range('edge_relief', 'mm', 0.05_wp, 40.0_wp), &
      size_range('side_interference', 'mm', 0.005_wp, 4.0_wp), &
      size_range('search_distance', 'mm', 0.05_wp, 40.0_wp)]

   !> What stands for a unit of the program in other units
   type :: other_unit
      character(len=3) :: unit
      character(len=11) :: name
      !> A value in it times this is one in `unit`
      real(wp) :: factor
   end type other_unit

   !> In the order in which they are thought of
   type(other_unit), parameter :: others(*) = [ &
      other_unit('mm', 'metres', 1.0e3_wp), &
      other_unit('mm', 'micrometres', 1.0e-3_wp), &
      other_unit('mm', 'centimetres', 10.0_wp), &
      other_unit('MPa', 'Pa', 1.0e-6_wp), &
      other_unit('MPa', 'kPa', 1.0e-3_wp), &
      other_unit('MPa', 'GPa', 1.0e3_wp), &
      other_unit('N', 'kN', 1.0e3_wp)]

contains

   !> Set `error`, unless it is set, when a size is outside its range.
   pure subroutine check_size(error, name, value, accepted)
      !> Set when the size is refused; its message begins with the name
      type(error_type), allocatable, intent(inout) :: error
      !> Name of the size
      character(len=*), intent(in) :: name
      !> Its value; zero passes, and so does what is no number, which is for others to refuse
      real(wp), intent(in) :: value
      !> Whether whoever set it wants it so
      logical, intent(in) :: accepted
      type(size_range) :: range

      range = range_of(name)
      call check_between(error, name, value, range%lowest, range%highest, trim(range%unit), &
         accepted)
   end subroutine check_size

   !> As `check_size`, with limits of one's own.
   pure subroutine check_between(error, name, value, lowest, highest, unit, accepted)
      !> Set when the size is refused; its message begins with the name
      type(error_type), allocatable, intent(inout) :: error
      !> Name of the size, and its unit
      character(len=*), intent(in) :: name, unit
      !> Its value, and the limits of its size
      real(wp), intent(in) :: value, lowest, highest
      !> Whether whoever set it wants it so
      logical, intent(in) :: accepted

      if (allocated(error) .or. accepted) return
      if (.not. (abs(value) > highest .or. (abs(value) > 0.0_wp .and. abs(value) < lowest))) return
      call fatal_error(error, name//' = '//to_text(value)//' '//unit//' is outside '// &
         to_text(lowest, 4)//' to '//to_text(highest, 4)//' '//unit//': '// &
         trim(slip_text(value, lowest, highest, unit))//'; accept_sizes lets it pass', subject=name)
   end subroutine check_between

   !> What a value outside its range looks like, such as `0.25 looks like metres, write 250.0`.
   pure function slip_text(value, lowest, highest, unit) result(text)
      !> The value, and the limits of its size
      real(wp), intent(in) :: value, lowest, highest
      !> Its unit
      character(len=*), intent(in) :: unit
      character(len=80) :: text
      character(len=24) :: number
      real(wp) :: meant
      integer :: i

      text = 'check its unit'
      do i = size(others), 1, -1
         if (others(i)%unit /= unit) cycle
         ! six figures, without round-off and zeros at their end
         number = to_text(value*others(i)%factor, 6)
         read (number, *) meant
         if (abs(meant) < lowest .or. abs(meant) > highest) cycle
         text = to_text(value, 4)//' looks like '//trim(others(i)%name)//', write '//to_text(meant)
      end do
   end function slip_text

   !> The range of a size.
   pure function range_of(name) result(range)
      !> Its name, which must be one of the table
      character(len=*), intent(in) :: name
      type(size_range) :: range

      range = ranges(findloc(ranges%name == name, .true., 1))
   end function range_of

end module asperity_replay_sizes
