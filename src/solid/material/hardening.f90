!> Yield stress over the equivalent plastic strain: straight pieces that never fall.
module asperity_solid_material_hardening
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: hardening_curve, new_hardening_curve, piece_of, yield_stress

   !> The pieces; the last one has no end.
   type :: hardening_curve
      !> Where they begin, rising from 0
      real(wp), allocatable :: strains(:)
      !> Yield stress there, and its slopes from there on, MPa
      real(wp), allocatable :: stresses(:), slopes(:)
   end type hardening_curve

contains

   !> Pieces from point to point, and on from the last one.
   pure function new_hardening_curve(strains, stresses, last_slope) result(curve)
      !> Strains, rising from 0, and stresses that do not fall, MPa
      real(wp), intent(in) :: strains(:), stresses(:)
      !> Slope after the last point, not below zero, MPa
      real(wp), intent(in) :: last_slope
      type(hardening_curve) :: curve
      integer :: i, n

      n = size(strains)
      allocate (curve%strains(n), curve%stresses(n), curve%slopes(n))
      do i = 1, n
         curve%strains(i) = strains(i)
         curve%stresses(i) = stresses(i)
         curve%slopes(i) = last_slope
         if (i < n) curve%slopes(i) = &
            (stresses(i + 1) - stresses(i))/(strains(i + 1) - strains(i))
      end do
   end function new_hardening_curve

   !> Number of the piece in which a strain, not below zero, lies.
   pure integer function piece_of(curve, strain) result(piece)
      !> The pieces
      type(hardening_curve), intent(in) :: curve
      !> Equivalent plastic strain
      real(wp), intent(in) :: strain

      do piece = size(curve%strains), 2, -1
         if (strain >= curve%strains(piece)) return
      end do
      piece = 1
   end function piece_of

   !> Yield stress, MPa.
   pure real(wp) function yield_stress(curve, strain)
      !> The pieces
      type(hardening_curve), intent(in) :: curve
      !> Equivalent plastic strain
      real(wp), intent(in) :: strain
      integer :: piece

      piece = piece_of(curve, strain)
      yield_stress = curve%stresses(piece) + curve%slopes(piece)*(strain - curve%strains(piece))
   end function yield_stress

end module asperity_solid_material_hardening
