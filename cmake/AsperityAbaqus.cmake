# What an ABAQUS user needs, in build/abaqus: the files that ABAQUS compiles and what goes with them

set(abaqus_folder ${PROJECT_BINARY_DIR}/abaqus)
set(abaqus_files)
foreach(name IN ITEMS asperity_uinter asperity_vuinter asperity_vuinter_single)
   foreach(ending IN ITEMS f90 for f)
      list(APPEND abaqus_files ${abaqus_folder}/${name}.${ending})
   endforeach()
endforeach()
get_target_property(law_sources asperity_law SOURCES)
get_target_property(abaqus_sources asperity_abaqus SOURCES)
file(GLOB_RECURSE ready_files CONFIGURE_DEPENDS interface/abaqus/ready/*)
list(FILTER ready_files EXCLUDE REGEX "/asperity_v?uinter[^/]*$")
add_custom_command(
   OUTPUT ${abaqus_files}
   COMMAND ${CMAKE_COMMAND} -D output=${abaqus_folder} -P ${PROJECT_SOURCE_DIR}/cmake/abaqus.cmake
   DEPENDS ${law_sources} ${abaqus_sources} ${ready_files} CMakeLists.txt LICENSE docs/abaqus.md
      cmake/abaqus.cmake cmake/abaqus/comments.cmake cmake/abaqus/modules.cmake
   VERBATIM)
add_custom_target(abaqus_files ALL DEPENDS ${abaqus_files})
