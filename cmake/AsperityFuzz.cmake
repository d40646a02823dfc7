# Fuzzing of the readers of height maps: all from sources, checked by the compiler at run time.
# test/fuzz/run.sh builds it in a folder of its own and runs it.

file(GLOB_RECURSE fuzz_sources CONFIGURE_DEPENDS src/base/*.f90 src/height_map/*.f90)
file(GLOB fuzz_program_sources CONFIGURE_DEPENDS test/fuzz/*.f90)
add_executable(asperity_fuzz ${fuzz_sources} ${fuzz_program_sources}
   test/height_map/binary_cases.f90 test/height_map/x3p_cases.f90 test/height_map/zip_writer.f90)
asperity_compile_options(asperity_fuzz)
set(fuzz_checks -fsanitize=address,undefined -fno-sanitize-recover=all)
target_compile_options(asperity_fuzz PRIVATE ${fuzz_checks} -g -O1 -fno-omit-frame-pointer)
if(CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
   target_compile_options(asperity_fuzz PRIVATE
      -fcheck=all -ffpe-trap=invalid,zero,overflow)
endif()
target_link_options(asperity_fuzz PRIVATE ${fuzz_checks})
target_link_libraries(asperity_fuzz PRIVATE
   ${asperity_zip_library} ${asperity_xml2_library} ${asperity_z_library})
