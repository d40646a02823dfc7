!> How the compiled batch grows with points and threads, beside the loop that only reads and
!> writes; and what it takes to compile a law.
module bench_scaling
   use asperity, only: compiled_law, error_type, find_pair, new_compiled_law, &
      new_normal_properties, normal_properties, pair_preset, unloading_elastic, wp
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_unloading_law, size_in_bytes
   use bench_list, only: compiled_pair, normal_pair
   use bench_law, only: batch_law, free_point_arrays, new_point_arrays, point_arrays, &
      read_write_loop
   use bench_machine, only: has_openmp
   use bench_options, only: options_type
   use bench_results, only: add_row, result_row, short
   use bench_timing, only: contender, contender_box, measure, plan_type, spread_of, spread_type
   use random_inputs, only: random_properties, random_stream
   implicit none
   private
   public :: run_growth, run_threads, run_building

   !> Compiles one law after the other, with memory or without.
   type, extends(contender) :: law_builder
      type(normal_properties), allocatable :: properties(:)
   contains
      procedure :: pass => pass_builder
   end type law_builder

   !> What three doubles a point take, GB, with a tenth to spare
   real(wp), parameter :: memory_of_point = 1.1_wp*24.0e-9_wp

contains

   !> From 1e2 to 1e8 points; `skipped` tells what was left out and why, blank otherwise.
   subroutine run_growth(options, rows, skipped)
      type(options_type), intent(in) :: options
      type(result_row), allocatable, intent(inout) :: rows(:)
      character(len=100), intent(out) :: skipped
      type(contender_box), allocatable :: list(:)
      type(point_arrays) :: on
      real(wp), allocatable :: times(:, :)
      real(wp) :: pass_time
      character(len=8) :: name
      integer :: power, repeats

      skipped = ''
      pass_time = 0.0_wp
      do power = 2, merge(5, 8, options%short)
         write (name, '(a, i0)') '1e', power
         if (10.0_wp**power*memory_of_point > options%memory) then
            skipped = trim(name)//' points and more: they need '// &
               trim(short(10.0_wp**power*memory_of_point))//' GB of memory, and '// &
               trim(short(options%memory))//' GB are free'
            return
         end if
         if (10.0_wp*pass_time*options%plan%fewest_repeats > options%plan%most) then
            skipped = trim(name)//' points and more: a pass would take '// &
               trim(short(10.0_wp*pass_time))//' s'
            return
         end if
         call make_pair(list, on, 10**power, 0)
         call measure(list, options%plan, times)
         call free_point_arrays(on)
         repeats = size(times, 1)
         pass_time = sum(times)/repeats*10.0_wp**power
         call add_row(rows, 'growth, batch', name, 'ns', spread_of(1.0e9_wp*times(:, 1)), repeats)
         call add_row(rows, 'growth, loop', name, 'ns', spread_of(1.0e9_wp*times(:, 2)), repeats)
         call add_row(rows, 'growth, ratio', name, '-', spread_of(times(:, 1)/times(:, 2)), &
            repeats)
      end do
   end subroutine run_growth

   !> One thread against more, up to all cores.
   subroutine run_threads(options, cores, rows, skipped)
      type(options_type), intent(in) :: options
      integer, intent(in) :: cores
      type(result_row), allocatable, intent(inout) :: rows(:)
      character(len=100), intent(out) :: skipped
      integer :: i
      integer, parameter :: points(2) = [1000000, 10000000]

      skipped = ''
      if (.not. has_openmp()) then
         skipped = 'built without OpenMP'
      else if (cores == 1) then
         skipped = 'there is one core only'
      else
         do i = 1, merge(1, 2, options%short .or. options%memory < 1.0_wp)
            call run_threads_over(points(i), options%plan, cores, rows)
         end do
      end if
   end subroutine run_threads

   !> The same number of points with one and more threads.
   subroutine run_threads_over(points, plan, cores, rows)
      integer, intent(in) :: points, cores
      type(plan_type), intent(in) :: plan
      type(result_row), allocatable, intent(inout) :: rows(:)
      type(contender_box), allocatable :: list(:), pair(:)
      type(point_arrays) :: on
      real(wp), allocatable :: times(:, :)
      integer :: threads(32), n, i
      character(len=24) :: name

      threads(1) = 1
      n = 1
      do while (threads(n) < cores)
         threads(n + 1) = min(2*threads(n), cores)
         n = n + 1
      end do
      allocate (list(2*n))
      do i = 1, n
         call make_pair(pair, on, points, threads(i))
         call move_alloc(pair(1)%item, list(2*i - 1)%item)
         call move_alloc(pair(2)%item, list(2*i)%item)
      end do
      call measure(list, plan, times)
      call free_point_arrays(on)
      do i = 1, n
         write (name, '(a, i0, a, i0)') '1e', nint(log10(real(points, wp))), ' points, threads ', &
            threads(i)
         call add_row(rows, 'threads, batch', name, 'ns', &
            spread_of(1.0e9_wp*times(:, 2*i - 1)), size(times, 1))
         call add_row(rows, 'threads, batch gain', name, '-', &
            spread_of(times(:, 1)/times(:, 2*i - 1)), size(times, 1))
         call add_row(rows, 'threads, loop', name, 'ns', spread_of(1.0e9_wp*times(:, 2*i)), &
            size(times, 1))
         call add_row(rows, 'threads, loop gain', name, '-', &
            spread_of(times(:, 2)/times(:, 2*i)), size(times, 1))
      end do
   end subroutine run_threads_over

   !> Compiled batch and read-write loop over the same points. Arrays that are there already stay.
   subroutine make_pair(list, on, points, threads)
      type(contender_box), allocatable, intent(out) :: list(:)
      type(point_arrays), intent(inout) :: on
      integer, intent(in) :: points, threads
      type(batch_law) :: batch
      type(read_write_loop) :: loop
      type(normal_properties) :: properties

      properties = normal_pair()
      if (.not. associated(on%separation)) &
         call new_point_arrays(on, points, properties%sigma, -8.0_wp, 8.0_wp)
      batch%law = compiled_pair()
      batch%on = on
      batch%points = points
      batch%threads = threads
      loop%on = on
      loop%points = points
      loop%threads = threads
      allocate (list(2))
      allocate (list(1)%item, source=batch)
      allocate (list(2)%item, source=loop)
   end subroutine make_pair

   !> Time to compile the law, without memory and with it, and its size.
   subroutine run_building(options, rows)
      type(options_type), intent(in) :: options
      type(result_row), allocatable, intent(inout) :: rows(:)
      type(contender_box) :: list(3)
      type(law_builder) :: builder
      type(random_stream) :: stream
      type(compiled_law) :: law
      type(compiled_unloading_law) :: with_memory
      type(error_type), allocatable :: error
      real(wp), allocatable :: times(:, :)
      integer :: i

      builder%properties = [normal_pair()]
      builder%points = 1
      builder%name = 'pair transverse-tangential'
      allocate (list(1)%item, source=builder)
      deallocate (builder%properties)
      allocate (builder%properties(200))
      stream%state = 17
      do i = 1, size(builder%properties)
         call random_properties(stream, builder%properties(i), 1.0e-5_wp, 1.0_wp, 0.1_wp)
      end do
      builder%points = size(builder%properties)
      builder%name = '200 random property sets, each'
      allocate (list(2)%item, source=builder)
      builder%properties = [pair_with_memory()]
      builder%points = 1
      builder%name = 'pair transverse-tangential with memory'
      allocate (list(3)%item, source=builder)
      call measure(list, options%plan, times)
      do i = 1, size(list)
         call add_row(rows, 'building', list(i)%item%name, 'ms', spread_of(1.0e3_wp*times(:, i)), &
            size(times, 1))
      end do
      call add_size('size', storage_size(law)/8)
      call new_compiled_unloading_law(with_memory, pair_with_memory(), error)
      if (allocated(error)) error stop error%message
      call add_size('size with memory', size_in_bytes(with_memory))

   contains

      subroutine add_size(name, size)
         character(len=*), intent(in) :: name
         integer, intent(in) :: size
         real(wp) :: bytes

         bytes = real(size, wp)
         call add_row(rows, 'size', name, 'bytes', spread_type(bytes, bytes, bytes), 1)
      end subroutine add_size

   end subroutine run_building

   !> The pair with summits that recover elastically.
   function pair_with_memory() result(properties)
      type(normal_properties) :: properties
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      call find_pair('transverse-tangential', pair, error)
      if (.not. allocated(error)) &
         call new_normal_properties(properties, pair, error, unloading=unloading_elastic)
      if (allocated(error)) error stop error%message
   end function pair_with_memory

   subroutine pass_builder(this)
      class(law_builder), intent(inout) :: this
      type(compiled_law) :: law
      type(compiled_unloading_law) :: with_memory
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, size(this%properties)
         if (this%properties(i)%unloading == unloading_elastic) then
            call new_compiled_unloading_law(with_memory, this%properties(i), error)
            law = with_memory%virgin
         else
            call new_compiled_law(law, this%properties(i), error)
         end if
         if (allocated(error)) error stop error%message
         this%checksum = this%checksum + law%properties%w1
      end do
   end subroutine pass_builder

end module bench_scaling
