!> Models of the decks: fit of the sides, gaps, strokes, numbers as text, what is refused.
module test_deck_models
   use asperity, only: contact_properties, error_type, evaluate_normal_law, normal_response, wp
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_mesh_cheek_interference, only: side_interference
   use asperity_deck_options, only: deck_choice
   use asperity_deck_shear_deck, only: new_shear_deck, shear_deck
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_tenon_sizes
   use asperity_deck_tenon_text, only: write_tenon_deck
   use asperity_replay_shear_settings, only: shear_settings
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_wood_properties, only: wood_properties
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_deck_models

contains

   function suite_deck_models() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('models of decks')
      call suite%addTest(TestMethod('numbers as text', test_numbers))
      call suite%addTest(TestMethod('comments', test_comments))
      call suite%addTest(TestMethod('side fit, rigid cheek', test_rigid_cheek))
      call suite%addTest(TestMethod('side fit, free cheek', test_free_cheek))
      call suite%addTest(TestMethod('side fit, by differences', test_cheek_differences))
      call suite%addTest(TestMethod('overlap of the discs', test_discs))
      call suite%addTest(TestMethod('gaps and sides of the joint', test_gaps))
      call suite%addTest(TestMethod('strokes', test_strokes))
      call suite%addTest(TestMethod('refused', test_refused))
   end function suite_deck_models

   !> Fields have up to 20 characters, eight numbers a line, and lose as little as that allows.
   subroutine test_numbers()
      real(wp), parameter :: values(*) = [1.0_wp/3.0_wp, -2.0_wp/3.0e5_wp, 3.0_wp, &
         -1.0e-300_wp/7.0_wp, acos(-1.0_wp)*1.0e200_wp, -0.1_wp/3.0_wp, 0.0_wp, 206.0_wp, &
         -1234567.0_wp/0.7_wp]
      type(writer_type) :: deck
      character(len=:), allocatable :: text
      character(len=200) :: line
      real(wp) :: back
      integer :: i, comma, at, n

      call deck%reals(values)
      text = deck%text()
      n = 0
      line = ''
      at = 1
      do i = 1, size(values)
         comma = scan(text(at:), ','//new_line('a'))
         call assertLessThan(len_trim(adjustl(text(at:at + comma - 2))), 21)
         read (text(at:at + comma - 2), *) back
         ! 20 characters less sign, point and the longest exponent leave 13 figures
         call assertEqual(values(i), back, tolerance=1.0e-12_wp*abs(values(i)))
         if (text(at + comma - 1:at + comma - 1) == new_line('a')) n = n + 1
         at = at + comma
      end do
      call assertEqual(2, n, message='lines')
      call assertEqual(len(text) + 1, at)
   end subroutine test_numbers

   !> Comments are cut at blanks, and lose no word.
   subroutine test_comments()
      type(writer_type) :: deck
      character(len=:), allocatable :: text
      integer :: i, width, words

      call deck%comment(repeat('seven77 ', 40)//repeat('x', 250)//' end')
      text = deck%text()
      width = 0
      words = 0
      do i = 1, len(text)
         width = width + 1
         if (text(i:i) == new_line('a')) width = 0
         call assertLessThan(width, 101)
         if (text(i:min(i + 6, len(text))) == 'seven77') words = words + 1
      end do
      call assertEqual(40, words)
      call assertEqual(250, count([(text(i:i) == 'x', i=1, len(text))]))
      call assertTrue(index(text, ' end'//new_line('a')) > 0)
   end subroutine test_comments

   !> Beside wood that is rigid along the grain and in shear, the cheek cannot move: contact and
   !> half the tenon alone give way. What is left goes with the fourth root of the stiffness: 1e-4
   !> of it.
   subroutine test_rigid_cheek()
      type(wood_properties) :: wood

      wood%young_moduli(1) = 1.0e16_wp
      wood%young_moduli(3) = 300.0_wp
      wood%shear_moduli = 1.0e16_wp
      call assertEqual(0.07_wp + 0.2_wp*52.5_wp/300.0_wp, &
         side_interference(0.2_wp, 0.07_wp, wood, 105.0_wp, 300.0_wp, 300.0_wp), &
         tolerance=5.0e-5_wp)
   end subroutine test_rigid_cheek

   !> A cheek over a mortise much longer than itself is, in its middle, free to move away from the
   !> tenon: pressure remains at the ends only, and the interference for a mean grows in proportion.
   subroutine test_free_cheek()
      type(wood_properties) :: wood
      real(wp) :: once, twice

      once = side_interference(0.2_wp, 0.07_wp, wood, 105.0_wp, 1.0e5_wp, 300.0_wp)
      twice = side_interference(0.2_wp, 0.07_wp, wood, 105.0_wp, 2.0e5_wp, 300.0_wp)
      call assertEqual(2.0_wp, twice/once, tolerance=1.0e-6_wp)
   end subroutine test_free_cheek

   !> The same beam by finite differences: one half on a grid from the middle of the mortise to far
   !> beyond its end, w and theta at its points, solved by elimination.
   subroutine test_cheek_differences()
      integer, parameter :: n = 2000, m = 500
      real(wp), parameter :: a = 150.0_wp, step = a/m, pressure = 0.2_wp, overclosure = 0.0739_wp
      type(wood_properties) :: wood
      real(wp) :: bending, shear, k, springs, deflection(0:n), mean

      wood%young_moduli(3) = 300.0_wp
      bending = wood%young_moduli(1)*97.5_wp**3/12.0_wp
      shear = 5.0_wp/6.0_wp*wood%shear_moduli(1)*97.5_wp
      k = wood%young_moduli(2)/52.5_wp
      springs = 1.0_wp/(overclosure/pressure + 52.5_wp/300.0_wp)
      call solve(deflection)
      ! trapezoidal rule of springs*(1 - w) over the mortise, for an interference of 1
      mean = springs*(1.0_wp - (sum(deflection(1:m - 1)) &
         + 0.5_wp*(deflection(0) + deflection(m)))/m)
      ! the grid is of second order but for the jump at the end of the mortise
      call assertEqual(pressure/mean, &
         side_interference(pressure, overclosure, wood, 105.0_wp, 300.0_wp, 300.0_wp), &
         tolerance=2.0e-3_wp*pressure/mean)

   contains

      !> Minimum of the energy with w and theta linear between points: elements of two nodes, one
      !> Gauss point for shear, so that thin beams do not lock. Two unknowns a point, block by
      !> block.
      subroutine solve(w)
         real(wp), intent(out) :: w(0:n)
         real(wp) :: diagonal(2, 2, 0:n), upper(2, 2, 0:n), right(2, 0:n), local(4, 4), g(4)
         real(wp) :: factor(2, 2), z
         integer :: i

         diagonal = 0.0_wp
         upper = 0.0_wp
         right = 0.0_wp
         do i = 0, n - 1
            ! w' - theta at the middle, of w1, theta1, w2, theta2
            g = [-1.0_wp/step, -0.5_wp, 1.0_wp/step, -0.5_wp]
            local = shear*step*spread(g, 2, 4)*spread(g, 1, 4)
            local(2, [2, 4]) = local(2, [2, 4]) + bending/step*[1.0_wp, -1.0_wp]
            local(4, [2, 4]) = local(4, [2, 4]) + bending/step*[-1.0_wp, 1.0_wp]
            z = 0.5_wp*step*merge(springs, k, i < m)
            local(1, 1) = local(1, 1) + z
            local(3, 3) = local(3, 3) + z
            diagonal(:, :, i) = diagonal(:, :, i) + local(:2, :2)
            upper(:, :, i) = local(:2, 3:)
            diagonal(:, :, i + 1) = diagonal(:, :, i + 1) + local(3:, 3:)
            if (i < m) right(1, i:i + 1) = right(1, i:i + 1) + z
         end do
         ! symmetry: no rotation in the middle
         diagonal(2, 2, 0) = diagonal(2, 2, 0)*1.0e12_wp
         do i = 1, n
            factor = matmul(transpose(upper(:, :, i - 1)), inverse(diagonal(:, :, i - 1)))
            diagonal(:, :, i) = diagonal(:, :, i) - matmul(factor, upper(:, :, i - 1))
            right(:, i) = right(:, i) - matmul(factor, right(:, i - 1))
         end do
         right(:, n) = matmul(inverse(diagonal(:, :, n)), right(:, n))
         do i = n - 1, 0, -1
            right(:, i) = matmul(inverse(diagonal(:, :, i)), &
               right(:, i) - matmul(upper(:, :, i), right(:, i + 1)))
         end do
         w = right(1, :)
      end subroutine solve

      pure function inverse(b) result(c)
         real(wp), intent(in) :: b(2, 2)
         real(wp) :: c(2, 2)

         c = reshape([b(2, 2), -b(2, 1), -b(1, 2), b(1, 1)], [2, 2]) &
            /(b(1, 1)*b(2, 2) - b(1, 2)*b(2, 1))
      end function inverse

   end subroutine test_cheek_differences

   !> Discs overlap by what makes the law carry the normal stress; hard contact by its penalty.
   subroutine test_discs()
      type(shear_deck) :: deck
      type(shear_settings) :: settings
      type(wood_properties) :: wood
      type(deck_choice) :: choice
      type(contact_properties) :: pair
      type(normal_response) :: response
      type(error_type), allocatable :: error

      pair = pair_properties()
      settings%displacement = [1.0_wp]
      choice%mesh_size = 10.0_wp
      choice%command = ''
      call new_shear_deck(deck, choice, settings, 10.0_wp, .true., wood, pair, error)
      call assertFalse(allocated(error))
      response = evaluate_normal_law(pair%normal, pair%initial_separation - deck%overclosure)
      call assertEqual(settings%normal_stress, response%pressure, tolerance=1.0e-12_wp)
      call assertEqual(-deck%overclosure, minval(deck%upper%nodes(3, :)), tolerance=1.0e-15_wp)
      choice%contact = 'hard'
      call new_shear_deck(deck, choice, settings, 10.0_wp, .true., wood, pair, error)
      call assertEqual(0.05_wp/100.0_wp, deck%overclosure, tolerance=1.0e-15_wp)
   end subroutine test_discs

   !> The gap of the meshes is the clearance less d0 between mean planes, else the clearance.
   subroutine test_gaps()
      type(tenon_deck) :: deck
      type(tenon_settings) :: s
      type(deck_choice) :: choice
      type(error_type), allocatable :: error

      choice = joint_choice()
      s%wood%criterion = 'none'
      s%clearance_below = 0.1_wp
      call make(deck, choice, s, error)
      call assertFalse(allocated(error))
      call assertEqual(0.5_wp - 4.0_wp*0.0593_wp, deck%sizes%gap_above, tolerance=1.0e-15_wp)
      call assertEqual(0.1_wp - 4.0_wp*0.0593_wp, deck%sizes%gap_below, tolerance=1.0e-15_wp)
      ! the rest of the interference is made by swelling
      call assertEqual(deck%sizes%side_interference, &
         deck%sizes%side_overlap + 52.5_wp*deck%swelling, tolerance=1.0e-14_wp)
      call assertTrue(deck%has_sides .and. deck%swelling > 0.0_wp)
      call assertEqual([1, 1], [times('*TEMPERATURE'), times('*EXPANSION')], 'swells in one step')
      s%gap = 'first_touch'
      call make(deck, choice, s, error)
      call assertEqual(0.1_wp, deck%sizes%gap_below, tolerance=1.0e-15_wp)
      s%gap = 'mean_plane'
      choice%contact = 'hard'
      call make(deck, choice, s, error)
      call assertEqual(0.1_wp, deck%sizes%gap_below, tolerance=1.0e-15_wp)
      call assertEqual(s%side_pressure/100.0_wp, deck%sizes%side_overlap, tolerance=1.0e-15_wp)
      s%side_pressure = 0.0_wp
      call make(deck, choice, s, error)
      call assertFalse(deck%has_sides)
      call assertEqual(0.0_wp, deck%swelling)
      call assertEqual([0, 0], [times('*TEMPERATURE'), times('*EXPANSION')], 'does not swell')
   contains
      !> How often a word is in the deck's text.
      integer function times(word)
         character(len=*), intent(in) :: word
         character(len=:), allocatable :: text
         integer :: at

         call write_tenon_deck(deck, text, error)
         call assertFalse(allocated(error), 'written')
         times = 0
         at = index(text, word)
         do while (at > 0)
            times = times + 1
            text = text(at + len(word):)
            at = index(text, word)
         end do
      end function times
   end subroutine test_gaps

   !> Strokes lie between the turns of the programme, or of a recorded history.
   subroutine test_strokes()
      type(tenon_deck) :: deck
      type(tenon_settings) :: s
      type(error_type), allocatable :: error

      s%amplitudes = [1.0_wp, 4.0_wp]
      s%cycles = [1, 2]
      call make(deck, joint_choice(), s, error)
      call assertEqual([0.0_wp, 1.0_wp, -1.0_wp, 4.0_wp, -4.0_wp, 4.0_wp, -4.0_wp, 0.0_wp], &
         deck%turns, tolerance=1.0e-15_wp)
      s%displacement = [0.0_wp, 0.5_wp, 2.0_wp, 2.0_wp, 1.0_wp, -3.0_wp, -3.0_wp, 0.0_wp, 0.2_wp]
      call make(deck, joint_choice(), s, error)
      call assertEqual([0.0_wp, 2.0_wp, -3.0_wp, 0.2_wp], deck%turns, tolerance=1.0e-15_wp)
   end subroutine test_strokes

   subroutine test_refused()
      type(tenon_settings) :: plain, s
      type(deck_choice) :: choice

      choice = joint_choice()
      s = plain
      s%axial_rule = 'free'
      call refused('axial_rule = free leaves the beam without axial hold')
      s%axial_rule = 'force'
      call refused('axial_rule = force leaves the beam without axial hold')
      s = plain
      s%shoulders = .true.
      call refused('shoulders = true is not in the deck')
      s = plain
      s%column = 'rigid'
      call refused('column = rigid is not in the deck')
      s = plain
      s%accept_sizes = .true.
      s%wood%young_moduli(1) = 30.0_wp
      call refused('poisson_ratio_lr = 0.62 is not allowed')
      s = plain
      s%wood%shear_moduli(3) = 0.06716_wp
      call refused('shear_modulus_rt = 0.06716 MPa is outside 4.0 to 3900.0 MPa: 0.06716 looks '// &
         'like GPa, write 67.16')
      s = plain
      s%accept_sizes = .true.
      s%side_pressure = 12.2_wp
      call refused('side_pressure = 12.2 MPa is above the hardness, 12.14 MPa')
      s = plain
      choice%mesh_size = -1.0_wp
      call refused('mesh_size = -1.0')
      choice%mesh_size = 0.03_wp
      call refused('mesh_size = 0.03 mm is outside 0.5 to 490.0 mm: 0.03 looks like metres, '// &
         'write 30.0')
      choice = joint_choice()
      choice%contact = 'table'
      choice%largest_pressure = 13.0_wp
      call refused('largest_pressure = 13.0 MPa is above the hardness, 12.14 MPa')
      choice = joint_choice()
      choice%contact = 'table'
      choice%rows = 20
      call refused('rows = 20 is too few')
      choice%rows = 1000
      choice%tolerance = 1.0e-4_wp
      call refused('rows = 1000 lets the table have')

   contains

      subroutine refused(start)
         character(len=*), intent(in) :: start
         type(tenon_deck) :: deck
         type(error_type), allocatable :: error

         call make(deck, choice, s, error)
         call assertTrue(allocated(error), message=start)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, start), message=error%message)
         call assertTrue(fits_subject(error), message=error%message)
      end subroutine refused

   end subroutine test_refused

   !> A coarse joint.
   function joint_choice() result(choice)
      type(deck_choice) :: choice

      choice%mesh_size = 75.0_wp
      choice%command = ''
   end function joint_choice

   subroutine make(deck, choice, settings, error)
      type(tenon_deck), intent(out) :: deck
      type(deck_choice), intent(in) :: choice
      type(tenon_settings), intent(in) :: settings
      type(error_type), allocatable, intent(out) :: error

      call new_tenon_deck(deck, choice, settings, default_tenon_sizes(settings), 10, &
         pair_properties(), pair_properties(pair='tangential-tangential'), error)
   end subroutine make

end module test_deck_models
