!> Contenders beside those that builds are compared by.
module bench_others
   use asperity, only: normal_properties, unloading_elastic, unloading_reversible, wp
   use asperity_contact_properties, only: default_initial_separation
   use bench_gsl, only: gsl_law, new_gsl_law
   use bench_law, only: batch_law, direct_law, new_point_arrays, point_arrays, read_write_loop
   use bench_list, only: append, compiled_pair, contender_list, in_cache, normal_pair, place
   use bench_memory, only: memory_update, new_memory_update
   use bench_options, only: options_type
   use bench_table, only: new_table_law, table_law
   implicit none
   private
   public :: add_others

   !> Points in memory and for GSL, rows of a table
   integer, parameter :: in_memory = 10000000, for_gsl = 128, rows_of_table = 200
   !> Memory that must be free for the largest of them, GB: four times what it takes
   real(wp), parameter :: memory_needed = 1.0_wp

contains

   !> The law over other ranges, and what else is used for contact.
   subroutine add_others(list, options)
      type(contender_list), intent(inout) :: list
      type(options_type), intent(in) :: options
      type(direct_law) :: direct
      type(batch_law) :: batch
      type(read_write_loop) :: loop
      integer :: i

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

      call add_memory(list)
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

   !> The update with memory, each beside that of the same points without.
   subroutine add_memory(list)
      type(contender_list), intent(inout) :: list
      character(len=*), parameter :: ways(2) = [character(len=9) :: 'unloading', 'loading'], &
         forms(2) = [character(len=8) :: 'direct', 'compiled'], &
         laws(2) = [character(len=10) :: 'reversible', 'memory']
      type(memory_update) :: update
      integer :: way, form, law

      do way = 1, 2
         do form = 1, 2
            do law = 1, 2
               call new_memory_update(update, in_cache, merge(unloading_elastic, &
                  unloading_reversible, law == 2), loads=way == 2, compiled=form == 2)
               update%name = 'update_contact_points, '//trim(laws(law))//', '// &
                  trim(forms(form))//', '//ways(way)
               call append(list, update)
            end do
            list%reversible_of(list%size) = list%size - 1
         end do
      end do
   end subroutine add_memory

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

end module bench_others
