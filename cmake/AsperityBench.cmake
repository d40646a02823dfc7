# Benchmarks: the program of test/bench with the library, built at three levels of optimisation
# whatever the type of the build, and the target `bench` that runs all three.

find_package(GSL REQUIRED)
find_package(OpenMP COMPONENTS Fortran)

file(GLOB bench_sources CONFIGURE_DEPENDS
   test/bench/builds/*.f90 test/bench/*.f90 test/bench/contenders/*.f90)
list(APPEND bench_sources test/support/random_inputs.f90
   test/support/contact_cases.f90 test/support/abaqus_stubs.f90
   test/abaqus/abaqus_utilities.f90)
string(TOUPPER "${CMAKE_BUILD_TYPE}" bench_build_type)
get_target_property(target_flags asperity_law COMPILE_OPTIONS)
separate_arguments(bench_flags NATIVE_COMMAND
   "${CMAKE_Fortran_FLAGS} ${CMAKE_Fortran_FLAGS_${bench_build_type}}")
list(APPEND bench_flags ${target_flags})
# The last level of a command line counts: that of the build is none of these
list(FILTER bench_flags EXCLUDE REGEX "^-(O[0-9a-z]*|Wall|Wextra|Werror)$")
list(JOIN bench_flags " " bench_flags)

set(bench_folder ${PROJECT_BINARY_DIR}/bench)
file(MAKE_DIRECTORY ${bench_folder})

# asperity_bench_<name>, and its command in bench_command_<name>
function(asperity_bench name)
   set(program asperity_bench_${name})
   # The library without OpenMP, as everyone has it; the benchmarks with it
   add_library(${program}_core STATIC EXCLUDE_FROM_ALL ${law_sources} ${abaqus_sources})
   add_executable(${program} EXCLUDE_FROM_ALL ${bench_sources})
   foreach(target ${program}_core ${program})
      asperity_compile_options(${target})
      target_compile_options(${target} PRIVATE ${ARGN})
   endforeach()
   target_include_directories(${program} PRIVATE ${PROJECT_BINARY_DIR}/modules/${program}_core)
   set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${bench_folder})
   target_link_libraries(${program} PRIVATE ${program}_core GSL::gsl GSL::gslcblas)
   if(OpenMP_Fortran_FOUND)
      target_link_libraries(${program} PRIVATE OpenMP::OpenMP_Fortran)
   endif()
   list(JOIN ARGN " " level)
   set(flags_option)
   if(bench_flags)
      set(flags_option --flags "${bench_flags}")
   endif()
   set(bench_command_${name}
      $<TARGET_FILE:${program}> --level "${level}" ${flags_option}
      --csv ${bench_folder}/${name}.csv PARENT_SCOPE)
endfunction()

asperity_bench(O2 -O2)
asperity_bench(O3 -O3)
asperity_bench(native -O3 -march=native)

add_custom_target(bench_programs
   DEPENDS asperity_bench_O2 asperity_bench_O3 asperity_bench_native)
# Threads that wait must not spin: they would slow down who is timed next
set(bench_environment ${CMAKE_COMMAND} -E env OMP_WAIT_POLICY=passive)
add_custom_target(bench
   COMMAND ${bench_environment} ${bench_command_O3} --level-only
   COMMAND ${bench_environment} ${bench_command_native} --level-only
   COMMAND ${bench_environment} ${bench_command_O2} --markdown ${bench_folder}/page.md
      --other ${bench_folder}/O3.csv --other ${bench_folder}/native.csv
   COMMAND ${CMAKE_COMMAND} -E copy ${bench_folder}/O2.csv ${bench_folder}/results.csv
   DEPENDS asperity_bench_O2 asperity_bench_O3 asperity_bench_native
   COMMENT "Benchmarks; ASPERITY_BENCH=short in the environment makes them short"
   USES_TERMINAL VERBATIM)
