!> Calls UINTER for points that stick or slip at h = d/sigma = 1..5, or VUINTER for as many at a
!> time as is asked for: what count.sh counts the instructions of. It uses no more of the library
!> than older builds have, so that both can be counted. Pair transverse-tangential of the paper.
!>
!>     calls stick|slip|nodes POINTS
program calls
   use abaqus_stubs, only: messages
   use asperity, only: contact_properties, contact_response, contact_state, error_type, find_pair, &
      new_contact_properties, no_rotation, pair_preset, update_contact_point, wp
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   implicit none
   procedure(uinter_interface) :: uinter
   procedure(vuinter_interface) :: vuinter
   real(wp), parameter :: props(12) = [0.5_wp, 0.31_wp, 206.0_wp, 297.0_wp, 3.14159265_wp, &
      0.1477_wp, 24.53_wp, 0.4_wp, 0.0593_wp, 0.2372_wp, 1.0_wp, 1.0_wp]
   !> DEPVAR of UINTER with plain friction
   integer, parameter :: n_statev = 11
   real(wp), parameter :: h_min = 1.0_wp, h_max = 5.0_wp, golden = 0.6180339887498949_wp
   character(len=80), parameter :: wood = 'WOOD', slave = 'SLAVE', master = 'MASTER'
   character(len=16) :: word
   real(wp), allocatable :: statev(:, :), position(:, :), motion(:, :)
   integer :: points, i

   call get_command_argument(2, word)
   read (word, *) points
   call get_command_argument(1, word)
   allocate (statev(n_statev, points), position(3, points), motion(3, points))
   call place_points(merge(3.0_wp, 0.05_wp, word == 'slip'))
   if (word == 'nodes') then
      call call_vuinter()
   else
      do i = 1, points
         call call_uinter(i)
      end do
   end if
   if (messages > 0) error stop 'the points are not within the limits of the law'

contains

   !> Points closed and a little slipped, and an increment that moves them by so many gcrit: they
   !> stick for 0.05 and slip for 3. Separations fill 1..5 sigma in no order.
   subroutine place_points(slip)
      real(wp), intent(in) :: slip
      type(contact_properties) :: properties
      type(contact_response) :: response
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      integer :: i

      call find_pair('transverse-tangential', pair, error)
      if (.not. allocated(error)) call new_contact_properties(properties, pair, error)
      if (allocated(error)) error stop 'the properties are refused'
      statev = 0.0_wp
      associate (p => properties)
         do i = 1, points
            position(:, i) = [p%initial_separation &
               - (h_min + (h_max - h_min)*modulo(i*golden, 1.0_wp))*p%normal%sigma, &
               0.24_wp*p%critical_slip, 0.18_wp*p%critical_slip]
            motion(:, i) = [0.01_wp*p%normal%sigma, slip*p%critical_slip, 0.0_wp]
            call update_contact_point(p, contact_state(), position(1, i) - motion(1, i), &
               position(2:, i), no_rotation, response)
            associate (s => response%state)
               statev(:, i) = [real(s%status, wp), s%overclosure, s%pressure, s%normal_energy, &
                  s%elastic_slip, s%largest_closure, s%dissipation, s%pressure_coupling, &
                  real(s%validity, wp), 0.0_wp]
            end associate
            position(2, i) = position(2, i) + motion(2, i)
         end do
      end associate
   end subroutine place_points

   subroutine call_uinter(i)
      integer, intent(in) :: i
      real(wp), dimension(3, 3) :: ddsddr, dviscous, dstructural, axes
      real(wp) :: stress(3), flux(2), ddfddt(2, 2), ddsddt(3, 2), ddfddr(2, 3), fields(2, 1)
      real(wp) :: none(2)
      real(wp) :: sed, sfd, spd, svd, scd, pnewdt
      integer :: lopenclose, lstate, lsdi

      none = 0.0_wp
      fields = 0.0_wp
      axes = 0.0_wp
      lsdi = 0
      call uinter(stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, &
         statev(:, i), sed, sfd, spd, svd, scd, pnewdt, position(:, i), motion(:, i), none, none, &
         fields, fields, none, 1.0_wp, 0.0_wp, wood, slave, master, props, axes(:, 1), axes, &
         no_rotation, 1.0_wp, 1.0_wp, i, 3, n_statev, 1, size(props), 3, 1, 1, 1, 0, lopenclose, &
         lstate, lsdi, 0)
      if (lstate /= merge(3, 2, word == 'slip')) error stop 'a point does not do what it should'
   end subroutine call_uinter

   subroutine call_vuinter()
      real(wp), allocatable :: stress(:, :), energy(:, :), flux(:, :), per_point(:), &
         per_facet(:, :), per_field(:, :), place(:, :), axes(:, :, :), rotation(:, :, :)
      integer, allocatable :: number(:), facet(:, :)
      real(wp) :: one(1), one_field(1, 1)

      allocate (stress(3, points), energy(points, 5), flux(points, 2), per_point(points), &
         per_facet(4, points), per_field(1, points), place(3, points), axes(3, 3, points), &
         source=0.0_wp)
      allocate (number(points), facet(4, points), source=1)
      rotation = spread(no_rotation, 3, points)
      one = 0.0_wp
      one_field = 0.0_wp
      call vuinter(energy(:, 1), energy(:, 2), energy(:, 3), energy(:, 4), stress, flux(:, 1), &
         flux(:, 2), energy(:, 5), statev, 1, 1, 4, points, 1, 1, 3, n_statev, size(props), 0, 1, &
         1, number, [1], facet, 1.0_wp, 1.0_wp, 1.0_wp, wood, slave, master, position, motion, &
         rotation, per_point, per_point, per_facet, place, place(:, :1), axes, props, per_point, &
         per_point, per_point, per_field, per_field, one, one, one_field, one_field)
   end subroutine call_vuinter

end program calls
