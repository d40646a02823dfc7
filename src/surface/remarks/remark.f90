!> Remarks on a map, one after the other, and the words for quantities in them.
module asperity_surface_remarks_remark
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_surface_parameters_parameters, only: parameters
   implicit none
   private
   public :: add_remark, is_known, quantity

   !> One remark.
   type, public :: remark_type
      !> What it is about, for programs: `shape`, `slope`, `outlier`, `filled`, `no_peaks`,
      !> `few_peaks`, `routes`, `alpha`, `heights`, `anisotropic`, `roughness_number`,
      !> `few_waves`, `resolution`, `step`, `isotropy`, `single` or `stylus`
      character(len=16) :: code = ''
      !> Plain sentences
      character(len=:), allocatable :: text
   end type remark_type

contains

   !> Add a remark.
   pure subroutine add_remark(remarks, code, text)
      !> The list
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      !> What it is about, and the sentences
      character(len=*), intent(in) :: code, text
      type(remark_type), allocatable :: longer(:)
      integer :: i, n

      n = size(remarks)
      allocate (longer(n + 1))
      do i = 1, n
         longer(i)%code = remarks(i)%code
         call move_alloc(remarks(i)%text, longer(i)%text)
      end do
      longer(n + 1)%code = code
      longer(n + 1)%text = text
      call move_alloc(longer, remarks)
   end subroutine add_remark

   !> Whether there is such a value.
   pure elemental logical function is_known(value)
      !> Of the table
      real(wp), intent(in) :: value

      is_known = .not. is_none(abs(value))
   end function is_known

   !> `12.3 +- 0.4 mm`, without what is not known or has no unit.
   pure function quantity(p, value, half_width) result(text)
      !> Place in the table
      integer, intent(in) :: p
      !> Value and half width of its interval
      real(wp), intent(in) :: value, half_width
      character(len=64) :: text

      text = to_text(value, 4)
      if (is_known(half_width)) text = trim(text)//' +- '//to_text(half_width, 2)
      if (parameters(p)%unit /= '-') text = trim(text)//' '//parameters(p)%unit
   end function quantity

end module asperity_surface_remarks_remark
