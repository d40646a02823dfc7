!> Slave nodes as ABAQUS/Explicit would hold them, with guard cells before and after every array
!> that VUINTER writes to, and every output poisoned before a call. In the precision of VUINTER.
module vuinter_host
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan, ieee_quiet_nan, ieee_value
   use asperity, only: contact_properties, no_rotation, wp
   use asperity_abaqus_props, only: props_from_properties
   use asperity_abaqus_statev, only: n_statev, statev_needed
   use asperity_abaqus_vuinter_precision, only: vp
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   implicit none
   private
   public :: slave_nodes, new_slave_nodes, advance_nodes, stress_of, statev_of, guards_hold, &
      outputs_set, outputs_untouched

   procedure(vuinter_interface) :: vuinter
   integer, parameter :: guard = 16
   !> Time of every increment, s
   real(vp), parameter, public :: time_increment = 0.1_vp
   real(vp), parameter :: guard_value = 8191.5_vp

   !> The arrays of one contact pair. Values count from 1, guard cells lie outside; arrays of
   !> several numbers a node are flat.
   type :: slave_nodes
      !> Components, nodes, state variables
      integer :: n_dir = 3, n_nodes = 0, n_statev = n_statev
      real(vp), allocatable :: props(:)
      !> Numbers of the nodes: 101, 102, ...
      integer, allocatable :: labels(:)
      real(vp), allocatable :: sfd(:), scd(:), spd(:), svd(:), stress(:), flux_slave(:), &
         flux_master(:), sed(:), statev(:)
   end type slave_nodes

contains

   !> Fresh nodes.
   subroutine new_slave_nodes(nodes, n_nodes, properties, n_dir, props, n_slots)
      type(slave_nodes), intent(out) :: nodes
      integer, intent(in) :: n_nodes
      type(contact_properties), intent(in) :: properties
      !> 3 when absent
      integer, intent(in), optional :: n_dir
      !> Another list than the full one of `properties`
      real(vp), intent(in), optional :: props(:)
      !> Length of STATEV; what VUINTER needs when absent
      integer, intent(in), optional :: n_slots
      integer :: i

      nodes%n_nodes = n_nodes
      if (present(n_dir)) nodes%n_dir = n_dir
      nodes%n_statev = statev_needed(properties)
      if (present(n_slots)) nodes%n_statev = n_slots
      nodes%props = real(props_from_properties(properties), vp)
      if (present(props)) nodes%props = props
      nodes%labels = [(100 + i, i=1, n_nodes + 1)]
      call fill(nodes%sfd, n_nodes)
      call fill(nodes%scd, n_nodes)
      call fill(nodes%spd, n_nodes)
      call fill(nodes%svd, n_nodes)
      call fill(nodes%sed, n_nodes)
      call fill(nodes%flux_slave, n_nodes)
      call fill(nodes%flux_master, n_nodes)
      call fill(nodes%stress, n_nodes*nodes%n_dir)
      call fill(nodes%statev, n_nodes*nodes%n_statev)
   end subroutine new_slave_nodes

   !> Zeros between guard cells.
   subroutine fill(cells, n)
      real(vp), allocatable, intent(out) :: cells(:)
      integer, intent(in) :: n

      allocate (cells(1 - guard:n + guard), source=guard_value)
      cells(1:n) = 0.0_vp
   end subroutine fill

   !> One call. Arguments that the law does not need are not numbers.
   subroutine advance_nodes(nodes, overclosure, slip, rotation)
      type(slave_nodes), intent(inout) :: nodes
      !> RDISP(1) of each node, mm
      real(vp), intent(in) :: overclosure(:)
      !> DRDISP(2:), mm; (2, nodes)
      real(vp), intent(in) :: slip(:, :)
      !> DROT; (2, 2, nodes), no rotation when absent
      real(vp), intent(in), optional :: rotation(:, :, :)
      character(len=80), parameter :: surfint = 'WOOD', surfslv = 'SLAVE', surfmst = 'MASTER'
      real(vp), allocatable :: rdisp(:), drdisp(:), drot(:), unused(:)
      real(vp) :: bad
      integer :: n, d, i, k

      bad = ieee_value(1.0_vp, ieee_quiet_nan)
      n = nodes%n_nodes
      d = nodes%n_dir
      allocate (rdisp(n*d + 1), drdisp(n*d + 1), unused(n*d*d + 1), source=bad)
      allocate (drot(4*n + 1), source=bad)
      do i = 1, n
         rdisp(d*(i - 1) + 1) = overclosure(i)
         k = min(d - 1, 2)
         drdisp(d*(i - 1) + 2:d*(i - 1) + 1 + k) = slip(:k, i)
         drot(4*i - 3:4*i) = reshape(real(no_rotation, vp), [4])
         if (present(rotation)) drot(4*i - 3:4*i) = reshape(rotation(:, :, i), [4])
      end do
      nodes%sfd(1:n) = bad
      nodes%scd(1:n) = bad
      nodes%spd(1:n) = bad
      nodes%svd(1:n) = bad
      nodes%sed(1:n) = bad
      nodes%flux_slave(1:n) = bad
      nodes%flux_master(1:n) = bad
      nodes%stress(1:n*d) = bad
      call vuinter( &
         nodes%sfd(1), nodes%scd(1), nodes%spd(1), nodes%svd(1), nodes%stress(1), &
         nodes%flux_slave(1), nodes%flux_master(1), nodes%sed(1), nodes%statev(1), 1, 1, 0, n, 0, &
         d, d, nodes%n_statev, size(nodes%props), 0, 0, 0, nodes%labels, nodes%labels, &
         nodes%labels, time_increment, time_increment, time_increment, surfint, surfslv, surfmst, &
         rdisp, drdisp, drot, &
         unused, unused, unused, unused, unused, unused, nodes%props, unused, unused, unused, &
         unused, unused, unused, unused, unused, unused)
   end subroutine advance_nodes

   !> Pressure and two shear stresses of a node, in double precision; zero for what is not there.
   pure function stress_of(nodes, node) result(stress)
      type(slave_nodes), intent(in) :: nodes
      integer, intent(in) :: node
      real(wp) :: stress(3)

      stress = 0.0_wp
      associate (d => nodes%n_dir)
         stress(:d) = real(nodes%stress(d*(node - 1) + 1:d*node), wp)
      end associate
   end function stress_of

   !> STATEV of a node, in double precision.
   pure function statev_of(nodes, node) result(statev)
      type(slave_nodes), intent(in) :: nodes
      integer, intent(in) :: node
      real(wp) :: statev(nodes%n_statev)

      associate (s => nodes%n_statev)
         statev = real(nodes%statev(s*(node - 1) + 1:s*node), wp)
      end associate
   end function statev_of

   !> Nothing was written outside the arrays.
   pure logical function guards_hold(nodes)
      type(slave_nodes), intent(in) :: nodes

      associate (n => nodes%n_nodes)
         guards_hold = held(nodes%sfd, n) .and. held(nodes%scd, n) .and. held(nodes%spd, n) &
            .and. held(nodes%svd, n) .and. held(nodes%sed, n) .and. held(nodes%flux_slave, n) &
            .and. held(nodes%flux_master, n) .and. held(nodes%stress, n*nodes%n_dir) &
            .and. held(nodes%statev, n*nodes%n_statev)
      end associate
   end function guards_hold

   pure logical function held(cells, n)
      real(vp), allocatable, intent(in) :: cells(:)
      integer, intent(in) :: n

      held = all(ieee_is_finite(cells(:0))) .and. all(ieee_is_finite(cells(n + 1:)))
      if (held) held = all(abs(cells(:0) - guard_value) <= 0.0_vp) &
         .and. all(abs(cells(n + 1:) - guard_value) <= 0.0_vp)
   end function held

   !> Every output holds a number.
   pure logical function outputs_set(nodes)
      type(slave_nodes), intent(in) :: nodes

      associate (n => nodes%n_nodes)
         outputs_set = all(ieee_is_finite(nodes%stress(1:n*nodes%n_dir))) &
            .and. all(ieee_is_finite(nodes%statev(1:n*nodes%n_statev))) &
            .and. all(ieee_is_finite([nodes%sfd(1:n), nodes%scd(1:n), nodes%spd(1:n), &
            nodes%svd(1:n), nodes%sed(1:n), nodes%flux_slave(1:n), nodes%flux_master(1:n)]))
      end associate
   end function outputs_set

   !> Every output still holds the poison.
   pure logical function outputs_untouched(nodes)
      type(slave_nodes), intent(in) :: nodes

      associate (n => nodes%n_nodes)
         outputs_untouched = all(ieee_is_nan(nodes%stress(1:n*nodes%n_dir))) &
            .and. all(ieee_is_nan([nodes%sfd(1:n), nodes%scd(1:n), nodes%spd(1:n), nodes%svd(1:n), &
            nodes%sed(1:n), nodes%flux_slave(1:n), nodes%flux_master(1:n)]))
      end associate
   end function outputs_untouched

end module vuinter_host
