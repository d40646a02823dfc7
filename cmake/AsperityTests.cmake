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
target_link_libraries(asperity_tests PRIVATE asperity_replay GSL::gsl GSL::gslcblas)
if(PFUNIT_FOUND)
   target_link_libraries(asperity_tests PRIVATE PFUNIT::funit)
endif()
add_test(NAME asperity_tests COMMAND asperity_tests WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

if(ASPERITY_BUILD_PROGRAM)
   add_test(NAME program_tests
      COMMAND bash ${PROJECT_SOURCE_DIR}/test/program/run_tests.sh $<TARGET_FILE:asperity_program>
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endif()
