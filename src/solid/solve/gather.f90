!> What the ranks know of their elements and faces, brought together: after it every rank has all of
!> the joint, for files and pictures.
module asperity_solid_solve_gather
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_energy, only: contact_energy
   use asperity_solid_contact_history, only: history_size, pack_facets, pack_history, &
      unpack_facets, unpack_history
   use asperity_solid_contact_pair, only: contact_pair
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: solid_model
   implicit none
   private
   public :: gather_model, gather_met_facets, leave_to_first

   !> How many numbers of a cell's trial are shown
   integer, parameter :: of_trial = 6

contains

   !> Bring the points of all elements and the contact of all faces to every rank. It is a sum of
   !> what is zero but on one rank.
   subroutine gather_model(model, ranks)
      !> The joint, after an increment was accepted
      type(solid_model), intent(inout) :: model
      !> The ranks
      type(rank_team), intent(in) :: ranks
      integer :: i

      if (ranks%size == 1) return
      call gather_points(model, ranks)
      do i = 1, size(model%pairs)
         call gather_history(model%pairs(i), ranks)
         call gather_trials(model%pairs(i), ranks)
      end do
      call leave_to_first(model, ranks)
   end subroutine gather_model

   !> Bring the master facets that faces have met to every rank, between two strokes: those that
   !> were not met are forgotten, and the pattern is.
   subroutine gather_met_facets(model, ranks)
      !> The joint
      type(solid_model), intent(inout) :: model
      !> The ranks
      type(rank_team), intent(in) :: ranks
      integer :: i

      if (ranks%size == 1) return
      do i = 1, size(model%pairs)
         call gather_facets(model%pairs(i), ranks)
      end do
   end subroutine gather_met_facets

   !> Energies that all ranks know whole are the first one's alone: they will be summed.
   subroutine leave_to_first(model, ranks)
      !> The joint
      type(solid_model), intent(inout) :: model
      !> The ranks
      type(rank_team), intent(in) :: ranks
      integer :: i

      if (ranks%rank == 0) return
      do i = 1, size(model%pairs)
         model%pairs(i)%energy = contact_energy()
      end do
   end subroutine leave_to_first

   !> Points, one of their numbers after the other.
   subroutine gather_points(model, ranks)
      type(solid_model), intent(inout) :: model
      type(rank_team), intent(in) :: ranks
      integer :: k

      do k = 1, 6
         model%points%plastic_strain(k) = gathered(model%points%plastic_strain(k))
         model%points%stress(k) = gathered(model%points%stress(k))
      end do
      model%points%equivalent_strain = gathered(model%points%equivalent_strain)

   contains

      function gathered(own) result(values)
         real(wp), intent(in) :: own(:, :)
         real(wp), allocatable :: values(:, :)

         allocate (values(size(own, 1), size(own, 2)), source=0.0_wp)
         values(:, model%own_elements) = own(:, model%own_elements)
         call ranks%sum(values)
      end function gathered

   end subroutine gather_points

   !> What the cells remember, and the energies of the pair.
   subroutine gather_history(pair, ranks)
      type(contact_pair), intent(inout) :: pair
      type(rank_team), intent(in) :: ranks
      real(wp) :: numbers(history_size(pair))
      integer :: i, first, n

      numbers = pack_history(pair)
      n = 0
      do i = 1, size(pair%faces)
         n = n + size(pair%faces(i)%cells)
      end do
      if (n == 0) return
      ! the same of every cell, after those of the pair
      n = history_size(pair)/n
      first = modulo(history_size(pair), n)
      do i = 1, size(pair%faces)
         associate (next => first + n*size(pair%faces(i)%cells))
            if (.not. any(pair%own == i)) numbers(first + 1:next) = 0.0_wp
            first = next
         end associate
      end do
      call ranks%sum(numbers)
      call unpack_history(pair, numbers)
   end subroutine gather_history

   !> What is shown of the cells' last trials.
   subroutine gather_trials(pair, ranks)
      type(contact_pair), intent(inout) :: pair
      type(rank_team), intent(in) :: ranks
      real(wp), allocatable :: values(:, :)
      integer :: i, j, k, n

      n = 0
      do i = 1, size(pair%faces)
         n = n + size(pair%faces(i)%cells)
      end do
      allocate (values(of_trial, n), source=0.0_wp)
      do k = 1, 2
         n = 0
         do i = 1, size(pair%faces)
            do j = 1, size(pair%faces(i)%cells)
               n = n + 1
               associate (cell => pair%faces(i)%cells(j))
                  if (k == 1) then
                     if (any(pair%own == i)) values(:, n) = [cell%coverage, cell%gap, &
                        cell%trial%traction, real(cell%trial%status, wp)]
                  else
                     cell%coverage = values(1, n)
                     cell%gap = values(2, n)
                     cell%trial%traction = values(3:5, n)
                     cell%trial%status = nint(values(6, n))
                  end if
               end associate
            end do
         end do
         if (k == 1) call ranks%sum(values)
      end do
   end subroutine gather_trials

   !> Master facets that the faces have met.
   subroutine gather_facets(pair, ranks)
      type(contact_pair), intent(inout) :: pair
      type(rank_team), intent(in) :: ranks
      integer, allocatable :: list(:)
      real(wp) :: counts(size(pair%faces))
      real(wp), allocatable :: all(:)
      integer :: i, n, place

      allocate (list, source=pack_facets(pair))
      counts = 0.0_wp
      n = 1
      do i = 1, size(counts)
         if (any(pair%own == i)) counts(i) = list(n)
         n = n + 1 + list(n)
      end do
      call ranks%sum(counts)
      allocate (all(size(counts) + nint(sum(counts))), source=0.0_wp)
      n = 1
      place = 1
      do i = 1, size(counts)
         if (any(pair%own == i)) all(place:place + list(n)) = list(n:n + list(n))
         n = n + 1 + list(n)
         place = place + 1 + nint(counts(i))
      end do
      call ranks%sum(all)
      call unpack_facets(pair, nint(all))
   end subroutine gather_facets

end module asperity_solid_solve_gather
