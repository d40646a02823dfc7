!> Wood of the decks: what is refused, and the cards of each criterion for each solver.
module test_deck_wood
   use asperity, only: error_type, wp
   use asperity_base_no_value, only: is_none
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_cards_wood_cards, only: check_criterion, write_wood
   use asperity_deck_check_wood, only: check_wood
   use asperity_deck_options, only: deck_choice
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: criteria, wood_properties
   use asperity_wood_values, only: n_values, set_wood_values, value_names, value_units, wood_values
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_deck_wood

   character(len=8), parameter :: solvers(2) = ['calculix', 'abaqus  ']

contains

   function suite_deck_wood() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('wood of decks')
      call suite%addTest(TestMethod('Table 1', test_table))
      call suite%addTest(TestMethod('values and their names', test_values))
      call suite%addTest(TestMethod('values that are refused', test_refused))
      call suite%addTest(TestMethod('elastic constants', test_elasticity))
      call suite%addTest(TestMethod('curves that are refused', test_curves))
      call suite%addTest(TestMethod('criteria of each solver', test_criteria))
      call suite%addTest(TestMethod('yield along and across the grain', test_yield))
      call suite%addTest(TestMethod('yield by curves', test_curve_cards))
      call suite%addTest(TestMethod('ratios of Hill', test_hill))
      call suite%addTest(TestMethod('curves of CalculiX', test_calculix_curve))
   end function suite_deck_wood

   !> What Table 1 of the paper prints.
   subroutine test_table()
      type(wood_properties) :: larch
      type(error_type), allocatable :: error

      call assertEqual([3727.12_wp, 351.01_wp, 351.01_wp], larch%young_moduli, 0.0_wp, 'E')
      call assertEqual([0.62_wp, 0.42_wp, 0.35_wp], larch%poisson_ratios, 0.0_wp, 'nu')
      call assertEqual([224.61_wp, 280.32_wp, 67.16_wp], larch%shear_moduli, 0.0_wp, 'G')
      call assertEqual([50.1_wp, 4.7_wp, 4.7_wp], larch%compression_strengths, 0.0_wp, 'fc')
      call assertEqual(75.3_wp, larch%tension_strengths(1), 0.0_wp, 'ft0')
      call check_wood(larch, .false., error)
      call assertFalse(allocated(error), 'allowed')
   end subroutine test_table

   !> Every value has a place of its own, there and back.
   subroutine test_values()
      type(wood_properties) :: wood
      real(wp) :: values(n_values)
      integer :: i

      values = [(real(i, wp), i=1, n_values)]
      call set_wood_values(wood, values)
      call assertEqual(values, wood_values(wood), 0.0_wp, 'back')
      call named(wood%young_moduli(3), 'young_modulus_t')
      call named(wood%poisson_ratios(3), 'poisson_ratio_rt')
      call named(wood%shear_moduli(2), 'shear_modulus_lt')
      call named(wood%compression_strengths(2), 'compression_strength_r')
      call named(wood%tension_strengths(1), 'tension_strength_l')
      call named(wood%shear_strengths(1), 'shear_strength_lr')
      call named(wood%hardening_along, 'hardening_along')
      call named(wood%hardening_across, 'hardening_across')
      call named(wood%hardnesses(2), 'hardness_tangential')
   contains
      subroutine named(place, name)
         real(wp), intent(in) :: place
         character(len=*), intent(in) :: name

         call assertEqual(name, trim(value_names(nint(place))))
      end subroutine named
   end subroutine test_values

   !> Every value out of its range, and every modulus and strength in another unit, by its name.
   subroutine test_refused()
      type(wood_properties) :: larch, wood
      type(error_type), allocatable :: error
      real(wp) :: values(n_values)
      integer :: i

      do i = 1, n_values
         values = wood_values(larch)
         values(i) = -1000.0_wp
         wood = larch
         call set_wood_values(wood, values)
         call check_wood_properties(wood, error)
         call expect(trim(value_names(i))//' = -1000.0', 'is not allowed')
         if (value_units(i) /= 'MPa') cycle
         values = wood_values(larch)
         if (is_none(values(i))) values(i) = 10.0_wp
         values(i) = 1000.0_wp*values(i)
         call set_wood_values(wood, values)
         call check_wood(wood, .false., error)
         call expect(trim(value_names(i))//' = ', 'kPa, write')
         call check_wood(wood, .true., error)
         ! a modulus so large may not go with the others
         if (allocated(error)) call assertEqual(1, index(error%message, 'poisson_ratio_'), &
            error%message)
      end do
      wood = larch
      wood%criterion = 'tresca'
      call check_wood_properties(wood, error)
      call expect("criterion = 'tresca'", 'none, mises, hill, crushing')
   contains
      subroutine expect(start, part)
         character(len=*), intent(in) :: start, part

         call assertTrue(allocated(error), start)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, start), error%message)
         call assertTrue(index(error%message, part) > 0, error%message)
         call assertTrue(fits_subject(error), error%message)
      end subroutine expect
   end subroutine test_refused

   !> What stores energy in every deformation passes; a ratio too large does not.
   subroutine test_elasticity()
      type(wood_properties) :: wood

      ! nu_RT alone: 1 is the limit for E_R = E_T
      wood%poisson_ratios = [0.0_wp, 0.0_wp, 1.001_wp]
      call expect(.false.)
      wood%poisson_ratios = [0.0_wp, 0.0_wp, 0.999_wp]
      call expect(.true.)
      ! all three together: equal ratios of an isotropic wood reach the limit at 1/2
      wood%young_moduli = 1000.0_wp
      wood%poisson_ratios = 0.501_wp
      call expect(.false.)
      wood%poisson_ratios = 0.499_wp
      call expect(.true.)
   contains
      subroutine expect(good)
         logical, intent(in) :: good
         type(error_type), allocatable :: error

         call check_wood_properties(wood, error)
         call assertTrue(good .neqv. allocated(error))
         if (allocated(error)) call assertEqual(1, index(error%subject, 'poisson_ratio_'), &
            error%message)
      end subroutine expect
   end subroutine test_elasticity

   !> A curve begins at the strength, and neither goes back nor softens.
   subroutine test_curves()
      call expect([0.0_wp, 4.7_wp, 0.1_wp, 5.0_wp, 0.5_wp, 5.0_wp], '')
      call expect([0.0_wp, 4.8_wp, 0.1_wp, 5.0_wp], 'compression_strength_r = 4.7 MPa')
      call expect([0.01_wp, 4.7_wp, 0.1_wp, 5.0_wp], 'it must begin at 0')
      call expect([0.0_wp, 4.7_wp, 0.1_wp, 4.6_wp], 'to 4.6 MPa at 0.1')
      call expect([0.0_wp, 4.7_wp, 0.1_wp, 5.0_wp, 0.1_wp, 6.0_wp], 'to 6.0 MPa at 0.1')
   contains
      subroutine expect(pairs, part)
         real(wp), intent(in) :: pairs(:)
         character(len=*), intent(in) :: part
         type(wood_properties) :: wood
         type(error_type), allocatable :: error

         wood%hardening_curve = reshape(pairs, [2, size(pairs)/2])
         call check_wood_properties(wood, error)
         call assertTrue((part == '') .neqv. allocated(error), part)
         if (.not. allocated(error)) return
         call assertTrue(index(error%message, part) > 0, error%message)
         call assertEqual(1, index(error%subject//' ', 'hardening_curve '), error%subject)
         deallocate (wood%hardening_curve)
         wood%compression_strengths(1) = 4.7_wp
         wood%hardening_curve_along = reshape(pairs, [2, size(pairs)/2])
         call check_wood_properties(wood, error)
         call assertTrue(allocated(error), part)
         if (allocated(error)) call assertEqual(1, index(error%subject, 'hardening_curve_along'))
      end subroutine expect
   end subroutine test_curves

   !> Which criteria a solver has a card for.
   subroutine test_criteria()
      logical, parameter :: has(size(criteria), size(solvers)) = reshape([ &
         .true., .true., .false., .false., .true., .true., .true., .false.], &
         [size(criteria), size(solvers)])
      type(wood_properties) :: wood
      type(deck_choice) :: choice
      type(error_type), allocatable :: error
      character(len=:), allocatable :: text
      integer :: i, j

      do j = 1, size(solvers)
         do i = 1, size(criteria)
            choice%solver = solvers(j)
            wood%criterion = criteria(i)
            call check_criterion(choice, wood, error)
            call assertTrue(has(i, j) .neqv. allocated(error), solvers(j)//' '//criteria(i))
            if (allocated(error)) then
               call assertEqual(1, index(error%message, 'criterion = '//trim(criteria(i))// &
                  ' cannot be written'), error%message)
               call assertTrue(fits_subject(error), error%message)
               cycle
            end if
            call write_card(choice%solver, wood, .false., text)
            call assertTrue((index(text, '*PLASTIC') > 0) .eqv. criteria(i) /= 'none', text)
            call assertTrue((index(text, '*POTENTIAL') > 0) .eqv. criteria(i) == 'hill', text)
         end do
      end do
   end subroutine test_criteria

   !> Yield stress over plastic strain: across the grain for Hill, along or across it for Mises, in
   !> either solver.
   subroutine test_yield()
      type(wood_properties) :: wood
      real(wp) :: across(4), along(4)
      integer :: j

      wood%hardening_along = 0.03_wp
      across = [4.7_wp, 0.0_wp, 4.7_wp + 0.02_wp*351.01_wp, 1.0_wp]
      along = [50.1_wp, 0.0_wp, 50.1_wp + 0.03_wp*3727.12_wp, 1.0_wp]
      wood%criterion = 'mises'
      do j = 1, size(solvers)
         call expect_rows(solvers(j), wood, .false., across)
         call expect_rows(solvers(j), wood, .true., along)
      end do
      wood%criterion = 'hill'
      call expect_rows('abaqus', wood, .false., across)
      call expect_rows('abaqus', wood, .true., across)
   end subroutine test_yield

   !> The points of a curve in place of the slope, each for its direction.
   subroutine test_curve_cards()
      real(wp), parameter :: across(6) = [4.7_wp, 0.0_wp, 5.5_wp, 0.1_wp, 9.0_wp, 0.4_wp], &
         along(4) = [50.1_wp, 0.0_wp, 60.0_wp, 0.05_wp]
      type(wood_properties) :: wood
      integer :: j

      wood%hardening_curve = reshape(across, [2, 3])
      wood%hardening_curve = wood%hardening_curve([2, 1], :)
      wood%criterion = 'mises'
      do j = 1, size(solvers)
         call expect_rows(solvers(j), wood, .false., across)
         call expect_rows(solvers(j), wood, .true., &
            [50.1_wp, 0.0_wp, 50.1_wp + 0.02_wp*3727.12_wp, 1.0_wp])
      end do
      wood%hardening_curve_along = reshape(along([2, 1, 4, 3]), [2, 2])
      do j = 1, size(solvers)
         call expect_rows(solvers(j), wood, .false., across)
         call expect_rows(solvers(j), wood, .true., along)
      end do
      wood%criterion = 'hill'
      call expect_rows('abaqus', wood, .true., across)
   end subroutine test_curve_cards

   !> Uniaxial stress at a strength in compression, and shear at a strength in shear, are on the
   !> surface that the ratios of *POTENTIAL mean: Hill's formula in its constants F, G, H, L, M, N.
   subroutine test_hill()
      type(wood_properties) :: wood
      character(len=:), allocatable :: text
      real(wp) :: r(6), f(6), s0, at(6)
      integer :: i

      wood%criterion = 'hill'
      wood%compression_strengths = [50.0_wp, 5.0_wp, 4.8_wp]
      wood%shear_strengths = [6.0_wp, 5.0_wp, 2.0_wp]
      call write_card('abaqus', wood, .false., text)
      call rows_after(text, '*POTENTIAL', r)
      s0 = 5.0_wp
      f(1) = 0.5_wp*(1.0_wp/r(2)**2 + 1.0_wp/r(3)**2 - 1.0_wp/r(1)**2)
      f(2) = 0.5_wp*(1.0_wp/r(3)**2 + 1.0_wp/r(1)**2 - 1.0_wp/r(2)**2)
      f(3) = 0.5_wp*(1.0_wp/r(1)**2 + 1.0_wp/r(2)**2 - 1.0_wp/r(3)**2)
      ! shear 12, 13, 23: 2N, 2M, 2L
      f(4:) = 3.0_wp/r(4:)**2
      do i = 1, 3
         at = 0.0_wp
         at(i) = -wood%compression_strengths(i)
         call assertEqual(s0, hill(at), 1.0e-12_wp*s0, 'compression')
         at = 0.0_wp
         at(3 + i) = wood%shear_strengths(i)
         call assertEqual(s0, hill(at), 1.0e-12_wp*s0, 'shear')
      end do
   contains
      pure real(wp) function hill(s)
         real(wp), intent(in) :: s(6)

         hill = sqrt(f(1)*(s(2) - s(3))**2 + f(2)*(s(3) - s(1))**2 + f(3)*(s(1) - s(2))**2 &
            + sum(f(4:)*s(4:)**2))
      end function hill
   end subroutine test_hill

   !> Beside nine elastic constants CalculiX goes on in the line of the first two points.
   subroutine test_calculix_curve()
      type(wood_properties) :: wood
      type(deck_choice) :: choice
      type(error_type), allocatable :: error

      wood%criterion = 'mises'
      wood%hardening_curve = reshape([0.0_wp, 4.7_wp, 0.1_wp, 5.5_wp], [2, 2])
      call check_criterion(choice, wood, error)
      call assertFalse(allocated(error), 'two points')
      wood%hardening_curve_along = reshape([0.0_wp, 50.1_wp, 0.1_wp, 55.0_wp, 0.2_wp, 56.0_wp], &
         [2, 3])
      call check_criterion(choice, wood, error)
      call assertTrue(allocated(error), 'three points')
      if (allocated(error)) call assertEqual(1, index(error%message, &
         'hardening_curve_along has 3 points'), error%message)
      choice%solver = 'abaqus'
      call check_criterion(choice, wood, error)
      call assertFalse(allocated(error), 'ABAQUS')
   end subroutine test_calculix_curve

   !> The rows of *PLASTIC, stress and strain by turns.
   subroutine expect_rows(solver, wood, along, expected)
      character(len=*), intent(in) :: solver
      type(wood_properties), intent(in) :: wood
      logical, intent(in) :: along
      real(wp), intent(in) :: expected(:)
      character(len=:), allocatable :: text
      real(wp) :: found(size(expected))

      call write_card(solver, wood, along, text)
      call rows_after(text, '*PLASTIC', found)
      call assertEqual(expected, found, 1.0e-12_wp*maxval(expected), solver)
   end subroutine expect_rows

   !> The text of the material.
   subroutine write_card(solver, wood, along, text)
      character(len=*), intent(in) :: solver
      type(wood_properties), intent(in) :: wood
      logical, intent(in) :: along
      character(len=:), allocatable, intent(out) :: text
      type(deck_choice) :: choice
      type(writer_type) :: deck

      choice%solver = solver
      call write_wood(deck, choice, wood, 'WOOD', along)
      text = deck%text()
   end subroutine write_card

   !> All numbers after a card, up to the next: there must be as many as are asked for.
   subroutine rows_after(text, card, found)
      character(len=*), intent(in) :: text, card
      real(wp), intent(out) :: found(:)
      character(len=:), allocatable :: rows
      integer :: i, at

      found = 0.0_wp
      at = index(text, card//new_line('a'))
      call assertTrue(at > 0, card)
      if (at == 0) return
      rows = text(at + len(card) + 1:)
      at = index(rows//'*', '*')
      rows = rows(:at - 1)
      ! several lines; a text is one record
      do i = 1, len(rows)
         if (rows(i:i) == new_line('a')) rows(i:i) = ','
      end do
      call assertEqual(size(found), count([(rows(i:i) == ',', i=1, len(rows))]), rows)
      if (size(found) == count([(rows(i:i) == ',', i=1, len(rows))])) read (rows, *) found
   end subroutine rows_after

end module test_deck_wood
