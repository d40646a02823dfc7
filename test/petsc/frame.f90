!> Programmes of frames: balances of forces and moments, mirror, elasticity in closed form,
!> checkpoint.
module test_petsc_frame
   use asperity, only: contact_properties, error_type, wp
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_tenon_sizes, tenon_sizes
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_solid_element_brick, only: brick_response
   use asperity_solid_frame_model, only: new_frame_model
   use asperity_solid_frame_settings, only: frame_settings
   use asperity_solid_material_material, only: material_point
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_model_settings, only: solid_settings
   use asperity_solid_solve_checkpoint, only: read_run, write_run
   use asperity_solid_solve_programme, only: new_solid_run, run_programme, solid_run
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFail, assertFalse, assertGreaterThan, assertTrue, &
      TestMethod, TestSuite
   use joint_cases, only: stop_at, stopper
   use measurements, only: record
   use test_petsc_engine, only: petsc
   implicit none
   private
   public :: suite_frame

   !> Height of the columns, distance of their axes, height of the beam's, mm
   real(wp), parameter :: height = 2000.0_wp, span = 1500.0_wp, level = 1200.0_wp
   !> Load of each column, N
   real(wp), parameter :: load = 40.0e3_wp

contains

   function suite_frame() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('frame')
      call suite%addTest(TestMethod('forces and moments balance', test_balance))
      call suite%addTest(TestMethod('left is right in a mirror', test_mirror))
      call suite%addTest(TestMethod('elastic columns and beam in closed form', test_elastic))
      call suite%addTest(TestMethod('cut is uncut', test_checkpoint))
   end function suite_frame

   !> A frame of two columns and a beam: one stroke to a sway, or back and forth.
   subroutine new_frame(model, sway, criterion, column_load, between)
      type(solid_model), intent(out) :: model
      !> Sway of the heads, mm
      real(wp), intent(in) :: sway
      character(len=*), intent(in) :: criterion
      !> Load of each column, N
      real(wp), intent(in) :: column_load
      !> Distance of the columns' axes, `span` unless given, mm
      real(wp), intent(in), optional :: between
      type(frame_settings) :: frame
      type(tenon_settings) :: joint
      type(tenon_sizes) :: sizes
      type(tenon_deck) :: deck
      type(deck_choice) :: choice
      type(solid_settings) :: settings
      type(contact_properties) :: faces, sides
      type(error_type), allocatable :: error

      joint%arm = height
      joint%wood%criterion = criterion
      allocate (joint%amplitudes, source=[abs(sway)])
      allocate (joint%cycles, source=[1])
      sizes = default_tenon_sizes(joint)
      sizes%column_height = height
      sizes%tail = 150.0_wp
      allocate (frame%column_places, source=[0.0_wp, span])
      if (present(between)) frame%column_places(2) = between
      allocate (frame%beam_heights, source=[level])
      allocate (frame%column_loads, source=[column_load])
      choice%command = ''
      choice%mesh_size = 100.0_wp
      settings%stroke_increments = 3
      settings%tolerance = 1.0e-6_wp
      faces = pair_properties()
      sides = pair_properties(pair='tangential-tangential')
      call new_tenon_deck(deck, choice, joint, sizes, settings%stroke_increments, faces, sides, &
         error)
      if (.not. allocated(error)) call new_frame_model(model, frame, deck, settings, error)
      if (allocated(error)) call assertFail(error%message)
      if (sway < 0.0_wp) model%turns = -model%turns
   end subroutine new_frame

   !> Run a frame until so many strokes are done.
   subroutine follow(run, model, strokes)
      type(solid_run), intent(out) :: run
      type(solid_model), intent(in) :: model
      integer, intent(in) :: strokes
      type(stopper) :: observer
      type(error_type), allocatable :: error

      observer%strokes = strokes
      call new_solid_run(run, model, petsc, error)
      if (.not. allocated(error)) call run_programme(run, observer, error)
      if (.not. allocated(error)) return
      if (error%message /= stop_at) call assertFail(error%message)
   end subroutine follow

   !> In the deformed frame: base shear is the reaction of the feet; moments of the joints are those
   !> of base shear and loads about the feet, and those of the beam's ends; all within the
   !> tolerance of equilibrium.
   subroutine test_balance()
      type(solid_model) :: model
      type(solid_run) :: run
      real(wp) :: reaction, moment
      integer :: i, n

      call new_frame(model, 40.0_wp, 'crushing', load)
      call follow(run, model, 3)
      n = size(run%records)
      call assertEqual([2, n], shape(run%joints))
      do i = 1, n
         associate (joints => run%joints(:, i), sway => run%records(i)%displacement, &
               force => run%records(i)%force)
            ! columns shorten by less than a millimetre
            moment = force*height + 2.0_wp*load*sway
            call assertEqual(moment, sum(joints%moment), tolerance=0.001_wp*peak(run), &
               message='about the feet')
            call assertEqual(span*joints(1)%force(2), sum(joints%moment), &
               tolerance=0.02_wp*peak(run), message='of the beam')
            call assertEqual(0.0_wp, sum(joints%force(1)), tolerance=20.0_wp, message='along x')
            call assertEqual(0.0_wp, sum(joints%force(2)), tolerance=20.0_wp, message='along z')
         end associate
      end do
      call find_reaction(run, reaction)
      call assertEqual(-run%records(n)%force, reaction, tolerance=20.0_wp, message='of the feet')
      call assertGreaterThan(maxval(run%joints%friction_energy), 1.0_wp, 'joints slip')
   end subroutine test_balance

   !> Largest moment of all joints, N mm.
   real(wp) function peak(run)
      type(solid_run), intent(in) :: run

      peak = maxval(abs(sum(run%joints%moment, 1)))
   end function peak

   !> Force of the ground on the whole frame along x, from the elements at the feet, N.
   subroutine find_reaction(run, reaction)
      type(solid_run), intent(in) :: run
      real(wp), intent(out) :: reaction
      type(material_point) :: points(8)
      real(wp) :: corners(3, 8), forces(3, 8), no_strain(6)
      integer :: i, j, n
      logical :: is_inverted

      reaction = 0.0_wp
      no_strain = 0.0_wp
      associate (model => run%model)
         do i = 1, size(model%mesh%elements, 2)
            associate (nodes => model%mesh%elements(:, i), shape => model%shapes(model%shape_of(i)))
               if (.not. any([(any(model%mesh%foot == nodes(j)), j=1, 8)])) cycle
               corners = shape%corners + run%displacement(:, nodes)
               call brick_response(shape, model%wood(model%mesh%part(i)), corners, no_strain, &
                  model%points(:, i), points, forces, n, inverted=is_inverted)
               do j = 1, 8
                  if (any(model%mesh%foot == nodes(j))) reaction = reaction + 2.0_wp*forces(1, j)
               end do
            end associate
         end do
      end associate
   end subroutine find_reaction

   !> Sway to the left is sway to the right, with the joints in turn.
   subroutine test_mirror()
      type(solid_model) :: model
      type(solid_run) :: right, left
      integer :: i

      call new_frame(model, 40.0_wp, 'crushing', load)
      call follow(right, model, 1)
      call new_frame(model, -40.0_wp, 'crushing', load)
      call follow(left, model, 1)
      call assertEqual(size(right%records), size(left%records))
      do i = 1, size(right%records)
         call assertEqual(right%records(i)%force, -left%records(i)%force, &
            tolerance=1.0e-4_wp*abs(right%records(i)%force), message='base shear')
         call assertEqual(right%joints(1, i)%moment, -left%joints(2, i)%moment, &
            tolerance=1.0e-4_wp*abs(right%joints(1, i)%moment), message='moments')
         call assertEqual(right%joints(2, i)%rotation, -left%joints(1, i)%rotation, &
            tolerance=1.0e-4_wp*abs(right%joints(2, i)%rotation), message='rotations')
      end do
   end subroutine test_mirror

   !> What columns and beam of an elastic frame add to the drift beside the turn of the joints, over
   !> the moment of a joint, grows with the span as Timoshenko's beam says that bends to both sides
   !> over its clear length l of a span s: by l**3/(6 EI s**2) + 2 l/(s**2 k G A). What is within
   !> joints and columns is the same in both frames. Mean dilatation sees (2/3)**2 of the energy of
   !> bending within a layer of bricks, whose share of the beam's is 1/4**2 with four layers.
   subroutine test_elastic()
      real(wp), parameter :: spans(2) = [4000.0_wp, 8000.0_wp], shear_share = 5.0_wp/6.0_wp, &
         softer = 1.0_wp - (1.0_wp - 4.0_wp/9.0_wp)/4.0_wp**2
      type(solid_model) :: model
      type(solid_run) :: run
      type(tenon_settings) :: joint
      real(wp) :: found(2), expected(2), clear
      integer :: i, n

      do i = 1, 2
         call new_frame(model, 1.0_wp, 'none', 0.0_wp, spans(i))
         call follow(run, model, 1)
         n = size(run%records)
         found(i) = (2.0_wp*run%records(n)%displacement/height - sum(run%joints(:, n)%rotation)) &
            /sum(run%joints(:, n)%moment)
         clear = spans(i) - joint%length
         associate (e => joint%wood%young_moduli(1), g => joint%wood%shear_moduli(1), &
               area => joint%width*joint%height)
            expected(i) = clear**3 &
               /(6.0_wp*softer*e*area*joint%height**2/12.0_wp*spans(i)**2) &
               + 2.0_wp*clear/(spans(i)**2*shear_share*g*area)
         end associate
      end do
      call record('solid.frame.flexibility', (found(2) - found(1))/(expected(2) - expected(1)) &
         - 1.0_wp)
      call assertEqual(expected(2) - expected(1), found(2) - found(1), &
         tolerance=0.03_wp*(expected(2) - expected(1)))
   end subroutine test_elastic

   !> Records, joints and displacements of a run that went on from a file.
   subroutine test_checkpoint()
      type(solid_model) :: model
      type(solid_run) :: uncut, cut, continued
      type(stopper) :: observer
      type(error_type), allocatable :: error
      integer :: unit, status

      call new_frame(model, 20.0_wp, 'crushing', load)
      call follow(uncut, model, 3)
      call follow(cut, model, 2)
      open (newunit=unit, access='stream', form='unformatted', status='scratch', &
         action='readwrite')
      call write_run(unit, cut, status)
      call assertEqual(0, status, message='written')
      rewind (unit)
      call new_solid_run(continued, model, petsc, error)
      call read_run(unit, continued, status)
      close (unit)
      call assertEqual(0, status, message='read')
      call run_programme(continued, observer, error)
      call assertFalse(allocated(error))
      call assertEqual(shape(uncut%joints), shape(continued%joints))
      call assertTrue(all(same(uncut%displacement, continued%displacement)), 'displacements')
      call assertTrue(all(same(uncut%joints%moment, continued%joints%moment)), 'moments')
      call assertTrue(all(same(uncut%records%force, continued%records%force)), 'forces')

   contains

      pure elemental logical function same(a, b)
         real(wp), intent(in) :: a, b

         same = .not. abs(a - b) > 0.0_wp
      end function same

   end subroutine test_checkpoint

end module test_petsc_frame
