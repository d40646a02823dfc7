!> Contenders that evaluate the law itself, and the loop that only reads and writes.
module bench_law
   use asperity, only: compiled_law, evaluate_compiled_law, evaluate_normal_law, &
      normal_properties, normal_response, wp
   use bench_timing, only: contender
   use random_inputs, only: random_stream
   implicit none
   private
   public :: point_arrays, array_contender, direct_law, scalar_law, batch_law, read_write_loop, &
      new_point_arrays, free_point_arrays

   !> Separations in random order, and room for what follows from them.
   type :: point_arrays
      !> d, mm; p, MPa; -dp/dd, MPa/mm
      real(wp), pointer, contiguous :: separation(:) => null(), pressure(:) => null(), &
         stiffness(:) => null()
   end type point_arrays

   !> A contender over such arrays.
   type, abstract, extends(contender) :: array_contender
      type(point_arrays) :: on
      !> It computes the law of these properties, so that its error can be told
      type(normal_properties) :: properties
      !> Largest error that is sane; without limit for what is known to be coarse
      real(wp) :: error_limit = huge(1.0_wp)
      !> Whether its error is of interest
      logical :: has_error = .false.
   end type array_contender

   !> Direct evaluation, the full response, a point a call.
   type, extends(array_contender) :: direct_law
      !> Sets of properties, and which of them each point has
      type(normal_properties), allocatable :: sets(:)
      integer, allocatable :: which(:)
   contains
      procedure :: pass => pass_direct
   end type direct_law

   !> Compiled law, a point a call.
   type, extends(array_contender) :: scalar_law
      type(compiled_law) :: law
   contains
      procedure :: pass => pass_scalar
   end type scalar_law

   !> Compiled law, all points in one call, or in slices that threads share.
   type, extends(array_contender) :: batch_law
      type(compiled_law) :: law
      !> Threads; zero is one call without OpenMP
      integer :: threads = 0
   contains
      procedure :: pass => pass_batch
   end type batch_law

   !> Reads one and writes two doubles a point: what the memory allows.
   type, extends(array_contender) :: read_write_loop
      !> Threads; zero is one call without OpenMP
      integer :: threads = 0
   contains
      procedure :: pass => pass_loop
   end type read_write_loop

   !> Points that a thread takes at a time
   integer, parameter :: slice = 4096

contains

   !> Separations uniform in h = d/sigma between the limits, in random order.
   subroutine new_point_arrays(on, points, sigma, h_min, h_max)
      type(point_arrays), intent(out) :: on
      integer, intent(in) :: points
      real(wp), intent(in) :: sigma, h_min, h_max
      type(random_stream) :: stream
      integer :: i

      allocate (on%separation(points), on%pressure(points), on%stiffness(points))
      stream%state = 20211123
      do i = 1, points
         on%separation(i) = sigma*stream%uniform(h_min, h_max)
      end do
      ! the first touch of a page is not what is measured
      on%pressure = 0.0_wp
      on%stiffness = 0.0_wp
   end subroutine new_point_arrays

   !> Give the memory back.
   subroutine free_point_arrays(on)
      type(point_arrays), intent(inout) :: on

      deallocate (on%separation, on%pressure, on%stiffness)
   end subroutine free_point_arrays

   subroutine pass_direct(this)
      class(direct_law), intent(inout) :: this
      type(normal_response) :: response
      integer :: i

      do i = 1, this%points
         response = evaluate_normal_law(this%sets(this%which(i)), this%on%separation(i))
         this%on%pressure(i) = response%pressure
         this%on%stiffness(i) = response%stiffness
         this%checksum = this%checksum + response%energy
      end do
   end subroutine pass_direct

   subroutine pass_scalar(this)
      class(scalar_law), intent(inout) :: this
      integer :: i

      associate (on => this%on)
         do i = 1, this%points
            call evaluate_compiled_law(this%law, on%separation(i), on%pressure(i), on%stiffness(i))
         end do
      end associate
      call consume(this)
   end subroutine pass_scalar

   subroutine pass_batch(this)
      class(batch_law), intent(inout) :: this
      integer :: first, last

      associate (on => this%on)
         if (this%threads == 0) then
            call evaluate_compiled_law(this%law, on%separation, on%pressure, on%stiffness)
         else
            !$omp parallel do private(last) num_threads(this%threads) schedule(static)
            do first = 1, this%points, slice
               last = min(first + slice - 1, this%points)
               call evaluate_compiled_law(this%law, on%separation(first:last), &
                  on%pressure(first:last), on%stiffness(first:last))
            end do
            !$omp end parallel do
         end if
      end associate
      call consume(this)
   end subroutine pass_batch

   subroutine pass_loop(this)
      class(read_write_loop), intent(inout) :: this
      integer :: first, last

      associate (on => this%on)
         if (this%threads == 0) then
            call read_one_write_two(on%separation, on%pressure, on%stiffness)
         else
            !$omp parallel do private(last) num_threads(this%threads) schedule(static)
            do first = 1, this%points, slice
               last = min(first + slice - 1, this%points)
               call read_one_write_two(on%separation(first:last), on%pressure(first:last), &
                  on%stiffness(first:last))
            end do
            !$omp end parallel do
         end if
      end associate
      call consume(this)
   end subroutine pass_loop

   !> The least that a batch can do; with OpenMP's leave to use vector instructions.
   subroutine read_one_write_two(x, y, z)
      real(wp), intent(in), contiguous :: x(:)
      real(wp), intent(out), contiguous :: y(:), z(:)
      integer :: i

      !$omp simd
      do i = 1, size(x)
         y(i) = 2.0_wp*x(i)
         z(i) = x(i) + 1.0_wp
      end do
   end subroutine read_one_write_two

   !> Use two results; the others stand in memory that others can see.
   subroutine consume(this)
      class(array_contender), intent(inout) :: this

      this%checksum = this%checksum + this%on%pressure(1) + this%on%stiffness(this%points)
   end subroutine consume

end module bench_law
