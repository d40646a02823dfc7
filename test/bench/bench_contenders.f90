!> All contenders, timed in turn.
module bench_contenders
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use abaqus_stubs, only: messages
   use asperity, only: compiled_law, error_type, new_compiled_law, normal_properties, status_slip, &
      status_stick, wp
   use asperity_contact_properties, only: default_initial_separation
   use bench_cases, only: both, contact_set, new_contact_set
   use bench_errors, only: add_errors
   use bench_gsl, only: gsl_law, new_gsl_law
   use bench_law, only: array_contender, batch_law, direct_law, new_point_arrays, point_arrays, &
      read_write_loop, scalar_law
   use bench_options, only: options_type
   use bench_points, only: new_points_update, points_update
   use bench_results, only: add_row, result_row
   use bench_table, only: new_table_law, table_law
   use bench_timing, only: contender, contender_box, measure, spread_of, spread_type
   use bench_uinter, only: new_vuinter_caller, props_reader, uinter_caller, vuinter_caller
   use random_inputs, only: normal_of_pair
   implicit none
   private
   public :: run_contenders, normal_pair, compiled_pair

   !> Points in the cache, in memory, for GSL, and in a set for the update, UINTER and VUINTER
   integer, parameter :: in_cache = 10000, in_memory = 10000000, for_gsl = 128, in_set = 1000
   !> Sets of random properties; rows of a table
   integer, parameter :: random_sets = 200, rows_of_table = 200
   !> Memory that must be free for the largest of them, GB: four times what it takes
   real(wp), parameter :: memory_needed = 1.0_wp

   !> Contenders so far, and whose time theirs is compared with
   type :: contender_list
      type(contender_box) :: boxes(32)
      integer :: size = 0
      !> Compiled batch and read-write loop, in the cache
      integer :: batch = 0, loop = 0
      !> Read-write loop of the same size, for each
      integer :: loop_of(32) = 0
   end type contender_list

contains

   !> The pair transverse-tangential.
   function normal_pair() result(properties)
      type(normal_properties) :: properties

      properties = normal_of_pair('transverse-tangential')
   end function normal_pair

   !> Its compiled law.
   function compiled_pair() result(law)
      type(compiled_law) :: law
      type(error_type), allocatable :: error

      call new_compiled_law(law, normal_pair(), error)
      if (allocated(error)) error stop error%message
   end function compiled_pair

   !> Time them all in turn; `sane` is false when an error is not what it should be.
   subroutine run_contenders(options, rows, sane)
      type(options_type), intent(in) :: options
      type(result_row), allocatable, intent(inout) :: rows(:)
      logical, intent(out) :: sane
      type(contender_list), allocatable :: list
      real(wp), allocatable :: times(:, :)
      real(wp) :: checksum
      integer :: i

      allocate (list)
      call add_law(list)
      call add_interfaces(list)
      if (.not. options%level_only) call add_others(list, options)
      call measure(list%boxes(:list%size), options%plan, times)

      sane = .true.
      checksum = 0.0_wp
      do i = 1, list%size
         associate (name => list%boxes(i)%item%name)
            call add('time', name, 'ns', spread_of(1.0e9_wp*times(:, i)))
            if (.not. options%level_only) then
               call add('over batch', name, '-', spread_of(times(:, i)/times(:, list%batch)))
               call add('over loop', name, '-', spread_of(times(:, i)/times(:, list%loop_of(i))))
            end if
         end associate
         call add_errors(list%boxes(i)%item, rows, sane)
         checksum = checksum + list%boxes(i)%item%checksum
      end do
      ! UINTER and VUINTER had nothing to say
      sane = sane .and. ieee_is_finite(checksum) .and. messages == 0
      call add('checksum', 'sum of results', '-', spread_type(checksum, checksum, checksum))

   contains

      subroutine add(section, name, unit, value)
         character(len=*), intent(in) :: section, name, unit
         type(spread_type), intent(in) :: value

         call add_row(rows, section, name, unit, value, size(times, 1))
      end subroutine add

   end subroutine run_contenders

   !> The law itself, and the read-write loop.
   subroutine add_law(list)
      type(contender_list), intent(inout) :: list
      type(direct_law) :: direct
      type(scalar_law) :: scalar
      type(batch_law) :: batch
      type(read_write_loop) :: loop

      direct%sets = [normal_pair()]
      allocate (direct%which(in_cache), source=1)
      call place(direct, 'direct evaluation', -8.0_wp, 8.0_wp)
      call append(list, direct)

      scalar%law = compiled_pair()
      call place(scalar, 'compiled law, a point a call', -8.0_wp, 8.0_wp)
      scalar%has_error = .true.
      scalar%error_limit = 1.0e-9_wp
      call append(list, scalar)

      batch%law = compiled_pair()
      batch%has_error = .true.
      batch%error_limit = 1.0e-9_wp
      call place(batch, 'compiled law, batch', -8.0_wp, 8.0_wp)
      call append(list, batch)
      list%batch = list%size

      call place(loop, 'read-write loop', -8.0_wp, 8.0_wp)
      call append(list, loop)
      list%loop = list%size
      list%loop_of = list%loop
   end subroutine add_law

   !> UINTER and VUINTER.
   subroutine add_interfaces(list)
      type(contender_list), intent(inout) :: list
      type(uinter_caller) :: caller
      type(vuinter_caller) :: explicit
      type(props_reader) :: reader
      type(contact_set) :: set

      call new_contact_set(caller%set, in_set, 1, status_stick, 1.0_wp, 5.0_wp)
      caller%points = in_set
      caller%name = 'UINTER, stick, h = 1..5'
      call append(list, caller)
      call new_contact_set(caller%set, in_set, 1, status_slip, 1.0_wp, 5.0_wp)
      caller%name = 'UINTER, slip, h = 1..5'
      call append(list, caller)
      call new_contact_set(caller%set, in_set, random_sets, both, -8.0_wp, 4.0_wp)
      caller%name = 'UINTER, 200 random property sets, h = -8..4'
      call append(list, caller)
      call new_contact_set(reader%set, in_set, 1, both, 1.0_wp, 5.0_wp)
      reader%points = in_set
      reader%name = 'part of UINTER: PROPS read and checked'
      call append(list, reader)
      call new_contact_set(set, in_set, 1, both, 1.0_wp, 5.0_wp)
      call new_vuinter_caller(explicit, set)
      explicit%name = 'VUINTER, 1000 points a call, h = 1..5'
      call append(list, explicit)
   end subroutine add_interfaces

   !> Everything that is not compared between levels of optimisation.
   subroutine add_others(list, options)
      type(contender_list), intent(inout) :: list
      type(options_type), intent(in) :: options
      type(direct_law) :: direct
      type(batch_law) :: batch
      type(read_write_loop) :: loop
      type(points_update) :: update
      type(contact_set) :: set
      integer :: i

      call new_contact_set(set, in_cache, 1, both, 1.0_wp, 5.0_wp)
      call new_points_update(update, set, everything=.false.)
      update%name = 'update_contact_points, tractions, h = 1..5'
      call append(list, update)
      call new_points_update(update, set, everything=.true.)
      update%name = 'update_contact_points, all results, h = 1..5'
      call append(list, update)

      direct%sets = [normal_pair()]
      allocate (direct%which(in_cache), source=1)
      call place(direct, 'direct evaluation, h = 1..5', 1.0_wp, 5.0_wp)
      call append(list, direct)
      batch%law = compiled_pair()
      batch%has_error = .true.
      batch%error_limit = 1.0e-9_wp
      call place(batch, 'compiled law, batch, h = 1..5', 1.0_wp, 5.0_wp)
      call append(list, batch)
      call place(batch, 'compiled law, batch, h = -8..37', -8.0_wp, 37.0_wp)
      call append(list, batch)

      call add_gsl(list)
      call add_tables(list, -8.0_wp, 8.0_wp)
      call add_tables(list, 1.0_wp, 5.0_wp)

      if (options%short .or. options%memory < memory_needed) return
      ! the loop will write over its results
      batch%has_error = .false.
      call place(batch, 'compiled law, batch of 1e7', -8.0_wp, 8.0_wp, in_memory)
      call append(list, batch)
      i = list%size
      loop%on = batch%on
      loop%points = in_memory
      loop%name = 'read-write loop over 1e7'
      call append(list, loop)
      list%loop_of(i:i + 1) = list%size
   end subroutine add_others

   !> Quadrature by GSL.
   subroutine add_gsl(list)
      type(contender_list), intent(inout) :: list
      type(gsl_law) :: gsl
      type(point_arrays) :: on
      type(normal_properties) :: properties

      properties = normal_pair()
      call new_point_arrays(on, for_gsl, properties%sigma, -8.0_wp, 8.0_wp)
      call new_gsl_law(gsl, on, properties, for_gsl)
      gsl%name = 'GSL QAG at 1e-10'
      call append(list, gsl)
   end subroutine add_gsl

   !> Tables that end where the separations do.
   subroutine add_tables(list, h_min, h_max)
      type(contender_list), intent(inout) :: list
      real(wp), intent(in) :: h_min, h_max
      type(table_law) :: table
      type(point_arrays) :: on
      type(normal_properties) :: properties
      character(len=16) :: range
      integer :: i

      properties = normal_pair()
      range = ''
      if (h_min > 0.0_wp) write (range, '(a, i0, a, i0)') ', h = ', nint(h_min), '..', nint(h_max)
      do i = 1, 2
         call new_point_arrays(on, in_cache, properties%sigma, h_min, h_max)
         call new_table_law(table, on, properties, rows_of_table, h_min, h_max, &
            default_initial_separation*properties%sigma)
         table%by_division = i == 1
         table%name = 'table of 200 rows, '//trim(merge('index ', 'search', i == 1))//range
         call append(list, table)
      end do
   end subroutine add_tables

   !> Give a contender its name and separations of the pair.
   subroutine place(item, name, h_min, h_max, points)
      class(array_contender), intent(inout) :: item
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: h_min, h_max
      integer, intent(in), optional :: points

      item%name = name
      item%properties = normal_pair()
      item%points = in_cache
      if (present(points)) item%points = points
      call new_point_arrays(item%on, item%points, item%properties%sigma, h_min, h_max)
   end subroutine place

   subroutine append(list, item)
      type(contender_list), intent(inout) :: list
      class(contender), intent(in) :: item

      list%size = list%size + 1
      allocate (list%boxes(list%size)%item, source=item)
   end subroutine append

end module bench_contenders
