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
