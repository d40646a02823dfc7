!> Contenders in a list, timed in turn.
module bench_list
   use, intrinsic :: iso_fortran_env, only: error_unit
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use abaqus_stubs, only: messages
   use asperity, only: compiled_law, error_type, new_compiled_law, normal_properties, wp
   use bench_errors, only: add_errors
   use bench_law, only: array_contender, new_point_arrays
   use bench_results, only: add_row, result_row
   use bench_timing, only: contender, contender_box, measure, plan_type, spread_of, spread_type
   use random_inputs, only: normal_of_pair
   implicit none
   private
   public :: contender_list, append, place, run_contenders, normal_pair, compiled_pair

   !> Points in the cache
   integer, parameter, public :: in_cache = 10000

   !> Contenders so far, and whose time theirs is compared with
   type :: contender_list
      type(contender_box) :: boxes(40)
      integer :: size = 0
      !> Compiled batch and read-write loop, in the cache
      integer :: batch = 0, loop = 0
      !> Read-write loop of the same size, for each
      integer :: loop_of(40) = 0
      !> The same without memory, for each that has memory
      integer :: reversible_of(40) = 0
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

   !> Time them all in turn, and stop when an error is not what it should be.
   subroutine run_contenders(list, plan, rows)
      type(contender_list), intent(inout) :: list
      type(plan_type), intent(in) :: plan
      type(result_row), allocatable, intent(inout) :: rows(:)
      real(wp), allocatable :: times(:, :)
      real(wp) :: checksum
      logical :: sane
      integer :: i

      call measure(list%boxes(:list%size), plan, times)
      sane = .true.
      checksum = 0.0_wp
      do i = 1, list%size
         associate (name => list%boxes(i)%item%name)
            call add('time', name, 'ns', spread_of(1.0e9_wp*times(:, i)))
            call add('over batch', name, '-', spread_of(times(:, i)/times(:, list%batch)))
            call add('over loop', name, '-', spread_of(times(:, i)/times(:, list%loop_of(i))))
            if (list%reversible_of(i) > 0) call add('over reversible', name, '-', &
               spread_of(times(:, i)/times(:, list%reversible_of(i))))
         end associate
         call add_errors(list%boxes(i)%item, rows, sane)
         checksum = checksum + list%boxes(i)%item%checksum
      end do
      ! UINTER and VUINTER had nothing to say
      sane = sane .and. ieee_is_finite(checksum) .and. messages == 0
      call add('checksum', 'sum of results', '-', spread_type(checksum, checksum, checksum))
      if (.not. sane) then
         write (error_unit, '(a)') 'bench: error: an error against the direct evaluation is '// &
            'too large, or something is not a number'
         stop 1
      end if

   contains

      subroutine add(section, name, unit, value)
         character(len=*), intent(in) :: section, name, unit
         type(spread_type), intent(in) :: value

         call add_row(rows, section, name, unit, value, size(times, 1))
      end subroutine add

   end subroutine run_contenders

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

end module bench_list
