!> Version of the library and the program.
module asperity_base_version
   implicit none
   private

   !> Semantic version, the same in fpm.toml, CMakeLists.txt and CITATION.cff
   character(len=*), parameter, public :: version = '0.2.0'
end module asperity_base_version
