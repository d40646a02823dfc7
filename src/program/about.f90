!> What the program says of itself: version, and what to cite.
module asperity_program_about
   use asperity_base_version, only: version
   use asperity_program_system_strings, only: newline
   implicit none
   private
   public :: version_text, citation_text

contains

   !> Name and version, and what the program is linked with.
   pure function version_text() result(text)
      character(len=:), allocatable :: text

      text = 'asperity '//version//newline// &
         'linked with FFTW and GSL, under the GNU GPL, which binds whoever passes the program'// &
         newline//'on, and with libzip, libxml2 and zlib; UINTER and the C interface have none'// &
         newline
   end function version_text

   !> What to cite: the paper of the law, and the program.
   pure function citation_text() result(text)
      character(len=:), allocatable :: text

      text = 'The contact law:'//newline// &
         '  Qifang Xie, Baozhuang Zhang, Lipeng Zhang, Tiantian Guo, Yajie Wu. Normal contact'// &
         newline//'  performance of mortise and tenon joint: theoretical analysis and numerical'// &
         newline//'  simulation. Journal of Wood Science 67 (2021).'//newline// &
         '  https://doi.org/10.1186/s10086-021-01963-x' &
         //newline//newline// &
         'The software:'//newline// &
         '  asperity, version '//version//': elasto-plastic contact of rough timber faces.' &
         //newline//newline// &
         '@article{xie2021normal,'//newline// &
         '  author  = {Xie, Qifang and Zhang, Baozhuang and Zhang, Lipeng and Guo, Tiantian'// &
         ' and Wu, Yajie},'//newline// &
         '  title   = {Normal contact performance of mortise and tenon joint: theoretical'// &
         newline//'             analysis and numerical simulation},'//newline// &
         '  journal = {Journal of Wood Science},'//newline// &
         '  volume  = {67},'//newline// &
         '  year    = {2021},'//newline// &
         '  doi     = {10.1186/s10086-021-01963-x}'//newline// &
         '}'//newline// &
         '@software{asperity,'//newline// &
         '  title   = {asperity: elasto-plastic contact of rough timber faces},'//newline// &
         '  version = {'//version//'}'//newline// &
         '}'//newline
   end function citation_text

end module asperity_program_about
