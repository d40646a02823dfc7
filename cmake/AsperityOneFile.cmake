# The files that ABAQUS compiles, each with all it needs: abaqus job=... user=asperity_uinter.f90

set(one_files)
get_target_property(law_sources asperity_law SOURCES)
get_target_property(abaqus_sources asperity_abaqus SOURCES)
function(asperity_one_file name routine single)
   set(one_file ${PROJECT_BINARY_DIR}/${name}.f90)
   add_custom_command(
      OUTPUT ${one_file}
      COMMAND ${CMAKE_COMMAND}
         -D source=${PROJECT_SOURCE_DIR} -D output=${one_file} -D version=${PROJECT_VERSION}
         -D routine=${routine} -D single=${single}
         -P ${PROJECT_SOURCE_DIR}/cmake/one_file.cmake
      DEPENDS ${law_sources} ${abaqus_sources} cmake/one_file.cmake
      VERBATIM)
   set(one_files ${one_files} ${one_file} PARENT_SCOPE)
endfunction()
asperity_one_file(asperity_uinter uinter OFF)
asperity_one_file(asperity_vuinter vuinter OFF)
asperity_one_file(asperity_vuinter_single vuinter ON)
add_custom_target(uinter_file ALL DEPENDS ${one_files})
