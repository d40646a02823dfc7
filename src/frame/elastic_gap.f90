!> OpenSees' ElasticMultiLinear with a gap: no force within it, then straight lines. It goes back
!> the way it came and takes no energy.
module asperity_frame_elastic_gap
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_frame_history, only: frame_history
   use asperity_frame_material, only: frame_command, frame_material
   implicit none
   private
   public :: elastic_gap_material

   !> Straight lines beyond the gap, on each side
   integer, parameter :: lines = 3, n_side = lines + 1

   !> Its numbers; the first point of each side is the end of the gap, without force.
   type, extends(frame_material) :: elastic_gap_material
      !> Points of both sides, all above zero
      real(wp) :: displacement(0:lines, 2) = 0.0_wp, force(0:lines, 2) = 0.0_wp
      !> Outermost displacements of the record
      real(wp) :: outermost(2) = 0.0_wp
   contains
      procedure :: parameters, apply, replay, commands
   end type elastic_gap_material

contains

   !> Parameters with bounds: the gap as a share of the way, and how much the force rises by.
   subroutine parameters(self, history, start, list)
      !> The material
      class(elastic_gap_material), intent(inout) :: self
      !> What it is fitted to
      type(frame_history), intent(in) :: history
      !> Which start
      integer, intent(in) :: start
      !> The parameters
      type(fit_parameter), allocatable, intent(out) :: list(:)
      character(len=9) :: mark
      integer :: side, i, n

      if (start > 1) then
         allocate (list(0))
         return
      end if
      self%outermost = history%outermost
      allocate (list(2*n_side))
      do side = 1, 2
         mark = merge('_positive', '_negative', side == 1)
         n = n_side*(side - 1)
         list(n + 1) = fit_parameter('gap'//mark, '', 0.2_wp, 1.0e-3_wp, 0.95_wp)
         associate (f => history%strongest_force(side))
            do i = 1, lines
               list(n + 1 + i) = fit_parameter('force_'//achar(iachar('0') + i)//mark, '', &
                  f/lines, 1.0e-3_wp*f, 2.0_wp*f)
            end do
         end associate
      end do
   end subroutine parameters

   !> Set the numbers.
   pure subroutine apply(self, values)
      !> The material
      class(elastic_gap_material), intent(inout) :: self
      !> Values in the order of the parameters
      real(wp), intent(in) :: values(:)
      integer :: side, i, n

      do side = 1, 2
         n = n_side*(side - 1)
         associate (d => self%displacement(:, side), far => self%outermost(side))
            d = [(far*(values(n + 1) + (1.0_wp - values(n + 1))*real(i, wp)/lines), i=0, lines)]
         end associate
         self%force(0, side) = 0.0_wp
         do i = 1, lines
            self%force(i, side) = self%force(i - 1, side) + values(n + 1 + i)
         end do
      end do
   end subroutine apply

   !> Force along a path.
   pure subroutine replay(self, displacement, force, error)
      !> The material
      class(elastic_gap_material), intent(in) :: self
      !> Displacements
      real(wp), intent(in) :: displacement(:)
      !> Forces
      real(wp), intent(out) :: force(:)
      !> Never set
      type(error_type), allocatable, intent(out) :: error
      integer :: i, k, side

      do i = 1, size(displacement)
         side = merge(1, 2, displacement(i) > 0.0_wp)
         force(i) = 0.0_wp
         associate (d => self%displacement, f => self%force, x => abs(displacement(i)))
            if (x <= d(0, side)) cycle
            do k = 1, lines - 1
               if (x <= d(k, side)) exit
            end do
            force(i) = sign(f(k - 1, side) + (f(k, side) - f(k - 1, side)) &
               *(x - d(k - 1, side))/(d(k, side) - d(k - 1, side)), displacement(i))
         end associate
      end do
   end subroutine replay

   !> What OpenSees is told.
   pure subroutine commands(self, list)
      !> The material
      class(elastic_gap_material), intent(in) :: self
      !> The command
      type(frame_command), allocatable, intent(out) :: list(:)

      allocate (list(1))
      list(1)%name = 'ElasticMultiLinear'
      associate (d => self%displacement, f => self%force)
         call list(1)%add('-strain', [-d(lines:0:-1, 2), d(:, 1)])
         call list(1)%add('-stress', [-f(lines:0:-1, 2), f(:, 1)])
      end associate
   end subroutine commands

end module asperity_frame_elastic_gap
