# Tests of the C interface. C is enabled for them alone: the product needs no C compiler.

include(CheckLanguage)
check_language(C)
if(NOT CMAKE_C_COMPILER)
   message(STATUS "No tests of the C interface, as there is no C compiler")
   return()
endif()
enable_language(C)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

file(GLOB c_test_sources CONFIGURE_DEPENDS test/c/*.c)
add_executable(c_tests ${c_test_sources} test/c/fortran_twin.f90)
set_target_properties(c_tests PROPERTIES LINKER_LANGUAGE C C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF
   # relative: -Wl,-rpath, would split a folder's name at a comma
   BUILD_RPATH_USE_ORIGIN ON)
target_compile_definitions(c_tests PRIVATE ASPERITY_TEST_VERSION="${PROJECT_VERSION}")
target_compile_options(c_tests PRIVATE $<$<COMPILE_LANGUAGE:C>:-Wall -Wextra -Wpedantic
   $<$<BOOL:${ASPERITY_WARNINGS_AS_ERRORS}>:-Werror>>)
# the library in Fortran besides that in C, whose own procedures are not seen, for a comparison
target_link_libraries(c_tests PRIVATE asperity_c asperity_law Threads::Threads m)
# A strict build stops at invalid operations: the main program sets that, which here is in C
if(CMAKE_Fortran_FLAGS MATCHES "-ffpe-trap")
   set(trap --trap)
endif()
add_test(NAME c_tests COMMAND c_tests ${trap})
