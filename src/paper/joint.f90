!> The tests of the tenon joint and the two finite element models of it.
module asperity_paper_joint
   use asperity_base_kinds, only: wp
   implicit none
   private

   !> Amplitudes of the load point, mm, and how many cycles of each (Fig. 22 and the text)
   real(wp), parameter, public :: joint_amplitudes(9) = &
      [0.5_wp, 1.0_wp, 2.0_wp, 4.0_wp, 8.0_wp, 16.0_wp, 24.0_wp, 32.0_wp, 48.0_wp]
   integer, parameter, public :: joint_cycles(9) = [1, 1, 1, 1, 3, 3, 3, 3, 3]

   !> Table 5, negative loading: yield and ultimate moment, kN m, stiffness, kN m/rad
   character(len=*), parameter, public :: published_methods(3) = [character(len=32) :: &
      'test, paper', 'hard contact, paper (OC-FEM)', 'rough law, paper (VC-FEM)']
   real(wp), parameter, public :: published(3, 3) = reshape([ &
      -19.56_wp, -22.14_wp, 181.06_wp, &
      -16.02_wp, -17.91_wp, 154.39_wp, &
      -18.03_wp, -19.84_wp, 163.82_wp], [3, 3])
end module asperity_paper_joint
