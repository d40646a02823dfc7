!> Thinned maps, to see what the sampling step changes.
module asperity_surface_prepare_every_nth
   use asperity_height_map_type, only: height_map
   implicit none
   private
   public :: thinned

contains

   !> Every so-manieth point of a map either way, from its first on; nothing is averaged, as a
   !> coarser measurement would not.
   pure subroutine thinned(map, every, thin)
      !> The map
      type(height_map), intent(in) :: map
      !> Take each of these: 2 for every second; at least 1
      integer, intent(in) :: every
      !> The thinned map
      type(height_map), intent(out) :: thin
      integer :: i, j, stride

      stride = max(every, 1)
      allocate (thin%heights((size(map%heights, 1) - 1)/stride + 1, &
         (size(map%heights, 2) - 1)/stride + 1))
      do j = 1, size(thin%heights, 2)
         do i = 1, size(thin%heights, 1)
            thin%heights(i, j) = map%heights((i - 1)*stride + 1, (j - 1)*stride + 1)
         end do
      end do
      thin%step_x = stride*map%step_x
      thin%step_y = stride*map%step_y
      if (allocated(map%source)) thin%source = map%source
      if (allocated(map%format)) thin%format = map%format
   end subroutine thinned

end module asperity_surface_prepare_every_nth
