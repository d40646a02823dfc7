# Options of the compiler and the folders of its modules, which no other compiler can read.

string(REGEX MATCH "^[0-9]+" compiler_major "${CMAKE_Fortran_COMPILER_VERSION}")
# For instance GNU-12
set(compiler_name ${CMAKE_Fortran_COMPILER_ID}-${compiler_major})
set(asperity_module_folder ${CMAKE_INSTALL_INCLUDEDIR}/asperity/${compiler_name})

# Warnings and a module folder of its own for one target
function(asperity_compile_options target)
   set_target_properties(${target} PROPERTIES
      Fortran_MODULE_DIRECTORY ${PROJECT_BINARY_DIR}/modules/${target})
   if(CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
      # -frecursive puts all locals on the stack, where threads do not share them
      target_compile_options(${target} PRIVATE -std=f2018 -frecursive -Wall -Wextra)
   elseif(CMAKE_Fortran_COMPILER_ID MATCHES "^Intel(LLVM)?$")
      # The same for Intel's, whose own floating-point model is the fast one; not tried
      target_compile_options(${target} PRIVATE -fp-model=precise -auto)
   endif()
   if(ASPERITY_WARNINGS_AS_ERRORS AND CMAKE_Fortran_COMPILER_ID MATCHES "^(GNU|LLVMFlang)$")
      target_compile_options(${target} PRIVATE -Werror)
   endif()
endfunction()
