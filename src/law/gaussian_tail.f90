!> Moments of the upper tail of the standard normal density phi without loss of digits:
!> F_n(y) = integral_0^inf t^n phi(t + y) dt for n = 0, 1, 2.
module asperity_law_gaussian_tail
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: find_tail_moments, density_reach

   !> From here on exp(-y^2/2), and with it the density, is zero in double precision
   real(wp), parameter, public :: vanishing_height = 39.0_wp
   !> 1/sqrt(2 pi)
   real(wp), parameter, public :: phi_0 = 0.398942280401432677939946_wp
   real(wp), parameter :: sqrt_half = 0.707106781186547524400844_wp
   !> The density is cut where it falls to exp(-45) of its largest value
   real(wp), parameter :: cut = 45.0_wp

   !> (y + shift) F_2/F_1 on equal intervals of u = 1/(y + shift), 0 <= u <= 1/shift, by powers of
   !> the local variable -1..1; from test/reference/gaussian_tail_constants.py, error 3e-17
   real(wp), parameter :: shift = 4.0_wp
   integer, parameter :: degree = 12, intervals = 6
   real(wp), parameter :: c(0:degree, 0:intervals - 1) = reshape([ &
      2.1784494277520991052_wp, 0.19071725054114274484_wp, 0.012734769343233370546_wp, &
      0.00044318767024916836636_wp, -0.000029924078617187449577_wp, &
      -6.6996010023697882412e-6_wp, -5.4410606719384835017e-7_wp, -5.9480057322802313998e-9_wp, &
      4.2836220191271825682e-9_wp, 5.5630991848544302123e-10_wp, 2.1691140537274786062e-11_wp, &
      -3.3124181217054387287e-12_wp, -5.7995024879554452928e-13_wp, &
      2.6136411453718374933_wp, 0.24537963548491723699_wp, 0.014015522506818007868_wp, &
      -0.00014378484523013349413_wp, -0.00012411671832237381937_wp, &
      -0.000010672848458605115285_wp, 2.1406691437961130739e-7_wp, 1.3072739109446553743e-7_wp, &
      9.1889652339331738833e-9_wp, -6.8948557037152686172e-10_wp, -1.6197372522242647953e-10_wp, &
      -4.1140547227738175553e-12_wp, 1.5436016795005742326e-12_wp, &
      3.1570170941958172617_wp, 0.29499739775849004291_wp, 0.009470832306371817104_wp, &
      -0.0014458800420801793331_wp, -0.00017601106649603081555_wp, 4.3605590929842993476e-6_wp, &
      2.1153408874359934769e-6_wp, 4.959458180043027065e-8_wp, -2.2461143700289330323e-8_wp, &
      -1.4411162490708946959e-9_wp, 2.1935731027635540377e-10_wp, 2.3103531014781880442e-11_wp, &
      -1.9196245364543624899e-12_wp, &
      3.7707870445899832305_wp, 0.31065002962673818026_wp, -0.0025827258135934097302_wp, &
      -0.0023572343165792150482_wp, -0.000018947960920139622874_wp, &
      0.000023140077989746398983_wp, 2.4946930439819188919e-7_wp, -2.5387624521660300452e-7_wp, &
      -8.9635960941811872989e-10_wp, 2.8940341117018529072e-9_wp, -3.0075825967304450857e-11_wp, &
      -3.1652900801473226706e-11_wp, 8.9247433012641607609e-13_wp, &
      4.3633202723569415927_wp, 0.27321661636412126409_wp, -0.015429832011362335737_wp, &
      -0.0016731667025793260496_wp, 0.00016544035251742138521_wp, 9.2180522418890277838e-6_wp, &
      -1.9315248119077561122e-6_wp, -2.0735269129325226122e-9_wp, 1.9377282663026450607e-8_wp, &
      -9.8473350492442165708e-10_wp, -1.4449543256004298235e-10_wp, &
      1.7501554982959567683e-11_wp, 4.6881454254009233469e-13_wp, &
      4.8374713293102445214_wp, 0.19709607936601026898_wp, -0.021196748245365898826_wp, &
      -0.00026315606498777050253_wp, 0.00015769396923238155089_wp, -8.0809622927219210194e-6_wp, &
      -6.8067854498867427759e-7_wp, 1.1648568840225049104e-7_wp, -3.2716574811125620483e-9_wp, &
      -7.3253129865862716879e-10_wp, 8.7561392927043137192e-11_wp, &
      -6.6925881644716493914e-13_wp, -6.8655929266162702509e-13_wp], [13, 6])

contains

   !> Scaled moments: F_n(y) = moments(n) exp(-max(y, 0)^2/2), n = 0, 1, 2.
   !> For y > 0 the closed forms phi - y Q and (1 + y^2) Q - y phi lose 13 digits by y = 37. There
   !> all follow from the ratio F_2/F_1 by sums of positive terms: F_0 = F_2 + y F_1 and
   !> phi = F_1 + y F_0.
   pure subroutine find_tail_moments(y, moments)
      !> Lower end of the tail; any finite value up to 1e150 in size
      real(wp), intent(in) :: y
      !> The three moments
      real(wp), intent(out) :: moments(0:2)
      real(wp) :: u, x, x2, x4, ratio
      integer :: i

      if (y > 0.0_wp) then
         u = 1.0_wp/(y + shift)
         x = (2*intervals*shift)*u
         i = min(int(0.5_wp*x), intervals - 1)
         x = x - real(2*i + 1, wp)
         x2 = x*x
         x4 = x2*x2
         ratio = u*((((c(0, i) + c(1, i)*x) + x2*(c(2, i) + c(3, i)*x)) &
            + x4*((c(4, i) + c(5, i)*x) + x2*(c(6, i) + c(7, i)*x))) &
            + x4*x4*(((c(8, i) + c(9, i)*x) + x2*(c(10, i) + c(11, i)*x)) + x4*c(12, i)))
         moments(1) = phi_0/(1.0_wp + y*(y + ratio))
         moments(2) = ratio*moments(1)
         moments(0) = (ratio + y)*moments(1)
      else
         moments(0) = 0.5_wp*erfc(sqrt_half*y)
         moments(1) = phi_0*exp(-0.5_wp*y*y) - y*moments(0)
         moments(2) = moments(0) - y*moments(1)
      end if
   end subroutine find_tail_moments

   !> How far from y, away from zero, the density phi matters: where it is exp(-45) phi(y).
   pure elemental real(wp) function density_reach(y)
      !> Any finite value up to 1e150 in size
      real(wp), intent(in) :: y

      density_reach = 2.0_wp*cut/(sqrt(y*y + 2.0_wp*cut) + abs(y))
   end function density_reach

end module asperity_law_gaussian_tail
