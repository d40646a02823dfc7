!> A finite-element program in one file that calls the contact-point update directly: a block of
!> wood is pressed onto another and slid, in plane strain. Linear elasticity at small strain on
!> plain four-node elements (2x2 points, no incompatible modes), nodes of the upper face against
!> segments of the lower one at finite slip, Newton with the consistent unsymmetric tangent,
!> LAPACK's banded solver. N, mm, MPa; 1 mm thick.
!>
!> What a code of your own needs of it is `add_contact`, and in `solve_increment` that the states
!> of the points change when an increment has converged, never before.
! link with: -llapack -lblas
program fortran_fe
   use asperity, only: contact_properties, contact_response, contact_state, error_type, &
      find_pair, new_contact_properties, no_rotation, pair_preset, status_slip, status_stick, &
      update_contact_point, wp
   implicit none

   !> Blocks, lower and upper: elements along x and y, left lower corner, size
   integer, parameter :: nx(2) = [24, 10], ny(2) = [6, 5]
   real(wp), parameter :: corner(2, 2) = reshape([0.0_wp, 0.0_wp, 14.2_wp, 20.0_wp], [2, 2])
   real(wp), parameter :: extent(2, 2) = reshape([60.0_wp, 20.0_wp, 30.0_wp, 15.0_wp], [2, 2])
   !> Wood across the grain
   real(wp), parameter :: modulus = 351.0_wp, poisson = 0.3_wp
   integer, parameter :: nodes = sum((nx + 1)*(ny + 1)), elements = sum(nx*ny), n = 2*nodes
   integer, parameter :: slaves = nx(2) + 1, masters = nx(1) + 1
   integer, parameter :: most_iterations = 15
   !> Residual, N/mm, of an increment that has converged
   real(wp), parameter :: tolerance = 1.0e-10_wp

   interface
      !> LAPACK: solve a banded system of equations
      subroutine dgbsv(n, kl, ku, nrhs, ab, ldab, ipiv, b, ldb, info)
         import :: wp
         integer, intent(in) :: n, kl, ku, nrhs, ldab, ldb
         real(wp), intent(inout) :: ab(ldab, n), b(ldb, nrhs)
         integer, intent(out) :: ipiv(n), info
      end subroutine dgbsv
   end interface

   type(contact_properties) :: wood
   !> At the start of the increment, and as last updated
   type(contact_state) :: state(slaves)
   type(contact_response) :: point(slaves)
   !> Coordinates, displacements now and at the start of the increment, residual: force that the
   !> elements and the contact put on a node
   real(wp) :: x(2, nodes), u(2, nodes), start(2, nodes), residual(2, nodes)
   !> Prescribed displacements
   real(wp) :: given(2, nodes)
   logical :: is_given(2, nodes)
   integer :: element(4, elements), slave(slaves), master(masters), equation(2, nodes)
   real(wp) :: stiffness(8, 8, 2)
   !> Tangent, column by column; row i of column j is at i - j + its middle row. The band is as wide
   !> as the mesh and the present contact need
   real(wp), allocatable :: tangent(:, :)
   integer :: band
   integer :: i

   call set_properties()
   call build_mesh()
   call build_stiffness()
   u = 0.0_wp
   given = 0.0_wp

   print '(a)', '  top moved, mm     force, N/mm       points   residual, N/mm, after each '// &
      'correction'
   print '(a)', '      x        y     normal   shear  stick slip  but the last, below 1E-10'
   do i = 1, 4
      call move_top(0.0_wp, -0.04_wp*i)
      call solve_increment()
   end do
   call check_tangent('sticking')
   do i = 1, 6
      call move_top(0.15_wp*i, -0.16_wp)
      call solve_increment()
   end do
   call check_balance()
   call check_tangent('slipping')

contains

   !> The first pair of the paper, compiled, as in any model of many points.
   subroutine set_properties()
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      call find_pair('transverse-tangential', pair, error)
      if (.not. allocated(error)) &
         call new_contact_properties(wood, pair, error, compiled=.true.)
      if (allocated(error)) error stop error%message
   end subroutine set_properties

   !> Nodes and elements of both blocks, faces, supports, and the order of the equations: by x, so
   !> that the band is narrow across both blocks.
   subroutine build_mesh()
      integer :: block, column, row, node, e, first

      node = 0
      e = 0
      is_given = .false.
      do block = 1, 2
         do column = 0, nx(block)
            do row = 0, ny(block)
               node = node + 1
               x(:, node) = corner(:, block) &
                  + extent(:, block)*[column, row]/real([nx(block), ny(block)], wp)
               ! the lower block is held at its base, the upper one moved at its top
               is_given(:, node) = merge(row == 0, row == ny(block), block == 1)
               if (block == 1 .and. row == ny(1)) master(column + 1) = node
               if (block == 2 .and. row == 0) slave(column + 1) = node
               if (column == nx(block) .or. row == ny(block)) cycle
               e = e + 1
               first = node + ny(block) + 1
               element(:, e) = [node, first, first + 1, node + 1]
            end do
         end do
      end do
      do node = 1, nodes
         e = count(x(1, :) < x(1, node)) + count(.not. x(1, :node - 1) < x(1, node) &
            .and. .not. x(1, :node - 1) > x(1, node))
         equation(:, node) = 2*e + [1, 2]
      end do
   end subroutine build_mesh

   !> Stiffness of the elements of each block, which are all alike.
   subroutine build_stiffness()
      real(wp), parameter :: gauss = 1.0_wp/sqrt(3.0_wp)
      real(wp), parameter :: corners(2, 4) = &
         reshape([-1.0_wp, -1.0_wp, 1.0_wp, -1.0_wp, 1.0_wp, 1.0_wp, -1.0_wp, 1.0_wp], [2, 4])
      real(wp) :: elasticity(3, 3), strain(3, 8), side(2), slope(2)
      integer :: block, k, j

      elasticity = 0.0_wp
      elasticity(1, :2) = [1.0_wp - poisson, poisson]
      elasticity(2, :2) = [poisson, 1.0_wp - poisson]
      elasticity(3, 3) = 0.5_wp - poisson
      elasticity = elasticity*modulus/((1.0_wp + poisson)*(1.0_wp - 2.0_wp*poisson))
      stiffness = 0.0_wp
      do block = 1, 2
         side = extent(:, block)/[nx(block), ny(block)]
         do k = 1, 4
            do j = 1, 4
               slope = 0.5_wp*corners(:, j)/side &
                  *(1.0_wp + gauss*corners([2, 1], j)*corners([2, 1], k))
               strain(:, 2*j - 1) = [slope(1), 0.0_wp, slope(2)]
               strain(:, 2*j) = [0.0_wp, slope(2), slope(1)]
            end do
            stiffness(:, :, block) = stiffness(:, :, block) + 0.25_wp*product(side) &
               *matmul(transpose(strain), matmul(elasticity, strain))
         end do
      end do
   end subroutine build_stiffness

   !> Prescribe the motion of the top of the upper block.
   subroutine move_top(along, up)
      real(wp), intent(in) :: along, up
      integer :: node

      do node = (nx(1) + 1)*(ny(1) + 1) + 1, nodes
         if (is_given(1, node)) given(:, node) = [along, up]
      end do
   end subroutine move_top

   !> One increment by Newton's method.
   subroutine solve_increment()
      real(wp) :: unbalanced(0:most_iterations), step(n, 1)
      integer :: pivots(n), info, iteration, k

      start = u
      do iteration = 0, most_iterations
         call assemble()
         unbalanced(iteration) = norm2(pack(residual, .not. is_given))
         if (iteration > 0 .and. unbalanced(iteration) <= tolerance) exit
         if (iteration == most_iterations) error stop 'no convergence'
         ! prescribed displacements have an equation of their own: correction = what is missing
         step(:, 1) = 0.0_wp
         do k = 1, nodes
            step(equation(:, k), 1) = merge(given(:, k) - u(:, k), -residual(:, k), is_given(:, k))
         end do
         call dgbsv(n, band, band, 1, tangent, size(tangent, 1), pivots, step, n, info)
         if (info /= 0) error stop 'the tangent is singular'
         do k = 1, nodes
            u(:, k) = u(:, k) + step(equation(:, k), 1)
         end do
      end do
      ! converged: only now the points take their new states
      state = point%state
      print '(2f9.4, f9.3, f8.3, i6, i5, 2x, *(es8.1))', given(:, nodes), -upper_force(2), &
         upper_force(1), count(point%status == status_stick), count(point%status == status_slip), &
         unbalanced(1:iteration - 1)
   end subroutine solve_increment

   !> Residual and tangent at the present displacements.
   subroutine assemble()
      integer :: e, i, k, block, segment(slaves), dofs(8)
      real(wp) :: force(8)

      band = 0
      do e = 1, elements
         dofs = pack(equation(:, element(:, e)), .true.)
         band = max(band, maxval(dofs) - minval(dofs))
      end do
      do i = 1, slaves
         segment(i) = segment_below(slave(i))
         dofs(:6) = pack(equation(:, [slave(i), master(segment(i):segment(i) + 1)]), .true.)
         band = max(band, maxval(dofs(:6)) - minval(dofs(:6)))
      end do
      ! LAPACK wants `band` more rows above for its pivoting
      if (allocated(tangent)) deallocate (tangent)
      allocate (tangent(3*band + 1, n), source=0.0_wp)
      residual = 0.0_wp
      do e = 1, elements
         block = merge(1, 2, e <= nx(1)*ny(1))
         force = matmul(stiffness(:, :, block), pack(u(:, element(:, e)), .true.))
         call add(element(:, e), force, stiffness(:, :, block))
      end do
      do i = 1, slaves
         call add_contact(i, segment(i))
      end do
      do k = 1, nodes
         do i = 1, 2
            if (.not. is_given(i, k)) cycle
            e = equation(i, k)
            call clear_row(e)
            tangent(2*band + 1, e) = 1.0_wp
         end do
      end do
   end subroutine assemble

   !> One contact point: a node of the upper face against a segment of the lower one.
   subroutine add_contact(i, segment)
      integer, intent(in) :: i, segment
      integer :: three(3), side
      real(wp) :: now(2, 3), moved(2, 3), part, length, area, overclosure, slip
      real(wp), dimension(6) :: along, up, along_by_part, up_by_part, by_part, by_overclosure, &
         by_slip
      real(wp) :: local(6, 6)

      three = [slave(i), master(segment), master(segment + 1)]
      now = x(:, three) + u(:, three)
      moved = u(:, three) - start(:, three)
      length = now(1, 3) - now(1, 2)
      part = (now(1, 1) - now(1, 2))/length

      ! relative motion of the node and the place below it, along x and y, and what moves that place
      along = [1.0_wp, 0.0_wp, part - 1.0_wp, 0.0_wp, -part, 0.0_wp]
      up = [0.0_wp, 1.0_wp, 0.0_wp, part - 1.0_wp, 0.0_wp, -part]
      along_by_part = [0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, -1.0_wp, 0.0_wp]
      up_by_part = [0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, -1.0_wp]
      by_part = along/length

      ! overclosure at the end, slip of the increment, and their derivatives by the displacements
      overclosure = -dot_product(up, pack(now, .true.))
      by_overclosure = -up - dot_product(up_by_part, pack(now, .true.))*by_part
      slip = dot_product(along, pack(moved, .true.))
      by_slip = along + dot_product(along_by_part, pack(moved, .true.))*by_part

      ! the law: always from the state at the start of the increment
      call update_contact_point(wood, state(i), overclosure, [slip, 0.0_wp], no_rotation, point(i))

      side = nx(2)
      area = extent(1, 2)/side
      if (i == 1 .or. i == slaves) area = 0.5_wp*area
      associate (p => point(i)%traction(1), tau => point(i)%traction(2), t => point(i)%tangent)
         local = outer(along, t(2, 1)*by_overclosure + t(2, 2)*by_slip) &
            - outer(up, t(1, 1)*by_overclosure + t(1, 2)*by_slip) &
            + outer(tau*along_by_part - p*up_by_part, by_part)
         call add(three, area*(tau*along - p*up), area*local)
      end associate
   end subroutine add_contact

   !> Segment of the lower face that lies below a node.
   integer function segment_below(node)
      integer, intent(in) :: node

      segment_below = count(x(1, master) + u(1, master) <= x(1, node) + u(1, node))
      if (segment_below < 1 .or. segment_below >= masters) &
         error stop 'the upper block has left the lower one'
   end function segment_below

   !> Add forces and stiffness of some nodes to the residual and the tangent.
   subroutine add(which, force, matrix)
      integer, intent(in) :: which(:)
      real(wp), intent(in) :: force(:), matrix(:, :)
      integer :: dofs(2*size(which)), j, k

      dofs = pack(equation(:, which), .true.)
      do j = 1, size(which)
         residual(:, which(j)) = residual(:, which(j)) + force(2*j - 1:2*j)
      end do
      do j = 1, size(dofs)
         do k = 1, size(dofs)
            associate (entry => tangent(2*band + 1 + dofs(k) - dofs(j), dofs(j)))
               entry = entry + matrix(k, j)
            end associate
         end do
      end do
   end subroutine add

   !> Set a row of the tangent to zero.
   subroutine clear_row(row)
      integer, intent(in) :: row
      integer :: column

      do column = max(1, row - band), min(n, row + band)
         tangent(2*band + 1 + row - column, column) = 0.0_wp
      end do
   end subroutine clear_row

   pure function outer(a, b) result(c)
      real(wp), intent(in) :: a(:), b(:)
      real(wp) :: c(size(a), size(b))

      c = spread(a, 2, size(b))*spread(b, 1, size(a))
   end function outer

   !> Force on the top of the upper block, along x or y, N/mm.
   real(wp) function upper_force(direction)
      integer, intent(in) :: direction

      upper_force = sum(residual(direction, :), mask=is_given(direction, :) &
         .and. x(2, :) > corner(2, 2))
   end function upper_force

   !> The tangent against a central difference of the residual, all nodes moved at random.
   subroutine check_tangent(status)
      character(len=*), intent(in) :: status
      real(wp) :: motion(2, nodes), predicted(n), flat(n), forward(2, nodes), kept(2, nodes), error
      real(wp), parameter :: step = 1.0e-6_wp
      integer :: k, row

      call random_number(motion)
      motion = motion - 0.5_wp
      kept = u
      call assemble()
      do k = 1, nodes
         flat(equation(:, k)) = motion(:, k)
      end do
      predicted = [(dot_product([(tangent(2*band + 1 + row - k, k), &
         k=max(1, row - band), min(n, row + band))], &
         flat(max(1, row - band):min(n, row + band))), row=1, n)]
      u = kept + step*motion
      call assemble()
      forward = residual
      u = kept - step*motion
      call assemble()
      forward = (forward - residual)/(2.0_wp*step)
      u = kept
      error = 0.0_wp
      do k = 1, nodes
         error = max(error, maxval(abs(forward(:, k) - predicted(equation(:, k))), &
            mask=.not. is_given(:, k)))
      end do
      error = error/maxval(abs(forward))
      print '(3a, es8.1)', '  tangent, points ', status, ', against differences of the residual:', &
         error
      if (error > 1.0e-7_wp) error stop 'the tangent is wrong'
   end subroutine check_tangent

   !> What must hold, whatever the mesh: forces balance and, all points slipping, shear is mu times
   !> pressure.
   subroutine check_balance()
      real(wp) :: total(2), friction

      total = sum(residual, 2)/upper_force(2)
      friction = upper_force(1)/(wood%friction_coefficient*upper_force(2)) + 1.0_wp
      print '(a, 2es9.1)', '  forces on both blocks, over the normal force:', total
      print '(a, es9.1)', '  shear force over mu times normal force, less 1:', friction
      ! round-off of a solution in millimetres on a slope of some hundred MPa/mm
      if (maxval(abs(total)) > 1.0e-11_wp .or. abs(friction) > 1.0e-11_wp) &
         error stop 'forces do not balance'
   end subroutine check_balance

end program fortran_fe
