!> Pattern of a sparse matrix that is a sum of small dense ones, each with rows and columns of its
!> own numbers, and where each of their entries goes.
module asperity_solid_solve_pattern
   implicit none
   private
   public :: block_list, block_places, find_pattern

   !> Numbers of the unknowns of a small matrix; those below 1 have no row.
   type :: block_list
      integer, allocatable :: numbers(:)
   end type block_list

   !> Place in the sparse matrix of each entry of a small one; 0 where there is none.
   type :: block_places
      integer, allocatable :: at(:, :)
   end type block_places

contains

   !> Pattern and places. It is symmetric, so that columns come out sorted: row by row, each row is
   !> put into the lists of its columns.
   pure subroutine find_pattern(n, blocks, row_start, columns, places)
      !> Number of unknowns
      integer, intent(in) :: n
      !> The small matrices
      type(block_list), intent(in) :: blocks(:)
      !> Where each row begins, from 0, and one more; columns from 0
      integer, allocatable, intent(out) :: row_start(:), columns(:)
      !> Places of each small matrix, from 1
      type(block_places), allocatable, intent(out) :: places(:)
      integer, allocatable :: first(:), blocks_of(:), row_in_block(:), filled(:), mark(:), place(:)
      integer :: b, i, j, k, r, total

      ! which blocks each unknown is in, and in which of their rows
      allocate (first(n + 1), source=0)
      do b = 1, size(blocks)
         do i = 1, size(blocks(b)%numbers)
            r = blocks(b)%numbers(i)
            if (r > 0) first(r) = first(r) + 1
         end do
      end do
      call starts(first, total)
      allocate (blocks_of(total), row_in_block(total), filled(n))
      filled = first(:n)
      do b = 1, size(blocks)
         do i = 1, size(blocks(b)%numbers)
            r = blocks(b)%numbers(i)
            if (r < 1) cycle
            filled(r) = filled(r) + 1
            blocks_of(filled(r)) = b
            row_in_block(filled(r)) = i
         end do
      end do

      allocate (row_start(n + 1), mark(n), source=0)
      do r = 1, n
         do k = first(r) + 1, first(r + 1)
            associate (numbers => blocks(blocks_of(k))%numbers)
               do j = 1, size(numbers)
                  if (numbers(j) < 1) cycle
                  if (mark(numbers(j)) == r) cycle
                  mark(numbers(j)) = r
                  row_start(r) = row_start(r) + 1
               end do
            end associate
         end do
      end do
      call starts(row_start, total)
      allocate (columns(total))
      filled = row_start(:n)
      mark = 0
      do r = 1, n
         do k = first(r) + 1, first(r + 1)
            associate (numbers => blocks(blocks_of(k))%numbers)
               do j = 1, size(numbers)
                  if (numbers(j) < 1) cycle
                  if (mark(numbers(j)) == r) cycle
                  mark(numbers(j)) = r
                  filled(numbers(j)) = filled(numbers(j)) + 1
                  columns(filled(numbers(j))) = r - 1
               end do
            end associate
         end do
      end do

      allocate (places(size(blocks)), place(n))
      do b = 1, size(blocks)
         allocate (places(b)%at(size(blocks(b)%numbers), size(blocks(b)%numbers)), source=0)
      end do
      do r = 1, n
         do k = row_start(r) + 1, row_start(r + 1)
            place(columns(k) + 1) = k
         end do
         do k = first(r) + 1, first(r + 1)
            associate (numbers => blocks(blocks_of(k))%numbers)
               do j = 1, size(numbers)
                  if (numbers(j) > 0) &
                     places(blocks_of(k))%at(row_in_block(k), j) = place(numbers(j))
               end do
            end associate
         end do
      end do
   end subroutine find_pattern

   !> Counts become what stands before each, and the last one all.
   pure subroutine starts(counts, total)
      integer, intent(inout) :: counts(:)
      integer, intent(out) :: total
      integer :: i, number

      total = 0
      do i = 1, size(counts)
         number = counts(i)
         counts(i) = total
         total = total + number
      end do
   end subroutine starts

end module asperity_solid_solve_pattern
