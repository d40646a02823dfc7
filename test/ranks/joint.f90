!> A joint shared by ranks: all of it is someone's, once, and what is gathered is whole.
module test_ranks_joint
   use asperity, only: contact_properties, error_type, wp
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_tenon_sizes
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_solid_contact_history, only: history_size, pack_facets, pack_history, unpack_history
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: new_solid_model, solid_model
   use asperity_solid_model_settings, only: solid_settings
   use asperity_solid_model_share, only: share_work
   use asperity_solid_solve_gather, only: gather_met_facets, gather_model
   use contact_cases, only: pair_properties
   use test_ranks_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_joint

contains

   function suite_joint() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('joint')
      call suite%addTest(TestMethod('everything is someone''s, once', test_shares))
      call suite%addTest(TestMethod('borders do not run through contact', test_borders))
      call suite%addTest(TestMethod('more ranks than elements are refused', test_too_many))
      call suite%addTest(TestMethod('what is gathered is whole', test_gather))
   end function suite_joint

   subroutine new_joint(model)
      type(solid_model), intent(out) :: model
      type(tenon_deck) :: deck
      type(deck_choice) :: choice
      type(tenon_settings) :: joint
      type(contact_properties) :: faces, sides
      type(solid_settings) :: settings
      type(error_type), allocatable :: error

      choice%command = ''
      choice%mesh_size = 60.0_wp
      faces = pair_properties()
      sides = pair_properties(pair='tangential-tangential')
      call new_tenon_deck(deck, choice, joint, default_tenon_sizes(joint), 10, faces, sides, error)
      if (.not. allocated(error)) call new_solid_model(model, deck, settings, error)
      call assertFalse(allocated(error), 'joint')
      call share_work(model, petsc%ranks, error)
      call assertFalse(allocated(error), 'shared')
   end subroutine new_joint

   subroutine test_shares()
      type(solid_model) :: model
      real(wp), allocatable :: count(:)
      integer :: i

      call new_joint(model)
      allocate (count(size(model%mesh%elements, 2)), source=0.0_wp)
      count(model%own_elements) = 1.0_wp
      call assertTrue(size(model%own_elements) > 0, 'this rank has some')
      call petsc%ranks%sum(count)
      call assertTrue(all(nint(count) == 1), 'elements')
      do i = 1, size(model%pairs)
         deallocate (count)
         allocate (count(size(model%pairs(i)%faces)), source=0.0_wp)
         count(model%pairs(i)%own) = 1.0_wp
         call petsc%ranks%sum(count)
         call assertTrue(all(nint(count) == 1), 'faces')
      end do
      ! numbers are a permutation: each is there as often as it was
      call assertEqual(0, model%first_rows(0), 'first row')
      call assertEqual(model%n_unknowns, model%first_rows(petsc%ranks%size), 'rows')
      do i = 1, model%n_unknowns
         if (.not. any(model%numbers == i)) exit
      end do
      call assertEqual(model%n_unknowns + 1, i, 'numbers')
      call assertEqual(1, minval(pack(model%numbers, model%numbers > 0)), 'least number')
      deallocate (count)
      allocate (count, source=real(reshape(model%numbers, [size(model%numbers)]), wp))
      call petsc%ranks%take_first(count)
      call assertTrue(all(nint(count) == reshape(model%numbers, [size(model%numbers)])), 'alike')
   end subroutine test_shares

   !> On two ranks the elements on both sides of nine in ten slave faces are of the rank that has
   !> the face; on more, whose borders must cross these few faces somewhere, those on one side.
   subroutine test_borders()
      type(solid_model) :: model
      real(wp) :: counts(2)
      logical :: sides(2)
      integer :: i, j

      call new_joint(model)
      counts = 0.0_wp
      do i = 1, size(model%pairs)
         associate (pair => model%pairs(i))
            counts(1) = counts(1) + size(pair%own)
            do j = 1, size(pair%own)
               associate (nodes => pair%faces(pair%own(j))%nodes(:4))
                  sides = [is_own(model, nodes), &
                     is_own(model, opposite(model, pair%master%facets, nodes))]
                  if (all(sides) .or. (any(sides) .and. petsc%ranks%size > 2)) &
                     counts(2) = counts(2) + 1.0_wp
               end associate
            end do
         end associate
      end do
      call petsc%ranks%sum(counts)
      call assertEqual(sum([(size(model%pairs(i)%faces), i=1, size(model%pairs))]), nint(counts(1)))
      call assertTrue(counts(2) >= 0.9_wp*counts(1), 'sides on its rank')
   end subroutine test_borders

   !> Whether one of this rank's elements has four corners.
   pure logical function is_own(model, nodes)
      type(solid_model), intent(in) :: model
      integer, intent(in) :: nodes(4)
      integer :: i, k

      is_own = .true.
      do i = 1, size(model%own_elements)
         if (all([(any(model%mesh%elements(:, model%own_elements(i)) == nodes(k)), k=1, 4)])) return
      end do
      is_own = .false.
   end function is_own

   !> The facet whose middle is nearest to that of four corners.
   pure function opposite(model, facets, nodes)
      type(solid_model), intent(in) :: model
      integer, intent(in) :: facets(:, :), nodes(4)
      integer :: opposite(4)
      real(wp) :: away, least
      integer :: i

      least = huge(1.0_wp)
      opposite = 0
      do i = 1, size(facets, 2)
         away = norm2(sum(model%mesh%nodes(:, facets(:, i)), 2) &
            - sum(model%mesh%nodes(:, nodes), 2))
         if (away >= least) cycle
         least = away
         opposite = facets(:, i)
      end do
   end function opposite

   subroutine test_too_many()
      type(solid_model) :: model
      type(rank_team) :: crowd
      type(error_type), allocatable :: error

      call new_joint(model)
      crowd = petsc%ranks
      crowd%size = size(model%mesh%elements, 2) + 1
      call share_work(model, crowd, error)
      call assertTrue(allocated(error), 'refused')
      if (allocated(error)) call assertEqual('379 ranks are more than the 378 elements of the '// &
         'mesh: start at most 378, or take a smaller mesh_size', error%message)
   end subroutine test_too_many

   !> Every rank writes numbers of its own points and cells, which tell where they are.
   subroutine test_gather()
      type(solid_model) :: model
      real(wp), allocatable :: numbers(:)
      integer :: i, j, k

      call new_joint(model)
      associate (own => model%own_elements)
         do i = 1, size(own)
            do j = 1, 6
               model%points(:, own(i))%stress(j) = 10.0_wp*own(i) + j
               model%points(:, own(i))%plastic_strain(j) = -10.0_wp*own(i) - j
            end do
            model%points(:, own(i))%equivalent_strain = 0.5_wp*own(i)
         end do
      end associate
      do i = 1, size(model%pairs)
         associate (pair => model%pairs(i))
            pair%energy%dissipation = 1.0_wp
            do j = 1, size(pair%own)
               do k = 1, size(pair%faces(pair%own(j))%cells)
                  associate (cell => pair%faces(pair%own(j))%cells(k))
                     cell%start%pressure = 100.0_wp*pair%own(j) + k
                     cell%trial%traction(1) = 3.0_wp*pair%own(j)
                     cell%coverage = 0.25_wp
                  end associate
               end do
            end do
         end associate
      end do
      call gather_model(model, petsc%ranks)
      do i = 1, size(model%points, 2)
         do j = 1, 6
            call assertEqual(10.0_wp*i + j, maxval(model%points(:, i)%stress(j)), &
               tolerance=0.0_wp, message='stress')
            call assertEqual(-10.0_wp*i - j, maxval(model%points(:, i)%plastic_strain(j)), &
               tolerance=0.0_wp, message='plastic strain')
         end do
         call assertEqual(0.5_wp*i, minval(model%points(:, i)%equivalent_strain), &
            tolerance=0.0_wp, message='equivalent strain')
      end do
      do i = 1, size(model%pairs)
         associate (pair => model%pairs(i))
            do j = 1, size(pair%faces)
               do k = 1, size(pair%faces(j)%cells)
                  associate (cell => pair%faces(j)%cells(k))
                     call assertEqual(100.0_wp*j + k, cell%start%pressure, tolerance=0.0_wp, &
                        message='pressure')
                     call assertEqual(3.0_wp*j, cell%trial%traction(1), tolerance=0.0_wp, &
                        message='traction')
                     call assertEqual(0.25_wp, cell%coverage, tolerance=0.0_wp, &
                        message='coverage')
                  end associate
               end do
            end do
            ! summed over the ranks it is what it was
            call assertEqual(merge(real(petsc%ranks%size, wp), 0.0_wp, petsc%ranks%rank == 0), &
               pair%energy%dissipation, tolerance=0.0_wp, message='energy')
            allocate (numbers, source=pack_history(pair))
            call assertEqual(history_size(pair), size(numbers))
            call unpack_history(pair, numbers)
            deallocate (numbers)
            call gather_met_facets(model, petsc%ranks)
            call assertEqual(size(pair%faces), size(pack_facets(pair)), 'no facet is met')
         end associate
      end do
   end subroutine test_gather

end module test_ranks_joint
