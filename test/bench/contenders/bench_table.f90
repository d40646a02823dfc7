!> Contender: a table of pressure against overclosure, linear between its rows, as hosts offer it
!> (ABAQUS: *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR). The stiffness is the slope.
module bench_table
   use asperity, only: evaluate_normal_law, normal_properties, normal_response, wp
   use bench_law, only: array_contender, point_arrays
   implicit none
   private
   public :: table_law, new_table_law

   !> Rows equally far apart in overclosure, so that both ways to find one give the same numbers.
   type, extends(array_contender) :: table_law
      !> Overclosure, mm, pressure, MPa, and slope up to the next row, MPa/mm
      real(wp), allocatable :: overclosure(:), pressure(:), slope(:)
      !> Separation at zero overclosure, mm
      real(wp) :: initial_separation = 0.0_wp
      !> Find the row by dividing; by halving intervals otherwise, as for rows anywhere
      logical :: by_division = .true.
   contains
      procedure :: pass => pass_table
   end type table_law

contains

   !> Table over separations h_min to h_max, in sigma.
   subroutine new_table_law(table, on, properties, rows, h_min, h_max, initial_separation)
      type(table_law), intent(out) :: table
      !> Points to evaluate
      type(point_arrays), intent(in) :: on
      type(normal_properties), intent(in) :: properties
      integer, intent(in) :: rows
      real(wp), intent(in) :: h_min, h_max, initial_separation
      type(normal_response) :: response
      integer :: i

      table%on = on
      table%properties = properties
      table%has_error = .true.
      table%points = size(on%separation)
      table%initial_separation = initial_separation
      allocate (table%overclosure(rows), table%pressure(rows), table%slope(rows))
      do i = 1, rows
         table%overclosure(i) = initial_separation &
            - properties%sigma*(h_max - (h_max - h_min)*real(i - 1, wp)/real(rows - 1, wp))
         response = evaluate_normal_law(properties, initial_separation - table%overclosure(i))
         table%pressure(i) = response%pressure
      end do
      table%slope(:rows - 1) = (table%pressure(2:) - table%pressure(:rows - 1)) &
         /(table%overclosure(2:) - table%overclosure(:rows - 1))
      table%slope(rows) = table%slope(rows - 1)
   end subroutine new_table_law

   subroutine pass_table(this)
      class(table_law), intent(inout) :: this

      associate (on => this%on)
         if (this%by_division) then
            call look_up_by_division(this%overclosure, this%pressure, this%slope, &
               this%initial_separation, on%separation, on%pressure, on%stiffness)
         else
            call look_up_by_halving(this%overclosure, this%pressure, this%slope, &
               this%initial_separation, on%separation, on%pressure, on%stiffness)
         end if
         this%checksum = this%checksum + on%pressure(1) + on%stiffness(this%points)
      end associate
   end subroutine pass_table

   pure subroutine look_up_by_division(rows, values, slopes, d0, separation, pressure, stiffness)
      real(wp), intent(in), contiguous :: rows(:), values(:), slopes(:)
      real(wp), intent(in) :: d0
      real(wp), intent(in), contiguous :: separation(:)
      real(wp), intent(out), contiguous :: pressure(:), stiffness(:)
      real(wp) :: closure, per_row
      integer :: i, row

      per_row = real(size(rows) - 1, wp)/(rows(size(rows)) - rows(1))
      do i = 1, size(separation)
         closure = d0 - separation(i)
         row = max(1, min(size(rows) - 1, 1 + int((closure - rows(1))*per_row)))
         pressure(i) = values(row) + slopes(row)*(closure - rows(row))
         stiffness(i) = slopes(row)
      end do
   end subroutine look_up_by_division

   pure subroutine look_up_by_halving(rows, values, slopes, d0, separation, pressure, stiffness)
      real(wp), intent(in), contiguous :: rows(:), values(:), slopes(:)
      real(wp), intent(in) :: d0
      real(wp), intent(in), contiguous :: separation(:)
      real(wp), intent(out), contiguous :: pressure(:), stiffness(:)
      real(wp) :: closure
      integer :: i, low, high, middle

      do i = 1, size(separation)
         closure = d0 - separation(i)
         low = 1
         high = size(rows)
         do while (high - low > 1)
            middle = (low + high)/2
            if (rows(middle) <= closure) then
               low = middle
            else
               high = middle
            end if
         end do
         pressure(i) = values(low) + slopes(low)*(closure - rows(low))
         stiffness(i) = slopes(low)
      end do
   end subroutine look_up_by_halving

end module bench_table
