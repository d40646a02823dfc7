!> Two rough faces as the one pair of numbers that the law takes: E* of both (Eq. 4), the hardness
!> of one of them, and the summits of their sum.
module asperity_faces_two_faces
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_faces_face, only: check_face, face
   use asperity_faces_nayak, only: moments_of_summits, nayak_summits, nayak_type
   use asperity_law_normal_properties, only: equivalent_modulus
   use asperity_paper_pairs, only: pair_preset, pairs
   implicit none
   private
   public :: pair_from_faces, sum_of_summits

   !> Whose hardness the law takes
   enum, bind(c)
      !> That of the softer face, as the text of the paper says of Eq. 26
      enumerator :: hardness_softer = 1
      !> That of the harder face, as Table 4 has it
      enumerator :: hardness_harder
   end enum
   public :: hardness_softer, hardness_harder

   !> Whose summits the law takes
   enum, bind(c)
      !> Those of the sum of both faces, whose spectral moments add
      enumerator :: roughness_moments = 1
      !> Those of one face, the other being smooth; the paper takes the rougher one's
      enumerator :: roughness_face_1
      enumerator :: roughness_face_2
   end enum
   public :: roughness_moments, roughness_face_1, roughness_face_2

contains

   !> The pair that two faces make. Yield factor, friction and critical slip are those of the pairs
   !> of the paper, which agree; change them in `pair` before it is built upon. `error` names the
   !> number of a face that cannot be, such as `sigma_1`, or the rule that is unknown.
   pure subroutine pair_from_faces(face_1, face_2, pair, error, hardness_rule, roughness_rule)
      !> The faces
      type(face), intent(in) :: face_1, face_2
      !> The pair, such as `new_contact_properties` takes
      type(pair_preset), intent(out) :: pair
      !> Set when it cannot be
      type(error_type), allocatable, intent(out) :: error
      !> `hardness_softer` (default) or `hardness_harder`
      integer, intent(in), optional :: hardness_rule
      !> `roughness_moments` (default), `roughness_face_1` or `roughness_face_2`
      integer, intent(in), optional :: roughness_rule
      type(nayak_type) :: summits
      integer :: rules(2)

      rules = [hardness_softer, roughness_moments]
      if (present(hardness_rule)) rules(1) = hardness_rule
      if (present(roughness_rule)) rules(2) = roughness_rule
      call check_face(face_1, '1', rules(2) /= roughness_face_2, error)
      call check_face(face_2, '2', rules(2) /= roughness_face_1, error)
      if (allocated(error)) return
      if (rules(1) < hardness_softer .or. rules(1) > hardness_harder) then
         call fatal_error(error, 'hardness_rule = '//to_text(rules(1))// &
            ' is unknown: 1 is softer, 2 is harder', subject='hardness_rule')
         return
      else if (rules(2) < roughness_moments .or. rules(2) > roughness_face_2) then
         call fatal_error(error, 'roughness_rule = '//to_text(rules(2))// &
            ' is unknown: 1 is moments, 2 is face_1, 3 is face_2', subject='roughness_rule')
         return
      end if

      pair%name = 'two faces'
      pair%yield_factor = pairs(1)%yield_factor
      pair%friction_coefficient = pairs(1)%friction_coefficient
      pair%critical_slip = pairs(1)%critical_slip
      pair%modulus = equivalent_modulus(face_1%young_modulus, face_1%poisson_ratio, &
         face_2%young_modulus, face_2%poisson_ratio)
      pair%hardness = min(face_1%hardness, face_2%hardness)
      if (rules(1) == hardness_harder) pair%hardness = max(face_1%hardness, face_2%hardness)
      select case (rules(2))
      case (roughness_face_1)
         call take_summits(pair, face_1)
      case (roughness_face_2)
         call take_summits(pair, face_2)
      case default
         summits = sum_of_summits(face_1, face_2)
         pair%eta = summits%density
         pair%radius = 1.0_wp/summits%curvature
         pair%sigma = sqrt(summits%variance)
      end select
   end subroutine pair_from_faces

   !> The summits of one face.
   pure subroutine take_summits(pair, one)
      type(pair_preset), intent(inout) :: pair
      type(face), intent(in) :: one

      pair%eta = one%eta
      pair%radius = one%radius
      pair%sigma = one%sigma
   end subroutine take_summits

   !> The summits of the sum of two faces that know nothing of each other: mean squares of heights,
   !> slopes and curvatures add. alpha of the sum is never below the lesser of both.
   pure function sum_of_summits(face_1, face_2) result(summits)
      !> The faces, with numbers above zero
      type(face), intent(in) :: face_1, face_2
      type(nayak_type) :: summits
      real(wp) :: first(3), second(3)

      call moments_of_summits(face_1%eta, face_1%radius, face_1%sigma, first(1), first(2), first(3))
      call moments_of_summits(face_2%eta, face_2%radius, face_2%sigma, second(1), second(2), &
         second(3))
      first = first + second
      summits = nayak_summits(first(1), first(2), first(3))
   end function sum_of_summits

end module asperity_faces_two_faces
