!> Two blocks of wood, one on the other, whose upper face is moved and whose foot is held: press,
!> slide, lift far in one increment, drag in the gap, and close again on a slanting way.
module test_petsc_two_blocks
   use asperity, only: error_type, wp
   use asperity_contact_state, only: status_open
   use asperity_deck_mesh_hexahedra, only: face_corners
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: new_contact_pair
   use asperity_solid_contact_rough, only: rough_law
   use asperity_solid_element_brick, only: new_brick
   use asperity_solid_material_material, only: new_solid_material
   use asperity_solid_model_equations, only: held, moved
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_equations, only: equation_system, load_state
   use asperity_solid_solve_increment, only: increment_type, solve_increment
   use asperity_wood_properties, only: wood_properties
   use contact_cases, only: pair_properties
   use test_petsc_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_two_blocks

   !> Edge of a block, mm, the gap between them at first, and their moduli over those of wood
   real(wp), parameter :: edge = 30.0_wp, gap = 1.0_wp, stiffer = 300.0_wp

contains

   function suite_two_blocks() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('two blocks')
      call suite%addTest(TestMethod('no shear while open, rough', test_rough))
      call suite%addTest(TestMethod('no shear while open, hard', test_hard))
   end function suite_two_blocks

   subroutine test_rough()
      type(rough_law) :: law

      law%properties = pair_properties()
      call compare(law)
   end subroutine test_rough

   subroutine test_hard()
      type(hard_law) :: law

      law%properties = pair_properties()
      ! as soft as the rough one here, so that blocks stay stiff beside it
      law%penalty = 20.0_wp
      call compare(law)
   end subroutine test_hard

   !> In one increment a leg and in a hundred: the shear is that of the way after closing, which is
   !> a small part of the whole. Blocks are stiff: contact takes the way in an increment as
   !> straight, and soft ones bend it when they touch.
   subroutine compare(law)
      class(solid_law), intent(in) :: law
      real(wp) :: shear(2), pressure(2)

      call travel(law, 1, shear(1), pressure(1))
      call travel(law, 100, shear(2), pressure(2))
      call assertGreaterThan(pressure(1), 0.1_wp, 'closed again')
      call assertGreaterThan(abs(shear(1)), 0.05_wp, 'with shear')
      call assertEqual(shear(2), shear(1), tolerance=0.005_wp*abs(shear(2)), message='shear')
      call assertEqual(pressure(2), pressure(1), tolerance=0.001_wp*pressure(2), &
         message='pressure')
   end subroutine compare

   !> Along the whole way; mean shear along x and mean pressure at its end.
   subroutine travel(law, steps, shear, pressure)
      class(solid_law), intent(in) :: law
      integer, intent(in) :: steps
      real(wp), intent(out) :: shear, pressure
      real(wp), parameter :: pressed = 0.1_wp, lifted = 5.0_wp
      type(solid_model) :: model
      type(equation_system) :: system
      real(wp), allocatable :: displacement(:, :), before(:, :)
      integer :: i

      call new_blocks(model, law)
      allocate (displacement(3, 16), before(3, 16), source=0.0_wp)
      system%solver%petsc = petsc
      allocate (system%residual(model%n_unknowns), system%by_motion(model%n_unknowns))
      call move([0, 0, -1], gap + pressed, steps)
      call assertTrue(all(model%pairs(1)%faces(1)%cells%start%pressure > 0.1_wp), 'pressed')
      call move([1, 0, 0], 0.5_wp, steps)
      call assertGreaterThan(maxval([(abs(model%pairs(1)%faces(1)%cells(i)%trial%traction(2)), &
         i=1, 9)]), 0.05_wp, 'slid')
      call move([0, 0, 1], lifted, 1)
      call assert_open()
      call move([1, 0, 0], 2.0_wp, steps)
      call assert_open()
      call move([-1, 0, -1], lifted + 0.02_wp, steps)
      shear = sum([(model%pairs(1)%faces(1)%cells(i)%trial%traction(2), i=1, 9)])/9
      pressure = sum([(model%pairs(1)%faces(1)%cells(i)%trial%traction(1), i=1, 9)])/9
      call system%solver%release()

   contains

      !> Move the upper face along axes, in some increments.
      subroutine move(way, length, n)
         integer, intent(in) :: way(3), n
         real(wp), intent(in) :: length
         type(increment_type) :: increment
         type(error_type), allocatable :: error
         integer :: i, j

         do j = 1, 3
            model%numbers(j, 13:16) = merge(held, moved, way(j) == 0)
         end do
         do i = 1, n
            increment = increment_type(motion=merge(-1, 1, any(way < 0))*length/n, &
               load=load_state(), is_soft=.true.)
            call solve_increment(increment, model, system, displacement, before, 1.0_wp, error)
            call assertFalse(allocated(error))
            call assertTrue(increment%is_solved, 'solved')
         end do
      end subroutine move

      subroutine assert_open()
         integer :: i

         associate (cells => model%pairs(1)%faces(1)%cells)
            call assertTrue(all(cells%start%status == status_open), 'open')
            do i = 1, size(cells)
               call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], cells(i)%trial%traction, 'no traction')
               call assertEqual([0.0_wp, 0.0_wp], cells(i)%start%elastic_slip, 'no memory')
            end do
         end associate
      end subroutine assert_open

   end subroutine travel

   !> Nodes 1 to 8 below, 9 to 16 above and wider; of each the lower four first. The foot is held,
   !> the upper block's upper face is not free.
   subroutine new_blocks(model, law)
      type(solid_model), intent(out) :: model
      class(solid_law), intent(in) :: law
      type(wood_properties) :: wood
      type(error_type), allocatable :: error
      real(wp) :: corners(3, 8), wide(3, 8)
      integer :: i, n

      corners = edge*reshape([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, &
         1, 1], [3, 8])
      wide = corners
      wide(:2, :) = 2.0_wp*corners(:2, :) - 0.5_wp*edge
      wide(3, :) = corners(3, :) + edge + gap
      wood%criterion = 'none'
      wood%young_moduli = stiffer*wood%young_moduli
      wood%shear_moduli = stiffer*wood%shear_moduli
      do i = 1, 2
         call new_solid_material(model%wood(i), wood, 1, 3, .false., error)
      end do
      allocate (model%mesh%nodes(3, 16), source=reshape([corners, wide], [3, 16]))
      model%mesh%elements = reshape([(i, i=1, 16)], [8, 2])
      model%mesh%part = [1, 2]
      model%own_elements = [1, 2]
      model%shape_of = [1, 2]
      allocate (model%shapes(2), model%points(8, 2), model%trial_points(8, 2), model%pairs(1))
      call new_brick(model%shapes(1), corners, model%wood(1)%stiffness, error)
      call assertFalse(allocated(error))
      wide = wide - spread(wide(:, 1), 2, 8)
      call new_brick(model%shapes(2), wide, model%wood(2)%stiffness, error)
      call assertFalse(allocated(error))
      ! face 2 is the upper one, face 1 the lower one
      call new_contact_pair(model%pairs(1), 'blocks', model%mesh%nodes, &
         reshape(model%mesh%elements(face_corners(:, 2), 1), [4, 1]), &
         reshape(model%mesh%elements(face_corners(:, 1), 2), [4, 1]), 3, law, error)
      call assertFalse(allocated(error))
      model%mesh%load = [13, 14, 15, 16]
      allocate (model%springs(0), model%column_loads(0))
      model%pairs_of_joint = 1
      model%small_force = 100.0_wp
      model%settings%tolerance = 1.0e-8_wp
      allocate (model%numbers(3, 16), source=held)
      n = 0
      do i = 5, 12
         model%numbers(:, i) = [n + 1, n + 2, n + 3]
         n = n + 3
      end do
      model%n_unknowns = n
      allocate (model%first_rows(0:1), source=[0, n])
   end subroutine new_blocks

end module test_petsc_two_blocks
