!> Where the time of a run goes, on one rank.
module asperity_solid_solve_times
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_solid_engine_ranks, only: rank_team
   implicit none
   private
   public :: run_times, seconds_now, take_slowest

   !> Seconds since the run began, or was taken up again.
   type :: run_times
      !> Elements; contact; sums over ranks and waiting for them
      real(wp) :: elements = 0.0_wp, contact = 0.0_wp, exchange = 0.0_wp
      !> Patterns of the matrix; factors; GMRES and solutions by factors
      real(wp) :: patterns = 0.0_wp, factors = 0.0_wp, solutions = 0.0_wp
   end type run_times

contains

   !> Make each of the times that of the rank that it took longest.
   subroutine take_slowest(times, ranks)
      !> Of this rank; on return the same on all
      type(run_times), intent(inout) :: times
      !> The ranks
      type(rank_team), intent(in) :: ranks
      real(wp) :: values(6)

      values = [times%elements, times%contact, times%exchange, times%patterns, times%factors, &
         times%solutions]
      call ranks%maximum(values)
      times = run_times(values(1), values(2), values(3), values(4), values(5), values(6))
   end subroutine take_slowest

   !> Time of a clock that never goes back, s.
   real(wp) function seconds_now()
      integer(int64) :: now, rate

      call system_clock(now, rate)
      seconds_now = real(now, wp)/real(rate, wp)
   end function seconds_now

end module asperity_solid_solve_times
