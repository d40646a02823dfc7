!> The files that ABAQUS has user subroutines include.
module asperity_check_source_includes
   use asperity_check_source_statements, only: newline
   implicit none
   private
   public :: include_text

   !> Their names, which users write in lower case as well: of ABAQUS/Standard, of ABAQUS/Explicit
   character(len=*), parameter, public :: include_names(2) = [character(len=14) :: &
      'ABA_PARAM.INC', 'VABA_PARAM.INC']
   !> Kinds of reals: of ABAQUS/Standard, and of ABAQUS/Explicit by its precision
   character(len=*), parameter, public :: double_kind = 'real*8', single_kind = 'real*4'

contains

   !> What they have in effect, in either form of source.
   pure function include_text(name, real_kind) result(text)
      !> One of the names
      character(len=*), intent(in) :: name
      !> `double_kind` or `single_kind`
      character(len=*), intent(in) :: real_kind
      character(len=80) :: text

      text = '      implicit '//real_kind//'(a-h,o-z)'//newline
      if (name == include_names(1)) then
         text = trim(text)//'      parameter (nprecd=2)'//newline
      else
         text = trim(text)//'      parameter (j_sys_dimension=2)'//newline
      end if
   end function include_text

end module asperity_check_source_includes
