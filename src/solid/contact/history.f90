!> What a contact pair must remember from one increment to the next, as numbers, for a checkpoint:
!> a pair that is built anew and given them goes on bit for bit as one that has forgotten its
!> pattern at the same time.
module asperity_solid_contact_history
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: contact_state
   use asperity_solid_contact_cell, only: contact_cell
   use asperity_solid_contact_energy, only: contact_energy
   use asperity_solid_contact_face, only: keep_facets, met_facets
   use asperity_solid_contact_pair, only: contact_pair
   implicit none
   private
   public :: history_size, pack_history, unpack_history, pack_facets, unpack_facets

   !> Numbers of a cell, and of a pair
   integer, parameter :: of_cell = 51, of_pair = 6

contains

   !> How many numbers there are.
   pure integer function history_size(pair)
      !> The pair
      type(contact_pair), intent(in) :: pair
      integer :: i

      history_size = of_pair
      do i = 1, size(pair%faces)
         history_size = history_size + of_cell*size(pair%faces(i)%cells)
      end do
   end function history_size

   !> The numbers, after an increment was accepted.
   pure function pack_history(pair) result(numbers)
      !> The pair
      type(contact_pair), intent(in) :: pair
      real(wp) :: numbers(history_size(pair))
      integer :: i, j, n

      associate (e => pair%energy)
         numbers(:of_pair) = [e%normal, e%tangential, e%dissipation, e%coupling, e%edge, &
            e%plastic]
      end associate
      n = of_pair
      do i = 1, size(pair%faces)
         do j = 1, size(pair%faces(i)%cells)
            numbers(n + 1:n + of_cell) = cell_numbers(pair%faces(i)%cells(j))
            n = n + of_cell
         end do
      end do
   end function pack_history

   !> Go on from numbers of `pack_history`.
   pure subroutine unpack_history(pair, numbers)
      !> A pair of the same surfaces and cells
      type(contact_pair), intent(inout) :: pair
      !> The numbers, `history_size` of them
      real(wp), intent(in) :: numbers(:)
      integer :: i, j, n

      pair%energy = contact_energy(numbers(1), numbers(2), numbers(3), numbers(4), numbers(5), &
         numbers(6))
      n = of_pair
      do i = 1, size(pair%faces)
         do j = 1, size(pair%faces(i)%cells)
            call set_cell(pair%faces(i)%cells(j), numbers(n + 1:n + of_cell))
            n = n + of_cell
         end do
      end do
   end subroutine unpack_history

   !> Master facets that each face has met since some were forgotten: how many, and which.
   pure function pack_facets(pair) result(list)
      !> The pair
      type(contact_pair), intent(in) :: pair
      integer, allocatable :: list(:)
      integer :: i

      allocate (list(0))
      do i = 1, size(pair%faces)
         associate (met => met_facets(pair%faces(i)))
            list = [list, size(met), met]
         end associate
      end do
   end function pack_facets

   !> Keep the facets of a list of `pack_facets` and forget all others.
   pure subroutine unpack_facets(pair, list)
      !> A pair of the same surfaces
      type(contact_pair), intent(inout) :: pair
      !> The list
      integer, intent(in) :: list(:)
      integer :: i, n

      n = 1
      do i = 1, size(pair%faces)
         call keep_facets(pair%faces(i), pair%master, list(n + 1:n + list(n)))
         n = n + 1 + list(n)
      end do
      pair%has_grown = .true.
   end subroutine unpack_facets

   pure function cell_numbers(cell) result(numbers)
      type(contact_cell), intent(in) :: cell
      real(wp) :: numbers(of_cell)

      associate (s => cell%start, middle => cell%middle)
         numbers = [real(s%status, wp), s%overclosure, s%pressure, s%normal_energy, &
            s%elastic_slip, s%largest_closure, s%dissipation, s%pressure_coupling, &
            real(s%validity, wp), cell%start_tangential_energy, cell%last_coverage, cell%slip, &
            real(middle%start_facet, wp), middle%start_natural, s%motion_share, s%grain_turn, &
            s%summit_slip]
      end associate
   end function cell_numbers

   pure subroutine set_cell(cell, numbers)
      type(contact_cell), intent(inout) :: cell
      real(wp), intent(in) :: numbers(of_cell)

      associate (n => numbers)
         cell%start = contact_state(nint(n(1)), n(2), n(3), n(4), n(5:6), n(7), n(8), n(9), &
            nint(n(10)), n(18), n(19), reshape(n(20:), shape(cell%start%summit_slip)))
         cell%start_tangential_energy = n(11)
         cell%last_coverage = n(12)
         cell%slip = n(13:14)
         cell%middle%start_facet = nint(n(15))
         cell%middle%start_natural = n(16:17)
      end associate
   end subroutine set_cell

end module asperity_solid_contact_history
