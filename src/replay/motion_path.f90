!> A given motion of a contact point, with what it is expected to answer.
module asperity_replay_motion_path
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: motion_path

   !> Names of the tractions, as in columns of files
   character(len=*), parameter, public :: traction_names(3) = [character(len=8) :: 'pressure', &
      'shear_1', 'shear_2']

   !> One row an increment, the state of its end; before the first row nothing is opposite.
   type :: motion_path
      !> Total time, rising, s
      real(wp), allocatable :: time(:)
      !> How far the faces have passed each other, mm; -1.E36 is no opposite surface
      real(wp), allocatable :: overclosure(:)
      !> Slip since the start in both slip directions, shape (2, rows), mm
      real(wp), allocatable :: slip(:, :)
      !> Tractions expected at the end, shape (3, rows), MPa: pressure, both shear stresses
      real(wp), allocatable :: expected(:, :)
      !> Which of them the path has
      logical :: has_expected(3) = .false.
   contains
      procedure :: lengths
   end type motion_path

contains

   !> Lengths of the increments, s. Where the first row is at time zero, the increment that led
   !> there is as long as the next one, as none is without length; 1 s where there is no next one.
   pure function lengths(path)
      !> The path, with a row at least
      class(motion_path), intent(in) :: path
      real(wp) :: lengths(size(path%time))
      integer :: n

      n = size(path%time)
      lengths(2:) = path%time(2:) - path%time(:n - 1)
      lengths(1) = path%time(1)
      if (lengths(1) > 0.0_wp) return
      lengths(1) = 1.0_wp
      if (n > 1) lengths(1) = lengths(2)
   end function lengths

end module asperity_replay_motion_path
