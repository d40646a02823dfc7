!> Contenders: UINTER as ABAQUS/Standard calls it, a point a call through its 47 arguments, and
!> VUINTER as ABAQUS/Explicit does, all points of a pair in one call through its 49.
module bench_uinter
   use asperity, only: contact_properties, error_type, no_rotation, wp
   use asperity_abaqus_prop_slots, only: prop_unloading
   use asperity_abaqus_props, only: properties_from_props
   use asperity_abaqus_statev, only: n_statev
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use bench_cases, only: contact_set
   use bench_timing, only: contender
   implicit none
   private
   public :: props_reader, uinter_caller, vuinter_caller, new_vuinter_caller

   procedure(uinter_interface) :: uinter
   procedure(vuinter_interface) :: vuinter

   !> ABAQUS/Standard. Time includes the copy of STATEV that the next increment starts from.
   type, extends(contender) :: uinter_caller
      type(contact_set) :: set
   contains
      procedure :: pass => pass_uinter
   end type uinter_caller

   !> What UINTER does before it comes to the point, and what a cache of properties would spare it.
   type, extends(contender) :: props_reader
      type(contact_set) :: set
   contains
      procedure :: pass => pass_props
   end type props_reader

   !> ABAQUS/Explicit, in double precision. Time includes the copy of STATEV, too.
   type, extends(contender) :: vuinter_caller
      type(contact_set) :: set
      !> Results
      real(wp), allocatable :: statev(:, :), stress(:, :), energy(:, :), flux(:, :)
      !> What VUINTER is given and does not use, of every shape
      integer, allocatable :: number(:), facet(:, :)
      real(wp), allocatable :: per_point(:), per_facet(:, :), per_field(:, :), place(:, :), &
         axes(:, :, :), rotation(:, :, :)
   contains
      procedure :: pass => pass_vuinter
   end type vuinter_caller

   character(len=80), parameter :: wood = 'WOOD', slave = 'SLAVE', master = 'MASTER'

contains

   subroutine pass_uinter(this)
      class(uinter_caller), intent(inout) :: this
      real(wp), dimension(3, 3) :: ddsddr, dviscous, dstructural, axes
      real(wp) :: stress(3), flux(2), ddfddt(2, 2), ddsddt(3, 2), ddfddr(2, 3), statev(n_statev)
      real(wp) :: sed, sfd, spd, svd, scd, pnewdt
      real(wp), dimension(2) :: none
      real(wp) :: fields(2, 1)
      integer :: lopenclose, lstate, lsdi, i

      none = 0.0_wp
      fields = 0.0_wp
      axes = 0.0_wp
      pnewdt = 1.0_wp
      lopenclose = 1
      lstate = 0
      lsdi = 0
      stress = 0.0_wp
      do i = 1, this%points
         associate (set => this%set)
            statev = set%statev(:, i)
            call uinter(stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, &
               statev, sed, sfd, spd, svd, scd, pnewdt, set%position(:, i), set%motion(:, i), &
               none, none, fields, fields, none, 1.0_wp, 0.0_wp, wood, slave, master, &
               set%props(:, set%which(i)), axes(:, 1), axes, no_rotation, 1.0_wp, 1.0_wp, i, 3, &
               n_statev, 1, prop_unloading, 3, 1, 1, 0, 0, lopenclose, lstate, lsdi, 0)
         end associate
         this%checksum = this%checksum + stress(1) + ddsddr(3, 2) + sed + sfd + statev(1)
      end do
   end subroutine pass_uinter

   subroutine pass_props(this)
      class(props_reader), intent(inout) :: this
      type(contact_properties) :: properties
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, this%points
         call properties_from_props(this%set%props(:, this%set%which(i)), properties, error)
         this%checksum = this%checksum + properties%p_open
      end do
   end subroutine pass_props

   !> All points of a set, which must share one set of properties.
   subroutine new_vuinter_caller(caller, set)
      type(vuinter_caller), intent(out) :: caller
      type(contact_set), intent(in) :: set
      integer :: n

      n = size(set%which)
      caller%set = set
      caller%points = n
      allocate (caller%number(n), source=1)
      allocate (caller%facet(4, n), source=1)
      allocate (caller%statev(n_statev, n), caller%stress(3, n), caller%energy(n, 5), &
         caller%flux(n, 2), caller%per_point(n), caller%per_facet(4, n), caller%per_field(1, n), &
         caller%place(3, n), caller%axes(3, 3, n), source=0.0_wp)
      caller%rotation = spread(no_rotation, 3, n)
   end subroutine new_vuinter_caller

   subroutine pass_vuinter(this)
      class(vuinter_caller), intent(inout) :: this
      real(wp) :: one(1), one_field(1, 1)

      one = 0.0_wp
      one_field = 0.0_wp
      this%statev = this%set%statev
      call vuinter(this%energy(:, 1), this%energy(:, 2), this%energy(:, 3), this%energy(:, 4), &
         this%stress, this%flux(:, 1), this%flux(:, 2), this%energy(:, 5), this%statev, 1, 1, 4, &
         this%points, 1, 1, 3, n_statev, prop_unloading, 0, 1, 1, this%number, [1], this%facet, &
         1.0_wp, 1.0_wp, 1.0_wp, wood, slave, master, this%set%position, this%set%motion, &
         this%rotation, &
         this%per_point, this%per_point, this%per_facet, this%place, this%place(:, :1), &
         this%axes, this%set%props(:, 1), this%per_point, this%per_point, this%per_point, &
         this%per_field, this%per_field, one, one, one_field, one_field)
      this%checksum = this%checksum + sum(this%stress) + sum(this%statev(1, :)) &
         + sum(this%energy(:, [1, 5]))
   end subroutine pass_vuinter

end module bench_uinter
