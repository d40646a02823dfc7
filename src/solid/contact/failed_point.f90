!> The contact point at which an increment of the solid joint failed, and how it has moved.
module asperity_solid_contact_failed_point
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, status_unset
   use asperity_replay_motion_path, only: motion_path
   use asperity_solid_contact_cell, only: contact_cell, motion_of
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_pair, only: contact_pair
   use asperity_solid_contact_rough, only: rough_law
   use asperity_solid_engine_ranks, only: rank_team
   implicit none
   private
   public :: failed_point, keep_motions, find_failed_point

   !> The point.
   type :: failed_point
      !> Its pair, face of the pair and cell of the face; zero where no increment failed at a point
      !> whose motion was kept
      integer :: pair = 0, face = 0, cell = 0
      !> Whether motions were kept from the start
      logical :: is_known = .false.
      !> Where it is
      character(len=80) :: words = ''
      !> Its motion from the start to what was tried last, an increment a second
      type(motion_path) :: path
      !> Its properties
      type(contact_properties) :: properties
   end type failed_point

contains

   !> Keep the motions of pairs from now on, where their law is one that UINTER knows.
   subroutine keep_motions(pairs)
      !> The pairs, at their beginning
      type(contact_pair), intent(inout) :: pairs(:)
      integer :: i

      do i = 1, size(pairs)
         select type (law => pairs(i)%law)
         class is (rough_law)
            allocate (pairs(i)%motions)
         class default
            continue
         end select
      end do
   end subroutine keep_motions

   !> The point that the law refused, else that whose force changed most: an increment that fails is
   !> next to nothing long, and began in balance. All ranks find the same.
   subroutine find_failed_point(pairs, failed, ranks)
      !> The pairs, after an increment that failed
      type(contact_pair), intent(inout) :: pairs(:)
      !> The point
      type(failed_point), intent(out) :: failed
      !> The ranks, each with its faces
      type(rank_team), intent(in) :: ranks
      real(wp) :: change, largest, place(3), greatest(1)
      logical :: is_refused, is_own
      integer :: i, j, k, n

      failed%is_known = .not. ranks%any(any([(.not. allocated(pairs(i)%motions), &
         i=1, size(pairs))]))
      if (.not. failed%is_known) return
      if (.not. any([(pairs(i)%motions%is_under_way, i=1, size(pairs))])) return
      largest = 0.0_wp
      search: do i = 1, size(pairs)
         do n = 1, size(pairs(i)%own)
            j = pairs(i)%own(n)
            do k = 1, size(pairs(i)%faces(j)%cells)
               associate (cell => pairs(i)%faces(j)%cells(k))
                  ! what is no number cannot be replayed
                  if (.not. all(abs(motion_of(cell)) <= huge(1.0_wp))) cycle
                  ! a law that refuses a point gives it no state
                  is_refused = cell%trial%state%status == status_unset
                  if (.not. is_refused) then
                     change = change_of(pairs(i)%law, cell)
                     if (.not. change > largest) cycle
                     largest = change
                  end if
                  failed%pair = i
                  failed%face = j
                  failed%cell = k
                  if (.not. is_refused) cycle
                  largest = huge(1.0_wp)
                  exit search
               end associate
            end do
         end do
      end do search
      ! of several ranks with as much the last
      greatest = largest
      call ranks%maximum(greatest)
      is_own = failed%pair > 0 .and. .not. largest < greatest(1)
      greatest = merge(real(ranks%rank, wp), -1.0_wp, is_own)
      call ranks%maximum(greatest)
      is_own = is_own .and. nint(greatest(1)) == ranks%rank
      place = 0.0_wp
      if (is_own) place = real([failed%pair, failed%face, failed%cell], wp)
      call ranks%sum(place)
      failed%pair = nint(place(1))
      failed%face = nint(place(2))
      failed%cell = nint(place(3))
      if (failed%pair > 0) call follow(pairs(failed%pair), failed, is_own, ranks)
   end subroutine find_failed_point

   !> By how much the force of a cell changes in an increment, N.
   real(wp) function change_of(law, cell)
      class(solid_law), intent(inout) :: law
      type(contact_cell), intent(in) :: cell
      type(contact_response) :: start
      type(error_type), allocatable :: error

      call law%update(cell%start, cell%start%overclosure, [0.0_wp, 0.0_wp], start, error)
      change_of = cell%area*norm2(cell%coverage*cell%trial%traction &
         - cell%start_coverage*start%traction)
   end function change_of

   !> Motion and properties of the point, which one rank has followed.
   subroutine follow(pair, failed, is_own, ranks)
      type(contact_pair), intent(in) :: pair
      type(failed_point), intent(inout) :: failed
      logical, intent(in) :: is_own
      type(rank_team), intent(in) :: ranks
      real(wp), allocatable :: values(:, :)
      integer :: i, n

      n = pair%motions%increments
      allocate (values(3, n + 1), source=0.0_wp)
      associate (face => failed%face, cell => failed%cell, &
            x => pair%faces(failed%face)%cells(failed%cell)%position)
         failed%words = 'the point of the '//trim(pair%name)//' faces at x, y, z = '// &
            to_text(x(1), 5)//', '//to_text(x(2), 5)//', '//to_text(x(3), 5)//' mm'
         if (is_own) then
            do i = 1, n
               values(:, i) = pair%motions%at(i)%values(:, cell, face)
            end do
            values(:, n + 1) = motion_of(pair%faces(face)%cells(cell))
            if (n > 0) values(2:, n + 1) = values(2:, n + 1) + values(2:, n)
         end if
         call ranks%sum(values)
      end associate
      failed%path%time = real([(i, i=1, n + 1)], wp)
      failed%path%overclosure = values(1, :)
      failed%path%slip = values(2:, :)
      allocate (failed%path%expected(3, n + 1), source=0.0_wp)
      select type (law => pair%law)
      class is (rough_law)
         failed%properties = law%properties
      class default
         continue
      end select
   end subroutine follow

end module asperity_solid_contact_failed_point
