!> Contenders by which builds are compared: they need nothing of the library that is new.
module bench_compared
   use asperity, only: status_slip, status_stick, wp
   use bench_cases, only: both, contact_set, new_contact_set
   use bench_law, only: batch_law, direct_law, read_write_loop, scalar_law
   use bench_list, only: append, compiled_pair, contender_list, in_cache, normal_pair, place
   use bench_points, only: new_points_update, points_update
   use bench_uinter, only: new_vuinter_caller, props_reader, uinter_caller, vuinter_caller
   implicit none
   private
   public :: add_compared

   !> Points in a set for UINTER, and in a call of VUINTER; sets of random properties
   integer, parameter :: in_set = 1000, points_a_call(3) = [100, 1000, 10000], random_sets = 200

contains

   !> The law, the update and UINTER and VUINTER.
   subroutine add_compared(list)
      type(contender_list), intent(inout) :: list

      call add_law(list)
      call add_interfaces(list)
      call add_update(list)
   end subroutine add_compared

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
      integer :: i

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
      do i = 1, size(points_a_call)
         call new_contact_set(set, points_a_call(i), 1, both, 1.0_wp, 5.0_wp)
         call new_vuinter_caller(explicit, set)
         write (explicit%name, '(a, i0, a)') 'VUINTER, ', points_a_call(i), &
            ' points a call, h = 1..5'
         call append(list, explicit)
      end do
   end subroutine add_interfaces

   !> The update of many points in one call, with the compiled law.
   subroutine add_update(list)
      type(contender_list), intent(inout) :: list
      type(points_update) :: update
      type(contact_set) :: set

      call new_contact_set(set, in_cache, 1, both, 1.0_wp, 5.0_wp)
      call new_points_update(update, set, everything=.false.)
      update%name = 'update_contact_points, tractions, h = 1..5'
      call append(list, update)
      call new_points_update(update, set, everything=.true.)
      update%name = 'update_contact_points, all results, h = 1..5'
      call append(list, update)
   end subroutine add_update

end module bench_compared
