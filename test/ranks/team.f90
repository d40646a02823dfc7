!> The ranks as a team: sums, largest values, errors that one of them has.
module test_ranks_team
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: computation_error, error_type, file_error, wp
   use asperity_base_error, only: fatal_error
   use asperity_base_number_text, only: to_text
   use test_ranks_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_team

contains

   function suite_team() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('team')
      call suite%addTest(TestMethod('sums and largest values', test_sums))
      call suite%addTest(TestMethod('sums have the same bits on all', test_bits))
      call suite%addTest(TestMethod('what the first has', test_first))
      call suite%addTest(TestMethod('whether it is so on any', test_any))
      call suite%addTest(TestMethod('no error', test_no_error))
      call suite%addTest(TestMethod('an error of the last', test_last))
      call suite%addTest(TestMethod('errors of all', test_all))
   end function suite_team

   subroutine test_sums()
      real(wp) :: list(2), table(2, 3), none(0)
      integer :: i

      associate (n => petsc%ranks%size, rank => petsc%ranks%rank)
         list = [1.0_wp, real(rank, wp)]
         call petsc%ranks%sum(list)
         call assertEqual(real(n, wp), list(1), tolerance=0.0_wp, message='ranks')
         call assertEqual(real(n*(n - 1)/2, wp), list(2), tolerance=0.0_wp, message='their sum')
         table = reshape([(real(i*rank, wp), i=1, 6)], [2, 3])
         call petsc%ranks%sum(table)
         call assertEqual(6*list(2), table(2, 3), tolerance=0.0_wp, message='a table')
         list = [-1.0_wp - rank, real(rank, wp)]
         call petsc%ranks%maximum(list)
         call assertEqual(-1.0_wp, list(1), tolerance=0.0_wp, message='largest of the first')
         call assertEqual(n - 1.0_wp, list(2), tolerance=0.0_wp, message='largest of the last')
         call petsc%ranks%sum(none)
      end associate
   end subroutine test_sums

   !> Numbers whose sum depends on its order.
   subroutine test_bits()
      real(wp) :: values(1000), first(1000)
      integer :: i

      values = [(sin(real(i*(petsc%ranks%rank + 1), wp))*10.0_wp**mod(i, 17), i=1, size(values))]
      call petsc%ranks%sum(values)
      first = values
      call petsc%ranks%take_first(first)
      call assertTrue(all(transfer(values, [0_int64]) == transfer(first, [0_int64])), 'bits')
   end subroutine test_bits

   subroutine test_first()
      real(wp) :: values(3)

      values = real(petsc%ranks%rank + 7, wp)
      call petsc%ranks%take_first(values)
      call assertEqual(7.0_wp, maxval(abs(values)), tolerance=0.0_wp)
   end subroutine test_first

   subroutine test_any()
      associate (ranks => petsc%ranks)
         call assertFalse(ranks%any(.false.), 'none')
         call assertTrue(ranks%any(ranks%rank == ranks%size - 1), 'the last')
         call assertTrue(ranks%any(.true.), 'all')
      end associate
   end subroutine test_any

   subroutine test_no_error()
      type(error_type), allocatable :: error

      call petsc%ranks%agree(error)
      call assertFalse(allocated(error))
   end subroutine test_no_error

   subroutine test_last()
      type(error_type), allocatable :: error

      associate (ranks => petsc%ranks)
         if (ranks%rank == ranks%size - 1) call fatal_error(error, 'the disk is full', &
            file_error, 'csv json')
         call ranks%agree(error)
         call assertTrue(allocated(error), 'all have it')
         if (.not. allocated(error)) return
         if (ranks%size == 1) then
            call assertEqual('the disk is full', error%message)
         else
            call assertEqual('rank '//to_text(ranks%size - 1)//': the disk is full', &
               error%message)
         end if
         call assertEqual('csv json', error%subject)
         call assertEqual(file_error, error%category)
      end associate
   end subroutine test_last

   !> The first one's is told, and not whose it is.
   subroutine test_all()
      type(error_type), allocatable :: error

      call fatal_error(error, 'told by '//to_text(petsc%ranks%rank)//repeat('.', &
         3*petsc%ranks%rank), computation_error)
      call petsc%ranks%agree(error)
      call assertEqual('told by 0', error%message)
      call assertEqual('', error%subject)
      call assertEqual(computation_error, error%category)
   end subroutine test_all

end module test_ranks_team
