!> The keys of `asperity surface`: where the map comes from, how it is prepared and analysed, and
!> the law that is made of it.
module asperity_program_commands_surface_keys
   use asperity_base_kinds, only: wp
   use asperity_height_map_read, only: map_hints
   use asperity_program_commands_faces_properties, only: critical_slip, &
      friction_coefficient, hardness, modulus, n_properties, yield_factor
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_input_key, only: kind_file
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_ranges, only: linear_range
   use asperity_program_system_strings, only: string_type
   use asperity_surface_analysis, only: analysis_settings, preparation_settings
   use asperity_surface_generate_settings, only: surface_settings
   implicit none
   private
   public :: surface_options

   !> Separations of the law that are drawn and verified, unless given
   integer, parameter :: default_points = 17
   !> Properties that a map does not give
   logical, parameter :: is_key(n_properties) = [.false., .true., .false., .true., .true., &
      .false., .true., .true.]
   integer, parameter, public :: of_pair(*) = [modulus, hardness, yield_factor, &
      friction_coefficient, critical_slip]

   !> The options.
   type :: surface_options
      !> The maps of two faces that touch
      logical :: pair = .false.
      !> Lines of maps are profiles
      logical :: profiles = .false.
      !> The map, two of a pair, or profiles; and profiles at right angles to those
      type(string_type), allocatable :: files(:), perpendicular(:)
      !> What is analysed are profiles, known once the first file is read
      logical :: of_profiles = .false.
      !> Radius of the stylus
      real(wp), allocatable :: stylus_radius
      character(len=4) :: mirror = 'x'
      !> What a file does not tell
      type(map_hints) :: hints
      real(wp), allocatable :: step(:)
      real(wp), allocatable :: missing_value
      !> How the map is prepared and analysed
      type(preparation_settings) :: preparation
      real(wp), allocatable :: short_cutoff, long_cutoff
      type(analysis_settings) :: analysis
      !> Where the number of tiles comes from, not allocated for a default
      character(len=:), allocatable :: tiles_source
      logical :: tiles_given = .false.
      !> Which parameters are taken for the law
      character(len=5) :: route = 'nayak'
      logical :: verify = .false.
      !> The random surface in place of a file
      logical :: generate = .false.
      type(surface_settings) :: made
      real(wp), allocatable :: map_points(:), correlation_length(:)
      real(wp), allocatable :: longest_wave, shortest_wave
      !> Paths of the case and of the map
      character(len=:), allocatable :: case, map
      !> Pair of the paper for what the map does not give
      character(len=:), allocatable :: material
      !> The law, once it is known, whose eta, radius and sigma are those of the map
      logical :: has_law = .false.
      type(faces_type) :: faces
      real(wp), allocatable :: separation(:)
   contains
      procedure :: declare_maps, declare_generated, declare_law
   end type surface_options

contains

   !> Declare the files, how they are read, prepared and analysed.
   pure subroutine declare_maps(self, keys)
      !> The options
      class(surface_options), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      character(len=*), parameter :: for_file = 'is for files, which tell or need it; a made '// &
         'map is in mm'
      integer :: of_file(3)

      call keys%switch('pair', self%pair, 'combine the maps of two faces that touch')
      call keys%unused(.not. self%pair)
      keys%of_faces = .true.
      call keys%text('material', self%material, &
         'pair of the paper for modulus, hardness, yield factor and friction')
      keys%of_faces = .false.
      call keys%paths('files', self%files, &
         'the height map, that of each face, or profiles, as FILE without an option')
      call keys%reads('map', is_argument=.true.)
      call keys%switch('profiles', self%profiles, &
         'take each line of a map for a profile along x, not for part of a map')
      call keys%unused(.not. self%profiles)
      call keys%paths('perpendicular', self%perpendicular, &
         'profiles at right angles to the others: all FILES up to the next option')
      call keys%reads('profile', is_argument=.false.)
      call keys%optional_real('stylus_radius', self%stylus_radius, 'mm', &
         'radius of the stylus that took profiles, to be compared with that of summits')
      call keys%choice('mirror', self%mirror, 'x y none', &
         'how the second map is turned over to face the first: its x or its y reversed')
      call keys%needs(self%pair, 'is for --pair')
      call keys%choice('lateral_unit', self%hints%lateral_unit, 'm cm mm um nm', &
         'unit of x, y and steps in a file that does not tell it')
      of_file(1) = keys%last
      call keys%choice('height_unit', self%hints%height_unit, 'm cm mm um nm', &
         'unit of heights in a file that does not tell it')
      of_file(2) = keys%last
      call keys%list('step', self%step, 'mm', &
         'distance of neighbours, or that in x and that in y; of a file that does not tell it')
      call keys%optional_real('missing_value', self%missing_value, '', &
         'number that marks missing points in a text, as it stands there')
      of_file(3) = keys%last
      call keys%choice('missing', self%preparation%fills, 'mask fill', &
         'points without height: leave out, or fill in smoothly')
      call keys%real('most_missing', self%preparation%most_missing, '', &
         'share of missing points up to which a map is taken')
      call keys%whole('form', self%preparation%form, &
         'degree of the polynomial of x and y that is removed, 1 (a plane) to 8')
      call keys%optional_real('short_cutoff', self%short_cutoff, 'mm', &
         'S filter, Gaussian (ISO 16610-61): removes shorter waves; none unless given')
      call keys%optional_real('long_cutoff', self%long_cutoff, 'mm', &
         'L filter: removes longer waves; none unless given')
      call keys%choice('long_filter', self%preparation%is_robust, 'gaussian robust', &
         'kind of the L filter: linear, or robust (ISO 16610-31, -71), which pores do not bend')
      call keys%needs(allocated(self%long_cutoff), 'is for --long-cutoff')
      call keys%real('pruning', self%analysis%pruning, '', &
         'hills lower than this share of sz are no peaks (Wolf pruning)')
      call keys%unused(self%of_profiles)
      call keys%whole('tiles', self%analysis%tiles, &
         'the map is split into tiles x tiles for the uncertainties, profiles into so many groups')
      call keys%said_by(self%tiles_source)
      self%tiles_given = keys%given()
      call keys%choice('route', self%route, 'nayak paper', &
         'parameters for --case and --plot: of moments, or spd, spc, sq')
      call keys%switch('verify', self%verify, &
         'sum the law over the summits of the map beside the Gaussian integral')
      call keys%switch('generate', self%generate, 'make a random surface in place of a file')
      call keys%unused(.not. self%generate)
      call keys%needs(.not. self%generate, for_file, of_file(1))
      call keys%needs(.not. self%generate, for_file, of_file(2))
      call keys%needs(.not. self%generate, for_file, of_file(3))
   end subroutine declare_maps

   !> Declare the random surface.
   pure subroutine declare_generated(self, keys)
      !> The options
      class(surface_options), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      character(len=*), parameter :: for_made = 'is for --generate', &
         of_correlation = 'is not for --spectrum self_affine', &
         of_waves = 'is for --spectrum self_affine'
      integer :: length, direction
      logical :: affine

      associate (made => self%made)
         if (.not. allocated(self%map_points)) self%map_points = [real(made%points_x, wp)]
         call keys%list('map_points', self%map_points, '', &
            'its points, or those along x and along y')
         call keys%means('points_x points_y')
         call keys%needs(self%generate, for_made)
         call keys%real('sq', made%sq, 'mm', 'its root mean square height')
         call keys%needs(self%generate, for_made)
         call keys%list('correlation_length', self%correlation_length, 'mm', &
            'where correlation falls to 1/e, or that in x and that in y; 10 steps unless given')
         call keys%means('correlation_length_x correlation_length_y')
         call keys%said_by('10 steps')
         call keys%needs(self%generate, for_made)
         length = keys%last
         call keys%real('length_direction', made%direction, 'deg', &
            'angle of the first correlation length, from x towards y')
         call keys%means('direction')
         call keys%needs(self%generate, for_made)
         direction = keys%last
         call keys%choice('spectrum', made%spectrum, 'gaussian exponential self_affine', &
            'its autocorrelation, or a self-affine spectrum')
         call keys%needs(self%generate, for_made)
         affine = made%spectrum == 'self_affine'
         call keys%needs(.not. affine, of_correlation, length)
         call keys%needs(.not. affine, of_correlation, direction)
         call keys%real('hurst', made%hurst, '', 'Hurst exponent of self_affine')
         call keys%needs(self%generate, for_made)
         call keys%needs(affine, of_waves)
         call keys%optional_real('longest_wave', self%longest_wave, 'mm', &
            'self_affine: the spectrum is flat above; a quarter of the map unless given')
         call keys%said_by('quarter of the map')
         call keys%needs(self%generate, for_made)
         call keys%needs(affine, of_waves)
         call keys%optional_real('shortest_wave', self%shortest_wave, 'mm', &
            'self_affine: no shorter waves; 8 steps unless given')
         call keys%said_by('8 steps')
         call keys%needs(self%generate, for_made)
         call keys%needs(affine, of_waves)
         call keys%real('ssk', made%ssk, '', 'its skewness')
         call keys%needs(self%generate, for_made)
         call keys%real('sku', made%sku, '', 'its kurtosis')
         call keys%needs(self%generate, for_made)
         call keys%whole('seed', made%seed, 'seed of its random numbers')
         call keys%needs(self%generate, for_made)
      end associate
   end subroutine declare_generated

   !> Declare the law: what the map does not give, and separations.
   pure subroutine declare_law(self, keys)
      !> The options
      class(surface_options), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      integer :: i

      call keys%text('case', self%case, &
         'write the parameters of route as a case for curve, press, shear, tenon and table', &
         kind_file)
      call keys%text('map', self%map, &
         'write the map as it was analysed, .sdf, .xyz or .csv', kind_file)
      self%faces%pair = ''
      self%faces%surface = ''
      call self%faces%declare_values(keys, is_key)
      do i = 1, size(of_pair)
         keys%last = self%faces%keys(of_pair(i))
         if (self%has_law) call keys%said_by('pair '//self%material)
      end do
      call self%faces%declare_separation(keys)
      call keys%said_by('4 sigma')
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      keys%of_faces = .false.
      if (self%has_law .and. .not. allocated(self%separation)) &
         self%separation = linear_range(self%faces%usual_separation(), 0.0_wp, default_points)
      call keys%list('separation', self%separation, 'mm', &
         'separations, also from:to:count as an option; 4 sigma to 0 unless given')
      call keys%said_by('4 sigma to 0')
   end subroutine declare_law

end module asperity_program_commands_surface_keys
