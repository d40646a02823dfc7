# Benchmarks, at three levels of optimisation whatever the type of the build: programs of
# test/bench/builds, by which builds are compared, and one of all of test/bench at -O2.

find_package(GSL REQUIRED)
find_package(OpenMP COMPONENTS Fortran)

file(GLOB bench_sources CONFIGURE_DEPENDS test/bench/builds/bench_*.f90)
list(APPEND bench_sources test/support/random_inputs.f90
   test/support/contact_cases.f90 test/support/abaqus_stubs.f90
   test/abaqus/abaqus_utilities.f90)
file(GLOB bench_other_sources CONFIGURE_DEPENDS test/bench/*.f90 test/bench/contenders/*.f90)
string(TOUPPER "${CMAKE_BUILD_TYPE}" bench_build_type)
get_target_property(target_flags asperity_law COMPILE_OPTIONS)
separate_arguments(bench_flags NATIVE_COMMAND
   "${CMAKE_Fortran_FLAGS} ${CMAKE_Fortran_FLAGS_${bench_build_type}}")
if(target_flags)
   list(APPEND bench_flags ${target_flags})
endif()
# The last level of a command line counts: that of the build is none of these
list(FILTER bench_flags EXCLUDE REGEX "^-(O[0-9a-z]*|Wall|Wextra|Werror)$")
list(JOIN bench_flags " " bench_flags)

set(bench_folder ${PROJECT_BINARY_DIR}/bench)
file(MAKE_DIRECTORY ${bench_folder})

# A program of the benchmarks with the library of a level
function(asperity_bench_program program level)
   add_executable(${program} EXCLUDE_FROM_ALL ${ARGN})
   asperity_compile_options(${program})
   # The read-write loop takes twice as long where it straddles two lines of the cache by chance
   target_compile_options(${program} PRIVATE ${bench_options_${level}}
      $<$<Fortran_COMPILER_ID:GNU>:-falign-loops=64>)
   target_include_directories(${program} PRIVATE
      ${PROJECT_BINARY_DIR}/modules/asperity_bench_${level}_core)
   set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${bench_folder})
   target_link_libraries(${program} PRIVATE asperity_bench_${level}_core)
   if(OpenMP_Fortran_FOUND)
      target_link_libraries(${program} PRIVATE OpenMP::OpenMP_Fortran)
   endif()
endfunction()

set(bench_options_O2 -O2)
set(bench_options_O3 -O3)
set(bench_options_native -O3 -march=native)
foreach(level O2 O3 native)
   # The library without OpenMP, as everyone has it; the benchmarks with it
   add_library(asperity_bench_${level}_core STATIC EXCLUDE_FROM_ALL ${law_sources} ${abaqus_sources})
   asperity_compile_options(asperity_bench_${level}_core)
   target_compile_options(asperity_bench_${level}_core PRIVATE ${bench_options_${level}})
   asperity_bench_program(asperity_bench_builds_${level} ${level}
      ${bench_sources} test/bench/builds/main.f90)
endforeach()
asperity_bench_program(asperity_bench O2 ${bench_sources} ${bench_other_sources})
target_link_libraries(asperity_bench PRIVATE GSL::gsl GSL::gslcblas)

add_custom_target(bench_programs DEPENDS asperity_bench asperity_bench_builds_O2
   asperity_bench_builds_O3 asperity_bench_builds_native)
set(flags_option)
if(bench_flags)
   set(flags_option --flags "${bench_flags}")
endif()
add_custom_target(bench
   # Threads that wait must not spin: they would slow down who is timed next
   COMMAND ${CMAKE_COMMAND} -E env OMP_WAIT_POLICY=passive $<TARGET_FILE:asperity_bench>
      --level -O2 ${flags_option} --csv ${bench_folder}/results.csv
      --markdown ${bench_folder}/page.md
   DEPENDS asperity_bench
   COMMENT "Benchmarks; ASPERITY_BENCH=short in the environment makes them short"
   USES_TERMINAL VERBATIM)
