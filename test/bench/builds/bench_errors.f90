!> Errors of contenders against the direct evaluation.
module bench_errors
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use asperity, only: evaluate_normal_law, normal_response, wp
   use bench_law, only: array_contender
   use bench_results, only: add_row, result_row
   use bench_timing, only: contender, spread_type
   implicit none
   private
   public :: add_errors

   !> Points that are compared, at most
   integer, parameter :: most = 10000

contains

   !> Largest and root-mean-square relative error of a contender that has one; `sane` turns false
   !> when it is above the contender's limit, or no number.
   subroutine add_errors(item, rows, sane)
      class(contender), intent(in) :: item
      type(result_row), allocatable, intent(inout) :: rows(:)
      logical, intent(inout) :: sane
      type(normal_response) :: response
      real(wp), allocatable :: pressure(:), stiffness(:)
      real(wp) :: limit
      integer :: i, n

      select type (item)
      class is (array_contender)
         if (.not. item%has_error) return
         limit = item%error_limit
         n = min(item%points, most)
         allocate (pressure(n), stiffness(n))
         do i = 1, n
            response = evaluate_normal_law(item%properties, item%on%separation(i))
            pressure(i) = item%on%pressure(i)/response%pressure - 1.0_wp
            stiffness(i) = item%on%stiffness(i)/response%stiffness - 1.0_wp
         end do
         call add_error('pressure', pressure)
         call add_error('stiffness', stiffness)
      end select

   contains

      subroutine add_error(quantity, errors)
         character(len=*), intent(in) :: quantity
         real(wp), intent(in) :: errors(:)
         real(wp) :: largest, rms

         if (.not. all(ieee_is_finite(errors))) then
            sane = .false.
            return
         end if
         largest = maxval(abs(errors))
         rms = norm2(errors)/sqrt(real(size(errors), wp))
         sane = sane .and. largest <= limit
         call add_row(rows, 'largest error', trim(item%name)//': '//quantity, '-', &
            spread_type(largest, largest, largest), 1)
         call add_row(rows, 'rms error', trim(item%name)//': '//quantity, '-', &
            spread_type(rms, rms, rms), 1)
      end subroutine add_error

   end subroutine add_errors

end module bench_errors
