!> What is known of summits beyond the six numbers of the normal law, as commands take it: when they
!> are fully plastic, and how their heights are distributed.
module asperity_program_commands_faces_heights
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: default_plastic_ratio, heights_gaussian, &
      heights_johnson
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: heights_type

   !> The settings.
   type :: heights_type
      !> w2/w1
      real(wp) :: plastic_ratio = default_plastic_ratio
      !> Whether heights are Johnson's, not Gaussian
      logical :: is_johnson = .false.
      !> Their skewness and kurtosis
      real(wp) :: skewness = 0.0_wp, kurtosis = 3.0_wp
      !> Kurtosis unless it is given, and the surface that it is of
      real(wp) :: usual_kurtosis = 3.0_wp
      character(len=:), allocatable :: surface
   contains
      procedure :: declare, distribution
   end type heights_type

contains

   !> Declare them.
   pure subroutine declare(self, keys)
      !> The settings
      class(heights_type), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys
      character(len=*), parameter :: of_johnson = 'needs height_distribution = johnson'

      call keys%real('plastic_ratio', self%plastic_ratio, '', &
         'deformation at full plasticity over that at first yield, w2/w1, 10 to 1000')
      call keys%choice('height_distribution', self%is_johnson, 'gaussian johnson', &
         'how summit heights are distributed: as in the paper, or by skewness and kurtosis')
      call keys%real('skewness', self%skewness, '', 'skewness of summit heights')
      call keys%needs(self%is_johnson, of_johnson)
      self%kurtosis = self%usual_kurtosis
      call keys%real('kurtosis', self%kurtosis, '', &
         'kurtosis of summit heights; that of the surface, or 3, unless given')
      call keys%said_by(self%surface)
      call keys%needs(self%is_johnson, of_johnson)
   end subroutine declare

   !> The number of the distribution.
   pure integer function distribution(self)
      !> The settings
      class(heights_type), intent(in) :: self

      distribution = merge(heights_johnson, heights_gaussian, self%is_johnson)
   end function distribution

end module asperity_program_commands_faces_heights
