!> Limits past which a result is still computed but no longer means what the law assumes.
!> Validity is part of every result: a sum of the flags below, `valid` (zero) when none is set.
module asperity_law_validity
   implicit none
   private
   public :: validity_text, validity_remark

   !> No limit is passed
   integer, parameter, public :: valid = 0
   !> Real area above nominal area: asperities would overlap
   integer, parameter, public :: area_above_nominal = 1
   !> Pressure above the hardness: no such contact exists
   integer, parameter, public :: pressure_above_hardness = 2
   !> Mean closure of the summits in contact above half their radius: past the sphere's equator
   integer, parameter, public :: closure_above_half_radius = 4
   !> Yield factor below 2/sqrt(w2/w1): the elasto-plastic stage is stiffer than Hertz (b3 > 1.5)
   integer, parameter, public :: stiffer_than_hertz = 8
   !> eta R sigma above 4: rougher than any surface measured so far
   integer, parameter, public :: roughness_number_high = 16
   !> eta R sigma below 0.0158, let pass by `accept_unphysical`: no isotropic Gaussian surface
   integer, parameter, public :: roughness_number_low = 32
   !> A property outside what solids and faces have, let pass by `accept_unphysical`
   integer, parameter, public :: implausible_property = 64
   !> Mean deformation of the summits in contact at the closest separation above 170 w1: past what
   !> unloading was computed for (Etsion, Kligerman, Kadin 2005); by a law with memory alone
   integer, parameter, public :: memory_beyond_data = 128

   integer, parameter :: name_length = 26, remark_length = 73
   integer, parameter :: n_flags = 8
   !> Sum of all flags
   integer, parameter, public :: all_flags = 2**n_flags - 1
   character(len=name_length), parameter :: names(n_flags) = [character(len=name_length) :: &
      'area_above_nominal', 'pressure_above_hardness', 'closure_above_half_radius', &
      'stiffer_than_hertz', 'roughness_number_high', 'roughness_number_low', &
      'implausible_property', 'memory_beyond_data']
   character(len=remark_length), parameter :: remarks(n_flags) = [character(len=remark_length) :: &
      'real area above nominal area: asperities overlap, pressure is too high', &
      'pressure above the hardness: outside the model', &
      'mean closure of touching summits above radius/2: spheres do not apply', &
      'yield_factor below 2/sqrt(plastic_ratio): yielding stiffer than Hertz', &
      'eta*radius*sigma above 4: rougher than any measured surface', &
      'eta*radius*sigma below 0.0158: no isotropic Gaussian surface has it', &
      'a property as no face or solid has, let pass: a slip of units?', &
      'closest mean deformation above 170 w1: beyond what unloading is known for']

contains

   !> Length of the entries of `list` whose flag is set, or of `none`.
   pure integer function joined_length(flags, list, separator, none)
      integer, intent(in) :: flags
      character(len=*), intent(in) :: list(:), separator, none
      integer :: i

      joined_length = -len(separator)
      do i = 1, size(list)
         if (btest(flags, i - 1)) &
            joined_length = joined_length + len(separator) + len_trim(list(i))
      end do
      if (joined_length < 0) joined_length = len(none)
   end function joined_length

   pure integer function names_length(flags)
      integer, intent(in) :: flags

      names_length = joined_length(flags, names, '+', 'valid')
   end function names_length

   pure integer function remarks_length(flags)
      integer, intent(in) :: flags

      remarks_length = joined_length(flags, remarks, '; ', '')
   end function remarks_length

   !> Names of the set flags joined by `+`, or `valid`.
   pure function validity_text(flags) result(text)
      !> Sum of flags
      integer, intent(in) :: flags
      character(len=names_length(flags)) :: text

      text = joined(flags, names, '+', 'valid', len(text))
   end function validity_text

   !> What the set flags mean, joined by `; `, or nothing.
   pure function validity_remark(flags) result(text)
      !> Sum of flags
      integer, intent(in) :: flags
      character(len=remarks_length(flags)) :: text

      text = joined(flags, remarks, '; ', '', len(text))
   end function validity_remark

   !> The entries of `list` whose flag is set, or `none`.
   pure function joined(flags, list, separator, none, length) result(text)
      integer, intent(in) :: flags, length
      character(len=*), intent(in) :: list(:), separator, none
      character(len=length) :: text
      integer :: i, next

      text = none
      next = 1
      do i = 1, size(list)
         if (.not. btest(flags, i - 1)) cycle
         if (next > 1) text(next - len(separator):next - 1) = separator
         text(next:) = list(i)
         next = next + len_trim(list(i)) + len(separator)
      end do
   end function joined

end module asperity_law_validity
