# Tests: one executable of all modules in test/, and the program's tests.
# They run in the project's folder, where test/data is.

find_package(GSL REQUIRED)
find_package(PFUNIT QUIET)

file(GLOB test_sources CONFIGURE_DEPENDS test/*.f90)
if(PFUNIT_FOUND)
   message(STATUS "Tests use pFUnit ${PFUNIT_VERSION}")
   list(FILTER test_sources EXCLUDE REGEX "/funit[^/]*\\.f90$")
else()
   message(STATUS "Tests use test/funit.f90, as pFUnit is not installed")
endif()

add_executable(asperity_tests ${test_sources})
asperity_compile_options(asperity_tests)
target_link_libraries(asperity_tests PRIVATE
   asperity_replay asperity_hysteresis asperity_deck asperity_surface GSL::gsl GSL::gslcblas)
if(PFUNIT_FOUND)
   target_link_libraries(asperity_tests PRIVATE PFUNIT::funit)
endif()
add_test(NAME asperity_tests COMMAND asperity_tests WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

# The same tests of VUINTER against the file for single precision, all from sources, as its modules
# are not those of the library
set(single_sources
   abaqus_stubs contact_cases extremes random_inputs threads vuinter_host test_vuinter
   test_vuinter_agreement single/main)
if(NOT PFUNIT_FOUND)
   list(APPEND single_sources funit funit_assert)
endif()
list(TRANSFORM single_sources PREPEND test/)
list(TRANSFORM single_sources APPEND .f90)
add_executable(asperity_single_tests
   ${PROJECT_BINARY_DIR}/asperity_vuinter_single.f90 ${single_sources}
   # of the face of the law, what that file has no need of
   src/base/version.f90 src/law/single_asperity.f90 src/paper/pairs.f90 src/asperity.f90
   interface/abaqus/uinter.f90 interface/abaqus/uinter_signature.f90
   interface/abaqus/vuinter_signature.f90 src/replay/abaqus_host.f90)
# one rule writes the file, not two at once
add_dependencies(asperity_single_tests uinter_file)
asperity_compile_options(asperity_single_tests)
if(PFUNIT_FOUND)
   target_link_libraries(asperity_single_tests PRIVATE PFUNIT::funit)
endif()
add_test(NAME single_tests COMMAND asperity_single_tests WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

# What the CalculiX interface computes itself, without CalculiX
set(calculix_sources test/calculix/main.f90 test/calculix/test_springs.f90
   test/calculix/test_keyword.f90 test/calculix/test_masters.f90 test/calculix/test_areas.f90
   test/calculix/test_outputs.f90 test/extremes.f90 test/random_inputs.f90 test/abaqus_stubs.f90)
foreach(name refusal faces kinematics interactions slots outputs host springs masters keyword areas)
   list(APPEND calculix_sources interface/calculix/${name}.f90)
endforeach()
if(NOT PFUNIT_FOUND)
   list(APPEND calculix_sources test/funit.f90 test/funit_assert.f90)
endif()
add_executable(asperity_calculix_tests ${calculix_sources})
asperity_compile_options(asperity_calculix_tests)
target_link_libraries(asperity_calculix_tests PRIVATE asperity)
if(PFUNIT_FOUND)
   target_link_libraries(asperity_calculix_tests PRIVATE PFUNIT::funit)
endif()
add_test(NAME calculix_tests COMMAND asperity_calculix_tests
   WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

# The runner of CalculiX decks, with a fake CalculiX
find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND)
   add_test(NAME calculix_run_tests
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/calculix/test_run.py)
   add_test(NAME calculix_source_tests
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/calculix/test_source.py)
endif()

if(ASPERITY_BUILD_PROGRAM)
   add_test(NAME program_tests
      COMMAND bash ${PROJECT_SOURCE_DIR}/test/program/run_tests.sh $<TARGET_FILE:asperity_program>
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endif()

if(ASPERITY_BUILD_C)
   include(cmake/AsperityCTests.cmake)
endif()

# A test that hangs is stopped; none takes nearly that, also with run-time checks on a busy machine
get_property(tests DIRECTORY PROPERTY TESTS)
set_tests_properties(${tests} PROPERTIES TIMEOUT 3600)
