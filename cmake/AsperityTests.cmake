# Tests: a program and a ctest `<folder>_tests` for each folder of test/ that has a main.f90, and
# the program's tests. They run in the project's folder, where test/data is.

find_package(GSL REQUIRED)
find_package(PFUNIT QUIET)

# What the suites share
file(GLOB support_sources CONFIGURE_DEPENDS test/support/*.f90)
set(funit_target)
if(PFUNIT_FOUND)
   message(STATUS "Tests use pFUnit ${PFUNIT_VERSION}")
   list(FILTER support_sources EXCLUDE REGEX "/funit[^/]*\\.f90$")
   set(funit_target PFUNIT::funit)
else()
   message(STATUS "Tests use test/support/funit.f90, as pFUnit is not installed")
endif()
add_library(asperity_test_support STATIC ${support_sources})
asperity_compile_options(asperity_test_support)
target_include_directories(asperity_test_support PUBLIC
   ${PROJECT_BINARY_DIR}/modules/asperity_test_support)
target_link_libraries(asperity_test_support PUBLIC
   asperity_abaqus asperity_law GSL::gsl GSL::gslcblas ${funit_target})

# The test of a program, run in the project's folder
function(asperity_test suite)
   set(program asperity_${suite}_tests)
   asperity_compile_options(${program})
   add_test(NAME ${suite}_tests COMMAND ${program} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()

# The suites of one folder, with the libraries that they need
function(asperity_test_suite suite)
   file(GLOB sources CONFIGURE_DEPENDS test/${suite}/*.f90)
   add_executable(asperity_${suite}_tests ${sources})
   target_link_libraries(asperity_${suite}_tests PRIVATE asperity_test_support ${ARGN})
   asperity_test(${suite})
   # A file of tests that the main program does not know would be compiled and never run
   file(READ test/${suite}/main.f90 main)
   foreach(source IN LISTS sources)
      get_filename_component(name ${source} NAME_WE)
      file(STRINGS ${source} suites REGEX "^ *function suite_")
      if(suites AND NOT main MATCHES "use test_${suite}_${name},")
         message(FATAL_ERROR "test/${suite}/${name}.f90 is not run: name it in main.f90 beside it")
      endif()
   endforeach()
endfunction()

asperity_test_suite(base)
# eta R sigma of real surfaces bounds what the law takes for plausible
asperity_test_suite(law asperity_surface)
asperity_test_suite(contact)
asperity_test_suite(faces)
asperity_test_suite(abaqus asperity_joint)
asperity_test_suite(replay asperity_joint)
asperity_test_suite(hysteresis asperity_hysteresis)
asperity_test_suite(height_map asperity_surface)
asperity_test_suite(surface asperity_surface)
asperity_test_suite(deck asperity_deck)
asperity_test_suite(fit asperity_fit)
asperity_test_suite(frame asperity_frame)
asperity_test_suite(check asperity_check)
asperity_test_suite(solid asperity_solid)
# With PETSc, or left out
asperity_test_suite(petsc asperity_solid)
set_tests_properties(petsc_tests PROPERTIES SKIP_RETURN_CODE 77)
# On one rank, and on two and three where there is MPI
asperity_test_suite(ranks asperity_solid)
set_tests_properties(ranks_tests PROPERTIES SKIP_RETURN_CODE 77)
find_program(ASPERITY_MPIRUN mpirun)
mark_as_advanced(ASPERITY_MPIRUN)
if(ASPERITY_MPIRUN)
   foreach(n IN ITEMS 2 3)
      add_test(NAME ranks_${n}_tests
         COMMAND ${ASPERITY_MPIRUN} --oversubscribe -n ${n} $<TARGET_FILE:asperity_ranks_tests>
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
      set_tests_properties(ranks_${n}_tests PROPERTIES SKIP_RETURN_CODE 77 PROCESSORS 2 ENVIRONMENT
         "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
   endforeach()
endif()
if(ASPERITY_BUILD_PROGRAM)
   asperity_test_suite(program_input asperity_commands)
   asperity_test_suite(program_fit asperity_commands)
   asperity_test_suite(program_solid asperity_commands)
endif()

# The same tests of VUINTER against the file for single precision, all from sources, as its modules
# are not those of the library
set(single_sources support/abaqus_stubs support/contact_cases support/extremes support/random_inputs
   support/run_suites support/threads abaqus/abaqus_utilities abaqus/vuinter_host abaqus/vuinter
   abaqus/vuinter_agreement abaqus/vuinter_friction single/main)
if(NOT PFUNIT_FOUND)
   list(APPEND single_sources support/funit support/funit_assert)
endif()
list(TRANSFORM single_sources PREPEND test/)
list(TRANSFORM single_sources APPEND .f90)
add_executable(asperity_single_tests
   ${abaqus_folder}/asperity_vuinter_single.f90 ${single_sources}
   # of the face of the law, what that file has no need of
   src/base/version.f90 src/base/no_value.f90 src/contact/points.f90 src/wood/properties.f90
   src/wood/values.f90
   src/wood/check.f90 src/wood/ageing.f90 src/wood/sections.f90 src/faces/nayak.f90
   src/faces/face.f90 src/faces/aged_pair.f90
   src/faces/two_faces.f90 src/asperity.f90
   interface/abaqus/routines/uinter.f90 interface/abaqus/routines/uinter_point.f90
   interface/abaqus/routines/uinter_signature.f90 interface/abaqus/routines/vuinter_signature.f90
   src/replay/abaqus_record.f90 src/replay/abaqus_host.f90)
# one rule writes the file, not two at once
add_dependencies(asperity_single_tests abaqus_files)
target_link_libraries(asperity_single_tests PRIVATE ${funit_target})
asperity_test(single)

# What the CalculiX interface computes itself, without CalculiX
file(GLOB glue_sources CONFIGURE_DEPENDS interface/calculix/glue/*.f90)
add_library(asperity_calculix_glue STATIC ${glue_sources})
asperity_compile_options(asperity_calculix_glue)
target_include_directories(asperity_calculix_glue PUBLIC
   ${PROJECT_BINARY_DIR}/modules/asperity_calculix_glue)
target_link_libraries(asperity_calculix_glue PUBLIC asperity_abaqus)
asperity_test_suite(calculix asperity_calculix_glue)
target_sources(asperity_calculix_tests PRIVATE test/abaqus/abaqus_utilities.f90)

add_executable(asperity_calculix_check_source interface/calculix/check_source.f90)
asperity_compile_options(asperity_calculix_check_source)
target_link_libraries(asperity_calculix_check_source PRIVATE asperity_check)

# Layers of the sources, what stands ready for ABAQUS, and the runner of CalculiX decks with a fake
# CalculiX
find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND)
   add_test(NAME layers_tests COMMAND ${Python3_EXECUTABLE} test/layers.py
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
   add_test(NAME abaqus_ready_tests COMMAND bash test/abaqus/ready.sh
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
   add_test(NAME mutate_tests
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/mutate/test_fortran.py)
   add_test(NAME solid_study_tests
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/solid/test_extrapolate.py)
   add_test(NAME calculix_run_tests
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/calculix/tools/test_run.py)
   add_test(NAME calculix_source_tests
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/calculix/tools/test_source.py
         $<TARGET_FILE:asperity_calculix_check_source>)
endif()

if(ASPERITY_BUILD_PROGRAM)
   # A ctest each, to run side by side
   file(GLOB parts CONFIGURE_DEPENDS test/program/*/*.sh)
   foreach(part IN LISTS parts)
      get_filename_component(name ${part} NAME_WE)
      add_test(NAME program_${name}_tests COMMAND bash test/program/run_tests.sh
         $<TARGET_FILE:asperity_program> ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
   endforeach()
   # On several ranks, or left out; two of them want two cores
   file(GLOB parts CONFIGURE_DEPENDS test/mpi/*.sh)
   foreach(part IN LISTS parts)
      get_filename_component(name ${part} NAME_WE)
      if(NOT name MATCHES "^(run_tests|ranks)$")
         add_test(NAME mpi_${name}_tests COMMAND bash test/mpi/run_tests.sh
            $<TARGET_FILE:asperity_program> ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
         set_tests_properties(mpi_${name}_tests PROPERTIES SKIP_RETURN_CODE 77 PROCESSORS 2)
         # Minutes, and left out by `./run test` without names
         if(name MATCHES "^(histories|resume|interrupts)$")
            set_tests_properties(mpi_${name}_tests PROPERTIES LABELS long)
         endif()
      endif()
   endforeach()
   if(Python3_FOUND)
      add_test(NAME paper_tests COMMAND ${Python3_EXECUTABLE} test/docs/test_paper.py
         $<TARGET_FILE:asperity_program> WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
      add_test(NAME first_run_tests COMMAND ${Python3_EXECUTABLE} -B test/first_run/expected.py
         $<TARGET_FILE:asperity_program> WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
   endif()
endif()

if(ASPERITY_BUILD_C)
   include(cmake/AsperityCTests.cmake)
endif()

# A test that hangs is stopped; none takes nearly that, also with run-time checks on a busy machine
get_property(tests DIRECTORY PROPERTY TESTS)
set_tests_properties(${tests} PROPERTIES TIMEOUT 3600)
