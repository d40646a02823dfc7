!> The state of a solid joint at a time that deserves a look: contact cell by cell, wood element by
!> element.
module asperity_program_commands_solid_snapshot
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: status_open
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: solid_run
   implicit none
   private
   public :: solid_snapshot, contact_value, snapshot_kind, take_snapshot, mean_stress

   !> What is seen: nothing; a peak of the first cycle of the largest amplitude, and the joint when
   !> it is a little unloaded from there
   enum, bind(c)
      enumerator :: no_snapshot = 0
      enumerator :: upper_peak
      enumerator :: upper_unloaded
      enumerator :: lower_peak
      enumerator :: lower_unloaded
   end enum
   public :: no_snapshot, upper_peak, upper_unloaded, lower_peak, lower_unloaded

   !> Way back from a peak over the largest amplitude at which the joint is unloaded
   real(wp), parameter :: unloading = 0.02_wp
   !> Displacements over the largest that are alike
   real(wp), parameter :: alike = 1.0e-9_wp

   !> One cell of a slave face.
   type :: contact_value
      !> Number of its pair
      integer :: pair = 0
      !> Place of its middle, and how far it reaches along each axis, undeformed, mm
      real(wp) :: position(3) = 0.0_wp, extent(3) = 0.0_wp
      !> Area, mm^2; share of it that has a surface opposite; gap, mm
      real(wp) :: area = 0.0_wp, coverage = 0.0_wp, gap = 0.0_wp
      !> Pressure and shear stresses, MPa
      real(wp) :: pressure = 0.0_wp, shear(2) = 0.0_wp
      !> `status_open` and its like
      integer :: status = status_open
   end type contact_value

   !> A state of the half joint.
   type :: solid_snapshot
      !> `upper_peak` and its like, and stroke
      integer :: kind = no_snapshot, stroke = 0
      !> Displacement of the load point, mm
      real(wp) :: displacement = 0.0_wp
      !> All contact cells, pair by pair
      type(contact_value), allocatable :: contact(:)
      !> Of each element: largest equivalent plastic strain, and mean stress, MPa
      real(wp), allocatable :: plastic_strain(:), stress(:, :)
   end type solid_snapshot

contains

   !> What the run shows after its last increment, `no_snapshot` where there is nothing to keep.
   pure integer function snapshot_kind(run)
      !> The run
      type(solid_run), intent(in) :: run
      integer :: n

      snapshot_kind = no_snapshot
      n = size(run%records)
      if (n == 0) return
      snapshot_kind = kind_of(run%model%turns, run%records(n)%stroke, run%records(n)%displacement)
      ! the first increment that is unloaded
      if (.not. is_unloaded(snapshot_kind) .or. n == 1) return
      if (kind_of(run%model%turns, run%records(n - 1)%stroke, run%records(n - 1)%displacement) &
         == snapshot_kind) snapshot_kind = no_snapshot
   end function snapshot_kind

   pure logical function is_unloaded(kind)
      integer, intent(in) :: kind

      is_unloaded = kind == upper_unloaded .or. kind == lower_unloaded
   end function is_unloaded

   !> What a displacement in a stroke is, whether or not it is the first to be that.
   pure integer function kind_of(turns, stroke, displacement)
      !> Turns of the programme, from 0, mm
      real(wp), intent(in) :: turns(:)
      !> Number of the stroke; it goes from the turn of that number to the next
      integer, intent(in) :: stroke
      !> Displacement, mm
      real(wp), intent(in) :: displacement
      real(wp), parameter :: sides(2) = [1.0_wp, -1.0_wp]
      integer, parameter :: peaks(2) = [upper_peak, lower_peak], &
         after(2) = [upper_unloaded, lower_unloaded]
      real(wp) :: largest
      integer :: side, peak

      largest = maxval(abs(turns))
      kind_of = no_snapshot
      do side = 1, 2
         ! the first turn of that amplitude ends the stroke before
         do peak = 2, size(turns)
            if (sides(side)*turns(peak) >= (1.0_wp - alike)*largest) exit
         end do
         if (peak > size(turns)) cycle
         if (stroke == peak - 1 .and. abs(displacement - turns(peak)) <= alike*largest) &
            kind_of = peaks(side)
         if (stroke == peak .and. abs(displacement - turns(peak)) >= unloading*largest) &
            kind_of = after(side)
      end do
   end function kind_of

   !> Keep the present state of a run.
   pure function take_snapshot(run, kind) result(snapshot)
      !> The run
      type(solid_run), intent(in) :: run
      !> What it shows
      integer, intent(in) :: kind
      type(solid_snapshot) :: snapshot
      integer :: i

      associate (model => run%model, record => run%records(size(run%records)))
         snapshot%kind = kind
         snapshot%stroke = record%stroke
         snapshot%displacement = record%displacement
         allocate (snapshot%contact, source=contact_values(model))
         allocate (snapshot%plastic_strain, source=maxval((model%points%equivalent_strain), 1))
         allocate (snapshot%stress(6, size(model%points, 2)))
         do i = 1, size(model%points, 2)
            snapshot%stress(:, i) = mean_stress(model, i)
         end do
      end associate
   end function take_snapshot

   !> All contact cells of a joint.
   pure function contact_values(model) result(values)
      type(solid_model), intent(in) :: model
      type(contact_value), allocatable :: values(:)
      integer :: i, j, k, n

      n = 0
      do i = 1, size(model%pairs)
         do j = 1, size(model%pairs(i)%faces)
            n = n + size(model%pairs(i)%faces(j)%cells)
         end do
      end do
      allocate (values(n))
      n = 0
      do i = 1, size(model%pairs)
         do j = 1, size(model%pairs(i)%faces)
            do k = 1, size(model%pairs(i)%faces(j)%cells)
               n = n + 1
               associate (cell => model%pairs(i)%faces(j)%cells(k))
                  values(n) = contact_value(i, cell%position, sum(abs(cell%edges), 2), &
                     cell%area, cell%coverage, cell%gap, cell%trial%traction(1), &
                     cell%trial%traction(2:3), cell%trial%status)
                  ! what has no surface opposite has no gap
                  if (.not. cell%coverage > 0.0_wp) values(n)%gap = 0.0_wp
               end associate
            end do
         end do
      end do
   end function contact_values

   !> Mean stress of an element, MPa.
   pure function mean_stress(model, element) result(stress)
      !> The joint
      type(solid_model), intent(in) :: model
      !> Number of the element
      integer, intent(in) :: element
      real(wp) :: stress(6)
      integer :: i

      stress = 0.0_wp
      do i = 1, size(model%points, 1)
         stress = stress + model%points(i, element)%stress/size(model%points, 1)
      end do
   end function mean_stress

end module asperity_program_commands_solid_snapshot
